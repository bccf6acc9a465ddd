//! The data of one tiling for the page's program: exact values as text, doubles for the picture.
//!
//! Corners and exact coordinates are not here; the page reads them from the certificate that it
//! carries. A tiling without a lattice has rank 0.

use super::colour::{hex, part};
use super::facts::{Facts, cosine_bounds, cosine_text, degrees, middle};
use super::proved::Proved;
use acutile_core::quality::{DihedralAngle, Exact, rounded_down, rounded_up};
use acutile_core::statistics::{Extreme, Place, Statistics};
use acutile_core::tiling::{Domain, Tiling};
use acutile_exact::number::Number;
use malachite::Rational;
use serde_json::{Value, json};

/// The object `tilings[i]` of the page, for a tiling with too many different simplices for tables.
/// `range`: the least and greatest largest angle of a simplex in degrees.
pub fn mesh_data<const D: usize>(
    proved: &Proved,
    tiling: &Tiling<D>,
    statistics: &Statistics,
) -> Value {
    let degrees = |extreme: &Option<Extreme<Place>>| {
        let bounds = extreme.as_ref().map(|extreme| &extreme.bounds);
        bounds.map_or(0.0, middle)
    };
    let range = [
        degrees(&statistics.smallest).max(if D == 2 { 60.0 } else { 70.5 }),
        degrees(&statistics.largest),
    ];
    let mut data = common(proved, tiling);
    data["range"] = json!(range);
    data
}

fn common<const D: usize>(proved: &Proved, tiling: &Tiling<D>) -> Value {
    json!({
        "name": proved.name,
        "dimension": D,
        "rank": tiling.frame.rank(),
        "domain": domain_word(&tiling.frame.domain),
        "sha256": proved.sha256(),
        "certificate": proved.json(),
        "basis": basis(tiling),
        "generator": tiling.frame.field.generator().approximate(),
        "points": tiling.vertices.iter().map(|v| v.each_ref().map(|x| x.approximate()).to_vec())
            .collect::<Vec<_>>(),
    })
}

/// The object `tilings[i]` of the page.
///
/// `basis`: rows are the basis vectors in Cartesian coordinates. `points`: D coordinates in the
/// basis for each vertex. `cells`: class, volume, edges 01 02 …, angles between facets 01 02 …,
/// the last three as indices into `numbers` and `angles`.
pub fn tiling_data<const D: usize>(proved: &Proved, tiling: &Tiling<D>, facts: &Facts) -> Value {
    let mut type_names: Vec<&String> = facts.types.iter().collect();
    type_names.sort_by_key(|name| (name.len(), *name));
    type_names.dedup();
    let type_index = |name: &String| type_names.iter().position(|other| *other == name);
    let mut data = common(proved, tiling);
    let tables = json!({
        "typeNames": type_names,
        "types": facts.types.iter().map(type_index).collect::<Vec<_>>(),
        "palette": facts.palette().colours().iter().map(|colour| hex(part(*colour))).collect::<Vec<_>>(),
        "numbers": facts.numbers.values.iter()
            .map(|x| json!([x.to_string(), x.approximate()])).collect::<Vec<_>>(),
        "angles": facts.angles.values.iter().map(angle).collect::<Vec<_>>(),
        "cells": facts.cells.iter()
            .map(|cell| [&[cell.class, cell.volume], &cell.edges[..], &cell.angles[..]].concat())
            .collect::<Vec<_>>(),
    });
    if let (Some(data), Value::Object(tables)) = (data.as_object_mut(), tables) {
        data.extend(tables);
    }
    data
}

/// What is tiled, in a word.
pub fn domain_word<S>(domain: &Domain<S>) -> &'static str {
    match domain {
        Domain::Space => "space",
        Domain::Slab(_) => "slab",
        Domain::Prism(_) => "prism",
        Domain::Solid(_) => "solid",
        Domain::Region(_) => "region",
    }
}

/// The exact cosine, its square with its sign, decimal bounds of the cosine and of the degrees.
/// Then the angle's name where it has one, and degrees as a double.
fn angle(angle: &DihedralAngle) -> Value {
    let enclosure = degrees(angle);
    json!({
        "cosine": cosine_text(angle),
        "square": angle.signed_square.to_string(),
        "decimals": decimals(&cosine_bounds(angle), 10),
        "degrees": decimals(&enclosure, 6),
        "name": angle.closed_form(),
        "approximate": middle(&enclosure),
    })
}

/// Both bounds, rounded outward.
fn decimals((low, high): &(Rational, Rational), digits: u64) -> [String; 2] {
    [rounded_down(low, digits), rounded_up(high, digits)]
}

/// Rows b_i with b_i · b_j = G_ij: the Cholesky factor, in doubles.
pub fn basis<const D: usize>(tiling: &Tiling<D>) -> Vec<Vec<f64>> {
    let gram = tiling
        .frame
        .gram
        .each_ref()
        .map(|row| row.each_ref().map(Number::approximate));
    let mut rows = vec![vec![0.0; D]; D];
    for i in 0..D {
        for j in 0..=i {
            let dot: f64 = (0..j).map(|k| rows[i][k] * rows[j][k]).sum();
            let rest: f64 = gram[i][j] - dot;
            rows[i][j] = if i == j {
                rest.max(0.0).sqrt()
            } else {
                rest / rows[j][j]
            };
        }
    }
    rows
}
