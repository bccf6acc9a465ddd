//! How to cite a certificate: BibTeX entries, and a paragraph on methods with its scope.
//!
//! The paragraph stands outside of all entries, where BibTeX reads nothing, so that the whole is one `.bib` file.

use crate::appendix::Subject;
use crate::appendix::bibliography::entries;
use acutile_core::proved::{hexadecimal, in_words};
use acutile_kernel::Verified;

const VERSION: &str = env!("CARGO_PKG_VERSION");

/// The text for a subject, whose certificate the kernel has just verified.
pub fn citation(subject: &Subject, verified: &Verified) -> String {
    let digest = hexadecimal(&verified.sha256);
    let mut items = vec![program(), certificate(subject, &digest)];
    let sources = entries(&subject.name, subject.source);
    items.extend(sources.iter().map(|entry| (*entry).trim_end().to_owned()));
    let paragraphs = [
        made(subject, &digest, !sources.is_empty()),
        format!("Proved: {}.", in_words(verified).trim_end_matches('.')),
        CHECKED.to_owned(),
        NOT_PROVED.to_owned(),
    ];
    let paragraphs: Vec<String> = paragraphs.iter().map(|text| plain(text)).collect();
    format!("{}\n\n{}\n", items.join("\n\n"), paragraphs.join("\n\n"))
}

/// An at sign would begin an entry.
fn plain(text: &str) -> String {
    wrapped(&text.replace('@', "(at)"))
}

fn program() -> String {
    format!(
        "@software{{acutile,\n  author  = {{{{The acutile project}}}},\n  title   = {{acutile: tilings by acute tetrahedra, proved in exact arithmetic}},\n  \
         version = {{{VERSION}}}\n}}"
    )
}

fn certificate(subject: &Subject, digest: &str) -> String {
    let slug = subject.slug();
    format!(
        "@misc{{{slug}-certificate,\n  author = {{{{The acutile project}}}},\n  title  = {{Certificate {slug}}},\n  \
         note   = {{SHA-256 of the deterministic CBOR: {digest}; checked by acutile-verify {VERSION}}}\n}}"
    )
}

fn made(subject: &Subject, digest: &str, has_sources: bool) -> String {
    let slug = subject.slug();
    let source = if has_sources {
        " The construction is from the works cited above; they are not needed for the proof."
    } else {
        ""
    };
    format!(
        "Methods. The certificate {slug} with the SHA-256 {digest} has the claim and all that is needed to check it. The kernel of acutile {VERSION}, acutile-verify, \
         read its bytes and confirmed the claim in exact arithmetic; no floating-point number takes part in a decision. The kernel shares no arithmetic \
         and no judgement with the part of acutile that writes certificates.{source}"
    )
}

/// Which proofs there are that the checks imply the claim.
const CHECKED: &str = "That the checks imply the claim is proved on paper in docs/soundness.md. \
    Coq can prove the claim from the same bytes: acutile export --coq writes it as a theorem. This command has not run Coq. \
    Independent verifiers in JavaScript and Python read the same certificate; this command has not run them.";

const NOT_PROVED: &str = "Not proved: the name, the description and the source, which are not in the certificate; \
    that the tiling is new or the best of its kind; values that are not in the claim; and that the compiler and the machine did what they should, \
    for which several verifiers in several languages are the remedy.";

/// Lines of at most 100 letters.
fn wrapped(text: &str) -> String {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        match lines.last_mut() {
            Some(line) if line.chars().count() + word.chars().count() < 100 => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines.join("\n")
}
