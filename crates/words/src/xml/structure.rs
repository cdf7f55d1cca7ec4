//! What is said of elements, attributes, names and references.

reports! {
    /// An element that the vocabulary does not have, or not there.
    unknown_element(name, parent, guess, legal) {
        "there is no element `{name}` in `{parent}`", "{guess}", "`{parent}` holds {legal}";
        "il n'y a pas d'élément « {name} » dans « {parent} »", "{guess}", "« {parent} » contient {legal}";
    }
    /// An element within one that holds none.
    no_elements(name, parent) {
        "there is no element `{name}` in `{parent}`", "", "`{parent}` holds no elements: close it before this one";
        "il n'y a pas d'élément « {name} » dans « {parent} »", "",
        "« {parent} » ne contient pas d'éléments : fermez-le avant celui-ci";
    }
    /// A known element in the wrong place.
    misplaced_element(name, parent, home) {
        "`{name}` does not stand in `{parent}`", "", "its place is in {home}";
        "« {name} » n'est pas à sa place dans « {parent} »", "", "sa place est dans {home}";
    }
    /// An attribute that the element does not have.
    unknown_attribute(name, element, guess, legal) {
        "`{element}` has no attribute `{name}`", "{guess}", "its attributes: {legal}";
        "« {element} » n'a pas d'attribut « {name} »", "{guess}", "ses attributs : {legal}";
    }
    /// An attribute on an element that has none.
    no_attributes(name, element) {
        "`{element}` has no attribute `{name}`", "", "`{element}` takes no attributes";
        "« {element} » n'a pas d'attribut « {name} »", "", "« {element} » ne prend pas d'attributs";
    }
    /// A required attribute is missing.
    missing_attribute(name, element, sample) {
        "`{element}` needs the attribute `{name}`", "`{name}` is missing here", "for example `{name}=\"{sample}\"`";
        "« {element} » demande l'attribut « {name} »", "« {name} » manque ici", "par exemple « {name}=\"{sample}\" »";
    }
    /// A required element is missing.
    missing_element(name, parent, sample) {
        "`{parent}` needs an element `{name}`", "it is missing in this one", "for example `{sample}`";
        "« {parent} » demande un élément « {name} »", "il manque dans celui-ci", "par exemple « {sample} »";
    }
    /// A mesh without anything to show.
    empty_mesh() {
        "a `mesh` needs vertices and facets, or a file", "neither is given here",
        "write `<vertices>…</vertices><facets>…</facets>` within, or name a file: `src=\"rabbit.obj\"`";
        "un « mesh » demande des sommets et des facettes, ou un fichier", "ni l'un ni l'autre n'est donné ici",
        "écrivez « <vertices>…</vertices><facets>…</facets> » dedans, ou nommez un fichier : « src=\"rabbit.obj\" »";
    }
    /// An element that may stand once stands again.
    second_element(name, parent, line) {
        "a second `{name}` in one `{parent}`", "the first stands on line {line}", "keep one of them";
        "un second « {name} » dans un même « {parent} »", "le premier est à la ligne {line}", "n'en gardez qu'un";
    }
    /// Text that is no white space where none is due.
    stray_text(parent) {
        "text has no place in `{parent}`", "", "for a remark write a comment: `<!-- like this -->`";
        "un texte n'a pas sa place dans « {parent} »", "", "pour une remarque, un commentaire : « <!-- ainsi --> »";
    }
    /// `material=` and an inline material.
    two_materials(element) {
        "this `{element}` has two materials: a name and an inline one", "the inline one", "keep one of them";
        "ce « {element} » a deux matières : un nom et une matière incluse", "la matière incluse", "n'en gardez qu'une";
    }
    /// An inline material with a name.
    named_inline() {
        "an inline material takes no name", "",
        "take the name out; or put the material beside the objects, and name it by `material=`";
        "une matière incluse ne prend pas de nom", "",
        "ôtez le nom ; ou placez la matière à côté des objets, et nommez-la par « material= »";
    }
    /// Inline geometry in a mesh that has a file.
    beside_source(name) {
        "`{name}` stands in a mesh that has a `src`", "",
        "the file brings vertices, facets and parts of its own: keep the file or what stands here";
        "« {name} » figure dans un maillage qui a un « src »", "",
        "le fichier apporte ses sommets, facettes et parties : gardez le fichier ou ce qui est ici";
    }
    /// A screen beside `look-at`.
    screen_beside_look_at() {
        "the screen is given twice: by `look-at` and by `screen`", "the second one",
        "keep `look-at` in `eye`, or this `screen`";
        "l'écran est donné deux fois : par « look-at » et par « screen »", "la seconde fois",
        "gardez « look-at » dans « eye », ou ce « screen »";
    }
    /// `up` or `fov` of an eye that looks at nothing.
    needs_look_at(name) {
        "`{name}` has no meaning without `look-at`", "",
        "add `look-at=\"0 0 0\"`, or take `{name}` out: the `screen` decides";
        "« {name} » n'a pas de sens sans « look-at »", "",
        "ajoutez « look-at=\"0 0 0\" », ou ôtez « {name} » : c'est « screen » qui décide";
    }
    /// Attributes of two ways to give a screen.
    mixed_screen(name, other) {
        "`{name}` does not go with `{other}`", "",
        "a screen is `origin`, `u` and `v`; or `center`, `size` and perhaps `up`; or `corners`";
        "« {name} » ne va pas avec « {other} »", "",
        "un écran est « origin », « u » et « v » ; ou « center », « size » et au besoin « up » ; ou « corners »";
    }
    /// A screen element without any place.
    empty_screen() {
        "this `screen` does not say where it is", "",
        "a screen is `origin`, `u` and `v`; or `center`, `size` and perhaps `up`; or `corners`";
        "ce « screen » ne dit pas où il est", "",
        "un écran est « origin », « u » et « v » ; ou « center », « size » et au besoin « up » ; ou « corners »";
    }
    /// A view without a screen.
    no_screen(name) {
        "the view `{name}` has no screen", "this eye looks nowhere",
        "add `look-at=\"0 0 0\"` to `eye`, or a `<screen …/>` beside it";
        "la vue « {name} » n'a pas d'écran", "cet œil ne regarde nulle part",
        "ajoutez « look-at=\"0 0 0\" » à « eye », ou un « <screen …/> » à côté";
    }
    /// A root that is no document's.
    unknown_root(name, guess) {
        "`{name}` is neither a scene nor a view", "{guess}",
        "a scene begins with `<scene version=\"1\">`, a view with `<views version=\"1\">`";
        "« {name} » n'est ni une scène ni une vue", "{guess}",
        "une scène commence par « <scene version=\"1\"> », une vue par « <views version=\"1\"> »";
    }
    /// Views where a scene is due.
    views_for_scene() {
        "this document holds views, where a scene is due", "",
        "were the two files exchanged? The scene comes first, then the view";
        "ce document contient des vues, là où une scène est attendue", "",
        "les deux fichiers sont-ils intervertis ? D'abord la scène, puis la vue";
    }
    /// A scene where views are due.
    scene_for_views() {
        "this document holds a scene, where a view is due", "",
        "were the two files exchanged? The scene comes first, then the view";
        "ce document contient une scène, là où une vue est attendue", "",
        "les deux fichiers sont-ils intervertis ? D'abord la scène, puis la vue";
    }
    /// `Scene` with native content.
    scene_of_2009() {
        "`Scene` begins a document of 2009, but this one is written in today's elements", "did you mean `scene`?",
        "today's names are all in small letters";
        "« Scene » commence un document de 2009, mais celui-ci est écrit avec les éléments d'aujourd'hui",
        "vouliez-vous dire « scene » ?", "les noms d'aujourd'hui sont tous en minuscules";
    }
    /// A later version of the format.
    newer_version(version) {
        "this file needs a newer lancer: it is of version {version}", "1 is the latest version known here",
        "use the lancer that wrote it, or save it as version 1";
        "ce fichier demande un lancer plus récent : il est de la version {version}",
        "1 est la dernière version connue ici",
        "utilisez le lancer qui l'a écrit, ou enregistrez-le en version 1";
    }
    /// A version of nothing.
    empty_version() {
        "the version is empty", "", "write `version=\"1\"`";
        "la version est vide", "", "écrivez « version=\"1\" »";
    }
    /// A version that is none.
    bad_version(found) {
        "`{found}` is no version of this format", "", "write `version=\"1\"`";
        "« {found} » n'est pas une version de ce format", "", "écrivez « version=\"1\" »";
    }
    /// A name that another object or lamp has.
    object_name_taken(name, line) {
        "the name `{name}` is taken", "it is first used on line {line}",
        "names are unique among objects and lamps together: rename one, or take its name out and it gets a free one";
        "le nom « {name} » est déjà pris", "il est déjà employé à la ligne {line}",
        "les noms sont uniques parmi les objets et les sources : changez-en un, ou ôtez-le et un nom libre sera donné";
    }
    /// A name that another material has.
    material_name_taken(name, line) {
        "the material `{name}` is defined twice", "it is first defined on line {line}",
        "names are unique among the materials: rename one";
        "la matière « {name} » est définie deux fois", "elle est déjà définie à la ligne {line}",
        "les noms sont uniques parmi les matières : changez-en un";
    }
    /// A name that another view has.
    view_name_taken(name, line) {
        "the view `{name}` is defined twice", "it is first defined on line {line}",
        "names are unique among the views: rename one";
        "la vue « {name} » est définie deux fois", "elle est déjà définie à la ligne {line}",
        "les noms sont uniques parmi les vues : changez-en un";
    }
    /// A reference to a material that does not exist.
    unknown_material(name, guess, known) {
        "there is no material `{name}`", "{guess}", "{known}";
        "il n'y a pas de matière « {name} »", "{guess}", "{known}";
    }
    /// A screen that shows the scene mirrored.
    mirrored_screen() {
        "the picture shows the scene mirrored", "seen from the eye, left and right are exchanged",
        "seen from the eye, `u` points to the right and `v` downwards; turn one of them round if this is not meant";
        "l'image montre la scène en miroir", "vues de l'œil, la gauche et la droite sont échangées",
        "vus de l'œil, « u » va vers la droite et « v » vers le bas ; retournez l'un des deux si ce n'est pas voulu";
    }
    /// A document of views without a view.
    no_views() {
        "the document has no view", "", "add `<view><eye at=\"0 1 5\" look-at=\"0 0 0\"/></view>`";
        "le document n'a aucune vue", "", "ajoutez « <view><eye at=\"0 1 5\" look-at=\"0 0 0\"/></view> »";
    }
    /// More problems than are listed.
    too_many(count) {
        "there are more than {count} problems: the others are not listed", "", "correct the first ones and try again";
        "il y a plus de {count} problèmes : les autres ne sont pas listés", "",
        "corrigez les premiers et recommencez";
    }
}

phrases! {
    /// A material of no name that is near.
    no_such_material() { "no material has this name", "aucune matière ne porte ce nom" }
    /// The materials that exist.
    known_materials(names) { "the document's materials: {names}", "les matières du document : {names}" }
    /// There are none.
    no_materials() {
        "the document has no material: add `<material name=\"…\"/>`",
        "le document n'a aucune matière : ajoutez « <material name=\"…\"/> »",
    }
}
