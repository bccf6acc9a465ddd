//! Section 4.2: the structure Z from icosahedra.

use super::row::{Finding, Row, mixed_number};
use crate::survey::{Study, Survey, isomorphic_entries};
use acutile_core::quality::{DihedralAngle, Exact};
use acutile_core::tiling::{Facet, SimplexId};
use acutile_exact::geometry::Simplex;
use acutile_exact::number::{Number, numbers};
use malachite::Rational;
use std::collections::BTreeSet;

/// The rows of section 4.2.
pub fn rows(survey: &Survey) -> Vec<Row> {
    let row = |id, statement, printed| Row::new("4.2", id, statement, printed);
    let cited = ["icosahedral"];
    vec![
        row(
            "cone",
            "coning a regular icosahedron to its centre gives 20 acute tetrahedra",
            "20 acute",
        )
        .found(cone()),
        row(
            "icosahedral-is-z",
            "the icosahedral construction is combinatorially the TCP structure Z",
            "combinatorially Z",
        )
        .citing(survey, &["icosahedral", "z"])
        .found(is_z(survey)),
        row(
            "icosahedral-geometry",
            "its geometry differs from that of Z over the triangle tiling",
            "slightly different geometry",
        )
        .citing(survey, &["icosahedral", "z"])
        .found(differs_from_z(survey)),
        row(
            "icosahedral-classes",
            "besides the tetrahedra of the icosahedra there are four types of tetrahedra, which fill the gaps",
            "four types",
        )
        .citing(survey, &cited)
        .found(four_types(survey)),
        row(
            "icosahedral-faces",
            "each face of an icosahedron is shared by two icosahedra (the horizontal ones, two of 20) or \
             separates it from a tetrahedron in a gap",
            "horizontal faces are shared",
        )
        .citing(survey, &cited)
        .found(faces(survey)),
    ]
}

/// The centre and one face of the icosahedron (0, ±1, ±φ) and cyclic permutations; the others are
/// images of it under its rotations.
fn cone() -> Finding {
    let phi = numbers(&["(1+sqrt(5))/2"]).map_err(|error| error.to_string())?;
    let number = |n: i64| Number::from(Rational::from(n));
    let point = |x: Number, y: Number, z: Number| [x, y, z];
    let face = [
        point(number(0), number(0), number(0)),
        point(number(0), number(1), phi[0].clone()),
        point(number(0), number(-1), phi[0].clone()),
        point(phi[0].clone(), number(0), number(1)),
    ];
    let unit: [[Number; 3]; 3] =
        std::array::from_fn(|i| std::array::from_fn(|j| number(i64::from(i == j))));
    let products = Simplex::new(&face).normal_products(&unit);
    let angle = |i, j| DihedralAngle::between(&products, i, j).expect("the cone is not flat");
    let at_centre: Vec<_> = [(1, 2), (1, 3), (2, 3)]
        .map(|(i, j)| angle(i, j).closed_form())
        .into();
    let at_face = [(0, 1), (0, 2), (0, 3)].map(|(i, j)| angle(i, j));
    let is_acute = products
        .pairs()
        .all(|(_, _, product)| product.sign().is_lt());
    let holds = is_acute && at_centre.iter().all(|form| form.as_deref() == Some("72"));
    let (low, high) = at_face[0].enclosure(&Rational::from_signeds(1, 1_000_000));
    let equal = at_face.iter().all(|other| *other == at_face[0]);
    let range = acutile_core::quality::decimal_range(&(low, high));
    Ok((
        holds && equal,
        format!("angles 72° at the edges to the centre and {range}° at the face's edges"),
    ))
}

/// Whether the minimal symbols are equal; where they are not, its type.
fn is_z(survey: &Survey) -> Finding {
    let (one, other) = (survey.space("icosahedral")?, survey.space("z")?);
    let symbol = one.symbol();
    if symbol.is_some() && symbol == other.symbol() {
        return Ok((true, "the Delaney-Dress symbols are equal".to_owned()));
    }
    let average = |study: &Study<3>| {
        let average = study.ridges.average_valence();
        average
            .and_then(|average| mixed_number(&average))
            .unwrap_or_default()
    };
    let mut known = isomorphic_entries(one, survey);
    known.retain(|name| *name != "icosahedral");
    let proved = format!(
        "not isomorphic to Z: average valence {}, that of Z is {}; it is isomorphic to {}",
        average(one),
        average(other),
        if known.is_empty() {
            "no other construction".to_owned()
        } else {
            known.join(", ")
        }
    );
    Ok((false, proved))
}

/// Congruent tilings would have equal figures.
fn differs_from_z(survey: &Survey) -> Finding {
    let figure = |name| -> Result<_, String> {
        let study = survey.space(name)?;
        Ok(study
            .ranges
            .largest_dihedral
            .max
            .enclosure(&Rational::from_signeds(1, 1_000_000)))
    };
    let (one, other) = (figure("icosahedral")?, figure("z")?);
    let range = acutile_core::quality::decimal_range;
    let proved = format!("largest angles {}° and {}°", range(&one), range(&other));
    Ok((one.0 > other.1 || one.1 < other.0, proved))
}

/// The class of the tetrahedra in the icosahedra: three angles of 72 degrees.
fn class_of_cones(study: &Study<3>) -> Result<usize, String> {
    let is_cone = |class: &usize| {
        let angles = study.measures()[*class].angles.iter();
        angles
            .filter(|angle| angle.rational() == Some(Rational::from(72)))
            .count()
            == 3
    };
    let classes: Vec<usize> = (0..study.shapes().len()).filter(is_cone).collect();
    match classes[..] {
        [class] => Ok(class),
        _ => Err(format!(
            "{} classes have three angles of 72°",
            classes.len()
        )),
    }
}

fn four_types(survey: &Survey) -> Finding {
    let study = survey.space("icosahedral")?;
    let cones = class_of_cones(study)?;
    let others = study.shapes().len() - 1;
    let sizes: Vec<String> = study
        .shapes()
        .iter()
        .enumerate()
        .filter(|(class, _)| *class != cones)
        .map(|(_, shape)| shape.members.len().to_string())
        .collect();
    let proved = format!(
        "{} tetrahedra in icosahedra, and {others} other congruence classes of {} tetrahedra in a cell",
        study.shapes()[cones].members.len(),
        sizes.join(", ")
    );
    Ok((others == 4, proved))
}

/// The face of a cone is opposite to the centre. It is the facet between the three angles that are not 72
/// degrees.
fn faces(survey: &Survey) -> Finding {
    let study = survey.space("icosahedral")?;
    let members = &study.shapes()[class_of_cones(study)?].members;
    let cones: BTreeSet<SimplexId> = members.iter().copied().collect();
    let metric = acutile_exact::geometry::linear::cofactors(&study.tiling.frame.gram);
    let mut shared = 0;
    for &cone in members {
        let products = study.tiling.shape(cone).normal_products(&metric);
        let is_72 = |i, j| {
            DihedralAngle::between(&products, i, j).and_then(|angle| angle.rational())
                == Some(Rational::from(72))
        };
        let centre = (0..4)
            .find(|&k| (0..4).all(|other| other == k || !is_72(k, other)))
            .ok_or("a tetrahedron of an icosahedron has other angles")?;
        let mate = study.matching.neighbour(Facet::new(cone, centre));
        shared += usize::from(mate.is_some_and(|m| cones.contains(&m.simplex)));
    }
    let proved = format!(
        "{shared} of {} faces are shared by two icosahedra",
        members.len()
    );
    Ok((shared * 10 == members.len(), proved))
}
