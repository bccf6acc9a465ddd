//! The files: a document that compiles alone, the fragment for another document, a
//! supplement with the long tables, the bibliography, and the certificates.

use super::bibliography::{FORMATTED, REFERENCES};
use super::names;
use super::overview;
use super::subject::Subject;
use super::tex::escape;
use super::{File, Options, Parts};
use sha2::{Digest, Sha256};

const MACROS: &str = include_str!("macros.tex");
const FAMILIES: &str = include_str!("families.tex");
const PATCHES: &str = include_str!("patches.tex");
const REGIONS: &str = include_str!("regions.tex");
const SOUNDNESS: &str = include_str!("soundness.tex");

/// All files, in the order of their names.
pub fn files(subjects: &[Subject], parts: Vec<Parts>, options: &Options) -> Vec<File> {
    let rows: Vec<String> = parts.iter().filter_map(|part| part.row.clone()).collect();
    let has_overview = rows.len() > 1;
    let mut files = vec![
        text("main.tex", main(subjects, options)),
        text("supplement.tex", supplement(subjects, options)),
        text("appendix.tex", fragment(subjects, has_overview, options)),
        text("acutile-macros.tex", MACROS.to_owned()),
        text("soundness.tex", soundness(subjects)),
        text("refs.bib", versioned(REFERENCES)),
    ];
    files.push(text("overview.tex", overview::table(rows, subjects)));
    let sections = parts.iter().map(|part| part.section.as_str());
    let cited: Vec<&str> = sections.chain([SOUNDNESS]).collect();
    files.push(text(
        "main.bbl",
        versioned(&cited_only(&cited, has_overview)),
    ));
    for (subject, part) in subjects.iter().zip(parts) {
        let (section, wide) = if options.two_column {
            without_long_tables(&part.section)
        } else {
            (part.section, String::new())
        };
        files.push(text(&format!("tiling-{}.tex", subject.slug()), section));
        if options.two_column {
            files.push(text(&format!("wide-{}.tex", subject.slug()), wide));
        }
        files.push(text(&format!("tables-{}.tex", subject.slug()), part.tables));
        files.push(File {
            path: subject.certificate_path(),
            bytes: subject.cbor.clone(),
        });
        files.push(File {
            path: subject.json_path(),
            bytes: subject.json.clone().into_bytes(),
        });
    }
    files.sort_by(|a, b| a.path.cmp(&b.path));
    files
}

/// The theorems on which the sections rest.
fn soundness(subjects: &[Subject]) -> String {
    let mut text = SOUNDNESS.to_owned();
    if subjects.iter().any(Subject::is_region) {
        text += REGIONS;
    }
    if subjects.iter().any(Subject::is_family) {
        text += FAMILIES;
    }
    if subjects.iter().any(Subject::is_system) {
        text += PATCHES;
    }
    text
}

fn versioned(text: &str) -> String {
    text.replace("@VERSION@", env!("CARGO_PKG_VERSION"))
}

/// The bibliography without what these texts do not cite, as BibTeX would make it.
fn cited_only(texts: &[&str], has_overview: bool) -> String {
    let mut items = FORMATTED.split("\\bibitem{");
    let mut kept = items.next().unwrap_or_default().to_owned();
    for item in items {
        let key = item.split('}').next().unwrap_or_default();
        let is_cited = |text: &&str| {
            text.split("\\cite").skip(1).any(|rest| {
                let keys = rest
                    .split_once('{')
                    .and_then(|(_, rest)| rest.split_once('}'));
                keys.is_some_and(|(keys, _)| keys.split(',').any(|other| other == key))
            })
        };
        let is_last = item.contains("\\end{thebibliography}");
        let in_overview = has_overview && key == "EppsteinSullivanUngor2004";
        if in_overview || texts.iter().any(is_cited) {
            kept.push_str(&format!("\\bibitem{{{item}"));
        } else if is_last {
            kept.push_str("\\end{thebibliography}\n");
        }
    }
    kept
}

/// The first line of a text says what wrote it and the digest of the rest, so that a file that
/// somebody changed is known.
fn text(path: &str, body: String) -> File {
    File {
        path: path.to_owned(),
        bytes: format!("{}\n{body}", stamp(&body)).into_bytes(),
    }
}

fn stamp(body: &str) -> String {
    let digest: String = Sha256::digest(body.as_bytes())
        .iter()
        .map(|byte| format!("{byte:02x}"))
        .collect();
    format!("% Written by acutile appendix; SHA-256 of the lines below: {digest}")
}

/// Whether a file is as some `acutile appendix` wrote it.
pub fn is_unchanged(bytes: &[u8]) -> bool {
    let Ok(text) = std::str::from_utf8(bytes) else {
        return false;
    };
    text.split_once('\n')
        .is_some_and(|(first, body)| first == stamp(body))
}

fn preamble(options: &Options, title: &str, subjects: &[Subject]) -> String {
    let siunitx = if options.siunitx {
        "\\usepackage{siunitx}\n\\newcommand{\\acutiledecimal}[1]{\\ensuremath{\\num{#1}}}\n"
    } else {
        ""
    };
    let (class, margin) = if options.two_column {
        ("twocolumn,10pt", "18mm")
    } else {
        ("11pt", "25mm")
    };
    let names: Vec<String> = subjects
        .iter()
        .map(|subject| escape(&names::plain(&subject.name)))
        .collect();
    let (subjects, version) = (names.join("; "), env!("CARGO_PKG_VERSION"));
    format!(
        "\\documentclass[{class}]{{article}}\n\\usepackage[utf8]{{inputenc}}\n\\usepackage{{amsmath,amssymb,amsthm}}\n\
         \\usepackage{{booktabs,longtable,graphicx,tikz}}\n\\usepackage[a4paper,margin={margin}]{{geometry}}\n{siunitx}\
         \\usepackage[hidelinks]{{hyperref}}\n\\hypersetup{{pdftitle={{{title}}},pdfsubject={{{subjects}}},pdfcreator={{acutile {version}}}}}\n\\setlength{{\\LTcapwidth}}{{.85\\textwidth}}\n\\emergencystretch=4em\n"
    )
}

fn main(subjects: &[Subject], options: &Options) -> String {
    let title = "Tilings proved in exact arithmetic";
    let contents = if subjects.len() > 1 {
        "\\tableofcontents\n"
    } else {
        ""
    };
    format!(
        "{}\\title{{{title}}}\n\\author{{}}\n\\date{{}}\n\\begin{{document}}\n\\maketitle\n{contents}\
         \\input{{appendix}}\n\\bibliographystyle{{plain}}\n\\bibliography{{refs}}\n\\end{{document}}\n",
        preamble(options, title, subjects),
    )
}

/// The fragments that another document can input.
fn fragment(subjects: &[Subject], has_overview: bool, options: &Options) -> String {
    let input = |kind: &str| -> String {
        subjects
            .iter()
            .map(|subject| format!("\\input{{{kind}-{}}}\n", subject.slug()))
            .collect()
    };
    let overview = if has_overview {
        "\\acutilesection{Overview}\n\\input{overview}\n"
    } else {
        ""
    };
    let (first, last) = if options.two_column {
        (
            String::new(),
            format!("\\acutilewide\n{overview}{}", input("wide")),
        )
    } else {
        (overview.to_owned(), String::new())
    };
    format!(
        "% Needs amsmath, amssymb, amsthm, booktabs, longtable, graphicx, for systems of patches tikz; see acutile-macros.tex for what can be set.\n\
         \\input{{acutile-macros}}\n{first}{}\\input{{soundness}}\n{last}",
        input("tiling")
    )
}

/// Where the next long table begins.
fn next_table(text: &str) -> Option<usize> {
    let begin = text.find("\\begin{longtable}")?;
    text[..begin].rfind("{\\acutiletables")
}

/// A section without its long tables, and these.
fn without_long_tables(section: &str) -> (String, String) {
    const END: &str = "\\end{longtable}}\n";
    let (mut text, mut tables) = (String::new(), String::new());
    let mut rest = section;
    while let Some(start) = next_table(rest) {
        let end = rest[start..]
            .find(END)
            .map_or(rest.len(), |end| start + end + END.len());
        text.push_str(&rest[..start]);
        tables.push_str(&rest[start..end]);
        rest = &rest[end..];
    }
    text.push_str(rest);
    (text, tables)
}

fn supplement(subjects: &[Subject], options: &Options) -> String {
    let sections: String = subjects
        .iter()
        .map(|subject| format!("\\input{{tables-{}}}\n", subject.slug()))
        .collect();
    let title = "Supplement: all vertices, tiles and facets";
    let one_column = Options {
        two_column: false,
        ..*options
    };
    format!(
        "{}\\title{{{title}}}\n\\author{{}}\n\\date{{}}\n\\begin{{document}}\n\\maketitle\n\\input{{acutile-macros}}\n\\small\n{sections}\\end{{document}}\n",
        preamble(&one_column, title, subjects),
    )
}
