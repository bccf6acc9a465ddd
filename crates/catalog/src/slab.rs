//! Section 4.3: an acute triangulation of a slab, in eight steps, with gamma = 1.
//!
//! Every step says which vertices a new tetrahedron has, so the tetrahedra are listed by
//! steps and no Delaunay triangulation is computed. Places in the plane are counted in sixths
//! of two sides of the grid, heights in tenths.

use super::recipe::fraction;
use acutile_core::tiling::{Domain, Frame, Polytope, Tiling};
use acutile_exact::geometry::RingElement;
use acutile_exact::number::{Field, Number};
use acutile_exact::polynomial::Polynomial;

/// A place in the plane.
type Place = [i64; 2];
/// A place and a height.
type Point = (Place, i64);

/// The height of the slab, in tenths.
const HEIGHT: i64 = 142;
/// The heights of the base plane and of the layers above it.
const BASE: i64 = 0;
const APEX: i64 = 40;
const BUMP: i64 = 46;
const MIDDLE: i64 = 71;
/// In step 8: bumps equal to the holes, 2 (7.1 - 4.6) + 4.6.
const UPPER_BUMP: i64 = 2 * (MIDDLE - BUMP) + BUMP;
/// The mirror image of a layer.
const UPPER_APEX: i64 = HEIGHT - APEX;

/// A triangle of the grid: its corners and its centre.
const TRIANGLES: [([Place; 3], Place); 2] = [
    ([[0, 0], [6, 0], [0, 6]], [2, 2]),
    ([[6, 0], [6, 6], [0, 6]], [4, 4]),
];

/// An edge of the grid: its ends, and the centres of the triangles on its sides.
const EDGES: [([Place; 2], [Place; 2]); 3] = [
    ([[0, 0], [6, 0]], [[2, 2], [4, -2]]),
    ([[0, 0], [0, 6]], [[2, 2], [-2, 4]]),
    ([[6, 0], [0, 6]], [[2, 2], [4, 4]]),
];

/// The numbers of a slab.
pub struct Layers {
    /// The squared side of the grid.
    pub square: Number,
    /// The heights of the layers above the base plane: steps 2, 4 and 5.
    pub apex: Number,
    pub bump: Number,
    pub middle: Number,
}

/// The slab: 56 tetrahedra in a cell.
pub fn slab() -> Tiling<3> {
    of_layers(&Layers {
        square: fraction(36, 1),
        apex: fraction(APEX, 10),
        bump: fraction(BUMP, 10),
        middle: fraction(MIDDLE, 10),
    })
}

/// The slab with other numbers.
pub fn of_layers(layers: &Layers) -> Tiling<3> {
    let top = &layers.middle + &layers.middle;
    let bounds = Polytope::interval(fraction(0, 1), top.clone());
    let height = |tenths: i64| match tenths {
        BASE => fraction(0, 1),
        APEX => layers.apex.clone(),
        BUMP => layers.bump.clone(),
        MIDDLE => layers.middle.clone(),
        UPPER_BUMP => &top - &layers.bump,
        UPPER_APEX => &top - &layers.apex,
        _ => top.clone(),
    };
    tiling(&layers.square, fraction(1, 1), height, Domain::Slab(bounds))
}

/// The slab repeated to fill space: its boundary planes carry the same grid.
pub fn slab_stack() -> Tiling<3> {
    let period = fraction(HEIGHT * HEIGHT, 100);
    let height = |tenths: i64| fraction(tenths, HEIGHT);
    tiling(&fraction(36, 1), period, height, Domain::Space)
}

/// A height of the slab as a polynomial in the heights z1, z2, z3 of its layers; `None` if it is
/// the height of no vertex.
pub fn height(value: &Number, [z1, z2, z3]: [&Polynomial; 3]) -> Option<Polynomial> {
    let top = z3.plus(z3);
    let heights = [
        (BASE, z3.integer(0)),
        (APEX, z1.clone()),
        (BUMP, z2.clone()),
        (MIDDLE, z3.clone()),
        (UPPER_BUMP, top.minus(z2)),
        (HEIGHT - APEX, top.minus(z1)),
        (HEIGHT, top),
    ];
    let known = |(n, _): &(i64, Polynomial)| *value == fraction(*n, 10);
    heights.into_iter().find(known).map(|(_, height)| height)
}

/// The slab with the height of each layer in units whose square is `unit`.
fn tiling(
    square: &Number,
    unit: Number,
    height: impl Fn(i64) -> Number,
    domain: Domain,
) -> Tiling<3> {
    let zero = Number::zero;
    // Step 1: a grid of equilateral triangles.
    let half = square * &fraction(1, 2);
    let gram = [
        [square.clone(), half.clone(), zero()],
        [half, square.clone(), zero()],
        [zero(), zero(), unit],
    ];
    let position = |([x, y], tenths): Point| [fraction(x, 6), fraction(y, 6), height(tenths)];
    let frame = Frame::space(Field::rationals(), gram).with_domain(domain);
    let tetrahedra: Vec<Vec<_>> = tetrahedra()
        .into_iter()
        .map(|corners| corners.map(position).to_vec())
        .collect();
    Tiling::from_positions(frame, &tetrahedra)
}

/// All eight steps, then the first seven in reverse order, upside down.
fn tetrahedra() -> Vec<[Point; 4]> {
    let lower = first_seven_steps();
    let mirrored = |(place, height): Point| (place, HEIGHT - height);
    let upper = lower.iter().rev().map(|corners| corners.map(mirrored));
    lower
        .iter()
        .copied()
        .chain(step_eight())
        .chain(upper)
        .collect()
}

fn first_seven_steps() -> Vec<[Point; 4]> {
    let mut tetrahedra = Vec::new();
    // Step 2: a near-regular tetrahedron of height 4 over each triangle.
    for ([a, b, c], center) in TRIANGLES {
        tetrahedra.push([(a, BASE), (b, BASE), (c, BASE), (center, APEX)]);
    }
    // Step 3: one in the gap between each pair of adjacent tetrahedra.
    for ([a, b], [m, n]) in EDGES {
        tetrahedra.push([(a, BASE), (b, BASE), (m, APEX), (n, APEX)]);
    }
    // Step 4: six in each dimple: a vertex of the plane, two vertices at height 4, and a
    // new one at height 4.6 over the first.
    for (ends, [m, n]) in EDGES {
        tetrahedra.extend(ends.map(|a| [(a, BASE), (m, APEX), (n, APEX), (a, BUMP)]));
    }
    // Step 5: a vertex at height 7.1 over the middle of the edge between two bumps. It
    // spans with the edge a vertical triangle, and that with the two bumps two tetrahedra.
    for (ends @ [a, b], [m, n]) in EDGES {
        let top = (middle(a, b), MIDDLE);
        tetrahedra.extend(ends.map(|bump| [top, (m, APEX), (n, APEX), (bump, BUMP)]));
    }
    // Step 6: one between each pair of adjacent (diamond-shaped) bumps.
    for (corners, center) in TRIANGLES {
        tetrahedra.extend(
            at_corners(corners)
                .map(|(corner, [left, right])| [left, right, (center, APEX), (corner, BUMP)]),
        );
    }
    // Step 7: fill each tetrahedral hole.
    for ([a, b, c], center) in TRIANGLES {
        let [p, q, r] = [middle(a, b), middle(b, c), middle(c, a)].map(|m| (m, MIDDLE));
        tetrahedra.push([(center, APEX), p, q, r]);
    }
    tetrahedra
}

/// Step 8: six in each hexagonal hole, which make it a bump.
fn step_eight() -> Vec<[Point; 4]> {
    TRIANGLES
        .into_iter()
        .flat_map(|(corners, _)| at_corners(corners))
        .map(|(corner, [left, right])| [left, right, (corner, BUMP), (corner, UPPER_BUMP)])
        .collect()
}

/// For each corner of a triangle the vertices of step 5 over its two sides there.
fn at_corners([a, b, c]: [Place; 3]) -> [(Place, [Point; 2]); 3] {
    [(a, b, c), (b, c, a), (c, a, b)]
        .map(|(p, q, r)| (p, [(middle(p, q), MIDDLE), (middle(p, r), MIDDLE)]))
}

fn middle(a: Place, b: Place) -> Place {
    [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2]
}
