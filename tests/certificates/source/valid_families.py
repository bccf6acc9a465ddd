"""Families in which every claim is true: theorems by hand, and tilings as before."""
from fractions import Fraction as F

from .build import edit, largest, ratio, smallest
from .family import Family, closed, halved, of_tiling, opened
from .polynomial import variables
from .tilings import (BCC, CUBE, LATTICE_TRIANGLES, SEGMENT, SQRT3, SQUARE_GRAM, TWO_COS_80, a15, block, hexagon, kuhn, kuhn_simplices,
                      lattice, octahedron, polygon, root_power, strip_of_height, times_root, z)
from .wrong import NINETY, SIXTY

X, = variables(1)
XY = variables(2)
XYZ = variables(3)
KUHN = [[[0, *c] for c in corners] for corners in kuhn_simplices(3)]


def plane(parameters, gram, tree=(), field=None):
    """The lattice triangles with this Gram matrix."""
    return Family(parameters, gram, [[0, 0]], LATTICE_TRIANGLES, tree=tree, **({"field": field} if field else {}))


def acute_triangles():
    """All acute triangles, up to their size: B, A - B and C - B are positive, and A + C - B is 1."""
    x, y = XY
    return plane({"x": opened(0, 1), "y": opened(0, 1)}, [[y, x * y], [x * y, 1 - y + x * y]])


def isosceles(*ends):
    """
    The sides have the squares 2, 2 + t, 2 + t. The angles at the first side have the squared cosine 1 / (4 + 2 t), the
    third one ((1 + t) / (2 + t))², and the squared ratio is (2 + t)² / (12 + 8 t). From t = 0 to 1: 1/4 to 1/6, 1/4 to
    4/9, 1/3 to 9/20.
    """
    return plane({"t": ends or closed(0, 1)}, [[2, 1], [1, 2 + X]])


def with_cosine(cosine, tree=(), **parameters):
    """Triangles with the squared sides 1, 1 and 2 - 2 cos."""
    return plane(parameters or {"x": closed(0, 1)}, [[1, cosine], [cosine, 1]], tree)


def goldberg(*ends):
    """
    Goldberg's first tetrahedra. Corners lie on the edges of prisms over equilateral triangles with the square 2 of a
    side; each is by a higher than the one before it, and s is the square of a. Nonobtuse exactly for 2 >= 2 s.
    """
    s = X
    gram = [[2 + s, 1 - s, 3 * s], [1 - s, 2 + s, -3 * s], [3 * s, -3 * s, 9 * s]]
    # Heights in units of a: the points (i, j, k) have i - j + 3 k; four consecutive ones around each triangle.
    up = [(0, 0, 0), (1, 0, 0), (0, 1, 1), (0, 0, 1), (1, 0, 1), (0, 1, 2)]
    down = [(1, 1, 0), (1, 0, 0), (0, 1, 1), (1, 1, 1), (1, 0, 1), (0, 1, 2)]
    simplices = [[[0, *column[k + i]] for i in range(4)] for column in (up, down) for k in range(3)]
    return Family({"s": ends or (("open", 0), ("closed", 1))}, gram, [[0, 0, 0]], simplices)


def selling(low, *tree):
    """Kuhn's tetrahedra of a lattice with the Selling parameters x, y, z and three times 1: Delaunay where they are positive."""
    x, y, z_ = XYZ
    gram = [[x + y + 1, -x, -y], [-x, x + z_ + 1, -z_], [-y, -z_, y + z_ + 1]]
    sides = {name: ((low, 0), ("closed", 1)) for name in "xyz"}
    return Family(sides, gram, [[0, 0, 0]], KUHN, tree=tree)


def stretched(tiling, low, high, tree=()):
    """The third direction, with a square between these multiples."""
    gram = [[F(g) * (X if i == j == 2 else 1) for j, g in enumerate(row)] for i, row in enumerate(tiling.gram)]
    return Family({"s": closed(low, high)}, gram, tiling.vertices, tiling.simplices, tree=tree)


def rows_over_sqrt_3():
    """Rectangles of the height u, and triangles of the height 1 - u, on sides with the square √3 - w."""
    u, w = variables(2, SQRT3)
    side = w * -1 + [0, 1]
    simplices = [[[0, 0, 0], [0, 1, 0], [1, 0, 0]], [[0, 1, 0], [1, 1, 0], [1, 0, 0]],
                 [[1, 0, 0], [1, 1, 0], [0, 0, 1]], [[1, 1, 0], [0, 1, 1], [0, 0, 1]]]
    sides = {"u": closed([F(-3, 2), 1], [2, -1]), "w": (("closed", 0), ("open", [F(-3, 2), 1]))}
    return Family(sides, [[side, side / 2], [side / 2, side / 4 + 1]], [[0, 0], [u / -2, u]], simplices, field=SQRT3)


def strip(height, *ends, tree=(), name="h"):
    """Rectangles of a height, each cut in two."""
    simplices = [[[0, 0], [0, 1], [1, 0]], [[0, 1], [1, 1], [1, 0]]]
    return Family({name: ends}, SQUARE_GRAM, [[0, 0], [0, height]], simplices, ("slab", [[0], [height]], [[0], [1]]), tree=tree)


def cut_square(point, tree=(), **sides):
    """The unit square, cut into four at a point."""
    corners = [[0, 0], [1, 0], [1, 1], [0, 1]]
    simplices = [[[4], [i], [(i + 1) % 4]] for i in range(4)]
    return Family(sides, SQUARE_GRAM, [*corners, list(point)], simplices, ("solid", *polygon(*corners)), tree=tree)


def corner_moved(*ends):
    """A triangle of the plane as a solid, whose third corner is (x, 1)."""
    corners = [[0, 0], [1, 0], [X, 1]]
    return Family({"x": ends}, SQUARE_GRAM, corners, [[[0], [1], [2]]], ("solid", *polygon(*corners)))


def tetrahedron_moved(*ends):
    """The corner of a cube as a solid, whose last corner is (x, x, 1)."""
    corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [X, X, 1]]
    faces = [[1, 2, 3], [0, 2, 3], [0, 1, 3], [0, 1, 2]]
    return Family({"x": ends}, CUBE, corners, [[[0], [1], [2], [3]]], ("solid", corners, faces))


def prism_sheared(*ends):
    """The prism over a parallelogram with the corner (x, 1)."""
    tiling = block(3, 2)
    corners = [[0, 0], [1, 0], [1 + X, 1], [X, 1]]
    vertices = [[v[0], v[1] + X * v[2], v[2]] for v in tiling.vertices]
    return Family({"x": ends}, tiling.gram, vertices, tiling.simplices, ("prism", *polygon(*corners)))


def by_degree(n):
    return plane({"x": closed(0, 1)}, [[1 + X ** n, 0], [0, 1]])


X_, Y_ = XY
SIDE = (X - F(1, 2)) ** 2 + F(1, 100)
HILL = (X_ - F(1, 2)) ** 2 + (Y_ - F(1, 2)) ** 2 + F(1, 100)
UNIT = {"x": closed(0, 1), "y": closed(0, 1)}
STRICT = [largest("less than", 1, F(1, 6)), largest("more than", *SIXTY), smallest("less than", *SIXTY),
          smallest("more than", 1, F(4, 9)), ratio("less than", F(9, 20)), ratio("more than", F(1, 3))]
WEAK = [largest("at most", 1, F(1, 6)), largest("at least", *SIXTY), smallest("at most", *SIXTY),
        smallest("at least", 1, F(4, 9)), ratio("at most", F(9, 20)), ratio("at least", F(1, 3))]
EXACT_RIGHT = [largest("maximum", *NINETY), largest("minimum", *NINETY)]

PLANE = {
    "family-plane-acute-triangles": acute_triangles().certificate("acute", "Delaunay"),
    "family-plane-right-triangles": plane({"x": closed(F(1, 10), 10)}, [[1, 0], [0, X]]).certificate(
        "nonobtuse", *EXACT_RIGHT, "weakly Delaunay"),
    "family-plane-isosceles-closed": isosceles().certificate("acute", *WEAK, "Delaunay"),
    "family-plane-isosceles-open": isosceles(*opened(0, 1)).certificate("acute", *STRICT, "Delaunay"),
    # Every angle is less than 180 degrees. The largest one is at least 60: that with the cosine x up to x = 1/2, then another.
    "family-plane-obtuse": with_cosine(X, [0, [], [0, [], []]], x=opened(-1, 1)).certificate(
        largest("less than", -1, 1), largest("at least", *SIXTY), smallest("more than", 1, 1)),
    "family-plane-cosine-from-minus-one-half": with_cosine(X, x=closed(F(-1, 2), 0)).certificate(
        largest("at most", -1, F(1, 4)), largest("at least", *NINETY)),
    # x + y is zero in (0, 0) alone, which is not in the box.
    "family-plane-zero-in-an-open-corner": plane({"x": closed(0, 1), "y": (("open", 0), ("closed", 1))}, [
        [X_ + Y_, 0], [0, 1]]).certificate("nonobtuse"),
    # x y is zero on two sides, which are not in the box.
    "family-plane-zero-on-open-sides": plane({"x": opened(0, 1), "y": (("open", 0), ("closed", 1))}, [
        [X_ * Y_, 0], [0, 1]]).certificate("nonobtuse"),
    "family-plane-cosine-that-needs-a-tree": with_cosine(SIDE, halved(0)).certificate("acute", "Delaunay"),
    "family-plane-two-parameters-and-a-tree": with_cosine(HILL, halved(0, 1), **UNIT).certificate("acute"),
    "family-plane-lopsided-tree": with_cosine(HILL, [1, halved(0), [0, [], [0, [], [1, [], []]]]], **UNIT).certificate("acute"),
    "family-plane-half-open-with-a-tree": with_cosine(X * (X - F(1, 2)) ** 2 + X / 50, halved(0), x=(("open", 0), ("closed", 1))).certificate(
        "acute"),
    # The zero of (x - 1/2) (x - 1) is an end of the box, and of the half of a leaf.
    "family-plane-weakly-zero-in-a-leaf-end": with_cosine((X - F(1, 2)) ** 2, halved(0)).certificate("nonobtuse", "weakly Delaunay"),
    # Obtuse triangles, two of which make a parallelogram: the other diagonal is the shorter one.
    "family-plane-not-delaunay": with_cosine(X, halved(0), x=(("closed", F(-3, 4)), ("open", 0))).certificate("not Delaunay"),
    "family-plane-not-delaunay-in-two-parameters": with_cosine(-X_ * Y_, x=opened(0, 1), y=opened(0, 1)).certificate("not Delaunay"),
    "family-plane-of-degree-15": by_degree(15).certificate("nonobtuse", *EXACT_RIGHT),
    "family-plane-more-leaves-than-needed":
        plane(UNIT, [[1 + X_, F(1, 2)], [F(1, 2), 1 + Y_]], halved(1, 1, 0)).certificate("acute"),
    "family-plane-large-coefficients": plane({"x": closed(0, 1)}, [[10**40 + X * 10**30, 1], [1, 10**40 + 1]]).certificate("acute"),
    "family-plane-long-name-and-negative-ends": plane({"a_name_of_16_abc": closed(-2, -1)}, [[X ** 2, F(1, 2)], [F(1, 2), 1]]).certificate(
        "acute"),
    "family-plane-of-degree-2-in-each-of-three": plane({name: closed(0, 1) for name in "abc"}, [
        [1 + XYZ[0] ** 2, XYZ[1] ** 2 / 2], [XYZ[1] ** 2 / 2, 1 + XYZ[2] ** 2]]).certificate("nonobtuse"),
}

FIELDS = {
    "family-plane-rows-over-sqrt-3": rows_over_sqrt_3().certificate("nonobtuse"),
    "family-plane-cubic-field": of_tiling(times_root(TWO_COS_80)).certificate("acute", largest("maximum", *SIXTY)),
    "family-plane-of-degree-8": of_tiling(lattice([[1, 0], [0, [0, 1]]], root_power(8))).certificate("nonobtuse", *EXACT_RIGHT),
    "family-strip-over-sqrt-3": of_tiling(strip_of_height([0, 1], SQRT3), halved(0)).certificate("nonobtuse"),
    # cos from 0 to √3 - 1: nonobtuse, and acute but for the end.
    "family-plane-algebraic-end": plane({"x": (("open", 0), ("closed", [-1, 1]))}, [
        [1, variables(1, SQRT3)[0]], [variables(1, SQRT3)[0], 1]], field=SQRT3).certificate("acute"),
}

SPACE = {
    "family-space-goldberg-first": goldberg().certificate("nonobtuse"),
    "family-space-goldberg-first-acute-or-not": goldberg(("open", 0), ("closed", 5)).certificate(),
    "family-space-selling-closed": selling("closed").certificate("weakly Delaunay"),
    "family-space-selling-open": selling("open").certificate("Delaunay"),
    "family-space-a15-stretched": stretched(a15(), F(99, 100), F(101, 100)).certificate("acute", "Delaunay", "TCP"),
    "family-space-z-stretched": stretched(z(), F(99, 100), F(101, 100)).certificate("acute", "TCP"),
    "family-space-bcc": of_tiling(kuhn(BCC), halved(0)).certificate("nonobtuse", largest("maximum", *NINETY), "Delaunay"),
}

DOMAINS = {
    "family-strip-of-every-height": strip(X, ("open", 0), ("closed", 1000)).certificate("nonobtuse", *EXACT_RIGHT),
    "family-slab-of-every-height": Family(
        {"h": (("open", 0), ("closed", 7))}, CUBE, [[v[0], v[1], v[2] * X] for v in block(3, 1).vertices], block(3, 1).simplices,
        ("slab", [[0], [X]], SEGMENT[1])).certificate("nonobtuse", "weakly Delaunay"),
    "family-prism-sheared": prism_sheared(*closed(0, F(1, 2))).certificate(),
    "family-solid-square-cut-anywhere": cut_square(XY, x=opened(0, 1), y=opened(0, 1)).certificate(),
    "family-solid-square-cut-on-a-line": cut_square((X, F(1, 2)), x=closed(F(1, 4), F(3, 4))).certificate(),
    "family-solid-triangle": corner_moved(*closed(-3, 3)).certificate(),
    "family-solid-triangle-acute": corner_moved(*opened(0, 1)).certificate("acute"),
    "family-solid-tetrahedron": tetrahedron_moved(*closed(-1, 5)).certificate(),
    "family-solid-hexagon": of_tiling(hexagon()).certificate("acute", "Delaunay"),
    "family-solid-octahedron": of_tiling(octahedron(), halved(0)).certificate("weakly Delaunay"),
}

ALL_LEAVES = plane(UNIT, [[1 + X_, F(1, 2)], [F(1, 2), 1 + Y_]], halved(*[0, 1] * 6)).certificate("acute")


def path(n):
    """A tree with a path of n halvings."""
    tree = []
    for _ in range(n):
        tree = [0, [], tree]
    return tree


LIMITS = {
    "family-tree-of-4096-leaves": ALL_LEAVES,
    "family-tree-with-a-path-of-64": edit(isosceles().certificate("acute"), ("witness", "tree"), path(64)),
}

VALID_FAMILIES = {**PLANE, **FIELDS, **SPACE, **DOMAINS, **LIMITS}
