//! The type of a space group, with a transformation to its standard setting.
//!
//! moyo proposes the type, the basis and, in doubles, the origin. The doubles propose the translation of
//! the standard group that belongs to each motion. Then the equations for the origin are solved exactly,
//! and the transformed group is compared with the standard one. Nothing else is believed.

use crate::lattice::{basis, gram_of, translations};
use crate::motion::{Motion, Vector, fractional};
use crate::setting::{Setting, settings};
use crate::solve::{Matrix, integral, inverse, product, rational, solve, times, transposed};
use malachite::Rational;
use malachite::base::num::arithmetic::traits::Floor;
use malachite::base::num::conversion::traits::RoundingFrom;
use malachite::base::rounding_modes::RoundingMode::Nearest;
use moyo::base::{Lattice, Operation};
use moyo::data::hall_symbol_entry;
use moyo::identify::SpaceGroup;
use nalgebra::{Matrix3, Vector3};

/// How far moyo's translations may be off when they are compared.
const EPSILON: f64 = 1e-6;

/// A group that was identified.
#[derive(Clone, Debug)]
pub struct Identified {
    /// The standard setting: unique axis b, hexagonal axes, origin choice 2.
    pub setting: &'static Setting,
    /// The standard group, sorted.
    pub standard: Vec<Motion>,
    /// x in the standard setting is `linear` (x - `origin`).
    linear: Matrix,
    origin: Vector,
}

impl Identified {
    /// A point in the standard setting.
    pub fn standard_point(&self, point: &Vector) -> Vector {
        let moved = std::array::from_fn(|k| &point[k] - &self.origin[k]);
        times(&self.linear, &moved)
    }

    /// A vector in the standard setting.
    pub fn standard_direction(&self, vector: &Vector) -> Vector {
        times(&self.linear, vector)
    }
}

/// The type of a group, closed modulo the lattice of a cell with this Gram matrix. `None` if moyo
/// finds none, or its result is not exactly right.
pub fn identify(group: &[Motion], gram: &Matrix) -> Option<Identified> {
    // Columns are the basis vectors of the primitive lattice.
    let rows = basis(&translations(group))?;
    let columns = transposed(&rows);
    let to_primitive = inverse(&columns)?;
    let operations = primitive_operations(group, &columns, &to_primitive)?;
    let lattice = Lattice::new(cartesian(&gram_of(&rows, gram))?);
    let found = SpaceGroup::from_lattice(
        &lattice,
        &operations,
        moyo::data::Setting::Standard,
        EPSILON,
    )
    .ok()?;
    let setting = settings().get(usize::try_from(found.hall_number - 1).ok()?)?;
    let entry = hall_symbol_entry(found.hall_number)?;
    let to_conventional = inverse(&rational(
        entry.centering.linear().map(i64::from).transpose().into(),
    ))?;
    let proposed = rational(
        found
            .transformation
            .linear_as_array()
            .map(|row| row.map(i64::from)),
    );
    let linear = product(
        &product(&to_conventional, &inverse(&proposed)?),
        &to_primitive,
    );
    let near = origin_near(&columns, found.transformation.origin_shift_as_array());
    let standard = setting.group().ok()?;
    let origin = exact_origin(group, &linear, &near, &standard)?;
    let identified = Identified {
        setting,
        standard,
        linear,
        origin,
    };
    is_right(&identified, group).then_some(identified)
}

/// The motions in the primitive basis, one of each class modulo its lattice, as moyo has them.
fn primitive_operations(
    group: &[Motion],
    columns: &Matrix,
    to_primitive: &Matrix,
) -> Option<Vec<Operation>> {
    let mut seen = std::collections::BTreeSet::new();
    let mut operations = Vec::new();
    for motion in group {
        let rotation = product(&product(to_primitive, &rational(motion.rotation)), columns);
        let rotation = integral(&rotation)?;
        let translation = times(to_primitive, &motion.translation).map(fractional);
        if !seen.insert((rotation, translation.clone())) {
            continue;
        }
        let entries = rotation.map(|row| row.map(|entry| entry as i32));
        operations.push(Operation::new(
            Matrix3::from_fn(|i, j| entries[i][j]),
            Vector3::from_fn(|k, _| approximate(&translation[k])),
        ));
    }
    Some(operations)
}

/// Basis vectors in Cartesian coordinates, as rows.
fn cartesian(gram: &Matrix) -> Option<Matrix3<f64>> {
    let gram = Matrix3::from_fn(|i, j| approximate(&gram[i][j]));
    Some(gram.cholesky()?.l())
}

fn approximate(x: &Rational) -> f64 {
    f64::rounding_from(x, Nearest).0
}

/// The proposed origin in the coordinates of the cell.
fn origin_near(columns: &Matrix, origin: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|i| {
        (0..3)
            .map(|j| approximate(&columns[i][j]) * origin[j])
            .sum()
    })
}

/// The origin p with L t + L (R - 1) p = w modulo the lattice for every motion and the motion of
/// the standard group that belongs to it.
fn exact_origin(
    group: &[Motion],
    linear: &Matrix,
    near: &[f64; 3],
    standard: &[Motion],
) -> Option<Vector> {
    let back = inverse(linear)?;
    let mut equations = Vec::new();
    for motion in group {
        let rotation = integral(&product(
            &product(linear, &rational(motion.rotation)),
            &back,
        ))?;
        let shift = times(linear, &motion.translation);
        let mut difference = rational(motion.rotation);
        (0..3).for_each(|k| difference[k][k] -= Rational::from(1));
        let factor = product(linear, &difference);
        let approximate_shift: [f64; 3] = std::array::from_fn(|k| {
            let moved: f64 = (0..3).map(|j| approximate(&factor[k][j]) * near[j]).sum();
            approximate(&shift[k]) + moved
        });
        let with_rotation = standard.iter().filter(|other| other.rotation == rotation);
        let distance = |other: &Motion| -> f64 {
            let steps = (0..3).map(|k| {
                let step = approximate_shift[k] - approximate(&other.translation[k]);
                (step - step.round()).abs()
            });
            steps.fold(0.0, f64::max)
        };
        let nearest = with_rotation.min_by(|a, b| distance(a).total_cmp(&distance(b)))?;
        for k in 0..3 {
            let step = approximate_shift[k] - approximate(&nearest.translation[k]);
            let whole = Rational::try_from(step.round()).ok()?;
            let value = &nearest.translation[k] + whole - &shift[k];
            equations.push((factor[k].clone(), value));
        }
    }
    solve(equations, false)
}

/// Whether the transformed group is the standard one: each motion goes to one of it, and the
/// lattices of both are the same.
fn is_right(identified: &Identified, group: &[Motion]) -> bool {
    let Identified {
        standard,
        linear,
        origin,
        ..
    } = identified;
    let Some(back) = inverse(linear) else {
        return false;
    };
    let is_standard = |motion: &Motion| {
        let rotation = product(&product(linear, &rational(motion.rotation)), &back);
        let Some(rotation) = integral(&rotation) else {
            return false;
        };
        let moved = motion.apply(origin);
        let step = std::array::from_fn(|k| &moved[k] - &origin[k]);
        let translation = times(linear, &step).map(fractional);
        standard
            .binary_search(&Motion {
                rotation,
                translation,
            })
            .is_ok()
    };
    let unit = |k: usize| std::array::from_fn(|j| Rational::from(u8::from(j == k)));
    let of_cell = (0..3).all(|k| {
        let image = times(linear, &unit(k)).map(fractional);
        standard.binary_search(&Motion::translation(image)).is_ok()
    });
    let of_standard = translations(standard)
        .into_iter()
        .chain((0..3).map(unit))
        .all(|translation| {
            let image = Motion::translation(times(&back, &translation)).reduced();
            group.contains(&image)
        });
    let rotations = |group: &[Motion]| {
        let all: std::collections::BTreeSet<_> = group.iter().map(|m| m.rotation).collect();
        all.len()
    };
    of_cell
        && of_standard
        && group.iter().all(is_standard)
        && rotations(group) == rotations(standard)
}

/// Whether two groups are the same but for a shift of the origin by multiples of 1/24; `None` if
/// their translations are no such multiples.
pub fn differ_by_origin(first: &[Motion], second: &[Motion]) -> Option<bool> {
    const GRID: i64 = 24;
    let scaled = |group: &[Motion]| -> Option<Vec<(crate::motion::Rotation, [i64; 3])>> {
        let one = |motion: &Motion| {
            let mut shift = [0; 3];
            for k in 0..3 {
                let value = fractional(motion.translation[k].clone()) * Rational::from(GRID);
                if *value.denominator_ref() != 1u32 {
                    return None;
                }
                shift[k] = i64::try_from(&(&value).floor()).ok()?;
            }
            Some((motion.rotation, shift))
        };
        group.iter().map(one).collect()
    };
    let (first, second) = (scaled(first)?, scaled(second)?);
    let wanted: std::collections::HashSet<_> = second.iter().copied().collect();
    if first.len() != wanted.len() {
        return Some(false);
    }
    for index in 0..GRID * GRID * GRID {
        let p = [index / (GRID * GRID), index / GRID % GRID, index % GRID];
        let is_moved = |(rotation, shift): &(crate::motion::Rotation, [i64; 3])| {
            let moved = std::array::from_fn(|i| {
                let turned: i64 = (0..3).map(|j| rotation[i][j] * p[j]).sum();
                (shift[i] + p[i] - turned).rem_euclid(GRID)
            });
            wanted.contains(&(*rotation, moved))
        };
        if first.iter().all(is_moved) {
            return Some(true);
        }
    }
    Some(false)
}
