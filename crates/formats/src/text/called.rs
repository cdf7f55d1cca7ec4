//! How an object is called where a point of it is told of: by its shape, its name, and the facet or face that is met.

use lancer_scene::{ConeFace, Object, Shape};
use lancer_words::{Lang, explain as words};

/// An object by its shape and name, with the facet or face of that number where there are several.
pub fn called(object: &Object, facet: u32, lang: Lang) -> String {
    let name = &object.name;
    match &object.shape {
        Shape::Sphere { .. } => words::object(lang, words::sphere(lang), name),
        Shape::Plane { .. } => words::object(lang, words::plane(lang), name),
        Shape::Facet { .. } => words::object(lang, words::facet(lang), name),
        Shape::Cube { .. } => words::object_facet(lang, words::cube(lang), name, facet),
        Shape::Parallelepiped { .. } => words::object_facet(lang, words::parallelepiped(lang), name, facet),
        Shape::Cone { .. } => {
            let face = match ConeFace::of(facet) {
                ConeFace::Side => words::side(lang),
                ConeFace::Base => words::base_cap(lang),
                ConeFace::Top => words::top_cap(lang),
            };
            words::object_face(lang, words::cone(lang), name, face)
        }
        Shape::Mesh(_) => words::object_facet(lang, words::mesh(lang), name, facet),
    }
}
