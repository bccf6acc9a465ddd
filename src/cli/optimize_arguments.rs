//! The arguments of `optimize`, which the words about its results read too.

use super::encoding::Encoding;
use super::input::FileArguments;
use super::integer::integer_in;
use super::limits::LimitArguments;
use super::name::InputName;
use acutile_optimize::{Goal, Keep};
use clap::{Args, ValueEnum};
use std::path::PathBuf;

#[derive(Debug, Args)]
pub struct OptimizeArguments {
    /// A name of the catalogue, or a tiling, mesh, point set or certificate file
    #[arg(value_name = "NAME|FILE", hide_possible_values = true)]
    pub input: InputName,
    /// The parameter of a construction (see acutile show --help)
    #[arg(long, value_name = "VALUE", allow_hyphen_values = true)]
    pub param: Option<String>,
    #[command(flatten)]
    pub file: FileArguments,
    /// Give negatively oriented simplices positive orientation first
    #[arg(long)]
    pub reorient: bool,
    /// The quantity to improve
    #[arg(long, value_enum, default_value = "max-dihedral")]
    pub goal: GoalName,
    /// The symmetry to keep: full, rotations, none, or the numbers of elements that generate a subgroup, like
    /// 3,7. The word list prints the elements with their numbers
    #[arg(long, value_name = "SUBGROUP", default_value = "full", value_parser = symmetry)]
    pub symmetry: SymmetryName,
    /// Do not change the lattice
    #[arg(long)]
    pub fixed_lattice: bool,
    /// Do not move vertices in the boundary. Without it they move in its planes
    #[arg(long)]
    pub fixed_boundary: bool,
    /// Coordinates become multiples of 1/N. The default step is about a millionth of an edge
    #[arg(long, value_name = "N", value_parser = integer_in::<u64>(1..=1 << 60))]
    pub denominator: Option<u64>,
    /// Also search from N random places near the start
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub restarts: u32,
    /// The seed of the random places
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub seed: u64,
    /// At most N linear programs from each place. For large meshes, at most N passes over all bad simplices
    #[arg(long, value_name = "N", default_value_t = 300)]
    pub steps: usize,
    /// Prove by exact multipliers that the result is a strict local optimum. The prover alone decides this
    #[arg(long)]
    pub prove_local: bool,
    /// Write the certificate of the result to this file (`-` for standard output). The commands convert and
    /// export turn it into a mesh or a tiling file
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// The encoding. The default is CBOR for a name that ends in .cbor, and otherwise JSON
    #[arg(long, value_enum)]
    pub format: Option<Encoding>,
    #[command(flatten)]
    pub limits: LimitArguments,
}

/// Goals by name.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum GoalName {
    /// The largest dihedral angle, as small as possible
    MaxDihedral,
    /// The smallest dihedral angle, as large as possible
    MinDihedral,
    /// The largest radius-edge ratio, as small as possible
    RadiusEdge,
    /// Every dihedral angle less than 90 degrees; then the search ends
    Acute,
}

impl GoalName {
    /// The goal with this name.
    pub fn goal(self) -> Goal {
        match self {
            GoalName::MaxDihedral => Goal::MaxDihedral,
            GoalName::MinDihedral => Goal::MinDihedral,
            GoalName::RadiusEdge => Goal::RadiusEdge,
            GoalName::Acute => Goal::Acute,
        }
    }
}

/// The values of `--symmetry`.
#[derive(Clone, Debug)]
pub enum SymmetryName {
    List,
    Keep(Keep),
}

fn symmetry(text: &str) -> Result<SymmetryName, String> {
    let keep = match text {
        "list" => return Ok(SymmetryName::List),
        "full" => Keep::All,
        "none" => Keep::Lattice,
        "rotations" => Keep::Rotations,
        places => {
            let places: Result<Vec<usize>, _> = places.split(',').map(str::parse).collect();
            Keep::Generated(places.map_err(|_| {
                format!("found {text}, expected full, rotations, none, list, or places like 3,7")
            })?)
        }
    };
    Ok(SymmetryName::Keep(keep))
}
