//! Section 4.1: which structure each one is, decided by Delaney-Dress symbols against the
//! crystallographic positions.

use super::row::{Finding, Row};
use crate::survey::{Study, Survey};
use acutile_core::tiling::{Frame, PointSet};
use acutile_exact::number::{Field, Number};
use malachite::Rational;
use malachite::base::num::arithmetic::traits::Floor;

/// The rows about names of structures and other ways to build them.
pub fn rows(survey: &Survey) -> Vec<Row> {
    let row = |id, statement, printed| Row::new("4.1", id, statement, printed);
    vec![
        row("is-z", "the triangle tiling leads to the structure Z (P6/mmm)", "Z")
            .citing(survey, &["z"])
            .found(is_isomorphic(survey, "z", crystal_z)),
        row("is-a15", "the square tiling leads to the structure A15 (Pm-3n)", "A15")
            .citing(survey, &["a15"])
            .found(is_isomorphic(survey, "a15", crystal_a15)),
        row("is-sigma", "the tiling 3².4.3.4 leads to the structure σ (P4₂/mnm, as in FeCr)", "σ")
            .citing(survey, &["sigma"])
            .found(is_isomorphic(survey, "sigma", crystal_sigma)),
        row(
            "c15-from-diamond",
            "the diamond lattice with selected circumcentres is C15 (Fd-3m), with the same geometry",
            "C15",
        )
        .citing(survey, &["c15"])
        .found(is_similar(survey, "c15", crystal_c15)),
        row("a15-geometry", "the square tiling gives A15 with the same geometry (Pm-3n)", "A15")
            .citing(survey, &["a15"])
            .found(is_similar(survey, "a15", crystal_a15)),
        row(
            "bcc-even",
            "all edges of the Delaunay triangulation of the BCC lattice have even valence, so that its \
             tetrahedra can be coloured alternately black and white",
            "even valence",
        )
        .citing(survey, &["sommerville-2"])
        .found(even_valences(survey)),
        row(
            "bcc-is-sommerville-2",
            "the second Sommerville tiling is the Delaunay triangulation of the BCC lattice",
            "the Delaunay triangulation",
        )
        .citing(survey, &["sommerville-2"])
        .found(is_similar(survey, "sommerville-2", bcc)),
        row(
            "a15-from-bcc",
            "the BCC lattice with the circumcentres of its black tetrahedra is A15, with the same geometry",
            "the vertices of A15",
        )
        .citing(survey, &["a15", "a15-bcc"])
        .found(a15_from_bcc(survey)),
    ]
}

fn is_isomorphic(survey: &Survey, name: &str, crystal: fn() -> PointSet<3>) -> Finding {
    let study = survey.space(name)?;
    let reference = Study::of_points(&crystal())?;
    let symbol = study.symbol();
    let holds = symbol.is_some() && symbol == reference.symbol();
    let chambers = symbol.map_or(0, |symbol| symbol.len());
    let proved = format!(
        "its Delaney-Dress symbol ({chambers} chambers) {} that of the crystallographic positions",
        if holds { "equals" } else { "differs from" }
    );
    Ok((holds, proved))
}

fn is_similar(survey: &Survey, name: &str, crystal: fn() -> PointSet<3>) -> Finding {
    similar(survey.space(name)?, &Study::of_points(&crystal())?)
}

fn a15_from_bcc(survey: &Survey) -> Finding {
    similar(survey.space("a15-bcc")?, survey.space("a15")?)
}

/// Similar tilings have equal symbols with edge lengths in units of the shortest.
fn similar(one: &Study<3>, other: &Study<3>) -> Finding {
    if one.tiling.frame.field != other.tiling.frame.field {
        return Err("the coordinates lie in different fields".to_owned());
    }
    let symbol = one.metric_symbol();
    let holds = symbol.is_some() && symbol == other.metric_symbol();
    let chambers = symbol.map_or(0, |symbol| symbol.len());
    let proved = format!(
        "the Delaney-Dress symbols with edge lengths ({chambers} chambers) {}",
        if holds {
            "are equal: similar"
        } else {
            "differ"
        }
    );
    Ok((holds, proved))
}

fn even_valences(survey: &Survey) -> Finding {
    let counts = survey.space("sommerville-2")?.ridges.valence_counts();
    let holds = counts.keys().all(|valence| valence % 2 == 0);
    let valences: Vec<String> = counts.keys().map(usize::to_string).collect();
    Ok((
        holds,
        format!(
            "valences {}; space is simply connected",
            valences.join(", ")
        ),
    ))
}

/// Points with rational coordinates, in a basis with a rational Gram matrix.
fn points(gram: [[i64; 3]; 3], scale: i64, points: Vec<[Rational; 3]>) -> PointSet<3> {
    let entry = |n| Number::from(Rational::from_signeds(n, scale));
    PointSet {
        frame: Frame::space(Field::rationals(), gram.map(|row| row.map(entry))),
        points: points
            .into_iter()
            .map(|point| point.map(Number::from))
            .collect(),
    }
}

fn fractions(denominator: i64, numerators: &[[i64; 3]]) -> Vec<[Rational; 3]> {
    let fraction = |n| Rational::from_signeds(n, denominator);
    numerators.iter().map(|point| point.map(fraction)).collect()
}

/// One point in a primitive cell of the body-centred cubic lattice.
fn bcc() -> PointSet<3> {
    points(
        [[3, -1, -1], [-1, 3, -1], [-1, -1, 3]],
        1,
        fractions(1, &[[0, 0, 0]]),
    )
}

/// Pm-3n: 2a (0,0,0), 6c (1/4,0,1/2).
fn crystal_a15() -> PointSet<3> {
    let quarters = [
        [0, 0, 0],
        [2, 2, 2],
        [1, 0, 2],
        [3, 0, 2],
        [2, 1, 0],
        [2, 3, 0],
        [0, 2, 1],
        [0, 2, 3],
    ];
    points(
        [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
        1,
        fractions(4, &quarters),
    )
}

/// P6/mmm with c = a: 3f (1/2,0,0), 2e (0,0,1/4), 2d (1/3,2/3,1/2).
fn crystal_z() -> PointSet<3> {
    let twelfths = [
        [6, 0, 0],
        [0, 6, 0],
        [6, 6, 0],
        [0, 0, 3],
        [0, 0, 9],
        [4, 8, 6],
        [8, 4, 6],
    ];
    points(
        [[2, -1, 0], [-1, 2, 0], [0, 0, 2]],
        2,
        fractions(12, &twelfths),
    )
}

/// Fd-3m: 8a (0,0,0), (1/4,1/4,1/4) and 16d, in eighths, all + the face centring.
fn crystal_c15() -> PointSet<3> {
    let eighths = [
        [0, 0, 0],
        [2, 2, 2],
        [5, 5, 5],
        [5, 7, 7],
        [7, 5, 7],
        [7, 7, 5],
    ];
    let centring = [[0, 0, 0], [0, 4, 4], [4, 0, 4], [4, 4, 0]];
    let all: Vec<[i64; 3]> = centring
        .iter()
        .flat_map(|shift| eighths.map(|p| std::array::from_fn(|k| (p[k] + shift[k]) % 8)))
        .collect();
    points([[1, 0, 0], [0, 1, 0], [0, 0, 1]], 1, fractions(8, &all))
}

/// P4₂/mnm with the positions of FeCr (Yakel, Acta Cryst. B 39, 1983), rounded: 2a; 4f x = 0.3986; 8i
/// (0.4635, 0.1312), (0.7393, 0.0661); 8j x = 0.1827, z = 0.2520; (c/a)² = 0.269.
fn crystal_sigma() -> PointSet<3> {
    let sites = [
        [0, 0, 0],
        [3986, 3986, 0],
        [4635, 1312, 0],
        [7393, 661, 0],
        [1827, 1827, 2520],
    ];
    let mut all: Vec<[Rational; 3]> = fractions(10_000, &sites)
        .iter()
        .flat_map(orbit_p42_mnm)
        .collect();
    all.sort();
    all.dedup();
    points([[1000, 0, 0], [0, 1000, 0], [0, 0, 269]], 1000, all)
}

/// The images of a point under P4₂/mnm, in the cell; some may coincide.
fn orbit_p42_mnm([x, y, z]: &[Rational; 3]) -> Vec<[Rational; 3]> {
    let half = || Rational::from_signeds(1, 2);
    let half_of_group = [
        [x.clone(), y.clone(), z.clone()],
        [-x, -y, z.clone()],
        [half() - y, half() + x, half() + z],
        [half() + y, half() - x, half() + z],
        [half() - x, half() + y, half() - z],
        [half() + x, half() - y, half() - z],
        [y.clone(), x.clone(), -z],
        [-y, -x, -z],
    ];
    let inverted = half_of_group.clone().map(|point| point.map(|x| -x));
    let into_cell = |x: Rational| &x - Rational::from((&x).floor());
    half_of_group
        .into_iter()
        .chain(inverted)
        .map(|point| point.map(into_cell))
        .collect()
}
