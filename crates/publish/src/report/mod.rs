//! What people look at: a page for tilings that the kernel has confirmed or that are refuted, and a
//! site of the whole catalogue.
//!
//! | file | holds |
//! |---|---|
//! | `proved` | [`Proved`]: a certificate with the kernel's word, the only thing that is shown as proved |
//! | `facts` | the exact values of a tiling, each once |
//! | `data` | these values for the page's program |
//! | `article` | the same as text and tables, readable without a program |
//! | `refutation` | a refuted tiling: its defects in words and in the picture |
//! | `histogram`, `picture` | drawings in SVG |
//! | `page` | the page: one file that loads nothing |
//! | `html` | escaping, templates |
//! | `gallery` | the site |
//! | `documents`, `markdown` | the project's documents in it |
//! | `assets` | template, style, program, and the verifier in JavaScript |
//!
//! Nothing here proves anything.

mod article;
mod colour;
mod data;
mod documents;
mod facts;
mod gallery;
mod histogram;
mod html;
mod markdown;
mod page;
mod picture;
mod proved;
mod refutation;

pub use documents::DOCUMENTS;
pub use gallery::{Site, gallery};
pub use markdown::Document;
pub use page::{Shown, mixed_page, page};
pub use proved::{NotProved, Proved};
pub use refutation::{Listed, Refutation};

use acutile_core::statement::Statement;
use acutile_core::tiling::AnyTiling;

/// Counts of a tiling in a line.
fn summary(proved: &Proved) -> String {
    let verified = proved.verified();
    let (one, many) = match proved.tiling() {
        AnyTiling::Plane(_) => ("triangle", "triangles"),
        AnyTiling::Space(_) => ("tetrahedron", "tetrahedra"),
    };
    let count = |n: usize, one: &str, many: &str| match n {
        1 => format!("1 {one}"),
        _ => format!("{n} {many}"),
    };
    let mut words = vec![
        count(verified.simplices as usize, one, many),
        count(verified.vertices as usize, "vertex", "vertices"),
    ];
    for statement in proved.statements() {
        words.extend(match statement {
            Statement::Acute => Some("acute".to_owned()),
            Statement::Nonobtuse => Some("nonobtuse".to_owned()),
            Statement::Tcp => Some("TCP".to_owned()),
            _ => None,
        });
    }
    words.join(", ")
}
