//! Cells as VTK has them in legacy files and in VTU files.

use super::draft::{Draft, Element};
use super::element::{VTK_CELLS, counted, vtk_cell};
use super::error::{MeshError, Place};
use super::numbering::{Index, Numbering};

/// The cells of a file or of a piece of it.
#[derive(Default)]
pub struct Cells {
    /// The points of all cells.
    pub connectivity: Vec<i64>,
    /// Where the points of each cell end.
    pub ends: Vec<i64>,
    /// The type of each cell.
    pub types: Vec<i64>,
    /// The line of each cell, or nothing.
    pub lines: Numbering,
    /// Arrays of one integer for each cell, by name.
    pub arrays: Vec<(String, Vec<i64>)>,
}

/// Names of arrays that other programs give to materials, the likeliest first.
const MATERIALS: [&str; 12] = [
    "gmsh:physical",
    "material",
    "materialids",
    "material_id",
    "materialid",
    "medit:ref",
    "cell_tags",
    "attribute",
    "region",
    "label",
    "abaqus:ref",
    "nastran:ref",
];
/// Names of arrays for geometric entities.
const ENTITIES: [&str; 2] = ["gmsh:geometrical", "cellentityids"];

impl Cells {
    /// Adds the cells to the mesh; point p of a cell is the point p + `first` of the mesh.
    pub fn store(mut self, draft: &mut Draft, index: &Index, first: i64) -> Result<(), MeshError> {
        let (cells, types) = (self.ends.len(), self.types.len());
        if cells != types {
            return Err(MeshError::of_file(format!(
                "has {} and {}, expected one type for each cell",
                counted(cells, "cells"),
                counted(types, "cell types")
            )));
        }
        let entities = self.take(&ENTITIES).unwrap_or_default();
        let labels = self.take(&MATERIALS);
        let labels = labels
            .or_else(|| self.take_any(entities.is_empty()))
            .unwrap_or_default();
        for (name, _) in &self.arrays {
            draft.pass(format!("array {name} of cells"));
        }
        // Cells of all pieces are counted together.
        let before = draft.element_count();
        let mut start = 0;
        for (cell, (&end, &kind)) in self.ends.iter().zip(&self.types).enumerate() {
            let tag = (before + cell) as i64;
            let nodes = self.nodes(tag, start, end)?;
            start = end;
            let Some((_, expected)) = VTK_CELLS.into_iter().find(|(cell, _)| *cell == kind) else {
                draft.count_other(&vtk_cell(kind), 1);
                continue;
            };
            if nodes.len() != expected {
                return Err(MeshError::of_file(format!(
                    "cell {tag} of type {kind} has {} points, expected {expected}",
                    nodes.len()
                )));
            }
            let moved = |&node: &i64| {
                if node < 0 {
                    node
                } else {
                    node.saturating_add(first)
                }
            };
            let nodes: Vec<i64> = nodes.iter().map(moved).collect();
            let element = Element {
                tag,
                label: labels.get(cell).copied().unwrap_or(0),
                entity: entities.get(cell).copied().unwrap_or(0),
                nodes: &nodes,
                place: self.place(cell),
            };
            draft.add(index, &element)?;
        }
        if start == self.connectivity.len() as i64 {
            Ok(())
        } else {
            Err(MeshError::of_file(format!(
                "the cells have {start} points by their offsets, but {} are listed",
                self.connectivity.len()
            )))
        }
    }

    /// Takes the array with the first of these names that there is.
    fn take(&mut self, names: &[&str]) -> Option<Vec<i64>> {
        let found = names.iter().find_map(|name| {
            let is_named = |(array, _): &(String, Vec<i64>)| array.eq_ignore_ascii_case(name);
            self.arrays.iter().position(is_named)
        });
        found.map(|position| self.arrays.remove(position).1)
    }

    /// Takes the only array, if its name says nothing.
    fn take_any(&mut self, is_wanted: bool) -> Option<Vec<i64>> {
        let is_only = is_wanted && self.arrays.len() == 1;
        is_only.then(|| self.arrays.remove(0).1)
    }

    fn place(&self, cell: usize) -> Place {
        if cell < self.lines.len() {
            Place::Line(self.lines.get(cell))
        } else {
            Place::File
        }
    }

    fn nodes(&self, tag: i64, start: i64, end: i64) -> Result<&[i64], MeshError> {
        let range = usize::try_from(start).ok().zip(usize::try_from(end).ok());
        range
            .and_then(|(start, end)| self.connectivity.get(start..end))
            .ok_or_else(|| {
                MeshError::of_file(format!(
                    "cell {tag} has the points from {start} to {end} of a list of {}",
                    self.connectivity.len()
                ))
            })
    }
}
