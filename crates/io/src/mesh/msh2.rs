//! The sections of MSH 2: nodes, elements, periodic links.

use super::Periodic;
use super::draft::{Draft, Element};
use super::element::{GMSH_CELLS, gmsh_element, gmsh_order};
use super::error::MeshError;
use super::msh_sections::{affine_map, periodic_nodes};
use super::numbering::Index;
use super::source::{Encoding, Source, shown};

/// The number of items stands in text even in a binary file.
fn count(source: &mut Source, least: usize, what: &str) -> Result<usize, MeshError> {
    let encoding = std::mem::replace(&mut source.encoding, Encoding::Text);
    let count = source.int(&format!("the number of {what}"))?;
    let count = source.count(count, least, what)?;
    source.rest_of_line();
    source.encoding = encoding;
    Ok(count)
}

/// `tag x y z` for each node. Of parametric nodes the dimension and the number of their entity follow,
/// and a parameter on a curve, or two on a surface.
pub fn nodes(source: &mut Source, draft: &mut Draft, is_parametric: bool) -> Result<(), MeshError> {
    let least = match source.encoding {
        Encoding::Text => 8,
        _ => 28,
    };
    let count = count(source, least, "nodes")?;
    draft.mesh.points.reserve(count);
    for _ in 0..count {
        let tag = source.int("a node number")?;
        let point = source.point()?;
        let place = source.place();
        if is_parametric {
            let dimension = source.int("the dimension of an entity")?;
            source.int("an entity")?;
            let parameters = match dimension {
                1 => 1,
                2 => 2,
                0 | 3 => 0,
                _ => {
                    return Err(
                        source.error(format!("found dimension {dimension}, expected 0 to 3"))
                    );
                }
            };
            for _ in 0..parameters {
                source.double("a parameter")?;
            }
        }
        draft.add_node(tag, point, place)?;
    }
    Ok(())
}

/// In text, each element is `tag type k label_1 … label_k node …`. In binary, a block has a type, a
/// number of elements and k. Then each element is `tag label_1 … label_k node …`.
pub fn elements(source: &mut Source, index: &Index, draft: &mut Draft) -> Result<(), MeshError> {
    let is_text = source.encoding == Encoding::Text;
    let total = count(source, 8, "elements")?;
    let mut has_further = false;
    let mut nodes = Vec::new();
    let mut done = 0;
    while done < total {
        let (tag, block) = if is_text {
            source.next_line_number();
            let tag = source.int("an element number")?;
            (Some(tag), Block::of_element(source)?)
        } else {
            (None, Block::header(source, total - done)?)
        };
        for _ in 0..block.elements {
            let tag = match tag {
                Some(tag) => tag,
                None => source.int("an element number")?,
            };
            has_further |= element(source, tag, &block, index, draft, &mut nodes)?;
        }
        done += block.elements;
    }
    if has_further {
        draft.pass("partition tags of elements");
    }
    Ok(())
}

/// Elements of one type.
struct Block {
    kind: i64,
    elements: usize,
    labels: usize,
    name: &'static str,
    nodes: usize,
}

impl Block {
    fn of_element(source: &mut Source) -> Result<Block, MeshError> {
        let kind = source.int("an element type")?;
        let labels = source.int("the number of tags")?;
        Block::new(source, kind, 1, labels)
    }

    fn header(source: &mut Source, most: usize) -> Result<Block, MeshError> {
        let kind = source.int("an element type")?;
        let elements = source.int("the number of elements in a block")?;
        let labels = source.int("the number of tags")?;
        match usize::try_from(elements) {
            Ok(elements) if (1..=most).contains(&elements) => {
                Block::new(source, kind, elements, labels)
            }
            _ => Err(source.error(format!(
                "found a block of {elements} elements, expected 1 to {most}"
            ))),
        }
    }

    fn new(source: &Source, kind: i64, elements: usize, labels: i64) -> Result<Block, MeshError> {
        let (name, nodes) = gmsh_element(kind).ok_or_else(|| {
            source.error(format!("found the element type {kind}, which is unknown"))
        })?;
        let labels = usize::try_from(labels)
            .ok()
            .filter(|&labels| labels <= source.remaining())
            .ok_or_else(|| source.error(format!("found {labels} as the number of tags")))?;
        Ok(Block {
            kind,
            elements,
            labels,
            name,
            nodes,
        })
    }
}

/// The first two tags are the physical group and the elementary entity; tells whether a cell has
/// more. `nodes` is memory for the nodes.
fn element(
    source: &mut Source,
    tag: i64,
    block: &Block,
    index: &Index,
    draft: &mut Draft,
    nodes: &mut Vec<i64>,
) -> Result<bool, MeshError> {
    let mut first = [0; 2];
    for k in 0..block.labels {
        let label = source.int("a tag")?;
        if let Some(slot) = first.get_mut(k) {
            *slot = label;
        }
    }
    nodes.clear();
    for _ in 0..block.nodes {
        nodes.push(source.int("a node number")?);
    }
    if !GMSH_CELLS.contains(&block.kind) {
        draft.count_other(block.name, 1);
        return Ok(false);
    }
    let element = Element {
        tag,
        label: first[0],
        entity: first[1],
        nodes: gmsh_order(nodes),
        place: source.place(),
    };
    draft.add(index, &element)?;
    Ok(block.labels > 2)
}

/// `dimension image original`, an optional line `Affine` with 16 numbers, and pairs of
/// nodes; in text even in a binary file.
pub fn periodic(source: &mut Source, index: &Index, draft: &mut Draft) -> Result<(), MeshError> {
    let encoding = std::mem::replace(&mut source.encoding, Encoding::Text);
    let links = source.int("the number of periodic links")?;
    let links = source.count(links, 8, "periodic links")?;
    for _ in 0..links {
        let dimension = source.int("a dimension")?;
        let image = source.int("an entity")?;
        let original = source.int("an entity")?;
        let word = source.word("Affine, or a number of nodes")?;
        let mut affine = None;
        let pairs = match word {
            b"Affine" => {
                affine = Some(affine_map(source)?);
                source.int("the number of nodes")?
            }
            _ => std::str::from_utf8(word)
                .ok()
                .and_then(|word| word.parse().ok())
                .ok_or_else(|| {
                    source.error(format!("found {}, expected a number of nodes", shown(word)))
                })?,
        };
        let pairs = source.count(pairs, 4, "pairs of nodes")?;
        let nodes = periodic_nodes(source, index, pairs, Source::int)?;
        draft.add_link(Periodic {
            dimension,
            entities: (image, original),
            affine,
            nodes,
        });
    }
    source.encoding = encoding;
    Ok(())
}
