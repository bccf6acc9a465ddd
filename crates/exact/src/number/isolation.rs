//! Turns a polynomial and an interval with one root into the data of a field. These are a monic polynomial,
//! and a dyadic interval in which it is monotone around the root.

use super::enclosure::Interval;
use super::error::FieldError;
use super::limits::{DEGREE_LIMIT, ISOLATION_LIMIT, POLYNOMIAL_BITS_LIMIT};
use super::polynomial as poly;
use super::root::Dyadic;
use malachite::base::num::arithmetic::traits::{Ceiling, DivExact, DivisibleBy, Floor, Pow};
use malachite::base::num::basic::traits::One;
use malachite::base::num::logic::traits::SignificantBits;
use malachite::{Integer, Rational};
use std::cmp::Ordering;

/// The checks without arithmetic.
pub(super) fn check_limits(
    polynomial: &[Integer],
    lo: &Rational,
    hi: &Rational,
) -> Result<(), FieldError> {
    let degree = polynomial
        .iter()
        .rposition(|c| *c != 0)
        .ok_or(FieldError::ZeroPolynomial)?;
    if degree == 0 {
        return Err(FieldError::ConstantPolynomial);
    }
    if degree > DEGREE_LIMIT {
        return Err(FieldError::DegreeBeyondLimit(degree));
    }
    let ends = [lo, hi].map(|x| {
        x.numerator_ref()
            .significant_bits()
            .max(x.denominator_ref().significant_bits())
    });
    let bits = polynomial
        .iter()
        .map(SignificantBits::significant_bits)
        .chain(ends)
        .max();
    if let Some(bits) = bits.filter(|bits| *bits > POLYNOMIAL_BITS_LIMIT) {
        return Err(FieldError::SizeBeyondLimit(bits));
    }
    if lo > hi {
        return Err(FieldError::EmptyInterval(lo.clone(), hi.clone()));
    }
    Ok(())
}

/// A monic polynomial whose roots are s times the roots of `p`, and s > 0.
///
/// With l the leading coefficient, s = l works: y = l x is a root of
/// l^(n-1) p(y/l) = Σ p_i l^(n-1-i) y^i. Then s is made smaller by the small
/// primes q for which q^(n-i) divides every coefficient.
pub(super) fn make_monic(mut p: Vec<Integer>) -> (Vec<Integer>, Rational) {
    let n = p.len() - 1;
    if p[n] < 0 {
        p.iter_mut().for_each(|c| *c = -&*c);
    }
    let lead = p[n].clone();
    let mut scale = Rational::from(&lead);
    if lead == 1 {
        return (p, scale);
    }
    p[n] = Integer::ONE;
    let mut power = Integer::ONE;
    for c in p[..n].iter_mut().rev() {
        *c *= &power;
        power *= &lead;
    }
    for q in (2u64..100).map(Integer::from) {
        let powers: Vec<Integer> = (0..=n as u64).map(|i| (&q).pow(n as u64 - i)).collect();
        while p.iter().zip(&powers).all(|(c, q)| c.divisible_by(q)) {
            p.iter_mut()
                .zip(&powers)
                .for_each(|(c, q)| *c = (&*c).div_exact(q));
            scale /= Rational::from(&q);
        }
    }
    (p, scale)
}

/// Where a root is.
pub(super) enum Isolated {
    Integer(Integer),
    Irrational(Dyadic),
}

/// The only root of the monic `p` in [lo, hi]: an integer, or an interval as in [`Field::root`]. A rational
/// root of a monic polynomial is an integer. `None` beyond [`ISOLATION_LIMIT`].
///
/// The interval is the first of k/2^e to (k+1)/2^e, e = 0, 1, …, that contains the root and in which
/// interval arithmetic excludes a zero of the derivative. There p is monotone and has no other root.
pub(super) fn isolate(p: &[Integer], lo: &Rational, hi: &Rational) -> Option<Isolated> {
    let (at_lo, at_hi) = (poly::sign_at(p, lo), poly::sign_at(p, hi));
    for (x, sign) in [(lo, at_lo), (hi, at_hi)] {
        if sign == Ordering::Equal {
            return Integer::try_from(x).ok().map(Isolated::Integer);
        }
    }
    // The sign that p would have without its other roots.
    let sign = |x: &Rational| match x {
        x if x <= lo => at_lo,
        x if x >= hi => at_hi,
        x => poly::sign_at(p, x),
    };
    let (mut low, mut high) = (lo.floor(), hi.ceiling());
    while &high - &low > 1 {
        let middle = (&low + &high) >> 1u64;
        match sign(&Rational::from(&middle)) {
            Ordering::Equal => return Some(Isolated::Integer(middle)),
            s if s == at_lo => low = middle,
            _ => high = middle,
        }
    }
    for bits in 0..ISOLATION_LIMIT {
        let candidate = Dyadic {
            low: low.clone(),
            high: &low + Integer::ONE,
            bits,
        };
        if isolates(p, &candidate) {
            return Some(Isolated::Irrational(candidate));
        }
        low <<= 1u64;
        let middle = &low + Integer::ONE;
        if sign(&(Rational::from(&middle) >> (bits + 1))) == at_lo {
            low = middle;
        }
    }
    None
}

/// Whether the interval is as [`Field::root`] says.
pub(super) fn isolates(p: &[Integer], interval: &Dyadic) -> bool {
    let (lo, hi) = interval.ends();
    let signs = (poly::sign_at(p, &lo), poly::sign_at(p, &hi));
    let slope: Vec<Integer> = (1u64..)
        .zip(&p[1..])
        .map(|(i, c)| c * Integer::from(i))
        .collect();
    signs.0 == signs.1.reverse()
        && signs.0 != Ordering::Equal
        && !Interval { lo, hi }.horner(&slope).contains_zero()
}
