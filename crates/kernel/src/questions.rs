//! The questions about regions that need exact coordinates. They are asked with the least integers that suffice.

use crate::grid::APEX;
use crate::int::Int;
use crate::limits::Work;
use crate::meets::{Meets, Rounding};
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
    fn edge<T: Int, const N: usize>(
        &self,
        from: Corner,
        to: Corner,
    ) -> Result<Vector<T, N>, Larger> {
        if to == APEX {
            return Ok([Element::default(), Element::default(), constant(1)]);
        }
        minus(&self.vertices.point(to)?, &self.vertices.point(from)?)
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

fn minus<T: Int, const N: usize>(
    x: &Vector<T, N>,
    y: &Vector<T, N>,
) -> Result<Vector<T, N>, Larger> {
    zip(x, y, |x, y| zip(&x.0, &y.0, T::minus).map(Element))
}

fn constant<T: Int, const N: usize>(value: i64) -> Element<T, N> {
    let mut element = Element::default();
    if let Some(first) = element.0.first_mut() {
        *first = T::of_small(value);
    }
    element
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
pub(crate) struct Pair<'q, const N: usize> {
    pub(crate) points: Points<'q>,
    pub(crate) rings: &'q Rings<N>,
    pub(crate) work: &'q Work,
    pub(crate) common: usize,
    pub(crate) f: Corners,
    pub(crate) g: Corners,
}

impl<const N: usize> Pair<'_, N> {
    /// The corners seen from a corner of f; in the plane as `meets` needs them.
    fn seen<T: Int>(&self, corners: Corners) -> Result<[Vector<T, N>; 3], Larger> {
        let [a, b, _] = self.f;
        let base = self.points.vertices.point(if a == APEX { b } else { a })?;
        let is_plane = self.f.contains(&APEX);
        each(&corners, |corner| {
            if *corner == APEX {
                return Ok(Vector::default());
            }
            let [x, y, z] = minus(&self.points.vertices.point(*corner)?, &base)?;
            Ok([x, y, if is_plane { constant(1) } else { z }])
        })
    }

    /// For rational coordinates in space: by their first 19 bits.
    ///
    /// The vectors whose determinant `meets` computes are differences or sums of two points.
    /// Their entries are at most m = 2^20, with errors below 2. So the error of the determinant is at
    /// most 6 ((m + 2)³ - m³) < 2^46.
    fn by_rounded<T: Int>(
        &self,
        f: &[Vector<T, N>; 3],
        g: &[Vector<T, N>; 3],
    ) -> Result<bool, Larger> {
        let ring = self.rings.small.as_ref().ok_or(Larger)?;
        let all = f.iter().chain(g).flatten().flat_map(|x| &x.0);
        let bits = all.map(T::bits).max().unwrap_or(0);
        let top = |c: &T| c.top(bits.saturating_sub(19));
        let rounded = |x: &Vector<T, N>| each(x, |x| each(&x.0, top).map(Element));
        let (f, g) = (each(f, rounded)?, each(g, rounded)?);
        let mut meets = Meets::new(ring, self.work);
        meets.rounding = Some(Rounding {
            slack: constant(1 << 46),
            length: constant(1 << 20),
        });
        meets.only_in_common(self.common, &f, &g)
    }
}

impl<const N: usize> Question<N> for Pair<'_, N> {
    type Answer = bool;

    fn ask<T: Int>(&self, ring: &Exact<T, N>) -> Result<bool, Larger> {
        let (f, g) = (self.seen(self.f)?, self.seen(self.g)?);
        let (common, work) = (self.common, self.work);
        let exactly = || Meets::new(ring, work).only_in_common(common, &f, &g);
        let by_intervals = || {
            let ring = &self.rings.intervals;
            let enclosed = |x: &Vector<T, N>| each(x, |x| ring.of(&x.0));
            let (f, g) = (each(&f, enclosed)?, each(&g, enclosed)?);
            Meets::new(ring, work).only_in_common(common, &f, &g)
        };
        // Rounded numbers decide nothing that is not true. They are faster than long products.
        if N == 1 && T::PRICE == 1 {
            let rounded = |Larger| self.by_rounded(&f, &g);
            exactly().or_else(rounded).or_else(|Larger| by_intervals())
        } else {
            by_intervals().or_else(|Larger| exactly())
        }
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
