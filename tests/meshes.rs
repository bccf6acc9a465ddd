//! Mesh files on the command line: periodic meshes proved, damaged ones not.

use acutile_io::mesh::{Family, Lattice, Mesh, load, write};
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
        // Half the lattice covers everything twice; twice the lattice leaves every other plate free.
        let output = acutile(&["certify", &path, "--lattice", "1/2,0,0;0,1,0;0,0,1"]);
        assert_eq!(exit_code(&output), 1, "{name}");
        let output = acutile(&["certify", &path, "--lattice", "2,0,0;0,1,0;0,0,1"]);
        assert_eq!(exit_code(&output), 0, "{name}: {}", stderr(&output));
        let answer = String::from_utf8_lossy(&output.stdout).into_owned();
        assert!(
            answer.contains("region") && answer.contains("by 4 triangles"),
            "{answer}"
        );
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
fn a_vector_of_two_entries_is_none_of_space() {
    let file = folder().join("meshio-4.msh");
    let path = file.to_str().expect("UTF-8");
    let run = acutile(&["certify", path, "--lattice", "1,2"]);
    assert_eq!(exit_code(&run), 2);
    let message = String::from_utf8_lossy(&run.stderr);
    assert!(message.contains("expected three entries"), "{message}");
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
        if told.contains("no exact 64-bit") {
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

/// The unit cubes of Z^3, each cut into six. A tetrahedron of one of the eight cubes at the origin has
/// coordinates -1, 0 and 1, so its corners are within sqrt 3 < 1.8. A tetrahedron of any other cube has a
/// corner with a coordinate 2 or -2.
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
