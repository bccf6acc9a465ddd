//! Blank edges of a square/triangle tiling, and colours of its tiles.
//!
//! A set of edges is *blank* if every triangle has one side in it, and every square two opposite sides.
//! Every vertex has two edges in it. Tiles then get colours ±1. Across a blank edge between two triangles
//! or two squares the colours are opposite. Across every other edge they are the same. Around a vertex the
//! colours close only if its two blank edges are of one kind. If that holds everywhere, the colours are
//! determined up to sign on the plane. They have the period of the cell doubled in each direction.
//!
//! A set with the period of a small multiple of the cell is searched for. Where there is none, the same
//! search over the tiles around one vertex, not periodic, may show that there is none at all. The smallest
//! such part is a wheel, six triangles at a vertex v ringed by squares. Consider a rim vertex p with the
//! spoke s. For each of the two rim edges, either it is blank, or the side at p of the square on it is.
//! These are two edges, so s is not blank. But v needs two blank spokes. The inflated tilings are made of
//! wheels.

use super::CatalogError;
use super::plane_tiling::{Cyclotomic, POWERS, PlaneTiling, TileCorner, sum};
use super::search::{Constraints, Found};
use std::collections::{BTreeSet, HashMap};

/// A tiling with blank edges and colours.
pub struct Marking {
    /// Over the lattice that the colours need.
    pub plane: PlaneTiling,
    /// The tiles around each vertex.
    pub stars: Vec<Vec<TileCorner>>,
    base: PlaneTiling,
    blank: BTreeSet<Edge>,
    colours: HashMap<Side, i64>,
}

/// An edge from a vertex in a direction less than 6.
type Edge = (Cyclotomic, usize);
/// A side of the tile on its left: index of the vertex where it begins, and direction.
type Side = (usize, usize);

/// Multiples of the cell that are tried.
const MULTIPLES: [[i64; 2]; 6] = [[1, 1], [2, 1], [1, 2], [2, 2], [3, 1], [1, 3]];
/// Multiples of the cell over which colours close.
const DOUBLED: [[i64; 2]; 4] = [[1, 1], [2, 1], [1, 2], [2, 2]];
/// The largest distance along edges at which stars around one vertex are examined.
const RADIUS_LIMIT: usize = 3;

/// Blank edges and colours for a tiling.
///
/// # Errors
/// Where it is not a tiling, or none were found: the part of the tiling that shows it.
pub fn marking(plane: &PlaneTiling) -> Result<Marking, CatalogError> {
    let stars = plane.stars()?;
    refute(plane, &stars)?;
    for multiple in MULTIPLES {
        let base = plane.repeated(multiple);
        let stars = base.stars()?;
        if let Some(blank) = blank_edges(&base, &stars) {
            return coloured(&base, &blank);
        }
    }
    Err(CatalogError::BlankEdgesNotFound)
}

/// Looks for a part of the tiling that has no blank edges.
fn refute(plane: &PlaneTiling, stars: &[Vec<TileCorner>]) -> Result<(), CatalogError> {
    let indices = plane.indices();
    for radius in 0..=RADIUS_LIMIT {
        for (vertex, &place) in plane.vertices.iter().enumerate() {
            let ball = ball(plane, &indices, stars, place, radius);
            let count = ball.len();
            if let (Found::None, _) = constraints(ball.into_iter(), |x| x).0.solve() {
                return Err(CatalogError::NoBlankEdges {
                    vertex,
                    tiles: vertex_symbol(&stars[vertex]),
                    radius,
                    stars: count,
                });
            }
        }
    }
    Ok(())
}

/// The tiles at a vertex by their numbers of sides, `3.3.4.3.4`.
fn vertex_symbol(star: &[TileCorner]) -> String {
    let sides = star
        .iter()
        .map(|tile| if tile.is_square() { "4" } else { "3" });
    sides.collect::<Vec<_>>().join(".")
}

type Star<'s> = (Cyclotomic, &'s [TileCorner]);

/// The vertices at most `radius` edges away, with their stars, nearest first.
fn ball<'s>(
    plane: &PlaneTiling,
    indices: &HashMap<Cyclotomic, usize>,
    stars: &'s [Vec<TileCorner>],
    center: Cyclotomic,
    radius: usize,
) -> Vec<Star<'s>> {
    let star = |place| &stars[indices[&plane.residue(place)]][..];
    let mut known = BTreeSet::from([center]);
    let mut found = vec![(center, star(center))];
    let mut first = 0;
    for _ in 0..radius {
        let last = found.len();
        for at in first..last {
            let (place, tiles) = found[at];
            for tile in tiles {
                let next = sum(place, POWERS[tile.direction]);
                if known.insert(next) {
                    found.push((next, star(next)));
                }
            }
        }
        first = last;
    }
    found
}

/// A set of blank edges with the period of the tiling.
fn blank_edges(plane: &PlaneTiling, stars: &[Vec<TileCorner>]) -> Option<BTreeSet<Edge>> {
    let indices = plane.indices();
    let center = *plane.vertices.first()?;
    // In order of the distance from one vertex, so that the search meets contradictions early.
    let mut all = ball(plane, &indices, stars, center, 0);
    let mut known = BTreeSet::from([plane.residue(center)]);
    let mut at = 0;
    while let Some(&(place, tiles)) = all.get(at) {
        at += 1;
        for tile in tiles {
            let next = plane.residue(sum(place, POWERS[tile.direction]));
            if known.insert(next) {
                all.push((next, &stars[indices[&next]]));
            }
        }
    }
    let (constraints, edges) = constraints(all.into_iter(), |x| plane.residue(x));
    match constraints.solve() {
        (Found::Some, values) => {
            let chosen = edges.into_iter().zip(values).filter(|(_, blank)| *blank);
            Some(chosen.map(|(edge, _)| edge).collect())
        }
        _ => None,
    }
}

/// The edge from a vertex in a direction; `residue` takes vertices that are the same to
/// one of them.
fn edge(place: Cyclotomic, k: usize, residue: impl Fn(Cyclotomic) -> Cyclotomic) -> Edge {
    if k < 6 {
        (residue(place), k)
    } else {
        (residue(sum(place, POWERS[k])), k - 6)
    }
}

/// The conditions on these vertices and the tiles around them, and the edges that their
/// variables stand for.
fn constraints<'s>(
    stars: impl Iterator<Item = Star<'s>>,
    residue: impl Fn(Cyclotomic) -> Cyclotomic,
) -> (Constraints, Vec<Edge>) {
    let mut constraints = Constraints::default();
    let mut numbers: HashMap<Edge, usize> = HashMap::new();
    let mut edges = Vec::new();
    for (place, tiles) in stars {
        let mut number = |place, k| {
            let edge = edge(place, k, &residue);
            *numbers.entry(edge).or_insert_with(|| {
                edges.push(edge);
                edges.len() - 1
            })
        };
        let spokes: Vec<(usize, bool)> = (0..tiles.len())
            .map(|i| {
                let before = &tiles[(i + tiles.len() - 1) % tiles.len()];
                let flips = before.is_square() == tiles[i].is_square();
                (number(place, tiles[i].direction), flips)
            })
            .collect();
        constraints.vertex(spokes);
        for tile in tiles {
            let turn = if tile.is_square() { 3 } else { 4 };
            let mut corner = place;
            let sides = (0..12 / turn)
                .map(|i| {
                    let k = (tile.direction + i * turn) % 12;
                    let side = number(corner, k);
                    corner = sum(corner, POWERS[k]);
                    side
                })
                .collect();
            constraints.tile(sides);
        }
    }
    (constraints, edges)
}

/// The colours over the smallest multiple of the cell on which they close.
fn coloured(base: &PlaneTiling, blank: &BTreeSet<Edge>) -> Result<Marking, CatalogError> {
    for multiple in DOUBLED {
        let plane = base.repeated(multiple);
        let mut marking = Marking {
            stars: plane.stars()?,
            plane,
            base: base.clone(),
            blank: blank.clone(),
            colours: HashMap::new(),
        };
        if let Some(colours) = colours(&marking) {
            marking.colours = colours;
            return Ok(marking);
        }
    }
    Err(CatalogError::BlankEdgesNotFound)
}

/// The colour of the tile on the left of each side; `None` if they do not close.
fn colours(marking: &Marking) -> Option<HashMap<Side, i64>> {
    let indices = marking.plane.indices();
    let squares: HashMap<Side, bool> = (0..)
        .zip(&marking.stars)
        .flat_map(|(i, star)| star.iter().map(move |t| ((i, t.direction), t.is_square())))
        .collect();
    let mut colours: HashMap<Side, i64> = HashMap::new();
    let mut stack = vec![((0, marking.stars.first()?.first()?.direction), 1)];
    while let Some((side, colour)) = stack.pop() {
        if let Some(&known) = colours.get(&side) {
            if known != colour {
                return None;
            }
            continue;
        }
        colours.insert(side, colour);
        let (index, k) = side;
        let place = marking.plane.vertices[index];
        let end = *indices.get(&marking.plane.residue(sum(place, POWERS[k])))?;
        let square = *squares.get(&side)?;
        let next = (end, (k + if square { 3 } else { 4 }) % 12);
        let mate = (end, (k + 6) % 12);
        let flips = marking.is_blank(place, k) && *squares.get(&mate)? == square;
        stack.extend([(next, colour), (mate, if flips { -colour } else { colour })]);
    }
    Some(colours)
}

impl Marking {
    /// Whether the edge from a vertex in a direction is blank.
    pub fn is_blank(&self, vertex: Cyclotomic, direction: usize) -> bool {
        self.blank
            .contains(&edge(vertex, direction, |x| self.base.residue(x)))
    }

    /// The colour of the tile on the left of the side that begins at a vertex.
    pub fn colour(&self, vertex: usize, direction: usize) -> Result<i64, CatalogError> {
        let colour = self.colours.get(&(vertex, direction)).copied();
        colour.ok_or(CatalogError::BlankEdgesNotFound)
    }
}
