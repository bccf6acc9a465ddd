//! Radius-edge ratios and dihedral angles against classical formulas, and their closed forms.

use acutile_core::quality::{
    DihedralAngle, Exact, RadiusEdge, rounded_down, rounded_nearest, rounded_up,
};
use acutile_exact::geometry::Simplex;
use acutile_exact::number::{Number, numbers};
use malachite::Rational;
use proptest::prelude::*;

fn unit() -> [[Number; 3]; 3] {
    std::array::from_fn(|i| {
        std::array::from_fn(|j| Number::from(Rational::from(i32::from(i == j))))
    })
}

fn simplex(corners: [[i64; 3]; 4]) -> Simplex<Number, 3> {
    Simplex::new(&corners.map(|p| p.map(|x| Number::from(Rational::from(x)))))
}

fn angles(corners: [[i64; 3]; 4]) -> Vec<DihedralAngle> {
    let products = simplex(corners).normal_products(&unit());
    let mut angles: Vec<_> = products
        .pairs()
        .map(|(i, j, _)| DihedralAngle::between(&products, i, j).expect("it is not flat"))
        .collect();
    angles.sort();
    angles
}

fn forms(corners: [[i64; 3]; 4]) -> Vec<String> {
    angles(corners)
        .iter()
        .map(|angle| angle.closed_form().expect("a closed form"))
        .collect()
}

/// By hand: the regular tetrahedron, the corner and the path tetrahedron of a cube.
#[test]
fn closed_forms_of_known_tetrahedra() {
    let regular = [[0, 0, 0], [1, 1, 0], [1, 0, 1], [0, 1, 1]];
    assert_eq!(forms(regular), ["arccos(1/3)"; 6]);
    assert_eq!(
        RadiusEdge::of(&simplex(regular), &unit())
            .unwrap()
            .closed_form()
            .as_deref(),
        Some("√(3/8)")
    );
    let corner = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]];
    let arccos = "arccos(√(1/3))";
    assert_eq!(forms(corner), [arccos, arccos, arccos, "90", "90", "90"]);
    let path = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [1, 1, 1]];
    assert_eq!(forms(path), ["45", "45", "60", "90", "90", "90"]);
    assert_eq!(
        RadiusEdge::of(&simplex(path), &unit())
            .unwrap()
            .closed_form()
            .as_deref(),
        Some("√(3/4)")
    );
}

/// cos 72° = (√5 - 1)/4 and the others from tables of exact values.
#[test]
fn degrees_are_recognised() {
    for (square, degrees) in [
        ("(3-sqrt(5))/8", 72),
        ("(3+sqrt(5))/8", 36),
        ("(5-sqrt(5))/8", 54),
        ("(5+sqrt(5))/8", 18),
        ("(2+sqrt(3))/4", 15),
        ("(2-sqrt(3))/4", 75),
        ("1/4", 60),
        ("1/2", 45),
        ("3/4", 30),
        ("0", 90),
    ] {
        let square = numbers(&[square]).expect("a number").remove(0);
        let angle = DihedralAngle {
            signed_square: square.clone(),
        };
        assert_eq!(angle.rational(), Some(Rational::from(degrees)));
        let supplement = DihedralAngle {
            signed_square: -square,
        };
        assert_eq!(supplement.rational(), Some(Rational::from(180 - degrees)));
    }
    let near = DihedralAngle {
        signed_square: numbers(&["(3-sqrt(5))/8+1e-30"])
            .expect("a number")
            .remove(0),
    };
    assert_eq!(near.rational(), None);
    assert_eq!(near.closed_form(), None);
}

#[test]
fn rounding_has_a_direction() {
    let value = Rational::from_signeds(-12345, 10_000);
    assert_eq!(rounded_down(&value, 2), "-1.24");
    assert_eq!(rounded_up(&value, 2), "-1.23");
    assert_eq!(rounded_nearest(&value, 3), "-1.235");
    assert_eq!(
        rounded_nearest(&Rational::from_signeds(6708, 10_000), 2),
        "0.67"
    );
    assert_eq!(rounded_nearest(&Rational::from_signeds(1, 2), 0), "1");
    assert_eq!(rounded_up(&Rational::from_signeds(1, 3), 1), "0.4");
}

fn double(value: &Rational) -> f64 {
    Number::from(value.clone()).approximate()
}

/// Inside angle between the half-planes at the edge ab, in doubles.
fn dihedral(a: [f64; 3], b: [f64; 3], c: [f64; 3], d: [f64; 3]) -> f64 {
    let minus = |p: [f64; 3], q: [f64; 3]| [p[0] - q[0], p[1] - q[1], p[2] - q[2]];
    let dot = |p: [f64; 3], q: [f64; 3]| p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
    let x = minus(b, a);
    let project = |p: [f64; 3]| {
        let t = dot(p, x) / dot(x, x);
        [p[0] - t * x[0], p[1] - t * x[1], p[2] - t * x[2]]
    };
    let (u, v) = (project(minus(c, a)), project(minus(d, a)));
    (dot(u, v) / (dot(u, u) * dot(v, v)).sqrt())
        .acos()
        .to_degrees()
}

proptest! {
    /// Against the projection along each edge, and Crelle's formula (6 V R)² = s(s-p)(s-q)(s-r) for the
    /// products p, q, r of opposite edges and s = (p+q+r)/2.
    #[test]
    fn measures_of_random_tetrahedra(points in prop::array::uniform4(prop::array::uniform3(-9i64..10))) {
        let shape = simplex(points);
        prop_assume!(!shape.determinant.is_zero());
        let p = points.map(|x| x.map(|x| x as f64));
        let mut expected: Vec<f64> = [(0, 1, 2, 3), (0, 2, 1, 3), (0, 3, 1, 2), (1, 2, 0, 3), (1, 3, 0, 2), (2, 3, 0, 1)]
            .map(|(a, b, c, d)| dihedral(p[a], p[b], p[c], p[d]))
            .into();
        expected.sort_by(f64::total_cmp);
        let width = Rational::from_signeds(1, 1_000_000_000);
        for (angle, expected) in angles(points).iter().zip(expected) {
            let (low, high) = angle.enclosure(&width);
            prop_assert!(low <= high && &high - &low <= width);
            prop_assert!(double(&low) - 1e-6 < expected && expected < double(&high) + 1e-6);
        }
        let edge = |i: usize, j: usize| {
            (0..3).map(|k| (p[i][k] - p[j][k]).powi(2)).sum::<f64>().sqrt()
        };
        let [x, y, z] = [edge(0, 1) * edge(2, 3), edge(0, 2) * edge(1, 3), edge(0, 3) * edge(1, 2)];
        let s = (x + y + z) / 2.0;
        let radius = (s * (s - x) * (s - y) * (s - z)).sqrt() / shape.determinant.approximate().abs();
        let shortest = [edge(0, 1), edge(0, 2), edge(0, 3), edge(1, 2), edge(1, 3), edge(2, 3)]
            .into_iter().fold(f64::INFINITY, f64::min);
        let (low, high) = RadiusEdge::of(&shape, &unit()).unwrap().enclosure(&width);
        prop_assert!(&high - &low <= width);
        let ratio = radius / shortest;
        prop_assert!((double(&low) - ratio).abs() < 1e-6 * ratio);
    }
}

/// Odd multiples of 9 degrees, whose cosines have squares of degree four: s = (1 + cos 2t)/2 with
/// cos 18° = √((5 + √5)/8) and cos 54° = √((5 - √5)/8).
#[test]
fn odd_multiples_of_nine_degrees_are_recognised() {
    for (text, degrees) in [
        ("(1+sqrt((5+sqrt(5))/8))/2", 9),
        ("(1+sqrt((5-sqrt(5))/8))/2", 27),
        ("(1-sqrt((5-sqrt(5))/8))/2", 63),
        ("(1-sqrt((5+sqrt(5))/8))/2", 81),
    ] {
        let values = numbers(&[text]).expect("a number");
        let angle = acutile_core::quality::DihedralAngle {
            signed_square: values[0].clone(),
        };
        assert_eq!(angle.rational(), Some(malachite::Rational::from(degrees)));
    }
}
