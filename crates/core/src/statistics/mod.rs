//! Quality of a mesh: how its dihedral angles are distributed, the extreme ones and who has them,
//! radius-edge ratios, aspect ratios.
//!
//! Counts and extremes are exact. Doubles with a proved error decide most angles, and exact
//! arithmetic decides the rest. Aspect ratios are doubles and are called so. Nothing is proved
//! about the tiling as a whole.

mod bins;
mod chart;
mod counts;
mod data;
mod extreme;

pub use chart::{csv, svg, text};
pub use data::data;
pub use extreme::Extreme;

use crate::checker::{Findings, check_metric};
use crate::predicates::Model;
use crate::quality::exact_ranges;
use crate::tiling::dimension::same;
use crate::tiling::{SimplexId, Tiling};
use counts::{Counts, counts};
use extreme::Members;

/// A dihedral angle of a tiling: the simplex and the two facets, each named by the corner
/// opposite to it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    /// The simplex.
    pub simplex: SimplexId,
    /// The two facets that meet in the angle, by their opposite corners.
    pub facets: (usize, usize),
}

/// The figures of a tiling.
#[derive(Clone, Debug)]
pub struct Statistics {
    /// Simplices, with those left out.
    pub simplices: usize,
    /// Flat or negatively oriented simplices; they are left out of everything else.
    pub left_out: Vec<SimplexId>,
    /// Simplices whose angles are all acute; with right angles but none obtuse; with obtuse ones.
    pub kinds: [usize; 3],
    /// Dihedral angles that are acute, right, obtuse.
    pub angles: [usize; 3],
    /// Counts of angles from k w to below (k + 1) w degrees, for the width w = `degrees_per_bin`.
    pub histogram: Vec<usize>,
    /// Width of a bin in degrees; divides 180.
    pub degrees_per_bin: u32,
    /// The smallest dihedral angle.
    pub smallest: Option<Extreme<Place>>,
    /// The largest dihedral angle.
    pub largest: Option<Extreme<Place>>,
    /// The smallest radius-edge ratio, circumradius over shortest edge (Eppstein, Sullivan, Üngör,
    /// Table 1).
    pub lowest_ratio: Option<Extreme<SimplexId>>,
    /// The largest radius-edge ratio.
    pub highest_ratio: Option<Extreme<SimplexId>>,
    /// Least and greatest aspect ratio in doubles, with a simplex that has it. It is the longest edge
    /// divided by √(2D(D+1)) times the inradius, and 1 for the regular simplex. See Knupp et al., The
    /// Verdict Library Reference Manual, SAND2007-1751.
    pub aspects: Option<[(f64, SimplexId); 2]>,
}

/// The figures of `tiling`, with angles counted in bins of `degrees_per_bin`, a divisor of 180.
///
/// # Errors
/// A Gram matrix that is not positive definite: then there are no angles.
pub fn statistics<const D: usize>(
    tiling: &Tiling<D>,
    degrees_per_bin: u32,
) -> Result<Statistics, Findings> {
    let mut findings = Findings::new(1);
    check_metric(&tiling.frame, &mut findings);
    if !findings.is_empty() {
        return Err(findings);
    }
    Ok(match D {
        2 => of_plane(same(tiling), degrees_per_bin),
        _ => of_space(same(tiling), degrees_per_bin),
    })
}

#[inline(never)]
fn of_plane(tiling: &Tiling<2>, degrees_per_bin: u32) -> Statistics {
    of_tiling(tiling, degrees_per_bin)
}

#[inline(never)]
fn of_space(tiling: &Tiling<3>, degrees_per_bin: u32) -> Statistics {
    of_tiling(tiling, degrees_per_bin)
}

fn of_tiling<const D: usize>(tiling: &Tiling<D>, degrees_per_bin: u32) -> Statistics {
    let model = Model::new(tiling);
    let counts = counts(&model, degrees_per_bin);
    let mut statistics = Statistics::of(tiling.len(), degrees_per_bin, counts);
    if statistics.left_out.is_empty() {
        let members = Members {
            model: &model,
            names: None,
        };
        statistics.add_extremes(&members);
    } else {
        let (part, names) = tiling.without(&statistics.left_out);
        let members = Members {
            model: &Model::new(&part),
            names: Some(&names),
        };
        statistics.add_extremes(&members);
    }
    statistics
}

impl Statistics {
    fn of(simplices: usize, degrees_per_bin: u32, counts: Counts) -> Self {
        Statistics {
            simplices,
            left_out: counts.left_out,
            kinds: counts.kinds,
            angles: counts.angles,
            histogram: counts.histogram,
            degrees_per_bin,
            smallest: None,
            largest: None,
            lowest_ratio: None,
            highest_ratio: None,
            aspects: counts.aspects,
        }
    }

    fn add_extremes<const D: usize>(&mut self, members: &Members<D>) {
        let Some(ranges) = exact_ranges(members.model) else {
            return;
        };
        self.smallest = Some(members.with_angle(&ranges.smallest_dihedral.min));
        self.largest = Some(members.with_angle(&ranges.largest_dihedral.max));
        self.lowest_ratio = Some(members.with_ratio(&ranges.radius_edge.min));
        self.highest_ratio = Some(members.with_ratio(&ranges.radius_edge.max));
    }
}
