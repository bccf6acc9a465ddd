//! Bounds of π, cosines and angles against published digits and against each other.

use acutile_exact::number::enclosure::{acos_degrees, cos_of_degrees, pi};
use acutile_exact::number::{numbers, parse_rational};
use malachite::Rational;
use malachite::base::num::arithmetic::traits::Pow;
use proptest::prelude::*;

fn q(text: &str) -> Rational {
    parse_rational(text).unwrap()
}

/// Whether the bounds lie at most `width` apart around a number with the decimals of `digits`, cut off. The
/// number is between these decimals and one unit of the last place more.
fn check(bounds: (Rational, Rational), digits: &str, width: &Rational) {
    let (lo, hi) = bounds;
    assert!(lo <= hi && &hi - &lo <= *width, "{digits}: too wide");
    let places = digits.split_once('.').unwrap().1.len() as i64;
    let (low, high) = (q(digits), q(digits) + Rational::from(10).pow(-places));
    assert!(
        lo <= high && low <= hi,
        "{digits} is not within {lo} and {hi}"
    );
    assert!(low - width <= lo && hi <= high + width);
}

#[test]
fn published_digits() {
    let width = &q("1e-49");
    check(
        pi(width),
        "3.14159265358979323846264338327950288419716939937510",
        width,
    );
    // acos(1/3), the dihedral angle of the regular tetrahedron.
    let third = q("1/3");
    let acos = acos_degrees(&third, &third, &q("1e-14"));
    check(acos, "70.528779365509308", &q("1e-14"));
    // cos 1° and cos 36° = (1 + √5)/4.
    check(
        cos_of_degrees(&q("1"), &q("1e-20")),
        "0.99984769515639123915",
        &q("1e-20"),
    );
    check(
        cos_of_degrees(&q("36"), &q("1e-20")),
        "0.80901699437494742410",
        &q("1e-20"),
    );
    check(
        cos_of_degrees(&q("144"), &q("1e-20")),
        "-0.80901699437494742411",
        &q("1e-20"),
    );
}

#[test]
fn cosines_of_constructible_angles() {
    let width = q("1e-60");
    for (degrees, text) in [
        ("36", "(1+sqrt(5))/4"),
        ("72", "(sqrt(5)-1)/4"),
        ("45", "sqrt(2)/2"),
        ("-30", "sqrt(3)/2"),
        ("15", "(sqrt(6)+sqrt(2))/4"),
        ("180-22.5", "-sqrt(2+sqrt(2))/2"),
        ("720+108", "(1-sqrt(5))/4"),
    ] {
        let exact = &numbers(&[text]).unwrap()[0];
        let (lo, hi) = cos_of_degrees(&q(degrees), &width);
        assert!(&hi - &lo <= width);
        assert!(
            *exact >= lo.clone().into() && *exact <= hi.clone().into(),
            "{degrees}"
        );
        let (x, y) = exact.enclosure(&width);
        let (lo, hi) = acos_degrees(&x, &y, &q("1e-50"));
        // The principal angle.
        let principal = match degrees {
            "-30" => q("30"),
            "720+108" => q("108"),
            other => q(other),
        };
        assert!(lo < principal && principal < hi && hi - lo < q("1e-40"));
    }
}

#[test]
fn rational_cosines_are_exact() {
    let width = q("1");
    for (degrees, cosine) in [
        ("0", "1"),
        ("60", "1/2"),
        ("90", "0"),
        ("120", "-1/2"),
        ("180", "-1"),
    ] {
        assert_eq!(cos_of_degrees(&q(degrees), &width), (q(cosine), q(cosine)));
        assert_eq!(
            acos_degrees(&q(cosine), &q(cosine), &width),
            (q(degrees), q(degrees))
        );
    }
    assert_eq!(cos_of_degrees(&q("270"), &width), (q("0"), q("0")));
    assert_eq!(acos_degrees(&q("-3"), &q("2"), &width), (q("0"), q("180")));
}

proptest! {
    /// The two functions are inverse to each other: cos(acos(c)) encloses c.
    #[test]
    fn inverse(n in -1000i64..=1000, digits in 1i64..60) {
        let c = Rational::from_signeds(n, 1000);
        let width = Rational::from(10).pow(-digits);
        let (lo, hi) = acos_degrees(&c, &c, &width);
        prop_assert!(&hi - &lo <= width && lo >= 0 && hi <= 180);
        // The cosine falls.
        prop_assert!(cos_of_degrees(&hi, &width).0 <= c);
        prop_assert!(cos_of_degrees(&lo, &width).1 >= c);
    }

    /// Against doubles, which are right to 1e-12 here.
    #[test]
    fn floating_point_twin(n in -1_000_000i64..1_000_000) {
        let degrees = Rational::from_signeds(n, 1000);
        let float = (n as f64 / 1000.0).to_radians().cos();
        let float = Rational::try_from(float).unwrap();
        let (lo, hi) = cos_of_degrees(&degrees, &q("1e-15"));
        prop_assert!(lo <= &float + q("1e-12") && &float - q("1e-12") <= hi);
    }
}
