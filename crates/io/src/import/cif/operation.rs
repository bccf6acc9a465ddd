//! Symmetry operations as a CIF lists them, like `-y+1/2, x-y, z`, and the check that a
//! list is a space group.
//!
//! An operation is x -> R x + t in fractional coordinates, R integral with determinant
//! 1 or -1 and t modulo the lattice. A list is closed when with any two operations it has
//! their product; a finite closed list is a group.

use crate::import::atoms::decimal::{Decimal, Snapped};
use crate::import::words::short;
use acutile_exact::geometry::linear;
use malachite::base::num::arithmetic::traits::{Floor, Lcm};
use malachite::{Natural, Rational};
use std::collections::HashSet;

/// Integral 3 x 3.
pub type Rotation = [[i64; 3]; 3];

/// A list may not be longer.
pub const OPERATION_LIMIT: usize = 1000;

/// The longest text of an operation. The entries of R are sums of at most this many signs, and stay small.
const TEXT_LIMIT: usize = 200;

/// x -> R x + t.
#[derive(Clone, Debug, PartialEq)]
pub struct Operation {
    pub rotation: Rotation,
    pub translation: [Rational; 3],
    /// The decimals among the translations that were replaced: as written, and by what.
    pub replaced: Vec<(String, Rational)>,
    /// Whether a decimal is left that is a multiple of no 1/24: a rounded fraction,
    /// for space groups have none.
    pub is_rounded: bool,
}

/// An operation and the line where it stands.
pub struct Listed {
    pub operation: Operation,
    pub line: u32,
    /// As it is written.
    pub text: String,
}

impl Operation {
    /// Reads an operation; decimals are snapped where a denominator is given.
    ///
    /// # Errors
    /// The expected text.
    pub fn parse(text: &str, snap: Option<u32>) -> Result<Operation, String> {
        if text.len() > TEXT_LIMIT {
            return Err(format!("is longer than {TEXT_LIMIT} bytes"));
        }
        let parts: Vec<&str> = text.split(',').collect();
        let [a, b, c] = parts[..] else {
            return Err(format!(
                "has {} parts, expected three like x,y,z",
                parts.len()
            ));
        };
        let mut operation = Operation {
            rotation: [[0; 3]; 3],
            translation: [(); 3].map(|()| Rational::from(0)),
            replaced: Vec::new(),
            is_rounded: false,
        };
        for (row, part) in [a, b, c].into_iter().enumerate() {
            operation.read_row(row, part, snap)?;
        }
        let determinant = linear::determinant(&operation.rotation.map(|row| row.map(i128::from)));
        match determinant.abs() {
            1 => Ok(operation),
            _ => Err(format!("has determinant {determinant}, expected 1 or -1")),
        }
    }

    /// Terms like `x`, `-y`, `+1/2`.
    fn read_row(&mut self, row: usize, text: &str, snap: Option<u32>) -> Result<(), String> {
        let compact: String = text.split_ascii_whitespace().collect();
        let mut rest = compact.as_str();
        let mut first = true;
        while first || !rest.is_empty() {
            let sign = if rest.starts_with('-') { -1 } else { 1 };
            let tail = rest.strip_prefix(['-', '+']);
            if tail.is_none() && !first {
                return Err(format!("has {} in {text:?}, expected + or -", short(rest)));
            }
            rest = tail.unwrap_or(rest);
            first = false;
            let letters = ["xX", "yY", "zZ"];
            if let Some(axis) = letters
                .iter()
                .position(|l| rest.starts_with(|c| l.contains(c)))
            {
                self.rotation[row][axis] += sign;
                rest = &rest[1..];
                continue;
            }
            let end = rest
                .find(['+', '-', 'x', 'X', 'y', 'Y', 'z', 'Z'])
                .unwrap_or(rest.len());
            let (number, tail) = rest.split_at(end);
            let value = self.constant(number, snap)?;
            self.translation[row] += value * Rational::from(sign);
            rest = tail;
        }
        Ok(())
    }

    fn constant(&mut self, text: &str, snap: Option<u32>) -> Result<Rational, String> {
        let number = Decimal::parse(text)
            .map_err(|_| format!("has {}, expected x, y, z or a number like 1/2", short(text)))?;
        if let Some(Snapped::To(value)) = snap.map(|n| number.snap(n)) {
            self.replaced.push((text.to_owned(), value.clone()));
            return Ok(value);
        }
        let twenty_fourth = &number.value * Rational::from(24);
        self.is_rounded |= number.unit != 0 && *twenty_fourth.denominator_ref() != 1u32;
        Ok(number.value)
    }

    /// Whether it is the identity up to a lattice vector.
    pub fn is_identity(&self) -> bool {
        self.rotation == [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
            && self
                .translation
                .iter()
                .all(|t| *t.denominator_ref() == 1u32)
    }

    /// Whether it is the other operation up to a lattice vector.
    pub fn is_same(&self, other: &Operation) -> bool {
        let translations = self.translation.iter().zip(&other.translation);
        self.rotation == other.rotation
            && translations
                .into_iter()
                .all(|(t, u)| *(t - u).denominator_ref() == 1u32)
    }

    /// The image of a point.
    pub fn apply(&self, point: &[Rational; 3]) -> [Rational; 3] {
        std::array::from_fn(|i| {
            let mut sum = self.translation[i].clone();
            for (j, x) in point.iter().enumerate() {
                match self.rotation[i][j] {
                    0 => {}
                    n => sum += x * Rational::from(n),
                }
            }
            sum
        })
    }
}

/// x - ⌊x⌋
pub fn fractional(x: Rational) -> Rational {
    let floor = Rational::from((&x).floor());
    x - floor
}

/// Why a list of operations is no space group; the numbers are indices of the list.
#[derive(Debug, PartialEq)]
pub enum NotAGroup {
    /// The same up to lattice vectors.
    Repeated(usize, usize),
    /// The product of these is not on the list.
    Product(usize, usize),
    /// The translations have no common denominator below 2^31.
    Denominator,
}

/// Whether the list is closed, and has no operation twice.
///
/// # Errors
/// The first two operations that are against it.
pub fn check_group(operations: &[Operation]) -> Result<(), NotAGroup> {
    let modulus = modulus(operations).ok_or(NotAGroup::Denominator)?;
    let whole = |o: &Operation| {
        let t = o.translation.each_ref().map(|t| {
            let scaled = fractional(t.clone()) * Rational::from(modulus);
            // An integer between 0 and the modulus.
            i64::try_from(&scaled.floor()).unwrap_or_default()
        });
        (o.rotation, t)
    };
    let list: Vec<_> = operations.iter().map(whole).collect();
    let mut set = HashSet::new();
    for (k, element) in list.iter().enumerate() {
        if !set.insert(element) {
            let first = list.iter().position(|other| other == element);
            return Err(NotAGroup::Repeated(first.unwrap_or_default(), k));
        }
    }
    for (a, x) in list.iter().enumerate() {
        for (b, y) in list.iter().enumerate() {
            if !set.contains(&product(x, y, modulus)) {
                return Err(NotAGroup::Product(a, b));
            }
        }
    }
    Ok(())
}

/// The least common denominator of all translations, below 2^31.
fn modulus(operations: &[Operation]) -> Option<i64> {
    let mut translations = operations.iter().flat_map(|o| &o.translation);
    translations.try_fold(1i64, |modulus, t| {
        let lcm = Natural::from(modulus.unsigned_abs()).lcm(t.denominator_ref());
        i64::try_from(&lcm).ok().filter(|&m| m < 1 << 31)
    })
}

type Whole = (Rotation, [i64; 3]);

/// R (S x + u) + t = R S x + (R u + t)
fn product((r, t): &Whole, (s, u): &Whole, modulus: i64) -> Whole {
    let rotation = std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            (0..3).fold(0i64, |sum, k| {
                sum.saturating_add(r[i][k].saturating_mul(s[k][j]))
            })
        })
    });
    let translation = std::array::from_fn(|i| {
        let sum: i128 = (0..3).map(|k| i128::from(r[i][k]) * i128::from(u[k])).sum();
        (sum + i128::from(t[i])).rem_euclid(i128::from(modulus)) as i64
    });
    (rotation, translation)
}

/// The entries of Rᵀ G R and of G that differ first, if any: the operation is no
/// isometry of the lattice then.
pub fn metric_change(
    rotation: &Rotation,
    gram: &[[Rational; 3]; 3],
) -> Option<(usize, usize, Rational)> {
    let column = |j: usize| std::array::from_fn(|i| Rational::from(rotation[i][j]));
    for i in 0..3 {
        for j in i..3 {
            let found = linear::dot(&column(i), &linear::apply(gram, &column(j)));
            if found != gram[i][j] {
                return Some((i, j, found));
            }
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Operation {
        Operation::parse(text, None).expect(text)
    }

    #[test]
    fn spellings_of_one_operation() {
        let expected = read("-y+1/2,x-y,z-1/3");
        assert_eq!(expected.rotation, [[0, -1, 0], [1, -1, 0], [0, 0, 1]]);
        assert_eq!(expected.translation[2], Rational::from_signeds(-1, 3));
        for text in [
            "1/2-Y, X-Y, -1/3+Z",
            " - y + 1/2 ,+x-y, z -1/3",
            ".5-y,x-y,z-1/3",
        ] {
            let found = read(text);
            assert_eq!(
                (found.rotation, found.translation),
                (expected.rotation, expected.translation.clone()),
                "{text}"
            );
        }
        assert!(read("x+0.3333,y,z").is_rounded && !read("x+0.25,y,z").is_rounded);
        let snapped = Operation::parse("x+0.3333,y,z", Some(3)).expect("an operation");
        assert_eq!(snapped.translation[0], Rational::from_signeds(1, 3));
        assert_eq!(snapped.replaced.len(), 1);
    }

    #[test]
    fn texts_that_are_no_operations() {
        for (text, problem) in [
            ("x,y", "has 2 parts, expected three like x,y,z"),
            ("x,y,z,+1", "has 4 parts, expected three like x,y,z"),
            ("x,y,", "has \"\", expected x, y, z or a number like 1/2"),
            ("x,y,w", "has \"w\", expected x, y, z or a number like 1/2"),
            (
                "x,y,z+1/0",
                "has \"1/0\", expected x, y, z or a number like 1/2",
            ),
            ("x,y,zx", "has \"x\" in \"zx\", expected + or -"),
            (&"x+".repeat(101), "is longer than 200 bytes"),
            ("x,y,2", "has determinant 0, expected 1 or -1"),
            ("x+y,y-x,z", "has determinant 2, expected 1 or -1"),
        ] {
            assert_eq!(Operation::parse(text, None).expect_err(text), problem);
        }
    }

    #[test]
    fn lists_that_are_groups_and_lists_that_are_not() {
        let check =
            |texts: &[&str]| check_group(&texts.iter().map(|t| read(t)).collect::<Vec<_>>());
        assert_eq!(check(&["x,y,z"]), Ok(()));
        assert_eq!(check(&["x,y,z", "-x,y+1/2,-z"]), Ok(()));
        assert_eq!(check(&["-x,-y,-z"]), Err(NotAGroup::Product(0, 0)));
        assert_eq!(
            check(&["x,y,z", "-x,y+1/3,-z"]),
            Err(NotAGroup::Product(1, 1))
        );
        assert_eq!(
            check(&["x,y,z", "x+1,y,z-2"]),
            Err(NotAGroup::Repeated(0, 1))
        );
        assert_eq!(
            check(&["x,y,z", "x+0.3333333333333333,y,z"]),
            Err(NotAGroup::Denominator)
        );
    }
}
