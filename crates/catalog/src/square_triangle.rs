//! Section 4.1: from an edge-to-edge tiling of the plane by squares and equilateral
//! triangles to a TCP structure.
//!
//! The paper marks black and white dots on the plane tiling with side 4. It puts points at heights 4k - 1
//! over black dots, 4k + 1 over white ones, 4k and 4k + 2 over vertices. *The rule of the colours.* All
//! edges have directions that are multiples of 30 degrees from one of them; call an edge black if the
//! multiple is even. Then the edges of a triangle, 60 degrees apart, have one colour. Neighbouring edges of
//! a square, 90 degrees apart, differ. Nothing depends on the choice of the cell. There are three kinds of
//! dots. The middle of an edge has the edge's colour. The centre of a triangle has the other colour than
//! its edges. A square has a dot for each side: the middle of the side moved inwards by 1, in the other
//! colour than the side.

use super::CatalogError;
use super::plane_tiling::{Cyclotomic, POWERS, PlaneTiling, scaled, sum};
use super::recipe::{common_field, quotient};
use acutile_core::delaunay::{Ties, triangulate};
use acutile_core::tiling::{Frame, PointSet, Tiling};
use acutile_exact::geometry::linear;
use acutile_exact::number::{Field, Number};
use malachite::{Integer, Rational};

impl PlaneTiling {
    /// The structure over the plane tiling.
    ///
    /// # Errors
    /// Where the tiling is not one, or the points have no Delaunay triangulation.
    pub fn structure(&self) -> Result<Tiling<3>, CatalogError> {
        Ok(triangulate(&self.point_set()?, Ties::Refuse)?)
    }

    /// The vertices of the structure: side 4.
    ///
    /// # Errors
    /// As for [`PlaneTiling::structure`].
    pub fn point_set(&self) -> Result<PointSet<3>, CatalogError> {
        lifted(self, &Rational::from(16), 12, &self.points()?)
    }

    /// The points of the structure over one cell: 12 times the place in the plane, and
    /// the height.
    ///
    /// # Errors
    /// Where the tiling is not one.
    pub fn points(&self) -> Result<Vec<(Cyclotomic, i64)>, CatalogError> {
        let dot = |black: bool| if black { -1 } else { 1 };
        // First, for it bounds the entries.
        let stars = self.stars()?;
        let mut points = Vec::new();
        for &vertex in &self.vertices {
            points.extend([(scaled(vertex, 12), 0), (scaled(vertex, 12), 2)]);
        }
        let corners = self.vertices.iter().zip(&stars);
        for (&vertex, tile) in corners.flat_map(|(v, star)| star.iter().map(move |t| (v, t))) {
            let k = tile.direction;
            let (corner, black) = (scaled(vertex, 12), k % 2 == 0);
            let middle = sum(corner, scaled(POWERS[k], 6));
            // An edge has two ends, a triangle three corners: one of them has a small k. A
            // square has a corner for each side.
            if k < 6 {
                points.push((middle, dot(black)));
            }
            if tile.is_square() {
                points.push((sum(middle, scaled(POWERS[(k + 3) % 12], 3)), dot(!black)));
            } else if k < 4 {
                let center = sum(scaled(POWERS[k], 4), scaled(POWERS[k + 2], 4));
                points.push((sum(corner, center), dot(!black)));
            }
        }
        Ok(points)
    }
}

/// The points over a plane tiling of side l, given by the square of l, with period 4 in height. `points`
/// are `scale` times the place in the plane, in units of l, and the height.
///
/// # Errors
/// If the lattice vectors are parallel.
pub fn lifted(
    plane: &PlaneTiling,
    side_square: &Rational,
    scale: i64,
    points: &[(Cyclotomic, i64)],
) -> Result<PointSet<3>, CatalogError> {
    let root = square_root_of_3()?;
    let [a, b] = plane.lattice.map(|x| cartesian(x, &root));
    let number = |x: Rational| Number::from(x);
    let cross = |rows: [&[Number; 2]; 2]| linear::determinant(&rows.map(Clone::clone));
    let area = &cross([&a, &b]) * &number(Rational::from(scale));
    let fractional = |&(place, height): &(Cyclotomic, i64)| {
        let x = cartesian(place, &root);
        let s = quotient(&cross([&x, &b]), &area)?;
        let t = quotient(&cross([&a, &x]), &area)?;
        Ok([s, t, number(Rational::from_signeds(height, 4))])
    };
    let points: Vec<[Number; 3]> = points
        .iter()
        .map(fractional)
        .collect::<Result<_, CatalogError>>()?;
    let inner = |x: &[Number; 2], y: &[Number; 2]| {
        &number(side_square.clone()) * &(&(&x[0] * &y[0]) + &(&x[1] * &y[1]))
    };
    let ab = inner(&a, &b);
    let zero = Number::zero;
    let gram = [
        [inner(&a, &a), ab.clone(), zero()],
        [ab, inner(&b, &b), zero()],
        [zero(), zero(), number(Rational::from(16))],
    ];
    let field = common_field(gram.iter().chain(&points).flatten());
    Ok(PointSet {
        frame: Frame::space(field, gram),
        points,
    })
}

pub(super) fn square_root_of_3() -> Result<Number, CatalogError> {
    let polynomial = [-3, 0, 1].map(Integer::from);
    let (_, root) = Field::adjoin_root(&polynomial, Rational::from(1), Rational::from(2))?;
    Ok(root)
}

/// z = (sqrt 3 + i)/2, z² = (1 + i sqrt 3)/2, z³ = i.
pub(super) fn cartesian(x: Cyclotomic, root: &Number) -> [Number; 2] {
    let [a, b, c, d] = x.map(|entry| Number::from(Rational::from(entry)));
    let half = Number::from(Rational::from_signeds(1, 2));
    let real = &a + &(&half * &(&(&b * root) + &c));
    let imaginary = &d + &(&half * &(&b + &(&c * root)));
    [real, imaginary]
}
