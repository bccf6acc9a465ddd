//! The symmetry of a data block: its list of operations, checked against each other and
//! against what else the file says of its space group.
//!
//! A list that is cut short gives a wrong atom count without any other sign, so it is
//! refused: the list must be a group, its point group must have the order that the number of
//! the space group asks for, and its centring must be that of the symbol.

use super::block::{Block, Column};
use super::operation::{NotAGroup, OPERATION_LIMIT, Operation, Rotation, check_group};
use super::token::{Value, at_line, short};
use crate::import::ImportError;
use std::collections::HashSet;

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
const SYMBOLS: [&str; 4] = [
    "_space_group_name_h-m_alt",
    "_symmetry_space_group_name_h-m",
    "_space_group_name_h-m_full",
    "_space_group_name_h-m_ref",
];
const HALL: [&str; 2] = ["_space_group_name_hall", "_symmetry_space_group_name_hall"];
const IDENTITY: [[i64; 3]; 3] = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];

/// An operation and the line where it stands.
pub struct Listed {
    pub operation: Operation,
    pub line: u32,
    /// As it is written.
    pub text: String,
}

/// The operations of a block; decimals in them are snapped where a denominator is given.
///
/// # Errors
/// They are missing, no group, or not those of the space group that the block names.
pub fn operations(block: &Block, snap: Option<u32>) -> Result<Vec<Listed>, ImportError> {
    let number = space_group_number(block)?;
    let symbol = block.value(&SYMBOLS)?;
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
        return without_list(block, number, symbol);
    };
    check_list(&list)?;
    if let Some(number) = number {
        check_point_group(&list, number)?;
    }
    if let Some(symbol) = symbol {
        check_centring(&list, symbol)?;
    }
    Ok(list)
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
        let mut line = value.line;
        for text in value.text.split(['\n', '\r', ';']) {
            let part = Value { text: text.trim(), line, ..value };
            line += 1;
            if part.text.is_empty() {
                continue;
            }
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
                !against.iter().any(|same| same.operation.is_same(&listed.operation))
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

/// Without a list the group must be P1.
fn without_list(
    block: &Block,
    number: Option<(u16, u32)>,
    symbol: Option<Value>,
) -> Result<Vec<Listed>, ImportError> {
    let is_p1 = |text: &str| {
        let letters: String = text.split_ascii_whitespace().collect();
        letters.eq_ignore_ascii_case("p1")
    };
    let symbol = symbol.or(block.value(&HALL)?);
    let named = symbol.map(|value| (short(value.text), value.line));
    let group = named.or(number.map(|(number, line)| (format!("number {number}"), line)));
    let is_trivial = match (number, symbol) {
        (Some((number, _)), symbol) => number == 1 && symbol.is_none_or(|value| is_p1(value.text)),
        (None, symbol) => symbol.is_some_and(|value| is_p1(value.text)),
    };
    if is_trivial {
        let operation = Operation::parse("x,y,z", None)
            .map_err(|problem| ImportError::entry("x,y,z", problem))?;
        let line = group.map_or(1, |(_, line)| line);
        return Ok(vec![Listed {
            operation,
            line,
            text: "x,y,z".to_owned(),
        }]);
    }
    let add = "add a loop_ with _space_group_symop_operation_xyz and all operations ('x,y,z' alone for P1)";
    Err(match group {
        Some((group, line)) => at_line(
            line,
            format!(
                "the space group is {group}, and its symmetry operations are not listed: {add}"
            ),
        ),
        None => ImportError::entry(
            format!("data_{}", block.name),
            format!("no symmetry operations: {add}"),
        ),
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

/// The order of the point group of a space group, by its number (International Tables A).
fn point_group_order(number: u16) -> usize {
    const LAST: [(u16, usize); 32] = [
        (1, 1),
        (2, 2),
        (5, 2),
        (9, 2),
        (15, 4),
        (24, 4),
        (46, 4),
        (74, 8),
        (80, 4),
        (82, 4),
        (88, 8),
        (98, 8),
        (110, 8),
        (122, 8),
        (142, 16),
        (146, 3),
        (148, 6),
        (155, 6),
        (161, 6),
        (167, 12),
        (173, 6),
        (174, 6),
        (176, 12),
        (182, 12),
        (186, 12),
        (190, 12),
        (194, 24),
        (199, 12),
        (206, 24),
        (214, 24),
        (220, 24),
        (230, 48),
    ];
    LAST.iter()
        .find(|(last, _)| number <= *last)
        .map_or(48, |&(_, order)| order)
}

fn check_point_group(list: &[Listed], (number, line): (u16, u32)) -> Result<(), ImportError> {
    let rotations: HashSet<&Rotation> = list.iter().map(|l| &l.operation.rotation).collect();
    let (found, expected) = (rotations.len(), point_group_order(number));
    match found == expected {
        true => Ok(()),
        false => Err(at_line(
            line,
            format!(
                "space group {number} has a point group of order {expected}, but the listed operations have {found} different \
             rotations: complete the list, or remove the number if the list is right"
            ),
        )),
    }
}

/// The lattice points in a cell, by the first letter of the Hermann-Mauguin symbol.
fn check_centring(list: &[Listed], symbol: Value) -> Result<(), ImportError> {
    let letter = symbol
        .text
        .chars()
        .next()
        .unwrap_or(' ')
        .to_ascii_uppercase();
    let expected: &[usize] = match letter {
        'P' => &[1],
        'A' | 'B' | 'C' | 'I' => &[2],
        'F' => &[4],
        'R' => &[1, 3],
        _ => return Ok(()),
    };
    let found = list
        .iter()
        .filter(|l| l.operation.rotation == IDENTITY)
        .count();
    match expected.contains(&found) {
        true => Ok(()),
        false => Err(at_line(
            symbol.line,
            format!(
                "{} has {} lattice points in a cell, but the listed operations have {found} translations: complete the list, or \
             remove the symbol if the list is right",
                short(symbol.text),
                expected
                    .iter()
                    .map(usize::to_string)
                    .collect::<Vec<_>>()
                    .join(" or "),
            ),
        )),
    }
}
