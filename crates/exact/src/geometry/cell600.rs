//! The 600-cell: its 120 vertices and 600 cells.
//!
//! The vertices are the unit icosians, times 2, with coordinates in Z\[φ\]. Two vertices are
//! adjacent when their inner product is 2φ, and the cells are the sets of four adjacent vertices.

use std::collections::BTreeSet;

/// a + bφ with φ² = φ + 1.
pub type Golden = [i32; 2];

/// The cells, by the sorted numbers of their vertices.
pub fn cells() -> Vec<[usize; 4]> {
    let vertices = vertices();
    let adjacent = |i: usize, j: usize| inner(&vertices[i], &vertices[j]) == [0, 2];
    let n = vertices.len();
    let later = |i: usize| (i + 1..n).filter(move |&j| adjacent(i, j));
    let mut cells = Vec::new();
    for a in 0..n {
        for b in later(a) {
            for c in later(b).filter(|&c| adjacent(a, c)) {
                for d in later(c).filter(|&d| adjacent(a, d) && adjacent(b, d)) {
                    cells.push([a, b, c, d]);
                }
            }
        }
    }
    cells
}

/// The 120 unit icosians, times 2, in a fixed order.
pub fn vertices() -> Vec<[Golden; 4]> {
    let mut vertices = BTreeSet::new();
    for signs in 0..16 {
        let sign = |k: usize| if signs >> k & 1 == 0 { 1 } else { -1 };
        vertices.insert([0, 1, 2, 3].map(|k| [sign(k), 0]));
        for k in 0..4 {
            let mut unit = [[0, 0]; 4];
            unit[k] = [2 * sign(k), 0];
            vertices.insert(unit);
        }
        // (±φ, ±1, ±1/φ, 0) with 1/φ = φ - 1.
        let base = [[0, sign(0)], [sign(1), 0], [-sign(2), sign(2)], [0, 0]];
        for permutation in even_permutations() {
            vertices.insert(permutation.map(|k| base[k]));
        }
    }
    vertices.into_iter().collect()
}

/// The twelve even permutations of 0 to 3.
fn even_permutations() -> Vec<[usize; 4]> {
    let mut even = Vec::new();
    for code in 0..256 {
        let p = [0, 2, 4, 6].map(|shift| code >> shift & 3);
        let pairs = (0..4).flat_map(|i| (i + 1..4).map(move |j| (i, j)));
        let is_permutation = BTreeSet::from(p).len() == 4;
        let inversions = pairs.filter(|&(i, j)| p[i] > p[j]).count();
        if is_permutation && inversions.is_multiple_of(2) {
            even.push(p);
        }
    }
    even
}

/// Σ x_k y_k
pub fn inner(x: &[Golden; 4], y: &[Golden; 4]) -> Golden {
    x.iter().zip(y).fold([0, 0], |[e, f], ([a, b], [c, d])| {
        [e + a * c + b * d, f + a * d + b * c + b * d]
    })
}
