//! Words about meshes: short numbers unless long ones are asked for, the words of the plane, options that
//! change nothing.

use super::common::{acutile, code, file, stderr, stdout};
use super::mesh_answers::{certify_text, msh};
use super::mesh_cases::certify;

/// `show` writes long numbers only with --exact and in JSON: doubles near 0.1 have squared edges with many
/// digits.
#[test]
fn show_writes_long_numbers_in_full_only_if_asked() {
    let folder = tempfile::tempdir().expect("a folder");
    let points = [[0., 0., 0.], [0.1, 0.3, 0.], [0., 0.1, 0.], [0., 0., 0.7]];
    let path = file(
        folder.path(),
        "a.msh",
        &msh(&points, &[[0, 1, 2, 3]], |_| 1),
    );
    let show = |options: &[&str]| {
        let path = path.to_string_lossy();
        let output = acutile([&["show", &*path], options].concat());
        assert_eq!(code(&output), 0, "{}", stderr(&output));
        stdout(&output)
    };
    // 0.1^2 + 0.3^2 of the doubles is this fraction.
    let whole = "129807421463370683507503004437709/1298074214633706907132624082305024";
    assert!(show(&[]).contains("squared edge about 0.100000000 with"));
    assert!(!show(&[]).contains(whole));
    assert!(show(&["--exact"]).contains(whole));
    assert!(show(&["--json"]).contains(whole));
}

/// Two triangles of the plane with one common corner: the boundary is no manifold at a vertex.
#[test]
fn places_in_the_plane_have_the_words_of_the_plane() {
    let folder = tempfile::tempdir().expect("a folder");
    let text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n5\n1 0 0 0\n2 1 0 0\n3 0 1 0\n\
                4 -1 0 0\n5 0 -1 0\n$EndNodes\n$Elements\n2\n1 2 2 1 1 1 2 3\n2 2 2 1 1 1 4 5\n\
                $EndElements\n";
    let (code, out, err) = certify_text(folder.path(), "two.msh", text, &[]);
    assert_eq!(code, 0, "{err}");
    assert!(
        out.contains("no manifold at 1 vertex\n") && out.contains("node 1 is in 4 boundary edges"),
        "{out}"
    );
    let required = ["--require", "manifold-boundary"];
    let (code, out, _) = certify_text(folder.path(), "two.msh", text, &required);
    assert_eq!(code, 1);
    let expected = "1 vertex is in another number of boundary edges than 2 ([node 1])\n";
    assert!(out.contains(expected), "{out}");
}

/// The coordinates of corners are short, too, unless --exact is given: 0.1 is 3602879701896397/2^55. Equal
/// elements are named with their labels.
#[test]
fn corners_are_written_in_full_with_exact_and_duplicates_have_labels() {
    let folder = tempfile::tempdir().expect("a folder");
    let points = [[0., 0., 0.], [0.1, 0., 0.], [0., 1., 0.], [0., 0., 1.]];
    let text = msh(&points, &[[0, 1, 2, 3]; 2], |cell| cell + 5);
    let (code, out, _) = certify_text(folder.path(), "twice.msh", &text, &[]);
    assert_eq!(code, 1);
    assert!(
        out.contains("with tag 5, element 2") && out.contains("with tag 6 have the same corners"),
        "{out}"
    );
    let whole = "2 at (3602879701896397/36028797018963968, 0, 0)";
    assert!(out.contains("2 at (about 0.100000000, 0, 0)"), "{out}");
    let (_, out, _) = certify_text(folder.path(), "twice.msh", &text, &["--exact"]);
    assert!(out.contains(whole), "{out}");
}

/// A lattice that nothing uses is named, and what uses it writes links.
#[test]
fn a_lattice_between_mesh_files_is_not_used_without_a_word() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name).to_string_lossy().into_owned();
    let (cell, links) = (path("a15.vtk"), path("a15.msh"));
    assert_eq!(code(&acutile(["convert", "a15", &cell])), 0);
    let lattice = ["--lattice", "4,0,0;0,4,0;0,0,4"];
    let plain = acutile([&["convert", &cell, &links], &lattice[..]].concat());
    assert_eq!(code(&plain), 0);
    assert!(
        stderr(&plain).contains("--lattice is not used"),
        "{}",
        stderr(&plain)
    );
    let used = [
        &["convert", &cell, &links, "--supercell", "1,1,1"],
        &lattice[..],
    ]
    .concat();
    let used = acutile(&used);
    assert_eq!(code(&used), 0);
    assert!(!stderr(&used).contains("is not used"), "{}", stderr(&used));
    let (code, out, err) = certify(&links, &["--require", "tcp"]);
    assert_eq!(code, 0, "{out}{err}");
}
