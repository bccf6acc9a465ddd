//! One pass over the witness of a tiling: each row is checked as it is read, and forgotten.
//!
//! The vertices, the open facets and the open edges stay in memory. [`Verified`] is made in one
//! place, after the last check.

use crate::cbor::Cbor;
use crate::claim::{Claim, Statement};
use crate::domain::Faces;
use crate::edges::Edges;
use crate::filter::{Interval, Intervals};
use crate::front::{Front, Step};
use crate::int::Int;
use crate::judge::Judge;
use crate::limits::{Limits, Work};
use crate::refusal::{Checked, Code, Larger, Limit, Place, Refusal, Stop, Value};
use crate::region::Region;
use crate::ring::{Element, Exact, Ring, Rings, each};
use crate::root::Root;
use crate::row::{Row, Shape};
use crate::rules::{Rules, to_attain};
use crate::vertices::Vertices;
use num_bigint::BigInt;
use std::rc::Rc;

/// A certificate that fulfils every condition of the format.
#[derive(Debug)]
pub struct Verified {
    claim: Claim,
    vertices: u32,
    simplices: u64,
    boundary: u64,
    peak_facets: usize,
    peak_edges: usize,
    bytes: u64,
    sha256: [u8; 32],
}

impl Verified {
    /// What is proved.
    pub fn claim(&self) -> &Claim {
        &self.claim
    }

    pub fn vertices(&self) -> u32 {
        self.vertices
    }

    pub fn simplices(&self) -> u64 {
        self.simplices
    }

    /// The number of facets in the boundary of the domain.
    pub fn boundary_facets(&self) -> u64 {
        self.boundary
    }

    /// The largest number of open facets at one time.
    pub fn peak_facets(&self) -> usize {
        self.peak_facets
    }

    /// The largest number of open edges at one time, with `TCP`.
    pub fn peak_edges(&self) -> usize {
        self.peak_edges
    }

    pub fn bytes(&self) -> u64 {
        self.bytes
    }

    /// The SHA-256 of the bytes of the certificate.
    pub fn sha256(&self) -> &[u8; 32] {
        &self.sha256
    }
}

/// Reads the rest of a certificate whose claim has been read.
pub(crate) fn verify<const N: usize>(
    mut cbor: Cbor,
    claim: Claim,
    limits: &Limits,
    work: Rc<Work>,
) -> Checked<Verified> {
    let mut tiling = Tiling::<N>::new(claim, &work)?;
    tiling.read_vertices(&mut cbor)?;
    tiling.read_boundary(&mut cbor)?;
    let simplices = cbor.array()?;
    // An empty list proves nothing.
    ensure!(simplices > 0, NoSimplices, Place::Witness);
    let exceeds = Value::Exceeds(Limit::Simplices, Some(simplices));
    let is_within = simplices <= limits.simplices;
    ensure!(is_within, TooManySimplices, Place::Witness, exceeds);
    for simplex in 0..simplices {
        let row = tiling.shape.read_row(&mut cbor, simplex)?;
        tiling.check_row(&row, simplex)?;
    }
    let (bytes, sha256) = cbor.finish()?;
    tiling.check_end()?;
    Ok(Verified {
        vertices: tiling.vertices.count(),
        simplices,
        boundary: tiling.front.boundary,
        peak_facets: tiling.front.peak(),
        peak_edges: tiling.edges.map_or(0, |edges| edges.peak()),
        bytes,
        sha256,
        claim: tiling.claim,
    })
}

/// The check of one tiling, or of one part of a larger structure: its rows come one by one.
pub(crate) struct Tiling<const N: usize> {
    claim: Claim,
    shape: Shape,
    rings: Rc<Rings<N>>,
    work: Rc<Work>,
    faces: Option<Faces<N>>,
    region: Option<Region<N>>,
    vertices: Vertices,
    used: Vec<bool>,
    front: Front,
    edges: Option<Edges>,
    small: Option<Rules<Exact<i64, N>>>,
    medium: Option<Rules<Exact<i128, N>>>,
    large: Rules<Exact<BigInt, N>>,
    intervals: Option<Rules<Intervals>>,
    volume: Volume<N>,
    /// The set of the bounds that some simplex attains.
    attained: u32,
}

impl<const N: usize> Tiling<N> {
    /// Checks what the claim states of its own numbers.
    pub(crate) fn new(claim: Claim, work: &Rc<Work>) -> Checked<Tiling<N>> {
        let root = Rc::new(Root::new(&claim.field)?);
        let undecided = |stop: Stop| stop.at_last(Place::Field);
        let rings = Rings::new(&root, work).map_err(|Larger| undecided(Stop::Larger))?;
        let rings: Rc<Rings<N>> = Rc::new(rings);
        let large = Rules::new(rings.large.clone(), &claim).map_err(undecided)?;
        let medium = rings
            .medium
            .as_ref()
            .and_then(|ring| Rules::new(ring.clone(), &claim).ok());
        let small = rings
            .small
            .as_ref()
            .and_then(|ring| Rules::new(ring.clone(), &claim).ok());
        let intervals = Rules::new(Intervals::new(&root), &claim).ok();
        let polytope = claim.domain.polytope();
        let faces = match polytope {
            Some(polytope) => Some(Faces::new(&claim, polytope, &rings, work)?),
            None => None,
        };
        check_statements(&claim)?;
        let has_sixes = claim.statements.contains(&Statement::Tcp);
        let shape = Shape {
            dimension: claim.dimension,
            rank: claim.domain.rank(claim.dimension),
            vertices: 0,
            has_sixes,
        };
        Ok(Tiling {
            shape,
            faces,
            region: None,
            vertices: Vertices::new(claim.dimension, claim.field.degree()),
            used: Vec::new(),
            front: Front::new(claim.dimension, work),
            edges: Some(Edges::new(work)).filter(|_| has_sixes),
            volume: Volume::default(),
            attained: 0,
            work: work.clone(),
            claim,
            rings,
            small,
            medium,
            large,
            intervals,
        })
    }

    fn read_vertices(&mut self, cbor: &mut Cbor) -> Checked {
        cbor.array_of(4)?;
        self.vertices.read_denominator(cbor)?;
        let mut faces = self.faces.as_mut();
        if let (Some(faces), Some(polytope)) = (&mut faces, self.claim.domain.polytope()) {
            faces.set_denominator(polytope, &self.vertices.denominator, &self.rings)?;
        }
        let work = &self.work;
        self.vertices.read(cbor, |vertices, vertex| {
            if let Some(faces) = &mut faces {
                faces.check_vertex(vertices, vertex)?;
            }
            work.check(Place::Vertex(vertex))
        })?;
        self.shape.vertices = self.vertices.count();
        self.used = vec![false; index(self.vertices.count())];
        Ok(())
    }

    fn read_boundary(&mut self, cbor: &mut Cbor) -> Checked {
        let count = cbor.array()?;
        // A region without boundary is space; other domains compute their boundary.
        let is_region = self.claim.domain.is_region();
        let is_fitting = (count > 0) == is_region;
        ensure!(is_fitting, BoundaryDomain, Place::Witness, count);
        let mut facets = Vec::new();
        for index in 0..count {
            let facet = self.shape.read_facet(cbor, index)?;
            self.front.list(facet, index)?;
            self.work.check(Place::Boundary(index))?;
            facets.push(facet);
        }
        if is_region {
            let region = Region::new(facets, self.shape, &self.vertices, &self.rings, &self.work)?;
            self.region = Some(region);
        }
        Ok(())
    }

    #[inline(always)]
    pub(crate) fn check_row(&mut self, row: &Row, simplex: u64) -> Checked {
        for corner in row.corners.iter().take(self.shape.dimension + 1) {
            if let Some(used) = self.used.get_mut(index(corner.vertex)) {
                *used = true;
            }
        }
        let steps = match &self.faces {
            None => self.front.step(row, |_| false, simplex)?,
            Some(faces) => self.front.step(row, |facet| faces.share(facet), simplex)?,
        };
        if let Some(edges) = &mut self.edges {
            edges.step(row, &steps, simplex)?;
        }
        match self.judge(
            self.small.as_ref(),
            self.medium.as_ref(),
            row,
            &steps,
            simplex,
        ) {
            Ok((determinant, attained)) => self.add(&determinant, attained),
            Err(Stop::Larger) => self.judge_larger(row, &steps, simplex)?,
            Err(stop) => return Err(self.with_units(stop, simplex)),
        }
        if let Some(region) = &mut self.region {
            region.check_row(row, &self.vertices, simplex)?;
        }
        self.work.check(Place::Simplex(simplex))
    }

    /// The refusal of a simplex, with its value in units of the lattice's cell.
    #[cold]
    fn with_units(&self, stop: Stop, simplex: u64) -> Box<Refusal> {
        let mut refusal = stop.at_last(Place::Simplex(simplex));
        let power = match refusal.code {
            Code::Orientation => self.shape.dimension,
            Code::NotDelaunay | Code::NotWeaklyDelaunay => 2,
            _ => 0,
        };
        if let Value::Quotient(_, divisor) = &mut refusal.value {
            for _ in 0..power {
                divisor
                    .iter_mut()
                    .for_each(|c| *c *= &self.vertices.denominator);
            }
        }
        refusal
    }

    /// The judgement where products do not fit 64 bits: by intervals, and then by larger integers.
    #[cold]
    #[inline(never)]
    fn judge_larger(&mut self, row: &Row, steps: &[Step; 4], simplex: u64) -> Checked {
        if self.judge_filtered(row, steps, simplex).is_ok() {
            return Ok(());
        }
        match self.judge(self.medium.as_ref(), Some(&self.large), row, steps, simplex) {
            Ok((determinant, attained)) => {
                self.add(&determinant, attained);
                return Ok(());
            }
            Err(Stop::Refused(refusal)) => return Err(refusal),
            Err(Stop::Larger) => {}
        }
        let (determinant, attained) = self
            .judge(Some(&self.large), None, row, steps, simplex)
            .map_err(|stop| stop.at_last(Place::Simplex(simplex)))?;
        self.add(&determinant, attained);
        Ok(())
    }

    #[inline(always)]
    fn judge<T: Int>(
        &self,
        rules: Option<&Rules<Exact<T, N>>>,
        next: Option<&Rules<Exact<T::Next, N>>>,
        row: &Row,
        steps: &[Step; 4],
        simplex: u64,
    ) -> Result<(Element<T, N>, u32), Stop> {
        let rules = rules.ok_or(Larger)?;
        self.work.add(rules.price());
        let seen = Seen::new(&rules.ring, &self.vertices, row, steps, rules.needs_mates())?;
        Judge { rules, next }.check(&seen.edges, &seen.mates, simplex)
    }

    /// The judgement by intervals. Only the volume needs the determinant itself. Exact integers
    /// repeat a refusal, for its value.
    fn judge_filtered(&mut self, row: &Row, steps: &[Step; 4], simplex: u64) -> Result<(), Stop> {
        let rules = self.intervals.as_ref().ok_or(Larger)?;
        let medium = self.medium.as_ref().ok_or(Larger)?;
        self.work.add(rules.price());
        let seen = Seen::new(
            &medium.ring,
            &self.vertices,
            row,
            steps,
            rules.needs_mates(),
        )?;
        let interval = |x: &Element<i128, N>| rules.ring.of(&x.0);
        let edges = each(&seen.edges, |edge| each(edge, interval))?;
        let mates: [Option<[Interval; 3]>; 4] = each(&seen.mates, |mate| {
            mate.as_ref().map(|x| each(x, interval)).transpose()
        })?;
        let next = None;
        let (_, attained) = Judge { rules, next }.check(&edges, &mates, simplex)?;
        if !self.claim.domain.is_region() {
            let (rules, next) = (medium, Some(&self.large));
            self.volume
                .add(&Judge { rules, next }.determinant(&seen.edges)?);
        }
        self.attained |= attained;
        Ok(())
    }

    #[inline(always)]
    fn add<T: Int>(&mut self, determinant: &Element<T, N>, attained: u32) {
        self.volume.add(determinant);
        self.attained |= attained;
    }

    /// The rules that concern all rows together.
    fn check_end(&self) -> Checked {
        self.front.check_end()?;
        // Every vertex is used.
        let unused = self.used.iter().zip(0u32..).find(|(used, _)| !**used);
        let vertex = unused.map_or(0, |(_, vertex)| vertex);
        ensure!(unused.is_none(), UnusedVertex, Place::Vertex(vertex));
        self.check_volume()?;
        // Each maximum and each minimum is attained.
        for (statement, bit) in to_attain(&self.claim) {
            let is_attained = self.attained & bit != 0;
            ensure!(is_attained, NotAttained, Place::Statement(statement));
        }
        Ok(())
    }

    /// Rule V: the determinants sum to D! times the volume of one cell of the lattice in the
    /// domain, all times the D-th power of the denominator. With k! vol P in place of the domain's
    /// volume the factor is D! / k!.
    fn check_volume(&self) -> Checked {
        if self.claim.domain.is_region() {
            return Ok(());
        }
        let rank = self.shape.rank;
        let mut factor = BigInt::from(1);
        for k in (self.shape.dimension - rank)..self.shape.dimension {
            factor *= k + 1;
        }
        for _ in 0..rank {
            factor *= &self.vertices.denominator;
        }
        let mut expected = match &self.faces {
            Some(faces) => faces.volume.clone(),
            None => self
                .rings
                .large
                .element(&[BigInt::from(1)])
                .unwrap_or_default(),
        };
        expected.0.iter_mut().for_each(|c| *c *= &factor);
        let sum = self.volume.sum();
        let found = || {
            let of = |x: &Element<BigInt, N>| self.rings.large.coefficients(x);
            Value::Quotient(of(&sum), of(&expected))
        };
        ensure!(sum == expected, VolumeSum, Place::Witness, found());
        Ok(())
    }
}

/// A simplex and the corners of its mates, seen from its first corner.
struct Seen<T, const N: usize> {
    edges: [[Element<T, N>; 3]; 3],
    mates: [Option<[Element<T, N>; 3]>; 4],
}

impl<T: Int, const N: usize> Seen<T, N> {
    #[inline(always)]
    fn new(
        ring: &Exact<T, N>,
        vertices: &Vertices,
        row: &Row,
        steps: &[Step; 4],
        needs_mates: bool,
    ) -> Result<Self, Larger> {
        let [a, b, c, d] = row.corners;
        let origin = vertices.point(a)?;
        let vector = |corner| ring.difference(&origin, &vertices.point(corner)?);
        // In the plane the last one is without meaning.
        let edges = [vector(b)?, vector(c)?, vector(d)?];
        let mates = each(steps, |step| match step {
            Step::Closed(corner) if needs_mates => vector(*corner).map(Some),
            _ => Ok(None),
        })?;
        Ok(Seen { edges, mates })
    }
}

/// A sum of determinants: in 128 bits as long as it fits.
struct Volume<const N: usize> {
    small: [i128; N],
    large: [BigInt; N],
}

impl<const N: usize> Default for Volume<N> {
    fn default() -> Self {
        Volume {
            small: [0; N],
            large: std::array::from_fn(|_| BigInt::ZERO),
        }
    }
}

impl<const N: usize> Volume<N> {
    #[inline(always)]
    fn add<T: Int>(&mut self, value: &Element<T, N>) {
        for ((small, large), c) in self.small.iter_mut().zip(&mut self.large).zip(&value.0) {
            match c.small().and_then(|c| small.checked_add(c)) {
                Some(sum) => *small = sum,
                None => *large += c.big(),
            }
        }
    }

    fn sum(&self) -> Element<BigInt, N> {
        let mut sum = Element(self.large.clone());
        for (sum, small) in sum.0.iter_mut().zip(self.small) {
            *sum += small;
        }
        sum
    }
}

/// Statements about angles need no domain. The others are defined for some domains only.
fn check_statements(claim: &Claim) -> Checked {
    let is_region = claim.domain.is_region();
    let is_space = claim.domain == crate::claim::Domain::Space;
    for (index, statement) in claim.statements.iter().enumerate() {
        let is_defined = match statement {
            Statement::Delaunay | Statement::WeaklyDelaunay => !is_region,
            Statement::LocallyDelaunay | Statement::LocallyWeaklyDelaunay => is_region,
            Statement::Tcp => claim.dimension == 3 && is_space,
            _ => true,
        };
        ensure!(is_defined, StatementDomain, Place::Statement(index));
    }
    Ok(())
}

fn index(number: u32) -> usize {
    usize::try_from(number).unwrap_or(usize::MAX)
}
