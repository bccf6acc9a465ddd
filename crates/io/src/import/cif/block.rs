//! Data blocks: which tag has which values.
//!
//! A tag with one value is a loop with one row, so that there is one way to look things
//! up. Tags do not depend on case, and `.` and `_` are one (`_atom_site.label` of the newer
//! dictionaries is `_atom_site_label` of the older). Tags of other categories than [`READ`]
//! are passed over.

use super::token::{Token, Tokens, Value, at_line};
use crate::import::ImportError;
use crate::import::words::short;
use std::collections::HashMap;

/// How the tags begin that anything is read from.
const READ: [&str; 4] = ["_cell_", "_atom_site_", "_symmetry_", "_space_group_"];

/// The number of the group of all tags that stand in no loop: they describe one thing.
const PAIRS: usize = usize::MAX;

/// A data block.
pub struct Block<'t> {
    /// The text after `data_`.
    pub name: &'t str,
    loops: Vec<Loop<'t>>,
    /// Loop and column of each tag.
    places: HashMap<String, (usize, usize)>,
}

/// Rows of values, one after the other.
struct Loop<'t> {
    is_pair: bool,
    width: usize,
    values: Vec<Value<'t>>,
}

/// The values of one tag.
#[derive(Clone, Copy)]
pub struct Column<'b, 't> {
    table: &'b Loop<'t>,
    index: usize,
    /// Columns of one loop have the same number here, and so do all tags without a loop.
    pub group: usize,
}

impl<'t> Column<'_, 't> {
    /// The number of values, one or more.
    pub fn len(&self) -> usize {
        self.table.values.len() / self.table.width
    }

    /// The value in a row.
    pub fn value(&self, row: usize) -> Value<'t> {
        self.table.values[row * self.table.width + self.index]
    }

    /// The values in order.
    pub fn values(&self) -> impl Iterator<Item = Value<'t>> {
        (0..self.len()).map(|row| self.value(row))
    }
}

impl<'t> Block<'t> {
    /// The tags of numbers of the cell and of coordinates that have a standard uncertainty in a tag of its own, the
    /// first one.
    pub fn separate_uncertainty(&self) -> Option<&str> {
        let is_one = |tag: &&str| {
            let is_number = ["_cell_length_", "_cell_angle_", "_atom_site_fract_"];
            is_number.iter().any(|start| tag.starts_with(start))
                && (tag.ends_with("_su") || tag.ends_with("_esd"))
        };
        self.places.keys().map(String::as_str).filter(is_one).min()
    }

    /// The values of the first of these tags, in the spelling of [`normal`], with a known value.
    /// If none has one, those of the first tag that is there.
    pub fn column(&self, tags: &[&str]) -> Option<Column<'_, 't>> {
        let mut there = tags.iter().filter_map(|&tag| self.exact(tag));
        let first = there.next()?;
        let is_known = |column: &Column<'_, 't>| column.values().any(|value| !value.is_missing());
        if is_known(&first) {
            return Some(first);
        }
        Some(there.find(is_known).unwrap_or(first))
    }

    /// The values of this tag.
    pub fn exact(&self, tag: &str) -> Option<Column<'_, 't>> {
        let &(place, index) = self.places.get(tag)?;
        let table = &self.loops[place];
        let group = if table.is_pair { PAIRS } else { place };
        Some(Column {
            table,
            index,
            group,
        })
    }

    /// Whether a tag of the block begins like this.
    pub fn has_tag(&self, start: &str) -> bool {
        self.places.keys().any(|tag| tag.starts_with(start))
    }

    /// The only value of the first of these tags that is there and says something.
    ///
    /// # Errors
    /// The tag stands in a loop with several rows.
    pub fn value(&self, tags: &[&str]) -> Result<Option<Value<'t>>, ImportError> {
        for &tag in tags {
            let Some(column) = self.exact(tag) else {
                continue;
            };
            let value = column.value(0);
            if column.len() > 1 {
                return Err(at_line(
                    value.line,
                    format!("{tag} has {} values, expected one", column.len()),
                ));
            }
            if !value.is_missing() {
                return Ok(Some(value));
            }
        }
        Ok(None)
    }

    fn add(
        &mut self,
        tags: &[(&str, u32)],
        values: Vec<Value<'t>>,
        is_pair: bool,
    ) -> Result<(), ImportError> {
        let group = self.loops.len();
        for (column, &(tag, line)) in tags.iter().enumerate() {
            let name = normal(tag);
            if !READ.iter().any(|category| name.starts_with(category)) {
                continue;
            }
            if self.places.insert(name, (group, column)).is_some() {
                let problem = format!("{} stands in this data block twice", short(tag));
                return Err(at_line(line, problem));
            }
        }
        self.loops.push(Loop {
            is_pair,
            width: tags.len(),
            values,
        });
        Ok(())
    }
}

/// Lower case, underscores for points.
fn normal(tag: &str) -> String {
    tag.to_ascii_lowercase().replace('.', "_")
}

/// The data blocks of a text.
///
/// # Errors
/// Text that is no CIF, with its line.
pub fn blocks(text: &str) -> Result<Vec<Block<'_>>, ImportError> {
    let mut tokens = Tokens::of(text);
    let mut blocks: Vec<Block> = Vec::new();
    let mut next = tokens.next()?;
    while let Some((token, line)) = next {
        let block = match (token, blocks.last_mut()) {
            (Token::Data(name), _) => {
                blocks.push(Block {
                    name,
                    loops: Vec::new(),
                    places: HashMap::new(),
                });
                next = tokens.next()?;
                continue;
            }
            (_, Some(block)) => block,
            (token, None) => {
                let problem = format!("found {}, expected data_NAME first", describe(&token));
                return Err(at_line(line, problem));
            }
        };
        next = match token {
            Token::Loop => read_loop(line, &mut tokens, block)?,
            Token::Tag(tag) => read_pair((tag, line), &mut tokens, block)?,
            token => {
                let problem = format!(
                    "found {}, expected a tag, loop_ or data_NAME",
                    describe(&token)
                );
                return Err(at_line(line, problem));
            }
        };
    }
    Ok(blocks)
}

type Next<'t> = Option<(Token<'t>, u32)>;

fn read_pair<'t>(
    tag: (&str, u32),
    tokens: &mut Tokens<'t>,
    block: &mut Block<'t>,
) -> Result<Next<'t>, ImportError> {
    match tokens.next()? {
        Some((Token::Value(value), _)) => block.add(&[tag], vec![value], true)?,
        _ => return Err(at_line(tag.1, format!("{} has no value", short(tag.0)))),
    }
    tokens.next()
}

/// The tags and then the values of a loop; the word after them.
fn read_loop<'t>(
    line: u32,
    tokens: &mut Tokens<'t>,
    block: &mut Block<'t>,
) -> Result<Next<'t>, ImportError> {
    let (mut tags, mut values) = (Vec::new(), Vec::new());
    let mut next = tokens.next()?;
    while let Some((Token::Tag(tag), line)) = next {
        tags.push((tag, line));
        next = tokens.next()?;
    }
    while let Some((Token::Value(value), _)) = next {
        values.push(value);
        next = tokens.next()?;
    }
    if tags.is_empty() || values.is_empty() {
        let what = if tags.is_empty() { "tags" } else { "values" };
        return Err(at_line(line, format!("loop_ has no {what}")));
    }
    if values.len() % tags.len() != 0 {
        let (found, width) = (values.len(), tags.len());
        let problem = format!(
            "loop_ has {width} tags and {found} values, which fill no whole number of rows"
        );
        return Err(at_line(line, problem));
    }
    block.add(&tags, values, false)?;
    Ok(next)
}

fn describe(token: &Token) -> String {
    match token {
        Token::Data(name) => short(&format!("data_{name}")),
        Token::Loop => "loop_".to_owned(),
        Token::Tag(text) | Token::Value(Value { text, .. }) => short(text),
    }
}
