//! `acutile quality` and its options, against figures by hand.
//!
//! `good_cube.vtk` is a cube in six tetrahedra, each with corners at 0, e_1, e_1 + e_2 and
//! e_1 + e_2 + e_3 for some order of the axes. Such a tetrahedron has dihedral angles of 45, 45, 60, 90, 90 and
//! 90 degrees, edges of length 1, √2 and √3, and the circumradius √3/2 = 0.86602...

use super::common::{acutile, code, file, stderr, stdout};
use serde_json::Value;

const CUBE: &str = concat!(
    env!("CARGO_MANIFEST_DIR"),
    "/tests/meshes/cases/good_cube.vtk"
);

fn quality(options: &[&str]) -> String {
    let output = acutile(["quality", CUBE].iter().chain(options));
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    stdout(&output)
}

fn json(options: &[&str]) -> Value {
    let text = quality(&[&["--json"], options].concat());
    serde_json::from_str(&text).expect("one JSON object")
}

#[test]
fn json_has_all_figures() {
    let data = json(&["--bin", "15"]);
    assert_eq!(data["input"], CUBE);
    assert_eq!(data["simplices"], 6);
    assert_eq!(
        data["kinds"],
        serde_json::json!({ "acute": 0, "right": 6, "obtuse": 0 })
    );
    assert_eq!(
        data["angles"],
        serde_json::json!({ "acute": 18, "right": 18, "obtuse": 0 })
    );
    // Bins of 15 degrees from 0: 45, 60 and 90 begin the bins 3, 4 and 6.
    let histogram: Vec<u64> = (0..12)
        .map(|bin| data["histogram"][bin].as_u64().expect("a count"))
        .collect();
    assert_eq!(histogram, [0, 0, 0, 12, 6, 0, 18, 0, 0, 0, 0, 0]);
    let smallest = &data["smallest_dihedral"];
    assert_eq!(smallest["bounds"], serde_json::json!(["45", "45"]));
    assert_eq!(smallest["count"], 12);
    let largest = &data["largest_dihedral"];
    assert_eq!(largest["bounds"], serde_json::json!(["90", "90"]));
    assert_eq!(largest["count"], 18);
    for ratio in ["least_radius_edge", "greatest_radius_edge"] {
        assert_eq!(data[ratio]["count"], 6);
        assert_eq!(data[ratio]["closed_form"], "√(3/4)");
    }
    // Longest edge √3; inradius 3 V / (sum of the areas) = (1/2) / (1/2 + 1/2 + √2/2 + √2/2) =
    // 1 / (2 + 2√2); over √24.
    let aspect = data["aspect"][0]["value"].as_f64().expect("a number");
    let expected = 3f64.sqrt() * (2.0 + 2.0 * 2f64.sqrt()) / 24f64.sqrt();
    assert!((aspect - expected).abs() < 1e-12, "{aspect}");
    assert_eq!(data["offenders"]["counts"], serde_json::json!({}));
}

/// A threshold belongs to the offenders: "at most" and "at least".
#[test]
fn offenders_are_counted_and_the_first_are_listed() {
    for (option, value, code, count) in [
        ("--below", "45", "angle-not-above", 12),
        ("--below", "60", "angle-not-above", 18),
        ("--below", "44.999", "", 0),
        ("--above", "90", "angle-not-below", 18),
        ("--above", "60", "angle-not-below", 24),
        ("--above", "90.001", "", 0),
        ("--ratio-above", "0.8660", "ratio-not-below", 6),
        ("--ratio-above", "0.8661", "", 0),
    ] {
        let data = json(&[option, value]);
        let counts = &data["offenders"]["counts"];
        let expected = match count {
            0 => serde_json::json!({}),
            _ => serde_json::json!({ code: count }),
        };
        assert_eq!(*counts, expected, "{option} {value}");
        let first = data["offenders"]["first"].as_array().expect("a list");
        assert_eq!(first.len(), count.min(20), "{option} {value}");
        let text = quality(&[option, value, "--max-offenders", "2"]);
        let listed = text
            .lines()
            .filter(|line| line.starts_with("  the ") || line.starts_with("  element "));
        assert_eq!(listed.count(), count.min(2), "{text}");
        let line = format!("{code}: {count}\n");
        assert!(count == 0 || text.contains(&line), "{text}");
    }
}

#[test]
fn wrong_thresholds_are_refused() {
    for (option, value) in [
        ("--below", "x"),
        ("--above", "181"),
        ("--ratio-above", ""),
        ("--bin", "7"),
        ("--bin", "0"),
    ] {
        let output = acutile(["quality", CUBE, option, value]);
        assert_eq!(code(&output), 2, "{option} {value}");
        assert!(stderr(&output).contains(option), "{}", stderr(&output));
    }
}

/// A flat element and a negative one are left out, and the others keep their numbers.
#[test]
fn flat_and_negative_elements_are_left_out() {
    let text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n5\n1 0 0 0\n2 1 0 0\n3 0 1 0\n\
                4 0 0 1\n5 1 1 0\n$EndNodes\n$Elements\n3\n7 4 2 1 1 1 2 3 5\n8 4 2 1 1 1 3 2 4\n\
                9 4 2 1 1 1 2 3 4\n$EndElements\n";
    let folder = tempfile::tempdir().expect("a folder");
    let path = file(folder.path(), "a.msh", text);
    let path = path.to_str().expect("UTF-8");
    let output = acutile(["quality", path, "--json", "--above", "90"]);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    let data: Value = serde_json::from_str(&stdout(&output)).expect("one JSON object");
    assert_eq!(
        data["left_out"],
        serde_json::json!(["element 7", "element 8"])
    );
    // The corner of a cube has three right angles.
    assert_eq!(data["largest_dihedral"]["count"], 3);
    let holder = &data["largest_dihedral"]["first"][0]["name"];
    assert_eq!(holder, "element 9");
    let first = data["offenders"]["first"][0].as_str().expect("a line");
    assert!(first.contains("element 9"), "{first}");
}

#[test]
fn a_metric_that_is_not_positive_is_refuted() {
    let directory = tempfile::tempdir().expect("a directory");
    let text = r#"{"format": "acutile-tiling", "version": 1, "dimension": 3,
        "lattice": {"gram": [[1, 0, 0], [0, 1, 0], [0, 0, -1]]}, "domain": "space",
        "vertices": [[0, 0, 0]],
        "simplices": [[[0, 0, 0, 0], [0, 1, 0, 0], [0, 1, 1, 0], [0, 1, 1, 1]]]}"#;
    let path = file(directory.path(), "metric.json", text);
    let output = acutile(["quality".as_ref(), path.as_os_str()]);
    assert_eq!(code(&output), 1);
    assert!(
        stderr(&output).contains("expected a positive number"),
        "{}",
        stderr(&output)
    );
}
