//! Radius-edge ratios and dihedral angles as exact objects. Each is determined by a number of the field. So
//! two of them are compared exactly, and each is enclosed as tightly as asked.

use super::closed_form;
use acutile_exact::geometry::{NormalProducts, Sign, Simplex, linear};
use acutile_exact::number::{Number, enclosure};
use malachite::Rational;
use std::cmp::Ordering;

/// A real number that is known exactly, and that has bounds and perhaps a name.
pub trait Exact: Ord + Clone {
    /// Rational bounds at most `width` > 0 apart; degrees for angles.
    fn enclosure(&self, width: &Rational) -> (Rational, Rational);
    /// The value in closed form, where there is a short one.
    fn closed_form(&self) -> Option<String>;
    /// The value itself where it is rational and recognised.
    fn rational(&self) -> Option<Rational>;
}

/// Circumradius over shortest edge.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct RadiusEdge {
    /// Its square.
    pub square: Number,
}

impl RadiusEdge {
    /// Of a simplex in a basis with this Gram matrix; `None` if it is flat.
    ///
    /// The circumcentre is corner 0 plus x with e_i · x = |e_i|²/2 for all edges
    /// e_i from there. With M the Gram matrix of the edges and l_i = |e_i|² this
    /// gives R² = l^T M^-1 l / 4.
    pub fn of<const D: usize>(
        simplex: &Simplex<Number, D>,
        gram: &[[Number; D]; D],
    ) -> Option<Self> {
        let products: [[Number; D]; D] = std::array::from_fn(|i| {
            let image = linear::apply(gram, &simplex.edges[i]);
            std::array::from_fn(|j| linear::dot(&image, &simplex.edges[j]))
        });
        let lengths: [Number; D] = std::array::from_fn(|i| products[i][i].clone());
        let numerator = linear::square(&linear::cofactors(&products), &lengths);
        let denominator = linear::determinant(&products) * Number::from(Rational::from(4));
        let between = |i: usize, j: usize| {
            linear::square(
                gram,
                &linear::subtract(&simplex.edges[i], &simplex.edges[j]),
            )
        };
        let others = (0..D).flat_map(|i| (i + 1..D).map(move |j| (i, j)));
        let shortest = lengths
            .iter()
            .cloned()
            .chain(others.map(|(i, j)| between(i, j)))
            .min()?;
        let square = numerator.divide(&(denominator * shortest))?;
        Some(RadiusEdge { square })
    }
}

impl Exact for RadiusEdge {
    fn enclosure(&self, width: &Rational) -> (Rational, Rational) {
        match self.rational() {
            Some(value) => (value.clone(), value),
            None => self.square.enclosure_of_root(width),
        }
    }

    fn closed_form(&self) -> Option<String> {
        closed_form::root(&self.square)
    }

    fn rational(&self) -> Option<Rational> {
        closed_form::rational_root(&self.square)
    }
}

/// A dihedral angle t of a simplex, 0 < t < 180 degrees; in the plane an angle of a
/// triangle. Angles are ordered by size.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DihedralAngle {
    /// The sign of cos t times cos² t, which falls strictly as t grows.
    pub signed_square: Number,
}

impl DihedralAngle {
    /// Between two facets: cos t = -p / √q with p = <g_i, g_j> and
    /// q = <g_i, g_i> <g_j, g_j>; `None` if a facet is degenerate.
    pub fn between<const D: usize>(
        products: &NormalProducts<Number, D>,
        i: usize,
        j: usize,
    ) -> Option<Self> {
        let p = products.get(i, j);
        let square = (p * p).divide(&(products.get(i, i) * products.get(j, j)))?;
        let is_obtuse = p.sign() == Sign::Greater;
        let signed_square = if is_obtuse { -square } else { square };
        Some(DihedralAngle { signed_square })
    }

    /// The angle whose cosine has this square with this sign.
    pub fn of_rational(signed_square: Rational) -> Self {
        DihedralAngle {
            signed_square: Number::from(signed_square),
        }
    }

    /// Less, equal or greater than a right angle.
    pub fn against_right(&self) -> Ordering {
        self.signed_square.sign().reverse()
    }
}

impl PartialOrd for DihedralAngle {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for DihedralAngle {
    fn cmp(&self, other: &Self) -> Ordering {
        other.signed_square.cmp(&self.signed_square)
    }
}

impl Exact for DihedralAngle {
    fn enclosure(&self, width: &Rational) -> (Rational, Rational) {
        if let Some(degrees) = self.rational() {
            return (degrees.clone(), degrees);
        }
        let square = self.signed_square.abs();
        let is_acute = self.against_right() == Ordering::Less;
        let mut precision = width / Rational::from(1000);
        loop {
            let (low, high) = square.enclosure_of_root(&precision);
            let (low, high) = if is_acute { (low, high) } else { (-high, -low) };
            let degrees = enclosure::acos_degrees(&low, &high, width);
            // Near 0 and 180 degrees the arc cosine magnifies without bound.
            if &degrees.1 - &degrees.0 <= *width || precision < FINEST_COSINE {
                return degrees;
            }
            precision /= Rational::from(1000);
        }
    }

    fn closed_form(&self) -> Option<String> {
        closed_form::angle(&self.signed_square)
    }

    fn rational(&self) -> Option<Rational> {
        closed_form::whole_degrees(&self.signed_square)
    }
}

/// No cosine is enclosed more tightly; only an angle within about 1e-30 degrees of
/// 0 or 180 comes here.
const FINEST_COSINE: f64 = 1e-60;
