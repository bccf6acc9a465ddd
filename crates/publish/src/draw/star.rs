//! The star of a vertex: all tetrahedra that have it, as one solid, with the edges behind as
//! broken lines.

use super::drawing::{BLACK, Colour, Drawing, Layout, Panel, Stroke, WHITE};
use super::polygon::Point;
use super::scene::{Body, Dot, Scene};
use super::view::View;
use super::{DrawError, Options, patch};
use crate::palette::Palette;
use acutile_core::quality::{kinds, shapes};
use acutile_core::tiling::{Corner, SimplexId, Tiling, VertexId};
use std::collections::BTreeSet;

/// The figure.
pub fn star(name: &str, tiling: &Tiling<3>, options: &Options) -> Result<Drawing, DrawError> {
    let (vertex, count) = (options.vertex, tiling.vertices.len());
    if vertex >= count {
        return Err(DrawError::NoVertex(vertex, count));
    }
    let view = View::new(&tiling.frame.gram, options.direction)?;
    let shapes = shapes(tiling);
    let id = VertexId::at(vertex);
    let palette = Palette::of(&shapes);
    let classes = kinds(&shapes, tiling.len());
    let bodies = bodies(tiling, id, |simplex| {
        palette.colour(classes[simplex.index()])
    });
    let (scene, _) = around(tiling, id, &bodies, &view, Some(Stroke::HiddenEdge));
    let panel = Panel {
        items: scene.items()?,
        caption: format!("vertex {vertex}: {} tetrahedra", bodies.len()),
    };
    let layout = Layout {
        width: options.width,
        columns: 1,
        margin: 4.0,
        has_one_scale: true,
        legend: [
            patch::legend(&palette),
            vec![
                (BLACK, format!("vertex {vertex}")),
                (WHITE, "neighbour; broken lines are behind".to_owned()),
            ],
        ]
        .concat(),
    };
    Ok(layout.arrange(&format!("{name}: star of vertex {vertex}"), &[panel]))
}

/// Every simplex once for each corner at the vertex, moved so that this corner is not shifted.
pub(super) fn bodies(
    tiling: &Tiling<3>,
    vertex: VertexId,
    colour: impl Fn(SimplexId) -> Colour,
) -> Vec<Body> {
    let mut bodies = Vec::new();
    for (id, simplex) in tiling.indices().zip(tiling.simplices()) {
        for corner in simplex.iter().filter(|corner| corner.vertex == vertex) {
            let back = corner.shift.map(|s| -s);
            let moved: Vec<Corner<3>> = simplex.iter().map(|c| c.moved(back)).collect();
            bodies.push(patch::body(tiling, &moved, colour(id)));
        }
    }
    bodies
}

/// These bodies around a vertex as one solid, with a black dot for the vertex and a white one for each
/// neighbour. Also the number of neighbours.
pub(super) fn around<'v>(
    tiling: &Tiling<3>,
    vertex: VertexId,
    bodies: &[Body],
    view: &'v View,
    hidden: Option<Stroke>,
) -> (Scene<'v>, usize) {
    let centre = tiling.position(&Corner::of(vertex));
    let mut scene = Scene::new(view);
    scene.add_solid(bodies, hidden);
    let corners = bodies.iter().flat_map(|body| &body.corners);
    let neighbours: BTreeSet<&Point> = corners.filter(|&p| *p != centre).collect();
    let count = neighbours.len();
    for at in neighbours {
        scene.add_dot(Dot {
            at: at.clone(),
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
    (scene, count)
}
