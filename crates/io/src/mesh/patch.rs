//! All whole simplices of a tiling in a ball around the origin.

use acutile_core::tiling::{Corner, Domain, Frame, Tiling, VertexId};
use acutile_exact::geometry::linear;
use acutile_exact::number::Number;
use malachite::Rational;
use std::collections::HashMap;

/// No patch looks at more translates of tetrahedra.
const MOST: f64 = 5e6;

/// The simplices of a tiling, translates included, with all corners at most `radius` away from the
/// origin. This is decided exactly. They are a bounded mesh in the same basis.
///
/// # Errors
/// Where there is none, or the ball holds too many.
pub fn patch<const D: usize>(tiling: &Tiling<D>, radius: &Rational) -> Result<Tiling<D>, String> {
    let reach = reach(tiling, radius);
    let mut patch = Patch {
        tiling,
        square: Number::from(radius * radius),
        indices: HashMap::new(),
        vertices: Vec::new(),
    };
    let mut corners = Vec::new();
    let mut work = 0.0;
    for simplex in tiling.simplices() {
        let ranges = ranges(tiling, simplex[0], reach);
        let counts = ranges.iter().map(|(low, high)| (high - low + 1.0).max(0.0));
        work += counts.product::<f64>();
    }
    if work.is_nan() || work > MOST {
        return Err(format!(
            "the ball of radius {radius} holds too many simplices, more than {MOST}"
        ));
    }
    for simplex in tiling.simplices() {
        let ranges = ranges(tiling, simplex[0], reach);
        for step in steps(ranges) {
            let moved: Option<Vec<VertexId>> = simplex
                .iter()
                .map(|corner| patch.vertex(corner.moved(step)))
                .collect();
            corners.extend(moved.into_iter().flatten().map(Corner::of));
        }
    }
    if corners.is_empty() {
        return Err(format!(
            "no whole simplex lies within {radius} of the origin, expected a larger radius"
        ));
    }
    let frame = tiling.frame.clone().with_domain(Domain::Region(0));
    Ok(used_only(frame, &patch.vertices, corners))
}

/// R √(G^-1)_kk, about: no basis coordinate of a point in the ball is larger.
fn reach<const D: usize>(tiling: &Tiling<D>, radius: &Rational) -> [f64; D] {
    let determinant = linear::determinant(&tiling.frame.gram).approximate();
    let cofactors = linear::cofactors(&tiling.frame.gram);
    let radius = Number::from(radius.clone()).approximate();
    std::array::from_fn(|k| radius * (cofactors[k][k].approximate() / determinant).sqrt())
}

/// The lattice vectors that may move a corner into the ball, with a margin for rounding.
fn ranges<const D: usize>(
    tiling: &Tiling<D>,
    corner: Corner<D>,
    reach: [f64; D],
) -> [(f64, f64); D] {
    let vertex = tiling.vertices.vertex(corner.vertex);
    std::array::from_fn(|k| {
        let at = vertex[k].approximate() + f64::from(corner.shift[k]);
        let reach = reach[k] * (1.0 + 1e-9) + 1e-6;
        if k < tiling.frame.rank() {
            ((-reach - at).ceil(), (reach - at).floor())
        } else {
            (0.0, 0.0)
        }
    })
}

fn steps<const D: usize>(ranges: [(f64, f64); D]) -> impl Iterator<Item = [i32; D]> {
    let mut steps = vec![[0; D]];
    for k in 0..D {
        let range = ranges[k].0 as i32..=ranges[k].1 as i32;
        let longer = |step: [i32; D]| {
            range.clone().map(move |entry| {
                let mut longer = step;
                longer[k] = entry;
                longer
            })
        };
        steps = steps.into_iter().flat_map(longer).collect();
    }
    steps.into_iter()
}

struct Patch<'a, const D: usize> {
    tiling: &'a Tiling<D>,
    square: Number,
    indices: HashMap<Corner<D>, Option<VertexId>>,
    vertices: Vec<[Number; D]>,
}

impl<const D: usize> Patch<'_, D> {
    /// The vertex at a corner, if it lies in the ball.
    fn vertex(&mut self, corner: Corner<D>) -> Option<VertexId> {
        if let Some(known) = self.indices.get(&corner) {
            return *known;
        }
        let position = self.tiling.position(&corner);
        let square = linear::square(&self.tiling.frame.gram, &position);
        let vertex = (square <= self.square).then(|| {
            self.vertices.push(position);
            VertexId::at(self.vertices.len() - 1)
        });
        self.indices.insert(corner, vertex);
        vertex
    }
}

/// Without the vertices that are no corners.
fn used_only<const D: usize>(
    frame: Frame<D>,
    points: &[[Number; D]],
    mut corners: Vec<Corner<D>>,
) -> Tiling<D> {
    let mut renumbered: HashMap<VertexId, VertexId> = HashMap::new();
    let mut vertices: Vec<[Number; D]> = Vec::new();
    for corner in &mut corners {
        let old = corner.vertex;
        corner.vertex = *renumbered.entry(old).or_insert_with(|| {
            vertices.push(points[old.index()].clone());
            VertexId::at(vertices.len() - 1)
        });
    }
    Tiling {
        frame,
        vertices: vertices.into(),
        corners,
    }
}
