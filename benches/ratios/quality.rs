//! The figures of `acutile quality` against the proof of `acutile certify --no-certificate`, both in
//! memory, over the same mesh.

use crate::clock::fastest;
use crate::data::{a15, doubles, entry, noise};
use crate::row::{Table, Target, ratio};
use acutile_core::checker::{Options, examine};
use acutile_core::delaunay::{Ties, triangulate};
use acutile_core::statistics::statistics;
use acutile_core::tiling::{Coordinates, Frame, PointSet, Tiling, supercell};
use acutile_exact::number::Number;
use malachite::Rational;

/// The rows of the figures.
pub fn measure(table: &Table) {
    table.head("figures of quality, in units of the proof without a certificate");
    let grid = supercell(&entry("cube-6"), [26; 3]);
    let tenths = tenths(&grid);
    for (name, tiling) in [
        ("A15, doubles of 53 bits", doubles(&a15(12), 1e-4, None)),
        ("Delaunay mesh of 100,000 random points", delaunay(100_000)),
        ("integer grid", grid),
        ("grid of multiples of the double 0.1", tenths),
    ] {
        let proof = fastest(|| examine(&tiling, &Options::default(), &|_| ()).is_ok());
        let figures = fastest(|| statistics(&tiling, 5));
        let note = format!("{} tetrahedra", tiling.len());
        let measured = ratio(figures, proof);
        table.row(name, measured, "x proof", Target::Most(2.0), &note);
    }
}

/// The periodic Delaunay triangulation of random points in the unit cube.
fn delaunay(points: usize) -> Tiling<3> {
    let mut noise = noise();
    let mut coordinate = || {
        let x = Rational::try_from(noise() + 0.5).expect("it is finite");
        Number::from(x)
    };
    let set = PointSet {
        frame: Frame::cubic(),
        points: (0..points)
            .map(|_| std::array::from_fn(|_| coordinate()))
            .collect(),
    };
    let tiling = triangulate(&set, Ties::Refuse);
    tiling.expect("random points have one triangulation")
}

/// The grid with each coordinate 0.1 times an integer, rounded, and stretched over the cell:
/// angles are right angles but for the last bits.
fn tenths(grid: &Tiling<3>) -> Tiling<3> {
    let mut tenths = grid.clone();
    let points = grid.vertices.iter();
    let points = points.map(|v| {
        v.each_ref()
            .map(|x| (x.approximate() * 26.0).round() * 0.1 / 2.6)
    });
    tenths.vertices = Coordinates::from_doubles(points.collect()).expect("they are finite");
    tenths
}
