//! The page: one HTML file with style, program, data and certificates in it. Its content security
//! policy forbids it to load anything.

use super::article;
use super::data::tiling_data;
use super::facts::Facts;
use super::html::{escape, fill, policy_hash, script_json};
use super::proved::Proved;
use acutile_core::tiling::AnyTiling;
use serde_json::{Value, json};

const TEMPLATE: &str = include_str!("assets/page.html");
/// The style of pages.
pub const STYLE: &str = include_str!("assets/style.css");
/// The second verifier, which the page runs on its own certificates.
const VERIFIER: &str = include_str!("../../../../verifiers/javascript/verifier.js");
/// The program, in the order in which its parts use each other.
const PROGRAM: [&str; 5] = [
    include_str!("assets/geometry.js"),
    include_str!("assets/renderer.js"),
    include_str!("assets/files.js"),
    include_str!("assets/details.js"),
    include_str!("assets/page.js"),
];

/// The page of one or more tilings. `home` is a link back to the index of a site, if there is one.
pub fn page(tilings: &[Proved], home: Option<&str>) -> String {
    let (articles, data): (Vec<String>, Vec<Value>) = (0..).zip(tilings).map(one).unzip();
    let program = PROGRAM.concat();
    let names: Vec<&str> = tilings.iter().map(|tiling| tiling.name.as_str()).collect();
    let title = escape(&names.join(", "));
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
            ("title", &title),
            ("policy", &policy(&program)),
            ("style", STYLE),
            ("home", &home),
            ("chooser", &chooser(tilings)),
            ("articles", &articles.concat()),
            ("version", env!("CARGO_PKG_VERSION")),
            ("data", &data),
            ("verifier", &script_json(&json!(VERIFIER))),
            ("program", &program),
        ],
    )
}

fn one((index, proved): (usize, &Proved)) -> (String, Value) {
    match proved.tiling() {
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
    }
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
fn chooser(tilings: &[Proved]) -> String {
    if tilings.len() < 2 {
        return String::new();
    }
    let link = |(index, tiling): (usize, &Proved)| {
        format!(
            "<li><a href=\"#tiling-{index}\">{}</a></li>",
            escape(&tiling.name)
        )
    };
    let links: String = (0..).zip(tilings).map(link).collect();
    format!("<nav class=\"chooser\" aria-label=\"Tilings on this page\"><ul>{links}</ul></nav>")
}
