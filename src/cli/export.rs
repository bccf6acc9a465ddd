//! `acutile export`: a tiling, or a supercell of it, as a tiling file or as a program for a computer
//! algebra system. It also writes a certificate as a theorem for Coq.

use super::extension::{self, Format};
use super::input::{self, FileArguments};
use super::name::InputName;
use super::named::{InputError, Named};
use super::outcome::Outcome;
use super::output::{Output, write_bytes};
use super::overwriting::check_output;
use super::record::Record;
use super::transcribe;
use acutile_catalog as catalog;
use acutile_core::format::recognise;
use acutile_core::statement::counted;
use acutile_core::tiling::{Tiling, supercell};
use acutile_core::with_dimension;
use acutile_io::export::{System, algebra_text, coq_file, labelled_tiling_text};
use acutile_io::import::{BYTE_LIMIT, read_bytes};
use clap::{Args, ValueEnum};
use std::path::PathBuf;

#[derive(Debug, Args)]
pub struct ExportArguments {
    /// A name of the catalogue, a tiling or mesh file, or a point set (CIF too); with --coq, a certificate
    #[arg(value_name = "NAME|FILE", hide_possible_values = true)]
    pub input: InputName,
    #[command(flatten)]
    pub file: FileArguments,
    /// Write to this file instead of standard output
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// The parameter of a construction, like 3/7 or sqrt(2)/4: a/e of goldberg-1, goldberg-2 and goldberg-3,
    /// epsilon of two-corners
    #[arg(long, value_name = "VALUE", allow_hyphen_values = true)]
    pub param: Option<String>,
    /// Write the certificate's bytes and its claim as a theorem for Coq (see proofs/README.md)
    #[arg(long, conflicts_with_all = ["supercell", "param"])]
    pub coq: bool,
    /// The output format. The default is that of the file name, or a tiling file. The files for sage,
    /// mathematica, gap and lean contain exact numbers, and assertions that the system decides as it loads them
    #[arg(long, value_enum, conflicts_with = "coq")]
    pub format: Option<ExportFormat>,
    /// Repeat the cell N times in each direction of the lattice
    #[arg(long, value_name = "N,N,N", value_delimiter = ',', value_parser = copies)]
    pub supercell: Vec<u16>,
}

/// The formats for a tiling.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum ExportFormat {
    /// A tiling file
    Json,
    /// Sage
    Sage,
    /// The Wolfram Language
    Mathematica,
    /// GAP
    Gap,
    /// Lean 4
    Lean,
}

const FORMATS: [Format<ExportFormat>; 5] = [
    (ExportFormat::Json, "a tiling file", &["json"]),
    (ExportFormat::Sage, "a file for Sage", &["sage"]),
    (
        ExportFormat::Mathematica,
        "a file for Mathematica",
        &["wl", "m", "wls"],
    ),
    (ExportFormat::Gap, "a file for GAP", &["g", "gap"]),
    (ExportFormat::Lean, "a file for Lean", &["lean"]),
];

impl ExportFormat {
    fn system(self) -> Option<System> {
        Some(match self {
            ExportFormat::Json => return None,
            ExportFormat::Sage => System::Sage,
            ExportFormat::Mathematica => System::Mathematica,
            ExportFormat::Gap => System::Gap,
            ExportFormat::Lean => System::Lean,
        })
    }
}

/// Writes the file.
pub fn run(arguments: &ExportArguments, output: &mut Output) -> Outcome {
    output.document_goes_to(arguments.output.as_deref());
    match write(arguments, output) {
        Ok(()) => output.done(Record::of(Some(&arguments.input))),
        Err(error) => output.fail(Some(&arguments.input), &error),
    }
}

fn write(arguments: &ExportArguments, output: &mut Output) -> Result<(), InputError> {
    let path = arguments.output.as_deref();
    check_output(path, "-o", std::slice::from_ref(&arguments.input))?;
    let text = written(arguments, output)?;
    write_bytes(path, text.as_bytes(), output)
}

fn written(arguments: &ExportArguments, output: &mut Output) -> Result<String, InputError> {
    let path = arguments.output.as_deref();
    if arguments.coq {
        extension::check(path, "a theorem for Coq", &["v"])?;
        return theorem(&arguments.input);
    }
    let format = extension::format(path, arguments.format, &FORMATS)
        .map_err(|message| format!("{message}; acutile convert writes meshes"))?;
    let parameter = arguments.param.as_deref();
    let named = input::tiling(&arguments.input, parameter, &arguments.file, output)?;
    with_dimension!(&named.tiling, AnyTiling, t => text(t, &named, format, &arguments.supercell))
}

fn expects_certificate(path: &InputName) -> String {
    format!(
        "{path}: found no certificate, which --coq takes; `acutile certify {path} -o FILE.cbor` writes one"
    )
}

fn theorem(path: &InputName) -> Result<String, InputError> {
    if !path.path().exists() && catalog::find(path).is_some() {
        return Err(expects_certificate(path).into());
    }
    let bytes = read_bytes(path.path(), BYTE_LIMIT)
        .map_err(|error| InputError::of_file(path.path(), &error))?;
    if recognise(&bytes).is_none() {
        return Err(expects_certificate(path).into());
    }
    let cbor = transcribe::cbor(path, &bytes)?;
    Ok(coq_file(&cbor).map_err(|reason| format!("{path}: {reason}"))?)
}

fn text<const D: usize>(
    tiling: &Tiling<D>,
    named: &Named,
    format: ExportFormat,
    sizes: &[u16],
) -> Result<String, InputError> {
    let labels = &named.labels;
    if sizes.is_empty() {
        return Ok(in_format(tiling, &named.name, labels, format));
    }
    let supercell = supercell(tiling, supercell_sizes(tiling, sizes)?);
    let copies = supercell.vertices.len() / tiling.vertices.len().max(1);
    // The vertices of each copy have the order of the cell.
    let labels: Vec<String> = (0..copies).flat_map(|_| labels.clone()).collect();
    Ok(in_format(&supercell, &named.name, &labels, format))
}

fn in_format<const D: usize>(
    tiling: &Tiling<D>,
    name: &str,
    labels: &[String],
    format: ExportFormat,
) -> String {
    match format.system() {
        Some(system) => algebra_text(tiling, name, system),
        None => labelled_tiling_text(tiling, name, labels),
    }
}

/// A number of copies.
pub fn copies(text: &str) -> Result<u16, String> {
    match text.parse() {
        Ok(copies) if copies > 0 => Ok(copies),
        _ => Err(format!(
            "found {text:?}, expected an integer from 1 to {}",
            u16::MAX
        )),
    }
}

/// No supercell is larger: about 2 GiB.
const SIMPLICES: usize = 20_000_000;

/// As many numbers as the lattice has directions, then ones.
///
/// # Errors
/// For another number of them, and where there would be too many copies.
pub fn supercell_sizes<const D: usize>(
    tiling: &Tiling<D>,
    sizes: &[u16],
) -> Result<[u16; D], String> {
    let rank = tiling.frame.rank();
    if sizes.len() != rank {
        let found = counted(sizes.len(), "number", "numbers");
        return Err(if rank == 0 {
            format!("--supercell: found {found} for a tiling without a lattice, expected none")
        } else {
            format!(
                "--supercell: found {found}, expected {rank}: one for each vector of the lattice"
            )
        });
    }
    let copies = sizes.iter().map(|&n| n as usize).product::<usize>();
    let simplices = copies.saturating_mul(tiling.len().max(tiling.vertices.len()));
    if simplices > SIMPLICES {
        return Err(format!(
            "--supercell: {copies} copies have {simplices} simplices or vertices, more than the limit of {SIMPLICES}"
        ));
    }
    Ok(std::array::from_fn(|k| sizes.get(k).copied().unwrap_or(1)))
}
