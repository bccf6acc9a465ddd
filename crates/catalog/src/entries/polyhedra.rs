//! Polyhedra cut into acute tetrahedra, and the solids that their mirror images fill.

use super::make::{PRISM, SOLID, SPACE, family, fixed, large, space, stating};
use crate::cell600::{cube, dodecahedron, prism};
use crate::entry::Entry;

const CUBES: &str = "600-cell; existence arXiv:0909.3706, arXiv:0905.3715";
const CELL: &str = "600-cell; compare arXiv:0909.3706";

pub const ENTRIES: &[Entry] = &[
    fixed(
        "dodecahedron-470",
        SOLID,
        CELL,
        "the regular dodecahedron in 470 acute tetrahedra",
        || space(dodecahedron::dodecahedron_470()),
    ),
    fixed(
        "tetrahedron-543",
        SOLID,
        CELL,
        "the regular tetrahedron in 543 acute tetrahedra",
        || space(cube::tetrahedron_543()),
    ),
    fixed(
        "prism-533",
        SOLID,
        CELL,
        "a right prism over a regular triangle in 533 acute tetrahedra",
        || space(prism::prism_533()),
    ),
    fixed(
        "pentagonal-prism-515",
        SOLID,
        CELL,
        "a right prism over a regular pentagon in 515 acute tetrahedra",
        || space(prism::pentagonal_prism_515()),
    ),
    large(
        "cube-2715",
        SOLID,
        CUBES,
        "the cube in 2,715 acute tetrahedra",
        || space(cube::cube_2715()),
    ),
    large(
        "octahedron-4344",
        SOLID,
        CELL,
        "the regular octahedron in 4,344 acute tetrahedra",
        || space(cube::octahedron_4344()),
    ),
    large(
        "square-prism",
        PRISM,
        CUBES,
        "the infinite square prism: mirror images of the cube",
        || space(cube::square_prism()),
    ),
    stating(
        large(
            "cube-space",
            SPACE,
            CUBES,
            "space with three families of mirror planes: cubes in 2,715 tetrahedra",
            || space(cube::cube_space()),
        ),
        &["plane:x1+x2=0", "plane:x1+x3=0", "plane:x2+x3=0"],
    ),
    family(
        "box:",
        SOLID,
        CUBES,
        "the box with three given integer sides, 2,1,1: mirror images of the cube",
        |sides| space(cube::from_word(sides)),
    ),
];
