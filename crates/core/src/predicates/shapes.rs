//! The simplices that are not as hoped for: orientation, and angles against right angles.

use super::signs::Signs;
use crate::tiling::SimplexId;

/// The simplices, in order, that are not as hoped for.
#[derive(Clone, Debug, Default)]
pub struct Shapes {
    /// Flat or negatively oriented.
    pub not_positive: Vec<SimplexId>,
    /// With a dihedral angle that is right or obtuse.
    pub not_acute: Vec<SimplexId>,
    /// With an obtuse dihedral angle.
    pub obtuse: Vec<SimplexId>,
}

impl Shapes {
    /// Adds a simplex by the conditions that fail.
    #[cold]
    pub(super) fn add(&mut self, simplex: SimplexId, is_positive: bool, angles: Signs) {
        if !is_positive {
            self.not_positive.push(simplex);
        }
        if !angles.all_negative() {
            self.not_acute.push(simplex);
        }
        if !angles.none_positive() {
            self.obtuse.push(simplex);
        }
    }
}
