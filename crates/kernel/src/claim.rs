//! The claim of a certificate: everything that "verified" means, and nothing else.
//!
//! This module reads a claim and checks lengths, ranges, order and lowest terms. The statements
//! about its numbers are checked in [`crate::root`], [`crate::rules`] and [`crate::domain`].

use crate::cbor::Cbor;
use crate::limits::{Limits, MAX_DEGREE};
use crate::refusal::{Checked, Value};
use num_bigint::BigInt;
use num_integer::Integer;

/// A number of the field: its coefficients of 1, a, …, a^(n-1).
pub type Number = Vec<BigInt>;

#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Claim {
    /// 2 or 3.
    pub dimension: usize,
    pub field: Field,
    /// The upper triangle of the Gram matrix, row by row; primitive.
    pub gram: Vec<Number>,
    pub domain: Domain,
    /// The first one is [`Property::FaceToFace`].
    pub statements: Vec<Statement>,
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Field {
    Rational,
    /// The field of the only root between low/denominator and high/denominator.
    Algebraic {
        /// Coefficients of 1, x, …, x^n; the last one is 1.
        polynomial: Vec<BigInt>,
        low: BigInt,
        high: BigInt,
        denominator: BigInt,
    },
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Domain {
    Space,
    /// A polytope P in the last k coordinates, times the span of the lattice: a slab for k = 1,
    /// a solid for k = D, else a prism.
    Polytope(Polytope),
    /// The union of the simplices, for a lattice of this rank.
    Region(usize),
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Polytope {
    pub denominator: BigInt,
    /// k coordinates each, times the denominator.
    pub vertices: Vec<Vec<Number>>,
    /// The vertices of each facet of P.
    pub faces: Vec<Vec<usize>>,
}

/// A property of all simplices; with a bound for the quantities.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Statement {
    pub property: Property,
    pub bound: Option<Bound>,
}

/// The square root of the fraction, with the sign, is the cosine of a bound for angles. For squared
/// ratios the sign is 1, and the fraction is the bound.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Bound {
    pub relation: Relation,
    pub sign: i64,
    pub numerator: Number,
    pub denominator: BigInt,
}

texts! {
    /// In the order of the grammar.
    Property {
        FaceToFace "face-to-face tiling",
        Acute "acute",
        Nonobtuse "nonobtuse",
        LargestAngle "largest dihedral angle",
        SmallestAngle "smallest dihedral angle",
        SquaredRatio "squared radius-edge ratio",
        Delaunay "Delaunay",
        WeaklyDelaunay "weakly Delaunay",
        LocallyDelaunay "locally Delaunay",
        LocallyWeaklyDelaunay "locally weakly Delaunay",
        Tcp "TCP",
    }
}

texts! {
    /// How a quantity of every simplex compares with a bound; some simplex attains a maximum or a
    /// minimum.
    Relation {
        LessThan "less than",
        AtMost "at most",
        Maximum "maximum",
        MoreThan "more than",
        AtLeast "at least",
        Minimum "minimum",
    }
}

impl Property {
    pub fn is_angle(self) -> bool {
        matches!(self, Property::LargestAngle | Property::SmallestAngle)
    }
}

impl Claim {
    pub fn has(&self, property: Property) -> bool {
        self.statements.iter().any(|statement| statement.property == property)
    }

    /// The rank r of the lattice: translations by integral combinations of b_1, …, b_r.
    pub fn rank(&self) -> usize {
        match &self.domain {
            Domain::Space => self.dimension,
            Domain::Polytope(polytope) => self.dimension.saturating_sub(polytope.dimension()),
            Domain::Region(rank) => *rank,
        }
    }

    pub(crate) fn read(cbor: &mut Cbor, limits: &Limits) -> Checked<Claim> {
        cbor.array_of(5)?;
        let found = cbor.small()?;
        let dimension = usize::try_from(found).ok().filter(|d| matches!(d, 2 | 3));
        let dimension = some!(dimension, Dimension, cbor.place(), found);
        let field = Field::read(cbor, limits)?;
        let degree = field.degree();
        cbor.array_of(dimension)?;
        let mut gram = Vec::new();
        for length in (1..=dimension).rev() {
            gram.extend(cbor.list(Some(length), |cbor| read_number(cbor, degree))?);
        }
        check_lowest(cbor, gram.iter().flatten())?;
        let domain = Domain::read(cbor, dimension, degree)?;
        let statements = cbor.list(None, |cbor| Statement::read(cbor, degree))?;
        // The statements are in the order of the grammar, each at most once; the tiling is first.
        let order = |of: &Statement| (of.property, of.bound.as_ref().map(|bound| bound.relation));
        let is_ordered = statements.is_sorted_by(|first, second| order(first) < order(second));
        let first = statements.first().map(|statement| statement.property);
        let is_first = first == Some(Property::FaceToFace);
        ensure!(is_ordered && is_first, Statements, cbor.place());
        Ok(Claim { dimension, field, gram, domain, statements })
    }
}

impl Field {
    pub fn degree(&self) -> usize {
        match self {
            Field::Rational => 1,
            Field::Algebraic { polynomial, .. } => polynomial.len().saturating_sub(1),
        }
    }

    fn read(cbor: &mut Cbor, limits: &Limits) -> Checked<Field> {
        if !cbor.is_array()? {
            ensure!(cbor.text()? == "Q", Cbor, cbor.place());
            return Ok(Field::Rational);
        }
        cbor.array_of(2)?;
        let length = cbor.array()?;
        let degree = length.saturating_sub(1);
        ensure!(degree >= 2, Polynomial, cbor.place(), degree);
        let within = |most| usize::try_from(degree).is_ok_and(|degree| degree <= most);
        let suffices = Some(degree).filter(|_| within(MAX_DEGREE));
        let is_within = within(limits.degree.min(MAX_DEGREE));
        ensure!(is_within, Degree, cbor.place(), Value::Limit("degree", suffices));
        let mut polynomial = Vec::new();
        for _ in 0..length {
            polynomial.push(cbor.big()?);
        }
        let is_monic = polynomial.last() == Some(&BigInt::from(1));
        ensure!(is_monic, Polynomial, cbor.place());
        cbor.array_of(3)?;
        let [low, high, denominator] = [cbor.big()?, cbor.big()?, cbor.big()?];
        check_lowest(cbor, [&low, &high, &denominator])?;
        Ok(Field::Algebraic { polynomial, low, high, denominator })
    }
}

impl Domain {
    fn read(cbor: &mut Cbor, dimension: usize, degree: usize) -> Checked<Domain> {
        if !cbor.is_array()? {
            ensure!(cbor.text()? == "space", Cbor, cbor.place());
            return Ok(Domain::Space);
        }
        cbor.array_of(2)?;
        let name = cbor.text()?;
        let k = match name.as_str() {
            "region" => {
                let found = cbor.small()?;
                let rank = usize::try_from(found).ok().filter(|&rank| rank <= dimension);
                return Ok(Domain::Region(some!(rank, RegionRank, cbor.place(), found)));
            }
            "slab" => Some(1),
            "prism" => Some(2),
            "solid" => Some(dimension),
            _ => None,
        };
        let is_prism = name == "prism";
        ensure!(!is_prism || dimension == 3, PrismDimension, cbor.place());
        let k = some!(k, Cbor, cbor.place());
        Polytope::read(cbor, k, degree).map(Domain::Polytope)
    }

    /// The name in the grammar.
    pub fn name(&self, dimension: usize) -> &'static str {
        match self {
            Domain::Space => "space",
            Domain::Region(_) => "region",
            Domain::Polytope(polytope) if polytope.dimension() == dimension => "solid",
            Domain::Polytope(polytope) if polytope.dimension() == 1 => "slab",
            Domain::Polytope(_) => "prism",
        }
    }
}

impl Polytope {
    /// k
    pub fn dimension(&self) -> usize {
        self.vertices.first().map_or(0, Vec::len)
    }

    fn read(cbor: &mut Cbor, k: usize, degree: usize) -> Checked<Polytope> {
        cbor.array_of(3)?;
        let denominator = cbor.big()?;
        ensure!(denominator > BigInt::ZERO, Denominator, cbor.place(), denominator);
        let read_vertex = |cbor: &mut Cbor| cbor.list(Some(k), |cbor| read_number(cbor, degree));
        let vertices = cbor.list(None, read_vertex)?;
        check_lowest(cbor, vertices.iter().flatten().flatten().chain([&denominator]))?;
        let faces = cbor.list(None, |cbor| read_face(cbor, k, vertices.len()))?;
        // A polytope of dimension k has more than k facets.
        ensure!(faces.len() > k, FaceCount, cbor.place(), faces.len());
        let mut sorted: Vec<_> = faces.iter().map(|face| sorted(face)).collect();
        sorted.sort_unstable();
        ensure!(is_strict(&sorted), FaceRepeated, cbor.place());
        let mut used = sorted.concat();
        used.sort_unstable();
        used.dedup();
        ensure!(used.len() == vertices.len(), UnusedDomainVertex, cbor.place());
        Ok(Polytope { denominator, vertices, faces })
    }
}

fn sorted(face: &[usize]) -> Vec<usize> {
    let mut sorted = face.to_vec();
    sorted.sort_unstable();
    sorted
}

fn is_strict<T: PartialOrd>(sorted: &[T]) -> bool {
    sorted.is_sorted_by(|first, second| first < second)
}

/// One vertex for k = 1, the two ends of a side for k = 2, a polygon for k = 3.
fn read_face(cbor: &mut Cbor, k: usize, vertices: usize) -> Checked<Vec<usize>> {
    let face = cbor.list(None, |cbor| {
        let index = cbor.small()?;
        let vertex = usize::try_from(index).ok().filter(|&vertex| vertex < vertices);
        Ok(some!(vertex, FaceVertices, cbor.place(), index))
    })?;
    let is_length = face.len() == k || (k == 3 && face.len() > 3);
    ensure!(is_length, FaceLength, cbor.place(), face.len());
    ensure!(is_strict(&sorted(&face)), FaceVertices, cbor.place());
    Ok(face)
}

impl Statement {
    /// A property, or [property, relation, sign, fraction]; ratios have no sign.
    fn read(cbor: &mut Cbor, degree: usize) -> Checked<Statement> {
        let length = if cbor.is_array()? { cbor.array()? } else { 0 };
        let property = Property::find(&cbor.text()?);
        let property = some!(property, Statements, cbor.place());
        let is_ratio = property == Property::SquaredRatio;
        let has_bound = is_ratio || property.is_angle();
        ensure!(has_bound == (length > 0), Statements, cbor.place());
        if !has_bound {
            return Ok(Statement { property, bound: None });
        }
        ensure!(length == if is_ratio { 3 } else { 4 }, Cbor, cbor.place(), length);
        let relation = some!(Relation::find(&cbor.text()?), Statements, cbor.place());
        let sign = if is_ratio { 1 } else { cbor.small()? };
        ensure!((-1..=1).contains(&sign), BoundRange, cbor.place(), sign);
        cbor.array_of(2)?;
        let numerator = read_number(cbor, degree)?;
        let denominator = cbor.big()?;
        ensure!(denominator > BigInt::ZERO, BoundRange, cbor.place(), denominator);
        check_lowest(cbor, numerator.iter().chain([&denominator]))?;
        let bound = Some(Bound { relation, sign, numerator, denominator });
        Ok(Statement { property, bound })
    }
}

/// An integer for the field Q, and else the list of the coefficients.
fn read_number(cbor: &mut Cbor, degree: usize) -> Checked<Number> {
    if degree == 1 {
        return Ok(vec![cbor.big()?]);
    }
    cbor.list(Some(degree), Cbor::big)
}

/// The greatest common divisor is 1.
fn check_lowest<'a>(cbor: &Cbor, integers: impl IntoIterator<Item = &'a BigInt>) -> Checked {
    let divisor = integers.into_iter().fold(BigInt::ZERO, |divisor, x| divisor.gcd(x));
    ensure!(divisor == BigInt::from(1), Canonical, cbor.place(), divisor);
    Ok(())
}
