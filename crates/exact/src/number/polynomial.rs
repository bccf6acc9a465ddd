//! Dense polynomials in one variable over the rationals, as slices.
//!
//! Coefficients stand in order of growing degree, the last one is not zero, and
//! the zero polynomial is empty. This is what algebraic numbers need and no
//! more: Euclid's algorithm, squarefree parts, and the count of real roots by
//! Sturm's theorem.

use super::over_common_denominator;
use crate::geometry::Sign;
use malachite::base::num::arithmetic::traits::{DivExact, Gcd, Reciprocal, Sign as _};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::{Integer, Natural, Rational};
use std::cmp::Ordering;

/// Removes the zeros at the end.
pub(super) fn trim(p: &mut Vec<Rational>) {
    while p.last().is_some_and(|c| *c == 0) {
        p.pop();
    }
}

/// The rational polynomial with the coefficients of `p`, trimmed.
pub(super) fn from_integers(p: &[Integer]) -> Vec<Rational> {
    let mut q: Vec<Rational> = p.iter().map(Rational::from).collect();
    trim(&mut q);
    q
}

/// The product of `p` with the positive rational that makes the coefficients
/// integers without a common divisor.
pub(super) fn primitive(p: &[Rational]) -> Vec<Integer> {
    let (mut numerators, _) = over_common_denominator(p);
    let content = numerators
        .iter()
        .fold(Natural::ZERO, |g, c| g.gcd(c.unsigned_abs_ref()));
    if content > 1 {
        let content = Integer::from(content);
        numerators
            .iter_mut()
            .for_each(|c| *c = (&*c).div_exact(&content));
    }
    numerators
}

/// The sign of p(x): with x = n/d and m = deg p it is the sign of the integer
/// d^m p(x) = Σ p_i n^i d^(m-i).
pub(super) fn sign_at(p: &[Integer], x: &Rational) -> Sign {
    let n = Integer::from_sign_and_abs_ref(*x >= 0, x.numerator_ref());
    let d = Integer::from(x.denominator_ref());
    let mut value = Integer::ZERO;
    let mut power = Integer::ONE;
    for c in p.iter().rev() {
        value = value * &n + c * &power;
        power *= &d;
    }
    value.sign()
}

/// p'
pub(super) fn derivative(p: &[Rational]) -> Vec<Rational> {
    (1u64..)
        .zip(p.iter().skip(1))
        .map(|(i, c)| c * Rational::from(i))
        .collect()
}

/// `p - q`
pub(super) fn subtract(p: &[Rational], q: &[Rational]) -> Vec<Rational> {
    let at = |p: &[Rational], i: usize| p.get(i).cloned().unwrap_or(Rational::ZERO);
    let mut difference: Vec<Rational> = (0..p.len().max(q.len()))
        .map(|i| at(p, i) - at(q, i))
        .collect();
    trim(&mut difference);
    difference
}

/// `p * q`
pub(super) fn multiply(p: &[Rational], q: &[Rational]) -> Vec<Rational> {
    if p.is_empty() || q.is_empty() {
        return Vec::new();
    }
    let mut product = vec![Rational::ZERO; p.len() + q.len() - 1];
    for (i, x) in p.iter().enumerate().filter(|(_, x)| **x != 0) {
        for (j, y) in q.iter().enumerate().filter(|(_, y)| **y != 0) {
            product[i + j] += x * y;
        }
    }
    product
}

/// Quotient and remainder of `p` by `q`, which is not zero.
pub(super) fn divide(p: &[Rational], q: &[Rational]) -> (Vec<Rational>, Vec<Rational>) {
    let mut rest = p.to_vec();
    let mut quotient = vec![Rational::ZERO; (p.len() + 1).saturating_sub(q.len())];
    let Some(lead) = q.last().map(Reciprocal::reciprocal) else {
        return (quotient, rest);
    };
    for i in (0..quotient.len()).rev() {
        let factor = &rest[i + q.len() - 1] * &lead;
        if factor != 0 {
            for (j, c) in q.iter().enumerate() {
                rest[i + j] -= &factor * c;
            }
        }
        quotient[i] = factor;
    }
    trim(&mut rest);
    (quotient, rest)
}

/// The multiple of `p` with leading coefficient 1.
fn monic(mut p: Vec<Rational>) -> Vec<Rational> {
    if let Some(lead) = p.last().map(Reciprocal::reciprocal) {
        p.iter_mut().for_each(|c| *c *= &lead);
    }
    p
}

/// The monic greatest common divisor; empty if both are zero.
pub(super) fn gcd(p: &[Rational], q: &[Rational]) -> Vec<Rational> {
    let (mut p, mut q) = (monic(p.to_vec()), monic(q.to_vec()));
    while !q.is_empty() {
        let (_, rest) = divide(&p, &q);
        p = std::mem::replace(&mut q, monic(rest));
    }
    p
}

/// `u` with u f ≡ 1 modulo `p`, if `f` and `p` have no common factor.
///
/// Euclid's algorithm keeps r ≡ u f modulo p for the last two remainders.
pub(super) fn inverse_modulo(f: &[Rational], p: &[Rational]) -> Option<Vec<Rational>> {
    let (mut r, mut u) = (p.to_vec(), Vec::new());
    let (mut r_next, mut u_next) = (divide(f, p).1, vec![Rational::ONE]);
    while r_next.len() > 1 {
        let scale = r_next.last()?.reciprocal();
        r_next
            .iter_mut()
            .chain(&mut u_next)
            .for_each(|c| *c *= &scale);
        let (quotient, rest) = divide(&r, &r_next);
        let next = subtract(&u, &multiply(&quotient, &u_next));
        (r, u) = (r_next, u_next);
        (r_next, u_next) = (rest, next);
    }
    let unit = r_next.first()?.reciprocal();
    u_next.iter_mut().for_each(|c| *c *= &unit);
    Some(divide(&u_next, p).1)
}

/// p / gcd(p, p'): the same roots, each once. `p` is not zero.
pub(super) fn squarefree(p: &[Rational]) -> Vec<Rational> {
    divide(p, &gcd(p, &derivative(p))).0
}

/// The number of roots of the squarefree `p` in the closed interval [lo, hi].
///
/// Sturm: with p_0 = p, p_1 = p', p_{i+1} = -(p_{i-1} mod p_i), and V(x) the
/// number of sign changes of (p_i(x)) without zeros, (lo, hi] has
/// V(lo) - V(hi) roots. Each p_i may be scaled by a positive number.
pub(super) fn count_roots(p: &[Rational], lo: &Rational, hi: &Rational) -> usize {
    let mut chain = vec![p.to_vec(), derivative(p)];
    while chain[chain.len() - 1].len() > 1 {
        let [.., a, b] = chain.as_slice() else { break };
        let rest = primitive(&divide(a, b).1);
        chain.push(rest.iter().map(|c| Rational::from(-c)).collect());
    }
    let chain: Vec<Vec<Integer>> = chain.iter().map(|p| primitive(p)).collect();
    let at_lo = usize::from(sign_at(&chain[0], lo) == Ordering::Equal);
    at_lo + sign_changes(&chain, lo).saturating_sub(sign_changes(&chain, hi))
}

fn sign_changes(chain: &[Vec<Integer>], x: &Rational) -> usize {
    let mut signs: Vec<Sign> = chain.iter().map(|p| sign_at(p, x)).collect();
    signs.retain(|s| *s != Ordering::Equal);
    signs.windows(2).filter(|pair| pair[0] != pair[1]).count()
}
