//! The symmetry groups of known structures. Oracles: International Tables for
//! Crystallography A (orders of point groups) and the space groups of the
//! structures: A15 Pm-3n, C15 Fd-3m, sigma P4_2/mnm, C14 P6_3/mmc, C36 P6_3/mmc, mu R-3m, Z P6/mmm,
//! H Cmmm, bcc Im-3m.

use acutile_catalog as catalog;
use acutile_core::classify::{Isometry, Symmetry, generators};
use acutile_core::quality::squared_edges;
use acutile_core::tiling::{AnyTiling, Tiling, match_facets};
use acutile_exact::geometry::linear;

fn symmetry<const D: usize>(tiling: &Tiling<D>) -> Symmetry<D> {
    let edges: Vec<_> = tiling.indices().map(|s| squared_edges(tiling, s)).collect();
    Symmetry::of(tiling, &match_facets(tiling), &edges)
}

fn space(name: &str) -> Tiling<3> {
    match catalog::build(name).expect("a name of the catalogue") {
        AnyTiling::Space(tiling) => tiling,
        AnyTiling::Plane(_) => panic!("{name} is not in space"),
    }
}

#[test]
fn point_groups_have_the_orders_that_crystallographers_know() {
    let known = [
        ("a15", 48),
        ("a15-bcc", 48),
        ("c15", 48),
        ("bcc", 48),
        ("sigma", 16),
        ("z", 24),
        ("c14", 24),
        ("c36", 24),
        ("mu", 12),
        ("h", 8),
    ];
    for (name, order) in known {
        assert_eq!(symmetry(&space(name)).point_group_order(), order, "{name}");
    }
}

#[test]
fn a15_has_three_orbits_of_tetrahedra_and_two_of_vertices() {
    let symmetry = symmetry(&space("a15"));
    assert_eq!(symmetry.orbits(), 3);
    let twelve = |orbit: usize| symmetry.vertices.iter().filter(|&&o| o == orbit).count();
    let mut sizes = [twelve(0), twelve(1)];
    sizes.sort_unstable();
    // Two vertices of type Z12 and six of type Z14 in a cell.
    assert_eq!(sizes, [2, 6]);
    assert_eq!(symmetry.translations(), 1);
}

#[test]
fn one_tetrahedron_has_the_symmetries_of_its_shape() {
    assert_eq!(symmetry(&space("regular")).elements.len(), 24);
    // Three equal edges at a right-angled corner.
    assert_eq!(symmetry(&space("cube-corner")).elements.len(), 6);
}

/// The isometries keep the Gram matrix and permute the tiles.
fn check_elements<const D: usize>(tiling: &Tiling<D>) {
    let symmetry = symmetry(tiling);
    let gram = &tiling.frame.gram;
    for element in &symmetry.elements {
        for i in 0..D {
            for j in 0..D {
                let column = |k: usize| std::array::from_fn(|l| element.linear[l][k].clone());
                let product = linear::dot(&column(i), &linear::apply(gram, &column(j)));
                assert_eq!(product, gram[i][j]);
            }
        }
        check_permutes(tiling, element);
    }
}

/// The images of the tiles, up to lattice vectors, are the tiles: compared by sorted
/// corners, the first of which is moved into the cell.
fn check_permutes<const D: usize>(tiling: &Tiling<D>, element: &Isometry<D>) {
    let rank = tiling.frame.rank();
    let forms = |moved: bool| {
        let mut forms: Vec<_> = tiling
            .indices()
            .map(|simplex| {
                let mut points: Vec<_> = tiling
                    .simplex(simplex)
                    .iter()
                    .map(|corner| {
                        let x = tiling.position(corner);
                        let y = linear::apply(&element.linear, &x);
                        if moved {
                            std::array::from_fn(|k| &y[k] + &element.translation[k])
                        } else {
                            x
                        }
                    })
                    .collect();
                points.sort();
                let floor: [i64; D] =
                    std::array::from_fn(|k| (points[0][k].approximate() + 1e-9).floor() as i64);
                for point in &mut points {
                    for k in 0..rank {
                        point[k] = &point[k] - &tiling.frame.field.integer(floor[k]);
                    }
                }
                points
            })
            .collect();
        forms.sort();
        forms
    };
    assert_eq!(forms(true), forms(false));
}

#[test]
fn elements_are_isometries_that_permute_the_tiles() {
    for name in ["a15", "sigma", "icosahedral", "slab", "mu", "two-corners"] {
        check_elements(&space(name));
    }
    for name in ["equilateral", "triangle-tiling", "square-14", "square-8"] {
        match catalog::build(name).expect("a name of the catalogue") {
            AnyTiling::Plane(tiling) => check_elements(&tiling),
            AnyTiling::Space(_) => panic!("{name} is in the plane"),
        }
    }
}

#[test]
fn generators_generate() {
    let tiling = space("a15");
    let symmetry = symmetry(&tiling);
    let group = symmetry.keeping_lattice(3);
    assert_eq!(group.len(), 48, "the cubic lattice is invariant");
    let generators = generators(&group, 3);
    assert!((2..=5).contains(&generators.len()), "{}", generators.len());
}
