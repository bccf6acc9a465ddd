//! The atoms of a cell: the images of the sites under the operations, merged where they
//! are equal modulo the lattice, exactly.

use super::operation::Listed;
use super::operation::fractional;
use super::sites::Site;
use super::token::at_line;
use crate::import::ImportError;
use malachite::Rational;
use malachite::base::num::conversion::traits::RoundingFrom;
use malachite::base::rounding_modes::RoundingMode::Nearest;
use std::collections::HashMap;

/// Images, before merging.
const IMAGE_LIMIT: usize = 200_000;
/// The number of near pairs after which the search ends.
pub const PAIR_LIMIT: usize = 1000;
/// No coordinate is taken to be written less finely than this when near images are
/// looked for: an atom is larger.
const COARSEST: f64 = 0.01;

/// An atom of the cell.
pub struct Atom {
    /// 0 <= x < 1
    pub position: [Rational; 3],
    /// Index of its site.
    pub site: usize,
    /// Index of the operation that takes the site to it.
    pub operation: usize,
    /// The distance within which the intended value of each coordinate lies, by the written digits.
    error: [f64; 3],
}

/// Whether there are too many images.
///
/// # Errors
/// There are.
pub fn check_count(sites: usize, operations: usize) -> Result<(), ImportError> {
    if sites.saturating_mul(operations) <= IMAGE_LIMIT {
        return Ok(());
    }
    let problem =
        format!("{sites} sites under {operations} operations, the limit is {IMAGE_LIMIT} images");
    Err(ImportError::limit("sites", problem))
}

/// The atoms, those of the first site first, in the order of the operations; and notes on sites
/// that are images of others.
///
/// # Errors
/// Two sites have an atom at the same place, unless they have the same element or `merge_sites`
/// is set.
pub fn atoms(
    sites: &[Site],
    operations: &[Listed],
    merge_sites: bool,
) -> Result<(Vec<Atom>, Vec<String>), ImportError> {
    let mut atoms: Vec<Atom> = Vec::new();
    let mut places: HashMap<[Rational; 3], usize> = HashMap::new();
    let mut repeated = Vec::new();
    for (index, site) in sites.iter().enumerate() {
        for (operation, listed) in operations.iter().enumerate() {
            let position = listed.operation.apply(&site.position).map(fractional);
            let Some(&other) = places.get(&position) else {
                places.insert(position.clone(), index);
                let error = error(site, listed);
                atoms.push(Atom {
                    position,
                    site: index,
                    operation,
                    error,
                });
                continue;
            };
            if other != index {
                repeated.push((index, other));
            }
        }
    }
    repeated.dedup();
    let notes = repeated.into_iter().map(|(index, other)| {
        let [site, other] = [&sites[index], &sites[other]];
        let is_same_element = site.element.is_some() && site.element == other.element;
        if !is_same_element && !merge_sites {
            return Err(same_place(site, other));
        }
        Ok(format!(
            "site {} is an image of site {}, and adds no atom",
            site.label, other.label
        ))
    });
    Ok((atoms, notes.collect::<Result<_, _>>()?))
}

fn same_place(site: &Site, other: &Site) -> ImportError {
    let problem = format!(
        "site {} has an atom at the place of one of site {} (line {}): disorder cannot be a point set; choose sites with \
         --only, or merge them with --ignore-occupancy",
        site.label, other.label, other.line
    );
    at_line(site.line, problem)
}

/// Half a unit of each written coordinate, as far as the image depends on it.
fn error(site: &Site, listed: &Listed) -> [f64; 3] {
    let units = site
        .units
        .each_ref()
        .map(|unit| approximate(unit).min(COARSEST));
    listed.operation.rotation.map(|row| {
        let terms = row
            .iter()
            .zip(units)
            .map(|(&n, unit)| n.abs() as f64 * unit / 2.0);
        terms.sum()
    })
}

fn approximate(x: &Rational) -> f64 {
    f64::rounding_from(x, Nearest).0
}

/// Pairs of atoms that are nearer to each other than the written digits tell apart, found in
/// double precision: they warn and decide nothing. No more than about [`PAIR_LIMIT`].
pub fn near_pairs(atoms: &[Atom]) -> Vec<(usize, usize)> {
    let largest = atoms.iter().flat_map(|atom| atom.error).fold(0.0, f64::max);
    if largest == 0.0 {
        return Vec::new();
    }
    let cells = (0.5 / largest).floor().clamp(1.0, 1024.0) as i32;
    let positions: Vec<[f64; 3]> = atoms
        .iter()
        .map(|atom| atom.position.each_ref().map(approximate))
        .collect();
    let key = |x: [f64; 3]| x.map(|x| ((x * f64::from(cells)) as i32).rem_euclid(cells));
    let mut grid: HashMap<[i32; 3], Vec<usize>> = HashMap::new();
    let mut pairs = Vec::new();
    for (i, &position) in positions.iter().enumerate() {
        for place in neighbours(key(position), cells) {
            let near = grid.get(&place).into_iter().flatten();
            pairs.extend(
                near.filter(|&&j| are_near(atoms, &positions, i, j))
                    .map(|&j| (j, i)),
            );
        }
        if pairs.len() >= PAIR_LIMIT {
            break;
        }
        grid.entry(key(position)).or_default().push(i);
    }
    pairs.sort_unstable();
    pairs
}

fn neighbours(key: [i32; 3], cells: i32) -> Vec<[i32; 3]> {
    let mut places: Vec<[i32; 3]> = (0..27)
        .map(|n| {
            let step = [n / 9 - 1, n / 3 % 3 - 1, n % 3 - 1];
            std::array::from_fn(|k| (key[k] + step[k]).rem_euclid(cells))
        })
        .collect();
    places.sort_unstable();
    places.dedup();
    places
}

fn are_near(atoms: &[Atom], positions: &[[f64; 3]], i: usize, j: usize) -> bool {
    (0..3).all(|k| {
        let difference = positions[i][k] - positions[j][k];
        let distance = (difference - difference.round()).abs();
        distance <= (atoms[i].error[k] + atoms[j].error[k]) * 1.000_001
    })
}
