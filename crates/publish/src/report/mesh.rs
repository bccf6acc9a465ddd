//! The article of a tiling with too many different simplices for tables: counts, extreme values, a
//! histogram. The page computes the values of a chosen simplex from the certificate.

use super::article::{Parts, summary, words};
use super::histogram::histogram_of;
use super::html::{escape, fill};
use super::proved::Proved;
use acutile_core::quality::{rounded_down, rounded_up};
use acutile_core::statistics::{Extreme, Statistics};
use acutile_core::tiling::{SimplexId, Tiling};

const TEMPLATE: &str = include_str!("assets/mesh.html");

/// The article number `index` of a page.
pub fn article<const D: usize>(
    index: usize,
    proved: &Proved,
    tiling: &Tiling<D>,
    statistics: &Statistics,
) -> String {
    let [(_, simplices), ..] = words::<D>();
    let extremes = [("extremes", &*extremes::<D>(statistics))];
    let parts = Parts {
        classes: &vec![0; tiling.len()],
        facts: summary(tiling, None),
        histogram: histogram_of(statistics, simplices),
        sections: fill(TEMPLATE, &[&extremes[..], &words::<D>()].concat()),
    };
    parts.article(index, proved, tiling)
}

/// The rows of the table of extreme values.
fn extremes<const D: usize>(statistics: &Statistics) -> String {
    let angle = if D == 2 { "angle" } else { "dihedral angle" };
    let angles = [
        ("smallest", &statistics.smallest),
        ("largest", &statistics.largest),
    ];
    let ratios = [
        ("least", &statistics.lowest_ratio),
        ("greatest", &statistics.highest_ratio),
    ];
    let angles = angles.into_iter().filter_map(|(word, extreme)| {
        let extreme = extreme.as_ref()?;
        Some(row::<D, _>(
            &format!("{word} {angle}"),
            "°",
            extreme,
            |p| p.simplex,
        ))
    });
    let ratios = ratios.into_iter().filter_map(|(word, extreme)| {
        let extreme = extreme.as_ref()?;
        Some(row::<D, _>(
            &format!("{word} radius-edge ratio"),
            "",
            extreme,
            |s| *s,
        ))
    });
    angles.chain(ratios).collect()
}

fn row<const D: usize, P>(
    name: &str,
    unit: &str,
    extreme: &Extreme<P>,
    simplex: impl Fn(&P) -> SimplexId,
) -> String {
    let (low, high) = &extreme.bounds;
    let (low, high) = (rounded_down(low, 8), rounded_up(high, 8));
    let bounds = if low == high {
        format!("{low}{unit}")
    } else {
        format!("{low}{unit} to {high}{unit}")
    };
    let times = match extreme.count {
        1 => "once".to_owned(),
        n => format!("{n} times"),
    };
    let word = if D == 2 { "triangle" } else { "tetrahedron" };
    let first = extreme.holders.first().map(|holder| {
        let number = simplex(holder).number();
        format!("<span class=\"no-js\">{word} {number}</span><button type=\"button\" class=\"js-only\" data-choose=\"{number}\">{word} {number}</button>")
    });
    format!(
        "<tr><th scope=\"row\">{}</th><td>{}</td><td>{times}</td><td>{}</td></tr>",
        escape(name),
        escape(&bounds),
        first.unwrap_or_default()
    )
}
