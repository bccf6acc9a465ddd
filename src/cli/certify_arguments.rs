//! The arguments of `certify`, which its steps read.

use super::encoding::Encoding;
use super::input::FileArguments;
use super::limits::LimitArguments;
use super::name::InputName;
use super::requirement::RequirementParser;
use acutile_core::statement::Requirement;
use clap::Args;
use std::path::PathBuf;

#[derive(Debug, Args)]
pub struct CertifyArguments {
    /// Names of the catalogue, tiling files, mesh files, or point sets (CIF too), whose
    /// Delaunay triangulation is certified (`-` for standard input)
    #[arg(
        value_name = "NAME|FILE",
        required_unless_present = "all",
        hide_possible_values = true
    )]
    pub inputs: Vec<InputName>,
    /// Write the certificate to this file (`-` for standard output), or the
    /// certificates into this directory
    #[arg(short, long, value_name = "FILE|DIR")]
    pub output: Option<PathBuf>,
    /// The encoding; without it CBOR for a file whose name ends in .cbor, and else JSON
    #[arg(long, value_enum, conflicts_with = "no_certificate")]
    pub format: Option<Encoding>,
    /// Statements that must hold: tiling, acute, nonobtuse, delaunay, weakly-delaunay, not-delaunay, tcp,
    /// dihedral-below=DEGREES, dihedral-above=DEGREES, radius-edge-below=RATIO; in quotes also
    /// 'dihedral<DEGREES', 'dihedral>DEGREES', 'radius-edge<RATIO'; plane:EQUATION in basis
    /// coordinates, like plane:x2+x3=1/2, for a plane that no simplex crosses; and, by the prover alone,
    /// connected, no-cavities, manifold-boundary
    #[arg(
        long = "require",
        value_name = "STATEMENT,STATEMENT",
        value_delimiter = ',',
        value_parser = RequirementParser,
        hide_possible_values = true
    )]
    pub required: Vec<Requirement>,
    #[command(flatten)]
    pub file: FileArguments,
    /// The whole catalogue
    #[arg(long)]
    pub all: bool,
    /// The number of a construction that has one, like 3/7 or sqrt(2)/4: a/e for goldberg-1,
    /// goldberg-2 and goldberg-3, epsilon for two-corners
    #[arg(
        long,
        value_name = "VALUE",
        conflicts_with = "all",
        allow_hyphen_values = true
    )]
    pub param: Option<String>,
    /// For square-triangle:NAME, square-triangle:FILE and kagome:WORD: check only that the input
    /// belongs to the family, and cite the theorem about all its members
    #[arg(long, conflicts_with_all = ["param", "no_certificate"])]
    pub cite: bool,
    /// Give negatively oriented simplices positive orientation
    #[arg(long)]
    pub reorient: bool,
    /// Prove, but make no certificate and do not ask the kernel: for large meshes that
    /// are to be checked and not to be published
    #[arg(long, conflicts_with_all = ["output", "report"])]
    pub no_certificate: bool,
    /// How many defects of each kind are printed; all are counted. Without it 20, and with --json all
    #[arg(long, value_name = "N")]
    pub max_defects: Option<usize>,
    /// Write exact numbers in full; without it long numbers are approximate. JSON has all in full
    #[arg(long)]
    pub exact: bool,
    /// Decline where the mesh has elements of types that are not checked
    #[arg(long)]
    pub strict: bool,
    /// Facets may lie against each other (cohesive zones, contact): prove that interiors are disjoint,
    /// and count the pairs
    #[arg(long)]
    pub allow_contact: bool,
    /// Compare the boundary of a bounded mesh with the triangles of a surface: STL, OBJ, or a mesh file
    /// of triangles
    #[arg(long, value_name = "SURFACE")]
    pub fills: Option<PathBuf>,
    /// Write the cells of the defects to this VTU file, for ParaView
    #[arg(long, value_name = "FILE.vtu")]
    pub defects: Option<PathBuf>,
    /// Write a page to look at to this file: what is proved, and the defects of what is refuted, in red
    #[arg(long, value_name = "FILE.html")]
    pub report: Option<PathBuf>,
    /// Replace files in the directory of -o that are there, even if they are no certificates
    #[arg(long, requires = "output")]
    pub force: bool,
    #[command(flatten)]
    pub family: FamilyArguments,
    #[command(flatten)]
    pub limits: LimitArguments,
}

/// Options for boxes of parameters.
#[derive(Debug, Args)]
pub struct FamilyArguments {
    /// For a family, or with --free: prove the largest interval around this point. With several parameters
    /// prove a box: no side of it can move out by --fraction of its length and be proved. POINT has a value
    /// for each parameter, with commas between them, like 3,3/50,4/5. The statements are those of
    /// --require; without it acute, or else nonobtuse, if that holds at POINT
    #[arg(long, value_name = "POINT", allow_hyphen_values = true)]
    pub maximal: Option<String>,
    /// The fraction for --maximal with several parameters
    #[arg(
        long,
        value_name = "FRACTION",
        default_value = "1/16",
        requires = "maximal"
    )]
    pub fraction: String,
    /// Let the coordinates of these vertices vary, or the entries of the Gram matrix (gram), each by
    /// at most --radius. A vertex is a number from 0, in the order of the file and of `export`
    #[arg(long, value_name = "VERTEX|gram", num_args = 1.., requires = "radius")]
    pub free: Vec<String>,
    /// Prove the statements of a CIF for all values of its numbers within their standard uncertainties,
    /// like 0.0629(3), at once. Numbers without one are exact, and symmetry is kept
    #[arg(long, conflicts_with_all = ["free", "maximal"])]
    pub within_su: bool,
    /// How far each number of --free may vary, up and down. A coordinate is in units of its basis vector,
    /// an entry of the Gram matrix in its own unit
    #[arg(long, value_name = "RADIUS", requires = "free")]
    pub radius: Option<String>,
}
