//! A tiling of the plane, its triangles coloured by congruence class; where there is a
//! lattice, several cells, and one of them outlined.

use super::drawing::{Drawing, Layout, Panel, Stroke, class_colour};
use super::polygon::Point;
use super::scene::{Line, Scene};
use super::view::View;
use super::{DrawError, Options, patch};
use acutile_core::quality::shapes;
use acutile_core::tiling::{Corner, Tiling};
use acutile_exact::number::Number;
use malachite::Rational;

/// Cells on either side of the outlined one.
const AROUND: i32 = 1;

/// The figure.
pub fn plane(name: &str, tiling: &Tiling<2>, options: &Options) -> Result<Drawing, DrawError> {
    patch::check_count(tiling)?;
    let view = View::new(&gram(&tiling.frame.gram), [0.0, 0.0, 1.0])?;
    let shapes = shapes(tiling);
    let classes = patch::classes(&shapes, tiling.len());
    let reach = |k: usize| if k < tiling.frame.rank() { AROUND } else { 0 };
    let mut scene = Scene::new(&view);
    for simplex in tiling.indices() {
        let corners = patch::centred(tiling, simplex);
        for i in -reach(0)..=reach(0) {
            for j in -reach(1)..=reach(1) {
                let places = [0, 1, 2].map(|k| place(tiling, &corners[k].moved([i, j])));
                scene.add_triangle(places, class_colour(classes[simplex.index()]));
            }
        }
    }
    for ends in outline(tiling.frame.rank()) {
        scene.add_line(Line {
            ends,
            visible: Stroke::Outline,
            hidden: None,
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
        legend: patch::legend(shapes.len()),
    };
    Ok(layout.arrange(&format!("{name}: plane"), &[panel]))
}

/// The plane as the coordinate plane of the first two basis vectors.
pub fn gram([[a, b], [c, d]]: &[[Number; 2]; 2]) -> [[Number; 3]; 3] {
    let zero = Number::zero;
    [
        [a.clone(), b.clone(), zero()],
        [c.clone(), d.clone(), zero()],
        [zero(), zero(), Number::from(Rational::from(1))],
    ]
}

/// A corner in that plane.
pub fn place(tiling: &Tiling<2>, corner: &Corner<2>) -> Point {
    let [x, y] = tiling.position(corner);
    [x, y, Number::zero()]
}

fn outline(rank: usize) -> Vec<[Point; 2]> {
    let corner = |(x, y): (u8, u8)| -> Point { [x, y, 0].map(|n| Number::from(Rational::from(n))) };
    let sides: &[_] = match rank {
        2 => &[
            ((0, 0), (1, 0)),
            ((1, 0), (1, 1)),
            ((1, 1), (0, 1)),
            ((0, 1), (0, 0)),
        ],
        _ => &[],
    };
    sides.iter().map(|&(a, b)| [corner(a), corner(b)]).collect()
}
