"""Systems of patches of which something is false, malformed ones, and one that is declined."""
from dataclasses import replace
from fractions import Fraction as F

from .build import edit
from .field import Field
from .patches import slab_of_cubes, slab_with_middles, system, with_middle
from .valid_patches import HALF, KUHN, RIGHT, UNIT, rectangles_and_segments, square_tile
from .wrong import edited

BCC = system([slab_with_middles(0, 1)], UNIT, ["nonobtuse", RIGHT, "Delaunay"], 2)
PRISM = system([square_tile()], UNIT, ["nonobtuse"], 1)
LONG_CELL = [[4, 0, 0], [0, 1, 0], [0, 0, 1]]
# The cube's tetrahedra, seen from above in a mirror: the diagonals of its walls are the other ones.
MIRRORED = [[[1 - c[0], *c[1:]] for c in simplex] for simplex in KUHN]
TILE, PATCH = ("claim", "tiles", 0), ("witness", 0)


def with_offsets(*offsets):
    return system([square_tile(2, [[x] for x in offsets])], LONG_CELL, [], 1)


def leaning_tile(middle):
    """A parallelogram with the angles 45 and 135 degrees, whose long sides lean beyond the short ones."""
    return with_middle([[0, 0], [1, 0], [3, 2], [2, 2]], middle, [0, 1, 0, 1])


def tower():
    return with_middle([[0, 0], [1, 0], [1, 10], [0, 10]], [HALF, 5], [0, 2, 0, 2])


def with_inner_pyramid():
    """A tetrahedron of the piece stands as a pyramid over one of its facets."""
    patch = slab_with_middles(0, 1)
    *rest, (a, b, c, d) = patch.tetrahedra
    return replace(patch, tetrahedra=rest, pyramids=[*patch.pyramids, (a, [b, c, d])])


def kuhn_prism():
    """A cube in six, along the lattice; each side has its own class and may meet its own turned copy."""
    corners = [(x, y) for x in (0, 1) for y in (0, 1)]
    tetrahedra = [[(corners.index((c[1], c[2])), c[0]) for c in simplex] for simplex in KUHN]
    return replace(square_tile(), classes=[0, 1, 2, 3], vertices=[[0, *c] for c in corners], tetrahedra=tetrahedra, pyramids=[])


FALSE_PATCHES = {
    "gram-not-positive--patches": system([slab_with_middles(0, 1)], [[1, 1, 0], [1, 1, 0], [0, 0, 1]], [], 2),
    "gram-blocks--slab": system([slab_with_middles(0, 1)], [[2, 0, 1], [0, 2, 0], [1, 0, 2]], [], 2),
    "gram-blocks--prism": system([square_tile()], [[2, 0, 1], [0, 2, 0], [1, 0, 2]], [], 1),
    "tile-order--slab": edited(BCC, ((*TILE, "vertices"), [[1], [0]])),
    "tile-order--clockwise": edited(PRISM, ((*TILE, "vertices"), [[0, 0], [0, 1], [1, 1], [1, 0]])),
    "pyramid-side--inside": system([with_inner_pyramid()], UNIT, [], 2),
    "wall-pattern--other-diagonals": system([slab_of_cubes(0, 1, KUHN), slab_of_cubes(0, 1, MIRRORED)], UNIT, [], 2),
    "wall-pattern--moved-by-half": system([slab_with_middles(0, 1, [[0, 0], [HALF, 0]])], UNIT, [], 2),
    "wall-pattern--pyramid-and-triangles": system([slab_with_middles(0, 1), slab_of_cubes(0, 1, KUHN)], UNIT, [], 2),
    "wall-pattern--sides-of-two-lengths": system(
        [with_middle([[0, 0], [2, 0], [2, 1], [0, 1]], [1, HALF], [0] * 4)], UNIT, [], 1),
    "wall-pattern--cells-of-two-heights": system([square_tile(1), square_tile(2)], LONG_CELL, [], 1),
    "wall-reversal--diagonals": system([kuhn_prism()], UNIT, [], 1),
    "side-classes--one-side-moved": with_offsets(HALF, 0, 0, 0),
    "side-classes--two-neighbours-moved": with_offsets(HALF, HALF, 0, 0),
    "missing-join--axis-beside-the-wall": system([leaning_tile([F(3, 2), 1]), tower()], UNIT, [], 1),
    "open-facet--patches-row-missing": edit(BCC, (*PATCH, "simplices", 0), None),
    "open-facet--patches-pyramid-missing": system([replace(slab_with_middles(0, 1), pyramids=[])], UNIT, [], 2),
    "vertex-outside--patches": edited(BCC, ((*TILE, "vertices"), [[0], [1]]), ((*TILE, "denominator"), 2)),
    "not-acute--patches": system([slab_with_middles(0, 1)], UNIT, ["acute"], 2),
    "not-nonobtuse--patches-low-slabs": system([slab_with_middles(0, HALF)], UNIT, ["nonobtuse"], 2),
    "not-nonobtuse--patches-in-a-join-of-two-slabs": system(rectangles_and_segments(), UNIT, ["nonobtuse"], 2),
    "not-delaunay--patches-cubes": system([slab_of_cubes(0, 1, KUHN)], UNIT, ["Delaunay"], 2),
    "angle-bound--patches": system([slab_with_middles(0, 1)], UNIT, [["largest dihedral angle", "less than", 0, 0]], 2),
    "ratio-bound--patches": system([slab_with_middles(0, 1)], UNIT, [["squared radius-edge ratio", "less than", F(5, 12)]], 2),
    "not-attained--patches": system([slab_with_middles(0, 1)], UNIT, [["squared radius-edge ratio", "maximum", F(1, 2)]], 2),
    "edge-valence--patches-bcc": system([slab_with_middles(0, 1)], UNIT, ["TCP"], 2),
    "edge-valence--patches-prisms": system([square_tile()], UNIT, ["TCP"], 1),
}

FIRST = (*PATCH, "pyramids", 0)
MALFORMED_PATCHES = {
    "rank--0": edit(BCC, ("claim", "rank"), 0),
    "rank--3": edit(BCC, ("claim", "rank"), 3),
    "rank--beyond-64-bits": edit(BCC, ("claim", "rank"), 2 ** 64),
    "tile-count--none": edited(BCC, (("claim", "tiles"), []), (("witness",), [])),
    "tile-count--one-patch-more": edit(BCC, ("witness",), BCC["witness"] * 2),
    "tile-count--one-tile-more": edit(BCC, ("claim", "tiles"), BCC["claim"]["tiles"] * 2),
    "side-count--slab-of-three": edited(BCC, ((*TILE, "vertices"), [[0], [1], [2]]), ((*TILE, "classes"), [0, 0, 0])),
    "side-count--polygon-of-two": edited(PRISM, ((*TILE, "vertices"), [[0, 0], [1, 0]]), ((*TILE, "classes"), [0, 0])),
    "pyramid--polygon-of-two": edit(BCC, (*FIRST, 1), BCC["witness"][0]["pyramids"][0][1][:2]),
    "pyramid--first-corner-moved": edit(BCC, (*FIRST, 1, 0), [0, 0, 1]),
    "pyramid--corner-twice": edit(BCC, (*FIRST, 1, 2), BCC["witness"][0]["pyramids"][0][1][1]),
    "pyramid--apex-in-the-polygon": edit(BCC, (*FIRST, 0), BCC["witness"][0]["pyramids"][0][1][1]),
    "vertex-range--patches-apex": edit(BCC, (*FIRST, 0), 7),
    "no-simplices--patch": edit(BCC, (*PATCH, "simplices"), []),
    "canonical--patches-gram-not-primitive": edit(BCC, ("claim", "gram"), [[2, 0, 0], [2, 0], [2]]),
    "canonical--patches-shift-of-zero": edit(BCC, (*FIRST, 0), [2, 0, 0]),
    "canonical--patches-members-in-another-order": edit(BCC, PATCH, {
        key: BCC["witness"][0][key] for key in ("denominator", "vertices", "offsets", "pyramids", "simplices")}),
    "json--patches-witness-an-object": edit(BCC, ("witness",), BCC["witness"][0]),
    "json--patches-without-offsets": edit(BCC, (*PATCH, "offsets"), None),
    "json--patches-with-a-dimension": edit(BCC, ("claim",), {"dimension": 3, **BCC["claim"]}),
    "json--patches-class-a-text": edit(BCC, (*TILE, "classes", 0), "a"),
    "json--patches-one-class-more": edit(BCC, (*TILE, "classes"), [0, 0, 0]),
    "json--patches-one-offset-less": edit(BCC, (*PATCH, "offsets"), [[0, 0]]),
    "json--patches-offset-of-one": edit(BCC, (*PATCH, "offsets", 0), [0]),
    "json--patches-pyramid-without-apex": edit(BCC, FIRST, [BCC["witness"][0]["pyramids"][0][1]]),
    "json--patches-row-with-sixes": edit(BCC, (*PATCH, "simplices", 0), [*BCC["witness"][0]["simplices"][0], 0]),
    "statement-domain--patches-plane": edit(BCC, ("claim", "statements"), ["face-to-face tiling", ["uncrossed plane", [1, 0, 0], [0, 1]]]),
    "statement-domain--patches-not-delaunay": edit(BCC, ("claim", "statements"), ["face-to-face tiling", "not Delaunay"]),
    "statement-domain--patches-locally": edit(BCC, ("claim", "statements"), ["face-to-face tiling", "locally Delaunay"]),
}

# 20 cos 10°: (a³ - 3a)² = 3 for a = 2 cos 10°.
TIMES_COS_10 = Field([-3000000, 0, 90000, 0, -600, 0, 1], 19, 20)
# cos 40° = (a⁴ - 4 a² + 2) / 2 and sin 40° = cos 50° = (a⁵ - 5 a³ + 5 a) / 2.
COS_40 = [1, 0, F(-2, 100), 0, F(1, 20000)]
SIN_40 = [0, F(1, 4), 0, F(-5, 2000), 0, F(1, 200000)]


def right_and_sharp():
    """Triangles with the angles 45, 45, 90 and 40, 70, 70 degrees: eighths and parts of 36, so 72 parts of a turn."""
    middle = (F(3, 5), F(1, 5))
    return system([with_middle([[0, 0], [1, 0], [0, 1]], (F(1, 3), F(1, 3)), [0, 1, 2]),
                   with_middle([[0, 0], [1, 0], [COS_40, SIN_40]], middle, [3, 4, 5])], UNIT, [], 1, TIMES_COS_10)


# The angles of the first triangle have the tangents 4/3 and 3/4; they are no parts of a turn.
DECLINED_PATCHES = {
    "corner-angle--eighths-and-parts-of-36": right_and_sharp(),
    "corner-angle--3-4-5": system([with_middle([[0, 0], [3, 0], [0, 4]], [1, 1], [0, 1, 2])], UNIT, [], 1),
    "version--3-of-patches": edit(BCC, ("version",), 3),
}
