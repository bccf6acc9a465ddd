//! The corners of a simplex, as they stand in its row.

/// The corners of a simplex: places `[v, s_1, …, s_r]`, one after another.
#[derive(Clone, Copy)]
pub(super) struct Corners<'r> {
    entries: &'r [i64],
    width: usize,
}

impl<'r> Corners<'r> {
    /// For a lattice of this rank.
    pub(super) fn new(entries: &'r [i64], rank: usize) -> Corners<'r> {
        let width = 1 + rank;
        Corners { entries, width }
    }

    /// D + 1
    pub(super) fn len(self) -> usize {
        self.entries.len() / self.width
    }

    pub(super) fn get(self, corner: usize) -> &'r [i64] {
        &self.entries[corner * self.width..][..self.width]
    }

    /// All but one: the corners of the facet opposite to it.
    pub(super) fn without(self, corner: usize) -> impl Iterator<Item = &'r [i64]> {
        let all = self.entries.chunks(self.width).enumerate();
        all.filter(move |(k, _)| *k != corner)
            .map(|(_, place)| place)
    }

    pub(super) fn entries(self) -> &'r [i64] {
        self.entries
    }

    /// Corners of the same tiling, from their entries.
    pub(super) fn like<'q>(self, entries: &'q [i64]) -> Corners<'q> {
        let width = self.width;
        Corners { entries, width }
    }
}
