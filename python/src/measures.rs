//! Dihedral angles of all simplices as enclosures in doubles.

use acutile_core::quality::{DihedralAngle, Exact, display_width};
use acutile_core::tiling::{AnyTiling, SimplexId, Tiling};
use acutile_core::with_dimension;
use acutile_exact::geometry::linear;
use malachite::Rational;
use malachite::base::num::conversion::traits::RoundingFrom;
use malachite::base::rounding_modes::RoundingMode::{Ceiling, Floor};
use rayon::prelude::*;

/// Rows of lower and of upper ends.
type Enclosures = (Vec<Vec<f64>>, Vec<Vec<f64>>);

/// The angles of each simplex at its edges, or at its corners in the plane, in degrees. Column k
/// belongs to the pair k of facets (0,1), (0,2), ..., (D-1,D).
pub fn angles(tiling: &AnyTiling) -> Enclosures {
    with_dimension!(tiling, AnyTiling, t => of_tiling(t))
}

fn of_tiling<const D: usize>(tiling: &Tiling<D>) -> Enclosures {
    let gram = linear::cofactors(&tiling.frame.gram);
    let simplices = (0..tiling.len()).into_par_iter().map(SimplexId::at);
    let rows = simplices.map(|simplex| {
        let products = tiling.shape(simplex).normal_products(&gram);
        let pairs = (0..=D).flat_map(|i| (i + 1..=D).map(move |j| (i, j)));
        let ends = pairs.map(|(i, j)| DihedralAngle::between(&products, i, j));
        ends.map(in_degrees).unzip()
    });
    rows.unzip()
}

/// The ends for an angle; a flat simplex has none, which arrays write as NaN.
fn in_degrees(angle: Option<DihedralAngle>) -> (f64, f64) {
    match angle.map(|angle| angle.enclosure(&display_width())) {
        Some((low, high)) => (below(&low), above(&high)),
        None => (f64::NAN, f64::NAN),
    }
}

fn below(value: &Rational) -> f64 {
    f64::rounding_from(value, Floor).0
}

fn above(value: &Rational) -> f64 {
    f64::rounding_from(value, Ceiling).0
}
