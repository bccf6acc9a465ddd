"""Tilings of space, slabs, prisms and solids."""
import functools
import itertools
from dataclasses import replace
from fractions import Fraction as F

from .build import Tiling, from_first
from .field import Field, Q, determinant

SQRT3 = Field([-3, 0, 1], 1, 2)
# (x^2 - 2)(x^2 - 3) and its root sqrt 2: a^2 - 2 has the value zero and coefficients that are not zero.
REDUCIBLE = Field([6, 0, -5, 0, 1], 1, F(3, 2))
# x^3 - 3x + 1 has three real roots: 2 cos 40, 2 cos 80 and -2 cos 20 degrees.
TWO_COS_80 = Field([1, -3, 0, 1], 0, F(1, 2))
MINUS_TWO_COS_20 = Field([1, -3, 0, 1], -2, F(-3, 2))
# x^2 - 4, its root 2 in the middle of the interval: the first halving hits it.
TWO = Field([-4, 0, 1], 1, 3)
ROOT = [0, 1]

SQUARE_GRAM = [[1, 0], [0, 1]]
HEXAGONAL = [[2, 1], [1, 2]]
CUBE = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
REGULAR = [[2, 1, 1], [1, 2, 1], [1, 1, 2]]
# bcc in the basis (-1,1,1), (1,-1,1), (1,1,-1): an obtuse superbase, so its Delaunay tetrahedra are Kuhn's.
BCC = [[3, -1, -1], [-1, 3, -1], [-1, -1, 3]]
HEXAGONAL_CELL = [[1, F(-1, 2), 0], [F(-1, 2), 1, 0], [0, 0, 1]]


def root_power(degree):
    """The field of the root 2^(1 / degree)."""
    return Field([-2, *[0] * (degree - 1), 1], 1, 2)


# --- lattices --------------------------------------------------------------------

LATTICE_TRIANGLES = [[[0, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 1, 0], [0, 1, 1], [0, 0, 1]]]


def lattice(gram, field=Q):
    """The plane lattice: parallelograms, each cut into two triangles."""
    return Tiling(gram, [[0, 0]], LATTICE_TRIANGLES, field=field)


def times_root(field, sign=1):
    """Equilateral triangles whose squared lengths are multiples of the root."""
    return lattice([[[0, 2 * sign], [0, sign]], [[0, sign], [0, 2 * sign]]], field)


def kuhn_simplices(dimension):
    """Kuhn's simplices of the cube: 0, e_p, e_p + e_q and so on for each permutation."""
    for permutation in itertools.permutations(range(dimension)):
        at, corners = [0] * dimension, [[0] * dimension]
        for axis in permutation:
            at[axis] += 1
            corners.append(at[:])
        yield corners


def kuhn(gram):
    """Kuhn's six tetrahedra of a parallelepiped."""
    simplices = [[[0, *c] for c in corners] for corners in kuhn_simplices(3)]
    return Tiling(gram, [[0, 0, 0]], simplices).turned()


def square_triangle():
    """3^3.4^2 with edge 1: squares, each cut in two, and equilateral triangles, over Q(sqrt 3).

    Basis (1, 0), (1/2, 1 + sqrt 3 / 2); the second vertex is (0, 1) in the Cartesian frame.
    """
    gram = [[1, F(1, 2)], [F(1, 2), [2, 1]]]
    simplices = [
        [[0, 0, 0], [0, 1, 0], [1, 0, 0]], [[0, 1, 0], [1, 1, 0], [1, 0, 0]],
        [[1, 0, 0], [1, 1, 0], [0, 0, 1]], [[1, 1, 0], [0, 1, 1], [0, 0, 1]],
    ]
    return Tiling(gram, [[0, 0], [[-2, 1], [4, -2]]], simplices, field=SQRT3).turned()


# --- domains with a boundary ---------------------------------------------------------

def polygon(*vertices):
    return vertices, [[i, (i + 1) % len(vertices)] for i in range(len(vertices))]


SEGMENT = ([[0], [1]], [[0], [1]])
SQUARE = polygon([0, 0], [1, 0], [1, 1], [0, 1])
CUBE_FACES = [[0, 1, 3, 2], [4, 5, 7, 6], [0, 1, 5, 4], [2, 3, 7, 6], [0, 2, 6, 4], [1, 3, 7, 5]]
CUBE_CORNERS = [list(c) for c in itertools.product((0, 1), repeat=3)]
SOLID_CUBE = (CUBE_CORNERS, CUBE_FACES)
KIND = {(2, 1): ("slab", *SEGMENT), (3, 1): ("slab", *SEGMENT), (3, 2): ("prism", *SQUARE),
        (2, 2): ("solid", *SQUARE), (3, 3): ("solid", *SOLID_CUBE)}


def block(d, k, gram=None):
    """Kuhn's simplices of the d-cube, periodic in the first d - k directions."""
    corners = list(itertools.product((0, 1), repeat=k))
    simplices = [[[corners.index(tuple(c[d - k:])), *c[:d - k]] for c in simplex] for simplex in kuhn_simplices(d)]
    vertices = [[0] * (d - k) + list(c) for c in corners]
    gram = gram or [[int(i == j) for j in range(d)] for i in range(d)]
    return Tiling(gram, vertices, simplices, KIND[d, k]).turned()


def solid(gram, body, vertices, simplices):
    """A solid whose simplices are lists of vertices."""
    return Tiling(gram, vertices, [[[v] for v in corners] for corners in simplices], ("solid", *body)).turned()


def tetrahedron():
    """The regular tetrahedron, in the basis of its three edges from a corner."""
    corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
    return solid(REGULAR, (corners, [[1, 2, 3], [0, 2, 3], [0, 1, 3], [0, 1, 2]]), corners, [[0, 1, 2, 3]])


def hexagon():
    """The regular hexagon, cut into six equilateral triangles."""
    ring = [[1, 0], [0, 1], [-1, 1], [-1, 0], [0, -1], [1, -1]]
    return solid(HEXAGONAL, polygon(*ring), [*ring, [0, 0]], [[6, i, (i + 1) % 6] for i in range(6)])


def octahedron():
    """The regular octahedron, cut into four around an axis."""
    tips = [[1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]]
    sides = [[i, (i + 1) % 4] for i in range(4)]
    body = tips, [[*side, tip] for side in sides for tip in (4, 5)]
    return solid(CUBE, body, tips, [[*side, 4, 5] for side in sides])


def strip_of_height(root, field):
    """Squares stretched to the height of the root: the volume is no rational."""
    simplices = [[[0, 0], [0, 1], [1, 0]], [[0, 1], [1, 1], [1, 0]]]
    return Tiling(SQUARE_GRAM, [[0, 0], [0, root]], simplices, ("slab", [[0], [root]], [[0], [1]]), field).turned()


# --- Delaunay tetrahedra by brute force ---------------------------------------------------

def delaunay(points, gram, reach):
    """The Delaunay tetrahedra of points modulo Z^3, each orbit once; no edge is longer than sqrt(reach)."""
    def apply(x):
        return [sum(F(g) * y for g, y in zip(row, x)) for row in gram]

    def square(x):
        return sum(a * b for a, b in zip(x, apply(x)))

    def volume(matrix):
        return determinant(Q, [[(F(x),) for x in row] for row in matrix])[0]
    shifts = list(itertools.product((-1, 0, 1), repeat=3))
    cloud = [(v, c, [x + s for x, s in zip(p, c)]) for v, p in enumerate(points) for c in shifts]
    found = {}
    for v, p in enumerate(points):
        near = [(w, c, [x - y for x, y in zip(q, p)]) for w, c, q in cloud]
        near = [n for n in near if 0 < square(n[2]) <= reach]
        for triple in itertools.combinations(near, 3):
            vectors = [n[2] for n in triple]
            if volume(vectors) == 0:
                continue
            squares, duals = [square(e) for e in vectors], [apply(e) for e in vectors]
            scale = 2 * volume(duals)
            centre = [volume([e[:k] + [r] + e[k + 1:] for e, r in zip(duals, squares)]) / scale for k in range(3)]
            radius = square(centre)
            powers = (square([x - y - z for x, y, z in zip(q, p, centre)]) - radius for _, _, q in cloud)
            on_sphere = 0
            for power in powers:
                if power < 0:
                    break
                on_sphere += power == 0
            else:
                assert on_sphere == 4, "cospherical points"
                corners = sorted([(v, 0, 0, 0)] + [(w, *c) for w, c, _ in triple])
                form = from_first(corners)
                found[tuple(form)] = [list(place) for place in form]
    return [found[form] for form in sorted(found)]


@functools.cache
def a15():
    """A15: (0,0,0), (1/2,1/2,1/2) and the six of 6c; 46 tetrahedra."""
    points = [[F(0)] * 3, [F(1, 2)] * 3]
    for axis in range(3):
        for quarter in (1, 3):
            point = [F(0)] * 3
            point[axis], point[(axis + 2) % 3] = F(quarter, 4), F(1, 2)
            points.append(point)
    simplices = delaunay(points, CUBE, F(2, 5))
    assert len(simplices) == 46
    return Tiling(CUBE, points, simplices).turned()


@functools.cache
def z():
    """Z in the group P6/mmm: a kagome layer, two points on the axis, a honeycomb; 40 tetrahedra."""
    half, third = F(1, 2), F(1, 3)
    points = [[half, F(0), F(0)], [F(0), half, F(0)], [half, half, F(0)], [F(0), F(0), F(1, 4)], [F(0), F(0), F(3, 4)],
              [third, 2 * third, half], [2 * third, third, half]]
    simplices = delaunay(points, HEXAGONAL_CELL, F(2, 5))
    assert len(simplices) == 40
    return Tiling(HEXAGONAL_CELL, points, simplices).turned()


@functools.cache
def z_contracted():
    """Z with the cell doubled in two directions and one edge of the axis contracted.

    The edge, between heights 1/4 and 3/4, goes through a hexagon of the honeycomb, whose sides are
    in 6 tetrahedra; they lose one. The edges from its ends to the hexagon are in 5 each, and
    become 5 + 5 - 4 = 6. So all edges are in 5 or 6 tetrahedra, and triangles have two in 6.
    """
    names = list(itertools.product(range(7), (0, 1), (0, 1)))
    low, high = names.index((3, 0, 0)), names.index((4, 0, 0))

    def place(v, x, y, height, by):
        x, y = x + by[0], y + by[1]
        name = names.index((v, x % 2, y % 2))
        return [low if name == high else name, x // 2, y // 2, height]
    simplices = []
    for corners, by in itertools.product(z().simplices, itertools.product((0, 1), repeat=2)):
        places = [place(*corner, by) for corner in corners]
        if len(set(map(tuple, places))) == 4:
            simplices.append([[p[0] - (p[0] > high), *p[1:]] for p in places])
    assert len(simplices) == 160 - 6
    vertices = []
    for v, x, y in names:
        p = z().vertices[v]
        height = F(1, 2) if (v, x, y) == (3, 0, 0) else p[2]
        vertices.append([(p[0] + x) / 2, (p[1] + y) / 2, height])
    del vertices[high]
    return Tiling([[4, -2, 0], [-2, 4, 0], [0, 0, 1]], vertices, simplices).turned()


def chambers():
    """The cube cut into the 48 chambers of its symmetry group: edges in 4, 6 and 8 tetrahedra."""
    names, simplices = [], []

    def place(p):
        base = tuple(x % 2 for x in p)
        if base not in names:
            names.append(base)
        return [names.index(base)] + [x // 2 for x in p]
    for permutation in itertools.permutations(range(3)):
        for signs in itertools.product((1, -1), repeat=3):
            # The centre of the cube, of a face, of an edge, and a corner, in halves.
            at = [1, 1, 1]
            places = [place(at)]
            for axis in permutation:
                at[axis] += signs[axis]
                places.append(place(at))
            simplices.append(places)
    return Tiling(CUBE, [[F(x, 2) for x in name] for name in names], simplices).turned()


def a15_split():
    """A15 with its last tetrahedron cut into four: edges in 3, and in 6 or 7 where they were in 5 or 6."""
    *rest, last = a15().simplices
    points = [a15().position(place) for place in last]
    middle = [sum(x[0] for x in xs) / 4 for xs in zip(*points)]
    new = [[*last[:i], [8, 0, 0, 0], *last[i + 1:]] for i in range(4)]
    return replace(a15(), vertices=[*a15().vertices, middle], simplices=rest + new).turned()


def moved_to_53_bits(tiling):
    """The vertices, each moved by less than 1/64."""
    def moved(x, seed):
        return x + F(pow(2654435761 * (seed + 1), 3, 2**47), 2**53)
    vertices = [[moved(x, 3 * k + axis) for axis, x in enumerate(v)] for k, v in enumerate(tiling.vertices)]
    return replace(tiling, vertices=vertices)
