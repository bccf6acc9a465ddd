//! Prints what is proved: figures, pages, appendices and archives. Decides nothing.

pub mod appendix;
pub mod bundle;
pub mod cite;
pub mod draw;
mod palette;
pub mod report;

// A checkout without symbolic links has paths in place of the documents that the crate embeds.
const _: () = assert!(
    include_str!("../repository/LICENSE").len() > 500,
    "repository/ is without symbolic links: set git's core.symlinks to true, and check out again",
);
