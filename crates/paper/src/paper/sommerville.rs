//! Section 2.2 and its figures: Sommerville's tetrahedra and Goldberg's families, and what
//! becomes of them when they are cut.

use super::row::{Finding, Row};
use crate::survey::{Study, Survey};
use acutile_catalog as catalog;
use acutile_core::family::AnyFamily;
use acutile_core::family::cleared::{Cleared, to_number};
use acutile_core::quality::congruence_form;
use acutile_core::tiling::{AnyTiling, SimplexId, Tiling};
use acutile_exact::geometry::{RingElement, linear};
use acutile_exact::number::Number;
use acutile_exact::polynomial::Polynomial;
use malachite::Rational;

/// The rows about cut tetrahedra and Goldberg's families.
pub fn rows(survey: &Survey) -> Vec<Row> {
    let row = |id, statement, printed| Row::new("2.2", id, statement, printed);
    vec![
        row(
            "sommerville-1-half-of-3",
            "the first Sommerville tetrahedron is half of the third: a plane through an edge and the \
             midpoint of the opposite one cuts the third into two of the first",
            "half",
        )
        .citing(survey, &["sommerville-1", "sommerville-3"])
        .found(first_is_half_of_third(survey)),
        row(
            "sommerville-4-quarter-of-2",
            "the fourth Sommerville tetrahedron is a quarter of the second: the centroid and the \
             facets of the second span four of the fourth",
            "one fourth",
        )
        .citing(survey, &["sommerville-2", "sommerville-4"])
        .found(fourth_is_quarter_of_second(survey)),
        row(
            "goldberg-sides",
            "Goldberg's first family has the sides 3a, b, b, b, c, c with b² = a² + e² and \
             c² = 4a² + e², and tiles space for every ratio a/e",
            "3a, b, b, b, c, c",
        )
        .citing(survey, &["goldberg-1-all"])
        .found_for_all(goldberg_family(survey)),
        row(
            "goldberg-c-edges",
            "in Goldberg's first family the edges of valence four are those of length c",
            "the edges of length c",
        )
        .citing(survey, &["goldberg-1"])
        .found(edges_of_valence_four(survey)),
        goldberg_cut(
            survey,
            "goldberg-2",
            Cut::LongEdge,
            "the plane through the middle edge b and the midpoint of the edge 3a cuts Goldberg's \
             tetrahedron into two congruent ones, those of another family",
        ),
        goldberg_cut(
            survey,
            "goldberg-3",
            Cut::MiddleEdge,
            "the plane through the edge 3a and the midpoint of the middle edge b cuts Goldberg's \
             tetrahedron into two congruent ones, those of another family",
        ),
    ]
}

/// A tetrahedron by its corners in a basis with a Gram matrix.
#[derive(Clone)]
struct Tetrahedron {
    gram: [[Number; 3]; 3],
    corners: [[Number; 3]; 4],
}

impl Tetrahedron {
    /// The first tetrahedron of a tiling by congruent ones.
    fn of(study: &Study<3>) -> Self {
        Tetrahedron::first(&study.tiling)
    }

    fn first(tiling: &Tiling<3>) -> Self {
        let corners = tiling.simplex(SimplexId::new(0));
        Tetrahedron {
            gram: tiling.frame.gram.clone(),
            corners: std::array::from_fn(|k| tiling.position(&corners[k])),
        }
    }

    fn square(&self, i: usize, j: usize) -> Number {
        let edge = linear::subtract(&self.corners[i], &self.corners[j]);
        linear::square(&self.gram, &edge)
    }

    /// The mean of some corners.
    fn mean(&self, of: &[usize]) -> [Number; 3] {
        let share = Number::from(Rational::from_unsigneds(1, of.len() as u64));
        std::array::from_fn(|k| {
            let sum = of
                .iter()
                .fold(Number::zero(), |sum, &i| sum + &self.corners[i][k]);
            sum * &share
        })
    }

    /// The tetrahedron with one corner moved to a point.
    fn with_corner(&self, corner: usize, point: [Number; 3]) -> Self {
        let mut moved = self.clone();
        moved.corners[corner] = point;
        moved
    }

    /// Both halves that the midpoint of the edge ij makes.
    fn halves(&self, i: usize, j: usize) -> [Self; 2] {
        let middle = self.mean(&[i, j]);
        [
            self.with_corner(i, middle.clone()),
            self.with_corner(j, middle),
        ]
    }

    fn squared_edges(&self) -> Vec<Number> {
        EDGES.iter().map(|&(i, j)| self.square(i, j)).collect()
    }

    fn is_congruent(&self, other: &Self) -> bool {
        congruence_form(&self.squared_edges(), 4) == congruence_form(&other.squared_edges(), 4)
    }

    /// Equal exactly for similar tetrahedra: the form of its edges in units of the shortest.
    fn similarity_form(&self) -> Option<Vec<Number>> {
        let edges = self.squared_edges();
        let scale = edges.iter().min()?.inverse()?;
        let scaled: Vec<Number> = edges.iter().map(|edge| edge * &scale).collect();
        Some(congruence_form(&scaled, 4))
    }

    fn is_similar(&self, other: &Self) -> bool {
        let form = self.similarity_form();
        form.is_some() && form == other.similarity_form()
    }
}

const EDGES: [(usize, usize); 6] = [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)];

fn first_is_half_of_third(survey: &Survey) -> Finding {
    let first = Tetrahedron::of(survey.space("sommerville-1")?);
    let third = Tetrahedron::of(survey.space("sommerville-3")?);
    let is_cut = |&&(i, j): &&(usize, usize)| {
        third
            .halves(i, j)
            .iter()
            .all(|half| half.is_similar(&first))
    };
    let cut = EDGES.iter().find(is_cut);
    Ok(match cut {
        Some(&(i, j)) => {
            let square = third.square(i, j);
            let text = format!("cut through the midpoint of an edge of squared length {square}");
            (
                true,
                format!("{text}: both halves are similar to the first"),
            )
        }
        None => (
            false,
            "no edge's midpoint gives halves similar to the first".to_owned(),
        ),
    })
}

fn fourth_is_quarter_of_second(survey: &Survey) -> Finding {
    let second = Tetrahedron::of(survey.space("sommerville-2")?);
    let fourth = Tetrahedron::of(survey.space("sommerville-4")?);
    let centroid = second.mean(&[0, 1, 2, 3]);
    let holds = (0..4).all(|k| second.with_corner(k, centroid.clone()).is_similar(&fourth));
    Ok((
        holds,
        "all four parts, of equal volume, are compared with the fourth".to_owned(),
    ))
}

/// A corner order with |01|² = |12|² = |23|² = a² + e², |02|² = |13|² = 4a² + e² and
/// |03|² = 9a², with a² and e².
struct Goldberg {
    order: [usize; 4],
    a: Number,
    e: Number,
}

impl Goldberg {
    fn of(tetrahedron: &Tetrahedron) -> Option<Self> {
        for order in orders() {
            let square = |x: usize, y: usize| tetrahedron.square(order[x], order[y]);
            let a = square(0, 3) * Number::from(Rational::from_signeds(1, 9));
            let b = square(0, 1);
            let e = &b - &a;
            let c = &a * Number::from(Rational::from(4)) + &e;
            let fits = square(1, 2) == b && square(2, 3) == b && square(0, 2) == c;
            if fits && square(1, 3) == c && e.sign().is_gt() {
                return Some(Goldberg { order, a, e });
            }
        }
        None
    }
}

/// The family proves the tilings. Its squared edges are polynomials in s = e²/(a² + e²), up to a factor, and
/// they are those of the statement.
fn goldberg_family(survey: &Survey) -> Finding {
    let general = survey.general("goldberg-1-all")?;
    let Some(AnyFamily::Space(family)) = &general.family else {
        return Err("goldberg-1-all: is not in space".to_owned());
    };
    let cleared = Cleared::new(family, to_number);
    let is_every_ratio = family.cuboid().sides[0].to_string() == "(0, 1)";
    let mut simplices = family.simplices();
    let holds = is_every_ratio && simplices.all(|simplex| has_goldberg_sides(&cleared, simplex));
    let proved = "the certificate is about every s = e²/(a² + e²) between 0 and 1; the squared sides of every \
                  tetrahedron are b² times 9 (1 - s), 1, 1, 1, 4 - 3s, 4 - 3s, as polynomials";
    Ok((holds, proved.to_owned()))
}

/// In some order of the corners, |01|² = |12|² = |23|² = b², |02|² = |13|² = (4 - 3s) b² and
/// |03|² = 9 (1 - s) b². With s = e²/(a² + e²) and b² = a² + e² these are 4a² + e² and 9a².
fn has_goldberg_sides(cleared: &Cleared<Number, 3>, simplex: SimplexId) -> bool {
    let corners = cleared.corners(simplex);
    let square = |i: usize, j: usize| {
        let [p, q] = [i, j].map(|k| cleared.position(&corners[k]));
        linear::square(&cleared.gram, &linear::subtract(&p, &q))
    };
    let s: Polynomial = Polynomial::parameter(0);
    let of_c = s.integer(4).minus(&s.times(&s.integer(3)));
    let of_long = s.integer(9).minus(&s.times(&s.integer(9)));
    orders().any(|[p, q, r, t]| {
        let b = square(p, q);
        let c = b.times(&of_c);
        let is_chain = square(q, r) == b && square(r, t) == b && square(p, t) == b.times(&of_long);
        is_chain && square(p, r) == c && square(q, t) == c
    })
}

/// All orders of four corners.
fn orders() -> impl Iterator<Item = [usize; 4]> {
    let triples = (0..4).flat_map(|i| (0..4).flat_map(move |j| (0..4).map(move |k| [i, j, k])));
    let distinct = triples.filter(|[i, j, k]| i != j && j != k && i != k);
    distinct.map(|[i, j, k]| [i, j, k, 6 - i - j - k])
}

fn edges_of_valence_four(survey: &Survey) -> Finding {
    let study = survey.space("goldberg-1")?;
    let shape = Goldberg::of(&Tetrahedron::of(study)).ok_or("goldberg-1: has other sides")?;
    let c = &shape.a * Number::from(Rational::from(4)) + &shape.e;
    let tiling = &study.tiling;
    let length = |ridge: &acutile_core::classify::Ridge<3>| {
        let [p, q] = [0, 1].map(|k| tiling.position(&ridge.corners[k]));
        linear::square(&tiling.frame.gram, &linear::subtract(&p, &q))
    };
    let holds = study
        .ridges
        .list
        .iter()
        .all(|ridge| (ridge.valence() == 4) == (length(ridge) == c));
    let count = study.ridges.valence_counts().get(&4).copied().unwrap_or(0);
    Ok((
        holds,
        format!("{count} edges of valence four in a cell, compared with c by length"),
    ))
}

/// Which edge a cut halves.
#[derive(Clone, Copy)]
enum Cut {
    /// 3a
    LongEdge,
    /// The b that shares no corner with 3a.
    MiddleEdge,
}

fn goldberg_cut(survey: &Survey, name: &str, cut: Cut, statement: &str) -> Row {
    Row::new(
        "2.2",
        &format!("cut-{name}"),
        statement,
        "two congruent pieces",
    )
    .citing(survey, &["goldberg-1", name])
    .found(halves_are(name, cut))
}

/// Ratios a/e for which both families are built; squared edges are linear in a² and e², so
/// two would do.
const RATIOS: [&str; 4] = ["1/2", "1", "sqrt(2)/2", "sqrt(2)/4"];

/// Whether the halves of a tetrahedron of the first family are congruent, and similar to
/// that of the family `name` with the same ratio.
fn halves_are(name: &str, cut: Cut) -> Finding {
    for ratio in RATIOS {
        let whole = family_member("goldberg-1", ratio)?;
        let order = Goldberg::of(&whole)
            .ok_or("goldberg-1: has other sides")?
            .order;
        let (i, j) = match cut {
            Cut::LongEdge => (order[0], order[3]),
            Cut::MiddleEdge => (order[1], order[2]),
        };
        let [one, other] = whole.halves(i, j);
        if !one.is_congruent(&other) {
            return Ok((
                false,
                format!("the halves are not congruent for a/e = {ratio}"),
            ));
        }
        if !one.is_similar(&family_member(name, ratio)?) {
            return Ok((
                false,
                format!("the halves are congruent, but not similar to {name} for a/e = {ratio}"),
            ));
        }
    }
    let ratios = RATIOS.join(", ");
    Ok((
        true,
        format!(
            "the halves are congruent, and similar to {name} with the same ratio, for a/e = {ratios}; squared edges are linear in a² and e²"
        ),
    ))
}

/// The tetrahedron of a family for a ratio, whether or not the tiling is face to face.
fn family_member(name: &str, ratio: &str) -> Result<Tetrahedron, String> {
    match catalog::build_with(name, ratio) {
        Ok(AnyTiling::Space(tiling)) => Ok(Tetrahedron::first(&tiling)),
        Ok(AnyTiling::Plane(_)) => Err(format!("{name}: is not in space")),
        Err(error) => Err(error.to_string()),
    }
}
