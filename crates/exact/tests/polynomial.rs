//! Polynomials in parameters: signs on boxes, and where signs change on a line.

use acutile_exact::geometry::{RingElement, Sign};
use acutile_exact::number::{Number, Reader, numbers};
use acutile_exact::polynomial::line::{Extent, Line, Place};
use acutile_exact::polynomial::{Cuboid, End, Polynomial, Side, bernstein, text};
use malachite::{Integer, Rational};
use proptest::prelude::*;

fn names(names: &[&str]) -> Vec<String> {
    names.iter().map(|name| (*name).to_owned()).collect()
}

fn polynomial(source: &str, parameters: &[&str]) -> Polynomial {
    let mut reader = Reader::new();
    let parameters = names(parameters);
    text::learn(&mut reader, source, &parameters).expect("a polynomial");
    text::read(&reader, source, &parameters).expect("a polynomial")
}

fn number(source: &str) -> Number {
    numbers(&[source]).expect("a number")[0].clone()
}

/// `[0 1)` and the like, one side for each.
fn cuboid(sides: &[&str]) -> Cuboid {
    let side = |text: &&str| {
        let inner = &text[1..text.len() - 1];
        let (low, high) = inner.split_once(' ').expect("two ends");
        Side {
            low: End {
                value: number(low),
                is_open: text.starts_with('('),
            },
            high: End {
                value: number(high),
                is_open: text.ends_with(')'),
            },
        }
    };
    Cuboid {
        sides: sides.iter().map(side).collect(),
    }
}

fn is_positive(p: &str, parameters: &[&str], sides: &[&str]) -> bool {
    let p = polynomial(p, parameters);
    let cuboid = cuboid(sides);
    let found = bernstein::is_positive(&p, &cuboid).expect("a small polynomial");
    if let Some(integers) = cleared(&p) {
        let by_integers = bernstein::is_positive(&integers, &cuboid);
        let ends = cuboid
            .sides
            .iter()
            .flat_map(|side| [&side.low.value, &side.high.value]);
        let is_rational = ends.into_iter().all(Number::is_rational);
        assert_eq!(by_integers, is_rational.then_some(found));
    }
    found
}

fn cleared(p: &Polynomial) -> Option<Polynomial<Integer>> {
    let p = p.reduced();
    let is_integer = |x: &Number| x.to_rational().is_some_and(|x| *x.denominator_ref() == 1);
    p.terms()
        .iter()
        .all(|(_, c)| is_integer(c))
        .then(|| p.map(|c| Integer::try_from(c.coefficients()[0].clone()).expect("an integer")))
}

#[test]
fn text_and_back() {
    let p = polynomial("3*c2/4 - 1 + 2*x^2*(c2 - 1)", &["c2", "x"]);
    assert_eq!(
        p.shown(&names(&["c2", "x"])),
        "2*c2*x^2 + 3/4*c2 - 2*x^2 - 1"
    );
    assert_eq!(p.degree(0), 1);
    assert_eq!(p.degree(1), 2);
    let p = polynomial("sqrt(2)*t - 1/sqrt(2)", &["t"]);
    let shown = p.shown(&names(&["t"]));
    assert_eq!(shown, "(1*a)*t + (-1/2*a)");
    assert!(p.value(&[number("1/2")]).is_zero());
}

#[test]
fn texts_that_are_no_polynomials() {
    let error = |source: &str| {
        let mut reader = Reader::new();
        let parameters = names(&["t"]);
        let read = text::learn(&mut reader, source, &parameters)
            .and_then(|()| text::read(&reader, source, &parameters));
        read.expect_err("no polynomial").to_string()
    };
    assert_eq!(
        error("1/t"),
        "column 2: expected a polynomial in the parameters; 't' stands in a divisor, under a root \
         or in a negative power"
    );
    assert!(error("sqrt(1+t)").starts_with("column 1: expected a polynomial"));
    assert!(error("t^-1").starts_with("column 2: expected a polynomial"));
    assert_eq!(
        error("t^16"),
        "column 2: polynomial of too high degree: 16 in one parameter, expected at most 15"
    );
    assert_eq!(error("t/(1-1)"), "column 2: division by zero");
    assert_eq!(
        error("u"),
        "column 1: found 'u', expected a number like 3/7 or sqrt(2)/4, or a declared name; the parameter is t and \
         there is no generator; to add a parameter, write \"parameters\": {\"u\": [0, 1]} with its ends"
    );
}

#[test]
fn ends_decide_about_zeros_there() {
    assert!(is_positive("t", &["t"], &["(0 1]"]));
    assert!(!is_positive("t", &["t"], &["[0 1]"]));
    assert!(is_positive("t*(1-t)", &["t"], &["(0 1)"]));
    assert!(!is_positive("t*(1-t)", &["t"], &["(0 1]"]));
    assert!(is_positive("t", &["t"], &["(0 sqrt(2)]"]));
    // x y (x + y): zero where x = 0 or y = 0 only.
    let p = "x*y*(x+y)";
    assert!(is_positive(p, &["x", "y"], &["(0 1]", "(0 1]"]));
    assert!(!is_positive(p, &["x", "y"], &["[0 1]", "(0 1]"]));
    // x + y is zero in one corner alone, which an open end leaves out.
    assert!(is_positive("x+y", &["x", "y"], &["(0 1]", "[0 1]"]));
    assert!(!is_positive("x+y", &["x", "y"], &["[0 1]", "[0 1]"]));
    // (x - y)² vanishes inside.
    assert!(!is_positive("(x-y)^2", &["x", "y"], &["(0 1)", "(0 1)"]));
}

#[test]
fn bisection_decides_more() {
    // 4 t² - 4 t + 5/4 has the coefficients 5/4, -3/4, 5/4 on [0, 1], and 5/4, 1/4, 1/4 on [0, 1/2].
    let p = "4*t^2-4*t+5/4";
    assert!(!is_positive(p, &["t"], &["[0 1]"]));
    assert!(is_positive(p, &["t"], &["[0 1/2]"]));
    assert!(is_positive(p, &["t"], &["[1/2 1]"]));
    assert_eq!(
        cuboid(&["(0 1)"]).halves(0),
        [cuboid(&["(0 1/2]"]), cuboid(&["[1/2 1)"])]
    );
}

fn extents(source: &[&str], wanted: &[Sign], at: &str) -> Option<(Extent, Extent)> {
    let polynomials: Vec<Polynomial> = source.iter().map(|p| polynomial(p, &["t"])).collect();
    Line::new(&polynomials).maximal(&number(at), |signs| {
        let pairs = signs.iter().zip(wanted);
        pairs
            .into_iter()
            .all(|(sign, wanted)| sign == wanted || *sign == Sign::Equal && *wanted == Sign::Less)
    })
}

fn shown(extent: &Extent) -> String {
    match extent {
        Extent::Unbounded => "none".to_owned(),
        Extent::At { place, is_open } => {
            let bracket = if *is_open { "open" } else { "closed" };
            match place {
                Place::Number(x) => format!("{bracket} {x}"),
                Place::Root { .. } => {
                    let p = place.polynomial().expect("a root").shown(&names(&["t"]));
                    let (low, high) = place.enclosure();
                    assert!(high - low < number("1/1000000000"));
                    format!("{bracket} {:.6} of {p}", low.approximate())
                }
            }
        }
    }
}

/// (t - 1) (t² - 2) has the roots -√2, 1 and √2; multiplicities and common factors make no difference.
#[test]
fn roots_in_an_interval() {
    let found = |source: &[&str], side: &str, most: usize| -> Vec<String> {
        let polynomials: Vec<Polynomial> = source.iter().map(|p| polynomial(p, &["t"])).collect();
        let roots = Line::new(&polynomials).roots(&cuboid(&[side]).sides[0], most);
        let root = |place: Place| format!("{:.6}", place.enclosure().0.approximate());
        roots.into_iter().map(root).collect()
    };
    let p = "(t-1)^2*(t^2-2)";
    let [low, one, high] = ["-1.414214", "1.000000", "1.414214"];
    assert_eq!(found(&[p], "[-2 2]", 8), [low, one, high]);
    assert_eq!(found(&[p], "[-2 2]", 2), [low, one]);
    assert_eq!(found(&["t-1", "(t^2-2)*(t-1)"], "[0 2]", 8), [one, high]);
    // Ends that belong to the interval, and ends that do not.
    assert_eq!(found(&[p], "[1 7/5]", 8), [one]);
    assert_eq!(found(&[p], "[0 1]", 8), [one]);
    assert!(found(&[p], "(1 7/5]", 8).is_empty());
    assert!(found(&[p], "[0 1)", 8).is_empty());
    assert!(found(&["1", "t^2+1"], "[-5 5]", 8).is_empty());
    // A root in the field, and ends that are irrational.
    assert_eq!(found(&["t^2-2"], "[1 sqrt(2)]", 8).len(), 1);
    assert!(found(&["t^2-2"], "[1 sqrt(2))", 8).is_empty());
}

#[test]
fn maximal_intervals() {
    let interval = |source: &[&str], wanted: &[Sign], at: &str| {
        let (low, high) = extents(source, wanted, at).expect("it holds there");
        [shown(&low), shown(&high)]
    };
    use std::cmp::Ordering::{Greater, Less};
    assert_eq!(interval(&["1-t^2"], &[Greater], "0"), ["open -1", "open 1"]);
    // Less stands for "at most zero" here.
    assert_eq!(
        interval(&["t^2-1"], &[Less], "1/3"),
        ["closed -1", "closed 1"]
    );
    assert_eq!(
        interval(&["2-t^2", "t"], &[Greater, Greater], "1"),
        ["open 0", "open 1.414214 of t^2 - 2"]
    );
    assert_eq!(
        interval(&["t^2-2", "3*t^2-6"], &[Greater, Greater], "2"),
        ["open 1.414214 of t^2 - 2", "none"]
    );
    // A double zero ends a strict condition, and does not end a weak one.
    assert_eq!(interval(&["(t-1)^2"], &[Greater], "0"), ["none", "open 1"]);
    assert_eq!(interval(&["-(t-1)^2"], &[Less], "0"), ["none", "none"]);
    // The point itself is an end.
    assert_eq!(interval(&["-t"], &[Less], "0"), ["closed 0", "none"]);
    // A weak and a strict condition with one root.
    assert_eq!(
        interval(&["t^2-2", "2-t^2"], &[Less, Greater], "0"),
        ["open -1.414214 of t^2 - 2", "open 1.414214 of t^2 - 2"]
    );
    // Rational roots of a polynomial of degree two.
    assert_eq!(
        interval(&["(3*t-1)*(7*t-5)"], &[Less], "1/2"),
        ["closed 1/3", "closed 5/7"]
    );
    assert!(extents(&["t"], &[Greater], "0").is_none());
    // Over Q(√2), the root of a factor of degree one is a number of the field.
    let (_, high) = extents(&["sqrt(2)-t"], &[Greater], "0").expect("it holds there");
    assert!(
        matches!(high, Extent::At { place: Place::Number(x), is_open: true } if &x * &x == number("2"))
    );
}

fn small() -> impl Strategy<Value = Rational> {
    (-6i64..=6, 1i64..=4).prop_map(|(n, d)| Rational::from_signeds(n, d))
}

prop_compose! {
    fn any_polynomial()(
        terms in prop::collection::vec((0u8..4, 0u8..3, small()), 1..7),
    ) -> Polynomial {
        let term = |(i, j, c): (u8, u8, Rational)| (vec![i, j], Number::from(c));
        Polynomial::from_terms(terms.into_iter().map(term))
    }
}

proptest! {
    /// A proved sign holds at all points of a grid that includes the ends which belong to the box.
    #[test]
    fn proved_signs_hold(
        p in any_polynomial(),
        low in [small(), small()],
        open in [any::<bool>(), any::<bool>(), any::<bool>(), any::<bool>()],
    ) {
        let side = |k: usize| Side {
            low: End { value: Number::from(low[k].clone()), is_open: open[2 * k] },
            high: End {
                value: Number::from(&low[k] + Rational::from(1)),
                is_open: open[2 * k + 1],
            },
        };
        let cuboid = Cuboid { sides: vec![side(0), side(1)] };
        let is_positive = bernstein::is_positive(&p, &cuboid) == Some(true);
        let is_nonnegative = bernstein::is_nonnegative(&p, &cuboid) == Some(true);
        prop_assert!(is_nonnegative || !is_positive);
        let corners = cuboid.corners();
        let signs: Vec<Sign> = corners.iter().map(|corner| p.sign_at(corner)).collect();
        prop_assert_eq!(bernstein::corner_signs(&p, &cuboid), Some(signs));
        for i in 0..=8 {
            for j in 0..=8 {
                let at = |k: usize, n: i64| &low[k] + Rational::from_signeds(n, 8);
                let point = [Number::from(at(0, i)), Number::from(at(1, j))];
                if cuboid.contains(&point) {
                    let sign = p.sign_at(&point);
                    prop_assert!(!is_positive || sign == Sign::Greater, "{:?} at {:?}", p, point);
                    prop_assert!(!is_nonnegative || sign != Sign::Less, "{:?} at {:?}", p, point);
                }
            }
        }
    }

    /// Sums, differences and products agree with values at points.
    #[test]
    fn ring_operations(p in any_polynomial(), q in any_polynomial(), x in small(), y in small()) {
        let at = [Number::from(x), Number::from(y)];
        prop_assert_eq!(p.plus(&q).value(&at), p.value(&at) + q.value(&at));
        prop_assert_eq!(p.minus(&q).value(&at), p.value(&at) - q.value(&at));
        prop_assert_eq!(p.times(&q).value(&at), p.value(&at) * q.value(&at));
        prop_assert!(p.minus(&p).is_zero());
        prop_assert_eq!(p.reduced().sign_at(&at), p.sign_at(&at));
    }
}
