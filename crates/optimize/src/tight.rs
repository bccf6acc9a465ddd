//! Exact multipliers that prove that a tiling is a strict local optimum.
//!
//! Let a_k be the gradients of the cosines of the tight angles, those with the extreme value. If positive
//! m_k exist with Σ m_k a_k = 0, then each motion d that is not orthogonal to all a_k lowers some cosine
//! and raises another one at first order. If the a_k have full rank but for translations, every other
//! motion is such a motion. So the largest angle grows, and the smallest one falls, along every motion.
//!
//! With Q the inverse of the inner products of the edges, c² = Q_ij² / (Q_ii Q_jj). The logarithm gives
//! dc = c (dQ_ij / Q_ij - dQ_ii / 2 Q_ii - dQ_jj / 2 Q_jj), which is in the field but for the common factor
//! c; for a right angle dc is a positive multiple of -dQ_ij. Multipliers absorb such factors.

use crate::group::Group;
use crate::moves::{ENTRIES, Moves};
use crate::program::{Row, best_step};
use crate::value::Extreme;
use acutile_core::quality::DihedralAngle;
use acutile_core::tiling::{SimplexId, Tiling};
use acutile_exact::geometry::space::{null_space, rank};
use acutile_exact::geometry::{Sign, linear};
use acutile_exact::number::Number;
use malachite::Integer;
use malachite::Rational;
use malachite::base::num::conversion::traits::RoundingFrom;
use malachite::base::rounding_modes::RoundingMode;
use std::fmt;

/// A proof of strict local optimality.
#[derive(Clone, Debug)]
pub struct LocalProof {
    /// The tight angles: a simplex of each orbit, and two of its facets.
    pub tight: Vec<(SimplexId, (usize, usize))>,
    /// One positive multiplier for each of them.
    pub multipliers: Vec<Number>,
    /// The rank of the gradients.
    pub rank: usize,
    /// The dimension of the space of motions.
    pub parameters: usize,
    /// The dimension of the motions that only translate.
    pub translations: usize,
}

/// Why local optimality is not proved. It is not refuted.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NotLocal {
    /// The goal is a ratio.
    NoAngle,
    /// The gradients have too small a rank: there may be a motion that changes no tight angle.
    Rank {
        /// The rank that was found.
        rank: usize,
        /// The rank that would suffice.
        needed: usize,
    },
    /// No positive multipliers were found.
    NoMultipliers {
        /// The number of tight angles.
        tight: usize,
    },
}

type Matrix = [[Number; 3]; 3];

/// Denominators of multipliers, in the order of trial.
const DENOMINATORS: [i64; 6] = [1, 2, 6, 60, 1_000, 1_000_000];

/// Proves that no small motion improves the extreme angle of a tiling.
///
/// # Errors
/// The missing part of a proof.
pub fn prove_local(
    tiling: &Tiling<3>,
    moves: &Moves,
    group: &Group,
    extreme: &Extreme,
) -> Result<LocalProof, NotLocal> {
    let (Extreme::LargestAngle(angle) | Extreme::SmallestAngle(angle)) = extreme else {
        return Err(NotLocal::NoAngle);
    };
    let tight = tight(tiling, group, angle);
    let rows: Vec<Vec<Number>> = tight
        .iter()
        .filter_map(|(simplex, pair)| gradient(tiling, moves, *simplex, *pair))
        .collect();
    let parameters = moves.len();
    let translations = translations(moves);
    let needed = parameters - translations;
    let rank = rank(rows.clone(), parameters);
    if rank < needed {
        return Err(NotLocal::Rank { rank, needed });
    }
    let columns: Vec<Vec<Number>> = (0..parameters)
        .map(|k| rows.iter().map(|row| row[k].clone()).collect())
        .collect();
    let multipliers =
        positive(columns, rows.len()).ok_or(NotLocal::NoMultipliers { tight: rows.len() })?;
    Ok(LocalProof {
        tight,
        multipliers,
        rank,
        parameters,
        translations,
    })
}

/// The angles with exactly this value, in one simplex of each orbit.
fn tight(
    tiling: &Tiling<3>,
    group: &Group,
    angle: &DihedralAngle,
) -> Vec<(SimplexId, (usize, usize))> {
    let cogram = linear::cofactors(&tiling.frame.gram);
    let mut tight = Vec::new();
    for simplex in group.representatives(tiling) {
        let products = tiling.shape(simplex).normal_products(&cogram);
        for (i, j) in (0..4).flat_map(|i| (i + 1..4).map(move |j| (i, j))) {
            if DihedralAngle::between(&products, i, j).as_ref() == Some(angle) {
                tight.push((simplex, (i, j)));
            }
        }
    }
    tight
}

/// A positive multiple of the gradient of the cosine of an angle with respect to the parameters. `None` for
/// a flat simplex, which a proved tiling does not have.
fn gradient(
    tiling: &Tiling<3>,
    moves: &Moves,
    simplex: SimplexId,
    pair: (usize, usize),
) -> Option<Vec<Number>> {
    let edges = tiling.shape(simplex).edges;
    let gram = &tiling.frame.gram;
    let w = of_products(&edges, gram, pair)?;
    let image = product(&w, &edges);
    let by_edge = product(&image, gram);
    let two = Number::from(Rational::from(2));
    let mut gradient = vec![Number::zero(); moves.len()];
    for (corner, place) in tiling.simplex(simplex).iter().zip(0..) {
        let slope: [Number; 3] = std::array::from_fn(|k| match place {
            0 => -(&by_edge[0][k] + &by_edge[1][k] + &by_edge[2][k]),
            _ => by_edge[place - 1][k].clone(),
        });
        for (parameter, vector) in &moves.vertices[corner.vertex.index()].terms {
            let change = linear::dot(&slope, vector) * &two;
            gradient[*parameter] = &gradient[*parameter] + &change;
        }
    }
    let by_gram = product(&transposed(&edges), &image);
    for (parameter, vector) in &moves.gram.terms {
        for ((i, j), v) in ENTRIES.into_iter().zip(vector) {
            let once = &by_gram[i][j] * v;
            let change = if i == j { once } else { once * &two };
            gradient[*parameter] = &gradient[*parameter] + &change;
        }
    }
    Some(gradient)
}

/// W with dc = Σ W_kl dP_kl up to a positive factor, as dQ_ij = -q_i^T dP q_j for q_i = Q u_i.
fn of_products(edges: &Matrix, gram: &Matrix, (i, j): (usize, usize)) -> Option<Matrix> {
    let products = product(&product(edges, gram), &transposed(edges));
    let inverse = linear::determinant(&products).inverse()?;
    let q = linear::cofactors(&products).map(|row| row.map(|x| x * &inverse));
    let (u, v) = (covector(i), covector(j));
    let (a, b) = (linear::apply(&q, &u), linear::apply(&q, &v));
    let half = Number::from(Rational::from_signeds(1, 2));
    let mixed = |k: usize, l: usize| (&a[k] * &b[l] + &a[l] * &b[k]) * &half;
    let across = linear::dot(&u, &b);
    let Some(across_inverse) = across.inverse() else {
        return Some(filled(mixed));
    };
    let (own_a, own_b) = (
        linear::dot(&u, &a).inverse()?,
        linear::dot(&v, &b).inverse()?,
    );
    // c = -Q_ij / √(Q_ii Q_jj)
    let is_acute = across.sign() == Sign::Less;
    Some(filled(|k, l| {
        let own = &(&a[k] * &a[l]) * &own_a + &(&b[k] * &b[l]) * &own_b;
        let value = own * &half - mixed(k, l) * &across_inverse;
        if is_acute { value } else { -value }
    }))
}

/// The barycentric covector of a corner in the basis of the edges.
fn covector(corner: usize) -> [Number; 3] {
    std::array::from_fn(|k| {
        Number::from(Rational::from(match corner {
            0 => -1,
            _ => i32::from(corner == k + 1),
        }))
    })
}

/// The dimension of the motions that move all vertices by one vector and keep the lattice.
fn translations(moves: &Moves) -> usize {
    let columns = moves.len() + 3;
    let mut rows = Vec::new();
    for vertex in &moves.vertices {
        for k in 0..3 {
            let mut row = vec![Number::zero(); columns];
            for (parameter, vector) in &vertex.terms {
                row[*parameter] = vector[k].clone();
            }
            row[moves.len() + k] = Number::from(Rational::from(-1));
            rows.push(row);
        }
    }
    for (parameter, _) in &moves.gram.terms {
        let mut row = vec![Number::zero(); columns];
        row[*parameter] = Number::from(Rational::from(1));
        rows.push(row);
    }
    null_space(rows, columns).basis.len()
}

/// A solution of `rows` m = 0 with m > 0. Doubles propose it, exact signs decide.
fn positive(rows: Vec<Vec<Number>>, columns: usize) -> Option<Vec<Number>> {
    let space = null_space(rows, columns);
    let condition = |column: usize| Row {
        value: 0.0,
        gradient: space
            .basis
            .iter()
            .map(|vector| -vector[column].approximate())
            .enumerate()
            .collect(),
    };
    let conditions: Vec<Row> = (0..columns).map(condition).collect();
    let (point, _) = best_step(&conditions, space.basis.len(), 1.0)?;
    DENOMINATORS.into_iter().find_map(|denominator| {
        let mut sum = vec![Number::zero(); columns];
        for (x, vector) in point.iter().zip(&space.basis) {
            let (numerator, _) =
                Integer::rounding_from(x * denominator as f64, RoundingMode::Nearest);
            let factor = Number::from(Rational::from_integers(
                numerator,
                Integer::from(denominator),
            ));
            for (entry, v) in sum.iter_mut().zip(vector) {
                *entry = &*entry + &(&factor * v);
            }
        }
        sum.iter().all(|m| m.sign() == Sign::Greater).then_some(sum)
    })
}

fn filled(entry: impl Fn(usize, usize) -> Number) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)))
}

fn product(a: &Matrix, b: &Matrix) -> Matrix {
    filled(|i, j| {
        let terms = (0..3).map(|k| &a[i][k] * &b[k][j]);
        terms.fold(Number::zero(), |sum, term| sum + term)
    })
}

fn transposed(a: &Matrix) -> Matrix {
    filled(|i, j| a[j][i].clone())
}

impl fmt::Display for LocalProof {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(
            f,
            "strict local optimum: {} tight angles with positive multipliers whose gradients add up to 0; \
             their rank is {}, all of {} parameters but {} of translation",
            self.tight.len(),
            self.rank,
            self.parameters,
            self.translations
        )
    }
}

impl fmt::Display for NotLocal {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            NotLocal::NoAngle => write!(f, "found a goal about ratios, expected one about angles"),
            NotLocal::Rank { rank, needed } => write!(
                f,
                "the gradients of the tight angles have rank {rank}, expected {needed}; a rounded optimum \
                 has no tight angles"
            ),
            NotLocal::NoMultipliers { tight } => {
                write!(f, "no positive multipliers found for {tight} tight angles")
            }
        }
    }
}
