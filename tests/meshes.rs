//! Mesh files: other programs' files against what these programs say of them, every format written
//! and read again, periodic meshes proved, damaged ones not. The files and their provenance
//! are in tests/meshes/make.py.

use acutile_io::mesh::{Family, Format, Lattice, Mesh, load, write};
use serde_json::Value;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/meshes")
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

/// What a format holds of a mesh.
fn kept(mesh: &Mesh, format: Format) -> Mesh {
    let mut kept = mesh.clone();
    let consecutive = |first, length| acutile_io::mesh::Numbering::consecutive(first, length);
    let (nodes, elements) = (mesh.points.len(), mesh.tetrahedra.len());
    match format.family() {
        Family::Msh => {}
        Family::TetGen => kept.periodic.clear(),
        Family::Medit | Family::Meditb => {
            kept.periodic.clear();
            kept.nodes = consecutive(1, nodes);
            kept.elements = consecutive(1, elements);
        }
        Family::Vtk | Family::Vtu => {
            kept.periodic.clear();
            kept.labels.clear();
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
    let mut mesh = mesh.unwrap_or_else(|error| panic!("{format:?}: {error}"));
    // The writer lists entities for Gmsh; the reader has no use for them.
    mesh.unread.retain(|part| part != "section $Entities");
    mesh
}

#[test]
fn every_format_gives_back_what_it_holds_through_every_other() {
    let folder_ = tempfile::tempdir().expect("a folder");
    let mut mesh = read(&folder().join("gmsh-periodic-4.msh"));
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
            let mut expected = kept(&once, second);
            if expected.labels.is_empty() && second.family() == Family::Msh {
                // Gmsh numbers entities from 1.
                expected.labels = vec![1; mesh.tetrahedra.len()];
            }
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

fn acutile(arguments: &[&str]) -> Output {
    let program = env!("CARGO_BIN_EXE_acutile");
    Command::new(program)
        .args(arguments)
        .output()
        .expect("the program runs")
}

fn exit_code(output: &Output) -> i32 {
    output.status.code().expect("no signal")
}

fn stderr(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

const UNIT: &str = "1,0,0;0,1,0;0,0,1";

/// The cube of side 1 in six tetrahedra is a cell of a tiling of space, and of a slab.
fn cube() -> Mesh {
    let points: Vec<[f64; 3]> = (0..8)
        .map(|k| [f64::from(k & 1), f64::from(k >> 1 & 1), f64::from(k >> 2)])
        .collect();
    let tetrahedra = vec![
        [0, 1, 3, 7],
        [0, 1, 7, 5],
        [0, 2, 7, 3],
        [0, 2, 6, 7],
        [0, 4, 5, 7],
        [0, 4, 7, 6],
    ];
    Mesh {
        nodes: acutile_io::mesh::Numbering::consecutive(1, points.len()),
        elements: acutile_io::mesh::Numbering::consecutive(1, tetrahedra.len()),
        points,
        tetrahedra,
        ..Mesh::default()
    }
}

fn file(folder: &Path, name: &str, mesh: &Mesh) -> String {
    let path = folder.join(name);
    let format = Family::of_path(&path).expect("a format").format();
    for part in write(mesh, format) {
        let path = match part.extension {
            Some(extension) => path.with_extension(extension),
            None => path.clone(),
        };
        std::fs::write(path, part.bytes).expect("written");
    }
    path.to_string_lossy().into_owned()
}

type Damage = fn(&mut Mesh);

#[test]
fn a_periodic_mesh_is_proved_in_every_format_and_not_when_it_is_damaged() {
    let folder = tempfile::tempdir().expect("a folder");
    let damages: [(&str, Damage); 6] = [
        ("one is missing", |mesh| mesh.tetrahedra.truncate(5)),
        ("one is there twice", |mesh| {
            mesh.tetrahedra.push(mesh.tetrahedra[0])
        }),
        ("one is turned", |mesh| mesh.tetrahedra[2].swap(0, 1)),
        ("one repeats a corner", |mesh| {
            mesh.tetrahedra[2][0] = mesh.tetrahedra[2][1]
        }),
        ("a vertex is moved", |mesh| mesh.points[7][0] = 0.9),
        ("a vertex is moved the least", |mesh| {
            mesh.points[7][2] = 1.0 + f64::EPSILON
        }),
    ];
    for name in ["c.msh", "c.vtk", "c.vtu", "c.mesh", "c.meshb", "c.ele"] {
        let path = file(folder.path(), name, &cube());
        for lattice in [
            UNIT,
            "1,0,0;0,1,0",
            "0,1,0;1,0,0;0,0,1",
            "-1,0,0;1,1,0;0,0,1",
        ] {
            let output = acutile(&["certify", &path, "--lattice", lattice]);
            assert_eq!(
                exit_code(&output),
                0,
                "{name} {lattice}: {}",
                stderr(&output)
            );
        }
        let output = acutile(&["certify", &path, "--lattice", "2,0,0;0,1,0;0,0,1"]);
        assert_eq!(exit_code(&output), 1, "{name}");
        for (damage, apply) in damages {
            let mut mesh = cube();
            apply(&mut mesh);
            mesh.elements = acutile_io::mesh::Numbering::consecutive(1, mesh.tetrahedra.len());
            let path = file(folder.path(), name, &mesh);
            let output = acutile(&["certify", &path, "--lattice", UNIT]);
            assert_eq!(
                exit_code(&output),
                1,
                "{name}: {damage}: {}",
                stderr(&output)
            );
        }
    }
}

#[test]
fn periodic_links_give_the_lattice() {
    for name in ["2", "2-binary", "4", "4-binary"] {
        let mesh = read(&folder().join(format!("gmsh-periodic-{name}.msh")));
        let lattice = Lattice::of_links(&mesh).expect("a lattice");
        assert_eq!(lattice.to_string(), "0,0,1;0,1,0;1,0,0", "{name}");
        assert_eq!(
            mesh.periodic
                .iter()
                .filter(|link| link.dimension == 2)
                .count(),
            3
        );
    }
    let path = folder().join("gmsh-periodic-4.msh");
    let path = path.to_str().expect("UTF-8");
    let output = acutile(&["certify", path, "--identify", "1e-9", "--reorient"]);
    assert_eq!(exit_code(&output), 0, "{}", stderr(&output));
    assert!(stderr(&output).contains("the lattice of $Periodic: 0,0,1;0,1,0;1,0,0"));
}

#[test]
fn every_move_of_a_node_is_told() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut mesh = cube();
    mesh.points[7] = [1.0 + 1e-12, 1.0, 1.0];
    mesh.points[4] = [0.0, 0.0, 1.0 - 1e-12];
    let path = file(folder.path(), "near.msh", &mesh);
    let exact = acutile(&["certify", &path, "--lattice", UNIT]);
    assert_eq!(exit_code(&exact), 1);
    let moves = folder.path().join("moves.csv");
    let moves = moves.to_str().expect("UTF-8");
    let output = acutile(&[
        "certify",
        &path,
        "--lattice",
        UNIT,
        "--identify",
        "1e-9",
        "--moves",
        moves,
    ]);
    assert_eq!(exit_code(&output), 0, "{}", stderr(&output));
    let told = stderr(&output);
    assert!(
        told.contains("2 nodes moved to exact images, by at most 1.000e-12"),
        "{told}"
    );
    assert!(told.contains("about the moved mesh"), "{told}");
    let list = std::fs::read_to_string(moves).expect("the list");
    let rows: Vec<Vec<&str>> = list
        .lines()
        .skip(1)
        .map(|line| line.split(',').collect())
        .collect();
    assert_eq!(rows.len(), 2);
    assert_eq!((rows[0][0], &rows[0][4..7]), ("5", &["0", "0", "1"][..]));
    assert_eq!((rows[1][0], &rows[1][4..7]), ("8", &["1", "1", "1"][..]));
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
            "line 5: found 99999999999 as the number of nodes, but the 19 bytes that are left have room for at most 2",
        ),
        (
            format!("{head}$Nodes\n2\n1 0 0 0\n1 1 nan 0\n$EndNodes\n"),
            "line 7: found \"nan\", expected the coordinate y, a number",
        ),
        (
            format!("{head}$Nodes\n2\n1 0 0 0\n1 1 0 0\n$EndNodes\n"),
            "the node number 1 is there twice: node 1 and node 2 of the file",
        ),
        (
            format!("{head}{nodes}$Elements\n1\n9 4 2 1 1 1 2 3 5\n$EndElements\n"),
            "line 13: the tetrahedron 9 has the node 5, which is not there",
        ),
        (
            format!("{head}{nodes}$Elements\n1\n9 2 2 1 1 1 2 3\n$EndElements\n"),
            "has no tetrahedra, but 1 triangles",
        ),
        (
            format!("{head}{nodes}$Elements\n1\n9 11 2 1 1 1 2 3 4 1 2 3 4 1 2\n$EndElements\n"),
            "has 1 second-order tetrahedra, expected tetrahedra with four nodes: facets of the former need not be plane",
        ),
        (
            format!("{head}{nodes}$Elements\n2\n9 4 2 1 1 1 2 3 4\n"),
            "line 14: the file ends, expected an element number",
        ),
        (
            "$MeshFormat\n4 0 8\n$EndMeshFormat\n".to_owned(),
            "line 2: found MSH version \"4\", expected 2.0 to 2.2, or 4.1 (Gmsh converts others)",
        ),
    ];
    for (text, expected) in cases {
        let error = Family::Msh.read(text.as_bytes()).expect_err(expected);
        assert_eq!(error.to_string(), expected);
    }
}

#[test]
fn a_pipe_and_gzip_are_read() {
    let folder = tempfile::tempdir().expect("a folder");
    let plain = file(folder.path(), "c.msh", &cube());
    let packed = folder.path().join("c.vtu.gz");
    let packed = packed.to_str().expect("UTF-8");
    assert_eq!(exit_code(&acutile(&["convert", &plain, packed])), 0);
    let output = acutile(&["certify", packed, "--lattice", UNIT]);
    assert_eq!(exit_code(&output), 0, "{}", stderr(&output));
    let output = Command::new(env!("CARGO_BIN_EXE_acutile"))
        .args(["certify", "-", "--lattice", UNIT])
        .stdin(std::fs::File::open(&plain).expect("the file"))
        .output()
        .expect("the program runs");
    assert_eq!(exit_code(&output), 0, "{}", stderr(&output));
    // Known by its first bytes, a mesh stays what it is.
    let nameless = folder.path().join("nameless");
    std::fs::copy(&plain, &nameless).expect("copied");
    let nameless = nameless.to_str().expect("UTF-8");
    let again = folder.path().join("again.msh");
    let output = acutile(&["convert", nameless, again.to_str().expect("UTF-8")]);
    assert_eq!(exit_code(&output), 0, "{}", stderr(&output));
    assert_eq!(
        std::fs::read(&plain).expect("a"),
        std::fs::read(&again).expect("b")
    );
}

#[test]
fn tilings_of_the_catalogue_become_meshes_and_are_proved_again() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("t.msh");
    let path = path.to_str().expect("UTF-8");
    for (name, supercell) in [
        ("a15", "1,2,1"),
        ("slab", "1,1"),
        ("cube-5", "1,1,1"),
        ("bcc", "2,1,1"),
    ] {
        let output = acutile(&["convert", name, path, "--supercell", supercell, "--round"]);
        assert_eq!(exit_code(&output), 0, "{name}: {}", stderr(&output));
        let told = stderr(&output);
        let lattice = told
            .split('"')
            .nth(1)
            .unwrap_or_else(|| panic!("{name}: {told}"));
        let mut arguments = vec!["certify", path, "--lattice", lattice];
        if told.contains("no doubles") {
            arguments.extend(["--identify", "1e-12"]);
        }
        let output = acutile(&arguments);
        assert_eq!(exit_code(&output), 0, "{name}: {told} {}", stderr(&output));
    }
    let refused = acutile(&["convert", "z", path]);
    assert_eq!(exit_code(&refused), 2);
    assert!(
        stderr(&refused).contains("--round allows it"),
        "{}",
        stderr(&refused)
    );
}

/// The unit cubes of Z^3, each cut into six. A tetrahedron of one of the eight cubes at the
/// origin has coordinates -1, 0 and 1, so its corners are within sqrt 3 < 1.8; one of any other cube
/// has a corner with a coordinate 2 or -2.
#[test]
fn a_patch_holds_whole_tetrahedra_in_the_ball() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("p.vtu");
    let path = path.to_str().expect("UTF-8");
    let output = acutile(&["convert", "cube-6", path, "--patch", "1.8"]);
    assert_eq!(exit_code(&output), 0, "{}", stderr(&output));
    let mesh = read(Path::new(path));
    for point in mesh.points.iter() {
        assert!(point.iter().map(|x| x * x).sum::<f64>() <= 1.8 * 1.8);
    }
    assert_eq!(mesh.tetrahedra.len(), 48);
    assert_eq!(mesh.points.len(), 27);
    let none = acutile(&["convert", "cube-6", path, "--patch", "1/2"]);
    assert_eq!(exit_code(&none), 2);
}
