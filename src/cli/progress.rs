//! The line on the terminal that names the current step of a long check. It shows after a moment only, on
//! standard error only, and only where that is a terminal.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::time::Duration;

/// A line that names the current step.
pub struct Progress {
    bar: ProgressBar,
    name: String,
}

impl Progress {
    /// Progress of the work on `name`.
    pub fn of(name: &str) -> Self {
        let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::stderr());
        if let Ok(style) = ProgressStyle::with_template("{spinner} {elapsed} {msg}") {
            bar.set_style(style);
        }
        bar.enable_steady_tick(Duration::from_millis(200));
        Progress {
            bar,
            name: name.to_owned(),
        }
    }

    /// The work has come to this step.
    pub fn step(&self, step: &str) {
        self.bar.set_message(format!("{}: {step}", self.name));
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}
