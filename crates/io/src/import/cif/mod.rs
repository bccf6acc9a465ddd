//! Crystallographic information files (CIF 1.1 and 2.0).
//!
//! A cell, a list of symmetry operations and sites give a point set. docs/cif.md lists the parts that
//! are read.
//!
//! | file | does |
//! |---|---|
//! | `token` | words, with their lines |
//! | `block` | data blocks: tags and their values |
//! | `cell` | lengths and angles, as a Gram matrix over Q |
//! | `operation`, `symmetry` | operations; the list of a file, checked to be its group |
//! | `groups` | the names of the space group, compared with the list or in its place |
//! | `fit` | the cell, made invariant under the operations |
//! | `disorder` | whether the chosen sites are atoms |
//! | `columns`, `sites` | the sites of the asymmetric unit |
//! | `special` | sites near special positions |
//! | `orbits` | the atoms of a cell |
//! | `uncertainty` | free numbers with standard uncertainties, as parameters |
//! | `notes` | counts and warnings |
//!
//! Coordinates become the rationals that are written. A note names every change.

mod block;
mod cell;
mod columns;
mod disorder;
mod fit;
mod groups;
mod notes;
mod operation;
mod orbits;
mod sites;
mod special;
mod symmetry;
mod token;
mod uncertainty;

pub use super::atoms::options::{CifOptions, Special};
pub use super::atoms::select::names;

use super::ImportError;
use super::atoms::structure::{Structure, point_set};
use super::words::short;
use block::Block;
use operation::Listed;
use sites::Site;
use std::path::Path;
use token::{at_line, strip_prefix};

/// Bytes of a CIF: it is taken apart as a whole.
const CIF_LIMIT: usize = 1 << 25;

/// Whether a file is a CIF: by its name, or because it begins with `data_` after comments.
pub fn is_cif(path: &Path, text: &str) -> bool {
    if path.extension().is_some_and(|extension| {
        ["cif", "mcif"]
            .iter()
            .any(|&own| extension.eq_ignore_ascii_case(own))
    }) {
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
/// [`ImportError`] with the line: no CIF, something missing, a site near a special position, disorder.
/// Or the list of operations is no group, or does not fit the cell.
pub fn read_cif(text: &str, options: &CifOptions) -> Result<Structure, ImportError> {
    if text.len() > CIF_LIMIT {
        return Err(ImportError::TooLong {
            limit: CIF_LIMIT as u64,
        });
    }
    let blocks = block::blocks(text.trim_start_matches('\u{feff}'))?;
    let block = choose(&blocks, options.block.as_deref())?;
    check_magnetic(block)?;
    let mut cell = cell::cell(block)?;
    let (operations, named) = symmetry::operations(block, options.snap, &cell)?;
    let fitted = fit::fit(&mut cell, &operations)?;
    let mut sites = sites::sites(block, options)?;
    orbits::check_count(sites.sites.len(), operations.len())?;
    check_snapped(&sites.sites, &operations, options)?;
    let moved = special::settle(&mut sites.sites, &operations, options.special)?;
    let (atoms, merged) = orbits::atoms(&sites.sites, &operations, options.ignore_occupancy)?;
    let variation = if options.within_su {
        uncertainty::check_readable(block, &cell)?;
        Some(uncertainty::variation(
            &cell,
            &sites.sites,
            &operations,
            &atoms,
        )?)
    } else {
        None
    };

    let mut notes = Vec::new();
    if blocks.len() > 1 {
        notes.push(format!(
            "data_{}: this data block of {} is read",
            block.name,
            blocks.len()
        ));
    }
    notes.extend(named);
    notes.extend(notes::replacements(&operations));
    notes.extend(sites.notes.iter().cloned());
    match &variation {
        Some(variation) => notes.push(notes::within_uncertainties(variation.intervals.len())),
        None => notes.extend(notes::uncertainties(cell.uncertain + sites.uncertain)),
    }
    notes.extend(cell.notes.iter().cloned());
    notes.extend(fitted);
    notes.extend(moved);
    notes.extend(merged);
    notes.extend(notes::of_atoms(&sites, &operations, &atoms));
    let of_site = |atom: &orbits::Atom| &sites.sites[atom.site];
    let mut structure = Structure {
        name: block.name.to_owned(),
        points: point_set(cell.gram.clone(), atoms.iter().map(|atom| &atom.position)),
        labels: atoms
            .iter()
            .map(|atom| of_site(atom).label.clone())
            .collect(),
        elements: atoms.iter().map(|atom| of_site(atom).element).collect(),
        notes,
        variation,
    };
    structure.note_distance();
    Ok(structure)
}

/// Snapping must not take a site off its special position.
fn check_snapped(
    sites: &[Site],
    operations: &[Listed],
    options: &CifOptions,
) -> Result<(), ImportError> {
    let Some(denominator) = options.snap else {
        return Ok(());
    };
    for site in sites {
        let [before, after] =
            [&site.written, &site.position].map(|x| special::images(x, operations));
        if after > before {
            let problem = format!(
                "--snap {denominator} takes site {} from {before} to {after} images: another coordinate follows from \
                 the one that is replaced; --special moves sites onto special positions",
                site.label
            );
            return Err(at_line(site.line, problem));
        }
    }
    Ok(())
}

/// Magnetic operations are no operations of this reader.
fn check_magnetic(block: &Block) -> Result<(), ImportError> {
    let is_magnetic = ["_space_group_magn", "_space_group_symop_magn"]
        .iter()
        .any(|start| block.has_tag(start));
    if is_magnetic && !symmetry::has_operations(block) {
        return Err(ImportError::entry(
            format!("data_{}", block.name),
            "is a magnetic CIF (magCIF), whose operations with time reversal are not read; give the operations of the \
             crystal structure in _space_group_symop_operation_xyz",
        ));
    }
    Ok(())
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
        None => columns::has_sites(block),
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
        ([], None) if blocks.iter().any(columns::has_cartesian_sites) => Err(ImportError::entry(
            format!("data_{}", blocks[0].name),
            "the sites have Cartesian coordinates (_atom_site_Cartn_x) only, expected fractional ones: \
             _atom_site_fract_x, _y and _z",
        )),
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
