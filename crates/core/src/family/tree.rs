//! Bisection of a box until all conditions are proved on each part.
//!
//! A sign that is proved on a box is proved on its halves, too. Their Bernstein coefficients are averages
//! of those of the box, and a coefficient of a face with a positive value is positive.

use super::conditions::{Atom, Conditions};
pub use crate::format::family::Tree;
use acutile_exact::number::Number;
use acutile_exact::polynomial::{Coefficient, Cuboid};
use std::cell::Cell;

/// A tree with more leaves is given up.
pub const LEAF_LIMIT: usize = 4096;
/// Cuts one after the other.
pub const DEPTH_LIMIT: usize = 64;
/// The most products of coefficients for a statement that is required.
pub const COST_LIMIT: u64 = 400_000_000;

/// The limits of a search for a tree.
#[derive(Clone, Copy)]
pub struct Effort<'r> {
    /// The most leaves.
    pub leaves: usize,
    /// The most products of coefficients.
    pub cost: u64,
    /// Is given the number of leaves that are proved, and the part of the box that they are. Only for display.
    pub report: &'r dyn Fn(usize, f64),
}

/// Why there is no tree.
#[derive(Clone, Debug)]
pub enum NoTree {
    /// A condition does not hold at this point of the box.
    Violated(Vec<Number>),
    /// The signs on this box are not decided, and a limit is reached.
    Undecided(Cuboid, Limit),
}

/// The limit that is reached.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Limit {
    /// The number of leaves.
    Leaves,
    /// The number of cuts one after the other.
    Depth,
    /// The number of products of coefficients.
    Cost,
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

/// Cuts the leaves of `tree` further until the conditions are proved on all leaves.
///
/// # Errors
/// A point at which a condition is violated, or a box that is not decided.
pub fn grow<C: Coefficient>(
    conditions: &Conditions<C>,
    cuboid: &Cuboid,
    tree: &Tree,
    effort: &Effort,
) -> Result<Tree, NoTree> {
    let mut growth = Growth {
        conditions,
        effort,
        budget: effort.leaves.saturating_sub(tree.leaves()),
        cost: Cell::new(0),
        proved: (0, 0.0),
        lengths: lengths(cuboid),
    };
    let open: Vec<&Vec<Vec<usize>>> = conditions.all().collect();
    let proved = vec![false; conditions.atoms.len()];
    growth.grow(cuboid, tree, &open, &proved, 0)
}

struct Growth<'c, C> {
    conditions: &'c Conditions<C>,
    effort: &'c Effort<'c>,
    /// Leaves that may still be added.
    budget: usize,
    /// The cost until now.
    cost: Cell<u64>,
    /// The leaves that are proved, and the part of the box that they are.
    proved: (usize, f64),
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
            self.proved.0 += tree.leaves();
            self.proved.1 += 0.5f64.powi(i32::try_from(depth).unwrap_or(i32::MAX));
            (self.effort.report)(self.proved.0, self.proved.1);
            return Ok(tree.clone());
        }
        if let Some(point) = self.violation(cuboid, &open) {
            return Err(NoTree::Violated(point));
        }
        if let Some(limit) = self.limit(tree, depth) {
            return Err(NoTree::Undecided(cuboid.clone(), limit));
        }
        let (axis, parts) = match tree {
            Tree::Halves(axis, parts) => (*axis, parts.clone()),
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

    /// The limit that forbids to go on.
    fn limit(&self, tree: &Tree, depth: usize) -> Option<Limit> {
        match tree {
            _ if self.is_spent() => Some(Limit::Cost),
            Tree::Leaf if self.budget == 0 => Some(Limit::Leaves),
            Tree::Leaf if depth == DEPTH_LIMIT => Some(Limit::Depth),
            _ => None,
        }
    }

    fn is_spent(&self) -> bool {
        self.cost.get() > self.effort.cost
    }

    /// Counts the cost of a look at an atom, unless the limit is reached.
    fn may_look(&self, atom: &Atom<C>, cuboid: &Cuboid) -> bool {
        let may = !self.is_spent();
        if may {
            let cost = self.cost.get().saturating_add(atom.cost(cuboid));
            self.cost.set(cost);
        }
        may
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
                    let atom = &self.conditions.atoms[number];
                    self.may_look(atom, cuboid) && atom.is_proved_on(cuboid) == Some(true)
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

    /// A point of the box at which a condition does not hold: the centre, one with short numbers, or a corner.
    /// A box that is open in some direction has no corner; the centers of its facets take their place.
    fn violation(&self, cuboid: &Cuboid, open: &Open) -> Option<Vec<Number>> {
        let has_corners = cuboid
            .sides
            .iter()
            .all(|side| side.closed_ends().next().is_some());
        let facets = if has_corners {
            Vec::new()
        } else {
            cuboid.facet_centers()
        };
        let inner = std::iter::once(cuboid.center()).chain(cuboid.simple_point());
        for point in inner.chain(facets) {
            let mut known = vec![None; self.conditions.atoms.len()];
            let mut holds = |k: usize| {
                *known[k].get_or_insert_with(|| self.conditions.atoms[k].holds_at(&point))
            };
            let all_hold = open
                .iter()
                .all(|condition| Conditions::<C>::holds(condition, &mut holds));
            if !all_hold {
                return Some(point);
            }
        }
        let corner = self.violated_corner(cuboid, open)?;
        cuboid.corners().into_iter().nth(corner)
    }

    /// The first corner at which a condition does not hold.
    fn violated_corner(&self, cuboid: &Cuboid, open: &Open) -> Option<usize> {
        if cuboid.sides.len() > MOST_SIDES {
            return None;
        }
        let mut known: Vec<Option<Vec<bool>>> = vec![None; self.conditions.atoms.len()];
        let corners = open.iter().filter_map(|condition| {
            for &number in condition.iter().flatten() {
                let atom = &self.conditions.atoms[number];
                if known[number].is_none() && self.may_look(atom, cuboid) {
                    known[number] = atom.holds_at_corners(cuboid);
                }
                known[number].as_ref()?;
            }
            let count = known[*condition.iter().flatten().next()?].as_ref()?.len();
            let holds = |corner: usize| {
                let atom = |k: usize| known[k].as_ref().is_none_or(|holds| holds[corner]);
                Conditions::<C>::holds(condition, atom)
            };
            (0..count).find(|corner| !holds(*corner))
        });
        corners.min()
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
