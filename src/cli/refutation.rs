//! The defects of a tiling, in words for people and as data for machines. Each kind comes with its
//! count, the first of each with names, coordinates and advice. As data all defects are given, one JSON
//! object a line.

use super::named::Named;
use super::output::Output;
use super::record::Record;
use acutile_core::advice::{Advice, Adviser};
use acutile_core::checker::{Defect, Findings, Names, defect_data, describe};
use acutile_core::quality::short_point;
use acutile_core::tiling::{AnyTiling, Corner, SimplexId, Tiling};
use acutile_core::with_dimension;
use acutile_exact::number::Number;
use acutile_io::mesh::Origin;
use serde_json::{Value, json};

/// A refuted tiling.
pub struct Refuted {
    pub tiling: AnyTiling,
    /// The point of the box, for a member of a family.
    pub point: Option<String>,
    /// The numbers of the file, for a mesh.
    pub origin: Option<Origin>,
    /// The changes that were made to the input.
    pub notes: Vec<String>,
    pub findings: Findings,
    /// The verdict after a repair.
    pub second: SecondLook,
    /// Whether long numbers are written in full.
    pub is_exact: bool,
    /// The number of defects of each kind that people see, if --max-defects says it.
    pub shown: Option<usize>,
}

/// The verdict on a refuted tiling after a repair.
#[derive(Default)]
pub struct SecondLook {
    /// Sentences for people.
    pub sentences: Vec<String>,
    /// The sentence that says all there is to say.
    pub instead: Option<String>,
}

/// The number of defects of each kind that a page lists.
pub const LISTED: usize = 100;

/// The number of defects of each kind that people see without --max-defects.
pub const SHOWN: usize = 20;

/// The same on a terminal.
const FEW: usize = 5;

/// The number of defects of each kind that get advice, which takes time.
const ADVISED: usize = 20;

impl Refuted {
    /// Defects of a tiling that was read.
    pub fn of(named: &Named, findings: Findings) -> Self {
        Refuted {
            point: None,
            tiling: named.tiling.clone(),
            origin: named.origin.clone(),
            notes: named.notes.clone(),
            findings,
            second: SecondLook::default(),
            is_exact: false,
            shown: None,
        }
    }

    /// Tells about the refutation of `input`: lines for people, or a JSON object.
    pub fn tell(&self, input: &str, output: &mut Output) {
        with_dimension!(&self.tiling, AnyTiling, t => {
                    let names = names(t, self.origin.as_ref(), self.is_exact);
                    if output.is_json() {
        self.in_json(t, &names, input, output)
        } else {
        self.in_words(t, &names, input, output)
        }
                });
    }

    fn in_words<const D: usize>(
        &self,
        tiling: &Tiling<D>,
        names: &Names,
        input: &str,
        output: &mut Output,
    ) {
        let place = self.point.as_ref().map(|point| format!(" at {point}"));
        let place = place.unwrap_or_default();
        let instead = self.second.instead.clone();
        let sentence = instead.clone().unwrap_or_else(|| counts(&self.findings));
        let subject = format!("{input}{place}");
        let whole = format!("{input}: refuted{place}: {sentence}");
        output.tell(&subject, "refuted", &[sentence], &whole);
        if instead.is_some() {
            return;
        }
        let shown = self.shown.unwrap_or_else(|| match output.look() {
            Some(_) => FEW,
            None => SHOWN,
        });
        let is_terminal = output.look().is_some();
        let mut line = |text: String| output.say(text);
        let mut left = 0;
        for sentence in &self.second.sentences {
            line(format!("  > {sentence}"));
        }
        let consequences = self.findings.consequences().iter();
        let consequences: Vec<String> = consequences
            .map(|(code, n)| format!("{n} {code}"))
            .collect();
        if !consequences.is_empty() {
            line(format!(
                "  consequences of these: {}",
                consequences.join(", ")
            ));
        }
        let adviser = Adviser::new(tiling);
        for (code, count) in self.findings.counts() {
            let kept = self.findings.kept().iter();
            let kept = kept.filter(|defect| defect.code() == *code);
            let kept: Vec<&Defect> = kept.take(shown).collect();
            left += count - kept.len();
            match kept.len() {
                0 => continue,
                n if n < *count => line(format!("  {code}: {count}, the first {n}:")),
                _ => line(format!("  {code}: {count}")),
            }
            for (index, defect) in kept.into_iter().enumerate() {
                line(format!("    {}", describe::<D>(names, defect)));
                for place in self.places(tiling, names, defect) {
                    line(format!("      {place}"));
                }
                for advice in advice(&adviser, defect, index) {
                    line(format!("      > {}", self.told(&advice, names)));
                }
            }
        }
        if is_terminal && left > 0 {
            line(format!(
                "  and {left} more; --max-defects N shows N of each kind, --json shows all"
            ));
        }
    }

    /// The verdict with the counts, and all defects; each is printed before the next one is made, as
    /// there may be millions.
    fn in_json<const D: usize>(
        &self,
        tiling: &Tiling<D>,
        names: &Names,
        input: &str,
        output: &mut Output,
    ) {
        let counts = self.findings.counts();
        let mut head = json!({
            "counts": counts,
            "consequences": self.findings.consequences(),
            "after_repair": self.second.instead.iter().chain(&self.second.sentences).collect::<Vec<_>>(),
        });
        if let Some(point) = &self.point {
            head["point"] = json!(point);
        }
        let record = Record::of(Some(input)).verdict("refuted");
        let head = output.record(record.notes(&self.notes).with(head)).text();
        let head = head.strip_suffix('}').unwrap_or(&head);
        output.say_part(&format!("{head},\"defects\":["));
        let adviser = Adviser::new(tiling);
        let mut seen = std::collections::BTreeMap::new();
        for (number, defect) in self.findings.kept().iter().enumerate() {
            let index = seen.entry(defect.code()).or_insert(0);
            let advice = advice(&adviser, defect, *index);
            *index += 1;
            let advice: Vec<String> = advice.iter().map(|a| self.told(a, names)).collect();
            let mut data = defect_data(tiling, names, defect);
            if let Value::Object(members) = &mut data {
                members.insert("advice".to_owned(), json!(advice));
            }
            let comma = if number == 0 { "" } else { "," };
            output.say_part(&format!("{comma}{data}"));
        }
        output.say_part("]}\n");
    }

    /// The corners of each simplex of a defect with their coordinates, the first few simplices.
    pub(super) fn places<const D: usize>(
        &self,
        tiling: &Tiling<D>,
        names: &Names,
        defect: &Defect,
    ) -> Vec<String> {
        const FEW: usize = 4;
        let simplices = defect.simplices().into_iter().take(FEW);
        let place = |simplex: SimplexId| {
            let corners = tiling.simplex(simplex).iter().enumerate();
            let corners = corners.map(|(k, corner)| {
                let position = self.point(&tiling.position(corner));
                format!("{} at {position}", names.corner(simplex, k))
            });
            let corners = corners.collect::<Vec<_>>().join(", ");
            format!("{}: {corners}", names.simplex(simplex))
        };
        simplices.map(place).collect()
    }

    /// A point in the coordinates of the file where it is a mesh, else in the basis.
    fn point<const D: usize>(&self, point: &[Number; D]) -> String {
        match &self.origin {
            Some(origin) => short_point(&origin.cartesian(point), self.is_exact),
            None => short_point(point, self.is_exact),
        }
    }

    pub(super) fn told<const D: usize>(&self, advice: &Advice<D>, names: &Names) -> String {
        in_words(advice, names, &|point| self.point(point))
    }
}

/// `2 overlap, 3 flat`
pub fn counts(findings: &Findings) -> String {
    let pairs = findings.counts().iter();
    pairs
        .map(|(code, count)| format!("{count} {code}"))
        .collect::<Vec<_>>()
        .join(", ")
}

/// Indices, or the numbers of the file that a mesh was read from.
pub fn names<'a, const D: usize>(
    tiling: &'a Tiling<D>,
    origin: Option<&'a Origin>,
    is_exact: bool,
) -> Names<'a> {
    let Some(origin) = origin else {
        return Names::of(tiling).exact(is_exact);
    };
    Names::new(
        |simplex| {
            let element = origin.tetrahedron(simplex);
            match element.line {
                Some(line) => format!("element {} (line {line})", element.tag),
                None => format!("element {}", element.tag),
            }
        },
        |simplex, corner| origin.corner(simplex, corner).to_string(),
        |vertex| format!("node {}", origin.vertex(vertex)),
    )
    .with_labels(|simplex| Some(origin.label_name(origin.label(simplex)?)))
    .with_points(|point| origin.cartesian(point))
    .exact(is_exact)
}

/// The first defects of a kind get advice.
pub(super) fn advice<const D: usize>(
    adviser: &Adviser<D>,
    defect: &Defect,
    index: usize,
) -> Vec<Advice<D>> {
    if index < ADVISED {
        adviser.advice(defect)
    } else {
        Vec::new()
    }
}

fn in_words<const D: usize>(
    advice: &Advice<D>,
    names: &Names,
    point: &dyn Fn(&[Number; D]) -> String,
) -> String {
    let corner = |corner: &Corner<D>| {
        let name = names.vertex(corner.vertex.index());
        if corner.shift == [0; D] {
            name
        } else {
            let shift = corner.shift.map(|s| s.to_string());
            format!(
                "{name} moved by ({}) lattice vectors",
                shift.as_slice().join(", ")
            )
        }
    };
    advice.in_words(&corner, &|simplex| names.simplex(simplex), point)
}
