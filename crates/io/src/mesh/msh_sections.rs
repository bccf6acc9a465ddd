//! Sections of MSH files beside nodes and elements: names, entities, and data that are passed over.

use super::draft::Draft;
use super::error::MeshError;
use super::numbering::{Index, periodic_node};
use super::source::{Encoding, Source, shown};
use std::collections::BTreeMap;

/// `dimension number "name"` for each group, in text even in a binary file. Version 2.0 has no
/// dimension. A name goes from the first quotation mark of its line to the last one.
pub fn physical_names(source: &mut Source, draft: &mut Draft) -> Result<(), MeshError> {
    let encoding = std::mem::replace(&mut source.encoding, Encoding::Text);
    let count = source.int("the number of names")?;
    let count = source.count(count, 4, "names")?;
    source.rest_of_line();
    for _ in 0..count {
        let place = source.place();
        let line = String::from_utf8_lossy(source.rest_of_line()).into_owned();
        let (head, name) = line.split_once('"').unwrap_or((&line, ""));
        let name = name.rsplit_once('"').map_or(name, |(name, _)| name);
        let numbers: Option<Vec<i64>> = head.split_whitespace().map(|n| n.parse().ok()).collect();
        let (dimension, number) = match numbers.as_deref() {
            Some([dimension @ 0..=3, number]) => (*dimension as usize, *number),
            Some([number]) => (3, *number),
            _ => {
                let found = shown(line.as_bytes());
                let problem = format!("found {found}, expected dimension, number and \"name\"");
                return Err(MeshError::at(place, problem));
            }
        };
        draft.names[dimension].insert(number, name.to_owned());
    }
    source.encoding = encoding;
    Ok(())
}

/// The physical groups of each entity, by dimension and number.
#[derive(Default)]
pub struct Entities {
    groups: BTreeMap<(i64, i64), Vec<i64>>,
}

impl Entities {
    /// The numbers of points, curves, surfaces and volumes. For each of them follow its number, its
    /// box and its groups; from curves on its boundary, too. In version 4.1 a point has its place
    /// instead of a box.
    pub fn read(source: &mut Source, is_version_40: bool) -> Result<Entities, MeshError> {
        let mut counts = [0; 4];
        for count in &mut counts {
            let found = source.long("a number of entities")?;
            *count = source.count(found, source.least_bytes(5, 8), "entities")?;
        }
        let mut entities = Entities::default();
        for (dimension, count) in (0..).zip(counts) {
            let places = if dimension == 0 && !is_version_40 {
                3
            } else {
                6
            };
            for _ in 0..count {
                let number = source.int("the number of an entity")?;
                for _ in 0..places {
                    source.double("a coordinate of a box")?;
                }
                let groups = list(source, "physical groups")?;
                if dimension > 0 {
                    list(source, "boundaries of an entity")?;
                }
                entities.groups.insert((dimension, number), groups);
            }
        }
        Ok(entities)
    }

    /// The first group of an entity, 0 for none; and how many more it has.
    pub fn group(&self, dimension: i64, number: i64) -> (i64, usize) {
        match self.groups.get(&(dimension, number)).map(Vec::as_slice) {
            Some([first, others @ ..]) => (*first, others.len()),
            _ => (0, 0),
        }
    }
}

fn list(source: &mut Source, what: &str) -> Result<Vec<i64>, MeshError> {
    let count = source.long(&format!("the number of {what}"))?;
    let count = source.count(count, source.least_bytes(1, 4), what)?;
    (0..count).map(|_| source.int("an entity")).collect()
}

/// Passes over data of a binary file by their counts, since they may end without a line feed.
pub fn skip_data(source: &mut Source, name: &str) -> Result<(), MeshError> {
    let encoding = std::mem::replace(&mut source.encoding, Encoding::Text);
    let strings = source.int("the number of strings")?;
    let strings = source.count(strings, 2, "strings")?;
    source.rest_of_line();
    for _ in 0..strings {
        source.rest_of_line();
    }
    let reals = source.int("the number of reals")?;
    for _ in 0..source.count(reals, 2, "reals")? {
        source.word("a real number")?;
    }
    let integers = source.int("the number of integers")?;
    let mut values = Vec::new();
    for _ in 0..source.count(integers, 2, "integers")? {
        values.push(source.int("an integer")?);
    }
    source.rest_of_line();
    source.encoding = encoding;
    let [_, components, rows, ..] = values[..] else {
        return Err(source.error(format!(
            "the section ${name} has {} integers, expected 3 or more: step, components, rows",
            values.len()
        )));
    };
    let rows = source.count(rows, 12, "rows of data")?;
    let components = source.count(components, 8, "components")?;
    for _ in 0..rows {
        source.int("a number of a node or an element")?;
        let nodes = match name {
            "ElementNodeData" => source.int("the number of nodes of an element")?,
            _ => 1,
        };
        let nodes = source.count(nodes, 8, "nodes of an element")?;
        source.take(8 * components.saturating_mul(nodes), "data")?;
    }
    Ok(())
}

/// The 16 entries of the affine map of a periodic link.
pub fn affine_map(source: &mut Source) -> Result<[f64; 16], MeshError> {
    let mut matrix = [0.0; 16];
    for entry in &mut matrix {
        *entry = source.double("an entry of the affine map")?;
    }
    Ok(matrix)
}

/// The pairs of a periodic link: an image and its original, as indices of points. `read` reads a
/// node number.
pub fn periodic_nodes<'a>(
    source: &mut Source<'a>,
    index: &Index,
    pairs: usize,
    read: impl Fn(&mut Source<'a>, &str) -> Result<i64, MeshError>,
) -> Result<Vec<(u32, u32)>, MeshError> {
    let mut nodes = Vec::with_capacity(pairs);
    for _ in 0..pairs {
        let image = read(source, "a node number")?;
        let original = read(source, "a node number")?;
        nodes.push((
            periodic_node(index, image, source.place())?,
            periodic_node(index, original, source.place())?,
        ));
    }
    Ok(nodes)
}
