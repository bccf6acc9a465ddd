//! The Voronoi cells of the vertices of a Delaunay triangulation of space, as polygons for the view.
//!
//! The cells are found exactly; their corners are rounded for the picture.

use super::proved::Proved;
use acutile_core::foam::{Cell, Point, cells};
use acutile_core::statement::Statement;
use acutile_core::tiling::Tiling;
use serde_json::{Value, json};

/// The cells of more vertices make a page too large.
const MOST_VERTICES: usize = 200;
/// Places behind the point.
const SCALE: f64 = 1e7;

/// For each vertex the faces of its cell, each a list of points in the basis; null where there is no such foam.
pub fn data(proved: &Proved, tiling: &Tiling<3>) -> Value {
    let delaunay = [Statement::Delaunay, Statement::WeaklyDelaunay];
    let is_delaunay = delaunay.iter().any(|s| proved.statements().contains(s));
    if !is_delaunay || tiling.frame.rank() < 3 || tiling.vertices.len() > MOST_VERTICES {
        return Value::Null;
    }
    let found = cells(tiling);
    found.map_or(Value::Null, |cells| cells.iter().map(cell).collect())
}

fn cell(cell: &Cell) -> Value {
    let rounded = |x: f64| (x * SCALE).round() / SCALE;
    let point = |point: &Point| json!(point.each_ref().map(|x| rounded(x.approximate())));
    let face = |corners: &Vec<Point>| corners.iter().map(point).collect::<Value>();
    cell.faces.iter().map(|one| face(&one.corners)).collect()
}
