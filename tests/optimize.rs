//! `acutile optimize`: goals, bad input, interrupts.

use crate::common::{acutile, acutile_verify, code, file, stderr, stdout};
use serde_json::{Value, json};
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Duration;

fn optimize(input: &Path, options: &[&str]) -> std::process::Output {
    let input = input.to_str().expect("UTF-8");
    acutile([&["optimize", input], options].concat())
}

/// Writes a tiling of the catalogue as a file, changed.
fn changed(directory: &Path, name: &str, change: impl Fn(&mut Value)) -> std::path::PathBuf {
    let text = stdout(&acutile(["export", name]));
    let mut tiling: Value = serde_json::from_str(&text).expect("JSON");
    change(&mut tiling);
    file(directory, "changed.json", &tiling.to_string())
}

#[test]
fn a_record_with_its_certificate() {
    let directory = tempfile::tempdir().expect("a directory");
    let path = directory.path().join("best.cbor");
    let path = path.to_str().expect("UTF-8");
    let run = acutile(["optimize", "c14", "-o", path, "--json"]);
    assert_eq!(code(&run), 0, "{}", stderr(&run));
    let data: Value = serde_json::from_str(&stdout(&run)).expect("JSON");
    assert_eq!(data["is_better"], true);
    assert_eq!(data["isometries"], 24);
    let verified = acutile_verify([path]);
    assert_eq!(code(&verified), 0);
    // The same search gives the same certificate.
    let again = acutile(["optimize", "c14", "--json"]);
    let again: Value = serde_json::from_str(&stdout(&again)).expect("JSON");
    assert_eq!(
        data["certificate"]["sha256"],
        again["certificate"]["sha256"]
    );
    assert_eq!(data["certificate"]["path"], path);
    // The bound is a requirement that the result fulfils.
    let certified = acutile(["certify", path, "--require", "dihedral-below=74.1478"]);
    assert_eq!(code(&certified), 0, "{}", stderr(&certified));
}

/// One seed gives the same bytes.
#[test]
fn a_seed_determines_the_certificate() {
    let directory = tempfile::tempdir().expect("a directory");
    let certificate = |name: &str| {
        let path = directory.path().join(name);
        let place = path.to_str().expect("UTF-8");
        let run = acutile([
            "optimize",
            "z",
            "--restarts",
            "3",
            "--seed",
            "7",
            "-o",
            place,
        ]);
        assert_eq!(code(&run), 0, "{}", stderr(&run));
        std::fs::read(path).expect("a certificate")
    };
    assert!(certificate("one.json") == certificate("two.json"));
}

/// C15 is a strict local optimum: nothing better, the start is written, and --prove-local proves it.
#[test]
fn no_progress_is_declined_and_written() {
    let directory = tempfile::tempdir().expect("a directory");
    let path = directory.path().join("best.json");
    let run = acutile(["optimize", "c15", "-o", path.to_str().expect("UTF-8")]);
    assert_eq!(code(&run), 3);
    assert!(stdout(&run).contains("no progress"), "{}", stdout(&run));
    assert!(path.exists());
    let run = acutile([
        "optimize",
        "c15",
        "--symmetry",
        "none",
        "--prove-local",
        "--json",
    ]);
    assert_eq!(code(&run), 0);
    let data: Value = serde_json::from_str(&stdout(&run)).expect("JSON");
    assert_eq!(data["local_optimum"]["rank"], 20);
    assert_eq!(
        data["local_optimum"]["tight"].as_array().map(Vec::len),
        Some(24)
    );
}

/// Four tetrahedra meet at an edge of bcc.
#[test]
fn an_edge_of_valence_four_is_the_reason() {
    let run = acutile(["optimize", "bcc", "--goal", "acute"]);
    assert_eq!(code(&run), 3);
    let said = stdout(&run);
    assert!(said.contains("can never be acute: edge 0 to 0+"), "{said}");
    assert!(said.contains("lies in 4 simplices only"), "{said}");
    let run = acutile(["optimize", "a15", "--goal", "acute"]);
    assert_eq!(code(&run), 0);
}

#[test]
fn a_vertex_off_its_face_is_named() {
    let directory = tempfile::tempdir().expect("a directory");
    let mut vertex = 0;
    for x in ["999/1000", "1001/1000"] {
        let path = changed(directory.path(), "cube-2715", |tiling| {
            let vertices = tiling["vertices"].as_array_mut().expect("vertices");
            let is_end = |x: &Value| ["0", "1"].contains(&x.as_str().unwrap_or("0"));
            let inside = |v: &Value| v[0] == "1" && !is_end(&v[1]) && !is_end(&v[2]);
            let place = vertices
                .iter()
                .position(inside)
                .expect("a vertex in the face x = 1");
            vertices[place][0] = json!(x);
        });
        let text = std::fs::read_to_string(&path).expect("a file");
        let tiling: Value = serde_json::from_str(&text).expect("JSON");
        let vertices = tiling["vertices"].as_array().expect("vertices");
        vertex = vertices.iter().position(|v| v[0] == x).unwrap_or(vertex);
        let expected = format!("vertex {vertex} is 1/1000 off the face x = 1");
        let run = optimize(&path, &[]);
        assert_eq!(code(&run), 1);
        assert!(stderr(&run).contains(&expected), "{}", stderr(&run));
        let run = acutile(["certify", path.to_str().expect("UTF-8")]);
        assert!(stdout(&run).contains(&expected), "{}", stdout(&run));
    }
}

#[test]
fn a_flat_or_inverted_start_is_refused() {
    let directory = tempfile::tempdir().expect("a directory");
    let path = changed(directory.path(), "a15", |tiling| {
        tiling["simplices"][0]
            .as_array_mut()
            .expect("corners")
            .swap(0, 1);
    });
    let run = optimize(&path, &[]);
    assert_eq!(code(&run), 1);
    assert!(
        stderr(&run).contains("negatively oriented"),
        "{}",
        stderr(&run)
    );
    assert_eq!(
        code(&optimize(&path, &["--reorient", "--goal", "acute"])),
        0
    );
    let flat = json!({
        "format": "acutile-tiling", "version": 1, "dimension": 3,
        "domain": { "region": 0 },
        "vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]],
        "simplices": [[0, 1, 2, 3]],
    });
    let path = file(directory.path(), "flat.json", &flat.to_string());
    let run = optimize(&path, &[]);
    assert_eq!(code(&run), 1);
    let said = stderr(&run);
    assert!(
        said.contains("flat.json") && said.contains("determinant is 0"),
        "{said}"
    );
    let run = acutile(["optimize", "equilateral"]);
    assert_eq!(code(&run), 2);
    assert!(stderr(&run).contains("expected one of space"));
    let run = acutile(["optimize", "a15", "--symmetry", "99"]);
    assert_eq!(code(&run), 2);
    assert!(stderr(&run).contains("--symmetry list"), "{}", stderr(&run));
}

#[test]
fn a_start_that_is_no_mesh_has_the_numbers_of_its_file() {
    let directory = tempfile::tempdir().expect("a directory");
    // The second element is inverted.
    let text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n\
                $Nodes\n5\n11 0 0 0\n12 1 0 0\n13 0 1 0\n14 0 0 1\n15 1 1 1\n$EndNodes\n\
                $Elements\n2\n6 4 2 1 1 11 12 13 14\n7 4 2 1 1 12 13 14 15\n$EndElements\n";
    let text = text.replace("12 13 14 15", "12 14 13 15");
    let path = file(directory.path(), "turned.msh", &text);
    let run = optimize(&path, &[]);
    assert_eq!(code(&run), 1);
    let said = stderr(&run);
    assert!(said.contains("element 7"), "{said}");
    assert!(!said.contains("simplex 1"), "{said}");
}

/// A15 in a bounded mesh with its inner nodes shaken: 99 degrees and more before, acute afterwards.
#[test]
fn a_mesh_becomes_acute() {
    let directory = tempfile::tempdir().expect("a directory");
    let path = directory.path().join("a15.mesh");
    let name = path.to_str().expect("UTF-8");
    let run = acutile(["convert", "a15", name, "--supercell", "4,4,4"]);
    assert_eq!(code(&run), 0, "{}", stderr(&run));
    shake(&path);
    let before = acutile(["certify", name, "--require", "acute"]);
    assert_eq!(code(&before), 1);
    let run = acutile(["optimize", name, "--goal", "acute", "--json"]);
    assert_eq!(code(&run), 0, "{}{}", stdout(&run), stderr(&run));
    let data: Value = serde_json::from_str(&stdout(&run)).expect("JSON");
    assert_eq!(data["acute"], true);
}

/// Moves each node that is in no boundary triangle by up to a quarter.
fn shake(path: &Path) {
    let text = std::fs::read_to_string(path).expect("a mesh");
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    let section = |lines: &[String], name: &str| {
        let head = lines.iter().position(|l| l.trim() == name).expect(name);
        let count: usize = lines[head + 1].trim().parse().expect("a count");
        head + 2..head + 2 + count
    };
    let mut uses = std::collections::BTreeMap::new();
    for line in &lines[section(&lines, "Tetrahedra")] {
        let corners: Vec<usize> = line
            .split_whitespace()
            .take(4)
            .map(|w| w.parse().expect("a node"))
            .collect();
        for k in 0..4 {
            let mut facet = corners.clone();
            facet.remove(k);
            facet.sort_unstable();
            *uses.entry(facet).or_insert(0) += 1;
        }
    }
    let boundary: Vec<usize> = uses
        .into_iter()
        .filter(|(_, n)| *n == 1)
        .flat_map(|(f, _)| f)
        .collect();
    let vertices = section(&lines, "Vertices");
    for (number, place) in vertices.enumerate() {
        if boundary.contains(&(number + 1)) {
            continue;
        }
        let words: Vec<&str> = lines[place].split_whitespace().collect();
        let moved = (0..3).map(|k| {
            let x: f64 = words[k].parse().expect("a number");
            // Multiples of 1/64 from -16/64 to 16/64, without a pattern.
            let noise = (number * 7919 + k * 104_729) * 31 % 33;
            (x + noise as f64 / 64.0 - 0.25).to_string()
        });
        lines[place] = moved.chain(["0".to_owned()]).collect::<Vec<_>>().join(" ");
    }
    std::fs::write(path, lines.join("\n")).expect("a mesh");
}

/// The first signal ends the search, and the best so far is written.
#[cfg(target_os = "linux")]
#[test]
fn an_interrupt_keeps_the_best() {
    let directory = tempfile::tempdir().expect("a directory");
    let path = directory.path().join("best.cbor");
    let mut child = Command::new("env")
        .args(["--default-signal", env!("CARGO_BIN_EXE_acutile")])
        .args([
            "optimize",
            "tetrahedron-543",
            "--symmetry",
            "none",
            "--restarts",
            "100000",
            "-o",
        ])
        .arg(&path)
        .stdout(Stdio::piped())
        .spawn()
        .expect("env runs");
    std::thread::sleep(Duration::from_secs(5));
    assert_eq!(
        child.try_wait().expect("a child"),
        None,
        "ended before the signal"
    );
    let sent = Command::new("kill")
        .args(["-s", "INT", &child.id().to_string()])
        .status();
    assert!(sent.expect("kill runs").success());
    let output = child.wait_with_output().expect("a child");
    assert!(
        [Some(0), Some(3)].contains(&output.status.code()),
        "{output:?}"
    );
    assert!(stdout(&output).contains("interrupted; this is the best so far"));
    assert_eq!(code(&acutile_verify([&path])), 0);
}

/// All candidates are accounted for, and finding none is declined, not refuted.
#[test]
fn a_search_says_what_it_tried() {
    let run = acutile(["search", "slab", "--tries", "20", "--json"]);
    let data: Value = serde_json::from_str(&stdout(&run)).expect("JSON");
    let count = |name: &str| data[name].as_u64().expect("a count");
    let parts = ["cospherical", "no_slab", "never_acute", "optimized"];
    assert_eq!(count("candidates"), 20);
    assert_eq!(parts.map(count).iter().sum::<u64>(), 20);
    let expected = if count("acute") > 0 { 0 } else { 3 };
    assert_eq!(code(&run), expected);
    let run = acutile(["search", "balls", "--size", "1", "--faces", "4"]);
    assert_eq!(code(&run), 3);
    // 20 of the 600 tetrahedra have a given vertex, and 130 have a vertex of its closed star.
    assert!(stdout(&run).contains("580 tetrahedra without 1 vertex [0] (1 such set)"));
    assert!(stdout(&run).contains("470 tetrahedra without 13 vertices"));
    let other = "0 optimized, 0 of these acute, 2 with another number of faces than was asked for, 0 not tried";
    assert!(stdout(&run).contains(other), "{}", stdout(&run));
    assert!(stdout(&run).contains("nothing was tried; the numbers of faces that occur are 1, 12"));
    let run = acutile(["search", "balls", "--seconds", "0"]);
    assert_eq!(code(&run), 3);
    assert!(stdout(&run).contains("the search ended before it was complete"));
    assert!(stdout(&run).contains("0 with another number of faces"));
    assert_eq!(code(&acutile(["search", "slab", "--over", "pentagons"])), 2);
}

/// Other tilings of the plane by squares and triangles: by name, and from a file.
#[test]
fn slabs_over_other_plane_tilings() {
    let directory = tempfile::tempdir().expect("a directory");
    let text = r#"{"format": "acutile-plane-tiling", "version": 1,
        "lattice": [[1, 0, 0, 0], [0, 0, 0, 1]], "vertices": [[0, 0, 0, 0]]}"#;
    let path = file(directory.path(), "squares.json", text);
    for over in ["32434", "33344", path.to_str().expect("UTF-8")] {
        let run = acutile(["search", "slab", "--over", over, "--tries", "3", "--json"]);
        let data: Value = serde_json::from_str(&stdout(&run)).expect("JSON");
        assert_eq!(
            (&data["candidates"], &data["over"]),
            (&json!(3), &json!(over))
        );
    }
    let missing = directory.path().join("none.json");
    let missing = missing.to_str().expect("UTF-8");
    assert_eq!(code(&acutile(["search", "slab", "--over", missing])), 2);
}

/// Without a vertex no edges of the polyhedron remain, and without its star those of a dodecahedron. So there is no cube.
#[test]
fn a_polyhedron_to_aim_at() {
    let run = acutile(["search", "balls", "--size", "1", "--shape", "cube"]);
    assert_eq!(code(&run), 3, "{}", stderr(&run));
    assert!(
        stdout(&run).contains("0 optimized, 0 of these acute"),
        "{}",
        stdout(&run)
    );
    let directory = tempfile::tempdir().expect("a directory");
    let cases = [
        ("0 0 0\n1 0\n", "line 2: found 2 numbers"),
        ("# a triangle\n0 0 0\n1 0 0\n0 1 0\n", "found 3 points"),
        ("0 0 0\n1 0 0\n0 1 0\n1 1 0\n", "lie in one plane"),
        (
            "0 0 0\n2 0 0\n0 2 0\n0 0 2\n1 0 0\n",
            "point 5 is no corner",
        ),
        ("0 0 0\n2 0 0\n0 2 0\n0 0 y\n", "y"),
        ("", "found 0 points"),
    ];
    for (text, expected) in cases {
        let path = file(directory.path(), "corners.txt", text);
        let run = acutile(["search", "balls", "--shape", path.to_str().expect("UTF-8")]);
        assert_eq!(code(&run), 2, "{text}");
        assert!(stderr(&run).contains(expected), "{}", stderr(&run));
    }
    for word in ["blob", "prism:7", "prism:3,0", "prism:3,-", "prism:"] {
        assert_eq!(
            code(&acutile(["search", "balls", "--shape", word])),
            2,
            "{word}"
        );
    }
}
