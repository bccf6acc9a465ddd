//! Where a command prints, and which files it says it wrote.
//!
//! A reader that closes the pipe early ends the printing quietly; any other error
//! of standard output makes the command fail.

use super::files::{is_standard, unwritten, write_file};
use super::look::Look;
use super::named::InputError;
use super::outcome::Outcome;
use super::record::Record;
use super::words::one_line;
use acutile_io::import::io_words;
use serde_json::{Value, json};
use std::fmt::Display;
use std::io::{self, BufWriter, ErrorKind, Stdout, Write};
use std::path::Path;

/// Standard output and standard error.
pub struct Output {
    writer: BufWriter<Stdout>,
    error: Option<io::Error>,
    command: String,
    is_json: bool,
    /// Standard output has a document, so answers go to standard error.
    has_document: bool,
    notes: Vec<String>,
    files: Vec<Value>,
    look: Option<Look>,
}

impl Output {
    /// The process's own streams.
    pub fn standard() -> Self {
        Output {
            writer: BufWriter::new(io::stdout()),
            error: None,
            command: String::new(),
            is_json: false,
            has_document: false,
            notes: Vec::new(),
            files: Vec::new(),
            look: None,
        }
    }

    /// The streams of a command.
    pub fn of_command(command: &str, is_json: bool) -> Self {
        Output {
            command: command.to_owned(),
            is_json,
            look: Look::of_standard_output().filter(|_| !is_json),
            ..Output::standard()
        }
    }

    /// Whether answers are JSON.
    pub fn is_json(&self) -> bool {
        self.is_json
    }

    /// From now on answers go to standard error, if the document that the command writes goes to standard output.
    pub fn document_goes_to(&mut self, path: Option<&Path>) {
        self.has_document = path.is_none_or(is_standard);
    }

    /// Prints a line of an answer.
    pub fn say(&mut self, text: impl Display) {
        if self.has_document {
            self.complain(text)
        } else {
            self.line(text)
        }
    }

    /// Prints a part of a line of an answer.
    pub fn say_part(&mut self, text: &str) {
        if self.has_document {
            let _ = self.writer.flush();
            let _ = write!(io::stderr(), "{text}");
        } else {
            self.bytes(text.as_bytes())
        }
    }

    /// Prints an answer as JSON, with the notes and files of the output.
    pub fn answer(&mut self, record: Record) {
        let text = self.record(record).text();
        self.say_part(&format!("{text}\n"));
    }

    /// An answer with the command, and the notes and files of the output.
    pub fn record(&mut self, record: Record) -> Record {
        let notes = std::mem::take(&mut self.notes);
        let files = std::mem::take(&mut self.files);
        let record = record.member("command", json!(self.command));
        let record = if record.has_notes() {
            record
        } else {
            record.notes(&notes)
        };
        if files.is_empty() {
            record
        } else {
            record.member("files", Value::Array(files))
        }
    }

    /// Says why there is no answer; with --json in the shape of an answer.
    pub fn fail(&mut self, input: Option<&str>, error: &InputError) -> Outcome {
        if self.is_json {
            self.answer(Record::failed(input, error))
        } else {
            self.complain(format!("acutile: {}", error.message))
        }
        error.outcome
    }

    /// The same for a usage or an output that is wrong.
    pub fn fail_with(&mut self, input: Option<&str>, message: impl Into<String>) -> Outcome {
        self.fail(input, &InputError::from(message.into()))
    }

    /// Prints a note on an input on standard error, and keeps it for the answer. It can contain texts of the input,
    /// so control characters are escaped.
    pub fn note(&mut self, input: &str, note: &str) {
        let note = one_line(note);
        self.complain(format!("{input}: {note}"));
        self.notes.push(note);
    }

    /// The notes since the last answer.
    pub fn take_notes(&mut self) -> Vec<String> {
        std::mem::take(&mut self.notes)
    }

    /// Remembers a file for the answer.
    pub fn wrote(&mut self, path: &Path, bytes: usize) {
        let path = path.to_string_lossy();
        self.files.push(json!({ "path": path, "bytes": bytes }));
    }

    /// An answer about files that belong to no single input.
    pub fn tell_files(&mut self) {
        if self.is_json && !self.files.is_empty() {
            self.answer(Record::of(None));
        }
    }

    /// Ends a command whose answer is the files that it has written, and a line that says so.
    pub fn done_in_words(&mut self, record: Record, words: impl Display) -> Outcome {
        if !self.is_json {
            self.say(words);
        }
        self.done(record)
    }

    /// Ends a command whose answer is the files that it has written.
    pub fn done(&mut self, record: Record) -> Outcome {
        if self.is_json {
            self.answer(record);
        }
        Outcome::Done
    }

    /// Prints a line, on a terminal broken between words.
    pub fn line(&mut self, text: impl Display) {
        let text = text.to_string();
        let text = match &self.look {
            Some(look) => look.wrapped(&text),
            None => text,
        };
        self.bytes(format!("{text}\n").as_bytes());
    }

    /// How answers look, if they go to a terminal.
    pub fn look(&self) -> Option<&Look> {
        self.look.as_ref().filter(|_| !self.has_document)
    }

    /// On a terminal a title with its statements below it, elsewhere the line.
    pub fn tell(&mut self, subject: &str, verdict: &str, statements: &[String], line: &str) {
        let Some(look) = self.look() else {
            return self.say(line);
        };
        let title = format!("{}\n", look.title(subject, verdict));
        self.bytes(title.as_bytes());
        for statement in statements {
            self.line(format!("    {statement}"));
        }
    }

    /// Prints bytes as they are.
    pub fn bytes(&mut self, bytes: &[u8]) {
        if self.error.is_none() {
            self.error = self.writer.write_all(bytes).err();
        }
    }

    /// Prints a line on standard error. Nothing is left to do where that fails.
    pub fn complain(&mut self, text: impl Display) {
        let _ = self.writer.flush();
        let _ = writeln!(io::stderr(), "{text}");
    }

    /// Flushes; failed where standard output took not everything.
    pub fn finish(&mut self) -> Outcome {
        if self.error.is_none() {
            self.error = self.writer.flush().err();
        }
        match &self.error {
            Some(error) if error.kind() != ErrorKind::BrokenPipe => {
                let _ = writeln!(
                    io::stderr(),
                    "acutile: standard output: {}",
                    io_words(error)
                );
                Outcome::Failed
            }
            _ => Outcome::Done,
        }
    }
}

/// Never fails: an error is kept, and [`Output::finish`] returns it.
impl Write for Output {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.bytes(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        if self.error.is_none() {
            self.error = self.writer.flush().err();
        }
        Ok(())
    }
}

/// Writes a file, or to standard output for `-` and where there is none.
///
/// # Errors
/// A message that names the file.
pub fn write_bytes(
    path: Option<&Path>,
    bytes: &[u8],
    output: &mut Output,
) -> Result<(), InputError> {
    let Some(path) = path.filter(|path| !is_standard(path)) else {
        output.bytes(bytes);
        output.wrote(Path::new("-"), bytes.len());
        return Ok(());
    };
    write_file(path, bytes).map_err(|error| unwritten(path, &error))?;
    output.wrote(path, bytes.len());
    Ok(())
}
