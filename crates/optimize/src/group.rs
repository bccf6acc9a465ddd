//! The isometries of a tiling that keep its lattice, and how they act on its vertices and simplices.

use acutile_core::classify::{Isometry, Symmetry};
use acutile_core::quality::squared_edges;
use acutile_core::tiling::{Corner, Matching, SimplexId, Tiling, VertexId, floor};
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
    pub isometry: Isometry<3>,
    /// The corner to which each vertex goes.
    pub images: Vec<Corner<3>>,
}

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
    pub place: usize,
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
        let normal = |images: &[Corner<3>]| -> Vec<Corner<3>> {
            let back = images[0].shift.map(|s| -s);
            images.iter().map(|corner| corner.moved(back)).collect()
        };
        let table: BTreeMap<Vec<Corner<3>>, usize> = self
            .elements
            .iter()
            .map(|e| normal(&e.images))
            .zip(0..)
            .collect();
        let mut found = vec![0];
        let mut next = 0;
        while next < found.len() {
            let first = &self.elements[found[next]];
            for &place in places {
                let product = self.elements[place].after(first);
                if let Some(&place) = table.get(&normal(&product))
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
        let table: BTreeMap<Vec<Corner<3>>, usize> =
            tiling.simplices().map(normal_form).zip(0..).collect();
        let mut seen = vec![false; tiling.len()];
        let mut chosen = Vec::new();
        for (simplex, corners) in tiling.indices().zip(tiling.simplices()) {
            if seen[simplex.index()] {
                continue;
            }
            chosen.push(simplex);
            for element in &self.elements {
                let image: Vec<_> = corners.iter().map(|c| element.image(c)).collect();
                if let Some(&place) = table.get(&normal_form(&image)) {
                    seen[place] = true;
                }
            }
        }
        chosen
    }
}

impl Element {
    /// Where a corner goes.
    pub fn image(&self, corner: &Corner<3>) -> Corner<3> {
        self.images[corner.vertex.index()].moved(self.moved(corner.shift))
    }

    /// Where a lattice vector goes. The entries are integers.
    fn moved(&self, shift: [i32; 3]) -> [i32; 3] {
        std::array::from_fn(|i| {
            (0..3)
                .filter(|&j| shift[j] != 0)
                .map(|j| floor(&self.isometry.linear[i][j]) * shift[j])
                .sum()
        })
    }

    /// The images of the vertices under first `first`, then `self`.
    fn after(&self, first: &Element) -> Vec<Corner<3>> {
        first
            .images
            .iter()
            .map(|corner| self.image(corner))
            .collect()
    }
}

/// The corners sorted, moved so that the first has shift zero.
fn normal_form(corners: &[Corner<3>]) -> Vec<Corner<3>> {
    let mut corners = corners.to_vec();
    corners.sort_unstable();
    let back = corners[0].shift.map(|s| -s);
    corners
        .into_iter()
        .map(|corner| corner.moved(back))
        .collect()
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

    /// The isometry with its action; `None` if it maps a vertex to no vertex.
    fn element(&self, tiling: &Tiling<3>, isometry: Isometry<3>) -> Option<Element> {
        let image = |point: [Number; 3]| {
            let (point, shift) = reduced(isometry.image(&point), self.rank);
            self.table.get(&point).map(|corner| corner.moved(shift))
        };
        let images = tiling.vertices.iter().map(image).collect::<Option<_>>()?;
        Some(Element { isometry, images })
    }
}

/// The point moved into 0 <= x < 1 in the lattice's directions, and the vector back.
fn reduced(mut point: [Number; 3], rank: usize) -> ([Number; 3], [i32; 3]) {
    let mut shift = [0; 3];
    for k in 0..rank {
        shift[k] = floor(&point[k]);
        point[k] = &point[k] - &Number::from(Rational::from(shift[k]));
    }
    (point, shift)
}
