//! Valences of face-to-face tilings, and tilings that are not face to face.

use crate::arithmetic::Function::{Arccos, Cos};
use crate::part::{Method, Part, applied, claim, given};

/// The decimals of two angles.
pub const DIGITS: Part = Part {
    id: "digits",
    method: Method::Enclosed,
    definitions: &[
        applied("theta", Arccos, "sqrt(3)/6"),
        applied("theta1", Arccos, "(sqrt(33) - 1)/16"),
    ],
    claims: &[
        claim("theta-from-below", "section 1", "theta > 73.2213"),
        claim("theta-from-above", "section 1", "theta < 73.2214"),
        claim("theta1-from-below", "section 1", "theta1 > 72.7503"),
        claim("theta1-from-above", "section 1", "theta1 < 72.7504"),
    ],
};

/// Proposition 5.
pub const FIVE_OR_SIX: Part = Part {
    id: "five-or-six",
    method: Method::Enclosed,
    definitions: &[
        given("theta", "74.7324"),
        applied("c", Cos, "theta"),
        applied("seventh", Cos, "360/7"),
    ],
    claims: &[
        claim("at-least-five", "section 5", "4*theta < 360"),
        claim("at-most-six", "section 5", "1 - 4*c^2/(1 - c) < seventh"),
    ],
};

/// Proposition 4.
pub const ANY_TILING: Part = Part {
    id: "any-tiling",
    method: Method::Exact,
    definitions: &[given("c", "(sqrt(33) - 1)/16")],
    claims: &[
        claim("theta-below-90", "section 5", "c > 0"),
        claim("angles-above-60", "section 5", "4*c^2/(1 - c) = 1/2"),
    ],
};

/// Steps (A) and (B) for theta = arccos(√3/6).
pub const VALENCES: Part = Part {
    id: "valences",
    method: Method::Enclosed,
    definitions: &[
        given("c", "sqrt(3)/6"),
        given("phi", "57.9"),
        given("p", "1.09"),
        given("z", "0.89"),
        applied("cosphi", Cos, "phi"),
        applied("half", Cos, "180 - 2*phi"),
        applied("diff", Cos, "180 - 3*phi"),
    ],
    claims: &[
        claim(
            "angles-above-phi",
            "section 6, step A",
            "1 - 4*c^2/(1 - c) < cosphi",
        ),
        claim("at-most-six", "section 6, step A", "7*phi > 360"),
        claim(
            "no-two-sixes",
            "section 6, step B",
            "2*half*diff > (p^2 + 2 + z^2 - c*(2 + 2*p*z + 4*z))/(2*p)",
        ),
    ],
};

/// Theorem 3.
pub const FOURTEEN: Part = Part {
    id: "fourteen",
    method: Method::Exact,
    definitions: &[given("theta", "75")],
    claims: &[
        claim(
            "sum-of-areas",
            "section 12",
            "24*theta + 24*theta + 2*360 = 12*360",
        ),
        claim("sharp-at-a-five", "section 12", "4*theta + 60 = 360"),
    ],
};
