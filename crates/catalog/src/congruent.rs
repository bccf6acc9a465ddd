//! Tilings by congruent tetrahedra (section 2.2): Sommerville's four, Goldberg's three
//! families, and the cube in five or six parts.

use super::CatalogError;
use super::recipe::{cubic_tiling, fraction, rational_points};
use acutile_core::delaunay::{Ties, triangulate};
use acutile_core::tiling::{Corner, Frame, Tiling};
use acutile_exact::number::{Field, Number};
use std::collections::BTreeSet;

/// The orders of three axes.
const PERMUTATIONS: [[usize; 3]; 6] = [
    [0, 1, 2],
    [1, 2, 0],
    [2, 0, 1],
    [0, 2, 1],
    [2, 1, 0],
    [1, 0, 2],
];

/// A face of the cube [0, 2]^3: its centre and its corners in cyclic order.
fn cube_faces() -> Vec<([i64; 3], [[i64; 3]; 4])> {
    let mut faces = Vec::new();
    for axis in 0..3 {
        for level in [0, 2] {
            let at = |x, y| {
                let mut point = [level; 3];
                (point[(axis + 1) % 3], point[(axis + 2) % 3]) = (x, y);
                point
            };
            faces.push((at(1, 1), [at(0, 0), at(2, 0), at(2, 2), at(0, 2)]));
        }
    }
    faces
}

const CENTER: [i64; 3] = [1, 1, 1];

/// Sommerville I: the cube's centre, the centre of a face, an edge of that face.
pub fn sommerville_1() -> Tiling<3> {
    let mut tetrahedra = Vec::new();
    for (middle, corners) in cube_faces() {
        for k in 0..4 {
            tetrahedra.push([CENTER, middle, corners[k], corners[(k + 1) % 4]]);
        }
    }
    cubic_tiling(2, &tetrahedra)
}

/// Sommerville II: the Delaunay triangulation of the bcc lattice, in the basis of
/// (-1,1,1), (1,-1,1), (1,1,-1) with inner products 3 and -1.
pub fn sommerville_2() -> Result<Tiling<3>, CatalogError> {
    let bcc = rational_points([[3, -1, -1], [-1, 3, -1], [-1, -1, 3]], 1, &[[0, 0, 0]]);
    Ok(triangulate(&bcc, Ties::Refuse)?)
}

/// Sommerville III: the cube's centre and half a face. The face is cut along the diagonal from the corner
/// with the least coordinates, so that opposite faces are cut alike.
pub fn sommerville_3() -> Tiling<3> {
    let mut tetrahedra = Vec::new();
    for (_, [a, b, c, d]) in cube_faces() {
        tetrahedra.extend([[CENTER, a, b, c], [CENTER, a, c, d]]);
    }
    cubic_tiling(2, &tetrahedra)
}

/// Sommerville IV: II cut into four from its centroid.
pub fn sommerville_4() -> Result<Tiling<3>, CatalogError> {
    let second = sommerville_2()?;
    let mut vertices = second.vertices.to_numbers();
    let mut corners = Vec::new();
    for simplex in second.simplices() {
        let centroid = Corner::of(vertices.len() as u32);
        vertices.push(centroid_of(&second, simplex));
        for i in 0..4 {
            let mut part = simplex.to_vec();
            part[i] = centroid;
            corners.extend(part);
        }
    }
    Ok(Tiling {
        frame: second.frame,
        vertices: vertices.into(),
        corners,
    })
}

fn centroid_of(tiling: &Tiling<3>, simplex: &[Corner<3>]) -> [Number; 3] {
    let corners: Vec<_> = simplex
        .iter()
        .map(|corner| tiling.position(corner))
        .collect();
    std::array::from_fn(|k| {
        let sum = corners.iter().fold(Number::zero(), |sum, x| sum + &x[k]);
        &sum * &fraction(1, 4)
    })
}

/// The cube in five: four corners are cut off, and a regular tetrahedron is left. The
/// corners left have even coordinate sums in every cube of Z³, so neighbouring cubes
/// are mirror images and the period is 2.
pub fn cube_5() -> Tiling<3> {
    let mut tetrahedra = Vec::new();
    for cube in unit_cubes() {
        let place = |corner: [i64; 3]| std::array::from_fn(|k| cube[k] + corner[k]);
        let is_even = |corner: &[i64; 3]| place(*corner).iter().sum::<i64>() % 2 == 0;
        let (even, odd): (Vec<_>, Vec<_>) = unit_cubes().partition(is_even);
        tetrahedra.push([0, 1, 2, 3].map(|i| place(even[i])));
        for cut in odd {
            let neighbour = |axis: usize| {
                let mut corner = cut;
                corner[axis] = 1 - corner[axis];
                place(corner)
            };
            tetrahedra.push([place(cut), neighbour(0), neighbour(1), neighbour(2)]);
        }
    }
    cubic_tiling(2, &tetrahedra)
}

/// The corners of the unit cube; also the cubes of one period.
fn unit_cubes() -> impl Iterator<Item = [i64; 3]> {
    (0..8).map(|bits| [bits & 1, bits >> 1 & 1, bits >> 2 & 1])
}

/// The cube in six: the paths along the three axes in every order.
pub fn cube_6() -> Tiling<3> {
    path_tiling(Frame::cubic())
}

/// For basis vectors v_1, v_2, v_3 the tetrahedra 0, v_s1, v_s1 + v_s2, v_1 + v_2 + v_3
/// over all permutations s.
fn path_tiling(frame: Frame<3>) -> Tiling<3> {
    let corners = PERMUTATIONS.iter().flat_map(path).collect();
    let mut tiling = Tiling {
        frame,
        vertices: vec![[0; 3].map(|x| fraction(x, 1))].into(),
        corners,
    };
    tiling.orient();
    tiling
}

fn path(axes: &[usize; 3]) -> [Corner<3>; 4] {
    let mut path = [Corner::of(0); 4];
    for (k, &axis) in axes.iter().enumerate() {
        path[k + 1] = path[k];
        path[k + 1].shift[axis] += 1;
    }
    path
}

/// The frame of Goldberg's families with e = 1: v_i = (u_i, a) for three vectors u_i of
/// the plane at 120 degrees.
fn goldberg_frame(ratio: &Number) -> Frame<3> {
    let square = ratio * ratio;
    let field = square.field().cloned().unwrap_or_else(Field::rationals);
    let product = |i, j| {
        if i == j {
            fraction(1, 1)
        } else {
            fraction(-1, 2)
        }
    };
    let gram = std::array::from_fn(|i| std::array::from_fn(|j| &square + &product(i, j)));
    Frame::space(field, gram)
}

/// Goldberg's first family for the ratio a/e: sides 3a, b, b, b, c, c. The edge of length
/// 3a is v_1 + v_2 + v_3.
pub fn goldberg_1(ratio: &Number) -> Tiling<3> {
    path_tiling(goldberg_frame(ratio))
}

/// Goldberg's second family: the first, cut by the plane through the middle step of the path
/// and the midpoint of the edge of length 3a. All tetrahedra at such an edge cut it
/// in the same point and nothing else changes, so the parts fit.
pub fn goldberg_2(ratio: &Number) -> Tiling<3> {
    let middle = Corner::of(1);
    let mut corners = Vec::new();
    for axes in &PERMUTATIONS {
        let [start, first, second, end] = path(axes);
        corners.extend([start, first, second, middle]);
        corners.extend([middle, first, second, end]);
    }
    let vertices = vec![
        [0; 3].map(|x| fraction(x, 1)),
        [1; 3].map(|x| fraction(x, 2)),
    ];
    let mut tiling = Tiling {
        frame: goldberg_frame(ratio),
        vertices: vertices.into(),
        corners,
    };
    tiling.orient();
    tiling
}

/// Goldberg's third family: the first, cut by a plane. The plane contains the edge AB of length 3a and the
/// midpoint of the middle step CD of the path A, C, D, B.
///
/// *Face to face or not.* In the first family's tiling CD is the first or last step of other tetrahedra,
/// which do not cut it. So for every ratio the parts do not fit there. Suppose that the faces ACM, BCM and
/// ABC of the parts A, C, B, M are scalene and different. In any face-to-face tiling by such parts the
/// neighbour across each of these faces is the mirror image. So the tetrahedra around CM and around AC are
/// mirror images of one another in turn, and the angles there divide 180 degrees. These are the first
/// family's angles at CD and AC, for which (six tetrahedra at CD, two of each kind) CD + 2 AC = 180. So
/// they are 60 and 60, where (a/e)² = 1/8 and the first family is Sommerville's II, or 90 and 45, where
/// (a/e)² = 1/2 and it is the cube in six. In both cases reflections do generate a tiling (the chambers of
/// affine Weyl groups), in which every CD is cut. It is built for these ratios; for all others the first
/// arrangement is, which the checker refutes.
pub fn goldberg_3(ratio: &Number) -> Tiling<3> {
    let square = ratio * ratio;
    if square == fraction(1, 2) {
        cubic_tiling(
            4,
            &halves(&reflected([[0, 0, 0], [2, 0, 0], [2, 2, 0], [2, 2, 2]], 4)),
        )
    } else if square == fraction(1, 8) {
        cubic_tiling(
            8,
            &halves(&reflected([[0, 0, 0], [-2, 2, 2], [0, 0, 4], [2, 2, 2]], 8)),
        )
    } else {
        goldberg_3_unfitting(ratio)
    }
}

type Path = [[i64; 3]; 4];

/// The images of a tetrahedron under the reflections in its faces, one for each orbit of
/// `period` Z³.
fn reflected(chamber: Path, period: i64) -> Vec<Path> {
    let mut known = BTreeSet::new();
    let mut found = Vec::new();
    let mut stack = vec![chamber];
    while let Some(path) = stack.pop() {
        let center = |axis: usize| path.iter().map(|p| p[axis]).sum::<i64>();
        let orbit: [i64; 3] = std::array::from_fn(|k| center(k).rem_euclid(4 * period));
        if known.insert(orbit) {
            found.push(path);
            stack.extend((0..4).map(|corner| mirrored(path, corner)));
        }
    }
    found
}

/// The mirror image of a tetrahedron in the face opposite to a corner. The chambers above
/// stay integral.
fn mirrored(mut path: Path, corner: usize) -> Path {
    let [p, q, r] = [1, 2, 3].map(|k| path[(corner + k) % 4]);
    let minus = |x: [i64; 3], y: [i64; 3]| -> [i64; 3] { std::array::from_fn(|k| x[k] - y[k]) };
    let dot = |x: [i64; 3], y: [i64; 3]| -> i64 { (0..3).map(|k| x[k] * y[k]).sum() };
    let (u, v) = (minus(q, p), minus(r, p));
    let normal: [i64; 3] = std::array::from_fn(|k| {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        u[i] * v[j] - u[j] * v[i]
    });
    let height = 2 * dot(normal, minus(path[corner], p));
    for k in 0..3 {
        path[corner][k] -= height * normal[k] / dot(normal, normal);
    }
    path
}

/// A, C, D, B cut into A, C, M, B and A, M, D, B with M the midpoint of CD.
fn halves(paths: &[Path]) -> Vec<Path> {
    paths
        .iter()
        .flat_map(|&[a, c, d, b]| {
            let m = std::array::from_fn(|k| (c[k] + d[k]) / 2);
            [[a, c, m, b], [a, m, d, b]]
        })
        .collect()
}

/// The tetrahedra of the first family, all cut, where they are.
fn goldberg_3_unfitting(ratio: &Number) -> Tiling<3> {
    let mut vertices = vec![[0; 3].map(|x| fraction(x, 1))];
    let mut corners = Vec::new();
    for (axis, middle) in (1..).zip(0..3) {
        let mut point = [0; 3].map(|x| fraction(x, 1));
        point[middle] = fraction(1, 2);
        vertices.push(point);
        for axes in PERMUTATIONS.iter().filter(|axes| axes[1] == middle) {
            let [start, first, second, end] = path(axes);
            let cut = Corner::of(axis).moved(first.shift);
            corners.extend([start, first, cut, end, start, cut, second, end]);
        }
    }
    let mut tiling = Tiling {
        frame: goldberg_frame(ratio),
        vertices: vertices.into(),
        corners,
    };
    tiling.orient();
    tiling
}
