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
use super::simplex::{self, Judge, check_simplices};
use super::tiling::{Tiling, number};
use super::{Refusal, angle, domain, mates, radius, region, tcp};
use crate::certificate::{Domain, Number, Statement};
use std::cmp::Ordering;

/// A check of the numbers; it may rely on [`super::shape::CHECKS`] and on the
/// checks before it.
#[derive(Clone, Copy)]
pub(super) enum Check {
    /// Of the tiling.
    Whole(fn(&Tiling) -> Result<(), Refusal>),
    /// Of each simplex for itself.
    Each(simplex::Statement),
}

use Check::{Each, Whole};

/// The exact value whose sign was judged, made only for a refusal.
type Value<'v> = &'v dyn Fn() -> Number;

/// All of them. A statement that is not claimed is not checked.
pub(super) const CHECKS: &[(&str, Check)] = &[
    ("gram_positive", Whole(check_gram_positive)),
    ("facets", Whole(domain::check_facets)),
    ("polygons", Whole(domain::check_polygons)),
    ("closed", Whole(domain::check_closed)),
    ("inside", Whole(domain::check_inside)),
    ("orientation", Whole(check_orientation)),
    ("mates_mutual", Whole(mates::check_mates_mutual)),
    ("mates_meet", Whole(mates::check_mates_meet)),
    ("boundary", Whole(domain::check_boundary)),
    ("volume_sum", Whole(check_volume_sum)),
    ("boundary_apart", Whole(region::check_boundary_apart)),
    ("covering", Whole(region::check_covering)),
    ("acute", Each(judge_acute)),
    ("nonobtuse", Each(judge_nonobtuse)),
    ("dihedral_below", Each(angle::judge_below)),
    ("dihedral_above", Each(angle::judge_above)),
    ("radius_edge", Each(radius::judge_radius_edge)),
    ("delaunay", Whole(check_delaunay)),
    ("weakly_delaunay", Whole(check_weakly_delaunay)),
    ("tcp_edges", Whole(tcp::check_tcp_edges)),
    ("tcp_triangles", Whole(tcp::check_tcp_triangles)),
];

/// All of these checks in their order; those of single simplices that stand side by side look
/// at each simplex once.
pub(super) fn check(tiling: &Tiling, checks: &[(&str, Check)]) -> Result<(), Refusal> {
    for run in
        checks.chunk_by(|(_, first), (_, second)| matches!((first, second), (Each(_), Each(_))))
    {
        let mut statements = Vec::new();
        for (_, check) in run {
            match check {
                Whole(check) => check(tiling)?,
                Each(statement) => statements.push(*statement),
            }
        }
        check_simplices(tiling, &statements)?;
    }
    Ok(())
}

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

/// The pairs i < j of facets or of corners of a D-simplex: one for each dihedral
/// angle, and one for each edge.
pub(super) fn facet_pairs(dimension: usize) -> impl Iterator<Item = (usize, usize)> {
    (0..=dimension).flat_map(move |j| (0..j).map(move |i| (i, j)))
}

/// The dihedral angle of the facets i and j is less than a right angle:
/// cos = -g_i · g_j / (|g_i| |g_j|) > 0.
fn judge_acute<'t>(tiling: &'t Tiling) -> Option<Judge<'t>> {
    judge_products(
        tiling,
        Statement::Acute,
        |simplex, facets, sign, product| match sign {
            Ordering::Less => Ok(()),
            _ => Err(Refusal::NotAcute {
                simplex,
                facets,
                product: product(),
            }),
        },
    )
}

/// It is at most a right angle: cos >= 0.
fn judge_nonobtuse<'t>(tiling: &'t Tiling) -> Option<Judge<'t>> {
    judge_products(
        tiling,
        Statement::Nonobtuse,
        |simplex, facets, sign, product| match sign {
            Ordering::Less | Ordering::Equal => Ok(()),
            Ordering::Greater => Err(Refusal::NotNonobtuse {
                simplex,
                facets,
                product: product(),
            }),
        },
    )
}

/// Gives `judge` the sign of g_i · g_j, and its value times det M, for each
/// dihedral angle, if `statement` is claimed.
fn judge_products<'t>(
    tiling: &'t Tiling,
    statement: Statement,
    judge: impl Fn(usize, (usize, usize), Ordering, Value) -> Result<(), Refusal> + 't,
) -> Option<Judge<'t>> {
    if !tiling.claims(&statement) {
        return None;
    }
    let d = tiling.dimension();
    let scale = &tiling.gram_scale.pow(d - 1) * &tiling.scale.pow(2 * (d - 1));
    Some(Box::new(move |simplex| {
        let index = simplex.index;
        for (i, j) in facet_pairs(d) {
            let value = &simplex.gradients[i][j];
            let of = || format!("product of the normals of facets {i} and {j} of simplex {index}");
            let sign = tiling.sign(value, &scale, of)?;
            judge(index, (i, j), sign, &|| number(value, &scale))?;
        }
        Ok(())
    }))
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
