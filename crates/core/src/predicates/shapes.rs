//! The simplices that are not as hoped for: orientation, and angles against right angles.

use super::signs::Signs;

/// The simplices, in order, that are not as hoped for.
#[derive(Clone, Debug, Default)]
pub struct Shapes {
    /// Flat or negatively oriented.
    pub not_positive: Vec<u32>,
    /// With a dihedral angle that is right or obtuse.
    pub not_acute: Vec<u32>,
    /// With an obtuse dihedral angle.
    pub obtuse: Vec<u32>,
}

impl Shapes {
    /// Adds a simplex by what fails.
    #[cold]
    pub(super) fn add(&mut self, simplex: u32, is_positive: bool, angles: Signs) {
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
