//! What is proved, in words and exact numbers; field, lattice and metric.

use super::numeral::Numerals;
use super::rational::{interval, rational};
use super::subject::{Analysis, Subject};
use super::tex::{counted, escape, facet_word, list, simplices, sphere_word, width};
use acutile_core::quality::{DihedralAngle, Exact, RadiusEdge};
use acutile_core::statement::{Relation, Statement};
use acutile_core::tiling::{Domain, Polytope};
use acutile_exact::geometry::linear;
use acutile_exact::number::Number;
use malachite::{Integer, Rational};

/// The theorem, and the paragraph on field, lattice and metric.
pub fn theorem<const D: usize>(analysis: &Analysis<D>) -> String {
    let subject = analysis.subject;
    let count = analysis.tiling.len();
    let mut statements: Vec<String> = subject
        .statements()
        .iter()
        .filter_map(|statement| in_words::<D>(&analysis.numerals, statement))
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
        "\\begin{{acutiletheorem}}[{name}]\\label{{{label}}}\n{setting} Then {tiles} of Table~\\ref{{{orbits}}}{images} {tile} {domain} {how}: they cover it, their interiors are disjoint, and \
         any two of them meet in a common face of both or not at all.{count}{further}\n\\end{{acutiletheorem}}\n\n",
        name = human_name(subject),
        label = analysis.label("theorem"),
        setting = setting(analysis),
        tiles = tiles(analysis),
        tile = if (count, analysis.rank()) == (1, 0) {
            "tiles"
        } else {
            "tile"
        },
        orbits = analysis.label("orbits"),
        images = images(analysis),
        domain = domain(analysis),
        how = if D == 2 {
            "edge to edge"
        } else {
            "face to face"
        },
        count = number_of_tiles(analysis),
    )
}

/// `the $46$ tetrahedra`, `the images under $\Gamma$ of the $3$ tetrahedra`.
fn tiles<const D: usize>(analysis: &Analysis<D>) -> String {
    let count = analysis.orbits.representatives.len();
    let kind = simplices(D, count);
    match (analysis.orbits.elements.len(), count) {
        (1, 1) => format!("the {kind}"),
        (1, _) => format!("the ${count}$ {kind}"),
        (_, 1) => format!("the images under $\\Gamma$ of the {kind}"),
        _ => format!("the images under $\\Gamma$ of the ${count}$ {kind}"),
    }
}

fn images<const D: usize>(analysis: &Analysis<D>) -> &'static str {
    match (
        analysis.orbits.elements.len(),
        analysis.orbits.representatives.len(),
        analysis.rank(),
    ) {
        (1, _, 0) => "",
        (1, 1, _) => " and its translates by $\\Lambda$",
        (1, _, _) => " and their translates by $\\Lambda$",
        _ => "",
    }
}

/// How many images there are, where the table has representatives only.
fn number_of_tiles<const D: usize>(analysis: &Analysis<D>) -> String {
    if analysis.orbits.elements.len() == 1 {
        return String::new();
    }
    let count = analysis.tiling.len();
    let kind = simplices(D, count);
    match analysis.rank() {
        0 => format!(" There are ${count}$ {kind}."),
        _ => format!(" There are ${count}$ {kind} up to $\\Lambda$."),
    }
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
        "{field}Let {basis} be a basis of {space} with the inner products\n\
         {gram}\n{lattice}{group}",
        field = field(analysis),
        basis = list(&basis),
        space = if D == 2 {
            "the Euclidean plane"
        } else {
            "Euclidean space"
        },
        gram = gram(analysis),
        group = super::group::definition(analysis),
    )
}

/// The field, where it is not the rational numbers.
fn field<const D: usize>(analysis: &Analysis<D>) -> String {
    let field = &analysis.tiling.frame.field;
    match &analysis.numerals {
        Numerals::Rational => String::new(),
        Numerals::Quadratic { radicand, .. } => {
            format!("All numbers lie in $\\mathbb{{Q}}(\\sqrt{{{radicand}}})$. ")
        }
        Numerals::Powers => {
            let (low, high) = field.root();
            format!(
                "All numbers lie in $\\mathbb{{Q}}(\\alpha)$, where $\\alpha$ is the root of ${}$ between ${}$ and ${}$. ",
                polynomial(field.polynomial()),
                rational(&low),
                rational(&high),
            )
        }
    }
}

/// The paragraph that shows the root to exist and to be unique in its interval: signs at the ends,
/// and the derivative over the interval by Horner's rule.
pub fn root<const D: usize>(analysis: &Analysis<D>) -> String {
    let field = &analysis.tiling.frame.field;
    if !matches!(analysis.numerals, Numerals::Powers) {
        return String::new();
    }
    let (low, high) = field.root();
    let p = field.polynomial();
    let value = |x: &Rational| {
        let steps = p.iter().rev();
        steps.fold(Rational::from(0), |sum, c| sum * x + Rational::from(c))
    };
    let derivative: Vec<Integer> = p
        .iter()
        .enumerate()
        .skip(1)
        .map(|(k, c)| c * Integer::from(k))
        .collect();
    let (least, greatest) = horner(&derivative, &low, &high);
    let side = |x: &Rational| if *x > 0 { ">0" } else { "<0" };
    let bounds = field
        .generator()
        .enclosure(&Rational::from_signeds(1, 100_000_000));
    format!(
        "\\acutileparagraph{{The number $\\alpha$.}} Let $p(x)={p}$. Then\n% acutile:root {slug}\n$p({low})={at_low}{low_side}$, $p({high})={at_high}{high_side}$, and $p'(x)\\in[{least},{greatest}]$ for ${low}\\le x\\le {high}$, \
         by Horner's rule in interval arithmetic. The derivative has one sign, so $p$ has exactly one root between the ends. In the same way $\\alpha\\in{enclosed}$.\n\n",
        slug = analysis.subject.slug(),
        p = polynomial(p),
        low = rational(&low),
        high = rational(&high),
        at_low = rational(&value(&low)),
        low_side = side(&value(&low)),
        at_high = rational(&value(&high)),
        high_side = side(&value(&high)),
        least = rational(&least),
        greatest = rational(&greatest),
        enclosed = interval(&bounds),
    )
}

/// The values of a polynomial over an interval, enclosed by Horner's rule.
fn horner(p: &[Integer], low: &Rational, high: &Rational) -> (Rational, Rational) {
    let start = (Rational::from(0), Rational::from(0));
    p.iter().rev().fold(start, |(least, greatest), c| {
        let products = [
            &least * low,
            &least * high,
            &greatest * low,
            &greatest * high,
        ];
        let c = Rational::from(c);
        let lowest = products.iter().min().unwrap_or(&least) + &c;
        let highest = products.iter().max().unwrap_or(&greatest) + &c;
        (lowest, highest)
    })
}

fn polynomial(coefficients: &[Integer]) -> String {
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
        "% acutile:gram\n\\[ \\acutilefit{{$\\bigl(\\langle b_i,b_j\\rangle\\bigr)={}.$}} \\]",
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
pub fn in_words<const D: usize>(numerals: &Numerals, statement: &Statement) -> Option<String> {
    let (angle, angles) = match D {
        2 => ("angle", "angles"),
        _ => ("dihedral angle", "dihedral angles"),
    };
    let (sphere, facet) = (sphere_word(D), facet_word(D));
    Some(match statement {
        Statement::FaceToFaceTiling => return None,
        Statement::Acute => format!("all {angles} are acute;"),
        Statement::Nonobtuse => format!("no {angle} is obtuse;"),
        Statement::LargestAngle(relation, bound) => {
            let bound = angle_text(numerals, bound);
            match relation {
                Relation::Maximum => format!("the largest {angle} is {bound};"),
                Relation::Minimum => {
                    format!("the least among the largest {angles} of the tiles is {bound};")
                }
                _ => format!("the largest {angle} of each is {} {bound};", relation.text()),
            }
        }
        Statement::SmallestAngle(relation, bound) => {
            let bound = angle_text(numerals, bound);
            match relation {
                Relation::Minimum => format!("the smallest {angle} is {bound};"),
                Relation::Maximum => {
                    format!("the greatest among the smallest {angles} of the tiles is {bound};")
                }
                _ => format!("the smallest {angle} of each is {} {bound};", relation.text()),
            }
        }
        Statement::RadiusEdge(relation, bound) => {
            let bound = ratio_text(numerals, bound);
            let quotient = "quotient of circumradius and shortest edge of a tile";
            match relation {
                Relation::Maximum => format!("the largest {quotient} is {bound};"),
                Relation::Minimum => format!("the least {quotient} is {bound};"),
                _ => format!("each {quotient} is {} {bound};", relation.text()),
            }
        }
        Statement::UncrossedPlane(plane) => {
            let plane = plane.to_string().replace('x', "x_");
            format!("no tile crosses ${plane}$ or a translate of it by the lattice;")
        }
        Statement::Delaunay => {
            format!("it is the Delaunay triangulation of its vertices: no vertex of the tiling but a tile's own corners is on its \
             {sphere}, and none is inside of it;")
        }
        Statement::WeaklyDelaunay => {
            format!("it is a Delaunay triangulation of its vertices: inside of no {sphere} is a vertex;")
        }
        Statement::LocallyDelaunay => {
            format!("at each {facet} that two tiles share, the other corner of the one is outside of the {sphere} of the other;")
        }
        Statement::LocallyWeaklyDelaunay => {
            format!("at each {facet} that two tiles share, the other corner of the one is not inside of the {sphere} of the other;")
        }
        Statement::Tcp => "it is tetrahedrally close packed: every edge is in five or six tetrahedra, and no triangle has \
             two edges that are in six;"
            .to_owned(),
    })
}

/// An exact number with more letters gives place to a decimal enclosure.
const WIDE: usize = 30;

/// `$\arccos 1/5$`, `$60^\circ$`, or an enclosure in degrees.
fn angle_text(numerals: &Numerals, angle: &DihedralAngle) -> String {
    if let Some(degrees) = angle.rational() {
        return format!("${}^\\circ$", rational(&degrees));
    }
    let root = numerals.root(&angle.signed_square.abs());
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
fn ratio_text(numerals: &Numerals, ratio: &RadiusEdge) -> String {
    let root = numerals.root(&ratio.square);
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
    let plain = super::names::plain(&subject.name);
    format!(
        "\\texorpdfstring{{{}}}{{{}}}",
        human_name(subject),
        escape(&plain)
    )
}

/// What people call it.
pub fn human_name(subject: &Subject) -> String {
    super::names::human(&subject.name)
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
        true => {
            " That all angles are acute follows from Lemma~\\ref{acutile:angles} and the signs below."
        }
        false => "",
    };
    let facet = if D == 2 { "edges" } else { "facets" };
    let has_group = analysis.orbits.elements.len() > 1;
    let group = if has_group { "(S) the symmetry, " } else { "" };
    let lemma = match has_group {
        true => {
            " By Lemma~\\ref{acutile:representatives} they need checking for the representatives only."
        }
        false => "",
    };
    let (theorem, rest) = match &analysis.tiling.frame.domain {
        Domain::Space => ("sound", "and (V) the sum of the volumes"),
        Domain::Region(_) => ("region", "(X) the boundary, and (W) what is outside of it"),
        _ => ("sound", "(B) the boundary, and (V) the sum of the volumes"),
    };
    format!(
        "\\acutileparagraph{{Proof.}} That this is a tiling follows from Theorem~\\ref{{acutile:{theorem}}}. Its hypotheses are checked below: (M) the metric, {group}(O) the determinants, \
         (F) the {facet}, {rest}.{lemma}{acute}\n\n",
    )
}
