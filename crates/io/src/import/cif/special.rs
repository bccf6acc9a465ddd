//! Sites that lie on a special position within their written digits.
//!
//! 0.3333 is not 1/3, so a site at (0.3333, 0.6667, 1/4) does not lie on a threefold axis. It
//! has three images where one is meant. The digits show it: an operation moves the site by less
//! than they say. Let half a unit, u_j / 2, be the error of each coordinate. Then the k-th coordinate
//! of g x - x = (R - I) x + t is known up to Σ_j |R - I|_kj u_j / 2. Numbers of three decimals or
//! more may also be cut off, which doubles the error.

use super::operation::Listed;
use super::operation::Operation;
use super::sites::Site;
use super::token::at_line;
use crate::import::ImportError;
use crate::import::atoms::decimal::about;
use crate::import::atoms::options::Special;
use malachite::Rational;
use malachite::base::num::arithmetic::traits::{Abs, Floor};

type Vector = [Rational; 3];

/// Sites that an error names.
const NAMED: usize = 5;

/// An operation that keeps a site within its digits, and by how much it moves it.
struct Keeper {
    operation: usize,
    moved: Vector,
}

/// Moves sites onto their special positions, keeps them, or refuses; notes name the changes.
///
/// # Errors
/// A site lies on a special position only within its digits, unless `special` allows more.
pub fn settle(
    sites: &mut [Site],
    operations: &[Listed],
    special: Special,
) -> Result<Vec<String>, ImportError> {
    let mut notes = Vec::new();
    let mut refused = Vec::new();
    for site in sites.iter_mut() {
        let keepers = keepers(site, operations);
        if keepers.iter().all(|keeper| is_zero(&keeper.moved)) {
            continue;
        }
        match special {
            Special::Move => notes.push(move_site(site, operations, &keepers)?),
            Special::AsWritten => {}
            Special::Refuse => refused.push(refusal(site, operations, &keepers)),
        }
    }
    match refused.first() {
        None => Ok(notes),
        Some((line, _)) => Err(at_line(*line, in_words(&refused))),
    }
}

fn in_words(refused: &[(u32, String)]) -> String {
    let mut words: Vec<String> = Vec::new();
    for (index, (line, text)) in refused.iter().take(NAMED).enumerate() {
        match index {
            0 => words.push(text.clone()),
            _ => words.push(format!("line {line}: {text}")),
        }
    }
    if refused.len() > NAMED {
        words.push(format!("and {} more sites", refused.len() - NAMED));
    }
    words.push(
        "--special moves such sites onto their special positions, --as-written keeps them where they are".to_owned(),
    );
    words.join("\n  ")
}

/// The operations, the identity among them, that keep a site within its digits.
fn keepers(site: &Site, operations: &[Listed]) -> Vec<Keeper> {
    let is_long = site
        .units
        .iter()
        .all(|unit| *unit <= Rational::from_signeds(1, 1000));
    let keeps = |(index, listed): (usize, &Listed)| {
        let moved = displacement(&listed.operation, &site.position);
        let is_kept = (0..3).all(|k| {
            let error = twice_the_error(&listed.operation, k, &site.units);
            let twice = (&moved[k]).abs() * Rational::from(2);
            // Half a unit each, or less than one each.
            twice <= error || is_long && (&moved[k]).abs() < error
        });
        is_kept.then_some(Keeper {
            operation: index,
            moved,
        })
    };
    operations.iter().enumerate().filter_map(keeps).collect()
}

/// g x - x, up to the nearest lattice vector.
fn displacement(operation: &Operation, x: &Vector) -> Vector {
    let image = operation.apply(x);
    std::array::from_fn(|k| {
        let difference = &image[k] - &x[k];
        let nearest = (&difference + Rational::from_signeds(1, 2)).floor();
        difference - Rational::from(nearest)
    })
}

/// Σ_j |R - I|_kj u_j
fn twice_the_error(operation: &Operation, k: usize, units: &Vector) -> Rational {
    let mut sum = Rational::from(0);
    for (j, unit) in units.iter().enumerate() {
        let entry = operation.rotation[k][j] - i64::from(j == k);
        sum += Rational::from(entry.abs()) * unit;
    }
    sum
}

fn is_zero(vector: &Vector) -> bool {
    vector.iter().all(|x| *x == 0)
}

/// Moves a site to the mean of its images and says so.
fn move_site(
    site: &mut Site,
    operations: &[Listed],
    keepers: &[Keeper],
) -> Result<String, ImportError> {
    let count = Rational::from(keepers.len());
    let mean: Vector = std::array::from_fn(|k| {
        let sum = keepers
            .iter()
            .fold(Rational::from(0), |sum, keeper| sum + &keeper.moved[k]);
        &site.position[k] + sum / &count
    });
    let is_fixed = |keeper: &Keeper| {
        is_zero(&displacement(
            &operations[keeper.operation].operation,
            &mean,
        ))
    };
    let is_near = (0..3).all(|k| (&mean[k] - &site.position[k]).abs() <= site.units[k]);
    if !keepers.iter().all(is_fixed) || !is_near {
        let problem = format!(
            "site {} {} has {} images within its digits, but no point within the digits is fixed by their \
             operations: write more digits, or keep the site with --as-written",
            site.label,
            place(&site.position),
            keepers.len()
        );
        return Err(at_line(site.line, problem));
    }
    let [before, after] = [&site.position, &mean].map(exact_place);
    let note = format!(
        "site {}: {before} moved to {after}, which {} operations fix",
        site.label,
        keepers.len()
    );
    for k in 0..3 {
        if mean[k] != site.position[k] {
            site.units[k] = Rational::from(0);
        }
    }
    site.position = mean;
    Ok(note)
}

fn refusal(site: &Site, operations: &[Listed], keepers: &[Keeper]) -> (u32, String) {
    let moving = keepers.iter().find(|keeper| !is_zero(&keeper.moved));
    let step = moving.map_or_else(String::new, |keeper| {
        format!(
            "the operation {:?} moves it by {} only, which is within the precision of its digits; ",
            operations[keeper.operation].text,
            place(&keeper.moved)
        )
    });
    let exact = keepers
        .iter()
        .filter(|keeper| is_zero(&keeper.moved))
        .count();
    let words = format!(
        "site {} {} is near a special position: {step}as written it stands for {} atoms, on the special position for {}",
        site.label,
        place(&site.position),
        operations.len() / exact.max(1),
        operations.len() / keepers.len(),
    );
    (site.line, words)
}

fn place(position: &Vector) -> String {
    let numbers = position.each_ref().map(|x| about(x, 8));
    format!("({})", numbers.join(", "))
}

fn exact_place(position: &Vector) -> String {
    let numbers = position.each_ref().map(ToString::to_string);
    format!("({})", numbers.join(", "))
}

/// The number of images of a point modulo the lattice.
pub fn images(position: &Vector, operations: &[Listed]) -> usize {
    let keeps = |listed: &&Listed| is_zero(&displacement(&listed.operation, position));
    let stabiliser = operations.iter().filter(keeps).count();
    operations.len() / stabiliser.max(1)
}
