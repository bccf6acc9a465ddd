//! Dihedral angles of all simplices as enclosures in doubles.

use super::error::failed;
use acutile_core::checker::{Findings, check_metric};
use acutile_core::proved::NotProved;
use acutile_core::quality::{DihedralAngle, Exact, display_width};
use acutile_core::tiling::{AnyTiling, SimplexId, Tiling};
use acutile_core::with_dimension;
use acutile_exact::geometry::linear;
use malachite::Rational;
use malachite::base::num::conversion::traits::RoundingFrom;
use malachite::base::rounding_modes::RoundingMode::{Ceiling, Floor};
use pyo3::PyResult;
use rayon::prelude::*;

/// Lower and upper ends, those of a simplex one after the other.
type Enclosures = (Vec<f64>, Vec<f64>);

/// The number of dihedral angles of a simplex.
pub fn angles_of_simplex(dimension: usize) -> usize {
    dimension * (dimension + 1) / 2
}

/// The angles of each simplex at its edges, or at its corners in the plane, in degrees. Column k
/// belongs to the pair k of facets (0,1), (0,2), ..., (D-1,D).
///
/// # Errors
/// A Gram matrix that is not positive definite.
pub fn angles(tiling: &AnyTiling) -> PyResult<Enclosures> {
    with_dimension!(tiling, AnyTiling, t => of_tiling(t))
}

fn of_tiling<const D: usize>(tiling: &Tiling<D>) -> PyResult<Enclosures> {
    let mut findings = Findings::new(1);
    check_metric(&tiling.frame, &mut findings);
    if !findings.is_empty() {
        return Err(failed(NotProved::Refuted(findings).in_words(tiling)));
    }
    let gram = linear::cofactors(&tiling.frame.gram);
    let simplices = (0..tiling.len()).into_par_iter().map(SimplexId::at);
    let rows = simplices.map(|simplex| {
        let products = tiling.shape(simplex).normal_products(&gram);
        let pairs = (0..=D).flat_map(|i| (i + 1..=D).map(move |j| (i, j)));
        let ends = pairs.map(|(i, j)| DihedralAngle::between(&products, i, j));
        ends.map(in_degrees).collect::<Vec<_>>()
    });
    Ok(rows.flatten_iter().unzip())
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
