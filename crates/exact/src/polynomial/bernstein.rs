//! Signs of a polynomial that hold on a whole box.
//!
//! Substitute the box by [0, 1]^m. The tensor Bernstein basis is B_i(u) = Π_k C(n_k, i_k) u_k^i_k (1 -
//! u_k)^(n_k - i_k), where n_k is the degree in the k-th parameter. Every basis function is at least zero
//! on the cube and positive inside. So coefficients that are at least zero prove that the polynomial is. On
//! a face of the cube, only the coefficients with i_k = 0 or i_k = n_k on the fixed axes matter. The
//! polynomial is positive inside of that face if one of them is positive.
//!
//! The coefficients here are those of the basis without the binomial factors, times a positive
//! number: they have the same signs. They are found axis by axis from
//! t = ((1 - u) l + u h) / d: a term a t^k becomes a ((1-u) l + u h)^k ((1-u) d + u d)^(n-k) / d^n.

use super::cuboid::Cuboid;
use super::{Coefficient, Polynomial};
use crate::geometry::Sign;
use crate::number::Number;

/// A polynomial with more coefficients than this is not decided.
pub const COEFFICIENT_LIMIT: usize = 1 << 20;

/// Whether the Bernstein coefficients prove that the polynomial is positive on the box. `None` if
/// there are too many, or if the box has other numbers than the polynomial.
pub fn is_positive<C: Coefficient>(p: &Polynomial<C>, cuboid: &Cuboid) -> Option<bool> {
    let table = Table::of(p, cuboid)?;
    Some(table.none_negative() && table.positive_on_faces(cuboid))
}

/// Whether they prove that it is at least zero on the box.
pub fn is_nonnegative<C: Coefficient>(p: &Polynomial<C>, cuboid: &Cuboid) -> Option<bool> {
    Some(Table::of(p, cuboid)?.none_negative())
}

/// A lower and an upper bound of p/q on the box, where q is at least zero. `None` for a bound that the
/// coefficients do not give, or do not decide.
///
/// If p - M q has no positive coefficient, then p/q is at most M wherever q is positive. The least such M is
/// the largest quotient of coefficients. A coefficient 0 of q asks for one of p that is not positive. So a
/// factor that p and q have in common and that is zero on a side of the box does no harm.
pub fn quotient_bounds(
    p: &Polynomial<Number>,
    q: &Polynomial<Number>,
    cuboid: &Cuboid,
) -> [Option<Number>; 2] {
    let degrees = (0..cuboid.sides.len()).map(|k| p.degree(k).max(q.degree(k)));
    let degrees: Vec<usize> = degrees.collect();
    let table = |polynomial| Table::of_degrees(polynomial, cuboid, degrees.clone());
    let (Some(p), Some(q)) = (table(p), table(q)) else {
        return [None, None];
    };
    let mut bounds: [Option<Number>; 2] = [None, None];
    let mut is_bounded = [true, true];
    for (b, c) in p.entries.iter().zip(&q.entries) {
        match (c.sign(), b.sign()) {
            (Sign::Less, _) => return [None, None],
            (Sign::Equal, Sign::Less) => is_bounded[0] = false,
            (Sign::Equal, Sign::Greater) => is_bounded[1] = false,
            (Sign::Equal, Sign::Equal) => {}
            (Sign::Greater, _) => {
                let Some(quotient) = b.divide(c) else {
                    return [None, None];
                };
                let [low, high] = &mut bounds;
                widen(low, &quotient, |old| quotient < *old);
                widen(high, &quotient, |old| quotient > *old);
            }
        }
    }
    let mut kept = is_bounded.into_iter();
    bounds.map(|bound| bound.filter(|_| kept.next() == Some(true)))
}

fn widen(bound: &mut Option<Number>, value: &Number, is_beyond: impl Fn(&Number) -> bool) {
    if bound.as_ref().is_none_or(is_beyond) {
        *bound = Some(value.clone());
    }
}

/// The signs at the corners of the box that belong to it, in the order of [`Cuboid::corners`]. A corner's
/// value is a positive number times its coefficient.
pub fn corner_signs<C: Coefficient>(p: &Polynomial<C>, cuboid: &Cuboid) -> Option<Vec<Sign>> {
    let table = Table::of(p, cuboid)?;
    let mut places = vec![0];
    for (axis, side) in cuboid.sides.iter().enumerate() {
        let last = table.stride(axis) * table.degrees[axis];
        let ends = [(side.low.is_open, 0), (side.high.is_open, last)];
        let closed = ends.iter().filter(|(is_open, _)| !is_open);
        let closed: Vec<usize> = closed.map(|(_, offset)| *offset).collect();
        let moved = |place: usize| closed.iter().map(move |offset| place + offset);
        places = places.into_iter().flat_map(moved).collect();
    }
    let signs = places.into_iter().map(|place| table.entries[place].sign());
    Some(signs.collect())
}

/// The steps that [`is_positive`] and [`is_nonnegative`] take for a polynomial: about one product of coefficients
/// each.
pub fn steps<C: Coefficient>(p: &Polynomial<C>, axes: usize) -> u64 {
    let lengths = (0..axes).map(|k| p.degree(k) as u64 + 1);
    let size = lengths.clone().fold(1u64, |size, n| size.saturating_mul(n));
    size.saturating_mul(1 + lengths.filter(|n| *n > 1).sum::<u64>())
}

/// The coefficients in the order of their indices, the last axis fastest, all times one positive
/// number and without the binomial factors.
pub fn coefficients<C: Coefficient>(p: &Polynomial<C>, cuboid: &Cuboid) -> Option<Vec<C>> {
    Some(Table::of(p, cuboid)?.entries)
}

/// Coefficients by their indices on all axes, the last axis fastest.
struct Table<C> {
    /// The degree on each axis.
    degrees: Vec<usize>,
    entries: Vec<C>,
}

impl<C: Coefficient> Table<C> {
    fn of(p: &Polynomial<C>, cuboid: &Cuboid) -> Option<Self> {
        let degrees = (0..cuboid.sides.len()).map(|k| p.degree(k)).collect();
        Table::of_degrees(p, cuboid, degrees)
    }

    /// With these degrees or higher ones than those of p.
    fn of_degrees(p: &Polynomial<C>, cuboid: &Cuboid, degrees: Vec<usize>) -> Option<Self> {
        let mut table = Table::dense(p, degrees)?;
        for (axis, side) in cuboid.sides.iter().enumerate() {
            if table.degrees[axis] > 0 {
                table.substitute(axis, &C::ends(side)?);
            }
        }
        Some(table)
    }

    /// The coefficients of the monomials.
    fn dense(p: &Polynomial<C>, degrees: Vec<usize>) -> Option<Self> {
        let size = degrees
            .iter()
            .try_fold(1usize, |size, n| size.checked_mul(n + 1));
        let size = size.filter(|size| *size <= COEFFICIENT_LIMIT)?;
        let mut entries = vec![C::from_integer(0); size];
        for (monomial, c) in p.terms() {
            let indices = degrees.iter().enumerate();
            let index = indices.fold(0, |index, (k, n)| index * (n + 1) + monomial.exponent(k));
            entries[index] = c.clone();
        }
        Some(Table { degrees, entries })
    }

    /// The distance of neighbours on an axis.
    fn stride(&self, axis: usize) -> usize {
        self.degrees[axis + 1..].iter().map(|n| n + 1).product()
    }

    /// Replaces monomials on an axis by the Bernstein basis.
    fn substitute(&mut self, axis: usize, ends: &[C; 3]) {
        let (stride, length) = (self.stride(axis), self.degrees[axis] + 1);
        for block in self.entries.chunks_exact_mut(stride * length) {
            for offset in 0..stride {
                let places = (0..length).map(|k| offset + k * stride);
                let row: Vec<C> = places.clone().map(|place| block[place].clone()).collect();
                if row.iter().any(|c| c.sign().is_ne()) {
                    let changed = substituted(&row, ends);
                    places.zip(changed).for_each(|(place, c)| block[place] = c);
                }
            }
        }
    }

    fn none_negative(&self) -> bool {
        self.entries.iter().all(|c| c.sign() != Sign::Less)
    }

    /// Whether some coefficient is positive on each of the smallest faces that the box contains.
    fn positive_on_faces(&self, cuboid: &Cuboid) -> bool {
        let choices = self.degrees.iter().zip(&cuboid.sides).map(|(n, side)| {
            let ends = [(side.low.is_open, 0), (side.high.is_open, *n)];
            let closed = ends.iter().filter(|(is_open, _)| !is_open);
            let mut fixed: Vec<Option<usize>> = closed.map(|(_, index)| Some(*index)).collect();
            fixed.dedup();
            match *n {
                0 => vec![None],
                _ if fixed.is_empty() => vec![None],
                _ => fixed,
            }
        });
        let choices: Vec<Vec<Option<usize>>> = choices.collect();
        let mut is_positive = vec![false; choices.iter().map(Vec::len).product()];
        let positive = self.entries.iter().enumerate();
        for (place, _) in positive.filter(|(_, c)| c.sign() == Sign::Greater) {
            if let Some(face) = self.face(place, &choices) {
                is_positive[face] = true;
            }
        }
        is_positive.into_iter().all(|is_positive| is_positive)
    }

    /// The number of the only face with this coefficient, if faces are given by one choice on each axis: an index, or
    /// all of them.
    fn face(&self, mut place: usize, choices: &[Vec<Option<usize>>]) -> Option<usize> {
        let (mut face, mut step) = (0, 1);
        for (n, choice) in self.degrees.iter().zip(choices).rev() {
            let index = place % (n + 1);
            place /= n + 1;
            let is_on = |fixed: &Option<usize>| fixed.is_none_or(|fixed| fixed == index);
            face += step * choice.iter().position(is_on)?;
            step *= choice.len();
        }
        Some(face)
    }
}

/// The coefficients of u^i (1 - u)^(n - i), by Horner's rule: after k steps the row stands for a
/// form of degree k in u and 1 - u.
fn substituted<C: Coefficient>(row: &[C], [low, high, unit]: &[C; 3]) -> Vec<C> {
    let mut form: Vec<C> = Vec::with_capacity(row.len());
    // ((1-u) d + u d)^k
    let mut power = vec![low.integer(1)];
    for c in row.iter().rev() {
        form = times_linear(&form, low, high);
        if form.is_empty() {
            form.push(c.clone());
        } else {
            power = times_linear(&power, unit, unit);
            for (sum, p) in form.iter_mut().zip(&power) {
                *sum = sum.plus(&c.times(p));
            }
        }
    }
    form
}

/// A form times (1 - u) l + u h.
fn times_linear<C: Coefficient>(form: &[C], low: &C, high: &C) -> Vec<C> {
    let Some(last) = form.last() else {
        return Vec::new();
    };
    let mut product = Vec::with_capacity(form.len() + 1);
    product.push(form[0].times(low));
    for pair in form.windows(2) {
        product.push(pair[0].times(high).plus(&pair[1].times(low)));
    }
    product.push(last.times(high));
    product
}
