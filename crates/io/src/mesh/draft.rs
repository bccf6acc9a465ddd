//! A mesh while it is read: nodes, then elements by the numbers of their nodes.
//!
//! Tetrahedra and triangles are kept apart, because a file says only at its end which of them are
//! its cells. Tetrahedra of second order whose middle nodes are the midpoints of their edges, as
//! doubles, are straight.

use super::element::is_curved_tetrahedron;
use super::error::{MeshError, Place};
use super::numbering::{Index, Numbering};
use super::{Mesh, Periodic};
use std::collections::BTreeMap;

/// No mesh has more points or more cells: indices have 32 bits, and the corners of all cells are
/// counted, too.
const MOST: usize = 1 << 29;

/// The edges of a tetrahedron in the order of its middle nodes, as VTK has them.
const EDGES: [(usize, usize); 6] = [(0, 1), (1, 2), (0, 2), (0, 3), (1, 3), (2, 3)];

/// An element of a file.
pub struct Element<'n> {
    /// Its number.
    pub tag: i64,
    /// Its physical group, material or reference; 0 for none.
    pub label: i64,
    /// Its geometric entity; 0 for none.
    pub entity: i64,
    /// Three nodes of a triangle, four of a tetrahedron, or ten of a tetrahedron of second order
    /// in VTK's order.
    pub nodes: &'n [i64],
    /// Where it stands.
    pub place: Place,
}

/// What has been read.
#[derive(Default)]
pub struct Draft {
    /// The nodes, and all that is no cell.
    pub mesh: Mesh,
    tetrahedra: Cells<4>,
    triangles: Cells<3>,
    middles: BTreeMap<usize, [u32; 6]>,
    straight: usize,
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

    /// Gives numbers, lines and labels to the mesh.
    fn store(self, mesh: &mut Mesh) -> Vec<[u32; N]> {
        let known = |list: Vec<i64>| match list.iter().all(|&label| label == 0) {
            true => Vec::new(),
            false => list,
        };
        mesh.elements = self.numbers;
        mesh.lines = self.lines;
        mesh.labels = known(self.labels);
        mesh.entities = known(self.entities);
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
                "the node number {} is there twice: node {} and node {} of the file",
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
            10 => {
                let corners = found(index, element, 0)?;
                let middles = found(index, element, 4)?;
                if self.is_straight(&corners, &middles) {
                    self.straight += 1;
                } else {
                    self.middles.insert(self.tetrahedra.corners.len(), middles);
                }
                self.tetrahedra.push(element, corners);
            }
            _ => {
                let corners = found(index, element, 0)?;
                self.tetrahedra.push(element, corners);
            }
        }
        Ok(())
    }

    /// Whether each middle node is the midpoint of its edge.
    fn is_straight(&self, corners: &[u32; 4], middles: &[u32; 6]) -> bool {
        let point = |index: u32| self.mesh.points[index as usize];
        EDGES.iter().zip(middles).all(|(&(a, b), &middle)| {
            let (a, b, middle) = (point(corners[a]), point(corners[b]), point(middle));
            (0..3).all(|k| is_midpoint(a[k], b[k], middle[k]))
        })
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
            self.count_other("triangles", self.triangles.corners.len());
            self.triangles = Cells::default();
        }
        if let Some(name) = self.mesh.others.keys().find(|n| is_curved_tetrahedron(n)) {
            let name = name.clone();
            return Err(self.refusal(&name));
        }
        let cells = self.tetrahedra.corners.len() + self.triangles.corners.len();
        if cells == 0 {
            let others = match self.mesh.others.is_empty() {
                true => String::new(),
                false => format!(", but {}", self.mesh.other_counts()),
            };
            return Err(MeshError::of_file(format!(
                "has no tetrahedra and no triangles{others}"
            )));
        }
        if cells > MOST {
            return Err(MeshError::limit(format!(
                "has {cells} cells, the limit is {MOST}"
            )));
        }
        if self.straight > 0 {
            self.pass(format!(
                "the middle nodes of {} second-order tetrahedra, midpoints of their edges as doubles",
                self.straight
            ));
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
        mesh.curved = self.middles;
        Ok(mesh)
    }

    fn refusal(&self, name: &str) -> MeshError {
        let count = self.mesh.others[name];
        MeshError::limit(format!(
            "has {count} {name}, expected tetrahedra with four nodes, or with ten from a format \
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
                "the element {} has the node {node}, which is not there",
                element.tag
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
