//! Orientation and acuteness of all tetrahedra, exactly: with the filter in front, and by exact
//! values alone.

use crate::clock::{compare, elapsed};
use crate::data::{FIELDS, a15, bent, doubles, entry};
use crate::naive;
use crate::row::{Table, Target};
use acutile_core::checker::Model;
use acutile_core::predicates::{Shape, Signs};
use acutile_core::tiling::{Tiling, supercell};
use std::time::Duration;

/// The rows of the predicates.
pub fn measure(table: &Table) {
    table.head("orientation and acuteness, all signs proved");
    let small = a15(4);
    let a15 = a15(6);
    let easy = filtered_row(
        table,
        "A15, coordinates are doubles",
        &doubles(&a15, 1e-4, None),
        Target::Most(1.8),
    );
    exact_row(
        table,
        "doubles of 53 bits",
        &doubles(&a15, 1e-4, None),
        Target::None,
    );
    filtered_row(table, "A15, integers", &a15, Target::Most(1.8));
    right_angles(table, "BCC", &supercell(&entry("bcc"), [8; 3]), easy);
    right_angles(
        table,
        "cube in six",
        &supercell(&entry("cube-6"), [10; 3]),
        easy,
    );
    for (bits, step, limit) in [(128, "1/1048583", 6.0), (256, "1/1125899906842679", 60.0)] {
        let name = format!("rationals, {bits} bits suffice");
        let tiling = bent(&a15, step);
        exact_row(table, &name, &tiling, Target::Most(limit));
        filtered_row(table, &name, &tiling, Target::None);
    }
    for (name, step) in FIELDS {
        let is_quadratic = name.starts_with('Q');
        let tiling = bent(if is_quadratic { &a15 } else { &small }, step);
        let (exact, filtered) = if is_quadratic {
            (Target::Most(100.0), Target::Most(3.0))
        } else {
            (Target::None, Target::Most(5.0))
        };
        exact_row(table, name, &tiling, exact);
        filtered_row(table, name, &tiling, filtered);
    }
}

fn filtered_row(table: &Table, name: &str, tiling: &Tiling<3>, target: Target) -> f64 {
    let (measured, naive) = filtered(tiling);
    let name = format!("{name}, filtered");
    table.row(&name, measured, "x naive", target, &note(tiling, naive));
    measured
}

/// Exact right angles, where no filter decides, in units of the same program's easy case.
fn right_angles(table: &Table, name: &str, tiling: &Tiling<3>, easy: f64) {
    let (measured, naive) = filtered(tiling);
    let note = note(tiling, naive);
    table.plain(&format!("{name}, filtered"), measured, "x naive", &note);
    let name = format!("{name}, angles of 90 degrees");
    table.row(
        &name,
        measured / easy,
        "x doubles, filtered",
        Target::Most(2.0),
        "",
    );
}

fn exact_row(table: &Table, name: &str, tiling: &Tiling<3>, target: Target) {
    let (measured, naive) = exact(tiling);
    let name = format!("{name}, no filter");
    table.row(&name, measured, "x naive", target, &note(tiling, naive));
}

fn note(tiling: &Tiling<3>, naive: Duration) -> String {
    let each = naive.as_secs_f64() * 1e9 / tiling.len() as f64;
    format!("{} tetrahedra, naive {each:.1} ns each", tiling.len())
}

/// The filter, and exact signs where it is silent, in units of the naive pass, and its time. The tiling must be nonobtuse.
fn filtered(tiling: &Tiling<3>) -> (f64, Duration) {
    let model = Model::new(tiling);
    let shape = model.prepare(Shape);
    against_naive(tiling, || assert!(shape.failing(is_right).is_empty()))
}

/// Exact signs of all, without a filter, in units of the naive pass, and its time.
fn exact(tiling: &Tiling<3>) -> (f64, Duration) {
    let model = Model::new(tiling);
    let shape = model.prepare(Shape);
    against_naive(tiling, || {
        for corners in tiling.simplices() {
            assert!(is_right(&shape.exact_signs(corners, &corners[0])));
        }
    })
}

fn against_naive(tiling: &Tiling<3>, work: impl Fn()) -> (f64, Duration) {
    let naive = naive::pass(tiling);
    compare(|| elapsed(&work), || elapsed(&naive))
}

/// Positively oriented, and no angle is obtuse.
pub fn is_right(signs: &Signs) -> bool {
    let (orientation, angles) = signs.split_first();
    orientation.all_positive() && angles.none_positive()
}
