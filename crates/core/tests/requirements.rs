//! Three verdicts: proved, refuted with a witness, and never one for the other.

use acutile_catalog as catalog;
use acutile_core::checker::{Defect, Findings, Options, Proof, examine};
use acutile_core::format::Relation;
use acutile_core::proved::prove;
use acutile_core::quality::{DihedralAngle, compare_with_degrees, cosine_above, cosine_below};
use acutile_core::statement::{Requirement, Statement};
use acutile_core::tiling::{AnyTiling, Coordinates, Corner, Domain, Frame, Tiling};
use acutile_exact::number::{Reader, enclosure, parse_rational};
use malachite::Rational;
use std::cmp::Ordering;

fn space(name: &str) -> Tiling<3> {
    match catalog::build(name) {
        Ok(AnyTiling::Space(tiling)) => tiling,
        _ => panic!("{name} is a tiling of space"),
    }
}

fn decide<const D: usize>(tiling: &Tiling<D>, requirement: &str) -> Result<Proof<D>, Findings> {
    let options = Options {
        required: vec![requirement.parse().unwrap()],
        ..Options::default()
    };
    let examined = examine(tiling, &options, &|_| ());
    if examined.is_ok() {
        let proved = prove(tiling, &options, &|_| ());
        assert!(proved.is_ok(), "{requirement}: {}", proved.unwrap_err());
    }
    examined
}

fn code(result: Result<Proof<3>, Findings>) -> &'static str {
    match result {
        Ok(_) => "proved",
        Err(findings) => findings.counts().keys().next().unwrap(),
    }
}

/// arccos(1/5) = 78.463040967184512… degrees: the largest angle of A15; the smallest is
/// arccos(3/5) = 53.130102354155978… degrees, and the largest radius-edge ratio 1/√2 =
/// 0.70710678118654752….
#[test]
fn bounds_of_a15_at_any_distance() {
    let a15 = space("a15");
    for (requirement, expected) in [
        ("dihedral<78.47", "proved"),
        ("dihedral<78.46304097", "proved"),
        ("dihedral<78.46304096718453", "proved"),
        ("dihedral<78.46304096718452", "proved"),
        ("dihedral<78.46304096718451", "angle-not-below"),
        ("dihedral<78.463040967", "angle-not-below"),
        ("dihedral<60", "angle-not-below"),
        ("dihedral<180", "proved"),
        ("dihedral>53.13", "proved"),
        ("dihedral>53.13010235415597", "proved"),
        ("dihedral>53.13010235415598", "angle-not-above"),
        ("dihedral>60", "angle-not-above"),
        ("dihedral>0.00001", "proved"),
        ("radius-edge<0.7071067811865476", "proved"),
        ("radius-edge<0.7071067811865475", "ratio-not-below"),
        ("delaunay", "proved"),
        ("tcp", "proved"),
        ("acute", "proved"),
        ("tiling", "proved"),
    ] {
        assert_eq!(code(decide(&a15, requirement)), expected, "{requirement}");
    }
}

/// A requirement about degrees gives a statement with a rational cosine that implies it.
#[test]
fn the_statement_implies_the_degrees() {
    let proof = decide(&space("a15"), "dihedral<78.46304097").unwrap();
    let bound = proof
        .statements
        .iter()
        .find_map(|statement| match statement {
            Statement::LargestAngle(Relation::LessThan, angle) => Some(angle.clone()),
            _ => None,
        });
    let bound = bound.expect("the requirement is stated");
    let square = bound.signed_square.to_rational().expect("it is rational");
    // Between cos² 78.46304097° and (1/5)².
    let degrees = parse_rational("78.46304097").unwrap();
    let (_, cosine) = enclosure::cos_of_degrees(&degrees, &parse_rational("1e-40").unwrap());
    assert!(*square >= &cosine * &cosine && *square < Rational::from_signeds(1, 25));
}

/// Angles that are equal to a bound are recognised; others are not taken for equal.
#[test]
fn angles_against_degrees() {
    let angle = |text: &str| {
        let mut reader = Reader::new();
        reader.learn(text).unwrap();
        DihedralAngle {
            signed_square: reader.value(text).unwrap(),
        }
    };
    let degrees = |text: &str| parse_rational(text).unwrap();
    // cos² 36° = (3 + √5)/8, cos² 72° = (3 - √5)/8, cos² 15° = (2 + √3)/4, cos² 22.5° = (2 + √2)/4
    for (square, text) in [
        ("1/4", "60"),
        ("1/2", "45"),
        ("3/4", "30"),
        ("0", "90"),
        ("-1/4", "120"),
        ("(3+sqrt(5))/8", "36"),
        ("(3-sqrt(5))/8", "72"),
        ("-(3-sqrt(5))/8", "108"),
        ("(2+sqrt(3))/4", "15"),
        ("(2+sqrt(2))/4", "22.5"),
        ("(2+sqrt(2+sqrt(2)))/4", "11.25"),
    ] {
        let bound = degrees(text);
        assert_eq!(
            compare_with_degrees(&angle(square), &bound),
            Ordering::Equal,
            "{text}"
        );
        assert_eq!(cosine_above(&angle(square), &bound), None);
        assert_eq!(cosine_below(&angle(square), &bound), None);
        let nearby = parse_rational("1e-30").unwrap();
        let (below, above) = (&bound - &nearby, &bound + &nearby);
        assert_eq!(
            compare_with_degrees(&angle(square), &above),
            Ordering::Less,
            "{text}"
        );
        assert_eq!(
            compare_with_degrees(&angle(square), &below),
            Ordering::Greater,
            "{text}"
        );
        assert!(cosine_above(&angle(square), &above).is_some(), "{text}");
        assert!(cosine_below(&angle(square), &below).is_some(), "{text}");
    }
    // The conjugate of cos² 36°, which the field does not tell from it by its polynomial.
    let other = compare_with_degrees(&angle("(3-sqrt(5))/8"), &degrees("36"));
    assert_eq!(other, Ordering::Greater);
}

/// A sliver over the unit square's diagonal: its angles are about 0.001 degrees.
#[test]
fn a_sliver() {
    let height = 1;
    let size = 100_000;
    let points = vec![[0, 0, 0], [size, 0, 0], [0, size, 0], [size, size, height]];
    let tiling = Tiling {
        frame: Frame::<3>::cubic().with_domain(Domain::Region(0)),
        vertices: Coordinates::from_integers(points, 1).unwrap(),
        corners: (0..4).map(Corner::of).collect(),
    };
    for (requirement, expected) in [
        ("dihedral>0.00001", "proved"),
        ("dihedral>0.0001", "proved"),
        ("dihedral>1", "angle-not-above"),
        ("dihedral<179.9999", "proved"),
        ("dihedral<179", "angle-not-below"),
        ("nonobtuse", "obtuse-angle"),
        ("tcp", "not-tcp"),
        ("delaunay", "proved"),
    ] {
        assert_eq!(
            code(decide(&tiling, requirement)),
            expected,
            "{requirement}"
        );
    }
}

/// A square cut by the diagonal that is not Delaunay, and by the one that is weakly so.
#[test]
fn regions_are_decided_locally() {
    let region = |points: [[i64; 2]; 4]| Tiling {
        frame: Frame::<2>::cubic().with_domain(Domain::Region(0)),
        vertices: Coordinates::from_integers(points.to_vec(), 1).unwrap(),
        corners: [0, 1, 2, 0, 2, 3].map(Corner::of).to_vec(),
    };
    let square = region([[0, 0], [1, 0], [1, 1], [0, 1]]);
    assert!(decide(&square, "weakly-delaunay").is_ok());
    let findings = decide(&square, "delaunay").unwrap_err();
    assert!(findings.counts().contains_key("on-circumsphere"));
    let thin = region([[0, 0], [2, -1], [4, 0], [2, 1]]);
    let findings = decide(&thin, "delaunay").unwrap_err();
    let inside = findings.kept().iter();
    let inside = inside.filter(|defect| matches!(defect, Defect::InsideCircumsphere { .. }));
    assert_eq!(inside.count(), 2, "seen from both sides");
    let good = region([[2, -1], [4, 0], [2, 1], [0, 0]]);
    let proof = decide(&good, "delaunay").unwrap();
    assert!(proof.statements.contains(&Statement::LocallyDelaunay));
    assert!(!proof.statements.contains(&Statement::Delaunay));
}

#[test]
fn requirements_are_read() {
    for text in [
        "acute",
        "dihedral<90",
        "dihedral>1/2",
        "radius-edge<7/10",
        "tcp",
        "tiling",
    ] {
        let requirement: Requirement = text.parse().unwrap();
        assert_eq!(requirement.to_string(), text);
    }
    for text in [
        "",
        "sharp",
        "dihedral<0",
        "dihedral<181",
        "dihedral>x",
        "radius-edge<-1",
    ] {
        assert!(text.parse::<Requirement>().is_err(), "{text}");
    }
}
