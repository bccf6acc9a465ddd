//! Numbers from text: known values, fields that grow or not, every refusal.

use acutile_exact::number::{Number, ReadErrorKind, Reader, numbers, parse_rational};
use malachite::{Integer, Rational};

/// The numbers of `texts`, in one field.
fn read<const N: usize>(texts: [&str; N]) -> [Number; N] {
    numbers(&texts).unwrap().try_into().unwrap()
}

fn degree(texts: &[&str]) -> usize {
    let mut reader = Reader::new();
    texts.iter().for_each(|text| reader.learn(text).unwrap());
    reader.field().degree()
}

fn polynomial(text: &str) -> Vec<Integer> {
    let mut reader = Reader::new();
    reader.learn(text).unwrap();
    reader.field().polynomial().to_vec()
}

fn integers(values: &[i64]) -> Vec<Integer> {
    values.iter().map(|c| Integer::from(*c)).collect()
}

#[test]
fn rationals() {
    for (text, n, d) in [
        ("0.25", 1, 4),
        (".5", 1, 2),
        ("1e-3", 1, 1000),
        ("1.5e3", 1500, 1),
        ("2E+2", 200, 1),
        ("-7/21", -1, 3),
        ("1/2/2", 1, 4),
        ("1 - 2 - 3", -4, 1),
        ("-2^2", -4, 1),
        ("2^-2", 1, 4),
        ("(2/3)^(-3)", 27, 8),
        ("2*(3+4)", 14, 1),
        ("0^0", 1, 1),
        ("007", 7, 1),
        ("sqrt(9/4)", 3, 2),
        ("sqrt(0)", 0, 1),
    ] {
        assert_eq!(
            parse_rational(text),
            Ok(Rational::from_signeds(n, d)),
            "{text}"
        );
    }
}

#[test]
fn golden_ratio() {
    let [phi, square] = read(["(1+sqrt(5))/2", "((1+sqrt(5))/2)^2"]);
    assert_eq!(square, &phi + Number::from(Rational::from(1)));
    assert_eq!(phi.to_string(), "1/2 + 1/2 a");
    assert_eq!(polynomial("(1+sqrt(5))/2"), integers(&[-5, 0, 1]));
}

#[test]
fn fields_extend_when_they_must() {
    assert_eq!(degree(&["1/2"]), 1);
    assert_eq!(
        degree(&["sqrt(2)", "sqrt(8)", "sqrt(1/2)", "sqrt(0.02)"]),
        2
    );
    assert_eq!(degree(&["sqrt(2)", "sqrt(3)"]), 4);
    assert_eq!(degree(&["sqrt(2)", "sqrt(3)", "sqrt(6)", "sqrt(2/3)"]), 4);
    assert_eq!(degree(&["sqrt(6)", "sqrt(10)", "sqrt(15)"]), 4);
    assert_eq!(degree(&["sqrt(3+2*sqrt(2))"]), 2);
    assert_eq!(degree(&["sqrt(2+sqrt(3))"]), 4);
    assert_eq!(degree(&["sqrt(2+sqrt(3))", "sqrt(6)", "sqrt(2)"]), 4);
    assert_eq!(degree(&["sqrt(5-2*sqrt(5))", "sqrt(5+2*sqrt(5))"]), 4);
    assert_eq!(degree(&["sqrt(1+sqrt(2))"]), 4);
    assert_eq!(degree(&["sqrt(1+sqrt(2))", "sqrt(sqrt(2)-1)"]), 4);
    assert_eq!(degree(&["sqrt(2)", "sqrt(3)", "sqrt(5)"]), 8);
}

#[test]
fn known_polynomials() {
    assert_eq!(polynomial("sqrt(2)+sqrt(3)"), integers(&[1, 0, -10, 0, 1]));
    assert_eq!(polynomial("4*sqrt(3)/3"), integers(&[-3, 0, 1]));
    assert_eq!(polynomial("sqrt(12)"), integers(&[-3, 0, 1]));
    // √(10 + 2√5): x^4 - 20 x^2 + 80.
    assert_eq!(
        polynomial("sqrt((5+sqrt(5))/8)"),
        integers(&[80, 0, -20, 0, 1])
    );
}

#[test]
fn known_identities() {
    for (x, y) in [
        ("sqrt(2)*sqrt(3)", "sqrt(6)"),
        ("sqrt(3+2*sqrt(2))", "1+sqrt(2)"),
        ("sqrt(5+2*sqrt(6))", "sqrt(2)+sqrt(3)"),
        // 4 cos 15°, and cos 36° = √((1 + cos 72°)/2).
        ("sqrt(2+sqrt(3))", "(sqrt(6)+sqrt(2))/2"),
        ("sqrt((3+sqrt(5))/8)", "(1+sqrt(5))/4"),
        (
            "1/(sqrt(2)+sqrt(3)+sqrt(5))",
            "(2*sqrt(3)+3*sqrt(2)-sqrt(30))/12",
        ),
        ("sqrt(sqrt(2)+1)*sqrt(sqrt(2)-1)", "1"),
        (
            "sqrt(16-2*sqrt(29)+2*sqrt(55-10*sqrt(29)))",
            "sqrt(22+2*sqrt(5))-sqrt(11+2*sqrt(29))+sqrt(5)",
        ),
    ] {
        let [x_value, y_value] = read([x, y]);
        assert_eq!(x_value, y_value, "{x} = {y}");
    }
}

/// t = tan 27° = √5 - 1 - √(5 - 2√5) = 0.50952544949442881… (literature). From it
/// (t + 1)² = 2√5 t, so t⁴ + 4t³ - 14t² + 4t + 1 = 0; and tan(5·27°) = -1.
#[test]
fn tangent_of_27_degrees() {
    let mut reader = Reader::new();
    reader.learn("sqrt(5)-1-sqrt(5-2*sqrt(5))").unwrap();
    assert_eq!(reader.field().degree(), 4);
    let t = reader.value("sqrt(5)-1-sqrt(5-2*sqrt(5))").unwrap();
    assert_eq!(t.approximate(), 0.5095254494944288);
    let polynomial = |c: &[i64]| {
        let scale = |c: i64| Number::from(Rational::from(c));
        c.iter()
            .rev()
            .fold(Number::zero(), |value, c| value * &t + scale(*c))
    };
    assert!(polynomial(&[1, 4, -14, 4, 1]).is_zero());
    assert_eq!(
        polynomial(&[0, 5, 0, -10, 0, 1]),
        -polynomial(&[1, 0, -10, 0, 5])
    );
}

#[test]
fn generators() {
    let mut reader = Reader::new();
    let q = Rational::from;
    // a³ = 2, then b² = 3, then c = √3 again from a multiple polynomial.
    reader
        .generator("a", &integers(&[-2, 0, 0, 1]), q(1), q(2))
        .unwrap();
    reader
        .generator("b", &integers(&[-3, 0, 1]), q(0), q(2))
        .unwrap();
    assert_eq!(reader.field().degree(), 6);
    reader
        .generator(
            "c",
            &integers(&[12, 0, -7, 0, 1]),
            q(1),
            Rational::from_signeds(19, 10),
        )
        .unwrap();
    assert_eq!(reader.field().degree(), 6);
    reader
        .generator("r", &integers(&[-1, 2]), q(0), q(1))
        .unwrap();
    let value = |text: &str| reader.value(text).unwrap();
    assert_eq!(value("a^3"), value("2"));
    assert_eq!(value("b"), value("c"));
    assert_eq!(value("b^2*r"), value("3/2"));
    assert_eq!(value("sqrt(3)"), value("b"));
    assert_eq!(value("a*b").approximate(), 2f64.cbrt() * 3f64.sqrt());
    let kind = |r: Result<(), acutile_exact::number::ReadError>| r.unwrap_err().kind;
    let taken = kind(reader.generator("a", &integers(&[-5, 0, 1]), q(0), q(3)));
    assert_eq!(taken, ReadErrorKind::NameTaken("a".into()));
    for bad in ["sqrt", "", "1a", "a b", "(a)", "ä"] {
        let refused = kind(reader.generator(bad, &integers(&[-5, 0, 1]), q(0), q(3)));
        assert_eq!(refused, ReadErrorKind::NotAName(bad.into()));
    }
}

/// a = √3 as a root of (x² - 2)(x² - 3): roots of its elements may extend the
/// field without need, but every value stays right.
#[test]
fn roots_over_a_reducible_polynomial() {
    for text in [
        "sqrt(3)",
        "sqrt(a^2-2)",
        "sqrt(a^2)",
        "sqrt(2)*sqrt(6)",
        "sqrt(4+2*a)-1",
    ] {
        let mut reader = Reader::new();
        let p = integers(&[6, 0, -5, 0, 1]);
        reader
            .generator("a", &p, Rational::from_signeds(3, 2), Rational::from(2))
            .unwrap();
        reader.learn(text).unwrap();
        let x = reader.value(text).unwrap();
        let a = reader.value("a").unwrap();
        let one = Number::from(Rational::from(1));
        let expected = match text {
            "sqrt(a^2-2)" => one.clone(),
            "sqrt(2)*sqrt(6)" => &a + &a,
            _ => a.clone(),
        };
        assert_eq!(x, expected, "{text} in {:?}", reader.field());
        assert_eq!((x.clone() - &expected).inverse(), None);
        assert_eq!(&a * &a, &one + &one + &one);
    }
}

#[test]
fn messages() {
    for (text, message) in [
        ("", "column 1: expected a number, found nothing"),
        ("  ", "column 3: expected a number, found nothing"),
        ("1/0", "column 2: division by zero"),
        ("0^-1", "column 2: division by zero"),
        ("1/(sqrt(2)^2-2)", "column 2: division by zero"),
        (
            "0x10",
            "column 2: expected an operator after the number, found 'x'",
        ),
        (
            "1e999999999",
            "column 3: the exponent is beyond the limit of 1000",
        ),
        (
            "1e99999999999999999999999",
            "column 3: the exponent is beyond the limit of 1000",
        ),
        (
            "2^1001",
            "column 3: the exponent is beyond the limit of 1000",
        ),
        (
            "--5",
            "column 2: expected a number, a name or '(', found '-'",
        ),
        (
            "2*-3",
            "column 3: expected a number, a name or '(', found '-'",
        ),
        (
            "+5",
            "column 1: expected a number, a name or '(', found '+'",
        ),
        (
            "٣",
            "column 1: expected a number, a name or '(', found the character U+0663",
        ),
        (
            "1３",
            "column 2: expected an operator or the end, found the character U+FF13",
        ),
        (
            "1,5",
            "column 2: expected an operator or the end, found ','",
        ),
        (
            "NaN",
            "column 1: found 'NaN', expected a number like 3/7 or sqrt(2)/4",
        ),
        (
            "-inf",
            "column 2: found 'inf', expected a number like 3/7 or sqrt(2)/4",
        ),
        (
            "1 2",
            "column 3: expected an operator or the end, found '2'",
        ),
        (
            "5.",
            "column 3: expected a digit after the point, found the end",
        ),
        (
            ".",
            "column 2: expected a digit after the point, found the end",
        ),
        (
            "1.2.3",
            "column 4: expected an operator after the number, found '.'",
        ),
        (
            "1e",
            "column 3: expected the digits of an exponent, found the end",
        ),
        (
            "2^sqrt(2)",
            "column 3: expected an integer exponent, found 's'",
        ),
        (
            "2^3^2",
            "column 4: expected an operator or the end, found '^'",
        ),
        ("sqrt 2", "column 6: expected '(' after sqrt, found '2'"),
        (
            "(1+2",
            "column 5: expected an operator or ')', found the end",
        ),
        ("1)", "column 2: expected an operator or the end, found ')'"),
        (
            "3+sqrt(1-2)",
            "column 3: the square root of the negative number -1",
        ),
        (
            "sqrt(1-sqrt(2))",
            "column 1: the square root of the negative number 1 - a",
        ),
        (
            "(10^1000)^1000",
            "column 10: a value has more bits than the limit of 65536",
        ),
        (
            "1+\u{0}",
            "column 3: expected a number, a name or '(', found the character U+0000",
        ),
    ] {
        assert_eq!(
            Reader::new().learn(text).unwrap_err().to_string(),
            message,
            "{text:?}"
        );
    }
}

#[test]
fn limits() {
    use acutile_exact::number::limits::{DEPTH_LIMIT, DIGITS_LIMIT, TEXT_LIMIT};
    let nested = |n| format!("{}1{}", "(".repeat(n), ")".repeat(n));
    assert!(Reader::new().learn(&nested(DEPTH_LIMIT)).is_ok());
    let error = Reader::new().learn(&nested(DEPTH_LIMIT + 1)).unwrap_err();
    assert_eq!(error.kind, ReadErrorKind::TooDeep);
    assert!(Reader::new().learn(&"7".repeat(DIGITS_LIMIT)).is_ok());
    let error = Reader::new()
        .learn(&"7".repeat(DIGITS_LIMIT + 1))
        .unwrap_err();
    assert_eq!(error.kind, ReadErrorKind::TooManyDigits(DIGITS_LIMIT + 1));
    let long = |n: usize| format!("1{}", " ".repeat(n - 1));
    assert!(Reader::new().learn(&long(TEXT_LIMIT)).is_ok());
    let error = Reader::new().learn(&long(TEXT_LIMIT + 1)).unwrap_err();
    assert_eq!(error.kind, ReadErrorKind::TooLong(TEXT_LIMIT + 1));
}

#[test]
fn degree_limit() {
    let mut reader = Reader::new();
    for d in [2, 3, 5, 7, 11] {
        reader.learn(&format!("sqrt({d})")).unwrap();
    }
    assert_eq!(reader.field().degree(), 32);
    assert_eq!(
        reader.value("sqrt(2310)").unwrap(),
        reader.value("sqrt(2)*sqrt(15)*sqrt(77)").unwrap()
    );
    for (x, y) in [
        ("sqrt(6+2*sqrt(5))", "1+sqrt(5)"),
        ("sqrt(5+2*sqrt(6))", "sqrt(2)+sqrt(3)"),
    ] {
        reader.learn(x).unwrap();
        assert_eq!(reader.value(x).unwrap(), reader.value(y).unwrap());
    }
    assert_eq!(reader.field().degree(), 32);
    assert_eq!(
        reader.learn("1+sqrt(13)").unwrap_err().to_string(),
        "column 3: degree 64 is beyond the limit of 32"
    );
}

#[test]
fn what_was_not_learnt() {
    let mut reader = Reader::new();
    reader.learn("sqrt(2)").unwrap();
    assert_eq!(
        reader.value("1+sqrt(3)").unwrap_err().to_string(),
        "column 3: the square root of 3 does not lie in the field"
    );
    assert!(reader.value("sqrt(18)").is_ok());
}
