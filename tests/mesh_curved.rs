//! Triangles of second order in the plane: each is decided alone, from every format that has them.

use super::common::file;
use super::mesh_answers::certify_text;
use super::mesh_cases::certify;

/// Corners and middle nodes of a curved triangle that is valid only with the middle nodes in the order 01,
/// 12, 02. In the other two rotations the Jacobian at corner 0 is -5 and -9/2.
const CURVED: [&str; 6] = ["0 0", "1 0", "0 1", "0.5 0.125", "0.5 0.5", "0 0.5"];

#[test]
fn curved_triangles_are_decided_one_by_one() {
    let folder = tempfile::tempdir().expect("a folder");
    let msh = |middle: &str, last: &str| {
        let nodes = ["0 0", "1 0", "0 1", middle, "0.5 0.5", "0 0.5"];
        let nodes: String = (1..)
            .zip(nodes)
            .map(|(k, node)| format!("{k} {node} 0\n"))
            .collect();
        format!(
            "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n6\n{nodes}$EndNodes\n$Elements\n1\n\
             1 9 2 1 1 1 2 3 4 {last}\n$EndElements\n"
        )
    };
    let certify = |text: &str| certify_text(folder.path(), "six.msh", text, &[]);
    let (code, out, err) = certify(&msh("0.5 0", "5 6"));
    assert_eq!(code, 0, "{err}");
    assert!(out.contains("1 simplex"), "{out}");
    let (code, out, err) = certify(&msh("0.5 0.125", "5 6"));
    assert_eq!(code, 0, "{err}");
    assert!(
        out.contains("each of the 1 triangles, of which 1 are of second order and curved"),
        "{out}"
    );
    // The edge from 1 to 2 with its middle node at 3/4, and middle nodes in the wrong order.
    for text in [msh("0.75 0", "5 6"), msh("0.5 0.125", "6 5")] {
        let (code, _, err) = certify(&text);
        assert_eq!(code, 3, "{err}");
        assert!(
            err.contains("its Jacobian at node")
                && err.contains("of 1 triangle, 1 is not proved valid"),
            "{err}"
        );
    }
    // The other orientation.
    let turned = msh("0.5 0.125", "5 6").replace("1 2 3 4 5 6\n", "1 3 2 6 5 4\n");
    assert_eq!(certify(&turned).0, 3);
    let (code, out, err) = certify_text(folder.path(), "six.msh", &turned, &["--reorient"]);
    assert_eq!(code, 0, "{out}{err}");
    // A middle node outside of the plane.
    let (code, _, err) = certify(&msh("0.5 0.125", "5 6").replace("0.5 0.5 0", "0.5 0.5 0.25"));
    assert_eq!(code, 2, "{err}");
    assert!(err.contains("in no plane z = constant"), "{err}");
}

/// Gmsh's disk has seven triangles with a curved side each; Gmsh's least value of the Jacobian is 0.78.
#[test]
fn curved_triangles_of_all_formats() {
    for extension in ["msh", "mesh", "vtk", "bdf", "inp"] {
        let (code, out, err) = certify(&format!("gmsh_disk2.{extension}"), &[]);
        assert_eq!(code, 0, "{extension}: {err}");
        assert!(
            out.contains("each of the 7 triangles"),
            "{extension}: {out}"
        );
    }
    let folder = tempfile::tempdir().expect("a folder");
    let valid = |name: &str, text: &str| {
        let (code, out, err) = certify_text(folder.path(), name, text, &[]);
        assert_eq!(code, 0, "{name}: {err}");
        assert!(
            out.contains("1 are of second order and curved"),
            "{name}: {out}"
        );
    };
    let rows: String = (1..)
        .zip(CURVED)
        .map(|(k, node)| format!("{k} {node}\n"))
        .collect();
    file(folder.path(), "t.node", &format!("6 2 0 0\n{rows}"));
    // Triangle has the middle nodes on the edges 12, 02 and 01.
    valid("t.ele", "1 6 0\n1 1 2 3 5 6 4\n");
    let vertices = CURVED.map(|node| format!("{node} 0\n")).concat();
    let text = format!(
        "MeshVersionFormatted 2\nDimension 2\nVertices\n6\n{vertices}TrianglesP2\n1\n1 2 3 4 5 6 7\nEnd\n"
    );
    valid("t.mesh", &text);
    let other = text.replace("End", "TrianglesP2Ordering\n6\n2 0 0 0 2 0\nEnd");
    let (code, _, err) = certify_text(folder.path(), "t.mesh", &other, &[]);
    assert_eq!(code, 3, "{err}");
    assert!(err.contains("TrianglesP2Ordering"), "{err}");
}
