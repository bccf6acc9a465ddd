//! The sections of MSH 2: nodes, elements, periodic links.

use super::element::{GMSH_TETRAHEDRON, gmsh_element};
use super::error::MeshError;
use super::numbering::{Index, periodic_node};
use super::source::{Encoding, Source, shown};
use super::{Mesh, Periodic};

/// The number of items stands in text even in a binary file.
fn count(source: &mut Source, least: usize, what: &str) -> Result<usize, MeshError> {
    let encoding = std::mem::replace(&mut source.encoding, Encoding::Text);
    let count = source.int(&format!("the number of {what}"))?;
    let count = source.count(count, least, what)?;
    source.rest_of_line();
    source.encoding = encoding;
    Ok(count)
}

/// `tag x y z` for each node.
pub fn nodes(source: &mut Source, mesh: &mut Mesh) -> Result<(), MeshError> {
    let least = match source.encoding {
        Encoding::Text => 8,
        _ => 28,
    };
    let count = count(source, least, "nodes")?;
    mesh.points.reserve(count);
    for _ in 0..count {
        let tag = source.int("a node number")?;
        let point = [
            source.double("the coordinate x")?,
            source.double("the coordinate y")?,
            source.double("the coordinate z")?,
        ];
        mesh.add_node(tag, point, source.place())?;
    }
    Ok(())
}

/// In text `tag type k label_1 … label_k node …` for each element; in binary blocks of a
/// type, a number of elements and k, and then `tag label_1 … label_k node …` for each.
pub fn elements(source: &mut Source, index: &Index, mesh: &mut Mesh) -> Result<(), MeshError> {
    let is_text = source.encoding == Encoding::Text;
    let total = count(source, 8, "elements")?;
    let mut labels = Labels::default();
    let mut done = 0;
    while done < total {
        let (tag, block) = match is_text {
            true => {
                source.next_line_number();
                let tag = source.int("an element number")?;
                (Some(tag), Block::of_element(source)?)
            }
            false => (None, Block::header(source, total - done)?),
        };
        for _ in 0..block.elements {
            let tag = match tag {
                Some(tag) => tag,
                None => source.int("an element number")?,
            };
            element(source, tag, &block, index, mesh, &mut labels)?;
        }
        done += block.elements;
    }
    labels.store(mesh);
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

fn element(
    source: &mut Source,
    tag: i64,
    block: &Block,
    index: &Index,
    mesh: &mut Mesh,
    labels: &mut Labels,
) -> Result<(), MeshError> {
    let mut first = [0; 2];
    for k in 0..block.labels {
        let label = source.int("a tag")?;
        match first.get_mut(k) {
            Some(slot) => *slot = label,
            None => labels.further = true,
        }
    }
    if block.kind != GMSH_TETRAHEDRON {
        for _ in 0..block.nodes {
            source.int("a node number")?;
        }
        mesh.count_other(block.name, 1);
        return Ok(());
    }
    labels.physical.push(first[0]);
    labels.elementary.push(first[1]);
    let mut nodes = [0; 4];
    for node in &mut nodes {
        *node = source.int("a node number")?;
    }
    mesh.add_tetrahedron(index, tag, nodes, source.place())
}

/// The first two tags of each tetrahedron: the physical group and the elementary entity.
#[derive(Default)]
struct Labels {
    physical: Vec<i64>,
    elementary: Vec<i64>,
    further: bool,
}

impl Labels {
    /// A mesh has one label: the physical group where there are such.
    fn store(self, mesh: &mut Mesh) {
        let has_groups = self.physical.iter().any(|&label| label != 0);
        let (kept, other) = match has_groups {
            true => (self.physical, self.elementary),
            false => (self.elementary, self.physical),
        };
        if has_groups && kept != other {
            let note = "elementary tags of elements (the physical ones are kept)";
            mesh.unread.push(note.to_owned());
        }
        if self.further {
            mesh.unread.push("partition tags of elements".to_owned());
        }
        if kept.iter().any(|&label| label != 0) {
            mesh.labels = kept;
        }
    }
}

/// `dimension image original`, an optional line `Affine` with 16 numbers, and pairs of
/// nodes; in text even in a binary file.
pub fn periodic(source: &mut Source, index: &Index, mesh: &mut Mesh) -> Result<(), MeshError> {
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
                let mut matrix = [0.0; 16];
                for entry in &mut matrix {
                    *entry = source.double("an entry of the affine map")?;
                }
                affine = Some(matrix);
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
        let mut nodes = Vec::with_capacity(pairs);
        for _ in 0..pairs {
            let image = source.int("a node number")?;
            let original = source.int("a node number")?;
            nodes.push((
                periodic_node(index, image, source.place())?,
                periodic_node(index, original, source.place())?,
            ));
        }
        mesh.periodic.push(Periodic {
            dimension,
            entities: (image, original),
            affine,
            nodes,
        });
    }
    source.encoding = encoding;
    Ok(())
}
