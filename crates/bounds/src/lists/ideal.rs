//! The angle theta = arccos(√3/6), exactly over Q(√3, √11).

use crate::part::{Claim, Definition, Method, Part, claim, given};

/// cos and sin of theta and of a0, and the constants of section 8 and 9.
const DEFINITIONS: &[Definition] = &[
    given("c", "sqrt(3)/6"),
    given("s", "sqrt(11)/(2*sqrt(3))"),
    given("ca", "8*c^4 - 8*c^2 + 1"),
    given("sa", "4*s*c*(1 - 2*c^2)"),
    given("K", "1/(2*s*c)"),
    given("C", "(1 - c)/2*s^2/c/(sa*sqrt(3)/2)"),
    given("D1", "sa/s"),
    given("D2", "D1*c/(1 - c)"),
    given("cf", "s^2*ca/sa*(1 + c)/s - c^2"),
];

/// The numbers of section 2.
pub const NUMBERS: Part = Part {
    id: "numbers",
    method: Method::Exact,
    definitions: DEFINITIONS,
    claims: &[
        claim("sine", "section 2", "s^2 = 1 - c^2"),
        claim("sine-is-positive", "section 2", "s > 0"),
        claim("theta-below-90", "section 2", "c > 0"),
        claim("theta-above-45", "section 2", "2*c^2 < 1"),
        // cos 72° is the positive root of 4x² + 2x - 1.
        claim("theta-above-72", "section 2", "4*c^2 + 2*c < 1"),
        claim("cosine-of-a0", "section 2", "ca = 7/18"),
        claim("sine-of-a0", "section 2", "sa = 5*sqrt(11)/18"),
        claim("sine-of-a0-squared", "section 2", "sa^2 = 1 - ca^2"),
        claim("a0-above-60", "section 2", "ca < 1/2"),
        claim("a0-below-theta", "section 2", "ca > c"),
    ],
};

/// The last step of the proof of Theorem 1.
pub const CONTRADICTION: Part = Part {
    id: "contradiction",
    method: Method::Exact,
    definitions: DEFINITIONS,
    claims: &[claim(
        "tetrahedron-with-three-a0",
        "section 6, step C",
        "2*3*ca + 2*3*(3*c)*c > 3 + (3*c)^2",
    )],
};

/// Lemmas 3 to 6.
pub const STAR: Part = Part {
    id: "star",
    method: Method::Exact,
    definitions: DEFINITIONS,
    claims: LEMMAS,
};

const LEMMAS: &[Claim] = &[
    claim(
        "least-side",
        "section 8, Lemma 3",
        "(ca + ca^2)/sa^2 = 7/11",
    ),
    claim(
        "least-apex-is-60",
        "section 8, Lemma 3",
        "s^2*7/11 - c^2 = 1/2",
    ),
    claim(
        "greatest-apex-is-theta",
        "section 8, Lemma 3",
        "s^2*c/(1 - c) - c^2 = c",
    ),
    claim("K", "section 8, Lemma 4", "K = 6/sqrt(11)"),
    claim("C", "section 8, Lemma 5", "C < 1.416"),
    claim("D1", "section 9, Lemma 6", "D1 = 5*sqrt(3)/9"),
    claim("D2", "section 9, Lemma 6", "D2 = D1*sqrt(3)/(6 - sqrt(3))"),
    claim("uuu-grows", "section 9, Lemma 6", "2*(D1 + 2*D2) > K"),
    claim("utt-grows", "section 9, Lemma 6", "3/2*(D1 + D2) > C"),
    claim(
        "f-at-the-end",
        "section 9, Lemma 6",
        "cf = (1 + 7*sqrt(3))/30",
    ),
    claim("f-limit", "section 9, Lemma 6", "3/2*s^2*ca/sa/K = 77/240"),
    claim(
        "f-grows-fast",
        "section 9, Lemma 6",
        "((1 - c)/2)^2*(1 - cf^2) < (77/240)^2",
    ),
];
