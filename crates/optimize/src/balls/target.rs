//! A convex polyhedron that a search aims at, and the ways in which the edges that remain of the 600-cell can be its
//! edges.

use acutile_exact::geometry::{Sign, linear};
use acutile_exact::number::{Field, Number, numbers};
use std::collections::BTreeSet;
use std::fmt;

/// Larger polyhedra are refused: all triples of corners are tried as planes.
pub const CORNER_LIMIT: usize = 60;

type Point = [Number; 3];

/// A convex polyhedron.
#[derive(Clone, Debug)]
pub struct Target {
    /// The field of all numbers.
    pub field: Field,
    /// The Gram matrix of the basis.
    pub gram: [Point; 3],
    /// The corners.
    pub corners: Vec<Point>,
    /// The corners of each face, sorted.
    pub faces: Vec<Vec<usize>>,
}

/// Why points are not the corners of a polyhedron.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NoTarget {
    /// A number cannot be read, or the numbers have no common field.
    Number(String),
    /// Fewer than four points, or more than [`CORNER_LIMIT`].
    Count(usize),
    /// All points lie in one plane.
    Flat,
    /// This point, from zero, is no corner of the hull.
    NoCorner(usize),
}

impl fmt::Display for NoTarget {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            NoTarget::Number(message) => f.write_str(message),
            NoTarget::Count(count) => {
                write!(f, "found {count} points, expected 4 to {CORNER_LIMIT}")
            }
            NoTarget::Flat => write!(f, "all points lie in one plane"),
            NoTarget::NoCorner(point) => write!(
                f,
                "point {} is no corner of the convex hull of all; leave it out",
                point + 1
            ),
        }
    }
}

impl Target {
    /// The convex hull of points, each of which is to be a corner, in a basis with this Gram matrix. All numbers are
    /// texts such as `1/2` or `(sqrt(5)-1)/4`, and have a common field.
    ///
    /// # Errors
    /// The points are not the corners of a polyhedron.
    pub fn of_texts(gram: [[&str; 3]; 3], points: &[[&str; 3]]) -> Result<Self, NoTarget> {
        let texts: Vec<&str> = gram.iter().chain(points).flatten().copied().collect();
        let all = numbers(&texts).map_err(|error| NoTarget::Number(error.to_string()))?;
        let field = all.iter().find_map(Number::field).cloned();
        let rows = all
            .chunks(3)
            .map(|row| [row[0].clone(), row[1].clone(), row[2].clone()]);
        let gram = std::array::from_fn(|i| std::array::from_fn(|j| all[3 * i + j].clone()));
        let corners = rows.skip(3).collect();
        Target::hull(field.unwrap_or_else(Field::rationals), gram, corners)
    }

    /// The convex hull of points, each of which is to be a corner.
    ///
    /// # Errors
    /// The points are not the corners of a polyhedron.
    pub fn hull(field: Field, gram: [Point; 3], corners: Vec<Point>) -> Result<Self, NoTarget> {
        let n = corners.len();
        if !(4..=CORNER_LIMIT).contains(&n) {
            return Err(NoTarget::Count(n));
        }
        let mut faces = BTreeSet::new();
        let mut is_flat = true;
        for i in 0..n {
            for j in i + 1..n {
                for k in j + 1..n {
                    let [a, b, c] = [i, j, k].map(|v| &corners[v]);
                    let edge = |p: &Point| linear::subtract(p, a);
                    let normal = linear::cross(&edge(b), &edge(c));
                    if normal.iter().all(Number::is_zero) {
                        continue;
                    }
                    let side = |p: &Point| linear::dot(&normal, &edge(p)).sign();
                    let sides: Vec<Sign> = corners.iter().map(side).collect();
                    let has = |sign: Sign| sides.contains(&sign);
                    is_flat &= !has(Sign::Greater) && !has(Sign::Less);
                    if has(Sign::Greater) != has(Sign::Less) {
                        let on = (0..n).filter(|v| sides[*v] == Sign::Equal);
                        faces.insert(on.collect::<Vec<usize>>());
                    }
                }
            }
        }
        if is_flat {
            return Err(NoTarget::Flat);
        }
        // A corner lies in three faces or more, a point inside an edge in two.
        let count = |v: &usize| faces.iter().filter(|face| face.contains(v)).count();
        if let Some(point) = (0..n).find(|v| count(v) < 3) {
            return Err(NoTarget::NoCorner(point));
        }
        Ok(Target {
            field,
            gram,
            corners,
            faces: faces.into_iter().collect(),
        })
    }

    /// The images of the corners of another polyhedron under all isomorphisms. Its faces and corners are
    /// given as here. Of each class with equal distances there is one.
    pub fn placements(&self, corners: usize, faces: &[Vec<usize>]) -> Vec<Vec<usize>> {
        if (corners, faces.len()) != (self.corners.len(), self.faces.len()) {
            return Vec::new();
        }
        let (theirs, own) = (Graph::of(corners, faces), Graph::of(corners, &self.faces));
        let wanted: BTreeSet<&Vec<usize>> = self.faces.iter().collect();
        let mut found = Vec::new();
        let mut distances: Vec<Vec<Number>> = Vec::new();
        theirs.isomorphisms(&own, &mut |map| {
            let image = |face: &Vec<usize>| {
                let mut image: Vec<usize> = face.iter().map(|v| map[*v]).collect();
                image.sort_unstable();
                image
            };
            if !faces.iter().all(|face| wanted.contains(&image(face))) {
                return;
            }
            let pairs = (0..corners).flat_map(|i| (0..i).map(move |j| (i, j)));
            let all: Vec<Number> = pairs.map(|(i, j)| self.distance(map[i], map[j])).collect();
            if !distances.contains(&all) {
                distances.push(all);
                found.push(map.to_vec());
            }
        });
        found
    }

    /// The square of the distance of two corners.
    fn distance(&self, v: usize, w: usize) -> Number {
        let difference = linear::subtract(&self.corners[v], &self.corners[w]);
        let image = linear::apply(&self.gram, &difference);
        linear::dot(&difference, &image)
    }
}

/// The edges of a polyhedron: two corners with two faces in common.
struct Graph {
    neighbours: Vec<Vec<usize>>,
}

impl Graph {
    fn of(corners: usize, faces: &[Vec<usize>]) -> Self {
        let has_edge = |v: usize, w: usize| {
            let common = |face: &&Vec<usize>| face.contains(&v) && face.contains(&w);
            v != w && faces.iter().filter(common).count() >= 2
        };
        let neighbours = |v: usize| (0..corners).filter(|w| has_edge(v, *w)).collect();
        Graph {
            neighbours: (0..corners).map(neighbours).collect(),
        }
    }

    /// All isomorphisms to another graph, as the images of the vertices. Vertices are taken in an order in which each
    /// has an earlier neighbour, so that few images are possible.
    fn isomorphisms(&self, other: &Graph, take: &mut dyn FnMut(&[usize])) {
        let mut order = vec![0];
        let mut next = 0;
        while next < order.len() {
            for &w in &self.neighbours[order[next]] {
                if !order.contains(&w) {
                    order.push(w);
                }
            }
            next += 1;
        }
        if order.len() == self.neighbours.len() {
            self.extend(other, &order, &mut Vec::new(), take);
        }
    }

    /// `images` are those of the first vertices in `order`.
    fn extend(
        &self,
        other: &Graph,
        order: &[usize],
        images: &mut Vec<usize>,
        take: &mut dyn FnMut(&[usize]),
    ) {
        let Some(&vertex) = order.get(images.len()) else {
            let mut pairs: Vec<_> = order.iter().zip(images.iter().copied()).collect();
            pairs.sort_unstable();
            let map: Vec<usize> = pairs.into_iter().map(|(_, image)| image).collect();
            return take(&map);
        };
        for image in 0..other.neighbours.len() {
            let (own, theirs) = (&self.neighbours[vertex], &other.neighbours[image]);
            let fits = |(w, of_w): (&usize, &usize)| {
                *of_w != image && own.contains(w) == theirs.contains(of_w)
            };
            if own.len() == theirs.len() && order.iter().zip(images.iter()).all(fits) {
                images.push(image);
                self.extend(other, order, images, take);
                images.pop();
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const CUBIC: [[&str; 3]; 3] = [["1", "0", "0"], ["0", "1", "0"], ["0", "0", "1"]];

    fn cuboid<'a>(a: &'a str, b: &'a str, c: &'a str) -> Vec<[&'a str; 3]> {
        let mut points = Vec::new();
        for x in ["0", a] {
            for y in ["0", b] {
                points.extend(["0", c].map(|z| [x, y, z]));
            }
        }
        points
    }

    fn target(points: &[[&str; 3]]) -> Target {
        Target::of_texts(CUBIC, points).expect("a polyhedron")
    }

    /// A cuboid has six faces with four corners. The cube's edges have 48 automorphisms, all of them isometries of the
    /// cube. Of a cuboid with three different sides 8 are isometries, so 6 classes remain.
    #[test]
    fn a_cube_in_cuboids() {
        let cube = target(&cuboid("1", "1", "1"));
        assert_eq!(cube.faces.len(), 6);
        assert!(cube.faces.iter().all(|face| face.len() == 4));
        for (sides, classes) in [
            (["1", "1", "1"], 1),
            (["1", "1", "2"], 3),
            (["1", "2", "sqrt(5)"], 6),
        ] {
            let [a, b, c] = sides;
            let placements = target(&cuboid(a, b, c)).placements(8, &cube.faces);
            assert_eq!(placements.len(), classes, "{sides:?}");
        }
    }

    /// An octahedron has eight triangles, and is no cube.
    #[test]
    fn an_octahedron_is_no_cube() {
        let octahedron = target(&[
            ["1", "0", "0"],
            ["-1", "0", "0"],
            ["0", "1", "0"],
            ["0", "-1", "0"],
            ["0", "0", "1"],
            ["0", "0", "-1"],
        ]);
        assert_eq!(octahedron.faces.len(), 8);
        assert!(octahedron.faces.iter().all(|face| face.len() == 3));
        let cube = target(&cuboid("1", "1", "1"));
        assert!(octahedron.placements(8, &cube.faces).is_empty());
    }

    #[test]
    fn what_is_no_polyhedron_is_refused() {
        let refused = |points: &[[&str; 3]]| Target::of_texts(CUBIC, points).map(|_| ());
        let square = [
            ["0", "0", "0"],
            ["1", "0", "0"],
            ["0", "1", "0"],
            ["1", "1", "0"],
        ];
        assert_eq!(refused(&square), Err(NoTarget::Flat));
        assert_eq!(refused(&square[..3]), Err(NoTarget::Count(3)));
        for extra in ["1/2", "0"] {
            let mut points = cuboid("1", "1", "1");
            points.push(["1/2", "1/2", extra]);
            assert_eq!(refused(&points), Err(NoTarget::NoCorner(8)));
        }
        let repeated = [["0", "0", "0"]; 5];
        assert_eq!(refused(&repeated), Err(NoTarget::Flat));
        let mut words = cuboid("1", "1", "1");
        words[0][0] = "x";
        assert!(matches!(refused(&words), Err(NoTarget::Number(_))));
    }
}
