//! The sum of the determinants of all simplices, exactly: their volume.

use super::ladder::{Base, Ladder, determinant};
use super::model::{Model, Prepared};
use super::polynomials::Orientation;
use super::ring::Ring;
use super::vectors::Vectors;
use crate::tiling::SimplexId;
use acutile_exact::geometry::{I512, RingElement};
use acutile_exact::number::Number;
use malachite::{Integer, Rational};
use std::collections::BTreeMap;

impl<const D: usize> Model<'_, D> {
    /// The sum of det (e_1, …, e_D) over all simplices, in basis coordinates.
    pub fn sum_of_determinants(&self) -> Number {
        let orientation = self.prepare(Orientation);
        let totals = self.by_chunks(|simplices| {
            let mut total = Total::default();
            for simplex in simplices.map(SimplexId::at) {
                orientation.add_determinant(simplex, &mut total);
            }
            total
        });
        let total = totals.into_iter().fold(Total::default(), Total::plus);
        total.value(&self.ring, D)
    }
}

impl<const D: usize> Prepared<'_, Orientation, D> {
    #[inline]
    fn add_determinant(&self, simplex: SimplexId, total: &mut Total) {
        let Prepared { model, exact, .. } = self;
        let corners = model.tiling.simplex(simplex);
        let apex = &corners[0];
        if let Some(vectors) = model.ring.integers(corners, apex) {
            total.add(exact.integers.as_ref(), &vectors);
        } else if let Some(vectors) = model.ring.quadratics(corners, apex) {
            total.add(exact.quadratics.as_ref(), &vectors);
        } else {
            let Vectors { edges, .. } = model.ring.numbers(model.tiling, corners, apex);
            let determinant = determinant::<_, Number, D>(&edges);
            total.numbers = total.numbers.plus(&determinant);
        }
    }
}

/// A sum of determinants: x + y √d in units of 2^(D e) for exponents e, and numbers.
struct Total {
    /// The sum since the exponent changed last.
    current: (i32, [I512; 2]),
    sums: BTreeMap<i32, [Integer; 2]>,
    numbers: Number,
}

impl Default for Total {
    fn default() -> Self {
        Total {
            current: (0, [I512::ZERO; 2]),
            sums: BTreeMap::new(),
            numbers: Number::zero(),
        }
    }
}

impl Total {
    #[inline]
    fn add<B: Base, const D: usize>(
        &mut self,
        ladder: Option<&Ladder<B, D>>,
        Vectors {
            edges, exponent, ..
        }: &Vectors<B, D>,
    ) {
        match ladder.and_then(|ladder| ladder.determinant(edges)) {
            Some(terms) => self.add_wide(*exponent, terms),
            None => self.add_big(*exponent, B::big_coefficients(determinant(edges))),
        }
    }

    #[inline]
    fn add_wide(&mut self, exponent: i32, terms: [I512; 2]) {
        let (current, [x, y]) = &self.current;
        match [x.checked_sum(&terms[0]), y.checked_sum(&terms[1])] {
            [Some(x), Some(y)] if *current == exponent => self.current.1 = [x, y],
            _ => {
                self.flush();
                self.current = (exponent, terms);
            }
        }
    }

    fn add_big(&mut self, exponent: i32, [x, y]: [Integer; 2]) {
        let sum = self.sums.entry(exponent).or_default();
        sum[0] += x;
        sum[1] += y;
    }

    fn flush(&mut self) {
        let (exponent, sum) = self.current;
        self.current.1 = [I512::ZERO; 2];
        self.add_big(exponent, sum.map(|x| Integer::from(&x)));
    }

    fn plus(mut self, mut other: Total) -> Total {
        self.flush();
        other.flush();
        for (exponent, sum) in other.sums {
            self.add_big(exponent, sum);
        }
        self.numbers = self.numbers.plus(&other.numbers);
        self
    }

    /// The sum in basis coordinates.
    fn value<const D: usize>(mut self, ring: &Ring<D>, dimension: usize) -> Number {
        self.flush();
        let root = match ring {
            Ring::Quadratic { root, .. } => root.number.clone(),
            _ => Number::zero(),
        };
        let mut value = self.numbers;
        for (exponent, sum) in self.sums {
            let scale = exponent * dimension as i32;
            let [x, y] = sum.map(|n| Number::from(Rational::from(n) << scale));
            value = value + x + y * &root;
        }
        let unit = ring.unit();
        let cell = (1..dimension).fold(unit.clone(), |cell, _| cell * &unit);
        value.divide(&cell).expect("a denominator is positive")
    }
}
