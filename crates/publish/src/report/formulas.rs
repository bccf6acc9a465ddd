//! Formulas in the running text of documents as MathML: `h_f(x) = det(w_1 - w_0, x - w_0)`. Documents write
//! them as plain text, so this recognises them: words with an index or an exponent, and the terms that
//! operators join to them. All else stays text.

use super::html::escape;

/// Characters of a formula that a telephone has on a line.
const LONGEST: usize = 40;

/// The text with its formulas marked up.
pub fn marked(text: &str) -> String {
    let words: Vec<&str> = text.split_inclusive(' ').collect();
    let kinds: Vec<Kind> = words.iter().map(|word| kind(word.trim_end())).collect();
    let mut marked = String::new();
    let mut at = 0;
    while at < words.len() {
        match run(&words, &kinds, at) {
            Some(end) => {
                let pieces = pieces(&words[at..end]);
                marked.extend(pieces.iter().map(|piece| formula(piece)));
                at = end;
            }
            None => {
                marked += &escape(words[at]);
                at += 1;
            }
        }
    }
    marked
}

/// The kinds of words in a formula.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    /// It has an index or an exponent: certainly a formula.
    Indexed,
    /// A sign between two terms.
    Operator,
    /// A letter, a number, brackets: a formula beside an operator.
    Term,
    Prose,
}

const OPERATORS: [&str; 13] = [
    "=", "<", ">", "≤", "≥", "+", "-", "·", "∈", "⊂", "∩", "∪", "≡",
];
const FUNCTIONS: [&str; 9] = [
    "det", "vol", "sqrt", "arccos", "sin", "cos", "tan", "min", "max",
];

fn kind(word: &str) -> Kind {
    let word = word.trim_end_matches(['.', ',', ';', ':']);
    if OPERATORS.contains(&word) {
        return Kind::Operator;
    }
    let tokens = tokens(word);
    let is_index = |k: usize| k > 0 && matches!(tokens[k - 1], "_" | "^") && tokens[k].len() <= 3;
    let is_math =
        !tokens.is_empty() && (0..tokens.len()).all(|k| is_index(k) || is_mathematical(tokens[k]));
    // An index is a letter or a number after a letter: `c_0`, `(S_j)`, `x^2`.
    let is_indexed = tokens.windows(2).any(|pair| matches!(pair[1], "_" | "^"));
    match (is_math, is_indexed) {
        (true, true) => Kind::Indexed,
        (true, false) => Kind::Term,
        _ => Kind::Prose,
    }
}

fn is_mathematical(token: &str) -> bool {
    let mut letters = token.chars();
    let is_single = letters.next().is_some() && letters.next().is_none();
    let is_number = token.chars().all(|c| c.is_ascii_digit());
    is_number || FUNCTIONS.contains(&token) || (is_single && !"\"!?“”".contains(token))
}

/// Words of letters, numbers, and single signs.
fn tokens(text: &str) -> Vec<&str> {
    let class = |c: char| match c {
        c if c.is_ascii_digit() => 1,
        c if c.is_alphabetic() => 2,
        _ => 0,
    };
    let mut tokens = Vec::new();
    let mut start = 0;
    let mut last = 0;
    for (at, c) in text.char_indices() {
        if at > 0 && (class(c) != last || last == 0) {
            tokens.push(&text[start..at]);
            start = at;
        }
        last = class(c);
    }
    tokens.push(&text[start..]);
    tokens.retain(|token| !token.trim().is_empty());
    tokens
}

/// The end of the formula that begins with word `start`, if one does. An operator joins the word before it and the one after it, and a
/// comma joins two words with indices.
fn run(words: &[&str], kinds: &[Kind], start: usize) -> Option<usize> {
    let is_term = |k: usize| matches!(kinds.get(k), Some(Kind::Indexed | Kind::Term));
    let is_operator = |k: usize| kinds.get(k) == Some(&Kind::Operator);
    if !is_term(start) {
        return None;
    }
    let mut end = start + 1;
    // The longest part in which all brackets are closed.
    let mut closed = None;
    loop {
        let depth = depth(&words[start..end].concat());
        if depth == 0 {
            closed = Some(end);
        }
        let last = words[end - 1].trim_end();
        if last.ends_with(['.', ';', ':']) && depth <= 0 {
            break;
        }
        // `a = b`, and `…, c_D` or ` c_0)` inside of brackets.
        if is_operator(end) && is_term(end + 1) && !last.ends_with(',') {
            end += 2;
        } else if is_term(end) && (depth > 0 || continues(last, words, kinds, end)) {
            end += 1;
        } else {
            break;
        }
    }
    closed.filter(|end| {
        let mut kinds = kinds[start..*end].iter();
        kinds.any(|kind| matches!(kind, Kind::Indexed | Kind::Operator))
    })
}

/// A formula in pieces, each of which but the first begins with an operator. Browsers break no line inside of MathML, so a long formula
/// breaks outside of its brackets.
fn pieces(words: &[&str]) -> Vec<String> {
    let is_long = words.concat().chars().count() > LONGEST;
    let mut pieces = vec![String::new()];
    for word in words {
        let piece = pieces.last().map_or("", String::as_str);
        let is_start = kind(word.trim_end()) == Kind::Operator && depth(piece) == 0;
        if is_long && is_start && !piece.is_empty() {
            pieces.push(String::new());
        }
        if let Some(piece) = pieces.last_mut() {
            *piece += word;
        }
    }
    pieces
}

/// Whether a list goes on after a comma: `b_1, …, b_r`; or a product: `s_f h_f`, `sin α_i`.
fn continues(last: &str, words: &[&str], kinds: &[Kind], next: usize) -> bool {
    let is_dots = words[next].trim_end().trim_end_matches(',') == "…";
    match last.strip_suffix(',') {
        Some(before) => is_dots || (before == "…" && kinds[next] != Kind::Prose),
        None if FUNCTIONS.iter().any(|name| last.ends_with(name)) => true,
        None => kinds[next] == Kind::Indexed && kinds[next - 1] == Kind::Indexed,
    }
}

/// How many brackets are open; -1 where one is closed that was not open.
fn depth(text: &str) -> i32 {
    let mut depth = 0;
    for c in text.chars() {
        depth += match c {
            '(' | '[' | '{' | '⟨' => 1,
            ')' | ']' | '}' | '⟩' => -1,
            _ => 0,
        };
        if depth < 0 {
            break;
        }
    }
    depth
}

/// The words of a formula as MathML; the punctuation and the blank at the end stay outside.
fn formula(text: &str) -> String {
    let trimmed = text.trim_end_matches([' ', '.', ',', ';', ':']);
    let after = &text[trimmed.len()..];
    let tokens = tokens(trimmed);
    let mut parts: Vec<String> = Vec::new();
    let mut at = 0;
    while at < tokens.len() {
        match tokens[at] {
            sign @ ("_" | "^") if at + 1 < tokens.len() && !parts.is_empty() => {
                let (index, next) = index(&tokens, at + 1);
                let base = parts.pop().unwrap_or_default();
                let name = if sign == "_" { "msub" } else { "msup" };
                parts.push(format!("<{name}>{base}{index}</{name}>"));
                at = next;
            }
            token => {
                parts.push(element(token));
                at += 1;
                let is_apart = tokens.get(at).is_some_and(|next| *next != "(");
                if FUNCTIONS.contains(&token) && is_apart {
                    parts.push("<mspace width=\"0.17em\"></mspace>".to_owned());
                }
            }
        }
    }
    format!(
        "<math alttext=\"{}\">{}</math>{after}",
        escape(trimmed),
        parts.concat()
    )
}

/// The argument of `_` or `^`: a token, or several in braces. And where the rest begins.
fn index(tokens: &[&str], start: usize) -> (String, usize) {
    let end = match tokens[start] {
        "{" => tokens[start..].iter().position(|token| *token == "}"),
        "(" => tokens[start..].iter().position(|token| *token == ")"),
        _ => None,
    };
    match end {
        Some(length) => {
            let inner: String = tokens[start + 1..start + length]
                .iter()
                .map(|token| element(token))
                .collect();
            (format!("<mrow>{inner}</mrow>"), start + length + 1)
        }
        None => (element(tokens[start]), start + 1),
    }
}

fn element(token: &str) -> String {
    let escaped = escape(token);
    match token.chars().next() {
        Some(c) if c.is_ascii_digit() => format!("<mn>{escaped}</mn>"),
        Some(c) if c.is_alphabetic() => format!("<mi>{escaped}</mi>"),
        _ if token == "-" => "<mo>−</mo>".to_owned(),
        _ if token == "'" => "<mo>′</mo>".to_owned(),
        _ => format!("<mo>{escaped}</mo>"),
    }
}

#[cfg(test)]
mod tests {
    use super::marked;

    /// The formulas of a text in their plain form.
    fn found(text: &str) -> Vec<String> {
        let marked = marked(text);
        let parts = marked.split("alttext=\"").skip(1);
        parts
            .map(|part| part.split('"').next().unwrap_or_default().to_owned())
            .collect()
    }

    #[test]
    fn formulas_are_found_in_prose() {
        let cases = [
            (
                "Then h_f(x) = det(w_1 - w_0, …, w_{k-1} - w_0, x - w_0).",
                // Longer than a line of a telephone.
                vec!["h_f(x)", "= det(w_1 - w_0, …, w_{k-1} - w_0, x - w_0)"],
            ),
            (
                "The lattice of b_1, …, b_r; r is its rank.",
                vec!["b_1, …, b_r"],
            ),
            ("Let n ≥ 1, and k = 0 hold.", vec!["n ≥ 1", "k = 0"]),
            (
                "Facets o_1 and o_2 of a simplex S are (S, i).",
                vec!["o_1", "o_2"],
            ),
            (
                "There is a sign s_f with s_f h_f > 0 at it.",
                vec!["s_f", "s_f h_f &gt; 0"],
            ),
        ];
        for (text, expected) in cases {
            assert_eq!(found(text), expected, "{text}");
        }
    }

    #[test]
    fn prose_stays() {
        let texts = [
            "A tile is a set. I say: not-delaunay, weakly_delaunay <b>.",
            "Table 2 has 53 of 205 pages - all of them.",
        ];
        for text in texts {
            assert_eq!(marked(text), text.replace('<', "&lt;").replace('>', "&gt;"));
        }
    }

    #[test]
    fn indices_are_below_and_exponents_above() {
        assert_eq!(
            marked("x_{k-1}^2"),
            "<math alttext=\"x_{k-1}^2\"><msup><msub><mi>x</mi><mrow><mi>k</mi><mo>−</mo><mn>1</mn></mrow></msub><mn>2</mn></msup></math>"
        );
    }
}
