//! Conditions X and W against an exact oracle: linear programming over all pairs.
#![allow(clippy::indexing_slicing, clippy::as_conversions, clippy::unwrap_used)]

use super::oracle::meet_elsewhere;
use crate::cbor::Cbor;
use crate::claim::Field;
use crate::limits::{Limits, Work};
use crate::refusal::Code;
use crate::region::Region;
use crate::ring::Exact;
use crate::root::Root;
use crate::row::{Corner, Row, Shape};
use crate::vertices::Vertices;
use num_bigint::BigInt;
use std::collections::BTreeMap;
use std::rc::Rc;

type Point = [i64; 3];

/// The numbers x + y a of the coordinates x. The geometry is the same for all positive x + y a.
#[derive(Clone, Copy)]
enum Scale {
    Rational(i64),
    /// Over Q(√2).
    Root(i64, i64),
}

#[derive(Clone, Debug)]
struct Case {
    dimension: usize,
    rank: usize,
    denominator: i64,
    vertices: Vec<Point>,
    /// In the plane the fourth corner is a default.
    rows: Vec<[Corner; 4]>,
}

fn head(bytes: &mut Vec<u8>, kind: u8, n: u64) {
    let lengths: &[(u64, u8, usize)] =
        &[(24, n as u8, 0), (1 << 8, 24, 1), (1 << 16, 25, 2), (1 << 32, 26, 4), (u64::MAX, 27, 8)];
    let &(_, info, length) = lengths.iter().find(|(end, ..)| n < *end).unwrap();
    bytes.push(kind << 5 | info);
    bytes.extend(&n.to_be_bytes()[8 - length..]);
}

fn integer(bytes: &mut Vec<u8>, x: i64) {
    if x < 0 { head(bytes, 1, !x as u64) } else { head(bytes, 0, x as u64) }
}

/// The verdict on these boundary facets and these rows.
fn verdict<const N: usize>(case: &Case, facets: &[[Corner; 3]], scale: Scale, limits: &Limits) -> Result<(), Code> {
    let (factor, field) = match scale {
        Scale::Rational(x) => (vec![x], Field { polynomial: [0, 1].map(BigInt::from).to_vec(), root: None }),
        Scale::Root(x, y) => {
            let (polynomial, root) = ([-2, 0, 1].map(BigInt::from).to_vec(), Some([1, 2, 1].map(BigInt::from)));
            (vec![x, y], Field { polynomial, root })
        }
    };
    // Over Q(√2) the denominator has no factor, so that the lattice is scaled the other way:
    // points stay the same only if the rank is zero.
    let denominator = if N == 1 { case.denominator * factor[0] } else { case.denominator };
    let mut bytes = Vec::new();
    integer(&mut bytes, denominator);
    // An additional vertex makes the coordinates primitive.
    head(&mut bytes, 4, case.vertices.len() as u64 + 1);
    for (k, vertex) in case.vertices.iter().chain([&[1, 0, 0]]).enumerate() {
        head(&mut bytes, 4, case.dimension as u64);
        for x in &vertex[..case.dimension] {
            if N > 1 {
                head(&mut bytes, 4, factor.len() as u64);
            }
            for c in &factor {
                let is_unit = k == case.vertices.len();
                integer(&mut bytes, if is_unit { *x } else { x * c });
            }
        }
    }
    let work = Rc::new(Work::new(limits.work));
    let root = Rc::new(Root::new(&field, &work).unwrap());
    let rings: (_, Exact<BigInt, N>) = (Exact::new(&root, &work).ok(), Exact::new(&root, &work).unwrap());
    let mut input = &bytes[..];
    let mut cbor = Cbor::new(&mut input, limits, &work);
    let mut vertices = Vertices::new(case.dimension, factor.len());
    vertices.read_denominator(&mut cbor).unwrap();
    for _ in 0..cbor.array().unwrap() {
        vertices.read(&mut cbor).unwrap();
    }
    vertices.check_lowest(cbor.place()).unwrap();
    let (dimension, rank) = (case.dimension, case.rank);
    let shape = Shape { dimension, rank, vertices: vertices.count, has_sixes: false };
    let check = move || {
        let region = Region::new(facets.to_vec(), shape, &vertices, rings)?;
        for (simplex, &corners) in (0..).zip(&case.rows) {
            let row = Row { corners, sorted: corners, is_odd: false, sixes: 0 };
            region.check_row(&row, &vertices, simplex)?;
        }
        Ok(())
    };
    check().map_err(|stop: crate::refusal::Stop| stop.refusal().code)
}

fn corner(vertex: usize) -> Corner {
    Corner { vertex: vertex as u32, shift: [0; 3] }
}

impl Case {
    fn new(dimension: usize, rank: usize, denominator: i64) -> Case {
        Case { dimension, rank, denominator, vertices: Vec::new(), rows: Vec::new() }
    }

    /// Times the denominator.
    fn place(&self, corner: Corner) -> Point {
        let mut point = self.vertices[corner.vertex as usize];
        for (x, shift) in point.iter_mut().zip(corner.shift) {
            *x += i64::from(shift) * self.denominator;
        }
        point
    }

    /// The facets of simplices that have no mate, as the format lists them.
    fn boundary(&self) -> Vec<[Corner; 3]> {
        let mut open = BTreeMap::new();
        for &[a, b, c, d] in &self.rows {
            let facets = if self.dimension == 3 {
                vec![vec![b, c, d], vec![a, d, c], vec![a, b, d], vec![a, c, b]]
            } else {
                vec![vec![b, c], vec![c, a], vec![a, b]]
            };
            for facet in facets {
                let mut name = facet.clone();
                name.sort();
                let base = name[0];
                let name: Vec<_> = name.into_iter().map(|c| c.seen_from(base)).collect();
                if open.remove(&name).is_none() {
                    open.insert(name, facet);
                }
            }
        }
        let listed = open.into_values().map(|mut facet| {
            let least = (0..facet.len()).min_by_key(|&k| facet[k]).unwrap();
            if self.dimension == 3 {
                facet.rotate_left(least);
            }
            let base = facet[0];
            let mut corners = [Corner::default(); 3];
            for (slot, corner) in corners.iter_mut().zip(facet) {
                *slot = corner.seen_from(base);
            }
            corners
        });
        listed.collect()
    }

    /// The translations by at most `reach` periods.
    fn translations(&self, reach: i32) -> Vec<[i32; 3]> {
        let range = |axis: usize| if axis < self.rank { -reach..=reach } else { 0..=0 };
        let all = range(0).flat_map(|x| range(1).flat_map(move |y| range(2).map(move |z| [x, y, z])));
        all.collect()
    }

    /// Whether two of the lists of corners, up to the lattice, meet elsewhere than in the hull of their
    /// common corners, by the oracle.
    fn some_meet_elsewhere(&self, lists: &[Vec<Corner>], reach: i32) -> bool {
        let translations = self.translations(reach);
        let boxes: Vec<[[i64; 2]; 3]> = lists.iter().map(|list| self.bounding_box(list)).collect();
        lists.iter().enumerate().any(|(k, p)| {
            lists[..=k].iter().enumerate().any(|(l, q)| {
                translations.iter().filter(|&&by| k != l || by > [0; 3]).any(|&by| {
                    let apart = |axis: usize| {
                        let step = i64::from(by[axis]) * self.denominator;
                        let ([a, b], [c, d]) = (boxes[k][axis], boxes[l][axis]);
                        b < c + step || d + step < a
                    };
                    !(0..3).any(apart) && self.meet_elsewhere(p, q, by)
                })
            })
        })
    }

    /// The least and the greatest coordinate of the corners along each axis.
    fn bounding_box(&self, list: &[Corner]) -> [[i64; 2]; 3] {
        [0, 1, 2].map(|k| {
            let values = || list.iter().map(|corner| self.place(*corner)[k]);
            [values().min().unwrap(), values().max().unwrap()]
        })
    }

    /// Whether p and the translate of q meet elsewhere than in the hull of their common corners.
    fn meet_elsewhere(&self, p: &[Corner], q: &[Corner], by: [i32; 3]) -> bool {
        let q: Vec<Corner> = q.iter().map(|c| c.moved_by(Corner { vertex: 0, shift: by })).collect();
        let common: Vec<bool> = p.iter().map(|corner| q.contains(corner)).collect();
        let [p, q] = [p, &q].map(|list| list.iter().map(|c| self.place(*c)).collect::<Vec<_>>());
        meet_elsewhere(&p, &q, &common)
    }
}

/// Verdicts at several sizes of numbers.
fn check_at_all_sizes(case: &Case, facets: &[[Corner; 3]], expected: Result<(), Code>) {
    let limits = Limits::DEFAULT;
    let largest = case.vertices.iter().flatten().map(|x| x.abs()).max().unwrap();
    let scales = [1, 1 << 20, (1 << 33) + 1, (1 << 52) + 1];
    for scale in scales.into_iter().filter(|&x: &i64| x.checked_mul(2 * largest).is_some()) {
        let found = verdict::<1>(case, facets, Scale::Rational(scale), &limits);
        assert_eq!(found, expected, "{:?} {facets:?} times {scale}", case.vertices);
    }
    if case.rank == 0 {
        for (x, y) in [(0, 1), (7, -4), (1 << 30, 1 << 29)] {
            let found = verdict::<2>(case, facets, Scale::Root(x, y), &limits);
            assert_eq!(found, expected, "{:?} {facets:?} over √2", case.vertices);
        }
    }
}

/// All pairs of facets that are not flat, with these corners; equal numbers are equal corners.
fn every_pair(dimension: usize, points: &[Point], stride: usize) {
    let mut case = Case::new(dimension, 0, 1);
    case.vertices = points.to_vec();
    let n = points.len();
    let mut facets: Vec<Vec<usize>> = Vec::new();
    for a in 0..n {
        for b in 0..a {
            if dimension == 2 {
                facets.push(vec![b, a]);
            } else {
                facets.extend((0..b).map(|c| vec![c, b, a]));
            }
        }
    }
    facets.retain(|facet| {
        let [x, y] = [points[facet[0]], points[facet[1]]];
        let e: Vec<i64> = (0..3).map(|k| y[k] - x[k]).collect();
        let h: Vec<i64> = match facet.get(2) {
            Some(&z) => (0..3).map(|k| points[z][k] - x[k]).collect(),
            None => vec![0, 0, 1],
        };
        [(0, 1), (1, 2), (2, 0)].iter().any(|&(i, j)| e[i] * h[j] != e[j] * h[i])
    });
    let mut seen = [0, 0];
    let pairs = (0..facets.len()).flat_map(|k| (0..k).map(move |l| (k, l)));
    for (k, l) in pairs.step_by(stride) {
        let lists = [k, l].map(|k| facets[k].iter().map(|&v| corner(v)).collect::<Vec<_>>());
        let expected = !case.some_meet_elsewhere(&lists, 0);
        let listed = lists.map(|list| {
            let mut corners = [Corner::default(); 3];
            corners[..dimension].copy_from_slice(&list);
            corners
        });
        let expected_code = if expected { Ok(()) } else { Err(Code::BoundaryMeets) };
        check_at_all_sizes(&case, &listed, expected_code);
        seen[usize::from(expected)] += 1;
    }
    assert!(seen[0] > 99 && seen[1] > 99, "{seen:?}");
}

fn grid(n: i64) -> impl Iterator<Item = Point> {
    (0..n * n * n).map(move |k| [k / (n * n), k / n % n, k % n])
}

#[test]
fn triangles_of_a_cube() {
    every_pair(3, &grid(2).collect::<Vec<_>>(), 2);
}

#[test]
fn triangles_of_a_plane() {
    every_pair(3, &grid(3).filter(|p| p[2] == 1).collect::<Vec<_>>(), 7);
    every_pair(3, &grid(3).filter(|p| p.iter().sum::<i64>() == 3).collect::<Vec<_>>(), 1);
}

/// Equal places with different numbers are different corners.
#[test]
fn triangles_of_a_tetrahedron_twice() {
    let corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]];
    every_pair(3, &[corners, corners].concat(), 5);
}

#[test]
fn segments_of_a_plane() {
    let points: Vec<Point> = grid(3).filter(|p| p[2] == 0).collect();
    every_pair(2, &points, 1);
    let some = [[0, 0, 0], [2, 0, 0], [4, 0, 0], [1, 1, 0], [3, 3, 0], [2, 4, 0]];
    every_pair(2, &[some, some].concat(), 1);
}

/// Coordinates that rounding to 19 bits changes, of triangles that nearly touch.
#[test]
fn triangles_nearly_touch() {
    let mut random = Random(7);
    let points: Vec<Point> =
        grid(2).chain([[1, 1, 1], [0, 0, 0]]).map(|p| p.map(|x| (x << 19) + random.below(3) - 1)).collect();
    every_pair(3, &points, 5);
}

struct Random(u64);

impl Random {
    fn below(&mut self, n: i64) -> i64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        i64::try_from(self.0 >> 33).unwrap() % n
    }
}

/// Kuhn's triangulation of a grid of n cells, as far as they are kept; it closes up along the lattice.
fn kuhn(dimension: usize, rank: usize, (n, size): (i64, i64), mut keep: impl FnMut() -> bool) -> Case {
    let mut case = Case::new(dimension, rank, size * n);
    let mut numbers: BTreeMap<Point, usize> = BTreeMap::new();
    let orders: &[&[usize]] = if dimension == 3 {
        &[&[0, 1, 2], &[1, 2, 0], &[2, 0, 1], &[0, 2, 1], &[2, 1, 0], &[1, 0, 2]]
    } else {
        &[&[0, 1], &[1, 0]]
    };
    let cells = grid(n).filter(|cell| dimension == 3 || cell[2] == 0);
    for (cell, order) in cells.flat_map(|cell| orders.iter().map(move |order| (cell, order))) {
        if !keep() {
            continue;
        }
        let mut row = [Corner::default(); 4];
        let mut at = cell;
        for (k, slot) in row.iter_mut().enumerate().take(dimension + 1) {
            if k > 0 {
                at[order[k - 1]] += 1;
            }
            let (mut place, mut shift) = (at, [0; 3]);
            for axis in 0..rank {
                shift[axis] = i32::try_from(at[axis].div_euclid(n)).unwrap();
                place[axis] = at[axis].rem_euclid(n);
            }
            let next = numbers.len();
            let vertex = *numbers.entry(place).or_insert(next);
            if vertex == case.vertices.len() {
                case.vertices.push(place.map(|x| size * x));
            }
            *slot = Corner { shift, ..corner(vertex) };
        }
        if !matches!(order, [0, 1, 2] | [1, 2, 0] | [2, 0, 1] | [0, 1]) {
            row.swap(dimension - 1, dimension);
        }
        case.rows.push(row);
    }
    case
}

/// Some tiles of a grid, and a piece that is smaller or of the same grid, somewhere.
/// F holds, since the boundary is computed. So X and W decide whether the tiles are a mesh.
fn random_regions(dimension: usize, rank: usize, n: i64, seed: u64, count: usize) {
    let mut random = Random(seed);
    let mut seen = BTreeMap::new();
    for _ in 0..count {
        let part = 1 + random.below(6);
        let mut case = kuhn(dimension, rank, (n, 12), || random.below(part) == 0);
        let size = [1, 2, 3, 12][random.below(4) as usize];
        let second = kuhn(dimension, 0, (1, size), || random.below(2) == 0);
        let mut by = [0; 3];
        for x in by.iter_mut().take(dimension) {
            *x = if size == 12 { 12 * random.below(2 * n) } else { random.below(13 * n) };
        }
        let before = case.vertices.len();
        case.vertices.extend(second.vertices.iter().map(|x| [0, 1, 2].map(|k| x[k] + by[k])));
        case.rows.extend(second.rows.iter().map(|row| {
            let mut row = *row;
            for corner in row.iter_mut().take(dimension + 1) {
                corner.vertex += u32::try_from(before).unwrap();
            }
            row
        }));
        let facets = case.boundary();
        if facets.is_empty() {
            continue;
        }
        let lists =
            |rows: &[[Corner; 4]]| -> Vec<Vec<Corner>> { rows.iter().map(|row| row[..=dimension].to_vec()).collect() };
        let is_mesh = !case.some_meet_elsewhere(&lists(&case.rows), 2);
        let limits = Limits::DEFAULT;
        let found = verdict::<1>(&case, &facets, Scale::Rational(1), &limits);
        let large = verdict::<1>(&case, &facets, Scale::Rational((1 << 50) + 1), &limits);
        assert_eq!((found.is_ok(), large), (is_mesh, found), "{case:?} {facets:?}");
        *seen.entry(found).or_insert(0) += 1;
    }
    println!("{dimension} {rank}: {seen:?}");
    let codes = [Ok(()), Err(Code::BoundaryMeets), Err(Code::Covering)];
    assert!(codes.iter().all(|code| seen.get(code) >= Some(&(count / 50))), "{seen:?}");
}

#[test]
fn random_regions_of_the_plane() {
    for rank in 0..3 {
        random_regions(2, rank, 3, 5 + rank as u64, 150);
    }
}

#[test]
fn random_regions_of_space() {
    for rank in 0..4 {
        random_regions(3, rank, 2, 9 + rank as u64, 40);
    }
}

/// A facet and its own translate overlap; different listed facets are apart.
#[test]
fn strip_of_twice_the_period() {
    let mut case = Case::new(2, 1, 1);
    case.vertices = vec![[0, 0, 0], [0, 1, 0]];
    let at = |vertex: usize, shift: i32| Corner { shift: [shift, 0, 0], ..corner(vertex) };
    let end = Corner::default();
    case.rows = vec![[at(0, 0), at(0, 2), at(1, 0), end], [at(0, 2), at(1, 2), at(1, 0), end]];
    let facets = case.boundary();
    assert_eq!(facets.len(), 2);
    check_at_all_sizes(&case, &facets, Err(Code::BoundaryMeets));
    // The same strip once.
    case.rows = vec![[at(0, 0), at(0, 1), at(1, 0), end], [at(0, 1), at(1, 1), at(1, 0), end]];
    let facets = case.boundary();
    check_at_all_sizes(&case, &facets, Ok(()));
    // Both: two sheets.
    case.rows.extend([[at(0, 0), at(0, 1), at(1, 0), end], [at(0, 1), at(1, 1), at(1, 0), end]]);
    case.vertices.extend([[0, 0, 0], [0, 1, 0]]);
    for corner in case.rows[2..].iter_mut().flat_map(|row| &mut row[..3]) {
        corner.vertex += 2;
    }
    let facets = case.boundary();
    check_at_all_sizes(&case, &facets, Err(Code::BoundaryMeets));
}

/// Two pieces whose vertices are far apart collide after a translation; each piece has its own name for
/// the place where it is.
#[test]
fn pieces_collide_after_a_translation() {
    for rank in 0..4 {
        let mut case = Case::new(3, rank, 10);
        let tetrahedron = [[0, 0, 0], [3, 0, 0], [0, 3, 0], [0, 0, 3]];
        for by in [[1, 1, 1], [31, -19, 42]] {
            case.vertices.extend(tetrahedron.map(|x| [0, 1, 2].map(|k| x[k] + by[k])));
        }
        case.rows = vec![[0, 1, 2, 3].map(corner), [4, 5, 6, 7].map(corner)];
        let expected = if rank == 3 { Err(Code::BoundaryMeets) } else { Ok(()) };
        check_at_all_sizes(&case, &case.boundary(), expected);
        // A smaller one, inside of the first one after the translation.
        let inside = [[32, -18, 43], [33, -18, 43], [32, -17, 43], [32, -18, 44]];
        case.vertices.truncate(4);
        case.vertices.extend(inside.map(|x| x.map(|x| 4 * x - 3)));
        for vertex in &mut case.vertices[..4] {
            *vertex = vertex.map(|x| 4 * x);
        }
        case.denominator = 40;
        let expected = if rank == 3 { Err(Code::Covering) } else { Ok(()) };
        check_at_all_sizes(&case, &case.boundary(), expected);
    }
}

/// Two sets of needles that do not meet, but whose boxes all do.
fn needles(count: i64, factor: i64) -> Case {
    let mut case = Case::new(3, 0, 1);
    let length = 4 * count;
    for (z, is_second) in (0..count).flat_map(|k| [(4 * k, false), (4 * k, true)]) {
        let needle = if is_second {
            let z = z + 2 + 2 * length;
            [[0, length, z], [length, 0, z + length], [0, length, z + 1], [0, length + 1, z]]
        } else {
            [[0, 0, z], [length, length, z + length], [0, 0, z + 1], [0, 1, z]]
        };
        let first = case.vertices.len();
        case.vertices.extend(needle.map(|x| x.map(|x| factor * x + x % 7)));
        case.rows.push([first, first + 1, first + 2, first + 3].map(corner));
    }
    case
}

/// A limit declines, and a larger one does not refuse.
#[test]
fn needles_are_declined_by_a_limit() {
    let case = needles(20, (1 << 40) + 1);
    let facets = case.boundary();
    let scale = Scale::Rational(1);
    let mut found = Vec::new();
    for work in [1_000, 100_000, 10_000_000, 1_000_000_000] {
        found.push(verdict::<1>(&case, &facets, scale, &Limits { work, ..Limits::DEFAULT }));
    }
    assert_eq!(found, [Err(Code::Work), Err(Code::Work), Ok(()), Ok(())]);
}
