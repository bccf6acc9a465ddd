//! Boxes of parameters: products of intervals, each end open or closed.

use crate::number::Number;
use malachite::Rational;
use malachite::rational::rational::arithmetic::traits::SimplestRationalInInterval;
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
    /// The lower end.
    pub low: End,
    /// The upper end.
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
        let above = if self.low.is_open {
            *value > self.low.value
        } else {
            *value >= self.low.value
        };
        let below = if self.high.is_open {
            *value < self.high.value
        } else {
            *value <= self.high.value
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
    /// One side for each parameter.
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

    /// The closed box around the middle whose sides are shorter by the factor 2^k.
    #[must_use]
    pub fn around_center(&self, k: u32) -> Cuboid {
        let half = Number::from(Rational::from_signeds(1, 2) >> k);
        let smaller = |side: &Side| {
            let (middle, reach) = (side.middle(), &side.length() * &half);
            Side {
                low: End::closed(&middle - &reach),
                high: End::closed(&middle + &reach),
            }
        };
        Cuboid {
            sides: self.sides.iter().map(smaller).collect(),
        }
    }

    /// A point inside, a third of the length away from each lower end.
    pub fn beside_center(&self) -> Vec<Number> {
        let third = Number::from(Rational::from_signeds(1, 3));
        let sides = self.sides.iter();
        let point = sides.map(|side| &side.low.value + &(&side.length() * &third));
        point.collect()
    }

    /// The point inside whose coordinates have the smallest denominators; `None` if an end is irrational.
    pub fn simple_point(&self) -> Option<Vec<Number>> {
        let simple = |side: &Side| {
            let (low, high) = (
                side.low.value.to_rational()?,
                side.high.value.to_rational()?,
            );
            Some(Number::from(Rational::simplest_rational_in_open_interval(
                low, high,
            )))
        };
        self.sides.iter().map(simple).collect()
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

    /// The centers of the facets that belong to it.
    pub fn facet_centers(&self) -> Vec<Vec<Number>> {
        let center = self.center();
        let of_side = |(axis, side): (usize, &Side)| {
            let at = |end: &Number| {
                let mut point = center.clone();
                point[axis] = end.clone();
                point
            };
            side.closed_ends().map(at).collect::<Vec<_>>()
        };
        self.sides.iter().enumerate().flat_map(of_side).collect()
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
