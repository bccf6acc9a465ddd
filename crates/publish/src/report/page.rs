//! The page: one HTML file with style, program, data and certificates in it. Its content security
//! policy forbids it to load anything.

use super::article;
use super::data::tiling_data;
use super::facts::Facts;
use super::html::{escape, fill, policy_hash, script_json};
use super::proved::Proved;
use super::refutation::{self, Refutation};
use acutile_core::tiling::AnyTiling;
use serde_json::{Value, json};

const TEMPLATE: &str = include_str!("assets/page.html");
/// The style of pages.
pub const STYLE: &str = include_str!("assets/style.css");
/// The second verifier, which the page runs on its own certificates.
const VERIFIER: &str = include_str!("../../../../verifiers/javascript/verifier.js");
/// The program, in the order in which its parts use each other.
const PROGRAM: [&str; 7] = [
    include_str!("assets/geometry.js"),
    include_str!("assets/renderer.js"),
    include_str!("assets/files.js"),
    include_str!("assets/details.js"),
    include_str!("assets/colours.js"),
    include_str!("assets/refuted.js"),
    include_str!("assets/page.js"),
];

/// Something that a page shows.
#[derive(Clone, Copy, Debug)]
pub enum Shown<'a> {
    Proved(&'a Proved),
    Refuted(&'a Refutation),
}

impl Shown<'_> {
    fn name(&self) -> &str {
        match self {
            Shown::Proved(proved) => &proved.name,
            Shown::Refuted(refutation) => &refutation.name,
        }
    }
}

/// The page of one or more proved tilings. `home` is a link back to the index of a site, if there is one.
pub fn page(tilings: &[Proved], home: Option<&str>) -> String {
    let shown: Vec<Shown> = tilings.iter().map(Shown::Proved).collect();
    mixed_page(&shown, home)
}

/// The page of proved and refuted tilings.
pub fn mixed_page(tilings: &[Shown], home: Option<&str>) -> String {
    let (articles, data): (Vec<String>, Vec<Value>) = (0..).zip(tilings).map(one).unzip();
    let program = PROGRAM.concat();
    let names: Vec<&str> = tilings.iter().map(Shown::name).collect();
    let data = script_json(&json!({ "version": env!("CARGO_PKG_VERSION"), "tilings": data }));
    let home = home.map_or_else(String::new, |link| {
        format!(
            "<a class=\"home\" href=\"{}\">All tilings</a>",
            escape(link)
        )
    });
    fill(
        TEMPLATE,
        &[
            ("title", &escape(&names.join(", "))),
            ("kind", kind(tilings)),
            ("policy", &policy(&program)),
            ("style", STYLE),
            ("home", &home),
            ("chooser", &chooser(&names)),
            ("articles", &articles.concat()),
            ("trust", &trust(tilings)),
            ("version", env!("CARGO_PKG_VERSION")),
            ("data", &data),
            ("verifier", &script_json(&json!(VERIFIER))),
            ("program", &program),
        ],
    )
}

fn one((index, shown): (usize, &Shown)) -> (String, Value) {
    match shown {
        Shown::Refuted(refuted) => (
            refutation::article(index, refuted),
            refutation::data(refuted),
        ),
        Shown::Proved(proved) => match proved.tiling() {
            AnyTiling::Plane(tiling) => {
                let facts = Facts::of_plane(tiling);
                let article = article::article(index, proved, tiling, &facts);
                (article, tiling_data(proved, tiling, &facts))
            }
            AnyTiling::Space(tiling) => {
                let facts = Facts::of_space(tiling);
                let article = article::article(index, proved, tiling, &facts);
                (article, tiling_data(proved, tiling, &facts))
            }
        },
    }
}

/// Whether any, and whether all, are refuted.
fn kinds(tilings: &[Shown]) -> (bool, bool) {
    let mut refuted = tilings.iter().map(|t| matches!(t, Shown::Refuted(_)));
    (refuted.clone().any(|is| is), refuted.all(|is| is))
}

fn kind(tilings: &[Shown]) -> &'static str {
    match kinds(tilings) {
        (_, true) => "defects",
        (true, _) => "proofs and defects",
        _ => "proved tilings",
    }
}

/// Who answers for which part of the page.
fn trust(tilings: &[Shown]) -> String {
    let (any_refuted, all_refuted) = kinds(tilings);
    let mut text = String::new();
    if !all_refuted {
        text += "<p><b>Confirmed by the kernel:</b> the sentences under \u{201c}What is proved\u{201d}, for the certificate \
                 whose SHA-256 stands there. <b>Computed by the prover, exactly, and checked by nobody else:</b> classes, types, \
                 tables, histograms and the values of a chosen cell. <b>Doubles, for the eye only:</b> pictures and meshes.</p>";
    }
    if any_refuted {
        text += "<p><b>Found by the prover in exact arithmetic:</b> the defects of a refuted tiling. The kernel has no part in \
                 them. Nothing is said of tilings that are not on this page.</p>";
    }
    text
}

/// The program and the style by their hashes; workers and the verifier from memory; nothing else.
fn policy(program: &str) -> String {
    format!(
        "default-src 'none'; script-src {} blob:; worker-src blob:; style-src {}; img-src data: \
         blob:; base-uri 'none'; form-action 'none'",
        policy_hash(program),
        policy_hash(STYLE)
    )
}

/// Links to the tilings of a page; nothing where there is one.
fn chooser(names: &[&str]) -> String {
    if names.len() < 2 {
        return String::new();
    }
    let link = |(index, name): (usize, &&str)| {
        format!("<li><a href=\"#tiling-{index}\">{}</a></li>", escape(name))
    };
    let links: String = (0..).zip(names).map(link).collect();
    format!("<nav class=\"chooser\" aria-label=\"Tilings on this page\"><ul>{links}</ul></nav>")
}
