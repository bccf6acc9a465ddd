//! A second examination after an answer. A proof gets further facts. A refuted mesh is examined again
//! with its elements turned, its equal nodes merged, or contact allowed.

use super::answer::{Answer, Beside};
use super::certify_arguments::CertifyArguments;
use super::named::Named;
use super::refutation::{Refuted, SecondLook, counts, names};
use super::region;
use super::target::Target;
use super::words::printable;
use acutile_core::checker::{self, Defect, Findings, Options};
use acutile_core::curved::Validity;
use acutile_core::quality::short_decimal;
use acutile_core::statement::counted;
use acutile_core::tiling::{AnyTiling, Domain, Tiling, match_facets, merged};
use acutile_core::with_dimension;
use acutile_exact::number::Number;
use acutile_io::mesh::counted as elements;
use acutile_io::mesh::surface::{Comparison, compare, load_surface};
use malachite::Rational;
use serde_json::json;

/// Elements of other types, and whether some have the dimension of the mesh.
pub fn others(named: &Named) -> Option<(String, bool)> {
    const LOWER: [&str; 3] = ["lines", "points", "vertices"];
    const SURFACES: [&str; 3] = ["triangles", "quadrangles", "polygons"];
    if named.others.is_empty() {
        return None;
    }
    let is_space = matches!(named.tiling, AnyTiling::Space(_));
    let fills = |name: &String| {
        let is_lower = LOWER.iter().any(|kind| name.ends_with(kind)) || name.contains("boundary");
        let is_surface = SURFACES.iter().any(|kind| name.ends_with(kind)) || name == "pixels";
        !(is_lower || is_space && is_surface)
    };
    let counts = named.others.iter().map(|(name, n)| elements(*n, name));
    let counts = counts.collect::<Vec<_>>().join(", ");
    Some((counts, named.others.keys().any(fills)))
}

/// A proof with what is said beside it: the surface that is filled, and what the region looks like.
pub fn after_proof(
    answer: Answer,
    named: &Named,
    arguments: &CertifyArguments,
    beside: &mut Beside,
) -> Answer {
    if let Some(path) = &arguments.fills {
        match fills(path, named) {
            Ok(words) => beside.added.push(words),
            Err(answer) => return *answer,
        }
    }
    let required = arguments.required.iter().map(ToString::to_string);
    let parts = ["connected", "no-cavities", "manifold-boundary"];
    let decided: Vec<String> = required.filter(|r| parts.contains(&r.as_str())).collect();
    if !decided.is_empty() {
        let words = decided.join(", ");
        beside
            .added
            .push(format!("as required, and by the prover alone: {words}"));
    }
    beside.description = with_dimension!(&named.tiling, AnyTiling, t => {
        region::describe(t, &names(t, named.origin.as_ref(), false), named.origin.as_ref())
    });
    answer
}

/// A note on a periodic region, for users who expected a closed cell.
pub fn note_on_boundary<const D: usize>(tiling: &Tiling<D>) -> Option<String> {
    let Domain::Region(1..) = tiling.frame.domain else {
        return None;
    };
    let mismatches = match_facets(tiling).mismatches;
    let free = mismatches.iter().filter(|m| m.uses.len() == 1).count();
    (free > 0).then(|| {
        format!(
            "the lattice closes the mesh but for {} boundary; facets on the sides of the cell that \
             have no mate would be defects",
            counted(free, "facet, which is", "facets, which are")
        )
    })
}

/// Whether the boundary is the surface of a file, triangle by triangle.
fn fills(path: &std::path::Path, named: &Named) -> Result<String, Box<Answer>> {
    let name = printable(path);
    let AnyTiling::Space(tiling) = &named.tiling else {
        let message = format!("{}: --fills is for tetrahedra", named.name);
        return Err(Box::new(Answer::Failed(message)));
    };
    if tiling.frame.domain != Domain::Region(0) {
        let message = format!("{}: --fills is for a bounded mesh", named.name);
        return Err(Box::new(Answer::Failed(message)));
    }
    let surface =
        load_surface(path).map_err(|error| Box::new(Answer::Failed(format!("{name}: {error}"))))?;
    let Comparison {
        missing,
        surplus,
        reversed,
        is_rounded,
    } = compare(tiling, &match_facets(tiling), &surface);
    if missing.is_empty() && surplus.is_empty() {
        let rounded = if is_rounded {
            " after rounding of its coordinates to single precision"
        } else {
            ""
        };
        let turned = match reversed {
            0 => String::new(),
            n => format!(", {n} of them seen from the other side"),
        };
        let count = surface.triangles.len();
        return Ok(format!(
            "it fills the surface {name}: its boundary is{rounded} the {}{turned}",
            counted(count, "triangle", "triangles")
        ));
    }
    let findings = {
        let mut findings = Findings::new(20);
        if !missing.is_empty() {
            findings.add(Defect::NotOnSurface { facets: missing });
        }
        if !surplus.is_empty() {
            findings.add(Defect::NotBoundary { triangles: surplus });
        }
        findings
    };
    Err(Box::new(Answer::Refuted(Box::new(Refuted::of(
        named, findings,
    )))))
}

/// No longer number is written in full without --exact.
const LONG: usize = 24;

/// The answer for a mesh with curved elements: each element alone.
pub fn curved(input: &str, named: &Named, arguments: &CertifyArguments) -> Answer {
    with_dimension!(&named.tiling, AnyTiling, t => curved_elements(t, input, named, arguments))
}

fn curved_elements<const D: usize>(
    tiling: &Tiling<D>,
    input: &str,
    named: &Named,
    arguments: &CertifyArguments,
) -> Answer {
    let cells = if D == 2 { "triangles" } else { "tetrahedra" };
    let names = names(tiling, named.origin.as_ref(), false);
    let mut straight = tiling.clone();
    let turned = straight.orient();
    let is_curved = |simplex| {
        named
            .curved
            .binary_search_by_key(&simplex, |(s, _)| *s)
            .is_ok()
    };
    let number = |x: &Rational| match x.to_string() {
        text if text.len() <= LONG || arguments.exact => text,
        _ => format!("about {}", short_decimal(&Number::from(x.clone()))),
    };
    let mut undecided = Vec::new();
    for simplex in turned.into_iter().filter(|simplex| !is_curved(*simplex)) {
        let words = "is negatively oriented; --reorient turns it";
        undecided.push(format!("{} {words}", names.simplex(simplex)));
    }
    for (simplex, element) in &named.curved {
        let name = names.simplex(*simplex);
        match element.validity() {
            Validity::Valid => {}
            Validity::Invalid { corner, jacobian } => {
                let node = names.corner(*simplex, corner);
                undecided.push(format!(
                    "{name} is not valid: its Jacobian at node {node} is {}, expected a positive \
                     number",
                    number(&jacobian)
                ));
            }
            Validity::Undecided { coefficient } => undecided.push(format!(
                "{name} may be valid or not: a Bernstein coefficient of its Jacobian is {}",
                number(&coefficient)
            )),
        }
    }
    const FEW: usize = 8;
    if !undecided.is_empty() {
        let count = undecided.len();
        let rest = if count > FEW { "; …" } else { "" };
        let list = undecided[..count.min(FEW)].join("; ");
        return Answer::Declined(format!(
            "{input}: of {}, {count} not proved valid: {list}{rest}",
            elements(tiling.len(), cells),
            count = if count == 1 {
                "1 is".to_owned()
            } else {
                format!("{count} are")
            },
        ));
    }
    if !arguments.required.is_empty() {
        return Answer::Declined(format!(
            "{input}: has {} curved {cells}, about which no requirement is decided",
            named.curved.len()
        ));
    }
    let words = format!(
        "proved by the prover alone, no certificate: each of the {} {cells}, of which {} are of \
         second order and curved, has a positive Jacobian everywhere; whether they overlap is not decided",
        tiling.len(),
        named.curved.len()
    );
    let data = json!({
        "statements": ["positive-jacobian"],
        "simplices": tiling.len(),
        "curved": named.curved.len(),
        "kernel": false,
    });
    Answer::Said(words, data)
}

/// The answer where contact is allowed and is all that is wrong.
pub fn contact(
    findings: &Findings,
    named: &Named,
    options: &Options,
    target: &Target,
) -> Option<Answer> {
    if !findings.counts().keys().eq([&"non-conforming"]) {
        return None;
    }
    let input = &named.name;
    if !matches!(target, Target::Nowhere) || !options.required.is_empty() {
        let message = "with --allow-contact there is no certificate, and no requirement is decided";
        return Some(Answer::Declined(format!("{input}: {message}")));
    }
    let mut lines = Vec::new();
    let mut coincident = 0;
    with_dimension!(&named.tiling, AnyTiling, t => {
        let names = names(t, named.origin.as_ref(), false);
        for defect in findings.kept() {
            if let Defect::NonConforming { coincident: pairs, .. } = defect {
                coincident += pairs;
                lines.push(words(t, &names, defect));
            }
        }
    });
    let interfaces = findings.counts()["non-conforming"];
    let words = format!(
        "proved by the prover alone, no certificate: interiors are disjoint; {} of coincident facets \
         at {}: {}",
        counted(coincident, "pair", "pairs"),
        counted(interfaces, "interface", "interfaces"),
        lines.join("; ")
    );
    let data = json!({
        "statements": ["disjoint-interiors"],
        "coincident_pairs": coincident,
        "interfaces": lines,
        "kernel": false,
    });
    Some(Answer::Said(words, data))
}

/// The verdict on a refuted tiling if all elements are turned, or equal nodes merged.
pub fn look<const D: usize>(
    tiling: &Tiling<D>,
    findings: &Findings,
    options: &Options,
) -> SecondLook {
    let mut second = SecondLook::default();
    let verdict = |tiling: &Tiling<D>| {
        let limited = Options {
            defect_limit: 0,
            ..options.clone()
        };
        match checker::examine(tiling, &limited, &|_| ()) {
            Ok(_) => "proved".to_owned(),
            Err(findings) if findings.is_declined() => "declined".to_owned(),
            Err(findings) => format!("refuted: {}", counts(&findings)),
        }
    };
    let negative = findings.counts().get("negative-orientation");
    if negative == Some(&tiling.len()) {
        let mut turned = tiling.clone();
        turned.orient();
        second.instead = Some(format!(
            "{} negatively oriented; with --reorient, which turns them: {}",
            match tiling.len() {
                1 => "the only element is".to_owned(),
                n => format!("all {n} elements are"),
            },
            verdict(&turned)
        ));
        return second;
    }
    if tiling.frame.domain == Domain::Region(0) {
        let (merged, fewer) = merged(tiling);
        if fewer > 0 {
            second.sentences.push(format!(
                "{} the coordinates of another node; with equal nodes merged (--identify 0): {}",
                counted(fewer, "node has", "nodes have"),
                verdict(&merged)
            ));
        }
    }
    second
}

fn words<const D: usize>(_: &Tiling<D>, names: &checker::Names, defect: &Defect) -> String {
    checker::describe::<D>(names, defect)
}
