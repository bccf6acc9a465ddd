//! The exact check of a finished triangulation, independent of how it was found: it
//! trusts neither the search tree nor the gift wrapping.
//!
//! Checked: (1) every point is a corner, (2) every simplex is positively oriented,
//! (3) every facet has one mate, on its other side, (4) the corner of
//! the mate opposite to the facet is outside of the circumsphere, or on it if the two
//! simplices come from one cell, (5) the volumes sum to less than 3/2 cells.
//!
//! *Then it is a Delaunay triangulation.* By (2) and (3) the number N of simplices
//! over a generic point is constant (crossing a facet leaves one simplex and enters its
//! mate), and N times the cell's volume is the sum of the volumes, so by (5) N is 1 and
//! the simplices tile. Let f be the function that interpolates |x|² on each of
//! them. By (4) it is convex across every facet, hence convex. So the
//! affine function of a simplex is at most f everywhere, in particular at most |p|² at
//! every point p, which by (1) is a corner: p is not inside the circumsphere. The float
//! sum in (5) is compared with an integer and has a bounded error.

use super::predicates::Predicates;
use crate::tiling::{Corner, Matching, Tiling, match_facets};
use acutile_exact::geometry::{Scalar, Sign};
use rayon::prelude::*;

/// Whether the simplices, in model coordinates, positively oriented, with the number
/// of the cell that each comes from, are the Delaunay triangulation. `shell` is a tiling of the
/// same simplices.
pub fn is_delaunay<S: Scalar, const D: usize>(
    shell: &Tiling<D>,
    cells: &[u32],
    predicates: &Predicates<S, D>,
) -> bool {
    uses_all_points(shell, predicates.model.names.len())
        && (0..shell.len())
            .into_par_iter()
            .all(|index| is_positive(shell.simplex(index), predicates))
        && is_simple_cover(shell, predicates)
        && is_locally_delaunay(shell, cells, predicates)
}

/// A simplex as a facet and its opposite corner.
fn parts<const D: usize>(simplex: &[Corner<D>]) -> ([Corner<D>; D], Corner<D>) {
    (std::array::from_fn(|k| simplex[k]), simplex[D])
}

fn uses_all_points<const D: usize>(shell: &Tiling<D>, count: usize) -> bool {
    let mut used = vec![false; count];
    shell
        .corners
        .iter()
        .for_each(|corner| used[corner.vertex as usize] = true);
    used.iter().all(|&used| used)
}

fn is_positive<S: Scalar, const D: usize>(
    simplex: &[Corner<D>],
    predicates: &Predicates<S, D>,
) -> bool {
    let (facet, apex) = parts(simplex);
    predicates.orientation(&facet, &apex) == Sign::Greater
}

/// (5): fractions have errors of 2^-52, so the determinant of entries of at most m has
/// one of at most 2^-45 (1 + m)^D; a sum of n terms rounds by n 2^-53 of itself.
fn is_simple_cover<S: Scalar, const D: usize>(
    shell: &Tiling<D>,
    predicates: &Predicates<S, D>,
) -> bool {
    let floats = &predicates.model.floats;
    let (mut sum, mut error) = (0.0, 0.0);
    for simplex in shell.simplices() {
        let (facet, apex) = parts(simplex);
        let (volume, size) = floats.determinant(&facet, &apex);
        sum += volume;
        error += 2f64.powi(-45) * (1.0 + size).powi(D as i32);
    }
    let factorial = (1..=D).product::<usize>() as f64;
    sum + error < 1.4 * factorial
}

/// (3), and (4) from one side of each facet: that a corner is outside of the sphere of
/// the mate is the same as that the corner of the mate is outside of this one, for both
/// say that the interpolation of |x|² is strictly convex across the facet.
fn is_locally_delaunay<S: Scalar, const D: usize>(
    shell: &Tiling<D>,
    cells: &[u32],
    predicates: &Predicates<S, D>,
) -> bool {
    let matching = match_facets(shell);
    (0..shell.len()).into_par_iter().all(|here| {
        let (facet, apex) = parts(shell.simplex(here));
        let sphere = predicates.sphere(&facet, &apex);
        (0..=D).all(|opposite| match matching.neighbour(here, opposite) {
            None => false,
            Some(mate) if (mate.simplex as usize) < here => true,
            Some(mate) => {
                let there = mate.simplex as usize;
                beyond(shell, &matching, here, opposite).is_some_and(|p| match sphere.side(&p) {
                    Sign::Greater => true,
                    Sign::Equal => cells[here] == cells[there],
                    Sign::Less => false,
                })
            }
        })
    })
}

/// The corner of the mate of a facet that is not in the facet.
fn beyond<const D: usize>(
    shell: &Tiling<D>,
    matching: &Matching<D>,
    here: usize,
    opposite: usize,
) -> Option<Corner<D>> {
    let mate = matching.mate(shell, here, opposite)?;
    let corners = shell.simplex(mate.facet.simplex as usize);
    Some(corners[usize::from(mate.facet.opposite)].moved(mate.shift))
}
