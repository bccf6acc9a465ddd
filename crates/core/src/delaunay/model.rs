//! A point set made ready: lattice reduced, points moved into the reduced cell,
//! exact coordinates, doubles with error bounds, and the search tree.
//!
//! Here lives the translation between the caller's indices and basis and the ones
//! of the search.

use super::DelaunayError;
use super::lattice::{Orthogonal, Reduced, reduce};
use super::places::Places;
use super::tree::{Ball, Tree, tree_order};
use crate::parallel;
use crate::tiling::{Corner, Frame, PointSet, SHIFT_LIMIT, Tiling, VertexId};
use acutile_exact::number::Number;
use malachite::{Integer, Rational};

/// The number of witness points after the points of the set, see [`Model::witness`].
pub const WITNESSES: usize = 4;

/// A point set in reduced coordinates. Its corners number the points in
/// tree order and take shifts in the reduced basis.
#[derive(Clone, Debug)]
pub struct Model<const D: usize> {
    pub lattice: Reduced<D>,
    /// The caller's index of each point.
    pub names: Vec<u32>,
    /// By caller's index: the points moved into 0 <= x < 1, in the caller's basis.
    pub vertices: Vec<[Number; D]>,
    /// In the reduced basis, 0 <= x < 1; then the witnesses. There are no simplices.
    pub points: Tiling<D>,
    /// The vector that was subtracted from the reduced coordinates of the vertex.
    offsets: Vec<[i64; D]>,
    pub places: Places<D>,
    pub tree: Tree<D>,
}

impl<const D: usize> Model<D> {
    /// The model of a point set in which no two points coincide.
    pub fn new(set: &PointSet<D>) -> Result<Self, DelaunayError> {
        if set.points.is_empty() {
            return Err(DelaunayError::Empty);
        }
        let lattice = reduce(&set.frame.gram)?;
        let orthogonal = Orthogonal::of(&lattice.gram).ok_or(DelaunayError::NotPositiveDefinite)?;
        let vertices: Vec<_> = parallel::map(set.points.len(), |k| fractional_part(&set.points[k]));
        let placed = |k: usize| {
            let (point, offset) = split(&lattice.coordinates(&vertices[k]));
            Ok((point, small(offset)?))
        };
        let placed = parallel::map(vertices.len(), placed).into_iter();
        let (points, offsets): (Vec<_>, Vec<_>) = placed
            .collect::<Result<Vec<_>, DelaunayError>>()?
            .into_iter()
            .unzip();
        let lengths = std::array::from_fn(|k| orthogonal.norms[k].approximate().sqrt());
        let fractions: Vec<_> = parallel::map(points.len(), |k| approximate(&points[k]));
        let names = tree_order(&fractions, &lengths);
        let mut points: Vec<_> = names.iter().map(|&i| points[i as usize].clone()).collect();
        let offsets = names.iter().map(|&i| offsets[i as usize]).collect();
        points.extend((0..WITNESSES).map(witness));
        let approximate = |k: usize| approximate(&points[k]);
        let places = Places::new(parallel::map(points.len(), approximate), &orthogonal)?;
        let tree = Tree::new(&places, names.len());
        let points = Tiling {
            frame: Frame::space(set.frame.field.clone(), lattice.gram.clone()),
            vertices: points.into(),
            corners: Vec::new(),
        };
        let model = Model {
            lattice,
            names,
            vertices,
            points,
            offsets,
            places,
            tree,
        };
        check_distinct(&model)?;
        Ok(model)
    }

    /// The corner of the i-th witness: a point in the interior of the reduced cell. Its denominator is
    /// large, so that it is in general position to points that occur.
    pub fn witness(&self, i: usize) -> Corner<D> {
        Corner::of((self.names.len() + i) as u32)
    }

    /// A corner in the caller's terms.
    ///
    /// The point of the corner is x - offset + shift for x the reduced coordinates
    /// of the vertex, so the vertex was moved by shift - offset.
    pub fn original(&self, corner: &Corner<D>) -> Result<Corner<D>, DelaunayError> {
        let offset = &self.offsets[corner.vertex.index()];
        let shift = std::array::from_fn(|k| i64::from(corner.shift[k]) - offset[k]);
        let moved = self.lattice.original(shift);
        if moved
            .iter()
            .any(|entry| entry.abs() > i64::from(SHIFT_LIMIT))
        {
            return Err(DelaunayError::TooSkewed);
        }
        Ok(Corner {
            vertex: self.names[corner.vertex.index()].into(),
            shift: moved.map(|entry| entry as i32),
        })
    }

    /// The exact position of a corner in the reduced basis.
    pub fn position(&self, corner: &Corner<D>) -> [Number; D] {
        let point = self.points.vertices.vertex(corner.vertex);
        std::array::from_fn(|k| &point[k] + &Number::from(Rational::from(corner.shift[k])))
    }
}

/// All witnesses have one denominator, a prime, so that the common denominator of all points
/// stays short.
fn witness<const D: usize>(i: usize) -> [Number; D] {
    const PRIME: u32 = 65_521;
    const NUMERATORS: [[u32; 3]; WITNESSES] = [
        [21_611, 27_749, 33_587],
        [30_319, 16_487, 43_793],
        [14_543, 39_461, 25_037],
        [46_901, 34_877, 18_911],
    ];
    std::array::from_fn(|k| Number::from(Rational::from_unsigneds(NUMERATORS[i][k], PRIME)))
}

fn approximate<const D: usize>(x: &[Number; D]) -> [f64; D] {
    std::array::from_fn(|k| x[k].approximate())
}

/// Fractional and integer parts of the coordinates.
fn split<const D: usize>(x: &[Number; D]) -> ([Number; D], [Integer; D]) {
    let whole: [Integer; D] = std::array::from_fn(|k| x[k].floor());
    let rest = std::array::from_fn(|k| &x[k] - &Number::from(Rational::from(&whole[k])));
    (rest, whole)
}

fn fractional_part<const D: usize>(x: &[Number; D]) -> [Number; D] {
    split(x).0
}

fn small<const D: usize>(offset: [Integer; D]) -> Result<[i64; D], DelaunayError> {
    let mut small = [0; D];
    for (entry, value) in small.iter_mut().zip(&offset) {
        *entry = i64::try_from(value).map_err(|_| DelaunayError::TooSkewed)?;
    }
    Ok(small)
}

/// Refuses points that differ by a lattice vector: of the corners that the doubles
/// cannot tell from a point, none has the same exact position.
fn check_distinct<const D: usize>(model: &Model<D>) -> Result<(), DelaunayError> {
    let ball = Ball {
        center: [0.0; D],
        radius: model.places.resolution(),
    };
    let mut near = Vec::new();
    for vertex in (0..model.names.len() as u32).map(VertexId::new) {
        let corner = Corner::of(vertex);
        model
            .tree
            .gather(&model.places, &corner, ball, usize::MAX, &mut near)?;
        let twin = near
            .iter()
            .find(|p| p.vertex != vertex && model.position(p) == model.position(&corner));
        if let Some(twin) = twin {
            let [a, b] = [vertex, twin.vertex].map(|v| model.names[v.index()] as usize);
            return Err(DelaunayError::Coincident(a.min(b), a.max(b)));
        }
    }
    Ok(())
}
