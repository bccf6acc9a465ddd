//! Orientation, in-sphere and circumspheres of corners, by the predicates of
//! [`crate::predicates`].
//!
//! A simplex is given as a facet and the corner opposite to it.

use super::DelaunayError;
use super::model::Model;
use super::places::Sphere;
use super::tree::Ball;
use crate::predicates::{self, InSphere, Orientation, Predicate, Prepared};
use crate::tiling::Corner;
use acutile_exact::geometry::{Sign, Simplex, linear};
use acutile_exact::number::Number;
use malachite::Rational;

/// The predicates of a model.
#[derive(Clone, Debug)]
pub struct Predicates<'a, const D: usize> {
    pub model: &'a Model<D>,
    orientation: Prepared<'a, Orientation, D>,
    in_sphere: Prepared<'a, InSphere, D>,
    /// Whether doubles may decide where they prove the answer, and propose where they are
    /// clear.
    pub filtered: bool,
}

impl<'a, const D: usize> Predicates<'a, D> {
    /// The predicates for corners of a point set; `coordinates` are those of its points.
    pub fn new(model: &'a Model<D>, coordinates: &'a predicates::Model<'a, D>) -> Self {
        Predicates {
            model,
            orientation: coordinates.prepare(Orientation),
            in_sphere: coordinates.prepare(InSphere),
            filtered: true,
        }
    }

    /// The sign of the determinant of the edges from the first corner of the facet.
    pub fn orientation(&self, facet: &[Corner<D>; D], apex: &Corner<D>) -> Sign {
        self.sign(&self.orientation, &Corners::new(facet, apex), apex)
    }

    /// The sphere through the corners of a positively oriented simplex, to ask on which
    /// side of it points are.
    pub fn sphere(&self, facet: &[Corner<D>; D], apex: &Corner<D>) -> SphereTest<'_, D> {
        SphereTest {
            predicates: self,
            corners: Corners::new(facet, apex),
        }
    }

    fn sign<P: Predicate<D>>(
        &self,
        prepared: &Prepared<P, D>,
        corners: &Corners<D>,
        point: &Corner<D>,
    ) -> Sign {
        let corners = corners.as_slice();
        let signs = if self.filtered {
            prepared.signs_of(corners, point)
        } else {
            prepared.exact_signs(corners, point)
        };
        signs.get(0)
    }

    /// The circumsphere of a simplex that is not flat, relative to facet[0].
    pub fn circumsphere(
        &self,
        facet: &[Corner<D>; D],
        apex: &Corner<D>,
    ) -> Result<Sphere<D>, DelaunayError> {
        let places = &self.model.places;
        if self.filtered
            && let Some(sphere) = places.circumsphere(facet, apex)
        {
            return Ok(sphere);
        }
        let (center, _) = exact_center(self.model, facet, apex)?;
        Ok(places.sphere_at(&center))
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
        } = self.circumsphere(facet, apex)?;
        let ball = Ball {
            center,
            radius: radius + slack,
        };
        let Model { places, tree, .. } = self.model;
        tree.gather(places, &facet[0], ball, enough, found)?;
        found.retain(|p| p != apex && !facet.contains(p));
        Ok(())
    }
}

/// The D + 1 corners of a simplex: those of a facet, then its apex.
#[derive(Clone, Copy, Debug)]
struct Corners<const D: usize> {
    /// The first D + 1 count.
    array: [Corner<D>; 4],
}

impl<const D: usize> Corners<D> {
    fn new(facet: &[Corner<D>; D], apex: &Corner<D>) -> Self {
        const { assert!(D < 4) };
        Corners {
            array: std::array::from_fn(|k| *facet.get(k).unwrap_or(apex)),
        }
    }

    fn as_slice(&self) -> &[Corner<D>] {
        &self.array[..=D]
    }
}

/// See [`Predicates::sphere`].
pub struct SphereTest<'a, const D: usize> {
    predicates: &'a Predicates<'a, D>,
    corners: Corners<D>,
}

impl<const D: usize> SphereTest<'_, D> {
    /// Whether p is outside of (`Greater`), on or inside (`Less`) the sphere.
    pub fn side(&self, p: &Corner<D>) -> Sign {
        let Predicates { in_sphere, .. } = self.predicates;
        self.predicates.sign(in_sphere, &self.corners, p)
    }
}

/// The exact circumcentre of a simplex, relative to its first corner and in the reduced
/// basis, and the square of the radius.
///
/// # Errors
/// [`DelaunayError::Uncertified`] if the simplex is flat, as no simplex of a right search is.
pub fn exact_center<const D: usize>(
    model: &Model<D>,
    facet: &[Corner<D>; D],
    apex: &Corner<D>,
) -> Result<([Number; D], Number), DelaunayError> {
    let corners = Corners::new(facet, apex);
    let corners: Vec<_> = corners
        .as_slice()
        .iter()
        .map(|c| model.position(c))
        .collect();
    let gram = &model.lattice.gram;
    let center = circumcenter(gram, &corners).ok_or(DelaunayError::Uncertified)?;
    let center = linear::subtract(&center, &corners[0]);
    let squared_radius = linear::square(gram, &center);
    Ok((center, squared_radius))
}

/// The circumcentre of the simplex with these D + 1 corners, exactly, in the basis with this Gram matrix.
/// `None` if the simplex is flat or the metric is degenerate.
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
