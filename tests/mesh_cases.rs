//! Faults of public mesh files, each with the right answer. The files are in `tests/meshes/cases`.

use super::common::{acutile, code, file, stderr, stdout};
use std::path::{Path, PathBuf};

pub(super) fn case(name: &str) -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/meshes/cases");
    folder.join(name).to_string_lossy().into_owned()
}

/// The exit code, standard output and standard error of `certify --no-certificate`.
pub(super) fn certify(name: &str, options: &[&str]) -> (i32, String, String) {
    let input = if Path::new(name).exists() {
        name.to_owned()
    } else {
        case(name)
    };
    let arguments = ["certify", &input, "--no-certificate"];
    let output = acutile(arguments.iter().chain(options));
    (code(&output), stdout(&output), stderr(&output))
}

/// The boundary of a cube of n x n x n small cubes with six tetrahedra each has 12 n² triangles, and
/// each of these files has 6 n³ tetrahedra.
#[test]
fn every_reader_reads_its_files() {
    for (name, simplices) in [
        ("good_cube.vtk", 6),
        ("float_upper.vtk", 48),
        ("upper_double.vtk", 48),
        ("binary_elementdata_newline.msh", 6),
        ("binary_elementdata_no_newline.msh", 6),
        ("version1.msh", 6),
        ("lz4.vtu", 162),
        ("cube_lzma.vtu", 6),
        ("cube40.msh", 6),
        ("cube40_binary.msh", 6),
        ("cube.inp", 6),
        ("cube.bdf", 6),
        ("cube.mesh", 6),
        ("tetgen_short_head.node", 1),
        ("tetgen_short_head.ele", 1),
        ("straight10.vtu", 1),
    ] {
        let (code, out, err) = certify(name, &[]);
        assert_eq!(code, 0, "{name}: {out}{err}");
        let noun = if simplices == 1 {
            "simplex"
        } else {
            "simplices"
        };
        let count = format!(", {simplices} {noun})");
        assert!(out.contains(&count), "{name}: {out}");
    }
}

/// Two cubes that share one edge: their union is no manifold there.
#[test]
fn a_version_is_a_number() {
    let (code, out, err) = certify("version_2.200000.msh", &[]);
    assert_eq!(code, 0, "{err}");
    assert!(out.contains("12 simplices"), "{out}");
    assert!(out.contains("no manifold at 1 edge and no vertex"), "{out}");
    let (code, out, _) = certify("version_2.200000.msh", &["--require", "manifold-boundary"]);
    assert_eq!(code, 1);
    assert!(out.contains("not-manifold"), "{out}");
}

#[test]
fn a_byte_order_mark_is_passed_over() {
    let folder = tempfile::tempdir().expect("a folder");
    for name in [
        "version1.msh",
        "good_cube.vtk",
        "cube.inp",
        "cube.bdf",
        "cube.mesh",
    ] {
        let text = std::fs::read_to_string(case(name)).expect("text");
        let path = file(folder.path(), name, &format!("\u{feff}{text}"));
        let (code, _, err) = certify(&path.to_string_lossy(), &[]);
        assert_eq!(code, 0, "{name}: {err}");
    }
}

#[test]
fn parametric_nodes_of_version_2_have_their_parameters() {
    let text = "$PhysicalNames\n1\n3 7 \"k\u{f6}rper \"a b\"\"\n$EndPhysicalNames\n\
                $MeshFormat\n2.2 0 8\n$EndMeshFormat\n$ParametricNodes\n4\n1 0 0 0 0 9\n\
                2 1 0 0 1 14 0.5\n3 0 1 0 2 3 0.25 0.75\n4 0 0 1 3 1\n$EndParametricNodes\n\
                $Elements\n1\n1 4 2 7 1 1 2 3 4\n$EndElements\n";
    let folder = tempfile::tempdir().expect("a folder");
    let path = file(folder.path(), "p.msh", text);
    let (code, out, err) = certify(&path.to_string_lossy(), &[]);
    assert_eq!(code, 0, "{err}");
    assert!(out.contains("tag 7 \"k\u{f6}rper \"a b\"\""), "{out}");
}

/// A name from a file, which a terminal would take for a command.
#[test]
fn names_of_labels_have_no_control_characters() {
    let text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n3 7 \"steel\u{1b}[2J\"\n\
                $EndPhysicalNames\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n\
                $Elements\n1\n1 4 2 7 1 1 2 3 4\n$EndElements\n";
    let folder = tempfile::tempdir().expect("a folder");
    let path = file(folder.path(), "p.msh", text);
    let named = path.to_string_lossy();
    let medit = folder.path().join("p.mesh");
    let grid =
        std::fs::read_to_string("tests/meshes/meshio-text.vtu").expect("a file of the tests");
    let array = "<CellData><DataArray type=\"Float64\" Name=\"steel&#27;[2J\" format=\"ascii\">0</DataArray></CellData>";
    let grid = grid.replacen("</Piece>", &format!("{array}</Piece>"), 1);
    let grid = file(folder.path(), "p.vtu", &grid);
    let grid = grid.to_string_lossy();
    for arguments in [
        &["certify", &named, "--no-certificate"][..],
        &["convert", &named, &medit.to_string_lossy()],
        &["convert", &grid, &medit.to_string_lossy()],
    ] {
        let output = acutile(arguments);
        let said = stdout(&output) + &stderr(&output);
        assert_eq!(code(&output), 0, "{said}");
        assert!(said.contains("steel"), "{arguments:?}: {said}");
        assert!(!said.contains('\u{1b}'), "{arguments:?}: {said}");
    }
}

#[test]
fn an_overlap_has_a_point_and_contact_has_none() {
    for (name, kind) in [
        ("interface_duplicated_nodes.msh", "the 8 facets are equal"),
        ("interface_other_diagonals.msh", "other diagonals"),
    ] {
        let (code, out, _) = certify(name, &[]);
        assert_eq!(code, 1, "{name}");
        assert!(out.contains("refuted: 1 non-conforming\n"), "{name}: {out}");
        assert!(out.contains(kind), "{name}: {out}");
        assert!(out.contains("8 facets ("), "{name}: {out}");
        let (code, out, _) = certify(name, &["--allow-contact"]);
        assert_eq!(code, 0, "{name}: {out}");
        assert!(out.contains("interiors are disjoint"), "{name}: {out}");
    }
    let (_, out, _) = certify("interface_duplicated_nodes.msh", &["--allow-contact"]);
    assert!(out.contains("8 pairs of coincident facets"), "{out}");
    let (code, out, _) = certify("random_tets.msh", &["--allow-contact"]);
    assert_eq!(code, 1);
    assert!(out.contains("overlap: both have the point"), "{out}");
    assert!(!out.contains("non-conforming"), "{out}");
}

#[test]
fn regions_are_described() {
    let (code, out, _) = certify("two_pieces.msh", &[]);
    assert_eq!(code, 0);
    assert!(out.contains("2 pieces, no cavity"), "{out}");
    assert_eq!(certify("two_pieces.msh", &["--require", "connected"]).0, 1);
    let (code, out, _) = certify("missing_cells.msh", &[]);
    assert_eq!(code, 0);
    assert!(out.contains("cavity"), "{out}");
    // 381 tetrahedra of volume 1/6.
    let (_, out, _) = certify("missing_cells.msh", &["--json"]);
    assert!(out.contains("\"volume\":63.5}"), "{out}");
    let (code, out, _) = certify("missing_cells.msh", &["--require", "no-cavities"]);
    assert_eq!(code, 1, "{out}");
    for requirement in ["connected", "no-cavities", "manifold-boundary"] {
        let (code, _, err) = certify("good_cube.vtk", &["--require", requirement]);
        assert_eq!(code, 0, "{requirement}: {err}");
    }
}

/// A cell of 3 x 3 x 3 cubes without the middle one.
#[test]
fn a_periodic_cell_may_have_a_void() {
    let (code, out, err) = certify("periodic_void.msh", &["--lattice", "3,0,0;0,3,0;0,0,3"]);
    assert_eq!(code, 0, "{out}{err}");
    assert!(out.contains("1 piece, 1 cavity"), "{out}");
    assert!(
        out.contains("cavity of 12 facets: 5 simplices or more"),
        "{out}"
    );
    // With fewer directions the other sides are boundary.
    for lattice in ["3,0,0;0,3,0", "0,0,3", "-3,0,0"] {
        let (code, out, err) = certify("periodic_void.msh", &["--lattice", lattice]);
        assert_eq!(code, 0, "{lattice}: {out}{err}");
    }
    // A lattice that does not fit.
    let (code, ..) = certify("periodic_void.msh", &["--lattice", "2,0,0;0,3,0;0,0,3"]);
    assert_eq!(code, 1);
}

#[test]
fn answers_are_proportionate() {
    let (code, out, _) = certify("all_negative.vtk", &[]);
    assert_eq!((code, out.lines().count()), (1, 1), "{out}");
    assert!(
        out.contains("all 48 elements") && out.contains("--reorient"),
        "{out}"
    );
    assert!(out.contains(": proved"), "{out}");
    let (code, out, _) = certify("soup.msh", &[]);
    assert_eq!(code, 1);
    assert!(
        out.contains("with equal nodes merged (--identify 0): proved"),
        "{out}"
    );
    let (code, out, _) = certify("saved_twice.msh", &[]);
    assert_eq!(code, 1);
    assert!(out.contains("refuted: 48 duplicate\n"), "{out}");
    assert!(
        out.contains("element 1 (line 36) with tag 1, element 49 (line 84) with tag 2 have"),
        "{out}"
    );
    assert!(out.contains("consequences of these"), "{out}");
    for name in ["folded.msh", "three_on_a_facet.msh"] {
        let (code, out, _) = certify(name, &[]);
        assert_eq!(code, 1, "{name}");
        assert!(out.contains("overlap"), "{name}: {out}");
    }
}

#[test]
fn long_numbers_are_written_only_where_they_are_wanted() {
    let longest = |text: &str| {
        let words = text.split(|c: char| !c.is_ascii_digit());
        words.map(str::len).max().unwrap_or(0)
    };
    let (_, out, _) = certify("random_tets.msh", &[]);
    assert!(longest(&out) < 30, "{out}");
    let (_, out, _) = certify("random_tets.msh", &["--exact"]);
    assert!(longest(&out) > 30, "{out}");
}

#[test]
fn unknown_formats_are_named() {
    let (code, _, err) = certify("duplicate_nodes.pos", &[]);
    assert_eq!(code, 2);
    assert!(err.contains("Gmsh post-processing view"), "{err}");
    assert!(err.contains("meshio"), "{err}");
    let folder = tempfile::tempdir().expect("a folder");
    for (name, text, expected) in [
        ("a.unv", "    -1\n  2411\n", "I-DEAS"),
        ("a.su2", "NDIME= 3\n", "SU2"),
        ("a.xyz1", "what is this", "not known"),
        ("a.vtk", "<Xdmf Version=\"3.0\">", "XDMF"),
    ] {
        let path = file(folder.path(), name, text);
        let (code, _, err) = certify(&path.to_string_lossy(), &[]);
        assert_eq!(code, 2, "{name}");
        assert!(err.contains(expected), "{name}: {err}");
        assert!(!err.contains("expected value"), "{name}: {err}");
    }
}

/// The cube is filled by its mesh, in every surface format; a cube with a triangle missing is not.
#[test]
fn a_mesh_fills_its_surface() {
    for surface in ["cube.stl", "cube_binary.stl", "cube.obj"] {
        let (code, out, err) = certify("good_cube.vtk", &["--fills", &case(surface)]);
        assert_eq!(code, 0, "{surface}: {out}{err}");
        assert!(out.contains("the 12 triangles"), "{surface}: {out}");
        assert!(!out.contains("from the other side"), "{surface}: {out}");
    }
    let text = std::fs::read_to_string(case("cube.obj")).expect("text");
    let kept: Vec<&str> = text.lines().collect();
    let last = kept
        .iter()
        .rposition(|line| line.starts_with("f "))
        .expect("a face");
    let folder = tempfile::tempdir().expect("a folder");
    let path = file(folder.path(), "open.obj", &kept[..last].join("\n"));
    let (code, out, _) = certify("good_cube.vtk", &["--fills", &path.to_string_lossy()]);
    assert_eq!(code, 1);
    assert!(out.contains("1 boundary facet is no triangle"), "{out}");
}

/// The unit tetrahedron with one middle node moved.
#[test]
fn curved_tetrahedra_are_decided_one_by_one() {
    for name in ["curved10.vtu", "curved10.msh"] {
        let (code, out, err) = certify(name, &[]);
        assert_eq!(code, 0, "{name}: {err}");
        assert!(
            out.contains("positive Jacobian everywhere"),
            "{name}: {out}"
        );
    }
    let (code, _, err) = certify("invalid10.vtu", &[]);
    assert_eq!(code, 3, "{err}");
    assert!(err.contains("Jacobian at node"), "{err}");
    let turned = std::fs::read_to_string(case("curved10.msh")).expect("the file");
    let turned = turned.replace("1 2 3 4 5 6 7 8 10 9\n", "1 2 4 3 5 9 8 7 10 6\n");
    let folder = tempfile::tempdir().expect("a folder");
    let path = file(folder.path(), "turned.msh", &turned);
    assert_eq!(certify(&path.to_string_lossy(), &[]).0, 3);
    assert_eq!(certify(&path.to_string_lossy(), &["--reorient"]).0, 0);
}

/// 620 tetrahedra around a common edge: any two of the 1240 boundary facets have a common corner.
#[test]
fn a_fan_is_decided() {
    let (code, out, err) = certify("fan_620.msh", &[]);
    assert_eq!(code, 0, "{out}{err}");
    assert!(out.contains("a boundary of 1240 triangles"), "{out}");
}

#[test]
fn triangles_in_the_plane_are_proved() {
    let (code, out, err) = certify("square.vtk", &[]);
    assert_eq!(code, 0, "{err}");
    assert!(out.contains("2 simplices"), "{out}");
    for lattice in ["1,0;0,1", "1,0", "1,0,0;0,1,0"] {
        let (code, out, err) = certify("square.vtk", &["--lattice", lattice]);
        assert_eq!(code, 0, "{lattice}: {out}{err}");
    }
    let (code, ..) = certify(
        "square.vtk",
        &["--lattice", "1,0;0,2", "--require", "acute"],
    );
    assert_eq!(code, 1);
}

/// Numbers from 0 become numbers from 1 in all variants of MSH, and the mesh comes back unchanged.
#[test]
fn msh_numbers_are_positive() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name);
    let convert = |from: &PathBuf, to: &PathBuf, format: &str| {
        let output = acutile([
            "convert".as_ref(),
            from.as_os_str(),
            to.as_os_str(),
            "--to".as_ref(),
            format.as_ref(),
        ]);
        assert_eq!(code(&output), 0, "{}", stderr(&output));
        stderr(&output)
    };
    convert(&case("good_cube.vtk").into(), &path("first.vtk"), "vtk");
    for format in ["msh2", "msh2-binary", "msh4", "msh4-binary"] {
        let notes = convert(&case("good_cube.vtk").into(), &path("a.msh"), format);
        assert!(notes.contains("nodes are numbered from 1"), "{notes}");
        let mesh = acutile_io::mesh::load(&path("a.msh"), acutile_io::mesh::Family::Msh);
        let mesh = mesh.expect("a mesh").mesh;
        assert_eq!(mesh.nodes.iter().min(), Some(1), "{format}");
        assert_eq!(mesh.elements.iter().min(), Some(1), "{format}");
        convert(&path("a.msh"), &path("again.vtk"), "vtk");
        let points_and_cells = |path: PathBuf| {
            let text = std::fs::read_to_string(path).expect("text");
            let end = text.find("CELL_DATA").unwrap_or(text.len());
            text[..end].trim().to_owned()
        };
        assert_eq!(
            points_and_cells(path("again.vtk")),
            points_and_cells(path("first.vtk")),
            "{format}"
        );
    }
}

/// Labels and names go from MSH to VTU and back. Names that a format cannot store are named in a note.
#[test]
fn labels_are_kept_or_their_loss_is_told() {
    let text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n3 7 \"steel\"\n\
                $EndPhysicalNames\n$Nodes\n5\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 0 0 -1\n\
                $EndNodes\n$Elements\n2\n1 4 2 7 3 1 2 3 4\n2 4 2 0 4 1 3 2 5\n$EndElements\n";
    let folder = tempfile::tempdir().expect("a folder");
    let input = file(folder.path(), "a.msh", text);
    let read = |name: &str| {
        let path = folder.path().join(name);
        let family = acutile_io::mesh::Family::of_path(&path).expect("a format");
        acutile_io::mesh::load(&path, family).expect("a mesh").mesh
    };
    for name in ["b.vtu", "b.vtk", "b.mesh", "b.meshb", "b.msh"] {
        let path = folder.path().join(name);
        let output = acutile(["convert".as_ref(), input.as_os_str(), path.as_os_str()]);
        assert_eq!(code(&output), 0, "{}", stderr(&output));
        let mesh = read(name);
        assert_eq!(mesh.labels, [7, 0], "{name}");
        let is_msh = name == "b.msh";
        let holds_entities = is_msh || name.starts_with("b.vt");
        let expected: &[i64] = if holds_entities { &[3, 4] } else { &[] };
        assert_eq!(mesh.entities, expected, "{name}");
        assert_eq!(
            mesh.names.get(&7).map(String::as_str),
            is_msh.then_some("steel"),
            "{name}"
        );
        assert_eq!(stderr(&output).contains("steel"), !is_msh, "{name}");
    }
}

#[test]
fn defects_are_written_for_paraview() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("defects.vtu");
    let option = path.to_string_lossy().into_owned();
    let (code, ..) = certify("folded.msh", &["--defects", &option]);
    assert_eq!(code, 1);
    let text = std::fs::read_to_string(&path).expect("written");
    assert!(text.contains("Name=\"same-side\"") && text.contains("Name=\"element\""));
    let mesh = acutile_io::mesh::load(&path, acutile_io::mesh::Family::Vtu).expect("a mesh");
    assert_eq!(mesh.mesh.tetrahedra.len(), 2);
}

#[test]
fn elements_of_other_types_are_mentioned_and_strict() {
    let text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n6\n1 0 0 0\n2 1 0 0\n3 0 1 0\n\
                4 0 0 1\n5 1 0 1\n6 0 1 1\n$EndNodes\n$Elements\n3\n1 4 2 1 1 1 2 3 4\n\
                2 6 2 1 1 1 2 3 4 5 6\n3 2 2 1 1 1 2 3\n$EndElements\n";
    let folder = tempfile::tempdir().expect("a folder");
    let path = file(folder.path(), "a.msh", text);
    let (code, out, _) = certify(&path.to_string_lossy(), &[]);
    assert_eq!(code, 0);
    assert!(out.contains("not checked: 1 prism, 1 triangle"), "{out}");
    assert_eq!(certify(&path.to_string_lossy(), &["--strict"]).0, 3);
    assert_eq!(certify("good_cube.vtk", &["--strict"]).0, 0);
}

/// Regions of any rank and of the plane are written as tiling files, and read again.
#[test]
fn tiling_files_have_regions_of_every_rank() {
    let folder = tempfile::tempdir().expect("a folder");
    for (name, lattice, domain) in [
        ("periodic_void.msh", "3,0,0;0,3,0;0,0,3", "{\"region\":3}"),
        ("periodic_void.msh", "3,0,0", "{\"region\":1}"),
        ("square.vtk", "", "\"region\""),
        ("square.vtk", "2,0", "{\"region\":1}"),
    ] {
        let path = folder.path().join("t.json");
        let input = case(name);
        let mut arguments = vec!["export", &input, "-o", path.to_str().expect("UTF-8")];
        if !lattice.is_empty() {
            arguments.extend(["--lattice", lattice]);
        }
        let output = acutile(arguments);
        assert_eq!(code(&output), 0, "{}", stderr(&output));
        let text = std::fs::read_to_string(&path).expect("written");
        assert!(
            text.contains(&format!("\"domain\": {domain}")),
            "{name}: {text}"
        );
        let (code, out, err) = certify(path.to_str().expect("UTF-8"), &[]);
        assert_eq!(code, 0, "{name} {lattice}: {out}{err}");
    }
}

/// A cell of 2 x 2 x 2 cubes with six tetrahedra each, as MSH 2 text; `edit` may move nodes and change
/// tetrahedra. With `links`, `$Periodic` has the three pairs of opposite sides.
pub(super) fn grid(edit: impl Fn(&mut Vec<[f64; 3]>, &mut Vec<[usize; 4]>), links: bool) -> String {
    const ORDERS: [[usize; 3]; 6] = [
        [0, 1, 2],
        [1, 2, 0],
        [2, 0, 1],
        [0, 2, 1],
        [2, 1, 0],
        [1, 0, 2],
    ];
    let node = |place: [usize; 3]| 9 * place[0] + 3 * place[1] + place[2] + 1;
    let places = (0..27).map(|k| [k / 9, k / 3 % 3, k % 3]);
    let places: Vec<[usize; 3]> = places.collect();
    let mut points: Vec<[f64; 3]> = places.iter().map(|p| p.map(|x| x as f64)).collect();
    let mut cells: Vec<[usize; 4]> = Vec::new();
    for cube in (0..8).map(|k| [k / 4, k / 2 % 2, k % 2]) {
        for (index, order) in ORDERS.iter().enumerate() {
            let mut at = cube;
            let mut cell = vec![node(at)];
            for axis in order {
                at[*axis] += 1;
                cell.push(node(at));
            }
            // The last three orders are odd.
            if index >= 3 {
                cell.swap(2, 3);
            }
            cells.push([cell[0], cell[1], cell[2], cell[3]]);
        }
    }
    edit(&mut points, &mut cells);
    let mut text = format!(
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{}\n",
        points.len()
    );
    for (index, [x, y, z]) in points.iter().enumerate() {
        text += &format!("{} {x} {y} {z}\n", index + 1);
    }
    text += &format!("$EndNodes\n$Elements\n{}\n", cells.len());
    for (index, [a, b, c, d]) in cells.iter().enumerate() {
        text += &format!("{} 4 2 1 1 {a} {b} {c} {d}\n", index + 1);
    }
    text += "$EndElements\n";
    if links {
        text += "$Periodic\n3\n";
        for axis in 0..3 {
            let matrix = |i: usize, j: usize| match (i == j, j == 3 && i == axis) {
                (true, _) => "1",
                (_, true) => "2",
                _ => "0",
            };
            let affine: Vec<&str> = (0..16).map(|k| matrix(k / 4, k % 4)).collect();
            text += &format!(
                "2 {} {}\nAffine {}\n9\n",
                2 * axis + 2,
                2 * axis + 1,
                affine.join(" ")
            );
            for place in places.iter().filter(|place| place[axis] == 2) {
                let mut image = *place;
                image[axis] = 0;
                text += &format!("{} {}\n", node(*place), node(image));
            }
        }
        text += "$EndPeriodic\n";
    }
    text
}

/// Node 23 is at (2, 1, 1), with six triangles in the side x = 2 around it, and node 5 at (0, 1, 1).
#[test]
fn a_gap_at_the_sides_is_refuted_only_with_a_witness() {
    let folder = tempfile::tempdir().expect("a folder");
    let lattice = ["--lattice", "2,0,0;0,2,0;0,0,2"];
    let run = |name: &str, text: &str, options: &[&str]| {
        let path = file(folder.path(), name, text);
        certify(&path.to_string_lossy(), options)
    };
    for (links, options) in [(false, &lattice[..]), (true, &[])] {
        let (code, out, err) = run("a.msh", &grid(|_, _| (), links), options);
        assert_eq!(code, 0, "{out}{err}");
        assert!(!out.contains("boundary"), "{out}");
    }
    let moved = |x: f64, links: bool| grid(move |points, _| points[22][0] = x, links);
    // The file says that node 23 is an image of node 5, and it is not.
    let thin = 2.0 - 2f64.powi(-30);
    let (code, out, _) = run("a.msh", &moved(thin, true), &[]);
    assert_eq!(code, 1);
    assert!(out.contains("refuted: 12 unmatched-facet\n"), "{out}");
    // Without links nobody says so.
    let text = moved(thin, false);
    let (code, _, err) = run("a.msh", &text, &lattice);
    assert_eq!(code, 3, "{err}");
    assert!(err.contains("12 facets have no mate"), "{err}");
    assert!(err.contains("9.313e-10"), "{err}");
    let with = |tolerance: &'static str| [&lattice[..], &["--identify", tolerance]].concat();
    let (code, out, _) = run("a.msh", &text, &with("0"));
    assert_eq!(code, 0);
    assert!(
        out.contains("a periodic region with a boundary of 12 triangles"),
        "{out}"
    );
    let (code, out, _) = run("a.msh", &text, &with("1e-6"));
    assert_eq!(code, 0);
    assert!(!out.contains("boundary"), "{out}");
    // A wide gap is a void.
    let (code, out, err) = run("a.msh", &moved(1.75, false), &lattice);
    assert_eq!(code, 0, "{out}{err}");
    assert!(
        err.contains("closes the mesh but for 12 facets, which are boundary"),
        "{err}"
    );
    assert!(
        out.contains("a periodic region with a boundary of 12 triangles"),
        "{out}"
    );
    // The last tetrahedron has a triangle in the side z = 2; that in the side z = 0 loses its mate.
    let text = grid(|_, cells| cells.truncate(47), false);
    let (code, out, _) = run("a.msh", &text, &lattice);
    assert_eq!(code, 1);
    assert!(out.contains("unmatched-facet"), "{out}");
}

/// One element of the cube has two corners exchanged. Two of its triangles are inside.
#[test]
fn facets_of_negative_elements_are_consequences() {
    let folder = tempfile::tempdir().expect("a folder");
    let text = std::fs::read_to_string(case("good_cube.vtk")).expect("text");
    let path = file(
        folder.path(),
        "a.vtk",
        &text.replace("4 0 1 7 5", "4 0 1 5 7"),
    );
    let path = path.to_string_lossy();
    let (code, out, _) = certify(&path, &[]);
    assert_eq!(code, 1);
    assert!(out.contains("refuted: 1 negative-orientation\n"), "{out}");
    assert!(
        out.contains("consequences of these: 2 same-side\n"),
        "{out}"
    );
    let (code, out, _) = certify(&path, &["--lattice", "1,0,0;0,1,0;0,0,1"]);
    assert_eq!(code, 1);
    assert!(out.contains("refuted: 1 negative-orientation\n"), "{out}");
    assert!(
        out.contains("consequences of these: 4 same-side, 1 volume-sum\n"),
        "{out}"
    );
    // A flat element that lies on the side z = 0, with both of its triangles there.
    let text = text.replace("CELLS 6 30", "CELLS 7 35\n4 0 3 1 2");
    let text = text.replace("CELL_TYPES 6", "CELL_TYPES 7\n10");
    let path = file(folder.path(), "b.vtk", &text);
    let (code, out, _) = certify(&path.to_string_lossy(), &[]);
    assert_eq!(code, 1);
    assert!(out.contains("refuted: 1 flat\n"), "{out}");
}

/// A cube in five tetrahedra has other diagonals on opposite sides, so its translates do not match.
#[test]
fn facets_that_lie_against_each_other_across_the_lattice_are_an_interface() {
    let folder = tempfile::tempdir().expect("a folder");
    let text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n8\n1 0 0 0\n2 1 0 0\n3 0 1 0\n\
                4 1 1 0\n5 0 0 1\n6 1 0 1\n7 0 1 1\n8 1 1 1\n$EndNodes\n$Elements\n5\n\
                1 4 2 1 1 1 2 3 5\n2 4 2 1 1 4 3 2 8\n3 4 2 1 1 6 2 5 8\n4 4 2 1 1 7 5 3 8\n\
                5 4 2 1 1 2 3 5 8\n$EndElements\n";
    let path = file(folder.path(), "five.msh", text);
    let path = path.to_string_lossy();
    let (code, out, err) = certify(&path, &[]);
    assert_eq!(code, 0, "{out}{err}");
    let lattice = ["--lattice", "1,0,0;0,1,0;0,0,1"];
    let (code, out, _) = certify(&path, &lattice);
    assert_eq!(code, 1);
    assert!(out.contains("non-conforming"), "{out}");
    assert!(out.contains("other diagonals"), "{out}");
    assert!(!out.contains("overlap"), "{out}");
    let (code, out, _) = certify(&path, &[&lattice[..], &["--allow-contact"]].concat());
    assert_eq!(code, 0, "{out}");
    assert!(out.contains("interiors are disjoint"), "{out}");
    // With a shorter lattice vector the cube overlaps itself.
    let (code, out, _) = certify(&path, &["--lattice", "3/4,0,0", "--allow-contact"]);
    assert_eq!(code, 1);
    assert!(out.contains("overlap: both have the point"), "{out}");
    assert!(out.contains("moved by ("), "{out}");
    assert!(!out.contains("non-conforming"), "{out}");
}

/// The nodes of the unit tetrahedron of second order; the middle of the edge from 0 to e_1 is moved by
/// 1/8 in the direction of e_2. In VTK's order: corners, then the edges 01, 12, 02, 03, 13, 23.
const CURVED: [[f64; 3]; 10] = [
    [0.0, 0.0, 0.0],
    [1.0, 0.0, 0.0],
    [0.0, 1.0, 0.0],
    [0.0, 0.0, 1.0],
    [0.5, 0.125, 0.0],
    [0.5, 0.5, 0.0],
    [0.0, 0.5, 0.0],
    [0.0, 0.0, 0.5],
    [0.5, 0.0, 0.5],
    [0.0, 0.5, 0.5],
];

/// Files of Gmsh 4.15.2 and TetGen 1.5.0 have straight elements; read in another order they would be
/// curved. A curved element is valid in the right order alone.
#[test]
fn second_order_tetrahedra_of_medit_and_tetgen() {
    for (name, simplices) in [("gmsh_order2.mesh", 24), ("tetgen_o2.node", 4)] {
        let (code, out, err) = certify(name, &[]);
        assert_eq!(code, 0, "{name}: {out}{err}");
        assert!(
            out.contains(&format!(", {simplices} simplices)")),
            "{name}: {out}"
        );
    }
    let folder = tempfile::tempdir().expect("a folder");
    let valid = |path: &Path| {
        let (code, out, err) = certify(&path.to_string_lossy(), &[]);
        assert_eq!(code, 0, "{out}{err}");
        assert!(out.contains("1 are of second order and curved"), "{out}");
    };
    let nodes = CURVED.map(|[x, y, z]| format!("{x} {y} {z}"));
    let vertices: String = nodes.iter().map(|node| format!("{node} 0\n")).collect();
    let text = format!(
        "MeshVersionFormatted 2\nDimension 3\nVertices\n10\n{vertices}TetrahedraP2\n1\n\
         1 2 3 4 5 6 7 8 9 10 7\nEnd\n"
    );
    valid(&file(folder.path(), "a.mesh", &text));
    let other = text.replace("End", "TetrahedraP2Ordering\n10\nEnd");
    let path = file(folder.path(), "b.mesh", &other);
    let (code, _, err) = certify(&path.to_string_lossy(), &[]);
    assert_eq!(code, 3);
    assert!(err.contains("TetrahedraP2Ordering"), "{err}");
    let rows: String = (1..)
        .zip(&nodes)
        .map(|(k, node)| format!("{k} {node}\n"))
        .collect();
    file(folder.path(), "c.node", &format!("10 3 0 0\n{rows}"));
    // The edges 23, 03, 01, 12, 13, 02.
    let path = file(folder.path(), "c.ele", "1 10 0\n1 1 2 3 4 10 8 5 6 9 7\n");
    valid(&path);
    // The opposite orientation: corners 3 and 4 exchanged, so the edges 23, 02, 01, 13, 12, 03.
    let path = file(folder.path(), "c.ele", "1 10 0\n1 1 2 4 3 10 7 5 9 6 8\n");
    valid(&path);
    // MEDIT in binary, version 2: keyword, position of the next one, count, items.
    let int = |x: i32| x.to_le_bytes().to_vec();
    let mut bytes = [int(1), int(2), int(3), int(20), int(3)].concat();
    bytes.extend([int(4), int(20 + 12 + 10 * 28), int(10)].concat());
    for node in CURVED {
        bytes.extend(node.iter().flat_map(|x| x.to_le_bytes()));
        bytes.extend(int(0));
    }
    bytes.extend([int(30), int(20 + 12 + 280 + 12 + 44), int(1)].concat());
    bytes.extend([1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 7].into_iter().flat_map(int));
    bytes.extend([int(54), int(0)].concat());
    let path = folder.path().join("d.meshb");
    std::fs::write(&path, bytes).expect("written");
    valid(&path);
}
