//! The system's dialogs, each on a thread of its own, so that the window goes on.

use super::{Dialogs, Reply, Request};
use std::path::Path;
use std::sync::mpsc::{Receiver, channel};
use std::time::{Duration, Instant};

/// A dialog that gives nothing within this time was never seen: without a desktop portal nothing else can be told.
const NEVER_SEEN: Duration = Duration::from_millis(500);

/// Whether there is a session bus, without which no desktop portal answers. How long it takes to find out otherwise
/// depends on how busy the machine is.
fn has_bus() -> bool {
    if !cfg!(target_os = "linux") {
        return true;
    }
    match std::env::var("DBUS_SESSION_BUS_ADDRESS") {
        Ok(address) if !address.is_empty() => address.split([';', ',', ':']).any(|part| match part.split_once('=') {
            Some(("path", path)) => Path::new(path).exists(),
            Some(("abstract" | "tmpdir" | "runtime" | "host", _)) => true,
            Some(_) | None => false,
        }),
        Ok(_) | Err(_) => {
            std::env::var_os("XDG_RUNTIME_DIR").is_some_and(|folder| Path::new(&folder).join("bus").exists())
        }
    }
}

/// The system's dialogs.
pub struct SystemDialogs {
    ctx: egui::Context,
    reply: Option<Receiver<Reply>>,
}

impl std::fmt::Debug for SystemDialogs {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("SystemDialogs").field("asking", &self.reply.is_some()).finish_non_exhaustive()
    }
}

impl SystemDialogs {
    /// Dialogs that wake the window when there is a reply.
    pub fn new(ctx: egui::Context) -> SystemDialogs {
        SystemDialogs { ctx, reply: None }
    }
}

impl Dialogs for SystemDialogs {
    fn ask(&mut self, request: &Request) {
        let (answer, reply) = channel();
        self.reply = Some(reply);
        if !has_bus() {
            // the receiver is ours
            let _ = answer.send(Reply::Unavailable);
            self.ctx.request_repaint();
            return;
        }
        let (request, ctx) = (request.clone(), self.ctx.clone());
        std::thread::spawn(move || {
            let mut dialog = rfd::FileDialog::new().set_title(&request.title);
            for (name, extensions) in &request.filters {
                dialog = dialog.add_filter(name, extensions);
            }
            if let Some(folder) = &request.folder {
                dialog = dialog.set_directory(folder);
            }
            if !request.name.is_empty() {
                dialog = dialog.set_file_name(&request.name);
            }
            let begun = Instant::now();
            let chosen = if request.save { dialog.save_file() } else { dialog.pick_file() };
            let reply = match chosen {
                Some(path) => Reply::Chosen(path),
                None if begun.elapsed() < NEVER_SEEN => Reply::Unavailable,
                None => Reply::Cancelled,
            };
            // a window that has gone on to another question wants no reply
            let _ = answer.send(reply);
            ctx.request_repaint_of(egui::ViewportId::ROOT);
        });
    }

    fn poll(&mut self) -> Option<Reply> {
        let reply = self.reply.as_ref()?.try_recv().ok()?;
        self.reply = None;
        Some(reply)
    }
}
