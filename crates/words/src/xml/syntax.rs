//! What is said of a text that is no well-formed XML.

reports! {
    /// The file has no bytes.
    empty_file() {
        "the file is empty", "", "a scene begins with `<scene version=\"1\">`, a view with `<views version=\"1\">`";
        "le fichier est vide", "",
        "une scène commence par « <scene version=\"1\"> », une vue par « <views version=\"1\"> »";
    }
    /// More bytes than offsets can count.
    too_large() {
        "the file is larger than 4 GiB", "", "keep large meshes in files of their own: `<mesh src=\"rabbit.ply\"/>`";
        "le fichier dépasse 4 Gio", "",
        "gardez les grands maillages dans leurs propres fichiers : « <mesh src=\"rabbit.ply\"/> »";
    }
    /// An encoding that is not read.
    unknown_encoding(label) {
        "the encoding `{label}` is not read here", "declared here",
        "save the file as UTF-8 and declare `encoding=\"UTF-8\"`; ISO-8859-1, Windows-1252 and UTF-16 are read too";
        "le codage « {label} » n'est pas lu ici", "déclaré ici",
        "enregistrez le fichier en UTF-8 et déclarez « encoding=\"UTF-8\" » ; ISO-8859-1, Windows-1252 et UTF-16 sont lus aussi";
    }
    /// Bytes that the encoding does not have.
    bad_bytes(byte, encoding) {
        "the byte {byte} has no meaning here in {encoding}", "the text is not legible from here on",
        "save the file as UTF-8, or declare how it was saved, often `<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?>`";
        "l'octet {byte} n'a pas de sens ici en {encoding}", "le texte devient illisible ici",
        "enregistrez le fichier en UTF-8, ou déclarez son codage, souvent « <?xml version=\"1.0\" encoding=\"ISO-8859-1\"?> »";
    }
    /// The mark says one encoding, the declaration another.
    encoding_contradicted(declared, actual) {
        "the file is declared as {declared}, but its bytes are {actual}", "declared here",
        "declare `encoding=\"{actual}\"`, or take the encoding out of the declaration";
        "le fichier se déclare en {declared}, mais ses octets sont en {actual}", "déclaré ici",
        "déclarez « encoding=\"{actual}\" », ou ôtez le codage de la déclaration";
    }
    /// UTF-16 whose byte order only a mark could tell.
    no_byte_order_mark() {
        "the file looks like UTF-16, but has no byte order mark", "",
        "save it with a byte order mark (BOM), or as UTF-8";
        "le fichier semble être en UTF-16, mais n'a pas de marque d'ordre des octets", "",
        "enregistrez-le avec cette marque (BOM), ou en UTF-8";
    }
    /// A character that no XML document may hold.
    illegal_character(code) {
        "the character {code} must not stand in an XML document", "",
        "take it out; of the control characters only tab and line ends are legal";
        "le caractère {code} est interdit dans un document XML", "",
        "ôtez-le ; des caractères de contrôle, seuls la tabulation et les fins de ligne sont permis";
    }
    /// The XML declaration is malformed.
    bad_declaration() {
        "the XML declaration is malformed", "",
        "a document begins with `<?xml version=\"1.0\" encoding=\"UTF-8\"?>`, or without a declaration";
        "la déclaration XML est mal formée", "",
        "un document commence par « <?xml version=\"1.0\" encoding=\"UTF-8\"?> », ou sans déclaration";
    }
    /// A version of XML that is not read.
    unknown_xml_version(version) {
        "XML {version} is not read here", "declared here", "declare `version=\"1.0\"`";
        "XML {version} n'est pas lu ici", "déclaré ici", "déclarez « version=\"1.0\" »";
    }
    /// The XML declaration stands elsewhere than at the very beginning.
    late_declaration() {
        "the XML declaration must be the first thing in the file", "something stands before it",
        "take out what stands before it, blanks and empty lines too";
        "la déclaration XML doit être en tête du fichier", "quelque chose la précède",
        "ôtez ce qui la précède, y compris les blancs et les lignes vides";
    }
    /// A DOCTYPE with an internal subset.
    internal_subset() {
        "a DOCTYPE with declarations of its own is refused", "the declarations begin here",
        "take out the part within `[` and `]`; a DOCTYPE that only names a file is allowed, and never fetched";
        "un DOCTYPE qui contient ses propres déclarations est refusé", "les déclarations commencent ici",
        "ôtez la partie entre « [ » et « ] » ; un DOCTYPE qui ne fait que nommer un fichier est toléré, sans jamais être lu";
    }
    /// A malformed DOCTYPE.
    bad_doctype() {
        "this DOCTYPE is malformed", "", "take it out: no document needs one";
        "ce DOCTYPE est mal formé", "", "ôtez-le : aucun document n'en a besoin";
    }
    /// A DOCTYPE where none may stand.
    misplaced_doctype() {
        "a DOCTYPE may only stand once, before the first element", "", "take it out: no document needs one";
        "un DOCTYPE ne peut figurer qu'une fois, avant le premier élément", "",
        "ôtez-le : aucun document n'en a besoin";
    }
    /// Something that begins with `<!` and is nothing known.
    unknown_markup() {
        "`<!` begins neither a comment nor anything else known", "", "a comment is written `<!-- like this -->`";
        "« <! » ne commence ni un commentaire ni rien de connu", "",
        "un commentaire s'écrit « <!-- ainsi --> »";
    }
    /// `<` without a name.
    tag_without_name() {
        "a `<` begins a tag, but no name follows it", "",
        "to mean the character itself, write `&lt;`; a name follows `<` at once, without a blank";
        "« < » commence une balise, mais aucun nom ne suit", "",
        "pour le caractère lui-même, écrivez « &lt; » ; un nom suit « < » aussitôt, sans blanc";
    }
    /// A tag that is not ended.
    tag_not_ended(name) {
        "the tag `<{name}` has no end", "it begins here", "a tag ends with `>`, or with `/>` where nothing stands within";
        "la balise « <{name} » n'a pas de fin", "elle commence ici",
        "une balise finit par « > », ou par « /> » quand rien n'est contenu";
    }
    /// The file ends within a tag.
    ends_within_tag(name) {
        "the file ends in the middle of the tag `<{name}`", "it begins here", "is the file cut short? A tag ends with `>` or `/>`";
        "le fichier finit au milieu de la balise « <{name} »", "elle commence ici",
        "le fichier est-il tronqué ? Une balise finit par « > » ou « /> »";
    }
    /// A stray character within a tag.
    stray_in_tag(found, name) {
        "`{found}` must not stand here in the tag `<{name}`", "",
        "within a tag stand only attributes such as `radius=\"0.5\"`, with blanks between them";
        "« {found} » n'a rien à faire ici dans la balise « <{name} »", "",
        "une balise ne contient que des attributs comme « radius=\"0.5\" », séparés par des blancs";
    }
    /// Two attributes without white space between them.
    attributes_touch(name) {
        "a blank is missing before the attribute `{name}`", "", "write `a=\"1\" b=\"2\"`, not `a=\"1\"b=\"2\"`";
        "il manque un blanc avant l'attribut « {name} »", "", "écrivez « a=\"1\" b=\"2\" », et non « a=\"1\"b=\"2\" »";
    }
    /// An attribute without a value.
    attribute_without_value(name) {
        "the attribute `{name}` has no value", "`=` and a value are missing after it", "write `{name}=\"…\"`";
        "l'attribut « {name} » n'a pas de valeur", "« = » et une valeur manquent après", "écrivez « {name}=\"…\" »";
    }
    /// A value without quotes.
    value_without_quotes(name, value) {
        "the value of `{name}` needs quotes", "", "write `{name}=\"{value}\"`";
        "la valeur de « {name} » demande des guillemets", "", "écrivez « {name}=\"{value}\" »";
    }
    /// A value whose closing quote is missing.
    value_not_ended(name, quote) {
        "the value of `{name}` is not closed", "the value begins here",
        "a closing `{quote}` is missing; for the character `<` within a value write `&lt;`";
        "la valeur de « {name} » n'est pas fermée", "la valeur commence ici",
        "il manque un « {quote} » fermant ; pour le caractère « < » dans une valeur, écrivez « &lt; »";
    }
    /// An attribute that stands twice in one tag.
    duplicate_attribute(name, element, line) {
        "the attribute `{name}` stands twice in `<{element}>`", "the second one; the first stands on line {line}",
        "keep one of them";
        "l'attribut « {name} » figure deux fois dans « <{element}> »", "le second ; le premier est à la ligne {line}",
        "n'en gardez qu'un";
    }
    /// An end tag that does not fit the open element.
    mismatched_end(found, open, line) {
        "`</{found}>` stands where `</{open}>` is due", "this closes nothing that is open",
        "`<{open}>` of line {line} is still open: close it first, with `</{open}>`";
        "« </{found}> » figure là où « </{open}> » est attendu", "ceci ne ferme rien d'ouvert",
        "« <{open}> » de la ligne {line} est encore ouvert : fermez-le d'abord, par « </{open}> »";
    }
    /// An end tag of an element further out than the open one.
    outer_end(found, open, line) {
        "`</{found}>` stands where `</{open}>` is due", "`<{open}>` of line {line} is still open",
        "close it first, with `</{open}>`, or write `<{open} …/>` if nothing stands within it";
        "« </{found}> » figure là où « </{open}> » est attendu", "« <{open}> » de la ligne {line} est encore ouvert",
        "fermez-le d'abord, par « </{open}> », ou écrivez « <{open} …/> » s'il ne contient rien";
    }
    /// An end tag with nothing open.
    end_without_start(name) {
        "`</{name}>` closes nothing", "", "take it out, or write the `<{name}>` that it should close";
        "« </{name}> » ne ferme rien", "", "ôtez-la, ou écrivez le « <{name}> » qu'elle devrait fermer";
    }
    /// A malformed end tag.
    bad_end_tag() {
        "this end tag is malformed", "", "an end tag is `</`, the name, and `>`";
        "cette balise fermante est mal formée", "", "une balise fermante est « </ », le nom, puis « > »";
    }
    /// An element that is open where the file ends.
    element_not_closed(name, line) {
        "`<{name}>` is never closed", "it is opened here",
        "write `</{name}>` where it ends; the file ends on line {line}: is it cut short?";
        "« <{name}> » n'est jamais fermé", "il s'ouvre ici",
        "écrivez « </{name}> » là où il finit ; le fichier finit à la ligne {line} : est-il tronqué ?";
    }
    /// Text outside the root element.
    text_outside() {
        "this text stands outside the document's element", "",
        "only comments may stand before and after the one element that holds everything";
        "ce texte est hors de l'élément du document", "",
        "seuls des commentaires peuvent précéder et suivre l'élément unique qui contient tout";
    }
    /// The file begins with something that is no XML.
    not_xml() {
        "this is not an XML document", "a `<` is due here",
        "a scene begins with `<scene version=\"1\">`, a view with `<views version=\"1\">`";
        "ceci n'est pas un document XML", "un « < » est attendu ici",
        "une scène commence par « <scene version=\"1\"> », une vue par « <views version=\"1\"> »";
    }
    /// A second root element.
    second_root(name) {
        "a second element, `<{name}>`, stands beside the document's own", "",
        "one element holds everything: put this within it, or into a file of its own";
        "un second élément, « <{name}> », figure à côté de celui du document", "",
        "un seul élément contient tout : placez celui-ci dedans, ou dans son propre fichier";
    }
    /// No root element at all.
    no_root() {
        "the document has no element", "",
        "a scene begins with `<scene version=\"1\">`, a view with `<views version=\"1\">`";
        "le document n'a aucun élément", "",
        "une scène commence par « <scene version=\"1\"> », une vue par « <views version=\"1\"> »";
    }
    /// A comment without an end.
    comment_not_ended() {
        "this comment has no end", "it begins here", "a comment ends with `-->`";
        "ce commentaire n'a pas de fin", "il commence ici", "un commentaire finit par « --> »";
    }
    /// `--` within a comment.
    double_dash() {
        "`--` must not stand within a comment", "", "write one dash, or end the comment with `-->`";
        "« -- » est interdit dans un commentaire", "", "écrivez un seul tiret, ou finissez le commentaire par « --> »";
    }
    /// A CDATA section without an end.
    cdata_not_ended() {
        "this CDATA section has no end", "it begins here", "a CDATA section ends with `]]>`";
        "cette section CDATA n'a pas de fin", "elle commence ici", "une section CDATA finit par « ]]> »";
    }
    /// `]]>` in text.
    stray_cdata_end() {
        "`]]>` must not stand in text", "", "write `]]&gt;`";
        "« ]]> » est interdit dans du texte", "", "écrivez « ]]&gt; »";
    }
    /// A malformed or endless processing instruction.
    bad_instruction() {
        "this processing instruction is malformed", "it begins here", "one is written `<?name …?>`; no document needs one";
        "cette instruction de traitement est mal formée", "elle commence ici",
        "elle s'écrit « <?nom …?> » ; aucun document n'en a besoin";
    }
    /// `&` that begins no reference.
    bare_ampersand() {
        "a lone `&` must be written `&amp;`", "", "write `&amp;` for the character `&`";
        "un « & » seul doit s'écrire « &amp; »", "", "écrivez « &amp; » pour le caractère « & »";
    }
    /// An entity that is not predefined.
    unknown_entity(name) {
        "there is no entity `&{name};`", "",
        "only `&lt;` `&gt;` `&amp;` `&quot;` `&apos;` and numbers such as `&#233;` are known: write the character itself";
        "il n'y a pas d'entité « &{name}; »", "",
        "seuls « &lt; » « &gt; » « &amp; » « &quot; » « &apos; » et des numéros comme « &#233; » sont connus : écrivez le caractère lui-même";
    }
    /// A numeric reference that names no legal character.
    bad_character_reference(reference) {
        "`{reference}` names no character that a document may hold", "", "write the character itself";
        "« {reference} » ne désigne aucun caractère permis dans un document", "", "écrivez le caractère lui-même";
    }
    /// Elements within elements, too deep.
    too_deep(limit) {
        "the elements are nested more than {limit} deep", "",
        "no legal document nests more than four deep: an end tag is probably missing further up";
        "les éléments sont imbriqués sur plus de {limit} niveaux", "",
        "aucun document légal n'en imbrique plus de quatre : il manque sans doute une balise fermante plus haut";
    }
    /// A name that is no XML name.
    bad_name() {
        "this is not a legal name", "", "a name begins with a letter and holds letters, digits, `-`, `_` and `.`";
        "ce nom est illégal", "", "un nom commence par une lettre et contient des lettres, chiffres, « - », « _ » et « . »";
    }
}
