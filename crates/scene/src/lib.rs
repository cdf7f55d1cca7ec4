//! What a scene and a view are: data, validity, edits and lint.
//!
//! A [`Scene`] is an immutable snapshot: cloning it is cheap because its parts are shared, and an [`Edit`] gives a new
//! snapshot that shares all that did not change. The crate knows no file, no ray and no window.
//!
//! Lengths are free scene units, angles are degrees, axes are right-handed, colours are linear intensities in 0..1.

mod color;
mod cone;
mod edit;
mod environment;
mod extents;
pub mod generate;
mod light;
mod lint;
mod list;
mod material;
mod mesh;
mod names;
mod object;
mod picture;
mod placement;
mod scene;
mod screen;
mod shape;
mod validity;
mod view;

pub use color::{Color, Rgb};
pub use cone::{ConeFace, circle, circle_extent, cone_facets};
pub use edit::{Edit, EditError, ListEdit};
pub use environment::{Compose, Environment};
pub use extents::Extents;
pub use glam::{DMat3, DVec3};
pub use light::PointLight;
pub use lint::{Bounce, Finding, Owner, Weight, lint};
pub use list::List;
pub use material::{Highlight, Material, MaterialRef, Reflectance, Surface};
pub use mesh::{Enclosure, Mesh, MeshGeometry, Part};
pub use names::{Name, NameKind, first_free_name};
pub use object::Object;
pub use picture::Picture;
pub use placement::{Placement, tan_degrees};
pub use scene::{Scene, Stage};
pub use screen::{Screen, ScreenSpec};
pub use shape::{Shape, box_facets};
pub use validity::{Invalid, limits};
pub use view::{Steps, View, Views};
