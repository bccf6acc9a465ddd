//! Boxes with integer ends, and a tree of them: which facets and tiles can have a common point.
//!
//! **Invariant.** A box contains its facet or tile, since its ends are rounded outwards.
//! Things whose boxes are disjoint are disjoint. Nothing else follows from a box.

use crate::limits::Work;
use crate::refusal::{Checked, Place};

/// The product of three intervals, from `low` to `high`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Bounds {
    pub(crate) low: [i64; 3],
    pub(crate) high: [i64; 3],
}

impl Bounds {
    /// The least box that contains both.
    pub(crate) fn join(&self, other: &Bounds) -> Bounds {
        let ([a, b, c], [d, e, f]) = (self.low, other.low);
        let ([p, q, r], [s, t, u]) = (self.high, other.high);
        Bounds {
            low: [a.min(d), b.min(e), c.min(f)],
            high: [p.max(s), q.max(t), r.max(u)],
        }
    }

    /// The sums of a point of each.
    pub(crate) fn plus(&self, other: &Bounds) -> Bounds {
        let sum = |[a, b, c]: [i64; 3], [d, e, f]: [i64; 3]| [a + d, b + e, c + f];
        Bounds {
            low: sum(self.low, other.low),
            high: sum(self.high, other.high),
        }
    }

    pub(crate) fn meets(&self, other: &Bounds) -> bool {
        let is_below = |[a, b, c]: [i64; 3], [d, e, f]: [i64; 3]| a <= d && b <= e && c <= f;
        is_below(self.low, other.high) && is_below(other.low, self.high)
    }

    /// The middle of the interval along an axis.
    fn middle(&self, axis: usize) -> Option<i64> {
        let (low, high) = (self.low.get(axis)?, self.high.get(axis)?);
        Some(low.midpoint(*high))
    }

    fn width(&self, axis: usize) -> Option<i64> {
        Some(self.high.get(axis)? - self.low.get(axis)?)
    }
}

/// A number in a box.
pub(crate) struct Item {
    pub(crate) bounds: Bounds,
    pub(crate) number: usize,
}

/// A balanced tree of items. A node has either items or children.
pub(crate) struct Tree {
    pub(crate) bounds: Bounds,
    items: Vec<Item>,
    children: Option<Box<[Tree; 2]>>,
}

/// The most items of a node.
const LEAF: usize = 4;
/// Units of work for the comparison of two boxes.
const PRICE: u64 = 4;

impl Tree {
    /// Nothing without items.
    pub(crate) fn new(mut items: Vec<Item>) -> Option<Tree> {
        let boxes = items.iter().map(|item| item.bounds);
        let bounds = boxes.reduce(|all, one| all.join(&one))?;
        let mut children = None;
        if items.len() > LEAF {
            let axis = (0..3).max_by_key(|&axis| bounds.width(axis)).unwrap_or(0);
            let half = items.len() / 2;
            items.select_nth_unstable_by_key(half, |item| item.bounds.middle(axis));
            let rest = items.split_off(half);
            children = Some(Box::new([Tree::new(items)?, Tree::new(rest)?]));
            items = Vec::new();
        }
        Some(Tree {
            bounds,
            items,
            children,
        })
    }

    /// Visits each pair of different items whose boxes meet, once.
    pub(crate) fn each_pair(
        &self,
        work: &Work,
        visit: &mut impl FnMut(usize, usize) -> Checked,
    ) -> Checked {
        let mut items = self.items.iter();
        while let Some(item) = items.next() {
            for other in items.as_slice() {
                work.add(PRICE);
                if item.bounds.meets(&other.bounds) {
                    visit(item.number, other.number)?;
                }
            }
        }
        if let Some([first, second]) = self.children.as_deref() {
            first.each_pair(work, visit)?;
            second.each_pair(work, visit)?;
            first.each_pair_with(second, &Bounds::default(), work, visit)?;
        }
        Ok(())
    }

    /// Visits each pair of an item here and one of `other` whose boxes meet after the second
    /// is moved by some vector of the box `by`.
    pub(crate) fn each_pair_with(
        &self,
        other: &Tree,
        by: &Bounds,
        work: &Work,
        visit: &mut impl FnMut(usize, usize) -> Checked,
    ) -> Checked {
        work.add(PRICE);
        if !self.bounds.meets(&other.bounds.plus(by)) {
            return Ok(());
        }
        work.check(Place::Witness)?;
        match (self.children.as_deref(), other.children.as_deref()) {
            (Some([a, b]), Some([c, d])) => {
                for (own, other) in [(a, c), (a, d), (b, c), (b, d)] {
                    own.each_pair_with(other, by, work, visit)?;
                }
            }
            (Some([a, b]), None) => {
                a.each_pair_with(other, by, work, visit)?;
                b.each_pair_with(other, by, work, visit)?;
            }
            (None, Some([c, d])) => {
                self.each_pair_with(c, by, work, visit)?;
                self.each_pair_with(d, by, work, visit)?;
            }
            (None, None) => {
                for other in &other.items {
                    let moved = other.bounds.plus(by);
                    for item in &self.items {
                        work.add(PRICE);
                        if item.bounds.meets(&moved) {
                            visit(item.number, other.number)?;
                        }
                    }
                }
            }
        }
        Ok(())
    }

    /// Visits each item whose box meets the given one.
    pub(crate) fn each_near(
        &self,
        bounds: &Bounds,
        work: &Work,
        visit: &mut impl FnMut(usize) -> Checked,
    ) -> Checked {
        work.add(PRICE);
        if !self.bounds.meets(bounds) {
            return Ok(());
        }
        for item in &self.items {
            work.add(PRICE);
            if item.bounds.meets(bounds) {
                visit(item.number)?;
            }
        }
        for child in self.children.iter().flat_map(|pair| pair.iter()) {
            child.each_near(bounds, work, visit)?;
        }
        work.check(Place::Witness)
    }
}
