//! The special places of a square/triangle tiling of the plane, by kinds.
//!
//! An edge is even or odd by its direction in multiples of 30 degrees. The sides of a triangle are of one kind, and
//! neighbouring sides of a square of both (see `square_triangle`).

use super::CatalogError;
use super::plane_tiling::{Cyclotomic, POWERS, PlaneTiling, scaled, sum};
use super::square_triangle::lifted;
use acutile_exact::number::{Field, Number};
use malachite::Rational;

/// Places of a plane tiling in a basis of its lattice.
#[derive(Clone, Debug)]
pub struct Places {
    /// The field of all numbers.
    pub field: Field,
    /// The Gram matrix of the lattice.
    pub gram: [[Number; 2]; 2],
    /// The kinds that occur, by name.
    pub kinds: Vec<(&'static str, Vec<[Number; 2]>)>,
}

/// The kinds in order: vertices; middles of even and odd edges; centres of triangles with even and odd
/// sides; centres of squares. The last two are points a quarter of a side inside the even and the odd sides
/// of squares.
const KINDS: [&str; 8] = ["V", "E0", "E1", "T0", "T1", "S", "S0", "S1"];
const VERTEX: usize = 0;
const EDGE: usize = 1;
const TRIANGLE: usize = 3;
const SQUARE: usize = 5;
const INSIDE: usize = 6;

impl PlaneTiling {
    /// The special places, with sides of this length.
    ///
    /// # Errors
    /// Where the tiling is not one.
    pub fn places(&self, side: i64) -> Result<Places, CatalogError> {
        let mut lists: [Vec<(Cyclotomic, i64)>; 8] = Default::default();
        for (vertex, star) in self.vertices.iter().zip(&self.stars()?) {
            let corner = scaled(*vertex, 12);
            lists[VERTEX].push((corner, 0));
            for tile in star {
                let k = tile.direction;
                let parity = k % 2;
                let middle = sum(corner, scaled(POWERS[k], 6));
                // An edge has two ends, a triangle three corners, a square four: one of them has a small k.
                if k < 6 {
                    lists[EDGE + parity].push((middle, 0));
                }
                if tile.is_square() {
                    let across = POWERS[(k + 3) % 12];
                    lists[INSIDE + parity].push((sum(middle, scaled(across, 3)), 0));
                    if k < 3 {
                        lists[SQUARE].push((sum(middle, scaled(across, 6)), 0));
                    }
                } else if k < 4 {
                    let center = sum(scaled(POWERS[k], 4), scaled(POWERS[k + 2], 4));
                    lists[TRIANGLE + parity].push((sum(corner, center), 0));
                }
            }
        }
        let square = Rational::from(side * side);
        let all = lists.concat();
        let set = lifted(self, &square, 12, &all)?;
        let mut places = set.points.into_iter().map(|[x, y, _]| [x, y]);
        let kinds = KINDS.iter().zip(&lists).map(|(name, list)| {
            let own = places.by_ref().take(list.len()).collect::<Vec<_>>();
            (*name, own)
        });
        let kinds = kinds.filter(|(_, own)| !own.is_empty()).collect();
        let [[a, b, _], [c, d, _], _] = set.frame.gram;
        Ok(Places {
            field: set.frame.field,
            gram: [[a, b], [c, d]],
            kinds,
        })
    }
}
