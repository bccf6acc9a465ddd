//! The statements of a block about its space group besides the list of operations: Hall symbol,
//! Hermann-Mauguin symbols and number. All must agree with the list, or they replace it.
//!
//! A Hermann-Mauguin symbol without an origin choice says nothing of the origin. So the list may
//! differ from the tables by a shift of the origin. A Hall symbol and a symbol with a choice say it all.

use super::block::Block;
use super::cell::Cell;
use super::fit;
use super::operation::Listed;
use super::operation::Operation;
use super::token::{Value, at_line};
use crate::import::ImportError;
use crate::import::words::short;
use acutile_core::statement::counted;
use acutile_crystal::hall;
use acutile_crystal::identify::{differ_by_origin, identify};
use acutile_crystal::motion::{Motion, fractional};
use acutile_crystal::setting::{Setting, of_number, of_symbol};

const SYMBOLS: [&str; 4] = [
    "_space_group_name_h-m_alt",
    "_symmetry_space_group_name_h-m",
    "_space_group_name_h-m_full",
    "_space_group_name_h-m_ref",
];
const HALL: [&str; 2] = ["_space_group_name_hall", "_symmetry_space_group_name_hall"];

/// The names of the space group in a block.
pub struct Names<'t> {
    pub number: Option<(u16, u32)>,
    pub symbols: Vec<Value<'t>>,
    pub hall: Option<Value<'t>>,
}

impl<'t> Names<'t> {
    /// The names that the block knows.
    pub fn of(block: &Block<'t>, number: Option<(u16, u32)>) -> Result<Self, ImportError> {
        let is_name = |value: &Value| !value.text.trim().is_empty();
        let mut symbols = Vec::new();
        for tag in SYMBOLS {
            symbols.extend(block.value(&[tag])?.filter(is_name));
        }
        Ok(Names {
            number,
            symbols,
            hall: block.value(&HALL)?.filter(is_name),
        })
    }

    /// Notes on names that cannot be compared with the list.
    ///
    /// # Errors
    /// A name that does not agree with the list.
    pub fn check(&self, list: &[Listed], cell: &Cell) -> Result<Vec<String>, ImportError> {
        let group = motions(list);
        let mut notes = Vec::new();
        if let Some(value) = self.hall {
            match hall::group(value.text) {
                Ok(named) if named == group => {}
                Ok(named) => {
                    let found = found_words(&group, cell);
                    return Err(disagreement(
                        "Hall symbol",
                        value,
                        &[named.len()],
                        list,
                        &found,
                    ));
                }
                Err(problem) => notes.push(format!(
                    "the Hall symbol {} is not compared with the operations: it {problem}",
                    short(value.text)
                )),
            }
        }
        for &value in &self.symbols {
            notes.extend(check_symbol(value, &group, list, cell)?);
        }
        if let Some((number, line)) = self.number {
            check_number(number, line, &group, list, cell)?;
        }
        Ok(notes)
    }

    /// The operations of the tables for these names, and a note that says so.
    ///
    /// # Errors
    /// No name, an unknown one, names that contradict each other, or several possible settings.
    pub fn tabulated(
        &self,
        cell: &Cell,
        block: &Block,
    ) -> Result<(Vec<Listed>, Vec<String>), ImportError> {
        let Some((line, words)) = self.words() else {
            let place = format!("data_{}", block.name);
            return Err(ImportError::entry(place, NO_NAME));
        };
        let mut candidates = self.settings()?;
        if let Some(value) = self.hall
            && let Ok(group) = hall::group(value.text)
        {
            let named = candidates.as_ref();
            let is_known = |settings: &Vec<&Setting>| {
                settings
                    .iter()
                    .any(|setting| is_same_group(setting, &group))
            };
            if named.is_some_and(|settings| !is_known(settings)) {
                let problem = format!(
                    "the Hall symbol {} contradicts the space group {words}",
                    short(value.text)
                );
                return Err(at_line(value.line, problem));
            }
            let note = format!(
                "the operations are those of the Hall symbol {}",
                short(value.text)
            );
            return Ok((listed(group, line), vec![note]));
        }
        let Some(settings) = candidates.take() else {
            let problem = format!(
                "the space group is {words}, which is in no table of settings, and its symmetry operations are not listed: {ADVICE}"
            );
            return Err(at_line(line, problem));
        };
        let (setting, group) = the_only_one(settings, cell, line, &words)?;
        if setting.number == 1 {
            return Ok((listed(group, line), Vec::new()));
        }
        let note = format!(
            "the operations are not listed; those of {} (Hall symbol {}) are taken from the tables",
            setting.name(),
            setting.hall
        );
        Ok((listed(group, line), vec![note]))
    }

    /// The first name, for a message.
    fn words(&self) -> Option<(u32, String)> {
        let value = self.symbols.first().or(self.hall.as_ref());
        let named = value.map(|value| (value.line, short(value.text)));
        named.or(self
            .number
            .map(|(number, line)| (line, format!("number {number}"))))
    }

    /// The settings that all known symbols and the number allow; `None` if nothing is known.
    fn settings(&self) -> Result<Option<Vec<&'static Setting>>, ImportError> {
        let mut settings: Option<Vec<&'static Setting>> =
            self.number.map(|(number, _)| of_number(number));
        for value in &self.symbols {
            let found = of_symbol(value.text).settings;
            if found.is_empty() {
                continue;
            }
            let both = match settings {
                None => found,
                Some(before) => {
                    let is_in =
                        |setting: &&Setting| before.iter().any(|b| b.index == setting.index);
                    found.into_iter().filter(|setting| is_in(setting)).collect()
                }
            };
            if both.is_empty() {
                let problem = format!(
                    "the symbol {} contradicts the other names of the space group in the block",
                    short(value.text)
                );
                return Err(at_line(value.line, problem));
            }
            settings = Some(both);
        }
        let is_number_alone = self
            .symbols
            .iter()
            .all(|value| of_symbol(value.text).settings.is_empty());
        Ok(settings.filter(|_| !is_number_alone || self.symbols.is_empty()))
    }
}

pub const ADVICE: &str =
    "add a loop_ with _space_group_symop_operation_xyz and all operations ('x,y,z' alone for P1)";
const NO_NAME: &str = "no symmetry operations and no space group: add a loop_ with _space_group_symop_operation_xyz and all operations ('x,y,z' alone for P1)";

/// The sorted motions of a list.
fn motions(list: &[Listed]) -> Vec<Motion> {
    let mut group: Vec<Motion> = list
        .iter()
        .map(|listed| Motion {
            rotation: listed.operation.rotation,
            translation: listed.operation.translation.clone().map(fractional),
        })
        .collect();
    group.sort();
    group.dedup();
    group
}

fn is_same_group(setting: &Setting, group: &[Motion]) -> bool {
    setting.group().is_ok_and(|own| own == group)
}

/// The type of a group, for a message.
fn found_words(group: &[Motion], cell: &Cell) -> String {
    identify(group, &cell.gram).map_or_else(String::new, |found| {
        format!(
            ", those of number {}, {}",
            found.setting.number, found.setting.short
        )
    })
}

fn disagreement(
    what: &str,
    value: Value,
    counts: &[usize],
    list: &[Listed],
    found: &str,
) -> ImportError {
    let mut counts = counts.to_vec();
    counts.sort_unstable();
    counts.dedup();
    let is_one = counts == [1];
    let counts: Vec<String> = counts.iter().map(usize::to_string).collect();
    let problem = format!(
        "the {what} {} does not agree with the listed operations: it stands for {} {}, and {} at line {}{found}; \
         complete the list, or remove the symbol or the list, whichever is wrong",
        short(value.text),
        counts.join(" or "),
        if is_one { "operation" } else { "operations" },
        counted(list.len(), "is listed", "are listed"),
        list.first().map_or(0, |listed| listed.line)
    );
    at_line(value.line, problem)
}

fn check_symbol(
    value: Value,
    group: &[Motion],
    list: &[Listed],
    cell: &Cell,
) -> Result<Option<String>, ImportError> {
    let found = of_symbol(value.text);
    if found.settings.is_empty() {
        return Ok(Some(format!(
            "the symbol {} is in no table of settings, and is not compared with the operations",
            short(value.text)
        )));
    }
    let agrees = |setting: &&Setting| {
        is_same_group(setting, group) || !found.is_fixed && is_moved(setting, group, cell)
    };
    if found.settings.iter().any(agrees) {
        return Ok(None);
    }
    let counts: Vec<usize> = found
        .settings
        .iter()
        .filter_map(|setting| setting.group().ok())
        .map(|group| group.len())
        .collect();
    let words = found_words(group, cell);
    Err(disagreement("symbol", value, &counts, list, &words))
}

/// Whether a group is that of a setting with another origin. If its translations are odd, its type
/// and its rotations decide.
fn is_moved(setting: &Setting, group: &[Motion], cell: &Cell) -> bool {
    let Ok(own) = setting.group() else {
        return false;
    };
    let is_same = |(a, b): (&Motion, &Motion)| a.rotation == b.rotation;
    if own.len() != group.len() || !own.iter().zip(group).all(is_same) {
        return false;
    }
    match differ_by_origin(group, &own) {
        // A threefold axis may stand at ninths.
        Some(false) if (143..=194).contains(&setting.number) => {
            has_number(setting.number, group, cell)
        }
        Some(answer) => answer,
        None => has_number(setting.number, group, cell),
    }
}

fn has_number(number: u16, group: &[Motion], cell: &Cell) -> bool {
    identify(group, &cell.gram).is_some_and(|found| found.setting.number == number)
}

fn check_number(
    number: u16,
    line: u32,
    group: &[Motion],
    list: &[Listed],
    cell: &Cell,
) -> Result<(), ImportError> {
    let settings = of_number(number);
    if settings.iter().any(|setting| is_same_group(setting, group)) {
        return Ok(());
    }
    match identify(group, &cell.gram) {
        Some(found) if found.setting.number == number => Ok(()),
        found => {
            let words = found.map_or_else(
                || "another group".to_owned(),
                |found| format!("number {}, {}", found.setting.number, found.setting.short),
            );
            let problem = format!(
                "space group {number} does not agree with the {} at line {}, of {words}: \
                 complete the list, or remove the number if the list is right",
                counted(list.len(), "listed operation", "listed operations"),
                list.first().map_or(0, |listed| listed.line)
            );
            Err(at_line(line, problem))
        }
    }
}

/// The settings whose rotations fit the cell, if they all have the same operations.
fn the_only_one(
    settings: Vec<&'static Setting>,
    cell: &Cell,
    line: u32,
    words: &str,
) -> Result<(&'static Setting, Vec<Motion>), ImportError> {
    let mut fitting: Vec<(&Setting, Vec<Motion>)> = Vec::new();
    for setting in settings {
        let Ok(group) = setting.group() else {
            continue;
        };
        let is_new = fitting.iter().all(|(_, other)| *other != group);
        if is_new && fit::fits(cell, &listed(group.clone(), line)) {
            fitting.push((setting, group));
        }
    }
    // A short monoclinic symbol means the unique axis b, if the cell allows it.
    let is_monoclinic = fitting
        .iter()
        .all(|(setting, _)| (3..=15).contains(&setting.number));
    let is_b = |setting: &Setting| setting.choice.starts_with('b');
    if is_monoclinic && fitting.iter().filter(|(setting, _)| is_b(setting)).count() == 1 {
        fitting.retain(|(setting, _)| is_b(setting));
    }
    let names: Vec<String> = fitting
        .iter()
        .map(|(setting, _)| format!("{} (Hall symbol {})", setting.name(), setting.hall))
        .collect();
    let count = fitting.len();
    match (fitting.pop(), count) {
        (Some(only), 1) => Ok(only),
        (None, _) => Err(at_line(
            line,
            format!(
                "the space group {words} has no setting that fits the cell, and its symmetry operations are not listed: {ADVICE}"
            ),
        )),
        (Some(_), _) => Err(at_line(
            line,
            format!(
                "the space group {words} has {count} settings that fit the cell, and its symmetry operations are not listed: \
                 write one of {} as _space_group_name_Hall, or list the operations",
                names.join(", ")
            ),
        )),
    }
}

fn listed(group: Vec<Motion>, line: u32) -> Vec<Listed> {
    let one = |motion: Motion| Listed {
        text: text(&motion),
        line,
        operation: Operation {
            rotation: motion.rotation,
            translation: motion.translation,
            replaced: Vec::new(),
            is_rounded: false,
        },
    };
    group.into_iter().map(one).collect()
}

/// `-y+1/2,x-y,z`
fn text(motion: &Motion) -> String {
    let row = |k: usize| {
        let mut text = String::new();
        for (entry, axis) in motion.rotation[k].iter().zip(["x", "y", "z"]) {
            match entry {
                0 => {}
                1 if text.is_empty() => text.push_str(axis),
                1 => text.push_str(&format!("+{axis}")),
                _ => text.push_str(&format!("-{axis}")),
            }
        }
        if motion.translation[k] != 0 {
            text.push_str(&format!("+{}", motion.translation[k]));
        }
        text
    };
    [row(0), row(1), row(2)].join(",")
}
