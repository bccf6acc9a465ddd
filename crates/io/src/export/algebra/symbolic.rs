//! Numbers as sums of powers of a generator `a`, for Sage, Mathematica and GAP.

use super::facts::{Class, Facts};
use super::{System, list};
use crate::export::native::number_in;
use acutile_core::tiling::{Corner, Tiling};
use acutile_exact::number::{Field, Number, Quadratic};
use malachite::Integer;

/// The values for the template.
pub fn values<const D: usize>(
    tiling: &Tiling<D>,
    facts: &Facts,
    system: System,
) -> Vec<(&'static str, String)> {
    let brackets = match system {
        System::Mathematica => ["{", "}"],
        _ => ["[", "]"],
    };
    let row = |row: &[Number]| list(row.iter().map(written), brackets);
    let rank = tiling.frame.rank();
    let simplices = tiling
        .simplices()
        .map(|corners| list(corners.iter().map(|c| corner(c, rank, brackets)), brackets));
    let class = |class: &Class| {
        let angles = list(class.angles.iter().map(usize::to_string), brackets);
        list([row(&class.squared_edges), angles], brackets)
    };
    vec![
        ("FIELD", field(&tiling.frame.field, system)),
        (
            "GRAM",
            list(tiling.frame.gram.iter().map(|r| row(r)), brackets),
        ),
        (
            "VERTICES",
            list(tiling.vertices.iter().map(|v| row(&v)), brackets),
        ),
        ("SIMPLICES", list(simplices, brackets)),
        ("TOTAL", written(&facts.total)),
        (
            "KINDS",
            list(facts.kinds.iter().map(usize::to_string), brackets),
        ),
        ("CLASSES", list(facts.classes.iter().map(class), brackets)),
    ]
}

fn written(x: &Number) -> String {
    number_in(x, "a")
}

/// The index of the vertex and D integers.
fn corner<const D: usize>(corner: &Corner<D>, rank: usize, brackets: [&str; 2]) -> String {
    let shift = corner.shift.iter().enumerate();
    let shift = shift.map(|(k, s)| {
        if k < rank {
            s.to_string()
        } else {
            "0".to_owned()
        }
    });
    list(
        std::iter::once(corner.vertex.to_string()).chain(shift),
        brackets,
    )
}

/// The definition of the field and of its generator.
fn field(field: &Field, system: System) -> String {
    let (low, high) = field.root();
    match (system, Quadratic::of(field)) {
        (System::Sage, _) if field.is_rationals() => "K = QQ".to_owned(),
        (System::Sage, _) => format!(
            "R.<t> = QQ[]\ngenerator = {}\n\
             K.<a> = NumberField(generator, embedding=AA.polynomial_root(generator, RIF({low}, {high})))",
            polynomial(field.polynomial(), "t")
        ),
        (System::Mathematica, _) if field.is_rationals() => "canonical = Expand;".to_owned(),
        (System::Mathematica, Some(root)) => {
            format!(
                "a = {};\ncanonical = Expand;",
                closed(&root, ["Sqrt[", "]"])
            )
        }
        (System::Mathematica, None) => format!(
            "a = t /. First[Solve[{} == 0 && {low} < t < {high}, t, Reals]];\ncanonical = RootReduce;",
            polynomial(field.polynomial(), "t")
        ),
        (_, root) => {
            let definition = match root {
                _ if field.is_rationals() => {
                    "K := Rationals;;\nbasis := Basis(K, [1]);;".to_owned()
                }
                Some(root) => format!(
                    "a := {};;\nK := Field(a);;\nbasis := Basis(K, [1, a]);;",
                    closed(&root, ["Sqrt(", ")"])
                ),
                None => format!(
                    "t := Indeterminate(Rationals, \"t\");;\nK := AlgebraicExtension(Rationals, {});;\n\
                     a := RootOfDefiningPolynomial(K);;\nbasis := Basis(K);;",
                    polynomial(field.polynomial(), "t")
                ),
            };
            let coefficients = field.polynomial().iter().map(Integer::to_string);
            format!(
                "{definition}\n# The polynomial of a, constant term first, and an interval with no other root of it.\n\
                 polynomial := {};;\nbounds := [{low}, {high}];;",
                list(coefficients, ["[", "]"])
            )
        }
    }
}

/// `1/2 + (1/2)*Sqrt(5)`
fn closed(root: &Quadratic, [open, close]: [&str; 2]) -> String {
    format!(
        "{} + ({})*{open}{}{close}",
        root.offset, root.factor, root.radicand
    )
}

/// `(-1) + (-1)*t^1 + (1)*t^3`
fn polynomial(coefficients: &[Integer], variable: &str) -> String {
    let terms = coefficients.iter().enumerate().filter(|(_, c)| **c != 0);
    let term = |(power, c): (usize, &Integer)| match power {
        0 => format!("({c})"),
        _ => format!("({c})*{variable}^{power}"),
    };
    terms.map(term).collect::<Vec<String>>().join(" + ")
}
