//! Optima that follow by hand.

use crate::periodic::{catalogue, degrees};
use acutile_core::tiling::{Corner, Domain, Frame, Polytope, Tiling, match_facets};
use acutile_exact::number::Number;
use acutile_optimize::{Extreme, Goal, Keep, Options, optimize, reasons, value};
use malachite::Rational;

fn fraction(n: i64, d: i64) -> Number {
    Number::from(Rational::from_signeds(n, d))
}

/// bcc stretched along an axis by √u. With edges of the cell 1, 1 and √u the tetrahedra have squared ratios
/// (4 + u) / 4(2 + u), which falls, and (4 + u²) / 4(2 + u), which grows near u = 1. They agree for u = 1, so
/// the optimum is 5/12.
#[test]
fn stretched_bcc_relaxes_to_cubic() {
    let mut tiling = catalogue("bcc");
    let u = fraction(6, 5);
    let two = fraction(2, 1);
    let (long, near, far) = (&two + &u, &u - &two, -u.clone());
    tiling.frame.gram = [
        [long.clone(), near.clone(), far.clone()],
        [near, long.clone(), far.clone()],
        [far.clone(), far, long],
    ];
    let options = Options {
        goal: Goal::RadiusEdge,
        ..Options::default()
    };
    let outcome = optimize(&tiling, &options, &mut |_| true).expect("a start");
    assert!(outcome.is_better);
    assert_eq!(outcome.parameters, 1);
    let Some(Extreme::LargestRatio(ratio)) = value(outcome.proved.statements(), Goal::RadiusEdge)
    else {
        panic!("no ratio");
    };
    let best = Rational::from_signeds(5, 12);
    let (low, high) = ratio
        .square
        .enclosure(&Rational::from_signeds(1, 1_000_000_000));
    assert!(
        high >= best && low <= best + Rational::from_signeds(1, 100_000),
        "{low}"
    );
}

/// A regular tetrahedron cut into four from an inner vertex.
fn four(apex: [Number; 3]) -> Tiling<3> {
    let corners = [[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]];
    let corners = corners.map(|p| p.map(|x| fraction(x, 1)));
    let solid = Polytope {
        vertices: corners.iter().map(|p| p.to_vec()).collect(),
        faces: vec![vec![0, 1, 2], vec![0, 1, 3], vec![0, 2, 3], vec![1, 2, 3]],
    };
    let vertices: Vec<[Number; 3]> = corners.into_iter().chain([apex]).collect();
    let mut tiling = Tiling {
        frame: Frame::cubic().with_domain(Domain::Solid(solid)),
        vertices: vertices.into(),
        corners: [[0, 1, 2, 4], [0, 1, 3, 4], [0, 2, 3, 4], [1, 2, 3, 4]]
            .concat()
            .into_iter()
            .map(|v: u32| Corner::of(v))
            .collect(),
    };
    tiling.orient();
    tiling
}

/// Three angles at each inner edge add up to 360 degrees, so the largest is at least 120, and it is 120 at the
/// centre.
#[test]
fn an_inner_vertex_goes_to_the_centre() {
    let start = four([fraction(1, 5), fraction(1, 10), fraction(1, 20)]);
    let options = Options {
        keep: Keep::Lattice,
        ..Options::default()
    };
    let outcome = optimize(&start, &options, &mut |_| true).expect("a start");
    assert_eq!(outcome.parameters, 3);
    let reached = degrees(&outcome, Goal::MaxDihedral);
    assert!(
        reached >= 120 && reached < Rational::from_signeds(1_200_001, 10_000),
        "{reached}"
    );
    let why = reasons(&start, &match_facets(&start));
    assert_eq!(
        why.iter().map(|reason| reason.valence).collect::<Vec<_>>(),
        [3, 3, 3, 3]
    );
    assert!(why.iter().all(|reason| !reason.is_boundary));
}

/// At the centre all symmetries fix the vertex.
#[test]
fn a_full_symmetry_moves_nothing() {
    let start = four([Number::zero(), Number::zero(), Number::zero()]);
    let outcome = optimize(&start, &Options::default(), &mut |_| true).expect("a start");
    assert_eq!((outcome.parameters, outcome.symmetries), (0, 24));
    assert!(!outcome.is_better);
    let rotations = Options {
        keep: Keep::Rotations,
        ..Options::default()
    };
    let outcome = optimize(&start, &rotations, &mut |_| true).expect("a start");
    assert_eq!(outcome.symmetries, 12);
}

/// T_d: the identity fixes all of space, 3 half turns and 8 turns of order 3 fix an axis, 6 mirrors a plane,
/// and 6 elements of order 4 a point.
#[test]
fn a_subgroup_frees_parameters() {
    let start = four([Number::zero(), Number::zero(), Number::zero()]);
    let mut counts = std::collections::BTreeMap::new();
    for place in 0..24 {
        let options = Options {
            keep: Keep::Generated(vec![place]),
            ..Options::default()
        };
        let outcome = optimize(&start, &options, &mut |_| true).expect("a start");
        *counts
            .entry((outcome.symmetries, outcome.parameters))
            .or_insert(0) += 1;
    }
    let expected = [
        ((1, 3), 1),
        ((2, 1), 3),
        ((2, 2), 6),
        ((3, 1), 8),
        ((4, 0), 6),
    ];
    assert_eq!(counts.into_iter().collect::<Vec<_>>(), expected);
}
