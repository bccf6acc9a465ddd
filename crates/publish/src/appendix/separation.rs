//! Linear functions that separate two boundary facets, so that they meet in common corners only.

use super::numeral::Numerals;
use acutile_exact::geometry::{Sign, linear};
use acutile_exact::number::Number;
use malachite::Rational;

/// A covector w and a number c. At the corners of the first facet w is at most c. At the corners of
/// the second it is greater than c, except at common corners, where it is c.
pub struct Separation<const D: usize> {
    pub covector: [Number; D],
    pub value: Number,
}

/// Separates two facets, given by their corners; `common` says which corners of the second are
/// corners of the first. The sum of all candidates that separate weakly is tried: the candidates
/// contain the edges of the cone of separating functions.
pub fn separate<const D: usize>(
    numerals: &Numerals,
    first: &[[Number; D]],
    second: &[[Number; D]],
    common: &[bool],
) -> Option<Separation<D>> {
    let shared: Vec<&[Number; D]> = second
        .iter()
        .zip(common)
        .filter_map(|(point, is_common)| is_common.then_some(point))
        .collect();
    let beyond: Vec<&[Number; D]> = second
        .iter()
        .zip(common)
        .filter_map(|(point, is_common)| (!is_common).then_some(point))
        .collect();
    let value = |w: &[Number; D], point: &[Number; D]| linear::dot(w, point);
    let is_weak = |w: &[Number; D]| {
        let greatest = first.iter().map(|p| value(w, p)).max();
        let Some(greatest) = greatest else {
            return false;
        };
        shared.iter().all(|p| value(w, p) == greatest)
            && beyond.iter().all(|p| value(w, p) >= greatest)
    };
    let mut sum: [Number; D] = std::array::from_fn(|_| Number::zero());
    for w in candidates(first, second, shared.first().copied()) {
        if is_weak(&w) {
            sum = std::array::from_fn(|k| &sum[k] + &w[k]);
        }
    }
    let factor = Number::from(numerals.primitive_factor(&sum));
    let covector = sum.map(|x| x * &factor);
    let greatest = first.iter().map(|p| value(&covector, p)).max()?;
    let is_strict = beyond.iter().all(|p| value(&covector, p) > greatest);
    (is_strict && is_weak(&covector)).then_some(Separation {
        covector,
        value: greatest,
    })
}

/// Covectors that vanish on D - 1 of the directions that matter, with both signs.
fn candidates<const D: usize>(
    first: &[[Number; D]],
    second: &[[Number; D]],
    shared: Option<&[Number; D]>,
) -> Vec<[Number; D]> {
    let mut directions: Vec<[Number; D]> = Vec::new();
    match shared {
        Some(origin) => {
            let points = first.iter().chain(second);
            directions.extend(points.map(|p| linear::subtract(p, origin)));
        }
        None => {
            for facet in [first, second] {
                for (i, p) in facet.iter().enumerate() {
                    directions.extend(facet[i + 1..].iter().map(|q| linear::subtract(q, p)));
                }
            }
        }
    }
    directions
        .extend((0..D).map(|axis| {
            std::array::from_fn(|k| Number::from(Rational::from(u8::from(k == axis))))
        }));
    let mut found = Vec::new();
    let mut add = |w: [Number; D]| {
        if w.iter().any(|x| x.sign() != Sign::Equal) {
            found.push(w.each_ref().map(|x| -x));
            found.push(w);
        }
    };
    for (i, x) in directions.iter().enumerate() {
        if D == 2 {
            add(std::array::from_fn(|k| {
                if k == 0 { -&x[1] } else { x[0].clone() }
            }));
            continue;
        }
        for y in &directions[i + 1..] {
            add(std::array::from_fn(|k| {
                let (a, b) = ((k + 1) % D, (k + 2) % D);
                &(&x[a] * &y[b]) - &(&x[b] * &y[a])
            }));
        }
    }
    found
}
