//! Which of many boxes overlap: a tree of bounding boxes.
//!
//! Edges of boxes are ranks, so that nothing is rounded. The answer is complete: every
//! pair of closed boxes with a common point is found, once. Called by [`crate::checker`].

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

/// Calls `visit` with the indices of every pair of boxes that overlap.
pub fn each_overlapping_pair(boxes: &[Box3], mut visit: impl FnMut(usize, usize)) {
    if boxes.is_empty() {
        return;
    }
    let mut tree = Tree {
        boxes,
        items: (0..boxes.len()).collect(),
        nodes: Vec::new(),
    };
    let root = tree.add(0, boxes.len());
    tree.within(root, &mut visit);
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

    /// The pairs inside of one node.
    fn within(&self, node: usize, visit: &mut impl FnMut(usize, usize)) {
        let node = &self.nodes[node];
        let Some((left, right)) = node.halves else {
            let items = &self.items[node.start..node.end];
            for (k, &a) in items.iter().enumerate() {
                self.visit(a, &items[k + 1..], visit);
            }
            return;
        };
        self.within(left, visit);
        self.within(right, visit);
        self.between(left, right, visit);
    }

    /// The pairs of an item of one node and an item of another.
    fn between(&self, left: usize, right: usize, visit: &mut impl FnMut(usize, usize)) {
        let (a, b) = (&self.nodes[left], &self.nodes[right]);
        if !overlap(&a.hull, &b.hull) {
            return;
        }
        match (a.halves, b.halves) {
            (None, None) => {
                for &item in &self.items[a.start..a.end] {
                    self.visit(item, &self.items[b.start..b.end], visit);
                }
            }
            (Some((first, second)), _) if b.halves.is_none() || a.len() >= b.len() => {
                self.between(first, right, visit);
                self.between(second, right, visit);
            }
            (_, Some((first, second))) => {
                self.between(left, first, visit);
                self.between(left, second, visit);
            }
            (Some(_), None) => {}
        }
    }

    fn visit(&self, a: usize, others: &[usize], visit: &mut impl FnMut(usize, usize)) {
        for &b in others {
            if overlap(&self.boxes[a], &self.boxes[b]) {
                visit(a, b);
            }
        }
    }
}

impl Node {
    fn len(&self) -> usize {
        self.end - self.start
    }
}
