//! Finds the points, moved by lattice vectors, that lie in a ball. It is a k-d tree over the points of one
//! cell, with one query for every lattice vector that the ball may need.
//!
//! The answer may hold points a little outside of the ball, never lacks one inside.

use super::DelaunayError;
use super::places::Places;
use crate::tiling::Corner;
use acutile_exact::geometry::linear::dot;

/// No query looks at more translated cells.
const SHIFTS_LIMIT: f64 = 1e6;
/// Leaves hold at most this many points.
const LEAF: usize = 8;

/// A k-d tree over points that are stored in the order of the tree.
#[derive(Clone, Debug)]
pub struct Tree<const D: usize> {
    /// The box around all points.
    hull: Extent<D>,
    /// The children of node i are 2 i + 1 and 2 i + 2.
    splits: Vec<Split>,
    len: usize,
}

/// How the two halves of a node lie along one axis: where the first ends and where
/// the second begins. Two comparisons decide which of them a window may meet.
#[derive(Clone, Copy, Debug, Default)]
struct Split {
    axis: usize,
    end: f64,
    begin: f64,
}

#[derive(Clone, Copy, Debug)]
struct Extent<const D: usize> {
    low: [f64; D],
    high: [f64; D],
}

/// A ball, in Cartesian coordinates relative to a corner.
#[derive(Clone, Copy, Debug)]
pub struct Ball<const D: usize> {
    pub center: [f64; D],
    pub radius: f64,
}

/// A permutation of `fractions` in which neighbours are close together. Points are stored in this order
/// before the tree is made. The points are halved at the median of the longest side.
pub fn tree_order<const D: usize>(fractions: &[[f64; D]], lengths: &[f64; D]) -> Vec<u32> {
    let mut order: Vec<u32> = (0..fractions.len() as u32).collect();
    halve(&mut order, fractions, lengths);
    order
}

fn halve<const D: usize>(order: &mut [u32], fractions: &[[f64; D]], lengths: &[f64; D]) {
    if order.len() <= LEAF {
        return;
    }
    let hull = Extent::around(order.iter().map(|&i| &fractions[i as usize]));
    let side = |k: usize| (hull.high[k] - hull.low[k]) * lengths[k];
    let axis = (0..D)
        .max_by(|&a, &b| side(a).total_cmp(&side(b)))
        .unwrap_or(0);
    let middle = order.len() / 2;
    order.select_nth_unstable_by(middle, |&a, &b| {
        fractions[a as usize][axis]
            .total_cmp(&fractions[b as usize][axis])
            .then(a.cmp(&b))
    });
    let (left, right) = order.split_at_mut(middle);
    halve(left, fractions, lengths);
    halve(right, fractions, lengths);
}

impl<const D: usize> Extent<D> {
    fn around<'a>(points: impl Iterator<Item = &'a [f64; D]>) -> Self {
        let mut hull = Extent {
            low: [f64::INFINITY; D],
            high: [f64::NEG_INFINITY; D],
        };
        for point in points {
            hull.low = std::array::from_fn(|k| hull.low[k].min(point[k]));
            hull.high = std::array::from_fn(|k| hull.high[k].max(point[k]));
        }
        hull
    }

    fn meets(&self, other: &Self) -> bool {
        (0..D).all(|k| self.low[k] <= other.high[k] && other.low[k] <= self.high[k])
    }

    fn union(self, other: Self) -> Self {
        Extent {
            low: std::array::from_fn(|k| self.low[k].min(other.low[k])),
            high: std::array::from_fn(|k| self.high[k].max(other.high[k])),
        }
    }
}

impl Split {
    /// Along the axis that separates the halves best. (Any axis would be right.)
    fn between<const D: usize>(left: &Extent<D>, right: &Extent<D>) -> Self {
        let gap = |k: usize| right.low[k] - left.high[k];
        let axis = (0..D)
            .max_by(|&a, &b| gap(a).total_cmp(&gap(b)))
            .unwrap_or(0);
        Split {
            axis,
            end: left.high[axis],
            begin: right.low[axis],
        }
    }
}

/// The data that a query carries down the tree.
struct Query<'a, const D: usize> {
    places: &'a [[f64; D]],
    window: Extent<D>,
    /// The centre of the ball, moved so that the cell that is searched has shift zero.
    center: [f64; D],
    square: f64,
    /// The shift of the corners of that cell.
    shift: [i32; D],
    found: &'a mut Vec<Corner<D>>,
}

impl<const D: usize> Tree<D> {
    /// The tree over the first `len` of the points, which are in tree order.
    pub fn new(places: &Places<D>, len: usize) -> Self {
        let mut tree = Tree {
            hull: Extent::around([].into_iter()),
            splits: Vec::new(),
            len,
        };
        tree.hull = tree.build(0, 0..len, &places.fractions);
        tree
    }

    fn build(
        &mut self,
        node: usize,
        range: std::ops::Range<usize>,
        fractions: &[[f64; D]],
    ) -> Extent<D> {
        if range.len() <= LEAF {
            return Extent::around(fractions[range].iter());
        }
        if self.splits.len() <= node {
            self.splits.resize(node + 1, Split::default());
        }
        let middle = range.start + range.len() / 2;
        let left = self.build(2 * node + 1, range.start..middle, fractions);
        let right = self.build(2 * node + 2, middle..range.end, fractions);
        self.splits[node] = Split::between(&left, &right);
        left.union(right)
    }

    /// Puts all corners in the ball around `origin` + centre into `found`, at least
    /// those; stops early once there are `enough`.
    pub fn gather(
        &self,
        places: &Places<D>,
        origin: &Corner<D>,
        ball: Ball<D>,
        enough: usize,
        found: &mut Vec<Corner<D>>,
    ) -> Result<(), DelaunayError> {
        found.clear();
        let window = window(places, origin, &ball);
        let first = window.low.map(f64::floor);
        let last = window.high.map(f64::floor);
        let count: f64 = (0..D).map(|k| last[k] - first[k] + 1.0).product();
        let is_far = |x: &f64| x.is_nan() || x.abs() > 1e9;
        if count.is_nan() || count > SHIFTS_LIMIT || first.iter().any(is_far) {
            return Err(DelaunayError::TooElongated);
        }
        let base = &places.places[origin.vertex.index()];
        let center: [f64; D] = std::array::from_fn(|k| base[k] + ball.center[k]);
        let mut shift = first.map(|x| x as i32);
        loop {
            let step = shift.map(f64::from);
            let moved = places.to_cartesian(&step);
            let mut query = Query {
                places: &places.places,
                window: Extent {
                    low: std::array::from_fn(|k| window.low[k] - step[k]),
                    high: std::array::from_fn(|k| window.high[k] - step[k]),
                },
                center: std::array::from_fn(|k| center[k] - moved[k]),
                square: ball.radius * ball.radius,
                shift: std::array::from_fn(|k| origin.shift[k] + shift[k]),
                found: &mut *found,
            };
            if query.window.meets(&self.hull) {
                self.visit(0, 0..self.len, &mut query);
            }
            if found.len() >= enough || !advance(&mut shift, &first, &last) {
                return Ok(());
            }
        }
    }

    fn visit(&self, node: usize, range: std::ops::Range<usize>, query: &mut Query<D>) {
        if range.len() <= LEAF {
            return query.test(range);
        }
        let split = &self.splits[node];
        let middle = range.start + range.len() / 2;
        if query.window.low[split.axis] <= split.end {
            self.visit(2 * node + 1, range.start..middle, query);
        }
        if query.window.high[split.axis] >= split.begin {
            self.visit(2 * node + 2, middle..range.end, query);
        }
    }
}

impl<const D: usize> Query<'_, D> {
    /// The callers' slack is larger than the rounding here, see `places`.
    fn test(&mut self, leaf: std::ops::Range<usize>) {
        for (place, vertex) in self.places[leaf.clone()].iter().zip(leaf.start as u32..) {
            let x: [f64; D] = std::array::from_fn(|k| place[k] - self.center[k]);
            if dot(&x, &x) <= self.square {
                self.found.push(Corner {
                    vertex: vertex.into(),
                    shift: self.shift,
                });
            }
        }
    }
}

/// The box around a ball in fractional coordinates, a little enlarged, where the origin
/// has shift zero.
fn window<const D: usize>(places: &Places<D>, origin: &Corner<D>, ball: &Ball<D>) -> Extent<D> {
    let center = places.to_fractional(&ball.center);
    let base = &places.fractions[origin.vertex.index()];
    let size = dot(&ball.center, &ball.center).sqrt() + ball.radius;
    let half: [f64; D] =
        std::array::from_fn(|k| places.dual[k] * (ball.radius + 1e-9 * size) + 1e-9);
    let middle: [f64; D] = std::array::from_fn(|k| base[k] + center[k]);
    Extent {
        low: std::array::from_fn(|k| middle[k] - half[k]),
        high: std::array::from_fn(|k| middle[k] + half[k]),
    }
}

/// The next integer vector between `first` and `last`, or false at the end.
fn advance<const D: usize>(shift: &mut [i32; D], first: &[f64; D], last: &[f64; D]) -> bool {
    for k in 0..D {
        if f64::from(shift[k]) < last[k] {
            shift[k] += 1;
            return true;
        }
        shift[k] = first[k] as i32;
    }
    false
}
