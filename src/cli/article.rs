//! Articles of a page of proved and refuted tilings.

use super::outcome::Outcome;
use super::output::{Output, write_bytes};
use acutile_publish::bundle::Content;
use acutile_publish::report::{Refutation, Shown, mixed_page};
use std::path::Path;

/// An article of a page.
pub enum Article {
    Confirmed(Content),
    Refuted(Box<Refutation>),
}

impl Article {
    fn shown(&self) -> Shown<'_> {
        match self {
            Article::Confirmed(content) => content.shown(),
            Article::Refuted(refutation) => Shown::Refuted(refutation),
        }
    }
}

/// Writes the page of these articles.
pub fn write(articles: &[Article], path: Option<&Path>, output: &mut Output) -> Outcome {
    let shown: Vec<Shown> = articles.iter().map(Article::shown).collect();
    match write_bytes(path, mixed_page(&shown, None).as_bytes(), output) {
        Ok(()) => Outcome::Done,
        Err(error) => output.fail(None, &error),
    }
}
