//! `acutile classify` from the file of a crystal structure to the answer, with the proof of its
//! triangulation, on all cores. The structure is A15 with shaken atoms, so that all tetrahedra differ.

use crate::clock::{once, processor_time_of_children};
use crate::data::a15_points;
use crate::row::{Table, Target};
use crate::verifier;
use acutile_core::delaunay::{Ties, triangulate};
use acutile_core::tiling::{Frame, PointSet};
use acutile_exact::number::{Field, Number};
use malachite::Rational;
use std::path::Path;
use std::process::Command;
use std::time::Instant;

/// Cells in a row, and the most seconds that they may take.
const SIZES: [(u16, f64); 2] = [(8, 1.0), (11, 2.0)];
/// Coordinates are multiples of one over this.
const UNIT: i64 = 1_000_000_000_000;
/// Atoms move by less than this part of a cell.
const SHAKE: i64 = 500;

/// The rows of the program. It is run three times, and the least time counts.
pub fn measure(table: &Table) {
    table.head("classify, the whole program, on all cores");
    let folder = tempfile::tempdir().expect("a directory");
    for (n, limit) in SIZES {
        let points = shaken(n);
        let file = folder.path().join(format!("{n}.poscar"));
        std::fs::write(&file, poscar(n, &points)).expect("the directory can be written");
        let (mut elapsed, mut processors) = (f64::INFINITY, f64::INFINITY);
        for _ in 0..3 {
            let (start, before) = (Instant::now(), processor_time_of_children());
            run(&file);
            elapsed = elapsed.min(start.elapsed().as_secs_f64());
            let spent = processor_time_of_children().saturating_sub(before);
            processors = processors.min(spent.as_secs_f64());
        }
        let tiling = triangulate(&set(n, &points), Ties::Refuse).expect("one triangulation");
        let certificate = verifier::certificate(&tiling);
        let (verified, _) = once(|| verifier::check(&certificate));
        let note = format!("{} atoms, {} tetrahedra", points.len(), tiling.len());
        let work = |what: &str| format!("{} atoms, {what}", points.len());
        table.row(&work("elapsed"), elapsed, "s", Target::Most(limit), &note);
        table.plain(&work("processors"), processors, "s", &note);
        let share = processors / verified.as_secs_f64();
        let name = work("processors");
        table.plain(&name, share, "x verifying it", &note);
    }
}

/// The atoms of n x n x n cells, in units of the whole.
fn shaken(n: u16) -> Vec<[i64; 3]> {
    let (mut state, unit) = (1u64, Number::from(Rational::from(UNIT)));
    let mut moved = |x: &Number| {
        // Knuth's multiplier; the upper bits are good.
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1);
        let random = (state >> 30) as i64 % (2 * UNIT / SHAKE) - UNIT / SHAKE;
        let place = i64::try_from(&(x * &unit).floor()).expect("a place in the cell");
        (place + random / i64::from(n)).rem_euclid(UNIT)
    };
    let atoms = a15_points(n).points.into_iter();
    atoms.map(|atom| atom.each_ref().map(&mut moved)).collect()
}

fn poscar(n: u16, points: &[[i64; 3]]) -> String {
    let rows = [0, 1, 2].map(|i| [0, 1, 2].map(|j| if i == j { 10 * n } else { 0 }));
    let lattice = rows.map(|[x, y, z]| format!("{x} {y} {z}\n")).concat();
    let atoms: Vec<String> = points
        .iter()
        .map(|point| point.map(|x| format!("0.{x:012}")).join(" "))
        .collect();
    format!(
        "A15, shaken\n1.0\n{lattice}Cr\n{}\nDirect\n{}\n",
        points.len(),
        atoms.join("\n")
    )
}

fn set(n: u16, points: &[[i64; 3]]) -> PointSet<3> {
    let field = Field::rationals();
    let square = 100 * i64::from(n) * i64::from(n);
    let entry = |i, j| field.integer(if i == j { square } else { 0 });
    let gram = std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)));
    let number = |x: i64| Number::from(Rational::from_signeds(x, UNIT));
    PointSet {
        frame: Frame::space(Field::rationals(), gram),
        points: points.iter().map(|point| point.map(number)).collect(),
    }
}

fn run(file: &Path) {
    let program = env!("CARGO_BIN_EXE_acutile");
    let output = Command::new(program).arg("classify").arg(file).output();
    let output = output.expect("the program starts");
    let text = String::from_utf8_lossy(&output.stdout);
    assert!(text.contains("isomorphic to: a15"), "{text}");
}
