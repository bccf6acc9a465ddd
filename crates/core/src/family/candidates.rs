//! The statements of a certificate that imply a requirement.

use crate::format::Relation;
use crate::quality::{DihedralAngle, RadiusEdge};
use crate::statement::{Requirement, Statement};
use acutile_exact::number::{Number, enclosure};
use malachite::base::num::arithmetic::traits::{Ceiling, Floor, Pow};
use malachite::{Integer, Rational};

/// Statements that imply a requirement, the simplest first. A bound in degrees becomes a rational
/// cosine beyond it.
pub(super) fn candidates(requirement: &Requirement) -> Vec<Statement> {
    match requirement {
        // One member decides combinatorial statements.
        Requirement::Tiling
        | Requirement::Tcp
        | Requirement::UncrossedPlane(_)
        | Requirement::Connected
        | Requirement::NoCavities
        | Requirement::ManifoldBoundary => Vec::new(),
        Requirement::Acute => vec![Statement::Acute],
        Requirement::Nonobtuse => vec![Statement::Nonobtuse],
        Requirement::Delaunay => vec![Statement::Delaunay],
        Requirement::WeaklyDelaunay => vec![Statement::WeaklyDelaunay],
        Requirement::NotDelaunay => vec![Statement::NotDelaunay],
        Requirement::DihedralBelow(bound) => {
            let cosines = DIGITS.map(|digits| cosine(bound, digits, true));
            let angles = cosines.map(|c| DihedralAngle::of_cosine(&c));
            let statement = |angle| Statement::LargestAngle(Relation::LessThan, angle);
            angles.map(statement).to_vec()
        }
        Requirement::DihedralAbove(bound) => {
            let cosines = DIGITS.map(|digits| cosine(bound, digits, false));
            let angles = cosines.map(|c| DihedralAngle::of_cosine(&c));
            let statement = |angle| Statement::SmallestAngle(Relation::MoreThan, angle);
            angles.map(statement).to_vec()
        }
        Requirement::RadiusEdgeBelow(bound) => {
            let square = Number::from(bound * bound);
            vec![Statement::RadiusEdge(
                Relation::LessThan,
                RadiusEdge { square },
            )]
        }
    }
}

/// Digits of the cosines that are tried.
const DIGITS: [u64; 3] = [4, 8, 16];

/// A decimal that is at least the cosine of these degrees, or at most.
fn cosine(degrees: &Rational, digits: u64, is_above: bool) -> Rational {
    let scale = Rational::from(10).pow(digits);
    let width = Rational::from(1) / (&scale * Rational::from(1000));
    let (low, high) = enclosure::cos_of_degrees(degrees, &width);
    let rounded: Integer = if is_above {
        (high * &scale).ceiling()
    } else {
        (low * &scale).floor()
    };
    Rational::from(rounded) / scale
}
