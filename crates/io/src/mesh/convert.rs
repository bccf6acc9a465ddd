//! A mesh as a tiling: periodic, or bounded.

use super::error::MeshError;
use super::identify::{Identified, identify};
use super::lattice::{Basis, Lattice};
use super::snap::{Move, snap};
use super::{Mesh, Origin};
use acutile_core::tiling::{Coordinates, Corner, Domain, Frame, Polytope, Tiling, VertexId};
use acutile_exact::number::{Field, Number};
use malachite::{Integer, Rational};

/// A tiling made of a mesh.
pub struct Converted {
    /// One simplex for each tetrahedron, in the order of the mesh.
    pub tiling: Tiling<3>,
    /// The numbers of the file.
    pub origin: Origin,
    /// The basis of the tiling's coordinates.
    pub basis: Basis,
    /// Nodes that were moved to exact images.
    pub moves: Vec<Move>,
    /// Nodes that belong to no tetrahedron, and were left out.
    pub unused: usize,
    /// Nodes that have exactly the coordinates of another node and are still vertices
    /// of their own.
    pub coincident: usize,
}

/// The tiling of space, or of a slab between the lowest and the highest node, that the mesh
/// is to be a cell of. Nodes that differ by a lattice vector become one vertex; with a
/// tolerance also those that nearly do.
///
/// # Errors
/// Where a node is too far from the origin, or the tolerance too large.
pub fn periodic_tiling(
    mesh: Mesh,
    lattice: &Lattice,
    tolerance: Option<f64>,
) -> Result<Converted, MeshError> {
    converted(mesh, lattice.basis(), true, tolerance)
}

/// The bounded region that the mesh covers. Nodes stay what they are; with a tolerance
/// those nearer to each other become one vertex.
///
/// # Errors
/// As for [`periodic_tiling`].
pub fn region_tiling(mesh: Mesh, tolerance: Option<f64>) -> Result<Converted, MeshError> {
    converted(mesh, Basis::cartesian(), tolerance.is_some(), tolerance)
}

fn converted(
    mesh: Mesh,
    basis: Basis,
    merge: bool,
    tolerance: Option<f64>,
) -> Result<Converted, MeshError> {
    let used = mesh.used_points();
    let inverse = basis.inverse()?;
    let mut found = identify(&mesh.points, &used, &inverse, basis.rank, merge)?;
    let mut moves = Vec::new();
    if let Some(tolerance) = tolerance.filter(|&tolerance| tolerance > 0.0) {
        moves = apply_snap(&mut found, &mesh, &basis, &inverse, tolerance)?;
    }
    let coincident = match merge {
        true => 0,
        false => {
            let merged = identify(&mesh.points, &used, &inverse, basis.rank, true)?;
            found.numerators.len() - merged.numerators.len()
        }
    };
    let corners = mesh.tetrahedra.iter().flatten().map(|&point| {
        let (vertex, shift) = found.places[point as usize];
        let vertex = VertexId::new(vertex);
        Corner { vertex, shift }
    });
    let corners = corners.collect();
    let tiling = tiling(&basis, &found, &mesh.points, corners);
    Ok(Converted {
        tiling,
        unused: used.iter().filter(|used| !**used).count(),
        coincident,
        moves,
        origin: Origin::new(mesh, found.representatives, &basis),
        basis,
    })
}

fn tiling(
    basis: &Basis,
    found: &Identified,
    points: &[[f64; 3]],
    corners: Vec<Corner<3>>,
) -> Tiling<3> {
    Tiling {
        frame: Frame {
            field: Field::rationals(),
            gram: basis.gram(),
            domain: domain(basis.rank, found),
        },
        vertices: coordinates(basis, found, points),
        corners,
    }
}

/// The only place where coordinates become those of a tiling: vertex v has the basis
/// coordinates N_v / Q. Without a lattice the basis is Cartesian and these are the doubles.
fn coordinates(basis: &Basis, found: &Identified, points: &[[f64; 3]]) -> Coordinates<3> {
    let doubles = || {
        found
            .representatives
            .iter()
            .map(|&point| points[point as usize])
    };
    let number = |x: &Integer| Number::from(Rational::from_integers_ref(x, &found.denominator));
    let integer = |x: &Integer| i64::try_from(x).ok();
    let row = |row: &[Integer; 3]| match row.each_ref().map(integer) {
        [Some(x), Some(y), Some(z)] => Some([x, y, z]),
        _ => None,
    };
    let coordinates = match (basis.rank, integer(&found.denominator)) {
        (0, _) => Coordinates::from_doubles(doubles().collect()),
        (_, Some(denominator)) => {
            let numerators = found.numerators.iter().map(row).collect::<Option<Vec<_>>>();
            numerators.and_then(|rows| Coordinates::from_integers(rows, denominator))
        }
        _ => None,
    };
    let as_numbers = || {
        found
            .numerators
            .iter()
            .map(|row| row.each_ref().map(number))
    };
    coordinates.unwrap_or_else(|| as_numbers().collect())
}

/// What is tiled: for two lattice vectors the slab between the lowest and the highest vertex.
fn domain(rank: usize, found: &Identified) -> Domain {
    let heights = || found.numerators.iter().map(|row| &row[2]);
    let number = |x: &Integer| Number::from(Rational::from_integers_ref(x, &found.denominator));
    match (rank, heights().min(), heights().max()) {
        (2, Some(low), Some(high)) => Domain::Slab(Polytope::interval(number(low), number(high))),
        (0, ..) => Domain::Region(0),
        _ => Domain::Space,
    }
}

/// Moves vertices, and leaves those out that have become others.
fn apply_snap(
    found: &mut Identified,
    mesh: &Mesh,
    basis: &Basis,
    inverse: &[[Rational; 3]; 3],
    tolerance: f64,
) -> Result<Vec<Move>, MeshError> {
    let moved = snap(found, basis, inverse, tolerance)?;
    let mut moves = Vec::new();
    for (point, place) in found.places.iter_mut().enumerate() {
        let Some((target, step)) = moved.get(&place.0) else {
            continue;
        };
        *place = (*target, std::array::from_fn(|k| place.1[k] + step[k]));
        moves.push(told(
            point,
            *place,
            found.numerators[*target as usize].clone(),
            &found.denominator,
            mesh,
            basis,
        ));
    }
    let mut kept = Vec::new();
    let mut renumbered = vec![u32::MAX; found.numerators.len()];
    for vertex in 0..found.numerators.len() {
        if !moved.contains_key(&(vertex as u32)) {
            renumbered[vertex] = kept.len() as u32;
            kept.push(vertex);
        }
    }
    for (vertex, _) in found.places.iter_mut().filter(|place| place.0 != u32::MAX) {
        *vertex = renumbered[*vertex as usize];
    }
    found.numerators = kept.iter().map(|&v| found.numerators[v].clone()).collect();
    found.representatives = kept.iter().map(|&v| found.representatives[v]).collect();
    Ok(moves)
}

/// A point that is now the vertex with these numerators, moved by a lattice vector.
fn told(
    point: usize,
    (_, shift): (u32, [i32; 3]),
    numerators: [Integer; 3],
    denominator: &Integer,
    mesh: &Mesh,
    basis: &Basis,
) -> Move {
    let fractions: [Rational; 3] = std::array::from_fn(|k| {
        Rational::from_integers_ref(&numerators[k], denominator) + Rational::from(shift[k])
    });
    let to: [Rational; 3] = std::array::from_fn(|j| {
        let terms = (0..3).map(|k| {
            let entry = basis.vectors[k][j]
                .to_rational()
                .cloned()
                .unwrap_or_default();
            &fractions[k] * entry
        });
        terms.sum()
    });
    let from = mesh.points[point];
    let step = |k: usize| {
        let from = Rational::try_from(from[k]).unwrap_or_default();
        Number::from(&to[k] - from).approximate()
    };
    Move {
        node: mesh.nodes.get(point),
        from,
        distance: (0..3).map(|k| step(k).powi(2)).sum::<f64>().sqrt(),
        to,
    }
}
