//! Crystal structures: files that give a cell and its atoms, read into point sets.
//!
//! | file | does |
//! |---|---|
//! | `vectors` | structures from basis vectors and a list of atoms |
//! | `poscar`, `xyz`, `pymatgen` | the formats of VASP, of extended XYZ, of pymatgen's JSON |
//!
//! CIF, which has symmetry, is in [`super::cif`], and the parts that all readers share in `super::atoms`.
//! Numbers stay the decimals that are written.

mod poscar;
mod pymatgen;
mod vectors;
mod xyz;

pub use super::atoms::Shortest;
pub use super::atoms::structure::{Interval, Structure, Variation};

use super::ImportError;
use super::atoms::options::CifOptions;
use super::cif::{is_cif, read_cif};
use std::path::Path;

/// The formats of crystal structures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Crystallographic information files.
    Cif,
    /// VASP's POSCAR and CONTCAR.
    Poscar,
    /// Extended XYZ.
    Xyz,
    /// A `Structure` of pymatgen as JSON.
    Pymatgen,
}

/// The format of a file by its name, or by the beginning of its text.
pub fn kind(path: &Path, text: &str) -> Option<Kind> {
    if is_cif(path, text) {
        return Some(Kind::Cif);
    }
    let is_extension = |names: &[&str]| {
        path.extension().is_some_and(|extension| {
            names
                .iter()
                .any(|name| extension.eq_ignore_ascii_case(name))
        })
    };
    let name = path.file_name().map_or_else(String::new, |name| {
        name.to_string_lossy().to_ascii_uppercase()
    });
    let is_json = is_extension(&["json"]);
    let is_poscar = ["POSCAR", "CONTCAR"].iter().any(|own| name.contains(own)) && !is_json;
    if is_poscar || is_extension(&["poscar", "contcar", "vasp"]) || poscar::is_likely(text) {
        Some(Kind::Poscar)
    } else if is_extension(&["xyz", "extxyz"]) || xyz::is_likely(text) {
        Some(Kind::Xyz)
    } else if pymatgen::is_likely(text) {
        Some(Kind::Pymatgen)
    } else {
        None
    }
}

/// Reads a file of this format.
///
/// # Errors
/// [`ImportError`] with the place of a thing that is missing, wrong or no crystal.
pub fn read(kind: Kind, text: &str, options: &CifOptions) -> Result<Structure, ImportError> {
    match kind {
        Kind::Cif => read_cif(text, options),
        Kind::Poscar => poscar::read(text, options),
        Kind::Xyz => xyz::read(text, options),
        Kind::Pymatgen => pymatgen::read(text, options),
    }
}

/// The text of a file: a crystal structure may have bytes that are not UTF-8 where nothing is
/// read, like names of authors.
///
/// # Errors
/// A file of another kind with bytes that are not UTF-8.
pub fn text_of(path: &Path, bytes: Vec<u8>) -> Result<String, ImportError> {
    match String::from_utf8(bytes) {
        Ok(text) => Ok(text),
        Err(error) => {
            let offset = error.utf8_error().valid_up_to();
            let text = String::from_utf8_lossy(error.as_bytes()).into_owned();
            match kind(path, &text) {
                Some(_) => Ok(text),
                None => Err(ImportError::NotText { offset }),
            }
        }
    }
}
