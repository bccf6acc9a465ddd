//! Large meshes: the stars of bad simplices move, one after the other.
//!
//! A pass takes the simplices that are among the worst, or that are not good enough, from the worst on.
//! The corners of each move so that the worst value of all simplices at them falls. No other simplex
//! changes, so the worst value of the mesh never rises. The lattice stays.

use crate::descent::{Watch, descend};
use crate::model::{Model, Patch};

/// Simplices this far from the worst are moved in one pass, where no value is good enough.
const WINDOW: f64 = 0.1;
/// A pass that lowers the worst value by less is the last but one; a star that gains less is left.
const LEAST_GAIN: f64 = 1e-5;
/// Linear programs for each star in a pass.
const STEPS: usize = 8;
/// The greatest number of passes.
const PASSES: usize = 60;
/// The number of passes without a gain that ends the search.
const PATIENCE: usize = 3;

/// The parameters after all passes.
pub fn improve(model: &Model, start: &[f64], passes: usize, watch: Watch) -> Vec<f64> {
    let mut parameters = start.to_vec();
    let stars = stars(model);
    let everything = model.everything();
    let enough = model.goal.enough();
    let mut last = f64::INFINITY;
    let mut idle = 0;
    for _ in 0..passes.min(PASSES) {
        let Some(values) = model.values(&everything, &parameters) else {
            break;
        };
        let mut worst: Vec<(f64, usize)> = values
            .iter()
            .map(|(s, values)| (largest(values), *s))
            .collect();
        worst.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
        let top = worst.first().map_or(f64::NEG_INFINITY, |(value, _)| *value);
        idle = if top > last - LEAST_GAIN { idle + 1 } else { 0 };
        if top <= enough || idle >= PATIENCE || !watch(top) {
            break;
        }
        last = top;
        let bad = worst.iter().take_while(|(value, _)| {
            if enough.is_finite() {
                *value > enough
            } else {
                *value > top - WINDOW
            }
        });
        for (_, simplex) in bad {
            if !watch(top) {
                return parameters;
            }
            let patch = around(model, &stars, *simplex);
            // `descend` keeps the parameters where nothing helps.
            descend(model, &patch, &mut parameters, enough, STEPS, &mut |_| true);
        }
    }
    parameters
}

fn largest(values: &[f64; 6]) -> f64 {
    values.iter().copied().fold(f64::NEG_INFINITY, f64::max)
}

/// The simplices that depend on each parameter.
fn stars(model: &Model) -> Vec<Vec<usize>> {
    let mut stars = vec![Vec::new(); model.scales.len()];
    for simplex in 0..model.len() {
        for parameter in own_parameters(model, simplex) {
            stars[parameter].push(simplex);
        }
    }
    stars
}

/// The parameters of the corners of a simplex. The lattice stays, as all simplices depend on it.
fn own_parameters(model: &Model, simplex: usize) -> Vec<usize> {
    let mut own = model.parameters_of_simplex(simplex);
    own.retain(|parameter| *parameter >= model.gram_parameters);
    own
}

/// The parameters of a simplex, and all simplices that depend on them.
fn around(model: &Model, stars: &[Vec<usize>], simplex: usize) -> Patch {
    let free = own_parameters(model, simplex);
    let mut simplices: Vec<usize> = free
        .iter()
        .flat_map(|k| stars[*k].iter().copied())
        .collect();
    simplices.sort_unstable();
    simplices.dedup();
    Patch { simplices, free }
}
