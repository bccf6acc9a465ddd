//! A static site of the whole catalogue. It has an index with pictures and the table, a page for
//! each tiling, the paper's statements with verdicts, and the documents. All links are relative.

use super::documents::{self, DOCUMENTS, FILES};
use super::drop;
use super::histogram::spark;
use super::html::{escape, fill};
use super::page::{Links, STYLE, page, shared_files};
use super::picture::picture;
use super::proved::Proved;
use super::summary;
use super::theorems;
use acutile_catalog::{self as catalog, Entry};
use acutile_core::checker::Options;
use acutile_core::tiling::AnyTiling;
use acutile_core::with_dimension;
use acutile_paper::paper::{self, Row, Verdict};
use acutile_paper::survey::Survey;
use acutile_paper::table;
use rayon::prelude::*;
use std::collections::BTreeMap;

const TEMPLATE: &str = include_str!("assets/site.html");
const SITE_STYLE: &str = include_str!("assets/site.css");
const SITE_PROGRAM: &str = include_str!("assets/site.js");

/// The files of a site by their paths in it.
pub type Site = BTreeMap<String, Vec<u8>>;

/// The site of all constructions that the catalogue has by a plain name.
///
/// # Errors
/// The first construction that is not proved, in words.
pub fn gallery() -> Result<Site, String> {
    let entries: Vec<&Entry> = catalog::names().filter_map(catalog::find).collect();
    let proved = prove_all(&entries)?;
    let theorems = theorems::all()?;
    let survey = Survey::of_catalog();
    let mut site = Site::new();
    let mut put = |path: String, text: String| drop(site.insert(path, text.into_bytes()));
    for (entry, tiling) in entries.iter().zip(&proved) {
        put(
            format!("pictures/{}.svg", entry.name),
            tiling.picture.clone(),
        );
        put(format!("tilings/{}.html", entry.name), tiling.page.clone());
        put(
            format!("certificates/{}.json", entry.name),
            tiling.certificate.clone(),
        );
    }
    put("index.html".into(), index(&entries, &proved, &survey)?);
    for (theorem, page) in theorems.iter().zip(theorems::pages(&theorems)) {
        put(
            format!("certificates/{}.json", theorem.name),
            theorem.json().to_owned(),
        );
        put(format!("tilings/{}.html", theorem.name), page);
    }
    let families = theorems::body(&theorems);
    put("theorems.html".into(), site_page("", "Families", &families));
    let records = theorems::records_body()?;
    put("records.html".into(), site_page("", "Records", &records));
    put("verify.html".into(), drop::page());
    put("site.js".into(), SITE_PROGRAM.to_owned());
    put("paper.html".into(), paper_page(&paper::rows(&survey)));
    put(
        "docs/index.html".into(),
        site_page("../", "Documents", &documents::contents()),
    );
    for document in &DOCUMENTS {
        let body = documents::body(document, is_entry);
        put(
            document.page.into(),
            site_page("../", document.title, &body),
        );
    }
    for (path, text) in shared_files() {
        put(path.into(), text);
    }
    for (path, text) in FILES {
        put(path.into(), text.to_owned());
    }
    put("site.css".into(), [STYLE, SITE_STYLE].concat());
    // A file that keeps hosts from running generators over the site.
    put(".nojekyll".into(), String::new());
    Ok(site)
}

/// The data that the site needs of a tiling; the rest is dropped.
struct Shown {
    page: String,
    picture: String,
    certificate: String,
    counts: String,
    /// A histogram of the angles, small.
    spark: String,
}

/// Proves all constructions, several at a time.
fn prove_all(entries: &[&Entry]) -> Result<Vec<Shown>, String> {
    let name = |index: usize| entries.get(index).map(|entry| entry.name);
    let one = |(index, entry): (usize, &&Entry)| {
        let links = Links {
            index: "index.html",
            previous: index.checked_sub(1).and_then(name),
            next: name(index + 1),
        };
        shown(entry, &links)
    };
    let shown: Vec<_> = entries.par_iter().enumerate().map(one).collect();
    // The error of the first entry, whichever was found first.
    shown.into_iter().collect()
}

fn shown(entry: &Entry, links: &Links) -> Result<Shown, String> {
    let name = entry.name;
    let tiling = entry.build().map_err(|error| format!("{name}: {error}"))?;
    let description = format!("{} ({})", entry.description, entry.source);
    let proved = Proved::of_tiling(
        name.to_owned(),
        description,
        &tiling,
        &Options::default(),
        &|_| {},
    )
    .map_err(|error| format!("{name}: {error}"))?;
    let label = format!("One cell of {}", escape(name));
    Ok(Shown {
        certificate: proved.json().to_owned(),
        picture: match proved.tiling() {
            AnyTiling::Plane(tiling) => picture(tiling, &super::facts::classes(tiling), &label),
            AnyTiling::Space(tiling) => picture(tiling, &super::facts::classes(tiling), &label),
        },
        counts: summary(&proved),
        spark: with_dimension!(proved.tiling(), AnyTiling, t => spark(t)),
        page: page(std::slice::from_ref(&proved), Some(links)),
    })
}

/// The groups of the index, in their order.
const GROUPS: [&str; 4] = [
    "Tetrahedrally close packed structures",
    "Other tilings of space",
    "Slabs, prisms and polyhedra",
    "The plane",
];

fn group(entry: &Entry, shown: &Shown) -> &'static str {
    let [packed, space, parts, plane] = GROUPS;
    match entry.domain {
        "plane" | "polygon" => plane,
        "space" if properties(shown).contains(&"tcp") => packed,
        "space" => space,
        _ => parts,
    }
}

/// The properties by which the index filters: words of the proved counts.
fn properties(shown: &Shown) -> Vec<&'static str> {
    let has = |word: &str| shown.counts.split(", ").any(|part| part == word);
    let known = [("acute", "acute"), ("TCP", "tcp")];
    let known = known.into_iter().filter(|(word, _)| has(word));
    known.map(|(_, property)| property).collect()
}

fn card(entry: &Entry, shown: &Shown) -> String {
    let name = escape(entry.name);
    format!(
        "<li data-has=\"{}\"><a href=\"tilings/{name}.html\"><img src=\"pictures/{name}.svg\" alt=\"\" loading=\"lazy\">\
         <b>{name}</b></a><span>{}</span><small>{}</small></li>",
        properties(shown).join(" "),
        escape(entry.description),
        escape(&shown.counts)
    )
}

fn groups(entries: &[&Entry], proved: &[Shown]) -> String {
    let section = |name: &&str| {
        let members = entries.iter().zip(proved);
        let members = members.filter(|(entry, shown)| group(entry, shown) == *name);
        let cards: String = members.map(|(entry, shown)| card(entry, shown)).collect();
        format!(
            "<section class=\"group\"><h2>{name}</h2><ul class=\"cards\">{cards}</ul></section>"
        )
    };
    GROUPS.iter().map(section).collect()
}

const FILTER: &str = "<form class=\"filter js-only\" role=\"search\"><label>Search <input type=\"search\" name=\"search\"></label>\
     <label><input type=\"checkbox\" value=\"acute\"> acute</label>\
     <label><input type=\"checkbox\" value=\"tcp\"> TCP</label><output></output></form>";

fn index(entries: &[&Entry], proved: &[Shown], survey: &Survey) -> Result<String, String> {
    let names: Vec<&str> = entries.iter().map(|entry| entry.name).collect();
    let rows = table::order(&names)
        .into_iter()
        .map(|name| Ok(table::Row::of(name, survey.get(name)?)))
        .collect::<Result<Vec<_>, String>>()?;
    let body = format!(
        "<h1 class=\"title\">Tilings by acute tetrahedra</h1><p class=\"lead\">Tilings of space, slabs, solids and the plane by tetrahedra and triangles, most of them acute. Each was proved in exact \
         arithmetic, and its certificate confirmed by a small independent kernel, when this site was written. Every page \
         carries its certificate and a verifier that runs in your browser.</p>\
         {FILTER}{}\
         <h2 id=\"table\">Table 1 of the paper, as enclosures</h2>\
         <p>Radius-edge ratio ρ, smallest dihedral angle α and largest dihedral angle β of each tetrahedron, the least and the \
         largest over the tiling. Minima are rounded down and maxima up; exact values below them where they are short. Click a heading to sort.</p>\
         {}",
        groups(entries, proved),
        figures(&rows, |name| {
            let index = entries.iter().position(|entry| entry.name == name);
            index.map_or("", |index| &proved[index].spark)
        })
    );
    Ok(site_page("", "Tilings by acute tetrahedra", &body))
}

/// The table with links to the tilings: the cells of its Markdown form.
fn figures<'a>(rows: &[table::Row], spark: impl Fn(&str) -> &'a str) -> String {
    let text = table::markdown(rows);
    let mut lines = text
        .lines()
        .map(|line| line.trim_matches(['|', ' ']).split(" | "));
    let head = lines.next().into_iter().flatten();
    let head: String = head
        .map(|cell| {
            format!("<th scope=\"col\"><span class=\"no-js\">{cell}</span><button type=\"button\" class=\"js-only\">{cell}</button></th>")
        })
        .collect();
    let row = |(row, cells): (&table::Row, std::str::Split<&str>)| {
        let name = format!(
            "<th scope=\"row\"><a href=\"tilings/{}.html\">{}</a></th>",
            escape(&row.name),
            escape(&row.label)
        );
        let figures: String = cells.skip(1).map(figure).collect();
        format!("<tr>{name}{figures}<td>{}</td></tr>", spark(&row.name))
    };
    let body: String = rows.iter().zip(lines.skip(1)).map(row).collect();
    format!(
        "<div class=\"scroll figures\" tabindex=\"0\" role=\"region\" aria-label=\"Table 1\"><table><thead><tr>{head}<th scope=\"col\">angles, 0° to 180°</th></tr>\
         </thead><tbody>{body}</tbody></table></div>"
    )
}

/// `0.645 (√(5/12))` in two lines; a closed form that is no help to a reader is left out.
fn figure(cell: &str) -> String {
    match cell.split_once(" (") {
        Some((decimal, form)) if form.chars().count() <= 20 => format!(
            "<td>{}<br><small>{}</small></td>",
            escape(decimal),
            escape(form.strip_suffix(')').unwrap_or(form))
        ),
        Some((decimal, _)) => format!("<td>{}</td>", escape(decimal)),
        None => format!("<td>{}</td>", escape(cell)),
    }
}

/// A page in the folder that `up` leads out of.
fn site_page(up: &str, title: &str, body: &str) -> String {
    fill(
        TEMPLATE,
        &[
            ("up", up),
            ("title", &escape(title)),
            ("body", body),
            ("version", env!("CARGO_PKG_VERSION")),
        ],
    )
}

fn paper_page(rows: &[Row]) -> String {
    let mut counts = BTreeMap::new();
    rows.iter()
        .for_each(|row| *counts.entry(row.verdict.word()).or_insert(0) += 1);
    let counts: Vec<String> = counts
        .iter()
        .map(|(word, n)| format!("{n} {word}"))
        .collect();
    let body = format!(
        "<h1 class=\"title\">The paper's statements</h1><p class=\"lead\">Every checkable statement of D. Eppstein, J. M. Sullivan, A. Üngör, “Tiling space and slabs with acute tetrahedra”, \
         decided in exact arithmetic. {} statements: {}.</p>\
         <div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Statements\"><table class=\"paper\"><thead><tr><th scope=\"col\">section</th>\
         <th scope=\"col\">statement</th><th scope=\"col\">printed</th><th scope=\"col\">proved</th><th scope=\"col\">verdict</th>\
         <th scope=\"col\">certificates</th></tr></thead><tbody>{}</tbody></table></div>",
        rows.len(),
        counts.join(", "),
        rows.iter().map(paper_row).collect::<String>()
    );
    site_page("", "The paper's statements", &body)
}

/// Whether the site has a tiling of this name.
fn is_entry(name: &str) -> bool {
    catalog::names().any(|known| known == name)
}

fn paper_row(row: &Row) -> String {
    let links = row.certificates.iter().map(|(name, _)| {
        let name = escape(name);
        if is_entry(&name) {
            format!("<a href=\"tilings/{name}.html\">{name}</a>")
        } else {
            name
        }
    });
    let mark = match row.verdict {
        Verdict::Confirmed | Verdict::ProvedForAll | Verdict::Rounded(_) => "holds",
        Verdict::Misprint | Verdict::Refuted => "differs",
        Verdict::Open | Verdict::Undecided => "open",
    };
    format!(
        "<tr id=\"{}\"><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td class=\"{mark}\">{}</td><td>{}</td></tr>",
        escape(&row.id),
        escape(row.section),
        escape(&row.statement),
        escape(&row.printed),
        escape(&row.proved),
        row.verdict.word(),
        links.collect::<Vec<_>>().join(", ")
    )
}
