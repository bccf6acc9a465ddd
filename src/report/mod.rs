//! What people look at: a page for tilings that the kernel has confirmed, and a site of the whole
//! catalogue.
//!
//! | file | holds |
//! |---|---|
//! | `proved` | [`Proved`]: a certificate with the kernel's word, the only thing that is shown |
//! | `facts` | the exact values of a tiling, each once |
//! | `data` | these values for the page's program |
//! | `article` | the same as text and tables, readable without a program |
//! | `histogram`, `picture` | drawings in SVG |
//! | `page` | the page: one file that loads nothing |
//! | `html` | escaping, templates |
//! | `gallery`, `markdown` | the site |
//! | `assets` | template, style, program, and the verifier in JavaScript |
//!
//! Nothing here proves anything. Called by the command line.

mod article;
mod data;
mod facts;
mod histogram;
mod html;
mod page;
mod picture;
mod proved;

pub use page::page;
pub use proved::{NotProved, Proved};
