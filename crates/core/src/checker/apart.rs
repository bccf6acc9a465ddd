//! Whether simplices have common inner points, and whether boundary facets lie against each other.
//!
//! Two convex bodies have disjoint interiors if and only if a plane separates them. For simplices it
//! is enough to try the normals of their facets and, in space, the cross products of their edges.
//! All values are exact.

use acutile_exact::geometry::triangle::Point;
use acutile_exact::geometry::{Scalar, Sign, linear};
use linear::cross;

/// Whether two simplices, given by their corners, have disjoint interiors. In the plane the third
/// coordinate is zero.
pub(super) fn are_apart<S: Scalar>(f: &[Point<S>], g: &[Point<S>]) -> bool {
    let separates = |axis: &Point<S>| {
        let (low_f, high_f) = range(axis, f);
        let (low_g, high_g) = range(axis, g);
        let is_direction = low_f.minus(&high_f).sign().is_ne();
        is_direction && (high_f.minus(&low_g).sign().is_le() || high_g.minus(&low_f).sign().is_le())
    };
    let normals = |points: &[Point<S>]| {
        let of_facet = |opposite: usize| {
            let others = (0..points.len()).filter(|&k| k != opposite);
            let others: Vec<&Point<S>> = others.map(|k| &points[k]).collect();
            conormal(&others)
        };
        (0..points.len()).map(of_facet).collect::<Vec<_>>()
    };
    if normals(f).iter().chain(&normals(g)).any(separates) {
        return true;
    }
    if f.len() < 4 {
        return false;
    }
    let (edges_f, edges_g) = (edges(f), edges(g));
    let mut pairs = edges_f
        .iter()
        .flat_map(|e| edges_g.iter().map(move |other| cross(e, other)));
    pairs.any(|axis| separates(&axis))
}

/// Whether two facets lie in one plane (line), with opposite normals, and have a common area (length).
/// The corners of each are in an order whose normal points out of its simplex.
pub(super) fn are_against<S: Scalar>(f: &[Point<S>], g: &[Point<S>]) -> bool {
    let normal = |points: &[Point<S>]| conormal(&points.iter().collect::<Vec<_>>());
    let (n, m) = (normal(f), normal(g));
    let in_plane = |point: &Point<S>| {
        let offset = linear::subtract(point, &f[0]);
        linear::dot(&n, &offset).sign().is_eq()
    };
    if !g.iter().all(in_plane) || linear::dot(&n, &m).sign() != Sign::Less {
        return false;
    }
    let meets_along = |axis: &Point<S>| {
        let (low_f, high_f) = range(axis, f);
        let (low_g, high_g) = range(axis, g);
        high_f.minus(&low_g).sign().is_gt() && high_g.minus(&low_f).sign().is_gt()
    };
    match f.len() {
        2 => meets_along(&linear::subtract(&f[1], &f[0])),
        _ => {
            let axes = edges(f).into_iter().chain(edges(g));
            axes.map(|edge| cross(&n, &edge))
                .all(|axis| meets_along(&axis))
        }
    }
}

/// The least and the greatest value of a covector.
fn range<S: Scalar>(axis: &Point<S>, points: &[Point<S>]) -> (S, S) {
    let mut values = points.iter().map(|point| linear::dot(axis, point));
    let first = values.next().unwrap_or_else(|| axis[0].minus(&axis[0]));
    let (mut low, mut high) = (first.clone(), first);
    for value in values {
        if value.minus(&low).sign().is_lt() {
            low = value;
        } else if value.minus(&high).sign().is_gt() {
            high = value;
        }
    }
    (low, high)
}

fn edges<S: Scalar>(points: &[Point<S>]) -> Vec<Point<S>> {
    let pairs = (0..points.len()).flat_map(|i| (0..i).map(move |j| (i, j)));
    pairs
        .map(|(i, j)| linear::subtract(&points[i], &points[j]))
        .collect()
}

/// A covector that is constant on the hull of two points of the plane z = 0, or of three points of
/// space.
pub(super) fn conormal<S: Scalar>(points: &[&Point<S>]) -> Point<S> {
    let along = linear::subtract(points[1], points[0]);
    match points.get(2) {
        Some(third) => cross(&along, &linear::subtract(third, points[0])),
        None => {
            let zero = along[2].minus(&along[2]);
            [along[1].clone(), zero.minus(&along[0]), zero]
        }
    }
}
