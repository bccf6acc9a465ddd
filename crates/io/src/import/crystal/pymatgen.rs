//! A `Structure` of pymatgen as JSON: a lattice matrix and sites, with the decimals as they stand.

use super::vectors::{self, Coordinates, Listed, Vector, number, species};
use crate::import::ImportError;
use crate::import::atoms::options::CifOptions;
use crate::import::atoms::structure::Structure;
use serde::Deserialize;
use serde_json::value::RawValue;

#[derive(Deserialize)]
struct Document<'a> {
    #[serde(rename = "@class", default)]
    class: Option<String>,
    #[serde(borrow)]
    lattice: Lattice<'a>,
    #[serde(borrow)]
    sites: Vec<Site<'a>>,
}

#[derive(Deserialize)]
struct Lattice<'a> {
    #[serde(borrow)]
    matrix: [[&'a RawValue; 3]; 3],
    #[serde(default)]
    pbc: Option<[bool; 3]>,
}

#[derive(Deserialize)]
struct Site<'a> {
    #[serde(borrow)]
    species: Vec<Species<'a>>,
    #[serde(borrow)]
    abc: [&'a RawValue; 3],
    #[serde(default)]
    label: Option<String>,
}

#[derive(Deserialize)]
struct Species<'a> {
    element: String,
    #[serde(borrow, default)]
    occu: Option<&'a RawValue>,
}

/// Whether a text looks like the JSON of a structure.
pub fn is_likely(text: &str) -> bool {
    let text = text.trim_start_matches('\u{feff}').trim_start();
    text.starts_with('{')
        && ["\"lattice\"", "\"sites\"", "\"matrix\""]
            .iter()
            .all(|word| text.contains(word))
}

/// Reads the JSON of a structure.
pub fn read(text: &str, options: &CifOptions) -> Result<Structure, ImportError> {
    let text = text.trim_start_matches('\u{feff}');
    let document: Document = serde_json::from_str(text).map_err(ImportError::Json)?;
    let class = document.class.as_deref().unwrap_or("Structure");
    if !class.ends_with("Structure") {
        let problem = format!("found {class:?}, expected a Structure of pymatgen");
        return Err(ImportError::entry("@class", problem));
    }
    if document.lattice.pbc.is_some_and(|pbc| pbc != [true; 3]) {
        let problem = "expected a cell that is periodic in all directions";
        return Err(ImportError::entry("lattice.pbc", problem));
    }
    let mut rows = Vec::new();
    for (i, row) in document.lattice.matrix.iter().enumerate() {
        rows.push(numbers(row, &format!("lattice.matrix[{i}]"))?);
    }
    let matrix = std::array::from_fn(|i| rows[i].clone());
    let mut atoms = Vec::with_capacity(document.sites.len());
    for (index, site) in document.sites.iter().enumerate() {
        let place = format!("sites[{index}]");
        let symbol = symbol(site, &place, options)?;
        let label = site.label.as_deref().filter(|label| *label != symbol);
        atoms.push(Listed {
            label: label.map_or_else(|| format!("{symbol}{}", index + 1), ToOwned::to_owned),
            element: species(symbol),
            position: numbers(&site.abc, &format!("{place}.abc"))?,
            place,
        });
    }
    vectors::structure(
        "pymatgen".to_owned(),
        &matrix,
        Coordinates::Fractional,
        atoms,
        Vec::new(),
        options,
    )
}

/// The element of a site that is one atom.
fn symbol<'a>(site: &'a Site, place: &str, options: &CifOptions) -> Result<&'a str, ImportError> {
    let [species] = &site.species[..] else {
        return match site.species.first() {
            Some(first) if options.ignore_occupancy => Ok(&first.element),
            _ => {
                let problem = format!(
                    "has {} species: disorder cannot be a point set; --ignore-occupancy takes it as one atom",
                    site.species.len()
                );
                Err(ImportError::entry(place, problem))
            }
        };
    };
    let occupancy = species
        .occu
        .map(|raw| number(raw.get(), || format!("{place}.species")))
        .transpose()?;
    match occupancy {
        Some(value) if value != 1 && (value == 0 || !options.ignore_occupancy) => {
            let problem = format!(
                "has the occupancy {value}: disorder cannot be a point set; --ignore-occupancy takes it as an atom"
            );
            Err(ImportError::entry(place, problem))
        }
        _ => Ok(&species.element),
    }
}

fn numbers(row: &[&RawValue; 3], place: &str) -> Result<Vector, ImportError> {
    let mut numbers = Vec::new();
    for (k, raw) in row.iter().enumerate() {
        numbers.push(number(raw.get(), || format!("{place}[{k}]"))?);
    }
    Ok(std::array::from_fn(|k| numbers[k].clone()))
}
