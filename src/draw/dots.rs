//! Section 4.1: the square/triangle tiling under a TCP structure, with the dots from which its
//! vertices are read off: black ones at heights 4k - 1, white ones at 4k + 1, and the tiling's vertices
//! at 4k and 4k + 2.

use super::drawing::{BLACK, Drawing, GREY, Item, Layout, Panel, Place, Stroke, WHITE};
use super::{DrawError, Options};
use crate::catalog::plane_tiling::{Cyclotomic, POWERS, PlaneTiling, named, sum};

/// The figure: several cells, as many as are needed for some tiles, and one of them outlined.
pub fn dots(name: &str, options: &Options) -> Result<Drawing, DrawError> {
    let plane = under(name).ok_or(DrawError::NoPlane)?;
    let copies = match plane.vertices.len() {
        0..=1 => 3,
        2..=12 => 2,
        _ => 1,
    };
    let patch = plane.repeated([copies, copies]);
    let mut items = edges(&patch)?;
    items.extend(outline(&plane));
    items.extend(marks(&patch)?);
    let panel = Panel {
        items,
        caption: String::new(),
    };
    let layout = Layout {
        width: options.width,
        columns: 1,
        margin: 2.0,
        legend: vec![
            (BLACK, "height 4k \u{2212} 1".to_owned()),
            (WHITE, "height 4k + 1".to_owned()),
            (GREY, "heights 4k, 4k + 2".to_owned()),
        ],
    };
    Ok(layout.arrange(&format!("{name}: plane tiling"), &[panel]))
}

/// The plane tiling of a construction of the catalogue.
fn under(name: &str) -> Option<PlaneTiling> {
    match name {
        "z" => named("3"),
        "a15" => named("4"),
        "sigma" => named("32434"),
        "h" => named("33344"),
        _ => named(name.strip_prefix("square-triangle")?.get(1..)?),
    }
}

/// All edges at the vertices of the patch, each drawn from the end from which its direction is
/// less than a half turn, and those that leave the patch backwards.
fn edges(patch: &PlaneTiling) -> Result<Vec<Item>, DrawError> {
    let stars = patch.stars()?;
    let mut lines = Vec::new();
    for (&vertex, star) in patch.vertices.iter().zip(&stars) {
        for corner in star.iter().filter(|corner| corner.direction < 6) {
            let end = sum(vertex, POWERS[corner.direction]);
            lines.push(Item::Line {
                ends: [cartesian(vertex, 1.0), cartesian(end, 1.0)],
                stroke: Stroke::Edge,
            });
        }
    }
    Ok(lines)
}

fn outline(plane: &PlaneTiling) -> Vec<Item> {
    let [a, b] = plane.lattice;
    let corners = [[0; 4], a, sum(a, b), b];
    (0..4)
        .map(|k| Item::Line {
            ends: [corners[k], corners[(k + 1) % 4]].map(|x| cartesian(x, 1.0)),
            stroke: Stroke::HiddenCell,
        })
        .collect()
}

/// The dots, and the vertices of the tiling, once for their two heights.
fn marks(patch: &PlaneTiling) -> Result<Vec<Item>, DrawError> {
    let points = patch.points()?;
    let dots = points.iter().filter(|(_, height)| *height != 2);
    Ok(dots
        .map(|&(place, height)| Item::Dot {
            at: cartesian(place, 12.0),
            radius: if height == 0 { 0.5 } else { 0.8 },
            fill: match height {
                0 => GREY,
                ..0 => BLACK,
                _ => WHITE,
            },
        })
        .collect())
}

/// z = (√3 + i)/2, z² = (1 + i √3)/2, z³ = i; divided by `scale`.
fn cartesian(x: Cyclotomic, scale: f64) -> Place {
    let [a, b, c, d] = x.map(|entry| entry as f64 / scale);
    let root = 3f64.sqrt();
    [a + (b * root + c) / 2.0, d + (b + c * root) / 2.0]
}
