//! The system of patches of a certificate.

use super::{Patch, Pyramid, System, Theorem, Tile};
use crate::format::patches as format;
use crate::format::{self as formats};
use crate::proved::NotProved;
use crate::refusal::Refused;
use crate::tiling::Corner;
use crate::transcribe::{Numbers, ReadError};
use acutile_exact::number::Number;
use acutile_kernel::{Limits, verify};
use malachite::Integer;

impl Theorem {
    /// Asks the kernel about a certificate in either encoding, and reads its system.
    ///
    /// # Errors
    /// The kernel's refusal, or numbers that cannot be read.
    pub fn of_certificate(bytes: &[u8], limits: &Limits) -> Result<(Theorem, System), NotProved> {
        let cbor = formats::to_cbor(bytes).map_err(NotProved::Json)?;
        let verified = verify(&mut &cbor[..], limits)
            .map_err(|refusal| NotProved::Unconfirmed(Refused::of_file(bytes, &cbor, refusal)))?;
        let read = format::certificate(&cbor)
            .map_err(|error| NotProved::Unreadable(ReadError::Cbor(error)))?;
        let numbers = Numbers::of(&read.claim.field).map_err(NotProved::Unreadable)?;
        let statements = read.claim.statements.iter().map(|s| numbers.statement(s));
        let theorem = Theorem {
            statements: statements
                .collect::<Result<_, _>>()
                .map_err(NotProved::Unreadable)?,
            certificate: cbor.into_owned(),
            verified,
        };
        Ok((theorem, system(&read, numbers)))
    }
}

fn system(read: &format::Certificate, numbers: Numbers) -> System {
    let one = Integer::from(1);
    let gram = std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            let (low, high) = (i.min(j), i.max(j));
            numbers.number(&read.claim.gram[low][high - low], &one)
        })
    });
    let tiles = read.claim.tiles.iter().zip(&read.witness);
    System {
        gram,
        rank: read.claim.rank,
        tiles: tiles
            .map(|(tile, patch)| Tile {
                corners: rows(&numbers, &tile.vertices, &tile.denominator),
                classes: tile.classes.clone(),
                patch: self::patch(&numbers, patch),
            })
            .collect(),
        field: numbers.field,
    }
}

fn rows(
    numbers: &Numbers,
    rows: &[Vec<formats::Number>],
    denominator: &Integer,
) -> Vec<Vec<Number>> {
    let row = |row: &Vec<formats::Number>| {
        let values = row.iter().map(|x| numbers.number(x, denominator));
        values.collect()
    };
    rows.iter().map(row).collect()
}

fn patch(numbers: &Numbers, read: &format::Patch) -> Patch {
    let vertices = rows(numbers, &read.vertices, &read.denominator);
    Patch {
        offsets: rows(numbers, &read.offsets, &read.denominator),
        // The kernel has counted the coordinates.
        vertices: vertices
            .into_iter()
            .filter_map(|vertex| vertex.try_into().ok())
            .collect(),
        simplices: read
            .simplices
            .iter()
            .map(|row| row.each_ref().map(corner))
            .collect(),
        pyramids: read
            .pyramids
            .iter()
            .map(|pyramid| Pyramid {
                apex: corner(&pyramid.apex),
                polygon: pyramid.polygon.iter().map(corner).collect(),
            })
            .collect(),
    }
}

fn corner(corner: &formats::Corner) -> Corner<3> {
    Corner {
        vertex: corner.vertex.into(),
        shift: corner.shift,
    }
}
