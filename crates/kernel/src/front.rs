//! The open facets: those of the rows so far that have not met their mates.
//!
//! Rule F: the facets outside of the boundary are paired, up to translations. The two of a pair have the same corners,
//! and their simplices lie on different sides. A facet is named by its sorted corners, seen from the first one.
//! Translates have one name, and facets of one name are translates of each other. The first facet with a name is open,
//! the second one closes it. A third one would be open again.

use crate::limits::Work;
use crate::refusal::{Checked, Place};
use crate::row::{Corner, Row};
use crate::table::Table;
use std::rc::Rc;

/// The vertices, and the shifts of the second and the third corner as seen from the first. In the
/// plane the third corner is the first one again.
pub(crate) type Facet = ([u32; 3], [[i32; 3]; 2]);

/// The name of the facet with these sorted corners.
fn facet([first, second, third]: [Corner; 3]) -> Facet {
    let vertices = [first.vertex, second.vertex, third.vertex];
    (vertices, [second.seen_from(first).shift, third.seen_from(first).shift])
}

/// The simplex of an open facet, or the mate that a facet in the list `boundary` would have.
pub(crate) struct Open {
    /// The sign of the simplex's sorted corners, with the opposite one moved to the front.
    side: bool,
    /// The corner opposite to the facet, seen from the facet's first corner; none in the list.
    opposite: Option<Corner>,
    /// The number of the simplex, or of the facet in the list.
    number: u64,
}

pub(crate) struct Front {
    pub(crate) open: Table<Facet, Open>,
    dimension: usize,
    /// Facets in the boundary so far.
    pub(crate) boundary: u64,
}

/// The effect of a row on one of its facets.
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
        Front { open: Table::new(work), dimension, boundary: 0 }
    }

    /// Opens the facet, or closes and returns the open one with its name.
    fn toggle(&mut self, name: Facet, open: Open) -> Checked<Option<Open>> {
        self.open.with(name.0[0], &name, |list, position| match position {
            Some(position) => Some(list.swap_remove(position).1),
            None => {
                list.push((name, open));
                None
            }
        })
    }

    /// Opens a facet of the list `boundary`. Its last two corners stand in the order that gives a
    /// positive orientation after the opposite corner of its simplex. So its simplex has the side
    /// that says whether they are exchanged, and its mate would have the other one.
    pub(crate) fn list(&mut self, [a, b, c]: [Corner; 3], index: u64) -> Checked {
        let (is_odd, sorted) = match self.dimension {
            3 if b < c => (false, [a, b, c]),
            3 => (true, [a, c, b]),
            _ if a < b => (false, [a, b, a]),
            _ => (true, [b, a, b]),
        };
        let found = self.toggle(facet(sorted), Open { side: !is_odd, opposite: None, number: index })?;
        ensure!(found.is_none(), BoundaryRepeated, Place::Boundary(index));
        Ok(())
    }

    /// Opens and closes the facets of a simplex, in the order of the sorted corners that they do not have. `share` says
    /// whether vertices lie in one face of the domain. A facet whose corners do is in the boundary and has no mate.
    pub(crate) fn step(&mut self, row: &Row, share: impl Fn([u32; 3]) -> bool, simplex: u64) -> Checked<[Step; 4]> {
        let [a, b, c, d] = row.sorted;
        let facets = if self.dimension == 3 {
            [[b, c, d], [a, c, d], [a, b, d], [a, b, c]]
        } else {
            [[b, c, b], [a, c, a], [a, b, a], [a, b, a]]
        };
        let mut steps = [Step::Opened; 4];
        let items = facets.into_iter().zip(row.sorted).zip(&mut steps).enumerate();
        for (i, ((corners, opposite), step)) in items.take(self.dimension + 1) {
            let first = corners[0];
            if share(corners.map(|corner| corner.vertex)) {
                *step = Step::Boundary;
                self.boundary += 1;
                continue;
            }
            // Moving corner i to the front takes i exchanges.
            let side = row.is_odd ^ (i % 2 == 1);
            let opposite = Some(opposite.seen_from(first));
            let open = Open { side, opposite, number: simplex };
            if let Some(mate) = self.toggle(facet(corners), open)? {
                // Rule F: a facet and its mate have opposite sides.
                ensure!(mate.side != side, FacetSide, Place::Facet(simplex, i));
                *step = match mate.opposite {
                    Some(opposite) => Step::Closed(opposite.moved_by(first)),
                    None => Step::Boundary,
                };
                self.boundary += u64::from(mate.opposite.is_none());
            }
        }
        Ok(steps)
    }

    pub(crate) fn check_end(&self) -> Checked {
        // Rule F: no facet of a simplex is without its mate.
        if let Some(open) = self.open.find(|open| open.opposite.is_some()) {
            ensure!(false, OpenFacet, Place::Simplex(open.number), self.open.count);
        }
        // Every facet of the list is a facet of a simplex.
        if let Some(open) = self.open.find(|open| open.opposite.is_none()) {
            ensure!(false, BoundaryOpen, Place::Boundary(open.number), self.open.count);
        }
        Ok(())
    }
}
