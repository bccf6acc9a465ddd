//! The subject of an appendix: a certificate that the kernel confirmed, and the values of its tiling for
//! the tables.

use super::numeral::Numerals;
use super::orbits::Orbits;
use super::space_group::SpaceGroup;
use super::tex::{moved, slug};
use crate::report::Proved;
use acutile_core::classify::{Ridges, Star, Symmetry};
use acutile_core::family::{AnyFamily, ProvedFamily, Tree};
use acutile_core::format::print;
use acutile_core::patches::{System, Theorem};
use acutile_core::proved::hexadecimal;
use acutile_core::quality::{Shape, kinds, shapes, squared_edges};
use acutile_core::statement::Statement;
use acutile_core::tiling::{AnyTiling, Matching, Mate, SimplexId, Tiling, match_facets};
use acutile_core::with_dimension;
use acutile_exact::geometry::{NormalProducts, linear};
use acutile_exact::number::Number;

/// A confirmed certificate with a name.
#[derive(Debug)]
pub struct Subject {
    /// The name in headings.
    pub name: String,
    /// A description in a line, or nothing. It is no part of the proof.
    pub description: String,
    /// Where it comes from, in the words of the catalogue.
    pub source: Option<&'static str>,
    /// The certificate.
    pub(super) cbor: Vec<u8>,
    /// The same for people.
    pub(super) json: String,
    pub(super) sha256: String,
    statements: Vec<Statement>,
    pub(super) content: Content,
}

/// The subject of a certificate.
#[derive(Debug)]
pub(super) enum Content {
    Tiling(AnyTiling),
    /// With the tree of its leaves.
    Family(AnyFamily, Tree),
    /// With the claim in words.
    Patches(Box<System>, String),
}

impl Subject {
    /// The digest of the certificate, in hexadecimal digits.
    pub fn sha256(&self) -> &str {
        &self.sha256
    }

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
            content: Content::Tiling(proved.tiling().clone()),
        }
    }

    /// A confirmed certificate of a family.
    pub fn of_family(
        name: String,
        description: String,
        proved: &ProvedFamily,
        family: AnyFamily,
    ) -> Subject {
        // The kernel has read the bytes.
        let json = print::to_json(proved.certificate()).unwrap_or_default();
        Subject {
            name,
            description,
            source: None,
            cbor: proved.certificate().to_vec(),
            json: String::from_utf8(json).unwrap_or_default(),
            sha256: proved.sha256(),
            statements: proved.statements().to_vec(),
            content: Content::Family(family, proved.tree().clone()),
        }
    }

    /// A theorem about all tilings that a system of patches builds. `words` is its claim.
    pub fn of_system(
        name: String,
        description: String,
        theorem: &Theorem,
        system: System,
        words: String,
    ) -> Subject {
        let json = print::to_json(theorem.certificate()).unwrap_or_default();
        Subject {
            name,
            description,
            source: None,
            cbor: theorem.certificate().to_vec(),
            json: String::from_utf8(json).unwrap_or_default(),
            sha256: hexadecimal(&theorem.verified().sha256),
            statements: theorem.statements().to_vec(),
            content: Content::Patches(Box::new(system), words),
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

    /// The certificate, in CBOR.
    pub fn certificate(&self) -> &[u8] {
        &self.cbor
    }

    /// Where the certificate stands beside the document.
    pub fn certificate_path(&self) -> String {
        format!("anc/{}.cbor", self.slug())
    }

    /// Where its JSON stands.
    pub(super) fn json_path(&self) -> String {
        format!("anc/{}.json", self.slug())
    }

    /// Whether it is a region, which is what its tiles cover.
    pub(super) fn is_region(&self) -> bool {
        match &self.content {
            Content::Tiling(tiling) => {
                with_dimension!(tiling, AnyTiling, t => t.frame.domain.is_region())
            }
            Content::Family(..) | Content::Patches(..) => false,
        }
    }

    pub(super) fn is_family(&self) -> bool {
        matches!(self.content, Content::Family(..))
    }

    pub(super) fn is_system(&self) -> bool {
        matches!(self.content, Content::Patches(..))
    }

    /// Whether it is about tetrahedra.
    pub(super) fn is_in_space(&self) -> bool {
        matches!(
            self.content,
            Content::Tiling(AnyTiling::Space(_))
                | Content::Family(AnyFamily::Space(_), _)
                | Content::Patches(..)
        )
    }

    pub(super) fn statements(&self) -> &[Statement] {
        &self.statements
    }
}

/// A subject in its dimension, each thing computed once.
pub(super) struct Analysis<'s, const D: usize> {
    pub subject: &'s Subject,
    pub tiling: &'s Tiling<D>,
    /// The type of each vertex's star in space.
    pub stars: Vec<Star>,
    pub numerals: Numerals,
    pub matching: Matching<D>,
    pub ridges: Ridges<D>,
    /// Squared edges 01, 02, …, 12, … of each simplex.
    pub edges: Vec<Vec<Number>>,
    pub shapes: Vec<Shape>,
    /// The class of each simplex.
    pub classes: Vec<usize>,
    pub orbits: Orbits<D>,
    /// Its type; none where it is no space group or is not found.
    pub space_group: Option<SpaceGroup>,
    /// The places of the representatives in the order of all tables: by class, then by tile.
    pub order: Vec<usize>,
    cogram: [[Number; D]; D],
}

impl<'s, const D: usize> Analysis<'s, D> {
    pub fn of(subject: &'s Subject, tiling: &'s Tiling<D>, stars: Vec<Star>) -> Self {
        let matching = match_facets(tiling);
        let edges: Vec<Vec<Number>> = tiling
            .indices()
            .map(|simplex| squared_edges(tiling, simplex))
            .collect();
        let symmetry = Symmetry::of(tiling, &matching, &edges);
        let shapes = shapes(tiling);
        let classes = kinds(&shapes, tiling.len());
        let orbits = Orbits::of(tiling, &symmetry);
        let mut order: Vec<usize> = (0..orbits.representatives.len()).collect();
        order.sort_by_key(|&place| {
            let tile = orbits.representatives[place].tile;
            (classes[tile.index()], tile)
        });
        let numerals = Numerals::of(&tiling.frame.field);
        Analysis {
            subject,
            tiling,
            stars,
            space_group: SpaceGroup::of(tiling, &orbits, &numerals),
            numerals,
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
