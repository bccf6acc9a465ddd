//! The reader against an independent evaluator on random expressions, and on
//! random bytes.

use acutile_exact::number::{ReadErrorKind, Reader, parse_rational};
use num_bigint::BigInt;
use num_rational::Ratio;
use num_traits::{One, Zero};
use proptest::prelude::*;
use std::time::{Duration, Instant};

type BigRational = Ratio<BigInt>;

/// A text and its value, computed while it is made; `None` for a division by 0.
#[derive(Clone, Debug)]
struct Made {
    text: String,
    value: Option<BigRational>,
}

fn literal() -> impl Strategy<Value = Made> {
    (0u64..10_000, 0usize..4, -4i32..4, 0u8..3).prop_map(|(n, places, exponent, style)| {
        let scale = |e: i32| BigRational::from_integer(10.into()).pow(e);
        let value = BigRational::from_integer(n.into());
        let digits = format!("{n:0width$}", width = places + 1);
        let (whole, fraction) = digits.split_at(digits.len() - places);
        let (text, value) = match (style, places) {
            (0, _) | (_, 0) => (n.to_string(), value),
            (1, _) => (
                format!("{whole}.{fraction}"),
                value * scale(-(places as i32)),
            ),
            _ => (
                format!("{whole}.{fraction}e{exponent}"),
                value * scale(exponent - places as i32),
            ),
        };
        Made {
            text,
            value: Some(value),
        }
    })
}

fn expression() -> impl Strategy<Value = Made> {
    literal().prop_recursive(5, 40, 2, |inner| {
        let operation = (inner.clone(), inner.clone(), 0u8..4, any::<bool>());
        let binary = operation.prop_map(|(x, y, operator, blank)| {
            let blank = if blank { " " } else { "" };
            let symbol = ['+', '-', '*', '/'][operator as usize];
            let text = format!("({}){blank}{symbol}{blank}({})", x.text, y.text);
            let value = x.value.zip(y.value).and_then(|(x, y)| match operator {
                0 => Some(x + y),
                1 => Some(x - y),
                2 => Some(x * y),
                _ => (!y.is_zero()).then(|| x / y),
            });
            Made { text, value }
        });
        let power = (inner.clone(), -3i32..4).prop_map(|(x, e)| {
            let text = format!("({})^{e}", x.text);
            let value = x.value.and_then(|x| match e {
                0.. => Some((0..e).fold(BigRational::one(), |p, _| p * &x)),
                _ if x.is_zero() => None,
                _ => Some((e..0).fold(BigRational::one(), |p, _| p / &x)),
            });
            Made { text, value }
        });
        let root = inner.prop_map(|x| {
            let text = format!("sqrt(({})^2)", x.text);
            Made {
                text,
                value: x
                    .value
                    .map(|x| if x < BigRational::zero() { -x } else { x }),
            }
        });
        prop_oneof![6 => binary, 1 => power, 1 => root]
    })
}

/// A sum of products without parentheses, by precedence and from the left.
fn flat() -> impl Strategy<Value = Made> {
    let factor = (1i64..50, any::<bool>());
    let product = prop::collection::vec(factor, 1..5);
    prop::collection::vec((product, any::<bool>()), 1..6).prop_map(|products| {
        let (mut text, mut sum) = (String::new(), BigRational::zero());
        for (i, (factors, minus)) in products.iter().enumerate() {
            text += if *minus {
                "-"
            } else {
                ["+", ""][usize::from(i == 0)]
            };
            let mut product = BigRational::one();
            for (j, (n, divides)) in factors.iter().enumerate() {
                let n_value = BigRational::from_integer((*n).into());
                let divides = *divides && j > 0;
                text += &format!(
                    "{}{n}",
                    if j == 0 {
                        ""
                    } else if divides {
                        "/"
                    } else {
                        "*"
                    }
                );
                product = if divides {
                    product / n_value
                } else {
                    product * n_value
                };
            }
            sum = if *minus { sum - product } else { sum + product };
        }
        Made {
            text,
            value: Some(sum),
        }
    })
}

/// Learning and reading may refuse, but soon and without panic.
fn read_soon(text: &str) -> Result<(), TestCaseError> {
    let begin = Instant::now();
    let mut reader = Reader::new();
    if reader.learn(text).is_ok() {
        prop_assert!(reader.value(text).is_ok());
    }
    prop_assert!(
        begin.elapsed() < Duration::from_secs(20),
        "{text:?} took {:?}",
        begin.elapsed()
    );
    Ok(())
}

proptest! {
    #[test]
    fn independent_evaluator(made in prop_oneof![expression(), flat()]) {
        match (parse_rational(&made.text), made.value) {
            (Ok(x), Some(value)) => prop_assert_eq!(x.to_string(), value.to_string()),
            (Err(error), None) => prop_assert_eq!(error.kind, ReadErrorKind::DivisionByZero),
            (found, value) => prop_assert!(false, "{}: {found:?}, not {value:?}", made.text),
        }
    }

    /// Sums of roots against doubles.
    #[test]
    fn roots_against_doubles(terms in prop::collection::vec((-9i64..=9, 1u64..30), 1..4), c in 1u64..20) {
        let text = terms.iter().map(|(x, d)| format!("({x}-10)*sqrt({d})")).collect::<Vec<_>>().join("-");
        let text = format!("sqrt(({text})^2+{c})");
        let mut sum = 0.0;
        for (i, (x, d)) in terms.iter().enumerate() {
            let term = (*x as f64 - 10.0) * (*d as f64).sqrt();
            sum += if i == 0 { term } else { -term };
        }
        let expected = (sum * sum + c as f64).sqrt();
        let mut reader = Reader::new();
        reader.learn(&text).unwrap();
        let found = reader.value(&text).unwrap().approximate();
        prop_assert!((found - expected).abs() <= 1e-11 * expected, "{text}: {found}, {expected}");
    }

    #[test]
    fn random_characters(text in ".{0,60}") {
        read_soon(&text)?;
    }

    #[test]
    fn random_bytes(bytes in prop::collection::vec(any::<u8>(), 0..60)) {
        read_soon(&String::from_utf8_lossy(&bytes))?;
    }

    #[test]
    fn random_words(words in prop::collection::vec(prop::sample::select(vec![
        "1", "2", "3/4", "0", ".5", "1e3", "e", "+", "-", "*", "/", "^", "^2", "^-1", "(", ")",
        "sqrt(", "sqrt(2)", "sqrt(3)", "sqrt(5)", "sqrt", " ", "a", "²", "10^99", "^999",
    ]), 0..14)) {
        read_soon(&words.concat())?;
    }
}
