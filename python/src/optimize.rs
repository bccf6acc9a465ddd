//! Better angles, proved.

use super::error::failed;
use super::words_and_digest;
use acutile::Tiling as Input;
use acutile_core::quality::{decimal_range, display_width};
use acutile_core::statement::in_words;
use acutile_core::tiling::AnyTiling;
use acutile_optimize::{Failure, Goal, Keep, Options, Outcome, optimize, value};
use pyo3::PyResult;
use serde_json::json;

/// The goal with this name of the command line.
pub fn goal(name: &str) -> PyResult<Goal> {
    match name {
        "max-dihedral" => Ok(Goal::MaxDihedral),
        "min-dihedral" => Ok(Goal::MinDihedral),
        "radius-edge" => Ok(Goal::RadiusEdge),
        "acute" => Ok(Goal::Acute),
        _ => Err(failed(format!(
            "found the goal {name}, expected max-dihedral, min-dihedral, radius-edge or acute"
        ))),
    }
}

/// The symmetry with this name of the command line.
pub fn symmetry(name: &str) -> PyResult<Keep> {
    match name {
        "full" => Ok(Keep::All),
        "rotations" => Ok(Keep::Rotations),
        "none" => Ok(Keep::Lattice),
        _ => Err(failed(format!(
            "found the symmetry {name}, expected full, rotations or none"
        ))),
    }
}

/// The best tiling, the answer as JSON, and the certificate.
pub fn best(
    input: &Input,
    options: &Options,
    step: &dyn Fn(&str),
) -> PyResult<(Input, String, Vec<u8>)> {
    let AnyTiling::Space(tiling) = input.any() else {
        return Err(failed("found a tiling of the plane, expected one of space"));
    };
    let found = optimize(tiling, options, &mut |value| {
        step(&format!("{value:.6}"));
        true
    });
    let found = found.map_err(|failure| match failure {
        Failure::Start(error) => failed(format!(
            "the start is no tiling: {}",
            error.in_words(tiling)
        )),
        Failure::NoElement(error) => failed(format!("there is no isometry {}", error.place)),
    })?;
    let answer = answer(&found, options.goal, input.notes());
    let certificate = found.proved.certificate().to_vec();
    Ok((
        Input::of(AnyTiling::Space(found.tiling)),
        answer,
        certificate,
    ))
}

fn answer(found: &Outcome, goal: Goal, notes: &[String]) -> String {
    let (words, sha256) = words_and_digest(found.proved.verified());
    let range = |statements: &[_]| {
        value(statements, goal).map(|value| decimal_range(&value.enclosure(&display_width())))
    };
    let statements = found.proved.statements();
    json!({
        "verdict": "proved",
        "kernel": true,
        "words": words,
        "statements": statements.iter().map(|s| in_words(s, 3)).collect::<Vec<_>>(),
        "sha256": sha256,
        "notes": notes,
        "vertices": found.tiling.vertices.len(),
        "simplices": found.tiling.len(),
        "is_better": found.is_better,
        "before": range(&found.before),
        "after": range(statements),
    })
    .to_string()
}
