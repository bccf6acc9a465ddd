//! Files as other programs write them: what is read, and how it is refused.

use super::common::{acutile, code, file};
use super::mesh_cases::{case, certify, grid};
use std::path::Path;

/// Arrays of texts and of variants stand before and after the labels 7 and 8.
#[test]
fn arrays_of_texts_in_vtk_files_are_passed_over() {
    for name in [
        "vtk_texts_42.vtk",
        "vtk_texts_42_binary.vtk",
        "vtk_texts_51.vtk",
        "vtk_texts_51_binary.vtk",
    ] {
        let (code, out, err) = certify(name, &[]);
        assert_eq!(code, 0, "{name}: {err}");
        for words in ["tag 7: 1 tetrahedron", "tag 8: 1 tetrahedron"] {
            assert!(out.contains(words), "{name}: {out}");
        }
        // A text that says to be longer than the file.
        let bytes = std::fs::read(case(name)).expect("the file");
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join(name);
        std::fs::write(&path, &bytes[..bytes.len() - 60]).expect("written");
        let (code, _, err) = certify(&path.to_string_lossy(), &[]);
        let is_text = !name.contains("binary");
        assert_eq!(code, if is_text { 0 } else { 2 }, "{name}: {err}");
    }
}

/// Gmsh writes `$Periodic` into files of version 1 as into those of version 2.
#[test]
fn periodic_links_of_version_1_are_read() {
    let text = grid(|_, _| {}, true)
        .replace("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n", "")
        .replace("$Nodes", "$NOD")
        .replace("$EndNodes", "$ENDNOD")
        .replace("$Elements", "$ELM")
        .replace("$EndElements", "$ENDELM")
        .replace(" 4 2 1 1 ", " 4 1 1 4 ");
    let folder = tempfile::tempdir().expect("a folder");
    let path = file(folder.path(), "one.msh", &text);
    let (code, out, err) = certify(&path.to_string_lossy(), &[]);
    assert_eq!(code, 0, "{err}");
    assert!(err.contains("the lattice of $Periodic: "), "{err}");
    assert!(!out.contains("boundary"), "{out}");
    assert!(out.contains(", 48 simplices)"), "{out}");
}

/// meshio 5.3.5 calls a tetrahedron with ten nodes `CTETRA_`.
#[test]
fn second_order_names_of_meshio_are_read_in_nastran_files() {
    let (code, out, err) = certify("curved10.bdf", &[]);
    assert_eq!(code, 0, "{err}");
    assert!(out.contains("positive Jacobian everywhere"), "{out}");
}

/// Gmsh writes third order into MEDIT files, with 10 and 20 nodes.
#[test]
fn third_order_in_medit_files_is_declined_by_name() {
    let vertices: String = (0..20)
        .map(|k| format!("{k} {} {} 0\n", k * k, k % 7))
        .collect();
    let nodes = |count: usize| (1..=count).map(|k| format!("{k} ")).collect::<String>();
    let folder = tempfile::tempdir().expect("a folder");
    for (keyword, count, words) in [
        (
            "TetrahedraP3",
            20,
            "has 1 third-order tetrahedron, expected",
        ),
        ("TrianglesP3", 10, "has 1 third-order triangle, expected"),
    ] {
        let text = format!(
            "MeshVersionFormatted 2\nDimension 3\nVertices\n20\n{vertices}{keyword}\n1\n{}1\nEnd\n",
            nodes(count)
        );
        let path = file(folder.path(), "p3.mesh", &text);
        let (code, _, err) = certify(&path.to_string_lossy(), &[]);
        assert_eq!(code, 3, "{keyword}: {err}");
        assert!(err.contains(words), "{keyword}: {err}");
    }
}

/// A second mesh after the end of the first would not be proved, so it is not passed over.
#[test]
fn nothing_follows_the_end_of_a_mesh() {
    let folder = tempfile::tempdir().expect("a folder");
    let medit = "MeshVersionFormatted 2\nDimension 3\nVertices\n4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n\
                 0 0 1 0\nTetrahedra\n1\n1 2 3 4 0\nEnd\n";
    let nastran = "BEGIN BULK\nGRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\nGRID,3,,0.,1.,0.\n\
                   GRID,4,,0.,0.,1.\nCTETRA,1,1,1,2,3,4\nENDDATA\n";
    let path = file(folder.path(), "one.mesh", medit);
    let binary = folder.path().join("one.meshb");
    let binary = binary.to_string_lossy();
    let run = acutile(["convert", &path.to_string_lossy(), &binary]);
    assert_eq!(code(&run), 0);
    let binary = std::fs::read(&*binary).expect("written");
    let vtu = |name| {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/meshes");
        std::fs::read(path.join(name)).expect("a file of the tests")
    };
    let (text, appended) = (vtu("meshio-text.vtu"), vtu("vtk-appended-64.vtu"));
    let second = "found a second VTKFile, expected the end of the file";
    for (name, text, nothing, words) in [
        (
            "a.mesh",
            medit.as_bytes(),
            &b"\n# a comment\n"[..],
            "line 13: found \"MeshVersionFormatted\", expected the end of the file after End",
        ),
        (
            "a.bdf",
            nastran.as_bytes(),
            b"\n$ a comment\n",
            "line 8: found \"BEGIN BULK\" after ENDDATA, expected the end of the file",
        ),
        (
            "a.meshb",
            &binary,
            &[0; 4],
            "found bytes after the keyword End (54), expected none",
        ),
        ("text.vtu", &text, b"\n<!-- a comment -->\n", second),
        ("appended.vtu", &appended, b"\n", second),
    ] {
        let path = folder.path().join(name);
        for (rest, expected) in [(nothing, 0), (text, 2)] {
            std::fs::write(&path, [text, rest].concat()).expect("written");
            let (code, _, err) = certify(&path.to_string_lossy(), &[]);
            assert_eq!(code, expected, "{name}: {err}");
            assert_eq!(err.contains(words), code == 2, "{name}: {err}");
        }
    }
}

/// The format is named even if an option says that it is a mesh or a crystal.
#[test]
fn unknown_formats_are_named_before_options_are_checked() {
    let folder = tempfile::tempdir().expect("a folder");
    // Ten vertices of PLY2 look like vectors, counts and positions of a POSCAR.
    let ply = format!(
        "8\n12\n{}{}",
        "0 0 1\n1 1 0\n".repeat(4),
        "3 0 1 2\n".repeat(12)
    );
    for (name, text, words) in [
        (
            "a.wkt",
            "TIN (((0 0 0, 1 0 0, 0 1 0, 0 0 0)))",
            "well-known text",
        ),
        ("a.ply2", &ply, "PLY2"),
        (
            "a.in",
            "lattice_vector 1 0 0\natom 0 0 0 C\n",
            "the format is not known",
        ),
    ] {
        let path = file(folder.path(), name, text);
        for option in ["--bounded", "--special"] {
            let (code, _, err) = certify(&path.to_string_lossy(), &[option]);
            assert_eq!(code, 2, "{name}");
            assert!(err.contains(words), "{name} {option}: {err}");
            assert!(err.contains("meshio converts"), "{name} {option}: {err}");
        }
    }
    let (code, _, err) = certify("fluent.msh", &["--bounded"]);
    assert_eq!(code, 2);
    assert!(err.contains("Fluent mesh"), "{err}");
}

/// Abaqus: a keyword goes on in the next line after a comma, and a comma in quotes separates nothing. A part
/// that is placed twice is no one list of elements.
#[test]
fn abaqus_keywords_may_have_several_lines() {
    let folder = tempfile::tempdir().expect("a folder");
    let text = "*PART, NAME=P\n*NODE,\nNSET=all\n1, 0,0,0\n2, 1,0,0\n3, 0,1,0\n4, 0,0,1\n\
                *ELEMENT, TYPE=C3D4,\n** a comment\n ELSET=\"a, b\"\n1, 1,2,3,4\n*END PART\n\
                *ASSEMBLY, NAME=A\n*INSTANCE, NAME=I, PART=P\n*END INSTANCE\n";
    let path = file(folder.path(), "a.inp", text);
    let (code, out, err) = certify(&path.to_string_lossy(), &[]);
    assert_eq!(code, 0, "{err}");
    assert!(out.contains("tag 1 \"a, b\": 1 tetrahedron"), "{out}");
    // A comma at the end, and data after it.
    let path = file(folder.path(), "b.inp", &text.replace("\nNSET=all", ""));
    assert_eq!(certify(&path.to_string_lossy(), &[]).0, 0);
    let second = format!("{text}*INSTANCE, NAME=J, PART=p\n5., 0., 0.\n*END INSTANCE\n");
    let path = file(folder.path(), "c.inp", &second);
    let (code, _, err) = certify(&path.to_string_lossy(), &[]);
    assert_eq!(code, 3, "{err}");
    assert!(
        err.contains("line 16: found a second *INSTANCE of the part \"p\""),
        "{err}"
    );
}
