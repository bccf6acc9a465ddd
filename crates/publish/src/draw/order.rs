//! The order in which faces are painted, from the far ones to the near ones.
//!
//! *Two faces.* Face B is behind A if some line of sight meets A before B. The part of B that A overlaps in
//! the projection is a convex polygon. The depth of B under A's plane is an affine function on it, so its
//! signs at the corners decide. *All faces.* Faces with nothing behind them that is not yet painted are
//! painted; faces before which there is nothing are left for the end. The remaining faces contain cycles,
//! or cross. A binary space partition cuts them, after which there are no cycles and no crossings.
//! Everything is exact, so no figure has a face before one that covers it.

use super::polygon::{Face, Plane, Point, cut};
use acutile_exact::number::Number;

/// A face or a part of one.
#[derive(Clone, Debug)]
pub struct Piece {
    /// The index of the face.
    pub face: usize,
    /// In cyclic order.
    pub corners: Vec<Point>,
}

/// No figure has more pieces: n faces that all cross may have n³.
pub const PIECE_LIMIT: usize = 20_000;

/// All faces, cut where that is needed, such that no piece is before a point of a later one. `None` beyond [`PIECE_LIMIT`].
pub fn painted(faces: &[Face]) -> Option<Vec<Piece>> {
    let piece = |&face: &usize| Piece {
        face,
        corners: faces[face].corners.clone(),
    };
    let behind = relation(faces);
    let mut before = vec![Vec::new(); faces.len()];
    for (near, list) in behind.iter().enumerate() {
        list.iter().for_each(|&far| before[far].push(near));
    }
    let mut rest = vec![true; faces.len()];
    let far = peeled(&mut rest, &behind, &before);
    let mut near = peeled(&mut rest, &before, &behind);
    near.reverse();
    let core: Vec<usize> = (0..faces.len()).filter(|&i| rest[i]).collect();
    let mut pieces: Vec<Piece> = far.iter().map(piece).collect();
    partition(faces, core.iter().map(piece).collect(), &mut pieces)?;
    pieces.extend(near.iter().map(piece));
    Some(pieces)
}

/// For each face those of which a part is behind it.
fn relation(faces: &[Face]) -> Vec<Vec<usize>> {
    let mut behind = vec![Vec::new(); faces.len()];
    for i in 0..faces.len() {
        for j in i + 1..faces.len() {
            if faces[i].is_beside(faces[j].extent()) {
                continue;
            }
            let Some(overlap) = faces[i].overlap(&faces[j].corners) else {
                continue;
            };
            let depths = overlap.iter().map(|p| faces[i].plane.value(p));
            let signs: Vec<_> = depths.map(|depth| depth.sign()).collect();
            if signs.iter().any(|s| s.is_lt()) {
                behind[i].push(j);
            }
            if signs.iter().any(|s| s.is_gt()) {
                behind[j].push(i);
            }
        }
    }
    behind
}

/// Takes from `rest`, in order, whatever has no more predecessor in it.
fn peeled(rest: &mut [bool], before: &[Vec<usize>], after: &[Vec<usize>]) -> Vec<usize> {
    let mut waiting: Vec<usize> = before
        .iter()
        .map(|list| list.iter().filter(|&&i| rest[i]).count())
        .collect();
    let mut ready: Vec<usize> = (0..rest.len())
        .filter(|&i| rest[i] && waiting[i] == 0)
        .collect();
    let mut done = 0;
    while done < ready.len() {
        let face = ready[done];
        done += 1;
        rest[face] = false;
        // Others were taken earlier, from the other end.
        for &next in after[face].iter().filter(|&&next| rest[next]) {
            waiting[next] -= 1;
            if waiting[next] == 0 {
                ready.push(next);
            }
        }
    }
    ready
}

/// Appends the pieces, cut by each other's planes, from the far to the near. It ends: the face
/// whose plane cuts is on neither side of it.
fn partition(faces: &[Face], pieces: Vec<Piece>, painted: &mut Vec<Piece>) -> Option<()> {
    let Some(plane) = best_plane(faces, &pieces) else {
        return Some(());
    };
    if painted.len() + pieces.len() > PIECE_LIMIT {
        return None;
    }
    let (mut far, mut within, mut near) = (Vec::new(), Vec::new(), Vec::new());
    for piece in pieces {
        let parts = cut(&piece.corners, plane);
        if parts.positive.is_none() && parts.negative.is_none() {
            within.push(piece);
            continue;
        }
        let face = piece.face;
        near.extend(parts.positive.map(|corners| Piece { face, corners }));
        far.extend(parts.negative.map(|corners| Piece { face, corners }));
    }
    partition(faces, far, painted)?;
    painted.extend(within);
    partition(faces, near, painted)
}

/// How many planes are tried.
const TRIED: usize = 12;

/// Of the planes of the first pieces the first one that cuts the fewest.
fn best_plane<'f>(faces: &'f [Face], pieces: &[Piece]) -> Option<&'f Plane> {
    let planes = pieces.iter().take(TRIED).map(|p| &faces[p.face].plane);
    planes.min_by_key(|plane| {
        let is_cut = |piece: &&Piece| {
            let signs = piece.corners.iter().map(|p| plane.value(p));
            let signs: Vec<_> = signs.map(|value: Number| value.sign()).collect();
            signs.iter().any(|s| s.is_lt()) && signs.iter().any(|s| s.is_gt())
        };
        pieces.iter().filter(is_cut).count()
    })
}
