//! Words of the editor's explanation of a pixel; the terms themselves stand in `explain`.

phrases! {
    /// What to do.
    hint() {
        "Click a pixel in a view, or give its place: every ray and every term of its colour stand here, and follow every edit.",
        "Cliquez sur un pixel d'une vue, ou donnez sa position : chaque rayon et chaque terme de sa couleur s'affichent ici et suivent chaque modification.",
    }
    /// Where the pixel is.
    pixel() { "Pixel", "Pixel" }
    /// The name of a coordinate.
    coordinate(letter) { "pixel {letter}", "pixel {letter}" }
    /// Which picture it is in.
    of(view, width, height) { "of {view}, {width} × {height}", "de {view}, {width} × {height}" }
    /// Which of several samples of the pixel is shown.
    sample(number, count) { "sample {number} of {count}", "échantillon {number} sur {count}" }
    /// Opens everything.
    unfold() { "Unfold all", "Tout déplier" }
    /// Closes everything but the first ray.
    fold() { "Fold all", "Tout replier" }
    /// Copies the text.
    copy() { "Copy", "Copier" }
    /// It is being computed.
    working() { "Following the rays…", "Suivi des rayons…" }
    /// There are too many rays.
    too_many(limit) {
        "This pixel costs more than {limit} rays, too many to be read: lower the depth limit of the view.",
        "Ce pixel coûte plus de {limit} rayons, trop pour être lus : baissez la profondeur limite de la vue.",
    }
    /// There is no view.
    no_view() { "Open a view first.", "Ouvrez d'abord une vue." }
}
