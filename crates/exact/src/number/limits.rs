//! Limits: numbers beyond them are declined.

/// The longest text of one number, in characters.
pub const TEXT_LIMIT: usize = 4096;
/// The deepest nesting of parentheses and roots.
pub const DEPTH_LIMIT: usize = 50;
/// The most digits of one decimal.
pub const DIGITS_LIMIT: usize = 1000;
/// The largest absolute value of the exponent in `1e3`.
pub const DECIMAL_EXPONENT_LIMIT: i64 = 1000;
/// The largest absolute value of the exponent in `x^3`.
pub const POWER_LIMIT: i64 = 1000;
/// The largest exponent of one parameter in a polynomial.
pub const EXPONENT_LIMIT: usize = 15;
/// No value, also in between, has more bits in all its numerators and
/// denominators together.
pub const BITS_LIMIT: u64 = 65_536;
/// No field has a larger degree.
pub const DEGREE_LIMIT: usize = 32;
/// No coefficient of a defining polynomial, and no numerator or denominator of
/// an interval's end, has more bits (about 1,200 decimal digits).
pub const POLYNOMIAL_BITS_LIMIT: u64 = 4096;
/// A root that is not alone in a dyadic interval of width 2^-this is declined.
pub const ISOLATION_LIMIT: u64 = 1024;
/// No minor of the linear system for a generator may have more bits (estimated):
/// with the largest degree the elimination then takes some seconds.
pub const MINOR_BITS_LIMIT: u64 = 60_000;
/// Lattices with more than this many bits in their dimension times the
/// precision are not searched, because of the time.
pub const LATTICE_LIMIT: u64 = 10_000;
