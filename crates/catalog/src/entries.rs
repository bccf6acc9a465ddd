//! The table of constructions.

use super::entry::{Entry, Parameter, Recipe};
use super::{
    CatalogError, congruent, families, icosahedral, kagome, planar,
    plane_tiling::{self, PlaneTiling, built_in},
    selected, slab, solid, z_c15,
};
use acutile_core::family::AnyFamily;
use acutile_core::tiling::{AnyTiling, Tiling};
use acutile_exact::number::Number;

const STRUCTURE: &str = "section 4.1";
const TILINGS: &str = "section 2.2";

const SPACE: &str = "space";
const SLAB: &str = "slab";
const SOLID: &str = "polyhedron";
const PLANE: &str = "plane";
const POLYGON: &str = "polygon";

pub(super) static ENTRIES: &[Entry] = &[
    fixed(
        "z",
        SPACE,
        STRUCTURE,
        "TCP structure Z over the triangle tiling",
        || space(plane_tiling::triangles().structure()),
    ),
    fixed(
        "a15",
        SPACE,
        STRUCTURE,
        "TCP structure A15 over the square tiling",
        || space(plane_tiling::squares().structure()),
    ),
    fixed(
        "sigma",
        SPACE,
        STRUCTURE,
        "TCP structure sigma over the tiling 3^2.4.3.4",
        || space(plane_tiling::snub().structure()),
    ),
    fixed(
        "h",
        SPACE,
        STRUCTURE,
        "TCP structure H over the tiling 3^3.4^2",
        || space(plane_tiling::rows().structure()),
    ),
    fixed(
        "square-triangle-3464",
        SPACE,
        STRUCTURE,
        "TCP structure over 3.4.6.4 with its hexagons cut into triangles",
        || space(plane_tiling::rhombitrihexagonal().structure()),
    ),
    fixed(
        "square-triangle-inflated-3",
        SPACE,
        STRUCTURE,
        "TCP structure over the triangle tiling inflated once",
        || space(plane_tiling::triangles().inflated().structure()),
    ),
    fixed(
        "square-triangle-inflated-4",
        SPACE,
        STRUCTURE,
        "TCP structure over the square tiling inflated once",
        || space(plane_tiling::squares().inflated().structure()),
    ),
    fixed(
        "square-triangle-inflated-32434",
        SPACE,
        STRUCTURE,
        "TCP structure over the tiling 3^2.4.3.4 inflated once",
        || space(plane_tiling::snub().inflated().structure()),
    ),
    over_plane(
        "square-triangle:",
        SPACE,
        STRUCTURE,
        "TCP structure over the square/triangle tiling of a name or file",
        |plane| space(plane.structure()),
    ),
    over_plane(
        "z-c15:",
        SPACE,
        STRUCTURE,
        "mixture of Z and C15 over the square/triangle tiling of a name or file",
        |plane| space(z_c15::z_c15(plane)),
    ),
    fixed(
        "z-c15-3",
        SPACE,
        STRUCTURE,
        "variant that mixes Z and C15, over the triangle tiling: C15",
        || space(z_c15::z_c15(&built_in("3")?)),
    ),
    fixed(
        "z-c15-4",
        SPACE,
        STRUCTURE,
        "variant that mixes Z and C15, over the square tiling: Z",
        || space(z_c15::z_c15(&built_in("4")?)),
    ),
    fixed(
        "z-c15-33344",
        SPACE,
        STRUCTURE,
        "variant that mixes Z and C15, over the tiling 3^3.4^2",
        || space(z_c15::z_c15(&built_in("33344")?)),
    ),
    fixed(
        "z-c15-32434",
        SPACE,
        STRUCTURE,
        "variant that mixes Z and C15, over the tiling 3^2.4.3.4",
        || space(z_c15::z_c15(&built_in("32434")?)),
    ),
    fixed(
        "icosahedral",
        SPACE,
        "section 4.2",
        "icosahedra with a vertical 3-fold axis in layers",
        || space(icosahedral::icosahedral()),
    ),
    fixed(
        "c15",
        SPACE,
        STRUCTURE,
        "TCP structure C15: diamond with selected circumcentres",
        || space(selected::c15()),
    ),
    fixed(
        "a15-bcc",
        SPACE,
        STRUCTURE,
        "bcc with the circumcentres of the black tetrahedra",
        || space(selected::a15_bcc()),
    ),
    fixed(
        "c14",
        SPACE,
        "Laves phase",
        "TCP structure C14: kagome layers +-",
        || space(kagome::kagome("+-")),
    ),
    fixed(
        "c36",
        SPACE,
        "Laves phase",
        "TCP structure C36: kagome layers ++--",
        || space(kagome::kagome("++--")),
    ),
    fixed(
        "mu",
        SPACE,
        "Frank and Kasper 1959",
        "TCP structure mu: kagome layers z+",
        || space(kagome::kagome("z+")),
    ),
    family(
        "kagome:",
        SPACE,
        "Frank and Kasper 1959",
        "kagome layers stacked by a word of z, +, -",
        |word| space(kagome::kagome(word)),
    ),
    fixed(
        "slab",
        SLAB,
        "section 4.3",
        "acute slab between two parallel planes, in eight steps",
        || space(Ok(slab::slab())),
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
    parameters(
        "two-corners-all",
        SOLID,
        "section 3.2",
        "two acute tetrahedra, for every epsilon for which they are not Delaunay",
        families::two_corners,
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

const fn fixed(
    name: &'static str,
    domain: &'static str,
    source: &'static str,
    description: &'static str,
    recipe: fn() -> Result<AnyTiling, CatalogError>,
) -> Entry {
    Entry {
        name,
        description,
        source,
        domain,
        parameter: None,
        recipe: Recipe::Fixed(recipe),
    }
}

const fn family(
    name: &'static str,
    domain: &'static str,
    source: &'static str,
    description: &'static str,
    recipe: fn(&str) -> Result<AnyTiling, CatalogError>,
) -> Entry {
    Entry {
        name,
        description,
        source,
        domain,
        parameter: None,
        recipe: Recipe::Word(recipe),
    }
}

/// A family over plane tilings by squares and triangles.
const fn over_plane(
    name: &'static str,
    domain: &'static str,
    source: &'static str,
    description: &'static str,
    recipe: fn(&PlaneTiling) -> Result<AnyTiling, CatalogError>,
) -> Entry {
    Entry {
        name,
        description,
        source,
        domain,
        parameter: None,
        recipe: Recipe::Plane(recipe),
    }
}

const fn number(
    name: &'static str,
    domain: &'static str,
    source: &'static str,
    description: &'static str,
    parameter: Parameter,
    recipe: fn(&Number) -> Tiling<3>,
) -> Entry {
    Entry {
        name,
        description,
        source,
        domain,
        parameter: Some(parameter),
        recipe: Recipe::Number(recipe),
    }
}

/// A tiling for each point of a box.
const fn parameters(
    name: &'static str,
    domain: &'static str,
    source: &'static str,
    description: &'static str,
    recipe: fn() -> Result<AnyFamily, CatalogError>,
) -> Entry {
    Entry {
        name,
        description,
        source,
        domain,
        parameter: None,
        recipe: Recipe::Parameters(recipe),
    }
}

fn space(tiling: Result<Tiling<3>, CatalogError>) -> Result<AnyTiling, CatalogError> {
    tiling.map(AnyTiling::Space)
}

fn plane(tiling: Result<Tiling<2>, CatalogError>) -> Result<AnyTiling, CatalogError> {
    tiling.map(AnyTiling::Plane)
}
