//! The section on a family: the theorem, vertices and tiles with polynomials, and the pairing. The
//! signs of all polynomials on the leaves of the tree follow.

use super::conditions::{Condition, Section, conditions};
use super::numeral::Numerals;
use super::polynomial::name;
use super::subject::Subject;
use super::tex::{self, Table, facet_word, list, matrix, simplices};
use super::{bibliography, claim, names, recheck};
use acutile_core::family::{Family, Tree};
use acutile_core::tiling::{Facet, SimplexId, match_facets};
use acutile_exact::number::Number;
use acutile_exact::polynomial::bernstein::coefficients;
use acutile_exact::polynomial::{Cuboid, End, Polynomial};

/// Leaves for which coefficients are printed.
const LEAVES: usize = 8;

/// The section.
pub fn section<const D: usize>(subject: &Subject, family: &Family<D>, tree: &Tree) -> String {
    let numerals = Numerals::of(&family.frame.field);
    let section = Section {
        subject,
        family,
        tree,
        numerals,
    };
    let citation = bibliography::citation(&subject.name, subject.source);
    let conditions = conditions(&section);
    [
        format!(
            "\\acutilesection{{{}}}\\label{{{}}}\n",
            names::heading(subject),
            section.label("section")
        ),
        names::introduction(subject, &citation),
        "\n\n".to_owned(),
        statement(&section),
        proof(&section),
        vertices(&section),
        tiles(&section),
        facets(&section),
        signs(&section, &conditions),
        recheck::recheck(subject),
    ]
    .concat()
}

fn statement<const D: usize>(section: &Section<D>) -> String {
    let family = section.family;
    let gram: Vec<Vec<String>> = family
        .frame
        .gram
        .iter()
        .map(|row| row.iter().map(|p| section.polynomial(p)).collect())
        .collect();
    let lattice: Vec<String> = (1..=section.rank())
        .map(|i| format!("\\mathbb{{Z}}b_{i}"))
        .collect();
    let basis: Vec<String> = (1..=D).map(|i| format!("$b_{i}$")).collect();
    let count = family.len();
    let items: String = section
        .subject
        .statements()
        .iter()
        .filter_map(|statement| claim::in_words::<D>(&section.numerals, statement))
        .map(|words| format!("\\item {words}\n"))
        .collect();
    let items = match items.trim_end().strip_suffix(';') {
        None => String::new(),
        Some(items) => format!(
            " Moreover, at each point of the box:\n\\begin{{itemize}}\\setlength{{\\itemsep}}{{0pt}}\\setlength{{\\parskip}}{{0pt}}\n{items}.\n\\end{{itemize}}"
        ),
    };
    format!(
        "\\begin{{acutiletheorem}}[{name}]\\label{{{label}}}\nLet {box}. Let {basis} be a basis of {space} with the inner products\n\
         % acutile:gram\n\\[ \\acutilefit{{$\\bigl(\\langle b_i,b_j\\rangle\\bigr)={gram}.$}} \\]\n{lattice}\
         Then the ${count}$ {kind} of Table~\\ref{{{orbits}}}{moved} tile {domain} {how}: they cover it, their interiors are disjoint, and any two of them meet in a common face of both or not at all.{items}\n\\end{{acutiletheorem}}\n\n",
        name = names::human_name(section.subject),
        label = section.label("theorem"),
        r#box = parameters(section),
        basis = list(&basis),
        space = if D == 2 {
            "the Euclidean plane"
        } else {
            "Euclidean space"
        },
        gram = matrix(&gram),
        lattice = if lattice.is_empty() {
            String::new()
        } else {
            format!("Let $\\Lambda={}$. ", lattice.join("+"))
        },
        kind = simplices(D, count),
        orbits = section.label("orbits"),
        moved = if lattice.is_empty() {
            ""
        } else {
            " and their translates by $\\Lambda$"
        },
        domain = domain(section),
        how = if D == 2 {
            "edge to edge"
        } else {
            "face to face"
        },
    )
}

/// `$0<s<1$ and $1\le t\le2$`.
fn parameters<const D: usize>(section: &Section<D>) -> String {
    let sign = |end: &End| if end.is_open { "<" } else { "\\le " };
    let intervals: Vec<String> = section
        .family
        .parameters
        .iter()
        .map(|parameter| {
            let side = &parameter.side;
            format!(
                "${}{}{}{}{}$",
                section.numerals.inline(&side.low.value),
                sign(&side.low),
                name(&parameter.name),
                sign(&side.high),
                section.numerals.inline(&side.high.value)
            )
        })
        .collect();
    list(&intervals)
}

fn domain<const D: usize>(section: &Section<D>) -> String {
    let Some(polytope) = section.family.frame.domain.polytope() else {
        return if D == 2 { "the plane" } else { "space" }.to_owned();
    };
    let points: Vec<String> = polytope
        .vertices
        .iter()
        .map(|vertex| {
            let entries: Vec<String> = vertex.iter().map(|p| section.polynomial(p)).collect();
            format!("$({})$", entries.join(",\\,"))
        })
        .collect();
    let last: Vec<String> = (section.rank() + 1..=D).map(|i| format!("x_{i}")).collect();
    format!(
        "the points for which $({})$ is in the convex hull of {}",
        last.join(","),
        list(&points)
    )
}

fn proof<const D: usize>(section: &Section<D>) -> String {
    let leaves = section.tree.leaves();
    let cut = match leaves {
        1 => "The box need not be cut.".to_owned(),
        _ => format!(
            "The box is cut into ${leaves}$ boxes by halving intervals, {}.",
            tree_words(section)
        ),
    };
    format!(
        "\\acutileparagraph{{Proof.}} By Theorem~\\ref{{acutile:family}} it suffices to check the names of the {facet}s in Table~\\ref{{{pairing}}} and the signs of the polynomials in Table~\\ref{{{signs}}}. {cut}\n\n",
        facet = facet_word(D),
        pairing = section.label("pairing"),
        signs = section.label("signs"),
    )
}

/// `first t, then its lower half s`: the tree as nested brackets.
fn tree_words<const D: usize>(section: &Section<D>) -> String {
    fn nested(tree: &Tree, names: &[String]) -> String {
        match tree {
            Tree::Leaf => "\\cdot".to_owned(),
            Tree::Halves(axis, halves) => format!(
                "{}({},{})",
                name(&names[*axis]),
                nested(&halves[0], names),
                nested(&halves[1], names)
            ),
        }
    }
    if section.tree.leaves() > 64 {
        "as the certificate lists them".to_owned()
    } else {
        format!(
            "as ${}$ says: $t(A,B)$ halves the interval of $t$ and treats the lower half as $A$ and the upper half as $B$, and a dot stands for a box that is not cut",
            nested(section.tree, &section.family.names())
        )
    }
}

fn vertices<const D: usize>(section: &Section<D>) -> String {
    let row = |(number, vertex): (usize, &[Polynomial; D])| {
        let cells: String = vertex
            .iter()
            .map(|p| format!(" & ${}$", section.polynomial(p)))
            .collect();
        format!("{number}{cells}")
    };
    let names: String = (1..=D).map(|i| format!(" & $x_{i}$")).collect();
    Table {
        mark: format!("vertices {}", section.subject.slug()),
        columns: &format!("r@{{\\qquad}}{}", "l".repeat(D)),
        caption: "Vertices in coordinates of the basis.".to_owned(),
        label: section.label("vertices"),
        heading: format!("vertex{names}"),
        rows: section
            .family
            .vertices
            .iter()
            .enumerate()
            .map(row)
            .collect(),
    }
    .tex()
}

fn corners<'f, const D: usize>(
    section: &Section<'f, D>,
    tile: SimplexId,
) -> &'f [acutile_core::tiling::Corner<D>] {
    let first = tile.index() * (D + 1);
    &section.family.corners[first..=first + D]
}

fn tiles<const D: usize>(section: &Section<D>) -> String {
    let row = |tile: SimplexId| {
        let cells: String = corners(section, tile)
            .iter()
            .map(|c| format!(" & ${}$", tex::corner(c, section.rank())))
            .collect();
        format!("$T_{{{tile}}}${cells}")
    };
    Table {
        mark: format!("orbits {}", section.subject.slug()),
        columns: &format!("r{}", "@{\\quad}r".repeat(D + 1)),
        caption: format!("All {}, by their corners.", simplices(D, 2)),
        label: section.label("orbits"),
        heading: format!("tile & \\multicolumn{{{}}}{{c}}{{corners}}", D + 1),
        rows: section.family.simplices().map(row).collect(),
    }
    .tex()
}

fn facets<const D: usize>(section: &Section<D>) -> String {
    let member = section.family.at(&section.family.cuboid().center());
    let matching = match_facets(&member);
    let mut rows = Vec::new();
    for tile in section.family.simplices() {
        for i in 0..=D {
            let facet = Facet::new(tile, i);
            rows.push(match matching.mate(&member, facet) {
                None => format!("$T_{{{tile}}}$ & {i} & $\\partial$ & &"),
                Some(mate) => {
                    let apex = corners(section, mate.facet.simplex)
                        [usize::from(mate.facet.opposite)]
                    .moved(mate.shift);
                    format!(
                        "$T_{{{tile}}}$ & {i} & ${}$ & $T_{{{}}}{}$ & {}",
                        tex::corner(&apex, section.rank()),
                        mate.facet.simplex,
                        tex::moved(&mate.shift[..section.rank()]),
                        mate.facet.opposite
                    )
                }
            });
        }
    }
    let word = facet_word(D);
    Table {
        mark: format!("pairing {}", section.subject.slug()),
        columns: "rrrrr",
        caption: format!(
            "The {word} of a tile opposite to its corner $c_i$: the corner $d$ on the other side, which is corner $j$ of the other tile; $\\partial$ in the boundary."
        ),
        label: section.label("pairing"),
        heading: "tile & $i$ & $d$ & other tile & $j$".to_owned(),
        rows,
    }
    .tex()
}

fn signs<const D: usize>(section: &Section<D>, conditions: &[Condition]) -> String {
    let leaves = leaves(section.tree, section.family.cuboid());
    let shown = leaves.len() <= LEAVES;
    let row = |(number, condition): (usize, &Condition)| {
        let sign = if condition.is_strict { ">0" } else { "\\ge0" };
        let lists = if shown {
            leaves
                .iter()
                .map(|leaf| bernstein(section, condition, leaf))
                .collect::<Vec<_>>()
                .join("; ")
        } else {
            String::new()
        };
        format!(
            "{number} & ${}{sign}$ & {} & {lists}",
            section.polynomial(&condition.polynomial),
            condition.uses
        )
    };
    let explained = if shown {
        "The last column has the numbers $b_i$ of Lemma~\\ref{acutile:signs}, in lexicographic order of $i$ and up to a positive factor, for one box after the other.".to_owned()
    } else {
        format!(
            "On each of the ${}$ boxes the numbers $b_i$ of Lemma~\\ref{{acutile:signs}} show the sign; they are too many to be printed.",
            leaves.len()
        )
    };
    format!(
        "\\acutileparagraph{{Signs.}} Table~\\ref{{{label}}} has all polynomials whose signs matter, up to positive factors, and where they occur: in a determinant $\\det T$, in $-\\langle g_i,g_j\\rangle$ for the angle at an edge of $T$ (Lemma~\\ref{{acutile:angles}}), in the power $\\pi(d)\\det T$ of the corner $d$ on the other side of a facet, \
         in a minor of the Gram matrix, or in the distance of a vertex from the boundary. {explained} {volume}\n\n{table}",
        label = section.label("signs"),
        volume = super::conditions::volume(section),
        table = Table {
            mark: format!("signs-of-polynomials {}", section.subject.slug()),
            columns: "rp{.34\\linewidth}p{.28\\linewidth}p{.24\\linewidth}",
            caption: "Polynomials and their signs on the box.".to_owned(),
            label: section.label("signs"),
            heading: "& polynomial & occurs in & $b_i$".to_owned(),
            rows: conditions.iter().enumerate().map(row).collect(),
        }
        .tex()
    )
}

/// The coefficients on a leaf.
fn bernstein<const D: usize>(section: &Section<D>, condition: &Condition, leaf: &Cuboid) -> String {
    let Some(numbers) = coefficients(&condition.polynomial, leaf) else {
        return "--".to_owned();
    };
    let factor = Number::from(section.numerals.primitive_factor(&numbers));
    let texts: Vec<String> = numbers
        .iter()
        .map(|x| format!("${}$", section.numerals.inline(&(x * &factor))))
        .collect();
    texts.join(", ")
}

fn leaves(tree: &Tree, cuboid: Cuboid) -> Vec<Cuboid> {
    match tree {
        Tree::Leaf => vec![cuboid],
        Tree::Halves(axis, halves) => {
            let [low, high] = cuboid.halves(*axis);
            [leaves(&halves[0], low), leaves(&halves[1], high)].concat()
        }
    }
}
