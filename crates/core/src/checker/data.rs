//! Defects as data, for machines: one JSON object each, with the same indices and
//! exact values as the sentences of [`super::render`].

use super::defect::{Angle, ContactKind, Defect};
use super::names::Names;
use super::render::describe;
use crate::tiling::{Corner, Facet, SimplexId, Tiling, VertexId};
use acutile_exact::number::Number;
use malachite::Rational;
use serde_json::{Map, Value, json};

/// `{"code": …, "message": …}` and the members of the defect: indices from zero,
/// corners as `[vertex, s_1, …, s_r]`, numbers and bounds as texts.
/// Every simplex that the defect is about is among the `places`, with its names and
/// its exact coordinates in the basis, and for a mesh in the file.
pub fn defect_data<const D: usize>(tiling: &Tiling<D>, names: &Names, defect: &Defect) -> Value {
    let mut data = Map::new();
    data.insert("code".to_owned(), json!(defect.code()));
    data.insert("message".to_owned(), json!(describe::<D>(names, defect)));
    if let Value::Object(members) = members(tiling, defect) {
        data.extend(members);
    }
    if let Defect::Overlap { point, .. } | Defect::BoundaryMeets { point, .. } = defect
        && let Some(point) = in_file(names, point)
    {
        data.insert("point_in_file".to_owned(), json!(point));
    }
    let places: Vec<Value> = defect
        .simplices()
        .into_iter()
        .map(|simplex| place(tiling, names, simplex))
        .collect();
    if !places.is_empty() {
        data.insert("places".to_owned(), json!(places));
    }
    Value::Object(data)
}

/// A simplex with its names and the coordinates of its corners.
fn place<const D: usize>(tiling: &Tiling<D>, names: &Names, simplex: SimplexId) -> Value {
    let corners: Vec<String> = (0..=D).map(|k| names.corner(simplex, k)).collect();
    let position = |corner: &Corner<D>| tiling.position(corner).each_ref().map(text).to_vec();
    let positions = tiling.simplex(simplex).iter().map(position);
    let mut data = json!({
        "simplex": simplex.number(),
        "name": names.simplex(simplex),
        "corner_names": corners,
        "coordinates": positions.collect::<Vec<_>>(),
    });
    let in_file = |corner: &Corner<D>| in_file(names, &tiling.position(corner));
    let in_file: Option<Vec<_>> = tiling.simplex(simplex).iter().map(in_file).collect();
    if let Some(in_file) = in_file {
        data["coordinates_in_file"] = json!(in_file);
    }
    data
}

/// A point in the coordinates of the file, if they are others than those of the basis.
fn in_file(names: &Names, point: &[Number]) -> Option<Vec<String>> {
    let point = names.point(point)?;
    Some(point.iter().map(text).collect())
}

fn members<const D: usize>(tiling: &Tiling<D>, defect: &Defect) -> Value {
    let facet = |facet: &Facet| facet_data(tiling, facet);
    match defect {
        Defect::MetricNotPositive { order, minor } => {
            json!({ "order": order, "minor": text(minor) })
        }
        Defect::NoSimplices => json!({}),
        Defect::RepeatedCorner {
            simplex,
            corners: (i, j),
        } => {
            json!({ "simplex": simplex.number(), "equal_corners": [i, j], "corners": corners(tiling, *simplex) })
        }
        Defect::Flat { simplex } => {
            json!({ "simplex": simplex.number(), "corners": corners(tiling, *simplex), "determinant": "0" })
        }
        Defect::NegativeOrientation {
            simplex,
            determinant,
        } => json!({
            "simplex": simplex.number(),
            "corners": corners(tiling, *simplex),
            "determinant": text(determinant),
        }),
        Defect::UnmatchedFacet { facet: unmatched } => json!({ "facets": [facet(unmatched)] }),
        Defect::SameSide { facets: (a, b) } => json!({ "facets": [facet(a), facet(b)] }),
        Defect::OverusedFacet { facets } => {
            json!({ "facets": facets.iter().map(facet).collect::<Vec<_>>() })
        }
        Defect::VolumeSum { sum, expected } => {
            json!({ "sum": text(sum), "expected": text(expected) })
        }
        Defect::FaceWithoutPlane { face } | Defect::FaceNotConvex { face } => {
            json!({ "face": face })
        }
        Defect::FaceNotSupporting {
            face,
            vertex,
            value,
        } => {
            json!({ "face": face, "domain_vertex": vertex, "value": text(value) })
        }
        Defect::RidgeNotShared { ridge, faces } => json!({ "ridge": ridge, "faces": faces }),
        Defect::VertexOutside {
            vertex,
            face,
            value,
        } => {
            json!({ "vertex": vertex, "face": face, "value": text(value) })
        }
        Defect::CoincidentVertices { vertices } => json!({ "vertices": vertices }),
        Defect::BoundaryMeets {
            facets: (a, b),
            point,
        } => {
            let point: Vec<String> = point.iter().map(text).collect();
            json!({ "facets": [facet(a), facet(b)], "point": point })
        }
        Defect::Covered {
            facet: boundary,
            simplices,
        } => json!({
            "facets": [facet(boundary)],
            "simplices": simplices.iter().map(|s| s.number()).collect::<Vec<_>>(),
            "outside": simplices.len(),
        }),
        Defect::Overlap {
            simplices,
            shift,
            point,
        } => {
            let point: Vec<String> = point.iter().map(text).collect();
            let simplices = [simplices.0.number(), simplices.1.number()];
            json!({ "simplices": simplices, "second_moved_by": shift, "point": point })
        }
        Defect::NonConforming {
            sides,
            coincident,
            kind,
        } => {
            let side = |facets: &Vec<Facet>| facets.iter().map(facet).collect::<Vec<_>>();
            let (kind, hanging) = match kind {
                ContactKind::EqualFacets => ("equal-facets", 0),
                ContactKind::OtherDiagonals => ("other-diagonals", 0),
                ContactKind::HangingNodes(hanging) => ("hanging-nodes", *hanging),
                ContactKind::Touching => ("touching", 0),
            };
            json!({
                "sides": sides.each_ref().map(side),
                "coincident": coincident,
                "kind": kind,
                "hanging_nodes": hanging,
            })
        }
        Defect::Duplicates { simplices } | Defect::NotConnected { firsts: simplices } => json!({
            "simplices": simplices.iter().map(|s| s.number()).collect::<Vec<_>>(),
        }),
        Defect::NotBoundary { triangles } => json!({ "triangles": triangles }),
        Defect::Cavity { facets } | Defect::NotOnSurface { facets } => {
            json!({ "facets": facets.iter().map(facet).collect::<Vec<_>>() })
        }
        Defect::NotManifold { ridges, vertices } => {
            let ridge = |r: &Vec<VertexId>| r.iter().map(|v| v.number()).collect::<Vec<_>>();
            json!({
                "ridges": ridges.iter().map(ridge).collect::<Vec<_>>(),
                "vertices": vertices.iter().map(|v| v.number()).collect::<Vec<_>>(),
            })
        }
        Defect::NearMates(near) => json!({ "facets": near.facets, "distance": near.distance }),
        Defect::VertexFar { vertex } => json!({ "vertex": vertex }),
        Defect::BoundaryWork { limit } => json!({ "limit": limit }),
        Defect::NoBoundary | Defect::NoneInside => json!({}),
        Defect::UnusedVertex { vertex } => json!({ "vertex": vertex }),
        Defect::RightAngle { angle } | Defect::ObtuseAngle { angle } => angle_data(tiling, angle),
        Defect::AngleNotBelow { angle, bound } | Defect::AngleNotAbove { angle, bound } => {
            let mut data = angle_data(tiling, angle);
            data["bound"] = json!(bound.to_string());
            data
        }
        Defect::RatioNotBelow {
            simplex,
            squared_ratio,
            bound,
        } => json!({
            "simplex": simplex.number(),
            "corners": corners(tiling, *simplex),
            "squared_ratio": text(squared_ratio),
            "bound": bound.to_string(),
        }),
        Defect::NotTcp { reason } => json!({ "reason": reason.to_string() }),
        Defect::PlaneBeyond { plane, dimension } => {
            json!({ "plane": plane.to_string(), "dimension": dimension })
        }
        Defect::PlaneCrossed {
            simplex,
            plane,
            offset,
            sides,
        } => json!({
            "simplex": simplex.number(),
            "corners": corners(tiling, *simplex),
            "plane": plane.to_string(),
            "offset": offset.to_string(),
            "sides": [text(&sides.0), text(&sides.1)],
        }),
        Defect::OnCircumsphere {
            facet: behind,
            neighbour,
        } => {
            json!({ "facets": [facet(behind)], "neighbour": neighbour.number(), "power": "0" })
        }
        Defect::InsideCircumsphere {
            facet: behind,
            neighbour,
            power,
        } => {
            json!({ "facets": [facet(behind)], "neighbour": neighbour.number(), "power": text(power) })
        }
    }
}

fn text(number: &Number) -> String {
    number.to_string()
}

/// An angle by its simplex, its two facets (each named by the corner opposite), the
/// product of their normals, and bounds in degrees.
fn angle_data<const D: usize>(tiling: &Tiling<D>, angle: &Angle) -> Value {
    let bound = |degrees: &Rational| degrees.to_string();
    json!({
        "simplex": angle.simplex.number(),
        "corners": corners(tiling, angle.simplex),
        "between": [angle.facets.0, angle.facets.1],
        "product": text(&angle.product),
        "degrees": [bound(&angle.degrees.0), bound(&angle.degrees.1)],
    })
}

fn facet_data<const D: usize>(tiling: &Tiling<D>, facet: &Facet) -> Value {
    let simplex = facet.simplex;
    json!({
        "simplex": simplex.number(),
        "opposite": facet.opposite,
        "corners": corners(tiling, simplex),
    })
}

fn corners<const D: usize>(tiling: &Tiling<D>, simplex: SimplexId) -> Value {
    let rank = tiling.frame.rank();
    let row = |corner: &Corner<D>| -> Vec<i64> {
        let shift = corner.shift[..rank].iter().map(|&s| i64::from(s));
        std::iter::once(i64::from(corner.vertex.number()))
            .chain(shift)
            .collect()
    };
    tiling.simplex(simplex).iter().map(row).collect()
}
