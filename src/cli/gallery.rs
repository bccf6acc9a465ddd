//! `acutile gallery`: a static site of the whole catalogue.

use super::Outcome;
use super::args::GalleryArguments;
use super::output::{Output, write_file};
use crate::report::{Site, gallery};
use std::io;
use std::path::Path;

/// Writes the site; nothing is written where a construction is not proved.
pub fn run(arguments: &GalleryArguments, output: &mut Output) -> Outcome {
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

fn write(directory: &Path, site: &Site) -> Result<(), (String, io::Error)> {
    for (path, bytes) in site {
        let file = directory.join(path);
        let folder = file.parent().unwrap_or(directory);
        std::fs::create_dir_all(folder)
            .and_then(|()| write_file(&file, bytes))
            .map_err(|error| (file.display().to_string(), error))?;
    }
    Ok(())
}
