//! `classify` names the P, M, R and T phases, from the files of `examples/frank-kasper` and from worse ones.

use crate::common::{acutile, code, file, stderr, stdout};
use serde_json::{Value, json};
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// Name of the file, space group, and vertices of types Z12, Z14, Z15, Z16 in the cell of the file, after
/// D. P. Shoemaker and C. B. Shoemaker, Acta Cryst. B 42 (1986) 3-11: the cells of R and T are three and two
/// primitive ones.
const PHASES: [(&str, u64, [u64; 4]); 4] = [
    ("p", 62, [24, 20, 8, 4]),
    ("m", 62, [28, 8, 8, 8]),
    ("r", 148, [81, 36, 18, 24]),
    ("t", 204, [98, 12, 12, 40]),
];

fn path(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("examples/frank-kasper/{name}.cif"))
}

fn answer(path: &Path) -> Value {
    let done = acutile(["classify", path.to_str().expect("UTF-8"), "--json"]);
    assert_eq!(code(&done), 0, "{}", stderr(&done));
    serde_json::from_str(&stdout(&done)).expect("an answer in JSON")
}

fn name_of(phase: &str) -> Value {
    json!([format!("Frank-Kasper {} phase", phase.to_uppercase())])
}

/// The group of the points and the numbers of vertices of each type are those of the literature. For P, M
/// and R so is the coordination number of each site, which is in its label.
#[test]
fn phases_of_frank_and_kasper_are_named() {
    for (phase, group, counts) in PHASES {
        let answer = answer(&path(phase));
        assert_eq!(answer["isomorphic_to"], name_of(phase));
        assert_eq!(answer["tcp"], true, "{phase}");
        assert_eq!(answer["space_group"]["number"], group, "{phase}");
        let [z12, z14, z15, z16] = counts;
        let types = json!({ "Z12": z12, "Z14": z14, "Z15": z15, "Z16": z16 });
        assert_eq!(answer["vertex_types"], types, "{phase}");
        if phase != "t" {
            check_labels(&answer);
        }
    }
}

/// Each label begins with the type of its site.
fn check_labels(answer: &Value) {
    let sites = answer["sites"].as_array().expect("sites");
    assert!(sites.len() > 10, "{answer}");
    for site in sites {
        let label = site["label"].as_str().expect("a label");
        assert_eq!(site["type"], label[..3], "{label}");
    }
}

/// The delta phase has as many vertices of each type as P. Its name comes from other coordinates, those of genice2.
#[test]
fn the_delta_phase_is_not_p() {
    let answer = answer(&path("delta"));
    check_labels(&answer);
    assert_eq!(
        answer["vertex_types"],
        json!({ "Z12": 24, "Z14": 20, "Z15": 8, "Z16": 4 })
    );
    assert_eq!(
        answer["isomorphic_to"],
        json!(["space fullerene 23 (delta)"])
    );
}

/// A POSCAR without symmetry, of two cells in another basis, with every coordinate off by up to 0.02, has the name of
/// the phase.
#[test]
fn phases_are_named_in_noisy_supercells() {
    let place = tempfile::tempdir().expect("a directory");
    for (phase, _, _) in PHASES {
        let text = noisy_supercell(&path(phase));
        let poscar = file(place.path(), &format!("POSCAR_{phase}"), &text);
        let answer = answer(&poscar);
        assert_eq!(answer["isomorphic_to"], name_of(phase));
    }
}

/// P without one of its sites has no name.
#[test]
fn without_a_site_there_is_no_name() {
    let place = tempfile::tempdir().expect("a directory");
    let cif = std::fs::read_to_string(path("p")).expect("a file");
    let without = cif.replace("Z12e 0.035 0 0.25\n", "");
    assert_ne!(cif, without);
    let answer = answer(&file(place.path(), "vacancy.cif", &without));
    assert_eq!(answer["isomorphic_to"], json!([]));
}

/// The points of a crystal file in the basis a + b, b, 2c + a of a sublattice, moved a little.
fn noisy_supercell(crystal: &Path) -> String {
    let done = acutile(["delaunay", crystal.to_str().expect("UTF-8"), "-o", "-"]);
    let tiling: Value = serde_json::from_str(&stdout(&done)).expect("a tiling file");
    let gram = matrix(&tiling["lattice"]["gram"]);
    let [a, b, c] = basis([0, 1, 2].map(|i| [0, 1, 2].map(|j| gram[i][j])));
    let sum = |u: [f64; 3], v: [f64; 3], k: f64| [0, 1, 2].map(|i| u[i] + k * v[i]);
    let lattice = [sum(a, b, 1.0), b, sum(a, c, 2.0)];
    let mut rows = String::new();
    let vertices = matrix(&tiling["vertices"]);
    let mut noise = 1_u64;
    for point in &vertices {
        for shift in [0.0, 1.0] {
            let place = sum(
                sum(sum([0.0; 3], a, point[0]), b, point[1]),
                c,
                point[2] + shift,
            );
            for x in place {
                noise = noise * 48_271 % 2_147_483_647;
                let off = (noise % 4001) as f64 / 100_000.0 - 0.02;
                write!(rows, "{:.6} ", x + off).expect("a string");
            }
            rows.push('\n');
        }
    }
    let lattice: String = lattice
        .map(|[x, y, z]| format!("{x:.6} {y:.6} {z:.6}\n"))
        .concat();
    format!(
        "noisy\n1\n{lattice}Fe\n{}\nCartesian\n{rows}",
        2 * vertices.len()
    )
}

/// Vectors with this Gram matrix: its Cholesky factor.
fn basis(gram: [[f64; 3]; 3]) -> [[f64; 3]; 3] {
    let mut rows = [[0.0; 3]; 3];
    for i in 0..3 {
        for j in 0..=i {
            let sum: f64 = (0..j).map(|k| rows[i][k] * rows[j][k]).sum();
            rows[i][j] = if i == j {
                (gram[i][i] - sum).sqrt()
            } else {
                (gram[i][j] - sum) / rows[j][j]
            };
        }
    }
    rows
}

/// Rows of fractions as doubles.
fn matrix(rows: &Value) -> Vec<Vec<f64>> {
    let row = |row: &Value| row.as_array().expect("a row").iter().map(double).collect();
    rows.as_array().expect("rows").iter().map(row).collect()
}

fn double(fraction: &Value) -> f64 {
    let parts = fraction.as_str().expect("a fraction").split('/');
    let parts = parts.map(|part| part.parse::<f64>().expect("a whole number"));
    parts.reduce(|n, d| n / d).expect("a number")
}
