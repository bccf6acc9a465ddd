//! The figures for readers: text with bars, SVG, CSV.

use super::{Extreme, Place, Statistics};
use crate::quality::{rounded_down, rounded_up};
use crate::tiling::SimplexId;
use std::fmt::{Display, Write};

/// The names of the figures.
const DEFINITIONS: &str = "radius-edge ratio: circumradius over shortest edge (Eppstein, Sullivan, Üngör, Table 1); aspect \
    ratio: longest edge over √(2D(D+1)) inradii, 1 for the regular simplex (Verdict Library Reference Manual, SAND2007-1751)";

/// The greatest length of a bar in characters.
const BAR: usize = 50;

/// Figures, extremes and a histogram with bars. `simplex` names a simplex.
pub fn text(statistics: &Statistics, simplex: &dyn Fn(SimplexId) -> String) -> String {
    let [acute, nonobtuse, obtuse] = statistics.kinds;
    let mut lines = vec![
        format!(
            "simplices: {}; acute {acute}, nonobtuse with a right angle {nonobtuse}, obtuse {obtuse}",
            statistics.simplices
        ),
        counts(
            "dihedral angles",
            ["acute", "right", "obtuse"],
            statistics.angles,
        ),
    ];
    if !statistics.left_out.is_empty() {
        let first = statistics.left_out[0];
        lines.push(format!(
            "left out: {} flat or negatively oriented simplices, the first is {}",
            statistics.left_out.len(),
            simplex(first)
        ));
    }
    let angle = |place: &Place| simplex(place.simplex);
    let ratio = |index: &SimplexId| simplex(*index);
    lines.extend(extreme(
        "smallest dihedral angle",
        "degrees",
        &statistics.smallest,
        angle,
    ));
    lines.extend(extreme(
        "largest dihedral angle",
        "degrees",
        &statistics.largest,
        angle,
    ));
    lines.extend(extreme(
        "least radius-edge ratio",
        "",
        &statistics.lowest_ratio,
        ratio,
    ));
    lines.extend(extreme(
        "greatest radius-edge ratio",
        "",
        &statistics.highest_ratio,
        ratio,
    ));
    if let Some([low, high]) = statistics.aspects {
        lines.push(format!(
            "aspect ratio, in doubles: {:.6} ({}) to {:.6} ({})",
            low.0,
            simplex(low.1),
            high.0,
            simplex(high.1)
        ));
    }
    lines.push(DEFINITIONS.to_owned());
    lines.push(String::new());
    lines.extend(bars(statistics));
    lines.join("\n") + "\n"
}

fn counts(what: &str, names: [&str; 3], counts: [usize; 3]) -> String {
    let parts: Vec<String> = names
        .iter()
        .zip(counts)
        .map(|(name, count)| format!("{name} {count}"))
        .collect();
    format!("{what}: {}", parts.join(", "))
}

fn extreme<P>(
    what: &str,
    unit: &str,
    extreme: &Option<Extreme<P>>,
    name: impl Fn(&P) -> String,
) -> Option<String> {
    let extreme = extreme.as_ref()?;
    let (low, high) = (
        rounded_down(&extreme.bounds.0, 6),
        rounded_up(&extreme.bounds.1, 6),
    );
    let value = if low == high {
        low
    } else {
        format!("{low} to {high}")
    };
    let is_rational = extreme.bounds.0 == extreme.bounds.1;
    let form = match &extreme.closed_form {
        Some(form) if !is_rational => format!(" = {form}"),
        _ => String::new(),
    };
    let mut names: Vec<String> = extreme.holders.iter().map(name).collect();
    names.dedup();
    names.truncate(5);
    Some(format!(
        "{what}: {value}{}{unit}{form}, {} times: {}{}",
        if unit.is_empty() { "" } else { " " },
        extreme.count,
        names.join(", "),
        if extreme.count > names.len() {
            ", …"
        } else {
            ""
        }
    ))
}

/// A line for each bin between the first and the last that is not empty.
fn bars(statistics: &Statistics) -> Vec<String> {
    let most = statistics
        .histogram
        .iter()
        .copied()
        .max()
        .unwrap_or(0)
        .max(1);
    occupied(statistics)
        .map(|(from, to, count)| {
            // Rounded up, so that one angle among millions shows.
            let bar = "█".repeat((count * BAR).div_ceil(most));
            format!("{from:>3} to {to:>3}°  {count:>9}  {bar}")
                .trim_end()
                .to_owned()
        })
        .collect()
}

/// The bins from the first to the last that is not empty: from, to, count.
fn occupied(statistics: &Statistics) -> impl Iterator<Item = (u32, u32, usize)> {
    let width = statistics.degrees_per_bin;
    let is_full = |count: &usize| *count > 0;
    let first = statistics.histogram.iter().position(is_full).unwrap_or(0);
    let last = statistics.histogram.iter().rposition(is_full);
    let bins = statistics.histogram[first..last.map_or(first, |last| last + 1)].iter();
    (first as u32..)
        .zip(bins)
        .map(move |(bin, &count)| (bin * width, (bin + 1) * width, count))
}

/// All bins: `from,to,count`, angles a with from <= a < to degrees.
pub fn csv(statistics: &Statistics) -> String {
    let width = statistics.degrees_per_bin;
    let rows = (0u32..).zip(&statistics.histogram);
    let lines = rows.map(|(bin, count)| format!("{},{},{count}\n", bin * width, (bin + 1) * width));
    std::iter::once("from,to,count\n".to_owned())
        .chain(lines)
        .collect()
}

/// A picture of the histogram, with the right angle marked.
pub fn svg(statistics: &Statistics, title: &str) -> String {
    let most = statistics
        .histogram
        .iter()
        .copied()
        .max()
        .unwrap_or(0)
        .max(1);
    let width = f64::from(statistics.degrees_per_bin);
    let mut svg = String::from(SVG_HEAD);
    text_at(&mut svg, 330.0, 18.0, "middle", &escaped(title));
    for (bin, &count) in statistics
        .histogram
        .iter()
        .enumerate()
        .filter(|(_, c)| **c > 0)
    {
        let height = 240.0 * count as f64 / most as f64;
        let (x, from) = (x_of(bin as f64 * width), bin as f64 * width);
        let _ = writeln!(
            svg,
            "<rect x=\"{x:.1}\" y=\"{:.1}\" width=\"{:.1}\" height=\"{height:.1}\"><title>{from} to {} degrees: {count}</title></rect>",
            280.0 - height,
            3.0 * width - 0.5,
            from + width
        );
    }
    for degrees in (0..=180).step_by(30) {
        text_at(
            &mut svg,
            x_of(f64::from(degrees)),
            298.0,
            "middle",
            &format!("{degrees}°"),
        );
    }
    let right = x_of(90.0);
    let _ = writeln!(
        svg,
        "<path class=\"right\" d=\"M{right} 30V280\"/>\n<path d=\"M60 280H600M60 280V40\"/>"
    );
    text_at(&mut svg, 56.0, 44.0, "end", &most);
    text_at(&mut svg, 330.0, 316.0, "middle", &"dihedral angle");
    svg.push_str("</svg>\n");
    svg
}

const SVG_HEAD: &str = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 640 325\" \
    font-family=\"sans-serif\" font-size=\"12\">\n<style>rect{fill:#0072b2}path{fill:none;stroke:#000}\
    .right{stroke:#d55e00;stroke-dasharray:4 3}</style>\n<rect width=\"640\" height=\"325\" style=\"fill:#fff\"/>\n";

fn x_of(degrees: f64) -> f64 {
    60.0 + 3.0 * degrees
}

fn text_at(svg: &mut String, x: f64, y: f64, anchor: &str, text: &dyn Display) {
    let _ = writeln!(
        svg,
        "<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"{anchor}\">{text}</text>"
    );
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
}
