//! The cells of defects as a VTU file, to look at in ParaView.

use super::refutation::Refuted;
use acutile_core::checker::{Defect, Findings};
use acutile_core::tiling::{Corner, Facet, Tiling};
use acutile_core::with_dimension;
use acutile_exact::number::Number;
use acutile_io::mesh::sink::Shortest;
use std::fmt::Write;

/// A cell of the file.
struct Cell {
    points: Vec<[f64; 3]>,
    /// The defect, counted from 1, and its code.
    defect: usize,
    code: &'static str,
    /// The number of the element, 0 for a point.
    element: u64,
}

/// The cells of all defects that are kept: the simplices of each, its facets, and its point. Fields are
/// the number of the defect, the number of the element, and for each kind of defect 0 or 1.
pub fn vtu(refuted: &Refuted) -> String {
    let cells = with_dimension!(&refuted.tiling, AnyTiling, t => cells(t, refuted));
    let points: Vec<&[f64; 3]> = cells.iter().flat_map(|cell| &cell.points).collect();
    let mut text = String::from(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" \
         byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<UnstructuredGrid>\n",
    );
    // Writing to a string cannot fail.
    let _ = writeln!(
        text,
        "<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n<Points>",
        points.len(),
        cells.len()
    );
    let coordinates = points.iter().flat_map(|p| p.iter());
    let coordinates = coordinates.map(|x| Shortest(*x).to_string());
    array(
        &mut text,
        "Float64\" NumberOfComponents=\"3",
        "Points",
        coordinates,
    );
    text.push_str("</Points>\n<Cells>\n");
    array(&mut text, "Int64", "connectivity", 0..points.len());
    let ends = cells.iter().scan(0, |end, cell| {
        *end += cell.points.len();
        Some(*end)
    });
    array(&mut text, "Int64", "offsets", ends);
    // A vertex, a line, a triangle, a tetrahedron of VTK.
    let kinds = cells.iter().map(|cell| [0, 1, 3, 5, 10][cell.points.len()]);
    array(&mut text, "UInt8", "types", kinds);
    text.push_str("</Cells>\n<CellData>\n");
    array(
        &mut text,
        "Int64",
        "defect",
        cells.iter().map(|cell| cell.defect),
    );
    array(
        &mut text,
        "Int64",
        "element",
        cells.iter().map(|cell| cell.element),
    );
    for code in refuted.findings.counts().keys() {
        let has = cells.iter().map(|cell| u8::from(cell.code == *code));
        array(&mut text, "UInt8", code, has);
    }
    text.push_str("</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
    text
}

fn array(
    text: &mut String,
    kind: &str,
    name: &str,
    values: impl Iterator<Item = impl std::fmt::Display>,
) {
    let _ = writeln!(
        text,
        "<DataArray type=\"{kind}\" Name=\"{name}\" format=\"ascii\">"
    );
    for value in values {
        let _ = writeln!(text, "{value}");
    }
    text.push_str("</DataArray>\n");
}

fn cells<const D: usize>(tiling: &Tiling<D>, refuted: &Refuted) -> Vec<Cell> {
    let place = |point: &[Number]| -> [f64; 3] {
        let cartesian = match &refuted.origin {
            Some(origin) => origin.cartesian(point),
            None => point.to_vec(),
        };
        std::array::from_fn(|k| cartesian.get(k).map_or(0.0, Number::approximate))
    };
    let corner = |corner: &Corner<D>| place(&tiling.position(corner));
    let element = |simplex| match &refuted.origin {
        Some(origin) => origin.tetrahedron(simplex).tag,
        None => u64::from(acutile_core::tiling::SimplexId::number(simplex)),
    };
    let mut cells = Vec::new();
    for (defect, found) in (1..).zip(kept(&refuted.findings)) {
        let code = found.code();
        let mut add = |points: Vec<[f64; 3]>, element: u64| {
            cells.push(Cell {
                points,
                defect,
                code,
                element,
            });
        };
        for simplex in found.simplices() {
            let corners = tiling.simplex(simplex).iter().map(corner);
            add(corners.collect(), element(simplex));
        }
        for facet in facets(found) {
            let corners = tiling.simplex(facet.simplex).iter().enumerate();
            let corners = corners.filter(|(k, _)| *k != usize::from(facet.opposite));
            let points = corners.map(|(_, c)| corner(c)).collect();
            add(points, element(facet.simplex));
        }
        if let Defect::Overlap { point, .. } | Defect::BoundaryMeets { point, .. } = found {
            add(vec![place(point)], 0);
        }
    }
    cells
}

fn kept(findings: &Findings) -> impl Iterator<Item = &Defect> {
    findings.kept().iter()
}

/// The facets that a defect names.
pub(super) fn facets(defect: &Defect) -> Vec<Facet> {
    match defect {
        Defect::UnmatchedFacet { facet } | Defect::Covered { facet, .. } => vec![*facet],
        Defect::SameSide { facets: (a, b) } | Defect::BoundaryMeets { facets: (a, b), .. } => {
            vec![*a, *b]
        }
        Defect::OverusedFacet { facets }
        | Defect::Cavity { facets }
        | Defect::NotOnSurface { facets } => facets.clone(),
        Defect::NonConforming { sides, .. } => sides.concat(),
        _ => Vec::new(),
    }
}
