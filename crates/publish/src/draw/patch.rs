//! Simplices of a tiling where they are drawn: coloured by congruence class, in one cell.

use super::DrawError;
use super::drawing::{Colour, class_colour};
use super::polygon::Point;
use super::scene::Body;
use acutile_core::quality::{Shape, shapes};
use acutile_core::tiling::{Corner, SimplexId, Tiling};
use acutile_exact::number::Number;
use malachite::Rational;

/// No figure has more simplices.
pub const SIMPLEX_LIMIT: usize = 800;

/// # Errors
/// Where there are more simplices than a figure shows.
pub fn check_count<const D: usize>(tiling: &Tiling<D>) -> Result<(), DrawError> {
    match tiling.len() {
        count if count > SIMPLEX_LIMIT => Err(DrawError::TooMany(count, SIMPLEX_LIMIT)),
        _ => Ok(()),
    }
}

/// The index of the class of each simplex.
pub fn classes(shapes: &[Shape], simplices: usize) -> Vec<usize> {
    let mut classes = vec![0; simplices];
    for (class, shape) in shapes.iter().enumerate() {
        shape
            .members
            .iter()
            .for_each(|&i| classes[i.index()] = class);
    }
    classes
}

/// The colours of the classes and their names.
pub fn legend(classes: usize) -> Vec<(Colour, String)> {
    let entry = |class: usize| (class_colour(class), format!("class {class}"));
    (0..classes).map(entry).collect()
}

/// All tetrahedra, each by that lattice vector that brings its centre into 0 <= x < 1;
/// and the number of classes.
pub fn cell(tiling: &Tiling<3>) -> (Vec<Body>, usize) {
    let shapes = shapes(tiling);
    let classes = classes(&shapes, tiling.len());
    let bodies = tiling
        .indices()
        .zip(classes)
        .map(|(i, class)| body(tiling, &centred(tiling, i), class))
        .collect();
    (bodies, shapes.len())
}

/// The corners moved together, by the lattice vector that brings their centre into 0 <= x < 1.
pub fn centred<const D: usize>(tiling: &Tiling<D>, simplex: SimplexId) -> Vec<Corner<D>> {
    let corners = tiling.simplex(simplex);
    let positions: Vec<[Number; D]> = corners.iter().map(|c| tiling.position(c)).collect();
    let mut by = [0; D];
    for (k, shift) in by.iter_mut().enumerate().take(tiling.frame.rank()) {
        *shift = -(mean(positions.iter().map(|p| &p[k])).approximate().floor() as i32);
    }
    corners.iter().map(|corner| corner.moved(by)).collect()
}

/// Four corners as a body in the colour of a class.
pub fn body(tiling: &Tiling<3>, corners: &[Corner<3>], class: usize) -> Body {
    Body {
        corners: std::array::from_fn(|k| tiling.position(&corners[k])),
        colour: class_colour(class),
    }
}

/// The sum over the number of terms; 0 of none.
pub fn mean<'n>(values: impl Iterator<Item = &'n Number>) -> Number {
    let (mut sum, mut count) = (Number::zero(), 0u32);
    for value in values {
        (sum, count) = (sum + value, count + 1);
    }
    sum * Number::from(Rational::from_unsigneds(1, count.max(1)))
}

/// The mean of points.
pub fn centre<'p>(points: impl Iterator<Item = &'p Point> + Clone) -> Point {
    std::array::from_fn(|k| mean(points.clone().map(|p| &p[k])))
}
