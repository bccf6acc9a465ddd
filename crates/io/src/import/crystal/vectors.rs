//! A structure from basis vectors and a list of atoms, all rational.

use crate::import::ImportError;
use crate::import::atoms::decimal::Decimal;
use crate::import::atoms::element;
use crate::import::atoms::options::CifOptions;
use crate::import::atoms::select::chosen;
use crate::import::atoms::structure::{Structure, point_set};
use acutile_core::statement::counted;
use malachite::Rational;
use malachite::base::num::arithmetic::traits::Floor;
use std::collections::HashMap;

pub type Vector = [Rational; 3];

/// Atoms of a cell: more are declined.
const ATOM_LIMIT: usize = 200_000;

/// An atom as a file lists it.
pub struct Listed {
    pub label: String,
    pub element: Option<&'static str>,
    /// In the file's coordinates.
    pub position: Vector,
    /// Where it stands, like `line 8`.
    pub place: String,
}

/// In which coordinates atoms are listed.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Coordinates {
    Fractional,
    Cartesian,
}

/// A number at a place of a file.
///
/// # Errors
/// It is none.
pub fn number(text: &str, place: impl Fn() -> String) -> Result<Rational, ImportError> {
    Decimal::parse(text)
        .map(|number| number.value)
        .map_err(|problem| ImportError::entry(place(), problem))
}

/// The element of a species like `Si`, `Si_pv` or `Si/0a1b`.
pub fn species(text: &str) -> Option<&'static str> {
    let symbol = text.split(['_', '/']).next().unwrap_or(text);
    match element::kind(symbol) {
        element::Kind::Element(element) => Some(element),
        _ => None,
    }
}

/// The structure of atoms in the cell of three vectors.
///
/// # Errors
/// No cell, two atoms at one place, an option for CIF only, no atom.
pub fn structure(
    name: String,
    vectors: &[Vector; 3],
    coordinates: Coordinates,
    atoms: Vec<Listed>,
    mut notes: Vec<String>,
    options: &CifOptions,
) -> Result<Structure, ImportError> {
    if options.snap.is_some() {
        let problem = "is for a CIF: this format has no symmetry operations, and its numbers are taken as they are";
        return Err(ImportError::entry("--snap", problem));
    }
    if atoms.is_empty() {
        return Err(ImportError::entry("atoms", "there is none"));
    }
    if atoms.len() > ATOM_LIMIT {
        let problem = format!("{}, the limit is {ATOM_LIMIT}", atoms.len());
        return Err(ImportError::limit("atoms", problem));
    }
    let inverse = inverse(vectors).ok_or_else(|| {
        ImportError::entry(
            "lattice",
            "the three vectors lie in a plane: the volume of the cell is 0",
        )
    })?;
    let names: Vec<_> = atoms
        .iter()
        .map(|atom| (atom.label.clone(), atom.element))
        .collect();
    let chosen = chosen(&names, options)?;
    let listed = atoms.len();
    let mut places: HashMap<Vector, String> = HashMap::new();
    let mut kept = Vec::new();
    for (atom, _) in atoms.into_iter().zip(chosen).filter(|(_, chosen)| *chosen) {
        let position = match coordinates {
            Coordinates::Fractional => atom.position,
            Coordinates::Cartesian => times(&atom.position, &inverse),
        };
        let position = position.map(fractional);
        if let Some(other) = places.get(&position) {
            let problem = format!("atom {} is at the place of the atom at {other}", atom.label);
            return Err(ImportError::entry(atom.place, problem));
        }
        places.insert(position.clone(), atom.place);
        kept.push((atom.label, atom.element, position));
    }
    notes.push(if kept.len() == listed {
        format!("{} in a cell", counted(listed, "atom", "atoms"))
    } else {
        format!("{} of {listed} atoms in a cell", kept.len())
    });
    let gram = std::array::from_fn(|i| std::array::from_fn(|j| dot(&vectors[i], &vectors[j])));
    let mut structure = Structure {
        name,
        points: point_set(gram, kept.iter().map(|(_, _, position)| position)),
        labels: kept.iter().map(|(label, _, _)| label.clone()).collect(),
        elements: kept.iter().map(|(_, element, _)| *element).collect(),
        notes,
        variation: None,
    };
    structure.note_distance();
    Ok(structure)
}

fn fractional(x: Rational) -> Rational {
    let floor = Rational::from((&x).floor());
    x - floor
}

fn dot(x: &Vector, y: &Vector) -> Rational {
    x.iter()
        .zip(y)
        .fold(Rational::from(0), |sum, (x, y)| sum + x * y)
}

/// x B for a row x.
fn times(x: &Vector, b: &[Vector; 3]) -> Vector {
    std::array::from_fn(|j| (0..3).fold(Rational::from(0), |sum, k| sum + &x[k] * &b[k][j]))
}

/// The determinant of three rows.
pub fn determinant(m: &[Vector; 3]) -> Rational {
    dot(&m[0], &cross(&m[1], &m[2]))
}

fn cross(x: &Vector, y: &Vector) -> Vector {
    std::array::from_fn(|k| {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        &x[i] * &y[j] - &x[j] * &y[i]
    })
}

/// The inverse; its columns are cross products over the determinant.
fn inverse(m: &[Vector; 3]) -> Option<[Vector; 3]> {
    let determinant = determinant(m);
    if determinant == 0 {
        return None;
    }
    let columns: [Vector; 3] = std::array::from_fn(|k| cross(&m[(k + 1) % 3], &m[(k + 2) % 3]));
    Some(std::array::from_fn(|i| {
        std::array::from_fn(|j| &columns[j][i] / &determinant)
    }))
}
