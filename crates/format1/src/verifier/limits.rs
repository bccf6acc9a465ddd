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
    /// Word multiplications for one product per simplex, and 64 times as many
    /// for all signs together; they are counted before they are made.
    pub work: u64,
}

impl Limits {
    /// A simplex takes some dozens of signs, most of them at the first enclosure.
    pub(super) const SIGNS: u64 = 64;

    /// The limits of `acutile-verify` without options. A hostile file may take up to about
    /// thirty times its bytes in memory, here one GiB; 80,000 tetrahedra of A15
    /// are 10 MB in JSON and 6 MB in CBOR. The other bounds leave room for
    /// every tiling of the literature and for a million simplices over Q.
    pub const DEFAULT: Limits = Limits {
        bytes: 32 << 20,
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
