//! Which constructions of the catalogue a triangulation is isomorphic to.

use super::Survey;
use super::study::{AnyStudy, Study};
use acutile_catalog as catalog;
use acutile_core::classify::{Ridges, combinatorial_symbol};
use acutile_core::tiling::{AnyTiling, Domain, match_facets};

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

/// The names of all constructions of the catalogue that a tiling of space is isomorphic to. They are built
/// and not proved, and most have another average valence.
pub fn isomorphic_in_catalog(study: &Study<3>) -> Vec<&'static str> {
    let average = study.ridges.average_valence();
    let mut symbol = None;
    let mut is_isomorphic = |name: &&str| {
        let Some(Ok(AnyTiling::Space(tiling))) = catalog::find(name).map(|entry| entry.build())
        else {
            return false;
        };
        if tiling.frame.domain != Domain::Space {
            return false;
        }
        let matching = match_facets(&tiling);
        let ridges = Ridges::of(&tiling, &matching);
        if ridges.average_valence() != average {
            return false;
        }
        let own = symbol.get_or_insert_with(|| study.symbol());
        own.is_some() && combinatorial_symbol(&tiling, &matching, &ridges) == *own
    };
    catalog::names()
        .filter(|name| is_isomorphic(name))
        .collect()
}
