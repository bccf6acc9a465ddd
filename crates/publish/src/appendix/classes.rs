//! The congruence classes: edges, volume, dihedral angles, and the sign computation that
//! shows each angle to be acute.
//!
//! Let M be the matrix of the inner products of the edges e_1, …, e_D from corner 0, and C its
//! cofactors. The gradients of the barycentric coordinates have <g_i, g_j> = C_ij / det M for
//! i, j >= 1, and g_0 = -(g_1 + … + g_D). M follows from the squared edges. A positive
//! factor makes the entries of Q, a multiple of M, integers without a common divisor; the
//! numbers N_ij printed are the cofactors of Q, continued to i = 0. So a reader needs
//! nothing but six squared lengths and 2 x 2 minors.

use super::columns::width;
use super::rational::interval;
use super::subject::Analysis;
use super::tex::{counted, fits, matrix, simplices, table_fits, tabular};
use acutile_core::quality::{DihedralAngle, Exact, measures};
use acutile_core::tiling::SimplexId;
use acutile_exact::geometry::linear;
use acutile_exact::number::Number;
use malachite::Rational;
use std::cmp::Ordering;

/// The section on classes, with their figures.
pub fn classes<const D: usize>(analysis: &Analysis<D>, figures: &str) -> String {
    let blocks: String = (0..analysis.shapes.len())
        .map(|class| block(analysis, class))
        .collect();
    format!("{}{figures}{blocks}", how_to_check::<D>())
}

fn how_to_check<const D: usize>() -> String {
    let (angle, formula) = match D {
        2 => (
            "angle at corner $k$",
            "$q_{12}=\\lambda(l_{01}+l_{02}-l_{12})$",
        ),
        _ => (
            "dihedral angle at the edge $kl$",
            "$q_{ij}=\\lambda(l_{0i}+l_{0j}-l_{ij})$",
        ),
    };
    let pair = if D == 2 {
        "$\\{i,j,k\\}=\\{0,1,2\\}$"
    } else {
        "$\\{i,j,k,l\\}=\\{0,1,2,3\\}$"
    };
    format!(
        "Write $l_{{ij}}$ for the squared length of the edge between the corners $i$ and $j$. Up to a factor the inner products of the edges \
         from corner $0$ are $q_{{ii}}=2\\lambda l_{{0i}}$ and {formula}; a number $\\lambda>0$ is chosen that makes these small integers of \
         the field. Let $N_{{ij}}$, for $i,j\\ge1$, be the cofactors of the matrix $Q=(q_{{ij}})$, divided by a common factor where there is one, and let the other $N_{{ij}}=N_{{ji}}$ be such that all sums \
         $\\sum_j N_{{ij}}$ are zero. Then $N_{{ij}}$ is a positive multiple of $\\langle g_i,g_j\\rangle$, and the {angle}, {pair}, between the facets opposite \
         to the corners $i$ and $j$ has $\\cos\\theta=-N_{{ij}}/\\sqrt{{N_{{ii}}N_{{jj}}}}$ (Lemma~\\ref{{acutile:angles}}). It is acute if and only if $N_{{ij}}<0$.\n\n"
    )
}

fn block<const D: usize>(analysis: &Analysis<D>, class: usize) -> String {
    let shape = &analysis.shapes[class];
    let first = shape.members[0];
    let edges = &analysis.edges[first.index()];
    let (count, orbits) = (shape.members.len(), orbits_in(analysis, &shape.members));
    let signs = Signs::of::<D>(analysis, edges);
    let factorial: i64 = (1..=D as i64).product();
    let volume = analysis.tiling.shape(first).determinant
        * Number::from(Rational::from_signeds(1, factorial));
    format!(
        "\\begin{{acutilekeep}}\n\\acutileparagraph{{Class {class}.}} ${count}$ {kind} in {orbits}, {each}of volume ${volume}$ cells; the first is $T_{{{first}}}$. Squared edges:\n\
         % acutile:edges {slug} {class}\n{edges}.\n{radius}{signs}{table}\\end{{acutilekeep}}\n\n",
        kind = simplices(D, count),
        orbits = counted(orbits, "orbit"),
        each = if count == 1 { "" } else { "each " },
        volume = analysis.numerals.inline(&volume),
        slug = analysis.subject.slug(),
        edges = squared_edges::<D>(analysis, edges),
        radius = radius(analysis, first, edges),
        signs = signs.matrices(analysis),
        table = signs.table(analysis, class, first),
    )
}

/// The squared circumradius, the shortest squared edge and their quotient.
fn radius<const D: usize>(analysis: &Analysis<D>, first: SimplexId, edges: &[Number]) -> String {
    let (Some(ratio), Some(shortest)) = (
        measures(analysis.tiling, first).map(|m| m.radius_edge.square),
        edges.iter().min(),
    ) else {
        return String::new();
    };
    let numerals = &analysis.numerals;
    format!(
        "The shortest is $l={}$. The squared circumradius is $R^2={}$, and $R^2/l={}$.\n",
        numerals.inline(shortest),
        numerals.inline(&(&ratio * shortest)),
        numerals.inline(&ratio),
    )
}

fn orbits_in<const D: usize>(analysis: &Analysis<D>, members: &[SimplexId]) -> usize {
    let mut orbits: Vec<usize> = members
        .iter()
        .map(|m| analysis.orbits.images[m.index()].representative)
        .collect();
    orbits.sort_unstable();
    orbits.dedup();
    orbits.len()
}

/// Pairs i < j in the order of edges.
pub fn pairs<const D: usize>() -> Vec<(usize, usize)> {
    (0..=D)
        .flat_map(|i| (i + 1..=D).map(move |j| (i, j)))
        .collect()
}

/// The facets i < j at each angle, in the order of the edges 01, 02, … or corners 0, 1, … where the
/// angles are.
fn facet_pairs<const D: usize>() -> Vec<(usize, usize)> {
    let mut pairs = pairs::<D>();
    pairs.reverse();
    pairs
}

fn squared_edges<const D: usize>(analysis: &Analysis<D>, edges: &[Number]) -> String {
    let items: Vec<String> = pairs::<D>()
        .iter()
        .zip(edges)
        .map(|((i, j), edge)| format!("$l_{{{i}{j}}}={}$", analysis.numerals.inline(edge)))
        .collect();
    items.join(", ")
}

/// Letters in a line of display.
const LINE: usize = 64;

/// λ, Q and N of a class.
struct Signs {
    factor: Rational,
    /// Q, D rows.
    inner: Vec<Vec<Number>>,
    /// N, D + 1 rows.
    normals: Vec<Vec<Number>>,
    /// The number that the cofactors of Q were divided by to give N.
    divisor: Rational,
}

impl Signs {
    fn of<const D: usize>(analysis: &Analysis<D>, edges: &[Number]) -> Signs {
        let length = |i: usize, j: usize| {
            let place = pairs::<D>().iter().position(|&p| p == (i.min(j), i.max(j)));
            place.map_or_else(Number::zero, |place| edges[place].clone())
        };
        let doubled: [[Number; D]; D] = std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                &(&length(0, i + 1) + &length(0, j + 1)) - &length(i + 1, j + 1)
            })
        });
        let entries: Vec<Number> = doubled.iter().flatten().cloned().collect();
        let factor = analysis.numerals.primitive_factor(&entries);
        let inner: [[Number; D]; D] = std::array::from_fn(|i| {
            std::array::from_fn(|j| &doubled[i][j] * &Number::from(factor.clone()))
        });
        let cofactors = continued(&linear::cofactors(&inner));
        let reduction = analysis.numerals.primitive_factor(&cofactors.concat());
        let scale = Number::from(reduction.clone());
        Signs {
            normals: cofactors
                .iter()
                .map(|row| row.iter().map(|x| x * &scale).collect())
                .collect(),
            divisor: Rational::from(1) / reduction,
            inner: inner.iter().map(|row| row.to_vec()).collect(),
            factor,
        }
    }

    /// λ, Q and N, as matrices where they fit.
    fn matrices<const D: usize>(&self, analysis: &Analysis<D>) -> String {
        let numerals = &analysis.numerals;
        let text = |rows: &[Vec<Number>]| -> Vec<Vec<String>> {
            rows.iter()
                .map(|row| row.iter().map(|x| numerals.number(x)).collect())
                .collect()
        };
        let (inner, normals) = (text(&self.inner), text(&self.normals));
        let lambda = super::rational::rational(&self.factor);
        let both: Vec<Vec<String>> = inner
            .iter()
            .zip(&normals)
            .map(|(a, b)| [&a[..], &b[..]].concat())
            .collect();
        let (first, second) = match (fits(&both, LINE), fits(&normals, LINE)) {
            (true, _) => (
                format!("\\[ \\acutilefit{{$Q={},\\qquad ", matrix(&inner)),
                format!("N={}.$}} \\]", matrix(&normals)),
            ),
            (false, true) => (
                format!("\\[ \\acutilefit{{$Q={},$}} \\]\n", matrix(&inner)),
                format!("\\[ \\acutilefit{{$N={}.$}} \\]", matrix(&normals)),
            ),
            _ => (
                entries("q", &inner, 1, true) + "; ",
                entries("N", &normals, 0, false) + ".\n",
            ),
        };
        let divided = if self.divisor == 1u32 {
            String::new()
        } else {
            format!(
                ", and the cofactors divided by ${}$",
                super::rational::rational(&self.divisor)
            )
        };
        format!(
            "With $\\lambda={lambda}${divided}:\n% acutile:matrices {}\n{first}{second}\n",
            analysis.subject.slug()
        )
    }

    /// One row for each angle: its sign, and why; its cosine, and the angle. Where that is too
    /// wide the reasons stand in a table of their own.
    fn table<const D: usize>(
        &self,
        analysis: &Analysis<D>,
        class: usize,
        first: SimplexId,
    ) -> String {
        let products = analysis.products(first);
        let pairs = facet_pairs::<D>();
        let signs: Vec<[String; 2]> = pairs.iter().map(|&p| self.sign(analysis, p)).collect();
        let cosines: Vec<[String; 3]> = pairs
            .iter()
            .map(|&(i, j)| {
                let angle = DihedralAngle::between(&products, i, j);
                let angle = angle.expect("no simplex of a proved tiling is flat");
                cosine_cells(analysis, (i, j), &angle)
            })
            .collect();
        let mark = format!("angles {} {class}", analysis.subject.slug());
        let place = if D == 2 { "at" } else { "edge" };
        let names: Vec<String> = pairs.iter().map(|&(i, j)| edge_name::<D>(i, j)).collect();
        let values = "$\\cos\\theta$ & enclosed in & $\\theta$ in degrees";
        let join =
            |name: &String, cells: &[&[String]]| format!("{name} & {}", cells.concat().join(" & "));
        let has_reasons = signs.iter().any(|[_, reason]| !reason.is_empty());
        let widths: Vec<Vec<&str>> = signs
            .iter()
            .zip(&cosines)
            .map(|(a, b)| a.iter().chain(b).map(String::as_str).collect())
            .collect();
        if !has_reasons && table_fits(&widths) {
            let rows: Vec<String> = (0..names.len())
                .map(|k| join(&names[k], &[&signs[k][..1], &cosines[k]]))
                .collect();
            return tabular(&mark, "rlccc", &format!("{place} & sign & {values}"), &rows);
        }
        let (columns, because) = if has_reasons {
            (2, " & because")
        } else {
            (1, "")
        };
        let reasons: Vec<String> = (0..names.len())
            .map(|k| join(&names[k], &[&signs[k][..columns]]))
            .collect();
        let angles: Vec<String> = (0..names.len())
            .map(|k| join(&names[k], &[&cosines[k]]))
            .collect();
        tabular(
            &mark.replace("angles", "signs"),
            "rll",
            &format!("{place} & sign{because}"),
            &reasons,
        ) + &tabular(&mark, "rccc", &format!("{place} & {values}"), &angles)
    }

    /// `N_{01}=-3<0`, and why where that is not seen.
    fn sign<const D: usize>(&self, analysis: &Analysis<D>, (i, j): (usize, usize)) -> [String; 2] {
        let n = &self.normals[i][j];
        let sign = match n.sign() {
            Ordering::Less => "<0",
            Ordering::Equal => "",
            Ordering::Greater => ">0",
        };
        let reason = analysis.numerals.why(n);
        let reason = if reason.is_empty() {
            reason
        } else {
            format!("${reason}$")
        };
        [
            format!("$N_{{{i}{j}}}={}{sign}$", analysis.numerals.inline(n)),
            reason,
        ]
    }
}

/// The corners of the edge in which the facets i and j meet.
pub fn edge_name<const D: usize>(i: usize, j: usize) -> String {
    let others = (0..=D).filter(|k| *k != i && *k != j);
    format!("${}$", others.map(|k| k.to_string()).collect::<String>())
}

/// cos θ exactly, cos θ enclosed, θ enclosed. A cosine that is too long to be written stands
/// as the quotient that defines it.
fn cosine_cells<const D: usize>(
    analysis: &Analysis<D>,
    (i, j): (usize, usize),
    angle: &DihedralAngle,
) -> [String; 3] {
    let exact = cosine(analysis, angle);
    let exact = if width(&exact) > WIDE {
        format!("-N_{{{i}{j}}}/\\sqrt{{N_{{{i}{i}}}N_{{{j}{j}}}}}")
    } else {
        exact
    };
    let degrees = angle.enclosure(&Rational::from_signeds(1, 1_000_000_000));
    [exact, interval(&cosine_bounds(angle)), interval(&degrees)].map(|cell| format!("${cell}$"))
}

/// Letters of a cosine in a table.
const WIDE: usize = 30;

/// The cofactors C_ij, i, j >= 1, as N_ij, continued to i, j >= 0 by zero sums.
fn continued<const D: usize>(cofactors: &[[Number; D]; D]) -> Vec<Vec<Number>> {
    let sum = |row: &[Number]| row.iter().fold(Number::zero(), |sum, x| &sum + x);
    let first: Vec<Number> = cofactors.iter().map(|row| -&sum(row)).collect();
    let corner = -&sum(&first);
    let mut rows = vec![[vec![corner], first.clone()].concat()];
    for (row, start) in cofactors.iter().zip(first) {
        rows.push([vec![start], row.to_vec()].concat());
    }
    rows
}

/// `q_{11}=…, …` for the entries i <= j, or those on the diagonal only.
fn entries(name: &str, rows: &[Vec<String>], from: usize, all: bool) -> String {
    let n = rows.len();
    let mut items = Vec::new();
    for i in 0..n {
        for j in i..if all { n } else { i + 1 } {
            items.push(format!(
                "${name}_{{{}{}}}={}$",
                i + from,
                j + from,
                rows[i][j]
            ));
        }
    }
    items.join(", ")
}

/// cos θ, exactly.
fn cosine<const D: usize>(analysis: &Analysis<D>, angle: &DihedralAngle) -> String {
    let root = analysis.numerals.root(&angle.signed_square.abs());
    match angle.signed_square.sign() {
        Ordering::Less => format!("-{root}"),
        _ => root,
    }
}

/// Bounds of cos θ; the value itself where it is rational.
pub fn cosine_bounds(angle: &DihedralAngle) -> (Rational, Rational) {
    let square = angle.signed_square.abs();
    let (low, high) = match square
        .to_rational()
        .and_then(malachite::base::num::arithmetic::traits::CheckedSqrt::checked_sqrt)
    {
        Some(root) => (root.clone(), root),
        None => square.enclosure_of_root(&Rational::from_signeds(1, 1_000_000_000)),
    };
    match angle.signed_square.sign() {
        Ordering::Less => (-high, -low),
        _ => (low, high),
    }
}
