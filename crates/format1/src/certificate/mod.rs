//! The certificate as passive data: what is claimed, and the witness for it.
//!
//! This room knows serde and nothing else. It neither computes nor judges: the
//! prover's room `checker` writes certificates, the kernel
//! ([`crate::verifier`]) reads them, and both share this description and the
//! canonical bytes, in JSON ([`to_bytes`]) and in CBOR ([`cbor`]). The grammar is
//! docs/format.md.
//!
//! Numbers are text here. A [`Number`] holds the coefficients c_0, c_1, … of
//! c_0 + c_1 a + c_2 a² + …, where a is the generator of the claim's field.

mod canonical;
pub mod cbor;

use serde::de::{self, SeqAccess, Visitor};
use serde::ser::SerializeSeq;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::fmt;

pub use canonical::to_bytes;
pub(crate) use canonical::to_writer;

/// The only value of [`Certificate::format`].
pub const FORMAT: &str = "acutile-certificate";
/// The only value of [`Certificate::version`].
pub const VERSION: u64 = 1;

/// A claim and the data from which anybody can re-check it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Certificate {
    /// Always [`FORMAT`].
    pub format: String,
    /// Always [`VERSION`].
    pub version: u64,
    /// What is proved. It alone decides what "verified" means.
    pub claim: Claim,
    /// Why it is true.
    pub witness: Witness,
}

/// What a certificate proves: there is a tiling of `domain`, periodic under the
/// lattice, for which every one of `statements` holds.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Claim {
    /// The dimension D of the space: 2 or 3.
    pub dimension: usize,
    /// The field in which all numbers of the certificate live.
    pub field: Field,
    /// The Gram matrix of the basis, D rows of D: the inner products of the
    /// basis vectors. Everything metric follows from it.
    pub gram: Vec<Vec<Number>>,
    /// What is tiled; it determines the rank of the lattice, which is spanned
    /// by the first `rank` basis vectors.
    pub domain: Domain,
    /// The statements proved, each at most once, in the order of [`Statement`];
    /// the first is always [`Statement::FaceToFaceTiling`].
    pub statements: Vec<Statement>,
}

/// An ordered field inside the real numbers.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Field {
    /// The rational numbers.
    #[serde(rename = "Q")]
    Rationals,
    /// Q(a) for the root a of an integer polynomial in an interval.
    #[serde(rename = "Q(a)")]
    Algebraic(AlgebraicField),
}

/// Q(a): `polynomial` is monic, of degree at least two, integer coefficients
/// from the constant term up; it has exactly one root a in the open interval
/// `root` with rational ends, and its derivative has no zero there.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct AlgebraicField {
    /// Integer coefficients, constant term first, the last one `"1"`.
    pub polynomial: Vec<String>,
    /// Lower and upper end of the isolating interval.
    pub root: (String, String),
}

/// What is tiled: all of space, or a convex polytope P of dimension k in the last
/// k coordinates times the span of the first r = D - k basis vectors, which
/// generate the lattice; or whatever the simplices fill.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Domain {
    /// All of D-space; k = 0, r = D.
    #[serde(rename = "space")]
    Space,
    /// Between two parallel hyperplanes: k = 1, r = D - 1.
    #[serde(rename = "slab")]
    Slab(Polytope),
    /// A convex polygon times a line, only for D = 3: k = 2, r = 1.
    #[serde(rename = "prism")]
    Prism(Polytope),
    /// A convex polygon or polyhedron: k = D, r = 0.
    #[serde(rename = "solid")]
    Solid(Polytope),
    /// The union of the simplices, only for D = 3: r = 0.
    #[serde(rename = "region")]
    Region,
}

/// A convex polytope of dimension 1, 2 or 3.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Polytope {
    /// k coordinates each.
    pub vertices: Vec<Vec<Number>>,
    /// The facets of the polytope by the indices of their vertices: for k = 1 one
    /// index, for k = 2 the two ends of a side, for k = 3 the corners of a face in
    /// cyclic order.
    pub faces: Vec<Vec<usize>>,
}

impl Domain {
    /// The rank of the lattice in dimension `dimension`.
    pub fn rank(&self, dimension: usize) -> usize {
        match self {
            Domain::Space => dimension,
            Domain::Slab(_) => dimension - 1,
            Domain::Prism(_) => 1,
            Domain::Solid(_) | Domain::Region => 0,
        }
    }

    /// The polytope, if the domain has one.
    pub fn polytope(&self) -> Option<&Polytope> {
        match self {
            Domain::Space | Domain::Region => None,
            Domain::Slab(polytope) | Domain::Prism(polytope) | Domain::Solid(polytope) => {
                Some(polytope)
            }
        }
    }
}

/// One proved statement about the tiling. The order of the variants is the
/// order in which a claim lists them.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub enum Statement {
    /// The translates of the simplices cover the domain, their interiors are
    /// disjoint, and any two meet in a common face or not at all.
    #[serde(rename = "face-to-face tiling")]
    FaceToFaceTiling,
    /// Every dihedral angle is less than a right angle.
    #[serde(rename = "acute")]
    Acute,
    /// No dihedral angle is more than a right angle.
    #[serde(rename = "nonobtuse")]
    Nonobtuse,
    /// Every dihedral angle is less than this rational number of degrees.
    #[serde(rename = "all dihedral angles below")]
    DihedralBelow(String),
    /// Every dihedral angle is more than this rational number of degrees.
    #[serde(rename = "all dihedral angles above")]
    DihedralAbove(String),
    /// In every simplex the circumradius is less than this rational number times the
    /// shortest edge.
    #[serde(rename = "all radius-edge ratios below")]
    RadiusEdgeBelow(String),
    /// The open circumball of every simplex holds no vertex, and no vertex but
    /// its own lies on the circumsphere.
    #[serde(rename = "Delaunay")]
    Delaunay,
    /// The open circumball of every simplex holds no vertex.
    #[serde(rename = "weakly Delaunay")]
    WeaklyDelaunay,
    /// Tetrahedrally close packed (D = 3, all of space): every edge is in 5 or 6
    /// tetrahedra, and no triangle has two edges that are in 6 (Sullivan 1999).
    #[serde(rename = "TCP")]
    Tcp,
}

/// The tiling itself, one simplex per lattice orbit, and hints for checking it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Witness {
    /// D coordinates each, in the basis.
    pub vertices: Vec<Vec<Number>>,
    /// D + 1 corners each, positively oriented in basis coordinates.
    pub simplices: Vec<Vec<Place>>,
    /// `mates[s][i]` for the facet of simplex s opposite to its corner i.
    pub mates: Vec<Vec<Mate>>,
}

/// A corner `[v, s_1, …, s_r]`: vertex v moved by the lattice vector
/// s_1 b_1 + … + s_r b_r.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(transparent)]
pub struct Place(pub Vec<i64>);

/// A facet's mate `[t, j, u_1, …, u_r]`: the facet opposite to corner j of
/// simplex t, moved by the lattice vector u, is the facet itself. Or `[f]`: the
/// facet lies in face f of the domain's polytope. Or `[]`: it lies in the boundary of
/// the region.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(transparent)]
pub struct Mate(pub Vec<i64>);

impl AsRef<[i64]> for Place {
    fn as_ref(&self) -> &[i64] {
        &self.0
    }
}

impl AsRef<[i64]> for Mate {
    fn as_ref(&self) -> &[i64] {
        &self.0
    }
}

/// An element of the claim's field: the coefficients of the powers of the
/// generator, without trailing zeros, at least one.
///
/// In JSON a rational is a string, `"3/4"`; any other number is an array of at
/// least two of them, the last one not zero: `["1/2", "1/2"]` is (1 + a)/2.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Number(pub Vec<String>);

impl Serialize for Number {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        if let [rational] = self.0.as_slice() {
            return serializer.serialize_str(rational);
        }
        let mut array = serializer.serialize_seq(Some(self.0.len()))?;
        for coefficient in &self.0 {
            array.serialize_element(coefficient)?;
        }
        array.end()
    }
}

impl<'de> Deserialize<'de> for Number {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(NumberVisitor)
    }
}

struct NumberVisitor;

impl<'de> Visitor<'de> for NumberVisitor {
    type Value = Number;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("a number: a string like \"3/4\", or an array of such strings")
    }

    fn visit_str<E: de::Error>(self, text: &str) -> Result<Number, E> {
        Ok(Number(vec![text.to_owned()]))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut array: A) -> Result<Number, A::Error> {
        let mut coefficients = Vec::new();
        while let Some(coefficient) = array.next_element()? {
            coefficients.push(coefficient);
        }
        Ok(Number(coefficients))
    }
}
