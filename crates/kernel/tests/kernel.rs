//! The kernel on the certificates of `tests/certificates`, on changed ones, and its program.
//! The expected verdicts come from the independent generator that wrote these files.

// The lints of the kernel are not for its tests.
#![allow(
    clippy::as_conversions,
    clippy::expect_used,
    clippy::float_arithmetic,
    clippy::indexing_slicing,
    clippy::panic,
    clippy::unwrap_used
)]

mod common;

use acutile_kernel::{Code, Kind, Limits, Refusal, Verified, verify};
use common::{File, files, folder, transcribe};
use num_bigint::BigInt;
use std::collections::BTreeSet;
use std::io::Write;
use std::process::{Command, Output, Stdio};

fn check(cbor: &[u8], limits: &Limits) -> Result<Verified, Refusal> {
    verify(&mut &cbor[..], limits)
}

fn limits(file: &File) -> Limits {
    let mut limits = Limits::DEFAULT;
    if let Some((name, value)) = file.limit() {
        match name {
            "bytes" => limits.bytes = value,
            "simplices" => limits.simplices = value,
            "bits" => limits.bits = value,
            "degree" => limits.degree = value as usize,
            "work" => limits.work = value,
            _ => panic!("{}: no limit {name}", file.name),
        }
    }
    limits
}

fn code(found: &Result<Verified, Refusal>) -> &'static str {
    found.as_ref().map_or_else(|refusal| refusal.code.text(), |_| "verified")
}

#[test]
fn each_file_gets_the_verdict_of_its_name() {
    let mut wrong = Vec::new();
    let mut count = 0;
    for file in files() {
        let found = check(&file.cbor, &limits(&file));
        let is_right = if file.is_about_json() {
            // Whoever reads JSON refuses it; here it must only be no other verdict.
            found.as_ref().map_or_else(|r| r.code.kind() != Kind::Declined, |_| true)
        } else {
            count += 1;
            code(&found) == file.code()
        };
        if !is_right {
            wrong.push(format!("{}/{}: {}", file.folder, file.name, code(&found)));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(count > 600, "{count} files");
}

#[test]
fn the_folder_tells_the_kind() {
    for file in files().iter().filter(|file| !file.is_about_json()) {
        if let Some(code) = Code::find(file.code()) {
            let expected = match file.folder {
                "false" => Kind::Rejected,
                "malformed" => Kind::Malformed,
                "declined" => Kind::Declined,
                _ => continue,
            };
            assert_eq!(code.kind(), expected, "{}", file.name);
        }
    }
}

#[test]
fn every_code_has_a_file() {
    let seen: BTreeSet<String> = files().iter().map(|file| file.code().to_owned()).collect();
    // A file that cannot be read is none.
    let missing: Vec<_> = Code::ALL.iter().map(|code| code.text()).collect();
    let missing: Vec<_> = missing.into_iter().filter(|code| !seen.contains(*code) && *code != "unreadable").collect();
    assert!(missing.is_empty(), "{missing:?}");
}

#[test]
fn the_printed_claim_is_that_of_the_json_certificate() {
    let mut count = 0;
    for file in files().iter().filter(|file| file.folder == "valid") {
        let json = file.json.as_ref().unwrap();
        let start = json.find("\"claim\":").unwrap();
        let end = json.find(",\n\"witness\":").unwrap();
        let expected = format!(
            "{{\n\"format\":\"acutile-claim\",\n\"version\":2,\n{}{}\n}}\n",
            &json[json.find("\"kind\":").unwrap()..start],
            &json[start..end]
        );
        let found = check(&file.cbor, &Limits::DEFAULT).unwrap();
        assert_eq!(found.claim.print(), expected, "{}", file.name);
        count += 1;
    }
    assert!(count > 90);
}

/// A certificate that passes under some limits passes under larger ones.
#[test]
fn limits_are_monotone_and_inclusive() {
    for file in files().iter().filter(|file| file.folder == "valid" && !file.name.contains("4096")) {
        let facts = check(&file.cbor, &Limits::DEFAULT).unwrap();
        let (bytes, simplices) = (file.cbor.len() as u64, facts.simplices);
        let with = |change: &dyn Fn(&mut Limits)| {
            let mut limits = Limits::DEFAULT;
            change(&mut limits);
            code(&check(&file.cbor, &limits))
        };
        assert_eq!(with(&|limits| limits.bytes = bytes), "verified");
        assert_eq!(with(&|limits| limits.bytes = bytes - 1), "too-many-bytes");
        assert_eq!(with(&|limits| limits.simplices = simplices), "verified");
        assert_eq!(with(&|limits| limits.simplices = simplices - 1), "too-many-simplices");
        let verdicts: Vec<_> = (0..34).map(|k| with(&|limits| limits.work = 1 << k)).collect();
        let first = verdicts.iter().position(|&verdict| verdict == "verified").unwrap();
        assert!(verdicts[..first].iter().all(|&verdict| verdict == "work"), "{verdicts:?}");
        assert!(verdicts[first..].iter().all(|&verdict| verdict == "verified"), "{verdicts:?}");
    }
}

/// Exact values that do not fit 128 bits leave the rest of the work to small numbers.
#[test]
fn long_bounds_cost_little_work() {
    let work = |name: &str| {
        let files = files();
        let file = files.iter().find(|file| file.folder == "valid" && file.name == name).unwrap();
        let suffices = |work: u64| check(&file.cbor, &Limits { work, ..Limits::DEFAULT }).is_ok();
        let (mut low, mut high) = (0, Limits::DEFAULT.work);
        while high - low > 1000 {
            let middle = low.midpoint(high);
            if suffices(middle) { high = middle } else { low = middle }
        }
        high
    };
    let (short, long) = (work("region-coordinates-of-53-bits"), work("region-coordinates-of-53-bits-all-figures"));
    assert!(long < 2 * short, "{long} and {short} units of work");
}

/// A slip in the kernel would panic, for overflow checks are on.
#[test]
fn changed_bytes_never_panic() {
    let mut seed = 1u64;
    let mut random = move || {
        seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        seed >> 33
    };
    let (mut verified, mut count) = (0, 0);
    for file in files().iter().filter(|file| file.folder == "valid" && file.cbor.len() < 4000) {
        for _ in 0..150 {
            let mut cbor = file.cbor.clone();
            for _ in 0..=random() % 2 {
                let place = random() as usize % cbor.len();
                match random() % 4 {
                    0 => cbor[place] = cbor[place].wrapping_add(1),
                    1 => cbor[place] ^= 1 << (random() % 8),
                    2 => cbor[place] = random() as u8,
                    _ => drop(cbor.remove(place)),
                }
            }
            let limits = Limits { work: 50_000_000, ..Limits::DEFAULT };
            verified += usize::from(check(&cbor, &limits).is_ok());
            count += 1;
        }
    }
    // Some changes give another true claim, like one statement less.
    assert!(verified < count / 10, "{verified} of {count}");
}

/// Triangles in a row, of each height: right, or too far from the lattice for the boxes of their facets.
#[test]
fn coordinates_far_from_the_lattice_are_verified_or_declined() {
    let path = folder().join("valid/region-plane-rank-1-triangles-in-a-row.json");
    let text = std::fs::read_to_string(path).unwrap();
    assert_eq!(text.matches("[1,2]").count(), 1);
    let verdicts: Vec<&str> = (0..100)
        .map(|bits| {
            // JSON has longer integers as texts.
            let quote = if bits < 53 { "" } else { "\"" };
            let json = text.replace("[1,2]", &format!("[1,{quote}{}{quote}]", 1u128 << bits));
            code(&check(&transcribe(json.as_bytes()).unwrap(), &Limits::DEFAULT))
        })
        .collect();
    assert!(verdicts[2..30].iter().all(|verdict| *verdict == "verified"), "{verdicts:?}");
    assert!(verdicts[30..].iter().all(|verdict| ["verified", "sign-undecided"].contains(verdict)), "{verdicts:?}");
}

/// The kite with the corners (0, 0), (2, 0), (1, a) and (1, -a), for the root a of 2^2k + 1 between 2^k and 2^k + 1.
#[test]
fn coordinates_over_a_large_root_are_verified() {
    let text = std::fs::read_to_string(folder().join("valid/region-plane-over-sqrt-3.json")).unwrap();
    // Without the statements about angles and circles.
    let (begin, end) = (text.find(",\n\"acute\"").unwrap(), text.find("\n]\n},\n\"witness\"").unwrap());
    let text = text[..begin].to_owned() + &text[end..];
    for k in [60, 64, 70, 200, 1000] {
        let power = |exponent: u32| BigInt::from(1) << exponent;
        let (square, low): (BigInt, BigInt) = (power(2 * k) + 1, power(k));
        let json = text
            .replace("[-3,0,1]", &format!("[\"-{square}\",0,1]"))
            .replace("\"low\":1,\"high\":2", &format!("\"low\":\"{low}\",\"high\":\"{}\"", &low + 1));
        assert_eq!(code(&check(&transcribe(json.as_bytes()).unwrap(), &Limits::DEFAULT)), "verified", "{k}");
    }
}

/// Many planes in a small file cost work for each of its rows.
#[test]
fn planes_have_a_price() {
    let text = std::fs::read_to_string(folder().join("valid/plane-uncrossed-lines.json")).unwrap();
    let first = "[\"uncrossed plane\",[0,1],[0,1]]";
    assert_eq!(text.matches(first).count(), 1);
    let planes: Vec<String> = (0..1000).map(|k| format!("[\"uncrossed plane\",[0,1],[{k},1]]")).collect();
    let cbor = transcribe(text.replace(first, &planes.join(",\n")).as_bytes()).unwrap();
    assert_eq!(code(&check(&cbor, &Limits::DEFAULT)), "verified");
    // Two rows, and 800 units of work for each plane.
    assert_eq!(code(&check(&cbor, &Limits { work: 1_600_000, ..Limits::DEFAULT })), "work");
}

#[test]
fn a_prefix_is_no_certificate() {
    for file in files().iter().filter(|file| file.folder == "valid").step_by(7) {
        for length in 0..file.cbor.len().min(600) {
            assert_eq!(code(&check(&file.cbor[..length], &Limits::DEFAULT)), "cbor");
        }
    }
}

#[test]
fn a_reader_that_fails_is_refused() {
    struct Broken;
    impl std::io::Read for Broken {
        fn read(&mut self, _: &mut [u8]) -> std::io::Result<usize> {
            Err(std::io::Error::other("broken"))
        }
    }
    let start = &valid()[..40];
    let found = verify(&mut std::io::Read::chain(start, Broken), &Limits::DEFAULT);
    assert_eq!(code(&found), "unreadable");
}

fn program(words: &[&str], input: &[u8]) -> Output {
    let mut child = Command::new(env!("CARGO_BIN_EXE_acutile-verify"))
        .args(words)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    // The program may end before it has read everything.
    let _ = child.stdin.take().unwrap().write_all(input);
    child.wait_with_output().unwrap()
}

fn text(output: &Output) -> (i32, String) {
    (output.status.code().unwrap(), String::from_utf8(output.stdout.clone()).unwrap())
}

fn valid() -> Vec<u8> {
    let json = std::fs::read(folder().join("valid/plane-equilateral.json")).unwrap();
    transcribe(&json).unwrap()
}

#[test]
fn the_program_has_one_line_for_each_file_and_the_worst_exit_code() {
    let directory = std::env::temp_dir().join(format!("acutile-verify-{}", std::process::id()));
    std::fs::create_dir_all(&directory).unwrap();
    let path = |name: &str| directory.join(name).to_str().unwrap().to_owned();
    let good = path("good.cbor");
    std::fs::write(&good, valid()).unwrap();
    let forged = path("a\ngood: verified");
    std::fs::write(&forged, b"\x00").unwrap();

    let (exit, out) = text(&program(&[&good], b""));
    assert_eq!(exit, 0);
    let digest = "2 simplices, 1 vertices, sha256 ";
    assert!(out.starts_with(&format!("{good}: verified: {digest}")) && out.len() < 300, "{out}");

    let (exit, out) = text(&program(&[&good, &forged, &path("missing")], b""));
    assert_eq!((exit, out.lines().count()), (2, 3), "{out}");
    assert!(
        out.lines().nth(1).unwrap().contains("a\\ngood: verified\": malformed [cbor]")
            || out.lines().nth(1).unwrap().contains("a\\u000agood: verified\": malformed [cbor]"),
        "{out}"
    );
    assert!(out.lines().nth(2).unwrap().contains("malformed [unreadable]"), "{out}");

    for (option, value, most) in [("--max-degree", "9", "8"), ("--max-bits", "x", "18446744073709551615")] {
        let output = program(&[option, value, &good], b"");
        assert_eq!(text(&output), (2, String::new()));
        let words = format!("acutile-verify: {option}: found {value}, expected an integer from 0 to {most}\n");
        assert_eq!(String::from_utf8(output.stderr).unwrap(), words);
    }

    let (exit, out) = text(&program(&["--max-simplices", "1", &good], b""));
    assert_eq!(exit, 3);
    assert!(out.contains("declined [too-many-simplices]") && out.contains("--max-simplices 2"), "{out}");
    let (exit, out) = text(&program(&["--max-work", "0", &good], b""));
    assert!(exit == 3 && out.contains("use a larger --max-work; the default is 3000000000"), "{out}");
    let length = valid().len();
    let (exit, out) = text(&program(&["--max-bytes", "10", &good], b""));
    assert!(exit == 3 && out.contains(&format!("--max-bytes {length}")), "{out}");

    let (exit, out) = text(&program(&["--json", "-"], &valid()));
    assert!(exit == 0 && out.starts_with("{\"file\":\"-\",\"verdict\":\"verified\",\"simplices\":2,"), "{out}");

    let (exit, out) = text(&program(&["-"], b"{\n"));
    assert!(exit == 2 && out.contains("acutile convert"), "{out}");
    std::fs::remove_dir_all(directory).unwrap();
}

#[test]
fn the_program_compares_and_prints_claims() {
    let directory = std::env::temp_dir().join(format!("acutile-claim-{}", std::process::id()));
    std::fs::create_dir_all(&directory).unwrap();
    let claim = directory.join("claim.json");
    let name = claim.to_str().unwrap();
    let (exit, printed) = text(&program(&["--print-claim", "-"], &valid()));
    assert_eq!(exit, 0);
    assert_eq!(printed, check(&valid(), &Limits::DEFAULT).unwrap().claim.print());
    std::fs::write(&claim, &printed).unwrap();
    assert_eq!(text(&program(&["--claim", name, "-"], &valid())).0, 0);
    for other in [printed.replace("acute", "nonobtuse"), printed.clone() + "\n", String::new()] {
        std::fs::write(&claim, other).unwrap();
        let (exit, out) = text(&program(&["--claim", name, "-"], &valid()));
        assert!(exit == 1 && out.contains("rejected [other-claim]"), "{out}");
    }
    std::fs::remove_dir_all(directory).unwrap();
}

#[test]
fn a_wrong_command_line_is_exit_code_2() {
    for words in [&[][..], &["--nothing"], &["--max-work"], &["--max-work", "x", "-"], &["--claim", "/none", "-"]] {
        let output = program(words, b"");
        assert_eq!(output.status.code(), Some(2));
        assert!(output.stdout.is_empty() && !output.stderr.is_empty());
    }
    let (exit, out) = text(&program(&["--help"], b""));
    assert!(exit == 0 && out.contains("--max-work"));
}
