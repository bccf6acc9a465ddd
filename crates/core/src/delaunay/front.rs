//! The facets beyond which the cell is still to be found, one of each orbit.
//!
//! A facet is kept in a short list at the least of its corners, and the facet whose least corner comes
//! first is served first. Points are numbered in tree order. So the finished part is about a union of boxes
//! of the tree, and only its surface is open. The data that are needed next were used a short time ago.

use crate::tiling::{Corner, difference};
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// A facet up to translation, and a side: (corners, p) is positively oriented for p
/// beyond it if `positive`. The corners are the D least by (vertex, shift), the first
/// with shift zero. They determine the facet, for they span its hyperplane.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct View<const D: usize> {
    corners: [Corner<D>; D],
    positive: bool,
}

impl<const D: usize> View<D> {
    /// The view of an ordered facet beyond which orientation is positive.
    pub fn new(mut corners: [Corner<D>; D]) -> Self {
        let positive = !sort_is_odd(&mut corners);
        let origin = corners[0].shift;
        for corner in &mut corners {
            corner.shift = difference(corner.shift, origin);
        }
        View { corners, positive }
    }

    /// The other side.
    pub fn reversed(self) -> Self {
        View {
            positive: !self.positive,
            ..self
        }
    }

    /// The corners in an order with positive orientation beyond them.
    pub fn facet(mut self) -> [Corner<D>; D] {
        if !self.positive {
            self.corners.swap(0, 1);
        }
        self.corners
    }

    fn least(&self) -> usize {
        self.corners[0].vertex.index()
    }
}

/// Insertion sort of a few corners; whether the permutation was odd.
pub fn sort_is_odd<const D: usize>(corners: &mut [Corner<D>; D]) -> bool {
    let mut odd = false;
    for end in 1..D {
        for k in (1..=end).rev() {
            if corners[k] < corners[k - 1] {
                corners.swap(k, k - 1);
                odd = !odd;
            }
        }
    }
    odd
}

/// The end of a list.
const NONE: u32 = u32::MAX;

/// An entry of a list, or of the list of free entries.
#[derive(Clone, Copy, Debug)]
struct Node<const D: usize> {
    view: View<D>,
    next: u32,
}

/// The open facets.
#[derive(Clone, Debug)]
pub struct Front<const D: usize> {
    /// The list of each point.
    heads: Vec<u32>,
    nodes: Vec<Node<D>>,
    free: u32,
    /// The points whose lists are not empty, and some whose lists are.
    waiting: BinaryHeap<Reverse<u32>>,
}

impl<const D: usize> Front<D> {
    /// No facet, in a cell with this many points.
    pub fn new(points: usize) -> Self {
        Front {
            heads: vec![NONE; points],
            nodes: Vec::new(),
            free: NONE,
            waiting: BinaryHeap::new(),
        }
    }

    /// An open facet; it stays open until a cell beyond it closes it.
    pub fn first(&mut self) -> Option<View<D>> {
        while let Some(&Reverse(vertex)) = self.waiting.peek() {
            match self.heads[vertex as usize] {
                NONE => self.waiting.pop(),
                node => return Some(self.nodes[node as usize].view),
            };
        }
        None
    }

    /// A facet of a new cell, seen from the cell: closes it if the cell beyond is
    /// there, else it is open.
    pub fn toggle(&mut self, view: View<D>) {
        if !self.close(&view.reversed()) {
            self.open(view);
        }
    }

    fn close(&mut self, view: &View<D>) -> bool {
        let (mut before, mut node) = (NONE, self.heads[view.least()]);
        while node != NONE {
            let Node { view: open, next } = self.nodes[node as usize];
            if open == *view {
                *self.link(before, view) = next;
                self.nodes[node as usize].next = self.free;
                self.free = node;
                return true;
            }
            (before, node) = (node, next);
        }
        false
    }

    /// The link after an entry of a list, or at its head.
    fn link(&mut self, before: u32, view: &View<D>) -> &mut u32 {
        match before {
            NONE => &mut self.heads[view.least()],
            node => &mut self.nodes[node as usize].next,
        }
    }

    fn open(&mut self, view: View<D>) {
        let next = self.heads[view.least()];
        if next == NONE {
            self.waiting.push(Reverse(view.least() as u32));
        }
        let entry = Node { view, next };
        self.heads[view.least()] = self.free;
        match self.nodes.get_mut(self.free as usize) {
            Some(node) => {
                self.free = node.next;
                *node = entry;
            }
            None => {
                self.heads[view.least()] = self.nodes.len() as u32;
                self.nodes.push(entry);
            }
        }
    }
}
