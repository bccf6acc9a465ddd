//! `acutile gallery`: a static site of the whole catalogue.

use super::files::{check_directory, unwritten, write_file};
use super::named::InputError;
use super::outcome::Outcome;
use super::output::Output;
use super::record::Record;
use super::words::printable;
use acutile_publish::report::{Site, gallery};
use clap::Args;
use std::io;
use std::path::{Path, PathBuf};

#[derive(Debug, Args)]
pub struct GalleryArguments {
    /// Write the site into this directory
    #[arg(short, long, value_name = "DIR", required = true)]
    pub output: PathBuf,
    /// Write into the directory even if it has other files
    #[arg(long)]
    pub force: bool,
}

/// Writes the site. Nothing is written if a construction is not proved. Nothing is written into a
/// directory with other files than a site of this program, unless `--force` is given.
pub fn run(arguments: &GalleryArguments, output: &mut Output) -> Outcome {
    let checked = check_directory(&arguments.output);
    if let Err(message) = checked.and_then(|()| check_own(&arguments.output, arguments.force)) {
        return output.fail_with(None, message);
    }
    let site = match gallery() {
        Ok(site) => site,
        Err(message) => {
            let outcome = Outcome::Refuted;
            return output.fail(None, &InputError { message, outcome });
        }
    };
    if let Err((path, error)) = write(&arguments.output, &site) {
        return output.fail(None, &unwritten(&path, &error));
    }
    for (path, bytes) in &site {
        output.wrote(&arguments.output.join(path), bytes.len());
    }
    let bytes: usize = site.values().map(Vec::len).sum();
    let directory = printable(&arguments.output);
    output.done_in_words(
        Record::of(None),
        format!("{directory}: {} files, {bytes} bytes", site.len()),
    )
}

/// The file by which a site is known.
const MARK: &str = ".acutile-gallery";

/// The directory is not there, is empty, or has a site that this program wrote.
fn check_own(directory: &Path, force: bool) -> Result<(), String> {
    let name = printable(directory);
    let is_empty = std::fs::read_dir(directory).map_or(true, |mut files| files.next().is_none());
    if is_empty || directory.join(MARK).is_file() || force {
        Ok(())
    } else {
        Err(format!(
            "{name}: has files that acutile gallery did not write; --force writes among them"
        ))
    }
}

fn write(directory: &Path, site: &Site) -> Result<(), (PathBuf, io::Error)> {
    let mark = (MARK.to_owned(), b"Written by acutile gallery.\n".to_vec());
    for (path, bytes) in site.iter().chain([(&mark.0, &mark.1)]) {
        let file = directory.join(path);
        if file.is_symlink() {
            let error = io::Error::new(io::ErrorKind::AlreadyExists, "is a link");
            return Err((file, error));
        }
        let folder = file.parent().unwrap_or(directory);
        std::fs::create_dir_all(folder)
            .and_then(|()| write_file(&file, bytes))
            .map_err(|error| (file, error))?;
    }
    Ok(())
}
