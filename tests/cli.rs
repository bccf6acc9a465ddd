//! The programs as a user meets them: exit codes, messages, files and pipes.

use crate::common::{acutile, acutile_verify, code, file, kuhn, stderr, stdout};
use serde_json::Value;
use std::io::{Read, Write};
use std::path::Path;
use std::process::{Command, Stdio};
use tempfile::TempDir;

fn directory() -> TempDir {
    tempfile::tempdir().expect("a temporary directory")
}

fn text(path: &Path) -> &str {
    path.to_str().expect("a path in UTF-8")
}

#[test]
fn certify_writes_what_the_verifier_confirms() {
    let place = directory();
    for name in ["a15.cbor", "a15.json"] {
        let certificate = place.path().join(name);
        let proved = acutile([
            "certify",
            "a15",
            "--require",
            "acute",
            "-o",
            text(&certificate),
        ]);
        assert_eq!(code(&proved), 0, "{}", stderr(&proved));
        assert!(stdout(&proved).starts_with("a15: proved: "));
        let verified = acutile(["verify", text(&certificate)]);
        assert_eq!(code(&verified), 0);
        let line = stdout(&verified);
        assert!(
            line.contains("46 tetrahedra") && line.contains("acute"),
            "{line}"
        );
        assert_eq!(line.lines().count(), 1);
    }
    // The kernel alone reads the certificate itself, which is the CBOR.
    let verified = acutile_verify([place.path().join("a15.cbor")]);
    assert_eq!(code(&verified), 0);
    let line = stdout(&verified);
    assert!(line.contains(": verified: 46 simplices"), "{line}");
    assert_eq!(line.lines().count(), 1);
    let refused = acutile_verify([place.path().join("a15.json")]);
    assert_eq!(code(&refused), 2);
    assert!(stdout(&refused).contains("`acutile verify F.json` reads JSON"));
}

#[test]
fn a_requirement_that_fails_is_a_refutation() {
    let refuted = acutile([
        "certify",
        "cube-6",
        "--require",
        "acute",
        "--max-defects",
        "3",
    ]);
    assert_eq!(code(&refuted), 1);
    let lines = stdout(&refuted);
    assert_eq!(
        lines.lines().next(),
        Some("cube-6: refuted: 18 right-angle")
    );
    assert_eq!(
        lines.lines().nth(1),
        Some("  right-angle: 18, the first 3:")
    );
    let told = lines
        .lines()
        .filter(|line| line.contains("is a right angle"));
    assert_eq!(told.count(), 3);
    // The coordinates of the corners, and what can be done about it.
    assert!(lines.contains("      simplex 0: 0 at (0, 0, 0), 0+(1, 0, 0) at (1, 0, 0)"));
    assert!(lines.contains("> no motion of a single corner makes simplex 0 acute"));
    // The largest angle of A15 is arccos(1/5) = 78.4630409671… degrees.
    for (input, requirement, expected) in [
        ("a15", "dihedral<78.46", 1),
        ("a15", "dihedral<78.46304096", 1),
        ("a15", "dihedral<78.46304097", 0),
        ("a15", "dihedral<78.47", 0),
        ("z", "dihedral<77.08", 0),
    ] {
        let output = acutile(["certify", input, "--require", requirement]);
        assert_eq!(code(&output), expected, "{input} {requirement}");
    }
}

#[test]
fn answers_in_json_are_one_object_for_each_input() {
    let refuted = acutile(["certify", "cube-6", "a15", "--require", "acute", "--json"]);
    assert_eq!(code(&refuted), 1);
    let answers: Vec<Value> = stdout(&refuted)
        .lines()
        .map(|line| serde_json::from_str(line).expect("an object"))
        .collect();
    assert_eq!(answers[0]["verdict"], "refuted");
    assert_eq!(answers[0]["counts"]["right-angle"], 18);
    assert_eq!(answers.len(), 2);
    assert_eq!(answers[0]["input"], "cube-6");
    let defects = answers[0]["defects"].as_array().expect("defects");
    assert_eq!(defects.len(), 18);
    let first = &defects[0];
    assert_eq!(first["code"], "right-angle");
    assert_eq!(first["product"], "0");
    assert_eq!(first["degrees"], serde_json::json!(["90", "90"]));
    assert_eq!(first["corners"].as_array().map(Vec::len), Some(4));
    let place = &first["places"][0];
    assert_eq!(place["name"], "simplex 0");
    assert_eq!(place["coordinates"][0], serde_json::json!(["0", "0", "0"]));
    assert_eq!(answers[1]["verdict"], "proved");
    assert_eq!(answers[1]["simplices"], 46);
}

#[test]
fn the_worst_outcome_decides_the_exit_code() {
    let refuted_and_failed = acutile(["certify", "no-such-name", "cube-6", "--require", "acute"]);
    assert_eq!(code(&refuted_and_failed), 1);
    assert_eq!(code(&acutile(["certify", "no-such-name", "a15"])), 2);
    let message = stderr(&acutile(["certify", "no-such-name"]));
    assert_eq!(
        message,
        "acutile: no-such-name: neither a name of the catalogue (acutile list) nor a file\n"
    );
}

#[test]
fn usage_errors_have_exit_code_2() {
    for arguments in [
        vec![],
        vec!["certify"],
        vec!["frobnicate"],
        vec!["certify", "a15", "--require", "pretty"],
        vec!["certify", "a15", "--require", "dihedral<0"],
        vec!["certify", "a15", "--require", "dihedral<181"],
        vec!["certify", "a15", "--require", "dihedral<sqrt(2)"],
        vec!["export", "a15", "--supercell", "2,2"],
        vec!["export", "a15", "--supercell", "0,1,1"],
    ] {
        let output = acutile(&arguments);
        assert_eq!(code(&output), 2, "{arguments:?}");
        assert!(!stderr(&output).is_empty(), "{arguments:?}");
    }
    assert_eq!(code(&acutile(["--help"])), 0);
    assert_eq!(code(&acutile(["--version"])), 0);
}

#[test]
fn files_that_cannot_be_read_are_named() {
    let place = directory();
    let empty = file(place.path(), "empty.json", "");
    let binary = place.path().join("binary.json");
    std::fs::write(&binary, [0x7b, 0xff, 0xfe]).expect("written");
    let through_a_file = empty.join("x.json");
    let cases = [
        (place.path().to_path_buf(), "cannot be read"),
        (place.path().join("missing.json"), "cannot be read"),
        (through_a_file, "cannot be read"),
        (empty, "is empty"),
        (binary, "byte 1 is not UTF-8"),
    ];
    for (path, expected) in cases {
        let output = acutile(["certify", text(&path)]);
        assert_eq!(code(&output), 2);
        let message = stderr(&output);
        assert!(
            message.contains(text(&path)) && message.contains(expected),
            "{message}"
        );
        assert_eq!(code(&acutile_verify([&path])), 2);
    }
}

/// The superuser may read everything, so this speaks only to others.
#[cfg(unix)]
#[test]
fn a_file_without_read_permission_is_named() {
    use std::os::unix::fs::PermissionsExt;
    let place = directory();
    let path = file(place.path(), "secret.json", "{}");
    std::fs::set_permissions(&path, std::fs::Permissions::from_mode(0o000)).expect("permissions");
    let expected = match std::fs::File::open(&path) {
        Ok(_) => "the member \"format\" is missing",
        Err(_) => "cannot be read: Permission denied",
    };
    let output = acutile(["certify", text(&path)]);
    assert_eq!(code(&output), 2);
    assert!(stderr(&output).contains(expected), "{}", stderr(&output));
}

#[cfg(target_os = "linux")]
#[test]
fn places_that_cannot_be_written_leave_nothing_behind() {
    let full = acutile(["certify", "a15", "-o", "/dev/full"]);
    assert_eq!(code(&full), 2);
    assert!(
        stderr(&full).contains("/dev/full: cannot be written"),
        "{}",
        stderr(&full)
    );
    assert_eq!(
        code(&acutile(["certify", "a15", "-o", "/proc/a15.json"])),
        2
    );
    assert_eq!(
        code(&acutile(["export", "a15", "-o", "/no/such/place/a15.json"])),
        2
    );
    for command in [
        &["gallery"][..],
        &["appendix", "bcc"],
        &["certify", "bcc", "a15"],
    ] {
        let answer = acutile([command, &["-o", "/proc/several"]].concat());
        assert_eq!(code(&answer), 2, "{command:?}");
        let text = stderr(&answer);
        assert!(
            text.contains("/proc/several: cannot be written: "),
            "{text}"
        );
        assert!(!stdout(&answer).contains("proved"), "{command:?}");
    }
    let stdout_full = Command::new(env!("CARGO_BIN_EXE_acutile"))
        .args(["export", "a15"])
        .stdout(
            std::fs::File::options()
                .write(true)
                .open("/dev/full")
                .expect("/dev/full"),
        )
        .output()
        .expect("it runs");
    assert_eq!(code(&stdout_full), 2);
    let place = directory();
    assert_eq!(
        code(&acutile(["export", "a15", "-o", text(place.path())])),
        2
    );
    assert_eq!(
        std::fs::read_dir(place.path()).expect("readable").count(),
        0
    );
}

#[test]
fn standard_input_and_output_are_files_too() {
    let mut child = Command::new(env!("CARGO_BIN_EXE_acutile"))
        .args(["certify", "-", "-o", "-"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("it runs");
    child
        .stdin
        .take()
        .expect("piped")
        .write_all(kuhn().to_string().as_bytes())
        .expect("taken");
    let output = child.wait_with_output().expect("it ends");
    assert_eq!(code(&output), 0);
    // The certificate alone, so that it can be piped on.
    let certificate: Value = serde_json::from_slice(&output.stdout).expect("JSON alone");
    assert_eq!(certificate["format"], "acutile-certificate");
    assert!(stderr(&output).contains("proved"));
}

#[test]
fn a_reader_that_leaves_early_is_no_error() {
    let mut child = Command::new(env!("CARGO_BIN_EXE_acutile"))
        .args(["export", "a15", "--supercell", "6,6,6"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("it runs");
    let mut first = [0; 10];
    child
        .stdout
        .take()
        .expect("piped")
        .read_exact(&mut first)
        .expect("ten bytes");
    let output = child.wait_with_output().expect("it ends");
    assert_eq!((code(&output), stderr(&output)), (0, String::new()));
}

#[test]
fn a_certificate_does_not_replace_its_input() {
    let place = directory();
    let path = file(place.path(), "kuhn.json", &kuhn().to_string());
    let before = std::fs::read(&path).expect("readable");
    for target in [text(&path), text(place.path())] {
        let output = acutile(["certify", text(&path), "-o", target]);
        assert_eq!(code(&output), 2);
        assert!(
            stderr(&output).contains("would overwrite the input"),
            "{}",
            stderr(&output)
        );
        assert_eq!(std::fs::read(&path).expect("readable"), before);
    }
}

#[cfg(unix)]
#[test]
fn a_link_stays_and_what_it_points_to_is_written() {
    let place = directory();
    let real = file(place.path(), "real.json", "old");
    for name in ["link.json", "link.cbor"] {
        let link = place.path().join(name);
        std::os::unix::fs::symlink(&real, &link).expect("a link");
        assert_eq!(code(&acutile(["certify", "bcc", "-o", text(&link)])), 0);
        assert!(link.symlink_metadata().expect("there").is_symlink());
        assert_eq!(code(&acutile(["verify", text(&real)])), 0, "{name}");
    }
    assert_eq!(code(&acutile_verify([&real])), 0, "CBOR is there last");
}

#[test]
fn limits_and_unknown_versions_are_declined() {
    let place = directory();
    let tomorrow = kuhn()
        .to_string()
        .replacen("\"version\":1", "\"version\":2", 1);
    assert_eq!(
        code(&acutile([
            "certify",
            text(&file(place.path(), "a.json", &tomorrow))
        ])),
        3
    );
    let large = kuhn()
        .to_string()
        .replacen("[0,0,0]", "[\"1e9999999\",0,0]", 1);
    assert_eq!(
        code(&acutile([
            "certify",
            text(&file(place.path(), "b.json", &large))
        ])),
        3
    );
}

#[test]
fn a_pipe_shows_no_progress() {
    let output = acutile(["certify", "a15"]);
    assert_eq!(stderr(&output), "");
    assert!(!stdout(&output).contains('\r') && !stdout(&output).contains('\u{1b}'));
}

#[test]
fn several_certificates_go_into_a_directory() {
    let place = directory();
    let target = place.path().join("new");
    let output = acutile(["certify", "a15", "cube-6", "-o", text(&target)]);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    for name in ["a15.json", "cube-6.json"] {
        assert_eq!(code(&acutile(["verify", text(&target.join(name))])), 0);
    }
}

#[test]
fn delaunay_takes_points_and_gives_a_tiling() {
    let place = directory();
    let points = r#"{"format": "acutile-points", "version": 1, "dimension": 3,
        "lattice": {"gram": [[3, -1, -1], [-1, 3, -1], [-1, -1, 3]]}, "points": [[0, 0, 0]]}"#;
    let bcc = file(place.path(), "bcc.json", points);
    let tiling = place.path().join("tiling.json");
    assert_eq!(
        code(&acutile(["delaunay", text(&bcc), "-o", text(&tiling)])),
        0
    );
    let proved = acutile(["certify", text(&tiling), "--require", "delaunay", "--json"]);
    let answer: Value = serde_json::from_str(&stdout(&proved)).expect("an object");
    // The Delaunay triangulation of bcc has six disphenoids for each point.
    assert_eq!(answer["simplices"], 6);
    let confused = acutile(["delaunay", text(&tiling)]);
    assert_eq!(code(&confused), 2);
    assert!(stderr(&confused).contains("is a tiling file, expected a point-set file"));
    let at_once = acutile(["certify", text(&bcc), "--require", "delaunay", "--json"]);
    assert!(
        stderr(&at_once).contains("a point set with 1 point in a cell; the tiling is its Delaunay")
    );
    let at_once: Value = serde_json::from_str(&stdout(&at_once)).expect("an object");
    assert_eq!(at_once["certificate"], answer["certificate"]);
}

#[test]
fn cospherical_points_are_listed_or_cut_on_request() {
    let place = directory();
    let points = r#"{"format": "acutile-points", "version": 1, "dimension": 3,
        "lattice": {"gram": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]}, "points": [["1/2", "1/2", "1/2"]]}"#;
    let cubic = file(place.path(), "cubic.json", points);
    let refused = acutile(["delaunay", text(&cubic)]);
    assert_eq!(code(&refused), 3);
    assert!(
        stderr(&refused).contains("8 points with squared radius 3/4"),
        "{}",
        stderr(&refused)
    );
    let cut = acutile(["delaunay", text(&cubic), "--triangulate"]);
    let tiling: Value = serde_json::from_str(&stdout(&cut)).expect("a tiling file");
    assert_eq!(tiling["simplices"].as_array().map(Vec::len), Some(6));
}

#[test]
fn every_name_of_the_catalogue_is_shown_and_exported_and_read_back() {
    let place = directory();
    for line in stdout(&acutile(["list", "--json"])).lines() {
        let entry: Value = serde_json::from_str(line).expect("an object");
        let name = match entry["name"].as_str().expect("a name") {
            "box:" => "box:1,1,1",
            "kagome:" => "kagome:z+-",
            "square-triangle:" => "square-triangle:3464",
            "z-c15:" => "z-c15:33344",
            "triangle-tiling:" => "triangle-tiling:2,2,sqrt(3)",
            name => name,
        };
        assert_eq!(code(&acutile(["show", name])), 0, "{name}");
        if entry["box"] == true || entry["theorem"] == true {
            assert_eq!(code(&acutile(["certify", name])), 0, "{name}");
            let exported = acutile(["export", name]);
            assert_eq!(code(&exported), 2, "{name}");
            assert!(stderr(&exported).contains("certify"), "{name}");
            continue;
        }
        let path = place.path().join("exported.json");
        assert_eq!(
            code(&acutile(["export", name, "-o", text(&path)])),
            0,
            "{name}"
        );
        let (a, b) = (place.path().join("a.json"), place.path().join("b.json"));
        assert_eq!(
            code(&acutile(["certify", name, "-o", text(&a)])),
            0,
            "{name}"
        );
        let mut again = vec!["certify", text(&path), "-o", text(&b)];
        // A tiling file has no statements, and the catalogue names planes for this one.
        if name == "cube-space" {
            again.extend(["--require", "plane:x2+x3=0,plane:x1+x3=0,plane:x1+x2=0"]);
        }
        assert_eq!(code(&acutile(&again)), 0, "{name}");
        assert_eq!(
            std::fs::read(a).expect("a"),
            std::fs::read(b).expect("b"),
            "{name}"
        );
    }
}

#[test]
fn parameters_are_exact_numbers_of_the_entries_that_take_one() {
    for (name, parameter, expected) in [
        ("goldberg-1", "3/7", 0),
        ("goldberg-1", "sqrt(2)/4", 0),
        ("goldberg-3", "sqrt(2)/4", 0),
        // The third arrangement is not face to face for other ratios.
        ("goldberg-3", "1/2", 1),
        ("goldberg-1", "0", 2),
        ("goldberg-1", "-1", 2),
        ("goldberg-1", "one", 2),
        ("a15", "1", 2),
        ("kagome:z", "1", 2),
    ] {
        let option = format!("--param={parameter}");
        let output = acutile(["certify", name, &option]);
        assert_eq!(code(&output), expected, "{name} {parameter}");
        assert_eq!(stderr(&output).contains(name), expected == 2, "{name}");
    }
    assert_eq!(code(&acutile(["certify", "--all", "--param", "1"])), 2);
    assert_eq!(code(&acutile(["show", "two-corners", "--param", "1/9"])), 0);
    assert_eq!(code(&acutile(["export", "two-corners", "--param", "x"])), 2);
    let place = directory();
    let path = file(place.path(), "kuhn.json", &kuhn().to_string());
    assert_eq!(code(&acutile(["show", text(&path), "--param", "1"])), 2);
}

#[test]
fn plane_tilings_come_from_files() {
    let place = directory();
    let rows = r#"{"format": "acutile-plane-tiling", "version": 1,
        "lattice": [[1, 0, 0, 0], [0, 0, 1, 1]], "vertices": [[0, 0, 0, 0], [0, 0, 0, 1]]}"#;
    let certify = |family: &str, content: &str| {
        let path = file(place.path(), "plane.json", content);
        acutile(["certify", &format!("{family}:{}", text(&path)), "--json"])
    };
    for family in ["square-triangle", "z-c15"] {
        let output = certify(family, rows);
        assert_eq!(code(&output), 0, "{}", stderr(&output));
        assert!(stdout(&output).contains("TCP"));
    }
    for (from, to, message) in [
        // A row of squares that slides by half of a side is not of this form; by another vertex
        // it has wrong angles.
        ("[0, 0, 1, 1]]", "[0, 1, 0, 1]]", "degrees apart"),
        ("[0, 0, 0, 1]]}", "[0, 0, 0, 2]]}", "degrees apart"),
        (
            "[0, 0, 0, 1]]}",
            "[0, 0, 1, 1]]}",
            "differ by a lattice vector",
        ),
        (
            "[0, 0, 0, 1]]}",
            "[0, 0, 0, 9223372036854775807]]}",
            "at most 100000",
        ),
        (
            "[0, 0, 0, 1]]}",
            "[0, 0, 0]]}",
            "plane.json:2:85: vertices[1]: found 3 entries, expected 4",
        ),
        ("[[0, 0, 0, 0], [0, 0, 0, 1]]", "[]", "vertices: found none"),
        (
            "\"version\": 1",
            "\"version\": 2",
            "version is 2, expected 1",
        ),
        ("[0, 0, 1, 1]]", "[2, 0, 0, 0]]", "degrees apart"),
    ] {
        let content = rows.replace(from, to);
        assert_ne!(content, rows, "{from}");
        let output = certify("square-triangle", &content);
        // As for tiling files, a version of tomorrow is declined.
        let expected = if to.contains("version") { 3 } else { 2 };
        assert_eq!(code(&output), expected, "{to}");
        assert!(stdout(&output).contains(message), "{}", stdout(&output));
    }
    assert_eq!(
        code(&acutile(["certify", "square-triangle:no-such-file"])),
        2
    );
    assert_eq!(code(&acutile(["certify", "square-triangle:"])), 2);
}

#[test]
fn completions_and_manual_are_generated() {
    assert!(stdout(&acutile(["completions", "bash"])).contains("_acutile"));
    for shell in ["bash", "zsh", "fish"] {
        let script = stdout(&acutile(["completions", shell]));
        let names = ["a15", "c14-best", "weakly-delaunay"];
        assert!(names.iter().all(|name| script.contains(name)), "{shell}");
    }
    assert!(stdout(&acutile(["man"])).contains(".TH"));
}

/// The prover's word alone says so, and has the same verdicts.
#[test]
fn without_a_certificate() {
    let proved = acutile(["certify", "a15", "--no-certificate"]);
    assert_eq!(code(&proved), 0);
    let line = stdout(&proved);
    assert!(
        line.contains("by the prover alone, no certificate"),
        "{line}"
    );
    assert!(
        line.contains("all dihedral angles are at most arccos(1/5) = 78.4630... degrees, attained"),
        "{line}"
    );
    let refuted = acutile([
        "certify",
        "cube-6",
        "--no-certificate",
        "--require",
        "acute",
    ]);
    assert_eq!(code(&refuted), 1);
    let data: Value = serde_json::from_str(&stdout(&acutile([
        "certify",
        "a15",
        "--no-certificate",
        "--json",
    ])))
    .expect("an object");
    assert_eq!(data["kernel"], false);
    assert_eq!(
        code(&acutile(["certify", "a15", "--no-certificate", "-o", "x"])),
        2
    );
}

/// 1000 thin cones with one common apex, which are legitimate: too many pairs of facets are close
/// to each other, and that is declined at once.
#[test]
fn a_fan_of_many_tetrahedra_is_declined() {
    let mut vertices = vec![serde_json::json!([0, 0, 0])];
    let mut simplices = Vec::new();
    for i in 0..1000 {
        let (first, y) = (vertices.len(), 10 * i);
        for point in [[100, y, 0], [100, y + 4, 0], [100, y, 4]] {
            vertices.push(serde_json::json!(point));
        }
        simplices.push(serde_json::json!([0, first, first + 1, first + 2]));
    }
    let place = tempfile::tempdir().expect("a directory");
    let path = place.path().join("fan.json");
    let tiling = serde_json::json!({
        "format": "acutile-tiling", "version": 1, "dimension": 3, "domain": "region",
        "vertices": vertices, "simplices": simplices,
    });
    std::fs::write(&path, tiling.to_string()).expect("written");
    let declined = acutile(["certify", path.to_str().expect("UTF-8")]);
    assert_eq!(code(&declined), 3, "{}", stdout(&declined));
    assert!(stderr(&declined).contains("too many facets close to each other"));
}

/// 25 tetrahedra apart from each other, with edges from 1 to 25: 25 shapes.
#[test]
fn show_lists_all_shapes_if_it_is_asked() {
    let (mut vertices, mut simplices) = (Vec::new(), Vec::new());
    for k in 1..=25 {
        let (first, x) = (vertices.len(), 100 * k);
        for point in [[x, 0, 0], [x + k, 0, 0], [x, k, 0], [x, 0, k]] {
            vertices.push(serde_json::json!(point));
        }
        simplices.push(serde_json::json!([first, first + 1, first + 2, first + 3]));
    }
    let place = tempfile::tempdir().expect("a directory");
    let path = place.path().join("many.json");
    let tiling = serde_json::json!({
        "format": "acutile-tiling", "version": 1, "dimension": 3, "domain": "region",
        "vertices": vertices, "simplices": simplices,
    });
    // A byte order mark before our own JSON is passed over.
    std::fs::write(&path, format!("\u{feff}{tiling}")).expect("written");
    let path = path.to_str().expect("UTF-8");
    let few = stdout(&acutile(["show", path]));
    assert!(
        few.contains("and 5 more of 25 shapes; --all lists them"),
        "{few}"
    );
    let all = stdout(&acutile(["show", path, "--all"]));
    assert!(!all.contains("--all"), "{all}");
    for (text, count) in [(few, 20), (all, 25)] {
        let shapes = text.matches("1 simplex:\n  squared edge ");
        assert_eq!(shapes.count(), count, "{text}");
    }
}

#[test]
fn a_deeply_nested_vtu_file_is_refused() {
    let place = tempfile::tempdir().expect("a directory");
    let path = place.path().join("deep.vtu");
    std::fs::write(&path, "<a>".repeat(100_000)).expect("written");
    let refused = acutile(["certify", path.to_str().expect("UTF-8")]);
    assert_eq!(code(&refused), 2);
    assert!(
        stderr(&refused).contains("more than 64 deep"),
        "{}",
        stderr(&refused)
    );
}

#[test]
fn a_gallery_is_not_written_among_foreign_files() {
    let place = tempfile::tempdir().expect("a directory");
    let index = place.path().join("index.html");
    std::fs::write(&index, "mine").expect("written");
    let refused = acutile(["gallery", "-o", place.path().to_str().expect("UTF-8")]);
    assert_eq!(code(&refused), 2);
    assert!(stderr(&refused).contains("--force"));
    assert_eq!(std::fs::read_to_string(&index).expect("kept"), "mine");
}

/// What is converted is not replaced by what comes of it.
#[test]
fn convert_does_not_overwrite_its_input() {
    let place = tempfile::tempdir().expect("a directory");
    let path = place.path().join("a15.msh");
    let path = path.to_str().expect("UTF-8");
    assert_eq!(code(&acutile(["convert", "a15", path])), 0);
    assert_eq!(code(&acutile(["convert", path, path])), 2);
}

/// `show` judges no certificate, and does not call a claim a theorem.
#[test]
fn show_calls_no_claim_of_a_file_a_theorem() {
    let path = "tests/certificates/false/triangle-valence--patches-in-a-join.json";
    let shown = stdout(&acutile(["show", path]));
    assert!(shown.contains("claim, not verified here: "), "{shown}");
    assert!(!shown.contains("a theorem: "), "{shown}");
    assert!(stdout(&acutile(["show", "kagome-all"])).contains("a theorem: "));
}

/// The Gram matrix [[1/2, 1/4], [1/4, 3/4]] has the squared sides 1/2, 3/4 and 3/4. So the angles are arccos(2/3) and
/// twice arccos(1/√6).
#[test]
fn show_names_the_smallest_and_the_largest_angle_of_a_member() {
    let shown = stdout(&acutile(["show", "triangle-tiling-all"]));
    let words = "dihedral angles at x = 1/2, y = 1/2: smallest 48.189685 to 48.189686, \
                 largest 65.905157 to 65.905158";
    assert!(shown.contains(words), "{shown}");
}

/// An option that would be ignored is an error, which names the option and a way out.
#[test]
fn options_for_boxes_are_errors_where_they_do_not_apply() {
    let cases: [(&[&str], &str); 7] = [
        (
            &["square-triangle-all", "--maximal", "3"],
            "has no parameters",
        ),
        (
            &["kagome-all", "--free", "0", "--radius", "1/10"],
            "has no parameters",
        ),
        (&["square-triangle-all", "--within-su"], "has no parameters"),
        (
            &["z-all", "--free", "0", "--radius", "1/10"],
            "a family already",
        ),
        (&["a15", "--maximal", "1"], "--free with --radius"),
        (&["z-all", "--maximal", "x"], "a number for each parameter"),
        (&["z-all", "--fraction", "1/8"], "--maximal"),
    ];
    for (arguments, message) in cases {
        let output = acutile([&["certify"][..], arguments].concat());
        let said = stderr(&output);
        assert_eq!(code(&output), 2, "{arguments:?}: {said}");
        assert!(said.contains(message), "{arguments:?}: {said}");
    }
}
