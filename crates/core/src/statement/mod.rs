//! Statements about a tiling, with exact bounds in the tiling's field.
//!
//! The prover makes them, certificates carry them ([`crate::transcribe`]), and `words` writes
//! them for people. [`Requirement`] is a user's request; the prover answers with a statement
//! that implies it.

mod requirement;
mod words;

pub use requirement::{Requirement, contradiction};
pub use words::{counted, in_words, summary};

mod plane;

pub use crate::format::{Plane, Relation};
use crate::quality::{DihedralAngle, RadiusEdge, Range, Ranges};

/// A statement. The order of the variants is the order in a claim.
///
/// Bounds are about three quantities of each simplex: the largest of its dihedral angles, the
/// smallest, and circumradius over shortest edge.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Statement {
    /// The simplices are a face-to-face tiling of the domain.
    FaceToFaceTiling,
    /// Every dihedral angle is less than a right angle.
    Acute,
    /// No dihedral angle is more than a right angle.
    Nonobtuse,
    /// About the largest dihedral angle of each simplex.
    LargestAngle(Relation, DihedralAngle),
    /// About the smallest dihedral angle of each simplex.
    SmallestAngle(Relation, DihedralAngle),
    /// About the radius-edge ratio of each simplex.
    RadiusEdge(Relation, RadiusEdge),
    /// No simplex crosses the plane or a translate of it by the lattice.
    UncrossedPlane(Plane),
    /// No vertex lies in the closed circumball of a simplex but its corners.
    Delaunay,
    /// No vertex lies in the open circumball of a simplex.
    WeaklyDelaunay,
    /// For regions: at each shared facet the opposite corner of the neighbour lies outside of
    /// the circumsphere.
    LocallyDelaunay,
    /// The same, and it may lie on the circumsphere.
    LocallyWeaklyDelaunay,
    /// Some vertex lies in the open circumball of a simplex.
    NotDelaunay,
    /// Tetrahedrally close packed.
    Tcp,
}

impl Statement {
    /// Whether a tiling with `self` and the further statements of the prover has `other`, too.
    /// Only between statements of one kind.
    pub fn implies(&self, other: &Statement) -> bool {
        match (self, other) {
            (Statement::Acute, Statement::Nonobtuse)
            | (Statement::Delaunay, Statement::WeaklyDelaunay)
            | (Statement::LocallyDelaunay, Statement::LocallyWeaklyDelaunay) => true,
            (Statement::LargestAngle(a, x), Statement::LargestAngle(b, y))
            | (Statement::SmallestAngle(a, x), Statement::SmallestAngle(b, y)) => {
                a == b && is_stronger(*a, x, y)
            }
            (Statement::RadiusEdge(a, x), Statement::RadiusEdge(b, y)) => {
                a == b && is_stronger(*a, x, y)
            }
            _ => false,
        }
    }
}

/// Whether the bound x of this relation is stronger than y.
fn is_stronger<T: Ord>(relation: Relation, x: &T, y: &T) -> bool {
    match relation {
        Relation::LessThan | Relation::AtMost | Relation::Maximum => x < y,
        Relation::MoreThan | Relation::AtLeast | Relation::Minimum => x > y,
    }
}

/// The six exact bounds among statements: the least and the greatest value of each quantity over
/// the simplices; `None` if one is not stated.
pub fn ranges(statements: &[Statement]) -> Option<Ranges> {
    let find = |wanted: Relation| {
        let (mut largest, mut smallest, mut ratio) = (None, None, None);
        for statement in statements {
            match statement {
                Statement::LargestAngle(relation, x) if *relation == wanted => largest = Some(x),
                Statement::SmallestAngle(relation, x) if *relation == wanted => smallest = Some(x),
                Statement::RadiusEdge(relation, x) if *relation == wanted => ratio = Some(x),
                _ => {}
            }
        }
        Some((largest?.clone(), smallest?.clone(), ratio?.clone()))
    };
    let (low, high) = (find(Relation::Minimum)?, find(Relation::Maximum)?);
    Some(Ranges {
        largest_dihedral: Range {
            min: low.0,
            max: high.0,
        },
        smallest_dihedral: Range {
            min: low.1,
            max: high.1,
        },
        radius_edge: Range {
            min: low.2,
            max: high.2,
        },
    })
}
