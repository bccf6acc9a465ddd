//! Enclosures of ratios and dihedral angles over all simplices and the whole box.
//!
//! Each figure is the infimum or the supremum of a measure. It lies between a proved bound and a value
//! that is attained at a point of the closed box, or is approached there. The box is cut where the bound
//! is worst, until the two agree or a limit is reached. No certificate states these figures.

use super::Family;
use super::cleared::{Cleared, to_number};
use crate::quality::{DihedralAngle, RadiusEdge};
use crate::tiling::SimplexId;
use acutile_exact::geometry::{RingElement, Sign};
use acutile_exact::number::Number;
use acutile_exact::polynomial::{Cuboid, Polynomial, bernstein};
use malachite::Rational;
use std::collections::BTreeSet;

/// The place of an infimum or a supremum.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Extreme<T> {
    /// Proved: no value is beyond. `None` if no bound was found.
    pub bound: Option<T>,
    /// A value at a point of the closed box; `None` if simplices are degenerate at all points that were tried.
    pub seen: Option<T>,
}

/// The infimum and the supremum over all simplices and the box.
#[derive(Clone, Debug)]
pub struct Span<T> {
    /// The greatest lower bound.
    pub infimum: Extreme<T>,
    /// The least upper bound.
    pub supremum: Extreme<T>,
}

/// The figures of a family as those of a row of Table 1.
#[derive(Clone, Debug)]
pub struct Spans {
    /// Of the circumradius over the shortest edge of each simplex.
    pub radius_edge: Span<RadiusEdge>,
    /// Of the smallest dihedral angle of each simplex.
    pub smallest_dihedral: Span<DihedralAngle>,
    /// Of the largest dihedral angle of each simplex.
    pub largest_dihedral: Span<DihedralAngle>,
}

/// How often the box is cut for one figure.
const CUTS: usize = 48;
/// Boxes with more sides have too many corners to try.
const MOST_SIDES: usize = 6;

/// The spans of a family whose simplices are positively oriented on the whole box.
pub fn spans<const D: usize>(family: &Family<D>) -> Spans {
    let cleared = Cleared::new(family, to_number);
    let measures = |of: fn(&Cleared<Number, D>, SimplexId) -> Vec<Quotient>| -> Vec<Measure> {
        let all: BTreeSet<Measure> = family
            .simplices()
            .map(|s| sorted(of(&cleared, s)))
            .collect();
        all.into_iter().collect()
    };
    let cuboid = family.cuboid();
    let ratios = span(&measures(ratios), &cuboid, Choice::Largest);
    let cosines = measures(cosines);
    // The larger the cosine, the smaller the angle.
    let smallest = span(&cosines, &cuboid, Choice::Largest).reversed();
    let largest = span(&cosines, &cuboid, Choice::Smallest).reversed();
    let angle = |signed_square| DihedralAngle { signed_square };
    Spans {
        radius_edge: ratios.map(|square| RadiusEdge { square }),
        smallest_dihedral: smallest.map(angle),
        largest_dihedral: largest.map(angle),
    }
}

impl<T> Span<T> {
    fn reversed(self) -> Self {
        Span {
            infimum: self.supremum,
            supremum: self.infimum,
        }
    }

    fn map<U>(self, map: impl Fn(T) -> U) -> Span<U> {
        let extreme = |extreme: Extreme<T>| Extreme {
            bound: extreme.bound.map(&map),
            seen: extreme.seen.map(&map),
        };
        Span {
            infimum: extreme(self.infimum),
            supremum: extreme(self.supremum),
        }
    }
}

/// p/q with q > 0 inside of the box, or for a cosine p/√q the square with the sign of p.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Quotient {
    p: Polynomial,
    q: Polynomial,
    is_cosine: bool,
}

/// Of these quotients the largest or the smallest is the measure of a simplex.
type Measure = Vec<Quotient>;

#[derive(Clone, Copy, PartialEq, Eq)]
enum Choice {
    Largest,
    Smallest,
}

impl Choice {
    fn of(self, values: impl Iterator<Item = Number>) -> Option<Number> {
        match self {
            Choice::Largest => values.max(),
            Choice::Smallest => values.min(),
        }
    }
}

fn sorted(mut measure: Measure) -> Measure {
    measure.sort_unstable();
    measure.dedup();
    measure
}

/// R²/|e|² for all edges e.
fn ratios<const D: usize>(cleared: &Cleared<Number, D>, simplex: SimplexId) -> Measure {
    let simplex = cleared.simplex(simplex);
    let products = simplex.normal_products(&cleared.cogram);
    let (numerator, denominator) = simplex.squared_circumradius(&cleared.gram, &products);
    let mut quotients = Vec::new();
    simplex.for_squared_edges(&cleared.gram, |edge| {
        quotients.push(Quotient {
            p: numerator.clone(),
            q: denominator.times(edge),
            is_cosine: false,
        });
    });
    quotients
}

fn cosines<const D: usize>(cleared: &Cleared<Number, D>, simplex: SimplexId) -> Measure {
    let products = cleared.simplex(simplex).normal_products(&cleared.cogram);
    let cosine = |(i, j, product): (usize, usize, &Polynomial)| Quotient {
        p: product.negated(),
        q: products.get(i, i).times(products.get(j, j)),
        is_cosine: true,
    };
    products.pairs().map(cosine).collect()
}

impl Quotient {
    /// The value at a point, or with its sign the square of the cosine there.
    fn value(&self, point: &[Number]) -> Option<Number> {
        let p = self.p.value(point);
        let p = if !self.is_cosine {
            p
        } else if p.sign() == Sign::Less {
            -(&p * &p)
        } else {
            &p * &p
        };
        p.divide(&self.q.value(point))
    }

    /// Bounds on a box.
    fn bounds(&self, cuboid: &Cuboid) -> [Option<Number>; 2] {
        if !self.is_cosine {
            return bernstein::quotient_bounds(&self.p, &self.q, cuboid);
        }
        let [low, high] = bernstein::quotient_bounds(&self.p.times(&self.p), &self.q, cuboid);
        // By the inequality of Cauchy and Schwarz the square is at most 1.
        let one = Number::from(Rational::from(1));
        let high = high.map_or(one.clone(), |high| high.min(one));
        let low = low.map_or(Number::zero(), |low| low.max(Number::zero()));
        let is_proved = |p: &Polynomial| bernstein::is_nonnegative(p, cuboid) == Some(true);
        match (is_proved(&self.p), is_proved(&self.p.negated())) {
            (true, _) => [Some(low), Some(high)],
            (_, true) => [Some(-high), Some(-low)],
            _ => [Some(-high.clone()), Some(high)],
        }
    }
}

fn span(measures: &[Measure], cuboid: &Cuboid, choice: Choice) -> Span<Number> {
    let search = |is_supremum| {
        let search = Search {
            measures,
            choice,
            is_supremum,
        };
        search.run(cuboid)
    };
    Span {
        infimum: search(false),
        supremum: search(true),
    }
}

struct Search<'m> {
    measures: &'m [Measure],
    choice: Choice,
    is_supremum: bool,
}

/// A part of the box with the proved bounds of the measures that may be beyond what was seen.
struct Part {
    cuboid: Cuboid,
    bound: Option<Number>,
    open: Vec<usize>,
}

impl Search<'_> {
    fn run(&self, cuboid: &Cuboid) -> Extreme<Number> {
        let mut seen = None;
        let all: Vec<usize> = (0..self.measures.len()).collect();
        let mut parts = vec![self.part(cuboid.clone(), &all, &mut seen)];
        for _ in 0..CUTS {
            let Some(worst) = self.worst(&parts) else {
                break;
            };
            if !self.is_beyond(&parts[worst].bound, &seen) {
                break;
            }
            let part = parts.swap_remove(worst);
            let axis = longest(&part.cuboid, cuboid);
            for half in part.cuboid.halves(axis) {
                parts.push(self.part(half, &part.open, &mut seen));
            }
        }
        let bound = self
            .worst(&parts)
            .and_then(|worst| parts[worst].bound.clone());
        // Parts without an open measure say no more than what was seen.
        let is_final = !parts.iter().any(|part| self.is_beyond(&part.bound, &seen));
        let bound = if is_final { seen.clone() } else { bound };
        Extreme { bound, seen }
    }

    /// Whether a bound, none being infinite, is beyond a value.
    fn is_beyond(&self, bound: &Option<Number>, seen: &Option<Number>) -> bool {
        match (bound, seen) {
            (Some(bound), Some(seen)) => self.is_better(bound, seen),
            _ => true,
        }
    }

    fn is_better(&self, value: &Number, than: &Number) -> bool {
        if self.is_supremum {
            value > than
        } else {
            value < than
        }
    }

    fn worst(&self, parts: &[Part]) -> Option<usize> {
        let mut worst: Option<usize> = None;
        for (k, part) in parts.iter().enumerate() {
            let is_worse = match worst.map(|w| &parts[w].bound) {
                None => true,
                Some(None) => false,
                Some(old) => self.is_beyond(&part.bound, old),
            };
            if is_worse {
                worst = Some(k);
            }
        }
        worst
    }

    fn part(&self, cuboid: Cuboid, measures: &[usize], seen: &mut Option<Number>) -> Part {
        for point in points(&cuboid) {
            for value in measures.iter().filter_map(|k| self.value(*k, &point)) {
                if seen
                    .as_ref()
                    .is_none_or(|seen| self.is_better(&value, seen))
                {
                    *seen = Some(value);
                }
            }
        }
        let bounds = measures.iter().map(|k| (*k, self.bound(*k, &cuboid)));
        let open: Vec<(usize, Option<Number>)> = bounds
            .filter(|(_, bound)| self.is_beyond(bound, seen))
            .collect();
        let mut bound = seen.clone();
        for (_, other) in &open {
            if self.is_beyond(other, &bound) {
                bound.clone_from(other);
            }
            if bound.is_none() {
                break;
            }
        }
        Part {
            cuboid,
            bound,
            open: open.into_iter().map(|(k, _)| k).collect(),
        }
    }

    /// The measure at a point; `None` if the simplex is degenerate there.
    fn value(&self, measure: usize, point: &[Number]) -> Option<Number> {
        let values: Option<Vec<Number>> = self.measures[measure]
            .iter()
            .map(|quotient| quotient.value(point))
            .collect();
        self.choice.of(values?.into_iter())
    }

    /// The bound of a measure on a box. A largest value has the largest of the bounds; where one is missing,
    /// the others still bound the infimum of the largest.
    fn bound(&self, measure: usize, cuboid: &Cuboid) -> Option<Number> {
        let side = usize::from(self.is_supremum);
        let bounds = self.measures[measure].iter();
        let bounds: Vec<Option<Number>> = bounds
            .map(|quotient| quotient.bounds(cuboid)[side].clone())
            .collect();
        let needs_all = (self.choice == Choice::Largest) == self.is_supremum;
        if needs_all && bounds.iter().any(Option::is_none) {
            None
        } else {
            self.choice.of(bounds.into_iter().flatten())
        }
    }
}

/// The middle and the corners of the closed box.
fn points(cuboid: &Cuboid) -> Vec<Vec<Number>> {
    let mut closed = cuboid.clone();
    for side in &mut closed.sides {
        (side.low.is_open, side.high.is_open) = (false, false);
    }
    let mut points = vec![cuboid.center()];
    if cuboid.sides.len() <= MOST_SIDES {
        points.extend(closed.corners());
    }
    points
}

/// The side that is longest against the whole box. Doubles decide nothing else.
fn longest(cuboid: &Cuboid, whole: &Cuboid) -> usize {
    let sides = cuboid.sides.iter().zip(&whole.sides);
    let parts =
        sides.map(|(side, whole)| side.length().approximate() / whole.length().approximate());
    let longest = parts
        .enumerate()
        .max_by(|a, b| a.1.total_cmp(&b.1).then(b.0.cmp(&a.0)));
    longest.map_or(0, |(axis, _)| axis)
}
