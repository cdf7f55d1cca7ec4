//! The explanation of a pixel, in the terms of the course's subject.

use crate::Lang;
use crate::digits::{channel, degrees, length, vector};

phrases! {
    // ---- the head -------------------------------------------------------------------------------------------------

    /// What is explained.
    title(x, y, view, width, height) {
        "pixel {x}, {y} of view `{view}`, {width}×{height} pixels",
        "pixel {x}, {y} de la vue « {view} », {width}×{height} pixels",
    }
    /// The scene's title.
    scene_title(name) { "scene: {name}", "scène : {name}" }
    /// How terms are put together and how deep rays go.
    rules(compose, depth) {
        "composition: {compose}; depth limit: {depth}",
        "composition : {compose} ; profondeur limite : {depth}",
    }
    /// SPEC §1: screen.
    compose_screen() {
        "screen, a ⊕ b = 1 - (1-a)(1-b)",
        "screen, a ⊕ b = 1 - (1-a)(1-b)",
    }
    /// SPEC §1: screen-each.
    compose_screen_each() {
        "screen-each, a ⊕ b = 1 - (1-a)(1-b), diffuse and highlight parts apart",
        "screen-each, a ⊕ b = 1 - (1-a)(1-b), parties diffuse et spéculaire séparées",
    }
    /// SPEC §1: add.
    compose_add() { "add, a + b, clamped to 0..1 at each ray", "add, a + b, borné à 0..1 à chaque rayon" }
    /// Steps of the algorithm that are not carried out.
    left_out(steps) { "left out: {steps}", "étapes omises : {steps}" }
    /// A step.
    step_shadows() { "shadows", "ombres" }
    /// A step.
    step_reflection() { "reflection", "réflexion" }
    /// A step.
    step_transparency() { "transparency", "transparence" }
    /// Which of several samples this is.
    sample(number, count, x, y) {
        "sample {number} of {count}, through the screen at {x}, {y} pixels from the top left",
        "échantillon {number} sur {count}, à travers l'écran à {x}, {y} pixels du coin en haut à gauche",
    }

    // ---- a ray ----------------------------------------------------------------------------------------------------

    /// The ray from the eye.
    primary() { "primary ray", "rayon primaire" }
    /// A mirrored ray, with its name.
    reflected(name) { "{name}, reflected ray", "{name}, rayon réfléchi" }
    /// A refracted ray, with its name.
    refracted(name) { "{name}, refracted ray", "{name}, rayon réfracté" }
    /// The level of a ray.
    level(level) { "level {level}", "niveau {level}" }
    /// The channels that a ray carries, where it is not all of them.
    carries(channels) { "{channels} only", "{channels} seulement" }
    /// A channel.
    red() { "red", "rouge" }
    /// A channel.
    green() { "green", "vert" }
    /// A channel.
    blue() { "blue", "bleu" }
    /// Start and direction.
    from_along(start, direction) { "from S = {start} along I = {direction}", "part de S = {start} dans la direction I = {direction}" }
    /// The medium around the objects.
    surroundings() { "the surrounding medium", "le milieu environnant" }
    /// The medium inside an object.
    inside(object) { "`{object}`", "« {object} »" }
    /// The medium that a ray travels in.
    travels_in(medium, index) { "in {medium}, index {index}", "dans {medium}, indice {index}" }
    /// A ray that meets nothing.
    meets_nothing() {
        "meets nothing: the colour of infinity",
        "ne rencontre rien : la couleur de l'infini",
    }
    /// What a ray meets.
    meets(object, distance) { "meets {object} at distance {distance}", "rencontre {object} à la distance {distance}" }
    /// An object that is no collection of facets.
    object(element, name) { "{element} `{name}`", "{element} « {name} »" }
    /// An object and one of its facets.
    object_facet(element, name, facet) {
        "{element} `{name}` (facet {facet})",
        "{element} « {name} » (facette {facet})",
    }
    /// The shapes, by their element in a scene document.
    sphere() { "sphere", "la sphère" }
    /// An infinite plane.
    plane() { "plane", "le plan" }
    /// A cone and which part of it: its side or one of its caps.
    object_face(element, name, face) { "{element} `{name}` ({face})", "{element} « {name} » ({face})" }
    /// The curved side of a cone.
    side() { "side", "flanc" }
    /// The disc that closes a cone at its base.
    base_cap() { "base", "base" }
    /// The disc that closes a cone at its top.
    top_cap() { "top", "sommet" }
    /// A facet alone.
    facet() { "facet", "la facette" }
    /// A cube.
    cube() { "cube", "le cube" }
    /// A cone.
    cone() { "cone", "le cône" }
    /// A box.
    parallelepiped() { "box", "la boîte" }
    /// A mesh.
    mesh() { "mesh", "le maillage" }
    /// From which side.
    from_outside() { "from outside", "de l'extérieur" }
    /// From which side.
    from_inside() { "from inside", "de l'intérieur" }
    /// A sheet has no inside.
    a_sheet() { "a sheet without thickness", "une surface sans épaisseur" }
    /// The material's name.
    material(name) { "material `{name}`", "matière « {name} »" }
    /// The angle between the ray and the normal.
    incidence(degrees) { "angle of incidence i = {degrees}°", "angle d'incidence i = {degrees}°" }
    /// The smooth normal, where it is another than the facet's.
    smooth_normal(normal) { "smooth normal {normal}", "normale lissée {normal}" }

    // ---- the terms ------------------------------------------------------------------------------------------------

    /// Ka·Ia
    ambient() { "ambient", "ambiante" }
    /// Kr·Ir
    mirror() { "reflected", "réfléchie" }
    /// Kt·It
    glass() { "refracted", "réfractée" }
    /// A lamp.
    lamp(name, distance) { "lamp `{name}`, {distance} away", "source « {name} », à la distance {distance}" }
    /// The coefficient is 0.
    no_mirror() { "Kr = 0, no mirror", "Kr = 0, pas de miroir" }
    /// The coefficient is 0.
    no_glass() { "Kt = 0, opaque", "Kt = 0, opaque" }
    /// The level is the depth limit.
    depth_reached(level) {
        "0: level {level} is the depth limit, no further ray",
        "0 : le niveau {level} est la profondeur limite, plus de rayon",
    }
    /// The step is left out.
    step_left_out() { "0: this step is left out", "0 : cette étape est omise" }
    /// What a ray of that name sees.
    seen_along(symbol, name) { "{symbol} seen along {name}", "{symbol} vue le long de {name}" }
    /// Refraction with its angles.
    refraction(n, n_prime, i, r) {
        "n = {n} → n' = {n_prime}: i = {i}°, r = {r}°",
        "n = {n} → n' = {n_prime} : i = {i}°, r = {r}°",
    }
    /// A sheet does not bend the ray.
    straight_on() { "a sheet: the ray goes straight on", "sans épaisseur : le rayon va tout droit" }
    /// Total internal reflection.
    total_reflection(n, n_prime, i, critical) {
        "n = {n} → n' = {n_prime}: i = {i}° is beyond the critical angle {critical}°, total reflection",
        "n = {n} → n' = {n_prime} : i = {i}° dépasse l'angle limite {critical}°, réflexion totale",
    }
    /// A lamp that lights the point.
    lit(cos_l, l, law, cos_s, s) {
        "lights the point: cos l = N·L = {cos_l} (l = {l}°), cos s = {law} = {cos_s} (s = {s}°)",
        "éclaire le point : cos l = N·L = {cos_l} (l = {l}°), cos s = {law} = {cos_s} (s = {s}°)",
    }
    /// A lamp behind an object.
    blocked(by) {
        "in shadow: `{by}` stands between",
        "dans l'ombre : « {by} » est entre les deux",
    }
    /// A lamp behind the surface.
    behind(cos_l) {
        "behind the surface: N·L = {cos_l} is not more than 0",
        "derrière la surface : N·L = {cos_l} n'est pas supérieur à 0",
    }
    /// A lamp at the very point.
    at_point() {
        "stands at the very point: gives nothing",
        "se trouve au point même : ne donne rien",
    }
    /// The parts of a lamp's light.
    diffuse() { "diffuse", "diffuse" }
    /// The parts of a lamp's light.
    highlight() { "highlight", "spéculaire" }
    /// A lamp's whole term, in the running sum.
    lamp_term() { "lamp", "source" }
    /// A term is more than 1 and is cut before it is composed.
    clamped_term() { "clamped to 1", "borné à 1" }
    /// The sum, cut to 0..1.
    clamped_sum() { "colour: E clamped to 0..1", "couleur : E borné à 0..1" }
    /// The colour that a ray hands back.
    seen_color(name) { "colour seen along {name}", "couleur vue le long de {name}" }
    /// The colour of infinity.
    background() { "colour of infinity", "couleur de l'infini" }
    /// How many rays are not shown.
    rays_below(more_rays) { "… {more_rays} below (--levels)", "… {more_rays} plus bas (--levels)" }

    // ---- the end --------------------------------------------------------------------------------------------------

    /// The colour of one sample.
    sample_color(number) { "sample {number}", "échantillon {number}" }
    /// The mean of the samples.
    mean() { "mean of the samples", "moyenne des échantillons" }
    /// The colour of the pixel.
    pixel_color() { "colour of the pixel, c", "couleur du pixel, c" }
    /// The bytes.
    bytes() { "byte = floor(255·c + 0.5)", "octet = floor(255·c + 0.5)" }
    /// What the engine computes for the same pixel.
    engine_color() { "c of the engine", "c du moteur" }
    /// What stands in a picture.
    engine_bytes() { "byte of the engine", "octet du moteur" }
    /// The engine's bytes differ as roundings may.
    engine_rounds() {
        "The engine's powers are rounded otherwise than the reference's, which are explained here, and here that moves a byte by 1. Pictures have the engine's byte; with --engine reference they have the other.",
        "Les puissances du moteur ne sont pas arrondies comme celles de la référence, qui sont expliquées ici, et ici cela déplace un octet de 1. Les images ont l'octet du moteur ; avec --engine reference, elles ont l'autre.",
    }
    /// The engine's bytes differ as they must not.
    engine_differs(most) {
        "The engine's bytes differ by {most} from those explained here. This is a fault of lancer; please report it with the scene and the view. Pictures have the engine's bytes; with --engine reference they have the others.",
        "Les octets du moteur diffèrent de {most} de ceux qui sont expliqués ici. C'est un défaut de lancer ; merci de le signaler avec la scène et la vue. Les images ont les octets du moteur ; avec --engine reference, elles ont les autres.",
    }
}

/// From which side a surface is met.
pub fn side_met(lang: Lang, sheet: bool, entering: bool) -> String {
    match (sheet, entering) {
        (true, _) => a_sheet(lang),
        (false, true) => from_outside(lang),
        (false, false) => from_inside(lang),
    }
}

/// Where a surface is met, and at which angle: the point, the normal, the cosine of the angle of incidence, and the
/// smooth normal where it is another one.
pub fn place(lang: Lang, point: [f64; 3], normal: [f64; 3], cos_i: f64, smooth: Option<[f64; 3]>) -> String {
    let mut told = format!("P = {}, N = {}, {}", vector(point), vector(normal), incidence(lang, degrees(cos_i)));
    if let Some(smooth) = smooth {
        told += ", ";
        told += &smooth_normal(lang, vector(smooth));
    }
    told
}

/// Refraction from the index `n` to `n'`, with the cosines of its two angles.
pub fn bent(lang: Lang, [n, n_prime]: [f64; 2], cos_i: f64, cos_r: f64) -> String {
    refraction(lang, length(n), length(n_prime), degrees(cos_i), degrees(cos_r))
}

/// Total reflection at the surface between the indices `n` and `n'`, with the cosines of incidence and critical angle.
pub fn not_bent(lang: Lang, [n, n_prime]: [f64; 2], cos_i: f64, cos_critical: f64) -> String {
    total_reflection(lang, length(n), length(n_prime), degrees(cos_i), degrees(cos_critical))
}

/// A lamp that lights the point: `cos l`, what `cos s` is, and `cos s`.
pub fn lights(lang: Lang, cos_l: f64, law: &str, cos_s: f64) -> String {
    lit(lang, channel(cos_l), degrees(cos_l), law, channel(cos_s), degrees(cos_s))
}

/// The names of the channels in their order.
pub fn channels(lang: Lang) -> [String; 3] {
    [red(lang), green(lang), blue(lang)]
}
