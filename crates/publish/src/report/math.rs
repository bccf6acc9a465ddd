//! Formulas as MathML: numbers like `-1/2 + 3/4 a^2`, roots like `√(5/12)`, polynomials like `2*z3 - x^2`.
//! `assets/math.js` does the same in the page. A text of another form stays text.

use super::html::escape;
use std::iter::Peekable;
use std::str::CharIndices;

/// The formula as MathML, or the text, escaped. A single integer needs no markup.
pub fn math(text: &str) -> String {
    let is_integer = !text.is_empty() && text.chars().all(|c| c.is_ascii_digit());
    match formula(text) {
        // Programs that read pages aloud, and those that copy text, have the plain form.
        Some(formula) if !is_integer => {
            format!("<math alttext=\"{}\">{formula}</math>", escape(text))
        }
        _ => escape(text),
    }
}

fn formula(text: &str) -> Option<String> {
    let tokens = tokens(text);
    let mut reader = Reader {
        tokens: &tokens,
        at: 0,
    };
    let formula = reader.sum()?;
    (reader.at == tokens.len()).then_some(formula)
}

/// Numbers, names and single signs.
fn tokens(text: &str) -> Vec<&str> {
    let mut tokens = Vec::new();
    let mut rest = text.char_indices().peekable();
    while let Some((start, first)) = rest.next() {
        let end = match first {
            c if c.is_whitespace() => continue,
            c if c.is_ascii_digit() => end_of(&mut rest, text, |c| c.is_ascii_digit()),
            c if c.is_ascii_lowercase() => end_of(&mut rest, text, is_of_name),
            c => start + c.len_utf8(),
        };
        tokens.push(&text[start..end]);
    }
    tokens
}

fn is_of_name(c: char) -> bool {
    c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_'
}

/// Where the characters that belong to a token end.
fn end_of(rest: &mut Peekable<CharIndices>, text: &str, belongs: fn(char) -> bool) -> usize {
    while rest.next_if(|(_, c)| belongs(*c)).is_some() {}
    rest.peek().map_or(text.len(), |(at, _)| *at)
}

struct Reader<'t> {
    tokens: &'t [&'t str],
    at: usize,
}

impl<'t> Reader<'t> {
    fn next(&self) -> &'t str {
        self.tokens.get(self.at).copied().unwrap_or("")
    }

    fn take(&mut self, token: &str) -> bool {
        let is_next = self.next() == token;
        self.at += usize::from(is_next);
        is_next
    }

    fn sum(&mut self) -> Option<String> {
        let mut parts = Vec::new();
        if self.take("-") {
            parts.push(operator("-"));
        }
        parts.push(self.product()?);
        while let sign @ ("+" | "-") = self.next() {
            self.at += 1;
            parts.push(operator(sign));
            parts.push(self.product()?);
        }
        Some(row(&parts))
    }

    fn product(&mut self) -> Option<String> {
        let mut factors = vec![self.power()?];
        loop {
            if self.take("/") {
                let (above, below) = (factors.pop()?, self.power()?);
                factors.push(format!("<mfrac>{above}{below}</mfrac>"));
            } else if self.take("*") || self.begins_factor() {
                factors.push("<mo>\u{2062}</mo>".to_owned());
                factors.push(self.power()?);
            } else {
                return Some(row(&factors));
            }
        }
    }

    fn begins_factor(&self) -> bool {
        let first = self.next().chars().next();
        first.is_some_and(|c| c.is_ascii_alphanumeric() || c == '√' || c == '(')
    }

    fn power(&mut self) -> Option<String> {
        let base = self.atom()?;
        if self.take("^") {
            return Some(format!("<msup>{base}{}</msup>", self.atom()?));
        }
        Some(base)
    }

    fn atom(&mut self) -> Option<String> {
        let token = self.next();
        self.at += 1;
        match token.chars().next()? {
            c if c.is_ascii_digit() => Some(format!("<mn>{token}</mn>")),
            c if c.is_ascii_lowercase() => Some(identifier(token)),
            '√' if self.take("(") => Some(format!("<msqrt>{}</msqrt>", self.closed()?)),
            '√' => Some(format!("<msqrt>{}</msqrt>", self.atom()?)),
            '(' => {
                let inner = self.closed()?;
                Some(row(&[operator("("), inner, operator(")")]))
            }
            _ => None,
        }
    }

    fn closed(&mut self) -> Option<String> {
        let inner = self.sum()?;
        self.take(")").then_some(inner)
    }
}

fn row(parts: &[String]) -> String {
    match parts {
        [part] => part.clone(),
        _ => format!("<mrow>{}</mrow>", parts.concat()),
    }
}

fn operator(sign: &str) -> String {
    format!("<mo>{}</mo>", if sign == "-" { "−" } else { sign })
}

/// `z1` has the index 1, and `x_zn2` the index zn2; `epsilon` has none.
fn identifier(name: &str) -> String {
    let end = name.find(|c: char| !c.is_ascii_lowercase());
    let (letters, index) = name.split_at(end.unwrap_or(name.len()));
    match index.trim_start_matches('_') {
        "" => format!("<mi>{letters}</mi>"),
        index => format!("<msub><mi>{letters}</mi><mi>{index}</mi></msub>"),
    }
}

#[cfg(test)]
mod tests {
    use super::math;

    #[test]
    fn numbers_roots_and_polynomials() {
        let cases = [
            (
                "-1/2",
                "<mrow><mo>−</mo><mfrac><mn>1</mn><mn>2</mn></mfrac></mrow>",
            ),
            (
                "√(5/12)",
                "<msqrt><mfrac><mn>5</mn><mn>12</mn></mfrac></msqrt>",
            ),
            (
                "3 a^2",
                "<mrow><mn>3</mn><mo>\u{2062}</mo><msup><mi>a</mi><mn>2</mn></msup></mrow>",
            ),
            (
                "2*z3",
                "<mrow><mn>2</mn><mo>\u{2062}</mo><msub><mi>z</mi><mi>3</mi></msub></mrow>",
            ),
            ("epsilon", "<mi>epsilon</mi>"),
            ("x_zn2", "<msub><mi>x</mi><mi>zn2</mi></msub>"),
        ];
        for (text, expected) in cases {
            assert_eq!(
                math(text),
                format!("<math alttext=\"{text}\">{expected}</math>")
            );
        }
    }

    #[test]
    fn other_texts_stay_text() {
        for text in ["17", "a - ", "", "(1", "arccos(1/3", "2 <b>", "1..2"] {
            assert!(!math(text).contains("<math"), "{text}");
            assert!(!math(text).contains("<b>"), "{text}");
        }
    }
}
