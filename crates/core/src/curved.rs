//! Triangles and tetrahedra of second order: whether the Jacobian is positive everywhere.
//!
//! Let b_ii be the corners and b_ij = 2 m_ij - (b_ii + b_jj) / 2 for the middle nodes m_ij. Then x(λ) =
//! Σ λ_i λ_j b_ij, and its derivative in the direction e_k - e_0 is 2 Σ λ_i d_k^i with d_k^i = b_ik - b_i0.
//! So the Jacobian of a tetrahedron is 8 Σ λ_i λ_j λ_l det(d_1^i, d_2^j, d_3^l), a cubic polynomial. Its
//! Bernstein coefficients are the means of these determinants over the orders of i, j, l. If all are
//! positive, so is the Jacobian; those at the corners are its values there. A triangle has 4 Σ λ_i λ_j
//! det(d_1^i, d_2^j), of degree two. (A. Johnen, J.-F. Remacle, C. Geuzaine, "Geometrical validity of
//! curvilinear finite elements", J. Comput. Phys. 233, 2013.)

use acutile_exact::geometry::linear;
use acutile_exact::number::Number;
use malachite::Rational;
use std::collections::BTreeMap;

/// The nodes of an element: the corners, then the nodes on the edges 01, 12 and 02, and on 03, 13 and
/// 23 of a tetrahedron.
#[derive(Clone, Debug, PartialEq)]
pub enum Element {
    /// In the plane.
    Triangle([[f64; 2]; 6]),
    /// In space.
    Tetrahedron([[f64; 3]; 10]),
}

/// The validity of an element.
#[derive(Clone, Debug, PartialEq)]
pub enum Validity {
    /// The Jacobian is positive everywhere.
    Valid,
    /// The Jacobian has this value, zero or less, at a corner.
    Invalid {
        /// The corner, from 0.
        corner: usize,
        /// The Jacobian there.
        jacobian: Rational,
    },
    /// Positive at the corners, but this Bernstein coefficient is not.
    Undecided {
        /// The smallest Bernstein coefficient, zero or less.
        coefficient: Rational,
    },
}

/// The number of the edge between two corners; the diagonal is not used.
const EDGES: [[usize; 4]; 4] = [[6, 0, 2, 3], [0, 6, 1, 4], [2, 1, 6, 5], [3, 4, 5, 6]];

impl Element {
    /// Exchanges the last two corners, and the middle nodes of the edges at them.
    pub fn turn(&mut self) {
        match self {
            Element::Triangle(nodes) => {
                nodes.swap(1, 2);
                nodes.swap(3, 5);
            }
            Element::Tetrahedron(nodes) => {
                for (a, b) in [(2, 3), (5, 8), (6, 7)] {
                    nodes.swap(a, b);
                }
            }
        }
    }

    /// Whether the Jacobian is positive.
    pub fn validity(&self) -> Validity {
        match self {
            Element::Triangle(nodes) => validity(nodes),
            Element::Tetrahedron(nodes) => validity(nodes),
        }
    }
}

fn validity<const D: usize, const N: usize>(nodes: &[[f64; D]; N]) -> Validity {
    if is_positive_in_doubles(nodes) {
        return Validity::Valid;
    }
    let exact = |x: f64| Rational::try_from(x).unwrap_or_default();
    let coefficients = coefficients(&nodes.map(|node| node.map(exact)));
    for corner in 0..=D {
        let jacobian = &coefficients[&[corner; D]];
        if *jacobian <= 0 {
            return Validity::Invalid {
                corner,
                jacobian: jacobian.clone(),
            };
        }
    }
    match coefficients.into_values().min() {
        Some(coefficient) if coefficient <= 0 => Validity::Undecided { coefficient },
        _ => Validity::Valid,
    }
}

/// The Bernstein coefficients of the Jacobian, by i <= j or i <= j <= l: 6 or 20.
pub fn coefficients<const D: usize, const N: usize>(
    nodes: &[[Rational; D]; N],
) -> BTreeMap<[usize; D], Rational> {
    let control = |i: usize, j: usize| -> [Rational; D] {
        if i == j {
            return nodes[i].clone();
        }
        let middle = &nodes[D + 1 + EDGES[i][j]];
        let two = Rational::from(2);
        std::array::from_fn(|k| &middle[k] * &two - (&nodes[i][k] + &nodes[j][k]) / &two)
    };
    let step = |i: usize, k: usize| -> [Number; D] {
        let (a, b) = (control(i, k), control(i, 0));
        std::array::from_fn(|c| Number::from(&a[c] - &b[c]))
    };
    let steps: Vec<[[Number; D]; D]> = (0..=D)
        .map(|i| std::array::from_fn(|k| step(i, k + 1)))
        .collect();
    let mut sums: BTreeMap<[usize; D], (Rational, u32)> = BTreeMap::new();
    for choice in choices::<D>() {
        let rows: [[Number; D]; D] = std::array::from_fn(|k| steps[choice[k]][k].clone());
        let value = linear::determinant(&rows);
        let value = value.to_rational().cloned().unwrap_or_default();
        let sum = sums.entry(sorted(choice)).or_default();
        sum.0 += value;
        sum.1 += 1;
    }
    let scale = Rational::from(1u32 << D);
    let mean = |(sum, count): (Rational, u32)| sum * &scale / Rational::from(count);
    sums.into_iter()
        .map(|(key, sum)| (key, mean(sum)))
        .collect()
}

/// All choices of D of the D + 1 corners, with order and repetition.
fn choices<const D: usize>() -> impl Iterator<Item = [usize; D]> {
    let count = (D + 1).pow(D as u32);
    (0..count).map(|n| std::array::from_fn(|k| n / (D + 1).pow(k as u32) % (D + 1)))
}

fn sorted<const D: usize>(mut choice: [usize; D]) -> [usize; D] {
    choice.sort_unstable();
    choice
}

/// Whether doubles know that all coefficients are positive. An entry of a row comes from five coordinates
/// by seven roundings, so its error is below 2^-48 of the largest coordinate c. A determinant of D rows of
/// size at most 7 c has an error below 2^-38 c^D, and so has a mean of six.
fn is_positive_in_doubles<const D: usize, const N: usize>(nodes: &[[f64; D]; N]) -> bool {
    let largest = nodes
        .as_flattened()
        .iter()
        .fold(0.0f64, |most, x| most.max(x.abs()));
    let control = |i: usize, j: usize| -> [f64; D] {
        if i == j {
            return nodes[i];
        }
        let middle = &nodes[D + 1 + EDGES[i][j]];
        std::array::from_fn(|k| 2.0 * middle[k] - (nodes[i][k] + nodes[j][k]) / 2.0)
    };
    let mut sums = BTreeMap::new();
    for choice in choices::<D>() {
        let rows: [[f64; D]; D] = std::array::from_fn(|k| {
            let (a, b) = (control(choice[k], k + 1), control(choice[k], 0));
            std::array::from_fn(|c| a[c] - b[c])
        });
        let sum: &mut (f64, f64) = sums.entry(sorted(choice)).or_default();
        sum.0 += linear::determinant(&rows);
        sum.1 += 1.0;
    }
    let margin = largest.powi(D as i32) * 2f64.powi(-36);
    let is_normal = margin.is_normal() && largest < 1e90;
    is_normal && sums.values().all(|(sum, count)| sum / count > margin)
}
