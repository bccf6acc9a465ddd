//! `acutile report`: a page to look at, of proved and of refuted tilings.

use super::input::FileArguments;
use super::limits::LimitArguments;
use super::outcome::Outcome;
use super::output::{Output, write_text};
use super::proved::{overwritten, shown};
use acutile_publish::report::{Proved, Refutation, Shown, mixed_page};
use clap::Args;
use std::path::{Path, PathBuf};

#[derive(Debug, Args)]
pub struct ReportArguments {
    /// Certificates, names of the catalogue, tiling or mesh files, or point sets (CIF too)
    #[arg(value_name = "CERT|NAME|FILE", required = true)]
    pub inputs: Vec<String>,
    #[command(flatten)]
    pub file: FileArguments,
    /// Write the page here and not to standard output
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    #[command(flatten)]
    pub limits: LimitArguments,
}

/// An article of a page.
pub enum Article {
    Proved(Box<Proved>),
    Refuted(Box<Refutation>),
}

impl Article {
    fn shown(&self) -> Shown<'_> {
        match self {
            Article::Proved(proved) => Shown::Proved(proved),
            Article::Refuted(refutation) => Shown::Refuted(refutation),
        }
    }
}

/// Writes the page; nothing is written where an input is neither proved nor refuted.
pub fn run(arguments: &ReportArguments, output: &mut Output) -> Outcome {
    if let Some(input) = overwritten(&arguments.inputs, arguments.output.as_deref()) {
        output.complain(format!("acutile: -o would overwrite the input {input}"));
        return Outcome::Failed;
    }
    let limits = arguments.limits.limits();
    let mut articles = Vec::new();
    let mut worst = Outcome::Done;
    for input in &arguments.inputs {
        match shown(input, &arguments.file, &limits, output) {
            Ok(article) => articles.push(article),
            Err(error) => {
                output.complain(format!("acutile: {}", error.message));
                return error.outcome;
            }
        }
        if let Some(Article::Refuted(refutation)) = articles.last() {
            let verdict = refutation.verdict.trim_start_matches("Refuted: ");
            output.complain(format!("acutile: {input}: refuted: {verdict}"));
            worst = Outcome::Refuted;
        }
    }
    worst.and(write(&articles, arguments.output.as_deref(), output))
}

/// Writes the page of these articles.
pub fn write(articles: &[Article], path: Option<&Path>, output: &mut Output) -> Outcome {
    let shown: Vec<Shown> = articles.iter().map(Article::shown).collect();
    write_text(path, &mixed_page(&shown, None), output)
}
