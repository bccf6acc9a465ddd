//! Tetrahedra of second order: whether the Jacobian is positive everywhere.
//!
//! Let b_ii be the corners and b_ij = 2 m_ij - (b_ii + b_jj) / 2 for the middle nodes m_ij. Then x(λ) =
//! Σ λ_i λ_j b_ij, and its derivative in the direction e_k - e_0 is 2 Σ λ_i d_k^i with d_k^i = b_ik - b_i0.
//! So the Jacobian is 8 Σ λ_i λ_j λ_l det(d_1^i, d_2^j, d_3^l), a cubic polynomial. Its Bernstein
//! coefficients are the means of these determinants over the orders of i, j, l. If all are positive,
//! so is the Jacobian; those at the corners are its values there. (A. Johnen, J.-F. Remacle, C.
//! Geuzaine, "Geometrical validity of curvilinear finite elements", J. Comput. Phys. 233, 2013.)

use acutile_exact::geometry::linear;
use acutile_exact::number::Number;
use malachite::Rational;
use std::collections::BTreeMap;

/// Four corners, then the nodes on the edges 01, 12, 02, 03, 13, 23.
pub type Nodes = [[f64; 3]; 10];

/// What is known of an element.
#[derive(Clone, Debug, PartialEq)]
pub enum Validity {
    /// The Jacobian is positive everywhere.
    Valid,
    /// The Jacobian has this value, zero or less, at a corner.
    Invalid { corner: usize, jacobian: Rational },
    /// Positive at the corners, but this Bernstein coefficient is not.
    Undecided { coefficient: Rational },
}

/// The middle node between two corners.
const MIDDLES: [[usize; 4]; 4] = [[0, 4, 6, 7], [4, 1, 5, 8], [6, 5, 2, 9], [7, 8, 9, 3]];

/// Whether the Jacobian of an element is positive.
pub fn validity(nodes: &Nodes) -> Validity {
    if is_positive_in_doubles(nodes) {
        return Validity::Valid;
    }
    let exact = |x: f64| Rational::try_from(x).unwrap_or_default();
    let nodes = nodes.map(|node| node.map(exact));
    let coefficients = coefficients(&nodes);
    for (corner, key) in (0..4).map(|k| (k, [k; 3])) {
        let jacobian = &coefficients[&key];
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

/// The 20 Bernstein coefficients of the Jacobian, by i <= j <= l.
pub fn coefficients(nodes: &[[Rational; 3]; 10]) -> BTreeMap<[usize; 3], Rational> {
    let control = |i: usize, j: usize| -> [Rational; 3] {
        let middle = &nodes[MIDDLES[i][j]];
        if i == j {
            return middle.clone();
        }
        let two = Rational::from(2);
        std::array::from_fn(|k| &middle[k] * &two - (&nodes[i][k] + &nodes[j][k]) / &two)
    };
    let step = |i: usize, k: usize| -> [Number; 3] {
        let (a, b) = (control(i, k), control(i, 0));
        std::array::from_fn(|c| Number::from(&a[c] - &b[c]))
    };
    let steps: Vec<[[Number; 3]; 3]> = (0..4)
        .map(|i| std::array::from_fn(|k| step(i, k + 1)))
        .collect();
    let mut sums: BTreeMap<[usize; 3], (Rational, u32)> = BTreeMap::new();
    for triple in (0..64).map(|n| [n / 16, n / 4 % 4, n % 4]) {
        let rows: [[Number; 3]; 3] = std::array::from_fn(|k| steps[triple[k]][k].clone());
        let value = linear::determinant(&rows);
        let value = value.to_rational().cloned().unwrap_or_default();
        let mut key = triple;
        key.sort_unstable();
        let sum = sums.entry(key).or_default();
        sum.0 += value;
        sum.1 += 1;
    }
    let mean = |(sum, count): (Rational, u32)| sum * Rational::from(8) / Rational::from(count);
    sums.into_iter()
        .map(|(key, sum)| (key, mean(sum)))
        .collect()
}

/// Whether doubles know that all coefficients are positive. An entry of a row comes from five
/// coordinates by seven roundings, so its error is below 2^-48 of the largest coordinate c; a
/// determinant of rows of size at most 7 c has an error below 2^-38 c^3, and so has a mean of six.
fn is_positive_in_doubles(nodes: &Nodes) -> bool {
    let largest = nodes
        .as_flattened()
        .iter()
        .fold(0.0f64, |most, x| most.max(x.abs()));
    let control = |i: usize, j: usize| -> [f64; 3] {
        let middle = &nodes[MIDDLES[i][j]];
        if i == j {
            return *middle;
        }
        std::array::from_fn(|k| 2.0 * middle[k] - (nodes[i][k] + nodes[j][k]) / 2.0)
    };
    let mut sums = BTreeMap::new();
    for triple in (0..64).map(|n| [n / 16, n / 4 % 4, n % 4]) {
        let rows: [[f64; 3]; 3] = std::array::from_fn(|k| {
            let (a, b) = (control(triple[k], k + 1), control(triple[k], 0));
            std::array::from_fn(|c| a[c] - b[c])
        });
        let mut key: [usize; 3] = triple;
        key.sort_unstable();
        let sum: &mut (f64, f64) = sums.entry(key).or_default();
        sum.0 += linear::determinant(&rows);
        sum.1 += 1.0;
    }
    let margin = largest.powi(3) * 2f64.powi(-36);
    let is_normal = margin.is_normal() && largest < 1e90;
    is_normal && sums.values().all(|(sum, count)| sum / count > margin)
}
