//! The tetrahedra of a small piece moved apart: each by the way from the middle of all to its own.
//! Larger ones hide one another, so that the command line does not offer it.

use super::drawing::{Drawing, Layout, Panel};
use super::polygon::Point;
use super::scene::{Body, Scene};
use super::view::View;
use super::{DrawError, Options, patch};
use acutile_core::tiling::Tiling;

/// The figure.
pub fn exploded(name: &str, tiling: &Tiling<3>, options: &Options) -> Result<Drawing, DrawError> {
    patch::check_count(tiling)?;
    let view = View::new(&tiling.frame.gram, options.direction)?;
    let (bodies, palette) = patch::cell(tiling);
    let middles: Vec<Point> = bodies
        .iter()
        .map(|b| patch::centre(b.corners.iter()))
        .collect();
    let middle = patch::centre(middles.iter());
    let mut scene = Scene::new(&view);
    for (body, own) in bodies.iter().zip(&middles) {
        let by: Point = [0, 1, 2].map(|k| &own[k] - &middle[k]);
        scene.add_solid(&[moved(body, &by)], None);
    }
    let panel = Panel {
        items: scene.items()?,
        caption: String::new(),
    };
    let layout = Layout {
        width: options.width,
        columns: 1,
        margin: 2.0,
        has_one_scale: true,
        legend: patch::legend(&palette),
    };
    Ok(layout.arrange(&format!("{name}: exploded"), &[panel]))
}

fn moved(body: &Body, by: &Point) -> Body {
    let corners = body.corners.each_ref();
    Body {
        corners: corners.map(|p| [0, 1, 2].map(|k| &p[k] + &by[k])),
        colour: body.colour,
    }
}
