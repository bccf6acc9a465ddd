//! Surfaces of the boundary, and the volume that each encloses.

use crate::tiling::{Corner, Facet, SimplexId, Tiling, VertexId, difference};
use acutile_exact::geometry::{Sign, Simplex};
use acutile_exact::number::Number;
use std::collections::{BTreeMap, BTreeSet, HashMap};

/// The kind of body that a surface bounds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A piece, from outside.
    Outer,
    /// A hole in a piece.
    Cavity,
    /// The surface closes only up to the lattice, or not without surfaces that touch it.
    Open,
}

/// Boundary facets that hang together.
#[derive(Clone, Debug)]
pub struct Surface<const D: usize> {
    /// The facets, in order.
    pub facets: Vec<Facet>,
    /// The different vertices.
    pub vertices: usize,
    /// The kind of body that it bounds.
    pub kind: Kind,
}

impl<const D: usize> Surface<D> {
    /// The simplices with facets in the surface, in order.
    pub fn simplices(&self) -> Vec<SimplexId> {
        let simplices: BTreeSet<SimplexId> = self.facets.iter().map(|f| f.simplex).collect();
        simplices.into_iter().collect()
    }

    /// The least number of simplices that fill a cavity like a ball without further vertices: V - D
    /// for V vertices.
    pub fn least_filling(&self) -> usize {
        self.vertices.saturating_sub(D).max(1)
    }

    /// Whether one simplex fills the cavity.
    pub fn is_one_simplex(&self) -> bool {
        self.facets.len() == D + 1 && self.vertices == D + 1
    }
}

/// The corners of a facet, in an order whose normal points out of the simplex.
pub fn facet_corners<const D: usize>(tiling: &Tiling<D>, facet: Facet) -> Vec<Corner<D>> {
    let opposite = usize::from(facet.opposite);
    let corners = tiling.simplex(facet.simplex).iter().enumerate();
    let corners = corners.filter(|(k, _)| *k != opposite);
    let mut corners: Vec<Corner<D>> = corners.map(|(_, corner)| *corner).collect();
    if opposite % 2 == 1 {
        corners.swap(D - 2, D - 1);
    }
    corners
}

type Use<const D: usize> = (Facet, [i32; D]);

/// The ridges of the boundary facets up to translation, each with its facets and the shift of its
/// first corner there.
pub struct Ridges<const D: usize> {
    uses: HashMap<Vec<Corner<D>>, Vec<Use<D>>>,
}

impl<const D: usize> Ridges<D> {
    /// The ridges of some facets.
    pub fn of(tiling: &Tiling<D>, boundary: &[Facet]) -> Self {
        let mut uses: HashMap<_, Vec<_>> = HashMap::new();
        for &facet in boundary {
            for (form, origin) in ridges(&facet_corners(tiling, facet)) {
                uses.entry(form).or_default().push((facet, origin));
            }
        }
        Ridges { uses }
    }

    /// Ridges with another number of facets than two, in order.
    pub fn singular(&self) -> Vec<(Vec<Corner<D>>, usize)> {
        let uses = self.uses.iter().filter(|(_, uses)| uses.len() != 2);
        let mut list: Vec<_> = uses
            .map(|(form, uses)| (form.clone(), uses.len()))
            .collect();
        list.sort();
        list
    }
}

/// The ridges of a facet: sorted, the first shift moved to zero; with that shift.
fn ridges<const D: usize>(corners: &[Corner<D>]) -> Vec<(Vec<Corner<D>>, [i32; D])> {
    let ridge = |left_out: usize| {
        let mut ridge = corners.to_vec();
        ridge.remove(left_out);
        ridge.sort();
        let origin = ridge.first().map_or([0; D], |corner| corner.shift);
        for corner in &mut ridge {
            corner.shift = difference(corner.shift, origin);
        }
        (ridge, origin)
    };
    (0..corners.len()).map(ridge).collect()
}

/// The surfaces of all boundary facets.
pub fn surfaces<const D: usize>(
    tiling: &Tiling<D>,
    ridges: &Ridges<D>,
    boundary: &[Facet],
) -> Vec<Surface<D>> {
    let mut seen = BTreeSet::new();
    let mut surfaces = Vec::new();
    for &start in boundary {
        if !seen.contains(&start) {
            let placed = connected(tiling, ridges, start);
            seen.extend(placed.facets.keys().copied());
            surfaces.push(surface(tiling, &placed));
        }
    }
    surfaces
}

/// Facets that hang together, each with the lattice vector that moves it to where it hangs.
struct Placed<const D: usize> {
    facets: BTreeMap<Facet, [i32; D]>,
    /// Whether every way to a facet leads to the same place, and no ridge has other facets.
    is_closed: bool,
}

fn connected<const D: usize>(tiling: &Tiling<D>, ridges: &Ridges<D>, start: Facet) -> Placed<D> {
    let mut facets = BTreeMap::from([(start, [0; D])]);
    let mut waiting = vec![start];
    let mut is_unique = true;
    while let Some(facet) = waiting.pop() {
        let shift = facets[&facet];
        for (form, origin) in self::ridges(&facet_corners(tiling, facet)) {
            let [a, b] = ridges.uses[&form][..] else {
                continue;
            };
            let (other, there) = if a.0 == facet { b } else { a };
            let by = difference(origin, there);
            let place: [i32; D] = std::array::from_fn(|k| shift[k] + by[k]);
            match facets.get(&other) {
                Some(known) => is_unique &= *known == place,
                None => {
                    facets.insert(other, place);
                    waiting.push(other);
                }
            }
        }
    }
    let is_closed = is_unique && closes_up(tiling, &facets);
    Placed { facets, is_closed }
}

/// Whether every ridge, in its place, is in an even number of the facets: then they bound.
fn closes_up<const D: usize>(tiling: &Tiling<D>, facets: &BTreeMap<Facet, [i32; D]>) -> bool {
    let mut is_odd: HashMap<Vec<Corner<D>>, bool> = HashMap::new();
    for (facet, shift) in facets {
        let corners = facet_corners(tiling, *facet);
        let corners: Vec<Corner<D>> = corners.iter().map(|c| c.moved(*shift)).collect();
        for left_out in 0..corners.len() {
            let mut ridge = corners.clone();
            ridge.remove(left_out);
            ridge.sort();
            *is_odd.entry(ridge).or_default() ^= true;
        }
    }
    is_odd.values().all(|is_odd| !is_odd)
}

fn surface<const D: usize>(tiling: &Tiling<D>, placed: &Placed<D>) -> Surface<D> {
    let corners = placed.facets.iter().flat_map(|(facet, shift)| {
        let corners = facet_corners(tiling, *facet).into_iter();
        corners.map(|corner| corner.moved(*shift))
    });
    let distinct: BTreeSet<(VertexId, [i32; D])> = corners.map(|c| (c.vertex, c.shift)).collect();
    let kind = match placed.is_closed.then(|| enclosed(tiling, placed)) {
        Some(Sign::Less) => Kind::Cavity,
        Some(_) => Kind::Outer,
        None => Kind::Open,
    };
    Surface {
        facets: placed.facets.keys().copied().collect(),
        vertices: distinct.len(),
        kind,
    }
}

/// The sign of the volume that a closed surface encloses: the sum over its facets of det(p_1 - o, …,
/// p_D - o) for any point o.
fn enclosed<const D: usize>(tiling: &Tiling<D>, placed: &Placed<D>) -> Sign {
    let facets = || {
        placed.facets.iter().map(|(facet, shift)| {
            let corners = facet_corners(tiling, *facet).into_iter();
            corners.map(|c| c.moved(*shift)).collect::<Vec<_>>()
        })
    };
    if let Some(sign) = enclosed_in_doubles(tiling, facets()) {
        return sign;
    }
    let mut origin = None;
    let mut sum = Number::zero();
    for corners in facets() {
        let positions = corners.iter().map(|corner| tiling.position(corner));
        let mut points: Vec<[Number; D]> = positions.collect();
        points.insert(0, origin.get_or_insert_with(|| points[0].clone()).clone());
        sum = sum + Simplex::new(&points).determinant;
    }
    sum.sign()
}

/// The same, if doubles know it. Each coordinate has a relative error of at most 2^-51 and each product
/// a few times that; the sum of n determinants has n more roundings. So (n + 64) 2^-48 times the sum of
/// the sizes of all summands is more than the error.
fn enclosed_in_doubles<const D: usize>(
    tiling: &Tiling<D>,
    facets: impl Iterator<Item = Vec<Corner<D>>>,
) -> Option<Sign> {
    let (mut sum, mut size, mut count) = (0.0f64, 0.0f64, 0.0f64);
    for corners in facets {
        let position = |corner: &Corner<D>| -> [f64; D] {
            let vertex = tiling.vertices.vertex(corner.vertex);
            std::array::from_fn(|k| vertex[k].approximate() + f64::from(corner.shift[k]))
        };
        let mut points: Vec<[f64; D]> = corners.iter().map(position).collect();
        points.insert(0, [0.0; D]);
        sum += Simplex::new(&points).determinant;
        let largest = |point: &[f64; D]| point.iter().fold(0.0f64, |most, x| most.max(x.abs()));
        let product: f64 = points[1..].iter().map(largest).product();
        size += 6.0 * product;
        count += 1.0;
    }
    let margin = (count + 64.0) * size * 2f64.powi(-48);
    (sum.abs() > margin && sum.is_finite()).then_some(if sum < 0.0 {
        Sign::Less
    } else {
        Sign::Greater
    })
}
