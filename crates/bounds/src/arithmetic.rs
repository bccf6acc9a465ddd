//! The value of an expression over any arithmetic.
//!
//! The syntax is that of [`acutile_exact::number::text`]: sums, products, powers, square roots and
//! names. A cosine is a definition of its own, see [`super::part`].

use acutile_exact::number::Expression;
use malachite::Rational;
use std::cmp::Ordering;
use std::collections::BTreeMap;

/// A function of angles in degrees.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Function {
    /// The cosine of an angle from 0 to 180 degrees.
    Cos,
    /// The sine of an angle from 0 to 90 degrees.
    Sin,
    /// The angle from 0 to 180 degrees with a cosine.
    Arccos,
}

impl Function {
    /// The function's name.
    pub fn name(self) -> &'static str {
        match self {
            Function::Cos => "cos",
            Function::Sin => "sin",
            Function::Arccos => "arccos",
        }
    }
}

/// Numbers, or sets that contain them.
pub trait Arithmetic {
    /// A number, or a set that contains it.
    type Value: Clone;

    /// The value of a rational number.
    fn rational(&self, value: &Rational) -> Self::Value;
    /// x + y
    fn sum(&self, x: &Self::Value, y: &Self::Value) -> Self::Value;
    /// x - y
    fn difference(&self, x: &Self::Value, y: &Self::Value) -> Self::Value;
    /// x y
    fn product(&self, x: &Self::Value, y: &Self::Value) -> Self::Value;
    /// 1/x; an error where x may be 0.
    fn inverse(&self, x: &Self::Value) -> Result<Self::Value, String>;
    /// The square root that is not negative; an error where there may be none.
    fn root(&self, x: &Self::Value) -> Result<Self::Value, String>;
    /// An error where the argument may lie outside the domain.
    fn apply(&self, function: Function, x: &Self::Value) -> Result<Self::Value, String>;
    /// The order of the two numbers, if the values decide it.
    fn compare(&self, x: &Self::Value, y: &Self::Value) -> Option<Ordering>;
    /// A decimal, or two around the number.
    fn shown(&self, x: &Self::Value) -> String;
}

/// Values of names.
pub type Names<V> = BTreeMap<String, V>;

/// The value of an expression.
///
/// # Errors
/// An unknown name, a division by zero, a root or a function outside its domain.
pub fn evaluate<A: Arithmetic>(
    arithmetic: &A,
    expression: &Expression,
    names: &Names<A::Value>,
) -> Result<A::Value, String> {
    let value = |x: &Expression| evaluate(arithmetic, x, names);
    match expression {
        Expression::Rational(x) => Ok(arithmetic.rational(x)),
        Expression::Name(name, _) => {
            let found = names.get(name).cloned();
            found.ok_or_else(|| format!("{name}: is not defined"))
        }
        Expression::Sum(summands) => {
            let zero = arithmetic.rational(&Rational::from(0));
            summands.iter().try_fold(zero, |sum, (is_minus, x)| {
                let x = value(x)?;
                Ok(if *is_minus {
                    arithmetic.difference(&sum, &x)
                } else {
                    arithmetic.sum(&sum, &x)
                })
            })
        }
        Expression::Product(first, factors) => {
            let mut product = value(first)?;
            for (divides, x, _) in factors {
                let x = value(x)?;
                let factor = if *divides { arithmetic.inverse(&x)? } else { x };
                product = arithmetic.product(&product, &factor);
            }
            Ok(product)
        }
        Expression::Power(base, exponent, _) => power(arithmetic, &value(base)?, *exponent),
        Expression::Root(x, _) => arithmetic.root(&value(x)?),
    }
}

/// x^e
fn power<A: Arithmetic>(arithmetic: &A, x: &A::Value, exponent: i64) -> Result<A::Value, String> {
    let one = arithmetic.rational(&Rational::from(1));
    let power = (0..exponent.unsigned_abs()).fold(one, |power, _| arithmetic.product(&power, x));
    if exponent < 0 {
        arithmetic.inverse(&power)
    } else {
        Ok(power)
    }
}
