//! The coordinates of a tiling with their denominators cleared: in a ring, so that
//! every predicate is a polynomial and nothing is divided.
//!
//! Coordinates are multiplied by one positive number, the Gram matrix by another, so
//! no sign changes. The ring is Z for rational data, Z[√d] for data in a quadratic
//! field, both where coefficients have less than 2^62 or so; else the field itself.
//! Doubles keep their own exponents and are cleared simplex by simplex.

use super::binary::{common_exponent, dyadic};
use super::vectors::{Vectors, vectors};
use crate::tiling::coordinates::Form;
use crate::tiling::{Corner, Tiling, VertexId};
use acutile_exact::geometry::Quadratic;
use acutile_exact::number::{Field, Number};
use malachite::base::num::arithmetic::traits::{CheckedSqrt, DivExact, Gcd};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::{Integer, Natural, Rational};

/// The vertices of a tiling in the ring; `unit` is one lattice step.
#[derive(Clone, Debug)]
pub enum Ring<'a, const D: usize> {
    /// Z, coordinates less than 2^62.
    Integers {
        /// D coordinates for each vertex.
        vertices: &'a [[i64; D]],
        /// The length of a lattice step.
        unit: i64,
    },
    /// Z, coordinates and unit less than 2^95.
    Long {
        /// D coordinates for each vertex.
        vertices: Vec<[i128; D]>,
        /// The length of a lattice step.
        unit: i128,
    },
    /// Z, times a power of two for all simplices or one for each.
    Doubles {
        /// D coordinates for each vertex.
        points: &'a [[f64; D]],
        /// The power of two for all simplices; `None` for one in each simplex.
        exponent: Option<i32>,
    },
    /// Z[√d]: x + y √d for each coordinate [x, y], less than 2^62.
    Quadratic {
        /// D coordinates [x, y] for each vertex.
        vertices: Vec<[[i64; 2]; D]>,
        /// The length of a lattice step.
        unit: i64,
        /// The square root of d.
        root: SquareRoot,
    },
    /// The field.
    Numbers {
        /// D coordinates for each vertex.
        vertices: Vec<[Number; D]>,
        /// The length of a lattice step.
        unit: Number,
    },
}

/// √d in a quadratic field: with a the generator, a² = q a + p and d = q² + 4 p,
/// it is ±(2 a - q).
#[derive(Clone, Debug)]
pub struct SquareRoot {
    /// Positive, no square.
    pub d: i64,
    q: i64,
    /// Whether 2 a - q is √d itself and not -√d.
    is_positive: bool,
    /// √d
    pub number: Number,
}

impl SquareRoot {
    /// `None` if the field is not quadratic or its polynomial is reducible or large.
    fn of(field: &Field) -> Option<Self> {
        let [p, q, _] = field.polynomial() else {
            return None;
        };
        let [p, q] = [-p, -q];
        let discriminant = &q * &q + Integer::from(4) * p;
        let d = i64::try_from(&discriminant).ok().filter(|d| *d > 0)?;
        if Natural::from(d.unsigned_abs()).checked_sqrt().is_some() {
            return None;
        }
        let two_a = field.generator() * field.integer(2);
        let difference = two_a - field.rational(Rational::from(&q));
        let is_positive = difference.sign().is_gt();
        Some(SquareRoot {
            d,
            q: i64::try_from(&q).ok()?,
            is_positive,
            number: difference.abs(),
        })
    }

    /// 2 n x as X + Y √d, for a number n such that X and Y are integers.
    fn doubled(&self, number: &Number, n: &Integer) -> Option<[Integer; 2]> {
        let coefficients = number.coefficients();
        let zero = Rational::ZERO;
        let scaled = |k: usize| {
            let c = coefficients.get(k).unwrap_or(&zero);
            Integer::try_from(c * Rational::from(n)).ok()
        };
        // c_0 + c_1 a = (2 c_0 + q c_1)/2 ± c_1 √d / 2
        let [c0, c1] = [scaled(0)?, scaled(1)?];
        let x = Integer::from(2) * c0 + Integer::from(self.q) * &c1;
        Some([x, if self.is_positive { c1 } else { -c1 }])
    }
}

impl SquareRoot {
    /// 2 n x as an element of Z[√d], for a number n such that its coefficients are integers.
    pub fn element(&self, number: &Number, n: &Integer) -> Option<Quadratic<Integer>> {
        let [x, y] = self.doubled(number, n)?;
        Some(Quadratic {
            x,
            y,
            d: Integer::from(self.d),
        })
    }
}

impl<'a, const D: usize> Ring<'a, D> {
    /// The narrowest ring for the coordinates and the metric of `tiling`.
    pub fn new(tiling: &'a Tiling<D>) -> Self {
        let is_metric_rational = tiling.frame.gram.iter().flatten().all(Number::is_rational);
        if is_metric_rational {
            match tiling.vertices.form() {
                Form::Integers {
                    numerators,
                    denominator,
                } => {
                    return Ring::Integers {
                        vertices: numerators,
                        unit: *denominator,
                    };
                }
                Form::Doubles(points) => {
                    let has_shift = tiling.corners.iter().any(|corner| corner.shift != [0; D]);
                    return Ring::Doubles {
                        points,
                        exponent: common_exponent(points.iter().flatten(), has_shift),
                    };
                }
                Form::Numbers(_) => {}
            }
        }
        let vertices = tiling.vertices.to_numbers();
        let unit = Number::common_denominator(vertices.iter().flatten());
        let narrow = if is_metric_rational {
            long(&vertices, &unit)
        } else {
            None
        };
        narrow
            .or_else(|| quadratic(&vertices, &unit, SquareRoot::of(&tiling.frame.field)?))
            .unwrap_or_else(|| numbers(vertices, &unit))
    }

    /// The vectors of a simplex over Z; `None` in the other rings, and for doubles
    /// too far apart in size.
    #[inline]
    pub fn integers(&self, corners: &[Corner<D>], apex: &Corner<D>) -> Option<Vectors<i128, D>> {
        match self {
            Ring::Integers { vertices, unit } => {
                let at = |vertex: usize, k: usize| i128::from(vertices[vertex][k]);
                Some(vectors(corners, apex, at, i128::from(*unit)))
            }
            Ring::Long { vertices, unit } => Some(vectors(
                corners,
                apex,
                |vertex, k| vertices[vertex][k],
                *unit,
            )),
            Ring::Doubles { points, exponent } => dyadic(points, *exponent, corners, apex),
            _ => None,
        }
    }

    /// The vectors of a simplex over Z[√d]; `None` in the other rings.
    pub fn quadratics(
        &self,
        corners: &[Corner<D>],
        apex: &Corner<D>,
    ) -> Option<Vectors<Quadratic<i128>, D>> {
        let Ring::Quadratic {
            vertices,
            unit,
            root,
        } = self
        else {
            return None;
        };
        let element = |[x, y]: [i64; 2]| Quadratic {
            x: i128::from(x),
            y: i128::from(y),
            d: i128::from(root.d),
        };
        let at = |vertex: usize, k: usize| element(vertices[vertex][k]);
        Some(vectors(corners, apex, at, element([*unit, 0])))
    }

    /// The vectors of a simplex in the field.
    pub fn numbers(
        &self,
        tiling: &Tiling<D>,
        corners: &[Corner<D>],
        apex: &Corner<D>,
    ) -> Vectors<Number, D> {
        match self {
            Ring::Numbers { vertices, unit } => {
                let at = |vertex: usize, k: usize| vertices[vertex][k].clone();
                vectors(corners, apex, at, unit.clone())
            }
            _ => {
                let at = |vertex: usize, k: usize| {
                    tiling.vertices.vertex(VertexId::at(vertex))[k].clone()
                };
                vectors(corners, apex, at, Number::from(Rational::ONE))
            }
        }
    }

    /// One lattice step as a number.
    pub fn unit(&self) -> Number {
        match self {
            Ring::Integers { unit, .. } | Ring::Quadratic { unit, .. } => {
                Number::from(Rational::from(*unit))
            }
            Ring::Long { unit, .. } => Number::from(Rational::from(*unit)),
            Ring::Doubles { .. } => Number::from(Rational::ONE),
            Ring::Numbers { unit, .. } => unit.clone(),
        }
    }
}

fn long<'a, const D: usize>(vertices: &[[Number; D]], unit: &Integer) -> Option<Ring<'a, D>> {
    let is_small = |n: &i128| n.unsigned_abs() >> 95 == 0;
    let clear = |x: &Number| {
        let value = x.to_rational()? * Rational::from(unit);
        let integer = Integer::try_from(value).ok()?;
        i128::try_from(&integer).ok().filter(is_small)
    };
    Some(Ring::Long {
        vertices: collected(vertices, clear)?,
        unit: i128::try_from(unit).ok().filter(is_small)?,
    })
}

fn quadratic<'a, const D: usize>(
    vertices: &[[Number; D]],
    unit: &Integer,
    root: SquareRoot,
) -> Option<Ring<'a, D>> {
    let small = |n: &Integer| {
        i64::try_from(n)
            .ok()
            .filter(|n| n.unsigned_abs() >> 62 == 0)
    };
    let clear = |x: &Number| {
        let [x, y] = root.doubled(x, unit)?;
        Some([small(&x)?, small(&y)?])
    };
    let vertices = collected(vertices, clear)?;
    Some(Ring::Quadratic {
        vertices,
        unit: small(&(Integer::from(2) * unit))?,
        root,
    })
}

fn numbers<'a, const D: usize>(vertices: Vec<[Number; D]>, unit: &Integer) -> Ring<'a, D> {
    let unit = Number::from(Rational::from(unit));
    let cleared = vertices.iter().map(|x| x.each_ref().map(|x| x * &unit));
    Ring::Numbers {
        vertices: cleared.collect(),
        unit,
    }
}

fn collected<T: Copy + Default, const D: usize>(
    vertices: &[[Number; D]],
    clear: impl Fn(&Number) -> Option<T>,
) -> Option<Vec<[T; D]>> {
    let row = |vertex: &[Number; D]| {
        let mut row = [T::default(); D];
        for (entry, x) in row.iter_mut().zip(vertex) {
            *entry = clear(x)?;
        }
        Some(row)
    };
    vertices.iter().map(row).collect()
}

/// A matrix times the positive number that makes its entries integers without a common
/// divisor; `None` if it is not rational.
pub fn cleared_integers<const D: usize>(matrix: &[[Number; D]; D]) -> Option<[[Integer; D]; D]> {
    let unit = Rational::from(Number::common_denominator(matrix.iter().flatten()));
    let clear = |x: &Number| Integer::try_from(x.to_rational()? * &unit).ok();
    let integers = square(matrix, clear)?;
    let divisor = integers.iter().flatten().fold(Natural::ZERO, |divisor, x| {
        divisor.gcd(x.unsigned_abs_ref())
    });
    let divisor = Integer::from(divisor.max(Natural::ONE));
    Some(integers.map(|row| row.map(|x| x.div_exact(&divisor))))
}

/// A matrix times one positive integer, over Z[√d].
pub fn cleared_quadratics<const D: usize>(
    matrix: &[[Number; D]; D],
    root: &SquareRoot,
) -> Option<[[Quadratic<Integer>; D]; D]> {
    let unit = Number::common_denominator(matrix.iter().flatten());
    square(matrix, |number| root.element(number, &unit))
}

fn square<T, const D: usize>(
    matrix: &[[Number; D]; D],
    clear: impl Fn(&Number) -> Option<T>,
) -> Option<[[T; D]; D]> {
    let rows = matrix.iter().map(|row| {
        let row = row.iter().map(&clear).collect::<Option<Vec<T>>>()?;
        <[T; D]>::try_from(row).ok()
    });
    <[[T; D]; D]>::try_from(rows.collect::<Option<Vec<_>>>()?).ok()
}
