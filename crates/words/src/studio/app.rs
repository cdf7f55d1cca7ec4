//! Words of the editor's window: messages, questions, the start.

phrases! {
    /// Closes a message or a window.
    close() { "Close", "Fermer" }
    /// Gives something up.
    cancel() { "Cancel", "Annuler" }
    /// Agrees.
    ok() { "OK", "OK" }
    /// The name of a document that has no file yet.
    untitled() { "Untitled", "Sans titre" }
    /// The mark of a document that is not saved.
    modified() { "modified", "modifié" }
    /// The mark of a document that is saved.
    saved() { "saved", "enregistré" }
    /// The window's title.
    window_title(document) { "{document} · lancer", "{document} · lancer" }
    /// The window's title where there are unsaved changes.
    window_title_modified(document) { "{document} (modified) · lancer", "{document} (modifié) · lancer" }

    /// The panel on the left.
    outliner() { "Scene", "Scène" }
    /// The panel on the right.
    properties() { "Properties", "Propriétés" }
    /// The scene in words.
    tab_text() { "Text", "Texte" }
    /// The scene as a document.
    tab_xml() { "XML", "XML" }
    /// What is wrong with files.
    tab_problems() { "Problems", "Problèmes" }
    /// A pixel with all its rays.
    tab_explain() { "Explain", "Explication" }
    /// The steps.
    tab_history() { "History", "Historique" }

    /// The question before unsaved work is lost.
    unsaved_title() { "Save the changes?", "Enregistrer les modifications ?" }
    /// What would be lost.
    unsaved_text(document) {
        "{document} has changes that are not saved. They are lost if you go on without saving.",
        "{document} contient des modifications non enregistrées. Elles seront perdues si vous continuez sans enregistrer.",
    }
    /// Saves and goes on.
    unsaved_save() { "Save", "Enregistrer" }
    /// Goes on without saving.
    unsaved_discard() { "Don't save", "Ne pas enregistrer" }

    /// The question after a crash.
    recover_title() { "Recover unsaved work?", "Récupérer le travail non enregistré ?" }
    /// What was left.
    recover_text(document, ago) {
        "The program ended last time without saving. {document} was kept as it was {ago}.",
        "Le programme s'est terminé la dernière fois sans enregistrer. {document} a été conservé tel qu'il était {ago}.",
    }
    /// Opens it.
    recover() { "Recover", "Récupérer" }
    /// Asks again on the next start.
    recover_later() { "Later", "Plus tard" }
    /// Removes it.
    recover_discard() { "Discard", "Abandonner" }
    /// Some minutes ago.
    minutes_ago(count) { "{count} min ago", "il y a {count} min" }
    /// Some hours ago.
    hours_ago(count) { "{count} h ago", "il y a {count} h" }
    /// Some days ago.
    days_ago(count) { "{count} d ago", "il y a {count} j" }
    /// A file is being read.
    loading(name) { "Reading {name}…", "Lecture de {name}…" }
    /// The bytes of a file are there, and what they say is being made out.
    making_out(name) { "Making out what {name} holds…", "Analyse du contenu de {name}…" }
    /// A file was read.
    loaded(name) { "{name} is open.", "{name} est ouvert." }
    /// A file was read with warnings.
    loaded_with(name, warnings) { "{name} is open: {warnings}.", "{name} est ouvert : {warnings}." }
    /// A file is broken.
    broken(name, errors) {
        "{name} cannot be opened: {errors}. The scene shown stays.",
        "{name} ne peut pas être ouvert : {errors}. La scène affichée reste.",
    }
    /// A file cannot be read.
    unreadable(name, cause) { "{name} cannot be read: {cause}", "{name} ne peut pas être lu : {cause}" }
    /// Something was saved.
    written(name) { "{name} is saved.", "{name} est enregistré." }
    /// A picture is rendered for a file.
    exporting(name) { "Rendering {name}", "Calcul de {name}" }
    /// A picture cannot be rendered.
    cannot_export(cause) { "The picture cannot be rendered: {cause}.", "L'image ne peut pas être calculée : {cause}." }
    /// There is no memory.
    no_memory(width, height) {
        "there is no memory for {width}×{height} pixels",
        "la mémoire ne suffit pas pour {width}×{height} pixels",
    }
    /// There are no threads.
    no_threads(reason) { "no threads can be started ({reason})", "aucun fil d'exécution ne peut démarrer ({reason})" }
    /// A file was read again.
    reloaded(name) {
        "{name} was changed by another program and is read again. Undo brings the earlier state back.",
        "{name} a été modifié par un autre programme et relu. Annuler rétablit l'état précédent.",
    }
    /// Views were loaded.
    views_loaded(name, views) { "{name}: {views}.", "{name} : {views}." }
    /// Something was put on the clipboard.
    copied() { "Copied to the clipboard.", "Copié dans le presse-papiers." }
    /// An edit is not possible.
    refused(rule) { "Not possible: {rule}.", "Impossible : {rule}." }

    /// Goes to the folder that holds this one.
    folder_above() { "Folder above", "Dossier parent" }
    /// A folder has no file of that kind.
    folder_empty() { "No such files here", "Aucun fichier de ce type ici" }
    /// A folder cannot be listed, or a file is not there.
    folder_unreadable(cause) { "Not found or not readable: {cause}", "Introuvable ou illisible : {cause}" }
    /// The field of a file's name.
    file_name() { "File name", "Nom du fichier" }
    /// The field that chooses which files are listed.
    kinds_of_files() { "Kinds of files", "Types de fichiers" }
    /// Every kind of file.
    all_files() { "All files", "Tous les fichiers" }
    /// Scenes of every format.
    scenes() { "Scenes", "Scènes" }
    /// Scenes in XML.
    xml_scenes() { "Scenes in XML", "Scènes XML" }
    /// Binary scenes.
    binary_scenes() { "Binary scenes", "Scènes binaires" }
    /// Documents of views.
    view_documents() { "Views", "Vues" }
    /// Meshes.
    meshes() { "Meshes", "Maillages" }
    /// Pictures.
    pictures() { "Pictures", "Images" }
    /// Texts.
    texts() { "Texts", "Textes" }
    /// Opens.
    open() { "Open", "Ouvrir" }
    /// Saves.
    save() { "Save", "Enregistrer" }
    /// Replaces a file.
    replace() { "Replace", "Remplacer" }
    /// A file would be replaced.
    replaces(name) {
        "{name} exists: press Replace to replace it.",
        "{name} existe déjà : appuyez sur Remplacer pour le remplacer.",
    }
    /// The title of a dialog.
    open_title() { "Open a scene", "Ouvrir une scène" }
    /// The title of a dialog.
    save_title() { "Save the scene", "Enregistrer la scène" }
    /// The title of a dialog.
    load_views_title() { "Load views", "Charger des vues" }
    /// The title of a dialog.
    save_views_title() { "Save the views", "Enregistrer les vues" }
    /// The title of a dialog.
    save_picture_title(view) { "Save the picture of {view}", "Enregistrer l'image de {view}" }
    /// The title of a dialog.
    export_title(what) { "Export: {what}", "Exporter : {what}" }
    /// What is asked before an export that loses something.
    losses_title(format) { "{format} cannot hold everything", "{format} ne peut pas tout contenir" }
    /// What is lost, before the list.
    losses_text() {
        "The exported file will differ from this document in what follows. The document itself stays as it is.",
        "Le fichier exporté différera de ce document sur les points suivants. Le document lui-même reste tel quel.",
    }
    /// Goes on with the export.
    export() { "Export…", "Exporter…" }
    /// The title of a dialog.
    add_mesh_title() { "Add a mesh from a file", "Ajouter un maillage depuis un fichier" }
    /// The title of a dialog.
    save_text_title() { "Save the text", "Enregistrer le texte" }
    /// A thing is gone.
    no_such_item() { "it is not there any more", "l'élément n'existe plus" }
    /// A material is in use.
    material_in_use(name, user) {
        "the material {name} is used by {user}",
        "la matière {name} est utilisée par {user}",
    }
    /// The rays and the time of all views.
    totals(rays, time) { "{rays} rays · {time}", "{rays} rayons · {time}" }
    /// Pictures are being computed.
    rendering(views) { "rendering {views}", "calcul de {views}" }
    /// Files may be dropped.
    drop_here() { "Drop a scene, a document of views or a mesh", "Déposez une scène, un document de vues ou un maillage" }

    /// The help of the command line.
    usage() {
        "The interactive editor of lancer: live ray-traced views of one scene.\n\nUsage: lancer-studio [OPTIONS] [SCENE] [VIEWS]...\n\nArguments:\n  [SCENE]     A scene: XML, binary, NFF, or a document of 2009\n  [VIEWS]...  Documents of views; without one the views beside the scene are shown\n\nOptions:\n      --lang <LANG>  The language: en or fr\n  -h, --help         Print this help\n  -V, --version      Print the version\n\nEnvironment:\n  LANCER_SIMD  portable, avx2 or avx512: the instructions of the engine; otherwise the best that the machine has",
        "L'éditeur interactif de lancer : des vues d'une scène, calculées en direct par lancer de rayon.\n\nUsage : lancer-studio [OPTIONS] [SCÈNE] [VUES]...\n\nArguments :\n  [SCÈNE]    Une scène : XML, binaire, NFF, ou un document de 2009\n  [VUES]...  Des documents de vues ; sans eux, les vues à côté de la scène sont affichées\n\nOptions :\n      --lang <LANGUE>  La langue : en ou fr\n  -h, --help           Afficher cette aide\n  -V, --version        Afficher la version\n\nEnvironnement :\n  LANCER_SIMD  portable, avx2 ou avx512 : les instructions du moteur ; sinon les meilleures de la machine",
    }
    /// An argument that does not exist.
    wrong_argument(argument) {
        "lancer-studio does not know the argument {argument}: lancer-studio --help lists what it knows.",
        "lancer-studio ne connaît pas l'argument {argument} : lancer-studio --help donne ceux qu'il connaît.",
    }
    /// No system library.
    missing_library(library, package) {
        "lancer-studio needs the library {library}, which is not on this machine: install it, on Debian or Ubuntu with «apt install {package}». The command line program lancer works without it.",
        "lancer-studio a besoin de la bibliothèque {library}, absente de cette machine : installez-la, sous Debian ou Ubuntu avec «apt install {package}». Le programme lancer en ligne de commande s'en passe.",
    }
    /// No descriptions of keyboards.
    no_keyboard_layouts() {
        "lancer-studio needs the keyboard layouts of X11 (/usr/share/X11/xkb), which are not on this machine: install them, on Debian or Ubuntu with «apt install xkb-data». The command line program lancer works without them.",
        "lancer-studio a besoin des dispositions de clavier de X11 (/usr/share/X11/xkb), absentes de cette machine : installez-les, sous Debian ou Ubuntu avec «apt install xkb-data». Le programme lancer en ligne de commande s'en passe.",
    }
    /// No display.
    no_display() {
        "lancer-studio needs a graphical session, but neither DISPLAY nor WAYLAND_DISPLAY is set: start it from a desktop, or use the command line program lancer.",
        "lancer-studio a besoin d'une session graphique, mais ni DISPLAY ni WAYLAND_DISPLAY n'est défini : lancez-le depuis un bureau, ou utilisez le programme lancer en ligne de commande.",
    }
    /// The display does not answer.
    no_connection(display) {
        "lancer-studio cannot reach the display {display}: check DISPLAY or WAYLAND_DISPLAY, or use the command line program lancer.",
        "lancer-studio n'atteint pas l'écran {display} : vérifiez DISPLAY ou WAYLAND_DISPLAY, ou utilisez le programme lancer en ligne de commande.",
    }
    /// The window cannot be opened.
    no_window(cause) {
        "lancer-studio cannot open a window with OpenGL: install the graphics driver or Mesa's software OpenGL, on Debian or Ubuntu with «apt install libgl1» ({cause}).",
        "lancer-studio ne peut pas ouvrir de fenêtre OpenGL : installez le pilote graphique ou l'OpenGL logiciel de Mesa, sous Debian ou Ubuntu avec «apt install libgl1» ({cause}).",
    }
}

/// How long ago something was.
pub fn ago(lang: crate::Lang, age: std::time::Duration) -> String {
    let minutes = age.as_secs() / 60;
    match minutes {
        0..60 => minutes_ago(lang, minutes),
        60..2880 => hours_ago(lang, minutes / 60),
        _ => days_ago(lang, minutes / 1440),
    }
}
