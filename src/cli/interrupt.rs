//! Temporary files do not outlive an interrupt: Ctrl-C, SIGTERM and SIGHUP remove those that are
//! open, and end the program with the exit code 130.
//!
//! `tempfile` removes a file when it is dropped, and a signal drops nothing. The list is locked while a
//! file is made or gets its name, and stays locked once the program ends: no file escapes it.

use std::collections::BTreeSet;
use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};
use std::process;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};
use tempfile::NamedTempFile;

/// 128 + SIGINT, as shells have it.
const INTERRUPTED: i32 = 130;

static OPEN: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());

/// Whether the first signal only asks the work to end.
static IS_GENTLE: AtomicBool = AtomicBool::new(false);
/// Whether it has asked.
static IS_ASKED: AtomicBool = AtomicBool::new(false);

/// From now on the first signal sets the value that is returned, and the second one ends the program.
pub fn gently() -> &'static AtomicBool {
    IS_GENTLE.store(true, Ordering::Relaxed);
    &IS_ASKED
}

/// Whoever panicked with the lock left a list that is good still.
fn open() -> MutexGuard<'static, BTreeSet<PathBuf>> {
    OPEN.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Listens, in a thread of its own. Where a signal is ignored already, as under `nohup`, nothing is
/// changed: the program is to live on.
pub fn listen() {
    let _ = ctrlc::try_set_handler(|| {
        if IS_GENTLE.load(Ordering::Relaxed) && !IS_ASKED.swap(true, Ordering::Relaxed) {
            return;
        }
        let open = open();
        for path in open.iter() {
            let _ = fs::remove_file(path);
        }
        process::exit(INTERRUPTED);
    });
}

/// A temporary file that an interrupt removes.
pub struct Guarded {
    file: NamedTempFile,
    entry: Entry,
}

/// A path on the list, for as long as this is there.
struct Entry(PathBuf);

impl Drop for Entry {
    fn drop(&mut self) {
        open().remove(&self.0);
    }
}

impl Guarded {
    /// The file that `make` makes, on the list from its first moment.
    ///
    /// # Errors
    /// Those of `make`.
    pub fn new(make: impl FnOnce() -> io::Result<NamedTempFile>) -> io::Result<Guarded> {
        let mut open = open();
        let file = make()?;
        let entry = Entry(file.path().to_path_buf());
        open.insert(entry.0.clone());
        Ok(Guarded { file, entry })
    }

    /// The file itself.
    pub fn as_file(&self) -> &File {
        self.file.as_file()
    }

    /// Gives the file its name.
    ///
    /// # Errors
    /// It cannot be renamed; then it is removed.
    pub fn persist(self, path: &Path) -> io::Result<()> {
        let Guarded { file, entry } = self;
        let list = open();
        let renamed = file.persist(path).map(drop).map_err(|error| error.error);
        drop(list);
        drop(entry);
        renamed
    }
}
