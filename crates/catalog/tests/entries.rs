//! The entries of the catalogue: validity, counts from the paper and the literature, names.

use crate::common::{check, largest_angle, tiling};
use acutile_catalog::{CatalogError, build, entries, find};
use acutile_core::tiling::{AnyTiling, Domain, Tiling, match_facets};
use acutile_exact::geometry::Sign;
use acutile_exact::number::Number;
use acutile_paper::survey::Study;
use malachite::Rational;
use std::collections::BTreeSet;

#[test]
fn every_entry_tiles() {
    let mut names = BTreeSet::new();
    for entry in entries() {
        assert!(names.insert(entry.name), "{} twice", entry.name);
        if entry.is_family() || entry.has_box() || entry.is_large {
            continue;
        }
        let tiling = entry
            .build()
            .unwrap_or_else(|error| panic!("{}: {error}", entry.name));
        match (entry.domain, tiling) {
            ("space", AnyTiling::Space(tiling)) => check(entry.name, &tiling),
            ("plane", AnyTiling::Plane(tiling)) => check(entry.name, &tiling),
            ("slab" | "polyhedron", AnyTiling::Space(tiling)) => check_bounded(&tiling),
            ("polygon", AnyTiling::Plane(tiling)) => check_bounded(&tiling),
            (domain, _) => panic!("{} in {domain}", entry.name),
        }
    }
}

/// A domain with a boundary: facets without a mate, and the checker's proof.
fn check_bounded<const D: usize>(tiling: &Tiling<D>) {
    assert_ne!(tiling.frame.domain, Domain::Space);
    assert!(!match_facets(tiling).mismatches.is_empty());
    assert!(Study::of(tiling.clone()).is_ok());
}

/// Points and tetrahedra of a cell. For TCP structures over t triangles and q squares these are
/// 7t/2 + 8q and 20t + 46q; sigma has 30 and H 15 atoms (Sullivan 1999). Laves
/// phases have 6 atoms to a layer (C14 12, C36 24), mu 13, and with coordination numbers 12 and 16
/// in the ratio 2 : 1 there are (40 - 6)/6 tetrahedra to an atom.
#[test]
fn counts() {
    let expected = [
        ("z", 7, 40),
        ("a15", 8, 46),
        ("sigma", 30, 172),
        ("h", 15, 86),
        ("square-triangle-3464", 52, 298),
        ("c15", 6, 34),
        ("kagome:+", 6, 34),
        ("a15-bcc", 8, 46),
        ("c14", 12, 68),
        ("c14-best", 12, 68),
        ("z-best", 7, 40),
        ("slab-best", 11, 56),
        ("c36", 24, 136),
        ("mu", 13, 74),
        ("kagome:z", 7, 40),
        ("kagome:z+z-", 26, 148),
        ("bcc", 1, 6),
        // A corner, the centre and three centres of faces.
        ("sommerville-1", 5, 24),
        ("sommerville-2", 1, 6),
        ("sommerville-3", 2, 12),
        ("sommerville-4", 7, 24),
        ("goldberg-1", 1, 6),
        ("goldberg-2", 2, 12),
        ("cube-5", 8, 40),
        ("cube-6", 1, 6),
        // 3 points of a triangle at each of two heights; in each of two layers a centre and
        // two of the middle rings. Laves phases have 34/6 tetrahedra to a point.
        ("icosahedral", 12, 68),
        // Heights 0, 4.6, 9.6, 14.2 one point each, 4 and 10.2 two, 7.1 three.
        ("slab", 11, 56),
        ("slab-stack", 10, 56),
        // Laves phase with the colours' period doubled; Z twice.
        ("z-c15-3", 12, 68),
        ("z-c15-4", 14, 80),
        ("regular", 4, 1),
        ("cube-corner", 4, 1),
        ("two-corners", 5, 2),
        // 8 cubes of 6 tetrahedra, halved.
        ("goldberg-3", 20, 96),
    ];
    for (name, points, tetrahedra) in expected {
        let tiling = tiling(name);
        assert_eq!(
            (tiling.vertices.len(), tiling.len()),
            (points, tetrahedra),
            "{name}"
        );
    }
}

/// The 600-cell has 120 vertices, and 20, 5 and 2 cells at a vertex, an edge and a triangle. A vertex has 12
/// neighbours, the ends of an edge have 5 in common, and the corners of a triangle 2.
///
/// Without a cell: 4 · 20 - 6 · 5 + 4 · 2 - 1 = 57 cells have a vertex of it, and 4 · 12 - 6 · 5 + 4 · 2 - 4 = 22 other
/// vertices are neighbours. These are the boundary: 4 corners, a point in each of the 6 edges, 3 in each of the 4 faces.
/// Without the star of a vertex: the 12 neighbours form an icosahedron, and 12 · 20 - 30 · 5 + 20 · 2 = 130 cells
/// have one of them. Without two cells with a common triangle: 5 vertices, 9 edges and 7 triangles. Without the
/// five cells at an edge: 7 vertices, 16 edges and 15 triangles.
#[test]
fn polyhedra_have_the_cells_that_remain_of_the_600_cell() {
    let (piece, all) = (600 - 57, 120 - 4);
    let inner = all - 22;
    // The cube has 8 corners, a point in each of 12 edges, and 7 in a face: in its diagonal, and in two triangles.
    let (edge, face) = (1, 1 + 2 * 3);
    // Each of four corners of the cube meets the middle in a face with 9 points.
    let cube = 5 * all - 4 * (3 + 3 + 3);
    let cube_inner = cube - (8 + 12 * edge + 6 * face);
    // The octahedron has 12 triangles inside and 8 outside, 6 + 12 edges and 7 corners.
    let octahedron = 8 * inner + 20 * 3 + 18 + 7;
    let expected = [
        ("dodecahedron-470", 600 - 130, 120 - 13),
        ("tetrahedron-543", piece, all),
        ("prism-533", 600 - (5 * 20 - 9 * 5 + 7 * 2 - 2), 120 - 5),
        (
            "pentagonal-prism-515",
            600 - (7 * 20 - 16 * 5 + 15 * 2 - 5),
            120 - 7,
        ),
        ("cube-2715", 5 * piece, cube),
        ("octahedron-4344", 8 * piece, octahedron),
        // Two cubes have both of their ends in common.
        (
            "square-prism",
            10 * piece,
            2 * cube - 2 * (4 + 4 * edge + face),
        ),
        // In a cell are 2 cubes, and 6 faces, 6 edges and 2 corners of cubes.
        (
            "cube-space",
            10 * piece,
            2 * cube_inner + 6 * face + 6 * edge + 2,
        ),
    ];
    for (name, tetrahedra, points) in expected {
        let tiling = tiling(name);
        assert_eq!(
            (tiling.len(), tiling.vertices.len()),
            (tetrahedra, points),
            "{name}"
        );
        assert_eq!(largest_angle(&tiling), Sign::Less, "{name}");
    }
    check("cube-space", &tiling("cube-space"));
    assert_eq!(tiling("box:1,2,1").len(), 2 * 2715);
}

#[test]
fn boxes_with_other_sides_are_refused() {
    for sides in [
        "",
        "1,1",
        "1,1,1,1",
        "0,1,1",
        "-1,-1,1",
        "1/2,1,1",
        "5,5,5",
        "9223372036854775807,3,1",
    ] {
        let built = build(&format!("box:{sides}"));
        assert!(matches!(built, Err(CatalogError::Sides(_))), "{sides}");
    }
}

#[test]
fn sides_of_triangles() {
    for sides in [
        "1,2,3", "1,2,4", "1,1", "1,1,1,1", "0,1,1", "-1,1,1", "x,1,1", "",
    ] {
        assert!(
            build(&format!("triangle-tiling:{sides}")).is_err(),
            "{sides}"
        );
    }
    // An obtuse triangle tiles as well.
    assert!(build("triangle-tiling:2,2,3").is_ok());
}

/// Everything in one field: Z, A15 and the Laves phases are rational.
#[test]
fn fields() {
    for name in ["z", "a15", "c15", "c14", "c36", "a15-bcc", "kagome:z"] {
        assert!(tiling(name).frame.field.is_rationals(), "{name}");
    }
    for name in ["sigma", "h", "mu"] {
        assert_eq!(tiling(name).frame.field.degree(), 2, "{name}");
    }
}

#[test]
fn names_and_parameters() {
    assert!(matches!(build("a14"), Err(CatalogError::UnknownName(_))));
    for word in ["", "x", "z+?", &"z".repeat(65)] {
        assert!(
            matches!(build(&format!("kagome:{word}")), Err(CatalogError::Word(_))),
            "{word}"
        );
    }
    let number = |n, d| Number::from(Rational::from_signeds(n, d));
    let goldberg = find("goldberg-1").unwrap();
    assert!(matches!(
        goldberg.build_with(&number(0, 1)),
        Err(CatalogError::NotPositive(_))
    ));
    assert!(matches!(
        find("a15").unwrap().build_with(&number(1, 1)),
        Err(CatalogError::NoParameter(_))
    ));
    let AnyTiling::Space(tiling) = goldberg.build_with(&number(3, 7)).unwrap() else {
        panic!("a plane tiling");
    };
    check("goldberg-1", &tiling);
}
