//! Runs every hypothesis of the theorem in docs/soundness.md, then the statements that the caller
//! requires, then finds the strongest further statements.
//!
//! Nothing here is trusted. [`crate::proved`] writes the result as a certificate and asks the
//! kernel.

mod apart;
mod boundary;
mod contact;
mod data;
mod defect;
mod domain;
mod duplicates;
mod findings;
mod hypotheses;
mod interfaces;
mod meeting;
mod names;
mod offenders;
mod outside;
mod plane;
mod region;
mod render;
mod required;
mod shared;
mod statements;
mod words;

pub use crate::predicates::Model;
pub use data::defect_data;
pub use defect::{Angle, ContactKind, Defect};
pub use domain::{check_domain, check_facets, check_inside};
pub use findings::Findings;
pub use hypotheses::{Unsided, check_corners, check_metric, check_orientation, check_volume};
pub use names::Names;
pub use offenders::offenders;
pub use region::check_region;
pub use render::describe;
pub use statements::{check_acute, check_delaunay, check_nonobtuse, check_tcp};

use crate::classify;
use crate::format::Relation;
use crate::limits::own_limits;
use crate::quality::{Ranges, exact_ranges};
use crate::statement::{Requirement, Statement};
use crate::tiling::dimension::{same, same_value};
use crate::tiling::{Facet, Matching, Plane, Tiling, match_facets};
use crate::transcribe::Parts;
use acutile_kernel::Limits;
use hypotheses::check_volume_beside;
use std::cmp::Ordering;
use std::collections::BTreeSet;

/// The statements to prove beyond the tiling itself.
#[derive(Clone, Debug)]
pub struct Options {
    /// Statements that must hold; where one fails the tiling is refuted.
    pub required: Vec<Requirement>,
    /// Knowledge about the sides of a periodic mesh.
    pub sides: Sides,
    /// How many defects of each kind a refutation keeps; all are counted.
    pub defect_limit: usize,
    /// Limits of the kernel, which checks the certificate.
    pub limits: Limits,
}

impl Default for Options {
    fn default() -> Self {
        Options {
            required: Vec::new(),
            sides: Sides::default(),
            defect_limit: 20,
            limits: own_limits(),
        }
    }
}

/// Knowledge about the sides of a periodic mesh.
#[derive(Clone, Debug, Default)]
pub struct Sides {
    /// Facets without a mate that must have one.
    pub facets: BTreeSet<Facet>,
    /// Facets that nearly have a mate: whether they should is a question, so nothing is proved.
    pub near: Option<NearMates>,
}

impl Sides {
    /// Whether no facet on the sides lacks its mate, and none nearly has one.
    pub fn are_closed(&self) -> bool {
        self.facets.is_empty() && self.near.is_none()
    }
}

/// Facets that would have a mate if nodes were moved a little.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NearMates {
    /// How many facets.
    pub facets: usize,
    /// How far nodes would be moved, about.
    pub distance: f64,
}

/// Called with the name of each step of a long check when it begins.
pub type Progress<'a> = &'a dyn Fn(&str);

/// A proof in the prover's memory, without the certificate that lets others check it.
#[derive(Clone, Debug)]
pub struct Proof<const D: usize> {
    /// The statement about the tiling, the required statements, and the strongest of the others, in
    /// the order of a claim.
    pub statements: Vec<Statement>,
    pub(crate) matching: Matching<D>,
    sixes: Option<Vec<u8>>,
}

impl<const D: usize> Proof<D> {
    /// The parts of the certificate of the tiling.
    pub fn parts<'t>(&'t self, tiling: &'t Tiling<D>) -> Parts<'t, D> {
        Parts {
            tiling,
            matching: &self.matching,
            statements: &self.statements,
            sixes: self.sixes.as_deref(),
        }
    }

    /// The number of facets without a mate.
    pub fn boundary_facets(&self) -> usize {
        self.matching.mismatches.len()
    }
}

/// Examines a tiling: a proof, or everything that is wrong with it.
///
/// # Errors
/// The defects. See [`Findings::is_declined`].
pub fn examine<const D: usize>(
    tiling: &Tiling<D>,
    options: &Options,
    progress: Progress,
) -> Result<Proof<D>, Findings> {
    match D {
        2 => same_value(examine_plane(same(tiling), options, progress)),
        _ => same_value(examine_space(same(tiling), options, progress)),
    }
}

#[inline(never)]
fn examine_plane(
    tiling: &Tiling<2>,
    options: &Options,
    progress: Progress,
) -> Result<Proof<2>, Findings> {
    examine_tiling(tiling, options, progress)
}

#[inline(never)]
fn examine_space(
    tiling: &Tiling<3>,
    options: &Options,
    progress: Progress,
) -> Result<Proof<3>, Findings> {
    examine_tiling(tiling, options, progress)
}

fn examine_tiling<const D: usize>(
    tiling: &Tiling<D>,
    options: &Options,
    progress: Progress,
) -> Result<Proof<D>, Findings> {
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
) -> Result<Proof<D>, Findings> {
    progress("orientation");
    let unsided = check_orientation(model, &mut findings);
    progress("facets");
    let matching = match_facets(model.tiling);
    let faces = check_inside(model.tiling, planes, &mut findings);
    let surplus = duplicates::check_duplicates(model.tiling, &mut findings);
    domain::check_facets_beside(
        model.tiling,
        &matching,
        &faces,
        &surplus,
        &unsided,
        &mut findings,
    );
    progress("volume");
    check_volume_beside(model, &unsided, &mut findings);
    if model.tiling.frame.domain.is_region() {
        progress("boundary");
        let explained =
            region::check_region_beside(model.tiling, &matching, &unsided, &mut findings);
        for &facet in &options.sides.facets {
            if explained.contains(&facet) {
                findings.add_consequence("unmatched-facet", 1)
            } else {
                findings.add(Defect::UnmatchedFacet { facet })
            }
        }
    }
    stop_if_any(&findings)?;
    if let Some(near) = options.sides.near {
        findings.add(Defect::NearMates(near));
        return Err(findings);
    }
    progress("angles and ratios");
    let Some(ranges) = exact_ranges(model) else {
        // A tiling without simplices has been refused.
        return Err(findings);
    };
    progress("required statements");
    let mut statements = vec![Statement::FaceToFaceTiling];
    for requirement in &options.required {
        let required = required::Required {
            model,
            matching: &matching,
            ranges: &ranges,
        };
        statements.extend(required.statement(requirement, &mut findings));
    }
    stop_if_any(&findings)?;
    progress("strongest statements");
    statements.extend(of_shapes(&ranges));
    statements.extend(delaunay(model, &matching));
    let is_space = model.tiling.frame.domain == crate::tiling::Domain::Space;
    let sixes = if is_space {
        classify::six_valent(model.tiling, &matching)
    } else {
        None
    };
    statements.extend(sixes.as_ref().map(|_| Statement::Tcp));
    Ok(Proof {
        statements: without_implied(statements),
        matching,
        sixes,
    })
}

fn stop_if_any(findings: &Findings) -> Result<(), Findings> {
    if findings.is_empty() {
        Ok(())
    } else {
        Err(findings.clone())
    }
}

/// Acute or nonobtuse, and the exact ranges of the largest angle, the smallest, and the ratio.
fn of_shapes(ranges: &Ranges) -> Vec<Statement> {
    let (largest, smallest) = (&ranges.largest_dihedral, &ranges.smallest_dihedral);
    let ratio = &ranges.radius_edge;
    let right = match largest.max.against_right() {
        Ordering::Less => Some(Statement::Acute),
        Ordering::Equal => Some(Statement::Nonobtuse),
        Ordering::Greater => None,
    };
    right
        .into_iter()
        .chain([
            Statement::LargestAngle(Relation::Maximum, largest.max.clone()),
            Statement::LargestAngle(Relation::Minimum, largest.min.clone()),
            Statement::SmallestAngle(Relation::Maximum, smallest.max.clone()),
            Statement::SmallestAngle(Relation::Minimum, smallest.min.clone()),
            Statement::RadiusEdge(Relation::Maximum, ratio.max.clone()),
            Statement::RadiusEdge(Relation::Minimum, ratio.min.clone()),
        ])
        .collect()
}

/// The stronger of the two Delaunay statements that holds.
fn delaunay<const D: usize>(model: &Model<D>, matching: &Matching<D>) -> Option<Statement> {
    let is_strict = statements::is_strictly_delaunay(model, matching)?;
    let is_region = model.tiling.frame.domain.is_region();
    Some(required::delaunay(is_region, !is_strict))
}

/// Sorted, without statements that a stronger one of the same kind implies.
pub(crate) fn without_implied(mut statements: Vec<Statement>) -> Vec<Statement> {
    statements.sort();
    statements.dedup();
    let all = statements.clone();
    statements.retain(|statement| !all.iter().any(|other| other.implies(statement)));
    statements
}
