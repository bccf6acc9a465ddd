//! The sites of a data block: labels and coordinates, chosen, snapped and checked.

use super::block::Block;
use super::columns::{Table, known};
use super::disorder;
use super::token::{Value, at_line};
use crate::import::ImportError;
use crate::import::atoms::decimal::{Decimal, Snapped};
use crate::import::atoms::options::CifOptions;
use crate::import::atoms::select;
use malachite::Rational;

/// A site of the asymmetric unit.
pub struct Site {
    pub label: String,
    /// Of its type symbol, or of its label.
    pub element: Option<&'static str>,
    pub line: u32,
    pub position: [Rational; 3],
    /// One unit of the last written digit of each coordinate, zero where that is exact.
    pub units: [Rational; 3],
    /// The standard uncertainty of each coordinate, zero where it has none or was snapped.
    pub uncertainties: [Rational; 3],
    /// The position before it was snapped.
    pub written: [Rational; 3],
    /// How many atoms the file says that it stands for.
    pub multiplicity: Option<usize>,
}

/// The chosen sites, and the changes to their numbers.
#[derive(Default)]
pub struct Sites {
    pub sites: Vec<Site>,
    /// How many the file lists.
    pub listed: usize,
    /// Replaced and ambiguous numbers, in words.
    pub notes: Vec<String>,
    /// How many numbers had an uncertainty.
    pub uncertain: usize,
}

/// The sites of a block that the options choose.
///
/// # Errors
/// Values that are missing, unreadable or disordered.
pub fn sites(block: &Block, options: &CifOptions) -> Result<Sites, ImportError> {
    Table::of(block)?.read(options)
}

impl Table<'_, '_> {
    fn read(&self, options: &CifOptions) -> Result<Sites, ImportError> {
        let rows = self.coordinates[0].len();
        let names: Vec<(String, Option<&'static str>)> = (0..rows)
            .map(|row| {
                let label = self.label(row);
                let element = self.element(row, &label);
                (label, element)
            })
            .collect();
        let chosen = select::chosen(&names, options)?;
        let labels: Vec<&str> = names.iter().map(|(label, _)| label.as_str()).collect();
        let mut sites = Sites {
            listed: rows,
            ..Sites::default()
        };
        let taken = disorder::check(self, &chosen, &labels, options, &mut sites.notes)?;
        for (row, (label, element)) in names.into_iter().enumerate() {
            if taken[row] {
                let site = self.site(row, label, element, options, &mut sites)?;
                sites.sites.push(site);
            }
        }
        if sites.sites.is_empty() {
            return Err(ImportError::entry(
                "sites",
                "no site is left that is an atom",
            ));
        }
        Ok(sites)
    }

    fn site(
        &self,
        row: usize,
        label: String,
        element: Option<&'static str>,
        options: &CifOptions,
        sites: &mut Sites,
    ) -> Result<Site, ImportError> {
        let mut numbers = Vec::new();
        let mut texts = Vec::new();
        for (column, axis) in self.coordinates.iter().zip(["x", "y", "z"]) {
            let value = column.value(row);
            let number = coordinate(&value, axis, &label)?;
            sites.uncertain += usize::from(number.uncertainty.is_some());
            numbers.push(number);
            texts.push(value.text);
        }
        let multiplicity = known(self.multiplicity, row).and_then(|value| value.text.parse().ok());
        let snapped = options
            .snap
            .and_then(|n| snapped(&numbers, &texts, &label, n, &mut sites.notes));
        let written = std::array::from_fn(|k| numbers[k].value.clone());
        let is_snapped = |k: usize| {
            snapped
                .as_ref()
                .is_some_and(|fractions| fractions[k] != numbers[k].value)
        };
        let units = std::array::from_fn(|k| {
            if is_snapped(k) {
                Rational::from(0)
            } else {
                numbers[k].unit.clone()
            }
        });
        let uncertainties = std::array::from_fn(|k| {
            let su = numbers[k].uncertainty.as_ref();
            su.cloned().unwrap_or_default()
        });
        let line = self.line(row);
        if texts.iter().any(|text| text.contains('\u{fffd}')) || label.contains('\u{fffd}') {
            return Err(at_line(line, "has bytes that are not UTF-8 text"));
        }
        Ok(Site {
            label,
            element,
            line,
            position: snapped.unwrap_or_else(|| <[Rational; 3]>::clone(&written)),
            units,
            uncertainties,
            written,
            multiplicity,
        })
    }
}

fn coordinate(value: &Value, axis: &str, label: &str) -> Result<Decimal, ImportError> {
    let wrong = |problem: String| at_line(value.line, format!("{axis} of site {label}: {problem}"));
    if value.is_missing() {
        return Err(wrong(format!(
            "is not known ({}); leave the site out with --except",
            value.text
        )));
    }
    Decimal::parse(value.text).map_err(wrong)
}

/// The coordinates with all decimals replaced that stand for multiples of 1/n. If one
/// of them might, but has too few digits, none is replaced: coordinates of a site belong together.
fn snapped(
    numbers: &[Decimal],
    texts: &[&str],
    label: &str,
    n: u32,
    notes: &mut Vec<String>,
) -> Option<[Rational; 3]> {
    let results: Vec<Snapped> = numbers.iter().map(|number| number.snap(n)).collect();
    let axes = ["x", "y", "z"];
    if let Some(k) = results.iter().position(|result| *result == Snapped::Short) {
        notes.push(format!(
            "{label}: the site is kept as it is written, since {} = {} has too few digits for one multiple of 1/{n}",
            axes[k], texts[k]
        ));
        return None;
    }
    let mut position: [Rational; 3] = std::array::from_fn(|k| numbers[k].value.clone());
    for (k, result) in results.into_iter().enumerate() {
        if let Snapped::To(fraction) = result {
            notes.push(format!(
                "{label}: {} = {} replaced by {fraction}",
                axes[k], texts[k]
            ));
            position[k] = fraction;
        }
    }
    Some(position)
}
