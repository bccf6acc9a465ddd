//! Orientation, in-sphere and circumsphere of corners: by doubles where they prove
//! the answer, exactly everywhere else.
//!
//! Over the rationals all coordinates are brought to one denominator and the exact
//! work is in integers, of machine words where they suffice, unless that denominator
//! is huge; else it is in the field.

use super::DelaunayError;
use super::floats::{FloatSphere, Sphere};
use super::model::Model;
use super::narrow::Narrow;
use super::tree::Ball;
use crate::tiling::Corner;
use acutile_exact::geometry::{Scalar, Sign, Simplex, linear};
use acutile_exact::number::Number;
use malachite::base::num::arithmetic::traits::Lcm;
use malachite::base::num::basic::traits::One;
use malachite::base::num::logic::traits::SignificantBits;
use malachite::{Integer, Natural, Rational};
use std::borrow::Cow;

/// A common denominator with more bits than this would not pay.
const DENOMINATOR_BITS: u64 = 256;

/// Exact coordinates in some ring, in units of 1/`unit`.
#[derive(Clone, Debug)]
pub struct Exact<'a, S: Clone, const D: usize> {
    points: Cow<'a, [[S; D]]>,
    unit: S,
    gram: [[S; D]; D],
}

impl<'a, const D: usize> Exact<'a, Number, D> {
    /// The coordinates of the model as they are.
    pub fn numbers(model: &'a Model<D>) -> Self {
        Exact {
            points: Cow::Borrowed(&model.points),
            unit: Number::from(Rational::ONE),
            gram: model.lattice.gram.clone(),
        }
    }
}

impl<const D: usize> Exact<'_, Integer, D> {
    /// The coordinates over one denominator, if all are rational and it is small.
    pub fn integers(model: &Model<D>) -> Option<Self> {
        let unit = common_denominator(&model.points)?;
        let metric = common_denominator(&model.lattice.gram)?;
        let points = model
            .points
            .iter()
            .map(|x| cleared(x, &unit))
            .collect::<Option<Vec<_>>>()?;
        let mut gram = Vec::with_capacity(D);
        for row in &model.lattice.gram {
            gram.push(cleared(row, &metric)?);
        }
        Some(Exact {
            points: Cow::Owned(points),
            unit: Integer::from(unit),
            gram: gram.try_into().ok()?,
        })
    }
}

/// Of all entries, if they are rational and it is not huge.
pub fn common_denominator<const D: usize>(rows: &[[Number; D]]) -> Option<Natural> {
    let mut common = Natural::ONE;
    for x in rows.iter().flatten() {
        common = common.lcm(x.to_rational()?.denominator_ref());
        if common.significant_bits() > DENOMINATOR_BITS {
            return None;
        }
    }
    Some(common)
}

/// The entries times `unit`, if these are integers.
pub fn cleared<const D: usize>(row: &[Number; D], unit: &Natural) -> Option<[Integer; D]> {
    let mut integers = Vec::with_capacity(D);
    for x in row {
        let scaled = x.to_rational()? * Rational::from(unit);
        integers.push(Integer::try_from(scaled).ok()?);
    }
    integers.try_into().ok()
}

impl<S: Scalar, const D: usize> Exact<'_, S, D> {
    fn position(&self, corner: &Corner<D>) -> [S; D] {
        let point = &self.points[corner.vertex as usize];
        std::array::from_fn(|k| match corner.shift[k] {
            0 => point[k].clone(),
            s => point[k].plus(&self.unit.times(&self.unit.integer(i64::from(s)))),
        })
    }

    fn simplex(&self, facet: &[Corner<D>; D], apex: &Corner<D>) -> Simplex<S, D> {
        let corners: Vec<_> = facet
            .iter()
            .chain([apex])
            .map(|corner| self.position(corner))
            .collect();
        Simplex::new(&corners)
    }

    fn in_sphere(&self, facet: &[Corner<D>; D], apex: &Corner<D>, p: &Corner<D>) -> Sign {
        let offset = linear::subtract(&self.position(p), &self.position(&facet[0]));
        self.simplex(facet, apex).power(&self.gram, &offset).sign()
    }
}

/// The predicates of a model. A simplex is given as a facet and the corner
/// opposite to it.
#[derive(Clone, Debug)]
pub struct Predicates<'a, S: Clone, const D: usize> {
    pub model: &'a Model<D>,
    pub exact: Exact<'a, S, D>,
    /// The same points in machine integers, if they fit.
    pub narrow: Option<Narrow<D>>,
    /// Whether doubles may decide where they prove the answer.
    pub filtered: bool,
}

impl<S: Scalar, const D: usize> Predicates<'_, S, D> {
    /// The sign of the determinant of the edges from the first corner of the facet.
    pub fn orientation(&self, facet: &[Corner<D>; D], apex: &Corner<D>) -> Sign {
        let quick = self
            .filtered
            .then(|| self.model.floats.orientation(facet, apex))
            .flatten();
        quick
            .or_else(|| self.narrow.as_ref()?.orientation(facet, apex))
            .unwrap_or_else(|| self.exact.simplex(facet, apex).determinant.sign())
    }

    /// The sphere through the corners of a positively oriented simplex, to ask on which
    /// side of it points are.
    pub fn sphere(&self, facet: &[Corner<D>; D], apex: &Corner<D>) -> SphereTest<'_, S, D> {
        SphereTest {
            exact: &self.exact,
            narrow: self.narrow.as_ref(),
            facet: *facet,
            apex: *apex,
            floats: self.filtered.then(|| self.model.floats.sphere(facet, apex)),
        }
    }

    /// The circumsphere of a simplex that is not flat, relative to facet[0].
    pub fn circumsphere(&self, facet: &[Corner<D>; D], apex: &Corner<D>) -> Sphere<D> {
        let quick = self
            .filtered
            .then(|| self.model.floats.circumsphere(facet, apex))
            .flatten();
        quick.unwrap_or_else(|| {
            let (center, _) = exact_center(self.model, facet, apex);
            self.model.floats.sphere_at(&center)
        })
    }

    /// All corners but those of the simplex that may be on or inside its sphere.
    pub fn near_sphere(
        &self,
        facet: &[Corner<D>; D],
        apex: &Corner<D>,
        enough: usize,
        found: &mut Vec<Corner<D>>,
    ) -> Result<(), DelaunayError> {
        let Sphere {
            center,
            radius,
            slack,
        } = self.circumsphere(facet, apex);
        let ball = Ball {
            center,
            radius: radius + slack,
        };
        let Model { floats, tree, .. } = self.model;
        tree.gather(floats, &facet[0], ball, enough, found)?;
        found.retain(|p| p != apex && !facet.contains(p));
        Ok(())
    }
}

/// See [`Predicates::sphere`].
pub struct SphereTest<'a, S: Clone, const D: usize> {
    exact: &'a Exact<'a, S, D>,
    narrow: Option<&'a Narrow<D>>,
    facet: [Corner<D>; D],
    apex: Corner<D>,
    floats: Option<FloatSphere<'a, D>>,
}

impl<S: Scalar, const D: usize> SphereTest<'_, S, D> {
    /// Whether p is outside of (`Greater`), on or inside (`Less`) the sphere.
    pub fn side(&self, p: &Corner<D>) -> Sign {
        let quick = self.floats.as_ref().and_then(|sphere| sphere.side(p));
        quick
            .or_else(|| self.narrow?.in_sphere(&self.facet, &self.apex, p))
            .unwrap_or_else(|| self.exact.in_sphere(&self.facet, &self.apex, p))
    }
}

/// The exact circumcentre of a simplex that is not flat, relative to its first
/// corner and in the reduced basis, and the square of the radius.
pub fn exact_center<const D: usize>(
    model: &Model<D>,
    facet: &[Corner<D>; D],
    apex: &Corner<D>,
) -> ([Number; D], Number) {
    let corners: Vec<_> = facet
        .iter()
        .chain([apex])
        .map(|c| model.position(c))
        .collect();
    let gram = &model.lattice.gram;
    // There is one: the simplex is not flat and the metric is positive definite.
    let center = circumcenter(gram, &corners).unwrap_or_else(|| corners[0].clone());
    let center = linear::subtract(&center, &corners[0]);
    let squared_radius = linear::square(gram, &center);
    (center, squared_radius)
}

/// The circumcentre of the simplex with these D + 1 corners, exactly, in the basis with
/// this Gram matrix; `None` if the simplex is flat or the metric degenerate.
///
/// With x measured from corner 0 it solves e_k · G x = |e_k|²/2. Since g_j · e_k is d
/// for j = k and else 0, G x = h/(2d) with h = Σ |e_k|² g_k; and with the
/// adjugate of G, x = adj(G) h / (2 d det G).
pub fn circumcenter<const D: usize>(
    gram: &[[Number; D]; D],
    corners: &[[Number; D]],
) -> Option<[Number; D]> {
    let simplex = Simplex::new(corners);
    let mut h: [Number; D] = std::array::from_fn(|_| Number::zero());
    for (edge, gradient) in simplex.edges.iter().zip(&simplex.gradients) {
        let square = linear::square(gram, edge);
        h = std::array::from_fn(|k| &h[k] + &(&square * &gradient[k]));
    }
    let adjugate = linear::cofactors(gram);
    let scale =
        &(&simplex.determinant * &linear::determinant(gram)) * &Number::from(Rational::from(2));
    let inverse = scale.inverse()?;
    let offset = linear::apply(&adjugate, &h);
    Some(std::array::from_fn(|k| {
        &corners[0][k] + &(&offset[k] * &inverse)
    }))
}

/// Refuses points that differ by a lattice vector: of the corners that the doubles
/// cannot tell from a point, none has the same exact position.
pub fn check_distinct<const D: usize>(model: &Model<D>) -> Result<(), DelaunayError> {
    let ball = Ball {
        center: [0.0; D],
        radius: model.floats.resolution(),
    };
    let mut near = Vec::new();
    for vertex in 0..model.names.len() as u32 {
        let corner = Corner::of(vertex);
        model
            .tree
            .gather(&model.floats, &corner, ball, usize::MAX, &mut near)?;
        let twin = near
            .iter()
            .find(|p| p.vertex != vertex && model.position(p) == model.position(&corner));
        if let Some(twin) = twin {
            let [a, b] = [vertex, twin.vertex].map(|v| model.names[v as usize] as usize);
            return Err(DelaunayError::Coincident(a.min(b), a.max(b)));
        }
    }
    Ok(())
}
