//! Claims are decided from their texts: false ones fail, and what cannot be computed is undecided.

use acutile_bounds::lists::PARTS;
use acutile_bounds::part::{Claim, Definition, Method, Part, applied, claim, given};
use acutile_bounds::{Check, Verdict, arithmetic::Function};

/// The checks of a part with other definitions and claims.
fn decided(method: Method, definitions: &[Definition], claims: &[Claim]) -> Vec<Check> {
    let part = Part {
        id: "test",
        method,
        definitions: definitions.to_vec().leak(),
        claims: claims.to_vec().leak(),
    };
    part.checks()
}

fn verdict(method: Method, definitions: &[Definition], text: &'static str) -> Verdict {
    decided(method, definitions, &[claim("a", "section 1", text)])[0].verdict
}

/// The text with its relation replaced by another one.
fn with_relation(text: &str, relation: &str) -> &'static str {
    let (left, right) = [" > ", " < ", " = "]
        .iter()
        .find_map(|sign| text.split_once(sign))
        .expect("a relation");
    format!("{left}{relation}{right}").leak()
}

/// For each claim of the proof, the opposite fails. An equation fails as either inequality.
#[test]
fn the_opposite_of_every_claim_fails() {
    for part in PARTS {
        for claim in part.claims {
            for relation in [" > ", " < ", " = "] {
                let text = with_relation(claim.text, relation);
                let verdict = verdict(part.method, part.definitions, text);
                let expected = if text == claim.text {
                    Verdict::Holds
                } else {
                    Verdict::Fails
                };
                assert_eq!(verdict, expected, "{}: {text}", part.id);
            }
        }
    }
}

/// Some claim depends on each definition of the proof. With another value of any single definition that is
/// not a choice, a claim of the part is lost.
#[test]
fn a_wrong_definition_is_noticed() {
    // p, z and phi are choices: 57.9 may be a little smaller.
    let choices = ["p", "z", "phi"];
    for part in PARTS {
        for k in 0..part.definitions.len() {
            if choices.contains(&part.definitions[k].name) {
                continue;
            }
            let lost = ["1000", "1/1000", "2/5"].into_iter().any(|value| {
                let mut definitions = part.definitions.to_vec();
                definitions[k] = given(definitions[k].name, value);
                let checks = decided(part.method, &definitions, part.claims);
                checks.iter().any(|check| check.verdict != Verdict::Holds)
            });
            let used = part.claims.iter().any(|claim| {
                let check = decided(part.method, part.definitions, &[*claim]);
                check[0]
                    .statement
                    .contains(&format!("{} = ", part.definitions[k].name))
            });
            assert!(lost || !used, "{}: {}", part.id, part.definitions[k].name);
        }
    }
}

/// Worse constants that a slip of the pen could give.
#[test]
fn false_variants_fail() {
    let exact = Method::Exact;
    let star = PARTS
        .iter()
        .find(|part| part.id == "star")
        .expect("a part")
        .definitions;
    for text in [
        // Lemma 5 with less slack, and with the sine of 45 degrees in place of 60.
        "C < 1.415",
        "(1 - c)/2*s^2/c/(sa/2) < 1.416",
        // Lemma 6 with a factor lost, and with √3 > 1.7234.
        "D1 + D2 > C",
        "D1 > K",
        "(29832 - 9570*1.7232)/129600 < (77/240)^2",
        // Step C without the factor 3 of the normal.
        "2*3*ca + 2*3*c*c > 3 + c^2",
        // The excess is compared with 60 and not with a0.
        "(1/2 + 1/4)/(3/4) = 7/11",
    ] {
        assert_eq!(verdict(exact, star, text), Verdict::Fails, "{text}");
    }
    let enclosed = Method::Enclosed;
    for text in [
        // cos 57.9 = 0.531399, cos 58 = 0.529919 (tables).
        "(21 - 2*sqrt(3))/33 < 0.529920",
        "7*51.4 > 360",
    ] {
        assert_eq!(verdict(enclosed, &[], text), Verdict::Fails, "{text}");
    }
}

/// Each part at an angle beyond its reach loses a claim.
#[test]
fn larger_angles_are_not_proved() {
    for (id, theta, lost) in [
        ("five-or-six", "74.7325", "at-most-six"),
        ("valences-73.29", "73.34", "no-two-sixes"),
        ("valences-73.31", "73.3128", "no-two-sixes"),
        ("star-73.29", "73.3", "uuu-pays"),
        ("star-73.29", "73.4", "t-with-two-utt"),
    ] {
        let part = PARTS.iter().find(|part| part.id == id).expect("a part");
        let mut definitions = part.definitions.to_vec();
        definitions[0] = given("theta", theta);
        let checks = decided(part.method, &definitions, part.claims);
        let check = checks
            .iter()
            .find(|check| check.id == lost)
            .expect("a claim");
        assert_eq!(check.verdict, Verdict::Fails, "{check}");
    }
}

#[test]
fn what_cannot_be_computed_is_undecided() {
    for method in [Method::Exact, Method::Enclosed] {
        for text in [
            "1/0 > 0",
            "sqrt(0 - 1) > 0",
            "unknown > 0",
            "1 >",
            "1",
            "1 + > 0",
        ] {
            assert_eq!(verdict(method, &[], text), Verdict::Undecided, "{text}");
        }
    }
    let enclosed = Method::Enclosed;
    let cosine = |text| applied("x", Function::Cos, text);
    assert_eq!(
        verdict(enclosed, &[cosine("181")], "x > 0"),
        Verdict::Undecided
    );
    let sine = applied("x", Function::Sin, "91");
    assert_eq!(verdict(enclosed, &[sine], "x > 0"), Verdict::Undecided);
    let arccos = applied("x", Function::Arccos, "1.01");
    assert_eq!(verdict(enclosed, &[arccos], "x < 1"), Verdict::Undecided);
    // A field has no cosines.
    assert_eq!(
        verdict(Method::Exact, &[cosine("60")], "x = 1/2"),
        Verdict::Undecided
    );
    // Equal irrational numbers: no enclosure separates them, and the field does.
    let equal = "sqrt(3)*sqrt(11) > sqrt(33)";
    assert_eq!(verdict(enclosed, &[], equal), Verdict::Undecided);
    assert_eq!(verdict(Method::Exact, &[], equal), Verdict::Fails);
    // A number outside the field is no number of it.
    assert_eq!(
        verdict(Method::Exact, &[], "sqrt(2) > 1"),
        Verdict::Undecided
    );
}

/// The printed statement contains the definitions that were used, and no others.
#[test]
fn statements_explain_their_names() {
    let definitions = [given("a", "2"), given("b", "a + 1"), given("unused", "7")];
    let claims = [claim("x", "section 1", "b > 2")];
    let check = &decided(Method::Exact, &definitions, &claims)[0];
    assert_eq!(check.statement, "b > 2 where a = 2, b = a + 1");
    assert_eq!(check.to_json()["place"], "docs/lower-bound.md, section 1");
    assert_eq!(check.to_json()["verdict"], "holds");
}
