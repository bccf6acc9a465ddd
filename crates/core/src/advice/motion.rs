//! How little one corner of a simplex must move to make it acute.
//!
//! The facet opposite to the corner stays. An acute simplex has acute facets only, because the dihedral
//! angles of a tetrahedron bound the angles of its triangles. (Eppstein, Sullivan, Üngör, section on acute
//! simplices.) So a corner whose opposite facet is not acute cannot do it. If the facet is acute, a corner
//! high above its middle makes the simplex acute. Then the lateral angles are near to those of the facet,
//! and the others are near to right angles from below.

use crate::tiling::{Corner, SimplexId, Tiling};
use acutile_exact::geometry::{Scalar, Sign, Simplex, linear};
use acutile_exact::number::Number;
use malachite::Rational;
use malachite::base::num::arithmetic::traits::{Floor, Pow};

/// A motion of one corner that makes a simplex acute; it says nothing of the neighbours.
#[derive(Clone, Debug, PartialEq)]
pub struct Motion<const D: usize> {
    /// The simplex.
    pub simplex: SimplexId,
    /// The corner that moves.
    pub corner: Corner<D>,
    /// Where it goes, in basis coordinates; confirmed exactly.
    pub target: [Number; D],
    /// At least the distance, in units of length.
    pub distance: Rational,
}

/// Whether a motion of one corner can make the simplex acute: it has an acute facet.
pub fn is_possible<const D: usize>(tiling: &Tiling<D>, simplex: SimplexId) -> bool {
    let corners = tiling.simplex(simplex).iter();
    let points: Vec<[Number; D]> = corners.map(|c| tiling.position(c)).collect();
    (0..=D).any(|k| is_facet_acute(tiling, &points, k))
}

/// The smallest motion that was found among all corners. The search is in doubles, so a smaller
/// one may exist; that this one does it is exact.
pub fn motion<const D: usize>(tiling: &Tiling<D>, simplex: SimplexId) -> Option<Motion<D>> {
    let motions = (0..=D).filter_map(|k| motion_of(tiling, simplex, k));
    motions.min_by(|a, b| a.distance.cmp(&b.distance))
}

fn motion_of<const D: usize>(
    tiling: &Tiling<D>,
    simplex: SimplexId,
    moving: usize,
) -> Option<Motion<D>> {
    let corners = tiling.simplex(simplex);
    let points: Vec<[Number; D]> = corners.iter().map(|c| tiling.position(c)).collect();
    if !is_facet_acute(tiling, &points, moving) {
        return None;
    }
    let cogram = linear::cofactors(&tiling.frame.gram);
    Search::new(tiling, &points, moving)
        .candidates()
        .into_iter()
        .filter_map(|step| target(&points[moving], &step))
        .find_map(|target| {
            let mut moved = points.clone();
            let step = linear::subtract(&target, &points[moving]);
            moved[moving] = target;
            is_acute(&Simplex::new(&moved), &cogram).then(|| Motion {
                simplex,
                corner: corners[moving],
                target: moved.swap_remove(moving),
                distance: length(tiling, &step),
            })
        })
}

/// Where a step leads, as short decimals that can be typed in: four digits of the step's size.
/// None for an infinite step.
fn target<const D: usize>(from: &[Number; D], step: &[f64; D]) -> Option<[Number; D]> {
    let size = step.iter().fold(0.0, |size: f64, x| size.max(x.abs()));
    if !size.is_normal() {
        return None;
    }
    let digits = (4.0 - size.log10().floor()).clamp(0.0, 300.0) as u64;
    let unit = Rational::from(10).pow(digits);
    let rounded = |k: usize| {
        let half = Rational::from_signeds(1, 2);
        let (low, high) = from[k].enclosure(&(Rational::from(1) / &unit));
        let middle = (low + high) * &half + Rational::try_from(step[k]).unwrap_or_default();
        Number::from(Rational::from((middle * &unit + half).floor()) / &unit)
    };
    Some(std::array::from_fn(rounded))
}

/// A little more than the length of a vector.
fn length<const D: usize>(tiling: &Tiling<D>, step: &[Number; D]) -> Rational {
    let square = linear::square(&tiling.frame.gram, step);
    let width = Rational::from_signeds(1, 10_000_000_000i64);
    square.enclosure_of_root(&width).1
}

/// Whether the facet opposite to a corner has acute angles only. Then every squared edge of each of its
/// triangles is less than the sum of the two others.
fn is_facet_acute<const D: usize>(
    tiling: &Tiling<D>,
    points: &[[Number; D]],
    opposite: usize,
) -> bool {
    let facet: Vec<&[Number; D]> = (0..=D)
        .filter(|&k| k != opposite)
        .map(|k| &points[k])
        .collect();
    let square = |a: usize, b: usize| {
        linear::square(&tiling.frame.gram, &linear::subtract(facet[a], facet[b]))
    };
    // In the plane a facet is an edge and has no angles.
    D < 3
        || (0..3).all(|a| {
            let (b, c) = ((a + 1) % 3, (a + 2) % 3);
            square(b, c) < &square(a, b) + &square(a, c)
        })
}

/// Positively oriented, with all dihedral angles acute.
fn is_acute<S: Scalar, const D: usize>(simplex: &Simplex<S, D>, cogram: &[[S; D]; D]) -> bool {
    simplex.determinant.sign() == Sign::Greater
        && simplex
            .normal_products(cogram)
            .pairs()
            .all(|(_, _, product)| product.sign() == Sign::Less)
}

/// The search for a short step, in doubles and in basis coordinates, relative to the moving corner.
struct Search<const D: usize> {
    /// The corners relative to the moving one.
    points: Vec<[f64; D]>,
    moving: usize,
    gram: [[f64; D]; D],
    cogram: [[f64; D]; D],
    size: f64,
}

/// Rounds of the pattern search, and by how much its step shrinks in a round without gain.
const ROUNDS: usize = 200;
const SHRINK: f64 = 0.7;

impl<const D: usize> Search<D> {
    fn new(tiling: &Tiling<D>, points: &[[Number; D]], moving: usize) -> Self {
        let gram = tiling
            .frame
            .gram
            .each_ref()
            .map(|row| row.each_ref().map(Number::approximate));
        let origin = &points[moving];
        let points: Vec<[f64; D]> = points
            .iter()
            .map(|p| linear::subtract(p, origin).map(|x| x.approximate()))
            .collect();
        let sizes = points.iter().map(|p| linear::square(&gram, p));
        Search {
            size: sizes.fold(0.0, f64::max).sqrt(),
            cogram: linear::cofactors(&gram),
            points,
            moving,
            gram,
        }
    }

    /// Steps that make the simplex acute according to doubles. The first is the shortest that was found, on
    /// the boundary of the acute positions. The others go farther inside.
    fn candidates(&self) -> Vec<[f64; D]> {
        let Some(safe) = self.acute_step() else {
            return Vec::new();
        };
        let best = self.improved(self.shortened(safe));
        let inward = |part: f64| std::array::from_fn(|k| best[k] + part * (safe[k] - best[k]));
        [1e-4, 1e-3, 1e-2, 1e-1, 1.0].map(inward).to_vec()
    }

    fn length(&self, step: &[f64; D]) -> f64 {
        linear::square(&self.gram, step).sqrt()
    }

    fn makes_acute(&self, step: &[f64; D]) -> bool {
        let mut points = self.points.clone();
        points[self.moving] = *step;
        is_acute(&Simplex::new(&points), &self.cogram)
    }

    /// High above the middle of the opposite facet, on the side that keeps the
    /// orientation.
    fn acute_step(&self) -> Option<[f64; D]> {
        let others: Vec<[f64; D]> = (0..=D)
            .filter(|&k| k != self.moving)
            .map(|k| self.points[k])
            .collect();
        let middle = self.center(&others);
        let normal = linear::apply(&self.cogram, &self.inward());
        let length = self.length(&normal);
        let heights = (0..20).map(|k| self.size * 0.25 * 1.5f64.powi(k) / length);
        heights
            .map(|height| std::array::from_fn(|k| middle[k] + height * normal[k]))
            .find(|step| self.makes_acute(step))
    }

    /// The gradient of the moving corner's barycentric coordinate: the inward normal of the
    /// opposite facet. All gradients sum to zero.
    fn inward(&self) -> [f64; D] {
        let gradients = Simplex::new(&self.points).gradients;
        match self.moving {
            0 => std::array::from_fn(|k| -gradients.iter().map(|g| g[k]).sum::<f64>()),
            corner => gradients[corner - 1],
        }
    }

    /// The incentre of a triangle, which is inside where the orthogonal projection must be; the middle of an
    /// edge.
    fn center(&self, facet: &[[f64; D]]) -> [f64; D] {
        let weights: Vec<f64> = (0..D)
            .map(|k| match D {
                3 => self.length(&linear::subtract(&facet[(k + 1) % D], &facet[(k + 2) % D])),
                _ => 1.0,
            })
            .collect();
        let total: f64 = weights.iter().sum();
        std::array::from_fn(|k| {
            facet
                .iter()
                .zip(&weights)
                .map(|(p, w)| p[k] * w)
                .sum::<f64>()
                / total
        })
    }

    /// The shortest multiple found by halving between no motion and `step`.
    fn shortened(&self, step: [f64; D]) -> [f64; D] {
        let scaled = |t: f64| step.map(|x| x * t);
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..40 {
            let middle = (low + high) / 2.0;
            if self.makes_acute(&scaled(middle)) {
                high = middle
            } else {
                low = middle
            }
        }
        scaled(high)
    }

    /// Pattern search: tries steps along the axes that make the motion shorter and
    /// keep it acute.
    fn improved(&self, start: [f64; D]) -> [f64; D] {
        let mut best = start;
        let mut reach = self.length(&start);
        for _ in 0..ROUNDS {
            let trials = (0..2 * D).map(|k| {
                let mut trial = best;
                let side = if k % 2 == 0 { reach } else { -reach };
                trial[k / 2] += side / self.gram[k / 2][k / 2].sqrt();
                self.pulled(trial)
            });
            let shorter = trials
                .filter(|trial| self.makes_acute(trial))
                .min_by(|a, b| self.length(a).total_cmp(&self.length(b)))
                .filter(|trial| self.length(trial) < self.length(&best));
            match shorter {
                Some(trial) => best = trial,
                None => reach *= SHRINK,
            }
        }
        best
    }

    /// A trial, pulled towards no motion as far as that goes.
    fn pulled(&self, trial: [f64; D]) -> [f64; D] {
        if self.makes_acute(&trial) {
            self.shortened(trial)
        } else {
            trial
        }
    }
}
