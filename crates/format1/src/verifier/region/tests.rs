//! What two triangles have in common, against a linear program.

use super::super::Limits;
use super::super::document::{Document, read_json};
use super::*;
use crate::certificate::{Certificate, Number, to_bytes};
use meeting::{Point, meet_elsewhere};

#[path = "../../../../../tests/common/meeting.rs"]
mod meeting;

/// Some certificate of a region, with these vertices.
fn certificate(points: &[Point]) -> Document<'static> {
    let root = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");
    let path = format!("{root}/tests/certificates/valid/region-cube-6.json");
    let mut certificate: Certificate =
        serde_json::from_slice(&std::fs::read(path).unwrap()).unwrap();
    let text = |x: &i64| Number(vec![x.to_string()]);
    let vertices = points.iter().map(|p| p.iter().map(text).collect());
    certificate.witness.vertices = vertices.collect();
    read_json(&to_bytes(&certificate), &Limits::DEFAULT).unwrap()
}

/// Every two of the triangles that are not flat, whose corners are the same if their indices are:
/// against a linear program.
fn every_two_triangles(points: &[Point]) {
    let certificate = certificate(points);
    let tiling = Tiling::new(&certificate, &Limits::DEFAULT).unwrap();
    let n = points.len();
    let triples = (0..n).flat_map(|a| (0..a).flat_map(move |b| (0..b).map(move |c| [a, b, c])));
    let triangle = |corners| Triangle {
        simplex: 0,
        facet: 0,
        corners,
    };
    let not_flat = |t: &Triangle| {
        let normal = normal(&tiling, t);
        first_sign(&tiling, &normal).unwrap().is_ne()
    };
    let triangles: Vec<Triangle> = triples.map(triangle).filter(not_flat).collect();
    let extents = Extents::new(&tiling, &triangles).unwrap();
    let places = |t: &Triangle| t.corners.map(|v| points[v]);
    let mut seen = [0, 0];
    for (k, f) in triangles.iter().enumerate() {
        for g in &triangles[..k] {
            let shared = f.corners.iter().filter(|v| g.corners.contains(v));
            let common: Vec<Point> = shared.map(|&v| points[v]).collect();
            let answer = apart::meet_in_common_corners(&tiling, &extents, f, g).unwrap();
            let expected = !meet_elsewhere(&places(f), &places(g), &common);
            assert_eq!(answer, expected, "{:?} {:?}", places(f), places(g));
            seen[usize::from(answer)] += 1;
        }
    }
    assert!(seen[0] > 99 && seen[1] > 99, "{seen:?}");
}

fn grid(n: i64) -> impl Iterator<Item = Point> {
    (0..n * n * n).map(move |k| [k / (n * n), k / n % n, k % n])
}

#[test]
fn triangles_of_a_cube() {
    every_two_triangles(&grid(2).collect::<Vec<_>>());
}

#[test]
fn triangles_of_a_plane() {
    every_two_triangles(&grid(3).filter(|p| p[2] == 1).collect::<Vec<_>>());
    every_two_triangles(
        &grid(3)
            .filter(|p| p.iter().sum::<i64>() == 3)
            .collect::<Vec<_>>(),
    );
}

/// The same places under two names are not the same corners.
#[test]
fn triangles_of_a_tetrahedron_twice() {
    let corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]];
    every_two_triangles(&[corners, corners].concat());
}
