//! Section 3.2: acute triangulations and Delaunay triangulations.

use super::identity::{dot, is_zero, minus};
use super::infinitesimal::Polynomial;
use super::introduction::states_for_all;
use super::row::{Finding, Row};
use crate::survey::Survey;
use acutile_core::statement::Statement;
use acutile_exact::geometry::{NormalProducts, RingElement, Scalar, Simplex, linear};
use acutile_exact::number::numbers;

/// The rows of section 3.2.
pub fn rows(survey: &Survey) -> Vec<Row> {
    let row = |id, statement, printed| Row::new("3.2", id, statement, printed);
    let planes: Vec<&str> = survey.planes().map(|(name, _)| name).collect();
    vec![
        row(
            "lemma-3",
            "lemma 3: an acute triangulation in the plane is Delaunay",
            "lemma 3",
        )
        .citing(survey, &planes)
        .found(acute_in_the_plane(survey)),
        row(
            "lemma-3-alternate-proof",
            "the circumcircle of an acute triangle is contained in the union of the three diametral \
             circles of its edges",
            "figure caption",
        )
        .found(Ok(diametral_circles())),
        row(
            "lemma-3-corollary",
            "an acute triangulation of a vertex set in the plane is unique",
            "corollary",
        )
        .found(Ok(unique())),
        row(
            "lemma-4-acute",
            "lemma 4: the tetrahedra abcd and bcde of the example are acute",
            "for small ε > 0",
        )
        .citing(survey, &["two-corners-all"])
        .found_for_all(example_is_acute(survey)),
        row(
            "lemma-4-not-delaunay",
            "lemma 4: e lies inside of the circumsphere of abcd, so that the triangulation is not Delaunay",
            "for small ε > 0",
        )
        .citing(survey, &["two-corners-all"])
        .found_for_all(example_is_not_delaunay(survey)),
        row(
            "lemma-4-certified",
            "lemma 4: the example, certified as an acute triangulation of a solid and not Delaunay",
            "acute, not Delaunay",
        )
        .citing(survey, &["two-corners"])
        .found(certified_example(survey)),
        row(
            "lemma-4-120",
            "the three tetrahedra abce, acde and abde have dihedral angles of 120 degrees along ae",
            "120°",
        )
        .found(Ok(angles_along_ae())),
        row(
            "lemma-4-flip",
            "the three tetrahedra abce, acde, abde and the two tetrahedra abcd, bcde fill the same body \
             (a 3-to-2 flip)",
            "3-to-2 flip",
        )
        .found(Ok(flip())),
    ]
}

/// In-circle as a polynomial of a = 0, b, c, d in the plane, D(p,q,r) = (q-p) × (r-p): with
/// P = D(a,b,c) times the power of d, P = D(a,d,b) (a-c)·(b-c) + D(a,b,c) (a-d)·(b-d). So if c and
/// d lie on different sides of ab and see it under acute angles, d is outside of the circle of
/// abc. That is the local condition of the soundness theorem on Delaunay tilings.
fn in_circle_identity() -> bool {
    is_zero(&[3; 6], |p| {
        let [b, c, d] = [[p[0], p[1], 0], [p[2], p[3], 0], [p[4], p[5], 0]];
        let a = [0; 3];
        let det = |x: [i128; 3], y: [i128; 3]| x[0] * y[1] - x[1] * y[0];
        // Power of d times the determinant of abc, expanded along |.|².
        let power = dot(d, d) * det(b, c) - dot(b, b) * det(d, c) - dot(c, c) * det(b, d);
        let from_c = det(d, b) * dot(minus(a, c), minus(b, c));
        let from_d = det(b, c) * dot(minus(a, d), minus(b, d));
        power - from_c - from_d
    })
}

fn acute_in_the_plane(survey: &Survey) -> Finding {
    let acute = survey
        .planes()
        .filter(|(_, study)| study.states(&Statement::Acute));
    let mut names = Vec::new();
    for (name, study) in acute {
        if !study.states(&Statement::Delaunay) {
            return Ok((false, format!("{name} is acute and not certified Delaunay")));
        }
        names.push(name);
    }
    let proved = format!(
        "identity: det times power is a sum of two products that are positive where both \
         opposite angles are acute; with Delaunay's lemma. Certified both acute and Delaunay: {}",
        names.join(", ")
    );
    Ok((in_circle_identity(), proved))
}

/// With barycentric coordinates λ of x, (x-a)·(x-b) - power(x) is affine in x, vanishes at a
/// and b and is (c-a)·(c-b) at c: it is λ_c (c-a)·(c-b). Where the power is at most 0 and λ_c <= 0, x is
/// in the circle over ab. Where all λ >= 0, the three angles at x add up to 360 degrees, and one of
/// them is obtuse.
fn diametral_circles() -> (bool, String) {
    let holds = is_zero(&[2; 6], |p| {
        let [b, c, x] = [[p[0], p[1], 0], [p[2], p[3], 0], [p[4], p[5], 0]];
        let det = |x: [i128; 3], y: [i128; 3]| x[0] * y[1] - x[1] * y[0];
        let area = det(b, c);
        let (at_b, at_c) = (det(x, c), det(b, x));
        let power = area * dot(x, x) - at_b * dot(b, b) - at_c * dot(c, c);
        area * dot(x, minus(x, b)) - power - at_c * dot(c, minus(c, b))
    });
    let proved = "identity (x-a)·(x-b) = power(x) + λ_c (c-a)·(c-b): outside of the triangle some λ is \
                  not positive; inside, one of three angles that add up to 360° is obtuse";
    (holds, proved.to_owned())
}

/// By lemma 3 the circumcircles of an acute triangulation are strictly empty, and the triangles
/// with strictly empty circumcircles are those of the only Delaunay triangulation.
fn unique() -> (bool, String) {
    let strict = "lemma 3 gives strictly empty circumcircles (both products are positive), and a \
                  vertex set has only one triangulation with these";
    (in_circle_identity(), strict.to_owned())
}

/// The points of lemma 4 with coordinates in `Q[ε]`: a, b, c, d, e.
fn points() -> [[Polynomial; 3]; 5] {
    let constant = |n| Polynomial::new(&[n], 1);
    let diagonal = |p: Polynomial| [p.clone(), p.clone(), p];
    let unit = |k: usize| std::array::from_fn(|i| constant(i64::from(i == k)));
    [
        diagonal(Polynomial::new(&[0, -1], 1)),
        unit(0),
        unit(1),
        unit(2),
        diagonal(Polynomial::new(&[2, 3], 3)),
    ]
}

fn simplex(corners: [usize; 4]) -> Simplex<Polynomial, 3> {
    let points = points();
    Simplex::new(&corners.map(|k| points[k].clone()))
}

fn unit_matrix() -> [[Polynomial; 3]; 3] {
    std::array::from_fn(|i| std::array::from_fn(|j| Polynomial::new(&[i64::from(i == j)], 1)))
}

fn products(corners: [usize; 4]) -> NormalProducts<Polynomial, 3> {
    simplex(corners).normal_products(&unit_matrix())
}

/// The certificate is about ε up to the value from which the example is Delaunay. Beyond it: all products
/// <g_i, g_j> are polynomials in ε without positive coefficients, and not zero.
fn example_is_acute(survey: &Survey) -> Finding {
    let (is_stated, certified) = states_for_all(survey, "two-corners-all", &[Statement::Acute])?;
    let holds = [[0, 1, 2, 3], [1, 2, 3, 4]].iter().all(|corners| {
        let products = products(*corners);
        products
            .pairs()
            .all(|(_, _, product)| product.is_negative_for_all())
    });
    let proved = format!(
        "{certified}; acute even for every ε > 0: all products of normals are polynomials in ε with no \
         positive coefficient"
    );
    Ok((holds && is_stated, proved))
}

/// The power of e is det times a polynomial that changes sign once for ε > 0 (Descartes: one
/// change of sign in its coefficients), at the root (√2 - 1)/3.
fn example_is_not_delaunay(survey: &Survey) -> Finding {
    let (is_stated, certified) =
        states_for_all(survey, "two-corners-all", &[Statement::NotDelaunay])?;
    let abcd = simplex([0, 1, 2, 3]);
    let points = points();
    let power = abcd.power(&unit_matrix(), &linear::subtract(&points[4], &points[0]));
    let signs: Vec<bool> = power
        .coefficients()
        .iter()
        .filter(|c| **c != 0)
        .map(|c| *c > 0)
        .collect();
    let changes = signs.windows(2).filter(|pair| pair[0] != pair[1]).count();
    let root = numbers(&["(sqrt(2)-1)/3"]).map_err(|error| error.to_string())?;
    let value = power
        .coefficients()
        .iter()
        .rev()
        .fold(acutile_exact::number::Number::zero(), |sum, c| {
            sum * &root[0] + acutile_exact::number::Number::from(c.clone())
        });
    // det > 0 for all ε > 0, negative power means inside.
    let positive = abcd.determinant.coefficients().iter().all(|c| *c >= 0);
    let is_root = signs.first() == Some(&false) && changes == 1 && value.is_zero();
    let proved = format!(
        "{certified}; inside exactly for 0 < ε < (√2 - 1)/3 = 0.13807…: the power of e has one positive root, on \
         the sphere at it and outside beyond it"
    );
    Ok((is_stated && positive && is_root, proved))
}

fn certified_example(survey: &Survey) -> Finding {
    let study = survey.space("two-corners")?;
    let delaunay = [Statement::Delaunay, Statement::WeaklyDelaunay];
    let holds = study.states(&Statement::Acute)
        && !delaunay.iter().any(|statement| study.states(statement));
    Ok((
        holds,
        "certified acute; neither Delaunay nor weakly Delaunay holds".to_owned(),
    ))
}

/// cos t = -1/2 means p > 0 and 4p² = q for the products p and q of the two facets.
fn angles_along_ae() -> (bool, String) {
    let holds = [[0, 1, 2, 4], [0, 2, 3, 4], [0, 3, 1, 4]]
        .iter()
        .all(|corners| {
            // The facets that meet in the edge of the corners 0 and 3 are those opposite 1 and 2.
            let products = products(*corners);
            let p = products.get(1, 2);
            let q = products.get(1, 1).times(products.get(2, 2));
            let four = p.integer(4);
            let is_positive = p.coefficients().iter().all(|c| *c >= 0) && !p.is_zero();
            is_positive && four.times(&p.times(p)).minus(&q).is_zero()
        });
    (
        holds,
        "exactly 120° for every ε > 0: 4p² = q in Q[ε] and p > 0".to_owned(),
    )
}

fn flip() -> (bool, String) {
    let volume = |corners| simplex(corners).determinant;
    let three = volume([0, 1, 2, 4])
        .plus(&volume([0, 2, 3, 4]))
        .plus(&volume([0, 3, 1, 4]));
    let two = volume([0, 1, 2, 3]).plus(&volume([1, 2, 3, 4]));
    let positive = [
        [0, 1, 2, 4],
        [0, 2, 3, 4],
        [0, 3, 1, 4],
        [0, 1, 2, 3],
        [1, 2, 3, 4],
    ]
    .iter()
    .all(|corners| volume(*corners).sign().is_gt());
    let holds = positive && three.minus(&two).is_zero();
    (
        holds,
        "all five are positively oriented and the volumes agree in Q[ε]".to_owned(),
    )
}
