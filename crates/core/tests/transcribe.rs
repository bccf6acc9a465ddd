//! Tilings written as certificates: canonical, confirmed by the kernel, and read back.

use acutile_catalog as catalog;
use acutile_core::checker::{Options, examine};
use acutile_core::format::{self, json, print, read};
use acutile_core::proved::{Proved, prove};
use acutile_core::quality::squared_edges;
use acutile_core::tiling::coordinates::Form;
use acutile_core::tiling::{AnyTiling, Coordinates, Corner, Domain, Frame, Tiling, supercell};
use acutile_core::transcribe::{self, of_certificate};
use acutile_core::with_dimension;
use acutile_exact::number::Number;
use acutile_kernel::Limits;
use malachite::base::num::arithmetic::traits::Gcd;
use malachite::{Integer, Natural};

fn space(name: &str) -> Tiling<3> {
    match catalog::build(name) {
        Ok(AnyTiling::Space(tiling)) => tiling,
        _ => panic!("{name} is a tiling of space"),
    }
}

fn certificate<const D: usize>(tiling: &Tiling<D>) -> Vec<u8> {
    let proved = prove(tiling, &Options::default(), &|_| ());
    let proved = proved.unwrap_or_else(|reason| panic!("{}", reason.in_words(tiling)));
    proved.certificate().to_vec()
}

/// The determinant of D integer vectors.
fn determinant(rows: &[Vec<Integer>]) -> Integer {
    match rows {
        [x, y] => &x[0] * &y[1] - &x[1] * &y[0],
        [x, y, z] => {
            let minor = |i: usize, j: usize| &y[i] * &z[j] - &y[j] * &z[i];
            &x[0] * minor(1, 2) + &x[1] * minor(2, 0) + &x[2] * minor(0, 1)
        }
        _ => panic!("two or three vectors"),
    }
}

/// The rules of canonical order, for the rational certificates of these names.
#[test]
fn canonical_order() {
    for name in ["a15", "bcc", "cube-5", "c15", "a15-snub-square"] {
        let Ok(tiling) = catalog::build(name) else {
            continue;
        };
        let cbor = with_dimension!(&tiling, AnyTiling, t => certificate(t));
        let data = read::certificate(&cbor).unwrap();
        assert_eq!(format::write::to_bytes(&data), cbor, "{name}");
        let json = print::to_json(&cbor).unwrap();
        assert_eq!(json::to_cbor(&json).unwrap(), cbor, "{name}");
        check_order(&data, name);
    }
}

fn check_order(data: &format::Certificate, name: &str) {
    let (claim, witness) = (&data.claim, &data.witness);
    let (d, rank) = (claim.dimension, claim.rank());
    assert!(claim.statements.is_sorted(), "{name}");
    let content = claim.gram.iter().flatten().flat_map(|number| &number.0);
    let content = content.fold(Natural::from(0u32), |gcd, n| gcd.gcd(n.unsigned_abs_ref()));
    assert_eq!(content, 1u32, "{name}: the Gram matrix is primitive");
    let coefficients = witness
        .vertices
        .iter()
        .flatten()
        .flat_map(|number| &number.0);
    let divisor = coefficients.fold(witness.denominator.unsigned_abs_ref().clone(), |gcd, n| {
        gcd.gcd(n.unsigned_abs_ref())
    });
    assert_eq!(divisor, 1u32, "{name}: lowest terms");
    for vertex in &witness.vertices {
        for x in &vertex[..rank] {
            let in_cell = x.0[0] >= 0 && x.0[0] < witness.denominator;
            assert!(in_cell || x.0.len() > 1, "{name}: {vertex:?}");
        }
    }
    let mut next = 0;
    for row in witness.simplices.chunks_exact(d + 1) {
        assert_eq!(row[0].shift, [0; 3], "{name}");
        assert!(
            row[..d].is_sorted_by(|x, y| x < y) && row[d - 2] < row[d],
            "{name}: {row:?}"
        );
        assert_ne!(row[d - 1], row[d]);
        // The last two corners may be exchanged.
        let mut vertices: Vec<u32> = row.iter().map(|corner| corner.vertex).collect();
        vertices.sort_unstable();
        for vertex in vertices {
            assert!(vertex <= next, "{name}: numbers follow the rows");
            next = next.max(vertex + 1);
        }
        if claim.field == format::Field::Rationals {
            let position = |corner: &format::Corner, k: usize| {
                let shift = Integer::from(corner.shift[k]) * &witness.denominator;
                &witness.vertices[corner.vertex as usize][k].0[0] + shift
            };
            let edge = |corner: &format::Corner| -> Vec<Integer> {
                (0..d)
                    .map(|k| position(corner, k) - position(&row[0], k))
                    .collect()
            };
            let edges: Vec<Vec<Integer>> = row[1..].iter().map(edge).collect();
            assert!(determinant(&edges) > 0, "{name}: {row:?}");
        }
    }
    assert_eq!(next as usize, witness.vertices.len(), "{name}");
}

/// The same simplices up to congruence, numbers of a field compared by their doubles.
fn lengths<const D: usize>(tiling: &Tiling<D>) -> Vec<Vec<i64>> {
    let scale = tiling.frame.gram[0][0].approximate();
    let mut all: Vec<Vec<i64>> = tiling
        .indices()
        .map(|simplex| {
            let edges = squared_edges(tiling, simplex);
            let rounded = |x: &Number| (x.approximate() / scale * 1e9).round() as i64;
            let mut edges: Vec<i64> = edges.iter().map(rounded).collect();
            edges.sort_unstable();
            edges
        })
        .collect();
    all.sort_unstable();
    all
}

#[test]
fn tilings_are_read_back() {
    for name in ["a15", "z", "icosahedral", "sigma", "slab", "cube-6"] {
        let tiling = space(name);
        let cbor = certificate(&tiling);
        let (read, statements) = of_certificate(&cbor).unwrap();
        let AnyTiling::Space(read) = read else {
            panic!("{name} is a tiling of space");
        };
        assert_eq!(lengths(&read), lengths(&tiling), "{name}");
        assert_eq!(read.vertices.len(), tiling.vertices.len(), "{name}");
        // Writing is determined by the tiling, up to the numbering.
        let again = examine(&read, &Options::default(), &|_| ()).unwrap();
        assert_eq!(again.statements, statements, "{name}");
        let json = print::to_json(&cbor).unwrap();
        for bytes in [&cbor, &json] {
            let (proved, _) = Proved::of_certificate(bytes, &Limits::DEFAULT).unwrap();
            assert_eq!(proved.certificate(), cbor, "{name}");
            assert_eq!(proved.statements(), statements, "{name}");
        }
    }
}

/// A certificate has the smallest field: a common factor of the Gram matrix plays no part, and
/// numbers of a larger field do not either.
#[test]
fn smallest_field() {
    let mut tiling = space("icosahedral");
    let field = tiling.frame.field.clone();
    assert_eq!(field.degree(), 2);
    let golden = read::certificate(&certificate(&tiling)).unwrap().claim;
    assert_eq!(golden.field.degree(), 2);
    tiling = space("a15");
    let rational = read::certificate(&certificate(&tiling)).unwrap().claim;
    assert_eq!(rational.field, format::Field::Rationals);
    // A15 with lattice constant 2 + a.
    let factor = field.generator() + field.integer(2);
    tiling.frame.field = field;
    tiling.frame.gram = tiling.frame.gram.map(|row| row.map(|x| x * &factor));
    let scaled = read::certificate(&certificate(&tiling)).unwrap().claim;
    assert_eq!(scaled, rational);
}

/// Rows in a random order are sorted again: few facets are open, as the kernel counts them.
#[test]
fn random_rows_are_sorted() {
    let tiling = supercell(&space("a15"), [6, 6, 6]);
    let open = |tiling: &Tiling<3>| {
        let proved = prove(tiling, &Options::default(), &|_| ()).unwrap();
        proved.verified().peak_facets
    };
    let given = open(&tiling);
    let mut rows: Vec<&[Corner<3>]> = tiling.simplices().collect();
    // A permutation: 7919 is prime and divides no number of simplices here.
    let n = rows.len();
    rows = (0..n).map(|k| rows[k * 7919 % n]).collect();
    let shuffled = Tiling {
        corners: rows.concat(),
        ..tiling.clone()
    };
    let sorted = open(&shuffled);
    assert!(
        sorted < 2 * given,
        "{sorted} facets open, {given} in the given order"
    );
}

/// A vertex of many simplices comes after all others.
#[test]
fn a_hub_is_numbered_last() {
    let n = 40usize;
    let tiling = double_wheel(n);
    let data = read::certificate(&certificate(&tiling)).unwrap();
    let hub = data.witness.vertices.len() as u32 - 1;
    let rows = data.witness.simplices.chunks_exact(3);
    let at_hub = rows.filter(|row| row.iter().any(|corner| corner.vertex == hub));
    assert_eq!(at_hub.count(), 8 * n);
}

/// The square [-n, n]² cut into triangles between its centre and the 8 n steps of its boundary.
fn double_wheel(n: usize) -> Tiling<2> {
    let n = n as i64;
    let corners = [(-n, -n), (n, -n), (n, n), (-n, n)];
    let mut points = vec![[0, 0]];
    for (k, (x, y)) in corners.into_iter().enumerate() {
        let (u, v) = corners[(k + 1) % 4];
        let steps = (0..2 * n).map(|t| [x + (u - x) / (2 * n) * t, y + (v - y) / (2 * n) * t]);
        points.extend(steps);
    }
    let rim = points.len() as u32 - 1;
    let triangle = |k: u32| [0, k + 1, (k + 1) % rim + 1].map(Corner::of);
    Tiling {
        frame: Frame::<2>::cubic().with_domain(Domain::Region(0)),
        vertices: Coordinates::from_integers(points, 1).unwrap(),
        corners: (0..rim).flat_map(triangle).collect(),
    }
}

/// Doubles of very different sizes are multiples of one power of two.
#[test]
fn doubles() {
    let points = vec![
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.1, 1e-25, 0.3],
    ];
    let tiling = Tiling {
        frame: Frame::<3>::cubic().with_domain(Domain::Region(0)),
        vertices: Coordinates::from_doubles(points).unwrap(),
        corners: (0..4).map(Corner::of).collect(),
    };
    assert!(matches!(tiling.vertices.form(), Form::Doubles(_)));
    let (read, _) = of_certificate(&certificate(&tiling)).unwrap();
    let AnyTiling::Space(read) = read else {
        panic!("a tiling of space");
    };
    assert_eq!(read.vertices.to_numbers(), tiling.vertices.to_numbers());
}

#[test]
fn claims_in_words() {
    let proved = prove(&space("a15"), &Options::default(), &|_| ()).unwrap();
    let words = acutile_core::proved::in_words(proved.verified());
    // The angles of Table 1 in the paper: 53.13 and 78.46 degrees; arccos(3/5) and arccos(1/5).
    for part in [
        "three-space is tiled face to face by 46 tetrahedra",
        "all dihedral angles are acute",
        "all dihedral angles are at most arccos(1/5) = 78.4630... degrees, attained",
        "all dihedral angles are at least arccos(3/5) = 53.1301... degrees, attained",
        "it is the Delaunay triangulation of its vertices",
        "it is tetrahedrally close packed",
    ] {
        assert!(words.contains(part), "{part}: {words}");
    }
    let claim = read::certificate(proved.certificate()).unwrap().claim;
    assert_eq!(transcribe::claim_in_words(&claim, 46, 0).unwrap(), words);
}
