//! The smallest field that some numbers generate.

use acutile_exact::number::{Field, Number, Reader, Subfield};
use malachite::{Integer, Rational};

fn in_one_field(texts: &[&str]) -> (Field, Vec<Number>) {
    let mut reader = Reader::new();
    texts.iter().for_each(|text| reader.learn(text).unwrap());
    let value = |text: &&str| reader.value(text).unwrap();
    (reader.field(), texts.iter().map(value).collect())
}

fn polynomial(field: &Field) -> Vec<i64> {
    let integer = |c: &Integer| i64::try_from(c).expect("small");
    field.polynomial().iter().map(integer).collect()
}

#[test]
fn rationals_in_a_larger_field() {
    let (field, all) = in_one_field(&["sqrt(3)", "1/2", "5"]);
    let subfield = Subfield::of(&field, all[1..].iter());
    assert!(subfield.field.is_rationals());
    assert_eq!(
        subfield.coefficients(&all[1]),
        Some(vec![Rational::from_signeds(1, 2)])
    );
    assert_eq!(subfield.coefficients(&all[0]), None);
    // √3 √3 is written as a rational.
    assert!(
        Subfield::of(&field, [&all[0] * &all[0]].iter())
            .field
            .is_rationals()
    );
}

#[test]
fn the_same_field() {
    let (field, all) = in_one_field(&["(1+sqrt(5))/2", "sqrt(5)"]);
    let subfield = Subfield::of(&field, all.iter());
    assert_eq!(subfield.field, field);
    let coefficients = subfield.coefficients(&all[1]).expect("it is in the field");
    assert_eq!(field.element(coefficients), all[1]);
}

#[test]
fn quadratic_subfields_of_a_field_of_degree_four() {
    let (field, all) = in_one_field(&["sqrt(2)", "sqrt(3)", "sqrt(6)/5 + 7/3", "1/2 - sqrt(8)"]);
    assert_eq!(field.degree(), 4);
    for (index, square) in [(0, 2), (1, 3), (2, 6), (3, 2)] {
        let subfield = Subfield::of(&field, [&all[index]]);
        assert_eq!(polynomial(&subfield.field), [-square, 0, 1], "{index}");
        let coefficients = subfield
            .coefficients(&all[index])
            .expect("it is in the field");
        let value = subfield.field.element(coefficients).approximate();
        assert!((value - all[index].approximate()).abs() < 1e-12, "{index}");
    }
    assert_eq!(Subfield::of(&field, all[..2].iter()).field, field);
    let subfield = Subfield::of(&field, [&all[0]]);
    assert!(!subfield.contains(&all[1]) && !subfield.contains(&all[2]));
    assert!(subfield.contains(&all[3]));
}

/// Q(2^(1/3)) in Q(2^(1/3), √2), of degree 6.
#[test]
fn cubic_subfield() {
    let mut reader = Reader::new();
    let polynomial_of_c = [-2, 0, 0, 1].map(Integer::from);
    let (one, two) = (Rational::from(1), Rational::from(2));
    reader.generator("c", &polynomial_of_c, one, two).unwrap();
    reader.learn("c + sqrt(2)").unwrap();
    let field = reader.field();
    assert_eq!(field.degree(), 6);
    let [c, root] = ["c/3", "sqrt(2)"].map(|text| reader.value(text).unwrap());
    let cubic = Subfield::of(&field, [&c]);
    assert_eq!(cubic.field.degree(), 3);
    let coefficients = cubic.coefficients(&(&c * &c)).expect("it is in the field");
    let value = cubic.field.element(coefficients);
    // (c/3)^6 = 4/729
    let cube = &(&value * &value) * &value;
    assert_eq!(cube, Number::from(Rational::from_signeds(4, 729)));
    assert_eq!(cubic.coefficients(&root), None);
    let quadratic = Subfield::of(&field, [&root]);
    assert_eq!(polynomial(&quadratic.field), [-2, 0, 1]);
}
