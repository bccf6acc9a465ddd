//! The exact check of a finished triangulation. It does not depend on the search tree or the gift wrapping,
//! which found the triangulation.
//!
//! These conditions are checked. (1) Every point is a corner. (2) Every simplex is positively oriented. (3)
//! Every facet has one mate, on its other side. (4) The corner of the mate opposite to the facet is outside
//! of the circumsphere, or on it if the two simplices come from one cell. (5) The volumes sum to the volume
//! of one cell.
//!
//! *Then it is a Delaunay triangulation.* By (2) and (3) the number N of simplices over a generic point is
//! constant: crossing a facet leaves one simplex and enters its mate. N times the cell's volume is the sum
//! of the volumes. So by (5) N is 1, and the simplices tile. Let f be the function that interpolates |x|²
//! on each of them. By (4) it is convex across every facet, hence convex. So the affine function of a
//! simplex is at most f everywhere. By (1) every point p is a corner, so the affine function is at most
//! |p|² there. Hence p is not inside the circumsphere.

use crate::predicates::{InSphere, Model, Orientation};
use crate::tiling::{SimplexId, Tiling, match_facets};
use acutile_exact::geometry::Sign;
use acutile_exact::number::Number;
use malachite::Rational;

/// Whether the simplices of `shell` are the Delaunay triangulation of its first `points` vertices. For each
/// simplex `cells` has the number of the cell that it comes from.
pub fn is_delaunay<const D: usize>(shell: &Tiling<D>, cells: &[u32], points: usize) -> bool {
    let model = Model::new(shell);
    uses_all_points(shell, points)
        && is_positive(&model)
        && is_one_cell(&model)
        && is_locally_delaunay(&model, cells)
}

/// (1)
fn uses_all_points<const D: usize>(shell: &Tiling<D>, points: usize) -> bool {
    let mut used = vec![false; points];
    for corner in &shell.corners {
        match used.get_mut(corner.vertex.index()) {
            Some(used) => *used = true,
            None => return false,
        }
    }
    used.iter().all(|&used| used)
}

/// (2)
fn is_positive<const D: usize>(model: &Model<D>) -> bool {
    let orientation = model.prepare(Orientation);
    orientation.failing(|signs| signs.all_positive()).is_empty()
}

/// (5)
fn is_one_cell<const D: usize>(model: &Model<D>) -> bool {
    let factorial = (1..=D as u64).product::<u64>();
    model.sum_of_determinants() == Number::from(Rational::from(factorial))
}

/// (3), and (4) from one side of each facet: see [`Prepared::failing_pairs`].
///
/// [`Prepared::failing_pairs`]: crate::predicates::Prepared::failing_pairs
fn is_locally_delaunay<const D: usize>(model: &Model<D>, cells: &[u32]) -> bool {
    let shell = model.tiling;
    let matching = match_facets(shell);
    let all_have_mates = shell
        .facets()
        .all(|facet| matching.neighbour(facet).is_some());
    let is_right = |here: SimplexId, there: SimplexId, sign| match sign {
        Sign::Greater => true,
        Sign::Equal => cells[here.index()] == cells[there.index()],
        Sign::Less => false,
    };
    let spheres = model.prepare(InSphere);
    all_have_mates && spheres.failing_pairs(&matching, is_right).is_empty()
}
