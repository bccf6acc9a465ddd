//! The claim of a certificate: everything that "verified" means, and nothing else.
//!
//! This module reads a claim and checks lengths, ranges, order and lowest terms. What a claim
//! states of numbers is checked in [`crate::root`], [`crate::domain`] and [`crate::judge`].

use crate::cbor::Cbor;
use crate::int::gcd;
use crate::limits::{Limits, MAX_DEGREE};
use crate::refusal::{Checked, Limit, Value};
use num_bigint::{BigInt, Sign};

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
    /// The first one is [`Statement::FaceToFace`].
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
    Slab(Polytope),
    Prism(Polytope),
    Solid(Polytope),
    /// The union of the simplices, for a lattice of this rank.
    Region(usize),
}

/// A convex polytope P in the last k coordinates.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Polytope {
    pub denominator: BigInt,
    /// k coordinates each, times the denominator.
    pub vertices: Vec<Vec<Number>>,
    /// The vertices of each facet of P.
    pub faces: Vec<Vec<usize>>,
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Statement {
    FaceToFace,
    Acute,
    Nonobtuse,
    Bound(Bound),
    Delaunay,
    WeaklyDelaunay,
    LocallyDelaunay,
    LocallyWeaklyDelaunay,
    Tcp,
}

/// A bound for a quantity of each simplex. The square root of the fraction, with the sign, is the
/// cosine of a bound for angles; the fraction is a bound for squared ratios.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Bound {
    pub quantity: Quantity,
    pub relation: Relation,
    /// 1 for ratios.
    pub sign: i64,
    pub numerator: Number,
    pub denominator: BigInt,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Quantity {
    LargestAngle,
    SmallestAngle,
    SquaredRatio,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Relation {
    LessThan,
    AtMost,
    Maximum,
    MoreThan,
    AtLeast,
    Minimum,
}

impl Quantity {
    const ALL: [Quantity; 3] = [
        Quantity::LargestAngle,
        Quantity::SmallestAngle,
        Quantity::SquaredRatio,
    ];

    pub fn text(self) -> &'static str {
        match self {
            Quantity::LargestAngle => "largest dihedral angle",
            Quantity::SmallestAngle => "smallest dihedral angle",
            Quantity::SquaredRatio => "squared radius-edge ratio",
        }
    }
}

impl Relation {
    const ALL: [Relation; 6] = [
        Relation::LessThan,
        Relation::AtMost,
        Relation::Maximum,
        Relation::MoreThan,
        Relation::AtLeast,
        Relation::Minimum,
    ];

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

impl Statement {
    fn without_values() -> [Statement; 8] {
        [
            Statement::FaceToFace,
            Statement::Acute,
            Statement::Nonobtuse,
            Statement::Delaunay,
            Statement::WeaklyDelaunay,
            Statement::LocallyDelaunay,
            Statement::LocallyWeaklyDelaunay,
            Statement::Tcp,
        ]
    }

    /// The place in the order of the grammar, and the text; for a bound that of its quantity.
    fn row(&self) -> (usize, &'static str) {
        match self {
            Statement::FaceToFace => (0, "face-to-face tiling"),
            Statement::Acute => (1, "acute"),
            Statement::Nonobtuse => (2, "nonobtuse"),
            Statement::Bound(bound) => (3, bound.quantity.text()),
            Statement::Delaunay => (4, "Delaunay"),
            Statement::WeaklyDelaunay => (5, "weakly Delaunay"),
            Statement::LocallyDelaunay => (6, "locally Delaunay"),
            Statement::LocallyWeaklyDelaunay => (7, "locally weakly Delaunay"),
            Statement::Tcp => (8, "TCP"),
        }
    }

    pub fn text(&self) -> &'static str {
        self.row().1
    }

    fn order(&self) -> (usize, Option<(Quantity, Relation)>) {
        let bound = match self {
            Statement::Bound(bound) => Some((bound.quantity, bound.relation)),
            _ => None,
        };
        (self.row().0, bound)
    }

    fn read(cbor: &mut Cbor, degree: usize) -> Checked<Statement> {
        if cbor.is_array()? {
            return read_bound(cbor, degree).map(Statement::Bound);
        }
        let text = cbor.text()?;
        let mut known = Statement::without_values().into_iter();
        let statement = known.find(|statement| statement.text() == text);
        ensure!(statement.is_some(), Statements, cbor.place());
        Ok(statement.unwrap_or(Statement::FaceToFace))
    }
}

impl Bound {
    /// Bounds for angles have a sign.
    pub fn has_sign(&self) -> bool {
        self.quantity != Quantity::SquaredRatio
    }
}

impl Claim {
    pub(crate) fn read(cbor: &mut Cbor, limits: &Limits) -> Checked<Claim> {
        cbor.array_of(5)?;
        let dimension = match cbor.small()? {
            2 => 2,
            found => {
                ensure!(found == 3, Dimension, cbor.place(), found);
                3
            }
        };
        let field = Field::read(cbor, limits)?;
        let degree = field.degree();
        cbor.array_of(wide(dimension))?;
        let mut gram = Vec::new();
        for row in 0..dimension {
            let length = wide(dimension - row);
            gram.extend(cbor.array_with(length, |cbor, _| read_number(cbor, degree))?);
        }
        ensure!(is_primitive(gram.iter().flatten()), Canonical, cbor.place());
        let domain = Domain::read(cbor, dimension, degree)?;
        let statements = cbor.list(|cbor, _| Statement::read(cbor, degree))?;
        // The statements are in the order of the grammar, each at most once; the tiling is first.
        let orders: Vec<_> = statements.iter().map(Statement::order).collect();
        let is_ordered = orders.is_sorted_by(|first, second| first < second);
        let is_first = statements.first() == Some(&Statement::FaceToFace);
        ensure!(is_ordered && is_first, Statements, cbor.place());
        Ok(Claim {
            dimension,
            field,
            gram,
            domain,
            statements,
        })
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
            let text = cbor.text()?;
            ensure!(text == "Q", Cbor, cbor.place());
            return Ok(Field::Rational);
        }
        cbor.array_of(2)?;
        let length = cbor.array()?;
        let degree = length.saturating_sub(1);
        ensure!(degree >= 2, Polynomial, cbor.place(), degree);
        let suffices = Some(degree).filter(|&degree| degree <= wide(MAX_DEGREE));
        let exceeds = Value::Exceeds(Limit::Degree, suffices);
        let most = limits.degree.min(MAX_DEGREE);
        ensure!(degree <= wide(most), Degree, cbor.place(), exceeds);
        let mut polynomial = Vec::new();
        for _ in 0..length {
            polynomial.push(cbor.big()?);
        }
        let is_monic = polynomial.last() == Some(&BigInt::from(1));
        ensure!(is_monic, Polynomial, cbor.place());
        cbor.array_of(3)?;
        let [low, high, denominator] = [cbor.big()?, cbor.big()?, cbor.big()?];
        let is_primitive = is_primitive([&low, &high, &denominator]);
        ensure!(is_primitive, Canonical, cbor.place());
        Ok(Field::Algebraic {
            polynomial,
            low,
            high,
            denominator,
        })
    }
}

impl Domain {
    /// The polytope P, where the domain is P times the span of the lattice.
    pub fn polytope(&self) -> Option<&Polytope> {
        match self {
            Domain::Space | Domain::Region(_) => None,
            Domain::Slab(polytope) | Domain::Prism(polytope) | Domain::Solid(polytope) => {
                Some(polytope)
            }
        }
    }

    pub fn is_region(&self) -> bool {
        matches!(self, Domain::Region(_))
    }

    /// The rank r of the lattice: translations by integral combinations of b_1, …, b_r.
    pub fn rank(&self, dimension: usize) -> usize {
        match self {
            Domain::Space => dimension,
            Domain::Slab(_) => dimension.saturating_sub(1),
            Domain::Prism(_) => dimension.saturating_sub(2),
            Domain::Solid(_) => 0,
            Domain::Region(rank) => *rank,
        }
    }

    fn read(cbor: &mut Cbor, dimension: usize, degree: usize) -> Checked<Domain> {
        if !cbor.is_array()? {
            let text = cbor.text()?;
            ensure!(text == "space", Cbor, cbor.place());
            return Ok(Domain::Space);
        }
        cbor.array_of(2)?;
        match cbor.text()?.as_str() {
            "slab" => Polytope::read(cbor, 1, degree).map(Domain::Slab),
            "prism" => {
                ensure!(dimension == 3, PrismDimension, cbor.place());
                Polytope::read(cbor, 2, degree).map(Domain::Prism)
            }
            "solid" => Polytope::read(cbor, dimension, degree).map(Domain::Solid),
            name => {
                ensure!(name == "region", Cbor, cbor.place());
                let rank = cbor.small()?;
                let found = usize::try_from(rank).ok().filter(|&r| r <= dimension);
                ensure!(found.is_some(), RegionRank, cbor.place(), rank);
                Ok(Domain::Region(found.unwrap_or(0)))
            }
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
        let is_positive = denominator.sign() == Sign::Plus;
        ensure!(is_positive, Denominator, cbor.place(), denominator);
        let vertices: Vec<Vec<Number>> =
            cbor.list(|cbor, _| cbor.array_with(wide(k), |cbor, _| read_number(cbor, degree)))?;
        let coefficients = vertices.iter().flatten().flatten();
        let is_primitive = is_primitive(coefficients.chain([&denominator]));
        ensure!(is_primitive, Canonical, cbor.place());
        let faces = cbor.list(|cbor, _| read_face(cbor, k, vertices.len()))?;
        // A polytope of dimension k has more than k facets.
        ensure!(faces.len() > k, FaceCount, cbor.place(), wide(faces.len()));
        let mut sorted: Vec<Vec<usize>> = faces.clone();
        sorted.iter_mut().for_each(|face| face.sort_unstable());
        sorted.sort_unstable();
        let is_strict = sorted.is_sorted_by(|first, second| first < second);
        ensure!(is_strict, FaceRepeated, cbor.place());
        let mut used: Vec<usize> = sorted.into_iter().flatten().collect();
        used.sort_unstable();
        used.dedup();
        let all_used = used.len() == vertices.len();
        ensure!(all_used, UnusedDomainVertex, cbor.place());
        Ok(Polytope {
            denominator,
            vertices,
            faces,
        })
    }
}

/// One vertex for k = 1, the two ends of a side for k = 2, a polygon for k = 3.
fn read_face(cbor: &mut Cbor, k: usize, vertices: usize) -> Checked<Vec<usize>> {
    let face = cbor.list(|cbor, _| {
        let index = cbor.small()?;
        let vertex = usize::try_from(index).ok().filter(|&v| v < vertices);
        ensure!(vertex.is_some(), FaceVertices, cbor.place(), index);
        Ok(vertex.unwrap_or(0))
    })?;
    let is_length = face.len() == k || (k == 3 && face.len() > 3);
    ensure!(is_length, FaceLength, cbor.place(), wide(face.len()));
    let mut sorted = face.clone();
    sorted.sort_unstable();
    let is_strict = sorted.is_sorted_by(|first, second| first < second);
    ensure!(is_strict, FaceVertices, cbor.place());
    Ok(face)
}

/// [quantity, relation, sign, fraction], without the sign for ratios.
fn read_bound(cbor: &mut Cbor, degree: usize) -> Checked<Bound> {
    let length = cbor.array()?;
    let text = cbor.text()?;
    let quantity = Quantity::ALL.into_iter().find(|q| q.text() == text);
    ensure!(quantity.is_some(), Statements, cbor.place());
    let quantity = quantity.unwrap_or(Quantity::LargestAngle);
    let is_angle = quantity != Quantity::SquaredRatio;
    ensure!(length == 3 + u64::from(is_angle), Cbor, cbor.place());
    let text = cbor.text()?;
    let relation = Relation::ALL.into_iter().find(|r| r.text() == text);
    ensure!(relation.is_some(), Statements, cbor.place());
    let sign = if is_angle { cbor.small()? } else { 1 };
    ensure!((-1..=1).contains(&sign), BoundRange, cbor.place(), sign);
    cbor.array_of(2)?;
    let numerator = read_number(cbor, degree)?;
    let denominator = cbor.big()?;
    let is_positive = denominator.sign() == Sign::Plus;
    ensure!(is_positive, BoundRange, cbor.place(), denominator);
    let is_lowest = is_primitive(numerator.iter().chain([&denominator]));
    ensure!(is_lowest, Canonical, cbor.place());
    Ok(Bound {
        quantity,
        relation: relation.unwrap_or(Relation::LessThan),
        sign,
        numerator,
        denominator,
    })
}

/// An integer for the field Q, and else the list of the coefficients.
pub(crate) fn read_number(cbor: &mut Cbor, degree: usize) -> Checked<Number> {
    if degree == 1 {
        Ok(vec![cbor.big()?])
    } else {
        cbor.array_with(wide(degree), |cbor, _| cbor.big())
    }
}

/// The greatest common divisor is 1.
pub(crate) fn is_primitive<'a>(integers: impl IntoIterator<Item = &'a BigInt>) -> bool {
    let one = BigInt::from(1);
    let mut divisor = BigInt::ZERO;
    for integer in integers {
        divisor = gcd(integer, &divisor);
        if divisor == one {
            return true;
        }
    }
    false
}

fn wide(length: usize) -> u64 {
    u64::try_from(length).unwrap_or(u64::MAX)
}
