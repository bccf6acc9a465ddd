//! The star of a vertex: all tetrahedra that have it, as one solid, with the edges behind as
//! broken lines.

use super::drawing::{BLACK, Drawing, Layout, Panel, Stroke, WHITE};
use super::polygon::Point;
use super::scene::{Body, Dot, Scene};
use super::view::View;
use super::{DrawError, Options, patch};
use acutile_core::quality::shapes;
use acutile_core::tiling::{Corner, Tiling, VertexId};
use std::collections::BTreeSet;

/// The figure.
pub fn star(name: &str, tiling: &Tiling<3>, options: &Options) -> Result<Drawing, DrawError> {
    let (vertex, count) = (options.vertex, tiling.vertices.len());
    if vertex >= count {
        return Err(DrawError::NoVertex(vertex, count));
    }
    patch::check_count(tiling)?;
    let view = View::new(&tiling.frame.gram, options.direction)?;
    let shapes = shapes(tiling);
    let id = VertexId::at(vertex);
    let bodies = bodies(tiling, id, &patch::classes(&shapes, tiling.len()));
    let centre = tiling.position(&Corner::of(id));
    let mut scene = Scene::new(&view);
    scene.add_solid(&bodies, Some(Stroke::HiddenEdge));
    for at in neighbours(&bodies, &centre) {
        scene.add_dot(Dot {
            at,
            radius: 0.6,
            colour: WHITE,
            shines_through: false,
        });
    }
    scene.add_dot(Dot {
        at: centre,
        radius: 0.8,
        colour: BLACK,
        shines_through: true,
    });
    let panel = Panel {
        items: scene.items()?,
        caption: format!("vertex {vertex}: {} tetrahedra", bodies.len()),
    };
    let layout = Layout {
        width: options.width,
        columns: 1,
        margin: 4.0,
        has_one_scale: true,
        legend: patch::legend(shapes.len()),
    };
    Ok(layout.arrange(&format!("{name}: star of vertex {vertex}"), &[panel]))
}

/// Every simplex once for each corner at the vertex, moved so that this corner is not shifted.
pub(super) fn bodies(tiling: &Tiling<3>, vertex: VertexId, classes: &[usize]) -> Vec<Body> {
    let mut bodies = Vec::new();
    for (simplex, &class) in tiling.simplices().zip(classes) {
        for corner in simplex.iter().filter(|corner| corner.vertex == vertex) {
            let back = corner.shift.map(|s| -s);
            let moved: Vec<Corner<3>> = simplex.iter().map(|c| c.moved(back)).collect();
            bodies.push(patch::body(tiling, &moved, class));
        }
    }
    bodies
}

/// The corners other than the centre.
pub(super) fn neighbours(bodies: &[Body], centre: &Point) -> BTreeSet<Point> {
    let corners = bodies.iter().flat_map(|body| &body.corners);
    corners.filter(|&p| p != centre).cloned().collect()
}
