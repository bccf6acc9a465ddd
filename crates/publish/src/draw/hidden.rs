//! Hidden lines: which parts of a segment are behind faces.
//!
//! A point P is hidden by a face if P + t v lies in it for some t > 0, v the direction to the
//! eye. On a segment P(s) = a + s (b - a) these are linear inequalities in s: one for each side
//! of the face, one for the depth. So they hold on an interval. Its ends are exact, and so is a union
//! of intervals.

use super::polygon::{Face, Plane, Point, extent};
use acutile_exact::geometry::Sign;
use acutile_exact::number::Number;
use malachite::Rational;

/// A part of a segment, from < to in [0, 1].
#[derive(Clone, Debug)]
pub struct Part {
    /// The parameter at which the part begins.
    pub from: Number,
    /// The parameter at which it ends.
    pub to: Number,
    /// Whether no face covers it.
    pub is_visible: bool,
}

/// The segment from a to b in parts, visible ones and hidden ones by turns.
pub fn parts(a: &Point, b: &Point, faces: &[Face], eye: &Point) -> Vec<Part> {
    let own = extent(&[a.clone(), b.clone()], eye).expect("the line of sight is not zero");
    let mut shadows: Vec<[Number; 2]> = faces
        .iter()
        .filter(|face| !face.is_beside(&own))
        .filter_map(|face| shadow(a, b, face))
        .collect();
    shadows.sort();
    let mut parts: Vec<Part> = Vec::new();
    let mut reached = Number::zero();
    for [from, to] in shadows {
        if from > reached {
            parts.push(part(&reached, &from, true));
        }
        let start = from.max(reached.clone());
        if to > start {
            match parts.last_mut() {
                Some(last) if !last.is_visible => last.to = to.clone(),
                _ => parts.push(part(&start, &to, false)),
            }
            reached = to;
        }
    }
    if reached < one() {
        parts.push(part(&reached, &one(), true));
    }
    parts
}

/// Whether no face is before the point.
pub fn is_visible(point: &Point, faces: &[Face]) -> bool {
    !faces.iter().any(|face| {
        face.plane.value(point).sign().is_lt()
            && face.shadow().all(|plane| plane.value(point).sign().is_ge())
    })
}

fn part(from: &Number, to: &Number, is_visible: bool) -> Part {
    Part {
        from: from.clone(),
        to: to.clone(),
        is_visible,
    }
}

fn one() -> Number {
    Number::from(Rational::from(1))
}

/// The parameters of the points of ab behind the face, if these are more than one. A
/// segment in the plane of the face is not behind it.
fn shadow(a: &Point, b: &Point, face: &Face) -> Option<[Number; 2]> {
    let values = |plane: &Plane| (plane.value(a), plane.value(b));
    let (depth_a, depth_b) = values(&face.plane);
    if depth_a.is_zero() && depth_b.is_zero() {
        return None;
    }
    let mut interval = [Number::zero(), one()];
    for plane in face.shadow() {
        let (at_a, at_b) = values(&plane);
        clip(&mut interval, &at_a, &at_b)?;
    }
    Some(interval)
}

/// Restricts the interval to where the linear function with these values at 0 and 1 is
/// at least 0; `None` if no more than a point is left.
fn clip(interval: &mut [Number; 2], at_0: &Number, at_1: &Number) -> Option<()> {
    match (at_0.sign(), at_1.sign()) {
        (Sign::Less, Sign::Less | Sign::Equal) | (Sign::Equal, Sign::Less) => return None,
        (Sign::Less, Sign::Greater) => {
            let root = at_0.divide(&(at_0 - at_1))?;
            interval[0] = root.max(interval[0].clone());
        }
        (Sign::Greater, Sign::Less) => {
            let root = at_0.divide(&(at_0 - at_1))?;
            interval[1] = root.min(interval[1].clone());
        }
        _ => {}
    }
    (interval[0] < interval[1]).then_some(())
}
