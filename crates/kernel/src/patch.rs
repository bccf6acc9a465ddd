//! The tiles of a system of patches, each with the piece and the pyramids over it.
//!
//! Each patch, with its pyramids cut into fans, is checked by the pass of [`crate::tiling`] as a prism or slab.

use crate::cbor::Cbor;
use crate::claim::{Claim, Domain, Number, Polytope, Property, Statement, read_number, read_points};
use crate::numbers::Single;
use crate::refusal::{Checked, Place};
use crate::row::{Corner, MOST_SHIFT, Row, Shape};
use crate::table::index;
use crate::tiling::{Pass, read_count};
use crate::transcript::Transcript;
use crate::vertices::Vertices;
use num_bigint::BigInt;

/// A tile of the mosaics, whose sides have classes.
#[derive(Debug, PartialEq)]
pub(crate) struct Tile {
    number: usize,
    polytope: Polytope,
    classes: Vec<BigInt>,
}

/// The rank of the lattice, and the tiles.
pub(crate) fn read_tiles(t: &mut Transcript) -> Checked<(usize, Vec<Tile>)> {
    let found = t.big()?;
    let rank = usize::try_from(&found).ok().filter(|rank| matches!(rank, 1 | 2));
    let rank = some!(rank, Rank, t.place(), found);
    let mut numbers = 0..;
    let tiles = t.list(None, |t| Tile::read(t, rank, numbers.next().unwrap_or_default()))?;
    ensure!(!tiles.is_empty(), TileCount, t.place());
    Ok((rank, tiles))
}

impl Tile {
    fn read(t: &mut Transcript, rank: usize, number: usize) -> Checked<Tile> {
        t.record(&["denominator", "vertices", "classes"])?;
        let dimension = 3 - rank;
        let (denominator, vertices) = read_points(t, dimension)?;
        let count = vertices.len();
        ensure!(if rank == 1 { count > 2 } else { count == 2 }, SideCount, t.place(), count);
        let classes = t.list(Some(count), Transcript::big)?;
        let faces = (0..count).map(|s| if rank == 1 { vec![s, (s + 1) % count] } else { vec![s] });
        Ok(Tile { number, polytope: Polytope { dimension, denominator, vertices, faces: faces.collect() }, classes })
    }
}

/// A tile with its piece and pyramids.
pub(crate) struct Patch {
    pub(crate) vertices: Vertices,
    /// The sides in which each vertex lies.
    faces: Vec<Vec<u32>>,
    pub(crate) rows: Vec<[Corner; 4]>,
    /// The number of the first row in the certificate.
    pub(crate) first: u64,
    pub(crate) pyramids: Vec<Pyramid>,
    pub(crate) offsets: Vec<Vec<Number>>,
    pub(crate) tile: Polytope,
    pub(crate) classes: Vec<BigInt>,
}

pub(crate) struct Pyramid {
    pub(crate) apex: Corner,
    pub(crate) polygon: Vec<Corner>,
    pub(crate) side: u32,
}

impl Patch {
    /// Reads a patch, and checks that the piece and the fans tile the prism or slab. `simplices`
    /// counts those of all patches.
    pub(crate) fn read<const N: usize>(
        cbor: &mut Cbor,
        head: &Claim,
        tile: &Tile,
        simplices: &mut u64,
        cells: &mut u64,
    ) -> Checked<Patch> {
        let (field, gram, domain) = (head.field.clone(), head.gram.clone(), Domain::Polytope(tile.polytope.clone()));
        let statements = vec![Statement { property: Property::FaceToFace, bound: None, plane: None }];
        let (parameters, file) = Default::default();
        let claim = Claim { dimension: 3, field, parameters, gram, domain, statements, file };
        let work = &cbor.work;
        let mut pass = Pass::new(&claim, Single::<N>::new(&claim, work)?, work);
        cbor.array_of(5)?;
        pass.numbers.read_denominator(&claim, cbor)?;
        cbor.array_of(tile.classes.len())?;
        let offset = |_: &BigInt| Transcript::of(cbor, head).list(Some(head.rank()), read_number);
        let offsets = tile.classes.iter().map(offset).collect::<Checked<_>>()?;
        pass.read_vertices(cbor)?;
        let shape = pass.shape;
        let pyramids = (0..cbor.array()?).map(|_| read_pyramid(cbor, shape));
        let pyramids = pyramids.collect::<Checked<Vec<_>>>()?;
        let count = read_count(cbor, *cells)?;
        *cells = cells.saturating_add(count);
        let (mut rows, first) = (Vec::new(), *simplices);
        for _ in 0..count {
            let row = shape.read_row(cbor, *simplices)?;
            pass.check_row(&row, *simplices)?;
            rows.push(row.corners);
            *simplices += 1;
        }
        // A pyramid is the union of its fans (h_0, h_i, h_(i+1), apex).
        for Pyramid { apex, polygon, .. } in &pyramids {
            for (one, other) in polygon.iter().skip(1).zip(polygon.iter().skip(2)) {
                let first = polygon.first().copied().unwrap_or_default();
                pass.check_row(&positive([first, *one, *other, *apex])?, *simplices)?;
                *simplices += 1;
            }
        }
        pass.check_end()?;
        let (faces, vertices, classes) = (pass.faces, pass.numbers.vertices, tile.classes.clone());
        let (tile, number) = (tile.polytope.clone(), tile.number);
        let mut patch = Patch { vertices, faces, rows, first, pyramids: Vec::new(), offsets, tile, classes };
        for (mut pyramid, index) in pyramids.into_iter().zip(0_usize..) {
            let sides = patch.sides(&pyramid.polygon);
            let is_apart = patch.sides(&[pyramid.apex]).is_empty() && sides.len() == 1;
            ensure!(is_apart, PyramidSide, Place::Tile(number), index);
            pyramid.side = sides.first().copied().unwrap_or_default();
            patch.pyramids.push(pyramid);
        }
        Ok(patch)
    }

    /// The sides that contain all these corners.
    pub(crate) fn sides(&self, corners: &[Corner]) -> Vec<u32> {
        let of = |corner: &Corner| self.faces.get(index(corner.vertex)).map_or(&[][..], Vec::as_slice);
        let first = corners.first().map_or(&[][..], of);
        first.iter().copied().filter(|side| corners.iter().all(|corner| of(corner).contains(side))).collect()
    }

    /// The facets of the piece, each with the opposite corner.
    pub(crate) fn facets(&self) -> impl Iterator<Item = (Vec<Corner>, Corner)> {
        let opposite = |row: &[Corner; 4], apex: Corner| (row.iter().copied().filter(|x| *x != apex).collect(), apex);
        self.rows.iter().flat_map(move |row| row.map(|apex| opposite(row, apex)))
    }
}

fn read_pyramid(cbor: &mut Cbor, shape: Shape) -> Checked<Pyramid> {
    cbor.array_of(2)?;
    let apex = shape.read_corner(cbor, Place::Witness)?;
    let polygon = (0..cbor.array()?).map(|_| shape.read_corner(cbor, Place::Witness));
    let polygon = polygon.collect::<Checked<Vec<_>>>()?;
    let mut sorted = polygon.clone();
    sorted.push(apex);
    sorted.sort_unstable();
    let is_polygon = polygon.len() > 2 && sorted.is_sorted_by(|one, other| one < other);
    let is_start = polygon.first().is_some_and(|first| first.shift == [0; 3]);
    ensure!(is_polygon && is_start, PyramidForm, cbor.place());
    Ok(Pyramid { apex, polygon, side: 0 })
}

/// The row of a tetrahedron whose corners are positively oriented in this order.
fn positive(corners: [Corner; 4]) -> Checked<Row> {
    let mut sorted = corners;
    sorted.sort_unstable();
    let [base, ..] = sorted;
    let exceeds =
        |corner: &Corner| corner.seen_from(base).shift.iter().any(|s| u64::from(s.unsigned_abs()) >= MOST_SHIFT);
    ensure!(!sorted.iter().any(exceeds), ShiftRange, Place::Witness);
    let pairs = corners.iter().enumerate().flat_map(|(k, x)| corners.iter().skip(k).map(move |y| (x, y)));
    let is_odd = pairs.filter(|(x, y)| x > y).count() % 2 == 1;
    let [a, b, c, d] = sorted.map(|corner| corner.seen_from(base));
    let corners = if is_odd { [a, b, d, c] } else { [a, b, c, d] };
    Ok(Row { corners, sorted: [a, b, c, d], is_odd, sixes: 0 })
}
