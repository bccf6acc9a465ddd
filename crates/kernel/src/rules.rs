//! The numbers of one simplex, and how they compare with the bounds of a claim.
//!
//! e_1, e_2, e_3 are the edges from the first corner, times the common denominator. n_1, n_2, n_3
//! are their cross products: n_i · e_j is det E for i = j and else 0. So n_i / det E is the
//! gradient of the i-th barycentric coordinate, and n_0 = -(n_1 + n_2 + n_3). Covectors have the
//! inner product ⟨n, m⟩ = n adj(G) m, up to the factor det G > 0. Everything is homogeneous in the
//! coordinates and in G, so positive factors do not matter.
//!
//! In the plane G gets a third row (0, 0, 1), e_3 is (0, 0, 1), and n_3 is left out.

use crate::claim::{self, Claim, Property, Relation};
use crate::refusal::{Checked, Place, Stop};
use crate::ring::{Ring, Vector, each};
use std::cmp::Ordering::{self, Equal, Greater, Less};

/// The claim about single simplices, in numbers of one ring.
pub(crate) struct Rules<R: Ring> {
    pub(crate) ring: R,
    pub(crate) is_plane: bool,
    gram: [Vector<R>; 3],
    adjugate: [Vector<R>; 3],
    four_det_gram: R::Element,
    pub(crate) acute: bool,
    pub(crate) nonobtuse: bool,
    pub(crate) angles: Vec<Bound<R::Element>>,
    pub(crate) ratios: Vec<Bound<R::Element>>,
    pub(crate) delaunay: bool,
    pub(crate) weakly_delaunay: bool,
}

/// A bound p/q: a squared cosine with a sign, or a squared ratio.
pub(crate) struct Bound<E> {
    pub(crate) statement: usize,
    /// The bound is for the smallest angle.
    pub(crate) is_smallest: bool,
    pub(crate) relation: Relation,
    sign: Ordering,
    p: E,
    q: E,
}

/// The angle between the facets i and j: its cosine is c / sqrt(x y).
pub(crate) struct Angle<R: Ring> {
    pub(crate) facets: (usize, usize),
    /// The sign of c.
    pub(crate) sign: Ordering,
    pub(crate) c: R::Element,
    pub(crate) x: R::Element,
    pub(crate) y: R::Element,
    /// c² and x y, if they fit; where there are bounds.
    pub(crate) squares: Checked<[R::Element; 2]>,
}

/// The circumcentre z, seen from the first corner, has 2 ⟨z, x⟩ = w · x / det E for all x.
pub(crate) struct Sphere<R: Ring> {
    /// w
    pub(crate) centre: Vector<R>,
    pub(crate) determinant: R::Element,
    /// The square of the shortest edge, where a ratio is claimed.
    pub(crate) shortest: R::Element,
}

impl Relation {
    pub(crate) fn allows(self, ordering: Ordering) -> bool {
        match self {
            Relation::LessThan => ordering == Less,
            Relation::AtMost | Relation::Maximum => ordering != Greater,
            Relation::MoreThan => ordering == Greater,
            Relation::AtLeast | Relation::Minimum => ordering != Less,
        }
    }
}

impl<R: Ring> Rules<R> {
    pub(crate) fn new(ring: &R, claim: &Claim) -> Checked<Self>
    where
        R: Clone,
    {
        let gram = gram(ring, claim)?;
        let [r, s, t] = &gram;
        let adjugate = [ring.cross(s, t)?, ring.cross(t, r)?, ring.cross(r, s)?];
        let determinant = ring.inner(r, &adjugate[0])?;
        // Rule M: G is positive definite (Sylvester). In the plane the third minor is the second.
        let minors = [&gram[0][0], &adjugate[2][2], &determinant];
        for (minor, rows) in minors.into_iter().zip(1..) {
            let is_positive = ring.sign(minor)? == Greater;
            ensure!(is_positive, GramNotPositive, Place::Minor(rows), ring.value(minor));
        }
        let (delaunay, local) = (Property::Delaunay, Property::LocallyDelaunay);
        let (weakly, locally) = (Property::WeaklyDelaunay, Property::LocallyWeaklyDelaunay);
        let mut rules = Rules {
            ring: ring.clone(),
            is_plane: claim.dimension == 2,
            four_det_gram: ring.times(&ring.integer(4)?, &determinant)?,
            gram,
            adjugate,
            acute: claim.has(Property::Acute),
            nonobtuse: claim.has(Property::Nonobtuse),
            angles: Vec::new(),
            ratios: Vec::new(),
            delaunay: claim.has(delaunay) || claim.has(local),
            weakly_delaunay: claim.has(weakly) || claim.has(locally),
        };
        for (index, statement) in claim.statements.iter().enumerate() {
            if let Some(bound) = &statement.bound {
                rules.add_bound(index, statement.property, bound)?;
            }
        }
        Ok(rules)
    }

    fn add_bound(&mut self, statement: usize, of: Property, bound: &claim::Bound) -> Checked {
        let ring = &self.ring;
        let p = ring.element(&bound.numerator)?;
        let q = ring.element(std::slice::from_ref(&bound.denominator))?;
        // A squared ratio is positive. A squared cosine is at most 1, and zero with the sign zero.
        let expected = if bound.sign == 0 { Equal } else { Greater };
        let is_cosine = !of.is_angle() || ring.compare(&p, &q)? != Greater;
        let is_range = is_cosine && ring.sign(&p)? == expected;
        ensure!(is_range, BoundRange, Place::Statement(statement), ring.quotient(&p, &q));
        let list = if of.is_angle() { &mut self.angles } else { &mut self.ratios };
        let is_smallest = of == Property::SmallestAngle;
        let (relation, sign) = (bound.relation, bound.sign.cmp(&0));
        list.push(Bound { statement, is_smallest, relation, sign, p, q });
        Ok(())
    }

    /// Units of work for one simplex, where the ring does not count each product.
    pub(crate) fn price(&self) -> u64 {
        300 * self.ring.price()
    }

    /// Whether the corners of mates matter.
    pub(crate) fn needs_mates(&self) -> bool {
        self.delaunay || self.weakly_delaunay
    }

    /// n_1 = e_2 × e_3
    pub(crate) fn first_normal(&self, [_, e2, e3]: &[Vector<R>; 3]) -> Checked<Vector<R>> {
        if self.is_plane {
            let [x, y, zero] = e2;
            return Ok([y.clone(), self.ring.minus(zero, x)?, zero.clone()]);
        }
        self.ring.cross(e2, e3)
    }

    pub(crate) fn normals(&self, edges: &[Vector<R>; 3]) -> Checked<[Vector<R>; 3]> {
        let [e1, e2, e3] = edges;
        let first = self.first_normal(edges)?;
        if self.is_plane {
            let [x, y, zero] = e1;
            let second = [self.ring.minus(zero, y)?, x.clone(), zero.clone()];
            return Ok([first, second, Default::default()]);
        }
        Ok([first, self.ring.cross(e3, e1)?, self.ring.cross(e1, e2)?])
    }

    /// With g_ij = ⟨n_i, n_j⟩ the dihedral angle of the facets i and j has the cosine
    /// -g_ij / sqrt(g_ii g_jj). The rows of (g_ij) sum to zero.
    pub(crate) fn angles(&self, [n1, n2, n3]: &[Vector<R>; 3]) -> Checked<[Angle<R>; 6]> {
        let ring = &self.ring;
        let [d1, d2, d3] = [self.dual(n1)?, self.dual(n2)?, self.dual(n3)?];
        let (g11, g12, g13) = (ring.inner(n1, &d1)?, ring.inner(n1, &d2)?, ring.inner(n1, &d3)?);
        let (g22, g23, g33) = (ring.inner(n2, &d2)?, ring.inner(n2, &d3)?, ring.inner(n3, &d3)?);
        // -g_01, -g_02, -g_03 and g_00.
        let c01 = ring.plus(&ring.plus(&g11, &g12)?, &g13)?;
        let c02 = ring.plus(&ring.plus(&g12, &g22)?, &g23)?;
        let c03 = ring.plus(&ring.plus(&g13, &g23)?, &g33)?;
        let g00 = ring.plus(&ring.plus(&c01, &c02)?, &c03)?;
        let negated = |g| ring.minus(&R::Element::default(), g);
        // The first three are those of the plane.
        Ok([
            self.angle((0, 1), c01, &g00, &g11)?,
            self.angle((0, 2), c02, &g00, &g22)?,
            self.angle((1, 2), negated(&g12)?, &g11, &g22)?,
            self.angle((0, 3), c03, &g00, &g33)?,
            self.angle((1, 3), negated(&g13)?, &g11, &g33)?,
            self.angle((2, 3), negated(&g23)?, &g22, &g33)?,
        ])
    }

    /// How an angle compares with a bound. Different signs of the cosines decide; else the squares
    /// do, the other way round where both are negative. The cosine decreases.
    pub(crate) fn compare_angle(&self, angle: &Angle<R>, bound: usize) -> Checked<Ordering> {
        let bound = self.angles.get(bound).ok_or(Stop::LARGER)?;
        if angle.sign != bound.sign || angle.sign == Equal {
            return Ok(bound.sign.cmp(&angle.sign));
        }
        let [square, lengths] = angle.squares.as_ref().map_err(Stop::clone)?;
        let (left, right) = self.scaled(square, lengths, bound)?;
        let ordering = self.ring.compare(&left, &right)?;
        Ok(if angle.sign == Less { ordering } else { ordering.reverse() })
    }

    /// An angle with the cosine c / sqrt(x y).
    pub(crate) fn angle(
        &self,
        facets: (usize, usize),
        c: R::Element,
        x: &R::Element,
        y: &R::Element,
    ) -> Checked<Angle<R>> {
        let ring = &self.ring;
        let squares = || Ok([ring.times(&c, &c)?, ring.times(x, y)?]);
        let (sign, squares) = (ring.sign(&c)?, squares());
        Ok(Angle { facets, sign, c, x: x.clone(), y: y.clone(), squares })
    }

    /// x q and y p: they compare as x/y does with the bound p/q.
    fn scaled(&self, x: &R::Element, y: &R::Element, bound: &Bound<R::Element>) -> Checked<(R::Element, R::Element)> {
        Ok((self.ring.times(x, &bound.q)?, self.ring.times(y, &bound.p)?))
    }

    /// adj(G) n
    fn dual(&self, n: &Vector<R>) -> Checked<Vector<R>> {
        each(&self.adjugate, |row| self.ring.inner(row, n))
    }

    /// G x
    fn image(&self, x: &Vector<R>) -> Checked<Vector<R>> {
        each(&self.gram, |row| self.ring.inner(row, x))
    }

    /// The circumcentre has 2 ⟨z, e_i⟩ = |e_i|², so w = Σ |e_i|² n_i.
    pub(crate) fn sphere(
        &self,
        [e1, e2, e3]: &[Vector<R>; 3],
        [n1, n2, n3]: &[Vector<R>; 3],
        determinant: &R::Element,
    ) -> Checked<Sphere<R>> {
        let ring = &self.ring;
        let [d1, d2, d3] = [self.image(e1)?, self.image(e2)?, self.image(e3)?];
        let [s1, s2, s3] = [ring.inner(e1, &d1)?, ring.inner(e2, &d2)?, ring.inner(e3, &d3)?];
        // In the plane n_3 is zero.
        let mut centre: Vector<R> = Default::default();
        for (((centre, n1), n2), n3) in centre.iter_mut().zip(n1).zip(n2).zip(n3) {
            *centre = ring.dot([&s1, &s2, &s3], [n1, n2, n3])?;
        }
        let mut shortest = s1.clone();
        if !self.ratios.is_empty() {
            // |y - x|² = |x|² + |y|² - 2 ⟨x, y⟩
            let between = |x, y, e, d| {
                let inner = ring.inner(e, d)?;
                ring.minus(&ring.minus(&ring.plus(x, y)?, &inner)?, &inner)
            };
            shortest = ring.lesser(&shortest, &between(&s1, &s2, e1, &d2)?)?;
            shortest = ring.lesser(&shortest, &s2)?;
            if !self.is_plane {
                shortest = ring.lesser(&shortest, &between(&s1, &s3, e1, &d3)?)?;
                shortest = ring.lesser(&shortest, &between(&s2, &s3, e2, &d3)?)?;
                shortest = ring.lesser(&shortest, &s3)?;
            }
        }
        Ok(Sphere { centre, determinant: determinant.clone(), shortest })
    }

    /// R² / l², for the shortest edge l. As 2 G z = w / det E,
    /// R² = z G z = w adj(G) w / (4 det E² det G).
    pub(crate) fn ratio(&self, sphere: &Sphere<R>) -> Checked<[R::Element; 2]> {
        let ring = &self.ring;
        let radius = ring.inner(&sphere.centre, &self.dual(&sphere.centre)?)?;
        let square = ring.times(&sphere.determinant, &sphere.determinant)?;
        let length = ring.times(&self.four_det_gram, &sphere.shortest)?;
        Ok([radius, ring.times(&square, &length)?])
    }

    pub(crate) fn compare_ratio(&self, sphere: &Sphere<R>, bound: usize) -> Checked<Ordering> {
        let bound = self.ratios.get(bound).ok_or(Stop::LARGER)?;
        let [radius, length] = self.ratio(sphere)?;
        let (left, right) = self.scaled(&radius, &length, bound)?;
        self.ring.compare(&left, &right)
    }

    /// The power of x, times det E: det E |x|² - w · x.
    pub(crate) fn power(&self, sphere: &Sphere<R>, x: &Vector<R>) -> Checked<R::Element> {
        let left = self.ring.times(&sphere.determinant, &self.ring.inner(x, &self.image(x)?)?)?;
        self.ring.minus(&left, &self.ring.inner(&sphere.centre, x)?)
    }
}

/// G from its upper triangle.
fn gram<R: Ring>(ring: &R, claim: &Claim) -> Checked<[Vector<R>; 3]> {
    let entries = claim.gram.iter().map(|number| ring.element(number));
    let entries = entries.collect::<Checked<Vec<_>>>()?;
    let (one, zero) = (ring.integer(1)?, R::Element::default());
    let matrix = match entries.as_slice() {
        [a, b, c, d, e, f] => [[a, b, c], [b, d, e], [c, e, f]],
        [a, b, c] => [[a, b, &zero], [b, c, &zero], [&zero, &zero, &one]],
        _ => return Err(Stop::LARGER),
    };
    Ok(matrix.map(|row| row.map(R::Element::clone)))
}
