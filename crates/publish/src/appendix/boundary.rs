//! The boundary of slabs, prisms and solids: faces, and the distances of the vertices from them.

use super::subject::Analysis;
use super::tex::list;
use acutile_core::tiling::Facet;
use acutile_exact::number::Number;
use std::collections::BTreeMap;

/// Which face is which.
pub fn faces<const D: usize>(analysis: &Analysis<D>) -> String {
    let Some(polytope) = analysis.tiling.frame.domain.polytope() else {
        return String::new();
    };
    let numerals = &analysis.numerals;
    let point = |v: &usize| {
        let entries: Vec<String> = polytope.vertices[*v]
            .iter()
            .map(|x| numerals.inline(x))
            .collect();
        match entries.as_slice() {
            [height] => format!("$x_{D}={height}$"),
            _ => format!("$p_{{{v}}}=({})$", entries.join(",\\,")),
        }
    };
    let faces: Vec<String> = polytope
        .faces
        .iter()
        .enumerate()
        .map(|(index, face)| {
            let points: Vec<String> = face.iter().map(point).collect();
            format!("face ${index}$: {}", points.join(", "))
        })
        .collect();
    format!(" ({}).", faces.join("; "))
}

/// The face of the domain in whose plane all corners of a facet lie.
pub fn boundary_face<const D: usize>(analysis: &Analysis<D>, facet: Facet) -> Option<usize> {
    let tiling = analysis.tiling;
    let polytope = tiling.frame.domain.polytope()?;
    let points: Vec<_> = tiling
        .simplex(facet.simplex)
        .iter()
        .enumerate()
        .filter(|(k, _)| *k != usize::from(facet.opposite))
        .map(|(_, corner)| tiling.position(corner))
        .collect();
    (0..polytope.faces.len()).find(|&face| {
        polytope.plane(face).is_some_and(|plane| {
            points
                .iter()
                .all(|point| plane.value(tiling.frame.cross_section(point)).is_zero())
        })
    })
}

/// The paragraph that shows all vertices to lie in the domain; nothing where there is no boundary.
pub fn boundary<const D: usize>(analysis: &Analysis<D>) -> String {
    let tiling = analysis.tiling;
    let Some(polytope) = tiling.frame.domain.polytope() else {
        return String::new();
    };
    let numerals = &analysis.numerals;
    let lists: Vec<String> = (0..polytope.faces.len())
        .filter_map(|face| {
            let plane = polytope.plane(face)?;
            let mut values: BTreeMap<Number, usize> = BTreeMap::new();
            for position in tiling.vertices.iter() {
                let value = plane.value(tiling.frame.cross_section(&position));
                *values.entry(value).or_insert(0) += 1;
            }
            let texts: Vec<String> = values
                .iter()
                .map(|(value, count)| match count {
                    1 => format!("${}$", numerals.justified(value)),
                    _ => format!("${}$ (${count}$ times)", numerals.justified(value)),
                })
                .collect();
            Some(format!("face ${face}$: {}", list(&texts)))
        })
        .collect();
    let function = match polytope.dimension() {
        1 => "the distance in the last coordinate",
        2 => {
            "the determinant that is zero on the line of the face and positive at the other corners of $P$"
        }
        _ => {
            "the determinant that is zero on the plane of the face and positive at the other corners of $P$"
        }
    };
    format!(
        "\\acutileparagraph{{Boundary (B).}} For each face let $\\ell$ be {function}. Its values at the vertices, all at least $0$, are\n% acutile:boundary {}\n{}.\n\n",
        analysis.subject.slug(),
        lists.join("; ")
    )
}
