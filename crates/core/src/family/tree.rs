//! Bisection of a box until all conditions are proved on each part.
//!
//! A sign that is proved on a box is proved on its halves, too: their Bernstein coefficients are
//! averages of those of the box, and a coefficient of a face with a positive value is positive.

use super::conditions::Conditions;
pub use crate::format::family::Tree;
use acutile_exact::number::Number;
use acutile_exact::polynomial::{Coefficient, Cuboid};

/// A tree with more leaves is given up.
pub const LEAF_LIMIT: usize = 4096;
/// Cuts one after the other.
pub const DEPTH_LIMIT: usize = 64;

/// Why there is no tree.
#[derive(Clone, Debug)]
pub enum NoTree {
    /// A condition does not hold at this point of the box.
    Violated(Vec<Number>),
    /// The signs on this box are not decided, and a limit is reached.
    Undecided(Cuboid),
}

impl Tree {
    /// The number of leaves.
    pub fn leaves(&self) -> usize {
        match self {
            Tree::Leaf => 1,
            Tree::Halves(_, halves) => halves.iter().map(Tree::leaves).sum(),
        }
    }

    /// The most cuts one after the other.
    pub fn depth(&self) -> usize {
        match self {
            Tree::Leaf => 0,
            Tree::Halves(_, halves) => 1 + halves.iter().map(Tree::depth).max().unwrap_or(0),
        }
    }
}

/// Cuts the leaves of `tree` further until the conditions are proved on all leaves, at most `limit`
/// of them.
///
/// # Errors
/// A point at which a condition is violated, or a box that is not decided.
pub fn grow<C: Coefficient>(
    conditions: &Conditions<C>,
    cuboid: &Cuboid,
    tree: &Tree,
    limit: usize,
) -> Result<Tree, NoTree> {
    let mut growth = Growth {
        conditions,
        budget: limit.saturating_sub(tree.leaves()),
        lengths: lengths(cuboid),
    };
    let open: Vec<&Vec<Vec<usize>>> = conditions.all().collect();
    let proved = vec![false; conditions.atoms.len()];
    growth.grow(cuboid, tree, &open, &proved, 0)
}

struct Growth<'c, C> {
    conditions: &'c Conditions<C>,
    /// Leaves that may still be added.
    budget: usize,
    /// The lengths of the sides of the whole box.
    lengths: Vec<f64>,
}

type Open<'c> = [&'c Vec<Vec<usize>>];

impl<C: Coefficient> Growth<'_, C> {
    fn grow(
        &mut self,
        cuboid: &Cuboid,
        tree: &Tree,
        open: &Open,
        proved: &[bool],
        depth: usize,
    ) -> Result<Tree, NoTree> {
        let (open, proved) = self.undecided(cuboid, open, proved);
        if open.is_empty() {
            return Ok(tree.clone());
        }
        if let Some(point) = self.violation(cuboid, &open) {
            return Err(NoTree::Violated(point));
        }
        let (axis, parts) = match tree {
            Tree::Halves(axis, parts) => (*axis, parts.clone()),
            Tree::Leaf if self.budget == 0 || depth == DEPTH_LIMIT => {
                return Err(NoTree::Undecided(cuboid.clone()));
            }
            Tree::Leaf => {
                self.budget -= 1;
                let axis = self.best_axis(cuboid, &open, &proved);
                (axis, Box::new([Tree::Leaf, Tree::Leaf]))
            }
        };
        let [low, high] = cuboid.halves(axis);
        let low = self.grow(&low, &parts[0], &open, &proved, depth + 1)?;
        let high = self.grow(&high, &parts[1], &open, &proved, depth + 1)?;
        Ok(Tree::Halves(axis, Box::new([low, high])))
    }

    /// The conditions that are not proved on the box, and the atoms that are.
    fn undecided<'o>(
        &self,
        cuboid: &Cuboid,
        open: &Open<'o>,
        proved: &[bool],
    ) -> (Vec<&'o Vec<Vec<usize>>>, Vec<bool>) {
        let mut known: Vec<Option<bool>> = proved.iter().map(|p| p.then_some(true)).collect();
        let mut left = Vec::new();
        for condition in open {
            let holds = Conditions::<C>::holds(condition, |number| {
                *known[number].get_or_insert_with(|| {
                    self.conditions.atoms[number].is_proved_on(cuboid) == Some(true)
                })
            });
            if !holds {
                left.push(*condition);
            }
        }
        (
            left,
            known.iter().map(|known| *known == Some(true)).collect(),
        )
    }

    /// A corner of the box, or its centre, at which a condition does not hold.
    fn violation(&self, cuboid: &Cuboid, open: &Open) -> Option<Vec<Number>> {
        let corners = match cuboid.sides.len() {
            0..=MOST_SIDES => cuboid.corners(),
            _ => Vec::new(),
        };
        let mut points = std::iter::once(cuboid.center()).chain(corners);
        points.find(|point| {
            open.iter().any(|condition| {
                !Conditions::<C>::holds(condition, |k| self.conditions.atoms[k].holds_at(point))
            })
        })
    }

    /// The side whose halves leave the fewest conditions undecided; of several the one that is the
    /// longest, against the whole box. Doubles decide nothing else.
    fn best_axis(&self, cuboid: &Cuboid, open: &Open, proved: &[bool]) -> usize {
        let left = |axis: usize| {
            let halves = cuboid.halves(axis);
            let counts = halves
                .iter()
                .map(|half| self.undecided(half, open, proved).0.len());
            counts.sum::<usize>()
        };
        let occurs = |axis: &usize| {
            let numbers = open.iter().flat_map(|condition| condition.iter().flatten());
            numbers
                .into_iter()
                .any(|k| self.conditions.atoms[*k].polynomial.degree(*axis) > 0)
        };
        let axes = (0..cuboid.sides.len()).filter(occurs);
        let part = |axis: usize| cuboid.sides[axis].length().approximate() / self.lengths[axis];
        let scored = axes.map(|axis| (left(axis), -part(axis), axis));
        let best = scored.min_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
        best.map_or(0, |(_, _, axis)| axis)
    }
}

/// Boxes with more sides have too many corners.
const MOST_SIDES: usize = 8;

fn lengths(cuboid: &Cuboid) -> Vec<f64> {
    let sides = cuboid.sides.iter();
    sides.map(|side| side.length().approximate()).collect()
}
