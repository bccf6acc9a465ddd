//! What is proved: the theorem, its lattice and metric, and its proof in a sentence.

use super::names::human_name;
use super::subject::Analysis;
use super::tex::{counted, list, matrix, simplices};
use super::{claim, field, group};
use acutile_core::statement::Statement;
use acutile_core::tiling::{Domain, Polytope};
use acutile_exact::geometry::linear;
use acutile_exact::number::Number;

/// The theorem, and the paragraph on field, lattice and metric.
pub fn theorem<const D: usize>(analysis: &Analysis<D>) -> String {
    let subject = analysis.subject;
    let count = analysis.tiling.len();
    let mut statements: Vec<String> = subject
        .statements()
        .iter()
        .filter_map(|statement| claim::in_words::<D>(&analysis.numerals, statement))
        .collect();
    if let Some(last) = statements.last_mut() {
        last.truncate(last.len() - 1);
        last.push('.');
    }
    let further = if statements.is_empty() {
        String::new()
    } else {
        format!(
            " Moreover:\n\\begin{{itemize}}\\setlength{{\\itemsep}}{{0pt}}\\setlength{{\\parskip}}{{0pt}}\n{}\\end{{itemize}}",
            statements
                .iter()
                .map(|statement| format!("\\item {statement}\n"))
                .collect::<String>()
        )
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
        field = field::definition(analysis),
        basis = list(&basis),
        space = if D == 2 {
            "the Euclidean plane"
        } else {
            "Euclidean space"
        },
        gram = gram(analysis),
        group = group::definition(analysis),
    )
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
    let why = if why.is_empty() {
        String::new()
    } else {
        format!(" ({})", list(&why))
    };
    format!(
        "The matrix is symmetric and its leading principal minors are {}, all positive{why}; so there is such a basis, and a \
         cell has the volume $\\sqrt{{\\det G}}={}$.\n\n",
        list(&minors),
        analysis.numerals.root(&linear::determinant(gram)),
    )
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
    let acute = if analysis.subject.statements().contains(&Statement::Acute) {
        " That all angles are acute follows from Lemma~\\ref{acutile:angles} and the signs below."
    } else {
        ""
    };
    let facet = if D == 2 { "edges" } else { "facets" };
    let has_group = analysis.orbits.elements.len() > 1;
    let group = if has_group { "(S) the symmetry, " } else { "" };
    let lemma = if has_group {
        " By Lemma~\\ref{acutile:representatives} they need checking for the representatives only."
    } else {
        ""
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
