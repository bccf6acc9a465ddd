//! The signs of the values of a predicate, in two words.

use super::{Metric, Predicate};
use acutile_exact::geometry::{Scalar, Sign, Simplex};

/// Up to 32 signs, in the order of the values.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Signs {
    count: u64,
    negative: u64,
    positive: u64,
}

impl Signs {
    /// The exact signs of a predicate's values.
    pub fn of<S: Scalar, P: Predicate<D>, const D: usize>(
        predicate: &P,
        edges: [[S; D]; D],
        point: &[S; D],
        metric: &Metric<S, D>,
    ) -> Self {
        let mut signs = Signs::default();
        let simplex = Simplex::from_edges(edges);
        predicate.values(&simplex, point, metric, |_, value| {
            let sign = value.sign();
            signs.push(sign == Sign::Less, sign == Sign::Greater);
        });
        signs
    }

    #[inline]
    pub(super) fn push(&mut self, is_negative: bool, is_positive: bool) {
        self.negative |= u64::from(is_negative) << self.count;
        self.positive |= u64::from(is_positive) << self.count;
        self.count += 1;
    }

    #[inline]
    fn all(&self) -> u64 {
        (1 << self.count) - 1
    }

    /// The sign of the first value, and those of the others.
    #[inline]
    pub fn split_first(&self) -> (Signs, Signs) {
        let first = Signs {
            count: 1,
            negative: self.negative & 1,
            positive: self.positive & 1,
        };
        let others = Signs {
            count: self.count - 1,
            negative: self.negative >> 1,
            positive: self.positive >> 1,
        };
        (first, others)
    }

    /// The sign of the value with this index.
    pub fn get(&self, index: usize) -> Sign {
        match (self.negative >> index & 1, self.positive >> index & 1) {
            (0, 0) => Sign::Equal,
            (0, _) => Sign::Greater,
            _ => Sign::Less,
        }
    }

    /// Whether no value is zero.
    #[inline]
    pub fn none_zero(&self) -> bool {
        self.negative | self.positive == self.all()
    }

    /// Whether all values are negative.
    #[inline]
    pub fn all_negative(&self) -> bool {
        self.negative == self.all()
    }

    /// Whether all values are positive.
    #[inline]
    pub fn all_positive(&self) -> bool {
        self.positive == self.all()
    }

    /// Whether no value is positive.
    #[inline]
    pub fn none_positive(&self) -> bool {
        self.positive == 0
    }

    /// Whether no value is negative.
    #[inline]
    pub fn none_negative(&self) -> bool {
        self.negative == 0
    }
}
