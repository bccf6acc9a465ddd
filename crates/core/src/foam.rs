//! Foams: the exact Voronoi cells of the vertices of a Delaunay triangulation of space, and their
//! isoperimetric quotient.
//!
//! The corners of the cell of a vertex are the circumcentres of the tetrahedra at it, and each edge at
//! it gives a face. This holds for weakly Delaunay triangulations only; the caller proves that.
//! The cells are those of the vertices as they are; no surface is relaxed.

use crate::delaunay::circumcenter;
use crate::tiling::{Corner, Tiling, VertexId};
use acutile_exact::geometry::linear;
use acutile_exact::number::Number;
use acutile_exact::number::enclosure::pi;
use malachite::Rational;
use std::collections::BTreeMap;

/// A point in basis coordinates.
pub type Point = [Number; 3];

/// The Voronoi cell of a vertex.
#[derive(Clone, Debug)]
pub struct Cell {
    /// The vertex, not shifted.
    pub centre: Point,
    /// One face for each Voronoi neighbour.
    pub faces: Vec<Face>,
}

/// The points that are as near to a neighbour as to the vertex, and to no other nearer.
#[derive(Clone, Debug)]
pub struct Face {
    /// The vertex on the other side, with its shift.
    pub neighbour: Corner<3>,
    /// Different points in cyclic order, at least three.
    pub corners: Vec<Point>,
}

/// The cell of each vertex; `None` if a tetrahedron is flat or an edge is not surrounded.
pub fn cells(tiling: &Tiling<3>) -> Option<Vec<Cell>> {
    let mut around: Vec<BTreeMap<Corner<3>, Vec<Wedge>>> =
        vec![BTreeMap::new(); tiling.vertices.len()];
    for simplex in tiling.simplices() {
        let points = std::array::from_fn::<Point, 4, _>(|k| tiling.position(&simplex[k]));
        let centre = circumcenter(&tiling.frame.gram, &points)?;
        for apex in 0..4 {
            let back = simplex[apex].shift.map(|s| -s);
            let seen: [Corner<3>; 4] = std::array::from_fn(|k| simplex[k].moved(back));
            let at = moved(&centre, back);
            for end in (0..4).filter(|&k| k != apex) {
                let mut others = (0..4).filter(|&k| k != apex && k != end);
                let pair = [others.next()?, others.next()?].map(|k| seen[k]);
                let wedges = around[simplex[apex].vertex.index()].entry(seen[end]);
                wedges.or_default().push((pair, at.clone()));
            }
        }
    }
    let cell = |(vertex, edges): (usize, BTreeMap<Corner<3>, Vec<Wedge>>)| {
        let mut faces = Vec::new();
        for (neighbour, wedges) in edges {
            let corners = polygon(wedges)?;
            if corners.len() > 2 {
                faces.push(Face { neighbour, corners });
            }
        }
        let centre = tiling.position(&Corner::of(VertexId::at(vertex)));
        Some(Cell { centre, faces })
    };
    around.into_iter().enumerate().map(cell).collect()
}

/// A tetrahedron at an edge: its two other corners, and its circumcentre.
type Wedge = ([Corner<3>; 2], Point);

fn moved(point: &Point, by: [i32; 3]) -> Point {
    std::array::from_fn(|k| &point[k] + &Number::from(Rational::from(by[k])))
}

/// The circumcentres in the order in which their tetrahedra surround the edge, equal neighbours once.
fn polygon(mut wedges: Vec<Wedge>) -> Option<Vec<Point>> {
    let ([first, mut open], centre) = wedges.pop()?;
    let mut corners = vec![centre];
    while !wedges.is_empty() {
        let next = wedges.iter().position(|(pair, _)| pair.contains(&open))?;
        let (pair, centre) = wedges.swap_remove(next);
        open = if pair[0] == open { pair[1] } else { pair[0] };
        if corners.last() != Some(&centre) {
            corners.push(centre);
        }
    }
    while corners.len() > 1 && corners.first() == corners.last() {
        corners.pop();
    }
    (open == first).then_some(corners)
}

impl Cell {
    /// The volume in units of the basis' parallelepiped.
    pub fn volume(&self) -> Number {
        let mut six = Number::zero();
        for face in &self.faces {
            let apex = |p: &Point| linear::subtract(p, &self.centre);
            // The cell is convex and has the vertex inside, so all pyramids count positive.
            let normal = face.doubled_normal();
            let height = linear::dot(&normal, &apex(&face.corners[0]));
            six = six
                + if height.sign().is_lt() {
                    -height
                } else {
                    height
                };
        }
        six * Number::from(Rational::from_unsigneds(1u8, 6))
    }

    /// Four times the squared areas of the faces, for a basis with the cofactors `cogram`.
    pub fn squared_areas(&self, cogram: &[[Number; 3]; 3]) -> Vec<Number> {
        let faces = self.faces.iter();
        faces
            .map(|face| linear::square(cogram, &face.doubled_normal()))
            .collect()
    }
}

impl Face {
    /// Twice the vector area as a covector: the sum of the cross products of sides with the first corner.
    fn doubled_normal(&self) -> Point {
        let from = |k: usize| linear::subtract(&self.corners[k], &self.corners[0]);
        let mut sum: Point = std::array::from_fn(|_| Number::zero());
        for k in 1..self.corners.len() - 1 {
            let term = linear::cross(&from(k), &from(k + 1));
            sum = std::array::from_fn(|i| &sum[i] + &term[i]);
        }
        sum
    }
}

/// Bounds of the isoperimetric quotient 36 π V² / A³ of a foam, with the mean volume V of a cell and the
/// mean area A of its surface. A ball has 1. `None` for no cell.
pub fn isoperimetric_quotient(
    gram: &[[Number; 3]; 3],
    cells: &[Cell],
) -> Option<(Rational, Rational)> {
    let width = Rational::from_unsigneds(1u64, 1_000_000_000_000);
    let cogram = linear::cofactors(gram);
    let count = Rational::from(cells.len());
    let volume = cells.iter().map(Cell::volume);
    let volume = volume.fold(Number::zero(), |sum, v| sum + v);
    let squared = &(&volume * &volume) * &linear::determinant(gram);
    let (low, high) = squared.enclosure(&width);
    let mut area = (Rational::from(0), Rational::from(0));
    for square in cells.iter().flat_map(|cell| cell.squared_areas(&cogram)) {
        let (l, h) = square.enclosure_of_root(&width);
        area = (area.0 + l, area.1 + h);
    }
    if area.0 <= 0 {
        return None;
    }
    // The means of V and A have the divisor n: n^3 / n^2 = n. Areas are halves of roots.
    let (pi_low, pi_high) = pi(&width);
    let factor = Rational::from(36 * 8) * count;
    let cube = |x: &Rational| x * x * x;
    Some((
        &factor * pi_low * low / cube(&area.1),
        &factor * pi_high * high / cube(&area.0),
    ))
}
