//! The other single tilings of the paper.

use super::make::{
    OPTIMIZED, PLANE, POLYGON, SLAB, SOLID, SPACE, TILINGS, family, fixed, number, optimized,
    plane, space,
};
use crate::entry::{Entry, Parameter};
use crate::{best, congruent, planar, slab, solid};

pub const ENTRIES: &[Entry] = &[
    fixed(
        "slab",
        SLAB,
        "section 4.3",
        "acute slab between two parallel planes, in eight steps",
        || space(Ok(slab::slab())),
    ),
    optimized(
        "slab",
        fixed(
            "slab-best",
            SLAB,
            OPTIMIZED,
            "the slab with the largest dihedral angle below 77.34 degrees",
            || space(Ok(best::slab_best())),
        ),
    ),
    fixed(
        "slab-stack",
        SPACE,
        "section 4.3",
        "the slab repeated to fill space",
        || space(Ok(slab::slab_stack())),
    ),
    fixed(
        "bcc",
        SPACE,
        TILINGS,
        "Sommerville II: Delaunay triangulation of bcc",
        || space(congruent::sommerville_2()),
    ),
    fixed(
        "sommerville-1",
        SPACE,
        TILINGS,
        "Sommerville I, 24 in a cube",
        || space(Ok(congruent::sommerville_1())),
    ),
    fixed(
        "sommerville-2",
        SPACE,
        TILINGS,
        "Sommerville II, the same as bcc",
        || space(congruent::sommerville_2()),
    ),
    fixed(
        "sommerville-3",
        SPACE,
        TILINGS,
        "Sommerville III, 12 in a cube",
        || space(Ok(congruent::sommerville_3())),
    ),
    fixed(
        "sommerville-4",
        SPACE,
        TILINGS,
        "Sommerville IV, a quarter of II",
        || space(congruent::sommerville_4()),
    ),
    number(
        "goldberg-1",
        SPACE,
        TILINGS,
        "Goldberg's first family",
        Parameter {
            name: "a/e",
            default: "1/2",
        },
        congruent::goldberg_1,
    ),
    number(
        "goldberg-2",
        SPACE,
        TILINGS,
        "Goldberg's second family",
        Parameter {
            name: "a/e",
            default: "1/2",
        },
        congruent::goldberg_2,
    ),
    number(
        "goldberg-3",
        SPACE,
        TILINGS,
        "Goldberg's third family: face to face for two ratios only",
        Parameter {
            name: "a/e",
            default: "sqrt(2)/2",
        },
        congruent::goldberg_3,
    ),
    fixed(
        "cube-5",
        SPACE,
        TILINGS,
        "cubes cut into five tetrahedra",
        || space(Ok(congruent::cube_5())),
    ),
    fixed(
        "cube-6",
        SPACE,
        TILINGS,
        "cubes cut into six tetrahedra",
        || space(Ok(congruent::cube_6())),
    ),
    fixed("regular", SOLID, "Table 1", "a regular tetrahedron", || {
        space(Ok(solid::regular()))
    }),
    fixed(
        "cube-corner",
        SOLID,
        "Table 1",
        "the corner of a cube",
        || space(Ok(solid::cube_corner())),
    ),
    number(
        "two-corners",
        SOLID,
        "section 3.2",
        "two acute tetrahedra that are not Delaunay",
        Parameter {
            name: "epsilon",
            default: "1/10",
        },
        solid::two_corners,
    ),
    fixed(
        "equilateral",
        PLANE,
        "section 1",
        "equilateral triangles in the plane",
        || plane(planar::equilateral()),
    ),
    fixed(
        "triangle-tiling",
        PLANE,
        "section 1",
        "copies of the triangle with sides 4, 5, 6",
        || plane(planar::triangle_tiling("4,5,6")),
    ),
    family(
        "triangle-tiling:",
        PLANE,
        "section 1",
        "copies of the triangle with three given sides, 4,5,6",
        |sides| plane(planar::triangle_tiling(sides)),
    ),
    fixed(
        "square-8",
        POLYGON,
        "section 2.1",
        "a square cut into eight acute triangles",
        || plane(Ok(planar::square_8())),
    ),
    fixed(
        "square-10",
        POLYGON,
        "section 2.1",
        "a square cut into ten acute triangles",
        || plane(Ok(planar::square_10())),
    ),
    fixed(
        "square-14",
        POLYGON,
        "section 2.1",
        "a square cut into fourteen triangles, largest angle 72 degrees",
        || plane(planar::square_14()),
    ),
];
