//! The statements about single simplices, in the numbers of one ring.
//!
//! e_1, e_2, e_3 are the edges from the first corner, times the common denominator. n_1, n_2, n_3 are their cross
//! products: n_i · e_j is det E for i = j and else 0. So n_i / det E is the gradient of the i-th barycentric
//! coordinate, and n_0 = -(n_1 + n_2 + n_3). Covectors have the inner product ⟨n, m⟩ = n adj(G) m, up to the factor det
//! G > 0. Everything is homogeneous in the coordinates and in G, so positive factors do not matter.
//!
//! In the plane G gets a third row (0, 0, 1), e_3 is (0, 0, 1), and n_3 is left out.

use crate::claim::{Bound, Claim, Property, Relation};
use crate::filter::Range;
use crate::refusal::{Checked, Place, Stop, Value};
use crate::ring::{Ring, Sign, Vector, each};
use num_bigint::BigInt;
use std::cmp::Ordering::{self, Equal, Greater, Less};

/// The claim about single simplices.
pub(crate) struct Rules<R: Ring> {
    pub(crate) ring: R,
    pub(crate) is_plane: bool,
    /// G is the unit matrix.
    is_unit: bool,
    gram: [Vector<R>; 3],
    adjugate: [Vector<R>; 3],
    four_det_gram: R::Element,
    acute: bool,
    nonobtuse: bool,
    angles: Vec<Extreme<R>>,
    ratios: Vec<Extreme<R>>,
    delaunay: bool,
    weakly_delaunay: bool,
    not_delaunay: bool,
}

/// A bound p/q for the least or the greatest of some quotients of a simplex. The quotients are the squared cosines,
/// with the signs of the cosines, and R²/l² for all edge lengths l. So the largest angle is a least quotient.
struct Extreme<R: Ring> {
    statement: usize,
    property: Property,
    relation: Relation,
    minus_p: R::Element,
    q: R::Element,
    range: Range,
}

/// A simplex and the corners of its mates, seen from its first corner.
pub(crate) struct Simplex<R: Ring> {
    pub(crate) number: u64,
    pub(crate) edges: [Vector<R>; 3],
    pub(crate) mates: [Option<Vector<R>>; 4],
}

/// Of a quotient: the sign and a range. If the sign is undecided, the quotient is one of two, and its numerator is
/// positive here.
type Size = (Sign, Range);

/// The inner products of the pairs (1, 1), (1, 2), (1, 3), (2, 2), (2, 3), (3, 3) of three vectors.
type Products<R> = [<R as Ring>::Element; 6];

/// -⟨n_i, n_j⟩ for the pairs of facets, and all ⟨n_i, n_i⟩.
type Cosines<R> = ([<R as Ring>::Element; 6], [<R as Ring>::Element; 4]);

/// The facets of the angles, by the corners that they do not have. The first three are those of the plane.
const FACETS: [(usize, usize); 6] = [(0, 1), (0, 2), (1, 2), (0, 3), (1, 3), (2, 3)];

/// The bit of `not Delaunay` among those of the statements. Bounds have less than 22 bits.
pub(crate) const INSIDE: u32 = 31;

/// The determinant of a simplex, and the set of the statements of which it attains the bound.
pub(crate) type Found<R> = (<R as Ring>::Element, u32);

impl<R: Ring> Rules<R> {
    pub(crate) fn new(ring: &R, claim: &Claim) -> Checked<Self> {
        let gram = gram(ring, claim)?;
        let [r, s, t] = &gram;
        let adjugate = [ring.cross(s, t)?, ring.cross(t, r)?, ring.cross(r, s)?];
        let determinant = ring.inner(r, &adjugate[0])?;
        // Rule M: G is positive definite (Sylvester). In the plane the third minor is the second.
        let minors = [&gram[0][0], &adjugate[2][2], &determinant];
        for (minor, rows) in minors.into_iter().zip(1..) {
            let is_positive = ring.sign(minor).is(|sign| sign == Greater)?;
            ensure!(is_positive, GramNotPositive, Place::Minor(rows), ring.value(minor));
        }
        let has = |property, local| claim.has(property) || claim.has(local);
        let mut rules = Rules {
            ring: ring.clone(),
            is_plane: claim.dimension == 2,
            is_unit: is_unit(ring, &gram)?,
            four_det_gram: ring.times(&ring.integer(4)?, &determinant)?,
            gram,
            adjugate,
            acute: claim.has(Property::Acute),
            nonobtuse: claim.has(Property::Nonobtuse),
            angles: Vec::new(),
            ratios: Vec::new(),
            delaunay: has(Property::Delaunay, Property::LocallyDelaunay),
            weakly_delaunay: has(Property::WeaklyDelaunay, Property::LocallyWeaklyDelaunay),
            not_delaunay: claim.has(Property::NotDelaunay),
        };
        for (index, statement) in claim.statements.iter().enumerate() {
            if let Some(bound) = &statement.bound {
                rules.add_bound(index, statement.property, bound)?;
            }
        }
        Ok(rules)
    }

    fn add_bound(&mut self, statement: usize, of: Property, bound: &Bound) -> Checked {
        let ring = &self.ring;
        let p = ring.element(&bound.numerator)?;
        let q = ring.long(&bound.denominator)?;
        // A squared ratio is positive. A squared cosine is at most 1, and zero with the sign zero.
        let expected = if bound.sign == 0 { Equal } else { Greater };
        let is_cosine = !of.is_angle() || ring.compare(&p, &q)?.is(|sign| sign != Greater)?;
        let is_range = is_cosine && ring.sign(&p).decided()? == expected;
        ensure!(is_range, BoundRange, Place::Statement(statement), ring.quotient(&p, &q));
        let minus_p = if bound.sign < 0 { p } else { ring.negated(&p)? };
        let roughs = ring.rough(&minus_p).1.zip(ring.rough(&q).1).map(|(p, q)| [p, p, p, q]);
        let range = Range::quotient(Sign::exactly(bound.sign.cmp(&0)), roughs);
        let list = if of.is_angle() { &mut self.angles } else { &mut self.ratios };
        list.push(Extreme { statement, property: of, relation: bound.relation, minus_p, q, range });
        Ok(())
    }

    /// Pairs of facets, or of corners.
    fn pairs(&self) -> usize {
        if self.is_plane { 3 } else { 6 }
    }

    /// Whether the corners of mates matter.
    pub(crate) fn needs_mates(&self) -> bool {
        self.delaunay || self.weakly_delaunay || self.not_delaunay
    }

    /// Checks everything that is claimed of one simplex. The coordinates have the denominator.
    pub(crate) fn check(&self, simplex: &Simplex<R>, denominator: &BigInt) -> Checked<Found<R>> {
        let (ring, place) = (&self.ring, Place::Simplex(simplex.number));
        let [e1, e2, e3] = &simplex.edges;
        let mut normals = [ring.cross(e2, e3)?, ring.cross(e3, e1)?, Default::default()];
        if !self.is_plane {
            normals[2] = ring.cross(e1, e2)?;
        }
        let determinant = ring.inner(e1, &normals[0])?;
        // Rule O: det E > 0.
        let is_positive = ring.sign(&determinant).is(|sign| sign == Greater)?;
        let unit = || denominator.pow(if self.is_plane { 2 } else { 3 });
        ensure!(is_positive, Orientation, place, Value::Quotient(ring.coefficients(&determinant), vec![unit()]));
        let has_angles = self.acute || self.nonobtuse || !self.angles.is_empty();
        let has_spheres = !self.ratios.is_empty() || self.needs_mates();
        let (mut products, mut attained) = (Products::<R>::default(), 0);
        if has_spheres || (has_angles && !self.is_unit) {
            products = self.products(&simplex.edges, &each(&simplex.edges, |edge| self.image(edge))?)?;
        }
        if has_angles {
            let products = if self.is_unit { self.products(&normals, &normals)? } else { self.cofactors(&products)? };
            attained |= self.check_angles(&self.cosines(products)?, simplex.number)?;
        }
        if has_spheres {
            attained |= self.check_sphere(simplex, &normals, &products, &determinant, denominator)?;
        }
        Ok((determinant, attained))
    }

    fn products(&self, x: &[Vector<R>; 3], y: &[Vector<R>; 3]) -> Checked<Products<R>> {
        let ([x1, x2, x3], [y1, y2, y3]) = (x, y);
        each(&[(x1, y1), (x1, y2), (x1, y3), (x2, y2), (x2, y3), (x3, y3)], |(x, y)| self.ring.inner(x, y))
    }

    /// ⟨n_i, n_j⟩ by M = (⟨e_i, e_j⟩): adj(E) adj(G) adj(E)ᵀ = adj(M), and the rows of adj(E) are the normals.
    fn cofactors(&self, [m11, m12, m13, m22, m23, m33]: &Products<R>) -> Checked<Products<R>> {
        let minor = |a, b, c, d| self.ring.dot([a, &self.ring.negated(b)?], [d, c]);
        let g33 = if self.is_plane { R::Element::default() } else { minor(m11, m12, m12, m22)? };
        Ok([
            minor(m22, m23, m23, m33)?,
            minor(m13, m12, m33, m23)?,
            minor(m12, m13, m22, m23)?,
            minor(m11, m13, m13, m33)?,
            minor(m12, m11, m23, m13)?,
            g33,
        ])
    }

    fn check_angles(&self, (cosines, squares): &Cosines<R>, simplex: u64) -> Checked<u32> {
        let ring = &self.ring;
        let roughs = squares.each_ref().map(|x| if self.angles.is_empty() { None } else { ring.rough(x).1 });
        let mut sizes = [(Sign::UNDECIDED, Range::quotient(Sign::UNDECIDED, None)); 6];
        for ((c, (i, j)), size) in cosines.iter().zip(FACETS).zip(&mut sizes) {
            let (sign, rough) = if self.angles.is_empty() { (ring.sign(c), None) } else { ring.rough(c) };
            let of = |k: usize| roughs.get(k).copied().flatten();
            let roughs = rough.zip(of(i)).zip(of(j)).map(|((c, x), y)| [c, c, x, y]);
            *size = (sign, Range::quotient(sign, roughs));
        }
        // The squared cosine, with the sign of the cosine.
        let exact = |k: usize| {
            let ((c, (i, j)), (sign, _)) = cosines.get(k).zip(FACETS.get(k)).zip(sizes.get(k)).ok_or(Stop::LARGER)?;
            let (x, y) = squares.get(*i).zip(squares.get(*j)).ok_or(Stop::LARGER)?;
            let square = ring.times(c, c)?;
            let is_negative = sign.least == Less && sign.most != Greater;
            Ok([if is_negative { ring.negated(&square)? } else { square }, ring.times(x, y)?])
        };
        let place = |k| FACETS.get(k).map(|(i, j)| Place::Angle(simplex, *i, *j)).ok_or(Stop::LARGER);
        let sizes = sizes.get(..self.pairs()).unwrap_or(&sizes);
        for (k, (sign, _)) in sizes.iter().enumerate() {
            // `acute`: the cosine is positive. `nonobtuse`: it is not negative.
            let is_acute = !self.acute || sign.is(|sign| sign == Greater)?;
            ensure!(is_acute, NotAcute, place(k)?, self.value(exact(k)?));
            let is_nonobtuse = !self.nonobtuse || sign.is(|sign| sign != Less)?;
            ensure!(is_nonobtuse, NotNonobtuse, place(k)?, self.value(exact(k)?));
        }
        self.check_extremes(&self.angles, sizes, exact, place)
    }

    fn value(&self, [x, y]: [R::Element; 2]) -> Value {
        self.ring.quotient(&x, &y)
    }

    /// With g_ij = ⟨n_i, n_j⟩ the dihedral angle of the facets i and j has the cosine
    /// -g_ij / sqrt(g_ii g_jj). The rows of (g_ij) sum to zero.
    fn cosines(&self, [g11, g12, g13, g22, g23, g33]: Products<R>) -> Checked<Cosines<R>> {
        let ring = &self.ring;
        // -g_01, -g_02, -g_03 and g_00.
        let c01 = ring.plus(&ring.plus(&g11, &g12)?, &g13)?;
        let c02 = ring.plus(&ring.plus(&g12, &g22)?, &g23)?;
        let c03 = ring.plus(&ring.plus(&g13, &g23)?, &g33)?;
        let g00 = ring.plus(&ring.plus(&c01, &c02)?, &c03)?;
        let [c12, c13, c23] = each(&[g12, g13, g23], |g| ring.negated(g))?;
        Ok(([c01, c02, c12, c03, c13, c23], [g00, g11, g22, g33]))
    }

    /// Compares bounds with extremes of quotients. Returns the set of the statements attained.
    fn check_extremes(
        &self,
        bounds: &[Extreme<R>],
        sizes: &[Size],
        exact: impl Fn(usize) -> Checked<[R::Element; 2]>,
        place: impl Fn(usize) -> Checked<Place>,
    ) -> Checked<u32> {
        let mut attained = 0;
        for bound in bounds {
            // Quotients between their ends have a least one between the least of the ends; and so for the greatest.
            let ranges = sizes.iter().map(|(_, range)| *range);
            let extreme =
                ranges.reduce(|a, b| Range { low: bound.extreme(a.low, b.low), high: bound.extreme(a.high, b.high) });
            let extreme = extreme.ok_or_else(|| Stop::LARGER)?;
            let sign = match extreme.compare(&bound.range) {
                Some(sign) => Sign::exactly(sign),
                None => self.extreme_exactly(bound, sizes, extreme, &exact)?,
            };
            // Angles rise where cosines fall.
            let is_angle = bound.property.is_angle();
            let order = |sign: Ordering| if is_angle { sign.reverse() } else { sign };
            let is_allowed = sign.is(|sign| bound.relation.allows(order(sign)))?;
            if !is_allowed {
                // The extreme quotient.
                let (mut at, mut extreme) = (0, exact(0)?);
                for k in 1..sizes.len() {
                    let [[p, q], [x, y]] = [&extreme, &exact(k)?];
                    let order = self.ring.compare(&self.ring.times(x, q)?, &self.ring.times(p, y)?)?;
                    if order == Sign::exactly(bound.beyond()) {
                        (at, extreme) = (k, exact(k)?);
                    }
                }
                let (place, value) = (place(at)?, self.value(extreme));
                ensure!(!is_angle, AngleBound, place, value);
                ensure!(is_angle, RatioBound, place, value);
            }
            attained |= u32::from(sign == Sign::exactly(Equal)) << bound.statement;
        }
        Ok(attained)
    }

    /// The sign of the extreme quotient, which is in a range, minus the bound.
    #[inline(never)]
    fn extreme_exactly(
        &self,
        bound: &Extreme<R>,
        sizes: &[Size],
        extreme: Range,
        exact: &impl Fn(usize) -> Checked<[R::Element; 2]>,
    ) -> Checked<Sign> {
        let mut found = None;
        for (k, (sign, range)) in sizes.iter().enumerate() {
            // A quotient whose range is disjoint from this one is not the extreme one.
            if range.compare(&extreme).is_none() {
                let sign = self.compare_exactly(exact(k)?, *sign, bound)?;
                let extreme = |first: Sign| Sign {
                    least: bound.extreme(first.least, sign.least),
                    most: bound.extreme(first.most, sign.most),
                };
                found = Some(found.map_or(sign, extreme));
            }
            // No sign is beyond this one.
            if found == Some(Sign::exactly(bound.beyond())) {
                break;
            }
        }
        found.ok_or_else(|| Stop::LARGER)
    }

    /// The sign of x/y - p/q, or with an undecided sign of ±x/y - p/q.
    fn compare_exactly(&self, [x, y]: [R::Element; 2], sign: Sign, bound: &Extreme<R>) -> Checked<Sign> {
        let difference = |x| Ok(self.ring.sign(&self.ring.dot([&bound.q, &bound.minus_p], [x, &y])?));
        let first = difference(&x)?;
        if sign != Sign::UNDECIDED {
            return Ok(first);
        }
        let other = difference(&self.ring.negated(&x)?)?;
        Ok(Sign { least: first.least.min(other.least), most: first.most.max(other.most) })
    }

    /// Checks the statements about the circumsphere.
    ///
    /// The circumcentre z, seen from the first corner, has 2 ⟨z, e_i⟩ = |e_i|² = s_i. So
    /// 2 ⟨z, x⟩ = -w · x / det E for all x, where w = -Σ s_i n_i.
    fn check_sphere(
        &self,
        simplex: &Simplex<R>,
        [n1, n2, n3]: &[Vector<R>; 3],
        [s1, m12, m13, s2, m23, s3]: &Products<R>,
        determinant: &R::Element,
        denominator: &BigInt,
    ) -> Checked<u32> {
        let ring = &self.ring;
        let mut w = Vector::<R>::default();
        for (((entry, n1), n2), n3) in w.iter_mut().zip(n1).zip(n2).zip(n3) {
            *entry = ring.negated(&ring.dot([s1, s2, s3], [n1, n2, n3])?)?;
        }
        let mut attained = 0;
        if !self.ratios.is_empty() {
            // |y - x|² = |x|² + |y|² - 2 ⟨x, y⟩. The first three are those of the plane.
            let between = |x, y, m| ring.minus(&ring.minus(&ring.plus(x, y)?, m)?, m);
            let [s12, s13, s23] = [between(s1, s2, m12)?, between(s1, s3, m13)?, between(s2, s3, m23)?];
            let squares = [s12, s1.clone(), s2.clone(), s13, s23, s3.clone()];
            let squares = self.shortest(squares.get(..self.pairs()).unwrap_or(&squares))?;
            // R² = z G z = w adj(G) w / (4 det E² det G), since 2 G z = -w / det E.
            let radius = ring.inner(&w, &self.dual(&w)?)?;
            let unit = ring.times(&ring.times(determinant, determinant)?, &self.four_det_gram)?;
            let exact = |k: usize| Ok([radius.clone(), ring.times(&unit, squares.get(k).ok_or(Stop::LARGER)?)?]);
            let positive = Sign::exactly(Greater);
            let sizes = [(positive, Range::quotient(positive, None)); 6];
            let sizes = sizes.get(..squares.len()).unwrap_or(&sizes);
            attained = self.check_extremes(&self.ratios, sizes, exact, |_| Ok(Place::Simplex(simplex.number)))?;
        }
        // `Delaunay`: a mate's corner outside of the common facet is outside of the circumsphere;
        // `weakly Delaunay`: it is not inside. The difference of the powers of two spheres through
        // the common facet is an affine function that is zero on the facet. The two other corners
        // are on different sides of it. So the condition says the same from both sides.
        for (mate, facet) in simplex.mates.iter().zip(0..) {
            let Some(x) = mate else { continue };
            // The power of x, times det E: det E |x|² + w · x.
            let ([w0, w1, w2], [x0, x1, x2]) = (&w, x);
            let power = ring.dot([determinant, w0, w1, w2], [&ring.inner(x, &self.image(x)?)?, x0, x1, x2])?;
            let (sign, place) = (ring.sign(&power), Place::Facet(simplex.number, facet));
            let is_outside = !self.delaunay || sign.is(|sign| sign == Greater)?;
            let is_not_inside = !self.weakly_delaunay || sign.is(|sign| sign != Less)?;
            let value = || {
                let divisor = ring.times(determinant, &ring.element(&[denominator.pow(2)])?)?;
                Ok(ring.quotient(&power, &divisor))
            };
            ensure!(is_outside, NotDelaunay, place, value()?);
            ensure!(is_not_inside, NotWeaklyDelaunay, place, value()?);
            // `not Delaunay`: for some simplex a mate's corner is inside of the circumsphere.
            // Where elements vary, a sign that is undecided counts as none: another facet may show it.
            let is_inside =
                || if ring.varies() { Ok(sign == Sign::exactly(Less)) } else { sign.is(|sign| sign == Less) };
            if self.not_delaunay && is_inside()? {
                attained |= 1 << INSIDE;
            }
        }
        Ok(attained)
    }

    /// The least of some numbers; all of them where a sign is undecided.
    fn shortest<'s>(&self, squares: &'s [R::Element]) -> Checked<&'s [R::Element]> {
        let mut least = squares;
        for square in squares.chunks(1).skip(1) {
            let [first, ..] = least else { return Ok(squares) };
            let [other] = square else { return Ok(squares) };
            match self.ring.compare(other, first)? {
                Sign { most: Less, .. } => least = square,
                Sign { least: Less, .. } => return Ok(squares),
                _ => {}
            }
        }
        Ok(least.get(..1).unwrap_or(least))
    }

    /// adj(G) n
    fn dual(&self, n: &Vector<R>) -> Checked<Vector<R>> {
        if self.is_unit { Ok(n.clone()) } else { each(&self.adjugate, |row| self.ring.inner(row, n)) }
    }

    /// The minor of G without its first row and column.
    pub(crate) fn base_determinant(&self) -> R::Element {
        self.adjugate[0][0].clone()
    }

    /// G x
    pub(crate) fn image(&self, x: &Vector<R>) -> Checked<Vector<R>> {
        if self.is_unit { Ok(x.clone()) } else { each(&self.gram, |row| self.ring.inner(row, x)) }
    }
}

impl<R: Ring> Extreme<R> {
    /// The sign of a quotient minus one that is less extreme.
    fn beyond(&self) -> Ordering {
        if self.property == Property::LargestAngle { Less } else { Greater }
    }

    fn extreme<T: Ord>(&self, a: T, b: T) -> T {
        if self.beyond() == Less { a.min(b) } else { a.max(b) }
    }
}

impl Relation {
    fn allows(self, ordering: Ordering) -> bool {
        match self {
            Relation::LessThan => ordering == Less,
            Relation::AtMost | Relation::Maximum => ordering != Greater,
            Relation::MoreThan => ordering == Greater,
            Relation::AtLeast | Relation::Minimum => ordering != Less,
        }
    }
}

fn is_unit<R: Ring>(ring: &R, matrix: &[Vector<R>; 3]) -> Checked<bool> {
    let unit = [1, 0, 0, 0, 1, 0, 0, 0, 1];
    let is_equal = |(x, unit)| Ok(ring.compare(x, &ring.integer(unit)?)? == Sign::exactly(Equal));
    matrix.as_flattened().iter().zip(unit).map(is_equal).try_fold(true, |all, is_equal| Ok(all && is_equal?))
}

/// G from its upper triangle.
fn gram<R: Ring>(ring: &R, claim: &Claim) -> Checked<[Vector<R>; 3]> {
    let entries = claim.gram.iter().map(|entry| ring.polynomial(entry));
    let entries = entries.collect::<Checked<Vec<_>>>()?;
    let (one, zero) = (ring.integer(1)?, R::Element::default());
    let matrix = match entries.as_slice() {
        [a, b, c, d, e, f] => [[a, b, c], [b, d, e], [c, e, f]],
        [a, b, c] => [[a, b, &zero], [b, c, &zero], [&zero, &zero, &one]],
        _ => return Err(Stop::LARGER),
    };
    Ok(matrix.map(|row| row.map(R::Element::clone)))
}
