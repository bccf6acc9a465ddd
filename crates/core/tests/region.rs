//! Meshes: what is an embedded triangulation is proved and verified, and nothing else.
//!
//! The oracle is a linear program for each pair of tetrahedra (`common::meeting`), or that a
//! part of an embedded triangulation is one.

use crate::meeting::{Point, meet_elsewhere};
use acutile_core::checker::{Defect, Findings, Options, Proof, examine};
use acutile_core::proved::{NotProved, prove};
use acutile_core::statement::Statement;
use acutile_core::tiling::{self, AnyTiling, CELL_LIMIT, Corner, Frame, Tiling, match_facets};
use acutile_core::transcribe::{Parts, to_certificate};
use acutile_exact::geometry::triangle::{Triangle, folded};
use acutile_io::import::{Content, read_native};
use acutile_kernel::{Limits, Refusal, Verified, verify};
use malachite::{Integer, Rational};
use proptest::prelude::*;

/// Points with integer coordinates, and tetrahedra.
#[derive(Clone, Debug)]
struct Mesh {
    points: Vec<Point>,
    tetrahedra: Vec<[usize; 4]>,
}

impl Mesh {
    /// Cubes with sides of length `side` at the corners, each cut into Kuhn's six tetrahedra.
    fn of_cubes(corners: &[Point], side: i64) -> Mesh {
        let mut mesh = Mesh {
            points: vec![],
            tetrahedra: vec![],
        };
        let orders = [
            [0, 1, 2],
            [1, 2, 0],
            [2, 0, 1],
            [0, 2, 1],
            [1, 0, 2],
            [2, 1, 0],
        ];
        for corner in corners {
            for (k, order) in orders.into_iter().enumerate() {
                let mut at = corner.map(|x| x * side);
                let mut tetrahedron = [mesh.index(at); 4];
                for (step, axis) in order.into_iter().enumerate() {
                    at[axis] += side;
                    tetrahedron[step + 1] = mesh.index(at);
                }
                if k >= 3 {
                    tetrahedron.swap(2, 3);
                }
                mesh.tetrahedra.push(tetrahedron);
            }
        }
        mesh
    }

    fn index(&mut self, point: Point) -> usize {
        let found = self.points.iter().position(|p| *p == point);
        found.unwrap_or_else(|| {
            self.points.push(point);
            self.points.len() - 1
        })
    }

    /// The chosen tetrahedra, with the vertices that they have.
    fn part(&self, chosen: impl Fn(usize) -> bool) -> Mesh {
        let mut part = Mesh {
            points: vec![],
            tetrahedra: vec![],
        };
        for (_, corners) in self
            .tetrahedra
            .iter()
            .enumerate()
            .filter(|(t, _)| chosen(*t))
        {
            let corners = corners.map(|v| part.index(self.points[v]));
            part.tetrahedra.push(corners);
        }
        part
    }

    fn volume(&self, t: usize) -> i64 {
        let [a, b, c, d] = self.tetrahedra[t].map(|v| self.points[v]);
        let edge = |p: Point| [p[0] - a[0], p[1] - a[1], p[2] - a[2]];
        let (b, c, d) = (edge(b), edge(c), edge(d));
        b[0] * (c[1] * d[2] - c[2] * d[1])
            + b[1] * (c[2] * d[0] - c[0] * d[2])
            + b[2] * (c[0] * d[1] - c[1] * d[0])
    }

    /// Positive tetrahedra of which any two meet in what their common vertices span.
    fn is_embedded(&self) -> bool {
        let n = self.tetrahedra.len();
        let places = |t: usize| self.tetrahedra[t].map(|v| self.points[v]);
        let meet_well = |s: usize, t: usize| {
            let shared = self.tetrahedra[s]
                .into_iter()
                .filter(|v| self.tetrahedra[t].contains(v));
            let common: Vec<Point> = shared.map(|v| self.points[v]).collect();
            !meet_elsewhere(&places(s), &places(t), &common)
        };
        (0..n).all(|t| self.volume(t) > 0) && (0..n).all(|t| (0..t).all(|s| meet_well(s, t)))
    }

    /// The certificate of the mesh, whatever it is: nothing is checked before the kernel.
    fn certificate(&self) -> Vec<u8> {
        let tiling = self.tiling();
        to_certificate(Parts {
            tiling: &tiling,
            matching: &match_facets(&tiling),
            statements: &[Statement::FaceToFaceTiling],
            sixes: None,
        })
    }

    fn verified(&self) -> Result<Verified, Refusal> {
        verify(&mut &self.certificate()[..], &Limits::DEFAULT)
    }

    fn tiling(&self) -> Tiling<3> {
        let frame = Frame::<3>::cubic().with_domain(tiling::Domain::Region(0));
        let integer = |x: i64| acutile_exact::number::Number::from(Rational::from(x));
        Tiling {
            frame,
            vertices: self.points.iter().map(|p| p.map(integer)).collect(),
            corners: self
                .tetrahedra
                .iter()
                .flatten()
                .map(|&v| Corner::of(v as u32))
                .collect(),
        }
    }

    fn proved(&self) -> Result<Proof<3>, Findings> {
        examine(&self.tiling(), &Options::default(), &|_| ())
    }
}

fn grid(n: i64) -> Vec<Point> {
    let axis = 0..n;
    let plane = axis.clone().flat_map(|x| axis.clone().map(move |y| (x, y)));
    plane
        .flat_map(|(x, y)| (0..n).map(move |z| [x, y, z]))
        .collect()
}

/// The verdicts of the kernel and of the prover are that of the oracle.
fn judge(mesh: &Mesh) -> Result<(), TestCaseError> {
    let expected = mesh.is_embedded();
    let verified = mesh.verified();
    prop_assert_eq!(verified.is_ok(), expected, "kernel: {:?}", verified);
    let proved = mesh.proved();
    prop_assert_eq!(proved.is_ok(), expected, "prover: {:?}", proved.map(|_| ()));
    Ok(())
}

fn tetrahedra(n: i64) -> impl Strategy<Value = [Point; 8]> {
    prop::array::uniform8(prop::array::uniform3(0..n))
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 400, ..ProptestConfig::default() })]

    /// Two tetrahedra with any number of common vertices, on a grid so small that every degenerate
    /// position is frequent.
    #[test]
    fn two_tetrahedra(points in tetrahedra(3), common in 0usize..4) {
        judge(&pair(points, common))?;
    }

    #[test]
    fn two_tetrahedra_on_a_larger_grid(points in tetrahedra(5), common in 0usize..4) {
        judge(&pair(points, common))?;
    }
}

/// Two tetrahedra, oriented if they can be; the second has the first vertices of the first.
fn pair(points: [Point; 8], common: usize) -> Mesh {
    let second = std::array::from_fn(|k| if k < common { k } else { k + 4 });
    let mut mesh = Mesh {
        points: points.to_vec(),
        tetrahedra: vec![[0, 1, 2, 3], second],
    };
    for t in 0..2 {
        if mesh.volume(t) < 0 {
            mesh.tetrahedra[t].swap(2, 3);
        }
    }
    // The vertices that are not used are moved out of the way of the indices.
    for v in (4..4 + common).rev() {
        mesh.points.remove(v);
    }
    for corner in &mut mesh.tetrahedra[1] {
        if *corner >= 4 {
            *corner -= common;
        }
    }
    mesh
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 60, ..ProptestConfig::default() })]

    /// Any part of an embedded triangulation is one: cavities, pieces, pinched vertices and edges.
    #[test]
    fn parts_of_a_block(bits in prop::collection::vec(any::<u8>(), 162), share in 1u8..8) {
        let block = Mesh::of_cubes(&grid(3), 1);
        let part = block.part(|t| bits[t] % 8 < share);
        prop_assume!(!part.tetrahedra.is_empty());
        let verified = part.verified();
        prop_assert!(verified.is_ok(), "{:?}", verified);
        prop_assert!(part.proved().is_ok());
    }

    /// The same for whole cubes, and with the vertices of the block shaken a little.
    #[test]
    fn parts_of_a_shaken_block(
        cubes in prop::collection::vec(any::<bool>(), 27),
        shakes in prop::collection::vec(prop::array::uniform3(-1i64..=1), 64),
    ) {
        let mut block = Mesh::of_cubes(&grid(3), 16);
        for (point, by) in block.points.iter_mut().zip(&shakes) {
            *point = [0, 1, 2].map(|k| point[k] + by[k]);
        }
        let part = block.part(|t| cubes[t / 6]);
        prop_assume!(!part.tetrahedra.is_empty());
        prop_assert!(part.verified().is_ok());
        prop_assert!(part.proved().is_ok());
    }

    /// Some tetrahedra of a few cubes, with some vertices moved: embedded or not, by the oracle.
    #[test]
    fn moved_vertices(
        keys in prop::collection::vec(any::<u8>(), 24),
        share in 1u8..7,
        moves in prop::collection::vec((any::<prop::sample::Index>(), prop::array::uniform3(-3i64..=3)), 1..4),
    ) {
        let block = Mesh::of_cubes(&[[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 1]], 2);
        let mut part = block.part(|t| keys[t] % 8 < share);
        prop_assume!(!part.tetrahedra.is_empty());
        for (index, by) in &moves {
            let v = index.index(part.points.len());
            part.points[v] = [0, 1, 2].map(|k| part.points[v][k] + by[k]);
        }
        for t in 0..part.tetrahedra.len() {
            if part.volume(t) < 0 && keys[t] % 2 == 0 {
                part.tetrahedra[t].swap(0, 1);
            }
        }
        judge(&part)?;
    }

    /// Two blocks without a common vertex, one moved: apart, touching, overlapping, one in a
    /// cavity of the other or in its inside.
    #[test]
    fn two_blocks(by in prop::array::uniform3(-3i64..9), size in 1i64..4, hollow: bool) {
        let around: Vec<Point> = grid(3).into_iter().filter(|c| !hollow || *c != [1, 1, 1]).collect();
        let mut mesh = Mesh::of_cubes(&around, 3);
        let n = mesh.points.len();
        let second = Mesh::of_cubes(&[[0, 0, 0]], size);
        mesh.points.extend(second.points.iter().map(|p| [0, 1, 2].map(|k| p[k] + by[k])));
        mesh.tetrahedra.extend(second.tetrahedra.iter().map(|t| t.map(|v| v + n)));
        let apart = (0..3).any(|k| by[k] + size < 0 || by[k] > 9);
        let in_the_cavity = hollow && (0..3).all(|k| by[k] > 3 && by[k] + size < 6);
        prop_assert_eq!(mesh.verified().is_ok(), apart || in_the_cavity);
        prop_assert_eq!(mesh.proved().is_ok(), apart || in_the_cavity);
    }
}

fn integers(point: &Point) -> [Integer; 3] {
    point.map(Integer::from)
}

/// All choices of k of the points, in order.
fn choices(points: &[Point], k: usize) -> Vec<Vec<Point>> {
    match (k, points.split_first()) {
        (0, _) => vec![vec![]],
        (_, None) => vec![],
        (_, Some((first, rest))) => {
            let with = choices(rest, k - 1)
                .into_iter()
                .map(|c| [vec![*first], c].concat());
            with.chain(choices(rest, k)).collect()
        }
    }
}

fn is_flat(triangle: &[Point]) -> bool {
    let points: Vec<[Integer; 3]> = triangle.iter().map(integers).collect();
    Triangle::new([&points[0], &points[1], &points[2]]).is_none()
}

/// The prover's predicate on every segment and triangle of the points, all
/// degenerate positions included; the point that it gives is in both.
fn segments_and_triangles(points: &[Point]) -> usize {
    let segments = choices(points, 2);
    let mut meetings = 0;
    for triangle in choices(points, 3).iter().filter(|t| !is_flat(t)) {
        let corners: Vec<[Integer; 3]> = triangle.iter().map(integers).collect();
        let exact = Triangle::new([&corners[0], &corners[1], &corners[2]]).unwrap();
        for segment in &segments {
            let [p, q] = [integers(&segment[0]), integers(&segment[1])];
            let answer = exact.meets_segment(&p, &q);
            assert_eq!(
                answer.is_some(),
                meet_elsewhere(segment, triangle, &[]),
                "{segment:?} {triangle:?}"
            );
            if let Some(point) = answer {
                meetings += 1;
                // Multiplied by the denominator, the point is one of the grid.
                let scale = i64::try_from(&point.denominator).unwrap();
                let place = point.numerators.map(|x| i64::try_from(&x).unwrap());
                let scaled = |points: &[Point]| -> Vec<Point> {
                    points.iter().map(|p| p.map(|x| x * scale)).collect()
                };
                assert!(
                    meet_elsewhere(&[place], &scaled(segment), &[]),
                    "{segment:?} {triangle:?}"
                );
                assert!(
                    meet_elsewhere(&[place], &scaled(triangle), &[]),
                    "{segment:?} {triangle:?}"
                );
            }
        }
    }
    meetings
}

#[test]
fn every_segment_and_triangle_of_a_cube() {
    assert!(segments_and_triangles(&grid(2)) > 0);
}

#[test]
fn every_segment_and_triangle_of_a_plane() {
    let plane: Vec<Point> = grid(3)
        .into_iter()
        .filter(|p| p[0] + p[1] + p[2] == 3)
        .collect();
    assert_eq!(plane.len(), 7);
    assert!(segments_and_triangles(&plane) > 0);
}

/// Triangles on a common edge: folded over it or not.
#[test]
fn every_two_triangles_on_an_edge() {
    let points = grid(2);
    let mut seen = [0, 0];
    for edge in choices(&points, 2) {
        let [b, c] = [integers(&edge[0]), integers(&edge[1])];
        let others: Vec<&Point> = points.iter().filter(|p| !edge.contains(p)).collect();
        for &p in &others {
            for &q in others.iter().filter(|q| **q != p) {
                let (first, second) = ([edge[0], edge[1], *p], [edge[0], edge[1], *q]);
                if is_flat(&first) || is_flat(&second) {
                    continue;
                }
                let answer = folded([&b, &c], &integers(p), &integers(q)).is_some();
                assert_eq!(
                    answer,
                    meet_elsewhere(&first, &second, &edge),
                    "{first:?} {second:?}"
                );
                seen[usize::from(answer)] += 1;
            }
        }
    }
    assert!(seen[0] > 0 && seen[1] > 0, "{seen:?}");
}

/// By hand: vertices and tetrahedra of Kuhn's block, and its boundary of 2 · 6 · n² triangles.
#[test]
fn the_boundary_is_counted() {
    for n in 1..4 {
        let verified = Mesh::of_cubes(&grid(n), 1).verified().unwrap();
        assert_eq!(verified.simplices as i64, 6 * n * n * n);
        assert_eq!(verified.vertices as i64, (n + 1) * (n + 1) * (n + 1));
        assert_eq!(verified.boundary_facets as i64, 12 * n * n);
    }
}

/// What is wrong is named, with the exact point.
#[test]
fn defects_of_a_region() {
    let mut mesh = Mesh::of_cubes(&[[0, 0, 0]], 4);
    mesh.points
        .extend([[1, 1, 2], [3, 1, 9], [1, 3, 9], [1, 1, 9]]);
    mesh.tetrahedra.push([8, 9, 10, 11]);
    assert!(mesh.volume(6) > 0);
    let findings = mesh.proved().unwrap_err();
    let codes: Vec<&str> = findings.counts().keys().copied().collect();
    // The corner (1, 1, 2) of the last tetrahedron is inside of the cube.
    assert_eq!(codes, ["overlap"]);
    let lines: Vec<String> = findings
        .kept()
        .iter()
        .map(|defect| {
            acutile_core::checker::describe::<3>(
                &acutile_core::checker::Names::of(&mesh.tiling()),
                defect,
            )
        })
        .collect();
    assert!(
        lines.iter().all(|line| line.contains("simplex 6 overlap")),
        "{lines:?}"
    );
    for defect in findings.kept() {
        let Defect::Overlap { point, .. } = defect else {
            panic!("{defect:?}");
        };
        // In the cube the tetrahedron has coordinates above 1, 1 and 2.
        let number = |n: i64| acutile_exact::number::Number::from(malachite::Rational::from(n));
        for (x, low) in point.iter().zip([1, 1, 2]) {
            assert!(number(low) < *x && *x < number(4), "{defect:?}");
        }
    }
}

/// Meshes of TetGen and Gmsh (tests/regions/make.py), with the counts that these tell.
#[test]
fn meshes_of_others() {
    for name in [
        "gmsh-torus",
        "gmsh-box-with-a-cavity",
        "tetgen-box-with-a-cavity",
    ] {
        let path = format!(
            "{}/tests/regions/{name}.json",
            concat!(env!("CARGO_MANIFEST_DIR"), "/../..")
        );
        let text = std::fs::read_to_string(path).unwrap();
        let file = read_native(&text).unwrap();
        let Content::Tiling(AnyTiling::Space(mut tiling)) = file.content else {
            panic!("{name} is a mesh of space");
        };
        tiling.orient();
        let proved = prove(&tiling, &Options::default(), &|_| ()).unwrap();
        let verified = proved.verified();
        let counts = format!(
            "{name}: {} points, {} tetrahedra, {} boundary triangles",
            verified.vertices, verified.simplices, verified.boundary_facets
        );
        assert!(text.contains(&counts), "{counts}");
    }
}

/// A layer with one small tetrahedron in each cell, `by` cells away from the origin.
fn layer(by: i64) -> Tiling<3> {
    let [low, high] = [format!("{by}"), format!("\"{by} + 1/2\"")];
    let text = format!(
        r#"{{"format": "acutile-tiling", "version": 1, "dimension": 3,
            "lattice": {{"vectors": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]}}, "domain": {{"region": 1}},
            "vertices": [[{low}, 0, 0], [{high}, 0, 0], [{low}, 1, 0], [{low}, 0, 1]],
            "simplices": [[0, 1, 2, 3]]}}"#
    );
    let Content::Tiling(AnyTiling::Space(tiling)) = read_native(&text).unwrap().content else {
        panic!("a tiling of space");
    };
    tiling
}

/// Beyond the limit of cells nothing is decided; it used to count as the cell at the origin.
#[test]
fn a_vertex_that_is_too_far_is_declined() {
    for by in [0, i64::from(CELL_LIMIT) - 1, 1 - i64::from(CELL_LIMIT)] {
        prove(&layer(by), &Options::default(), &|_| ()).unwrap();
    }
    for by in [1i64 << 29, 1 << 31, 1 << 40, -(1 << 31)] {
        match prove(&layer(by + by.signum()), &Options::default(), &|_| ()) {
            Err(NotProved::Declined(findings)) => {
                let counts: Vec<&str> = findings.counts().keys().copied().collect();
                assert_eq!(counts, ["vertex-far"]);
            }
            other => panic!("{by}: {other:?}"),
        }
    }
}

/// Two tetrahedra with coordinates of 61 bits. The second one points at the face x + y + z = L of the
/// first one: its apex has the sum L + d, and its other corners have larger sums. So they are
/// disjoint exactly for d > 0, which doubles cannot see.
#[test]
fn coordinates_of_61_bits() {
    let (l, a) = (1i64 << 60, 1i64 << 58);
    for d in [-1, 0, 1] {
        let apex = [a, a, l - 2 * a + d];
        let moved = |k: usize| {
            let mut point = apex;
            point[k] += 1000;
            point
        };
        let mesh = Mesh {
            points: vec![
                [0, 0, 0],
                [l, 0, 0],
                [0, l, 0],
                [0, 0, l],
                apex,
                moved(0),
                moved(1),
                moved(2),
            ],
            tetrahedra: vec![[0, 1, 2, 3], [4, 5, 6, 7]],
        };
        assert_eq!(mesh.proved().is_ok(), d > 0, "{d}");
        assert_eq!(mesh.verified().is_ok(), d > 0, "{d}");
    }
}
