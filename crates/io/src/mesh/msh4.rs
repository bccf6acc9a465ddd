//! The sections of MSH 4.1: nodes, elements, periodic links. In text and in binary the
//! same numbers in the same order.

use super::element::{GMSH_TETRAHEDRON, gmsh_element};
use super::error::MeshError;
use super::numbering::{Index, periodic_node};
use super::source::Source;
use super::{Mesh, Periodic};

/// Blocks, items, and the smallest and the largest number of an item.
struct Totals {
    blocks: usize,
    items: usize,
}

fn totals(source: &mut Source, what: &str) -> Result<Totals, MeshError> {
    let blocks = source.long("the number of blocks")?;
    let items = source.long(&format!("the number of {what}"))?;
    source.long("the smallest number")?;
    source.long("the largest number")?;
    let least = source.least_bytes(4, 5);
    Ok(Totals {
        blocks: source.count(blocks, least, "blocks")?,
        items: source.count(items, source.least_bytes(1, 8), what)?,
    })
}

fn check_total(
    source: &Source,
    found: usize,
    totals: &Totals,
    what: &str,
) -> Result<(), MeshError> {
    match found == totals.items {
        true => Ok(()),
        false => Err(source.error(format!(
            "the blocks hold {found} {what}, expected {} as the section's head says",
            totals.items
        ))),
    }
}

/// For each block `dimension entity parametric count`, the numbers of the nodes, then
/// their coordinates, with parameters behind them where the block is parametric.
pub fn nodes(source: &mut Source, mesh: &mut Mesh) -> Result<(), MeshError> {
    let totals = totals(source, "nodes")?;
    for _ in 0..totals.blocks {
        let dimension = source.int("a dimension")?;
        source.int("an entity")?;
        let parametric = source.int("0, or 1 for parameters")?;
        let parameters = match (parametric, dimension) {
            (0, _) => 0,
            (1, 0..=3) => dimension,
            _ => {
                let problem = format!(
                    "found dimension {dimension} and parametric {parametric}, expected 0 to 3 \
                     and 0 or 1"
                );
                return Err(source.error(problem));
            }
        };
        let count = source.long("the number of nodes in a block")?;
        let count = source.count(count, source.least_bytes(4, 8), "nodes in a block")?;
        let mut tags = Vec::with_capacity(count);
        for _ in 0..count {
            tags.push(source.long("a node number")?);
        }
        for tag in tags {
            let point = [
                source.double("the coordinate x")?,
                source.double("the coordinate y")?,
                source.double("the coordinate z")?,
            ];
            for _ in 0..parameters {
                source.double("a parameter")?;
            }
            mesh.add_node(tag, point, source.place())?;
        }
    }
    check_total(source, mesh.points.len(), &totals, "nodes")
}

/// For each block `dimension entity type count`, then `tag node …` for each element.
pub fn elements(source: &mut Source, index: &Index, mesh: &mut Mesh) -> Result<(), MeshError> {
    let totals = totals(source, "elements")?;
    let mut done = 0;
    for _ in 0..totals.blocks {
        source.int("a dimension")?;
        let entity = source.int("an entity")?;
        let kind = source.int("an element type")?;
        let count = source.long("the number of elements in a block")?;
        let (name, nodes) = gmsh_element(kind).ok_or_else(|| {
            source.error(format!("found the element type {kind}, which is unknown"))
        })?;
        let least = source.least_bytes(1 + nodes, 8);
        let count = source.count(count, least, "elements in a block")?;
        done += count;
        if kind == GMSH_TETRAHEDRON {
            tetrahedra(source, count, index, mesh)?;
            mesh.labels.resize(mesh.tetrahedra.len(), entity);
            continue;
        }
        for _ in 0..count * (1 + nodes) {
            source.long("a number of an element or a node")?;
        }
        mesh.count_other(name, count);
    }
    check_total(source, done, &totals, "elements")
}

fn tetrahedra(
    source: &mut Source,
    count: usize,
    index: &Index,
    mesh: &mut Mesh,
) -> Result<(), MeshError> {
    mesh.tetrahedra.reserve(count);
    for _ in 0..count {
        let tag = source.long("an element number")?;
        let mut nodes = [0; 4];
        for node in &mut nodes {
            *node = source.long("a node number")?;
        }
        mesh.add_tetrahedron(index, tag, nodes, source.place())?;
    }
    Ok(())
}

/// For each link `dimension image original`, the number of entries of the affine map
/// (0 or 16) and the entries, then the number of pairs and the pairs.
pub fn periodic(source: &mut Source, index: &Index, mesh: &mut Mesh) -> Result<(), MeshError> {
    let links = source.long("the number of periodic links")?;
    let links = source.count(links, source.least_bytes(5, 5), "periodic links")?;
    for _ in 0..links {
        let dimension = source.int("a dimension")?;
        let entities = (source.int("an entity")?, source.int("an entity")?);
        let affine = affine(source)?;
        let pairs = source.long("the number of pairs of nodes")?;
        let pairs = source.count(pairs, source.least_bytes(2, 8), "pairs of nodes")?;
        let mut nodes = Vec::with_capacity(pairs);
        for _ in 0..pairs {
            let image = source.long("a node number")?;
            let original = source.long("a node number")?;
            nodes.push((
                periodic_node(index, image, source.place())?,
                periodic_node(index, original, source.place())?,
            ));
        }
        mesh.periodic.push(Periodic {
            dimension,
            entities,
            affine,
            nodes,
        });
    }
    Ok(())
}

fn affine(source: &mut Source) -> Result<Option<[f64; 16]>, MeshError> {
    match source.long("the number of entries of the affine map")? {
        0 => Ok(None),
        16 => {
            let mut matrix = [0.0; 16];
            for entry in &mut matrix {
                *entry = source.double("an entry of the affine map")?;
            }
            Ok(Some(matrix))
        }
        other => Err(source.error(format!(
            "found an affine map with {other} entries, expected 0 or 16"
        ))),
    }
}
