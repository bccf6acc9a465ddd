//! The statements of a claim: terms for the checker, terms over the real numbers, propositions.

use super::error::{NotATheorem, require};
use super::numbers::{element, integer, real};
use acutile_core::format::{Claim, Cosine, Fraction, Relation, Statement};

/// One statement in its three forms.
pub(super) struct Named {
    /// Of type `cstatement`, with integers.
    pub(super) checked: String,
    /// Of type `statement`, with real numbers.
    pub(super) claimed: String,
    /// The proposition about the tiling `@`.
    pub(super) proposition: String,
}

/// All statements but the first, which is the tiling itself.
pub(super) fn named(claim: &Claim) -> Result<Vec<Named>, NotATheorem> {
    let (first, rest) = claim.statements.split_first().ok_or(ORDER)?;
    require(
        *first == Statement::FaceToFaceTiling,
        "the order of the statements",
    )?;
    rest.iter().map(|statement| one(statement, claim)).collect()
}

const ORDER: NotATheorem = NotATheorem::Malformed("the order of the statements");

fn one(statement: &Statement, claim: &Claim) -> Result<Named, NotATheorem> {
    let is_plane = claim.dimension == 2;
    let angle = if is_plane { "angle" } else { "dihedral_angle" };
    let plain = |term: &str, word: &str| {
        Ok(Named {
            checked: format!("C{term} _"),
            claimed: term.to_owned(),
            proposition: format!("{word}{} @", suffix(claim)),
        })
    };
    match statement {
        Statement::FaceToFaceTiling => Err(ORDER),
        Statement::Acute => plain("Acute", "acute"),
        Statement::Nonobtuse => plain("Nonobtuse", "nonobtuse"),
        Statement::LargestAngle(relation, cosine) => {
            let words = ("LargestDihedralAngle", format!("largest_{angle}"));
            angle_bound(words, *relation, cosine, claim)
        }
        Statement::SmallestAngle(relation, cosine) => {
            let words = ("SmallestDihedralAngle", format!("smallest_{angle}"));
            angle_bound(words, *relation, cosine, claim)
        }
        Statement::SquaredRatio(relation, fraction) => ratio_bound(*relation, fraction, claim),
        Statement::UncrossedPlane(_) => Err(NotATheorem::Plane),
        Statement::Delaunay => plain("Delaunay", "delaunay"),
        Statement::WeaklyDelaunay => plain("WeaklyDelaunay", "weakly_delaunay"),
        Statement::Tcp if !is_plane => plain("TCP", "tcp"),
        Statement::Tcp => Err(NotATheorem::Malformed("TCP in the plane")),
        Statement::LocallyDelaunay | Statement::LocallyWeaklyDelaunay => Err(
            NotATheorem::Malformed("a local statement about a domain that is not a region"),
        ),
    }
}

fn suffix(claim: &Claim) -> &'static str {
    if claim.dimension == 2 { "2" } else { "" }
}

fn angle_bound(
    (term, word): (&str, String),
    relation: Relation,
    cosine: &Cosine,
    claim: &Claim,
) -> Result<Named, NotATheorem> {
    let sign = match cosine.sign {
        -1 => "(-1)",
        0 => "0",
        1 => "1",
        _ => return Err(NotATheorem::Malformed("the sign of a cosine")),
    };
    let bound = format!(
        "(acos ({sign} * sqrt {}))",
        quotient(&cosine.square, claim)?
    );
    let checked = format!("{sign} {}", checked(&cosine.square, claim)?);
    Ok(related(term, word, relation, &checked, &bound, claim))
}

fn ratio_bound(
    relation: Relation,
    fraction: &Fraction,
    claim: &Claim,
) -> Result<Named, NotATheorem> {
    let bound = quotient(fraction, claim)?;
    let checked = checked(fraction, claim)?;
    let word = "squared_radius_edge_ratio".to_owned();
    Ok(related(
        "SquaredRadiusEdgeRatio",
        word,
        relation,
        &checked,
        &bound,
        claim,
    ))
}

fn related(
    term: &str,
    word: String,
    relation: Relation,
    checked: &str,
    bound: &str,
    claim: &Claim,
) -> Named {
    let relation = relation_term(relation);
    Named {
        checked: format!("C{term} _ {relation} {checked}"),
        claimed: format!("{term} {relation} {bound}"),
        proposition: format!("{word}{} @ {relation} {bound}", suffix(claim)),
    }
}

fn relation_term(relation: Relation) -> &'static str {
    match relation {
        Relation::LessThan => "LessThan",
        Relation::AtMost => "AtMost",
        Relation::Maximum => "Maximum",
        Relation::MoreThan => "MoreThan",
        Relation::AtLeast => "AtLeast",
        Relation::Minimum => "Minimum",
    }
}

/// Numerator and denominator for the checker.
fn checked(fraction: &Fraction, claim: &Claim) -> Result<String, NotATheorem> {
    let numerator = element(&fraction.numerator, &claim.field)?;
    Ok(format!("{numerator} {}", integer(&fraction.denominator)))
}

/// The fraction over the real numbers. Numerator and denominator stand as in the certificate.
fn quotient(fraction: &Fraction, claim: &Claim) -> Result<String, NotATheorem> {
    require(fraction.denominator > 0, "a denominator is positive")?;
    let one = malachite::Integer::from(1);
    let numerator = real(&fraction.numerator, &one, &claim.field, "a")?;
    Ok(format!("({numerator} / {})", fraction.denominator))
}
