//! `acutile classify`: what a tiling is combinatorially.

use super::input::{self, FileArguments};
use super::outcome::Outcome;
use super::output::Output;
use acutile_core::tiling::Domain;
use acutile_paper::survey::{AnyStudy, NotStudied, Study, Survey, isomorphic_entries};
use clap::Args;
use malachite::Rational;
use serde_json::{Value, json};

#[derive(Debug, Args)]
pub struct ClassifyArguments {
    /// A name of the catalogue, a tiling or mesh file, or a point set (CIF too) (`-` for standard input)
    #[arg(value_name = "NAME|FILE")]
    pub input: String,
    #[command(flatten)]
    pub file: FileArguments,
    /// One JSON object
    #[arg(long)]
    pub json: bool,
}

/// Prints what the tiling is; refuted where it is no tiling.
pub fn run(arguments: &ClassifyArguments, output: &mut Output) -> Outcome {
    let named = match input::tiling(&arguments.input, None, &arguments.file, output) {
        Ok(named) => named,
        Err(error) => {
            output.complain(format!("acutile: {}", error.message));
            return error.outcome;
        }
    };
    let report = match AnyStudy::of(named.tiling) {
        Ok(AnyStudy::Plane(study)) => of_plane(&study),
        Ok(AnyStudy::Space(study)) => of_space(&study),
        Err(error) => {
            output.complain(format!("acutile: {}: {error}", arguments.input));
            return of_study(&error);
        }
    };
    match arguments.json {
        true => output.line(with_name(&arguments.input, report)),
        false => in_words(&arguments.input, &report, output),
    }
    Outcome::Done
}

/// How a command ends that has no study to show.
pub fn of_study(error: &NotStudied) -> Outcome {
    match error.is_refuted {
        true => Outcome::Refuted,
        false => Outcome::Declined,
    }
}

fn with_name(name: &str, mut report: Value) -> Value {
    report["input"] = json!(name);
    report
}

/// What holds in both dimensions; ridges are edges in space and vertices in the plane.
fn common<const D: usize>(study: &Study<D>) -> Value {
    let valences = study.ridges.valence_counts();
    json!({
        "dimension": D,
        "vertices": study.tiling.vertices.len(),
        "simplices": study.tiling.len(),
        "shapes": study.shapes.len(),
        "valences": valences.iter().map(|(v, n)| (v.to_string(), json!(n)))
            .collect::<serde_json::Map<_, _>>(),
        "average_valence": study.ridges.average_valence().map(|v| v.to_string()),
        "chambers": study.symbol().map(|symbol| symbol.len()),
        "certificate": study.certificate,
    })
}

fn of_plane(study: &Study<2>) -> Value {
    common(study)
}

fn of_space(study: &Study<3>) -> Value {
    let mut report = common(study);
    let stars = study.star_counts();
    report["edges"] = json!(study.ridges.list.len());
    report["vertex_types"] = stars
        .iter()
        .map(|(star, count)| (star.to_string(), json!(count)))
        .collect::<serde_json::Map<_, _>>()
        .into();
    let tcp = study.check_tcp();
    report["tcp"] = json!(tcp.is_ok());
    report["why_not_tcp"] = json!(tcp.err().map(|reason| reason.to_string()));
    report["isomorphic_to"] = match study.tiling.frame.domain == Domain::Space {
        true => json!(isomorphic_entries(study, &Survey::of_catalog())),
        false => Value::Null,
    };
    report
}

fn in_words(name: &str, report: &Value, output: &mut Output) {
    output.line(format!(
        "{name}: {} vertices, {} simplices of {} shapes in a cell",
        report["vertices"], report["simplices"], report["shapes"]
    ));
    let ridges = if report["dimension"] == 2 {
        "vertices"
    } else {
        "edges"
    };
    let valences = pairs(&report["valences"], |valence, count| {
        format!("{count} {ridges} of valence {valence}")
    });
    output.line(format!("valences: {valences}"));
    if let Some(average) = report["average_valence"].as_str() {
        output.line(format!("average valence: {}", mixed(average)));
    }
    if report["dimension"] != 3 {
        return;
    }
    let types = pairs(&report["vertex_types"], |star, count| {
        format!("{count} {star}")
    });
    output.line(format!("vertex types: {types}"));
    output.line(match report["why_not_tcp"].as_str() {
        None => "TCP: yes".to_owned(),
        Some(reason) => format!("TCP: no, {reason}"),
    });
    output.line(match report["isomorphic_to"].as_array() {
        None => "isomorphic to: not decided for a domain with boundary".to_owned(),
        Some(names) if names.is_empty() => "isomorphic to: nothing in the catalogue".to_owned(),
        Some(names) => {
            let names: Vec<&str> = names.iter().filter_map(Value::as_str).collect();
            format!("isomorphic to: {}", names.join(", "))
        }
    });
}

/// The members of an object, each written by `write`, joined with commas.
fn pairs(object: &Value, write: impl Fn(&str, &Value) -> String) -> String {
    let members = object.as_object().into_iter().flatten();
    let words: Vec<String> = members.map(|(key, value)| write(key, value)).collect();
    words.join(", ")
}

/// `51/10 = 5 1/10`
fn mixed(fraction: &str) -> String {
    match fraction.parse::<Rational>() {
        Ok(value) if *value.denominator_ref() != 1u32 => acutile_paper::paper::mixed_number(&value)
            .map_or(fraction.to_owned(), |mixed| format!("{fraction} = {mixed}")),
        _ => fraction.to_owned(),
    }
}
