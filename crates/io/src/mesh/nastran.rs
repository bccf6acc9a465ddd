//! Nastran bulk data, `.bdf` and `.nas`: `GRID`, `CTETRA`, `CTRIA3` and `CTRIA6` in free, small and large fields
//! (NX Nastran User's Guide, "The bulk data section"). Property numbers are the labels.
//!
//! Not read: coordinate systems other than the basic one, replicated cards, included files. They are
//! declined by their name.

use super::Mesh;
use super::draft::{Draft, Element};
use super::error::{MeshError, Place};
use super::lines::numbered;
use super::source::{decimal_double, shown};

/// Cards that are elements of other types, with their names.
const OTHERS: [(&str, &str); 11] = [
    ("CHEXA", "hexahedra"),
    ("CPENTA", "prisms"),
    ("CPYRAM", "pyramids"),
    ("CPYRA", "pyramids"),
    ("CQUAD4", "quadrangles"),
    ("CQUAD8", "second-order quadrangles"),
    ("CQUADR", "quadrangles"),
    ("CBAR", "lines"),
    ("CBEAM", "lines"),
    ("CROD", "lines"),
    ("CONROD", "lines"),
];

/// Reads the nodes and elements of a file.
pub fn read(bytes: &[u8]) -> Result<Mesh, MeshError> {
    let mut draft = Draft::default();
    let mut elements = Vec::new();
    for card in cards(bytes)? {
        match card.name.as_str() {
            "GRID" => grid(&card, &mut draft)?,
            "CTETRA" => elements.push((card.cell(&[4, 10])?, card.place)),
            "CTRIA3" | "CTRIAR" => elements.push((card.cell(&[3])?, card.place)),
            "CTRIA6" => elements.push((card.cell(&[6])?, card.place)),
            "GRDSET" | "INCLUDE" => {
                return Err(card.declined(&format!("found {}", card.name)));
            }
            name => {
                if let Some((_, name)) = OTHERS.iter().find(|(card, _)| *card == name) {
                    draft.count_other(name, 1);
                }
            }
        }
    }
    let index = draft.node_index()?;
    for (numbers, place) in &elements {
        let element = Element {
            tag: numbers[0],
            label: numbers[1],
            entity: 0,
            nodes: &numbers[2..],
            place: *place,
        };
        draft.add(&index, &element)?;
    }
    draft.finish()
}

/// `GRID id cp x1 x2 x3`
fn grid(card: &Card, draft: &mut Draft) -> Result<(), MeshError> {
    let tag = card.integer(0, "a node number")?;
    if card.integer(1, "a coordinate system")? != 0 {
        return Err(card.declined("found a node in another coordinate system"));
    }
    let mut point = [0.0; 3];
    for (k, x) in point.iter_mut().enumerate() {
        *x = card.real(2 + k)?;
    }
    draft.add_node(tag, point, card.place)
}

/// A line with the lines that continue it.
struct Card {
    name: String,
    fields: Vec<Vec<u8>>,
    place: Place,
}

impl Card {
    fn field(&self, index: usize) -> &[u8] {
        self.fields.get(index).map_or(&[], Vec::as_slice)
    }

    /// An integer; an empty field is 0.
    fn integer(&self, index: usize, what: &str) -> Result<i64, MeshError> {
        let field = self.field(index);
        if field.is_empty() {
            return Ok(0);
        }
        let value = std::str::from_utf8(field).ok().and_then(|f| f.parse().ok());
        value.ok_or_else(|| self.error(format!("found {}, expected {what}", shown(field))))
    }

    /// A real number; an empty field is 0.
    fn real(&self, index: usize) -> Result<f64, MeshError> {
        let field = self.field(index);
        if field.is_empty() {
            return Ok(0.0);
        }
        let value = real(field).filter(|value| value.is_finite());
        value.ok_or_else(|| {
            self.error(format!(
                "found {}, expected a coordinate, a number in the range of doubles",
                shown(field)
            ))
        })
    }

    /// Element, property and nodes, one of these numbers of them.
    fn cell(&self, widths: &[usize]) -> Result<Vec<i64>, MeshError> {
        let mut numbers = vec![
            self.integer(0, "an element number")?,
            self.integer(1, "a property number")?,
        ];
        let last = widths.last().copied().unwrap_or(0);
        for index in 2..2 + last {
            numbers.push(self.integer(index, "a node number")?);
        }
        while numbers.last() == Some(&0) && numbers.len() > 2 {
            numbers.pop();
        }
        let found = numbers.len() - 2;
        if widths.contains(&found) && !numbers[2..].contains(&0) {
            Ok(numbers)
        } else {
            Err(self.error(format!(
                "the element {} has {found} nodes, some perhaps left out, expected {}",
                numbers[0],
                widths
                    .iter()
                    .map(usize::to_string)
                    .collect::<Vec<_>>()
                    .join(" or ")
            )))
        }
    }

    fn error(&self, problem: String) -> MeshError {
        MeshError::at(self.place, problem)
    }

    fn declined(&self, problem: &str) -> MeshError {
        MeshError {
            place: self.place,
            ..MeshError::limit(format!(
                "{problem}, which is not read; a preprocessor can write nodes in the basic system"
            ))
        }
    }
}

/// `1.5`, `1.5E-3`, `1.5D-3`, and Nastran's `1.5-3`.
fn real(field: &[u8]) -> Option<f64> {
    if let Some(value) = decimal_double(field) {
        return Some(value);
    }
    let at = field.iter().rposition(|byte| matches!(byte, b'+' | b'-'))?;
    let is_exponent = at > 0 && !field[at - 1].eq_ignore_ascii_case(&b'e');
    is_exponent
        .then(|| [&field[..at], b"e", &field[at..]].concat())
        .and_then(|text| decimal_double(&text))
}

/// The cards between `BEGIN BULK`, or the start, and `ENDDATA`, or the end.
fn cards(bytes: &[u8]) -> Result<Vec<Card>, MeshError> {
    let is_begin = |line: &[u8]| {
        let text = String::from_utf8_lossy(line).to_ascii_uppercase();
        let mut words = text.split([' ', ',', '\t']).filter(|word| !word.is_empty());
        words.next() == Some("BEGIN") && words.next().is_none_or(|word| word.starts_with("BULK"))
    };
    let begin = numbered(bytes).find(|(_, line)| is_begin(line));
    let first = begin.map_or(0, |(number, _)| number);
    let mut cards: Vec<Card> = Vec::new();
    let mut has_ended = false;
    for (number, line) in numbered(bytes).skip_while(|(number, _)| *number <= first) {
        let line = line.split(|&byte| byte == b'$').next().unwrap_or_default();
        if line.trim_ascii().is_empty() {
            continue;
        }
        let (name, fields) = split(&expanded(line));
        let name = name.trim().to_ascii_uppercase();
        if has_ended {
            let found = String::from_utf8_lossy(line.trim_ascii());
            let problem = format!("found {found:?} after ENDDATA, expected the end of the file");
            return Err(MeshError::at(Place::Line(number), problem));
        }
        if name == "ENDDATA" {
            has_ended = true;
            continue;
        }
        let is_continuation = name.is_empty() || name.starts_with(['+', '*']);
        match cards.last_mut() {
            Some(card) if is_continuation => card.fields.extend(fields),
            _ if is_continuation => {}
            _ if name.starts_with('=') => {
                let card = Card {
                    name,
                    fields,
                    place: Place::Line(number),
                };
                return Err(card.declined("found a replicated card"));
            }
            // meshio ends the names of second-order elements with an underscore.
            _ => cards.push(Card {
                name: name
                    .trim_end_matches('*')
                    .trim()
                    .trim_end_matches('_')
                    .to_owned(),
                fields,
                place: Place::Line(number),
            }),
        }
    }
    Ok(cards)
}

/// Tabs go to the next multiple of eight columns.
fn expanded(line: &[u8]) -> Vec<u8> {
    let mut expanded = Vec::with_capacity(line.len());
    for &byte in line {
        match byte {
            b'\t' => expanded.resize(expanded.len() / 8 * 8 + 8, b' '),
            _ => expanded.push(byte),
        }
    }
    expanded
}

/// The name, and the fields of data: eight small ones or four large ones, without the tenth field,
/// which names a continuation.
fn split(line: &[u8]) -> (String, Vec<Vec<u8>>) {
    let is_free = line.contains(&b',');
    let name: &[u8] = if is_free {
        line.split(|&byte| byte == b',').next().unwrap_or_default()
    } else {
        &line[..line.len().min(8)]
    };
    let is_large = name.contains(&b'*');
    let (count, width) = if is_large { (4, 16) } else { (8, 8) };
    let trimmed = |field: &[u8]| field.trim_ascii().to_vec();
    let mut fields: Vec<Vec<u8>> = if is_free {
        line.split(|&byte| byte == b',')
            .skip(1)
            .take(count)
            .map(trimmed)
            .collect()
    } else {
        line.get(8..)
            .unwrap_or_default()
            .chunks(width)
            .take(count)
            .map(trimmed)
            .collect()
    };
    fields.resize(count, Vec::new());
    (String::from_utf8_lossy(name).into_owned(), fields)
}
