//! The numbers of a CIF that have standard uncertainties, as parameters of a family.
//!
//! A coordinate of a site is free if it has an uncertainty and the operations that keep the site leave it
//! free. The coordinates x and 2x are one parameter, whether or not 2x is written with an uncertainty. A
//! parameter ranges over its written value plus and minus the uncertainty. Where two coordinates depend on
//! one parameter, only the interval of the one counts. So the box contains all coordinates that are within
//! the uncertainties of the file.
//!
//! Lengths count by their quotients with the first one, because similar cells have the same angles. An
//! angle with an uncertainty counts by its cosine, in a rational interval that contains its cosines.
//! Numbers without an uncertainty are exact.

use super::block::Block;
use super::cell::{Cell, gram};
use super::operation::Listed;
use super::operation::{Rotation, fractional};
use super::orbits::Atom;
use super::sites::Site;
use crate::import::ImportError;
use crate::import::atoms::decimal::Decimal;
use crate::import::atoms::structure::{Interval, Variation};
use acutile_exact::geometry::RingElement;
use acutile_exact::geometry::space::null_space;
use acutile_exact::number::Number;
use acutile_exact::polynomial::{MOST_PARAMETERS, Polynomial};
use malachite::Rational;
use std::collections::BTreeSet;

type Gram = [[Polynomial; 3]; 3];

/// The variation of a structure.
///
/// # Errors
/// No number is free, too many are, or the free numbers of the cell do not keep its symmetry.
pub fn variation(
    cell: &Cell,
    sites: &[Site],
    operations: &[Listed],
    atoms: &[Atom],
) -> Result<Variation, ImportError> {
    let mut free = Free::default();
    let gram = free.cell(cell, operations)?;
    let positions: Vec<Option<[Polynomial; 3]>> = sites
        .iter()
        .enumerate()
        .map(|(index, site)| {
            let has_atoms = atoms.iter().any(|atom| atom.site == index);
            has_atoms.then(|| free.site(site, operations))
        })
        .collect();
    let count = free.intervals.len();
    if !(1..=MOST_PARAMETERS).contains(&count) {
        return Err(refusal(count));
    }
    let image = |atom: &Atom| {
        let listed = &operations[atom.operation];
        let position = positions[atom.site].as_ref();
        position.map(|position| moved(listed, &sites[atom.site], position))
    };
    let points: Option<Vec<[Polynomial; 3]>> = atoms.iter().map(image).collect();
    Ok(Variation {
        intervals: free.intervals,
        gram,
        points: points.unwrap_or_default(),
    })
}

/// Refuses uncertainties that are not read, and lengths that may be zero.
///
/// # Errors
/// A tag of its own for an uncertainty, or a length that is not more than its uncertainty.
pub fn check_readable(block: &Block, cell: &Cell) -> Result<(), ImportError> {
    if let Some(tag) = block.separate_uncertainty() {
        let problem = format!(
            "{tag} gives uncertainties apart from their numbers, which is not read; write them as 0.0629(3)"
        );
        return Err(ImportError::entry("--within-su", problem));
    }
    let may_vanish = |length: &&Decimal| {
        length
            .uncertainty
            .as_ref()
            .is_some_and(|su| *su >= length.value)
    };
    match cell.lengths.iter().find(may_vanish) {
        Some(_) => Err(ImportError::entry(
            "--within-su",
            "a length of the cell is not more than its uncertainty, so that there may be no cell"
                .to_owned(),
        )),
        None => Ok(()),
    }
}

fn refusal(count: usize) -> ImportError {
    let problem = match count {
        0 => "no number with a standard uncertainty, like 0.0629(3), is left free by the symmetry"
            .to_owned(),
        _ => format!(
            "{count} numbers with standard uncertainties are free, expected at most {MOST_PARAMETERS}; leave sites \
             out with --except, or delete uncertainties"
        ),
    };
    ImportError::entry("--within-su", problem)
}

#[derive(Default)]
struct Free {
    intervals: Vec<Interval>,
}

impl Free {
    /// A new parameter. Too many are counted, and refused at the end.
    fn parameter(&mut self, name: String, low: Rational, high: Rational) -> Polynomial {
        let index = self.intervals.len();
        let is_taken = |name: &str| self.intervals.iter().any(|other| other.name == name);
        let name = if is_taken(&name) {
            format!("{}_{index}", &name[..name.len().min(12)])
        } else {
            name
        };
        self.intervals.push(Interval { name, low, high });
        if index < MOST_PARAMETERS {
            Polynomial::parameter(index)
        } else {
            Polynomial::zero()
        }
    }

    /// The Gram matrix over the square of the first length.
    fn cell(&mut self, cell: &Cell, operations: &[Listed]) -> Result<Gram, ImportError> {
        let lengths = [&cell.lengths[0], &cell.lengths[1], &cell.lengths[2]];
        if cell.gram != gram(lengths, &cell.cosines) {
            return Err(cell_refusal("are replaced by a mean under the operations"));
        }
        let classes = classes(operations);
        let mut quotients: Vec<Polynomial> = vec![constant(&Rational::from(1))];
        for k in 1..3 {
            let quotient = if classes[k] < k {
                quotients[classes[k]].clone()
            } else {
                self.quotient(cell, k)
            };
            quotients.push(quotient);
        }
        let cosines = self.cosines(cell, operations);
        let gram: Gram = std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                let product = quotients[i].times(&quotients[j]);
                if i == j {
                    product
                } else {
                    product.times(&cosines[3 - i - j])
                }
            })
        });
        let keeps = |listed: &Listed| transformed(&listed.operation.rotation, &gram) == gram;
        if operations.iter().all(keeps) {
            Ok(gram)
        } else {
            Err(cell_refusal(
                "cannot vary on their own under the operations",
            ))
        }
    }

    /// The length k over the first one.
    fn quotient(&mut self, cell: &Cell, k: usize) -> Polynomial {
        let [first, length] = [0, k].map(|k| &cell.lengths[k]);
        let [low, high] = [first, length].map(|length| {
            let su = length.uncertainty.clone().unwrap_or_default();
            (&length.value - &su, &length.value + su)
        });
        let (least, most) = (&high.0 / &low.1, &high.1 / &low.0);
        if least == most {
            constant(&least)
        } else {
            self.parameter(format!("{}_over_a", ["a", "b", "c"][k]), least, most)
        }
    }

    /// Cosines that the operations take to each other are one, up to the sign. One that they take to its
    /// negative is zero: its angle is 90 degrees, and an uncertainty does not count.
    fn cosines(&mut self, cell: &Cell, operations: &[Listed]) -> Vec<Polynomial> {
        let mut cosines: Vec<Polynomial> = Vec::new();
        for k in 0..3 {
            let images: Vec<(usize, i64)> = (0..=k)
                .flat_map(|other| signs(operations, other, k).map(move |sign| (other, sign)))
                .collect();
            let is_right = images
                .iter()
                .any(|(other, sign)| images.contains(&(*other, -sign)));
            let cosine = match (images.first(), &cell.cosine_ranges[k]) {
                _ if is_right => Polynomial::zero(),
                (Some((other, sign)), _) if *other < k => {
                    cosines[*other].times(&cosines[*other].integer(*sign))
                }
                (_, Some((low, high))) => {
                    let name = format!("cos_{}", ["alpha", "beta", "gamma"][k]);
                    self.parameter(name, low.clone(), high.clone())
                }
                (_, None) => constant(&cell.cosines[k]),
            };
            cosines.push(cosine);
        }
        cosines
    }

    /// The coordinates of a site. With the rotations R of the operations that keep it, displacements d have
    /// R d = d. Coordinates with an uncertainty become free before others, x before y and z. A free one without
    /// an uncertainty is exact; one that depends on another follows it.
    fn site(&mut self, site: &Site, operations: &[Listed]) -> [Polynomial; 3] {
        let is_exact = |k: &usize| site.uncertainties[*k] == 0;
        // Unknowns are eliminated from the first on.
        let mut order: Vec<usize> = (0..3).rev().collect();
        order.sort_by_key(|k| !is_exact(k));
        let mut rows: Vec<Vec<Number>> = Vec::new();
        for listed in operations.iter().filter(|listed| keeps(listed, site)) {
            let rotation = &listed.operation.rotation;
            let row = |k: usize| {
                order
                    .iter()
                    .map(move |&j| number(rotation[k][j] - i64::from(j == k)))
            };
            rows.extend((0..3).map(|k| row(k).collect()));
        }
        let space = null_space(rows, 3);
        let mut position = site.position.each_ref().map(constant);
        for (free, vector) in space.free.iter().zip(&space.basis) {
            let k = order[*free];
            if is_exact(&k) {
                continue;
            }
            let (value, su) = (&site.written[k], &site.uncertainties[k]);
            let parameter = self.parameter(name(k, &site.label), value - su, value + su);
            let change = parameter.minus(&constant(&site.position[k]));
            for (entry, &j) in vector.iter().zip(&order) {
                let change = change.times(&Polynomial::constant(entry.clone()));
                position[j] = position[j].plus(&change);
            }
        }
        position
    }
}

fn cell_refusal(problem: &str) -> ImportError {
    ImportError::entry(
        "--within-su",
        format!("the lengths and angles of the cell {problem}; delete their uncertainties"),
    )
}

fn number(n: i64) -> Number {
    Number::from(Rational::from(n))
}

fn constant(value: &Rational) -> Polynomial {
    Polynomial::constant(Number::from(value.clone()))
}

/// `x_fe1`
fn name(axis: usize, label: &str) -> String {
    let label = label.to_ascii_lowercase();
    let usual = label.chars().filter(|c| c.is_ascii_alphanumeric());
    let label: String = usual.take(10).collect();
    format!("{}_{label}", ["x", "y", "z"][axis])
}

/// For each axis the first one that the operations mix with it.
fn classes(operations: &[Listed]) -> [usize; 3] {
    let mixed = |i: usize, j: usize| {
        let mut rotations = operations.iter().map(|listed| &listed.operation.rotation);
        rotations.any(|r| r[i][j] != 0 || r[j][i] != 0)
    };
    let mut classes = [0, 1, 2];
    for _ in 0..2 {
        for k in 1..3 {
            for other in 0..k {
                if mixed(other, k) {
                    let class = classes[k].min(classes[other]);
                    (classes[k], classes[other]) = (class, class);
                }
            }
        }
    }
    classes
}

/// The signs with which operations take the cosine of one angle to that of another one. Such an
/// operation takes the axes of the first to multiples of the axes of the second.
fn signs(operations: &[Listed], one: usize, other: usize) -> impl Iterator<Item = i64> {
    let axes = |angle: usize| (0..3).filter(move |k| *k != angle);
    let sign = move |listed: &Listed| {
        let rotation: &Rotation = &listed.operation.rotation;
        let images = axes(one).map(|column| {
            let entries = (0..3).filter(|row| rotation[*row][column] != 0);
            let entries: Vec<usize> = entries.collect();
            (entries.len() == 1).then(|| (entries[0], rotation[entries[0]][column].signum()))
        });
        let mut images: Vec<(usize, i64)> = images.flatten().collect();
        images.sort_unstable();
        let is_there = images.iter().map(|(row, _)| *row).eq(axes(other));
        is_there.then(|| images.iter().map(|(_, sign)| sign).product())
    };
    let found: BTreeSet<i64> = operations.iter().filter_map(sign).collect();
    found.into_iter()
}

/// Whether the image of a site is the site, up to a lattice vector.
fn keeps(listed: &Listed, site: &Site) -> bool {
    let place = |x: &[Rational; 3]| x.clone().map(fractional);
    place(&listed.operation.apply(&site.position)) == place(&site.position)
}

/// The image of a site, moved into the cell as its value is.
fn moved(listed: &Listed, site: &Site, position: &[Polynomial; 3]) -> [Polynomial; 3] {
    let image = listed.operation.apply(&site.position);
    std::array::from_fn(|i| {
        let shift = fractional(image[i].clone()) - &image[i];
        let start = constant(&(&listed.operation.translation[i] + shift));
        let terms = position.iter().zip(listed.operation.rotation[i]);
        terms.fold(start, |sum, (x, n)| sum.plus(&x.times(&x.integer(n))))
    })
}

/// Rᵀ G R
fn transformed(rotation: &Rotation, gram: &Gram) -> Gram {
    std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            let mut sum = Polynomial::zero();
            for k in 0..3 {
                for l in 0..3 {
                    let entry = &gram[k][l];
                    sum = sum.plus(&entry.times(&entry.integer(rotation[k][i] * rotation[l][j])));
                }
            }
            sum
        })
    })
}
