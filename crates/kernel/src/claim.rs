//! The claim of a certificate: everything that "verified" means, and nothing else.
//!
//! This module reads a claim and checks lengths, ranges, order and lowest terms. The statements
//! about its numbers are checked in [`crate::root`], [`crate::rules`] and [`crate::domain`].

use crate::cbor::Cbor;
use crate::family::{Parameter, read_parameters};
use crate::limits::MAX_DEGREE;
use crate::patch::{Tile, read_tiles};
use crate::refusal::{Checked, Place, Value};
use crate::transcript::Transcript;
use num_bigint::BigInt;
use num_integer::Integer;

/// A number of the field: its coefficients of 1, a, …, a^(n-1).
pub(crate) type Number = Vec<BigInt>;

/// The terms of a polynomial in the parameters, each with its exponents. Without parameters it is one number.
pub(crate) type Polynomial = Vec<(Number, Vec<u32>)>;

/// The claim of a certificate.
#[derive(Debug)]
pub struct Claim {
    /// 2 or 3.
    pub(crate) dimension: usize,
    pub(crate) field: Field,
    /// Those of a family; a tiling has none.
    pub(crate) parameters: Vec<Parameter>,
    /// The upper triangle of the Gram matrix, row by row; primitive.
    pub(crate) gram: Vec<Polynomial>,
    pub(crate) domain: Domain,
    /// The first one is [`Property::FaceToFace`].
    pub(crate) statements: Vec<Statement>,
    pub(crate) file: String,
}

/// The field of a root of a polynomial.
#[derive(Clone, Debug)]
pub(crate) struct Field {
    /// Coefficients of 1, x, …, x^n; the last one is 1. For the field Q the polynomial is x.
    pub(crate) polynomial: Vec<BigInt>,
    /// low, high and a denominator: the only root between low/denominator and high/denominator. None for Q.
    pub(crate) root: Option<[BigInt; 3]>,
}

#[derive(Debug, PartialEq)]
pub(crate) enum Domain {
    Space,
    /// A polytope P in the last k coordinates, times the span of the lattice: a slab for k = 1,
    /// a solid for k = D, else a prism.
    Polytope(Polytope),
    /// The union of the simplices, for a lattice of this rank.
    Region(usize),
    /// All mosaics of these tiles, in the last 3 - r coordinates for a lattice of this rank r.
    Mosaics((usize, Vec<Tile>)),
}

#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Polytope {
    /// k
    pub(crate) dimension: usize,
    pub(crate) denominator: BigInt,
    /// k coordinates each, times the denominator.
    pub(crate) vertices: Vec<Vec<Polynomial>>,
    /// The vertices of each facet of P.
    pub(crate) faces: Vec<Vec<usize>>,
}

/// A property of all simplices; with a bound for the quantities.
#[derive(Debug)]
pub(crate) struct Statement {
    pub(crate) property: Property,
    pub(crate) bound: Option<Bound>,
    pub(crate) plane: Option<Plane>,
}

/// The plane of the points x with normal · x = offset / denominator, in basis coordinates.
#[derive(Debug, PartialEq, PartialOrd)]
pub(crate) struct Plane {
    pub(crate) normal: Vec<i64>,
    pub(crate) offset: BigInt,
    pub(crate) denominator: BigInt,
}

/// The square root of the fraction, with the sign, is the cosine of a bound for angles. For squared
/// ratios the sign is 1, and the fraction is the bound.
#[derive(Debug)]
pub(crate) struct Bound {
    pub(crate) relation: Relation,
    pub(crate) sign: i64,
    pub(crate) numerator: Number,
    pub(crate) denominator: BigInt,
}

const MAX_EXPONENT: u32 = 15;
texts! {
    /// In the order of the grammar.
    Property {
        FaceToFace "face-to-face tiling",
        Acute "acute",
        Nonobtuse "nonobtuse",
        LargestAngle "largest dihedral angle",
        SmallestAngle "smallest dihedral angle",
        SquaredRatio "squared radius-edge ratio",
        UncrossedPlane "uncrossed plane",
        Delaunay "Delaunay",
        WeaklyDelaunay "weakly Delaunay",
        LocallyDelaunay "locally Delaunay",
        LocallyWeaklyDelaunay "locally weakly Delaunay",
        NotDelaunay "not Delaunay",
        Tcp "TCP",
    }
}

texts! {
    /// How a quantity of every simplex compares with a bound; some simplex attains a maximum or a minimum.
    Relation {
        LessThan "less than",
        AtMost "at most",
        Maximum "maximum",
        MoreThan "more than",
        AtLeast "at least",
        Minimum "minimum",
    }
}

impl Claim {
    /// The claim file, in canonical JSON.
    pub fn print(&self) -> &str {
        &self.file
    }

    pub(crate) fn has(&self, property: Property) -> bool {
        self.statements.iter().any(|statement| statement.property == property)
    }

    /// The rank r of the lattice: translations by integral combinations of b_1, …, b_r.
    pub(crate) fn rank(&self) -> usize {
        match &self.domain {
            Domain::Space => self.dimension,
            Domain::Polytope(polytope) => self.dimension.saturating_sub(polytope.dimension),
            Domain::Region(rank) => *rank,
            Domain::Mosaics((rank, _)) => *rank,
        }
    }

    /// The claim of a certificate of this kind.
    pub(crate) fn read(cbor: &mut Cbor, kind: &str) -> Checked<Claim> {
        let mut t = Transcript::new(cbor, kind);
        let is_family = kind == "family";
        t.record(match kind {
            "patches" => &["field", "gram", "rank", "tiles", "statements"],
            "family" => &["dimension", "field", "parameters", "gram", "domain", "statements"],
            _ => &["dimension", "field", "gram", "domain", "statements"],
        })?;
        let found = if kind == "patches" { 3.into() } else { t.big()? };
        let dimension = usize::try_from(&found).ok().filter(|d| matches!(d, 2 | 3));
        let dimension = some!(dimension, Dimension, t.place(), found);
        let field = Field::read(&mut t)?;
        t.degree = field.degree();
        let parameters = if is_family { read_parameters(&mut t)? } else { Vec::new() };
        t.parameters = parameters.len();
        let gram = read_gram(&mut t, dimension)?;
        let domain =
            if kind == "patches" { Domain::Mosaics(read_tiles(&mut t)?) } else { Domain::read(&mut t, dimension)? };
        let statements = read_statements(&mut t, dimension)?;
        Ok(Claim { dimension, field, parameters, gram, domain, statements, file: t.json + "\n" })
    }
}

/// The upper triangle by rows.
fn read_gram(t: &mut Transcript, dimension: usize) -> Checked<Vec<Polynomial>> {
    t.array(Some(dimension))?;
    let mut gram = Vec::new();
    for length in (1..=dimension).rev() {
        gram.extend(t.list(Some(length), read_polynomial)?);
    }
    check_lowest(t.place(), integers(&gram))?;
    Ok(gram)
}

fn read_statements(t: &mut Transcript, dimension: usize) -> Checked<Vec<Statement>> {
    let statements = t.list(None, |t| Statement::read(t, dimension))?;
    // The statements are in the order of the grammar, each at most once; the tiling is first.
    let order = |of: &Statement| (of.property, of.bound.as_ref().map(|bound| bound.relation));
    let is_ordered =
        statements.is_sorted_by(|first, second| (order(first), &first.plane) < (order(second), &second.plane));
    let first = statements.first().map(|statement| statement.property);
    let is_first = first == Some(Property::FaceToFace);
    ensure!(is_ordered && is_first, Statements, t.place());
    Ok(statements)
}

impl Field {
    pub(crate) fn degree(&self) -> usize {
        self.polynomial.len().saturating_sub(1)
    }

    fn read(t: &mut Transcript) -> Checked<Field> {
        if !t.is_array()? {
            ensure!(t.text()? == "Q", Cbor, t.place());
            return Ok(Field { polynomial: vec![0.into(), 1.into()], root: None });
        }
        t.record(&["polynomial", "root"])?;
        let length = t.array(None)?;
        let degree = length.saturating_sub(1);
        ensure!(degree >= 2, Polynomial, t.place(), degree);
        let within = |most| usize::try_from(degree).is_ok_and(|degree| degree <= most);
        let is_within = within(t.cbor.limits.degree.min(MAX_DEGREE));
        // No option raises the second limit.
        let value = if within(MAX_DEGREE) { Value::Limit("degree", Some(degree)) } else { degree.into() };
        ensure!(is_within, Degree, t.place(), value);
        let polynomial = (0..length).map(|_| t.big()).collect::<Checked<Vec<_>>>()?;
        let is_monic = polynomial.last() == Some(&BigInt::from(1));
        ensure!(is_monic, Polynomial, t.place());
        t.record(&["low", "high", "denominator"])?;
        let root = [t.big()?, t.big()?, t.big()?];
        check_lowest(t.place(), &root)?;
        Ok(Field { polynomial, root: Some(root) })
    }
}

impl Domain {
    fn read(t: &mut Transcript, dimension: usize) -> Checked<Domain> {
        if !t.is_array()? {
            ensure!(t.text()? == "space", Cbor, t.place());
            return Ok(Domain::Space);
        }
        t.array(Some(2))?;
        let name = t.text()?;
        if name == "region" {
            ensure!(t.parameters == 0, FamilyDomain, t.place());
            let found = t.big()?;
            let rank = usize::try_from(&found).ok().filter(|&rank| rank <= dimension);
            return Ok(Domain::Region(some!(rank, RegionRank, t.place(), found)));
        }
        ensure!(name != "prism" || dimension == 3, PrismDimension, t.place());
        let names = [("slab", 1), ("prism", 2), ("solid", dimension)];
        let k = names.into_iter().find(|(known, _)| *known == name).map(|(_, k)| k);
        Ok(Domain::Polytope(Polytope::read(t, some!(k, Cbor, t.place()))?))
    }
}

impl Polytope {
    fn read(t: &mut Transcript, k: usize) -> Checked<Polytope> {
        t.record(&["denominator", "vertices", "faces"])?;
        let (denominator, vertices) = read_points(t, k)?;
        let faces = t.list(None, |t| read_face(t, k, vertices.len()))?;
        // A polytope of dimension k has more than k facets.
        ensure!(faces.len() > k, FaceCount, t.place(), faces.len());
        let mut sorted: Vec<_> = faces.iter().map(|face| sorted(face)).collect();
        sorted.sort_unstable();
        ensure!(is_strict(&sorted), FaceRepeated, t.place());
        let mut used = sorted.concat();
        used.sort_unstable();
        used.dedup();
        ensure!(used.len() == vertices.len(), UnusedDomainVertex, t.place());
        Ok(Polytope { dimension: k, denominator, vertices, faces })
    }
}

fn sorted(face: &[usize]) -> Vec<usize> {
    let mut sorted = face.to_vec();
    sorted.sort_unstable();
    sorted
}

pub(crate) fn is_strict<T: PartialOrd>(sorted: &[T]) -> bool {
    sorted.is_sorted_by(|first, second| first < second)
}

/// One vertex for k = 1, the two ends of a side for k = 2, a polygon for k = 3.
fn read_face(t: &mut Transcript, k: usize, vertices: usize) -> Checked<Vec<usize>> {
    let face = t.list(None, |t| {
        let index = t.big()?;
        let vertex = usize::try_from(&index).ok().filter(|&vertex| vertex < vertices);
        Ok(some!(vertex, FaceVertices, t.place(), index))
    })?;
    let is_length = face.len() == k || (k == 3 && face.len() > 3);
    ensure!(is_length, FaceLength, t.place(), face.len());
    ensure!(is_strict(&sorted(&face)), FaceVertices, t.place());
    Ok(face)
}

impl Statement {
    /// A property; [property, relation, sign, fraction], where ratios have no sign; or that of a plane.
    fn read(t: &mut Transcript, dimension: usize) -> Checked<Statement> {
        let length = if t.is_array()? { t.array(None)? } else { 0 };
        let property = some!(Property::find(&t.text()?), Statements, t.place());
        let (is_ratio, is_plane) = (property == Property::SquaredRatio, property == Property::UncrossedPlane);
        let has_bound = is_ratio || property.is_angle();
        ensure!((has_bound || is_plane) == (length > 0), Statements, t.place());
        ensure!(length == 0 || length == if property.is_angle() { 4 } else { 3 }, Cbor, t.place(), length);
        let plane = if is_plane { Some(Plane::read(t, dimension)?) } else { None };
        let bound = if has_bound { Some(Bound::read(t, is_ratio)?) } else { None };
        Ok(Statement { property, bound, plane })
    }
}

impl Bound {
    fn read(t: &mut Transcript, is_ratio: bool) -> Checked<Bound> {
        let relation = some!(Relation::find(&t.text()?), Statements, t.place());
        let found = if is_ratio { 1.into() } else { t.big()? };
        let sign = i64::try_from(&found).ok().filter(|sign| (-1..=1).contains(sign));
        let sign = some!(sign, BoundRange, t.place(), found);
        let (numerator, denominator) = read_fraction(t)?;
        ensure!(denominator > BigInt::ZERO, BoundRange, t.place(), denominator);
        check_lowest(t.place(), numerator.iter().chain([&denominator]))?;
        Ok(Bound { relation, sign, numerator, denominator })
    }
}

/// The bound for the entries of normals; with those of shifts, sums of products fit 64 bits.
const MOST_ENTRY: i64 = 1 << 29;

impl Plane {
    /// [normal, [offset, denominator]]
    fn read(t: &mut Transcript, dimension: usize) -> Checked<Plane> {
        let entries = t.list(Some(dimension), Transcript::big)?;
        check_lowest(t.place(), &entries)?;
        // Of a normal and its negative one is canonical.
        let sign = entries.iter().map(|c| c.cmp(&BigInt::ZERO)).find(|sign| sign.is_ne());
        ensure!(sign.is_some_and(|sign| sign.is_gt()), Canonical, t.place());
        let entry = |c: &BigInt| i64::try_from(c).ok().filter(|c| c.abs() < MOST_ENTRY);
        let normal = some!(entries.iter().map(entry).collect::<Option<Vec<_>>>(), BoundRange, t.place());
        t.array(Some(2))?;
        let [offset, denominator] = [t.big()?, t.big()?];
        ensure!(denominator > BigInt::ZERO, BoundRange, t.place(), denominator);
        check_lowest(t.place(), [&offset, &denominator])?;
        Ok(Plane { normal, offset, denominator })
    }
}

impl Property {
    pub(crate) fn is_angle(self) -> bool {
        matches!(self, Property::LargestAngle | Property::SmallestAngle)
    }
}

/// An integer for the field Q, and else the list of the coefficients.
pub(crate) fn read_number(t: &mut Transcript) -> Checked<Number> {
    if t.degree == 1 {
        return Ok(vec![t.big()?]);
    }
    t.list(Some(t.degree), Transcript::big)
}

pub(crate) fn read_fraction(t: &mut Transcript) -> Checked<(Number, BigInt)> {
    t.array(Some(2))?;
    Ok((read_number(t)?, t.big()?))
}

/// A number; with parameters the list of the terms, in the order of their exponents.
fn read_polynomial(t: &mut Transcript) -> Checked<Polynomial> {
    if t.parameters == 0 {
        return Ok(vec![(read_number(t)?, Vec::new())]);
    }
    let terms = t.list(None, |t| {
        t.array(Some(1 + t.parameters))?;
        let number = read_number(t)?;
        let is_zero = number.iter().all(|c| *c == BigInt::ZERO);
        ensure!(!is_zero, Terms, t.place());
        let mut exponents = Vec::new();
        for _ in 0..t.parameters {
            let found = t.big()?;
            let exponent = u32::try_from(&found).ok().filter(|&exponent| exponent <= MAX_EXPONENT);
            exponents.push(some!(exponent, Exponent, t.place(), found));
        }
        Ok((number, exponents))
    })?;
    ensure!(terms.is_sorted_by(|first, second| first.1 < second.1), Terms, t.place());
    Ok(terms)
}

/// A denominator, and points of this dimension over it.
pub(crate) fn read_points(t: &mut Transcript, dimension: usize) -> Checked<(BigInt, Vec<Vec<Polynomial>>)> {
    let denominator = t.big()?;
    ensure!(denominator > BigInt::ZERO, Denominator, t.place(), denominator);
    let points = t.list(None, |t| t.list(Some(dimension), read_polynomial))?;
    check_lowest(t.place(), points.iter().flat_map(|point| integers(point)).chain([&denominator]))?;
    Ok((denominator, points))
}

/// All coefficients of some polynomials.
pub(crate) fn integers(polynomials: &[Polynomial]) -> impl Iterator<Item = &BigInt> {
    polynomials.iter().flatten().flat_map(|(number, _)| number)
}

/// The greatest common divisor is 1.
pub(crate) fn check_lowest<'a>(place: Place, integers: impl IntoIterator<Item = &'a BigInt>) -> Checked {
    let divisor = integers.into_iter().fold(BigInt::ZERO, |divisor, x| divisor.gcd(x));
    ensure!(divisor == BigInt::from(1), Canonical, place, divisor);
    Ok(())
}
