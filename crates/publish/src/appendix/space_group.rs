//! The type of the group as a space group, and the Wyckoff letters of the vertices.
//!
//! The tables are those of `acutile-crystal`. They only propose: the change to the standard setting is checked exactly there. A Gram
//! matrix with irrational entries is rounded for the proposal, which the check does not use.

use super::numeral::Numerals;
use super::orbits::Orbits;
use acutile_core::classify::Isometry;
use acutile_core::tiling::{Tiling, VertexId};
use acutile_crystal::identify::{Identified, identify};
use acutile_crystal::motion::{Motion, Rotation, Vector, rotated};
use acutile_crystal::wyckoff::wyckoff_of_parts;
use acutile_exact::number::Number;
use malachite::Rational;
use std::collections::HashMap;

/// A group with its type.
pub struct SpaceGroup {
    identified: Identified,
    /// `6c` for each vertex; none where the tables do not tell.
    pub letters: Vec<Option<String>>,
}

impl SpaceGroup {
    /// The type of the group of a tiling of space. `None` in the plane, in other domains, in fields of
    /// higher degree and for a lattice alone. Also `None` if the tables have no such type.
    ///
    /// The polynomial of a field of higher degree may be reducible, and then powers of its root may depend on each other.
    pub fn of<const D: usize>(
        tiling: &Tiling<D>,
        orbits: &Orbits<D>,
        numerals: &Numerals,
    ) -> Option<SpaceGroup> {
        let has_group = orbits.elements.len() > 1;
        if !has_group || tiling.frame.rank() != 3 || matches!(numerals, Numerals::Powers) {
            return None;
        }
        let (group, origin) = with_rational_translations(&orbits.elements, numerals)?;
        let gram = array(
            tiling
                .frame
                .gram
                .iter()
                .map(|row| array(row.iter().map(near))),
        )?;
        let identified = identify(&group, &gram)?;
        let letters = letters(tiling, orbits, numerals, &identified, &origin);
        Some(SpaceGroup {
            identified,
            letters,
        })
    }

    /// `$P4_2/mnm$ (number 136)`
    pub fn name(&self) -> String {
        let setting = self.identified.setting;
        format!("${}$ (number ${}$)", symbol(&setting.short), setting.number)
    }
}

/// Vertices that are images of one corner have one letter.
fn letters<const D: usize>(
    tiling: &Tiling<D>,
    orbits: &Orbits<D>,
    numerals: &Numerals,
    identified: &Identified,
    origin: &[Vector; 2],
) -> Vec<Option<String>> {
    let mut known: HashMap<(usize, usize), Option<String>> = HashMap::new();
    let letter = |vertex: usize| {
        let parts = parts(numerals, &tiling.vertices.vertex(VertexId::at(vertex)));
        let parts: [Vector; 2] = std::array::from_fn(|k| difference(&parts[k], &origin[k]));
        let found = wyckoff_of_parts(identified, &parts)?;
        Some(format!("{}{}", found.multiplicity, found.letter))
    };
    let vertices = 0..tiling.vertices.len();
    let letters = vertices.map(|vertex| {
        let origin = orbits.vertices[vertex].as_ref()?;
        let key = (origin.representative, origin.corner);
        known.entry(key).or_insert_with(|| letter(vertex)).clone()
    });
    letters.collect()
}

/// The group about an origin where its translations are rational, and p and q of this origin p + q √d.
///
/// Here p = 0. Lattice vectors are rational, so the group acts on the coefficients of √d exactly, and not only modulo the lattice.
/// There the mean of the images of zero is a fixed point, because the group is finite.
fn with_rational_translations<const D: usize>(
    elements: &[Isometry<D>],
    numerals: &Numerals,
) -> Option<(Vec<Motion>, [Vector; 2])> {
    let translations: Vec<[Vector; 2]> = elements
        .iter()
        .map(|element| parts(numerals, &element.translation))
        .collect();
    let count = Rational::from(elements.len());
    let fixed: Vector = std::array::from_fn(|k| {
        let sum: Rational = translations.iter().map(|[_, root]| &root[k]).sum();
        sum / &count
    });
    let motion = |(element, [rational, root]): (&Isometry<D>, &[Vector; 2])| {
        let rotation = rotation(element)?;
        let is_fixed = difference(&fixed, &rotated(&rotation, &fixed)) == *root;
        let translation = rational.clone();
        let motion = Motion {
            rotation,
            translation,
        };
        is_fixed.then(|| motion.reduced())
    };
    let group = elements.iter().zip(&translations).map(motion);
    let zero = std::array::from_fn(|_| Rational::from(0));
    Some((group.collect::<Option<_>>()?, [zero, fixed]))
}

fn rotation<const D: usize>(element: &Isometry<D>) -> Option<Rotation> {
    let integer = |x: &Number| i64::try_from(x.to_rational()?).ok();
    let rows = element.linear.iter();
    array(rows.map(|row| array(row.iter().map(integer))))
}

/// p and q of a point p + q √d.
fn parts<const D: usize>(numerals: &Numerals, point: &[Number; D]) -> [Vector; 2] {
    let coefficients: Vec<Vec<Rational>> = point.iter().map(|x| numerals.coefficients(x)).collect();
    let entry = |i: usize, k: usize| coefficients[i].get(k).cloned().unwrap_or_default();
    std::array::from_fn(|k| std::array::from_fn(|i| entry(i, k)))
}

fn difference(a: &Vector, b: &Vector) -> Vector {
    std::array::from_fn(|k| a[k].clone() - &b[k])
}

/// A rational number near this one.
fn near(x: &Number) -> Option<Rational> {
    Some(
        x.enclosure(&Rational::from_signeds(1, 1_000_000_000_000_000i64))
            .0,
    )
}

fn array<T>(entries: impl Iterator<Item = Option<T>>) -> Option<[T; 3]> {
    let entries: Vec<T> = entries.collect::<Option<_>>()?;
    entries.try_into().ok()
}

/// `P 42/m n m` as `P4_2/mnm`, `P m -3 n` as `Pm\bar{3}n`.
fn symbol(short: &str) -> String {
    let mut text = String::new();
    for token in short.split(' ') {
        let mut letters = token.chars().peekable();
        while let Some(letter) = letters.next() {
            match (letter, letters.peek().copied()) {
                ('-', Some(next)) => {
                    letters.next();
                    text.push_str(&format!("\\bar{{{next}}}"));
                }
                // Two digits without a blank between them are a screw axis.
                ('0'..='9', Some(screw @ '0'..='9')) => {
                    letters.next();
                    text.push_str(&format!("{letter}_{{{screw}}}"));
                }
                _ => text.push(letter),
            }
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use acutile_catalog::build;
    use acutile_core::classify::Symmetry;
    use acutile_core::quality::squared_edges;
    use acutile_core::tiling::{AnyTiling, match_facets};
    use std::collections::BTreeSet;

    /// The structures as the databases of crystals have them. In sigma and mu no translation of the group is rational about the
    /// origin of the construction.
    #[test]
    fn groups_and_letters_are_those_of_the_literature() {
        let cases = [
            ("a15", "$Pm\\bar{3}n$ (number $223$)", "2a 6c"),
            ("c15", "$Fd\\bar{3}m$ (number $227$)", "16d 8a"),
            ("c14", "$P6_{3}/mmc$ (number $194$)", "2a 4f 6h"),
            ("bcc", "$Im\\bar{3}m$ (number $229$)", "2a"),
            ("c36", "$P6_{3}/mmc$ (number $194$)", "4e 4f 6g 6h"),
            ("sigma", "$P4_{2}/mnm$ (number $136$)", "2a 4f 8i 8j"),
            ("mu", "$R\\bar{3}m$ (number $166$)", "18h 3a 6c"),
        ];
        for (name, group, letters) in cases {
            let Ok(AnyTiling::Space(tiling)) = build(name) else {
                panic!("{name}");
            };
            let matching = match_facets(&tiling);
            let edges: Vec<_> = tiling
                .indices()
                .map(|s| squared_edges(&tiling, s))
                .collect();
            let orbits = Orbits::of(&tiling, &Symmetry::of(&tiling, &matching, &edges));
            let numerals = Numerals::of(&tiling.frame.field);
            let found = SpaceGroup::of(&tiling, &orbits, &numerals).expect(name);
            assert_eq!(found.name(), group, "{name}");
            let all: BTreeSet<String> = found.letters.into_iter().flatten().collect();
            let all: Vec<String> = all.into_iter().collect();
            assert_eq!(all.join(" "), letters, "{name}");
        }
    }
}
