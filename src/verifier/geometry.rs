//! The hypotheses of the soundness theorem, a function each.
//!
//! Over each function stands the rule that it checks. x_0, …, x_D are the
//! corners of a simplex, E the matrix whose rows are the edges e_i = x_i - x_0
//! in basis coordinates, G the Gram matrix of the basis. That these hypotheses
//! imply the claim is proved in docs/soundness.md.

use super::corners::Corners;
use super::integer::Integer;
use super::mates::Pair;
use super::matrix::{Matrix, apply, cofactors, determinant, leading};
use super::ring::Element;
use super::tiling::{Tiling, number};
use super::{Refusal, angle, domain, mates, radius, region, tcp};
use crate::certificate::{Domain, Number, Statement};
use std::cmp::Ordering;
use std::iter;

/// A check of the numbers; it may rely on [`super::shape::CHECKS`] and on the
/// checks before it.
pub(super) type Check = fn(&Tiling) -> Result<(), Refusal>;

/// The exact value whose sign was judged, made only for a refusal.
type Value<'v> = &'v dyn Fn() -> Number;

/// All of them. A statement that is not claimed is not checked.
pub(super) const CHECKS: &[(&str, Check)] = &[
    ("gram_positive", check_gram_positive),
    ("facets", domain::check_facets),
    ("polygons", domain::check_polygons),
    ("closed", domain::check_closed),
    ("inside", domain::check_inside),
    ("orientation", check_orientation),
    ("mates_mutual", mates::check_mates_mutual),
    ("mates_meet", mates::check_mates_meet),
    ("boundary", domain::check_boundary),
    ("volume_sum", check_volume_sum),
    ("boundary_apart", region::check_boundary_apart),
    ("covering", region::check_covering),
    ("acute", check_acute),
    ("nonobtuse", check_nonobtuse),
    ("dihedral_below", angle::check_dihedral_below),
    ("dihedral_above", angle::check_dihedral_above),
    ("radius_edge", radius::check_radius_edge),
    ("delaunay", check_delaunay),
    ("weakly_delaunay", check_weakly_delaunay),
    ("tcp_edges", tcp::check_tcp_edges),
    ("tcp_triangles", tcp::check_tcp_triangles),
];

/// G is positive definite: its leading principal minors are positive (Sylvester).
fn check_gram_positive(tiling: &Tiling) -> Result<(), Refusal> {
    for order in 1..=tiling.dimension() {
        let minor = determinant(&tiling.ring, &leading(&tiling.gram, order));
        let scale = tiling.gram_scale.pow(order);
        let of = || format!("leading principal minor {order} of the Gram matrix");
        if tiling.sign(&minor, &scale, of)? != Ordering::Greater {
            return Err(Refusal::GramNotPositive {
                order,
                minor: number(&minor, &scale),
            });
        }
    }
    Ok(())
}

/// det E > 0.
fn check_orientation(tiling: &Tiling) -> Result<(), Refusal> {
    let scale = tiling.scale.pow(tiling.dimension());
    tiling.each_simplex(|simplex, corners| {
        let value = determinant(&tiling.ring, &tiling.edges(corners));
        let of = || format!("determinant of simplex {simplex}");
        match tiling.sign(&value, &scale, of)? {
            Ordering::Greater => Ok(()),
            _ => Err(Refusal::Orientation {
                simplex,
                determinant: number(&value, &scale),
            }),
        }
    })
}

/// The volumes, in units of the basis's parallelepiped, sum to vol P, where P is
/// the domain's polytope; to one where the domain is space. As vol = det E / D!, the
/// sum of all det E is D! vol P. Here each det E is N^D too large, and k! vol P is
/// N^k. Vectors that agree have the same value; where they differ, the difference
/// must be seen to. A region has no volume but this sum.
fn check_volume_sum(tiling: &Tiling) -> Result<(), Refusal> {
    if tiling.certificate.claim.domain == Domain::Region {
        return Ok(());
    }
    let d = tiling.dimension();
    let mut sum = Element::default();
    tiling.each_simplex(|_, corners| {
        let value = determinant(&tiling.ring, &tiling.edges(corners));
        sum = std::mem::take(&mut sum).plus(&value);
        Ok(())
    })?;
    let (volume, k) = match &tiling.polytope {
        None => (Element::integer(Integer::ONE), 0),
        Some(polytope) => (domain::volume(tiling, polytope)?, polytope.dimension()),
    };
    let falling = |k: usize| Integer::from((k + 1..=d).product::<usize>() as i64);
    let units = &falling(k) * &tiling.scale.pow(d - k);
    let expected = tiling.ring.times(&volume, &Element::integer(units));
    let cell = &falling(0) * &tiling.scale.pow(d);
    let difference = sum.clone().minus(&expected);
    let of = || "sum of the volumes, minus that of the domain".to_owned();
    match tiling.sign(&difference, &cell, of)? {
        Ordering::Equal => Ok(()),
        _ => Err(Refusal::VolumeSum {
            sum: number(&sum, &cell),
            expected: number(&expected, &cell),
        }),
    }
}

/// M = E G E^T: the inner products e_i · e_j, d N² times too large.
pub(super) fn edge_products(tiling: &Tiling, corners: Corners) -> Matrix {
    let ring = &tiling.ring;
    let edges = tiling.edges(corners);
    let dual: Matrix = edges
        .iter()
        .map(|edge| apply(ring, &tiling.gram, edge))
        .collect();
    let mut products = Matrix::new();
    for (i, edge) in edges.iter().enumerate() {
        let product = |j| match products.get::<usize>(j) {
            Some(row) => row[i].clone(),
            None => ring.dot(edge, &dual[j]),
        };
        products.push((0..edges.len()).map(product).collect());
    }
    products
}

/// The inner products of the gradients g_0, …, g_D of the barycentric
/// coordinates, times det M > 0, where M = E G E^T holds the e_i · e_j.
///
/// g_1, …, g_D is the dual basis of e_1, …, e_D, so (g_i · g_j) = M^-1 = C / det M
/// with C the cofactors of M, and g_0 = -(g_1 + … + g_D). The gradient g_i is
/// the inward normal of the facet opposite to x_i. det M > 0 because det E and
/// det G are. The result is d^(D-1) N^(2D-2) too large.
pub(super) fn gradient_products(tiling: &Tiling, corners: Corners) -> Matrix {
    let inner = cofactors(&tiling.ring, &edge_products(tiling, corners));
    let negated_sum =
        |values: &[Element]| values.iter().fold(Element::default(), |s, v| s.minus(v));
    let first: Vec<Element> = inner.iter().map(|row| negated_sum(row)).collect();
    let corner = negated_sum(&first);
    let row = |x: &Element, xs: &[Element]| iter::once(x).chain(xs).cloned().collect();
    let others = first.iter().zip(&inner).map(|(x, xs)| row(x, xs));
    iter::once(row(&corner, &first)).chain(others).collect()
}

/// The pairs i < j of facets or of corners of a D-simplex: one for each dihedral
/// angle, and one for each edge.
pub(super) fn facet_pairs(dimension: usize) -> impl Iterator<Item = (usize, usize)> {
    (0..=dimension).flat_map(move |j| (0..j).map(move |i| (i, j)))
}

/// The dihedral angle of the facets i and j is less than a right angle:
/// cos = -g_i · g_j / (|g_i| |g_j|) > 0.
fn check_acute(tiling: &Tiling) -> Result<(), Refusal> {
    if !tiling.claims(&Statement::Acute) {
        return Ok(());
    }
    each_product(tiling, |simplex, facets, sign, product| match sign {
        Ordering::Less => Ok(()),
        _ => Err(Refusal::NotAcute {
            simplex,
            facets,
            product: product(),
        }),
    })
}

/// It is at most a right angle: cos >= 0.
fn check_nonobtuse(tiling: &Tiling) -> Result<(), Refusal> {
    if !tiling.claims(&Statement::Nonobtuse) {
        return Ok(());
    }
    each_product(tiling, |simplex, facets, sign, product| match sign {
        Ordering::Less | Ordering::Equal => Ok(()),
        Ordering::Greater => Err(Refusal::NotNonobtuse {
            simplex,
            facets,
            product: product(),
        }),
    })
}

/// Gives `judge` the sign of g_i · g_j, and its value times det M, for each
/// dihedral angle.
fn each_product(
    tiling: &Tiling,
    judge: impl Fn(usize, (usize, usize), Ordering, Value) -> Result<(), Refusal>,
) -> Result<(), Refusal> {
    let d = tiling.dimension();
    let scale = &tiling.gram_scale.pow(d - 1) * &tiling.scale.pow(2 * (d - 1));
    tiling.each_simplex(|simplex, corners| {
        let products = gradient_products(tiling, corners);
        for (i, j) in facet_pairs(tiling.dimension()) {
            let value = &products[i][j];
            let of =
                || format!("product of the normals of facets {i} and {j} of simplex {simplex}");
            let sign = tiling.sign(value, &scale, of)?;
            judge(simplex, (i, j), sign, &|| number(value, &scale))?;
        }
        Ok(())
    })
}

/// The corner behind each facet lies strictly outside of the circumsphere. This
/// local condition implies the global one (Delaunay's lemma, docs/soundness.md).
fn check_delaunay(tiling: &Tiling) -> Result<(), Refusal> {
    if !tiling.claims(&Statement::Delaunay) {
        return Ok(());
    }
    each_power(tiling, |simplex, facet, sign, power| match sign {
        Ordering::Greater => Ok(()),
        _ => Err(Refusal::NotDelaunay {
            simplex,
            facet,
            power: power(),
        }),
    })
}

/// The corner behind each facet does not lie inside of the circumsphere.
fn check_weakly_delaunay(tiling: &Tiling) -> Result<(), Refusal> {
    if !tiling.claims(&Statement::WeaklyDelaunay) {
        return Ok(());
    }
    each_power(tiling, |simplex, facet, sign, power| match sign {
        Ordering::Greater | Ordering::Equal => Ok(()),
        Ordering::Less => Err(Refusal::NotWeaklyDelaunay {
            simplex,
            facet,
            power: power(),
        }),
    })
}

/// Gives `judge` the sign of the power of the corner behind each facet with
/// respect to the circumsphere, and its value times det E.
///
/// Let c be the circumcentre and w the corner, both seen from x_0. The power is
/// |w|² - 2 c · w, and 2 c · e_i = |e_i|² defines c. Write w = λ_1 e_1 + … +
/// λ_D e_D, that is λ = C w / det E with C the cofactors of E. So, as det E > 0,
/// the power has the sign of det(E) |w|² - Σ (C w)_i |e_i|².
///
/// That value belongs to the pair of facets. Let p and q be the powers with respect to the
/// spheres of the two simplices, w and x the corners opposite to the common facet, q(w) = p(x) = 0.
/// Then p - q is affine and zero on the facet; p(w) and -q(x) are its values at w and x, which lie on
/// different sides. So p(w) and q(x) have one sign, and are as the distances of w and x from the facet,
/// while the volumes are as those of x and w: the products are equal. Each pair is looked at
/// once, from its second simplex.
fn each_power(
    tiling: &Tiling,
    judge: impl Fn(usize, usize, Ordering, Value) -> Result<(), Refusal>,
) -> Result<(), Refusal> {
    let scale = &tiling.gram_scale * &tiling.scale.pow(tiling.dimension() + 2);
    let mut sphere: Option<(usize, Sphere)> = None;
    let check = |pair: &Pair| {
        let (simplex, facet) = pair.first;
        let (behind, corners) = (pair.corners.0.get(facet), pair.corners.1);
        let known = sphere.take().filter(|(of, _)| *of == pair.second.0);
        let (_, of_second) =
            sphere.insert(known.unwrap_or_else(|| (pair.second.0, Sphere::new(tiling, corners))));
        let back: Vec<i64> = pair.shift.iter().map(|entry| -entry).collect();
        let value = of_second.power(tiling, &tiling.edge(corners.get(0), behind, &back));
        let of = || format!("power of the corner behind facet {facet} of simplex {simplex}");
        let sign = tiling.sign(&value, &scale, of)?;
        judge(simplex, facet, sign, &|| number(&value, &scale))
    };
    mates::each_pair(tiling, check).map(drop)
}

/// The circumsphere of a simplex.
struct Sphere {
    /// det E
    volume: Element,
    cofactors: Matrix,
    /// |e_i|²
    squares: Vec<Element>,
}

impl Sphere {
    fn new(tiling: &Tiling, corners: Corners) -> Sphere {
        let edges = tiling.edges(corners);
        Sphere {
            volume: determinant(&tiling.ring, &edges),
            cofactors: cofactors(&tiling.ring, &edges),
            squares: edges.iter().map(|edge| square(tiling, edge)).collect(),
        }
    }

    /// det(E) |w|² - Σ (C w)_i |e_i|²
    fn power(&self, tiling: &Tiling, w: &[Element]) -> Element {
        let ring = &tiling.ring;
        ring.times(&self.volume, &square(tiling, w))
            .minus(&ring.dot(&apply(ring, &self.cofactors, w), &self.squares))
    }
}

/// |x|²
fn square(tiling: &Tiling, x: &[Element]) -> Element {
    let ring = &tiling.ring;
    ring.dot(x, &apply(ring, &tiling.gram, x))
}
