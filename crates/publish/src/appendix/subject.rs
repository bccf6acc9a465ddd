//! What an appendix is about: a certificate that the kernel confirmed, and what is
//! computed of its tiling for the tables.

use super::numeral::Numerals;
use super::tex::slug;
use crate::report::Proved;
use acutile_core::classify::{Ridges, Symmetry};
use acutile_core::quality::{Shape, shapes, squared_edges};
use acutile_core::statement::Statement;
use acutile_core::tiling::{AnyTiling, Matching, SimplexId, Tiling, match_facets};
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
    /// A confirmed certificate; nothing for a region, whose proof is another theorem than that of
    /// soundness.tex.
    pub fn of_proved(proved: &Proved) -> Option<Subject> {
        if proved.is_region() {
            return None;
        }
        Some(Subject {
            name: proved.name.clone(),
            description: proved.description.clone(),
            source: None,
            cbor: proved.certificate().to_vec(),
            json: proved.json().to_owned(),
            sha256: proved.sha256(),
            statements: proved.statements().to_vec(),
            tiling: proved.tiling().clone(),
        })
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
    pub symmetry: Symmetry<D>,
    cogram: [[Number; D]; D],
}

impl<'s, const D: usize> Analysis<'s, D> {
    pub fn of(subject: &'s Subject, tiling: &'s Tiling<D>) -> Self {
        let matching = match_facets(tiling);
        let edges: Vec<Vec<Number>> = tiling
            .indices()
            .map(|simplex| squared_edges(tiling, simplex))
            .collect();
        Analysis {
            subject,
            tiling,
            numerals: Numerals::of(&tiling.frame.field),
            ridges: Ridges::of(tiling, &matching),
            shapes: shapes(tiling),
            symmetry: Symmetry::of(tiling, &matching, &edges),
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

    /// The class of each simplex.
    pub fn class_of(&self) -> Vec<usize> {
        let mut classes = vec![0; self.tiling.len()];
        for (class, shape) in self.shapes.iter().enumerate() {
            for &member in &shape.members {
                classes[member.index()] = class;
            }
        }
        classes
    }

    /// The first simplex of each orbit, and how many there are.
    pub fn orbits(&self) -> Vec<(SimplexId, usize)> {
        let orbits = first_and_count(&self.symmetry.simplices).into_iter();
        orbits
            .map(|(first, count)| (SimplexId::at(first), count))
            .collect()
    }
}

/// For each of the numbers 0, 1, … the place of its first occurrence, and how often
/// it occurs.
pub(super) fn first_and_count(numbers: &[usize]) -> Vec<(usize, usize)> {
    let mut found: Vec<(usize, usize)> = Vec::new();
    for (place, &number) in numbers.iter().enumerate() {
        match found.get_mut(number) {
            Some((_, count)) => *count += 1,
            None => found.push((place, 1)),
        }
    }
    found
}
