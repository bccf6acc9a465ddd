//! What the kernel is willing to spend, in one place.
//!
//! A limit refuses ([`Kind::Declined`](super::Kind)) and never accepts: a
//! certificate that passes under some limits passes under larger ones.

/// Upper bounds, each inclusive: a certificate *at* the bound is looked at.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Limits {
    /// Bytes of the file.
    pub bytes: u64,
    /// Simplices of the witness.
    pub simplices: usize,
    /// Decimal digits of one rational, numerator and denominator together, and
    /// of the common denominator of all coordinates or of the Gram matrix.
    pub digits: usize,
    /// Degree of the polynomial that defines the field.
    pub degree: usize,
    /// Halvings of the root's interval to prove one sign.
    pub bisections: usize,
    /// Word multiplications for one product per simplex; they are counted
    /// before any is made.
    pub work: u64,
}

impl Limits {
    /// The limits of `acutile-verify` without options. Parsing takes up to
    /// about thirty times the bytes in memory; the other bounds leave room for
    /// every tiling of the literature and for a million simplices over Q.
    pub const DEFAULT: Limits = Limits {
        bytes: 128 << 20,
        simplices: 1_000_000,
        digits: 1_000,
        degree: 32,
        bisections: 512,
        work: 30_000_000,
    };
}

impl Default for Limits {
    fn default() -> Self {
        Limits::DEFAULT
    }
}
