//! The tiles of a system of patches, each with the piece and the pyramids over it.
//!
//! Each patch, with its pyramids cut into fans, is checked by the pass of [`crate::tiling`] as a prism or slab.

use crate::cbor::Cbor;
use crate::claim::{
    Claim, Domain, Field, Number, Polytope, Property, Statement, check_lowest, integers, read_gram, read_number,
    read_polynomial, read_statements,
};
use crate::limits::{Limits, Work};
use crate::numbers::Single;
use crate::refusal::{Checked, Place, Value};
use crate::row::{Corner, MOST_SHIFT, Row, Shape};
use crate::table::index;
use crate::tiling::Pass;
use crate::transcript::Transcript;
use crate::vertices::Vertices;
use num_bigint::BigInt;
use std::rc::Rc;

/// The claim. Its members in common with the kind `tiling` are in a claim about all of space.
pub(crate) struct Head {
    pub(crate) claim: Claim,
    pub(crate) rank: usize,
    pub(crate) tiles: Vec<Tile>,
}

pub(crate) struct Tile {
    number: usize,
    polytope: Polytope,
    classes: Vec<BigInt>,
}

impl Head {
    pub(crate) fn read(cbor: &mut Cbor, limits: &Limits) -> Checked<Head> {
        let mut t = Transcript::new(cbor, "patches");
        t.record(&["field", "gram", "rank", "tiles", "statements"])?;
        let field = Field::read(&mut t, limits)?;
        let degree = field.degree();
        let gram = read_gram(&mut t, 3, degree, 0)?;
        let found = t.big()?;
        let rank = usize::try_from(&found).ok().filter(|rank| matches!(rank, 1 | 2));
        let rank = some!(rank, Rank, t.place(), found);
        let mut numbers = 0..;
        let tiles = t.list(None, |t| Tile::read(t, rank, degree, numbers.next().unwrap_or_default()))?;
        ensure!(!tiles.is_empty(), TileCount, t.place());
        let statements = read_statements(&mut t, degree, 3)?;
        let (parameters, domain, file) = (Vec::new(), Domain::Space, t.json + "\n");
        let claim = Claim { dimension: 3, field, parameters, gram, domain, statements, file };
        Ok(Head { claim, rank, tiles })
    }
}

impl Tile {
    fn read(t: &mut Transcript, rank: usize, degree: usize, number: usize) -> Checked<Tile> {
        t.record(&["denominator", "vertices", "classes"])?;
        let denominator = t.big()?;
        ensure!(denominator > BigInt::ZERO, Denominator, t.place(), denominator);
        let dimension = 3 - rank;
        let vertices = t.list(None, |t| t.list(Some(dimension), |t| read_polynomial(t, degree, 0)))?;
        check_lowest(t.place(), vertices.iter().flat_map(|vertex| integers(vertex)).chain([&denominator]))?;
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
        head: &Head,
        tile: &Tile,
        limits: &Limits,
        work: &Rc<Work>,
        simplices: &mut u64,
        cells: &mut u64,
    ) -> Checked<Patch> {
        let Claim { field, gram, .. } = &head.claim;
        let degree = field.degree();
        let (field, gram, domain) = (field.clone(), gram.clone(), Domain::Polytope(tile.polytope.clone()));
        let statements = vec![Statement { property: Property::FaceToFace, bound: None, plane: None }];
        let (parameters, file) = Default::default();
        let claim = Claim { dimension: 3, field, parameters, gram, domain, statements, file };
        let mut pass = Pass::new(&claim, Single::<N>::new(&claim, work)?, work);
        cbor.array_of(5)?;
        pass.numbers.read_denominator(&claim, cbor)?;
        cbor.array_of(tile.classes.len())?;
        let offsets = tile.classes.iter().map(|_| read_offset(cbor, head.rank, degree)).collect::<Checked<_>>()?;
        for _ in 0..cbor.array()? {
            pass.numbers.vertices.read(cbor)?;
            pass.add_vertex()?;
        }
        pass.numbers.vertices.check_lowest(cbor.place())?;
        let shape = pass.shape;
        let pyramids = (0..cbor.array()?).map(|_| read_pyramid(cbor, shape));
        let pyramids = pyramids.collect::<Checked<Vec<_>>>()?;
        let count = cbor.array()?;
        ensure!(count > 0, NoSimplices, Place::Witness);
        *cells = cells.saturating_add(count);
        ensure!(*cells <= limits.simplices, TooManySimplices, Place::Witness, Value::Limit("simplices", Some(*cells)));
        let (mut rows, first) = (Vec::new(), *simplices);
        for _ in 0..count {
            let row = shape.read_row(cbor, *simplices)?;
            pass.check_row(&row, *simplices)?;
            rows.push(row.corners);
            *simplices += 1;
        }
        // A pyramid is the union of its fans (h_0, h_i, h_(i+1), apex).
        for (apex, polygon) in &pyramids {
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
        for ((apex, polygon), index) in pyramids.into_iter().zip(0_usize..) {
            let sides = patch.sides(&polygon);
            let is_apart = patch.sides(&[apex]).is_empty() && sides.len() == 1;
            ensure!(is_apart, PyramidSide, Place::Tile(number), index);
            patch.pyramids.push(Pyramid { apex, polygon, side: sides.first().copied().unwrap_or_default() });
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

fn read_offset(cbor: &mut Cbor, rank: usize, degree: usize) -> Checked<Vec<Number>> {
    Transcript::new(cbor, "").list(Some(rank), |t| read_number(t, degree))
}

fn read_pyramid(cbor: &mut Cbor, shape: Shape) -> Checked<(Corner, Vec<Corner>)> {
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
    Ok((apex, polygon))
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
