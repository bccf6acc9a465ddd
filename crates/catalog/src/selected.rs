//! Section 4.1: lattices with the circumcentres of selected Delaunay cells.

use super::CatalogError;
use super::recipe::rational_points;
use acutile_core::delaunay::{Ties, circumcenter, triangulate};
use acutile_core::tiling::{Facet, PointSet, SimplexId, Tiling, match_facets};
use acutile_exact::number::Number;

/// A15: the bcc lattice, its Delaunay tetrahedra coloured alternately black and white, and the
/// circumcentres of the black ones. The colouring has the period of the cubic cell.
pub fn a15_bcc() -> Result<Tiling<3>, CatalogError> {
    let cubic = [[4, 0, 0], [0, 4, 0], [0, 0, 4]];
    let mut points = rational_points(cubic, 2, &[[0, 0, 0], [1, 1, 1]]);
    let lattice = triangulate(&points, Ties::Refuse)?;
    for (simplex, black) in lattice.simplices().zip(two_colouring(&lattice)?) {
        if black {
            let corners: Vec<_> = simplex.iter().map(|c| lattice.position(c)).collect();
            let center = circumcenter(&lattice.frame.gram, &corners);
            points.points.push(center.ok_or(CatalogError::Degenerate)?);
        }
    }
    Ok(triangulate(&points, Ties::Refuse)?)
}

/// Whether each simplex is black, so that simplices with a common facet differ; the first one is.
fn two_colouring(tiling: &Tiling<3>) -> Result<Vec<bool>, CatalogError> {
    let matching = match_facets(tiling);
    let mut colours: Vec<Option<bool>> = vec![None; tiling.len()];
    let mut stack = vec![(SimplexId::new(0), true)];
    while let Some((simplex, colour)) = stack.pop() {
        match colours[simplex.index()] {
            Some(known) if known == colour => continue,
            Some(_) => return Err(CatalogError::NotTwoColourable),
            None => colours[simplex.index()] = Some(colour),
        }
        let facets = (0..4).filter_map(|k| matching.neighbour(Facet::new(simplex, k)));
        stack.extend(facets.map(|facet| (facet.simplex, !colour)));
    }
    colours
        .into_iter()
        .collect::<Option<_>>()
        .ok_or(CatalogError::NotTwoColourable)
}

/// C15: the diamond structure, and the centres of its puckered hexagons of bonds. Diamond is fcc, with the
/// basis (0,1,1), (1,0,1), (1,1,0), and its translate by a quarter of their sum. The centres are the
/// circumcentres of those Delaunay cells that have more than four corners.
pub fn c15() -> Result<Tiling<3>, CatalogError> {
    let mut points = rational_points([[2, 1, 1], [1, 2, 1], [1, 1, 2]], 4, &[[0; 3], [1; 3]]);
    points.points.extend(large_cell_centers(&points)?);
    Ok(triangulate(&points, Ties::Refuse)?)
}

fn large_cell_centers(points: &PointSet<3>) -> Result<Vec<[Number; 3]>, CatalogError> {
    use acutile_core::delaunay::DelaunayError::Cospherical;
    match triangulate(points, Ties::Refuse) {
        Err(Cospherical(sets)) => sets
            .into_iter()
            .map(|set| set.center.try_into().map_err(|_| CatalogError::Degenerate))
            .collect(),
        Err(error) => Err(error.into()),
        Ok(_) => Ok(Vec::new()),
    }
}
