//! Properties of the prover: bytes never make it panic, what it proves the kernel
//! confirms, and symmetries of a tiling keep its verdict.

use crate::kuhn::kuhn;
use acutile_catalog as catalog;
use acutile_core::checker::{Options, examine};
use acutile_core::proved::prove;
use acutile_core::statement::Statement;
use acutile_core::tiling::{AnyTiling, Corner, Tiling, VertexId, supercell};
use acutile_core::with_dimension;
use acutile_exact::geometry::linear;
use acutile_exact::number::Number;
use acutile_io::import::{Content, read_native};
use malachite::Rational;
use proptest::prelude::*;

/// What is proved of a text, confirmed by the kernel; `None` where it is no tiling.
fn judged(text: &str) -> Option<Vec<Statement>> {
    let Content::Tiling(tiling) = read_native(text).ok()?.content else {
        return None;
    };
    with_dimension!(&tiling, AnyTiling, t => statements(t))
}

fn statements<const D: usize>(tiling: &Tiling<D>) -> Option<Vec<Statement>> {
    let proof = examine(tiling, &Options::default(), &|_| ()).ok()?;
    let proved = prove(tiling, &Options::default(), &|_| ());
    let proved = proved.unwrap_or_else(|reason| panic!("examined, but {reason}"));
    assert_eq!(proved.statements(), proof.statements);
    Some(proof.statements)
}

fn named(name: &str) -> Tiling<3> {
    match catalog::build(name) {
        Ok(AnyTiling::Space(tiling)) => tiling,
        _ => panic!("{name} is a tiling of space"),
    }
}

proptest! {
    #[test]
    fn bytes_never_panic(bytes in proptest::collection::vec(any::<u8>(), 0..400)) {
        let _ = judged(&String::from_utf8_lossy(&bytes));
    }

    #[test]
    fn changed_characters_never_panic_and_what_is_proved_is_confirmed(
        changes in proptest::collection::vec((any::<prop::sample::Index>(), "[ -~]"), 1..4),
    ) {
        let mut text = kuhn().to_string().into_bytes();
        for (index, character) in &changes {
            let place = index.index(text.len());
            text[place] = character.as_bytes()[0];
        }
        let _ = judged(&String::from_utf8_lossy(&text));
    }

    #[test]
    fn numbers_in_place_of_numbers_are_confirmed_or_refused(number in "[-+*/^().0-9a-z]{1,12}") {
        let mut document = kuhn();
        document["lattice"]["gram"][2][2] = number.into();
        let _ = judged(&document.to_string());
    }

    #[test]
    fn symmetries_keep_the_verdict(
        name in prop::sample::select(vec!["a15", "z", "bcc", "cube-6", "sigma"]),
        keys in proptest::collection::vec(any::<u64>(), 400),
        shears in proptest::collection::vec((0usize..3, 0usize..3, -2i32..3), 0..4),
        shifts in proptest::collection::vec(prop::array::uniform3(-3i32..4), 400),
        (scale, per) in (1i64..50, 1i64..50),
    ) {
        let tiling = named(name);
        let mut changed = tiling.clone();
        relabel(&mut changed, &keys);
        reorder(&mut changed, &keys);
        move_vertices(&mut changed, &shifts);
        for (row, column, factor) in shears {
            if row != column {
                shear(&mut changed, row, column, factor);
            }
        }
        rescale(&mut changed, &Number::from(Rational::from_signeds(scale, per)));
        prop_assert_eq!(statements(&changed), statements(&tiling));
    }
}

/// Numbers the vertices in the order of their keys.
fn relabel(tiling: &mut Tiling<3>, keys: &[u64]) {
    let mut order: Vec<usize> = (0..tiling.vertices.len()).collect();
    order.sort_by_key(|&v| (keys[v], v));
    let mut index = vec![0; order.len()];
    for (new, &old) in order.iter().enumerate() {
        index[old] = new as u32;
    }
    tiling.vertices = order
        .iter()
        .map(|&old| tiling.vertices.vertex(VertexId::at(old)))
        .collect();
    for corner in &mut tiling.corners {
        corner.vertex = VertexId::new(index[corner.vertex.index()]);
    }
}

/// Orders the simplices by keys, and rotates the last three corners of some.
fn reorder(tiling: &mut Tiling<3>, keys: &[u64]) {
    let mut simplices: Vec<Vec<Corner<3>>> = tiling.simplices().map(<[_]>::to_vec).collect();
    for (simplex, key) in simplices.iter_mut().zip(keys) {
        simplex[1..].rotate_left((key % 3) as usize);
    }
    let mut order: Vec<usize> = (0..simplices.len()).collect();
    order.sort_by_key(|&s| (keys[s].rotate_left(17), s));
    tiling.corners = order.iter().flat_map(|&s| simplices[s].clone()).collect();
}

/// Replaces vertices by lattice translates of themselves, and simplices, too.
fn move_vertices(tiling: &mut Tiling<3>, shifts: &[[i32; 3]]) {
    let moved = |(vertex, shift): ([Number; 3], &[i32; 3])| {
        std::array::from_fn(|k| &vertex[k] + &Number::from(Rational::from(shift[k])))
    };
    tiling.vertices = tiling.vertices.iter().zip(shifts).map(moved).collect();
    for (index, corner) in tiling.corners.iter_mut().enumerate() {
        let back = shifts[corner.vertex.index()].map(|step| -step);
        *corner = corner.moved(back).moved(shifts[index / 4 % shifts.len()]);
    }
}

/// The basis with b_row replaced by b_row + factor b_column, so that the coordinate at
/// `column` becomes x_column - factor x_row.
fn shear(tiling: &mut Tiling<3>, row: usize, column: usize, factor: i32) {
    let number = Number::from(Rational::from(factor));
    let unit = |i: usize, j: usize| Number::from(Rational::from(i64::from(i == j)));
    let change: [[Number; 3]; 3] = std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            if (i, j) == (row, column) {
                number.clone()
            } else {
                unit(i, j)
            }
        })
    });
    let gram = &tiling.frame.gram;
    tiling.frame.gram = std::array::from_fn(|i| {
        std::array::from_fn(|j| linear::dot(&change[i], &linear::apply(gram, &change[j])))
    });
    let changed = |mut vertex: [Number; 3]| {
        vertex[column] = &vertex[column] - &(&number * &vertex[row]);
        vertex
    };
    tiling.vertices = tiling.vertices.iter().map(changed).collect();
    for corner in &mut tiling.corners {
        corner.shift[column] -= factor * corner.shift[row];
    }
}

fn rescale(tiling: &mut Tiling<3>, factor: &Number) {
    tiling.frame.gram = tiling
        .frame
        .gram
        .each_ref()
        .map(|row| row.each_ref().map(|entry| entry * factor));
}

#[test]
fn a_supercell_has_the_same_statements() {
    for name in ["a15", "cube-6", "sigma"] {
        let tiling = named(name);
        assert_eq!(
            statements(&supercell(&tiling, [2, 1, 3])),
            statements(&tiling),
            "{name}"
        );
    }
}
