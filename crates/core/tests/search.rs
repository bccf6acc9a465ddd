//! The filtered predicates and search of Delaunay triangulations against the exact ones.

use acutile_core::delaunay::model::Model;
use acutile_core::delaunay::predicates::Predicates;
use acutile_core::delaunay::{Found, search};
use acutile_core::predicates::Model as Coordinates;
use acutile_core::tiling::{Corner, Frame, PointSet, VertexId};
use acutile_exact::geometry::{Simplex, linear};
use acutile_exact::number::{Field, Number};
use malachite::Rational;

/// A generator of pseudo-random numbers (Knuth's MMIX).
struct Random(u64);

impl Random {
    /// From 0 to n - 1.
    fn below(&mut self, n: i64) -> i64 {
        self.0 = self
            .0
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        ((self.0 >> 1) as i64).rem_euclid(n)
    }

    /// A point of the model, moved by less than `reach` cells.
    fn corner(&mut self, model: &Model<3>, reach: i64) -> Corner<3> {
        Corner {
            vertex: VertexId::new(self.below(model.names.len() as i64) as u32),
            shift: std::array::from_fn(|_| (self.below(2 * reach) - reach) as i32),
        }
    }
}

const CUBIC: [[i64; 3]; 3] = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
const TRICLINIC: [[i64; 3]; 3] = [[100, 23, -17], [23, 121, 35], [-17, 35, 81]];

fn model(gram: [[i64; 3]; 3], denominator: i64, points: &[[i64; 3]]) -> Model<3> {
    let rational = |n, d| Number::from(Rational::from_signeds(n, d));
    let gram = gram.map(|row| row.map(|x| rational(x, 1)));
    let points = points
        .iter()
        .map(|p| p.map(|x| rational(x, denominator)))
        .collect();
    let frame = Frame::space(Field::rationals(), gram);
    Model::new(&PointSet { frame, points }).unwrap()
}

/// The predicates give the signs of the polynomials in numbers of the field. Coordinates have 2 to 60 bits.
/// Corners are close to each other, or far beyond the filter's reach. Five points of a small grid often lie
/// on a sphere.
#[test]
fn predicates_agree_with_numbers_of_the_field() {
    let mut random = Random(1);
    let mut zeros = 0;
    for gram in [CUBIC, TRICLINIC] {
        for bits in [2, 4, 9, 14, 21, 30, 46, 58, 60] {
            let mut points: Vec<[i64; 3]> = (0..20)
                .map(|_| std::array::from_fn(|_| random.below(1 << bits)))
                .collect();
            points.sort_unstable();
            points.dedup();
            let model = model(gram, 1 << bits, &points);
            let coordinates = Coordinates::of_vertices(&model.points);
            let predicates = Predicates::new(&model, &coordinates);
            for reach in [1, 2, 8, 1 << 10, 1 << 22] {
                for _ in 0..20 {
                    let facet: [Corner<3>; 3] =
                        std::array::from_fn(|_| random.corner(&model, reach));
                    let [apex, p] = [(); 2].map(|()| random.corner(&model, reach));
                    let corners = [facet[0], facet[1], facet[2], apex].map(|c| model.position(&c));
                    let simplex = Simplex::new(&corners);
                    let orientation = simplex.determinant.sign();
                    assert_eq!(predicates.orientation(&facet, &apex), orientation);
                    let offset = linear::subtract(&model.position(&p), &corners[0]);
                    let side = simplex.power(&model.lattice.gram, &offset).sign();
                    assert_eq!(predicates.sphere(&facet, &apex).side(&p), side);
                    zeros += u32::from(orientation.is_eq()) + u32::from(side.is_eq());
                }
            }
        }
    }
    assert!(zeros > 50);
}

/// Positions in the cell do not matter here: corners as sets, in order.
fn simplices(found: &Found<3>) -> Vec<Vec<Corner<3>>> {
    let normal = |simplex: &[Corner<3>]| {
        let mut corners = simplex.to_vec();
        corners.sort_unstable();
        let back = corners[0].shift.map(|x| -x);
        corners.into_iter().map(|c| c.moved(back)).collect()
    };
    let mut simplices: Vec<_> = found.shell.simplices().map(normal).collect();
    simplices.sort_unstable();
    simplices
}

/// The search without doubles, to which a failed certificate falls back, finds the same.
#[test]
fn the_search_without_doubles_finds_the_same() {
    let mut random = Random(2);
    for (gram, denominator, count) in [
        (CUBIC, 1 << 30, 40),
        (TRICLINIC, 1 << 30, 40),
        (CUBIC, 4, 20),
        (TRICLINIC, 3, 15),
    ] {
        let mut points: Vec<[i64; 3]> = (0..count)
            .map(|_| std::array::from_fn(|_| random.below(denominator)))
            .collect();
        points.sort_unstable();
        points.dedup();
        let model = model(gram, denominator, &points);
        let coordinates = Coordinates::of_vertices(&model.points);
        let mut predicates = Predicates::new(&model, &coordinates);
        let quick = search(&predicates).unwrap();
        predicates.filtered = false;
        let slow = search(&predicates).unwrap();
        assert_eq!(simplices(&quick), simplices(&slow));
        assert_eq!(quick.simple, slow.simple);
    }
}
