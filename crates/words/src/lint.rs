//! What lint says: what it found, and the way out.

phrases! {
    no_lamp() {
        "there is no lamp: only ambient light reaches the objects",
        "il n'y a aucune source de lumière : seule la lumière ambiante atteint les objets",
    }
    no_lamp_help() {
        "add a `<light position=\"…\"/>`",
        "ajoutez une source : « <light position=\"…\"/> »",
    }
    all_lamps_hidden() {
        "every lamp is hidden: only ambient light reaches the objects",
        "toutes les sources sont masquées : seule la lumière ambiante atteint les objets",
    }
    no_object() {
        "there is no object: the picture shows the background alone",
        "il n'y a aucun objet : l'image ne montre que le fond",
    }
    no_object_help() {
        "add an object, such as `<sphere center=\"0 0 0\" radius=\"1\"/>`",
        "ajoutez un objet, par exemple « <sphere center=\"0 0 0\" radius=\"1\"/> »",
    }
    all_objects_hidden() {
        "every object is hidden: the picture shows the background alone",
        "tous les objets sont masqués : l'image ne montre que le fond",
    }
    show_one_help() {
        "take one `visible=\"false\"` off",
        "ôtez un « visible=\"false\" »",
    }
    dark_lamp(lamp) {
        "the lamp `{lamp}` is black and gives no light",
        "la source « {lamp} » est noire et n'éclaire rien",
    }
    dark_lamp_help() {
        "give it a colour, or hide it with `visible=\"false\"`",
        "donnez-lui une couleur, ou masquez-la par « visible=\"false\" »",
    }
    lamp_inside(lamp, object) {
        "the lamp `{lamp}` is inside `{object}` and lights nothing outside it",
        "la source « {lamp} » est à l'intérieur de « {object} » et n'éclaire rien au-dehors",
    }
    lamp_inside_help() {
        "objects shadow fully, transparent ones too: move the lamp out, or hide the object with `visible=\"false\"`",
        "les objets font entièrement ombre, même transparents : sortez la source, ou masquez l'objet par « visible=\"false\" »",
    }
    lamp_behind_plane(lamp, plane) {
        "the lamp `{lamp}` is behind the plane `{plane}` and lights nothing that is seen",
        "la source « {lamp} » est derrière le plan « {plane} » et n'éclaire rien de visible",
    }
    lamp_behind_plane_help() {
        "a plane has no end: move the lamp to the side where the objects and the eye are",
        "un plan est infini : mettez la source du côté des objets et de l'œil",
    }
    eye_inside(view, object) {
        "the eye of view `{view}` is inside `{object}` and sees nothing outside it",
        "l'œil de la vue « {view} » est à l'intérieur de « {object} » et ne voit rien au-dehors",
    }
    eye_inside_help() {
        "move the eye out, or hide the object with `visible=\"false\"`",
        "sortez l'œil, ou masquez l'objet par « visible=\"false\" »",
    }
    eye_in_glass(view, object) {
        "the eye of view `{view}` is inside the transparent object `{object}`: its rays start in that medium",
        "l'œil de la vue « {view} » est à l'intérieur de l'objet transparent « {object} » : ses rayons partent dans ce milieu",
    }
    eye_in_glass_help() {
        "move the eye out if that is not meant",
        "sortez l'œil si ce n'est pas voulu",
    }
    eye_behind_glass_plane(view, plane) {
        "the eye of view `{view}` is behind the transparent plane `{plane}`: its rays start in that medium",
        "l'œil de la vue « {view} » est derrière le plan transparent « {plane} » : ses rayons partent dans ce milieu",
    }
    eye_behind_glass_plane_help() {
        "a plane encloses the side away from its normal P0P1 × P0P2: if that is not meant, exchange p1 and p2",
        "un plan enferme le côté opposé à sa normale P0P1 ∧ P0P2 : si ce n'est pas voulu, échangez p1 et p2",
    }
    eye_behind_plane(view, plane) {
        "the plane `{plane}` hides every other object from view `{view}`",
        "le plan « {plane} » cache tous les autres objets à la vue « {view} »",
    }
    eye_behind_plane_help() {
        "the eye is on the other side of it: move the eye or the plane",
        "l'œil est de l'autre côté : déplacez l'œil ou le plan",
    }
    plane_through_eye(view, plane) {
        "the plane `{plane}` passes through the eye of view `{view}`, which sees nothing of it",
        "le plan « {plane} » passe par l'œil de la vue « {view} », qui n'en voit rien",
    }
    plane_through_eye_help() {
        "a plane seen from its edge has no width: move the eye or the plane a little",
        "un plan vu par la tranche n'a pas d'épaisseur : déplacez un peu l'œil ou le plan",
    }
    mirrored_view(view) {
        "view `{view}` shows the scene mirrored: left and right are exchanged",
        "la vue « {view} » montre la scène en miroir : la gauche et la droite sont échangées",
    }
    mirrored_view_help() {
        "turn the screen's `u` around and move its `origin` to the other end of it",
        "retournez le bord « u » de l'écran et mettez son « origin » à l'autre bout",
    }
    pixels_too_wide(view, ratio) {
        "the pixels of view `{view}` are {ratio} times as wide as high: the picture looks squeezed",
        "les pixels de la vue « {view} » sont {ratio} fois plus larges que hauts : l'image paraît comprimée en largeur",
    }
    pixels_too_high(view, ratio) {
        "the pixels of view `{view}` are {ratio} times as high as wide: the picture looks stretched",
        "les pixels de la vue « {view} » sont {ratio} fois plus hauts que larges : l'image paraît étirée en largeur",
    }
    pixels_not_square_help() {
        "give `width` and `height` the same proportion as the sides of the screen",
        "donnez à « width » et « height » la même proportion que les côtés de l'écran",
    }
    depth_too_small_for_mirror(depth, object) {
        "with depth {depth} the mirror `{object}` reflects nothing",
        "avec la profondeur {depth}, le miroir « {object} » ne reflète rien",
    }
    depth_too_small_for_glass(depth, object) {
        "with depth {depth} nothing is seen through `{object}`",
        "avec la profondeur {depth}, on ne voit rien à travers « {object} »",
    }
    depth_of_view(view, finding) {
        "view `{view}`: {finding}",
        "vue « {view} » : {finding}",
    }
    depth_too_small_help(enough) {
        "set `depth` to {enough} or more",
        "portez « depth » à {enough} ou plus",
    }
    glass_depth_help() {
        "a ray that goes in must come out again: set `depth` to 2 or more",
        "un rayon qui entre doit ressortir : portez « depth » à 2 ou plus",
    }
    facing_mirrors(depth, first, second) {
        "with depth {depth} the reflections between the mirrors `{first}` and `{second}` end in the dark",
        "avec la profondeur {depth}, les reflets entre les miroirs « {first} » et « {second} » finissent dans le noir",
    }
    facing_mirrors_help(enough) {
        "at a depth of {enough} the last of them is hardly seen",
        "à la profondeur {enough}, le dernier ne se voit presque plus",
    }
    one_hidden_behind_plane(plane, object) {
        "the plane `{plane}` hides `{object}` from every view",
        "le plan « {plane} » cache « {object} » à toutes les vues",
    }
    hidden_behind_plane(plane, object, count) {
        "the plane `{plane}` hides {count} objects from every view, the first of them `{object}`",
        "le plan « {plane} » cache {count} objets à toutes les vues, le premier étant « {object} »",
    }
    hidden_behind_plane_help() {
        "what is behind an opaque plane takes no part in the picture: move it, or take it out",
        "ce qui est derrière un plan opaque ne participe pas à l'image : déplacez-le ou ôtez-le",
    }
    coincident_faces(first, second) {
        "faces of `{first}` and `{second}` lie in one place: which one is seen depends on rounding",
        "des faces de « {first} » et « {second} » sont au même endroit : l'arrondi décide de celle qu'on voit",
    }
    coincident_faces_help() {
        "move one of them by a hair; glass that holds something should overlap it a little",
        "décalez légèrement l'un des deux ; un verre doit pénétrer un peu ce qu'il contient",
    }
    open_glass(object) {
        "the transparent mesh `{object}` is not closed: it is taken for a sheet without thickness and does not refract",
        "le maillage transparent « {object} » n'est pas fermé : il compte comme une feuille sans épaisseur et ne réfracte pas",
    }
    open_glass_help() {
        "in a closed mesh every edge has exactly two facets, which run along it in opposite directions",
        "dans un maillage fermé, chaque arête a exactement deux facettes, qui la parcourent en sens opposés",
    }
    sheet_glass(object) {
        "`{object}` is a sheet without thickness: its refraction index is not used",
        "« {object} » est une feuille sans épaisseur : son indice de réfraction ne sert pas",
    }
    sheet_glass_help() {
        "for glass with thickness take a `<box>`, a capped `<cone>` or a closed `<mesh>`",
        "pour un verre épais, prenez un « <box> », un « <cone> » aux bouts fermés ou un « <mesh> » fermé",
    }
    empty_mesh(object) {
        "the mesh `{object}` has no facets and is not seen",
        "le maillage « {object} » n'a pas de facettes et ne se voit pas",
    }
    empty_mesh_help() {
        "add `<facets>`, or take the mesh out",
        "ajoutez des facettes dans « <facets> », ou ôtez le maillage",
    }
    unused_material(material) {
        "the material `{material}` is not used",
        "la matière « {material} » n'est portée par aucun objet",
    }
    unused_material_help(material) {
        "give it to an object with `material=\"{material}\"`, or take it out",
        "donnez-la à un objet par « material=\"{material}\" », ou ôtez-la",
    }
    world_index_below_one(index) {
        "the refraction index {index} of the world is less than 1, that of empty space",
        "l'indice de réfraction {index} du milieu ambiant est inférieur à 1, celui du vide",
    }
    material_index_below_one(material, index) {
        "the refraction index {index} of the material `{material}` is less than 1, that of empty space",
        "l'indice de réfraction {index} de la matière « {material} » est inférieur à 1, celui du vide",
    }
    object_index_below_one(object, index) {
        "the refraction index {index} of `{object}` is less than 1, that of empty space",
        "l'indice de réfraction {index} de « {object} » est inférieur à 1, celui du vide",
    }
    index_below_one_help() {
        "indices are absolute: air 1, water 1.33, glass 1.5; for a bubble in water give 1 to the bubble and 1.33 to the water",
        "les indices sont absolus : air 1, eau 1.33, verre 1.5 ; pour une bulle dans l'eau, 1 à la bulle et 1.33 à l'eau",
    }
    material_always_white(material) {
        "the material `{material}` is white everywhere: Ka·Ia alone is already 1",
        "la matière « {material} » est blanche partout : Ka·Ia vaut déjà 1",
    }
    object_always_white(object) {
        "`{object}` is white everywhere: Ka·Ia alone is already 1",
        "« {object} » est blanc partout : Ka·Ia vaut déjà 1",
    }
    always_white_help() {
        "no light can be added to 1: lower `ka` of the material or `ambient` of the world",
        "on n'ajoute pas de lumière à 1 : baissez « ka » de la matière ou « ambient » du monde",
    }
}
