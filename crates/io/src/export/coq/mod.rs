//! A certificate as a file for Coq that ends in its claim, a theorem about real space or the real plane.
//!
//! The file contains the certificate's integers, and the mates of the facets as a hint. It states
//! the claim with the words of `Statement.v` and the claim's numbers, and lets Coq's kernel run the
//! checker of `Checker.v`, which is proved sound. So nothing here is trusted: a mistake makes
//! `coqc` fail, or state something else in plain sight.
//!
//! | file | contains |
//! |---|---|
//! | `claim` | the theorem and its proof |
//! | `statements` | the statements of the claim, for the checker and for people |
//! | `data`, `plane` | the witness as a term, in space and in the plane |
//! | `pairing` | rows of corners, and the mates of their facets |
//! | `error` | why a certificate has no such file |
//! | `numbers`, `root` | numbers as terms; the root of the field, isolated |
//!
//! Regions are left out: the development does not treat them.

mod claim;
mod data;
mod error;
mod numbers;
mod pairing;
mod plane;
mod root;
mod statements;

pub use error::NotATheorem;

use acutile_core::format;
use claim::Theorem;
use format::{Certificate, Domain, Field};
use root::RootOf;

/// The file for `certificate`, whether or not its claim is true.
///
/// # Errors
/// [`NotATheorem`] for regions, and for data of a wrong shape.
pub fn coq_theorem(certificate: &Certificate) -> Result<String, NotATheorem> {
    if let Domain::Region(_) = certificate.claim.domain {
        return Err(NotATheorem::Region);
    }
    let words = match certificate.claim.dimension {
        3 => &claim::SPACE,
        2 => &claim::PLANE,
        d => return Err(NotATheorem::Dimension(d)),
    };
    let root = match &certificate.claim.field {
        Field::Rationals => None,
        Field::Algebraic(field) => Some(RootOf::new(field)?),
    };
    let theorem = Theorem { certificate, words };
    let mut text = HEAD.to_owned();
    if let Some(root) = &root {
        text += &root.definitions()?;
    }
    text += &match words.dimension {
        2 => plane::data(certificate)?,
        _ => data::data(certificate)?,
    };
    text += &match &root {
        None => theorem.over_the_rationals()?,
        Some(root) => theorem.over_a_field(root)?,
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
