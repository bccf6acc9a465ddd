//! Constructions for all values of their parameters in a box.

use super::make::{PLANE, SLAB, SOLID, SPACE, STRUCTURE, TILINGS, parameters, stating};
use crate::entry::Entry;
use crate::families;

pub const ENTRIES: &[Entry] = &[
    parameters(
        "goldberg-1-all",
        SPACE,
        TILINGS,
        "Goldberg's first family for every ratio, s = e²/(a² + e²)",
        families::goldberg_1,
    ),
    parameters(
        "goldberg-1-nonobtuse",
        SPACE,
        TILINGS,
        "Goldberg's first family where no angle is obtuse: e² >= 2a²",
        families::goldberg_1_nonobtuse,
    ),
    parameters(
        "goldberg-2-all",
        SPACE,
        TILINGS,
        "Goldberg's second family for every ratio, s = e²/(a² + e²)",
        families::goldberg_2,
    ),
    parameters(
        "triangle-tiling-all",
        PLANE,
        "section 1",
        "copies of any acute triangle",
        families::triangle_tiling,
    ),
    stating(
        parameters(
            "two-corners-all",
            SOLID,
            "section 3.2",
            "two acute tetrahedra, for every epsilon for which they are not Delaunay",
            families::two_corners,
        ),
        &["not-delaunay"],
    ),
    parameters(
        "slab-all",
        SLAB,
        "section 4.3",
        "the slab with its heights in a box around the paper's",
        families::slab_heights,
    ),
    parameters(
        "slab-stretch-all",
        SLAB,
        "section 4.3",
        "the slab over grids with squared sides w from 100/3 to 64",
        families::slab_stretch,
    ),
    parameters(
        "z-all",
        SPACE,
        STRUCTURE,
        "Z, stretched along its axis by t = (c/a)²",
        families::z,
    ),
    parameters(
        "a15-all",
        SPACE,
        STRUCTURE,
        "A15, stretched along an axis by t = (c/a)²",
        families::a15,
    ),
    parameters(
        "c14-all",
        SPACE,
        "Laves phase and section 4.2",
        "C14 from the ideal Laves phase to the icosahedra in layers",
        families::c14,
    ),
];
