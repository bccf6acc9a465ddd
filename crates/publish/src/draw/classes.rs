//! One simplex of each congruence class with its angles in degrees. A tetrahedron has its dihedral
//! angles at its edges, a triangle has its angles at its corners.
//!
//! The angles are enclosed and rounded from the enclosure. Corners have the numbers 0 to 3 of the simplex. Each tetrahedron is
//! seen from where its labels are off the edges and off one another.

use super::drawing::{Colour, Drawing, FONT, Item, Layout, Panel, Place, Stroke, lit, text_width};
use super::labels::{Request, around_point, beside_line, placed};
use super::polygon::Point;
use super::scene::{Body, Scene};
use super::view::View;
use super::{DrawError, Options, patch, plane};
use crate::palette::Palette;
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
    let panels = solid_panels(tiling, &shapes, &layout)?;
    Ok(layout.arrange(&title(name), &panels))
}

/// The classes of a tiling of the plane.
pub fn triangles(name: &str, tiling: &Tiling<2>, options: &Options) -> Result<Drawing, DrawError> {
    let shapes = checked_shapes(tiling)?;
    let layout = layout(&shapes, options);
    let panels = flat_panels(tiling, &shapes, &layout)?;
    Ok(layout.arrange(&title(name), &panels))
}

/// The classes of a tiling of space as several drawings with this many of them beside one another, all of one width.
///
/// # Errors
/// The Gram matrix is not positive definite, or a place is not finite.
pub fn tetrahedra_in_rows(
    name: &str,
    tiling: &Tiling<3>,
    shapes: &[Shape],
    row: Row,
) -> Result<Vec<Drawing>, DrawError> {
    row.drawings(name, solid_panels(tiling, shapes, &row.layout())?)
}

/// The classes of a tiling of the plane in the same way.
///
/// # Errors
/// The Gram matrix is not positive definite, or a place is not finite.
pub fn triangles_in_rows(
    name: &str,
    tiling: &Tiling<2>,
    shapes: &[Shape],
    row: Row,
) -> Result<Vec<Drawing>, DrawError> {
    row.drawings(name, flat_panels(tiling, shapes, &row.layout())?)
}

/// A row of classes.
#[derive(Clone, Copy, Debug)]
pub struct Row {
    /// In millimetres.
    pub width: f64,
    /// Classes beside one another.
    pub columns: usize,
}

impl Row {
    fn layout(self) -> Layout {
        Layout {
            width: self.width,
            columns: self.columns,
            margin: 5.0,
            has_one_scale: false,
            legend: Vec::new(),
        }
    }

    fn drawings(self, name: &str, panels: Vec<Panel>) -> Result<Vec<Drawing>, DrawError> {
        let rows = panels.chunks(self.columns.max(1)).map(|panels| {
            // A row that is not full keeps the size of its panels.
            let width = self.width * panels.len() as f64 / self.columns.max(1) as f64;
            let layout = Layout {
                width,
                columns: panels.len(),
                ..self.layout()
            };
            let drawing = layout.arrange(&title(name), panels);
            drawing
                .is_finite()
                .then_some(drawing)
                .ok_or(DrawError::TooLarge)
        });
        rows.collect()
    }
}

fn title(name: &str) -> String {
    format!("{name}: classes")
}

fn solid_panels(
    tiling: &Tiling<3>,
    shapes: &[Shape],
    layout: &Layout,
) -> Result<Vec<Panel>, DrawError> {
    let palette = Palette::of(shapes);
    let panels = shapes.iter().enumerate().map(|(class, shape)| {
        let simplex = shape.members[0];
        let body = patch::body(tiling, tiling.simplex(simplex), palette.colour(class));
        let angles = EDGES.map(|(_, [i, j])| angle(tiling, simplex, i, j));
        let (view, labels) = best_view(tiling, &body, &angles, layout)?;
        let mut scene = Scene::new(&view);
        scene.add_solid(std::slice::from_ref(&body), Some(Stroke::HiddenEdge));
        let mut items = scene.items()?;
        items.extend(labels);
        Ok(Panel {
            items,
            caption: caption(class, shape, tiling.len()),
        })
    });
    panels.collect()
}

fn flat_panels(
    tiling: &Tiling<2>,
    shapes: &[Shape],
    layout: &Layout,
) -> Result<Vec<Panel>, DrawError> {
    let palette = Palette::of(shapes);
    let view = View::new(&plane::gram(&tiling.frame.gram), [0.0, 0.0, 1.0])?;
    let panels = shapes.iter().enumerate().map(|(class, shape)| {
        let simplex = shape.members[0];
        let corners = tiling.simplex(simplex);
        let places = [0, 1, 2].map(|k| view.place(&plane::place(tiling, &corners[k])));
        let colour = palette.colour(class);
        Panel {
            items: triangle(tiling, simplex, places, colour, room(layout)),
            caption: caption(class, shape, tiling.len()),
        }
    });
    Ok(panels.collect())
}

/// The angle at a corner is that between the two sides not opposite to it; its label is outside.
fn triangle(
    tiling: &Tiling<2>,
    simplex: SimplexId,
    places: [Place; 3],
    colour: Colour,
    room: f64,
) -> Vec<Item> {
    let mut items = vec![Item::Polygon {
        corners: places.to_vec(),
        fill: lit(colour, 1.0),
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

/// The middle of a label outside of a corner, on the side away from the nearer other corner. So
/// the labels of two near corners go apart.
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
    let shapes = shapes(tiling);
    match shapes.len() {
        classes if classes > CLASS_LIMIT => Err(DrawError::TooManyClasses(classes, CLASS_LIMIT)),
        _ => Ok(shapes),
    }
}

fn layout(shapes: &[Shape], options: &Options) -> Layout {
    // A label is 9 mm wide; in less than 50 mm not all are off the edges.
    let fitting = (options.width / 50.0).floor().max(1.0) as usize;
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

/// Tries the clearest directions with small whole coordinates. Takes the first one in which all labels, angles at
/// edges and numbers of corners, are off all edges and off one another.
fn best_view(
    tiling: &Tiling<3>,
    body: &Body,
    angles: &[String; 6],
    layout: &Layout,
) -> Result<(View, Vec<Item>), DrawError> {
    let room = room(layout);
    let mut views: Vec<(f64, View)> = Vec::new();
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
        let places = body.corners.each_ref().map(|p: &Point| view.place(p));
        views.push((clearness(places, room), view));
    }
    views.sort_by(|(a, _), (b, _)| b.total_cmp(a));
    let mut best: Option<(usize, View, Vec<Item>)> = None;
    for (_, view) in views.into_iter().take(TRIED) {
        let places = body.corners.each_ref().map(|p: &Point| view.place(p));
        let (labels, hits) = labelled(&places, angles, room);
        if best.as_ref().is_none_or(|(least, ..)| hits < *least) {
            best = Some((hits, view, labels));
        }
        if hits == 0 {
            break;
        }
    }
    best.map(|(_, view, labels)| (view, labels))
        .ok_or(DrawError::NoDirection)
}

/// Directions for which labels are placed.
const TRIED: usize = 120;

/// The labels of a tetrahedron with corners at these places, and how many edges and labels they hit.
fn labelled(places: &[Place; 4], angles: &[String; 6], room: f64) -> (Vec<Item>, usize) {
    // What is left where there are labels on either side.
    let wide = (room - 2.0 * text_width("000.00°")).max(1.0) / extent(places, 0).max(1e-9);
    let scale = wide.min((1.5 * room - 5.0 * FONT) / extent(places, 1).max(1e-9));
    let paper = places.map(|p| p.map(|x| x * scale));
    let middle: Place = [0, 1].map(|k| paper.iter().map(|p| p[k]).sum::<f64>() / 4.0);
    let lines = EDGES.map(|(ends, _)| ends.map(|k| paper[k]));
    let names = (0..4).map(|k| around_point(k.to_string(), paper[k], middle));
    let requests: Vec<Request> = lines
        .iter()
        .zip(angles)
        .map(|(line, angle)| beside_line(angle.clone(), *line))
        .chain(names)
        .collect();
    let (found, hits) = placed(&requests, &lines);
    let labels = found.iter().zip(requests).map(|(at, request)| Item::Label {
        at: at.map(|x| x / scale),
        text: request.text,
        has_halo: true,
    });
    (labels.collect(), hits)
}

/// The least distance between two labels, or between a label and an edge of another label. The unit
/// is a label's width and height, and the tetrahedron fills its place.
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
