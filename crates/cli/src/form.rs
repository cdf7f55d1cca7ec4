//! The formats in which the program writes documents, and the scenes in each of them: with what they cannot hold, and
//! the file that some have beside them.

use crate::documents;
use crate::{Context, Failure, target};
use lancer_formats::export::{self, Container, Loss};
use lancer_formats::n7_2009::{self, N7Problem};
use lancer_formats::{Diagnostic, Source, binary, xml};
use lancer_scene::{Scene, View};
use std::path::{Path, PathBuf};

/// A format that a document can be written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Form {
    /// The native documents.
    Xml,
    /// The binary scenes.
    Binary,
    /// The documents of 2009.
    Of2009,
    /// POV-Ray's scenes, with their camera.
    Povray,
    /// Wavefront objects, with the library of their materials beside them.
    Obj,
    /// glTF 2.0.
    Gltf(Container),
}

/// A document that is ready to be written.
#[derive(Debug)]
pub(crate) struct Written {
    bytes: Vec<u8>,
    losses: Vec<Diagnostic>,
    beside: Vec<(PathBuf, Vec<u8>)>,
}

impl Form {
    /// The form that an extension means, without its dot and whatever its case.
    pub(crate) fn of_extension(extension: &str) -> Option<Form> {
        Some(match extension.to_ascii_lowercase().as_str() {
            "xml" => Form::Xml,
            "lancer" => Form::Binary,
            "pov" => Form::Povray,
            "obj" => Form::Obj,
            "gltf" => Form::Gltf(Container::Text),
            "glb" => Form::Gltf(Container::Binary),
            _ => return None,
        })
    }

    /// The form of a path, by its extension.
    pub(crate) fn of_path(path: &Path) -> Option<Form> {
        Form::of_extension(&path.extension()?.to_string_lossy())
    }

    /// A scene in this form, for a file at `output`. `view` is asked for where the form has a camera.
    ///
    /// # Errors
    /// Those of `view`; two files cannot go to standard output.
    pub(crate) fn of_scene(
        self,
        scene: &Scene,
        output: &Path,
        view: impl FnOnce() -> Result<View, Failure>,
    ) -> Result<Written, Failure> {
        Ok(match self {
            Form::Xml => Written::whole(xml::write_scene(scene).into_bytes()),
            Form::Binary => Written::whole(binary::write_scene(scene)),
            Form::Of2009 => Written::of_2009(n7_2009::write_scene(scene)),
            Form::Povray => {
                let view = view()?;
                let mut bytes = Vec::new();
                export::write_povray(scene, &view, &mut bytes)
                    .map_err(|error| Failure::cannot_write(output, &error))?;
                Written { bytes, losses: told(export::povray_losses(scene, &view)), beside: Vec::new() }
            }
            Form::Obj if target::is_standard(output) => return Err(Failure::ObjToStdout),
            Form::Obj => {
                let library = output.with_extension("mtl");
                let name = library.file_name().unwrap_or_default().to_string_lossy();
                let files = export::write_obj(scene, &name);
                let losses = told(export::obj_losses(scene));
                let beside = vec![(library, files.materials.into_bytes())];
                Written { bytes: files.objects.into_bytes(), losses, beside }
            }
            Form::Gltf(container) => {
                let bytes = export::write_gltf(scene, container);
                Written { bytes, losses: told(export::gltf_losses(scene)), beside: Vec::new() }
            }
        })
    }
}

fn told(losses: Vec<Loss>) -> Vec<Diagnostic> {
    losses.into_iter().map(|loss| Diagnostic::warning(None, loss)).collect()
}

impl Written {
    /// A document that lost nothing.
    pub(crate) fn whole(bytes: Vec<u8>) -> Written {
        Written { bytes, losses: Vec::new(), beside: Vec::new() }
    }

    /// A document of 2009 and what it cannot hold.
    pub(crate) fn of_2009((text, losses): (String, Vec<n7_2009::Loss>)) -> Written {
        let warning = |loss| Diagnostic::warning(None, N7Problem::Loss(loss));
        Written { bytes: text.into_bytes(), losses: losses.into_iter().map(warning).collect(), beside: Vec::new() }
    }

    /// The same with one more file that belongs to it.
    pub(crate) fn and(mut self, path: &Path, bytes: Vec<u8>) -> Written {
        self.beside.push((path.to_owned(), bytes));
        self
    }

    /// Tells what is lost, and writes the file and those beside it: all of them or, where one cannot be written, none.
    ///
    /// # Errors
    /// A file that cannot be written, or the wish to stop.
    pub(crate) fn save(self, output: &Path, context: &Context) -> Result<(), Failure> {
        let source = Source { name: output.display().to_string().into(), text: "".into() };
        documents::tell(&source, &self.losses, &context.console);
        let beside = self.beside.iter().map(|(path, bytes)| (path.as_path(), bytes.as_slice()));
        let files: Vec<_> = beside.chain([(output, self.bytes.as_slice())]).collect();
        target::write_documents(&files, context)
    }
}
