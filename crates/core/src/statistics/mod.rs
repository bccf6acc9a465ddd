//! Quality of a mesh: how its dihedral angles are distributed, the extreme ones and who has them,
//! radius-edge ratios, aspect ratios.
//!
//! Counts and extremes are exact: a double computed from exact values decides only where it is
//! far from every other candidate, and exact arithmetic decides the rest. Aspect ratios are
//! doubles and are called so. Nothing is proved about the tiling as a whole.

mod chart;
mod cosine;
mod data;
mod extreme;

pub use chart::{csv, svg, text};
pub use data::data;
pub use extreme::Extreme;

use crate::predicates::ring::{Ring, cleared_integers};
use crate::quality::{DihedralAngle, Exact, measures};
use crate::tiling::dimension::same;
use crate::tiling::{SimplexId, Tiling};
use acutile_exact::geometry::{NormalProducts, Scalar, Sign, Simplex, linear};
use acutile_exact::number::Number;
use cosine::{Bins, Cosine};
use malachite::base::num::arithmetic::traits::Floor;
use malachite::base::num::basic::traits::Zero;
use malachite::{Integer, Rational};
use std::collections::BTreeMap;
use std::rc::Rc;

/// A dihedral angle of a tiling: the simplex and the two facets, each named by the corner
/// opposite to it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    pub simplex: SimplexId,
    pub facets: (usize, usize),
}

/// The figures of a tiling.
#[derive(Clone, Debug)]
pub struct Statistics {
    /// Simplices, with those left out.
    pub simplices: usize,
    /// Flat or negatively oriented simplices; they are left out of everything else.
    pub left_out: Vec<SimplexId>,
    /// Simplices whose angles are all acute; with right angles but none obtuse; with obtuse ones.
    pub kinds: [usize; 3],
    /// Dihedral angles that are acute, right, obtuse.
    pub angles: [usize; 3],
    /// Counts of angles from k w to below (k + 1) w degrees, for the width w = `degrees_per_bin`.
    pub histogram: Vec<usize>,
    /// Width of a bin in degrees; divides 180.
    pub degrees_per_bin: u32,
    /// The smallest dihedral angle.
    pub smallest: Option<Extreme<Place>>,
    /// The largest dihedral angle.
    pub largest: Option<Extreme<Place>>,
    /// The smallest radius-edge ratio, circumradius over shortest edge (Eppstein, Sullivan, Üngör,
    /// Table 1).
    pub lowest_ratio: Option<Extreme<SimplexId>>,
    /// The largest radius-edge ratio.
    pub highest_ratio: Option<Extreme<SimplexId>>,
    /// Least and greatest aspect ratio in doubles, with a simplex that has it: longest edge over
    /// √(2D(D+1)) times the inradius, 1 for the regular simplex (Knupp et al., The Verdict
    /// Library Reference Manual, SAND2007-1751).
    pub aspects: Option<[(f64, SimplexId); 2]>,
}

/// The figures of `tiling`, with angles counted in bins of so many degrees, a divisor of 180.
pub fn statistics<const D: usize>(tiling: &Tiling<D>, degrees_per_bin: u32) -> Statistics {
    match D {
        2 => of_plane(same(tiling), degrees_per_bin),
        _ => of_space(same(tiling), degrees_per_bin),
    }
}

#[inline(never)]
fn of_plane(tiling: &Tiling<2>, degrees_per_bin: u32) -> Statistics {
    of_tiling(tiling, degrees_per_bin)
}

#[inline(never)]
fn of_space(tiling: &Tiling<3>, degrees_per_bin: u32) -> Statistics {
    of_tiling(tiling, degrees_per_bin)
}

fn of_tiling<const D: usize>(tiling: &Tiling<D>, degrees_per_bin: u32) -> Statistics {
    let ring = Ring::new(tiling);
    let gram = &tiling.frame.gram;
    match cleared_integers(gram).filter(|_| tiling.frame.field.degree() == 1) {
        Some(gram) => {
            let edges = |simplex: SimplexId| integer_edges(tiling, &ring, simplex);
            Gathering::over(tiling, gram, edges, degrees_per_bin)
        }
        None => {
            let edges = |simplex: SimplexId| {
                let corners = tiling.simplex(simplex);
                ring.numbers(tiling, corners, &corners[0]).edges
            };
            Gathering::over(tiling, gram.clone(), edges, degrees_per_bin)
        }
    }
}

/// The edges of a simplex times a positive number, which all figures leave alone.
fn integer_edges<const D: usize>(
    tiling: &Tiling<D>,
    ring: &Ring<D>,
    simplex: SimplexId,
) -> [[Integer; D]; D] {
    let corners = tiling.simplex(simplex);
    if let Some(vectors) = ring.integers(corners, &corners[0]) {
        return vectors.edges.map(|edge| edge.map(Integer::from));
    }
    let edges = ring.numbers(tiling, corners, &corners[0]).edges;
    let unit = Number::from(Rational::from(Number::common_denominator(
        edges.iter().flatten(),
    )));
    let integer = |x: &Number| {
        let scaled = x * &unit;
        scaled
            .to_rational()
            .map_or(Integer::ZERO, |value| value.floor())
    };
    edges.each_ref().map(|edge| edge.each_ref().map(integer))
}

/// The figures while they are gathered.
struct Gathering<'t, S, const D: usize> {
    tiling: &'t Tiling<D>,
    metric: Metric<S, D>,
    statistics: Statistics,
    bins: Bins,
    known: BTreeMap<[[S; D]; D], Option<Rc<Figures<S, D>>>>,
    smallest: extreme::Tracker<Cosine<S>, Place>,
    largest: extreme::Tracker<Cosine<S>, Place>,
    lowest: extreme::Tracker<Ratio<S>, SimplexId>,
    highest: extreme::Tracker<Ratio<S>, SimplexId>,
}

/// The Gram matrix, and its adjugate, which measures covectors.
struct Metric<S, const D: usize> {
    gram: [[S; D]; D],
    cogram: [[S; D]; D],
}

/// The figures of one simplex.
struct Figures<S, const D: usize> {
    angles: Vec<AngleFigures<S>>,
    ratio: Ratio<S>,
    aspect: f64,
}

/// The figures of one angle.
struct AngleFigures<S> {
    facets: (usize, usize),
    /// Of the product of their normals.
    sign: Sign,
    cosine: Cosine<S>,
    /// About.
    degrees: f64,
    bin: usize,
}

/// So many different simplices are remembered, since periodic meshes repeat few.
const REMEMBERED: usize = 1 << 12;

impl<'t, S: Scalar + Ord, const D: usize> Gathering<'t, S, D> {
    fn over(
        tiling: &'t Tiling<D>,
        gram: [[S; D]; D],
        edges: impl Fn(SimplexId) -> [[S; D]; D],
        degrees_per_bin: u32,
    ) -> Statistics {
        let mut gathering = Gathering::new(tiling, gram, degrees_per_bin);
        for index in tiling.indices() {
            match gathering.figures(index, edges(index)) {
                Some(figures) => gathering.include(index, &figures),
                None => gathering.statistics.left_out.push(index),
            }
        }
        gathering.finish()
    }

    fn new(tiling: &'t Tiling<D>, gram: [[S; D]; D], degrees_per_bin: u32) -> Self {
        Gathering {
            tiling,
            metric: Metric {
                cogram: linear::cofactors(&gram),
                gram,
            },
            statistics: Statistics {
                simplices: tiling.len(),
                left_out: Vec::new(),
                kinds: [0; 3],
                angles: [0; 3],
                histogram: vec![0; 180usize.div_ceil(degrees_per_bin as usize)],
                degrees_per_bin,
                smallest: None,
                largest: None,
                lowest_ratio: None,
                highest_ratio: None,
                aspects: None,
            },
            bins: Bins::new(degrees_per_bin),
            known: BTreeMap::new(),
            smallest: extreme::Tracker::new(Sign::Less),
            largest: extreme::Tracker::new(Sign::Greater),
            lowest: extreme::Tracker::new(Sign::Less),
            highest: extreme::Tracker::new(Sign::Greater),
        }
    }

    /// The figures of a simplex, none if it is not positively oriented.
    fn figures(&mut self, index: SimplexId, edges: [[S; D]; D]) -> Option<Rc<Figures<S, D>>> {
        if let Some(known) = self.known.get(&edges) {
            return known.clone();
        }
        let figures = self.computed(index, Simplex::from_edges(edges.clone()));
        let figures = figures.map(Rc::new);
        if self.known.len() < REMEMBERED {
            self.known.insert(edges, figures.clone());
        }
        figures
    }

    fn computed(&self, index: SimplexId, simplex: Simplex<S, D>) -> Option<Figures<S, D>> {
        if simplex.determinant.sign() != Sign::Greater {
            return None;
        }
        let products = simplex.normal_products(&self.metric.cogram);
        let angle = |(i, j, product): (usize, usize, &S)| {
            let cosine = Cosine::between(&products, (i, j));
            let degrees = cosine.degrees();
            let place = Place {
                simplex: index,
                facets: (i, j),
            };
            let exact = || exact_angle(self.tiling, &place);
            let bin = self.bins.of(&cosine, degrees, exact);
            AngleFigures {
                facets: (i, j),
                sign: product.sign(),
                cosine,
                degrees,
                bin,
            }
        };
        Some(Figures {
            angles: products.pairs().map(angle).collect(),
            ratio: self.ratio(&simplex, &products)?,
            aspect: self.aspect(&simplex, &products),
        })
    }

    fn ratio(&self, simplex: &Simplex<S, D>, products: &NormalProducts<S, D>) -> Option<Ratio<S>> {
        let gram = &self.metric.gram;
        let (numerator, denominator) = simplex.squared_circumradius(gram, products);
        let mut shortest: Option<S> = None;
        simplex.for_squared_edges(gram, |edge| {
            if shortest.as_ref().is_none_or(|least| edge < least) {
                shortest = Some(edge.clone());
            }
        });
        Some(Ratio {
            numerator,
            denominator: denominator.times(&shortest?),
        })
    }

    fn aspect(&self, simplex: &Simplex<S, D>, products: &NormalProducts<S, D>) -> f64 {
        let gram = &self.metric.gram;
        let mut longest = 0.0;
        simplex.for_squared_edges(gram, |edge| longest = edge.approximate().max(longest));
        // The inradius is D V / (sum of the facets' volumes), with D! V = d √det G and
        // (D - 1)! times the volume of facet i = √<g_i, g_i>.
        let facets = (0..=D).map(|i| products.get(i, i).approximate().sqrt());
        let metric = linear::determinant(gram).approximate().sqrt();
        let inradius = simplex.determinant.approximate() * metric / facets.sum::<f64>();
        f64::sqrt(longest) / ((2 * D * (D + 1)) as f64).sqrt() / inradius
    }

    fn include(&mut self, index: SimplexId, figures: &Figures<S, D>) {
        let mut worst = Sign::Less;
        for angle in &figures.angles {
            worst = worst.max(angle.sign);
            self.statistics.angles[kind(angle.sign)] += 1;
            self.statistics.histogram[angle.bin] += 1;
            let place = Place {
                simplex: index,
                facets: angle.facets,
            };
            self.smallest.include(angle.degrees, &angle.cosine, place);
            self.largest.include(angle.degrees, &angle.cosine, place);
        }
        self.statistics.kinds[kind(worst)] += 1;
        let value = figures.ratio.approximate();
        self.lowest.include(value, &figures.ratio, index);
        self.highest.include(value, &figures.ratio, index);
        self.include_aspect(figures.aspect, index);
    }

    fn include_aspect(&mut self, aspect: f64, index: SimplexId) {
        let [low, high] = self.statistics.aspects.unwrap_or([(aspect, index); 2]);
        let low = if aspect < low.0 { (aspect, index) } else { low };
        let high = if aspect > high.0 {
            (aspect, index)
        } else {
            high
        };
        self.statistics.aspects = Some([low, high]);
    }

    fn finish(self) -> Statistics {
        let angle = |place: &Place| {
            let angle = exact_angle(self.tiling, place);
            (angle.enclosure(&width()), angle.closed_form())
        };
        let ratio = |simplex: &SimplexId| {
            let ratio = measures(self.tiling, *simplex).expect(INCLUDED).radius_edge;
            (ratio.enclosure(&width()), ratio.closed_form())
        };
        Statistics {
            smallest: self.smallest.finish(angle),
            largest: self.largest.finish(angle),
            lowest_ratio: self.lowest.finish(ratio),
            highest_ratio: self.highest.finish(ratio),
            ..self.statistics
        }
    }
}

/// The width of enclosures in reports.
fn width() -> Rational {
    Rational::from_signeds(1, 10_000_000)
}

/// 0 for an acute angle, 1 for a right, 2 for an obtuse one, by the sign of the product of the
/// normals.
fn kind(sign: Sign) -> usize {
    match sign {
        Sign::Less => 0,
        Sign::Equal => 1,
        Sign::Greater => 2,
    }
}

/// A positive quotient of two values of the ring.
#[derive(Clone)]
struct Ratio<S> {
    numerator: S,
    denominator: S,
}

impl<S: Scalar> Ratio<S> {
    /// The square root; NaN beyond the range of doubles.
    fn approximate(&self) -> f64 {
        (self.numerator.approximate() / self.denominator.approximate()).sqrt()
    }
}

impl<S: Scalar> extreme::Compare for Ratio<S> {
    fn compare(&self, other: &Self) -> Sign {
        let left = self.numerator.times(&other.denominator);
        left.minus(&other.numerator.times(&self.denominator)).sign()
    }
}

const INCLUDED: &str = "flat simplices are left out";

/// The angle in the tiling's own numbers.
fn exact_angle<const D: usize>(tiling: &Tiling<D>, place: &Place) -> DihedralAngle {
    let cogram = linear::cofactors(&tiling.frame.gram);
    let products = tiling.shape(place.simplex).normal_products(&cogram);
    DihedralAngle::between(&products, place.facets.0, place.facets.1).expect(INCLUDED)
}
