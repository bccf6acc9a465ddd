//! How a command ended, and its exit code.

/// How a command ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// Everything asked for was proved or done.
    Done,
    /// Something was refuted or rejected.
    Refuted,
    /// Something could not be read, or written.
    Failed,
    /// Something was neither proved nor refuted.
    Declined,
}

impl Outcome {
    /// The exit code.
    pub fn code(self) -> u8 {
        match self {
            Outcome::Done => 0,
            Outcome::Refuted => 1,
            Outcome::Failed => 2,
            Outcome::Declined => 3,
        }
    }

    /// The outcome of several: the first of refuted, failed, declined that occurs.
    pub fn and(self, other: Outcome) -> Outcome {
        let rank = |outcome| match outcome {
            Outcome::Refuted => 3,
            Outcome::Failed => 2,
            Outcome::Declined => 1,
            Outcome::Done => 0,
        };
        if rank(other) > rank(self) {
            other
        } else {
            self
        }
    }
}

/// The outcome with this exit code.
pub fn exit_outcome(code: u8) -> Outcome {
    match code {
        0 => Outcome::Done,
        1 => Outcome::Refuted,
        3 => Outcome::Declined,
        _ => Outcome::Failed,
    }
}
