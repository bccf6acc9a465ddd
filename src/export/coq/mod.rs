//! A certificate as a file for Coq that ends in its claim, a theorem about real three-space.
//!
//! The file holds the certificate's integers, denominators cleared, states the
//! claim with the words of proofs/theories/Statement.v and the claim's numbers, and
//! lets Coq's kernel run the checker of proofs/theories/Checker.v, which is proved
//! sound. So nothing here is trusted: a mistake makes `coqc` fail, or state
//! something else in plain sight. Called by `acutile export --coq`.

mod claim;
mod data;
mod numbers;
mod root;

use crate::certificate::Certificate;
use root::RootOf;
use std::fmt;

/// Why a certificate has no such file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NotATheorem {
    /// The development treats dimension 3 only.
    Dimension(usize),
    /// A text that is not a rational number, or a list of the wrong length.
    Malformed(String),
}

impl fmt::Display for NotATheorem {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            NotATheorem::Dimension(d) => {
                write!(f, "the Coq development is about dimension 3, not {d}")
            }
            NotATheorem::Malformed(what) => write!(f, "not a certificate: {what}"),
        }
    }
}

impl std::error::Error for NotATheorem {}

/// The file for `certificate`, whether or not its claim is true.
pub fn coq_theorem(certificate: &Certificate) -> Result<String, NotATheorem> {
    if certificate.claim.dimension != 3 {
        return Err(NotATheorem::Dimension(certificate.claim.dimension));
    }
    let root = RootOf::new(&certificate.claim.field)?;
    let mut text = HEAD.to_owned();
    if let Some(root) = &root {
        text += &claim::field(root)?;
    }
    text += &data::data(certificate, root.is_some())?;
    text += &match root {
        None => claim::over_the_rationals(certificate)?,
        Some(root) => claim::over_a_field(certificate, &root)?,
    };
    Ok(text)
}

const HEAD: &str = "\
(* The claim of an acutile certificate, as a theorem about real three-space. The
   words are defined in Statement.v; the last line prints the axioms. *)
From Coq Require Import Reals ZArith List Lra.
From Acutile Require Import Statement Checker Soundness Numbers.
Import ListNotations.
Local Open Scope Z_scope.

";
