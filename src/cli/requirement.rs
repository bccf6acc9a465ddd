//! Statements of `--require`, which shells complete.

use acutile_core::statement::Requirement;
use clap::builder::{PossibleValue, StringValueParser, TypedValueParser};
use clap::{Arg, Command, Error};
use std::ffi::OsStr;

/// Words that shells offer; the bounds of angles and ratios are written after them.
const WORDS: [&str; 13] = [
    "tiling",
    "acute",
    "nonobtuse",
    "delaunay",
    "weakly-delaunay",
    "not-delaunay",
    "tcp",
    "connected",
    "no-cavities",
    "manifold-boundary",
    "dihedral-below=",
    "dihedral-above=",
    "radius-edge-below=",
];

/// Reads a statement.
#[derive(Clone, Debug)]
pub struct RequirementParser;

impl TypedValueParser for RequirementParser {
    type Value = Requirement;

    fn parse_ref(
        &self,
        command: &Command,
        argument: Option<&Arg>,
        value: &OsStr,
    ) -> Result<Requirement, Error> {
        let parser = StringValueParser::new().try_map(|text| text.parse::<Requirement>());
        parser.parse_ref(command, argument, value)
    }

    fn possible_values(&self) -> Option<Box<dyn Iterator<Item = PossibleValue> + '_>> {
        Some(Box::new(WORDS.into_iter().map(PossibleValue::new)))
    }
}
