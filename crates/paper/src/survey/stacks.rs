//! The word of a stack of kagome layers, read from its combinatorics.
//!
//! In such a stack (see `kagome` of the catalogue) an edge of valence 6 goes through the middle of each
//! hexagon of a layer. It is called the *axis*. The tetrahedra around it join it to the six sides of the
//! hexagon. The triangles of the layer at these sides lie, alternately, over the next and the previous
//! registry. From the upper end of an axis the next layer is found:
//!
//! - block `z`: the upper end has two edges of valence 6, and so has the other end of the second one. The edge after
//!   these two is the axis of the next layer.
//! - block `+` or `-`: the upper end has four edges of valence 6. All of these except the axis go to the
//!   lower ends of axes of the next layer. Each is beside a side of the hexagon, and the three sides belong
//!   to the same registry.
//!
//! The steps repeat after a while, since a cell of the lattice has finitely many edges. The word that they spell is a
//! candidate: whether the tiling is that stack is decided by comparing symbols.

use super::study::Study;
use acutile_core::classify::{Ridge, Star, Wedge};
use acutile_core::tiling::{Corner, difference};
use std::collections::BTreeSet;

/// The words of stacks of kagome layers that a triangulation may be isomorphic to; almost always one or none.
pub fn candidate_words(study: &Study<3>) -> BTreeSet<String> {
    let mut words = BTreeSet::new();
    if !has_counts_of_a_stack(study) {
        return words;
    }
    let skeleton = Skeleton::of(study);
    let mut seen = BTreeSet::new();
    for ridge in six_valent(study) {
        let start = skeleton.axis(ridge.corners[0], ridge.corners[1]);
        words.extend(start.and_then(|start| word(&skeleton, start, &mut seen)));
    }
    words
}

/// A block `z` has vertices of the types 3 Z12, 2 Z14, 2 Z15, and a block `+` or `-` 4 Z12, 2 Z16.
fn has_counts_of_a_stack(study: &Study<3>) -> bool {
    let counts = study.star_counts();
    let count = |n| counts.get(&Star::FrankKasper(n)).copied().unwrap_or(0);
    let all: usize = counts.values().sum();
    let [z12, z14, z15, z16] = [12, 14, 15, 16].map(count);
    all == z12 + z14 + z15 + z16 && z14 == z15 && 2 * z12 == 3 * z14 + 4 * z16
}

/// The word from an axis upwards, in canonical form. `None` if the steps meet an axis that is already seen,
/// or do not come from a stack.
fn word(skeleton: &Skeleton, start: Axis, seen: &mut BTreeSet<Key>) -> Option<String> {
    let first = start.key();
    let mut letters = Vec::new();
    let mut axis = start;
    while seen.insert(axis.key()) {
        let (letter, next) = axis.next(skeleton)?;
        letters.push(letter);
        axis = next;
    }
    (axis.key() == first && !letters.is_empty()).then(|| canonical(&letters))
}

/// The axis of a hexagon of a layer. The sides of the hexagon begin at its corners 0, …, 5; the triangles at those of
/// even number lie over the next registry.
struct Axis {
    low: Corner<3>,
    up: Corner<3>,
    hexagon: Vec<Corner<3>>,
}

/// An axis up to lattice translation: its ends, and the sides of even number.
type Key = (Corner<3>, Corner<3>, Vec<[Corner<3>; 2]>);

impl Axis {
    fn key(&self) -> Key {
        let origin = self.low.shift;
        let moved = |corner: &Corner<3>| Corner {
            vertex: corner.vertex,
            shift: difference(corner.shift, origin),
        };
        let mut sides: Vec<[Corner<3>; 2]> = (0..6)
            .step_by(2)
            .map(|k| {
                let mut side = [moved(&self.hexagon[k]), moved(&self.hexagon[k + 1])];
                side.sort_unstable();
                side
            })
            .collect();
        sides.sort_unstable();
        (moved(&self.low), moved(&self.up), sides)
    }

    /// The next block, and the axis of a hexagon of the layer above it.
    fn next(&self, skeleton: &Skeleton) -> Option<(char, Axis)> {
        match skeleton.sixes(self.up)[..] {
            [a, b] => Some(('z', self.over_z(skeleton, other([a, b], self.low)?)?)),
            [_, _, _, _] => self.over_laves(skeleton),
            _ => None,
        }
    }

    /// Side 0 lies below a vertex at mid-height, and above this vertex lies the side 0 of the next hexagon.
    fn over_z(&self, skeleton: &Skeleton, middle: Corner<3>) -> Option<Axis> {
        let &[a, b] = &skeleton.sixes(middle)[..] else {
            return None;
        };
        let next = skeleton.axis(middle, other([a, b], self.up)?)?;
        let over_side = skeleton.link(self.hexagon[0], self.hexagon[1])?;
        let apex = beside(&over_side, self.up)?
            .into_iter()
            .find(|corner| *corner != self.low)?;
        let side = next.side_in(&skeleton.link(middle, apex)?)?;
        Some(next.turned(side))
    }

    fn over_laves(&self, skeleton: &Skeleton) -> Option<(char, Axis)> {
        let low = skeleton
            .sixes(self.up)
            .into_iter()
            .find(|corner| *corner != self.low)?;
        let around = skeleton.link(self.up, low)?;
        let side = self.side_in(&around)?;
        // The other edges of valence 6 at the lower end lead down beside the hexagon.
        let mut ups = skeleton.sixes(low);
        ups.retain(|up| {
            let link = skeleton.link(low, *up).unwrap_or_default();
            !self.hexagon.iter().any(|corner| link.contains(corner))
        });
        let &[up] = &ups[..] else {
            return None;
        };
        let next = skeleton.axis(low, up)?;
        // Seen from above, the old axis stands over the registry that the step came from.
        let back = next.side_in(&around)?;
        match side % 2 {
            0 => Some(('+', next.turned(back + 1))),
            _ => Some(('-', next.turned(back))),
        }
    }

    /// The first side of the hexagon that belongs to a link.
    fn side_in(&self, link: &[Corner<3>]) -> Option<usize> {
        (0..6).find(|&k| {
            let side = [self.hexagon[k], self.hexagon[(k + 1) % 6]];
            side.iter().all(|corner| link.contains(corner))
        })
    }

    /// The axis whose side 0 is this side.
    fn turned(mut self, side: usize) -> Axis {
        self.hexagon.rotate_left(side % 6);
        self
    }
}

/// The one of two corners that is not the given one; `None` if both are other ones.
fn other([a, b]: [Corner<3>; 2], given: Corner<3>) -> Option<Corner<3>> {
    match (a == given, b == given) {
        (true, false) => Some(b),
        (false, true) => Some(a),
        _ => None,
    }
}

/// The two neighbours of a corner in a cycle.
fn beside(cycle: &[Corner<3>], corner: Corner<3>) -> Option<[Corner<3>; 2]> {
    let place = cycle.iter().position(|other| *other == corner)?;
    let n = cycle.len();
    Some([cycle[(place + n - 1) % n], cycle[(place + 1) % n]])
}

fn six_valent(study: &Study<3>) -> impl Iterator<Item = &Ridge<3>> {
    study
        .ridges
        .list
        .iter()
        .filter(|ridge| ridge.valence() == 6)
}

/// The edges of valence 6 of a triangulation, by vertex.
struct Skeleton<'a> {
    study: &'a Study<3>,
    /// For each vertex the other ends of its edges of valence 6.
    ends: Vec<Vec<Corner<3>>>,
}

impl<'a> Skeleton<'a> {
    fn of(study: &'a Study<3>) -> Self {
        let mut ends = vec![Vec::new(); study.tiling.vertices.len()];
        for ridge in six_valent(study) {
            let [a, b] = [ridge.corners[0], ridge.corners[1]];
            ends[a.vertex.index()].push(b.moved(difference([0; 3], a.shift)));
            ends[b.vertex.index()].push(a.moved(difference([0; 3], b.shift)));
        }
        Skeleton { study, ends }
    }

    /// The other ends of the edges of valence 6 at a corner.
    fn sixes(&self, corner: Corner<3>) -> Vec<Corner<3>> {
        let ends = self.ends[corner.vertex.index()].iter();
        ends.map(|end| end.moved(corner.shift)).collect()
    }

    fn axis(&self, low: Corner<3>, up: Corner<3>) -> Option<Axis> {
        let hexagon = self.link(low, up)?;
        (hexagon.len() == 6).then_some(Axis { low, up, hexagon })
    }

    /// The cycle of corners around an edge.
    fn link(&self, a: Corner<3>, b: Corner<3>) -> Option<Vec<Corner<3>>> {
        let mut ends = [a, b];
        ends.sort_unstable();
        let origin = ends[0].shift;
        let form = ends.map(|end| end.moved(difference([0; 3], origin)));
        let list = &self.study.ridges.list;
        let place = list
            .binary_search_by(|ridge| ridge.corners[..].cmp(&form))
            .ok()?;
        let sides = list[place]
            .around
            .iter()
            .map(|wedge| self.opposite(*wedge, origin));
        cycle(sides.collect::<Option<_>>()?)
    }

    /// The edge opposite to the one around which a wedge lies, where the first end of the latter has this shift.
    fn opposite(&self, (simplex, (i, j)): Wedge, origin: [i32; 3]) -> Option<[Corner<3>; 2]> {
        let corners = self.study.tiling.simplex(simplex);
        let ends = (0..4).filter(|k| *k != i && *k != j).map(|k| corners[k]);
        let by = difference(origin, ends.min()?.shift);
        Some([corners[i].moved(by), corners[j].moved(by)])
    }
}

/// The cycle that these edges make.
fn cycle(mut edges: Vec<[Corner<3>; 2]>) -> Option<Vec<Corner<3>>> {
    let [first, mut last] = edges.pop()?;
    let mut cycle = vec![first];
    while last != first {
        cycle.push(last);
        let place = edges.iter().position(|edge| edge.contains(&last))?;
        last = other(edges.swap_remove(place), last)?;
    }
    edges.is_empty().then_some(cycle)
}

/// A word up to what does not change the stack: repeating it, another first letter, upside down, a mirror image.
fn canonical(letters: &[char]) -> String {
    let n = letters.len();
    let period =
        (1..=n).find(|&p| n.is_multiple_of(p) && (p..n).all(|k| letters[k] == letters[k - p]));
    let word = &letters[..period.unwrap_or(n)];
    let upside_down: Vec<char> = word.iter().rev().copied().collect();
    let mirrored = |word: &[char]| word.iter().map(|letter| mirror(*letter)).collect();
    let images: [Vec<char>; 4] = [
        word.to_vec(),
        mirrored(word),
        mirrored(&upside_down),
        upside_down,
    ];
    let rotations = images
        .iter()
        .flat_map(|word| (0..word.len()).map(|k| [&word[k..], &word[..k]].concat()));
    let least =
        rotations.min_by_key(|word| word.iter().map(|letter| order(*letter)).collect::<Vec<_>>());
    least.unwrap_or_default().into_iter().collect()
}

fn mirror(letter: char) -> char {
    match letter {
        '+' => '-',
        '-' => '+',
        other => other,
    }
}

/// `z` before `+` before `-`, as the words of the catalogue are written.
fn order(letter: char) -> usize {
    "z+-".find(letter).unwrap_or(3)
}
