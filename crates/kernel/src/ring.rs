//! The rings in which the checks compute, and Z[a] with integers of one size.
//!
//! Every check of a simplex is written once, over a [`Ring`]. The rings are Z[a] for three sizes
//! of integers, and the real intervals of [`crate::filter`]. A ring of polynomials in parameters
//! would be another one, with signs that hold for all parameters or are undecided.

use crate::filter::Intervals;
use crate::int::Int;
use crate::limits::Work;
use crate::refusal::Larger;
use crate::root::{Root, enclosure, sign_between};
use num_bigint::BigInt;
use std::array::from_fn;
use std::cmp::Ordering;
use std::rc::Rc;

/// Three coordinates; in the plane the third one is zero.
pub type Vector<R> = [<R as Ring>::Element; 3];

pub trait Ring {
    type Element: Clone + Default;
    /// A ring in which more results fit.
    type Next: Ring;

    /// The number with these coefficients of 1, a, a², …
    fn element(&self, coefficients: &[BigInt]) -> Result<Self::Element, Larger>;
    /// The coefficients, where the ring is exact; else nothing.
    fn coefficients(&self, x: &Self::Element) -> Vec<BigInt>;
    fn next(x: &Self::Element) -> <Self::Next as Ring>::Element;
    fn plus(&self, x: &Self::Element, y: &Self::Element) -> Result<Self::Element, Larger>;
    fn minus(&self, x: &Self::Element, y: &Self::Element) -> Result<Self::Element, Larger>;
    /// Σ x_i y_i, for at most three terms.
    fn dot<const K: usize>(
        &self,
        x: [&Self::Element; K],
        y: [&Self::Element; K],
    ) -> Result<Self::Element, Larger>;
    /// The sign; [`Larger`] where it is undecided.
    fn sign(&self, x: &Self::Element) -> Result<Ordering, Larger>;
    /// The lesser of two numbers.
    fn lesser(&self, x: &Self::Element, y: &Self::Element) -> Result<Self::Element, Larger>;
    /// Units of work for one product, where the ring does not count each one.
    fn price(&self) -> u64;

    #[inline(always)]
    fn times(&self, x: &Self::Element, y: &Self::Element) -> Result<Self::Element, Larger> {
        self.dot([x], [y])
    }

    #[inline(always)]
    fn inner(&self, x: &Vector<Self>, y: &Vector<Self>) -> Result<Self::Element, Larger>
    where
        Self: Sized,
    {
        self.dot(x.each_ref(), y.each_ref())
    }

    /// x × y: the functional z -> det(x, y, z).
    #[inline(always)]
    fn cross(&self, x: &Vector<Self>, y: &Vector<Self>) -> Result<Vector<Self>, Larger>
    where
        Self: Sized,
    {
        let ([x0, x1, x2], [y0, y1, y2]) = (x, y);
        Ok([
            self.minus(&self.times(x1, y2)?, &self.times(x2, y1)?)?,
            self.minus(&self.times(x2, y0)?, &self.times(x0, y2)?)?,
            self.minus(&self.times(x0, y1)?, &self.times(x1, y0)?)?,
        ])
    }

    /// y - x
    #[inline(always)]
    fn difference(&self, x: &Vector<Self>, y: &Vector<Self>) -> Result<Vector<Self>, Larger>
    where
        Self: Sized,
    {
        zip(y, x, |y, x| self.minus(y, x))
    }

    /// The sign of x - y.
    #[inline(always)]
    fn compare(&self, x: &Self::Element, y: &Self::Element) -> Result<Ordering, Larger> {
        self.sign(&self.minus(x, y)?)
    }
}

/// f of the entries of two arrays.
#[inline(always)]
pub(crate) fn zip<A, B, V: Default, E, const K: usize>(
    a: &[A; K],
    b: &[B; K],
    mut f: impl FnMut(&A, &B) -> Result<V, E>,
) -> Result<[V; K], E> {
    let mut values = from_fn(|_| V::default());
    for ((value, a), b) in values.iter_mut().zip(a).zip(b) {
        *value = f(a, b)?;
    }
    Ok(values)
}

/// f of the entries of an array.
#[inline(always)]
pub(crate) fn each<A, V: Default, E, const K: usize>(
    a: &[A; K],
    mut f: impl FnMut(&A) -> Result<V, E>,
) -> Result<[V; K], E> {
    zip(a, &[(); K], |a, ()| f(a))
}

/// Coefficients of 1, a, …, a^(N-1); those from the degree on are zero.
#[derive(Clone, Debug, PartialEq)]
pub struct Element<T, const N: usize>(pub [T; N]);

impl<T: Default, const N: usize> Default for Element<T, N> {
    #[inline(always)]
    fn default() -> Self {
        Element(from_fn(|_| T::default()))
    }
}

/// Z[a] for a root a of a monic polynomial of degree at most N; Z for degree 1.
#[derive(Clone)]
pub struct Exact<T, const N: usize> {
    degree: usize,
    /// a^degree = Σ tail_k a^k
    tail: [T; N],
    rough: [(i64, i64); N],
    root: Rc<Root>,
    work: Rc<Work>,
}

impl<T: Int, const N: usize> Exact<T, N> {
    pub(crate) fn new(root: &Rc<Root>, work: &Rc<Work>) -> Result<Self, Larger> {
        let mut rough = [(0, 0); N];
        for (slot, power) in rough.iter_mut().zip(&root.rough) {
            *slot = *power;
        }
        Ok(Exact {
            degree: root.tail.len(),
            tail: element(&root.tail)?.0,
            rough,
            root: root.clone(),
            work: work.clone(),
        })
    }

    /// The compiler knows it for small N.
    #[inline(always)]
    pub(crate) fn degree(&self) -> usize {
        if N <= 2 { N } else { self.degree.min(N) }
    }

    #[inline(always)]
    fn times_a(&self, sum: &mut [T; N]) -> Result<(), Larger> {
        let sum = sum.get_mut(..self.degree()).ok_or(Larger)?;
        sum.rotate_right(1);
        let last = std::mem::take(sum.first_mut().ok_or(Larger)?);
        for (sum, tail) in sum.iter_mut().zip(&self.tail) {
            self.count(&last, tail);
            sum.add_product(&last, tail)?;
        }
        Ok(())
    }

    pub(crate) fn work(&self) -> &Work {
        &self.work
    }

    #[inline(always)]
    fn count(&self, x: &T, y: &T) {
        if T::PRICE == 0 {
            self.work.add(T::price(x, y));
        }
    }

    /// The sign by the fine enclosures; only for the largest integers.
    #[cold]
    #[inline(never)]
    fn fine_sign(&self, x: &Element<T, N>) -> Result<Ordering, Larger> {
        if T::PRICE != 0 {
            return Err(Larger);
        }
        let (mut low, mut high) = (BigInt::ZERO, BigInt::ZERO);
        for (c, (least, most)) in x.0.iter().zip(&self.root.fine) {
            let c = c.big();
            self.work.add(2 * BigInt::price(&c, most));
            let (x, y) = (&c * least, &c * most);
            let (x, y) = if x < y { (x, y) } else { (y, x) };
            low += x;
            high += y;
        }
        sign_between(Int::sign(&low), Int::sign(&high))
    }
}

/// The rings of one field.
pub struct Rings<const N: usize> {
    pub(crate) small: Option<Exact<i64, N>>,
    pub(crate) medium: Option<Exact<i128, N>>,
    pub(crate) large: Exact<BigInt, N>,
    pub(crate) intervals: Intervals,
}

impl<const N: usize> Rings<N> {
    pub(crate) fn new(root: &Rc<Root>, work: &Rc<Work>) -> Result<Rings<N>, Larger> {
        Ok(Rings {
            small: Exact::new(root, work).ok(),
            medium: Exact::new(root, work).ok(),
            large: Exact::new(root, work)?,
            intervals: Intervals::new(root),
        })
    }
}

fn element<T: Int, const N: usize>(coefficients: &[BigInt]) -> Result<Element<T, N>, Larger> {
    let mut element = Element::default();
    for (slot, c) in element.0.iter_mut().zip(coefficients) {
        *slot = T::of(c)?;
    }
    Ok(element)
}

impl<T: Int, const N: usize> Ring for Exact<T, N> {
    type Element = Element<T, N>;
    type Next = Exact<T::Next, N>;

    fn element(&self, coefficients: &[BigInt]) -> Result<Element<T, N>, Larger> {
        element(coefficients)
    }

    fn coefficients(&self, x: &Element<T, N>) -> Vec<BigInt> {
        x.0.iter().take(self.degree()).map(T::big).collect()
    }

    #[inline(always)]
    fn next(x: &Element<T, N>) -> Element<T::Next, N> {
        Element(x.0.each_ref().map(T::next))
    }

    #[inline(always)]
    fn plus(&self, x: &Element<T, N>, y: &Element<T, N>) -> Result<Element<T, N>, Larger> {
        zip(&x.0, &y.0, T::plus).map(Element)
    }

    #[inline(always)]
    fn minus(&self, x: &Element<T, N>, y: &Element<T, N>) -> Result<Element<T, N>, Larger> {
        zip(&x.0, &y.0, T::minus).map(Element)
    }

    #[inline(always)]
    fn dot<const K: usize>(
        &self,
        x: [&Element<T, N>; K],
        y: [&Element<T, N>; K],
    ) -> Result<Element<T, N>, Larger> {
        let degree = self.degree();
        let mut sum: [T; N] = from_fn(|_| T::default());
        // Horner's rule in a: the coefficients of x from the last one down.
        for j in (0..degree).rev() {
            if j + 1 < degree {
                self.times_a(&mut sum)?;
            }
            for (x, y) in x.iter().zip(y) {
                let x = x.0.get(j).ok_or(Larger)?;
                if N > 2 && *x == T::default() {
                    continue;
                }
                for (sum, y) in sum.iter_mut().zip(&y.0).take(degree) {
                    self.count(x, y);
                    sum.add_product(x, y)?;
                }
            }
        }
        Ok(Element(sum))
    }

    /// Zero if all coefficients are. Else an enclosure must show the sign.
    #[inline(always)]
    fn sign(&self, x: &Element<T, N>) -> Result<Ordering, Larger> {
        if let [c] = &x.0[..] {
            return Ok(c.sign());
        }
        if x.0.iter().all(|c| *c == T::default()) {
            return Ok(Ordering::Equal);
        }
        let (low, high, _) = enclosure(&x.0, &self.rough)?;
        sign_between(low.cmp(&0), high.cmp(&0)).or_else(|Larger| self.fine_sign(x))
    }

    #[inline(always)]
    fn lesser(&self, x: &Element<T, N>, y: &Element<T, N>) -> Result<Element<T, N>, Larger> {
        let first = self.compare(x, y)? != Ordering::Greater;
        Ok(if first { x.clone() } else { y.clone() })
    }

    fn price(&self) -> u64 {
        u64::try_from(self.degree * self.degree).unwrap_or(u64::MAX) * T::PRICE
    }
}
