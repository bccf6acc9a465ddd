//! Quality of a mesh: how its dihedral angles are distributed, the extreme ones and who has them,
//! radius-edge ratios, aspect ratios.
//!
//! Counts and extremes are exact: a double computed from exact values decides only where it is
//! far from every other candidate, and exact arithmetic decides the rest. Aspect ratios are
//! doubles and are called so. Nothing is proved about the tiling as a whole.

mod chart;
mod cosine;
mod extreme;

pub use chart::{csv, svg, text};
pub use extreme::Extreme;

use crate::checker::Model;
use crate::geometry::{NormalProducts, Scalar, Sign, Simplex, linear};
use crate::quality::{DihedralAngle, Exact, measures};
use crate::tiling::Tiling;
use cosine::{Bins, Cosine};
use malachite::Rational;

/// A dihedral angle of a tiling: the simplex and the two facets, each named by the corner
/// opposite to it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    pub simplex: usize,
    pub facets: (usize, usize),
}

/// The figures of a tiling.
#[derive(Clone, Debug)]
pub struct Statistics {
    /// Simplices, with those left out.
    pub simplices: usize,
    /// Flat or negatively oriented simplices; they are left out of everything else.
    pub left_out: Vec<usize>,
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
    pub lowest_ratio: Option<Extreme<usize>>,
    /// The largest radius-edge ratio.
    pub highest_ratio: Option<Extreme<usize>>,
    /// Least and greatest aspect ratio in doubles, with a simplex that has it: longest edge over
    /// √(2D(D+1)) times the inradius, 1 for the regular simplex (Knupp et al., The Verdict
    /// Library Reference Manual, SAND2007-1751).
    pub aspects: Option<[(f64, usize); 2]>,
}

/// The figures of `tiling`, with angles counted in bins of so many degrees, a divisor of 180.
pub fn statistics<const D: usize>(tiling: &Tiling<D>, degrees_per_bin: u32) -> Statistics {
    if tiling.frame.field.degree() == 1 {
        Gathering::over(&Model::rational(tiling), degrees_per_bin)
    } else {
        Gathering::over(&Model::algebraic(tiling), degrees_per_bin)
    }
}

/// The figures while they are gathered.
struct Gathering<S> {
    statistics: Statistics,
    bins: Bins,
    smallest: extreme::Tracker<Cosine<S>, Place>,
    largest: extreme::Tracker<Cosine<S>, Place>,
    lowest: extreme::Tracker<Ratio<S>, usize>,
    highest: extreme::Tracker<Ratio<S>, usize>,
}

impl<S: Scalar> Gathering<S> {
    fn over<const D: usize>(model: &Model<S, D>, degrees_per_bin: u32) -> Statistics {
        let mut gathering = Gathering::new(model.tiling.len(), degrees_per_bin);
        for index in 0..model.tiling.len() {
            let simplex = model.simplex(index);
            match simplex.determinant.sign() {
                Sign::Greater => gathering.include(model, index, &simplex),
                _ => gathering.statistics.left_out.push(index),
            }
        }
        gathering.finish(model)
    }

    fn new(simplices: usize, degrees_per_bin: u32) -> Self {
        Gathering {
            statistics: Statistics {
                simplices,
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
            smallest: extreme::Tracker::new(Sign::Less),
            largest: extreme::Tracker::new(Sign::Greater),
            lowest: extreme::Tracker::new(Sign::Less),
            highest: extreme::Tracker::new(Sign::Greater),
        }
    }

    fn include<const D: usize>(
        &mut self,
        model: &Model<S, D>,
        index: usize,
        simplex: &Simplex<S, D>,
    ) {
        let products = simplex.normal_products(&model.cogram);
        let mut worst = Sign::Less;
        for (i, j, product) in products.pairs() {
            let sign = product.sign();
            worst = worst.max(sign);
            self.statistics.angles[kind(sign)] += 1;
            let place = Place {
                simplex: index,
                facets: (i, j),
            };
            self.include_angle(model.tiling, &products, place);
        }
        self.statistics.kinds[kind(worst)] += 1;
        self.include_ratio(model, index, simplex, &products);
        self.include_aspect(model, index, simplex, &products);
    }

    fn include_angle<const D: usize>(
        &mut self,
        tiling: &Tiling<D>,
        products: &NormalProducts<S>,
        place: Place,
    ) {
        let cosine = Cosine::between(products, place.facets);
        let degrees = cosine.degrees();
        let bin = self
            .bins
            .of(&cosine, degrees, || exact_angle(tiling, &place));
        self.statistics.histogram[bin] += 1;
        self.smallest.include(degrees, &cosine, place);
        self.largest.include(degrees, &cosine, place);
    }

    fn include_ratio<const D: usize>(
        &mut self,
        model: &Model<S, D>,
        index: usize,
        simplex: &Simplex<S, D>,
        products: &NormalProducts<S>,
    ) {
        let (numerator, denominator) = simplex.squared_circumradius(&model.gram, products);
        let edges = simplex.squared_edges(&model.gram).into_iter();
        let shortest = edges.reduce(|a, b| match a.minus(&b).sign() {
            Sign::Greater => b,
            _ => a,
        });
        let Some(shortest) = shortest else { return };
        let ratio = Ratio {
            numerator,
            denominator: denominator.times(&shortest),
        };
        let value = ratio.approximate();
        self.lowest.include(value, &ratio, index);
        self.highest.include(value, &ratio, index);
    }

    fn include_aspect<const D: usize>(
        &mut self,
        model: &Model<S, D>,
        index: usize,
        simplex: &Simplex<S, D>,
        products: &NormalProducts<S>,
    ) {
        let edges = simplex.squared_edges(&model.gram).into_iter();
        let longest = edges.map(|e| e.approximate()).fold(0.0, f64::max).sqrt();
        let metric = linear::determinant(&model.gram).approximate().sqrt();
        // The inradius is D V / (sum of the facets' volumes), with D! V = d √det G and
        // (D - 1)! times the volume of facet i = √<g_i, g_i>.
        let facets: f64 = (0..=D)
            .map(|i| products.get(i, i).approximate().sqrt())
            .sum();
        let inradius = simplex.determinant.approximate() * metric / facets;
        let aspect = longest / ((2 * D * (D + 1)) as f64).sqrt() / inradius;
        let [low, high] = self.statistics.aspects.unwrap_or([(aspect, index); 2]);
        let low = if aspect < low.0 { (aspect, index) } else { low };
        let high = if aspect > high.0 {
            (aspect, index)
        } else {
            high
        };
        self.statistics.aspects = Some([low, high]);
    }

    fn finish<const D: usize>(self, model: &Model<S, D>) -> Statistics {
        let angle = |place: &Place| {
            let angle = exact_angle(model.tiling, place);
            (angle.enclosure(&width()), angle.closed_form())
        };
        let ratio = |simplex: &usize| {
            let ratio = measures(model.tiling, *simplex).radius_edge;
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

/// The angle in the tiling's own numbers.
fn exact_angle<const D: usize>(tiling: &Tiling<D>, place: &Place) -> DihedralAngle {
    let cogram = linear::cofactors(&tiling.frame.gram);
    let products = tiling.shape(place.simplex).normal_products(&cogram);
    DihedralAngle::between(&products, place.facets.0, place.facets.1)
}
