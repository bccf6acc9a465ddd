//! Which of many boxes overlap: a tree of bounding boxes.
//!
//! Edges of boxes are ranks, so that nothing is rounded. The answer is complete: every
//! pair of closed boxes with a common point is found, once.

/// From the least to the greatest rank on each axis, both inclusive.
pub type Box3 = [(u32, u32); 3];

/// Whether two closed boxes have a common point.
pub fn overlap(a: &Box3, b: &Box3) -> bool {
    a.iter().zip(b).all(|(a, b)| a.0 <= b.1 && b.0 <= a.1)
}

/// The least box that holds all of these; empty for none.
pub fn hull(boxes: impl IntoIterator<Item = Box3>) -> Box3 {
    let empty = [(u32::MAX, 0); 3];
    boxes.into_iter().fold(empty, |hull, next| {
        std::array::from_fn(|k| (hull[k].0.min(next[k].0), hull[k].1.max(next[k].1)))
    })
}

/// Every pair of boxes that overlap, by their indices; `None` if there are more than `limit`.
pub fn overlapping_pairs(boxes: &[Box3], limit: usize) -> Option<Vec<(usize, usize)>> {
    let mut pairs = Vec::new();
    if boxes.is_empty() {
        return Some(pairs);
    }
    let mut tree = Tree {
        boxes,
        items: (0..boxes.len()).collect(),
        nodes: Vec::new(),
    };
    let root = tree.add(0, boxes.len());
    tree.within(root, &mut |a, b| {
        pairs.push((a.min(b), a.max(b)));
        pairs.len() <= limit
    })
    .then_some(pairs)
}

struct Tree<'b> {
    boxes: &'b [Box3],
    items: Vec<usize>,
    nodes: Vec<Node>,
}

/// The items from `start` to `end`; the halves of all but the smallest nodes.
struct Node {
    hull: Box3,
    start: usize,
    end: usize,
    halves: Option<(usize, usize)>,
}

const LEAF: usize = 8;

impl Tree<'_> {
    /// Adds a node for some items, halved at the median along the longest axis of the
    /// centres; gives its index.
    fn add(&mut self, start: usize, end: usize) -> usize {
        let boxes = self.boxes;
        let items = &mut self.items[start..end];
        let hull = hull(items.iter().map(|&item| boxes[item]));
        let halves = (end - start > LEAF).then(|| {
            let length = |k: &usize| hull[*k].1 - hull[*k].0;
            let axis = (0..3).max_by_key(length).unwrap_or(0);
            let middle = items.len() / 2;
            let centre = |item: &usize| {
                let (low, high) = boxes[*item][axis];
                u64::from(low) + u64::from(high)
            };
            items.select_nth_unstable_by_key(middle, centre);
            start + middle
        });
        let halves = halves.map(|middle| (self.add(start, middle), self.add(middle, end)));
        self.nodes.push(Node {
            hull,
            start,
            end,
            halves,
        });
        self.nodes.len() - 1
    }

    /// The pairs inside of one node; like all below until `visit` says false, which is passed on.
    fn within(&self, node: usize, visit: &mut impl FnMut(usize, usize) -> bool) -> bool {
        let node = &self.nodes[node];
        let Some((left, right)) = node.halves else {
            let items = &self.items[node.start..node.end];
            let mut each = items.iter().enumerate();
            return each.all(|(k, &a)| self.visit(a, &items[k + 1..], visit));
        };
        self.within(left, visit) && self.within(right, visit) && self.between(left, right, visit)
    }

    /// The pairs of an item of one node and an item of another.
    fn between(
        &self,
        left: usize,
        right: usize,
        visit: &mut impl FnMut(usize, usize) -> bool,
    ) -> bool {
        let (a, b) = (&self.nodes[left], &self.nodes[right]);
        if !overlap(&a.hull, &b.hull) {
            return true;
        }
        match (a.halves, b.halves) {
            (None, None) => {
                let others = &self.items[b.start..b.end];
                let mut items = self.items[a.start..a.end].iter();
                items.all(|&item| self.visit(item, others, visit))
            }
            (Some((first, second)), _) if b.halves.is_none() || a.len() >= b.len() => {
                self.between(first, right, visit) && self.between(second, right, visit)
            }
            (_, Some((first, second))) => {
                self.between(left, first, visit) && self.between(left, second, visit)
            }
            (Some(_), None) => true,
        }
    }

    fn visit(
        &self,
        a: usize,
        others: &[usize],
        visit: &mut impl FnMut(usize, usize) -> bool,
    ) -> bool {
        let near = others
            .iter()
            .filter(|&&b| overlap(&self.boxes[a], &self.boxes[b]));
        near.into_iter().all(|&b| visit(a, b))
    }
}

impl Node {
    fn len(&self) -> usize {
        self.end - self.start
    }
}
