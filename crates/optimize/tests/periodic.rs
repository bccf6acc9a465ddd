//! Periodic tilings of the catalogue, and values known from theory or from other programs.

use acutile_core::tiling::{AnyTiling, Tiling};
use acutile_exact::number::Number;
use acutile_optimize::{
    Extreme, Goal, Keep, NotLocal, Options, Outcome, optimize, prove_local, value,
};
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

/// On its primitive cell with no symmetry kept: 24 tight angles, whose gradients add up to 0 with rank 20.
#[test]
fn c15_is_a_strict_local_optimum() {
    let options = Options {
        keep: Keep::Lattice,
        ..Options::default()
    };
    let outcome = run("c15", &options);
    let proof = prove_local(&outcome, &options).expect("a proof");
    assert_eq!(proof.tight.len(), 24);
    assert_eq!(proof.rank, 20);
    assert_eq!(proof.translations, 3);
    let one = Number::from(Rational::from(1));
    assert!(proof.multipliers.iter().all(|m| *m == one));
}

/// Rounding leaves no two angles tight, so nothing is claimed.
#[test]
fn a_rounded_optimum_is_not_proved() {
    let outcome = run("z", &Options::default());
    let reason = prove_local(&outcome, &Options::default());
    assert!(matches!(reason, Err(NotLocal::Rank { .. })), "{reason:?}");
}
