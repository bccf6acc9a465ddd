//! Foams against the literature, hand calculations and another program.

use acutile_catalog::build;
use acutile_core::foam::{Cell, cells, isoperimetric_quotient};
use acutile_core::tiling::{AnyTiling, Tiling};
use acutile_exact::number::Number;
use acutile_publish::draw::{DrawError, Figure, Options, draw, foam};
use malachite::Rational;
use std::collections::BTreeMap;

fn space(name: &str) -> Tiling<3> {
    match build(name).expect(name) {
        AnyTiling::Space(tiling) => tiling,
        AnyTiling::Plane(_) => panic!("{name} is in the plane"),
    }
}

fn face_counts(cells: &[Cell]) -> BTreeMap<usize, usize> {
    let mut counts = BTreeMap::new();
    for cell in cells {
        *counts.entry(cell.faces.len()).or_insert(0) += 1;
    }
    counts
}

/// The Frank-Kasper structures have the coordination numbers of the literature: A15 two Z12 and six Z14,
/// Z three Z12, two Z14, two Z15, C15 four Z12 and two Z16 in a primitive cell.
#[test]
fn cells_have_the_faces_of_the_literature() {
    let cases = [
        ("bcc", vec![(14, 1)]),
        ("a15", vec![(12, 2), (14, 6)]),
        ("z", vec![(12, 3), (14, 2), (15, 2)]),
        ("c15", vec![(12, 4), (16, 2)]),
    ];
    for (name, expected) in cases {
        let cells = cells(&space(name)).expect(name);
        assert_eq!(
            face_counts(&cells),
            expected.into_iter().collect(),
            "{name}"
        );
        let volume = cells.iter().map(Cell::volume);
        let volume = volume.fold(Number::zero(), |sum, v| sum + v);
        assert_eq!(volume, Number::from(Rational::from(1)), "{name}");
    }
}

/// Of a cube with edge 4 the cells take 125/16 and 129/16: 2 · 125 + 6 · 129 = 1024 = 16 · 64.
#[test]
fn cells_of_a15_have_the_volumes_of_a_clipping_program() {
    let cells = cells(&space("a15")).expect("a15");
    for cell in cells {
        let sixteenths = if cell.faces.len() == 12 { 125 } else { 129 };
        let expected = Rational::from_unsigneds(sixteenths as u32, 16 * 64);
        assert_eq!(cell.volume(), Number::from(expected));
    }
}

/// Kelvin's truncated octahedron with edge 1 has volume 8 √2 and area 6 + 12 √3: 0.753367. A program that
/// clips half-spaces in doubles gives 0.76181273 for A15.
#[test]
fn isoperimetric_quotients() {
    for (name, low, high) in [("bcc", 753_366, 753_367), ("a15", 761_812, 761_813)] {
        let tiling = space(name);
        let cells = cells(&tiling).expect(name);
        let (below, above) = isoperimetric_quotient(&tiling.frame.gram, &cells).expect(name);
        assert!(below <= above);
        assert!(
            below >= Rational::from_unsigneds(low as u32, 1_000_000),
            "{name}"
        );
        assert!(
            above <= Rational::from_unsigneds(high as u32, 1_000_000),
            "{name}"
        );
        assert!(above - below < Rational::from_unsigneds(1u32, 100_000_000));
    }
}

/// Every edge of a closed surface is in two triangles, once in each direction.
#[test]
fn stl_surfaces_are_closed() {
    let tiling = space("z");
    let cells = foam::foam(&tiling).expect("z is Delaunay");
    let text = foam::stl(&tiling, &cells).expect("z has a metric");
    let mut solids = 0;
    for solid in text.split("endsolid").filter(|part| part.contains("facet")) {
        solids += 1;
        let corners: Vec<&str> = solid
            .lines()
            .filter_map(|line| line.strip_prefix("vertex "))
            .collect();
        let mut edges: BTreeMap<(&str, &str), usize> = BTreeMap::new();
        for triangle in corners.chunks(3) {
            for (k, next) in [(0, 1), (1, 2), (2, 0)] {
                *edges.entry((triangle[k], triangle[next])).or_insert(0) += 1;
            }
        }
        assert!(edges.iter().all(|(_, &count)| count == 1));
        assert!(edges.keys().all(|&(p, q)| edges.contains_key(&(q, p))));
    }
    assert_eq!(solids, 7);
    let obj = foam::obj("z", &tiling, &cells).expect("z has a metric");
    let count = |prefix: &str| obj.lines().filter(|line| line.starts_with(prefix)).count();
    // 3 · 12 + 2 · 14 + 2 · 15 faces; a simple polyhedron with f faces has 2 f - 4 corners.
    assert_eq!((count("o "), count("f "), count("v ")), (7, 94, 160));
}

/// A slab does not fill space, and the cells at its boundary would be unbounded.
#[test]
fn only_delaunay_triangulations_of_space_have_a_foam() {
    assert!(matches!(
        foam::foam(&space("slab")),
        Err(DrawError::NoFoam(_))
    ));
    let slab = build("slab").expect("slab");
    let figure = draw("slab", &slab, Figure::Foam, &Options::default());
    assert!(matches!(figure, Err(DrawError::NoFoam(_))));
}

#[test]
fn coordination_has_a_panel_for_each_kind_of_vertex() {
    let c15 = build("c15").expect("c15");
    let drawing = draw("c15", &c15, Figure::Coordination, &Options::default()).expect("c15");
    let text = acutile_publish::draw::svg::svg(&drawing);
    assert!(text.contains("Z12: 12 neighbours, 4 in the cell"));
    assert!(text.contains("Z16: 16 neighbours, 2 in the cell"));
}
