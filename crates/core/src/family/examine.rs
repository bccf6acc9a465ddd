//! A family proved with a bisection tree, refuted with a point of its box, or declined.
//!
//! First the member in the middle of the box is examined as a single tiling. It decides everything
//! combinatorial, and proposes statements. Then signs of polynomials are decided on the whole box.
//! A point at which one is wrong is handed to the checker of single tilings, which has the word.

use super::angles::{self, Bound};
use super::cleared::{Cleared, Convert, to_integer, to_number};
use super::conditions::Conditions;
use super::hypotheses::{self, Member};
use super::tree::{LEAF_LIMIT, NoTree, Tree, grow};
use super::{Family, FamilyError, point_in_words, ratios};
use crate::checker::{self, Findings, Options, Progress, Proof, without_implied};
use crate::format::Relation;
use crate::quality::{DihedralAngle, RadiusEdge};
use crate::statement::{Requirement, Statement};
use crate::tiling::Tiling;
use acutile_exact::number::{Number, enclosure};
use acutile_exact::polynomial::{Coefficient, Cuboid};
use malachite::base::num::arithmetic::traits::{Ceiling, Floor, Pow};
use malachite::{Integer, Rational};

/// A proof in the prover's memory.
#[derive(Clone, Debug)]
pub struct FamilyProof<const D: usize> {
    /// In the order of a claim.
    pub statements: Vec<Statement>,
    /// How the box is cut.
    pub tree: Tree,
    /// The number of different signs that are proved.
    pub signs: usize,
    /// The member in the middle of the box, and its proof.
    pub member: Tiling<D>,
    pub proof: Proof<D>,
}

/// Why a family is not proved.
#[derive(Clone, Debug)]
pub enum NotProvable {
    /// Parameters and polynomials are no family.
    Malformed(FamilyError),
    /// The member at this point of the box is refuted.
    Refuted {
        point: Vec<Number>,
        findings: Findings,
    },
    /// Nothing is known to be wrong.
    Declined(String),
}

/// A tree that proves statements which are not required has at most this many leaves.
const OPTIONAL_LEAVES: usize = 64;

/// Examines a family: a proof, or why there is none.
///
/// # Errors
/// [`NotProvable`], with an exact point for a refutation.
pub fn examine<const D: usize>(
    family: &Family<D>,
    options: &Options,
    progress: Progress,
) -> Result<FamilyProof<D>, NotProvable> {
    family.check().map_err(NotProvable::Malformed)?;
    progress("the member in the middle");
    let point = family.cuboid().center();
    let member = family.at(&point);
    let proof = checker::examine(&member, options, progress);
    let proof = proof.map_err(|findings| refuted(&point, findings))?;
    progress("polynomials");
    match family.frame.field.is_rationals() {
        true => {
            Examination::new(family, &point, &member, &proof, to_integer).run(options, progress)
        }
        false => {
            Examination::new(family, &point, &member, &proof, to_number).run(options, progress)
        }
    }
}

fn refuted(point: &[Number], findings: Findings) -> NotProvable {
    match findings.is_declined() {
        true => NotProvable::Declined("a limit is reached at one point".to_owned()),
        false => NotProvable::Refuted {
            point: point.to_vec(),
            findings,
        },
    }
}

/// A family with its examined member.
pub(super) struct Examination<'f, C, const D: usize> {
    family: &'f Family<D>,
    point: &'f [Number],
    tiling: &'f Tiling<D>,
    proof: &'f Proof<D>,
    cleared: Cleared<'f, C, D>,
    convert: Convert<C>,
}

impl<'f, C: Coefficient, const D: usize> Examination<'f, C, D> {
    pub(super) fn new(
        family: &'f Family<D>,
        point: &'f [Number],
        tiling: &'f Tiling<D>,
        proof: &'f Proof<D>,
        convert: Convert<C>,
    ) -> Self {
        Examination {
            cleared: Cleared::new(family, convert),
            family,
            point,
            tiling,
            proof,
            convert,
        }
    }

    fn run(&self, options: &Options, progress: Progress) -> Result<FamilyProof<D>, NotProvable> {
        let cuboid = self.family.cuboid();
        let mut conditions = Conditions::default();
        hypotheses::add(&self.cleared, &self.member(), &mut conditions);
        let mut tree = self.required(&conditions, &cuboid, &Tree::Leaf, options)?;
        let mut signs = conditions.atoms.len();
        let mut statements = vec![Statement::FaceToFaceTiling];
        progress("required statements");
        for requirement in &options.required {
            let proved = self.requirement(requirement, &cuboid, &tree, options)?;
            if let Some((statement, grown, atoms)) = proved {
                statements.push(statement);
                (tree, signs) = (grown, signs + atoms);
            }
        }
        progress("further statements");
        for choice in self.proposals() {
            for statement in choice {
                let Some(conditions) = self.conditions(&statement) else {
                    continue;
                };
                let limit = tree.leaves().max(OPTIONAL_LEAVES);
                if let Ok(grown) = grow(&conditions, &cuboid, &tree, limit) {
                    statements.push(statement);
                    (tree, signs) = (grown, signs + conditions.atoms.len());
                    break;
                }
            }
        }
        if self.proof.statements.contains(&Statement::Tcp) {
            statements.push(Statement::Tcp);
        }
        Ok(FamilyProof {
            statements: without_implied(statements),
            tree,
            signs,
            member: self.tiling.clone(),
            proof: self.proof.clone(),
        })
    }

    fn member(&self) -> Member<'_, D> {
        Member {
            point: self.point,
            tiling: self.tiling,
            matching: &self.proof.matching,
        }
    }

    /// The conditions of the hypotheses, and of required statements as they would be claimed.
    pub(super) fn of_hypotheses(&self) -> Conditions<C> {
        let mut conditions = Conditions::default();
        hypotheses::add(&self.cleared, &self.member(), &mut conditions);
        conditions
    }

    fn required(
        &self,
        conditions: &Conditions<C>,
        cuboid: &Cuboid,
        tree: &Tree,
        options: &Options,
    ) -> Result<Tree, NotProvable> {
        grow(conditions, cuboid, tree, LEAF_LIMIT).map_err(|error| self.refusal(error, options))
    }

    /// The checker of single tilings has the word about a point.
    fn refusal(&self, error: NoTree, options: &Options) -> NotProvable {
        let names = self.family.names();
        match error {
            NoTree::Violated(point) => {
                let member = self.family.at(&point);
                match checker::examine(&member, options, &|_| {}) {
                    Err(findings) => refuted(&point, findings),
                    Ok(_) => NotProvable::Declined(format!(
                        "a sign cannot hold on the whole box, and the tiling at {} is right",
                        point_in_words(&names, &point)
                    )),
                }
            }
            NoTree::Undecided(cuboid) => {
                let sides = names.iter().zip(&cuboid.sides);
                let sides: Vec<String> = sides.map(|(n, side)| format!("{n} in {side}")).collect();
                NotProvable::Declined(format!(
                    "a sign is not decided where {}; a smaller box may be proved",
                    sides.join(", ")
                ))
            }
        }
    }

    /// A statement that implies the requirement, with the tree that proves it; `None` if it needs
    /// no further proof.
    fn requirement(
        &self,
        requirement: &Requirement,
        cuboid: &Cuboid,
        tree: &Tree,
        options: &Options,
    ) -> Result<Option<(Statement, Tree, usize)>, NotProvable> {
        if let Requirement::UncrossedPlane(plane) = requirement {
            return Err(NotProvable::Declined(format!(
                "plane:{plane} is stated of single tilings, not of a box of parameters; choose \
                 values of the parameters"
            )));
        }
        let mut failure = None;
        for statement in candidates(requirement) {
            let Some(conditions) = self.conditions(&statement) else {
                continue;
            };
            match self.required(&conditions, cuboid, tree, options) {
                Ok(grown) => return Ok(Some((statement, grown, conditions.atoms.len()))),
                Err(error @ NotProvable::Refuted { .. }) => return Err(error),
                Err(error) => failure = Some(error),
            }
        }
        failure.map_or(Ok(None), Err)
    }

    /// The conditions of a statement; `None` if it has none or is no statement about families.
    pub(super) fn conditions(&self, statement: &Statement) -> Option<Conditions<C>> {
        let mut conditions = Conditions::default();
        let cleared = &self.cleared;
        let mut angle = |is_largest: bool, relation: Relation, bound: &DihedralAngle| {
            let angles = angles::of_simplices(cleared);
            let bound = Bound::of(bound, self.convert);
            angles::add_bound(&angles, is_largest, relation, &bound, &mut conditions);
        };
        match statement {
            Statement::Acute => angles::add_acute(cleared, true, &mut conditions),
            Statement::Nonobtuse => angles::add_acute(cleared, false, &mut conditions),
            Statement::LargestAngle(relation, bound) => angle(true, *relation, bound),
            Statement::SmallestAngle(relation, bound) => angle(false, *relation, bound),
            Statement::RadiusEdge(relation, bound) => {
                ratios::add_bound(cleared, *relation, bound, self.convert, &mut conditions);
            }
            Statement::Delaunay => {
                hypotheses::add_delaunay(cleared, &self.member(), true, &mut conditions);
            }
            Statement::WeaklyDelaunay => {
                hypotheses::add_delaunay(cleared, &self.member(), false, &mut conditions);
            }
            Statement::FaceToFaceTiling
            | Statement::Tcp
            | Statement::UncrossedPlane(_)
            | Statement::LocallyDelaunay
            | Statement::LocallyWeaklyDelaunay => return None,
        }
        Some(conditions)
    }

    /// What holds for the member and may hold for all; of each list the first that does is taken.
    fn proposals(&self) -> Vec<Vec<Statement>> {
        let weaker = |statement: &Statement| match statement {
            Statement::Acute => vec![Statement::Acute, Statement::Nonobtuse],
            Statement::Delaunay => vec![Statement::Delaunay, Statement::WeaklyDelaunay],
            Statement::FaceToFaceTiling | Statement::Tcp => Vec::new(),
            other => vec![other.clone()],
        };
        self.proof.statements.iter().map(weaker).collect()
    }
}

/// Statements that imply a requirement, the simplest first. A bound in degrees becomes a rational
/// cosine beyond it.
pub(super) fn candidates(requirement: &Requirement) -> Vec<Statement> {
    match requirement {
        // What is combinatorial is decided by one member.
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
    let rounded: Integer = match is_above {
        true => (high * &scale).ceiling(),
        false => (low * &scale).floor(),
    };
    Rational::from(rounded) / scale
}
