//! What exactness costs, as ratios to a naive double-precision pass over the same
//! data in the same run: `cargo bench`.
//!
//! Every line is the fastest of several rounds, on one thread but for the last table.
//! Long work is timed by the processor time of its threads, from the kernel's scheduler,
//! so that other programs disturb it less.
//! "naive" computes orientation and the six products of normals of each tetrahedron in
//! doubles, from doubles, with no error bound: what an unproved check does.

use acutile::certificate::to_bytes;
use acutile::checker::{
    Findings, Model, Options, check_acute, check_delaunay, check_orientation, check_volume, prove,
};
use acutile::geometry::{Simplex, linear};
use acutile::number::{Number, Reader};
use acutile::predicates::{Angles, AnglesAgainst, Orientation};
use acutile::tiling::{AnyTiling, Coordinates, Tiling, match_facets, supercell};
use acutile::verifier::{Limits, verify};
use std::hint::black_box;
use std::time::{Duration, Instant};

const ROUNDS: usize = 100;
const LONGEST: Duration = Duration::from_secs(2);

fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    let wants = |name: &str| {
        let named: Vec<&String> = arguments[1..]
            .iter()
            .filter(|a| !a.starts_with('-'))
            .collect();
        named.is_empty() || named.iter().any(|a| *a == name)
    };
    let single = rayon::ThreadPoolBuilder::new()
        .num_threads(1)
        .build()
        .expect("a thread");
    single.install(|| {
        if wants("predicates") {
            predicates();
        }
        if wants("matching") {
            matching();
        }
        if wants("statements") {
            statements();
        }
        if wants("verifier") {
            verifier();
        }
    });
    if wants("whole") {
        whole();
    }
}

fn predicates() {
    println!("orientation and acuteness, x naive; exact: no filter in front");
    let a15 = supercell(&entry("a15"), [6; 3]);
    let fraction = |text: &str| bent(&a15, text, "0");
    row("A15, integers", &a15);
    row("A15, moved, coordinates are doubles", &doubles(&a15));
    row(
        "BCC, angles of 90 degrees",
        &supercell(&entry("bcc"), [8; 3]),
    );
    row(
        "cube in six, angles of 90 degrees",
        &supercell(&entry("cube-6"), [10; 3]),
    );
    row("rational, 25 bits", &fraction("1/1048583"));
    row("rational, 50 bits", &fraction("1/1125899906842679"));
    row("Q(sqrt 5)", &bent(&a15, "sqrt(5)", "2236/1000"));
    row("Q(sqrt 3)", &bent(&a15, "sqrt(3)", "1732/1000"));
    let small = supercell(&entry("a15"), [4; 3]);
    row(
        "Q(sqrt 2 + sqrt 3), degree 4",
        &bent(&small, "sqrt(2)+sqrt(3)", "3146/1000"),
    );
    row(
        "degree 8",
        &bent(&small, "sqrt(2)+sqrt(3)+sqrt(5)", "5382/1000"),
    );
}

/// Filter and exact values together, and exact values alone.
fn row(name: &str, tiling: &Tiling<3>) {
    let naive = naive_time(tiling);
    let model = Model::new(tiling);
    let (orientation, angles) = (model.prepare(Orientation), model.prepare(Angles));
    let filtered = fastest(|| {
        let positive = orientation.failing(|signs| signs.all_positive());
        let nonobtuse = angles.failing(|signs| signs.none_positive());
        assert!(positive.is_empty() && nonobtuse.is_empty());
    });
    let exact = fastest(|| {
        for corners in tiling.simplices() {
            assert!(orientation.exact_signs(corners, &corners[0]).all_positive());
            assert!(angles.exact_signs(corners, &corners[0]).none_positive());
        }
    });
    let per = |time: Duration| time.as_secs_f64() * 1e9 / tiling.len() as f64;
    println!(
        "  {name:38} {:7} tetrahedra, naive {:5.1} ns, filtered {:6.2} x, exact {:8.1} x",
        tiling.len(),
        per(naive),
        per(filtered) / per(naive),
        per(exact) / per(naive),
    );
}

fn matching() {
    let tiling = supercell(&entry("a15"), [38; 3]);
    let copy = on_processor(|| tiling.corners.clone());
    let time = on_processor(|| match_facets(&tiling));
    println!(
        "\nmatching of {} half-facets: {:.3} s, {:.1} x a copy of the corners",
        tiling.corners.len(),
        time.as_secs_f64(),
        time.as_secs_f64() / copy.as_secs_f64()
    );
}

fn statements() {
    println!("\nfurther statements, x naive");
    for (name, tiling) in [
        ("A15, integers", supercell(&entry("a15"), [6; 3])),
        (
            "A15, moved, doubles",
            doubles(&supercell(&entry("a15"), [6; 3])),
        ),
    ] {
        let naive = naive_time(&tiling).as_secs_f64();
        let model = Model::new(&tiling);
        let matching = match_facets(&tiling);
        let bound = model.prepare(AnglesAgainst {
            numerator: 1,
            denominator: 1 << 31,
        });
        let below = fastest(|| bound.failing(|signs| signs.all_positive()));
        let delaunay = fastest(|| check_delaunay(&model, &matching, true, &mut Findings::new(0)));
        println!(
            "  {name:38} one bound of angles {:5.2} x, local Delaunay {:5.2} x",
            below.as_secs_f64() / naive,
            delaunay.as_secs_f64() / naive
        );
    }
}

fn verifier() {
    println!("\nverifier");
    let a15 = supercell(&entry("a15"), [8; 3]);
    for (name, tiling) in [
        ("Q", a15.clone()),
        ("Q(sqrt 5)", bent(&a15, "sqrt(5)", "2236/1000")),
    ] {
        let certificate = prove(&tiling, &Options::default(), &|_| ()).expect("it is a tiling");
        let bytes = to_bytes(&certificate);
        let limits = Limits {
            simplices: usize::MAX,
            ..Limits::default()
        };
        let time = fastest(|| verify(&bytes, &limits).expect("it is right"));
        let rate = tiling.len() as f64 / time.as_secs_f64();
        println!("  {name:38} {rate:9.0} tetrahedra a second");
    }
}

/// Orientation, acuteness, matching and volume of A15 on all cores, in four sizes.
fn whole() {
    println!(
        "\nthe whole check of A15, {} threads",
        rayon::current_num_threads()
    );
    for n in [16u16, 20, 23, 25, 32, 40, 50] {
        let tiling = supercell(&entry("a15"), [n; 3]);
        let mut parts = [Duration::ZERO; 5];
        let start = Instant::now();
        let mut last = processor_time();
        let mut lap = |part: &mut Duration| {
            let now = processor_time();
            *part = now.saturating_sub(last);
            last = now;
        };
        let mut findings = Findings::new(1);
        let model = Model::new(&tiling);
        lap(&mut parts[0]);
        check_orientation(&model, &mut findings);
        lap(&mut parts[1]);
        check_acute(&model, &mut findings);
        lap(&mut parts[2]);
        assert!(match_facets(&tiling).mismatches.is_empty());
        lap(&mut parts[3]);
        check_volume(&model, &mut findings);
        lap(&mut parts[4]);
        assert!(findings.is_empty());
        let [model, orientation, acute, facets, volume] = parts.map(|part| part.as_secs_f64());
        let all: f64 = parts.iter().map(Duration::as_secs_f64).sum();
        let elapsed = start.elapsed().as_secs_f64();
        println!(
            "  n = {n:2}, {:7} tetrahedra: {elapsed:.3} s elapsed, {all:.3} s of processors, {:5.1} ns each (model {model:.3}, orientation \
             {orientation:.3}, acuteness {acute:.3}, facets {facets:.3}, volume {volume:.3}); peak {} MB",
            tiling.len(),
            all * 1e9 / tiling.len() as f64,
            peak_megabytes(),
        );
    }
}

/// The time that all threads of this process have spent on a processor.
fn processor_time() -> Duration {
    let tasks = std::fs::read_dir("/proc/self/task").expect("Linux");
    let nanoseconds = tasks.filter_map(|task| {
        let text = std::fs::read_to_string(task.ok()?.path().join("schedstat")).ok()?;
        text.split_whitespace().next()?.parse::<u64>().ok()
    });
    Duration::from_nanos(nanoseconds.sum())
}

/// The most memory that this process has had, from the kernel.
fn peak_megabytes() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    let kilobytes = line.and_then(|rest| rest.split_whitespace().next()?.parse::<u64>().ok());
    kilobytes.unwrap_or(0) / 1000
}

fn entry(name: &str) -> Tiling<3> {
    match acutile::catalog::find(name)
        .expect("it is in the catalogue")
        .build()
    {
        Ok(AnyTiling::Space(tiling)) => tiling,
        _ => unreachable!("{name} is a tiling of space"),
    }
}

/// The tiling with its vertices moved a little by multiples of `number - near`, so
/// that the coordinates are as long, or as irrational, as that number.
fn bent(tiling: &Tiling<3>, number: &str, near: &str) -> Tiling<3> {
    let mut reader = Reader::new();
    let text = format!("({number}-{near})/1000");
    reader.learn(&text).expect("a number");
    let step = reader.value(&text).expect("it was learnt");
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

/// The tiling with its vertices rounded to doubles and moved a little.
fn doubles(tiling: &Tiling<3>) -> Tiling<3> {
    let mut state = 1u64;
    let mut noise = || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1);
        (state >> 11) as f64 / 2f64.powi(53) - 0.5
    };
    let points = tiling
        .vertices
        .iter()
        .map(|vertex| vertex.map(|x| x.approximate() + 1e-4 * noise()));
    let mut moved = tiling.clone();
    moved.vertices = Coordinates::from_doubles(points.collect()).expect("they are finite");
    moved
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
            let mut points = [[0.0; 3]; 4];
            for (point, corner) in points.iter_mut().zip(corners) {
                let vertex = &vertices[corner.vertex as usize];
                for k in 0..3 {
                    point[k] = vertex[k] + f64::from(corner.shift[k]);
                }
            }
            let edges = [1, 2, 3].map(|k| linear::subtract(&points[k], &points[0]));
            let simplex = Simplex::from_edges(edges);
            acute += usize::from(simplex.determinant > 0.0 && naive_acute(&simplex, &cogram));
        }
        acute
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

/// The least elapsed time of many rounds, of which some are not disturbed.
fn fastest<T>(mut work: impl FnMut() -> T) -> Duration {
    let begin = Instant::now();
    let mut least = Duration::MAX;
    for round in 0..ROUNDS {
        if round > 0 && begin.elapsed() > LONGEST {
            break;
        }
        let start = Instant::now();
        black_box(work());
        least = least.min(start.elapsed());
    }
    least
}

/// The time on a processor of work that takes much longer than the kernel's tick.
fn on_processor<T>(mut work: impl FnMut() -> T) -> Duration {
    let round = |_| {
        let start = processor_time();
        black_box(work());
        processor_time().saturating_sub(start)
    };
    (0..5).map(round).min().unwrap_or_default()
}
