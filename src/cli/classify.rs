//! `acutile classify`: what a tiling is combinatorially.

use super::input::{self, FileArguments, Loaded};
use super::named::InputError;
use super::outcome::Outcome;
use super::output::Output;
use super::points;
use super::sites::{self, Sites};
use acutile_core::tiling::{AnyPointSet, AnyTiling, Domain, PointSet};
use acutile_paper::survey::{AnyStudy, NotStudied, Study, isomorphic_in_catalog};
use clap::Args;
use malachite::Rational;
use serde_json::{Value, json};

#[derive(Debug, Args)]
pub struct ClassifyArguments {
    /// A name of the catalogue, a tiling or mesh file, a point set or a crystal structure (`-` for standard input)
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
    let report = match input::open(&arguments.input, None, &arguments.file, output) {
        Ok(loaded) => report(loaded, arguments),
        Err(error) => Err(error),
    };
    match report {
        Ok(report) if arguments.json => output.line(with_name(&arguments.input, report)),
        Ok(report) => in_words(&arguments.input, &report, output),
        Err(error) => {
            output.complain(format!("acutile: {}", error.message));
            return error.outcome;
        }
    }
    Outcome::Done
}

fn report(loaded: Loaded, arguments: &ClassifyArguments) -> Result<Value, InputError> {
    let name = &arguments.input;
    match loaded {
        Loaded::Points(points) => match &points.set {
            AnyPointSet::Space(set) => {
                let sites = Sites {
                    set,
                    labels: &points.labels,
                    elements: &points.elements,
                };
                of_points(arguments, &sites, &points.notes)
            }
            AnyPointSet::Plane(set) => {
                let tiling = points::tiling(name, set, &arguments.file.points)?;
                of_tiling(arguments, AnyTiling::Plane(tiling))
            }
        },
        Loaded::Family(named) => Err(named.is_no_tiling()),
        Loaded::Tiling(named) => {
            let set = (!named.labels.is_empty())
                .then(|| vertices(&named.tiling))
                .flatten();
            let mut report = of_tiling(arguments, named.tiling)?;
            if let Some(set) = set {
                let sites = Sites {
                    set: &set,
                    labels: &named.labels,
                    elements: &[],
                };
                let (cells, cut) = sites.report(name)?;
                add(&mut report, cells);
                if cut > 0 {
                    not_compared(&mut report, cut);
                }
            }
            report["notes"] = json!(named.notes);
            Ok(report)
        }
    }
}

/// The vertices of a tiling of the whole space.
fn vertices(tiling: &AnyTiling) -> Option<PointSet<3>> {
    match tiling {
        AnyTiling::Space(tiling) if tiling.frame.domain == Domain::Space => Some(PointSet {
            frame: tiling.frame.clone(),
            points: tiling.vertices.iter().collect(),
        }),
        _ => None,
    }
}

fn of_tiling(arguments: &ClassifyArguments, tiling: AnyTiling) -> Result<Value, InputError> {
    let (name, is_json) = (&arguments.input, arguments.json);
    match AnyStudy::of(tiling) {
        Ok(AnyStudy::Plane(study)) => Ok(of_plane(&study, is_json)),
        Ok(AnyStudy::Space(study)) => Ok(of_space(&study, is_json)),
        Err(error) => Err(InputError {
            message: format!("{name}: {error}"),
            outcome: of_study(&error),
        }),
    }
}

/// Points are described by their Delaunay cells as they are. Only if all are tetrahedra there is a
/// triangulation to classify: a cut would be arbitrary.
fn of_points(
    arguments: &ClassifyArguments,
    sites: &Sites,
    notes: &[String],
) -> Result<Value, InputError> {
    let (name, options) = (&arguments.input, &arguments.file.points);
    let (cells, cut) = sites.report(name)?;
    let mut report = if cut == 0 {
        of_tiling(
            arguments,
            AnyTiling::Space(points::tiling(name, sites.set, options)?),
        )?
    } else {
        let simplices = match options.triangulate {
            true => Some(points::tiling(name, sites.set, options)?.len()),
            false => None,
        };
        let mut report = json!({
            "dimension": 3,
            "vertices": sites.set.points.len(),
            "simplices": simplices,
        });
        not_compared(&mut report, cut);
        report
    };
    add(&mut report, cells);
    report["notes"] = json!(notes);
    Ok(report)
}

fn add(report: &mut Value, more: serde_json::Map<String, Value>) {
    for (key, value) in more {
        report[key] = value;
    }
}

/// A triangulation that cuts Delaunay cells is one of many.
fn not_compared(report: &mut Value, cut: usize) {
    report["cells_that_are_no_simplices"] = json!(cut);
    report["tcp"] = json!(false);
    report["why_not_tcp"] = json!(format!("{cut} Delaunay cells are not tetrahedra"));
    report["isomorphic_to"] = Value::Null;
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
fn common<const D: usize>(study: &Study<D>, is_json: bool) -> Value {
    // They are not printed in words, and take as long as all else together.
    let chambers = is_json
        .then(|| study.symbol())
        .flatten()
        .map(|symbol| symbol.len());
    let valences = study.ridges.valence_counts();
    json!({
        "dimension": D,
        "vertices": study.tiling.vertices.len(),
        "simplices": study.tiling.len(),
        "shapes": study.shapes.len(),
        "valences": valences.iter().map(|(v, n)| (v.to_string(), json!(n)))
            .collect::<serde_json::Map<_, _>>(),
        "average_valence": study.ridges.average_valence().map(|v| v.to_string()),
        "chambers": chambers,
        "certificate": study.certificate,
    })
}

fn of_plane(study: &Study<2>, is_json: bool) -> Value {
    common(study, is_json)
}

fn of_space(study: &Study<3>, is_json: bool) -> Value {
    let mut report = common(study, is_json);
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
        true => json!(isomorphic_in_catalog(study)),
        false => Value::Null,
    };
    report
}

fn in_words(name: &str, report: &Value, output: &mut Output) {
    if !report["cells"].is_null() {
        sites::in_words(name, report, output);
    }
    if report["shapes"].is_null() {
        if let Some(simplices) = report["simplices"].as_u64() {
            output.line(format!(
                "cut: the {} cells that are not tetrahedra were cut; the cell of the lattice has {simplices} tetrahedra then",
                report["cells_that_are_no_simplices"]
            ));
        }
        output.line(format!("TCP: no, {}", words(&report["why_not_tcp"])));
        output.line("isomorphic to: not compared, since a triangulation would be an arbitrary cut");
        return;
    }
    if !report["cells_that_are_no_simplices"].is_null() {
        output.line(format!(
            "the tiling cuts {} Delaunay cells; what follows depends on the cut",
            report["cells_that_are_no_simplices"]
        ));
    }
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
        None if !report["cells_that_are_no_simplices"].is_null() => {
            "isomorphic to: not compared, since the tiling cuts Delaunay cells".to_owned()
        }
        None => "isomorphic to: not decided for a domain with boundary".to_owned(),
        Some(names) if names.is_empty() => "isomorphic to: nothing in the catalogue".to_owned(),
        Some(names) => {
            let names: Vec<&str> = names.iter().filter_map(Value::as_str).collect();
            format!("isomorphic to: {}", names.join(", "))
        }
    });
}

/// A string of the report without its quotes.
fn words(value: &Value) -> &str {
    value.as_str().unwrap_or_default()
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
