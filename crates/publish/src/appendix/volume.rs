//! The sum of the volumes over the representatives: it is the volume of the domain.

use super::columns::width;
use super::subject::Analysis;
use acutile_core::tiling::Domain;
use acutile_exact::number::Number;
use malachite::Rational;

/// A sum with more terms is not written out.
const LONGEST_SUM: usize = 60;

/// The volume sum over the representatives; nothing for a region.
pub fn volume<const D: usize>(analysis: &Analysis<D>) -> String {
    if analysis.tiling.frame.domain.is_region() {
        return String::new();
    }
    let numerals = &analysis.numerals;
    let mut counts: Vec<(Number, usize)> = Vec::new();
    for &place in &analysis.order {
        let representative = &analysis.orbits.representatives[place];
        let determinant = analysis.tiling.shape(representative.tile).determinant;
        match counts.iter_mut().find(|(other, _)| *other == determinant) {
            Some((_, count)) => *count += representative.count,
            None => counts.push((determinant, representative.count)),
        }
    }
    let sum = counts.iter().fold(Number::zero(), |sum, (det, count)| {
        sum + det * &Number::from(Rational::from(*count))
    });
    let terms: Vec<String> = if counts.len() > LONGEST_SUM {
        vec!["\\sum_m\\frac h{s_m}\\det S_m".to_owned()]
    } else {
        counts
            .iter()
            .map(|(det, count)| format!("{count}\\cdot {}", numerals.factor(det)))
            .collect()
    };
    let factorial: u32 = (1..=D as u32).product();
    let meaning = match &analysis.tiling.frame.domain {
        Domain::Space => format!("which is ${D}!$ times the volume of a cell, in cells"),
        Domain::Region(_) => String::new(),
        Domain::Slab(polytope) | Domain::Prism(polytope) | Domain::Solid(polytope) => {
            let k: u32 = (1..=polytope.dimension() as u32).product();
            let volume = polytope.scaled_volume() * Number::from(Rational::from_unsigneds(1u32, k));
            let volume_text = numerals.inline(&volume);
            let expected = &volume * &Number::from(Rational::from(factorial));
            debug_assert!(expected == sum);
            match analysis.rank() {
                0 => format!(
                    "which is ${D}!$ times the volume ${volume_text}$ of the domain in basis coordinates"
                ),
                _ => format!(
                    "which is ${D}!$ times the volume of the domain for a cell of the lattice, ${volume_text}$ in basis coordinates"
                ),
            }
        }
    };
    let images = if analysis.orbits.elements.len() > 1 {
        "images"
    } else {
        "tiles"
    };
    format!(
        "\\acutileparagraph{{Volume (V).}} The sum of the determinants of Table~\\ref{{{}}}, with the number of {images} for each value, is\n\
         % acutile:volume {}\n{}{meaning}.\n\n",
        analysis.label("orbits"),
        analysis.subject.slug(),
        display_sum(terms.iter().map(String::as_str), &numerals.number(&sum)),
    )
}

/// Lines of a display; a longer one does not fit on a page.
const LINES: usize = 12;

/// A sum of terms in displays, broken where a line is full.
fn display_sum<'t>(terms: impl Iterator<Item = &'t str>, total: &str) -> String {
    let mut lines = vec![String::new()];
    let mut letters = 0;
    for (index, text) in terms.enumerate() {
        let wide = width(text) + 3;
        if letters + wide > 70 && letters > 0 {
            lines.push("\\quad{}".to_owned());
            letters = 0;
        }
        let plus = if index > 0 { "+" } else { "" };
        let line = lines.len() - 1;
        lines[line].push_str(&format!("{plus}{text}"));
        letters += wide;
    }
    if let Some(last) = lines.last_mut() {
        last.push_str(&format!("={total},"));
    }
    let displays = lines.chunks(LINES).map(|lines| {
        format!(
            "\\[ \\acutilefit{{$\\begin{{aligned}}\n&{}\n\\end{{aligned}}$}} \\]\n",
            lines.join("\\\\\n&")
        )
    });
    displays.collect()
}
