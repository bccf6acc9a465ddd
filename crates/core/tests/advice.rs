//! Advice about defects: planted defects whose cure is known beforehand.

use acutile_catalog::build;
use acutile_core::advice::{Advice, Adviser, common_point, motion};
use acutile_core::checker::{Defect, Options, examine};
use acutile_core::tiling::{AnyTiling, Corner, Facet, Frame, SimplexId, Tiling, VertexId};
use acutile_exact::geometry::{Sign, Simplex, linear};
use acutile_exact::number::{Number, parse_rational};
use malachite::Rational;
use std::collections::BTreeSet;

fn a15() -> Tiling<3> {
    match build("a15").unwrap() {
        AnyTiling::Space(tiling) => tiling,
        AnyTiling::Plane(_) => panic!("a15 is in space"),
    }
}

fn number(text: &str) -> Number {
    Number::from(parse_rational(text).unwrap())
}

fn point(texts: [&str; 3]) -> [Number; 3] {
    texts.map(number)
}

fn defects(tiling: &Tiling<3>) -> Vec<Defect> {
    let refutation = examine(tiling, &Options::default(), &|_| {}).unwrap_err();
    refutation.kept().to_vec()
}

fn advice(tiling: &Tiling<3>) -> Vec<Advice<3>> {
    let adviser = Adviser::new(tiling);
    let defects = defects(tiling);
    defects.iter().flat_map(|d| adviser.advice(d)).collect()
}

/// Up to a common translation.
fn as_set(corners: &[Corner<3>]) -> BTreeSet<Corner<3>> {
    let least = corners.iter().min().unwrap().shift;
    corners.iter().map(|c| c.moved(least.map(|s| -s))).collect()
}

#[test]
fn a_removed_tetrahedron_is_named() {
    let mut tiling = a15();
    let removed: Vec<Corner<3>> = tiling.corners.drain(20..24).collect();
    let missing: Vec<Vec<Corner<3>>> = advice(&tiling)
        .into_iter()
        .filter_map(|advice| match advice {
            Advice::Hole(hole) => hole.missing,
            _ => None,
        })
        .collect();
    assert_eq!(missing.len(), 4, "one for each facet of the hole");
    for corners in missing {
        assert_eq!(as_set(&corners), as_set(&removed));
        let points: Vec<[Number; 3]> = corners.iter().map(|c| tiling.position(c)).collect();
        assert_eq!(Simplex::new(&points).determinant.sign(), Sign::Greater);
    }
}

#[test]
fn two_neighbours_removed_are_a_hole_of_six_facets() {
    let mut tiling = a15();
    let matching = acutile_core::tiling::match_facets(&tiling);
    let neighbour = matching
        .neighbour(Facet::new(SimplexId::new(0), 0))
        .unwrap()
        .simplex
        .index();
    tiling.corners.drain(4 * neighbour..4 * neighbour + 4);
    tiling.corners.drain(0..4);
    let holes: Vec<(usize, bool)> = advice(&tiling)
        .iter()
        .filter_map(|advice| match advice {
            Advice::Hole(hole) => Some((hole.facets.len(), hole.missing.is_some())),
            _ => None,
        })
        .collect();
    assert_eq!(holes, vec![(6, false); 6]);
}

/// One corner of one tetrahedron gets a vertex of its own, which is off by 1/1000 in x. Three of its facets
/// no longer match. They miss by exactly that times the lattice constant, 4.
#[test]
fn a_split_vertex_is_found_with_its_distance() {
    for (offset, square) in [("1/1000", "16/1000000"), ("0", "0")] {
        let mut tiling = a15();
        let corner = tiling.corners[0];
        let mut position = tiling.position(&Corner::of(corner.vertex));
        position[0] = &position[0] + &number(offset);
        let new = tiling.vertices.len() as u32;
        let mut vertices = tiling.vertices.to_numbers();
        vertices.push(position);
        tiling.vertices = vertices.into();
        tiling.corners[0].vertex = VertexId::new(new);
        let squares: Vec<Number> = advice(&tiling)
            .into_iter()
            .filter_map(|advice| match advice {
                Advice::Near(near) => Some(near.squared_distance),
                _ => None,
            })
            .collect();
        assert_eq!(
            squares,
            vec![number(square); 6],
            "three facets and three mates"
        );
    }
}

#[test]
fn a_double_cover_has_a_point_in_two_tetrahedra() {
    let mut tiling = a15();
    let (vertices, corners) = (tiling.vertices.to_numbers(), tiling.corners.clone());
    let shifted = vertices.iter().map(|v| {
        let [x, y, z] = v;
        [x + &number("1/7"), y + &number("1/5"), z + &number("1/3")]
    });
    tiling.vertices = vertices.iter().cloned().chain(shifted).collect();
    let second = corners.iter().map(|c| Corner {
        vertex: VertexId::at(c.vertex.index() + vertices.len()),
        ..*c
    });
    tiling.corners.extend(second);
    let advice = advice(&tiling);
    assert!(advice.contains(&Advice::Covered { ratio: number("2") }));
    let mut overlaps = advice.iter().filter_map(|advice| match advice {
        Advice::Overlap(overlap) => Some(overlap),
        _ => None,
    });
    let overlap = overlaps.next_back().expect("an overlapping pair");
    let (s, t) = overlap.simplices;
    assert_ne!(s, t);
    for (index, shift) in [(s, [0; 3]), (t, overlap.shift)] {
        assert!(is_inside(&tiling, index, shift, &overlap.point));
    }
}

/// By four determinants, each with one corner replaced by the point.
fn is_inside(tiling: &Tiling<3>, index: SimplexId, shift: [i32; 3], point: &[Number; 3]) -> bool {
    let corners = tiling.simplex(index).iter();
    let corners: Vec<[Number; 3]> = corners.map(|c| tiling.position(&c.moved(shift))).collect();
    (0..4).all(|k| {
        let mut replaced = corners.clone();
        replaced[k] = point.clone();
        let rows = [1, 2, 3].map(|i| linear::subtract(&replaced[i], &replaced[0]));
        linear::determinant(&rows).sign() == Sign::Greater
    })
}

#[test]
fn tetrahedra_that_touch_have_no_common_inner_point() {
    let base = [["0", "0", "0"], ["1", "0", "0"], ["0", "1", "0"]].map(point);
    let with = |apex: [&str; 3]| [base.to_vec(), vec![point(apex)]].concat();
    let up = with(["0", "0", "1"]);
    assert_eq!(common_point(&up, &with(["0", "0", "-1"])), None, "a facet");
    let opposite: Vec<[Number; 3]> = up.iter().map(|p| p.clone().map(|x| -x)).collect();
    assert_eq!(common_point(&up, &opposite), None, "a corner");
    assert!(common_point(&up, &with(["5", "5", "1/100"])).is_some());
    assert!(common_point(&up, &up).is_some());
    // A small one inside, and a bar through it that has no corner in it.
    let half = number("1/8");
    let small: Vec<[Number; 3]> = up
        .iter()
        .map(|p| p.clone().map(|x| &(&x * &half) + &half))
        .collect();
    assert!(common_point(&up, &small).is_some());
    let bar = [
        ["-9", "1/5", "1/5"],
        ["9", "1/5", "1/5"],
        ["9", "1/4", "1/5"],
        ["9", "1/5", "1/4"],
    ];
    assert!(common_point(&up, &bar.map(point)).is_some());
}

/// One tetrahedron alone, in the cubic frame. Its neighbours do not matter here.
fn alone(corners: [[&str; 3]; 4]) -> Tiling<3> {
    let mut tiling = Tiling {
        frame: Frame::cubic(),
        vertices: corners.map(point).to_vec().into(),
        corners: (0..4).map(Corner::of).collect(),
    };
    tiling.orient();
    tiling
}

/// The regular tetrahedron whose apex is lowered to the centre. On the axis the angles at the
/// apex are right angles at (1/3, 1/3, 1/3), a distance of 1/√3 = 0.57735 away.
#[test]
fn a_low_apex_must_rise() {
    let tiling = alone([
        ["0", "0", "0"],
        ["1", "-1", "-1"],
        ["-1", "1", "-1"],
        ["-1", "-1", "1"],
    ]);
    let motion = motion(&tiling, SimplexId::new(0)).expect("the base is acute");
    assert!(motion.distance <= Rational::from_signeds(5774, 10000));
    let mut moved = tiling.clone();
    let mut vertices = moved.vertices.to_numbers();
    vertices[motion.corner.vertex.index()] = motion.target.clone();
    moved.vertices = vertices.into();
    let shape = moved.shape(SimplexId::new(0));
    assert_eq!(shape.determinant.sign(), Sign::Greater);
    let products = shape.normal_products(&linear::cofactors(&moved.frame.gram));
    assert!(
        products
            .pairs()
            .all(|(_, _, product)| product.sign() == Sign::Less)
    );
}

/// All four facets of the path simplex are right triangles.
#[test]
fn no_corner_of_the_path_simplex_can_mend_it() {
    let tiling = alone([
        ["0", "0", "0"],
        ["1", "0", "0"],
        ["1", "1", "0"],
        ["1", "1", "1"],
    ]);
    let angle = acutile_core::checker::Angle {
        simplex: SimplexId::new(0),
        facets: (0, 1),
        product: number("0"),
        degrees: (Rational::from(90), Rational::from(90)),
    };
    let advice = Adviser::new(&tiling).advice(&Defect::RightAngle { angle });
    assert_eq!(
        advice,
        [Advice::NoMotion {
            simplex: SimplexId::new(0)
        }]
    );
}
