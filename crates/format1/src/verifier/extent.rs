//! Which facets of a region's boundary can meet: their extents along a few fixed
//! functionals, as ranks.
//!
//! The vertices are sorted by the exact value of each functional; equal values
//! have equal ranks. So comparing ranks is comparing values, and where all ranks
//! of some points are less than all those of others, a plane is between their convex hulls.
//! That these pairs need no look is all that this file says.

use super::Refusal;
use super::region::Triangle;
use super::ring::Element;
use super::tiling::Tiling;
use std::cmp::Ordering;

/// x_i, x_i + x_j and x_i - x_j, as coefficients.
const FUNCTIONALS: [[i8; 3]; COUNT] = [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
    [0, 1, 1],
    [1, 0, 1],
    [1, 1, 0],
    [0, 1, -1],
    [1, 0, -1],
    [1, -1, 0],
];
const COUNT: usize = 9;

/// The least and the greatest rank along each functional.
type Extent = [(u32, u32); COUNT];

pub(super) struct Extents {
    /// The ranks of each vertex; zero where it is in no triangle.
    ranks: Vec<[u32; COUNT]>,
    of_triangles: Vec<Extent>,
}

impl Extents {
    pub(super) fn new(tiling: &Tiling, triangles: &[Triangle]) -> Result<Extents, Refusal> {
        let mut used: Vec<usize> = triangles.iter().flat_map(|t| t.corners).collect();
        used.sort_unstable();
        used.dedup();
        let mut ranks = vec![[0; COUNT]; tiling.vertices.len()];
        for (f, functional) in FUNCTIONALS.iter().enumerate() {
            let at = |&vertex: &usize| value(functional, &tiling.vertices[vertex]);
            let values: Vec<Element> = used.iter().map(at).collect();
            let order = |v: usize, w: usize| compare(tiling, &values[v], &values[w]);
            let rising = sorted((0..used.len()).collect(), &order)?;
            for (k, &v) in rising.iter().enumerate().skip(1) {
                let last = rising[k - 1];
                let step = u32::from(order(last, v)? == Ordering::Less);
                ranks[used[v]][f] = ranks[used[last]][f] + step;
            }
        }
        let of_triangles = triangles.iter().map(|t| extent(&ranks, &t.corners));
        Ok(Extents {
            of_triangles: of_triangles.collect(),
            ranks,
        })
    }

    /// Some functional is less at all of `p` than at all of `q`, or the reverse.
    pub(super) fn are_apart(&self, p: &[usize], q: &[usize]) -> bool {
        are_apart(&extent(&self.ranks, p), &extent(&self.ranks, q))
    }

    /// Whether the ray from the centroid of the triangle `from` into the direction
    /// (1, ε, ε²), for small ε > 0, may meet the triangle `t`: not where all of t is
    /// behind, above, below or beside all of `from`.
    pub(super) fn may_be_ahead(&self, from: usize, t: usize) -> bool {
        let (from, t) = (&self.of_triangles[from], &self.of_triangles[t]);
        t[0].1 >= from[0].0 && overlap(t[1], from[1]) && overlap(t[2], from[2])
    }

    /// Calls `visit` for each pair of triangles whose extents overlap along all functionals.
    /// The pairs that overlap along one of them, the best one, are gone through; more
    /// than `limit` are refused.
    pub(super) fn each_close_pair(
        &self,
        limit: u64,
        mut visit: impl FnMut(usize, usize) -> Result<(), Refusal>,
    ) -> Result<(), Refusal> {
        let counts = (0..COUNT).map(|f| (self.overlaps(f), f));
        let (found, f) = counts.min().unwrap_or((0, 0));
        if found > limit {
            let of = "for the pairs of facets in the boundary";
            return Err(Refusal::Work { of, found, limit });
        }
        let mut order: Vec<usize> = (0..self.of_triangles.len()).collect();
        order.sort_by_key(|&t| self.of_triangles[t][f].0);
        let mut open: Vec<usize> = Vec::new();
        for t in order {
            let extent = &self.of_triangles[t];
            open.retain(|&u| self.of_triangles[u][f].1 >= extent[f].0);
            for &u in &open {
                if !are_apart(&self.of_triangles[u], extent) {
                    visit(u, t)?;
                }
            }
            open.push(t);
        }
        Ok(())
    }

    /// How many pairs of triangles overlap along functional f: where they stand in the
    /// order of their beginnings, the earlier ones less those that have ended.
    fn overlaps(&self, f: usize) -> u64 {
        let mut begins: Vec<u32> = self.of_triangles.iter().map(|e| e[f].0).collect();
        let mut ends: Vec<u32> = self.of_triangles.iter().map(|e| e[f].1).collect();
        begins.sort_unstable();
        ends.sort_unstable();
        let ended = |begin: u32| ends.partition_point(|&end| end < begin);
        let open = begins.iter().enumerate().map(|(i, &b)| i - ended(b));
        open.map(|n| n as u64).sum()
    }
}

fn extent(ranks: &[[u32; COUNT]], points: &[usize]) -> Extent {
    let mut extent = [(u32::MAX, 0); COUNT];
    for &point in points {
        for (range, &rank) in extent.iter_mut().zip(&ranks[point]) {
            *range = (range.0.min(rank), range.1.max(rank));
        }
    }
    extent
}

fn are_apart(p: &Extent, q: &Extent) -> bool {
    p.iter().zip(q).any(|(&p, &q)| !overlap(p, q))
}

fn overlap(p: (u32, u32), q: (u32, u32)) -> bool {
    p.0 <= q.1 && q.0 <= p.1
}

/// The functional at x.
fn value(functional: &[i8; 3], x: &[Element]) -> Element {
    let add = |sum: Element, (&c, x): (&i8, &Element)| match c {
        0 => sum,
        1 => sum.plus(x),
        _ => sum.minus(x),
    };
    functional.iter().zip(x).fold(Element::default(), add)
}

fn compare(tiling: &Tiling, x: &Element, y: &Element) -> Result<Ordering, Refusal> {
    let of = || "difference of two vertices along a functional".to_owned();
    tiling.sign(&x.clone().minus(y), &tiling.scale, of)
}

/// The items in rising order, by merging: a comparison may be refused.
fn sorted(
    mut items: Vec<usize>,
    order: &impl Fn(usize, usize) -> Result<Ordering, Refusal>,
) -> Result<Vec<usize>, Refusal> {
    if items.len() < 2 {
        return Ok(items);
    }
    let upper = sorted(items.split_off(items.len() / 2), order)?;
    let lower = sorted(items, order)?;
    let mut merged = Vec::with_capacity(lower.len() + upper.len());
    let mut upper = upper.into_iter().peekable();
    for item in lower {
        while let Some(&next) = upper.peek() {
            if order(next, item)? != Ordering::Less {
                break;
            }
            merged.push(next);
            upper.next();
        }
        merged.push(item);
    }
    merged.extend(upper);
    Ok(merged)
}
