//! A tiling in, a certificate or a refutation out.
//!
//! [`prove`] runs every hypothesis of the theorem of docs/soundness.md, then the
//! statements that the caller requires, then looks for the strongest further
//! statements that hold. Nothing here is trusted: what comes out is re-checked by
//! [`acutile_format1::verifier`].

pub mod assemble;
mod data;
mod defect;
mod domain;
mod hypotheses;
mod names;
mod region;
mod render;
mod statements;

pub use crate::predicates::Model;
pub use data::defect_data;
pub use defect::{Angle, Defect, Findings};
pub use domain::{Boundary, check_domain, check_facets, check_inside};
pub use hypotheses::{check_corners, check_metric, check_orientation, check_volume};
pub use names::Names;
pub use region::check_region;
pub use render::describe;
pub use statements::{
    check_acute, check_delaunay, check_dihedral_above, check_dihedral_below, check_nonobtuse,
    check_radius_edge_below, check_tcp,
};

use crate::quality;
use crate::tiling::{Domain, Matching, Plane, Tiling, match_facets};
use acutile_format1::certificate::{Certificate, Statement};
use malachite::Rational;
use std::io;
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
    let proof = examine(tiling, options, progress)?;
    progress("certificate");
    Ok(assemble::certificate(
        tiling,
        &proof.matching,
        &proof.boundary,
        proof.statements,
    ))
}

/// A proof as the prover holds it, without the certificate that lets others check it.
#[derive(Clone, Debug)]
pub struct Proof<const D: usize> {
    /// What holds: the tiling, what is required, the strongest of the others.
    pub statements: Vec<Statement>,
    matching: Matching<D>,
    boundary: Boundary,
}

impl<const D: usize> Proof<D> {
    /// Writes the certificate of the tiling that was proved, in CBOR, a row at a time.
    ///
    /// # Errors
    /// Where `out` cannot be written.
    pub fn write_cbor(&self, tiling: &Tiling<D>, out: &mut impl io::Write) -> io::Result<()> {
        let statements = self.statements.clone();
        assemble::write_cbor(tiling, &self.matching, &self.boundary, statements, out)
    }
}

/// As [`prove`], and makes no certificate.
pub fn examine<const D: usize>(
    tiling: &Tiling<D>,
    options: &Options,
    progress: Progress,
) -> Result<Proof<D>, Refutation> {
    let mut findings = Findings::new(options.defect_limit);
    progress("metric");
    check_metric(&tiling.frame, &mut findings);
    check_corners(tiling, &mut findings);
    let planes = check_domain(tiling, &mut findings);
    stop_if_any(&findings)?;
    progress("coordinates");
    examine_model(&Model::new(tiling), &planes, findings, options, progress)
}

fn examine_model<const D: usize>(
    model: &Model<D>,
    planes: &[Plane],
    mut findings: Findings,
    options: &Options,
    progress: Progress,
) -> Result<Proof<D>, Refutation> {
    progress("orientation");
    check_orientation(model, &mut findings);
    progress("facets");
    let matching = match_facets(model.tiling);
    let faces = check_inside(model.tiling, planes, &mut findings);
    let boundary = check_facets(model.tiling, &matching, &faces, &mut findings);
    progress("volume");
    check_volume(model, &mut findings);
    if model.tiling.frame.domain == Domain::Region {
        progress("boundary");
        check_region(model.tiling, &matching, &mut findings);
    }
    stop_if_any(&findings)?;
    progress("required statements");
    for statement in &options.required {
        check_statement(model, &matching, statement, &mut findings);
    }
    stop_if_any(&findings)?;
    progress("strongest statements");
    let statements = strongest_statements(model, &matching, &options.required);
    Ok(Proof {
        statements,
        matching,
        boundary,
    })
}

fn stop_if_any(findings: &Findings) -> Result<(), Refutation> {
    if findings.is_empty() {
        Ok(())
    } else {
        Err(findings.clone())
    }
}

/// Checks one statement about a tiling whose hypotheses hold.
fn check_statement<const D: usize>(
    model: &Model<D>,
    matching: &Matching<D>,
    statement: &Statement,
    findings: &mut Findings,
) {
    match statement {
        Statement::FaceToFaceTiling => {}
        Statement::Acute => check_acute(model, findings),
        Statement::Nonobtuse => check_nonobtuse(model, findings),
        Statement::DihedralBelow(bound) => {
            check_dihedral_below(model, &bound_value(bound), findings);
        }
        Statement::DihedralAbove(bound) => {
            check_dihedral_above(model, &bound_value(bound), findings);
        }
        Statement::RadiusEdgeBelow(bound) => {
            check_radius_edge_below(model, &bound_value(bound), findings);
        }
        Statement::Delaunay | Statement::WeaklyDelaunay
            if model.tiling.frame.domain == Domain::Region =>
        {
            findings.add(Defect::DelaunayOfRegion);
        }
        Statement::Delaunay => check_delaunay(model, matching, false, findings),
        Statement::WeaklyDelaunay => check_delaunay(model, matching, true, findings),
        Statement::Tcp => check_tcp(model.tiling, matching, findings),
    }
}

/// The bound of a statement; a text that is none bounds nothing.
fn bound_value(text: &str) -> Rational {
    Rational::from_str(text).unwrap_or(Rational::from(0))
}

/// The claim's statements: the tiling; acute, or else nonobtuse; the tightest bounds of
/// angles and ratios; Delaunay, or else weakly Delaunay; TCP; and whatever is required.
fn strongest_statements<const D: usize>(
    model: &Model<D>,
    matching: &Matching<D>,
    required: &[Statement],
) -> Vec<Statement> {
    let holds = |statement: &Statement| {
        let mut findings = Findings::new(0);
        check_statement(model, matching, statement, &mut findings);
        findings.is_empty()
    };
    let first = |choices: Vec<Statement>| choices.into_iter().find(|choice| holds(choice));
    let bounds = quality::bounds(model);
    let bounded = |bounds: Vec<Rational>, statement: fn(String) -> Statement| {
        first(
            bounds
                .iter()
                .map(|bound| statement(bound.to_string()))
                .collect(),
        )
    };
    let mut statements = vec![Statement::FaceToFaceTiling];
    statements.extend(first(vec![Statement::Acute, Statement::Nonobtuse]));
    statements.extend(bounded(bounds.above_angles, Statement::DihedralBelow));
    statements.extend(bounded(bounds.below_angles, Statement::DihedralAbove));
    statements.extend(bounded(bounds.above_ratios, Statement::RadiusEdgeBelow));
    statements.extend(first(vec![Statement::Delaunay, Statement::WeaklyDelaunay]));
    statements.extend(first(vec![Statement::Tcp]));
    statements.extend(required.iter().cloned());
    without_implied(statements)
}

/// Sorted, without what a stronger statement of the list implies.
fn without_implied(mut statements: Vec<Statement>) -> Vec<Statement> {
    statements.sort();
    statements.dedup();
    let all = statements.clone();
    statements.retain(|statement| !all.iter().any(|other| implies(other, statement)));
    statements
}

/// Whether `a` is stronger than `b`.
fn implies(a: &Statement, b: &Statement) -> bool {
    match (a, b) {
        (Statement::Acute, Statement::Nonobtuse) => true,
        (Statement::Delaunay, Statement::WeaklyDelaunay) => true,
        (Statement::DihedralBelow(a), Statement::DihedralBelow(b))
        | (Statement::RadiusEdgeBelow(a), Statement::RadiusEdgeBelow(b)) => {
            bound_value(a) < bound_value(b)
        }
        (Statement::DihedralAbove(a), Statement::DihedralAbove(b)) => {
            bound_value(a) > bound_value(b)
        }
        _ => false,
    }
}
