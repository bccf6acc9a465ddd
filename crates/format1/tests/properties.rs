//! Properties of the kernel over random certificates and random damage.

use acutile_format1::certificate::{
    AlgebraicField, Certificate, Domain, Field, Mate, Number, Place, Polytope, Statement, to_bytes,
};
use acutile_format1::verifier::{Limits, Refusal, Verified, verify};
use proptest::prelude::*;
use std::cmp::Ordering::{self, Equal, Greater, Less};

fn bytes(name: &str) -> Vec<u8> {
    let root = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");
    std::fs::read(format!("{root}/tests/certificates/valid/{name}.json")).unwrap()
}

fn valid(name: &str) -> Certificate {
    serde_json::from_slice(&bytes(name)).unwrap()
}

fn check(certificate: &Certificate) -> Result<Verified, Refusal> {
    verify(&to_bytes(certificate), &Limits::DEFAULT)
}

const NAMES: [&str; 11] = [
    "plane-equilateral-acute",
    "plane-square-triangle",
    "space-bcc",
    "space-a15",
    "strip-of-height-sqrt-3",
    "slab-bcc",
    "prism-cube-6",
    "solid-octahedron",
    "region-two-cubes-at-an-edge",
    "region-piece-in-a-cavity",
    "region-prism-over-sqrt-3",
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
        prop_assume!(!entries.is_empty());
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
        prop_assume!(certificate != valid(name));
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

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    /// Four points in this order, cut along the diagonal from the first: a tiling of
    /// a convex quadrilateral exactly where all four turns are to the left.
    #[test]
    fn quadrilaterals_against_their_turns(points in prop::array::uniform4(prop::array::uniform2(-3i64..=3))) {
        let mut certificate = valid("solid-square-2");
        let vertex = |k: usize| points[k].map(|x| Number(vec![x.to_string()])).to_vec();
        polytope(&mut certificate).vertices = (0..4).map(vertex).collect();
        // The file's vertices are (0, 0), (0, 1), (1, 0), (1, 1); the polygon's go round.
        certificate.witness.vertices = [0, 3, 1, 2].map(vertex).to_vec();
        certificate.claim.statements.truncate(1);
        let turn = |k: usize| {
            let [p, q, r] = [0, 1, 2].map(|i| points[(k + i) % 4]);
            (q[0] - p[0]) * (r[1] - q[1]) - (q[1] - p[1]) * (r[0] - q[0])
        };
        let convex = (0..4).all(|k| turn(k) > 0);
        prop_assert_eq!(check(&certificate).is_ok(), convex);
    }

    /// An affine map of the last k coordinates, of the tiling and of the domain
    /// alike, changes nothing but the orientation and, where it is singular, all.
    #[test]
    fn affine_maps_of_a_domain(
        name in prop::sample::select(&["slab-bcc", "prism-cube-6", "solid-cube-6", "solid-octahedron"][..]),
        m in prop::array::uniform3(prop::array::uniform3(-2i64..=2)), by in prop::array::uniform3(-9i64..9),
    ) {
        let mut certificate = valid(name);
        certificate.claim.statements.truncate(1);
        let k = polytope(&mut certificate).vertices[0].len();
        let tiling = certificate.witness.vertices.clone();
        certificate.witness.vertices = tiling.iter().map(|vertex| image(vertex, &m, &by, k)).collect();
        for vertex in &mut polytope(&mut certificate).vertices {
            *vertex = image(vertex, &m, &by, k);
        }
        let expected = match determinant(&m, k).cmp(&0) {
            Greater => "verified",
            Equal => "face-not-facet",
            Less => "orientation",
        };
        let answer = check(&certificate).map_or_else(|refusal| refusal.code(), |_| "verified");
        prop_assert_eq!(answer, expected);
    }

    /// Faces in another order, with the mates that name them, and with their vertices
    /// read from another one on or the other way round.
    #[test]
    fn faces_in_any_order(
        name in prop::sample::select(&["slab-bcc", "prism-cube-6", "solid-cube-6", "solid-octahedron"][..]),
        seed: u64, turn in 0usize..5, reversed: bool,
    ) {
        let mut certificate = valid(name);
        let faces = polytope(&mut certificate).faces.clone();
        let order = permutation(faces.len(), seed);
        polytope(&mut certificate).faces = order.iter().map(|&old| {
            let mut face = faces[old].clone();
            let length = face.len();
            face.rotate_left(turn % length);
            if reversed {
                face.reverse();
            }
            face
        }).collect();
        for Mate(mate) in certificate.witness.mates.iter_mut().flatten() {
            if let [face] = mate.as_mut_slice() {
                *face = order.iter().position(|&old| old as i64 == *face).unwrap() as i64;
            }
        }
        let verified = check(&certificate);
        prop_assert!(verified.is_ok(), "{verified:?}");
    }

    /// No face of the domain can be changed, removed or repeated alone.
    #[test]
    fn one_changed_face(
        name in prop::sample::select(&["slab-bcc", "prism-cube-6", "solid-cube-6", "solid-octahedron"][..]),
        what in 0..4usize, f in any::<prop::sample::Index>(), i in any::<prop::sample::Index>(), w in 0usize..9,
    ) {
        let mut certificate = valid(name);
        let polytope = polytope(&mut certificate);
        let f = f.index(polytope.faces.len());
        let i = i.index(polytope.faces[f].len());
        prop_assume!(polytope.faces[f][i] != w);
        match what {
            0 => polytope.faces[f][i] = w,
            1 => { polytope.faces.remove(f); }
            2 => polytope.faces.push(polytope.faces[f].clone()),
            _ => { polytope.faces[f].remove(i); }
        }
        prop_assert!(check(&certificate).is_err());
    }
}

fn polytope(certificate: &mut Certificate) -> &mut Polytope {
    match &mut certificate.claim.domain {
        Domain::Space | Domain::Region => panic!("no polytope"),
        Domain::Slab(polytope) | Domain::Prism(polytope) | Domain::Solid(polytope) => polytope,
    }
}

/// The last k coordinates x become m x + b, with the first k rows and columns of m.
fn image(point: &[Number], m: &[[i64; 3]; 3], b: &[i64; 3], k: usize) -> Vec<Number> {
    let (first, last) = point.split_at(point.len() - k);
    let row = |i: usize| {
        let terms = (0..k).map(|j| rational(&last[j]) * m[i][j]);
        number(terms.sum::<Rational>() + b[i])
    };
    first.iter().cloned().chain((0..k).map(row)).collect()
}

fn determinant(m: &[[i64; 3]; 3], k: usize) -> i64 {
    let minor = |i: usize, j: usize| m[1][i] * m[2][j] - m[1][j] * m[2][i];
    match k {
        1 => m[0][0],
        2 => m[0][0] * m[1][1] - m[0][1] * m[1][0],
        _ => m[0][0] * minor(1, 2) - m[0][1] * minor(0, 2) + m[0][2] * minor(0, 1),
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
