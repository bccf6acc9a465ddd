//! Tetrahedral meshes of other programs: read, written, turned into tilings and back.
//!
//! | file | holds |
//! |---|---|
//! | `mod.rs` | [`Mesh`]: what all formats have in common |
//! | [`mod@format`] | [`Format`]: names, extensions, how a file is recognised |
//! | [`mod@load`] | a file, or standard input, read into a mesh |
//! | `msh`, `msh2`, `msh4`, `msh_write` | Gmsh MSH 2 and 4.1 |
//! | `vtk`, `vtu`, `vtu_data`, `vtu_parts`, `vtu_write` | VTK legacy and XML files |
//! | `medit`, `tetgen` | MEDIT `.mesh` and `.meshb`, TetGen `.node` and `.ele` |
//! | [`source`], [`numbering`], `element`, [`error`] | what the readers share |
//! | [`sink`], [`writer`] | what the writers share; which writer a format has |
//! | [`lattice`] | the lattice of a periodic mesh |
//! | [`convert`], `identify`, `snap` | a mesh as a tiling |
//! | [`origin`] | a tiling's indices in the numbers of the file |
//! | [`mod@flatten`], `patch` | a tiling as a mesh |
//!
//! A reader checks form; whether the mesh tiles anything is the checker's business.
//! Every coordinate is a finite double and means the dyadic rational that it is.

pub mod convert;
mod element;
pub mod error;
pub mod flatten;
pub mod format;
mod identify;
pub mod lattice;
pub mod load;
mod medit;
mod msh;
mod msh2;
mod msh4;
mod msh_write;
pub mod numbering;
pub mod origin;
mod patch;
pub mod sink;
mod snap;
pub mod source;
mod tetgen;
mod vtk;
mod vtu;
mod vtu_data;
mod vtu_parts;
mod vtu_write;
pub mod writer;

pub use convert::{Converted, periodic_tiling, region_tiling};
pub use error::{MeshError, Place};
pub use flatten::{Flat, flatten};
pub use format::{Family, Format};
pub use lattice::Lattice;
pub use load::{Loaded, load};
pub use numbering::Numbering;
pub use origin::Origin;
pub use patch::patch;
pub use snap::Move;
pub use writer::{File, write};

use element::is_curved_tetrahedron;
use numbering::Index;
use std::collections::BTreeMap;

/// Points and tetrahedra with the numbers that a file gives them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Cartesian coordinates, finite.
    pub points: Vec<[f64; 3]>,
    /// The number of each point.
    pub nodes: Numbering,
    /// Four points each, by their indices in `points`; where the determinant of
    /// the differences to the first is positive, the orientation is.
    pub tetrahedra: Vec<[u32; 4]>,
    /// The number of each tetrahedron.
    pub elements: Numbering,
    /// The line of each tetrahedron, for text.
    pub lines: Option<Numbering>,
    /// A label of each tetrahedron (region, material, reference), or nothing.
    pub labels: Vec<i64>,
    /// How many elements of other types there are, by name.
    pub others: BTreeMap<String, usize>,
    /// Parts of the file that were passed over: sections, arrays, further labels.
    pub unread: Vec<String>,
    /// How parts of the boundary are images of each other.
    pub periodic: Vec<Periodic>,
    /// How many tetrahedra were turned because the format's convention is the opposite.
    pub turned: usize,
}

/// An entity of the boundary that is the image of another one.
#[derive(Clone, Debug, PartialEq)]
pub struct Periodic {
    /// 0 for points, 1 for curves, 2 for surfaces.
    pub dimension: i64,
    /// The numbers of the image and of the original.
    pub entities: (i64, i64),
    /// The rows of a 4 x 4 matrix that takes the original to the image.
    pub affine: Option<[f64; 16]>,
    /// Pairs of an image and its original, as indices of points.
    pub nodes: Vec<(u32, u32)>,
}

impl Mesh {
    /// Appends a point.
    fn add_node(&mut self, tag: i64, point: [f64; 3], place: Place) -> Result<(), MeshError> {
        let tag = u64::try_from(tag)
            .map_err(|_| MeshError::at(place, format!("the node number {tag} is negative")))?;
        self.nodes.push(tag);
        self.points.push(point);
        Ok(())
    }

    /// Finds points by number.
    fn node_index(&self) -> Result<Index, MeshError> {
        if self.points.len() > MOST {
            return Err(MeshError::limit(format!(
                "has {} nodes, the limit is {MOST}",
                self.points.len()
            )));
        }
        self.nodes.index().map_err(|repeated| {
            let (first, second) = repeated.positions;
            MeshError::of_file(format!(
                "the node number {} is there twice: node {} and node {} of the file",
                repeated.tag,
                first + 1,
                second + 1
            ))
        })
    }

    /// Appends a tetrahedron by the numbers of its nodes.
    fn add_tetrahedron(
        &mut self,
        index: &Index,
        tag: i64,
        nodes: [i64; 4],
        place: Place,
    ) -> Result<(), MeshError> {
        let mut corners = [0; 4];
        for (corner, node) in corners.iter_mut().zip(nodes) {
            *corner = index.find(node).ok_or_else(|| {
                let problem =
                    format!("the tetrahedron {tag} has the node {node}, which is not there");
                MeshError::at(place, problem)
            })?;
        }
        self.tetrahedra.push(corners);
        self.elements.push(u64::try_from(tag).unwrap_or(0));
        if let Place::Line(line) = place {
            self.lines.get_or_insert_default().push(line);
        }
        Ok(())
    }

    /// Counts an element of another type.
    fn count_other(&mut self, name: &str, count: usize) {
        if count > 0 {
            *self.others.entry(name.to_owned()).or_default() += count;
        }
    }

    /// Exchanges the last two corners of all tetrahedra.
    fn turn(&mut self) {
        for corners in &mut self.tetrahedra {
            corners.swap(2, 3);
        }
        self.turned = self.tetrahedra.len();
    }

    /// The mesh, if it has tetrahedra and none with curved facets.
    fn checked(self) -> Result<Mesh, MeshError> {
        if let Some((name, count)) = self.others.iter().find(|(n, _)| is_curved_tetrahedron(n)) {
            return Err(MeshError::of_file(format!(
                "has {count} {name}, expected tetrahedra with four nodes: facets of the former \
                 need not be plane"
            )));
        }
        if self.tetrahedra.is_empty() {
            let others = match self.others.is_empty() {
                true => String::new(),
                false => format!(", but {}", self.other_counts()),
            };
            return Err(MeshError::of_file(format!("has no tetrahedra{others}")));
        }
        if self.tetrahedra.len() > MOST {
            return Err(MeshError::limit(format!(
                "has {} tetrahedra, the limit is {MOST}",
                self.tetrahedra.len()
            )));
        }
        Ok(self)
    }

    /// `12 triangles, 4 points`: the elements of other types.
    pub fn other_counts(&self) -> String {
        let counts = self.others.iter().map(|(name, n)| format!("{n} {name}"));
        counts.collect::<Vec<_>>().join(", ")
    }

    /// Which points are corners of tetrahedra.
    pub fn used_points(&self) -> Vec<bool> {
        let mut used = vec![false; self.points.len()];
        for &corner in self.tetrahedra.iter().flatten() {
            used[corner as usize] = true;
        }
        used
    }
}

/// No mesh has more points or more tetrahedra: indices have 32 bits, and four corners
/// of a tetrahedron are counted, too.
const MOST: usize = 1 << 29;
