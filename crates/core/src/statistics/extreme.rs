//! The smallest or largest of many exact values, and who has it.

use acutile_exact::geometry::Sign;
use malachite::Rational;

/// An exact order.
pub trait Compare {
    fn compare(&self, other: &Self) -> Sign;
}

/// An extreme value with those who have it.
#[derive(Clone, Debug)]
pub struct Extreme<P> {
    /// Rational bounds of the value.
    pub bounds: (Rational, Rational),
    /// The value in closed form where there is a short one.
    pub closed_form: Option<String>,
    /// The first few who have exactly this value.
    pub holders: Vec<P>,
    /// How many have it.
    pub count: usize,
}

/// No more than so many holders are named.
const NAMED: usize = 20;

/// Doubles here come from exact values by a few roundings: relative errors of quotients and roots
/// are under 1e-14, and the arc cosine makes at most 1e-5 degrees of that, near 0 and 180. Values
/// farther apart than this part of their size are told apart by doubles.
const MARGIN: f64 = 1e-4;

/// Keeps the extreme value seen so far.
pub struct Tracker<V, P> {
    wanted: Sign,
    best: Option<(f64, V)>,
    holders: Vec<P>,
    count: usize,
}

impl<V: Compare + Clone, P> Tracker<V, P> {
    /// Keeps the smallest (`Less`) or the largest (`Greater`).
    pub fn new(wanted: Sign) -> Self {
        Tracker {
            wanted,
            best: None,
            holders: Vec::new(),
            count: 0,
        }
    }

    /// One more value, with its double, which may be NaN.
    pub fn include(&mut self, double: f64, value: &V, holder: P) {
        let order = match &self.best {
            None => self.wanted,
            Some((best, exact)) => match clear_order(double, *best) {
                Some(order) => order,
                None => value.compare(exact),
            },
        };
        if order == self.wanted {
            self.best = Some((double, value.clone()));
            self.holders.clear();
            self.count = 0;
        }
        if order == self.wanted || order == Sign::Equal {
            self.count += 1;
            if self.holders.len() < NAMED {
                self.holders.push(holder);
            }
        }
    }

    /// The extreme, if there was any value; `describe` gives the bounds and the closed form for
    /// one of its holders.
    pub fn finish(
        self,
        describe: impl Fn(&P) -> ((Rational, Rational), Option<String>),
    ) -> Option<Extreme<P>> {
        let (bounds, closed_form) = describe(self.holders.first()?);
        Some(Extreme {
            bounds,
            closed_form,
            holders: self.holders,
            count: self.count,
        })
    }
}

/// The order of two doubles that are far enough apart.
fn clear_order(a: f64, b: f64) -> Option<Sign> {
    let is_clear = (a - b).abs() > MARGIN * (1.0 + a.abs().max(b.abs()));
    is_clear
        .then(|| a.total_cmp(&b))
        .filter(|_| a.is_finite() && b.is_finite())
}
