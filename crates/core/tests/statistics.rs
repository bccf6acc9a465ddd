//! Figures of meshes against the paper, the literature and hand calculation.

use acutile_catalog::build;
use acutile_core::quality::rounded_nearest;
use acutile_core::statistics::{Statistics, csv, statistics};
use acutile_core::tiling::{Corner, Frame, SimplexId, Tiling};
use acutile_core::with_dimension;
use acutile_exact::number::{Number, parse_rational};

fn of(name: &str, bin: u32) -> Statistics {
    with_dimension!(&build(name).unwrap(), AnyTiling, t => statistics(t, bin).unwrap())
}

fn bin(statistics: &Statistics, from: u32) -> usize {
    statistics.histogram[(from / statistics.degrees_per_bin) as usize]
}

/// Table 1 of the paper, row A15: radius-edge ratio 0.645 to 0.707, dihedral angles from 53.13
/// to 78.46 degrees.
#[test]
fn a15_has_the_figures_of_the_paper() {
    let a15 = of("a15", 5);
    assert_eq!((a15.simplices, a15.kinds), (46, [46, 0, 0]));
    assert_eq!(a15.angles, [6 * 46, 0, 0]);
    assert_eq!(a15.histogram.iter().sum::<usize>(), 6 * 46);
    let [smallest, largest] = [a15.smallest.unwrap(), a15.largest.unwrap()];
    assert_eq!(rounded_nearest(&smallest.bounds.0, 2), "53.13");
    assert_eq!(rounded_nearest(&largest.bounds.1, 2), "78.46");
    let [low, high] = [a15.lowest_ratio.unwrap(), a15.highest_ratio.unwrap()];
    assert_eq!(rounded_nearest(&low.bounds.0, 3), "0.645");
    assert_eq!(rounded_nearest(&high.bounds.1, 3), "0.707");
}

/// Every tetrahedron of Sommerville II has two right angles and four of 60 degrees. 60 and 90 are ends of
/// bins, and the angles belong to the upper bins. All six angles tie.
#[test]
fn angles_at_the_ends_of_bins_are_in_the_upper_one() {
    for width in [30, 15, 5, 1] {
        let bcc = of("bcc", width);
        let n = bcc.simplices;
        assert_eq!((bin(&bcc, 60), bin(&bcc, 90)), (4 * n, 2 * n), "{width}");
        assert_eq!(bcc.kinds, [0, n, 0]);
        assert_eq!(bcc.smallest.unwrap().count, 4 * n);
        assert_eq!(bcc.largest.unwrap().count, 2 * n);
    }
}

/// The square in 14 triangles has angles of exactly 72 degrees and none above.
#[test]
fn angles_of_exactly_72_degrees() {
    let square = of("square-14", 36);
    let largest = square.largest.clone().unwrap();
    assert_eq!(largest.closed_form.as_deref(), Some("72"));
    assert_eq!(bin(&square, 72), largest.count);
    assert_eq!(square.histogram.iter().sum::<usize>(), 3 * 14);
}

#[test]
fn the_regular_tetrahedron_has_aspect_ratio_one() {
    let [low, high] = of("regular", 5).aspects.unwrap();
    assert!((low.0 - 1.0).abs() < 1e-12 && (high.0 - 1.0).abs() < 1e-12);
    let equilateral = of("equilateral", 5).aspects.unwrap();
    assert!((equilateral[0].0 - 1.0).abs() < 1e-12);
}

fn one(corners: [[&str; 3]; 4]) -> Statistics {
    let number = |text: &str| Number::from(parse_rational(text).unwrap());
    let tiling = Tiling {
        frame: Frame::cubic(),
        vertices: corners.map(|point| point.map(number)).to_vec().into(),
        corners: (0..4).map(Corner::of).collect(),
    };
    statistics(&tiling, 5).unwrap()
}

/// The corner of a cube: three right angles, and three of arctan √2 = 54.7356.
#[test]
fn the_corner_of_a_cube() {
    let corner = one([
        ["0", "0", "0"],
        ["1", "0", "0"],
        ["0", "1", "0"],
        ["0", "0", "1"],
    ]);
    assert_eq!((corner.kinds, corner.angles), ([0, 1, 0], [3, 3, 0]));
    let smallest = corner.smallest.clone().unwrap();
    assert_eq!(rounded_nearest(&smallest.bounds.0, 4), "54.7356");
    assert_eq!(smallest.count, 3);
    assert!(csv(&corner).contains("\n50,55,3\n") && csv(&corner).contains("\n90,95,3\n"));
}

/// A sliver with huge and tiny coordinates: nothing is lost, and the obtuse angles count.
#[test]
fn slivers_and_flat_ones() {
    let height = format!("1/1{}", "0".repeat(40));
    let sliver = one([
        ["0", "0", "0"],
        ["1", "0", "0"],
        ["0", "1", "0"],
        ["1", "1", &height],
    ]);
    assert_eq!((sliver.kinds, sliver.left_out.len()), ([0, 0, 1], 0));
    assert_eq!(sliver.histogram.iter().sum::<usize>(), 6);
    let size = format!("1{}", "0".repeat(200));
    let huge = one([
        ["0", "0", "0"],
        [&size, "0", "0"],
        ["0", &size, "0"],
        ["0", "0", &size],
    ]);
    assert_eq!((huge.kinds, huge.angles), ([0, 1, 0], [3, 3, 0]));
    assert_eq!(bin(&huge, 90), 3);
    let flat = one([
        ["0", "0", "0"],
        ["1", "0", "0"],
        ["0", "1", "0"],
        ["1", "1", "0"],
    ]);
    assert_eq!(
        (flat.left_out, flat.kinds),
        (vec![SimplexId::new(0)], [0, 0, 0])
    );
}

/// A metric that is not positive definite has no angles; it used to end in a panic.
#[test]
fn without_a_positive_metric_there_are_no_figures() {
    let zero = || Number::zero();
    for (entry, code) in [("0", 1), ("-1", 1), ("1", 0)] {
        let mut tiling = with_one_corner();
        tiling.frame.gram[2] = [zero(), zero(), Number::from(parse_rational(entry).unwrap())];
        let counts = statistics(&tiling, 5).map_or_else(|e| e.counts().clone(), |_| [].into());
        assert_eq!(
            counts.get("metric-not-positive").copied().unwrap_or(0),
            code
        );
    }
}

fn with_one_corner() -> Tiling<3> {
    let number = |entry: u32| Number::from(parse_rational(&entry.to_string()).unwrap());
    let corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]];
    Tiling {
        frame: Frame::cubic(),
        vertices: corners.map(|point| point.map(number)).to_vec().into(),
        corners: (0..4).map(Corner::of).collect(),
    }
}
