//! The README of an archive: for a referee who has Python 3, or Node, or Rust, and has never heard of
//! this program.

use super::Entry;
use super::metadata::Deposit;

const VERSION: &str = env!("CARGO_PKG_VERSION");

/// The text, in Markdown. Names in it are slugs, and claims are in the kernel's words.
pub fn readme(entries: &[Entry], has_appendix: bool, has_pdf: bool, deposit: &Deposit) -> String {
    let slugs: Vec<&str> = entries.iter().map(|entry| entry.slug.as_str()).collect();
    [
        format!(
            "# {}\n\nWritten by acutile {VERSION} (`acutile bundle`). Each certificate below proves the \
             claim beside it, and can be\nchecked without the program that found it.\n\n## What is proved\n\n",
            deposit.title(&slugs)
        ),
        entries.iter().map(claim).collect(),
        check(),
        contents(entries, has_appendix, has_pdf),
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
         `verify/LICENSE`.\n"
    )
}

/// `make check`: the checksums, then all certificates by two programs.
pub fn makefile() -> String {
    "# make check: nothing has changed since the deposit, and every certificate is verified.
.PHONY: check checksums python node
check: checksums python
checksums:
\tsha256sum --check --quiet SHA256SUMS || shasum -a 256 -c SHA256SUMS
python:
\tpython3 verify/verify.py certificates/*.json
node:
\tnode verify/verify-cli.mjs certificates/*.json
"
    .to_owned()
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
- The meshes in `tilings/`: their coordinates are rounded.
- That a tiling is new, or the best of its kind.
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

fn check() -> String {
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

With **Rust** (1.90 or later) and the source of acutile {VERSION}, the same with the verifier that confirmed these files when they were written.
In the folder of the source, and then with that program here:

    cargo build --release --locked --package acutile-kernel
    acutile-verify certificates/*.cbor

Or by hand: the JSON is text, and `docs/format.md` says what every number in it means and works through one with pencil and paper.

"
    )
}

fn contents(entries: &[Entry], has_appendix: bool, has_pdf: bool) -> String {
    let pdf = match has_pdf {
        true => "; `main.pdf` and `supplement.pdf` are made of it",
        false => "; `pdflatex main` and `pdflatex supplement`, three times each, make PDFs of it",
    };
    let appendix = match has_appendix {
        true => format!("| `appendix/` | theorems, exact tables and proofs in LaTeX{pdf} |\n"),
        false => String::new(),
    };
    let is_flat = |entry: &Entry| entry.rounding.is_none();
    let meshes = match entries.iter().all(is_flat) {
        true => "",
        false => {
            "| `tilings/*.msh`, `*.vtu`, `*.mesh` | one cell as a mesh in MSH 4.1, VTU and MEDIT, in doubles |\n"
        }
    };
    format!(
        "## What is here

| file | what it is |
|---|---|
| `certificates/` | claims with all that is needed to check them, as CBOR and as JSON |
{appendix}| `report.html` | a page to look at, with a check in the browser; it loads nothing |
| `tilings/*.json` | the tilings for acutile, exact |
{meshes}| `verify/` | the verifiers in Python and JavaScript |
| `docs/` | the format of certificates, and why they prove what they claim |
| `CLAIMS.md` | each claim with its evidence, and what is not proved |
| `Makefile` | `make check` compares the checksums and verifies every certificate |
| `SHA256SUMS` | the SHA-256 of every other file |

"
    )
}

/// What rounding did.
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
