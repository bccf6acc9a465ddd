//! Changes of basis after Hall symbols: a shift of the origin in twelfths, `(0 0 -1)`, or three rows like
//! `(x-y,x+y,z+1/4)`.
//!
//! With V = x -> M x + v, a motion S becomes V S V^-1 (International Tables B, A1.4.2.3). The lattice L
//! becomes M L. It must contain the integral vectors, which are the lattice of the new cell.

use crate::motion::{Motion, Rotation, Vector, closure, fractional, rotated};
use malachite::Rational;

/// x -> M x + v
pub struct Change {
    matrix: [Vector; 3],
    inverse: [Vector; 3],
    shift: Vector,
}

impl Change {
    /// The inside of the parentheses.
    ///
    /// # Errors
    /// The problem.
    pub fn parse(text: &str) -> Result<Change, String> {
        let wrong = || {
            format!(
                "has ({text}), expected a shift of the origin like (0 0 -1), in twelfths, or a change \
                 of basis like (x-y,x+y,z)"
            )
        };
        let words: Vec<&str> = text.split_ascii_whitespace().collect();
        let (matrix, shift) = match words[..] {
            [x, y, z] if !text.contains(',') => {
                let twelfths =
                    |word: &str| word.parse().map(|n: i32| Rational::from_signeds(n, 12));
                let shift = [twelfths(x), twelfths(y), twelfths(z)].map(|n| n.map_err(|_| wrong()));
                let [x, y, z] = shift;
                (identity(), [x?, y?, z?])
            }
            _ => rows(text).ok_or_else(wrong)?,
        };
        let inverse = inverse(&matrix).ok_or_else(wrong)?;
        Ok(Change {
            matrix,
            inverse,
            shift,
        })
    }

    /// The motions that generate the group in the new basis.
    ///
    /// # Errors
    /// The new basis does not fit the group.
    pub fn apply(&self, motions: &[Motion]) -> Result<Vec<Motion>, String> {
        let group = closure(motions).ok_or("generates no space group")?;
        for j in 0..3 {
            let old = self
                .inverse
                .each_ref()
                .map(|row| fractional(row[j].clone()));
            if !group.contains(&Motion::translation(old)) {
                return Err(
                    "has a change of basis whose basis vectors are no lattice vectors".to_owned(),
                );
            }
        }
        let translations = (0..3).map(|j| {
            let column = self.matrix.each_ref().map(|row| row[j].clone());
            Ok(Motion::translation(column).reduced())
        });
        let images = group.iter().map(|motion| self.image(motion));
        images.chain(translations).collect()
    }

    /// V S V^-1: R becomes M R M^-1, and t becomes M t + v - M R M^-1 v.
    fn image(&self, motion: &Motion) -> Result<Motion, String> {
        let rational = motion.rotation.map(|row| row.map(Rational::from));
        let product = times(&times(&self.matrix, &rational), &self.inverse);
        let mut rotation: Rotation = [[0; 3]; 3];
        for (row, entries) in rotation.iter_mut().zip(&product) {
            for (entry, value) in row.iter_mut().zip(entries) {
                *entry = i64::try_from(value).map_err(|_| {
                    "has a change of basis after which an operation is not integral".to_owned()
                })?;
            }
        }
        let turned = rotated(&rotation, &self.shift);
        let translation = std::array::from_fn(|k| {
            let moved = dot(&self.matrix[k], &motion.translation);
            moved + &self.shift[k] - &turned[k]
        });
        Ok(Motion {
            rotation,
            translation,
        })
    }
}

fn identity() -> [Vector; 3] {
    std::array::from_fn(|i| std::array::from_fn(|j| Rational::from(u8::from(i == j))))
}

/// Three sums of terms like `x`, `-1/2*y`, `z/2` and `1/4`.
fn rows(text: &str) -> Option<([Vector; 3], Vector)> {
    let parts: Vec<String> = text
        .split(',')
        .map(|part| part.split_ascii_whitespace().collect())
        .collect();
    let [x, y, z] = &parts[..] else {
        return None;
    };
    let [x, y, z] = [row(x)?, row(y)?, row(z)?];
    Some(([x.0, y.0, z.0], [x.1, y.1, z.1]))
}

fn row(text: &str) -> Option<(Vector, Rational)> {
    let zero = || Rational::from(0);
    let (mut factors, mut constant) = ([zero(), zero(), zero()], zero());
    let mut rest = text;
    while !rest.is_empty() {
        let is_negative = rest.starts_with('-');
        let is_first = rest.len() == text.len();
        let unsigned = rest.strip_prefix(['-', '+']);
        rest = match unsigned {
            Some(unsigned) => unsigned,
            None if is_first => rest,
            None => return None,
        };
        let end = rest.find(['-', '+']).unwrap_or(rest.len());
        let (axis, size) = term(&rest[..end])?;
        let signed = if is_negative { -size } else { size };
        match axis {
            Some(axis) => factors[axis] += signed,
            None => constant += signed,
        }
        rest = &rest[end..];
    }
    (!text.is_empty()).then_some((factors, constant))
}

/// The axis of a term without its sign, and its factor.
fn term(text: &str) -> Option<(Option<usize>, Rational)> {
    let Some(at) = text.find(['x', 'y', 'z']) else {
        return Some((None, quotient(text)?));
    };
    let axis = "xyz".find(&text[at..=at]);
    let before = text[..at].strip_suffix('*').unwrap_or(&text[..at]);
    let factor = match before {
        "" => Rational::from(1),
        before => quotient(before)?,
    };
    let divisor = match &text[at + 1..] {
        "" => Rational::from(1),
        after => quotient(after.strip_prefix('/')?)?,
    };
    (divisor != 0).then(|| (axis, factor / divisor))
}

/// `3`, `1/2` or `0.25`, of few digits.
fn quotient(text: &str) -> Option<Rational> {
    const DIGITS: usize = 12;
    let is_plain = |c: char| c.is_ascii_digit() || matches!(c, '/' | '.');
    if text.len() > DIGITS || !text.chars().all(is_plain) {
        return None;
    }
    if let Some((whole, decimals)) = text.split_once('.') {
        let digits: u64 = format!("{whole}{decimals}").parse().ok()?;
        let scale = 10u64.checked_pow(u32::try_from(decimals.len()).ok()?)?;
        return Some(Rational::from_unsigneds(digits, scale));
    }
    let (numerator, denominator) = text.split_once('/').unwrap_or((text, "1"));
    let denominator: u64 = denominator.parse().ok().filter(|d| *d > 0)?;
    Some(Rational::from_unsigneds(
        numerator.parse::<u64>().ok()?,
        denominator,
    ))
}

fn dot(x: &Vector, y: &Vector) -> Rational {
    x.iter().zip(y).map(|(x, y)| x * y).sum()
}

fn times(m: &[Vector; 3], n: &[Vector; 3]) -> [Vector; 3] {
    std::array::from_fn(|i| std::array::from_fn(|j| (0..3).map(|k| &m[i][k] * &n[k][j]).sum()))
}

/// The inverse, by cofactors.
fn inverse(m: &[Vector; 3]) -> Option<[Vector; 3]> {
    let cofactor = |i: usize, j: usize| {
        let [a, b] = [(i + 1) % 3, (i + 2) % 3];
        let [c, d] = [(j + 1) % 3, (j + 2) % 3];
        &m[a][c] * &m[b][d] - &m[a][d] * &m[b][c]
    };
    let determinant: Rational = (0..3).map(|j| &m[0][j] * cofactor(0, j)).sum();
    (determinant != 0)
        .then(|| std::array::from_fn(|i| std::array::from_fn(|j| cofactor(j, i) / &determinant)))
}
