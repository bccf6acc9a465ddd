//! Planes that no simplex crosses.
//!
//! Let g be the greatest common divisor of the normal's entries at the lattice. The translates of the plane
//! are those with the offsets q + g k. The numbers (normal · x - q) / g of a simplex that crosses none are
//! between two successive integers. For g = 0 there is one plane, and no sign changes.

use super::defect::Defect;
use super::findings::Findings;
use crate::statement::Plane;
use crate::tiling::{Corner, Tiling};
use acutile_exact::geometry::Sign;
use acutile_exact::number::Number;
use malachite::Rational;
use malachite::base::num::arithmetic::traits::Gcd;

/// Refutes with each simplex that crosses a translate of the plane.
pub fn check_plane<const D: usize>(tiling: &Tiling<D>, plane: &Plane, findings: &mut Findings) {
    let rank = tiling.frame.rank();
    let of_lattice = plane.normal.iter().take(rank);
    let step = of_lattice.fold(0, |gcd: u32, c| gcd.gcd(c.unsigned_abs()));
    let unit = Rational::from(step.max(1));
    let offset = plane.value();
    // Of a vertex normal · x - q, in units of the step; corners add integers.
    let height = |vertex: [Number; D]| {
        let terms = vertex.iter().zip(&plane.normal);
        let value = terms.fold(Number::zero(), |sum, (x, c)| {
            sum + x * &Number::from(Rational::from(*c))
        });
        (value - Number::from(offset.clone())) * Number::from(Rational::from(1) / &unit)
    };
    let heights: Vec<Number> = tiling.vertices.iter().map(height).collect();
    let at = |corner: &Corner<D>| {
        let shift = corner.shift.iter().zip(&plane.normal);
        let moved: i64 = shift.map(|(s, c)| i64::from(*s) * i64::from(*c)).sum();
        &heights[corner.vertex.index()] + &Number::from(Rational::from(moved) / &unit)
    };
    for (index, corners) in tiling.indices().zip(tiling.simplices()) {
        let values: Vec<Number> = corners.iter().map(at).collect();
        let (Some(low), Some(high)) = (values.iter().min(), values.iter().max()) else {
            continue;
        };
        // The first translate above the lowest corner; for one plane itself.
        let next = match step {
            0 => Rational::from(0),
            _ => Rational::from(low.floor()) + Rational::from(1),
        };
        let is_beyond = |x: &Number| (x - &Number::from(next.clone())).sign();
        if is_beyond(low) == Sign::Less && is_beyond(high) == Sign::Greater {
            let value = |x: &Number| x * &Number::from(unit.clone()) + Number::from(offset.clone());
            findings.add(Defect::PlaneCrossed {
                simplex: index,
                plane: plane.clone(),
                offset: &offset + next * &unit,
                sides: (value(low), value(high)),
            });
        }
    }
}
