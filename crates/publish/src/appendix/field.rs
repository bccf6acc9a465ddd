//! The field of the numbers, and why its generator is one number only.

use super::numeral::Numerals;
use super::rational::{interval, rational};
use super::subject::Analysis;
use acutile_exact::number::radical::tex_sign_over;
use malachite::{Integer, Rational};

/// The field, where it is not the rational numbers.
pub fn definition<const D: usize>(analysis: &Analysis<D>) -> String {
    let field = &analysis.tiling.frame.field;
    match &analysis.numerals {
        Numerals::Rational => String::new(),
        Numerals::Quadratic { radicand, .. } => {
            let root = tex_sign_over(&radicand.to_string());
            format!("All numbers lie in $\\mathbb{{Q}}({root})$. ")
        }
        Numerals::Powers => {
            let (low, high) = field.root();
            format!(
                "All numbers lie in $\\mathbb{{Q}}(\\alpha)$, where $\\alpha$ is the root of ${}$ between ${}$ and ${}$. ",
                polynomial(field.polynomial()),
                rational(&low),
                rational(&high),
            )
        }
    }
}

/// The paragraph that shows that exactly one root is in the interval. It has the signs at the ends,
/// and the derivative over the interval by Horner's rule.
pub fn root<const D: usize>(analysis: &Analysis<D>) -> String {
    let field = &analysis.tiling.frame.field;
    if !matches!(analysis.numerals, Numerals::Powers) {
        return String::new();
    }
    let (low, high) = field.root();
    let p = field.polynomial();
    let value = |x: &Rational| {
        let steps = p.iter().rev();
        steps.fold(Rational::from(0), |sum, c| sum * x + Rational::from(c))
    };
    let derivative: Vec<Integer> = p
        .iter()
        .enumerate()
        .skip(1)
        .map(|(k, c)| c * Integer::from(k))
        .collect();
    let (least, greatest) = horner(&derivative, &low, &high);
    let side = |x: &Rational| if *x > 0 { ">0" } else { "<0" };
    let bounds = field
        .generator()
        .enclosure(&Rational::from_signeds(1, 100_000_000));
    format!(
        "\\acutileparagraph{{The number $\\alpha$.}} Let $p(x)={p}$. Then\n% acutile:root {slug}\n$p({low})={at_low}{low_side}$, $p({high})={at_high}{high_side}$, and $p'(x)\\in[{least},{greatest}]$ for ${low}\\le x\\le {high}$, \
         by Horner's rule in interval arithmetic. The derivative has one sign, so $p$ has exactly one root between the ends. In the same way $\\alpha\\in{enclosed}$.\n\n",
        slug = analysis.subject.slug(),
        p = polynomial(p),
        low = rational(&low),
        high = rational(&high),
        at_low = rational(&value(&low)),
        low_side = side(&value(&low)),
        at_high = rational(&value(&high)),
        high_side = side(&value(&high)),
        least = rational(&least),
        greatest = rational(&greatest),
        enclosed = interval(&bounds),
    )
}

/// The values of a polynomial over an interval, enclosed by Horner's rule.
fn horner(p: &[Integer], low: &Rational, high: &Rational) -> (Rational, Rational) {
    let start = (Rational::from(0), Rational::from(0));
    p.iter().rev().fold(start, |(least, greatest), c| {
        let products = [
            &least * low,
            &least * high,
            &greatest * low,
            &greatest * high,
        ];
        let c = Rational::from(c);
        let lowest = products.iter().min().unwrap_or(&least) + &c;
        let highest = products.iter().max().unwrap_or(&greatest) + &c;
        (lowest, highest)
    })
}

fn polynomial(coefficients: &[Integer]) -> String {
    let mut text = String::new();
    for (power, c) in coefficients.iter().enumerate().rev() {
        if *c == 0 {
            continue;
        }
        let sign = match (*c < 0, text.is_empty()) {
            (true, _) => "-",
            (false, true) => "",
            (false, false) => "+",
        };
        let size = c.unsigned_abs_ref().to_string();
        let variable = match power {
            0 => String::new(),
            1 => "x".to_owned(),
            _ => format!("x^{{{power}}}"),
        };
        let size = if size == "1" && power > 0 { "" } else { &size };
        text.push_str(&format!("{sign}{size}{variable}"));
    }
    text
}
