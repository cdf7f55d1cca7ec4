//! Live pictures: sessions that begin again at every change of the scene or the view, on one pool of threads.
//!
//! A window owns its [`Session`]s and asks them for pictures; the threads own the work. Between them pass messages
//! only: no call of a session waits for a thread, and no thread waits for the window.

mod image;
mod pool;
mod session;

pub use image::LiveImage;
pub use pool::{Job, Renderer};
pub use session::{Session, Status};
