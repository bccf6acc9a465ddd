//! A tiling in, a certificate or a refutation out.
//!
//! [`prove`] runs every hypothesis of the theorem of docs/soundness.md, then the
//! statements that the caller requires, then looks for the strongest further
//! statements that hold. Nothing here is trusted: what comes out is re-checked by
//! [`crate::verifier`].

mod assemble;
mod defect;
mod hypotheses;
mod model;
mod render;
mod statements;

pub use defect::{Angle, Defect, Findings};
pub use hypotheses::{check_corners, check_facets, check_metric, check_orientation, check_volume};
pub use model::Model;
pub use render::describe;
pub use statements::{check_acute, check_delaunay, check_dihedral_below, check_nonobtuse};

use crate::certificate::{Certificate, Statement};
use crate::geometry::Scalar;
use crate::quality;
use crate::tiling::{Corner, Matching, Tiling, match_facets};
use malachite::Rational;
use std::str::FromStr;

/// What to prove beyond the tiling itself.
#[derive(Clone, Debug)]
pub struct Options {
    /// Statements that must hold; where one fails the tiling is refuted.
    pub required: Vec<Statement>,
    /// How many defects of each kind a refutation keeps; all are counted.
    pub defect_limit: usize,
}

impl Default for Options {
    fn default() -> Self {
        Options {
            required: Vec::new(),
            defect_limit: 20,
        }
    }
}

/// Tells how far a long check has come: called with the name of a step when it
/// begins.
pub type Progress<'a> = &'a dyn Fn(&str);

/// Why there is no certificate.
pub type Refutation = Findings;

/// Proves that `tiling` is a face-to-face tiling with the required statements and
/// the strongest of the others that hold.
pub fn prove<const D: usize>(
    tiling: &Tiling<D>,
    options: &Options,
    progress: Progress,
) -> Result<Certificate, Refutation> {
    let mut findings = Findings::new(options.defect_limit);
    progress("metric");
    check_metric(&tiling.frame, &mut findings);
    check_corners(tiling, &mut findings);
    stop_if_any(&findings)?;
    if tiling.frame.field.degree() == 1 {
        prove_over(&Model::rational(tiling), findings, options, progress)
    } else {
        prove_over(&Model::algebraic(tiling), findings, options, progress)
    }
}

fn prove_over<S: Scalar, const D: usize>(
    model: &Model<S, D>,
    mut findings: Findings,
    options: &Options,
    progress: Progress,
) -> Result<Certificate, Refutation> {
    progress("orientation");
    check_orientation(model, &mut findings);
    progress("facets");
    let matching = match_facets(model.tiling);
    check_facets(&matching, &mut findings);
    progress("volume");
    check_volume(model, &mut findings);
    stop_if_any(&findings)?;
    progress("required statements");
    for statement in &options.required {
        check_statement(model, &matching, statement, &mut findings);
    }
    stop_if_any(&findings)?;
    progress("strongest statements");
    let statements = strongest_statements(model, &matching, &options.required);
    progress("certificate");
    Ok(assemble::certificate(model.tiling, &matching, statements))
}

fn stop_if_any(findings: &Findings) -> Result<(), Refutation> {
    if findings.is_empty() {
        Ok(())
    } else {
        Err(findings.clone())
    }
}

/// Checks one statement about a tiling whose hypotheses hold.
fn check_statement<S: Scalar, const D: usize>(
    model: &Model<S, D>,
    matching: &Matching<D>,
    statement: &Statement,
    findings: &mut Findings,
) {
    match statement {
        Statement::FaceToFaceTiling => {}
        Statement::Acute => check_acute(model, findings),
        Statement::Nonobtuse => check_nonobtuse(model, findings),
        Statement::DihedralBelow(bound) => {
            let bound = Rational::from_str(bound).unwrap_or(Rational::from(0));
            check_dihedral_below(model, &bound, findings);
        }
        // Placeholder: the prover neither states nor checks these yet, only the kernel does.
        Statement::DihedralAbove(_) | Statement::RadiusEdgeBelow(_) | Statement::Tcp => {}
        Statement::Delaunay => check_delaunay(model, matching, false, findings),
        Statement::WeaklyDelaunay => check_delaunay(model, matching, true, findings),
    }
}

/// The claim's statements: the tiling; acute, or else nonobtuse; the least bound
/// in whole hundredths of a degree that holds and the required bounds; Delaunay,
/// or else weakly Delaunay.
fn strongest_statements<S: Scalar, const D: usize>(
    model: &Model<S, D>,
    matching: &Matching<D>,
    required: &[Statement],
) -> Vec<Statement> {
    let holds = |statement: &Statement| {
        let mut findings = Findings::new(0);
        check_statement(model, matching, statement, &mut findings);
        findings.is_empty()
    };
    let first_that_holds =
        |choices: [Statement; 2]| choices.into_iter().find(|choice| holds(choice));
    let mut statements = vec![Statement::FaceToFaceTiling];
    statements.extend(first_that_holds([Statement::Acute, Statement::Nonobtuse]));
    statements.extend(
        quality::least_bounds(model.tiling)
            .map(bound_statement)
            .find(holds),
    );
    statements.extend(first_that_holds([
        Statement::Delaunay,
        Statement::WeaklyDelaunay,
    ]));
    statements.extend(required.iter().cloned());
    drop_implied(&mut statements);
    statements
}

fn bound_statement(bound: Rational) -> Statement {
    Statement::DihedralBelow(bound.to_string())
}

/// Sorts, and leaves out what a stronger statement of the list implies.
fn drop_implied(statements: &mut Vec<Statement>) {
    statements.sort();
    statements.dedup();
    let has = |statement: &Statement, list: &[Statement]| list.contains(statement);
    let acute = has(&Statement::Acute, statements);
    let delaunay = has(&Statement::Delaunay, statements);
    let least = statements.iter().filter_map(bound_of).min();
    statements.retain(|statement| match statement {
        Statement::Nonobtuse => !acute,
        Statement::WeaklyDelaunay => !delaunay,
        Statement::DihedralBelow(_) => bound_of(statement) == least,
        _ => true,
    });
}

fn bound_of(statement: &Statement) -> Option<Rational> {
    match statement {
        Statement::DihedralBelow(bound) => Rational::from_str(bound).ok(),
        _ => None,
    }
}

/// A corner in words: `3` or `3+(0, 1, -1)`.
pub fn corner_text<const D: usize>(corner: &Corner<D>, rank: usize) -> String {
    if corner.shift.iter().all(|&s| s == 0) {
        return corner.vertex.to_string();
    }
    let shift: Vec<String> = corner.shift[..rank].iter().map(i32::to_string).collect();
    format!("{}+({})", corner.vertex, shift.join(", "))
}
