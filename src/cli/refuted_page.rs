//! A refuted tiling as an article of a page: the words of `certify`, with the places of the defects.

use super::defects::facets;
use super::family::member_at;
use super::refutation::{LISTED, Refuted, advice, counts, names};
use acutile_core::advice::Adviser;
use acutile_core::checker::{Defect, Names, describe};
use acutile_core::format::{self, print};
use acutile_core::tiling::{AnyTiling, SimplexId, Tiling};
use acutile_core::{refusal, transcribe, with_dimension};
use acutile_exact::number::Number;
use acutile_kernel::{Place, Refusal};
use acutile_publish::report::{Listed, Refutation};
use std::collections::BTreeMap;

impl Refuted {
    /// The article; `name` is its heading.
    pub fn article(&self, name: &str) -> Refutation {
        with_dimension!(&self.tiling, AnyTiling, t => self.article_of(t, name))
    }

    fn article_of<const D: usize>(&self, tiling: &Tiling<D>, name: &str) -> Refutation {
        let names = names(tiling, self.origin.as_ref(), self.is_exact);
        let adviser = Adviser::new(tiling);
        let mut seen: BTreeMap<&str, usize> = BTreeMap::new();
        let mut defects = Vec::new();
        for defect in self.findings.kept() {
            let index = seen.entry(defect.code()).or_insert(0);
            if *index < LISTED {
                let advice = advice(&adviser, defect, *index);
                let advice = advice.iter().map(|a| self.told(a, &names)).collect();
                defects.push(Listed {
                    advice,
                    ..self.listed(tiling, &names, defect)
                });
            }
            *index += 1;
        }
        let ids = defects.iter().flat_map(|d| d.simplices.iter());
        let second = self.second.instead.iter().chain(&self.second.sentences);
        let notes = self.notes.iter().chain(second).cloned();
        Refutation {
            name: name.to_owned(),
            refused: None,
            verdict: self.verdict(),
            notes: self.point.iter().map(at_point).chain(notes).collect(),
            tiling: self.tiling.clone(),
            counts: self.findings.counts().clone(),
            names: ids.map(|&id| (id, names.simplex(id))).collect(),
            defects,
        }
    }

    fn verdict(&self) -> String {
        let consequences = self.findings.consequences().iter();
        let consequences: Vec<String> = consequences.map(|(c, n)| format!("{n} {c}")).collect();
        let found = counts(&self.findings);
        if consequences.is_empty() {
            format!("Refuted: {found}.")
        } else {
            format!(
                "Refuted: {found}. Consequences of these: {}.",
                consequences.join(", ")
            )
        }
    }

    /// Without advice.
    fn listed<const D: usize>(&self, tiling: &Tiling<D>, names: &Names, defect: &Defect) -> Listed {
        let facets = facets(defect);
        let mut simplices: Vec<SimplexId> = defect.simplices();
        simplices.extend(facets.iter().map(|facet| facet.simplex));
        simplices.sort_unstable();
        simplices.dedup();
        Listed {
            code: defect.code(),
            words: describe::<D>(names, defect),
            places: self.places(tiling, names, defect),
            advice: Vec::new(),
            simplices,
            facets,
            point: point(defect),
        }
    }
}

/// The article of a certificate that the kernel refuses, with the simplex of the refusal in the picture.
/// `None` if it does not describe a tiling or a family.
pub fn refused(name: String, bytes: &[u8], refusal: &Refusal) -> Option<Refutation> {
    let cbor = format::to_cbor(bytes).ok()?;
    let (tiling, notes) = described(&cbor)?;
    let json = String::from_utf8(print::to_json(&cbor).ok()?).ok()?;
    let count = with_dimension!(&tiling, AnyTiling, t => t.len());
    let simplex = match refusal.place {
        Place::Simplex(s) | Place::Facet(s, _) | Place::Edge(s, ..) | Place::Angle(s, ..) => {
            u32::try_from(s).ok().filter(|&s| (s as usize) < count)
        }
        _ => None,
    };
    let code = refusal.code.text();
    let listed = Listed {
        code,
        words: refusal::message(refusal),
        places: Vec::new(),
        advice: Vec::new(),
        simplices: simplex.map(SimplexId::new).into_iter().collect(),
        facets: Vec::new(),
        point: None,
    };
    Some(Refutation {
        name,
        refused: Some(json),
        verdict: format!(
            "The kernel refuses this certificate: {}.",
            refusal::in_words(refusal)
        ),
        notes,
        tiling,
        counts: BTreeMap::from([(code, 1)]),
        defects: vec![listed],
        names: BTreeMap::new(),
    })
}

/// The tiling of a certificate, or a member of its family and a note that names it.
fn described(cbor: &[u8]) -> Option<(AnyTiling, Vec<String>)> {
    if format::kind(cbor) != Some(format::FAMILY) {
        let (tiling, _) = transcribe::of_certificate(cbor).ok()?;
        return Some((tiling, Vec::new()));
    }
    let (family, ..) = transcribe::family::of_certificate(cbor).ok()?;
    let (tiling, point) = member_at(&family, None).ok()?;
    Some((tiling, vec![at_point(&point)]))
}

fn at_point(point: &String) -> String {
    format!("The picture shows the member of the family at {point}.")
}

fn point(defect: &Defect) -> Option<Vec<f64>> {
    match defect {
        Defect::Overlap { point, .. } | Defect::BoundaryMeets { point, .. } => {
            Some(point.iter().map(Number::approximate).collect())
        }
        _ => None,
    }
}
