//! The object that `--json` prints: one shape for every command (docs/json.md).

use super::named::InputError;
use super::outcome::Outcome;
use serde_json::{Map, Value, json};
use std::path::Path;

/// The name of the shape.
const FORMAT: &str = "acutile-answer";

/// Its version.
const VERSION: u64 = 1;

/// An answer as data. [`super::output::Output::answer`] adds the command and prints it.
#[derive(Clone, Debug)]
pub struct Record {
    members: Map<String, Value>,
}

impl Record {
    /// An answer about an input; `None` for commands without one.
    pub fn of(input: Option<&str>) -> Self {
        let mut members = Map::new();
        members.insert("format".to_owned(), json!(FORMAT));
        members.insert("version".to_owned(), json!(VERSION));
        members.insert("input".to_owned(), json!(input));
        for member in ["verdict", "certificate"] {
            members.insert(member.to_owned(), Value::Null);
        }
        Record { members }
    }

    /// Why there is no answer.
    pub fn failed(input: Option<&str>, error: &InputError) -> Self {
        let record = Record::of(input).verdict(verdict(error.outcome));
        record.member("error", json!(error.message))
    }

    pub fn verdict(self, verdict: &str) -> Self {
        self.member("verdict", json!(verdict))
    }

    /// The certificate, by its digest, and its file if it has one.
    pub fn certificate(self, path: Option<&Path>, sha256: &str) -> Self {
        let path = path.map(Path::to_string_lossy);
        self.member("certificate", json!({ "path": path, "sha256": sha256 }))
    }

    /// Notes, instead of those that the output has collected.
    pub fn notes(self, notes: &[String]) -> Self {
        self.member("notes", json!(notes))
    }

    pub fn has_notes(&self) -> bool {
        self.members.contains_key("notes")
    }

    pub fn member(mut self, name: &str, value: Value) -> Self {
        self.members.insert(name.to_owned(), value);
        self
    }

    /// Adds the members of an object.
    pub fn with(mut self, body: Value) -> Self {
        if let Value::Object(members) = body {
            self.members.extend(members);
        }
        self
    }

    /// The text, in one line.
    pub fn text(self) -> String {
        Value::Object(self.members).to_string()
    }
}

/// The verdict that goes with an exit code.
pub fn verdict(outcome: Outcome) -> &'static str {
    match outcome {
        Outcome::Done => "proved",
        Outcome::Refuted => "refuted",
        Outcome::Failed => "failed",
        Outcome::Declined => "declined",
    }
}
