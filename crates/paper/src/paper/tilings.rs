//! Section 2.2: the statements about all known space-filling tetrahedra, of regular ones and of
//! subdivided cubes.

use super::introduction::{CONGRUENT, regular_angle};
use super::row::{Finding, Row};
use crate::survey::{Study, Survey};
use crate::table::Figure;
use acutile_core::quality::{DihedralAngle, Exact, decimal_range, display_width};
use acutile_core::statement::Statement;
use acutile_exact::geometry::Sign;
use malachite::Rational;

/// The rows of section 2.2 but those of `sommerville`.
pub fn rows(survey: &Survey) -> Vec<Row> {
    let row = |id, statement, printed| Row::new("2.2", id, statement, printed);
    vec![
        row(
            "regular-angle",
            "the dihedral angle of the regular tetrahedron is arccos(1/3), not 72 degrees",
            "70.53",
        )
        .figure("°", Ok(Figure::of(&regular_angle()))),
        row(
            "five-regular-leave-a-gap",
            "five regular tetrahedra around an edge leave a gap",
            "small gap",
        )
        .found(Ok(gap())),
        row(
            "one-shape",
            "each of these tilings consists of copies of one tetrahedron (equal volumes, \
             congruent)",
            "congruent copies",
        )
        .citing(survey, &CONGRUENT)
        .found(for_all(survey, &CONGRUENT, |study| study.shapes().len() == 1)),
        row(
            "right-angles",
            "all tetrahedra known to tile space have right dihedral angles",
            "have right angles",
        )
        .citing(survey, &CONGRUENT)
        .found(for_all(survey, &CONGRUENT, has_right_angle)),
        row("none-acute", "none of the known space-tiling tetrahedra is acute", "none is acute")
            .citing(survey, &CONGRUENT)
            .found(for_all(survey, &CONGRUENT, |study| !study.states(&Statement::Acute))),
        row(
            "several-nonobtuse",
            "several of the known space-tiling tetrahedra are nonobtuse",
            "several are nonobtuse",
        )
        .citing(survey, &CONGRUENT)
        .found(several_nonobtuse(survey)),
        row(
            "valence-four",
            "all tilings by congruent tetrahedra contain edges of valence four",
            "valence four",
        )
        .citing(survey, &CONGRUENT)
        .found(for_all(survey, &CONGRUENT, |study| {
            study.ridges.valence_counts().contains_key(&4)
        })),
        row(
            "cubes",
            "the cubes cut into five or six tetrahedra have right dihedral angles and are nonobtuse, \
             not acute",
            "90°",
        )
        .citing(survey, &["cube-5", "cube-6"])
        .found(for_all(survey, &["cube-5", "cube-6"], |study| {
            has_right_angle(study) && study.states(&Statement::Nonobtuse)
        })),
    ]
}

/// Whether a property holds for all these constructions; describes those without it.
fn for_all(survey: &Survey, names: &[&str], property: impl Fn(&Study<3>) -> bool) -> Finding {
    let mut without = Vec::new();
    let mut missing = Vec::new();
    for name in names {
        match survey.space(name) {
            Ok(study) if property(study) => {}
            Ok(study) => without.push(format!("{name} ({})", profile(study))),
            Err(reason) => missing.push(reason),
        }
    }
    match (&without[..], missing.first()) {
        ([], None) => Ok((true, format!("holds for {}", names.join(", ")))),
        ([], Some(reason)) => Err(reason.clone()),
        _ => Ok((false, format!("does not hold for {}", without.join(", ")))),
    }
}

/// The dihedral angles of the first shape and the valences.
fn profile(study: &Study<3>) -> String {
    let angles = study
        .measures()
        .first()
        .map_or(&[][..], |measures| &measures.angles);
    let angles: Vec<String> = angles
        .iter()
        .map(|angle| angle.closed_form().unwrap_or_else(|| range_in_words(angle)))
        .collect();
    let counts = study.ridges.valence_counts();
    let valences: Vec<String> = counts.keys().map(usize::to_string).collect();
    format!(
        "dihedral angles {}; edge valences {}",
        angles.join(", "),
        valences.join(", ")
    )
}

fn range_in_words(angle: &DihedralAngle) -> String {
    decimal_range(&angle.enclosure(&display_width()))
}

fn has_right_angle(study: &Study<3>) -> bool {
    let mut angles = study
        .measures()
        .iter()
        .flat_map(|measures| &measures.angles);
    angles.any(|angle| angle.against_right() == Sign::Equal)
}

fn several_nonobtuse(survey: &Survey) -> Finding {
    let nonobtuse: Vec<&str> = CONGRUENT
        .into_iter()
        .filter(|name| {
            survey
                .space(name)
                .is_ok_and(|s| s.states(&Statement::Nonobtuse))
        })
        .collect();
    Ok((
        nonobtuse.len() >= 2,
        format!("certified nonobtuse: {}", nonobtuse.join(", ")),
    ))
}

/// With c = 1/3 = cos θ: cos 5θ = 16c^5 - 20c³ + 5c. As 0 < 5θ < 360 degrees and θ < 72, the
/// gap is 360 - 5θ = arccos(cos 5θ).
fn gap() -> (bool, String) {
    let c = Rational::from_signeds(1, 3);
    let square = &c * &c;
    let integer = |n: i32| Rational::from(n);
    let fifth = &c * (integer(16) * &square * &square - integer(20) * &square + integer(5));
    let (low, high) = regular_angle().enclosure(&Rational::from_signeds(1, 1_000_000_000));
    let gap = (
        integer(360) - integer(5) * high,
        integer(360) - integer(5) * low,
    );
    let holds = gap.0 > 0 && fifth < 1;
    let figure = Figure {
        bounds: gap,
        closed_form: Some(format!("arccos({fifth})")),
    };
    (
        holds,
        format!("the gap is {}", super::row::describe(&figure, "°")),
    )
}
