//! Integers between which the coordinates lie, and the translations that can bring two boxes together.
//!
//! All axes have one unit, so chosen that coordinates and the period have at most 40 bits.

use crate::boxes::Bounds;
use crate::int::Int;
use crate::limits::Work;
use crate::refusal::{Checked, Larger, Limit, Place, Stop, Value};
use crate::ring::{Element, each};
use crate::root::{BITS, Root, enclosure};
use crate::row::{Corner, Shape};
use crate::vertices::Vertices;
use num_bigint::BigInt;

const SIZE: i64 = 40;
/// Bits of the period after the point.
const FRACTION: u32 = 32;
/// Units of work for one translation.
const PRICE: u64 = 4;
/// Bounds the entries of translations. Sums of three fit 32 bits.
const MOST_SHIFT: i64 = 1 << 29;
/// Bounds the ends of boxes. Sums of a few fit 64 bits.
const MOST_END: i128 = 1 << 58;

/// In the plane, the third corner of each facet. It has no place, and the lattice does not move it.
pub(crate) const APEX: Corner = Corner {
    vertex: u32::MAX,
    shift: [0; 3],
};

pub(crate) struct Grid {
    /// A coordinate of a vertex lies between an integer here and that plus `width`.
    points: Vec<[i64; 3]>,
    width: i64,
    rank: usize,
    /// The period lies between this and the next integer, in units of 2^-FRACTION.
    period: i128,
    /// The period lies between this and the next integer.
    whole_period: i64,
}

/// A number lies between low 2^dropped and high 2^dropped; all numbers have one further factor.
type Enclosure = (i128, i128, i64);

impl Grid {
    pub(crate) fn new<const N: usize>(
        shape: Shape,
        vertices: &Vertices,
        root: &Root,
    ) -> Result<Grid, Larger> {
        // Enclosures have the factor 2^-exponent.
        let exponent = signed(BITS)? - signed(root.dropped)?;
        let mut most = 0;
        if shape.rank > 0 {
            most = signed(vertices.denominator.bits())? + exponent;
        }
        for vertex in 0..shape.vertices {
            for (low, high, dropped) in enclosures::<N>(vertices, root, vertex)? {
                most = most.max(signed(low.bits().max(high.bits()))? + dropped);
            }
        }
        let unit = most - SIZE;
        let mut grid = Grid {
            points: Vec::new(),
            width: 1,
            rank: shape.rank,
            period: 0,
            whole_period: 1,
        };
        for vertex in 0..shape.vertices {
            let mut point = [0; 3];
            let enclosures = enclosures::<N>(vertices, root, vertex)?;
            for (slot, (low, high, dropped)) in point.iter_mut().zip(enclosures) {
                let shift = u64::try_from(unit - dropped).map_err(|_| Larger)?;
                *slot = low.top(shift)?;
                grid.width = grid.width.max(high.top(shift)? + 1 - *slot);
            }
            grid.points.push(point);
        }
        if shape.rank > 0 {
            let shift = exponent + i64::from(FRACTION) - unit;
            let left = BigInt::from(1) << shift.max(0);
            grid.period = i128::of(&((&vertices.denominator * left) >> (-shift).max(0)))?;
            grid.whole_period = grid.period.top(FRACTION.into())?;
            if grid.whole_period == 0 {
                return Err(Larger);
            }
        }
        Ok(grid)
    }

    /// The box of these corners.
    pub(crate) fn bounds(&self, corners: &[Corner]) -> Checked<Bounds> {
        let mut all: Option<Bounds> = None;
        for corner in corners.iter().filter(|corner| **corner != APEX) {
            let index = usize::try_from(corner.vertex).unwrap_or(usize::MAX);
            let low = *at(&self.points, index)?;
            let high = low.map(|x| x + self.width);
            let moved = self.translation(corner.shift)?;
            let bounds = moved.plus(&Bounds { low, high });
            all = Some(all.map_or(bounds, |all| all.join(&bounds)));
        }
        Ok(all.unwrap_or_default())
    }

    /// A box that contains the centroid of the corners.
    pub(crate) fn centroid(&self, corners: &[Corner]) -> Checked<Bounds> {
        let (mut sum, mut number) = (Bounds::default(), 0);
        for corner in corners.iter().filter(|corner| **corner != APEX) {
            sum = sum.plus(&self.bounds(&[*corner])?);
            number += 1;
        }
        Ok(Bounds {
            low: sum.low.map(|x| x.div_euclid(number.max(1))),
            high: sum.high.map(|x| x.div_euclid(number.max(1)) + 1),
        })
    }

    /// A box that contains the lattice vector.
    pub(crate) fn translation(&self, shift: [i32; 3]) -> Checked<Bounds> {
        let mut bounds = Bounds::default();
        if shift == [0; 3] {
            return Ok(bounds);
        }
        let ends = bounds.low.iter_mut().zip(&mut bounds.high);
        for ((low, high), entry) in ends.zip(shift) {
            let entry = i128::from(entry);
            let (a, b) = (self.period * entry, (self.period + 1) * entry);
            let (least, most) = (a.min(b) >> FRACTION, (a.max(b) >> FRACTION) + 1);
            let is_within = -MOST_END < least && most < MOST_END;
            ensure!(
                is_within,
                Work,
                Place::Witness,
                Value::Exceeds(Limit::Work, None)
            );
            *low = i64::try_from(least).unwrap_or(0);
            *high = i64::try_from(most).unwrap_or(0);
        }
        Ok(bounds)
    }

    /// The translation that brings the lower end of the box near the cell.
    pub(crate) fn home(&self, bounds: &Bounds) -> Checked<[i32; 3]> {
        let mut home = [0; 3];
        for (entry, low) in home.iter_mut().zip(bounds.low).take(self.rank) {
            *entry = to_shift(-low.div_euclid(self.whole_period))?;
        }
        Ok(home)
    }

    /// Visits each translation after which the second box can meet the first one.
    pub(crate) fn each_translation(
        &self,
        first: &Bounds,
        second: &Bounds,
        work: &Work,
        mut visit: impl FnMut([i32; 3]) -> Checked,
    ) -> Checked {
        let ([a, b, c], [d, e, f]) = (first.low, first.high);
        let ([p, q, r], [s, t, u]) = (second.low, second.high);
        let range = |axis, down, up| {
            if axis < self.rank {
                -self.most_within(down)..=self.most_within(up)
            } else {
                0..=0
            }
        };
        for x in range(0, s - a, d - p) {
            for y in range(1, t - b, e - q) {
                for z in range(2, u - c, f - r) {
                    work.add(PRICE);
                    work.check(Place::Witness)?;
                    visit([to_shift(x)?, to_shift(y)?, to_shift(z)?])?;
                }
            }
        }
        Ok(())
    }

    /// Not less than floor(distance / period).
    fn most_within(&self, distance: i64) -> i64 {
        if distance >= 0 {
            distance / self.whole_period
        } else {
            distance / (self.whole_period + 1)
        }
    }
}

/// The corner, moved by a lattice vector.
pub(crate) fn moved(corner: Corner, shift: [i32; 3]) -> Corner {
    if corner == APEX {
        APEX
    } else {
        corner.moved_by(Corner { vertex: 0, shift })
    }
}

/// An entry of a list that has it.
pub(crate) fn at<T>(list: &[T], index: usize) -> Checked<&T> {
    let entry = list.get(index);
    entry.ok_or_else(|| Stop::Larger.at_last(Place::Witness))
}

fn to_shift(entry: i64) -> Checked<i32> {
    let is_within = entry.abs() < MOST_SHIFT;
    ensure!(
        is_within,
        Work,
        Place::Witness,
        Value::Exceeds(Limit::Work, None)
    );
    Ok(i32::try_from(entry).unwrap_or(0))
}

fn enclosures<const N: usize>(
    vertices: &Vertices,
    root: &Root,
    vertex: u32,
) -> Result<[Enclosure; 3], Larger> {
    fn of<T: Int, const N: usize>(
        point: Result<[Element<T, N>; 3], Larger>,
        root: &Root,
    ) -> Result<[Enclosure; 3], Larger> {
        each(&point?, |x| {
            let (low, high, dropped) = enclosure(&x.0, &root.rough)?;
            Ok((low, high, signed(dropped)?))
        })
    }
    of::<i64, N>(vertices.get(vertex), root)
        .or_else(|Larger| of::<BigInt, N>(vertices.get(vertex), root))
}

fn signed(x: u64) -> Result<i64, Larger> {
    i64::try_from(x).map_err(|_| Larger)
}
