//! Section 2.1: acute and nonobtuse triangulations of the square.

use super::row::{Finding, Row};
use crate::survey::{AnyStudy, Study, Survey};
use crate::table::Figure;
use acutile_core::quality::{DihedralAngle, Exact};
use acutile_core::statement::Statement;
use acutile_exact::geometry::Simplex;
use acutile_exact::number::Number;
use malachite::Rational;

/// The rows of section 2.1.
pub fn rows(survey: &Survey) -> Vec<Row> {
    vec![
        Row::new(
            "2.1",
            "square/diagonal",
            "a diagonal cuts a square into two nonobtuse triangles",
            "nonobtuse",
        )
        .found(Ok(diagonal())),
        acute_square(survey, "square-8", "eight", 8),
        acute_square(survey, "square-10", "ten", 10),
        acute_square(survey, "square-14", "fourteen", 14),
        largest_angle(
            survey,
            "square-8",
            "85",
            "eight acute triangles, realised with a largest angle of about 85 degrees",
        ),
        largest_angle(
            survey,
            "square-10",
            "80.3",
            "ten acute triangles, realised with a largest angle of about 80.3 degrees",
        ),
        largest_angle(
            survey,
            "square-14",
            "72",
            "fourteen acute triangles with a largest angle of 72 degrees",
        ),
        Row::new(
            "2.1",
            "square/five-valent",
            "every acute triangulation of a square has an interior vertex of valence five, so that \
             its largest angle is at least 72 degrees",
            "72° is the best possible",
        )
        .found(Ok(euler())),
        Row::new(
            "2.1",
            "square/five-valent-examples",
            "the three triangulations of the square have interior vertices of valence five",
            "valence five",
        )
        .citing(survey, &["square-8", "square-10", "square-14"])
        .found(five_valent_vertices(survey)),
    ]
}

/// The half (0,0), (1,0), (0,1); the other one is congruent to it.
fn diagonal() -> (bool, String) {
    let number = |n: i64| Number::from(Rational::from(n));
    let half = Simplex::new(&[[0, 0], [1, 0], [0, 1]].map(|point| point.map(number)));
    let products = half.normal_products(&[[1, 0], [0, 1]].map(|row| row.map(number)));
    let degrees: Vec<String> = [(0, 1), (0, 2), (1, 2)]
        .into_iter()
        .filter_map(|(i, j)| DihedralAngle::between(&products, i, j)?.closed_form())
        .collect();
    (
        degrees == ["45", "45", "90"],
        format!("angles of {} degrees", degrees.join(", ")),
    )
}

fn plane<'a>(survey: &'a Survey, name: &str) -> Result<&'a Study<2>, String> {
    match survey.get(name)? {
        AnyStudy::Plane(study) => Ok(study),
        AnyStudy::Space(_) => Err(format!("{name}: is not in the plane")),
    }
}

fn acute_square(survey: &Survey, name: &str, words: &str, count: usize) -> Row {
    let finding = || {
        let study = plane(survey, name)?;
        let holds = study.tiling.len() == count && study.states(&Statement::Acute);
        Ok((
            holds,
            format!("{} triangles, certified acute", study.tiling.len()),
        ))
    };
    Row::new(
        "2.1",
        &format!("{name}/acute"),
        &format!("a square can be cut into {words} acute triangles"),
        &count.to_string(),
    )
    .citing(survey, &[name])
    .found(finding())
}

fn largest_angle(survey: &Survey, name: &str, printed: &str, statement: &str) -> Row {
    let figure = plane(survey, name).map(|study| Figure::of(&study.ranges.largest_dihedral.max));
    Row::new("2.1", &format!("{name}/largest-angle"), statement, printed)
        .citing(survey, &[name])
        .figure("°", figure)
}

/// A triangulation with I vertices inside and S on the open sides has, by Euler's formula, 2I + S + 2
/// triangles, hence 6I + 3S + 6 corners of triangles. If it is acute, each corner of the square is in at
/// least 2 triangles, and each vertex on a side in at least 3. If each vertex inside were in 6, there would
/// be at least 6I + 3S + 8.
fn euler() -> (bool, String) {
    // Coefficients of I, S, 1.
    let triangles = [2, 1, 2];
    let corners = triangles.map(|c| 3 * c);
    let at_least = [6, 3, 4 * 2];
    let holds = corners[..2] == at_least[..2] && corners[2] < at_least[2];
    let proved = "with I vertices inside and S on the sides there are 6I + 3S + 6 corners of \
                  triangles; without an interior vertex of valence at most five there would be \
                  6I + 3S + 8; and valence below five gives an angle of 90° or more";
    (holds, proved.to_owned())
}

fn five_valent_vertices(survey: &Survey) -> Finding {
    let mut words = Vec::new();
    let mut holds = true;
    for name in ["square-8", "square-10", "square-14"] {
        let counts = plane(survey, name)?.ridges.valence_counts();
        let fives = counts.get(&5).copied().unwrap_or(0);
        holds &= fives > 0;
        words.push(format!("{name} has {fives}"));
    }
    Ok((holds, words.join(", ")))
}
