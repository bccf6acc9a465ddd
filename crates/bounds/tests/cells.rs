//! The 600-cell against known facts, and complexes that are not the 600-cell.

use acutile_bounds::Verdict;
use acutile_bounds::cell600::{Cells, checks};
use acutile_core::classify::{Code, code};
use std::collections::{BTreeMap, BTreeSet};

/// The verdicts by name.
fn verdicts(cells: &Cells) -> BTreeMap<&'static str, Verdict> {
    let checks = checks(cells);
    checks
        .iter()
        .map(|check| (check.id, check.verdict))
        .collect()
}

fn failing(cells: &Cells) -> Vec<&'static str> {
    let verdicts = verdicts(cells);
    assert!(
        verdicts
            .values()
            .all(|verdict| *verdict != Verdict::Undecided)
    );
    let failing = verdicts
        .iter()
        .filter(|(_, verdict)| **verdict == Verdict::Fails);
    failing.map(|(id, _)| *id).collect()
}

/// H. S. M. Coxeter, Regular polytopes: {3, 3, 5} has 120 vertices, and its vertex figure is the
/// icosahedron {3, 5}.
#[test]
fn vertex_figures_are_icosahedra() {
    let cells = Cells::of_600_cell();
    assert_eq!((cells.vertices, cells.cells.len()), (120, 600));
    let icosahedron = code(&ICOSAHEDRON).expect("a sphere");
    for vertex in 0..120 {
        assert_eq!(figure(&cells, vertex), icosahedron, "vertex {vertex}");
    }
}

/// The triangles opposite a vertex, turned so that they are consistent.
fn figure(cells: &Cells, vertex: usize) -> Code {
    let at_vertex = cells.cells.iter().filter(|cell| cell.contains(&vertex));
    let others = at_vertex.map(|cell| {
        let rest: Vec<usize> = cell.iter().copied().filter(|v| *v != vertex).collect();
        <[usize; 3]>::try_from(rest).expect("three vertices")
    });
    let mut open: Vec<[usize; 3]> = others.collect();
    assert_eq!(open.len(), 20);
    let vertices: BTreeSet<usize> = open.iter().flatten().copied().collect();
    let number: BTreeMap<usize, usize> = vertices.into_iter().zip(0..).collect();
    let mut done = vec![open.remove(0)];
    while !open.is_empty() {
        let (k, turned) = open
            .iter()
            .enumerate()
            .find_map(|(k, [a, b, c])| {
                let ways = [[*a, *b, *c], [*b, *a, *c]];
                ways.into_iter()
                    .find(|way| done.iter().any(|other| is_glued(way, other)))
                    .map(|way| (k, way))
            })
            .expect("a connected figure");
        open.remove(k);
        done.push(turned);
    }
    let numbered: Vec<[usize; 3]> = done.iter().map(|t| t.map(|v| number[&v])).collect();
    code(&numbered).expect("a sphere")
}

/// Whether an edge of one triangle is an edge of the other in the opposite direction.
fn is_glued(x: &[usize; 3], y: &[usize; 3]) -> bool {
    let edges = |t: &[usize; 3]| [(t[0], t[1]), (t[1], t[2]), (t[2], t[0])];
    edges(x).iter().any(|(a, b)| edges(y).contains(&(*b, *a)))
}

/// A pentagonal antiprism between two poles, by hand.
const ICOSAHEDRON: [[usize; 3]; 20] = [
    [0, 1, 2],
    [0, 2, 3],
    [0, 3, 4],
    [0, 4, 5],
    [0, 5, 1],
    [1, 6, 2],
    [2, 7, 3],
    [3, 8, 4],
    [4, 9, 5],
    [5, 10, 1],
    [2, 6, 7],
    [3, 7, 8],
    [4, 8, 9],
    [5, 9, 10],
    [1, 10, 6],
    [11, 7, 6],
    [11, 8, 7],
    [11, 9, 8],
    [11, 10, 9],
    [11, 6, 10],
];

/// The boundary of the 16-cell: one of ±e_k for each k. Its edges have four cells.
fn cells_of_16_cell() -> Cells {
    let cells = (0..16).map(|signs: usize| [0, 1, 2, 3].map(|k| 2 * k + (signs >> k & 1)));
    Cells {
        vertices: 8,
        cells: cells.collect(),
    }
}

#[test]
fn other_complexes_fail() {
    assert_eq!(failing(&Cells::of_600_cell()), Vec::<&str>::new());
    assert_eq!(
        failing(&cells_of_16_cell()),
        ["counts", "deductions", "edges", "tree"]
    );
    // A cell is missing: four triangles have one cell, and six edges have a gap.
    let mut open = Cells::of_600_cell();
    open.cells.pop();
    assert_eq!(
        failing(&open),
        ["counts", "deductions", "edges", "facets", "tree"]
    );
    // A cell occurs twice.
    let mut double = Cells::of_600_cell();
    double.cells[1] = double.cells[0];
    let failing = failing(&double);
    assert!(
        failing.contains(&"facets") && failing.contains(&"edges"),
        "{failing:?}"
    );
}

/// Two copies are no connected complex, though all edges have five cells.
#[test]
fn two_copies_fail() {
    let one = Cells::of_600_cell();
    let copy = one.cells.iter().map(|cell| cell.map(|v| v + 120));
    let two = Cells {
        vertices: 240,
        cells: one.cells.iter().copied().chain(copy).collect(),
    };
    assert_eq!(failing(&two), ["counts", "deductions", "tree"]);
}
