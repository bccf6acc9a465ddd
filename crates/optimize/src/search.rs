//! A search from the start to the proof.

use crate::descent::descend;
use crate::goal::Goal;
use crate::group::{Group, Keep, NoElement};
use crate::local;
use crate::model::Model;
use crate::moves::{Freedom, Moves};
use crate::rounding::Grid;
use crate::tight::{self, LocalProof, NotLocal};
use crate::value::value;
use acutile_core::checker::{self, Sides};
use acutile_core::proved::{NotProved, Proved, prove};
use acutile_core::statement::Statement;
use acutile_core::tiling::{Matching, Tiling, match_facets};
use acutile_exact::number::Number;
use acutile_kernel::Limits;

/// The options of a search.
#[derive(Clone, Debug)]
pub struct Options {
    /// The value that becomes better.
    pub goal: Goal,
    /// The isometries that the result has.
    pub keep: Keep,
    /// The parts that may move.
    pub freedom: Freedom,
    /// Coordinates become multiples of 1/denominator; without it the search chooses.
    pub denominator: Option<u64>,
    /// The number of random places near the start from which a search starts, too.
    pub restarts: u32,
    /// The seed of these places.
    pub seed: u64,
    /// The greatest number of linear programs from each place.
    pub steps: usize,
    /// Limits of the kernel.
    pub limits: Limits,
    /// Knowledge about the sides of a periodic mesh; it is a tiling only if they match.
    pub sides: Sides,
}

/// A tiling that is proved.
#[derive(Debug)]
pub struct Outcome {
    /// The best tiling: the start itself where nothing better was found.
    pub tiling: Tiling<3>,
    /// The proof of the tiling.
    pub proved: Proved,
    /// The statements that the start has.
    pub before: Vec<Statement>,
    /// Whether the exact value is better than that of the start.
    pub is_better: bool,
    /// Entries of the Gram matrix that moved are multiples of 1 over the first, coordinates of the second;
    /// `None` where none can move.
    pub denominators: (Option<u64>, Option<u64>),
    /// The dimension of the space of motions.
    pub parameters: usize,
    /// The number of isometries that were kept, up to the lattice.
    pub symmetries: usize,
    /// Whether a signal ended the search.
    pub is_interrupted: bool,
}

/// Why there is no result.
#[derive(Debug)]
pub enum Failure {
    /// The start is no tiling.
    Start(NotProved),
    /// An isometry that is to be kept does not exist.
    NoElement(NoElement),
}

/// Called with the current value, in degrees or as a ratio; returns whether to go on.
pub type Watch<'a> = &'a mut dyn FnMut(f64) -> bool;

/// Tilings with more simplices are searched without their symmetries.
const SYMMETRIC: usize = 20_000;
/// Searches with more parameters move one star after the other: of a region, whose lattice stays anyway, and
/// of another domain.
const LARGE: (usize, usize) = (400, 1_200);
/// The number of steps of the grid in a typical edge.
const FINE: f64 = 1e6;
/// No denominator is much larger.
const LARGEST: u64 = 1 << 50;
/// The number of best ends that are proved, because rounding may change their order.
const PROVED: usize = 3;
/// The distance of random starts, in edges.
const JITTER: f64 = 0.02;

impl Default for Options {
    fn default() -> Self {
        Options {
            goal: Goal::MaxDihedral,
            keep: Keep::All,
            freedom: Freedom {
                lattice: true,
                boundary: true,
            },
            denominator: None,
            restarts: 0,
            seed: 0,
            steps: 300,
            limits: checker::Options::default().limits,
            sides: Sides::default(),
        }
    }
}

/// Searches for a better tiling near `tiling`, and proves what is found.
///
/// # Errors
/// The start is no tiling.
pub fn optimize(tiling: &Tiling<3>, options: &Options, watch: Watch) -> Result<Outcome, Failure> {
    let start = proved(tiling, options).map_err(Failure::Start)?;
    let matching = match_facets(tiling);
    let group = group(tiling, &matching, &options.keep).map_err(Failure::NoElement)?;
    let moves = Moves::of(tiling, &matching, &group, options.freedom);
    let model = Model::new(tiling, &moves, &group.representatives(tiling), options.goal);
    let grid = grid(tiling, &model, options.denominator);
    let is_region = tiling.frame.domain.is_region();
    let mut is_interrupted = false;
    let mut shown = |value: f64| {
        let goes_on = watch(options.goal.shown(value));
        is_interrupted |= !goes_on;
        goes_on
    };
    let mut outcome = Outcome {
        tiling: tiling.clone(),
        before: start.statements().to_vec(),
        proved: start,
        is_better: false,
        denominators: grid.stated(&model),
        parameters: moves.len(),
        symmetries: group.elements.len(),
        is_interrupted: false,
    };
    for numbers in candidates(&model, &moves, &grid, is_region, options, &mut shown) {
        let found = moves.tiling(tiling, &numbers);
        // A candidate that is no tiling is not better.
        if let Ok(proof) = proved(&found, options)
            && is_better(&proof, &outcome.proved, options.goal)
        {
            outcome.tiling = found;
            outcome.proved = proof;
            outcome.is_better = true;
        }
    }
    outcome.is_interrupted = is_interrupted;
    Ok(outcome)
}

/// Proves that a result is a strict local optimum among the tilings that a search with these options
/// reaches. The prover alone says it; no certificate states it.
///
/// # Errors
/// The missing part of a proof.
pub fn prove_local(outcome: &Outcome, options: &Options) -> Result<LocalProof, NotLocal> {
    let tiling = &outcome.tiling;
    let matching = match_facets(tiling);
    // The search had the same group.
    let group = group(tiling, &matching, &options.keep).map_err(|_| NotLocal::NoAngle)?;
    let moves = Moves::of(tiling, &matching, &group, options.freedom);
    let extreme = value(outcome.proved.statements(), options.goal).ok_or(NotLocal::NoAngle)?;
    tight::prove_local(tiling, &moves, &group, &extreme)
}

fn proved(tiling: &Tiling<3>, options: &Options) -> Result<Proved, NotProved> {
    let options = checker::Options {
        limits: options.limits.clone(),
        sides: options.sides.clone(),
        ..checker::Options::default()
    };
    prove(tiling, &options, &|_| {})
}

/// The isometries to keep. Those of a large tiling are not computed.
fn group(tiling: &Tiling<3>, matching: &Matching<3>, keep: &Keep) -> Result<Group, NoElement> {
    if *keep == Keep::Lattice || (*keep == Keep::All && tiling.len() > SYMMETRIC) {
        return Ok(Group::trivial(tiling));
    }
    Group::of(tiling, matching).kept(keep)
}

/// The points that the searches end at, to be proved.
fn candidates(
    model: &Model,
    moves: &Moves,
    grid: &Grid,
    is_region: bool,
    options: &Options,
    watch: Watch,
) -> Vec<Vec<Number>> {
    let start: Vec<f64> = moves.start.iter().map(Number::approximate).collect();
    if moves.is_empty() {
        return Vec::new();
    }
    let large = if is_region { LARGE.0 } else { LARGE.1 };
    if moves.len() > large {
        let parameters = local::improve(model, &start, options.steps, watch);
        let rounded = grid.numbers(&grid.nearest(&parameters));
        let is_moved = |k: usize| parameters[k] != start[k];
        let number = |(k, rounded)| {
            if is_moved(k) {
                rounded
            } else {
                moves.start[k].clone()
            }
        };
        return vec![rounded.into_iter().enumerate().map(number).collect()];
    }
    let mut random = Random(options.seed);
    let mut ends: Vec<Vec<Number>> = Vec::new();
    let mut least = f64::INFINITY;
    for round in 0..=options.restarts {
        let mut parameters = start.clone();
        if round > 0 {
            for (x, scale) in parameters.iter_mut().zip(&model.scales) {
                *x += JITTER * scale * random.next();
            }
        }
        if let Some(value) = end(model, grid, &mut parameters, options, watch)
            && value < least
        {
            least = value;
            ends.push(grid.numbers(&grid.nearest(&parameters)));
        }
        if !watch(least) {
            break;
        }
    }
    // The last ones are the best ones.
    ends.drain(..ends.len().saturating_sub(PROVED));
    ends
}

/// Searches from one place. The parameters become a point of the grid; its worst value.
fn end(
    model: &Model,
    grid: &Grid,
    parameters: &mut Vec<f64>,
    options: &Options,
    watch: Watch,
) -> Option<f64> {
    let everything = model.everything();
    let enough = options.goal.enough();
    descend(model, &everything, parameters, enough, options.steps, watch)?;
    let numbers = grid.numbers(&grid.improved(model, parameters, watch));
    *parameters = numbers.iter().map(Number::approximate).collect();
    model.worst(&everything, parameters)
}

/// The denominators: a typical edge has [`FINE`] steps, and those of a mesh are powers of two.
fn grid(tiling: &Tiling<3>, model: &Model, given: Option<u64>) -> Grid {
    let base: u64 = if tiling.frame.domain.is_region() {
        2
    } else {
        10
    };
    let fine = |scales: &[f64]| {
        let least = scales.iter().copied().fold(f64::INFINITY, f64::min);
        let mut denominator = 1u64;
        while (denominator as f64) * least < FINE && denominator < LARGEST {
            denominator *= base;
        }
        given.unwrap_or(denominator)
    };
    let (gram, points) = model.scales.split_at(model.gram_parameters);
    let mut denominators = vec![fine(gram); gram.len()];
    denominators.resize(model.scales.len(), fine(points));
    Grid { denominators }
}

/// Whether a proof has a better value for the goal, exactly.
fn is_better(proof: &Proved, other: &Proved, goal: Goal) -> bool {
    let value = |proof: &Proved| value(proof.statements(), goal);
    match (value(proof), value(other)) {
        (Some(new), Some(old)) => new.is_better_than(&old),
        _ => false,
    }
}

/// Doubles between -1 and 1, by the generator splitmix64 (Steele, Lea, Flood 2014).
pub struct Random(pub u64);

impl Random {
    /// The next number.
    pub fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ z >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ z >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^= z >> 31;
        (z >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }
}
