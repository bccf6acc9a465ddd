//! What exactness costs, as ratios to a naive double-precision pass over the same
//! data in the same run: `cargo bench`.
//!
//! Every line is the fastest of several rounds. "naive" computes orientation and
//! the six products of normals of each tetrahedron in doubles, from doubles, with
//! no error bound: what an unproved check does.

use acutile::certificate::{Certificate, to_bytes};
use acutile::checker::{
    Findings, Model, Options, check_acute, check_delaunay, check_orientation, prove,
};
use acutile::geometry::{Scalar, Simplex, linear};
use acutile::number::{Number, Reader};
use acutile::tiling::{AnyTiling, Tiling, match_facets, supercell};
use acutile::verifier::{Limits, verify};
use std::hint::black_box;
use std::time::{Duration, Instant};

/// Copies of the A15 cell in each direction.
const SIZE: u16 = 8;
const ROUNDS: usize = 3;

fn main() {
    let rational = supercell(&a15(), [SIZE; 3]);
    println!(
        "A15, {SIZE} x {SIZE} x {SIZE} cells, {} tetrahedra, one thread",
        rational.len()
    );
    let fields = [
        ("Q", rational.clone()),
        ("Q(sqrt 5)", bent(&rational, "sqrt(5)", "2236/1000")),
        (
            "Q(sqrt 2 + sqrt 3), degree 4",
            bent(&rational, "sqrt(2)+sqrt(3)", "3146/1000"),
        ),
    ];
    for (name, tiling) in &fields {
        println!("\n{name}");
        let naive = naive_time(tiling);
        let row = |what: &str, count: usize, time: Duration| report(what, count, time, naive);
        row("naive double pass", tiling.len(), naive);
        row(
            "exact orientation",
            tiling.len(),
            over_field(tiling, Work::Orientation),
        );
        row(
            "exact acuteness",
            tiling.len(),
            over_field(tiling, Work::Acuteness),
        );
        row(
            "exact local Delaunay",
            tiling.len(),
            over_field(tiling, Work::Delaunay),
        );
        row(
            "facet matching (half-facets)",
            4 * tiling.len(),
            fastest(|| match_facets(tiling)),
        );
        let bytes = to_bytes(&certificate(tiling));
        let limits = Limits {
            simplices: usize::MAX,
            ..Limits::default()
        };
        let verified = fastest(|| verify(&bytes, &limits).expect("it is right"));
        row("verification of the certificate", tiling.len(), verified);
    }
}

fn a15() -> Tiling<3> {
    match acutile::catalog::find("a15")
        .expect("it is in the catalogue")
        .build()
    {
        Ok(AnyTiling::Space(tiling)) => tiling,
        _ => unreachable!("A15 is a tiling of space"),
    }
}

/// The tiling with its vertices moved a little by multiples of `number - near`,
/// which generates the field, so that no coordinate is rational any more.
fn bent(tiling: &Tiling<3>, number: &str, near: &str) -> Tiling<3> {
    let mut reader = Reader::new();
    let text = format!("({number}-{near})/1000");
    reader.learn(&text).expect("a number");
    let step = reader.value(&text).expect("it was learnt");
    let mut bent = tiling.clone();
    bent.frame.field = reader.field();
    for (index, vertex) in bent.vertices.iter_mut().enumerate() {
        for (k, coordinate) in vertex.iter_mut().enumerate() {
            let factor = bent.frame.field.integer(1 + ((index + 3 * k) % 7) as i64);
            *coordinate = &*coordinate + &(&step * &factor);
        }
    }
    bent
}

fn certificate(tiling: &Tiling<3>) -> Certificate {
    prove(tiling, &Options::default(), &|_| ()).expect("it is a tiling")
}

#[derive(Clone, Copy)]
enum Work {
    Orientation,
    Acuteness,
    Delaunay,
}

fn over_field(tiling: &Tiling<3>, work: Work) -> Duration {
    if tiling.frame.field.degree() == 1 {
        exact_time(&Model::rational(tiling), work)
    } else {
        exact_time(&Model::algebraic(tiling), work)
    }
}

fn exact_time<S: Scalar>(model: &Model<S, 3>, work: Work) -> Duration {
    let matching = match_facets(model.tiling);
    fastest(|| {
        let mut findings = Findings::new(1);
        match work {
            Work::Orientation => check_orientation(model, &mut findings),
            Work::Acuteness => check_acute(model, &mut findings),
            Work::Delaunay => check_delaunay(model, &matching, false, &mut findings),
        }
        assert!(findings.is_empty());
    })
}

fn naive_time(tiling: &Tiling<3>) -> Duration {
    let vertices: Vec<[f64; 3]> = tiling
        .vertices
        .iter()
        .map(|v| v.each_ref().map(Number::approximate))
        .collect();
    let gram = tiling
        .frame
        .gram
        .each_ref()
        .map(|row| row.each_ref().map(Number::approximate));
    let cogram = linear::cofactors(&gram);
    fastest(|| {
        let mut acute = 0;
        for corners in tiling.simplices() {
            let point = |i: usize| {
                let vertex = &vertices[corners[i].vertex as usize];
                std::array::from_fn(|k| vertex[k] + f64::from(corners[i].shift[k]))
            };
            let simplex = Simplex::new(&[point(0), point(1), point(2), point(3)]);
            acute += usize::from(simplex.determinant > 0.0 && naive_acute(&simplex, &cogram));
        }
        assert_eq!(acute, tiling.len());
    })
}

fn naive_acute(simplex: &Simplex<f64, 3>, cogram: &[[f64; 3]; 3]) -> bool {
    let [a, b, c] = &simplex.gradients;
    let [x, y] = [linear::apply(cogram, b), linear::apply(cogram, c)];
    let (ab, ac, bc) = (linear::dot(a, &x), linear::dot(a, &y), linear::dot(b, &y));
    let (aa, bb, cc) = (
        linear::square(cogram, a),
        linear::dot(b, &x),
        linear::dot(c, &y),
    );
    ab < 0.0
        && ac < 0.0
        && bc < 0.0
        && aa + ab + ac > 0.0
        && ab + bb + bc > 0.0
        && ac + bc + cc > 0.0
}

fn fastest<T>(mut work: impl FnMut() -> T) -> Duration {
    let round = |_| {
        let start = Instant::now();
        black_box(work());
        start.elapsed()
    };
    (0..ROUNDS).map(round).min().unwrap_or_default()
}

fn report(what: &str, count: usize, time: Duration, naive: Duration) {
    let per_second = count as f64 / time.as_secs_f64();
    let ratio = time.as_secs_f64() / naive.as_secs_f64();
    println!("  {what:34} {per_second:14.0} per second {ratio:10.1} x naive");
}
