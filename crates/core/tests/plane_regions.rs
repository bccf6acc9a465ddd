//! Regions of the plane of every rank, small enough that every degenerate position is frequent. The prover
//! and the kernel agree with an oracle that compares all pairs of triangles.

use crate::meeting::{Point, meet_elsewhere};
use acutile_core::checker::{Options, examine};
use acutile_core::statement::Statement;
use acutile_core::tiling::{Coordinates, Corner, Domain, Frame, Tiling, VertexId, match_facets};
use acutile_core::transcribe::{Parts, to_certificate};
use acutile_kernel::{Limits, verify};
use proptest::prelude::*;
use std::collections::BTreeSet;

/// Steps of the grid in a lattice step.
const CELL: i64 = 3;
/// Triangles reach over fewer cells.
const REACH: i32 = 4;

/// Triangles by their corners: a vertex and a shift.
#[derive(Clone, Debug)]
struct Region {
    rank: usize,
    points: Vec<[i64; 2]>,
    triangles: Vec<[Corner<2>; 3]>,
}

impl Region {
    /// Triangles between points of the grid, one vertex for each class of points.
    fn of_points(rank: usize, triangles: &[[[i64; 2]; 3]]) -> Region {
        let mut region = Region {
            rank,
            points: Vec::new(),
            triangles: Vec::new(),
        };
        for triangle in triangles {
            let corners = triangle.map(|point| region.corner(point));
            region.triangles.push(corners);
        }
        region
    }

    fn corner(&mut self, point: [i64; 2]) -> Corner<2> {
        let in_lattice = |k: usize| k < self.rank;
        let shift = [0, 1].map(|k| {
            if in_lattice(k) {
                point[k].div_euclid(CELL)
            } else {
                0
            }
        });
        let vertex = [0, 1].map(|k| point[k] - shift[k] * CELL);
        let found = self.points.iter().position(|other| *other == vertex);
        let index = found.unwrap_or_else(|| {
            self.points.push(vertex);
            self.points.len() - 1
        });
        Corner {
            vertex: VertexId::new(index as u32),
            shift: shift.map(|s| s as i32),
        }
    }

    fn position(&self, corner: &Corner<2>) -> Point {
        let at =
            |k: usize| self.points[corner.vertex.index()][k] + CELL * i64::from(corner.shift[k]);
        [at(0), at(1), 0]
    }

    fn area(&self, triangle: &[Corner<2>; 3]) -> i64 {
        let [a, b, c] = triangle.each_ref().map(|corner| self.position(corner));
        (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    }

    fn shifts(&self) -> Vec<[i32; 2]> {
        let range = |k: usize| if k < self.rank { -REACH..=REACH } else { 0..=0 };
        range(0)
            .flat_map(|x| range(1).map(move |y| [x, y]))
            .collect()
    }

    /// Positive triangles of which any two different ones, up to the lattice, meet in the hull of
    /// at most two common corners.
    fn is_embedded(&self) -> bool {
        let places = |t: &[Corner<2>; 3]| t.each_ref().map(|corner| self.position(corner));
        let meet_well = |s: &[Corner<2>; 3], t: &[Corner<2>; 3]| {
            let shared = s.iter().filter(|corner| t.contains(corner));
            let common: Vec<Point> = shared.map(|corner| self.position(corner)).collect();
            common.len() < 3 && !meet_elsewhere(&places(s), &places(t), &common)
        };
        let is_right = |(index, s): (usize, &[Corner<2>; 3])| {
            self.triangles.iter().enumerate().all(|(other, t)| {
                let shifts = self.shifts().into_iter();
                let mut others = shifts.filter(|by| (index, [0, 0]) != (other, *by));
                others.all(|by| meet_well(s, &t.map(|corner| corner.moved(by))))
            })
        };
        self.triangles.iter().all(|t| self.area(t) > 0)
            && self.triangles.iter().enumerate().all(is_right)
    }

    fn tiling(&self) -> Tiling<2> {
        let scaled = |point: &[i64; 2]| *point;
        Tiling {
            frame: Frame::<2>::cubic().with_domain(Domain::Region(self.rank)),
            vertices: Coordinates::from_integers(self.points.iter().map(scaled).collect(), CELL)
                .unwrap(),
            corners: self.triangles.concat(),
        }
    }
}

/// The verdicts of the prover and of the kernel are that of the oracle, if there is a boundary.
fn judge(region: &Region) -> Result<bool, TestCaseError> {
    let tiling = region.tiling();
    let matching = match_facets(&tiling);
    let has_boundary = matching.mismatches.iter().any(|m| m.uses.len() == 1);
    let expected = region.is_embedded() && has_boundary;
    let examined = examine(&tiling, &Options::default(), &|_| ());
    prop_assert_eq!(
        examined.is_ok(),
        expected,
        "prover: {:?}",
        examined.map(|_| ())
    );
    let certificate = to_certificate(Parts {
        tiling: &tiling,
        matching: &matching,
        statements: &[Statement::FaceToFaceTiling],
        sixes: None,
    });
    let verified = verify(&mut &certificate[..], &Limits::DEFAULT);
    prop_assert_eq!(
        verified.is_ok(),
        expected,
        "kernel: {:?}",
        verified.map(|_| ())
    );
    Ok(expected)
}

fn point() -> impl Strategy<Value = [i64; 2]> {
    [0..4i64, 0..4i64]
}

/// Oriented positively, most of the time.
fn triangle() -> impl Strategy<Value = [[i64; 2]; 3]> {
    ([point(), point(), point()], 0..8).prop_map(|([a, b, c], keep)| {
        let area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        if area < 0 && keep > 0 {
            [a, c, b]
        } else {
            [a, b, c]
        }
    })
}

/// The grid's unit squares, each cut by a diagonal; some of the triangles.
fn squares() -> impl Strategy<Value = Vec<[[i64; 2]; 3]>> {
    let square = (0..CELL, 0..CELL, any::<bool>(), 0..4u8);
    prop::collection::vec(square, 1..9).prop_map(|squares| {
        let mut seen = BTreeSet::new();
        let mut triangles = Vec::new();
        for (x, y, diagonal, parts) in squares {
            if !seen.insert((x, y)) {
                continue;
            }
            let [a, b, c, d] = [[x, y], [x + 1, y], [x + 1, y + 1], [x, y + 1]];
            let pair = if diagonal {
                [[a, b, c], [a, c, d]]
            } else {
                [[a, b, d], [b, c, d]]
            };
            let chosen = pair.into_iter().enumerate();
            triangles.extend(chosen.filter(|(k, _)| parts != *k as u8).map(|(_, t)| t));
        }
        triangles
    })
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 300, ..ProptestConfig::default() })]

    #[test]
    fn a_few_triangles(rank in 0..3usize, triangles in prop::collection::vec(triangle(), 1..5)) {
        judge(&Region::of_points(rank, &triangles))?;
    }

    /// Parts of a triangulation, with one triangle more.
    #[test]
    fn one_triangle_more(rank in 0..3usize, triangles in squares(), more in triangle()) {
        let mut triangles = triangles;
        triangles.push(more);
        judge(&Region::of_points(rank, &triangles))?;
    }

    #[test]
    fn parts_of_a_triangulation(rank in 0..3usize, triangles in squares()) {
        judge(&Region::of_points(rank, &triangles))?;
    }
}

/// A strip of two triangles whose period is twice the lattice's: every listed facet meets the
/// others well, and its own translate badly.
#[test]
fn strip_of_twice_the_period() {
    let strip = |length: i64| {
        let [v, w] = [[0, 0], [0, CELL]];
        let [v_next, w_next] = [[length, 0], [length, CELL]];
        Region::of_points(1, &[[v, v_next, w], [v_next, w_next, w]])
    };
    assert!(judge(&strip(CELL)).expect("they agree"));
    assert!(!judge(&strip(2 * CELL)).expect("they agree"));
}

/// A square in a square, with its boundary or without.
#[test]
fn a_hole_in_each_cell() {
    let all: Vec<[[i64; 2]; 3]> = (0..CELL * CELL)
        .flat_map(|n| {
            let (x, y) = (n % CELL, n / CELL);
            let [a, b, c, d] = [[x, y], [x + 1, y], [x + 1, y + 1], [x, y + 1]];
            [[a, b, c], [a, c, d]]
        })
        .collect();
    // Without a hole there is no boundary if the lattice has rank 2.
    for (rank, expected) in [(0, true), (1, true), (2, false)] {
        let answer = judge(&Region::of_points(rank, &all)).expect("they agree");
        assert_eq!(answer, expected, "{rank}");
        let with_hole = Region::of_points(rank, &all[2..]);
        assert!(judge(&with_hole).expect("they agree"), "{rank}");
    }
}
