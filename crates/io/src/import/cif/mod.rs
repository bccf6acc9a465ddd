//! Crystallographic information files (CIF 1.1): a point set from a cell, a list of
//! symmetry operations and sites. What is read, and what not, is in docs/cif.md.
//!
//! | file | does |
//! |---|---|
//! | `token` | words, with their lines |
//! | `block` | data blocks: tags and their values |
//! | `decimal` | numbers exactly as written, and snapping |
//! | `cell` | lengths and angles, as a Gram matrix over Q |
//! | `operation`, `symmetry` | operations; the list of a file, checked to be its group |
//! | `options` | the options |
//! | `sites` | the sites of the asymmetric unit |
//! | `orbits` | the atoms of a cell |
//!
//! Coordinates become rationals and stay what is written; whatever is not taken literally is
//! said in a note.

mod block;
mod cell;
mod decimal;
mod operation;
mod options;
mod orbits;
mod sites;
mod symmetry;
mod token;

pub use options::CifOptions;

use super::ImportError;
use acutile_core::tiling::{Frame, PointSet};
use acutile_exact::number::{Field, Number};
use block::Block;
use decimal::about;
use malachite::Rational;
use orbits::{Atom, PAIR_LIMIT};
use sites::{Site, Sites};
use std::path::Path;
use symmetry::Listed;
use token::{short, strip_prefix};

/// Bytes of a CIF: it is taken apart as a whole.
const CIF_LIMIT: usize = 1 << 25;
/// How many sites the count names.
const NAMED_SITES: usize = 20;
/// How many pairs of near atoms a warning names.
const NAMED_PAIRS: usize = 3;

/// The point set of a CIF.
pub struct CifPoints {
    /// The name of its data block.
    pub name: String,
    pub points: PointSet<3>,
    /// What a reader has to know: replacements, rounding, warnings, counts. Each is a line.
    pub notes: Vec<String>,
}

/// Whether a file is a CIF: by its name, or because it begins with `data_` after comments.
pub fn is_cif(path: &Path, text: &str) -> bool {
    if path
        .extension()
        .is_some_and(|extension| extension.eq_ignore_ascii_case("cif"))
    {
        return true;
    }
    let text = text.trim_start_matches('\u{feff}');
    let mut lines = text.lines().map(str::trim_start);
    lines
        .find(|line| !line.is_empty() && !line.starts_with('#'))
        .is_some_and(|line| strip_prefix(line, "data_").is_some())
}

/// Reads the text of a CIF.
///
/// # Errors
/// [`ImportError`] with the line: no CIF, something missing, a list of operations that is no
/// group or does not fit the cell, disorder.
pub fn read_cif(text: &str, options: &CifOptions) -> Result<CifPoints, ImportError> {
    if text.len() > CIF_LIMIT {
        return Err(ImportError::TooLong {
            limit: CIF_LIMIT as u64,
        });
    }
    let blocks = block::blocks(text.trim_start_matches('\u{feff}'))?;
    let block = choose(&blocks, options.block.as_deref())?;
    let operations = symmetry::operations(block, options.snap)?;
    let cell = cell::cell(block)?;
    let bent = cell::check_isometries(&cell, &operations)?;
    let sites = sites::sites(block, options)?;
    let atoms = orbits::atoms(&sites.sites, &operations, options.ignore_occupancy)?;

    let each = atoms_of_sites(sites.sites.len(), &atoms);
    let mut notes = Vec::new();
    if blocks.len() > 1 {
        notes.push(format!(
            "data_{}: this data block of {} is read",
            block.name,
            blocks.len()
        ));
    }
    notes.extend(replacements(&operations));
    notes.extend(sites.notes.iter().cloned());
    notes.extend(uncertainties(cell.uncertain + sites.uncertain));
    notes.extend(
        cell.rounded.iter().map(|words| {
            format!("{words} (15 decimals; what is proved is proved of that lattice)")
        }),
    );
    notes.extend(bent.map(|words| format!("warning: {words}")));
    notes.extend(wrong_multiplicities(&sites.sites, &each));
    notes.extend(near_atoms(&sites.sites, &atoms));
    notes.push(counts(&sites, operations.len(), &each));
    Ok(CifPoints {
        name: block.name.to_owned(),
        points: point_set(cell.gram, &atoms),
        notes,
    })
}

fn point_set(gram: [[Rational; 3]; 3], atoms: &[Atom]) -> PointSet<3> {
    let points = atoms
        .iter()
        .map(|atom| atom.position.clone().map(Number::from));
    PointSet {
        frame: Frame::space(Field::rationals(), gram.map(|row| row.map(Number::from))),
        points: points.collect(),
    }
}

/// The block of this name, or the only one with sites.
fn choose<'b, 't>(
    blocks: &'b [Block<'t>],
    name: Option<&str>,
) -> Result<&'b Block<'t>, ImportError> {
    if blocks.is_empty() {
        return Err(ImportError::entry(
            "line 1",
            "no data block, expected a CIF, which begins with data_NAME",
        ));
    }
    let fits = |block: &&Block| match name {
        Some(name) => block.name.eq_ignore_ascii_case(name),
        None => sites::has_sites(block),
    };
    let found: Vec<&Block> = blocks.iter().filter(fits).collect();
    let names = |blocks: &[&Block]| {
        let names: Vec<String> = blocks
            .iter()
            .take(20)
            .map(|block| short(block.name))
            .collect();
        names.join(", ")
    };
    match (found[..].as_ref(), name) {
        ([block], _) => Ok(block),
        ([], Some(name)) => {
            let all: Vec<&Block> = blocks.iter().collect();
            Err(ImportError::entry(
                "--block",
                format!("there is no data block {name}; there are {}", names(&all)),
            ))
        }
        ([], None) => Err(ImportError::entry(
            format!("data_{}", blocks[0].name),
            "no sites, expected a loop_ with _atom_site_fract_x, _y and _z",
        )),
        (several, Some(_)) => Err(ImportError::entry(
            "--block",
            format!("{} data blocks have this name", several.len()),
        )),
        (several, None) => Err(ImportError::entry(
            "data blocks",
            format!(
                "{} have sites, choose one with --block: {}",
                several.len(),
                names(several)
            ),
        )),
    }
}

fn replacements(operations: &[Listed]) -> impl Iterator<Item = String> {
    operations.iter().flat_map(|listed| {
        let replaced = listed.operation.replaced.iter();
        replaced.map(|(text, value)| format!("{:?}: {text} replaced by {value}", listed.text))
    })
}

fn uncertainties(count: usize) -> Option<String> {
    (count > 0).then(|| {
        format!(
            "numbers with a standard uncertainty, like 0.1234(5): {count}; it is left out, and the number before it \
             is exact"
        )
    })
}

/// The number of atoms of each site.
fn atoms_of_sites(sites: usize, atoms: &[Atom]) -> Vec<usize> {
    let mut counts = vec![0; sites];
    atoms.iter().for_each(|atom| counts[atom.site] += 1);
    counts
}

/// A wrong atom count shows where a file counts its atoms itself.
fn wrong_multiplicities(sites: &[Site], counts: &[usize]) -> Vec<String> {
    let says = |(index, site): (usize, &Site)| {
        let (expected, found) = (site.multiplicity?, counts[index]);
        (expected != found).then(|| {
            format!(
                "warning: site {} gives {found} atoms, the file says {expected}",
                site.label
            )
        })
    };
    sites.iter().enumerate().filter_map(says).collect()
}

/// Rounded fractions off their special positions show as atoms that almost coincide.
fn near_atoms(sites: &[Site], atoms: &[Atom]) -> Vec<String> {
    let pairs = orbits::near_pairs(atoms);
    let place = |atom: &Atom| {
        let numbers = atom.position.each_ref().map(|x| about(x, 6));
        format!("{} ({})", sites[atom.site].label, numbers.join(", "))
    };
    let named = pairs.iter().take(NAMED_PAIRS).map(|&(i, j)| {
        let (a, b) = (place(&atoms[i]), place(&atoms[j]));
        format!("warning: the atoms {a} and {b} differ by no more than the written digits tell")
    });
    let mut notes: Vec<String> = named.collect();
    if !pairs.is_empty() {
        let more = if pairs.len() < PAIR_LIMIT {
            ""
        } else {
            "or more "
        };
        notes.push(format!(
            "warning: {} {more}such pairs, which stay different atoms: --snap 12, or another denominator, makes \
             rounded fractions exact; a coordinate that follows from another, like y = 2x, has to be exact in the file",
            pairs.len()
        ));
    }
    notes
}

fn counts(sites: &Sites, operations: usize, atoms: &[usize]) -> String {
    let chosen = sites.sites.len();
    let of = match chosen == sites.listed {
        true => String::new(),
        false => format!(" of {}", sites.listed),
    };
    let each = sites.sites.iter().zip(atoms).take(NAMED_SITES);
    let mut each: Vec<String> = each
        .map(|(site, n)| format!("{} {n}", site.label))
        .collect();
    if chosen > NAMED_SITES {
        each.push("…".to_owned());
    }
    format!(
        "{chosen}{of} sites, {operations} operations, {} images, {} atoms in a cell: {}",
        chosen * operations,
        atoms.iter().sum::<usize>(),
        each.join(", "),
    )
}
