//! The shortest distance between atoms of a crystal structure.
//!
//! Let d be the shortest distance of n points in a cell of volume V. Spheres of diameter d around them
//! do not overlap, so n d³ / √2 <= V (the densest packing, Hales 2005). All pairs within this bound
//! are compared: in doubles first, and exactly where doubles do not decide.

use malachite::Rational;
use malachite::base::num::conversion::traits::RoundingFrom;
use malachite::base::rounding_modes::RoundingMode::Nearest;
use std::collections::HashMap;

type Vector = [Rational; 3];
type Gram = [[Rational; 3]; 3];

/// A pair of atoms and their distance.
pub struct Shortest {
    /// Indices of the atoms; equal if an atom is nearest to its own translate.
    pub atoms: (usize, usize),
    /// Exactly.
    pub squared: Rational,
}

/// Pairs whose squared distances differ by less than this part are compared exactly.
const CLOSE: f64 = 1e-9;
/// Boxes of the grid in one direction at most.
const BOXES: f64 = 64.0;
/// The most boxes of the grid that are visited. A cell that needs more is too skewed.
const WORK: f64 = 1e8;

/// The shortest distance in the point set, or `None` for a cell that is too skewed.
pub fn shortest(gram: &Gram, points: &[Vector]) -> Option<Shortest> {
    let metric = gram.each_ref().map(|row| row.each_ref().map(approximate));
    let volume = determinant(&metric).sqrt();
    let bound = (std::f64::consts::SQRT_2 * volume / points.len() as f64).cbrt() * 1.001;
    let places: Vec<[f64; 3]> = points
        .iter()
        .map(|point| point.each_ref().map(approximate))
        .collect();
    let grid = Grid::new(&metric, &places, bound)?;
    let mut best: Option<Shortest> = None;
    let mut best_double = bound * bound;
    grid.pairs(&places, |pair, shift| {
        let step =
            std::array::from_fn(|k| places[pair.1][k] + f64::from(shift[k]) - places[pair.0][k]);
        let squared = norm(&metric, &step);
        if squared > best_double * (1.0 + CLOSE) {
            return;
        }
        let exact = exact_norm(gram, &difference(&points[pair.0], &points[pair.1], shift));
        if best.as_ref().is_none_or(|best| exact < best.squared) {
            best_double = squared;
            best = Some(Shortest {
                atoms: pair,
                squared: exact,
            });
        }
    });
    best
}

/// The points by boxes of the cell, as wide as the bound or wider.
struct Grid {
    boxes: [i32; 3],
    /// How many boxes away a point within the bound is at most.
    reach: [i32; 3],
    members: HashMap<[i32; 3], Vec<usize>>,
}

impl Grid {
    fn new(metric: &[[f64; 3]; 3], places: &[[f64; 3]], bound: f64) -> Option<Grid> {
        // The k-th coordinate changes at most by √(G^-1)_kk for each unit of length.
        let widths = inverse_diagonal(metric).map(|x| x.sqrt() * bound);
        if !widths.iter().all(|width| width.is_finite() && *width > 0.0) {
            return None;
        }
        let boxes = widths.map(|width| (1.0 / width).floor().clamp(1.0, BOXES) as i32);
        let reach = std::array::from_fn(|k| (widths[k] * f64::from(boxes[k])).ceil());
        let around = reach.iter().map(|reach: &f64| 2.0 * reach + 1.0);
        if around.product::<f64>() * places.len() as f64 > WORK {
            return None;
        }
        let reach = reach.map(|reach| reach as i32);
        let mut members: HashMap<[i32; 3], Vec<usize>> = HashMap::new();
        for (index, place) in places.iter().enumerate() {
            members
                .entry(box_of(place, &boxes))
                .or_default()
                .push(index);
        }
        Some(Grid {
            boxes,
            reach,
            members,
        })
    }

    /// All pairs of points with the lattice shift of the second one, near ones among them.
    fn pairs(&self, places: &[[f64; 3]], mut visit: impl FnMut((usize, usize), [i32; 3])) {
        for (index, place) in places.iter().enumerate() {
            let home = box_of(place, &self.boxes);
            for x in -self.reach[0]..=self.reach[0] {
                for y in -self.reach[1]..=self.reach[1] {
                    for z in -self.reach[2]..=self.reach[2] {
                        let there = [home[0] + x, home[1] + y, home[2] + z];
                        let shift = std::array::from_fn(|k| there[k].div_euclid(self.boxes[k]));
                        let inside = std::array::from_fn(|k| there[k].rem_euclid(self.boxes[k]));
                        for &other in self.members.get(&inside).into_iter().flatten() {
                            if other > index || other == index && shift > [0; 3] {
                                visit((index, other), shift);
                            }
                        }
                    }
                }
            }
        }
    }
}

fn box_of(place: &[f64; 3], boxes: &[i32; 3]) -> [i32; 3] {
    std::array::from_fn(|k| ((place[k] * f64::from(boxes[k])) as i32).clamp(0, boxes[k] - 1))
}

/// The nearest double.
pub fn approximate(x: &Rational) -> f64 {
    f64::rounding_from(x, Nearest).0
}

fn difference(from: &Vector, to: &Vector, shift: [i32; 3]) -> Vector {
    std::array::from_fn(|k| &to[k] - &from[k] + Rational::from(shift[k]))
}

fn exact_norm(gram: &Gram, x: &Vector) -> Rational {
    let mut sum = Rational::from(0);
    for i in 0..3 {
        for j in 0..3 {
            sum += &gram[i][j] * &x[i] * &x[j];
        }
    }
    sum
}

fn norm(metric: &[[f64; 3]; 3], x: &[f64; 3]) -> f64 {
    (0..3)
        .flat_map(|i| (0..3).map(move |j| (i, j)))
        .map(|(i, j)| metric[i][j] * x[i] * x[j])
        .sum()
}

fn minor(m: &[[f64; 3]; 3], k: usize) -> f64 {
    let (i, j) = ((k + 1) % 3, (k + 2) % 3);
    m[i][i] * m[j][j] - m[i][j] * m[j][i]
}

fn determinant(m: &[[f64; 3]; 3]) -> f64 {
    m[0][0] * minor(m, 0) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0])
        + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0])
}

fn inverse_diagonal(m: &[[f64; 3]; 3]) -> [f64; 3] {
    let determinant = determinant(m);
    std::array::from_fn(|k| minor(m, k) / determinant)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn gram(rows: [[i64; 3]; 3]) -> Gram {
        rows.map(|row| row.map(Rational::from))
    }

    fn point(x: [(i64, i64); 3]) -> Vector {
        x.map(|(n, d)| Rational::from_signeds(n, d))
    }

    /// By hand: in the cubic lattice of edge 4 with a body centre, the squared distance is 3 · 4.
    /// In the lattice of one point with a·b = 9/10 a², a - b is the shortest vector. Its squared length
    /// is 1/5 a².
    #[test]
    fn shortest_distances() {
        let cubic = gram([[16, 0, 0], [0, 16, 0], [0, 0, 16]]);
        let bcc = [point([(0, 1); 3]), point([(1, 2); 3])];
        let found = shortest(&cubic, &bcc).expect("a distance");
        assert_eq!((found.squared, found.atoms), (Rational::from(12), (0, 1)));
        let skew = gram([[10, 9, 0], [9, 10, 0], [0, 0, 10]]);
        let found = shortest(&skew, &bcc[..1]).expect("a distance");
        assert_eq!((found.squared, found.atoms), (Rational::from(2), (0, 0)));
    }
}
