//! Hall symbols and Hermann-Mauguin symbols against gemmi's tables (tests/make.py).

use acutile_crystal::motion::{Motion, fractional};
use acutile_crystal::{hall, setting};
use malachite::Rational;
use std::collections::HashSet;

/// A line of gemmi's tables.
struct Row {
    number: u16,
    symbol: String,
    hall: String,
    count: usize,
    hash: u64,
}

fn rows() -> Vec<Row> {
    let lines = include_str!("settings.tsv").lines();
    lines
        .map(|line| {
            let fields: Vec<&str> = line.split('\t').collect();
            Row {
                number: fields[0].parse().expect("a number"),
                symbol: fields[1].to_owned(),
                hall: fields[2].to_owned(),
                count: fields[3].parse().expect("a count"),
                hash: fields[4].parse().expect("a hash"),
            }
        })
        .collect()
}

/// The sum of a code of each operation, as make.py computes it.
fn hash(group: &[Motion]) -> u64 {
    let modulus = 1u128 << 63;
    let code = |motion: &Motion| {
        let translations = motion.translation.iter().map(|t| {
            let scaled = fractional(t.clone()) * Rational::from(24);
            i128::try_from(&malachite::Integer::try_from(scaled).expect("24ths")).expect("small")
        });
        let entries = motion
            .rotation
            .iter()
            .flatten()
            .map(|&entry| i128::from(entry));
        entries.chain(translations).fold(0u128, |value, entry| {
            let next = value as i128 * 1_000_003 + entry + 7;
            next.rem_euclid(modulus as i128) as u128
        })
    };
    (group.iter().map(code).sum::<u128>() % modulus) as u64
}

#[test]
fn hall_symbols_give_the_groups_of_gemmi() {
    let rows = rows();
    assert_eq!(rows.len(), 564);
    for row in rows {
        let group = hall::group(&row.hall).unwrap_or_else(|error| panic!("{}: {error}", row.hall));
        assert_eq!(
            (group.len(), hash(&group)),
            (row.count, row.hash),
            "{}",
            row.hall
        );
    }
}

/// Hall symbols with changes of basis, as gemmi has them. A symbol is refused if the new basis vectors are
/// no lattice vectors, or rotations are not integral; make.py decides this.
#[test]
fn changes_of_basis_give_the_groups_of_gemmi() {
    let (mut equal, mut refused, mut finer) = (0, 0, Vec::new());
    for line in include_str!("changes.tsv").lines() {
        let (symbol, expected) = line.split_once('\t').expect("two fields");
        // gemmi has translations in 24ths only.
        let is_fine = |motion: &Motion| {
            let translations = motion.translation.iter();
            let scaled = translations.map(|t| t * Rational::from(24));
            scaled.into_iter().any(|t| *t.denominator_ref() != 1u32)
        };
        match hall::group(symbol) {
            Ok(group) if group.iter().any(is_fine) => finer.push(symbol),
            Ok(group) => {
                let found = format!("{}\t{}", group.len(), hash(&group));
                assert_eq!(found, expected, "{symbol}");
                equal += 1;
            }
            Err(error) => {
                assert_eq!(expected, "none", "{symbol}: {error}");
                refused += 1;
            }
        }
    }
    // This one has translations in ninths.
    let ninths = "R 3 (2/3*x-1/3*y-1/3*z,1/3*x+1/3*y-2/3*z,1/3*x+1/3*y+1/3*z)";
    assert_eq!((equal, refused, finer), (76, 63, vec![ninths]));
}

/// Every symbol of gemmi's lines stands for a setting with gemmi's operations.
#[test]
fn symbols_stand_for_the_groups_of_gemmi() {
    let mut known = HashSet::new();
    for row in rows() {
        let found = setting::of_symbol(&row.symbol);
        let hashes: Vec<u64> = found
            .settings
            .iter()
            .map(|setting| hash(&setting.group().expect("a group")))
            .collect();
        assert!(
            hashes.contains(&row.hash),
            "{}: {:?}",
            row.symbol,
            found.settings
        );
        // An origin choice, or the old name of a glide, leaves one group.
        let is_one = row.symbol.contains(':') || row.number == 67;
        assert!(
            !is_one || hashes.iter().all(|hash| *hash == row.hash),
            "{}: {:?}",
            row.symbol,
            found.settings
        );
        assert!(
            found.settings.iter().all(|s| s.number == row.number),
            "{}",
            row.symbol
        );
        known.insert(row.hash);
    }
    assert_eq!(setting::settings().len(), 564);
    let all: HashSet<u64> = setting::settings()
        .iter()
        .map(|setting| hash(&setting.group().expect("a group")))
        .collect();
    assert_eq!(all, known);
}

#[test]
fn spellings_of_symbols() {
    let numbers = |symbol: &str| {
        let found = setting::of_symbol(symbol).settings;
        found
            .iter()
            .map(|s| (s.number, s.choice))
            .collect::<Vec<_>>()
    };
    for (symbol, expected) in [
        ("P m -3 n", vec![(223, "")]),
        ("Pm-3n", vec![(223, "")]),
        ("Pm3n", vec![(223, "")]),
        ("P m 3 n", vec![(223, "")]),
        ("F 4/m -3 2/m", vec![(225, "")]),
        ("F d -3 m", vec![(227, "1"), (227, "2")]),
        ("Fd3m:2", vec![(227, "2")]),
        ("F d -3 m Z", vec![(227, "2")]),
        ("F d -3 m S", vec![(227, "1")]),
        ("F d -3 m (origin choice 2)", vec![(227, "2")]),
        ("R -3 c", vec![(167, "H"), (167, "R")]),
        ("R -3 c :H", vec![(167, "H")]),
        ("R -3 c R", vec![(167, "R")]),
        ("C m c a", vec![(64, "")]),
        ("A b a 2", vec![(41, "")]),
        ("P 1 21/c 1", vec![(14, "b1")]),
        ("P 21/c", vec![(14, "b1"), (14, "a3")]),
        ("P2(1)/n", vec![(14, "b2"), (14, "c2"), (14, "a2")]),
        ("P n m a", vec![(62, "")]),
        ("P b n m", vec![(62, "cab")]),
        ("P 63/m m c", vec![(194, "")]),
        ("X 1", vec![]),
        ("", vec![]),
    ] {
        assert_eq!(numbers(symbol), expected, "{symbol}");
    }
}

#[test]
fn texts_that_are_no_hall_symbols() {
    for text in [
        "",
        "Q 2",
        "P 5",
        "P 2q",
        "P 4'",
        "P 2 (0 0",
        "P 2 (x,x,y)",
        "P 2 (x,2z,y)",
        "P 2 (x,y)",
        "P 2 (x y,z,y)",
        "P 2 (x,y,z/0)",
        "P 2 (x,,z)",
        "P 2 (x+,y,z)",
        "P 2 (1/3x,y,z+99999999999999)",
        "P 2 (1 2)",
        &"P 2 ".repeat(30),
    ] {
        assert!(hall::group(text).is_err(), "{text}");
    }
    assert_eq!(hall::group("P 2 (x,z,y)"), hall::group("P 2y"));
    // ITB table A1.4.2.7: the origin of P 2ac (0 0 -1) does not matter along its axis.
    assert_eq!(hall::group("P 2c (0 0 -1)"), hall::group("P 2c"));
    assert_eq!(hall::group("-P 2 (0 0 3)").map(|group| group.len()), Ok(4));
    assert_eq!(hall::group("-P 2 (x,y,z+1/4)"), hall::group("-P 2 (0 0 3)"));
}
