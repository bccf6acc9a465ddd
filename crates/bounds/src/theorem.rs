//! The theorems, and which checks the proof of each one uses.

use super::check::{Check, Verdict};
use serde_json::{Value, json};

/// A theorem of docs/lower-bound.md.
#[derive(Clone, Copy, Debug)]
pub struct Theorem {
    /// A stable name.
    pub id: &'static str,
    /// The place in docs/lower-bound.md.
    pub place: &'static str,
    /// The statement in words.
    pub statement: &'static str,
    /// The parts whose checks the proof uses.
    pub parts: &'static [&'static str],
}

/// All theorems.
pub const THEOREMS: [Theorem; 8] = [
    Theorem {
        id: "face-to-face",
        place: "Theorem 1",
        statement: "every locally finite face-to-face tiling of space by tetrahedra has a dihedral \
                    angle above arccos(√3/6) = 73.2213…°",
        parts: &[
            "numbers",
            "digits",
            "valences",
            "contradiction",
            "star",
            "600-cell",
        ],
    },
    Theorem {
        id: "star",
        place: "Theorem 2",
        statement: "a vertex whose edges have valences 5 and 6, with a 6 and no two 6 in one \
                    triangle, has an edge with a dihedral angle of at least arccos(√3/6)",
        parts: &["numbers", "star"],
    },
    Theorem {
        id: "fourteen-neighbours",
        place: "Theorem 3",
        statement: "a vertex with 14 neighbours in a TCP tiling has an edge with a dihedral angle \
                    of at least 75°",
        parts: &["fourteen", "links"],
    },
    Theorem {
        id: "any-tiling",
        place: "Proposition 4",
        statement: "every locally finite tiling of space by tetrahedra, face to face or not, has a \
                    dihedral angle of at least arccos((√33-1)/16) = 72.7503…°",
        parts: &["digits", "any-tiling", "600-cell"],
    },
    Theorem {
        id: "valences",
        place: "Proposition 5",
        statement: "all edges of a locally finite face-to-face tiling with all dihedral angles \
                    below 74.7324° have valence 5 or 6",
        parts: &["five-or-six"],
    },
    Theorem {
        id: "face-to-face-73.29",
        place: "Theorem 6",
        statement: "every locally finite face-to-face tiling of space by tetrahedra has a dihedral \
                    angle above 73.29°",
        parts: &["600-cell", "valences-73.29", "star-73.29"],
    },
    Theorem {
        id: "tcp-73.44",
        place: "Theorem 7",
        statement: "every locally finite TCP tiling of space by tetrahedra has a dihedral angle \
                    above 73.44°",
        parts: &["600-cell", "boxes-73.44"],
    },
    Theorem {
        id: "face-to-face-73.31",
        place: "Theorem 8",
        statement: "every locally finite face-to-face tiling of space by tetrahedra has a dihedral \
                    angle above 73.31°",
        parts: &["600-cell", "valences-73.31", "boxes-73.44"],
    },
];

impl Theorem {
    /// The theorem as an object.
    pub fn to_json(&self, checks: &[Check]) -> Value {
        json!({
            "id": self.id,
            "place": format!("docs/lower-bound.md, {}", self.place),
            "statement": self.statement,
            "verdict": self.verdict(checks).word(),
            "parts": self.parts,
        })
    }

    /// Holds if every check of every part holds and no part is empty; else the first of fails and
    /// undecided that occurs.
    pub fn verdict(&self, checks: &[Check]) -> Verdict {
        let of_part = |part: &&str| {
            let mut verdicts = checks
                .iter()
                .filter(|check| check.part == *part)
                .map(|check| check.verdict)
                .peekable();
            match verdicts.peek() {
                Some(_) => worst(verdicts),
                None => Verdict::Undecided,
            }
        };
        worst(self.parts.iter().map(of_part))
    }
}

/// The theorem with this name.
pub fn theorem(id: &str) -> Option<&'static Theorem> {
    THEOREMS.iter().find(|theorem| theorem.id == id)
}

/// The first of fails, undecided and holds that occurs.
pub fn worst(verdicts: impl Iterator<Item = Verdict>) -> Verdict {
    let rank = |verdict: &Verdict| match verdict {
        Verdict::Holds => 0,
        Verdict::Undecided => 1,
        Verdict::Fails => 2,
    };
    verdicts.max_by_key(rank).unwrap_or(Verdict::Undecided)
}
