//! Products and signs of small elements in 128-bit integers.
//!
//! Most elements of a tiling have short coefficients in a field of low degree. Then machine integers with
//! checked overflow do the same exact work in a fraction of the time. If a value does not fit, the answer
//! is `None`, and [`super::element`] and [`super::sign`] use the general method.

use super::root::Level;
use crate::geometry::Sign;
use malachite::base::num::arithmetic::traits::Gcd;
use malachite::base::num::logic::traits::SignificantBits;
use malachite::{Integer, Natural, Rational};

/// The largest degree that is treated here.
const DEGREE: usize = 8;
/// The bits of the bounds of the generator's powers.
const BITS: u64 = 62;

/// The small data of a field.
pub(super) struct Small {
    degree: usize,
    /// a^n = Σ c a^i for the pairs (i, c).
    reduction: Vec<(usize, i64)>,
    /// Bounds of a^i, all in the same unit.
    powers: Vec<(i64, i64)>,
}

impl Small {
    /// `None` if the degree or a coefficient of the polynomial is too large.
    pub fn new(polynomial: &[Integer], level: &Level) -> Option<Small> {
        let degree = polynomial.len() - 1;
        if degree > DEGREE {
            return None;
        }
        let term = |(i, c): (usize, &Integer)| Some((i, i64::try_from(&-c).ok()?));
        let reduction = polynomial[..degree]
            .iter()
            .enumerate()
            .map(term)
            .collect::<Option<Vec<_>>>()?;
        let longest = level
            .powers()
            .iter()
            .flat_map(|(lo, hi)| [lo.significant_bits(), hi.significant_bits()]);
        let shift = longest.max()?.saturating_sub(BITS);
        // A shift of an integer rounds down.
        let bounds = |(lo, hi): &(Integer, Integer)| {
            let (lo, hi) = (lo >> shift, -(-hi >> shift));
            Some((i64::try_from(&lo).ok()?, i64::try_from(&hi).ok()?))
        };
        let powers = level
            .powers()
            .iter()
            .map(bounds)
            .collect::<Option<Vec<_>>>()?;
        Some(Small {
            degree,
            reduction: reduction.into_iter().filter(|(_, c)| *c != 0).collect(),
            powers,
        })
    }

    /// The coefficients of a product, reduced but not trimmed.
    pub fn product(&self, x: &[Rational], y: &[Rational]) -> Option<Vec<Rational>> {
        let (x, y) = (Scaled::new(x)?, Scaled::new(y)?);
        let mut z = [0i128; 2 * DEGREE];
        for (i, x) in x.numerators().iter().enumerate() {
            for (j, y) in y.numerators().iter().enumerate() {
                z[i + j] = z[i + j].checked_add(i128::from(*x) * i128::from(*y))?;
            }
        }
        for k in (self.degree..2 * self.degree - 1).rev() {
            let top = z[k];
            for (i, c) in self.reduction.iter().filter(|_| top != 0) {
                let low = &mut z[k - self.degree + i];
                *low = low.checked_add(top.checked_mul(i128::from(*c))?)?;
            }
        }
        let denominator = u128::from(x.denominator) * u128::from(y.denominator);
        Some(
            z[..self.degree]
                .iter()
                .map(|n| quotient(*n, denominator))
                .collect(),
        )
    }

    /// The sign, if the bounds of the powers determine it.
    pub fn sign(&self, f: &[Rational]) -> Option<Sign> {
        let f = Scaled::new(f)?;
        let (mut low, mut high) = (0i128, 0i128);
        for (n, (lo, hi)) in f.numerators().iter().zip(&self.powers) {
            let (lo, hi) = if *n >= 0 { (lo, hi) } else { (hi, lo) };
            low = low.checked_add(i128::from(*n) * i128::from(*lo))?;
            high = high.checked_add(i128::from(*n) * i128::from(*hi))?;
        }
        (low.signum() == high.signum() && low != 0).then(|| low.cmp(&0))
    }
}

/// Numerators over a common denominator.
struct Scaled {
    numerators: [i64; DEGREE],
    length: usize,
    denominator: u64,
}

impl Scaled {
    fn new(c: &[Rational]) -> Option<Scaled> {
        if c.len() > DEGREE {
            return None;
        }
        let denominator_of = |c: &Rational| u64::try_from(c.denominator_ref()).ok();
        let mut denominator = 1u64;
        for c in c {
            let d = denominator_of(c)?;
            denominator = denominator.checked_mul(d / denominator.gcd(d))?;
        }
        let mut numerators = [0; DEGREE];
        for (n, c) in numerators.iter_mut().zip(c) {
            let size = i64::try_from(u64::try_from(c.numerator_ref()).ok()?).ok()?;
            let scale = i64::try_from(denominator / denominator_of(c)?).ok()?;
            let size = size.checked_mul(scale)?;
            *n = if *c < 0 { -size } else { size };
        }
        Some(Scaled {
            numerators,
            length: c.len(),
            denominator,
        })
    }

    fn numerators(&self) -> &[i64] {
        &self.numerators[..self.length]
    }
}

fn quotient(n: i128, d: u128) -> Rational {
    let common = n.unsigned_abs().gcd(d);
    let (size, d) = (n.unsigned_abs() / common, d / common);
    if d == 1 {
        return Rational::from(Integer::from_sign_and_abs(n >= 0, Natural::from(size)));
    }
    Rational::from_sign_and_naturals(n >= 0, Natural::from(size), Natural::from(d))
}
