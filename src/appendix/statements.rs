//! What is claimed beyond tiling and acuteness: bounds of angles and ratios, Delaunay, TCP,
//! each with the numbers that show it.

use super::LONG;
use super::classes::cosine_bounds;
use super::numeral::{interval, rational};
use super::pairing::behind;
use super::subject::{Analysis, first_and_count};
use super::tex::{Table, list};
use super::theorem::bound;
use crate::certificate::Statement;
use crate::geometry::linear;
use crate::number::{Number, enclosure};
use crate::quality::{DihedralAngle, Exact, RadiusEdge, measures_of_shapes};
use malachite::Rational;
use std::collections::BTreeMap;
use std::str::FromStr;

/// A paragraph for each statement that has one.
pub fn statements<const D: usize>(analysis: &Analysis<D>) -> String {
    let paragraphs = analysis
        .subject
        .statements()
        .iter()
        .map(|statement| match statement {
            Statement::FaceToFaceTiling | Statement::Acute | Statement::Nonobtuse => String::new(),
            Statement::DihedralBelow(q) => angle_bound(analysis, q, true),
            Statement::DihedralAbove(q) => angle_bound(analysis, q, false),
            Statement::RadiusEdgeBelow(q) => radius_edge(analysis, q),
            Statement::Delaunay => delaunay(analysis, true),
            Statement::WeaklyDelaunay => delaunay(analysis, false),
            Statement::Tcp => close_packed(analysis),
        });
    paragraphs.collect()
}

/// The extreme angle against a bound: cos θ on the right side of cos Q.
fn angle_bound<const D: usize>(analysis: &Analysis<D>, q: &str, is_below: bool) -> String {
    let angles = measures_of_shapes(analysis.tiling, &analysis.shapes)
        .into_iter()
        .flat_map(|measures| measures.angles);
    let extreme: Option<DihedralAngle> = match is_below {
        true => angles.max(),
        false => angles.min(),
    };
    let (Some(extreme), Ok(degrees)) = (extreme, Rational::from_str(q)) else {
        return String::new();
    };
    let cosine = enclosure::cos_of_degrees(&degrees, &fine());
    let (word, relation) = match is_below {
        true => ("largest", '>'),
        false => ("smallest", '<'),
    };
    let square = extreme.signed_square.abs();
    let sign = if extreme.signed_square.sign().is_lt() {
        "-"
    } else {
        ""
    };
    let value = analysis.numerals.root(&square);
    let bounds = interval(&cosine_bounds(&extreme));
    let value = match extreme.signed_square.is_zero() || value == bounds {
        true => format!("{sign}{value}"),
        false => format!("{sign}{value}\\in{bounds}"),
    };
    format!(
        "\\paragraph{{The {word} angle}} $\\theta$ has $\\cos\\theta={value}$, so $\\theta$ is in ${}$ degrees. It is {} than \
         ${bound}^\\circ$: $\\cos\\theta{relation}\\cos{bound}^\\circ\\in{}$.\n\n",
        interval(&extreme.enclosure(&fine())),
        if is_below { "less" } else { "more" },
        interval(&cosine),
        bound = bound(q),
    )
}

fn fine() -> Rational {
    Rational::from_signeds(1, 1_000_000_000)
}

/// The largest ratio of circumradius and shortest edge, by its square.
fn radius_edge<const D: usize>(analysis: &Analysis<D>, q: &str) -> String {
    let ratios = measures_of_shapes(analysis.tiling, &analysis.shapes)
        .into_iter()
        .map(|measures| measures.radius_edge);
    let (Some(largest), Ok(limit)): (Option<RadiusEdge>, _) = (ratios.max(), Rational::from_str(q))
    else {
        return String::new();
    };
    let square = &limit * &limit;
    let difference = &largest.square - &Number::from(square.clone());
    let why = analysis.numerals.why_negative(&difference);
    format!(
        "\\paragraph{{Circumradii.}} With the squared edges $l$ and the cofactors $C$ of $M=(\\langle e_i,e_j\\rangle)$ the squared circumradius is $\\sum_{{i,j}} \
         l_{{0i}}C_{{ij}}l_{{0j}}/(4\\det M)$. The largest ratio of circumradius and shortest edge has the square \
         ${}<{}$, the square of ${}$; it is in ${}${}.\n\n",
        analysis.numerals.inline(&largest.square),
        rational(&square),
        bound(q),
        interval(&largest.enclosure(&fine())),
        match why.is_empty() {
            true => String::new(),
            false => format!(
                " (difference ${}$: ${why}$)",
                analysis.numerals.inline(&difference)
            ),
        }
    )
}

/// The power of the corner behind each facet, one facet of each orbit.
fn delaunay<const D: usize>(analysis: &Analysis<D>, is_strict: bool) -> String {
    let facets = &analysis.symmetry.facets;
    let all: Vec<(usize, usize)> = first_and_count(facets);
    let inner: Vec<(usize, usize)> = all
        .into_iter()
        .filter(|(facet, _)| analysis.matching.mates[*facet].is_some())
        .collect();
    let rows: Vec<String> = inner
        .iter()
        .take(LONG)
        .filter_map(|&(facet, count)| power_row(analysis, facet, count))
        .collect();
    let omitted = match inner.len() > LONG {
        true => format!(
            " The first ${LONG}$ of ${}$ orbits; \\texttt{{acutile}} has checked all.",
            inner.len()
        ),
        false => String::new(),
    };
    let (relation, lemma) = match is_strict {
        true => ("positive", "outside of"),
        false => ("nonnegative", "not inside of"),
    };
    format!(
        "\\paragraph{{Delaunay.}} By Theorem~\\ref{{acutile:delaunay}} it suffices that for each facet the corner $d$ of the tile behind it is {lemma} the circumsphere: \
         that its power $\\pi(d)=|d-z|^2-\\rho^2$, for the circumcentre $z$ and the circumradius $\\rho$, is {relation}. With $x=d-c_0$ it is \
         $|x|^2-\\sum_i\\lambda_i(x)\\,l_{{0i}}$, where $x=\\sum_i\\lambda_i(x)e_i$. Table~\\ref{{{}}} has one facet of each orbit.\n\n{}",
        analysis.label("delaunay"),
        Table {
            mark: format!("delaunay {}", analysis.subject.slug()),
            columns: "rrrr",
            caption: format!(
                "One facet of each orbit, how many a cell has, what is behind it, and the power of the corner there.{omitted}"
            ),
            label: analysis.label("delaunay"),
            heading: "facet & number & behind & power".to_owned(),
            rows,
        }
        .tex()
    )
}

fn power_row<const D: usize>(
    analysis: &Analysis<D>,
    facet: usize,
    halves: usize,
) -> Option<String> {
    let (simplex, opposite) = (facet / (D + 1), facet % (D + 1));
    let power = power(analysis, simplex, opposite)?;
    let why = analysis.numerals.why_negative(&-&power);
    let why = match why.is_empty() {
        true => String::new(),
        false => format!(" \\quad({why})"),
    };
    Some(format!(
        "${simplex}_{{{opposite}}}$ & {} & ${}$ & ${}{why}$",
        halves / 2,
        behind(analysis, simplex, opposite),
        analysis.numerals.inline(&power)
    ))
}

/// The power of the corner behind a facet; `None` at the boundary.
fn power<const D: usize>(
    analysis: &Analysis<D>,
    simplex: usize,
    opposite: usize,
) -> Option<Number> {
    let tiling = analysis.tiling;
    let mate = analysis.matching.mates[simplex * (D + 1) + opposite].as_ref()?;
    let behind = tiling.simplex(mate.facet.simplex as usize)[usize::from(mate.facet.opposite)];
    let origin = tiling.position(&tiling.simplex(simplex)[0]);
    let offset = linear::subtract(&tiling.position(&behind.moved(mate.shift)), &origin);
    let shape = tiling.shape(simplex);
    shape
        .power(&tiling.frame.gram, &offset)
        .divide(&shape.determinant)
}

/// Valences of edges, and stars of vertices.
fn close_packed<const D: usize>(analysis: &Analysis<D>) -> String {
    let valences: Vec<String> = analysis
        .ridges
        .valence_counts()
        .iter()
        .map(|(valence, count)| format!("${count}$ are in ${valence}$ tetrahedra"))
        .collect();
    let stars: Vec<String> = star_counts(analysis)
        .iter()
        .map(|(star, count)| format!("${count}$ of type {star}"))
        .collect();
    format!(
        "\\paragraph{{Tetrahedrally close packed.}} Up to $\\Lambda$ there are ${}$ edges. Of these {}, and no triangle has two edges \
         that are in $6$ (checked for all, in the certificate). So the tiling is tetrahedrally close packed as defined by Sullivan~\\cite{{Sullivan1999}}, and it follows that each vertex has one of the four stars of Frank and Kasper~\\cite{{FrankKasper1958}}, with $12$, $14$, $15$ or $16$ neighbours \
         and as many edges of valence six as exceed $12$; a cell has {}.\n\n",
        analysis.ridges.list.len(),
        list(&valences),
        list(&stars)
    )
}

fn star_counts<const D: usize>(analysis: &Analysis<D>) -> BTreeMap<String, usize> {
    let mut counts = BTreeMap::new();
    if let crate::tiling::AnyTiling::Space(tiling) = &analysis.subject.tiling {
        for star in crate::classify::stars(tiling) {
            let name = match star {
                crate::classify::Star::FrankKasper(n) => format!("$Z_{{{n}}}$"),
                other => other.to_string(),
            };
            *counts.entry(name).or_insert(0) += 1;
        }
    }
    counts
}
