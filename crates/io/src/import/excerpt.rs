//! The place of an error in a JSON text: line, column, and the line with a caret.
//!
//! It decides nothing about the content of a file.

use super::ImportError;
use annotate_snippets::{Level, Renderer, Snippet};
use serde_json::value::RawValue;
use std::collections::BTreeMap;

/// No line of the text is shown beyond this number of characters.
const WIDTH: usize = 100;

/// Where an error is in its text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Excerpt {
    /// Counted from 1.
    pub line: usize,
    /// In characters, counted from 1.
    pub column: usize,
    /// The line with a caret below it.
    pub lines: String,
}

impl ImportError {
    /// Where the error is in `text`, which it was read from; `None` if it is not at one place.
    pub fn excerpt(&self, text: &str) -> Option<Excerpt> {
        let text = text.trim_start_matches('\u{feff}');
        let place = match self {
            ImportError::Json(error) | ImportError::Shape { error, .. } => {
                offset(text, error.line(), error.column())?
            }
            ImportError::Entry { place, .. }
            | ImportError::Limit { place, .. }
            | ImportError::Number { place, .. } => locate(text, place)?,
            ImportError::Format { .. } => locate(text, "format")?,
            ImportError::Version { .. } => locate(text, "version")?,
            _ => return None,
        };
        Some(excerpt(text, place))
    }
}

/// The byte offset of a line and a column of serde_json, whose columns count bytes from 1.
fn offset(text: &str, line: usize, column: usize) -> Option<usize> {
    let before: usize = text
        .split_inclusive('\n')
        .take(line.checked_sub(1)?)
        .map(str::len)
        .sum();
    let end = text[before..]
        .find('\n')
        .map_or(text.len(), |length| before + length);
    let mut place = (before + column.saturating_sub(1)).min(end);
    while !text.is_char_boundary(place) {
        place -= 1;
    }
    Some(place)
}

/// The byte offset of the value at a place like `vertices[3][1]` or `lattice.gram[0]`; of the
/// innermost value around it that is there.
fn locate(text: &str, place: &str) -> Option<usize> {
    let plain = super::without_comments(text);
    // Lines that were emptied shift offsets, so the place is found by its line and its bytes.
    let mut value = plain.trim();
    let mut found = false;
    for step in steps(place) {
        match inner(value, &step) {
            Some(next) => {
                value = next;
                found = true;
            }
            None => break,
        }
    }
    if !found {
        return None;
    }
    let start = value.as_ptr() as usize - plain.as_ptr() as usize;
    let before = &plain[..start];
    let line = before.matches('\n').count() + 1;
    let column = start - before.rfind('\n').map_or(0, |end| end + 1) + 1;
    offset(text, line, column)
}

/// A member of an object or an entry of an array.
enum Step<'a> {
    Member(&'a str),
    Entry(usize),
}

fn steps(place: &str) -> Vec<Step<'_>> {
    let parts = place.split(['.', '[', ']']).filter(|part| !part.is_empty());
    parts
        .map(|part| part.parse().map_or(Step::Member(part), Step::Entry))
        .collect()
}

fn inner<'t>(value: &'t str, step: &Step) -> Option<&'t str> {
    match step {
        Step::Member(name) => {
            let members: BTreeMap<String, &RawValue> = serde_json::from_str(value).ok()?;
            members.get(*name).map(|raw| raw.get())
        }
        Step::Entry(index) => {
            let entries: Vec<&RawValue> = serde_json::from_str(value).ok()?;
            entries.get(*index).map(|raw| raw.get())
        }
    }
}

fn excerpt(text: &str, place: usize) -> Excerpt {
    // An error at the end of the text is shown at the end of its last line that has something.
    let place = if text[place..].trim().is_empty() {
        place.min(text.trim_end().len())
    } else {
        place
    };
    let start = text[..place].rfind('\n').map_or(0, |end| end + 1);
    let end = text[place..]
        .find('\n')
        .map_or(text.len(), |length| place + length);
    let line = text[..start].matches('\n').count() + 1;
    let shown = text[start..end].trim_end();
    let at = (place - start).min(shown.len());
    let mark = shown[at..].chars().next().map_or(0, char::len_utf8);
    let snippet = Snippet::source(shown)
        .line_start(line)
        .annotation(Level::Error.span(at..at + mark));
    let rendered = Renderer::plain()
        .term_width(WIDTH)
        .render(Level::Error.title("").snippet(snippet))
        .to_string();
    // The first line is the title, which the caller has.
    let lines: Vec<&str> = rendered.lines().skip(1).map(str::trim_end).collect();
    Excerpt {
        line,
        column: text[start..start + at].chars().count() + 1,
        lines: lines.join("\n"),
    }
}
