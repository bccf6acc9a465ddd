//! `acutile export`: a tiling, or a supercell of it, as a tiling file; a certificate
//! as a theorem for Coq.

use super::extension;
use super::input::{self, FileArguments};
use super::named::{InputError, Named};
use super::outcome::Outcome;
use super::output::{Output, write_text};
use super::transcribe;
use acutile_core::format;
use acutile_core::tiling::{Tiling, supercell};
use acutile_core::with_dimension;
use acutile_io::export::{coq_theorem, labelled_tiling_text};
use acutile_io::import::{BYTE_LIMIT, read_bytes};
use clap::Args;
use std::path::{Path, PathBuf};

#[derive(Debug, Args)]
pub struct ExportArguments {
    /// A name of the catalogue, a tiling or mesh file, or a point set (CIF too); with --coq, a certificate
    #[arg(value_name = "NAME|FILE")]
    pub input: String,
    #[command(flatten)]
    pub file: FileArguments,
    /// Write the file here and not to standard output
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// The number that the construction depends on, like 3/7 or sqrt(2)/4: a/e of
    /// goldberg-1, -2 and -3, epsilon of two-corners
    #[arg(long, value_name = "VALUE", allow_hyphen_values = true)]
    pub param: Option<String>,
    /// Write the certificate's bytes and its claim as a theorem for Coq (see proofs/README.md)
    #[arg(long, conflicts_with_all = ["supercell", "param"])]
    pub coq: bool,
    /// Repeat the cell N times in each direction of the lattice
    #[arg(long, value_name = "N,N,N", value_delimiter = ',', value_parser = clap::value_parser!(u16).range(1..))]
    pub supercell: Vec<u16>,
}

/// Writes the file.
pub fn run(arguments: &ExportArguments, output: &mut Output) -> Outcome {
    let path = arguments.output.as_deref();
    let named = match arguments.coq {
        true => extension::check(path, "a theorem for Coq", &["v"]),
        false => extension::check(path, "a tiling file", &["json"])
            .map_err(|message| format!("{message}; acutile convert writes meshes")),
    };
    let text = named
        .map_err(InputError::from)
        .and_then(|()| match arguments.coq {
            true => theorem(&arguments.input),
            false => tiling_file(arguments, output),
        });
    match text {
        Ok(text) => write_text(arguments.output.as_deref(), &text, output),
        Err(error) => {
            output.complain(format!("acutile: {}", error.message));
            error.outcome
        }
    }
}

fn theorem(path: &str) -> Result<String, InputError> {
    let bytes = read_bytes(Path::new(path), BYTE_LIMIT)
        .map_err(|error| InputError::of_file(Path::new(path), &error))?;
    let cbor = transcribe::cbor(path, &bytes)?;
    let certificate =
        format::read::certificate(&cbor).map_err(|error| format!("{path}: {error}"))?;
    Ok(coq_theorem(&cbor, &certificate.claim).map_err(|reason| format!("{path}: {reason}"))?)
}

fn tiling_file(arguments: &ExportArguments, output: &mut Output) -> Result<String, InputError> {
    input::tiling(
        &arguments.input,
        arguments.param.as_deref(),
        &arguments.file,
        output,
    )
    .and_then(|named| with_dimension!(&named.tiling, AnyTiling, t => text(t, &named, arguments)))
}

fn text<const D: usize>(
    tiling: &Tiling<D>,
    named: &Named,
    arguments: &ExportArguments,
) -> Result<String, InputError> {
    let (name, labels) = (&named.name, &named.labels);
    if arguments.supercell.is_empty() {
        return Ok(labelled_tiling_text(tiling, name, labels));
    }
    let sizes = supercell_sizes(tiling, &arguments.supercell)?;
    let supercell = supercell(tiling, sizes);
    let copies = supercell.vertices.len() / tiling.vertices.len().max(1);
    // The vertices of each copy have the order of the cell.
    let labels: Vec<String> = (0..copies).flat_map(|_| labels.clone()).collect();
    Ok(labelled_tiling_text(&supercell, name, &labels))
}

/// No supercell is larger: about 2 GiB.
const SIMPLICES: usize = 20_000_000;

/// As many numbers as the lattice has directions, with ones behind them.
///
/// # Errors
/// For another number of them, and where there would be too many copies.
pub fn supercell_sizes<const D: usize>(
    tiling: &Tiling<D>,
    sizes: &[u16],
) -> Result<[u16; D], String> {
    let rank = tiling.frame.rank();
    if sizes.len() != rank {
        let found = sizes.len();
        return Err(format!(
            "--supercell: found {found} numbers, expected {rank}"
        ));
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
