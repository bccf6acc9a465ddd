//! Periodic tilings of the catalogue, and values known from theory or from other programs.

use acutile_core::tiling::{AnyTiling, Tiling};
use acutile_optimize::{Extreme, Goal, Options, Outcome, optimize, value};
use malachite::Rational;

pub fn catalogue(name: &str) -> Tiling<3> {
    match acutile_catalog::build(name) {
        Ok(AnyTiling::Space(tiling)) => tiling,
        other => panic!("{name}: {other:?}"),
    }
}

pub fn run(name: &str, options: &Options) -> Outcome {
    let found = optimize(&catalogue(name), options, &mut |_| true);
    found.unwrap_or_else(|failure| panic!("{name}: {failure:?}"))
}

/// The upper end of a narrow enclosure of the proved value, in degrees.
pub fn degrees(outcome: &Outcome, goal: Goal) -> Rational {
    let value: Option<Extreme> = value(outcome.proved.statements(), goal);
    value
        .expect("a proved tiling has its extremes")
        .enclosure(&Rational::from_signeds(1, 1_000_000_000))
        .1
}

fn reaches(name: &str, ten_thousandths: i64) {
    let outcome = run(name, &Options::default());
    assert!(outcome.is_better, "{name}");
    let reached = degrees(&outcome, Goal::MaxDihedral);
    let bound = Rational::from_signeds(ten_thousandths, 10_000);
    println!(
        "{name} {} {} {:?}",
        reached, outcome.parameters, outcome.denominators
    );
    assert!(reached <= bound, "{name}: {reached} is more than {bound}");
}

#[test]
fn c14_reaches_its_record() {
    reaches("c14", 741_478);
}

#[test]
fn the_slab_reaches_its_record() {
    reaches("slab", 773_400);
}

#[test]
fn z_reaches_its_record() {
    reaches("z", 756_900);
}

/// C15 is a strict local optimum.
#[test]
fn c15_stays() {
    let outcome = run("c15", &Options::default());
    assert!(!outcome.is_better);
}
