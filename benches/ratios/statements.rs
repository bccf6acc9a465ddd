//! Further statements: one bound of all angles, and that all spheres are locally empty.

use crate::clock::{compare, elapsed};
use crate::data::{a15, doubles};
use crate::naive;
use crate::row::Table;
use acutile_core::checker::{Findings, Model, check_delaunay};
use acutile_core::predicates::AnglesAgainst;
use acutile_core::tiling::match_facets;
use acutile_exact::number::Number;
use malachite::Rational;

/// The rows of the statements.
pub fn measure(table: &Table) {
    table.head("further statements");
    let a15 = a15(6);
    for (name, tiling) in [
        ("A15, integers", a15.clone()),
        ("A15, doubles", doubles(&a15, 1e-4, None)),
    ] {
        let naive = naive::pass(&tiling);
        let model = Model::new(&tiling);
        let matching = match_facets(&tiling);
        let bound = model.prepare(AnglesAgainst::new(&Number::from(Rational::from_signeds(
            1i64,
            1 << 62,
        ))));
        let naive = || elapsed(&naive);
        let below = || elapsed(|| bound.failing(|signs| signs.all_positive()));
        let delaunay =
            || elapsed(|| check_delaunay(&model, &matching, true, &mut Findings::new(0)));
        table.plain(
            &format!("{name}, one bound of angles"),
            compare(below, naive).0,
            "x naive",
            "",
        );
        table.plain(
            &format!("{name}, local Delaunay"),
            compare(delaunay, naive).0,
            "x naive",
            "",
        );
    }
}
