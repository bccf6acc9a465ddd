//! Sites that are no atoms, or only some of the time: dummies, occupancies, disorder groups,
//! mixtures. A point set has each atom or has it not, so most of these are refused.

use super::columns::{Table, known};
use super::token::{Value, at_line};
use crate::import::ImportError;
use crate::import::atoms::decimal::Decimal;
use crate::import::atoms::element::{self, Kind};
use crate::import::atoms::options::CifOptions;
use crate::import::words::short;
use std::collections::BTreeMap;

const ADVICE: &str = "disorder cannot be a point set; choose sites with --only or --except, or take each as an atom with --ignore-occupancy";

/// Which of the chosen sites are atoms.
///
/// # Errors
/// A chosen site is a dummy, or an atom only some of the time.
pub fn check(
    table: &Table,
    chosen: &[bool],
    labels: &[&str],
    options: &CifOptions,
    notes: &mut Vec<String>,
) -> Result<Vec<bool>, ImportError> {
    let mut taken = chosen.to_vec();
    let mut empty = Vec::new();
    for (row, label) in labels.iter().enumerate().filter(|(row, _)| chosen[*row]) {
        check_dummy(table, row, label)?;
        if !is_occupied(table, row, label, options)? {
            taken[row] = false;
            empty.push(*label);
        }
        notes.extend(check_symbol(table, row, label, options)?);
    }
    if !empty.is_empty() {
        let words = empty.join(", ");
        notes.push(format!("left out, the occupancy is zero: {words}"));
    }
    if !options.ignore_occupancy {
        check_groups(table, &taken, labels)?;
    }
    Ok(taken)
}

fn wrong(value: &Value, label: &str, problem: impl std::fmt::Display) -> ImportError {
    at_line(value.line, format!("site {label} {problem}"))
}

fn check_dummy(table: &Table, row: usize, label: &str) -> Result<(), ImportError> {
    match known(table.flag, row) {
        Some(value) if value.text.eq_ignore_ascii_case("dum") => Err(wrong(
            &value,
            label,
            "is a dummy (_atom_site_calc_flag dum), no atom: leave it out with --except",
        )),
        _ => Ok(()),
    }
}

/// False for a site of occupancy zero that --ignore-occupancy passes over.
fn is_occupied(
    table: &Table,
    row: usize,
    label: &str,
    options: &CifOptions,
) -> Result<bool, ImportError> {
    let Some(value) = known(table.occupancy, row) else {
        return Ok(true);
    };
    let occupancy = Decimal::parse(value.text).map_err(|problem| {
        let problem = format!("has an occupancy that cannot be read: {problem}");
        wrong(&value, label, problem)
    })?;
    if occupancy.value == 1 {
        return Ok(true);
    }
    if options.ignore_occupancy {
        return Ok(occupancy.value != 0);
    }
    if occupancy.value == 0 {
        let problem = "has the occupancy 0, so that it is no atom: leave it out with --except";
        return Err(wrong(&value, label, problem));
    }
    let problem = format!("has the occupancy {}: {ADVICE}", value.text);
    Err(wrong(&value, label, problem))
}

/// A mixture is refused; a group of atoms at one place is a point with a note.
fn check_symbol(
    table: &Table,
    row: usize,
    label: &str,
    options: &CifOptions,
) -> Result<Option<String>, ImportError> {
    let Some(value) = known(table.symbol, row) else {
        return Ok(None);
    };
    let symbol = short(value.text);
    match element::kind(value.text) {
        Kind::Mixture if !options.ignore_occupancy => {
            let problem =
                format!("has the type symbol {symbol}, several elements at one place: {ADVICE}");
            Err(wrong(&value, label, problem))
        }
        Kind::Mixture | Kind::Group => Ok(Some(format!(
            "warning: site {label} has the type symbol {symbol}, several atoms at one place; it is one point"
        ))),
        Kind::Element(_) | Kind::Unknown => Ok(None),
    }
}

/// Of the alternatives of one assembly at most one may be chosen.
fn check_groups(table: &Table, taken: &[bool], labels: &[&str]) -> Result<(), ImportError> {
    let mut first: BTreeMap<&str, (&str, usize)> = BTreeMap::new();
    for row in (0..taken.len()).filter(|&row| taken[row]) {
        let Some(group) = known(table.group, row).filter(|value| value.text != "0") else {
            continue;
        };
        let assembly = known(table.assembly, row).map_or("", |value| value.text);
        let &mut (other, before) = first.entry(assembly).or_insert((group.text, row));
        if other != group.text {
            let problem = format!(
                "is in disorder group {}, and site {} in group {other} of the same assembly: {ADVICE}",
                group.text, labels[before]
            );
            return Err(wrong(&group, labels[row], problem));
        }
    }
    Ok(())
}
