//! Simplices that need not tile anything, and every fast predicate against its twin in exact
//! numbers of the field.

use acutile_core::predicates::{
    Angles, AnglesAgainst, InSphere, Metric, Model, Orientation, Predicate, RadiusAgainst, Shape,
    Signs,
};
use acutile_core::tiling::{Coordinates, Corner, Frame, SimplexId, Tiling, VertexId};
use acutile_exact::geometry::linear;
use acutile_exact::number::Number;
use malachite::Rational;

/// A generator of numbers that is the same in every run (Knuth's constants).
pub struct Random(pub u64);

impl Random {
    pub fn next(&mut self) -> u64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        self.0 ^ self.0 >> 29
    }

    pub fn below(&mut self, n: u64) -> u64 {
        (self.next() >> 16) % n
    }

    pub fn integer(&mut self, bits: u32) -> i64 {
        (self.next() as i64) >> (64 - bits)
    }

    pub fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 / 2f64.powi(53)
    }
}

pub fn rational(n: i64) -> Number {
    Number::from(Rational::from(n))
}

/// Simplices over these vertices, four corners each, some of them moved; they need
/// not tile anything.
pub fn soup(
    vertices: Coordinates<3>,
    frame: Frame<3>,
    shift: i32,
    random: &mut Random,
) -> Tiling<3> {
    let n = vertices.len() as u64;
    let corner = |vertex: u64, random: &mut Random| Corner {
        vertex: VertexId::new(vertex as u32),
        shift: [0; 3].map(|_| random.below(2 * shift as u64 + 1) as i32 - shift),
    };
    let mut corners = Vec::new();
    for first in (0..n).step_by(5) {
        for k in [0, 1, 2, 3, 0, 2, 1, 4] {
            corners.push(corner((first + k) % n, random));
        }
    }
    Tiling {
        frame,
        vertices,
        corners,
    }
}

/// The value of the predicate over the numbers of the tiling, without any shortcut.
pub fn twin<P: Predicate<3>>(
    predicate: &P,
    tiling: &Tiling<3>,
    simplex: SimplexId,
    apex: &Corner<3>,
) -> Signs {
    let corners = tiling.simplex(simplex);
    let origin = tiling.position(&corners[0]);
    let vector = |corner: &Corner<3>| linear::subtract(&tiling.position(corner), &origin);
    let gram = tiling.frame.gram.clone();
    let metric = Metric {
        cogram: linear::cofactors(&gram),
        gram,
        constants: predicate.constants(),
    };
    let edges = [1, 2, 3].map(|k| vector(&corners[k]));
    Signs::of(predicate, edges, &vector(apex), &metric)
}

/// Compares one predicate on all simplices; how many values are zero.
pub fn compare<P: Predicate<3> + Clone>(predicate: P, tiling: &Tiling<3>) -> usize {
    let model = Model::new(tiling);
    let prepared = model.prepare(predicate.clone());
    let mut zeros = 0;
    let apex_of =
        |simplex: SimplexId| tiling.simplex(SimplexId::at((simplex.index() + 1) % tiling.len()))[2];
    let mut together = Vec::new();
    let items = tiling
        .indices()
        .map(|simplex| ((simplex, simplex), apex_of(simplex)));
    prepared.for_each_with(items, |_, signs| together.push(*signs));
    for simplex in tiling.indices() {
        let apex = apex_of(simplex);
        let expected = twin(&predicate, tiling, simplex, &apex);
        let corners = tiling.simplex(simplex);
        assert_eq!(prepared.signs_with(simplex, &apex), expected, "{corners:?}");
        assert_eq!(together[simplex.index()], expected, "{corners:?}");
        assert_eq!(
            prepared.exact_signs(corners, &apex),
            expected,
            "{corners:?}"
        );
        zeros += usize::from(!expected.none_zero());
    }
    zeros
}

/// All predicates; how many simplices have a value that is zero.
pub fn compare_all(tiling: &Tiling<3>) -> usize {
    let mut zeros = compare(Orientation, tiling) + compare(Angles, tiling);
    zeros += compare(Shape, tiling) + compare(InSphere, tiling);
    for numerator in [-(1i64 << 30), -1, 0, 1, 1 << 30, 1_518_500_250] {
        let cosine = Rational::from_signeds(numerator, 1i64 << 31);
        let square = &cosine * &cosine;
        let signed_square = if cosine < 0 { -square } else { square };
        zeros += compare(AnglesAgainst::new(&Number::from(signed_square)), tiling);
    }
    let bound = Rational::from_signeds(866, 1000);
    zeros += compare(RadiusAgainst::new(&Number::from(&bound * &bound)), tiling);
    check_shapes(tiling);
    let sum = tiling
        .indices()
        .fold(Number::zero(), |sum, s| sum + tiling.shape(s).determinant);
    assert_eq!(Model::new(tiling).sum_of_determinants(), sum);
    zeros
}

pub fn skewed() -> Frame<3> {
    let gram = [[4, 1, -1], [1, 3, 1], [-1, 1, 5]];
    Frame {
        gram: gram.map(|row| row.map(rational)),
        ..Frame::cubic()
    }
}

/// The lists of one pass against the twins of both predicates.
fn check_shapes(tiling: &Tiling<3>) {
    let model = Model::new(tiling);
    let failing = |is_right: &dyn Fn(Signs, Signs) -> bool| -> Vec<SimplexId> {
        let all = tiling.indices().filter(|&simplex| {
            let apex = &tiling.simplex(simplex)[0];
            let twins = (
                twin(&Orientation, tiling, simplex, apex),
                twin(&Angles, tiling, simplex, apex),
            );
            !is_right(twins.0, twins.1)
        });
        all.collect()
    };
    let shapes = model.shapes();
    assert_eq!(
        shapes.not_positive,
        failing(&|orientation, _| orientation.all_positive())
    );
    assert_eq!(
        shapes.not_acute,
        failing(&|_, angles| angles.all_negative())
    );
    assert_eq!(shapes.obtuse, failing(&|_, angles| angles.none_positive()));
}
