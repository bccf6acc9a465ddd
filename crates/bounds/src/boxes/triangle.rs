//! Enclosures for a spherical triangle with three given angles.

use crate::arithmetic::{Arithmetic, Function};
use crate::enclosure::{Enclosures, enclosed_pi, point};
use acutile_exact::number::Interval;
use malachite::Rational;
use std::collections::BTreeMap;

const E: Enclosures = Enclosures;

/// Numbers that depend on theta only, with the names of docs/lower-bound.md.
#[derive(Clone)]
pub struct Constants {
    pub a0: Rational,
    pub kappa: Rational,
    pub cos_squared: Interval,
    pub sin_squared: Interval,
    pub k: Interval,
    pub c: Interval,
    /// m = (3 - 9 cos² theta)/2
    pub most: Interval,
    /// 180/π
    pub radian: Interval,
}

/// Cosines and sines of angles in degrees that were asked for before.
#[derive(Default)]
pub struct Angles(BTreeMap<Rational, [Interval; 2]>);

/// A triangle with angles a0 + e_i.
pub struct Corner {
    pub excess: [Rational; 3],
    pub cos: [Interval; 3],
    pub sin: [Interval; 3],
    /// The cosines of the sides.
    sides: [Interval; 3],
}

/// Operations as methods, for short formulas.
pub trait Operations: Sized {
    fn and(&self, other: &Self) -> Self;
    fn minus(&self, other: &Self) -> Self;
    fn by(&self, other: &Self) -> Self;
    fn plus(&self, value: &Rational) -> Self;
    fn scaled(&self, factor: &Rational) -> Self;
    fn negated(&self) -> Self;
}

impl Operations for Interval {
    fn and(&self, other: &Interval) -> Interval {
        E.sum(self, other)
    }
    fn minus(&self, other: &Interval) -> Interval {
        E.difference(self, other)
    }
    fn by(&self, other: &Interval) -> Interval {
        E.product(self, other)
    }
    fn plus(&self, value: &Rational) -> Interval {
        E.sum(self, &point(value))
    }
    fn scaled(&self, factor: &Rational) -> Interval {
        E.product(self, &point(factor))
    }
    fn negated(&self) -> Interval {
        Interval {
            lo: -&self.hi,
            hi: -&self.lo,
        }
    }
}

fn divided(x: &Interval, y: &Interval) -> Result<Interval, String> {
    Ok(x.by(&E.inverse(y)?))
}

impl Constants {
    /// The constants at theta degrees. C is that of section 14, with x >= 60.
    ///
    /// # Errors
    /// A division by a number that may be zero, or an angle out of range.
    pub fn at(theta: &Rational) -> Result<Constants, String> {
        let a0 = Rational::from(360) - Rational::from(4) * theta;
        let [c, s] = Angles::default().at(theta)?;
        let [_, sin_a0] = Angles::default().at(&a0)?;
        let one = point(&Rational::from(1));
        let (cos_squared, sin_squared) = (c.by(&c), s.by(&s));
        let sin_60 = E.root(&point(&Rational::from_signeds(3, 4)))?;
        let half = Rational::from_signeds(1, 2);
        let above = one.minus(&c).scaled(&half).by(&sin_squared);
        let nine_halves = Rational::from_signeds(9, 2);
        Ok(Constants {
            kappa: Rational::from(5) * theta - Rational::from(360),
            k: E.inverse(&s.by(&c).scaled(&Rational::from(2)))?,
            c: divided(&above, &c.by(&sin_a0).by(&sin_60))?,
            most: cos_squared
                .scaled(&nine_halves)
                .negated()
                .plus(&Rational::from_signeds(3, 2)),
            radian: divided(&point(&Rational::from(180)), &enclosed_pi())?,
            a0,
            cos_squared,
            sin_squared,
        })
    }

    /// The cosine of x for a side with this cosine.
    fn cos_x(&self, cos_side: &Interval) -> Interval {
        self.sin_squared.by(cos_side).minus(&self.cos_squared)
    }
}

impl Angles {
    /// The cosine and the sine of an angle from 0 to 90 degrees.
    fn at(&mut self, degrees: &Rational) -> Result<[Interval; 2], String> {
        if let Some(found) = self.0.get(degrees) {
            return Ok(found.clone());
        }
        let angle = point(degrees);
        let values = [
            E.apply(Function::Cos, &angle)?,
            E.apply(Function::Sin, &angle)?,
        ];
        self.0.insert(degrees.clone(), values.clone());
        Ok(values)
    }
}

impl Corner {
    /// The triangle with angles a0 + e_i.
    ///
    /// # Errors
    /// An angle out of range.
    pub fn at(
        excess: &[Rational; 3],
        constants: &Constants,
        angles: &mut Angles,
    ) -> Result<Corner, String> {
        let [x, y, z] = excess.each_ref().map(|e| angles.at(&(&constants.a0 + e)));
        let [[cos_x, sin_x], [cos_y, sin_y], [cos_z, sin_z]] = [x?, y?, z?];
        let (cos, sin) = ([cos_x, cos_y, cos_z], [sin_x, sin_y, sin_z]);
        let [x, y, z] = [0, 1, 2].map(|i| cos_side(i, &cos, &sin));
        Ok(Corner {
            excess: excess.clone(),
            sides: [x?, y?, z?],
            cos,
            sin,
        })
    }

    /// The sum of the cosines of the angles.
    pub fn sum_of_cosines(&self) -> Interval {
        let [x, y, z] = &self.cos;
        x.and(y).and(z)
    }

    /// x of the side opposite angle i, in degrees.
    ///
    /// # Errors
    /// A cosine beyond -1 or 1.
    pub fn x(&self, i: usize, constants: &Constants) -> Result<Interval, String> {
        E.apply(Function::Arccos, &constants.cos_x(&self.sides[i]))
    }
}

/// cos a = (cos A + cos B cos C)/(sin B sin C)
fn cos_side(i: usize, cos: &[Interval; 3], sin: &[Interval; 3]) -> Result<Interval, String> {
    let (j, k) = ((i + 1) % 3, (i + 2) % 3);
    divided(&cos[i].and(&cos[j].by(&cos[k])), &sin[j].by(&sin[k]))
}

/// Lower bounds, on the box between two corners, of the derivative of x_i by e_v.
///
/// It is sin² theta sin A_i/(sin A_j sin A_k sin x_i) for v = i, and the same times the cosine of the
/// side opposite A_k for v = j. All angles, sides and x are acute, and sides and x grow with the
/// angles. So each factor has its least value at one of the two corners.
pub fn slopes(
    low: &Corner,
    high: &Corner,
    constants: &Constants,
) -> Result<[[Rational; 3]; 3], String> {
    let one = point(&Rational::from(1));
    let row = |i: usize| -> Result<[Rational; 3], String> {
        let cos_x = constants.cos_x(&high.sides[i]);
        let sin_x = E.root(&one.minus(&cos_x.by(&cos_x)))?;
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        let below = high.sin[j].by(&high.sin[k]).by(&sin_x);
        let own = divided(&constants.sin_squared.by(&low.sin[i]), &below)?;
        let mut row = [0, 1, 2].map(|_| own.lo.clone());
        row[j] = own.by(&high.sides[k]).lo;
        row[k] = own.by(&high.sides[j]).lo;
        Ok(row)
    };
    Ok([row(0)?, row(1)?, row(2)?])
}
