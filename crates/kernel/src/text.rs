//! Words for verdicts: this module belongs to the program, not to the kernel.

use acutile_kernel::{Kind, Limit, Place, Refusal, Value};
use num_bigint::BigInt;

pub fn verdict(kind: Kind) -> &'static str {
    match kind {
        Kind::Rejected => "rejected",
        Kind::Malformed => "malformed",
        Kind::Declined => "declined",
    }
}

pub fn place(place: Place) -> String {
    match place {
        Place::Byte(offset) => format!("byte {offset}"),
        Place::Field => "field".into(),
        Place::Minor(rows) => format!("minor {rows} of the Gram matrix"),
        Place::Domain => "domain".into(),
        Place::Face(face) => format!("face {face} of the domain"),
        Place::Statement(statement) => format!("statement {statement}"),
        Place::Vertex(vertex) => format!("vertex {vertex}"),
        Place::Boundary(facet) => format!("boundary facet {facet}"),
        Place::BoundaryPair(first, second) => format!("boundary facets {first} and {second}"),
        Place::Simplex(simplex) => format!("simplex {simplex}"),
        Place::Facet(simplex, facet) => format!("simplex {simplex}, facet {facet}"),
        Place::Edge(simplex, i, j) => format!("simplex {simplex}, edge {i} {j}"),
        Place::Angle(simplex, i, j) => format!("simplex {simplex}, facets {i} and {j}"),
        Place::Witness => "witness".into(),
    }
}

/// The value that is wrong, if there is one.
pub fn value(refusal: &Refusal) -> Option<String> {
    match &refusal.value {
        Value::Nothing | Value::Exceeds(..) => None,
        Value::Integer(value) => Some(value.to_string()),
        Value::Quotient(p, q) => Some(quotient(p, q)),
    }
}

/// The option that accepts more, and a value that suffices, if one is known.
pub fn option(refusal: &Refusal, length: Option<u64>) -> Option<(&'static str, Option<u64>)> {
    let Value::Exceeds(limit, suffices) = &refusal.value else {
        return None;
    };
    Some(match limit {
        Limit::Bytes => ("--max-bytes", length),
        Limit::Simplices => ("--max-simplices", *suffices),
        Limit::Bits => ("--max-bits", *suffices),
        Limit::Degree => ("--max-degree", *suffices),
        Limit::Work => ("--max-work", *suffices),
    })
}

fn quotient(p: &[BigInt], q: &[BigInt]) -> String {
    let divisor = p
        .iter()
        .chain(q)
        .fold(BigInt::ZERO, |x, y| gcd(x, y.clone()));
    let lowest = |number: &[BigInt]| -> Vec<BigInt> {
        let divided = number.iter().filter(|_| divisor != BigInt::ZERO);
        divided.map(|c| c / &divisor).collect()
    };
    let (p, q) = (sum(&lowest(p)), sum(&lowest(q)));
    if q == "1" { p } else { format!("{p}/{q}") }
}

fn gcd(mut x: BigInt, mut y: BigInt) -> BigInt {
    while y != BigInt::ZERO {
        (x, y) = (y.clone(), x % y);
    }
    if x < BigInt::ZERO { -x } else { x }
}

/// Σ c_k a^k
fn sum(coefficients: &[BigInt]) -> String {
    let terms = coefficients
        .iter()
        .zip(0..)
        .filter(|(c, _)| **c != BigInt::ZERO);
    let terms = terms.map(|(c, k)| match k {
        0 => c.to_string(),
        1 => format!("{c} a"),
        _ => format!("{c} a^{k}"),
    });
    let terms: Vec<String> = terms.collect();
    match terms.as_slice() {
        [] => "0".into(),
        [term] if !term.contains(' ') => term.clone(),
        terms => format!("({})", terms.join(" + ")),
    }
}

/// The name, or a JSON string where it has unusual characters. So no name can forge a line.
pub fn name(name: &str) -> String {
    let is_usual = |c: char| c.is_ascii_alphanumeric() || "._/-+=@%~".contains(c);
    if !name.is_empty() && name.chars().all(is_usual) {
        name.into()
    } else {
        json(name)
    }
}

/// A JSON string in printable ASCII.
pub fn json(text: &str) -> String {
    let mut out = String::from("\"");
    for unit in text.encode_utf16() {
        match u8::try_from(unit)
            .ok()
            .filter(|byte| (32..127).contains(byte))
        {
            Some(byte @ (b'"' | b'\\')) => out.extend(['\\', char::from(byte)]),
            Some(byte) => out.push(char::from(byte)),
            None => out.push_str(&format!("\\u{unit:04x}")),
        }
    }
    out + "\""
}
