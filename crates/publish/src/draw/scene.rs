//! The visible parts of one panel: opaque tetrahedra, lines and points in space become marks, without their
//! hidden parts.

use super::DrawError;
use super::drawing::{Colour, Item, Stroke, lit};
use super::polygon::{Face, Point, on_segment};
use super::view::View;
use super::{hidden, order};
use acutile_exact::number::Number;
use std::collections::{BTreeMap, BTreeSet};

/// A tetrahedron with its colour.
#[derive(Clone, Debug)]
pub struct Body {
    pub corners: [Point; 4],
    pub colour: Colour,
}

/// A line, and how it is drawn where it is behind a face, if it is.
#[derive(Clone, Debug)]
pub struct Line {
    pub ends: [Point; 2],
    pub visible: Stroke,
    pub hidden: Option<Stroke>,
}

/// A point with its mark.
#[derive(Clone, Debug)]
pub struct Dot {
    pub at: Point,
    /// In millimetres.
    pub radius: f64,
    pub colour: Colour,
    /// Whether it is drawn where it is behind a face.
    pub shines_through: bool,
}

/// A collection of opaque bodies, lines and points.
#[derive(Clone, Debug)]
pub struct Scene<'v> {
    view: &'v View,
    faces: Vec<Face>,
    colours: Vec<Colour>,
    lines: Vec<Line>,
    dots: Vec<Dot>,
}

impl<'v> Scene<'v> {
    /// Nothing yet.
    pub fn new(view: &'v View) -> Self {
        Scene {
            view,
            faces: Vec::new(),
            colours: Vec::new(),
            lines: Vec::new(),
            dots: Vec::new(),
        }
    }

    /// Adds tetrahedra as one solid: facets that two of them share are inside. Edges behind faces are drawn
    /// as `hidden` says. Without it edges inside are ignored.
    pub fn add_solid(&mut self, bodies: &[Body], hidden: Option<Stroke>) {
        let mut facets: BTreeMap<Vec<&Point>, Vec<(usize, usize)>> = BTreeMap::new();
        for (body, Body { corners, .. }) in bodies.iter().enumerate() {
            for opposite in 0..4 {
                let mut key: Vec<&Point> = others(opposite).map(|k| &corners[k]).to_vec();
                key.sort();
                facets.entry(key).or_default().push((body, opposite));
            }
        }
        let mut edges: BTreeSet<[&Point; 2]> = BTreeSet::new();
        for (corners, places) in &facets {
            if places.len() == 1 || hidden.is_some() {
                edges.extend([(0, 1), (0, 2), (1, 2)].map(|(i, j)| [corners[i], corners[j]]));
            }
            if let [(body, opposite)] = places[..] {
                self.add_facet(&bodies[body], opposite);
            }
        }
        for [a, b] in edges {
            self.add_line(Line {
                ends: [a.clone(), b.clone()],
                visible: Stroke::Edge,
                hidden,
            });
        }
    }

    /// Only facets that face the eye: a line of sight leaves a solid through one of them.
    fn add_facet(&mut self, body: &Body, opposite: usize) {
        let corners = others(opposite).map(|k| body.corners[k].clone());
        let Some(face) = Face::triangle(corners, &self.view.eye) else {
            return;
        };
        if face.plane.value(&body.corners[opposite]).sign().is_lt() {
            let light = self.view.light(&face.corners);
            self.faces.push(face);
            self.colours.push(lit(body.colour, light));
        }
    }

    /// Adds a convex solid with this point inside: the faces that face the eye, and all edges.
    pub fn add_polyhedron(&mut self, faces: &[&[Point]], inside: &Point, colour: Colour) {
        let mut edges: BTreeSet<[&Point; 2]> = BTreeSet::new();
        for corners in faces {
            let next = corners.iter().cycle().skip(1);
            edges.extend(corners.iter().zip(next).map(
                |(p, q)| {
                    if p < q { [p, q] } else { [q, p] }
                },
            ));
            let Some(face) = Face::polygon(corners.to_vec(), &self.view.eye) else {
                continue;
            };
            if face.plane.value(inside).sign().is_lt() {
                self.colours
                    .push(lit(colour, self.view.light(&face.corners)));
                self.faces.push(face);
            }
        }
        for [a, b] in edges {
            self.add_line(Line {
                ends: [a.clone(), b.clone()],
                visible: Stroke::Edge,
                hidden: Some(Stroke::HiddenEdge),
            });
        }
    }

    /// Adds a line.
    pub fn add_line(&mut self, line: Line) {
        self.lines.push(line);
    }

    /// Adds a point.
    pub fn add_dot(&mut self, dot: Dot) {
        self.dots.push(dot);
    }

    /// The marks, in units of length: fills from the far to the near, hidden lines, visible
    /// lines, points.
    ///
    /// # Errors
    /// Where faces cross so often that there are too many pieces.
    pub fn items(&self) -> Result<Vec<Item>, DrawError> {
        let pieces = order::painted(&self.faces).ok_or(DrawError::TooManyPieces)?;
        let mut items: Vec<Item> = pieces
            .into_iter()
            .map(|piece| Item::Polygon {
                corners: piece.corners.iter().map(|p| self.view.place(p)).collect(),
                fill: self.colours[piece.face],
            })
            .collect();
        let (visible, hidden) = self.strokes();
        items.extend(hidden);
        items.extend(visible);
        let dots = self.dots.iter();
        let shown = dots.filter(|d| d.shines_through || hidden::is_visible(&d.at, &self.faces));
        items.extend(shown.map(|dot| Item::Dot {
            at: self.view.place(&dot.at),
            radius: dot.radius,
            fill: dot.colour,
        }));
        Ok(items)
    }

    /// The visible and the hidden parts of all lines.
    fn strokes(&self) -> (Vec<Item>, Vec<Item>) {
        let (mut visible, mut hidden) = (Vec::new(), Vec::new());
        for line in &self.lines {
            let [a, b] = &line.ends;
            let place = |s: &Number| self.view.place(&on_segment(a, b, s));
            for part in hidden::parts(a, b, &self.faces, &self.view.eye) {
                let ends = [place(&part.from), place(&part.to)];
                match (part.is_visible, line.hidden) {
                    (true, _) => visible.push(Item::Line {
                        ends,
                        stroke: line.visible,
                    }),
                    (false, Some(stroke)) => hidden.push(Item::Line { ends, stroke }),
                    (false, None) => {}
                }
            }
        }
        (visible, hidden)
    }
}

/// The three corners other than this one.
fn others(opposite: usize) -> [usize; 3] {
    [1, 2, 3].map(|step| (opposite + step) % 4)
}
