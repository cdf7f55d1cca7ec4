//! Everything that can keep the program from doing what it was asked to: its exit code, its sentence and the way out.
//! It is handled once, where the program ends.

use crate::Exit;
use lancer_formats::Describe;
use lancer_formats::load::LoadError;
use lancer_formats::picture::UnknownExtension;
use lancer_formats::save::{SaveCause, SaveError};
use lancer_formats::xml::XmlProblem;
use lancer_render::{PixelFault, Region, RenderError, SimdError, Tracing};
use lancer_scene::generate::Family;
use lancer_scene::{Invalid, Name, View};
use lancer_trace::Simd;
use lancer_words::Lang;
use lancer_words::cli::{self as words, usage};
use lancer_words::{engine, export, number};
use std::path::PathBuf;

/// Why the program ends early.
#[derive(Debug)]
pub(crate) enum Failure {
    /// Everything there is to say was said.
    Told(Exit),
    /// The program was asked to stop.
    Interrupted,
    /// A file or standard input cannot be read.
    Load(LoadError),
    /// A file or standard output cannot be written.
    Save(SaveError),
    /// The handlers of signals cannot be set.
    Signals(String),
    /// The environment asks for instructions that are not there.
    Simd(SimdError),
    /// Adaptive samples of a view of one sample a pixel.
    AdaptiveOfOne {
        /// The view.
        view: Name,
    },
    /// The extension of an output means no format.
    UnknownExtension(UnknownExtension),
    /// Several pictures cannot go to standard output.
    AllViewsToStdout,
    /// Two files cannot both come from standard input.
    StdinTwice,
    /// A picture was asked for, but the input is a document.
    NeedsRendering {
        /// The picture.
        path: PathBuf,
    },
    /// A name that does not say which format to write.
    UnknownForm {
        /// The name.
        path: PathBuf,
    },
    /// Views have no binary form.
    ViewsAsBinary,
    /// A form with a camera, and no views.
    NeedsViews {
        /// What was to be written.
        path: PathBuf,
        /// Where views were looked for.
        beside: PathBuf,
    },
    /// A form that holds objects, and the input is views.
    NeedsScene {
        /// What was to be written.
        path: PathBuf,
    },
    /// Two files cannot go to standard output.
    ObjToStdout,
    /// A generated scene of a size that its family does not have.
    BadFamilySize {
        /// The family.
        family: Family,
    },
    /// A document without a view.
    NoView {
        /// The document.
        path: PathBuf,
    },
    /// No view has that name.
    UnknownView {
        /// The name that was asked for.
        name: String,
        /// The document.
        path: PathBuf,
        /// The names that are most like it, the likest first.
        nearest: Vec<Name>,
        /// How many views there are.
        count: usize,
    },
    /// A view breaks a rule once the command line has changed it.
    ViewInvalid {
        /// The view.
        view: Name,
        /// The rule.
        rule: Invalid,
    },
    /// The region leaves the picture.
    RegionOutside {
        /// The region.
        region: Region,
        /// The picture.
        picture: PictureOf,
    },
    /// The pixel lies outside the picture.
    PixelOutside {
        /// Its column.
        x: u32,
        /// Its row.
        y: u32,
        /// The picture.
        picture: PictureOf,
    },
    /// Two views would be written to one file.
    SameOutput {
        /// The views.
        views: [Name; 2],
        /// The file.
        path: PathBuf,
    },
    /// A pixel has no colour.
    Pixel {
        /// The view.
        view: Name,
        /// Its column.
        x: u32,
        /// Its row.
        y: u32,
        /// Why.
        fault: PixelFault,
    },
    /// The picture does not fit into memory.
    Memory {
        /// Its columns.
        width: u32,
        /// Its rows.
        height: u32,
    },
    /// The threads cannot be started.
    Threads(String),
}

/// A picture by its view and size.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct PictureOf {
    view: Name,
    width: u32,
    height: u32,
}

impl PictureOf {
    /// The picture of a view.
    pub(crate) fn new(view: &View) -> PictureOf {
        PictureOf { view: view.name.clone(), width: view.width, height: view.height }
    }

    /// Its size, in words.
    fn size(&self, lang: Lang) -> String {
        let PictureOf { view, width, height } = self;
        words::picture_size(lang, view, width, height, width - 1, height - 1)
    }
}

impl Failure {
    /// What keeps a view from being rendered.
    pub(crate) fn render(error: RenderError, view: &View) -> Failure {
        match error {
            RenderError::Cancelled => Failure::Interrupted,
            RenderError::View(rule) => Failure::ViewInvalid { view: view.name.clone(), rule },
            RenderError::Region { region, .. } => Failure::RegionOutside { region, picture: PictureOf::new(view) },
            RenderError::Memory { width, height } => Failure::Memory { width, height },
            RenderError::Threads { reason } => Failure::Threads(reason),
            RenderError::Pixel { x, y, fault } => Failure::Pixel { view: view.name.clone(), x, y, fault },
        }
    }

    /// A file that could not be written, in the writer's words.
    pub(crate) fn cannot_write(path: &std::path::Path, error: &std::io::Error) -> Failure {
        Failure::Save(SaveError { path: path.to_owned(), cause: SaveCause::Other(error.to_string()) })
    }

    /// How the program ends (DESIGN §3.6). What the command line alone shows to be wrong is 2; what only shows beside
    /// the documents is 1.
    pub(crate) fn exit(&self) -> Exit {
        match self {
            Failure::Told(exit) => *exit,
            Failure::Interrupted => Exit::Interrupted,
            Failure::Simd(_)
            | Failure::UnknownExtension(_)
            | Failure::AllViewsToStdout
            | Failure::StdinTwice
            | Failure::ObjToStdout
            | Failure::BadFamilySize { .. }
            | Failure::UnknownForm { .. } => Exit::Usage,
            Failure::AdaptiveOfOne { .. }
            | Failure::NeedsRendering { .. }
            | Failure::ViewsAsBinary
            | Failure::NeedsViews { .. }
            | Failure::NeedsScene { .. }
            | Failure::NoView { .. }
            | Failure::UnknownView { .. }
            | Failure::ViewInvalid { .. }
            | Failure::RegionOutside { .. }
            | Failure::PixelOutside { .. }
            | Failure::SameOutput { .. }
            | Failure::Pixel { .. } => Exit::Wrong,
            Failure::Load(_)
            | Failure::Save(_)
            | Failure::Signals(_)
            | Failure::Memory { .. }
            | Failure::Threads(_) => Exit::System,
        }
    }

    /// What is wrong; `None` if nothing more is to be said.
    pub(crate) fn message(&self, lang: Lang) -> Option<String> {
        Some(match self {
            Failure::Told(_) | Failure::Interrupted => return None,
            Failure::Load(error) => error.message(lang),
            Failure::Save(error) => error.message(lang),
            Failure::Signals(reason) => words::no_signals(lang, reason),
            Failure::Simd(SimdError::Unknown { name }) => engine::unknown_simd(lang, Tracing::VARIABLE, name),
            Failure::Simd(SimdError::Missing { simd }) => engine::missing_simd(lang, Tracing::VARIABLE, simd.name()),
            Failure::AdaptiveOfOne { view } => words::adaptive_of_one(lang, view),
            Failure::UnknownExtension(error) => error.message(lang),
            Failure::AllViewsToStdout => usage::all_views_to_stdout(lang),
            Failure::StdinTwice => usage::stdin_twice(lang),
            Failure::NeedsRendering { path } => words::convert_needs_rendering(lang, path.display()),
            Failure::UnknownForm { path } => words::convert_unknown(lang, path.display()),
            Failure::ViewsAsBinary => words::convert_views_binary(lang),
            Failure::NeedsViews { path, .. } => export::needs_views(lang, path.display()),
            Failure::NeedsScene { path } => export::needs_scene(lang, path.display()),
            Failure::ObjToStdout => export::no_stdout(lang),
            Failure::BadFamilySize { family } => {
                words::bench::bad_size_of(lang, family.word(), family.sizes().start(), family.sizes().end())
            }
            Failure::NoView { path } => words::no_view(lang, path.display()),
            Failure::UnknownView { name, path, .. } => words::unknown_view(lang, name, path.display()),
            Failure::ViewInvalid { view, rule } => {
                words::view_invalid(lang, view, XmlProblem::Rule(rule.clone()).message(lang))
            }
            Failure::RegionOutside { region: Region { x, y, width, height }, .. } => {
                words::region_outside(lang, x, y, width, height)
            }
            Failure::PixelOutside { x, y, .. } => words::pixel_outside(lang, x, y),
            Failure::SameOutput { views: [first, second], path } => {
                words::same_output(lang, first, second, path.display())
            }
            Failure::Pixel { view, x, y, fault: PixelFault::Budget { limit } } => {
                let rays = number::rays(lang, usize::try_from(*limit).unwrap_or(usize::MAX));
                words::budget(lang, view, x, y, rays)
            }
            Failure::Pixel { view, x, y, fault: PixelFault::NotFinite } => words::not_finite(lang, view, x, y),
            Failure::Memory { width, height } => words::no_memory(lang, width, height),
            Failure::Threads(reason) => words::no_threads(lang, reason),
        })
    }

    /// The rule or the way out.
    pub(crate) fn help(&self, lang: Lang) -> Option<String> {
        match self {
            Failure::Load(error) => error.help(lang),
            Failure::Save(error) => error.help(lang),
            Failure::Told(_)
            | Failure::Interrupted
            | Failure::Signals(_)
            | Failure::UnknownExtension(_)
            | Failure::AllViewsToStdout
            | Failure::StdinTwice
            | Failure::ObjToStdout
            | Failure::BadFamilySize { .. }
            | Failure::NoView { .. } => None,
            Failure::Simd(_) => {
                let available = Simd::ALL.into_iter().filter(|simd| simd.is_available()).map(Simd::name);
                Some(engine::available_simd(lang, available.collect::<Vec<_>>().join(", ")))
            }
            Failure::AdaptiveOfOne { .. } => Some(words::adaptive_of_one_help(lang)),
            Failure::ViewInvalid { rule, .. } => XmlProblem::Rule(rule.clone()).help(lang),
            Failure::NeedsRendering { .. } => Some(words::convert_needs_rendering_help(lang)),
            Failure::UnknownForm { .. } => Some(words::convert_unknown_help(lang)),
            Failure::NeedsViews { beside, .. } => Some(export::needs_views_help(lang, beside.display())),
            Failure::NeedsScene { .. } => Some(export::needs_scene_help(lang)),
            Failure::ViewsAsBinary => Some(words::convert_views_binary_help(lang)),
            Failure::UnknownView { nearest, count, .. } => {
                let names: Vec<String> = nearest.iter().map(|name| words::quoted(lang, name)).collect();
                Some(match nearest.len() == *count {
                    true => words::known_views(lang, names.join(", ")),
                    false => words::nearest_views(lang, names.join(", "), count),
                })
            }
            Failure::RegionOutside { picture, .. } | Failure::PixelOutside { picture, .. } => Some(picture.size(lang)),
            Failure::SameOutput { .. } => Some(words::same_output_help(lang)),
            Failure::Pixel { fault: PixelFault::Budget { .. }, .. } => Some(words::budget_help(lang)),
            Failure::Pixel { fault: PixelFault::NotFinite, .. } => Some(words::not_finite_help(lang)),
            Failure::Memory { .. } => Some(words::no_memory_help(lang)),
            Failure::Threads(_) => Some(words::no_threads_help(lang)),
        }
    }
}
