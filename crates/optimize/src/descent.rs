//! Sequential linear programs in a trust region.

use crate::model::{Model, Patch};
use crate::program::best_step;

/// Values this far from the worst take part, in radians.
const WINDOW: f64 = 0.2;
/// The first trust region, in edges.
const FIRST_RADIUS: f64 = 0.05;
/// A trust region that is smaller ends the search.
const LAST_RADIUS: f64 = 1e-11;
/// A step that promises less ends the search.
const LEAST_GAIN: f64 = 1e-12;
/// An accepted step gains this share of its promise.
const SHARE: f64 = 0.1;

/// Reports the current worst value; returns whether to go on.
pub type Watch<'a> = &'a mut dyn FnMut(f64) -> bool;

/// Moves the free parameters of a patch until its worst value is at most `enough`, or no step helps.
/// Returns the worst value; `None` if a simplex of the start is not positively oriented.
pub fn descend(
    model: &Model,
    patch: &Patch,
    parameters: &mut Vec<f64>,
    enough: f64,
    steps: usize,
    watch: Watch,
) -> Option<f64> {
    let mut worst = model.worst(patch, parameters)?;
    let mut radius = FIRST_RADIUS;
    for _ in 0..steps {
        if worst <= enough || radius < LAST_RADIUS || patch.free.is_empty() || !watch(worst) {
            break;
        }
        let rows = model.rows(patch, parameters, worst - WINDOW)?;
        let Some((step, promise)) = best_step(&rows, patch.free.len(), radius) else {
            radius /= 4.0;
            continue;
        };
        let promised = worst - promise;
        if promised < LEAST_GAIN {
            break;
        }
        let mut trial = parameters.clone();
        for (&parameter, change) in patch.free.iter().zip(&step) {
            trial[parameter] += change * model.scales[parameter];
        }
        let gain = model.worst(patch, &trial).map(|value| worst - value);
        match gain {
            Some(gain) if gain >= SHARE * promised => {
                *parameters = trial;
                worst -= gain;
                if gain > 0.7 * promised {
                    radius = (2.0 * radius).min(1.0);
                }
            }
            _ => radius /= 3.0,
        }
    }
    Some(worst)
}
