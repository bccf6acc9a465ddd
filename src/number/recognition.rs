//! Does a real number lie in a field? Square roots, and roots of polynomials.
//!
//! A square root that is found is squared exactly before it is believed. That
//! there is none is proved by a prime, where the polynomial of the field is
//! irreducible; where it is reducible, the answer "none" may be wrong, and then
//! a field is extended without need, to one with a reducible polynomial.

use super::element::Number;
use super::field::Field;
use super::lattice;
use super::polynomial as poly;
use super::root::Level;
use malachite::base::num::arithmetic::traits::{CheckedSqrt, DivisibleBy, Floor, Mod, PowerOf2};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::{Integer, Natural, Rational};
use std::cmp::Ordering;

/// The search alternates: primes below the first number for a proof that there
/// is no square root, then a search for one with as many bits as the second.
pub const SEARCH_ROUNDS: [(u64, u64); 3] = [(500, 256), (2000, 1024), (8000, 4096)];
/// Lattices with more than this many bits in their dimension times the
/// precision are not searched, because of the time.
pub const LATTICE_LIMIT: u64 = 40_000;

/// Neither a root nor a proof was found within the limits.
#[derive(Debug)]
pub(super) struct Undecided;

/// The root √d >= 0 in `field`, or `None` if there is none, for d >= 0 in it.
/// `steps` are square roots, with their squares first, that made the field.
pub(super) fn square_root(
    field: &Field,
    d: &Number,
    steps: &[(Number, Number)],
) -> Result<Option<Number>, Undecided> {
    if let Some(root) = root_by_steps(d, steps) {
        return Ok(Some(root));
    }
    if field.is_rationals() {
        return Ok(None);
    }
    let mut from = 3;
    for (below, bits) in SEARCH_ROUNDS {
        if has_nonresidue(field, d, from..below) {
            return Ok(None);
        }
        let enclose = |width: &Rational| d.enclosure_of_root(width);
        let is_root = |s: &Number| s * s == *d && s.sign() == Ordering::Greater;
        if let Some(root) = search(field, bits, enclose).filter(is_root) {
            return Ok(Some(root));
        }
        from = below;
    }
    Err(Undecided)
}

/// The generator of `other` as an element of `field`, if a search finds it.
pub(super) fn generator(field: &Field, other: &Field) -> Option<Number> {
    let p = poly::from_integers(other.polynomial());
    let (lo, hi) = other.root();
    let is_generator = |x: &Number| {
        super::extension::at(&p, x).is_zero()
            && *x > Number::from(lo.clone())
            && *x < Number::from(hi.clone())
    };
    SEARCH_ROUNDS.iter().find_map(|(_, bits)| {
        search(field, *bits, |width| other.generator().enclosure(width)).filter(is_generator)
    })
}

/// If d e is the square of a rational number r for a product e of squares of
/// steps, then √d = r/√e. For rational d and steps nothing else is possible
/// (Kummer theory).
fn root_by_steps(d: &Number, steps: &[(Number, Number)]) -> Option<Number> {
    let Some(((square, root), rest)) = steps.split_first() else {
        return rational_root(d.to_rational()?).map(Number::from);
    };
    root_by_steps(d, rest).or_else(|| root_by_steps(&(d * square), rest)?.divide(root))
}

/// √x, if it is rational.
fn rational_root(x: &Rational) -> Option<Rational> {
    let numerator: Natural = x.numerator_ref().checked_sqrt()?;
    let denominator = x.denominator_ref().checked_sqrt()?;
    Some(Rational::from_naturals(numerator, denominator))
}

/// A proof that d is no square in K = Q(a), if p is irreducible: a prime q and a
/// simple root r of p modulo q such that d has no q in its denominators and d(r)
/// is no square modulo q.
///
/// Since r is simple, the ring Z[a], localised at (q, a - r), is a discrete
/// valuation ring with residue field Z/q. It holds d, hence also a square root
/// of d in K, which is integral over it; and modulo the maximal ideal a becomes
/// r, so that d(r) would be a square.
fn has_nonresidue(field: &Field, d: &Number, range: std::ops::Range<u64>) -> bool {
    let (numerators, denominator) = poly::common_denominator(d.coefficients());
    // d times the square of its denominator.
    let numerators: Vec<Integer> = numerators
        .iter()
        .map(|n| n * Integer::from(&denominator))
        .collect();
    let is_prime = |q: &u64| {
        (2..)
            .take_while(|i| i * i <= *q)
            .all(|i| !q.is_multiple_of(i))
    };
    range.filter(is_prime).any(|q| {
        let p = modulo(field.polynomial(), q);
        let slope: Vec<u64> = (1..).zip(&p[1..]).map(|(i, c)| i % q * c % q).collect();
        let d = modulo(&numerators, q);
        let is_witness = |r: u64| {
            value(&p, r, q) == 0
                && value(&slope, r, q) != 0
                && power(value(&d, r, q), (q - 1) / 2, q) == q - 1
        };
        !(&denominator).divisible_by(Natural::from(q)) && (0..q).any(is_witness)
    })
}

fn modulo(p: &[Integer], q: u64) -> Vec<u64> {
    let q = Integer::from(q);
    p.iter()
        .filter_map(|c| u64::try_from(&c.mod_op(&q)).ok())
        .collect()
}

/// p(r) modulo q < 2^32.
fn value(p: &[u64], r: u64, q: u64) -> u64 {
    p.iter().rev().fold(0, |value, c| (value * r + c) % q)
}

/// x^e modulo q < 2^32.
fn power(x: u64, e: u64, q: u64) -> u64 {
    let root = if e > 1 { power(x * x % q, e / 2, q) } else { 1 };
    if e % 2 == 1 { root * x % q } else { root }
}

/// A candidate for the element of `field` that `enclose` encloses: a small
/// integer relation between it and the powers of the generator, as seen with
/// `bits` bits. The caller checks it.
pub(super) fn search(
    field: &Field,
    bits: u64,
    enclose: impl Fn(&Rational) -> (Rational, Rational),
) -> Option<Number> {
    let n = field.degree();
    if (n as u64 + 1) * bits > LATTICE_LIMIT {
        return None;
    }
    let scaled = (enclose(&Rational::power_of_2(-(bits as i64))).0 << bits).floor();
    let level = (0..).find(|j| Level::bits(*j) >= bits)?;
    let shift = Level::bits(level) - bits;
    let powers = field
        .level(level)
        .powers()
        .iter()
        .map(|(lo, _)| lo >> shift);
    let rows = std::iter::once(scaled)
        .chain(powers)
        .enumerate()
        .map(|(i, value)| {
            let mut row = vec![Integer::ZERO; n + 2];
            row[i] = Integer::ONE;
            row[n + 1] = value;
            row
        });
    let relation = lattice::reduce(rows.collect()).swap_remove(0);
    let (first, others) = (&relation[0], &relation[1..=n]);
    if *first == 0 {
        return None;
    }
    let coefficient = |c: &Integer| -Rational::from_integers_ref(c, first);
    Some(field.element(others.iter().map(coefficient).collect()))
}
