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
    /// Delaunay triangulation is proved (`-` for standard input)
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
    /// The encoding. The default is CBOR for a name that ends in .cbor, and otherwise JSON
    #[arg(long, value_enum, conflicts_with = "no_certificate")]
    pub format: Option<Encoding>,
    /// Statements that must hold: tiling, acute, nonobtuse, delaunay, weakly-delaunay, not-delaunay, tcp,
    /// dihedral-below=DEGREES, dihedral-above=DEGREES, radius-edge-below=RATIO. In quotes also
    /// 'dihedral<DEGREES', 'dihedral>DEGREES' and 'radius-edge<RATIO'. plane:EQUATION, like
    /// plane:x2+x3=1/2 in basis coordinates, is a plane that no simplex crosses. The kernel does not check
    /// connected, no-cavities and manifold-boundary; the prover does
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
    /// Prove the whole catalogue
    #[arg(long)]
    pub all: bool,
    /// The parameter of a construction, like 3/7 or sqrt(2)/4: a/e of goldberg-1, goldberg-2 and
    /// goldberg-3, epsilon of two-corners
    #[arg(
        long,
        value_name = "VALUE",
        conflicts_with = "all",
        allow_hyphen_values = true
    )]
    pub param: Option<String>,
    /// Cite the theorem about all members of square-triangle:WORD or kagome:WORD. Only the membership of
    /// the input is checked
    #[arg(long, conflicts_with_all = ["param", "no_certificate"])]
    pub cite: bool,
    /// Give negatively oriented simplices positive orientation
    #[arg(long)]
    pub reorient: bool,
    /// Prove without a certificate, so that the prover alone decides. This is faster for large meshes
    #[arg(long, conflicts_with_all = ["output", "report"])]
    pub no_certificate: bool,
    /// The number of defects of each kind that are printed; all are counted. The default is 20, with
    /// --json all
    #[arg(long, value_name = "N")]
    pub max_defects: Option<usize>,
    /// Print exact numbers in full. Without it long numbers are printed as decimals; JSON always has exact
    /// numbers
    #[arg(long)]
    pub exact: bool,
    /// Decline a mesh that has elements of types that are not checked
    #[arg(long)]
    pub strict: bool,
    /// Allow boundary facets to touch each other (cohesive zones, contact): prove that the interiors are
    /// disjoint, and count the pairs
    #[arg(long)]
    pub allow_contact: bool,
    /// Compare the boundary of a bounded mesh with the triangles of a surface: STL, OBJ, or a mesh file
    /// of triangles
    #[arg(long, value_name = "SURFACE")]
    pub fills: Option<PathBuf>,
    /// Write the cells of the defects to this VTU file, for ParaView
    #[arg(long, value_name = "FILE.vtu")]
    pub defects: Option<PathBuf>,
    /// Write an HTML page to this file. It shows the statements that are proved, and marks defects in red
    #[arg(long, value_name = "FILE.html")]
    pub report: Option<PathBuf>,
    /// Replace existing files in the directory of -o, even if they are no certificates
    #[arg(long, requires = "output")]
    pub force: bool,
    #[command(flatten)]
    pub family: FamilyArguments,
    #[command(flatten)]
    pub limits: LimitArguments,
}

/// What an input is, for the options that are not for every input.
#[derive(Clone, Copy, Debug, Default)]
pub struct Takes {
    /// Its author gave each simplex, so that it may be negatively oriented.
    pub has_given_simplices: bool,
    pub is_mesh_file: bool,
    /// It has a boundary of its own, and fills no space, slab, prism or solid.
    pub is_region: bool,
}

impl CertifyArguments {
    /// Checks that every option means something for an input.
    ///
    /// # Errors
    /// Names the input, the option, and the inputs that the option is for.
    pub fn check_for(&self, input: &str, takes: Takes) -> Result<(), String> {
        let without_meaning = [
            (
                self.reorient && !takes.has_given_simplices,
                "--reorient",
                "a tiling or mesh file",
            ),
            (
                self.strict && !takes.is_mesh_file,
                "--strict",
                "a mesh file",
            ),
            (
                self.allow_contact && !takes.is_region,
                "--allow-contact",
                "a mesh with a boundary",
            ),
            (
                self.fills.is_some() && !takes.is_region,
                "--fills",
                "a bounded mesh",
            ),
        ];
        match without_meaning.into_iter().find(|(is_given, ..)| *is_given) {
            None => Ok(()),
            Some((_, option, inputs)) => Err(format!(
                "{input}: {option} is for {inputs}, which this is not"
            )),
        }
    }
}

/// Options for boxes of parameters.
#[derive(Debug, Args)]
pub struct FamilyArguments {
    /// For a family, or with --free: prove the largest interval around this point. With several parameters
    /// prove a box: the proof fails if a side moves out by --fraction of its length. POINT has a value for
    /// each parameter, separated by commas, like 3,3/50,4/5. The statements are those of --require. Without
    /// it the statement is acute, or else nonobtuse, if it holds at POINT
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
    /// Prove the statements for all values of the numbers of a CIF within their standard uncertainties, like
    /// 0.0629(3). Numbers without an uncertainty are exact, and the symmetry does not change
    #[arg(long, conflicts_with_all = ["free", "maximal"])]
    pub within_su: bool,
    /// The largest change of each number of --free, up or down. A coordinate counts in its basis vector, an
    /// entry of the Gram matrix in the unit of the matrix
    #[arg(long, value_name = "RADIUS", requires = "free")]
    pub radius: Option<String>,
}
