//! What several statements ask of one simplex, computed once.
//!
//! A statement about single simplices gives a [`Judge`]. [`check_simplices`] shows each
//! simplex to all of them, and refuses as if they had gone through the tiling in turn.

use super::Refusal;
use super::corners::Corners;
use super::matrix::{Matrix, apply, cofactors};
use super::ring::Element;
use super::tiling::Tiling;
use std::iter;

/// A simplex of the tiling, seen through its metric.
pub(super) struct Simplex {
    /// Its position in the certificate.
    pub(super) index: usize,
    /// M = E G E^T: the inner products e_i · e_j, d N² times too large.
    pub(super) edges: Matrix,
    /// C: the cofactors of M.
    pub(super) cofactors: Matrix,
    /// The inner products of the gradients g_0, …, g_D of the barycentric
    /// coordinates, times det M > 0.
    ///
    /// g_1, …, g_D is the dual basis of e_1, …, e_D, so (g_i · g_j) = M^-1 = C / det M,
    /// and g_0 = -(g_1 + … + g_D). The gradient g_i is the inward normal of the facet
    /// opposite to x_i. det M > 0 because det E and det G are. The result is
    /// d^(D-1) N^(2D-2) too large.
    pub(super) gradients: Matrix,
}

/// Whether a simplex is as one statement says.
pub(super) type Judge<'t> = Box<dyn Fn(&Simplex) -> Result<(), Refusal> + 't>;

/// The judge of a statement; none if it is not claimed.
pub(super) type Statement = for<'t> fn(&'t Tiling) -> Option<Judge<'t>>;

/// Shows every simplex to the judges of all claimed statements. The refusal is the first one
/// of the first statement that refuses: once a statement has, the later ones are dropped.
pub(super) fn check_simplices(tiling: &Tiling, statements: &[Statement]) -> Result<(), Refusal> {
    let claimed = statements.iter().filter_map(|judge| judge(tiling));
    let mut judges: Vec<Judge> = claimed.collect();
    if judges.is_empty() {
        return Ok(());
    }
    let mut refused = Ok(());
    tiling.each_simplex(|index, corners| {
        let simplex = Simplex::new(tiling, index, corners);
        let mut found = judges.iter().map(|judge| judge(&simplex)).enumerate();
        if let Some((statement, refusal)) = found.find(|(_, judged)| judged.is_err()) {
            judges.truncate(statement);
            refused = refusal;
        }
        match judges.is_empty() {
            true => std::mem::replace(&mut refused, Ok(())),
            false => Ok(()),
        }
    })?;
    refused
}

impl Simplex {
    fn new(tiling: &Tiling, index: usize, corners: Corners) -> Simplex {
        let edges = edge_products(tiling, corners);
        let cofactors = cofactors(&tiling.ring, &edges);
        Simplex {
            index,
            gradients: gradient_products(&cofactors),
            cofactors,
            edges,
        }
    }
}

fn edge_products(tiling: &Tiling, corners: Corners) -> Matrix {
    let ring = &tiling.ring;
    let edges = tiling.edges(corners);
    let dual: Matrix = edges
        .iter()
        .map(|edge| apply(ring, &tiling.gram, edge))
        .collect();
    let mut products = Matrix::new();
    for (i, edge) in edges.iter().enumerate() {
        let product = |j| match products.get::<usize>(j) {
            Some(row) => row[i].clone(),
            None => ring.dot(edge, &dual[j]),
        };
        products.push((0..edges.len()).map(product).collect());
    }
    products
}

fn gradient_products(inner: &Matrix) -> Matrix {
    let negated_sum =
        |values: &[Element]| values.iter().fold(Element::default(), |s, v| s.minus(v));
    let first: Vec<Element> = inner.iter().map(|row| negated_sum(row)).collect();
    let corner = negated_sum(&first);
    let row = |x: &Element, xs: &[Element]| iter::once(x).chain(xs).cloned().collect();
    let others = first.iter().zip(inner).map(|(x, xs)| row(x, xs));
    iter::once(row(&corner, &first)).chain(others).collect()
}
