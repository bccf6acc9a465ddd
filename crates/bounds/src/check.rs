//! One finite step of the proof, with its verdict.

use serde_json::{Value, json};
use std::fmt;

/// The result of a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// It holds.
    Holds,
    /// It does not hold.
    Fails,
    /// Neither was shown: enclosures overlap, or a limit was reached.
    Undecided,
}

impl Verdict {
    /// Holds or fails.
    pub fn of(holds: bool) -> Verdict {
        if holds {
            Verdict::Holds
        } else {
            Verdict::Fails
        }
    }

    /// The verdict in a word.
    pub fn word(self) -> &'static str {
        match self {
            Verdict::Holds => "holds",
            Verdict::Fails => "fails",
            Verdict::Undecided => "undecided",
        }
    }
}

/// A step of the proof that a machine can decide.
#[derive(Clone, Debug)]
pub struct Check {
    /// The part of the proof that needs it.
    pub part: &'static str,
    /// A stable name within the part.
    pub id: &'static str,
    /// The place in docs/lower-bound.md.
    pub place: &'static str,
    /// The statement that was decided.
    pub statement: String,
    /// Whether the statement holds.
    pub verdict: Verdict,
    /// How it was decided, and the values found.
    pub found: String,
}

impl Check {
    /// The check as an object.
    pub fn to_json(&self) -> Value {
        json!({
            "part": self.part,
            "id": self.id,
            "place": format!("docs/lower-bound.md, {}", self.place),
            "statement": self.statement,
            "verdict": self.verdict.word(),
            "found": self.found,
        })
    }
}

impl fmt::Display for Check {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let (part, id, place) = (self.part, self.id, self.place);
        writeln!(f, "{} {part}/{id} [{place}]", self.verdict.word())?;
        writeln!(f, "  {}", self.statement)?;
        write!(f, "  {}", self.found)
    }
}
