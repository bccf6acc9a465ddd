//! The links of TCP vertices, built by hand, and spheres that violate the lemmas of section 7.

use acutile_bounds::links::Link;
use acutile_core::classify::{Triangle, code, frank_kasper};

/// A hexagonal antiprism between two poles: the star with 14 neighbours of Frank and Kasper.
fn antiprism(n: usize) -> Vec<Triangle> {
    let (top, bottom) = (0, 2 * n + 1);
    let upper = |k: usize| 1 + k % n;
    let lower = |k: usize| 1 + n + k % n;
    (0..n)
        .flat_map(|k| {
            [
                [top, upper(k), upper(k + 1)],
                [upper(k), lower(k), upper(k + 1)],
                [upper(k + 1), lower(k), lower(k + 1)],
                [bottom, lower(k + 1), lower(k)],
            ]
        })
        .collect()
}

fn link(triangles: &[Triangle]) -> Link {
    Link::of(&code(triangles).expect("a sphere"))
}

#[test]
fn antiprisms_are_stars() {
    let stars = frank_kasper::links();
    for (n, neighbours) in [(5, 12), (6, 14)] {
        let triangles = antiprism(n);
        let code = code(&triangles).expect("a sphere");
        assert_eq!(code.len(), neighbours);
        assert!(stars.contains(&code));
        assert_eq!(Link::of(&code).violation(), Ok(()));
    }
}

/// Each face of a tetrahedron is truncated to a hexagon with a six, each corner to a triangle: the
/// star with 16 neighbours.
#[test]
fn the_truncated_tetrahedron_is_a_star() {
    let corner = |at: usize, to: usize| 4 * at + to;
    let mut triangles: Vec<Triangle> = Vec::new();
    // Faces of the tetrahedron 0 1 2 3, all seen from outside.
    for [a, b, c] in [[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]] {
        let six = 16 + (6 - a - b - c);
        let ring = [(a, b), (b, a), (b, c), (c, b), (c, a), (a, c)];
        for k in 0..6 {
            let (p, q) = (ring[k], ring[(k + 1) % 6]);
            triangles.push([six, corner(p.0, p.1), corner(q.0, q.1)]);
        }
    }
    for [a, b, c, d] in [[0, 1, 2, 3], [1, 0, 3, 2], [2, 0, 1, 3], [3, 0, 2, 1]] {
        triangles.push([corner(a, b), corner(a, c), corner(a, d)]);
    }
    let mut used: Vec<usize> = triangles.iter().flatten().copied().collect();
    used.sort_unstable();
    used.dedup();
    let number = |v: usize| used.iter().position(|u| *u == v).expect("a vertex");
    let numbered = |flip: bool| -> Vec<Triangle> {
        let turned = triangles.iter().enumerate().map(|(k, &[a, b, c])| {
            // The corners may be seen from inside.
            if flip && k >= 24 {
                [a, c, b]
            } else {
                [a, b, c]
            }
        });
        turned.map(|t| t.map(number)).collect()
    };
    let code = code(&numbered(false))
        .or_else(|| code(&numbered(true)))
        .expect("a sphere");
    assert_eq!(code.len(), 16);
    assert!(frank_kasper::links().contains(&code));
    assert_eq!(Link::of(&code).violation(), Ok(()));
}

#[test]
fn other_spheres_violate_the_lemmas() {
    // The poles of a hexagonal bipyramid are sixes; each other vertex is adjacent to both.
    let bipyramid: Vec<Triangle> = (0..6)
        .flat_map(|k| [[6, k, (k + 1) % 6], [7, (k + 1) % 6, k]])
        .collect();
    let reason = link(&bipyramid)
        .violation()
        .expect_err("all edges of the hexagon are HH");
    assert!(reason.contains("the weights add up to 0/2"), "{reason}");
    // Every edge of an icosahedron is halved: all new vertices are sixes, and many are adjacent.
    let mut halved = Vec::new();
    let half = |a: usize, b: usize| 12 + 12 * a.min(b) + a.max(b);
    for [a, b, c] in antiprism(5) {
        let (ab, bc, ca) = (half(a, b), half(b, c), half(c, a));
        halved.extend([[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]);
    }
    let mut used: Vec<usize> = halved.iter().flatten().copied().collect();
    used.sort_unstable();
    used.dedup();
    assert_eq!(used.len(), 42);
    let number = |v: usize| used.iter().position(|u| *u == v).expect("a vertex");
    let halved: Vec<Triangle> = halved.iter().map(|t| t.map(number)).collect();
    let reason = link(&halved).violation().expect_err("adjacent sixes");
    assert!(reason.contains("adjacent sixes"), "{reason}");
}
