//! Disjoint sets of small numbers.

/// Each set is named by its least number, to which its numbers lead.
pub struct Union(Vec<usize>);

impl Union {
    /// The numbers below `count`, each in a set of its own.
    pub fn new(count: usize) -> Self {
        Union((0..count).collect())
    }

    /// The least number of a set.
    pub fn first(&mut self, mut item: usize) -> usize {
        while self.0[item] != item {
            self.0[item] = self.0[self.0[item]];
            item = self.0[item];
        }
        item
    }

    /// Makes two sets one.
    pub fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.first(a), self.first(b));
        self.0[a.max(b)] = a.min(b);
    }
}
