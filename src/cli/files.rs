//! Files that a command writes: whole or not at all, and checked before the work starts.

use super::interrupt::Guarded;
use super::named::InputError;
use super::words::printable;
use acutile_io::import::io_words;
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};

/// Writes a whole file or nothing: to a temporary file beside it, then renamed. A link
/// stays, and what it points to is written; devices and pipes are written directly.
pub fn write_file(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let Some(staged) = Staged::new(path)? else {
        return std::fs::write(path, bytes);
    };
    let mut file = staged.file();
    file.write_all(bytes).map_err(without_temporary_name)?;
    staged.persist()
}

/// A file that is written whole or not at all, before it has its name.
pub struct Staged {
    file: Guarded,
    path: PathBuf,
}

impl Staged {
    /// A temporary file beside `path`, or beside the file that it points to. `None` for a device or a pipe,
    /// which has no place beside it.
    pub fn new(path: &Path) -> io::Result<Option<Staged>> {
        if path.is_dir() {
            return Err(io::Error::new(ErrorKind::IsADirectory, "is a directory"));
        }
        let is_special = ["/dev", "/proc"].iter().any(|top| path.starts_with(top));
        let path = path.canonicalize().unwrap_or_else(|_| path.to_path_buf());
        if is_special || (path.exists() && !path.is_file()) {
            return Ok(None);
        }
        let directory = match path.parent() {
            Some(parent) if parent != Path::new("") => parent,
            _ => Path::new("."),
        };
        let file = new_file(directory).map_err(without_temporary_name)?;
        Ok(Some(Staged { file, path }))
    }

    /// The temporary file, to write into or to read from.
    pub fn file(&self) -> &std::fs::File {
        self.file.as_file()
    }

    /// Gives the file its name.
    pub fn persist(self) -> io::Result<()> {
        self.file.as_file().sync_all()?;
        self.file
            .persist(&self.path)
            .map_err(without_temporary_name)
    }
}

/// Writes several files into directories that are there: all to temporary files first, so that
/// what can fail has failed before the first is renamed. The disk is not waited for: these are
/// files that can be written again.
pub fn write_files(files: &[(PathBuf, &[u8])]) -> Result<(), (PathBuf, io::Error)> {
    let mut staged = Vec::with_capacity(files.len());
    for (path, bytes) in files {
        let stage = || {
            let file = new_file(path.parent().unwrap_or(Path::new(".")))?;
            file.as_file().write_all(bytes)?;
            Ok(file)
        };
        let file = stage().map_err(|error| (path.clone(), without_temporary_name(error)))?;
        staged.push((path, file));
    }
    for (path, file) in staged {
        let unwritten = |error| (path.clone(), without_temporary_name(error));
        file.persist(path).map_err(unwritten)?;
    }
    Ok(())
}

/// The user did not choose the temporary file's name.
fn without_temporary_name(error: io::Error) -> io::Error {
    match error.kind() {
        ErrorKind::NotFound => io::Error::new(ErrorKind::NotFound, "no such directory"),
        kind => io::Error::from(kind),
    }
}

/// A temporary file with the permissions of an ordinary new file.
fn new_file(directory: &Path) -> io::Result<Guarded> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".acutile-");
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        builder.permissions(std::fs::Permissions::from_mode(0o666));
    }
    Guarded::new(|| builder.tempfile_in(directory))
}

/// Whether a path is `-`, standard output.
pub fn is_standard(path: &Path) -> bool {
    path == Path::new("-")
}

/// Checks that several files can go into a directory: it is neither `-` nor a file, and it or the one that will hold it takes new files.
///
/// # Errors
/// A message that names the directory.
pub fn check_directory(path: &Path) -> Result<(), String> {
    if is_standard(path) {
        Err("-o -: several files are written, expected a directory".to_owned())
    } else if let Some(file) = path.ancestors().find(|at| at.exists() && !at.is_dir()) {
        Err(format!(
            "{}: found a file, expected a directory or a new name",
            printable(file)
        ))
    } else if let Some(extension) = file_extension(path).filter(|_| !path.exists()) {
        Err(format!(
            "{}: found the extension .{extension}, expected the name of a directory, into which several files are written",
            printable(path)
        ))
    } else {
        let place = path.ancestors().find(|at| at.is_dir());
        let file = new_file(place.unwrap_or(Path::new(".")));
        file.map_or_else(
            |error| Err(unwritten(path, &without_temporary_name(error)).message),
            |_| Ok(()),
        )
    }
}

/// The extension of a name that can only be meant for a single file.
fn file_extension(path: &Path) -> Option<&str> {
    const OF_FILES: [&str; 9] = [
        "tex", "pdf", "html", "htm", "zip", "json", "cbor", "svg", "gz",
    ];
    let extension = path.extension()?.to_str()?;
    OF_FILES.contains(&extension).then_some(extension)
}

/// Checks before the work that a file can be written at its end: its directory takes a new file.
///
/// # Errors
/// A message that names the file.
pub fn check_writable(path: &Path) -> Result<(), String> {
    if is_standard(path) {
        return Ok(());
    }
    let staged = Staged::new(path);
    staged.map_or_else(|error| Err(unwritten(path, &error).message), |_| Ok(()))
}

/// That a file cannot be written.
pub fn unwritten(path: &Path, error: &io::Error) -> InputError {
    let words = match error.kind() {
        ErrorKind::NotFound => "there is no such directory".to_owned(),
        _ => io_words(error),
    };
    format!("{}: cannot be written: {words}", printable(path)).into()
}
