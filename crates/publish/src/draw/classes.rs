//! One simplex of each congruence class with its angles in degrees: the dihedral angles of a
//! tetrahedron at its edges, the angles of a triangle at its corners.
//!
//! The angles are enclosed and rounded from the enclosure. Each tetrahedron is seen from where its
//! labels are farthest from one another and from the other edges.

use super::drawing::{
    Drawing, FONT, Item, Layout, Panel, Place, Stroke, class_colour, lit, text_width,
};
use super::polygon::Point;
use super::scene::{Body, Scene};
use super::view::View;
use super::{DrawError, Options, patch, plane};
use acutile_core::quality::{DihedralAngle, Exact, Shape, rounded_nearest, shapes};
use acutile_core::tiling::{SimplexId, Tiling};
use acutile_exact::geometry::linear;
use malachite::Rational;

/// No figure has more classes.
const CLASS_LIMIT: usize = 60;

/// The edges of a tetrahedron, each with the two facets that meet there, by the corners
/// opposite to them.
const EDGES: [([usize; 2], [usize; 2]); 6] = [
    ([0, 1], [2, 3]),
    ([0, 2], [1, 3]),
    ([0, 3], [1, 2]),
    ([1, 2], [0, 3]),
    ([1, 3], [0, 2]),
    ([2, 3], [0, 1]),
];

/// The classes of a tiling of space.
pub fn tetrahedra(name: &str, tiling: &Tiling<3>, options: &Options) -> Result<Drawing, DrawError> {
    let shapes = checked_shapes(tiling)?;
    let layout = layout(&shapes, options);
    let panels = shapes.iter().enumerate().map(|(class, shape)| {
        let simplex = shape.members[0];
        let body = patch::body(tiling, tiling.simplex(simplex), class);
        let view = best_view(tiling, &body, &layout)?;
        let mut scene = Scene::new(&view);
        scene.add_solid(std::slice::from_ref(&body), Some(Stroke::HiddenEdge));
        let mut items = scene.items()?;
        for ([a, b], [i, j]) in EDGES {
            let [p, q] = [a, b].map(|k| view.place(&body.corners[k]));
            items.push(Item::Label {
                at: middle(p, q),
                text: angle(tiling, simplex, i, j),
                has_halo: true,
            });
        }
        Ok(Panel {
            items,
            caption: caption(class, shape, tiling.len()),
        })
    });
    let panels = panels.collect::<Result<Vec<Panel>, DrawError>>()?;
    Ok(layout.arrange(&format!("{name}: classes"), &panels))
}

/// The classes of a tiling of the plane.
pub fn triangles(name: &str, tiling: &Tiling<2>, options: &Options) -> Result<Drawing, DrawError> {
    let shapes = checked_shapes(tiling)?;
    let layout = layout(&shapes, options);
    let view = View::new(&plane::gram(&tiling.frame.gram), [0.0, 0.0, 1.0])?;
    let panels: Vec<Panel> = shapes
        .iter()
        .enumerate()
        .map(|(class, shape)| {
            let simplex = shape.members[0];
            let corners = tiling.simplex(simplex);
            let places = [0, 1, 2].map(|k| view.place(&plane::place(tiling, &corners[k])));
            Panel {
                items: triangle(tiling, simplex, places, class, room(&layout)),
                caption: caption(class, shape, tiling.len()),
            }
        })
        .collect();
    Ok(layout.arrange(&format!("{name}: classes"), &panels))
}

/// The angle at a corner is that between the two sides not opposite to it; its label is outside.
fn triangle(
    tiling: &Tiling<2>,
    simplex: SimplexId,
    places: [Place; 3],
    class: usize,
    room: f64,
) -> Vec<Item> {
    let mut items = vec![Item::Polygon {
        corners: places.to_vec(),
        fill: lit(class_colour(class), 1.0),
    }];
    items.extend([(0, 1), (1, 2), (2, 0)].map(|(a, b)| Item::Line {
        ends: [places[a], places[b]],
        stroke: Stroke::Edge,
    }));
    // What is left where there is a label on either side.
    let room = (room - 2.0 * text_width("00.00°")).max(1.0);
    let scale = room / extent(&places, 0).max(extent(&places, 1)).max(1e-9);
    for corner in 0..3 {
        items.push(Item::Label {
            at: beside(&places, corner, scale),
            text: angle(tiling, simplex, (corner + 1) % 3, (corner + 2) % 3),
            has_halo: true,
        });
    }
    items
}

/// The middle of a label outside of a corner, in the direction away from the nearer other
/// corner, so that the labels of two near corners go apart.
fn beside(places: &[Place; 3], corner: usize, scale: f64) -> Place {
    let at = places[corner];
    let away = |k: usize| {
        let [x, y] = [0, 1].map(|i| at[i] - places[(corner + k) % 3][i]);
        (x.hypot(y), [x, y])
    };
    let (first, second) = (away(1), away(2));
    let (length, [x, y]) = if first.0 <= second.0 { first } else { second };
    let [x, y] = [x, y].map(|x| x / length.max(1e-9));
    let reach = [0.6 * text_width("00.00°"), 0.9 * FONT];
    let far = (reach[0] / x.abs()).min(reach[1] / y.abs()) / scale;
    [at[0] + far * x, at[1] + far * y]
}

fn checked_shapes<const D: usize>(tiling: &Tiling<D>) -> Result<Vec<Shape>, DrawError> {
    patch::check_count(tiling)?;
    let shapes = shapes(tiling);
    match shapes.len() {
        classes if classes > CLASS_LIMIT => Err(DrawError::TooManyClasses(classes, CLASS_LIMIT)),
        _ => Ok(shapes),
    }
}

fn layout(shapes: &[Shape], options: &Options) -> Layout {
    // A label is 9 mm wide, and three go beside one another over an edge.
    let fitting = (options.width / 40.0).floor().max(1.0) as usize;
    Layout {
        width: options.width,
        columns: fitting.min(shapes.len()),
        margin: 5.0,
        has_one_scale: false,
        legend: Vec::new(),
    }
}

/// The width of a panel without its margins.
fn room(layout: &Layout) -> f64 {
    layout.width / layout.columns.max(1) as f64 - 2.0 * layout.margin
}

fn caption(class: usize, shape: &Shape, simplices: usize) -> String {
    format!("class {}: {} of {simplices}", class, shape.members.len())
}

/// The angle between two facets: `60°` where it is rational, else two decimals.
fn angle<const D: usize>(tiling: &Tiling<D>, simplex: SimplexId, i: usize, j: usize) -> String {
    let shape = tiling.shape(simplex);
    let products = shape.normal_products(&linear::cofactors(&tiling.frame.gram));
    let Some(angle) = DihedralAngle::between(&products, i, j) else {
        return "flat".to_owned();
    };
    if let Some(degrees) = angle.rational() {
        return format!("{degrees}°");
    }
    let mut width = Rational::from_signeds(1, 1000);
    // An irrational angle is no tie between two decimals, so that this ends; a flat simplex may be
    // one, hence the limit.
    for _ in 0..16 {
        let (low, high) = angle.enclosure(&width);
        let (low, high) = (rounded_nearest(&low, 2), rounded_nearest(&high, 2));
        if low == high {
            return format!("{low}°");
        }
        width /= Rational::from(1000);
    }
    String::new()
}

/// Of the directions with small whole coordinates the first in which the labels are clearest.
fn best_view(tiling: &Tiling<3>, body: &Body, layout: &Layout) -> Result<View, DrawError> {
    let room = room(layout);
    let mut best: Option<(f64, View)> = None;
    let range = -3..=3;
    for (x, y, z) in range
        .clone()
        .flat_map(|x| range.clone().map(move |y| (x, y)))
        .flat_map(|(x, y)| range.clone().map(move |z| (x, y, z)))
        .filter(|v| *v != (0, 0, 0))
    {
        // A little off, so that no edge of a symmetric tetrahedron is seen end on.
        let direction = [(x, 0.11), (y, 0.07), (z, 0.05)].map(|(n, off)| f64::from(n) + off);
        let view = View::new(&tiling.frame.gram, direction)?;
        let clearness = clearness(body.corners.each_ref().map(|p: &Point| view.place(p)), room);
        if best.as_ref().is_none_or(|(most, _)| clearness > *most) {
            best = Some((clearness, view));
        }
    }
    best.map(|(_, view)| view).ok_or(DrawError::NoDirection)
}

/// The least distance between labels, and of a label from an edge that is not its own, in
/// units of a label's width and height, for a tetrahedron that fills the room.
fn clearness(places: [Place; 4], room: f64) -> f64 {
    let scale = room / extent(&places, 0).max(extent(&places, 1)).max(1e-9);
    let unit = [text_width("00.00°"), 1.2 * FONT];
    let places = places.map(|p| [0, 1].map(|k| p[k] * scale / unit[k]));
    let labels = EDGES.map(|([a, b], _)| middle(places[a], places[b]));
    let mut least = f64::MAX;
    for (i, label) in labels.iter().enumerate() {
        for other in &labels[..i] {
            let apart = [0, 1].map(|k| (label[k] - other[k]).abs());
            least = least.min(apart[0].max(apart[1]));
        }
        for (j, ([a, b], _)) in EDGES.iter().enumerate() {
            if i != j {
                least = least.min(1.5 * distance(*label, places[*a], places[*b]));
            }
        }
    }
    least
}

fn extent(places: &[Place], k: usize) -> f64 {
    let all = places.iter().map(|p| p[k]);
    all.clone().fold(f64::MIN, f64::max) - all.fold(f64::MAX, f64::min)
}

/// Of a point from a segment.
fn distance(p: Place, a: Place, b: Place) -> f64 {
    let (along, from) = ([b[0] - a[0], b[1] - a[1]], [p[0] - a[0], p[1] - a[1]]);
    let square = along[0] * along[0] + along[1] * along[1];
    let s = (along[0] * from[0] + along[1] * from[1]) / square.max(1e-12);
    let s = s.clamp(0.0, 1.0);
    (from[0] - s * along[0]).hypot(from[1] - s * along[1])
}

fn middle(p: Place, q: Place) -> Place {
    [0, 1].map(|k| (p[k] + q[k]) / 2.0)
}
