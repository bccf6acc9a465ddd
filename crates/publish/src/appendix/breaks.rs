//! Where lines may break: in and after long numbers of formulas in the text.
//!
//! TeX breaks a formula after signs and relations only. A number of many digits is wider than that: it may break after every few
//! digits, with a mark, and a fraction after its slash. Formulas that are made to fit, and short numbers, stay as they are.

/// Longer numbers may break.
const LONG: usize = 12;
/// Digits between two places where a number may break.
const GROUP: usize = 6;
/// Digits around a slash after which a line may break.
const FRACTION: usize = 10;

/// The text with places where lines may break. Comments and decimals have none: programs read the former, and a package may read
/// the latter.
pub fn breakable(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for line in text.split_inclusive('\n') {
        if line.starts_with("% ") {
            out.push_str(line)
        } else {
            add_line(&mut out, line)
        }
    }
    out
}

fn add_line(out: &mut String, line: &str) {
    for (place, part) in line.split('$').enumerate() {
        if place > 0 {
            out.push('$');
        }
        // Between the first and the second dollar sign is a formula, and so on.
        match place % 2 {
            1 => add_formula(out, part),
            _ => out.push_str(part),
        }
    }
}

fn add_formula(out: &mut String, formula: &str) {
    let mut rest = formula;
    while let Some(first) = rest.chars().next() {
        let digits = run(rest);
        if let Some(decimal) = rest.strip_prefix(DECIMAL) {
            let end = decimal
                .find('}')
                .map_or(rest.len(), |end| DECIMAL.len() + end);
            out.push_str(&rest[..end]);
            rest = &rest[end..];
        } else if digits > 0 {
            add_number(out, &rest[..digits]);
            let after = &rest[digits..];
            let next = after.strip_prefix('/').map_or(0, run);
            if next > 0 && digits + next > FRACTION {
                out.push_str("/\\allowbreak ");
                rest = &after[1..];
            } else {
                rest = after;
            }
        } else {
            out.push(first);
            rest = &rest[first.len_utf8()..];
        }
    }
}

const DECIMAL: &str = "\\acutiledecimal{";

/// How many digits the text begins with.
fn run(text: &str) -> usize {
    text.bytes().take_while(u8::is_ascii_digit).count()
}

fn add_number(out: &mut String, digits: &str) {
    if digits.len() <= LONG {
        out.push_str(digits);
        return;
    }
    let mut rest = digits;
    while rest.len() > GROUP {
        let (group, others) = rest.split_at(GROUP);
        out.push_str(group);
        out.push_str("\\acutilebreak ");
        rest = others;
    }
    out.push_str(rest);
}

#[cfg(test)]
mod tests {
    use super::breakable;

    #[test]
    fn long_numbers_break_in_formulas_only() {
        let cases = [
            ("$123456789012$", "$123456789012$"),
            (
                "$1234567890123$",
                "$123456\\acutilebreak 789012\\acutilebreak 3$",
            ),
            (
                "1234567890123 $x$ 1234567890123",
                "1234567890123 $x$ 1234567890123",
            ),
            ("% $1234567890123$\n$1/2$", "% $1234567890123$\n$1/2$"),
            ("$123456/123456$", "$123456/\\allowbreak 123456$"),
            (
                "$\\acutiledecimal{12345678901234.5}$",
                "$\\acutiledecimal{12345678901234.5}$",
            ),
        ];
        for (text, expected) in cases {
            assert_eq!(breakable(text), expected);
        }
    }
}
