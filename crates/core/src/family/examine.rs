//! A family proved with a bisection tree, refuted with a point of its box, or declined.
//!
//! First the member in the middle of the box is examined as a single tiling. It decides everything
//! combinatorial, and proposes statements. Then signs of polynomials are decided on the whole box.
//! A point at which one is wrong is handed to the checker of single tilings, which has the word.

use super::angles::{self, Bound};
use super::candidates::candidates;
use super::cleared::{Cleared, Convert, to_integer, to_number};
use super::conditions::Conditions;
use super::hypotheses::{self, Member};
use super::tree::{COST_LIMIT, Effort, LEAF_LIMIT, Limit, NoTree, Tree, grow};
use super::{Family, FamilyError, box_in_words, point_in_words, ratios, zeros};
use crate::checker::{self, Findings, Options, Progress, Proof, without_implied};
use crate::format::Relation;
use crate::quality::DihedralAngle;
use crate::statement::{Requirement, Statement};
use crate::tiling::Tiling;
use acutile_exact::number::Number;
use acutile_exact::polynomial::line::Place;
use acutile_exact::polynomial::{Coefficient, Cuboid};

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
    /// The proof of this member.
    pub proof: Proof<D>,
}

/// Why a family is not proved.
#[derive(Clone, Debug)]
pub enum NotProvable {
    /// Parameters and polynomials are no family.
    Malformed(FamilyError),
    /// The member at this point of the box is refuted.
    Refuted {
        /// The values of the parameters.
        point: Vec<Number>,
        /// The defects of the member.
        findings: Findings,
    },
    /// Nothing is known to be wrong.
    Declined(String),
}

/// A tree that proves statements which are not required has at most this many leaves.
const OPTIONAL_LEAVES: usize = 64;
/// The cost of a statement that is not required.
const OPTIONAL_COST: u64 = COST_LIMIT / 4;

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
    if family.frame.field.is_rationals() {
        Examination::new(family, &point, &member, &proof, to_integer).run(options, progress)
    } else {
        Examination::new(family, &point, &member, &proof, to_number).run(options, progress)
    }
}

fn refuted(point: &[Number], findings: Findings) -> NotProvable {
    if findings.is_declined() {
        NotProvable::Declined("a limit is reached at one point".to_owned())
    } else {
        NotProvable::Refuted {
            point: point.to_vec(),
            findings,
        }
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
        let required = Required {
            options,
            progress,
            cuboid: &cuboid,
        };
        let mut tree = self.required(&conditions, "a tiling", &Tree::Leaf, &required)?;
        let mut signs = conditions.atoms.len();
        let mut statements = vec![Statement::FaceToFaceTiling];
        progress("required statements");
        for requirement in &options.required {
            let proved = self.requirement(requirement, &tree, &required)?;
            if let Some((statement, grown, atoms)) = proved {
                statements.push(statement);
                (tree, signs) = (grown, signs + atoms);
            }
        }
        progress("further statements");
        for choice in self.proposals(&cuboid) {
            for statement in choice {
                let Some(conditions) = self.conditions(&statement) else {
                    continue;
                };
                let effort = Effort {
                    leaves: tree.leaves().max(OPTIONAL_LEAVES),
                    cost: OPTIONAL_COST,
                    report: &|_, _| {},
                };
                if let Ok(grown) = grow(&conditions, &cuboid, &tree, &effort) {
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

    /// A tree for conditions that are required; `subject` names them on the terminal.
    fn required(
        &self,
        conditions: &Conditions<C>,
        subject: &str,
        tree: &Tree,
        required: &Required,
    ) -> Result<Tree, NotProvable> {
        let effort = Effort {
            leaves: LEAF_LIMIT,
            cost: COST_LIMIT,
            report: &|leaves, part| {
                let percent = (100.0 * part) as u32;
                (required.progress)(&format!("{subject}: {percent}% of the box, {leaves} parts"));
            },
        };
        let grown = grow(conditions, required.cuboid, tree, &effort);
        grown.map_err(|error| self.refusal(error, conditions, required))
    }

    /// The checker of single tilings has the word about a point.
    fn refusal(
        &self,
        error: NoTree,
        conditions: &Conditions<C>,
        required: &Required,
    ) -> NotProvable {
        let names = self.family.names();
        match error {
            NoTree::Violated(point) => {
                let member = self.family.at(&point);
                match checker::examine(&member, required.options, &|_| {}) {
                    Err(findings) => refuted(&point, findings),
                    Ok(_) => NotProvable::Declined(format!(
                        "a sign cannot hold on the whole box, and the tiling at {} is right",
                        point_in_words(&names, &point)
                    )),
                }
            }
            NoTree::Undecided(cuboid, limit) => {
                let zeros = zeros::zeros(conditions, &cuboid);
                if let Some(refutation) = self.refuted_at(&zeros, required) {
                    return refutation;
                }
                let limit = match limit {
                    Limit::Leaves => format!("the box is in {LEAF_LIMIT} parts"),
                    Limit::Depth => "the part is very small".to_owned(),
                    Limit::Cost => "the limit of work is reached".to_owned(),
                };
                let best = self
                    .smaller(conditions, required)
                    .map_or(String::new(), |smaller| {
                        format!(
                            "; proved is the smaller box {}",
                            box_in_words(&names, &smaller)
                        )
                    });
                let place = match zeros.first() {
                    Some(zero) => format!("vanishes at {}", zeros::in_words(&names, zero)),
                    None => format!("is not decided where {}", box_in_words(&names, &cuboid)),
                };
                NotProvable::Declined(format!(
                    "a sign {place}, and {limit}{best}; a smaller box or fewer parameters may be proved"
                ))
            }
        }
    }

    /// The refutation by the first of some zeros at which the member is refuted.
    fn refuted_at(&self, zeros: &[Place], required: &Required) -> Option<NotProvable> {
        let mut points = zeros.iter().filter_map(zeros::number);
        points.find_map(|point| {
            let point = vec![point];
            let member = self.family.at(&point);
            let findings = checker::examine(&member, required.options, &|_| {}).err()?;
            (!findings.is_declined()).then_some(NotProvable::Refuted { point, findings })
        })
    }

    /// The largest box around the middle on which the conditions are proved without a cut. Boxes half as
    /// large, a quarter as large and so on are tried.
    fn smaller(&self, conditions: &Conditions<C>, required: &Required) -> Option<Cuboid> {
        let effort = Effort {
            leaves: 1,
            cost: COST_LIMIT / 16,
            report: &|_, _| {},
        };
        let boxes = (1..=SMALLER_BOXES).map(|k| required.cuboid.around_center(k));
        let mut boxes =
            boxes.filter(|smaller| grow(conditions, smaller, &Tree::Leaf, &effort).is_ok());
        boxes.next()
    }

    /// A statement that implies the requirement, with the tree that proves it; `None` if it needs
    /// no further proof.
    fn requirement(
        &self,
        requirement: &Requirement,
        tree: &Tree,
        required: &Required,
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
            match self.required(&conditions, &requirement.to_string(), tree, required) {
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
            Statement::NotDelaunay => {
                hypotheses::add_not_delaunay(cleared, &self.member(), &mut conditions);
            }
            Statement::FaceToFaceTiling
            | Statement::Tcp
            | Statement::UncrossedPlane(_)
            | Statement::LocallyDelaunay
            | Statement::LocallyWeaklyDelaunay => return None,
        }
        Some(conditions)
    }

    /// Statements that hold for the member and may hold for all; of each list the first that does is taken.
    ///
    /// A statement must hold at another point of the box, too. That excludes bounds that one member attains.
    fn proposals(&self, cuboid: &Cuboid) -> Vec<Vec<Statement>> {
        let weaker = |statement: &Statement| match statement {
            Statement::Acute => vec![Statement::Acute, Statement::Nonobtuse],
            Statement::Delaunay => vec![Statement::Delaunay, Statement::WeaklyDelaunay],
            Statement::FaceToFaceTiling | Statement::Tcp => Vec::new(),
            other => vec![other.clone()],
        };
        let other = self.family.at(&cuboid.beside_center());
        let other = checker::examine(&other, &Options::default(), &|_| {});
        let other = other.map(|proof| proof.statements).unwrap_or_default();
        let is_there = |statement: &Statement| {
            other.contains(statement)
                || other
                    .iter()
                    .any(|stronger| weaker(stronger).contains(statement))
        };
        let choices = self.proof.statements.iter().map(weaker);
        let kept = choices.map(|choice| choice.into_iter().filter(is_there).collect());
        kept.collect()
    }
}

/// The common part of all required statements.
struct Required<'r> {
    options: &'r Options,
    progress: Progress<'r>,
    cuboid: &'r Cuboid,
}

/// Halvings of a box that is not proved.
const SMALLER_BOXES: u32 = 6;
