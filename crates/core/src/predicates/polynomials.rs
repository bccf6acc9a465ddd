//! The predicates: polynomials in the edges of a simplex, a further point and the
//! metric, written once for every kind of number.
//!
//! The same code is evaluated over several rings. Over [`Bound`](acutile_exact::geometry::Bound)s it gives
//! the error of the doubles and the width of the integers. Over integers, quadratic numbers and numbers of
//! a field it gives the exact values.

use acutile_exact::geometry::{Scalar, Simplex};
use acutile_exact::number::Number;
use malachite::Rational;

/// The Gram matrix, its adjugate, and the predicate's constants, in one ring.
#[derive(Clone, Debug)]
pub struct Metric<S, const D: usize> {
    /// Inner products of the basis vectors, times a positive number.
    pub gram: [[S; D]; D],
    /// Its adjugate, which measures covectors.
    pub cogram: [[S; D]; D],
    /// The type of [`Predicate::constants`].
    pub constants: Vec<S>,
}

/// Values whose signs are asked for.
pub trait Predicate<const D: usize>: Sync {
    /// How many parts the values have; at most [`MOST_PARTS`].
    const PARTS: usize = 1;

    /// Numbers on which the values depend, linearly in all of them together. Their coefficients
    /// are integers.
    fn constants(&self) -> Vec<Number> {
        Vec::new()
    }

    /// The values of one part are homogeneous of this degree in edges and point together.
    fn degree(&self, part: usize) -> i32;

    /// Calls `visit` with each value and its part; at most 32.
    fn values<S: Scalar>(
        &self,
        simplex: &Simplex<S, D>,
        point: &[S; D],
        metric: &Metric<S, D>,
        visit: impl FnMut(usize, &S),
    );
}

/// The most parts of a predicate.
pub const MOST_PARTS: usize = 2;

/// det (e_1, …, e_D)
#[derive(Clone, Copy, Debug)]
pub struct Orientation;

impl<const D: usize> Predicate<D> for Orientation {
    #[inline(always)]
    fn degree(&self, _: usize) -> i32 {
        D as i32
    }

    #[inline(always)]
    fn values<S: Scalar>(
        &self,
        simplex: &Simplex<S, D>,
        _: &[S; D],
        _: &Metric<S, D>,
        mut visit: impl FnMut(usize, &S),
    ) {
        visit(0, &simplex.determinant);
    }
}

/// <g_i, g_j> for the pairs i < j of facets: negative, zero or positive as the
/// dihedral angle is acute, right or obtuse.
#[derive(Clone, Copy, Debug)]
pub struct Angles;

impl<const D: usize> Predicate<D> for Angles {
    #[inline(always)]
    fn degree(&self, _: usize) -> i32 {
        2 * (D as i32 - 1)
    }

    #[inline(always)]
    fn values<S: Scalar>(
        &self,
        simplex: &Simplex<S, D>,
        _: &[S; D],
        metric: &Metric<S, D>,
        mut visit: impl FnMut(usize, &S),
    ) {
        let products = simplex.normal_products(&metric.cogram);
        products.for_pairs(|_, _, product| visit(0, product));
    }
}

/// The value of [`Orientation`], and as a second part those of [`Angles`], of one simplex.
#[derive(Clone, Copy, Debug)]
pub struct Shape;

impl<const D: usize> Predicate<D> for Shape {
    const PARTS: usize = 2;

    #[inline(always)]
    fn degree(&self, part: usize) -> i32 {
        match part {
            0 => Predicate::<D>::degree(&Orientation, 0),
            _ => Predicate::<D>::degree(&Angles, 0),
        }
    }

    #[inline(always)]
    fn values<S: Scalar>(
        &self,
        simplex: &Simplex<S, D>,
        point: &[S; D],
        metric: &Metric<S, D>,
        mut visit: impl FnMut(usize, &S),
    ) {
        Orientation.values(simplex, point, metric, |_, value| visit(0, value));
        Angles.values(simplex, point, metric, |_, value| visit(1, value));
    }
}

/// The value of [`Orientation`], and as a second part the products <g_i, g_j> of one simplex: first
/// those with i = j, then those for the pairs i < j.
#[derive(Clone, Copy, Debug)]
pub struct Products;

impl<const D: usize> Predicate<D> for Products {
    const PARTS: usize = 2;

    #[inline(always)]
    fn degree(&self, part: usize) -> i32 {
        Predicate::<D>::degree(&Shape, part)
    }

    #[inline(always)]
    fn values<S: Scalar>(
        &self,
        simplex: &Simplex<S, D>,
        _: &[S; D],
        metric: &Metric<S, D>,
        mut visit: impl FnMut(usize, &S),
    ) {
        visit(0, &simplex.determinant);
        let products = simplex.normal_products(&metric.cogram);
        for i in 0..=D {
            visit(1, products.get(i, i));
        }
        products.for_pairs(|_, _, product| visit(1, product));
    }
}

/// cos t - c for the dihedral angles t, up to a positive factor, with c |c| = n/d.
///
/// cos t = -p/√q with p = <g_i, g_j> and q = <g_i, g_i> <g_j, g_j>. As x ↦ x |x|
/// grows, cos t - c has the sign of -p |p| d - n q. (In doubles the error of
/// x |x| is that of x x, for |x |x| - y |y|| <= (|x| + |y|) |x - y|.)
#[derive(Clone, Debug)]
pub struct AnglesAgainst {
    bound: Quotient,
}

impl AnglesAgainst {
    /// Against the angle whose cosine has this square, with its sign.
    pub fn new(signed_square: &Number) -> Self {
        AnglesAgainst {
            bound: Quotient::of(signed_square),
        }
    }
}

/// A number as a quotient n/d of one with integer coefficients and a positive integer.
#[derive(Clone, Debug)]
struct Quotient {
    numerator: Number,
    denominator: Number,
}

impl Quotient {
    fn of(number: &Number) -> Self {
        let denominator = Number::from(Rational::from(Number::common_denominator(
            [number].into_iter(),
        )));
        Quotient {
            numerator: number * &denominator,
            denominator,
        }
    }

    fn constants(&self) -> Vec<Number> {
        vec![self.numerator.clone(), self.denominator.clone()]
    }
}

impl<const D: usize> Predicate<D> for AnglesAgainst {
    fn constants(&self) -> Vec<Number> {
        self.bound.constants()
    }

    #[inline(always)]
    fn degree(&self, _: usize) -> i32 {
        4 * (D as i32 - 1)
    }

    #[inline(always)]
    fn values<S: Scalar>(
        &self,
        simplex: &Simplex<S, D>,
        _: &[S; D],
        metric: &Metric<S, D>,
        mut visit: impl FnMut(usize, &S),
    ) {
        let products = simplex.normal_products(&metric.cogram);
        let [n, d] = [&metric.constants[0], &metric.constants[1]];
        let zero = simplex.determinant.integer(0);
        products.for_pairs(|i, j, p| {
            let left = p.times(d).times(&p.magnitude());
            let right = products.get(i, i).times(n).times(products.get(j, j));
            visit(0, &zero.minus(&left).minus(&right));
        });
    }
}

/// b |e|² - R² for all edges e, up to a positive factor, with b = n/d: negative for none if
/// R² / |e|² is at most b for the shortest edge.
#[derive(Clone, Debug)]
pub struct RadiusAgainst {
    bound: Quotient,
}

impl RadiusAgainst {
    /// Against this squared ratio, which is positive.
    pub fn new(squared_ratio: &Number) -> Self {
        RadiusAgainst {
            bound: Quotient::of(squared_ratio),
        }
    }
}

impl<const D: usize> Predicate<D> for RadiusAgainst {
    fn constants(&self) -> Vec<Number> {
        self.bound.constants()
    }

    #[inline(always)]
    fn degree(&self, _: usize) -> i32 {
        2 * D as i32 + 2
    }

    fn values<S: Scalar>(
        &self,
        simplex: &Simplex<S, D>,
        _: &[S; D],
        metric: &Metric<S, D>,
        mut visit: impl FnMut(usize, &S),
    ) {
        let products = simplex.normal_products(&metric.cogram);
        let (numerator, denominator) = simplex.squared_circumradius(&metric.gram, &products);
        let left = numerator.times(&metric.constants[1]);
        let right = denominator.times(&metric.constants[0]);
        simplex.for_squared_edges(&metric.gram, |edge| {
            visit(0, &right.times(edge).minus(&left));
        });
    }
}

/// The power of the point corner_0 + x with respect to the circumsphere, times the
/// determinant.
#[derive(Clone, Copy, Debug)]
pub struct InSphere;

impl<const D: usize> Predicate<D> for InSphere {
    #[inline(always)]
    fn degree(&self, _: usize) -> i32 {
        D as i32 + 2
    }

    #[inline(always)]
    fn values<S: Scalar>(
        &self,
        simplex: &Simplex<S, D>,
        point: &[S; D],
        metric: &Metric<S, D>,
        mut visit: impl FnMut(usize, &S),
    ) {
        visit(0, &simplex.power(&metric.gram, point));
    }
}
