//! Writes a proved tiling as a certificate.

use super::domain::Boundary;
use crate::certificate::{
    self, Certificate, Claim, Domain, FORMAT, Number, Place, Polytope, Statement, VERSION, Witness,
};
use crate::number;
use crate::tiling::{self, Corner, Facet, Matching, Mate, Tiling};

/// The certificate of a tiling whose facets all have mates.
pub fn certificate<const D: usize>(
    tiling: &Tiling<D>,
    matching: &Matching<D>,
    boundary: &Boundary,
    statements: Vec<Statement>,
) -> Certificate {
    let frame = &tiling.frame;
    Certificate {
        format: FORMAT.to_owned(),
        version: VERSION,
        claim: Claim {
            dimension: D,
            field: frame.field.to_certificate(),
            gram: frame.gram.iter().map(|row| numbers(row)).collect(),
            domain: domain(&frame.domain),
            statements,
        },
        witness: Witness {
            vertices: tiling
                .vertices
                .iter()
                .map(|vertex| numbers(&vertex))
                .collect(),
            simplices: tiling
                .simplices()
                .map(|corners| places(corners, frame.rank()))
                .collect(),
            mates: mates(tiling, matching, boundary),
        },
    }
}

fn domain(domain: &tiling::Domain) -> Domain {
    match domain {
        tiling::Domain::Space => Domain::Space,
        tiling::Domain::Slab(polytope) => Domain::Slab(polytope_data(polytope)),
        tiling::Domain::Prism(polytope) => Domain::Prism(polytope_data(polytope)),
        tiling::Domain::Solid(polytope) => Domain::Solid(polytope_data(polytope)),
        tiling::Domain::Region => Domain::Region,
    }
}

fn polytope_data(polytope: &tiling::Polytope) -> Polytope {
    Polytope {
        vertices: polytope
            .vertices
            .iter()
            .map(|vertex| numbers(vertex))
            .collect(),
        faces: polytope.faces.clone(),
    }
}

fn numbers(numbers: &[number::Number]) -> Vec<Number> {
    numbers.iter().map(number::Number::to_certificate).collect()
}

fn places<const D: usize>(corners: &[Corner<D>], rank: usize) -> Vec<Place> {
    corners
        .iter()
        .map(|corner| Place(row(&[corner.vertex], &corner.shift[..rank])))
        .collect()
}

fn mates<const D: usize>(
    tiling: &Tiling<D>,
    matching: &Matching<D>,
    boundary: &Boundary,
) -> Vec<Vec<certificate::Mate>> {
    let row_of = |simplex: usize, opposite: usize| {
        if let Some(mate) = matching.mate(tiling, simplex, opposite) {
            return mate_row(&mate, tiling.frame.rank());
        }
        let facet = Facet {
            simplex: simplex as u32,
            opposite: opposite as u8,
        };
        let face = boundary.get(&facet);
        certificate::Mate(face.iter().map(|face| **face as i64).collect())
    };
    let rows = |simplex| {
        (0..=D)
            .map(move |opposite| row_of(simplex, opposite))
            .collect()
    };
    (0..tiling.len()).map(rows).collect()
}

fn mate_row<const D: usize>(mate: &Mate<D>, rank: usize) -> certificate::Mate {
    let Facet { simplex, opposite } = mate.facet;
    certificate::Mate(row(&[simplex, u32::from(opposite)], &mate.shift[..rank]))
}

fn row(indices: &[u32], shift: &[i32]) -> Vec<i64> {
    indices
        .iter()
        .map(|&k| i64::from(k))
        .chain(shift.iter().map(|&s| i64::from(s)))
        .collect()
}
