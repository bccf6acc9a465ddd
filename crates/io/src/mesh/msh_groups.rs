//! Numbers for MSH files. Nodes, elements, entities and physical groups have positive numbers.
//! Each element has one entity, and here each entity has at most one group.

use super::Mesh;
use super::numbering::Numbering;
use std::collections::{BTreeMap, BTreeSet};

/// A mesh's numbers as an MSH file has them.
pub struct Numbers {
    /// Positive, each once.
    pub nodes: Numbering,
    /// Positive, each once.
    pub elements: Numbering,
    /// The geometric entity and the physical group of each cell; 0 for no group.
    pub groups: Vec<(i64, i64)>,
    /// The names of groups.
    pub names: BTreeMap<i64, String>,
    /// What is numbered or named otherwise than in the mesh.
    pub notes: Vec<String>,
}

impl Numbers {
    /// Numbers of at most `most`.
    pub fn of(mesh: &Mesh, most: u64) -> Numbers {
        let mut notes = Vec::new();
        let nodes = positive(&mesh.nodes, most, "nodes", &mut notes);
        let elements = positive(&mesh.elements, most, "elements", &mut notes);
        let labels = labels(mesh, &mut notes);
        let groups = groups(mesh, &labels, &mut notes);
        let names = names(mesh, &labels, &mut notes);
        Numbers {
            nodes,
            elements,
            groups,
            names,
            notes,
        }
    }
}

/// The numbers themselves if they are positive and different, each plus one if only 0 is in the
/// way, else from 1 on.
fn positive(numbers: &Numbering, most: u64, what: &str, notes: &mut Vec<String>) -> Numbering {
    let least = numbers.iter().min().unwrap_or(1);
    let largest = numbers.iter().max().unwrap_or(1);
    let fit = numbers.index().is_ok() && largest < most;
    if fit && least > 0 {
        return numbers.clone();
    }
    if fit {
        notes.push(format!(
            "{what} are numbered from 1, each number is one more than in the input: numbers in MSH \
             are positive"
        ));
        let mut shifted = Numbering::default();
        numbers.iter().for_each(|number| shifted.push(number + 1));
        return shifted;
    }
    let reason = if numbers.index().is_err() {
        "some numbers are there twice".to_owned()
    } else {
        format!("some numbers are more than {most}")
    };
    notes.push(format!(
        "{what} are numbered from 1 in their order: {reason}"
    ));
    Numbering::consecutive(1, numbers.len())
}

/// The group of each label.
fn labels(mesh: &Mesh, notes: &mut Vec<String>) -> BTreeMap<i64, i64> {
    let labels: BTreeSet<i64> = mesh.labels.iter().copied().collect();
    let is_valid = |label: i64| (0..=i64::from(i32::MAX)).contains(&label);
    let valid = labels.iter().copied().filter(|&label| is_valid(label));
    let mut fresh = valid.clone().max().unwrap_or(0);
    let mut groups: BTreeMap<i64, i64> = valid.map(|label| (label, label)).collect();
    for &label in labels.iter().filter(|&&label| !is_valid(label)) {
        fresh += 1;
        notes.push(format!(
            "the label {label} is the physical group {fresh}: numbers in MSH are positive"
        ));
        groups.insert(label, fresh);
    }
    groups
}

/// Entities and groups of cells. An entity keeps its number if no other group needs it.
fn groups(mesh: &Mesh, labels: &BTreeMap<i64, i64>, notes: &mut Vec<String>) -> Vec<(i64, i64)> {
    let pair = |cell: usize| {
        let entity = mesh.entities.get(cell).copied().unwrap_or(0);
        let label = mesh.labels.get(cell).map_or(0, |label| labels[label]);
        (entity, label)
    };
    let pairs: BTreeSet<(i64, i64)> = (0..mesh.cell_count()).map(pair).collect();
    let mut used = BTreeSet::new();
    let mut numbers = BTreeMap::new();
    let is_valid = |number: i64| (1..=i64::from(i32::MAX)).contains(&number);
    let mut fresh = pairs
        .iter()
        .flat_map(|&(entity, label)| [entity, label])
        .filter(|&number| is_valid(number))
        .max()
        .unwrap_or(0);
    let mut renumbered = 0;
    for &(entity, label) in &pairs {
        let wanted = [entity, label, 1].into_iter().find(|&n| is_valid(n));
        let number = match wanted.filter(|number| used.insert(*number)) {
            Some(number) => number,
            None => {
                fresh += 1;
                used.insert(fresh);
                fresh
            }
        };
        renumbered += usize::from(entity != 0 && number != entity);
        numbers.insert((entity, label), (number, label));
    }
    if renumbered > 0 {
        notes.push(format!(
            "{renumbered} geometric entities have other numbers than in the input"
        ));
    }
    (0..mesh.cell_count())
        .map(|cell| numbers[&pair(cell)])
        .collect()
}

/// The names of groups, without characters that end a name.
fn names(
    mesh: &Mesh,
    labels: &BTreeMap<i64, i64>,
    notes: &mut Vec<String>,
) -> BTreeMap<i64, String> {
    let mut names = BTreeMap::new();
    for (label, name) in &mesh.names {
        let group = labels.get(label).copied().unwrap_or(*label);
        if group <= 0 {
            notes.push(format!("lost: the name \"{name}\" of the label {label}"));
            continue;
        }
        let plain = name.replace('"', "'").replace(['\n', '\r'], " ");
        if plain != *name {
            notes.push(format!("the name {name:?} is written as {plain:?}"));
        }
        names.insert(group, plain);
    }
    names
}
