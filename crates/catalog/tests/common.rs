//! Constructions of space, and checks by other means than the recipes'.

use acutile_catalog::build;
use acutile_core::tiling::{AnyTiling, Tiling, match_facets};
use acutile_exact::geometry::{RingElement, Sign, Simplex, linear};
use acutile_exact::number::Number;
use malachite::Rational;

pub fn tiling(name: &str) -> Tiling<3> {
    match build(name).unwrap() {
        AnyTiling::Space(tiling) => tiling,
        AnyTiling::Plane(_) => panic!("{name} is plane"),
    }
}

/// Matched facets, positive orientation, and the volume of one cell.
pub fn check<const D: usize>(name: &str, tiling: &Tiling<D>) {
    assert!(match_facets(tiling).mismatches.is_empty(), "{name}");
    let mut volume = Number::zero();
    for simplex in tiling.simplices() {
        let corners: Vec<_> = simplex.iter().map(|c| tiling.position(c)).collect();
        let determinant = Simplex::new(&corners).determinant;
        assert_eq!(determinant.sign(), Sign::Greater, "{name}");
        volume = volume.plus(&determinant);
    }
    assert_eq!(
        volume,
        Number::from(Rational::from((1..=D).product::<usize>())),
        "{name}"
    );
}

/// The largest sign of a product of facet normals: `Less` if all angles are acute.
pub fn largest_angle(tiling: &Tiling<3>) -> Sign {
    let cogram = linear::cofactors(&tiling.frame.gram);
    let signs = tiling.simplices().flat_map(|simplex| {
        let corners: Vec<_> = simplex.iter().map(|c| tiling.position(c)).collect();
        let products = Simplex::new(&corners).normal_products(&cogram);
        products
            .pairs()
            .map(|(_, _, product)| product.sign())
            .collect::<Vec<_>>()
    });
    signs.max().unwrap()
}
