//! The rings in which the checks compute, and Z[a] with integers of one size.
//!
//! Every check of a simplex is written once, over a [`Ring`]. The rings are Z[a] for three sizes
//! of integers, the real intervals of [`crate::filter`], and polynomials in the parameters of a
//! family ([`crate::polynomial`]). A sign of an interval or of a polynomial can be undecided.

use crate::claim::Polynomial;
use crate::filter::Rough;
use crate::int::Int;
use crate::limits::Work;
use crate::refusal::{Checked, Stop, Value};
use crate::root::{ROUGH_BITS, Root, enclosure};
use num_bigint::BigInt;
use std::array::from_fn;
use std::cmp::Ordering::{self, Equal, Greater, Less};
use std::rc::Rc;

/// Three coordinates; in the plane the third one is zero.
pub type Vector<R> = [<R as Ring>::Element; 3];

/// The sign of a number lies between these two, inclusive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sign {
    pub(crate) least: Ordering,
    pub(crate) most: Ordering,
}

impl Sign {
    pub(crate) const UNDECIDED: Sign = Sign { least: Less, most: Greater };

    pub(crate) fn exactly(sign: Ordering) -> Sign {
        Sign { least: sign, most: sign }
    }

    /// Whether a condition holds; [`Stop::LARGER`] if that depends on which sign it is.
    pub(crate) fn is(self, condition: impl Fn(Ordering) -> bool) -> Checked<bool> {
        let answer = condition(self.least);
        let is_possible = |sign| self.least <= sign && sign <= self.most;
        let is_decided = |sign| !is_possible(sign) || condition(sign) == answer;
        if [Equal, Greater].into_iter().all(is_decided) { Ok(answer) } else { Err(Stop::LARGER) }
    }

    pub(crate) fn decided(self) -> Checked<Ordering> {
        if self.least == self.most { Ok(self.least) } else { Err(Stop::LARGER) }
    }
}

pub trait Ring: Clone {
    type Element: Clone + Default;

    /// The number with these coefficients of 1, a, a², …
    fn element(&self, coefficients: &[BigInt]) -> Checked<Self::Element>;
    /// The number, or the polynomial in a ring of these.
    fn polynomial(&self, terms: &Polynomial) -> Checked<Self::Element> {
        terms.first().map_or(Ok(Self::Element::default()), |(number, _)| self.element(number))
    }
    /// The coefficients, where the ring is exact; else nothing.
    fn coefficients(&self, x: &Self::Element) -> Vec<BigInt>;
    fn plus(&self, x: &Self::Element, y: &Self::Element) -> Checked<Self::Element>;
    fn minus(&self, x: &Self::Element, y: &Self::Element) -> Checked<Self::Element>;
    /// Σ x_i y_i, for at most four terms.
    fn dot<const K: usize>(&self, x: [&Self::Element; K], y: [&Self::Element; K]) -> Checked<Self::Element>;
    fn sign(&self, x: &Self::Element) -> Sign;
    /// The sign; and the size where that saves work, unless the number is zero.
    fn rough(&self, x: &Self::Element) -> (Sign, Option<Rough>) {
        (self.sign(x), None)
    }
    /// Whether an element may have several signs, at different points.
    fn varies(&self) -> bool {
        false
    }
    fn work(&self) -> &Work;
    /// Units of work for one product; zero where the ring counts them itself.
    fn price(&self) -> u64;

    fn integer(&self, value: i64) -> Checked<Self::Element> {
        self.element(&[value.into()])
    }

    fn long(&self, value: &BigInt) -> Checked<Self::Element> {
        self.element(std::slice::from_ref(value))
    }

    fn times(&self, x: &Self::Element, y: &Self::Element) -> Checked<Self::Element> {
        self.dot([x], [y])
    }

    fn inner(&self, x: &Vector<Self>, y: &Vector<Self>) -> Checked<Self::Element> {
        self.dot(x.each_ref(), y.each_ref())
    }

    /// x × y: the functional z -> det(x, y, z).
    fn cross(&self, x: &Vector<Self>, y: &Vector<Self>) -> Checked<Vector<Self>> {
        let ([x0, x1, x2], [y0, y1, y2]) = (x, y);
        let [m0, m1, m2] = [&self.negated(x0)?, &self.negated(x1)?, &self.negated(x2)?];
        Ok([self.dot([x1, m2], [y2, y1])?, self.dot([x2, m0], [y0, y2])?, self.dot([x0, m1], [y1, y0])?])
    }

    fn negated(&self, x: &Self::Element) -> Checked<Self::Element> {
        self.minus(&Self::Element::default(), x)
    }

    /// y - x
    fn difference(&self, x: &Vector<Self>, y: &Vector<Self>) -> Checked<Vector<Self>> {
        zip(y, x, |y, x| self.minus(y, x))
    }

    /// The sign of x - y.
    fn compare(&self, x: &Self::Element, y: &Self::Element) -> Checked<Sign> {
        Ok(self.sign(&self.minus(x, y)?))
    }

    /// x / y for a refusal.
    fn quotient(&self, x: &Self::Element, y: &Self::Element) -> Value {
        Value::Quotient(self.coefficients(x), self.coefficients(y))
    }

    fn value(&self, x: &Self::Element) -> Value {
        Value::Quotient(self.coefficients(x), vec![1.into()])
    }
}

/// f of the entries of two arrays.
pub(crate) fn zip<A, B, V: Default, const K: usize>(
    a: &[A; K],
    b: &[B; K],
    mut f: impl FnMut(&A, &B) -> Checked<V>,
) -> Checked<[V; K]> {
    let mut values = from_fn(|_| V::default());
    for ((value, a), b) in values.iter_mut().zip(a).zip(b) {
        *value = f(a, b)?;
    }
    Ok(values)
}

/// f of the entries of an array.
pub(crate) fn each<A, V: Default, const K: usize>(a: &[A; K], mut f: impl FnMut(&A) -> Checked<V>) -> Checked<[V; K]> {
    zip(a, &[(); K], |a, ()| f(a))
}

/// Coefficients of 1, a, …, a^(N-1); those from the degree on are zero.
#[derive(Clone, Debug, PartialEq)]
pub struct Element<T, const N: usize>(pub [T; N]);

impl<T: Default, const N: usize> Default for Element<T, N> {
    fn default() -> Self {
        Element(from_fn(|_| T::default()))
    }
}

/// Z[a] for a root a of a monic polynomial of degree at most N; Z for degree 1.
#[derive(Clone)]
pub struct Exact<T, const N: usize> {
    /// a^degree = Σ tail_k a^k
    tail: [T; N],
    rough: [(i64, u64); N],
    /// The sum of the widths of these, divided by 16.
    slack: i128,
    pub(crate) root: Rc<Root>,
    pub(crate) work: Rc<Work>,
}

impl<T: Int, const N: usize> Exact<T, N> {
    pub(crate) fn new(root: &Rc<Root>, work: &Rc<Work>) -> Checked<Self> {
        let mut rough = [(0, 0); N];
        rough.iter_mut().zip(&root.rough).for_each(|(slot, power)| *slot = *power);
        let slack = rough.iter().map(|(_, width)| i128::from(*width)).sum::<i128>() / 16;
        Ok(Exact { tail: coefficients(&root.tail)?, rough, slack, root: root.clone(), work: work.clone() })
    }

    /// The compiler knows the degrees 1 and 2.
    fn degree(&self) -> usize {
        if N <= 2 { N } else { self.root.tail.len().min(N) }
    }

    fn add_product(&self, sum: &mut T, x: &T, y: &T) -> Checked {
        if T::PRICE == 0 {
            // The products of words, and something for the memory.
            self.work.add(50 + (1 + x.length() / 64) * (1 + y.length() / 64));
        }
        sum.add_product(x, y)
    }

    fn times_a(&self, sum: &mut [T; N]) -> Checked {
        let sum = sum.get_mut(..self.degree()).ok_or_else(|| Stop::LARGER)?;
        sum.rotate_right(1);
        let last = std::mem::take(sum.first_mut().ok_or_else(|| Stop::LARGER)?);
        for (sum, tail) in sum.iter_mut().zip(&self.tail) {
            self.add_product(sum, &last, tail)?;
        }
        Ok(())
    }

    /// The sign by a rough enclosure of the number.
    #[inline(never)]
    fn close_sign(&self, x: &Element<T, N>) -> Sign {
        match enclosure(&x.0, &self.rough) {
            Ok((middle, radius, _)) if middle.unsigned_abs() > radius => Sign::exactly(middle.cmp(&0)),
            _ => self.fine_sign(x),
        }
    }

    /// The sign by the fine enclosures; only for the largest integers.
    #[cold]
    #[inline(never)]
    fn fine_sign(&self, x: &Element<T, N>) -> Sign {
        if T::PRICE != 0 {
            return Sign::UNDECIDED;
        }
        let (low, high) = self.enclose(x);
        Sign { least: low.cmp(&BigInt::ZERO), most: high.cmp(&BigInt::ZERO) }
    }

    /// 2^BITS x lies between these.
    pub(crate) fn enclose(&self, x: &Element<T, N>) -> (BigInt, BigInt) {
        let (mut low, mut high) = (BigInt::ZERO, BigInt::ZERO);
        for (c, (least, most)) in x.0.iter().zip(&self.root.fine) {
            let c = c.big();
            self.work.add(100 + (1 + c.length() / 64) * (1 + most.length() / 64));
            let (x, y) = (&c * least, &c * most);
            low += (&x).min(&y);
            high += (&x).max(&y);
        }
        (low, high)
    }
}

fn coefficients<T: Int, const N: usize>(coefficients: &[BigInt]) -> Checked<[T; N]> {
    let mut array = from_fn(|_| T::default());
    for (slot, c) in array.iter_mut().zip(coefficients) {
        *slot = T::of(c)?;
    }
    Ok(array)
}

impl<T: Int, const N: usize> Ring for Exact<T, N> {
    type Element = Element<T, N>;

    fn element(&self, number: &[BigInt]) -> Checked<Element<T, N>> {
        coefficients(number).map(Element)
    }

    fn coefficients(&self, x: &Element<T, N>) -> Vec<BigInt> {
        x.0.iter().take(self.degree()).map(T::big).collect()
    }

    fn plus(&self, x: &Element<T, N>, y: &Element<T, N>) -> Checked<Element<T, N>> {
        zip(&x.0, &y.0, T::plus).map(Element)
    }

    fn minus(&self, x: &Element<T, N>, y: &Element<T, N>) -> Checked<Element<T, N>> {
        zip(&x.0, &y.0, T::minus).map(Element)
    }

    fn dot<const K: usize>(&self, x: [&Element<T, N>; K], y: [&Element<T, N>; K]) -> Checked<Element<T, N>> {
        let degree = self.degree();
        let mut sum: [T; N] = from_fn(|_| T::default());
        // Horner's rule in a: the coefficients of x from the last one down.
        for j in (0..degree).rev() {
            if j + 1 < degree {
                self.times_a(&mut sum)?;
            }
            for (x, y) in x.iter().zip(y) {
                let x = x.0.get(j).ok_or_else(|| Stop::LARGER)?;
                if N > 1 && *x == T::default() {
                    continue;
                }
                for (sum, y) in sum.iter_mut().zip(&y.0).take(degree) {
                    self.add_product(sum, x, y)?;
                }
            }
        }
        Ok(Element(sum))
    }

    /// Zero if all coefficients are. Else an enclosure must show the sign.
    #[inline(always)]
    fn sign(&self, x: &Element<T, N>) -> Sign {
        if let [c] = &x.0[..] {
            return Sign::exactly(c.sign());
        }
        if x.0.iter().all(|c| *c == T::default()) {
            return Sign::exactly(Equal);
        }
        if T::PRICE == 1 && x.0.iter().all(|c| c.length() <= ROUGH_BITS) {
            // The sum lies less than 2^60 Σ width < 2^64 (slack + 1) from this one.
            let middle = |(c, (low, _)): (&T, &(i64, u64))| Ok(i128::from(c.top(0)?) * i128::from(*low));
            let sum = x.0.iter().zip(&self.rough).map(middle).sum::<Checked<i128>>();
            let top = sum.map_or(0, |sum| sum >> 64);
            if top > self.slack || top < -self.slack - 1 {
                return Sign::exactly(top.cmp(&0));
            }
        }
        self.close_sign(x)
    }

    #[inline(always)]
    fn rough(&self, x: &Element<T, N>) -> (Sign, Option<Rough>) {
        // Where products are those of two words, they cost less.
        let is_cheap = (N, T::PRICE) == (1, 1);
        if let (false, Ok((middle, radius, s))) = (is_cheap, enclosure(&x.0, &self.rough))
            && let Some(rough) = Rough::new(middle.unsigned_abs(), radius, s.cast_signed())
        {
            return (Sign::exactly(middle.cmp(&0)), Some(rough));
        }
        (self.sign(x), None)
    }

    fn work(&self) -> &Work {
        &self.work
    }

    fn price(&self) -> u64 {
        u64::try_from(self.degree() * self.degree()).unwrap_or(64) * T::PRICE
    }
}
