//! The simplices that have an extreme value: predicates with filters find them, exactly.

use super::Place;
use crate::predicates::{AnglesAgainst, Model, Predicate, RadiusAgainst, Signs};
use crate::quality::{DihedralAngle, Exact, RadiusEdge};
use crate::tiling::SimplexId;
use acutile_exact::geometry::Sign;
use malachite::Rational;

/// An extreme value with those who have it.
#[derive(Clone, Debug)]
pub struct Extreme<P> {
    /// Rational bounds of the value.
    pub bounds: (Rational, Rational),
    /// The value in closed form where there is a short one.
    pub closed_form: Option<String>,
    /// The first few who have exactly this value.
    pub holders: Vec<P>,
    /// How many have it.
    pub count: usize,
}

/// No more than this many holders are named.
const NAMED: usize = 20;

/// The simplices among which extremes are looked for.
pub(super) struct Members<'m, 't, const D: usize> {
    pub model: &'m Model<'t, D>,
    /// The names of the simplices of the model, if these are not their own indices.
    pub names: Option<&'m [SimplexId]>,
}

impl<const D: usize> Members<'_, '_, D> {
    /// All dihedral angles that are equal to an extreme one.
    pub fn with_angle(&self, angle: &DihedralAngle) -> Extreme<Place> {
        let predicate = AnglesAgainst::new(&angle.signed_square);
        let holders = self.holders(predicate, |simplex, signs, add| {
            for (index, facets) in pairs::<D>().enumerate() {
                if signs.get(index) == Sign::Equal {
                    add(Place { simplex, facets });
                }
            }
        });
        extreme(angle, holders)
    }

    /// All simplices whose radius-edge ratio is equal to an extreme one.
    pub fn with_ratio(&self, ratio: &RadiusEdge) -> Extreme<SimplexId> {
        let predicate = RadiusAgainst::new(&ratio.square);
        // The signs are those of b |e|² - R² for all edges e; the least belongs to the shortest.
        let holders = self.holders(predicate, |simplex, signs, add| {
            if signs.none_negative() && !signs.all_positive() {
                add(simplex);
            }
        });
        extreme(ratio, holders)
    }

    /// The simplices that `find` adds where a sign is zero: the first few, and their number.
    fn holders<P: Send + Sync>(
        &self,
        predicate: impl Predicate<D>,
        find: impl Fn(SimplexId, &Signs, &mut dyn FnMut(P)) + Sync,
    ) -> (Vec<P>, usize) {
        let prepared = self.model.prepare(predicate);
        let chunks = self.model.by_chunks(|simplices| {
            let (mut holders, mut count) = (Vec::new(), 0);
            prepared.for_each(simplices, |simplex, signs| {
                if signs.none_zero() {
                    return;
                }
                find(self.name(simplex), signs, &mut |holder| {
                    count += 1;
                    if holders.len() < NAMED {
                        holders.push(holder);
                    }
                });
            });
            (holders, count)
        });
        let count = chunks.iter().map(|(_, count)| count).sum();
        let holders = chunks.into_iter().flat_map(|(holders, _)| holders);
        (holders.take(NAMED).collect(), count)
    }

    fn name(&self, simplex: SimplexId) -> SimplexId {
        match self.names {
            Some(names) => names[simplex.index()],
            None => simplex,
        }
    }
}

fn extreme<P>(value: &impl Exact, (holders, count): (Vec<P>, usize)) -> Extreme<P> {
    // The width of enclosures in reports.
    let width = Rational::from_signeds(1, 10_000_000);
    Extreme {
        bounds: value.enclosure(&width),
        closed_form: value.closed_form(),
        holders,
        count,
    }
}

/// The pairs of facets of a simplex, in the order of the predicates' values.
pub(super) fn pairs<const D: usize>() -> impl Iterator<Item = (usize, usize)> {
    (0..=D).flat_map(|i| (i + 1..=D).map(move |j| (i, j)))
}
