//! The files that `acutile new` writes: accepted as they are, and answered sensibly with one fault, or with
//! a thousand random changes.

use crate::common::{acutile, code, file, stderr, stdout};
use acutile_core::checker::Options;
use acutile_core::delaunay::{Ties, triangulate};
use acutile_core::proved::{NotProved, prove};
use acutile_core::tiling::{AnyPointSet, AnyTiling, PointSet, Tiling};
use acutile_core::with_dimension;
use acutile_io::import::cif::{CifOptions, read_cif};
use acutile_io::import::{Content, read_native, without_comments};
use serde_json::{Value, json};
use std::time::{Duration, Instant};

/// The kinds whose files hold a tiling, and one that holds points.
const TILINGS: [&str; 6] = ["tiling", "plane", "slab", "prism", "solid", "square-root"];

fn example(kind: &str) -> String {
    let output = acutile(["new", kind]);
    assert_eq!(code(&output), 0, "{kind}: {}", stderr(&output));
    stdout(&output)
}

/// The Kuhn cube has 6 tetrahedra, the cube cut at its corners 5, A15 46, Z 40. The plane has 2 triangles.
/// The tiling of space over the rows of 3^3.4^2 has 86: one cell of A15 (46 for a square) and one of Z (40
/// for two triangles).
#[test]
fn every_kind_is_certified_as_it_is() {
    let place = tempfile::tempdir().expect("a directory");
    for (kind, arguments, simplices) in [
        ("tiling", &["--require", "delaunay"][..], None),
        ("tiling", &["--require", "nonobtuse"], Some("6 tetrahedra")),
        ("plane", &["--require", "acute"], Some("2 triangles")),
        ("slab", &["--require", "nonobtuse"], Some("6 tetrahedra")),
        ("prism", &["--require", "nonobtuse"], Some("6 tetrahedra")),
        ("solid", &["--require", "nonobtuse"], Some("5 tetrahedra")),
        ("region", &[], Some("3 tetrahedra")),
        (
            "point-set",
            &["--require", "acute", "--require", "tcp"],
            Some("46 tetrahedra"),
        ),
        ("square-root", &["--require", "acute"], Some("2 triangles")),
        (
            "square-triangle",
            &["--require", "acute"],
            Some("86 tetrahedra"),
        ),
        (
            "cif",
            &["--snap", "3", "--require", "acute"],
            Some("40 tetrahedra"),
        ),
    ] {
        let path = place.path().join(match kind {
            "cif" => "example.cif".to_owned(),
            _ => format!("{kind}.json"),
        });
        let path = path.to_str().expect("UTF-8");
        if !std::path::Path::new(path).exists() {
            assert_eq!(code(&acutile(["new", kind, "-o", path])), 0);
        }
        let input = match kind {
            "square-triangle" => format!("square-triangle:{path}"),
            _ => path.to_owned(),
        };
        let output = acutile([&["certify", input.as_str()], arguments].concat());
        match simplices {
            Some(count) => {
                assert_eq!(code(&output), 0, "{kind}: {}", stderr(&output));
                assert!(
                    stdout(&output).contains(count),
                    "{kind}: {}",
                    stdout(&output)
                );
            }
            // The corners of a cube are cospherical.
            None => assert_eq!(code(&output), 1, "{kind}"),
        }
        // An example that nobody has edited can be made again; another file stays.
        let written = std::fs::read(path).expect("written");
        assert_eq!(code(&acutile(["new", kind, "-o", path])), 0);
        let edited = [written.as_slice(), b"\n"].concat();
        std::fs::write(path, &edited).expect("edited");
        let again = acutile(["new", kind, "-o", path]);
        assert_eq!(code(&again), 2);
        let words = "the file exists and is not as acutile wrote it; --force replaces it";
        assert!(stderr(&again).contains(words), "{}", stderr(&again));
        assert_eq!(std::fs::read(path).expect("a file"), edited);
        assert_eq!(code(&acutile(["new", kind, "-o", path, "--force"])), 0);
        assert_eq!(std::fs::read(path).expect("a file"), written);
    }
    assert_eq!(code(&acutile(["new", "no-such-kind"])), 2);
}

/// A comment is a line of its own; elsewhere `//` stays an error of JSON. Lines keep their numbers.
#[test]
fn comments() {
    let place = tempfile::tempdir().expect("a directory");
    let path = file(
        place.path(),
        "t.json",
        &example("plane").replace("\"vertices\"", "\"vertizes\""),
    );
    let wrong = acutile(["certify", path.to_str().expect("UTF-8")]);
    let line = example("plane")
        .lines()
        .position(|line| line.contains("\"vertices\""))
        .expect("a line")
        + 1;
    assert!(
        stderr(&wrong).contains(&format!("t.json:{line}:")),
        "{}",
        stderr(&wrong)
    );
    let trailing = example("plane").replace("\"version\": 1,", "\"version\": 1, // one");
    assert!(read_native(&trailing).is_err());
    let inside = example("plane").replace("equilateral triangles\"", "a // b\"");
    assert_eq!(
        read_native(&inside).expect("a tiling").name.as_deref(),
        Some("a // b")
    );
}

/// The number of statements that the kernel confirms of a file, or nothing.
fn judge(text: &str, is_cif: bool) -> Option<usize> {
    let content = if is_cif {
        let options = CifOptions {
            snap: Some(3),
            ..CifOptions::default()
        };
        Content::Points(AnyPointSet::Space(read_cif(text, &options).ok()?.points))
    } else {
        read_native(text).ok()?.content
    };
    let tiling = match content {
        Content::Tiling(tiling) => tiling,
        Content::Family(_) => return None,
        Content::Points(AnyPointSet::Plane(points)) => AnyTiling::Plane(delaunay(&points)?),
        Content::Points(AnyPointSet::Space(points)) => AnyTiling::Space(delaunay(&points)?),
    };
    with_dimension!(&tiling, AnyTiling, t => statements(t))
}

fn delaunay<const D: usize>(points: &PointSet<D>) -> Option<Tiling<D>> {
    triangulate(points, Ties::Refuse).ok()
}

/// The kernel confirms every proof of the prover.
fn statements<const D: usize>(tiling: &Tiling<D>) -> Option<usize> {
    match prove(tiling, &Options::default(), &|_| ()) {
        Ok(proved) => Some(proved.statements().len()),
        Err(NotProved::Refuted(_) | NotProved::Declined(_)) => None,
        Err(error) => panic!("the kernel does not confirm: {error}"),
    }
}

/// Every corner is moved by a lattice vector, or replaced by another vertex where there is no lattice.
/// Every simplex is left out, doubled, or turned over. Each change is refuted.
#[test]
fn planted_defects_in_tilings_are_refuted() {
    for kind in TILINGS {
        let whole: Value = serde_json::from_str(&without_comments(&example(kind))).expect("JSON");
        assert!(judge(&whole.to_string(), false).is_some(), "{kind}");
        let simplices = whole["simplices"].as_array().expect("an array").clone();
        let mut planted = 0;
        let mut refuted = |changed: Vec<Value>| {
            let mut document = whole.clone();
            document["simplices"] = Value::Array(changed);
            assert_eq!(
                judge(&document.to_string(), false),
                None,
                "{kind}: {document}"
            );
            planted += 1;
        };
        for (s, simplex) in simplices.iter().enumerate() {
            let with = |simplex: Value| {
                let mut changed = simplices.clone();
                changed[s] = simplex;
                changed
            };
            refuted([&simplices[..s], &simplices[s + 1..]].concat());
            refuted([&simplices[..], &simplices[s..=s]].concat());
            let corners = simplex.as_array().expect("corners");
            let turned = [&[corners[1].clone(), corners[0].clone()], &corners[2..]].concat();
            refuted(with(Value::Array(turned)));
            for i in 0..corners.len() {
                let mut moved = corners.clone();
                moved[i] = other_corner(&corners[i], kind);
                refuted(with(Value::Array(moved)));
            }
        }
        assert!(planted >= 2 * 6, "{kind}");
    }
}

fn other_corner(corner: &Value, kind: &str) -> Value {
    let rank = match kind {
        "tiling" => 3,
        "plane" | "square-root" | "slab" => 2,
        "prism" => 1,
        _ => return json!((corner.as_u64().expect("a vertex") + 1) % 8),
    };
    let mut entries = match corner {
        Value::Array(entries) => entries.clone(),
        vertex => std::iter::once(vertex.clone())
            .chain((0..rank).map(|_| json!(0)))
            .collect(),
    };
    entries[1] = json!(entries[1].as_i64().expect("a shift") + 1);
    Value::Array(entries)
}

#[test]
fn a_point_twice_is_refused() {
    let doubled = example("point-set").replace("[0.5, 0.25, 0]", "[0.5, 0.25, 0], [-0.5, 3.25, 1]");
    assert_eq!(judge(&doubled, false), None);
    assert!(judge(&example("point-set"), false).is_some());
}

/// The triangulation of a periodic point set fills space, so a slab of it means nothing.
#[test]
fn a_point_set_with_a_boundary_is_refused() {
    let slab = example("point-set").replace(
        "\"dimension\"",
        "\"domain\": { \"slab\": [0, 1] }, \"dimension\"",
    );
    let message = read_native(&slab).err().expect("it is refused").to_string();
    assert_eq!(
        message,
        "domain: a point set has no domain but \"space\", its Delaunay triangulation fills it"
    );
}

/// A linear congruential generator (Knuth, MMIX): the same changes in every run.
struct Random(u64);

impl Random {
    fn below(&mut self, n: usize) -> usize {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) as usize) % n.max(1)
    }
}

/// One to three changes: a byte, a line, or the rest.
fn mutated(text: &str, random: &mut Random) -> String {
    const BYTES: &[u8] = b"0123456789.-+e/\"'[]{}(),:;_#?xyz \n";
    let mut bytes = text.as_bytes().to_vec();
    for _ in 0..1 + random.below(3) {
        let at = random.below(bytes.len());
        let byte = BYTES[random.below(BYTES.len())];
        match random.below(7) {
            0 | 1 => bytes[at] = byte,
            2 => drop(bytes.remove(at)),
            3 => bytes.insert(at, byte),
            4 | 5 => {
                let mut lines: Vec<Vec<u8>> =
                    bytes.split(|&b| b == b'\n').map(<[u8]>::to_vec).collect();
                let (from, to) = (random.below(lines.len()), random.below(lines.len()));
                let line = lines.remove(from);
                if random.below(2) == 0 {
                    lines.insert(to.min(lines.len()), line);
                }
                bytes = lines.join(&b'\n');
            }
            _ => bytes.truncate(at.max(1)),
        }
        if bytes.is_empty() {
            bytes.push(b' ');
        }
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

/// A thousand of each kind: nothing panics, nothing takes ten seconds, and whatever is proved is
/// confirmed by the kernel. Comments are left out first, or most changes would be there.
#[test]
fn a_thousand_changes_of_each_kind() {
    for kind in TILINGS.into_iter().chain(["point-set", "cif"]) {
        let is_cif = kind == "cif";
        let whole = if is_cif {
            example(kind)
                .lines()
                .filter(|line| !line.starts_with('#'))
                .map(|line| format!("{line}\n"))
                .collect()
        } else {
            without_comments(&example(kind)).into_owned()
        };
        let mut random = Random(kind.len() as u64);
        let (mut proved, mut refused) = (0, 0);
        for _ in 0..1000 {
            let text = mutated(&whole, &mut random);
            let start = Instant::now();
            match judge(&text, is_cif) {
                Some(_) => proved += 1,
                None => refused += 1,
            }
            assert!(start.elapsed() < Duration::from_secs(10), "{kind}: {text}");
        }
        // White space and names may change without harm, numbers seldom.
        assert!(
            proved > 10 && refused > 300,
            "{kind}: {proved} proved, {refused} refused"
        );
    }
}
