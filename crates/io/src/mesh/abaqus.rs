//! Abaqus input files, `.inp`: `*NODE` and `*ELEMENT` (Abaqus Analysis User's Guide, section
//! "Defining a model in Abaqus"). The element sets of `*ELEMENT` are the labels.
//!
//! Not read: files with several parts, generated nodes or elements, included files, cylindrical
//! coordinates. They are declined by their keyword.

use super::Mesh;
use super::draft::{Draft, Element};
use super::error::{MeshError, Place};
use super::lines::{Line, numbered};
use super::numbering::Index;
use super::source::shown;
use std::collections::{BTreeMap, BTreeSet};

/// Keywords that make nodes or elements in a way that is not read.
const DECLINED: [&str; 9] = [
    "NGEN",
    "NFILL",
    "NCOPY",
    "NMAP",
    "ELGEN",
    "ELCOPY",
    "INCLUDE",
    "SYSTEM",
    "TRANSFORM",
];

/// Reads the nodes and elements of a file.
pub fn read(bytes: &[u8]) -> Result<Mesh, MeshError> {
    let mut reading = Reading::default();
    let mut keyword: Option<(String, u64)> = None;
    for (number, line) in numbered(bytes) {
        let text = line.trim_ascii();
        if text.starts_with(b"**") || text.is_empty() {
            continue;
        }
        let begun = keyword
            .as_mut()
            .filter(|(begun, _)| begun.ends_with(',') && text[0].is_ascii_alphabetic());
        if let Some((begun, _)) = begun {
            // A line of a keyword that ends with a comma goes on in the next one.
            *begun += &String::from_utf8_lossy(text);
            continue;
        }
        if let Some((text, number)) = keyword.take() {
            reading.keyword(&text, number)?;
        }
        match text.strip_prefix(b"*") {
            Some(text) => keyword = Some((String::from_utf8_lossy(text).into_owned(), number)),
            None => reading.data(text, number)?,
        }
    }
    if let Some((text, number)) = keyword {
        reading.keyword(&text, number)?;
    }
    reading.finish()
}

/// The parts of a text between commas that do not stand in quotes.
fn fields(text: &str) -> Vec<&str> {
    let mut is_quoted = false;
    let is_end = |c: char| {
        is_quoted ^= c == '"';
        c == ',' && !is_quoted
    };
    text.split(is_end).map(str::trim).collect()
}

/// The keyword that data lines belong to.
#[derive(Default)]
enum Block {
    Nodes,
    Elements {
        kind: String,
        /// The nodes of an element that is a cell.
        cell: Option<usize>,
        label: i64,
    },
    #[default]
    Other,
}

/// An element before all nodes are known.
struct Pending {
    numbers: Vec<i64>,
    label: i64,
    place: Place,
}

/// The value of a parameter; quotes around it are no part of it.
fn unquoted(value: &str) -> String {
    let inner = value
        .strip_prefix('"')
        .and_then(|rest| rest.strip_suffix('"'));
    inner.unwrap_or(value).to_owned()
}

#[derive(Default)]
struct Reading {
    draft: Draft,
    block: Block,
    elements: Vec<Pending>,
    /// The numbers of an element that goes on in the next line.
    begun: Vec<i64>,
    labels: BTreeMap<String, i64>,
    parts_with_nodes: usize,
    is_new_part: bool,
    /// The names of parts that have been placed.
    placed: BTreeSet<String>,
}

impl Reading {
    fn keyword(&mut self, text: &str, number: u64) -> Result<(), MeshError> {
        let place = Place::Line(number);
        self.expect_whole(place)?;
        let mut fields = fields(text).into_iter();
        let keyword = fields.next().unwrap_or_default().to_ascii_uppercase();
        let parameters: BTreeMap<String, String> = fields
            .map(|field| field.split_once('=').unwrap_or((field, "")))
            .map(|(name, value)| (name.trim().to_ascii_uppercase(), unquoted(value.trim())))
            .collect();
        self.block = match keyword.as_str() {
            "PART" => {
                self.is_new_part = true;
                Block::Other
            }
            "INSTANCE" => {
                let part = parameters.get("PART").cloned().unwrap_or_default();
                if self.placed.insert(part.to_ascii_uppercase()) {
                    Block::Other
                } else {
                    let problem = format!("found a second *INSTANCE of the part {part:?}");
                    return Err(declined(place, problem));
                }
            }
            "NODE" => self.node_block(&parameters, place)?,
            "ELEMENT" if parameters.contains_key("INPUT") => {
                let problem = "found *ELEMENT with INPUT".to_owned();
                return Err(declined(place, problem));
            }
            "ELEMENT" => {
                let kind = parameters.get("TYPE").cloned().unwrap_or_default();
                let kind = kind.to_ascii_uppercase();
                Block::Elements {
                    cell: nodes_of_cell(&kind),
                    label: self.label(parameters.get("ELSET")),
                    kind,
                }
            }
            keyword if DECLINED.contains(&keyword) => {
                return Err(declined(place, format!("found *{keyword}")));
            }
            _ => Block::Other,
        };
        Ok(())
    }

    fn node_block(
        &mut self,
        parameters: &BTreeMap<String, String>,
        place: Place,
    ) -> Result<Block, MeshError> {
        let is_cartesian = parameters
            .get("SYSTEM")
            .is_none_or(|system| system.eq_ignore_ascii_case("R"));
        if !is_cartesian || parameters.contains_key("INPUT") {
            let problem = "found *NODE with SYSTEM or INPUT".to_owned();
            return Err(declined(place, problem));
        }
        if std::mem::take(&mut self.is_new_part) || self.parts_with_nodes == 0 {
            self.parts_with_nodes += 1;
        }
        match self.parts_with_nodes {
            1 => Ok(Block::Nodes),
            _ => Err(declined(
                place,
                "found a second *PART with nodes".to_owned(),
            )),
        }
    }

    fn label(&mut self, set: Option<&String>) -> i64 {
        let Some(set) = set.filter(|set| !set.is_empty()) else {
            return 0;
        };
        let next = self.labels.len() as i64 + 1;
        *self.labels.entry(set.clone()).or_insert(next)
    }

    fn data(&mut self, text: &[u8], number: u64) -> Result<(), MeshError> {
        let mut words: Vec<&[u8]> = text
            .split(|&byte| byte == b',')
            .map(<[u8]>::trim_ascii)
            .collect();
        let goes_on = words.last().is_some_and(|word| word.is_empty());
        if goes_on {
            words.pop();
        }
        let line = Line { number, words };
        match &self.block {
            Block::Nodes => self.node(&line),
            Block::Elements { kind, cell, label } => {
                let (cell, label) = (*cell, *label);
                if cell.is_none() {
                    if self.begun.is_empty() {
                        let name = format!("elements of type {}", shown(kind.as_bytes()));
                        self.draft.count_other(&name, 1);
                    }
                    self.begun = if goes_on { vec![0] } else { Vec::new() };
                    return Ok(());
                }
                self.element(&line, cell.unwrap_or(0), label)
            }
            Block::Other => Ok(()),
        }
    }

    /// `number, x, y, z`; coordinates that are not there are 0.
    fn node(&mut self, line: &Line) -> Result<(), MeshError> {
        let tag = line.parsed(0, "a node number, an integer")?;
        let mut point = [0.0; 3];
        for (k, x) in point.iter_mut().enumerate() {
            if line.words.get(1 + k).is_some_and(|word| !word.is_empty()) {
                *x = line.coordinate(1 + k)?;
            }
        }
        self.draft.add_node(tag, point, Place::Line(line.number))
    }

    /// `number, node, …`, perhaps over several lines.
    fn element(&mut self, line: &Line, nodes: usize, label: i64) -> Result<(), MeshError> {
        for column in 0..line.words.len() {
            self.begun
                .push(line.parsed(column, "a node number, an integer")?);
        }
        if self.begun.len() > nodes + 1 {
            return Err(line.error(format!(
                "the element {} has {} nodes, expected {nodes}",
                self.begun[0],
                self.begun.len() - 1
            )));
        }
        if self.begun.len() == nodes + 1 {
            self.elements.push(Pending {
                numbers: std::mem::take(&mut self.begun),
                label,
                place: Place::Line(line.number),
            });
        }
        Ok(())
    }

    /// No element is left half way.
    fn expect_whole(&mut self, place: Place) -> Result<(), MeshError> {
        let begun = std::mem::take(&mut self.begun);
        match (&self.block, begun.as_slice()) {
            (
                Block::Elements {
                    cell: Some(nodes), ..
                },
                [element, found @ ..],
            ) => {
                let problem = format!(
                    "the element {element} has {} nodes, expected {nodes}",
                    found.len()
                );
                Err(MeshError::at(place, problem))
            }
            _ => Ok(()),
        }
    }

    fn finish(mut self) -> Result<Mesh, MeshError> {
        self.expect_whole(Place::File)?;
        let index: Index = self.draft.node_index()?;
        for pending in &self.elements {
            let element = Element {
                tag: pending.numbers[0],
                label: pending.label,
                entity: 0,
                nodes: &pending.numbers[1..],
                place: pending.place,
            };
            self.draft.add(&index, &element)?;
        }
        for (name, label) in self.labels {
            for names in &mut self.draft.names {
                names.insert(label, name.clone());
            }
        }
        self.draft.finish()
    }
}

/// The types of elements that are read, without letters before, and their nodes. A name that goes on with
/// a digit is another type.
const CELLS: [(&str, usize); 22] = [
    ("C3D4", 4),
    ("C3D10", 10),
    ("CPS3", 3),
    ("CPE3", 3),
    ("CPEG3", 3),
    ("CAX3", 3),
    ("C2D3", 3),
    ("AC2D3", 3),
    ("S3", 3),
    ("STRI3", 3),
    ("M3D3", 3),
    ("SFM3D3", 3),
    ("R3D3", 3),
    ("WARPF2D3", 3),
    ("CPS6", 6),
    ("CPE6", 6),
    ("CPEG6", 6),
    ("CAX6", 6),
    ("C2D6", 6),
    ("STRI65", 6),
    ("M3D6", 6),
    ("SFM3D6", 6),
];

/// The nodes of a solid tetrahedron or of a triangle. The letters before and after the numbers say
/// what is computed.
fn nodes_of_cell(kind: &str) -> Option<usize> {
    let base = kind.trim_start_matches(['D', 'A', 'Q']);
    let begins = |prefix: &str| {
        let rest = base.strip_prefix(prefix).or(kind.strip_prefix(prefix));
        rest.is_some_and(|rest| !rest.starts_with(|c: char| c.is_ascii_digit()))
    };
    let found = CELLS.iter().find(|(prefix, _)| begins(prefix));
    found.map(|(_, nodes)| *nodes)
}

fn declined(place: Place, problem: String) -> MeshError {
    MeshError {
        place,
        ..MeshError::limit(format!(
            "{problem}, which is not read; meshio or Abaqus can write the mesh as one list of nodes \
             and elements"
        ))
    }
}
