//! A certificate as a file for Coq that ends in its claim, a theorem about real space or the real plane.
//!
//! The file holds the certificate's integers, denominators cleared, states the
//! claim with the words of proofs/theories/Statement.v and the claim's numbers, and
//! lets Coq's kernel run the checker of proofs/theories/Checker.v, which is proved
//! sound. So nothing here is trusted: a mistake makes `coqc` fail, or state
//! something else in plain sight. Called by `acutile export --coq`.

mod claim;
mod data;
mod numbers;
mod plane;
mod root;

use acutile_format1::certificate::{Certificate, Domain};
use claim::Theorem;
use root::RootOf;
use std::fmt;

/// Why a certificate has no such file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NotATheorem {
    /// The development treats the dimensions 2 and 3.
    Dimension(usize),
    /// The soundness of regions is proved on paper only.
    Region,
    /// A text that is not a rational number, or a list of the wrong length.
    Malformed(String),
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
            NotATheorem::Malformed(what) => write!(f, "not a certificate: {what}"),
        }
    }
}

impl std::error::Error for NotATheorem {}

/// The file for `certificate`, whether or not its claim is true.
pub fn coq_theorem(certificate: &Certificate) -> Result<String, NotATheorem> {
    if certificate.claim.domain == Domain::Region {
        return Err(NotATheorem::Region);
    }
    let words = match certificate.claim.dimension {
        3 => &claim::SPACE,
        2 => &claim::PLANE,
        d => return Err(NotATheorem::Dimension(d)),
    };
    let theorem = Theorem { certificate, words };
    let root = RootOf::new(&certificate.claim.field)?;
    let mut text = HEAD.to_owned();
    if let Some(root) = &root {
        text += &claim::field(root)?;
    }
    text += &match certificate.claim.dimension {
        2 => plane::data(certificate, root.is_some())?,
        _ => data::data(certificate, root.is_some())?,
    };
    text += &match root {
        None => theorem.over_the_rationals()?,
        Some(root) => theorem.over_a_field(&root)?,
    };
    Ok(text)
}

const HEAD: &str = "\
(* The claim of an acutile certificate, as a theorem about real space or the real
   plane. The words are defined in Statement.v and PlaneStatement.v; the last line prints the axioms. *)
From Coq Require Import Reals ZArith List Lra.
From Acutile Require Import Statement PlaneStatement Checker PlaneChecker Soundness PlaneSoundness Numbers.
Import ListNotations.
Local Open Scope Z_scope.

";
