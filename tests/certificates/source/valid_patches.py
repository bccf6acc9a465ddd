"""Systems of patches for which every claim is true."""
from fractions import Fraction as F

from .patches import slab_of_cubes, slab_with_middles, system, with_middle
from .tilings import SQRT3, kuhn_simplices

KUHN = list(kuhn_simplices(3))
UNIT = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
HALF = F(1, 2)
SQUARE_TILE = [[0, 0], [1, 0], [1, 1], [0, 1]]
# Sommerville's tetrahedron: 60 and 90 degrees, squared ratio 5/12.
RIGHT = ["largest dihedral angle", "maximum", 0, 0]
SIXTY = ["smallest dihedral angle", "minimum", 1, F(1, 4)]
RATIO = ["squared radius-edge ratio", "maximum", F(5, 12)]


def square_tile(heights=1, offsets=None):
    """Unit squares; a period of several cells has its first basis vector as long as they are."""
    return with_middle(SQUARE_TILE, [HALF, HALF], [0] * 4, heights, offsets)


def triangle_tile():
    return with_middle([[0, 0], [1, 0], [HALF, [0, HALF]]], [HALF, [0, F(1, 6)]], [0] * 3)


def rectangles_and_segments():
    """Slabs of the heights 1 and 2, with the middles of their cells; those of height 1 are bcc."""
    return [slab_with_middles(0, 1), slab_with_middles(0, 2)]


VALID_PATCHES = {
    # Stacks of slabs of bcc: only one, in different heights of the base.
    "patches-slabs-of-bcc": system([slab_with_middles(0, 1)], UNIT, ["nonobtuse", RIGHT, SIXTY, RATIO, "Delaunay"], 2),
    "patches-slabs-of-bcc-higher-up": system([slab_with_middles(F(5, 2), F(7, 2))], UNIT, ["nonobtuse", RIGHT, "Delaunay"], 2),
    "patches-slabs-of-two-heights": system(rectangles_and_segments(), UNIT, [], 2),
    "patches-slabs-of-cubes": system([slab_of_cubes(0, 1, KUHN), slab_of_cubes(0, 3, KUHN)], UNIT, ["nonobtuse", RIGHT, "weakly Delaunay"], 2),
    "patches-slabs-of-cubes-in-two-classes": system(
        [slab_of_cubes(0, 1, KUHN, (3, -7)), slab_of_cubes(0, 2, KUHN, (-7, 3))], UNIT, ["nonobtuse"], 2),
    "patches-slabs-moved-by-the-lattice": system([slab_with_middles(0, 1, [[0, 0], [2, -3]])], UNIT, ["nonobtuse", "Delaunay"], 2),
    "patches-prisms-of-bcc": system([square_tile()], UNIT, ["nonobtuse", RIGHT, SIXTY, RATIO, "Delaunay"], 1),
    "patches-prisms-of-bcc-of-two-cells": system(
        [square_tile(2)], [[4, 0, 0], [0, 1, 0], [0, 0, 1]], ["nonobtuse", RIGHT, "Delaunay"], 1),
    # By half a period at every second side: around each vertex of four squares the moves close.
    "patches-prisms-of-bcc-with-offsets": system(
        [square_tile(2, [[0], [HALF], [0], [HALF]])], [[4, 0, 0], [0, 1, 0], [0, 0, 1]], ["nonobtuse", RIGHT, "Delaunay"], 1),
    "patches-prisms-over-squares-and-triangles": system([square_tile(), triangle_tile()], UNIT, [], 1, SQRT3),
    "patches-prisms-over-a-square-turned": system(
        [with_middle([[0, 0], [1, 1], [0, 2], [-1, 1]], [0, 1], [5] * 4)], [[2, 0, 0], [0, 1, 0], [0, 0, 1]],
        ["nonobtuse", RIGHT, "Delaunay"], 1),
}
