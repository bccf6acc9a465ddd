//! Triangles and segments in space: whether they meet, and where.
//!
//! Exact over any [`Scalar`], all degenerate positions included. Points are those of an affine
//! basis; no metric enters. The kernel
//! decides the same by separating planes, without a word of this.

use super::{Scalar, Sign, linear};

/// A point of space.
pub type Point<S> = [S; 3];

/// The point `numerators / denominator`.
#[derive(Clone, Debug)]
pub struct Quotient<S> {
    /// The numerators of the three coordinates.
    pub numerators: Point<S>,
    /// Not zero.
    pub denominator: S,
}

/// A triangle that is not flat, with its plane n · x = c.
#[derive(Clone, Debug)]
pub struct Triangle<'p, S> {
    /// The corners a, b and c.
    pub corners: [&'p Point<S>; 3],
    /// (b - a) × (c - a)
    pub normal: Point<S>,
    offset: S,
}

impl<'p, S: Scalar> Triangle<'p, S> {
    /// The triangle with these corners; `None` if they are on a line.
    pub fn new(corners: [&'p Point<S>; 3]) -> Option<Self> {
        let [a, b, c] = corners;
        let normal = linear::cross(&linear::subtract(b, a), &linear::subtract(c, a));
        normal.iter().any(|x| x.sign().is_ne()).then(|| Triangle {
            corners,
            offset: linear::dot(&normal, a),
            normal,
        })
    }

    /// n · x - c: zero in the plane.
    pub fn value(&self, point: &Point<S>) -> S {
        linear::dot(&self.normal, point).minus(&self.offset)
    }

    fn sides(&self) -> [(&'p Point<S>, &'p Point<S>); 3] {
        let [a, b, c] = self.corners;
        [(a, b), (b, c), (c, a)]
    }

    /// A common point of this triangle and the segment from p to q, p ≠ q.
    pub fn meets_segment(&self, p: &Point<S>, q: &Point<S>) -> Option<Quotient<S>> {
        let (at_p, at_q) = (self.value(p), self.value(q));
        match (at_p.sign(), at_q.sign()) {
            (Sign::Equal, Sign::Equal) => self.meets_coplanar(p, q),
            (Sign::Less, Sign::Less) | (Sign::Greater, Sign::Greater) => None,
            _ => self.is_pierced(p, q).then(|| between(p, q, &at_p, &at_q)),
        }
    }

    /// Whether the line pq, which is not in the plane, meets the triangle: its orientations with
    /// respect to the sides do not have opposite signs.
    fn is_pierced(&self, p: &Point<S>, q: &Point<S>) -> bool {
        let along = linear::subtract(q, p);
        let [a, b, c] = self.corners.map(|corner| linear::subtract(corner, p));
        let turn = |x, y| linear::dot(&along, &linear::cross(x, y)).sign();
        let signs = [turn(&a, &b), turn(&b, &c), turn(&c, &a)];
        !(signs.contains(&Sign::Less) && signs.contains(&Sign::Greater))
    }

    /// The same for a segment in the plane of the triangle, projected along an axis that the plane
    /// does not contain. If neither end is in the triangle, the segment crosses a side that
    /// is not parallel to it, or misses the triangle.
    fn meets_coplanar(&self, p: &Point<S>, q: &Point<S>) -> Option<Quotient<S>> {
        let axis = self.axis()?;
        if let Some(end) = [p, q].into_iter().find(|end| self.holds(end, axis)) {
            return Some(whole(end));
        }
        let mut sides = self.sides().into_iter();
        sides.find_map(|side| crossing((p, q), side, axis))
    }

    /// An axis that the plane does not contain.
    fn axis(&self) -> Option<usize> {
        (0..3).find(|&k| self.normal[k].sign().is_ne())
    }

    /// Whether a point of the plane is in the triangle.
    fn holds(&self, point: &Point<S>, axis: usize) -> bool {
        let signs = self.sides().map(|(a, b)| turn(a, b, point, axis).sign());
        !(signs.contains(&Sign::Less) && signs.contains(&Sign::Greater))
    }
}

/// A common point, not on the edge bc, of the triangles bcp and bcq, which are not flat. There
/// is one if they lie in one plane on the same side of the edge: p, or q, or a crossing of sides.
pub fn folded<S: Scalar>(
    [b, c]: [&Point<S>; 2],
    p: &Point<S>,
    q: &Point<S>,
) -> Option<Quotient<S>> {
    let (at_p, at_q) = (Triangle::new([b, c, p])?, Triangle::new([b, c, q])?);
    let coplanar = at_p.value(q).sign().is_eq();
    if !coplanar || linear::dot(&at_p.normal, &at_q.normal).sign() != Sign::Greater {
        return None;
    }
    let axis = at_p.axis()?;
    if at_q.holds(p, axis) {
        Some(whole(p))
    } else if at_p.holds(q, axis) {
        Some(whole(q))
    } else {
        crossing((p, b), (q, c), axis).or_else(|| crossing((p, c), (q, b), axis))
    }
}

/// A common point of two closed segments of the plane z = 0, whose ends differ.
pub fn segments_meet<S: Scalar>(
    (p, q): (&Point<S>, &Point<S>),
    (a, b): (&Point<S>, &Point<S>),
) -> Option<Quotient<S>> {
    if turn(a, b, p, 2).sign().is_ne() || turn(a, b, q, 2).sign().is_ne() {
        return crossing((p, q), (a, b), 2);
    }
    let ends = [(p, (a, b)), (q, (a, b)), (a, (p, q)), (b, (p, q))];
    let common = ends.into_iter().find(|(end, line)| is_between(end, *line));
    common.map(|(end, _)| whole(end))
}

/// Whether a point of the line through a and b is on the segment ab.
fn is_between<S: Scalar>(x: &Point<S>, (a, b): (&Point<S>, &Point<S>)) -> bool {
    let product = |k: usize| x[k].minus(&a[k]).times(&x[k].minus(&b[k]));
    (0..3).all(|k| product(k).sign().is_le())
}

/// A common point, not a, of the segments ap and aq in the plane z = 0: the nearer end, if p and
/// q lie in the same direction.
pub fn aligned<S: Scalar>(a: &Point<S>, p: &Point<S>, q: &Point<S>) -> Option<Quotient<S>> {
    if turn(a, p, q, 2).sign().is_ne() {
        return None;
    }
    let nearer = [(p, q), (q, p)].into_iter();
    nearer
        .map(|(near, far)| (near, (a, far)))
        .find(|(near, line)| is_between(near, *line))
        .map(|(near, _)| whole(near))
}

fn whole<S: Scalar>(point: &Point<S>) -> Quotient<S> {
    Quotient {
        numerators: point.clone(),
        denominator: point[0].integer(1),
    }
}

/// The common point of two closed segments in a plane, projected along `axis`, that are not parallel. The
/// ends of neither segment lie strictly on one side of the other segment.
fn crossing<S: Scalar>(
    (p, q): (&Point<S>, &Point<S>),
    (a, b): (&Point<S>, &Point<S>),
    axis: usize,
) -> Option<Quotient<S>> {
    let [at_p, at_q] = [p, q].map(|x| turn(a, b, x, axis));
    let [at_a, at_b] = [a, b].map(|x| turn(p, q, x, axis));
    let apart = |x: &S, y: &S| x.sign() == y.sign() && x.sign().is_ne();
    let parallel = at_p.minus(&at_q).sign().is_eq();
    (!parallel && !apart(&at_p, &at_q) && !apart(&at_a, &at_b)).then(|| between(p, q, &at_p, &at_q))
}

/// The point of pq at which an affine function with these different values at p and q is zero.
fn between<S: Scalar>(p: &Point<S>, q: &Point<S>, at_p: &S, at_q: &S) -> Quotient<S> {
    Quotient {
        numerators: std::array::from_fn(|k| at_p.times(&q[k]).minus(&at_q.times(&p[k]))),
        denominator: at_p.minus(at_q),
    }
}

/// The orientation of a, b, c without their coordinate `axis`.
fn turn<S: Scalar>(a: &Point<S>, b: &Point<S>, c: &Point<S>, axis: usize) -> S {
    let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
    let along = [b[i].minus(&a[i]), b[j].minus(&a[j])];
    let across = [c[i].minus(&a[i]), c[j].minus(&a[j])];
    linear::determinant(&[along, across])
}
