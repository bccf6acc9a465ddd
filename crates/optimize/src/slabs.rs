//! Slabs over plane tilings, searched: layers of points over special places, such as the vertices, midpoints of edges
//! and centres of tiles.
//!
//! A candidate has layers of random classes at random heights up to a middle plane, and their mirror images above it. The
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

/// A plane tiling with its special places, in a basis of its lattice.
#[derive(Clone, Debug)]
pub struct Plane {
    /// The name of the plane tiling.
    pub name: String,
    /// The field of all numbers.
    pub field: Field,
    /// The Gram matrix, for side length 6.
    pub gram: [[Number; 2]; 2],
    /// Places of one kind, such as all vertices, with a short name.
    pub classes: Vec<(String, Vec<[Number; 2]>)>,
}

/// The counts of a search.
#[derive(Debug, Default)]
pub struct Tried {
    /// The number of candidates.
    pub candidates: usize,
    /// More than four points lie on an empty sphere, so that there is no single triangulation.
    pub cospherical: usize,
    /// Other candidates that give no slab: a tetrahedron lies across a boundary plane, or the result is not
    /// proved.
    pub unusable: usize,
    /// An edge proves that these can never be acute.
    pub hopeless: usize,
    /// The number of candidates that were optimized.
    pub optimized: usize,
    /// Optimized candidates that are acute.
    pub acute: usize,
    /// The best one, with its layers in words.
    pub best: Option<(String, Outcome)>,
    /// Whether a signal ended the search.
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
        let candidate = Candidate::random(plane.classes.len(), layers, &mut random);
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
        tried.take(candidate.words(plane), outcome);
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

/// Layers from the boundary to the middle: one or two classes of places, and a height.
#[derive(Clone, Debug)]
struct Candidate {
    layers: Vec<(Vec<usize>, i64)>,
    middle: i64,
}

/// Heights are in parts of this many to the unit of length; an edge has length 6.
const PARTS: i64 = 20;

impl Candidate {
    /// A number of layers and their heights. `classes` is at least 1.
    fn random(classes: usize, layers: usize, random: &mut crate::search::Random) -> Self {
        let mut below = |n: i64| ((random.next() + 1.0) / 2.0 * n as f64) as i64;
        let count = 2 + below(layers as i64 - 1) as usize;
        let (mut height, mut last) = (0, None);
        let mut list = Vec::new();
        for k in 0..=count {
            if k > 0 {
                // Layers are up to two thirds of an edge apart.
                height += below(4 * PARTS + 1);
            }
            let others = (classes as i64 - 1).max(1);
            // Neighbours differ in their first class.
            let first = match last {
                Some(last) => (last + 1 + below(others) as usize) % classes,
                None => below(classes as i64) as usize,
            };
            last = Some(first);
            let mut layer = vec![first];
            if classes > 3 && below(4) == 0 {
                layer.push((first + 1 + below(others) as usize) % classes);
                layer.sort_unstable();
            }
            list.push((layer, height));
        }
        let in_middle = below(2) == 0;
        let middle = if in_middle {
            height
        } else {
            height + 1 + below(2 * PARTS)
        };
        Candidate {
            layers: list,
            middle,
        }
    }

    /// The classes at each height of a period: the layers and their images in the planes of the middle and the
    /// boundary.
    fn heights(&self) -> Vec<(usize, i64)> {
        let top = 2 * self.middle;
        let mut heights: Vec<(usize, i64)> = Vec::new();
        for (layer, height) in &self.layers {
            for z in [*height, top - height, -height, height - top] {
                let z = z.rem_euclid(2 * top);
                for class in layer {
                    if !heights.contains(&(*class, z)) {
                        heights.push((*class, z));
                    }
                }
            }
        }
        heights
    }

    /// The tetrahedra between the boundary planes.
    fn tiling(&self, plane: &Plane) -> Result<Tiling<3>, NoSlab> {
        let top = 2 * self.middle;
        if self.middle == 0 {
            return Err(NoSlab::Other);
        }
        let heights = self.heights();
        let fraction = |n: i64, d: i64| Number::from(Rational::from_signeds(n, d));
        let [[a, b], [c, d]] = plane.gram.clone();
        let period = fraction(4 * top * top, PARTS * PARTS);
        let zero = Number::zero;
        let gram = [[a, b, zero()], [c, d, zero()], [zero(), zero(), period]];
        let points = heights.iter().flat_map(|&(class, z)| {
            let places = plane.classes[class].1.iter();
            places.map(move |[x, y]| [x.clone(), y.clone(), fraction(z, 2 * top)])
        });
        let set = PointSet {
            frame: Frame::space(plane.field.clone(), gram),
            points: points.collect(),
        };
        let space = triangulate(&set, Ties::Refuse).map_err(|error| match error {
            DelaunayError::Cospherical(_) => NoSlab::Cospherical,
            _ => NoSlab::Other,
        })?;
        cut(&space, plane, fraction(top, PARTS)).ok_or(NoSlab::Other)
    }

    fn words(&self, plane: &Plane) -> String {
        let name = |class: &usize| plane.classes[*class].0.as_str();
        let layers = self.layers.iter().map(|(layer, height)| {
            let names: Vec<&str> = layer.iter().map(name).collect();
            format!("{} at {height}", names.join("+"))
        });
        format!(
            "{}; mirrored at {}, in {PARTS}ths of a sixth of a side",
            layers.collect::<Vec<_>>().join(", "),
            self.middle
        )
    }
}

/// The tetrahedra whose heights are all at most half a period; `None` if one lies across a boundary.
fn cut(space: &Tiling<3>, plane: &Plane, height: Number) -> Option<Tiling<3>> {
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
    let [[a, b], [c, d]] = plane.gram.clone();
    let frame = Frame {
        field: plane.field.clone(),
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
