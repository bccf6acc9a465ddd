//! The project's documents in the site: which there are, where they stand, and as HTML.

use super::html::escape;
use super::markdown::{Document, to_html};

/// The documents that the site has.
pub const DOCUMENTS: [Document; 26] = [
    document(
        "README.md",
        "docs/readme.html",
        "Read me",
        include_str!("../../../../README.md"),
    ),
    document(
        "docs/tutorials/theorem.md",
        "docs/tutorial-theorem.html",
        "Tutorial: a theorem",
        include_str!("../../../../docs/tutorials/theorem.md"),
    ),
    document(
        "docs/tutorials/mesh.md",
        "docs/tutorial-mesh.html",
        "Tutorial: a mesh",
        include_str!("../../../../docs/tutorials/mesh.md"),
    ),
    document(
        "docs/tutorials/paper.md",
        "docs/tutorial-paper.html",
        "Tutorial: a paper",
        include_str!("../../../../docs/tutorials/paper.md"),
    ),
    document(
        "python/README.md",
        "docs/python.html",
        "The Python package",
        include_str!("../../../../python/README.md"),
    ),
    document(
        "docs/format.md",
        "docs/format.html",
        "File formats",
        include_str!("../../../../docs/format.md"),
    ),
    document(
        "docs/soundness.md",
        "docs/soundness.html",
        "Why a certificate proves what it claims",
        include_str!("../../../../docs/soundness.md"),
    ),
    document(
        "docs/trust.md",
        "docs/trust.html",
        "What is trusted",
        include_str!("../../../../docs/trust.md"),
    ),
    document(
        "docs/optimize.md",
        "docs/optimize.html",
        "Better angles",
        include_str!("../../../../docs/optimize.md"),
    ),
    document(
        "docs/glossary.md",
        "docs/glossary.html",
        "Glossary",
        include_str!("../../../../docs/glossary.md"),
    ),
    document(
        "docs/performance.md",
        "docs/performance.html",
        "Performance",
        include_str!("../../../../docs/performance.md"),
    ),
    document(
        "docs/profile.md",
        "docs/profile.html",
        "What profiles said",
        include_str!("../../../../docs/profile.md"),
    ),
    document(
        "docs/meshes.md",
        "docs/meshes.html",
        "Mesh files",
        include_str!("../../../../docs/meshes.md"),
    ),
    document(
        "docs/cif.md",
        "docs/cif.html",
        "Crystallographic files",
        include_str!("../../../../docs/cif.md"),
    ),
    document(
        "docs/appendix.md",
        "docs/appendix.html",
        "Appendices in LaTeX",
        include_str!("../../../../docs/appendix.md"),
    ),
    document(
        "docs/gallery.md",
        "docs/gallery.html",
        "This site",
        include_str!("../../../../docs/gallery.md"),
    ),
    document(
        "docs/bundle.md",
        "docs/bundle.html",
        "Archives to deposit",
        include_str!("../../../../docs/bundle.md"),
    ),
    document(
        "docs/draw.md",
        "docs/draw.html",
        "Figures for print",
        include_str!("../../../../docs/draw.md"),
    ),
    document(
        "proofs/README.md",
        "docs/proofs.html",
        "The development in Coq",
        include_str!("../../../../proofs/README.md"),
    ),
    document(
        "ARCHITECTURE.md",
        "docs/architecture.html",
        "Architecture",
        include_str!("../../../../ARCHITECTURE.md"),
    ),
    document(
        "docs/lower-bound.md",
        "docs/lower-bound.html",
        "Lower bounds for the largest dihedral angle",
        include_str!("../../../../docs/lower-bound.md"),
    ),
    document(
        "docs/families.md",
        "docs/families.html",
        "Families of tilings",
        include_str!("../../../../docs/families.md"),
    ),
    document(
        "docs/choices.md",
        "docs/choices.html",
        "Choices and dependencies",
        include_str!("../../../../docs/choices.md"),
    ),
    document(
        "docs/versions.md",
        "docs/versions.html",
        "Versions",
        include_str!("../../../../docs/versions.md"),
    ),
    document(
        "CONTRIBUTING.md",
        "docs/contributing.html",
        "Contributing",
        include_str!("../../../../CONTRIBUTING.md"),
    ),
    document(
        "SECURITY.md",
        "docs/security.html",
        "Security",
        include_str!("../../../../SECURITY.md"),
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
    }
}

/// Files of the repository that the site has as they are.
pub const FILES: [(&str, &str); 3] = [
    (
        "docs/certificate.schema.json",
        include_str!("../../../../docs/certificate.schema.json"),
    ),
    (
        "docs/images/a15.svg",
        include_str!("../../../../docs/images/a15.svg"),
    ),
    ("LICENSE", include_str!("../../../../LICENSE")),
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
