//! Mesh files: other programs' files against what these programs say of them, every format written
//! and read again. The files and their provenance are in tests/meshes/make.py.

use acutile_io::mesh::{Family, Format, Mesh, load, write};
use serde_json::Value;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

fn folder() -> PathBuf {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).join("tests/meshes")
}

fn read(path: &Path) -> Mesh {
    let family = Family::of_path(path).expect("a known extension");
    match load(path, family) {
        Ok(loaded) => loaded.mesh,
        Err(error) => panic!("{}: {error}", path.display()),
    }
}

/// A double as Python's `float.hex` writes it.
fn hex_double(text: &str) -> f64 {
    let (sign, rest) = match text.strip_prefix('-') {
        Some(rest) => (-1.0, rest),
        None => (1.0, text),
    };
    let (digits, exponent) = rest
        .strip_prefix("0x")
        .and_then(|r| r.split_once('p'))
        .expect("hex");
    let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
    let number = u64::from_str_radix(&format!("{whole}{fraction}"), 16).expect("digits");
    let exponent: i32 = exponent.parse().expect("an exponent");
    // The product of two powers of two is exact, and neither overflows here.
    sign * number as f64 * 2f64.powi(exponent - 4 * fraction.len() as i32)
}

/// Each tetrahedron by the bits of its corners' coordinates in order, and whether the order that
/// was given is an even permutation of it; sorted.
fn geometry(points: &[[f64; 3]], tetrahedra: &[[u32; 4]]) -> Vec<([[u64; 3]; 4], bool)> {
    let mut list: Vec<_> = tetrahedra
        .iter()
        .map(|corners| {
            let mut bits = corners.map(|c| points[c as usize].map(|x| (x + 0.0).to_bits()));
            let mut even = true;
            for i in 0..4 {
                for j in 0..i {
                    even ^= bits[i] < bits[j];
                }
            }
            bits.sort_unstable();
            (bits, even)
        })
        .collect();
    list.sort_unstable();
    list
}

#[test]
fn files_of_other_programs_are_read_as_they_read_them() {
    let text = std::fs::read_to_string(folder().join("oracle.json")).expect("the oracle");
    let oracle: BTreeMap<String, Value> = serde_json::from_str(&text).expect("JSON");
    assert!(oracle.len() > 25, "{} files", oracle.len());
    for (name, expected) in &oracle {
        let mesh = read(&folder().join(name));
        let points: Vec<[f64; 3]> =
            serde_json::from_value::<Vec<[String; 3]>>(expected["points"].clone())
                .expect("points")
                .iter()
                .map(|point| point.each_ref().map(|x| hex_double(x)))
                .collect();
        let tetrahedra: Vec<[u32; 4]> =
            serde_json::from_value(expected["tetrahedra"].clone()).expect("tetrahedra");
        assert_eq!(mesh.points.len(), points.len(), "{name}");
        assert_eq!(
            geometry(&mesh.points, &mesh.tetrahedra),
            geometry(&points, &tetrahedra),
            "{name}"
        );
        let names = [
            ("triangle", "triangles"),
            ("line", "lines"),
            ("vertex", "points"),
        ];
        for (theirs, ours) in names {
            let found = mesh.others.get(ours).copied().unwrap_or(0);
            let expected = expected["others"][theirs].as_u64().unwrap_or(0);
            assert_eq!(found as u64, expected, "{name}: {ours}");
        }
    }
}

#[test]
fn lines_and_numbers_are_those_of_the_file() {
    let path = folder().join("meshio-2.msh");
    let mesh = read(&path);
    let text = std::fs::read_to_string(&path).expect("text");
    let lines: Vec<&str> = text.lines().collect();
    let line_numbers = mesh.lines.as_ref().expect("text has lines");
    for (index, corners) in mesh.tetrahedra.iter().enumerate() {
        let line = lines[line_numbers.get(index) as usize - 1];
        let words: Vec<u64> = line
            .split_whitespace()
            .map(|w| w.parse().expect("a number"))
            .collect();
        assert_eq!((words[0], words[1]), (mesh.elements.get(index), 4));
        let nodes = corners.map(|corner| mesh.nodes.get(corner as usize));
        assert_eq!(words[words.len() - 4..], nodes);
    }
    assert_eq!(mesh.labels, [1, 1, 1, 2, 2, 2]);
}

/// The parts of a mesh that a format stores.
fn kept(mesh: &Mesh, format: Format) -> Mesh {
    let mut kept = mesh.clone();
    let consecutive = |first, length| acutile_io::mesh::Numbering::consecutive(first, length);
    let (nodes, elements) = (mesh.points.len(), mesh.tetrahedra.len());
    match format.family() {
        Family::Msh => {
            // Each cell has an entity, and numbers are positive.
            if kept.entities.is_empty() {
                kept.entities = if kept.labels.is_empty() {
                    vec![1; elements]
                } else {
                    kept.labels.clone()
                };
            }
            if mesh.nodes.get(0) == 0 {
                kept.nodes = consecutive(1, nodes);
            }
            if mesh.elements.get(0) == 0 {
                kept.elements = consecutive(1, elements);
            }
        }
        Family::TetGen | Family::Medit | Family::Meditb => {
            kept.periodic.clear();
            kept.labels = mesh.materials().to_vec();
            kept.entities.clear();
            if format.family() != Family::TetGen {
                kept.nodes = consecutive(1, nodes);
                kept.elements = consecutive(1, elements);
            }
        }
        _ => {
            kept.periodic.clear();
            kept.nodes = consecutive(0, nodes);
            kept.elements = consecutive(0, elements);
        }
    }
    kept.lines = None;
    kept.others.clear();
    kept.unread.clear();
    kept
}

fn written_and_read(mesh: &Mesh, format: Format, folder: &Path) -> Mesh {
    let files = write(mesh, format);
    if format == Format::TetGen {
        for file in &files {
            let name = format!("m.{}", file.extension.expect("two files"));
            std::fs::write(folder.join(name), &file.bytes).expect("written");
        }
        return load(&folder.join("m.ele"), Family::TetGen)
            .expect("read")
            .mesh;
    }
    let mesh = format.family().read(&files[0].bytes);
    mesh.unwrap_or_else(|error| panic!("{format:?}: {error}"))
}

#[test]
fn every_format_gives_back_what_it_holds_through_every_other() {
    let folder_ = tempfile::tempdir().expect("a folder");
    let mut mesh = read(&folder().join("gmsh-periodic-4.msh"));
    mesh.entities.clear();
    mesh.labels = (0..mesh.tetrahedra.len() as i64)
        .map(|k| 1 + k / 7)
        .collect();
    mesh.points[0] = [5e-324, -1.7976931348623157e308, 0.1];
    for (_, first) in acutile_io::mesh::format::NAMES {
        let once = written_and_read(&mesh, first, folder_.path());
        let expected = kept(&mesh, first);
        assert_eq!(
            Mesh {
                lines: None,
                ..once.clone()
            },
            expected,
            "{first:?}"
        );
        for (_, second) in acutile_io::mesh::format::NAMES {
            let twice = written_and_read(&once, second, folder_.path());
            let expected = kept(&once, second);
            assert_eq!(
                Mesh {
                    lines: None,
                    ..twice
                },
                expected,
                "{first:?} {second:?}"
            );
        }
    }
}

#[test]
fn messages_name_the_place_what_was_expected_and_what_was_found() {
    let head = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
    let nodes = "$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n";
    let cases = [
        (
            format!("{head}$Nodes\n2\n1 0 0 0\n$EndNodes\n"),
            "line 7: found \"$EndNodes\", expected a node number, an integer",
        ),
        (
            format!("{head}$Nodes\n99999999999\n1 0 0 0\n$EndNodes\n"),
            "line 5: found 99999999999 as the number of nodes, but the 19 bytes that are left contain at most 2",
        ),
        (
            format!("{head}$Nodes\n2\n1 0 0 0\n1 1 nan 0\n$EndNodes\n"),
            "line 7: found \"nan\", expected the coordinate y, a finite number",
        ),
        (
            format!("{head}$Nodes\n2\n1 0 0 0\n1 1 0 0\n$EndNodes\n"),
            "the node number 1 occurs twice: node 1 and node 2 of the file",
        ),
        (
            format!("{head}{nodes}$Elements\n1\n9 4 2 1 1 1 2 3 5\n$EndElements\n"),
            "line 13: found the node 5 in the element 9; the nodes of the file are 1 to 4",
        ),
        (
            format!("{head}{nodes}$Elements\n1\n9 3 2 1 1 1 2 3 4\n$EndElements\n"),
            "has no tetrahedra and no triangles, but 1 quadrangle; expected a mesh of either",
        ),
        (
            format!(
                "{head}{nodes}$Elements\n1\n9 29 2 1 1 {}\n$EndElements\n",
                "1 2 3 4 ".repeat(5)
            ),
            "has 1 third-order tetrahedron, expected tetrahedra with four nodes, or with ten from a format whose order of nodes is documented: facets of the former need not be plane",
        ),
        (
            format!("{head}{nodes}$Elements\n2\n9 4 2 1 1 1 2 3 4\n"),
            "line 14: the file ends, expected an element number",
        ),
        (
            "$MeshFormat\n3 0 8\n$EndMeshFormat\n".to_owned(),
            "line 2: found MSH version \"3\", expected 1, 2.0 to 2.2, 4.0 or 4.1 (Gmsh and meshio convert others)",
        ),
    ];
    for (text, expected) in cases {
        let error = Family::Msh.read(text.as_bytes()).expect_err(expected);
        assert_eq!(error.to_string(), expected);
    }
}
