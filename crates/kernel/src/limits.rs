//! The limits, and the account of the work that was done.
//!
//! A limit declines and never accepts. A certificate that passes under some limits passes under larger ones.

use crate::refusal::{Checked, Place, Value};
use std::cell::Cell;

/// Upper bounds, each inclusive.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Limits {
    /// Bytes of the certificate.
    pub bytes: u64,
    /// Simplices.
    pub simplices: u64,
    /// Bits of one integer.
    pub bits: u64,
    /// Degree of the field; more than 8 means 8.
    pub degree: usize,
    /// Units of work for the certificate, and again for each MiB of it. A unit is about one
    /// nanosecond: a product of two 64-bit words, or a third of a step along a list.
    pub work: u64,
}

pub const MAX_DEGREE: usize = 8;

impl Limits {
    /// The limits of `acutile-verify`.
    pub const DEFAULT: Limits =
        Limits { bytes: 1 << 32, simplices: 1 << 28, bits: 4096, degree: MAX_DEGREE, work: 3_000_000_000 };
}

/// The work so far. Each part of the kernel counts its work, and calls [`Work::check`] after
/// each piece of work that other limits bound.
pub(crate) struct Work {
    limit: u64,
    allowed: Cell<u64>,
    spent: Cell<u64>,
}

impl Work {
    pub(crate) fn new(limit: u64) -> Work {
        Work { limit, allowed: Cell::new(limit), spent: Cell::new(0) }
    }

    pub(crate) fn add(&self, units: u64) {
        self.spent.set(self.spent.get().saturating_add(units));
    }

    /// This many bytes of the certificate have been read.
    pub(crate) fn set_bytes(&self, bytes: u64) {
        self.allowed.set(self.limit.saturating_mul(1 + (bytes >> 20)));
    }

    pub(crate) fn check(&self, place: Place) -> Checked {
        let is_within = self.spent.get() <= self.allowed.get();
        // The work that is left is not known before it is done. The greatest limit is no limit.
        ensure!(is_within, Work, place, Value::Limit("work", Some(u64::MAX)));
        Ok(())
    }
}
