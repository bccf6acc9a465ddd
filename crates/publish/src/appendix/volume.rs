//! The sum of the volumes, class by class: it is the volume of the domain.

use super::subject::Analysis;
use super::tex::width;
use acutile_core::tiling::Domain;
use acutile_exact::number::Number;
use malachite::Rational;

/// The volume sum over classes.
pub fn volume<const D: usize>(analysis: &Analysis<D>) -> String {
    let numerals = &analysis.numerals;
    let terms: Vec<(String, Number)> = analysis
        .shapes
        .iter()
        .map(|shape| {
            let determinant = analysis.tiling.shape(shape.members[0]).determinant;
            let count = shape.members.len();
            let total = &determinant * &Number::from(Rational::from(count));
            (
                format!("{count}\\cdot {}", numerals.factor(&determinant)),
                total,
            )
        })
        .collect();
    let sum = terms
        .iter()
        .fold(Number::zero(), |sum, (_, term)| &sum + term);
    let factorial: u32 = (1..=D as u32).product();
    let meaning = match &analysis.tiling.frame.domain {
        Domain::Space => format!("which is ${D}!$ times the volume of a cell, in cells"),
        Domain::Region(_) => format!("which is ${D}!$ times the volume of the region, in cells"),
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
    format!(
        "\\acutileparagraph{{Volume.}} All determinants, {factorial} times the volumes in cells, are positive. Their sum, class by class, is\n\
         % acutile:volume {}\n{}{meaning}.\n\n",
        analysis.subject.slug(),
        display_sum(
            terms.iter().map(|(text, _)| text.as_str()),
            &numerals.number(&sum)
        ),
    )
}

/// A sum of terms in a display, broken where a line is full.
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
    format!(
        "\\[\\begin{{aligned}}\n&{}={total},\n\\end{{aligned}}\\]\n",
        lines.join("\\\\\n&")
    )
}
