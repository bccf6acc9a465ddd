//! POSCAR and CONTCAR of VASP: a comment, a scale, three vectors, species, counts, positions.
//!
//! The format is that of the VASP wiki, "POSCAR". A negative scale is the volume of the cell. If the
//! scale that follows from it is irrational, it is rounded to 12 digits. A structure with another
//! scale is similar, and only lengths depend on it. Velocities are not read.

use super::vectors::{self, Coordinates, Listed, Vector, determinant, number, species};
use crate::import::ImportError;
use crate::import::atoms::options::CifOptions;
use crate::import::atoms::structure::Structure;
use acutile_core::statement::counted;
use acutile_exact::number::Number;
use malachite::Rational;
use malachite::base::num::arithmetic::traits::{Abs, CheckedRoot, Floor, FloorRoot, Pow};

/// The lines of a file, numbered from 1.
struct Lines<'t> {
    lines: std::iter::Enumerate<std::str::Lines<'t>>,
}

impl<'t> Lines<'t> {
    fn next(&mut self, expected: &str) -> Result<(usize, &'t str), ImportError> {
        match self.lines.next() {
            Some((index, line)) => Ok((index + 1, line.trim())),
            None => Err(ImportError::entry(
                "the end of the file",
                format!("expected {expected}"),
            )),
        }
    }
}

/// Whether a text looks like a POSCAR: numbers where its scale and vectors are, then counts of species,
/// perhaps after a line with their names.
pub fn is_likely(text: &str) -> bool {
    let counts: Vec<Option<usize>> = text.lines().skip(1).take(4).map(numbers_in).collect();
    let has_vectors = matches!(counts[..], [Some(1 | 3), Some(3), Some(3), Some(3)]);
    let words = |line: usize| {
        text.lines()
            .nth(line)
            .into_iter()
            .flat_map(str::split_whitespace)
    };
    let are_counts = |line: usize| {
        let counts: Option<Vec<u32>> = words(line).map(|word| word.parse().ok()).collect();
        counts.is_some_and(|counts| counts.iter().any(|&count| count > 0))
    };
    let are_names = |line: usize| {
        let is_name = |word: &str| word.starts_with(|c: char| c.is_ascii_alphabetic());
        words(line).all(is_name)
    };
    has_vectors && (are_counts(5) || are_names(5) && are_counts(6))
}

fn numbers_in(line: &str) -> Option<usize> {
    let words = line.split_ascii_whitespace();
    words
        .map(|word| word.parse::<f64>().ok())
        .collect::<Option<Vec<_>>>()
        .map(|numbers| numbers.len())
}

/// Reads the text of a POSCAR.
pub fn read(text: &str, options: &CifOptions) -> Result<Structure, ImportError> {
    let text = text.trim_start_matches('\u{feff}');
    let mut lines = Lines {
        lines: text.lines().enumerate(),
    };
    let (_, comment) = lines.next("a comment")?;
    let scale = lines.next("the scale")?;
    let mut vectors = Vec::new();
    for name in ["a", "b", "c"] {
        vectors.push(vector(lines.next(&format!("the vector {name}"))?)?);
    }
    let [a, b, c] = &vectors[..] else {
        return Err(ImportError::entry("lattice", "expected three vectors"));
    };
    let unscaled = [a.clone(), b.clone(), c.clone()];
    let Scales { scales, notes } = scales(scale, &unscaled)?;
    let scaled = unscaled.map(|vector| stretched(vector, &scales));
    let (names, counts) = species_and_counts(comment, &mut lines)?;
    let (mut line, mut mode) = lines.next("Direct or Cartesian")?;
    if mode.starts_with(['s', 'S']) {
        (line, mode) = lines.next("Direct or Cartesian")?;
    }
    let coordinates = match mode.chars().next() {
        Some('c' | 'C' | 'k' | 'K') => Coordinates::Cartesian,
        // VASP takes every other letter for direct coordinates, like that of Fractional.
        Some(letter) if letter.is_alphabetic() => Coordinates::Fractional,
        _ => {
            let problem = format!("found {mode:?}, expected Direct or Cartesian");
            return Err(ImportError::entry(format!("line {line}"), problem));
        }
    };
    let mut atoms = Vec::new();
    for (name, count) in names.iter().zip(counts) {
        for index in 1..=count {
            let line = lines.next("the position of an atom")?;
            let position = vector(line)?;
            atoms.push(Listed {
                // VASP may write the hash of a potential after the element.
                label: format!("{}{index}", name.split('/').next().unwrap_or(name)),
                element: species(name),
                position: match coordinates {
                    Coordinates::Cartesian => stretched(position, &scales),
                    Coordinates::Fractional => position,
                },
                place: format!("line {}", line.0),
            });
        }
    }
    let rest = lines
        .lines
        .filter(|(_, line)| !line.trim().is_empty())
        .count();
    let unread = (rest > 0).then(|| {
        format!(
            "{} not read",
            counted(
                rest,
                "line after the positions is",
                "lines after the positions are"
            )
        )
    });
    let notes = notes.into_iter().chain(unread).collect();
    vectors::structure(
        comment.to_owned(),
        &scaled,
        coordinates,
        atoms,
        notes,
        options,
    )
}

/// The first three numbers of a line.
fn vector((line, text): (usize, &str)) -> Result<Vector, ImportError> {
    let place = || format!("line {line}");
    let words: Vec<&str> = text.split_ascii_whitespace().take(3).collect();
    let [x, y, z] = words[..] else {
        let problem = format!("found {text:?}, expected three numbers");
        return Err(ImportError::entry(place(), problem));
    };
    Ok([number(x, place)?, number(y, place)?, number(z, place)?])
}

fn stretched(vector: Vector, scales: &Vector) -> Vector {
    std::array::from_fn(|k| &vector[k] * &scales[k])
}

/// One factor for all directions, or one for each Cartesian direction, and a note about it.
struct Scales {
    scales: Vector,
    notes: Vec<String>,
}

fn scales((line, text): (usize, &str), vectors: &[Vector; 3]) -> Result<Scales, ImportError> {
    let exact = |scales: Vector| Scales {
        scales,
        notes: Vec::new(),
    };
    let place = || format!("line {line}");
    let wrong = |problem: &str| {
        Err(ImportError::entry(
            place(),
            format!("found {text:?}, {problem}"),
        ))
    };
    let words: Vec<&str> = text
        .split_ascii_whitespace()
        .take_while(|word| word.parse::<f64>().is_ok())
        .collect();
    match words[..] {
        [one] => {
            let scale = number(one, place)?;
            if scale > 0 {
                return Ok(exact([scale.clone(), scale.clone(), scale]));
            }
            let volume = determinant(vectors).abs();
            // The lattice reports a volume of zero later.
            let cube = if volume == 0 {
                volume
            } else {
                (&scale).abs() / volume
            };
            match (&cube).checked_root(3u64) {
                Some(root) if root == 0 => wrong("expected a scale or a volume that is not 0"),
                Some(root) => Ok(exact([root.clone(), root.clone(), root])),
                None => Ok(rounded(&cube)),
            }
        }
        [x, y, z] => {
            let scales = [number(x, place)?, number(y, place)?, number(z, place)?];
            if scales.iter().all(|scale| *scale > 0) {
                Ok(exact(scales))
            } else {
                wrong("expected three positive scales")
            }
        }
        _ => wrong("expected a scale, or three"),
    }
}

/// The cube root to 12 decimals.
fn rounded(cube: &Rational) -> Scales {
    let unit = Rational::from(10).pow(12u64);
    // The floor of the root of n is that of the root of the floor of n.
    let scaled = (cube * (&unit).pow(3u64)).floor();
    let scale = Rational::from(scaled.floor_root(3)) / unit;
    let digits = Number::from(scale.clone()).approximate();
    Scales {
        notes: vec![format!(
            "the scale that the volume needs is irrational, and rounded to {digits}; lengths alone \
             depend on it, no angle and no ratio"
        )],
        scales: [scale.clone(), scale.clone(), scale],
    }
}

/// The names of the species and how many atoms each has. Old files have no names; then the comment
/// may name them.
fn species_and_counts(
    comment: &str,
    lines: &mut Lines,
) -> Result<(Vec<String>, Vec<usize>), ImportError> {
    let (mut line, mut text) = lines.next("species or counts")?;
    let is_number = |text: &str| {
        text.bytes()
            .next()
            .is_some_and(|byte| byte.is_ascii_digit())
    };
    let mut names = None;
    if !is_number(text) {
        names = Some(words(text));
        (line, text) = lines.next("the counts of the species")?;
    }
    let wrong = || {
        let problem = format!("found {text:?}, expected the counts of the species");
        ImportError::entry(format!("line {line}"), problem)
    };
    let counts: Vec<usize> = text
        .split_ascii_whitespace()
        .take_while(|word| is_number(word))
        .map(|word| word.parse::<usize>())
        .collect::<Result<_, _>>()
        .map_err(|_| wrong())?;
    let total = counts
        .iter()
        .fold(0usize, |sum, count| sum.saturating_add(*count));
    if counts.is_empty() || total == 0 {
        return Err(wrong());
    }
    let of_comment = words(comment);
    let is_named =
        of_comment.len() == counts.len() && of_comment.iter().all(|name| species(name).is_some());
    let names = match names {
        Some(names) => names,
        None if is_named => of_comment,
        None => (1..=counts.len()).map(|k| format!("species{k}_")).collect(),
    };
    if names.len() != counts.len() {
        let problem = format!("{} species have {} counts", names.len(), counts.len());
        return Err(ImportError::entry(format!("line {line}"), problem));
    }
    Ok((names, counts))
}

fn words(text: &str) -> Vec<String> {
    text.split_ascii_whitespace()
        .map(ToOwned::to_owned)
        .collect()
}
