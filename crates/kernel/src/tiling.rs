//! One pass over the witness of a tiling: each row is checked as it is read, and forgotten.
//!
//! The vertices, the open facets and the open edges stay in memory. [`Verified`] is made in one
//! place, after the last check.

use crate::cbor::Cbor;
use crate::claim::{Claim, Domain, Property, Relation};
use crate::edges::Edges;
use crate::front::Front;
use crate::limits::Work;
use crate::numbers::{Numbers, Single};
use crate::planes;
use crate::refusal::{Checked, Place, Stop, Value};
use crate::row::{Row, Shape};
use crate::rules::INSIDE;
use crate::table::index;
use std::ops::Deref;
use std::rc::Rc;

/// A certificate that fulfils every condition of the format. Only [`crate::verify`] makes one, and nobody can change it.
#[derive(Debug)]
pub struct Verified(pub(crate) Facts);

/// The claim that is proved, and some counts.
#[derive(Debug)]
pub struct Facts {
    /// The claim that is proved.
    pub claim: Claim,
    /// The number of vertices.
    pub vertices: u32,
    /// The number of simplices.
    pub simplices: u64,
    /// Facets in the boundary of the domain.
    pub boundary_facets: u64,
    /// The largest number of open facets at one time.
    pub peak_facets: usize,
    /// With `TCP`, the largest number of open edges at one time.
    pub peak_edges: usize,
    /// The length of the certificate.
    pub bytes: u64,
    /// The SHA-256 of its bytes.
    pub sha256: [u8; 32],
}

impl Deref for Verified {
    type Target = Facts;

    fn deref(&self) -> &Facts {
        &self.0
    }
}

/// Reads the rest of a certificate whose claim has been read.
pub(crate) fn verify<const N: usize>(mut cbor: Cbor, claim: Claim) -> Checked<Facts> {
    let work = &cbor.work.clone();
    let numbers = Single::<N>::new(&claim, work)?;
    check_statements(&claim)?;
    let mut pass = Pass::new(&claim, numbers, work);
    cbor.array_of(4)?;
    pass.numbers.read_denominator(&claim, &mut cbor)?;
    pass.read_vertices(&mut cbor)?;
    pass.read_boundary(&mut cbor)?;
    let simplices = read_count(&mut cbor, 0)?;
    for simplex in 0..simplices {
        let row = pass.shape.read_row(&mut cbor, simplex)?;
        pass.check_row(&row, simplex)?;
        let checked = planes::check_row(&claim, &pass.numbers, &row, simplex);
        checked.map_err(|stop| stop.at(Place::Simplex(simplex)))?;
    }
    let (bytes, sha256) = cbor.finish()?;
    pass.check_end()?;
    let ((boundary_facets, peak_facets, peak_edges), vertices) = (pass.counts(), pass.shape.vertices);
    Ok(Facts { vertices, simplices, boundary_facets, peak_facets, peak_edges, bytes, sha256, claim })
}

/// Reads the length of a list of simplices. Together with those of earlier lists it is within the limit.
pub(crate) fn read_count(cbor: &mut Cbor, before: u64) -> Checked<u64> {
    let count = cbor.array()?;
    // An empty list proves nothing.
    ensure!(count > 0, NoSimplices, Place::Witness);
    let all = count.saturating_add(before);
    ensure!(all <= cbor.limits.simplices, TooManySimplices, Place::Witness, Value::Limit("simplices", Some(all)));
    Ok(count)
}

/// The check of one tiling, or of one part of a larger structure: its rows come one by one.
pub(crate) struct Pass<'c, M> {
    claim: &'c Claim,
    pub(crate) shape: Shape,
    pub(crate) numbers: M,
    work: Rc<Work>,
    /// Whether a row has the vertex.
    used: Vec<bool>,
    /// The faces of the domain in which each vertex lies, up to the last one in a face.
    pub(crate) faces: Vec<Vec<u32>>,
    front: Front,
    edges: Option<Edges>,
    /// The set of the statements of which some simplex attains the bound.
    attained: u32,
}

impl<const N: usize> Pass<'_, Single<N>> {
    pub(crate) fn read_vertices(&mut self, cbor: &mut Cbor) -> Checked {
        for _ in 0..cbor.array()? {
            self.numbers.vertices.read(cbor)?;
            self.add_vertex()?;
        }
        self.numbers.vertices.check_lowest(cbor.place())
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
            self.numbers.add_boundary(facets, self.shape)?;
        }
        Ok(())
    }
}

impl<'c, M> Pass<'c, M> {
    pub(crate) fn new(claim: &'c Claim, numbers: M, work: &Rc<Work>) -> Self {
        let has_sixes = claim.has(Property::Tcp);
        let (dimension, rank) = (claim.dimension, claim.rank());
        let shape = Shape { dimension, rank, vertices: 0, has_sixes };
        let (front, edges) = (Front::new(dimension, work), has_sixes.then(|| Edges::new(work)));
        let (work, used, faces) = (work.clone(), Vec::new(), Vec::new());
        Pass { claim, shape, numbers, work, used, faces, front, edges, attained: 0 }
    }

    /// The numbers of facets in the boundary, and of the peaks of open facets and edges.
    pub(crate) fn counts(&self) -> (u64, usize, usize) {
        let edges = self.edges.as_ref().map_or(0, |edges| edges.peak);
        (self.front.boundary, self.front.open.peak, edges)
    }
}

impl<M: Numbers> Pass<'_, M> {
    /// Checks I for the next vertex.
    pub(crate) fn add_vertex(&mut self) -> Checked {
        let place = Place::Vertex(self.shape.vertices);
        let faces = self.numbers.faces(self.shape.vertices).map_err(|stop| stop.at(place))?;
        if !faces.is_empty() {
            self.faces.resize(self.used.len(), Vec::new());
            self.faces.push(faces);
        }
        self.used.push(false);
        self.shape.vertices += 1;
        self.work.check(place)
    }

    pub(crate) fn check_row(&mut self, row: &Row, simplex: u64) -> Checked {
        for corner in row.corners.iter().take(self.shape.dimension + 1) {
            *self.used.get_mut(index(corner.vertex)).ok_or_else(|| Stop::LARGER)? = true;
        }
        // Whether vertices lie in one face.
        let share = |corners: [u32; 3]| {
            let [a, b, c] = corners.map(|vertex| self.faces.get(index(vertex)).map_or(&[][..], Vec::as_slice));
            self.work.add(u64::try_from(a.len()).unwrap_or(u64::MAX) * 20);
            let has = |faces: &[u32], face| faces.binary_search(face).is_ok();
            a.iter().any(|face| has(b, face) && has(c, face))
        };
        let steps = self.front.step(row, share, simplex)?;
        if let Some(edges) = &mut self.edges {
            edges.step(row, &steps, simplex)?;
        }
        self.attained |= self.numbers.check(row, &steps, simplex)?;
        self.work.check(Place::Simplex(simplex))
    }

    /// The rules that concern all rows together.
    pub(crate) fn check_end(&self) -> Checked {
        self.front.check_end()?;
        // Every vertex is used.
        if let Some((_, vertex)) = self.used.iter().zip(0..).find(|(used, _)| !**used) {
            ensure!(false, UnusedVertex, Place::Vertex(vertex));
        }
        self.numbers.check_volume(self.shape)?;
        check_attained(self.claim, self.attained)
    }
}

/// Each maximum and each minimum is attained.
pub(crate) fn check_attained(claim: &Claim, attained: u32) -> Checked {
    for (statement, index) in claim.statements.iter().zip(0..) {
        let relation = statement.bound.as_ref().map(|bound| bound.relation);
        let is_extreme = matches!(relation, Some(Relation::Maximum | Relation::Minimum));
        // Bounds are among the first statements, so their bits exist.
        ensure!(!is_extreme || attained >> index & 1 == 1, NotAttained, Place::Statement(index));
        let is_about_spheres = statement.property == Property::NotDelaunay;
        ensure!(!is_about_spheres || attained >> INSIDE == 1, NoneInside, Place::Statement(index));
    }
    Ok(())
}

/// Statements about angles need no domain. The others are defined for some domains only, and planes for single tilings.
pub(crate) fn check_statements(claim: &Claim) -> Checked {
    let is_region = matches!(claim.domain, Domain::Region(_));
    let is_mosaic = matches!(claim.domain, Domain::Mosaics(_));
    for (index, statement) in claim.statements.iter().enumerate() {
        let is_defined = match statement.property {
            Property::Delaunay | Property::WeaklyDelaunay => !is_region,
            Property::LocallyDelaunay | Property::LocallyWeaklyDelaunay => is_region,
            Property::Tcp => claim.dimension == 3 && (is_mosaic || claim.domain == Domain::Space),
            Property::UncrossedPlane => !is_mosaic && claim.parameters.is_empty(),
            // It would be about each mosaic, and the cells differ.
            Property::NotDelaunay => !is_mosaic,
            _ => true,
        };
        ensure!(is_defined, StatementDomain, Place::Statement(index));
    }
    Ok(())
}
