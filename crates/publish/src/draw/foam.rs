//! The foam of a Delaunay triangulation of space: the Voronoi cell of one vertex of each kind, and all cells as
//! OBJ and STL.

use super::drawing::{BLACK, Drawing, Layout, Panel};
use super::scene::{Dot, Scene};
use super::view::View;
use super::{DrawError, Options};
use crate::palette::colour;
use acutile_core::checker::{self, examine};
use acutile_core::classify::stars;
use acutile_core::foam::{Cell, cells, isoperimetric_quotient};
use acutile_core::proved::NotProved;
use acutile_core::quality::{rounded_down, rounded_up};
use acutile_core::statement::Requirement;
use acutile_core::tiling::{Domain, Tiling};
use acutile_exact::geometry::linear;
use acutile_exact::number::Number;
use std::collections::BTreeMap;
use std::fmt::Write;

/// The cell of each vertex, after the prover has found that the tiling is a weakly Delaunay triangulation of space.
///
/// # Errors
/// [`DrawError::NoFoam`] if it is not.
pub fn foam(tiling: &Tiling<3>) -> Result<Vec<Cell>, DrawError> {
    let no_foam = |reason: &str| DrawError::NoFoam(reason.to_owned());
    if !matches!(tiling.frame.domain, Domain::Space) {
        return Err(no_foam("this does not fill space"));
    }
    let options = checker::Options {
        required: vec![Requirement::WeaklyDelaunay],
        ..checker::Options::default()
    };
    examine(tiling, &options, &|_| {})
        .map_err(|findings| DrawError::NoFoam(NotProved::from(findings).in_words(tiling)))?;
    cells(tiling).ok_or_else(|| no_foam("an edge is not surrounded by tetrahedra"))
}

/// The bounds of the isoperimetric quotient in a sentence, to six digits.
pub fn quotient_in_words(tiling: &Tiling<3>, cells: &[Cell]) -> String {
    match isoperimetric_quotient(&tiling.frame.gram, cells) {
        Some((low, high)) => format!(
            "isoperimetric quotient 36 pi V^2 / A^3 of the foam with flat faces between {} and {}",
            rounded_down(&low, 6),
            rounded_up(&high, 6)
        ),
        None => "no isoperimetric quotient".to_owned(),
    }
}

/// One panel for each kind of cell: the same number of faces, volume and areas.
pub fn figure(name: &str, tiling: &Tiling<3>, options: &Options) -> Result<Drawing, DrawError> {
    let all = foam(tiling)?;
    let view = View::new(&tiling.frame.gram, options.direction)?;
    let kinds = kinds(tiling, &all);
    let names = stars(tiling);
    let mut panels = Vec::new();
    for (kind, members) in kinds.iter().enumerate() {
        let cell = &all[members[0]];
        let mut scene = Scene::new(&view);
        let faces: Vec<&[_]> = cell.faces.iter().map(|f| &f.corners[..]).collect();
        scene.add_polyhedron(&faces, &cell.centre, colour(kind));
        scene.add_dot(Dot {
            at: cell.centre.clone(),
            radius: 0.7,
            colour: BLACK,
            shines_through: true,
        });
        let (star, faces) = (&names[members[0]], cell.faces.len());
        panels.push(Panel {
            items: scene.items()?,
            caption: format!("{star}: {faces} faces, {} in the cell", members.len()),
        });
    }
    let layout = Layout {
        width: options.width,
        columns: panels.len().clamp(1, 2),
        margin: 3.0,
        has_one_scale: true,
        legend: vec![(BLACK, "vertex; broken lines are behind".to_owned())],
    };
    let title = format!("{name}: foam; {}", quotient_in_words(tiling, &all));
    Ok(layout.arrange(&title, &panels))
}

/// The vertices by the kind of their cells; kinds with fewer faces first.
fn kinds(tiling: &Tiling<3>, cells: &[Cell]) -> Vec<Vec<usize>> {
    let cogram = linear::cofactors(&tiling.frame.gram);
    let mut kinds: BTreeMap<(usize, Number, Vec<Number>), Vec<usize>> = BTreeMap::new();
    for (vertex, cell) in cells.iter().enumerate() {
        let mut areas = cell.squared_areas(&cogram);
        areas.sort();
        let kind = (cell.faces.len(), cell.volume(), areas);
        kinds.entry(kind).or_default().push(vertex);
    }
    kinds.into_values().collect()
}

/// Wavefront OBJ: each cell an object with its faces as polygons. Coordinates are rounded to doubles.
pub fn obj(name: &str, tiling: &Tiling<3>, cells: &[Cell]) -> Result<String, DrawError> {
    let view = View::new(&tiling.frame.gram, super::DIRECTION)?;
    let mut text = format!("# {name}: foam, coordinates rounded to doubles\n");
    let mut first = 1;
    for (vertex, cell) in cells.iter().enumerate() {
        let mut numbers = BTreeMap::new();
        let mut faces = String::new();
        // Writing to a string cannot fail.
        let _ = writeln!(text, "o cell-{vertex}");
        for face in outward(cell) {
            faces.push('f');
            for corner in face {
                let next = first + numbers.len();
                let number = *numbers.entry(corner).or_insert(next);
                let _ = write!(faces, " {number}");
                if number == next {
                    let [x, y, z] = view.cartesian(corner);
                    let _ = writeln!(text, "v {x} {y} {z}");
                }
            }
            faces.push('\n');
        }
        first += numbers.len();
        text += &faces;
    }
    Ok(text)
}

/// ASCII STL: the faces of all cells as fans of triangles, each cell a closed surface of its own.
pub fn stl(tiling: &Tiling<3>, cells: &[Cell]) -> Result<String, DrawError> {
    let view = View::new(&tiling.frame.gram, super::DIRECTION)?;
    let mut text = String::new();
    for (vertex, cell) in cells.iter().enumerate() {
        let _ = writeln!(text, "solid cell-{vertex}");
        for face in outward(cell) {
            let corners: Vec<[f64; 3]> = face.iter().map(|p| view.cartesian(p)).collect();
            for k in 1..corners.len() - 1 {
                let [a, b, c] = [corners[0], corners[k], corners[k + 1]];
                let normal = linear::cross(&linear::subtract(&b, &a), &linear::subtract(&c, &a));
                let length = linear::dot(&normal, &normal).sqrt();
                let [x, y, z] = normal.map(|n| n / length);
                let _ = writeln!(text, "facet normal {x:e} {y:e} {z:e}\nouter loop");
                for [x, y, z] in [a, b, c] {
                    let _ = writeln!(text, "vertex {x:e} {y:e} {z:e}");
                }
                text += "endloop\nendfacet\n";
            }
        }
        let _ = writeln!(text, "endsolid cell-{vertex}");
    }
    Ok(text)
}

/// The faces with their corners in the positive sense, seen from outside in a right-handed basis.
fn outward(cell: &Cell) -> Vec<Vec<&acutile_core::foam::Point>> {
    let faces = cell.faces.iter().map(|face| {
        let mut corners: Vec<_> = face.corners.iter().collect();
        let side = |k: usize| linear::subtract(corners[k], corners[0]);
        let normal = linear::cross(&side(1), &side(2));
        let from = linear::subtract(corners[0], &cell.centre);
        if linear::dot(&normal, &from).sign().is_lt() {
            corners.reverse();
        }
        corners
    });
    faces.collect()
}
