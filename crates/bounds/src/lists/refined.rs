//! Angles given in degrees: 73.29 with inequalities only, 73.31 with the boxes of [`crate::boxes`].

use crate::arithmetic::Function::{Arccos, Cos, Sin};
use crate::part::{Claim, Definition, Method, Part, applied, claim, given};

/// Steps (A) and (B).
const VALENCES: &[Claim] = &[
    claim("at-least-five", "section 13", "4*theta < 360"),
    claim("at-most-six", "section 13", "7*phi > 360"),
    claim(
        "no-two-sixes",
        "section 13",
        "2*half*diff > (p^2 + 2 + z^2 - c*(2 + 2*p*z + 4*z))/(2*p)",
    ),
];

/// The numbers of steps (A) and (B) at an angle.
const fn valences(theta: &'static str) -> [Definition; 7] {
    [
        given("theta", theta),
        given("p", "1.0915"),
        given("z", "0.8875"),
        applied("c", Cos, "theta"),
        applied("phi", Arccos, "1 - 4*c^2/(1 - c)"),
        applied("half", Cos, "180 - 2*phi"),
        applied("diff", Cos, "180 - 3*phi"),
    ]
}

/// Steps (A) and (B) at 73.29 degrees.
pub const REFINED_VALENCES: Part = Part {
    id: "valences-73.29",
    method: Method::Enclosed,
    definitions: &valences("73.29"),
    claims: VALENCES,
};

/// Steps (A) and (B) at 73.31 degrees.
pub const WIDER_VALENCES: Part = Part {
    id: "valences-73.31",
    method: Method::Enclosed,
    definitions: &valences("73.31"),
    claims: VALENCES,
};

const STAR: &[Definition] = &[
    given("theta", "73.29"),
    given("a0", "360 - 4*theta"),
    given("kappa", "5*theta - 360"),
    applied("c", Cos, "theta"),
    applied("s", Sin, "theta"),
    applied("ca", Cos, "a0"),
    applied("sa", Sin, "a0"),
    applied("x0", Arccos, "1/(8*c^2) - 1"),
    applied("sx", Sin, "x0"),
    given("K", "1/(2*s*c)"),
    given("C", "(1 - c)/2*s^2/c/(sa*sx)"),
    given("D1", "sa/s"),
    given("D2", "D1*c/(1 - c)"),
    given("rate", "3/2*(D1 + D2) - C"),
    given("cf", "s^2*ca/sa*(1 + c)/s - c^2"),
    applied("b", Arccos, "(3 - 9*c^2)/2 - 2*ca"),
];

/// The star of a vertex at 73.29 degrees.
pub const REFINED_STAR: Part = Part {
    id: "star-73.29",
    method: Method::Enclosed,
    definitions: STAR,
    claims: &[
        claim("a0-above-60", "section 13", "a0 > 60"),
        claim("a0-below-theta", "section 13", "kappa > 0"),
        claim("x0-below-theta", "section 13", "x0 < theta"),
        claim("uuu-grows", "section 13", "2*(D1 + 2*D2) > K"),
        claim("utt-grows", "section 13", "rate > 0"),
        claim(
            "f-grows-fast",
            "section 13",
            "(1 - c)/2*sqrt(1 - cf^2)*K < 3/2*s^2*ca/sa",
        ),
        claim("concave", "section 13", "a0 + 3*kappa < 90"),
        claim("uuu-excess", "section 13", "b > a0"),
        claim(
            "uuu-pays",
            "section 13",
            "6*(x0 - 60) + (2*(D1 + 2*D2) - K)*(b - a0) > 0",
        ),
        claim(
            "t-with-two-utt",
            "section 13",
            "3*(x0 - 60) + rate*kappa > 0",
        ),
        claim(
            "t-with-one-utt",
            "section 13",
            "2*(x0 - 60) + rate*kappa > 0",
        ),
        claim("t-with-one-tt", "section 13", "2*(x0 - 60) + D2*kappa > 0"),
        claim("t-with-two-tt", "section 13", "x0 - 60 + D2*kappa > 0"),
    ],
};
