//! The certificate's numbers as elements of one ring, denominators cleared.
//!
//! With N a common denominator of the coordinates and d one of the Gram matrix,
//! both positive integers, the kernel computes with N x and d G. Every
//! predicate is homogeneous in x and in G, so its sign stays.

use super::cbor::Lists;
use super::corners::Corners;
use super::document::Document;
use super::domain::Polytope;
use super::integer::Integer;
use super::matrix::Matrix;
use super::number::{self, Rational};
use super::ring::{Element, Ring};
use super::shape::{check_row_of_corners, check_row_of_mates};
use super::{Limits, Refusal};
use crate::certificate::{AlgebraicField, Field, Number, Statement};
use num_bigint::BigInt;
use num_integer::Integer as _;
use num_traits::{One, Signed, Zero};
use std::cmp::Ordering;

pub(super) struct Tiling<'c> {
    pub(super) certificate: &'c Document<'c>,
    pub(super) ring: Ring,
    /// d G
    pub(super) gram: Matrix,
    /// d
    pub(super) gram_scale: Integer,
    /// N x for each vertex x.
    pub(super) vertices: Matrix,
    pub(super) polytope: Option<Polytope<'c>>,
    /// N
    pub(super) scale: Integer,
    pub(super) bounds: Bounds,
    /// What comparisons of the facets in the boundary of a region may cost.
    pub(super) limit: u64,
}

/// The bounds of the claimed statements that have one; angles in degrees.
#[derive(Default)]
pub(super) struct Bounds {
    pub(super) below: Option<Rational>,
    pub(super) above: Option<Rational>,
    pub(super) radius_edge: Option<Rational>,
}

impl Bounds {
    /// The bits of the ratio, by whose square each simplex is multiplied. Angles
    /// enter through cosines of a fixed size.
    fn bits(&self) -> u64 {
        let ratio = self.radius_edge.as_ref();
        ratio.map_or(0, |q| q.numer().bits().max(q.denom().bits()))
    }
}

impl<'c> Tiling<'c> {
    /// Reads the numbers of a certificate that has passed [`super::shape`].
    pub(super) fn new(certificate: &'c Document<'c>, limits: &Limits) -> Result<Self, Refusal> {
        let claim = &certificate.claim;
        let ring = ring(&claim.field, limits)?;
        let reader = Reader {
            degree: ring.degree(),
            limits,
        };
        let polytope = claim.domain.polytope();
        let corners = polytope.map_or(&[][..], |polytope| &polytope.vertices);
        let (gram, gram_scale) = reader.table(&[("gram", &in_memory(&claim.gram))])?;
        let vertices = &certificate.witness.vertices;
        let all = |visit: Visit| vertices.each(|i, row| visit(i, row));
        let tables: [(_, EachRow); 2] = [("vertices", &all), ("domain", &in_memory(corners))];
        let (mut vertices, scale) = reader.table(&tables)?;
        let corners = vertices.split_off(certificate.witness.vertices.len());
        let polytope = polytope.map(|polytope| Polytope {
            faces: &polytope.faces,
            vertices: corners,
        });
        let tiling = Tiling {
            certificate,
            ring,
            gram,
            gram_scale,
            vertices,
            polytope,
            scale,
            bounds: bounds(&claim.statements, limits)?,
            limit: limits.work.saturating_mul(Limits::SIGNS),
        };
        tiling.check_work(limits)?;
        Ok(tiling)
    }

    /// Bounds the products before they are made; the ring counts its signs. A product of two elements whose
    /// coefficients have w words costs n² w² word products; reductions multiply
    /// by powers of p up to the n-th, so p's bits count n times. The domain's
    /// vertices are put into the plane of each face and, at worst, the vertices
    /// of each face into all planes through its sides; the tiling's into each plane.
    fn check_work(&self, limits: &Limits) -> Result<(), Refusal> {
        let (mut corners, mut faces, mut incidences) = (0, 0, 0);
        if let Some(polytope) = &self.polytope {
            (corners, faces) = (polytope.vertices.len(), polytope.faces.len());
            incidences = polytope.faces.iter().map(Vec::len).sum();
        }
        let domain = incidences
            .saturating_mul(corners)
            .saturating_add(faces.saturating_mul(self.vertices.len()));
        let count = domain.saturating_add(self.count());
        let found = self.product().saturating_mul(count as u64);
        match found <= limits.work {
            true => Ok(()),
            false => Err(Refusal::Work {
                of: "for each product",
                found,
                limit: limits.work,
            }),
        }
    }

    /// n² w²
    pub(super) fn product(&self) -> u64 {
        let n = self.ring.degree() as u64;
        let corners = self.polytope.iter().flat_map(|p| &p.vertices);
        let table = self.gram.iter().chain(&self.vertices).chain(corners);
        let coefficients = table.flatten().map(Element::bits).max().unwrap_or(0);
        let bits = coefficients
            .max(self.scale.bits())
            .max(self.bounds.bits())
            .max(n.saturating_mul(self.ring.bits()));
        let words = bits / 64 + 1;
        [n, n, words, words]
            .into_iter()
            .fold(1, u64::saturating_mul)
    }

    /// D
    pub(super) fn dimension(&self) -> usize {
        self.certificate.claim.dimension
    }

    pub(super) fn claims(&self, statement: &Statement) -> bool {
        self.certificate.claim.statements.contains(statement)
    }

    /// How many simplices there are.
    pub(super) fn count(&self) -> usize {
        self.certificate.witness.simplices.len()
    }

    /// Calls `visit` for each simplex, in order.
    pub(super) fn each_simplex(
        &self,
        mut visit: impl FnMut(usize, Corners) -> Result<(), Refusal>,
    ) -> Result<(), Refusal> {
        let simplices = &self.certificate.witness.simplices;
        simplices.each(|simplex, corners| visit(simplex, self.corners(simplex, corners)?))
    }

    /// Calls `visit` for each simplex with its mates, in order.
    pub(super) fn each_row(
        &self,
        mut visit: impl FnMut(usize, Corners, &Lists) -> Result<(), Refusal>,
    ) -> Result<(), Refusal> {
        let witness = &self.certificate.witness;
        witness
            .simplices
            .each_beside(&witness.mates, |simplex, corners, mates| {
                if witness.mates.may_change() {
                    check_row_of_mates(self.certificate, simplex, mates)?;
                }
                visit(simplex, self.corners(simplex, corners)?, mates)
            })
    }

    /// Its shape has been checked; but a file can change, which the digest tells at the end only.
    fn corners<'r>(&self, simplex: usize, row: &'r Lists) -> Result<Corners<'r>, Refusal> {
        if self.certificate.witness.simplices.may_change() {
            check_row_of_corners(self.certificate, simplex, row)?;
        }
        let rank = self.certificate.claim.domain.rank(self.dimension());
        Ok(Corners::new(row.entries(), rank))
    }

    /// N times the vector from one place, moved by the lattice vector `by`, to
    /// another; in basis coordinates.
    pub(super) fn edge(&self, from: &[i64], to: &[i64], by: &[i64]) -> Vec<Element> {
        let (start, end) = (self.vertex(from), self.vertex(to));
        let mut edge: Vec<Element> = end
            .iter()
            .zip(start)
            .map(|(end, start)| end.clone().minus(start))
            .collect();
        for (k, coordinate) in edge.iter_mut().enumerate().take(by.len()) {
            let shift = to[1 + k] - from[1 + k] + by[k];
            if shift != 0 {
                let moved = Element::integer(&self.scale * &Integer::from(shift));
                *coordinate = std::mem::take(coordinate).plus(&moved);
            }
        }
        edge
    }

    /// N times the edge vectors from corner 0 to the corners 1, …, D, as rows.
    pub(super) fn edges(&self, corners: Corners) -> Matrix {
        let still = [0; 3];
        let first = corners.get(0);
        corners
            .without(0)
            .map(|corner| self.edge(first, corner, &still[..first.len() - 1]))
            .collect()
    }

    /// N times the vertex of a place, not moved.
    pub(super) fn vertex(&self, place: &[i64]) -> &[Element] {
        &self.vertices[place[0] as usize]
    }

    /// The sign of `value`, or the refusal that it is undecided. `of` says what
    /// `value` is, and `scale` by what positive integer it is too large.
    pub(super) fn sign(
        &self,
        value: &Element,
        scale: &Integer,
        of: impl Fn() -> String,
    ) -> Result<Ordering, Refusal> {
        let undecided = || Refusal::SignUndecided {
            of: of(),
            value: number(value, scale),
        };
        self.ring.sign(value)?.ok_or_else(undecided)
    }
}

/// The element `value` divided by `scale`, as a certificate writes it.
pub(super) fn number(value: &Element, scale: &Integer) -> Number {
    let big = |x: &Integer| x.clone().into_big();
    let text = |c| Rational::new(big(c), big(scale)).to_string();
    Number(value.coefficients().map(text).collect())
}

/// The ring of the claimed field, once the field has been shown to be one.
fn ring(field: &Field, limits: &Limits) -> Result<Ring, Refusal> {
    let Field::Algebraic(AlgebraicField { polynomial, root }) = field else {
        return Ok(Ring::integers());
    };
    let modulus = modulus(polynomial, limits)?;
    let low = number::rational(&root.0, &|| "root[0]".to_owned(), limits)?;
    let high = number::rational(&root.1, &|| "root[1]".to_owned(), limits)?;
    Ring::extension(modulus, (low, high), limits)
}

/// p is monic, of degree n with 2 <= n <= limit, and its coefficients are integers.
fn modulus(polynomial: &[String], limits: &Limits) -> Result<Element, Refusal> {
    let refuse = |reason| Err(Refusal::Polynomial { reason });
    if polynomial.len() < 3 {
        return refuse("its degree is less than two");
    }
    let degree = polynomial.len() - 1;
    if degree > limits.degree {
        return Err(Refusal::Degree {
            found: degree,
            limit: limits.degree,
        });
    }
    if polynomial[degree] != "1" {
        return refuse("it is not monic");
    }
    let mut modulus = Vec::new();
    for (k, text) in polynomial.iter().enumerate() {
        let coefficient = number::rational(text, &|| format!("polynomial[{k}]"), limits)?;
        if !coefficient.is_integer() {
            return refuse("a coefficient is not an integer");
        }
        modulus.push(Integer::from(coefficient.to_integer()));
    }
    Ok(Element::new(modulus))
}

/// The claimed bounds: angles below Q with 0 < Q <= 180 and above Q with
/// 0 <= Q < 180, ratios below q with 0 < q.
fn bounds(statements: &[Statement], limits: &Limits) -> Result<Bounds, Refusal> {
    let mut bounds = Bounds::default();
    let half_turn = Rational::from_integer(BigInt::from(180));
    let refuse = |found: &String| Refusal::AngleRange {
        found: found.clone(),
    };
    for statement in statements {
        let read = |text, of: &str| number::rational(text, &|| of.to_owned(), limits);
        match statement {
            Statement::DihedralBelow(text) => {
                let angle = read(text, "all dihedral angles below")?;
                let fits = angle.is_positive() && angle <= half_turn;
                bounds.below = Some(fits.then_some(angle).ok_or_else(|| refuse(text))?);
            }
            Statement::DihedralAbove(text) => {
                let angle = read(text, "all dihedral angles above")?;
                let fits = !angle.is_negative() && angle < half_turn;
                bounds.above = Some(fits.then_some(angle).ok_or_else(|| refuse(text))?);
            }
            Statement::RadiusEdgeBelow(text) => {
                let ratio = read(text, "all radius-edge ratios below")?;
                if !ratio.is_positive() {
                    return Err(Refusal::RatioRange {
                        found: text.clone(),
                    });
                }
                bounds.radius_edge = Some(ratio);
            }
            _ => {}
        }
    }
    Ok(bounds)
}

/// Takes a row and its number.
type Visit<'v> = &'v mut dyn FnMut(usize, &[Number]) -> Result<(), Refusal>;

/// Goes through the rows of a table.
type EachRow<'t> = &'t dyn Fn(Visit) -> Result<(), Refusal>;

fn in_memory(rows: &[Vec<Number>]) -> impl Fn(Visit) -> Result<(), Refusal> {
    move |visit| {
        let mut rows = rows.iter().enumerate();
        rows.try_for_each(|(i, row)| visit(i, row))
    }
}

/// Reads tables of field elements.
struct Reader<'l> {
    degree: usize,
    limits: &'l Limits,
}

impl Reader<'_> {
    /// m T for a positive integer m, the least that makes all T integral, and m;
    /// the rows of the named tables one after another, each gone through twice.
    fn table(&self, tables: &[(&'static str, EachRow)]) -> Result<(Matrix, Integer), Refusal> {
        let mut common = BigInt::one();
        for (name, each) in tables {
            each(&mut |i, row| {
                for (j, number) in row.iter().enumerate() {
                    for c in self.coefficients(number, &|| format!("{name}[{i}][{j}]"))? {
                        self.widen(&mut common, &c, name)?;
                    }
                }
                Ok(())
            })?;
        }
        let mut rows = Vec::new();
        for (name, each) in tables {
            each(&mut |i, row| {
                let place = || format!("{name}[{i}]");
                let mut scaled = Vec::with_capacity(row.len());
                for number in row {
                    scaled.push(self.element(number, &common, &place)?);
                }
                rows.push(scaled);
                Ok(())
            })?;
        }
        Ok((rows, Integer::from(common)))
    }

    /// The number, `common` times too large, which makes it integral.
    fn element(
        &self,
        number: &Number,
        common: &BigInt,
        place: &dyn Fn() -> String,
    ) -> Result<Element, Refusal> {
        let coefficients = self.coefficients(number, place)?;
        let integral = |c: &Rational| Integer::from(c.numer() * (common / c.denom()));
        Ok(Element::new(coefficients.iter().map(integral)))
    }

    /// Between one and n coefficients, the last one not zero unless it is alone.
    fn coefficients(
        &self,
        number: &Number,
        place: &dyn Fn() -> String,
    ) -> Result<Vec<Rational>, Refusal> {
        let refuse = |reason| {
            Err(Refusal::Coefficients {
                place: place(),
                reason,
            })
        };
        let count = number.0.len();
        if count == 0 {
            return refuse("there is none");
        }
        if count > self.degree {
            return refuse("there are more than the degree of the field");
        }
        let read = |text: &String| number::rational(text, place, self.limits);
        let coefficients = number.0.iter().map(read).collect::<Result<Vec<_>, _>>()?;
        if count > 1 && coefficients[count - 1].is_zero() {
            return refuse("the last one is zero");
        }
        Ok(coefficients)
    }

    /// common = lcm(common, denominator), while it has no more digits than allowed.
    fn widen(&self, common: &mut BigInt, c: &Rational, of: &'static str) -> Result<(), Refusal> {
        if common.is_multiple_of(c.denom()) {
            return Ok(());
        }
        *common = common.lcm(c.denom());
        let limit = self.limits.digits;
        match common.to_string().len() <= limit {
            true => Ok(()),
            false => Err(Refusal::CommonDenominator { of, limit }),
        }
    }
}
