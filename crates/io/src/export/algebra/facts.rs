//! The facts that the files assert of a tiling, computed by the prover.

use acutile_core::quality::{Shape, kinds, shapes};
use acutile_core::tiling::Tiling;
use acutile_exact::geometry::{Sign, linear};
use acutile_exact::number::Number;

/// The facts that the systems compute again.
pub struct Facts {
    /// The sum of the absolute determinants of all simplices.
    pub total: Number,
    /// The congruence class of each simplex.
    pub kinds: Vec<usize>,
    pub classes: Vec<Class>,
}

/// A congruence class.
pub struct Class {
    pub squared_edges: Vec<Number>,
    /// The numbers of acute, right and obtuse dihedral angles.
    pub angles: [usize; 3],
}

impl Facts {
    pub fn of<const D: usize>(tiling: &Tiling<D>) -> Facts {
        let shapes = shapes(tiling);
        let sizes = tiling
            .indices()
            .map(|simplex| tiling.shape(simplex).determinant.abs());
        Facts {
            total: sizes.fold(Number::zero(), |sum, size| &sum + &size),
            kinds: kinds(&shapes, tiling.len()),
            classes: shapes
                .into_iter()
                .map(|shape| class(tiling, shape))
                .collect(),
        }
    }
}

fn class<const D: usize>(tiling: &Tiling<D>, shape: Shape) -> Class {
    let cogram = linear::cofactors(&tiling.frame.gram);
    let products = tiling.shape(shape.members[0]).normal_products(&cogram);
    let mut angles = [0; 3];
    products.for_pairs(|_, _, product| {
        // A negative product of inward normals is an acute angle.
        angles[match product.sign() {
            Sign::Less => 0,
            Sign::Equal => 1,
            Sign::Greater => 2,
        }] += 1;
    });
    Class {
        squared_edges: shape.squared_edges,
        angles,
    }
}
