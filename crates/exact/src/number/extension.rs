//! Larger fields: K(y) for a square root, or for a root of another polynomial.
//!
//! With K = Q(a), p(a) = 0 of degree n, and y^m = r_0 + … + r_(m-1) y^(m-1) over K, the ring A = Q[x]/(p)
//! [y] has dimension n m over Q. For small k the element t = y + k a generates it; its minimal polynomial,
//! and a in terms of t, come from one system of linear equations. Every equation in A also holds for the
//! real numbers, even if A is no field.

use super::element::Number;
use super::error::FieldError;
use super::field::Field;
use super::limits::{DEGREE_LIMIT, MINOR_BITS_LIMIT};
use super::over_common_denominator;
use super::polynomial as poly;
use malachite::base::num::arithmetic::traits::{DivExact, DivisibleBy, Gcd, Pow};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::num::logic::traits::SignificantBits;
use malachite::{Integer, Natural, Rational};

/// Square factors are sought among the primes below this.
const SQUARE_FACTOR_LIMIT: u64 = 10_000;
/// The values of k for which y + k a is tried as a generator: for each pair of
/// roots of different factors one k fails at most.
const MULTIPLIERS: std::ops::Range<i64> = 0..1000;

/// A field that contains another one.
pub(super) struct Extension {
    pub field: Field,
    /// The generator of the smaller field.
    pub old: Number,
    /// The number that was adjoined.
    pub new: Number,
}

impl Extension {
    /// An element of the smaller field in the larger one.
    pub fn embed(&self, x: &Number) -> Number {
        if x.is_rational() {
            x.clone()
        } else {
            at(x.coefficients(), &self.old)
        }
    }
}

/// Σ c_i x^i
pub(super) fn at(coefficients: &[Rational], x: &Number) -> Number {
    let zero = Number::zero();
    coefficients
        .iter()
        .rev()
        .fold(zero, |value, c| value * x + Number::from(c.clone()))
}

/// K(√d) for d > 0 in K.
///
/// √d = (u/v) √e with e an algebraic integer, so that the generator is one.
pub(super) fn adjoin_square_root(field: &Field, d: &Number) -> Result<Extension, FieldError> {
    let whole = without_zeros_of(field, d)?;
    let d = whole.element(d.coefficients().to_vec());
    let (e, factor) = square_class(&d);
    let enclose = |width: &Rational| e.enclosure_of_root(width);
    let extension = adjoin(&whole, &[e.clone(), Number::zero()], enclose)?;
    let new = &extension.new * Number::from(factor);
    Ok(Extension { new, ..extension })
}

/// The same field, with a polynomial that has no factor in common with that of d. Such a factor does not
/// vanish at the generator, because d does not.
fn without_zeros_of(field: &Field, d: &Number) -> Result<Field, FieldError> {
    let p = poly::from_integers(field.polynomial());
    let common = poly::gcd(d.coefficients(), &p);
    if common.len() <= 1 || field.is_rationals() {
        return Ok(field.clone());
    }
    let rest = poly::primitive(&poly::divide(&p, &common).0);
    Field::from_enclosure(rest, |width| field.generator().enclosure(width))
}

/// (e, f) with d = e f², f > 0 rational, and the coefficients of e integers
/// without a common square factor among small primes.
fn square_class(d: &Number) -> (Number, Rational) {
    let (numerators, denominator) = over_common_denominator(d.coefficients());
    let content = numerators
        .iter()
        .fold(Natural::ZERO, |g, n| g.gcd(n.unsigned_abs_ref()));
    // d = (content/denominator) · primitive = content·denominator / denominator² · primitive
    let (square, free) = split_square(&content, &denominator);
    let content = Integer::from(content);
    let e = numerators
        .iter()
        .map(|n| Rational::from(n.div_exact(&content) * Integer::from(&free)));
    let e = match d.field() {
        Some(field) => field.element(e.collect()),
        None => Number::from(e.sum::<Rational>()),
    };
    (e, Rational::from_naturals(square, denominator))
}

/// (s, f) with x y = s² f.
pub(super) fn split_square(x: &Natural, y: &Natural) -> (Natural, Natural) {
    let (mut square, mut free) = (Natural::ONE, x * y);
    for q in (2..SQUARE_FACTOR_LIMIT).map(Natural::from) {
        let q_squared = (&q).pow(2);
        if q_squared > free {
            break;
        }
        while (&free).divisible_by(&q_squared) {
            free = free.div_exact(&q_squared);
            square *= &q;
        }
    }
    (square, free)
}

/// K(y) for the y that `enclose` encloses, with y^m = Σ relation_j y^j, the
/// relation's coefficients algebraic integers and its roots distinct.
pub(super) fn adjoin(
    field: &Field,
    relation: &[Number],
    enclose: impl Fn(&Rational) -> (Rational, Rational),
) -> Result<Extension, FieldError> {
    let degree = field.degree() * relation.len();
    if degree > DEGREE_LIMIT {
        return Err(FieldError::DegreeBeyondLimit(degree));
    }
    for k in MULTIPLIERS {
        let k = Rational::from(k);
        let Some((polynomial, old)) = primitive_element(field, relation, &k)? else {
            continue;
        };
        let a = field.generator();
        let larger = Field::from_enclosure(polynomial, |width| {
            let half = width / (Rational::from(2) * (Rational::ONE + &k));
            let (y, a) = (enclose(&half), a.enclosure(&half));
            (y.0 + &k * a.0, y.1 + &k * a.1)
        })?;
        let old = larger.element(old);
        let new = larger.generator() - Number::from(k) * &old;
        return Ok(Extension {
            field: larger,
            old,
            new,
        });
    }
    Err(FieldError::NoGenerator)
}

/// A minimal polynomial, and the coefficients of the old generator in powers of the new.
type Primitive = (Vec<Integer>, Vec<Rational>);

/// The minimal polynomial of t = y + k a and the coefficients of a in the powers
/// of t, if t generates the ring.
fn primitive_element(
    field: &Field,
    relation: &[Number],
    k: &Rational,
) -> Result<Option<Primitive>, FieldError> {
    let Some(columns) = powers(field, relation, k) else {
        return Ok(None);
    };
    let bits = minor_bits(&columns);
    if bits > MINOR_BITS_LIMIT {
        return Err(FieldError::ExtensionBeyondLimit(bits));
    }
    let Some([top, old]) = solve(columns) else {
        return Ok(None);
    };
    let integer = |c: &Rational| Integer::try_from(-c).ok();
    let polynomial: Option<Vec<Integer>> = top.iter().map(integer).collect();
    Ok(polynomial.map(|mut polynomial| {
        polynomial.push(Integer::ONE);
        (polynomial, old)
    }))
}

/// The coordinates of 1, t, …, t^N and of a, for t = y + k a, with respect to the N = nm
/// products of powers of a and y: integers, for those of the relation are.
fn powers(field: &Field, relation: &[Number], k: &Rational) -> Option<Vec<Vec<Integer>>> {
    let (n, m) = (field.degree(), relation.len());
    let coordinates = |v: &[Number]| -> Option<Vec<Integer>> {
        let padded = |x: &Number| {
            let c = x.coefficients().to_vec();
            c.into_iter()
                .chain(std::iter::repeat(Rational::ZERO))
                .take(n)
        };
        v.iter()
            .flat_map(padded)
            .map(|c| Integer::try_from(c).ok())
            .collect()
    };
    let ka = Number::from(k.clone()) * field.generator();
    let mut power = vec![Number::zero(); m];
    power[0] = Number::from(Rational::ONE);
    let mut columns = Vec::with_capacity(n * m + 2);
    for _ in 0..n * m {
        columns.push(coordinates(&power)?);
        power = times_generator(&power, relation, &ka);
    }
    columns.push(coordinates(&power)?);
    let mut a = vec![Number::zero(); m];
    a[0] = field.generator();
    columns.push(coordinates(&a)?);
    Some(columns)
}

/// (y + ka) v for v = Σ v_j y^j.
fn times_generator(v: &[Number], relation: &[Number], ka: &Number) -> Vec<Number> {
    let Some(top) = v.last() else {
        return Vec::new();
    };
    let term = |j: usize| {
        let low = top * &relation[j] + &v[j] * ka;
        if j == 0 { low } else { low + &v[j - 1] }
    };
    (0..v.len()).map(term).collect()
}

/// The coordinates of the last two of N + 2 columns in terms of the first N, by
/// elimination without fractions (Bareiss, Math. Comp. 22, 1968): every entry stays a
/// minor of the matrix, and the division by the pivot before is exact. `None` if the
/// first N are dependent.
fn solve(columns: Vec<Vec<Integer>>) -> Option<[Vec<Rational>; 2]> {
    let n = columns.len() - 2;
    let row = |i: usize| columns.iter().map(|column| column[i].clone()).collect();
    let mut rows: Vec<Vec<Integer>> = (0..n).map(row).collect();
    let mut before = Integer::ONE;
    for i in 0..n {
        let pivot = (i..n).find(|j| rows[*j][i] != 0)?;
        rows.swap(i, pivot);
        let pivot_row = rows[i].clone();
        let others = rows.iter_mut().enumerate().filter(|(j, _)| *j != i);
        for (_, row) in others {
            let factor = row[i].clone();
            for (x, y) in row.iter_mut().zip(&pivot_row) {
                *x = (&*x * &pivot_row[i] - &factor * y).div_exact(&before);
            }
        }
        before = pivot_row[i].clone();
    }
    // Every diagonal entry is now the determinant.
    let quotient = |j: usize, i: usize| Rational::from_integers_ref(&rows[i][j], &rows[i][i]);
    let column = |j: usize| (0..n).map(|i| quotient(j, i)).collect();
    Some([column(n), column(n + 1)])
}

/// About the bits of the largest minor (Hadamard).
fn minor_bits(columns: &[Vec<Integer>]) -> u64 {
    let largest = |column: &Vec<Integer>| column.iter().map(|x| x.significant_bits()).max();
    columns.iter().filter_map(largest).sum()
}
