//! What an appendix is about: a certificate that the kernel confirmed, and what is
//! computed of its tiling for the tables.

use super::numeral::Numerals;
use super::orbits::Orbits;
use super::tex::{moved, slug};
use crate::report::Proved;
use acutile_core::classify::{Ridges, Symmetry};
use acutile_core::quality::{Shape, shapes, squared_edges};
use acutile_core::statement::Statement;
use acutile_core::tiling::{AnyTiling, Matching, Mate, SimplexId, Tiling, match_facets};
use acutile_exact::geometry::{NormalProducts, linear};
use acutile_exact::number::Number;

/// A confirmed certificate with a name.
#[derive(Debug)]
pub struct Subject {
    /// What it is called in headings.
    pub name: String,
    /// What it is, in a line, or nothing; not part of what is proved.
    pub description: String,
    /// Where it comes from, in the words of the catalogue.
    pub source: Option<&'static str>,
    /// The certificate.
    pub(super) cbor: Vec<u8>,
    /// The same for people.
    pub(super) json: String,
    pub(super) sha256: String,
    statements: Vec<Statement>,
    pub(super) tiling: AnyTiling,
}

impl Subject {
    /// A confirmed certificate.
    pub fn of_proved(proved: &Proved) -> Subject {
        Subject {
            name: proved.name.clone(),
            description: proved.description.clone(),
            source: None,
            cbor: proved.certificate().to_vec(),
            json: proved.json().to_owned(),
            sha256: proved.sha256(),
            statements: proved.statements().to_vec(),
            tiling: proved.tiling().clone(),
        }
    }

    /// The same subject with a source.
    pub fn from_source(self, source: &'static str) -> Subject {
        Subject {
            source: Some(source),
            ..self
        }
    }

    /// The name in files and labels.
    pub fn slug(&self) -> String {
        slug(&self.name)
    }

    /// Where the certificate stands beside the document.
    pub fn certificate_path(&self) -> String {
        format!("anc/{}.cbor", self.slug())
    }

    /// Where its JSON stands.
    pub(super) fn json_path(&self) -> String {
        format!("anc/{}.json", self.slug())
    }

    pub(super) fn statements(&self) -> &[Statement] {
        &self.statements
    }
}

/// A subject in its dimension, each thing computed once.
pub(super) struct Analysis<'s, const D: usize> {
    pub subject: &'s Subject,
    pub tiling: &'s Tiling<D>,
    pub numerals: Numerals,
    pub matching: Matching<D>,
    pub ridges: Ridges<D>,
    /// Squared edges 01, 02, …, 12, … of each simplex.
    pub edges: Vec<Vec<Number>>,
    pub shapes: Vec<Shape>,
    /// The class of each simplex.
    pub classes: Vec<usize>,
    pub orbits: Orbits<D>,
    /// The places of the representatives in the order of all tables: by class, then by tile.
    pub order: Vec<usize>,
    cogram: [[Number; D]; D],
}

impl<'s, const D: usize> Analysis<'s, D> {
    pub fn of(subject: &'s Subject, tiling: &'s Tiling<D>) -> Self {
        let matching = match_facets(tiling);
        let edges: Vec<Vec<Number>> = tiling
            .indices()
            .map(|simplex| squared_edges(tiling, simplex))
            .collect();
        let symmetry = Symmetry::of(tiling, &matching, &edges);
        let shapes = shapes(tiling);
        let classes = classes(&shapes, tiling.len());
        let orbits = Orbits::of(tiling, &symmetry);
        let mut order: Vec<usize> = (0..orbits.representatives.len()).collect();
        order.sort_by_key(|&place| {
            let tile = orbits.representatives[place].tile;
            (classes[tile.index()], tile)
        });
        Analysis {
            subject,
            tiling,
            numerals: Numerals::of(&tiling.frame.field),
            ridges: Ridges::of(tiling, &matching),
            shapes,
            classes,
            orbits,
            order,
            cogram: linear::cofactors(&tiling.frame.gram),
            matching,
            edges,
        }
    }

    pub fn rank(&self) -> usize {
        self.tiling.frame.rank()
    }

    /// A label of this subject, `tab:a15-vertices`.
    pub fn label(&self, what: &str) -> String {
        format!("acutile:{}:{what}", self.subject.slug())
    }

    /// The inner products of the gradients of a simplex.
    pub fn products(&self, simplex: SimplexId) -> NormalProducts<Number, D> {
        self.tiling.shape(simplex).normal_products(&self.cogram)
    }

    /// `\gamma_{5}T_{3}^{1\bar10}`: an image of a representative, moved.
    pub fn image(&self, element: usize, representative: usize, shift: &[i32; D]) -> String {
        let tile = self.orbits.representatives[representative].tile;
        let map = match element {
            0 => String::new(),
            _ => format!("\\gamma_{{{element}}}"),
        };
        format!("{map}T_{{{tile}}}{}", moved(&shift[..self.rank()]))
    }

    /// The tile of a mate as an image of a representative, and the corner of that which is opposite
    /// to the mate.
    pub fn behind(&self, mate: &Mate<D>) -> (String, usize) {
        let image = &self.orbits.images[mate.facet.simplex.index()];
        let shift = std::array::from_fn(|k| image.shift[k] + mate.shift[k]);
        let tile = self.image(image.element, image.representative, &shift);
        (tile, image.corners[usize::from(mate.facet.opposite)])
    }
}

/// The class of each of `count` simplices.
fn classes(shapes: &[Shape], count: usize) -> Vec<usize> {
    let mut classes = vec![0; count];
    for (class, shape) in shapes.iter().enumerate() {
        for &member in &shape.members {
            classes[member.index()] = class;
        }
    }
    classes
}
