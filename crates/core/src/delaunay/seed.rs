//! The first cell: a simplex with an empty circumsphere, from which gift wrapping starts.

use super::DelaunayError;
use super::model::WITNESSES;
use super::predicates::Predicates;
use crate::tiling::{Corner, VertexId};
use acutile_exact::geometry::Sign;
use acutile_exact::geometry::linear::dot;

/// A simplex as a facet and its opposite corner.
type Proposal<const D: usize> = ([Corner<D>; D], Corner<D>);

/// How many candidates the search looks at in one step.
const CANDIDATES: usize = 4096;

struct Search<'a, const D: usize> {
    predicates: &'a Predicates<'a, D>,
    /// Scratch space.
    near: Vec<Corner<D>>,
}

/// A positively oriented simplex with no point inside its circumsphere.
pub fn seed<const D: usize>(predicates: &Predicates<D>) -> Result<Proposal<D>, DelaunayError> {
    Search {
        predicates,
        near: Vec::new(),
    }
    .run()
}

impl<const D: usize> Search<'_, D> {
    /// A simplex with an empty sphere.
    ///
    /// Let g be a point in no hyperplane of corners. A simplex that contains g lifts to a simplex over the
    /// paraboloid; among them the Delaunay one is lowest over g. If a point is inside the sphere of such a
    /// simplex, it can replace exactly one corner so that g stays inside. This step goes down strictly.
    /// This starts from a simplex of lattice vectors and ends as there are finitely many simplices below
    /// it.
    fn run(&mut self) -> Result<Proposal<D>, DelaunayError> {
        let mut failure = DelaunayError::Uncertified;
        for i in 0..WITNESSES {
            match self.descend(self.predicates.model.witness(i)) {
                Ok(Some(seed)) => return Ok(seed),
                Ok(None) => {}
                Err(error) => failure = error,
            }
        }
        Err(failure)
    }

    /// The search for one witness g; `None` if g is not in general position.
    fn descend(&mut self, witness: Corner<D>) -> Result<Option<Proposal<D>>, DelaunayError> {
        let Some(mut simplex) = self.first_simplex(&witness) else {
            return Ok(None);
        };
        loop {
            let (facet, apex) = simplex;
            let mut near = std::mem::take(&mut self.near);
            self.predicates
                .near_sphere(&facet, &apex, CANDIDATES, &mut near)?;
            let inside = self.deepest(&facet, &apex, &near)?;
            self.near = near;
            let Some(p) = inside else {
                return Ok(Some(simplex));
            };
            match self.exchange(&simplex, p, &witness) {
                Some(lower) => simplex = lower,
                None => return Ok(None),
            }
        }
    }

    /// A simplex with g inside among those of Kuhn: 0, b_i, b_i + b_j, … added to a
    /// point of the set that is lattice-moved to be near.
    fn first_simplex(&self, witness: &Corner<D>) -> Option<Proposal<D>> {
        let places = &self.predicates.model.places;
        let [g, p] = [witness.vertex.index(), 0].map(|v| &places.fractions[v]);
        let offset: [f64; D] = std::array::from_fn(|k| g[k] - p[k]);
        let mut axes: [usize; D] = std::array::from_fn(|k| k);
        axes.sort_by(|&a, &b| {
            let rest = |k: usize| offset[k] - offset[k].floor();
            rest(b).total_cmp(&rest(a))
        });
        let mut corner = Corner {
            vertex: VertexId::new(0),
            shift: offset.map(|x| x.floor() as i32),
        };
        let mut facet = [corner; D];
        for (k, &axis) in axes.iter().enumerate() {
            facet[k] = corner;
            corner.shift[axis] += 1;
        }
        let simplex = self.oriented(facet, corner)?;
        self.contains(&simplex, witness).then_some(simplex)
    }

    fn oriented(&self, mut facet: [Corner<D>; D], apex: Corner<D>) -> Option<Proposal<D>> {
        match self.predicates.orientation(&facet, &apex) {
            Sign::Greater => {}
            Sign::Less => facet.swap(0, 1),
            Sign::Equal => return None,
        }
        Some((facet, apex))
    }

    /// Whether g is in the interior of a positively oriented simplex.
    fn contains(&self, (facet, apex): &Proposal<D>, g: &Corner<D>) -> bool {
        let inside = |facet: &[Corner<D>; D], apex| {
            self.predicates.orientation(facet, apex) == Sign::Greater
        };
        inside(facet, g)
            && (0..D).all(|i| {
                let mut replaced = *facet;
                replaced[i] = *g;
                inside(&replaced, apex)
            })
    }

    /// Of some corners one that is inside the sphere, by doubles the deepest.
    fn deepest(
        &self,
        facet: &[Corner<D>; D],
        apex: &Corner<D>,
        near: &[Corner<D>],
    ) -> Result<Option<Corner<D>>, DelaunayError> {
        let sphere = self.predicates.circumsphere(facet, apex)?;
        let distance = |p: &Corner<D>| {
            let y = self.predicates.model.places.difference(&facet[0], p);
            let x: [f64; D] = std::array::from_fn(|k| y[k] - sphere.center[k]);
            dot(&x, &x)
        };
        let mut sorted: Vec<_> = near.iter().map(|p| (distance(p), *p)).collect();
        sorted.sort_by(|a, b| a.0.total_cmp(&b.0));
        let test = self.predicates.sphere(facet, apex);
        let is_inside = |p: &Corner<D>| test.side(p) == Sign::Less;
        Ok(sorted.into_iter().map(|(_, p)| p).find(is_inside))
    }

    /// The simplex with p in the place of one corner that has g inside.
    fn exchange(
        &self,
        (facet, apex): &Proposal<D>,
        p: Corner<D>,
        g: &Corner<D>,
    ) -> Option<Proposal<D>> {
        let candidates = (0..=D).map(|i| {
            let (mut facet, mut apex) = (*facet, *apex);
            *facet.get_mut(i).unwrap_or(&mut apex) = p;
            (facet, apex)
        });
        candidates
            .filter_map(|(facet, apex)| self.oriented(facet, apex))
            .find(|simplex| self.contains(simplex, g))
    }
}
