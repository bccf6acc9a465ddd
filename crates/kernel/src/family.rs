//! Certificates of the kind `family`: one tiling for each point of a box of parameters.
//!
//! The witness has a tree that cuts the box into leaves. In each leaf the pass of [`crate::tiling`] is made over
//! [`Polynomials`], with signs that hold on the whole leaf. Where this does not succeed, the same pass at single points
//! of the box finds out whether the claim is false. docs/soundness.md, section 11, has the proof.

use crate::cbor::Cbor;
use crate::claim::{Claim, Domain, Number, Polynomial, check_lowest, is_strict, read_fraction, read_points};
use crate::front::Step;
use crate::numbers::{Model, Numbers};
use crate::polynomial::{Polynomials, Side, Terms};
use crate::refusal::{Checked, Code, Kind, Place, Stop, Value};
use crate::ring::{Exact, Ring, Vector};
use crate::root::Root;
use crate::row::{Corner, Row, Shape};
use crate::table::index;
use crate::tiling::{Facts, Pass, check_statements, read_count};
use crate::transcript::Transcript;
use num_bigint::BigInt;
use num_integer::Integer;
use std::cmp::Ordering::{Equal, Greater};
use std::rc::Rc;

type Box<const N: usize> = Vec<Side<N>>;

const MAX_PARAMETERS: usize = 64;
const LONGEST_NAME: usize = 16;
const MOST_LEAVES: usize = 4096;
const MOST_HALVINGS: usize = 64;

/// A parameter of a family, and its interval.
#[derive(Debug)]
pub(crate) struct Parameter {
    pub(crate) name: String,
    pub(crate) low: End,
    pub(crate) high: End,
}

/// An end of an interval: numerator / denominator.
#[derive(Debug)]
pub(crate) struct End {
    /// The end belongs to the interval.
    pub(crate) is_closed: bool,
    pub(crate) numerator: Number,
    pub(crate) denominator: BigInt,
}

pub(crate) fn read_parameters(t: &mut Transcript) -> Checked<Vec<Parameter>> {
    let parameters = t.list(None, |t| {
        t.record(&["name", "low", "high"])?;
        let name = t.text()?;
        let is_usual = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_';
        let is_name = name.starts_with(|c: char| c.is_ascii_lowercase()) && name.chars().all(is_usual);
        ensure!(is_name && name.len() <= LONGEST_NAME, ParameterName, t.place());
        Ok(Parameter { name, low: End::read(t)?, high: End::read(t)? })
    })?;
    let count = parameters.len();
    ensure!((1..=MAX_PARAMETERS).contains(&count), Parameters, t.place(), count);
    let mut names: Vec<&str> = parameters.iter().map(|parameter| parameter.name.as_str()).collect();
    names.extend((t.degree > 1).then_some("a")); // The generator, in all sentences.
    names.sort_unstable();
    ensure!(is_strict(&names), ParameterName, t.place());
    Ok(parameters)
}

impl End {
    fn read(t: &mut Transcript) -> Checked<End> {
        t.array(Some(2))?;
        let kind = t.text()?;
        ensure!(kind == "closed" || kind == "open", Cbor, t.place());
        let (numerator, denominator) = read_fraction(t)?;
        ensure!(denominator > BigInt::ZERO, Denominator, t.place(), denominator);
        check_lowest(t.place(), numerator.iter().chain([&denominator]))?;
        Ok(End { is_closed: kind == "closed", numerator, denominator })
    }
}

/// The claim and the witness of a family.
struct Family<'c, const N: usize> {
    claim: &'c Claim,
    ring: Exact<BigInt, N>,
    denominator: BigInt,
    vertices: Vec<Vec<Polynomial>>,
    /// The greatest exponents of the parameters.
    degrees: Vec<u32>,
    rows: Vec<Row>,
}

/// Reads the rest of a certificate whose claim has been read.
pub(crate) fn verify<const N: usize>(mut cbor: Cbor, claim: Claim) -> Checked<Facts> {
    let root = Rc::new(Root::new(&claim.field, &cbor.work)?);
    let ring = Exact::new(&root, &cbor.work)?;
    let mut sides: Box<N> = Vec::new();
    for (parameter, k) in claim.parameters.iter().zip(0..) {
        let side = Side::new(parameter, &ring)?;
        let order =
            ring.compare(&side.ends[1], &side.ends[0])?.decided().map_err(|stop| stop.at(Place::Parameter(k)))?;
        ensure!(order != Equal, BoxEmpty, Place::Parameter(k));
        ensure!(order == Greater, BoxExchanged, Place::Parameter(k));
        sides.push(side);
    }
    check_statements(&claim)?;
    cbor.array_of(5)?;
    let mut family = Family::read_vertices(&mut cbor, &claim, ring)?;
    let boundary = cbor.array()?;
    ensure!(boundary == 0, BoundaryDomain, Place::Witness, boundary);
    let mut leaves = Vec::new();
    family.read_tree(&mut cbor, &sides, 0, &mut leaves)?;
    let shape = family.read_rows(&mut cbor)?;
    let (bytes, sha256) = cbor.finish()?;
    let mut counts = Default::default();
    for leaf in leaves {
        counts = family.check(&leaf).or_else(|stop| Err(family.refusal(&leaf, stop)?))?;
    }
    let (boundary_facets, peak_facets, peak_edges) = counts;
    let (vertices, simplices) = (shape.vertices, u64::try_from(family.rows.len()).unwrap_or(u64::MAX));
    Ok(Facts { vertices, simplices, boundary_facets, peak_facets, peak_edges, bytes, sha256, claim })
}

impl<'c, const N: usize> Family<'c, N> {
    fn read_vertices(cbor: &mut Cbor, claim: &'c Claim, ring: Exact<BigInt, N>) -> Checked<Self> {
        let (denominator, vertices) = read_points(&mut Transcript::of(cbor, claim), claim.dimension)?;
        let mut degrees = vec![0; claim.parameters.len()];
        let domain = match &claim.domain {
            Domain::Polytope(polytope) => &polytope.vertices[..],
            _ => &[],
        };
        for (_, exponents) in claim.gram.iter().chain(vertices.iter().chain(domain).flatten()).flatten() {
            degrees.iter_mut().zip(exponents).for_each(|(degree, e)| *degree = (*degree).max(*e));
        }
        // Every parameter occurs.
        let unused = degrees.iter().position(|degree| *degree == 0);
        ensure!(unused.is_none(), UnusedParameter, Place::Parameter(unused.unwrap_or(0)));
        Ok(Family { claim, ring, denominator, vertices, degrees, rows: Vec::new() })
    }

    /// An empty array, or an axis and the trees of the lower and the upper half.
    fn read_tree(&self, cbor: &mut Cbor, sides: &Box<N>, halvings: usize, leaves: &mut Vec<Box<N>>) -> Checked {
        let length = cbor.array()?;
        if length == 0 {
            ensure!(leaves.len() < MOST_LEAVES, TreeSize, cbor.place(), leaves.len() + 1);
            leaves.push(sides.clone());
            return Ok(());
        }
        ensure!(length == 3, Cbor, cbor.place(), length);
        ensure!(halvings < MOST_HALVINGS, TreeSize, cbor.place(), halvings + 1);
        let found = cbor.small()?;
        let axis = usize::try_from(found).ok().filter(|&axis| axis < sides.len());
        let axis = some!(axis, Tree, cbor.place(), found);
        let halves = sides.get(axis).ok_or(Stop::LARGER)?.halves(&self.ring)?;
        for half in halves {
            let mut sides = sides.clone();
            *sides.get_mut(axis).ok_or(Stop::LARGER)? = half;
            self.read_tree(cbor, &sides, halvings + 1, leaves)?;
        }
        Ok(())
    }

    fn read_rows(&mut self, cbor: &mut Cbor) -> Checked<Shape> {
        let shape = Pass::new(self.claim, (), &self.ring.work).shape;
        let vertices = u32::try_from(self.vertices.len()).unwrap_or(u32::MAX);
        let shape = Shape { vertices, ..shape };
        let simplices = read_count(cbor, 0)?;
        for simplex in 0..simplices {
            self.rows.push(shape.read_row(cbor, simplex)?);
        }
        Ok(shape)
    }

    /// The check of the tiling on a whole leaf, or at a point. Returns its counts.
    fn check(&self, leaf: &Box<N>) -> Checked<(u64, usize, usize)> {
        let ring = Polynomials::new(&self.ring, leaf, &self.degrees)?;
        let mut model = Model::new(&ring, self.claim)?;
        model.set_denominator(self.claim, &self.denominator)?;
        let mut points = Vec::new();
        for vertex in &self.vertices {
            let mut point: Vector<Polynomials<N>> = Default::default();
            for (coordinate, polynomial) in point.iter_mut().zip(vertex) {
                *coordinate = ring.polynomial(polynomial)?;
            }
            points.push(point);
        }
        let denominator = &self.denominator * &ring.scale;
        let numbers = Leaf { model, points, denominator, volume: Terms::default() };
        let mut pass = Pass::new(self.claim, numbers, &self.ring.work);
        for _ in &self.vertices {
            pass.add_vertex()?;
        }
        for (row, simplex) in self.rows.iter().zip(0..) {
            pass.check_row(row, simplex)?;
        }
        pass.check_end()?;
        Ok(pass.counts())
    }

    /// A check did not succeed on a leaf. A condition that does not hold at the middle, or at a
    /// corner that belongs to the box, is refused there. (In a coordinate without a closed end the
    /// corner has the middle.) Otherwise nothing is decided.
    fn refusal(&self, leaf: &Box<N>, stop: Stop) -> Checked<Stop> {
        let refusal = stop.refusal();
        let is_open = refusal.code == Code::SignUndecided || refusal.code.kind() == Kind::Rejected;
        if is_open {
            let is_about_all = matches!(refusal.code, Code::NotAttained | Code::NoneInside);
            self.check_points(leaf, true, &mut Vec::new(), is_about_all)?;
            self.check_points(leaf, false, &mut Vec::new(), is_about_all)?;
            return Ok(Stop::LARGER.at(refusal.place));
        }
        Ok(Stop::of(refusal))
    }

    /// Checks the middle, or the corners.
    fn check_points(&self, leaf: &Box<N>, is_middle: bool, point: &mut Box<N>, is_about_all: bool) -> Checked {
        let Some(side) = leaf.get(point.len()) else { return self.check_point(point, is_about_all) };
        let points = side.points(&self.ring)?;
        let (middle, ends) = points.split_at(1);
        for end in if is_middle || ends.is_empty() { middle } else { ends } {
            point.push(end.clone());
            self.check_points(leaf, is_middle, point, is_about_all)?;
            point.pop();
        }
        Ok(())
    }

    /// Refuses if a condition does not hold at a point. Whether bounds are attained counts only if
    /// nothing else is open on the leaf.
    fn check_point(&self, point: &Box<N>, is_about_all: bool) -> Checked {
        let Err(stop) = self.check(point) else { return Ok(()) };
        let mut refusal = stop.refusal();
        let is_attainment = matches!(refusal.code, Code::NotAttained | Code::NoneInside);
        if refusal.code == Code::SignUndecided || (is_attainment && !is_about_all) {
            return Ok(());
        }
        let value = |side: &Side<N>| {
            let numerator = self.ring.coefficients(&side.ends[0]);
            let divisor = numerator.iter().fold(side.unit.clone(), |divisor, c| divisor.gcd(c));
            Value::Quotient(numerator.iter().map(|c| c / &divisor).collect(), vec![&side.unit / &divisor])
        };
        let names = self.claim.parameters.iter().map(|parameter| parameter.name.clone());
        refusal.point = names.zip(point.iter().map(value)).collect();
        // These values are too large by a factor that depends on the box.
        let is_about_size = [Code::GramNotPositive, Code::VertexOutside].contains(&refusal.code);
        let is_about_faces = [Code::FaceNotFacet, Code::FaceNotConvex].contains(&refusal.code);
        let is_about_spheres = [Code::NotDelaunay, Code::NotWeaklyDelaunay].contains(&refusal.code);
        if is_about_size || is_about_faces || is_about_spheres {
            refusal.value = Value::Nothing;
        }
        Err(Stop::of(refusal))
    }
}

/// The numbers of a family on a leaf.
struct Leaf<const N: usize> {
    model: Model<Polynomials<N>>,
    points: Vec<Vector<Polynomials<N>>>,
    /// With the scale of the ring.
    denominator: BigInt,
    volume: Terms<N>,
}

impl<const N: usize> Numbers for Leaf<N> {
    fn faces(&self, vertex: u32) -> Checked<Vec<u32>> {
        self.model.faces(self.points.get(index(vertex)).ok_or(Stop::LARGER)?, vertex)
    }

    fn check(&mut self, row: &Row, steps: &[Step; 4], simplex: u64) -> Checked<u32> {
        let Model { rules, .. } = &self.model;
        let ring = &rules.ring;
        let point = |Corner { vertex, shift }| {
            let mut point = self.points.get(index(vertex)).ok_or(Stop::LARGER)?.clone();
            for (coordinate, shift) in point.iter_mut().zip(shift).filter(|(_, shift)| *shift != 0) {
                *coordinate = ring.plus(coordinate, &ring.element(&[&self.denominator * shift])?)?;
            }
            Ok(point)
        };
        let found = self.model.simplex(ring, row, steps, simplex, point);
        let found = found.and_then(|simplex| rules.check(&simplex, &self.denominator));
        let (determinant, attained) = found.map_err(|stop| stop.at(Place::Simplex(simplex)))?;
        self.volume = ring.plus(&self.volume, &determinant)?;
        Ok(attained)
    }

    fn check_volume(&self, shape: Shape) -> Checked {
        self.model.check_volume(&self.volume, shape, &self.denominator)
    }
}
