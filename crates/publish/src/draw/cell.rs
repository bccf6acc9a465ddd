//! The tetrahedra of a cell, and the parallelepiped of the lattice.

use super::drawing::{Drawing, Layout, Panel, Stroke};
use super::polygon::Point;
use super::scene::{Line, Scene};
use super::view::View;
use super::{DrawError, Options, patch};
use acutile_core::tiling::{Domain, Frame, Tiling};
use acutile_exact::number::Number;
use malachite::Rational;

/// The figure. A lattice of rank 3 has a parallelepiped, that of a slab one between its
/// planes; a prism and a solid have none.
pub fn cell(name: &str, tiling: &Tiling<3>, options: &Options) -> Result<Drawing, DrawError> {
    patch::check_count(tiling)?;
    let view = View::new(&tiling.frame.gram, options.direction)?;
    let (bodies, palette) = patch::cell(tiling);
    let mut scene = Scene::new(&view);
    scene.add_solid(&bodies, None);
    for ends in parallelepiped(&tiling.frame) {
        scene.add_line(Line {
            ends,
            visible: Stroke::Cell,
            hidden: Some(Stroke::HiddenCell),
        });
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
        legend: patch::legend_with_cell(&palette),
    };
    Ok(layout.arrange(&format!("{name}: cell"), &[panel]))
}

/// The twelve edges.
fn parallelepiped(frame: &Frame<3>) -> Vec<[Point; 2]> {
    let number = |n: u8| Number::from(Rational::from(n));
    let unit = [number(0), number(1)];
    let heights = match &frame.domain {
        Domain::Space => unit.clone(),
        Domain::Slab(bounds) => match &bounds.vertices[..] {
            [low, high] => [low[0].clone(), high[0].clone()],
            _ => return Vec::new(),
        },
        Domain::Prism(_) | Domain::Solid(_) | Domain::Region(_) => return Vec::new(),
    };
    let ranges = [unit.clone(), unit, heights];
    let corner = |bits: usize| -> Point { [0, 1, 2].map(|k| ranges[k][bits >> k & 1].clone()) };
    (0..8)
        .flat_map(|bits| [1, 2, 4].map(|step| (bits, bits | step)))
        .filter(|(a, b)| a != b)
        .map(|(a, b)| [corner(a), corner(b)])
        .collect()
}
