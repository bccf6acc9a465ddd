//! Section 4.1: average valences and dihedral angles.

use super::infinitesimal::Polynomial;
use super::introduction::regular_angle;
use super::row::{Finding, Row, mixed_number};
use crate::survey::{Study, Survey};
use crate::table::{Figure, width};
use acutile_core::classify::Wedge;
use acutile_core::quality::{Exact, display_width, rounded_down, rounded_up};
use acutile_core::tiling::Domain;
use acutile_exact::geometry::{RingElement, Simplex, linear};
use acutile_exact::number::Number;
use malachite::Rational;

/// The rows about averages.
pub fn rows(survey: &Survey) -> Vec<Row> {
    let row = |id, statement, printed| Row::new("4.1", id, statement, printed);
    let mut rows = vec![
        row(
            "valence-times-angle",
            "in a triangulation of space the average dihedral angle times the average edge valence is \
             exactly 360 degrees",
            "exactly 360°",
        )
        .found(valence_times_angle(survey)),
        row(
            "n0",
            "n0 = 360/arccos(1/3), the average valence if the tetrahedra could be regular",
            "5.1043",
        )
        .figure("", Ok(n_zero())),
        row(
            "critical-point",
            "the regular tetrahedron is a critical point of the average dihedral angle",
            "critical point",
        )
        .found(Ok(critical_point())),
        row(
            "near-regularity",
            "tilings by nearly regular tetrahedra have average valences close to n0 (here: within 1/100 for all \
             TCP structures of the catalogue)",
            "quite close to n0",
        )
        .found(near_regularity(survey)),
        row(
            "between",
            "all known TCP structures have average valences from 5 1/10 to 5 1/9 (here all of the \
             catalogue)",
            "between 5 1/10 and 5 1/9",
        )
        .found(between(survey)),
    ];
    for (name, printed, value) in [("c15", "5 1/10", (51, 10)), ("a15", "5 1/9", (46, 9))] {
        let finding = survey.space(name).map(|study| {
            let average = study.ridges.average_valence().unwrap_or_default();
            (
                average == Rational::from_signeds(value.0, value.1),
                average.to_string(),
            )
        });
        let statement = format!("the average valence of {}", name.to_uppercase());
        rows.push(
            Row::new(
                "4.1",
                &format!("average-valence/{name}"),
                &statement,
                printed,
            )
            .citing(survey, &[name])
            .found(finding),
        );
    }
    rows
}

/// The average of the 6 T angles is Σ/(6 T), and the average valence is 6 T/E. So the statement says that
/// the sum of all angles is 360 E. This holds if the angles around each edge add up to 360. That follows
/// from the proof that the tetrahedra tile face to face, and is computed here edge by edge.
fn valence_times_angle(survey: &Survey) -> Finding {
    let mut edges = 0;
    let mut tilings = 0;
    for (name, study) in survey
        .spaces()
        .filter(|(_, s)| s.tiling.frame.domain == Domain::Space)
    {
        if !study
            .ridges
            .list
            .iter()
            .all(|ridge| closes_up(study, &ridge.around))
        {
            return Ok((
                false,
                format!("{name}: the angles around an edge are not 360°"),
            ));
        }
        edges += study.ridges.list.len();
        tilings += 1;
    }
    if tilings == 0 {
        return Err("no tilings in this build".to_owned());
    }
    let proved = format!(
        "follows from the proof of a face-to-face tiling; moreover the rotations around each of {edges} \
         edges of {tilings} tilings were multiplied exactly: one full turn each"
    );
    Ok((true, proved))
}

/// Whether the dihedral angles of these simplices between these facets add up to 360 degrees.
///
/// Each angle is below 180 degrees, so that the running product of rotations enters the upper half-plane from
/// the lower one once for each full turn.
fn closes_up(study: &Study<3>, around: &[Wedge]) -> bool {
    let metric = linear::determinant(&study.tiling.frame.gram);
    let mut turn = (Number::from(Rational::from(1)), Number::zero());
    let mut turns = 0;
    for &wedge in around {
        let (cosine, sine, square) = rotation(study, wedge);
        let s_square = -(square * &metric);
        let next = (
            &turn.0 * &cosine + &turn.1 * &sine * s_square,
            &turn.0 * &sine + &turn.1 * &cosine,
        );
        turns += usize::from(is_below(&turn) && !is_below(&next));
        turn = next;
    }
    turn.1.is_zero() && turn.0.sign().is_gt() && turns == 1
}

/// Whether the argument of x + i y times a positive number is in [180, 360) degrees.
fn is_below((x, y): &(Number, Number)) -> bool {
    y.sign().is_lt() || y.is_zero() && x.sign().is_lt()
}

/// cos t, (sin t)/√(|x|² det G), both up to one positive factor, and |x|², for the dihedral angle t at
/// an edge x.
///
/// With u and v from a corner of the edge to the other two corners and P the projection along x,
/// |Pu||Pv||x|² cos t = (u·v)|x|² - (u·x)(v·x) and |Pu||Pv||x|² sin t = |x| √det G d, d > 0 the determinant of
/// the simplex. So the rotations by t are multiplied in K(s) with s² = -|x|² det G.
fn rotation(study: &Study<3>, (simplex, (i, j)): Wedge) -> (Number, Number, Number) {
    let gram = &study.tiling.frame.gram;
    let corners = study.tiling.simplex(simplex);
    let edge: Vec<usize> = (0..4).filter(|&k| k != i && k != j).collect();
    let from = study.tiling.position(&corners[edge[0]]);
    let [x, u, v] =
        [edge[1], i, j].map(|k| linear::subtract(&study.tiling.position(&corners[k]), &from));
    let [to_x, to_u] = [&x, &u].map(|vector| linear::apply(gram, vector));
    let square = linear::dot(&x, &to_x);
    let cosine = linear::dot(&to_u, &v) * &square - linear::dot(&u, &to_x) * linear::dot(&v, &to_x);
    (cosine, study.tiling.shape(simplex).determinant, square)
}

fn n_zero() -> Figure {
    let (low, high) = regular_angle().enclosure(&(width() / Rational::from(100)));
    let turn = || Rational::from(360);
    Figure {
        bounds: (turn() / high, turn() / low),
        closed_form: Some("360/arccos(1/3)".to_owned()),
    }
}

/// The regular tetrahedron with one edge changed by ε. For each angle cos t = -p/√(q r) with p, q, r in
/// `Q[ε]`. At ε = 0 all six angles are equal, with the same sin t, and q = r. So cos' = (-p' + p (q' +
/// r')/(2q))/q. The sum of the six derivatives must vanish.
fn critical_point() -> (bool, String) {
    let number = |n: &[i64]| Polynomial::new(n, 1);
    // Squared sides 2, but |e_1 - e_2|² = 2 - 2ε.
    let gram = [
        [number(&[2]), number(&[1, 1]), number(&[1])],
        [number(&[1, 1]), number(&[2]), number(&[1])],
        [number(&[1]), number(&[1]), number(&[2])],
    ];
    let corners: [[Polynomial; 3]; 4] =
        std::array::from_fn(|k| std::array::from_fn(|i| number(&[i64::from(i + 1 == k)])));
    let products = Simplex::new(&corners).normal_products(&linear::cofactors(&gram));
    let mut sum = Rational::from(0);
    for (i, j, p) in products.pairs() {
        let lengths = products.get(i, i).plus(products.get(j, j));
        let q = products.get(i, i).coefficient(0);
        let two = Rational::from(2);
        sum += (p.coefficient(0) * lengths.coefficient(1) / (two * &q) - p.coefficient(1)) / q;
    }
    let proved = "the derivatives of the six cosines by the square of one edge add up to 0, computed in Q[ε]; \
                  by symmetry for all edges";
    (sum == 0, proved.to_owned())
}

/// The distance of the averages from n0, with the range of all dihedral angles of these structures.
fn near_regularity(survey: &Survey) -> Finding {
    let (low, high) = n_zero().bounds;
    let mut farthest = Rational::from(0);
    let mut angles: Option<(Rational, Rational)> = None;
    for (_, study) in survey
        .spaces()
        .filter(|(_, study)| study.check_tcp().is_ok())
    {
        let average = study.ridges.average_valence().unwrap_or_default();
        farthest = farthest.max(&high - &average).max(average - &low);
        let least = study
            .ranges
            .smallest_dihedral
            .min
            .enclosure(&display_width())
            .0;
        let most = study
            .ranges
            .largest_dihedral
            .max
            .enclosure(&display_width())
            .1;
        angles = Some(match angles {
            Some((low, high)) => (low.min(least), high.max(most)),
            None => (least, most),
        });
    }
    let (least, most) = angles.ok_or("no TCP structures in this build")?;
    let proved = format!(
        "average valences differ from n0 by less than {}; all dihedral angles lie between {}° and {}°, that of \
         the regular tetrahedron is 70.53°",
        rounded_up(&farthest, 4),
        rounded_down(&least, 2),
        rounded_up(&most, 2)
    );
    Ok((farthest < Rational::from_signeds(1, 100), proved))
}

fn between(survey: &Survey) -> Finding {
    let (least, most) = (
        Rational::from_signeds(51, 10),
        Rational::from_signeds(46, 9),
    );
    let mut averages = Vec::new();
    for (name, study) in survey
        .spaces()
        .filter(|(_, study)| study.check_tcp().is_ok())
    {
        let average = study.ridges.average_valence().unwrap_or_default();
        if average < least || average > most {
            return Ok((false, format!("{name} has {average}")));
        }
        averages.push((average, name));
    }
    averages.sort();
    let words: Vec<String> = averages
        .iter()
        .map(|(average, name)| format!("{name} {}", mixed_number(average).unwrap_or_default()))
        .collect();
    if words.is_empty() {
        Err("no TCP structures in this build".to_owned())
    } else {
        Ok((true, words.join(", ")))
    }
}
