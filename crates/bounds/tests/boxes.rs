//! The boxes of Theorem 7: values against another program, and settings beyond its reach.

use acutile_bounds::Verdict;
use acutile_bounds::boxes::Setting;
use acutile_exact::number::parse_rational;
use malachite::Rational;

fn q(text: &str) -> Rational {
    parse_rational(text).expect("a number")
}

fn setting(theta: &str, lambda: &str) -> Setting {
    Setting {
        theta: q(theta),
        lambda: q(lambda),
    }
}

/// From mpmath with 30 digits, by other formulas: sides from the normals of the three planes, and the
/// apex from cos(apex/2) = cos(l/2) sin theta. The last number is m minus the sum of cosines.
const VALUES: [(&str, &str, &str, [&str; 5]); 5] = [
    (
        "0",
        "0",
        "0",
        [
            "-2.5970257457",
            "-15.582154474",
            "-1.7250772373",
            "3.4689742542",
            "-0.0742812170",
        ],
    ),
    (
        "1.5",
        "2.5",
        "3.5",
        [
            "3.3336024285",
            "9.1309484449",
            "1.6850327960",
            "4.3446024285",
            "0.0467464453",
        ],
    ),
    (
        "7.2",
        "0",
        "0",
        [
            "5.8311688355",
            "8.6810189410",
            "0.5356869705",
            "11.897168835",
            "0.0436059561",
        ],
    ),
    (
        "0",
        "7.2",
        "7.2",
        [
            "6.2399999999",
            "27.220047006",
            "3.8191374981",
            "0.1739999999",
            "0.1614931294",
        ],
    ),
    (
        "7.2",
        "7.2",
        "7.2",
        [
            "13.439999999",
            "41.108112217",
            "0.1408624244",
            "7.3739999999",
            "0.2793803026",
        ],
    ),
];

#[test]
fn values_agree_with_mpmath() {
    let targets = Setting::proved().targets().expect("targets");
    let close = |bounds: &acutile_exact::number::Interval, value: &str| {
        let width = q("2e-9");
        &bounds.hi - &bounds.lo < width
            && bounds.lo < q(value) + &width
            && bounds.hi > q(value) - &width
    };
    for (x, y, z, values) in VALUES {
        let excess = [q(x), q(y), q(z)];
        for (target, value) in targets.iter().zip(values) {
            let (found, spare) = target.at(&excess).expect("an enclosure");
            assert!(
                close(&found, value),
                "{} at {x}, {y}, {z}: {found:?}",
                target.id
            );
            assert!(close(&spare, values[4]), "{x}, {y}, {z}: {spare:?}");
        }
    }
}

fn verdict(theta: &str, lambda: &str, id: &str) -> Verdict {
    let targets = setting(theta, lambda).targets().expect("targets");
    let target = targets
        .iter()
        .find(|target| target.id == id)
        .expect("a target");
    target.check().verdict
}

/// On a grid of 73³ points the least values of uuu, utt and tt at 73.44 degrees are 0.43, 0.10 and
/// 0.17 (numpy). They become negative at larger angles and for other lambda.
#[test]
fn false_inequalities_are_refuted() {
    for (theta, lambda, id) in [
        ("73.75", "337/400", "x-above-60"),
        ("73.5", "337/400", "uuu"),
        ("73.46", "337/400", "utt"),
        ("73.44", "0.7", "utt"),
        ("73.44", "0.9", "tt"),
    ] {
        let verdict = verdict(theta, lambda, id);
        assert_eq!(verdict, Verdict::Fails, "{id} at {theta}, lambda {lambda}");
    }
}

#[test]
fn true_inequalities_at_smaller_angles_hold() {
    for id in ["x-above-60", "uuu", "utt", "tt"] {
        assert_eq!(verdict("73.3", "337/400", id), Verdict::Holds, "{id}");
    }
}

/// An angle for which the constants have no enclosure gives no verdict.
#[test]
fn an_impossible_angle_is_undecided() {
    let checks = setting("95", "1/2").checks(&|_| {});
    assert_eq!(checks.len(), 1);
    assert_eq!(checks[0].verdict, Verdict::Undecided);
}
