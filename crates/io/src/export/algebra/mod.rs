//! A tiling as a program for a computer algebra system or a proof assistant.
//! It has exact numbers in the field of the tiling. The system decides its assertions when it loads the file.
//!
//! The assertions are: the metric is positive, no simplex is flat, and the volumes add up to the printed sum.
//! Each simplex has the squared edges and the signs of dihedral angles of its congruence class.
//! They do not prove that the simplices tile: that is the certificate's business.
//! The programs are the files in `templates`.

mod facts;
mod integral;
mod symbolic;

use acutile_core::tiling::{Domain, Tiling};
use facts::Facts;

/// The system that reads the file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum System {
    /// Sage, with its preparser.
    Sage,
    /// Mathematica, as a package in the Wolfram Language.
    Mathematica,
    /// GAP, without packages.
    Gap,
    /// Lean 4, without libraries.
    Lean,
}

impl System {
    fn template(self) -> &'static str {
        match self {
            System::Sage => include_str!("templates/tiling.sage"),
            System::Mathematica => include_str!("templates/tiling.wl"),
            System::Gap => include_str!("templates/tiling.g"),
            System::Lean => include_str!("templates/tiling.lean"),
        }
    }
}

/// The file of a tiling for a system.
pub fn algebra_text<const D: usize>(tiling: &Tiling<D>, name: &str, system: System) -> String {
    let facts = Facts::of(tiling);
    let mut values = vec![
        ("NAME", plain(name)),
        ("VERSION", env!("CARGO_PKG_VERSION").to_owned()),
        ("RANK", tiling.frame.rank().to_string()),
        ("DOMAIN", domain(&tiling.frame.domain).to_owned()),
        ("D", D.to_string()),
    ];
    values.extend(match system {
        System::Lean => integral::values(tiling, &facts),
        _ => symbolic::values(tiling, &facts, system),
    });
    filled(system.template(), &values)
}

/// Nothing that could end a comment of one of the systems.
fn plain(name: &str) -> String {
    let is_plain = |c: char| c.is_alphanumeric() || " .,:+=^_".contains(c);
    let letter = |c: char| if is_plain(c) { c } else { '-' };
    name.chars().map(letter).collect()
}

fn domain(domain: &Domain) -> &'static str {
    match domain {
        Domain::Space => "all of space",
        Domain::Slab(_) => "a slab",
        Domain::Prism(_) => "a prism",
        Domain::Solid(_) => "a convex solid",
        Domain::Region(_) => "the union of the simplices",
    }
}

/// The template with each `@KEY@` replaced in one pass, so that a value is never read as a key.
fn filled(template: &str, values: &[(&str, String)]) -> String {
    let mut text = String::new();
    let mut rest = template;
    while let Some((before, after)) = rest.split_once('@') {
        text.push_str(before);
        let value = after.split_once('@').and_then(|(key, tail)| {
            let (_, value) = values.iter().find(|(other, _)| *other == key)?;
            Some((value, tail))
        });
        rest = match value {
            Some((value, tail)) => {
                text.push_str(value);
                tail
            }
            None => {
                text.push('@');
                after
            }
        };
    }
    text + rest
}

/// A list of entries in brackets, each on a line of its own if they are long.
fn list(entries: impl IntoIterator<Item = String>, [open, close]: [&str; 2]) -> String {
    let entries: Vec<String> = entries.into_iter().collect();
    let length: usize = entries.iter().map(String::len).sum();
    let separator = if length > 80 { ",\n  " } else { ", " };
    format!("{open}{}{close}", entries.join(separator))
}

#[cfg(test)]
mod tests {
    use super::{filled, plain};

    #[test]
    fn values_are_not_read_as_keys() {
        let values = [("A", "@B@".to_owned()), ("B", "x".to_owned())];
        assert_eq!(filled("@A@ @B@ mail@C @A@", &values), "@B@ x mail@C @B@");
    }

    #[test]
    fn names_end_no_comment() {
        assert_eq!(plain("x *) -/ \"\n3^2.4"), "x -- -- --3^2.4");
    }
}
