//! The cells of a system of patches, each with the cells that it can meet: those of the pieces, and
//! those of the joins, for all pairs of sides that can meet.

use crate::claim::Claim;
use crate::domain::cycle;
use crate::refusal::{Checked, Place, Stop};
use crate::ring::{Ring, each};
use crate::row::Corner;
use crate::rules::Simplex;
use crate::tiling::check_attained;
use crate::walls::{Large, Point, Side, System, name};
use std::cmp::Ordering::Greater;
use std::collections::BTreeMap;

/// Two pyramids over one polygon h_0, …, h_(n-1), with the apexes l and m. Its cells are (m, h_i, h_(i+1), l).
pub(crate) struct Join<const N: usize> {
    /// The index of the side of the first pyramid, and of the other one.
    pub(crate) sides: [usize; 2],
    /// The indices of the pyramids in their patches.
    pub(crate) pyramids: [usize; 2],
    polygon: Vec<Point<N>>,
    apex: Point<N>,
    beyond: Point<N>,
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
    pub(crate) fn check_cells(&self, claim: &Claim) -> Checked<Vec<Join<N>>> {
        let mut attained = 0;
        for (patch, tile) in self.patches.iter().zip(0..) {
            for (row, simplex) in patch.rows.iter().zip(patch.first..) {
                let corners = each(row, |corner| self.point(tile, *corner))?;
                attained |= self.check_cell(&corners, None, Place::Simplex(simplex))?;
            }
        }
        check_attained(claim, attained)?;
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

    /// The axis from m to l crosses the polygon. Each cell is positive, and its neighbour is beyond their facet.
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
            for [one, other] in cycle(&pyramid.polygon) {
                self.add(&mut opposites, &[one, other, pyramid.apex], beyond.clone())?;
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
}
