//! Slabs over plane tilings, searched: layers of points over the vertices, midpoints of edges and centres of
//! tiles.
//!
//! A candidate has layers at random heights up to a middle plane, and their mirror images above it. The
//! Delaunay triangulation of these points and their mirror images in the boundary planes gives a tiling of
//! space. If no tetrahedron crosses a boundary plane, those in the slab tile it. Candidates with an edge that
//! proves that they can never be acute are left out; the others are optimized.

use crate::goal::Goal;
use crate::reason::reasons;
use crate::search::{Options, Outcome, Watch, optimize};
use crate::value::value;
use acutile_core::delaunay::{DelaunayError, Ties, triangulate};
use acutile_core::tiling::{Domain, Frame, PointSet, Polytope, Tiling, match_facets};
use acutile_exact::number::{Field, Number};
use malachite::Rational;

/// A plane tiling with its special points, in a basis of its lattice.
#[derive(Clone, Copy, Debug)]
pub struct Plane {
    pub name: &'static str,
    /// The Gram matrix, for side length 6.
    gram: [[i64; 2]; 2],
    /// Places in twelfths of the basis: vertices, midpoints of edges, centres.
    classes: [&'static [[i64; 2]]; 3],
}

/// The tilings that are tried.
pub const PLANES: [Plane; 2] = [
    Plane {
        name: "triangles",
        gram: [[36, 18], [18, 36]],
        classes: [&[[0, 0]], &[[6, 0], [0, 6], [6, 6]], &[[4, 4], [8, 8]]],
    },
    Plane {
        name: "squares",
        gram: [[36, 0], [0, 36]],
        classes: [&[[0, 0]], &[[6, 0], [0, 6]], &[[6, 6]]],
    },
];

/// What a search did.
#[derive(Debug, Default)]
pub struct Tried {
    pub candidates: usize,
    /// More than four points lie on an empty sphere, so that there is no single triangulation.
    pub cospherical: usize,
    /// Other candidates that give no slab: a tetrahedron lies across a boundary plane, or the result is not
    /// proved.
    pub unusable: usize,
    /// An edge proves that these can never be acute.
    pub hopeless: usize,
    pub optimized: usize,
    /// Optimized candidates that are acute.
    pub acute: usize,
    /// The best one, with its layers in words.
    pub best: Option<(String, Outcome)>,
    pub is_interrupted: bool,
}

/// Tries `count` candidates with up to `layers` layers below the middle.
pub fn slabs(plane: &Plane, count: usize, layers: usize, seed: u64, watch: Watch) -> Tried {
    let mut random = crate::search::Random(seed);
    let mut tried = Tried::default();
    for _ in 0..count {
        if !watch(tried.candidates as f64) {
            tried.is_interrupted = true;
            break;
        }
        tried.candidates += 1;
        let candidate = Candidate::random(layers, &mut random);
        let tiling = match candidate.tiling(plane) {
            Ok(tiling) => tiling,
            Err(NoSlab::Cospherical) => {
                tried.cospherical += 1;
                continue;
            }
            Err(NoSlab::Other) => {
                tried.unusable += 1;
                continue;
            }
        };
        if !reasons(&tiling, &match_facets(&tiling)).is_empty() {
            tried.hopeless += 1;
            continue;
        }
        tried.optimized += 1;
        let Ok(outcome) = optimize(&tiling, &Options::default(), &mut |_| true) else {
            tried.unusable += 1;
            continue;
        };
        tried.take(candidate.words(), outcome);
    }
    tried
}

/// Why a candidate gives no slab.
enum NoSlab {
    Cospherical,
    Other,
}

impl Tried {
    /// Keeps the better one.
    fn take(&mut self, words: String, outcome: Outcome) {
        use acutile_core::statement::Statement;
        if outcome.proved.statements().contains(&Statement::Acute) {
            self.acute += 1;
        }
        let angle = |outcome: &Outcome| value(outcome.proved.statements(), Goal::MaxDihedral);
        let is_better = match (&self.best, angle(&outcome)) {
            (Some((_, best)), Some(new)) => angle(best).is_none_or(|old| new.is_better_than(&old)),
            _ => true,
        };
        if is_better {
            self.best = Some((words, outcome));
        }
    }
}

/// Layers from the boundary to the middle: a class of places and a height, in twelfths of an edge.
#[derive(Clone, Debug)]
struct Candidate {
    layers: Vec<(usize, i64)>,
    middle: i64,
}

/// Letters for the classes.
const LETTERS: [char; 3] = ['V', 'E', 'C'];
/// Heights are in parts of this many to the unit of length; an edge has length 6.
const PARTS: i64 = 20;

impl Candidate {
    fn random(layers: usize, random: &mut crate::search::Random) -> Self {
        let mut below = |n: i64| ((random.next() + 1.0) / 2.0 * n as f64) as i64;
        let count = 2 + below(layers as i64 - 1) as usize;
        let mut height = 0;
        let mut list = vec![(below(3) as usize, 0)];
        for k in 0..count {
            // Layers are up to two thirds of an edge apart, and neighbours differ in class.
            height += below(4 * PARTS + 1);
            list.push(((list[k].0 + 1 + below(2) as usize) % 3, height));
        }
        let in_middle = below(2) == 0;
        let middle = match in_middle {
            true => height,
            false => height + 1 + below(2 * PARTS),
        };
        Candidate {
            layers: list,
            middle,
        }
    }

    /// The tetrahedra between the boundary planes.
    fn tiling(&self, plane: &Plane) -> Result<Tiling<3>, NoSlab> {
        let top = 2 * self.middle;
        if self.middle == 0 {
            return Err(NoSlab::Other);
        }
        let mut heights: Vec<(usize, i64)> = Vec::new();
        for &(class, height) in &self.layers {
            for z in [height, top - height, -height, height - top] {
                let z = z.rem_euclid(2 * top);
                if !heights.contains(&(class, z)) {
                    heights.push((class, z));
                }
            }
        }
        let fraction = |n: i64, d: i64| Number::from(Rational::from_signeds(n, d));
        let integer = |n: i64| fraction(n, 1);
        let [[a, b], [c, d]] = plane.gram;
        let period = fraction(4 * top * top, PARTS * PARTS);
        let zero = Number::zero;
        let gram = [
            [integer(a), integer(b), zero()],
            [integer(c), integer(d), zero()],
            [zero(), zero(), period],
        ];
        let points = heights.iter().flat_map(|&(class, z)| {
            plane.classes[class]
                .iter()
                .map(move |[x, y]| [fraction(*x, 12), fraction(*y, 12), fraction(z, 2 * top)])
        });
        let set = PointSet {
            frame: Frame::space(Field::rationals(), gram.clone()),
            points: points.collect(),
        };
        let space = triangulate(&set, Ties::Refuse).map_err(|error| match error {
            DelaunayError::Cospherical(_) => NoSlab::Cospherical,
            _ => NoSlab::Other,
        })?;
        cut(
            &space,
            [[integer(a), integer(b)], [integer(c), integer(d)]],
            fraction(top, PARTS),
        )
        .ok_or(NoSlab::Other)
    }

    fn words(&self) -> String {
        let layer = |(class, height): &(usize, i64)| format!("{}{height}", LETTERS[*class]);
        let layers: Vec<String> = self.layers.iter().map(layer).collect();
        format!(
            "{} mirrored at {}, in {PARTS}ths of a sixth of a side",
            layers.join(" "),
            self.middle
        )
    }
}

/// The tetrahedra whose heights are all at most half a period; `None` if one lies across a boundary.
fn cut(space: &Tiling<3>, gram: [[Number; 2]; 2], height: Number) -> Option<Tiling<3>> {
    let half = Number::from(Rational::from_signeds(1, 2));
    let one = Number::from(Rational::from(1));
    let zero = Number::zero();
    let mut chosen: Vec<Vec<[Number; 3]>> = Vec::new();
    for simplex in space.indices() {
        let points: Vec<[Number; 3]> = space
            .simplex(simplex)
            .iter()
            .map(|corner| space.position(corner))
            .collect();
        let least = points.iter().map(|p| &p[2]).min()?;
        let floor = Number::from(Rational::from(least.floor()));
        let moved = |p: &[Number; 3]| [p[0].clone(), p[1].clone(), &p[2] - &floor];
        let points: Vec<[Number; 3]> = points.iter().map(moved).collect();
        let low = points.iter().map(|p| &p[2]).min()?;
        let high = points.iter().map(|p| &p[2]).max()?;
        if *high <= half {
            chosen.push(points);
        } else if *low < half || *high > one {
            return None;
        }
    }
    let scale = &height * &Number::from(Rational::from(2));
    let scaled = |points: Vec<[Number; 3]>| -> Vec<[Number; 3]> {
        points
            .into_iter()
            .map(|[x, y, z]| [x, y, &z * &scale])
            .collect()
    };
    let [[a, b], [c, d]] = gram;
    let frame = Frame {
        field: Field::rationals(),
        gram: [
            [a, b, zero.clone()],
            [c, d, zero.clone()],
            [zero.clone(), zero.clone(), one],
        ],
        domain: Domain::Slab(Polytope::interval(zero, height)),
    };
    let tetrahedra: Vec<Vec<[Number; 3]>> = chosen.into_iter().map(scaled).collect();
    (!tetrahedra.is_empty()).then(|| Tiling::from_positions(frame, &tetrahedra))
}
