//! What `lancer generate` says.

phrases! {
    /// `lancer generate`.
    about_generate() {
        "Make a scene by calculation, and a view of it beside it",
        "Fabrique une scène par le calcul, avec une vue à côté",
    }
    /// Its form.
    usage_generate() { "lancer generate [OPTIONS] NAME [OUT]", "lancer generate [OPTIONS] NOM [SORTIE]" }
    /// More about it.
    after_generate(list) {
        "Names, their sizes, and the size where none is given:
{list}
The view goes beside the scene: lattice.xml or lattice.lancer has lattice.view.xml.
A .pov file holds its camera itself; .obj, .gltf and .glb hold objects alone.",
        "Les noms, leurs tailles, et la taille si aucune n'est donnée :
{list}
La vue va à côté de la scène : lattice.xml ou lattice.lancer a lattice.view.xml.
Un fichier .pov contient lui-même sa caméra ; .obj, .gltf et .glb ne contiennent que des objets.",
    }
    /// NAME
    name_help() { "Which scene, see below", "Quelle scène, voir plus bas" }
    /// OUT
    output_help() {
        "The file to write; its extension picks the format (xml, lancer, pov, obj, gltf, glb), `-` is standard output \
and gets the scene alone, NAME.xml where none is given",
        "Le fichier à écrire ; l'extension choisit le format (xml, lancer, pov, obj, gltf, glb), `-` désigne la sortie \
standard et reçoit la scène seule, NOM.xml si rien n'est donné",
    }
    /// --size
    size_help() { "How large, see below", "Quelle taille, voir plus bas" }
    /// What was written.
    written(scene, view) { "{scene}, and its view in {view}", "{scene}, et sa vue dans {view}" }

    course() { "a plane, three spheres, two cubes, three lamps", "un plan, trois sphères, deux cubes, trois sources" }
    sphereflake() {
        "spheres that carry nine each, so often (E. Haines' «balls» at 4)",
        "des sphères qui en portent neuf, tant de fois (« balls » d'E. Haines à 4)",
    }
    tetrahedron() {
        "tetrahedra of tetrahedra, so often (E. Haines' «tetra» at 6)",
        "des tétraèdres de tétraèdres, tant de fois (« tetra » d'E. Haines à 6)",
    }
    mountain() {
        "a fractal mountain and four glass spheres (E. Haines' «mount» at 6)",
        "une montagne fractale et quatre sphères de verre (« mount » d'E. Haines à 6)",
    }
    field() { "a rough landscape of N×N cells", "un paysage accidenté de N×N mailles" }
    knot() { "a tube along a trefoil knot, N cells around it", "un tube le long d'un nœud de trèfle, N mailles autour" }
    pebble() { "a dented stone of 20·N² facets", "un galet cabossé de 20·N² facettes" }
    nest() { "N shells of glass within one another", "N coques de verre l'une dans l'autre" }
    lattice() { "N×N×N cells of balls and struts", "N×N×N mailles de boules et de barres" }
    sponge() { "Menger's sponge of the N-th step", "l'éponge de Menger à l'étape N" }
}
