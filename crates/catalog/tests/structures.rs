//! Properties of structures of the catalogue: positions, symbols, and the bounds of parameters.

use crate::common::tiling;
use acutile_catalog::{CatalogError, build, build_with};
use acutile_core::classify::metric_symbol;
use acutile_core::quality::{shapes, squared_edges};
use acutile_core::statement::Statement;
use acutile_core::tiling::AnyTiling;
use acutile_exact::number::Number;
use acutile_paper::survey::Study;
use malachite::Rational;
use std::collections::BTreeSet;

/// C15, Fd-3m with the origin at an atom of the diamond lattice: 8a (0,0,0), 16d (5/8,5/8,5/8),
/// modulo the fcc lattice of (0,1,1), (1,0,1), (1,1,0) halves of the cubic cell.
#[test]
fn c15_has_the_crystallographic_positions() {
    let positions = [
        [0, 0, 0],
        [2, 2, 2],
        [5, 5, 5],
        [5, 7, 7],
        [7, 5, 7],
        [7, 7, 5],
    ];
    // A cubic position (x, y, z)/8 is (-x + y + z, x - y + z, x + y - z)/8 in that basis.
    let expected: BTreeSet<[Number; 3]> = positions
        .iter()
        .map(|[x, y, z]| [y + z - x, x + z - y, x + y - z])
        .map(|p: [i64; 3]| p.map(|n| Number::from(Rational::from_signeds(n.rem_euclid(8), 8))))
        .collect();
    let c15 = tiling("c15");
    let found: BTreeSet<[Number; 3]> = c15.vertices.iter().collect();
    assert_eq!(found, expected);
}

/// Similar tilings have equal metric symbols.
#[test]
fn a15_from_bcc_is_similar_to_a15() {
    let symbol = |name| {
        let Study {
            tiling,
            matching,
            ridges,
            ..
        } = Study::of(tiling(name)).unwrap();
        metric_symbol(&tiling, &matching, &ridges, |simplex| {
            squared_edges(&tiling, simplex)
        })
    };
    assert!(symbol("a15").is_some());
    assert_eq!(symbol("a15-bcc"), symbol("a15"));
    assert_ne!(symbol("z"), symbol("a15"));
}

/// The icosahedra give C14 and not Z: all vertices have 12 or 16 neighbours, and Z has none with 16. The
/// variant gives C15 over triangles and Z over squares.
#[test]
fn what_tcp_structures_are() {
    let symbol = |name| Study::of(tiling(name)).unwrap().symbol().unwrap();
    assert_eq!(symbol("icosahedral"), symbol("c14"));
    assert_ne!(symbol("icosahedral"), symbol("z"));
    assert_eq!(symbol("z-c15-3"), symbol("c15"));
    assert_eq!(symbol("z-c15-4"), symbol("z"));
    for name in ["z-c15-33344", "z-c15-32434"] {
        let study = Study::of(tiling(name)).unwrap();
        assert!(study.states(&Statement::Tcp) && study.states(&Statement::Acute));
    }
}

/// The part that shows it is the wheel: six triangles at a vertex and the squares around them.
#[test]
fn wheels_have_no_blank_edges() {
    for name in ["3464", "inflated-3", "inflated-4", "inflated-32434"] {
        match build(&format!("z-c15:{name}")) {
            Err(CatalogError::NoBlankEdges {
                tiles,
                radius: 1,
                stars: 7,
                ..
            }) => assert_eq!(tiles, "3.3.3.3.3.3", "{name}"),
            other => panic!("{name}: {other:?}"),
        }
    }
}

/// Acute for every positive epsilon; Delaunay from (sqrt 2 - 1)/3 on.
#[test]
fn two_corners_are_delaunay_only_from_a_bound_on() {
    let statements = |epsilon: &str| {
        let AnyTiling::Space(tiling) = build_with("two-corners", epsilon).unwrap() else {
            panic!("a plane tiling");
        };
        Study::of(tiling).unwrap().statements
    };
    for (epsilon, delaunay, weakly) in [
        ("1/1000", false, false),
        ("(sqrt(2)-1)/3 - 1/10^9", false, false),
        ("(sqrt(2)-1)/3", false, true),
        ("(sqrt(2)-1)/3 + 1/10^9", true, false),
        ("1000", true, false),
    ] {
        let statements = statements(epsilon);
        assert!(statements.contains(&Statement::Acute), "{epsilon}");
        assert_eq!(
            statements.contains(&Statement::Delaunay),
            delaunay,
            "{epsilon}"
        );
        assert_eq!(
            statements.contains(&Statement::WeaklyDelaunay),
            weakly,
            "{epsilon}"
        );
    }
}

/// All pieces are congruent; the arrangement fits for two ratios.
#[test]
fn goldberg_3_fits_for_two_ratios() {
    for (ratio, fits) in [
        ("sqrt(2)/2", true),
        ("sqrt(2)/4", true),
        ("1/2", false),
        ("1", false),
        ("sqrt(3)/5", false),
    ] {
        let AnyTiling::Space(tiling) = build_with("goldberg-3", ratio).unwrap() else {
            panic!("a plane tiling");
        };
        assert_eq!(shapes(&tiling).len(), 1, "{ratio}");
        assert_eq!(Study::of(tiling).is_ok(), fits, "{ratio}");
    }
}
