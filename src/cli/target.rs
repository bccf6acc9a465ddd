//! Where `acutile certify` writes certificates.

use super::certify::CertifyArguments;
use super::encoding::Encoding;
use acutile_catalog as catalog;
use acutile_io::import::{is_gzip, uncompressed_name};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Where a certificate goes.
pub enum Target {
    Nowhere,
    StandardOutput,
    File(PathBuf),
}

/// One target for each input: several go into a directory, which is made.
pub fn targets(inputs: &[String], arguments: &CertifyArguments) -> Result<Vec<Target>, String> {
    let Some(path) = arguments.output.as_deref() else {
        return Ok(inputs.iter().map(|_| Target::Nowhere).collect());
    };
    let several = inputs.len() > 1;
    if path == Path::new("-") {
        return match several {
            true => Err("-o -: expected one input, standard output holds one certificate".into()),
            false => Ok(vec![Target::StandardOutput]),
        };
    }
    check_name(path, several)?;
    if several {
        std::fs::create_dir_all(path)
            .map_err(|error| format!("{}: cannot be made a directory: {error}", path.display()))?;
    }
    if !path.is_dir() {
        check_not_an_input(path, inputs)?;
        return Ok(vec![Target::File(path.to_path_buf())]);
    }
    let mut names = BTreeMap::new();
    let encoding = arguments.format.unwrap_or(Encoding::Json);
    for input in inputs {
        let name = file_name(input, encoding);
        if let Some(other) = names.insert(name.clone(), input) {
            return Err(format!(
                "{other} and {input} would both be written to {name}"
            ));
        }
    }
    let file = |input: &String| {
        let file = path.join(file_name(input, encoding));
        check_not_an_input(&file, inputs).map(|()| Target::File(file))
    };
    inputs.iter().map(file).collect()
}

/// The name of a new file or directory promises nothing that is not kept.
fn check_name(path: &Path, several: bool) -> Result<(), String> {
    let name = path.display();
    if path.is_dir() {
        return Ok(());
    }
    if several && Encoding::of_path(&uncompressed_name(path)).is_some() {
        return Err(format!(
            "{name}: several certificates need a directory; expected no extension .json or .cbor"
        ));
    }
    match is_gzip(path) {
        true => Err(format!(
            "{name}: certificates are not compressed; expected no extension .gz"
        )),
        false => Ok(()),
    }
}

/// A certificate must not replace the tiling that it certifies.
fn check_not_an_input(target: &Path, inputs: &[String]) -> Result<(), String> {
    let Ok(target_file) = target.canonicalize() else {
        return Ok(());
    };
    let is_target = |input: &&String| {
        catalog::find(input).is_none()
            && Path::new(input)
                .canonicalize()
                .is_ok_and(|file| file == target_file)
    };
    match inputs.iter().find(is_target) {
        Some(input) => Err(format!(
            "{}: would overwrite the input {input}",
            target.display()
        )),
        None => Ok(()),
    }
}

/// `a15` and `dir/a15.json` both give `a15.json`.
fn file_name(input: &str, encoding: Encoding) -> String {
    let stem = match catalog::find(input) {
        Some(_) => Some(input.to_owned()),
        None => uncompressed_name(Path::new(input))
            .file_stem()
            .map(|stem| stem.to_string_lossy().into_owned()),
    };
    let stem = match stem.as_deref() {
        None | Some("-") => "certificate".to_owned(),
        Some(stem) => stem.replace([':', '/'], "-"),
    };
    format!("{stem}.{}", encoding.extension())
}
