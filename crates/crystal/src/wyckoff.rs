//! Wyckoff letters: which of the tabulated sets of positions has a point.
//!
//! The tables are moyo's, those of International Tables A. A point belongs to the position whose
//! multiplicity is the number of its images and one of whose sets has one of the images, exactly.

use crate::identify::Identified;
use crate::motion::{Motion, Vector, fractional, rotated};
use malachite::Rational;
use moyo::data::{WyckoffPosition, iter_wyckoff_positions_from_hall_number};
use std::collections::BTreeSet;

/// The Wyckoff position of a point.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Wyckoff {
    /// In the conventional cell.
    pub multiplicity: usize,
    /// The letter of the International Tables.
    pub letter: char,
    /// The symbol of the site symmetry.
    pub site_symmetry: &'static str,
}

/// The Wyckoff position of a point of the cell that the group was given in.
pub fn wyckoff(identified: &Identified, point: &Vector) -> Option<Wyckoff> {
    wyckoff_of_parts(identified, std::slice::from_ref(point))
}

/// The same for p_0 + p_1 θ_1 + p_2 θ_2 + …, given by p_0, p_1, …, where 1, θ_1, … are independent over the rationals.
///
/// The group moves p_0, and turns the others. The point is in a set of positions if p_0 is, and the others are parallel to it.
pub fn wyckoff_of_parts(identified: &Identified, parts: &[Vector]) -> Option<Wyckoff> {
    let (point, others) = parts.split_first()?;
    let point = identified.standard_point(point);
    let others: Vec<Vector> = others
        .iter()
        .map(|part| identified.standard_direction(part))
        .collect();
    let images: BTreeSet<Vec<Vector>> = identified
        .standard
        .iter()
        .map(|motion: &Motion| {
            let turned = others.iter().map(|part| rotated(&motion.rotation, part));
            let moved = motion.apply(&point).map(fractional);
            std::iter::once(moved).chain(turned).collect()
        })
        .collect();
    let mut positions = iter_wyckoff_positions_from_hall_number(identified.setting.index);
    positions
        .find(|position| position.multiplicity == images.len() && has_one_of(position, &images))
        .map(|position| Wyckoff {
            multiplicity: position.multiplicity,
            letter: position.letter,
            site_symmetry: position.site_symmetry,
        })
}

fn has_one_of(position: &WyckoffPosition, images: &BTreeSet<Vec<Vector>>) -> bool {
    let Some(family) = Family::parse(position.coordinates) else {
        return false;
    };
    images.iter().any(|parts| match parts.split_first() {
        Some((point, others)) => {
            others.iter().all(|part| family.has_direction(part)) && family.has(point)
        }
        None => false,
    })
}

/// Points o + Σ c_j x_j with real x_j, modulo the lattice.
struct Family {
    origin: Vector,
    /// Independent integral vectors n with n · c_j = 0 for all j.
    normals: Vec<[i64; 3]>,
}

/// Lattice vectors by which a reduced point may have to be moved have entries of this size at most:
/// coefficients are at most 2.
const REACH: i64 = 3;

impl Family {
    /// Reads coordinates like `x,2x,1/4`.
    fn parse(text: &str) -> Option<Family> {
        let mut origin: Vector = std::array::from_fn(|_| Rational::from(0));
        let mut columns = [[0i64; 3]; 3];
        let parts: Vec<&str> = text.split(',').collect();
        if parts.len() != 3 {
            return None;
        }
        for (row, part) in parts.iter().enumerate() {
            let compact: String = part.split_ascii_whitespace().collect();
            let signed = compact.replace('-', "+-");
            for term in signed.split('+').filter(|term| !term.is_empty()) {
                match term.strip_suffix(['x', 'y', 'z']) {
                    Some(factor) => {
                        let axis = "xyz".find(&term[term.len() - 1..])?;
                        columns[axis][row] += match factor {
                            "" => 1,
                            "-" => -1,
                            factor => factor.parse().ok()?,
                        };
                    }
                    None => origin[row] += term.parse::<Rational>().ok()?,
                }
            }
        }
        Some(Family {
            origin,
            normals: normals(&columns),
        })
    }

    /// Whether a vector is parallel to the set.
    fn has_direction(&self, vector: &Vector) -> bool {
        self.normals.iter().all(|normal| dot(normal, vector) == 0)
    }

    fn has(&self, point: &Vector) -> bool {
        let step: Vector = std::array::from_fn(|k| &point[k] - &self.origin[k]);
        let mut values = Vec::new();
        for normal in &self.normals {
            let value = dot(normal, &step);
            let Ok(value) = i64::try_from(&value) else {
                return false;
            };
            values.push(value);
        }
        let range = -REACH..=REACH;
        range.clone().any(|x| {
            range.clone().any(|y| {
                range.clone().any(|z| {
                    let vector = [x, y, z];
                    self.normals.iter().zip(&values).all(|(normal, value)| {
                        value + (0..3).map(|k| normal[k] * vector[k]).sum::<i64>() == 0
                    })
                })
            })
        })
    }
}

fn dot(normal: &[i64; 3], vector: &Vector) -> Rational {
    let terms = normal.iter().zip(vector);
    terms.fold(Rational::from(0), |sum, (n, x)| {
        sum + Rational::from(*n) * x
    })
}

/// Independent vectors with entries of at most 2 in size that are normal to some columns.
fn normals(columns: &[[i64; 3]; 3]) -> Vec<[i64; 3]> {
    let size = |v: &[i64; 3]| v.iter().map(|x| x * x).sum::<i64>();
    let range = -2..=2i64;
    let mut all = Vec::new();
    for x in range.clone() {
        for y in range.clone() {
            for z in range.clone() {
                let vector = [x, y, z];
                let is_normal = columns
                    .iter()
                    .all(|column| (0..3).map(|k| column[k] * vector[k]).sum::<i64>() == 0);
                if is_normal && vector > [0; 3] {
                    all.push(vector);
                }
            }
        }
    }
    all.sort_by_key(size);
    let mut chosen: Vec<[i64; 3]> = Vec::new();
    for vector in all {
        let is_independent = match chosen[..] {
            [] => true,
            [a] => cross(a, vector) != [0; 3],
            [a, b] => {
                let normal = cross(a, b);
                (0..3).map(|k| normal[k] * vector[k]).sum::<i64>() != 0
            }
            _ => false,
        };
        if is_independent {
            chosen.push(vector);
        }
    }
    chosen
}

fn cross(a: [i64; 3], b: [i64; 3]) -> [i64; 3] {
    std::array::from_fn(|k| {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        a[i] * b[j] - a[j] * b[i]
    })
}
