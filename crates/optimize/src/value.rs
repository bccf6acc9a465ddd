//! The proved value that a goal is about.

use crate::goal::Goal;
use acutile_core::quality::{DihedralAngle, Exact, RadiusEdge};
use acutile_core::statement::{Relation, Statement};
use malachite::Rational;

/// An exact extreme over all simplices.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Extreme {
    /// The largest dihedral angle.
    LargestAngle(DihedralAngle),
    /// The smallest dihedral angle.
    SmallestAngle(DihedralAngle),
    /// The largest radius-edge ratio.
    LargestRatio(RadiusEdge),
}

/// The value among proved statements.
pub fn value(statements: &[Statement], goal: Goal) -> Option<Extreme> {
    statements
        .iter()
        .find_map(|statement| match (goal, statement) {
            (
                Goal::MaxDihedral | Goal::Acute,
                Statement::LargestAngle(Relation::Maximum, angle),
            ) => Some(Extreme::LargestAngle(angle.clone())),
            (Goal::MinDihedral, Statement::SmallestAngle(Relation::Minimum, angle)) => {
                Some(Extreme::SmallestAngle(angle.clone()))
            }
            (Goal::RadiusEdge, Statement::RadiusEdge(Relation::Maximum, ratio)) => {
                Some(Extreme::LargestRatio(ratio.clone()))
            }
            _ => None,
        })
}

impl Extreme {
    /// Whether this is the better one of two of the same kind.
    pub fn is_better_than(&self, other: &Extreme) -> bool {
        match (self, other) {
            (Extreme::LargestAngle(a), Extreme::LargestAngle(b)) => a < b,
            (Extreme::SmallestAngle(a), Extreme::SmallestAngle(b)) => a > b,
            (Extreme::LargestRatio(a), Extreme::LargestRatio(b)) => a < b,
            _ => false,
        }
    }

    /// Rational bounds at most `width` apart, in degrees or as a ratio.
    pub fn enclosure(&self, width: &Rational) -> (Rational, Rational) {
        match self {
            Extreme::LargestAngle(angle) | Extreme::SmallestAngle(angle) => angle.enclosure(width),
            Extreme::LargestRatio(ratio) => ratio.enclosure(width),
        }
    }
}
