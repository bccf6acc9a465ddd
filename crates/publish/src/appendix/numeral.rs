//! Exact numbers as TeX: fractions, square roots, powers of the generator. Also the reason why a number is
//! negative, in a form that paper and pencil can follow.
//!
//! Everything is written for math mode. Decimals go through the macro `\acutiledecimal`,
//! so that a document may hand them to siunitx.

use super::columns::width;
use super::rational::interval;
use super::surd::compared;
use acutile_exact::number::radical::{tex_root, tex_sign_over};
use acutile_exact::number::{Field, Number, Quadratic, over_common_denominator};
use malachite::base::num::arithmetic::traits::{CheckedSqrt, Gcd};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::{Integer, Natural, Rational};

/// Letters of a number with its reason in a table.
const LONGEST: usize = 50;

/// How the numbers of one field are written.
#[derive(Clone, Debug)]
pub enum Numerals {
    /// p/q
    Rational,
    /// (p + q √d)/n; the generator of the field is offset + factor √d.
    Quadratic {
        offset: Rational,
        factor: Rational,
        radicand: Integer,
    },
    /// Combinations of powers of the generator α.
    Powers,
}

/// The rational square root of a rational number; a negative number has none.
fn rational_square_root(x: &Rational) -> Option<Rational> {
    if *x < 0 { None } else { x.checked_sqrt() }
}

impl Numerals {
    /// The notation for a field.
    pub fn of(field: &Field) -> Numerals {
        match (Quadratic::of(field), field.degree()) {
            (Some(root), _) => Numerals::Quadratic {
                offset: root.offset,
                factor: root.factor,
                radicand: root.radicand,
            },
            (None, 1) => Numerals::Rational,
            (None, _) => Numerals::Powers,
        }
    }

    /// The coefficients in the notation's basis: 1; 1, √d; or 1, α, α², …
    pub fn coefficients(&self, x: &Number) -> Vec<Rational> {
        match (self, x.coefficients()) {
            (Numerals::Quadratic { offset, factor, .. }, [c, d]) => {
                vec![c + d * offset, d * factor]
            }
            (_, coefficients) => coefficients.to_vec(),
        }
    }

    /// The number.
    pub fn number(&self, x: &Number) -> String {
        let coefficients = self.coefficients(x);
        let (numerators, denominator) = over_common_denominator(&coefficients);
        if denominator == 1u32 {
            return self.sum(&numerators);
        }
        let is_negative = numerators.iter().all(|n| *n <= 0);
        let (sign, numerators) = if is_negative {
            ("-", numerators.iter().map(|n| -n).collect())
        } else {
            ("", numerators)
        };
        format!("{sign}\\frac{{{}}}{{{denominator}}}", self.sum(&numerators))
    }

    /// The number with a slash for the fraction bar, for lines of text and tables.
    pub fn inline(&self, x: &Number) -> String {
        self.slashed(&self.coefficients(x))
    }

    /// The number in a table: a fraction bar over and under digits only;
    /// a slash where the line has to break.
    pub fn cell(&self, x: &Number) -> String {
        let inline = self.inline(x);
        if x.is_rational() && width(&inline) <= LONGEST {
            self.number(x)
        } else {
            inline
        }
    }

    fn slashed(&self, coefficients: &[Rational]) -> String {
        let (numerators, denominator) = over_common_denominator(coefficients);
        let terms = numerators.iter().filter(|n| **n != 0).count();
        match (denominator == 1u32, terms > 1) {
            (true, _) => self.sum(&numerators),
            (false, true) => format!("({})/{denominator}", self.sum(&numerators)),
            (false, false) => format!("{}/{denominator}", self.sum(&numerators)),
        }
    }

    /// The number with parentheses where a factor needs them.
    pub fn factor(&self, x: &Number) -> String {
        let text = self.number(x);
        let terms = self.coefficients(x).iter().filter(|c| **c != 0).count();
        if text.starts_with('-') || (terms > 1 && !text.starts_with("\\frac")) {
            format!("({text})")
        } else {
            text
        }
    }

    /// The number on one line, with parentheses where a factor needs them.
    pub fn slashed_factor(&self, x: &Number) -> String {
        let text = self.inline(x);
        let terms = self.coefficients(x).iter().filter(|c| **c != 0).count();
        if text.starts_with('-') || terms > 1 || text.contains('/') {
            format!("({text})")
        } else {
            text
        }
    }

    /// The number with the reason for its sign in parentheses, if the sign is not obvious. A number that is
    /// too long for a table is replaced by a decimal enclosure.
    pub fn justified(&self, x: &Number) -> String {
        let (text, why) = (self.cell(x), self.why(x));
        let wide = width(&text);
        match (why.is_empty(), wide + width(&why) > LONGEST) {
            (true, _) if wide <= LONGEST || x.is_rational() => text,
            (false, false) => format!("{text}\\quad({why})"),
            _ => format!("\\in {}", self.enclosed(x)),
        }
    }

    /// Σ n_i of the basis.
    fn sum(&self, numerators: &[Integer]) -> String {
        let mut text = String::new();
        for (power, n) in numerators.iter().enumerate().filter(|(_, n)| **n != 0) {
            let sign = match (*n < 0, text.is_empty()) {
                (true, _) => "-",
                (false, true) => "",
                (false, false) => "+",
            };
            let size = n.unsigned_abs_ref();
            let basis = self.basis(power);
            text.push_str(sign);
            match (power, *size == 1u32) {
                (0, _) => text.push_str(&size.to_string()),
                (_, true) => text.push_str(&basis),
                _ => text.push_str(&format!("{size}{basis}")),
            }
        }
        if text.is_empty() {
            text.push('0');
        }
        text
    }

    fn basis(&self, power: usize) -> String {
        match (self, power) {
            (Numerals::Quadratic { radicand, .. }, _) => tex_sign_over(&radicand.to_string()),
            (_, 1) => "\\alpha".to_owned(),
            _ => format!("\\alpha^{{{power}}}"),
        }
    }

    /// √x for x >= 0: a number of the field where it is one and is found, else the root sign over x.
    pub fn root(&self, x: &Number) -> String {
        if let Some(x) = x.to_rational() {
            return tex_root(x);
        }
        if let Some(root) = self.root_in_field(x) {
            return root;
        }
        tex_sign_over(&self.inline(x))
    }

    /// u + v √d with (u + v √d)² = p + q √d: u² and d v² are (p ± n)/2 with n² = p² - d q².
    fn root_in_field(&self, x: &Number) -> Option<String> {
        let Numerals::Quadratic { radicand, .. } = self else {
            return None;
        };
        let coefficients = self.coefficients(x);
        let (p, q) = (&coefficients[0], &coefficients[1]);
        let d = Rational::from(radicand);
        let n = rational_square_root(&(p * p - &d * q * q))?;
        let halves = [(p + &n), (p - &n)].map(|sum| sum / Rational::from(2));
        let u = halves.iter().find_map(rational_square_root)?;
        if u == 0 {
            return None;
        }
        let v = q / (Rational::from(2) * &u);
        // Of the two roots the positive one; u > 0, so v decides where it is large.
        let is_positive = v >= 0 || &u * &u > &d * &v * &v;
        Some(if is_positive {
            self.slashed(&[u, v])
        } else {
            self.slashed(&[-u, -v])
        })
    }

    /// Why x has its sign. Nothing where all terms have it; for p + q √d the comparison of p²
    /// and d q²; beyond that a decimal enclosure.
    pub fn why(&self, x: &Number) -> String {
        let coefficients = self.coefficients(x);
        if x.is_rational()
            || !matches!(self, Numerals::Powers)
                && (coefficients.iter().all(|c| *c <= 0) || coefficients.iter().all(|c| *c >= 0))
        {
            return String::new();
        }
        let (n, _) = over_common_denominator(&coefficients);
        match (self, n.as_slice()) {
            (Numerals::Quadratic { radicand, .. }, [p, q]) => compared(p, q, radicand),
            _ => format!("\\in {}", self.enclosed(x)),
        }
    }

    /// A decimal enclosure.
    pub fn enclosed(&self, x: &Number) -> String {
        interval(&x.enclosure(&Rational::from_signeds(1, 100_000_000)))
    }

    /// A positive rational that makes all of these numbers integers of the notation without a
    /// common factor; 1 if all are zero.
    pub fn primitive_factor(&self, numbers: &[Number]) -> Rational {
        let coefficients: Vec<Rational> =
            numbers.iter().flat_map(|x| self.coefficients(x)).collect();
        let (numerators, denominator) = over_common_denominator(&coefficients);
        let common = numerators
            .iter()
            .fold(Natural::ZERO, |g, n| g.gcd(n.unsigned_abs_ref()));
        if common == 0u32 {
            Rational::ONE
        } else {
            Rational::from_naturals(denominator, common)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use acutile_exact::number::Reader;

    /// The numbers of these texts, and the notation for their field.
    fn read(texts: &[&str]) -> (Numerals, Vec<Number>) {
        let mut reader = Reader::new();
        for text in texts {
            reader.learn(text).expect("a number");
        }
        let numbers = texts
            .iter()
            .map(|text| reader.value(text).expect("a number"));
        let numbers = numbers.collect();
        (Numerals::of(&reader.field()), numbers)
    }

    fn written(text: &str) -> String {
        let (numerals, numbers) = read(&[text]);
        numerals.inline(&numbers[0])
    }

    #[test]
    fn numbers_are_written_over_one_denominator() {
        let cases = [
            ("0", "0"),
            ("-3/4", "-3/4"),
            ("sqrt(5)", "\\sqrt{5}"),
            ("(1+sqrt(5))/2", "(1+\\sqrt{5})/2"),
            ("1/2 - sqrt(12)/3", "(3-4\\sqrt{3})/6"),
            ("-sqrt(2)/7", "-\\sqrt{2}/7"),
        ];
        for (text, expected) in cases {
            assert_eq!(written(text), expected);
        }
    }

    #[test]
    fn roots_are_found_in_the_field() {
        // The last: (√5 - 1)/2 squared is (3 - √5)/2, and 1 - √5 would be the wrong root.
        let cases = [
            ("1/25", "1/5"),
            ("1/20", "\\sqrt{1/20}"),
            ("12", "\\sqrt{12}"),
            ("(3-sqrt(5))/2", "(-1+\\sqrt{5})/2"),
            ("(3-sqrt(5))/6", "\\sqrt{(3-\\sqrt{5})/6}"),
            // The norm is -1, so no number of the field has this square.
            ("1+sqrt(2)", "\\sqrt{1+\\sqrt{2}}"),
        ];
        for (text, expected) in cases {
            let (numerals, numbers) = read(&[text]);
            assert_eq!(numerals.root(&numbers[0]), expected);
        }
    }

    #[test]
    fn signs_are_explained_where_they_are_not_seen() {
        let cases = [
            ("-1-sqrt(5)", ""),
            ("2-sqrt(5)", "2^2=4<5=5\\cdot1^2"),
            ("sqrt(5)-3", "3^2=9>5=5\\cdot1^2"),
            // The squares have 15 digits; 1.73 lies between 1.7 and √3 = 1.732….
            (
                "17000000-10000000*sqrt(3)",
                "17000000/10000000<\\acutiledecimal{1.73}<\\sqrt{3}",
            ),
        ];
        for (text, expected) in cases {
            let (numerals, numbers) = read(&[text]);
            assert_eq!(numerals.why(&numbers[0]), expected, "{text}");
        }
    }

    #[test]
    fn enclosures_are_rounded_outward() {
        let third = Rational::from_signeds(1, 3);
        assert_eq!(
            interval(&(third.clone(), third)),
            "[\\acutiledecimal{0.333333},\\allowbreak\\,\\acutiledecimal{0.333334}]"
        );
        let half = Rational::from_signeds(1, 2);
        assert_eq!(interval(&(half.clone(), half)), "\\acutiledecimal{0.5}");
        let ten = Rational::from(10);
        assert_eq!(interval(&(ten.clone(), ten)), "\\acutiledecimal{10}");
    }
}
