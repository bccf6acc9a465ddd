//! The works that the text cites: one list, as BibTeX entries and as the bibliography that BibTeX
//! makes of them. So the document compiles with pdfLaTeX alone.

/// refs.bib
pub const REFERENCES: &str = include_str!("refs.bib");
/// main.bbl, the same entries in the order of their labels.
pub const FORMATTED: &str = include_str!("refs.bbl");

/// The keys of works other than the paper that a construction of the catalogue is cited by.
fn others(name: &str, source: Option<&str>) -> &'static [&'static str] {
    match (name, source) {
        (_, None) => &[],
        ("c14" | "c36" | "mu", _) => &["FrankKasper1959"],
        ("bcc", _) => &["Sommerville1923"],
        (name, _) if name.starts_with("sommerville") => &["Sommerville1923"],
        (name, _) if name.starts_with("goldberg") => &["Goldberg1974"],
        (name, _) if name.starts_with("kagome") => &["FrankKasper1959"],
        ("square-10", _) => &["CassidyLord1980"],
        ("square-8", _) => &["Lindgren1964"],
        _ => &[],
    }
}

/// Whether the catalogue names a place in the paper.
fn is_in_paper(source: &str) -> bool {
    source.starts_with("section") || source.starts_with("Table")
}

/// The entries of refs.bib that a construction is cited by.
pub fn entries(name: &str, source: Option<&str>) -> Vec<&'static str> {
    let paper = source.filter(|source| is_in_paper(source));
    let keys = paper.map(|_| "EppsteinSullivanUngor2004");
    let keys = keys.into_iter().chain(others(name, source).iter().copied());
    keys.filter_map(entry).collect()
}

fn entry(key: &str) -> Option<&'static str> {
    let begins = |entry: &&str| {
        entry
            .split_once('{')
            .is_some_and(|(_, rest)| rest.starts_with(&format!("{key},")))
    };
    REFERENCES.split("\n\n").find(begins)
}

/// How the text cites a construction of the catalogue, from its name and the place that the catalogue names.
pub fn citation(name: &str, source: Option<&str>) -> String {
    let keys = others(name, source);
    let place = match source {
        Some(source) if is_in_paper(source) => {
            format!("[{}]", capitalised(source))
        }
        _ => String::new(),
    };
    let paper = match source {
        Some(source) if is_in_paper(source) => {
            format!("~\\cite{place}{{EppsteinSullivanUngor2004}}")
        }
        _ => String::new(),
    };
    let others = if keys.is_empty() {
        String::new()
    } else {
        format!("~\\cite{{{}}}", keys.join(","))
    };
    format!("{others}{paper}")
}

fn capitalised(source: &str) -> String {
    source.replacen("section", "Section", 1).replace(' ', "~")
}
