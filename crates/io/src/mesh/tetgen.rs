//! TetGen's `.node` and `.ele` files (TetGen manual, section "File formats"), and those of Triangle,
//! which have two coordinates and three or six nodes.
//!
//! One line is one item. Commas separate like spaces; missing numbers at the end of a head are 0;
//! columns beyond those that the head announces are ignored. Programs that write these files do not
//! agree on the order of a tetrahedron's corners. A mesh whose volumes all come out negative is
//! turned.

use super::Mesh;
use super::draft::{Draft, Element};
use super::error::{MeshError, Place};
use super::lines::{Line, Lines, words};
use super::numbering::Index;

/// The nodes: a head `count dimension attributes markers`, then `number x y z …` for each. Gives a
/// mesh without cells, and finds its points by number.
pub fn read_nodes(bytes: &[u8]) -> Result<(Draft, Index), MeshError> {
    let mut lines = Lines::new(words(bytes, b'#'), bytes.len());
    let head = lines.next("the number of nodes")?;
    let count: usize = head.parsed(0, "the number of nodes")?;
    let dimension = match head.entry(1, "the dimension")? {
        found @ (2 | 3) => found,
        0 => 3,
        found => return Err(head.error(format!("found dimension {found}, expected 2 or 3"))),
    };
    let attributes = head.entry(2, "the number of attributes")?;
    let markers = head.entry(3, "the number of boundary markers")?;
    check_count(&head, count, lines.length, "nodes")?;
    let mut draft = Draft::default();
    for _ in 0..count {
        let line = lines.next("a node")?;
        let mut point = [0.0; 3];
        for (k, x) in point[..dimension].iter_mut().enumerate() {
            *x = line.coordinate(1 + k)?;
        }
        let tag = line.parsed(0, "a node number, an integer")?;
        draft.add_node(tag, point, Place::Line(line.number))?;
    }
    lines.expect_end("nodes")?;
    if attributes + markers > 0 {
        draft.pass(format!(
            "{attributes} attributes and {markers} markers of each node"
        ));
    }
    let index = draft.node_index()?;
    Ok((draft, index))
}

/// The elements: a head `count corners attributes`, then `number node … attribute …` for each.
pub fn read_elements(bytes: &[u8], mut draft: Draft, index: &Index) -> Result<Mesh, MeshError> {
    let mut lines = Lines::new(words(bytes, b'#'), bytes.len());
    let head = lines.next("the number of elements")?;
    let count: usize = head.parsed(0, "the number of elements")?;
    let corners = match head.entry(1, "the nodes of an element")? {
        0 => 4,
        found @ (3 | 4 | 6 | 10) => found,
        found => {
            let problem = format!(
                "found {found} nodes in an element, expected 4 or 10 for tetrahedra, 3 or 6 for triangles"
            );
            return Err(MeshError {
                is_limit: true,
                ..head.error(problem)
            });
        }
    };
    let attributes = head.entry(2, "the number of attributes")?;
    check_count(&head, count, lines.length, "elements")?;
    let mut fractional = false;
    for _ in 0..count {
        let line = lines.next("an element")?;
        let mut nodes = [0; 10];
        for (k, node) in nodes[..corners].iter_mut().enumerate() {
            *node = line.parsed(1 + k, "a node number, an integer")?;
        }
        match corners {
            10 => nodes = vtk_order(nodes),
            // Triangle has the middle nodes on the edges 12, 02 and 01.
            6 => nodes[3..6].rotate_right(1),
            _ => {}
        }
        let label = match attributes {
            0 => 0.0,
            _ => line.coordinate(1 + corners)?,
        };
        let is_integer = label == label.trunc() && label.abs() < 1e15;
        fractional |= !is_integer;
        let element = Element {
            tag: line.parsed(0, "an element number, an integer")?,
            label: if is_integer { label as i64 } else { 0 },
            entity: 0,
            nodes: &nodes[..corners],
            place: Place::Line(line.number),
        };
        draft.add(index, &element)?;
    }
    lines.expect_end("elements")?;
    if attributes > 1 || fractional {
        draft.pass("attributes of elements");
    }
    let mut mesh = draft.finish()?;
    if fractional {
        mesh.labels.clear();
    }
    if mesh.dimension() == 3 && are_all_negative(&mesh) {
        turn(&mut mesh);
    }
    Ok(mesh)
}

/// Each item takes a line of at least two bytes.
fn check_count(head: &Line, count: usize, length: usize, what: &str) -> Result<(), MeshError> {
    if count <= length / 2 {
        Ok(())
    } else {
        Err(head.error(format!(
            "found {count} as the number of {what}, but the file has only {length} bytes"
        )))
    }
}

/// TetGen 1.5 with -o2 has the middle nodes on the edges 23, 03, 01, 12, 13 and 02; VTK on 01, 12, 02,
/// 03, 13 and 23.
fn vtk_order([a, b, c, d, cd, ad, ab, bc, bd, ac]: [i64; 10]) -> [i64; 10] {
    [a, b, c, d, ab, bc, ac, ad, bd, cd]
}

/// Exchanges the last two corners of all tetrahedra.
fn turn(mesh: &mut Mesh) {
    for corners in &mut mesh.tetrahedra {
        corners.swap(2, 3);
    }
    for middles in mesh.curved.values_mut() {
        if let [ab, bc, ac, ad, bd, cd] = middles[..] {
            *middles = vec![ab, bd, ad, ac, bc, cd];
        }
    }
    mesh.turned = mesh.tetrahedra.len();
}

/// Whether no tetrahedron comes out positive; in doubles, for the checker decides what the
/// orientation is after all.
fn are_all_negative(mesh: &Mesh) -> bool {
    mesh.tetrahedra.iter().all(|corners| {
        let [a, b, c, d] = corners.map(|corner| mesh.points[corner as usize]);
        let edge = |p: [f64; 3]| -> [f64; 3] { std::array::from_fn(|k| p[k] - a[k]) };
        let (b, c, d) = (edge(b), edge(c), edge(d));
        let cross = |k: usize| c[(k + 1) % 3] * d[(k + 2) % 3] - c[(k + 2) % 3] * d[(k + 1) % 3];
        b[0] * cross(0) + b[1] * cross(1) + b[2] * cross(2) < 0.0
    })
}
