//! Scenes for other programs. What their formats cannot say is listed, so that nobody is surprised by the picture.

mod facetted;
mod gltf;
mod loss;
mod obj;
mod povray;

pub use gltf::{Container, losses as gltf_losses, write as write_gltf};
pub use loss::{Feature, Loss};
pub use obj::{Files as ObjFiles, losses as obj_losses, write as write_obj};
pub use povray::{losses as povray_losses, write as write_povray};
