//! Answers on a terminal: a sign and a colour for the verdict, one statement a line, lines of the terminal's
//! width. A pipe gets none of this: its lines are for scripts, and stay as they are.

use anstream::{AutoStream, ColorChoice};
use anstyle::{AnsiColor, Style};
use std::io::{self, IsTerminal};
use textwrap::{Options, WordSeparator, WordSplitter};

/// How a terminal shows things.
pub struct Look {
    width: usize,
    is_coloured: bool,
}

/// Widths of a terminal that does not say its own.
const WIDTH: usize = 80;

/// Narrower terminals break lines where they like.
const LEAST: usize = 20;

impl Look {
    /// That of standard output, if it is a terminal.
    pub fn of_standard_output() -> Option<Look> {
        let stream = io::stdout();
        let width = || {
            let size = terminal_size::terminal_size_of(io::stdout());
            size.map_or(WIDTH, |(width, _)| usize::from(width.0))
        };
        stream.is_terminal().then(|| Look {
            width: width().max(LEAST),
            is_coloured: AutoStream::choice(&stream) != ColorChoice::Never,
        })
    }

    /// A line, broken between words. The lines after the first have two more blanks before them.
    pub fn wrapped(&self, line: &str) -> String {
        let text = line.trim_start_matches(' ');
        let indent = " ".repeat(line.len() - text.len());
        let rest = format!("{indent}  ");
        let options = Options::new(self.width)
            .initial_indent(&indent)
            .subsequent_indent(&rest)
            .word_separator(WordSeparator::AsciiSpace)
            .word_splitter(WordSplitter::NoHyphenation)
            .break_words(false);
        textwrap::fill(text, options)
    }

    /// The line with the verdict on a subject.
    pub fn title(&self, subject: &str, verdict: &str) -> String {
        let (sign, colour) = match verdict {
            "proved" | "verified" | "holds" | "confirmed" => ("✓", AnsiColor::Green),
            "refuted" | "rejected" | "fails" => ("✗", AnsiColor::Red),
            "declined" | "undecided" => ("?", AnsiColor::Yellow),
            _ => ("!", AnsiColor::Red),
        };
        let sign = self.painted(&format!("{sign} {verdict}"), colour);
        format!("{sign} {subject}")
    }

    fn painted(&self, text: &str, colour: AnsiColor) -> String {
        if self.is_coloured {
            let style = Style::new().bold().fg_color(Some(colour.into()));
            format!("{style}{text}{style:#}")
        } else {
            text.to_owned()
        }
    }
}
