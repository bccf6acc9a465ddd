//! Section 4.2: regular icosahedra with a vertical 3-fold axis, touching edge to edge
//! in hexagonal layers, the layers sharing horizontal faces.
//!
//! Edge length 2. Let q_0, q_1, q_2 be the corners of an equilateral triangle of side 2 in the plane around
//! the origin, and phi the golden ratio. The vertices of the icosahedron lie over q_i at the height
//! phi²/sqrt 3, over -phi q_i at 1/(phi sqrt 3), and opposite to these twelve minus six. Six edges go from
//! an upper end U over -phi q_i to a lower end L over phi q_j. The opposite edge goes from -L to -U. So the
//! neighbour that touches there is moved by U + L = phi (q_j - q_i). These vectors span the lattice of the
//! layer. A layer that shares horizontal faces with this one is its mirror image: the period is two layers,
//! 4 phi²/sqrt 3. With that as the unit of height all numbers lie in Q(sqrt 5).

use super::CatalogError;
use super::recipe::{fraction, quotient};
use acutile_core::delaunay::{Ties, triangulate};
use acutile_core::tiling::{Frame, PointSet, Tiling};
use acutile_exact::number::{Field, Number};
use malachite::{Integer, Rational};

/// The Delaunay triangulation of the vertices and centres of all icosahedra.
pub fn icosahedral() -> Result<Tiling<3>, CatalogError> {
    Ok(triangulate(&points()?, Ties::Refuse)?)
}

fn points() -> Result<PointSet<3>, CatalogError> {
    let polynomial = [-1, -1, 1].map(Integer::from);
    let (field, phi) = Field::adjoin_root(&polynomial, Rational::from(1), Rational::from(2))?;
    Ok(PointSet {
        points: orbits(&phi)?,
        frame: Frame::space(field, gram(&phi)),
    })
}

/// Of phi (q_1 - q_0), phi (q_2 - q_1) and the period in height: 4 phi², -2 phi², 16 phi⁴/3.
fn gram(phi: &Number) -> [[Number; 3]; 3] {
    let square = phi * phi;
    let (long, short) = (&square * &fraction(4, 1), &square * &fraction(-2, 1));
    let height = &(&square * &square) * &fraction(16, 3);
    let zero = Number::zero;
    [
        [long.clone(), short.clone(), zero()],
        [short, long, zero()],
        [zero(), zero(), height],
    ]
}

/// One point of each orbit. The upper middle ring is one orbit, and so is the lower one.
fn orbits(phi: &Number) -> Result<Vec<[Number; 3]>, CatalogError> {
    let third = quotient(&fraction(1, 3), phi)?;
    // phi q_0, phi q_1, phi q_2 are thirds of these combinations of the basis.
    let corners = [[-2, -1], [1, -1], [1, 2]];
    let ring = quotient(&fraction(1, 4), &(&(phi * phi) * phi))?;
    let half = fraction(1, 2);
    let at = |[x, y]: [i64; 2], scale: &Number, height: Number| {
        [scale * &fraction(x, 1), scale * &fraction(y, 1), height]
    };
    let over =
        |sign: i64, height: Number| at(corners[0].map(|x| sign * x), &fraction(1, 3), height);
    let mut points = vec![
        at([0, 0], &third, Number::zero()),
        at([0, 0], &third, half.clone()),
        over(-1, ring.clone()),
        over(1, &Number::zero() - &ring),
        // The mirror image about the horizontal faces, at 1/4.
        over(-1, &half - &ring),
        over(1, &half + &ring),
    ];
    for corner in corners {
        points.push(at(corner, &third, fraction(1, 4)));
        points.push(at(corner.map(|x| -x), &third, fraction(-1, 4)));
    }
    Ok(points)
}
