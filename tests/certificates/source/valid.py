"""The valid certificates. Values of bounds are calculated by hand where a comment says how."""
import itertools
from dataclasses import replace
from fractions import Fraction as F

from .build import ALL_FIGURES, Tiling, largest, ratio, smallest, uncrossed
from .field import Field
from .regions import CAVITY, CORNER, NINE, RING, THREE, beside, cells, lone, periodic, region, shaken, small
from .tilings import (BCC, CUBE, CUBE_CORNERS, CUBE_FACES, HEXAGONAL, MINUS_TWO_COS_20, REDUCIBLE, REGULAR, ROOT, SQRT3,
                      SQUARE_GRAM, TWO, TWO_COS_80, a15, block, chambers, hexagon, kuhn, lattice, moved_to_53_bits, octahedron,
                      root_power, square_triangle, strip_of_height, tetrahedron, times_root, z, z_contracted)

OBTUSE = lattice([[4, -3], [-3, 4]])
RIGHT_3_4_5 = lattice([[9, 0], [0, 16]])
REGULAR_REGION = region(*lone((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)), gram=REGULAR)


def in_domain(tiling, kind, vertices, faces):
    return replace(tiling, domain=(kind, vertices, faces))


def renamed(tiling, vertex, by):
    """The same tiling; one vertex is another representative of its orbit, which shifts move back."""
    vertices = [list(v) for v in tiling.vertices]
    vertices[vertex] = [x - b for x, b in itertools.zip_longest(vertices[vertex], by, fillvalue=0)]
    simplices = [[[p[0], *(s + b for s, b in zip(p[1:], by))] if p[0] == vertex else p for p in places]
                 for places in tiling.simplices]
    return replace(tiling, vertices=vertices, simplices=simplices)


def scaled(mesh, factor):
    vertices, simplices = mesh
    return [tuple(x * factor for x in v) for v in vertices], simplices


def triangles_near(*numbers):
    """One triangle near (n, -n) for each n: integers on both sides of a limit, with both signs."""
    return region(*beside(*(lone((n - 1, -n), (n, -n - 1), (n + 1, 1 - n)) for n in numbers)))


def two_triangles_per_unit(root, field):
    """Rectangles with the sides 1 and sqrt(root), each cut in two: the angle's squared cosine is 1 / (1 + root)."""
    return lattice([[1, 0], [0, root]], field)


# --- bounds by hand ------------------------------------------------------------------

# Equilateral triangle: 60 degrees, cosine 1/2. R = l / sqrt 3.
SIXTY = (1, F(1, 4))
# Right isosceles triangle, hypotenuse sqrt 2: 45 degrees; R = sqrt 2 / 2, l = 1.
FORTY_FIVE = (1, F(1, 2))
NINETY, HUNDRED_TWENTY = (0, 0), (-1, F(1, 4))
# cos 75 degrees is (sqrt 6 - sqrt 2) / 4, its square (2 - sqrt 3) / 4.
SEVENTY_FIVE = (1, [F(1, 2), F(-1, 4)])

# 3^3.4^2 has both triangles. Each quantity's values: largest 60, 90; smallest 45, 60; squared ratio 1/3, 1/2.
EVERY_RELATION = [
    largest("less than", *HUNDRED_TWENTY), largest("at most", *NINETY), largest("maximum", *NINETY),
    largest("more than", *FORTY_FIVE), largest("at least", *SIXTY), largest("minimum", *SIXTY),
    smallest("less than", *SEVENTY_FIVE), smallest("at most", *SIXTY), smallest("maximum", *SIXTY),
    smallest("more than", 1, F(3, 4)), smallest("at least", *FORTY_FIVE), smallest("minimum", *FORTY_FIVE),
    ratio("less than", F(501, 1000)), ratio("at most", F(1, 2)), ratio("maximum", F(1, 2)),
    ratio("more than", F(333, 1000)), ratio("at least", F(1, 3)), ratio("minimum", F(1, 3)),
]

PLANE = {
    "plane-equilateral": lattice(HEXAGONAL).certificate("acute", "nonobtuse", largest("maximum", *SIXTY), "Delaunay",
                                                        "weakly Delaunay"),
    # Obtuse triangles: the other diagonal of two of them is the shorter one; by little, so that 30 bits do not show it.
    "plane-not-delaunay": lattice([[2, -1], [-1, 2]]).certificate("not Delaunay"),
    "plane-not-delaunay-by-little": lattice([[2 * 10**13, -1], [-1, 2 * 10**13]]).certificate("not Delaunay"),
    # The product of the two edges is about -10^-15, with coefficients of 49 bits: the small integers do not show its sign.
    "plane-not-delaunay-over-sqrt-2": lattice(
        [[2**48, [423859315570607, -299713796309065]], [[423859315570607, -299713796309065], 2**48]], root_power(2)).certificate("not Delaunay"),
    "region-not-delaunay": region(*cells((0, 0)), gram=HEXAGONAL).certificate("not Delaunay"),
    "plane-equilateral-acute": lattice(HEXAGONAL).certificate("acute"),
    # Lines along the edges, each with its translates; the negative offset is that of a translate.
    "plane-uncrossed-lines": lattice(HEXAGONAL).certificate(
        uncrossed((0, 1), 0), uncrossed((1, 0), -7), uncrossed((1, 1), 20), "Delaunay"),
    "plane-equilateral-exactly-60": lattice(HEXAGONAL).certificate(
        largest("maximum", *SIXTY), largest("minimum", *SIXTY), smallest("maximum", *SIXTY), smallest("minimum", *SIXTY),
        ratio("maximum", F(1, 3)), ratio("minimum", F(1, 3))),
    "plane-equilateral-close-bounds": lattice(HEXAGONAL).certificate(
        largest("less than", 1, F(10**30 - 1, 4 * 10**30)), smallest("more than", 1, F(10**30 + 1, 4 * 10**30)),
        ratio("less than", F(10**30 + 1, 3 * 10**30)), ratio("more than", F(10**30 - 1, 3 * 10**30))),
    # Every angle is less than 180 degrees and more than 0.
    "plane-bounds-at-the-ends": OBTUSE.certificate(
        largest("less than", -1, 1), largest("more than", 1, 1), smallest("less than", -1, 1), smallest("more than", 1, 1)),
    "plane-square": lattice(SQUARE_GRAM).certificate("nonobtuse", largest("maximum", *NINETY), largest("minimum", *NINETY),
                                                     "weakly Delaunay"),
    "plane-obtuse": OBTUSE.certificate(),
    # The edges 2, 2 and sqrt 14 with -3/4 for the cosine between the first two; 14 / (4 sqrt 14) for the others.
    "plane-obtuse-exactly": OBTUSE.certificate(largest("maximum", -1, F(9, 16)), smallest("minimum", 1, F(7, 8))),
    # cos 140 degrees is -0.76604.
    "plane-obtuse-below-140": OBTUSE.certificate(largest("less than", -1, F(766, 1000) ** 2)),
    "plane-right-triangles-3-4-5": RIGHT_3_4_5.certificate(
        largest("maximum", *NINETY), smallest("maximum", 1, F(16, 25)), smallest("minimum", 1, F(16, 25)),
        ratio("maximum", F(25, 36)), ratio("minimum", F(25, 36))),
    "plane-square-triangle":
        square_triangle().certificate("nonobtuse", largest("less than", *HUNDRED_TWENTY), "weakly Delaunay"),
    "plane-every-relation": square_triangle().certificate("nonobtuse", *EVERY_RELATION),
    "plane-shift-of-29-bits": renamed(block(2, 1, [[2, -1], [-1, 2]]), 1, [2**29 - 2]).certificate("acute"),
}

FIELDS = {
    "plane-equilateral-times-sqrt-3": times_root(SQRT3).certificate(
        "acute", largest("maximum", *SIXTY), "Delaunay"),
    "plane-reducible-field": times_root(REDUCIBLE).certificate("acute", "Delaunay"),
    "plane-cubic-field": times_root(TWO_COS_80).certificate("acute"),
    "plane-cubic-field-negative-root": times_root(MINUS_TWO_COS_20, -1).certificate("acute"),
    "plane-field-with-rational-root": times_root(TWO).certificate("acute"),
    "plane-field-with-fractions-for-ends": times_root(Field([-3, 0, 1], F(17, 10), F(7, 4))).certificate("acute"),
    # x^4 - 10 x^2 + 1: the root sqrt 3 - sqrt 2, near 0.318.
    "plane-field-of-two-roots": times_root(Field([1, 0, -10, 0, 1], F(3, 10), F(1, 3))).certificate("acute", *ALL_FIGURES),
    **{f"plane-field-of-degree-{n}": two_triangles_per_unit(ROOT, root_power(n)).certificate(
        "nonobtuse", *ALL_FIGURES, "weakly Delaunay") for n in range(2, 9)},
    "strip-of-height-2-to-1-8": strip_of_height(ROOT, root_power(8)).certificate("nonobtuse", *ALL_FIGURES),
    "space-field-of-degree-8": replace(kuhn(BCC), gram=[[[0, x] for x in row] for row in BCC], field=root_power(8)).certificate(
        "nonobtuse", *ALL_FIGURES, "Delaunay"),
}

SPACE = {
    # Kuhn's tetrahedron: the edges 1, 1, 1 in a path; angles 45, 60 and 90 degrees; R = sqrt 3 / 2.
    "space-cube-6": kuhn(CUBE).certificate(
        "nonobtuse", largest("maximum", *NINETY), largest("minimum", *NINETY), smallest("maximum", *FORTY_FIVE),
        smallest("minimum", *FORTY_FIVE), ratio("maximum", F(3, 4)), ratio("minimum", F(3, 4)), "weakly Delaunay"),
    # Sommerville's tetrahedron: 60 and 90 degrees; the sides 2 and sqrt 3, R = sqrt 5 / 2.
    "space-bcc": kuhn(BCC).certificate("nonobtuse", largest("maximum", *NINETY), smallest("minimum", *SIXTY),
                                       ratio("maximum", F(5, 12)), "Delaunay", "weakly Delaunay"),
    # The largest angle of A15 is arccos(1/5).
    "space-a15": a15().certificate("acute", largest("maximum", 1, F(1, 25)), "Delaunay"),
    "space-a15-figures": a15().certificate("acute", *ALL_FIGURES),
    "space-a15-tcp": a15().certificate("TCP"),
    "space-z-tcp": z().certificate("Delaunay", "TCP"),
    "space-z-figures": z().certificate("acute", *ALL_FIGURES, "TCP"),
    "space-z-contracted": z_contracted().certificate(),
    "space-chambers-of-the-cube": chambers().certificate("nonobtuse", smallest("at least", *FORTY_FIVE), *ALL_FIGURES[3:]),
    "space-vertex-in-another-cell": renamed(a15(), 3, [5, -7, 2]).certificate("acute"),
    # Determinants have about 160 bits.
    "space-coordinates-of-53-bits": moved_to_53_bits(a15()).certificate(
        "acute", largest("less than", *HUNDRED_TWENTY), "Delaunay"),
}

TURNED_CUBE = [face[i % 4:] + face[:i % 4] if i % 2 else face[::-1] for i, face in enumerate(CUBE_FACES)]

DOMAINS = {
    "strip": block(2, 1, [[2, -1], [-1, 2]]).certificate(
        "acute", largest("maximum", *SIXTY), smallest("minimum", *SIXTY), "Delaunay"),
    "strip-of-height-sqrt-3": strip_of_height(ROOT, SQRT3).certificate("nonobtuse", "weakly Delaunay"),
    "slab-cube-6": block(3, 1).certificate("nonobtuse", smallest("minimum", *FORTY_FIVE), "weakly Delaunay"),
    "slab-bcc": block(3, 1, BCC).certificate("nonobtuse", "Delaunay"),
    "slab-first-vertex-above": in_domain(block(3, 1), "slab", [[1], [0]], [[0], [1]]).certificate(),
    "slab-faces-exchanged": in_domain(block(3, 1), "slab", [[0], [1]], [[1], [0]]).certificate(),
    "prism-cube-6": block(3, 2).certificate("nonobtuse", "weakly Delaunay"),
    "prism-sides-in-any-order": in_domain(block(3, 2), "prism", [[1, 0], [1, 1], [0, 0], [0, 1]],
                                          [[0, 2], [3, 1], [3, 2], [0, 1]]).certificate(),
    "solid-square-2":
        block(2, 2).certificate("nonobtuse", smallest("minimum", *FORTY_FIVE), ratio("maximum", F(1, 2)), "weakly Delaunay"),
    "solid-hexagon": hexagon().certificate("acute", "Delaunay"),
    # Kuhn's tetrahedra are where the coordinates have one order.
    "solid-cube-6-uncrossed": block(3, 3).certificate(uncrossed((0, 1, -1), 0), uncrossed((1, -1, 0), 0), uncrossed((1, 1, 1), 5)),
    "slab-cube-6-uncrossed": block(3, 1).certificate(uncrossed((0, 0, 1), 0), uncrossed((0, 1, -1), 3), uncrossed((0, 1, 0), -1)),
    "solid-cube-6": block(3, 3).certificate("nonobtuse", largest("at most", *NINETY), "weakly Delaunay"),
    "solid-cube-faces-turned-and-reversed":
        in_domain(block(3, 3), "solid", CUBE_CORNERS, TURNED_CUBE).certificate(),
    # Around the axis 90 degrees; at the edges from the axis half of arccos(-1/3); at the rim twice that of a half octahedron.
    "solid-octahedron": octahedron().certificate(*ALL_FIGURES, "weakly Delaunay"),
    # The regular tetrahedron: arccos(1/3); R^2 / l^2 is 3/8.
    "solid-tetrahedron": tetrahedron().certificate(
        "acute", largest("maximum", 1, F(1, 9)), smallest("minimum", 1, F(1, 9)), ratio("maximum", F(3, 8)), "Delaunay"),
    "solid-of-half-size": Tiling(SQUARE_GRAM, [[0, 0], [F(1, 2), 0], [0, F(1, 3)]], [[[0], [1], [2]]],
                                 ("solid", [[0, 0], [F(1, 2), 0], [0, F(1, 3)]], [[0, 1], [1, 2], [2, 0]])).certificate(),
}

# Two cavities with a common edge; a ring of seven cubes whose ends meet in an edge.
CAVITIES_AT_AN_EDGE = [c for c in itertools.product(range(4), range(4), range(3)) if c not in ((1, 1, 1), (2, 2, 1))]
PINCHED = [(0, 0, 0), (1, 0, 0), (2, 0, 0), (0, 1, 0), (0, 2, 0), (2, 1, 0), (1, 2, 0)]

REGIONS = {
    "region-tetrahedron": REGULAR_REGION.certificate(
        "acute", largest("maximum", 1, F(1, 9)), smallest("minimum", 1, F(1, 9)), ratio("maximum", F(3, 8))),
    "region-cube-6": region(*cells((0, 0, 0))).certificate("nonobtuse"),
    "region-stairs": region(*cells((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1))).certificate(),
    "region-cavity": region(*CAVITY).certificate("nonobtuse"),
    "region-ring": region(*RING).certificate(),
    "region-two-cubes-at-an-edge": region(*cells((0, 0, 0), (1, 1, 0))).certificate(),
    "region-two-cubes-at-a-vertex": region(*cells((0, 0, 0), (1, 1, 1))).certificate(),
    "region-cavities-at-an-edge": region(*cells(*CAVITIES_AT_AN_EDGE)).certificate(),
    "region-ring-pinched-shut": region(*cells(*PINCHED)).certificate(),
    "region-piece-in-a-cavity": region(*beside(CAVITY, small(F(5, 4), F(5, 4), F(5, 4)))).certificate(),
    "region-piece-in-the-hole-of-a-ring": region(*beside(RING, small(F(5, 4), F(5, 4), F(1, 3)))).certificate(),
    "region-pieces-apart": region(*beside(*(small(x, y, z, F(1, 2)) for x, y, z in THREE))).certificate(),
    "region-two-in-a-plane": region([(0, 0, 0), (4, 0, 0), (0, 4, 0), (0, 0, 4), (4, 4, 0), (2, 2, -4)],
                                    [[0, 1, 2, 3], [1, 2, 4, 5]]).certificate(),
    "region-prism-over-sqrt-3": region(
        [(0, 0, 0), (2, 0, 0), (1, ROOT, 0), (0, 0, 1), (2, 0, 1), (1, ROOT, 1)],
        [[0, 1, 2, 3], [1, 2, 3, 4], [2, 3, 4, 5]], field=SQRT3).certificate(*ALL_FIGURES),
    # The bounding boxes of the translates overlap; at each height the triangle is less than one period wide.
    "region-plane-needles-across-cells":
        Tiling(SQUARE_GRAM, [[0, 0], [3, F(1, 2)], [3, F(3, 5)]], [[[0, 0, 0], [1, 0, 0], [2, 0, 0]]], ("region", 2)).certificate(),
}

TRIANGLE = [[0, 0], [F(1, 2), 1]]

PERIODIC = {
    "region-rank-2-slab-of-cubes": periodic((1, 1), (0, 0, 0)).certificate("nonobtuse", "locally weakly Delaunay"),
    "region-rank-2-stairs": periodic((2, 2), (0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0), (0, 0, 1)).certificate(),
    "region-rank-2-two-slabs": periodic((1, 1), (0, 0, 0), (0, 0, 2)).certificate(),
    "region-rank-2-columns-apart": periodic((2, 2), (0, 0, 0), (0, 0, 1)).certificate("nonobtuse"),
    "region-rank-1-rod": periodic((1,), (0, 0, 0)).certificate("nonobtuse", "locally weakly Delaunay"),
    "region-rank-1-pipe": periodic((1,), *((0, y, z) for y, z in NINE if (y, z) != (1, 1))).certificate(),
    "region-rank-1-screw-of-cubes": periodic((4,), (0, 0, 0), (0, 1, 0), (1, 1, 0), (1, 1, 1), (2, 1, 1), (2, 0, 1),
                                             (3, 0, 1), (3, 0, 0)).certificate(),
    "region-rank-1-chain-of-tetrahedra":
        Tiling(CUBE, [[0, 0, 0], [F(1, 2), 1, 0], [F(1, 2), 0, 1]], [[[0, 0], [0, 1], [1, 0], [2, 0]]], ("region", 1)).certificate(),
    "region-rank-3-void": periodic((2, 2, 2), *(c for c in itertools.product((0, 1), repeat=3) if c != (1, 1, 1))).certificate(
        "nonobtuse", "locally weakly Delaunay"),
    "region-rank-3-piece-in-a-void": periodic(
        (2, 2, 2), *(c for c in itertools.product((0, 1), repeat=3) if c != (1, 1, 1)),
        extra=[small(F(5, 4), F(5, 4), F(5, 4))[0]]).certificate(),
    "region-rank-3-voids-at-a-vertex": periodic(
        (2, 2, 2), *(c for c in itertools.product((0, 1), repeat=3) if sum(c) not in (0, 3))).certificate(),
    "region-rank-3-tunnels": periodic((2, 2, 1), (0, 0, 0), (1, 0, 0), (0, 1, 0)).certificate(),
    "region-rank-3-tetrahedra-apart": Tiling(REGULAR, [[0, 0, 0], [F(1, 2), 0, 0], [0, F(1, 2), 0], [0, 0, F(1, 2)]],
                                             [[[v, 0, 0, 0] for v in range(4)]], ("region", 3)).certificate("acute"),
    "region-rank-3-octahedral-voids": Tiling(REGULAR, [[0, 0, 0]], [[[0, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]],
                                             ("region", 3)).certificate("acute", largest("maximum", 1, F(1, 9))),
    "region-plane-cells":
        region(*cells((0, 0), (1, 0))).certificate("nonobtuse", largest("maximum", *NINETY), "locally weakly Delaunay"),
    "region-plane-hole": region(*cells(*(c for c in NINE if c != (1, 1)))).certificate("nonobtuse"),
    "region-plane-piece-in-a-hole": region(*beside(
        cells(*(c for c in NINE if c != (1, 1))), lone((F(5, 4), F(5, 4)), (F(3, 2), F(5, 4)), (F(5, 4), F(3, 2))))).certificate(),
    "region-plane-two-cells-at-a-vertex": region(*cells((0, 0), (1, 1))).certificate(),
    "region-plane-triangle":
        region(*lone((0, 0), (3, 0), (0, 4))).certificate(smallest("minimum", 1, F(16, 25)), ratio("maximum", F(25, 36))),
    "region-plane-over-sqrt-3":
        region([(0, 0), (2, 0), (1, ROOT), (1, [0, -1])], [[0, 1, 2], [0, 1, 3]], field=SQRT3).certificate(
        "acute", largest("maximum", *SIXTY), "locally Delaunay"),
    "region-plane-rank-1-strip": periodic((1,), (0, 0)).certificate("nonobtuse"),
    "region-plane-rank-1-strip-with-holes": periodic((3,), *(c for c in NINE if c != (1, 1))).certificate("nonobtuse"),
    "region-plane-rank-1-triangles-in-a-row":
        Tiling(SQUARE_GRAM, TRIANGLE, [[[0, 0], [0, 1], [1, 0]]], ("region", 1)).certificate("acute"),
    "region-plane-rank-2-holes": periodic((2, 2), (0, 0), (1, 0), (0, 1)).certificate("nonobtuse"),
    "region-plane-rank-2-checkerboard": periodic((2, 2), (0, 0), (1, 1)).certificate("nonobtuse"),
    "region-plane-rank-2-triangles-at-vertices":
        Tiling(HEXAGONAL, [[0, 0]], [[[0, 0, 0], [0, 1, 0], [0, 0, 1]]], ("region", 2)).certificate(
            "acute", largest("maximum", *SIXTY)),
    "region-plane-rank-2-hexagon-holes": Tiling(
        HEXAGONAL, [[F(1, 2), 0], [0, F(1, 2)], [F(1, 2), F(1, 2)]],
        [[[0, 0, 0], [2, 0, 0], [1, 0, 0]], [[1, 1, 0], [0, 0, 1], [2, 0, 0]]], ("region", 2)).certificate("acute"),
}

LOCALLY_DELAUNAY = {
    "region-locally-delaunay-bcc":
        replace(periodic((1, 1), (0, 0, 0)), gram=BCC).certificate("locally Delaunay", "locally weakly Delaunay"),
    "region-locally-delaunay-cells-of-bcc":
        region(*cells((0, 0, 0), (1, 0, 0)), gram=BCC).certificate("nonobtuse", "locally Delaunay"),
    "region-locally-delaunay-cube": region(*cells((0, 0, 0), (1, 0, 0))).certificate("locally weakly Delaunay"),
    # The flat triangle's circle has the centre (2, -3/2) and the radius 5/2.
    # It contains the other piece, but no edge is between them.
    "region-locally-delaunay-not-globally": region(
        [(0, 0), (4, 0), (2, 1), (4, 2), (1, -1), (3, -1), (2, -3)], [[0, 1, 2], [1, 2, 3], [4, 5, 6]]).certificate(
            "locally Delaunay"),
}

BIG = {
    "region-integers-at-limits": triangles_near(2**53, 2**63, 2**64, 2**72).certificate(),
    "region-integers-at-limits-below": triangles_near(2**53 - 1, 2**64 - 1, 2**72 - 1, 2**80 - 1).certificate(),
    "region-coordinates-of-300-bits": region(*beside(
        scaled(CORNER, 10**90), lone((-1, -1, -1), (-2, -1, -1), (-1, -2, -1), (-1, -1, -2)))).certificate(
            "nonobtuse", largest("maximum", *NINETY)),
    # The exact values of the second one have about 300 bits, more than the coordinates.
    "region-coordinates-of-53-bits": region(*shaken(cells(*THREE))).certificate(largest("less than", *HUNDRED_TWENTY)),
    "region-coordinates-of-53-bits-all-figures": region(*shaken(cells(*THREE))).certificate(*ALL_FIGURES),
    "region-denominator-of-100-bits":
        region(*beside(CORNER, lone((1, 1, F(-1, 10**30)), (1, 2, -1), (2, 1, -1), (1, 1, -2)))).certificate(),
    "plane-gram-of-200-bits":
        lattice([[2**200, 1], [1, 2**200 + 1]]).certificate("acute", largest("less than", *NINETY), "Delaunay"),
    "space-cube-with-coordinates-beyond-64-bits": renamed(kuhn(CUBE), 0, [2**80, -2**70, 3**50]).certificate("nonobtuse"),
}

VALID = {**PLANE, **FIELDS, **SPACE, **DOMAINS, **REGIONS, **PERIODIC, **LOCALLY_DELAUNAY, **BIG}
