//! One simplex in coordinates: orientation, angles, radius, Delaunay.
//!
//! e_1, e_2, e_3 are the edges from the first corner, times the common denominator. n_1, n_2, n_3
//! are their cross products: n_i · e_j is det E for i = j and else 0. So n_i / det E is the
//! gradient of the i-th barycentric coordinate, and n_0 = -(n_1 + n_2 + n_3). Covectors have the
//! inner product ⟨n, m⟩ = n adj(G) m, up to the factor det G > 0. Everything is homogeneous in the
//! coordinates and in G, so positive factors do not matter.
//!
//! In the plane G gets a third row (0, 0, 1), e_3 is (0, 0, 1), and n_3 is left out.

use crate::claim::{self, Claim, Quantity, Relation, Statement};
use crate::refusal::{Larger, Place, Stop, Value};
use crate::ring::{Ring, Vector, each};
use num_bigint::BigInt;
use std::cmp::Ordering::{self, Equal, Greater, Less};

/// The claim about single simplices, in numbers of one ring.
pub(crate) struct Rules<R: Ring> {
    pub(crate) ring: R,
    pub(crate) is_plane: bool,
    pub(crate) gram: [Vector<R>; 3],
    pub(crate) adjugate: [Vector<R>; 3],
    pub(crate) four_det_gram: R::Element,
    pub(crate) acute: bool,
    pub(crate) nonobtuse: bool,
    pub(crate) angles: Vec<Bound<R::Element>>,
    pub(crate) ratios: Vec<Bound<R::Element>>,
    pub(crate) delaunay: bool,
    pub(crate) weakly_delaunay: bool,
}

/// A bound p/q: a squared cosine with a sign, or a squared ratio.
pub(crate) struct Bound<E> {
    pub(crate) is_largest: bool,
    pub(crate) relation: Relation,
    pub(crate) sign: Ordering,
    pub(crate) p: E,
    pub(crate) q: E,
    /// The bound in sets of bounds.
    pub(crate) bit: u32,
}

/// The sets of bounds that are more than, equal to, and less than a quantity.
#[derive(Clone, Copy, Default)]
pub(crate) struct Found {
    pub(crate) less: u32,
    pub(crate) equal: u32,
    pub(crate) greater: u32,
}

impl Found {
    /// The quantity compares like this with the bound.
    #[inline(always)]
    pub(crate) fn add(&mut self, ordering: Ordering, bit: u32) {
        match ordering {
            Less => self.less |= bit,
            Equal => self.equal |= bit,
            Greater => self.greater |= bit,
        }
    }

    #[inline(always)]
    pub(crate) fn join(&mut self, other: Found) {
        self.less |= other.less;
        self.equal |= other.equal;
        self.greater |= other.greater;
    }
}

impl Relation {
    #[inline(always)]
    pub(crate) fn allows(self, ordering: Ordering) -> bool {
        match self {
            Relation::LessThan => ordering == Less,
            Relation::AtMost | Relation::Maximum => ordering != Greater,
            Relation::MoreThan => ordering == Greater,
            Relation::AtLeast | Relation::Minimum => ordering != Less,
        }
    }
}

/// The circumcentre z, seen from the first corner, has 2 ⟨z, x⟩ = w · x / det E for all x.
pub(crate) struct Sphere<R: Ring> {
    /// w
    pub(crate) centre: Vector<R>,
    /// The square of the shortest edge, where a ratio is claimed.
    pub(crate) shortest: R::Element,
}

/// An angle between facets i and j, with the cosine c / sqrt(x y).
pub(crate) struct Angle<R: Ring> {
    pub(crate) facets: (usize, usize),
    pub(crate) c: R::Element,
    pub(crate) x: R::Element,
    pub(crate) y: R::Element,
}

/// The bounds that need "attained", as a set.
pub(crate) fn to_attain(claim: &Claim) -> Vec<(usize, u32)> {
    let bounds = bounds(claim).zip(1u32..);
    let bounds = bounds
        .filter(|((_, bound), _)| matches!(bound.relation, Relation::Maximum | Relation::Minimum));
    bounds
        .map(|((statement, _), bit)| (statement, 1 << bit))
        .collect()
}

/// The bounds of a claim, with the numbers of their statements. There are at most 18.
fn bounds(claim: &Claim) -> impl Iterator<Item = (usize, &claim::Bound)> {
    let statements = claim.statements.iter().enumerate();
    statements.filter_map(|(index, statement)| match statement {
        Statement::Bound(bound) => Some((index, bound)),
        _ => None,
    })
}

impl<R: Ring> Rules<R> {
    pub(crate) fn new(ring: R, claim: &Claim) -> Result<Self, Stop> {
        let gram = gram(&ring, claim)?;
        let [r, s, t] = &gram;
        let adjugate = [ring.cross(s, t)?, ring.cross(t, r)?, ring.cross(r, s)?];
        let determinant = ring.inner(r, &adjugate[0])?;
        // Rule M: G is positive definite (Sylvester). In the plane the third minor is the second.
        let minors = [&gram[0][0], &adjugate[2][2], &determinant];
        for (rows, minor) in minors.into_iter().enumerate() {
            let value = || Value::Quotient(ring.coefficients(minor), vec![1.into()]);
            let is_positive = ring.sign(minor)? == Greater;
            ensure!(
                is_positive,
                GramNotPositive,
                Place::Minor(rows + 1),
                value()
            );
        }
        let four = ring.element(&[BigInt::from(4)])?;
        let has = |statement| claim.statements.contains(&statement);
        let mut rules = Rules {
            is_plane: claim.dimension == 2,
            four_det_gram: ring.times(&four, &determinant)?,
            gram,
            adjugate,
            acute: has(Statement::Acute),
            nonobtuse: has(Statement::Nonobtuse),
            angles: Vec::new(),
            ratios: Vec::new(),
            delaunay: has(Statement::Delaunay) || has(Statement::LocallyDelaunay),
            weakly_delaunay: has(Statement::WeaklyDelaunay)
                || has(Statement::LocallyWeaklyDelaunay),
            ring,
        };
        for ((statement, bound), bit) in bounds(claim).zip(1u32..) {
            rules.add_bound(statement, bound, 1 << bit)?;
        }
        Ok(rules)
    }

    fn add_bound(&mut self, statement: usize, bound: &claim::Bound, bit: u32) -> Result<(), Stop> {
        let p = self.ring.element(&bound.numerator)?;
        let q = self
            .ring
            .element(std::slice::from_ref(&bound.denominator))?;
        let (sign, excess) = (self.ring.sign(&p)?, self.ring.compare(&p, &q)?);
        let is_ratio = bound.quantity == Quantity::SquaredRatio;
        // A squared ratio is positive. A squared cosine is at most 1, and zero with the sign zero.
        let expected = if bound.sign == 0 { Equal } else { Greater };
        let is_range = sign == expected && (is_ratio || excess != Greater);
        ensure!(is_range, BoundRange, Place::Statement(statement));
        let list = if is_ratio {
            &mut self.ratios
        } else {
            &mut self.angles
        };
        list.push(Bound {
            is_largest: bound.quantity != Quantity::SmallestAngle,
            relation: bound.relation,
            sign: bound.sign.cmp(&0),
            p,
            q,
            bit,
        });
        Ok(())
    }

    /// Units of work for one simplex, where the ring does not count each product.
    #[inline(always)]
    pub(crate) fn price(&self) -> u64 {
        300 * self.ring.price()
    }

    /// Whether the corners of mates matter.
    #[inline(always)]
    pub(crate) fn needs_mates(&self) -> bool {
        self.delaunay || self.weakly_delaunay
    }

    /// e_2 × e_3
    #[inline(always)]
    pub(crate) fn first_normal(&self, [_, e2, e3]: &[Vector<R>; 3]) -> Result<Vector<R>, Larger> {
        if self.is_plane {
            let [x, y, zero] = e2;
            return Ok([y.clone(), self.ring.minus(zero, x)?, zero.clone()]);
        }
        self.ring.cross(e2, e3)
    }

    #[inline(always)]
    pub(crate) fn normals(&self, edges: &[Vector<R>; 3]) -> Result<[Vector<R>; 3], Larger> {
        let ring = &self.ring;
        let [e1, e2, e3] = edges;
        let first = self.first_normal(edges)?;
        if self.is_plane {
            let [x, y, zero] = e1;
            let second = [ring.minus(zero, y)?, x.clone(), zero.clone()];
            return Ok([first, second, Default::default()]);
        }
        Ok([first, ring.cross(e3, e1)?, ring.cross(e1, e2)?])
    }

    /// With g_ij = ⟨n_i, n_j⟩ the dihedral angle of the facets i and j has the cosine
    /// -g_ij / sqrt(g_ii g_jj). The rows of (g_ij) sum to zero.
    #[inline(always)]
    pub(crate) fn angles(&self, [n1, n2, n3]: &[Vector<R>; 3]) -> Result<[Angle<R>; 6], Larger> {
        let ring = &self.ring;
        let [d1, d2, d3] = [self.dual(n1)?, self.dual(n2)?, self.dual(n3)?];
        let (g11, g12, g13) = (
            ring.inner(n1, &d1)?,
            ring.inner(n1, &d2)?,
            ring.inner(n1, &d3)?,
        );
        let (g22, g23, g33) = (
            ring.inner(n2, &d2)?,
            ring.inner(n2, &d3)?,
            ring.inner(n3, &d3)?,
        );
        // -g_01, -g_02, -g_03 and g_00.
        let c01 = ring.plus(&ring.plus(&g11, &g12)?, &g13)?;
        let c02 = ring.plus(&ring.plus(&g12, &g22)?, &g23)?;
        let c03 = ring.plus(&ring.plus(&g13, &g23)?, &g33)?;
        let g00 = ring.plus(&ring.plus(&c01, &c02)?, &c03)?;
        let zero = R::Element::default();
        let angle = |facets, c: &R::Element, x: &R::Element, y: &R::Element| Angle {
            facets,
            c: c.clone(),
            x: x.clone(),
            y: y.clone(),
        };
        // The first three are those of the plane.
        Ok([
            angle((0, 1), &c01, &g00, &g11),
            angle((0, 2), &c02, &g00, &g22),
            angle((1, 2), &ring.minus(&zero, &g12)?, &g11, &g22),
            angle((0, 3), &c03, &g00, &g33),
            angle((1, 3), &ring.minus(&zero, &g13)?, &g11, &g33),
            angle((2, 3), &ring.minus(&zero, &g23)?, &g22, &g33),
        ])
    }

    /// c² / (x y), with the sign of the cosine.
    #[cold]
    pub(crate) fn squared_cosine(&self, angle: &Angle<R>) -> Result<Value, Larger> {
        let ring = &self.ring;
        let mut square = ring.times(&angle.c, &angle.c)?;
        if ring.sign(&angle.c)? == Less {
            square = ring.minus(&R::Element::default(), &square)?;
        }
        let lengths = ring.times(&angle.x, &angle.y)?;
        let [square, lengths] = [square, lengths].map(|value| ring.coefficients(&value));
        Ok(Value::Quotient(square, lengths))
    }

    /// How the angle with the cosine c / sqrt(x y) compares with the bounds, where c has this
    /// sign. Different signs decide; else the squares do, the other way round where both cosines
    /// are negative. The angle decreases as the cosine increases.
    #[inline(always)]
    pub(crate) fn compare_squares(
        &self,
        sign: Ordering,
        c: &R::Element,
        x: &R::Element,
        y: &R::Element,
    ) -> Result<Found, Larger> {
        let ring = &self.ring;
        let (square, lengths) = (ring.times(c, c)?, ring.times(x, y)?);
        let mut found = Found::default();
        for bound in &self.angles {
            let cosine = if sign != bound.sign || sign == Equal {
                sign.cmp(&bound.sign)
            } else {
                let squares = ring.compare(
                    &ring.times(&square, &bound.q)?,
                    &ring.times(&lengths, &bound.p)?,
                )?;
                if sign == Less {
                    squares.reverse()
                } else {
                    squares
                }
            };
            found.add(cosine.reverse(), bound.bit);
        }
        Ok(found)
    }

    /// adj(G) n
    #[inline(always)]
    pub(crate) fn dual(&self, n: &Vector<R>) -> Result<Vector<R>, Larger> {
        each(&self.adjugate, |row| self.ring.inner(row, n))
    }

    /// x G x
    #[inline(always)]
    pub(crate) fn square(&self, x: &Vector<R>) -> Result<R::Element, Larger> {
        let image: Vector<R> = each(&self.gram, |row| self.ring.inner(row, x))?;
        self.ring.inner(x, &image)
    }

    /// The circumcentre has 2 ⟨z, e_i⟩ = |e_i|², so w = Σ |e_i|² n_i.
    #[inline(always)]
    pub(crate) fn sphere(
        &self,
        [e1, e2, e3]: &[Vector<R>; 3],
        [n1, n2, n3]: &[Vector<R>; 3],
    ) -> Result<Sphere<R>, Larger> {
        let ring = &self.ring;
        // In the plane n_3 is zero.
        let (s1, s2) = (self.square(e1)?, self.square(e2)?);
        let s3 = if self.is_plane {
            s1.clone()
        } else {
            self.square(e3)?
        };
        let mut centre: Vector<R> = Default::default();
        for (((centre, n1), n2), n3) in centre.iter_mut().zip(n1).zip(n2).zip(n3) {
            *centre = ring.dot([&s1, &s2, &s3], [n1, n2, n3])?;
        }
        let mut shortest = s1;
        if !self.ratios.is_empty() {
            let between = |x, y| self.square(&ring.difference(x, y)?);
            shortest = ring.lesser(&shortest, &s2)?;
            shortest = ring.lesser(&shortest, &between(e1, e2)?)?;
            if !self.is_plane {
                shortest = ring.lesser(&shortest, &s3)?;
                shortest = ring.lesser(&shortest, &between(e1, e3)?)?;
                shortest = ring.lesser(&shortest, &between(e2, e3)?)?;
            }
        }
        Ok(Sphere { centre, shortest })
    }

    /// R² / l², for the shortest edge l. As 2 G z = w / det E,
    /// R² = z G z = w adj(G) w / (4 det E² det G).
    #[inline(always)]
    pub(crate) fn ratio(
        &self,
        sphere: &Sphere<R>,
        determinant: &R::Element,
    ) -> Result<[R::Element; 2], Larger> {
        let ring = &self.ring;
        let radius = ring.inner(&sphere.centre, &self.dual(&sphere.centre)?)?;
        let square = ring.times(determinant, determinant)?;
        let length = ring.times(&self.four_det_gram, &sphere.shortest)?;
        Ok([radius, ring.times(&square, &length)?])
    }

    /// How the squared radius-edge ratio compares with the bounds.
    #[inline(always)]
    pub(crate) fn compare_ratios(
        &self,
        sphere: &Sphere<R>,
        determinant: &R::Element,
    ) -> Result<Found, Larger> {
        let ring = &self.ring;
        let [radius, length] = self.ratio(sphere, determinant)?;
        let mut found = Found::default();
        for bound in &self.ratios {
            let left = ring.times(&radius, &bound.q)?;
            let ordering = ring.compare(&left, &ring.times(&length, &bound.p)?)?;
            found.add(ordering, bound.bit);
        }
        Ok(found)
    }

    /// The power of x, times det E: det E |x|² - w · x.
    #[inline(always)]
    pub(crate) fn power(
        &self,
        sphere: &Sphere<R>,
        determinant: &R::Element,
        x: &Vector<R>,
    ) -> Result<R::Element, Larger> {
        let ring = &self.ring;
        let left = ring.times(determinant, &self.square(x)?)?;
        ring.minus(&left, &ring.inner(&sphere.centre, x)?)
    }
}

impl<R: Ring> Sphere<R> {
    pub(crate) fn next(&self) -> Sphere<R::Next> {
        Sphere {
            centre: self.centre.each_ref().map(R::next),
            shortest: R::next(&self.shortest),
        }
    }
}

/// G from its upper triangle.
fn gram<R: Ring>(ring: &R, claim: &Claim) -> Result<[Vector<R>; 3], Larger> {
    let mut entries = Vec::new();
    for number in &claim.gram {
        entries.push(ring.element(number)?);
    }
    let (one, zero) = (ring.element(&[BigInt::from(1)])?, R::Element::default());
    let matrix = match entries.as_slice() {
        [a, b, c, d, e, f] => [[a, b, c], [b, d, e], [c, e, f]],
        [a, b, c] => [[a, b, &zero], [b, c, &zero], [&zero, &zero, &one]],
        _ => return Err(Larger),
    };
    Ok(matrix.map(|row| row.map(R::Element::clone)))
}
