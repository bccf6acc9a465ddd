//! Random exact tetrahedra from a fixed seed, for properties that are tested beside their
//! proof. Coordinates are small integers, so that right angles, on which properties
//! turn, come up by themselves.

use super::identity::{Vector, cross, dot, minus};

/// How many tetrahedra a property is tested on.
pub const SAMPLES: usize = 4000;

/// Numbers from a seed (Steele, Lea, Flood, Fast splittable pseudorandom number generators,
/// OOPSLA 2014).
struct SplitMix(u64);

impl SplitMix {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn coordinate(&mut self, bound: i128) -> i128 {
        i128::from(self.next()) % (2 * bound + 1) - bound
    }
}

/// Tetrahedra a, b, c, d of positive volume. Every second one is a regular one moved a
/// little, so that enough are acute.
pub fn tetrahedra() -> impl Iterator<Item = [Vector; 4]> {
    const REGULAR: [Vector; 4] = [[4, 4, 4], [4, -4, -4], [-4, -4, 4], [-4, 4, -4]];
    let mut random = SplitMix(0x5eed);
    let mut count = 0usize;
    std::iter::from_fn(move || {
        count += 1;
        let near_regular = count.is_multiple_of(2);
        Some(std::array::from_fn(|k| {
            std::array::from_fn(|i| {
                if near_regular {
                    REGULAR[k][i] + random.coordinate(2)
                } else {
                    random.coordinate(5)
                }
            })
        }))
    })
    .filter(|t| volume(t) > 0)
    .take(SAMPLES)
}

/// Six times the signed volume.
pub fn volume([a, b, c, d]: &[Vector; 4]) -> i128 {
    dot(minus(*b, *a), cross(minus(*c, *a), minus(*d, *a)))
}
