//! Properties of the kernel over random certificates and random damage.

use acutile::certificate::{
    AlgebraicField, Certificate, Field, Mate, Number, Place, Statement, to_bytes,
};
use acutile::verifier::{Limits, Refusal, Verified, verify};
use proptest::prelude::*;
use std::cmp::Ordering::{self, Equal, Greater, Less};

fn bytes(name: &str) -> Vec<u8> {
    let root = env!("CARGO_MANIFEST_DIR");
    std::fs::read(format!("{root}/tests/certificates/valid/{name}.json")).unwrap()
}

fn valid(name: &str) -> Certificate {
    serde_json::from_slice(&bytes(name)).unwrap()
}

fn check(certificate: &Certificate) -> Result<Verified, Refusal> {
    verify(&to_bytes(certificate), &Limits::DEFAULT)
}

const NAMES: [&str; 4] = [
    "plane-equilateral-acute",
    "plane-square-triangle",
    "space-bcc",
    "space-a15",
];

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn random_bytes_are_refused(bytes in prop::collection::vec(any::<u8>(), 0..400)) {
        prop_assert!(verify(&bytes, &Limits::DEFAULT).is_err());
    }

    /// A certificate is one byte string: with any one byte changed it is not
    /// the same certificate, and where it is one, it claims something else.
    #[test]
    fn one_changed_byte(name in prop::sample::select(&NAMES[..]), at in any::<prop::sample::Index>(), byte: u8) {
        let good = bytes(name);
        let mut bad = good.clone();
        let at = at.index(bad.len());
        prop_assume!(bad[at] != byte);
        bad[at] = byte;
        if let Ok(verified) = verify(&bad, &Limits::DEFAULT) {
            let certificate: Certificate = serde_json::from_slice(&bad).unwrap();
            prop_assert_eq!(verified.claim(), &certificate.claim);
            // The combinatorics are rigid: only a number can have changed.
            prop_assert_eq!(&certificate.witness.simplices, &valid(name).witness.simplices);
            prop_assert_eq!(&certificate.witness.mates, &valid(name).witness.mates);
        }
    }

    #[test]
    fn truncated_or_spliced(name in prop::sample::select(&NAMES[..]), a in any::<prop::sample::Index>(), b in any::<prop::sample::Index>()) {
        let good = bytes(name);
        let (a, b) = (a.index(good.len()), b.index(good.len()));
        prop_assert!(verify(&good[..a], &Limits::DEFAULT).is_err());
        let spliced = [&good[..a], &good[b..]].concat();
        prop_assert!(a == b || verify(&spliced, &Limits::DEFAULT).is_err());
    }

    /// No entry of a corner or of a mate can be changed alone: the facets of
    /// that simplex would not be those of its mates.
    #[test]
    fn one_changed_entry(
        name in prop::sample::select(&NAMES[..]), mates: bool,
        s in any::<prop::sample::Index>(), i in any::<prop::sample::Index>(), k in any::<prop::sample::Index>(),
        by in prop_oneof![-3i64..=-1, 1i64..=3, Just(1i64 << 30), Just(i64::MIN / 2)],
    ) {
        let mut certificate = valid(name);
        let witness = &mut certificate.witness;
        let s = s.index(witness.simplices.len());
        let entries = if mates {
            let row = &mut witness.mates[s];
            let i = i.index(row.len());
            &mut row[i].0
        } else {
            let row = &mut witness.simplices[s];
            let i = i.index(row.len());
            &mut row[i].0
        };
        let k = k.index(entries.len());
        entries[k] = entries[k].wrapping_add(by);
        prop_assert!(check(&certificate).is_err());
    }

    /// Two corners exchanged, two mates exchanged, a row removed or repeated.
    #[test]
    fn one_changed_row(name in prop::sample::select(&NAMES[..]), what in 0..5usize, s in any::<prop::sample::Index>()) {
        let mut certificate = valid(name);
        let witness = &mut certificate.witness;
        let s = s.index(witness.simplices.len());
        match what {
            0 => witness.simplices[s].swap(0, 1),
            1 => witness.mates[s].swap(0, 1),
            2 => { witness.simplices.remove(s); witness.mates.remove(s); }
            3 => { witness.simplices.push(witness.simplices[s].clone()); witness.mates.push(witness.mates[s].clone()); }
            _ => { witness.simplices[s].remove(0); }
        }
        prop_assert!(check(&certificate).is_err());
    }

    /// The two triangles 0, e_1, e_2 and e_1, e_1 + e_2, e_2 have the angles whose
    /// cosines have the signs of g_12, g_11 - g_12, g_22 - g_12; across each edge
    /// the two opposite angles are equal, so Delaunay is acute, weakly so nonobtuse.
    #[test]
    fn plane_lattices_against_a_formula(g11 in -3i64..12, g12 in -6i64..8, g22 in -3i64..12) {
        let integer = |value: i64| Number(vec![value.to_string()]);
        let mut certificate = valid("plane-equilateral-acute");
        certificate.claim.gram = vec![vec![integer(g11), integer(g12)], vec![integer(g12), integer(g22)]];
        let sign = |value: i64| value.cmp(&0);
        let signs = [sign(g12), sign(g11 - g12), sign(g22 - g12)];
        compare(&mut certificate, sign(g11), sign(g11 * g22 - g12 * g12), signs)?;
    }

    /// The same over Q(sqrt 3), signs of x + y sqrt 3 by squaring.
    #[test]
    fn plane_lattices_over_sqrt_3(g in prop::array::uniform6(-4i64..8)) {
        let [a, b, c, d, e, f] = g;
        let number = |x: i64, y: i64| match y {
            0 => Number(vec![x.to_string()]),
            _ => Number(vec![x.to_string(), y.to_string()]),
        };
        let mut certificate = valid("plane-equilateral-acute");
        certificate.claim.field = valid("plane-square-triangle").claim.field;
        certificate.claim.gram = vec![vec![number(a, b), number(c, d)], vec![number(c, d), number(e, f)]];
        let determinant = sign_sqrt_3(a * e + 3 * b * f - c * c - 3 * d * d, a * f + b * e - 2 * c * d);
        let signs = [sign_sqrt_3(c, d), sign_sqrt_3(a - c, b - d), sign_sqrt_3(e - c, f - d)];
        compare(&mut certificate, sign_sqrt_3(a, b), determinant, signs)?;
    }

    /// A tiling moved as a whole, scaled, or with its data in another order is
    /// the same tiling.
    #[test]
    fn symmetries_keep_the_verdict(
        name in prop::sample::select(&["space-a15", "space-bcc"][..]),
        seed: u64, shear in -3i64..=3, scale in 1i64..50, axes in prop::sample::select(&[(0usize, 1usize), (1, 2), (2, 0), (1, 0)][..]),
        by in prop::array::uniform3(-9i64..9), simplex in any::<prop::sample::Index>(),
    ) {
        let mut certificate = valid(name);
        let simplex = simplex.index(certificate.witness.simplices.len());
        relabel_vertices(&mut certificate, seed);
        reorder_simplices(&mut certificate, seed);
        move_simplex(&mut certificate, simplex, &by);
        rotate_corners(&mut certificate, simplex);
        change_basis(&mut certificate, axes, shear);
        scale_metric(&mut certificate, scale);
        let verified = check(&certificate);
        prop_assert!(verified.is_ok(), "{verified:?}");
    }
}

fn sign_sqrt_3(x: i64, y: i64) -> Ordering {
    match (x.signum(), y.signum()) {
        (s, 0) => s.cmp(&0),
        (0, s) => s.cmp(&0),
        (s, t) if s == t => s.cmp(&0),
        (s, _) => {
            if s > 0 {
                (x * x).cmp(&(3 * y * y))
            } else {
                (3 * y * y).cmp(&(x * x))
            }
        }
    }
}

/// Each statement alone gets the verdict that the signs of g_11, det G and the
/// three cosines demand.
fn compare(
    certificate: &mut Certificate,
    g11: Ordering,
    determinant: Ordering,
    cosines: [Ordering; 3],
) -> Result<(), TestCaseError> {
    let metric = g11 == Greater && determinant == Greater;
    let acute = metric && cosines.iter().all(|sign| *sign == Greater);
    let nonobtuse = metric && cosines.iter().all(|sign| *sign != Less);
    let bound = |q: &str| Statement::DihedralBelow(q.to_owned());
    let cases = [
        (Statement::Acute, acute),
        (Statement::Nonobtuse, nonobtuse),
        (bound("90"), acute),
        (bound("180"), metric),
        (Statement::Delaunay, acute),
        (Statement::WeaklyDelaunay, nonobtuse),
    ];
    for (statement, expected) in cases {
        certificate.claim.statements = vec![Statement::FaceToFaceTiling, statement];
        let answer = check(certificate);
        prop_assert_eq!(
            answer.is_ok(),
            expected,
            "{:?} {:?}",
            certificate.claim,
            answer
        );
    }
    certificate.claim.statements.truncate(1);
    prop_assert_eq!(check(certificate).is_ok(), metric);
    prop_assert!(cosines.contains(&Equal) || acute == nonobtuse);
    Ok(())
}

/// A permutation of 0..n from a seed: multiplication by a unit modulo a prime, sorted.
fn permutation(n: usize, seed: u64) -> Vec<usize> {
    let key = |k: &usize| (*k as u64 + 1).wrapping_mul(seed | 1) % 1_000_003;
    let mut order: Vec<usize> = (0..n).collect();
    order.sort_by_key(key);
    order
}

fn relabel_vertices(certificate: &mut Certificate, seed: u64) {
    let witness = &mut certificate.witness;
    let order = permutation(witness.vertices.len(), seed);
    witness.vertices = order
        .iter()
        .map(|&old| witness.vertices[old].clone())
        .collect();
    for Place(place) in witness.simplices.iter_mut().flatten() {
        place[0] = order
            .iter()
            .position(|&old| old as i64 == place[0])
            .unwrap() as i64;
    }
}

fn reorder_simplices(certificate: &mut Certificate, seed: u64) {
    let witness = &mut certificate.witness;
    let order = permutation(witness.simplices.len(), seed);
    witness.simplices = order
        .iter()
        .map(|&old| witness.simplices[old].clone())
        .collect();
    witness.mates = order
        .iter()
        .map(|&old| witness.mates[old].clone())
        .collect();
    for Mate(mate) in witness.mates.iter_mut().flatten() {
        mate[0] = order.iter().position(|&old| old as i64 == mate[0]).unwrap() as i64;
    }
}

/// The simplex moved by v: its mates move along, and others see it at -v.
fn move_simplex(certificate: &mut Certificate, simplex: usize, by: &[i64]) {
    let witness = &mut certificate.witness;
    for Place(place) in &mut witness.simplices[simplex] {
        place[1..]
            .iter_mut()
            .zip(by)
            .for_each(|(entry, by)| *entry += by);
    }
    for (s, row) in witness.mates.iter_mut().enumerate() {
        for Mate(mate) in row {
            let sign = (s == simplex) as i64 - (mate[0] == simplex as i64) as i64;
            mate[2..]
                .iter_mut()
                .zip(by)
                .for_each(|(entry, by)| *entry += sign * by);
        }
    }
}

/// The first three corners in cyclic order: an even permutation.
fn rotate_corners(certificate: &mut Certificate, simplex: usize) {
    let witness = &mut certificate.witness;
    witness.simplices[simplex][..3].rotate_left(1);
    witness.mates[simplex][..3].rotate_left(1);
    for Mate(mate) in witness.mates.iter_mut().flatten() {
        if mate[0] == simplex as i64 && mate[1] < 3 {
            mate[1] = (mate[1] + 2) % 3;
        }
    }
}

type Rational = num_rational::Ratio<i64>;

fn rational(number: &Number) -> Rational {
    number.0[0].parse().unwrap()
}

fn number(value: Rational) -> Number {
    Number(vec![value.to_string()])
}

/// The basis vector b_j becomes b_j - k b_i; a coordinate x_i becomes x_i + k x_j.
fn change_basis(certificate: &mut Certificate, (i, j): (usize, usize), k: i64) {
    let gram = &mut certificate.claim.gram;
    let other = gram[i].clone();
    for (entry, other) in gram[j].iter_mut().zip(&other) {
        *entry = number(rational(entry) - rational(other) * k);
    }
    for row in gram.iter_mut() {
        row[j] = number(rational(&row[j]) - rational(&row[i]) * k);
    }
    let witness = &mut certificate.witness;
    for vertex in &mut witness.vertices {
        vertex[i] = number(rational(&vertex[i]) + rational(&vertex[j]) * k);
    }
    for Place(place) in witness.simplices.iter_mut().flatten() {
        place[1 + i] += k * place[1 + j];
    }
    for Mate(mate) in witness.mates.iter_mut().flatten() {
        mate[2 + i] += k * mate[2 + j];
    }
}

fn scale_metric(certificate: &mut Certificate, scale: i64) {
    for entry in certificate.claim.gram.iter_mut().flatten() {
        *entry = number(rational(entry) * Rational::new(scale, 7));
    }
}

/// p = (x² - 2)(x² - 3), a = sqrt 2: every element with the value zero is
/// declined where a strict sign is asked, whatever multiple of x² - 2 it is.
#[test]
fn a_reducible_field_never_guesses() {
    let polynomial = ["6", "0", "-5", "0", "1"].map(str::to_owned).to_vec();
    let root = ("1".to_owned(), "3/2".to_owned());
    let mut certificate = valid("plane-equilateral-acute");
    certificate.claim.field = Field::Algebraic(AlgebraicField { polynomial, root });
    certificate.claim.statements.truncate(1);
    let number = |texts: &[i64]| Number(texts.iter().map(|c| c.to_string()).collect());
    for (x, y) in (-20..=20).flat_map(|x| (-20..=20).map(move |y| (x, y))) {
        // (x + y a)(a² - 2) = -2x - 2y a + x a² + y a³
        let coefficients = if y == 0 {
            vec![-2 * x, 0, x]
        } else {
            vec![-2 * x, -2 * y, x, y]
        };
        let coefficients = if (x, y) == (0, 0) {
            vec![0]
        } else {
            coefficients
        };
        certificate.claim.gram[0] = vec![number(&coefficients), number(&[0])];
        certificate.claim.gram[1] = vec![number(&[0]), number(&[1])];
        let code = check(&certificate).unwrap_err().code();
        let expected = if (x, y) == (0, 0) {
            "gram-not-positive"
        } else {
            "sign-undecided"
        };
        assert_eq!(code, expected, "{x} + {y} a");
    }
}
