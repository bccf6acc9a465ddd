//! Gift wrapping: from one Delaunay cell over its facets to all of them.
//!
//! A Delaunay cell is the convex hull of all points on an empty sphere. Exactly one other cell lies beyond
//! each of its facets. To find it, the centre of a sphere through the facet is pushed out until the sphere
//! meets a point beyond. Doubles propose that point, and where they leave hardly a doubt the simplex is
//! recorded as it is: the certificate decides. Where they do leave a doubt, all points that may lie on or
//! inside of the sphere are fetched and judged exactly. A point inside is a better proposal; when there is
//! none, the points on the sphere are the cell. The sphere shrinks beyond the facet with each proposal, so
//! this ends. Where predicates are not filtered, each cell is found in this way, and so has been shown to
//! be empty.
//!
//! (In the plane a triangulation could be repaired by flips instead; in space these
//! may get stuck before all facets are locally Delaunay.)

use super::DelaunayError;
use super::front::{Front, View};
use super::model::Model;
use super::places::Circle;
use super::polytope::Polytope;
use super::predicates::Predicates;
use super::seed;
use super::tree::Ball;
use crate::tiling::Corner;
use acutile_exact::geometry::Sign;
use acutile_exact::geometry::linear::dot;

/// All Delaunay cells, one of each orbit, in the model's coordinates.
#[derive(Clone, Debug, Default)]
pub struct Cells<const D: usize> {
    /// Positively oriented, D + 1 corners each.
    pub simplices: Vec<Corner<D>>,
    /// The others.
    pub polytopes: Vec<Polytope<D>>,
}

/// The square of the radius of the first ball that is searched, that of the smallest
/// sphere through the facet being 1.
const FIRST_BALL: f64 = 1.5;
/// Below this height, relative to the radius of the ball, a point is not proposed.
const FLAT: f64 = 1e-6;
/// Below this height on either side the exact predicates are asked.
const CLEAR: f64 = 1e-3;
/// If the reach of two spheres differs by more than this, relative to the radius of the ball, doubles
/// decide which is smaller. They decide the facet in the same way: see [`Circle::is_sharp`].
const APART: f64 = 1e-4;

/// A corner that may be beyond a facet.
struct Proposal<const D: usize> {
    apex: Corner<D>,
    /// Whether there is hardly a doubt that it is the only one.
    is_clear: bool,
}

struct Wrapping<'a, const D: usize> {
    predicates: &'a Predicates<'a, D>,
    front: Front<D>,
    /// D! times the volume of the simplices, in units of the lattice's cell: with a wrong
    /// proposal they might go on for ever.
    volume: f64,
    cells: Cells<D>,
    /// Scratch space.
    near: Vec<Corner<D>>,
}

/// All Delaunay cells of a model.
pub fn wrap<const D: usize>(predicates: &Predicates<D>) -> Result<Cells<D>, DelaunayError> {
    let mut wrapping = Wrapping {
        predicates,
        front: Front::new(predicates.model.names.len()),
        volume: 0.0,
        cells: Cells {
            simplices: Vec::new(),
            polytopes: Vec::new(),
        },
        near: Vec::new(),
    };
    let (facet, apex) = seed::seed(predicates)?;
    wrapping.settle(facet, apex)?;
    while let Some(view) = wrapping.front.first() {
        let facet = view.facet();
        let Proposal { apex, is_clear } = wrapping.propose(&facet)?;
        if is_clear {
            wrapping.record_simplex(facet, apex)?
        } else {
            wrapping.settle(facet, apex)?
        }
    }
    Ok(wrapping.cells)
}

impl<const D: usize> Wrapping<'_, D> {
    /// Replaces the apex until the sphere is empty, and records the cell.
    fn settle(&mut self, facet: [Corner<D>; D], mut apex: Corner<D>) -> Result<(), DelaunayError> {
        let mut near = std::mem::take(&mut self.near);
        loop {
            self.predicates
                .near_sphere(&facet, &apex, usize::MAX, &mut near)?;
            let lowest = self.keep_cospherical(&facet, &apex, &mut near)?;
            if lowest == apex {
                self.near = near;
                return self.record(facet, apex);
            }
            apex = lowest;
        }
    }

    /// Replaces the apex by each corner that is inside of the sphere of the one before,
    /// and keeps the corners on the last sphere. A corner inside must be beyond the facet:
    /// on this side the sphere lies in that of the cell below. Beyond, spheres lie in those
    /// before, so a corner that is outside of one is outside of all that follow.
    fn keep_cospherical(
        &self,
        facet: &[Corner<D>; D],
        apex: &Corner<D>,
        near: &mut Vec<Corner<D>>,
    ) -> Result<Corner<D>, DelaunayError> {
        let mut lowest = *apex;
        let mut sphere = self.predicates.sphere(facet, apex);
        let mut is_beyond = true;
        near.retain(|p| {
            let sign = sphere.side(p);
            if sign == Sign::Less {
                is_beyond &= self.predicates.orientation(facet, p) == Sign::Greater;
                lowest = *p;
                sphere = self.predicates.sphere(facet, p);
            }
            sign == Sign::Equal
        });
        if is_beyond {
            Ok(lowest)
        } else {
            Err(DelaunayError::Uncertified)
        }
    }

    /// Records the cell with these corners and the cospherical ones in `near`.
    fn record(&mut self, facet: [Corner<D>; D], apex: Corner<D>) -> Result<(), DelaunayError> {
        if !self.near.is_empty() {
            let corners = facet
                .iter()
                .chain([&apex])
                .chain(&self.near)
                .copied()
                .collect();
            return self.record_polytope(corners);
        }
        self.record_simplex(facet, apex)
    }

    fn record_simplex(
        &mut self,
        facet: [Corner<D>; D],
        apex: Corner<D>,
    ) -> Result<(), DelaunayError> {
        self.cells.simplices.extend(facet);
        self.cells.simplices.push(apex);
        self.volume += self.predicates.model.places.determinant(&facet, &apex);
        if self.volume > 2.0 * (1..=D).product::<usize>() as f64 {
            return Err(DelaunayError::Uncertified);
        }
        // The facet without facet[i]. The apex takes the place of facet[i], which goes to the end. This is
        // one exchange, so the orientation beyond the facet is positive.
        for i in 0..D {
            let mut other = facet;
            other[i] = apex;
            self.front.toggle(View::new(other));
        }
        self.front.toggle(View::new(facet).reversed());
        Ok(())
    }

    fn record_polytope(&mut self, corners: Vec<Corner<D>>) -> Result<(), DelaunayError> {
        let polytope = Polytope::new(corners, self.predicates)?;
        for &mask in &polytope.facets {
            let (mut facet, inner) = polytope.spanning(mask);
            facet.sort_unstable();
            let least: [Corner<D>; D] = std::array::from_fn(|k| facet[k]);
            let view = View::new(least);
            let inward = self.predicates.orientation(&least, &inner) == Sign::Greater;
            self.front
                .toggle(if inward { view.reversed() } else { view });
        }
        self.cells.polytopes.push(polytope);
        Ok(())
    }

    /// A corner beyond a facet whose sphere is small, by doubles: growing balls
    /// through the facet are searched until there is one.
    fn propose(&mut self, facet: &[Corner<D>; D]) -> Result<Proposal<D>, DelaunayError> {
        let Model { places, tree, .. } = self.predicates.model;
        let circle = places.circle(facet);
        let least = dot(&circle.center, &circle.center);
        let mut square = FIRST_BALL * least;
        loop {
            let height = (square - least).max(0.0).sqrt();
            let center = std::array::from_fn(|k| circle.center[k] + height * circle.normal[k]);
            let radius = square.sqrt() * (1.0 + 1e-9);
            let ball = Ball { center, radius };
            tree.gather(places, &facet[0], ball, usize::MAX, &mut self.near)?;
            if let Some(proposal) = self.lowest(facet, &circle, height, radius) {
                return Ok(proposal);
            }
            square *= 3.0;
        }
    }

    /// The corner beyond the facet whose sphere reaches least far, of those in the list. The centre c + t n
    /// is as far from p as from the facet, so 2 t n · (p - c) = |p - c|² - |c|². (Corners almost in the
    /// plane of the facet have their turn when spheres are judged exactly.)
    ///
    /// All points beyond the facet with t below `height` are at hand. So the answer is
    /// clear if none is near the plane and no other t is nearly as small.
    fn lowest(
        &self,
        facet: &[Corner<D>; D],
        circle: &Circle<D>,
        height: f64,
        radius: f64,
    ) -> Option<Proposal<D>> {
        let places = &self.predicates.model.places;
        let square = dot(&circle.center, &circle.center);
        let is_sharp = circle.is_sharp && self.predicates.filtered;
        let mut best: Option<(f64, Corner<D>)> = None;
        let (mut next, mut is_clear) = (height, is_sharp);
        for p in self.near.iter().filter(|p| !facet.contains(p)) {
            let y = places.difference(&facet[0], p);
            let x: [f64; D] = std::array::from_fn(|k| y[k] - circle.center[k]);
            let above = dot(&x, &circle.normal);
            let t = (dot(&x, &x) - square) / (2.0 * above);
            let is_off = above.abs() > CLEAR * radius;
            is_clear &= is_off;
            let is_beyond =
                || is_sharp && is_off || self.predicates.orientation(facet, p) == Sign::Greater;
            if above <= FLAT * radius {
                continue;
            }
            match best {
                Some((least, _)) if t >= least => next = next.min(t),
                _ if is_beyond() => {
                    next = best.map_or(next, |(least, _)| least);
                    best = Some((t, *p));
                }
                _ => {}
            }
        }
        best.map(|(t, apex)| Proposal {
            apex,
            is_clear: is_clear && t + APART * radius < next,
        })
    }
}
