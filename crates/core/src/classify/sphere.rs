//! Triangulated spheres up to isomorphism.
//!
//! A consistently oriented list of triangles gives each vertex the cyclic order of its neighbours. A
//! directed edge and a sense of rotation give an order of all vertices: the order in which a walk meets
//! them. The neighbour lists with these numbers are a code. An isomorphism maps directed edges to directed
//! edges and both senses of rotation to both. So two triangulated spheres are isomorphic, mirror images
//! included, exactly if their least codes agree.

use std::collections::{BTreeMap, VecDeque};

/// Three vertices in the positive sense of rotation.
pub type Triangle = [usize; 3];

/// The neighbours of vertex 0, 1, … in cyclic order, in a numbering that makes the
/// list least.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Code(Vec<Vec<usize>>);

impl Code {
    /// The number of vertices.
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The neighbours of each vertex in cyclic order.
    pub fn neighbours(&self) -> &[Vec<usize>] {
        &self.0
    }

    /// The valence of each vertex.
    pub fn valences(&self) -> impl Iterator<Item = usize> {
        self.0.iter().map(Vec::len)
    }
}

/// The canonical code of a closed surface. `None` if the triangles around some vertex do not close up to
/// one cycle, or if the surface is not connected.
pub fn code(triangles: &[Triangle]) -> Option<Code> {
    let rotation = Rotation::new(triangles)?;
    let darts = rotation.neighbours.iter().enumerate();
    darts
        .flat_map(|(from, ring)| ring.iter().map(move |&to| (from, to)))
        .flat_map(|dart| [true, false].map(|forward| rotation.code_from(dart, forward)))
        .min()
        .filter(|code| code.len() == rotation.neighbours.len())
}

/// The cyclic order of the neighbours of every vertex.
struct Rotation {
    neighbours: Vec<Vec<usize>>,
}

impl Rotation {
    fn new(triangles: &[Triangle]) -> Option<Rotation> {
        let mut next: Vec<BTreeMap<usize, usize>> = Vec::new();
        for &[a, b, c] in triangles {
            next.resize(next.len().max(a.max(b).max(c) + 1), BTreeMap::new());
            for (vertex, from, to) in [(a, b, c), (b, c, a), (c, a, b)] {
                if next[vertex].insert(from, to).is_some() {
                    return None;
                }
            }
        }
        let neighbours = next.iter().map(cycle).collect::<Option<Vec<_>>>()?;
        Some(Rotation { neighbours })
    }

    /// The code of the part that is connected with a directed edge.
    fn code_from(&self, (from, to): (usize, usize), forward: bool) -> Code {
        let mut number = vec![None; self.neighbours.len()];
        (number[from], number[to]) = (Some(0), Some(1));
        let mut waiting = VecDeque::from([(from, to), (to, from)]);
        let mut next = 2;
        let mut lists = Vec::with_capacity(number.len());
        while let Some((vertex, first)) = waiting.pop_front() {
            let mut list = self.around(vertex, first, forward);
            for entry in &mut list {
                let neighbour = *entry;
                *entry = *number[neighbour].get_or_insert_with(|| {
                    waiting.push_back((neighbour, vertex));
                    next += 1;
                    next - 1
                });
            }
            lists.push(list);
        }
        Code(lists)
    }

    /// The neighbours of a vertex, from one of them on.
    fn around(&self, vertex: usize, first: usize, forward: bool) -> Vec<usize> {
        let mut ring = self.neighbours[vertex].clone();
        if !forward {
            ring.reverse();
        }
        let start = ring.iter().position(|&n| n == first).unwrap_or(0);
        ring.rotate_left(start);
        ring
    }
}

/// The keys in the order in which `next` leads through them, if that is one cycle.
fn cycle(next: &BTreeMap<usize, usize>) -> Option<Vec<usize>> {
    let (&start, _) = next.first_key_value()?;
    let mut ring = vec![start];
    let mut at = *next.get(&start)?;
    while at != start && ring.len() <= next.len() {
        ring.push(at);
        at = *next.get(&at)?;
    }
    (ring.len() == next.len()).then_some(ring)
}
