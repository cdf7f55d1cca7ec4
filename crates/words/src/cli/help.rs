//! The help texts of the command line.

phrases! {
    // ---- help: headings and the forms of the commands -------------------------------------------------------------

    /// Before the form of a command.
    usage_heading() { "Usage:", "Emploi :" }
    /// Above the positional arguments; the parser adds a colon to this and the next two.
    arguments_heading() { "Arguments", "Arguments " }
    /// Above the options.
    options_heading() { "Options", "Options " }
    /// Above the subcommands.
    commands_heading() { "Commands", "Commandes " }
    /// The value names of help texts.
    scene_value() { "SCENE", "SCÈNE" }
    /// A view document.
    view_value() { "VIEW", "VUE" }
    /// A picture to write.
    output_value() { "OUTPUT", "IMAGE" }
    /// Any file.
    file_value() { "FILE", "FICHIER" }
    /// A folder.
    folder_value() { "FOLDER", "DOSSIER" }
    /// A name.
    name_value() { "NAME", "NOM" }
    /// A list.
    list_value() { "LIST", "LISTE" }
    /// A size in pixels.
    size_value() { "WxH", "LxH" }
    /// A rectangle.
    region_value() { "X,Y,W,H", "X,Y,L,H" }
    /// A form of output.
    form_value() { "FORM", "FORME" }
    /// A command.
    command_value() { "COMMAND", "COMMANDE" }
    /// What is read in a conversion.
    input_value() { "IN", "ENTRÉE" }
    /// What is written in a conversion.
    converted_value() { "OUT", "SORTIE" }

    // ---- help: what the commands do -------------------------------------------------------------------------------

    /// The program in one line.
    about() {
        "Ray casting by the formulas of the course: a scene and a view in, an exact picture out",
        "Lancer de rayon selon les formules du cours : une scène et une vue en entrée, une image exacte en sortie",
    }
    /// The forms of the program.
    usage() {
        "lancer [OPTIONS] SCENE VIEW [OUTPUT]\n       lancer COMMAND …",
        "lancer [OPTIONS] SCÈNE VUE [IMAGE]\n       lancer COMMANDE …",
    }
    /// After the options of the program.
    after_help() {
        "Examples:
  lancer scene.xml view.xml                      the first view, written to output.ppm
  lancer scene.xml view.xml front.png --view front
  lancer explain scene.xml view.xml 320 240      where the colour of one pixel comes from

A scene file that is named like a command is given as ./show.

Environment: LANCER_SIMD=portable, avx2 or avx512 chooses the instructions of the engine simd; otherwise it uses the best that the machine has. The picture is the same.

Exit status: 0 done; 1 the input is wrong, or `diff` found differences, or `check` found errors; 2 wrong use of the command line; 3 a file cannot be read or written, or memory is short; 130 interrupted.",
        "Exemples :
  lancer scene.xml vue.xml                       la première vue, écrite dans output.ppm
  lancer scene.xml vue.xml face.png --view face
  lancer explain scene.xml vue.xml 320 240       d'où vient la couleur d'un pixel

Un fichier de scène qui porte le nom d'une commande se donne ainsi : ./show.

Environnement : LANCER_SIMD=portable, avx2 ou avx512 choisit les instructions du moteur simd ; sinon il emploie les meilleures de la machine. L'image est la même.

Code de retour : 0 terminé ; 1 l'entrée est fausse, ou `diff` a trouvé des différences, ou `check` des erreurs ; 2 mauvais emploi de la ligne de commande ; 3 fichier impossible à lire ou à écrire, ou mémoire insuffisante ; 130 interrompu.",
    }
    /// `lancer show`.
    about_show() { "Print a scene as text", "Affiche une scène en texte" }
    /// Its form.
    usage_show() { "lancer show [OPTIONS] SCENE", "lancer show [OPTIONS] SCÈNE" }
    /// `lancer check`.
    about_check() {
        "Report every error and every suspicious thing in scenes and views",
        "Signale toutes les erreurs et tout ce qui est suspect dans des scènes et des vues",
    }
    /// Its form.
    usage_check() { "lancer check [OPTIONS] FILE…", "lancer check [OPTIONS] FICHIER…" }
    /// More about it.
    after_check() {
        "A view document is looked at together with the scene of the same name beside it (first.view.xml with \
first.xml), or with the only scene that is given. Exit status: 1 if there are errors; findings alone give 0.",
        "Un document de vues est examiné avec la scène de même nom à côté de lui (premier.view.xml avec \
premier.xml), ou avec la seule scène donnée. Code de retour : 1 s'il y a des erreurs ; de simples remarques \
donnent 0.",
    }
    /// `lancer convert`.
    about_convert() {
        "Convert a scene, views or a picture to another format",
        "Convertit une scène, des vues ou une image dans un autre format",
    }
    /// Its form.
    usage_convert() { "lancer convert [OPTIONS] IN OUT", "lancer convert [OPTIONS] ENTRÉE SORTIE" }
    /// `lancer explain`.
    about_explain() {
        "Explain one pixel: its tree of rays, every term, every ⊕, down to the byte",
        "Explique un pixel : son arbre de rayons, chaque terme, chaque ⊕, jusqu'à l'octet",
    }
    /// Its form.
    usage_explain() { "lancer explain [OPTIONS] SCENE VIEW X Y", "lancer explain [OPTIONS] SCÈNE VUE X Y" }
    /// `lancer diff`.
    about_diff() {
        "Compare two pictures: how many pixels differ, where, and by how much",
        "Compare deux images : combien de pixels diffèrent, où et de combien",
    }
    /// Its form.
    usage_diff() { "lancer diff [OPTIONS] A B", "lancer diff [OPTIONS] A B" }
    /// `lancer schema`.
    about_schema() {
        "Print the schema of scene and view documents",
        "Affiche le schéma des documents de scène et de vues",
    }
    /// Its form.
    usage_schema() { "lancer schema [OPTIONS]", "lancer schema [OPTIONS]" }
    /// `lancer completions`.
    about_completions() {
        "Print the completion script of a shell",
        "Affiche le script de complétion d'un interpréteur de commandes",
    }
    /// Its form.
    usage_completions() { "lancer completions [OPTIONS] SHELL", "lancer completions [OPTIONS] SHELL" }
    /// `lancer man`.
    about_man() { "Print the manual page", "Affiche la page de manuel" }
    /// Its form.
    usage_man() { "lancer man [OPTIONS] [COMMAND]", "lancer man [OPTIONS] [COMMANDE]" }
    /// `lancer help`.
    about_help() { "Print help for the program or a command", "Affiche l'aide du programme ou d'une commande" }
    /// Its form.
    usage_help() { "lancer help [COMMAND]", "lancer help [COMMANDE]" }

    // ---- help: arguments and options ------------------------------------------------------------------------------

    /// SCENE
    scene_help() {
        "The scene: XML, binary (.lancer), NFF, a mesh file, or a document of 2009",
        "La scène : XML, binaire (.lancer), NFF, fichier de maillage ou document de 2009",
    }
    /// SCENE of show
    show_help() { "A scene, or views", "Une scène, ou des vues" }
    /// VIEW
    view_help() {
        "The document that holds the eye and the screen of one or more views",
        "Le document qui contient l'œil et l'écran d'une ou de plusieurs vues",
    }
    /// OUTPUT
    output_help(formats) {
        "The picture to write; its extension picks the format ({formats}), `-` is standard output, \
`output.ppm` where none is given",
        "L'image à écrire ; l'extension choisit le format ({formats}), `-` désigne la sortie standard, \
`output.ppm` si rien n'est donné",
    }
    /// --view
    view_name_help() {
        "Take the view of that name instead of the first",
        "Prend la vue de ce nom au lieu de la première",
    }
    /// --all-views
    all_views_help() {
        "Render every view: OUTPUT gets the view's name before its extension, or where it says {{view}}",
        "Calcule toutes les vues : IMAGE reçoit le nom de la vue avant l'extension, ou là où elle porte {{view}}",
    }
    /// --size
    size_help() { "Width and height in pixels, instead of the view's", "Largeur et hauteur en pixels, à la place de celles de la vue" }
    /// --depth
    depth_help() {
        "Depth limit of the rays, 0 to 64, instead of the document's",
        "Profondeur limite des rayons, de 0 à 64, à la place de celle du document",
    }
    /// --samples
    samples_help() {
        "N×N samples for each pixel, 1 to 64, instead of the view's",
        "N×N échantillons par pixel, de 1 à 64, à la place de ceux de la vue",
    }
    /// --adaptive
    adaptive_help() {
        "Take the samples only of pixels whose colour at the centre differs from that of one of the eight around by more than T in some channel, 0 to 1; such as --samples 4 --adaptive 0.05",
        "Ne prend les échantillons que des pixels dont la couleur au centre diffère de celle d'un des huit voisins de plus de T dans un canal, de 0 à 1 ; par exemple --samples 4 --adaptive 0.05",
    }
    /// --region
    region_help() {
        "Render only these pixels: left column, top row, width, height; the picture has that size",
        "Ne calcule que ces pixels : colonne de gauche, ligne du haut, largeur, hauteur ; l'image a cette taille",
    }
    /// --without
    without_help() {
        "Leave out steps of the algorithm, separated by commas: shadows, reflection, transparency",
        "Omet des étapes de l'algorithme, séparées par des virgules : shadows (ombres), reflection (réflexion), \
transparency (transparence)",
    }
    /// --threads
    threads_help() {
        "Number of threads; the picture is the same for every number",
        "Nombre de fils d'exécution ; l'image est la même quel que soit ce nombre",
    }
    /// --engine
    engine_help() {
        "What follows the rays: simd, many at a time (the default), or reference, the formulas of the course one ray at a time; the picture is the same",
        "Ce qui suit les rayons : simd, beaucoup à la fois (par défaut), ou reference, les formules du cours un rayon après l'autre ; l'image est la même",
    }
    /// --max-rays
    max_rays_help(default) {
        "How many rays one pixel may cost before it is an error (default {default})",
        "Nombre de rayons qu'un pixel peut coûter avant d'être une erreur ({default} par défaut)",
    }
    /// --binary
    binary_help() { "Write a .ppm file in its binary form, P6", "Écrit un fichier .ppm sous sa forme binaire, P6" }
    /// --stats
    stats_help() {
        "Print the time of each stage and the rays by kind, as text or as json; on standard output, or on standard \
error where the picture goes to standard output",
        "Affiche la durée de chaque étape et les rayons par sorte, en text ou en json ; sur la sortie standard, ou sur \
la sortie d'erreur si l'image va sur la sortie standard",
    }
    /// --quiet
    quiet_help() { "No progress bar, no warnings", "Ni barre de progression, ni avertissements" }
    /// --allow-outside
    allow_outside_help() {
        "Allow a scene to name files outside its own folder",
        "Autorise une scène à nommer des fichiers hors de son propre dossier",
    }
    /// --lang
    lang_help() {
        "Language of the messages, en or fr; otherwise LC_ALL, LC_MESSAGES and LANG decide",
        "Langue des messages, en ou fr ; sinon LC_ALL, LC_MESSAGES et LANG décident",
    }
    /// --help
    help_help() { "Print this help", "Affiche cette aide" }
    /// --version
    version_help() { "Print the version", "Affiche la version" }
    /// FILE… of check
    check_files_help() { "Scenes and views", "Scènes et vues" }
    /// --json of check
    check_json_help() { "Print the findings as JSON", "Affiche les remarques en JSON" }
    /// IN of convert
    convert_in_help() { "A scene, views or a picture", "Une scène, des vues ou une image" }
    /// OUT of convert
    convert_out_help() {
        "The file to write; its extension picks the format: scenes xml, lancer, pov (POV-Ray), obj with its mtl, gltf, glb; views xml; or that of a picture",
        "Le fichier à écrire ; son extension choisit le format : scènes xml, lancer, pov (POV-Ray), obj avec son mtl, gltf, glb ; vues xml ; ou celui d'une image",
    }
    /// --views of convert
    convert_views_help() {
        "The views of the scene, for a format that holds a camera (pov); where none is given, those beside it: scene.view.xml with scene.xml",
        "Les vues de la scène, pour un format qui contient une caméra (pov) ; sinon celles à côté d'elle : scène.view.xml avec scène.xml",
    }
    /// --to of convert
    convert_to_help() {
        "The format of a scene or of views instead of the extension's: xml, binary, 2009 for the documents of 2009, pov, gltf or glb",
        "Le format d'une scène ou de vues au lieu de celui de l'extension : xml, binary (binaire), 2009 pour les \
documents de 2009, pov, gltf ou glb",
    }
    /// X of explain
    x_help() { "The pixel's column, from 0 at the left", "La colonne du pixel, à partir de 0 à gauche" }
    /// Y of explain
    y_help() { "The pixel's row, from 0 at the top", "La ligne du pixel, à partir de 0 en haut" }
    /// --json of explain
    explain_json_help() {
        "Print the tree as JSON, with all digits",
        "Affiche l'arbre en JSON, avec tous les chiffres",
    }
    /// --levels of explain
    levels_help() {
        "Print only the first N levels of rays below the primary ray",
        "N'affiche que les N premiers niveaux de rayons sous le rayon primaire",
    }
    /// A and B of diff
    diff_picture_help() { "A picture", "Une image" }
    /// --tolerance
    tolerance_help() {
        "The difference of a channel that still counts as the same, 0 to 255 (default 0)",
        "L'écart d'un canal qui compte encore comme égal, de 0 à 255 (0 par défaut)",
    }
    /// -o of diff
    diff_output_help() {
        "Write a picture of the differences: A in dark grey, differing pixels from red (little) to yellow (much)",
        "Écrit une image des différences : A en gris sombre, les pixels différents du rouge (peu) au jaune (beaucoup)",
    }
    /// SHELL
    shell_help() { "bash, elvish, fish, powershell or zsh", "bash, elvish, fish, powershell ou zsh" }
    /// COMMAND of man and help
    command_help() { "The command that is asked about", "La commande dont il s'agit" }

    // ---- headings of the manual page ------------------------------------------------------------------------------

    /// NAME
    man_name() { "NAME", "NOM" }
    /// SYNOPSIS
    man_synopsis() { "SYNOPSIS", "SYNOPSIS" }
    /// DESCRIPTION
    man_description() { "DESCRIPTION", "DESCRIPTION" }
    /// After the options.
    man_extra() { "NOTES", "NOTES" }
    /// VERSION
    man_version() { "VERSION", "VERSION" }
}
