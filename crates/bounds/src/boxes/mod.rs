//! Inequalities for all triangles with three angles in a box, by bisection.
//!
//! The angles are a0 + e_1, a0 + e_2, a0 + e_3 with 0 <= e_i <= kappa. A triangle is *feasible* if the
//! sum of their cosines is at most m, as Lemma 2 asks of a tetrahedron. A [`Target`] claims that
//!
//! f = Σ w_i x_i + Σ r_i e_i + k > 0 for every feasible triangle.
//!
//! Let L = f - ν (180/π) (m - Σ cos) with ν >= 0. Where L > 0, f > 0 or the triangle is not feasible. By
//! the mean value theorem L is at least the following sum in a box. Its first term is the value at the
//! lower corner. The others are the widths times the negative parts of lower bounds of the partial
//! derivatives. A box is decided when this is positive, for the given ν or for ν = 0, or when the sum of
//! cosines exceeds m at the upper corner. Else it is cut in half. Section 14 of docs/lower-bound.md has the
//! formulas; `triangle` evaluates them.

mod triangle;

use super::check::{Check, Verdict};
use acutile_core::quality::rounded_down;
use acutile_exact::number::Interval;
use malachite::Rational;
use triangle::{Angles, Constants, Corner, Operations, slopes};

/// The part of the proof.
pub const PART: &str = "boxes-73.44";
/// No target takes more boxes.
const LIMIT: usize = 20_000;

/// The lower and the upper end of each e_i.
type Box3 = [[Rational; 2]; 3];

/// The angle theta, and how much a t pays for its two triangles, per degree.
pub struct Setting {
    /// Degrees.
    pub theta: Rational,
    /// λ of docs/lower-bound.md: the payment per degree.
    pub lambda: Rational,
}

/// An inequality for all feasible triangles.
pub struct Target {
    /// A stable name.
    pub id: &'static str,
    statement: String,
    constants: Constants,
    function: Function,
}

/// f and L.
struct Function {
    /// The factors of the x_i; none is negative.
    weights: [Rational; 3],
    /// The factors of the e_i.
    rates: [Interval; 3],
    constant: Rational,
    /// ν
    multiplier: Rational,
}

/// The result for one box.
enum Decision {
    Infeasible,
    Positive,
    /// f is not positive at a feasible corner.
    Refuted,
    Open,
}

fn q(numerator: i64, denominator: i64) -> Rational {
    Rational::from_signeds(numerator, denominator)
}

impl Setting {
    /// The values for which all four targets are proved.
    pub fn proved() -> Setting {
        Setting {
            theta: q(7344, 100),
            lambda: q(337, 400),
        }
    }

    /// The four inequalities of section 14.
    ///
    /// # Errors
    /// A constant that has no enclosure.
    pub fn targets(&self) -> Result<Vec<Target>, String> {
        let constants = Constants::at(&self.theta)?;
        let zero = || q(0, 1);
        let lambda_kappa = &self.lambda * &constants.kappa;
        let minus_k = constants.k.negated();
        let of_t = constants.c.plus(&self.lambda).negated();
        let exact = |x: Rational| Interval {
            lo: x.clone(),
            hi: x,
        };
        let none = || exact(zero());
        let for_t = || exact(-&self.lambda);
        let target = |id, statement: &str, function| Target {
            id,
            statement: format!(
                "{statement} > 0 for all feasible triangles at {} degrees, lambda = {}",
                self.theta, self.lambda
            ),
            constants: constants.clone(),
            function,
        };
        Ok(vec![
            target(
                "x-above-60",
                "x1 - 60",
                Function {
                    weights: [q(1, 1), zero(), zero()],
                    rates: [none(), none(), none()],
                    constant: q(-60, 1),
                    multiplier: q(1, 2),
                },
            ),
            target(
                "uuu",
                "2*(x1 + x2 + x3) - K*(e1 + e2 + e3) - 360",
                Function {
                    weights: [q(2, 1), q(2, 1), q(2, 1)],
                    rates: [minus_k.clone(), minus_k.clone(), minus_k.clone()],
                    constant: q(-360, 1),
                    multiplier: q(12, 5),
                },
            ),
            target(
                "utt",
                "3/2*(x2 + x3) - K*e1 - (C + lambda)*(e2 + e3) + lambda*kappa - 180",
                Function {
                    weights: [zero(), q(3, 2), q(3, 2)],
                    rates: [minus_k, of_t.clone(), of_t],
                    constant: &lambda_kappa - q(180, 1),
                    multiplier: zero(),
                },
            ),
            target(
                "tt",
                "x1 - lambda*(e2 + e3) + lambda*kappa - 60",
                Function {
                    weights: [q(1, 1), zero(), zero()],
                    rates: [none(), for_t(), for_t()],
                    constant: lambda_kappa - q(60, 1),
                    multiplier: zero(),
                },
            ),
        ])
    }

    /// The checks of the four inequalities. `step` is called before each.
    pub fn checks(&self, step: &dyn Fn(&str)) -> Vec<Check> {
        let decided = self.targets().map(|targets| {
            let targets = targets.iter();
            targets
                .map(|target| {
                    step(&format!("{PART}/{}", target.id));
                    target.check()
                })
                .collect()
        });
        decided.unwrap_or_else(|reason| {
            vec![Check {
                part: PART,
                id: "constants",
                place: "section 14",
                statement: "the constants at theta have enclosures".to_owned(),
                verdict: Verdict::Undecided,
                found: reason,
            }]
        })
    }
}

impl Target {
    /// Decides the inequality.
    pub fn check(&self) -> Check {
        let (verdict, found) = match self.bisect() {
            Ok(found) => found,
            Err(reason) => (Verdict::Undecided, reason),
        };
        Check {
            part: PART,
            id: self.id,
            place: "section 14",
            statement: self.statement.clone(),
            verdict,
            found,
        }
    }

    /// f at a triangle with angles a0 + e_i, and m minus its sum of cosines, which is negative
    /// where the triangle is not feasible.
    ///
    /// # Errors
    /// An angle out of range.
    pub fn at(&self, excess: &[Rational; 3]) -> Result<(Interval, Interval), String> {
        let corner = Corner::at(excess, &self.constants, &mut Angles::default())?;
        let value = self.function.value(&corner, &self.constants)?;
        Ok((value, self.constants.most.minus(&corner.sum_of_cosines())))
    }

    fn bisect(&self) -> Result<(Verdict, String), String> {
        let side = || [q(0, 1), self.constants.kappa.clone()];
        let mut waiting: Vec<Box3> = vec![[side(), side(), side()]];
        let mut angles = Angles::default();
        let (mut positive, mut infeasible, mut seen) = (0, 0, 0);
        while let Some(cell) = waiting.pop() {
            seen += 1;
            match self.decide(&cell, &mut angles)? {
                Decision::Infeasible => infeasible += 1,
                Decision::Positive => positive += 1,
                Decision::Refuted => {
                    let found = format!("it fails at a corner of the box at e = {}", shown(&cell));
                    return Ok((Verdict::Fails, found));
                }
                Decision::Open if seen >= LIMIT => {
                    let found = format!(
                        "{LIMIT} boxes do not decide it; one is at e = {}",
                        shown(&cell)
                    );
                    return Ok((Verdict::Undecided, found));
                }
                Decision::Open => waiting.extend(halves(cell)),
            }
        }
        let found = format!(
            "bisection with rational enclosures: {positive} boxes positive, {infeasible} infeasible"
        );
        Ok((Verdict::Holds, found))
    }

    fn decide(&self, cell: &Box3, angles: &mut Angles) -> Result<Decision, String> {
        let constants = &self.constants;
        let [low, high] = [0, 1].map(|end| cell.each_ref().map(|side| side[end].clone()));
        let high = Corner::at(&high, constants, angles)?;
        if high.sum_of_cosines().lo > constants.most.hi {
            return Ok(Decision::Infeasible);
        }
        let low = Corner::at(&low, constants, angles)?;
        let slopes = slopes(&low, &high, constants)?;
        let slopes = [0, 1, 2].map(|v| self.function.slope(v, &slopes));
        if self.lower_bound(cell, &low, &high, &slopes)? > 0 {
            return Ok(Decision::Positive);
        }
        // The corner where f may be least.
        let worst = [0, 1, 2].map(|v| cell[v][usize::from(slopes[v] < 0)].clone());
        let worst = Corner::at(&worst, constants, angles)?;
        Ok(if self.is_refuted(&worst)? || self.is_refuted(&high)? {
            Decision::Refuted
        } else {
            Decision::Open
        })
    }

    /// The larger one of two lower bounds, of L and of f, on a box. Where f or L is positive, a
    /// triangle is as claimed. `slopes` are lower bounds of the derivatives of f.
    fn lower_bound(
        &self,
        cell: &Box3,
        low: &Corner,
        high: &Corner,
        slopes: &[Rational; 3],
    ) -> Result<Rational, String> {
        let (constants, function) = (&self.constants, &self.function);
        let value = function.value(low, constants)?;
        let spare = constants.most.minus(&low.sum_of_cosines());
        let spare = spare.by(&constants.radian);
        let bound = |multiplier: &Rational| {
            let start = value.minus(&spare.scaled(multiplier)).lo;
            (0..3).fold(start, |bound, v| {
                let slope = &slopes[v] - multiplier * &high.sin[v].hi;
                let [from, to] = &cell[v];
                bound + slope.min(q(0, 1)) * (to - from)
            })
        };
        Ok(bound(&function.multiplier).max(bound(&q(0, 1))))
    }

    /// Whether a triangle is certainly feasible and f is certainly not positive there.
    fn is_refuted(&self, corner: &Corner) -> Result<bool, String> {
        let sum = corner.sum_of_cosines();
        let is_feasible = sum.hi <= self.constants.most.lo;
        Ok(is_feasible && self.function.value(corner, &self.constants)?.hi <= 0)
    }
}

impl Function {
    /// f at a corner.
    fn value(&self, corner: &Corner, constants: &Constants) -> Result<Interval, String> {
        let mut value = Interval {
            lo: self.constant.clone(),
            hi: self.constant.clone(),
        };
        for i in 0..3 {
            if self.weights[i] != 0 {
                value = value.and(&corner.x(i, constants)?.scaled(&self.weights[i]));
            }
            value = value.and(&self.rates[i].scaled(&corner.excess[i]));
        }
        Ok(value)
    }

    /// A lower bound of the derivative of f by e_v on the box; `slopes[i][v]` is one of x_i by e_v.
    fn slope(&self, v: usize, slopes: &[[Rational; 3]; 3]) -> Rational {
        let of_x = (0..3).map(|i| &self.weights[i] * &slopes[i][v]);
        of_x.fold(self.rates[v].lo.clone(), |sum, slope| sum + slope)
    }
}

/// The halves of a box, cut across its first longest side.
fn halves(cell: Box3) -> [Box3; 2] {
    let length = |v: usize| &cell[v][1] - &cell[v][0];
    let mut longest = 0;
    for v in 1..3 {
        if length(v) > length(longest) {
            longest = v;
        }
    }
    let middle = (&cell[longest][0] + &cell[longest][1]) / q(2, 1);
    let (mut first, mut second) = (cell.clone(), cell);
    first[longest][1] = middle.clone();
    second[longest][0] = middle;
    [first, second]
}

/// The lower corner of a box.
fn shown(cell: &Box3) -> String {
    let ends = cell.each_ref().map(|side| rounded_down(&side[0], 4));
    format!("({})", ends.join(", "))
}
