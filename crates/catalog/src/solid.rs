//! Single tetrahedra (Table 1), and the two of section 3.2 that are acute and not Delaunay.

use super::recipe::fraction;
use acutile_core::tiling::{Domain, Frame, Polytope, Tiling};
use acutile_exact::number::{Field, Number};

/// The regular tetrahedron: edges of the length sqrt 2 at 60 degrees from one corner.
pub fn regular() -> Tiling<3> {
    corner_of(Frame::space(
        Field::rationals(),
        [[2, 1, 1], [1, 2, 1], [1, 1, 2]].map(|row| row.map(|x| fraction(x, 1))),
    ))
}

/// The corner of a cube: three edges at right angles.
pub fn cube_corner() -> Tiling<3> {
    corner_of(Frame::cubic())
}

/// The tetrahedron of the origin and the basis.
fn corner_of(frame: Frame<3>) -> Tiling<3> {
    let points = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]].map(|p| p.map(|x| fraction(x, 1)));
    let faces = [[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]];
    solid(frame, &points, &faces, &[[0, 1, 2, 3]])
}

/// a = -(epsilon, epsilon, epsilon), b, c, d the unit vectors, e = (2/3 + epsilon)(1, 1, 1):
/// abcd and bcde.
///
/// The line ae meets the triangle bcd in its centroid, between a and e, for every epsilon > -1/3. So none
/// of the five points is in the hull of the others, and the hull is the bipyramid: convex without further
/// condition. Not Delaunay: the sphere abcd meets the line again at (1 + epsilon)/(1 + 3 epsilon) on all
/// axes. That is beyond e exactly if 9 epsilon² + 6 epsilon < 1, so epsilon < (sqrt 2 - 1)/3.
pub fn two_corners(epsilon: &Number) -> Tiling<3> {
    let diagonal = |x: Number| [x.clone(), x.clone(), x];
    let unit = |axis| std::array::from_fn(|k| fraction(i64::from(k == axis), 1));
    let [a, b, c, d, e] = [
        diagonal(&Number::zero() - epsilon),
        unit(0),
        unit(1),
        unit(2),
        diagonal(&fraction(2, 3) + epsilon),
    ];
    let field = epsilon.field().cloned().unwrap_or_else(Field::rationals);
    let faces = [
        [0, 1, 2],
        [0, 2, 3],
        [0, 1, 3],
        [4, 1, 2],
        [4, 2, 3],
        [4, 1, 3],
    ];
    solid(
        Frame {
            field,
            ..Frame::cubic()
        },
        &[a, b, c, d, e],
        &faces,
        &[[0, 1, 2, 3], [1, 2, 3, 4]],
    )
}

/// A polyhedron cut into tetrahedra without further vertices.
fn solid(
    frame: Frame<3>,
    points: &[[Number; 3]],
    faces: &[[usize; 3]],
    tetrahedra: &[[usize; 4]],
) -> Tiling<3> {
    let polytope = Polytope {
        vertices: points.iter().map(|point| point.to_vec()).collect(),
        faces: faces.iter().map(|face| face.to_vec()).collect(),
    };
    let tetrahedra: Vec<Vec<_>> = tetrahedra
        .iter()
        .map(|corners| corners.iter().map(|&k| points[k].clone()).collect())
        .collect();
    Tiling::from_positions(frame.with_domain(Domain::Solid(polytope)), &tetrahedra)
}
