//! All whole tetrahedra of a tiling in a ball around the origin.

use crate::geometry::linear;
use crate::number::Number;
use crate::tiling::{Corner, Domain, Frame, Tiling};
use malachite::Rational;
use std::collections::HashMap;

/// No patch looks at more translates of vertices.
const MOST: f64 = 2e7;

/// The tetrahedra of a tiling, translates included, whose corners are at most `radius` away
/// from the origin, decided exactly; a bounded mesh in the same basis.
///
/// # Errors
/// Where there is none, or the ball holds too many.
pub fn patch(tiling: &Tiling<3>, radius: &Rational) -> Result<Tiling<3>, String> {
    let reach = reach(tiling, radius)?;
    let mut patch = Patch {
        tiling,
        square: Number::from(radius * radius),
        indices: HashMap::new(),
        vertices: Vec::new(),
    };
    let mut corners = Vec::new();
    for simplex in tiling.simplices() {
        // The translates that may have the first corner in the ball.
        let first = simplex[0].shift;
        for step in steps(reach) {
            let step = crate::tiling::difference(step, first);
            let moved: Option<Vec<u32>> = simplex
                .iter()
                .map(|c| patch.vertex(c.moved(step)))
                .collect();
            corners.extend(moved.into_iter().flatten().map(Corner::of));
        }
    }
    if corners.is_empty() {
        return Err(format!("no tetrahedron lies within {radius} of the origin"));
    }
    let frame = tiling.frame.clone().with_domain(Domain::Region);
    Ok(used_only(frame, &patch.vertices, corners))
}

/// Bounds of the shifts in each direction: |f_k| <= R √(G^-1)_kk for a point with the basis
/// coordinates f in the ball, so a shift is at most that and |x_k| of the vertex x.
fn reach(tiling: &Tiling<3>, radius: &Rational) -> Result<[i32; 3], String> {
    let determinant = linear::determinant(&tiling.frame.gram).approximate();
    let cofactors = linear::cofactors(&tiling.frame.gram);
    let radius = Number::from(radius.clone()).approximate();
    let rank = tiling.frame.rank();
    let bound = |k: usize| {
        let width = (cofactors[k][k].approximate() / determinant).sqrt();
        let farthest = tiling
            .vertices
            .iter()
            .map(|v| v[k].approximate().abs())
            .fold(0.0, f64::max);
        match k < rank {
            true => (radius * width * (1.0 + 1e-9) + farthest + 1.0).ceil(),
            false => 0.0,
        }
    };
    let bounds = [bound(0), bound(1), bound(2)];
    let translates: f64 = bounds.iter().map(|bound| 2.0 * bound + 1.0).product();
    let work = translates * tiling.len() as f64;
    if work.is_nan() || work > MOST {
        return Err(format!(
            "the ball of radius {radius} holds too many tetrahedra"
        ));
    }
    Ok(bounds.map(|bound| bound as i32))
}

fn steps(reach: [i32; 3]) -> impl Iterator<Item = [i32; 3]> {
    let range = move |k: usize| -reach[k]..=reach[k];
    let plane = move |c| range(1).flat_map(move |b| range(0).map(move |a| [a, b, c]));
    range(2).flat_map(plane)
}

struct Patch<'a> {
    tiling: &'a Tiling<3>,
    square: Number,
    indices: HashMap<Corner<3>, Option<u32>>,
    vertices: Vec<[Number; 3]>,
}

impl Patch<'_> {
    /// The vertex at a corner, if it lies in the ball.
    fn vertex(&mut self, corner: Corner<3>) -> Option<u32> {
        if let Some(known) = self.indices.get(&corner) {
            return *known;
        }
        let position = self.tiling.position(&corner);
        let square = linear::square(&self.tiling.frame.gram, &position);
        let vertex = (square <= self.square).then(|| {
            self.vertices.push(position);
            self.vertices.len() as u32 - 1
        });
        self.indices.insert(corner, vertex);
        vertex
    }
}

/// Without the vertices that are no corners.
fn used_only(frame: Frame<3>, points: &[[Number; 3]], mut corners: Vec<Corner<3>>) -> Tiling<3> {
    let mut renumbered: HashMap<u32, u32> = HashMap::new();
    let mut vertices: Vec<[Number; 3]> = Vec::new();
    for corner in &mut corners {
        let old = corner.vertex;
        corner.vertex = *renumbered.entry(old).or_insert_with(|| {
            vertices.push(points[old as usize].clone());
            vertices.len() as u32 - 1
        });
    }
    Tiling {
        frame,
        vertices: vertices.into(),
        corners,
    }
}
