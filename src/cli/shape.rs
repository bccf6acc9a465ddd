//! The polyhedron that `search balls --shape` aims at: a name, or a file with its corners.

use super::named::InputError;
use super::words::printable;
use acutile_io::import::read_text;
use acutile_optimize::balls::target::{NoTarget, Target};
use std::path::Path;

/// Names for messages.
const EXPECTED: &str = "tetrahedron, cube, octahedron, dodecahedron, icosahedron, prism:N with N sides \
                        (3, 4, 5, 6, 8, 10 or 12), prism:N,HEIGHT with the height in sides, \
                        or a file with the three coordinates of a corner on each line";

const CUBIC: [[&str; 3]; 3] = [["1", "0", "0"], ["0", "1", "0"], ["0", "0", "1"]];
const SIGNS: [&str; 2] = ["1", "-1"];

/// The polyhedron of a name or of a file.
///
/// # Errors
/// A message that names the file and its line.
pub fn shape(word: &str) -> Result<Target, InputError> {
    let path = Path::new(word);
    let named = match word {
        "tetrahedron" => of_points(&[
            ["1", "1", "1"],
            ["1", "-1", "-1"],
            ["-1", "1", "-1"],
            ["-1", "-1", "1"],
        ]),
        "cube" => of_points(&signed(["1", "1", "1"])),
        "octahedron" => of_points(&cyclic(&signed(["1", "0", "0"]))),
        "dodecahedron" => {
            let [phi, inverse] = ["(sqrt(5)+1)/2", "(sqrt(5)-1)/2"];
            let mut points = cyclic(&signed(["0", inverse, phi]));
            points.extend(signed(["1", "1", "1"]));
            of_points(&points)
        }
        "icosahedron" => of_points(&cyclic(&signed(["0", "1", "(sqrt(5)+1)/2"]))),
        _ => match word.strip_prefix("prism:") {
            Some(rest) => prism(rest)?,
            None if path.exists() || word.contains(['/', '.']) => return of_file(path),
            None => return Err(format!("--shape: found {word}, expected {EXPECTED}").into()),
        },
    };
    named.map_err(|error| format!("--shape {word}: {error}").into())
}

type Texts = Vec<[String; 3]>;

fn of_points<S: AsRef<str>>(points: &[[S; 3]]) -> Result<Target, NoTarget> {
    let points: Vec<[&str; 3]> = points.iter().map(|p| p.each_ref().map(S::as_ref)).collect();
    Target::of_texts(CUBIC, &points)
}

/// A point with all signs, each result once.
fn signed(point: [&str; 3]) -> Texts {
    let mut points = Texts::new();
    for x in SIGNS {
        for y in SIGNS {
            for z in SIGNS {
                let signs = [x, y, z];
                let image = [0, 1, 2].map(|k| match point[k] {
                    "0" => "0".to_owned(),
                    number => format!("{}*({number})", signs[k]),
                });
                if !points.contains(&image) {
                    points.push(image);
                }
            }
        }
    }
    points
}

/// The points with their coordinates in all cyclic orders.
fn cyclic(points: &Texts) -> Texts {
    let turned =
        |point: &[String; 3], by: usize| std::array::from_fn(|k| point[(k + by) % 3].clone());
    (0..3)
        .flat_map(|by| points.iter().map(move |point| turned(point, by)))
        .collect()
}

/// The right prism over a regular polygon. The basis has the directions of two successive sides, of length 1, and the
/// axis.
fn prism(rest: &str) -> Result<Result<Target, NoTarget>, InputError> {
    let (sides, height) = rest.split_once(',').unwrap_or((rest, "1"));
    // The cosine of the angle between the directions.
    let known = [
        (3, "-1/2"),
        (4, "0"),
        (5, "(sqrt(5)-1)/4"),
        (6, "1/2"),
        (8, "sqrt(2)/2"),
        (10, "(sqrt(5)+1)/4"),
        (12, "sqrt(3)/2"),
    ];
    let found = known.iter().find(|(n, _)| n.to_string() == sides);
    let Some((n, cosine)) = found else {
        return Err(
            format!("--shape: found a prism with {sides} sides, expected {EXPECTED}").into(),
        );
    };
    // The next direction is twice the cosine times one direction, less the one before.
    let (mut corner, mut side, mut next) = (
        zero(),
        ["1", "0"].map(str::to_owned),
        ["0", "1"].map(str::to_owned),
    );
    let mut points = Texts::new();
    for _ in 0..*n {
        for z in ["0", height] {
            points.push([corner[0].clone(), corner[1].clone(), z.to_owned()]);
        }
        corner = [0, 1].map(|k| format!("({})+({})", corner[k], side[k]));
        let after = [0, 1].map(|k| format!("2*({cosine})*({})-({})", next[k], side[k]));
        (side, next) = (next, after);
    }
    let gram = [["1", cosine, "0"], [cosine, "1", "0"], ["0", "0", "1"]];
    let points: Vec<[&str; 3]> = points
        .iter()
        .map(|p| p.each_ref().map(String::as_str))
        .collect();
    Ok(Target::of_texts(gram, &points))
}

fn zero() -> [String; 2] {
    ["0", "0"].map(str::to_owned)
}

/// The corners of a file: three numbers on each line; empty lines and those that begin with `#` say nothing.
fn of_file(path: &Path) -> Result<Target, InputError> {
    let text = read_text(path).map_err(|error| InputError::of_file(path, &error))?;
    let mut points = Vec::new();
    for (number, line) in text.lines().enumerate() {
        let line = line.trim();
        if line.is_empty() || line.starts_with('#') {
            continue;
        }
        let words: Vec<&str> = line.split_whitespace().collect();
        let [x, y, z] = words[..] else {
            return Err(format!(
                "{}: line {}: found {} numbers, expected the three coordinates of a corner",
                printable(path),
                number + 1,
                words.len()
            )
            .into());
        };
        points.push([x, y, z]);
    }
    Target::of_texts(CUBIC, &points).map_err(|error| format!("{}: {error}", printable(path)).into())
}
