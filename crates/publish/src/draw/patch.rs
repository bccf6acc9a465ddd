//! Simplices of a tiling where they are drawn: coloured by congruence class, in one cell.

use super::DrawError;
use super::drawing::{Colour, Stroke};
use super::polygon::Point;
use super::scene::Body;
use crate::palette::Palette;
use acutile_core::quality::{kinds, shapes};
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

/// The colours of the classes and their names.
pub fn legend(palette: &Palette) -> Vec<(Colour, String)> {
    let colours = palette.colours().iter().enumerate();
    colours
        .map(|(class, colour)| (*colour, format!("class {class}")))
        .collect()
}

/// The same, with the cell where it is drawn.
pub fn legend_with_cell(palette: &Palette) -> Vec<(Colour, String)> {
    let cell = (Stroke::Cell.colour(), "heavy lines: the cell".to_owned());
    legend(palette).into_iter().chain([cell]).collect()
}

/// All tetrahedra, each by that lattice vector that brings its centre into 0 <= x < 1;
/// and the colours of the classes.
pub fn cell(tiling: &Tiling<3>) -> (Vec<Body>, Palette) {
    let shapes = shapes(tiling);
    let palette = Palette::of(&shapes);
    let bodies = tiling
        .indices()
        .zip(kinds(&shapes, tiling.len()))
        .map(|(i, class)| body(tiling, &centred(tiling, i), palette.colour(class)))
        .collect();
    (bodies, palette)
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

/// Four corners as a body.
pub fn body(tiling: &Tiling<3>, corners: &[Corner<3>], colour: Colour) -> Body {
    Body {
        corners: std::array::from_fn(|k| tiling.position(&corners[k])),
        colour,
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
