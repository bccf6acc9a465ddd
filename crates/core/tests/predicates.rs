//! Every fast predicate against its twin in exact numbers of the field, on difficult data. They are nearly
//! flat, exactly flat, with exact right angles, subnormals, huge exponents, or coordinates at the limits of
//! every width.

use crate::soup::{Random, compare_all, rational, skewed, soup};
use acutile_core::tiling::{
    Coordinates, Corner, Facet, Frame, Tiling, VertexId, match_facets, supercell,
};
use acutile_exact::geometry::{Bound, Sign, Simplex, linear};
use acutile_exact::number::{Number, Reader};
use malachite::Rational;
use std::collections::BTreeMap;

/// In each five the fourth point makes a parallelogram of the first four where it fits.
fn integers(random: &mut Random, n: usize, bits: u32, denominator: i64) -> Coordinates<3> {
    let mut points: Vec<_> = (0..n)
        .map(|_| [0; 3].map(|_| random.integer(bits)))
        .collect();
    for five in points.chunks_exact_mut(5) {
        let fourth = [0, 1, 2].map(|k| five[1][k] + five[2][k] - five[0][k]);
        if fourth.iter().all(|x| x.unsigned_abs() >> 62 == 0) {
            five[3] = fourth;
        }
    }
    Coordinates::from_integers(points, denominator).expect("they fit")
}

#[test]
fn integers_of_every_width() {
    let mut random = Random(1);
    let mut zeros = 0;
    for bits in (1..=62).step_by(if cfg!(debug_assertions) { 3 } else { 1 }) {
        for frame in [Frame::cubic(), skewed()] {
            let vertices = integers(&mut random, 10, bits, 7919);
            let shift = random.below(2) as i32;
            zeros += compare_all(&soup(vertices, frame, shift, &mut random));
        }
    }
    assert!(zeros > 100, "{zeros} zeros");
}

/// Lattice steps of almost 2^62, and shifts at their limit.
#[test]
fn long_steps() {
    let mut random = Random(2);
    for denominator in [1 << 40, (1 << 61) + 1, (1 << 62) - 1] {
        let vertices = integers(&mut random, 10, 61, denominator);
        compare_all(&soup(vertices, Frame::cubic(), 1 << 20, &mut random));
    }
}

/// Simplices with all or nearly all corners in a plane, at every scale.
#[test]
fn flat_and_nearly_flat_doubles() {
    let mut random = Random(3);
    let mut zeros = 0;
    for scale in [-1060, -800, -400, -100, -30, 0, 30, 100, 300, 900] {
        let size = 2f64.powi(scale / 2) * 2f64.powi(scale - scale / 2);
        for frame in [Frame::cubic(), skewed()] {
            let mut points = Vec::new();
            for _ in 0..4 {
                let [a, b] = [0; 2]
                    .map(|_| [0; 3].map(|_| random.unit().round() + random.integer(4) as f64));
                for _ in 0..5 {
                    let [s, t] = [0; 2].map(|_| random.integer(5) as f64);
                    let tilt = if random.below(2) == 0 {
                        0.0
                    } else {
                        f64::EPSILON
                    };
                    points.push([0, 1, 2].map(|k| (s * a[k] + t * b[k]) * (1.0 + tilt) * size));
                }
            }
            let vertices = Coordinates::from_doubles(points).expect("they are finite");
            zeros += compare_all(&soup(vertices, frame, 0, &mut random));
        }
    }
    assert!(zeros > 100, "{zeros} zeros");
}

/// Boxes cut along their diagonals: right angles that are exact.
#[test]
fn right_angles() {
    let mut random = Random(4);
    let mut zeros = 0;
    for scale in [-1000, -500, -60, 0, 60, 500] {
        let [a, b, c] = [0; 3].map(|_| (1.0 + random.unit()) * 2f64.powi(scale));
        let o = [0; 3].map(|_| random.unit() * 2f64.powi(scale));
        let at = |x: f64, y: f64, z: f64| [o[0] + x, o[1] + y, o[2] + z];
        let points = vec![
            o,
            at(a, 0.0, 0.0),
            at(a, b, 0.0),
            at(a, b, c),
            at(0.0, b, c),
        ];
        let vertices = Coordinates::from_doubles(points).expect("they are finite");
        zeros += compare_all(&soup(vertices, Frame::cubic(), 0, &mut random));
    }
    assert!(zeros > 10, "{zeros} zeros");
}

/// Doubles of all sizes in one simplex, subnormal and near the largest.
#[test]
fn wild_exponents() {
    let mut random = Random(5);
    for _ in 0..8 {
        let points = (0..10).map(|_| {
            [0; 3].map(|_| {
                let x = f64::from_bits(random.next());
                if x.is_finite() { x } else { 0.0 }
            })
        });
        let vertices = Coordinates::from_doubles(points.collect()).expect("they are finite");
        compare_all(&soup(vertices, skewed(), 1, &mut random));
    }
}

/// Doubles between -1 and 1 with a lattice.
#[test]
fn doubles_with_shifts() {
    let mut random = Random(6);
    for exponent in [0, -5, -20, -45, -200] {
        let scale = 2f64.powi(exponent);
        let points = (0..30).map(|_| [0; 3].map(|_| random.unit() * scale));
        let vertices = Coordinates::from_doubles(points.collect()).expect("they are finite");
        compare_all(&soup(vertices, skewed(), 2, &mut random));
    }
}

/// A vertex x and a number like sqrt(5) that is nearly rational to it.
fn field_soup(text: &str, near: &str, size: u32, random: &mut Random) -> Tiling<3> {
    let mut reader = Reader::new();
    let text = format!("{text}-({near})");
    reader.learn(&text).expect("a number");
    let small = reader.value(&text).expect("it was learnt");
    let frame = Frame {
        field: reader.field(),
        ..skewed()
    };
    let coordinate = |random: &mut Random| {
        rational(random.integer(size)) + &small * &rational(random.integer(size))
    };
    let mut points: Vec<_> = (0..10)
        .map(|_| [0; 3].map(|_| coordinate(random)))
        .collect();
    for five in points.chunks_exact_mut(5) {
        five[3] = [0, 1, 2].map(|k| &five[1][k] + &five[2][k] - &five[0][k]);
    }
    let mut tiling = soup(points.into(), frame, 1 - (size % 2) as i32, random);
    tiling.frame.gram[2][2] = &tiling.frame.gram[2][2] + &(&small * &rational(3));
    tiling
}

#[test]
fn quadratic_fields() {
    let mut random = Random(7);
    let mut zeros = 0;
    let near = ["0", "161/72", "2207/987", "7881196/3524578"];
    for near in near {
        for size in [2, 3, 8, 20, 29, 40, 61] {
            zeros += compare_all(&field_soup("sqrt(5)", near, size, &mut random));
        }
    }
    for root in ["sqrt(2)", "-sqrt(3)", "(1+sqrt(13))/2", "sqrt(1000003)"] {
        for size in [2, 8, 30] {
            zeros += compare_all(&field_soup(root, "3/7", size, &mut random));
        }
    }
    assert!(zeros > 10, "{zeros} zeros");
}

#[test]
fn other_fields_and_long_rationals() {
    let mut random = Random(8);
    for size in [2, 8, 40] {
        compare_all(&field_soup(
            "sqrt(2)+sqrt(3)",
            "3146264/1000000",
            size,
            &mut random,
        ));
    }
    for near in [
        "1/3",
        "1/1125899906842679",
        "1/123456789012345678901234567890123456789",
    ] {
        compare_all(&field_soup("1", near, 30, &mut random));
    }
}

/// The determinant and the products of normals in doubles are no further from the
/// exact values than the bounds say.
#[test]
fn bounds_hold() {
    let mut random = Random(9);
    let number = |x: f64| Number::from(Rational::try_from(x).expect("it is finite"));
    for round in 0..2000 {
        let flat = random.unit();
        let row: [f64; 3] = [0; 3].map(|_| random.unit() - 0.5);
        let mut edges = [row; 3];
        let wiggle = 2f64.powi(-(round % 60));
        edges
            .iter_mut()
            .flatten()
            .for_each(|x| *x = *x * (1.0 + flat) + (random.unit() - 0.5) * wiggle);
        let m = edges.iter().flatten().fold(0.0, |m: f64, x| m.max(x.abs()));
        let gram = [[4.0, 1.0, -1.0], [1.0, 3.0, 1.0], [-1.0, 1.0, 5.0]];
        let cogram = linear::cofactors(&gram);
        let doubles = Simplex::from_edges(edges);
        let exact = Simplex::from_edges(edges.map(|edge| edge.map(number)));
        let bounds = Simplex::from_edges([[Bound::given(m, 0.0); 3]; 3]);
        let check = |x: f64, exact: &Number, bound: &Bound| {
            let error = number(x) - exact.clone();
            assert!(error.abs() <= number(bound.error), "{x} {exact} {bound:?}");
            assert!(exact.abs() <= number(bound.size) && bound.size <= bound.top);
        };
        check(doubles.determinant, &exact.determinant, &bounds.determinant);
        let products = (
            doubles.normal_products(&cogram),
            exact.normal_products(&cogram.map(|row| row.map(number))),
            bounds.normal_products(&cogram.map(|row| row.map(|x| Bound::given(x.abs(), 0.0)))),
        );
        for (i, j, x) in products.0.pairs() {
            check(*x, products.1.get(i, j), products.2.get(i, j));
        }
    }
}

/// Each double is stored as the rational number that it is.
#[test]
fn doubles_are_exact() {
    let mut random = Random(11);
    let mut points = vec![[5e-324, -5e-324, f64::MAX], [0.0, -0.0, f64::MIN_POSITIVE]];
    points.extend((0..1000).map(|_| [0; 3].map(|_| f64::from_bits(random.next() & !(1 << 62)))));
    for stored in [
        points.clone(),
        vec![[0.5, 0.375, -7.0], [1.0, 2f64.powi(60), 0.0]],
    ] {
        let coordinates = Coordinates::from_doubles(stored.clone()).expect("they are finite");
        for (point, vertex) in stored.iter().zip(coordinates.iter()) {
            let expected = point.map(|x| Number::from(Rational::try_from(x).expect("finite")));
            assert_eq!(vertex, expected);
        }
    }
    assert!(Coordinates::from_doubles(vec![[0.0, f64::NAN, 0.0]]).is_none());
    assert!(Coordinates::from_doubles(vec![[f64::INFINITY, 0.0, 0.0]]).is_none());
    assert!(Coordinates::<3>::from_integers(vec![[1 << 62, 0, 0]], 1).is_none());
    assert!(Coordinates::<3>::from_integers(vec![[0, 0, 0]], 0).is_none());
}

/// Facets in pairs and otherwise, against a map from normal forms.
#[test]
fn matching_against_a_map() {
    let mut random = Random(12);
    for vertices in [1, 2, 3, 5, 9] {
        for _ in 0..60 {
            let corner = |random: &mut Random| Corner {
                vertex: VertexId::new(random.below(vertices) as u32),
                shift: [0; 3].map(|_| random.below(2) as i32),
            };
            let corners = (0..4 * 40).map(|_| corner(&mut random)).collect();
            check_matching(&tiling_of(vertices as usize, corners));
        }
    }
}

/// Cubes in six tetrahedra each, as they are and with a change: without one, with one twice, with one
/// turned inside out, with one moved far by a lattice vector, with numbers of vertices in another order.
#[test]
fn matching_of_cubes_against_a_map() {
    let mut random = Random(13);
    for n in 1..=4 {
        for change in 0..6 {
            let mut corners = cubes(n);
            let row = 4 * random.below(corners.len() as u64 / 4) as usize;
            match change {
                1 => drop(corners.drain(row..row + 4)),
                2 => corners.extend_from_within(row..row + 4),
                3 => corners.swap(row, row + 1),
                4 => {
                    for corner in &mut corners[row..row + 4] {
                        *corner = corner.moved([-9, 1 << 20, 16]);
                    }
                }
                5 => {
                    for corner in &mut corners {
                        let number = corner.vertex.number() as usize;
                        let other = (number * 29 + 5) % (n * n * n);
                        corner.vertex = VertexId::new(other as u32);
                    }
                }
                _ => {}
            }
            let mismatches = check_matching(&tiling_of(n * n * n, corners));
            // 29 has no common divisor with 1, 8, 27 and 64.
            assert_eq!(mismatches, [0, 4, 4, 4, 0, 0][change], "{n} {change}");
        }
    }
}

/// More facets with one vertex than are compared one by one.
#[test]
fn matching_of_a_large_star_against_a_map() {
    let mut random = Random(14);
    for vertices in [10, 40] {
        let corner = |vertex: u64| Corner {
            vertex: VertexId::new(vertex as u32),
            shift: [0; 3],
        };
        let rows = (0..200).map(|_| {
            let [a, b, c] = [0; 3].map(|_| 1 + random.below(vertices - 1));
            [0, a, b, c].map(corner)
        });
        let corners = rows.flatten().collect();
        check_matching(&tiling_of(vertices as usize, corners));
    }
}

/// The cubes of a lattice in six tetrahedra each; its cell has n cubes to every side.
fn cubes(n: usize) -> Vec<Corner<3>> {
    let mut corners = Vec::new();
    for cube in 0..n * n * n {
        for (order, is_even) in [
            ([0, 1, 2], true),
            ([1, 2, 0], true),
            ([2, 0, 1], true),
            ([0, 2, 1], false),
            ([2, 1, 0], false),
            ([1, 0, 2], false),
        ] {
            let mut point = [cube / n / n, cube / n % n, cube % n];
            let mut row = Vec::new();
            for axis in [order[0], order[1], order[2], 0] {
                let [x, y, z] = point.map(|x| x % n);
                row.push(Corner {
                    vertex: VertexId::new(((x * n + y) * n + z) as u32),
                    shift: point.map(|x| (x / n) as i32),
                });
                point[axis] += 1;
            }
            if !is_even {
                row.swap(2, 3);
            }
            corners.extend(row);
        }
    }
    corners
}

fn tiling_of(vertices: usize, corners: Vec<Corner<3>>) -> Tiling<3> {
    Tiling {
        frame: Frame::cubic(),
        vertices: Coordinates::from_integers(vec![[0; 3]; vertices], 1).expect("they fit"),
        corners,
    }
}

/// The number of groups that do not match.
fn check_matching(tiling: &Tiling<3>) -> usize {
    type Use = (Facet, bool, [i32; 3]);
    let mut groups: BTreeMap<Vec<Corner<3>>, Vec<Use>> = BTreeMap::new();
    for (s, simplex) in tiling.indices().zip(tiling.simplices()) {
        for i in 0..4 {
            let rest: Vec<Corner<3>> = (0..4).filter(|&k| k != i).map(|k| simplex[k]).collect();
            let mut form = rest.clone();
            form.sort();
            // The parity by counting inversions.
            let pairs = [(0, 1), (0, 2), (1, 2)];
            let odd = pairs.iter().filter(|(a, b)| rest[*b] < rest[*a]).count() % 2 == 1;
            let origin = form[0].shift;
            let form = form.iter().map(|c| c.moved(origin.map(|x| -x))).collect();
            let entry = (Facet::new(s, i), odd ^ (i % 2 == 1), origin);
            groups.entry(form).or_default().push(entry);
        }
    }
    let matching = match_facets(tiling);
    let mut mismatches = Vec::new();
    for group in groups.values() {
        match group[..] {
            [a, b] if a.1 != b.1 => {
                for (a, b) in [(a, b), (b, a)] {
                    let mate = matching.mate(tiling, a.0).expect("a mate");
                    assert_eq!(mate.facet, b.0);
                    assert_eq!(mate.shift, [0, 1, 2].map(|k| a.2[k] - b.2[k]));
                }
            }
            _ => {
                for (facet, ..) in group {
                    assert_eq!(matching.mate(tiling, *facet), None);
                }
                let uses = group.iter().map(|(facet, side, _)| (*facet, *side));
                mismatches.push(uses.collect::<Vec<_>>());
            }
        }
    }
    mismatches.sort();
    let found = matching.mismatches.iter().map(|m| m.uses.clone());
    let found: Vec<Vec<(Facet, bool)>> = found.collect();
    assert_eq!(found, mismatches);
    mismatches.len()
}

/// Supercells in integers and in numbers of a field are the same.
#[test]
fn supercells() {
    let mut random = Random(13);
    let vertices = integers(&mut random, 5, 20, 12);
    let integral = soup(vertices, skewed(), 3, &mut random);
    let mut general = integral.clone();
    let far = Number::from(Rational::from_signeds(1, 3) << 200u32);
    let moved = |x: [Number; 3]| x.map(|x| x + &far);
    general.vertices = integral.vertices.iter().map(moved).collect();
    let sizes = [2, 3, 5];
    let (a, b) = (supercell(&integral, sizes), supercell(&general, sizes));
    assert_eq!(a.corners, b.corners);
    assert_eq!(a.vertices.len(), b.vertices.len());
    for (x, y) in a.vertices.iter().zip(b.vertices.iter()) {
        for k in 0..3 {
            let expected = &far * &Number::from(Rational::from_unsigneds(1, sizes[k]));
            assert_eq!((&y[k] - &x[k]).cmp(&expected), Sign::Equal);
        }
    }
}
