//! The claim of a system of patches in words.

use crate::format::patches::Claim;
use crate::statement::{Relation, Statement, in_words as statement_in_words};
use crate::transcribe::{Numbers, ReadError};

/// The claim in one line.
///
/// # Errors
/// If the claim's field is none, or beyond the prover's limits.
pub fn in_words(claim: &Claim) -> Result<String, ReadError> {
    let numbers = Numbers::of(&claim.field)?;
    let sides = claim.tiles.iter().map(|tile| tile.vertices.len());
    let mut words = match claim.rank {
        1 => format!(
            "over every edge-to-edge tiling of the plane by moved and turned copies of {} (sides: {})",
            counted(claim.tiles.len(), "convex polygon"),
            sides.map(|n| n.to_string()).collect::<Vec<_>>().join(", "),
        ),
        _ => format!(
            "over every division of the line into moved copies of {}",
            counted(claim.tiles.len(), "segment")
        ),
    };
    if claim
        .tiles
        .iter()
        .flat_map(|tile| &tile.classes)
        .any(|class| Some(class) != claim.tiles[0].classes.first())
    {
        words += " in which sides of one class meet";
    }
    words += ", periodic or not, the patches build a tiling of three-space, face to face";
    for statement in &claim.statements {
        let statement = numbers.statement(statement)?;
        if statement != Statement::FaceToFaceTiling {
            words += "; ";
            words += &statement_in_words(&statement, 3);
            if is_attained(&statement) {
                words += " wherever a certain tile occurs";
            }
        }
    }
    Ok(words)
}

/// Whether the statement says that a bound is attained: by a cell over some tile.
fn is_attained(statement: &Statement) -> bool {
    use Relation::{Maximum, Minimum};
    matches!(
        statement,
        Statement::LargestAngle(Maximum | Minimum, _)
            | Statement::SmallestAngle(Maximum | Minimum, _)
            | Statement::RadiusEdge(Maximum | Minimum, _)
    )
}

fn counted(count: usize, name: &str) -> String {
    match count {
        1 => format!("one {name}"),
        n => format!("{n} {name}s"),
    }
}
