//! The anatomy of a tiling with a boundary, in words and as data: pieces, cavities, singular places,
//! labels.

use acutile_core::anatomy::{Anatomy, pieces, volumes};
use acutile_core::checker::Names;
use acutile_core::quality::plain_decimal;
use acutile_core::statement::counted;
use acutile_core::tiling::{Matching, SimplexId, Tiling, match_facets};
use acutile_io::mesh::Origin;
use serde_json::{Value, json};
use std::collections::BTreeMap;

/// A description in lines and as data.
pub struct Description {
    pub lines: Vec<String>,
    pub data: Value,
}

/// Cells with one label.
struct Tag {
    name: String,
    simplices: usize,
    volume: f64,
    pieces: usize,
}

/// Describes a region, or says what labels a mesh has.
pub fn describe<const D: usize>(
    tiling: &Tiling<D>,
    names: &Names,
    origin: Option<&Origin>,
) -> Option<Description> {
    let is_region = tiling.frame.domain.is_region();
    let has_labels = origin.is_some_and(Origin::has_labels);
    if !is_region && !has_labels {
        return None;
    }
    let matching = match_facets(tiling);
    let mut lines = Vec::new();
    let mut data = json!({});
    if is_region {
        let anatomy = Anatomy::of(tiling, &matching);
        lines.push(in_words(&anatomy));
        lines.extend(details(&anatomy, names));
        data = in_data(&anatomy, names);
    }
    if let Some(origin) = origin.filter(|_| has_labels) {
        let tags = tags(tiling, &matching, origin);
        data["tags"] = tags.iter().map(tag_data).collect();
        lines.extend(tags.iter().take(TAGS).map(tag_words::<D>));
        if tags.len() > TAGS {
            let more = counted(tags.len() - TAGS, "more tag", "more tags");
            lines.push(format!("and {more}, which --json lists"));
        }
    }
    Some(Description { lines, data })
}

fn simplices<const D: usize>(count: usize) -> String {
    match D {
        2 => counted(count, "triangle", "triangles"),
        _ => counted(count, "tetrahedron", "tetrahedra"),
    }
}

fn in_words<const D: usize>(anatomy: &Anatomy<D>) -> String {
    let count = |n: usize, one: &str, many: &str| match n {
        0 => format!("no {one}"),
        n => counted(n, one, many),
    };
    let ridges = anatomy.ridges.len();
    let vertices = count(anatomy.vertices.len(), "vertex", "vertices");
    let manifold = match (anatomy.is_manifold(), D) {
        (true, _) => "its boundary is a manifold".to_owned(),
        (false, 2) => format!(
            "its boundary is no manifold at {}",
            count(ridges, "vertex", "vertices")
        ),
        (false, _) => format!(
            "its boundary is no manifold at {} and {vertices}",
            count(ridges, "edge", "edges")
        ),
    };
    format!(
        "{}, {}; {manifold}",
        count(anatomy.pieces.len(), "piece", "pieces"),
        count(anatomy.cavities().count(), "cavity", "cavities"),
    )
}

/// The number of pieces, cavities and singular places that are named.
const FEW: usize = 8;

/// The number of tags that are described. Some files give each cell a number of its own.
const TAGS: usize = 50;

fn details<const D: usize>(anatomy: &Anatomy<D>, names: &Names) -> Vec<String> {
    let mut lines = Vec::new();
    let facets = if D == 2 { "edges" } else { "facets" };
    if anatomy.pieces.len() > 1 {
        for (first, count) in anatomy.pieces.iter().take(FEW) {
            let name = names.simplex(*first);
            let simplices = simplices::<D>(*count);
            lines.push(format!("piece of {simplices}, from {name}"));
        }
    }
    for cavity in anatomy.cavities().take(FEW) {
        let filling = if cavity.is_one_simplex() {
            "1 simplex fills it".to_owned()
        } else {
            format!("{} simplices or more fill it", cavity.least_filling())
        };
        let near = some(&cavity.simplices(), names);
        let count = cavity.facets.len();
        lines.push(format!(
            "cavity of {count} {facets}: {filling}; it is next to {near}"
        ));
    }
    for (ridge, count) in anatomy.ridges.iter().take(FEW) {
        let corners = ridge.iter().map(|c| names.vertex(c.vertex.index()));
        let corners = corners.collect::<Vec<_>>().join(", ");
        lines.push(match D {
            2 => format!("{corners} is in {count} boundary edges"),
            _ => format!("edge [{corners}] is in {count} boundary facets"),
        });
    }
    for vertex in anatomy.vertices.iter().take(FEW) {
        let name = names.vertex(vertex.index());
        lines.push(format!("at {name} the boundary facets form several rings"));
    }
    lines
}

fn some(simplices: &[SimplexId], names: &Names) -> String {
    let first = simplices.iter().take(FEW).map(|s| names.simplex(*s));
    let rest = (simplices.len() > FEW).then(|| "…".to_owned());
    first.chain(rest).collect::<Vec<_>>().join(", ")
}

fn in_data<const D: usize>(anatomy: &Anatomy<D>, names: &Names) -> Value {
    let piece = |(first, count): &(SimplexId, usize)| json!({ "simplices": count, "first": names.simplex(*first) });
    let cavities = anatomy.cavities().map(|cavity| {
        let near = cavity.simplices();
        json!({
            "facets": cavity.facets.len(),
            "fills_with_one": cavity.is_one_simplex(),
            "fills_with_at_least": cavity.least_filling(),
            "next_to": near.iter().map(|s| names.simplex(*s)).collect::<Vec<_>>(),
        })
    });
    let ridge = |(corners, count): &(Vec<acutile_core::tiling::Corner<D>>, usize)| {
        let corners = corners.iter().map(|c| names.vertex(c.vertex.index()));
        json!({ "corners": corners.collect::<Vec<_>>(), "facets": count })
    };
    let vertices = anatomy.vertices.iter().map(|v| names.vertex(v.index()));
    json!({
        "pieces": anatomy.pieces.iter().map(piece).collect::<Vec<_>>(),
        "cavities": cavities.collect::<Vec<_>>(),
        "manifold": anatomy.is_manifold(),
        "singular_edges": anatomy.ridges.iter().map(ridge).collect::<Vec<_>>(),
        "singular_vertices": vertices.collect::<Vec<_>>(),
    })
}

/// A sum of doubles with the errors of its additions (Neumaier's summation): a sum of 10^5 volumes is right
/// to nearly all of its digits.
#[derive(Default)]
struct Sum {
    total: f64,
    lost: f64,
}

impl Sum {
    fn add(&mut self, value: f64) {
        let total = self.total + value;
        self.lost += if self.total.abs() >= value.abs() {
            (self.total - total) + value
        } else {
            (value - total) + self.total
        };
        self.total = total;
    }
}

/// Of each label the cells, their volume and their pieces.
fn tags<const D: usize>(tiling: &Tiling<D>, matching: &Matching<D>, origin: &Origin) -> Vec<Tag> {
    let volumes = volumes(tiling);
    let mut sums: BTreeMap<i64, (usize, Sum)> = BTreeMap::new();
    let label = |simplex| origin.label(simplex).unwrap_or(0);
    for simplex in tiling.indices() {
        let sum = sums.entry(label(simplex)).or_default();
        sum.0 += 1;
        sum.1.add(volumes[simplex.index()]);
    }
    let pieces = pieces(tiling, matching, |s, t| label(s) == label(t));
    let tag = |(value, (simplices, volume)): (i64, (usize, Sum))| Tag {
        name: match value {
            0 => "no tag".to_owned(),
            _ => origin.label_name(value),
        },
        simplices,
        volume: volume.total + volume.lost,
        pieces: pieces
            .iter()
            .filter(|(first, _)| label(*first) == value)
            .count(),
    };
    sums.into_iter().map(tag).collect()
}

fn tag_words<const D: usize>(tag: &Tag) -> String {
    let measure = if D == 2 { "area" } else { "volume" };
    format!(
        "{}: {}, {measure} about {}, {}",
        tag.name,
        simplices::<D>(tag.simplices),
        plain_decimal(tag.volume),
        counted(tag.pieces, "piece", "pieces")
    )
}

fn tag_data(tag: &Tag) -> Value {
    json!({
        "tag": tag.name,
        "simplices": tag.simplices,
        "volume": tag.volume,
        "pieces": tag.pieces,
    })
}
