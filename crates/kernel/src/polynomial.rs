//! Polynomials over Z[a] in the parameters of a family, with signs that hold on a whole box.
//!
//! The box is mapped to [0, 1]^m. There a polynomial is a combination of products of Bernstein
//! polynomials, which are not negative on [0, 1] and positive inside. So the signs of its
//! coefficients bound its sign (docs/soundness.md, section 11).

use crate::claim::Polynomial;
use crate::family::{End, Parameter};
use crate::limits::Work;
use crate::refusal::{Checked, Place, Stop};
use crate::ring::{Element, Exact, Ring, Sign};
use num_bigint::BigInt;
use std::cmp::Ordering::{self, Equal, Greater, Less};
use std::collections::BTreeMap;
use std::rc::Rc;

type Large<const N: usize> = Exact<BigInt, N>;
type Number<const N: usize> = Element<BigInt, N>;

/// The terms by their exponents. The empty list of exponents stands for zeros.
#[derive(Clone, Default)]
pub(crate) struct Terms<const N: usize>(BTreeMap<Vec<u32>, Number<N>>);

/// The interval of a parameter: its ends, over a unit.
#[derive(Clone)]
pub(crate) struct Side<const N: usize> {
    pub(crate) ends: [Number<N>; 2],
    pub(crate) unit: BigInt,
    /// Whether the ends belong to the box.
    pub(crate) closed: [bool; 2],
}

impl<const N: usize> Side<N> {
    pub(crate) fn new(parameter: &Parameter, ring: &Large<N>) -> Checked<Self> {
        let Parameter { low, high, .. } = parameter;
        let end = |end: &End, factor: &BigInt| ring.times(&ring.element(&end.numerator)?, &ring.long(factor)?);
        let ends = [end(low, &high.denominator)?, end(high, &low.denominator)?];
        Ok(Side { ends, unit: &low.denominator * &high.denominator, closed: [low.is_closed, high.is_closed] })
    }

    /// The lower and the upper half. The middle belongs to both.
    pub(crate) fn halves(&self, ring: &Large<N>) -> Checked<[Side<N>; 2]> {
        let ([low, high], [is_low_closed, is_high_closed]) = (&self.ends, self.closed);
        let [low, middle, high] = [ring.plus(low, low)?, ring.plus(low, high)?, ring.plus(high, high)?];
        let half = |ends, closed| Side { ends, unit: &self.unit * 2, closed };
        Ok([half([low, middle.clone()], [is_low_closed, true]), half([middle, high], [true, is_high_closed])])
    }

    /// The middle, and then the ends that belong to the box, as intervals without length.
    pub(crate) fn points(&self, ring: &Large<N>) -> Checked<Vec<Side<N>>> {
        let [low, high] = &self.ends;
        let middle = (ring.plus(low, high)?, &self.unit * 2);
        let closed = self.ends.iter().zip(self.closed).filter(|(_, is_closed)| *is_closed);
        let points = [middle].into_iter().chain(closed.map(|(end, _)| (end.clone(), self.unit.clone())));
        Ok(points.map(|(end, unit)| Side { ends: [end.clone(), end], unit, closed: [true; 2] }).collect())
    }
}

/// The polynomials on one box.
#[derive(Clone)]
pub(crate) struct Polynomials<const N: usize> {
    pub(crate) numbers: Large<N>,
    sides: Rc<Vec<Side<N>>>,
    /// For each parameter u^(d-e) (l + (h - l) t)^e for all exponents e up to the greatest one d,
    /// where u, l, h are unit, low and high: the power of the parameter, times u^d.
    powers: Rc<Vec<Vec<Terms<N>>>>,
    /// The product of all u^d.
    pub(crate) scale: BigInt,
}

/// The degrees, and the sign of each coefficient with its number on each axis.
type Signs = (Vec<u32>, Vec<(Vec<u32>, Ordering)>);

/// The greatest number of terms, and of Bernstein coefficients.
const MOST: usize = 1 << 18;

impl<const N: usize> Polynomials<N> {
    /// `degrees` are the greatest exponents of the parameters.
    pub(crate) fn new(numbers: &Large<N>, sides: &[Side<N>], degrees: &[u32]) -> Checked<Self> {
        let (numbers, sides) = (numbers.clone(), Rc::new(sides.to_vec()));
        let mut ring = Polynomials { numbers, sides: sides.clone(), powers: Rc::default(), scale: 1.into() };
        let mut powers = Vec::new();
        for (axis, (side, &degree)) in sides.iter().zip(degrees).enumerate() {
            let unit = |e| ring.element(&[side.unit.pow(e)]);
            let mut exponents = vec![0; axis];
            exponents.push(1);
            let [low, high] = &side.ends;
            let width = ring.numbers.minus(high, low)?;
            let linear = Terms([(Vec::new(), low.clone()), (exponents, width)].into());
            let (mut power, mut list) = (unit(0)?, Vec::new());
            for e in 0..=degree {
                list.push(ring.times(&power, &unit(degree - e)?)?);
                power = ring.times(&power, &linear)?;
            }
            powers.push(list);
            ring.scale *= side.unit.pow(degree);
        }
        ring.powers = Rc::new(powers);
        Ok(ring)
    }

    /// The work for this many terms or coefficients.
    fn charge(&self, count: usize) -> Checked {
        let units = if count > MOST { u64::MAX } else { 400 * u64::try_from(count).unwrap_or(u64::MAX) };
        self.work().add(units);
        self.work().check(Place::Witness)
    }

    /// The signs of the Bernstein coefficients. Nothing if there are too many, or if one is undecided.
    fn signs(&self, x: &Terms<N>) -> Option<Signs> {
        let axes = x.0.keys().map(Vec::len).max().unwrap_or(0);
        let exponent = |exponents: &Vec<u32>, axis: usize| exponents.get(axis).copied().unwrap_or(0);
        let degree = |axis| x.0.keys().map(|exponents| exponent(exponents, axis)).max().unwrap_or(0);
        let degrees: Vec<u32> = (0..axes).map(degree).collect();
        let mut indices = vec![Vec::new()];
        for &degree in &degrees {
            let count = indices.len().checked_mul(usize::try_from(degree).ok()? + 1)?;
            self.charge(count).ok()?;
            indices = indices.iter().flat_map(|index| (0..=degree).map(|e| [&index[..], &[e]].concat())).collect();
        }
        let mut padded = BTreeMap::new();
        for (exponents, c) in &x.0 {
            let mut exponents = exponents.clone();
            exponents.resize(axes, 0);
            padded.insert(exponents, c);
        }
        let dense = indices.iter().map(|index| padded.get(index).map_or_else(Number::default, |c| (*c).clone()));
        let mut table: Vec<Number<N>> = dense.collect();
        // From the last axis to the first one: each is the last one in its turn.
        for &degree in degrees.iter().rev() {
            table = self.bernstein(table, degree).ok()?;
        }
        let signs = table.iter().map(|c| self.numbers.sign(c).decided());
        Some((degrees, indices.into_iter().zip(signs.collect::<Checked<Vec<_>>>().ok()?).collect()))
    }

    /// Changes the basis along the last axis, which becomes the first one.
    ///
    /// The coefficients c_j of the powers give those of the Bernstein basis, n! times too large:
    /// Σ_j binomial(i, j) j! (n-j)! c_j. The sums are those of Pascal's triangle.
    fn bernstein(&self, table: Vec<Number<N>>, degree: u32) -> Checked<Vec<Number<N>>> {
        let factorial = |n: u32| (1..=n).map(BigInt::from).product::<BigInt>();
        let factors = (0..=degree).map(|j| self.numbers.element(&[factorial(j) * factorial(degree - j)]));
        let factors = factors.collect::<Checked<Vec<_>>>()?;
        let mut lines = Vec::new();
        for line in table.chunks(factors.len()) {
            let line = line.iter().zip(&factors).map(|(c, factor)| self.numbers.times(c, factor));
            let mut line = line.collect::<Checked<Vec<_>>>()?;
            let mut done = Vec::new();
            while let Some(first) = line.first().cloned() {
                done.push(first);
                let sums = line.iter().zip(line.iter().skip(1)).map(|(x, y)| self.numbers.plus(x, y));
                line = sums.collect::<Checked<Vec<_>>>()?;
            }
            self.work().add(u64::from(degree) * u64::from(degree) * 50);
            lines.push(done);
        }
        let columns = (0..factors.len()).map(|i| lines.iter().filter_map(move |line| line.get(i)).cloned());
        Ok(columns.flatten().collect())
    }

    /// Whether each of the smallest faces of [0, 1]^m that the box contains has an index: with a
    /// closed end on each axis that has one.
    fn is_everywhere(&self, indices: &[&Vec<u32>], axis: usize, degrees: &[u32]) -> bool {
        self.work().add(2 * u64::try_from(indices.len()).unwrap_or(u64::from(u32::MAX)));
        let (Some(side), Some(&degree)) = (self.sides.get(axis), degrees.get(axis)) else {
            return !indices.is_empty();
        };
        let [is_low_closed, is_high_closed] = side.closed;
        let ends = [(is_low_closed, 0), (is_high_closed && degree > 0, degree)];
        let mut closed = ends.into_iter().filter(|(is_closed, _)| *is_closed).peekable();
        if degree == 0 || closed.peek().is_none() {
            return self.is_everywhere(indices, axis + 1, degrees);
        }
        closed.all(|(_, end)| {
            let face: Vec<&Vec<u32>> = indices.iter().copied().filter(|index| index.get(axis) == Some(&end)).collect();
            !face.is_empty() && self.is_everywhere(&face, axis + 1, degrees)
        })
    }
}

impl<const N: usize> Ring for Polynomials<N> {
    type Element = Terms<N>;

    fn element(&self, coefficients: &[BigInt]) -> Checked<Terms<N>> {
        Ok(Terms([(Vec::new(), self.numbers.element(coefficients)?)].into()))
    }

    /// The polynomial on the box, times the scale.
    fn polynomial(&self, terms: &Polynomial) -> Checked<Terms<N>> {
        let mut sum = Terms::default();
        for (number, exponents) in terms {
            let mut product = self.element(number)?;
            for (powers, &exponent) in self.powers.iter().zip(exponents) {
                let power = usize::try_from(exponent).ok().and_then(|e| powers.get(e));
                product = self.times(&product, power.ok_or(Stop::LARGER)?)?;
            }
            sum = self.plus(&sum, &product)?;
        }
        Ok(sum)
    }

    /// Those of the constant term: all, where the box is a point.
    fn coefficients(&self, x: &Terms<N>) -> Vec<BigInt> {
        let constant = x.0.get(&Vec::new()).cloned().unwrap_or_default();
        self.numbers.coefficients(&constant)
    }

    fn plus(&self, x: &Terms<N>, y: &Terms<N>) -> Checked<Terms<N>> {
        let mut sum = x.clone();
        for (exponents, c) in &y.0 {
            let entry = sum.0.entry(exponents.clone()).or_default();
            *entry = self.numbers.plus(entry, c)?;
        }
        self.charge(sum.0.len())?;
        sum.0.retain(|_, c| *c != Number::default());
        Ok(sum)
    }

    fn minus(&self, x: &Terms<N>, y: &Terms<N>) -> Checked<Terms<N>> {
        self.plus(x, &self.times(y, &self.element(&[(-1).into()])?)?)
    }

    fn dot<const K: usize>(&self, x: [&Terms<N>; K], y: [&Terms<N>; K]) -> Checked<Terms<N>> {
        let mut sum = Terms::default();
        for (x, y) in x.into_iter().zip(y) {
            for (first, c) in &x.0 {
                self.charge(y.0.len())?;
                if sum.0.len() > MOST {
                    self.charge(sum.0.len())?;
                }
                for (second, d) in &y.0 {
                    let (mut long, short) =
                        if first.len() < second.len() { (second.clone(), first) } else { (first.clone(), second) };
                    long.iter_mut().zip(short).for_each(|(e, f)| *e += f);
                    let entry: &mut Number<N> = sum.0.entry(long).or_default();
                    *entry = self.numbers.plus(entry, &self.numbers.times(c, d)?)?;
                }
            }
        }
        sum.0.retain(|_, c| *c != Number::default());
        Ok(sum)
    }

    fn sign(&self, x: &Terms<N>) -> Sign {
        let Some((degrees, signs)) = self.signs(x) else { return Sign::UNDECIDED };
        let least = signs.iter().map(|(_, sign)| *sign).min().unwrap_or(Equal);
        let most = signs.iter().map(|(_, sign)| *sign).max().unwrap_or(Equal);
        let nonzero: Vec<&Vec<u32>> = signs.iter().filter(|(_, sign)| *sign != Equal).map(|(index, _)| index).collect();
        match (least, most) {
            (Less, Greater) | (Equal, Equal) => Sign { least, most },
            _ if self.is_everywhere(&nonzero, 0, &degrees) => {
                Sign::exactly(if most == Greater { Greater } else { Less })
            }
            _ => Sign { least: least.min(Equal), most: most.max(Equal) },
        }
    }

    fn varies(&self) -> bool {
        self.sides.iter().any(|side| side.ends[0] != side.ends[1])
    }

    fn work(&self) -> &Work {
        self.numbers.work()
    }

    fn price(&self) -> u64 {
        0
    }
}
