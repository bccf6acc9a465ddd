//! One pass over the witness of a tiling: each row is checked as it is read, and forgotten.
//!
//! The vertices, the open facets and the open edges stay in memory. [`Verified`] is made in one
//! place, after the last check.

use crate::cbor::Cbor;
use crate::claim::{Claim, Domain, Property, Relation};
use crate::domain::Faces;
use crate::edges::Edges;
use crate::filter::Intervals;
use crate::front::{Front, Step};
use crate::int::Int;
use crate::judge::Judge;
use crate::limits::{Limits, Work};
use crate::refusal::{Checked, Place, Stop, Value};
use crate::region::Region;
use crate::ring::{Element, Exact, Ring, Rings, each};
use crate::root::Root;
use crate::row::{Row, Shape};
use crate::rules::Rules;
use crate::vertices::Vertices;
use num_bigint::BigInt;
use std::ops::Deref;
use std::rc::Rc;

/// A certificate that fulfils every condition of the format. Only this module makes one.
#[derive(Debug)]
pub struct Verified(Facts);

/// What is proved, and some counts.
#[derive(Debug)]
pub struct Facts {
    pub claim: Claim,
    pub vertices: u32,
    pub simplices: u64,
    /// Facets in the boundary of the domain.
    pub boundary_facets: u64,
    /// The largest numbers of open facets and, with `TCP`, of open edges at one time.
    pub peak_facets: usize,
    pub peak_edges: usize,
    pub bytes: u64,
    pub sha256: [u8; 32],
}

impl Deref for Verified {
    type Target = Facts;

    fn deref(&self) -> &Facts {
        &self.0
    }
}

/// Reads the rest of a certificate whose claim has been read.
pub(crate) fn verify<const N: usize>(
    mut cbor: Cbor,
    claim: Claim,
    limits: &Limits,
    work: &Rc<Work>,
) -> Checked<Verified> {
    let mut tiling = Tiling::<N>::new(claim, work)?;
    tiling.read_vertices(&mut cbor)?;
    tiling.read_boundary(&mut cbor)?;
    let simplices = cbor.array()?;
    // An empty list proves nothing.
    ensure!(simplices > 0, NoSimplices, Place::Witness);
    let exceeds = Value::Limit("simplices", Some(simplices));
    ensure!(simplices <= limits.simplices, TooManySimplices, Place::Witness, exceeds);
    for simplex in 0..simplices {
        let row = tiling.shape.read_row(&mut cbor, simplex)?;
        tiling.check_row(&row, simplex)?;
    }
    let (bytes, sha256) = cbor.finish()?;
    tiling.check_end()?;
    Ok(Verified(Facts {
        vertices: tiling.vertices.count,
        simplices,
        boundary_facets: tiling.front.boundary,
        peak_facets: tiling.front.peak(),
        peak_edges: tiling.edges.map_or(0, |edges| edges.peak()),
        bytes,
        sha256,
        claim: tiling.claim,
    }))
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
    /// The sum of the determinants.
    volume: Element<BigInt, N>,
    /// The set of the statements of which some simplex attains the bound.
    attained: u32,
}

impl<const N: usize> Tiling<N> {
    /// Checks what the claim states of its own numbers.
    pub(crate) fn new(claim: Claim, work: &Rc<Work>) -> Checked<Tiling<N>> {
        let root = Rc::new(Root::new(&claim.field, work)?);
        let rings = Rc::new(Rings::<N>::new(&root, work)?);
        let large = Rules::new(&rings.large, &claim).map_err(|stop| stop.at(Place::Field))?;
        let faces = match &claim.domain {
            Domain::Polytope(polytope) => {
                let faces = Faces::new(polytope, claim.dimension, &rings.large);
                Some(faces.map_err(|stop| stop.at(Place::Domain))?)
            }
            _ => None,
        };
        check_statements(&claim)?;
        let has_sixes = claim.has(Property::Tcp);
        let (dimension, rank) = (claim.dimension, claim.rank());
        Ok(Tiling {
            shape: Shape { dimension, rank, vertices: 0, has_sixes },
            faces,
            region: None,
            vertices: Vertices::new(dimension, claim.field.degree()),
            used: Vec::new(),
            front: Front::new(dimension, work),
            edges: has_sixes.then(|| Edges::new(work)),
            small: rings.small.as_ref().and_then(|ring| Rules::new(ring, &claim).ok()),
            medium: rings.medium.as_ref().and_then(|ring| Rules::new(ring, &claim).ok()),
            large,
            intervals: Rules::new(&rings.intervals, &claim).ok(),
            rings,
            volume: Element::default(),
            attained: 0,
            work: work.clone(),
            claim,
        })
    }

    fn read_vertices(&mut self, cbor: &mut Cbor) -> Checked {
        cbor.array_of(4)?;
        self.vertices.read_denominator(cbor)?;
        if let (Some(faces), Domain::Polytope(polytope)) = (&mut self.faces, &self.claim.domain) {
            faces.set_denominator(polytope, &self.vertices.denominator, &self.rings)?;
        }
        let (faces, work) = (&mut self.faces, &self.work);
        self.vertices.read(cbor, |vertices, vertex| {
            if let Some(faces) = faces {
                faces.check_vertex(vertices, vertex)?;
            }
            work.check(Place::Vertex(vertex))
        })?;
        self.shape.vertices = self.vertices.count;
        self.used = vec![false; index(self.vertices.count)];
        Ok(())
    }

    fn read_boundary(&mut self, cbor: &mut Cbor) -> Checked {
        let count = cbor.array()?;
        // A region without boundary is space; other domains compute their boundary.
        let is_region = matches!(self.claim.domain, Domain::Region(_));
        ensure!((count > 0) == is_region, BoundaryDomain, Place::Witness, count);
        let mut facets = Vec::new();
        for index in 0..count {
            let facet = self.shape.read_facet(cbor, index)?;
            self.front.list(facet, index)?;
            self.work.check(Place::Boundary(index))?;
            facets.push(facet);
        }
        if is_region {
            let (vertices, rings) = (&self.vertices, &self.rings);
            self.region = Some(Region::new(facets, self.shape, vertices, rings, &self.work)?);
        }
        Ok(())
    }

    pub(crate) fn check_row(&mut self, row: &Row, simplex: u64) -> Checked {
        for corner in row.corners.iter().take(self.shape.dimension + 1) {
            *self.used.get_mut(index(corner.vertex)).ok_or(Stop::LARGER)? = true;
        }
        let steps = match &self.faces {
            None => self.front.step(row, |_| false, simplex)?,
            Some(faces) => self.front.step(row, |facet| faces.share(facet), simplex)?,
        };
        if let Some(edges) = &mut self.edges {
            edges.step(row, &steps, simplex)?;
        }
        match self.judge(self.small.as_ref(), self.medium.as_ref(), row, &steps, simplex) {
            Ok(found) => self.add(found),
            Err(stop) if stop.is_larger() => self.judge_larger(row, &steps, simplex)?,
            Err(stop) => return Err(stop),
        }
        if let Some(region) = &self.region {
            region.check_row(row, &self.vertices, simplex)?;
        }
        self.work.check(Place::Simplex(simplex))
    }

    /// The judgement where products do not fit 64 bits: by intervals, and then by larger integers.
    #[cold]
    #[inline(never)]
    fn judge_larger(&mut self, row: &Row, steps: &[Step; 4], simplex: u64) -> Checked {
        if self.judge_by_intervals(row, steps, simplex).is_ok() {
            return Ok(());
        }
        match self.judge(self.medium.as_ref(), Some(&self.large), row, steps, simplex) {
            Err(stop) if stop.is_larger() => {}
            found => return found.map(|found| self.add(found)),
        }
        let found = self.judge(Some(&self.large), None, row, steps, simplex);
        self.add(found.map_err(|stop| stop.at(Place::Simplex(simplex)))?);
        Ok(())
    }

    fn judge<T: Int>(
        &self,
        rules: Option<&Rules<Exact<T, N>>>,
        next: Option<&Rules<Exact<T::Next, N>>>,
        row: &Row,
        steps: &[Step; 4],
        simplex: u64,
    ) -> Checked<(Element<T, N>, u32)> {
        let rules = rules.ok_or(Stop::LARGER)?;
        self.work.add(rules.price());
        let seen = Seen::new(rules, &self.vertices, row, steps)?;
        let found = Judge { rules, next }.check(&seen.edges, &seen.mates, simplex);
        found.map_err(|stop| stop.over(&self.vertices.denominator, self.shape.dimension))
    }

    /// The judgement by intervals. Only the volume needs the determinant itself. Exact integers
    /// repeat a refusal, for its value.
    fn judge_by_intervals(&mut self, row: &Row, steps: &[Step; 4], simplex: u64) -> Checked {
        let rules = self.intervals.as_ref().ok_or(Stop::LARGER)?;
        let medium = self.medium.as_ref().ok_or(Stop::LARGER)?;
        self.work.add(rules.price());
        let seen = Seen::new(medium, &self.vertices, row, steps)?;
        let vector = |x: &[Element<i128, N>; 3]| each(x, |x| rules.ring.of(&x.0));
        let edges = each(&seen.edges, vector)?;
        let mates = each(&seen.mates, |mate| mate.as_ref().map(vector).transpose())?;
        let (_, attained) = Judge { rules, next: None }.check(&edges, &mates, simplex)?;
        if self.region.is_none() {
            let normal = medium.first_normal(&seen.edges)?;
            match medium.ring.inner(&seen.edges[0], &normal) {
                Ok(determinant) => self.add((determinant, attained)),
                Err(_) => {
                    let next = |x: &[Element<i128, N>; 3]| x.each_ref().map(Exact::<i128, N>::next);
                    let determinant = self.rings.large.inner(&next(&seen.edges[0]), &next(&normal))?;
                    self.add((determinant, attained));
                }
            }
        }
        self.attained |= attained;
        Ok(())
    }

    /// Adds a judged simplex to the statements about all of them.
    fn add<T: Int>(&mut self, (determinant, attained): (Element<T, N>, u32)) {
        for (sum, c) in self.volume.0.iter_mut().zip(&determinant.0) {
            *sum += c.big();
        }
        self.attained |= attained;
    }

    /// The rules that concern all rows together.
    fn check_end(&self) -> Checked {
        self.front.check_end()?;
        // Every vertex is used.
        if let Some((_, vertex)) = self.used.iter().zip(0..).find(|(used, _)| !**used) {
            ensure!(false, UnusedVertex, Place::Vertex(vertex));
        }
        if self.region.is_none() {
            self.check_volume()?;
        }
        // Each maximum and each minimum is attained.
        for (statement, index) in self.claim.statements.iter().zip(0..) {
            let relation = statement.bound.as_ref().map(|bound| bound.relation);
            let is_extreme = matches!(relation, Some(Relation::Maximum | Relation::Minimum));
            let is_attained = self.attained >> index & 1 == 1;
            ensure!(!is_extreme || is_attained, NotAttained, Place::Statement(index));
        }
        Ok(())
    }

    /// Rule V: the determinants sum to D! times the volume of one cell of the lattice in the
    /// domain, all times the D-th power of the denominator. With k! vol P in place of the domain's
    /// volume the factor is D! / k!.
    fn check_volume(&self) -> Checked {
        let ring = &self.rings.large;
        let mut expected = match &self.faces {
            Some(faces) => faces.volume.clone(),
            None => ring.integer(1)?,
        };
        for factor in (1..=self.shape.dimension).rev().take(self.shape.rank) {
            for c in &mut expected.0 {
                *c *= &self.vertices.denominator * factor;
            }
        }
        let is_equal = self.volume == expected;
        let found = || ring.quotient(&self.volume, &expected);
        ensure!(is_equal, VolumeSum, Place::Witness, found());
        Ok(())
    }
}

/// A simplex and the corners of its mates, seen from its first corner.
struct Seen<T, const N: usize> {
    edges: [[Element<T, N>; 3]; 3],
    mates: [Option<[Element<T, N>; 3]>; 4],
}

impl<T: Int, const N: usize> Seen<T, N> {
    fn new(rules: &Rules<Exact<T, N>>, vertices: &Vertices, row: &Row, steps: &[Step; 4]) -> Checked<Self> {
        let [a, b, c, d] = row.corners;
        let origin = vertices.point(a)?;
        let vector = |corner| rules.ring.difference(&origin, &vertices.point(corner)?);
        // In the plane the last one is without meaning.
        let edges = [vector(b)?, vector(c)?, vector(d)?];
        let mates = each(steps, |step| match step {
            Step::Closed(corner) if rules.needs_mates() => vector(*corner).map(Some),
            _ => Ok(None),
        })?;
        Ok(Seen { edges, mates })
    }
}

/// Statements about angles need no domain. The others are defined for some domains only.
fn check_statements(claim: &Claim) -> Checked {
    let is_region = matches!(claim.domain, Domain::Region(_));
    for (index, statement) in claim.statements.iter().enumerate() {
        let is_defined = match statement.property {
            Property::Delaunay | Property::WeaklyDelaunay => !is_region,
            Property::LocallyDelaunay | Property::LocallyWeaklyDelaunay => is_region,
            Property::Tcp => claim.dimension == 3 && claim.domain == Domain::Space,
            _ => true,
        };
        ensure!(is_defined, StatementDomain, Place::Statement(index));
    }
    Ok(())
}

fn index(number: u32) -> usize {
    usize::try_from(number).unwrap_or(usize::MAX)
}
