//! The facts about a construction, each computed once: the tiling, its certificate's hash,
//! congruence classes, measures and combinatorics.
//!
//! The table, the paper's statements and the classification all read studies, so that a construction is
//! built and proved once in a run. Only proved tilings have a study.

mod fullerenes;
mod general;
mod known;
mod phases;
mod stacks;
mod study;

pub use general::General;
pub use known::{isomorphic_entries, isomorphic_to};
pub use study::{AnyStudy, NotStudied, Study};

use acutile_catalog as catalog;
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::sync::OnceLock;

/// Studies of several constructions by name, or why there is none.
pub struct Survey {
    studies: BTreeMap<String, Result<AnyStudy, String>>,
    /// Families and systems of patches, once one is asked for.
    generals: OnceLock<BTreeMap<String, Result<General, String>>>,
}

impl Survey {
    /// Studies these constructions of the catalogue, several at a time.
    pub fn of(names: &[&str]) -> Survey {
        let study = |name: &&str| ((*name).to_owned(), AnyStudy::of_entry(name));
        Survey {
            studies: names.par_iter().map(study).collect(),
            generals: OnceLock::new(),
        }
    }

    /// Studies the whole catalogue.
    pub fn of_catalog() -> Survey {
        Survey::of(&catalog::names().collect::<Vec<_>>())
    }

    /// The study of a construction.
    ///
    /// # Errors
    /// Why there is none, in a message that names the construction.
    pub fn get(&self, name: &str) -> Result<&AnyStudy, String> {
        match self.studies.get(name) {
            Some(Ok(study)) => Ok(study),
            Some(Err(message)) => Err(message.clone()),
            None => Err(format!("{name}: not in this build")),
        }
    }

    /// The study of a construction of space.
    ///
    /// # Errors
    /// As [`Survey::get`].
    pub fn space(&self, name: &str) -> Result<&Study<3>, String> {
        match self.get(name)? {
            AnyStudy::Space(study) => Ok(study),
            AnyStudy::Plane(_) => Err(format!("{name}: is not in space")),
        }
    }

    /// What is proved of all members of a construction: a family or a system of patches of the catalogue.
    ///
    /// # Errors
    /// As [`Survey::get`].
    pub fn general(&self, name: &str) -> Result<&General, String> {
        let generals = self.generals.get_or_init(|| {
            let theorems = catalog::THEOREMS.iter().map(|theorem| theorem.name);
            let names: Vec<&str> = catalog::family_names().chain(theorems).collect();
            let general = |name: &&str| ((*name).to_owned(), General::of_entry(name));
            names.par_iter().map(general).collect()
        });
        match generals.get(name) {
            Some(Ok(general)) => Ok(general),
            Some(Err(message)) => Err(message.clone()),
            None => Err(format!("{name}: not in this build")),
        }
    }

    /// All studies of space, by name.
    pub fn spaces(&self) -> impl Iterator<Item = (&str, &Study<3>)> {
        self.studies.iter().filter_map(|(name, study)| match study {
            Ok(AnyStudy::Space(study)) => Some((name.as_str(), study)),
            _ => None,
        })
    }

    /// All studies of the plane, by name.
    pub fn planes(&self) -> impl Iterator<Item = (&str, &Study<2>)> {
        self.studies.iter().filter_map(|(name, study)| match study {
            Ok(AnyStudy::Plane(study)) => Some((name.as_str(), study)),
            _ => None,
        })
    }
}
