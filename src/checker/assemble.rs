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
                .map(|vertex| numbers(vertex))
                .collect(),
            simplices: tiling
                .simplices()
                .map(|corners| places(corners, frame.rank()))
                .collect(),
            mates: mates(matching, boundary, frame.rank()),
        },
    }
}

fn domain(domain: &tiling::Domain) -> Domain {
    match domain {
        tiling::Domain::Space => Domain::Space,
        tiling::Domain::Slab(polytope) => Domain::Slab(polytope_data(polytope)),
        tiling::Domain::Prism(polytope) => Domain::Prism(polytope_data(polytope)),
        tiling::Domain::Solid(polytope) => Domain::Solid(polytope_data(polytope)),
        // Certificates have no such domain; a polytope without faces is none.
        tiling::Domain::Region => Domain::Solid(Polytope {
            vertices: Vec::new(),
            faces: Vec::new(),
        }),
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
    matching: &Matching<D>,
    boundary: &Boundary,
    rank: usize,
) -> Vec<Vec<certificate::Mate>> {
    let row_of = |simplex: usize, opposite: usize, mate: &Option<Mate<D>>| match mate {
        Some(mate) => mate_row(mate, rank),
        None => {
            let facet = Facet {
                simplex: simplex as u32,
                opposite: opposite as u8,
            };
            certificate::Mate(
                boundary
                    .get(&facet)
                    .iter()
                    .map(|face| **face as i64)
                    .collect(),
            )
        }
    };
    let rows = matching.mates.chunks_exact(D + 1).enumerate();
    rows.map(|(s, mates)| {
        (0..)
            .zip(mates)
            .map(|(i, mate)| row_of(s, i, mate))
            .collect()
    })
    .collect()
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
