//! Stacked kagome layers: the Laves phases, Z, and their mixtures (Frank and Kasper,
//! Acta Cryst. 12, 1959). Section 4.1 compares its structures with these.
//!
//! A layer is a hexagonal lattice with a = 4 without every fourth point: the middles of
//! the edges of a larger hexagonal net. Its hexagons are centred at one of three places
//! (registry 0, 1, 2: multiples of (1/3, 2/3)). A word names the layers between one layer
//! and the next:
//!
//! - `z`, height 4, same registry: two points on the hexagon's axis at distance 1 from the
//!   layers, and at mid-height one over each of the other registries;
//! - `+` or `-`, height 4 sqrt(2/3), registry one more or less: three points. They are on the lower
//!   hexagon's axis at 3/8 of the height, on the upper hexagon's axis at 5/8, and at mid-height over the
//!   third registry.
//!
//! `z` is Z, `+` C15, `+-` C14, `++--` C36, `z+` mu.

use super::CatalogError;
use super::limits::WORD_LIMIT;
use super::recipe::{common_field, fraction, quotient};
use acutile_core::delaunay::{Ties, triangulate};
use acutile_core::tiling::{Frame, PointSet, Tiling};
use acutile_exact::number::{Field, Number};
use malachite::{Integer, Rational};

/// A point: the registry or place in the plane, in the basis with 120 degrees, and the height.
type Point = ([Number; 2], Number);

/// The number of blocks of a word.
///
/// # Errors
/// Where it is none.
pub fn blocks(word: &str) -> Result<usize, CatalogError> {
    let is_word = !word.is_empty() && word.chars().all(|letter| "z+-".contains(letter));
    if is_word {
        Ok(word.len())
    } else {
        Err(CatalogError::Word(word.to_owned()))
    }
}

/// The structure of a word.
pub fn kagome(word: &str) -> Result<Tiling<3>, CatalogError> {
    Ok(triangulate(&points(word)?, Ties::Refuse)?)
}

/// The vertices of the structure of a word.
pub fn points(word: &str) -> Result<PointSet<3>, CatalogError> {
    if word.is_empty() || word.len() > WORD_LIMIT {
        return Err(CatalogError::Word(word.to_owned()));
    }
    let low = laves_height()?;
    let (mut registry, mut height) = (0, Number::zero());
    let mut points: Vec<Point> = Vec::new();
    for letter in word.chars() {
        points.extend(layer(registry).map(|place| (place, height.clone())));
        let (step, size, block) = match letter {
            'z' => (0, fraction(4, 1), z_block(registry)),
            '+' => (1, low.clone(), laves_block(registry, 1, &low)),
            '-' => (-1, low.clone(), laves_block(registry, -1, &low)),
            _ => return Err(CatalogError::Word(word.to_owned())),
        };
        points.extend(block.into_iter().map(|(r, h)| (axis(r), &height + &h)));
        registry += step;
        height = &height + &size;
    }
    in_lattice(&points, &axis(registry.rem_euclid(3)), &height)
}

/// The lattice has two vectors of length 4 in the plane. The third goes from the first layer to the first
/// of the next period, and may lean by `lean`.
fn in_lattice(
    points: &[Point],
    lean: &[Number; 2],
    height: &Number,
) -> Result<PointSet<3>, CatalogError> {
    let [x, y] = lean;
    let image = [
        &(&fraction(16, 1) * x) - &(&fraction(8, 1) * y),
        &(&fraction(16, 1) * y) - &(&fraction(8, 1) * x),
    ];
    let square = &(&(&image[0] * x) + &(&image[1] * y)) + &(height * height);
    let gram = [
        [fraction(16, 1), fraction(-8, 1), image[0].clone()],
        [fraction(-8, 1), fraction(16, 1), image[1].clone()],
        [image[0].clone(), image[1].clone(), square],
    ];
    let mut coordinates = Vec::new();
    for (place, h) in points {
        let t = quotient(h, height)?;
        coordinates.push([&place[0] - &(&t * x), &place[1] - &(&t * y), t]);
    }
    let field = common_field(gram.iter().chain(&coordinates).flatten());
    Ok(PointSet {
        frame: Frame::space(field, gram),
        points: coordinates,
    })
}

/// The place of a registry.
pub(super) fn axis(registry: i64) -> [Number; 2] {
    [fraction(registry, 3), fraction(2 * registry, 3)]
}

/// The points of a layer around its hexagon's centre.
fn layer(registry: i64) -> [[Number; 2]; 3] {
    let center = axis(registry);
    [[1, 0], [0, 1], [1, 1]]
        .map(|place| std::array::from_fn(|k| &center[k] + &fraction(place[k], 2)))
}

/// Registries and heights over the lower layer.
fn z_block(r: i64) -> Vec<(i64, Number)> {
    let at = |registry, height| (registry, fraction(height, 1));
    vec![at(r, 1), at(r, 3), at(r + 1, 2), at(r + 2, 2)]
}

fn laves_block(r: i64, step: i64, height: &Number) -> Vec<(i64, Number)> {
    let at = |registry, eighths| (registry, height * &fraction(eighths, 8));
    vec![at(r, 3), at(r + step, 5), at(r - step, 4)]
}

/// 4 sqrt(2/3) = 4 sqrt(6)/3
pub(super) fn laves_height() -> Result<Number, CatalogError> {
    let polynomial = [-6, 0, 1].map(Integer::from);
    let (_, root) = Field::adjoin_root(&polynomial, Rational::from(2), Rational::from(3))?;
    Ok(&root * &fraction(4, 3))
}
