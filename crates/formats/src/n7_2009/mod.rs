//! The documents of 2009: the format that an implementation of the course read and wrote (SPEC §4).
//!
//! A document whose root is `Scene` or `Rendu` is read wherever a native one is; [`crate::xml::DocumentKind`] tells them
//! apart. The order of elements is free. What the format does not know is passed over with a warning, so that documents
//! of other hands can be read; what it needs is an error where it is missing. Writing gives a list of what is lost.
//!
//! ```text
//! Scene          = ObjetGraphique*  Source*  Couleur        the last Couleur: ambient light and background
//! ObjetGraphique = Matiere, ( Sphere | Plan | Cube | ObjetFacette )
//! Matiere @n     = Ambiante, Diffuse, Speculaire @n, Reflection, Refraction     each holds one Couleur
//! Sphere @rayon  = Point         Plan = Point ×3        Cube = Point ×4 (corner, ends of its three edges)
//! ObjetFacette   = Facette*      Facette = Point ×3
//! Source         = Point, Couleur           Point @x @y @z          Couleur @r @v @b (0..255)
//! Rendu          = Vue*          Vue @largeur @hauteur = PointVue(Point), Point ×4
//! ```

mod loss;
mod problem;
mod read_scene;
mod read_views;
mod reader;
mod write_scene;
mod write_views;
mod writer;

use lancer_scene::{DVec3, Invalid, Shape};

pub use loss::{Feature, Loss};
pub use problem::{N7Problem, Points};
pub use read_scene::read_scene;
pub use read_views::read_views;
pub use write_scene::write_scene;
pub use write_views::write_views;

/// The depth limit that every document of 2009 means.
const DEPTH: u32 = 6;
/// Refraction indices and shininess are counted in 64ths.
const UNIT: f64 = 64.0;
/// Colours are counted in 255ths.
const FULL: f64 = 255.0;

/// The one facet that some facets are: an `ObjetFacette` of one is a facet, and any other number is a mesh. One without
/// area is legal in a mesh alone.
fn lone_facet(facets: &[[DVec3; 3]]) -> Option<Shape> {
    match *facets {
        [[p0, p1, p2]] => Some(Shape::Facet { p0, p1, p2 }).filter(|facet| facet.check() != Err(Invalid::Collinear)),
        _ => None,
    }
}
