//! Motions x -> R x + t in coordinates of a basis.

use malachite::Rational;
use malachite::base::num::arithmetic::traits::Floor;
use std::collections::BTreeSet;

/// An integral matrix.
pub type Rotation = [[i64; 3]; 3];
/// Rational coordinates.
pub type Vector = [Rational; 3];

/// The identity.
pub const IDENTITY: Rotation = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];

/// Groups have no more elements: 192 is the most of a conventional cell.
pub const GROUP_LIMIT: usize = 10_000;

/// x -> R x + t
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Motion {
    /// R, an integer matrix in the basis of the lattice.
    pub rotation: Rotation,
    /// t, in the basis of the lattice.
    pub translation: Vector,
}

impl Motion {
    /// x -> x + t
    pub fn translation(translation: Vector) -> Motion {
        Motion {
            rotation: IDENTITY,
            translation,
        }
    }

    /// The image of a point.
    pub fn apply(&self, point: &Vector) -> Vector {
        let moved = rotated(&self.rotation, point);
        std::array::from_fn(|k| &moved[k] + &self.translation[k])
    }

    /// x -> self(first(x)), with the translation reduced.
    pub fn after(&self, first: &Motion) -> Motion {
        Motion {
            rotation: product(&self.rotation, &first.rotation),
            translation: self.apply(&first.translation),
        }
        .reduced()
    }

    /// The translation moved into 0 <= t < 1.
    #[must_use]
    pub fn reduced(mut self) -> Motion {
        self.translation = self.translation.map(fractional);
        self
    }
}

/// x - ⌊x⌋
pub fn fractional(x: Rational) -> Rational {
    let floor = Rational::from((&x).floor());
    x - floor
}

/// R x
pub fn rotated(rotation: &Rotation, point: &Vector) -> Vector {
    std::array::from_fn(|i| {
        let mut sum = Rational::from(0);
        for (factor, x) in rotation[i].iter().zip(point) {
            match factor {
                0 => {}
                1 => sum += x,
                -1 => sum -= x,
                factor => sum += x * Rational::from(*factor),
            }
        }
        sum
    })
}

/// R S
pub fn product(r: &Rotation, s: &Rotation) -> Rotation {
    std::array::from_fn(|i| std::array::from_fn(|j| (0..3).map(|k| r[i][k] * s[k][j]).sum()))
}

/// All products of some motions modulo the lattice, sorted, or `None` beyond [`GROUP_LIMIT`].
pub fn closure(generators: &[Motion]) -> Option<Vec<Motion>> {
    let identity = Motion::translation([(); 3].map(|()| Rational::from(0)));
    let mut found = BTreeSet::from([identity.clone()]);
    let mut fresh = vec![identity];
    while let Some(element) = fresh.pop() {
        for generator in generators {
            let product = generator.after(&element);
            if !found.contains(&product) {
                found.insert(product.clone());
                fresh.push(product);
            }
        }
        if found.len() > GROUP_LIMIT {
            return None;
        }
    }
    Some(found.into_iter().collect())
}
