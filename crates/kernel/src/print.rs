//! The canonical JSON of a claim: the text that `--claim` compares.

use crate::claim::{Bound, Claim, Domain, Field, Number, Polytope, Statement};
use num_bigint::BigInt;

impl Claim {
    /// The claim file of this claim.
    pub fn print(&self) -> String {
        let claim = block(
            "{}",
            vec![
                format!("\"dimension\":{}", self.dimension),
                format!("\"field\":{}", field(&self.field)),
                format!("\"gram\":{}", self.print_gram()),
                format!("\"domain\":{}", domain(&self.domain)),
                format!(
                    "\"statements\":{}",
                    block("[]", self.statements.iter().map(statement))
                ),
            ],
        );
        let file = vec![
            String::from("\"format\":\"acutile-claim\""),
            String::from("\"version\":2"),
            String::from("\"kind\":\"tiling\""),
            format!("\"claim\":{claim}"),
        ];
        block("{}", file) + "\n"
    }

    fn print_gram(&self) -> String {
        let mut entries = self.gram.iter().map(number);
        let rows = (0..self.dimension).map(|row| list(entries.by_ref().take(self.dimension - row)));
        block("[]", rows.collect::<Vec<_>>())
    }
}

fn field(field: &Field) -> String {
    match field {
        Field::Rational => String::from("\"Q\""),
        Field::Algebraic {
            polynomial,
            low,
            high,
            denominator,
        } => {
            let [low, high, denominator] = [low, high, denominator].map(integer);
            let root = format!("{{\"low\":{low},\"high\":{high},\"denominator\":{denominator}}}");
            let members = vec![
                format!("\"polynomial\":{}", list(polynomial.iter().map(integer))),
                format!("\"root\":{root}"),
            ];
            block("{}", members)
        }
    }
}

fn domain(domain: &Domain) -> String {
    let (name, value) = match domain {
        Domain::Space => return String::from("\"space\""),
        Domain::Slab(p) => ("slab", polytope(p)),
        Domain::Prism(p) => ("prism", polytope(p)),
        Domain::Solid(p) => ("solid", polytope(p)),
        Domain::Region(rank) => ("region", rank.to_string()),
    };
    block("[]", vec![format!("\"{name}\""), value])
}

fn polytope(polytope: &Polytope) -> String {
    let vertices = polytope
        .vertices
        .iter()
        .map(|vertex| list(vertex.iter().map(number)));
    let faces = polytope
        .faces
        .iter()
        .map(|face| list(face.iter().map(usize::to_string)));
    let (vertices, faces) = (list(vertices), list(faces));
    let denominator = integer(&polytope.denominator);
    format!("{{\"denominator\":{denominator},\"vertices\":{vertices},\"faces\":{faces}}}")
}

fn statement(statement: &Statement) -> String {
    let text = format!("\"{}\"", statement.text());
    match statement {
        Statement::Bound(bound) => bound_values(text, bound),
        _ => text,
    }
}

fn bound_values(quantity: String, bound: &Bound) -> String {
    let mut values = vec![quantity, format!("\"{}\"", bound.relation.text())];
    if bound.has_sign() {
        values.push(bound.sign.to_string());
    }
    values.push(list([
        number(&bound.numerator),
        integer(&bound.denominator),
    ]));
    list(values)
}

fn number(number: &Number) -> String {
    match number.as_slice() {
        [value] => integer(value),
        coefficients => list(coefficients.iter().map(integer)),
    }
}

/// A number of less than 53 bits, or a text.
fn integer(value: &BigInt) -> String {
    if value.bits() <= 53 {
        value.to_string()
    } else {
        format!("\"{value}\"")
    }
}

/// On one line.
fn list(items: impl IntoIterator<Item = String>) -> String {
    let items: Vec<String> = items.into_iter().collect();
    format!("[{}]", items.join(","))
}

/// Each item on its own line.
fn block(brackets: &str, items: impl IntoIterator<Item = String>) -> String {
    let items: Vec<String> = items.into_iter().collect();
    let (open, close) = brackets.split_at(1);
    if items.is_empty() {
        brackets.to_string()
    } else {
        format!("{open}\n{}\n{close}", items.join(",\n"))
    }
}
