//! The symmetry of a data block: its list of operations. They are checked against each other and
//! against the other statements of the file about its space group.
//!
//! A list that is cut short gives a wrong atom count without any other sign, so it is refused.
//! The list must be a group, and that of every name of the space group (see [`super::groups`]).

use super::block::{Block, Column};
use super::cell::Cell;
use super::groups::Names;
use super::operation::{Listed, NotAGroup, OPERATION_LIMIT, Operation, check_group};
use super::token::{Value, at_line};
use crate::import::ImportError;
use crate::import::words::short;

const OPERATIONS: [&str; 4] = [
    "_space_group_symop_operation_xyz",
    "_symmetry_equiv_pos_as_xyz",
    "_symmetry_equiv_position_as_xyz",
    "_symmetry_equiv_as_xyz",
];
const NUMBERS: [&str; 3] = [
    "_space_group_it_number",
    "_symmetry_int_tables_number",
    "_symmetry_space_group_it_number",
];

/// The operations of a block; decimals in them are snapped where a denominator is given.
///
/// # Errors
/// They are missing, no group, or not those of the space group that the block names.
pub fn operations(
    block: &Block,
    snap: Option<u32>,
    cell: &Cell,
) -> Result<(Vec<Listed>, Vec<String>), ImportError> {
    let names = Names::of(block, space_group_number(block)?)?;
    let mut lists = Vec::new();
    for tag in OPERATIONS {
        if let Some(column) = block.exact(tag) {
            let list = list(column, snap)?;
            if !list.is_empty() {
                lists.push(list);
            }
        }
    }
    check_same(&lists)?;
    let Some(list) = lists.into_iter().next() else {
        return names.tabulated(cell, block);
    };
    check_list(&list)?;
    let notes = names.check(&list, cell)?;
    Ok((list, notes))
}

/// Whether a block has a list of operations.
pub fn has_operations(block: &Block) -> bool {
    block.column(&OPERATIONS).is_some()
}

/// The operations of a column. A value may have several, one on each line; the identity may
/// be repeated.
fn list(column: Column, snap: Option<u32>) -> Result<Vec<Listed>, ImportError> {
    let mut list: Vec<Listed> = Vec::new();
    let mut has_identity = false;
    for value in column.values().filter(|value| !value.is_missing()) {
        let rows = (value.line..).zip(value.text.split('\n'));
        let parts = rows.flat_map(|(line, row)| {
            row.split(['\r', ';']).map(move |text| Value {
                text: text.trim(),
                line,
                ..value
            })
        });
        for part in parts.filter(|part| !part.text.is_empty()) {
            let listed = read(part, snap)?;
            let is_repeated = has_identity && listed.operation.is_identity();
            has_identity |= listed.operation.is_identity();
            if !is_repeated {
                list.push(listed);
            }
        }
        if list.len() > OPERATION_LIMIT {
            let problem = format!(
                "{} symmetry operations, the limit is {OPERATION_LIMIT}",
                column.len().max(list.len())
            );
            return Err(ImportError::limit(format!("line {}", value.line), problem));
        }
    }
    Ok(list)
}

/// Lists under different tags must have the same operations.
fn check_same(lists: &[Vec<Listed>]) -> Result<(), ImportError> {
    let Some((first, others)) = lists.split_first() else {
        return Ok(());
    };
    for other in others {
        for (list, against) in [(first, other), (other, first)] {
            let missing = list.iter().find(|listed| {
                !against
                    .iter()
                    .any(|same| same.operation.is_same(&listed.operation))
            });
            if let Some(listed) = missing {
                let problem = format!(
                    "the block has two lists of symmetry operations that differ: {} is not in the list at line {}; remove the wrong list",
                    short(&listed.text),
                    against[0].line
                );
                return Err(at_line(listed.line, problem));
            }
        }
    }
    Ok(())
}

fn read(value: Value, snap: Option<u32>) -> Result<Listed, ImportError> {
    let operation = Operation::parse(value.text, snap).map_err(|problem| {
        at_line(
            value.line,
            format!("the symmetry operation {} {problem}", short(value.text)),
        )
    })?;
    Ok(Listed {
        operation,
        line: value.line,
        text: value.text.to_owned(),
    })
}

fn space_group_number(block: &Block) -> Result<Option<(u16, u32)>, ImportError> {
    let Some(value) = block.value(&NUMBERS)? else {
        return Ok(None);
    };
    match value.text.trim().parse() {
        // Programs write 0 for "not known".
        Ok(0) => Ok(None),
        Ok(number @ 1..=230) => Ok(Some((number, value.line))),
        _ => Err(at_line(
            value.line,
            format!(
                "found {}, expected the number of a space group, 1 to 230",
                short(value.text)
            ),
        )),
    }
}

fn check_list(list: &[Listed]) -> Result<(), ImportError> {
    let operations: Vec<Operation> = list.iter().map(|l| l.operation.clone()).collect();
    let text = |k: usize| short(&list[k].text);
    let rounded = list.iter().find(|l| l.operation.is_rounded);
    let hint = rounded.map_or_else(String::new, |l| {
        format!(
            "; {} has a rounded decimal, which --snap 12 replaces",
            short(&l.text)
        )
    });
    match check_group(&operations) {
        Ok(()) => Ok(()),
        Err(NotAGroup::Repeated(a, b)) => {
            let problem = format!(
                "the symmetry operation {} is that of line {} again",
                text(b),
                list[a].line
            );
            Err(at_line(list[b].line, problem))
        }
        Err(NotAGroup::Product(a, b)) => {
            let problem = format!(
                "the symmetry operations are no group: {} after {} (line {}) is not listed{hint}",
                text(a),
                text(b),
                list[b].line
            );
            Err(at_line(list[a].line, problem))
        }
        Err(NotAGroup::Denominator) => {
            let problem = format!(
                "the symmetry operations' translations have no common denominator below 2^31{hint}"
            );
            Err(at_line(list[0].line, problem))
        }
    }
}
