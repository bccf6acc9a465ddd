//! Words for names, places and values. This module belongs to the program, not to the kernel.

use acutile_kernel::{Limits, Place, Refusal, Value};
use num_bigint::BigInt;
use num_integer::Integer;

/// The place, the value, and the option that accepts more.
pub fn refusal(refusal: &Refusal, length: Option<u64>) -> String {
    let at = refusal.point.iter().map(|(name, value)| match value {
        Value::Quotient(p, q) => format!("{name} = {}", quotient(p, q)),
        _ => name.clone(),
    });
    let point = at.collect::<Vec<_>>().join(", ");
    let place = place(refusal.place) + if point.is_empty() { "" } else { " at " } + &point;
    match &refusal.value {
        Value::Nothing => place,
        Value::Integer(value) => format!("{place}: found {value}"),
        Value::Quotient(p, q) => format!("{place}: found {}", quotient(p, q)),
        Value::Limit("work", _) => format!("{place}: use a larger --max-work; the default is {}", Limits::DEFAULT.work),
        Value::Limit(name, suffices) => {
            let suffices = suffices.or(length).unwrap_or(u64::MAX);
            format!("{place}: use --max-{name} {suffices}")
        }
    }
}

/// `Angle(17, 0, 1)` as `angle 17 0 1`.
fn place(place: Place) -> String {
    let mut text = String::new();
    for c in format!("{place:?}").chars() {
        match c {
            'A'..='Z' if text.is_empty() => text.push(c.to_ascii_lowercase()),
            'A'..='Z' => text.extend([' ', c.to_ascii_lowercase()]),
            '(' => text.push(' '),
            ')' | ',' => {}
            c => text.push(c),
        }
    }
    text
}

/// In lowest terms; a number of a field as the list of its coefficients of 1, a, a², …
fn quotient(p: &[BigInt], q: &[BigInt]) -> String {
    let divisor = p.iter().chain(q).fold(BigInt::ZERO, |divisor, x| divisor.gcd(x));
    let number = |number: &[BigInt]| {
        let length = number.iter().rposition(|c| *c != BigInt::ZERO).map_or(0, |last| last + 1);
        let lowest: Vec<String> = number.iter().take(length).map(|c| (c / &divisor).to_string()).collect();
        match lowest.as_slice() {
            [] => "0".into(),
            [value] => value.clone(),
            values => format!("[{}]", values.join(",")),
        }
    };
    let (p, q) = (number(p), number(q));
    if q == "1" { p } else { format!("{p}/{q}") }
}

/// The name, or a JSON string where it has unusual characters. So no name can forge a line.
pub fn name(name: &str) -> String {
    let is_usual = |c: char| c.is_ascii_alphanumeric() || "._/-+=@%~".contains(c);
    if !name.is_empty() && name.chars().all(is_usual) { name.into() } else { json(name) }
}

/// A JSON string in printable ASCII.
pub fn json(text: &str) -> String {
    let mut out = String::from("\"");
    for unit in text.encode_utf16() {
        match u8::try_from(unit) {
            Ok(byte @ (b'"' | b'\\')) => out.extend(['\\', char::from(byte)]),
            Ok(byte @ b' '..=b'~') => out.push(char::from(byte)),
            _ => out += &format!("\\u{unit:04x}"),
        }
    }
    out + "\""
}
