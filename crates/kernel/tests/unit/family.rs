//! Signs of polynomials on boxes: by hand, and against values at points in plain integers.

use crate::claim::{Field, Polynomial};
use crate::family::{End, Parameter};
use crate::limits::Work;
use crate::polynomial::{Polynomials, Side};
use crate::ring::{Exact, Ring, Sign};
use crate::root::Root;
use num_bigint::BigInt;
use std::cmp::Ordering::{self, Equal, Greater, Less};
use std::rc::Rc;

/// numerator, denominator, whether the end is closed
type Given = (i64, i64, bool);

fn end((numerator, denominator, is_closed): Given) -> End {
    End { is_closed, numerator: vec![numerator.into()], denominator: denominator.into() }
}

fn large() -> Exact<BigInt, 1> {
    let work = Rc::new(Work::new(u64::MAX));
    let field = Field { polynomial: [0, 1].map(BigInt::from).to_vec(), root: None };
    Exact::new(&Rc::new(Root::new(&field, &work).unwrap()), &work).unwrap()
}

fn sides(ends: &[[Given; 2]]) -> Vec<Side<1>> {
    let parameter = |&[low, high]: &[Given; 2]| Parameter { name: "x".into(), low: end(low), high: end(high) };
    ends.iter().map(|ends| Side::new(&parameter(ends), &large()).unwrap()).collect()
}

fn sign(sides: &[Side<1>], terms: &[(i64, &[u32])]) -> Sign {
    let ring = Polynomials::new(&large(), sides, &vec![4; sides.len()]).unwrap();
    let terms: Polynomial = terms.iter().map(|(c, exponents)| (vec![(*c).into()], exponents.to_vec())).collect();
    ring.sign(&ring.polynomial(&terms).unwrap())
}

const BETWEEN: fn(Ordering, Ordering) -> Sign = |least, most| Sign { least, most };

/// In the Bernstein basis 1 - x² has the coefficients 1, 1, 0 on [0, 1], and x has 0, 1.
#[test]
fn signs_by_hand() {
    let unit = |low, high| sides(&[[(0, 1, low), (1, 1, high)]]);
    let square: &[(i64, &[u32])] = &[(1, &[0]), (-1, &[2])];
    assert_eq!(sign(&unit(false, false), square), Sign::exactly(Greater));
    assert_eq!(sign(&unit(true, false), square), Sign::exactly(Greater));
    assert_eq!(sign(&unit(false, true), square), BETWEEN(Equal, Greater));
    assert_eq!(sign(&unit(true, false), &[(-1, &[1])]), BETWEEN(Less, Equal));
    assert_eq!(sign(&unit(true, true), &[]), Sign::exactly(Equal));
    // 3x² - 3x + 1 is at least 1/4, but its coefficients are 1, -1/2, 1: only halves show its sign.
    let bowl: &[(i64, &[u32])] = &[(1, &[0]), (-3, &[1]), (3, &[2])];
    assert_eq!(sign(&unit(true, true), bowl), Sign::UNDECIDED);
    for half in unit(true, true)[0].halves(&large()).unwrap() {
        assert_eq!(sign(&[half], bowl), Sign::exactly(Greater));
    }
}

/// xy is zero on the sides x = 0 and y = 0 of the unit square, and 1 - xy in one corner.
#[test]
fn closed_ends_decide() {
    let square = |ends: [bool; 4]| sides(&[[(0, 1, ends[0]), (1, 1, ends[1])], [(0, 1, ends[2]), (1, 1, ends[3])]]);
    let corner: &[(i64, &[u32])] = &[(1, &[0, 0]), (-1, &[1, 1])];
    for k in 0..16 {
        let ends = [0, 1, 2, 3].map(|bit| k >> bit & 1 == 1);
        let product = if ends[0] || ends[2] { BETWEEN(Equal, Greater) } else { Sign::exactly(Greater) };
        assert_eq!(sign(&square(ends), &[(1, &[1, 1])]), product, "{ends:?}");
        let other = if ends[1] && ends[3] { BETWEEN(Equal, Greater) } else { Sign::exactly(Greater) };
        assert_eq!(sign(&square(ends), corner), other, "{ends:?}");
    }
}

/// At points p/q of a grid on the box the sign is between the two; and often it is decided.
#[test]
fn signs_at_points() {
    let mut seed = 5u64;
    let mut random = move |range: u64| {
        seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        ((seed >> 33) % range) as i64
    };
    let mut decided = 0;
    for _ in 0..300 {
        let mut ends = Vec::new();
        for _ in 0..2 {
            let (low, width) = (random(9) - 4, 1 + random(3));
            ends.push([(low, 2, random(2) == 1), (low * 3 + width, 6, random(2) == 1)]);
        }
        let mut terms = Vec::new();
        for e in 0..3 {
            for f in 0..4 {
                terms.push((random(7) - 2, [e, f]));
            }
        }
        let given: Vec<(i64, &[u32])> = terms.iter().map(|(c, exponents)| (*c, &exponents[..])).collect();
        let found = sign(&sides(&ends), &given);
        decided += usize::from(found.decided().is_ok());
        for j in 0..=6 {
            for k in 0..=6 {
                let is_inside = |n: i64, [low, high]: [Given; 2]| (n > 0 || low.2) && (n < 6 || high.2);
                if !is_inside(j, ends[0]) || !is_inside(k, ends[1]) {
                    continue;
                }
                // (low (6 - n) + high n) / 6 for ends over 2 and 6, times 36.
                let point = |n, [low, high]: [Given; 2]| i128::from(low.0 * 3 * (6 - n) + high.0 * n);
                let (x, y) = (point(j, ends[0]), point(k, ends[1]));
                let value = terms
                    .iter()
                    .map(|(c, [e, f])| i128::from(*c) * x.pow(*e) * y.pow(*f) * 36i128.pow(3 - e) * 36i128.pow(3 - f));
                let sign = value.sum::<i128>().cmp(&0);
                assert!(found.least <= sign && sign <= found.most, "{found:?} {sign:?} {ends:?} {terms:?}");
            }
        }
    }
    assert!(decided > 30, "{decided}");
}
