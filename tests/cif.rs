//! CIF on the command line: options, standard input, gzip, the example of the documentation.

use crate::common::{acutile, code, file, stderr, stdout};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

fn path(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("tests/cif/{name}.cif"))
}

fn text(name: &str) -> String {
    std::fs::read_to_string(path(name)).expect("a file of tests/cif")
}

#[test]
fn commands_take_a_cif() {
    let sigma = path("sigma");
    let sigma = sigma.to_str().expect("UTF-8");
    let proved = acutile(["certify", sigma, "--require", "acute", "--require", "tcp"]);
    assert_eq!(code(&proved), 0, "{}", stderr(&proved));
    assert!(stderr(&proved).contains(
        "a point set with 30 points in a cell; the tiling is its Delaunay triangulation"
    ));
    assert!(stdout(&proved).contains("172 tetrahedra"));
    let classified = acutile(["classify", sigma]);
    assert!(
        stdout(&classified)
            .contains("vertex types: 10 Z12, 16 Z14, 4 Z15\nTCP: yes\nisomorphic to: sigma")
    );
    assert!(stdout(&acutile(["show", sigma])).contains("30 vertices and 172 simplices in a cell"));

    let z = path("z");
    let z = z.to_str().expect("UTF-8");
    let refused = acutile(["certify", z]);
    assert_eq!(code(&refused), 2);
    assert!(stderr(&refused).contains("--special moves such sites"));
    let declined = acutile(["certify", z, "--as-written"]);
    assert_eq!(code(&declined), 3);
    assert!(
        stderr(&declined).contains("warning: 6 such pairs"),
        "{}",
        stderr(&declined)
    );
    assert_eq!(
        code(&acutile(["certify", z, "--special", "--require", "tcp"])),
        0
    );
    assert_eq!(
        code(&acutile(["certify", z, "--snap", "3", "--require", "tcp"])),
        0
    );
    assert_eq!(
        code(&acutile([
            "certify",
            z,
            "--as-written",
            "--triangulate",
            "--require",
            "acute"
        ])),
        1
    );

    let fcc = path("fcc");
    let fcc = fcc.to_str().expect("UTF-8");
    let declined = acutile(["delaunay", fcc]);
    assert_eq!(code(&declined), 3);
    assert!(stderr(&declined).contains("4 Delaunay cells are not simplices"));
    assert!(stderr(&declined).contains("--triangulate cuts them"));
    assert_eq!(code(&acutile(["certify", fcc, "--triangulate"])), 0);
    assert_eq!(
        code(&acutile([
            "certify",
            fcc,
            "--triangulate",
            "--require",
            "acute"
        ])),
        1
    );

    let wrong = acutile(["certify", "a15", "--snap", "3"]);
    assert_eq!(code(&wrong), 2);
    assert_eq!(
        stderr(&wrong),
        "acutile: a15: --snap is for a CIF, which this is not\n"
    );
}

/// Standard input, and gzip by extension, give the certificate of the plain file.
#[test]
fn standard_input_and_gzip() {
    let place = tempfile::tempdir().expect("a directory");
    let plain = acutile(["certify", path("a15").to_str().expect("UTF-8"), "-o", "-"]);
    assert_eq!(code(&plain), 0);
    let zipped = place.path().join("a15.cif.gz");
    std::fs::write(&zipped, gzip(text("a15").as_bytes())).expect("written");
    let unzipped = acutile(["certify", zipped.to_str().expect("UTF-8"), "-o", "-"]);
    assert_eq!(stdout(&unzipped), stdout(&plain));
    let directory = place.path().join("out");
    std::fs::create_dir(&directory).expect("a directory");
    let named = acutile([
        "certify",
        zipped.to_str().expect("UTF-8"),
        "-o",
        directory.to_str().expect("UTF-8"),
    ]);
    assert_eq!(code(&named), 0);
    assert!(directory.join("a15.json").exists());

    let mut child = Command::new(env!("CARGO_BIN_EXE_acutile"))
        .args(["certify", "-", "-o", "-"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .expect("acutile runs");
    child
        .stdin
        .take()
        .expect("a pipe")
        .write_all(text("a15").as_bytes())
        .expect("written");
    let piped = child.wait_with_output().expect("it ends");
    assert_eq!(stdout(&piped), stdout(&plain));
}

/// 300 MB of blanks fit into 1.4 MB of gzip, a ratio of 200: declined beyond 1 MiB and the ratio 100.
/// A plain file of 300 MB, a sparse one, is declined by its length.
#[test]
fn gzip_that_is_too_long_or_none() {
    let place = tempfile::tempdir().expect("a directory");
    let bomb = place.path().join("bomb.cif.gz");
    let mut encoder = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::fast());
    let blanks = vec![b' '; 1 << 20];
    for _ in 0..300 {
        encoder.write_all(&blanks).expect("compressed");
    }
    std::fs::write(&bomb, encoder.finish().expect("compressed")).expect("written");
    let declined = acutile(["certify", bomb.to_str().expect("UTF-8")]);
    assert_eq!(code(&declined), 3);
    let length = std::fs::metadata(&bomb).expect("a file").len();
    let expected = format!("expected at most {}", (1 << 20) + 100 * length);
    assert!(
        stderr(&declined).contains(&expected),
        "{}",
        stderr(&declined)
    );
    let plain = place.path().join("plain.cif");
    let sparse = std::fs::File::create(&plain).expect("a file");
    sparse.set_len(300 << 20).expect("sparse");
    let declined = acutile(["certify", plain.to_str().expect("UTF-8")]);
    assert_eq!(code(&declined), 3);
    assert!(
        stderr(&declined).ends_with("plain.cif: is longer than the limit of 268435456 bytes\n"),
        "{}",
        stderr(&declined)
    );
    let none = file(place.path(), "none.cif.gz", &text("a15"));
    let failed = acutile(["certify", none.to_str().expect("UTF-8")]);
    assert_eq!(code(&failed), 2);
    assert!(
        stderr(&failed).contains("cannot be read: invalid gzip header"),
        "{}",
        stderr(&failed)
    );
}

fn gzip(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::default());
    encoder.write_all(bytes).expect("compressed");
    encoder.finish().expect("compressed")
}

/// The lines of the example in docs/cif.md are the program's.
#[test]
fn the_documented_example() {
    let document = include_str!("../docs/cif.md");
    let run = |arguments: &[&str]| {
        let output = Command::new(env!("CARGO_BIN_EXE_acutile"))
            .args(arguments)
            .current_dir(path("z").parent().expect("a folder"))
            .output()
            .expect("acutile runs");
        format!("{}{}", stderr(&output), stdout(&output))
    };
    let place = tempfile::tempdir().expect("a directory");
    let target = place.path().join("z.json");
    let target = target.to_str().expect("UTF-8");
    let printed = [
        run(&["certify", "z.cif"]),
        run(&[
            "certify",
            "z.cif",
            "--special",
            "--require",
            "acute",
            "--require",
            "tcp",
            "-o",
            target,
        ]),
        run(&["classify", "z.cif", "--special"]),
    ];
    let printed = printed.concat().replace(target, "z.json");
    let words = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
    let (printed, mut count) = (words(&printed), 0);
    for block in document.split("```").skip(1).step_by(2) {
        // The lines between two commands or ellipses are one piece.
        for piece in block
            .split('\n')
            .filter(|line| !line.starts_with('$'))
            .collect::<Vec<_>>()
            .join("\n")
            .split('…')
        {
            assert!(printed.contains(&words(piece)), "{piece}");
            count += 1;
        }
    }
    assert!(count > 3);
}

/// Delaunay cells and Voronoi neighbours of simple lattices and packings, by hand. They are the cube, and
/// the prism over a triangle. A close packing has two tetrahedra and an octahedron for each atom, and bcc
/// has tetrahedra only.
#[test]
fn cells_that_are_not_cut() {
    let place = tempfile::tempdir().expect("a directory");
    let classify = |symbol: &str, [a, c]: [&str; 2], gamma: &str, site: &str| {
        let text = format!(
            "data_x\n_cell_length_a {a}\n_cell_length_b {a}\n_cell_length_c {c}\n_cell_angle_gamma {gamma}\n\
             _space_group_name_H-M_alt '{symbol}'\nloop_\n_atom_site_label\n_atom_site_fract_x\n_atom_site_fract_y\n\
             _atom_site_fract_z\nFe1 {site}\n"
        );
        let file = file(place.path(), "x.cif", &text);
        let output = acutile([
            "classify",
            file.to_str().expect("UTF-8"),
            "--special",
            "--json",
        ]);
        assert_eq!(code(&output), 0, "{}", stderr(&output));
        serde_json::from_str::<serde_json::Value>(&stdout(&output)).expect("JSON")
    };
    let hcp = ["1", "1.6329931619"];
    for (symbol, lengths, gamma, site, cells, neighbours, index, group) in [
        (
            "P m -3 m",
            ["1", "1"],
            "90",
            "0 0 0",
            [("cube", 1), ("", 0)],
            6,
            [0, 6, 0, 0],
            221,
        ),
        (
            "P 6/m m m",
            ["1", "1.1"],
            "120",
            "0 0 0",
            [("triangular prism", 2), ("", 0)],
            8,
            [0, 6, 0, 2],
            191,
        ),
        (
            "F m -3 m",
            ["1", "1"],
            "90",
            "0 0 0",
            [("octahedron", 4), ("tetrahedron", 8)],
            12,
            [0, 12, 0, 0],
            225,
        ),
        (
            "P 63/m m c",
            hcp,
            "120",
            "0.3333 0.6667 0.25",
            [("octahedron", 2), ("tetrahedron", 4)],
            12,
            [0, 12, 0, 0],
            194,
        ),
        (
            "I m -3 m",
            ["1", "1"],
            "90",
            "0 0 0",
            [("tetrahedron", 12), ("", 0)],
            14,
            [0, 6, 0, 8],
            229,
        ),
    ] {
        let report = classify(symbol, lengths, gamma, site);
        let expected: serde_json::Map<_, _> = cells
            .into_iter()
            .filter(|(_, count)| *count > 0)
            .map(|(name, count)| (name.to_owned(), serde_json::json!(count)))
            .collect();
        assert_eq!(
            report["cells"],
            serde_json::Value::Object(expected),
            "{symbol}"
        );
        assert_eq!(report["sites"][0]["neighbours"], neighbours, "{symbol}");
        assert_eq!(
            report["sites"][0]["voronoi_index"],
            serde_json::json!(index),
            "{symbol}"
        );
        assert_eq!(report["space_group"]["number"], group, "{symbol}");
        let is_compared = symbol == "I m -3 m";
        assert_eq!(report["isomorphic_to"].is_array(), is_compared, "{symbol}");
        assert!(
            report["notes"]
                .as_array()
                .is_some_and(|notes| notes.len() >= 2),
            "{symbol}"
        );
    }
}

/// Labels go into tiling files and are read there; a cut is not compared with the catalogue.
#[test]
fn labels_and_cuts() {
    let place = tempfile::tempdir().expect("a directory");
    let tiling = place.path().join("fcc.json");
    let target = tiling.to_str().expect("UTF-8");
    let fcc = path("fcc");
    let fcc = fcc.to_str().expect("UTF-8");
    assert_eq!(
        code(&acutile(["delaunay", fcc, "--triangulate", "-o", target])),
        0
    );
    let text = std::fs::read_to_string(&tiling).expect("a tiling file");
    assert_eq!(text.matches("\"Cu1\"").count(), 4, "{text}");
    let classified = stdout(&acutile(["classify", target]));
    assert!(classified.contains("site Cu1 (4 in a cell"), "{classified}");
    assert!(
        classified.contains("12 neighbours, Voronoi index (0,12,0,0)"),
        "{classified}"
    );
    assert!(
        classified.contains("isomorphic to: not compared"),
        "{classified}"
    );
    let cut = stdout(&acutile(["classify", fcc, "--triangulate"]));
    assert!(
        cut.contains("the 4 cells that are not tetrahedra were cut"),
        "{cut}"
    );
    let mu = path("mu");
    let mu = stdout(&acutile([
        "classify",
        mu.to_str().expect("UTF-8"),
        "--special",
    ]));
    assert!(
        mu.contains("39 points in a cell") && mu.contains("isomorphic to: mu"),
        "{mu}"
    );
    assert!(
        mu.contains("space group of the points: R -3 m (number 166)"),
        "{mu}"
    );
}

/// C14 with uncertainties of the usual size is acute within them. With 0.063(20) and 0.83(8) it is not: the
/// answer names an exact point.
#[test]
fn statements_within_uncertainties() {
    let place = tempfile::tempdir().expect("a directory");
    let c14 = |z: &str, x: &str| {
        text("c14")
            .replace("length_a 5.223", "length_a 5.223(1)")
            .replace("length_b 5.223", "length_b 5.223(1)")
            .replace("length_c 8.566", "length_c 8.566(3)")
            .replace("0.33333 0.66667 0.06286", &format!("1/3 2/3 {z}"))
            .replace("0.83048 0.66096", x)
    };
    let certify = |name: &str, text: &str| {
        let cif = file(place.path(), name, text);
        let cif = cif.to_str().expect("UTF-8");
        acutile(["certify", cif, "--within-su", "--require", "acute"])
    };
    let proved = certify("c14.cif", &c14("0.06286(6)", "0.83048(4) 0.66096(8)"));
    assert_eq!(code(&proved), 0, "{}", stderr(&proved));
    assert!(
        stdout(&proved).contains("for all c_over_a in [8563/5224, 8569/5222]"),
        "{}",
        stdout(&proved)
    );
    let refuted = certify("wide.cif", &c14("0.063(20)", "0.83(8) 0.66"));
    assert_eq!(code(&refuted), 1, "{}", stdout(&refuted));
    let said = stdout(&refuted) + &stderr(&refuted);
    assert!(
        said.contains("z_mg1 = ") && said.contains("obtuse"),
        "{said}"
    );
    let other = acutile(["certify", "a15", "--within-su"]);
    assert_eq!(code(&other), 2);
    assert!(
        stderr(&other).contains("--within-su is for a CIF"),
        "{}",
        stderr(&other)
    );
}
