//! The sections of MSH 4.0: nodes, elements, periodic links. Numbers of nodes and elements have 32
//! bits, and each node is beside its number.

use super::draft::{Draft, Element};
use super::element::{GMSH_CELLS, gmsh_element, gmsh_order};
use super::error::MeshError;
use super::msh_sections::{Entities, affine_map, periodic_nodes};
use super::numbering::Index;
use super::source::{Encoding, Source};
use super::{Periodic, msh4};

/// Blocks of `entity dimension parametric count`, then `tag x y z parameters` for each node.
pub fn nodes(source: &mut Source, draft: &mut Draft) -> Result<(), MeshError> {
    let (blocks, total) = head(source, "nodes")?;
    for _ in 0..blocks {
        source.int("an entity")?;
        let dimension = source.int("a dimension")?;
        let parametric = source.int("0, or more for parameters")?;
        let parameters = msh4::parameters(source, dimension, parametric)?;
        let count = source.long("the number of nodes in a block")?;
        for _ in 0..source.count(count, source.least_bytes(4, 4), "nodes in a block")? {
            let tag = source.int("a node number")?;
            let point = source.point()?;
            for _ in 0..parameters {
                source.double("a parameter")?;
            }
            draft.add_node(tag, point, source.place())?;
        }
    }
    msh4::check_total(source, draft.mesh.points.len(), total, "nodes")
}

fn head(source: &mut Source, what: &str) -> Result<(usize, usize), MeshError> {
    let blocks = source.long("the number of blocks")?;
    let items = source.long(&format!("the number of {what}"))?;
    Ok((
        source.count(blocks, source.least_bytes(4, 5), "blocks")?,
        source.count(items, source.least_bytes(1, 4), what)?,
    ))
}

/// Blocks of `entity dimension type count`, then `tag node …` for each element.
pub fn elements(
    source: &mut Source,
    index: &Index,
    entities: &Entities,
    draft: &mut Draft,
) -> Result<(), MeshError> {
    let (blocks, total) = head(source, "elements")?;
    let mut done = 0;
    for _ in 0..blocks {
        let entity = source.int("an entity")?;
        let dimension = source.int("a dimension")?;
        let kind = source.int("an element type")?;
        let count = source.long("the number of elements in a block")?;
        let (name, width) = gmsh_element(kind).ok_or_else(|| {
            source.error(format!("found the element type {kind}, which is unknown"))
        })?;
        let least = source.least_bytes(1 + width, 4);
        let count = source.count(count, least, "elements in a block")?;
        done += count;
        let (label, _) = entities.group(dimension, entity);
        let mut nodes = vec![0; width];
        for _ in 0..count {
            source.next_line_number();
            let tag = source.int("an element number")?;
            for node in &mut nodes {
                *node = source.int("a node number")?;
            }
            if GMSH_CELLS.contains(&kind) {
                let element = Element {
                    tag,
                    label,
                    entity,
                    nodes: gmsh_order(&mut nodes),
                    place: source.place(),
                };
                draft.add(index, &element)?;
            } else {
                draft.count_other(name, 1);
            }
        }
    }
    msh4::check_total(source, done, total, "elements")
}

/// For each link `dimension image original`, perhaps an affine map, the number of pairs and the
/// pairs. In text the map has the word `Affine` before it, in binary a negative number.
pub fn periodic(source: &mut Source, index: &Index, draft: &mut Draft) -> Result<(), MeshError> {
    let links = source.int("the number of periodic links")?;
    for _ in 0..source.count(links, source.least_bytes(4, 5), "periodic links")? {
        let dimension = source.int("a dimension")?;
        let entities = (source.int("an entity")?, source.int("an entity")?);
        let is_affine = match source.encoding {
            Encoding::Text => source.skip_word("Affine"),
            _ => source.clone().long("the number of pairs of nodes")? < 0,
        };
        let mut affine = None;
        if is_affine {
            if source.encoding != Encoding::Text {
                source.long("a negative number")?;
            }
            affine = Some(affine_map(source)?);
        }
        let pairs = source.long("the number of pairs of nodes")?;
        let pairs = source.count(pairs, source.least_bytes(2, 4), "pairs of nodes")?;
        let nodes = periodic_nodes(source, index, pairs, Source::int)?;
        draft.add_link(Periodic {
            dimension,
            entities,
            affine,
            nodes,
        });
    }
    Ok(())
}
