//! The counts: simplices and angles that are acute, right or obtuse, and bins of angles.

use super::bins::Bins;
use super::extreme::pairs;
use crate::predicates::{Model, Prepared, Products, Shape, Signs};
use crate::tiling::SimplexId;
use acutile_exact::geometry::{Sign, Simplex, linear};
use acutile_exact::number::Number;
use std::cell::OnceCell;
use std::ops::Range;

/// The counts. See [`super::Statistics`].
pub(super) struct Counts {
    pub left_out: Vec<SimplexId>,
    pub kinds: [usize; 3],
    pub angles: [usize; 3],
    pub histogram: Vec<usize>,
    pub aspects: Option<[(f64, SimplexId); 2]>,
}

/// The counts of all simplices, on all cores.
pub(super) fn counts<const D: usize>(model: &Model<D>, degrees_per_bin: u32) -> Counts {
    let bins = Bins::new(model, degrees_per_bin);
    let counting = Counting {
        model,
        products: model.prepare(Products),
        shape: model.prepare(Shape),
        bins: &bins,
    };
    let none = Counts::none(bins.len());
    let chunks = model.by_chunks(|simplices| counting.of(simplices));
    chunks.into_iter().fold(none, Counts::and)
}

struct Counting<'m, 't, const D: usize> {
    model: &'m Model<'t, D>,
    products: Prepared<'m, Products, D>,
    shape: Prepared<'m, Shape, D>,
    bins: &'m Bins<'m, 't, D>,
}

/// The number of values of [`Products`] in space.
const VALUES: usize = 11;

/// Beyond this relative error of the volume, the aspect ratio is computed from exact numbers.
const ASPECT: f64 = 1e-9;

impl<const D: usize> Counting<'_, '_, D> {
    fn of(&self, simplices: Range<usize>) -> Counts {
        let mut counts = Counts::none(self.bins.len());
        for simplex in simplices.map(SimplexId::at) {
            self.add(simplex, &mut counts);
        }
        counts
    }

    fn add(&self, simplex: SimplexId, counts: &mut Counts) {
        let mut values = [0.0; VALUES];
        let mut next = values.iter_mut();
        let errors = self.products.bounded(simplex, |value| {
            if let Some(place) = next.next() {
                *place = value;
            }
        });
        // Of infinite error nothing is known.
        let [volume_error, error] = errors.unwrap_or([f64::INFINITY; 2]);
        let exact = OnceCell::new();
        let signs = || exact.get_or_init(|| self.shape.signs(simplex).split_first());
        let (determinant, squares, products) = (values[0], &values[1..D + 2], &values[D + 2..]);
        let is_positive = if determinant.abs() > volume_error {
            determinant > 0.0
        } else {
            signs().0.all_positive()
        };
        if !is_positive {
            counts.left_out.push(simplex);
            return;
        }
        let mut worst = Sign::Less;
        for (index, (i, j)) in pairs::<D>().enumerate() {
            let product = products[index];
            let sign = sign(product, error, index, || &signs().1);
            let bins = self
                .bins
                .of_products(product, [squares[i], squares[j]], error);
            let bin = if bins.start() == bins.end() {
                *bins.start()
            } else {
                self.bins.decide(simplex, (index, (i, j)), bins)
            };
            worst = worst.max(sign);
            counts.angles[kind(sign)] += 1;
            counts.histogram[bin] += 1;
        }
        counts.kinds[kind(worst)] += 1;
        let is_close = volume_error <= ASPECT * determinant;
        let aspect = if is_close {
            aspect(
                self.model.float_edges(simplex),
                self.products.float_gram(),
                determinant,
                squares,
            )
        } else {
            self.exact_aspect(simplex)
        };
        counts.add_aspects([(aspect, simplex); 2]);
    }

    /// From exact numbers, each rounded once.
    #[cold]
    fn exact_aspect(&self, simplex: SimplexId) -> f64 {
        let tiling = self.model.tiling;
        let gram = &tiling.frame.gram;
        let shape = tiling.shape(simplex);
        let products = shape.normal_products(&linear::cofactors(gram));
        let squares: Vec<f64> = (0..=D).map(|i| products.get(i, i).approximate()).collect();
        let double = |rows: &[[Number; D]; D]| {
            rows.each_ref()
                .map(|row| row.each_ref().map(Number::approximate))
        };
        aspect(
            double(&shape.edges),
            &double(gram),
            shape.determinant.approximate(),
            &squares,
        )
    }
}

/// The sign of a product in doubles with this error, else the exact one.
#[inline(always)]
fn sign<'s>(product: f64, error: f64, index: usize, exact: impl Fn() -> &'s Signs) -> Sign {
    if product > error {
        Sign::Greater
    } else if product < -error {
        Sign::Less
    } else if error == 0.0 {
        Sign::Equal
    } else {
        exact().get(index)
    }
}

/// The aspect ratio. The inradius is D V / (sum of the facets' volumes), with D! V = d √det G and
/// (D - 1)! times the volume of facet i = √<g_i, g_i>.
fn aspect<const D: usize>(
    edges: [[f64; D]; D],
    gram: &[[f64; D]; D],
    determinant: f64,
    squares: &[f64],
) -> f64 {
    let mut longest: f64 = 0.0;
    Simplex::from_edges(edges).for_squared_edges(gram, |edge| longest = longest.max(*edge));
    let facets: f64 = squares.iter().map(|square| square.sqrt()).sum();
    let inradius = determinant * linear::determinant(gram).sqrt() / facets;
    longest.sqrt() / ((2 * D * (D + 1)) as f64).sqrt() / inradius
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

impl Counts {
    fn none(bins: usize) -> Self {
        Counts {
            left_out: Vec::new(),
            kinds: [0; 3],
            angles: [0; 3],
            histogram: vec![0; bins],
            aspects: None,
        }
    }

    /// The sum of both, simplices of the first one first.
    fn and(mut self, other: Counts) -> Self {
        let add = |to: &mut [usize], from: &[usize]| {
            for (to, from) in to.iter_mut().zip(from) {
                *to += from;
            }
        };
        add(&mut self.kinds, &other.kinds);
        add(&mut self.angles, &other.angles);
        add(&mut self.histogram, &other.histogram);
        self.left_out.extend(other.left_out);
        if let Some(aspects) = other.aspects {
            self.add_aspects(aspects);
        }
        self
    }

    fn add_aspects(&mut self, [less, more]: [(f64, SimplexId); 2]) {
        let [low, high] = self.aspects.unwrap_or([less, more]);
        self.aspects = Some([
            if less.0 < low.0 { less } else { low },
            if more.0 > high.0 { more } else { high },
        ]);
    }
}
