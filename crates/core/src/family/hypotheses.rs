//! The hypotheses of the theorem as conditions, and the statements without bounds.
//!
//! The combinatorial hypotheses hold for all members or for none: a checked member decides them.
//! The same member gives the side of each plane and the sign of each cone.

use super::cleared::Cleared;
use super::conditions::{Atom, Conditions};
use crate::tiling::{Facet, Matching, Plane, Polytope, Tiling};
use acutile_exact::geometry::{RingElement, Sign, linear};
use acutile_exact::number::Number;
use acutile_exact::polynomial::{Coefficient, Polynomial};

/// A member whose combinatorics is checked.
#[derive(Clone, Copy, Debug)]
pub struct Member<'m, const D: usize> {
    /// The values of the parameters.
    pub point: &'m [Number],
    /// The tiling at this point.
    pub tiling: &'m Tiling<D>,
    /// Which facets coincide.
    pub matching: &'m Matching<D>,
}

impl<const D: usize> Member<'_, D> {
    fn sign<C: Coefficient>(&self, p: &Polynomial<C>) -> Sign {
        p.map(C::to_number).sign_at(self.point)
    }
}

/// Hypotheses M, O, D, I, F and V.
pub fn add<C: Coefficient, const D: usize>(
    cleared: &Cleared<C, D>,
    member: &Member<D>,
    conditions: &mut Conditions<C>,
) {
    add_metric(cleared, conditions);
    let one = cleared.unit.integer(1);
    let mut sum = one.integer(0);
    for simplex in cleared.family.simplices() {
        let determinant = cleared.simplex(simplex).determinant;
        sum = sum.plus(&determinant);
        conditions.add(Atom::positive(determinant));
    }
    match &cleared.polytope {
        None => {
            let power = |n: usize| (0..n).fold(one.clone(), |p, _| p.times(&cleared.unit));
            conditions.add(Atom::zero(sum.minus(&scaled(&power(D), D))));
        }
        Some(polytope) => {
            let planes = add_domain(polytope, member, conditions);
            add_inside(cleared, &planes, member, conditions);
            let volume = add_cones(polytope, member, conditions);
            // The sum of det E is D! times the volume, and the cones have k! times that of P.
            let k = polytope.dimension();
            let lattice = (k..D).fold(volume, |v, _| v.times(&cleared.unit));
            conditions.add(Atom::zero(scaled(&sum, k).minus(&scaled(&lattice, D))));
        }
    }
}

/// n! p
fn scaled<C: Coefficient>(p: &Polynomial<C>, n: usize) -> Polynomial<C> {
    let factorial: i64 = (1..=n as i64).product();
    p.times(&p.integer(factorial))
}

/// M. The leading principal minors of the Gram matrix are positive.
fn add_metric<C: Coefficient, const D: usize>(
    cleared: &Cleared<C, D>,
    conditions: &mut Conditions<C>,
) {
    for order in 1..=D {
        let block: [[Polynomial<C>; D]; D] = std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                if i.max(j) < order {
                    cleared.gram[i][j].clone()
                } else {
                    cleared.unit.integer(i64::from(i == j))
                }
            })
        });
        conditions.add(Atom::positive(linear::determinant(&block)));
    }
}

/// D. The faces span the facets of a convex polytope. Gives their planes, turned inwards.
fn add_domain<C: Coefficient, const D: usize>(
    polytope: &Polytope<Polynomial<C>>,
    member: &Member<D>,
    conditions: &mut Conditions<C>,
) -> Vec<Plane<Polynomial<C>>> {
    let mut planes = Vec::with_capacity(polytope.faces.len());
    for (face, corners) in polytope.faces.iter().enumerate() {
        let Some(plane) = polytope.unturned_plane(face) else {
            conditions.add_impossible();
            continue;
        };
        let others = || (0..polytope.vertices.len()).filter(|v| !corners.contains(v));
        let side = others().map(|v| member.sign(&plane.value(&polytope.vertices[v])));
        let is_turned = side.into_iter().find(|s| s.is_ne()) == Some(Sign::Less);
        let plane = if is_turned { plane.turned() } else { plane };
        for vertex in corners {
            conditions.add(Atom::zero(plane.value(&polytope.vertices[*vertex])));
        }
        for vertex in others() {
            conditions.add(Atom::positive(plane.value(&polytope.vertices[vertex])));
        }
        if polytope.dimension() == 3 {
            add_convex_cycle(polytope, corners, member, conditions);
        }
        planes.push(plane);
    }
    planes
}

/// The corners of a face are in the cyclic order of a convex polygon. Seen from a fixed vertex o that is
/// not in its plane, every other corner t is on the same side of every side pq.
fn add_convex_cycle<C: Coefficient, const D: usize>(
    polytope: &Polytope<Polynomial<C>>,
    corners: &[usize],
    member: &Member<D>,
    conditions: &mut Conditions<C>,
) {
    let Some(apex) = (0..polytope.vertices.len()).find(|v| !corners.contains(v)) else {
        return conditions.add_impossible();
    };
    let n = corners.len();
    for i in 0..n {
        let (p, q) = (corners[i], corners[(i + 1) % n]);
        for t in corners.iter().copied().filter(|t| *t != p && *t != q) {
            let row = |v: usize| -> [Polynomial<C>; 3] {
                std::array::from_fn(|k| polytope.vertices[v][k].minus(&polytope.vertices[p][k]))
            };
            let side = linear::determinant(&[row(q), row(t), row(apex)]);
            conditions.add(Atom::positive(turned(side, member)));
        }
    }
}

/// The polynomial or its negative, whichever is positive for the member.
fn turned<C: Coefficient, const D: usize>(p: Polynomial<C>, member: &Member<D>) -> Polynomial<C> {
    if member.sign(&p) == Sign::Less {
        p.negated()
    } else {
        p
    }
}

/// The sum of the cones over the faces, k! times the volume of the polytope. Each cone keeps its
/// sign.
fn add_cones<C: Coefficient, const D: usize>(
    polytope: &Polytope<Polynomial<C>>,
    member: &Member<D>,
    conditions: &mut Conditions<C>,
) -> Polynomial<C> {
    let mut sum = Polynomial::zero();
    for face in 0..polytope.faces.len() {
        let cone = turned(polytope.scaled_cone(face), member);
        sum = sum.plus(&cone);
        if !cone.is_zero() {
            conditions.add(Atom::positive(cone));
        }
    }
    sum
}

/// I and F. Every vertex lies in the domain, and every facet without a mate in a face of it.
fn add_inside<C: Coefficient, const D: usize>(
    cleared: &Cleared<C, D>,
    planes: &[Plane<Polynomial<C>>],
    member: &Member<D>,
    conditions: &mut Conditions<C>,
) {
    let mut faces: Vec<Vec<usize>> = Vec::with_capacity(cleared.vertices.len());
    for vertex in &cleared.vertices {
        let point = &vertex[cleared.family.frame.rank()..];
        let mut on = Vec::new();
        for (face, plane) in planes.iter().enumerate() {
            let value = plane.value(point);
            if value.is_zero() {
                on.push(face);
            } else {
                conditions.add(Atom::nonnegative(value));
            }
        }
        faces.push(on);
    }
    for mismatch in &member.matching.mismatches {
        let boundary = mismatch.uses.iter().map(|(facet, _)| *facet);
        if !boundary
            .clone()
            .all(|facet| lies_in_face(cleared, facet, &faces))
        {
            conditions.add_impossible();
        }
    }
}

fn lies_in_face<C: Coefficient, const D: usize>(
    cleared: &Cleared<C, D>,
    facet: Facet,
    faces: &[Vec<usize>],
) -> bool {
    let corners = cleared.corners(facet.simplex).iter().enumerate();
    let mut lists = corners
        .filter(|(k, _)| *k != usize::from(facet.opposite))
        .map(|(_, corner)| &faces[corner.vertex.index()]);
    let Some(first) = lists.next() else {
        return false;
    };
    let others: Vec<&Vec<usize>> = lists.collect();
    first
        .iter()
        .any(|face| others.iter().all(|list| list.contains(face)))
}

/// Delaunay, or weakly so: one condition for each pair of neighbours.
pub fn add_delaunay<C: Coefficient, const D: usize>(
    cleared: &Cleared<C, D>,
    member: &Member<D>,
    is_strict: bool,
    conditions: &mut Conditions<C>,
) {
    for power in powers(cleared, member) {
        conditions.add(Atom::strict_if(is_strict, power));
    }
}

/// Not Delaunay: the power of some neighbour's corner is negative.
pub fn add_not_delaunay<C: Coefficient, const D: usize>(
    cleared: &Cleared<C, D>,
    member: &Member<D>,
    conditions: &mut Conditions<C>,
) {
    let inside = |power: Polynomial<C>| vec![Atom::positive(power.negated())];
    let alternatives: Vec<_> = powers(cleared, member).into_iter().map(inside).collect();
    if alternatives.is_empty() {
        conditions.add_impossible()
    } else {
        conditions.add_alternatives(alternatives)
    }
}

/// For each pair of neighbours the power of the one's corner for the other's circumsphere, times its
/// determinant.
fn powers<C: Coefficient, const D: usize>(
    cleared: &Cleared<C, D>,
    member: &Member<D>,
) -> Vec<Polynomial<C>> {
    let mut powers = Vec::new();
    for simplex in cleared.family.simplices() {
        let mut shape = None;
        for facet in (0..=D).map(|opposite| Facet::new(simplex, opposite)) {
            let Some(mate) = member.matching.neighbour(facet) else {
                continue;
            };
            let apex = member.matching.apex(member.tiling, facet);
            if let Some(apex) = apex.filter(|_| facet < mate) {
                let shape = shape.get_or_insert_with(|| cleared.simplex(simplex));
                let origin = cleared.position(&cleared.corners(simplex)[0]);
                let offset = linear::subtract(&cleared.position(&apex), &origin);
                let power = shape.power(&cleared.gram, &offset);
                powers.push(power);
            }
        }
    }
    powers
}
