//! Counts of verdicts, for a command with several inputs.

use super::output::Output;
use std::collections::BTreeMap;

/// How often each verdict occurs.
#[derive(Default)]
pub struct Counts(BTreeMap<&'static str, usize>);

impl Counts {
    pub fn add(&mut self, verdict: &'static str) {
        *self.0.entry(verdict).or_insert(0) += 1;
    }

    /// On a terminal a last line about several inputs.
    pub fn tell(&self, output: &mut Output) {
        let total: usize = self.0.values().sum();
        if output.look().is_none() || total < 2 {
            return;
        }
        let counts = self.0.iter().map(|(verdict, n)| format!("{n} {verdict}"));
        let counts = counts.collect::<Vec<_>>().join(", ");
        output.line(format!("{total} inputs: {counts}"));
    }
}
