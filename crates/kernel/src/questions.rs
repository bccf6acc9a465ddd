//! The questions about regions that need exact coordinates. They are asked with the least integers that suffice.

use crate::filter::Intervals;
use crate::grid::APEX;
use crate::int::Int;
use crate::limits::Work;
use crate::meets::Meets;
use crate::refusal::{Checked, Larger, Place, Stop};
use crate::ring::{Element, Exact, Ring, Rings, each, zip};
use crate::row::Corner;
use crate::vertices::Vertices;
use std::cmp::Ordering;

/// A boundary facet. With an inner point before them, the corners have a positive orientation.
pub(crate) type Corners = [Corner; 3];

pub(crate) trait Question<const N: usize> {
    type Answer;

    fn ask<T: Int>(&self, ring: &Exact<T, N>) -> Result<Self::Answer, Larger>;
}

/// The answer with the least integers that give one.
pub(crate) fn decide<Q: Question<N>, const N: usize>(
    rings: &Rings<N>,
    question: &Q,
    place: Place,
) -> Checked<Q::Answer> {
    let small = rings.small.as_ref().ok_or(Larger);
    let medium = || rings.medium.as_ref().ok_or(Larger);
    small
        .and_then(|ring| question.ask(ring))
        .or_else(|Larger| question.ask(medium()?))
        .or_else(|Larger| question.ask(&rings.large))
        .map_err(|larger| Stop::from(larger).at_last(place))
}

type Vector<T, const N: usize> = [Element<T, N>; 3];

#[derive(Clone, Copy)]
pub(crate) struct Points<'v> {
    pub(crate) vertices: &'v Vertices,
}

impl Points<'_> {
    /// The vector from one corner to another one. That to the apex is (0, 0, 1).
    fn edge<T: Int, const N: usize>(&self, from: Corner, to: Corner) -> Result<Vector<T, N>, Larger> {
        if to == APEX {
            return Ok([Element::default(), Element::default(), one()]);
        }
        let (from, to) = (self.vertices.point(from)?, self.vertices.point(to)?);
        zip(&to, &from, |x: &Element<T, N>, y| zip(&x.0, &y.0, T::minus).map(Element))
    }

    /// A normal of the facet, which points outwards.
    fn outer_normal<T: Int, const N: usize>(
        &self,
        ring: &Exact<T, N>,
        [a, b, c]: Corners,
    ) -> Result<Vector<T, N>, Larger> {
        ring.cross(&self.edge(a, b)?, &self.edge(a, c)?)
    }
}

fn one<T: Int, const N: usize>() -> Element<T, N> {
    let mut one = Element::default();
    for constant in one.0.iter_mut().take(1) {
        *constant = T::of_small(1);
    }
    one
}

/// The sign of w · (1, ε, ε²) for small ε > 0: that of the first entry of w that is not zero.
fn first_sign<T: Int, const N: usize>(
    ring: &Exact<T, N>,
    w: &Vector<T, N>,
) -> Result<Ordering, Larger> {
    for entry in w {
        let sign = ring.sign(entry)?;
        if sign != Ordering::Equal {
            return Ok(sign);
        }
    }
    Ok(Ordering::Equal)
}

/// Whether two boundary facets meet in the hull of their first `common` corners, which are the same.
pub(crate) struct Pair<'q> {
    pub(crate) points: Points<'q>,
    pub(crate) intervals: &'q Intervals,
    pub(crate) work: &'q Work,
    pub(crate) common: usize,
    pub(crate) f: Corners,
    pub(crate) g: Corners,
}

impl Pair<'_> {
    /// The corners seen from a corner of f; in the plane as `meets` needs them.
    fn seen<T: Int, const N: usize>(&self, corners: Corners) -> Result<[Vector<T, N>; 3], Larger> {
        let [a, b, _] = self.f;
        let base = if a == APEX { b } else { a };
        let is_plane = self.f.contains(&APEX);
        each(&corners, |corner| {
            if *corner == APEX {
                return Ok(Vector::default());
            }
            let [x, y, z] = self.points.edge(base, *corner)?;
            Ok([x, y, if is_plane { one() } else { z }])
        })
    }
}

impl<const N: usize> Question<N> for Pair<'_> {
    type Answer = bool;

    fn ask<T: Int>(&self, ring: &Exact<T, N>) -> Result<bool, Larger> {
        let (f, g) = (self.seen(self.f)?, self.seen(self.g)?);
        let work = self.work;
        // Intervals are faster than long products. What they decide is true.
        if N > 1 || T::PRICE != 1 {
            let ring = self.intervals;
            let round = |x: &Vector<T, N>| each(x, |x| ring.of(&x.0));
            let (f, g) = (each(&f, round)?, each(&g, round)?);
            let answer = Meets { ring, work }.only_in_common(self.common, &f, &g);
            if answer.is_ok() {
                return answer;
            }
        }
        Meets { ring, work }.only_in_common(self.common, &f, &g)
    }
}

/// The sign of w · (1, ε, ε²) for the outer normal w of a facet.
pub(crate) struct OuterNormal<'q> {
    pub(crate) points: Points<'q>,
    pub(crate) corners: Corners,
}

impl<const N: usize> Question<N> for OuterNormal<'_> {
    type Answer = Ordering;

    fn ask<T: Int>(&self, ring: &Exact<T, N>) -> Result<Ordering, Larger> {
        first_sign(ring, &self.points.outer_normal(ring, self.corners)?)
    }
}

/// Whether a tile contains the point just outside of a facet: the centroid m, moved outwards by
/// ε (1, ε, ε²) or its negative, for small ε > 0.
pub(crate) struct Contains<'q> {
    pub(crate) points: Points<'q>,
    /// Positively oriented.
    pub(crate) tile: [Corner; 4],
    pub(crate) facet: Corners,
    pub(crate) outwards: Ordering,
}

impl<const N: usize> Question<N> for Contains<'_> {
    type Answer = bool;

    /// The point is on the inner side of each facet of the tile. With the outer normal w and a corner o of
    /// the facet, w · (m - o) is negative, or it is zero and the point is moved to the inner side.
    fn ask<T: Int>(&self, ring: &Exact<T, N>) -> Result<bool, Larger> {
        let [a, b, c, d] = self.tile;
        let facets = if d == APEX {
            vec![[a, b, d], [b, c, d], [c, a, d]]
        } else {
            vec![[b, c, d], [a, d, c], [a, b, d], [a, c, b]]
        };
        for [o, p, q] in facets {
            let w = self.points.outer_normal(ring, [o, p, q])?;
            let mut side = Element::default();
            for corner in self.facet.into_iter().filter(|corner| *corner != APEX) {
                side = ring.plus(&side, &ring.inner(&w, &self.points.edge(o, corner)?)?)?;
            }
            let mut side = ring.sign(&side)?;
            if side == Ordering::Equal {
                let forwards = first_sign(ring, &w)?;
                side = if self.outwards == Ordering::Greater {
                    forwards
                } else {
                    forwards.reverse()
                };
            }
            if side != Ordering::Less {
                return Ok(false);
            }
        }
        Ok(true)
    }
}
