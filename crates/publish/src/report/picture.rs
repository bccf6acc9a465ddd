//! A still picture of one cell in SVG, for readers without the page's program and for the index of a site.
//!
//! Parallel projection, faces that look at the viewer only, painted from back to front. In a Delaunay
//! triangulation the simplices can be ordered by the depth of their circumcentres (H. Edelsbrunner, An
//! acyclicity theorem for cell complexes in d dimensions, 1990, with the viewpoint at infinity): a common
//! facet lies in the plane of equal power of the two spheres. For other tilings this order, and hence the
//! picture, may be wrong in places; the text beside it does not depend on it.

use super::colour::{hex, part};
use super::data::basis;
use crate::palette::Palette;
use acutile_core::quality::shapes;
use acutile_core::tiling::{Corner, Facet, SimplexId, Tiling, supercell};
use acutile_exact::geometry::linear;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

/// The longer side of the picture.
const SIZE: f64 = 480.0;
/// Toward the viewer, right, up: an orthonormal frame that shows no symmetric tiling edge-on.
const VIEW: [[f64; 3]; 3] = [
    [0.4680, -0.7488, 0.4695],
    [0.8480, 0.5300, 0.0],
    [-0.2488, 0.3981, 0.8830],
];

/// A polygon on its way to the paper.
struct Face {
    depth: f64,
    points: Vec<[f64; 2]>,
    colour: [f64; 3],
}

/// The picture of simplices of these congruence classes; `label` describes it and is escaped
/// already. Few triangles of the plane are shown with their neighbours.
pub fn picture<const D: usize>(tiling: &Tiling<D>, classes: &[usize], label: &str) -> String {
    let palette = Palette::of(&shapes(tiling));
    if D == 2 && tiling.len() < 12 {
        let sizes: [u16; D] = std::array::from_fn(|k| if k < tiling.frame.rank() { 3 } else { 1 });
        let copies = sizes.iter().map(|&n| usize::from(n)).product();
        let classes = classes.repeat(copies);
        return cell_picture(&supercell(tiling, sizes), &classes, &palette, label);
    }
    cell_picture(tiling, classes, &palette, label)
}

fn cell_picture<const D: usize>(
    tiling: &Tiling<D>,
    classes: &[usize],
    palette: &Palette,
    label: &str,
) -> String {
    let basis = basis(tiling);
    let mut faces = Vec::new();
    let moves: Vec<[i32; D]> = tiling
        .indices()
        .map(|s| move_into_cell(tiling, s))
        .collect();
    let inner = inner_facets(tiling, &moves);
    for (simplex, &class) in tiling.indices().zip(classes) {
        let corners = placed(tiling, &basis, simplex, moves[simplex.index()]);
        let colour = part(palette.colour(class));
        match D {
            2 => faces.push(flat_face(&corners, colour)),
            _ => faces.extend(solid_faces(&corners, colour, |k| {
                inner.contains(&Facet::new(simplex, k))
            })),
        }
    }
    faces.sort_by(|a, b| a.depth.total_cmp(&b.depth));
    draw(&faces, label)
}

/// The lattice vector that moves the centroid of a simplex into the cell.
fn move_into_cell<const D: usize>(tiling: &Tiling<D>, simplex: SimplexId) -> [i32; D] {
    let corners: Vec<[f64; D]> = tiling
        .simplex(simplex)
        .iter()
        .map(|corner| tiling.position(corner).map(|x| x.approximate()))
        .collect();
    std::array::from_fn(|k| {
        let middle = corners.iter().map(|c| c[k]).sum::<f64>() / corners.len() as f64;
        // Centroids in the boundary of the cell go to one side, whatever was rounded.
        if k < tiling.frame.rank() {
            -(middle + 1e-9).floor() as i32
        } else {
            0
        }
    })
}

/// The facets that two simplices of the picture share: nobody
/// sees them.
fn inner_facets<const D: usize>(tiling: &Tiling<D>, moves: &[[i32; D]]) -> BTreeSet<Facet> {
    let mut owners: BTreeMap<Vec<Corner<D>>, Vec<Facet>> = BTreeMap::new();
    for (simplex, corners) in tiling.indices().zip(tiling.simplices()) {
        for opposite in 0..=D {
            let others = (0..=D).filter(|&k| k != opposite);
            let mut facet: Vec<Corner<D>> = others
                .map(|k| corners[k].moved(moves[simplex.index()]))
                .collect();
            facet.sort_unstable();
            owners
                .entry(facet)
                .or_default()
                .push(Facet::new(simplex, opposite));
        }
    }
    owners
        .into_values()
        .filter(|facets| facets.len() > 1)
        .flatten()
        .collect()
}

/// Cartesian corners of a simplex that is moved by a lattice vector.
fn placed<const D: usize>(
    tiling: &Tiling<D>,
    basis: &[Vec<f64>],
    simplex: SimplexId,
    move_by: [i32; D],
) -> Vec<[f64; 3]> {
    let cartesian = |corner: &Corner<D>| {
        let coordinates = tiling
            .position(&corner.moved(move_by))
            .map(|x| x.approximate());
        let mut point = [0.0; 3];
        for (x, vector) in coordinates.iter().zip(basis) {
            for (slot, b) in point.iter_mut().zip(vector) {
                *slot += x * b;
            }
        }
        point
    };
    tiling.simplex(simplex).iter().map(cartesian).collect()
}

fn flat_face(corners: &[[f64; 3]], colour: [f64; 3]) -> Face {
    Face {
        depth: 0.0,
        points: corners.iter().map(|p| [p[0], -p[1]]).collect(),
        colour,
    }
}

/// The facets of a tetrahedron that look at the viewer and are not hidden.
fn solid_faces(
    corners: &[[f64; 3]],
    colour: [f64; 3],
    is_hidden: impl Fn(usize) -> bool,
) -> Vec<Face> {
    let depth = linear::dot(&circumcentre(corners), &VIEW[0]);
    let mut faces = Vec::new();
    for opposite in (0..4).filter(|&k| !is_hidden(k)) {
        let face: Vec<[f64; 3]> = (0..4)
            .filter(|&k| k != opposite)
            .map(|k| corners[k])
            .collect();
        let side = |k: usize| linear::subtract(&face[k], &face[0]);
        let normal = linear::cross(&side(1), &side(2));
        let outward = linear::subtract(&face[0], &corners[opposite]);
        let outward = linear::dot(&normal, &outward).signum();
        let facing =
            outward * linear::dot(&normal, &VIEW[0]) / linear::dot(&normal, &normal).sqrt();
        if facing > 1e-9 {
            faces.push(Face {
                depth,
                points: face
                    .iter()
                    .map(|p| [linear::dot(p, &VIEW[1]), -linear::dot(p, &VIEW[2])])
                    .collect(),
                colour: colour.map(|c| c * (0.55 + 0.45 * facing)),
            });
        }
    }
    faces
}

/// e_i · x = |e_i|²/2 for the edges from corner 0, solved by their cross products.
fn circumcentre(corners: &[[f64; 3]]) -> [f64; 3] {
    let edges = [1, 2, 3].map(|k| linear::subtract(&corners[k], &corners[0]));
    let duals = linear::cofactors(&edges);
    let determinant = linear::dot(&edges[0], &duals[0]);
    std::array::from_fn(|k| {
        let terms = edges.iter().zip(&duals);
        let sum: f64 = terms
            .map(|(edge, dual)| linear::dot(edge, edge) * dual[k])
            .sum();
        corners[0][k] + sum / (2.0 * determinant)
    })
}

fn draw(faces: &[Face], label: &str) -> String {
    let points = || faces.iter().flat_map(|face| &face.points);
    let bound =
        |k: usize, f: fn(f64, f64) -> f64, start: f64| points().map(|p| p[k]).fold(start, f);
    let low = [0, 1].map(|k| bound(k, f64::min, f64::INFINITY));
    let high = [0, 1].map(|k| bound(k, f64::max, f64::NEG_INFINITY));
    let scale = (SIZE - 8.0) / (high[0] - low[0]).max(high[1] - low[1]).max(1e-300);
    let place = |k: usize, p: &[f64; 2]| (p[k] - low[k]) * scale + 4.0;
    let size = [0, 1].map(|k| (high[k] - low[k]) * scale + 8.0);
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"picture\" viewBox=\"0 0 {:.0} {:.0}\" role=\"img\" aria-label=\"{label}\" \
         stroke=\"#222\" stroke-width=\"1\" stroke-linejoin=\"round\">",
        size[0], size[1]
    );
    for face in faces {
        let corner = |p: &[f64; 2]| format!("{:.1},{:.1}", place(0, p), place(1, p));
        let corners: Vec<String> = face.points.iter().map(corner).collect();
        // Writing to a string cannot fail.
        let _ = write!(
            svg,
            "<polygon points=\"{}\" fill=\"{}\"/>",
            corners.join(" "),
            hex(face.colour)
        );
    }
    svg + "</svg>"
}
