//! The sections of MSH 1, which has no header: `$NOD` and `$ELM`, in text.

use super::draft::{Draft, Element};
use super::element::{GMSH_CELLS, gmsh_element, gmsh_order};
use super::error::MeshError;
use super::numbering::Index;
use super::source::Source;

/// The number of nodes, then `tag x y z` for each.
pub fn nodes(source: &mut Source, draft: &mut Draft) -> Result<(), MeshError> {
    let count = source.int("the number of nodes")?;
    for _ in 0..source.count(count, 8, "nodes")? {
        let tag = source.int("a node number")?;
        let point = source.point()?;
        draft.add_node(tag, point, source.place())?;
    }
    Ok(())
}

/// The number of elements, then `tag type physical elementary k node_1 … node_k` for each.
pub fn elements(source: &mut Source, index: &Index, draft: &mut Draft) -> Result<(), MeshError> {
    let count = source.int("the number of elements")?;
    for _ in 0..source.count(count, 10, "elements")? {
        source.next_line_number();
        let tag = source.int("an element number")?;
        let kind = source.int("an element type")?;
        let label = source.int("a physical group")?;
        let entity = source.int("an elementary entity")?;
        let k = source.int("the number of nodes")?;
        let k = source.count(k, 2, "nodes of an element")?;
        let mut nodes = Vec::with_capacity(k);
        for _ in 0..k {
            nodes.push(source.int("a node number")?);
        }
        let (name, expected) = gmsh_element(kind).unwrap_or(("elements of an unknown type", k));
        if k != expected {
            return Err(source.error(format!(
                "the element {tag} of type {kind} has {k} nodes, expected {expected}"
            )));
        }
        if !GMSH_CELLS.contains(&kind) {
            draft.count_other(name, 1);
            continue;
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
    Ok(())
}
