//! Cubes cut into tetrahedra (paper, section 2.2).

use super::CatalogError;
use crate::number::{Field, Number};
use crate::tiling::{AnyTiling, Frame, Tiling};
use malachite::Rational;

/// A point with integer Cartesian coordinates.
type Point = [i64; 3];

/// The unit cube cut along the paths from (0,0,0) to (1,1,1): one for each order
/// of the axes. All cubes alike.
pub fn cube_6() -> Result<AnyTiling, CatalogError> {
    let orders = [
        [0, 1, 2],
        [0, 2, 1],
        [1, 0, 2],
        [1, 2, 0],
        [2, 0, 1],
        [2, 1, 0],
    ];
    let path = |axes: [usize; 3]| {
        let mut point = [0; 3];
        let mut path = vec![point];
        for axis in axes {
            point[axis] = 1;
            path.push(point);
        }
        path.into_iter().map(|p| p.map(integer)).collect()
    };
    Ok(AnyTiling::Space(Tiling::from_positions(
        Frame::cubic(),
        &orders.map(path),
    )))
}

/// The unit cubes with integer corners, each cut into the regular tetrahedron of its
/// corners with even coordinate sum, and the four corners that this leaves. So the
/// diagonals of a common face agree. The lattice is that of the even points, with
/// the basis (0,1,1), (1,0,1), (1,1,0), and has two cubes in a cell.
pub fn cube_5() -> Result<AnyTiling, CatalogError> {
    let cubes = [[0, 0, 0], [1, 0, 0]];
    let tetrahedra: Vec<Vec<[Number; 3]>> = cubes
        .into_iter()
        .flat_map(five_tetrahedra)
        .map(|corners| corners.into_iter().map(in_even_basis).collect())
        .collect();
    let field = Field::rationals();
    let gram =
        std::array::from_fn(|i| std::array::from_fn(|j| field.integer(if i == j { 2 } else { 1 })));
    Ok(AnyTiling::Space(Tiling::from_positions(
        Frame::space(field, gram),
        &tetrahedra,
    )))
}

fn five_tetrahedra(cube: Point) -> Vec<Vec<Point>> {
    let corners = (0..8).map(|bits| add(cube, [bits & 1, bits >> 1 & 1, bits >> 2]));
    let (even, odd): (Vec<Point>, Vec<Point>) =
        corners.partition(|corner| corner.iter().sum::<i64>() % 2 == 0);
    let neighbours = |corner: Point| even.iter().copied().filter(move |&e| is_edge(corner, e));
    let cut_off = odd
        .iter()
        .map(|&corner| neighbours(corner).chain([corner]).collect());
    cut_off.chain([even.clone()]).collect()
}

fn add(p: Point, q: Point) -> Point {
    std::array::from_fn(|k| p[k] + q[k])
}

fn is_edge(p: Point, q: Point) -> bool {
    (0..3).map(|k| (p[k] - q[k]).pow(2)).sum::<i64>() == 1
}

/// The coordinates f of a point with respect to (0,1,1), (1,0,1), (1,1,0):
/// f_1 = (-x + y + z) / 2 and so on.
fn in_even_basis(point: Point) -> [Number; 3] {
    let sum: i64 = point.iter().sum();
    point.map(|x| Number::from(Rational::from_signeds(sum - 2 * x, 2)))
}

fn integer(n: i64) -> Number {
    Number::from(Rational::from(n))
}
