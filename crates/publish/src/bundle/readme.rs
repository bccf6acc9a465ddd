//! The README of an archive: for a referee who has Python 3, or Node, or Rust, and has never heard of
//! this program.

use super::Entry;
use super::metadata::Deposit;

const VERSION: &str = env!("CARGO_PKG_VERSION");

/// What is in the archive besides certificates.
#[derive(Clone, Copy, Debug)]
pub struct Parts {
    pub has_appendix: bool,
    pub has_pdf: bool,
    /// The claims as theorems for Coq.
    pub has_theorems: bool,
}

/// The text, in Markdown. Names in it are slugs, and claims are in the kernel's words.
pub fn readme(entries: &[Entry], parts: Parts, deposit: &Deposit) -> String {
    let slugs: Vec<&str> = entries.iter().map(|entry| entry.slug.as_str()).collect();
    [
        format!(
            "# {}\n\nWritten by acutile {VERSION} (`acutile bundle`). Each certificate below proves the \
             claim beside it, and can be\nchecked without the program that found it.\n\n## What is proved\n\n",
            deposit.title(&slugs)
        ),
        entries.iter().map(claim).collect(),
        check(entries),
        theorems(parts.has_theorems),
        contents(entries, parts),
        meshes(entries),
        citation(deposit),
    ]
    .concat()
}

fn citation(deposit: &Deposit) -> String {
    let licence = match &deposit.licence {
        Some(licence) => format!("The data are under the licence {licence}."),
        None => "No licence is stated for the data.".to_owned(),
    };
    format!(
        "## To cite\n\n`CITATION.cff`. {licence} The verifiers in `verify/` and the documents in `docs/` are under the licence in \
         `verify/LICENSE`; the crates in `verify/rust/vendor` have their own licences beside them.\n"
    )
}

/// `make check`: the checksums, then all certificates by Python, with the answers that are expected.
pub fn makefile() -> String {
    "# make check: nothing has changed since the deposit, and every certificate is verified.
# make node, make rust: the same certificates by two other programs; the first build in Rust takes about a minute.
.PHONY: check checksums python node rust
export LC_ALL = C
check: checksums python
checksums:
\tsha256sum --check --quiet SHA256SUMS || shasum -a 256 -c SHA256SUMS
python:
\tpython3 verify/verify.py certificates/*.json | sed -E 's/: verified: .*sha256 ([0-9a-f]+).*/: verified, sha256 \\1/' >check-output.txt
\tcat check-output.txt
\tdiff expected-output.txt check-output.txt
\t@echo 'as expected'
node:
\tnode verify/verify-cli.mjs certificates/*.json
rust:
\tcd verify/rust && cargo build --release --offline --locked
\tverify/rust/target/release/acutile-verify certificates/*.cbor
"
    .to_owned()
}

/// The output of `make check` about the certificates, in the order of their names.
pub fn expected(entries: &[Entry]) -> String {
    let line = |entry: &Entry| {
        format!(
            "certificates/{}.json: verified, sha256 {}\n",
            entry.slug, entry.sha256
        )
    };
    let mut lines: Vec<String> = entries.iter().map(line).collect();
    lines.sort();
    lines.concat()
}

/// How the theorems for Coq are checked.
fn theorems(are_there: bool) -> String {
    if !are_there {
        return String::new();
    }
    format!(
        "With **Coq** 8.16 and the folder `proofs` of the source of acutile {VERSION}: each `coq/NAME.v` has a certificate and its claim as \
         a theorem.\n`make -C proofs` there builds the theory, and `coqc -R proofs/theories Acutile coq/NAME.v` proves the claim\nand prints \
         its axioms.\n\n"
    )
}

/// From each claim to its evidence, and the limits of all claims.
pub fn claims(entries: &[Entry]) -> String {
    let rows = entries.iter().flat_map(|entry| {
        let slug = &entry.slug;
        entry.claim.split("; ").map(move |sentence| {
            format!(
                "| {} | `certificates/{slug}.cbor` | `python3 verify/verify.py certificates/{slug}.json` |\n",
                sentence.trim_end_matches('.').replace('|', "\\|")
            )
        })
    });
    format!(
        "# Claims and evidence

| claim | evidence | check |
|---|---|---|
{}
The digests of the certificates are in `README.md` and in `SHA256SUMS`.
`docs/soundness.md` proves that the checks imply the claims.

## Not proved

- Names, descriptions and sources of the tilings: the certificates do not contain them.
- The values in `report.html` and the tables of the appendix beside the claims: the prover computed them exactly, and the verifiers
  do not check them.
- Meshes in `tilings/`: their coordinates are rounded.
- That a tiling is new, or the best of its kind.
- That a compiler or an interpreter does what its language says: hence several verifiers in several languages.
",
        rows.collect::<String>()
    )
}

fn claim(entry: &Entry) -> String {
    format!(
        "- `certificates/{}.cbor`, SHA-256 `{}`: {}.\n",
        entry.slug,
        entry.sha256,
        entry.claim.trim_end_matches('.')
    )
}

fn check(entries: &[Entry]) -> String {
    let expected: String = expected(entries)
        .lines()
        .map(|line| format!("    {line}\n"))
        .collect();
    format!(
        "
## How to check it

First that the files are those that were deposited: `sha256sum -c SHA256SUMS` (on macOS `shasum -a 256 -c SHA256SUMS`).
Then the certificates, with any of these three. They share no code; each reads a certificate, computes exactly, and
believes nothing that the certificate does not show. For each file it prints a line, `FILE: verified: …` or what is wrong, and its
exit code is 0 only if every file is verified. That this implies the claims is proved in `docs/soundness.md`. The certificate
itself is the CBOR; the JSON is the same certificate for people, and the verifiers print the SHA-256 of the CBOR for both.

With **Python** 3.8 or later, and nothing else:

    python3 verify/verify.py certificates/*.json

It checks the hypotheses from which the tiling theorem follows, and every statement of the claim. It reads certificates in CBOR, too.
It sets no limit to its own work.

With **Node** 20 or later, and nothing else, all of `docs/format.md`:

    node verify/verify-cli.mjs certificates/*.json

With **Rust** (1.90 or later), and nothing else, the same with the verifier that confirmed these files when they were written.
`verify/rust` has its sources with all crates that it needs, so that no network is used:

    cd verify/rust && cargo build --release --offline --locked && cd ../..
    verify/rust/target/release/acutile-verify certificates/*.cbor

`make check` runs the checksums and Python, and compares the answers with `expected-output.txt`:

{}
Python takes about a second for 1,000 simplices with rational coordinates, and several for other fields; Rust builds in a minute and needs
less than a second for 100,000.

Or by hand: the JSON is text, and `docs/format.md` says what every number in it means and works through one with pencil and paper.

",
        expected
    )
}

fn contents(entries: &[Entry], parts: Parts) -> String {
    let pdf = if parts.has_pdf {
        "; `main.pdf` and `supplement.pdf` are made of it"
    } else {
        "; `pdflatex main` and `pdflatex supplement`, three times each, make PDFs of it"
    };
    let appendix = if parts.has_appendix {
        format!("| `appendix/` | theorems, exact tables and proofs in LaTeX{pdf} |\n")
    } else {
        String::new()
    };
    let tilings = if entries.iter().any(|entry| entry.is_tiling) {
        "| `tilings/*.json` | the tilings for acutile, exact |\n"
    } else {
        ""
    };
    let is_flat = |entry: &Entry| entry.rounding.is_none();
    let meshes = if entries.iter().all(is_flat) {
        ""
    } else {
        "| `tilings/*.msh`, `*.vtu`, `*.mesh` | one cell as a mesh in MSH 4.1, VTU and MEDIT, in doubles |\n"
    };
    let coq = if parts.has_theorems {
        "| `coq/` | claims as theorems for Coq, each with its certificate |\n"
    } else {
        ""
    };
    format!(
        "## What is here

| file | what it is |
|---|---|
| `certificates/` | claims with all that is needed to check them, as CBOR and as JSON |
{appendix}| `report.html` | an HTML page with a check in the browser; it needs no network |
{tilings}{meshes}{coq}| `verify/` | the verifiers in Python and JavaScript, and the sources of the one in Rust with all crates that it needs |
| `docs/` | the format of certificates, and why they prove what they claim |
| `CLAIMS.md` | each claim with its evidence, and what is not proved |
| `Makefile` | `make check` compares the checksums, verifies every certificate, and compares the answers with `expected-output.txt` |
| `SHA256SUMS` | the SHA-256 of every other file |

"
    )
}

/// The section about the meshes, whose coordinates are rounded.
fn meshes(entries: &[Entry]) -> String {
    let rows: String = entries.iter().filter_map(row).collect();
    if rows.is_empty() {
        return String::new();
    }
    format!(
        "## What is not exact

Coordinates in the mesh files are rounded to doubles, so that a check of a mesh is not a check of the tiling; those of the
certificates and of `tilings/*.json` are exact.

| mesh | coordinates that are no doubles | moved by at most |
|---|---|---|
{rows}
The lattice of a periodic tiling is in the MSH file alone, as `$Periodic`. Decimals in the appendix and on the page are cut off or
enclosed by exact bounds; the pictures are made of doubles.

"
    )
}

fn row(entry: &Entry) -> Option<String> {
    let (rounded, largest) = entry.rounding?;
    let largest = match rounded {
        0 => "0".to_owned(),
        _ => format!("{largest:.3e}"),
    };
    Some(format!("| `{}` | {rounded} | {largest} |\n", entry.slug))
}
