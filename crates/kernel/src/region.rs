//! Regions: conditions X and W, which make the covering number N of the tiles at most 1, for a lattice of any rank.
//! docs/soundness.md, section 8, has the proof. N(x) is the number of tiles that contain x, for a point x on no facet.
//!
//! **X** (`boundary-meets`). Two boundary facets, up to the lattice, meet in the hull of their common corners.
//!
//! **W** (`covering`). N = 0 just outside of the first boundary facet of each class. Two boundary facets belong to
//! one class if they have a ridge (an edge, in the plane a vertex) that no third one has, up to the lattice.
//!
//! Left out: that each boundary facet is a facet of one simplex, on the side that it says.

use crate::boxes::{APEX, Grid, Tree};
use crate::filter::{Interval, Intervals};
use crate::int::Int;
use crate::limits::Work;
use crate::meets::only_in_common;
use crate::refusal::{Checked, Place, Stop};
use crate::ring::{Element, Exact, Ring, Vector, each};
use crate::row::{Corner, Row, Shape};
use crate::vertices::Vertices;
use num_bigint::BigInt;
use std::cmp::Ordering;
use std::mem::replace;

/// A boundary facet. With an inner point before them, the corners have a positive orientation.
type Corners = [Corner; 3];

/// For each ridge of a facet, the other boundary facets that have it, up to the lattice: none, one
/// (`Some(Some(facet))`) or more. The k-th ridge is the one without the k-th corner.
type Across = [Option<Option<usize>>; 3];

/// Small integers, where they serve, and large ones.
pub(crate) type Sizes<const N: usize> = (Option<Exact<i64, N>>, Exact<BigInt, N>);

pub(crate) struct Region<const N: usize> {
    rings: Sizes<N>,
    intervals: Intervals,
    grid: Grid,
    is_plane: bool,
    facets: Vec<Corners>,
    /// The first facet of each class.
    bases: Tree,
}

impl<const N: usize> Region<N> {
    /// Checks X. There is a facet at least; they are as the format lists them.
    pub(crate) fn new(
        mut facets: Vec<Corners>,
        shape: Shape,
        vertices: &Vertices,
        rings: Sizes<N>,
    ) -> Checked<Region<N>> {
        let grid = Grid::new::<N>(shape, vertices, &rings.1.root)?;
        let is_plane = shape.dimension == 2;
        let mut boxes = Vec::new();
        for (number, facet) in facets.iter_mut().enumerate() {
            let [a, b, c] = *facet;
            *facet = [a, b, if is_plane { APEX } else { c }];
            boxes.push((grid.bounds(&*facet)?, number));
        }
        let bases = Tree::new(&mut boxes)?;
        let intervals = Intervals { root: rings.1.root.clone(), work: rings.1.work.clone() };
        let mut region = Region { rings, intervals, grid, is_plane, facets, bases };
        let across = region.check_meets(vertices)?;
        boxes.clear();
        for first in first_of_classes(&across)? {
            boxes.push((region.grid.bounds(region.facet(first)?)?, first));
        }
        region.bases = Tree::new(&mut boxes)?;
        Ok(region)
    }

    fn work(&self) -> &Work {
        self.rings.1.work()
    }

    fn facet(&self, number: usize) -> Checked<&Corners> {
        self.facets.get(number).ok_or(Stop::LARGER)
    }

    /// X for each pair of facets whose boxes meet.
    fn check_meets(&self, vertices: &Vertices) -> Checked<Vec<Across>> {
        let mut across = vec![[None; 3]; self.facets.len()];
        self.grid.each_near(&self.bases, &self.bases, self.work(), &mut |by, first, second| {
            // One of two opposite translations suffices.
            if (by, second) <= ([0; 3], first) {
                return Ok(());
            }
            let f = *self.facet(first)?;
            let g = self.facet(second)?.map(|corner| moved(corner, by));
            let number = |facet: usize| u64::try_from(facet).unwrap_or(u64::MAX);
            let place = Place::BoundaryPair(number(first.min(second)), number(first.max(second)));
            self.work().add(100);
            self.work().check(place)?;
            // The common corners first, in one order.
            let common = f.iter().filter(|corner| g.contains(corner)).count();
            let (mut f_sorted, mut g_sorted) = (f, g);
            f_sorted.sort_by_key(|corner| !g.contains(corner));
            g_sorted.sort_by_key(|corner| f_sorted.iter().position(|c| c == corner).unwrap_or(3));
            let is_right = self.meet(vertices, common, [&f_sorted, &g_sorted]);
            let is_right = is_right.map_err(|stop| stop.at(place))?;
            ensure!(is_right, BoundaryMeets, place);
            for (own, f, g, other) in [(first, &f, &g, second), (second, &g, &f, first)] {
                for (ridge, corner) in across.get_mut(own).into_iter().flatten().zip(f) {
                    if common == 2 && !g.contains(corner) {
                        *ridge = Some(ridge.is_none().then_some(other));
                    }
                }
            }
            Ok(())
        })?;
        Ok(across)
    }

    /// Whether two facets meet in the hull of their first common corners: by small integers, by
    /// intervals, or else by large integers.
    fn meet(&self, vertices: &Vertices, common: usize, facets: [&Corners; 2]) -> Checked<bool> {
        let small = || {
            let ring = self.rings.0.as_ref().ok_or(Stop::LARGER)?;
            let points = self.points(ring, vertices, facets)?;
            only_in_common(ring, common, &points).or_else(|_| {
                let interval = |x: &Element<i64, N>| Interval::of(&x.0, &self.intervals.root);
                let points = each(&points, |facet| each(facet, |point| each(point, interval)))?;
                only_in_common(&self.intervals, common, &points)
            })
        };
        let ring = &self.rings.1;
        small().or_else(|_| only_in_common(ring, common, &self.points(ring, vertices, facets)?))
    }

    /// The corners, seen from one of them. In the plane they get the height 1, and the apex is 0.
    fn points<T: Int>(
        &self,
        ring: &Exact<T, N>,
        vertices: &Vertices,
        facets: [&Corners; 2],
    ) -> Checked<[[Vector<Exact<T, N>>; 3]; 2]> {
        let base = facets.into_iter().flatten().find(|corner| **corner != APEX);
        let base = vertices.point(*base.ok_or(Stop::LARGER)?)?;
        each(&facets, |facet| {
            each(facet, |corner| {
                if *corner == APEX {
                    return Ok(Default::default());
                }
                let [x, y, z] = ring.difference(&base, &vertices.point(*corner)?)?;
                Ok([x, y, if self.is_plane { ring.integer(1)? } else { z }])
            })
        })
    }

    /// W for a row: no translate of its tile contains the point just outside of a base.
    pub(crate) fn check_row(&self, row: &Row, vertices: &Vertices, simplex: u64) -> Checked {
        let [a, b, c, d] = row.corners;
        let tile = [a, b, c, if self.is_plane { APEX } else { d }];
        let leaf = Tree::new(&mut [(self.grid.bounds(&tile)?, 0)])?;
        let place = Place::Simplex(simplex);
        self.grid.each_near(&self.bases, &leaf, self.work(), &mut |by, base, _| {
            let tile = tile.map(|corner| moved(corner, by));
            let facet = self.facet(base)?;
            self.work().add(300);
            let small = self.rings.0.as_ref().ok_or(Stop::LARGER);
            let is_covered = small
                .and_then(|ring| self.contains(ring, vertices, &tile, facet))
                .or_else(|_| self.contains(&self.rings.1, vertices, &tile, facet))
                .map_err(|stop| stop.at(place))?;
            ensure!(!is_covered, Covering, place, base);
            Ok(())
        })
    }

    /// Whether a tile contains the point just outside of a facet: the centroid m, moved outwards by ε (1, ε, ε²) or its
    /// negative, for small ε > 0. It is on the inner side of each facet of the tile: for the outer normal w and a
    /// corner o, w · (m - o) is negative, or it is zero and the point is moved inwards.
    fn contains<T: Int>(
        &self,
        ring: &Exact<T, N>,
        vertices: &Vertices,
        [a, b, c, d]: &[Corner; 4],
        facet: &Corners,
    ) -> Checked<bool> {
        // The vector to the apex is (0, 0, 1).
        let edge = |from: &Corner, to: &Corner| -> Checked<Vector<Exact<T, N>>> {
            if *to == APEX {
                return Ok([Element::default(), Element::default(), ring.integer(1)?]);
            }
            ring.difference(&vertices.point(*from)?, &vertices.point(*to)?)
        };
        let normal = |[o, p, q]: [&Corner; 3]| ring.cross(&edge(o, p)?, &edge(o, q)?);
        // The sign of w · (1, ε, ε²): that of the first entry of w that is not zero.
        let forwards = |[x, y, z]: &Vector<Exact<T, N>>| -> Checked<Ordering> {
            Ok(ring.sign(x).decided()?.then(ring.sign(y).decided()?).then(ring.sign(z).decided()?))
        };
        let is_backwards = forwards(&normal(facet.each_ref())?)? == Ordering::Less;
        let facets = if self.is_plane {
            &[[a, b, d], [b, c, d], [c, a, d]][..]
        } else {
            &[[b, c, d], [a, d, c], [a, b, d], [a, c, b]]
        };
        for &[o, p, q] in facets {
            let w = normal([o, p, q])?;
            let mut side = Element::default();
            for corner in facet.iter().filter(|corner| **corner != APEX) {
                side = ring.plus(&side, &ring.inner(&w, &edge(o, corner)?)?)?;
            }
            let turned = forwards(&w)?;
            let turned = if is_backwards { turned.reverse() } else { turned };
            if ring.sign(&side).decided()?.then(turned) != Ordering::Less {
                return Ok(false);
            }
        }
        Ok(true)
    }
}

/// The corner, moved by a lattice vector.
fn moved(corner: Corner, shift: [i32; 3]) -> Corner {
    if corner == APEX { APEX } else { corner.moved_by(Corner { vertex: 0, shift }) }
}

fn first_of_classes(across: &[Across]) -> Checked<Vec<usize>> {
    let mut is_seen = vec![false; across.len()];
    let mut firsts = Vec::new();
    for first in 0..across.len() {
        if is_seen.get(first) == Some(&false) {
            firsts.push(first);
        }
        let mut reached = vec![first];
        while let Some(facet) = reached.pop() {
            if !replace(is_seen.get_mut(facet).ok_or(Stop::LARGER)?, true) {
                reached.extend(across.get(facet).into_iter().flatten().copied().flatten().flatten());
            }
        }
    }
    Ok(firsts)
}
