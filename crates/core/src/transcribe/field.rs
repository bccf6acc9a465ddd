//! The field of a certificate: the smallest one that contains its numbers.

use crate::format::{self, Cosine, Fraction};
use crate::quality::{DihedralAngle, RadiusEdge};
use crate::statement::Statement;
use crate::tiling::coordinates::Form;
use crate::tiling::{Frame, Tiling};
use acutile_exact::geometry::Sign;
use acutile_exact::number::{Field, Number, Subfield, common_denominator};
use malachite::base::num::arithmetic::traits::{DivExact, Gcd};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::{Integer, Natural, Rational};

/// The Gram matrix and the field in which a tiling is written.
#[derive(Clone, Debug)]
pub struct Written<const D: usize> {
    /// The field of the certificate.
    pub numerals: Numerals,
    gram: [[Number; D]; D],
}

/// Numbers of a field by their coefficients in a smaller one.
#[derive(Clone, Debug)]
pub struct Numerals {
    subfield: Subfield,
}

impl<const D: usize> Written<D> {
    /// For a tiling. A common factor of the Gram matrix is divided out if the field is smaller
    /// without it.
    pub fn of(tiling: &Tiling<D>) -> Self {
        let Frame { field, gram, .. } = &tiling.frame;
        // A matrix that begins with zero is no metric, and stays as it is.
        let ratios = match gram[0][0].inverse() {
            Some(scale) => gram
                .each_ref()
                .map(|row| row.each_ref().map(|x| x * &scale)),
            None => gram.clone(),
        };
        let vertices: &[[Number; D]] = match tiling.vertices.form() {
            Form::Numbers(points) => points,
            _ => &[],
        };
        let polytope = tiling.frame.domain.polytope();
        let corners = polytope.iter().flat_map(|p| p.vertices.iter().flatten());
        let numbers = ratios.iter().flatten().chain(corners);
        let subfield = Subfield::of(field, numbers.chain(vertices.iter().flatten()));
        let entries = gram.iter().flatten();
        let gram = if entries.clone().all(|x| subfield.contains(x)) {
            gram.clone()
        } else {
            ratios
        };
        let numerals = Numerals { subfield };
        Written { numerals, gram }
    }

    /// The upper triangle of the primitive Gram matrix.
    pub fn gram(&self) -> Vec<Vec<format::Number>> {
        let unit = self.numerals.denominator(self.gram.iter().flatten());
        let entry = |x: &Number| self.numerals.numerator(x, &unit);
        let rows = self.gram.iter().enumerate();
        let rows = rows.map(|(k, row)| row[k..].iter().map(entry).collect());
        let mut rows: Vec<Vec<format::Number>> = rows.collect();
        make_primitive(rows.iter_mut().flatten());
        rows
    }
}

impl Numerals {
    /// In the smallest field that contains these numbers of `field`.
    pub fn of<'n>(field: &Field, numbers: impl IntoIterator<Item = &'n Number>) -> Self {
        Numerals {
            subfield: Subfield::of(field, numbers),
        }
    }

    /// The field of the certificate.
    pub fn field(&self) -> format::Field {
        let field = &self.subfield.field;
        if field.is_rationals() {
            return format::Field::Rationals;
        }
        let (low, high) = field.root();
        let denominator = Integer::from(common_denominator([&low, &high].into_iter()));
        let scaled = |x: Rational| integer(&(x * Rational::from(&denominator)));
        format::Field::Algebraic(format::AlgebraicField {
            polynomial: field.polynomial().to_vec(),
            low: scaled(low),
            high: scaled(high),
            denominator,
        })
    }

    /// The degree of the field.
    pub fn degree(&self) -> usize {
        self.subfield.field.degree()
    }

    /// The coefficients of a number of the tiling in the certificate's field. It is in this field. `of`
    /// generates the field by the ratios of the Gram matrix and all coordinates. The squares in statements
    /// are rational functions of these, or rational.
    fn coefficients(&self, number: &Number) -> Vec<Rational> {
        let coefficients = self.subfield.coefficients(number);
        coefficients.expect("the numbers of a tiling are in the field that they generate")
    }

    /// The least positive integer that clears these numbers.
    pub fn denominator<'n>(&self, numbers: impl Iterator<Item = &'n Number>) -> Integer {
        if self.is_same() {
            return Number::common_denominator(numbers);
        }
        let coefficients: Vec<Rational> = numbers.flat_map(|x| self.coefficients(x)).collect();
        Integer::from(common_denominator(coefficients.iter()))
    }

    /// Whether numbers keep their coefficients.
    fn is_same(&self) -> bool {
        self.subfield.is_whole()
    }

    /// A number times an integer that clears it.
    pub fn numerator(&self, number: &Number, unit: &Integer) -> format::Number {
        let unit = Rational::from(unit);
        let coefficients = self.coefficients(number).into_iter();
        format::Number(coefficients.map(|c| integer(&(c * &unit))).collect())
    }

    /// A number in lowest terms.
    pub fn fraction(&self, number: &Number) -> Fraction {
        let denominator = self.denominator([number].into_iter());
        Fraction {
            numerator: self.numerator(number, &denominator),
            denominator,
        }
    }

    fn cosine(&self, angle: &DihedralAngle) -> Cosine {
        Cosine {
            sign: match angle.signed_square.sign() {
                Sign::Less => -1,
                Sign::Equal => 0,
                Sign::Greater => 1,
            },
            square: self.fraction(&angle.signed_square.abs()),
        }
    }

    /// A statement as a certificate has it.
    pub fn statement(&self, statement: &Statement) -> format::Statement {
        match statement {
            Statement::FaceToFaceTiling => format::Statement::FaceToFaceTiling,
            Statement::Acute => format::Statement::Acute,
            Statement::Nonobtuse => format::Statement::Nonobtuse,
            Statement::LargestAngle(relation, angle) => {
                format::Statement::LargestAngle(*relation, self.cosine(angle))
            }
            Statement::SmallestAngle(relation, angle) => {
                format::Statement::SmallestAngle(*relation, self.cosine(angle))
            }
            Statement::RadiusEdge(relation, RadiusEdge { square }) => {
                format::Statement::SquaredRatio(*relation, self.fraction(square))
            }
            Statement::UncrossedPlane(plane) => format::Statement::UncrossedPlane(plane.clone()),
            Statement::Delaunay => format::Statement::Delaunay,
            Statement::WeaklyDelaunay => format::Statement::WeaklyDelaunay,
            Statement::LocallyDelaunay => format::Statement::LocallyDelaunay,
            Statement::LocallyWeaklyDelaunay => format::Statement::LocallyWeaklyDelaunay,
            Statement::NotDelaunay => format::Statement::NotDelaunay,
            Statement::Tcp => format::Statement::Tcp,
        }
    }
}

/// Divides numbers by the greatest common divisor of all their coefficients.
pub fn make_primitive<'n>(numbers: impl Iterator<Item = &'n mut format::Number>) {
    let numbers: Vec<&mut format::Number> = numbers.collect();
    let all = numbers.iter().flat_map(|number| &number.0);
    let content = all.fold(Natural::ZERO, |gcd, n| gcd.gcd(n.unsigned_abs_ref()));
    let content = Integer::from(content.max(Natural::ONE));
    for number in numbers {
        number
            .0
            .iter_mut()
            .for_each(|n| *n = (&*n).div_exact(&content));
    }
}

/// The value of a rational number that is an integer: all callers have multiplied it by a common
/// denominator.
fn integer(x: &Rational) -> Integer {
    Integer::try_from(x.clone()).expect("the number is cleared of its denominator")
}
