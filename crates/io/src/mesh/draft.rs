//! A mesh while it is read: nodes, then elements by the numbers of their nodes.
//!
//! Tetrahedra and triangles are kept apart, because a file says only at its end which of them are
//! its cells. Cells of second order whose middle nodes are the midpoints of their edges, as doubles,
//! are straight.

use super::element::{counted, is_curved_tetrahedron};
use super::error::{MeshError, Place};
use super::numbering::{Index, Numbering};
use super::{Mesh, Periodic};
use std::collections::BTreeMap;

/// No mesh has more points or more cells: indices have 32 bits, and the corners of all cells are
/// counted, too.
const MOST: usize = 1 << 29;

/// The edges of a cell in the order of its middle nodes, as VTK has them; the first three are those of
/// a triangle.
const EDGES: [(usize, usize); 6] = [(0, 1), (1, 2), (0, 2), (0, 3), (1, 3), (2, 3)];

/// An element of a file.
pub struct Element<'n> {
    /// Its number.
    pub tag: i64,
    /// Its physical group, material or reference; 0 for none.
    pub label: i64,
    /// Its geometric entity; 0 for none.
    pub entity: i64,
    /// Three nodes of a triangle, four of a tetrahedron, or six and ten of those of second order in
    /// VTK's order.
    pub nodes: &'n [i64],
    /// Where it stands.
    pub place: Place,
}

/// The parts of a mesh that have been read.
#[derive(Default)]
pub struct Draft {
    /// The nodes, and all that is no cell.
    pub mesh: Mesh,
    tetrahedra: Cells<4>,
    triangles: Cells<3>,
    /// The names of labels by the dimension of the cells.
    pub names: [BTreeMap<i64, String>; 4],
}

/// Cells of one type.
#[derive(Default)]
struct Cells<const N: usize> {
    corners: Vec<[u32; N]>,
    numbers: Numbering,
    lines: Option<Numbering>,
    labels: Vec<i64>,
    entities: Vec<i64>,
    /// The middle nodes of curved cells, by the index of the cell.
    middles: BTreeMap<usize, Vec<u32>>,
    /// The number of straight cells of second order.
    straight: usize,
}

/// A cell of second order.
struct Nodes<const N: usize> {
    corners: [u32; N],
    middles: Vec<u32>,
}

impl<const N: usize> Cells<N> {
    fn push(&mut self, element: &Element, corners: [u32; N]) {
        self.corners.push(corners);
        self.numbers.push(u64::try_from(element.tag).unwrap_or(0));
        self.labels.push(element.label);
        self.entities.push(element.entity);
        if let Place::Line(line) = element.place {
            self.lines.get_or_insert_default().push(line);
        }
    }

    /// A cell of second order, by its middle nodes.
    fn push_second_order(&mut self, points: &[[f64; 3]], element: &Element, nodes: Nodes<N>) {
        let point = |index: u32| points[index as usize];
        let is_straight = EDGES.iter().zip(&nodes.middles).all(|(&(a, b), &middle)| {
            let ends = [nodes.corners[a], nodes.corners[b]];
            let ([a, b], middle) = (ends.map(point), point(middle));
            (0..3).all(|k| is_midpoint(a[k], b[k], middle[k]))
        });
        if is_straight {
            self.straight += 1;
        } else {
            self.middles.insert(self.corners.len(), nodes.middles);
        }
        self.push(element, nodes.corners);
    }

    /// How many cells are of first order, and how many of second order.
    fn by_order(&self) -> [usize; 2] {
        let second = self.straight + self.middles.len();
        [self.corners.len() - second, second]
    }

    /// Gives numbers, lines and labels to the mesh.
    fn store(self, mesh: &mut Mesh) -> Vec<[u32; N]> {
        let known = |list: Vec<i64>| {
            if list.iter().all(|&label| label == 0) {
                Vec::new()
            } else {
                list
            }
        };
        mesh.elements = self.numbers;
        mesh.lines = self.lines;
        mesh.labels = known(self.labels);
        mesh.entities = known(self.entities);
        mesh.curved = self.middles;
        self.corners
    }
}

impl Draft {
    /// Appends a point.
    pub fn add_node(&mut self, tag: i64, point: [f64; 3], place: Place) -> Result<(), MeshError> {
        let tag = u64::try_from(tag)
            .map_err(|_| MeshError::at(place, format!("the node number {tag} is negative")))?;
        self.mesh.nodes.push(tag);
        self.mesh.points.push(point);
        Ok(())
    }

    /// Finds points by number.
    pub fn node_index(&self) -> Result<Index, MeshError> {
        if self.mesh.points.len() > MOST {
            return Err(MeshError::limit(format!(
                "has {} nodes, the limit is {MOST}",
                self.mesh.points.len()
            )));
        }
        self.mesh.nodes.index().map_err(|repeated| {
            let (first, second) = repeated.positions;
            MeshError::of_file(format!(
                "the node number {} occurs twice: node {} and node {} of the file",
                repeated.tag,
                first + 1,
                second + 1
            ))
        })
    }

    /// Appends a triangle or a tetrahedron.
    pub fn add(&mut self, index: &Index, element: &Element) -> Result<(), MeshError> {
        match element.nodes.len() {
            3 => {
                let corners = found(index, element, 0)?;
                self.triangles.push(element, corners);
            }
            6 => {
                let nodes = Nodes {
                    corners: found(index, element, 0)?,
                    middles: found::<3>(index, element, 3)?.to_vec(),
                };
                let points = &self.mesh.points;
                self.triangles.push_second_order(points, element, nodes);
            }
            10 => {
                let nodes = Nodes {
                    corners: found(index, element, 0)?,
                    middles: found::<6>(index, element, 4)?.to_vec(),
                };
                let points = &self.mesh.points;
                self.tetrahedra.push_second_order(points, element, nodes);
            }
            _ => {
                let corners = found(index, element, 0)?;
                self.tetrahedra.push(element, corners);
            }
        }
        Ok(())
    }

    /// Counts elements of another type.
    pub fn count_other(&mut self, name: &str, count: usize) {
        if count > 0 {
            *self.mesh.others.entry(name.to_owned()).or_default() += count;
        }
    }

    /// A part of the file that is passed over.
    pub fn pass(&mut self, name: impl Into<String>) {
        self.mesh.unread.push(name.into());
    }

    /// Appends a periodic link.
    pub fn add_link(&mut self, link: Periodic) {
        self.mesh.periodic.push(link);
    }

    /// How many elements there are as yet, of any type.
    pub fn element_count(&self) -> usize {
        let others = self.mesh.others.values().sum::<usize>();
        self.tetrahedra.corners.len() + self.triangles.corners.len() + others
    }

    /// The mesh, if it has cells and none with curved facets of a kind that is not known.
    pub fn finish(mut self) -> Result<Mesh, MeshError> {
        if self.tetrahedra.corners.is_empty() {
            let is_refused = |name: &&String| is_curved_tetrahedron(name);
            if let Some(name) = self.mesh.others.keys().find(is_refused) {
                let name = name.clone();
                return Err(self.refusal(&name));
            }
        } else if !self.triangles.corners.is_empty() {
            let [first, second] = self.triangles.by_order();
            self.count_other("triangles", first);
            self.count_other("second-order triangles", second);
            self.triangles = Cells::default();
        }
        if let Some(name) = self.mesh.others.keys().find(|n| is_curved_tetrahedron(n)) {
            let name = name.clone();
            return Err(self.refusal(&name));
        }
        let cells = self.tetrahedra.corners.len() + self.triangles.corners.len();
        if cells == 0 {
            let mut names = self.mesh.others.keys();
            if let Some(name) = names.find(|name| name.ends_with(" triangles")) {
                let count = counted(self.mesh.others[name], name);
                return Err(MeshError::limit(format!(
                    "has {count}, expected triangles with three or six nodes"
                )));
            }
            let others = if self.mesh.others.is_empty() {
                String::new()
            } else {
                format!(", but {}", self.mesh.other_counts())
            };
            return Err(MeshError::of_file(format!(
                "has no tetrahedra and no triangles{others}; expected a mesh of either"
            )));
        }
        if cells > MOST {
            return Err(MeshError::limit(format!(
                "has {cells} cells, the limit is {MOST}"
            )));
        }
        for (straight, kind) in [
            (self.tetrahedra.straight, "second-order tetrahedra"),
            (self.triangles.straight, "second-order triangles"),
        ] {
            if straight > 0 {
                let cells = counted(straight, kind);
                self.pass(format!(
                    "the middle nodes of {cells}, midpoints of their edges as doubles"
                ));
            }
        }
        let mut mesh = self.mesh;
        let [_, _, of_triangles, of_tetrahedra] = self.names;
        if self.tetrahedra.corners.is_empty() {
            mesh.triangles = self.triangles.store(&mut mesh);
            mesh.names = of_triangles;
        } else {
            mesh.tetrahedra = self.tetrahedra.store(&mut mesh);
            mesh.names = of_tetrahedra;
        }
        Ok(mesh)
    }

    fn refusal(&self, name: &str) -> MeshError {
        let count = counted(self.mesh.others[name], name);
        MeshError::limit(format!(
            "has {count}, expected tetrahedra with four nodes, or with ten from a format \
             whose order of nodes is documented: facets of the former need not be plane"
        ))
    }
}

/// N points from a position of the list of nodes.
fn found<const N: usize>(
    index: &Index,
    element: &Element,
    start: usize,
) -> Result<[u32; N], MeshError> {
    let mut points = [0; N];
    for (point, &node) in points.iter_mut().zip(&element.nodes[start..]) {
        *point = index.find(node).ok_or_else(|| {
            let problem = format!(
                "found the node {node} in the element {}; {}",
                element.tag,
                index.in_words()
            );
            MeshError::at(element.place, problem)
        })?;
    }
    Ok(points)
}

/// Whether m is the double nearest to the midpoint of a and b, as programs compute it. Halves are
/// exact, and so are doubles far from the least.
fn is_midpoint(a: f64, b: f64, m: f64) -> bool {
    m == (a + b) / 2.0 || m == a / 2.0 + b / 2.0
}
