//! Periodic Delaunay triangulations, exactly.
//!
//! [`triangulate`] turns a point set with a lattice into a tiling by simplices. The lattice may be skewed,
//! and one point is enough. [`cells`] gives the Delaunay cells themselves, which are polytopes if more than
//! D + 1 points lie on an empty sphere. Dimensions 2 and 3.
//!
//! | file | does |
//! |---|---|
//! | `lattice` | a reduced basis, exactly |
//! | `model` | coordinates in the reduced cell, and back to the caller's |
//! | `places` | positions in doubles, to search by |
//! | `tree` | the points in a ball |
//! | `predicates` | exact signs and circumcentres |
//! | `seed` | a first cell |
//! | `front` | the facets beyond which the cell is still to be found |
//! | `wrap` | gift wrapping from cell to cell |
//! | `polytope` | facets and pulling of cells that are not simplices |
//! | `certify` | an independent exact check of the result |
//!
//! `model`, `predicates` and `search` are public for the tests, which would compile this crate a
//! second time if they were inside of it.
//!
//! Doubles only propose: which points lie on or in a sphere is decided by proved signs.

mod certify;
mod error;
mod front;
mod lattice;
#[doc(hidden)]
pub mod model;
mod places;
mod polytope;
#[doc(hidden)]
pub mod predicates;
mod seed;
mod tree;
mod wrap;

pub use error::{COSPHERICAL_LIMIT, CosphericalSet, DelaunayError};
pub use predicates::circumcenter;

use crate::parallel;
use crate::predicates::Model as Coordinates;
use crate::tiling::dimension::{same, same_value};
use crate::tiling::{Corner, PointSet, SimplexId, Tiling, difference};
use acutile_exact::geometry::Sign;
use front::sort_is_odd;
use model::Model;
use polytope::Polytope;
use predicates::Predicates;
use wrap::Cells;

/// The treatment of cells that are not simplices.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ties {
    /// Refuse, and list all cospherical sets.
    Refuse,
    /// Cut them by pulling: from the least corner, in the lexicographic order of basis
    /// coordinates. Translates and common facets are cut alike.
    Pull,
}

/// A Delaunay cell: the convex hull of all points on an empty sphere.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cell<const D: usize> {
    /// At least D + 1, sorted, the first with shift zero.
    pub corners: Vec<Corner<D>>,
    /// The facets, as sorted indices of corners; sorted.
    pub facets: Vec<Vec<usize>>,
}

/// The Delaunay triangulation of a point set.
///
/// Vertex i of the tiling is point i, moved by a lattice vector into the cell 0 <= x < 1 of the given
/// basis. Simplices are positively oriented and sorted by corners. Their corners are sorted by (vertex,
/// shift), and the first has shift zero. The last two are exchanged if the orientation requires it. So the
/// result depends on nothing but the points, the basis and their order.
pub fn triangulate<const D: usize>(
    set: &PointSet<D>,
    ties: Ties,
) -> Result<Tiling<D>, DelaunayError> {
    match D {
        2 => same_value(triangulate_plane(same(set), ties)),
        _ => same_value(triangulate_space(same(set), ties)),
    }
}

#[inline(never)]
fn triangulate_plane(set: &PointSet<2>, ties: Ties) -> Result<Tiling<2>, DelaunayError> {
    triangulate_set(set, ties)
}

#[inline(never)]
fn triangulate_space(set: &PointSet<3>, ties: Ties) -> Result<Tiling<3>, DelaunayError> {
    triangulate_set(set, ties)
}

fn triangulate_set<const D: usize>(
    set: &PointSet<D>,
    ties: Ties,
) -> Result<Tiling<D>, DelaunayError> {
    let model = Model::new(set)?;
    let found = find(&model)?;
    if ties == Ties::Refuse && !found.polytopes.is_empty() {
        return Err(DelaunayError::Cospherical(cospherical_sets(
            &model,
            &found.polytopes,
        )?));
    }
    tiling(set, model, found)
}

/// The simplices that were found, sorted by corners.
fn tiling<const D: usize>(
    set: &PointSet<D>,
    model: Model<D>,
    found: Found<D>,
) -> Result<Tiling<D>, DelaunayError> {
    let shell = &found.shell;
    let simplices = parallel::map(shell.len(), |simplex| {
        Simplex::new(&model, shell.simplex(SimplexId::at(simplex)))
    });
    let simplices = simplices.into_iter().collect::<Result<Vec<_>, _>>()?;
    drop(found);
    let simplices = sorted(simplices, model.names.len());
    let corners = simplices.iter().flat_map(Simplex::ordered).collect();
    Ok(Tiling {
        frame: set.frame.clone(),
        vertices: model.vertices.into(),
        corners,
    })
}

/// The Delaunay cells of a point set, one of each orbit, sorted by corners. Corners refer to the points
/// moved into the cell 0 <= x < 1 of the given basis.
pub fn cells<const D: usize>(set: &PointSet<D>) -> Result<Vec<Cell<D>>, DelaunayError> {
    let model = Model::new(set)?;
    let found = find(&model)?;
    cells_of(&model, &found)
}

/// The Delaunay cells as [`cells`] gives them, and the triangulation where all are simplices, as [`triangulate`]
/// gives it; the search is made once.
pub fn cells_and_triangulation<const D: usize>(
    set: &PointSet<D>,
) -> Result<(Vec<Cell<D>>, Option<Tiling<D>>), DelaunayError> {
    let model = Model::new(set)?;
    let found = find(&model)?;
    let cells = cells_of(&model, &found)?;
    let tiling = if found.polytopes.is_empty() {
        Some(tiling(set, model, found)?)
    } else {
        None
    };
    Ok((cells, tiling))
}

fn cells_of<const D: usize>(
    model: &Model<D>,
    found: &Found<D>,
) -> Result<Vec<Cell<D>>, DelaunayError> {
    let simple = found.shell.simplices().take(found.simple);
    let all_but_one = |i: usize| (0..=D).filter(|&k| k != i).collect::<Vec<_>>();
    let facets: Vec<_> = (0..=D).rev().map(all_but_one).collect();
    let mut cells = Vec::with_capacity(found.simple + found.polytopes.len());
    for simplex in simple {
        cells.push(Cell::new(model, simplex, facets.clone())?);
    }
    for polytope in &found.polytopes {
        cells.push(Cell::new(
            model,
            &polytope.corners,
            polytope.facet_indices(),
        )?);
    }
    cells.sort_unstable_by(|a, b| a.corners.cmp(&b.corners));
    Ok(cells)
}

/// The result of the search, in model coordinates.
#[doc(hidden)]
pub struct Found<const D: usize> {
    /// The simplices: first the cells that are simplices, then the parts of the others.
    pub shell: Tiling<D>,
    /// How many cells are simplices.
    pub simple: usize,
    pub polytopes: Vec<Polytope<D>>,
}

/// With doubles as filters and for clear proposals, and if the check should fail, exactly
/// throughout.
fn find<const D: usize>(model: &Model<D>) -> Result<Found<D>, DelaunayError> {
    let coordinates = Coordinates::of_vertices(&model.points);
    let mut predicates = Predicates::new(model, &coordinates);
    match search(&predicates) {
        Err(DelaunayError::Uncertified) => {
            predicates.filtered = false;
            search(&predicates)
        }
        result => result,
    }
}

/// Wraps, pulls and certifies.
#[doc(hidden)]
pub fn search<const D: usize>(predicates: &Predicates<D>) -> Result<Found<D>, DelaunayError> {
    let Cells {
        simplices: mut corners,
        polytopes,
    } = wrap::wrap(predicates)?;
    let simple = corners.len() / (D + 1);
    let mut cells: Vec<u32> = (0..simple as u32).collect();
    for (polytope, cell) in polytopes.iter().zip(simple as u32..) {
        for mut simplex in polytope.pulled() {
            let facet = std::array::from_fn(|k| simplex[k]);
            if predicates.orientation(&facet, &simplex[D]) == Sign::Less {
                simplex.swap(0, 1);
            }
            corners.extend(simplex);
            cells.push(cell);
        }
    }
    let model = predicates.model;
    let shell = Tiling {
        corners,
        ..model.points.clone()
    };
    if !certify::is_delaunay(&shell, &cells, model.names.len()) {
        return Err(DelaunayError::Uncertified);
    }
    Ok(Found {
        shell,
        simple,
        polytopes,
    })
}

fn cospherical_sets<const D: usize>(
    model: &Model<D>,
    polytopes: &[Polytope<D>],
) -> Result<Vec<CosphericalSet>, DelaunayError> {
    let mut sets = Vec::with_capacity(polytopes.len());
    for polytope in polytopes {
        sets.push(cospherical_set(model, polytope)?);
    }
    sets.sort_unstable_by(|a, b| a.corners.cmp(&b.corners));
    Ok(sets)
}

fn cospherical_set<const D: usize>(
    model: &Model<D>,
    polytope: &Polytope<D>,
) -> Result<CosphericalSet, DelaunayError> {
    let (corners, order) = sorted_original(model, &polytope.corners)?;
    let moved = &polytope.corners[order[0]];
    let (facet, apex) = polytope.spanning(polytope.facets[0]);
    let facet = std::array::from_fn(|k| facet[k]);
    let (center, squared_radius) = predicates::exact_center(model, &facet, &apex)?;
    // From relative to facet[0] to relative to the least corner.
    let [from, to] = [&facet[0], moved].map(|corner| model.position(corner));
    let center = std::array::from_fn(|k| &center[k] + &(&from[k] - &to[k]));
    let least = &model.vertices[corners[0].vertex.index()];
    let center = model.lattice.vector(&center);
    let center = std::array::from_fn(|k| &center[k] + &least[k]);
    Ok(CosphericalSet::new(&corners, center, squared_radius))
}

/// Corners in the caller's terms, sorted and moved so that the first has shift zero,
/// and their order before.
fn sorted_original<const D: usize>(
    model: &Model<D>,
    corners: &[Corner<D>],
) -> Result<(Vec<Corner<D>>, Vec<usize>), DelaunayError> {
    let mut indexed = Vec::with_capacity(corners.len());
    for (index, corner) in corners.iter().enumerate() {
        indexed.push((model.original(corner)?, index));
    }
    indexed.sort_unstable();
    let origin = indexed[0].0.shift;
    let moved = |corner: Corner<D>| Corner {
        shift: difference(corner.shift, origin),
        ..corner
    };
    Ok(indexed
        .into_iter()
        .map(|(corner, index)| (moved(corner), index))
        .unzip())
}

impl<const D: usize> Cell<D> {
    fn new(
        model: &Model<D>,
        corners: &[Corner<D>],
        facets: Vec<Vec<usize>>,
    ) -> Result<Self, DelaunayError> {
        let (corners, order) = sorted_original(model, corners)?;
        let mut place = vec![0; order.len()];
        order
            .iter()
            .enumerate()
            .for_each(|(new, &old)| place[old] = new);
        let mut facets: Vec<Vec<usize>> = facets
            .into_iter()
            .map(|facet| {
                let mut facet: Vec<usize> = facet.into_iter().map(|i| place[i]).collect();
                facet.sort_unstable();
                facet
            })
            .collect();
        facets.sort_unstable();
        Ok(Cell { corners, facets })
    }

    /// Whether the cell has D + 1 corners.
    pub fn is_simplex(&self) -> bool {
        self.corners.len() == D + 1
    }
}

/// A simplex of the result, ordered first by its sorted corners.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Simplex<const D: usize> {
    facet: [Corner<D>; D],
    apex: Corner<D>,
    odd: bool,
}

impl<const D: usize> Simplex<D> {
    /// The normal form of a positively oriented simplex.
    fn new(model: &Model<D>, corners: &[Corner<D>]) -> Result<Self, DelaunayError> {
        let mut facet = [corners[0]; D];
        for (corner, given) in facet.iter_mut().zip(corners) {
            *corner = model.original(given)?;
        }
        let mut apex = model.original(&corners[D])?;
        let mut odd = sort_is_odd(&mut facet);
        if apex < facet[D - 1] {
            std::mem::swap(&mut apex, &mut facet[D - 1]);
            odd ^= !sort_is_odd(&mut facet);
        }
        let origin = facet[0].shift;
        for corner in facet.iter_mut().chain([&mut apex]) {
            corner.shift = difference(corner.shift, origin);
        }
        Ok(Simplex { facet, apex, odd })
    }

    /// The corners in positive order.
    fn ordered(&self) -> impl Iterator<Item = Corner<D>> + use<D> {
        let (mut facet, mut apex) = (self.facet, self.apex);
        if self.odd {
            std::mem::swap(&mut facet[D - 1], &mut apex);
        }
        facet.into_iter().chain([apex])
    }
}

/// Sorts simplices: counted by the least vertex, then each lot by itself.
fn sorted<const D: usize>(simplices: Vec<Simplex<D>>, vertices: usize) -> Vec<Simplex<D>> {
    let least = |simplex: &Simplex<D>| simplex.facet[0].vertex.index();
    let mut ends = vec![0u32; vertices + 1];
    simplices.iter().for_each(|s| ends[least(s) + 1] += 1);
    (0..vertices).for_each(|v| ends[v + 1] += ends[v]);
    let Some(&first) = simplices.first() else {
        return simplices;
    };
    let mut sorted = vec![first; simplices.len()];
    for simplex in simplices {
        let place = &mut ends[least(&simplex)];
        sorted[*place as usize] = simplex;
        *place += 1;
    }
    sorted
        .chunk_by_mut(|a, b| least(a) == least(b))
        .for_each(|lot| lot.sort_unstable());
    sorted
}
