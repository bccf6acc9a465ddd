//! Gift wrapping: from one Delaunay cell over its facets to all of them.
//!
//! A Delaunay cell is the convex hull of all points on an empty sphere. Beyond
//! each of its facets lies exactly one further cell: of the spheres through the facet
//! the one whose centre is pushed out until it meets a point beyond. Doubles propose
//! that point; then all points that may lie on or inside of the sphere are fetched and
//! judged exactly. A point inside is a better proposal; when there is none, the points
//! on the sphere are the cell. So every cell that is recorded has been shown to be empty,
//! and the sphere shrinks beyond the facet with each proposal, so this ends.
//!
//! (In the plane a triangulation could be repaired by flips instead; in space these
//! may get stuck before all facets are locally Delaunay.)

use super::DelaunayError;
use super::floats::dot;
use super::front::{Front, View};
use super::polytope::Polytope;
use super::predicates::Predicates;
use super::seed;
use super::tree::Ball;
use crate::geometry::{Scalar, Sign};
use crate::tiling::Corner;

/// All Delaunay cells, one of each orbit, in the model's coordinates.
#[derive(Clone, Debug, Default)]
pub struct Cells<const D: usize> {
    /// Positively oriented, D + 1 corners each.
    pub simplices: Vec<Corner<D>>,
    /// The others.
    pub polytopes: Vec<Polytope<D>>,
}

struct Wrapping<'a, S: Clone, const D: usize> {
    predicates: &'a Predicates<'a, S, D>,
    front: Front<D>,
    cells: Cells<D>,
    /// Scratch space.
    near: Vec<Corner<D>>,
}

/// All Delaunay cells of a model.
pub fn wrap<S: Scalar, const D: usize>(
    predicates: &Predicates<S, D>,
) -> Result<Cells<D>, DelaunayError> {
    let mut wrapping = Wrapping {
        predicates,
        front: Front::new(predicates.model.names.len()),
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
        let apex = wrapping.propose(&facet)?;
        wrapping.settle(facet, apex)?;
    }
    Ok(wrapping.cells)
}

impl<S: Scalar, const D: usize> Wrapping<'_, S, D> {
    /// Replaces the apex until the sphere is empty, and records the cell.
    fn settle(&mut self, facet: [Corner<D>; D], mut apex: Corner<D>) -> Result<(), DelaunayError> {
        loop {
            let mut near = std::mem::take(&mut self.near);
            self.predicates
                .near_sphere(&facet, &apex, usize::MAX, &mut near)?;
            let better = self.keep_cospherical(&facet, &apex, &mut near)?;
            self.near = near;
            match better {
                Some(inside) => apex = inside,
                None => return self.record(facet, apex),
            }
        }
    }

    /// Drops the corners outside of the sphere; returns one that is inside. It must
    /// be beyond the facet: on this side the sphere lies in that of the cell below.
    fn keep_cospherical(
        &self,
        facet: &[Corner<D>; D],
        apex: &Corner<D>,
        near: &mut Vec<Corner<D>>,
    ) -> Result<Option<Corner<D>>, DelaunayError> {
        let mut inside = None;
        near.retain(|p| {
            let sign = self.predicates.in_sphere(facet, apex, p);
            if sign == Sign::Less {
                inside = Some(*p);
            }
            sign == Sign::Equal
        });
        match inside {
            Some(p) if self.predicates.orientation(facet, &p) != Sign::Greater => {
                Err(DelaunayError::Uncertified)
            }
            inside => Ok(inside),
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
        self.cells.simplices.extend(facet);
        self.cells.simplices.push(apex);
        // The facet without facet[i]: putting the apex in the place of facet[i] and
        // that at the end is one exchange, so beyond it orientation is positive.
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
    fn propose(&mut self, facet: &[Corner<D>; D]) -> Result<Corner<D>, DelaunayError> {
        let floats = &self.predicates.model.floats;
        let (center, normal) = floats.facet_center(facet);
        let least = dot(&center, &center);
        let mut square = 2.0 * least;
        loop {
            let height = (square - least).max(0.0).sqrt();
            let above = std::array::from_fn(|k| center[k] + height * normal[k]);
            let ball = Ball {
                center: above,
                radius: square.sqrt() * (1.0 + 1e-9),
            };
            self.predicates.model.tree.gather(
                floats,
                &facet[0],
                ball,
                usize::MAX,
                &mut self.near,
            )?;
            if let Some(apex) = self.lowest(facet, &center, &normal, 1e-6 * ball.radius) {
                return Ok(apex);
            }
            square *= 3.0;
        }
    }

    /// Of the corners at hand that are clearly beyond the facet, the one whose sphere
    /// reaches least far: the centre c + t n is as far from p as from the facet,
    /// so 2 t n · (p - c) = |p - c|² - |c|². (Corners almost in the plane of the facet
    /// have their turn when spheres are judged exactly.)
    fn lowest(
        &self,
        facet: &[Corner<D>; D],
        center: &[f64; D],
        normal: &[f64; D],
        clear: f64,
    ) -> Option<Corner<D>> {
        let floats = &self.predicates.model.floats;
        let square = dot(center, center);
        let mut best: Option<(f64, Corner<D>)> = None;
        for p in self.near.iter().filter(|p| !facet.contains(p)) {
            let y = floats.difference(&facet[0], p);
            let x: [f64; D] = std::array::from_fn(|k| y[k] - center[k]);
            let height = dot(&x, normal);
            let t = (dot(&x, &x) - square) / (2.0 * height);
            if height > clear
                && best.is_none_or(|(least, _)| t < least)
                && self.predicates.orientation(facet, p) == Sign::Greater
            {
                best = Some((t, *p));
            }
        }
        best.map(|(_, p)| p)
    }
}
