//! Triangulated spheres with degrees 5 and 6 in which no two vertices of degree 6 are adjacent.
//!
//! The search of [`acutile_core::classify::frank_kasper`] finds all of them. Theorem 3 uses that the
//! two sixes of the one with 14 vertices have no common neighbour. The lemmas of section 7 are
//! proved by hand for every such sphere; here they are checked again on those that were found.

use super::check::{Check, Verdict};
use acutile_core::classify::{Code, frank_kasper};
use std::collections::BTreeSet;

/// The part of the proof.
pub const PART: &str = "links";

/// The number of neighbours of a vertex on the spheres of the search, in order.
const SIZES: [usize; 4] = [12, 14, 15, 16];

/// The checks on all spheres of the search.
pub fn checks() -> Vec<Check> {
    let links: Vec<Link> = frank_kasper::links().iter().map(Link::of).collect();
    let sizes: Vec<usize> = links.iter().map(|link| link.ring.len()).collect();
    let check = |id, place, statement: &str, holds, found| Check {
        part: PART,
        id,
        place,
        statement: statement.to_owned(),
        verdict: Verdict::of(holds),
        found,
    };
    let with_two: Vec<&Link> = links.iter().filter(|link| link.sixes.len() == 2).collect();
    let common: Vec<usize> = with_two.iter().map(|link| link.common()).collect();
    let wrong: Vec<String> = links
        .iter()
        .filter_map(|link| link.violation().err())
        .collect();
    vec![
        check(
            "enumeration",
            "section 12, Lemma C",
            "spheres with degrees 5 and 6 and no adjacent sixes: one each with 0, 2, 3 and 4 sixes, \
             and no other",
            sizes == SIZES,
            format!("exhaustive search: vertices {sizes:?}"),
        ),
        check(
            "two-sixes-are-far",
            "section 12, Lemma C",
            "if there are two sixes, they have no common neighbour",
            common == [0],
            format!("common neighbours: {common:?}"),
        ),
        check(
            "types",
            "section 7",
            "each 555 triangle with a u is uuu or utt', the two triangles across the HT edges of a t \
             differ, and the weights at a six add up to 6",
            wrong.is_empty(),
            match wrong.first() {
                None => format!("true of all {} spheres", links.len()),
                Some(reason) => reason.clone(),
            },
        ),
    ]
}

/// A sphere by the cyclic order of the neighbours of each vertex.
pub struct Link {
    ring: Vec<Vec<usize>>,
    sixes: BTreeSet<usize>,
}

impl Link {
    /// The sphere with a code.
    pub fn of(code: &Code) -> Link {
        Link::of_rings(code.neighbours().to_vec())
    }

    /// The sphere with these neighbours in cyclic order.
    pub fn of_rings(ring: Vec<Vec<usize>>) -> Link {
        let sixes = (0..ring.len()).filter(|&v| ring[v].len() == 6).collect();
        Link { ring, sixes }
    }

    /// The number of vertices adjacent to every six.
    fn common(&self) -> usize {
        let is_common = |ring: &&Vec<usize>| self.sixes.iter().all(|six| ring.contains(six));
        self.ring.iter().filter(is_common).count()
    }

    /// The number of sixes around a five: 0 for o, 1 for t, 2 for u.
    fn kind(&self, five: usize) -> usize {
        let ring = self.ring[five].iter();
        ring.filter(|v| self.sixes.contains(v)).count()
    }

    /// The third vertices of the triangles at an edge.
    fn across(&self, a: usize, b: usize) -> Option<[usize; 2]> {
        let ring = &self.ring[a];
        let at = ring.iter().position(|&v| v == b)?;
        let n = ring.len();
        Some([ring[(at + 1) % n], ring[(at + n - 1) % n]])
    }

    /// The third vertices that are fives, of the triangles at an edge.
    fn fives_across(&self, a: usize, b: usize) -> Vec<usize> {
        let across = self.across(a, b).into_iter().flatten();
        across.filter(|v| !self.sixes.contains(v)).collect()
    }

    /// The lemmas of section 7.
    ///
    /// # Errors
    /// The first one that does not hold, with the place.
    pub fn violation(&self) -> Result<(), String> {
        for &six in &self.sixes {
            self.hexagon(six)?;
        }
        for five in (0..self.ring.len()).filter(|v| !self.sixes.contains(v)) {
            match self.kind(five) {
                0 => {}
                1 => self.check_t(five)?,
                2 => self.check_u(five)?,
                n => return Err(format!("vertex {five}: {n} sixes are adjacent")),
            }
        }
        Ok(())
    }

    /// Twice the weights 2 (uu), 3/2 (ut), 1 (tt) of the HT edges of a hexagon add up to 12.
    fn hexagon(&self, six: usize) -> Result<(), String> {
        let ring = &self.ring[six];
        let mut weights = 0;
        for (k, &a) in ring.iter().enumerate() {
            let b = ring[(k + 1) % ring.len()];
            if self.sixes.contains(&a) {
                return Err(format!("vertices {six}, {a}: adjacent sixes"));
            }
            if !self.fives_across(a, b).is_empty() {
                weights += self.kind(a) + self.kind(b);
            }
        }
        if weights == 12 {
            Ok(())
        } else {
            Err(format!("six {six}: the weights add up to {weights}/2"))
        }
    }

    /// A u lies in one 555 triangle; its other two vertices are both u or both t.
    fn check_u(&self, u: usize) -> Result<(), String> {
        let others = self.triangles(u);
        match others[..] {
            [[y, z]] if self.kind(y) == self.kind(z) && self.kind(y) != 0 => Ok(()),
            _ => Err(format!(
                "u {u}: its 555 triangles have the vertices {others:?}"
            )),
        }
    }

    /// The triangles across the two HT edges at a t differ.
    fn check_t(&self, t: usize) -> Result<(), String> {
        let ring = &self.ring[t];
        let six = ring.iter().find(|v| self.sixes.contains(v));
        let ends = six.and_then(|&six| self.across(t, six));
        let apexes: Vec<usize> = ends
            .into_iter()
            .flatten()
            .flat_map(|end| self.fives_across(t, end))
            .collect();
        match apexes[..] {
            [x, y] if x != y => Ok(()),
            _ => Err(format!("t {t}: across its HT edges are {apexes:?}")),
        }
    }

    /// The 555 triangles at a five, by their other vertices.
    fn triangles(&self, five: usize) -> Vec<[usize; 2]> {
        let ring = &self.ring[five];
        let pairs = (0..ring.len()).map(|k| [ring[k], ring[(k + 1) % ring.len()]]);
        let is_555 = |pair: &[usize; 2]| pair.iter().all(|v| !self.sixes.contains(v));
        pairs.filter(is_555).collect()
    }
}
