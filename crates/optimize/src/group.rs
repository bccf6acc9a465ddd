//! The isometries of a tiling that keep its lattice, and how they act on its vertices and simplices.

use acutile_core::classify::{Isometry, Symmetry};
use acutile_core::quality::squared_edges;
use acutile_core::tiling::{Corner, Matching, SimplexId, Tiling, VertexId, cell_of, floor};
use acutile_exact::geometry::{Sign, linear};
use acutile_exact::number::Number;
use malachite::Rational;
use std::collections::BTreeMap;

/// A group of isometries, up to the lattice.
#[derive(Clone, Debug)]
pub struct Group {
    /// The identity comes first.
    pub elements: Vec<Element>,
}

/// An isometry that maps the tiling to itself.
#[derive(Clone, Debug)]
pub struct Element {
    /// The isometry, in the basis of the lattice.
    pub isometry: Isometry<3>,
    /// The corner to which each vertex goes.
    pub images: Vec<Corner<3>>,
    /// How lattice vectors move. Entries are at most [`CELL_LIMIT`](acutile_core::tiling::CELL_LIMIT).
    lattice: [[i64; 3]; 3],
}

/// A corner with a shift of 64 bits. Entries of `lattice` and of shifts have at most 30 bits, so that no sum of
/// products overflows.
type Place = (VertexId, [i64; 3]);

/// The isometries that a search keeps.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Keep {
    /// All that keep the lattice.
    All,
    /// The lattice only.
    Lattice,
    /// Those that turn no left hand into a right one.
    Rotations,
    /// The group that these elements generate, by their places in the list of all.
    Generated(Vec<usize>),
}

/// An element with this place does not exist.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NoElement {
    /// The place that was asked for.
    pub place: usize,
    /// The number of elements.
    pub count: usize,
}

impl Group {
    /// The group with the identity alone.
    pub fn trivial(tiling: &Tiling<3>) -> Self {
        let vertices = 0..tiling.vertices.len();
        Group {
            elements: vec![Element {
                isometry: Isometry::identity(),
                images: vertices.map(|v| Corner::of(VertexId::at(v))).collect(),
                lattice: std::array::from_fn(|i| std::array::from_fn(|j| i64::from(i == j))),
            }],
        }
    }

    /// All isometries that map a tiling to itself and keep its lattice.
    pub fn of(tiling: &Tiling<3>, matching: &Matching<3>) -> Self {
        let edges: Vec<Vec<Number>> = tiling.indices().map(|s| squared_edges(tiling, s)).collect();
        let symmetry = Symmetry::of(tiling, matching, &edges);
        let places = Places::of(tiling);
        let rank = tiling.frame.rank();
        let kept = symmetry.keeping_lattice(rank).into_iter();
        let elements = kept
            .filter_map(|isometry| places.element(tiling, isometry))
            .collect();
        Group { elements }
    }

    /// The part of the group that is to be kept.
    ///
    /// # Errors
    /// A generator that does not exist.
    pub fn kept(self, keep: &Keep) -> Result<Self, NoElement> {
        let kept = |is_kept: &dyn Fn(&Element) -> bool| Group {
            elements: self
                .elements
                .iter()
                .filter(|e| is_kept(e))
                .cloned()
                .collect(),
        };
        Ok(match keep {
            Keep::All => self,
            Keep::Lattice => Group {
                elements: self.elements.into_iter().take(1).collect(),
            },
            Keep::Rotations => {
                kept(&|e| linear::determinant(&e.isometry.linear).sign() == Sign::Greater)
            }
            Keep::Generated(places) => {
                let count = self.elements.len();
                if let Some(&place) = places.iter().find(|place| **place >= count) {
                    return Err(NoElement { place, count });
                }
                let members = self.generated(places);
                Group {
                    elements: members
                        .into_iter()
                        .map(|k| self.elements[k].clone())
                        .collect(),
                }
            }
        })
    }

    /// The places of all products of some elements, sorted. Two elements are equal if they map vertices
    /// alike up to one lattice vector: four of the vertices are in general position.
    fn generated(&self, places: &[usize]) -> Vec<usize> {
        let own = |e: &Element| back(e.images.iter().map(place).collect());
        let table: BTreeMap<Vec<Place>, usize> = self.elements.iter().map(own).zip(0..).collect();
        let mut found = vec![0];
        let mut next = 0;
        while next < found.len() {
            let first = &self.elements[found[next]];
            for &place in places {
                let product = self.elements[place].after(first);
                if let Some(&place) = table.get(&back(product))
                    && !found.contains(&place)
                {
                    found.push(place);
                }
            }
            next += 1;
        }
        found.sort_unstable();
        found
    }

    /// One simplex of each orbit.
    pub fn representatives(&self, tiling: &Tiling<3>) -> Vec<SimplexId> {
        let own = |corners: &[Corner<3>]| normal_form(corners.iter().map(place).collect());
        let table: BTreeMap<Vec<Place>, usize> = tiling.simplices().map(own).zip(0..).collect();
        let mut seen = vec![false; tiling.len()];
        let mut chosen = Vec::new();
        for (simplex, corners) in tiling.indices().zip(tiling.simplices()) {
            if seen[simplex.index()] {
                continue;
            }
            chosen.push(simplex);
            for element in &self.elements {
                let image = corners.iter().map(|c| element.image(c)).collect();
                if let Some(&place) = table.get(&normal_form(image)) {
                    seen[place] = true;
                }
            }
        }
        chosen
    }
}

impl Element {
    /// Where a corner goes.
    fn image(&self, corner: &Corner<3>) -> Place {
        let image = &self.images[corner.vertex.index()];
        let shift = std::array::from_fn(|i| {
            let terms = self.lattice[i].iter().zip(corner.shift);
            terms.fold(i64::from(image.shift[i]), |sum, (entry, s)| {
                sum + entry * i64::from(s)
            })
        });
        (image.vertex, shift)
    }

    /// The images of the vertices under first `first`, then `self`.
    fn after(&self, first: &Element) -> Vec<Place> {
        first
            .images
            .iter()
            .map(|corner| self.image(corner))
            .collect()
    }
}

fn place(corner: &Corner<3>) -> Place {
    (corner.vertex, corner.shift.map(i64::from))
}

/// The places sorted, moved so that the first has shift zero.
fn normal_form(mut places: Vec<Place>) -> Vec<Place> {
    places.sort_unstable();
    back(places)
}

/// The places moved so that the first has shift zero.
fn back(mut places: Vec<Place>) -> Vec<Place> {
    let first = places.first().map_or([0; 3], |(_, shift)| *shift);
    for (_, shift) in &mut places {
        for (s, first) in shift.iter_mut().zip(first) {
            *s -= first;
        }
    }
    places
}

/// The vertices by their coordinates up to the lattice.
struct Places {
    rank: usize,
    table: BTreeMap<[Number; 3], Corner<3>>,
}

impl Places {
    fn of(tiling: &Tiling<3>) -> Self {
        let rank = tiling.frame.rank();
        let vertices = tiling.vertices.iter().enumerate();
        let entry = |(vertex, point)| {
            let (point, shift) = reduced(point, rank);
            let corner = Corner::of(VertexId::at(vertex));
            (point, corner.moved(shift.map(|s: i32| -s)))
        };
        Places {
            rank,
            table: vertices.map(entry).collect(),
        }
    }

    /// The isometry with its action; `None` if it maps a vertex to no vertex, or a lattice vector beyond the limit
    /// of cells.
    fn element(&self, tiling: &Tiling<3>, isometry: Isometry<3>) -> Option<Element> {
        let image = |point: [Number; 3]| {
            let (point, shift) = reduced(isometry.image(&point), self.rank);
            self.table.get(&point).map(|corner| corner.moved(shift))
        };
        let images = tiling.vertices.iter().map(image).collect::<Option<_>>()?;
        let lattice = self.lattice(&isometry)?;
        Some(Element {
            isometry,
            images,
            lattice,
        })
    }

    /// The linear part in the lattice's directions, where its entries are integers, and zeros.
    fn lattice(&self, isometry: &Isometry<3>) -> Option<[[i64; 3]; 3]> {
        let mut lattice = [[0; 3]; 3];
        for i in 0..self.rank {
            for j in 0..self.rank {
                lattice[i][j] = i64::from(floor(&isometry.linear[i][j])?);
            }
        }
        Some(lattice)
    }
}

/// The point moved into 0 <= x < 1 in the lattice's directions, and the vector back. A point beyond
/// the limit of cells stays, and is found only where it is.
fn reduced(mut point: [Number; 3], rank: usize) -> ([Number; 3], [i32; 3]) {
    let shift = cell_of(&point, rank).unwrap_or([0; 3]);
    for k in 0..rank {
        point[k] = &point[k] - &Number::from(Rational::from(shift[k]));
    }
    (point, shift)
}
