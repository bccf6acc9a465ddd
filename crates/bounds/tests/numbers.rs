//! The constants of the proof against another program: mpmath with 30 digits, from trigonometric
//! formulas (`acos(sqrt(3)/6)`, `sin(theta/2)**2*tan(theta)*sin(theta)/(sin(a0)*sin(x0))`, …).

use acutile_bounds::Verdict;
use acutile_bounds::lists::{CONTRADICTION, NUMBERS, REFINED_STAR, STAR};
use acutile_bounds::part::{Part, claim};

/// Values cut off after ten decimals.
const AT_THE_ROOT: [(&str, &str); 9] = [
    ("c", "0.2886751345"),
    ("s", "0.9574271077"),
    ("ca", "0.3888888888"),
    ("sa", "0.9212846639"),
    ("K", "1.8090680674"),
    ("C", "1.4155186095"),
    ("D1", "0.9622504486"),
    ("D2", "0.3905076165"),
    ("cf", "0.4374785217"),
];

const AT_73_29: [(&str, &str); 11] = [
    ("c", "0.2875276870"),
    ("s", "0.9577723263"),
    ("ca", "0.3933001361"),
    ("sa", "0.9194101385"),
    ("K", "1.8156329223"),
    ("C", "1.4390855912"),
    ("D1", "0.9599464436"),
    ("D2", "0.3873991671"),
    ("cf", "0.4448414398"),
    ("x0", "59.2031192128"),
    ("b", "70.0393338389"),
];

/// Asserts that each name of a part is within 10^-10 above the value.
fn compare(part: &Part, values: &[(&'static str, &'static str)]) {
    for (name, value) in values {
        let above = format!("{name} > {value}").leak();
        let below = format!("{name} < {value} + 1e-10").leak();
        let claims = vec![claim("above", "", above), claim("below", "", below)].leak();
        for check in (Part { claims, ..*part }).checks() {
            assert_eq!(check.verdict, Verdict::Holds, "{check}");
        }
    }
}

#[test]
fn constants_agree_with_mpmath() {
    for part in [&NUMBERS, &STAR, &CONTRADICTION] {
        compare(part, &AT_THE_ROOT);
    }
    compare(&REFINED_STAR, &AT_73_29);
}
