//! Extended XYZ: a count, a line of `key=value`, and one atom on each line.
//!
//! The format is that of github.com/libAtoms/extxyz. `Lattice` has the three vectors one after the other;
//! `Properties` names the columns. The cell must be periodic in all directions. Of several
//! frames one is chosen.

use super::vectors::{self, Coordinates, Listed, Vector, number, species};
use crate::import::ImportError;
use crate::import::atoms::options::CifOptions;
use crate::import::atoms::structure::Structure;

/// Frames that are counted at most.
const FRAME_LIMIT: usize = 1_000_000;

/// Whether a text looks like extended XYZ: a number, then a line with a lattice.
pub fn is_likely(text: &str) -> bool {
    let mut lines = text.lines();
    let is_count = |line: &str| line.trim().parse::<usize>().is_ok();
    lines.next().is_some_and(is_count)
        && lines
            .next()
            .is_some_and(|line| line.to_ascii_lowercase().contains("lattice="))
}

/// A frame: its line of keys, and its lines of atoms, with the number of the first.
struct Frame<'t> {
    keys: &'t str,
    first_line: usize,
    atoms: Vec<&'t str>,
}

/// Reads the text of an extended XYZ file.
pub fn read(text: &str, options: &CifOptions) -> Result<Structure, ImportError> {
    let text = text.trim_start_matches('\u{feff}');
    let (frame, count) = frame(text, options.block.as_deref())?;
    let place = format!("line {}", frame.first_line - 1);
    let keys = keys(frame.keys).map_err(|problem| ImportError::entry(place.clone(), problem))?;
    let key = |name: &str| {
        keys.iter()
            .find(|(key, _)| key.eq_ignore_ascii_case(name))
            .map(|(_, value)| value.as_str())
    };
    // A word without a value is true.
    let lattice = key("Lattice").filter(|value| *value != "T");
    let lattice = lattice.ok_or_else(|| {
        ImportError::entry(
            place.clone(),
            "there is no Lattice=\"…\": a file without a cell is no crystal",
        )
    })?;
    let vectors = lattice_vectors(lattice, &place)?;
    if let Some(pbc) = key("pbc") {
        check_periodic(pbc, &place)?;
    }
    let columns = Columns::of(key("Properties").unwrap_or("species:S:1:pos:R:3"))
        .map_err(|problem| ImportError::entry(place, problem))?;
    let mut atoms = Vec::with_capacity(frame.atoms.len());
    for (index, line) in frame.atoms.iter().enumerate() {
        atoms.push(columns.atom(line, frame.first_line + index, index + 1)?);
    }
    let notes = match count {
        1 => Vec::new(),
        count => vec![format!(
            "frame {} of {count} is read",
            options.block.as_deref().unwrap_or("1")
        )],
    };
    let name = key("name").unwrap_or("xyz").to_owned();
    vectors::structure(
        name,
        &vectors,
        Coordinates::Cartesian,
        atoms,
        notes,
        options,
    )
}

/// The chosen frame, and how many there are.
fn frame<'t>(text: &'t str, chosen: Option<&str>) -> Result<(Frame<'t>, usize), ImportError> {
    let lines: Vec<&str> = text.lines().collect();
    let mut frames = Vec::new();
    let mut at = 0;
    while lines[at.min(lines.len())..]
        .iter()
        .any(|line| !line.trim().is_empty())
    {
        let place = format!("line {}", at + 1);
        let count: usize = lines[at].trim().parse().map_err(|_| {
            let problem = format!("found {:?}, expected the number of atoms", short(lines[at]));
            ImportError::entry(place.clone(), problem)
        })?;
        let left = lines.len() - at;
        if left < 2 || count > left - 2 {
            let lines = left.saturating_sub(2);
            let problem =
                format!("found {count} as the number of atoms, but {lines} lines of atoms follow");
            return Err(ImportError::entry(place, problem));
        }
        frames.push(Frame {
            keys: lines[at + 1],
            first_line: at + 3,
            atoms: lines[at + 2..at + 2 + count].to_vec(),
        });
        at += 2 + count;
        if frames.len() > FRAME_LIMIT {
            return Err(ImportError::limit(
                "frames",
                format!("more than {FRAME_LIMIT}"),
            ));
        }
    }
    let total = frames.len();
    let index = match (chosen, total) {
        (_, 0) => return Err(ImportError::Empty),
        (None, 1) => 0,
        (None, total) => {
            let problem =
                format!("there are {total}, choose one with --block 1 to --block {total}");
            return Err(ImportError::entry("frames", problem));
        }
        (Some(name), total) => match name.parse::<usize>() {
            Ok(number) if (1..=total).contains(&number) => number - 1,
            _ => {
                let problem =
                    format!("found {name:?}, expected the number of a frame, 1 to {total}");
                return Err(ImportError::entry("--block", problem));
            }
        },
    };
    Ok((frames.swap_remove(index), total))
}

fn short(text: &str) -> String {
    text.chars().take(40).collect()
}

/// `key=value` with values in quotes or braces, and bare words, which are true.
fn keys(text: &str) -> Result<Vec<(String, String)>, String> {
    let mut keys = Vec::new();
    let mut rest = text.trim_start();
    while !rest.is_empty() {
        let end = rest
            .find(|c: char| c == '=' || c.is_whitespace())
            .unwrap_or(rest.len());
        let (key, tail) = rest.split_at(end);
        let tail = tail.trim_start();
        let Some(value) = tail.strip_prefix('=') else {
            keys.push((key.to_owned(), "T".to_owned()));
            rest = tail;
            continue;
        };
        let value = value.trim_start();
        let close = match value.chars().next() {
            Some('"') => Some('"'),
            Some('\'') => Some('\''),
            Some('{') => Some('}'),
            _ => None,
        };
        let (value, tail) = match close {
            Some(close) => value[1..]
                .split_once(close)
                .ok_or_else(|| format!("the value of {key} has no end"))?,
            None => value.split_at(value.find(char::is_whitespace).unwrap_or(value.len())),
        };
        keys.push((key.trim_matches('"').to_owned(), value.to_owned()));
        rest = tail.trim_start();
    }
    Ok(keys)
}

fn lattice_vectors(text: &str, place: &str) -> Result<[Vector; 3], ImportError> {
    let mut numbers = Vec::new();
    for word in text.split(|c: char| c.is_whitespace() || matches!(c, ',' | '[' | ']')) {
        if !word.is_empty() {
            numbers.push(number(word, || format!("{place}: Lattice"))?);
        }
    }
    if numbers.len() != 9 {
        let problem = format!("Lattice has {} numbers, expected 9", numbers.len());
        return Err(ImportError::entry(place, problem));
    }
    Ok(std::array::from_fn(|i| {
        std::array::from_fn(|j| numbers[3 * i + j].clone())
    }))
}

fn check_periodic(text: &str, place: &str) -> Result<(), ImportError> {
    let is_true = |word: &str| matches!(word.to_ascii_lowercase().as_str(), "t" | "true" | "1");
    let words: Vec<&str> = text
        .split(|c: char| c.is_whitespace() || matches!(c, ',' | '[' | ']'))
        .filter(|word| !word.is_empty())
        .collect();
    if !words.is_empty() && words.iter().all(|word| is_true(word)) {
        Ok(())
    } else {
        Err(ImportError::entry(
            place,
            format!("pbc is {text:?}, expected a cell that is periodic in all directions (T T T)"),
        ))
    }
}

/// Where species and positions are among the columns.
struct Columns {
    species: Option<usize>,
    position: usize,
}

impl Columns {
    /// `name:type:columns:…`
    fn of(properties: &str) -> Result<Columns, String> {
        let parts: Vec<&str> = properties.split(':').collect();
        let (mut species, mut position, mut at) = (None, None, 0usize);
        for part in parts.chunks(3) {
            let [name, kind, count] = part else {
                return Err(format!("Properties {properties:?} do not come in threes"));
            };
            let count: usize = count.parse().map_err(|_| {
                format!("Properties: found {count:?}, expected a number of columns")
            })?;
            match (name.to_ascii_lowercase().as_str(), *kind, count) {
                ("species" | "element" | "type", "S", 1) if species.is_none() => species = Some(at),
                ("pos" | "positions", "R", 3) if position.is_none() => position = Some(at),
                _ => {}
            }
            at = at.saturating_add(count);
        }
        let position = position.ok_or("Properties have no pos:R:3, the positions")?;
        Ok(Columns { species, position })
    }

    fn atom(&self, text: &str, line: usize, number_of_atom: usize) -> Result<Listed, ImportError> {
        let place = || format!("line {line}");
        let words: Vec<&str> = text.split_ascii_whitespace().collect();
        let word = |index: usize| {
            words.get(index).copied().ok_or_else(|| {
                let problem = format!("has {} columns, expected more than {index}", words.len());
                ImportError::entry(place(), problem)
            })
        };
        let name = self.species.map(word).transpose()?.unwrap_or("atom");
        let mut position = Vec::new();
        for k in 0..3 {
            position.push(number(word(self.position + k)?, place)?);
        }
        Ok(Listed {
            label: format!("{name}{number_of_atom}"),
            element: species(name),
            position: std::array::from_fn(|k| position[k].clone()),
            place: place(),
        })
    }
}
