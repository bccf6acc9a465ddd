//! The module `delaunay` against hand counts, a brute-force twin and its symmetries.

use acutile_core::checker::Options;
use acutile_core::delaunay::{Cell, DelaunayError, Ties, cells, triangulate};
use acutile_core::proved::prove;
use acutile_core::statement::{Requirement, Statement};
use acutile_core::tiling::{Corner, Facet, Frame, PointSet, Tiling, VertexId, match_facets};
use acutile_exact::geometry::{Sign, Simplex};
use acutile_exact::number::{Field, Number};
use malachite::{Integer, Rational};
use std::collections::{BTreeMap, BTreeSet};

fn q(numerator: i64, denominator: i64) -> Number {
    Number::from(Rational::from_signeds(numerator, denominator))
}

/// Points n_i / denominator in a lattice with an integer Gram matrix.
fn set<const D: usize>(gram: [[i64; D]; D], denominator: i64, points: &[[i64; D]]) -> PointSet<D> {
    let gram = gram.map(|row| row.map(|x| q(x, 1)));
    PointSet {
        frame: Frame::space(Field::rationals(), gram),
        points: points
            .iter()
            .map(|p| p.map(|x| q(x, denominator)))
            .collect(),
    }
}

const CUBIC: [[i64; 3]; 3] = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
const FCC: [[i64; 3]; 3] = [[2, 1, 1], [1, 2, 1], [1, 1, 2]];
const BCC: [[i64; 3]; 3] = [[3, -1, -1], [-1, 3, -1], [-1, -1, 3]];

/// The number of cells for each size. A size has the number of corners, and the number of corners of each
/// facet.
fn census<const D: usize>(set: &PointSet<D>) -> BTreeMap<(usize, Vec<usize>), usize> {
    let mut census = BTreeMap::new();
    for cell in cells(set).unwrap() {
        let mut facets: Vec<usize> = cell.facets.iter().map(Vec::len).collect();
        facets.sort_unstable();
        *census.entry((cell.corners.len(), facets)).or_insert(0) += 1;
    }
    census
}

/// The numbers of orbits of vertices, edges, …, simplices: faces are sets of corners up to a
/// common translation.
fn face_counts<const D: usize>(tiling: &Tiling<D>) -> Vec<usize> {
    let mut faces = vec![BTreeSet::new(); D + 1];
    for simplex in tiling.simplices() {
        for subset in 1u32..1 << (D + 1) {
            let face: Vec<_> = (0..=D)
                .filter(|i| subset >> i & 1 == 1)
                .map(|i| simplex[i])
                .collect();
            faces[face.len() - 1].insert(normal(face));
        }
    }
    faces.iter().map(BTreeSet::len).collect()
}

fn normal<const D: usize>(mut face: Vec<Corner<D>>) -> Vec<Corner<D>> {
    face.sort_unstable();
    let origin = face[0].shift;
    face.iter_mut()
        .for_each(|c| *c = c.moved(origin.map(|x| -x)));
    face
}

/// All conditions of a tiling by simplices, by other methods than those of the module.
fn check<const D: usize>(tiling: &Tiling<D>) {
    let matching = match_facets(tiling);
    assert!(matching.mismatches.is_empty());
    let mut volume = q(0, 1);
    for (s, simplex) in tiling.indices().zip(tiling.simplices()) {
        let corners: Vec<_> = simplex.iter().map(|c| tiling.position(c)).collect();
        let shape = Simplex::new(&corners);
        assert_eq!(shape.determinant.sign(), Sign::Greater);
        volume = &volume + &shape.determinant;
        for i in 0..=D {
            let mate = matching.mate(tiling, Facet::new(s, i)).unwrap();
            let other = tiling.simplex(mate.facet.simplex);
            let beyond = other[usize::from(mate.facet.opposite)].moved(mate.shift);
            let position = tiling.position(&beyond);
            let offset = std::array::from_fn(|k| &position[k] - &corners[0][k]);
            assert_ne!(shape.power(&tiling.frame.gram, &offset).sign(), Sign::Less);
        }
    }
    assert_eq!(volume, q((1..=D as i64).product(), 1));
    // The torus has Euler characteristic 0.
    let euler: i64 = face_counts(tiling)
        .iter()
        .enumerate()
        .map(|(k, &n)| if k % 2 == 0 { n as i64 } else { -(n as i64) })
        .sum();
    assert_eq!(euler, 0);
}

/// The points of A15 in quarters of its cubic cell.
const A15: [Vector; 8] = [
    [0, 0, 0],
    [2, 2, 2],
    [1, 0, 2],
    [3, 0, 2],
    [2, 1, 0],
    [2, 3, 0],
    [0, 2, 1],
    [0, 2, 3],
];

fn a15() -> PointSet<3> {
    set(CUBIC, 4, &A15)
}

/// 2 points with 12 neighbours and 6 with 14: 54 edges at 8 points, and by Euler's
/// characteristic 0 (with 2 t facets) t = e - v = 46.
#[test]
fn a15_has_46_tetrahedra() {
    let tiling = triangulate(&a15(), Ties::Refuse).unwrap();
    check(&tiling);
    assert_eq!(face_counts(&tiling), [8, 54, 92, 46]);
}

/// C15 in the primitive cell: of 6 points 4 have 12 neighbours and 2 have 16, so 40 edges
/// and 34 tetrahedra. Positions in the fcc basis (0,1,1)/2, (1,0,1)/2, (1,1,0)/2.
#[test]
fn c15_has_34_tetrahedra() {
    // (1/4,1/4,1/4) is (b1 + b2 + b3)/4; (5/8,5/8,5/8) is 5/8 of the same sum; the others
    // halve one coordinate: midpoints of the edges between its neighbours.
    let points = [
        [0, 0, 0],
        [2, 2, 2],
        [5, 5, 5],
        [9, 5, 5],
        [5, 9, 5],
        [5, 5, 9],
    ];
    let tiling = triangulate(&set(FCC, 8, &points), Ties::Refuse).unwrap();
    check(&tiling);
    assert_eq!(face_counts(&tiling), [6, 40, 68, 34]);
}

/// Every point of the bcc lattice has 14 neighbours: 7 edges, 6 tetrahedra.
#[test]
fn bcc_has_6_tetrahedra() {
    let tiling = triangulate(&set(BCC, 1, &[[0, 0, 0]]), Ties::Refuse).unwrap();
    check(&tiling);
    assert_eq!(face_counts(&tiling), [1, 7, 12, 6]);
}

#[test]
fn cubic_cell_is_a_cube() {
    let cubic = set(CUBIC, 1, &[[0, 0, 0]]);
    assert_eq!(census(&cubic), BTreeMap::from([((8, vec![4; 6]), 1)]));
    let Err(DelaunayError::Cospherical(sets)) = triangulate(&cubic, Ties::Refuse) else {
        panic!("the cube is not a simplex");
    };
    assert_eq!(sets.len(), 1);
    assert_eq!(sets[0].corners.len(), 8);
    assert_eq!(sets[0].center, vec![q(1, 2); 3]);
    assert_eq!(sets[0].squared_radius, q(3, 4));
    assert_eq!(sets[0].corners[7], (0, vec![1, 1, 1]));
}

/// Kuhn's tetrahedra are the paths 0, e_i, e_i + e_j, (1,1,1).
#[test]
fn pulling_the_cube_gives_kuhn() {
    let tiling = triangulate(&set(CUBIC, 1, &[[0, 0, 0]]), Ties::Pull).unwrap();
    check(&tiling);
    let found: BTreeSet<_> = tiling.simplices().map(|s| normal(s.to_vec())).collect();
    let mut kuhn = BTreeSet::new();
    for path in [
        [0, 1, 2],
        [0, 2, 1],
        [1, 0, 2],
        [1, 2, 0],
        [2, 0, 1],
        [2, 1, 0],
    ] {
        let mut corner = Corner::of(0);
        let mut corners = vec![corner];
        for axis in path {
            corner.shift[axis] += 1;
            corners.push(corner);
        }
        kuhn.insert(normal(corners));
    }
    assert_eq!(found, kuhn);
}

/// The fcc lattice: two tetrahedra and one octahedron to a point.
#[test]
fn fcc_cells_are_tetrahedra_and_octahedra() {
    let fcc = set(FCC, 1, &[[0, 0, 0]]);
    let expected = BTreeMap::from([((4, vec![3; 4]), 2), ((6, vec![3; 8]), 1)]);
    assert_eq!(census(&fcc), expected);
    let pulled = triangulate(&fcc, Ties::Pull).unwrap();
    check(&pulled);
    assert_eq!(pulled.len(), 6);
}

/// The hexagonal lattice has triangular prisms; without its central points, hexagonal
/// ones among triangular ones (the kagome prisms).
#[test]
fn hexagonal_prisms() {
    let hexagonal = [[2, -1, 0], [-1, 2, 0], [0, 0, 3]];
    let prism = (6, vec![3, 3, 4, 4, 4]);
    assert_eq!(
        census(&set(hexagonal, 1, &[[0, 0, 0]])),
        BTreeMap::from([(prism.clone(), 2)])
    );
    let kagome = set(hexagonal, 2, &[[1, 0, 0], [0, 1, 0], [1, 1, 0]]);
    let hexagon = (12, vec![4, 4, 4, 4, 4, 4, 6, 6]);
    assert_eq!(census(&kagome), BTreeMap::from([(prism, 2), (hexagon, 1)]));
    check(&triangulate(&kagome, Ties::Pull).unwrap());
}

#[test]
fn in_the_plane() {
    let equilateral = set([[2, 1], [1, 2]], 1, &[[0, 0]]);
    let tiling = triangulate(&equilateral, Ties::Refuse).unwrap();
    check(&tiling);
    assert_eq!(face_counts(&tiling), [1, 3, 2]);
    let square = set([[1, 0], [0, 1]], 1, &[[0, 0]]);
    assert_eq!(census(&square), BTreeMap::from([((4, vec![2; 4]), 1)]));
    check(&triangulate(&square, Ties::Pull).unwrap());
}

/// The regular icosahedron with its centre, in Q(sqrt 5), far from its translates: the 20
/// pyramids over its faces are cells.
#[test]
fn icosahedron_over_a_field_of_degree_two() {
    let coefficients = [-1, -1, 1].map(Integer::from);
    let (field, phi) =
        Field::adjoin_root(&coefficients, Rational::from(1), Rational::from(2)).unwrap();
    let (zero, one) = (q(0, 1), q(1, 1));
    let gram =
        std::array::from_fn(|i| std::array::from_fn(|j| if i == j { q(1, 1) } else { q(0, 1) }));
    let mut points = vec![[zero.clone(), zero.clone(), zero.clone()]];
    for signs in 0..4 {
        let x = if signs & 1 == 0 { one.clone() } else { -&one };
        let y = if signs & 2 == 0 { phi.clone() } else { -&phi };
        points.push([zero.clone(), x.clone(), y.clone()]);
        points.push([x.clone(), y.clone(), zero.clone()]);
        points.push([y, zero.clone(), x]);
    }
    let tenth = q(1, 10);
    let points = points
        .iter()
        .map(|p| std::array::from_fn(|k| &p[k] * &tenth))
        .collect();
    let set = PointSet {
        frame: Frame::space(field, gram),
        points,
    };
    let around = |cell: &&Cell<3>| {
        cell.is_simplex()
            && cell
                .corners
                .iter()
                .any(|corner| corner.vertex == VertexId::new(0))
    };
    assert_eq!(cells(&set).unwrap().iter().filter(around).count(), 20);
    check(&triangulate(&set, Ties::Pull).unwrap());
}

#[test]
fn errors() {
    let refused = |set: PointSet<3>| triangulate(&set, Ties::Pull).unwrap_err();
    assert!(matches!(refused(set(CUBIC, 1, &[])), DelaunayError::Empty));
    let twice = set(CUBIC, 2, &[[0, 0, 1], [1, 0, 0], [4, -6, 3]]);
    assert!(matches!(refused(twice), DelaunayError::Coincident(0, 2)));
    let flat = set([[1, 0, 0], [0, 1, 1], [0, 1, 1]], 1, &[[0, 0, 0]]);
    assert!(matches!(refused(flat), DelaunayError::NotPositiveDefinite));
    let lopsided = set([[1, 0, 0], [0, 1, 0], [0, 1, 3]], 1, &[[0, 0, 0]]);
    assert!(matches!(refused(lopsided), DelaunayError::NotSymmetric));
    let needle = set([[1, 0, 0], [0, 1, 0], [0, 0, 1 << 60]], 1, &[[0, 0, 0]]);
    assert!(matches!(refused(needle), DelaunayError::TooElongated));
    let skew = 1 << 30;
    let skewed = set(
        [[1, skew, 0], [skew, skew * skew + 1, 0], [0, 0, 1]],
        1,
        &[[0, 0, 0]],
    );
    assert!(matches!(refused(skewed), DelaunayError::TooSkewed));
}

// --- A twin: all (D + 1)-subsets of the points near a point, in machine integers ---

/// A generator of pseudo-random numbers (Knuth's MMIX).
struct Random(u64);

impl Random {
    /// From low to high, both possible.
    fn between(&mut self, low: i64, high: i64) -> i64 {
        self.0 = self
            .0
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        low + ((self.0 >> 33) as i64) % (high - low + 1)
    }

    /// A Gram matrix that is not far from diagonal.
    fn gram(&mut self) -> [[i64; 3]; 3] {
        loop {
            let [a, b, c] = [(); 3].map(|()| self.between(4, 9));
            let [d, e, f] = [(); 3].map(|()| self.between(-2, 2));
            let g = [[a, d, e], [d, b, f], [e, f, c]];
            if 3 * det(g) >= g[0][0] * g[1][1] * g[2][2] {
                return g;
            }
        }
    }

    /// Different points of the grid with this step, in the cell.
    fn points(&mut self, count: usize, denominator: i64) -> Vec<[i64; 3]> {
        let mut points = Vec::new();
        while points.len() < count {
            let point = std::array::from_fn(|_| self.between(0, denominator - 1));
            if !points.contains(&point) {
                points.push(point);
            }
        }
        points
    }

    /// A matrix of determinant 1 and its inverse.
    fn unimodular(&mut self, steps: usize, size: i64) -> ([[i64; 3]; 3], [[i64; 3]; 3]) {
        let (mut u, mut inverse) = (CUBIC, CUBIC);
        for _ in 0..steps {
            let k = self.between(0, 2) as usize;
            let j = (k + self.between(1, 2) as usize) % 3;
            let m = self.between(-size, size);
            for i in 0..3 {
                u[k][i] += m * u[j][i];
                inverse[i][j] -= m * inverse[i][k];
            }
        }
        (u, inverse)
    }
}

fn det(m: [[i64; 3]; 3]) -> i64 {
    let minor = |a: usize, b: usize| m[1][a] * m[2][b] - m[1][b] * m[2][a];
    m[0][0] * minor(1, 2) - m[0][1] * minor(0, 2) + m[0][2] * minor(0, 1)
}

fn times(x: [i64; 3], m: [[i64; 3]; 3]) -> [i64; 3] {
    std::array::from_fn(|j| (0..3).map(|i| x[i] * m[i][j]).sum())
}

type Vector = [i64; 3];

fn square(g: &[[i64; 3]; 3], x: Vector) -> i64 {
    times(x, *g).iter().zip(x).map(|(a, b)| a * b).sum()
}

/// All Delaunay cells as sets of corners. For every point it tries the quadruples of points within twice
/// the covering radius, which is at most half the root of the trace (Babai).
fn brute_force(
    gram: &[[i64; 3]; 3],
    denominator: i64,
    points: &[Vector],
) -> BTreeSet<Vec<Corner<3>>> {
    let mut found = BTreeSet::new();
    let reach = (0..3).map(|k| gram[k][k]).sum::<i64>() * denominator * denominator;
    for (v, origin) in (0u32..).zip(points) {
        let mut near: Vec<(i64, Vector, Corner<3>)> = Vec::new();
        for (w, point) in (0u32..).zip(points) {
            for index in 0..11 * 11 * 11 {
                let shift = [index % 11 - 5, index / 11 % 11 - 5, index / 121 - 5];
                let x: Vector = std::array::from_fn(|k| {
                    point[k] - origin[k] + denominator * i64::from(shift[k])
                });
                let square = square(gram, x);
                if 0 < square && square <= reach {
                    near.push((
                        square,
                        x,
                        Corner {
                            vertex: VertexId::new(w),
                            shift,
                        },
                    ));
                }
            }
        }
        near.sort_unstable();
        collect_cells(Corner::of(v), &near, &mut found);
    }
    found
}

/// The lifted determinant of four vectors; its sign, with that of the orientation, tells the
/// side of the circumsphere of 0, a, b, c on which x lies.
fn collect_cells(
    origin: Corner<3>,
    near: &[(i64, Vector, Corner<3>)],
    found: &mut BTreeSet<Vec<Corner<3>>>,
) {
    for (i, a) in near.iter().enumerate() {
        for (j, b) in near.iter().enumerate().take(i) {
            for c in near.iter().take(j) {
                let d = det([a.1, b.1, c.1]);
                if d == 0 {
                    continue;
                }
                let power = |x: &(i64, Vector, Corner<3>)| {
                    let wide = |p: i64, q: i64| i128::from(p) * i128::from(q);
                    d.signum() as i128
                        * (wide(x.0, d)
                            - wide(a.0, det([x.1, b.1, c.1]))
                            - wide(b.0, det([a.1, x.1, c.1]))
                            - wide(c.0, det([a.1, b.1, x.1])))
                };
                if near.iter().all(|x| power(x) >= 0) {
                    let on = near.iter().filter(|x| power(x) == 0).map(|x| x.2);
                    found.insert(normal(on.chain([origin]).collect()));
                }
            }
        }
    }
}

/// The cells that the module finds for the same points in the basis u · b, shuffled and moved by lattice
/// vectors. They are in terms of the given points and basis.
fn disguised(
    gram: &[[i64; 3]; 3],
    denominator: i64,
    points: &[Vector],
    random: &mut Random,
    size: i64,
) -> BTreeSet<Vec<Corner<3>>> {
    let (u, inverse) = random.unimodular(6, size);
    let skewed = std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            let image = times(u[i], *gram);
            (0..3).map(|k| image[k] * u[j][k]).sum()
        })
    });
    let mut order: Vec<usize> = (0..points.len()).collect();
    order.sort_by_cached_key(|_| random.between(0, 1000));
    let shown: Vec<Vector> = order
        .iter()
        .map(|&i| {
            let far = random.between(0, 1) * random.between(-1_000_000_000, 1_000_000_000);
            times(points[i].map(|x| x + far * denominator), inverse)
        })
        .collect();
    let back = |corner: &Corner<3>| {
        let index = order[corner.vertex.index()];
        let x: Vector = std::array::from_fn(|k| {
            shown[corner.vertex.index()][k].rem_euclid(denominator)
                + denominator * i64::from(corner.shift[k])
        });
        let position = times(x, u);
        let shift = std::array::from_fn(|k| {
            let moved = position[k] - points[index][k];
            assert_eq!(moved % denominator, 0);
            (moved / denominator) as i32
        });
        Corner {
            vertex: VertexId::at(index),
            shift,
        }
    };
    let cells = cells(&set(skewed, denominator, &shown)).unwrap();
    let count = cells.len();
    let told: BTreeSet<_> = cells
        .iter()
        .map(|cell| normal(cell.corners.iter().map(back).collect()))
        .collect();
    assert_eq!(told.len(), count);
    told
}

#[test]
fn agrees_with_brute_force() {
    let mut random = Random(2024);
    for round in 0..48 {
        let gram = random.gram();
        let count = 1 + round % 5;
        // Few grid points make many cospherical sets, many make none.
        let denominator = [2, 3, 4, 7, 60, 1000][round % 6];
        let points = random.points(count, denominator);
        let expected = brute_force(&gram, denominator, &points);
        for size in [0, 1, 9] {
            let found = disguised(&gram, denominator, &points, &mut random, size);
            assert_eq!(
                found, expected,
                "round {round}: {gram:?} {points:?}/{denominator}"
            );
        }
    }
}

/// Sets that are too large for the twin. A basis of the same lattice, sheared by up to 10 six times over,
/// gives the same cells. Doubles prove most of them for random points, some in a triclinic lattice, and
/// none in a grid.
#[test]
fn a_change_of_basis_changes_nothing() {
    let mut random = Random(31);
    let triclinic = [[100, 23, -17], [23, 121, 35], [-17, 35, 81]];
    let flat = [[1, 0, 0], [0, 2, 0], [0, 0, 300]];
    for (gram, denominator) in [
        (CUBIC, 1 << 20),
        (triclinic, 1 << 10),
        (triclinic, 8),
        (flat, 1 << 20),
        (CUBIC, 12),
    ] {
        let points = random.points(250, denominator);
        let expected = disguised(&gram, denominator, &points, &mut random, 0);
        for size in [5, 10] {
            let found = disguised(&gram, denominator, &points, &mut random, size);
            assert!(found == expected, "{gram:?} in steps of 1/{denominator}");
        }
    }
}

/// The shears of the cubic lattice by 5 and by 10, and a triclinic lattice. The kernel confirms from the
/// certificate's bytes that the tiling is the Delaunay one.
#[test]
fn the_kernel_confirms_skewed_triangulations() {
    let mut random = Random(8);
    let by_5 = [[1, 5, 0], [5, 26, 0], [0, 0, 1]];
    let by_10 = [[1, 10, 10], [10, 101, 110], [10, 110, 201]];
    let triclinic = [[100, 23, -17], [23, 121, 35], [-17, 35, 81]];
    for gram in [CUBIC, by_5, by_10, triclinic] {
        let points = random.points(60, 1 << 16);
        let tiling = triangulate(&set(gram, 1 << 16, &points), Ties::Refuse).unwrap();
        check(&tiling);
        let options = Options {
            required: vec![Requirement::Delaunay],
            ..Options::default()
        };
        let proved = prove(&tiling, &options, &|_| ()).unwrap();
        let claimed = proved.statements();
        assert!(claimed.contains(&Statement::Delaunay), "{claimed:?}");
    }
}

#[test]
fn very_skewed_lattices() {
    // The rows (1,0,0), (1000,1,0), (12345,678,1).
    let gram = [
        [1, 1000, 12345],
        [1000, 1000001, 12345678],
        [12345, 12345678, 152858710],
    ];
    let expected = BTreeMap::from([((8, vec![4; 6]), 1)]);
    assert_eq!(census(&set(gram, 1, &[[0, 0, 0]])), expected);
    check(&triangulate(&set(gram, 1, &[[7, -123456789, 3]]), Ties::Pull).unwrap());
}

/// Huge and tiny cells give the same triangulation.
#[test]
fn scaling_changes_nothing() {
    let expected = triangulate(&a15(), Ties::Refuse).unwrap();
    for power in [-300i64, -40, 40, 300] {
        let mut set = a15();
        let scale = Number::from(Rational::from(1) << power);
        for row in &mut set.frame.gram {
            row.iter_mut().for_each(|x| *x = &*x * &scale);
        }
        assert_eq!(
            triangulate(&set, Ties::Refuse).unwrap().corners,
            expected.corners
        );
    }
}

fn random_set(count: usize, bits: u32) -> PointSet<3> {
    let mut random = Random(u64::from(bits));
    let points: Vec<Vector> = (0..count)
        .map(|_| std::array::from_fn(|_| random.between(0, (1 << bits) - 1)))
        .collect();
    set(CUBIC, 1 << bits, &points)
}

#[test]
fn a_thousand_random_points() {
    let tiling = triangulate(&random_set(1000, 28), Ties::Refuse).unwrap();
    check(&tiling);
    assert_eq!(face_counts(&tiling)[0], 1000);
}

/// Points of a fine grid moved by less than doubles can tell: nearly everything is nearly
/// cospherical, and the exact predicates decide.
#[test]
fn almost_cospherical() {
    let mut random = Random(77);
    let fine = 1i64 << 58;
    let points: Vec<Vector> = (0..64)
        .map(|i| [i % 4, i / 4 % 4, i / 16].map(|x| x * (fine / 4) + random.between(0, 3)))
        .collect();
    let tiling = triangulate(&set(CUBIC, fine, &points), Ties::Pull).unwrap();
    check(&tiling);
    assert!(tiling.len() >= 5 * 64);
}

/// Dense clusters in a wide cell.
#[test]
fn clusters() {
    let mut random = Random(5);
    let fine = 1i64 << 40;
    let points: Vec<Vector> = (0..600)
        .map(|i| {
            let center = (i % 3) * (fine / 3);
            std::array::from_fn(|_| center + random.between(0, 1 << (8 + 8 * (i % 3))))
        })
        .collect();
    check(&triangulate(&set(CUBIC, fine, &points), Ties::Pull).unwrap());
}

/// n³ copies of the cell of A15.
fn a15_supercell(n: i64) -> PointSet<3> {
    let copies = (0..n * n * n).map(|i| [i % n, i / n % n, i / n / n]);
    let points: Vec<Vector> = copies
        .flat_map(|copy| A15.map(|p: Vector| std::array::from_fn(|k| p[k] + 4 * copy[k])))
        .collect();
    set(CUBIC, 4 * n, &points)
}

#[test]
fn supercells_have_as_many_times_more_tetrahedra() {
    let tiling = triangulate(&a15_supercell(3), Ties::Refuse).unwrap();
    assert_eq!(face_counts(&tiling), [8 * 27, 54 * 27, 92 * 27, 46 * 27]);
    let grid: Vec<Vector> = (0..64).map(|i| [i % 4, i / 4 % 4, i / 16]).collect();
    let grid = set(CUBIC, 4, &grid);
    assert_eq!(census(&grid), BTreeMap::from([((8, vec![4; 6]), 64)]));
    let pulled = triangulate(&grid, Ties::Pull).unwrap();
    check(&pulled);
    assert_eq!(pulled.len(), 6 * 64);
}
