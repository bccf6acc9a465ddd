//! A simplex by its barycentric gradients: orientation, dihedral angles and the
//! circumsphere as polynomials in the coordinates.
//!
//! Let e_1 … e_D be the edges from corner 0 of a D-simplex, in basis coordinates,
//! E the matrix with these rows and d = det E. The barycentric coordinates are
//! affine functions; write g_i for the gradient of the i-th one times d. Then
//! g_1 … g_D are the rows of the cofactor matrix of E (g_i · e_j = d for i = j, 0
//! otherwise) and g_0 = -(g_1 + … + g_D). For d > 0 the covector g_i is an inward
//! normal of the facet opposite to corner i.
//!
//! Covectors are measured by the inverse of the Gram matrix G, or, up to the
//! positive factor det G, by its adjugate: `cogram`. The dihedral angle t between
//! the facets i and j has
//!     cos t = -<g_i, g_j> / (|g_i| |g_j|),
//! so it is acute exactly when <g_i, g_j> < 0 and right exactly when that is zero.

use super::{RingElement, linear};

/// The edges and scaled barycentric gradients of a simplex with D + 1 corners.
#[derive(Clone, Debug)]
pub struct Simplex<S, const D: usize> {
    /// e_1 … e_D, in basis coordinates.
    pub edges: [[S; D]; D],
    /// g_1 … g_D; g_0 = -(g_1 + … + g_D).
    pub gradients: [[S; D]; D],
    /// det E: D! times the signed volume in units of the basis' parallelepiped.
    pub determinant: S,
}

impl<S: RingElement, const D: usize> Simplex<S, D> {
    /// The simplex with these D + 1 corners, in basis coordinates.
    ///
    /// # Panics
    /// If there are not D + 1 corners.
    pub fn new(corners: &[[S; D]]) -> Self {
        assert_eq!(corners.len(), D + 1, "a {D}-simplex has {} corners", D + 1);
        Simplex::from_edges(std::array::from_fn(|k| {
            linear::subtract(&corners[k + 1], &corners[0])
        }))
    }

    /// The simplex with these edges e_1 … e_D from corner 0, in basis coordinates.
    #[inline(always)]
    pub fn from_edges(edges: [[S; D]; D]) -> Self {
        let gradients = linear::cofactors(&edges);
        let determinant = linear::dot(&edges[0], &gradients[0]);
        Simplex {
            edges,
            gradients,
            determinant,
        }
    }

    /// The inner products <g_i, g_j> for 0 <= i, j <= D, measured by `cogram`.
    ///
    /// As g_0 = -(g_1 + … + g_D), its products are sums of the others:
    /// <g_0, g_j> = -Σ_i <g_i, g_j> and <g_0, g_0> = -Σ_j <g_0, g_j>.
    #[inline(always)]
    pub fn normal_products(&self, cogram: &[[S; D]; D]) -> NormalProducts<S, D> {
        let zero = self.determinant.integer(0);
        let mut inner: [[S; D]; D] = linear::zeros(&zero);
        for j in 0..D {
            let image = linear::apply(cogram, &self.gradients[j]);
            // Not a range that ends with j: only loops of constant length are unrolled.
            for i in 0..D {
                if i <= j {
                    inner[i][j] = linear::dot(&self.gradients[i], &image);
                    inner[j][i] = inner[i][j].clone();
                }
            }
        }
        let minus_sum = |row: &[S; D]| zero.minus(&linear::sum(row));
        let [mut first] = linear::zeros(&zero);
        for j in 0..D {
            first[j] = minus_sum(&inner[j]);
        }
        NormalProducts {
            corner: minus_sum(&first),
            first,
            inner,
        }
    }

    /// Calls `visit` with the squared lengths of the edges: of e_1 … e_D, then of
    /// e_j - e_i for i < j.
    #[inline]
    pub fn for_squared_edges(&self, gram: &[[S; D]; D], mut visit: impl FnMut(&S)) {
        for edge in &self.edges {
            visit(&linear::square(gram, edge));
        }
        for i in 0..D {
            for j in i + 1..D {
                let edge = linear::subtract(&self.edges[j], &self.edges[i]);
                visit(&linear::square(gram, &edge));
            }
        }
    }

    /// Numerator and positive denominator of the squared circumradius.
    ///
    /// The circumcentre is corner 0 plus x with e_i · x = |e_i|²/2. As the gradients are
    /// dual to the edges, x is half the sum of |e_i|² ∇λ_i, and with the products
    /// P_ij = <g_i, g_j> measured by the adjugate of G this gives
    /// |x|² = Σ |e_i|² |e_j|² P_ij / (4 d² det G).
    pub fn squared_circumradius(
        &self,
        gram: &[[S; D]; D],
        products: &NormalProducts<S, D>,
    ) -> (S, S) {
        let squares = self.edges.each_ref().map(|edge| linear::square(gram, edge));
        let mut numerator = self.determinant.integer(0);
        for (i, a) in squares.iter().enumerate() {
            for (j, b) in squares.iter().enumerate() {
                numerator = numerator.plus(&a.times(b).times(products.get(i + 1, j + 1)));
            }
        }
        let four = self.determinant.integer(4);
        let square = self.determinant.times(&self.determinant);
        (
            numerator,
            four.times(&square).times(&linear::determinant(gram)),
        )
    }

    /// How far the point corner_0 + `offset` is outside of the circumsphere:
    /// for d > 0 positive outside, zero on it, negative inside.
    ///
    /// x ↦ |x|² - Σ λ_i(x) |e_i|² (x measured from corner 0) vanishes on the
    /// circumsphere, for it is a monic quadratic that is zero at all corners;
    /// times d it is the polynomial d |x|² - Σ (g_i · x) |e_i|².
    #[inline(always)]
    pub fn power(&self, gram: &[[S; D]; D], offset: &[S; D]) -> S {
        let mut power = self.determinant.times(&linear::square(gram, offset));
        for (edge, gradient) in self.edges.iter().zip(&self.gradients) {
            let term = linear::dot(gradient, offset).times(&linear::square(gram, edge));
            power = power.minus(&term);
        }
        power
    }
}

/// The matrix of <g_i, g_j>.
#[derive(Clone, Debug)]
pub struct NormalProducts<S, const D: usize> {
    /// <g_0, g_0>
    corner: S,
    /// <g_0, g_j> for j = 1 … D
    first: [S; D],
    /// <g_i, g_j> for i, j = 1 … D
    inner: [[S; D]; D],
}

impl<S: RingElement, const D: usize> NormalProducts<S, D> {
    /// <g_i, g_j>: negative, zero or positive as the dihedral angle between the
    /// facets i and j is acute, right or obtuse.
    #[inline(always)]
    pub fn get(&self, i: usize, j: usize) -> &S {
        match (i, j) {
            (0, 0) => &self.corner,
            (0, k) | (k, 0) => &self.first[k - 1],
            _ => &self.inner[i - 1][j - 1],
        }
    }

    /// Calls `visit` with i, j and the product for all pairs i < j, in order.
    #[inline(always)]
    pub fn for_pairs(&self, mut visit: impl FnMut(usize, usize, &S)) {
        for (j, product) in self.first.iter().enumerate() {
            visit(0, j + 1, product);
        }
        for i in 0..D {
            for j in i + 1..D {
                visit(i + 1, j + 1, &self.inner[i][j]);
            }
        }
    }

    /// All pairs i < j with their product.
    pub fn pairs(&self) -> impl Iterator<Item = (usize, usize, &S)> {
        (0..=D).flat_map(move |i| (i + 1..=D).map(move |j| (i, j, self.get(i, j))))
    }
}
