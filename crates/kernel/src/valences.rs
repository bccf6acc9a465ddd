//! `TCP` for systems of patches: every edge has the valence 5 or 6 over every mosaic, and no
//! triangle has two edges that can have the valence 6.

use crate::corners::Angles;
use crate::domain::cycle;
use crate::joins::Join;
use crate::patch::Patch;
use crate::refusal::{Checked, Place, Stop};
use crate::row::Corner;
use crate::walls::{Polygon, Side, System, name};
use num_bigint::BigInt;
use std::collections::{BTreeMap, BTreeSet};

type Edge = Vec<Corner>;

/// The cells of a piece at an edge, the cells of joins at it inside of the tile, and the polygons
/// of pyramids that it is a side of.
#[derive(Clone, Copy, Default)]
struct Count {
    rows: u64,
    lateral: u64,
    flat: u64,
}

type Counts = BTreeMap<Edge, Count>;

/// The numbers of cells that the pieces on the left and on the right can have at an edge of a wall.
type Walls = BTreeMap<(BigInt, Edge), [BTreeSet<u64>; 2]>;

fn edge(ends: &[Corner]) -> Edge {
    name(ends).1
}

/// The pairs of some corners.
fn pairs(corners: &[Corner]) -> impl Iterator<Item = [Corner; 2]> {
    let pairs = corners.iter().enumerate();
    pairs.flat_map(|(k, one)| corners.iter().skip(k + 1).map(move |other| [*one, *other]))
}

fn counts(patch: &Patch) -> Counts {
    let mut counts = Counts::new();
    for ends in patch.rows.iter().flat_map(|row| pairs(row).collect::<Vec<_>>()) {
        counts.entry(edge(&ends)).or_default().rows += 1;
    }
    for pyramid in &patch.pyramids {
        for ends in cycle(&pyramid.polygon) {
            counts.entry(edge(&ends)).or_default().flat += 1;
        }
        // A join has two cells at each edge from an apex to a corner of the polygon.
        for corner in &pyramid.polygon {
            counts.entry(edge(&[pyramid.apex, *corner])).or_default().lateral += 2;
        }
    }
    counts
}

/// Whether edges of each patch can have the valence 6.
type Sixes = Vec<BTreeMap<Edge, bool>>;

pub(crate) fn check<const N: usize>(system: &System<N>, joins: &[Join<N>], angles: &Angles) -> Checked {
    for (patch, tile) in system.patches.iter().zip(0..) {
        // The axis of a join is in as many cells as the polygon has corners.
        for valence in patch.pyramids.iter().map(|pyramid| pyramid.polygon.len()) {
            ensure!(matches!(valence, 5 | 6), EdgeValence, Place::Tile(tile), valence);
        }
    }
    let counts: Vec<Counts> = system.patches.iter().map(counts).collect();
    let mut walls = Walls::new();
    for side in &system.sides {
        let patch = system.patches.get(side.patch).ok_or(Stop::LARGER)?;
        for (ends, count) in counts.get(side.patch).into_iter().flatten() {
            if patch.sides(ends) == [side.number] {
                for (is_right, there) in roles(system, side, ends) {
                    let found = walls.entry((side.label.clone(), there)).or_default();
                    found.get_mut(usize::from(is_right)).ok_or(Stop::LARGER)?.insert(count.rows);
                }
            }
        }
    }
    let mut sixes = Sixes::new();
    for (counts, tile) in counts.iter().zip(0..) {
        let mut six = BTreeMap::new();
        for (ends, count) in counts {
            let valences = valences(system, &walls, angles, tile, ends, *count)?;
            let is_allowed = valences.iter().all(|valence| matches!(valence, 5 | 6));
            ensure!(is_allowed, EdgeValence, Place::Tile(tile), valences.last().copied().unwrap_or_default());
            six.insert(ends.clone(), valences.contains(&6));
        }
        system.work().check(Place::Tile(tile))?;
        sixes.push(six);
    }
    check_triangles(system, joins, &sixes)
}

/// The edge in the wall, as the left side and as the right one where two meet.
fn roles<const N: usize>(system: &System<N>, side: &Side<N>, ends: &[Corner]) -> Vec<(bool, Edge)> {
    let seen = |is_right: bool| {
        let view = if is_right { &side.right } else { &side.left };
        let there: Vec<Corner> = ends.iter().map(|corner| view.corner(*corner)).collect();
        (is_right, edge(&there))
    };
    if system.rank == 1 { vec![seen(false), seen(true)] } else { vec![seen(side.number == 0)] }
}

/// All valences that an edge of a tile can have.
fn valences<const N: usize>(
    system: &System<N>,
    walls: &Walls,
    (angles, whole): &Angles,
    tile: usize,
    ends: &[Corner],
    count: Count,
) -> Checked<BTreeSet<u64>> {
    let sides = system.patches.get(tile).ok_or(Stop::LARGER)?.sides(ends);
    let here = |number: u32| system.sides.iter().find(|side| side.patch == tile && side.number == number);
    match sides.as_slice() {
        [] => Ok(BTreeSet::from([count.rows + count.lateral])),
        [number] => {
            let side = here(*number).ok_or(Stop::LARGER)?;
            let there = roles(system, side, ends).into_iter().next().ok_or(Stop::LARGER)?.1;
            let [left, right] = walls.get(&(side.label.clone(), there)).ok_or(Stop::LARGER)?;
            Ok(left.iter().flat_map(|x| right.iter().map(move |y| x + y + count.flat)).collect())
        }
        sides => {
            // The sides i - 1 and i have corner i in common. Its share of 6 cells is that of its
            // angle; a polygon counts one half.
            let angles = angles.get(tile).ok_or(Stop::LARGER)?;
            let is_first = |i: &&u32| {
                let after = if usize::try_from(**i).is_ok_and(|i| i + 1 == angles.len()) { 0 } else { **i + 1 };
                sides.contains(&after)
            };
            let before = sides.iter().find(is_first).ok_or(Stop::LARGER)?;
            let corner = usize::try_from(*before).map_or(0, |before| (before + 1) % angles.len());
            let angle = angles.get(corner).ok_or(Stop::LARGER)?;
            let is_share = (2 * count.rows + count.flat) * whole == 12 * angle;
            ensure!(is_share, EdgeValence, Place::Tile(tile), corner);
            Ok(BTreeSet::from([6]))
        }
    }
}

/// No triangle of a cell has two edges that can have the valence 6.
fn check_triangles<const N: usize>(system: &System<N>, joins: &[Join<N>], sixes: &Sixes) -> Checked {
    let is_six = |patch: usize, ends: &[Corner]| sixes.get(patch).and_then(|six| six.get(&edge(ends))).copied();
    let is_six = |patch, ends: &[Corner]| is_six(patch, ends).ok_or(Stop::LARGER);
    for (patch, tile) in system.patches.iter().zip(0..) {
        let lateral = patch.pyramids.iter().flat_map(|p| cycle(&p.polygon).map(|[x, y]| vec![x, y, p.apex]));
        for triangle in patch.facets().map(|(facet, _)| facet).chain(lateral) {
            let mut count = 0;
            for ends in pairs(&triangle) {
                count += u32::from(is_six(tile, &ends)?);
            }
            ensure!(count < 2, TriangleValence, Place::Tile(tile), u64::from(count));
        }
    }
    for join in joins {
        let [left, right] = [system.side(join.sides[0])?, system.side(join.sides[1])?];
        let mine = pyramid(&left.left.polygons, join.pyramids[0])?;
        let theirs = pyramid(&right.right.polygons, join.pyramids[1])?;
        let valence = mine.corners.len();
        for (corner, there) in mine.corners.iter().zip(&mine.there) {
            let beyond = theirs.corners.iter().zip(&theirs.there).find(|(_, other)| *other == there);
            let (beyond, _) = beyond.ok_or(Stop::LARGER)?;
            let count = u64::from(is_six(left.patch, &[mine.apex, *corner])?)
                + u64::from(is_six(right.patch, &[theirs.apex, *beyond])?)
                + u64::from(valence == 6);
            ensure!(count < 2, TriangleValence, left.place(), count);
        }
        system.work().check(left.place())?;
    }
    Ok(())
}

fn pyramid<K>(polygons: &BTreeMap<K, Polygon>, number: usize) -> Checked<&Polygon> {
    polygons.values().find(|polygon| polygon.pyramid == Some(number)).ok_or(Stop::LARGER)
}
