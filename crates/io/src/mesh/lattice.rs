//! The lattice of a periodic mesh: given as numbers, or found in the file's periodic links.

use super::error::MeshError;
use super::{Mesh, Periodic};
use acutile_core::statement::counted;
use acutile_exact::geometry::linear;
use acutile_exact::number::{Number, parse_rational};
use malachite::Rational;
use malachite::base::num::basic::traits::{One, Zero};

/// One to three linearly independent vectors in Cartesian coordinates, exact.
#[derive(Clone, Debug, PartialEq)]
pub struct Lattice {
    vectors: Vec<[Rational; 3]>,
    /// Whether a vector is written with two entries.
    is_of_plane: bool,
}

/// A right-handed basis of space whose first `rank` vectors generate the lattice.
#[derive(Clone, Debug)]
pub struct Basis {
    /// The vectors in Cartesian coordinates.
    pub vectors: [[Number; 3]; 3],
    /// How many of them generate the lattice.
    pub rank: usize,
}

impl Lattice {
    /// `a1,a2,a3;b1,b2,b3;c1,c2,c3`, or fewer vectors; a vector of the plane may lack its third
    /// entry. Integers, fractions and decimals are exact as they are written.
    ///
    /// # Errors
    /// A message without the name of the option.
    pub fn parse(text: &str) -> Result<Lattice, String> {
        let vectors: Result<Vec<[Rational; 3]>, String> = text.split(';').map(vector).collect();
        let vectors = vectors?;
        if !(1..=3).contains(&vectors.len()) {
            let found = vectors.len();
            return Err(format!("found {found} vectors, expected 1 to 3"));
        }
        if !are_independent(&vectors) {
            return Err("the vectors are linearly dependent, expected independent ones".to_owned());
        }
        let is_short = |vector: &str| vector.split(',').count() == 2;
        Ok(Lattice {
            vectors,
            is_of_plane: text.split(';').any(is_short),
        })
    }

    /// Whether a vector is written with two entries, so that it is none of space.
    pub fn is_of_plane(&self) -> bool {
        self.is_of_plane
    }

    /// The lattice of a mesh's periodic links: the translations of the links between
    /// surfaces (of curves, in a plane mesh). The shortest independent ones generate it; each other
    /// one has to be an integer combination of them.
    ///
    /// # Errors
    /// Where a link is no translation, or there is no translation.
    pub fn of_links(mesh: &Mesh) -> Result<Lattice, MeshError> {
        let mut translations = Vec::new();
        let top = mesh.periodic.iter().map(|link| link.dimension).max();
        for link in mesh.periodic.iter().filter(|l| Some(l.dimension) == top) {
            translations.extend(translation(link, mesh)?);
        }
        translations.retain(|t| t.iter().any(|x| *x != 0));
        for translation in &mut translations {
            // Of a translation and its opposite one.
            if translation
                .iter()
                .find(|x| **x != 0)
                .is_some_and(|x| *x < 0)
            {
                *translation = translation.each_ref().map(|x| -x);
            }
        }
        translations.sort_by_cached_key(|t| (t.iter().map(|x| x * x).sum::<Rational>(), t.clone()));
        translations.dedup();
        let mut vectors: Vec<[Rational; 3]> = Vec::new();
        for translation in &translations {
            vectors.push(translation.clone());
            if vectors.len() > 3 || !are_independent(&vectors) {
                vectors.pop();
            }
        }
        if vectors.is_empty() {
            return Err(MeshError::of_file(
                "$Periodic gives no translation, expected one or more; --lattice gives others, \
                 --bounded reads the mesh without them",
            ));
        }
        let lattice = Lattice {
            vectors,
            is_of_plane: false,
        };
        match translations.iter().find(|t| !lattice.contains(t)) {
            None => Ok(lattice),
            Some(t) => Err(MeshError::of_file(format!(
                "the translation ({}) of $Periodic is no integer combination of the shorter ones \
                 {lattice}; give the lattice with --lattice",
                row_text(t)
            ))),
        }
    }

    /// How many vectors there are.
    pub fn rank(&self) -> usize {
        self.vectors.len()
    }

    fn contains(&self, translation: &[Rational; 3]) -> bool {
        let basis = self.basis(3);
        basis.is_ok_and(|basis| basis.generates(translation))
    }

    /// A right-handed basis whose first vectors generate the lattice: of a left-handed one the first
    /// two are exchanged, or the last is turned. Vectors beyond the lattice are orthogonal to it;
    /// for a mesh in the plane the last is (0, 0, 1).
    ///
    /// # Errors
    /// Where the lattice of a plane mesh is not in the plane.
    pub fn basis(&self, dimension: usize) -> Result<Basis, MeshError> {
        let mut vectors = self.vectors.clone();
        let rank = vectors.len();
        if dimension == 2 && (rank > 2 || vectors.iter().any(|vector| vector[2] != 0)) {
            return Err(MeshError::of_file(format!(
                "the lattice {self} is not in the plane of the triangles, expected one or two \
                 vectors with 0 as their third entry"
            )));
        }
        if rank == 1 {
            let axis = match dimension {
                2 => [Rational::ZERO, Rational::ZERO, Rational::ONE],
                _ => axis_across(&vectors[0]),
            };
            vectors.push(primitive(linear::cross(&axis, &vectors[0])));
        }
        if vectors.len() == 2 {
            vectors.push(primitive(linear::cross(&vectors[0], &vectors[1])));
        }
        let number = |x: &Rational| Number::from(x.clone());
        let mut rows: [[Number; 3]; 3] = std::array::from_fn(|i| vectors[i].each_ref().map(number));
        if dimension == 2 && rows[2][2].sign().is_lt() {
            // Turning a vector of a lattice leaves the lattice as it is.
            rows[1] = rows[1].each_ref().map(|x| -x.clone());
            rows[2] = rows[2].each_ref().map(|x| -x.clone());
        }
        if linear::determinant(&rows).sign().is_lt() {
            rows.swap(0, 1);
        }
        Ok(Basis {
            vectors: rows,
            rank,
        })
    }

    /// Those numbers that are no doubles: no node of a mesh can be an exact image by them.
    pub fn inexact(&self) -> Vec<String> {
        let entries = self.vectors.iter().flatten();
        let inexact = entries.filter(|x| {
            let double = Number::from((*x).clone()).approximate();
            Rational::try_from(double).as_ref() != Ok(*x)
        });
        let mut texts: Vec<String> = inexact.map(ToString::to_string).collect();
        texts.dedup();
        texts
    }
}

/// As `--lattice` reads it.
impl std::fmt::Display for Lattice {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        let rows: Vec<String> = self.vectors.iter().map(row_text).collect();
        write!(f, "{}", rows.join(";"))
    }
}

fn row_text(row: &[Rational; 3]) -> String {
    row.each_ref().map(ToString::to_string).join(",")
}

impl Basis {
    /// The Cartesian basis, without a lattice.
    pub fn cartesian() -> Basis {
        let entry = |is_one| {
            Number::from(if is_one {
                Rational::ONE
            } else {
                Rational::ZERO
            })
        };
        Basis {
            vectors: std::array::from_fn(|i| std::array::from_fn(|j| entry(i == j))),
            rank: 0,
        }
    }

    /// Row k gives basis coordinate k as a combination of Cartesian ones. The rows of B are the
    /// basis vectors, and C has the cofactors of B. Then x = f B, so f_k = Σ_j x_j C_kj / det B.
    ///
    /// # Errors
    /// Where the vectors are dependent, which those of a [`Lattice`] are not.
    pub fn inverse(&self) -> Result<[[Rational; 3]; 3], MeshError> {
        let determinant = linear::determinant(&self.vectors);
        let dependent = || MeshError::of_file("the lattice vectors are linearly dependent");
        let scale = determinant.inverse().ok_or_else(dependent)?;
        let rational = |x: &Number| (x * &scale).to_rational().cloned();
        let mut inverse = [const { [Rational::ZERO; 3] }; 3];
        for (row, cofactors) in inverse.iter_mut().zip(&linear::cofactors(&self.vectors)) {
            for (entry, cofactor) in row.iter_mut().zip(cofactors) {
                *entry = rational(cofactor).ok_or_else(dependent)?;
            }
        }
        Ok(inverse)
    }

    /// Whether the translation of a periodic link is in the lattice.
    pub(super) fn has_link(&self, link: &Periodic, mesh: &Mesh) -> bool {
        matches!(translation(link, mesh), Ok(Some(step)) if self.generates(&step))
    }

    /// Whether a translation is an integer combination of the lattice's vectors.
    fn generates(&self, translation: &[Rational; 3]) -> bool {
        let Ok(inverse) = self.inverse() else {
            return false;
        };
        inverse.iter().enumerate().all(|(k, row)| {
            let coefficient: Rational = row.iter().zip(translation).map(|(a, x)| a * x).sum();
            if k < self.rank {
                *coefficient.denominator_ref() == 1u32
            } else {
                coefficient == 0
            }
        })
    }

    /// The inner products of the vectors.
    pub fn gram(&self) -> [[Number; 3]; 3] {
        let vectors = &self.vectors;
        std::array::from_fn(|i| std::array::from_fn(|j| linear::dot(&vectors[i], &vectors[j])))
    }
}

fn vector(text: &str) -> Result<[Rational; 3], String> {
    let entries: Vec<&str> = text.split(',').map(str::trim).collect();
    let [a, b, c] = match entries[..] {
        [a, b] => [a, b, "0"],
        [a, b, c] => [a, b, c],
        _ => {
            return Err(format!(
                "the vector \"{}\" has {}, expected 3 with commas between",
                text.trim(),
                counted(entries.len(), "entry", "entries")
            ));
        }
    };
    let number = |text| parse_rational(text).map_err(|error| format!("\"{text}\": {error}"));
    Ok([number(a)?, number(b)?, number(c)?])
}

/// Up to three vectors: none is zero, two have a cross product, three a determinant.
fn are_independent(vectors: &[[Rational; 3]]) -> bool {
    match vectors {
        [a] => a.iter().any(|x| *x != 0),
        [a, b] => linear::cross(a, b).iter().any(|x| *x != 0),
        [a, b, c] => linear::dot(&linear::cross(a, b), c) != 0,
        _ => false,
    }
}

/// The vector divided by its entry of largest size: (0, 0, 1) for the normal of a
/// horizontal lattice, so that heights are Cartesian there.
fn primitive(vector: [Rational; 3]) -> [Rational; 3] {
    use malachite::base::num::arithmetic::traits::Abs;
    let largest = vector
        .iter()
        .map(|x| x.abs())
        .max()
        .unwrap_or(Rational::ONE);
    vector.map(|x| x / &largest)
}

/// A unit vector along the least entry, hence not parallel.
fn axis_across(vector: &[Rational; 3]) -> [Rational; 3] {
    use malachite::base::num::arithmetic::traits::Abs;
    let sizes = vector.each_ref().map(|x| x.abs());
    let least = (0..3).min_by_key(|&k| &sizes[k]).unwrap_or(0);
    std::array::from_fn(|k| Rational::from(u8::from(k == least)))
}

/// The translation of a link, from its affine map or else from its first pair of nodes.
fn translation(link: &Periodic, mesh: &Mesh) -> Result<Option<[Rational; 3]>, MeshError> {
    let exact = |x: f64| Rational::try_from(x).unwrap_or(Rational::ZERO);
    let Some(matrix) = link.affine else {
        return Ok(link.nodes.first().map(|&(image, original)| {
            let (image, original) = (mesh.points[image as usize], mesh.points[original as usize]);
            std::array::from_fn(|k| exact(image[k]) - exact(original[k]))
        }));
    };
    let is_one = |i: usize, j: usize| matrix[4 * i + j] == f64::from(u8::from(i == j));
    if !(0..3).all(|i| (0..3).all(|j| is_one(i, j))) {
        return Err(MeshError::of_file(format!(
            "the periodic link between the entities {} and {} is no translation; --lattice gives \
             the lattice, --bounded reads the mesh without it",
            link.entities.0, link.entities.1
        )));
    }
    Ok(Some(std::array::from_fn(|k| exact(matrix[4 * k + 3]))))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reads_exact_vectors() {
        let lattice = Lattice::parse("1,0,0; 1/2, 0.25 ,0;0,0,3").expect("a lattice");
        assert_eq!(lattice.to_string(), "1,0,0;1/2,1/4,0;0,0,3");
        assert!(lattice.inexact().is_empty());
        let tenth = Lattice::parse("0.1,0,0;0,0.1,0;0,0,1").expect("a lattice");
        assert_eq!(tenth.inexact(), ["1/10"]);
    }

    #[test]
    fn says_what_is_wrong_with_vectors() {
        for (text, expected) in [
            (
                "1,0,0;0,1,0;0,0,1;1,1,1",
                "found 4 vectors, expected 1 to 3",
            ),
            (
                "1;0,1",
                "the vector \"1\" has 1 entry, expected 3 with commas between",
            ),
            (
                "1,0,0;2,0,0",
                "the vectors are linearly dependent, expected independent ones",
            ),
        ] {
            assert_eq!(Lattice::parse(text), Err(expected.to_owned()));
        }
        assert!(Lattice::parse("1,0,0;0,1,0;0,0,x").is_err());
    }

    #[test]
    fn a_plane_lattice_gets_a_basis_with_the_normal_last() {
        for text in ["1,0;0,1", "0,1;1,0", "2,1", "-1,0,0", "1,1;-1,1"] {
            let lattice = Lattice::parse(text).expect("a lattice");
            let basis = lattice.basis(2).expect("a basis");
            let last: Vec<String> = basis.vectors[2].iter().map(|x| x.to_string()).collect();
            assert_eq!(last, ["0", "0", "1"], "{text}");
            assert!(linear::determinant(&basis.vectors).sign().is_gt());
        }
        let space = Lattice::parse("1,0,0;0,1,1").expect("a lattice");
        assert!(space.basis(2).is_err());
    }

    #[test]
    fn a_left_handed_lattice_gets_a_right_handed_basis() {
        for text in [
            "1,0,0;0,0,1;0,1,0",
            "0,1,0;1,0,0",
            "1,0,0;0,1,0",
            "0,0,-3",
            "1,2,3",
        ] {
            let lattice = Lattice::parse(text).expect("a lattice");
            let basis = lattice.basis(3).expect("a basis");
            assert!(linear::determinant(&basis.vectors).sign().is_gt());
        }
    }
}
