//! What the text cites: one list, written as BibTeX entries and as the bibliography that
//! BibTeX would make of them, so that the document compiles with pdfLaTeX alone.

/// refs.bib
pub const REFERENCES: &str = include_str!("refs.bib");
/// main.bbl, the same entries in the order of their labels.
pub const FORMATTED: &str = include_str!("refs.bbl");

/// The keys that a construction of the catalogue is cited by, from the place that the
/// catalogue names and the construction's name.
pub fn citation(name: &str, source: Option<&str>) -> String {
    let keys: &[&str] = match (name, source) {
        (_, None) => return String::new(),
        ("c14" | "c36" | "mu", _) => &["FrankKasper1959"],
        ("bcc", _) => &["Sommerville1923"],
        (name, _) if name.starts_with("sommerville") => &["Sommerville1923"],
        (name, _) if name.starts_with("goldberg") => &["Goldberg1974"],
        (name, _) if name.starts_with("kagome") => &["FrankKasper1959"],
        ("square-10", _) => &["CassidyLord1980"],
        ("square-8", _) => &["Lindgren1964"],
        _ => &[],
    };
    let place = match source {
        Some(source) if source.starts_with("section") || source.starts_with("Table") => {
            format!("[{}]", capitalised(source))
        }
        _ => String::new(),
    };
    let paper = match source {
        Some(source) if source.starts_with("section") || source.starts_with("Table") => {
            format!("~\\cite{place}{{EppsteinSullivanUngor2004}}")
        }
        _ => String::new(),
    };
    let others = match keys.is_empty() {
        true => String::new(),
        false => format!("~\\cite{{{}}}", keys.join(",")),
    };
    format!("{others}{paper}")
}

fn capitalised(source: &str) -> String {
    source.replacen("section", "Section", 1).replace(' ', "~")
}
