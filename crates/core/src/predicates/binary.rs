//! Doubles as integers in one binary unit.

use super::vectors::{Vectors, vectors};
use crate::tiling::Corner;
use crate::tiling::coordinates::decompose;

/// The vectors of a simplex with doubles as coordinates, as integers in the unit
/// 2^e, e given or the greatest that is possible; `None` beyond 95 bits.
pub fn dyadic<const D: usize>(
    points: &[[f64; D]],
    exponent: Option<i32>,
    corners: &[Corner<D>],
    apex: &Corner<D>,
) -> Option<Vectors<i128, D>> {
    let all = || corners.iter().chain([apex]);
    let has_shift = all().any(|corner| corner.shift != [0; D]);
    let doubles = || all().flat_map(|corner| &points[corner.vertex.index()]);
    let least = exponent
        .filter(|e| !has_shift || (-94..=0).contains(e))
        .or_else(|| common_exponent(doubles(), has_shift))?;
    let at = |vertex: usize, k: usize| match decompose(points[vertex][k]) {
        (0, _) => 0,
        (mantissa, exponent) => i128::from(mantissa) << (exponent - least),
    };
    let unit = if has_shift { 1i128 << -least } else { 0 };
    Some(Vectors {
        exponent: least,
        ..vectors(corners, apex, at, unit)
    })
}

/// The greatest e for which these doubles, and 1 if `has_shift`, are multiples of 2^e, if
/// they are less than 2^(e + 95). A shift has 25 bits, so that edges have 126 bits at most.
pub fn common_exponent<'x>(doubles: impl Iterator<Item = &'x f64>, has_shift: bool) -> Option<i32> {
    let (mut least, mut end) = if has_shift {
        (0, 1)
    } else {
        (i32::MAX, i32::MIN)
    };
    for x in doubles.filter(|x| **x != 0.0) {
        let (mantissa, exponent) = decompose(*x);
        let bits = 64 - mantissa.unsigned_abs().leading_zeros();
        least = least.min(exponent);
        end = end.max(exponent + bits as i32);
    }
    match end.checked_sub(least) {
        Some(bits) => (bits <= 95).then_some(least),
        // Nothing but zeros.
        None => Some(0),
    }
}
