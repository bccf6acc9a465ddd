//! Answers about meshes: one line for one fault, points in the coordinates of the file, nouns that agree
//! with their numbers.

use super::common::{acutile, code, file, stderr, stdout};
use super::mesh_cases::{certify, grid};
use serde_json::Value;
use std::fmt::Write;
use std::path::Path;

/// A mesh as MSH 2 text, with a label for each tetrahedron.
pub fn msh(points: &[[f64; 3]], cells: &[[usize; 4]], label: impl Fn(usize) -> usize) -> String {
    let mut text = format!(
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{}\n",
        points.len()
    );
    // Writing to a string cannot fail.
    for (index, [x, y, z]) in points.iter().enumerate() {
        let _ = writeln!(text, "{} {x} {y} {z}", index + 1);
    }
    let _ = write!(text, "$EndNodes\n$Elements\n{}\n", cells.len());
    for (index, cell) in cells.iter().enumerate() {
        let (tag, [a, b, c, d]) = (label(index), cell.map(|node| node + 1));
        let _ = writeln!(text, "{} 4 2 {tag} {tag} {a} {b} {c} {d}", index + 1);
    }
    text + "$EndElements\n"
}

pub fn certify_text(
    folder: &Path,
    name: &str,
    text: &str,
    options: &[&str],
) -> (i32, String, String) {
    certify(&file(folder, name, text).to_string_lossy(), options)
}

/// Two tetrahedra have a common edge or corner in space, and different nodes there. Each pair of facets at
/// the edge touches, and this is one contact.
#[test]
fn a_contact_along_an_edge_is_one_line() {
    let folder = tempfile::tempdir().expect("a folder");
    let first = [[0., 0., 0.], [1., 0., 0.], [0., 1., 0.], [0., 0., 1.]];
    // The first has the edge from (0, 0, 0) to (0, 0, 1) as well, the second the corner (0, 0, 0) only.
    let edge = [[0., 0., 0.], [-1., 0., 0.], [0., -1., 0.], [0., 0., 1.]];
    let corner = [[0., 0., 0.], [-1., 0., 0.], [0., 0., -1.], [0., -1., 0.]];
    for (name, second, merged) in [
        ("edge", edge, "2 nodes have"),
        ("corner", corner, "1 node has"),
    ] {
        let text = msh(
            &[first, second].concat(),
            &[[0, 1, 2, 3], [4, 5, 6, 7]],
            |_| 1,
        );
        let run = |options: &[&str]| certify_text(folder.path(), "touch.msh", &text, options);
        let (code, out, err) = run(&[]);
        assert_eq!(code, 1, "{name}: {err}");
        assert!(out.contains("refuted: 1 non-conforming\n"), "{name}: {out}");
        assert!(
            out.contains("touch in points or along edges"),
            "{name}: {out}"
        );
        assert!(
            out.contains(&format!("{merged} the coordinates of another node")),
            "{name}: {out}"
        );
        assert_eq!(run(&["--identify", "0"]).0, 0, "{name}");
        assert_eq!(run(&["--allow-contact"]).0, 0, "{name}");
    }
}

/// Three tetrahedra on one facet, two of them on the same side: they overlap, and nothing else is wrong.
#[test]
fn defects_of_simplices_on_one_side_of_a_facet_are_consequences() {
    let (code, out, _) = certify("three_on_a_facet.msh", &[]);
    assert_eq!(code, 1);
    assert!(out.contains("refuted: 1 overused-facet\n"), "{out}");
    assert!(out.contains("consequences of these: "), "{out}");
    assert!(out.contains("boundary-meets"), "{out}");
    assert!(
        out.contains("element 1 (line 15) and element 3 (line 17) overlap"),
        "{out}"
    );
}

/// In the lattice of the basis (3/2, 0, 0) the coordinates of the basis differ from those of the file. A
/// point in two tetrahedra is inside of both, in the coordinates of the file.
#[test]
fn points_of_defects_are_in_the_coordinates_of_the_file() {
    let folder = tempfile::tempdir().expect("a folder");
    let text = grid(|_, _| {}, false);
    let options = ["--lattice", "3/2,0,0", "--json"];
    let (code, out, err) = certify_text(folder.path(), "cell.msh", &text, &options);
    assert_eq!(code, 1, "{err}");
    let answer: Value = serde_json::from_str(&out).expect("JSON");
    let defects = answer["defects"].as_array().expect("defects");
    assert!(!defects.is_empty());
    for defect in defects {
        let point: [f64; 3] = numbers(&defect["point_in_file"]);
        let by = defect["second_moved_by"][0].as_f64().expect("a number") * 1.5;
        let places = defect["places"].as_array().expect("places");
        for (place, shift) in places.iter().zip([0.0, by]) {
            let corners = place["coordinates_in_file"].as_array().expect("corners");
            let corners: Vec<[f64; 3]> = corners.iter().map(numbers).collect();
            let moved = [point[0] - shift, point[1], point[2]];
            assert!(is_inside(&corners, moved), "{defect}");
        }
        let message = defect["message"].as_str().expect("a message");
        let first = defect["point_in_file"][0].as_str().expect("a number");
        assert!(
            message.contains(&format!("both have the point ({first}")),
            "{message}"
        );
    }
}

/// Fractions with small numerators and denominators, as doubles.
fn numbers(list: &Value) -> [f64; 3] {
    let number = |text: &str| match text.split_once('/') {
        Some((n, d)) => n.parse::<f64>().expect("n") / d.parse::<f64>().expect("d"),
        None => text.parse().expect("a number"),
    };
    std::array::from_fn(|k| number(list[k].as_str().expect("a text")))
}

/// Whether all determinants with the point in place of a corner have the sign of the tetrahedron's.
fn is_inside(corners: &[[f64; 3]], point: [f64; 3]) -> bool {
    let determinant = |corners: &[[f64; 3]]| {
        let [a, b, c] = [1, 2, 3].map(|k| [0, 1, 2].map(|j| corners[k][j] - corners[0][j]));
        a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
            + a[2] * (b[0] * c[1] - b[1] * c[0])
    };
    let whole = determinant(corners);
    (0..4).all(|k| {
        let mut replaced = corners.to_vec();
        replaced[k] = point;
        determinant(&replaced) * whole > 1e-6
    })
}

/// Tetrahedra around a common edge: any two facets at one of its ends have a common corner. For most of
/// these pairs the first attempt of the kernel shows that they have nothing else in common. With all
/// attempts it needed 13,000 units of work for a pair. There are 11,175 pairs at each end.
#[test]
fn a_fan_costs_the_kernel_little() {
    let folder = tempfile::tempdir().expect("a folder");
    let count = 150;
    let mut points = vec![[0., 0., 0.], [0., 0., 1.]];
    for k in 0..=count {
        let angle = f64::from(k) * std::f64::consts::TAU / f64::from(count + 1);
        points.push([angle.cos(), angle.sin(), 0.]);
    }
    let cell = |k: usize| [0, k + 2, k + 3, 1];
    let cells: Vec<[usize; 4]> = (0..count as usize).map(cell).collect();
    let path = file(folder.path(), "fan.msh", &msh(&points, &cells, |_| 1));
    let path = path.to_string_lossy();
    let output = acutile(["certify", &path, "--max-work", "60000000"]);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    assert!(stdout(&output).contains("proved: "), "{}", stdout(&output));
    // With a limit that is too small nothing is proved, and a larger one is named.
    let output = acutile(["certify", &path, "--max-work", "1000"]);
    assert_eq!(code(&output), 3);
    let words = "use a larger --max-work: without the option it is 3000000000";
    assert!(stderr(&output).contains(words), "{}", stderr(&output));
}

/// A certificate that may be beyond the usual limits says so.
#[test]
fn readers_of_a_certificate_hear_of_raised_limits() {
    let folder = tempfile::tempdir().expect("a folder");
    let certificate = folder.path().join("c.json");
    let certificate = certificate.to_string_lossy();
    let arguments = ["certify", "a15", "-o", &certificate];
    let output = acutile(arguments.iter().chain(&["--max-work", "3000000001"]));
    assert_eq!(code(&output), 0);
    assert!(
        stderr(&output).contains("acutile-verify may need the same options"),
        "{}",
        stderr(&output)
    );
    assert!(stderr(&output).contains("confirmed with --max-work 3000000001"));
    assert!(!stderr(&acutile(arguments)).contains("--max-work"));
}

/// A number for each cell is no reason for a line for each cell.
#[test]
fn many_tags_are_listed_in_part() {
    let folder = tempfile::tempdir().expect("a folder");
    let corner = |k: f64| [[k, 0., 0.], [k + 0.5, 0., 0.], [k, 1., 0.], [k, 0., 1.]];
    let points: Vec<[f64; 3]> = (0..60).flat_map(|k| corner(f64::from(k))).collect();
    let cells: Vec<[usize; 4]> = (0..60).map(|k| [0, 1, 2, 3].map(|c| 4 * k + c)).collect();
    let text = msh(&points, &cells, |index| index + 1);
    let (code, out, err) = certify_text(folder.path(), "tags.msh", &text, &[]);
    assert_eq!(code, 0, "{err}");
    assert!(out.contains("tag 1: 1 tetrahedron, volume about"), "{out}");
    assert!(
        out.contains("and 10 more tags, which --json lists"),
        "{out}"
    );
    assert!(!out.contains("tag 51:"), "{out}");
    let (_, out, _) = certify_text(folder.path(), "tags.msh", &text, &["--json"]);
    let data: Value = serde_json::from_str(out.lines().next().expect("a line")).expect("JSON");
    assert_eq!(data["region"]["tags"].as_array().map(Vec::len), Some(60));
}

/// A mesh with one triangle of nine nodes, third order.
#[test]
fn triangles_of_third_order_are_declined_by_name() {
    let folder = tempfile::tempdir().expect("a folder");
    let nodes: String = (1..=9).map(|k| format!("{k} {k} {} 0\n", k * k)).collect();
    let text = format!(
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n9\n{nodes}$EndNodes\n$Elements\n1\n\
         1 20 2 1 1 1 2 3 4 5 6 7 8 9\n$EndElements\n"
    );
    let (code, _, err) = certify_text(folder.path(), "nine.msh", &text, &[]);
    assert_eq!(code, 3, "{err}");
    assert!(err.contains("has 1 third-order triangle,"), "{err}");
}

/// Formats of meshio 5.3.5 and Gmsh 4.15.2 that are not read. None is read as a POSCAR, though the second
/// to fifth lines have one and three numbers.
#[test]
fn formats_that_are_not_read_are_named_by_their_first_bytes() {
    let folder = tempfile::tempdir().expect("a folder");
    for (name, text, expected) in [
        (
            "a.mdpa",
            "Begin ModelPartData\nEnd ModelPartData\n",
            "Kratos",
        ),
        ("a.dat", "TITLE = \"x\"\nVARIABLES = \"X\"\n", "Tecplot"),
        ("a.post", "!PERMAS DataFile Version 18.0\n", "PERMAS"),
        (
            "a.vtp",
            "<VTKFile type=\"PolyData\">",
            "VTK XML of type \"PolyData\"",
        ),
        (
            "a.vtk",
            "# vtk DataFile Version 2.0\nx\nASCII\nDATASET POLYDATA\n",
            "a VTK dataset of type \"POLYDATA\"",
        ),
        (
            "a.ply2",
            "3\n1\n0 0 0\n1 0 0\n0 1 0\n0 0 0\n3 0 1 2\n",
            "PLY2",
        ),
    ] {
        let (code, _, err) = certify_text(folder.path(), name, text, &[]);
        assert_eq!(code, 2, "{name}");
        assert!(err.contains(expected), "{name}: {err}");
        for read in ["POSCAR", "extended XYZ", "MFEM", "meshio"] {
            assert!(err.contains(read), "{name}: {err}");
        }
    }
    let text = "2\nno lattice\nNa 0 0 0\nCl 1.5 1.5 1.5\n";
    let (code, _, err) = certify_text(folder.path(), "a.xyz", text, &[]);
    assert_eq!(code, 2);
    assert!(err.contains("there is no Lattice="), "{err}");
}

/// Abaqus: quotes around a name are no part of it, and elements in another file are not passed over.
#[test]
fn abaqus_sets_have_names_without_quotes() {
    let folder = tempfile::tempdir().expect("a folder");
    let nodes = "*NODE\n1, 0,0,0\n2, 1,0,0\n3, 0,1,0\n4, 0,0,1\n";
    let text = format!("{nodes}*ELEMENT, TYPE=C3D4, ELSET=\"My Set\"\n1, 1,2,3,4\n");
    let (code, out, err) = certify_text(folder.path(), "a.inp", &text, &[]);
    assert_eq!(code, 0, "{err}");
    assert!(out.contains("tag 1 \"My Set\": 1 tetrahedron"), "{out}");
    let text = format!("{text}*ELEMENT, TYPE=C3D4, INPUT=more.inp\n");
    let (code, _, err) = certify_text(folder.path(), "b.inp", &text, &[]);
    assert_eq!(code, 3, "{err}");
    assert!(err.contains("line 8: found *ELEMENT with INPUT"), "{err}");
    // A surface without triangles is no surface.
    let surface = file(folder.path(), "empty.stl", "solid a\nendsolid a\n");
    let options = ["--fills", &surface.to_string_lossy()];
    let (code, _, err) = certify("good_cube.vtk", &options);
    assert_eq!(code, 2, "{err}");
    assert!(err.contains("has no triangles"), "{err}");
}

/// The notes about a crystal structure are in the JSON of each command that reads it.
#[test]
fn notes_are_in_the_json_of_every_command() {
    let folder = tempfile::tempdir().expect("a folder");
    let text = "data_hcp\n_cell_length_a 3.2\n_cell_length_b 3.2\n_cell_length_c 5.2\n\
                _cell_angle_gamma 120\n_space_group_name_H-M_alt 'P 63/m m c'\nloop_\n\
                _atom_site_label\n_atom_site_fract_x\n_atom_site_fract_y\n_atom_site_fract_z\n\
                Mg1 0.333 0.667 0.25\n";
    let path = file(folder.path(), "hcp.cif", text);
    let path = path.to_string_lossy();
    for command in ["classify", "quality", "certify", "optimize"] {
        let options = ["--special", "--triangulate", "--json"];
        let steps = ["--steps", "1"];
        let steps = steps.iter().filter(|_| command == "optimize");
        let output = acutile([command, &path].iter().chain(&options).chain(steps));
        // With one step nothing better may be found, and the answer is the same.
        let is_answered = [0, 3].contains(&code(&output));
        assert!(is_answered, "{command}: {}", stderr(&output));
        let line = stdout(&output);
        let line = line.lines().next().expect("a line");
        let data: Value = serde_json::from_str(line).expect("JSON");
        let notes = data["notes"].as_array().expect("notes");
        let has = |words: &str| {
            let mut texts = notes.iter().filter_map(Value::as_str);
            texts.any(|note| note.contains(words))
        };
        assert!(has("moved to (1/3, 2/3, 1/4)"), "{command}: {data}");
        assert!(has("2 atoms in a cell: Mg1 2"), "{command}: {data}");
    }
}

/// The z of a plane mesh is that of the file.
#[test]
fn corners_of_plane_meshes_have_the_height_of_the_file() {
    let folder = tempfile::tempdir().expect("a folder");
    let text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 0 0 0.25\n2 1 0 0.25\n\
                3 0 1 0.25\n$EndNodes\n$Elements\n2\n1 2 2 1 1 1 2 3\n2 2 2 1 1 1 2 3\n$EndElements\n";
    let (code, out, _) = certify_text(folder.path(), "high.msh", text, &[]);
    assert_eq!(code, 1);
    assert!(out.contains("refuted: 1 duplicate\n"), "{out}");
    assert!(out.contains("2 at (1, 0, 1/4)"), "{out}");
}
