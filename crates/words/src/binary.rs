//! What the reader of binary scenes says.

phrases! {
    not_binary_scene() {
        "this is no binary scene of lancer",
        "ce n'est pas une scène binaire de lancer",
    }
    not_binary_scene_help() {
        "a `.lancer` file begins with the signature that `lancer convert` writes",
        "un fichier « .lancer » commence par la signature qu'écrit « lancer convert »",
    }
    transferred_as_text() {
        "the file was damaged by a transfer that took it for text",
        "le fichier a été abîmé par un transfert qui l'a pris pour du texte",
    }
    transferred_as_text_help() {
        "copy it again in binary mode (for git: `*.lancer binary` in .gitattributes)",
        "recopiez-le en mode binaire (pour git : « *.lancer binary » dans .gitattributes)",
    }
    cut(found, expected) {
        "the file is cut: {found} of its {expected} bytes are there",
        "le fichier est tronqué : {found} de ses {expected} octets sont là",
    }
    cut_in_header(found) {
        "the file is cut after {found} bytes, within its header",
        "le fichier est tronqué après {found} octets, dans son en-tête",
    }
    too_long(found, expected) {
        "the file has {found} bytes, but says that it has {expected}",
        "le fichier a {found} octets, mais il en annonce {expected}",
    }
    damaged() {
        "the file is damaged: its checksum does not match its content",
        "le fichier est abîmé : sa somme de contrôle ne correspond pas à son contenu",
    }
    copy_again_help() {
        "copy or save it again; nothing of it was read, because a part may be wrong unnoticed",
        "recopiez-le ou enregistrez-le de nouveau ; rien n'en a été lu, car une partie pourrait être fausse sans qu'on le voie",
    }
    newer_version(found, known) {
        "this file needs a newer lancer: it has version {found}, and this program reads up to version {known}",
        "ce fichier demande un lancer plus récent : il est en version {found}, et ce programme lit jusqu'à la version {known}",
    }
    newer_version_help() {
        "update lancer, or have the program that wrote the file save it as XML",
        "mettez lancer à jour, ou enregistrez la scène en XML avec le programme qui a écrit le fichier",
    }
    unknown_version(found) {
        "there is no version {found} of the format",
        "il n'existe pas de version {found} du format",
    }
    malformed(detail) {
        "the content is no scene: {detail}",
        "le contenu n'est pas une scène : {detail}",
    }
    other_program_help() {
        "the checksum is right, so the program that wrote the file is wrong; save the scene with lancer",
        "la somme de contrôle est juste : c'est le programme qui a écrit le fichier qui se trompe ; enregistrez la scène avec lancer",
    }
    invalid_part(name, rule) {
        "`{name}`: {rule}",
        "« {name} » : {rule}",
    }
}
