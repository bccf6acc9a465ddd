//! Balls removed from the 600-cell, for acute triangulations of polyhedra.
//!
//! | module | contents |
//! |---|---|
//! | `remains` | the cells without a vertex of a set, and their boundary |
//! | `rest` | sets, and counts that forbid acute polyhedra |
//! | [`target`] | a polyhedron that the search aims at |
//! | `polyhedron`, `relax` | a polyhedron for a set, with the remaining cells in it |
//!
//! One set of each class with equal counts is built and optimized. The polyhedron is the one that is given, where its
//! edges are those that remain; else its shape is that of a projection. It does not change.

mod polyhedron;
mod relax;
mod remains;
mod rest;
pub mod target;

pub use rest::Rest;

use crate::goal::Goal;
use crate::search::{Options, Outcome, optimize};
use crate::value::value;
use acutile_core::statement::Statement;
use acutile_exact::geometry::cell600;
use remains::Remains;
use target::Target;

/// Sets with equal counts, and the result for one of them.
#[derive(Debug)]
pub struct Class {
    /// The counts.
    pub rest: Rest,
    /// One of the sets.
    pub removed: Vec<usize>,
    /// The number of sets that were seen.
    pub sets: usize,
    /// The result for `removed`.
    pub result: Found,
}

/// The result for a set.
#[derive(Debug)]
pub enum Found {
    /// A path of edges of valence one and two ends, so that they are not all edges of a polyhedron.
    DeadEnd,
    /// Another number of faces was asked for.
    OtherFaces,
    /// The search ended before.
    NotTried,
    /// The edges of valence one and two are not those of the given polyhedron, or of a convex polyhedron with three
    /// faces at each corner.
    NoPolyhedron,
    /// The tetrahedra overlap where they are placed, in each of this number of placements.
    Overlap(usize),
    /// Optimized; perhaps acute.
    Optimized(Box<Outcome>),
}

impl Found {
    /// Whether an acute tiling was proved.
    pub fn is_acute(&self) -> bool {
        match self {
            Found::Optimized(outcome) => outcome.proved.statements().contains(&Statement::Acute),
            _ => false,
        }
    }
}

/// Reports the current work; returns whether to go on.
pub type Report<'a> = &'a mut dyn FnMut(&str) -> bool;

/// The options of a search.
#[derive(Clone, Debug)]
pub struct Balls {
    /// Connected sets of at most this many vertices, and these with their neighbours.
    pub size: usize,
    /// Only polyhedra with this many faces.
    pub faces: Option<usize>,
    /// Only this polyhedron.
    pub target: Option<Target>,
    /// At most this many linear programs for a polyhedron.
    pub steps: usize,
}

/// Builds and optimizes one polyhedron of each class. The second value is whether `report` ended the search.
pub fn search(balls: &Balls, report: Report) -> (Vec<Class>, bool) {
    let cells = cell600::cells();
    let mut goes_on = true;
    let found = rest::rests(balls.size, &mut |count| {
        goes_on = report(&format!("set {count}"));
        goes_on
    });
    let mut classes = Vec::new();
    for (rest, (removed, sets)) in found {
        let is_wanted = balls.faces.is_none_or(|faces| faces == rest.faces);
        let result = if !rest.is_closed() {
            Found::DeadEnd
        } else if !is_wanted {
            Found::OtherFaces
        } else if !goes_on {
            Found::NotTried
        } else {
            let words = format!("{} tetrahedra, {} faces", rest.tetrahedra, rest.faces);
            result(&cells, &removed, balls, &mut |value| {
                goes_on = report(&format!("{words}: {value:.4}"));
                goes_on
            })
        };
        classes.push(Class {
            rest,
            removed,
            sets,
            result,
        });
    }
    (classes, !goes_on)
}

fn result(
    cells: &[[usize; 4]],
    removed: &[usize],
    balls: &Balls,
    watch: &mut dyn FnMut(f64) -> bool,
) -> Found {
    let Some(remains) = Remains::of(cells, removed) else {
        return Found::NoPolyhedron;
    };
    let placed = match &balls.target {
        Some(target) => polyhedron::placed_in(&remains, removed, target),
        None => polyhedron::placed(&remains, removed).into_iter().collect(),
    };
    if placed.is_empty() {
        return Found::NoPolyhedron;
    }
    let options = Options {
        goal: Goal::Acute,
        steps: balls.steps,
        ..Options::default()
    };
    let mut best: Option<Outcome> = None;
    for tiling in &placed {
        if let Ok(outcome) = optimize(tiling, &options, watch) {
            let is_better = best.as_ref().is_none_or(|best| is_better(&outcome, best));
            if is_better {
                best = Some(outcome);
            }
        }
    }
    match best {
        Some(outcome) => Found::Optimized(Box::new(outcome)),
        None => Found::Overlap(placed.len()),
    }
}

/// Whether the largest dihedral angle is smaller, exactly.
fn is_better(outcome: &Outcome, other: &Outcome) -> bool {
    let angle = |outcome: &Outcome| value(outcome.proved.statements(), Goal::MaxDihedral);
    match (angle(outcome), angle(other)) {
        (Some(new), Some(old)) => new.is_better_than(&old),
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Acute triangulations are known for each of these: without a cell, without two cells with a common triangle,
    /// without the star of a vertex. All cells are placed without an overlap, as a program in Python found, too.
    #[test]
    fn known_polyhedra_are_placed() {
        let cells = cell600::cells();
        let [a, b, c, d] = cells[0];
        let has = |cell: &&[usize; 4], v: usize| cell.contains(&v);
        let mut second = cells
            .iter()
            .filter(|cell| has(cell, a) && has(cell, b) && has(cell, c) && !has(cell, d));
        let other = second
            .next()
            .and_then(|cell| cell.iter().find(|v| ![a, b, c].contains(v)));
        let star: Vec<usize> = {
            let near = cells.iter().filter(|cell| has(cell, a)).flatten();
            let all: std::collections::BTreeSet<usize> = near.copied().collect();
            all.into_iter().collect()
        };
        let sets = [
            (vec![a, b, c, d], 543, 4),
            (vec![a, b, c, d, *other.expect("a cell")], 533, 5),
            (star, 470, 12),
        ];
        for (removed, tetrahedra, faces) in sets {
            let remains = Remains::of(&cells, &removed).expect("a sphere");
            let tiling = polyhedron::placed(&remains, &removed).expect("a polyhedron");
            let solid = tiling.frame.domain.polytope().expect("a solid");
            assert_eq!((tiling.len(), solid.faces.len()), (tetrahedra, faces));
            let balls = Balls {
                size: 1,
                faces: None,
                target: None,
                steps: 0,
            };
            match result(&cells, &removed, &balls, &mut |_| true) {
                Found::Optimized(_) => {}
                other => panic!("{faces} faces: {other:?}"),
            }
        }
        // Without a vertex the boundary is an icosahedron with five cells at each edge, which has no edge of valence 2.
        let remains = Remains::of(&cells, &[a]).expect("a sphere");
        assert!(polyhedron::placed(&remains, &[a]).is_none());
    }

    /// Without a cell the edges are those of a tetrahedron: the regular one, of volume 8/3, is filled, and a
    /// pyramid over a square is not.
    #[test]
    fn a_given_polyhedron_is_filled() {
        let cells = cell600::cells();
        let cubic = [["1", "0", "0"], ["0", "1", "0"], ["0", "0", "1"]];
        let balls = |points: &[[&str; 3]]| Balls {
            size: 1,
            faces: None,
            target: Some(Target::of_texts(cubic, points).expect("a polyhedron")),
            steps: 0,
        };
        let regular = [
            ["1", "1", "1"],
            ["1", "-1", "-1"],
            ["-1", "1", "-1"],
            ["-1", "-1", "1"],
        ];
        let target = balls(&regular);
        let Found::Optimized(outcome) = result(&cells, &cells[0], &target, &mut |_| true) else {
            panic!("it overlaps");
        };
        let solid = outcome.tiling.frame.domain.polytope().expect("a solid");
        assert_eq!(outcome.tiling.len(), 543);
        assert_eq!(
            solid.scaled_volume(),
            acutile_exact::number::Number::from(malachite::Rational::from(16))
        );
        let pyramid = [
            ["0", "0", "0"],
            ["1", "0", "0"],
            ["0", "1", "0"],
            ["1", "1", "0"],
            ["1/2", "1/2", "1"],
        ];
        let found = result(&cells, &cells[0], &balls(&pyramid), &mut |_| true);
        assert!(matches!(found, Found::NoPolyhedron));
    }
}
