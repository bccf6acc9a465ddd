//! Orientation and the six products of normals of each tetrahedron in doubles, from doubles, with no error
//! bound. This is the work of an unproved check.

use acutile_core::tiling::Tiling;
use acutile_exact::geometry::{Simplex, linear};
use acutile_exact::number::Number;

/// The pass over these tetrahedra; returns how many are acute.
pub fn pass(tiling: &Tiling<3>) -> impl Fn() -> usize {
    let vertices: Vec<[f64; 3]> = tiling
        .vertices
        .iter()
        .map(|v| v.each_ref().map(Number::approximate))
        .collect();
    let gram = tiling
        .frame
        .gram
        .each_ref()
        .map(|row| row.each_ref().map(Number::approximate));
    let cogram = linear::cofactors(&gram);
    move || count_acute(tiling, &vertices, &cogram)
}

fn count_acute(tiling: &Tiling<3>, vertices: &[[f64; 3]], cogram: &[[f64; 3]; 3]) -> usize {
    let mut acute = 0;
    for corners in tiling.simplices() {
        let mut points = [[0.0; 3]; 4];
        for (point, corner) in points.iter_mut().zip(corners) {
            let vertex = &vertices[corner.vertex.index()];
            for k in 0..3 {
                point[k] = vertex[k] + f64::from(corner.shift[k]);
            }
        }
        let edges = [1, 2, 3].map(|k| linear::subtract(&points[k], &points[0]));
        let simplex = Simplex::from_edges(edges);
        acute += usize::from(simplex.determinant > 0.0 && is_acute(&simplex, cogram));
    }
    acute
}

fn is_acute(simplex: &Simplex<f64, 3>, cogram: &[[f64; 3]; 3]) -> bool {
    let [a, b, c] = &simplex.gradients;
    let [x, y] = [linear::apply(cogram, b), linear::apply(cogram, c)];
    let (ab, ac, bc) = (linear::dot(a, &x), linear::dot(a, &y), linear::dot(b, &y));
    let (aa, bb, cc) = (
        linear::square(cogram, a),
        linear::dot(b, &x),
        linear::dot(c, &y),
    );
    ab < 0.0
        && ac < 0.0
        && bc < 0.0
        && aa + ab + ac > 0.0
        && ab + bb + bc > 0.0
        && ac + bc + cc > 0.0
}
