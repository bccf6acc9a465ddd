//! Representatives of the tiles under a group of isometries that keep tiling and lattice.
//!
//! For each tile the image of a representative that it is, and for each representative the
//! elements that map it to one of its translates. Everything is found by the images of the
//! vertices, so a reader can follow it with coordinates.

use acutile_core::classify::{Isometry, Symmetry, generators};
use acutile_core::tiling::{Corner, SHIFT_LIMIT, SimplexId, Tiling, VertexId, cell_of};
use acutile_exact::number::Number;
use malachite::{Integer, Rational};
use std::collections::BTreeMap;

/// A group up to the lattice, with representatives of the tiles.
pub struct Orbits<const D: usize> {
    /// One element of each coset of the lattice, the identity first.
    pub elements: Vec<Isometry<D>>,
    /// The places of generators among the elements.
    pub generators: Vec<usize>,
    /// For each element the places of its products with the generators, the generator applied last.
    pub products: Vec<Vec<usize>>,
    /// One tile of each orbit, in the order of the tiles.
    pub representatives: Vec<Representative>,
    /// How each tile is the image of a representative.
    pub images: Vec<Image<D>>,
    /// How each vertex is the image of a corner of a representative.
    pub vertices: Vec<Option<Origin>>,
}

/// A tile that stands for its orbit.
pub struct Representative {
    pub tile: SimplexId,
    /// The places of the elements that map it to one of its translates.
    pub stabiliser: Vec<usize>,
    /// The tiles of the orbit, up to the lattice.
    pub count: usize,
}

/// A tile as an image: the element applied to the representative, moved by the shift.
#[derive(Clone)]
pub struct Image<const D: usize> {
    /// The place of the representative in the list.
    pub representative: usize,
    pub element: usize,
    pub shift: [i32; D],
    /// Corner i is the image of this corner of the representative.
    pub corners: Vec<usize>,
}

/// The corner of a representative, and the element that maps it to a translate of the vertex.
#[derive(Clone, Copy)]
pub struct Origin {
    pub element: usize,
    pub representative: usize,
    pub corner: usize,
}

impl<const D: usize> Orbits<D> {
    /// The orbits under all symmetries that keep the lattice. Under the lattice alone for a region, and
    /// where vertices are too many cells apart.
    pub fn of(tiling: &Tiling<D>, symmetry: &Symmetry<D>) -> Self {
        let rank = tiling.frame.rank();
        let elements = if tiling.frame.domain.is_region() {
            vec![Isometry::identity()]
        } else {
            symmetry.keeping_lattice(rank)
        };
        let images = vertex_images(tiling, &elements);
        let (elements, images) = match images {
            Some(images) => (elements, images),
            None => {
                let vertices = (0..tiling.vertices.len() as u32).map(Corner::of);
                (vec![Isometry::identity()], vec![vertices.collect()])
            }
        };
        let generators = generators(&elements, rank);
        let product = |element: &Isometry<D>, generator: &usize| {
            let product = elements[*generator].after(element).reduced(rank);
            elements.iter().position(|e| *e == product).unwrap_or(0)
        };
        let mut orbits = Orbits {
            products: elements
                .iter()
                .map(|element| generators.iter().map(|g| product(element, g)).collect())
                .collect(),
            generators,
            representatives: Vec::new(),
            images: Vec::new(),
            vertices: vec![None; tiling.vertices.len()],
            elements,
        };
        orbits.find(tiling, &images);
        orbits
    }

    fn find(&mut self, tiling: &Tiling<D>, vertices: &[Vec<Corner<D>>]) {
        let names: BTreeMap<Vec<Corner<D>>, SimplexId> = tiling
            .indices()
            .map(|tile| (name(tiling.simplex(tile)).0, tile))
            .collect();
        let mut images: Vec<Option<Image<D>>> = vec![None; tiling.len()];
        for tile in tiling.indices() {
            if images[tile.index()].is_some() {
                continue;
            }
            let representative = self.representatives.len();
            let (mut stabiliser, mut count) = (Vec::new(), 0);
            for (element, vertices) in vertices.iter().enumerate() {
                let row = tiling.simplex(tile).iter();
                let corners = row.map(|c| image(&self.elements[element], vertices, c));
                let Some(corners) = corners.collect::<Option<Vec<_>>>() else {
                    continue;
                };
                for (corner, at) in corners.iter().enumerate() {
                    self.vertices[at.vertex.index()].get_or_insert(Origin {
                        element,
                        representative,
                        corner,
                    });
                }
                let (key, first) = name(&corners);
                let Some(&found) = names.get(&key) else {
                    continue;
                };
                if found == tile {
                    stabiliser.push(element);
                }
                let place = &mut images[found.index()];
                if place.is_none() {
                    count += 1;
                    let own = tiling.simplex(found);
                    let shift = std::array::from_fn(|k| name(own).1[k] - first[k]);
                    let is_at = |c: &Corner<D>| corners.iter().position(|x| x.moved(shift) == *c);
                    *place = Some(Image {
                        representative,
                        element,
                        shift,
                        corners: own.iter().filter_map(is_at).collect(),
                    });
                }
            }
            self.representatives.push(Representative {
                tile,
                stabiliser,
                count,
            });
        }
        self.images = images.into_iter().flatten().collect();
    }
}

/// The images of all vertices under each element; `None` if a lattice vector is too long.
fn vertex_images<const D: usize>(
    tiling: &Tiling<D>,
    elements: &[Isometry<D>],
) -> Option<Vec<Vec<Corner<D>>>> {
    let rank = tiling.frame.rank();
    let positions = tiling.vertices.to_numbers();
    let places: BTreeMap<[Number; D], (VertexId, [Integer; D])> = positions
        .iter()
        .enumerate()
        .map(|(v, position)| {
            let (reduced, cell) = reduced(position, rank);
            (reduced, (VertexId::at(v), cell))
        })
        .collect();
    let image = |element: &Isometry<D>, position: &[Number; D]| {
        let (point, cell) = reduced(&element.image(position), rank);
        let (vertex, own) = places.get(&point)?;
        let mut shift = [0; D];
        for k in 0..D {
            let by = i32::try_from(&(&cell[k] - &own[k])).ok()?;
            if by.abs() > SHIFT_LIMIT {
                return None;
            }
            shift[k] = by;
        }
        Some(Corner {
            vertex: *vertex,
            shift,
        })
    };
    elements
        .iter()
        .map(|element| positions.iter().map(|p| image(element, p)).collect())
        .collect()
}

/// The image of a corner: that of its vertex, moved by the image of its shift. `None` if this is
/// too long to be a shift of the tiling.
fn image<const D: usize>(
    element: &Isometry<D>,
    vertices: &[Corner<D>],
    corner: &Corner<D>,
) -> Option<Corner<D>> {
    let shift = corner.shift.map(|s| Number::from(Rational::from(s)));
    let turned: [Number; D] = std::array::from_fn(|i| {
        let terms = element.linear[i].iter().zip(&shift);
        terms.fold(Number::zero(), |sum, (a, s)| sum + a * s)
    });
    Some(vertices[corner.vertex.index()].moved(cell_of(&turned, D)?))
}

/// A point with the lattice's coordinates in [0, 1), and by which lattice vector it was moved.
fn reduced<const D: usize>(point: &[Number; D], rank: usize) -> ([Number; D], [Integer; D]) {
    let cell: [Integer; D] = std::array::from_fn(|k| {
        if k < rank {
            point[k].floor()
        } else {
            Integer::from(0)
        }
    });
    let moved = std::array::from_fn(|k| &point[k] - &Number::from(Rational::from(&cell[k])));
    (moved, cell)
}

/// The sorted corners, moved so that the first has no shift; and that shift.
fn name<const D: usize>(corners: &[Corner<D>]) -> (Vec<Corner<D>>, [i32; D]) {
    let mut sorted = corners.to_vec();
    sorted.sort_unstable();
    let first = sorted[0].shift;
    let back = first.map(|s| -s);
    (sorted.iter().map(|c| c.moved(back)).collect(), first)
}
