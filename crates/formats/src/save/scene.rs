//! Scenes into files: which writer a name means, and that a document finds its meshes again from where it goes.

use super::{SaveError, is_standard, save};
use crate::load::{FolderOfDocument, LoadOptions};
use crate::mesh::MeshFiles;
use crate::xml::Document;
use crate::{binary, xml};
use lancer_scene::{MaterialRef, Mesh, MeshGeometry, Object, Scene, Shape};
use lancer_words::{Lang, file as words};
use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// The formats in which a scene can be written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum SceneFormat {
    /// The native document.
    Xml,
    /// The binary scene.
    Binary,
}

/// A file name's extension means no scene format.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("no scene format has the extension `.{extension}`")]
pub struct UnknownSceneExtension {
    /// The extension.
    pub extension: String,
}

impl UnknownSceneExtension {
    /// The sentence for a person, with the extensions that are known.
    pub fn message(&self, lang: Lang) -> String {
        words::unknown_scene_extension(lang, &self.extension)
    }
}

impl SceneFormat {
    /// The format that a file's extension means, whatever its case. A name without an extension gets a document.
    ///
    /// # Errors
    /// An extension that is not known.
    pub fn of_path(path: &Path) -> Result<SceneFormat, UnknownSceneExtension> {
        let Some(extension) = path.extension() else { return Ok(SceneFormat::Xml) };
        let extension = extension.to_string_lossy();
        if extension.eq_ignore_ascii_case("xml") {
            Ok(SceneFormat::Xml)
        } else if extension.eq_ignore_ascii_case("lancer") {
            Ok(SceneFormat::Binary)
        } else {
            Err(UnknownSceneExtension { extension: extension.into_owned() })
        }
    }
}

/// Where a scene was loaded from.
#[derive(Clone, Copy, Debug)]
pub struct Origin<'a> {
    /// The path of the file.
    pub path: &'a Path,
    /// Its document, if it is a native one; what did not change stays as it stands there.
    pub document: Option<&'a Document>,
}

/// The bytes of a scene for a file at `path`, whose extension need not mean the format.
///
/// A document names the files of its meshes. A name that leads to the same mesh from the new place is kept, else it is
/// made to, else the vertices are written into the document: it reads back as the same scene wherever it goes.
pub fn scene_bytes(
    scene: &Scene,
    format: SceneFormat,
    path: &Path,
    origin: Option<Origin<'_>>,
    options: LoadOptions,
) -> Vec<u8> {
    if format == SceneFormat::Binary {
        return binary::write_scene(scene);
    }
    let origin_path = origin.map(|origin| origin.path);
    match origin.and_then(|origin| Some((origin.document?, folder(origin.path) == folder(path)))) {
        // The names were right when it was loaded.
        Some((document, true)) => xml::patch_scene(document, scene),
        Some((document, false)) => xml::patch_scene(document, &with_meshes_found(scene, path, origin_path, options)),
        None => xml::write_scene(&with_meshes_found(scene, path, origin_path, options)).into_bytes(),
    }
}

/// Writes a scene as [`scene_bytes`] gives it.
///
/// # Errors
/// Why the file cannot be written.
pub fn save_scene(
    scene: &Scene,
    format: SceneFormat,
    path: &Path,
    origin: Option<Origin<'_>>,
    options: LoadOptions,
) -> Result<(), SaveError> {
    let bytes = scene_bytes(scene, format, path, origin, options);
    save(path, |out| out.write_all(&bytes))
}

/// The scene with names of mesh files that are right from a document at `path`.
fn with_meshes_found(scene: &Scene, path: &Path, origin: Option<&Path>, options: LoadOptions) -> Scene {
    let mut files = FolderOfDocument::new(path, options);
    // what many objects share is compared once
    let mut compared = HashMap::new();
    let mut found = |object: &Arc<Object>| match &object.shape {
        Shape::Mesh(mesh) => {
            let source = name_found(mesh, &object.material, (&mut files, &mut compared), path, origin);
            if source == mesh.source {
                return Arc::clone(object);
            }
            let shape = Shape::Mesh(Mesh { source, ..mesh.clone() });
            Arc::new(Object { shape, ..Object::clone(object) })
        }
        Shape::Sphere { .. }
        | Shape::Plane { .. }
        | Shape::Facet { .. }
        | Shape::Cube { .. }
        | Shape::Parallelepiped { .. }
        | Shape::Cone { .. } => Arc::clone(object),
    };
    Scene { objects: scene.objects.iter().map(&mut found).collect(), ..scene.clone() }
}

/// A name by which the document finds a mesh, if there is one.
fn name_found(
    mesh: &Mesh,
    material: &MaterialRef,
    (files, compared): (&mut FolderOfDocument, &mut HashMap<[*const MeshGeometry; 2], bool>),
    path: &Path,
    origin: Option<&Path>,
) -> Option<Arc<str>> {
    let name = mesh.source.as_ref()?;
    let mut leads_to_it = |name: &str| {
        files.read(name).is_ok_and(|file| {
            let geometry = match material {
                MaterialRef::Default => file.geometry,
                MaterialRef::Named(_) | MaterialRef::Inline(_) => file.without_materials(),
            };
            let pair = [Arc::as_ptr(&geometry), Arc::as_ptr(&mesh.geometry)];
            *compared.entry(pair).or_insert_with(|| geometry == mesh.geometry)
        })
    };
    if leads_to_it(name) {
        return Some(Arc::clone(name));
    }
    let renamed = name_from(path, origin?, name)?;
    leads_to_it(&renamed).then(|| renamed.into())
}

/// The name by which a document at `path` finds a file that one at `origin` calls `name`, if it lies at or below its
/// folder.
fn name_from(path: &Path, origin: &Path, name: &str) -> Option<String> {
    let file = folder(origin)?.join(name).canonicalize().ok()?;
    let name = file.strip_prefix(folder(path)?).ok()?;
    name.to_str().map(str::to_owned)
}

/// The folder of a document without links; standard input and output stand in the current one.
fn folder(document: &Path) -> Option<PathBuf> {
    let folder = if is_standard(document) { Path::new(".") } else { super::folder_of(document) };
    folder.canonicalize().ok()
}
