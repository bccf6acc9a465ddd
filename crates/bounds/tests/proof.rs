//! Every finite step of the proof holds, and the document names each of them.

use acutile_bounds::theorem::worst;
use acutile_bounds::{Check, THEOREMS, Verdict, checks, theorem};
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

fn document() -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/lower-bound.md");
    fs::read_to_string(path).expect("docs/lower-bound.md")
}

#[test]
fn every_step_holds_and_has_a_place() {
    let document = document();
    let checks = checks(&|_| {});
    let mut names = BTreeSet::new();
    for check in &checks {
        assert_eq!(check.verdict, Verdict::Holds, "{check}");
        assert!(names.insert((check.part, check.id)), "{check}: twice");
        let section = check.place.trim_start_matches("section ");
        let (number, rest) = section.split_once(", ").unwrap_or((section, ""));
        assert!(document.contains(&format!("\n## {number}. ")), "{check}");
        assert!(
            document.to_lowercase().contains(&rest.to_lowercase()),
            "{check}"
        );
        assert!(document.contains(&format!("`{}`", check.part)), "{check}");
    }
    for theorem in THEOREMS {
        assert_eq!(theorem.verdict(&checks), Verdict::Holds, "{}", theorem.id);
        assert!(
            document.contains(&format!("**{}.**", theorem.place)),
            "{}",
            theorem.id
        );
    }
}

/// Every part is used by a theorem, and every theorem names parts that exist.
#[test]
fn every_part_belongs_to_a_theorem() {
    let checks = checks(&|_| {});
    let parts: BTreeSet<&str> = checks.iter().map(|check| check.part).collect();
    let used: BTreeSet<&str> = THEOREMS
        .iter()
        .flat_map(|theorem| theorem.parts.to_vec())
        .collect();
    assert_eq!(parts, used);
}

fn check(part: &'static str, verdict: Verdict) -> Check {
    Check {
        part,
        id: "a",
        place: "section 1",
        statement: "1 > 0".to_owned(),
        verdict,
        found: "left 1, right 0".to_owned(),
    }
}

/// One bad step of one part is enough to lose a theorem, and so is a part without steps.
#[test]
fn a_theorem_needs_every_step() {
    let valences = theorem("valences").expect("Proposition 5");
    assert_eq!(valences.parts, ["five-or-six"]);
    let of = |verdicts: &[Verdict]| {
        let checks: Vec<Check> = verdicts.iter().map(|v| check("five-or-six", *v)).collect();
        valences.verdict(&checks)
    };
    use Verdict::{Fails, Holds, Undecided};
    assert_eq!(of(&[Holds, Holds]), Holds);
    assert_eq!(of(&[Holds, Undecided]), Undecided);
    assert_eq!(of(&[Undecided, Fails, Holds]), Fails);
    assert_eq!(of(&[]), Undecided);
    assert_eq!(valences.verdict(&[check("links", Holds)]), Undecided);
    assert_eq!(worst([].into_iter()), Undecided);
    assert!(theorem("no-such-theorem").is_none());
}

#[test]
fn steps_are_announced() {
    let seen = std::cell::RefCell::new(Vec::new());
    checks(&|part| seen.borrow_mut().push(part.to_owned()));
    let seen = seen.into_inner();
    assert!(seen.contains(&"600-cell".to_owned()) && seen.contains(&"boxes-73.44/uuu".to_owned()));
}
