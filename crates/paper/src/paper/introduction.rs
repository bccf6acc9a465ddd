//! The abstract and section 1.

use super::row::{Finding, Row};
use crate::survey::Survey;
use acutile_core::checker::{
    Findings, Model, check_corners, check_facets, check_orientation, check_volume,
};
use acutile_core::quality::{DihedralAngle, Exact, rounded_down, rounded_up};
use acutile_core::statement::{Statement, in_words};
use acutile_core::tiling::{Corner, Frame, Tiling, VertexId, match_facets};
use acutile_core::with_family;
use acutile_exact::number::Field;
use malachite::Rational;

/// The constructions of section 4 that tile space.
pub const ACUTE: [&str; 7] = ["z", "a15", "sigma", "h", "c15", "icosahedral", "slab-stack"];

/// The tetrahedra that tile space by congruent copies, and are not acute.
pub const CONGRUENT: [&str; 7] = [
    "sommerville-1",
    "sommerville-2",
    "sommerville-3",
    "sommerville-4",
    "goldberg-1",
    "goldberg-2",
    "goldberg-3",
];

/// The rows of the abstract and of section 1.
pub fn rows(survey: &Survey) -> Vec<Row> {
    vec![
        main_theorem(survey),
        largest_angle_of_z(survey),
        acute_slab(survey),
        Row::new(
            "1",
            "triangles-tile-the-plane",
            "congruent copies of any single triangle tile the plane",
            "trivial",
        )
        .found(copies_of_a_triangle()),
        Row::new(
            "1",
            "acute-triangles-tile-the-plane",
            "congruent copies of any acute triangle are an acute tiling of the plane; x and y range over all \
             acute triangles up to similarity",
            "trivial",
        )
        .citing(survey, &["triangle-tiling-all"])
        .found_for_all(states_for_all(survey, "triangle-tiling-all", &[Statement::Acute])),
        Row::new(
            "1",
            "regular-does-not-tile",
            "regular tetrahedra do not tile space face to face: no whole number of them fits \
             around an edge",
            "cannot tile space",
        )
        .found(regular_around_an_edge()),
        Row::new(
            "1",
            "bcc-angles",
            "the tetrahedra of the second Sommerville tiling have dihedral angles of exactly \
             60 and 90 degrees",
            "60° and 90°",
        )
        .citing(survey, &["sommerville-2"])
        .found(angles_of_bcc(survey)),
    ]
}

/// Whether the certificate about all members of a construction makes these statements.
pub fn states_for_all(survey: &Survey, name: &str, statements: &[Statement]) -> Finding {
    let general = survey.general(name)?;
    let words: Vec<String> = statements.iter().map(|s| in_words(s, 3)).collect();
    let words = words.join(", ");
    let members = match &general.family {
        Some(family) => {
            let parameters = with_family!(family, f => f.parameters.iter());
            let sides = parameters.map(|p| format!("{} in {}", p.name, p.side));
            format!("for {}", sides.collect::<Vec<_>>().join(", "))
        }
        None => "over every tiling or word, periodic or not".to_owned(),
    };
    Ok(if statements.iter().all(|s| general.states(s)) {
        (true, format!("{name}, {members}: {words}"))
    } else {
        (
            false,
            format!("{name}: its certificate does not state {words}"),
        )
    })
}

/// The theorem of section 4.3, in the introduction the answer to problem 2.
fn main_theorem(survey: &Survey) -> Row {
    Row::new(
        "1",
        "main-theorem",
        "space can be tiled by acute tetrahedra; each construction of section 4 shows it",
        "theorem",
    )
    .citing(survey, &ACUTE)
    .found(all_state(survey, &ACUTE, &Statement::Acute))
}

/// Whether all these constructions are certified with a statement.
pub fn all_state(survey: &Survey, names: &[&str], statement: &Statement) -> Finding {
    let mut without = Vec::new();
    for name in names {
        if !survey.get(name)?.states(statement) {
            without.push(*name);
        }
    }
    Ok(match without[..] {
        [] => (true, format!("certified: {}", names.join(", "))),
        _ => (false, format!("not certified: {}", without.join(", "))),
    })
}

fn largest_angle_of_z(survey: &Survey) -> Row {
    let finding = || {
        let study = survey.space("z")?;
        let largest = &study.ranges.largest_dihedral.max;
        let (low, high) = largest.enclosure(&Rational::from_signeds(1, 1_000_000_000));
        let holds = high < Rational::from_signeds(7708, 100);
        let form = largest.closed_form().unwrap_or_default();
        let (low, high) = (rounded_down(&low, 9), rounded_up(&high, 9));
        Ok((holds, format!("the largest is {form} = {low} to {high}°")))
    };
    Row::new(
        "abstract",
        "angles-below-77.08",
        "there is a tiling of space with all dihedral angles below 77.08 degrees (the structure Z \
         over the triangle tiling)",
        "77.08°",
    )
    .citing(survey, &["z"])
    .found(finding())
}

fn acute_slab(survey: &Survey) -> Row {
    Row::new(
        "abstract",
        "acute-slab",
        "a slab between two parallel planes can be tiled by acute tetrahedra",
        "tiles a slab",
    )
    .citing(survey, &["slab"])
    .found(all_state(survey, &["slab"], &Statement::Acute))
}

/// Two sides span a lattice, and the triangle with its mirror image in the midpoint of the third
/// side is a cell. Orientation, facets and volume are conditions on coordinates in the
/// basis of the sides, which are the same for all triangles.
fn copies_of_a_triangle() -> Finding {
    let corner = |x, y| Corner {
        vertex: VertexId::new(0),
        shift: [x, y],
    };
    let tiling = Tiling {
        frame: Frame::cubic(),
        vertices: vec![[Field::rationals().integer(0), Field::rationals().integer(0)]].into(),
        corners: vec![
            corner(0, 0),
            corner(1, 0),
            corner(0, 1),
            corner(1, 1),
            corner(0, 1),
            corner(1, 0),
        ],
    };
    let mut findings = Findings::new(1);
    let model = Model::new(&tiling);
    check_corners(&tiling, &mut findings);
    check_orientation(&model, &mut findings);
    let no_faces = vec![Vec::new(); tiling.vertices.len()];
    check_facets(&tiling, &match_facets(&tiling), &no_faces, &mut findings);
    check_volume(&model, &mut findings);
    let proved = "two triangles in the cell spanned by two sides; the hypotheses checked do not \
                  involve the metric, so they hold for every triangle";
    Ok((findings.is_empty(), proved.to_owned()))
}

/// arccos(1/3), the dihedral angle of the regular tetrahedron.
pub fn regular_angle() -> DihedralAngle {
    DihedralAngle::of_rational(Rational::from_signeds(1, 9))
}

/// The dihedral angle θ = arccos(1/3) satisfies 360/6 < θ < 360/5.
fn regular_around_an_edge() -> Finding {
    let (low, high) = regular_angle().enclosure(&Rational::from_signeds(1, 1_000_000));
    let holds = low > 60 && high < 72;
    Ok((
        holds,
        "60° < arccos(1/3) < 72°: five around an edge leave a gap, six overlap".to_owned(),
    ))
}

fn angles_of_bcc(survey: &Survey) -> Finding {
    let study = survey.space("sommerville-2")?;
    let angles: Vec<String> = study
        .measures()
        .iter()
        .flat_map(|measures| &measures.angles)
        .filter_map(Exact::closed_form)
        .collect();
    let holds = study.measures().len() == 1 && angles == ["60", "60", "60", "60", "90", "90"];
    Ok((
        holds,
        format!("the angles in degrees: {}", angles.join(", ")),
    ))
}
