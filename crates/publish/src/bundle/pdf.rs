//! The appendix as PDF, by a `pdflatex` of the machine, with nothing in it of the day or the place.

use crate::appendix::File;
use std::io::ErrorKind;
use std::path::Path;
use std::process::{Command, Stdio};

/// The documents of an appendix that compile alone.
const DOCUMENTS: [&str; 2] = ["main", "supplement"];

/// References and the columns of long tables settle in three runs.
const RUNS: usize = 3;

/// The PDFs of the appendix's documents.
///
/// # Errors
/// That there is no TeX, or what it complained about.
pub fn compile(appendix: &[File]) -> Result<Vec<File>, String> {
    let place =
        tempfile::tempdir().map_err(|error| format!("no place for TeX to work: {error}"))?;
    for file in appendix {
        write(place.path(), file).map_err(|error| format!("no place for TeX to work: {error}"))?;
    }
    DOCUMENTS
        .iter()
        .map(|document| pdf(place.path(), document))
        .collect()
}

fn write(place: &Path, file: &File) -> std::io::Result<()> {
    let path = place.join(&file.path);
    if let Some(parent) = path.parent() {
        std::fs::create_dir_all(parent)?;
    }
    std::fs::write(path, &file.bytes)
}

fn pdf(place: &Path, document: &str) -> Result<File, String> {
    for _ in 0..RUNS {
        run(place, document)?;
    }
    let path = format!("{document}.pdf");
    let bytes = std::fs::read(place.join(&path)).map_err(|error| format!("{path}: {error}"))?;
    Ok(File { path, bytes })
}

fn run(place: &Path, document: &str) -> Result<(), String> {
    let source = format!("\\pdftrailerid{{}}\\pdfsuppressptexinfo=-1 \\input{{{document}}}");
    let status = Command::new("pdflatex")
        .args([
            "-no-shell-escape",
            "-halt-on-error",
            "-interaction=batchmode",
        ])
        .args([&format!("-jobname={document}"), &source])
        .current_dir(place)
        .env("SOURCE_DATE_EPOCH", "0")
        .env("FORCE_SOURCE_DATE", "1")
        .env("TZ", "UTC")
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .status();
    match status {
        Ok(status) if status.success() => Ok(()),
        Ok(_) => Err(format!("pdflatex fails: {}", complaint(place, document))),
        Err(error) if error.kind() == ErrorKind::NotFound => {
            Err("pdflatex is not installed".to_owned())
        }
        Err(error) => Err(format!("pdflatex cannot be run: {error}")),
    }
}

/// The first error in the log.
fn complaint(place: &Path, document: &str) -> String {
    let log = std::fs::read(place.join(format!("{document}.log"))).unwrap_or_default();
    let log = String::from_utf8_lossy(&log);
    let line = log.lines().find(|line| line.starts_with('!'));
    line.unwrap_or("its log has no error")
        .trim_end_matches('.')
        .to_owned()
}
