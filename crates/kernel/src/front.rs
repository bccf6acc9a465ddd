//! The open facets: those of the rows so far that have not met their mates.
//!
//! Rule F: the facets outside of the boundary are paired, up to translations. The two of a pair
//! have the same corners, and their simplices lie on different sides. A facet is named by its
//! sorted corners, seen from the first one. Translates have one name, and facets of one name are
//! translates of each other. The first facet with a name is open, the second one closes it. A
//! third one would be open again.

use crate::limits::Work;
use crate::refusal::{Checked, Place};
use crate::row::{Corner, Row};
use crate::table::{Name, Table};
use std::rc::Rc;

/// In the plane the third corner is the first one again.
#[derive(Clone, Copy, PartialEq, Eq)]
struct Facet {
    vertices: [u32; 3],
    shifts: [[i32; 3]; 2],
}

impl Name for Facet {
    #[inline(always)]
    fn vertex(&self) -> u32 {
        self.vertices[0]
    }
}

impl Facet {
    /// The name of the facet with these sorted corners.
    #[inline(always)]
    fn new([first, second, third]: [Corner; 3]) -> Facet {
        Facet {
            vertices: [first.vertex, second.vertex, third.vertex],
            shifts: [second.seen_from(first).shift, third.seen_from(first).shift],
        }
    }
}

/// What is known of the simplex of an open facet.
enum Open {
    Simplex {
        /// The corner opposite to the facet, seen from the facet's first corner.
        opposite: Corner,
        /// The sign of the simplex's sorted corners, with the opposite one moved to the front.
        side: bool,
        simplex: u64,
    },
    /// A facet in the list `boundary`; its mate would have this side.
    Listed { side: bool, index: u64 },
}

pub(crate) struct Front {
    open: Table<Facet, Open>,
    dimension: usize,
    /// Facets in the boundary so far.
    pub(crate) boundary: u64,
}

/// What becomes of a facet of a simplex.
#[derive(Clone, Copy, Default)]
pub(crate) enum Step {
    #[default]
    Opened,
    /// The corner of the mate's simplex that is not in the facet, seen from the row's first one.
    Closed(Corner),
    Boundary,
}

impl Front {
    pub(crate) fn new(dimension: usize, work: &Rc<Work>) -> Front {
        Front {
            open: Table::new(work),
            dimension,
            boundary: 0,
        }
    }

    pub(crate) fn peak(&self) -> usize {
        self.open.peak()
    }

    /// Opens a facet of the list `boundary`. Its last two corners stand in the order that gives a
    /// positive orientation after the opposite corner of its simplex. So its simplex has the side
    /// that says whether they are exchanged, and its mate would have the other one.
    pub(crate) fn list(&mut self, [a, b, c]: [Corner; 3], index: u64) -> Checked {
        let (name, is_odd) = match (self.dimension, b < c, a < b) {
            (3, true, _) => (Facet::new([a, b, c]), false),
            (3, false, _) => (Facet::new([a, c, b]), true),
            (_, _, true) => (Facet::new([a, b, a]), false),
            (_, _, false) => (Facet::new([b, a, b]), true),
        };
        let side = !is_odd;
        let found = self.open.toggle(name, || Open::Listed { side, index });
        ensure!(found.is_none(), BoundaryRepeated, Place::Boundary(index));
        Ok(())
    }

    /// Opens and closes the facets of a simplex, in the order of the sorted corners that they do
    /// not have. `share` tells whether vertices lie in one face of the domain. A facet whose
    /// corners do is in the boundary and has no mate.
    #[inline(always)]
    pub(crate) fn step(
        &mut self,
        row: &Row,
        share: impl Fn([u32; 3]) -> bool,
        simplex: u64,
    ) -> Checked<[Step; 4]> {
        let [a, b, c, d] = row.sorted(self.dimension);
        let facets = if self.dimension == 3 {
            [[b, c, d], [a, c, d], [a, b, d], [a, b, c]]
        } else {
            [[b, c, b], [a, c, a], [a, b, a], [a, b, a]]
        };
        let mut steps = [Step::Opened; 4];
        let items = facets.into_iter().zip([a, b, c, d]).zip(&mut steps);
        for (i, ((corners, opposite), step)) in items.enumerate().take(self.dimension + 1) {
            if share(corners.map(|corner| corner.vertex)) {
                *step = Step::Boundary;
                self.boundary += 1;
                continue;
            }
            // Moving corner i to the front takes i exchanges.
            let side = row.is_odd ^ (i % 2 == 1);
            let first = corners[0];
            let opposite = opposite.seen_from(first);
            let open = || Open::Simplex {
                opposite,
                side,
                simplex,
            };
            let Some(mate) = self.open.toggle(Facet::new(corners), open) else {
                continue;
            };
            // Rule F: a facet and its mate have opposite sides.
            let (Open::Simplex { side: other, .. } | Open::Listed { side: other, .. }) = mate;
            ensure!(other != side, FacetSide, Place::Facet(simplex, i));
            *step = match mate {
                Open::Simplex { opposite, .. } => Step::Closed(opposite.moved_by(first)),
                Open::Listed { .. } => Step::Boundary,
            };
            self.boundary += u64::from(matches!(step, Step::Boundary));
        }
        Ok(steps)
    }

    /// At the end no facet is open.
    pub(crate) fn check_end(&self) -> Checked {
        let count = u64::try_from(self.open.len()).unwrap_or(u64::MAX);
        let is_simplex = |open: &&Open| matches!(open, Open::Simplex { .. });
        // Rule F: no facet of a simplex is without its mate.
        if let Some(Open::Simplex { simplex, .. }) = self.open.any(is_simplex) {
            ensure!(false, OpenFacet, Place::Simplex(*simplex), count);
        }
        // Every facet of the list is a facet of a simplex.
        if let Some(Open::Listed { index, .. }) = self.open.any(|_| true) {
            ensure!(false, BoundaryOpen, Place::Boundary(*index), count);
        }
        Ok(())
    }
}
