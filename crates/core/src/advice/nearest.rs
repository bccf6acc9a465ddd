//! For a facet without a mate, the free facet that was probably meant, and by how much it misses.

use super::place::{Places, facet_corners, mean};
use crate::quality::permutations;
use crate::tiling::{Corner, Facet, Tiling};
use acutile_exact::geometry::linear;
use acutile_exact::number::Number;

/// The free facet nearest to another.
#[derive(Clone, Debug, PartialEq)]
pub struct Near<const D: usize> {
    /// The other facet.
    pub facet: Facet,
    /// Its corners, moved by a lattice vector to where they are nearest, in the order of the
    /// corners of the first facet.
    pub corners: Vec<Corner<D>>,
    /// The square of the largest distance between corresponding corners.
    pub squared_distance: Number,
}

/// The free facet, up to lattice translations and the order of its corners, whose farthest corner
/// is nearest to that of `facet`. Doubles choose it; the distance is exact.
pub fn nearest<const D: usize>(
    tiling: &Tiling<D>,
    places: &Places<D>,
    facet: Facet,
    free: &[Facet],
) -> Option<Near<D>> {
    let corners = facet_corners(tiling, facet);
    let others = free.iter().filter(|other| **other != facet);
    let candidates = others.map(|&other| (other, closest_image(tiling, places, &corners, other)));
    let (other, (_, image)) = candidates.min_by(|a, b| a.1.0.total_cmp(&b.1.0))?;
    let distances = corners.iter().zip(&image).map(|(a, b)| {
        let across = linear::subtract(&tiling.position(a), &tiling.position(b));
        linear::square(&tiling.frame.gram, &across)
    });
    Some(Near {
        facet: other,
        squared_distance: distances.max()?,
        corners: image,
    })
}

/// The best image of a facet, with the square of its largest distance.
fn closest_image<const D: usize>(
    tiling: &Tiling<D>,
    places: &Places<D>,
    corners: &[Corner<D>],
    other: Facet,
) -> (f64, Vec<Corner<D>>) {
    let wanted: Vec<[f64; D]> = corners.iter().map(|c| places.position(c)).collect();
    let there = facet_corners(tiling, other);
    let here: Vec<[f64; D]> = there.iter().map(|c| places.position(c)).collect();
    let shift = places.shift_between(&mean(&here), &mean(&wanted));
    let moved: Vec<Corner<D>> = there.iter().map(|c| c.moved(shift)).collect();
    let orders = permutations(D).into_iter().map(|order| {
        let image: Vec<Corner<D>> = order.iter().map(|&k| moved[k]).collect();
        let distance = image
            .iter()
            .zip(&wanted)
            .map(|(corner, point)| places.squared_distance(&places.position(corner), point));
        (distance.fold(0.0, f64::max), image)
    });
    orders
        .min_by(|a, b| a.0.total_cmp(&b.0))
        .unwrap_or((f64::INFINITY, moved.clone()))
}
