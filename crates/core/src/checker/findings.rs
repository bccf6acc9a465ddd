//! The defects of one tiling: all are counted, and the first few of each kind are kept.

use super::defect::{BOUNDARY_WORK, Defect, NEAR_MATES, VERTEX_FAR};
use std::collections::BTreeMap;

/// Collects defects: all are counted, and of each kind the first few are kept.
#[derive(Clone, Debug)]
pub struct Findings {
    limit: usize,
    counts: BTreeMap<&'static str, usize>,
    kept: Vec<Defect>,
    consequences: BTreeMap<&'static str, usize>,
}

impl Findings {
    /// Keeps up to `limit` defects of each kind.
    pub fn new(limit: usize) -> Self {
        Findings {
            limit,
            counts: BTreeMap::new(),
            kept: Vec::new(),
            consequences: BTreeMap::new(),
        }
    }

    /// How many defects of each kind are kept.
    pub fn limit(&self) -> usize {
        self.limit
    }

    /// Adds everything that other findings have.
    pub fn append(&mut self, other: Findings) {
        for (code, count) in other.counts {
            *self.counts.entry(code).or_insert(0) += count;
        }
        self.kept.extend(other.kept);
        for (code, count) in other.consequences {
            *self.consequences.entry(code).or_insert(0) += count;
        }
    }

    /// Counts the defects of others as consequences of these.
    pub fn add_consequences(&mut self, others: &Findings) {
        for (&code, count) in &others.counts {
            self.add_consequence(code, *count);
        }
    }

    /// Counts some defects that follow from these.
    pub fn add_consequence(&mut self, code: &'static str, count: usize) {
        *self.consequences.entry(code).or_insert(0) += count;
    }

    /// How many defects of each kind follow from these, and are not among them.
    pub fn consequences(&self) -> &BTreeMap<&'static str, usize> {
        &self.consequences
    }

    /// Adds a defect.
    pub fn add(&mut self, defect: Defect) {
        let count = self.counts.entry(defect.code()).or_insert(0);
        *count += 1;
        if *count <= self.limit {
            self.kept.push(defect);
        }
    }

    /// Adds a defect with this name; it is made only if it is kept.
    pub fn add_with(&mut self, code: &'static str, make: impl FnOnce() -> Defect) {
        let count = self.counts.entry(code).or_insert(0);
        *count += 1;
        if *count <= self.limit {
            self.kept.push(make());
        }
    }

    /// Whether nothing is known to be wrong, but a limit or a question left something open.
    pub fn is_declined(&self) -> bool {
        let mut codes = self.counts.keys();
        !self.is_empty() && codes.all(|code| [BOUNDARY_WORK, NEAR_MATES, VERTEX_FAR].contains(code))
    }

    /// Whether nothing is wrong.
    pub fn is_empty(&self) -> bool {
        self.counts.is_empty()
    }

    /// How many defects of each kind were found.
    pub fn counts(&self) -> &BTreeMap<&'static str, usize> {
        &self.counts
    }

    /// The first defects of each kind, in the order in which they were found.
    pub fn kept(&self) -> &[Defect] {
        &self.kept
    }
}
