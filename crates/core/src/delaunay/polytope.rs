//! Delaunay cells that are not simplices: their facets, and how they are cut into
//! simplices by pulling.
//!
//! Let < be the lexicographic order of positions in the caller's basis. Pulling a polytope: let v be its
//! least corner, and pull each facet that does not contain v. The simplices are the pyramids with apex v
//! over the simplices of these facets.
//!
//! *Pulling agrees on shared faces and across lattice translations.* The order depends only on differences
//! of positions, so translates are cut alike. The pulling of P, restricted to a face F of P, is the pulling
//! of F (De Loera, Rambau, Santos, Triangulations, 2010, Lemma 4.3.6). The proof is by induction on the
//! dimension. If F does not contain v, F lies in a facet that is pulled by itself. If it does, v is also
//! the least corner of F. Then the simplices in F are the pyramids with apex v over the faces of F without
//! v. These are faces of facets of P without v. So two cells with a common facet cut it alike.
//!
//! In the cubic lattice v is (0,0,0), and following the least corners
//! gives the paths from (0,0,0) to (1,1,1): the six tetrahedra of Kuhn.
//!
//! All corners lie on one sphere. Hence every corner is a vertex, and two facets
//! that share D - 1 corners meet in a face of dimension D - 2 (D = 3: two points of an
//! edge). Sets of corners are bit masks.

use super::DelaunayError;
use super::error::COSPHERICAL_LIMIT;
use super::predicates::Predicates;
use crate::tiling::Corner;
use acutile_exact::geometry::Sign;

/// A set of corners: bit i for the i-th.
pub type Mask = u128;

/// A Delaunay cell with more than D + 1 corners.
#[derive(Clone, Debug)]
pub struct Polytope<const D: usize> {
    /// In the order of pulling, moved by a common lattice vector at will.
    pub corners: Vec<Corner<D>>,
    /// The facets.
    pub facets: Vec<Mask>,
}

impl<const D: usize> Polytope<D> {
    /// The convex hull of corners on one sphere, not all in a hyperplane.
    ///
    /// Every D corners that lie in no facet yet span a hyperplane, because no three points of a sphere are
    /// on a line. It contains a facet exactly if no two corners lie on different sides.
    pub fn new(
        mut corners: Vec<Corner<D>>,
        predicates: &Predicates<D>,
    ) -> Result<Self, DelaunayError> {
        if corners.len() > COSPHERICAL_LIMIT {
            return Err(DelaunayError::TooManyCospherical(corners.len()));
        }
        sort_for_pulling(&mut corners, predicates)?;
        let mut polytope = Polytope {
            corners,
            facets: Vec::new(),
        };
        let mut chosen: [usize; D] = std::array::from_fn(|k| k);
        loop {
            let mask = chosen.iter().fold(0, |mask: Mask, i| mask | 1 << i);
            if !polytope.facets.iter().any(|facet| facet & mask == mask) {
                polytope
                    .facets
                    .extend(polytope.supporting(&chosen, predicates));
            }
            if !next_subset(&mut chosen, polytope.corners.len()) {
                return Ok(polytope);
            }
        }
    }

    /// The corners in the hyperplane of the chosen ones, if all others lie on one
    /// side of it.
    fn supporting(&self, chosen: &[usize; D], predicates: &Predicates<D>) -> Option<Mask> {
        let facet = chosen.map(|i| self.corners[i]);
        let mut on: Mask = 0;
        let mut side = None;
        for (i, corner) in self.corners.iter().enumerate() {
            let sign = if chosen.contains(&i) {
                Sign::Equal
            } else {
                predicates.orientation(&facet, corner)
            };
            match (sign, side) {
                (Sign::Equal, _) => on |= 1 << i,
                (sign, None) => side = Some(sign),
                (sign, Some(known)) if sign == known => {}
                _ => return None,
            }
        }
        Some(on)
    }

    /// D corners that span a facet, and a corner that is not in it.
    pub fn spanning(&self, facet: Mask) -> (Vec<Corner<D>>, Corner<D>) {
        let outside = (!facet).trailing_zeros() as usize;
        (self.select(facet), self.corners[outside])
    }

    fn select(&self, mask: Mask) -> Vec<Corner<D>> {
        indices(mask).map(|i| self.corners[i]).collect()
    }

    /// The simplices of the pulling, D + 1 corners each, not yet oriented.
    pub fn pulled(&self) -> Vec<Vec<Corner<D>>> {
        let all = Mask::MAX >> (COSPHERICAL_LIMIT - self.corners.len());
        self.pull(all, D)
            .into_iter()
            .map(|mask| self.select(mask))
            .collect()
    }

    /// The simplices of a face of dimension `dimension`.
    fn pull(&self, face: Mask, dimension: usize) -> Vec<Mask> {
        if face.count_ones() as usize == dimension + 1 {
            return vec![face];
        }
        let least = face & face.wrapping_neg();
        let mut simplices = Vec::new();
        for part in self.faces_within(face, dimension) {
            if part & least == 0 {
                simplices.extend(
                    self.pull(part, dimension - 1)
                        .iter()
                        .map(|mask| mask | least),
                );
            }
        }
        simplices
    }

    /// The faces of dimension one less within a face.
    fn faces_within(&self, face: Mask, dimension: usize) -> Vec<Mask> {
        let mut parts: Vec<Mask> = self
            .facets
            .iter()
            .map(|facet| facet & face)
            .filter(|&part| part != face && part.count_ones() as usize >= dimension)
            .collect();
        parts.sort_unstable();
        parts.dedup();
        parts
    }

    /// The corners of each facet as indices.
    pub fn facet_indices(&self) -> Vec<Vec<usize>> {
        self.facets
            .iter()
            .map(|&facet| indices(facet).collect())
            .collect()
    }
}

fn indices(mask: Mask) -> impl Iterator<Item = usize> {
    (0..COSPHERICAL_LIMIT).filter(move |i| mask >> i & 1 == 1)
}

/// Sorts by position, lexicographically in the caller's basis. There the vertices
/// have coordinates 0 <= x < 1, so shifts compare first.
fn sort_for_pulling<const D: usize>(
    corners: &mut [Corner<D>],
    predicates: &Predicates<D>,
) -> Result<(), DelaunayError> {
    let model = predicates.model;
    let mut keyed = Vec::with_capacity(corners.len());
    for corner in corners.iter() {
        keyed.push((model.original(corner)?, *corner));
    }
    keyed.sort_by(|(a, _), (b, _)| {
        let [x, y] = [a, b].map(|corner| &model.vertices[corner.vertex.index()]);
        (0..D)
            .map(|k| a.shift[k].cmp(&b.shift[k]).then_with(|| x[k].cmp(&y[k])))
            .find(|order| order.is_ne())
            .unwrap_or(Sign::Equal)
    });
    corners
        .iter_mut()
        .zip(keyed)
        .for_each(|(corner, (_, sorted))| *corner = sorted);
    Ok(())
}

/// The next D-subset of 0 … n-1 in lexicographic order.
fn next_subset<const D: usize>(chosen: &mut [usize; D], n: usize) -> bool {
    for k in (0..D).rev() {
        if chosen[k] < n - (D - k) {
            chosen[k] += 1;
            for later in k + 1..D {
                chosen[later] = chosen[later - 1] + 1;
            }
            return true;
        }
    }
    false
}
