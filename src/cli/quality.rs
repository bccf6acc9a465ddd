//! `acutile quality`: how good the simplices of a mesh are.

use super::extension::{self, Format};
use super::input::{self, FileArguments};
use super::named::Named;
use super::outcome::Outcome;
use super::output::{Output, write_text};
use super::progress::Progress;
use acutile_core::checker::{self, Names};
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
    /// A name of the catalogue, or a tiling or mesh file
    #[arg(value_name = "NAME|FILE")]
    pub input: String,
    /// The number that the construction depends on (see acutile show)
    #[arg(long, value_name = "VALUE", allow_hyphen_values = true)]
    pub param: Option<String>,
    #[command(flatten)]
    pub file: FileArguments,
    /// Degrees of a bin of the histogram, a divisor of 180
    #[arg(long, value_name = "DEGREES", default_value_t = 5, value_parser = divisor_of_180)]
    pub bin: u32,
    /// How to write it: text has everything, the others the histogram; text where neither this nor
    /// the name of the file says it
    #[arg(long, value_enum)]
    pub format: Option<QualityFormat>,
    /// List the simplices with a dihedral angle of at most this many degrees
    #[arg(long, value_name = "DEGREES", value_parser = degrees)]
    pub below: Option<Rational>,
    /// List the simplices with a dihedral angle of at least this many degrees
    #[arg(long, value_name = "DEGREES", value_parser = degrees)]
    pub above: Option<Rational>,
    /// List the simplices with a radius-edge ratio of at least this
    #[arg(long, value_name = "RATIO", value_parser = ratio)]
    pub ratio_above: Option<Rational>,
    /// How many offenders of each kind to list; all are counted
    #[arg(long, value_name = "N", default_value_t = 20)]
    pub max_offenders: usize,
    /// One JSON object with all figures
    #[arg(long, conflicts_with = "format")]
    pub json: bool,
    /// Write here and not to standard output
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
    (QualityFormat::Text, "text", &["txt", "log", "out"]),
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
    /// The format that is asked for, or that the name of the file says.
    fn written(&self) -> Result<QualityFormat, String> {
        let asked = match self.json {
            true => Some(QualityFormat::Json),
            false => self.format,
        };
        extension::format(self.output.as_deref(), asked, &FORMATS)
    }

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
    let format = match arguments.written() {
        Ok(format) => format,
        Err(message) => {
            output.complain(format!("acutile: {message}"));
            return Outcome::Failed;
        }
    };
    let input = &arguments.input;
    let named = input::tiling(input, arguments.param.as_deref(), &arguments.file, output);
    let named = match named {
        Ok(named) => named,
        Err(error) => {
            output.complain(format!("acutile: {}", error.message));
            return error.outcome;
        }
    };
    let progress = Progress::of(&named.name);
    progress.step("quality");
    let statistics =
        with_dimension!(&named.tiling, AnyTiling, t => statistics::statistics(t, arguments.bin));
    let offenders = with_dimension!(&named.tiling, AnyTiling, t => {
        offenders(t, &statistics, arguments, named.origin.as_ref())
    });
    drop(progress);
    let text = rendered(&statistics, &offenders, format, &named);
    write_text(arguments.output.as_deref(), &text, output)
}

fn rendered(
    statistics: &Statistics,
    offenders: &Offenders,
    format: QualityFormat,
    named: &Named,
) -> String {
    let simplex = |simplex: SimplexId| match &named.origin {
        Some(origin) => format!("element {}", origin.tetrahedron(simplex).tag),
        None => format!("simplex {simplex}"),
    };
    let data = || {
        let mut data = statistics::data(statistics, &simplex);
        data["input"] = json!(named.name);
        data["offenders"] = json!({ "counts": offenders.counts, "first": offenders.lines });
        format!("{data}\n")
    };
    match format {
        QualityFormat::Json => data(),
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
