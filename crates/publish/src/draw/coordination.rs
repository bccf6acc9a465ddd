//! Coordination polyhedra: the link of one vertex of each kind as a solid, with the vertex in it.

use super::drawing::{BLACK, Drawing, Layout, Panel, WHITE};
use super::star::{around, bodies};
use super::view::View;
use super::{DrawError, Options};
use crate::palette::colour;
use acutile_core::classify::stars;
use acutile_core::quality::{kinds as classes_of, shapes};
use acutile_core::tiling::{Tiling, VertexId};
use std::collections::BTreeMap;

/// One panel for each kind of vertex: the same star, with tetrahedra of the same congruence classes.
pub fn figure(name: &str, tiling: &Tiling<3>, options: &Options) -> Result<Drawing, DrawError> {
    let view = View::new(&tiling.frame.gram, options.direction)?;
    let classes = classes_of(&shapes(tiling), tiling.len());
    let mut panels = Vec::new();
    for (kind, ((star, _), members)) in kinds(tiling, &classes).into_iter().enumerate() {
        let id = VertexId::at(members[0]);
        let bodies = bodies(tiling, id, |_| colour(kind));
        let (scene, count) = around(tiling, id, &bodies, &view, None);
        panels.push(Panel {
            items: scene.items()?,
            caption: format!("{star}: {count} neighbours, {} in the cell", members.len()),
        });
    }
    let layout = Layout {
        width: options.width,
        columns: panels.len().clamp(1, 2),
        margin: 3.0,
        has_one_scale: true,
        legend: vec![
            (BLACK, "vertex".to_owned()),
            (WHITE, "neighbour".to_owned()),
        ],
    };
    Ok(layout.arrange(&format!("{name}: coordination polyhedra"), &panels))
}

/// The vertices by the names of their stars and the classes of the tetrahedra there.
fn kinds(tiling: &Tiling<3>, classes: &[usize]) -> BTreeMap<(String, Vec<usize>), Vec<usize>> {
    let mut around = vec![Vec::new(); tiling.vertices.len()];
    for (simplex, &class) in tiling.simplices().zip(classes) {
        for corner in simplex {
            around[corner.vertex.index()].push(class);
        }
    }
    let mut kinds: BTreeMap<_, Vec<usize>> = BTreeMap::new();
    for (vertex, (star, mut classes)) in stars(tiling).iter().zip(around).enumerate() {
        classes.sort_unstable();
        let key = (star.to_string(), classes);
        kinds.entry(key).or_default().push(vertex);
    }
    kinds
}
