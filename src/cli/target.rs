//! Where `acutile certify` writes certificates.

use super::certify_arguments::CertifyArguments;
use super::encoding::Encoding;
use super::files::{check_directory, check_writable, is_standard};
use super::name::InputName;
use super::overwriting::{check_not_an_input, check_output, check_replaceable};
use super::words::printable;
use acutile_catalog as catalog;
use acutile_core::format::recognise;
use acutile_io::import::{is_gzip, uncompressed_name};
use std::collections::BTreeMap;
use std::ffi::{OsStr, OsString};
use std::path::{Path, PathBuf};

/// Where a certificate goes.
pub enum Target {
    Nowhere,
    StandardOutput,
    File(PathBuf),
}

/// One target for each input: several go into a directory, which is made.
pub fn targets(inputs: &[InputName], arguments: &CertifyArguments) -> Result<Vec<Target>, String> {
    let Some(path) = arguments.output.as_deref() else {
        return Ok(inputs.iter().map(|_| Target::Nowhere).collect());
    };
    let several = inputs.len() > 1;
    if is_standard(path) {
        return if several {
            Err("-o -: expected one input, standard output holds one certificate".into())
        } else {
            Ok(vec![Target::StandardOutput])
        };
    }
    check_name(path, several)?;
    if several {
        check_directory(path)?;
        std::fs::create_dir_all(path)
            .map_err(|error| format!("{}: cannot be made a directory: {error}", printable(path)))?;
    }
    if !path.is_dir() {
        check_output(Some(path), "-o", inputs)?;
        Encoding::of(Some(path), arguments.format)?;
        return Ok(vec![Target::File(path.to_path_buf())]);
    }
    let mut names = BTreeMap::new();
    let encoding = arguments.format.unwrap_or(Encoding::Json);
    for input in inputs {
        let name = file_name(input, encoding);
        if let Some(other) = names.insert(name.clone(), input) {
            return Err(format!(
                "{other} and {input} would both be written to {}",
                printable(name)
            ));
        }
    }
    let file = |input: &InputName| {
        let file = path.join(file_name(input, encoding));
        check_not_an_input(Some(&file), "-o", inputs)?;
        check_replaceable(&file, |bytes| recognise(bytes).is_some(), arguments.force)?;
        check_writable(&file)?;
        Ok(Target::File(file))
    };
    inputs.iter().map(file).collect()
}

/// The name of a new file or directory promises nothing that is not kept.
fn check_name(path: &Path, several: bool) -> Result<(), String> {
    let name = printable(path);
    if path.is_dir() {
        return Ok(());
    }
    if several && Encoding::of_path(&uncompressed_name(path)).is_some() {
        return Err(format!(
            "{name}: several certificates need a directory; expected no extension .json or .cbor"
        ));
    }
    if is_gzip(path) {
        Err(format!(
            "{name}: certificates are not compressed; expected no extension .gz"
        ))
    } else {
        Ok(())
    }
}

/// `a15` and `dir/a15.json` both give `a15.json`.
fn file_name(input: &InputName, encoding: Encoding) -> OsString {
    let stem = match catalog::find(input) {
        Some(_) => Some(OsString::from(input.replace([':', '/'], "-"))),
        None => uncompressed_name(input.path())
            .file_stem()
            .map(OsStr::to_owned),
    };
    let mut name = match stem {
        Some(stem) if stem != "-" => stem,
        _ => OsString::from("certificate"),
    };
    name.push(".");
    name.push(encoding.extension());
    name
}
