//! A row: a statement of the paper, its printed form, the proved form, and the verdict.

use crate::survey::Survey;
use crate::table::Figure;
use acutile_core::quality::{rounded_down, rounded_nearest, rounded_up};
use malachite::Rational;
use malachite::base::num::arithmetic::traits::Floor;
use serde_json::{Value, json};
use std::fmt;

/// The verdict on a statement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// It holds as printed.
    Confirmed,
    /// It is about a construction, and holds for all members: a certificate proves it.
    ProvedForAll,
    /// The printed figure is the proved value rounded in this way.
    Rounded(Rounding),
    /// The printed figure is neither the proved value nor that value rounded or truncated.
    Misprint,
    /// It does not hold.
    Refuted,
    /// An open problem; the row has proved bounds.
    Open,
    /// Nothing was proved; the row says why. Only where a construction is missing.
    Undecided,
}

/// How a figure was rounded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rounding {
    /// To the nearest; truncation would give another figure.
    Nearest,
    /// Digits were cut off; the nearest figure is another one.
    Truncated,
    /// Rounding and truncation give the same figure.
    Either,
}

impl Verdict {
    /// The verdict in a word.
    pub fn word(&self) -> &'static str {
        match self {
            Verdict::Confirmed => "confirmed",
            Verdict::ProvedForAll => "proved for all",
            Verdict::Rounded(_) => "rounded",
            Verdict::Misprint => "misprint",
            Verdict::Refuted => "refuted",
            Verdict::Open => "open",
            Verdict::Undecided => "undecided",
        }
    }

    /// Confirmed or refuted.
    pub fn of(holds: bool) -> Verdict {
        if holds {
            Verdict::Confirmed
        } else {
            Verdict::Refuted
        }
    }
}

impl Rounding {
    fn words(self) -> &'static str {
        match self {
            Rounding::Nearest => "to nearest",
            Rounding::Truncated => "truncated",
            Rounding::Either => "to nearest, truncation gives the same",
        }
    }
}

/// A statement with its verdict.
#[derive(Clone, Debug)]
pub struct Row {
    /// A stable name.
    pub id: String,
    /// The paper's section.
    pub section: &'static str,
    /// The statement in our words.
    pub statement: String,
    /// The paper's text.
    pub printed: String,
    /// The proved text.
    pub proved: String,
    /// Whether the statement holds.
    pub verdict: Verdict,
    /// The certificates that the proof rests on: constructions and SHA-256.
    pub certificates: Vec<(String, String)>,
}

/// The result of a proof: whether the statement holds, and the evidence; or why nothing was
/// decided.
pub type Finding = Result<(bool, String), String>;

impl Row {
    /// A row that is still to be decided.
    pub fn new(section: &'static str, id: &str, statement: &str, printed: &str) -> Row {
        Row {
            id: id.to_owned(),
            section,
            statement: statement.to_owned(),
            printed: printed.to_owned(),
            proved: String::new(),
            verdict: Verdict::Undecided,
            certificates: Vec::new(),
        }
    }

    /// Cites the certificates of those of these constructions that there are.
    pub fn citing(mut self, survey: &Survey, names: &[&str]) -> Row {
        for name in names {
            let study = survey.get(name).map(|study| study.certificate());
            let hash = study.or_else(|_| survey.general(name).map(|general| &*general.certificate));
            if let Ok(hash) = hash {
                self.certificates
                    .push(((*name).to_owned(), hash.to_owned()));
            }
        }
        self
    }

    /// The row with the result of a proof.
    pub fn found(mut self, finding: Finding) -> Row {
        (self.verdict, self.proved) = match finding {
            Ok((holds, proved)) => (Verdict::of(holds), proved),
            Err(reason) => (Verdict::Undecided, reason),
        };
        self
    }

    /// The row with a proof about all members of a construction.
    pub fn found_for_all(self, finding: Finding) -> Row {
        let mut row = self.found(finding);
        if row.verdict == Verdict::Confirmed {
            row.verdict = Verdict::ProvedForAll;
        }
        row
    }

    /// The row with its printed decimal judged against the proved figure.
    pub fn figure(mut self, unit: &str, figure: Result<Figure, String>) -> Row {
        (self.verdict, self.proved) = match figure {
            Ok(figure) => (judge(&self.printed, &figure), describe(&figure, unit)),
            Err(reason) => (Verdict::Undecided, reason),
        };
        self
    }

    /// The row as an object.
    pub fn to_json(&self) -> Value {
        let mut row = json!({
            "id": self.id,
            "section": self.section,
            "statement": self.statement,
            "printed": self.printed,
            "proved": self.proved,
            "verdict": self.verdict.word(),
        });
        if let Verdict::Rounded(rounding) = self.verdict {
            row["rounding"] = json!(rounding.words());
        }
        if !self.certificates.is_empty() {
            let pairs = self.certificates.iter().cloned();
            row["certificates"] = json!(pairs.collect::<std::collections::BTreeMap<_, _>>());
        }
        row
    }
}

impl fmt::Display for Row {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let verdict = match self.verdict {
            Verdict::Rounded(rounding) => format!("rounded ({})", rounding.words()),
            verdict => verdict.word().to_owned(),
        };
        writeln!(f, "{} [section {}] {verdict}", self.id, self.section)?;
        writeln!(f, "  statement: {}", self.statement)?;
        writeln!(f, "  printed: {}", self.printed)?;
        write!(f, "  proved: {}", self.proved)?;
        if self.verdict == Verdict::ProvedForAll {
            for (name, hash) in &self.certificates {
                write!(f, "\n  certificate: {name}, SHA-256 {hash}")?;
            }
        }
        Ok(())
    }
}

/// Judges a printed decimal against a figure.
pub fn judge(printed: &str, figure: &Figure) -> Verdict {
    let digits = printed
        .split_once('.')
        .map_or(0, |(_, fraction)| fraction.len()) as u64;
    // The paper writes .651 for 0.651.
    let printed = if printed.starts_with('.') {
        format!("0{printed}")
    } else {
        printed.to_owned()
    };
    let (low, high) = &figure.bounds;
    let agrees = |round: fn(&Rational, u64) -> String| {
        round(low, digits) == printed && round(high, digits) == printed
    };
    let is_exact = low == high && decimal(&printed).as_ref() == Some(low);
    match (is_exact, agrees(rounded_nearest), agrees(rounded_down)) {
        (true, ..) => Verdict::Confirmed,
        (_, true, true) => Verdict::Rounded(Rounding::Either),
        (_, true, false) => Verdict::Rounded(Rounding::Nearest),
        (_, false, true) => Verdict::Rounded(Rounding::Truncated),
        (_, false, false) => Verdict::Misprint,
    }
}

/// The value of a decimal.
pub fn decimal(text: &str) -> Option<Rational> {
    acutile_exact::number::parse_rational(text).ok()
}

/// A figure for readers: the value, or an enclosure, with the closed form.
pub fn describe(figure: &Figure, unit: &str) -> String {
    let (low, high) = &figure.bounds;
    let value = if low == high {
        format!("{low}{unit}")
    } else {
        format!("{} to {}{unit}", rounded_down(low, 9), rounded_up(high, 9))
    };
    match &figure.closed_form {
        Some(form) if low != high => format!("{form} = {value}"),
        _ => value,
    }
}

/// A fraction above 1 as `5 1/10`.
pub fn mixed_number(value: &Rational) -> Option<String> {
    let whole = value.clone().floor();
    let rest = value - Rational::from(&whole);
    (whole > 0 && rest != 0).then(|| format!("{whole} {rest}"))
}
