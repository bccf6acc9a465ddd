//! Polyhedra cut into acute tetrahedra: the 600-cell without a small ball, made flat.
//!
//! The tetrahedra of the 600-cell that avoid a ball of its tetrahedra form a ball themselves.
//! Placed in space with flat faces they triangulate a polyhedron.
//!
//! | file | constructions |
//! |---|---|
//! | `piece`, `tables` | without one tetrahedron: the regular tetrahedron and the corner of a cube, 543 |
//! | `cube` | the cube in 2,715, its mirror images, the octahedron |
//! | `dodecahedron` | without the star of a vertex: the regular dodecahedron, 470 |
//! | `prism`, `prism_tables` | without a bipyramid: prisms over a triangle, 533, and a pentagon, 515 |
//!
//! Two papers prove that a cube has an acute triangulation: Kopczyński, Pak and Przytycki
//! (arXiv:0909.3706), and VanderZee, Hirani, Zharnitsky and Guoy (arXiv:0905.3715). The latter have 1,370
//! tetrahedra and, as far as is known here, published no coordinates.

pub mod cube;
pub mod dodecahedron;
mod piece;
pub mod prism;
mod prism_tables;
mod tables;

use acutile_exact::geometry::cell600;

/// The cells without a vertex in the ball.
fn without(ball: &[usize]) -> Vec<[usize; 4]> {
    let mut cells = cell600::cells();
    cells.retain(|cell| cell.iter().all(|vertex| !ball.contains(vertex)));
    cells
}
