//! Files that people have: tilings, point sets, crystal structures and meshes, read and written.

pub mod export;
pub mod import;
pub mod mesh;
