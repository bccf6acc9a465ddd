//! Planes that no simplex crosses: equations in words, the prover's check, and families.

use acutile_catalog as catalog;
use acutile_core::checker::{Options, examine};
use acutile_core::family::{self, NotProvable};
use acutile_core::statement::{Requirement, Statement};
use acutile_core::tiling::{AnyTiling, Coordinates, Corner, Domain, Frame, Tiling};
use acutile_core::with_family;
use acutile_exact::number::Number;
use malachite::Rational;

fn requirement(equation: &str) -> Result<Requirement, String> {
    format!("plane:{equation}").parse()
}

/// Lowest terms, and the first coefficient positive: one plane has one equation.
#[test]
fn equations_have_one_form() {
    for (written, expected) in [
        ("x1=0", "x1=0"),
        ("+x1=0", "x1=0"),
        ("-x1=1/2", "x1=-1/2"),
        ("-x1+2x3=-4", "x1-2x3=4"),
        ("2x1+4x2=3", "x1+2x2=3/2"),
        ("x2+x1=0", "x1+x2=0"),
        ("x1+x1=1", "x1=1/2"),
        ("0x1+x2=3", "x2=3"),
        ("x1=-0", "x1=0"),
        ("x1=0.5", "x1=1/2"),
        ("x1=2/4", "x1=1/2"),
        ("6x1-4x2+2x3=-10/3", "3x1-2x2+x3=-5/3"),
        ("536870911x1+x2=0", "536870911x1+x2=0"),
        ("-3x2=7", "x2=-7/3"),
    ] {
        let plane = requirement(written).unwrap_or_else(|error| panic!("{written}: {error}"));
        assert_eq!(plane.to_string(), format!("plane:{expected}"));
    }
}

#[test]
fn what_is_no_equation_is_refused() {
    for wrong in [
        "",
        "=",
        "x1",
        "x1=",
        "=1",
        "x1=1=2",
        "x0=0",
        "x4=0",
        "x=0",
        "0x1=0",
        "x1-x1=0",
        "x1=1/0",
        "x1=1/-2",
        "x1+=1",
        "++x1=1",
        "x1x2=0",
        "1/2x1=0",
        "x1 = 0",
        "X1=0",
        "y=0",
        "x1=sqrt(2)",
        "x1=x2",
        "x1=−1",
        "536870912x1=0",
        "-536870912x1=0",
        "99999999999x1=0",
        "400000000x1+400000000x1=0",
    ] {
        let refused = requirement(wrong);
        let message = refused.expect_err(wrong);
        assert!(message.contains("expected"), "{wrong}: {message}");
    }
}

/// Whether the prover finds no simplex that crosses it.
fn is_uncrossed<const D: usize>(tiling: &Tiling<D>, equation: &str) -> bool {
    let options = Options {
        required: vec![requirement(equation).expect("an equation")],
        ..Options::default()
    };
    match examine(tiling, &options, &|_| ()) {
        Ok(proof) => {
            let is_stated = |s: &Statement| matches!(s, Statement::UncrossedPlane(_));
            assert!(proof.statements.iter().any(is_stated), "{equation}");
            true
        }
        Err(findings) => {
            assert!(
                findings
                    .counts()
                    .keys()
                    .all(|code| *code == "plane-crossed"),
                "{equation}"
            );
            false
        }
    }
}

/// In each of Kuhn's tetrahedra of a unit cube the coordinates have one order. So none crosses an integer
/// plane x_i = k or x_i - x_j = k. Every other plane that meets the inside of the cube crosses one.
/// Translates of a plane belong to it.
#[test]
fn kuhn_tetrahedra_have_six_families_of_mirrors() {
    let Ok(AnyTiling::Space(tiling)) = catalog::build("cube-6") else {
        panic!("a tiling of space");
    };
    for (equation, expected) in [
        ("x1=0", true),
        ("x1=7", true),
        ("x1=-7", true),
        ("-x3=2", true),
        ("x1=1/2", false),
        ("x1=1/1000000000", false),
        ("x1-x2=0", true),
        ("x2-x1=3", true),
        ("x1-x2=1/2", false),
        ("x1+x2=0", false),
        ("x1+x2-x3=0", false),
        // Twice the height of x1 = 0: the step between translates is one, and half of them are crossed.
        ("2x1+x2=0", false),
    ] {
        assert_eq!(is_uncrossed(&tiling, equation), expected, "{equation}");
    }
}

/// One tetrahedron, as a region: a plane may have a corner, an edge or a facet in it, and may be far away.
/// Without a lattice there are no translates.
#[test]
fn a_plane_may_touch() {
    let number = |n: i64| Number::from(Rational::from(n));
    let points = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]];
    let vertices: Vec<[Number; 3]> = points.iter().map(|p| p.map(number)).collect();
    let tiling = Tiling {
        frame: Frame::cubic().with_domain(Domain::Region(0)),
        vertices: Coordinates::from(vertices),
        corners: (0..4).map(|vertex: u32| Corner::of(vertex)).collect(),
    };
    for (equation, expected) in [
        ("x1=0", true),
        ("x1+x2+x3=1", true),
        ("x1+x2=0", true),
        ("x1+x2+x3=0", true),
        ("x1=1", true),
        ("x1=2", true),
        ("x1=-1", true),
        ("x1=1/2", false),
        ("x1+x2+x3=1/1000000", false),
        ("x1-x2=0", false),
        ("x1+x2+x3=999999/1000000", false),
    ] {
        assert_eq!(is_uncrossed(&tiling, equation), expected, "{equation}");
    }
}

/// A slab has two lattice vectors. The plane x3 = 1/2 is its own translate, and x1 + x3 = 1/2 has others, x1 + x3 = 3/2 among
/// them. Boundary planes are touched only.
#[test]
fn planes_along_lattice_vectors() {
    let Ok(AnyTiling::Space(slab)) = catalog::build("slab") else {
        panic!("a slab");
    };
    assert!(is_uncrossed(&slab, "x3=0"));
    assert!(is_uncrossed(&slab, "x3=71/5"));
    assert!(is_uncrossed(&slab, "x3=-100"));
    assert!(!is_uncrossed(&slab, "x3=1"));
    assert!(!is_uncrossed(&slab, "x1+x3=-100"));
}

/// A plane with a third coordinate is not for a tiling of the plane.
#[test]
fn a_plane_has_the_dimension_of_the_tiling() {
    let Ok(AnyTiling::Plane(tiling)) = catalog::build("equilateral") else {
        panic!("a plane tiling");
    };
    assert!(is_uncrossed(&tiling, "x1=0"));
    let options = Options {
        required: vec![requirement("x3=0").expect("an equation")],
        ..Options::default()
    };
    let refused = examine(&tiling, &options, &|_| ());
    let findings = refused.expect_err("a refusal");
    assert_eq!(
        findings.counts().keys().collect::<Vec<_>>(),
        [&"plane-beyond"]
    );
}

/// No triangle crosses a line through the sides, for all triangles. No certificate of a family can state it,
/// so the prover declines and does not refute.
#[test]
fn families_decline_planes() {
    let entry = catalog::find("triangle-tiling-all").expect("a family");
    let family = entry.build_family().expect("a family").expect("a family");
    let options = Options {
        required: vec![requirement("x1=0").expect("an equation")],
        ..Options::default()
    };
    let result = with_family!(&family, f => family::examine(f, &options, &|_| ()).map(|_| ()));
    assert!(
        matches!(result, Err(NotProvable::Declined(_))),
        "{result:?}"
    );
}
