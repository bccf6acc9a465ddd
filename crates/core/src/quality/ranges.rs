//! Smallest and largest value of each measure over the simplices of a tiling: the
//! columns of the paper's Table 1.

use super::measure::{DihedralAngle, RadiusEdge};
use super::shape::Shape;
use crate::tiling::{SimplexId, Tiling};
use acutile_exact::geometry::linear;

/// The measures of one simplex, hence of its congruence class.
#[derive(Clone, Debug)]
pub struct Measures {
    /// Circumradius over shortest edge.
    pub radius_edge: RadiusEdge,
    /// All dihedral angles, D (D + 1) / 2 of them, by size.
    pub angles: Vec<DihedralAngle>,
}

/// The smallest and the largest of several values.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Range<T> {
    /// The smallest value.
    pub min: T,
    /// The largest value.
    pub max: T,
}

/// The six figures of a row of Table 1.
#[derive(Clone, Debug)]
pub struct Ranges {
    /// Circumradius over shortest edge.
    pub radius_edge: Range<RadiusEdge>,
    /// Over the simplices, of the smallest dihedral angle of each.
    pub smallest_dihedral: Range<DihedralAngle>,
    /// Over the simplices, of the largest dihedral angle of each.
    pub largest_dihedral: Range<DihedralAngle>,
}

/// The measures of the simplex with this index; `None` if it is flat.
pub fn measures<const D: usize>(tiling: &Tiling<D>, simplex: SimplexId) -> Option<Measures> {
    let simplex = tiling.shape(simplex);
    let products = simplex.normal_products(&linear::cofactors(&tiling.frame.gram));
    let mut angles: Vec<DihedralAngle> = (0..=D)
        .flat_map(|i| (i + 1..=D).map(move |j| (i, j)))
        .map(|(i, j)| DihedralAngle::between(&products, i, j))
        .collect::<Option<_>>()?;
    angles.sort_unstable();
    Some(Measures {
        radius_edge: RadiusEdge::of(&simplex, &tiling.frame.gram)?,
        angles,
    })
}

/// The measures of each congruence class; `None` if one is flat.
pub fn measures_of_shapes<const D: usize>(
    tiling: &Tiling<D>,
    shapes: &[Shape],
) -> Option<Vec<Measures>> {
    shapes
        .iter()
        .map(|shape| measures(tiling, shape.members[0]))
        .collect()
}

/// The smallest and the largest of each measure; `None` where there is nothing.
pub fn ranges(measures: &[Measures]) -> Option<Ranges> {
    Some(Ranges {
        radius_edge: range(measures.iter().map(|m| &m.radius_edge))?,
        smallest_dihedral: range(measures.iter().filter_map(|m| m.angles.first()))?,
        largest_dihedral: range(measures.iter().filter_map(|m| m.angles.last()))?,
    })
}

fn range<'a, T: Ord + Clone + 'a>(values: impl Iterator<Item = &'a T> + Clone) -> Option<Range<T>> {
    Some(Range {
        min: values.clone().min()?.clone(),
        max: values.max()?.clone(),
    })
}
