//! Tests inside of the crate: the program's checks, each left out once.

// The lints of the kernel are not for its tests.
#![allow(
    clippy::as_conversions,
    clippy::expect_used,
    clippy::float_arithmetic,
    clippy::indexing_slicing,
    clippy::panic,
    clippy::unwrap_used
)]

#[path = "../common/mod.rs"]
mod common;
mod family;
mod filter;
mod oracle;
mod region;

use crate::limits::Limits;
use std::cell::Cell;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::panic::catch_unwind;
use std::path::Path;

/// A check: the file and the line of its `ensure!` or `some!`.
type Site = (&'static str, u32);

thread_local! {
    static LEFT_OUT: Cell<Option<Site>> = const { Cell::new(None) };
    /// The last check that failed.
    static FAILED: Cell<Option<Site>> = const { Cell::new(None) };
}

pub(crate) fn is_left_out(file: &'static str, line: u32) -> bool {
    FAILED.set(Some((file, line)));
    LEFT_OUT.get() == Some((file, line))
}

/// The code, the place and the value, or `verified`, or `panic`.
fn answer(cbor: &[u8], limits: &Limits) -> String {
    let found = catch_unwind(|| match crate::verify(&mut &cbor[..], limits) {
        Ok(_) => "verified".to_owned(),
        Err(refusal) => format!("{:?}", (refusal.code, refusal.place, refusal.value)),
    });
    found.unwrap_or_else(|_| "panic".into())
}

fn limits(file: &common::File) -> Limits {
    let mut limits = Limits { work: 100_000_000, ..Limits::DEFAULT };
    match file.limit() {
        Some(("bytes", value)) => limits.bytes = value,
        Some(("simplices", value)) => limits.simplices = value,
        Some(("work", value)) => limits.work = value,
        Some(("bits", value)) => limits.bits = value,
        _ => {}
    }
    limits
}

/// Parts of the checks that need no file: a broken pipe (see tests/kernel.rs), more than 2^32
/// vertices, a region of more than 2^18 periods.
const WITHOUT_FILE: [&str; 3] = ["Unreadable", "self.count < u32::MAX", "some!(small, Work"];

/// The lines of the source with a check.
fn sites() -> BTreeMap<(String, u32), String> {
    let mut sites = BTreeMap::new();
    for entry in fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("src")).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_str().unwrap().to_owned();
        if name == "refusal.rs" {
            continue;
        }
        for (line, text) in (1..).zip(fs::read_to_string(&path).unwrap().lines()) {
            if text.contains("ensure!(") || text.contains("some!(") {
                sites.insert((name.clone(), line), text.trim().to_owned());
            }
        }
    }
    sites
}

/// Each check, left out, changes the answer for a file.
#[test]
fn no_check_can_be_left_out() {
    // Panics of a kernel without a check are expected.
    let hook = std::panic::take_hook();
    std::panic::set_hook(Box::new(|_| {}));
    let files = common::files();
    let mut of_site: BTreeMap<Site, Vec<usize>> = BTreeMap::new();
    for (index, file) in files.iter().enumerate() {
        FAILED.set(None);
        if answer(&file.cbor, &limits(file)) != "verified"
            && let Some(site) = FAILED.get()
        {
            of_site.entry(site).or_default().push(index);
        }
    }
    let sites = sites();
    let mut seen = BTreeSet::new();
    let mut without_effect = Vec::new();
    for (site, indices) in &of_site {
        let changes = indices.iter().any(|&index| {
            let file = &files[index];
            let before = answer(&file.cbor, &limits(file));
            LEFT_OUT.set(Some(*site));
            let after = answer(&file.cbor, &limits(file));
            LEFT_OUT.set(None);
            before != after
        });
        let name = Path::new(site.0).file_name().unwrap().to_str().unwrap().to_owned();
        let site = (name, site.1);
        // Without a content the default of its type goes on, and may fail in the same way.
        if !changes && !sites.get(&site).is_some_and(|text| text.contains("some!(")) {
            without_effect.push(site.clone());
        }
        seen.insert(site);
    }
    std::panic::set_hook(hook);
    let is_without_file = |text: &str| WITHOUT_FILE.iter().any(|part| text.contains(part));
    let unseen = sites.iter().filter(|(site, text)| !seen.contains(*site) && !is_without_file(text));
    let unseen: Vec<_> = unseen.collect();
    let is_right = without_effect.is_empty() && unseen.is_empty();
    assert!(is_right, "without effect: {without_effect:?}; no file fails at {unseen:?}");
}
