//! Combinatorics of tilings against hand counts, the literature, and a second way of
//! deciding isomorphism.

use acutile::classify::frank_kasper;

/// Frank and Kasper 1958: the coordination numbers 12, 14, 15, 16, one polyhedron each.
#[test]
fn four_stars_by_exhaustion() {
    let links = frank_kasper::links();
    let sizes: Vec<usize> = links.iter().map(|link| link.len()).collect();
    assert_eq!(sizes, [12, 14, 15, 16]);
    for link in links {
        let sixes = link.valences().filter(|&v| v == 6).count();
        assert_eq!(sixes, link.len() - 12);
        assert_eq!(link.valences().filter(|&v| v == 5).count(), 12);
    }
}
