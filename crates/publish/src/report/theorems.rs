//! Pages of the site about families, systems of patches, and records. Each has the confirmed claim and its
//! certificate.

use super::html::escape;
use super::page::{Links, Shown, mixed_page};
use super::theorem::Theorem;
use acutile_catalog::{self as catalog, CatalogError, Entry, THEOREMS};
use acutile_core::checker::Options;
use acutile_core::family::{self, ProvedFamily};
use acutile_core::{patches, with_family};
use acutile_paper::records::{self, Record};
use rayon::prelude::*;

/// Proves all families and systems of patches of the catalogue.
///
/// # Errors
/// The first that is not proved, in words.
pub fn all() -> Result<Vec<Theorem>, String> {
    let entries = catalog::entries().iter();
    let families: Vec<&Entry> = entries.filter(|entry| entry.has_box()).collect();
    let families = families.par_iter().map(|entry| family(entry));
    let theorems: Vec<_> = families.chain(THEOREMS.par_iter().map(system)).collect();
    // The error of the first, whichever was found first.
    theorems.into_iter().collect()
}

fn family(entry: &Entry) -> Result<Theorem, String> {
    let name = entry.name;
    let named = |error: String| format!("{name}: {error}");
    let built = entry
        .build_family()
        .unwrap_or_else(|| Err(CatalogError::Family(name.to_owned())));
    let built = built.map_err(|error| named(error.to_string()))?;
    let options = Options {
        required: entry.requirements().map_err(named)?,
        ..Options::default()
    };
    let proved = with_family!(&built, f => family::prove(f, &options, &|_| {}));
    let proved = proved.map_err(|error| named(format!("{error:?}")))?;
    // With the numbers of the certificate, which may be in a smaller field.
    let (proved, read) = ProvedFamily::of_certificate(proved.certificate(), &options.limits)
        .map_err(|error| named(error.to_string()))?;
    let description = format!("{} ({})", entry.description, entry.source);
    Ok(Theorem::of_family(
        name.to_owned(),
        description,
        &proved,
        read,
    ))
}

fn system(entry: &catalog::Theorem) -> Result<Theorem, String> {
    let name = entry.name;
    let system = (entry.system)().map_err(|error| format!("{name}: {error}"))?;
    let proved = patches::prove(&system, &Options::default().limits)
        .map_err(|error| format!("{name}: {error}"))?;
    let description = entry.description.to_owned();
    let theorem = Theorem::of_system(name.to_owned(), description, &proved, system);
    Ok(theorem.with_letters(entry.letters))
}

/// The pages of these theorems, each with links to its neighbours.
pub fn pages(theorems: &[Theorem]) -> Vec<String> {
    let name = |index: usize| theorems.get(index).map(|theorem| theorem.name.as_str());
    let page = |(index, theorem): (usize, &Theorem)| {
        let links = Links {
            index: "theorems.html",
            previous: index.checked_sub(1).and_then(name),
            next: name(index + 1),
        };
        mixed_page(&[Shown::Theorem(theorem)], Some(&links))
    };
    theorems.par_iter().enumerate().map(page).collect()
}

fn item(theorem: &Theorem) -> String {
    let name = escape(&theorem.name);
    format!(
        "<section class=\"theorem\" id=\"{name}\"><h2><a href=\"tilings/{name}.html\">{name}</a></h2><p>{}</p><p>{}.</p>\
         <p><a href=\"certificates/{name}.json\">Certificate</a>, SHA-256 <code>{}</code></p></section>",
        escape(&theorem.description),
        escape(theorem.claim()),
        escape(theorem.sha256())
    )
}

/// The body of the page of these theorems.
pub fn body(theorems: &[Theorem]) -> String {
    let items: String = theorems.iter().map(item).collect();
    format!(
        "<h1 class=\"title\">Families</h1><p class=\"lead\">Theorems about many tilings at once: for every value of some \
         parameters in a box, or for all tilings that can be put together from some pieces. The kernel confirmed each \
         certificate when this site was written. The page of a family has a slider for each parameter, and that of a system of patches builds tilings from \
         its pieces; <a href=\"verify.html\">this page</a> verifies it in your browser.</p>{items}"
    )
}

/// The body of the page of the best known tilings.
///
/// # Errors
/// A candidate that is not proved, in words.
pub fn records_body() -> Result<String, String> {
    let found: Vec<Record> = records::records(&|_| {})?;
    let page = records::html(&found);
    let table = page
        .split_once("<table>")
        .and_then(|(_, rest)| rest.split_once("</table>"));
    let (table, _) = table.ok_or("the table of records has another form")?;
    Ok(format!(
        "<h1 class=\"title\">Records</h1><p class=\"lead\">The tilings with the smallest largest dihedral angle that are proved, beside the \
         literature and lower bounds.</p><div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Records\">\
         <table class=\"paper\">{table}</table></div>"
    ))
}
