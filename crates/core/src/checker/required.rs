//! Requirements of a user, decided: a statement for the claim, or the defects.
//!
//! A bound in degrees becomes a rational cosine between the bound and the angle. So the statement
//! implies the requirement, and no degrees occur in a certificate.

use super::findings::Findings;
use super::plane::check_plane;
use super::statements::{
    check_acute, check_delaunay, check_nonobtuse, check_tcp, list_not_above, list_not_below,
    list_not_below_ratio,
};
use crate::anatomy::Anatomy;
use crate::classify::NotTcp;
use crate::format::Relation;
use crate::predicates::Model;
use crate::quality::{DihedralAngle, RadiusEdge, Ranges, cosine_above, cosine_below};
use crate::statement::{Plane, Requirement, Statement};
use crate::tiling::{Corner, Domain, Matching};
use acutile_exact::number::Number;
use malachite::Rational;

/// A tiling whose hypotheses hold.
pub(super) struct Required<'m, const D: usize> {
    pub model: &'m Model<'m, D>,
    pub matching: &'m Matching<D>,
    pub ranges: &'m Ranges,
}

impl<const D: usize> Required<'_, D> {
    /// The statement that implies the requirement; `None` if it does not hold, or holds for every
    /// tiling. Defects are added to the findings.
    pub fn statement(
        &self,
        requirement: &Requirement,
        findings: &mut Findings,
    ) -> Option<Statement> {
        let mut found = Findings::new(findings.limit());
        let statement = self.decide(requirement, &mut found);
        let holds = found.is_empty();
        findings.append(found);
        statement.filter(|_| holds)
    }

    fn decide(&self, requirement: &Requirement, findings: &mut Findings) -> Option<Statement> {
        let Required {
            model, matching, ..
        } = self;
        match requirement {
            Requirement::Tiling => None,
            Requirement::Acute => {
                check_acute(model, findings);
                Some(Statement::Acute)
            }
            Requirement::Nonobtuse => {
                check_nonobtuse(model, findings);
                Some(Statement::Nonobtuse)
            }
            Requirement::DihedralBelow(bound) => self.dihedral_below(bound, findings),
            Requirement::DihedralAbove(bound) => self.dihedral_above(bound, findings),
            Requirement::RadiusEdgeBelow(bound) => self.radius_edge_below(bound, findings),
            Requirement::Delaunay | Requirement::WeaklyDelaunay => {
                let weak = *requirement == Requirement::WeaklyDelaunay;
                check_delaunay(model, matching, weak, findings);
                Some(delaunay(model.tiling.frame.domain.is_region(), weak))
            }
            Requirement::NotDelaunay => {
                let mut inside = Findings::new(1);
                check_delaunay(model, matching, true, &mut inside);
                if inside.is_empty() {
                    findings.add(super::Defect::NoneInside);
                }
                Some(Statement::NotDelaunay)
            }
            Requirement::UncrossedPlane(plane) => self.uncrossed(plane, findings),
            Requirement::Tcp if model.tiling.frame.domain != Domain::Space => {
                let reason = match D {
                    3 => NotTcp::Boundary,
                    _ => NotTcp::Dimension,
                };
                findings.add(super::Defect::NotTcp { reason });
                None
            }
            Requirement::Tcp => {
                check_tcp(model.tiling, matching, findings);
                Some(Statement::Tcp)
            }
            Requirement::Connected | Requirement::NoCavities | Requirement::ManifoldBoundary => {
                self.check_parts(requirement, findings);
                None
            }
        }
    }

    fn uncrossed(&self, plane: &Plane, findings: &mut Findings) -> Option<Statement> {
        if plane.normal.iter().skip(D).any(|c| *c != 0) {
            let plane = plane.clone();
            findings.add(super::Defect::PlaneBeyond {
                plane,
                dimension: D,
            });
            return None;
        }
        let mut plane = plane.clone();
        plane.normal.truncate(D);
        check_plane(self.model.tiling, &plane, findings);
        Some(Statement::UncrossedPlane(plane))
    }

    /// The pieces, cavities and singular places of the boundary, which no certificate states.
    fn check_parts(&self, requirement: &Requirement, findings: &mut Findings) {
        let anatomy = Anatomy::of(self.model.tiling, self.matching);
        match requirement {
            Requirement::Connected if anatomy.pieces.len() > 1 => {
                let firsts = anatomy.pieces.iter().map(|(first, _)| *first).collect();
                findings.add(super::Defect::NotConnected { firsts });
            }
            Requirement::NoCavities => {
                for cavity in anatomy.cavities() {
                    let facets = cavity.facets.clone();
                    findings.add(super::Defect::Cavity { facets });
                }
            }
            Requirement::ManifoldBoundary if !anatomy.is_manifold() => {
                let ridge = |(corners, _): &(Vec<Corner<D>>, usize)| {
                    corners.iter().map(|corner| corner.vertex).collect()
                };
                findings.add(super::Defect::NotManifold {
                    ridges: anatomy.ridges.iter().map(ridge).collect(),
                    vertices: anatomy.vertices,
                });
            }
            _ => {}
        }
    }

    fn dihedral_below(&self, bound: &Rational, findings: &mut Findings) -> Option<Statement> {
        match cosine_above(&self.ranges.largest_dihedral.max, bound) {
            Some(cosine) => Some(Statement::LargestAngle(
                Relation::LessThan,
                DihedralAngle::of_cosine(&cosine),
            )),
            None => {
                list_not_below(self.model, bound, findings);
                None
            }
        }
    }

    fn dihedral_above(&self, bound: &Rational, findings: &mut Findings) -> Option<Statement> {
        match cosine_below(&self.ranges.smallest_dihedral.min, bound) {
            Some(cosine) => Some(Statement::SmallestAngle(
                Relation::MoreThan,
                DihedralAngle::of_cosine(&cosine),
            )),
            None => {
                list_not_above(self.model, bound, findings);
                None
            }
        }
    }

    fn radius_edge_below(&self, bound: &Rational, findings: &mut Findings) -> Option<Statement> {
        let square = Number::from(bound * bound);
        if self.ranges.radius_edge.max.square < square {
            let ratio = RadiusEdge { square };
            Some(Statement::RadiusEdge(Relation::LessThan, ratio))
        } else {
            list_not_below_ratio(self.model, bound, findings);
            None
        }
    }
}

/// The Delaunay statement for a domain.
pub(super) fn delaunay(is_region: bool, weak: bool) -> Statement {
    match (is_region, weak) {
        (false, false) => Statement::Delaunay,
        (false, true) => Statement::WeaklyDelaunay,
        (true, false) => Statement::LocallyDelaunay,
        (true, true) => Statement::LocallyWeaklyDelaunay,
    }
}
