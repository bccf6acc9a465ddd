//! `acutile gallery`: a static site of the whole catalogue.

use super::outcome::Outcome;
use super::output::{Output, write_file};
use acutile_publish::report::{Site, gallery};
use clap::Args;
use std::io;
use std::path::Path;
use std::path::PathBuf;

#[derive(Debug, Args)]
pub struct GalleryArguments {
    /// Write the site into this directory
    #[arg(short, long, value_name = "DIR", required = true)]
    pub output: PathBuf,
    /// Write into a directory that has other files, too
    #[arg(long)]
    pub force: bool,
}

/// Writes the site; nothing is written where a construction is not proved, nor into a directory
/// that has other things than a site of this program, unless `--force` is given.
pub fn run(arguments: &GalleryArguments, output: &mut Output) -> Outcome {
    if let Err(message) = check_own(&arguments.output, arguments.force) {
        output.complain(format!("acutile: {message}"));
        return Outcome::Failed;
    }
    let site = match gallery() {
        Ok(site) => site,
        Err(message) => {
            output.complain(format!("acutile: {message}"));
            return Outcome::Refuted;
        }
    };
    match write(&arguments.output, &site) {
        Ok(()) => {
            let bytes: usize = site.values().map(Vec::len).sum();
            let directory = arguments.output.display();
            output.line(format!("{directory}: {} files, {bytes} bytes", site.len()));
            Outcome::Done
        }
        Err((path, error)) => {
            output.complain(format!("acutile: {path}: cannot be written: {error}"));
            Outcome::Failed
        }
    }
}

/// The file by which a site is known.
const MARK: &str = ".acutile-gallery";

/// The directory is not there, is empty, or has a site that this program wrote.
fn check_own(directory: &Path, force: bool) -> Result<(), String> {
    let name = directory.display();
    if directory.exists() && !directory.is_dir() {
        return Err(format!("{name}: is not a directory"));
    }
    let is_empty = std::fs::read_dir(directory).map_or(true, |mut files| files.next().is_none());
    match is_empty || directory.join(MARK).is_file() || force {
        true => Ok(()),
        false => Err(format!(
            "{name}: has files that acutile gallery did not write; --force writes among them"
        )),
    }
}

fn write(directory: &Path, site: &Site) -> Result<(), (String, io::Error)> {
    let mark = (MARK.to_owned(), b"Written by acutile gallery.\n".to_vec());
    for (path, bytes) in site.iter().chain([(&mark.0, &mark.1)]) {
        let file = directory.join(path);
        if file.is_symlink() {
            let error = io::Error::new(io::ErrorKind::AlreadyExists, "is a link");
            return Err((file.display().to_string(), error));
        }
        let folder = file.parent().unwrap_or(directory);
        std::fs::create_dir_all(folder)
            .and_then(|()| write_file(&file, bytes))
            .map_err(|error| (file.display().to_string(), error))?;
    }
    Ok(())
}
