//! A figure as marks on paper: polygons, lines, dots and words, in the order in which they are
//! painted. The unit is a millimetre, x goes to the right and y up. Panels are arranged here, too.

pub use crate::palette::Colour;

/// A place on paper.
pub type Place = [f64; 2];

/// Black.
pub const BLACK: Colour = [0, 0, 0];
/// White.
pub const WHITE: Colour = [255, 255, 255];
/// Light grey.
pub const GREY: Colour = [200, 200, 200];

/// A colour mixed with white: the colour itself for `light` 0, a tenth white for 1, so that
/// no class gets the grey of another.
pub fn lit(colour: Colour, light: f64) -> Colour {
    colour.map(|x| (f64::from(x) + 0.1 * light * (255.0 - f64::from(x))).round() as u8)
}

/// The kinds of lines; a journal column wants weights of 0.1 mm and more.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stroke {
    /// An edge of a simplex.
    Edge,
    /// Such an edge behind a face.
    HiddenEdge,
    /// An edge of the lattice's cell.
    Cell,
    /// Such an edge behind a face.
    HiddenCell,
    /// A cell of the plane, also where it runs along edges.
    Outline,
}

impl Stroke {
    /// In millimetres.
    pub fn weight(self) -> f64 {
        match self {
            Stroke::Edge => 0.2,
            Stroke::HiddenEdge => 0.12,
            Stroke::Cell => 0.45,
            Stroke::HiddenCell => 0.25,
            Stroke::Outline => 0.6,
        }
    }

    /// Dark, so that it is seen on every fill.
    pub fn colour(self) -> Colour {
        match self {
            Stroke::Edge => BLACK,
            Stroke::HiddenEdge => [70, 70, 70],
            Stroke::Cell | Stroke::HiddenCell => [40, 40, 40],
            Stroke::Outline => [0, 80, 130],
        }
    }

    /// The lengths of dashes and gaps in millimetres, for a broken line.
    pub fn dash(self) -> Option<f64> {
        match self {
            Stroke::Edge | Stroke::Cell => None,
            Stroke::HiddenEdge => Some(0.7),
            Stroke::HiddenCell => Some(1.2),
            Stroke::Outline => Some(1.6),
        }
    }
}

/// A mark.
#[derive(Clone, Debug)]
pub enum Item {
    /// Filled, with a hair line of its colour so that no gap is seen between neighbours.
    Polygon {
        /// The corners, in order.
        corners: Vec<Place>,
        /// The colour.
        fill: Colour,
    },
    /// A line with round ends.
    Line {
        /// The two ends.
        ends: [Place; 2],
        /// Width and dashes.
        stroke: Stroke,
    },
    /// A disc with a thin black outline; the radius is in millimetres always.
    Dot {
        /// The centre.
        at: Place,
        /// The radius in millimetres.
        radius: f64,
        /// The colour.
        fill: Colour,
    },
    /// Words centred at a place, on white where `has_halo`.
    Label {
        /// The centre of the words.
        at: Place,
        /// The words, without markup.
        text: String,
        /// Whether they are on white.
        has_halo: bool,
    },
}

/// The height of letters' bodies in millimetres: 7 points.
pub const FONT: f64 = 2.46;
/// A mean letter's width in parts of [`FONT`].
const LETTER: f64 = 0.5;

/// An estimate of the width of a text in millimetres.
pub fn text_width(text: &str) -> f64 {
    text.chars().count() as f64 * LETTER * FONT
}

/// A picture in some unit of length with words below it.
#[derive(Clone, Debug)]
pub struct Panel {
    /// The marks, from the back to the front.
    pub items: Vec<Item>,
    /// The words below it.
    pub caption: String,
}

/// A whole figure.
#[derive(Clone, Debug)]
pub struct Drawing {
    /// For the file, not for the paper.
    pub title: String,
    /// In millimetres.
    pub size: [f64; 2],
    /// The marks, from the back to the front.
    pub items: Vec<Item>,
}

impl Drawing {
    /// Whether everything has a place.
    pub fn is_finite(&self) -> bool {
        let places = self.items.iter().flat_map(Item::places);
        let mut numbers = places.flatten().chain(&self.size);
        numbers.all(|x| x.is_finite())
    }
}

/// How panels are arranged.
#[derive(Clone, Debug)]
pub struct Layout {
    /// Of the figure, in millimetres.
    pub width: f64,
    /// Panels beside one another.
    pub columns: usize,
    /// Around each panel, in millimetres.
    pub margin: f64,
    /// Whether all panels have one scale; else each fills its place.
    pub has_one_scale: bool,
    /// Colours and what they mean, below everything.
    pub legend: Vec<(Colour, String)>,
}

/// No panel is higher than this many times its width.
const HIGHEST: f64 = 1.5;
/// The height of a line of words.
const LINE: f64 = 1.6 * FONT;

impl Layout {
    /// The panels in rows, each in the middle of its place.
    pub fn arrange(&self, title: &str, panels: &[Panel]) -> Drawing {
        let columns = self.columns.clamp(1, panels.len().max(1));
        let cell = self.width / columns as f64;
        let room = (cell - 2.0 * self.margin).max(1.0);
        let boxes: Vec<[Place; 2]> = panels.iter().map(bounds).collect();
        let scales = self.scales(&boxes, room);
        let mut items = Vec::new();
        let mut top = 0.0;
        for first in (0..panels.len()).step_by(columns) {
            let row = first..panels.len().min(first + columns);
            let heights = row.clone().map(|k| extent(&boxes[k], 1) * scales[k]);
            let height = heights.fold(0.0, f64::max) + 2.0 * self.margin;
            for k in row.clone() {
                let centre = [((k - first) as f64 + 0.5) * cell, top - height / 2.0];
                let [low, high] = boxes[k];
                let place = |p: Place| -> Place {
                    [0, 1].map(|i| centre[i] + scales[k] * (p[i] - (low[i] + high[i]) / 2.0))
                };
                items.extend(panels[k].items.iter().map(|item| item.moved(&place)));
                let below = [centre[0], top - height - LINE / 3.0];
                items.extend(caption(below, &panels[k].caption));
            }
            let has_caption = row.into_iter().any(|k| !panels[k].caption.is_empty());
            top -= height + if has_caption { LINE * 1.3 } else { 0.0 };
        }
        top = self.add_legend(&mut items, top);
        let up = |p: Place| [p[0], p[1] - top];
        Drawing {
            title: title.to_owned(),
            size: [self.width, -top],
            items: items.iter().map(|item| item.moved(&up)).collect(),
        }
    }

    /// Millimetres for a unit of each panel.
    fn scales(&self, boxes: &[[Place; 2]], room: f64) -> Vec<f64> {
        let scale = |b: &[Place; 2]| (room / extent(b, 0)).min(HIGHEST * room / extent(b, 1));
        let scales: Vec<f64> = boxes.iter().map(scale).collect();
        let least = scales.iter().copied().fold(f64::INFINITY, f64::min);
        if self.has_one_scale {
            vec![least; boxes.len()]
        } else {
            scales
        }
    }

    /// A row of swatches, or several; returns where it ends.
    fn add_legend(&self, items: &mut Vec<Item>, top: f64) -> f64 {
        if self.legend.is_empty() {
            return top;
        }
        let (mut x, mut y) = (self.margin, top - LINE);
        for (fill, text) in &self.legend {
            let width = text_width(text);
            if x > self.margin && x + 5.0 + width > self.width - self.margin {
                (x, y) = (self.margin, y - LINE);
            }
            let radius = 1.0;
            items.push(Item::Dot {
                at: [x + radius, y],
                radius,
                fill: *fill,
            });
            items.extend(caption([x + 3.0 + width / 2.0, y], text));
            x += 6.0 + width;
        }
        y - LINE * 0.7
    }
}

fn caption(at: Place, text: &str) -> Option<Item> {
    (!text.is_empty()).then(|| Item::Label {
        at,
        text: text.to_owned(),
        has_halo: false,
    })
}

impl Item {
    fn moved(&self, place: &dyn Fn(Place) -> Place) -> Item {
        match self.clone() {
            Item::Polygon { corners, fill } => Item::Polygon {
                corners: corners.into_iter().map(place).collect(),
                fill,
            },
            Item::Line { ends, stroke } => Item::Line {
                ends: ends.map(place),
                stroke,
            },
            Item::Dot { at, radius, fill } => Item::Dot {
                at: place(at),
                radius,
                fill,
            },
            Item::Label { at, text, has_halo } => Item::Label {
                at: place(at),
                text,
                has_halo,
            },
        }
    }

    fn places(&self) -> &[Place] {
        match self {
            Item::Polygon { corners, .. } => corners,
            Item::Line { ends, .. } => ends,
            Item::Dot { at, .. } | Item::Label { at, .. } => std::slice::from_ref(at),
        }
    }
}

/// In one direction; not 0.
fn extent([low, high]: &[Place; 2], k: usize) -> f64 {
    (high[k] - low[k]).max(1e-9)
}

/// The least and the greatest coordinates; 0 of nothing.
fn bounds(panel: &Panel) -> [Place; 2] {
    let places: Vec<Place> = panel.items.iter().flat_map(Item::places).copied().collect();
    if places.is_empty() {
        return [[0.0; 2]; 2];
    }
    let all = |k: usize| places.iter().map(move |p| p[k]);
    [
        [0, 1].map(|k| all(k).fold(f64::INFINITY, f64::min)),
        [0, 1].map(|k| all(k).fold(f64::NEG_INFINITY, f64::max)),
    ]
}
