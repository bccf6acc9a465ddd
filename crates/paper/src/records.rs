//! The best known tilings: certified here, in the literature, and lower bounds.
//!
//! A value of a tiling comes from a certificate that was proved in this run. A lower bound comes from
//! checks that were decided in it. Only the literature is quoted.

use acutile_bounds::{Verdict, checks, theorem};
use acutile_catalog as catalog;
use acutile_core::checker::{self, Options};
use acutile_core::proved::prove;
use acutile_core::quality::{DihedralAngle, Exact, rounded_down, rounded_up};
use acutile_core::statement::{Relation, Statement};
use acutile_core::with_dimension;
use acutile_exact::number::radical::with_radicals;
use malachite::Rational;
use serde_json::{Value, json};

/// A kind of domain.
#[derive(Clone, Copy, Debug)]
struct Kind {
    name: &'static str,
    /// Names of the catalogue that compete.
    candidates: &'static [&'static str],
    literature: Literature,
    /// The theorem of docs/lower-bound.md that bounds the largest angle from below.
    bound: Option<&'static str>,
}

/// The published value.
#[derive(Clone, Copy, Debug)]
struct Literature {
    /// As the source says it.
    value: &'static str,
    source: &'static str,
}

const PAPER: &str = "Eppstein, Sullivan, Üngör 2004, Table 1";
const FACE_TO_FACE: &str = "face-to-face-73.31";

/// All kinds, in the order of the table.
const KINDS: [Kind; 11] = [
    Kind {
        name: "space",
        candidates: &[
            "c14-best",
            "z-best",
            "c14",
            "c15",
            "z",
            "a15",
            "sigma",
            "icosahedral",
        ],
        literature: Literature {
            value: "74.20 (C15)",
            source: PAPER,
        },
        bound: Some(FACE_TO_FACE),
    },
    Kind {
        name: "space, three families of mirror planes",
        candidates: &["cube-space"],
        literature: Literature {
            value: "",
            source: "",
        },
        bound: Some(FACE_TO_FACE),
    },
    Kind {
        name: "slab",
        candidates: &["slab-best", "slab"],
        literature: Literature {
            value: "87.70",
            source: PAPER,
        },
        bound: None,
    },
    Kind {
        name: "infinite square prism",
        candidates: &["square-prism"],
        literature: Literature {
            value: "",
            source: "",
        },
        bound: None,
    },
    Kind {
        name: "cube",
        candidates: &["cube-2715"],
        literature: Literature {
            value: "acute, in 1,370 tetrahedra",
            source: "VanderZee, Hirani, Zharnitsky, Guoy 2010; existence also Kopczyński, Pak, Przytycki 2012",
        },
        bound: None,
    },
    Kind {
        name: "regular tetrahedron",
        candidates: &["tetrahedron-543"],
        literature: Literature {
            value: "acute",
            source: "Kopczyński, Pak, Przytycki 2012",
        },
        bound: None,
    },
    Kind {
        name: "regular octahedron",
        candidates: &["octahedron-4344"],
        literature: Literature {
            value: "acute",
            source: "Kopczyński, Pak, Przytycki 2012",
        },
        bound: None,
    },
    Kind {
        name: "regular dodecahedron",
        candidates: &["dodecahedron-470"],
        literature: Literature {
            value: "",
            source: "",
        },
        bound: None,
    },
    Kind {
        name: "right prism over a regular triangle",
        candidates: &["prism-533"],
        literature: Literature {
            value: "",
            source: "",
        },
        bound: None,
    },
    Kind {
        name: "right prism over a regular pentagon",
        candidates: &["pentagonal-prism-515"],
        literature: Literature {
            value: "",
            source: "",
        },
        bound: None,
    },
    Kind {
        name: "square",
        candidates: &["square-14", "square-10", "square-8"],
        literature: Literature {
            value: "72, in 14 triangles, the least possible",
            source: "Eppstein, after Eppstein, Sullivan, Üngör 2004, section 2.1",
        },
        bound: None,
    },
];

/// A row of the table.
#[derive(Clone, Debug)]
pub struct Record {
    /// The kind of tilings that are compared.
    pub kind: &'static str,
    /// The best tiling that was proved; `None` if the catalogue has none.
    pub best: Option<Best>,
    /// The best value in the literature, as printed.
    pub literature: &'static str,
    /// The source of this value.
    pub source: &'static str,
    /// The lower bound and its place, where its checks hold.
    pub bound: Option<(&'static str, String)>,
}

/// A proved tiling.
#[derive(Clone, Debug)]
pub struct Best {
    /// The name in the catalogue.
    pub name: &'static str,
    /// The number of simplices, up to the lattice.
    pub simplices: u64,
    /// The largest dihedral angle.
    pub angle: DihedralAngle,
    /// The SHA-256 of the certificate.
    pub certificate: String,
}

/// Proves all candidates and decides the lower bounds.
///
/// # Errors
/// A candidate that is not proved.
pub fn records(progress: &dyn Fn(&str)) -> Result<Vec<Record>, String> {
    progress("lower bounds");
    let checks = checks(&|_| {});
    let record = |kind: &Kind| {
        let bound = kind
            .bound
            .and_then(theorem)
            .filter(|t| t.verdict(&checks) == Verdict::Holds);
        Ok(Record {
            kind: kind.name,
            best: best(kind, progress)?,
            literature: kind.literature.value,
            source: kind.literature.source,
            bound: bound.map(|t| (t.statement, format!("docs/lower-bound.md, {}", t.place))),
        })
    };
    KINDS.iter().map(record).collect()
}

/// The best of the candidates that the catalogue has.
fn best(kind: &Kind, progress: &dyn Fn(&str)) -> Result<Option<Best>, String> {
    let mut best: Option<Best> = None;
    for name in kind
        .candidates
        .iter()
        .filter(|name| catalog::find(name).is_some())
    {
        progress(name);
        let candidate = proved(name)?;
        if best
            .as_ref()
            .is_none_or(|best| candidate.angle < best.angle)
        {
            best = Some(candidate);
        }
    }
    Ok(best)
}

fn proved(name: &'static str) -> Result<Best, String> {
    let tiling = catalog::build(name).map_err(|error| format!("{name}: {error}"))?;
    let options = Options::default();
    let steps: checker::Progress = &|_| {};
    let proved = with_dimension!(&tiling, AnyTiling, t => prove(t, &options, steps));
    let proved = proved.map_err(|error| format!("{name}: {error}"))?;
    let largest = proved
        .statements()
        .iter()
        .find_map(|statement| match statement {
            Statement::LargestAngle(Relation::Maximum, angle) => Some(angle.clone()),
            _ => None,
        });
    Ok(Best {
        name,
        simplices: proved.verified().simplices,
        angle: largest.ok_or_else(|| format!("{name}: found no largest angle"))?,
        certificate: proved.sha256(),
    })
}

/// The number of decimals of angles.
const DIGITS: u64 = 6;

impl Best {
    /// The angle in degrees, rounded up.
    pub fn degrees(&self) -> String {
        rounded_up(&self.angle.enclosure(&width()).1, DIGITS)
    }
}

fn width() -> Rational {
    Rational::from_signeds(1i64, 1_000_000_000)
}

const HEADINGS: [&str; 6] = [
    "domain",
    "largest angle, certified",
    "tiling",
    "certificate",
    "literature",
    "lower bound",
];

/// The cells of a row. `code` writes a digest.
fn cells(record: &Record, code: impl Fn(&str) -> String) -> [String; 6] {
    let none = || "none".to_owned();
    let best = record.best.as_ref();
    let literature = if record.source.is_empty() {
        "none known to us".to_owned()
    } else {
        format!("{}: {}", record.source, record.literature)
    };
    [
        record.kind.to_owned(),
        best.map_or_else(none, |best| format!("{}°", best.degrees())),
        best.map_or_else(none, |best| {
            format!("{} ({} simplices)", best.name, best.simplices)
        }),
        best.map_or_else(none, |best| code(&best.certificate)),
        literature,
        record
            .bound
            .as_ref()
            .map_or_else(none, |(bound, place)| format!("{bound} ({place})")),
    ]
}

/// One paragraph for each kind.
pub fn text(records: &[Record]) -> String {
    let mut text = String::new();
    for record in records {
        let cells = cells(record, str::to_owned);
        text.push_str(&format!("{}\n", cells[0]));
        for (heading, cell) in HEADINGS.iter().zip(&cells).skip(1) {
            text.push_str(&format!("  {heading}: {cell}\n"));
        }
    }
    text
}

/// A table as GitHub and pandoc read it.
pub fn markdown(records: &[Record]) -> String {
    let line = |cells: &[String]| format!("| {} |\n", cells.join(" | "));
    let mut text = line(&HEADINGS.map(str::to_owned));
    text.push_str(&line(&["---"; 6].map(str::to_owned)));
    for record in records {
        text.push_str(&line(&cells(record, |digest| format!("`{digest}`"))));
    }
    text
}

/// A `tabular` environment.
pub fn latex(records: &[Record]) -> String {
    let line = |cells: &[String]| {
        let cells: Vec<String> = cells.iter().map(|cell| in_latex(cell)).collect();
        format!("{} \\\\\n", cells.join(" & "))
    };
    let mut text = String::from("\\begin{tabular}{lrlp{4cm}p{4cm}p{4cm}}\n\\hline\n");
    text.push_str(&line(&HEADINGS.map(str::to_owned)));
    text.push_str("\\hline\n");
    for record in records {
        // A digest may be broken after every eighth digit.
        text.push_str(&line(&cells(record, |digest| {
            let parts = digest.as_bytes().chunks(8).map(String::from_utf8_lossy);
            parts.collect::<Vec<_>>().join(" ")
        })));
    }
    text.push_str("\\hline\n\\end{tabular}\n");
    text
}

fn in_latex(cell: &str) -> String {
    let plain = |text: &str| {
        text.replace('&', "\\&")
            .replace('°', "$^\\circ$")
            .replace('…', "\\dots")
    };
    with_radicals(cell, plain, |tex| format!("${tex}$"))
}

/// A page with a table.
pub fn html(records: &[Record]) -> String {
    let line = |tag: &str, cells: &[String]| {
        let cell = |cell: &String| format!("<{tag}>{}</{tag}>", in_html(cell));
        format!("<tr>{}</tr>\n", cells.iter().map(cell).collect::<String>())
    };
    let mut text = String::from(
        "<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n<title>Records</title>\n<table>\n",
    );
    text.push_str(&line("th", &HEADINGS.map(str::to_owned)));
    for record in records {
        text.push_str(&line("td", &cells(record, str::to_owned)));
    }
    text.push_str("</table>\n</html>\n");
    text
}

fn in_html(cell: &str) -> String {
    cell.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
}

/// An object with the member `records`; angles have both ends of an enclosure.
pub fn json(records: &[Record]) -> Value {
    let ends = |best: &Best| {
        let (low, high) = best.angle.enclosure(&width());
        [rounded_down(&low, DIGITS), rounded_up(&high, DIGITS)]
    };
    let row = |record: &Record| {
        json!({
            "domain": record.kind,
            "best": record.best.as_ref().map(|best| json!({
                "name": best.name,
                "simplices": best.simplices,
                "largest_dihedral": ends(best),
                "sha256": best.certificate,
            })),
            "literature": record.literature,
            "source": record.source,
            "lower_bound": record.bound.as_ref().map(|(bound, place)| json!({
                "statement": bound,
                "place": place,
            })),
        })
    };
    json!({ "records": records.iter().map(row).collect::<Vec<_>>() })
}
