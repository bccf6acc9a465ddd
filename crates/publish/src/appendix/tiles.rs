//! The representatives of the tiles: corners, determinants, stabilisers; and all tiles for the
//! supplement.

use super::subject::Analysis;
use super::tex::{Table, corner, simplices};
use acutile_core::tiling::SimplexId;
use acutile_exact::geometry::Simplex;
use acutile_exact::number::Number;

/// The paragraph on determinants and numbers of images, with the table of representatives.
pub fn tiles<const D: usize>(analysis: &Analysis<D>) -> String {
    let kind = simplices(D, 2);
    let has_group = analysis.orbits.elements.len() > 1;
    let counted = if has_group {
        format!(
            " The last columns have the number $s$ of the isometries of Table~\\ref{{{}}} that map the tile to itself{}, and the number ${}/s$ of its images{}.",
            analysis.label("group"),
            if analysis.rank() == 0 {
                ""
            } else {
                " up to $\\Lambda$"
            },
            analysis.orbits.elements.len(),
            if analysis.rank() == 0 {
                ""
            } else {
                " up to $\\Lambda$"
            },
        )
    } else {
        String::new()
    };
    format!(
        "\\acutileparagraph{{Tiles (O).}} Table~\\ref{{{label}}} lists the {kind}, by congruence classes. {notation} \
         The column $\\det$ has the determinant of the edges $c_1-c_0,\\dots,c_{D}-c_0$ in coordinates, which is positive.{counted}\n\n{table}{stabilisers}",
        label = analysis.label("orbits"),
        notation = notation(analysis),
        table = table(analysis),
        stabilisers = if has_group {
            stabilisers(analysis)
        } else {
            String::new()
        },
    )
}

fn table<const D: usize>(analysis: &Analysis<D>) -> String {
    let has_group = analysis.orbits.elements.len() > 1;
    let row = |&place: &usize| {
        let representative = &analysis.orbits.representatives[place];
        let tile = representative.tile;
        let counts = if has_group {
            format!(
                " & {} & {}",
                representative.stabiliser.len(),
                representative.count
            )
        } else {
            String::new()
        };
        format!(
            "{} & $T_{{{tile}}}$ & {} & {}{counts}",
            analysis.classes[tile.index()],
            corners(analysis, tile),
            determinant(analysis, tile),
        )
    };
    let (columns, heads) = if has_group {
        ("rr", " & $s$ & images")
    } else {
        ("", "")
    };
    Table {
        mark: format!("orbits {}", analysis.subject.slug()),
        columns: &format!("rr{}l{columns}", "@{\\quad}r".repeat(D + 1)),
        caption: format!(
            "{}: congruence class, corners $c_0,\\dots,c_{D}$, determinant.",
            if has_group {
                format!("Representatives of the {}", simplices(D, 2))
            } else {
                format!("All {}", simplices(D, 2))
            }
        ),
        label: analysis.label("orbits"),
        heading: format!(
            "class & tile & \\multicolumn{{{}}}{{c}}{{corners}} & $\\det$ $(>0)${heads}",
            D + 1
        ),
        rows: analysis.order.iter().map(row).collect(),
    }
    .tex()
}

/// Which isometries map a representative to itself, where these are more than the identity.
fn stabilisers<const D: usize>(analysis: &Analysis<D>) -> String {
    let items: Vec<String> = analysis
        .order
        .iter()
        .map(|&place| &analysis.orbits.representatives[place])
        .filter(|representative| representative.stabiliser.len() > 1)
        .map(|representative| {
            let numbers: Vec<String> = representative
                .stabiliser
                .iter()
                .map(usize::to_string)
                .collect();
            format!(
                "$T_{{{}}}$: ${}$",
                representative.tile,
                numbers.join("$, $")
            )
        })
        .collect();
    if items.is_empty() {
        return "Only the identity maps one of these tiles to itself.\n\n".to_owned();
    }
    format!(
        "The numbers of the isometries that map a tile to itself{}, other tiles only by $\\gamma_0$:\n% acutile:stabilisers {}\n{}.\n\n",
        if analysis.rank() == 0 {
            ""
        } else {
            " up to $\\Lambda$"
        },
        analysis.subject.slug(),
        items.join("; ")
    )
}

/// The meaning of a corner's superscript.
fn notation<const D: usize>(analysis: &Analysis<D>) -> &'static str {
    match (analysis.rank(), D) {
        (0, _) => "A corner is a vertex, by its number.",
        (1, _) => {
            "A corner is a vertex, by its number; $5^{\\bar1}$ is vertex $5$ moved by $-b_1$."
        }
        (2, _) => {
            "A corner is a vertex, by its number; $5^{1\\bar1}$ is vertex $5$ moved by $b_1-b_2$."
        }
        _ => {
            "A corner is a vertex, by its number; $5^{1\\bar10}$ is vertex $5$ moved by $b_1-b_2$."
        }
    }
}

/// The determinant, and why it is positive.
pub fn determinant<const D: usize>(analysis: &Analysis<D>, simplex: SimplexId) -> String {
    let determinant = analysis.tiling.shape(simplex).determinant;
    format!("${}$", analysis.numerals.justified(&determinant))
}

/// The corners as cells of a table.
pub fn corners<const D: usize>(analysis: &Analysis<D>, simplex: SimplexId) -> String {
    let corners: Vec<String> = analysis
        .tiling
        .simplex(simplex)
        .iter()
        .map(|c| format!("${}$", corner(c, analysis.rank())))
        .collect();
    corners.join(" & ")
}

/// All simplices, for the supplement.
pub fn all_simplices<const D: usize>(analysis: &Analysis<D>) -> String {
    let row = |simplex: SimplexId| {
        let image = &analysis.orbits.images[simplex.index()];
        let determinant = analysis.tiling.shape(simplex).determinant;
        format!(
            "$T_{{{simplex}}}$ & {} & ${}$ & ${}$ & {}",
            analysis.classes[simplex.index()],
            analysis.image(image.element, image.representative, &image.shift),
            analysis.numerals.cell(&determinant),
            corners(analysis, simplex)
        )
    };
    Table {
        mark: format!("simplices {}", analysis.subject.slug()),
        columns: &format!("rrll{}", "@{\\quad}r".repeat(D + 1)),
        caption: format!(
            "All {}: class, as an image of a representative, determinant, corners. {}",
            simplices(D, 2),
            notation(analysis)
        ),
        label: analysis.label("simplices"),
        heading: format!(
            "& class & image & $\\det$ & \\multicolumn{{{}}}{{c}}{{corners}}",
            D + 1
        ),
        rows: analysis.tiling.indices().map(row).collect(),
    }
    .tex()
}

/// The barycentric coordinates of a point in a tile.
pub fn barycentric<const D: usize>(
    analysis: &Analysis<D>,
    tile: SimplexId,
    point: &[Number; D],
) -> Vec<Number> {
    let corners: Vec<[Number; D]> = analysis
        .tiling
        .simplex(tile)
        .iter()
        .map(|c| analysis.tiling.position(c))
        .collect();
    let whole = Simplex::new(&corners).determinant;
    (0..=D)
        .filter_map(|k| {
            let mut exchanged = corners.clone();
            exchanged[k] = point.clone();
            Simplex::new(&exchanged).determinant.divide(&whole)
        })
        .collect()
}
