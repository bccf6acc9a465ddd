//! What is claimed beyond tiling and acuteness: bounds of angles and ratios, Delaunay, TCP,
//! each with the numbers that show it.

use super::LONG;
use super::classes::{cosine_bounds, edge_name};
use super::pairing::behind;
use super::rational::interval;
use super::subject::{Analysis, first_and_count};
use super::tex::{Table, list, width};
use acutile_core::quality::{DihedralAngle, Exact, RadiusEdge};
use acutile_core::statement::{Relation, Statement};
use acutile_core::tiling::{Facet, FacetId};
use acutile_exact::geometry::linear;
use acutile_exact::number::Number;
use malachite::Rational;
use std::collections::BTreeMap;

/// A paragraph for each statement that has one. The table of powers for Delaunay shows weakly
/// Delaunay, too.
pub fn statements<const D: usize>(analysis: &Analysis<D>) -> String {
    let statements = analysis.subject.statements();
    let is_strict = statements.contains(&Statement::Delaunay);
    let paragraphs = statements.iter().map(|statement| match statement {
        Statement::LargestAngle(Relation::Maximum, angle) => extreme_angle(analysis, angle, true),
        Statement::SmallestAngle(Relation::Minimum, angle) => extreme_angle(analysis, angle, false),
        Statement::RadiusEdge(Relation::Maximum, ratio) => radius_edge(analysis, ratio),
        Statement::Delaunay => delaunay(analysis, true),
        Statement::WeaklyDelaunay if !is_strict => delaunay(analysis, false),
        Statement::Tcp => close_packed(analysis),
        _ => String::new(),
    });
    paragraphs.collect()
}

/// The largest or the smallest angle: where it is, its cosine, and its size in degrees.
fn extreme_angle<const D: usize>(
    analysis: &Analysis<D>,
    angle: &DihedralAngle,
    is_largest: bool,
) -> String {
    let Some((class, (i, j))) = place(analysis, angle) else {
        return String::new();
    };
    let word = if is_largest { "largest" } else { "smallest" };
    let sign = if angle.against_right().is_gt() {
        "-"
    } else {
        ""
    };
    let exact = analysis.numerals.root(&angle.signed_square.abs());
    let bounds = interval(&cosine_bounds(angle));
    let value = match (width(&exact) > WIDE, bounds.starts_with('[')) {
        (true, _) => relation_to(&bounds),
        (false, true) => format!("={sign}{exact}\\in{bounds}"),
        (false, false) => format!("={sign}{exact}"),
    };
    format!(
        "\\acutileparagraph{{The {word} angle}} $\\theta$ (class {class}, {place} {edge}) has $\\cos\\theta{value}$ and, in degrees, $\\theta{degrees}$.\n\n",
        place = if D == 2 { "corner" } else { "edge" },
        edge = edge_name::<D>(i, j),
        degrees = relation_to(&interval(&angle.enclosure(&fine()))),
    )
}

/// `=0.5`, or `\in[…]`.
fn relation_to(bounds: &str) -> String {
    let relation = if bounds.starts_with('[') { "\\in" } else { "=" };
    format!("{relation}{bounds}")
}

/// The first class with this angle, and the facets between which it is in the class's first
/// simplex.
fn place<const D: usize>(
    analysis: &Analysis<D>,
    angle: &DihedralAngle,
) -> Option<(usize, (usize, usize))> {
    let mut classes = analysis.shapes.iter().enumerate();
    classes.find_map(|(class, shape)| {
        let products = analysis.products(shape.members[0]);
        let mut pairs = (0..=D).flat_map(|i| (i + 1..=D).map(move |j| (i, j)));
        let pair = pairs
            .find(|(i, j)| DihedralAngle::between(&products, *i, *j).as_ref() == Some(angle))?;
        Some((class, pair))
    })
}

fn fine() -> Rational {
    Rational::from_signeds(1, 1_000_000_000)
}

/// The largest ratio of circumradius and shortest edge, by its square.
fn radius_edge<const D: usize>(analysis: &Analysis<D>, largest: &RadiusEdge) -> String {
    let exact = analysis.numerals.inline(&largest.square);
    let value = match width(&exact) > WIDE {
        true => format!("\\in{}", analysis.numerals.enclosed(&largest.square)),
        false => format!("={exact}"),
    };
    format!(
        "\\acutileparagraph{{Circumradii.}} With the squared edges $l$ and the cofactors $C$ of $M=(\\langle e_i,e_j\\rangle)$ the squared circumradius is $\\sum_{{i,j}} \
         l_{{0i}}C_{{ij}}l_{{0j}}/(4\\det M)$. For the largest ratio $\\sigma$ of circumradius and shortest edge, $\\sigma^2{value}$. Approximately, $\\sigma{}$.\n\n",
        relation_to(&interval(&largest.enclosure(&fine()))),
    )
}

/// The power of the corner behind each facet, one facet of each orbit.
fn delaunay<const D: usize>(analysis: &Analysis<D>, is_strict: bool) -> String {
    let facets = &analysis.symmetry.facets;
    let inner: Vec<(Facet, usize)> = first_and_count(facets)
        .into_iter()
        .map(|(first, count)| (Facet::numbered::<D>(FacetId::at(first)), count))
        .filter(|(facet, _)| analysis.matching.neighbour(*facet).is_some())
        .collect();
    if inner.is_empty() {
        return "\\acutileparagraph{Delaunay.} All facets are in the boundary, so nothing is to be checked in \
                Theorem~\\ref{acutile:delaunay}.\n\n"
            .to_owned();
    }
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
        "\\acutileparagraph{{Delaunay.}} By Theorem~\\ref{{acutile:delaunay}} it suffices that for each facet the corner $d$ of the tile behind it is {lemma} the circumsphere: \
         that its power $\\pi(d)=|d-z|^2-\\rho^2$, for the circumcentre $z$ and the circumradius $\\rho$, is {relation}. With $x=d-c_0$ it is \
         $|x|^2-\\sum_i\\lambda_i(x)\\,l_{{0i}}$, where $x=\\sum_i\\lambda_i(x)e_i$. Table~\\ref{{{}}} has one facet of each orbit, seen from \
         one of its two sides. That suffices: with $S$ and $T$ on the two sides of a facet, $\\pi_S-\\pi_T$ is affine and vanishes on the hyperplane of the facet; \
         the corners $d$ of $T$ and $c$ of $S$ off the facet lie on different sides of it, and $\\pi_T(d)=\\pi_S(c)=0$. So $\\pi_S(d)$ and $\\pi_T(c)$ have the same sign.\n\n{}",
        analysis.label("delaunay"),
        Table {
            mark: format!("delaunay {}", analysis.subject.slug()),
            columns: "rrrl",
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
    facet: Facet,
    halves: usize,
) -> Option<String> {
    let Facet { simplex, opposite } = facet;
    let power = power(analysis, facet)?;
    let why = analysis.numerals.why(&power);
    let value = analysis.numerals.inline(&power);
    let value = match (why.is_empty(), width(&value) + width(&why) > 46) {
        (_, true) => format!("\\in{}", analysis.numerals.enclosed(&power)),
        (true, _) => value,
        (false, _) => format!("{value}\\quad({why})"),
    };
    Some(format!(
        "${simplex}_{{{opposite}}}$ & {} & ${}$ & ${value}$",
        halves / 2,
        behind(analysis, facet),
    ))
}

/// An exact number with more letters gives place to a decimal enclosure in a table.
const WIDE: usize = 30;

/// The power of the corner behind a facet; `None` at the boundary.
fn power<const D: usize>(analysis: &Analysis<D>, facet: Facet) -> Option<Number> {
    let tiling = analysis.tiling;
    let simplex = facet.simplex;
    let mate = analysis.matching.mate(tiling, facet)?;
    let behind = tiling.simplex(mate.facet.simplex)[usize::from(mate.facet.opposite)];
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
        "\\acutileparagraph{{Tetrahedrally close packed.}} Up to $\\Lambda$ there are ${}$ edges. Of these {}, and no triangle has two edges \
         that are in $6$ (checked for all, in the certificate). So the tiling is tetrahedrally close packed as defined by Sullivan~\\cite{{Sullivan1999}}, and it follows that each vertex has one of the four stars of Frank and Kasper~\\cite{{FrankKasper1958}}, with $12$, $14$, $15$ or $16$ neighbours \
         and as many edges of valence six as exceed $12$; a cell has {}.\n\n",
        analysis.ridges.list.len(),
        list(&valences),
        list(&stars)
    )
}

fn star_counts<const D: usize>(analysis: &Analysis<D>) -> BTreeMap<String, usize> {
    let mut counts = BTreeMap::new();
    if let acutile_core::tiling::AnyTiling::Space(tiling) = &analysis.subject.tiling {
        for star in acutile_core::classify::stars(tiling) {
            let name = match star {
                acutile_core::classify::Star::FrankKasper(n) => format!("$Z_{{{n}}}$"),
                other => other.to_string(),
            };
            *counts.entry(name).or_insert(0) += 1;
        }
    }
    counts
}
