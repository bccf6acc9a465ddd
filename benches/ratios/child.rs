//! Starts this program again with one piece of work. The peak memory of a process never falls, and
//! callgrind counts a whole process.
//!
//! The work is named in an environment variable, `size times kind`, a tab and the file; the child prints one line.

use crate::clock::{once, peak_megabytes};
use crate::data::{FIELDS, a15, a15_points, bent, doubles, skewed_points};
use crate::predicates::is_right;
use crate::{parts, reading, verifier};
use acutile_core::checker::Model;
use acutile_core::delaunay::{Ties, triangulate};
use acutile_core::predicates::Shape;
use acutile_core::tiling::{PointSet, Tiling, match_facets};
use acutile_io::mesh::{Family, load::load};
use std::path::Path;
use std::process::Command;
use std::time::Duration;

const VARIABLE: &str = "ACUTILE_BENCH_CHILD";

/// A kind of work and its size; for reading and verifying, the file.
#[derive(Clone)]
pub struct Work {
    kind: String,
    size: u16,
    times: u32,
    file: String,
}

impl Work {
    /// Work that needs no file.
    pub fn new(kind: &str, size: u16) -> Self {
        Work::with_file(kind, size, Path::new("-"))
    }

    /// Work on a file.
    pub fn with_file(kind: &str, size: u16, file: &Path) -> Self {
        Work {
            kind: kind.to_owned(),
            size,
            times: 1,
            file: file.display().to_string(),
        }
    }

    /// The number of repetitions of the same work.
    pub fn times(self, times: u32) -> Self {
        Work { times, ..self }
    }

    /// A command that does it; `before`, such as valgrind, precedes it.
    pub fn command(&self, before: &[&str]) -> Command {
        let program = std::env::current_exe().expect("this program has a path");
        let mut words = before.iter().map(|word| (*word).into());
        let mut command = match words.next() {
            Some(first) => {
                let first: std::ffi::OsString = first;
                let mut command = Command::new(first);
                command.args(words).arg(program);
                command
            }
            None => Command::new(program),
        };
        let Work {
            kind,
            size,
            times,
            file,
        } = self;
        let text = format!("{size} {times} {kind}\t{file}");
        command.env(VARIABLE, text);
        command
    }
}

/// The measurements of a child.
pub struct Found {
    /// Tetrahedra.
    pub count: usize,
    /// Processor time of the work, without what was made before.
    pub seconds: f64,
    /// Elapsed time of the same.
    pub elapsed: f64,
    /// The most memory that the process had.
    pub megabytes: f64,
    /// Further figures, in words.
    pub remark: String,
}

/// Starts a child and waits for it.
pub fn start(work: &Work) -> Found {
    let output = work.command(&[]).output().expect("the child starts");
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let words: Vec<&str> = text.trim_end_matches('\n').splitn(5, '\t').collect();
    let [count, seconds, elapsed, megabytes, remark] = words[..] else {
        let error = String::from_utf8_lossy(&output.stderr).into_owned();
        panic!("{} {}: {text}{error}", work.kind, work.size);
    };
    let number = |word: &str| word.parse::<f64>().expect("a number");
    Found {
        count: number(count) as usize,
        seconds: number(seconds),
        elapsed: number(elapsed),
        megabytes: number(megabytes),
        remark: remark.to_owned(),
    }
}

/// The work of this process, if it is a child.
pub fn asked_for() -> Option<Work> {
    let text = std::env::var(VARIABLE).ok()?;
    let (rest, file) = text.split_once('\t')?;
    let mut words = rest.splitn(3, ' ');
    Some(Work {
        size: words.next()?.parse().ok()?,
        times: words.next()?.parse().ok()?,
        kind: words.next()?.to_owned(),
        file: file.to_owned(),
    })
}

/// Does the work and prints the line.
pub fn run(work: &Work) {
    let threads = if work.kind == "whole" { 0 } else { 1 };
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    let (count, elapsed, seconds, remark) = pool.expect("a pool").install(|| done(work));
    println!(
        "{count}\t{}\t{}\t{}\t{remark}",
        seconds.as_secs_f64(),
        elapsed.as_secs_f64(),
        peak_megabytes()
    );
}

type Done = (usize, Duration, Duration, String);

fn done(work: &Work) -> Done {
    let (n, times) = (work.size, work.times);
    match work.kind.as_str() {
        "whole" => parts::check(n, times),
        "filter" => filter(&doubles(&a15(n), 1e-4, None), times),
        "exact" => exact(&bent(&a15(n), "1/1048583"), times),
        "quadratic" => exact(&bent(&a15(n), FIELDS[0].1), times),
        "matching" => {
            let tiling = a15(n);
            timed(times, || {
                assert!(match_facets(&tiling).mismatches.is_empty());
                tiling.len()
            })
        }
        "delaunay" => triangulated(&a15_points(n), times),
        "delaunay-skewed" => triangulated(&skewed_points(n), times),
        "reading" => timed(times, || read(&work.file)),
        "verifier" => {
            let bytes = std::fs::read(&work.file).expect("the certificate is there");
            timed(times, || verifier::check(&bytes))
        }
        other => panic!("no work {other}"),
    }
}

fn timed(times: u32, work: impl Fn() -> usize) -> Done {
    let start = std::time::Instant::now();
    let (seconds, count) = once(|| {
        let counts = (0..times).map(|_| std::hint::black_box(work()));
        counts.last().unwrap_or(0)
    });
    (count, start.elapsed(), seconds, String::new())
}

fn filter(tiling: &Tiling<3>, times: u32) -> Done {
    let model = Model::new(tiling);
    timed(times, || {
        assert!(model.prepare(Shape).failing(is_right).is_empty());
        tiling.len()
    })
}

fn exact(tiling: &Tiling<3>, times: u32) -> Done {
    let model = Model::new(tiling);
    let shape = model.prepare(Shape);
    timed(times, || {
        for corners in tiling.simplices() {
            assert!(is_right(&shape.exact_signs(corners, &corners[0])));
        }
        tiling.len()
    })
}

fn triangulated(set: &PointSet<3>, times: u32) -> Done {
    timed(times, || {
        let tiling = triangulate(set, Ties::Refuse);
        tiling.expect("it has one triangulation").len()
    })
}

fn read(file: &str) -> usize {
    let loaded = load(Path::new(file), Family::Msh).expect("it is a mesh");
    loaded.mesh.tetrahedra.len()
}

/// Writes the file that a kind of work needs, and gives the work.
pub fn prepared(kind: &str, size: u16, folder: &Path) -> Work {
    let file = folder.join(format!("{kind}-{size}"));
    let (kind, bytes) = match kind {
        "reading" => {
            let file =
                acutile_io::mesh::write(&reading::mesh(size), acutile_io::mesh::Format::Msh4);
            (kind, file.into_iter().next().map(|file| file.bytes))
        }
        "verifier, Q" => ("verifier", Some(verifier::certificate(&a15(size)))),
        "verifier, Q(sqrt 5)" => {
            let tiling = bent(&a15(size), FIELDS[0].1);
            ("verifier", Some(verifier::certificate(&tiling)))
        }
        _ => (kind, None),
    };
    match bytes {
        Some(bytes) => {
            std::fs::write(&file, bytes).expect("the directory can be written");
            Work::with_file(kind, size, &file)
        }
        None => Work::new(kind, size),
    }
}
