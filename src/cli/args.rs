//! The arguments of every command, as clap reads them.

use super::draw::DrawArguments;
use super::quality::QualityArguments;
use crate::certificate::Statement;
use crate::verifier::Limits;
use clap::{Args, Parser, Subcommand};
use std::ffi::OsString;
use std::path::PathBuf;

/// Proves, in exact arithmetic, that tilings by tetrahedra are valid and acute.
#[derive(Debug, Parser)]
#[command(name = "acutile", version, about, max_term_width = 100)]
#[command(
    after_help = "Exit codes: 0 proved or verified, 1 refuted or rejected, \
    2 usage or unreadable input, 3 declined."
)]
pub struct Arguments {
    #[command(subcommand)]
    pub command: Command,
}

#[derive(Debug, Subcommand)]
pub enum Command {
    /// List the catalogue of constructions
    List(ListArguments),
    /// Tell what a tiling is: counts, lattice, field, shapes
    Show(ShowArguments),
    /// Write a commented starting example of a kind of file
    New(NewArguments),
    /// Prove a tiling and write its certificate
    Certify(CertifyArguments),
    /// Re-check certificates with the independent kernel
    Verify(VerifyArguments),
    /// Compute the periodic Delaunay triangulation of a point set
    Delaunay(DelaunayArguments),
    /// Write a tiling, or a supercell of it, as a tiling file, or a certificate for Coq
    Export(ExportArguments),
    /// The paper's table, as rigorous enclosures, and rows it does not have
    Table(TableArguments),
    /// Every checkable statement of the paper, with a verdict
    ///
    /// The exit code is 0 when every statement was settled, misprints included, and 3 when one
    /// was not.
    Paper(PaperArguments),
    /// How good the simplices are: dihedral angles, radius-edge and aspect ratios
    Quality(QualityArguments),
    /// Figures for print, as SVG or TikZ, with hidden lines found exactly
    Draw(DrawArguments),
    /// Valences, vertex types, TCP or why not, and what the tiling is isomorphic to
    Classify(ClassifyArguments),
    /// Print a completion script for a shell
    Completions(CompletionsArguments),
    /// Print the manual page
    Man,
}

#[derive(Debug, Args)]
pub struct ListArguments {
    /// One JSON object for each construction
    #[arg(long)]
    pub json: bool,
}

#[derive(Debug, Args)]
pub struct NewArguments {
    /// The kind of file
    #[arg(value_enum)]
    pub kind: super::new::Kind,
    /// Write the file here and not to standard output; a file that is there is not overwritten
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
}

/// How a point set is read and triangulated.
#[derive(Debug, Default, Args)]
pub struct PointArguments {
    /// Cut Delaunay cells with cospherical vertices into simplices, the same way
    /// in every lattice translate, instead of refusing
    #[arg(long)]
    pub triangulate: bool,
    /// The data block of a CIF that has several
    #[arg(long, value_name = "NAME", help_heading = "CIF")]
    pub block: Option<String>,
    /// Replace each decimal of a CIF by the multiple of 1/DENOMINATOR that agrees with all of its
    /// digits, if there is one; every replacement is printed
    #[arg(long, value_name = "DENOMINATOR", help_heading = "CIF",
          value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    pub snap: Option<u32>,
    /// The sites of a CIF that are taken
    #[arg(
        long,
        value_name = "LABEL,LABEL",
        help_heading = "CIF",
        value_delimiter = ','
    )]
    pub only: Vec<String>,
    /// Take sites of a CIF as atoms whatever their occupancy, and those at one place as one
    #[arg(long, help_heading = "CIF")]
    pub ignore_occupancy: bool,
}

#[derive(Debug, Args)]
pub struct ShowArguments {
    /// A name of the catalogue, a tiling file, or a point set (CIF too)
    #[arg(value_name = "NAME|FILE")]
    pub input: String,
    #[command(flatten)]
    pub points: PointArguments,
    /// The number that the construction depends on, like 3/7 or sqrt(2)/4: a/e of
    /// goldberg-1, -2 and -3, epsilon of two-corners
    #[arg(long, value_name = "VALUE", allow_hyphen_values = true)]
    pub param: Option<String>,
}

#[derive(Debug, Args)]
pub struct CertifyArguments {
    /// Names of the catalogue, tiling files, or point sets (CIF too), whose Delaunay
    /// triangulation is certified (`-` for standard input)
    #[arg(value_name = "NAME|FILE", required_unless_present = "all")]
    pub inputs: Vec<String>,
    #[command(flatten)]
    pub points: PointArguments,
    /// The whole catalogue
    #[arg(long)]
    pub all: bool,
    /// The number that the construction depends on, like 3/7 or sqrt(2)/4: a/e of
    /// goldberg-1, -2 and -3, epsilon of two-corners
    #[arg(
        long,
        value_name = "VALUE",
        conflicts_with = "all",
        allow_hyphen_values = true
    )]
    pub param: Option<String>,
    /// Write the certificate to this file (`-` for standard output), or the
    /// certificates into this directory
    #[arg(short, long, value_name = "FILE|DIR")]
    pub output: Option<PathBuf>,
    /// A statement that must hold: tiling, acute, nonobtuse, delaunay, weakly-delaunay, tcp,
    /// dihedral<DEGREES, dihedral>DEGREES, radius-edge<RATIO
    #[arg(long = "require", value_name = "STATEMENT", value_parser = statement)]
    pub required: Vec<Statement>,
    /// Give negatively oriented simplices positive orientation
    #[arg(long)]
    pub reorient: bool,
    /// How many defects of each kind to describe; all are counted
    #[arg(long, value_name = "N", default_value_t = 20)]
    pub max_defects: usize,
    /// One JSON object for each input
    #[arg(long)]
    pub json: bool,
}

#[derive(Debug, Args)]
pub struct VerifyArguments {
    /// Certificates (`-` for standard input)
    #[arg(value_name = "FILE", required = true)]
    pub files: Vec<OsString>,
    /// One JSON object for each file
    #[arg(long)]
    pub json: bool,
    /// Bytes of a file
    #[arg(long, value_name = "N", default_value_t = Limits::DEFAULT.bytes)]
    pub limit_bytes: u64,
    /// Simplices of a certificate
    #[arg(long, value_name = "N", default_value_t = Limits::DEFAULT.simplices)]
    pub limit_simplices: usize,
    /// Decimal digits of a number
    #[arg(long, value_name = "N", default_value_t = Limits::DEFAULT.digits)]
    pub limit_digits: usize,
    /// Degree of the field
    #[arg(long, value_name = "N", default_value_t = Limits::DEFAULT.degree)]
    pub limit_degree: usize,
    /// Halvings of the root's interval
    #[arg(long, value_name = "N", default_value_t = Limits::DEFAULT.bisections)]
    pub limit_bisections: usize,
    /// Word products for one product of numbers in every simplex
    #[arg(long, value_name = "N", default_value_t = Limits::DEFAULT.work)]
    pub limit_work: u64,
}

#[derive(Debug, Args)]
pub struct DelaunayArguments {
    /// A point-set file or a CIF (`-` for standard input)
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    #[command(flatten)]
    pub points: PointArguments,
    /// Write the tiling file here and not to standard output
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
}

#[derive(Debug, Args)]
pub struct ExportArguments {
    /// A name of the catalogue, a tiling file, or a point set (CIF too); with --coq, a certificate
    #[arg(value_name = "NAME|FILE")]
    pub input: String,
    #[command(flatten)]
    pub points: PointArguments,
    /// Write the file here and not to standard output
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// The number that the construction depends on, like 3/7 or sqrt(2)/4: a/e of
    /// goldberg-1, -2 and -3, epsilon of two-corners
    #[arg(long, value_name = "VALUE", allow_hyphen_values = true)]
    pub param: Option<String>,
    /// Write the certificate's claim as a theorem for Coq (see proofs/README.md)
    #[arg(long, conflicts_with_all = ["supercell", "param"])]
    pub coq: bool,
    /// Repeat the cell so many times in each direction of the lattice
    #[arg(long, value_name = "N,N,N", value_delimiter = ',', value_parser = clap::value_parser!(u16).range(1..))]
    pub supercell: Vec<u16>,
}

#[derive(Debug, Args)]
pub struct TableArguments {
    /// Names of the catalogue, or tiling files; without any the whole catalogue, the
    /// paper's rows first
    #[arg(value_name = "NAME|FILE")]
    pub inputs: Vec<String>,
    /// How to write it
    #[arg(long, value_enum, default_value = "text")]
    pub format: TableFormat,
}

/// How the table is written.
#[derive(Clone, Copy, Debug, clap::ValueEnum)]
pub enum TableFormat {
    Text,
    Markdown,
    Latex,
    Csv,
    Json,
}

#[derive(Debug, Args)]
pub struct PaperArguments {
    /// An array with one JSON object for each statement
    #[arg(long)]
    pub json: bool,
}

#[derive(Debug, Args)]
pub struct ClassifyArguments {
    /// A name of the catalogue, a tiling file, or a point set (CIF too) (`-` for standard input)
    #[arg(value_name = "NAME|FILE")]
    pub input: String,
    #[command(flatten)]
    pub points: PointArguments,
    /// One JSON object
    #[arg(long)]
    pub json: bool,
}

#[derive(Debug, Args)]
pub struct CompletionsArguments {
    /// The shell
    #[arg(value_enum)]
    pub shell: clap_complete::Shell,
}

/// Reads a statement as `--require` takes it.
fn statement(text: &str) -> Result<Statement, String> {
    let bounded = |prefix: &str, largest: u8, statement: fn(String) -> Statement| {
        text.strip_prefix(prefix)
            .map(|bound| bound_text(bound, largest).map(statement))
    };
    match text {
        "tiling" => Ok(Statement::FaceToFaceTiling),
        "acute" => Ok(Statement::Acute),
        "nonobtuse" => Ok(Statement::Nonobtuse),
        "delaunay" => Ok(Statement::Delaunay),
        "weakly-delaunay" => Ok(Statement::WeaklyDelaunay),
        "tcp" => Ok(Statement::Tcp),
        _ => bounded("dihedral<", 180, Statement::DihedralBelow)
            .or_else(|| bounded("dihedral>", 180, Statement::DihedralAbove))
            .or_else(|| bounded("radius-edge<", u8::MAX, Statement::RadiusEdgeBelow))
            .unwrap_or_else(|| {
                Err(
                    "expected acute, nonobtuse, delaunay, weakly-delaunay, tcp, tiling, \
                     dihedral<DEGREES, dihedral>DEGREES or radius-edge<RATIO"
                        .to_owned(),
                )
            }),
    }
}

fn bound_text(text: &str, largest: u8) -> Result<String, String> {
    let bound = crate::number::parse_rational(text).map_err(|error| error.to_string())?;
    if bound <= 0 || bound > largest {
        return Err(format!(
            "found {text}, expected more than 0 and at most {largest}"
        ));
    }
    Ok(bound.to_string())
}
