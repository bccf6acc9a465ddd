//! Hall symbols: a space group with its origin and axes in one line.
//!
//! The grammar is that of S. R. Hall, Acta Cryst. A 37 (1981) 517, as in International Tables B,
//! section 1.4, appendix A1.4.2. A symbol is a lattice letter, up to four generators, and a change of
//! basis in parentheses. Where quotes cannot be used, `=` stands for `"`.

use crate::change::Change;
use crate::motion::{IDENTITY, Motion, Rotation, Vector, closure};
use malachite::Rational;

/// Symbols are shorter.
const LENGTH_LIMIT: usize = 100;

/// The group of a Hall symbol, sorted, modulo the lattice of the cell.
///
/// # Errors
/// The problem with a symbol.
pub fn group(symbol: &str) -> Result<Vec<Motion>, String> {
    if symbol.len() > LENGTH_LIMIT {
        return Err(format!("is longer than {LENGTH_LIMIT} bytes"));
    }
    let (generators, change) = split_change(symbol)?;
    let mut words = generators.split([' ', '_']).filter(|word| !word.is_empty());
    let lattice = words.next().ok_or("is empty")?;
    let mut motions = lattice_motions(lattice)?;
    let mut before = None;
    for (position, word) in words.enumerate() {
        let generator = Generator::parse(word, position, before)?;
        before = Some((generator.order, generator.axis));
        motions.push(generator.motion()?);
    }
    if let Some(change) = change {
        motions = Change::parse(change)?.apply(&motions)?;
    }
    closure(&motions).ok_or_else(|| "generates no space group".to_owned())
}

/// The generators, and the inside of the parentheses after them.
fn split_change(symbol: &str) -> Result<(&str, Option<&str>), String> {
    match symbol.split_once('(') {
        None => Ok((symbol, None)),
        Some((head, tail)) => match tail.trim_end().strip_suffix(')') {
            Some(inner) => Ok((head, Some(inner))),
            None => Err("has a parenthesis without an end".to_owned()),
        },
    }
}

/// The centring translations, and the inversion for a minus.
fn lattice_motions(word: &str) -> Result<Vec<Motion>, String> {
    let letter = word.trim_start_matches('-');
    let points: &[[i64; 3]] = match letter.to_ascii_uppercase().as_str() {
        "P" => &[],
        "A" => &[[0, 6, 6]],
        "B" => &[[6, 0, 6]],
        "C" => &[[6, 6, 0]],
        "I" => &[[6, 6, 6]],
        "R" => &[[8, 4, 4], [4, 8, 8]],
        "S" => &[[4, 4, 8], [8, 8, 4]],
        "T" => &[[4, 8, 4], [8, 4, 8]],
        "H" => &[[8, 4, 0], [4, 8, 0]],
        "F" => &[[0, 6, 6], [6, 0, 6], [6, 6, 0]],
        _ => {
            return Err(format!(
                "has the lattice {word:?}, expected P, A, B, C, I, R, H, S, T or F"
            ));
        }
    };
    let mut motions: Vec<Motion> = points
        .iter()
        .map(|point| Motion::translation(twelfths(*point)))
        .collect();
    if word.starts_with('-') {
        motions.push(Motion {
            rotation: negative(IDENTITY),
            translation: twelfths([0; 3]),
        });
    }
    Ok(motions)
}

fn twelfths(point: [i64; 3]) -> Vector {
    point.map(|n| Rational::from_signeds(n, 12))
}

fn negative(rotation: Rotation) -> Rotation {
    rotation.map(|row| row.map(|entry| -entry))
}

/// The direction of an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Axis {
    X,
    Y,
    Z,
    /// `'`: the difference of the two axes other than the one before.
    Difference,
    /// `"`: their sum.
    Sum,
    /// `*`: along a + b + c.
    Diagonal,
}

struct Generator {
    is_improper: bool,
    order: u8,
    axis: Axis,
    /// The axis that `'` and `"` refer to.
    reference: Axis,
    /// In twelfths.
    shift: [i64; 3],
}

impl Generator {
    /// A generator at this position, from 0, after one of some order and axis.
    fn parse(word: &str, position: usize, before: Option<(u8, Axis)>) -> Result<Self, String> {
        let wrong = || {
            format!(
                "has the generator {word:?}, which is no rotation with an axis and translations"
            )
        };
        let rest = word.strip_prefix('-').unwrap_or(word);
        let mut letters = rest.chars();
        let order = match letters.next() {
            Some(digit @ ('1' | '2' | '3' | '4' | '6')) => digit as u8 - b'0',
            _ => return Err(wrong()),
        };
        let mut generator = Generator {
            is_improper: word.starts_with('-'),
            order,
            axis: default_axis(order, position, before),
            reference: match before {
                Some((_, axis @ (Axis::X | Axis::Y))) => axis,
                _ => Axis::Z,
            },
            shift: [0; 3],
        };
        let mut screw = None;
        for letter in letters {
            match letter {
                '1'..='5' if screw.is_none() => screw = Some(i64::from(letter as u8 - b'0')),
                'x' => generator.axis = Axis::X,
                'y' => generator.axis = Axis::Y,
                'z' => generator.axis = Axis::Z,
                '\'' => generator.axis = Axis::Difference,
                '"' | '=' => generator.axis = Axis::Sum,
                '*' => generator.axis = Axis::Diagonal,
                _ => {
                    let step = translation(letter).ok_or_else(wrong)?;
                    (0..3).for_each(|k| generator.shift[k] += step[k]);
                }
            }
        }
        if let Some(screw) = screw {
            let along = generator.axis.index().ok_or_else(wrong)?;
            generator.shift[along] += 12 * screw / i64::from(order);
        }
        Ok(generator)
    }

    fn motion(&self) -> Result<Motion, String> {
        let rotation = rotation(self.order, self.axis, self.reference).ok_or_else(|| {
            format!(
                "has a rotation of order {} about an axis that it cannot have",
                self.order
            )
        })?;
        Ok(Motion {
            rotation: if self.is_improper {
                negative(rotation)
            } else {
                rotation
            },
            translation: twelfths(self.shift),
        })
    }
}

impl Axis {
    fn index(self) -> Option<usize> {
        match self {
            Axis::X => Some(0),
            Axis::Y => Some(1),
            Axis::Z => Some(2),
            _ => None,
        }
    }
}

/// The axis of a generator that names none.
fn default_axis(order: u8, position: usize, before: Option<(u8, Axis)>) -> Axis {
    match (position, order, before) {
        (1, 2, Some((2 | 4, _))) => Axis::X,
        (1, 2, Some((3 | 6, _))) => Axis::Difference,
        (2, 3, _) => Axis::Diagonal,
        _ => Axis::Z,
    }
}

/// a, b, c: half an axis; n: half of all; u, v, w: a quarter; d: a quarter of all.
fn translation(letter: char) -> Option<[i64; 3]> {
    Some(match letter {
        'a' => [6, 0, 0],
        'b' => [0, 6, 0],
        'c' => [0, 0, 6],
        'n' => [6, 6, 6],
        'u' => [3, 0, 0],
        'v' => [0, 3, 0],
        'w' => [0, 0, 3],
        'd' => [3, 3, 3],
        _ => return None,
    })
}

fn rotation(order: u8, axis: Axis, reference: Axis) -> Option<Rotation> {
    let about_z: Rotation = match (order, axis) {
        (1, _) => return Some(IDENTITY),
        (3, Axis::Diagonal) => return Some([[0, 0, 1], [1, 0, 0], [0, 1, 0]]),
        (2, Axis::Difference) => [[0, -1, 0], [-1, 0, 0], [0, 0, -1]],
        (2, Axis::Sum) => [[0, 1, 0], [1, 0, 0], [0, 0, -1]],
        (_, Axis::Difference | Axis::Sum | Axis::Diagonal) => return None,
        (2, _) => [[-1, 0, 0], [0, -1, 0], [0, 0, 1]],
        (3, _) => [[0, -1, 0], [1, -1, 0], [0, 0, 1]],
        (4, _) => [[0, -1, 0], [1, 0, 0], [0, 0, 1]],
        _ => [[1, -1, 0], [1, 0, 0], [0, 0, 1]],
    };
    // The axes x, y, z in cyclic order such that the axis is the last one.
    let last = axis.index().or(reference.index())?;
    let place = [(last + 1) % 3, (last + 2) % 3, last];
    let mut rotation = [[0; 3]; 3];
    for i in 0..3 {
        for j in 0..3 {
            rotation[place[i]][place[j]] = about_z[i][j];
        }
    }
    Some(rotation)
}
