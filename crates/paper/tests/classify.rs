//! Combinatorics of tilings against hand counts, the literature, and a second way of
//! deciding isomorphism.

use acutile_catalog as catalog;
use acutile_core::classify::{NotTcp, Ridges, Star, check_tcp, frank_kasper, six_valent};
use acutile_core::quality::{Exact, rounded_down, squared_edges};
use acutile_core::tiling::{
    AnyPointSet, AnyTiling, Corner, SimplexId, Tiling, VertexId, match_facets, supercell,
};
use acutile_exact::number::Number;
use acutile_io::import::{Content, read_native};
use acutile_paper::survey::{Study, isomorphic_to};
use malachite::Rational;
use std::collections::{BTreeMap, BTreeSet, HashMap, VecDeque};

fn tiling(name: &str) -> Tiling<3> {
    match catalog::build(name) {
        Ok(AnyTiling::Space(tiling)) => tiling,
        other => panic!("{name}: {other:?}"),
    }
}

fn study(name: &str) -> Study<3> {
    Study::of(tiling(name)).expect("a tiling")
}

/// Frank and Kasper 1958: the coordination numbers 12, 14, 15, 16, one polyhedron each.
#[test]
fn four_stars_by_exhaustion() {
    let links = frank_kasper::links();
    let sizes: Vec<usize> = links.iter().map(|link| link.len()).collect();
    assert_eq!(sizes, [12, 14, 15, 16]);
    for link in links {
        let sixes = link.valences().filter(|&v| v == 6).count();
        assert_eq!(sixes, link.len() - 12);
        assert_eq!(link.valences().filter(|&v| v == 5).count(), 12);
    }
}

/// Coordination numbers of the Frank-Kasper phases (Shoemaker and Shoemaker 1986, table 1).
#[test]
fn vertex_types_of_the_literature() {
    for (name, expected) in [
        ("a15", [2, 6, 0, 0]),
        ("z", [3, 2, 2, 0]),
        ("c15", [4, 0, 0, 2]),
        ("c14", [8, 0, 0, 4]),
        ("c36", [16, 0, 0, 8]),
        ("sigma", [10, 16, 4, 0]),
        ("mu", [7, 2, 2, 2]),
    ] {
        let study = study(name);
        assert_eq!(study.check_tcp(), Ok(()), "{name}");
        let counts = study.star_counts();
        let found =
            [12, 14, 15, 16].map(|n| counts.get(&Star::FrankKasper(n)).copied().unwrap_or(0));
        // The catalogue's cell may be a multiple of the primitive one.
        let scale = found[0] / expected[0];
        assert_eq!(found, expected.map(|n| n * scale), "{name}");
        assert_eq!(
            counts.values().sum::<usize>(),
            found.iter().sum::<usize>(),
            "{name}"
        );
    }
}

/// The Kuhn cube: 6 tetrahedra at a space diagonal, 4 at a face diagonal, 6 at an edge;
/// 3 edges, 3 face diagonals and 1 space diagonal in a cell.
#[test]
fn valences_of_the_kuhn_cube() {
    let study = study("cube-6");
    assert_eq!(
        study.ridges.valence_counts(),
        BTreeMap::from([(4, 3), (6, 4)])
    );
    assert_eq!(
        study.ridges.average_valence(),
        Some(Rational::from_signeds(36, 7))
    );
    assert_eq!(*study.star_counts(), BTreeMap::from([(Star::Other(14), 1)]));
    assert!(matches!(
        study.check_tcp(),
        Err(NotTcp::Edge { valence: 4, .. })
    ));
}

/// The same tiling with vertices renumbered backwards and moved by lattice vectors, simplices
/// in reverse order and corners turned.
fn relabelled(tiling: &Tiling<3>) -> Tiling<3> {
    let n = tiling.vertices.len() as u32;
    let moved = |vertex: u32| {
        [
            vertex as i32 % 3 - 1,
            vertex as i32 % 2,
            -(vertex as i32 % 5),
        ]
    };
    let mut other = tiling.clone();
    let vertices = (0..n).rev().map(|old| {
        let vertex = tiling.vertices.vertex(VertexId::new(old));
        std::array::from_fn(|k| &vertex[k] - &Number::from(Rational::from(moved(old)[k])))
    });
    other.vertices = vertices.collect();
    let corner = |c: &Corner<3>| {
        Corner {
            vertex: VertexId::new(n - 1 - c.vertex.number()),
            shift: c.shift,
        }
        .moved(moved(c.vertex.number()))
    };
    other.corners = tiling
        .corners
        .chunks_exact(4)
        .rev()
        .flat_map(|c| [1, 2, 0, 3].map(|k| corner(&c[k])))
        .collect();
    other
}

/// In the basis b_1, b_2 + b_1, b_3 - 2 b_1 of the same lattice: coordinates x become T x with
/// x_1' = x_1 - x_2 + 2 x_3.
fn sheared(tiling: &Tiling<3>) -> Tiling<3> {
    let basis = [[1, 0, 0], [1, 1, 0], [-2, 0, 1]];
    let mut other = tiling.clone();
    let number = |n: i32| Number::from(Rational::from(n));
    other.frame.gram = std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            let mut sum = Number::zero();
            for k in 0..3 {
                for l in 0..3 {
                    sum = sum + &tiling.frame.gram[k][l] * number(basis[i][k] * basis[j][l]);
                }
            }
            sum
        })
    });
    let sheared = |[x, y, z]: [Number; 3]| [&x - &y + &z * number(2), y, z];
    other.vertices = tiling.vertices.iter().map(sheared).collect();
    for corner in &mut other.corners {
        corner.shift[0] += 2 * corner.shift[2] - corner.shift[1];
    }
    other
}

/// The mirror image: the first two basis vectors exchanged, and two corners of each simplex.
fn mirrored(tiling: &Tiling<3>) -> Tiling<3> {
    let mut other = tiling.clone();
    other.frame.gram = [1, 0, 2].map(|i| [1, 0, 2].map(|j| tiling.frame.gram[i][j].clone()));
    other.vertices = tiling.vertices.iter().map(|[x, y, z]| [y, x, z]).collect();
    other
        .corners
        .iter_mut()
        .for_each(|corner| corner.shift.swap(0, 1));
    other
        .corners
        .chunks_exact_mut(4)
        .for_each(|corners| corners.swap(2, 3));
    other
}

/// Walking around every edge and counting by a list of edges agree.
#[test]
fn tcp_in_two_ways() {
    let mut tcp = 0;
    for entry in catalog::entries() {
        let Ok(AnyTiling::Space(tiling)) = entry.build() else {
            continue;
        };
        let matching = match_facets(&tiling);
        let expected = check_tcp(&tiling, &Ridges::of(&tiling, &matching)).is_ok();
        assert_eq!(
            six_valent(&tiling, &matching).is_some(),
            expected,
            "{}",
            entry.name
        );
        tcp += usize::from(expected);
    }
    assert!(tcp > 5, "{tcp} are TCP");
}

#[test]
fn symbols_do_not_depend_on_the_description() {
    for name in ["a15", "z", "c15", "h", "mu", "sommerville-4", "cube-5"] {
        let given = study(name);
        let images = [
            relabelled(&given.tiling),
            sheared(&given.tiling),
            mirrored(&given.tiling),
            supercell(&given.tiling, [2, 1, 1]),
            supercell(&sheared(&given.tiling), [1, 1, 3]),
        ];
        for (k, image) in images.into_iter().enumerate() {
            let image = Study::of(image).expect("still a tiling");
            assert_eq!(image.symbol(), given.symbol(), "{name}, image {k}");
            assert_eq!(
                image.metric_symbol(),
                given.metric_symbol(),
                "{name}, image {k}"
            );
            assert_eq!(image.check_tcp().is_ok(), given.check_tcp().is_ok());
        }
    }
}

/// A stack of kagome layers is recognized in any description of it. Its word is known up to the choice of
/// the first block, turning it upside down, and mirror images.
#[test]
fn the_words_of_stacks_are_read() {
    for (word, canonical) in [
        ("+", "+"),
        ("z", "z"),
        ("-+-+", "+-"),
        ("+--+", "++--"),
        ("-z", "z+"),
        ("zz-", "zz+"),
        ("z-z+", "z+z-"),
        ("-z+z", "z+z-"),
        ("+++-+", "++++-"),
        ("-+z+--", "z+---+"),
    ] {
        let given = study(&format!("kagome:{word}"));
        let images = match canonical {
            "z+" | "+-" => vec![
                relabelled(&sheared(&given.tiling)),
                supercell(&mirrored(&given.tiling), [2, 1, 1]),
            ],
            _ => vec![given.tiling.clone()],
        };
        for image in images {
            let image = Study::of(image).expect("still a tiling");
            let symbol = image.symbol().expect("without boundary");
            let names = isomorphic_to(&image, &symbol);
            let stacks: Vec<&String> = names.iter().filter(|n| n.starts_with("kagome:")).collect();
            assert_eq!(stacks, [&format!("kagome:{canonical}")], "{word}");
        }
    }
}

/// The names that genice2 gives to some of its structures, for tilings that the catalogue makes from the
/// literature. The digests come from that package's coordinates.
#[test]
fn space_fullerenes_have_their_names() {
    for (name, expected) in [
        ("a15", "space fullerene 33 (A15)"),
        ("c14", "space fullerene 68 (C14)"),
        ("c36", "space fullerene 4 (C36)"),
        ("sigma", "space fullerene 38 (sigma)"),
        ("mu", "space fullerene 16 (mu)"),
        ("h", "space fullerene 37 (H)"),
        ("z", "space fullerene 54 (Z)"),
    ] {
        let study = study(name);
        let names = isomorphic_to(&study, &study.symbol().expect("without boundary"));
        assert!(names.contains(&expected.to_owned()), "{name}: {names:?}");
    }
}

/// Squeezing the metric changes lengths and not the combinatorics.
#[test]
fn lengths_are_seen_by_the_metric_symbol_only() {
    let given = study("cube-6");
    let mut longer = given.tiling.clone();
    longer.frame.gram[2][2] = Number::from(Rational::from(5));
    let longer = Study::of(longer).expect("a tiling by other tetrahedra");
    assert_eq!(longer.symbol(), given.symbol());
    assert_ne!(longer.metric_symbol(), given.metric_symbol());
}

/// Chambers as (simplex, order of corners), the facets matched by points: a second
/// implementation for small tilings.
struct Chambers {
    tiling: Tiling<3>,
    /// Facets by their points moved into one cell, with the simplices that have them.
    facets: HashMap<Form, Vec<(usize, usize, [i32; 3])>>,
}

type Chamber = (usize, [usize; 4]);

/// The corners of a facet.
type Form = BTreeSet<(u32, [i32; 3])>;

impl Chambers {
    fn new(tiling: Tiling<3>) -> Self {
        let mut facets: HashMap<_, Vec<_>> = HashMap::new();
        for (simplex, corners) in tiling.simplices().enumerate() {
            for opposite in 0..4 {
                let (form, origin) = facet(corners, opposite);
                facets
                    .entry(form)
                    .or_default()
                    .push((simplex, opposite, origin));
            }
        }
        Chambers { tiling, facets }
    }

    fn neighbour(&self, (simplex, order): Chamber, k: usize) -> Chamber {
        if k < 3 {
            let mut order = order;
            order.swap(k, k + 1);
            return (simplex, order);
        }
        let corners = self.tiling.simplex(SimplexId::at(simplex));
        let (form, origin) = facet(corners, order[3]);
        let uses = &self.facets[&form];
        assert_eq!(uses.len(), 2);
        let other = uses
            .iter()
            .find(|(s, o, _)| (*s, *o) != (simplex, order[3]))
            .expect("a mate");
        let back: [i32; 3] = std::array::from_fn(|i| origin[i] - other.2[i]);
        let there = self.tiling.simplex(SimplexId::at(other.0));
        let mut image = [other.1; 4];
        for place in 0..3 {
            let corner = corners[order[place]];
            image[place] = there
                .iter()
                .position(|c| c.moved(back) == corner)
                .expect("a common corner");
        }
        (other.0, image)
    }

    /// Half the length of the cycle of s_2 and s_3.
    fn valence(&self, chamber: Chamber) -> usize {
        let mut at = chamber;
        let mut steps = 0;
        loop {
            at = self.neighbour(self.neighbour(at, 2), 3);
            steps += 1;
            if at == chamber {
                return steps;
            }
        }
    }
}

fn facet(corners: &[Corner<3>], opposite: usize) -> (Form, [i32; 3]) {
    let points: Vec<_> = (0..4)
        .filter(|&k| k != opposite)
        .map(|k| corners[k])
        .collect();
    let least = points.iter().min().expect("three corners").shift;
    let form = points
        .iter()
        .map(|c| {
            (
                c.vertex.number(),
                std::array::from_fn(|i| c.shift[i] - least[i]),
            )
        })
        .collect();
    (form, least)
}

/// Whether a flag of one tiling and a flag of the other extend to an isomorphism. All flags reached by the
/// same steps must have edges of the same valence. Valences in the quotient by a lattice can be shorter
/// than around the edge only if the lattice fixed a simplex.
fn are_isomorphic(one: &Chambers, other: &Chambers) -> bool {
    let start = (0, [0, 1, 2, 3]);
    let orders: Vec<[usize; 4]> = (0..256)
        .map(|n| [n & 3, n >> 2 & 3, n >> 4 & 3, n >> 6 & 3])
        .filter(|o| o.iter().collect::<BTreeSet<_>>().len() == 4)
        .collect();
    let mut candidates = (0..other.tiling.len()).flat_map(|s| orders.iter().map(move |o| (s, *o)));
    candidates.any(|candidate| {
        let mut seen = BTreeSet::from([(start, candidate)]);
        let mut waiting = VecDeque::from([(start, candidate)]);
        while let Some((a, b)) = waiting.pop_front() {
            if one.valence(a) != other.valence(b) {
                return false;
            }
            for k in 0..4 {
                let pair = (one.neighbour(a, k), other.neighbour(b, k));
                if seen.insert(pair) {
                    waiting.push_back(pair);
                }
            }
        }
        true
    })
}

#[test]
fn symbols_agree_with_propagated_flags() {
    let names = [
        "a15",
        "a15-bcc",
        "z",
        "c15",
        "c14",
        "sommerville-1",
        "sommerville-2",
        "cube-5",
        "cube-6",
        "goldberg-1",
    ];
    let chambers: Vec<Chambers> = names
        .iter()
        .map(|name| Chambers::new(tiling(name)))
        .collect();
    let symbols: Vec<_> = names.iter().map(|name| study(name).symbol()).collect();
    for i in 0..names.len() {
        for j in 0..i {
            let expected = are_isomorphic(&chambers[i], &chambers[j]);
            assert_eq!(
                symbols[i] == symbols[j],
                expected,
                "{} and {}",
                names[i],
                names[j]
            );
        }
    }
    // By hand: Kuhn's cubes and Goldberg's prisms are affine images of the bcc triangulation.
    assert_eq!(symbols[6], symbols[8]);
    assert_eq!(symbols[6], symbols[9]);
}

/// The group of A15 (Pm-3n, 48 modulo lattice) acts freely on the 24 x 46 chambers.
#[test]
fn chambers_of_a15() {
    let study = study("a15");
    assert_eq!(study.symbol().expect("no boundary").len(), 24 * 46 / 48);
    let edges: BTreeSet<_> = study
        .tiling
        .indices()
        .flat_map(|simplex| squared_edges(&study.tiling, simplex))
        .collect();
    // In units of the cell: 1/2, √6/4 and √5/4.
    let scale = study.tiling.frame.gram[0][0].clone();
    let expected = [(1, 4), (5, 16), (6, 16)]
        .map(|(n, d)| &scale * &Number::from(Rational::from_signeds(n, d)));
    assert_eq!(edges, BTreeSet::from(expected));
}

/// Section 4.2 in coordinates of its own, derived by hand. The icosahedra have edge 2 and a vertical 3-fold
/// axis. Their upper triangle is at the height φ²/√3, and the upper vertices of the slanted middle edges at
/// 1/(φ√3). Those edges touch. So two vectors of length 2φ at 60 degrees generate the plane lattice, and
/// the middle vertices lie over its triangles' centres. Layers are mirror images in the shared faces, so
/// the period is 4φ²/√3. With f = 1/φ = (√5-1)/2.
const ICOSAHEDRA: &str = r#"{ "format": "acutile-points", "version": 1, "dimension": 3,
  "lattice": { "gram": [["6+2*sqrt(5)", "3+sqrt(5)", 0], ["3+sqrt(5)", "6+2*sqrt(5)", 0],
                        [0, 0, "16/3*((1+sqrt(5))/2)^4"]] },
  "points": [
    [0, 0, 0], [0, 0, "1/2"],
    ["-(sqrt(5)-1)/6", "-(sqrt(5)-1)/6", "1/4"], ["(sqrt(5)-1)/3", "-(sqrt(5)-1)/6", "1/4"],
    ["-(sqrt(5)-1)/6", "(sqrt(5)-1)/3", "1/4"],
    ["(sqrt(5)-1)/6", "(sqrt(5)-1)/6", "3/4"], ["-(sqrt(5)-1)/3", "(sqrt(5)-1)/6", "3/4"],
    ["(sqrt(5)-1)/6", "-(sqrt(5)-1)/3", "3/4"],
    ["1/3", "1/3", "((sqrt(5)-1)/2)^3/4"], ["2/3", "2/3", "-((sqrt(5)-1)/2)^3/4"],
    ["1/3", "1/3", "1/2-((sqrt(5)-1)/2)^3/4"], ["2/3", "2/3", "1/2+((sqrt(5)-1)/2)^3/4"] ] }"#;

/// The paper calls it combinatorially Z. Its own figures in Table 1 (.629, 1.000, 41.81, 69.09, 83.62) identify the
/// construction; the vertex types are those of the Laves phases, and by propagated flags, too, it is C14.
#[test]
fn touching_icosahedra_are_c14_and_not_z() {
    let points = match read_native(ICOSAHEDRA).expect("a file").content {
        Content::Points(AnyPointSet::Space(points)) => points,
        _ => panic!("points in space"),
    };
    let study = Study::of_points(&points).expect("a tiling");
    let bounds = |value: &dyn Fn(&Rational) -> (Rational, Rational)| {
        let (low, high) = value(&Rational::from_signeds(1, 1_000_000));
        (rounded_down(&low, 3), rounded_down(&high, 3))
    };
    let ranges = &study.ranges;
    let both = |text: &str| (text.to_owned(), text.to_owned());
    assert_eq!(
        bounds(&|w| ranges.radius_edge.min.enclosure(w)),
        both("0.629")
    );
    assert_eq!(
        bounds(&|w| ranges.radius_edge.max.enclosure(w)),
        both("1.000")
    );
    assert_eq!(
        bounds(&|w| ranges.smallest_dihedral.min.enclosure(w)),
        both("41.810")
    );
    assert_eq!(
        bounds(&|w| ranges.smallest_dihedral.max.enclosure(w)),
        both("69.094")
    );
    assert_eq!(
        bounds(&|w| ranges.largest_dihedral.max.enclosure(w)),
        both("83.620")
    );
    let expected = [(Star::FrankKasper(12), 8), (Star::FrankKasper(16), 4)];
    assert_eq!(*study.star_counts(), BTreeMap::from(expected));
    let chambers = Chambers::new(study.tiling.clone());
    for (name, expected) in [("c14", true), ("z", false), ("c15", false)] {
        assert_eq!(
            study.symbol() == self::study(name).symbol(),
            expected,
            "{name}"
        );
        assert_eq!(
            are_isomorphic(&chambers, &Chambers::new(tiling(name))),
            expected,
            "{name}"
        );
    }
}
