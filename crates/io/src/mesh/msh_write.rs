//! Writes MSH 2.2 and 4.1, text or binary. All numbers are positive, see `msh_groups`.

use super::element::{GMSH_TETRAHEDRON, GMSH_TRIANGLE};
use super::msh_groups::Numbers;
use super::sink::{Shortest, Sink};
use super::source::Encoding;
use super::{Mesh, Numbering, Periodic};
use std::collections::{BTreeMap, BTreeSet};

/// Numbers of MSH 2 have 32 bits.
pub const MOST_MSH2: u64 = i32::MAX as u64;
/// Numbers of nodes and elements of MSH 4.1 have 64 bits.
pub const MOST_MSH4: u64 = i64::MAX as u64;

fn header(version: &str, encoding: Encoding) -> Sink {
    let mut sink = Sink::new(encoding);
    let kind = u8::from(encoding != Encoding::Text);
    sink.text(format!("$MeshFormat\n{version} {kind} 8\n"));
    if kind == 1 {
        sink.int(1);
        sink.text("\n");
    }
    sink.text("$EndMeshFormat\n");
    sink
}

/// In a binary file a section's data end without a new line.
fn close(sink: &mut Sink, encoding: Encoding, name: &str) {
    let line = if encoding == Encoding::Text { "" } else { "\n" };
    sink.text(format!("{line}$End{name}\n"));
}

fn kind(mesh: &Mesh) -> i64 {
    match mesh.dimension() {
        2 => GMSH_TRIANGLE,
        _ => GMSH_TETRAHEDRON,
    }
}

/// In text even in a binary file.
fn physical_names(mesh: &Mesh, numbers: &Numbers, sink: &mut Sink) {
    if numbers.names.is_empty() {
        return;
    }
    sink.text(format!("$PhysicalNames\n{}\n", numbers.names.len()));
    for (group, name) in &numbers.names {
        sink.text(format!("{} {group} \"{name}\"\n", mesh.dimension()));
    }
    sink.text("$EndPhysicalNames\n");
}

/// MSH 2.2.
pub fn msh2(mesh: &Mesh, encoding: Encoding) -> Vec<u8> {
    let numbers = Numbers::of(mesh, MOST_MSH2);
    let mut sink = header("2.2", encoding);
    physical_names(mesh, &numbers, &mut sink);
    sink.text(format!("$Nodes\n{}\n", mesh.points.len()));
    for (index, point) in mesh.points.iter().enumerate() {
        sink.int(numbers.nodes.get(index) as i64);
        sink.point(point);
        sink.end();
    }
    close(&mut sink, encoding, "Nodes");
    let count = mesh.cell_count();
    sink.text(format!("$Elements\n{count}\n"));
    if encoding != Encoding::Text {
        [kind(mesh), count as i64, 2]
            .iter()
            .for_each(|&n| sink.int(n));
    }
    for (index, corners) in mesh.cells().enumerate() {
        sink.int(numbers.elements.get(index) as i64);
        if encoding == Encoding::Text {
            sink.int(kind(mesh));
            sink.int(2);
        }
        let (entity, group) = numbers.groups[index];
        sink.int(group);
        sink.int(entity);
        for &corner in corners {
            sink.int(numbers.nodes.get(corner as usize) as i64);
        }
        sink.end();
    }
    close(&mut sink, encoding, "Elements");
    if !mesh.periodic.is_empty() {
        periodic2(mesh, &numbers.nodes, &mut sink);
    }
    sink.bytes
}

/// In text even in a binary file.
fn periodic2(mesh: &Mesh, nodes: &Numbering, sink: &mut Sink) {
    sink.text(format!("$Periodic\n{}\n", mesh.periodic.len()));
    for (link, (image, original)) in mesh.periodic.iter().zip(link_entities(mesh)) {
        sink.text(format!("{} {image} {original}\n", link.dimension));
        if let Some(matrix) = &link.affine {
            let entries = matrix.map(|x| Shortest(x).to_string()).join(" ");
            sink.text(format!("Affine {entries}\n"));
        }
        sink.text(format!("{}\n", link.nodes.len()));
        for (image, original) in pairs(nodes, link) {
            sink.text(format!("{image} {original}\n"));
        }
    }
    sink.text("$EndPeriodic\n");
}

fn pairs<'m>(nodes: &'m Numbering, link: &'m Periodic) -> impl Iterator<Item = (i64, i64)> + 'm {
    let tag = |point: u32| nodes.get(point as usize) as i64;
    link.nodes
        .iter()
        .map(move |&(image, original)| (tag(image), tag(original)))
}

/// The entities of each link with positive numbers: each number plus one, if one of them is 0.
fn link_entities(mesh: &Mesh) -> Vec<(i64, i64)> {
    let entities = || mesh.periodic.iter().map(|link| link.entities);
    let least = entities().flat_map(|(a, b)| [a, b]).min().unwrap_or(1);
    let step = (1 - least).max(0);
    entities().map(|(a, b)| (a + step, b + step)).collect()
}

/// MSH 4.1.
pub fn msh4(mesh: &Mesh, encoding: Encoding) -> Vec<u8> {
    let numbers = Numbers::of(mesh, MOST_MSH4);
    let mut sink = header("4.1", encoding);
    physical_names(mesh, &numbers, &mut sink);
    let has_groups = numbers.groups.iter().any(|(_, group)| *group != 0);
    if has_groups || !mesh.periodic.is_empty() {
        entities4(mesh, &numbers, &mut sink);
        close(&mut sink, encoding, "Entities");
    }
    nodes4(mesh, &numbers, &mut sink);
    close(&mut sink, encoding, "Nodes");
    elements4(mesh, &numbers, &mut sink);
    close(&mut sink, encoding, "Elements");
    if !mesh.periodic.is_empty() {
        periodic4(mesh, &numbers.nodes, &mut sink);
        close(&mut sink, encoding, "Periodic");
    }
    sink.bytes
}

/// The number of blocks, of items, and the smallest and largest number of an item.
fn totals(sink: &mut Sink, blocks: usize, numbers: &Numbering) {
    let smallest = numbers.iter().min().unwrap_or(0);
    let largest = numbers.iter().max().unwrap_or(0);
    sink.long(blocks as i64);
    sink.long(numbers.len() as i64);
    sink.long(smallest as i64);
    sink.long(largest as i64);
    sink.end();
}

fn block(sink: &mut Sink, numbers: [i64; 3], count: usize) {
    numbers.iter().for_each(|&number| sink.int(number));
    sink.long(count as i64);
    sink.end();
}

/// The entities of periodic links and of cells, with their groups and without boundaries: Gmsh reads
/// no link between entities that it does not know. For each `number box groups`, and from curves on
/// `boundaries`.
fn entities4(mesh: &Mesh, numbers: &Numbers, sink: &mut Sink) {
    let mut entities: [BTreeMap<i64, i64>; 4] = Default::default();
    for (link, (image, original)) in mesh.periodic.iter().zip(link_entities(mesh)) {
        let of_dimension = usize::try_from(link.dimension)
            .ok()
            .and_then(|dimension| entities.get_mut(dimension));
        if let Some(entities) = of_dimension {
            entities.extend([(image, 0), (original, 0)]);
        }
    }
    let groups: BTreeSet<(i64, i64)> = numbers.groups.iter().copied().collect();
    entities[mesh.dimension()].extend(groups);
    sink.text("$Entities\n");
    for entities in &entities {
        sink.long(entities.len() as i64);
    }
    sink.end();
    let bound = |start: f64, pick: fn(f64, f64) -> f64| -> [f64; 3] {
        std::array::from_fn(|k| mesh.points.iter().map(|point| point[k]).fold(start, pick))
    };
    let (low, high) = (bound(f64::MAX, f64::min), bound(f64::MIN, f64::max));
    for (dimension, entities) in entities.iter().enumerate() {
        for (&entity, &group) in entities {
            sink.int(entity);
            sink.point(&low);
            if dimension > 0 {
                sink.point(&high);
            }
            sink.long(i64::from(group != 0));
            if group != 0 {
                sink.int(group);
            }
            if dimension > 0 {
                sink.long(0);
            }
            sink.end();
        }
    }
}

/// One block, of the first entity of cells.
fn nodes4(mesh: &Mesh, numbers: &Numbers, sink: &mut Sink) {
    let entity = numbers.groups.first().map_or(1, |(entity, _)| *entity);
    sink.text("$Nodes\n");
    totals(sink, 1, &numbers.nodes);
    block(
        sink,
        [mesh.dimension() as i64, entity, 0],
        mesh.points.len(),
    );
    for tag in numbers.nodes.iter() {
        sink.long(tag as i64);
        sink.end();
    }
    for point in &mesh.points {
        sink.point(point);
        sink.end();
    }
}

/// A block for each run of cells of the same entity.
fn elements4(mesh: &Mesh, numbers: &Numbers, sink: &mut Sink) {
    let runs: Vec<&[(i64, i64)]> = numbers.groups.chunk_by(|a, b| a.0 == b.0).collect();
    sink.text("$Elements\n");
    totals(sink, runs.len(), &numbers.elements);
    let mut cells = mesh.cells().enumerate();
    for run in runs {
        let numbers_of_block = [mesh.dimension() as i64, run[0].0, kind(mesh)];
        block(sink, numbers_of_block, run.len());
        for (index, corners) in cells.by_ref().take(run.len()) {
            sink.long(numbers.elements.get(index) as i64);
            for &corner in corners {
                sink.long(numbers.nodes.get(corner as usize) as i64);
            }
            sink.end();
        }
    }
}

fn periodic4(mesh: &Mesh, nodes: &Numbering, sink: &mut Sink) {
    sink.text("$Periodic\n");
    sink.long(mesh.periodic.len() as i64);
    sink.end();
    for (link, (image, original)) in mesh.periodic.iter().zip(link_entities(mesh)) {
        [link.dimension, image, original]
            .iter()
            .for_each(|&number| sink.int(number));
        sink.end();
        let entries = link.affine.as_ref().map_or(&[][..], |matrix| &matrix[..]);
        sink.long(entries.len() as i64);
        entries.iter().for_each(|&entry| sink.double(entry));
        sink.end();
        sink.long(link.nodes.len() as i64);
        sink.end();
        for (image, original) in pairs(nodes, link) {
            sink.long(image);
            sink.long(original);
            sink.end();
        }
    }
}
