//! The page: one HTML file with style, program, data and certificates in it. Its content security
//! policy forbids it to load anything. Pages of a site share the files of style and program.

use super::article;
use super::data::{mesh_data, tiling_data};
use super::facts::Facts;
use super::family;
use super::foam;
use super::histogram::{DEGREES_PER_BIN, METRIC};
use super::html::{escape, fill, policy_hash, script_json};
use super::mesh;
use super::patches;
use super::proved::Proved;
use super::refutation::{self, Refutation};
use super::theorem::{Content, Theorem};
use acutile_core::statistics::statistics;
use acutile_core::tiling::{AnyTiling, Tiling};
use serde_json::{Value, json};

const TEMPLATE: &str = include_str!("assets/page.html");
/// The style of pages.
pub const STYLE: &str = include_str!("assets/style.css");
/// The second verifier, which the page runs on its own certificates.
pub const VERIFIER: &str = include_str!("../../repository/verifiers/javascript/verifier.js");
/// The program, in the order in which its parts use each other.
const PROGRAM: [&str; 26] = [
    include_str!("assets/vectors.js"),
    include_str!("assets/elements.js"),
    include_str!("assets/math.js"),
    include_str!("assets/geometry.js"),
    include_str!("assets/polygons.js"),
    include_str!("assets/shaders.js"),
    include_str!("assets/renderer.js"),
    include_str!("assets/files.js"),
    include_str!("assets/archive.js"),
    include_str!("assets/solids.js"),
    include_str!("assets/exact.js"),
    include_str!("assets/details.js"),
    include_str!("assets/colours.js"),
    include_str!("assets/refuted.js"),
    include_str!("assets/foam.js"),
    include_str!("assets/rounded.js"),
    include_str!("assets/family.js"),
    include_str!("assets/patches.js"),
    include_str!("assets/input.js"),
    include_str!("assets/view.js"),
    include_str!("assets/share.js"),
    include_str!("assets/recheck.js"),
    include_str!("assets/words.js"),
    include_str!("assets/general.js"),
    include_str!("assets/verify.js"),
    include_str!("assets/rows.js"),
];
/// Before the page is drawn: a still picture that nobody will see takes long to draw.
const EARLY: &str = "document.documentElement.classList.add(\"js\");";
/// The last part, which starts the others.
const START: &str = include_str!("assets/page.js");

/// Something that a page shows.
#[derive(Clone, Copy, Debug)]
pub enum Shown<'a> {
    /// A proved tiling.
    Proved(&'a Proved),
    /// A theorem about many tilings.
    Theorem(&'a Theorem),
    /// A tiling with defects.
    Refuted(&'a Refutation),
}

impl Shown<'_> {
    fn name(&self) -> &str {
        match self {
            Shown::Proved(proved) => &proved.name,
            Shown::Theorem(theorem) => &theorem.name,
            Shown::Refuted(refutation) => &refutation.name,
        }
    }
}

/// Where a page of a site leads: links to the index and to the tilings before and after this one.
#[derive(Clone, Copy, Debug, Default)]
pub struct Links<'a> {
    /// A page in the folder of [`shared_files`], which is above that of this page.
    pub index: &'a str,
    /// The names of the tilings, whose pages are beside this one.
    pub previous: Option<&'a str>,
    pub next: Option<&'a str>,
}

impl Links<'_> {
    fn html(&self) -> String {
        let link = |href: &str, text: &str| format!("<a class=\"home\" href=\"{href}\">{text}</a>");
        let neighbour = |name: Option<&str>, before: &str, after: &str| {
            name.map_or_else(String::new, |name| {
                let name = escape(name);
                link(&format!("{name}.html"), &format!("{before}{name}{after}"))
            })
        };
        let previous = neighbour(self.previous, "\u{2190}\u{a0}", "");
        let next = neighbour(self.next, "", "\u{a0}\u{2192}");
        let all = link(&format!("../{}", escape(self.index)), "All tilings");
        format!("<nav class=\"links\" aria-label=\"Site\">{all}{previous}{next}</nav>")
    }
}

/// The page of one or more proved tilings, with links if it belongs to a site.
pub fn page(tilings: &[Proved], home: Option<&Links>) -> String {
    let shown: Vec<Shown> = tilings.iter().map(Shown::Proved).collect();
    mixed_page(&shown, home)
}

/// The page of proved and refuted tilings.
pub fn mixed_page(tilings: &[Shown], home: Option<&Links>) -> String {
    let (articles, data): (Vec<String>, Vec<Value>) = (0..).zip(tilings).map(one).unzip();
    let names: Vec<&str> = tilings.iter().map(Shown::name).collect();
    let data = script_json(&json!({ "version": env!("CARGO_PKG_VERSION"), "tilings": data }));
    let parts = Parts::of(home.is_some());
    let home = home.map_or_else(String::new, Links::html);
    fill(
        TEMPLATE,
        &[
            ("title", &escape(&names.join(", "))),
            ("kind", kind(tilings)),
            ("policy", &parts.policy),
            ("style", &parts.style),
            ("early", EARLY),
            ("home", &home),
            ("chooser", &chooser(&names)),
            ("articles", &articles.concat()),
            ("trust", &trust(tilings)),
            ("version", env!("CARGO_PKG_VERSION")),
            ("data", &data),
            ("program", &parts.program),
            ("loads", parts.loads),
        ],
    )
}

fn one((index, shown): (usize, &Shown)) -> (String, Value) {
    match shown {
        Shown::Refuted(refuted) => (
            refutation::article(index, refuted),
            refutation::data(refuted),
        ),
        Shown::Theorem(theorem) => match &theorem.content {
            Content::Family(family, tree) => family::of_family(index, theorem, family, tree),
            Content::Patches(system) => (
                patches::article(index, theorem, system),
                patches::data(theorem, system),
            ),
        },
        Shown::Proved(proved) => match proved.tiling() {
            AnyTiling::Plane(tiling) => of_tiling(index, proved, tiling, Facts::of_plane(tiling)),
            AnyTiling::Space(tiling) => {
                let (article, mut data) = of_tiling(index, proved, tiling, Facts::of_space(tiling));
                data["foam"] = foam::data(proved, tiling);
                (article, data)
            }
        },
    }
}

/// With tables of all values, or as a mesh where these would be too many.
fn of_tiling<const D: usize>(
    index: usize,
    proved: &Proved,
    tiling: &Tiling<D>,
    facts: Option<Facts>,
) -> (String, Value) {
    match facts {
        Some(facts) => (
            article::article(index, proved, tiling, &facts),
            tiling_data(proved, tiling, &facts),
        ),
        None => {
            let statistics = statistics(tiling, DEGREES_PER_BIN).expect(METRIC);
            (
                mesh::article(index, proved, tiling, &statistics),
                mesh_data(proved, tiling, &statistics),
            )
        }
    }
}

fn is_refuted(shown: &Shown) -> bool {
    matches!(shown, Shown::Refuted(_))
}

fn is_theorem(shown: &Shown) -> bool {
    matches!(shown, Shown::Theorem(_))
}

/// A certificate that the kernel does not confirm.
fn is_refused(shown: &Shown) -> bool {
    matches!(shown, Shown::Refuted(refutation) if refutation.refused.is_some())
}

/// Whether any, and whether all, are refuted.
fn kinds(tilings: &[Shown]) -> (bool, bool) {
    let mut refuted = tilings.iter().map(is_refuted);
    (refuted.clone().any(|is| is), refuted.all(|is| is))
}

fn kind(tilings: &[Shown]) -> &'static str {
    match kinds(tilings) {
        (_, true) => "defects",
        (true, _) => "proofs and defects",
        _ if tilings.iter().all(is_theorem) => "proved for all",
        _ => "proved tilings",
    }
}

/// Who answers for which part of the page.
fn trust(tilings: &[Shown]) -> String {
    let (_, all_refuted) = kinds(tilings);
    let mut text = String::new();
    if !all_refuted {
        text += "<p><b>Confirmed by the kernel:</b> the sentences under \u{201c}What is proved\u{201d}, for the certificate \
                 whose SHA-256 stands there. <b>Computed by the prover, exactly, and checked by nobody else:</b> classes, types, \
                 tables, histograms and the values of a chosen cell. <b>Doubles, for the eye only:</b> pictures and meshes.</p>";
    }
    if tilings.iter().any(is_refused) {
        text += "<p><b>Refused by the kernel:</b> a certificate whose page says \u{201c}Not proved\u{201d}, at the place that is named. \
                 Nothing that it claims is proved.</p>";
    }
    if tilings.iter().any(|t| is_refuted(t) && !is_refused(t)) {
        text += "<p><b>Found by the prover in exact arithmetic:</b> the defects of a refuted tiling. The kernel has no part in \
                 them. Nothing is said of tilings that are not on this page.</p>";
    }
    if tilings.iter().any(is_theorem) {
        text += "<p><b>Families and systems of patches:</b> the theorem holds for all values and all tilings that it names. The picture shows one of them, \
                 computed in doubles from the numbers of the certificate; values of angles beside it are rounded.</p>";
    }
    text
}

/// The verifier's source as a constant of the program.
pub fn verifier(source: &str) -> String {
    format!("const VERIFIER = {};\n", script_json(&json!(source)))
}

fn program() -> String {
    verifier(VERIFIER) + &PROGRAM.concat() + START
}

const SHARED_PROGRAM: &str = "viewer.js";
const SHARED_STYLE: &str = "viewer.css";

/// The files that all pages of a site share, with their places in it. A browser takes no module from a file, so this script is none.
pub fn shared_files() -> [(&'static str, String); 2] {
    let program = format!("(() => {{\n\"use strict\";\n{}}})();\n", program());
    [(SHARED_PROGRAM, program), (SHARED_STYLE, STYLE.to_owned())]
}

/// Style and program of a page, with the policy that allows them.
struct Parts {
    style: String,
    program: String,
    policy: String,
    /// From where it takes files, in words.
    loads: &'static str,
}

impl Parts {
    /// Shared with the other pages of a site, or within the page.
    fn of(is_shared: bool) -> Parts {
        if is_shared {
            return Parts {
                style: format!("<link rel=\"stylesheet\" href=\"../{SHARED_STYLE}\">"),
                program: format!("<script src=\"../{SHARED_PROGRAM}\" defer></script>"),
                policy: policy("'self'", "'self'"),
                loads: "only files of this site",
            };
        }
        let program = program();
        Parts {
            style: format!("<style>{STYLE}</style>"),
            policy: policy(&policy_hash(&program), &policy_hash(STYLE)),
            program: format!("<script type=\"module\">{program}</script>"),
            loads: "nothing from any network",
        }
    }
}

/// This program and this style; workers and the verifier from memory; nothing else.
fn policy(program: &str, style: &str) -> String {
    format!(
        "default-src 'none'; script-src {} {program} blob:; worker-src blob:; style-src {style}; img-src data: \
         blob:; base-uri 'none'; form-action 'none'",
        policy_hash(EARLY),
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
