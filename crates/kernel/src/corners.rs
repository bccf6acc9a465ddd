//! The corners of the tiles of a mosaic: their angles, and the offsets of the sides around a vertex.

use crate::patch::Patch;
use crate::refusal::{Checked, Place, Stop};
use crate::ring::{Ring, each};
use crate::walls::{Side, System};
use num_integer::Integer;
use std::cmp::Ordering::{Equal, Greater, Less};

/// The numerators of the angles of each tile as parts of a turn, and the denominator for all.
pub(crate) type Angles = (Vec<Vec<u64>>, u64);

/// The most equal parts of a turn of which all angles are multiples.
const PARTS: u64 = 60;

/// The angles are parts of a turn, and the offsets of the sides close around every vertex.
pub(crate) fn check<const N: usize>(system: &System<N>) -> Checked<Angles> {
    let mut turns = Vec::new();
    for (patch, tile) in system.patches.iter().zip(0..) {
        let angles = (0..patch.classes.len()).map(|corner| system.angle(patch, tile, corner));
        turns.push(angles.collect::<Checked<Vec<_>>>()?);
    }
    let whole = turns.iter().flatten().fold(1, |whole: u64, (_, parts)| whole.lcm(parts));
    ensure!(whole <= PARTS, CornerAngle, Place::Witness, whole);
    let mut steps = Vec::new();
    for tile in 0..system.patches.len() {
        let sides: Vec<&Side<N>> = system.sides.iter().filter(|side| side.patch == tile).collect();
        let before = sides.iter().cycle().skip(sides.len().saturating_sub(1));
        for (side, before) in sides.iter().zip(before) {
            let difference = system.ring.difference(&side.offset, &before.offset)?;
            let [step, ..] = each(&difference, |x| system.ring.times(x, &system.ring.element(&[whole.into()])?))?;
            let step = some!(system.whole(&step, &system.scale), SideClasses, side.place());
            steps.push(i64::from(step));
        }
        system.work().check(Place::Tile(tile))?;
    }
    let parts: Vec<Vec<u64>> =
        turns.iter().map(|row| row.iter().map(|(a, parts)| a * (whole / parts)).collect()).collect();
    let whole_turn = i64::try_from(whole).unwrap_or(i64::MAX);
    let fits = |n: i64| {
        let expected = parts.iter().flatten().map(|a| n * i64::try_from(*a).unwrap_or(0));
        steps.iter().zip(expected).all(|(step, expected)| (step - expected).is_multiple_of(&whole_turn))
    };
    ensure!((0..whole_turn).any(fits), SideClasses, Place::Witness);
    Ok((parts, whole))
}

impl<const N: usize> System<N> {
    /// The angle at a corner as a part of a turn. The complex number z with the argument of the
    /// angle is (c, s) for c + i √g s, and g is the determinant of the base. z^n is positive after
    /// some turns; each one ends or passes at the positive real axis.
    fn angle(&self, patch: &Patch, tile: usize, corner: usize) -> Checked<(u64, u64)> {
        let ring = &self.ring;
        let count = patch.classes.len();
        let here = self.base(patch, corner)?;
        let [u, v] =
            [corner + 1, corner + count - 1].map(|other| ring.difference(&here, &self.base(patch, other % count)?));
        let (u, v) = (u?, v?);
        let [s, ..] = ring.cross(&u, &v)?;
        let c = ring.inner(&u, &self.rules.image(&v)?)?;
        let g = self.rules.base_determinant();
        let (mut power, mut turns) = ((c.clone(), s.clone()), 0);
        for n in 1..=PARTS {
            let (x, y) = &power;
            let [sign_x, sign_y] = [ring.sign(x).decided()?, ring.sign(y).decided()?];
            if (sign_x, sign_y) == (Greater, Equal) {
                return Ok((turns, n));
            }
            let square = ring.times(&ring.times(y, &s)?, &g)?;
            let next =
                (ring.minus(&ring.times(x, &c)?, &square)?, ring.plus(&ring.times(x, &s)?, &ring.times(y, &c)?)?);
            turns += u64::from(sign_y == Less && ring.sign(&next.1).is(|sign| sign != Less)?);
            power = next;
        }
        ensure!(false, CornerAngle, Place::Tile(tile), corner);
        Err(Stop::LARGER)
    }
}
