//! Words of the editor's view panes.

use crate::Lang;

phrases! {
    /// No pane is open.
    no_view() { "No view is open.", "Aucune vue n'est ouverte." }
    /// How to open one.
    no_view_help() {
        "Open a view from the scene panel or the View menu, or add one.",
        "Ouvrez une vue depuis le panneau de la scène ou le menu Affichage, ou ajoutez-en une.",
    }
    /// The picture of a view, for screen readers.
    picture_of(view) { "Picture of {view}", "Image de {view}" }

    /// The steps of the subject (§5.2).
    steps_of(view) { "Steps of the algorithm · {view}", "Étapes de l'algorithme · {view}" }
    /// Step 1.
    hidden_surfaces() { "Hidden surfaces", "Élimination des parties cachées" }
    /// Step 2.
    shadows() { "+ Shadows", "+ Ombres portées" }
    /// Step 3.
    reflection() { "+ Reflection", "+ Réflexion" }
    /// Step 4.
    transparency() { "+ Transparency", "+ Transparence" }
    /// Hidden surfaces cannot be left out.
    always() { "Always computed", "Toujours calculée" }

    /// Size, depth, samples.
    picture_settings_of(view) { "Size, depth, samples · {view}", "Taille, profondeur, échantillons · {view}" }
    /// The size of the picture.
    size() { "Size", "Taille" }
    /// Made to fit the pane.
    fit() { "Fit the pane", "Adapter au volet" }
    /// The depth limit.
    depth() { "Depth limit", "Profondeur limite" }
    /// As in the world.
    depth_of_world(depth) { "As the world ({depth})", "Celle du monde ({depth})" }
    /// The samples of a pixel.
    samples() { "Samples per pixel", "Échantillons par pixel" }
    /// Fewer.
    fewer(what) { "Less: {what}", "Moins : {what}" }
    /// More.
    more(what) { "More: {what}", "Plus : {what}" }

    /// The menu of pictures.
    save_of(view) { "Save the picture · {view}", "Enregistrer l'image · {view}" }
    /// Saves in a format.
    save_as(format) { "Save as {format}…", "Enregistrer en {format}…" }
    /// The format of the subject.
    ppm() { "PPM (P3)", "PPM (P3)" }
    /// The menu of everything else.
    more_of(view) { "More · {view}", "Autres commandes · {view}" }

    /// A finished picture.
    done() { "done", "terminé" }
    /// A picture that rests.
    paused() { "paused", "en pause" }
    /// The old picture is still seen.
    stale() { "old picture", "ancienne image" }
    /// What is shown while nothing is.
    waiting() { "waiting", "en attente" }
    /// How many rays.
    rays(count) { "{count} rays", "{count} rayons" }
    /// A pixel that has no colour.
    over_budget(x, y, limit) {
        "pixel ({x}, {y}) needs more than {limit} rays",
        "le pixel ({x}, {y}) demande plus de {limit} rayons",
    }
    /// A pixel whose colour is no number.
    not_a_number(x, y) { "the colour of pixel ({x}, {y}) is not a number", "la couleur du pixel ({x}, {y}) n'est pas un nombre" }
    /// The view breaks a rule.
    cannot_render() { "This view cannot be rendered", "Cette vue ne peut pas être calculée" }
    /// Nothing is under the pointer.
    infinity() { "infinity", "infini" }
    /// A pixel.
    pixel(x, y) { "pixel ({x}, {y})", "pixel ({x}, {y})" }
    /// A distance.
    distance(distance) { "distance {distance}", "distance {distance}" }
    /// A rectangle is wanted.
    drag_region() { "Drag a rectangle: it is rendered first", "Tracez un rectangle : il sera calculé d'abord" }
    /// An object moves along an axis.
    along(axis) { "along {axis}", "selon {axis}" }
    /// An object moves in the view's plane.
    in_plane() { "in the view's plane · X, Y, Z: one axis", "dans le plan de la vue · X, Y, Z : un axe" }
}

/// A number with the decimal sign of the language.
fn decimal(lang: Lang, number: String) -> String {
    match lang {
        Lang::English => number,
        Lang::French => number.replace('.', ","),
    }
}

/// A large count in three digits: `12.4 M`.
pub fn compact(lang: Lang, count: u64) -> String {
    let scaled = |unit: f64, name: &str| {
        let value = count as f64 / unit;
        let digits = if value < 9.995 { 2 } else { usize::from(value < 99.95) };
        format!("{} {name}", decimal(lang, format!("{value:.digits$}")))
    };
    let billion = match lang {
        Lang::English => "G",
        Lang::French => "Md",
    };
    match count {
        0..1_000 => count.to_string(),
        1_000..999_500 => scaled(1e3, "k"),
        999_500..999_500_000 => scaled(1e6, "M"),
        _ => scaled(1e9, billion),
    }
}

/// A time: `41 ms`, `3.2 s`, `2 min 05 s`.
pub fn duration(lang: Lang, time: std::time::Duration) -> String {
    let seconds = time.as_secs_f64();
    if seconds < 0.9995 {
        format!("{:.0} ms", seconds * 1e3)
    } else if seconds < 59.95 {
        format!("{} s", decimal(lang, format!("{seconds:.1}")))
    } else {
        let whole = seconds.round() as u64;
        format!("{} min {:02} s", whole / 60, whole % 60)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::time::Duration;

    #[test]
    fn counts_have_three_digits() {
        let texts = [7, 999, 1_000, 12_400, 999_499, 999_500, 12_400_000, 2_500_000_000];
        let english: Vec<_> = texts.iter().map(|count| compact(Lang::English, *count)).collect();
        assert_eq!(english, ["7", "999", "1.00 k", "12.4 k", "999 k", "1.00 M", "12.4 M", "2.50 G"]);
        assert_eq!(compact(Lang::French, 12_400_000), "12,4 M");
        assert_eq!(compact(Lang::French, 2_500_000_000), "2,50 Md");
    }

    #[test]
    fn times_are_short() {
        let text = |millis| duration(Lang::English, Duration::from_millis(millis));
        assert_eq!([41, 999, 1_000, 3_240, 125_000].map(text), ["41 ms", "999 ms", "1.0 s", "3.2 s", "2 min 05 s"]);
        assert_eq!(duration(Lang::French, Duration::from_millis(3_240)), "3,2 s");
    }
}
