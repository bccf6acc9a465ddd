//! The sides of the tiles of a system of patches, and the patterns in them.
//!
//! The wall coordinates of a point are those of the fibre less the offset of the side, and then,
//! for rank 1, X = ⟨u, b⟩ along the side and Y = det(u, b) inwards; for rank 2 the height.

use crate::domain::cycle;
use crate::limits::Work;
use crate::patch::Patch;
use crate::refusal::{Checked, Place, Stop};
use crate::ring::{Element, Exact, Ring, Vector, each};
use crate::row::Corner;
use crate::rules::Rules;
use num_bigint::BigInt;
use num_integer::Integer;
use std::cmp::Ordering::Greater;
use std::collections::{BTreeMap, BTreeSet};

pub(crate) type Large<const N: usize> = Exact<BigInt, N>;
pub(crate) type Point<const N: usize> = Vector<Large<N>>;
type Number<const N: usize> = Element<BigInt, N>;

/// The patches in common coordinates: times `scale`; and their sides, where points are also multiplied by the unit of
/// the sides.
pub(crate) struct System<const N: usize> {
    pub(crate) ring: Large<N>,
    pub(crate) rules: Rules<Large<N>>,
    pub(crate) rank: usize,
    pub(crate) scale: BigInt,
    pub(crate) patches: Vec<Patch>,
    pub(crate) sides: Vec<Side<N>>,
}

/// The edges as corners of the wall, seen from the least corner; and whether it is a pyramid's.
type Name = (BTreeSet<Vec<Corner>>, bool);

/// A polygon in a side, with the apex of the pyramid or of the cell over it.
pub(crate) struct Polygon {
    pub(crate) corners: Vec<Corner>,
    pub(crate) apex: Corner,
    pub(crate) pyramid: Option<usize>,
    /// The corners in the wall, seen from the least one, and that one.
    pub(crate) there: Vec<Corner>,
    pub(crate) base: Corner,
}

/// A side as a part of the wall of its class.
#[derive(Default)]
pub(crate) struct View {
    /// The corner of the wall at each vertex in the side.
    corners: BTreeMap<u32, Corner>,
    pub(crate) polygons: BTreeMap<Name, Polygon>,
}

#[derive(Default)]
pub(crate) struct Side<const N: usize> {
    pub(crate) patch: usize,
    pub(crate) number: u32,
    pub(crate) label: BigInt,
    /// Its first corner, the offset, u, G u, v with ⟨v, b⟩ = 0 for all b along u, and ⟨u, u⟩.
    start: Point<N>,
    pub(crate) offset: Point<N>,
    along: Point<N>,
    dual: Point<N>,
    across: Point<N>,
    square: Number<N>,
    /// The product of the squares of the other classes, and of all.
    others: Number<N>,
    unit: Number<N>,
    /// As seen from its own tile, and from the tile beyond.
    pub(crate) left: View,
    pub(crate) right: View,
}

/// A corner that is none of the wall's.
const NOWHERE: Corner = Corner { vertex: u32::MAX, shift: [0; 3] };

/// The least corner, and all corners in order, seen from it. So translates have one name.
pub(crate) fn name(corners: &[Corner]) -> (Corner, Vec<Corner>) {
    let mut sorted = corners.to_vec();
    sorted.sort_unstable();
    let base = sorted.first().copied().unwrap_or_default();
    (base, sorted.into_iter().map(|corner| corner.seen_from(base)).collect())
}

impl View {
    pub(crate) fn corner(&self, corner: Corner) -> Corner {
        self.corners.get(&corner.vertex).map_or(NOWHERE, |there| there.moved_by(corner))
    }

    fn add(&mut self, corners: Vec<Corner>, apex: Corner, pyramid: Option<usize>) {
        let there: Vec<Corner> = corners.iter().map(|corner| self.corner(*corner)).collect();
        let base = there.iter().min().copied().unwrap_or_default();
        let there: Vec<Corner> = there.into_iter().map(|corner| corner.seen_from(base)).collect();
        let edges = cycle(&there).map(|mut edge| {
            edge.sort_unstable();
            edge.to_vec()
        });
        let name = (edges.collect(), pyramid.is_some());
        self.polygons.insert(name, Polygon { corners, apex, pyramid, there, base });
    }
}

/// The sides of all tiles, with their patterns compared.
pub(crate) fn sides<const N: usize>(system: &System<N>) -> Checked<Vec<Side<N>>> {
    let mut sides = Vec::new();
    for (patch, number) in system.patches.iter().zip(0..) {
        check_order(system, patch, number)?;
        for side in 0..patch.classes.len() {
            sides.push(Side::new(system, patch, number, side)?);
        }
    }
    let mut walls: BTreeMap<BigInt, usize> = BTreeMap::new();
    for (side, number) in sides.iter().zip(0..) {
        walls.entry(side.label.clone()).or_insert(number);
    }
    let squares = |label: Option<&BigInt>| {
        let others = walls.iter().filter(|(other, _)| label != Some(other));
        let mut squares = others.filter_map(|(_, number)| sides.get(*number)).map(|side| &side.square);
        squares.try_fold(system.ring.integer(1)?, |product, square| system.ring.times(&product, square))
    };
    let unit = squares(None)?;
    let others = sides.iter().map(|side| squares(Some(&side.label))).collect::<Checked<Vec<_>>>()?;
    let mut done: Vec<Side<N>> = Vec::new();
    for (mut side, others) in sides.into_iter().zip(others) {
        (side.others, side.unit) = (others, unit.clone());
        let wall = walls.get(&side.label).and_then(|number| done.get(*number));
        let (left, right) = side.views(system, wall)?;
        (side.left, side.right) = (left, right);
        done.push(side);
    }
    Ok(done)
}

/// The vertices of a tile are counterclockwise, or in increasing order.
fn check_order<const N: usize>(system: &System<N>, patch: &Patch, tile: usize) -> Checked {
    let ring = &system.ring;
    let [a, b, c] = [0, 1, 2].map(|corner| system.base(patch, corner));
    let (a, b) = (a?, b?);
    let turn = match c {
        Ok(c) if system.rank == 1 => ring.cross(&ring.difference(&a, &b)?, &ring.difference(&a, &c)?)?,
        _ => ring.difference(&a, &b)?,
    };
    let [first, _, last] = &turn;
    let is_ordered = ring.sign(if system.rank == 1 { first } else { last }).is(|sign| sign == Greater)?;
    ensure!(is_ordered, TileOrder, Place::Tile(tile));
    Ok(())
}

impl<const N: usize> Side<N> {
    fn new(system: &System<N>, patch: &Patch, number: usize, side: usize) -> Checked<Self> {
        let ring = &system.ring;
        let mut offset = Point::<N>::default();
        let offsets = patch.offsets.get(side).ok_or(Stop::LARGER)?;
        for (slot, x) in offset.iter_mut().zip(offsets) {
            *slot = ring.times(&ring.element(x)?, &system.factor(patch)?)?;
        }
        let start = system.base(patch, side)?;
        let end = system.base(patch, (side + 1) % patch.classes.len())?;
        let along = if system.rank == 1 { ring.difference(&start, &end)? } else { Default::default() };
        let dual = system.rules.image(&along)?;
        let [_, first, second] = &dual;
        let across = [Default::default(), ring.negated(second)?, first.clone()];
        let square = if system.rank == 1 { ring.inner(&along, &dual)? } else { ring.integer(1)? };
        let label = patch.classes.get(side).cloned().unwrap_or_default();
        let number_of_side = u32::try_from(side).map_err(|_| Stop::LARGER)?;
        let side = Side { patch: number, number: number_of_side, label, start, offset, along, ..Side::default() };
        Ok(Side { dual, across, square, ..side })
    }

    pub(crate) fn place(&self) -> Place {
        Place::Side(self.patch, self.number)
    }

    /// The wall coordinates, seen from the tile of this side or from the one beyond.
    fn coordinates(&self, system: &System<N>, corner: Corner, is_turned: bool) -> Checked<Point<N>> {
        let ring = &system.ring;
        let patch = system.patches.get(self.patch).ok_or(Stop::LARGER)?;
        let factor = system.factor(patch)?;
        let point = each(&patch.vertices.point(corner)?, |x| ring.times(x, &factor))?;
        let [f, y, z] = ring.difference(&self.offset, &ring.difference(&self.start, &point)?)?;
        if system.rank == 2 {
            return Ok([f, y, z]);
        }
        let base = [Default::default(), y, z];
        let (x, [y, ..]) = (ring.inner(&self.dual, &base)?, ring.cross(&self.along, &base)?);
        Ok(if is_turned { [f, ring.minus(&self.square, &x)?, ring.negated(&y)?] } else { [f, x, y] })
    }

    /// The vertices in this side with their wall coordinates.
    fn points(&self, system: &System<N>, is_turned: bool) -> Checked<Vec<(Corner, Point<N>)>> {
        let patch = system.patches.get(self.patch).ok_or(Stop::LARGER)?;
        let corners = (0..patch.vertices.count).map(|vertex| Corner { vertex, shift: [0; 3] });
        let corners = corners.filter(|corner| patch.sides(&[*corner]).contains(&self.number));
        corners.map(|corner| Ok((corner, self.coordinates(system, corner, is_turned)?))).collect()
    }

    /// The pattern, which is that of the first side of the class, from here and from beyond.
    fn views(&self, system: &System<N>, wall: Option<&Side<N>>) -> Checked<(View, View)> {
        let points = wall.unwrap_or(self).points(system, false)?;
        let left = self.view(system, &points, false)?;
        let is_same =
            wall.is_none_or(|wall| left.polygons.keys().eq(wall.left.polygons.keys()) && self.square == wall.square);
        ensure!(is_same, WallPattern, self.place());
        let right = self.view(system, &points, system.rank == 1)?;
        ensure!(left.polygons.keys().eq(right.polygons.keys()), WallReversal, self.place());
        Ok((left, right))
    }

    fn view(&self, system: &System<N>, wall: &[(Corner, Point<N>)], is_turned: bool) -> Checked<View> {
        let patch = system.patches.get(self.patch).ok_or(Stop::LARGER)?;
        let mut view = View::default();
        for (corner, point) in self.points(system, is_turned)? {
            view.corners.insert(corner.vertex, self.corner_at(system, wall, &point)?);
            system.ring.work().check(self.place())?;
        }
        for (pyramid, number) in patch.pyramids.iter().zip(0..).filter(|(pyramid, _)| pyramid.side == self.number) {
            view.add(pyramid.polygon.clone(), pyramid.apex, Some(number));
        }
        for (facet, apex) in patch.facets().filter(|(facet, _)| patch.sides(facet).contains(&self.number)) {
            view.add(facet, apex, None);
        }
        Ok(view)
    }

    /// The corner of the wall at these coordinates: X is the same, and the others differ by a lattice vector.
    fn corner_at(&self, system: &System<N>, wall: &[(Corner, Point<N>)], point: &Point<N>) -> Checked<Corner> {
        for (corner, there) in wall {
            let difference = system.ring.difference(there, point)?;
            let shift = each(&difference, |x| Ok(system.whole(x, &system.scale)));
            system.ring.work().add(50);
            match (shift?, system.rank) {
                ([Some(f), ..], 1) if difference[1] == Element::default() => {
                    return Ok(Corner { shift: [f, 0, 0], ..*corner });
                }
                ([Some(f), Some(g), _], 2) => return Ok(Corner { shift: [f, g, 0], ..*corner }),
                _ => {}
            }
        }
        Ok(NOWHERE)
    }

    /// The point of a corner of the tile beyond, which this side meets with its side `right`, moved
    /// by a lattice vector.
    pub(crate) fn point_of(
        &self,
        system: &System<N>,
        right: &Side<N>,
        corner: Corner,
        shift: Corner,
    ) -> Checked<Point<N>> {
        let ring = &system.ring;
        let there = right.coordinates(system, corner, true)?;
        let shift = each(&shift.shift, |s| ring.times(&ring.integer(i64::from(*s))?, &ring.long(&system.scale)?))?;
        let plus = |a: &Point<N>, b: &Point<N>| system.sum(a, b);
        let home = plus(&plus(&self.offset, &shift)?, &self.start)?;
        if system.rank == 2 {
            return each(&plus(&home, &there)?, |x| ring.times(x, &self.unit));
        }
        // X u + Y v, which is ⟨u, u⟩ times the vector in the base.
        let [f, x, y] = &there;
        let base = plus(&each(&self.along, |u| ring.times(u, x))?, &each(&self.across, |v| ring.times(v, y))?)?;
        let fibre = [f.clone(), Default::default(), Default::default()];
        plus(
            &each(&plus(&home, &fibre)?, |x| ring.times(x, &self.unit))?,
            &each(&base, |x| ring.times(x, &self.others))?,
        )
    }
}

impl<const N: usize> System<N> {
    /// The multiple of a patch's coordinates that has the denominator `scale`.
    fn factor(&self, patch: &Patch) -> Checked<Number<N>> {
        self.ring.element(&[&self.scale / &patch.vertices.denominator])
    }

    /// A corner of the tile in the base, over `scale`.
    pub(crate) fn base(&self, patch: &Patch, corner: usize) -> Checked<Point<N>> {
        let factor = self.ring.element(&[&self.scale / &patch.tile.denominator])?;
        let corner = patch.tile.vertices.get(corner).ok_or(Stop::LARGER)?;
        let mut point = Point::<N>::default();
        for (slot, x) in point.iter_mut().skip(self.rank).zip(corner) {
            *slot = self.ring.times(&self.ring.polynomial(x)?, &factor)?;
        }
        Ok(point)
    }

    pub(crate) fn sum(&self, a: &Point<N>, b: &Point<N>) -> Checked<Point<N>> {
        crate::ring::zip(a, b, |a, b| self.ring.plus(a, b))
    }

    /// x / divisor where that is an integer of the size of a shift.
    pub(crate) fn whole(&self, x: &Number<N>, divisor: &BigInt) -> Option<i32> {
        let (first, others) = x.0.split_first()?;
        let is_integer = others.iter().all(|c| *c == BigInt::ZERO) && first.is_multiple_of(divisor);
        let whole = i32::try_from(first / divisor).ok()?;
        (is_integer && whole.unsigned_abs() < 1 << 29).then_some(whole)
    }

    /// A corner of a patch in common coordinates.
    pub(crate) fn point(&self, patch: usize, corner: Corner) -> Checked<Point<N>> {
        let patch = self.patches.get(patch).ok_or(Stop::LARGER)?;
        let factor = self.ring.times(&self.factor(patch)?, self.unit()?)?;
        each(&patch.vertices.point(corner)?, |x| self.ring.times(x, &factor))
    }

    /// A lattice vector in common coordinates.
    pub(crate) fn shift(&self, corner: &Corner) -> Checked<Point<N>> {
        let factor = self.ring.times(&self.ring.long(&self.scale)?, self.unit()?)?;
        each(&corner.shift, |s| self.ring.times(&self.ring.integer(i64::from(*s))?, &factor))
    }

    fn unit(&self) -> Checked<&Number<N>> {
        self.sides.first().map(|side| &side.unit).ok_or(Stop::LARGER)
    }

    pub(crate) fn work(&self) -> &Work {
        self.ring.work()
    }

    pub(crate) fn side(&self, number: usize) -> Checked<&Side<N>> {
        self.sides.get(number).ok_or(Stop::LARGER)
    }
}
