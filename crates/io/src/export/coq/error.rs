//! Why a certificate has no file for Coq.

use std::fmt;

/// Why a certificate has no such file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NotATheorem {
    /// The development treats the dimensions 2 and 3.
    Dimension(usize),
    /// The soundness of regions is proved on paper only.
    Region,
    /// So is that of planes.
    Plane,
    /// Data that break a rule of the format, which it names.
    Malformed(&'static str),
}

impl fmt::Display for NotATheorem {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            NotATheorem::Dimension(d) => {
                write!(
                    f,
                    "the Coq development is about the dimensions 2 and 3, not {d}"
                )
            }
            NotATheorem::Region => f.write_str("the Coq development does not treat regions"),
            NotATheorem::Plane => {
                f.write_str("the Coq development does not treat the statement \"uncrossed plane\"")
            }
            NotATheorem::Malformed(rule) => write!(f, "not a certificate: {rule}"),
        }
    }
}

impl std::error::Error for NotATheorem {}

/// `Ok` if the condition holds, else the rule that is broken.
pub(super) fn require(condition: bool, rule: &'static str) -> Result<(), NotATheorem> {
    if condition {
        Ok(())
    } else {
        Err(NotATheorem::Malformed(rule))
    }
}
