//! Section 4.1: which structures are TCP, with which vertices.

use super::introduction::states_for_all;
use super::row::{Finding, Row};
use crate::survey::{Study, Survey};
use acutile_catalog::{self as catalog, CatalogError};
use acutile_core::classify::{Star, frank_kasper};
use acutile_core::statement::Statement;
use malachite::Rational;

/// The structures that the text calls TCP, with its names.
const CALLED_TCP: [(&str, &str); 6] = [
    ("a15", "A15"),
    ("z", "Z"),
    ("c15", "C15"),
    ("sigma", "σ"),
    ("h", "H"),
    ("icosahedral", "the icosahedral construction"),
];

/// The structures over tilings by squares and triangles.
const OVER_TILINGS: [&str; 8] = [
    "z",
    "a15",
    "sigma",
    "h",
    "square-triangle-3464",
    "square-triangle-inflated-3",
    "square-triangle-inflated-4",
    "square-triangle-inflated-32434",
];

/// The rows about the TCP property.
pub fn rows(survey: &Survey) -> Vec<Row> {
    let row = |id: &str, statement: &str, printed| Row::new("4.1", id, statement, printed);
    let mut rows = vec![
        row(
            "four-stars",
            "the definition of TCP allows exactly four types of vertex star; dually, exactly four polyhedra \
             have pentagons and hexagons without adjacent hexagons as faces",
            "exactly four",
        )
        .found(Ok(four_stars())),
    ];
    for (name, words) in CALLED_TCP {
        rows.push(
            row(&format!("tcp/{name}"), &format!("{words} is TCP"), "TCP")
                .citing(survey, &[name])
                .found(is_tcp(survey, name)),
        );
    }
    let over_all =
        |statement: Statement| states_for_all(survey, "square-triangle-all", &[statement]);
    rows.push(
        row(
            "tcp/square-triangle",
            "every tiling of the plane by squares and triangles leads to a TCP structure",
            "any tiling",
        )
        .citing(survey, &["square-triangle-all"])
        .found_for_all(over_all(Statement::Tcp)),
    );
    rows.push(
        row(
            "delaunay",
            "over a tiling by squares and triangles the TCP triangulation is the Delaunay triangulation \
             of the points",
            "Delaunay",
        )
        .citing(survey, &["square-triangle-all"])
        .found_for_all(over_all(Statement::Delaunay)),
    );
    rows.push(
        row(
            "combinations",
            "all known TCP structures are convex combinations of A15, Z and C15 (by the numbers of \
             their vertex types; here for all TCP structures of the catalogue)",
            "convex combinations",
        )
        .found(combinations(survey)),
    );
    rows.push(
        row(
            "combinations-z-c15",
            "a variant of the construction gives combinations of Z and C15 (the recipe with blank \
             edges, over the tilings by squares and triangles that admit them)",
            "combinations of the Z and C15 structures",
        )
        .citing(survey, &VARIANTS)
        .found(variants(survey)),
    );
    rows.push(
        row(
            "variant-arbitrary",
            "the recipe with blank edges, which is our reading of the variant, works over every tiling by \
             squares and triangles (the source that the paper cites may mean another one)",
            "an arbitrary square/triangle tiling",
        )
        .found(variant_over("3464")),
    );
    rows.push(
        row(
            "combinations-a15-z",
            "structures over tilings by squares and triangles are combinations of A15 and Z",
            "combinations of A15 and Z",
        )
        .citing(survey, &OVER_TILINGS)
        .found(combinations_of_two(survey)),
    );
    rows.push(
        row(
            "tcp-acute",
            "the TCP structures constructed are acute triangulations",
            "acute triangulations",
        )
        .citing(survey, &["square-triangle-all", "kagome-all"])
        .found_for_all(tcp_is_acute(survey)),
    );
    rows
}

/// Z, A15, σ and H are over tilings by squares and triangles, and C15 is a word of kagome layers.
fn tcp_is_acute(survey: &Survey) -> Finding {
    let acute = [Statement::Acute];
    let (is_first, first) = states_for_all(survey, "square-triangle-all", &acute)?;
    let (is_second, second) = states_for_all(survey, "kagome-all", &acute)?;
    Ok((is_first && is_second, format!("{first}; {second}")))
}

fn four_stars() -> (bool, String) {
    let sizes: Vec<usize> = frank_kasper::links()
        .iter()
        .map(|link| link.len())
        .collect();
    let proved = format!("exhaustive search: one each with {sizes:?} neighbours, and no other");
    (sizes == [12, 14, 15, 16], proved)
}

fn is_tcp(survey: &Survey, name: &str) -> Finding {
    let study = survey.space(name)?;
    Ok(match study.check_tcp() {
        Ok(()) => {
            let counts = study.star_counts();
            let words: Vec<String> = counts
                .iter()
                .map(|(star, n)| format!("{n} {star}"))
                .collect();
            (
                true,
                format!("TCP; vertices in a cell: {}", words.join(", ")),
            )
        }
        Err(reason) => (false, format!("not TCP: {reason}")),
    })
}

/// The numbers of cells of A15 (2 Z12, 6 Z14), Z (3 Z12, 2 Z14, 2 Z15) and C15 (2 Z12, 1 Z16) that together
/// have the vertex types of a TCP structure. The equations for Z16, Z15 and Z14 determine them. Then the
/// equation for Z12 must hold.
fn cells(study: &Study<3>) -> Option<[Rational; 3]> {
    let counts = study.star_counts();
    let count = |n: usize| {
        let count = counts.get(&Star::FrankKasper(n)).copied().unwrap_or(0);
        Rational::from(count as u64)
    };
    let number = |n: i64| Rational::from(n);
    let c15 = count(16);
    let z = count(15) / number(2);
    let a15 = (count(14) - number(2) * &z) / number(6);
    let twelves = number(2) * &a15 + number(3) * &z + number(2) * &c15;
    (a15 >= 0 && twelves == count(12)).then_some([a15, z, c15])
}

fn combinations(survey: &Survey) -> Finding {
    let mut words = Vec::new();
    for (name, study) in survey
        .spaces()
        .filter(|(_, study)| study.check_tcp().is_ok())
    {
        let Some([a15, z, c15]) = cells(study) else {
            return Ok((false, format!("{name} is no such combination")));
        };
        words.push(format!("{name} = {a15} A15 + {z} Z + {c15} C15"));
    }
    if words.is_empty() {
        Err("no TCP structures in this build".to_owned())
    } else {
        Ok((true, format!("in cells: {}", words.join("; "))))
    }
}

/// The mixtures of Z and C15 in the catalogue.
const VARIANTS: [&str; 4] = ["z-c15-3", "z-c15-4", "z-c15-33344", "z-c15-32434"];

fn variants(survey: &Survey) -> Finding {
    let mut words = Vec::new();
    for name in VARIANTS {
        let study = survey.space(name)?;
        if let Err(reason) = study.check_tcp() {
            return Ok((false, format!("{name} is not TCP: {reason}")));
        }
        match cells(study) {
            Some([a15, z, c15]) if a15 == 0 => words.push(format!("{name} = {z} Z + {c15} C15")),
            _ => return Ok((false, format!("{name} is no such combination"))),
        }
    }
    Ok((true, format!("TCP, in cells: {}", words.join("; "))))
}

/// Whether the recipe of the variant works over one of the built-in tilings.
fn variant_over(plane: &str) -> Finding {
    match catalog::build(&format!("z-c15:{plane}")) {
        Ok(_) => Ok((true, format!("it works over {plane}"))),
        Err(error @ CatalogError::NoBlankEdges { .. }) => {
            Ok((false, format!("not over {plane}: {error}")))
        }
        Err(error) => Err(error.to_string()),
    }
}

fn combinations_of_two(survey: &Survey) -> Finding {
    let mut words = Vec::new();
    for name in OVER_TILINGS {
        match cells(survey.space(name)?) {
            Some([a15, z, c15]) if c15 == 0 => words.push(format!("{name} = {a15} A15 + {z} Z")),
            _ => return Ok((false, format!("{name} is no such combination"))),
        }
    }
    Ok((true, format!("in cells: {}", words.join("; "))))
}
