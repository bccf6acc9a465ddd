//! An input as the command line gives it: a name of the catalogue, or a file, whose name may be any bytes.

use super::words::printable;
use acutile_catalog as catalog;
use clap::builder::{PossibleValue, TypedValueParser, ValueParserFactory};
use clap::{Arg, Command, Error};
use std::ffi::{OsStr, OsString};
use std::fmt;
use std::ops::Deref;
use std::path::{Path, PathBuf};

/// An input. The text is for messages and for names of the catalogue: one line, without control characters.
/// [`InputName::path`] opens files, since the text of an unusual name names no file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct InputName {
    raw: OsString,
    text: String,
}

impl InputName {
    /// The file with this name, or `-`.
    pub fn path(&self) -> &Path {
        Path::new(&self.raw)
    }

    /// The name as it was given.
    pub fn raw(&self) -> &OsStr {
        &self.raw
    }

    /// The path after a prefix of ASCII letters, as in `square-triangle:FILE`.
    pub fn path_after(&self, prefix: &str) -> PathBuf {
        #[cfg(unix)]
        {
            use std::os::unix::ffi::OsStrExt;
            let rest = self.raw.as_bytes().get(prefix.len()..);
            PathBuf::from(OsStr::from_bytes(rest.unwrap_or_default()))
        }
        #[cfg(not(unix))]
        PathBuf::from(self.text.get(prefix.len()..).unwrap_or_default())
    }

    /// Whether it is `-`.
    pub fn is_standard_input(&self) -> bool {
        self.raw == "-"
    }
}

/// Standard input can be read only once.
///
/// # Errors
/// More than one of the names is `-`.
pub fn check_standard_input<'a>(names: impl Iterator<Item = &'a OsStr>) -> Result<(), String> {
    match names.filter(|name| *name == "-").count() {
        0 | 1 => Ok(()),
        count => Err(format!(
            "-: standard input is named {count} times, expected once; give the other files by name"
        )),
    }
}

impl From<OsString> for InputName {
    fn from(raw: OsString) -> Self {
        let text = printable(&raw);
        InputName { raw, text }
    }
}

impl From<&str> for InputName {
    fn from(text: &str) -> Self {
        OsString::from(text).into()
    }
}

impl From<&OsStr> for InputName {
    fn from(raw: &OsStr) -> Self {
        raw.to_owned().into()
    }
}

impl Deref for InputName {
    type Target = str;

    fn deref(&self) -> &str {
        &self.text
    }
}

impl fmt::Display for InputName {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(&self.text)
    }
}

/// Takes anything; shells complete the names of the catalogue, and else files.
#[derive(Clone, Debug)]
pub struct NameParser;

impl TypedValueParser for NameParser {
    type Value = InputName;

    fn parse_ref(&self, _: &Command, _: Option<&Arg>, value: &OsStr) -> Result<InputName, Error> {
        Ok(value.into())
    }

    fn possible_values(&self) -> Option<Box<dyn Iterator<Item = PossibleValue> + '_>> {
        let theorems = catalog::THEOREMS.iter().map(|theorem| theorem.name);
        let names = catalog::entries().iter().map(|entry| entry.name);
        Some(Box::new(names.chain(theorems).map(PossibleValue::new)))
    }
}

impl ValueParserFactory for InputName {
    type Parser = NameParser;

    fn value_parser() -> NameParser {
        NameParser
    }
}
