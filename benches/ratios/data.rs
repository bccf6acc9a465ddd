//! The tilings and point sets that are measured.

use acutile_core::tiling::{AnyTiling, Coordinates, Frame, PointSet, Tiling, supercell};
use acutile_exact::number::{Number, Reader};
use malachite::Rational;

/// A tiling of space of the catalogue.
pub fn entry(name: &str) -> Tiling<3> {
    match acutile_catalog::find(name)
        .expect("it is in the catalogue")
        .build()
    {
        Ok(AnyTiling::Space(tiling)) => tiling,
        _ => unreachable!("{name} is a tiling of space"),
    }
}

/// n x n x n cells of A15: 8 n³ vertices, 46 n³ tetrahedra.
pub fn a15(n: u16) -> Tiling<3> {
    supercell(&entry("a15"), [n; 3])
}

/// The tiling with its vertices moved a little by multiples of `step`, a text. So the coordinates are as
/// long, or as irrational, as that number.
pub fn bent(tiling: &Tiling<3>, step: &str) -> Tiling<3> {
    let mut reader = Reader::new();
    reader.learn(step).expect("a number");
    let step = reader.value(step).expect("it was learnt");
    let mut bent = tiling.clone();
    bent.frame.field = reader.field();
    let moved = |(index, vertex): (usize, [Number; 3])| {
        std::array::from_fn(|k| {
            let factor = bent.frame.field.integer(1 + ((index + 3 * k) % 7) as i64);
            &vertex[k] + &(&step * &factor)
        })
    };
    bent.vertices = tiling.vertices.iter().enumerate().map(moved).collect();
    bent
}

/// Irrational steps of the fields of the table, all near 2e-7: √d minus a decimal near it.
pub const FIELDS: [(&str, &str); 4] = [
    ("Q(sqrt 5)", "(sqrt(5)-2236/1000)/1000"),
    ("Q(sqrt 3)", "(sqrt(3)-1732/1000)/1000"),
    ("degree 4", "(sqrt(2)+sqrt(3)-3146/1000)/1000"),
    ("degree 8", "(sqrt(2)+sqrt(3)+sqrt(5)-5382/1000)/1000"),
];

/// Numbers between -1/2 and 1/2, the same in every run.
pub fn noise() -> impl FnMut() -> f64 {
    let mut state = 1u64;
    move || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1);
        (state >> 11) as f64 / 2f64.powi(53) - 0.5
    }
}

/// The tiling with its vertices rounded to doubles and moved by up to half of `size`; then
/// multiples of 2^-`bits`, if that is given.
pub fn doubles(tiling: &Tiling<3>, size: f64, bits: Option<i32>) -> Tiling<3> {
    let mut noise = noise();
    let mut moved = |x: &Number| {
        let x = x.approximate() + size * noise();
        bits.map_or(x, |bits| (x * 2f64.powi(bits)).round() / 2f64.powi(bits))
    };
    let points = tiling.vertices.iter().map(|v| v.each_ref().map(&mut moved));
    let points = Coordinates::from_doubles(points.collect());
    let mut moved = tiling.clone();
    moved.vertices = points.expect("they are finite");
    moved
}

/// The vertices of n³ cells of A15, and their lattice.
pub fn a15_points(n: u16) -> PointSet<3> {
    points(&a15(n))
}

/// The same places, moved a little, in a lattice whose basis vectors include angles of 66 and
/// 73 degrees.
pub fn skewed_points(n: u16) -> PointSet<3> {
    let mut tiling = doubles(&a15(n), 0.05 / f64::from(n), None);
    let gram = [[10, 4, 3], [4, 10, 4], [3, 4, 10]];
    let number = |value: i64| Number::from(Rational::from(value));
    tiling.frame = Frame::space(tiling.frame.field, gram.map(|row| row.map(number)));
    points(&tiling)
}

/// The vertices of a tiling.
pub fn points(tiling: &Tiling<3>) -> PointSet<3> {
    PointSet {
        frame: tiling.frame.clone(),
        points: tiling.vertices.to_numbers(),
    }
}
