//! The dihedral angles of one cell as a histogram, in SVG. Bars are two degrees wide. From tables they
//! are counted by doubles: a picture, no proof.

use super::facts::{Facts, degrees, middle};
use acutile_core::statistics::{Statistics, statistics};
use acutile_core::tiling::Tiling;
use std::collections::BTreeMap;
use std::fmt::Write;

const BIN: f64 = 2.0;
/// The same for [`Statistics`].
pub const DEGREES_PER_BIN: u32 = 2;
const WIDTH: f64 = 640.0;
const HEIGHT: f64 = 200.0;
/// Why a proved tiling has statistics.
pub const METRIC: &str = "the metric of a proved tiling is positive definite";
/// The heights below for the degrees, above for the counts.
const BELOW: f64 = 34.0;
const ABOVE: f64 = 18.0;
const SIDE: f64 = 12.0;

/// The histogram; `simplex` is what the simplices are called.
pub fn histogram(facts: &Facts, simplex: &str) -> String {
    drawn(&bins(facts), simplex)
}

/// The histogram of a mesh, counted exactly.
pub fn histogram_of(statistics: &Statistics, simplex: &str) -> String {
    let counted = (0..).zip(&statistics.histogram);
    let bins = counted.filter(|(_, count)| **count > 0);
    drawn(&bins.map(|(bin, count)| (bin, *count)).collect(), simplex)
}

/// All angles of a proved tiling from 0 to 180 degrees as bars without labels.
///
/// # Panics
/// Never for a proved tiling.
pub fn spark<const D: usize>(tiling: &Tiling<D>) -> String {
    let counts = statistics(tiling, 5).expect(METRIC).histogram;
    let most = counts.iter().max().copied().unwrap_or(1).max(1);
    let bars = (0..).zip(&counts).filter(|(_, count)| **count > 0);
    let bar = |(k, count): (usize, &usize)| {
        let height = 1.0 + 19.0 * *count as f64 / most as f64;
        format!(
            "<rect x=\"{}\" y=\"{:.1}\" width=\"1.6\" height=\"{height:.1}\"/>",
            2 * k,
            20.0 - height
        )
    };
    let bars: String = bars.map(bar).collect();
    format!("<svg class=\"spark\" viewBox=\"0 0 72 20\" aria-hidden=\"true\">{bars}</svg>")
}

fn drawn(bins: &BTreeMap<i64, usize>, simplex: &str) -> String {
    let first = bins.keys().next().map_or(0, |bin| bin - 1);
    let last = bins.keys().last().map_or(45, |bin| bin + 1);
    let (low, high) = (
        (first as f64 * BIN).min(58.0),
        ((last + 1) as f64 * BIN).max(92.0),
    );
    let x = |degrees: f64| SIDE + (degrees - low) / (high - low) * (WIDTH - 2.0 * SIDE);
    let most = bins.values().max().copied().unwrap_or(1) as f64;
    let height = |count: usize| count as f64 / most * (HEIGHT - ABOVE - BELOW);
    let mut svg = format!(
        "<svg class=\"histogram\" viewBox=\"0 0 {WIDTH} {HEIGHT}\" role=\"img\" aria-label=\"Histogram: \
         {}\">",
        in_words(bins, simplex)
    );
    let base = HEIGHT - BELOW;
    for (&bin, &count) in bins {
        let (left, right) = (bin as f64 * BIN, (bin + 1) as f64 * BIN);
        // Writing to a string cannot fail.
        let _ = write!(
            svg,
            "<g><rect class=\"bar\" x=\"{:.1}\" y=\"{:.1}\" width=\"{:.1}\" height=\"{:.1}\"/>\
             <title>{left} to {right} degrees: {count}</title>\
             <text class=\"count\" x=\"{:.1}\" y=\"{:.1}\">{count}</text></g>",
            x(left) + 1.0,
            base - height(count),
            x(right) - x(left) - 2.0,
            height(count),
            (x(left) + x(right)) / 2.0,
            base - height(count) - 4.0,
        );
    }
    axis(&mut svg, low, high, x);
    svg + "</svg>"
}

/// How many angles of a cell lie in each bin.
fn bins(facts: &Facts) -> BTreeMap<i64, usize> {
    // A value at the border of two bins belongs to the upper one, rounding or not.
    let bin = |degrees: f64| ((degrees + 1e-9) / BIN).floor() as i64;
    let of_angle: Vec<i64> = facts
        .angles
        .values
        .iter()
        .map(|angle| bin(middle(&degrees(angle))))
        .collect();
    let mut bins = BTreeMap::new();
    for &angle in facts.cells.iter().flat_map(|cell| &cell.angles) {
        *bins.entry(of_angle[angle]).or_insert(0) += 1;
    }
    bins
}

fn axis(svg: &mut String, low: f64, high: f64, x: impl Fn(f64) -> f64) {
    let base = HEIGHT - BELOW;
    let _ = write!(
        svg,
        "<line class=\"axis\" x1=\"{:.1}\" y1=\"{base}\" x2=\"{:.1}\" y2=\"{base}\"/>",
        x(low),
        x(high)
    );
    let step = if high - low > 80.0 { 20 } else { 10 };
    for degrees in (0..=180).step_by(step).filter(|&d| {
        let d = f64::from(d);
        (low..=high).contains(&d)
    }) {
        let at = x(f64::from(degrees));
        let _ = write!(
            svg,
            "<line class=\"axis\" x1=\"{at:.1}\" y1=\"{base}\" x2=\"{at:.1}\" y2=\"{:.1}\"/>\
             <text class=\"tick\" x=\"{at:.1}\" y=\"{:.1}\">{degrees}°</text>",
            base + 5.0,
            base + 20.0
        );
    }
    let right = x(90.0);
    let _ = write!(
        svg,
        "<line class=\"right-angle\" x1=\"{right:.1}\" y1=\"4\" x2=\"{right:.1}\" y2=\"{base}\"/>"
    );
}

fn in_words(bins: &BTreeMap<i64, usize>, simplex: &str) -> String {
    let total: usize = bins.values().sum();
    let bound = |bin: Option<&i64>, step: i64| bin.map_or(0.0, |bin| (bin + step) as f64 * BIN);
    format!(
        "{total} angles of the {simplex} of one cell, between {} and {} degrees; the line marks 90 degrees",
        bound(bins.keys().next(), 0),
        bound(bins.keys().last(), 1)
    )
}
