//! The results of `acutile optimize`, in words and as data.

use super::claim::{claim_json, summary};
use super::optimize_arguments::{GoalName, OptimizeArguments};
use super::output::Output;
use super::record::Record;
use super::words::printable;
use acutile_core::quality::{decimal_range, display_width};
use acutile_core::statement::{Statement, counted};
use acutile_optimize::{LocalProof, NotLocal, Reason, value};
use serde_json::{Value, json};
use std::path::Path;

/// The answer about the best tiling that was found.
pub struct Report<'r> {
    pub arguments: &'r OptimizeArguments,
    pub found: &'r acutile_optimize::Outcome,
    pub reasons: Vec<Reason>,
    pub is_acute: bool,
    pub local: Option<Result<LocalProof, NotLocal>>,
}

impl Report<'_> {
    /// Tells it.
    pub fn tell(&self, output: &mut Output) {
        if output.is_json() {
            return output.answer(self.record());
        }
        self.words().iter().for_each(|line| output.say(line));
    }

    /// The value of some statements, as an interval in decimals.
    fn value(&self, statements: &[Statement]) -> String {
        let value = value(statements, self.arguments.goal.goal());
        value.map_or(String::new(), |value| {
            decimal_range(&value.enclosure(&display_width()))
        })
    }

    fn words(&self) -> Vec<String> {
        let (input, found) = (&self.arguments.input, self.found);
        let (before, after) = (
            self.value(&found.before),
            self.value(found.proved.statements()),
        );
        let quantity = match self.arguments.goal {
            GoalName::MaxDihedral | GoalName::Acute => "largest dihedral angle",
            GoalName::MinDihedral => "smallest dihedral angle",
            GoalName::RadiusEdge => "largest radius-edge ratio",
        };
        let mut lines = vec![if found.is_better {
            format!("{input}: {quantity} {before} before, {after} now")
        } else {
            format!("{input}: no progress; {quantity} {before}")
        }];
        let grid = if found.is_better || found.parameters == 0 {
            format!("; {}", self.grid())
        } else {
            String::new()
        };
        lines.push(format!(
            "  {}, {} kept{grid}",
            counted(found.parameters, "parameter", "parameters"),
            counted(found.symmetries, "isometry", "isometries"),
        ));
        if found.is_interrupted {
            lines.push("  interrupted; this is the best so far".to_owned());
        }
        lines.push(format!("  proved: {}", summary(found.proved.verified())));
        if let Some(path) = self
            .arguments
            .output
            .as_ref()
            .filter(|p| *p != Path::new("-"))
        {
            lines.push(format!(
                "  certificate: {}, SHA-256 {}",
                printable(path),
                found.proved.sha256()
            ));
        }
        lines.extend(self.local.as_ref().map(|local| match local {
            Ok(proof) => format!("  {proof}"),
            Err(reason) => format!("  not proved to be a local optimum: {reason}"),
        }));
        if !self.is_acute {
            let count = self.reasons.len();
            lines.extend(self.reasons.first().map(|reason| {
                format!("  this tiling can never be acute: {reason} ({count} such edges)")
            }));
        }
        lines
    }

    fn grid(&self) -> String {
        let of = |what: &str, denominator: Option<u64>| {
            denominator.map(|d| format!("{what} multiples of 1/{d}"))
        };
        let (gram, points) = self.found.denominators;
        let parts = [
            of("moved coordinates are", points),
            of("Gram matrix entries are", gram),
        ];
        let parts: Vec<String> = parts.into_iter().flatten().collect();
        if parts.is_empty() {
            "nothing can move".to_owned()
        } else {
            parts.join(", ")
        }
    }

    fn record(&self) -> Record {
        let found = self.found;
        let (gram, points) = found.denominators;
        let path = self.arguments.output.as_deref();
        let record = Record::of(Some(&self.arguments.input)).verdict("proved");
        let record = record.certificate(path, &found.proved.sha256());
        record.with(json!({
            "is_better": found.is_better,
            "before": self.value(&found.before),
            "after": self.value(found.proved.statements()),
            "acute": self.is_acute,
            "parameters": found.parameters,
            "isometries": found.symmetries,
            "denominator": points,
            "gram_denominator": gram,
            "interrupted": found.is_interrupted,
            "never_acute": self.reasons.iter().map(|reason| json!({
                "edge": reason.ends.map(|corner| corner.to_string()),
                "valence": reason.valence,
                "boundary": reason.is_boundary,
                "why": reason.to_string(),
            })).collect::<Vec<_>>(),
            "local_optimum": self.local.as_ref().map(local_data),
            "statements": claim_json(found.proved.verified())["statements"],
        }))
    }
}

/// Angles by their simplex and two of its facets, each with its multiplier.
fn local_data(local: &Result<LocalProof, NotLocal>) -> Value {
    match local {
        Err(reason) => json!({ "proved": false, "message": reason.to_string() }),
        Ok(proof) => json!({
            "proved": true,
            "parameters": proof.parameters,
            "translations": proof.translations,
            "rank": proof.rank,
            "tight": proof.tight.iter().zip(&proof.multipliers).map(|((simplex, (i, j)), multiplier)| {
                json!({
                    "simplex": simplex.number(),
                    "facets": [i, j],
                    "multiplier": multiplier.to_string(),
                })
            }).collect::<Vec<_>>(),
        }),
    }
}
