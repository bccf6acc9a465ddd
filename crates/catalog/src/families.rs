//! Constructions for all values of their parameters in a box.
//!
//! The simplices are those of one member; Gram matrix and vertices become polynomials. A Gram matrix
//! counts up to a positive factor, so a ratio r between 0 and infinity is written as
//! r = s/(1 - s) with s between 0 and 1.

use super::recipe::{common_field, fraction};
use super::{CatalogError, congruent, planar, plane_tiling, slab, solid};
use acutile_core::delaunay::{Ties, triangulate};
use acutile_core::family::{AnyFamily, Family, Parameter, free};
use acutile_core::tiling::{Domain, Frame, PointSet, Tiling};
use acutile_exact::geometry::RingElement;
use acutile_exact::number::{Field, Number, numbers};
use acutile_exact::polynomial::{End, Polynomial, Side};

type Built = Result<AnyFamily, CatalogError>;

/// A parameter with its interval in brackets, `(0, 1]`; its ends are numbers of `field`.
fn parameter(name: &str, interval: [Number; 2], is_open: [bool; 2]) -> Parameter {
    let [low, high] = interval;
    let end = |value: Number, is_open: bool| End { value, is_open };
    Parameter {
        name: name.to_owned(),
        side: Side {
            low: end(low, is_open[0]),
            high: end(high, is_open[1]),
        },
    }
}

fn open(name: &str, low: Number, high: Number) -> Parameter {
    parameter(name, [low, high], [true, true])
}

fn closed(name: &str, low: Number, high: Number) -> Parameter {
    parameter(name, [low, high], [false, false])
}

fn constant(value: &Number) -> Polynomial {
    Polynomial::constant(value.clone())
}

fn rational(numerator: i64, denominator: i64) -> Polynomial {
    Polynomial::constant(fraction(numerator, denominator))
}

/// The family of a tiling with these parameters; entries of the Gram matrix and coordinates are
/// mapped to polynomials.
fn over<const D: usize>(
    tiling: &Tiling<D>,
    parameters: Vec<Parameter>,
    gram: impl Fn(usize, usize, &Number) -> Polynomial,
    coordinate: impl Fn(usize, &Number) -> Polynomial,
) -> Family<D> {
    let entries = &tiling.frame.gram;
    let gram: [[Polynomial; D]; D] =
        std::array::from_fn(|i| std::array::from_fn(|j| gram(i, j, &entries[i][j])));
    let vertex = |vertex: [Number; D]| -> [Polynomial; D] {
        std::array::from_fn(|k| coordinate(k, &vertex[k]))
    };
    // The polytope has the last coordinates.
    let rank = tiling.frame.rank();
    let mut domain = tiling.frame.domain.map(constant);
    if let Domain::Slab(polytope) | Domain::Prism(polytope) | Domain::Solid(polytope) = &mut domain
    {
        for row in &mut polytope.vertices {
            for (k, x) in row.iter_mut().enumerate() {
                if let Some(value) = x.to_constant() {
                    *x = coordinate(rank + k, &value);
                }
            }
        }
    }
    let vertices: Vec<[Polynomial; D]> = tiling.vertices.iter().map(vertex).collect();
    let mut family = Family {
        parameters,
        frame: Frame {
            field: Field::rationals(),
            gram,
            domain,
        },
        vertices,
        corners: tiling.corners.clone(),
    };
    family.frame.field = field_of(&family);
    family
}

/// The field of all coefficients and ends.
fn field_of<const D: usize>(family: &Family<D>) -> Field {
    let sides = family.parameters.iter().map(|parameter| &parameter.side);
    let ends = sides.flat_map(|side| [&side.low.value, &side.high.value]);
    let terms = family.polynomials().flat_map(|p| p.terms());
    common_field(terms.map(|(_, c)| c).chain(ends))
}

/// Goldberg's frame with e² : a² = s : 1 - s: the products of the basis are a² + e² and a² - e²/2.
fn goldberg(tiling: &Tiling<3>, low: Number, is_open: bool) -> Built {
    let s = Polynomial::parameter(0);
    let one = s.integer(1);
    let gram = |i: usize, j: usize, _: &Number| {
        let product = if i == j {
            rational(1, 1)
        } else {
            rational(-1, 2)
        };
        one.minus(&s).plus(&product.times(&s))
    };
    let side = parameter("s", [low, fraction(1, 1)], [is_open, true]);
    let family = over(tiling, vec![side], gram, |_, x| constant(x));
    Ok(AnyFamily::Space(family))
}

/// Goldberg's first family for every ratio.
pub fn goldberg_1() -> Built {
    goldberg(
        &congruent::goldberg_1(&fraction(1, 2)),
        fraction(0, 1),
        true,
    )
}

/// The members with e² >= 2a²: s >= 2/3.
pub fn goldberg_1_nonobtuse() -> Built {
    goldberg(
        &congruent::goldberg_1(&fraction(1, 2)),
        fraction(2, 3),
        false,
    )
}

/// Goldberg's second family for every ratio.
pub fn goldberg_2() -> Built {
    goldberg(
        &congruent::goldberg_2(&fraction(1, 2)),
        fraction(0, 1),
        true,
    )
}

/// All acute triangles up to similarity. A triangle with the Gram matrix [[A, B], [B, C]] is acute
/// exactly if B, A - B and C - B are positive. Their sum is made 1: B = xy, A - B = (1 - x) y,
/// C - B = 1 - y.
pub fn triangle_tiling() -> Built {
    let tiling = planar::triangle_tiling("1,1,1")?;
    let [x, y] = [0, 1].map(Polynomial::parameter);
    let product = x.times(&y);
    let gram = |i: usize, j: usize, _: &Number| match (i, j) {
        (0, 0) => y.clone(),
        (1, 1) => y.integer(1).minus(&y).plus(&product),
        _ => product.clone(),
    };
    let unit = |name: &str| open(name, fraction(0, 1), fraction(1, 1));
    let family = over(&tiling, vec![unit("x"), unit("y")], gram, |_, x| {
        constant(x)
    });
    Ok(AnyFamily::Plane(family))
}

/// The two tetrahedra for epsilon between 0 and (sqrt 2 - 1)/3, from which on they are Delaunay.
pub fn two_corners() -> Built {
    // The coordinates with epsilon = 1/10 are -epsilon, 0, 1 and 2/3 + epsilon.
    let tiling = solid::two_corners(&fraction(1, 10));
    let epsilon = Polynomial::parameter(0);
    let coordinate = |_: usize, x: &Number| match x {
        x if *x == fraction(-1, 10) => epsilon.negated(),
        x if *x == fraction(23, 30) => rational(2, 3).plus(&epsilon),
        x => constant(x),
    };
    let end = "(sqrt(2)-1)/3";
    let high = numbers(&[end]).map_err(|error| CatalogError::Number(end.to_owned(), error))?;
    let side = open("epsilon", fraction(0, 1), high[0].clone());
    let family = over(&tiling, vec![side], |_, _, x| constant(x), coordinate);
    Ok(AnyFamily::Space(family))
}

/// The slab with the heights z1, z2, z3 of its layers, in a box around the paper's 4, 4.6 and 7.1.
///
/// Necessary for acute angles are z1 > 3, 4 (z3 - z2)² < 27,
/// 2 z3² + 2 z2 z3 - z2² - 6 z1 z3 + 3 z1² > 9 and 4 (z3 - z1) (z3 - z2) > 9. The box nearly touches
/// each of these: at (., 4.55, 7.14), (4.5, 4.55, 6.6) and (4.5, 5.5, 6.6).
pub fn slab_heights() -> Built {
    let [z1, z2, z3] = [0, 1, 2].map(Polynomial::parameter);
    let sides = [
        parameter("z1", [fraction(3, 1), fraction(9, 2)], [true, false]),
        closed("z2", fraction(91, 20), fraction(11, 2)),
        closed("z3", fraction(33, 5), fraction(357, 50)),
    ];
    let family = over(
        &slab::slab(),
        sides.to_vec(),
        |i, j, x| match (i, j) {
            // One unit of height; the slab has tenths.
            (2, 2) => rational(1, 1),
            _ => constant(x),
        },
        |k, x| match k {
            2 => slab::height(x, [&z1, &z2, &z3]).unwrap_or_else(|| constant(x)),
            _ => constant(x),
        },
    );
    Ok(AnyFamily::Space(family))
}

/// The slab with the paper's heights over a grid with the squared side w. The paper's is 36.
pub fn slab_stretch() -> Built {
    let w = Polynomial::parameter(0);
    let side = open("w", fraction(100, 3), fraction(64, 1));
    let family = over(
        &slab::slab(),
        vec![side],
        |i, j, x| match (i, j) {
            (2, 2) => constant(x),
            _ => w.times(&constant(&(x * &fraction(1, 36)))),
        },
        |_, x| constant(x),
    );
    Ok(AnyFamily::Space(family))
}

/// A structure with a vertical axis, period 4 as the side: its squared height times t = (c/a)².
fn stretched(structure: &Tiling<3>, low: Number, high: Number) -> Built {
    let t = Polynomial::parameter(0);
    let gram = |i: usize, j: usize, x: &Number| match (i, j) {
        (2, 2) => t.times(&constant(x)),
        _ => constant(x),
    };
    let family = over(structure, vec![open("t", low, high)], gram, |_, x| {
        constant(x)
    });
    Ok(AnyFamily::Space(family))
}

/// Z, stretched.
pub fn z() -> Built {
    stretched(
        &plane_tiling::triangles().structure()?,
        fraction(1, 2),
        fraction(3, 1),
    )
}

/// A15, stretched.
pub fn a15() -> Built {
    stretched(
        &plane_tiling::squares().structure()?,
        fraction(2, 5),
        fraction(16, 5),
    )
}

/// C14 with its three free numbers c2 = (c/a)², z and x. The ideal member is a corner of the box.
pub fn c14() -> Built {
    let [c2, z, x] = [0, 1, 2].map(Polynomial::parameter);
    let zero = || rational(0, 1);
    let [third, half, quarter] = [3, 2, 4].map(|n| rational(1, n));
    let (two_thirds, three_quarters) = (rational(2, 3), rational(3, 4));
    let (twice, minus) = (x.plus(&x), x.negated());
    let minus_twice = twice.negated();
    let points = [
        [third.clone(), two_thirds.clone(), z.clone()],
        [two_thirds.clone(), third.clone(), z.negated()],
        [two_thirds.clone(), third.clone(), half.plus(&z)],
        [third, two_thirds, half.minus(&z)],
        [zero(), zero(), zero()],
        [zero(), zero(), half],
        [x.clone(), twice.clone(), quarter.clone()],
        [minus_twice.clone(), minus.clone(), quarter.clone()],
        [x.clone(), minus.clone(), quarter],
        [minus.clone(), minus_twice, three_quarters.clone()],
        [twice, x.clone(), three_quarters.clone()],
        [minus, x, three_quarters],
    ];
    let gram = [
        [rational(1, 1), rational(-1, 2), zero()],
        [rational(-1, 2), rational(1, 1), zero()],
        [zero(), zero(), c2],
    ];
    let parameters = vec![
        closed("c2", fraction(8, 3), fraction(8727, 2500)),
        closed("z", fraction(59, 1000), fraction(1, 16)),
        closed("x", fraction(7939, 10000), fraction(5, 6)),
    ];
    let ideal = [fraction(8, 3), fraction(1, 16), fraction(5, 6)];
    let member = PointSet {
        frame: Frame::space(
            Field::rationals(),
            gram.each_ref()
                .map(|row| row.each_ref().map(|p| p.value(&ideal))),
        ),
        points: points
            .iter()
            .map(|point| point.each_ref().map(|p| p.value(&ideal)))
            .collect(),
    };
    let tiling = triangulate(&member, Ties::Refuse)?;
    let family = free::over_points(&tiling, &member.points, parameters, gram, points.to_vec());
    family.map(AnyFamily::Space).ok_or(CatalogError::Degenerate)
}
