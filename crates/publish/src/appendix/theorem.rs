//! What is proved, in words and exact numbers; field, lattice and metric.

use super::rational::{interval, rational};
use super::subject::{Analysis, Subject};
use super::tex::{counted, escape, list, simplices, width};
use acutile_core::quality::{DihedralAngle, Exact, RadiusEdge};
use acutile_core::statement::{Relation, Statement};
use acutile_core::tiling::{Domain, Polytope};
use acutile_exact::geometry::linear;
use acutile_exact::number::Number;
use malachite::Rational;

/// The theorem, and the paragraph on field, lattice and metric.
pub fn theorem<const D: usize>(analysis: &Analysis<D>) -> String {
    let subject = analysis.subject;
    let count = analysis.tiling.len();
    let mut statements: Vec<String> = subject
        .statements()
        .iter()
        .filter_map(|statement| in_words(analysis, statement))
        .collect();
    if let Some(last) = statements.last_mut() {
        last.truncate(last.len() - 1);
        last.push('.');
    }
    let further = match statements.is_empty() {
        true => String::new(),
        false => format!(
            " Moreover:\n\\begin{{itemize}}\\setlength{{\\itemsep}}{{0pt}}\\setlength{{\\parskip}}{{0pt}}\n{}\\end{{itemize}}",
            statements
                .iter()
                .map(|statement| format!("\\item {statement}\n"))
                .collect::<String>()
        ),
    };
    format!(
        "\\begin{{acutiletheorem}}[{name}]\\label{{{label}}}\n{setting} Then the ${count}$ {kind} \
         of Table~\\ref{{{orbits}}}{translates} {tile} {domain} {how}: they cover it, their interiors are disjoint, and \
         any two of them meet in a common face or not at all.{further}\n\\end{{acutiletheorem}}\n\n",
        name = escape(&subject.name),
        label = analysis.label("theorem"),
        setting = setting(analysis),
        kind = simplices(D, count),
        tile = if (count, analysis.rank()) == (1, 0) {
            "tiles"
        } else {
            "tile"
        },
        orbits = analysis.label("orbits"),
        translates = match analysis.rank() {
            0 => "",
            _ => " and their translates by $\\Lambda$",
        },
        domain = domain(analysis),
        how = if D == 2 {
            "edge to edge"
        } else {
            "face to face"
        },
    )
}

fn setting<const D: usize>(analysis: &Analysis<D>) -> String {
    let basis: Vec<String> = (1..=D).map(|i| format!("$b_{i}$")).collect();
    let lattice = match analysis.rank() {
        0 => String::new(),
        1 => " Let $\\Lambda=\\mathbb{Z}b_1$.".to_owned(),
        rank => {
            let terms: Vec<String> = (1..=rank).map(|i| format!("\\mathbb{{Z}}b_{i}")).collect();
            format!(" Let $\\Lambda={}$.", terms.join("+"))
        }
    };
    format!(
        "{field}Let {basis} be a basis of Euclidean ${D}$-space with the inner products\n\
         {gram}\n{lattice}",
        field = field(analysis),
        basis = list(&basis),
        gram = gram(analysis),
    )
}

/// The field, where it is not the rational numbers.
fn field<const D: usize>(analysis: &Analysis<D>) -> String {
    let field = &analysis.tiling.frame.field;
    match &analysis.numerals {
        super::numeral::Numerals::Rational => String::new(),
        super::numeral::Numerals::Quadratic { radicand, .. } => {
            format!("All numbers lie in $\\mathbb{{Q}}(\\sqrt{{{radicand}}})$. ")
        }
        super::numeral::Numerals::Powers => {
            let (low, high) = field.root();
            let bounds = field
                .generator()
                .enclosure(&Rational::from_signeds(1, 100_000_000));
            format!(
                "All numbers lie in $\\mathbb{{Q}}(\\alpha)$, where $\\alpha\\in{}$ is the root of ${}$ between \
                 ${}$ and ${}$. ",
                interval(&bounds),
                polynomial(field.polynomial()),
                rational(&low),
                rational(&high),
            )
        }
    }
}

fn polynomial(coefficients: &[malachite::Integer]) -> String {
    let mut text = String::new();
    for (power, c) in coefficients.iter().enumerate().rev() {
        if *c == 0 {
            continue;
        }
        let sign = match (*c < 0, text.is_empty()) {
            (true, _) => "-",
            (false, true) => "",
            (false, false) => "+",
        };
        let size = c.unsigned_abs_ref().to_string();
        let variable = match power {
            0 => String::new(),
            1 => "x".to_owned(),
            _ => format!("x^{{{power}}}"),
        };
        let size = if size == "1" && power > 0 { "" } else { &size };
        text.push_str(&format!("{sign}{size}{variable}"));
    }
    text
}

/// The Gram matrix as a display.
fn gram<const D: usize>(analysis: &Analysis<D>) -> String {
    let numerals = &analysis.numerals;
    let rows: Vec<Vec<String>> = analysis
        .tiling
        .frame
        .gram
        .iter()
        .map(|row| row.iter().map(|x| numerals.number(x)).collect())
        .collect();
    format!(
        "% acutile:gram\n\\[ \\bigl(\\langle b_i,b_j\\rangle\\bigr)={}. \\]",
        matrix(&rows)
    )
}

/// A matrix; in displays that are not too wide.
pub fn matrix(rows: &[Vec<String>]) -> String {
    let rows: Vec<String> = rows.iter().map(|row| row.join(" & ")).collect();
    format!(
        "\\begin{{pmatrix}} {} \\end{{pmatrix}}",
        rows.join(" \\\\ ")
    )
}

/// What is tiled; x_1, …, x_D are coordinates in the basis.
fn domain<const D: usize>(analysis: &Analysis<D>) -> String {
    let numerals = &analysis.numerals;
    let row = |vertex: &Vec<Number>| {
        let entries: Vec<String> = vertex.iter().map(|x| numerals.inline(x)).collect();
        format!("$({})$", entries.join(",\\,"))
    };
    let hull = |polytope: &Polytope| {
        let points: Vec<String> = polytope.vertices.iter().map(row).collect();
        list(&points)
    };
    match (&analysis.tiling.frame.domain, D) {
        (Domain::Space, 2) => "the plane".to_owned(),
        (Domain::Space, _) => "space".to_owned(),
        (Domain::Region(_), _) => "the region that is their union".to_owned(),
        (Domain::Slab(polytope), _) => {
            let mut ends: Vec<&Number> = polytope.vertices.iter().flatten().collect();
            ends.sort();
            let [low, high] = [ends.first(), ends.last()]
                .map(|end| end.map_or(String::new(), |x| numerals.inline(x)));
            let name = if D == 2 { "strip" } else { "slab" };
            format!("the {name} ${low}\\le x_{D}\\le {high}$ (in coordinates of the basis)")
        }
        (Domain::Prism(polytope), _) => format!(
            "the prism of the points for which $(x_2,x_3)$ is in the convex hull of {}",
            hull(polytope)
        ),
        (Domain::Solid(polytope), 2) => format!("the polygon with the corners {}", hull(polytope)),
        (Domain::Solid(polytope), _) => {
            format!("the polyhedron with the corners {}", hull(polytope))
        }
    }
}

/// A statement beyond the tiling.
fn in_words<const D: usize>(analysis: &Analysis<D>, statement: &Statement) -> Option<String> {
    let (angle, angles) = match D {
        2 => ("angle", "angles"),
        _ => ("dihedral angle", "dihedral angles"),
    };
    Some(match statement {
        Statement::FaceToFaceTiling => return None,
        Statement::Acute => format!("all {angles} are acute;"),
        Statement::Nonobtuse => format!("no {angle} is obtuse;"),
        Statement::LargestAngle(relation, bound) => {
            let bound = angle_text(analysis, bound);
            match relation {
                Relation::Maximum => format!("the largest {angle} is {bound};"),
                Relation::Minimum => {
                    format!("the least among the largest {angles} of the tiles is {bound};")
                }
                _ => format!("the largest {angle} of each is {} {bound};", relation.text()),
            }
        }
        Statement::SmallestAngle(relation, bound) => {
            let bound = angle_text(analysis, bound);
            match relation {
                Relation::Minimum => format!("the smallest {angle} is {bound};"),
                Relation::Maximum => {
                    format!("the greatest among the smallest {angles} of the tiles is {bound};")
                }
                _ => format!("the smallest {angle} of each is {} {bound};", relation.text()),
            }
        }
        Statement::RadiusEdge(relation, bound) => {
            let bound = ratio_text(analysis, bound);
            let quotient = "quotient of circumradius and shortest edge of a tile";
            match relation {
                Relation::Maximum => format!("the largest {quotient} is {bound};"),
                Relation::Minimum => format!("the least {quotient} is {bound};"),
                _ => format!("each {quotient} is {} {bound};", relation.text()),
            }
        }
        Statement::UncrossedPlane(plane) => {
            format!("no tile crosses ${plane}$ or a translate of it by the lattice;")
        }
        Statement::Delaunay => {
            "it is the Delaunay triangulation of its vertices: no vertex of the tiling but a tile's own corners is on its \
             circumsphere, and none is inside of it;"
                .to_owned()
        }
        Statement::WeaklyDelaunay => {
            "it is a Delaunay triangulation of its vertices: inside of no circumsphere is a vertex;".to_owned()
        }
        Statement::LocallyDelaunay => {
            "it is Delaunay at each facet that two tiles share;".to_owned()
        }
        Statement::LocallyWeaklyDelaunay => {
            "it is weakly Delaunay at each facet that two tiles share;".to_owned()
        }
        Statement::Tcp => "it is tetrahedrally close packed: every edge is in five or six tetrahedra, and no triangle has \
             two edges that are in six;"
            .to_owned(),
    })
}

/// An exact number with more letters gives place to a decimal enclosure.
const WIDE: usize = 30;

/// `$\arccos 1/5$`, `$60^\circ$`, or an enclosure in degrees.
fn angle_text<const D: usize>(analysis: &Analysis<D>, angle: &DihedralAngle) -> String {
    if let Some(degrees) = angle.rational() {
        return format!("${}^\\circ$", rational(&degrees));
    }
    let root = analysis.numerals.root(&angle.signed_square.abs());
    let sign = if angle.against_right().is_gt() {
        "-"
    } else {
        ""
    };
    if width(&root) > WIDE {
        let bounds = angle.enclosure(&Rational::from_signeds(1, 1_000_000_000));
        return format!("$\\theta^\\circ$ with $\\theta\\in{}$", interval(&bounds));
    }
    format!("$\\arccos({sign}{root})$")
}

/// The ratio, or an enclosure.
fn ratio_text<const D: usize>(analysis: &Analysis<D>, ratio: &RadiusEdge) -> String {
    let root = analysis.numerals.root(&ratio.square);
    if width(&root) > WIDE {
        let bounds = ratio.enclosure(&Rational::from_signeds(1, 1_000_000_000));
        return format!("some $\\sigma\\in{}$", interval(&bounds));
    }
    format!("${root}$")
}

/// The leading principal minors, which show the metric to be positive definite.
pub fn metric<const D: usize>(analysis: &Analysis<D>) -> String {
    let gram = &analysis.tiling.frame.gram;
    let minor = |k: usize| match k {
        1 => gram[0][0].clone(),
        2 => &(&gram[0][0] * &gram[1][1]) - &(&gram[0][1] * &gram[1][0]),
        _ => linear::determinant(gram),
    };
    let minors: Vec<String> = (1..=D)
        .map(|k| format!("${}$", analysis.numerals.inline(&minor(k))))
        .collect();
    let why: Vec<String> = (1..=D)
        .map(|k| analysis.numerals.why(&minor(k)))
        .filter(|why| !why.is_empty())
        .map(|why| format!("${why}$"))
        .collect();
    let why = match why.is_empty() {
        true => String::new(),
        false => format!(" ({})", list(&why)),
    };
    format!(
        "The matrix is symmetric and its leading principal minors are {}, all positive{why}; so there is such a basis, and a \
         cell has the volume $\\sqrt{{\\det G}}={}$.\n\n",
        list(&minors),
        analysis.numerals.root(&linear::determinant(gram)),
    )
}

/// The heading of a section.
pub fn heading(subject: &Subject) -> String {
    format!("\\texttt{{{}}}", escape(&subject.name))
}

/// The first sentence of a section.
pub fn introduction(subject: &Subject, citation: &str) -> String {
    let description = subject.description.trim();
    let what = match description.is_empty() {
        true => String::new(),
        false => format!("{}{citation}. ", escape(&capitalised(description))),
    };
    format!("\\noindent {what}")
}

fn capitalised(text: &str) -> String {
    let mut characters = text.chars();
    let first = characters.next().map(char::to_uppercase);
    first.into_iter().flatten().chain(characters).collect()
}

/// Whether a matrix of these entries fits into a line, `letters` wide.
pub fn fits(rows: &[Vec<String>], letters: usize) -> bool {
    let columns = rows.first().map_or(0, Vec::len);
    let widest = |column: usize| rows.iter().map(|row| width(&row[column])).max();
    (0..columns)
        .map(|k| widest(k).unwrap_or(0) + 2)
        .sum::<usize>()
        <= letters
}

/// `1 vertex` and so on, in a sentence.
pub fn sizes<const D: usize>(analysis: &Analysis<D>) -> String {
    let cell = if analysis.rank() == 0 {
        ""
    } else {
        ", up to $\\Lambda$"
    };
    format!(
        "The tiling has {} and ${}$ {}{cell}. ",
        counted(analysis.tiling.vertices.len(), "vertex"),
        analysis.tiling.len(),
        simplices(D, analysis.tiling.len()),
    )
}

/// The proof in a sentence, with references to what is checked where.
pub fn proof<const D: usize>(analysis: &Analysis<D>) -> String {
    let acute = match analysis.subject.statements().contains(&Statement::Acute) {
        true => "; that all angles are acute, from Lemma~\\ref{acutile:angles} and the signs below",
        false => "",
    };
    let boundary = match analysis.tiling.frame.domain {
        Domain::Space => "",
        _ => ", (B) the coordinates of the vertices",
    };
    format!(
        "That this is a tiling follows from Theorem~\\ref{{acutile:sound}}; its hypotheses are (M) the metric, (O) the positive determinants in \
         Table~\\ref{{{}}}, (F) the pairing of the facets{boundary} and (V) the sum of the volumes{acute}.\n\n",
        analysis.label("orbits"),
    )
}
