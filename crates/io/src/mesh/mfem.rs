//! MFEM meshes, versions 1.0 to 1.3 (mfem.org, "MFEM mesh formats"). Attributes are the labels, and
//! vertices are numbered from 0. Nodes of a finite element space are read where it is the linear one.

use super::Mesh;
use super::draft::{Draft, Element};
use super::error::{MeshError, Place};
use super::source::{Source, shown};

/// Names and numbers of vertices of the geometry types 0 to 7.
const GEOMETRIES: [(&str, usize); 8] = [
    ("points", 1),
    ("lines", 2),
    ("triangles", 3),
    ("quadrangles", 4),
    ("tetrahedra", 4),
    ("hexahedra", 8),
    ("prisms", 6),
    ("pyramids", 5),
];

/// An element of the list of elements or of the boundary.
struct Pending {
    label: i64,
    /// The name of its geometry type.
    kind: &'static str,
    nodes: Vec<i64>,
    place: Place,
}

/// Reads a file of the conforming format.
pub fn read(bytes: &[u8]) -> Result<Mesh, MeshError> {
    let mut source = Source::with_comments(bytes, b'#');
    head(&mut source)?;
    let mut draft = Draft::default();
    let mut elements = Vec::new();
    let mut dimension = 3;
    let mut vertices = None;
    while let Some(word) = source.try_word() {
        match word {
            b"dimension" => dimension = source.int("the dimension")?,
            b"elements" => elements = list(&mut source)?,
            b"boundary" => {
                for element in list(&mut source)? {
                    draft.count_other(&format!("boundary {}", element.kind), 1);
                }
            }
            b"vertices" => vertices = Some(vertex_list(&mut source, &mut draft)?),
            b"nodes" => nodes(&mut source, &mut draft, vertices.unwrap_or(0))?,
            b"mfem_mesh_end" => break,
            b"attribute_sets" | b"bdr_attribute_sets" => {
                draft.pass(String::from_utf8_lossy(word));
                skip_sets(&mut source)?;
            }
            _ => return Err(source.unexpected(word, "dimension, elements, boundary, vertices")),
        }
    }
    if !(2..=3).contains(&dimension) {
        return Err(MeshError::of_file(format!(
            "found dimension {dimension}, expected 2 or 3"
        )));
    }
    let index = draft.node_index()?;
    for (tag, pending) in (0..).zip(&elements) {
        if !matches!(pending.kind, "triangles" | "tetrahedra") {
            draft.count_other(pending.kind, 1);
            continue;
        }
        let element = Element {
            tag,
            label: pending.label,
            entity: 0,
            nodes: &pending.nodes,
            place: pending.place,
        };
        draft.add(&index, &element)?;
    }
    draft.finish()
}

/// `MFEM mesh v1.0`
fn head(source: &mut Source) -> Result<(), MeshError> {
    let line = source.rest_of_line();
    match line {
        b"MFEM mesh v1.0" | b"MFEM mesh v1.1" | b"MFEM mesh v1.2" | b"MFEM mesh v1.3" => Ok(()),
        _ => Err(MeshError {
            place: Place::Line(1),
            ..MeshError::limit(format!(
                "found {}, expected MFEM mesh v1.0 to v1.3 (no NC, NURBS or INLINE mesh)",
                shown(line)
            ))
        }),
    }
}

/// The number of elements, then `attribute geometry vertex …` for each.
fn list(source: &mut Source) -> Result<Vec<Pending>, MeshError> {
    let count = source.int("the number of elements")?;
    let count = source.count(count, 4, "elements")?;
    let mut list = Vec::with_capacity(count);
    for _ in 0..count {
        let label = source.int("an attribute")?;
        let found = source.int("a geometry type")?;
        let geometry = usize::try_from(found).unwrap_or(usize::MAX);
        let Some((kind, width)) = GEOMETRIES.get(geometry) else {
            return Err(source.error(format!("found geometry type {found}, expected 0 to 7")));
        };
        let mut nodes = Vec::with_capacity(*width);
        for _ in 0..*width {
            nodes.push(source.int("a vertex")?);
        }
        list.push(Pending {
            label,
            kind,
            nodes,
            place: source.place(),
        });
    }
    Ok(list)
}

/// The number of vertices, their dimension and coordinates; only the number, if `nodes` follow.
fn vertex_list(source: &mut Source, draft: &mut Draft) -> Result<usize, MeshError> {
    let count = source.int("the number of vertices")?;
    let count = source.count(count, 1, "vertices")?;
    let mut ahead = source.clone();
    if ahead.try_word().is_none_or(|word| word == b"nodes") {
        return Ok(count);
    }
    let width = source.int("the dimension of vertices")?;
    if !(2..=3).contains(&width) {
        return Err(source.error(format!("found {width} coordinates, expected 2 or 3")));
    }
    for tag in 0..count as i64 {
        let mut point = [0.0; 3];
        for x in point.iter_mut().take(width as usize) {
            *x = source.double("a coordinate")?;
        }
        draft.add_node(tag, point, source.place())?;
    }
    Ok(count)
}

/// A grid function: the space, its dimension and order, then the coordinates.
fn nodes(source: &mut Source, draft: &mut Draft, count: usize) -> Result<(), MeshError> {
    source.expect("FiniteElementSpace")?;
    source.expect("FiniteElementCollection:")?;
    let space = source.word("a collection like H1_3D_P1")?;
    let is_linear = matches!(space, b"Linear" | b"H1_2D_P1" | b"H1_3D_P1");
    if !is_linear {
        return Err(MeshError {
            place: source.place(),
            ..MeshError::limit(format!(
                "found nodes of the space {}, expected Linear, H1_2D_P1 or H1_3D_P1: others may \
                 be curved",
                shown(space)
            ))
        });
    }
    source.expect("VDim:")?;
    let width = source.int("the number of coordinates")?;
    source.expect("Ordering:")?;
    let by_vertex = source.int("0 or 1")? == 1;
    let width = usize::try_from(width)
        .ok()
        .filter(|width| (2..=3).contains(width))
        .ok_or_else(|| source.error(format!("found VDim {width}, expected 2 or 3")))?;
    source.count((count * width) as i64, 2, "coordinates")?;
    if !draft.mesh.points.is_empty() {
        return Err(source.error("found nodes after the coordinates of vertices, expected one"));
    }
    let mut points = vec![[0.0; 3]; count];
    for index in 0..count * width {
        let (vertex, k) = if by_vertex {
            (index / width, index % width)
        } else {
            (index % count, index / count)
        };
        let read = source.double("a coordinate")?;
        if let Some(x) = points.get_mut(vertex).and_then(|point| point.get_mut(k)) {
            *x = read;
        }
    }
    for (tag, point) in (0..).zip(points) {
        draft.add_node(tag, point, source.place())?;
    }
    Ok(())
}

/// The number of sets, then a line for each.
fn skip_sets(source: &mut Source) -> Result<(), MeshError> {
    let count = source.int("the number of sets")?;
    let count = source.count(count, 2, "sets")?;
    source.rest_of_line();
    for _ in 0..count {
        source.rest_of_line();
    }
    Ok(())
}
