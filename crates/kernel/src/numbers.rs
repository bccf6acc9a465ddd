//! The checks of a tiling that need coordinates, by the smallest integers that suffice.
//!
//! Each question goes to integers of 64 bits, and on if a result does not fit or a sign is not
//! visible: to intervals, to the same with 128 bits, and to integers of any size.

use crate::cbor::Cbor;
use crate::claim::{Claim, Domain};
use crate::domain::Facets;
use crate::filter::{Interval, Intervals};
use crate::front::Step;
use crate::int::Int;
use crate::limits::Work;
use crate::refusal::{Checked, Place, Stop};
use crate::region::Region;
use crate::ring::{Element, Exact, Ring, Sign, Vector, each, zip};
use crate::root::Root;
use crate::row::{Corner, Row, Shape};
use crate::rules::{Rules, Simplex};
use crate::vertices::Vertices;
use num_bigint::BigInt;
use num_integer::Integer;
use std::cell::RefCell;
use std::cmp::Ordering::Equal;
use std::mem::replace;
use std::rc::Rc;

/// The claim in the numbers of one ring.
pub(crate) struct Model<R: Ring> {
    pub(crate) rules: Rules<R>,
    facets: Option<Facets<R>>,
}

impl<R: Ring> Model<R> {
    /// Checks the numbers of the claim.
    pub(crate) fn new(ring: &R, claim: &Claim) -> Checked<Self> {
        let rules = Rules::new(ring, claim).map_err(|stop| stop.at(Place::Field))?;
        let facets = match &claim.domain {
            Domain::Polytope(polytope) => Some(Facets::new(polytope, claim.dimension, ring)),
            _ => None,
        };
        Ok(Model { rules, facets: facets.transpose().map_err(|stop| stop.at(Place::Domain))? })
    }

    /// The vertices of the tiling have this denominator.
    pub(crate) fn set_denominator(&mut self, claim: &Claim, denominator: &BigInt) -> Checked {
        if let (Some(facets), Domain::Polytope(polytope)) = (&mut self.facets, &claim.domain) {
            // In a tiling every vertex of P is a corner, so its coordinates have this denominator.
            let (factor, rest) = denominator.div_rem(&polytope.denominator);
            ensure!(rest == BigInt::ZERO, DenominatorDomain, Place::Witness, polytope.denominator.clone());
            facets.factor = self.rules.ring.long(&factor)?;
        }
        Ok(())
    }

    /// The faces of the domain in which a vertex lies.
    pub(crate) fn faces(&self, point: &Vector<R>, vertex: u32) -> Checked<Vec<u32>> {
        self.facets.as_ref().map_or(Ok(Vec::new()), |facets| facets.of_vertex(point, vertex))
    }

    /// A row's simplex, in the numbers of any ring. In the plane the last edge is (0, 0, 1).
    pub(crate) fn simplex<S: Ring>(
        &self,
        ring: &S,
        row: &Row,
        steps: &[Step; 4],
        number: u64,
        point: impl Fn(Corner) -> Checked<Vector<S>>,
    ) -> Checked<Simplex<S>> {
        ring.work().add(300 * ring.price());
        let [a, b, c, d] = row.corners;
        let origin = point(a)?;
        let vector = |corner| ring.difference(&origin, &point(corner)?);
        let third = if self.rules.is_plane {
            [S::Element::default(), S::Element::default(), ring.integer(1)?]
        } else {
            vector(d)?
        };
        let mates = each(steps, |step| match step {
            Step::Closed(corner) if self.rules.needs_mates() => vector(*corner).map(Some),
            _ => Ok(None),
        })?;
        Ok(Simplex { number, edges: [vector(b)?, vector(c)?, third], mates })
    }

    /// Rule V: the determinants sum to D! times the volume of one cell of the lattice in the domain, all times the D-th
    /// power of the denominator. With k! vol P in place of the domain's volume the factor is D! / k!.
    pub(crate) fn check_volume(&self, sum: &R::Element, shape: Shape, denominator: &BigInt) -> Checked {
        let ring = &self.rules.ring;
        let (mut expected, factor) = match &self.facets {
            Some(facets) => (facets.volume.clone(), facets.factor.clone()),
            None => (ring.integer(1)?, ring.integer(1)?),
        };
        for k in 0..shape.dimension {
            let unit = ring.element(&[denominator * (shape.dimension - k)])?;
            expected = ring.times(&expected, if k < shape.rank { &unit } else { &factor })?;
        }
        let is_equal = ring.sign(&ring.minus(sum, &expected)?) == Sign::exactly(Equal);
        ensure!(is_equal, VolumeSum, Place::Witness, ring.quotient(sum, &expected));
        Ok(())
    }
}

/// The numbers of a tiling, or of one part of a family of tilings.
pub(crate) trait Numbers {
    /// Checks I for a vertex. Returns the faces of the domain in which it lies.
    fn faces(&self, vertex: u32) -> Checked<Vec<u32>>;
    /// Checks the statements about a simplex, and counts its volume. Returns the set of the
    /// statements of which it attains the bound.
    fn check(&mut self, row: &Row, steps: &[Step; 4], simplex: u64) -> Checked<u32>;
    fn check_volume(&self, shape: Shape) -> Checked;
}

/// A ring, and the statements in it where their numbers fit.
type Size<T, const N: usize> = (Exact<T, N>, Option<Rules<Exact<T, N>>>);

/// A sum of integers. Those of 128 bits are added to each other as long as their sum fits.
#[derive(Default)]
struct Sum {
    recent: i128,
    others: BigInt,
}

impl Sum {
    fn add<T: Int>(&mut self, x: &T) {
        match x.wide().map(|x| (x, self.recent.checked_add(x))) {
            Ok((_, Some(sum))) => self.recent = sum,
            Ok((x, None)) => self.others += replace(&mut self.recent, x),
            Err(_) => self.others += x.big(),
        }
    }
}

/// The numbers of one tiling.
pub(crate) struct Single<const N: usize> {
    pub(crate) vertices: Vertices,
    small: Option<Size<i64, N>>,
    medium: Option<Size<i128, N>>,
    pub(crate) large: Model<Exact<BigInt, N>>,
    intervals: Option<Rules<Intervals>>,
    region: Option<Region<N>>,
    /// x and y for the sum x + 2^62 y of the determinants.
    volume: RefCell<[Element<Sum, N>; 2]>,
}

fn size<T: Int, const N: usize>(root: &Rc<Root>, claim: &Claim, work: &Rc<Work>) -> Option<Size<T, N>> {
    let ring = Exact::new(root, work).ok()?;
    let rules = Rules::new(&ring, claim).ok();
    Some((ring, rules))
}

impl<const N: usize> Single<N> {
    /// Checks the numbers of the claim.
    pub(crate) fn new(claim: &Claim, work: &Rc<Work>) -> Checked<Self> {
        let root = Rc::new(Root::new(&claim.field, work)?);
        let large = Model::new(&Exact::new(&root, work)?, claim)?;
        let intervals = Rules::new(&Intervals { root: root.clone(), work: work.clone() }, claim).ok();
        let vertices = Vertices::new(claim.dimension, claim.field.degree());
        let (small, medium) = (size(&root, claim, work), size(&root, claim, work));
        Ok(Single { vertices, small, medium, large, intervals, region: None, volume: Default::default() })
    }

    pub(crate) fn read_denominator(&mut self, claim: &Claim, cbor: &mut Cbor) -> Checked {
        self.vertices.read_denominator(cbor)?;
        self.large.set_denominator(claim, &self.vertices.denominator)
    }

    /// Checks X for the facets of the list `boundary`.
    pub(crate) fn add_boundary(&mut self, facets: Vec<[Corner; 3]>, shape: Shape) -> Checked {
        let large = self.large.rules.ring.clone();
        let rings = (Exact::new(&large.root, &large.work).ok(), large);
        self.region = Some(Region::new(facets, shape, &self.vertices, rings)?);
        Ok(())
    }

    /// The judgement by integers of one size, or else by intervals around its edges. Counts the volume.
    fn judge<T: Int>(
        &self,
        ring: &Exact<T, N>,
        rules: Option<&Rules<Exact<T, N>>>,
        row: &Row,
        steps: &[Step; 4],
        number: u64,
    ) -> Checked<u32> {
        let simplex = self.large.simplex(ring, row, steps, number, |corner| self.vertices.point(corner))?;
        let rules = rules.ok_or_else(|| Stop::LARGER);
        match rules.and_then(|rules| rules.check(&simplex, &self.vertices.denominator)) {
            Err(stop) if stop.is_larger() => self.judge_by_intervals(&simplex),
            found => found.map(|(determinant, attained)| {
                self.add_volume([determinant]);
                attained
            }),
        }
    }

    fn add_volume<T: Int, const K: usize>(&self, parts: [Element<T, N>; K]) {
        for (sum, part) in self.volume.borrow_mut().iter_mut().zip(&parts) {
            sum.0.iter_mut().zip(&part.0).for_each(|(sum, c)| sum.add(c));
        }
    }

    /// Only the volume needs the determinant itself. Exact integers repeat a refusal, for its value.
    #[cold]
    #[inline(never)]
    fn judge_by_intervals<T: Int>(&self, simplex: &Simplex<Exact<T, N>>) -> Checked<u32> {
        let rules = self.intervals.as_ref().ok_or_else(|| Stop::LARGER)?;
        let vector = |x: &[Element<T, N>; 3]| each(x, |x| Interval::of(&x.0, &rules.ring.root));
        let intervals = Simplex {
            number: simplex.number,
            edges: each(&simplex.edges, vector)?,
            mates: each(&simplex.mates, |mate| mate.as_ref().map(vector).transpose())?,
        };
        let found = rules.check(&intervals, &self.vertices.denominator);
        let (_, attained) = found.map_err(|_| Stop::LARGER)?;
        if self.region.is_some() {
            return Ok(attained);
        }
        let (ring, _) = self.medium.as_ref().ok_or_else(|| Stop::LARGER)?;
        let [e1, e2, e3] = each(&simplex.edges, |edge| each(edge, wide))?;
        let normal = ring.cross(&e2, &e3)?;
        if let Ok(determinant) = ring.inner(&e1, &normal) {
            self.add_volume([determinant]);
            return Ok(attained);
        }
        // A normal is x + 2^62 y, and products of these with edges of 62 bits fit 128 bits.
        let x = normal.each_ref().map(|x| Element(x.0.map(|c| c & ((1 << 62) - 1))));
        let y = normal.each_ref().map(|x| Element(x.0.map(|c| c >> 62)));
        self.add_volume([ring.inner(&e1, &x)?, ring.inner(&e1, &y)?]);
        Ok(attained)
    }
}

fn wide<T: Int, const N: usize>(x: &Element<T, N>) -> Checked<Element<i128, N>> {
    each(&x.0, T::wide).map(Element)
}

impl<const N: usize> Numbers for Single<N> {
    fn faces(&self, vertex: u32) -> Checked<Vec<u32>> {
        let corner = Corner { vertex, shift: [0; 3] };
        self.large.faces(&self.vertices.point(corner)?, vertex)
    }

    fn check(&mut self, row: &Row, steps: &[Step; 4], simplex: u64) -> Checked<u32> {
        let mut found = Err(Stop::LARGER);
        if let Some((ring, rules)) = &self.small {
            found = self.judge(ring, rules.as_ref(), row, steps, simplex);
        }
        if let (Err(Stop::LARGER), Some((ring, rules))) = (&found, &self.medium) {
            found = self.judge(ring, rules.as_ref(), row, steps, simplex);
        }
        if found == Err(Stop::LARGER) {
            let rules = &self.large.rules;
            found = self.judge(&rules.ring, Some(rules), row, steps, simplex);
        }
        let attained = found.map_err(|stop| stop.at(Place::Simplex(simplex)))?;
        if let Some(region) = &self.region {
            region.check_row(row, &self.vertices, simplex)?;
        }
        Ok(attained)
    }

    fn check_volume(&self, shape: Shape) -> Checked {
        if self.region.is_some() {
            return Ok(());
        }
        let [x, y] = &*self.volume.borrow();
        let total = |sum: &Sum| &sum.others + sum.recent;
        let volume = Element(zip(&x.0, &y.0, |x, y| Ok(total(x) + (total(y) << 62)))?);
        self.large.check_volume(&volume, shape, &self.vertices.denominator)
    }
}
