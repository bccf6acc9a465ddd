//! Writes a proved tiling as a certificate.

use crate::certificate::{
    self, Certificate, Claim, Domain, FORMAT, Number, Place, Statement, VERSION, Witness,
};
use crate::number;
use crate::tiling::{self, Corner, Facet, Matching, Mate, Tiling};

/// The certificate of a tiling whose facets all have mates.
pub fn certificate<const D: usize>(
    tiling: &Tiling<D>,
    matching: &Matching<D>,
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
            mates: mates(matching, frame.rank()),
        },
    }
}

fn domain(domain: &tiling::Domain) -> Domain {
    match domain {
        tiling::Domain::Space => Domain::Space,
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

fn mates<const D: usize>(matching: &Matching<D>, rank: usize) -> Vec<Vec<certificate::Mate>> {
    matching
        .mates
        .chunks_exact(D + 1)
        .map(|facets| {
            facets
                .iter()
                .flatten()
                .map(|mate| mate_row(mate, rank))
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
