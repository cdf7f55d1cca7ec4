//! Words of the editor's view panes.

phrases! {
    /// A pane has no view.
    no_view() { "No view is open.", "Aucune vue n'est ouverte." }
    /// The steps of the subject (§5.2).
    steps() { "Steps of the algorithm", "Étapes de l'algorithme" }
    /// Step 1.
    hidden_surfaces() { "hidden surfaces", "parties cachées" }
    /// Step 2.
    shadows() { "+ shadows", "+ ombres portées" }
    /// Step 3.
    reflection() { "+ reflection", "+ réflexion" }
    /// Step 4.
    transparency() { "+ transparency", "+ transparence" }
}
