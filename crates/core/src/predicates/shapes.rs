//! What is asked of every simplex first, found in one pass: orientation, and angles
//! against right angles. Called by the checker.

use super::model::Model;
use super::polynomials::Shape;
use super::signs::Signs;
use std::ops::Range;

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

impl<const D: usize> Model<'_, D> {
    /// The shapes of all simplices; computed when it is asked for first.
    pub fn shapes(&self) -> &Shapes {
        self.shapes.get_or_init(|| Shapes::of(self))
    }
}

impl Shapes {
    fn of<const D: usize>(model: &Model<D>) -> Self {
        let shape = model.prepare(Shape);
        let parts = model.by_chunks(|simplices: Range<usize>| {
            let mut part = Shapes::default();
            shape.for_each(simplices, |simplex, signs| {
                let (orientation, angles) = signs.split_first();
                if !(orientation.all_positive() && angles.all_negative()) {
                    part.add(simplex as u32, orientation.all_positive(), angles);
                }
            });
            part
        });
        let list = |of: fn(&Shapes) -> &Vec<u32>| parts.iter().flat_map(of).copied().collect();
        Shapes {
            not_positive: list(|part| &part.not_positive),
            not_acute: list(|part| &part.not_acute),
            obtuse: list(|part| &part.obtuse),
        }
    }

    #[cold]
    fn add(&mut self, simplex: u32, is_positive: bool, angles: Signs) {
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
