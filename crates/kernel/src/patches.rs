//! Certificates of the kind `patches`: one theorem about all tilings that a system of patches
//! builds, periodic or not.
//!
//! Each patch, with its pyramids cut into fans, is checked by the pass of [`crate::tiling`] as a
//! prism or slab. [`crate::walls`] compares the sides. This module finds all pairs of sides that
//! can meet, and checks the statements for the cells of the pieces and joins, each with the cells
//! that it can meet. docs/soundness.md, section 10, has the proof.

use crate::cbor::Cbor;
use crate::claim::{
    Claim, Domain, Field, Polytope, Property, Relation, Statement, check_lowest, integers, read_gram, read_polynomial,
    read_statements,
};
use crate::limits::{Limits, Work};
use crate::numbers::Single;
use crate::refusal::{Checked, Place, Stop, Value};
use crate::ring::{Exact, Ring, Vector, each};
use crate::root::Root;
use crate::row::{Corner, Row, Shape};
use crate::rules::{Rules, Simplex};
use crate::table::index;
use crate::tiling::{Facts, Pass, check_statements};
use crate::transcript::Transcript;
use crate::valences;
use crate::vertices::Vertices;
use crate::walls::{self, Side, name};
use num_bigint::BigInt;
use num_integer::Integer;
use std::cmp::Ordering::Greater;
use std::collections::BTreeMap;
use std::rc::Rc;

pub(crate) type Large<const N: usize> = Exact<BigInt, N>;
pub(crate) type Point<const N: usize> = Vector<Large<N>>;

/// The claim. What the kind `tiling` has, too, is in a claim about all of space.
pub(crate) struct Head {
    pub(crate) claim: Claim,
    rank: usize,
    tiles: Vec<Tile>,
}

struct Tile {
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
        let claim = Claim {
            dimension: 3,
            field,
            parameters: Vec::new(),
            gram,
            domain: Domain::Space,
            statements,
            file: t.json + "\n",
        };
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
    first: u64,
    pub(crate) pyramids: Vec<Pyramid>,
    pub(crate) offsets: Vec<Vec<Vec<BigInt>>>,
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
    fn read<const N: usize>(
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
        let claim = Claim {
            dimension: 3,
            field: field.clone(),
            parameters: Vec::new(),
            gram: gram.clone(),
            domain: Domain::Polytope(tile.polytope.clone()),
            statements: vec![Statement { property: Property::FaceToFace, bound: None, plane: None }],
            file: String::new(),
        };
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
                pass.check_row(&Row::positive([first, *one, *other, *apex])?, *simplices)?;
                *simplices += 1;
            }
        }
        pass.check_end()?;
        let mut patch = Patch {
            faces: pass.faces,
            vertices: pass.numbers.vertices,
            rows,
            first,
            pyramids: Vec::new(),
            offsets,
            tile: tile.polytope.clone(),
            classes: tile.classes.clone(),
        };
        for ((apex, polygon), number) in pyramids.into_iter().zip(0_usize..) {
            let sides = patch.sides(&polygon);
            let is_apart = patch.sides(&[apex]).is_empty() && sides.len() == 1;
            ensure!(is_apart, PyramidSide, Place::Tile(tile.number), number);
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

fn read_offset(cbor: &mut Cbor, rank: usize, degree: usize) -> Checked<Vec<Vec<BigInt>>> {
    cbor.array_of(rank)?;
    let number = |cbor: &mut Cbor| {
        if degree == 1 {
            return Ok(vec![cbor.big()?]);
        }
        cbor.array_of(degree)?;
        (0..degree).map(|_| cbor.big()).collect()
    };
    (0..rank).map(|_| number(cbor)).collect()
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

/// Two pyramids over one polygon h_0, …, h_(n-1), with the apexes l and m. Its cells are
/// (m, h_i, h_(i+1), l).
pub(crate) struct Join<const N: usize> {
    /// The index of the side of the first pyramid, and of the other one.
    pub(crate) sides: [usize; 2],
    /// The indices of the pyramids in their patches.
    pub(crate) pyramids: [usize; 2],
    polygon: Vec<Point<N>>,
    apex: Point<N>,
    beyond: Point<N>,
}

/// The patches in common coordinates: times `scale`, and times `unit`.
pub(crate) struct System<const N: usize> {
    pub(crate) ring: Large<N>,
    pub(crate) rules: Rules<Large<N>>,
    pub(crate) rank: usize,
    pub(crate) scale: BigInt,
    pub(crate) patches: Vec<Patch>,
    pub(crate) sides: Vec<Side<N>>,
}

/// Reads and checks the rest of a certificate whose claim has been read.
pub(crate) fn verify<const N: usize>(mut cbor: Cbor, head: Head, limits: &Limits, work: &Rc<Work>) -> Checked<Facts> {
    let ring = Large::<N>::new(&Rc::new(Root::new(&head.claim.field, work)?), work)?;
    let rules = Rules::new(&ring, &head.claim).map_err(|stop| stop.at(Place::Field))?;
    check_statements(&head.claim, false)?;
    // b_i · b_j = 0 for i <= r < j: two entries of the upper triangle by rows.
    let mixed = if head.rank == 1 { [1, 2] } else { [2, 4] };
    let is_zero = |k: usize| {
        head.claim.gram.get(k).is_some_and(|x| integers(std::slice::from_ref(x)).all(|c| *c == BigInt::ZERO))
    };
    ensure!(mixed.into_iter().all(is_zero), GramBlocks, Place::Field);
    let count = cbor.array()?;
    let is_complete = usize::try_from(count).is_ok_and(|count| count == head.tiles.len());
    ensure!(is_complete, TileCount, Place::Witness, count);
    let (mut simplices, mut cells) = (0, 0);
    let read = |tile| Patch::read::<N>(&mut cbor, &head, tile, limits, work, &mut simplices, &mut cells);
    let patches = head.tiles.iter().map(read);
    let patches = patches.collect::<Checked<Vec<_>>>()?;
    let (bytes, sha256) = cbor.finish()?;
    let scale = patches.iter().fold(BigInt::from(1), |scale, patch| scale.lcm(&patch.vertices.denominator));
    let vertices = patches.iter().map(|patch| patch.vertices.count).fold(0, u32::saturating_add);
    let rows = patches.iter().map(|patch| u64::try_from(patch.rows.len()).unwrap_or(u64::MAX)).sum();
    let mut system = System { ring, rules, rank: head.rank, scale, patches, sides: Vec::new() };
    system.sides = walls::sides(&system)?;
    let angles = if head.rank == 1 { walls::check_corners(&system)? } else { Default::default() };
    let joins = system.check_cells(&head.claim)?;
    if head.claim.has(Property::Tcp) {
        valences::check(&system, &joins, &angles)?;
    }
    Ok(Facts {
        claim: head.claim,
        vertices,
        simplices: rows,
        boundary_facets: 0,
        peak_facets: 0,
        peak_edges: 0,
        bytes,
        sha256,
    })
}

/// The points on one side of a facet and on the other one, for each of its names.
type Opposites<const N: usize> = BTreeMap<[Corner; 3], Vec<Vec<Point<N>>>>;

impl<const N: usize> System<N> {
    /// The sides that can meet, in both orders.
    pub(crate) fn meetings(&self) -> impl Iterator<Item = (usize, usize)> {
        let sides = || self.sides.iter().enumerate();
        sides().flat_map(move |(i, left)| {
            let meets =
                move |right: &Side<N>| left.label == right.label && (self.rank == 1 || left.number != right.number);
            sides().filter(move |(_, right)| meets(right)).map(move |(j, _)| (i, j))
        })
    }

    /// Checks the statements about angles, ratios and spheres, and that each join is there.
    fn check_cells(&self, claim: &Claim) -> Checked<Vec<Join<N>>> {
        let mut attained = 0;
        for (patch, tile) in self.patches.iter().zip(0..) {
            for (row, simplex) in patch.rows.iter().zip(patch.first..) {
                let corners = each(row, |corner| self.point(tile, *corner))?;
                attained |= self.check_cell(&corners, None, Place::Simplex(simplex))?;
            }
        }
        for (statement, index) in claim.statements.iter().zip(0..) {
            let relation = statement.bound.as_ref().map(|bound| bound.relation);
            let is_extreme = matches!(relation, Some(Relation::Maximum | Relation::Minimum));
            ensure!(!is_extreme || attained >> index & 1 == 1, NotAttained, Place::Statement(index));
        }
        let mut joins = Vec::new();
        for (i, j) in self.meetings().collect::<Vec<_>>() {
            self.work().check(self.side(i)?.place())?;
            joins.extend(self.meet(i, j)?);
        }
        if self.rules.needs_mates() {
            for patch in 0..self.patches.len() {
                self.check_inside(patch, &joins)?;
            }
        }
        Ok(joins)
    }

    /// Checks two sides that meet, and returns their joins.
    fn meet(&self, i: usize, j: usize) -> Checked<Vec<Join<N>>> {
        let mut joins = Vec::new();
        let (left, right) = (self.side(i)?, self.side(j)?);
        for (name, one) in &left.left.polygons {
            let other = right.right.polygons.get(name).ok_or(Stop::LARGER)?;
            let polygon = one.corners.iter().map(|corner| self.point(left.patch, *corner));
            let polygon = polygon.collect::<Checked<Vec<_>>>()?;
            let apex = self.point(left.patch, one.apex)?;
            let beyond = left.point_of(self, right, other.apex, one.base.seen_from(other.base))?;
            match (one.pyramid, other.pyramid, polygon.as_slice()) {
                (Some(first), Some(second), _) => {
                    let join = Join { sides: [i, j], pyramids: [first, second], polygon, apex, beyond };
                    self.check_join(&join)?;
                    joins.push(join);
                }
                (_, _, [a, b, c]) => {
                    self.check_cell(&[apex, a.clone(), b.clone(), c.clone()], Some(&beyond), left.place())?;
                }
                _ => return Err(Stop::LARGER),
            }
        }
        Ok(joins)
    }

    /// The axis from m to l crosses the polygon. Each cell is positive, and its neighbour is
    /// beyond their facet.
    fn check_join(&self, join: &Join<N>) -> Checked {
        let Join { polygon, apex, beyond, .. } = join;
        let place = self.side(join.sides[0])?.place();
        let following = || polygon.iter().cycle().skip(1);
        for ((one, other), after) in polygon.iter().zip(following()).zip(following().skip(1)) {
            let determinant = self.determinant(&[beyond, one, other, apex])?;
            let is_positive = self.ring.sign(&determinant).is(|sign| sign == Greater)?;
            ensure!(is_positive, MissingJoin, place, self.ring.value(&determinant));
            let cell = [beyond.clone(), other.clone(), one.clone(), apex.clone()];
            self.check_cell(&cell, Some(after), place)?;
        }
        Ok(())
    }

    /// The facets inside of a tile that are in no fan, with all cells that can be on either side.
    fn check_inside(&self, number: usize, joins: &[Join<N>]) -> Checked {
        let patch = self.patches.get(number).ok_or(Stop::LARGER)?;
        let mut opposites = Opposites::new();
        for (facet, apex) in patch.facets().filter(|(facet, _)| patch.sides(facet).is_empty()) {
            self.add(&mut opposites, &facet, vec![self.point(number, apex)?])?;
        }
        for (pyramid, p) in patch.pyramids.iter().zip(0..) {
            let is_here = |join: &&Join<N>| {
                join.pyramids[0] == p && self.sides.get(join.sides[0]).is_some_and(|side| side.patch == number)
            };
            let mut beyond: Vec<Point<N>> = Vec::new();
            for join in joins.iter().filter(is_here) {
                if !beyond.contains(&join.beyond) {
                    beyond.push(join.beyond.clone());
                }
            }
            for (one, other) in pyramid.polygon.iter().zip(pyramid.polygon.iter().cycle().skip(1)) {
                self.add(&mut opposites, &[*one, *other, pyramid.apex], beyond.clone())?;
            }
        }
        for (facet, sides) in &opposites {
            let [points, others] = sides.as_slice() else { return Err(Stop::LARGER) };
            let [a, b, c] = each(facet, |corner| self.point(number, *corner))?;
            for (point, other) in points.iter().flat_map(|point| others.iter().map(move |other| (point, other))) {
                self.check_cell(&[point.clone(), a.clone(), b.clone(), c.clone()], Some(other), Place::Tile(number))?;
            }
            self.work().check(Place::Tile(number))?;
        }
        Ok(())
    }

    /// Adds the points that can be on one side of a facet, seen from its first corner.
    fn add(&self, opposites: &mut Opposites<N>, facet: &[Corner], points: Vec<Point<N>>) -> Checked {
        let (base, name) = name(facet);
        let name = <[Corner; 3]>::try_from(name).map_err(|_| Stop::LARGER)?;
        let back = self.shift(&Corner { vertex: 0, shift: base.shift.map(|s| -s) })?;
        let points = points.iter().map(|point| self.sum(point, &back));
        opposites.entry(name).or_default().push(points.collect::<Checked<_>>()?);
        Ok(())
    }

    /// Checks a cell, and the corner of a mate that is not in their common facet.
    fn check_cell(&self, [a, b, c, d]: &[Point<N>; 4], mate: Option<&Point<N>>, place: Place) -> Checked<u32> {
        let determinant = self.determinant(&[a, b, c, d])?;
        let is_positive = self.ring.sign(&determinant).is(|sign| sign == Greater)?;
        let (c, d) = if is_positive { (c, d) } else { (d, c) };
        let vector = |x| self.ring.difference(a, x);
        let mates = [mate.map(vector).transpose()?, None, None, None];
        let simplex = Simplex { number: 0, edges: [vector(b)?, vector(c)?, vector(d)?], mates };
        let found = self.rules.check(&simplex, &self.scale).map_err(Stop::refusal);
        found.map(|(_, attained)| attained).map_err(|refusal| Stop::refuse(refusal.code, place, refusal.value))
    }

    fn determinant(&self, [a, b, c, d]: &[&Point<N>; 4]) -> Checked<<Large<N> as Ring>::Element> {
        let vector = |x| self.ring.difference(a, x);
        self.ring.inner(&vector(b)?, &self.ring.cross(&vector(c)?, &vector(d)?)?)
    }

    pub(crate) fn work(&self) -> &Work {
        self.ring.work()
    }

    pub(crate) fn side(&self, number: usize) -> Checked<&Side<N>> {
        self.sides.get(number).ok_or(Stop::LARGER)
    }
}
