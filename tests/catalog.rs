//! The catalogue: counts from the paper and the literature, and validity by other means
//! than the recipes'.

use acutile::catalog::{CatalogError, build, entries, find, plane_tiling};
use acutile::geometry::{Scalar, Sign, Simplex, linear};
use acutile::number::Number;
use acutile::tiling::{AnyTiling, Tiling, match_facets};
use malachite::Rational;
use std::collections::BTreeSet;

fn tiling(name: &str) -> Tiling<3> {
    match build(name).unwrap() {
        AnyTiling::Space(tiling) => tiling,
        AnyTiling::Plane(_) => panic!("{name} is plane"),
    }
}

/// Matched facets, positive orientation, and the volume of one cell.
fn check<const D: usize>(name: &str, tiling: &Tiling<D>) {
    assert!(match_facets(tiling).mismatches.is_empty(), "{name}");
    let mut volume = Number::zero();
    for simplex in tiling.simplices() {
        let corners: Vec<_> = simplex.iter().map(|c| tiling.position(c)).collect();
        let determinant = Simplex::new(&corners).determinant;
        assert_eq!(determinant.sign(), Sign::Greater, "{name}");
        volume = volume.plus(&determinant);
    }
    assert_eq!(
        volume,
        Number::from(Rational::from((1..=D).product::<usize>())),
        "{name}"
    );
}

/// The largest sign of a product of facet normals: `Less` if all angles are acute.
fn largest_angle(tiling: &Tiling<3>) -> Sign {
    let cogram = linear::cofactors(&tiling.frame.gram);
    let signs = tiling.simplices().flat_map(|simplex| {
        let corners: Vec<_> = simplex.iter().map(|c| tiling.position(c)).collect();
        let products = Simplex::new(&corners).normal_products(&cogram);
        products
            .pairs()
            .map(|(_, _, product)| product.sign())
            .collect::<Vec<_>>()
    });
    signs.max().unwrap()
}

#[test]
fn every_entry_tiles() {
    let mut names = BTreeSet::new();
    for entry in entries() {
        assert!(names.insert(entry.name), "{} twice", entry.name);
        if entry.is_family() {
            continue;
        }
        match entry
            .build()
            .unwrap_or_else(|error| panic!("{}: {error}", entry.name))
        {
            AnyTiling::Space(tiling) => check(entry.name, &tiling),
            AnyTiling::Plane(tiling) => check(entry.name, &tiling),
        }
    }
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

/// Table 1: the TCP structures are acute, the largest angle of these others is 90 degrees or
/// (III and IV) more.
#[test]
fn angles_as_in_table_1() {
    let acute = [
        "z",
        "a15",
        "sigma",
        "h",
        "c15",
        "a15-bcc",
        "c14",
        "c36",
        "mu",
        "kagome:zz+-",
    ];
    for name in acute {
        assert_eq!(largest_angle(&tiling(name)), Sign::Less, "{name}");
    }
    for name in ["bcc", "sommerville-1", "cube-5", "cube-6"] {
        assert_eq!(largest_angle(&tiling(name)), Sign::Equal, "{name}");
    }
    for name in ["sommerville-3", "sommerville-4"] {
        assert_eq!(largest_angle(&tiling(name)), Sign::Greater, "{name}");
    }
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
fn inflation_gives_hundreds_of_points() {
    let sizes = [
        plane_tiling::triangles(),
        plane_tiling::squares(),
        plane_tiling::snub(),
    ]
    .map(|plane| plane.inflated().point_set().unwrap().points.len());
    assert!(sizes[0] >= 90 && sizes[2] >= 400, "{sizes:?}");
    // The area grows by (2 + sqrt 3)² = 7 + 4 sqrt 3: a triangle, sqrt 3/4, becomes 7 triangles
    // and 3 squares, so Z's two triangles become 14 and 6: 49 + 48 points.
    assert_eq!(sizes[0], 97);
}

#[test]
fn what_is_no_square_triangle_tiling_is_refused() {
    let mut holed = plane_tiling::rhombitrihexagonal();
    holed.vertices.remove(0);
    assert!(matches!(
        holed.structure(),
        Err(CatalogError::NotSquareTriangle { angle: 120, .. })
    ));
    let mut flat = plane_tiling::squares();
    flat.lattice[1] = [3, 0, 0, 0];
    assert!(flat.structure().is_err());
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
        Err(CatalogError::Parameter(_))
    ));
    assert!(matches!(
        find("a15").unwrap().build_with(&number(1, 1)),
        Err(CatalogError::Parameter(_))
    ));
    let AnyTiling::Space(tiling) = goldberg.build_with(&number(3, 7)).unwrap() else {
        panic!("a plane tiling");
    };
    check("goldberg-1", &tiling);
}
