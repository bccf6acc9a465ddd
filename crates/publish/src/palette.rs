//! The colours of congruence classes: a class of a tiling has one colour in figures, on pages and in the appendix.
//!
//! The colour follows from the exact shape, up to scale. The shapes of the TCP structures have colours of
//! their own, the same in all tilings. Another shape has the colour that its edges hash to. If a class of
//! the tiling has that colour or its lightness, the shape has the next one. So it may have two colours in
//! two tilings.

use acutile_core::quality::{Shape, rounded_nearest};
use acutile_exact::number::Number;
use malachite::Rational;

/// Red, green, blue.
pub type Colour = [u8; 3];

/// The hues of Okabe and Ito (2008), three times over the same eight values of L*, which are more than 8 apart: 88, 36, 70.5,
/// 53, 79, 44.5, 61.8 and 97. So eight classes, one of each column, differ in grey.
const COLOURS: [Colour; 24] = [
    [236, 225, 65],
    [0, 89, 140],
    [89, 182, 233],
    [208, 92, 0],
    [238, 189, 79],
    [0, 120, 87],
    [205, 124, 169],
    [246, 246, 246],
    [245, 215, 192],
    [115, 77, 0],
    [85, 190, 162],
    [176, 104, 144],
    [196, 196, 196],
    [113, 107, 26],
    [79, 157, 202],
    [238, 248, 253],
    [188, 229, 218],
    [119, 69, 97],
    [172, 172, 172],
    [136, 129, 33],
    [158, 202, 226],
    [51, 111, 146],
    [221, 125, 48],
    [253, 246, 230],
];

/// Columns of [`COLOURS`]: values of L*.
const LEVELS: usize = 8;

/// The shapes of A15, Z, C15, mu, sigma and bcc: squared edges over the first one, to six decimals.
const KNOWN: [&str; 15] = [
    "1.000000 1.250000 1.500000 1.250000 1.500000 1.250000",
    "1.000000 1.500000 1.500000 1.500000 1.500000 1.000000",
    "1.000000 1.000000 1.000000 1.200000 1.200000 1.200000",
    "1.000000 1.250000 1.250000 1.250000 1.250000 1.000000",
    "1.000000 1.583333 1.583333 1.583333 1.583333 1.333333",
    "1.000000 1.066667 1.066667 1.266667 1.266667 1.066667",
    "1.000000 1.250000 1.333333 1.250000 1.333333 1.583333",
    "1.000000 1.000000 1.333333 1.000000 1.333333 1.333333",
    "1.000000 1.375000 1.375000 1.375000 1.375000 1.500000",
    "1.000000 1.000000 1.375000 1.000000 1.375000 1.375000",
    "1.000000 1.000000 1.000000 1.000000 1.000000 1.000000",
    "1.000000 1.250000 1.375000 1.250000 1.375000 1.237372",
    "1.000000 1.500000 1.583333 1.500000 1.583333 1.160684",
    "1.000000 1.076952 1.292342 1.148748 1.364139 1.076952",
    "1.000000 1.000000 1.333333 1.333333 1.000000 1.000000",
];

/// The colour of each class of a tiling.
#[derive(Clone, Debug)]
pub struct Palette(Vec<Colour>);

impl Palette {
    /// For these classes, in their order.
    pub fn of<'s>(shapes: impl IntoIterator<Item = &'s Shape>) -> Palette {
        let keys: Vec<String> = shapes.into_iter().map(key).collect();
        let known = |key: &String| KNOWN.iter().position(|other| other == key);
        let mut slots: Vec<Option<usize>> = keys.iter().map(known).collect();
        let mut others: Vec<usize> = (0..keys.len()).filter(|&k| slots[k].is_none()).collect();
        // Not by the numbers of classes, which depend on the order of simplices.
        others.sort_by(|&a, &b| keys[a].cmp(&keys[b]));
        let mut taken = [false; COLOURS.len()];
        slots.iter().flatten().for_each(|&slot| taken[slot] = true);
        for class in others {
            let slot = free(hash(&keys[class]), &taken);
            taken[slot] = true;
            slots[class] = Some(slot);
        }
        Palette(slots.into_iter().flatten().map(colour).collect())
    }

    /// Of a class.
    pub fn colour(&self, class: usize) -> Colour {
        self.0.get(class).copied().unwrap_or(COLOURS[0])
    }

    /// Of all classes, in order.
    pub fn colours(&self) -> &[Colour] {
        &self.0
    }
}

/// Colours of things that are no shapes, by their number.
pub fn colour(number: usize) -> Colour {
    COLOURS[number % COLOURS.len()]
}

/// The first colour from `start` on whose lightness is free, or else that is free, or else that one.
fn free(start: usize, taken: &[bool; COLOURS.len()]) -> usize {
    let slots = || (0..COLOURS.len()).map(|step| (start + step) % COLOURS.len());
    let is_light_free = |slot: &usize| {
        taken
            .iter()
            .skip(slot % LEVELS)
            .step_by(LEVELS)
            .all(|taken| !taken)
    };
    slots()
        .find(is_light_free)
        .or_else(|| slots().find(|slot| !taken[*slot]))
        .unwrap_or(start % COLOURS.len())
}

/// The squared edges over the first of them, to six decimals; the same text in every field.
fn key(shape: &Shape) -> String {
    let first = shape.squared_edges.first();
    let ratio = |x: &Number| first.and_then(|first| x.divide(first));
    let width = Rational::from_signeds(1_i64, 1_000_000_000_000);
    let ratios = shape.squared_edges.iter().filter_map(ratio);
    let decimals = ratios.map(|x| rounded_nearest(&x.enclosure(&width).0, 6));
    decimals.collect::<Vec<_>>().join(" ")
}

/// FNV-1a with 64 bits, the same on every machine.
fn hash(text: &str) -> usize {
    let step = |hash: u64, byte: u8| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
    let hash = text.bytes().fold(0xcbf2_9ce4_8422_2325, step);
    (hash % COLOURS.len() as u64) as usize
}

#[cfg(test)]
mod tests {
    use super::{COLOURS, LEVELS, Palette};
    use acutile_catalog::build;
    use acutile_core::quality::shapes;
    use acutile_core::tiling::{AnyTiling, supercell};
    use std::collections::{BTreeSet, HashMap};

    /// CIE 1976, from sRGB.
    fn lightness(colour: [u8; 3]) -> f64 {
        let linear = colour.map(|x| {
            let x = f64::from(x) / 255.0;
            if x <= 0.04045 {
                x / 12.92
            } else {
                ((x + 0.055) / 1.055).powf(2.4)
            }
        });
        116.0 * (0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]).cbrt() - 16.0
    }

    #[test]
    fn columns_are_eight_apart_in_lightness() {
        for (i, a) in COLOURS.iter().enumerate() {
            for (j, b) in COLOURS.iter().enumerate() {
                let apart = (lightness(*a) - lightness(*b)).abs();
                assert_eq!(apart < 8.0, i % LEVELS == j % LEVELS, "{a:?} {b:?}");
            }
        }
    }

    /// The classes of several structures, by their edges: equal shapes have equal colours, whatever else is there.
    #[test]
    fn congruent_simplices_have_one_colour_in_all_tilings() {
        let mut colours: HashMap<String, [u8; 3]> = HashMap::new();
        let mut shared = 0;
        for name in [
            "a15", "z", "sigma", "h", "c15", "c14", "mu", "a15-bcc", "bcc",
        ] {
            let Ok(AnyTiling::Space(tiling)) = build(name) else {
                panic!("{name}");
            };
            let shapes = shapes(&tiling);
            let palette = Palette::of(&shapes);
            for (class, shape) in shapes.iter().enumerate() {
                let known = colours.insert(super::key(shape), palette.colour(class));
                shared += usize::from(known.is_some());
                assert!(
                    known.is_none_or(|other| other == palette.colour(class)),
                    "{name}"
                );
            }
            let different: BTreeSet<_> = palette.colours().iter().collect();
            assert_eq!(different.len(), shapes.len(), "{name}");
            if shapes.len() <= LEVELS {
                let levels: BTreeSet<u64> = palette
                    .colours()
                    .iter()
                    .map(|c| (lightness(*c) / 8.0) as u64)
                    .collect();
                assert_eq!(levels.len(), shapes.len(), "{name}");
            }
        }
        assert!(shared > 15);
    }

    #[test]
    fn other_shapes_do_not_depend_on_the_order_of_simplices() {
        let Ok(AnyTiling::Space(tiling)) = build("slab") else {
            panic!("slab");
        };
        let found = |tiling| {
            let shapes = shapes(tiling);
            let colours = Palette::of(&shapes).0;
            let edges = shapes.into_iter().map(|shape| shape.squared_edges);
            edges
                .zip(colours)
                .collect::<std::collections::BTreeMap<_, _>>()
        };
        let mut turned = supercell(&tiling, [2, 1, 1]);
        let first = found(&tiling);
        turned.corners.rotate_left(4 * 17);
        assert_eq!(found(&turned), first);
        assert_eq!(first.values().collect::<BTreeSet<_>>().len(), 7);
    }
}
