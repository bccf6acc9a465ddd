//! `acutile quality`: how good the simplices of a mesh are.

use super::input::{self, FileArguments};
use super::named::Named;
use super::outcome::Outcome;
use super::output::{Output, write_text};
use super::progress::Progress;
use acutile_core::statistics::{self, Statistics};
use acutile_core::tiling::SimplexId;
use acutile_core::with_dimension;
use clap::{Args, ValueEnum};
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
    /// How to write it: text has everything, the others the histogram
    #[arg(long, value_enum, default_value = "text")]
    pub format: QualityFormat,
    /// Write here and not to standard output
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
}

/// How the figures are written.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum QualityFormat {
    Text,
    Csv,
    Svg,
}

fn divisor_of_180(text: &str) -> Result<u32, String> {
    match text.parse() {
        Ok(degrees) if degrees > 0 && 180u32.is_multiple_of(degrees) => Ok(degrees),
        _ => Err("expected a divisor of 180".to_owned()),
    }
}

/// Prints or writes the figures.
pub fn run(arguments: &QualityArguments, output: &mut Output) -> Outcome {
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
    drop(progress);
    let text = rendered(&statistics, arguments.format, &named);
    write_text(arguments.output.as_deref(), &text, output)
}

fn rendered(statistics: &Statistics, format: QualityFormat, named: &Named) -> String {
    let simplex = |simplex: SimplexId| match &named.origin {
        Some(origin) => format!("element {}", origin.tetrahedron(simplex).tag),
        None => format!("simplex {simplex}"),
    };
    match format {
        QualityFormat::Text => statistics::text(statistics, &simplex),
        QualityFormat::Csv => statistics::csv(statistics),
        QualityFormat::Svg => statistics::svg(statistics, &named.name),
    }
}
