"""False claims about regions: the boundary meets itself (X), or something is covered twice (W).

The coordinates are small, so that a person sees whether two facets meet.
"""
import itertools
from dataclasses import replace
from fractions import Fraction as F

from .build import Tiling, facets, listed
from .regions import CAVITY, CORNER, NINE, THREE, beside, cells, lone, periodic, region, small
from .tilings import CUBE, ROOT, SQRT3, SQUARE_GRAM
from .wrong import TINY, fold, in_the_cavity, moved, together

MESH = region(*cells((0, 0, 0)))


# --- regions: the boundary meets itself -----------------------------------------------------

def with_corner(*points):
    """A large tetrahedron with a corner at 0, and another one outside that touches it or pierces it."""
    return region(*beside(CORNER, lone(*points))).certificate()


def sharing(second, *points):
    """The large tetrahedron, and another one that has some of its vertices: by their numbers, then its own points."""
    return region([*CORNER[0], *points], [[0, 1, 2, 3], second]).certificate()


WRONG_VERTEX = (1, F(3, 2), F(4, 3))

MEETS = {
    "vertex-in-a-facet": with_corner((1, 1, 0), (1, 2, -1), (2, 1, -1), (1, 1, -2)),
    "vertex-on-an-edge": with_corner((2, 0, 0), (2, -1, -1), (2, -2, -1), (3, -1, -2)),
    "vertex-on-a-vertex": with_corner((4, 0, 0), (5, 0, 0), (5, 1, 0), (5, 0, 1)),
    "edges-cross": with_corner((1, -1, -1), (1, 1, 1), (1, 1, -9), (2, -2, -9)),
    "edge-on-an-edge": with_corner((1, 0, 0), (2, 0, 0), (1, -1, -1), (2, -1, -2)),
    "edge-in-a-facet": with_corner((1, 1, 0), (2, 1, 0), (1, 1, -1), (2, 2, -2)),
    "vertex-pierces": with_corner((1, 1, 1), (1, 2, -1), (2, 1, -1), (1, 1, -2)),
    "edge-passes-through": with_corner((1, 1, -9), (1, 1, 9), (11, 11, 9), (11, 12, 9)),
    "facet-in-a-facet": with_corner((1, 1, 0), (2, 1, 0), (1, 2, 0), (1, 1, -2)),
    "facets-overlap": with_corner((1, 1, 0), (5, 1, 0), (1, 5, 0), (1, 1, -2)),
    "star-of-david": region(*beside(lone((0, 4, 0), (-3, -2, 0), (3, -2, 0), (0, 0, 5)),
                                    lone((0, -4, 0), (-3, 2, 0), (3, 2, 0), (0, 0, -5)))).certificate(),
    "same-facet-with-other-vertices": with_corner((0, 0, 0), (4, 0, 0), (0, 4, 0), (0, 0, -4)),
    "same-place": region(*beside(CORNER, CORNER)).certificate(),
    "slightly": with_corner((1, 1, TINY), (1, 2, -1), (2, 1, -1), (1, 1, -2)),
    "common-vertex-and-through-a-facet": sharing([3, 4, 5, 6], (1, 1, 1), (9, 9, -8), (9, 10, -8)),
    "common-vertex-and-crossing-in-a-plane": sharing([0, 4, 5, 6], (1, 2, 0), (5, 1, 0), (2, 2, -3)),
    "common-vertex-and-along-an-edge": sharing([0, 4, 5, 6], (2, 0, 0), (1, -1, -1), (1, -1, -2)),
    "common-vertex-and-a-vertex-on-the-opposite-edge": sharing([0, 4, 5, 6], (2, 2, 0), (2, 1, -3), (3, 1, -5)),
    "common-edge-and-folded": sharing([0, 1, 4, 5], (1, 1, 0), (1, 1, -3)),
    "common-edge-and-folded-beyond": sharing([0, 1, 4, 5], (9, 1, 0), (1, 1, -3)),
    "in-a-cavity-touching-its-surface": in_the_cavity(
        WRONG_VERTEX, (F(3, 2),) * 3, (F(3, 2), F(5, 4), F(4, 3)), (F(4, 3), F(3, 2), F(5, 4))).certificate(),
    "over-sqrt-3": region(
        [(0, 0, 0), (1, 0, 0), (0, ROOT, 0), (0, 0, 1), (0, [0, F(1, 2)], 0), (-1, 0, 0), (-1, ROOT, 0), (-1, 1, 1)],
        [[0, 1, 2, 3], [4, 5, 6, 7]], field=SQRT3).certificate(),
    "beyond-64-bits": region(*beside(([tuple(x * 10**40 for x in v) for v in CORNER[0]], CORNER[1]),
                                     lone((10**40, 10**40, 1), (1, 2, -1), (2, 1, -1), (1, 1, -2)))).certificate(),
    "two-cubes-at-a-vertex-with-two-numbers": region(*beside(cells((0, 0, 0)), cells((1, 1, 1)))).certificate(),
    "two-cubes-at-an-edge-with-four-numbers": region(*beside(cells((0, 0, 0)), cells((1, 1, 0)))).certificate(),
    "two-cubes-at-a-face-with-eight-numbers": region(*beside(cells((0, 0, 0)), cells((1, 0, 0)))).certificate(),
}


def plane(*triangles):
    return region(*beside(*(lone(*t) for t in triangles))).certificate()


LARGE = ((0, 0), (4, 0), (0, 4))
FLAT = {
    "plane-edges-cross": plane(LARGE, ((1, -1), (1, 1), (2, -2))),
    "plane-vertex-on-an-edge": plane(LARGE, ((1, 0), (1, -1), (2, -1))),
    "plane-vertex-on-a-vertex": plane(LARGE, ((4, 0), (5, 0), (5, 1))),
    "plane-edge-on-an-edge": plane(LARGE, ((1, 0), (2, 0), (1, -1))),
    "plane-edge-around-an-edge": plane(((1, 0), (2, 0), (1, 1)), ((0, 0), (4, 0), (2, -1))),
    "plane-same-place": plane(LARGE, LARGE),
    "plane-common-vertex-and-folded": region([*LARGE, (2, 0), (2, -1)], [[0, 1, 2], [0, 3, 4]]).certificate(),
    "plane-common-vertex-and-through": region([*LARGE, (3, 3), (3, 2)], [[0, 1, 2], [0, 3, 4]]).certificate(),
    "plane-over-sqrt-3": region([(0, 0), (1, ROOT), (0, 3), (1, [0, 1]), (2, 0), (2, 1)], [[0, 1, 2], [3, 4, 5]],
                                field=SQRT3).certificate(),
    "plane-two-cells-at-a-vertex-with-two-numbers": region(*beside(cells((0, 0)), cells((1, 1)))).certificate(),
}


def triangle(rank, *points):
    return Tiling(SQUARE_GRAM, list(points), [[[v, *[0] * rank] for v in range(3)]], ("region", rank)).turned()


def two_triangles(rank, *points):
    simplices = [[[v + s, *[0] * rank] for v in range(3)] for s in (0, 3)]
    return Tiling(SQUARE_GRAM, list(points), simplices, ("region", rank)).turned()


VOID = [c for c in itertools.product((0, 1), repeat=3) if c != (1, 1, 1)]


def tetrahedra(rank, *simplices, gram=CUBE):
    points = [list(p) for simplex in simplices for p in simplex]
    rows = [[[4 * s + v, *[0] * rank] for v in range(4)] for s in range(len(simplices))]
    return Tiling(gram, points, rows, ("region", rank)).turned()


def cube_filling():
    """Kuhn's tetrahedra of the cube at (1, 1, 1) with vertices of their own: the points are moved by a period."""
    points, simplices = cells((1, 1, 1))
    mesh = periodic((2, 2, 2), *VOID)
    n = len(mesh.vertices)
    return replace(mesh, vertices=[*mesh.vertices, *([F(x, 2) for x in p] for p in points)],
                   simplices=[*mesh.simplices, *([[n + v, 0, 0, 0] for v in s] for s in simplices)]).turned()


AFTER_TRANSLATION = {
    # The lower edge is longer than the period.
    "rank-1-edge-on-its-translate": triangle(1, (0, 0), (F(3, 2), 0), (0, 1)).certificate(),
    "rank-1-edge-through-its-translate": triangle(1, (0, 0), (F(5, 2), F(1, 2)), (F(1, 4), 1)).certificate(),
    # Each edge between two triangles has its mate; only an edge of the strip and its own translate meet.
    "rank-1-strip-of-twice-the-period": Tiling(
        SQUARE_GRAM, [[0, 0], [0, 1]], [[[0, 0], [0, 2], [1, 0]], [[0, 2], [1, 2], [1, 0]]], ("region", 1)).certificate(),
    "rank-1-vertex-with-two-names": triangle(1, (0, 0), (1, 0), (F(1, 2), 1)).certificate(),
    "rank-1-vertex-on-a-translated-edge":
        two_triangles(1, (0, 0), (F(1, 2), 0), (0, 1), (F(13, 4), 0), (F(13, 4), -1), (F(7, 2), -1)).certificate(),
    "rank-2-across-the-second-direction": triangle(2, (0, 0), (F(1, 2), 0), (F(1, 4), F(3, 2))).certificate(),
    "rank-2-across-the-diagonal-only": triangle(2, (0, 0), (F(13, 10), F(12, 10)), (F(12, 10), F(13, 10))).certificate(),
    "rank-2-far-translate": two_triangles(2, (0, 0), (F(1, 2), 0), (0, F(1, 2)),
                                          (F(801, 8), F(-799, 8)), (F(807, 8), F(-799, 8)), (F(807, 8), F(-793, 8))).certificate(),
    "rank-1-tetrahedron-through-its-translate":
        tetrahedra(1, ((0, 0, 0), (F(5, 2), 0, 0), (0, 1, 0), (0, 0, 1))).certificate(),
    "rank-2-vertex-with-two-names": tetrahedra(2, ((0, 0, 0), (F(1, 2), F(1, 2), 1), (1, 0, 0), (F(1, 2), 0, 1))).certificate(),
    "rank-3-filling-pierces-its-void":
        periodic((2, 2, 2), *VOID, extra=[small(F(5, 4), F(5, 4), F(5, 4), 1)[0]]).certificate(),
    "rank-3-filling-touches-its-void":
        periodic((2, 2, 2), *VOID, extra=[small(F(5, 4), F(5, 4), 1, F(1, 2))[0]]).certificate(),
    "rank-3-void-filled-with-other-vertices": cube_filling().certificate(),
    "rank-3-filling-of-another-void-pierces":
        periodic((2, 2, 2), *VOID, extra=[small(F(21, 4), F(-11, 4), F(21, 4), 1)[0]]).certificate(),
}

# --- regions: covering ----------------------------------------------------------------------

HALF_MOVED = [[x + F(1, 2) for x in v] for v in cells((0, 0, 0))[0]]

COVERING = {
    "tetrahedron-inside": region(*beside(CORNER, small(F(1, 2), F(1, 2), F(1, 2)))),
    "tetrahedron-inside-of-a-mesh": region(*beside(cells(*THREE), small(F(5, 4), F(7, 6), F(9, 7)))),
    "cube-inside-of-a-mesh": region(*beside(cells(*THREE), (HALF_MOVED, cells((0, 0, 0))[1]))),
    "inside-with-a-common-vertex": region([*CORNER[0], (1, F(1, 2), F(1, 3)), (F(1, 2), 1, F(1, 3)), (F(1, 3), F(1, 2), 1)],
                                          [[0, 1, 2, 3], [0, 4, 5, 6]]),
    "inside-with-a-common-edge":
        region([*CORNER[0], (1, F(1, 2), F(1, 3)), (1, F(1, 3), F(1, 2))], [[0, 1, 2, 3], [0, 1, 4, 5]]),
    "inside-of-a-piece-in-a-cavity":
        region(*beside(CAVITY, small(F(5, 4), F(5, 4), F(5, 4)), small(F(21, 16), F(21, 16), F(21, 16), F(1, 100)))),
    "between-a-cavity-and-the-outside": region(*beside(CAVITY, small(F(1, 4), F(5, 4), F(5, 4), F(1, 9)))),
    "three-deep": region(*beside(CORNER, small(F(1, 2), F(1, 2), F(1, 2), 1), small(F(5, 8), F(5, 8), F(5, 8)))),
    "over-sqrt-3": region(*beside(([(0, 0, 0), (9, 0, 0), (0, [0, 9], 0), (0, 0, 9)], [[0, 1, 2, 3]]),
                                  ([(1, 1, 1), (2, 1, 1), (1, ROOT, 1), (1, 1, 2)], [[0, 1, 2, 3]])), field=SQRT3),
    "inside-listed-first": region(*beside(small(F(1, 2), F(1, 2), F(1, 2)), CORNER)),
    "plane-triangle-inside": region(*beside(lone(*LARGE), lone((F(1, 2), F(1, 2)), (1, F(1, 2)), (F(1, 2), 1)))),
    "plane-inside-with-a-common-vertex": region([*LARGE, (1, F(1, 2)), (F(1, 2), 1)], [[0, 1, 2], [0, 3, 4]]),
    "plane-inside-of-a-mesh": region(*beside(cells(*NINE), lone((F(5, 4), F(9, 8)), (F(7, 4), F(9, 8)), (F(5, 4), F(7, 4))))),
    "plane-rank-1-inside-of-a-translate": two_triangles(
        1, (0, 0), (F(9, 10), 0), (F(9, 20), F(9, 10)), (F(145, 100), F(2, 10)), (F(155, 100), F(2, 10)), (F(15, 10), F(3, 10))),
    "plane-rank-2-inside-of-a-far-translate": two_triangles(
        2, (0, 0), (F(9, 10), 0), (F(9, 20), F(9, 10)), (F(1445, 100), F(-58, 10)), (F(1455, 100), F(-58, 10)), (F(1450, 100), F(-57, 10))),
    "rank-2-slab-with-one-inside": periodic((1, 1), (0, 0, 0), extra=[small(F(21, 4), F(1, 3), F(1, 8), F(1, 16))[0]]),
    "rank-3-filling-inside-of-a-cube": periodic((2, 2, 2), *VOID, extra=[small(F(33, 4), F(1, 3), F(1, 8), F(1, 16))[0]]),
    "rank-1-rod-inside-of-a-rod": together(periodic((1,), *((0, y, z) for y, z in NINE)),
                                           moved(periodic((1,), (0, 0, 0)), [F(1, 2), F(1, 2), F(1, 2)])),
}


def facet_listed_inside():
    """A facet between two tetrahedra of a cube is listed, as the first of them needs it."""
    names = [tuple(sorted(facet)) for facet in MESH.boundary()]
    inner, side = next((name, side) for name, side in facets(MESH.rows()[0]) if name not in names)
    return MESH.certificate(boundary=[*MESH.boundary(), listed(inner, side)])


REGIONS = {
    **{f"boundary-meets--{name}": c for name, c in {**MEETS, **FLAT, **AFTER_TRANSLATION}.items()},
    "boundary-meets--fold": fold((1, 1, 4)).certificate(),
    **{f"covering--{name}": tiling.certificate() for name, tiling in COVERING.items()},
    "covering--facet-between-two-tetrahedra-listed": facet_listed_inside(),
}
