//! The rules of `lancer-scene`, told in words.

use super::{Excerpt, shortest};
use lancer_scene::{Invalid, limits};
use lancer_words::xml::{Report, rule as words};
use lancer_words::{Lang, number};

/// The code and the words of a broken rule.
pub(super) fn told(rule: &Invalid, lang: Lang) -> (&'static str, Report) {
    match rule {
        Invalid::NotFinite { field } => ("rule::not-finite", words::not_finite(lang, field)),
        Invalid::OutOfRange { field, value, min, .. } if *min == limits::LEAST && value < min => {
            let words = if *value > 0.0 { words::too_near_zero } else { words::not_positive };
            ("rule::not-positive", words(lang, field, shortest(*value), shortest(*min)))
        }
        Invalid::OutOfRange { field, value, min, max } => {
            let [value_told, min_told, max_told] = [value, min, max].map(|number| shortest(*number));
            let report = if value < min {
                words::too_small(lang, field, value_told, min_told, max_told)
            } else {
                words::too_great(lang, field, value_told, min_told, max_told)
            };
            ("rule::out-of-range", report)
        }
        Invalid::Collinear => ("rule::collinear", words::collinear(lang)),
        Invalid::Coplanar => ("rule::coplanar", words::coplanar(lang)),
        Invalid::ConeFlat => ("rule::cone-flat", words::cone_flat(lang)),
        Invalid::ConeThin => ("rule::cone-thin", words::cone_thin(lang)),
        Invalid::ScaleZero => ("rule::scale-zero", words::scale_zero(lang)),
        Invalid::FacetVertex { facet, vertex, vertices } => {
            let count = number::vertices(lang, *vertices);
            let count = match vertices.checked_sub(1) {
                Some(last) => words::vertices_to(lang, count, last),
                None => count,
            };
            ("rule::facet-vertex", words::facet_vertex(lang, facet, vertex, count))
        }
        Invalid::NormalCount { normals, vertices } => {
            let (normals, vertices) = (number::normals(lang, *normals), number::vertices(lang, *vertices));
            ("rule::normal-count", words::normal_count(lang, normals, vertices))
        }
        Invalid::PartRange { part, facets } => {
            let facets = words::facets_of_mesh(lang, number::facets(lang, *facets));
            ("rule::part-range", words::part_range(lang, part, facets))
        }
        Invalid::BadName => ("rule::bad-name", words::bad_name(lang)),
        Invalid::NameTaken { name, .. } => ("rule::name-taken", words::name_taken(lang, Excerpt::new(name))),
        Invalid::UnknownMaterial { name } => {
            ("rule::unknown-material", words::unknown_material(lang, Excerpt::new(name)))
        }
        Invalid::ScreenCollinear => ("rule::screen-collinear", words::screen_collinear(lang)),
        Invalid::NotParallelogram => ("rule::not-parallelogram", words::not_parallelogram(lang)),
        Invalid::EyeInScreen => ("rule::eye-in-screen", words::eye_in_screen(lang)),
        Invalid::LookAtIsEye => ("rule::look-at-is-eye", words::look_at_is_eye(lang)),
        Invalid::UpAlongSight => ("rule::up-along-sight", words::up_along_sight(lang)),
    }
}
