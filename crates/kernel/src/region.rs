//! Regions: conditions X and W, which make the covering number N of the tiles at most 1.
//!
//! N(x) is the number of tiles that contain x, for a point x on no facet. It changes only at boundary
//! facets, by one, since each other facet has a mate on its other side.
//!
//! **X** (`boundary-meets`). Two boundary facets, up to the lattice, meet in the hull of their common corners.
//!
//! **W** (`covering`). N = 0 just outside of the first boundary facet of each class.
//! Two boundary facets belong to one class if they have a ridge that no third one has, up to the lattice.
//! (A ridge is an edge, in the plane a vertex.) By X nothing else of the boundary is near to this ridge.
//! So N has one value just outside of both facets.
//!
//! Then N ≤ 1: from a point follow any path that avoids ridges to the first boundary facet that it meets.
//! Before it N is constant, and there it is 0 or 1. The lattice may have any rank.
//!
//! Left out: that each boundary facet is a facet of one simplex, on the side that it says. See `front`.

use crate::boxes::{Item, Tree};
use crate::grid::{APEX, Grid, at, moved};
use crate::limits::Work;
use crate::questions::{Contains, Corners, OuterNormal, Pair, Points, decide};
use crate::refusal::{Checked, Place, Stop};
use crate::ring::Rings;
use crate::row::{Corner, Row, Shape};
use crate::vertices::Vertices;
use std::cmp::Ordering;
use std::mem::replace;
use std::rc::Rc;

/// The boundary facets that have a ridge in common with a facet, up to the lattice.
#[derive(Clone, Copy, Default)]
enum Across {
    #[default]
    None,
    One(usize),
    More,
}

/// The first boundary facet of a class.
struct Base {
    facet: u64,
    corners: Corners,
    /// The sign of w · (1, ε, ε²) for the outer normal w and small ε > 0.
    outwards: Ordering,
}

pub(crate) struct Region<const N: usize> {
    rings: Rc<Rings<N>>,
    work: Rc<Work>,
    grid: Grid,
    is_plane: bool,
    bases: Vec<Base>,
    /// The centroids of the bases.
    tree: Option<Tree>,
}

impl<const N: usize> Region<N> {
    /// Checks X, and prepares W. The facets are seen from outside, as the format lists them.
    pub(crate) fn new(
        facets: Vec<Corners>,
        shape: Shape,
        vertices: &Vertices,
        rings: &Rc<Rings<N>>,
        work: &Rc<Work>,
    ) -> Checked<Region<N>> {
        let grid = Grid::new::<N>(shape, vertices, &rings.intervals.root);
        let mut region = Region {
            rings: rings.clone(),
            work: work.clone(),
            grid: grid.map_err(|larger| Stop::from(larger).at_last(Place::Witness))?,
            is_plane: shape.dimension == 2,
            bases: Vec::new(),
            tree: None,
        };
        let (facets, tree) = region.at_home(facets)?;
        let mut across = vec![[Across::None; 3]; facets.len()];
        if let Some(tree) = tree {
            region.check_meets(&facets, &tree, vertices, &mut across)?;
        }
        region.choose_bases(&facets, &first_of_classes(&across)?, vertices)?;
        Ok(region)
    }

    /// Moves each facet near to the cell, so that few translations bring two of them together.
    fn at_home(&self, facets: Vec<Corners>) -> Checked<(Vec<Corners>, Option<Tree>)> {
        let (mut at_home, mut items) = (Vec::new(), Vec::new());
        for (number, [a, b, c]) in facets.into_iter().enumerate() {
            let facet = [a, b, if self.is_plane { APEX } else { c }];
            let home = self.grid.home(&self.grid.bounds(&facet)?)?;
            let facet = facet.map(|corner| moved(corner, home));
            let bounds = self.grid.bounds(&facet)?;
            items.push(Item { bounds, number });
            at_home.push(facet);
        }
        Ok((at_home, Tree::new(items)))
    }

    /// X for each pair of facets whose boxes meet, and for one of each two opposite translations.
    fn check_meets(
        &self,
        facets: &[Corners],
        tree: &Tree,
        vertices: &Vertices,
        across: &mut [[Across; 3]],
    ) -> Checked {
        let (work, grid) = (&*self.work, &self.grid);
        grid.each_translation(&tree.bounds, &tree.bounds, work, |by| {
            let mut visit = |f: usize, g: usize| {
                let own = *at(facets, f)?;
                let other = at(facets, g)?.map(|corner| moved(corner, by));
                let place = Place::BoundaryPair(count(f.min(g)), count(f.max(g)));
                let common = self.check_pair(own, other, vertices, place)?;
                if common == 2 {
                    mark(across.get_mut(f), own, other, g);
                    mark(across.get_mut(g), other, own, f);
                }
                Ok(())
            };
            match by.cmp(&[0; 3]) {
                Ordering::Less => Ok(()),
                Ordering::Equal => tree.each_pair(work, &mut visit),
                Ordering::Greater => {
                    tree.each_pair_with(tree, &grid.translation(by)?, work, &mut visit)
                }
            }
        })
    }

    /// Checks X for two facets, and returns the number of common corners; in the plane that plus one.
    fn check_pair(
        &self,
        f: Corners,
        g: Corners,
        vertices: &Vertices,
        place: Place,
    ) -> Checked<usize> {
        let (points, rings) = (Points { vertices }, &*self.rings);
        let (f, g, common) = common_first(f, g);
        let pair = Pair {
            points,
            rings,
            work: &self.work,
            common,
            f,
            g,
        };
        ensure!(decide(rings, &pair, place)?, BoundaryMeets, place);
        self.work.add(PAIR_PRICE);
        self.work.check(place)?;
        Ok(common)
    }

    fn choose_bases(
        &mut self,
        facets: &[Corners],
        firsts: &[usize],
        vertices: &Vertices,
    ) -> Checked {
        let mut items = Vec::new();
        for first in firsts {
            let corners = *at(facets, *first)?;
            let facet = count(*first);
            let points = Points { vertices };
            let normal = OuterNormal { points, corners };
            items.push(Item {
                bounds: self.grid.centroid(&corners)?,
                number: self.bases.len(),
            });
            self.bases.push(Base {
                facet,
                corners,
                outwards: decide(&self.rings, &normal, Place::Boundary(facet))?,
            });
        }
        self.tree = Tree::new(items);
        Ok(())
    }

    /// W for a row: no translate of its tile contains the point just outside of a base.
    pub(crate) fn check_row(&self, row: &Row, vertices: &Vertices, simplex: u64) -> Checked {
        let [a, b, c, d] = row.corners;
        let tile = [a, b, c, if self.is_plane { APEX } else { d }];
        let bounds = self.grid.bounds(&tile)?;
        let (work, grid) = (&*self.work, &self.grid);
        let Some(tree) = &self.tree else {
            return Ok(());
        };
        grid.each_translation(&tree.bounds, &bounds, work, |by| {
            let moved_bounds = bounds.plus(&grid.translation(by)?);
            tree.each_near(&moved_bounds, work, &mut |base| {
                let base = at(&self.bases, base)?;
                let question = Contains {
                    points: Points { vertices },
                    tile: tile.map(|corner| moved(corner, by)),
                    facet: base.corners,
                    outwards: base.outwards,
                };
                let place = Place::Simplex(simplex);
                let is_covered = decide(&self.rings, &question, place)?;
                ensure!(!is_covered, Covering, place, base.facet);
                Ok(())
            })
        })
    }
}

/// Units of work for a pair of facets, without products.
const PAIR_PRICE: u64 = 100;

fn count(number: usize) -> u64 {
    u64::try_from(number).unwrap_or(u64::MAX)
}

/// The corners in such an order that the common ones come first, and the number of these.
fn common_first(mut f: Corners, mut g: Corners) -> (Corners, Corners, usize) {
    let mut common = 0;
    for i in 0..f.len() {
        let corner = f.get(i).copied();
        if let Some(j) = g.iter().position(|other| Some(*other) == corner) {
            f.swap(common, i);
            g.swap(common, j);
            common += 1;
        }
    }
    (f, g, common)
}

/// The ridge that f has in common with g is the one without the corner that g does not have.
fn mark(across: Option<&mut [Across; 3]>, f: Corners, g: Corners, neighbour: usize) {
    for (ridge, corner) in across.into_iter().flatten().zip(f) {
        if !g.contains(&corner) {
            *ridge = match ridge {
                Across::None => Across::One(neighbour),
                _ => Across::More,
            };
        }
    }
}

/// The first facet of each class.
fn first_of_classes(across: &[[Across; 3]]) -> Checked<Vec<usize>> {
    let mut is_seen = vec![false; across.len()];
    let mut see = |facet: usize| {
        is_seen
            .get_mut(facet)
            .is_some_and(|seen| !replace(seen, true))
    };
    let mut firsts = Vec::new();
    for first in 0..across.len() {
        if see(first) {
            firsts.push(first);
            let mut reached = vec![first];
            while let Some(facet) = reached.pop() {
                for ridge in at(across, facet)? {
                    if let Across::One(neighbour) = ridge
                        && see(*neighbour)
                    {
                        reached.push(*neighbour);
                    }
                }
            }
        }
    }
    Ok(firsts)
}
