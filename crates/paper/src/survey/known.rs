//! Which constructions of the catalogue a triangulation is isomorphic to.

use super::Survey;
use super::fullerenes::space_fullerene;
use super::phases::frank_kasper_phase;
use super::stacks::candidate_words;
use super::study::{AnyStudy, Study};
use acutile_catalog as catalog;
use acutile_core::classify::{Ridges, Symbol, combinatorial_symbol};
use acutile_core::tiling::{AnyTiling, Domain, Tiling, match_facets};
use malachite::Rational;
use rayon::prelude::*;
use std::sync::LazyLock;

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
    catalog::types().filter(is_isomorphic).collect()
}

/// The names of known tilings that a tiling of space is isomorphic to. First come constructions of the
/// catalogue, then the stack of kagome layers, its number among the space fullerenes, and the P, M, R or T
/// phase.
pub fn isomorphic_to(study: &Study<3>, symbol: &Symbol<usize, 3>) -> Vec<String> {
    let average = study.ridges.average_valence();
    let of_catalog = averages()
        .iter()
        .filter(|(_, other)| *other == average)
        .map(|(name, _)| (*name).to_owned());
    let of_stacks = candidate_words(study)
        .into_iter()
        .map(|word| format!("kagome:{word}"));
    let mut names: Vec<String> = of_catalog
        .chain(of_stacks)
        .filter(|name| has_symbol(name, symbol))
        .collect();
    let digest = symbol.sha256();
    names.extend(space_fullerene(&digest));
    names.extend(frank_kasper_phase(&digest));
    names
}

/// The constructions of the catalogue that tile space, with their average valences. They are built and not
/// proved, once in a run.
fn averages() -> &'static [(&'static str, Option<Rational>)] {
    static AVERAGES: LazyLock<Vec<(&str, Option<Rational>)>> = LazyLock::new(|| {
        let names: Vec<&str> = catalog::types().collect();
        let average = |name: &&'static str| {
            let tiling = of_space(name)?;
            let ridges = Ridges::of(&tiling, &match_facets(&tiling));
            Some((*name, ridges.average_valence()))
        };
        names.par_iter().filter_map(average).collect()
    });
    &AVERAGES
}

fn of_space(name: &str) -> Option<Tiling<3>> {
    match catalog::build(name) {
        Ok(AnyTiling::Space(tiling)) if tiling.frame.domain == Domain::Space => Some(tiling),
        _ => None,
    }
}

fn has_symbol(name: &str, symbol: &Symbol<usize, 3>) -> bool {
    let found = of_space(name).and_then(|tiling| {
        let matching = match_facets(&tiling);
        combinatorial_symbol(&tiling, &matching, &Ridges::of(&tiling, &matching))
    });
    found.as_ref() == Some(symbol)
}
