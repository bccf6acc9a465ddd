//! Counts and warnings about a structure, in words.

use super::operation::Listed;
use super::orbits::{self, Atom, PAIR_LIMIT};
use super::sites::{Site, Sites};
use crate::import::atoms::decimal::about;
use acutile_core::statement::counted;

/// How many sites the count names.
const NAMED_SITES: usize = 20;
/// How many pairs of near atoms a warning names.
const NAMED_PAIRS: usize = 3;

/// Warnings about the atoms, and their count.
pub fn of_atoms(sites: &Sites, operations: &[Listed], atoms: &[Atom]) -> Vec<String> {
    let each = atoms_of_sites(sites.sites.len(), atoms);
    let mut notes = wrong_multiplicities(&sites.sites, &each, operations.len());
    notes.extend(near_atoms(&sites.sites, atoms));
    notes.push(counts(sites, operations.len(), &each));
    notes
}

/// Decimals of operations that were replaced.
pub fn replacements(operations: &[Listed]) -> impl Iterator<Item = String> {
    operations.iter().flat_map(|listed| {
        let replaced = listed.operation.replaced.iter();
        replaced.map(|(text, value)| format!("{:?}: {text} replaced by {value}", listed.text))
    })
}

/// How many uncertainties were left out.
pub fn uncertainties(count: usize) -> Option<String> {
    (count > 0).then(|| {
        format!(
            "numbers with a standard uncertainty, like 0.1234(5): {count}; it is left out, and the number before it \
             is exact"
        )
    })
}

/// The free numbers that are parameters.
pub fn within_uncertainties(count: usize) -> String {
    format!("{count} free numbers take all values within their standard uncertainties")
}

/// The number of atoms of each site.
fn atoms_of_sites(sites: usize, atoms: &[Atom]) -> Vec<usize> {
    let mut counts = vec![0; sites];
    atoms.iter().for_each(|atom| counts[atom.site] += 1);
    counts
}

/// A wrong atom count shows where a file counts its atoms itself. Some programs write the
/// order of the site symmetry under the same tag.
fn wrong_multiplicities(sites: &[Site], counts: &[usize], operations: usize) -> Vec<String> {
    let says = |(index, site): (usize, &Site)| {
        let (expected, found) = (site.multiplicity?, counts[index]);
        let is_order = expected.checked_mul(found) == Some(operations);
        (expected != found && !is_order).then(|| {
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
        format!("warning: the atoms {a} and {b} differ by no more than the precision of the written digits")
    });
    let mut notes: Vec<String> = named.collect();
    if !pairs.is_empty() {
        let more = if pairs.len() < PAIR_LIMIT {
            ""
        } else {
            "or more "
        };
        notes.push(format!(
            "warning: {} {more}such pairs, which stay different atoms; --special moves sites onto special positions, and --snap 12, or \
             another denominator, makes rounded fractions exact",
            pairs.len()
        ));
    }
    notes
}

fn counts(sites: &Sites, operations: usize, atoms: &[usize]) -> String {
    let chosen = sites.sites.len();
    let of = if chosen == sites.listed {
        String::new()
    } else {
        format!(" of {}", sites.listed)
    };
    let each = sites.sites.iter().zip(atoms).take(NAMED_SITES);
    let mut each: Vec<String> = each
        .map(|(site, n)| format!("{} {n}", site.label))
        .collect();
    if chosen > NAMED_SITES {
        each.push("…".to_owned());
    }
    format!(
        "{}, {}, {}, {} in a cell: {}",
        if of.is_empty() {
            counted(chosen, "site", "sites")
        } else {
            format!("{chosen}{of} sites")
        },
        counted(operations, "operation", "operations"),
        counted(chosen * operations, "image", "images"),
        counted(atoms.iter().sum(), "atom", "atoms"),
        each.join(", "),
    )
}
