//! Theorems about constructions: proved families, and proved systems of patches.

use acutile_catalog as catalog;
use acutile_core::checker::Options;
use acutile_core::family::{self, AnyFamily, FamilyNotProved, NotProvable, point_in_words};
use acutile_core::limits::own_limits;
use acutile_core::patches;
use acutile_core::refusal;
use acutile_core::statement::{Requirement, Statement};
use acutile_core::with_family;

/// A construction of the catalogue that is proved for all its members.
#[derive(Debug)]
pub struct General {
    /// The statements of the certificate about every member.
    pub statements: Vec<Statement>,
    /// The SHA-256 of the certificate's bytes, in hexadecimal digits.
    pub certificate: String,
    /// The tilings; `None` for a system of patches.
    pub family: Option<AnyFamily>,
}

impl General {
    /// Builds a construction and proves it; the kernel confirms the certificate.
    ///
    /// # Errors
    /// A message that names the construction.
    pub fn of_entry(name: &str) -> Result<General, String> {
        let named = |message: String| format!("{name}: {message}");
        if let Some(theorem) = catalog::theorem(name) {
            let system = (theorem.system)().map_err(|error| named(error.to_string()))?;
            let theorem = patches::prove(&system, &own_limits());
            let theorem = theorem.map_err(|error| named(error.to_string()))?;
            return Ok(General {
                statements: theorem.statements().to_vec(),
                certificate: theorem.sha256(),
                family: None,
            });
        }
        let entry = catalog::find(name).ok_or_else(|| named("not in this build".to_owned()))?;
        let family = entry
            .build_family()
            .ok_or_else(|| named("a single tiling".to_owned()))?;
        let family = family.map_err(|error| named(error.to_string()))?;
        let required = entry.requirements().map_err(named)?;
        General::of(family, required).map_err(named)
    }

    /// Proves a family, with these requirements among others.
    ///
    /// # Errors
    /// Why it is not proved, in words.
    pub fn of(family: AnyFamily, required: Vec<Requirement>) -> Result<General, String> {
        let options = Options {
            required,
            ..Options::default()
        };
        let proved = with_family!(&family, f => family::prove(f, &options, &|_| {}));
        let names = with_family!(&family, f => f.names());
        let proved = proved.map_err(|error| in_words(error, &names))?;
        Ok(General {
            statements: proved.statements().to_vec(),
            certificate: proved.sha256(),
            family: Some(family),
        })
    }

    /// Whether the certificate makes this statement.
    pub fn states(&self, statement: &Statement) -> bool {
        self.statements.contains(statement)
    }
}

fn in_words(error: FamilyNotProved, names: &[String]) -> String {
    match error {
        FamilyNotProved::Prover(NotProvable::Malformed(error)) => error.to_string(),
        FamilyNotProved::Prover(NotProvable::Declined(reason)) => reason,
        FamilyNotProved::Prover(NotProvable::Refuted { point, .. }) => {
            format!("refuted at {}", point_in_words(names, &point))
        }
        FamilyNotProved::Unconfirmed(refusal) => refusal::in_words(&refusal),
    }
}
