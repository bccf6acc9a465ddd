//! Boxes of parameters: products of intervals, each end open or closed.

use crate::number::Number;
use malachite::Rational;
use std::fmt;

/// An end of an interval.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct End {
    /// Where it is.
    pub value: Number,
    /// Whether the point itself is left out.
    pub is_open: bool,
}

impl End {
    /// An end that belongs to the interval.
    pub fn closed(value: Number) -> Self {
        End {
            value,
            is_open: false,
        }
    }

    /// An end that does not.
    pub fn open(value: Number) -> Self {
        End {
            value,
            is_open: true,
        }
    }
}

/// An interval from a lower end to a higher one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Side {
    pub low: End,
    pub high: End,
}

impl Side {
    /// The middle.
    pub fn middle(&self) -> Number {
        (&self.low.value + &self.high.value) * Number::from(Rational::from_signeds(1, 2))
    }

    /// The distance of the ends.
    pub fn length(&self) -> Number {
        &self.high.value - &self.low.value
    }

    /// Whether it contains a number.
    pub fn contains(&self, value: &Number) -> bool {
        let above = match self.low.is_open {
            true => *value > self.low.value,
            false => *value >= self.low.value,
        };
        let below = match self.high.is_open {
            true => *value < self.high.value,
            false => *value <= self.high.value,
        };
        above && below
    }

    /// The ends that belong to it.
    pub fn closed_ends(&self) -> impl Iterator<Item = &Number> {
        let ends = [&self.low, &self.high].into_iter();
        ends.filter(|end| !end.is_open).map(|end| &end.value)
    }
}

/// `[8/3, 7/2)`
impl fmt::Display for Side {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let left = if self.low.is_open { '(' } else { '[' };
        let right = if self.high.is_open { ')' } else { ']' };
        write!(f, "{left}{}, {}{right}", self.low.value, self.high.value)
    }
}

/// A box: the product of its sides, one for each parameter.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cuboid {
    pub sides: Vec<Side>,
}

impl Cuboid {
    /// The closed box with these ends.
    pub fn closed(ends: &[(Rational, Rational)]) -> Self {
        let end = |x: &Rational| End::closed(Number::from(x.clone()));
        let side = |(low, high): &(Rational, Rational)| Side {
            low: end(low),
            high: end(high),
        };
        Cuboid {
            sides: ends.iter().map(side).collect(),
        }
    }

    /// The point in the middle.
    pub fn center(&self) -> Vec<Number> {
        self.sides.iter().map(Side::middle).collect()
    }

    /// Whether it contains a point.
    pub fn contains(&self, point: &[Number]) -> bool {
        self.sides
            .iter()
            .zip(point)
            .all(|(side, x)| side.contains(x))
    }

    /// The corners that belong to it.
    pub fn corners(&self) -> Vec<Vec<Number>> {
        self.sides.iter().fold(vec![Vec::new()], |corners, side| {
            let with = |corner: &Vec<Number>| {
                let corner = corner.clone();
                side.closed_ends().map(move |end| {
                    let end = std::iter::once(end.clone());
                    corner.iter().cloned().chain(end).collect()
                })
            };
            corners
                .iter()
                .flat_map(|corner| with(corner).collect::<Vec<_>>())
                .collect()
        })
    }

    /// The two halves along a side. Their common end belongs to both.
    pub fn halves(&self, axis: usize) -> [Cuboid; 2] {
        let middle = End::closed(self.sides[axis].middle());
        let (mut low, mut high) = (self.clone(), self.clone());
        low.sides[axis].high = middle.clone();
        high.sides[axis].low = middle;
        [low, high]
    }
}
