//! A mesh as a tiling: periodic, or bounded; of tetrahedra in space, or of triangles in a plane
//! z = constant.

use super::error::MeshError;
use super::identify::{Identified, identify};
use super::lattice::{Basis, Lattice};
use super::sides::{Question, sides};
use super::snap::{Move, snap};
use super::{Mesh, Origin};
use acutile_core::checker::Sides;
use acutile_core::tiling::{
    AnyTiling, Coordinates, Corner, Domain, Facet, Frame, Tiling, VertexId,
};
use acutile_exact::number::{Field, Number};
use malachite::{Integer, Rational};
use std::collections::{BTreeSet, HashSet};

/// A tiling made of a mesh.
pub struct Converted {
    /// One simplex for each cell, in the order of the mesh.
    pub tiling: AnyTiling,
    /// The numbers of the file.
    pub origin: Origin,
    /// The basis of the tiling's coordinates.
    pub basis: Basis,
    /// The sides of a periodic mesh.
    pub sides: Sides,
    /// Nodes that were moved to exact images.
    pub moves: Vec<Move>,
    /// Nodes that are no corners of cells, and were left out.
    pub unused: usize,
    /// Nodes that have exactly the coordinates of another node and are still vertices
    /// of their own.
    pub coincident: usize,
}

/// The periodic tiling, or the periodic region, that the mesh is to be a cell of. Nodes that differ
/// by a lattice vector become one vertex; with a tolerance also those that nearly do.
///
/// # Errors
/// Where a node is too far from the origin, or the tolerance too large.
pub fn periodic_tiling(
    mesh: Mesh,
    lattice: &Lattice,
    tolerance: Option<f64>,
) -> Result<Converted, MeshError> {
    let basis = lattice.basis(mesh.dimension())?;
    converted(mesh, basis, true, tolerance)
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
    if mesh.dimension() == 2 {
        check_plane(&mesh, &used)?;
    }
    let inverse = basis.inverse()?;
    let mut found = identify(&mesh.points, &used, &inverse, basis.rank, merge)?;
    let mut moves = Vec::new();
    if let Some(tolerance) = tolerance.filter(|&tolerance| tolerance > 0.0) {
        moves = apply_snap(&mut found, &mesh, &basis, &inverse, tolerance)?;
    }
    let coincident = if merge {
        0
    } else {
        let points: HashSet<&[Integer; 3]> = found.numerators.iter().collect();
        found.numerators.len() - points.len()
    };
    let snapped = |distance: f64| {
        // Whoever gives a tolerance says which gaps are meant.
        if tolerance.is_some() {
            return None;
        }
        let mut found = identify(&mesh.points, &used, &inverse, basis.rank, true).ok()?;
        let moves = apply_snap(&mut found, &mesh, &basis, &inverse, distance).ok()?;
        Some((found, moves))
    };
    let (tiling, sides) = match mesh.dimension() {
        2 => {
            let (tiling, sides) = with_domain::<2>(&mesh, &basis, &found, &snapped);
            (AnyTiling::Plane(tiling), sides)
        }
        _ => {
            let (tiling, sides) = with_domain::<3>(&mesh, &basis, &found, &snapped);
            (AnyTiling::Space(tiling), sides)
        }
    };
    Ok(Converted {
        tiling,
        sides,
        unused: used.iter().filter(|used| !**used).count(),
        coincident,
        moves,
        origin: Origin::new(mesh, found.representatives, &basis),
        basis,
    })
}

/// A mesh of triangles has to lie in a plane z = constant.
fn check_plane(mesh: &Mesh, used: &[bool]) -> Result<(), MeshError> {
    let corners = (0..mesh.points.len()).filter(|&point| used[point]);
    let middles = mesh.curved.values().flatten().map(|&point| point as usize);
    let mut heights = corners.chain(middles);
    let Some(first) = heights.next() else {
        return Ok(());
    };
    let height = mesh.points[first][2];
    match heights.find(|&point| mesh.points[point][2] != height) {
        None => Ok(()),
        Some(point) => Err(MeshError::of_file(format!(
            "has no tetrahedra, but {} triangles that lie in no plane z = constant: the nodes {} \
             and {} have z = {height} and {}; a surface is compared with a mesh by --fills",
            mesh.triangles.len(),
            mesh.nodes.get(first),
            mesh.nodes.get(point),
            mesh.points[point][2]
        ))),
    }
}

/// The tiling with its domain, and the facets on the sides that have no mate.
fn with_domain<const D: usize>(
    mesh: &Mesh,
    basis: &Basis,
    found: &Identified,
    snapped: &dyn Fn(f64) -> Option<(Identified, Vec<Move>)>,
) -> (Tiling<D>, Sides) {
    let region = Domain::Region(basis.rank);
    let mut tiling = tiling(basis, found, mesh, region.clone());
    if basis.rank == 0 {
        return (tiling, Sides::default());
    }
    let linked = linked_points(mesh, basis);
    let is_linked = |facet: Facet| {
        let corners = mesh.cell(facet.simplex.index()).iter().enumerate();
        let corners = corners.filter(|(k, _)| *k != usize::from(facet.opposite));
        let points: Vec<u32> = corners.map(|(_, point)| *point).collect();
        linked
            .iter()
            .any(|link| points.iter().all(|point| link.contains(point)))
    };
    let moved = |distance: f64| {
        let (found, moves) = snapped(distance)?;
        let tiling = self::tiling(basis, &found, mesh, region.clone());
        Some((tiling, moves))
    };
    let (domain, sides) = sides(&Question {
        tiling: &tiling,
        is_linked: &is_linked,
        moved: &moved,
    });
    tiling.frame.domain = domain;
    (tiling, sides)
}

/// The points of each side of the periodic links between surfaces (curves, in the plane) whose
/// translation is in the lattice.
fn linked_points(mesh: &Mesh, basis: &Basis) -> Vec<BTreeSet<u32>> {
    let top = mesh.dimension() as i64 - 1;
    let links = mesh.periodic.iter().filter(|link| link.dimension == top);
    links
        .filter(|link| basis.has_link(link, mesh))
        .flat_map(|link| {
            let images = link.nodes.iter().map(|(image, _)| *image).collect();
            let originals = link.nodes.iter().map(|(_, original)| *original).collect();
            [images, originals]
        })
        .collect()
}

fn tiling<const D: usize>(
    basis: &Basis,
    found: &Identified,
    mesh: &Mesh,
    domain: Domain,
) -> Tiling<D> {
    let gram = basis.gram();
    let corners = mesh.cells().flatten().map(|&point| {
        let (vertex, shift) = found.places[point as usize];
        Corner {
            vertex: VertexId::new(vertex),
            shift: std::array::from_fn(|k| shift[k]),
        }
    });
    Tiling {
        corners: corners.collect(),
        frame: Frame {
            field: Field::rationals(),
            gram: std::array::from_fn(|i| std::array::from_fn(|j| gram[i][j].clone())),
            domain,
        },
        vertices: coordinates(basis, found, &mesh.points),
    }
}

/// The only place where coordinates become those of a tiling: vertex v has the basis
/// coordinates N_v / Q. Without a lattice the basis is Cartesian and these are the doubles. In the
/// plane the third coordinate is left out.
fn coordinates<const D: usize>(
    basis: &Basis,
    found: &Identified,
    points: &[[f64; 3]],
) -> Coordinates<D> {
    let doubles = || {
        let points = found.representatives.iter().map(|&p| &points[p as usize]);
        points.map(|point| std::array::from_fn(|k| point[k]))
    };
    let number = |x: &Integer| Number::from(Rational::from_integers_ref(x, &found.denominator));
    let row = |row: &[Integer; 3]| -> Option<[i64; D]> {
        let mut numbers = [0; D];
        for (number, x) in numbers.iter_mut().zip(row) {
            *number = i64::try_from(x).ok()?;
        }
        Some(numbers)
    };
    let coordinates = match (basis.rank, i64::try_from(&found.denominator).ok()) {
        (0, _) => Coordinates::from_doubles(doubles().collect()),
        (_, Some(denominator)) => {
            let numerators = found.numerators.iter().map(row).collect::<Option<Vec<_>>>();
            numerators.and_then(|rows| Coordinates::from_integers(rows, denominator))
        }
        _ => None,
    };
    let as_numbers = || -> Coordinates<D> {
        let rows = found.numerators.iter();
        rows.map(|row| std::array::from_fn(|k| number(&row[k])))
            .collect()
    };
    coordinates.unwrap_or_else(as_numbers)
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
