//! `acutile quality`: how good the simplices of a mesh are.

use super::extension::{self, Format};
use super::input::{self, FileArguments};
use super::name::InputName;
use super::named::{InputError, Named};
use super::outcome::Outcome;
use super::output::{Output, write_bytes};
use super::overwriting::check_output;
use super::progress::Progress;
use super::record::Record;
use acutile_core::checker::{self, Names};
use acutile_core::proved::NotProved;
use acutile_core::statement::Requirement;
use acutile_core::statistics::{self, Statistics};
use acutile_core::tiling::{SimplexId, Tiling};
use acutile_core::with_dimension;
use acutile_io::mesh::Origin;
use clap::{Args, ValueEnum};
use malachite::Rational;
use serde_json::json;
use std::collections::BTreeMap;
use std::path::PathBuf;

#[derive(Debug, Args)]
pub struct QualityArguments {
    /// A name of the catalogue, a tiling or mesh file, or a point set (CIF too)
    #[arg(value_name = "NAME|FILE", hide_possible_values = true)]
    pub input: InputName,
    /// The parameter of a construction (see acutile show --help)
    #[arg(long, value_name = "VALUE", allow_hyphen_values = true)]
    pub param: Option<String>,
    #[command(flatten)]
    pub file: FileArguments,
    /// The width of a bin of the histogram in degrees, a divisor of 180
    #[arg(long, value_name = "DEGREES", default_value_t = 5, value_parser = divisor_of_180)]
    pub bin: u32,
    /// The output format: text has everything, csv and svg have the histogram. The default is that of the
    /// file name, or text
    #[arg(long, value_enum)]
    pub format: Option<QualityFormat>,
    /// List the simplices with a dihedral angle of at most this many degrees
    #[arg(long, value_name = "DEGREES", value_parser = degrees)]
    pub below: Option<Rational>,
    /// List the simplices with a dihedral angle of at least this many degrees
    #[arg(long, value_name = "DEGREES", value_parser = degrees)]
    pub above: Option<Rational>,
    /// List the simplices with a radius-edge ratio of at least this number
    #[arg(long, value_name = "RATIO", value_parser = ratio)]
    pub ratio_above: Option<Rational>,
    /// The number of simplices that each of these options lists; all are counted
    #[arg(long, value_name = "N", default_value_t = 20)]
    pub max_offenders: usize,
    /// Write to this file instead of standard output
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
}

/// How the figures are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum QualityFormat {
    Text,
    Csv,
    Svg,
    /// That of --json
    #[value(skip)]
    Json,
}

const FORMATS: [Format<QualityFormat>; 4] = [
    (QualityFormat::Text, "text", extension::TEXT),
    (QualityFormat::Csv, "CSV", &["csv"]),
    (QualityFormat::Svg, "SVG", &["svg"]),
    (QualityFormat::Json, "JSON", &["json"]),
];

fn divisor_of_180(text: &str) -> Result<u32, String> {
    match text.parse() {
        Ok(degrees) if degrees > 0 && 180u32.is_multiple_of(degrees) => Ok(degrees),
        _ => Err("expected a divisor of 180".to_owned()),
    }
}

fn degrees(text: &str) -> Result<Rational, String> {
    match format!("dihedral<{text}").parse()? {
        Requirement::DihedralBelow(bound) => Ok(bound),
        _ => Err("expected degrees".to_owned()),
    }
}

fn ratio(text: &str) -> Result<Rational, String> {
    match format!("radius-edge<{text}").parse()? {
        Requirement::RadiusEdgeBelow(bound) => Ok(bound),
        _ => Err("expected a ratio".to_owned()),
    }
}

impl QualityArguments {
    /// The thresholds as requirements that offenders do not fulfil.
    fn thresholds(&self) -> Vec<Requirement> {
        let below = self.below.clone().map(Requirement::DihedralAbove);
        let above = self.above.clone().map(Requirement::DihedralBelow);
        let ratio = self.ratio_above.clone().map(Requirement::RadiusEdgeBelow);
        [below, above, ratio].into_iter().flatten().collect()
    }
}

/// Offenders in words, after a line with their number.
struct Offenders {
    counts: BTreeMap<&'static str, usize>,
    lines: Vec<String>,
}

fn offenders<const D: usize>(
    tiling: &Tiling<D>,
    statistics: &Statistics,
    arguments: &QualityArguments,
    origin: Option<&Origin>,
) -> Offenders {
    let (findings, kept) = checker::offenders(
        tiling,
        &statistics.left_out,
        &arguments.thresholds(),
        arguments.max_offenders,
    );
    let names = Names::new(
        |simplex| match origin {
            Some(origin) => format!("element {}", origin.tetrahedron(kept[simplex.index()]).tag),
            None => format!("simplex {}", kept[simplex.index()]),
        },
        |simplex, corner| match origin {
            Some(origin) => origin.corner(kept[simplex.index()], corner).to_string(),
            None => tiling.simplex(kept[simplex.index()])[corner].to_string(),
        },
        |vertex| format!("vertex {vertex}"),
    );
    let kept = findings.kept().iter();
    Offenders {
        lines: kept.map(|d| checker::describe::<D>(&names, d)).collect(),
        counts: findings.counts().clone(),
    }
}

/// Prints or writes the figures.
pub fn run(arguments: &QualityArguments, output: &mut Output) -> Outcome {
    match write(arguments, output) {
        Ok(()) => Outcome::Done,
        Err(error) => output.fail(Some(&arguments.input), &error),
    }
}

fn write(arguments: &QualityArguments, output: &mut Output) -> Result<(), InputError> {
    let path = arguments.output.as_deref();
    let asked = extension::asked(arguments.format, QualityFormat::Json, output)?;
    let format = extension::format(path, asked, &FORMATS)?;
    let input = &arguments.input;
    check_output(path, "-o", std::slice::from_ref(input))?;
    let named = input::tiling(input, arguments.param.as_deref(), &arguments.file, output)?;
    let progress = Progress::of(&named.name);
    progress.step("quality");
    let statistics = with_dimension!(&named.tiling, AnyTiling, t => {
        statistics::statistics(t, arguments.bin)
            .map_err(|findings| NotProved::Refuted(findings).in_words(t))
    });
    let statistics = statistics.map_err(|message| InputError {
        message: format!("{}: {message}", named.name),
        outcome: Outcome::Refuted,
    })?;
    let offenders = with_dimension!(&named.tiling, AnyTiling, t => {
        offenders(t, &statistics, arguments, named.origin.as_ref())
    });
    drop(progress);
    let text = rendered(&statistics, &offenders, format, &named, output);
    write_bytes(path, text.as_bytes(), output)
}

fn rendered(
    statistics: &Statistics,
    offenders: &Offenders,
    format: QualityFormat,
    named: &Named,
    output: &mut Output,
) -> String {
    let simplex = |simplex: SimplexId| match &named.origin {
        Some(origin) => format!("element {}", origin.tetrahedron(simplex).tag),
        None => format!("simplex {simplex}"),
    };
    match format {
        QualityFormat::Json => {
            let data = statistics::data(statistics, &simplex);
            let found = json!({ "counts": offenders.counts, "first": offenders.lines });
            let record = Record::of(Some(&named.name)).with(data);
            let record = output.record(record.member("offenders", found));
            format!("{}\n", record.text())
        }
        QualityFormat::Text => {
            let mut text = statistics::text(statistics, &simplex);
            for (code, count) in &offenders.counts {
                text.push_str(&format!("{code}: {count}\n"));
            }
            for line in &offenders.lines {
                text.push_str(&format!("  {line}\n"));
            }
            text
        }
        QualityFormat::Csv => statistics::csv(statistics),
        QualityFormat::Svg => statistics::svg(statistics, &named.name),
    }
}
