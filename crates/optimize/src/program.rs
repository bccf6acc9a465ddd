//! The linear programs of a search: minimise t subject to value + gradient · step <= t in a box.

use clarabel::algebra::CscMatrix;
use clarabel::solver::{
    DefaultSettingsBuilder, DefaultSolver, IPSolver, NonnegativeConeT, SolverStatus,
};

/// A linear condition: `value` + Σ coefficient · step <= t.
#[derive(Clone, Debug)]
pub struct Row {
    pub value: f64,
    pub gradient: Vec<(usize, f64)>,
}

/// The step with entries at most `radius` in absolute value for which the largest row is as small as
/// possible, and that value. `None` where the solver finds none.
pub fn best_step(rows: &[Row], columns: usize, radius: f64) -> Option<(Vec<f64>, f64)> {
    let worst = rows
        .iter()
        .map(|row| row.value)
        .fold(f64::NEG_INFINITY, f64::max);
    let (matrix, bounds) = matrix(rows, columns, radius, worst);
    let mut cost = vec![0.0; columns];
    cost.push(1.0);
    let settings = DefaultSettingsBuilder::default()
        .verbose(false)
        .build()
        .ok()?;
    let none = CscMatrix::zeros((columns + 1, columns + 1));
    let cones = [NonnegativeConeT(bounds.len())];
    let mut solver = DefaultSolver::new(&none, &cost, &matrix, &bounds, &cones, settings).ok()?;
    solver.solve();
    let is_solved = matches!(
        solver.solution.status,
        SolverStatus::Solved | SolverStatus::AlmostSolved
    );
    let step: Vec<f64> = solver.solution.x[..columns]
        .iter()
        .map(|x| x.clamp(-1.0, 1.0) * radius)
        .collect();
    let value = |row: &Row| {
        let terms = row.gradient.iter().map(|(k, g)| step[*k] * g);
        row.value + terms.sum::<f64>()
    };
    let reached = rows.iter().map(value).fold(f64::NEG_INFINITY, f64::max);
    (is_solved && step.iter().all(|x| x.is_finite())).then_some((step, reached))
}

/// The conditions for steps and a t in units of `radius`: the rows, then the box.
fn matrix(rows: &[Row], columns: usize, radius: f64, worst: f64) -> (CscMatrix<f64>, Vec<f64>) {
    let mut entries: Vec<Vec<(usize, f64)>> = vec![Vec::new(); columns + 1];
    let mut bounds = Vec::with_capacity(rows.len() + 2 * columns);
    for row in rows {
        for (column, gradient) in &row.gradient {
            entries[*column].push((bounds.len(), *gradient));
        }
        entries[columns].push((bounds.len(), -1.0));
        bounds.push((worst - row.value) / radius);
    }
    for (column, entries) in entries[..columns].iter_mut().enumerate() {
        let first = rows.len() + 2 * column;
        entries.push((first, 1.0));
        entries.push((first + 1, -1.0));
    }
    bounds.resize(rows.len() + 2 * columns, 1.0);
    let mut starts = vec![0];
    let (mut places, mut values) = (Vec::new(), Vec::new());
    for column in entries {
        for (row, value) in column {
            places.push(row);
            values.push(value);
        }
        starts.push(places.len());
    }
    let matrix = CscMatrix::new(bounds.len(), columns + 1, starts, places, values);
    (matrix, bounds)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// max(x, 1 - x) is least at x = 1/2; in a box of 1/4 the best step is to its side.
    #[test]
    fn two_lines_cross() {
        let row = |value, gradient| Row {
            value,
            gradient: vec![(0, gradient)],
        };
        let rows = [row(0.0, 1.0), row(1.0, -1.0)];
        let (step, value) = best_step(&rows, 1, 2.0).unwrap();
        assert!((step[0] - 0.5).abs() < 1e-6 && (value - 0.5).abs() < 1e-6);
        let (step, value) = best_step(&rows, 1, 0.25).unwrap();
        assert!((step[0] - 0.25).abs() < 1e-6 && (value - 0.75).abs() < 1e-6);
    }
}
