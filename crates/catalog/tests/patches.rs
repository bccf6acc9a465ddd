//! Systems of patches against the Delaunay triangulations of single tilings.

use acutile_catalog::patches::{kagome_all, square_triangle_all};
use acutile_catalog::plane_tiling::{
    Cyclotomic, POWERS, PlaneTiling, built_in, scaled, sum, times,
};
use acutile_catalog::{build, theorem};
use acutile_core::limits::own_limits;
use acutile_core::patches::{System, Tile, prove};
use acutile_core::quality::Exact;
use acutile_core::statement::{Relation, Statement};
use acutile_core::tiling::{AnyTiling, Corner, floor};
use acutile_exact::number::Number;
use malachite::Rational;
use std::collections::{BTreeMap, BTreeSet};

#[test]
fn counts_of_pieces() {
    // 20 T + 46 Q = 11 T + 34 Q + 6 E for T triangles, Q squares and E = (3 T + 4 Q)/2 edges.
    let sizes = |system: System| -> Vec<(usize, Vec<usize>)> {
        let tiles = system.tiles.iter();
        tiles
            .map(|tile| {
                let polygons = tile.patch.pyramids.iter().map(|p| p.polygon.len());
                (tile.patch.simplices.len(), polygons.collect())
            })
            .collect()
    };
    let system = square_triangle_all().unwrap();
    assert_eq!(sizes(system), [(11, vec![6; 3]), (34, vec![6; 4])]);
    // 17 for a Laves block and 40 for a block of Z: half a layer's hexagon of 6 each.
    let system = kagome_all().unwrap();
    let expected = [(34, vec![6; 2]), (28, vec![6; 2]), (28, vec![6; 2])];
    assert_eq!(sizes(system), expected);
}

#[test]
fn the_kernel_confirms_the_theorems() {
    // arccos(1/5) for squares and triangles; 77.079 degrees, as in Z, for kagome layers.
    for (name, square) in [("square-triangle-all", (1, 25)), ("kagome-all", (1, 20))] {
        let system = (theorem(name).unwrap().system)().unwrap();
        let theorem = prove(&system, &own_limits()).unwrap();
        let statements = theorem.statements();
        assert!(statements.contains(&Statement::Acute), "{name}");
        assert!(statements.contains(&Statement::Delaunay), "{name}");
        assert!(statements.contains(&Statement::Tcp), "{name}");
        let largest = statements.iter().find_map(|statement| match statement {
            Statement::LargestAngle(Relation::Maximum, angle) => Some(angle),
            _ => None,
        });
        let square = Number::from(Rational::from_signeds(square.0, square.1));
        assert_eq!(largest.unwrap().signed_square, square, "{name}");
        assert!(largest.unwrap().closed_form().is_some());
    }
}

/// Points of a periodic structure.
trait Period {
    type Point: Clone + Ord;

    /// The translation that moves a point into the first cell, applied to another point.
    fn moved(&self, base: &Self::Point, point: &Self::Point) -> Self::Point;

    /// A set of points, the same for translates.
    fn name(&self, points: &[Self::Point]) -> (Vec<Self::Point>, Self::Point) {
        let moved = points.iter().map(|base| {
            let mut moved: Vec<_> = points.iter().map(|x| self.moved(base, x)).collect();
            moved.sort_unstable();
            (moved, base.clone())
        });
        moved.min().unwrap()
    }
}

/// A tile, and the place of each corner of its patch over the plane.
type Placed<'t, P> = (&'t Tile, Box<dyn Fn(&Corner<3>) -> P + 't>);

/// A polygon, and an apex over it.
type Cone<P> = (Vec<P>, P);

/// The cells over some tiles; `place` gives the points of a corner of a tile.
fn assembled<P: Period>(period: &P, tiles: &[Placed<'_, P::Point>]) -> BTreeSet<Vec<P::Point>> {
    let mut cells = BTreeSet::new();
    let mut add = |points: &[P::Point]| assert!(cells.insert(period.name(points).0));
    let mut apexes: BTreeMap<Vec<P::Point>, Cone<P::Point>> = BTreeMap::new();
    for (tile, place) in tiles {
        for row in &tile.patch.simplices {
            add(&row.each_ref().map(place));
        }
        for pyramid in &tile.patch.pyramids {
            let polygon: Vec<_> = pyramid.polygon.iter().map(place).collect();
            let (name, base) = period.name(&polygon);
            let polygon: Vec<_> = polygon.iter().map(|x| period.moved(&base, x)).collect();
            let apex = period.moved(&base, &place(&pyramid.apex));
            let Some((_, other)) = apexes.remove(&name) else {
                apexes.insert(name, (polygon, apex));
                continue;
            };
            for (k, corner) in polygon.iter().enumerate() {
                let next = &polygon[(k + 1) % polygon.len()];
                add(&[corner.clone(), next.clone(), apex.clone(), other.clone()]);
            }
        }
    }
    assert!(apexes.is_empty(), "a pyramid is alone");
    cells
}

/// The place in the plane, times 12, and the height in quarters of the period.
type Lifted = (Cyclotomic, i64);

struct OverPlane(PlaneTiling);

impl Period for OverPlane {
    type Point = Lifted;

    fn moved(&self, base: &Lifted, point: &Lifted) -> Lifted {
        let shift = sum(self.0.residue(base.0), scaled(base.0, -1));
        (sum(point.0, shift), point.1 - 4 * base.1.div_euclid(4))
    }
}

/// 12 (a + b √3), with √3 = 2 z - z³.
fn cyclotomic(x: &Number) -> Cyclotomic {
    let part = |k: usize| {
        let c = x.coefficients().get(k).cloned().unwrap_or_default();
        i64::try_from(&(c * Rational::from(12))).unwrap()
    };
    let (a, b) = (part(0), part(1));
    [a, 2 * b, 0, -b]
}

fn over_plane(system: &System, plane: &PlaneTiling) -> BTreeSet<Vec<Lifted>> {
    let stars = plane.stars().unwrap();
    let mut tiles: Vec<Placed<'_, Lifted>> = Vec::new();
    for (vertex, star) in plane.vertices.iter().zip(&stars) {
        for corner in star {
            let (k, is_square) = (corner.direction, corner.is_square());
            // One corner of each triangle, and one of each square.
            if k >= if is_square { 3 } else { 4 } {
                continue;
            }
            let tile = &system.tiles[usize::from(is_square)];
            let place = move |corner: &Corner<3>| {
                let [h, x, y] = &tile.patch.vertices[corner.vertex.index()];
                let flat = sum(cyclotomic(x), times(cyclotomic(y), POWERS[3]));
                let quarters = cyclotomic(h)[0] / 3 + 4 * i64::from(corner.shift[0]);
                // White sides are half a period higher.
                let lift = 2 * (k as i64 % 2);
                (
                    sum(scaled(*vertex, 12), times(flat, POWERS[k])),
                    quarters + lift,
                )
            };
            tiles.push((tile, Box::new(place)));
        }
    }
    assembled(&OverPlane(scaled_plane(plane)), &tiles)
}

fn scaled_plane(plane: &PlaneTiling) -> PlaneTiling {
    PlaneTiling {
        lattice: plane.lattice.map(|x| scaled(x, 12)),
        vertices: Vec::new(),
    }
}

fn delaunay_over_plane(plane: &PlaneTiling) -> BTreeSet<Vec<Lifted>> {
    let points = plane.points().unwrap();
    let set = plane.point_set().unwrap();
    let tiling = plane.structure().unwrap();
    let period = OverPlane(scaled_plane(plane));
    let [a, b] = period.0.lattice;
    let place = |corner: &Corner<3>| {
        let vertex = corner.vertex.index();
        let (place, height) = points[vertex];
        // A vertex of the triangulation may be another translate of its point.
        let [s, t, u] = std::array::from_fn(|k| {
            let moved = &tiling.vertices.vertex(corner.vertex)[k] - &set.points[vertex][k];
            i64::from(floor(&moved).unwrap() + corner.shift[k])
        });
        (sum(place, sum(scaled(a, s), scaled(b, t))), height + 4 * u)
    };
    let cells = tiling.simplices();
    cells
        .map(|row| period.name(&row.iter().map(place).collect::<Vec<_>>()).0)
        .collect()
}

/// Rows of squares and of triangles, one over the other.
fn strips(word: &str) -> PlaneTiling {
    let (mut at, mut vertices) = ([0; 4], Vec::new());
    for letter in word.chars() {
        vertices.push(at);
        at = sum(at, POWERS[if letter == 'S' { 3 } else { 2 }]);
    }
    PlaneTiling {
        lattice: [POWERS[0], at],
        vertices,
    }
}

#[test]
fn the_patches_are_delaunay_triangulations_over_squares_and_triangles() {
    let system = square_triangle_all().unwrap();
    let names = [
        "3",
        "4",
        "33344",
        "32434",
        "3464",
        "inflated-3",
        "inflated-4",
    ];
    let words = [
        "SST",
        "STT",
        "SSST",
        "SSTT",
        "STTT",
        "SSSST",
        "SSSTT",
        "SSTST",
        "SSTTT",
        "STSTT",
        "STTTT",
        "SSSTST",
        "SSTSTT",
        "STTSTTT",
        "SSTTSTSTT",
    ];
    let planes = names.iter().map(|name| (*name, built_in(name).unwrap()));
    let planes: Vec<_> = planes
        .chain(words.iter().map(|word| (*word, strips(word))))
        .collect();
    assert!(planes.len() >= 20);
    for (name, plane) in planes {
        let delaunay = delaunay_over_plane(&plane);
        assert_eq!(over_plane(&system, &plane), delaunay, "{name}");
    }
}

/// Fractional coordinates, as texts, after integer parts.
struct OverLattice;

type Fractional = ([i32; 3], [String; 3]);

impl Period for OverLattice {
    type Point = Fractional;

    fn moved(&self, base: &Fractional, point: &Fractional) -> Fractional {
        let shift = std::array::from_fn(|k| point.0[k] - base.0[k]);
        (shift, point.1.clone())
    }
}

fn fractional(point: [Number; 3]) -> Fractional {
    let floors = point
        .each_ref()
        .map(|x| floor(x).expect("a point near the origin"));
    let rests = std::array::from_fn(|k| {
        let whole = Number::from(Rational::from(floors[k]));
        (&point[k] - &whole).to_string()
    });
    (floors, rests)
}

#[test]
fn the_patches_are_delaunay_triangulations_of_kagome_words() {
    let system = kagome_all().unwrap();
    for word in [
        "z", "+", "-", "+-", "z+", "z-", "++--", "z+z-", "zz+", "z++", "+-z", "z+-z--",
    ] {
        let AnyTiling::Space(tiling) = build(&format!("kagome:{word}")).unwrap() else {
            panic!("{word}")
        };
        let delaunay: BTreeSet<_> = tiling
            .simplices()
            .map(|row| {
                let points: Vec<_> = row.iter().map(|c| fractional(tiling.position(c))).collect();
                OverLattice.name(&points).0
            })
            .collect();
        assert_eq!(stacked(&system, word), delaunay, "{word}");
    }
}

/// The cells of a word, in the basis of two plane vectors and the one to the next period.
fn stacked(system: &System, word: &str) -> BTreeSet<Vec<Fractional>> {
    let third = |n: i64| Number::from(Rational::from_signeds(n, 3));
    let blocks: Vec<&Tile> = word
        .chars()
        .map(|letter| &system.tiles["z+-".find(letter).unwrap()])
        .collect();
    let (mut registry, mut height) = (0_i64, Number::zero());
    let mut starts = Vec::new();
    for (block, letter) in blocks.iter().zip(word.chars()) {
        starts.push((registry, height.clone()));
        registry += match letter {
            'z' => 0,
            '+' => 1,
            _ => -1,
        };
        height = &height + &block.corners[1][0];
    }
    let lean = registry.rem_euclid(3);
    let mut tiles: Vec<Placed<'_, Fractional>> = Vec::new();
    for (tile, (registry, start)) in blocks.into_iter().zip(starts) {
        let height = &height;
        let place = move |corner: &Corner<3>| {
            let [x, y, h] = &tile.patch.vertices[corner.vertex.index()];
            let t = (h + &start).divide(height).unwrap();
            let flat = |x: &Number, k: i64| {
                let shift = Number::from(Rational::from(corner.shift[k as usize - 1]));
                let moved = &(x + &shift) + &third(k * registry);
                &moved - &(&t * &third(k * lean))
            };
            let (x, y) = (flat(x, 1), flat(y, 2));
            fractional([x, y, t])
        };
        tiles.push((tile, Box::new(place)));
    }
    assembled(&OverLattice, &tiles)
}

#[test]
fn tilings_can_be_inflated_again() {
    // The area grows by (2 + √3)² each time: 7 + 4 √3 for triangles of √3/4 and squares of 1.
    // From T triangles and Q squares come 7 T + 16 Q triangles and 3 T + 7 Q squares.
    let counts = |name: &str| {
        let stars = built_in(name).unwrap().stars().unwrap();
        let corners = stars.iter().flatten();
        let squares = corners.clone().filter(|corner| corner.is_square()).count() / 4;
        let triangles = corners.filter(|corner| !corner.is_square()).count() / 3;
        (triangles, squares)
    };
    let mut name = "3".to_owned();
    let (mut triangles, mut squares) = counts(&name);
    for _ in 0..3 {
        name = format!("inflated-{name}");
        (triangles, squares) = (7 * triangles + 16 * squares, 3 * triangles + 7 * squares);
        assert_eq!(counts(&name), (triangles, squares), "{name}");
    }
    assert!(built_in("inflated-inflated-inflated-inflated-inflated-3").is_err());
}
