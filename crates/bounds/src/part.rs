//! A part of the proof that consists of definitions and claims, and its checks.
//!
//! Definitions and claims are texts. The text that is printed is the text that is decided.

use super::arithmetic::{Arithmetic, Function, Names, evaluate};
use super::check::{Check, Verdict};
use super::enclosure::Enclosures;
use super::exact::Exact;
use acutile_exact::number::text::parse;
use std::cmp::Ordering;

/// How claims are decided.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// Exactly, over Q(√3, √11).
    Exact,
    /// With rational enclosures.
    Enclosed,
}

/// A name for a number.
#[derive(Clone, Copy, Debug)]
pub struct Definition {
    /// The name, which later texts use.
    pub name: &'static str,
    /// A function that is applied to the value of the text.
    pub function: Option<Function>,
    /// An expression of numbers and earlier names.
    pub text: &'static str,
}

/// An inequality or an equation between expressions.
#[derive(Clone, Copy, Debug)]
pub struct Claim {
    /// A stable name within the part.
    pub id: &'static str,
    /// The place in docs/lower-bound.md.
    pub place: &'static str,
    /// `left > right`, `left < right` or `left = right`.
    pub text: &'static str,
}

/// Definitions, and claims about them.
#[derive(Clone, Copy, Debug)]
pub struct Part {
    /// A stable name.
    pub id: &'static str,
    /// The arithmetic in which the claims are decided.
    pub method: Method,
    /// The names, each defined by earlier ones.
    pub definitions: &'static [Definition],
    /// The claims, in the order in which they are decided.
    pub claims: &'static [Claim],
}

/// `name = text`
pub const fn given(name: &'static str, text: &'static str) -> Definition {
    Definition {
        name,
        function: None,
        text,
    }
}

/// `name = function(text)`
pub const fn applied(name: &'static str, function: Function, text: &'static str) -> Definition {
    Definition {
        name,
        function: Some(function),
        text,
    }
}

/// A claim at a place of the proof.
pub const fn claim(id: &'static str, place: &'static str, text: &'static str) -> Claim {
    Claim { id, place, text }
}

impl Part {
    /// Decides every claim.
    pub fn checks(&self) -> Vec<Check> {
        match self.method {
            Method::Exact => match Exact::new() {
                Ok(exact) => self.checks_over(&exact, "exactly"),
                Err(reason) => self.all_undecided(&reason),
            },
            Method::Enclosed => self.checks_over(&Enclosures, "with rational enclosures"),
        }
    }

    fn checks_over<A: Arithmetic>(&self, arithmetic: &A, how: &str) -> Vec<Check> {
        match self.names(arithmetic) {
            Ok(names) => {
                let claims = self.claims.iter();
                claims
                    .map(|claim| {
                        let (verdict, found) = claim
                            .decide(arithmetic, &names)
                            .unwrap_or_else(|reason| (Verdict::Undecided, reason));
                        self.check(claim, verdict, format!("{how}: {found}"))
                    })
                    .collect()
            }
            Err(reason) => self.all_undecided(&reason),
        }
    }

    fn all_undecided(&self, reason: &str) -> Vec<Check> {
        let claims = self.claims.iter();
        claims
            .map(|claim| self.check(claim, Verdict::Undecided, reason.to_owned()))
            .collect()
    }

    fn check(&self, claim: &Claim, verdict: Verdict, found: String) -> Check {
        Check {
            part: self.id,
            id: claim.id,
            place: claim.place,
            statement: self.with_definitions(claim),
            verdict,
            found,
        }
    }

    /// The values of the names. A definition uses earlier names only.
    fn names<A: Arithmetic>(&self, arithmetic: &A) -> Result<Names<A::Value>, String> {
        let mut names = Names::new();
        for definition in self.definitions {
            let value = definition
                .value(arithmetic, &names)
                .map_err(|reason| format!("{}: {reason}", definition.words()))?;
            names.insert(definition.name.to_owned(), value);
        }
        Ok(names)
    }

    /// The claim, and the definitions that it uses, directly or through others.
    fn with_definitions(&self, claim: &Claim) -> String {
        let mut used = vec![claim.text];
        let mut words = Vec::new();
        for definition in self.definitions.iter().rev() {
            if used.iter().any(|text| mentions(text, definition.name)) {
                used.push(definition.text);
                words.push(definition.words());
            }
        }
        words.reverse();
        if words.is_empty() {
            return claim.text.to_owned();
        }
        format!("{} where {}", claim.text, words.join(", "))
    }
}

/// Whether a name is a word of the text.
fn mentions(text: &str, name: &str) -> bool {
    let is_part = |c: char| c.is_ascii_alphanumeric() || c == '_';
    text.split(|c| !is_part(c)).any(|word| word == name)
}

impl Definition {
    fn value<A: Arithmetic>(
        &self,
        arithmetic: &A,
        names: &Names<A::Value>,
    ) -> Result<A::Value, String> {
        let value = value_of(arithmetic, self.text, names)?;
        match self.function {
            Some(function) => arithmetic.apply(function, &value),
            None => Ok(value),
        }
    }

    /// `c = cos(theta)`
    fn words(&self) -> String {
        let Definition { name, text, .. } = self;
        match self.function {
            Some(function) => format!("{name} = {}({text})", function.name()),
            None => format!("{name} = {text}"),
        }
    }
}

/// The relations, each with the order that makes it true.
const RELATIONS: [(&str, Ordering); 3] = [
    (" > ", Ordering::Greater),
    (" < ", Ordering::Less),
    (" = ", Ordering::Equal),
];

impl Claim {
    /// The verdict and the values of both sides.
    fn decide<A: Arithmetic>(
        &self,
        arithmetic: &A,
        names: &Names<A::Value>,
    ) -> Result<(Verdict, String), String> {
        let (left, right, wanted) = RELATIONS
            .iter()
            .find_map(|(sign, order)| {
                let (left, right) = self.text.split_once(sign)?;
                Some((left, right, *order))
            })
            .ok_or_else(|| format!("{}: has no relation", self.text))?;
        let left = value_of(arithmetic, left, names)?;
        let right = value_of(arithmetic, right, names)?;
        let verdict = match arithmetic.compare(&left, &right) {
            Some(order) => Verdict::of(order == wanted),
            None => Verdict::Undecided,
        };
        let (left, right) = (arithmetic.shown(&left), arithmetic.shown(&right));
        Ok((verdict, format!("left {left}, right {right}")))
    }
}

fn value_of<A: Arithmetic>(
    arithmetic: &A,
    text: &str,
    names: &Names<A::Value>,
) -> Result<A::Value, String> {
    let expression = parse(text).map_err(|error| format!("{text}: {error}"))?;
    evaluate(arithmetic, &expression, names)
}
