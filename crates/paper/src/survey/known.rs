//! Which constructions of the catalogue a triangulation is isomorphic to.

use super::Survey;
use super::study::{AnyStudy, Study};
use acutile_catalog as catalog;

/// The names of the constructions in a survey that a tiling of space is isomorphic to, in
/// the catalogue's order. Valences decide most cases before symbols are compared.
pub fn isomorphic_entries(study: &Study<3>, survey: &Survey) -> Vec<&'static str> {
    let Some(symbol) = study.symbol() else {
        return Vec::new();
    };
    let average = study.ridges.average_valence();
    let is_isomorphic = |name: &&str| match survey.get(name) {
        Ok(AnyStudy::Space(other)) => {
            other.ridges.average_valence() == average && other.symbol().as_ref() == Some(&symbol)
        }
        _ => false,
    };
    catalog::names().filter(is_isomorphic).collect()
}
