//! `acutile classify`: the combinatorial type of a tiling.

use super::input::{self, FileArguments, Loaded};
use super::name::InputName;
use super::named::InputError;
use super::outcome::Outcome;
use super::output::Output;
use super::points;
use super::record::Record;
use super::sites::{self, Sites};
use acutile_core::classify::Symbol;
use acutile_core::statement::counted;
use acutile_core::tiling::{AnyPointSet, AnyTiling, Domain, PointSet};
use acutile_paper::survey::{AnyStudy, NotStudied, Study, isomorphic_to};
use clap::Args;
use malachite::Rational;
use serde_json::{Value, json};

#[derive(Debug, Args)]
pub struct ClassifyArguments {
    /// A name of the catalogue, a tiling or mesh file, a point set or a crystal structure (`-` for standard input)
    #[arg(value_name = "NAME|FILE", hide_possible_values = true)]
    pub input: InputName,
    #[command(flatten)]
    pub file: FileArguments,
}

/// Prints what the tiling is; refuted where it is no tiling.
pub fn run(arguments: &ClassifyArguments, output: &mut Output) -> Outcome {
    let report = match input::open(&arguments.input, None, &arguments.file, output) {
        Ok(loaded) => report(loaded, arguments),
        Err(error) => Err(error),
    };
    match report {
        Ok(report) if output.is_json() => output.answer(record(&arguments.input, report)),
        Ok(report) => in_words(&arguments.input, &report, output),
        Err(error) => return output.fail(Some(&arguments.input), &error),
    }
    Outcome::Done
}

/// A classified tiling is proved; points whose cells are not cut are none.
fn record(name: &str, mut report: Value) -> Record {
    let certificate = report["certificate"].take();
    if let Value::Object(members) = &mut report {
        members.remove("certificate");
    }
    let record = Record::of(Some(name)).with(report);
    match certificate.as_str() {
        Some(sha256) => record.verdict("proved").certificate(None, sha256),
        None => record,
    }
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
                of_points(arguments, &sites)
            }
            AnyPointSet::Plane(set) => {
                let tiling = points::tiling(name, set, &arguments.file.points)?;
                of_tiling(name, AnyTiling::Plane(tiling))
            }
        },
        Loaded::Family(named) => Err(named.is_no_tiling()),
        Loaded::Tiling(named) => {
            let set = (!named.labels.is_empty())
                .then(|| vertices(&named.tiling))
                .flatten();
            let mut report = of_tiling(name, named.tiling)?;
            if let Some(set) = set {
                let sites = Sites {
                    set: &set,
                    labels: &named.labels,
                    elements: &[],
                };
                let (cells, _) = sites.cells(name)?;
                add(&mut report, sites.report(&cells));
                let cut = sites::polytopes(&cells);
                if cut > 0 {
                    not_compared(&mut report, cut);
                }
            }
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

fn of_tiling(name: &str, tiling: AnyTiling) -> Result<Value, InputError> {
    match AnyStudy::of(tiling) {
        Ok(AnyStudy::Plane(study)) => Ok(of_plane(&study)),
        Ok(AnyStudy::Space(study)) => Ok(of_space(&study)),
        Err(error) => Err(InputError {
            message: format!("{name}: {error}"),
            outcome: of_study(&error),
        }),
    }
}

/// Points are described by their Delaunay cells as they are. Only if all are tetrahedra there is a
/// triangulation to classify: a cut would be arbitrary.
fn of_points(arguments: &ClassifyArguments, sites: &Sites) -> Result<Value, InputError> {
    let (name, options) = (&arguments.input, &arguments.file.points);
    let (cells, tiling) = sites.cells(name)?;
    if let Some(tiling) = tiling {
        // Much of the proof is the work of one core.
        let study = || of_tiling(name, AnyTiling::Space(tiling));
        let (report, of_sites) = rayon::join(study, || sites.report(&cells));
        let mut report = report?;
        add(&mut report, of_sites);
        return Ok(report);
    }
    let simplices = if options.triangulate {
        Some(points::tiling(name, sites.set, options)?.len())
    } else {
        None
    };
    let mut report = json!({
        "dimension": 3,
        "vertices": sites.set.points.len(),
        "simplices": simplices,
    });
    not_compared(&mut report, sites::polytopes(&cells));
    add(&mut report, sites.report(&cells));
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
    report["why_not_tcp"] = json!(format!(
        "{} not {}",
        counted(cut, "Delaunay cell is", "Delaunay cells are"),
        if cut == 1 {
            "a tetrahedron"
        } else {
            "tetrahedra"
        }
    ));
    report["isomorphic_to"] = Value::Null;
}

/// How a command ends that has no study to show.
pub fn of_study(error: &NotStudied) -> Outcome {
    if error.is_refuted {
        Outcome::Refuted
    } else {
        Outcome::Declined
    }
}

/// The part for both dimensions; ridges are edges in space and vertices in the plane.
fn common<const D: usize>(study: &Study<D>) -> Value {
    let valences = study.ridges.valence_counts();
    json!({
        "dimension": D,
        "vertices": study.tiling.vertices.len(),
        "simplices": study.tiling.len(),
        "valences": valences.iter().map(|(v, n)| (v.to_string(), json!(n)))
            .collect::<serde_json::Map<_, _>>(),
        "average_valence": study.ridges.average_valence().map(|v| v.to_string()),
        "certificate": study.certificate,
    })
}

fn of_plane(study: &Study<2>) -> Value {
    let mut report = common(study);
    report["chambers"] = json!(study.symbol().map(|symbol| symbol.len()));
    report
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
    // A domain with boundary has no symbol.
    let symbol = study.symbol();
    report["chambers"] = json!(symbol.as_ref().map(Symbol::len));
    report["symbol"] = json!(symbol.as_ref().map(Symbol::sha256));
    report["isomorphic_to"] = json!(symbol.map(|symbol| isomorphic_to(study, &symbol)));
    report
}

fn in_words(name: &str, report: &Value, output: &mut Output) {
    if !report["cells"].is_null() {
        sites::in_words(name, report, output);
    }
    if report["valences"].is_null() {
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
        "{name}: {}, {} in a cell",
        count(&report["vertices"], "vertex", "vertices"),
        count(&report["simplices"], "simplex", "simplices")
    ));
    let (ridge, ridges) = if report["dimension"] == 2 {
        ("vertex", "vertices")
    } else {
        ("edge", "edges")
    };
    let valences = pairs(&report["valences"], |valence, number| {
        format!("{} of valence {valence}", count(number, ridge, ridges))
    });
    output.line(format!("valences: {valences}"));
    if let Some(average) = report["average_valence"].as_str() {
        output.line(format!("average valence: {}", mixed(average)));
    }
    if report["dimension"] != 3 {
        return;
    }
    let types = pairs(&report["vertex_types"], |star, count| {
        match (star.strip_prefix("boundary, "), star.starts_with('Z')) {
            (Some(neighbours), _) => format!("{count} on the boundary with {neighbours}"),
            (None, true) => format!("{count} {star}"),
            (None, false) => format!("{count} with {star}"),
        }
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

/// A number of the report with its noun.
fn count(number: &Value, one: &str, several: &str) -> String {
    counted(number.as_u64().unwrap_or_default() as usize, one, several)
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
