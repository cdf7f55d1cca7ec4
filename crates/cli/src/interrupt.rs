//! Ctrl-C, and the other ways in which a program is asked to stop.
//!
//! The first signal raises the flag that the tracer polls, and the program ends by itself within a few milliseconds,
//! taking its temporary files with it. A program that does not (it reads a slow disk, or writes into a pipe that nobody
//! reads) is ended from here.

use crate::Exit;
use lancer_trace::Cancel;
use std::sync::{Arc, Mutex, PoisonError, TryLockError};
use std::time::{Duration, Instant};

/// How long the program may take to end by itself: together with the signal's way, and with the time that the system
/// takes to clear some hundreds of megabytes away, less than 100 ms.
const GRACE: Duration = Duration::from_millis(20);

/// How long it may take while a file is being written, so that nothing half-written stays behind.
const GRACE_WHILE_WRITING: Duration = Duration::from_secs(2);

/// Held while a temporary file exists, and by the end of the program: none is begun any more then.
#[derive(Clone, Debug, Default)]
pub(crate) struct Writing(Arc<Mutex<()>>);

impl Writing {
    /// Does something that leaves a temporary file behind if it is cut short.
    pub(crate) fn guard<T>(&self, write: impl FnOnce() -> T) -> T {
        let _held = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        write()
    }
}

/// Sets the handlers and gives the flags that they raise and heed.
///
/// # Errors
/// What the system says.
pub(crate) fn install() -> Result<(Cancel, Writing), ctrlc::Error> {
    let (cancel, writing) = (Cancel::default(), Writing::default());
    let flags = (cancel.clone(), writing.clone());
    ctrlc::set_handler(move || {
        let asked = Instant::now();
        flags.0.cancel();
        let pause = || std::thread::sleep(Duration::from_millis(2));
        while asked.elapsed() < GRACE {
            pause();
        }
        let mut held = flags.1.0.try_lock();
        while matches!(held, Err(TryLockError::WouldBlock)) && asked.elapsed() < GRACE_WHILE_WRITING {
            pause();
            held = flags.1.0.try_lock();
        }
        #[allow(clippy::exit, reason = "the main thread does not answer")]
        std::process::exit(Exit::Interrupted as i32);
    })?;
    ignore_file_size_limit();
    Ok((cancel, writing))
}

/// A file that grows beyond the limit of `ulimit -f` then fails with an error that is told, instead of ending the
/// program.
#[cfg(unix)]
fn ignore_file_size_limit() {
    // The flag is not read: that a handler stands there is what makes `write` return. Where none can be set, the
    // program ends as it would without us.
    let _ = signal_hook::flag::register(signal_hook::consts::SIGXFSZ, Arc::default());
}

#[cfg(not(unix))]
fn ignore_file_size_limit() {}
