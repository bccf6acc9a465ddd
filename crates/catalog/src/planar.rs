//! The plane (section 2): the square cut into 8, 10 and 14 acute triangles (Figure 1),
//! the equilateral triangle tiling, and the tiling by copies of any triangle.

use super::CatalogError;
use super::recipe::{common_field, fraction, quotient, rational_points};
use acutile_core::delaunay::{Ties, triangulate};
use acutile_core::tiling::{Domain, Frame, Polytope, Tiling};
use acutile_exact::number::{Field, Number, numbers};
use malachite::{Integer, Rational};

type Point = [Number; 2];

/// The corners of the unit square in cyclic order; they are points 0 to 3 of every
/// triangulation.
const CORNERS: [[i64; 2]; 4] = [[0, 0], [1, 0], [1, 1], [0, 1]];

/// Figure 1(b), eight triangles: the middles of two sides, and two points inside that are
/// mirror images.
pub fn square_8() -> Tiling<2> {
    let inner = |x| [fraction(x, 23), fraction(19, 100)];
    let points = [
        [fraction(1, 2), fraction(0, 1)],
        [fraction(1, 2), fraction(1, 1)],
        inner(10),
        inner(13),
    ];
    let triangles = [
        [0, 4, 6],
        [4, 7, 6],
        [4, 1, 7],
        [1, 2, 7],
        [2, 5, 7],
        [5, 6, 7],
        [5, 3, 6],
        [3, 0, 6],
    ];
    square(Field::rationals(), &points, &triangles)
}

/// Figure 1(c), ten triangles: points on two adjacent sides, and three inside.
pub fn square_10() -> Tiling<2> {
    let millionths = |p: [i64; 2]| p.map(|x| fraction(x, 1_000_000));
    let points = [
        [573_740, 0],
        [1_000_000, 373_659],
        [790_333, 252_583],
        [514_772, 229_971],
        [741_138, 444_438],
    ]
    .map(millionths);
    let triangles = [
        [0, 7, 3],
        [0, 4, 7],
        [1, 6, 4],
        [1, 5, 6],
        [2, 3, 8],
        [2, 8, 5],
        [3, 7, 8],
        [4, 6, 7],
        [5, 8, 6],
        [6, 8, 7],
    ];
    square(Field::rationals(), &points, &triangles)
}

/// Figure 1(d), fourteen triangles with no angle of more than 72 degrees (Eppstein). It has
/// the symmetry of both diagonals: a point at distance u on each side, two points
/// (t, t) and (1 - t, 1 - t), two (x, 1 - x) and (1 - x, x).
///
/// All five angles at (t, t) are 72 degrees. So one edge goes to (0, 0), and the others lie symmetrically
/// about the diagonal. The edge to (u, 0) is 27 degrees off the vertical: u = t (1 + tan 27). The edge to
/// (x, 1 - x) is 9 degrees off the horizontal: 1 - x - t = (x - t) tan 9. Both tangents lie in Q(tan 9), of
/// degree 4. t = 8/25 is one of the values that leave all other angles below 72.
pub fn square_14() -> Result<Tiling<2>, CatalogError> {
    let polynomial = [1, -4, -14, -4, 1].map(Integer::from);
    let (field, tan_9) = Field::adjoin_root(
        &polynomial,
        Rational::from(0),
        Rational::from_unsigneds(1u8, 5),
    )?;
    let one = fraction(1, 1);
    let square_9 = &tan_9 * &tan_9;
    // tan 3y = tan y (3 - tan² y)/(1 - 3 tan² y)
    let tan_27 = quotient(
        &(&tan_9 * &(&fraction(3, 1) - &square_9)),
        &(&one - &(&fraction(3, 1) * &square_9)),
    )?;
    let t = fraction(8, 25);
    let opposite = &one - &t;
    let u = &t * &(&one + &tan_27);
    let x = quotient(&(&opposite + &(&t * &tan_9)), &(&one + &tan_9))?;
    let (far, low) = (&one - &u, &one - &x);
    let zero = Number::zero;
    let points = [
        [u.clone(), zero()],
        [one.clone(), far.clone()],
        [far, one],
        [zero(), u],
        [t.clone(), t],
        [opposite.clone(), opposite],
        [x.clone(), low.clone()],
        [low, x],
    ];
    let triangles = [
        [0, 4, 8],
        [0, 8, 7],
        [4, 10, 8],
        [7, 8, 11],
        [8, 10, 11],
        [4, 1, 10],
        [1, 5, 10],
        [5, 9, 10],
        [5, 2, 9],
        [2, 6, 9],
        [6, 11, 9],
        [9, 11, 10],
        [6, 3, 11],
        [3, 7, 11],
    ];
    Ok(square(field, &points, &triangles))
}

/// The unit square with further points, from number 4 on.
fn square(field: Field, further: &[Point], triangles: &[[usize; 3]]) -> Tiling<2> {
    let corners = CORNERS.map(|corner| corner.map(|x| fraction(x, 1)));
    let outline = Polytope::polygon(corners.iter().map(|corner| corner.to_vec()).collect());
    let points = [&corners, further].concat();
    let triangles: Vec<Vec<Point>> = triangles
        .iter()
        .map(|triangle| triangle.iter().map(|&k| points[k].clone()).collect())
        .collect();
    let frame = Frame {
        field,
        ..Frame::cubic()
    };
    Tiling::from_positions(frame.with_domain(Domain::Solid(outline)), &triangles)
}

/// The equilateral triangles: the Delaunay triangulation of their lattice.
pub fn equilateral() -> Result<Tiling<2>, CatalogError> {
    let lattice = rational_points([[2, 1], [1, 2]], 1, &[[0, 0]]);
    Ok(triangulate(&lattice, Ties::Refuse)?)
}

/// Copies of the triangle with the sides a, b, c, written `a,b,c`: two of them make a parallelogram,
/// and its translates tile. With v, w two sides from one corner of lengths b, c,
/// v · w = (b² + c² - a²)/2.
pub fn triangle_tiling(sides: &str) -> Result<Tiling<2>, CatalogError> {
    let no_triangle = || CatalogError::NotATriangle(sides.to_owned());
    let texts: Vec<&str> = sides.split(',').collect();
    let sides: [Number; 3] = numbers(&texts)
        .map_err(|error| CatalogError::Number(sides.to_owned(), error))?
        .try_into()
        .map_err(|_| no_triangle())?;
    let [a, b, c] = sides.each_ref().map(|side| side * side);
    let product = &(&(&b + &c) - &a) * &fraction(1, 2);
    let determinant = &(&b * &c) - &(&product * &product);
    if sides.iter().any(|side| side.sign().is_le()) || determinant.sign().is_le() {
        return Err(no_triangle());
    }
    let gram = [[b, product.clone()], [product, c]];
    let field = common_field(gram.iter().flatten());
    let triangle = |corners: [[i64; 2]; 3]| corners.map(|p| p.map(|x| fraction(x, 1))).to_vec();
    Ok(Tiling::from_positions(
        Frame::space(field, gram),
        &[
            triangle([[0, 0], [1, 0], [0, 1]]),
            triangle([[1, 0], [1, 1], [0, 1]]),
        ],
    ))
}
