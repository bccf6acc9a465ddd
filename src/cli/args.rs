//! The arguments of every command, as clap reads them.

use super::bundle::BundleArguments;
use super::draw::DrawArguments;
use super::quality::QualityArguments;
use acutile_format1::certificate::Statement;
use acutile_format1::verifier::Limits;
use acutile_io::mesh::{Format, Lattice};
use clap::{Args, Parser, Subcommand};
use malachite::Rational;
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
    /// Turn a mesh or a tiling into a mesh file of another format, or a tiling file
    Convert(ConvertArguments),
    /// The paper's table, as rigorous enclosures, and rows it does not have
    Table(TableArguments),
    /// Every checkable statement of the paper, with a verdict
    ///
    /// The exit code is 0 when every statement was settled, misprints included, and 3 when one
    /// was not.
    Paper(PaperArguments),
    /// How good the simplices are: dihedral angles, radius-edge and aspect ratios
    Quality(QualityArguments),
    /// Write a page to look at: the tiling in three dimensions, its exact data, its certificate
    ///
    /// One HTML file that loads nothing. A tiling that is no certificate yet is proved first;
    /// nothing is written that the kernel does not confirm.
    Report(ReportArguments),
    /// Write a static site of the whole catalogue
    Gallery(GalleryArguments),
    /// Figures for print, as SVG or TikZ, with hidden lines found exactly
    Draw(DrawArguments),
    /// Valences, vertex types, TCP or why not, and what the tiling is isomorphic to
    Classify(ClassifyArguments),
    /// A LaTeX appendix about certificates: theorem, numbers, and how to check them
    Appendix(AppendixArguments),
    /// An archive to deposit: certificates, appendix, page, meshes, verifiers, checksums
    ///
    /// A tiling that is no certificate yet is proved first; nothing is written that the kernel does
    /// not confirm. The same input gives the same bytes.
    Bundle(BundleArguments),
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

/// How a mesh file becomes a tiling. Coordinates in text mean the nearest double, and every
/// double is taken as the exact number that it is.
#[derive(Clone, Debug, Default, Args)]
#[command(next_help_heading = "Mesh files")]
pub struct MeshArguments {
    /// The mesh is a cell of a periodic tiling with these lattice vectors, three for space or two
    /// for a slab: integers, fractions and decimals, exact as written
    #[arg(long, value_name = "A1,A2,A3;B1,B2,B3;C1,C2,C3", value_parser = Lattice::parse,
        allow_hyphen_values = true)]
    pub lattice: Option<Lattice>,
    /// The mesh is bounded, even if the file has periodic links
    #[arg(long, conflicts_with = "lattice")]
    pub bounded: bool,
    /// Move nodes that are within this distance of a lattice translate of another node exactly
    /// onto it (of another node, if the mesh is bounded); what is proved is proved about the
    /// moved mesh
    #[arg(long, value_name = "TOLERANCE", value_parser = tolerance)]
    pub identify: Option<f64>,
    /// Write every move of --identify to this file, as CSV
    #[arg(long, value_name = "FILE", requires = "identify")]
    pub moves: Option<PathBuf>,
    /// The format of a mesh file that has no extension of its own: msh4, vtk, vtu, medit,
    /// meshb, tetgen
    #[arg(long = "from", value_name = "FORMAT", value_parser = Format::parse)]
    pub mesh_format: Option<Format>,
}

#[derive(Debug, Args)]
pub struct ConvertArguments {
    /// A name of the catalogue, a tiling file or a mesh file (`-` for standard input), or a
    /// certificate
    #[arg(value_name = "NAME|FILE")]
    pub input: String,
    /// The file to write, its format told by the extension: msh, vtk, vtu, mesh, meshb, node or
    /// ele, json for a tiling file; with .gz behind it compressed (`-` for standard output). For a
    /// certificate json or cbor, its two encodings
    #[arg(value_name = "FILE")]
    pub output: PathBuf,
    /// The number that the construction depends on
    #[arg(long, value_name = "VALUE", allow_hyphen_values = true)]
    pub param: Option<String>,
    /// The format to write: msh2, msh2-binary, msh4, msh4-binary, vtk, vtk-binary, vtu-text,
    /// vtu-base64, vtu-raw, vtu (compressed), medit, meshb, tetgen
    #[arg(long, value_name = "FORMAT", value_parser = Format::parse)]
    pub to: Option<Format>,
    /// Repeat the cell so many times in each direction of the lattice
    #[arg(long, value_name = "N,N,N", value_delimiter = ',', value_parser = clap::value_parser!(u16).range(1..))]
    pub supercell: Vec<u16>,
    /// All whole tetrahedra of the tiling in the ball of this radius around the origin, as a
    /// bounded mesh
    #[arg(long, value_name = "RADIUS", value_parser = radius)]
    pub patch: Option<Rational>,
    /// Round coordinates that are no doubles, and tell how many and how far
    #[arg(long)]
    pub round: bool,
    #[command(flatten)]
    pub file: FileArguments,
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

/// How a file becomes a tiling.
#[derive(Debug, Default, Args)]
pub struct FileArguments {
    #[command(flatten)]
    pub points: PointArguments,
    #[command(flatten)]
    pub mesh: MeshArguments,
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
    /// A name of the catalogue, a tiling or mesh file, or a point set (CIF too)
    #[arg(value_name = "NAME|FILE")]
    pub input: String,
    #[command(flatten)]
    pub file: FileArguments,
    /// The number that the construction depends on, like 3/7 or sqrt(2)/4: a/e of
    /// goldberg-1, -2 and -3, epsilon of two-corners
    #[arg(long, value_name = "VALUE", allow_hyphen_values = true)]
    pub param: Option<String>,
}

#[derive(Debug, Args)]
pub struct CertifyArguments {
    /// Names of the catalogue, tiling files, mesh files, or point sets (CIF too), whose
    /// Delaunay triangulation is certified (`-` for standard input)
    #[arg(value_name = "NAME|FILE", required_unless_present = "all")]
    pub inputs: Vec<String>,
    #[command(flatten)]
    pub file: FileArguments,
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
    /// The encoding; without it CBOR for a file whose name ends in .cbor, and else JSON
    #[arg(long, value_enum, conflicts_with = "no_certificate")]
    pub format: Option<Encoding>,
    /// A statement that must hold: tiling, acute, nonobtuse, delaunay, weakly-delaunay, tcp,
    /// dihedral<DEGREES, dihedral>DEGREES, radius-edge<RATIO
    #[arg(long = "require", value_name = "STATEMENT", value_parser = statement)]
    pub required: Vec<Statement>,
    /// Give negatively oriented simplices positive orientation
    #[arg(long)]
    pub reorient: bool,
    /// Prove and tell, but make no certificate and do not ask the kernel: for large meshes that
    /// are to be checked and not to be published
    #[arg(long, conflicts_with = "output")]
    pub no_certificate: bool,
    /// How many defects of each kind to tell; all are counted. Without it 20, and with --json all
    #[arg(long, value_name = "N")]
    pub max_defects: Option<usize>,
    /// One JSON object a line: one for each input, and for a refuted one then one for each defect
    #[arg(long)]
    pub json: bool,
}

/// How a certificate is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Encoding {
    /// For people and for every verifier
    Json,
    /// For large ones: shorter, written and verified in pieces
    Cbor,
}

impl Encoding {
    /// That of a file with this name, if the name says it; `.CBOR` says what `.cbor` does.
    pub fn of_path(path: &std::path::Path) -> Option<Encoding> {
        let extension = path.extension()?;
        [Encoding::Json, Encoding::Cbor]
            .into_iter()
            .find(|encoding| extension.eq_ignore_ascii_case(encoding.extension()))
    }

    /// What names of files end in.
    pub fn extension(self) -> &'static str {
        match self {
            Encoding::Json => "json",
            Encoding::Cbor => "cbor",
        }
    }
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
pub struct ReportArguments {
    /// Certificates, names of the catalogue, tiling or mesh files, or point sets (CIF too)
    #[arg(value_name = "CERT|NAME|FILE", required = true)]
    pub inputs: Vec<String>,
    #[command(flatten)]
    pub file: FileArguments,
    /// Write the page here and not to standard output
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
}

#[derive(Debug, Args)]
pub struct GalleryArguments {
    /// Write the site into this directory
    #[arg(short, long, value_name = "DIR", required = true)]
    pub output: PathBuf,
    /// Write into a directory that has other files, too
    #[arg(long)]
    pub force: bool,
}

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

#[derive(Debug, Args)]
pub struct AppendixArguments {
    /// Certificates, names of the catalogue, tiling files, or point sets (CIF too)
    #[arg(value_name = "CERT|NAME|FILE", required_unless_present = "all")]
    pub inputs: Vec<String>,
    #[command(flatten)]
    pub file: FileArguments,
    /// The whole catalogue
    #[arg(long)]
    pub all: bool,
    /// Write the files into this directory
    #[arg(short, long, value_name = "DIR")]
    pub output: PathBuf,
    /// Replace files that are there, even if they are others' or were edited
    #[arg(long)]
    pub force: bool,
    /// Print decimals with the package siunitx
    #[arg(long)]
    pub siunitx: bool,
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

/// A distance in doubles.
fn tolerance(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(value) if value.is_finite() && value >= 0.0 => Ok(value),
        _ => Err(format!(
            "found {text}, expected a number that is not negative"
        )),
    }
}

fn radius(text: &str) -> Result<Rational, String> {
    match acutile_exact::number::parse_rational(text) {
        Ok(value) if value > 0 => Ok(value),
        Ok(_) => Err(format!("found {text}, expected a positive number")),
        Err(error) => Err(error.to_string()),
    }
}

fn bound_text(text: &str, largest: u8) -> Result<String, String> {
    let bound = acutile_exact::number::parse_rational(text).map_err(|error| error.to_string())?;
    if bound <= 0 || bound > largest {
        return Err(format!(
            "found {text}, expected more than 0 and at most {largest}"
        ));
    }
    Ok(bound.to_string())
}
