//! The filters against exact integers: what they decide is true. Without their error bounds it would not be.

use crate::claim::Field;
use crate::filter::{Interval, Intervals, Range, Rough};
use crate::int::Int;
use crate::limits::Work;
use crate::ring::{Element, Exact, Ring, Sign};
use crate::root::{Root, enclosure};
use num_bigint::BigInt;
use std::cmp::Ordering::{self, Equal};
use std::rc::Rc;

fn random() -> impl FnMut() -> u64 {
    let mut seed = 1u64;
    move || {
        seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        seed >> 1 ^ seed >> 33
    }
}

fn root(field: &Field) -> (Rc<Root>, Rc<Work>) {
    let work = Rc::new(Work::new(u64::MAX));
    (Rc::new(Root::new(field, &work).unwrap()), work)
}

/// Q(√5)
fn golden() -> (Rc<Root>, Rc<Work>) {
    root(&Field { polynomial: [-5, 0, 1].map(BigInt::from).to_vec(), root: Some([2, 3, 1].map(BigInt::from)) })
}

#[test]
fn intervals_of_sums_of_products() {
    let (root, work) = root(&Field { polynomial: [0, 1].map(BigInt::from).to_vec(), root: None });
    let ring = Intervals { root, work };
    let mut random = random();
    let (mut decided, mut would_be_wrong) = (0, 0);
    for round in 0..200_000u64 {
        let mut number = || (random() as i64) >> (random() % 60);
        let (mut x, mut y) = ([number(), number(), number(), number()], [number(), number(), number(), number()]);
        // The last product cancels most of the others.
        let product = |k: usize, y: &[i64; 4]| i128::from(x[k]) * i128::from(y[k]);
        let sum = product(0, &y) + product(1, &y) + product(2, &y);
        if x[3] != 0 && round % 4 != 0 {
            y[3] = i64::try_from(-sum / i128::from(x[3])).unwrap_or(0);
        }
        if round % 16 == 1 {
            (x[3], y[3]) = (x[0], -y[0]);
            (x[2], y[2]) = (-x[1], y[1]);
        }
        let exact = (0..4).map(|k| BigInt::from(x[k]) * y[k]).sum::<BigInt>();
        let [x, y] = [x, y].map(|x| x.map(|c| Interval::of(&[c], &ring.root).unwrap()));
        let found = ring.dot(x.each_ref(), y.each_ref()).unwrap();
        let sign = exact.cmp(&BigInt::ZERO);
        if ring.sign(&found) != Sign::UNDECIDED {
            assert_eq!(ring.sign(&found), Sign::exactly(sign));
            decided += 1;
        }
        would_be_wrong += u64::from(found.middle.cmp(&0) != sign && sign != Equal);
    }
    assert!(decided > 100_000 && would_be_wrong > 100, "{decided} decided, {would_be_wrong} wrong middles");
}

#[test]
fn orders_of_quotients() {
    let mut random = random();
    let (mut decided, mut would_be_wrong) = (0, 0);
    for round in 0..100_000u64 {
        // Integers, as the ends of enclosures of which the radius is up to 2^-13 of the middle.
        let mut number = || {
            let x = u128::from(random() | 1) << (random() % 40);
            let radius = (x >> 13) >> (random() % 100).min(127);
            let middle = if random() & 1 == 0 { x + radius } else { x - radius };
            (x, Rough::new(middle, radius, 0).unwrap())
        };
        let [a, b, c, d, mut e, f] = [number(), number(), number(), number(), number(), number()];
        // Most of the second quotients are near to the first one.
        if round % 8 != 0 {
            let near: BigInt = BigInt::from(a.0) * b.0 * f.0 * f.0 / (BigInt::from(c.0) * d.0 * f.0);
            let near = near + (BigInt::from(random() as i64) >> (random() % 64));
            if let Ok(near @ 4096..) = u128::try_from(near) {
                e = (near, Rough::new(near, 0, 0).unwrap());
            }
        }
        let exact = (BigInt::from(a.0) * b.0 * f.0).cmp(&(BigInt::from(e.0) * c.0 * d.0));
        // The same for the negative quotients, which have the reverse order.
        let signs = [Ordering::Greater, Ordering::Less].map(Sign::exactly);
        for (sign, exact) in signs.into_iter().zip([exact, exact.reverse()]) {
            let first = Range::quotient(sign, Some([a.1, b.1, c.1, d.1]));
            let second = Range::quotient(sign, Some([e.1, f.1, f.1, f.1]));
            if let Some(order) = first.compare(&second) {
                assert_eq!(order, exact);
                decided += 1;
            }
            let middle = |range: Range| range.low.midpoint(range.high);
            would_be_wrong += u64::from(middle(first).cmp(&middle(second)) != exact && exact != Equal);
        }
    }
    assert!(decided > 10_000 && would_be_wrong > 100, "{decided} decided, {would_be_wrong} wrong middles");
}

#[test]
fn orders_of_different_signs() {
    let five = Rough::new(5, 0, 0);
    let quotient = |sign, roughs| Range::quotient(sign, roughs);
    let known = five.map(|five| [five; 4]);
    let ordered = [Ordering::Less, Equal, Ordering::Greater].map(Sign::exactly);
    for (k, x) in ordered.into_iter().enumerate() {
        for (l, y) in ordered.into_iter().enumerate() {
            for (first, second) in [(None, None), (known, None), (known, known)] {
                let found = quotient(x, first).compare(&quotient(y, second));
                assert_eq!(found, (k != l).then(|| k.cmp(&l)));
            }
        }
        // Without a sign a quotient is one of two.
        for roughs in [None, known] {
            assert_eq!(quotient(x, roughs).compare(&quotient(Sign::UNDECIDED, roughs)), None);
        }
    }
    // Exponents that would not fit the scale are left to exact integers.
    assert!(Rough::new(5, 0, 1 << 40).is_none() && Rough::new(5, 0, -(1 << 40)).is_none());
}

/// The order of p and q √5.
fn exact(p: &BigInt, q: &BigInt) -> Ordering {
    let zero = &BigInt::ZERO;
    let squares = (p * p).cmp(&(q * q * 5));
    match (p.cmp(zero), q.cmp(zero)) {
        (Ordering::Less, Ordering::Less) => squares.reverse(),
        (p, q) if p != q => p.cmp(&q),
        _ => squares,
    }
}

fn check_signs<T: Int>(ring: &Exact<T, 2>, p: &BigInt, q: &BigInt) -> [u64; 2] {
    let (Ok(c), Ok(d)) = (T::of(p), T::of(&-q)) else { return [0, 0] };
    let (x, expected) = (Element([c, d]), exact(p, q));
    let (sign, rough) = ring.rough(&x);
    for sign in [sign, ring.sign(&x)] {
        let is_right = sign == Sign::exactly(expected) || (sign == Sign::UNDECIDED && T::PRICE > 0);
        assert!(is_right, "{p} - {q} √5");
    }
    assert!(rough.is_none() || sign != Sign::UNDECIDED);
    let (middle, _, _) = enclosure(&x.0, &ring.root.rough).unwrap();
    [u64::from(sign != Sign::UNDECIDED), u64::from(middle.cmp(&0) != expected)]
}

#[test]
fn signs_near_zero() {
    let (root, work) = golden();
    let mut random = random();
    // Convergents p/q of √5 with the continued fraction 2; 4, 4, 4, …
    let mut convergents = vec![[1, 0].map(BigInt::from), [2, 1].map(BigInt::from)];
    while convergents.len() < 70 {
        let [[a, b], [c, d]] = [&convergents[convergents.len() - 2], &convergents[convergents.len() - 1]];
        convergents.push([c * 4 + a, d * 4 + b]);
    }
    let mut counts = [0, 0];
    for [p, q] in &convergents {
        for _ in 0..200 {
            let factor = BigInt::from((random() as i64) >> (random() % 64));
            let shift = BigInt::from((random() as i64) >> (random() % 64)) >> (random() % 64);
            for (p, q) in [(p * &factor, q * &factor), (p * &factor + &shift, q * &factor), (p + &shift, q.clone())] {
                let found = [
                    check_signs(&Exact::<i64, 2>::new(&root, &work).unwrap(), &p, &q),
                    check_signs(&Exact::<i128, 2>::new(&root, &work).unwrap(), &p, &q),
                    check_signs(&Exact::<BigInt, 2>::new(&root, &work).unwrap(), &p, &q),
                ];
                found.iter().for_each(|[decided, wrong]| {
                    counts[0] += decided;
                    counts[1] += wrong;
                });
            }
        }
    }
    let [decided, would_be_wrong] = counts;
    assert!(decided > 10_000 && would_be_wrong > 100, "{decided} decided, {would_be_wrong} wrong middles");
}
