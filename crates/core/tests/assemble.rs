//! Numbers and fields as a certificate writes them.

use acutile_core::checker::assemble::{field, number};
use acutile_exact::number::Field;
use acutile_format1::certificate;
use malachite::{Integer, Rational};

#[test]
fn numbers_and_fields() {
    // a^3 = a + 1, the root between 0 and 2
    let polynomial: Vec<Integer> = [-1, -1, 0, 1].map(Integer::from).into();
    let (cubic, a) = Field::adjoin_root(&polynomial, Rational::from(0), Rational::from(2)).unwrap();
    let certificate::Field::Algebraic(written) = field(&cubic) else {
        panic!("not algebraic")
    };
    assert_eq!(written.polynomial, ["-1", "-1", "0", "1"]);
    let coefficients = [(0, 1), (-1, 2), (1, 1)];
    let x = cubic.element(
        coefficients
            .map(|(n, d)| Rational::from_signeds(n, d))
            .into(),
    );
    assert_eq!(
        number(&x),
        certificate::Number(["0", "-1/2", "1"].map(String::from).into())
    );
    assert_eq!(number(&(&a - &a)), certificate::Number(vec!["0".into()]));
    assert_eq!(field(&Field::rationals()), certificate::Field::Rationals);
}
