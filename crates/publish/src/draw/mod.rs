//! Figures for print: tetrahedra of each congruence class, the cell, the star of a vertex, foams, the slab's eight steps,
//! plane tilings.
//!
//! | file | holds |
//! |---|---|
//! | [`polygon`] | exact faces, and planes that cut them |
//! | [`order`] | what is painted before what |
//! | [`hidden`] | which parts of a line are behind faces |
//! | [`view`] | the direction of sight, and the projection |
//! | `scene` | bodies, lines and points, turned into marks |
//! | [`drawing`] | marks in millimetres, panels, line weights, colours |
//! | [`svg`], [`tikz`], [`pdf`], [`png`] | how marks are written |
//! | `font` | letters for the last two |
//! | [`classes`], `cell`, `star`, `foam`, `coordination`, `exploded`, `steps`, `plane`, `dots` | one kind of figure each |
//! | `labels` | places for words beside lines |
//! | `patch` | simplices of a tiling as bodies |
//!
//! Visibility is decided exactly; only places on the paper are doubles. Nothing here proves anything about
//! a tiling, and nothing is assumed: simplices may overlap.

mod cell;
pub mod classes;
mod coordination;
mod dots;
pub mod drawing;
mod error;
mod exploded;
pub mod foam;
mod font;
pub mod hidden;
mod labels;
pub mod order;
mod patch;
pub mod pdf;
mod plane;
pub mod png;
pub mod polygon;
mod scene;
mod star;
mod steps;
pub mod svg;
pub mod tikz;
pub mod view;

pub use drawing::Drawing;
pub use error::DrawError;

use acutile_core::tiling::AnyTiling;

/// What is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Figure {
    /// One simplex of each congruence class with its angles in degrees.
    Classes,
    /// The simplices of a cell, with the cell itself.
    Cell,
    /// The tetrahedra at a vertex.
    Star,
    /// The Voronoi cells of the vertices, one of each kind.
    Foam,
    /// The neighbours of the vertices with their link, one of each kind.
    Coordination,
    /// The tetrahedra of a small piece, moved apart.
    Exploded,
    /// The slab in its eight steps.
    Steps,
    /// A tiling of the plane; for a TCP structure over a square/triangle tiling that tiling.
    Plane,
}

/// How it is drawn.
#[derive(Clone, Debug)]
pub struct Options {
    /// The direction to the eye; see [`view::View::new`].
    pub direction: [f64; 3],
    /// The vertex of [`Figure::Star`].
    pub vertex: usize,
    /// Of the figure, in millimetres.
    pub width: f64,
}

/// From the front, a little from the right and from above; no edge of a lattice that one draws is
/// seen end on.
pub const DIRECTION: [f64; 3] = [4.0, -9.0, 5.0];

impl Default for Options {
    fn default() -> Self {
        Options {
            direction: DIRECTION,
            vertex: 0,
            width: 84.0,
        }
    }
}

/// The figure of a tiling with this name.
///
/// # Errors
/// If the tiling has no such figure, if the figure is too large, or if the Gram matrix is not positive
/// definite.
pub fn draw(
    name: &str,
    tiling: &AnyTiling,
    figure: Figure,
    options: &Options,
) -> Result<Drawing, DrawError> {
    let drawing = match (tiling, figure) {
        (AnyTiling::Plane(t), Figure::Classes) => classes::triangles(name, t, options),
        (AnyTiling::Plane(t), Figure::Cell | Figure::Plane) => plane::plane(name, t, options),
        (AnyTiling::Plane(_), _) => Err(DrawError::NotSolid),
        (AnyTiling::Space(t), Figure::Classes) => classes::tetrahedra(name, t, options),
        (AnyTiling::Space(t), Figure::Cell) => cell::cell(name, t, options),
        (AnyTiling::Space(t), Figure::Star) => star::star(name, t, options),
        (AnyTiling::Space(t), Figure::Foam) => foam::figure(name, t, options),
        (AnyTiling::Space(t), Figure::Coordination) => coordination::figure(name, t, options),
        (AnyTiling::Space(t), Figure::Exploded) => exploded::exploded(name, t, options),
        (AnyTiling::Space(t), Figure::Steps) => steps::steps(name, t, options),
        (AnyTiling::Space(_), Figure::Plane) => dots::dots(name, options),
    }?;
    if drawing.is_finite() {
        Ok(drawing)
    } else {
        Err(DrawError::TooLarge)
    }
}
