//! Reading documents and pictures for the commands: what is wrong with them is told, and only what is right is given.

use crate::console::{Console, Stream};
use crate::{Exit, Failure, report};
use lancer_formats::load::{self, LoadOptions, Loaded, STANDARD};
use lancer_formats::xml::{self, Element, StructureProblem, XmlProblem};
use lancer_formats::{Diagnostic, Problem, Severity, Source, Span};
use lancer_scene::{Finding, NameKind, Picture, Scene, View, Views, Weight, lint};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// How many names are offered instead of an unknown one.
const NEAREST: usize = 5;

/// A legal scene and legal views, with the documents that they come from.
#[derive(Debug)]
pub(crate) struct Stage {
    /// The scene.
    pub(crate) scene: Scene,
    /// The views.
    pub(crate) views: Views,
    documents: [Document; 2],
}

/// Reads a scene and views. What is wrong with either is told.
///
/// # Errors
/// Both from standard input; a file that cannot be read; a document with errors.
pub(crate) fn stage(scene: &Path, views: &Path, options: &LoadOptions, console: &Console) -> Result<Stage, Failure> {
    read_once(scene, views)?;
    let read_scene = load::load_scene(scene, options).map_err(Failure::Load);
    let scene = read_scene.and_then(|loaded| legal(scene, loaded, Content::Scene, console));
    let read_views = load::load_views(views, options).map_err(Failure::Load);
    let views = read_views.and_then(|loaded| legal(views, loaded, Content::Views, console));
    match (scene, views) {
        (Ok((scene, scene_document)), Ok((views, views_document))) => {
            Ok(Stage { scene, views, documents: [scene_document, views_document] })
        }
        (Err(failure), Ok(_)) | (Ok(_), Err(failure)) => Err(failure),
        (Err(first), Err(second)) => Err(Failure::Told(console.fail(&first).max(console.fail(&second)))),
    }
}

/// Two files that are not both standard input.
///
/// # Errors
/// [`Failure::StdinTwice`].
pub(crate) fn read_once(first: &Path, second: &Path) -> Result<(), Failure> {
    if [first, second].iter().all(|path| *path == Path::new(STANDARD)) { Err(Failure::StdinTwice) } else { Ok(()) }
}

/// The value of what was loaded, and its document. What was found is told.
fn legal<T: Clone>(
    path: &Path,
    loaded: Loaded<T>,
    content: impl FnOnce(T) -> Content,
    console: &Console,
) -> Result<(T, Document), Failure> {
    let value = loaded.value.clone();
    let document = Document::of(path, loaded, content);
    tell(&document.source, &document.diagnostics, console);
    match (value, &document.content) {
        (Some(value), Some(_)) => Ok((value, document)),
        (Some(_) | None, _) => Err(Failure::Told(Exit::Wrong)),
    }
}

impl Stage {
    /// Tells what is hardly meant in the pictures of some views, unless the console is quiet.
    pub(crate) fn warn(&self, shown: &[Arc<View>], console: &Console) {
        let [scene, views] = &self.documents;
        let found = findings(&self.scene, shown, scene, &[views]);
        let warnings = found.into_iter().filter(|(finding, ..)| finding.weight() == Weight::Warning);
        for (finding, owner, span) in warnings {
            let document = owner.map_or(scene, |_| views);
            tell(&document.source, &[Diagnostic::warning(span, finding)], console);
        }
    }
}

/// What lint finds in a scene and views of it: each finding with the document that it is about (the number of a
/// document of views, or nothing for the scene's), and its place there. What a document says itself is left out.
pub(crate) fn findings(
    scene: &Scene,
    shown: &[Arc<View>],
    scene_document: &Document,
    view_documents: &[&Document],
) -> Vec<(Finding, Option<usize>, Option<Span>)> {
    let placed = |finding: Finding| {
        let view = finding.names().into_iter().find(|(kind, _)| *kind == NameKind::View).map(|(_, name)| name);
        let holds = |document: &&Document| document.views().iter().any(|other| Some(&other.name) == view);
        let owner = view_documents.iter().position(holds);
        let document = owner.map_or(scene_document, |owner| view_documents[owner]);
        let span = document.place_of(&finding);
        (!document.says(&finding)).then_some((finding, owner, span))
    };
    lint(scene, shown).into_iter().filter_map(placed).collect()
}

/// Views.
///
/// # Errors
/// A file that cannot be read; one with errors, which are told.
pub(crate) fn views(path: &Path, options: &LoadOptions, console: &Console) -> Result<Views, Failure> {
    accepted(load::load_views(path, options).map_err(Failure::Load)?, console)
}

/// A picture.
///
/// # Errors
/// A file that cannot be read; one that is no picture, which is told.
pub(crate) fn picture(path: &Path, console: &Console) -> Result<Picture, Failure> {
    accepted(load::load_picture(path, &LoadOptions::default()).map_err(Failure::Load)?, console)
}

/// The value of what was loaded. Errors are told, and warnings unless the console is quiet.
fn accepted<T>(loaded: Loaded<T>, console: &Console) -> Result<T, Failure> {
    let errors = loaded.has_errors();
    tell(&loaded.source, &loaded.diagnostics, console);
    loaded.value.filter(|_| !errors).ok_or(Failure::Told(Exit::Wrong))
}

/// Tells errors, and warnings unless the console is quiet.
pub(crate) fn tell(source: &Source, diagnostics: &[Diagnostic], console: &Console) {
    let told = |found: &&Diagnostic| found.severity == Severity::Error || !console.quiet;
    let diagnostics: Vec<Diagnostic> = diagnostics.iter().filter(told).cloned().collect();
    if !diagnostics.is_empty() {
        console.tell(&reported(source, &diagnostics, console, Stream::Errors));
    }
}

/// The report of diagnostics, as wide and as colourful as the stream allows.
fn reported(source: &Source, diagnostics: &[Diagnostic], console: &Console, stream: Stream) -> String {
    report::render(source, diagnostics, console.lang, stream.has_colors(), stream.width())
}

/// What a document holds.
#[derive(Clone, Debug)]
pub(crate) enum Content {
    /// A scene.
    Scene(Scene),
    /// Views.
    Views(Views),
}

/// A document of either kind, with everything there is to say about it.
#[derive(Debug)]
pub(crate) struct Document {
    /// The path as the user gave it.
    pub(crate) path: PathBuf,
    /// What it holds; `None` if it has errors.
    pub(crate) content: Option<Content>,
    /// What was found.
    pub(crate) diagnostics: Vec<Diagnostic>,
    /// The text that the diagnostics are about.
    pub(crate) source: Source,
    tree: Option<xml::Document>,
}

/// Reads a scene or views, whichever it is.
///
/// # Errors
/// A file that cannot be read.
pub(crate) fn read(path: &Path, options: &LoadOptions) -> Result<Document, Failure> {
    let scene = load::load_scene(path, options).map_err(Failure::Load)?;
    // standard input can be read only once, so views must come from a file here
    if !scene.diagnostics.iter().any(is_views) || path == Path::new(STANDARD) {
        return Ok(Document::of(path, scene, Content::Scene));
    }
    read_views(path, options)
}

/// Reads the views of a file that holds a scene too.
///
/// # Errors
/// A file that cannot be read.
pub(crate) fn read_views(path: &Path, options: &LoadOptions) -> Result<Document, Failure> {
    Ok(Document::of(path, load::load_views(path, options).map_err(Failure::Load)?, Content::Views))
}

/// Whether the reader of scenes says that the document holds views.
fn is_views(diagnostic: &Diagnostic) -> bool {
    matches!(diagnostic.problem, Problem::Xml(XmlProblem::Structure(StructureProblem::ViewsForScene)))
}

impl Document {
    fn of<T>(path: &Path, loaded: Loaded<T>, content: impl FnOnce(T) -> Content) -> Document {
        let errors = loaded.has_errors();
        Document {
            path: path.to_owned(),
            content: loaded.value.filter(|_| !errors).map(content),
            diagnostics: loaded.diagnostics,
            source: loaded.source,
            tree: loaded.document,
        }
    }

    /// What it holds. Errors are told, and warnings unless the console is quiet.
    ///
    /// # Errors
    /// A document with errors.
    pub(crate) fn accepted(self, console: &Console) -> Result<Content, Failure> {
        tell(&self.source, &self.diagnostics, console);
        self.content.ok_or(Failure::Told(Exit::Wrong))
    }

    /// How many diagnostics are of that severity.
    pub(crate) fn count(&self, severity: Severity) -> usize {
        self.diagnostics.iter().filter(|found| found.severity == severity).count()
    }

    /// Its views; none for a scene.
    pub(crate) fn views(&self) -> &[Arc<View>] {
        match &self.content {
            Some(Content::Views(views)) => views,
            Some(Content::Scene(_)) | None => &[],
        }
    }

    /// The report of everything that was found.
    pub(crate) fn report(&self, console: &Console, stream: Stream) -> String {
        reported(&self.source, &self.diagnostics, console, stream)
    }

    /// Whether the document's own diagnostics say the same as a finding.
    fn says(&self, finding: &Finding) -> bool {
        let mirrored = Problem::Xml(XmlProblem::Structure(StructureProblem::MirroredScreen));
        matches!(finding, Finding::MirroredView { .. }) && self.diagnostics.iter().any(|own| own.problem == mirrored)
    }

    /// Where the document names the first thing that a finding is about; `None` for a file without text, and for a
    /// thing without a name of its own.
    pub(crate) fn place_of(&self, finding: &Finding) -> Option<Span> {
        let root = self.tree.as_ref()?.root();
        let holds_views = matches!(self.content, Some(Content::Views(_)));
        let (kind, name) = finding.names().into_iter().find(|(kind, _)| (*kind == NameKind::View) == holds_views)?;
        let elements = || std::iter::once(root).chain(root.elements());
        let fits = |element: &Element<'_>| match kind {
            NameKind::View => element.name() == "view",
            NameKind::Material => element.name() == "material",
            NameKind::ObjectOrLight => !matches!(element.name(), "scene" | "material"),
        };
        elements()
            .filter(fits)
            .filter_map(|element| element.attribute("name"))
            .find_map(|attribute| (attribute.value().trim() == &**name).then_some(attribute.value_span))
    }
}

/// The view of that name, else the first.
///
/// # Errors
/// A document without views; a name that no view has.
pub(crate) fn view<'a>(views: &'a Views, name: Option<&str>, path: &Path) -> Result<&'a Arc<View>, Failure> {
    let Some(name) = name else {
        return views.first().ok_or_else(|| Failure::NoView { path: path.to_owned() });
    };
    views.iter().find(|view| &*view.name == name).ok_or_else(|| {
        let mut nearest: Vec<_> = views.iter().map(|view| view.name.clone()).collect();
        // stable: names that are equally near stay in document order
        nearest.sort_by_key(|candidate| strsim::damerau_levenshtein(candidate, name));
        nearest.truncate(NEAREST);
        Failure::UnknownView { name: name.to_owned(), path: path.to_owned(), nearest, count: views.len() }
    })
}
