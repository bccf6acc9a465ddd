//! Figures against an oracle that solves for the point of a line of sight, against the literature, and
//! against the paper. Their files are read by other programs.

use crate::well_formed::well_formed;
use acutile_catalog::build;
use acutile_exact::number::Number;
use acutile_publish::draw::drawing::Item;
use acutile_publish::draw::order::painted;
use acutile_publish::draw::polygon::{Face, Point, on_segment};
use acutile_publish::draw::svg::svg;
use acutile_publish::draw::tikz::tikz;
use acutile_publish::draw::{DrawError, Drawing, Figure, Options, draw, hidden};
use malachite::Rational;
use num_rational::Ratio;
use num_traits::{One, Signed, Zero};
use std::process::Command;

type Fraction = Ratio<i128>;
type Exact = [Fraction; 3];

fn number(n: i64) -> Number {
    Number::from(Rational::from(n))
}

fn point(p: [i64; 3]) -> Point {
    p.map(number)
}

fn exact(p: &Point) -> Exact {
    p.each_ref()
        .map(|x| x.to_rational().unwrap().to_string().parse().unwrap())
}

fn determinant([a, b, c]: [Exact; 3]) -> Fraction {
    a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
        + a[2] * (b[0] * c[1] - b[1] * c[0])
}

/// The t, β, γ with p + t v = a + β (b - a) + γ (c - a), by Cramer's rule.
fn sight(p: Exact, v: Exact, [a, b, c]: [Exact; 3]) -> Option<[Fraction; 3]> {
    let minus = |x: Exact, y: Exact| -> Exact { std::array::from_fn(|k| x[k] - y[k]) };
    let (u, w, r) = (minus(b, a), minus(c, a), minus(p, a));
    let back = v.map(|x| -x);
    let d = determinant([back, u, w]);
    (!d.is_zero()).then(|| {
        [
            determinant([r, u, w]) / d,
            determinant([back, r, w]) / d,
            determinant([back, u, r]) / d,
        ]
    })
}

/// Whether the triangle is before p, its sides included or not.
fn hides(p: Exact, v: Exact, triangle: [Exact; 3], with_sides: bool) -> bool {
    sight(p, v, triangle).is_some_and(|[t, beta, gamma]| {
        let least = beta.min(gamma).min(Fraction::one() - beta - gamma);
        t.is_positive() && (least.is_positive() || with_sides && least.is_zero())
    })
}

/// Small pseudo-random integers.
struct Dice(u64);

impl Dice {
    fn roll(&mut self, size: i64) -> i64 {
        self.0 = self
            .0
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        ((self.0 >> 33) % (2 * size as u64 + 1)) as i64 - size
    }

    fn point(&mut self, size: i64) -> [i64; 3] {
        std::array::from_fn(|_| self.roll(size))
    }
}

/// Random triangles, those that are seen as segments left out.
fn triangles(dice: &mut Dice, count: usize, size: i64, eye: &Point) -> Vec<([Exact; 3], Face)> {
    (0..count)
        .filter_map(|_| {
            let corners = [(); 3].map(|_| point(dice.point(size)));
            let exact = corners.each_ref().map(exact);
            Some((exact, Face::triangle(corners, eye)?))
        })
        .collect()
}

/// Sizes are small so that vertices behind edges, and planes through points, occur.
#[test]
fn every_part_of_a_line_is_as_hidden_as_points_of_it_are() {
    let mut dice = Dice(1);
    let [mut visible, mut covered] = [0, 0];
    for round in 0..60 {
        let eye = point([[1, 2, 3], [0, 0, 1], [3, -1, 0]][round % 3]);
        let (triangles, faces): (Vec<_>, Vec<_>) =
            triangles(&mut dice, 6, 4, &eye).into_iter().unzip();
        let [a, b] = [(); 2].map(|_| point(dice.point(4)));
        if a == b {
            continue;
        }
        let parts = hidden::parts(&a, &b, &faces, &eye);
        let ends: Vec<&Number> = parts.iter().flat_map(|p| [&p.from, &p.to]).collect();
        assert_eq!((ends[0], ends[ends.len() - 1]), (&number(0), &number(1)));
        assert!(
            ends[1..ends.len() - 1]
                .chunks(2)
                .all(|pair| pair[0] == pair[1])
        );
        for part in &parts {
            assert!(part.from < part.to);
            for k in 1..12 {
                let weight = Number::from(Rational::from_signeds(k, 12));
                let s = on_segment(
                    &[part.from.clone(), number(0), number(0)],
                    &[part.to.clone(), number(0), number(0)],
                    &weight,
                );
                let p = exact(&on_segment(&a, &b, &s[0]));
                let is_hidden = triangles.iter().any(|t| hides(p, exact(&eye), *t, true));
                assert_eq!(is_hidden, !part.is_visible, "round {round}: {parts:?}");
                *(if is_hidden {
                    &mut covered
                } else {
                    &mut visible
                }) += 1;
            }
        }
    }
    assert!(visible > 200 && covered > 200, "{visible} {covered}");
}

#[test]
fn points_are_visible_where_no_triangle_is_before_them() {
    let mut dice = Dice(7);
    let mut counts = [0, 0];
    for _ in 0..200 {
        let eye = point([2, -1, 3]);
        let (triangles, faces): (Vec<_>, Vec<_>) =
            triangles(&mut dice, 4, 3, &eye).into_iter().unzip();
        let p = point(dice.point(3));
        let is_hidden = triangles
            .iter()
            .any(|t| hides(exact(&p), exact(&eye), *t, true));
        assert_eq!(hidden::is_visible(&p, &faces), !is_hidden);
        counts[usize::from(is_hidden)] += 1;
    }
    assert!(counts[0] > 20 && counts[1] > 20, "{counts:?}");
}

/// Twice the area of the projection along z.
fn area(corners: &[Point]) -> Fraction {
    let exact: Vec<Exact> = corners.iter().map(exact).collect();
    let next = exact.iter().cycle().skip(1);
    let sum: Fraction = exact
        .iter()
        .zip(next)
        .map(|(p, q)| p[0] * q[1] - p[1] * q[0])
        .sum();
    sum.abs()
}

/// No piece is before a point of one that is painted later, and each face is painted wholly.
fn check_painting(faces: &[Face]) -> usize {
    let eye = exact(&point([0, 0, 1]));
    let pieces = painted(faces).unwrap();
    for (i, piece) in pieces.iter().enumerate() {
        let corners: Vec<Exact> = piece.corners.iter().map(exact).collect();
        for k in 1..corners.len() - 1 {
            for weights in [[1, 1, 1], [4, 1, 1], [1, 4, 1], [1, 1, 4], [9, 9, 1]] {
                let total: i128 = weights.iter().sum();
                let p: Exact = std::array::from_fn(|x| {
                    (corners[0][x] * weights[0]
                        + corners[k][x] * weights[1]
                        + corners[k + 1][x] * weights[2])
                        / total
                });
                for earlier in &pieces[..i] {
                    let e: Vec<Exact> = earlier.corners.iter().map(exact).collect();
                    let covers =
                        (1..e.len() - 1).any(|m| hides(p, eye, [e[0], e[m], e[m + 1]], false));
                    assert!(!covers, "{earlier:?} is before {piece:?}");
                }
            }
        }
    }
    for (index, face) in faces.iter().enumerate() {
        let parts = pieces.iter().filter(|piece| piece.face == index);
        let sum: Fraction = parts.map(|piece| area(&piece.corners)).sum();
        assert_eq!(sum, area(&face.corners));
    }
    pieces.len()
}

/// Three beams, each over the next one: no order of the whole triangles is right.
#[test]
fn a_cycle_of_faces_is_cut() {
    let eye = point([0, 0, 1]);
    // Long thin triangles round a middle, each rising along its length.
    let beams = [
        [[-6, -2, 0], [6, -2, 4], [6, -3, 4]],
        [[3, -6, 0], [0, 6, 4], [1, 6, 4]],
        [[3, 6, 0], [-6, -5, 4], [-6, -6, 4]],
    ];
    let faces: Vec<Face> = beams
        .iter()
        .filter_map(|beam| Face::triangle(beam.map(point), &eye))
        .collect();
    assert_eq!(faces.len(), 3);
    assert!(check_painting(&faces) > 3, "no cut was needed");
}

#[test]
fn faces_that_cross_are_cut() {
    let mut dice = Dice(3);
    let eye = point([0, 0, 1]);
    for _ in 0..12 {
        let (_, faces): (Vec<_>, Vec<_>) = triangles(&mut dice, 5, 5, &eye).into_iter().unzip();
        check_painting(&faces);
    }
}

/// Three hundred random triangles in a ball cut one another into more pieces than the limit; a
/// file may hold such.
#[test]
fn too_many_pieces_are_refused() {
    let mut dice = Dice(11);
    let eye = point([1, 2, 3]);
    let (_, faces): (Vec<_>, Vec<_>) = triangles(&mut dice, 300, 40, &eye).into_iter().unzip();
    assert!(painted(&faces).is_none());
}

fn figure(name: &str, figure: Figure) -> Drawing {
    draw(name, &build(name).unwrap(), figure, &Options::default()).unwrap()
}

/// The words on edges or corners with their places, in the order of classes.
fn angles(drawing: &Drawing) -> Vec<(String, [f64; 2])> {
    let label = |item: &Item| match item {
        Item::Label {
            at,
            text,
            has_halo: true,
        } if text.ends_with('°') => Some((text.clone(), *at)),
        _ => None,
    };
    drawing.items.iter().filter_map(label).collect()
}

fn sorted(labels: &[(String, [f64; 2])]) -> Vec<&str> {
    let mut texts: Vec<&str> = labels.iter().map(|(text, _)| text.as_str()).collect();
    texts.sort_unstable();
    texts
}

/// The tetrahedra of A15 between two icosahedra-free vertices have arccos(3/5) = 53.13° twice
/// and arccos(1/5) = 78.46° four times; the paper's Table 1 has these as its extremes.
#[test]
fn a15_has_the_angles_of_the_literature() {
    let drawing = figure("a15", Figure::Classes);
    let all = angles(&drawing);
    assert_eq!(all.len(), 3 * 6);
    let expected = ["53.13°", "53.13°", "78.46°", "78.46°", "78.46°", "78.46°"];
    assert!(
        all.chunks(6).any(|class| sorted(class) == expected),
        "{all:?}"
    );
    let degrees = |text: &str| text.trim_end_matches('°').parse::<f64>().unwrap();
    assert!(
        all.iter()
            .all(|(text, _)| (53.13..=78.46).contains(&degrees(text)))
    );
}

/// Sommerville II has right angles at two edges, and 60 degrees at the others.
#[test]
fn bcc_has_two_right_angles() {
    let drawing = figure("bcc", Figure::Classes);
    let all = angles(&drawing);
    assert_eq!(sorted(&all), ["60°", "60°", "60°", "60°", "90°", "90°"]);
}

/// The middle of no label is nearer to an edge than its letters are high, and each tetrahedron has the names of its corners.
#[test]
fn labels_are_off_the_edges() {
    for (name, classes) in [
        ("a15", 3),
        ("bcc", 1),
        ("c15", 3),
        ("slab", 7),
        ("icosahedral", 5),
    ] {
        let drawing = figure(name, Figure::Classes);
        let lines = drawing.items.iter().filter_map(|item| match item {
            Item::Line { ends, .. } => Some(*ends),
            _ => None,
        });
        let lines: Vec<[[f64; 2]; 2]> = lines.collect();
        let mut corners = 0;
        for item in &drawing.items {
            let Item::Label { at, text, .. } = item else {
                continue;
            };
            corners += usize::from(["0", "1", "2", "3"].contains(&text.as_str()));
            let near = lines.iter().map(|line| distance(*at, line));
            let near = near.fold(f64::INFINITY, f64::min);
            assert!(near > 0.9, "{name}: {text} is {near} mm from an edge");
        }
        assert_eq!(corners, 4 * classes, "{name}");
    }
}

/// Of a point from a segment.
fn distance(p: [f64; 2], [a, b]: &[[f64; 2]; 2]) -> f64 {
    let (along, from) = ([b[0] - a[0], b[1] - a[1]], [p[0] - a[0], p[1] - a[1]]);
    let square = (along[0] * along[0] + along[1] * along[1]).max(1e-12);
    let s = ((along[0] * from[0] + along[1] * from[1]) / square).clamp(0.0, 1.0);
    (from[0] - s * along[0]).hypot(from[1] - s * along[1])
}

/// The angles of a triangle add up to 180 degrees; rounding changes each by at most 0.005.
#[test]
fn angles_of_triangles_add_up() {
    for name in ["square-8", "square-10", "square-14", "equilateral"] {
        let drawing = figure(name, Figure::Classes);
        let all = angles(&drawing);
        assert!(!all.is_empty());
        for class in all.chunks(3) {
            let degrees = class
                .iter()
                .map(|(text, _)| text.trim_end_matches('°').parse::<f64>());
            let sum: f64 = degrees.map(Result::unwrap).sum();
            assert!((sum - 180.0).abs() < 0.0151, "{name}: {class:?}");
        }
    }
}

/// Labels are written 7 points high; none of one panel lies on another.
#[test]
fn labels_do_not_lie_on_one_another() {
    for name in [
        "a15",
        "sigma",
        "c15",
        "icosahedral",
        "slab",
        "bcc",
        "cube-5",
        "square-8",
        "square-10",
        "square-14",
    ] {
        let drawing = figure(name, Figure::Classes);
        let all = angles(&drawing);
        for (i, (text, a)) in all.iter().enumerate() {
            for (other, b) in &all[..i] {
                let apart = [(a[0] - b[0]).abs() / 7.0, (a[1] - b[1]).abs() / 2.3];
                assert!(
                    apart[0].max(apart[1]) > 1.0,
                    "{name}: {text} at {a:?}, {other} at {b:?}"
                );
            }
        }
    }
}

/// Nine squares: 24 sides with one dot each, four dots inside of each square, 16 corners; by hand
/// from section 4.1. And as many black dots as white ones, with those of the legend.
#[test]
fn the_square_tiling_has_its_dots() {
    let drawing = figure("a15", Figure::Plane);
    let count = |wanted: f64| {
        let dots = drawing.items.iter();
        dots.filter(|item| matches!(item, Item::Dot { radius, .. } if *radius == wanted))
            .count()
    };
    assert_eq!((count(0.8), count(0.5)), (24 + 36, 16));
    let coloured = |wanted: [u8; 3]| {
        let dots = drawing.items.iter();
        dots.filter(|item| matches!(item, Item::Dot { fill, .. } if *fill == wanted))
            .count()
    };
    assert_eq!(coloured([0; 3]), 30 + 1);
    assert_eq!(coloured([255; 3]), 30 + 1);
}

/// Every figure that there is of some tilings.
fn figures() -> Vec<Drawing> {
    use Figure::{Cell, Classes, Plane, Star, Steps};
    let space = [Classes, Cell, Star];
    let mut figures = Vec::new();
    for name in ["a15", "c15", "icosahedral", "cube-5", "bcc", "slab"] {
        figures.extend(space.map(|kind| figure(name, kind)));
    }
    figures.extend(["square-8", "square-14", "a15", "sigma"].map(|name| figure(name, Plane)));
    figures.push(figure("slab", Steps));
    figures
}

/// Everything lies on the paper, and the same input gives the same bytes.
#[test]
fn figures_fit_and_are_the_same_again() {
    for drawing in figures() {
        let [width, height] = drawing.size;
        assert_eq!(width, 84.0);
        for item in &drawing.items {
            let places = match item {
                Item::Polygon { corners, .. } => corners.clone(),
                Item::Line { ends, .. } => ends.to_vec(),
                Item::Dot { at, .. } | Item::Label { at, .. } => vec![*at],
            };
            for [x, y] in places {
                let fits = (0.0..=width).contains(&x) && (0.0..=height).contains(&y);
                assert!(fits, "{}: {x} {y}", drawing.title);
            }
        }
        well_formed(&svg(&drawing));
    }
    let [first, second] = [(); 2].map(|_| svg(&figure("slab", Figure::Steps)));
    assert_eq!(first, second);
}

const NASTY: &str = "a<b>&\"c\" \\input{x} 100% #$_^~\n\u{0}é]]>";

#[test]
fn names_are_escaped() {
    let drawing = draw(
        NASTY,
        &build("bcc").unwrap(),
        Figure::Cell,
        &Options::default(),
    )
    .unwrap();
    let text = svg(&drawing);
    well_formed(&text);
    assert!(
        text.contains("<title>a&lt;b&gt;&amp;\"c\" \\input{x} 100% #$_^~  é]]&gt;: cell</title>")
    );
    let first = tikz(&drawing, false);
    let first = first.lines().next().unwrap();
    assert!(
        first.starts_with("% a<b>") && first.contains("\\input{x}"),
        "{first}"
    );
}

#[test]
#[ignore = "needs pdflatex with TikZ"]
fn tikz_compiles() {
    let folder = tempfile::tempdir().unwrap();
    let mut nasty = figure("bcc", Figure::Cell);
    nasty.title = NASTY.to_owned();
    nasty.items.push(Item::Label {
        at: [40.0, 20.0],
        text: NASTY.to_owned(),
        has_halo: true,
    });
    let drawings = [
        nasty,
        figure("a15", Figure::Plane),
        figure("a15", Figure::Classes),
        figure("sigma", Figure::Plane),
        figure("slab", Figure::Steps),
    ];
    for drawing in &drawings {
        let path = folder.path().join("figure.tex");
        std::fs::write(&path, tikz(drawing, true)).unwrap();
        let run = Command::new("pdflatex")
            .args(["-interaction=nonstopmode", "-halt-on-error", "figure.tex"])
            .current_dir(folder.path())
            .output()
            .unwrap();
        let log = String::from_utf8_lossy(&run.stdout).into_owned();
        assert!(run.status.success(), "{}: {log}", drawing.title);
        assert!(log.contains("(1 page"), "{log}");
        assert!(!log.contains("Overfull"), "{log}");
    }
}

#[test]
fn what_cannot_be_drawn_is_refused() {
    let refusal = |name: &str, kind: Figure, options: &Options| {
        draw(name, &build(name).unwrap(), kind, options).unwrap_err()
    };
    let usual = Options::default();
    assert!(matches!(
        refusal("a15", Figure::Steps, &usual),
        DrawError::NoSteps
    ));
    assert!(matches!(
        refusal("bcc", Figure::Plane, &usual),
        DrawError::NoPlane
    ));
    assert!(matches!(
        refusal("square-8", Figure::Star, &usual),
        DrawError::NotSolid
    ));
    let far = Options {
        vertex: 8,
        ..usual.clone()
    };
    assert!(matches!(
        refusal("a15", Figure::Star, &far),
        DrawError::NoVertex(8, 8)
    ));
    for direction in [[0.0; 3], [f64::NAN, 0.0, 1.0], [f64::INFINITY, 0.0, 0.0]] {
        let nowhere = Options {
            direction,
            ..usual.clone()
        };
        assert!(matches!(
            refusal("a15", Figure::Cell, &nowhere),
            DrawError::NoDirection
        ));
    }
}

/// Along an axis many edges are seen end on, and faces as segments.
#[test]
fn views_along_axes_are_drawn() {
    for direction in [
        [1.0, 0.0, 0.0],
        [0.0, 0.0, 1.0],
        [0.0, 0.0, -1.0],
        [1.0, 1.0, 0.0],
    ] {
        for name in ["a15", "cube-5", "bcc"] {
            let options = Options {
                direction,
                ..Options::default()
            };
            let tiling = build(name).unwrap();
            for kind in [Figure::Cell, Figure::Star] {
                well_formed(&svg(&draw(name, &tiling, kind, &options).unwrap()));
            }
        }
    }
}
