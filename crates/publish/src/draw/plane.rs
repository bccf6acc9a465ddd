//! A tiling of the plane, its triangles coloured by congruence class; where there is a
//! lattice, several cells, and one of them outlined.

use super::drawing::{Drawing, Item, Layout, Panel, Stroke, lit};
use super::polygon::Point;
use super::view::View;
use super::{DrawError, Options, patch};
use crate::palette::Palette;
use acutile_core::quality::{kinds, shapes};
use acutile_core::tiling::{Corner, Tiling};
use acutile_exact::number::Number;
use malachite::Rational;
use std::collections::BTreeSet;

/// Cells on either side of the outlined one.
const AROUND: i32 = 1;

/// The figure.
pub fn plane(name: &str, tiling: &Tiling<2>, options: &Options) -> Result<Drawing, DrawError> {
    let view = View::new(&gram(&tiling.frame.gram), [0.0, 0.0, 1.0])?;
    let shapes = shapes(tiling);
    let palette = Palette::of(&shapes);
    let classes = kinds(&shapes, tiling.len());
    let reach = |k: usize| if k < tiling.frame.rank() { AROUND } else { 0 };
    // In the plane no triangle covers another, so no edge is tested for visibility.
    let (mut items, mut edges) = (Vec::new(), BTreeSet::new());
    for simplex in tiling.indices() {
        let corners = patch::centred(tiling, simplex);
        let colour = palette.colour(classes[simplex.index()]);
        for i in -reach(0)..=reach(0) {
            for j in -reach(1)..=reach(1) {
                let places = [0, 1, 2].map(|k| place(tiling, &corners[k].moved([i, j])));
                items.push(Item::Polygon {
                    corners: places.iter().map(|p| view.place(p)).collect(),
                    fill: lit(colour, view.light(&places)),
                });
                let sides = [(0, 1), (0, 2), (1, 2)].map(|(a, b)| [&places[a], &places[b]]);
                edges.extend(sides.map(|ends| ends.map(Point::clone)).map(sorted));
            }
        }
    }
    let line = |stroke| {
        let view = &view;
        move |ends: [Point; 2]| Item::Line {
            ends: ends.map(|p| view.place(&p)),
            stroke,
        }
    };
    items.extend(edges.into_iter().map(line(Stroke::Edge)));
    items.extend(
        outline(tiling.frame.rank())
            .into_iter()
            .map(line(Stroke::Outline)),
    );
    let panel = Panel {
        items,
        caption: String::new(),
    };
    let layout = Layout {
        width: options.width,
        columns: 1,
        margin: 2.0,
        has_one_scale: true,
        legend: patch::legend(&palette),
    };
    Ok(layout.arrange(&format!("{name}: plane"), &[panel]))
}

fn sorted([a, b]: [Point; 2]) -> [Point; 2] {
    if a < b { [a, b] } else { [b, a] }
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
