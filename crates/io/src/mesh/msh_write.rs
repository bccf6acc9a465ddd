//! Writes MSH 2.2 and 4.1, text or binary.

use super::element::GMSH_TETRAHEDRON;
use super::sink::{Shortest, Sink, labels, labels_or};
use super::source::Encoding;
use super::{Mesh, Periodic};
use std::collections::BTreeSet;

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

/// MSH 2.2.
pub fn msh2(mesh: &Mesh, encoding: Encoding) -> Vec<u8> {
    let mut sink = header("2.2", encoding);
    sink.text(format!("$Nodes\n{}\n", mesh.points.len()));
    for (index, point) in mesh.points.iter().enumerate() {
        sink.int(mesh.nodes.get(index) as i64);
        sink.point(point);
        sink.end();
    }
    close(&mut sink, encoding, "Nodes");
    let count = mesh.tetrahedra.len();
    sink.text(format!("$Elements\n{count}\n"));
    if encoding != Encoding::Text {
        [GMSH_TETRAHEDRON, count as i64, 2]
            .iter()
            .for_each(|&n| sink.int(n));
    }
    let labels = labels_or(mesh, 1);
    for ((index, corners), label) in mesh.tetrahedra.iter().enumerate().zip(labels) {
        sink.int(mesh.elements.get(index) as i64);
        if encoding == Encoding::Text {
            sink.int(GMSH_TETRAHEDRON);
            sink.int(2);
        }
        sink.int(label);
        sink.int(label);
        corners
            .iter()
            .for_each(|&corner| sink.int(mesh.nodes.get(corner as usize) as i64));
        sink.end();
    }
    close(&mut sink, encoding, "Elements");
    if !mesh.periodic.is_empty() {
        periodic2(mesh, &mut sink);
    }
    sink.bytes
}

/// In text even in a binary file.
fn periodic2(mesh: &Mesh, sink: &mut Sink) {
    sink.text(format!("$Periodic\n{}\n", mesh.periodic.len()));
    for link in &mesh.periodic {
        let (image, original) = link.entities;
        sink.text(format!("{} {image} {original}\n", link.dimension));
        if let Some(matrix) = &link.affine {
            let entries = matrix.map(|x| Shortest(x).to_string()).join(" ");
            sink.text(format!("Affine {entries}\n"));
        }
        sink.text(format!("{}\n", link.nodes.len()));
        for (image, original) in pairs(mesh, link) {
            sink.text(format!("{image} {original}\n"));
        }
    }
    sink.text("$EndPeriodic\n");
}

fn pairs<'m>(mesh: &'m Mesh, link: &'m Periodic) -> impl Iterator<Item = (i64, i64)> + 'm {
    let tag = |point: u32| mesh.nodes.get(point as usize) as i64;
    link.nodes
        .iter()
        .map(move |&(image, original)| (tag(image), tag(original)))
}

/// MSH 4.1.
pub fn msh4(mesh: &Mesh, encoding: Encoding) -> Vec<u8> {
    let mut sink = header("4.1", encoding);
    if !mesh.periodic.is_empty() {
        entities4(mesh, &mut sink);
        close(&mut sink, encoding, "Entities");
    }
    nodes4(mesh, &mut sink);
    close(&mut sink, encoding, "Nodes");
    elements4(mesh, &mut sink);
    close(&mut sink, encoding, "Elements");
    if !mesh.periodic.is_empty() {
        periodic4(mesh, &mut sink);
        close(&mut sink, encoding, "Periodic");
    }
    sink.bytes
}

/// The number of blocks, of items, and the smallest and largest number of an item.
fn totals(sink: &mut Sink, blocks: usize, numbers: &super::Numbering) {
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

/// The entities of periodic links and the volumes, without boundaries or groups: Gmsh reads no link
/// between entities that it does not know. For each `number box groups`, and from curves on
/// `boundaries`.
fn entities4(mesh: &Mesh, sink: &mut Sink) {
    let mut entities: [BTreeSet<i64>; 4] = Default::default();
    for link in &mesh.periodic {
        if let Some(entities) = usize::try_from(link.dimension)
            .ok()
            .and_then(|d| entities.get_mut(d))
        {
            entities.extend([link.entities.0, link.entities.1]);
        }
    }
    entities[3].extend(labels(mesh).unwrap_or(&[1]));
    entities[3].insert(1);
    sink.text("$Entities\n");
    entities
        .iter()
        .for_each(|entities| sink.long(entities.len() as i64));
    sink.end();
    let bound = |start: f64, pick: fn(f64, f64) -> f64| -> [f64; 3] {
        std::array::from_fn(|k| mesh.points.iter().map(|point| point[k]).fold(start, pick))
    };
    let (low, high) = (bound(f64::MAX, f64::min), bound(f64::MIN, f64::max));
    for (dimension, entities) in entities.iter().enumerate() {
        for &entity in entities {
            sink.int(entity);
            sink.point(&low);
            if dimension > 0 {
                sink.point(&high);
                sink.long(0);
            }
            sink.long(0);
            sink.end();
        }
    }
}

/// One block, of the volume 1.
fn nodes4(mesh: &Mesh, sink: &mut Sink) {
    sink.text("$Nodes\n");
    totals(sink, 1, &mesh.nodes);
    block(sink, [3, 1, 0], mesh.points.len());
    for tag in mesh.nodes.iter() {
        sink.long(tag as i64);
        sink.end();
    }
    for point in &mesh.points {
        sink.point(point);
        sink.end();
    }
}

/// A block for each run of tetrahedra with the same label, which is the number of a volume.
fn elements4(mesh: &Mesh, sink: &mut Sink) {
    let all_one = vec![1; mesh.tetrahedra.len()];
    let labels = labels(mesh).unwrap_or(&all_one);
    let runs: Vec<&[i64]> = labels.chunk_by(|a, b| a == b).collect();
    sink.text("$Elements\n");
    totals(sink, runs.len(), &mesh.elements);
    let mut index = 0;
    for run in runs {
        block(sink, [3, run[0], GMSH_TETRAHEDRON], run.len());
        for corners in &mesh.tetrahedra[index..index + run.len()] {
            sink.long(mesh.elements.get(index) as i64);
            corners
                .iter()
                .for_each(|&corner| sink.long(mesh.nodes.get(corner as usize) as i64));
            sink.end();
            index += 1;
        }
    }
}

fn periodic4(mesh: &Mesh, sink: &mut Sink) {
    sink.text("$Periodic\n");
    sink.long(mesh.periodic.len() as i64);
    sink.end();
    for link in &mesh.periodic {
        let (image, original) = link.entities;
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
        for (image, original) in pairs(mesh, link) {
            sink.long(image);
            sink.long(original);
            sink.end();
        }
    }
}
