//! Identification of groups, and Wyckoff letters.

use acutile_crystal::identify::{differ_by_origin, identify};
use acutile_crystal::motion::{Motion, Vector};
use acutile_crystal::setting::{of_symbol, settings};
use acutile_crystal::symmetry::symmetry;
use acutile_crystal::wyckoff::wyckoff;
use malachite::Rational;

type Matrix = [Vector; 3];

fn q(n: i64, d: i64) -> Rational {
    Rational::from_signeds(n, d)
}

/// The mean of a general Gram matrix under the rotations of a group.
fn metric(group: &[Motion]) -> Matrix {
    let general = [[100, -13, 7], [-13, 121, 5], [7, 5, 169]].map(|row| row.map(Rational::from));
    let mut sum: Matrix = std::array::from_fn(|_| std::array::from_fn(|_| Rational::from(0)));
    for motion in group {
        let r = motion.rotation;
        for i in 0..3 {
            for j in 0..3 {
                for k in 0..3 {
                    for l in 0..3 {
                        sum[i][j] += Rational::from(r[k][i] * r[l][j]) * &general[k][l];
                    }
                }
            }
        }
    }
    sum
}

fn shifted(group: &[Motion], shift: &Vector) -> Vec<Motion> {
    let moved = |motion: &Motion| {
        let image = motion.apply(shift);
        // t + R v - v, the group seen from the origin v.
        Motion {
            rotation: motion.rotation,
            translation: std::array::from_fn(|k| &image[k] - &shift[k]),
        }
        .reduced()
    };
    let mut group: Vec<Motion> = group.iter().map(moved).collect();
    group.sort();
    group
}

/// The groups of all 530 settings have the number that the tables give, with other origins too.
#[test]
fn every_setting_is_identified() {
    for (index, setting) in settings().iter().enumerate() {
        let group = setting.group().expect("a group");
        let gram = metric(&group);
        let found = identify(&group, &gram).unwrap_or_else(|| panic!("{setting:?}"));
        assert_eq!(found.setting.number, setting.number, "{setting:?}");
        if index % 7 == 0 {
            let moved = shifted(&group, &[q(1, 10), q(23, 100), q(3, 7)]);
            let found = identify(&moved, &gram).unwrap_or_else(|| panic!("shifted {setting:?}"));
            assert_eq!(found.setting.number, setting.number, "{setting:?}");
        }
    }
}

#[test]
fn groups_that_differ_by_their_origin() {
    let group = |symbol: &str| {
        let found = of_symbol(symbol);
        found.settings[0].group().expect("a group")
    };
    let (first, second) = (group("F d -3 m :1"), group("F d -3 m :2"));
    assert_ne!(first, second);
    assert_eq!(differ_by_origin(&first, &second), Some(true));
    assert_eq!(
        differ_by_origin(&group("P n m a"), &group("P b n m")),
        Some(false)
    );
    let odd = shifted(&first, &[q(1, 10), q(0, 1), q(0, 1)]);
    assert_eq!(differ_by_origin(&odd, &first), None);
}

/// A15 (Cr3Si): Pm-3n with Si in 2a and Cr in 6c or 6d, which another origin exchanges. A supercell of
/// the conventional cell, shifted, has the same group.
#[test]
fn the_group_of_a15() {
    let atoms = [
        ([0, 0, 0], 0),
        ([2, 2, 2], 0),
        ([1, 0, 2], 1),
        ([3, 0, 2], 1),
        ([2, 1, 0], 1),
        ([2, 3, 0], 1),
        ([0, 2, 1], 1),
        ([0, 2, 3], 1),
    ];
    let cubic = |a: i64| -> Matrix {
        std::array::from_fn(|i| std::array::from_fn(|j| Rational::from(if i == j { a } else { 0 })))
    };
    let points: Vec<Vector> = atoms.iter().map(|(x, _)| x.map(|x| q(x, 4))).collect();
    let mut kinds: Vec<usize> = atoms.iter().map(|(_, kind)| *kind).collect();
    let found = symmetry(&cubic(1), &points, &kinds).expect("a group");
    assert_eq!(found.group.len(), 48);
    let identified = identify(&found.group, &found.gram).expect("a type");
    assert_eq!(identified.setting.number, 223);
    let letter = |point: &Vector| {
        let changed = std::array::from_fn(|i| {
            (0..3).fold(Rational::from(0), |sum, k| {
                sum + &found.change[i][k] * &point[k]
            })
        });
        let wyckoff = wyckoff(&identified, &changed).expect("a letter");
        (wyckoff.multiplicity, wyckoff.letter)
    };
    assert_eq!(letter(&points[0]), (2, 'a'));
    assert!(matches!(letter(&points[2]), (6, 'c' | 'd')));
    // Twice the cell along x, shifted by an odd vector.
    let copies: Vec<Vector> = points
        .iter()
        .flat_map(|x| {
            [0, 1].map(|n| {
                [
                    (&x[0] + q(n, 1)) / q(2, 1) + q(1, 13),
                    &x[1] + q(2, 7),
                    &x[2] + q(1, 9),
                ]
            })
        })
        .collect();
    let mut gram = cubic(1);
    gram[0][0] = Rational::from(4);
    let kinds_of_copies: Vec<usize> = kinds.iter().flat_map(|&kind| [kind, kind]).collect();
    let found = symmetry(&gram, &copies, &kinds_of_copies).expect("a group");
    let identified = identify(&found.group, &found.gram).expect("a type");
    assert_eq!((identified.setting.number, found.group.len()), (223, 48));
    // One atom of another kind in the cell: the group keeps its place, m-3.
    kinds[0] = 2;
    let found = symmetry(&cubic(1), &points, &kinds).expect("a group");
    let identified = identify(&found.group, &found.gram).expect("a type");
    assert_eq!((identified.setting.number, found.group.len()), (200, 24));
}
