//! The growth of time and memory. Four sizes of each kind of work run, each in a process of its own. The
//! factor for twice the size is fitted.

use crate::child::{self, Found};
use crate::clock::repetitions;
use crate::row::{Table, Target};
use std::time::Duration;

/// Twice the size may take 15 percent more than twice the time.
const LINEAR: f64 = 2.0 * 1.15;

/// Kinds of work, and cells in each direction: about twice as many tetrahedra each time.
const KINDS: [(&str, [u16; 4]); 10] = [
    ("filter", [16, 20, 25, 32]),
    ("exact", [10, 13, 16, 20]),
    ("quadratic", [4, 5, 6, 8]),
    ("matching", [25, 32, 40, 50]),
    ("whole", [25, 32, 40, 50]),
    ("delaunay", [10, 13, 16, 20]),
    ("delaunay-skewed", [10, 13, 16, 20]),
    ("reading", [10, 13, 16, 20]),
    ("verifier, Q", [4, 5, 6, 8]),
    ("verifier, Q(sqrt 5)", [3, 4, 5, 6]),
];

/// The rows of growth.
pub fn measure(table: &Table) {
    table.head("how cost grows: the factor for twice the size, fitted over four sizes");
    let folder = tempfile::tempdir().expect("a directory");
    for (kind, sizes) in KINDS {
        let found = sizes.map(|size| least(&child::prepared(kind, size, folder.path())));
        report(table, kind, "time", "s", &found, |found| found.seconds);
        report(table, kind, "memory", "MB", &found, |found| found.megabytes);
    }
}

/// The run that took the least time, of three where they are short; short work is repeated.
fn least(work: &child::Work) -> Found {
    let first = child::start(work);
    if first.seconds > 0.5 {
        return first;
    }
    let times = repetitions(Duration::from_secs_f64(first.elapsed));
    let runs = (0..2).map(|_| child::start(&work.clone().times(times)));
    let seconds = runs.map(|found| found.seconds / f64::from(times));
    Found {
        seconds: seconds.min_by(f64::total_cmp).unwrap_or(first.seconds),
        ..first
    }
}

fn report(
    table: &Table,
    kind: &str,
    what: &str,
    unit: &str,
    found: &[Found; 4],
    value: impl Fn(&Found) -> f64,
) {
    let points = found.each_ref().map(|f| (f.count as f64, value(f)));
    let factor = slope(&points.map(|(n, y)| (n.ln(), y.max(1e-9).ln()))).exp2();
    let texts = points.map(|(n, y)| format!("{n} {y:.3}"));
    let note = format!("tetrahedra, {unit}: {}", texts.join("; "));
    let work = format!("{kind}, {what}");
    table.row(
        &work,
        factor,
        "x for twice the size",
        Target::Most(LINEAR),
        &note,
    );
}

/// The slope of the line of least squares.
fn slope(points: &[(f64, f64)]) -> f64 {
    let count = points.len() as f64;
    let mean = |part: fn(&(f64, f64)) -> f64| points.iter().map(part).sum::<f64>() / count;
    let (x, y) = (mean(|p| p.0), mean(|p| p.1));
    let covariance: f64 = points.iter().map(|p| (p.0 - x) * (p.1 - y)).sum();
    let variance: f64 = points.iter().map(|p| (p.0 - x).powi(2)).sum();
    covariance / variance
}
