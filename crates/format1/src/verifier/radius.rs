//! `all radius-edge ratios below q`: the circumradius against every edge.

use super::Refusal;
use super::geometry::facet_pairs;
use super::integer::Integer;
use super::matrix::{Matrix, apply, determinant};
use super::ring::Element;
use super::simplex::Judge;
use super::tiling::Tiling;
use std::cmp::Ordering;

/// R < q l for every edge length l of every simplex, with R its circumradius.
///
/// Let M hold the e_i · e_j, C its cofactors, δ_i = M_ii. The circumcentre z, seen
/// from x_0, has 2 z · e_i = δ_i, so z = Σ y_i e_i with 2 M y = δ, and
/// R² = y^T M y = δ^T M^-1 δ / 4 = δ^T C δ / (4 det M). Hence, for q = p/s, the
/// rule is s² δ^T C δ - 4 p² det(M) l² < 0, for det M > 0.
pub(super) fn judge_radius_edge<'t>(tiling: &'t Tiling) -> Option<Judge<'t>> {
    let q = tiling.bounds.radius_edge.as_ref()?;
    let ring = &tiling.ring;
    let left = Element::integer(Integer::from(q.denom() * q.denom()));
    let right = Element::integer(Integer::from(q.numer() * q.numer() * 4));
    Some(Box::new(move |simplex| {
        let products = &simplex.edges;
        let diagonal: Vec<Element> = (0..products.len())
            .map(|i| products[i][i].clone())
            .collect();
        let inner = apply(ring, &simplex.cofactors, &diagonal);
        let radius = ring.times(&left, &ring.dot(&diagonal, &inner));
        let volume = ring.times(&right, &determinant(ring, products));
        for ends @ (i, j) in facet_pairs(tiling.dimension()) {
            let value = radius
                .clone()
                .minus(&ring.times(&volume, &length(products, i, j)));
            let index = simplex.index;
            let of = || format!("radius less edge {i} {j} of simplex {index}, scaled");
            if tiling.sign(&value, &Integer::ONE, of)? != Ordering::Less {
                return Err(Refusal::RatioNotBelow {
                    simplex: index,
                    corners: ends,
                    ratio: q.to_string(),
                });
            }
        }
        Ok(())
    }))
}

/// |x_i - x_j|² for i < j: M_jj for i = 0, and else |e_i - e_j|².
fn length(products: &Matrix, i: usize, j: usize) -> Element {
    let square = products[j - 1][j - 1].clone();
    if i == 0 {
        return square;
    }
    let mixed = &products[i - 1][j - 1];
    square
        .plus(&products[i - 1][i - 1])
        .minus(mixed)
        .minus(mixed)
}
