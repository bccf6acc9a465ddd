//! The project's documents in the site: their list, their paths, and their HTML.

use super::html::escape;
use super::markdown::{Document, to_html};

/// The documents that the site has.
pub const DOCUMENTS: [Document; 27] = [
    document(
        "README.md",
        "docs/readme.html",
        "Read me",
        include_str!("../../repository/README.md"),
    ),
    document(
        "docs/tutorials/theorem.md",
        "docs/tutorial-theorem.html",
        "Tutorial: a theorem",
        include_str!("../../repository/docs/tutorials/theorem.md"),
    ),
    document(
        "docs/tutorials/mesh.md",
        "docs/tutorial-mesh.html",
        "Tutorial: a mesh",
        include_str!("../../repository/docs/tutorials/mesh.md"),
    ),
    document(
        "docs/tutorials/paper.md",
        "docs/tutorial-paper.html",
        "Tutorial: a paper",
        include_str!("../../repository/docs/tutorials/paper.md"),
    ),
    document(
        "python/README.md",
        "docs/python.html",
        "The Python package",
        include_str!("../../repository/python/README.md"),
    ),
    document(
        "docs/format.md",
        "docs/format.html",
        "File formats",
        include_str!("../../repository/docs/format.md"),
    ),
    document(
        "docs/soundness.md",
        "docs/soundness.html",
        "Why a certificate proves what it claims",
        include_str!("../../repository/docs/soundness.md"),
    )
    .with_formulas(),
    document(
        "docs/trust.md",
        "docs/trust.html",
        "What is trusted",
        include_str!("../../repository/docs/trust.md"),
    ),
    document(
        "docs/optimize.md",
        "docs/optimize.html",
        "Better angles",
        include_str!("../../repository/docs/optimize.md"),
    ),
    document(
        "docs/glossary.md",
        "docs/glossary.html",
        "Glossary",
        include_str!("../../repository/docs/glossary.md"),
    ),
    document(
        "docs/performance.md",
        "docs/performance.html",
        "Performance",
        include_str!("../../repository/docs/performance.md"),
    ),
    document(
        "docs/command-line.md",
        "docs/command-line.html",
        "The command line",
        include_str!("../../repository/docs/command-line.md"),
    ),
    document(
        "docs/json.md",
        "docs/json.html",
        "Answers as JSON",
        include_str!("../../repository/docs/json.md"),
    ),
    document(
        "docs/meshes.md",
        "docs/meshes.html",
        "Mesh files",
        include_str!("../../repository/docs/meshes.md"),
    ),
    document(
        "docs/cif.md",
        "docs/cif.html",
        "Crystallographic files",
        include_str!("../../repository/docs/cif.md"),
    ),
    document(
        "docs/appendix.md",
        "docs/appendix.html",
        "Appendices in LaTeX",
        include_str!("../../repository/docs/appendix.md"),
    ),
    document(
        "docs/gallery.md",
        "docs/gallery.html",
        "This site",
        include_str!("../../repository/docs/gallery.md"),
    ),
    document(
        "docs/bundle.md",
        "docs/bundle.html",
        "Archives to deposit",
        include_str!("../../repository/docs/bundle.md"),
    ),
    document(
        "docs/draw.md",
        "docs/draw.html",
        "Figures for print",
        include_str!("../../repository/docs/draw.md"),
    ),
    document(
        "proofs/README.md",
        "docs/proofs.html",
        "The development in Coq",
        include_str!("../../repository/proofs/README.md"),
    ),
    document(
        "ARCHITECTURE.md",
        "docs/architecture.html",
        "Architecture",
        include_str!("../../repository/ARCHITECTURE.md"),
    ),
    document(
        "docs/lower-bound.md",
        "docs/lower-bound.html",
        "Lower bounds for the largest dihedral angle",
        include_str!("../../repository/docs/lower-bound.md"),
    )
    .with_formulas(),
    document(
        "docs/families.md",
        "docs/families.html",
        "Families of tilings",
        include_str!("../../repository/docs/families.md"),
    ),
    document(
        "docs/choices.md",
        "docs/choices.html",
        "Choices and dependencies",
        include_str!("../../repository/docs/choices.md"),
    ),
    document(
        "docs/versions.md",
        "docs/versions.html",
        "Versions",
        include_str!("../../repository/docs/versions.md"),
    ),
    document(
        "CONTRIBUTING.md",
        "docs/contributing.html",
        "Contributing",
        include_str!("../../repository/CONTRIBUTING.md"),
    ),
    document(
        "SECURITY.md",
        "docs/security.html",
        "Security",
        include_str!("../../repository/SECURITY.md"),
    ),
];

const fn document(
    path: &'static str,
    page: &'static str,
    title: &'static str,
    text: &'static str,
) -> Document {
    Document {
        path,
        page,
        title,
        text,
        has_formulas: false,
    }
}

/// Files of the repository that the site has as they are.
pub const FILES: [(&str, &str); 3] = [
    (
        "docs/certificate.schema.json",
        include_str!("../../repository/docs/certificate.schema.json"),
    ),
    (
        "docs/images/a15.svg",
        include_str!("../../repository/docs/images/a15.svg"),
    ),
    ("LICENSE", include_str!("../../repository/LICENSE")),
];

/// The list of documents, as the body of `docs/index.html`.
pub fn contents() -> String {
    let item = |document: &Document| {
        let file = document.page.trim_start_matches("docs/");
        format!("<li><a href=\"{file}\">{}</a></li>", escape(document.title))
    };
    let items: String = DOCUMENTS.iter().map(item).collect();
    format!("<h1 class=\"title\">Documents</h1><ul>{items}</ul>")
}

/// A document as the body of its page, which is one folder below the site's root. Links lead to
/// other documents, to `FILES`, and to the certificates that `has_certificate` knows by name.
pub fn body(document: &Document, has_certificate: impl Fn(&str) -> bool) -> String {
    let html = to_html(document, |path| {
        let page = DOCUMENTS.iter().find(|other| other.path == path);
        let file = FILES.iter().find(|(file, _)| *file == path);
        let certificate = path
            .strip_prefix("certificates/")
            .and_then(|file| file.strip_suffix(".json"))
            .filter(|name| has_certificate(name));
        page.map(|document| document.page)
            .or(file.map(|(file, _)| *file))
            .or(certificate.map(|_| path))
            .map(|link| format!("../{link}"))
    });
    format!("<div class=\"document\">{html}</div>")
}

#[cfg(test)]
mod tests {
    use super::{DOCUMENTS, body};

    /// The text of a page without its formulas and code.
    fn prose(html: &str) -> String {
        let mut rest = html.to_owned();
        for name in ["math", "code", "h1", "h2", "h3"] {
            let (open, close) = (format!("<{name}"), format!("</{name}>"));
            while let Some(start) = rest.find(&open) {
                let end = rest[start..].find(&close).expect("an end") + close.len();
                rest.replace_range(start..start + end, " ");
            }
        }
        rest
    }

    #[test]
    fn proofs_have_their_formulas_marked() {
        for document in DOCUMENTS.iter().filter(|document| document.has_formulas) {
            let html = body(document, |_| false);
            let formulas = html.matches("<math").count();
            assert!(formulas > 200, "{}: {formulas}", document.path);
            let text = prose(&html);
            let words = text.split_whitespace();
            let left: Vec<&str> = words
                .filter(|word| word.contains('_') && !word.contains("href"))
                .collect();
            // A bracket that closes in another sentence is beyond the rule.
            assert!(left.len() * 50 < formulas, "{}: {left:?}", document.path);
        }
    }
}
