//! Periodic tilings of the plane by unit squares and equilateral triangles: built in,
//! inflated, repeated, and checked.
//!
//! Vertices are exact: with z a 12th root of unity (z^4 = z² - 1) the vector
//! (a, b, c, d) is a + b z + c z² + d z³. A combination of absolute value 1 is a power
//! of z (its conjugate has absolute value 1 too, for x x' = 1 holds in Z[sqrt 3]; Kronecker), so
//! edges have twelve directions.

use super::CatalogError;
use super::limits::{DEPTH_LIMIT, ENTRY_LIMIT};
use std::collections::{BTreeSet, HashMap};

/// a + b z + c z² + d z³
pub type Cyclotomic = [i64; 4];

/// z^k
pub const POWERS: [Cyclotomic; 12] = [
    [1, 0, 0, 0],
    [0, 1, 0, 0],
    [0, 0, 1, 0],
    [0, 0, 0, 1],
    [-1, 0, 1, 0],
    [0, -1, 0, 1],
    [-1, 0, 0, 0],
    [0, -1, 0, 0],
    [0, 0, -1, 0],
    [0, 0, 0, -1],
    [1, 0, -1, 0],
    [0, 1, 0, -1],
];

/// A corner of a tile, at a vertex.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TileCorner {
    /// The direction of the first side; the tile lies to its left.
    pub direction: usize,
    /// The angle in units of 30 degrees: 2 or 3.
    pub angle: usize,
}

impl TileCorner {
    /// Whether the tile is a square.
    pub fn is_square(&self) -> bool {
        self.angle == 3
    }
}

/// The tilings that are built in, by name: five, and these inflated up to [`DEPTH_LIMIT`] times.
pub fn named(name: &str) -> Option<PlaneTiling> {
    let (depth, name) = depth(name);
    let plane = simple(name).filter(|_| depth <= DEPTH_LIMIT)?;
    Some((0..depth).fold(plane, |plane, _| plane.inflated()))
}

/// How often a name says `inflated-`, and the rest of it.
fn depth(mut name: &str) -> (usize, &str) {
    let mut depth = 0;
    while let Some(rest) = name.strip_prefix("inflated-") {
        (depth, name) = (depth + 1, rest);
    }
    (depth, name)
}

/// The plane tiling that is built in under this name.
///
/// # Errors
/// There is none; the message lists the names.
pub fn built_in(name: &str) -> Result<PlaneTiling, CatalogError> {
    named(name).ok_or_else(|| {
        CatalogError::File(format!(
            "found {} after the colon, expected a plane-tiling file or a built-in tiling: 3, \
             4, 33344, 32434, 3464, or one of these after inflated- up to {DEPTH_LIMIT} times",
            if name.is_empty() {
                "nothing".to_owned()
            } else {
                format!("{name:?}")
            }
        ))
    })
}

fn simple(name: &str) -> Option<PlaneTiling> {
    match name {
        "3" => Some(triangles()),
        "4" => Some(squares()),
        "33344" => Some(rows()),
        "32434" => Some(snub()),
        "3464" => Some(rhombitrihexagonal()),
        _ => None,
    }
}

/// A periodic tiling of the plane by unit squares and triangles: a basis of the lattice and one
/// vertex of each orbit. Its edges are all pairs of vertices at distance 1.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PlaneTiling {
    /// Two lattice vectors.
    pub lattice: [Cyclotomic; 2],
    /// The vertices of a cell.
    pub vertices: Vec<Cyclotomic>,
}

fn plane(lattice: [Cyclotomic; 2], vertices: &[Cyclotomic]) -> PlaneTiling {
    PlaneTiling {
        lattice,
        vertices: vertices.to_vec(),
    }
}

/// 3^6: triangles only, which gives Z.
pub fn triangles() -> PlaneTiling {
    plane([POWERS[0], POWERS[2]], &[[0; 4]])
}

/// 4^4: squares only, which gives A15.
pub fn squares() -> PlaneTiling {
    plane([POWERS[0], POWERS[3]], &[[0; 4]])
}

/// 3^3.4^2: a row of squares, a row of triangles; gives H.
pub fn rows() -> PlaneTiling {
    plane([POWERS[0], [0, 0, 1, 1]], &[[0; 4], POWERS[3]])
}

/// 3^2.4.3.4: every vertex belongs to a square with sides 1 and z³; gives sigma.
pub fn snub() -> PlaneTiling {
    plane(
        [[1, 1, 0, 0], [-1, 0, 1, 1]],
        &[[0; 4], POWERS[0], POWERS[3], [1, 0, 0, 1]],
    )
}

/// 3.4.6.4 with each hexagon cut into six triangles. The lattice vectors have the length
/// 1 + sqrt 3, and sqrt 3 = 2 z - z³.
pub fn rhombitrihexagonal() -> PlaneTiling {
    let length = [1, 2, 0, -1];
    let mut vertices = vec![[0; 4]];
    vertices.extend([1, 3, 5, 7, 9, 11].map(|k| POWERS[k]));
    PlaneTiling {
        lattice: [length, times(length, POWERS[2])],
        vertices,
    }
}

impl PlaneTiling {
    /// Stampfli's inflation by the factor 2 + sqrt 3: around each vertex c of the
    /// enlarged tiling a dodecagonal wheel, c, c + z^k, c + z^k + z^(k±1) for even k.
    pub fn inflated(&self) -> PlaneTiling {
        let factor = [2, 2, 0, -1];
        let lattice = self.lattice.map(|x| times(x, factor));
        let mut inflated = PlaneTiling {
            lattice,
            vertices: Vec::new(),
        };
        let mut known = BTreeSet::new();
        for &vertex in &self.vertices {
            for x in wheel(times(vertex, factor)) {
                if known.insert(inflated.residue(x)) {
                    inflated.vertices.push(x);
                }
            }
        }
        inflated
    }

    /// The representative of x modulo the lattice: two coordinates in which the lattice
    /// vectors are independent determine the multiples to subtract.
    pub fn residue(&self, x: Cyclotomic) -> Cyclotomic {
        let [a, b] = &self.lattice;
        let minor = |x: &Cyclotomic, y: &Cyclotomic, i: usize, j: usize| x[i] * y[j] - x[j] * y[i];
        let pairs = (0..4).flat_map(|j| (0..j).map(move |i| (i, j)));
        let Some((i, j)) = pairs.into_iter().find(|&(i, j)| minor(a, b, i, j) != 0) else {
            return x;
        };
        let d = minor(a, b, i, j);
        let s = (minor(&x, b, i, j) * d.signum()).div_euclid(d.abs());
        let t = (minor(a, &x, i, j) * d.signum()).div_euclid(d.abs());
        std::array::from_fn(|k| x[k] - s * a[k] - t * b[k])
    }

    /// The tiling seen over a coarser lattice.
    pub fn repeated(&self, [m, n]: [i64; 2]) -> PlaneTiling {
        let [a, b] = self.lattice;
        let offsets = (0..n).flat_map(|j| (0..m).map(move |i| sum(scaled(a, i), scaled(b, j))));
        PlaneTiling {
            lattice: [scaled(a, m), scaled(b, n)],
            vertices: offsets
                .flat_map(|offset| self.vertices.iter().map(move |&v| sum(v, offset)))
                .collect(),
        }
    }

    /// The index of each vertex by its residue.
    pub fn indices(&self) -> HashMap<Cyclotomic, usize> {
        let residues = self.vertices.iter().map(|&v| self.residue(v));
        residues.zip(0..).collect()
    }

    /// The corners of tiles around each vertex, in positive order.
    ///
    /// Checked: all angles are 60 or 90 degrees. Then the tiles close. At the far end of a side the same
    /// tile has the same angle, because an angle of 60 degrees makes its third side an edge. So the tiles
    /// cover the plane evenly, and once if their area is that of the cell.
    ///
    /// # Errors
    /// The first defect of the plane tiling.
    pub fn stars(&self) -> Result<Vec<Vec<TileCorner>>, CatalogError> {
        self.check_entries()?;
        let stars: Vec<Vec<TileCorner>> = self
            .directions()?
            .iter()
            .enumerate()
            .map(|(vertex, directions)| star(vertex, directions))
            .collect::<Result<_, _>>()?;
        self.check_area(&stars)?;
        Ok(stars)
    }

    fn check_entries(&self) -> Result<(), CatalogError> {
        let mut entries = self.lattice.iter().chain(&self.vertices).flatten();
        match entries.find(|entry| entry.unsigned_abs() > ENTRY_LIMIT.unsigned_abs()) {
            Some(&entry) => Err(CatalogError::EntryTooLarge(entry)),
            None => Ok(()),
        }
    }

    /// The directions k, sorted, of the edges at each vertex.
    fn directions(&self) -> Result<Vec<Vec<usize>>, CatalogError> {
        let indices = self.indices();
        for (i, &v) in self.vertices.iter().enumerate() {
            match indices.get(&self.residue(v)) {
                Some(&last) if last != i => return Err(CatalogError::SameVertex(i, last)),
                _ => {}
            }
        }
        let is_edge =
            |v: &Cyclotomic, k: usize| indices.contains_key(&self.residue(sum(*v, POWERS[k])));
        let directions = |v| (0..12).filter(|&k| is_edge(v, k)).collect();
        Ok(self.vertices.iter().map(directions).collect())
    }

    /// Twice the area of the cell is the imaginary part of 2 a' b for the lattice vectors a, b (a' the
    /// conjugate): c_1 + 2 c_3 + c_2 sqrt 3 for a' b = (c_0, …, c_3). A triangle has
    /// sqrt 3/2 and a square 2.
    fn check_area(&self, stars: &[Vec<TileCorner>]) -> Result<(), CatalogError> {
        let [a, b] = self.lattice;
        let [_, c1, c2, c3] = times(conjugate(a), b);
        let (rational, root) = (2 * c1 + 4 * c3, 2 * c2);
        if (rational, root) == (0, 0) {
            return Err(CatalogError::Degenerate);
        }
        let corners = stars.iter().flatten();
        let squares = corners.clone().filter(|corner| corner.is_square()).count() / 4;
        let triangles = corners.filter(|corner| !corner.is_square()).count() / 3;
        let tiles = (4 * squares as i64, triangles as i64);
        if tiles != (rational, root) && tiles != (-rational, -root) {
            return Err(CatalogError::NotACover { triangles, squares });
        }
        Ok(())
    }
}

/// The corners between neighbouring directions.
fn star(vertex: usize, directions: &[usize]) -> Result<Vec<TileCorner>, CatalogError> {
    let error = |angle| CatalogError::NotSquareTriangle { vertex, angle };
    if directions.is_empty() {
        return Err(error(360));
    }
    let next = directions.iter().cycle().skip(1);
    directions
        .iter()
        .zip(next)
        .map(
            |(&direction, &next)| match (next + 11 - direction) % 12 + 1 {
                angle @ (2 | 3) => Ok(TileCorner { direction, angle }),
                angle => Err(error(30 * angle)),
            },
        )
        .collect()
}

fn wheel(c: Cyclotomic) -> Vec<Cyclotomic> {
    let mut points = vec![c];
    for k in [0, 2, 4, 6, 8, 10] {
        let spoke = sum(c, POWERS[k]);
        points.extend([
            spoke,
            sum(spoke, POWERS[k + 1]),
            sum(spoke, POWERS[(k + 11) % 12]),
        ]);
    }
    points
}

/// x + y
pub fn sum(x: Cyclotomic, y: Cyclotomic) -> Cyclotomic {
    std::array::from_fn(|k| x[k] + y[k])
}

/// x times an integer.
pub fn scaled(x: Cyclotomic, factor: i64) -> Cyclotomic {
    x.map(|entry| entry * factor)
}

/// x y
pub fn times(x: Cyclotomic, y: Cyclotomic) -> Cyclotomic {
    let mut product = [0; 4];
    for (i, a) in x.iter().enumerate() {
        for (j, b) in y.iter().enumerate() {
            product = sum(product, scaled(POWERS[i + j], a * b));
        }
    }
    product
}

/// The complex conjugate: z^k becomes z^(12 - k).
fn conjugate(x: Cyclotomic) -> Cyclotomic {
    (0..4).fold([0; 4], |total, k| {
        sum(total, scaled(POWERS[(12 - k) % 12], x[k]))
    })
}
