//! Dihedral angles in degrees, as rational intervals.

use super::measure::{DihedralAngle, Exact};
use acutile_exact::geometry::NormalProducts;
use acutile_exact::number::Number;
use malachite::Rational;

/// The width of angle enclosures in messages: 1e-6 degrees.
pub fn display_width() -> Rational {
    Rational::from_signeds(1, 1_000_000)
}

/// The dihedral angle between two facets, enclosed in an interval of at most the
/// given width, in degrees; `None` if a facet is degenerate.
pub fn dihedral_degrees<const D: usize>(
    products: &NormalProducts<Number, D>,
    (i, j): (usize, usize),
    width: &Rational,
) -> Option<(Rational, Rational)> {
    Some(DihedralAngle::between(products, i, j)?.enclosure(width))
}
