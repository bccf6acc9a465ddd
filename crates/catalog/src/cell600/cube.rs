//! The cube in 2,715 acute tetrahedra, and the solids that mirror images of a piece fill.
//!
//! Alternate corners of a cube span a regular tetrahedron, and four corners of the cube remain.
//! Each of the five parts is one piece of 543. Where the middle meets a corner of the cube,
//! the two have the same bumps. The other faces are flat, so mirror images of the cube meet face to face.

use super::piece::{Point, Symmetry, UNIT, cells, tetrahedra};
use super::tables::{CORNER, CUBE_CORNER, CUBE_MIDDLE, REGULAR};
use crate::CatalogError;
use crate::limits::CUBE_LIMIT;
use crate::recipe::fraction;
use acutile_core::tiling::{Domain, Frame, Polytope, Tiling};
use acutile_exact::number::{Field, Number};

type Built = Result<Tiling<3>, CatalogError>;

/// Alternate corners of the cube with the corners ±1.
const ALTERNATE: [[i64; 3]; 4] = [[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]];
const TRIANGLES: [[usize; 3]; 4] = [[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]];

/// The regular tetrahedron.
pub fn tetrahedron_543() -> Built {
    let tetrahedra = tetrahedra(&cells()?, REGULAR, Symmetry::All, ALTERNATE)?;
    let hull = polytope(&ALTERNATE, &TRIANGLES.map(|face| face.to_vec()));
    Ok(solid(hull, &tetrahedra, UNIT))
}

/// The octahedron: the corner of a cube and its mirror images in the planes of coordinates.
pub fn octahedron_4344() -> Built {
    let corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]];
    let corner = tetrahedra(&cells()?, CORNER, Symmetry::KeepFirst, corners)?;
    let mut all = Vec::new();
    let mut faces = Vec::new();
    for signs in 0..8_usize {
        let sign = |axis: usize| if signs >> axis & 1 == 0 { 1 } else { -1 };
        let image = |point: Point| [0, 1, 2].map(|axis| sign(axis) * point[axis]);
        all.extend(corner.iter().map(|points| points.map(image)));
        faces.push((0..3).map(|axis| 2 * axis + (signs >> axis & 1)).collect());
    }
    let ends = [
        [1, 0, 0],
        [-1, 0, 0],
        [0, 1, 0],
        [0, -1, 0],
        [0, 0, 1],
        [0, 0, -1],
    ];
    Ok(solid(polytope(&ends, &faces), &all, UNIT))
}

/// The cube.
pub fn cube_2715() -> Built {
    boxed([1, 1, 1])
}

/// A box with these integer sides, `2,1,1`: mirror images of the cube.
pub fn from_word(word: &str) -> Built {
    let refused = || CatalogError::Sides(word.to_owned());
    let sides: Result<Vec<i64>, _> = word.split(',').map(str::parse).collect();
    let sides: [i64; 3] = sides
        .ok()
        .and_then(|sides| sides.try_into().ok())
        .ok_or_else(refused)?;
    let is_possible = |side: &i64| (1..=CUBE_LIMIT).contains(side);
    if !sides.iter().all(is_possible) || sides.iter().product::<i64>() > CUBE_LIMIT {
        return Err(refused());
    }
    boxed(sides)
}

fn boxed(sides: [i64; 3]) -> Built {
    let cube = cube()?;
    let mut all = Vec::new();
    for x in 0..sides[0] {
        for y in 0..sides[1] {
            for z in 0..sides[2] {
                all.extend(image(&cube, [x, y, z]));
            }
        }
    }
    let corners: Vec<Point> = (0..8)
        .map(|code| [0, 1, 2].map(|axis| (code >> axis & 1) * sides[axis]))
        .collect();
    let faces = [
        [0, 1, 3, 2],
        [4, 5, 7, 6],
        [0, 1, 5, 4],
        [2, 3, 7, 6],
        [0, 2, 6, 4],
        [1, 3, 7, 5],
    ];
    let hull = polytope(&corners, &faces.map(|face| face.to_vec()));
    Ok(solid(hull, &all, 2 * UNIT))
}

/// The infinite prism over a square: the cube and its mirror image, over and over.
pub fn square_prism() -> Built {
    let cube = cube()?;
    let [lower, upper] = [0, 1].map(|z| image(&cube, [0, 0, z]));
    let square = [[0, 0], [1, 0], [1, 1], [0, 1]].map(|p| p.map(|x| fraction(x, 1)).to_vec());
    let gram = [[4, 0, 0], [0, 1, 0], [0, 0, 1]].map(|row| row.map(|x| fraction(x, 1)));
    let frame = Frame::space(Field::rationals(), gram)
        .with_domain(Domain::Prism(Polytope::polygon(square.to_vec())));
    let position = |[x, y, z]: Point| {
        [
            fraction(z, 4 * UNIT),
            fraction(x, 2 * UNIT),
            fraction(y, 2 * UNIT),
        ]
    };
    Ok(tiling(frame, lower.chain(upper), position))
}

/// Space: all mirror images of the cube. Two of them repeat, since half turns about the axes keep the
/// cube: the lattice has the basis (0,1,1), (1,0,1), (1,1,0).
pub fn cube_space() -> Built {
    let cube = cube()?;
    let [first, second] = [0, 1].map(|x| image(&cube, [x, 0, 0]));
    let gram = [[2, 1, 1], [1, 2, 1], [1, 1, 2]].map(|row| row.map(|x| fraction(x, 1)));
    let position =
        |[x, y, z]: Point| [y + z - x, x + z - y, x + y - z].map(|sum| fraction(sum, 4 * UNIT));
    let frame = Frame::space(Field::rationals(), gram);
    Ok(tiling(frame, first.chain(second), position))
}

/// The cube with the corners ±1.
fn cube() -> Result<Vec<[Point; 4]>, CatalogError> {
    let cells = cells()?;
    let mut all = tetrahedra(&cells, CUBE_MIDDLE, Symmetry::All, ALTERNATE)?;
    for missing in 0..4 {
        let mut corners = ALTERNATE;
        corners[missing] = ALTERNATE[missing].map(|x| -x);
        corners.swap(0, missing);
        all.extend(tetrahedra(
            &cells,
            CUBE_CORNER,
            Symmetry::KeepFirst,
            corners,
        )?);
    }
    Ok(all)
}

/// The image of the cube in unit cube number (x, y, z), in numerators over 2 [`UNIT`]: reflected in
/// the axes with an odd number.
fn image(cube: &[[Point; 4]], place: [i64; 3]) -> impl Iterator<Item = [Point; 4]> {
    let image = move |point: Point| {
        [0, 1, 2].map(|axis| {
            let sign = if place[axis] % 2 == 0 { 1 } else { -1 };
            (2 * place[axis] + 1) * UNIT + sign * point[axis]
        })
    };
    cube.iter().map(move |points| points.map(image))
}

fn polytope(vertices: &[Point], faces: &[Vec<usize>]) -> Polytope {
    let vertices = vertices
        .iter()
        .map(|point| point.map(|x| fraction(x, 1)).to_vec());
    Polytope {
        vertices: vertices.collect(),
        faces: faces.to_vec(),
    }
}

fn solid(hull: Polytope, tetrahedra: &[[Point; 4]], unit: i64) -> Tiling<3> {
    let frame = Frame::cubic().with_domain(Domain::Solid(hull));
    tiling(frame, tetrahedra.iter().copied(), |point| {
        point.map(|x| fraction(x, unit))
    })
}

fn tiling(
    frame: Frame<3>,
    tetrahedra: impl Iterator<Item = [Point; 4]>,
    position: impl Fn(Point) -> [Number; 3],
) -> Tiling<3> {
    let tetrahedra: Vec<Vec<_>> = tetrahedra
        .map(|points| points.map(&position).to_vec())
        .collect();
    Tiling::from_positions(frame, &tetrahedra)
}
