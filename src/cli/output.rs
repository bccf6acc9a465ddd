//! Where a command prints, and how files are written.
//!
//! A reader that closes the pipe early ends the printing quietly; any other error
//! of standard output makes the command fail.

use super::interrupt::Guarded;
use super::outcome::Outcome;
use std::fmt::Display;
use std::io::{self, BufWriter, ErrorKind, Stdout, Write};
use std::path::{Path, PathBuf};

/// Standard output and standard error.
pub struct Output {
    writer: BufWriter<Stdout>,
    error: Option<io::Error>,
}

impl Output {
    /// The process's own streams.
    pub fn standard() -> Self {
        Output {
            writer: BufWriter::new(io::stdout()),
            error: None,
        }
    }

    /// Prints a line.
    pub fn line(&mut self, text: impl Display) {
        self.bytes(format!("{text}\n").as_bytes());
    }

    /// Prints bytes as they are.
    pub fn bytes(&mut self, bytes: &[u8]) {
        if self.error.is_none() {
            self.error = self.writer.write_all(bytes).err();
        }
    }

    /// Prints a line on standard error. Nothing is left to do where that fails.
    pub fn complain(&mut self, text: impl Display) {
        let _ = self.writer.flush();
        let _ = writeln!(io::stderr(), "{text}");
    }

    /// Flushes; failed where standard output took not everything.
    pub fn finish(&mut self) -> Outcome {
        if self.error.is_none() {
            self.error = self.writer.flush().err();
        }
        match &self.error {
            Some(error) if error.kind() != ErrorKind::BrokenPipe => {
                let _ = writeln!(io::stderr(), "acutile: standard output: {error}");
                Outcome::Failed
            }
            _ => Outcome::Done,
        }
    }
}

/// Never fails: an error is kept and told by [`Output::finish`].
impl Write for Output {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.bytes(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        if self.error.is_none() {
            self.error = self.writer.flush().err();
        }
        Ok(())
    }
}

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
    /// A temporary file beside `path`, or beside what it points to; `None` where that is a
    /// device or a pipe, which has no place beside it.
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

    /// What has been written, and is to be.
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

/// Writes a file, or to standard output for `-` and where there is none.
pub fn write_text(path: Option<&Path>, text: &str, output: &mut Output) -> Outcome {
    let Some(path) = path.filter(|path| *path != Path::new("-")) else {
        output.bytes(text.as_bytes());
        return Outcome::Done;
    };
    match write_file(path, text.as_bytes()) {
        Ok(()) => Outcome::Done,
        Err(error) => {
            output.complain(format!(
                "acutile: {}: cannot be written: {error}",
                path.display()
            ));
            Outcome::Failed
        }
    }
}
