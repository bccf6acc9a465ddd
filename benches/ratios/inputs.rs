//! Files for the programs of others: the same data, and what acutile says about them, so that
//! answers can be compared. See `benches/peers/run`.

use crate::data::{FIELDS, a15, a15_points, bent, doubles, entry, points};
use crate::reading;
use acutile_core::checker::Model;
use acutile_core::delaunay::{Ties, triangulate};
use acutile_core::predicates::{Angles, Orientation};
use acutile_core::tiling::{Frame, PointSet, SimplexId, Tiling, match_facets, supercell};
use acutile_exact::number::Number;
use std::fmt::Write;
use std::fs;
use std::io::Result;
use std::path::Path;

/// Writes the files and prints the answers, one on a line: `@answer`, the file and a number.
pub fn write(folder: &Path) -> Result<()> {
    fs::create_dir_all(folder)?;
    // Multiples of 2^-44, so that corners, sums of a vertex and a shift, are doubles.
    let a15_8 = a15(8);
    let sets = [
        ("easy", doubles(&a15_8, 1e-4, Some(44))),
        ("mixed", doubles(&a15_8, 0.03, Some(44))),
        ("right", supercell(&entry("cube-6"), [10; 3])),
    ];
    for (name, tiling) in &sets {
        fs::write(folder.join(name), corner_doubles(tiling))?;
        answer(name, acute(tiling));
    }
    let small = a15(4);
    for (name, step) in [
        ("rational-128", "1/1048583"),
        ("rational-256", "1/1125899906842679"),
        ("degree-2", FIELDS[0].1),
        ("degree-4", FIELDS[2].1),
        ("degree-8", FIELDS[3].1),
    ] {
        let tiling = bent(&small, step);
        fs::write(folder.join(name), corner_numbers(&tiling))?;
        answer(name, acute(&tiling));
    }
    let matched = a15(38);
    fs::write(folder.join("matching"), corner_vertices(&matched))?;
    assert!(match_facets(&matched).mismatches.is_empty());
    answer("matching", matched.corners.len() / 2);
    drop(matched);
    let one_cell = triangulate(&points(&entry("a15")), Ties::Refuse);
    let one_cell = one_cell.expect("it has one triangulation").len();
    for (name, set, side) in [
        ("points-8", points(&entry("a15")), 1),
        ("points-97336", a15_points(23), 23),
        ("points-1000000", a15_points(50), 50),
    ] {
        fs::write(folder.join(name), scaled_points(&set, f64::from(8 * side)))?;
        answer(name, one_cell * usize::pow(side as usize, 3));
    }
    for (_, _, path) in reading::write_files(folder, 16)? {
        let name = path.file_name().and_then(|name| name.to_str());
        answer(name.unwrap_or_default(), 46 * 16 * 16 * 16);
    }
    Ok(())
}

fn answer(name: &str, value: usize) {
    println!("@answer\t{name}\t{value}");
}

/// How many tetrahedra are positively oriented and acute.
fn acute(tiling: &Tiling<3>) -> usize {
    let model = Model::new(tiling);
    let (orientation, angles) = (model.prepare(Orientation), model.prepare(Angles));
    let is_acute =
        |s: SimplexId| orientation.signs(s).all_positive() && angles.signs(s).all_negative();
    tiling.indices().filter(|s| is_acute(*s)).count()
}

/// Three coordinates of four corners of each tetrahedron. The Gram matrix must be a multiple of
/// the identity, for angles to be those of these coordinates.
fn corner_doubles(tiling: &Tiling<3>) -> Vec<u8> {
    assert_cubic(&tiling.frame);
    let vertices: Vec<[f64; 3]> = tiling
        .vertices
        .iter()
        .map(|v| v.map(|x| x.approximate()))
        .collect();
    let mut bytes = Vec::new();
    for corner in &tiling.corners {
        for (x, shift) in vertices[corner.vertex.index()].iter().zip(corner.shift) {
            bytes.extend_from_slice(&(x + f64::from(shift)).to_le_bytes());
        }
    }
    bytes
}

fn assert_cubic(frame: &Frame<3>) {
    let gram = &frame.gram;
    for (i, row) in gram.iter().enumerate() {
        for (j, entry) in row.iter().enumerate() {
            let wanted = if i == j {
                gram[0][0].clone()
            } else {
                Number::zero()
            };
            assert!(
                *entry == wanted,
                "the basis is orthonormal but for a factor"
            );
        }
    }
}

/// The first line has the polynomial of the generator and its root. Every other line has the twelve
/// coordinates of a tetrahedron, each as rational coefficients with commas between.
fn corner_numbers(tiling: &Tiling<3>) -> String {
    assert_cubic(&tiling.frame);
    let field = &tiling.frame.field;
    let mut text = String::new();
    for coefficient in field.polynomial() {
        let _ = write!(text, "{coefficient} ");
    }
    let _ = writeln!(text, "{}", field.generator().approximate());
    for simplex in tiling.simplices() {
        for x in simplex.iter().flat_map(|corner| tiling.position(corner)) {
            let coefficients: Vec<String> =
                x.coefficients().iter().map(|c| c.to_string()).collect();
            let number = if coefficients.is_empty() {
                "0".to_owned()
            } else {
                coefficients.join(",")
            };
            let _ = write!(text, "{number} ");
        }
        text.push('\n');
    }
    text
}

/// The vertices of each tetrahedron: in so large a supercell they tell facets apart without
/// shifts.
fn corner_vertices(tiling: &Tiling<3>) -> Vec<u8> {
    let vertices = tiling
        .corners
        .iter()
        .map(|corner| corner.vertex.number().to_le_bytes());
    vertices.flatten().collect()
}

/// The side of the cube, and the points in it.
fn scaled_points(set: &PointSet<3>, side: f64) -> Vec<u8> {
    assert_cubic(&set.frame);
    let mut bytes = side.to_le_bytes().to_vec();
    for point in &set.points {
        for x in point {
            // Places are multiples of 1/8 of a cell: the product is an integer.
            bytes.extend_from_slice(&(x.approximate() * side).round().to_le_bytes());
        }
    }
    bytes
}
