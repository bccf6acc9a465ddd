//! Boxes with integer ends: which facets and tiles can have a common point.
//!
//! **Invariant.** A box contains its facet or tile, since its ends are rounded outwards. Things
//! whose boxes are disjoint are disjoint. Nothing else follows from a box.

use crate::int::Int;
use crate::limits::Work;
use crate::refusal::{Checked, Place, Stop};
use crate::ring::{each, zip};
use crate::root::{BITS, Root, enclosure};
use crate::row::{Corner, Shape};
use crate::vertices::Vertices;
use num_bigint::BigInt;
use num_integer::Integer;

/// In the plane, the third corner of each facet. It has no place, and the lattice does not move it.
pub(crate) const APEX: Corner = Corner { vertex: u32::MAX, shift: [0; 3] };

/// The least and the greatest value of each coordinate.
pub(crate) type Bounds = [(i64, i64); 3];

fn moved(bounds: &Bounds, by: &[i64; 3]) -> Checked<Bounds> {
    zip(bounds, by, |(low, high), by| Ok((low + by, high + by)))
}

/// The smallest box that contains both.
fn join(a: &Bounds, b: &Bounds) -> Checked<Bounds> {
    zip(a, b, |a, b| Ok((a.0.min(b.0), a.1.max(b.1))))
}

/// A balanced tree of boxes. The leaves have numbers.
pub(crate) struct Tree {
    bounds: Bounds,
    number: usize,
    children: Vec<Tree>,
}

impl Tree {
    /// Of at least one box.
    pub(crate) fn new(items: &mut [(Bounds, usize)]) -> Checked<Tree> {
        let (first, others) = items.split_first().ok_or(Stop::LARGER)?;
        let (mut bounds, number) = *first;
        for (other, _) in others {
            bounds = join(&bounds, other)?;
        }
        let mut children = Vec::new();
        if !others.is_empty() {
            // By halves along the widest axis.
            let widths = bounds.map(|(low, high)| high - low);
            let axis = (0..3).max_by_key(|&axis| widths.get(axis)).unwrap_or(0);
            let middle = |item: &(Bounds, usize)| item.0.get(axis).map(|x| x.0.midpoint(x.1));
            items.select_nth_unstable_by_key(items.len() / 2, middle);
            let (first, second) = items.split_at_mut(items.len() / 2);
            children = vec![Tree::new(first)?, Tree::new(second)?];
        }
        Ok(Tree { bounds, number, children })
    }

    /// Visits each leaf here and each leaf of the other tree, moved by a vector, whose boxes meet.
    fn each_pair(
        &self,
        other: &Tree,
        by: &[i64; 3],
        work: &Work,
        visit: &mut impl FnMut(usize, usize) -> Checked,
    ) -> Checked {
        work.add(4);
        let moved = moved(&other.bounds, by)?;
        if self.bounds.iter().zip(&moved).any(|(a, b)| a.1 < b.0 || b.1 < a.0) {
            return Ok(());
        }
        work.check(Place::Witness)?;
        if self.children.is_empty() && other.children.is_empty() {
            return visit(self.number, other.number);
        }
        for first in self.parts() {
            for second in other.parts() {
                first.each_pair(second, by, work, visit)?;
            }
        }
        Ok(())
    }

    fn parts(&self) -> &[Tree] {
        if self.children.is_empty() { std::slice::from_ref(self) } else { &self.children }
    }
}

/// Coordinates as integers of at most 43 bits, in one unit for all axes.
pub(crate) struct Grid {
    points: Vec<Bounds>,
    /// The lengths of the lattice's basis vectors. Along other axes, more than the size of any box.
    periods: [i64; 3],
}

impl Grid {
    pub(crate) fn new<const N: usize>(shape: Shape, vertices: &Vertices, root: &Root) -> Checked<Grid> {
        // Integers between which the coordinates lie, times 2^bits. The powers of a large root have no bits after the point.
        let (bits, up) = (BITS.saturating_sub(root.dropped), root.dropped.saturating_sub(BITS));
        let ends = |vertex| -> Checked<[(BigInt, BigInt); 3]> {
            let point = vertices.point::<BigInt, N>(Corner { vertex, shift: [0; 3] })?;
            each(&point, |x| {
                let (middle, radius, s) = enclosure(&x.0, &root.rough)?;
                let floor = |end: i128| (BigInt::from(end) << (s + up)).div_floor(&vertices.denominator);
                Ok((floor(middle - radius.cast_signed()), floor(middle + radius.cast_signed()) + 1))
            })
        };
        let mut most = if shape.rank > 0 { bits } else { 0 };
        for vertex in 0..shape.vertices {
            most = ends(vertex)?.iter().fold(most, |most, (low, high)| most.max(low.bits()).max(high.bits()));
        }
        let dropped = most.saturating_sub(42);
        let bounds = |vertex| each(&ends(vertex)?, |(low, high)| Ok((low.top(dropped)?, high.top(dropped)? + 1)));
        let points = (0..shape.vertices).map(bounds).collect::<Checked<_>>()?;
        let mut grid = Grid { points, periods: [1 << 62; 3] };
        for period in grid.periods.iter_mut().take(shape.rank) {
            // A whole number of units, unless a coordinate has more than 42 bits in periods.
            let kept = bits.checked_sub(dropped).ok_or(Stop::LARGER)?;
            *period = (BigInt::from(1) << kept).top(0)?;
        }
        Ok(grid)
    }

    /// The box of the corners.
    pub(crate) fn bounds(&self, corners: &[Corner]) -> Checked<Bounds> {
        let mut all = None;
        for corner in corners.iter().filter(|corner| **corner != APEX) {
            let index = usize::try_from(corner.vertex).map_err(|_| Stop::LARGER)?;
            let point = self.points.get(index).ok_or(Stop::LARGER)?;
            let point = moved(point, &self.vector(corner.shift)?)?;
            all = Some(join(&all.unwrap_or(point), &point)?);
        }
        all.ok_or(Stop::LARGER)
    }

    /// Visits each leaf of the two trees, after each translation of the second one, whose boxes meet.
    pub(crate) fn each_near(
        &self,
        first: &Tree,
        second: &Tree,
        work: &Work,
        visit: &mut impl FnMut([i32; 3], usize, usize) -> Checked,
    ) -> Checked {
        let ranges = zip(&first.bounds, &second.bounds, |a, b| Ok((b.1 - a.0, a.1 - b.0)))?;
        let [x, y, z] = zip(&ranges, &self.periods, |(back, forth), period| {
            let entries = (-back.div_euclid(*period), forth.div_euclid(*period));
            Ok((to_entry(entries.0)?, to_entry(entries.1)?))
        })?;
        for x in x.0..=x.1 {
            for y in y.0..=y.1 {
                for z in z.0..=z.1 {
                    let by = self.vector([x, y, z])?;
                    first.each_pair(second, &by, work, &mut |f, g| visit([x, y, z], f, g))?;
                }
            }
        }
        Ok(())
    }

    fn vector(&self, shift: [i32; 3]) -> Checked<[i64; 3]> {
        zip(&shift, &self.periods, |entry, period| Ok(i64::from(to_entry((*entry).into())?) * period))
    }
}

/// Declines larger translations under all limits, so that no sum of ends is too large.
fn to_entry(entry: i64) -> Checked<i32> {
    let small = i32::try_from(entry).ok().filter(|entry| entry.unsigned_abs() < 1 << 18);
    Ok(some!(small, Work, Place::Witness, entry))
}
