//! How recipes are written down: numbers as texts, points as rows of them.

use super::CatalogError;
use crate::delaunay::{Ties, triangulate};
use crate::number::{Field, Number, ReadError, Reader};
use crate::tiling::{Frame, PointSet, Tiling};

/// The Delaunay triangulation of points given by their coordinates in the basis
/// with this Gram matrix, all of space.
pub fn delaunay<const D: usize>(
    gram: [[&str; D]; D],
    points: &[[&str; D]],
) -> Result<Tiling<D>, CatalogError> {
    let rows = read(gram.iter().chain(points))?;
    let field_of = |rows: &[[Number; D]]| {
        rows.iter()
            .flatten()
            .find_map(|number| number.field().cloned())
            .unwrap_or_else(Field::rationals)
    };
    let (gram, points) = rows.split_at(D);
    let frame = Frame::space(field_of(&rows), std::array::from_fn(|i| gram[i].clone()));
    Ok(triangulate(
        &PointSet {
            frame,
            points: points.to_vec(),
        },
        Ties::Refuse,
    )?)
}

/// Rows of numbers, all in one field.
pub fn read<'t, const D: usize>(
    rows: impl Iterator<Item = &'t [&'t str; D]> + Clone,
) -> Result<Vec<[Number; D]>, ReadError> {
    let mut reader = Reader::new();
    for text in rows.clone().flatten() {
        reader.learn(text)?;
    }
    let mut read = Vec::new();
    for row in rows {
        let numbers: Result<Vec<Number>, ReadError> =
            row.iter().map(|text| reader.value(text)).collect();
        let numbers = numbers?;
        read.push(std::array::from_fn(|k| numbers[k].clone()));
    }
    Ok(read)
}
