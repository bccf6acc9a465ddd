//! The sections of MSH 4.1: nodes, elements, periodic links. In text and in binary the
//! same numbers in the same order.

use super::Periodic;
use super::draft::{Draft, Element};
use super::element::{GMSH_CELLS, gmsh_element, gmsh_order};
use super::error::MeshError;
use super::msh_sections::{Entities, affine_map, periodic_nodes};
use super::numbering::Index;
use super::source::Source;

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

/// The items of all blocks are as many as the section's head says.
pub fn check_total(
    source: &Source,
    found: usize,
    expected: usize,
    what: &str,
) -> Result<(), MeshError> {
    if found == expected {
        Ok(())
    } else {
        Err(source.error(format!(
            "the blocks hold {found} {what}, expected {expected} as the section's head says"
        )))
    }
}

/// How many parameters follow the coordinates of a node.
pub fn parameters(source: &Source, dimension: i64, parametric: i64) -> Result<i64, MeshError> {
    match (parametric, dimension) {
        (0, _) => Ok(0),
        (1, 0..=3) => Ok(dimension),
        _ => Err(source.error(format!(
            "found dimension {dimension} and parametric {parametric}, expected 0 to 3 and 0 or 1"
        ))),
    }
}

/// For each block `dimension entity parametric count`, the numbers of the nodes, then
/// their coordinates, followed by parameters where the block is parametric.
pub fn nodes(source: &mut Source, draft: &mut Draft) -> Result<(), MeshError> {
    let totals = totals(source, "nodes")?;
    for _ in 0..totals.blocks {
        let dimension = source.int("a dimension")?;
        source.int("an entity")?;
        let parametric = source.int("0, or 1 for parameters")?;
        let parameters = parameters(source, dimension, parametric)?;
        let count = source.long("the number of nodes in a block")?;
        let count = source.count(count, source.least_bytes(4, 8), "nodes in a block")?;
        let mut tags = Vec::with_capacity(count);
        for _ in 0..count {
            tags.push(source.long("a node number")?);
        }
        for tag in tags {
            let point = source.point()?;
            for _ in 0..parameters {
                source.double("a parameter")?;
            }
            draft.add_node(tag, point, source.place())?;
        }
    }
    check_total(source, draft.mesh.points.len(), totals.items, "nodes")
}

/// For each block `dimension entity type count`, then `tag node …` for each element.
pub fn elements(
    source: &mut Source,
    index: &Index,
    entities: &Entities,
    draft: &mut Draft,
) -> Result<(), MeshError> {
    let totals = totals(source, "elements")?;
    let (mut done, mut further) = (0, 0);
    for _ in 0..totals.blocks {
        let dimension = source.int("a dimension")?;
        let entity = source.int("an entity")?;
        let kind = source.int("an element type")?;
        let count = source.long("the number of elements in a block")?;
        let (name, width) = gmsh_element(kind).ok_or_else(|| {
            source.error(format!("found the element type {kind}, which is unknown"))
        })?;
        let least = source.least_bytes(1 + width, 8);
        let count = source.count(count, least, "elements in a block")?;
        done += count;
        if !GMSH_CELLS.contains(&kind) {
            for _ in 0..count * (1 + width) {
                source.long("a number of an element or a node")?;
            }
            draft.count_other(name, count);
            continue;
        }
        let (label, others) = entities.group(dimension, entity);
        further += others * count;
        let mut nodes = vec![0; width];
        for _ in 0..count {
            let tag = source.long("an element number")?;
            for node in &mut nodes {
                *node = source.long("a node number")?;
            }
            let element = Element {
                tag,
                label,
                entity,
                nodes: gmsh_order(&mut nodes),
                place: source.place(),
            };
            draft.add(index, &element)?;
        }
    }
    if further > 0 {
        draft.pass(format!("{further} further physical groups of elements"));
    }
    check_total(source, done, totals.items, "elements")
}

/// A link is `dimension image original`, then the number of entries of the affine map (0 or 16) and
/// the entries. The number of pairs and the pairs follow.
pub fn periodic(source: &mut Source, index: &Index, draft: &mut Draft) -> Result<(), MeshError> {
    let links = source.long("the number of periodic links")?;
    let links = source.count(links, source.least_bytes(5, 5), "periodic links")?;
    for _ in 0..links {
        let dimension = source.int("a dimension")?;
        let entities = (source.int("an entity")?, source.int("an entity")?);
        let affine = affine(source)?;
        let pairs = source.long("the number of pairs of nodes")?;
        let pairs = source.count(pairs, source.least_bytes(2, 8), "pairs of nodes")?;
        let nodes = periodic_nodes(source, index, pairs, Source::long)?;
        draft.add_link(Periodic {
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
        16 => affine_map(source).map(Some),
        other => Err(source.error(format!(
            "found an affine map with {other} entries, expected 0 or 16"
        ))),
    }
}
