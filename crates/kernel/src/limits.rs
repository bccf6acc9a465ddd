//! The limits, and the account of the work that was done.
//!
//! A limit declines and never accepts. A certificate that passes under some limits passes under
//! larger ones.

use crate::refusal::{Checked, Limit, Place, Value};
use std::cell::Cell;

/// Upper bounds, each inclusive.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Limits {
    /// Bytes of the certificate.
    pub bytes: u64,
    /// Simplices of the witness.
    pub simplices: u64,
    /// Bits of one integer.
    pub bits: u64,
    /// Degree of the field; the kernel has no more than [`MAX_DEGREE`].
    pub degree: usize,
    /// Units of work for the certificate and again for each MiB of it. A unit is about one
    /// nanosecond: a product of two 64-bit words, or a step along a list.
    pub work: u64,
}

pub const MAX_DEGREE: usize = 8;

impl Limits {
    pub const DEFAULT: Limits = Limits {
        bytes: 1 << 32,
        simplices: 1 << 28,
        bits: 4096,
        degree: MAX_DEGREE,
        work: 3_000_000_000,
    };
}

impl Default for Limits {
    fn default() -> Self {
        Limits::DEFAULT
    }
}

/// The work so far. Each part of the kernel counts what it does, and calls [`Work::check`] at
/// latest after a piece of work that other limits bound.
pub(crate) struct Work {
    spent: Cell<u64>,
    limit: u64,
    bytes: Cell<u64>,
}

impl Work {
    pub(crate) fn new(limits: &Limits) -> Work {
        Work {
            spent: Cell::new(0),
            limit: limits.work,
            bytes: Cell::new(0),
        }
    }

    #[inline(always)]
    pub(crate) fn add(&self, units: u64) {
        self.spent.set(self.spent.get().saturating_add(units));
    }

    /// The reader has taken this many bytes.
    pub(crate) fn set_bytes(&self, bytes: u64) {
        self.bytes.set(bytes);
    }

    #[inline(always)]
    pub(crate) fn check(&self, place: Place) -> Checked {
        let is_within = self.spent.get() <= self.limit || self.is_within_bytes();
        ensure!(is_within, Work, place, Value::Exceeds(Limit::Work, None));
        Ok(())
    }

    #[cold]
    fn is_within_bytes(&self) -> bool {
        let parts = 1 + u128::from(self.bytes.get()) / (1 << 20);
        u128::from(self.spent.get()) <= u128::from(self.limit) * parts
    }
}
