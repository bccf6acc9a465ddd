//! A line of the table: the measured value, its target, and whether it is reached.

use std::time::Duration;

/// Prints rows.
pub struct Table {
    /// Whether lines for programs are printed, too.
    pub for_programs: bool,
}

/// The target for the measured value.
#[derive(Clone, Copy)]
pub enum Target {
    /// At most this.
    Most(f64),
    /// At least this.
    Least(f64),
    /// Nothing is asked for.
    None,
}

use Target::{Least, Most};

impl Target {
    fn verdict(self, value: f64) -> &'static str {
        let is_met = match self {
            Most(limit) => value <= limit,
            Least(limit) => value >= limit,
            Target::None => return "-",
        };
        if is_met { "met" } else { "not met" }
    }

    fn text(self) -> String {
        match self {
            Most(limit) => format!("<= {}", figure(limit)),
            Least(limit) => format!(">= {}", figure(limit)),
            Target::None => "-".to_owned(),
        }
    }
}

impl Table {
    /// A line between rows.
    pub fn head(&self, title: &str) {
        println!("\n{title}");
        println!(
            "  {:46} {:>10} {:22} {:>12}  verdict",
            "", "measured", "unit", "target"
        );
        if self.for_programs {
            println!("@head\t{title}");
        }
    }

    /// A row; `note` has the text that fits no column.
    pub fn row(&self, work: &str, value: f64, unit: &str, target: Target, note: &str) {
        let (shown, aim, verdict) = (figure(value), target.text(), target.verdict(value));
        println!("  {work:46} {shown:>10} {unit:22} {aim:>12}  {verdict:7} {note}");
        if self.for_programs {
            println!("@row\t{work}\t{value}\t{unit}\t{aim}\t{verdict}\t{note}");
        }
    }

    /// A row without a target.
    pub fn plain(&self, work: &str, value: f64, unit: &str, note: &str) {
        self.row(work, value, unit, Target::None, note);
    }
}

/// Three significant figures, or all before the point.
fn figure(value: f64) -> String {
    let places = match value.abs() {
        100.0.. => 0,
        10.0.. => 1,
        1.0.. => 2,
        _ => 4,
    };
    let text = format!("{value:.places$}");
    let (whole, rest) = text.split_at(text.find('.').unwrap_or(text.len()));
    let mut grouped = String::new();
    for (k, digit) in whole.chars().enumerate() {
        if k > 0 && (whole.len() - k) % 3 == 0 && digit.is_ascii_digit() {
            grouped.push(',');
        }
        grouped.push(digit);
    }
    grouped + rest
}

/// The quotient of two times.
pub fn ratio(time: Duration, unit: Duration) -> f64 {
    time.as_secs_f64() / unit.as_secs_f64().max(1e-12)
}
