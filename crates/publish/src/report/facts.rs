//! Everything exact that a page shows of a tiling: for each simplex its class, volume, edges and
//! angles, every value once.

use crate::palette::Palette;
use acutile_core::classify::{Ridges, stars};
use acutile_core::quality::{
    DihedralAngle, Exact, Measures, Shape, kinds, measures_of_shapes, rational_root, root, shapes,
    squared_edges,
};
use acutile_core::tiling::{SimplexId, Tiling, match_facets};
use acutile_exact::geometry::linear;
use acutile_exact::number::Number;
use acutile_exact::number::radical::sign_over;
use malachite::Rational;
use std::collections::BTreeMap;

/// Different values, numbered in the order in which they came.
#[derive(Debug)]
pub struct Table<T> {
    pub values: Vec<T>,
    index: BTreeMap<T, usize>,
}

impl<T: Ord + Clone> Table<T> {
    fn new() -> Self {
        Table {
            values: Vec::new(),
            index: BTreeMap::new(),
        }
    }

    fn number(&mut self, value: T) -> usize {
        *self.index.entry(value).or_insert_with_key(|value| {
            self.values.push(value.clone());
            self.values.len() - 1
        })
    }
}

/// A simplex: its class, and indices into the tables of [`Facts`].
#[derive(Debug)]
pub struct Cell {
    pub class: usize,
    /// The volume in units of the basis' parallelepiped.
    pub volume: usize,
    /// Squared lengths of the edges 01, 02, …, 12, …
    pub edges: Vec<usize>,
    /// The angles between the facets opposite to the corners 0 and 1, 0 and 2, …
    pub angles: Vec<usize>,
}

/// What is known of a tiling whose hypotheses hold.
#[derive(Debug)]
pub struct Facts {
    /// Squared lengths and volumes.
    pub numbers: Table<Number>,
    pub angles: Table<DihedralAngle>,
    /// One for each simplex.
    pub cells: Vec<Cell>,
    /// The congruence class of each simplex.
    pub class_of: Vec<usize>,
    /// Congruence classes with their measures.
    pub classes: Vec<(Shape, Measures)>,
    /// For each vertex its type: Z12 … Z16 and others in space, the valence in the plane.
    pub types: Vec<String>,
}

/// More classes, or more simplices, are no help to a reader, and their exact values fill a page.
const MOST_CLASSES: usize = 300;
const MOST_SIMPLICES: usize = 20_000;

const NOT_FLAT: &str = "no simplex of a proved tiling is flat";

impl Facts {
    /// The colours of the classes.
    pub fn palette(&self) -> Palette {
        Palette::of(self.classes.iter().map(|(shape, _)| shape))
    }
}

// The constructors panic on flat simplices. They are for tilings that the kernel has confirmed.
impl Facts {
    /// Of a tiling of space; `None` if it has too many different simplices for tables.
    pub fn of_space(tiling: &Tiling<3>) -> Option<Facts> {
        let shapes = few_shapes(tiling)?;
        Some(Facts::with_types(tiling, shapes, types_of_space(tiling)))
    }

    /// Of a tiling of the plane; `None` if it has too many different triangles.
    pub fn of_plane(tiling: &Tiling<2>) -> Option<Facts> {
        let shapes = few_shapes(tiling)?;
        Some(Facts::with_types(tiling, shapes, types_of_plane(tiling)))
    }

    fn with_types<const D: usize>(
        tiling: &Tiling<D>,
        shapes: Vec<Shape>,
        types: Vec<String>,
    ) -> Facts {
        let class_of = kinds(&shapes, tiling.len());
        let measures = measures_of_shapes(tiling, &shapes).expect(NOT_FLAT);
        let mut facts = Facts {
            numbers: Table::new(),
            angles: Table::new(),
            cells: Vec::with_capacity(tiling.len()),
            class_of,
            classes: shapes.into_iter().zip(measures).collect(),
            types,
        };
        let cogram = linear::cofactors(&tiling.frame.gram);
        for simplex in tiling.indices() {
            facts.add(tiling, &cogram, simplex);
        }
        facts
    }

    fn add<const D: usize>(
        &mut self,
        tiling: &Tiling<D>,
        cogram: &[[Number; D]; D],
        simplex: SimplexId,
    ) {
        let shape = tiling.shape(simplex);
        let products = shape.normal_products(cogram);
        let factorial = Rational::from_unsigneds(1u64, (1..=D as u64).product());
        let volume = &shape.determinant * &Number::from(factorial);
        let edges = squared_edges(tiling, simplex).into_iter();
        let cell = Cell {
            class: self.class_of[simplex.index()],
            volume: self.numbers.number(volume),
            edges: edges.map(|square| self.numbers.number(square)).collect(),
            angles: products
                .pairs()
                .map(|(i, j, _)| {
                    let angle = DihedralAngle::between(&products, i, j);
                    self.angles.number(angle.expect(NOT_FLAT))
                })
                .collect(),
        };
        self.cells.push(cell);
    }
}

/// The type of each vertex: Z12 … Z16 and others.
pub fn types_of_space(tiling: &Tiling<3>) -> Vec<String> {
    stars(tiling).iter().map(ToString::to_string).collect()
}

/// The valence of each vertex of the plane, in words.
pub fn types_of_plane(tiling: &Tiling<2>) -> Vec<String> {
    let ridges = Ridges::of(tiling, &match_facets(tiling));
    let mut types = vec![String::new(); tiling.vertices.len()];
    for ridge in &ridges.list {
        let place = if ridge.is_boundary { "boundary, " } else { "" };
        let text = format!("{place}{} triangles", ridge.valence());
        // The ridges of the plane are its vertices.
        types[ridge.corners[0].vertex.index()] = text;
    }
    types
}

fn few_shapes<const D: usize>(tiling: &Tiling<D>) -> Option<Vec<Shape>> {
    if tiling.len() > MOST_SIMPLICES {
        return None;
    }
    Some(shapes(tiling)).filter(|shapes| shapes.len() <= MOST_CLASSES)
}

/// The congruence class of each simplex of a tiling.
pub fn classes<const D: usize>(tiling: &Tiling<D>) -> Vec<usize> {
    kinds(&shapes(tiling), tiling.len())
}

/// The cosine of an angle, exactly: `√(5/12)`, or with the field's generator `√(1/2 + 1/4 a)`.
pub fn cosine_text(angle: &DihedralAngle) -> String {
    let sign = if angle.signed_square.sign().is_lt() {
        "-"
    } else {
        ""
    };
    format!("{sign}{}", root_text(&angle.signed_square.abs()))
}

/// A square root, exactly.
pub fn root_text(square: &Number) -> String {
    root(square).unwrap_or_else(|| sign_over(&square.to_string()))
}

/// Bounds of the cosine, 1e-10 apart or less.
pub fn cosine_bounds(angle: &DihedralAngle) -> (Rational, Rational) {
    let square = angle.signed_square.abs();
    let width = Rational::from_signeds(1i64, 10_000_000_000);
    let (low, high) = match rational_root(&square) {
        Some(root) => (root.clone(), root),
        None => square.enclosure_of_root(&width),
    };
    if angle.signed_square.sign().is_lt() {
        (-high, -low)
    } else {
        (low, high)
    }
}

/// The middle of rational bounds, for pictures.
pub fn middle((low, high): &(Rational, Rational)) -> f64 {
    Number::from((low + high) / Rational::from(2)).approximate()
}

/// The angle in degrees, 1e-9 apart or less.
pub fn degrees(angle: &DihedralAngle) -> (Rational, Rational) {
    angle.enclosure(&Rational::from_signeds(1i64, 1_000_000_000))
}
