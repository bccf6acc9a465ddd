//! A figure of each congruence class, in rows: the tile with the numbers of its corners and its angles.
//! A shape has one colour in all figures and on all pages.

use super::Options;
use crate::draw::classes::{Row, tetrahedra_in_rows, triangles_in_rows};
use crate::draw::tikz::tikz;
use crate::draw::{DrawError, Drawing};
use acutile_core::quality::Shape;
use acutile_core::tiling::Tiling;

/// The figures of a tiling of space in TeX; nothing where there are none, which is no part of a proof.
pub fn solids(name: &str, tiling: &Tiling<3>, shapes: &[Shape], options: &Options) -> String {
    in_tex(tetrahedra_in_rows(name, tiling, shapes, row(options)))
}

/// Those of a tiling of the plane.
pub fn triangles(name: &str, tiling: &Tiling<2>, shapes: &[Shape], options: &Options) -> String {
    in_tex(triangles_in_rows(name, tiling, shapes, row(options)))
}

/// Labels need panels of about 50 mm.
fn row(options: &Options) -> Row {
    if options.two_column {
        Row {
            width: 84.0,
            columns: 2,
        }
    } else {
        Row {
            width: 159.0,
            columns: 3,
        }
    }
}

fn in_tex(drawings: Result<Vec<Drawing>, DrawError>) -> String {
    let pictures = drawings.unwrap_or_default().into_iter();
    let pictures: String = pictures
        .map(|drawing| format!("\\acutilepicture{{%\n{}}}\n", tikz(&drawing, false)))
        .collect();
    if pictures.is_empty() {
        pictures
    } else {
        format!(
            "The figures show the first tile of each class, with the numbers of its corners and its angles in degrees, rounded.\n{pictures}\n"
        )
    }
}
