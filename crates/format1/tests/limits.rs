//! Each limit holds at n and refuses at n + 1.

use acutile_format1::certificate::{
    AlgebraicField, Certificate, Field, Number, Statement, to_bytes,
};
use acutile_format1::verifier::{Limits, verify};

fn valid(name: &str) -> Certificate {
    serde_json::from_slice(&bytes(name)).unwrap()
}

fn bytes(name: &str) -> Vec<u8> {
    let root = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");
    std::fs::read(format!("{root}/tests/certificates/valid/{name}.json")).unwrap()
}

/// The code of the answer, or "verified".
fn answer(bytes: &[u8], limits: &Limits) -> &'static str {
    match verify(bytes, limits) {
        Ok(_) => "verified",
        Err(refusal) => refusal.code(),
    }
}

#[test]
fn bytes_of_the_file() {
    let file = bytes("space-cube-6");
    let limit = |bytes| Limits {
        bytes,
        ..Limits::DEFAULT
    };
    let size = file.len() as u64;
    assert_eq!(answer(&file, &limit(size)), "verified");
    assert_eq!(answer(&file, &limit(size - 1)), "too-many-bytes");
}

#[test]
fn the_default_of_bytes() {
    let mut file = bytes("space-cube-6");
    file.resize(Limits::DEFAULT.bytes as usize, b' ');
    assert_eq!(answer(&file, &Limits::DEFAULT), "canonical");
    file.push(b' ');
    assert_eq!(answer(&file, &Limits::DEFAULT), "too-many-bytes");
}

#[test]
fn simplices() {
    let file = bytes("space-cube-6");
    let limit = |simplices| Limits {
        simplices,
        ..Limits::DEFAULT
    };
    assert_eq!(answer(&file, &limit(6)), "verified");
    assert_eq!(answer(&file, &limit(5)), "too-many-simplices");
}

/// A Gram matrix scaled by 10^k stays right; 2 10^k has k + 1 digits.
#[test]
fn digits_of_a_number() {
    let scaled = |zeros: usize| {
        let mut certificate = valid("plane-equilateral");
        for number in certificate.claim.gram.iter_mut().flatten() {
            number.0[0].push_str(&"0".repeat(zeros));
        }
        to_bytes(&certificate)
    };
    let digits = Limits::DEFAULT.digits;
    assert_eq!(answer(&scaled(digits - 1), &Limits::DEFAULT), "verified");
    assert_eq!(answer(&scaled(digits), &Limits::DEFAULT), "too-many-digits");
    let more = Limits {
        digits: digits + 1,
        ..Limits::DEFAULT
    };
    assert_eq!(answer(&scaled(digits), &more), "verified");
}

/// The plane lattice moved by (1/1000, 1/7777), whose common denominator 7777000
/// has seven digits, while no number has more than five.
#[test]
fn digits_of_the_common_denominator() {
    let mut certificate = valid("plane-equilateral-acute");
    let texts = ["1/1000", "1/7777"];
    certificate.witness.vertices[0] = texts.map(|text| Number(vec![text.to_owned()])).to_vec();
    let file = to_bytes(&certificate);
    let limit = |digits| Limits {
        digits,
        ..Limits::DEFAULT
    };
    assert_eq!(answer(&file, &limit(7)), "verified");
    assert_eq!(answer(&file, &limit(6)), "common-denominator");
}

/// x^n - 2 has one root between 1 and 2, and a rising derivative there.
#[test]
fn degree_of_the_field() {
    let of_degree = |degree: usize| {
        let mut certificate = valid("plane-equilateral");
        let mut polynomial = vec!["0".to_owned(); degree + 1];
        polynomial[0] = "-2".to_owned();
        polynomial[degree] = "1".to_owned();
        let root = ("1".to_owned(), "2".to_owned());
        certificate.claim.field = Field::Algebraic(AlgebraicField { polynomial, root });
        to_bytes(&certificate)
    };
    let degree = Limits::DEFAULT.degree;
    assert_eq!(answer(&of_degree(degree), &Limits::DEFAULT), "verified");
    assert_eq!(answer(&of_degree(degree + 1), &Limits::DEFAULT), "degree");
}

/// g_11 = a - 7/5 with a = sqrt 2 = 1.4142… in (1, 2). Halving gives (1, 3/2),
/// (5/4, 3/2), (11/8, 3/2), (11/8, 23/16), (45/32, 23/16), and 45/32 = 1.40625 is the
/// first lower end above 7/5: the sign of g_11 needs five halvings.
#[test]
fn bisections_for_a_sign() {
    let mut certificate = valid("plane-square-triangle");
    certificate.claim.field = Field::Algebraic(AlgebraicField {
        polynomial: ["-2", "0", "1"].map(str::to_owned).to_vec(),
        root: ("1".to_owned(), "2".to_owned()),
    });
    certificate.claim.statements.truncate(1);
    let plane = valid("plane-equilateral").witness;
    certificate.witness = plane;
    let number = |texts: &[&str]| Number(texts.iter().map(|text| text.to_string()).collect());
    certificate.claim.gram = vec![
        vec![number(&["-7/5", "1"]), number(&["0"])],
        vec![number(&["0"]), number(&["1"])],
    ];
    let file = to_bytes(&certificate);
    let limit = |bisections| Limits {
        bisections,
        ..Limits::DEFAULT
    };
    assert_eq!(answer(&file, &limit(5)), "verified");
    assert_eq!(answer(&file, &limit(4)), "sign-undecided");
    assert_eq!(answer(&file, &Limits::DEFAULT), "verified");
}

/// Degree 1, one word, six simplices: six word products.
#[test]
fn work() {
    let file = bytes("space-cube-6");
    let limit = |work| Limits {
        work,
        ..Limits::DEFAULT
    };
    assert_eq!(answer(&file, &limit(6)), "verified");
    assert_eq!(answer(&file, &limit(5)), "work");
}

/// 10^40 has 133 bits, three words: two triangles, nine word products each.
#[test]
fn work_for_a_ratio() {
    let mut certificate = valid("plane-equilateral");
    let ratio = "1".to_owned() + &"0".repeat(40);
    certificate.claim.statements = vec![
        Statement::FaceToFaceTiling,
        Statement::RadiusEdgeBelow(ratio),
    ];
    let file = to_bytes(&certificate);
    let limit = |work| Limits {
        work,
        ..Limits::DEFAULT
    };
    assert_eq!(answer(&file, &limit(18)), "verified");
    assert_eq!(answer(&file, &limit(17)), "work");
}

/// x² - 3 in (1, 2), and G with a = sqrt 3 in the first minor alone. While all numbers
/// have one word, an evaluation costs 2 m² with m coefficients: 18 for p, 8 for p' and
/// for the minor. That is p at both ends and once more at the upper, p', the minor, and
/// k halvings: 70 + 18 k. Work 8 allows the products (4 for each of two triangles) and
/// 512 for signs: 24 halvings, 502, and not 25, 520.
#[test]
fn work_for_signs() {
    let mut certificate = valid("plane-equilateral-times-sqrt-3");
    certificate.claim.statements.truncate(1);
    let file = to_bytes(&certificate);
    let limit = |work, bisections| Limits {
        work,
        bisections,
        ..Limits::DEFAULT
    };
    assert_eq!(answer(&file, &limit(8, 24)), "verified");
    assert_eq!(answer(&file, &limit(8, 25)), "work");
    assert_eq!(answer(&file, &limit(9, 25)), "verified");
    assert_eq!(answer(&file, &limit(7, 24)), "work");
}

/// The cube: 6 simplices, 6 faces of 4 vertices each against its 8 vertices, and
/// the tiling's 8 vertices against 6 faces: 6 + 24 * 8 + 6 * 8 = 246.
#[test]
fn work_for_a_domain() {
    let file = bytes("solid-cube-6");
    let limit = |work| Limits {
        work,
        ..Limits::DEFAULT
    };
    assert_eq!(answer(&file, &limit(246)), "verified");
    assert_eq!(answer(&file, &limit(245)), "work");
}
