//! The canonical JSON of a claim: the text that `--claim` compares.

use crate::claim::{Claim, Domain, Field, Number, Property, Statement};
use num_bigint::BigInt;

impl Claim {
    /// The claim file of this claim.
    pub fn print(&self) -> String {
        let mut entries = self.gram.iter().map(number);
        let rows = (1..=self.dimension).rev();
        let rows = rows.map(|length| list(entries.by_ref().take(length))).collect();
        let claim = vec![
            format!("\"dimension\":{}", self.dimension),
            format!("\"field\":{}", self.print_field()),
            format!("\"gram\":{}", block("[]", rows)),
            format!("\"domain\":{}", self.print_domain()),
            format!("\"statements\":{}", block("[]", self.statements.iter().map(statement).collect())),
        ];
        let head = r#""format":"acutile-claim","version":2,"kind":"tiling""#;
        let mut file: Vec<String> = head.split(',').map(String::from).collect();
        file.push(format!("\"claim\":{}", block("{}", claim)));
        block("{}", file) + "\n"
    }

    fn print_field(&self) -> String {
        let Field::Algebraic { polynomial, low, high, denominator } = &self.field else {
            return "\"Q\"".into();
        };
        let [low, high, denominator] = [low, high, denominator].map(integer);
        let polynomial = list(polynomial.iter().map(integer));
        let root = format!("{{\"low\":{low},\"high\":{high},\"denominator\":{denominator}}}");
        block("{}", vec![format!("\"polynomial\":{polynomial}"), format!("\"root\":{root}")])
    }

    fn print_domain(&self) -> String {
        let name = format!("\"{}\"", self.domain.name(self.dimension));
        let value = match &self.domain {
            Domain::Space => return name,
            Domain::Region(rank) => rank.to_string(),
            Domain::Polytope(polytope) => {
                let vertices = polytope.vertices.iter().map(|v| list(v.iter().map(number)));
                let faces = polytope.faces.iter().map(|f| list(f.iter().map(usize::to_string)));
                let (vertices, faces) = (list(vertices), list(faces));
                let denominator = integer(&polytope.denominator);
                format!("{{\"denominator\":{denominator},\"vertices\":{vertices},\"faces\":{faces}}}")
            }
        };
        block("[]", vec![name, value])
    }
}

fn statement(statement: &Statement) -> String {
    let text = |text| format!("\"{text}\"");
    let mut values = vec![text(statement.property.text())];
    let Some(bound) = &statement.bound else {
        return values.concat();
    };
    values.push(text(bound.relation.text()));
    if statement.property != Property::SquaredRatio {
        values.push(bound.sign.to_string());
    }
    values.push(list([number(&bound.numerator), integer(&bound.denominator)]));
    list(values)
}

fn number(number: &Number) -> String {
    match number.as_slice() {
        [value] => integer(value),
        coefficients => list(coefficients.iter().map(integer)),
    }
}

/// A number where the absolute value is less than 2^53, else a text.
fn integer(value: &BigInt) -> String {
    if value.bits() <= 53 { value.to_string() } else { format!("\"{value}\"") }
}

/// On one line.
fn list(items: impl IntoIterator<Item = String>) -> String {
    format!("[{}]", items.into_iter().collect::<Vec<_>>().join(","))
}

/// Each item on its own line.
fn block(brackets: &str, items: Vec<String>) -> String {
    let (open, close) = brackets.split_at(1);
    format!("{open}\n{}\n{close}", items.join(",\n"))
}
