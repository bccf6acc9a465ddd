//! The article and the data of a refuted tiling: its defects with exact values and advice, beside a
//! picture that shows them in red.
//!
//! The words come from the caller, which knows the numbers of the file. Nothing is decided here.

use super::data::basis;
use super::html::{escape, fill};
use acutile_core::tiling::{AnyTiling, Facet, SimplexId, Tiling, match_facets};
use acutile_core::with_dimension;
use serde_json::{Value, json};
use std::collections::{BTreeMap, BTreeSet};

const TEMPLATE: &str = include_str!("assets/refuted.html");
/// A picture of more simplices has only those in the boundary and those with defects.
const DRAWN: usize = 4000;

/// A refuted tiling with the words for its defects.
#[derive(Debug)]
pub struct Refutation {
    /// The name of its file.
    pub name: String,
    /// A certificate that the kernel refuses, in JSON; `None` for a file that is none.
    pub refused: Option<String>,
    /// The verdict in a sentence.
    pub verdict: String,
    /// Further sentences: the changes of the input, and the effect of a repair.
    pub notes: Vec<String>,
    /// The tiling as it was read.
    pub tiling: AnyTiling,
    /// The number of defects of each kind, also of those that are not listed.
    pub counts: BTreeMap<&'static str, usize>,
    /// The defects that are listed.
    pub defects: Vec<Listed>,
    /// The names of the simplices in defects, as the file has them.
    pub names: BTreeMap<SimplexId, String>,
}

/// A defect in words, with the places where it is drawn.
#[derive(Debug)]
pub struct Listed {
    /// The stable name of the kind of defect.
    pub code: &'static str,
    /// The defect in one sentence.
    pub words: String,
    /// The corners with their exact coordinates.
    pub places: Vec<String>,
    /// Possible repairs, each a sentence.
    pub advice: Vec<String>,
    /// The simplices that it names.
    pub simplices: Vec<SimplexId>,
    /// The facets that it names.
    pub facets: Vec<Facet>,
    /// A point that shows the defect, in the basis, rounded.
    pub point: Option<Vec<f64>>,
}

/// The article number `index` of a page.
pub fn article(index: usize, refutation: &Refutation) -> String {
    let (simplices, one) = match refutation.tiling {
        AnyTiling::Plane(_) => ("triangles", "triangle"),
        AnyTiling::Space(_) => ("tetrahedra", "tetrahedron"),
    };
    let count = with_dimension!(&refutation.tiling, AnyTiling, t => t.len());
    let word = if count == 1 { one } else { simplices };
    let notes = refutation.notes.iter();
    let notes: String = notes
        .map(|note| format!("<p class=\"note\">{}</p>", escape(note)))
        .collect();
    fill(
        TEMPLATE,
        &[
            ("index", &index.to_string()),
            ("name", &escape(&refutation.name)),
            ("heading", heading(refutation)),
            ("buttons", buttons(refutation)),
            ("note", note(refutation)),
            ("counts", &format!("{count} {word}")),
            ("verdict", &escape(&refutation.verdict)),
            ("notes", &notes),
            ("defects", &groups(refutation)),
        ],
    )
}

fn heading(refutation: &Refutation) -> &'static str {
    match refutation.refused {
        None => "Not a valid tiling",
        Some(_) => "Not proved",
    }
}

fn buttons(refutation: &Refutation) -> &'static str {
    match refutation.refused {
        None => "<button type=\"button\" data-action=\"all\">All defects</button>",
        Some(_) => {
            "<button type=\"button\" class=\"primary\" data-action=\"verify\">Verify in this browser</button>\
             <button type=\"button\" data-action=\"certificate\">Download certificate</button>"
        }
    }
}

fn note(refutation: &Refutation) -> &'static str {
    match refutation.refused {
        None => {
            "The prover found these defects in exact arithmetic; no rounding and no tolerance is part of it. Coordinates are as in the \
             file. Numbers after \u{201c}about\u{201d} are cut off; the picture is made of doubles."
        }
        Some(_) => {
            "The kernel stops at the first rule that a certificate breaks; there may be more. Nothing that the certificate claims is \
             proved, and nothing is refuted by this: the picture shows what the certificate describes, in doubles."
        }
    }
}

/// The defects by kind, in the order in which the prover found the kinds.
fn groups(refutation: &Refutation) -> String {
    let group = |(code, count): (&&str, &usize)| {
        let listed = (0..).zip(&refutation.defects);
        let listed: Vec<_> = listed.filter(|(_, d)| d.code == *code).collect();
        let shown = match listed.len() {
            n if n < *count => format!("{count}, the first {n}"),
            _ => count.to_string(),
        };
        let items: String = listed.into_iter().map(item).collect();
        format!(
            "<h4>{} ({shown})</h4><ol class=\"defects\">{items}</ol>",
            escape(code)
        )
    };
    refutation.counts.iter().map(group).collect()
}

fn item((number, defect): (usize, &Listed)) -> String {
    let list = |class: &str, lines: &[String]| -> String {
        let line = |text: &String| format!("<p class=\"{class}\">{}</p>", escape(text));
        lines.iter().map(line).collect()
    };
    let words = escape(&defect.words);
    let head = if defect.simplices.is_empty() {
        format!("<p>{words}</p>")
    } else {
        format!("<button type=\"button\" data-defect=\"{number}\">{words}</button>")
    };
    let places = list("place", &defect.places);
    let advice = list("advice", &defect.advice);
    format!("<li>{head}{places}{advice}</li>")
}

/// The object `tilings[i]` of the page; see [`super::data::tiling_data`] for the names.
pub fn data(refutation: &Refutation) -> Value {
    with_dimension!(&refutation.tiling, AnyTiling, t => data_of(t, refutation))
}

fn data_of<const D: usize>(tiling: &Tiling<D>, refutation: &Refutation) -> Value {
    let ids = drawn(tiling, refutation);
    let vertices = tiling.vertices.iter();
    let points = vertices.map(|v| v.each_ref().map(|x| x.approximate()).to_vec());
    let rows = ids.iter().map(|&id| {
        let corners = tiling.simplex(id).iter();
        let corner = |c: &acutile_core::tiling::Corner<D>| {
            if c.shift == [0; D] {
                json!([c.vertex.number()])
            } else {
                let shift = c.shift.iter().take(tiling.frame.rank());
                let shift = shift.map(|&s| i64::from(s));
                let entries = std::iter::once(i64::from(c.vertex.number())).chain(shift);
                json!(entries.collect::<Vec<_>>())
            }
        };
        corners.map(corner).collect::<Vec<_>>()
    });
    let defects = refutation.defects.iter().map(|defect| {
        let simplices = defect.simplices.iter().map(|id| id.number());
        let facets = defect.facets.iter();
        json!({
            "simplices": simplices.collect::<Vec<_>>(),
            "facets": facets.map(|f| [f.simplex.number(), u32::from(f.opposite)]).collect::<Vec<_>>(),
            "point": defect.point,
        })
    });
    let names = refutation.names.iter();
    json!({
        "name": refutation.name,
        "certificate": refutation.refused,
        "sha256": "",
        "dimension": D,
        "rank": tiling.frame.rank(),
        "basis": basis(tiling),
        "points": points.collect::<Vec<_>>(),
        "simplices": tiling.len(),
        "ids": ids.iter().map(|id| id.number()).collect::<Vec<_>>(),
        "rows": rows.collect::<Vec<_>>(),
        "names": names.map(|(id, name)| (id.number().to_string(), json!(name))).collect::<serde_json::Map<_, _>>(),
        "defects": defects.collect::<Vec<_>>(),
    })
}

/// All simplices of a small tiling; else those with a defect and those with a facet that no other has.
fn drawn<const D: usize>(tiling: &Tiling<D>, refutation: &Refutation) -> Vec<SimplexId> {
    if tiling.len() <= DRAWN {
        return tiling.indices().collect();
    }
    let mismatches = match_facets(tiling).mismatches;
    let alone = mismatches.iter().filter(|m| m.uses.len() == 1);
    let outer = alone.flat_map(|m| m.uses.iter().map(|(facet, _)| facet.simplex));
    let defects = refutation.defects.iter();
    let named = defects.flat_map(|d| d.simplices.iter().copied());
    let all: BTreeSet<SimplexId> = outer.chain(named).collect();
    all.into_iter().collect()
}
