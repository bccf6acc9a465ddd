//! Section 4.3: the slab in its eight steps, one panel each. New tetrahedra are coloured. The vertices have
//! the colours of their layers as in the paper: white, yellow, red, blue, black.

use super::drawing::{BLACK, Colour, Drawing, Layout, Panel, Stroke, WHITE};
use super::polygon::Point;
use super::scene::{Body, Dot, Line, Scene};
use super::view::View;
use super::{DrawError, Options};
use acutile_core::tiling::{Corner, SimplexId, Tiling};
use acutile_exact::geometry::linear;
use acutile_exact::number::Number;
use malachite::Rational;
use std::collections::BTreeSet;

/// The tetrahedra of a cell that come with each step, in the order of the catalogue. A cell has
/// one vertex, three edges and two triangles of the grid.
pub const NEW: [usize; 8] = [0, 2, 3, 6, 6, 6, 2, 6];

/// How far the patch reaches from the middle, in units of the slab: the side of the grid is 6.
const REACH: i64 = 8;

/// The colours of tetrahedra of earlier steps and of this one; apart in grey, too.
const OLD: Colour = [228, 228, 228];
const FRESH: Colour = [230, 159, 0];

/// The colours of the layers, by the heights in tenths up to which they are.
const LAYERS: [(i64, Colour); 5] = [
    (0, WHITE),
    (40, [240, 228, 66]),
    (46, [204, 60, 60]),
    (71, [0, 114, 178]),
    (i64::MAX, BLACK),
];

/// The figure, of the slab only.
pub fn steps(name: &str, tiling: &Tiling<3>, options: &Options) -> Result<Drawing, DrawError> {
    if name != "slab" {
        return Err(DrawError::NoSteps);
    }
    let view = View::new(&tiling.frame.gram, options.direction)?;
    let panels = (1..=8).map(|step| panel(tiling, &view, step));
    let panels = panels.collect::<Result<Vec<Panel>, DrawError>>()?;
    let layout = Layout {
        width: options.width,
        columns: if options.width < 120.0 { 2 } else { 4 },
        margin: 1.5,
        has_one_scale: true,
        legend: LAYERS
            .iter()
            .zip(["0", "4", "4.6", "7.1", "9.6"])
            .map(|((_, colour), height)| (*colour, format!("height {height}")))
            .collect(),
    };
    Ok(layout.arrange("slab: the eight steps", &panels))
}

fn panel(tiling: &Tiling<3>, view: &View, step: usize) -> Result<Panel, DrawError> {
    let old: usize = NEW[..step - 1].iter().sum();
    let until = old + NEW[step - 1];
    let mut bodies = Vec::new();
    for simplex in 0..until {
        let colour = if simplex < old { OLD } else { FRESH };
        let places = patch(tiling, SimplexId::at(simplex)).into_iter();
        bodies.extend(places.map(|corners| Body { corners, colour }));
    }
    let mut scene = Scene::new(view);
    scene.add_solid(&bodies, None);
    let base = base(tiling);
    for ends in &base {
        scene.add_line(Line {
            ends: ends.clone(),
            visible: Stroke::Edge,
            hidden: None,
        });
    }
    let corners = bodies.iter().flat_map(|body| &body.corners);
    let vertices: BTreeSet<&Point> = corners.chain(base.iter().flatten()).collect();
    for at in vertices {
        scene.add_dot(Dot {
            at: at.clone(),
            radius: 0.45,
            colour: layer(&at[2]),
            shines_through: false,
        });
    }
    Ok(Panel {
        items: scene.items()?,
        caption: format!("step {step}"),
    })
}

/// The edges of the grid in the base plane: those of the tetrahedra of step 2.
fn base(tiling: &Tiling<3>) -> BTreeSet<[Point; 2]> {
    let bodies = (0..NEW[1]).flat_map(|simplex| patch(tiling, SimplexId::at(simplex)));
    let mut edges = BTreeSet::new();
    for corners in bodies {
        let mut low: Vec<Point> = corners.into_iter().filter(|p| p[2].is_zero()).collect();
        low.sort();
        for (i, j) in [(0, 1), (0, 2), (1, 2)] {
            edges.extend(low.get(j).map(|end| [low[i].clone(), end.clone()]));
        }
    }
    edges
}

/// The translates of a tetrahedron whose centre is near the vertical line through a vertex of the
/// grid.
fn patch(tiling: &Tiling<3>, simplex: SimplexId) -> Vec<[Point; 4]> {
    let limit = Number::from(Rational::from(REACH * REACH));
    let shifts = (-4..=4).flat_map(|i| (-4..=4).map(move |j| [i, j, 0]));
    let place = |shift: [i32; 3]| -> [Point; 4] {
        let corners = tiling.simplex(simplex);
        let moved = |corner: &Corner<3>| tiling.position(&corner.moved(shift));
        std::array::from_fn(|k| moved(&corners[k]))
    };
    let is_near = |corners: &[Point; 4]| {
        let mut middle = super::patch::centre(corners.iter());
        middle[2] = Number::zero();
        linear::square(&tiling.frame.gram, &middle) <= limit
    };
    shifts.map(place).filter(is_near).collect()
}

fn layer(height: &Number) -> Colour {
    let tenths = (height.approximate() * 10.0).round() as i64;
    let found = LAYERS.iter().find(|(until, _)| tenths <= *until);
    found.map_or(BLACK, |(_, colour)| *colour)
}

#[cfg(test)]
mod tests {
    use super::{NEW, layer};
    use acutile_catalog::build;
    use acutile_core::tiling::{AnyTiling, SimplexId};
    use acutile_exact::number::Number;
    use malachite::Rational;

    /// Section 4.3: the heights of the corners of the tetrahedra that each step places, in tenths.
    const HEIGHTS: [[i64; 4]; 7] = [
        [0, 0, 0, 40],
        [0, 0, 40, 40],
        [0, 40, 40, 46],
        [40, 40, 46, 71],
        [40, 46, 71, 71],
        [40, 71, 71, 71],
        [46, 71, 71, 96],
    ];

    #[test]
    fn the_steps_are_those_of_the_paper() {
        let AnyTiling::Space(slab) = build("slab").unwrap() else {
            panic!("the slab is not in space");
        };
        let mut simplex = 0;
        for (new, heights) in NEW[1..].iter().zip(HEIGHTS) {
            for _ in 0..*new {
                let corners = slab.simplex(SimplexId::at(simplex)).iter();
                let mut found: Vec<Number> = corners.map(|c| slab.position(c)[2].clone()).collect();
                found.sort();
                let tenths = |h: i64| Number::from(Rational::from_signeds(h, 10));
                assert_eq!(found, heights.map(tenths));
                simplex += 1;
            }
        }
        // The eighth step, and twice the first seven.
        assert_eq!(2 * (simplex - NEW[7]) + NEW[7], slab.len());
    }

    /// The caption of the figure of the slab: white, yellow, red, blue, black.
    #[test]
    fn layers_have_the_colours_of_the_paper() {
        let colours =
            [0, 40, 46, 71, 96].map(|h| layer(&Number::from(Rational::from_signeds(h, 10))));
        let brightest = |c: [u8; 3]| c.map(|x| x > 150);
        assert_eq!(
            colours.map(brightest),
            [
                [true; 3],
                [true, true, false],
                [true, false, false],
                [false, false, true],
                [false; 3]
            ]
        );
    }
}
