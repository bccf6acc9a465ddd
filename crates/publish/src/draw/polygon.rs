//! Exact convex polygons in space, and planes that cut them.
//!
//! Everything here is affine: a line of sight hits a polygon in every basis or in none. So points
//! are taken in basis coordinates, and no length is needed.

use acutile_exact::geometry::{Sign, linear};
use acutile_exact::number::Number;

/// Basis coordinates.
pub type Point = [Number; 3];

/// The affine function n · x - c, and the plane where it is 0.
#[derive(Clone, Debug)]
pub struct Plane {
    normal: Point,
    offset: Number,
}

impl Plane {
    /// Through a point, along two vectors; `None` if they are parallel.
    pub fn spanned(point: &Point, u: &Point, v: &Point) -> Option<Plane> {
        let normal = linear::cross(u, v);
        let offset = linear::dot(&normal, point);
        let is_plane = normal.iter().any(|x| !x.is_zero());
        is_plane.then_some(Plane { normal, offset })
    }

    /// n · x - c
    pub fn value(&self, point: &Point) -> Number {
        &linear::dot(&self.normal, point) - &self.offset
    }

    /// n · v
    pub fn slope(&self, vector: &Point) -> Number {
        linear::dot(&self.normal, vector)
    }

    /// The negative function.
    pub fn turned(&self) -> Plane {
        Plane {
            normal: self.normal.each_ref().map(|x| -x),
            offset: -&self.offset,
        }
    }
}

/// A polygon that the line of sight crosses, seen from the eye.
#[derive(Clone, Debug)]
pub struct Face {
    /// In cyclic order; at least three.
    pub corners: Vec<Point>,
    /// Greater than 0 on the side of the eye.
    pub plane: Plane,
    /// The planes of sight through the sides; all at least 0 before and behind the polygon.
    sides: Vec<Plane>,
    /// The least and the greatest of two coordinates of the projection.
    extent: [[Number; 2]; 2],
}

impl Face {
    /// The triangle, seen in the direction against `eye`; `None` if it is seen as a segment.
    pub fn triangle(corners: [Point; 3], eye: &Point) -> Option<Face> {
        Face::polygon(corners.to_vec(), eye)
    }

    /// A strictly convex plane polygon, its corners in cyclic order; `None` if it is seen as a segment.
    pub fn polygon(corners: Vec<Point>, eye: &Point) -> Option<Face> {
        let [a, b, c, ..] = &corners[..] else {
            return None;
        };
        let plane = Plane::spanned(a, &linear::subtract(b, a), &linear::subtract(c, a))?;
        let plane = match plane.slope(eye).sign() {
            Sign::Greater => plane,
            Sign::Less => plane.turned(),
            Sign::Equal => return None,
        };
        let count = corners.len();
        let sides = (0..count)
            .map(|k| {
                let [p, q, inside] = [0, 1, 2].map(|step| &corners[(k + step) % count]);
                let side = Plane::spanned(p, &linear::subtract(q, p), eye)?;
                let is_inward = side.value(inside).sign().is_gt();
                Some(if is_inward { side } else { side.turned() })
            })
            .collect::<Option<Vec<Plane>>>()?;
        let extent = extent(&corners, eye)?;
        Some(Face {
            corners,
            plane,
            sides,
            extent,
        })
    }

    /// The part of `polygon` that has an area and lies before, in or behind this one.
    pub fn overlap(&self, polygon: &[Point]) -> Option<Vec<Point>> {
        self.sides
            .iter()
            .try_fold(polygon.to_vec(), |rest, side| cut(&rest, side).positive)
    }

    /// Whether the projections are apart by their extents; `false` says nothing.
    pub fn is_beside(&self, other: &[[Number; 2]; 2]) -> bool {
        let mut pairs = self.extent.iter().zip(other);
        pairs.any(|([low, high], [l, h])| low > h || l > high)
    }

    /// See [`Face::is_beside`].
    pub fn extent(&self) -> &[[Number; 2]; 2] {
        &self.extent
    }

    /// The functions of the sides, and the depth beyond the face's plane. All are at least 0 where a
    /// point is hidden, and not all of them on the plane.
    pub fn shadow(&self) -> impl Iterator<Item = Plane> {
        let behind = std::iter::once(self.plane.turned());
        self.sides.iter().cloned().chain(behind)
    }
}

/// The least and the greatest value of x_i v_k - x_k v_i for some k with v_k ≠ 0 and the two other i.
/// Both functions are constant along the line of sight v. `None` without points, or if v is zero.
pub fn extent(points: &[Point], eye: &Point) -> Option<[[Number; 2]; 2]> {
    let k = (0..3).find(|&k| !eye[k].is_zero())?;
    let range = |step: usize| {
        let i = (k + step) % 3;
        let values = points
            .iter()
            .map(|x| &(&x[i] * &eye[k]) - &(&x[k] * &eye[i]));
        let values: Vec<Number> = values.collect();
        let least = values.iter().min().cloned()?;
        let greatest = values.into_iter().max()?;
        Some([least, greatest])
    };
    Some([range(1)?, range(2)?])
}

/// The parts of a polygon on the two sides of a plane, where they have an area; neither
/// for a polygon in the plane.
#[derive(Clone, Debug)]
pub struct Cut {
    /// The part on the positive side.
    pub positive: Option<Vec<Point>>,
    /// The part on the negative side.
    pub negative: Option<Vec<Point>>,
}

/// Cuts a convex polygon.
pub fn cut(polygon: &[Point], plane: &Plane) -> Cut {
    let values: Vec<Number> = polygon.iter().map(|p| plane.value(p)).collect();
    let signs: Vec<Sign> = values.iter().map(Number::sign).collect();
    let part = |side: Sign| {
        if !signs.contains(&side) {
            return None;
        }
        if !signs.contains(&side.reverse()) {
            return Some(polygon.to_vec());
        }
        let mut part = Vec::new();
        for i in 0..polygon.len() {
            let next = (i + 1) % polygon.len();
            if signs[i] != side.reverse() {
                part.push(polygon[i].clone());
            }
            if signs[i].is_ne() && signs[next] == signs[i].reverse() {
                part.extend(between(
                    &polygon[i],
                    &polygon[next],
                    &values[i],
                    &values[next],
                ));
            }
        }
        Some(part)
    };
    Cut {
        positive: part(Sign::Greater),
        negative: part(Sign::Less),
    }
}

/// The point of the segment pq where an affine function with these values at the ends, of
/// different sign, is 0.
fn between(p: &Point, q: &Point, at_p: &Number, at_q: &Number) -> Option<Point> {
    let s = at_p.divide(&(at_p - at_q))?;
    Some(on_segment(p, q, &s))
}

/// p + s (q - p)
pub fn on_segment(p: &Point, q: &Point, s: &Number) -> Point {
    std::array::from_fn(|k| &p[k] + &(s * &(&q[k] - &p[k])))
}
