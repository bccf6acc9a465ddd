//! Every finite step of the proof is decided, and holds.

use acutile_bounds::{THEOREMS, Verdict, checks};

#[test]
fn everything_holds() {
    let checks = checks(&|_| {});
    for check in &checks {
        println!("{check}");
    }
    for check in &checks {
        assert_eq!(check.verdict, Verdict::Holds, "{check}");
    }
    for theorem in THEOREMS {
        assert_eq!(theorem.verdict(&checks), Verdict::Holds, "{}", theorem.id);
    }
}
