//! The domain of a file.

use super::ImportError;
use super::document::{self, Document, PolytopeEntry};
use super::numbers::{Entry, Numbers};
use acutile_core::tiling::{Domain, Polytope};

/// The domain of a document of dimension D, in the coordinates of the file.
pub fn read_domain<S: Entry, const D: usize>(
    document: &Document,
    numbers: &Numbers,
) -> Result<Domain<S>, ImportError> {
    match &document.domain {
        document::Domain::Space => Ok(Domain::Space),
        document::Domain::Slab(heights) => {
            let heights = numbers.row::<S, 2>(heights, || "domain.slab".to_owned())?;
            let [lower, upper] = heights;
            Ok(Domain::Slab(Polytope::interval(lower, upper)))
        }
        document::Domain::Prism(_) if D != 3 => Err(ImportError::entry(
            "domain.prism",
            "found dimension 2, expected 3",
        )),
        document::Domain::Prism(entry) => {
            polytope(entry, 2, "domain.prism", numbers).map(Domain::Prism)
        }
        document::Domain::Region(rank) if *rank > D => Err(ImportError::entry(
            "domain.region",
            format!("found the rank {rank}, expected 0 to {D}"),
        )),
        document::Domain::Region(rank) => Ok(Domain::Region(*rank)),
        document::Domain::Solid(entry) => {
            polytope(entry, D, "domain.solid", numbers).map(Domain::Solid)
        }
    }
}

/// A polygon by its corners, or a polyhedron by its vertices and faces.
fn polytope<S: Entry>(
    entry: &PolytopeEntry,
    dimension: usize,
    place: &str,
    numbers: &Numbers,
) -> Result<Polytope<S>, ImportError> {
    let vertices: Result<Vec<Vec<S>>, ImportError> = (0..)
        .zip(&entry.vertices)
        .map(|(i, row)| numbers.list(row, dimension, || format!("{place}.vertices[{i}]")))
        .collect();
    let vertices = vertices?;
    if vertices.len() <= dimension {
        let problem = format!(
            "has {} entries, expected {} or more",
            vertices.len(),
            dimension + 1
        );
        return Err(ImportError::entry(format!("{place}.vertices"), problem));
    }
    match (&entry.faces, dimension) {
        (None, 2) => Ok(Polytope::polygon(vertices)),
        (None, _) => Err(ImportError::entry(format!("{place}.faces"), "is missing")),
        (Some(faces), _) => {
            check_faces(faces, vertices.len(), dimension, place)?;
            Ok(Polytope {
                vertices,
                faces: faces.clone(),
            })
        }
    }
}

fn check_faces(
    faces: &[Vec<usize>],
    vertices: usize,
    dimension: usize,
    place: &str,
) -> Result<(), ImportError> {
    for (f, face) in faces.iter().enumerate() {
        let at = format!("{place}.faces[{f}]");
        if face.len() < dimension || (dimension == 2 && face.len() != 2) {
            let problem = format!("has {} corners, expected {dimension}", face.len());
            return Err(ImportError::entry(at, problem));
        }
        if let Some(vertex) = face.iter().find(|&&vertex| vertex >= vertices) {
            let problem = format!(
                "vertex {vertex} is out of range, expected 0 to {}",
                vertices - 1
            );
            return Err(ImportError::entry(at, problem));
        }
    }
    Ok(())
}
