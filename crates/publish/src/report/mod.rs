//! Pages about tilings that the kernel has confirmed or that are refuted, and a site of the whole
//! catalogue.
//!
//! | file | holds |
//! |---|---|
//! | `proved` | [`Proved`]: a certificate with the kernel's word, the only thing that is shown as proved |
//! | `facts` | the exact values of a tiling, each once |
//! | `data` | these values for the page's program |
//! | `foam` | Voronoi cells for the view |
//! | `article` | the same as text and tables, readable without a program |
//! | `theorem` | [`Theorem`]: a confirmed family or system of patches |
//! | `family`, `patches`, `mosaics` | their articles |
//! | `math` | formulas as MathML |
//! | `mesh` | the article of a tiling with too many different simplices for tables |
//! | `refutation` | a refuted tiling: its defects in words and in the picture |
//! | `histogram`, `picture` | drawings in SVG |
//! | `page` | the page: one file that loads nothing |
//! | `html` | escaping, templates |
//! | `gallery` | the site |
//! | `theorems` | its pages of families, systems of patches and records |
//! | `drop` | its page that verifies any certificate in the reader's browser |
//! | `documents`, `markdown` | the project's documents in it |
//! | `formulas` | formulas in their text |
//! | `assets` | template, style, program, and the verifier in JavaScript |
//!
//! Nothing here proves anything.

mod article;
mod colour;
mod data;
mod documents;
mod drop;
mod facts;
mod family;
mod foam;
mod formulas;
mod gallery;
mod histogram;
mod html;
mod markdown;
mod math;
mod mesh;
mod mosaics;
mod page;
mod patches;
mod picture;
mod proved;
mod refutation;
mod theorem;
mod theorems;

pub use documents::DOCUMENTS;
pub use gallery::{Site, gallery};
pub use markdown::Document;
pub use page::{Shown, mixed_page, page};
pub use proved::{NotProved, Proved};
pub use refutation::{Listed, Refutation};
pub use theorem::Theorem;

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
