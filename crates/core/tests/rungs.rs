//! The exact path at its limits: integers of every width against big ones, edges of the greatest length for
//! each rung, doubles as far apart as one exponent allows. Neighbours that are tested from one side are
//! compared with both sides.

use crate::soup::{Random, compare_all, rational, skewed, soup, twin};
use acutile_core::checker::{Findings, Model, check_delaunay};
use acutile_core::predicates::InSphere;
use acutile_core::tiling::{AnyTiling, Coordinates, Frame, Tiling, match_facets, supercell};
use acutile_exact::geometry::wide::Wide;
use acutile_exact::geometry::{I128, I256, I512, Quadratic, RingElement, Scalar, Sign};
use acutile_exact::number::{Number, Reader};
use malachite::base::num::arithmetic::traits::ModPowerOf2;
use malachite::base::num::basic::traits::One;
use malachite::{Integer, Rational};

/// Integers of at most `bits` bits and a sign, the extreme ones often.
fn extreme(bits: u64, random: &mut Random) -> Integer {
    let end = Integer::ONE << bits;
    match random.below(6) {
        0 => end - Integer::ONE,
        1 => -end,
        2 => Integer::ONE - end,
        3 => Integer::from(random.integer(2)),
        _ => (0..=bits / 60)
            .fold(Integer::ONE, |x, _| {
                (x << 60u32) + Integer::from(random.integer(60))
            })
            .mod_power_of_2(bits)
            .into(),
    }
}

fn narrow(x: &Integer) -> I128 {
    I128(i128::try_from(x).expect("it fits"))
}

fn words<const N: usize>(x: &Integer) -> [u64; N] {
    let residue = Integer::from(x.mod_power_of_2(64 * N as u64));
    std::array::from_fn(|k| {
        let word = (&residue >> (64 * k as u64)).mod_power_of_2(64);
        u64::try_from(&word).expect("it fits")
    })
}

/// Products of halves, sums and differences that fit, signs and conversions.
fn check_ring<S: Scalar + PartialEq>(bits: u64, random: &mut Random, of: impl Fn(&Integer) -> S) {
    for _ in 0..5000 {
        let [a, b] = [0; 2].map(|_| extreme(bits / 2 - 1, random));
        assert_eq!(of(&a).times(&of(&b)), of(&(&a * &b)), "{a} {b}");
        let [x, y] = [0; 2].map(|_| extreme(bits - 2, random));
        assert_eq!(of(&x).plus(&of(&y)), of(&(&x + &y)), "{x} {y}");
        assert_eq!(of(&x).minus(&of(&y)), of(&(&x - &y)), "{x} {y}");
        assert_eq!(of(&x).sign(), x.cmp(&Integer::from(0)));
        let ratio = of(&x).approximate() / Scalar::approximate(&x);
        assert!(x == 0 || (ratio - 1.0).abs() < 1e-12);
    }
}

#[test]
fn integers_of_each_width() {
    let mut random = Random(10);
    check_ring(128, &mut random, narrow);
    check_ring(256, &mut random, |x| Wide::<4>(words(x)));
    check_ring(512, &mut random, |x| Wide::<8>(words(x)));
    let most = Integer::ONE << 511u32;
    let [least, greatest] = [-&most, &most - Integer::ONE].map(|x| Wide::<8>(words(&x)));
    let one = least.integer(1);
    assert_eq!(greatest.checked_sum(&one), None);
    assert_eq!(least.checked_sum(&I512::ZERO.minus(&one)), None);
    assert_eq!(greatest.checked_sum(&least), Some(I512::ZERO.minus(&one)));
    assert_eq!(I512::from(I256::from(-5)), I512::from(-5));
}

/// Signs of x + y √d, where the squares of x and √d y are next to each other, too.
#[test]
fn signs_by_squares() {
    let mut random = Random(14);
    for (x, y, d) in [
        (9, -4, 5),
        (-161, 72, 5),
        (51841, -23184, 5),
        (-7, 4, 3),
        (1351, -780, 3),
    ] {
        // x² - d y² = ±1
        for _ in 0..200 {
            let n = extreme(1 + random.below(40), &mut random);
            let [x, y] = [x, y].map(|x| Integer::from(x) * &n + Integer::from(random.integer(2)));
            let d = Integer::from(d);
            let squares = (&x * &x, &y * &y * &d);
            let expected = match (x.cmp(&Integer::from(0)), y.cmp(&Integer::from(0))) {
                (a, b) if a == b || b == Sign::Equal => a,
                (Sign::Equal, b) => b,
                (a, b) => {
                    if squares.0 > squares.1 {
                        a
                    } else {
                        b
                    }
                }
            };
            let q = Quadratic {
                x: narrow(&x),
                y: narrow(&y),
                d: narrow(&d),
            };
            assert_eq!(q.sign(), expected);
            let wide = |x: &Integer| I256::from(narrow(x).0);
            assert_eq!(
                Quadratic {
                    x: wide(&x),
                    y: wide(&y),
                    d: wide(&d)
                }
                .sign(),
                expected
            );
            assert_eq!(Quadratic { x, y, d }.sign(), expected);
        }
    }
}

/// Coordinates ±2^b and next to that, so that edges and minors are as large as bounds say.
#[test]
fn longest_edges_of_each_rung() {
    let mut random = Random(15);
    for bits in (1..=96).step_by(if cfg!(debug_assertions) { 3 } else { 1 }) {
        for frame in [Frame::cubic(), skewed()] {
            let number = |x: Integer| Number::from(Rational::from(x));
            let points = (0..10).map(|_| [0; 3].map(|_| number(extreme(bits, &mut random))));
            let points: Vec<[Number; 3]> = points.collect();
            compare_all(&soup(points.into(), frame, 0, &mut random));
        }
    }
}

/// The same over Z[√d].
#[test]
fn longest_edges_over_quadratic_fields() {
    let mut random = Random(16);
    for (root, bits) in [
        ("sqrt(5)", 3),
        ("sqrt(5)", 14),
        ("sqrt(3)", 28),
        ("sqrt(1000003)", 24),
        ("sqrt(2)", 59),
    ] {
        let mut reader = Reader::new();
        reader.learn(root).expect("a number");
        let root = reader.value(root).expect("it was learnt");
        let frame = Frame {
            field: reader.field(),
            ..skewed()
        };
        let number = |x: Integer| Number::from(Rational::from(x));
        let points: Vec<[Number; 3]> = (0..10)
            .map(|_| {
                [0; 3].map(|_| {
                    number(extreme(bits, &mut random)) + &root * &number(extreme(bits, &mut random))
                })
            })
            .collect();
        compare_all(&soup(points.into(), frame, 0, &mut random));
    }
}

/// Doubles whose exponents are as far apart as one unit for all of them allows, and further.
#[test]
fn doubles_far_apart() {
    let mut random = Random(17);
    for spread in [0, 30, 41, 42, 43, 60, 93, 94, 95, 96, 120] {
        for shift in [0, 1] {
            for scale in [0, -3, 40] {
                let mut double = || {
                    let exponent = scale
                        - [0, spread, random.below(spread as u64 + 1) as i32]
                            [random.below(3) as usize];
                    ((random.unit() - 0.5) * 8.0).round() * 2f64.powi(exponent)
                };
                let points = (0..10).map(|_| [0; 3].map(|_| double())).collect();
                let vertices = Coordinates::from_doubles(points).expect("they are finite");
                compare_all(&soup(vertices, skewed(), shift, &mut random));
            }
        }
    }
}

fn entry(name: &str) -> Tiling<3> {
    match acutile_catalog::find(name).map(|entry| entry.build()) {
        Some(Ok(AnyTiling::Space(tiling))) => tiling,
        _ => unreachable!("{name} is a tiling of space"),
    }
}

/// The same tiling in another metric is a tiling, but need not be Delaunay: what is
/// found by pairs is what both sides say.
#[test]
fn neighbours_from_both_sides() {
    let mut defects = 0;
    for name in ["a15", "bcc", "cube-6"] {
        for stretch in [1, 2, 3, 30] {
            let mut tiling = supercell(&entry(name), [2, 1, 2]);
            tiling.frame.gram[2][2] = &tiling.frame.gram[2][2] * &rational(stretch);
            let matching = match_facets(&tiling);
            let mut signs = Vec::new();
            for facet in tiling.facets() {
                let mate = matching.mate(&tiling, facet).expect("it is a tiling");
                let corners = tiling.simplex(mate.facet.simplex);
                let apex = corners[usize::from(mate.facet.opposite)].moved(mate.shift);
                signs.push(twin(&InSphere, &tiling, facet.simplex, &apex).get(0));
            }
            let count = |sign: Sign| signs.iter().filter(|s| **s == sign).count();
            for weak in [false, true] {
                let mut findings = Findings::new(10);
                check_delaunay(&Model::new(&tiling), &matching, weak, &mut findings);
                let counted = |code: &str| findings.counts().get(code).copied().unwrap_or(0);
                assert_eq!(
                    counted("inside-circumsphere"),
                    count(Sign::Less),
                    "{name} {stretch}"
                );
                let on = if weak { 0 } else { count(Sign::Equal) };
                assert_eq!(counted("on-circumsphere"), on, "{name} {stretch}");
                defects += findings.counts().values().sum::<usize>();
            }
        }
    }
    assert!(defects > 100, "{defects}");
}
