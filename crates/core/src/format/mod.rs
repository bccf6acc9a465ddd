//! Certificate format 2 as plain data, its two encodings, and the way between them.
//!
//! | file | contains |
//! |---|---|
//! | this one | [`Certificate`], [`Claim`], [`Witness`] and their parts |
//! | [`family`] | polynomials, parameters and trees in their place |
//! | [`cbor`] | items of CBOR: heads, integers, texts, arrays |
//! | [`write`](mod@write) | the data in CBOR, in one pass |
//! | [`read`] | CBOR into the data |
//! | [`patches`] | the same for certificates of the kind `patches` |
//! | [`json`] | JSON into CBOR, with the check that it is canonical |
//! | `json_error` | why JSON is no certificate |
//! | [`mod@print`] | CBOR into JSON; the claim file |
//! | [`recognise`] | one function that distinguishes the encodings |
//!
//! CBOR is the certificate: its digest is the certificate's digest. JSON is the same data for
//! people. The typed writer and reader know CBOR only; JSON is transcribed, item by item.
//!
//! This module neither computes nor judges. The kernel decides whether a certificate proves its claim.
//! It leaves out the tiling: `transcribe` makes a certificate from one, and back.

pub mod cbor;
pub mod family;
pub mod json;
mod json_error;
pub mod patches;
pub mod print;
pub mod read;
mod recognise;
pub mod write;

pub use recognise::{Encoding, kind, recognise, to_cbor, version};

use malachite::Integer;
use malachite::base::num::arithmetic::traits::Gcd;

/// The first member of every certificate.
pub const FORMAT: &str = "acutile-certificate";
/// The first member of a claim file.
pub const CLAIM_FORMAT: &str = "acutile-claim";
/// The second member of both.
pub const VERSION: u64 = 2;
/// The third member: the claim is about one tiling.
pub const KIND: &str = "tiling";
/// The third member: the claim is about all members of a family.
pub const FAMILY: &str = "family";
/// All kinds.
pub const KINDS: [&str; 3] = [KIND, FAMILY, patches::KIND];

/// A claim and the witness for it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Certificate {
    /// The statement that is proved. It alone decides what "verified" means.
    pub claim: Claim,
    /// The data that anybody needs to check it.
    pub witness: Witness,
}

/// There is a tiling of `domain`, periodic under the lattice, for which all `statements` hold.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Claim<V = Number> {
    /// D: 2 or 3.
    pub dimension: usize,
    /// The field of all numbers.
    pub field: Field,
    /// The upper triangle, by rows, of a matrix that is proportional to the inner products of
    /// the basis vectors b_1 … b_D. Its coefficients have no common divisor.
    pub gram: Vec<Vec<V>>,
    /// The set that is tiled. It determines the rank of the lattice.
    pub domain: Domain<V>,
    /// In the order of [`Statement`]; the first is the tiling itself.
    pub statements: Vec<Statement>,
}

impl<V> Claim<V> {
    /// The rank r of the lattice, which b_1 … b_r span.
    pub fn rank(&self) -> usize {
        self.domain.rank(self.dimension)
    }
}

/// An ordered field inside the real numbers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Field {
    /// Q
    Rationals,
    /// Q(a)
    Algebraic(AlgebraicField),
}

impl Field {
    /// The number of coefficients of a [`Number`].
    pub fn degree(&self) -> usize {
        match self {
            Field::Rationals => 1,
            Field::Algebraic(field) => field.polynomial.len() - 1,
        }
    }
}

/// Q(a) for the only root a of a monic polynomial between two fractions.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AlgebraicField {
    /// Coefficients, the constant term first, the last one 1; at least three.
    pub polynomial: Vec<Integer>,
    /// The lower end of the interval is `low` / `denominator`.
    pub low: Integer,
    /// The upper end is `high` / `denominator`.
    pub high: Integer,
    /// Positive.
    pub denominator: Integer,
}

/// An element of `Z[a]`: the coefficients of 1, a, …, a^(n-1), as many as the field's degree.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Number(pub Vec<Integer>);

/// An element of the field, in lowest terms.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Fraction {
    /// The coefficients of the numerator.
    pub numerator: Number,
    /// Positive.
    pub denominator: Integer,
}

/// The set that is tiled. It is all of D-space, or the union of the simplices. Or it is a convex polytope P
/// of dimension k in the last k coordinates, times the span of the first r = D - k basis vectors.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Domain<V = Number> {
    /// k = 0, r = D
    Space,
    /// k = 1, r = D - 1
    Slab(Polytope<V>),
    /// k = 2, r = 1, only for D = 3
    Prism(Polytope<V>),
    /// k = D, r = 0
    Solid(Polytope<V>),
    /// The union of the simplices and their translates by a lattice of this rank.
    Region(usize),
}

impl<V> Domain<V> {
    /// The rank of the lattice in dimension `dimension`.
    pub fn rank(&self, dimension: usize) -> usize {
        match self {
            Domain::Space => dimension,
            Domain::Slab(_) => dimension - 1,
            Domain::Prism(_) => 1,
            Domain::Solid(_) => 0,
            Domain::Region(rank) => *rank,
        }
    }

    /// The polytope, if the domain has one.
    pub fn polytope(&self) -> Option<&Polytope<V>> {
        match self {
            Domain::Space | Domain::Region(_) => None,
            Domain::Slab(polytope) | Domain::Prism(polytope) | Domain::Solid(polytope) => {
                Some(polytope)
            }
        }
    }
}

/// A convex polytope of dimension k = 1, 2 or 3.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Polytope<V = Number> {
    /// Positive; coordinates are numerators over it.
    pub denominator: Integer,
    /// k numerators each.
    pub vertices: Vec<Vec<V>>,
    /// The facets by the indices of their vertices. There is one index for k = 1. There are the ends of a
    /// side for k = 2, and the corners of a face in cyclic order for k = 3.
    pub faces: Vec<Vec<u32>>,
}

/// A statement about the tiling. The order of the variants is the order in a claim.
///
/// The bounds are about three quantities of a simplex: the largest of its dihedral angles, the
/// smallest, and R² / l² for the circumradius R and the shortest edge l.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Statement {
    /// The translates of the simplices cover the domain, their interiors are disjoint, and any
    /// two meet in a common face or not at all.
    FaceToFaceTiling,
    /// Every dihedral angle is less than a right angle.
    Acute,
    /// No dihedral angle is more than a right angle.
    Nonobtuse,
    /// About the largest dihedral angle of each simplex.
    LargestAngle(Relation, Cosine),
    /// About the smallest dihedral angle of each simplex.
    SmallestAngle(Relation, Cosine),
    /// About the squared radius-edge ratio of each simplex.
    SquaredRatio(Relation, Fraction),
    /// No simplex crosses the plane or a translate of it by the lattice.
    UncrossedPlane(Plane),
    /// No vertex lies in the closed circumball of a simplex but its own corners.
    Delaunay,
    /// No vertex lies in the open circumball of a simplex.
    WeaklyDelaunay,
    /// For regions: at each facet that two simplices share, the opposite corner of one lies
    /// outside of the circumsphere of the other.
    LocallyDelaunay,
    /// The same, and the corner may lie on the circumsphere.
    LocallyWeaklyDelaunay,
    /// Some vertex lies in the open circumball of a simplex.
    NotDelaunay,
    /// D = 3, all of space: every edge is in 5 or 6 tetrahedra, and no triangle has two edges
    /// that are in 6.
    Tcp,
}

/// The points x with normal · x = offset / denominator, in basis coordinates.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Plane {
    /// D integers with the greatest common divisor 1; the first one that is not zero is positive.
    pub normal: Vec<i32>,
    /// The plane is normal · x = offset.
    pub offset: Integer,
    /// Positive; without a common divisor with the offset.
    pub denominator: Integer,
}

impl Plane {
    /// Whether the entries of the normal are as a certificate has them.
    pub fn is_canonical(&self) -> bool {
        let divisor = self
            .normal
            .iter()
            .fold(0, |gcd: u32, c| gcd.gcd(c.unsigned_abs()));
        let is_short = self
            .normal
            .iter()
            .all(|c| c.unsigned_abs() < Self::MOST_ENTRY);
        is_short && divisor == 1 && self.normal.iter().find(|c| **c != 0) > Some(&0)
    }

    /// The entries of normals are smaller in size.
    pub const MOST_ENTRY: u32 = 1 << 29;
}

/// How the quantity q of each simplex compares with the bound B. In the order of a claim.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Relation {
    /// q < B for all.
    LessThan,
    /// q <= B for all.
    AtMost,
    /// q <= B for all, and q = B for one.
    Maximum,
    /// q > B for all.
    MoreThan,
    /// q >= B for all.
    AtLeast,
    /// q >= B for all, and q = B for one.
    Minimum,
}

impl Relation {
    /// All relations, in order.
    pub const ALL: [Relation; 6] = [
        Relation::LessThan,
        Relation::AtMost,
        Relation::Maximum,
        Relation::MoreThan,
        Relation::AtLeast,
        Relation::Minimum,
    ];

    /// The text in a certificate.
    pub fn text(self) -> &'static str {
        match self {
            Relation::LessThan => "less than",
            Relation::AtMost => "at most",
            Relation::Maximum => "maximum",
            Relation::MoreThan => "more than",
            Relation::AtLeast => "at least",
            Relation::Minimum => "minimum",
        }
    }
}

/// The angle arccos(sign √square) between 0 and 180 degrees.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Cosine {
    /// -1, 0 or 1; 0 exactly if the square is 0.
    pub sign: i8,
    /// Between 0 and 1.
    pub square: Fraction,
}

/// A vertex moved by a lattice vector.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Corner {
    /// Index into [`Witness::vertices`].
    pub vertex: u32,
    /// The coordinates of the lattice vector; 0 beyond the rank.
    pub shift: [i32; 3],
}

/// The tiling: one simplex for each orbit of the lattice.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Witness {
    /// Positive; coordinates are numerators over it.
    pub denominator: Integer,
    /// D numerators each.
    pub vertices: Vec<Vec<Number>>,
    /// D corners for each facet, one facet after the other; only for regions.
    pub boundary: Vec<Corner>,
    /// D + 1 corners for each simplex, one simplex after the other.
    pub simplices: Vec<Corner>,
    /// For each simplex the bits of the edges of valence 6, if TCP is claimed; else empty.
    pub sixes: Vec<u8>,
}
