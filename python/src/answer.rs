//! Verdicts as JSON, in the shape that `acutile certify --json` has.

use super::error::failed;
use super::words_and_digest;
use acutile::Tiling as Input;
use acutile_core::checker::{self, Findings, Options, defect_data};
use acutile_core::proved::{NotProved, prove};
use acutile_core::statement::in_words;
use acutile_core::tiling::Tiling;
use acutile_core::with_dimension;
use acutile_kernel::Verified;
use acutile_paper::survey::{AnyStudy, Study, isomorphic_to};
use acutile_publish::draw;
use pyo3::PyResult;
use serde_json::{Value, json};

/// Options of the prover from the texts of requirements.
pub fn options(required: &[String], defect_limit: usize) -> PyResult<Options> {
    let required = required.iter().map(|text| {
        text.parse()
            .map_err(|error| failed(format!("{text}: {error}")))
    });
    Ok(Options {
        required: required.collect::<PyResult<_>>()?,
        defect_limit,
        ..Options::default()
    })
}

/// The verdict on a tiling, and its certificate if it is wanted and the tiling is proved.
pub fn certify(
    input: &Input,
    options: &Options,
    with_certificate: bool,
    step: &dyn Fn(&str),
) -> PyResult<(String, Option<Vec<u8>>)> {
    let answer = with_dimension!(input.any(), AnyTiling, t => if with_certificate { proved(t, options, step) } else { examined(t, options, step) });
    let (mut data, certificate) = match answer {
        Ok(answer) => answer,
        Err(NotProved::Refuted(findings)) => (findings_data(input, "refuted", &findings), None),
        Err(NotProved::Declined(findings)) => (findings_data(input, "declined", &findings), None),
        Err(error) => {
            let message = error.to_string();
            (
                json!({ "verdict": "declined", "message": message, "counts": {}, "defects": [] }),
                None,
            )
        }
    };
    data["notes"] = json!(input.notes());
    data["vertices"] = json!(with_dimension!(input.any(), AnyTiling, t => t.vertices.len()));
    data["simplices"] = json!(with_dimension!(input.any(), AnyTiling, t => t.len()));
    Ok((data.to_string(), certificate))
}

fn proved<const D: usize>(
    tiling: &Tiling<D>,
    options: &Options,
    step: &dyn Fn(&str),
) -> Result<(Value, Option<Vec<u8>>), NotProved> {
    let proved = prove(tiling, options, step)?;
    let (words, sha256) = words_and_digest(proved.verified());
    let statements = proved.statements().iter().map(|s| in_words(s, D));
    let data = json!({
        "verdict": "proved",
        "kernel": true,
        "words": words,
        "statements": statements.collect::<Vec<_>>(),
        "sha256": sha256,
    });
    Ok((data, Some(proved.certificate().to_vec())))
}

/// The prover's word alone, without a certificate.
fn examined<const D: usize>(
    tiling: &Tiling<D>,
    options: &Options,
    step: &dyn Fn(&str),
) -> Result<(Value, Option<Vec<u8>>), NotProved> {
    let proof = checker::examine(tiling, options, step)?;
    let statements: Vec<String> = proof.statements.iter().map(|s| in_words(s, D)).collect();
    let data = json!({
        "verdict": "proved",
        "kernel": false,
        "words": statements.join("; "),
        "statements": statements,
        "sha256": null,
    });
    Ok((data, None))
}

fn findings_data(input: &Input, verdict: &str, findings: &Findings) -> Value {
    let defects: Vec<Value> = with_dimension!(input.any(), AnyTiling, t => {
        let names = input.names(t);
        findings.kept().iter().map(|defect| defect_data(t, &names, defect)).collect()
    });
    json!({ "verdict": verdict, "counts": findings.counts(), "defects": defects })
}

/// The verified claim, compared with an expected one.
pub fn verified(verified: &Verified, claim: Option<&[u8]>) -> PyResult<String> {
    let printed = verified.claim.print();
    if claim.is_some_and(|claim| claim != printed.as_bytes()) {
        let words = words_and_digest(verified).0;
        return Err(failed(format!("it proves another claim: {words}")));
    }
    let (words, sha256) = words_and_digest(verified);
    let data = json!({
        "verdict": "verified",
        "words": words,
        "claim": printed,
        "vertices": verified.vertices,
        "simplices": verified.simplices,
        "sha256": sha256,
    });
    Ok(data.to_string())
}

/// The combinatorial type of the tiling.
pub fn classify(input: &Input) -> PyResult<String> {
    let study = AnyStudy::of(input.any().clone()).map_err(failed)?;
    let data = match &study {
        AnyStudy::Plane(study) => counts(study),
        AnyStudy::Space(study) => {
            let mut data = counts(study);
            let stars = study.star_counts();
            let stars = stars.iter().map(|(star, n)| (star.to_string(), json!(n)));
            data["vertex_types"] = Value::Object(stars.collect());
            data["tcp"] = json!(study.check_tcp().is_ok());
            if let Some(symbol) = study.symbol() {
                data["isomorphic_to"] = json!(isomorphic_to(study, &symbol));
            }
            data
        }
    };
    Ok(data.to_string())
}

fn counts<const D: usize>(study: &Study<D>) -> Value {
    let valences = study.ridges.valence_counts();
    let valences = valences.iter().map(|(v, n)| (v.to_string(), json!(n)));
    json!({
        "vertices": study.tiling.vertices.len(),
        "simplices": study.tiling.len(),
        "shapes": study.shapes().len(),
        "valences": Value::Object(valences.collect()),
        "certificate": study.certificate,
    })
}

/// The cell, or the plane tiling, in SVG.
pub fn picture(input: &Input, name: &str) -> PyResult<String> {
    let figure = match input.dimension() {
        2 => draw::Figure::Plane,
        _ => draw::Figure::Cell,
    };
    let drawing = draw::draw(name, input.any(), figure, &draw::Options::default());
    Ok(draw::svg::svg(&drawing.map_err(failed)?))
}
