//! Dense polynomials in one parameter over a field: Euclid's algorithm and Sturm's theorem.
//!
//! Coefficients stand in order of growing degree, the last one is not zero, and the polynomial 0 is
//! empty. The file `number/polynomial.rs` does the same over the rationals alone, for the fields
//! themselves.

use super::{Coefficient, Polynomial};
use crate::geometry::{RingElement, Sign};
use crate::number::Number;
use malachite::Rational;

pub type Dense = Vec<Number>;

/// The coefficients of a polynomial in the first parameter.
pub fn of(p: &Polynomial<Number>) -> Dense {
    let mut dense = vec![Number::zero(); p.degree(0) + 1];
    for (monomial, c) in p.terms() {
        dense[monomial.exponent(0)] = c.clone();
    }
    reduced(dense)
}

/// Without zeros at the end, and times a positive number that makes the coefficients short.
fn reduced(mut p: Dense) -> Dense {
    while p.last().is_some_and(Number::is_zero) {
        p.pop();
    }
    Number::reduced(p.iter().collect())
}

/// p(x)
pub fn value(p: &[Number], x: &Number) -> Number {
    p.iter()
        .rev()
        .fold(Number::zero(), |value, c| value * x + c)
}

/// p(-x)
pub fn mirrored(p: &[Number]) -> Dense {
    let signs = p.iter().enumerate();
    signs
        .map(|(k, c)| if k % 2 == 1 { -c } else { c.clone() })
        .collect()
}

fn derivative(p: &[Number]) -> Dense {
    let terms = (1..).zip(p.iter().skip(1));
    reduced(terms.map(|(k, c)| c * c.integer(k)).collect())
}

/// The quotient of p by q, and the remainder.
fn divide(p: &[Number], q: &[Number]) -> (Dense, Dense) {
    let mut rest = p.to_vec();
    let mut quotient = vec![Number::zero(); (p.len() + 1).saturating_sub(q.len())];
    let Some(lead) = q.last().and_then(Number::inverse) else {
        return (quotient, rest);
    };
    for k in (0..quotient.len()).rev() {
        let factor = &rest[k + q.len() - 1] * &lead;
        for (place, c) in rest[k..].iter_mut().zip(q) {
            *place = &*place - &factor * c;
        }
        quotient[k] = factor;
    }
    (reduced(quotient), reduced(rest))
}

/// A positive multiple of the remainder of p by q.
pub fn remainder(p: &[Number], q: &[Number]) -> Dense {
    divide(p, q).1
}

fn gcd(p: &[Number], q: &[Number]) -> Dense {
    let (mut p, mut q) = (p.to_vec(), q.to_vec());
    while !q.is_empty() {
        let rest = remainder(&p, &q);
        p = std::mem::replace(&mut q, rest);
    }
    p
}

/// Squarefree polynomials without common roots, whose roots are those of the given ones. Each given
/// one is a multiple of those that have a root in common with it.
pub fn coprime(polynomials: &[Dense]) -> Vec<Dense> {
    let mut factors: Vec<Dense> = Vec::new();
    for p in polynomials.iter().filter(|p| p.len() > 1) {
        let mut rest = divide(p, &gcd(p, &derivative(p))).0;
        let mut split = Vec::new();
        for factor in factors {
            let common = gcd(&factor, &rest);
            if common.len() < 2 {
                split.push(factor);
                continue;
            }
            rest = divide(&rest, &common).0;
            let other = divide(&factor, &common).0;
            split.extend([common, other].into_iter().filter(|f| f.len() > 1));
        }
        split.extend(Some(rest).filter(|rest| rest.len() > 1));
        factors = split;
    }
    factors
}

/// A squarefree polynomial that is not constant, with its Sturm chain: p, p', and each further one
/// minus the remainder of the two before.
#[derive(Clone, Debug)]
pub struct Factor {
    chain: Vec<Dense>,
}

impl Factor {
    pub fn new(p: Dense) -> Self {
        let mut chain = vec![p.clone(), derivative(&p)];
        while let [.., a, b] = chain.as_slice()
            && b.len() > 1
        {
            let rest = remainder(a, b);
            chain.push(rest.iter().map(|c| -c).collect());
        }
        Factor { chain }
    }

    pub fn polynomial(&self) -> &[Number] {
        &self.chain[0]
    }

    pub fn sign_at(&self, x: &Number) -> Sign {
        value(&self.chain[0], x).sign()
    }

    /// The number of roots in (low, high], by Sturm's theorem.
    pub fn count(&self, low: &Number, high: &Number) -> usize {
        self.changes(low).saturating_sub(self.changes(high))
    }

    fn changes(&self, x: &Number) -> usize {
        let signs = self.chain.iter().map(|p| value(p, x).sign());
        let signs: Vec<Sign> = signs.filter(|sign| sign.is_ne()).collect();
        signs.windows(2).filter(|pair| pair[0] != pair[1]).count()
    }

    /// No root is larger: 1 + max |c_k / c_n|, rounded up.
    pub fn bound(&self) -> Number {
        let p = self.polynomial();
        let lead = p
            .last()
            .and_then(Number::inverse)
            .unwrap_or_else(Number::zero);
        let ratios = p.iter().map(|c| (c * &lead).abs());
        let largest = ratios.max().unwrap_or_else(Number::zero);
        let (_, above) = largest.enclosure(&Rational::from(1));
        Number::from(above + Rational::from(1))
    }
}
