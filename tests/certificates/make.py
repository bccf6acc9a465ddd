#!/usr/bin/env python3
"""Writes the certificates of this folder: `python3 make.py`, needs Python 3 alone.

A second implementation, which shares nothing with the program: it writes the
canonical bytes from docs/format.md, matches facets by sorting them modulo the
lattice, and finds Delaunay tetrahedra by trying all quadruples of near points,
in exact fractions. README.md says what each file is for.
"""
import copy
import functools
import itertools
import json
import math
import os
from fractions import Fraction as F

HERE = os.path.dirname(os.path.abspath(__file__))
TILING = "face-to-face tiling"


# --- the canonical bytes ---------------------------------------------------

def text(value, depth=1):
    """JSON with the members of the outer three levels on lines of their own."""
    if not isinstance(value, (list, dict)):
        return json.dumps(value, ensure_ascii=False)
    line = "\n" if depth <= 3 else ""
    if isinstance(value, dict):
        parts = [json.dumps(key) + ":" + text(item, depth + 1) for key, item in value.items()]
        brackets = "{}"
    else:
        parts = [text(item, depth + 1) for item in value]
        brackets = "[]"
    return brackets[0] + ",".join(line + part for part in parts) + line + brackets[1]


def to_bytes(certificate):
    return (text(certificate) + "\n").encode()


# --- tilings -----------------------------------------------------------------

def determinant(m):
    if len(m) == 1:
        return m[0][0]
    return sum((-1) ** j * m[0][j] * determinant([row[:j] + row[j + 1:] for row in m[1:]])
               for j in range(len(m)))


def approximate(number, a):
    coefficients = [number] if isinstance(number, str) else number
    return sum(float(F(c)) * a ** k for k, c in enumerate(coefficients))


def oriented(vertices, simplices, a):
    """The simplices, with their last two corners exchanged where the determinant is negative."""
    def point(place):
        return [approximate(x, a) + s
                for x, s in itertools.zip_longest(vertices[place[0]], place[1:], fillvalue=0)]
    result = []
    for corners in simplices:
        corners = [list(corner) for corner in corners]
        base, *rest = map(point, corners)
        if determinant([[x - y for x, y in zip(p, base)] for p in rest]) < 0:
            corners[-2:] = corners[:-3:-1]
        result.append(corners)
    return result


def normal_form(facet):
    """The facet moved so that its list of places is least, and by what it was moved."""
    least = min(place[0] for place in facet)
    forms = []
    for place in facet:
        if place[0] == least:
            by = place[1:]
            moved = sorted([p[0]] + [x - y for x, y in zip(p[1:], by)] for p in facet)
            forms.append((moved, by))
    moved, by = min(forms)
    return tuple(map(tuple, moved)), by


def matched(simplices):
    """The mates, found by sorting the facets modulo the lattice; None for a facet without one."""
    groups = {}
    for s, corners in enumerate(simplices):
        for i in range(len(corners)):
            form, by = normal_form(corners[:i] + corners[i + 1:])
            groups.setdefault(form, []).append((s, i, by))
    mates = [[None] * len(corners) for corners in simplices]
    for pair in groups.values():
        if len(pair) == 2:
            (s, i, x), (t, j, y) = pair
            mates[s][i] = [t, j] + [p - q for p, q in zip(x, y)]
            mates[t][j] = [s, i] + [q - p for p, q in zip(x, y)]
    return mates


def certificate(gram, vertices, simplices, *statements, field="Q", a=0.0, domain="space"):
    simplices = oriented(vertices, simplices, a)
    mates = matched(simplices)
    if domain == "region":
        mates = [[mate or [] for mate in row] for row in mates]
    elif domain != "space":
        name_boundary(domain, vertices, simplices, mates, a)
    assert all(mate is not None for row in mates for mate in row), "not every facet has one mate"
    return {
        "format": "acutile-certificate", "version": 1,
        "claim": {"dimension": len(gram), "field": field, "gram": gram, "domain": domain,
                  "statements": [TILING, *statements]},
        "witness": {"vertices": vertices, "simplices": simplices, "mates": mates},
    }


def name_boundary(domain, vertices, simplices, mates, a):
    """Gives each facet without a mate the first face in whose plane its corners lie."""
    (polytope,) = domain.values()
    corners = [[approximate(x, a) for x in w] for w in polytope["vertices"]]
    k = len(corners[0])

    def in_plane(v, face):
        x = [approximate(x, a) for x in vertices[v][-k:]]
        base, *rest = [corners[w] for w in face[:k]]
        return abs(determinant([[p - q for p, q in zip(y, base)] for y in [*rest, x]])) < 1e-9
    for row, places in zip(mates, simplices):
        for i in range(len(row)):
            facet = [place[0] for place in places[:i] + places[i + 1:]]
            if row[i] is None:
                row[i] = next(([f] for f, face in enumerate(polytope["faces"])
                               if all(in_plane(v, face) for v in facet)), None)


# --- domains with a boundary ---------------------------------------------------

def polytope(vertices, faces):
    return {"vertices": [[x if isinstance(x, list) else str(x) for x in w] for w in vertices],
            "faces": faces}


def polygon(vertices):
    return polytope(vertices, [[i, (i + 1) % len(vertices)] for i in range(len(vertices))])


SEGMENT = polytope([[0], [1]], [[0], [1]])
SQUARE = polygon([[0, 0], [1, 0], [1, 1], [0, 1]])
CUBE_FACES = [[0, 1, 3, 2], [4, 5, 7, 6], [0, 1, 5, 4], [2, 3, 7, 6], [0, 2, 6, 4], [1, 3, 7, 5]]
CUBE_SOLID = polytope(list(itertools.product((0, 1), repeat=3)), CUBE_FACES)
KIND = {(2, 1): ("slab", SEGMENT), (3, 1): ("slab", SEGMENT), (3, 2): ("prism", SQUARE),
        (2, 2): ("solid", SQUARE), (3, 3): ("solid", CUBE_SOLID)}


def block(d, k, *statements, gram=None, domain=None):
    """Kuhn's simplices of the d-cube, periodic in the first d - k directions only."""
    kind, body = KIND[d, k]
    corners = list(itertools.product((0, 1), repeat=k))
    simplices = []
    for permutation in itertools.permutations(range(d)):
        at, places = [0] * d, []
        for axis in (None, *permutation):
            if axis is not None:
                at[axis] += 1
            places.append([corners.index(tuple(at[d - k:]))] + at[:d - k])
        simplices.append(places)
    vertices = [["0"] * (d - k) + [str(x) for x in c] for c in corners]
    gram = gram or [[str(int(i == j)) for j in range(d)] for i in range(d)]
    return certificate(gram, vertices, simplices, *statements, domain=domain or {kind: body})


def solid(gram, body, vertices, simplices, *statements):
    """A solid whose simplices are lists of vertices, all numbers rational."""
    vertices = [[str(x) for x in v] for v in vertices]
    simplices = [[[v] for v in corners] for corners in simplices]
    return certificate(gram, vertices, simplices, *statements, domain={"solid": body})


def tetrahedron(*statements):
    """The regular tetrahedron, in the basis of its three edges from a corner."""
    corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
    faces = [[1, 2, 3], [0, 2, 3], [0, 1, 3], [0, 1, 2]]
    gram = [["2", "1", "1"], ["1", "2", "1"], ["1", "1", "2"]]
    return solid(gram, polytope(corners, faces), corners, [[0, 1, 2, 3]], *statements)


def hexagon(*statements):
    """The regular hexagon, cut into six equilateral triangles."""
    ring = [[1, 0], [0, 1], [-1, 1], [-1, 0], [0, -1], [1, -1]]
    triangles = [[6, i, (i + 1) % 6] for i in range(6)]
    return solid(HEXAGONAL, polygon(ring), [*ring, [0, 0]], triangles, *statements)


def octahedron(*statements):
    """The regular octahedron, cut into four around an axis."""
    tips = [[1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]]
    sides = [[i, (i + 1) % 4] for i in range(4)]
    faces = [[*side, tip] for side in sides for tip in (4, 5)]
    return solid(CUBE, polytope(tips, faces), tips, [[*side, 4, 5] for side in sides], *statements)


def strip_of_height_sqrt_3(*statements):
    """Squares stretched to the height sqrt 3: the volume is no rational."""
    root = ["0", "1"]
    domain = {"slab": {"vertices": [["0"], [root]], "faces": [[0], [1]]}}
    simplices = [[[0, 0], [0, 1], [1, 0]], [[0, 1], [1, 1], [1, 0]]]
    return certificate([["1", "0"], ["0", "1"]], [["0", "0"], ["0", root]], simplices, *statements,
                       field=SQRT3, a=math.sqrt(3), domain=domain)


# --- regions -------------------------------------------------------------------

def region(vertices, simplices, *statements, gram=None, **field):
    """A mesh: the facets without a mate are its boundary."""
    vertices = [[x if isinstance(x, list) else str(x) for x in v] for v in vertices]
    simplices = [[[v] for v in corners] for corners in simplices]
    return certificate(gram or CUBE, vertices, simplices, *statements, domain="region", **field)


def cells(*corners):
    """Unit cubes at these corners, each cut into Kuhn's six tetrahedra: vertices and simplices."""
    index, simplices = {}, []
    for corner in corners:
        for permutation in itertools.permutations(range(3)):
            at, places = list(corner), []
            for axis in (None, *permutation):
                if axis is not None:
                    at[axis] += 1
                places.append(index.setdefault(tuple(at), len(index)))
            simplices.append(places)
    return list(index), simplices


def beside(*meshes):
    """Several meshes in one, none of whose vertices are shared."""
    vertices, simplices = [], []
    for points, tetrahedra in meshes:
        simplices += [[v + len(vertices) for v in corners] for corners in tetrahedra]
        vertices += points
    return vertices, simplices


def lone(*points):
    """One tetrahedron."""
    return list(points), [[0, 1, 2, 3]]


def small(x, y, z, size=F(1, 4)):
    """A small tetrahedron with its right-angled corner here."""
    return lone((x, y, z), (x + size, y, z), (x, y + size, z), (x, y, z + size))


THREE = list(itertools.product(range(3), repeat=3))
CAVITY = cells(*(c for c in THREE if c != (1, 1, 1)))
RING = cells(*((x, y, 0) for x, y, z in THREE if z == 0 and (x, y) != (1, 1)))
CORNER = lone((0, 0, 0), (4, 0, 0), (0, 4, 0), (0, 0, 4))


def below(degrees):
    return {"all dihedral angles below": degrees}


def above(degrees):
    return {"all dihedral angles above": degrees}


def ratio(q):
    return {"all radius-edge ratios below": q}


def algebraic(polynomial, low, high):
    return {"Q(a)": {"polynomial": polynomial, "root": [low, high]}}


SQRT3 = algebraic(["-3", "0", "1"], "1", "2")
# (x^2 - 2)(x^2 - 3), its root sqrt 2: a^2 - 2 is a vector that is not zero, of value zero.
REDUCIBLE = algebraic(["6", "0", "-5", "0", "1"], "1", "3/2")

# a^3 - 3a + 1 has three real roots: 2 cos 40, 2 cos 80, -2 cos 20 degrees.
THREE_ROOTS = ["1", "-3", "0", "1"]
# x^2 - 4, its root 2 at the middle of the interval: halving hits it.
TWO = algebraic(["-4", "0", "1"], "1", "3")

LATTICE_TRIANGLES = [[[0, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 1, 0], [0, 1, 1], [0, 0, 1]]]


def lattice(gram, *statements, **field):
    """The plane lattice: parallelograms, each cut into two triangles."""
    return certificate(gram, [["0", "0"]], LATTICE_TRIANGLES, *statements, **field)


def kuhn(gram, *statements):
    """Kuhn's six tetrahedra of a parallelepiped: 0, b_p, b_p + b_q, b_p + b_q + b_r."""
    simplices = []
    for permutation in itertools.permutations(range(3)):
        corner, corners = [0, 0, 0, 0], [[0, 0, 0, 0]]
        for axis in permutation:
            corner = corner[:]
            corner[1 + axis] += 1
            corners.append(corner)
        simplices.append(corners)
    return certificate(gram, [["0", "0", "0"]], simplices, *statements)


CUBE = [["1", "0", "0"], ["0", "1", "0"], ["0", "0", "1"]]
# bcc in the basis (-1,1,1), (1,-1,1), (1,1,-1): an obtuse superbase, so its
# Delaunay tetrahedra are Kuhn's (Delaunay 1932, Selling).
BCC = [["3", "-1", "-1"], ["-1", "3", "-1"], ["-1", "-1", "3"]]
HEXAGONAL = [["2", "1"], ["1", "2"]]


def square_triangle(*statements):
    """3^3.4^2 with edge 1: squares, each cut in two, and equilateral triangles, over Q(sqrt 3).

    Basis (1, 0), (1/2, 1 + sqrt 3 / 2); the second vertex is (0, 1) in the Cartesian frame.
    """
    gram = [["1", "1/2"], ["1/2", ["2", "1"]]]
    vertices = [["0", "0"], [["-2", "1"], ["4", "-2"]]]
    simplices = [
        [[0, 0, 0], [0, 1, 0], [1, 0, 0]], [[0, 1, 0], [1, 1, 0], [1, 0, 0]],
        [[1, 0, 0], [1, 1, 0], [0, 0, 1]], [[1, 1, 0], [0, 1, 1], [0, 0, 1]],
    ]
    return certificate(gram, vertices, simplices, *statements, field=SQRT3, a=math.sqrt(3))


def delaunay(points, gram, reach):
    """The Delaunay tetrahedra of points modulo Z^3, each orbit once; no edge is longer than sqrt(reach)."""
    def apply(x):
        return [sum(F(g) * y for g, y in zip(row, x)) for row in gram]

    def square(x):
        return sum(a * b for a, b in zip(x, apply(x)))
    cells = list(itertools.product((-1, 0, 1), repeat=3))
    cloud = [(v, c, [x + s for x, s in zip(p, c)]) for v, p in enumerate(points) for c in cells]
    found = {}
    for v, p in enumerate(points):
        near = [(w, c, [x - y for x, y in zip(q, p)]) for w, c, q in cloud]
        near = [n for n in near if 0 < square(n[2]) <= reach]
        for triple in itertools.combinations(near, 3):
            edges = [n[2] for n in triple]
            volume = determinant(edges)
            if volume == 0:
                continue
            squares, duals = [square(e) for e in edges], [apply(e) for e in edges]
            centre = []
            for k in range(3):
                centre.append(determinant([e[:k] + [r] + e[k + 1:] for e, r in zip(duals, squares)])
                              / (2 * determinant(duals)))
            radius = square(centre)
            powers = (square([x - y - z for x, y, z in zip(q, p, centre)]) - radius for _, _, q in cloud)
            on_sphere = 0
            for power in powers:
                if power < 0:
                    break
                on_sphere += power == 0
            else:
                assert on_sphere == 4, "cospherical points"
                corners = [[v, 0, 0, 0]] + [[w, *c] for w, c, _ in triple]
                form, _ = normal_form(corners)
                found[form] = [list(place) for place in form]
    return [found[form] for form in sorted(found)]


@functools.cache
def a15_simplices(points):
    return delaunay(points, CUBE, F(2, 5))


def a15(*statements):
    """A15: (0,0,0), (1/2,1/2,1/2) and the six of 6c; 46 tetrahedra."""
    points = [(F(0),) * 3, (F(1, 2),) * 3]
    for axis in range(3):
        for quarter in (1, 3):
            point = [F(0)] * 3
            point[axis], point[(axis + 2) % 3] = F(quarter, 4), F(1, 2)
            points.append(tuple(point))
    simplices = a15_simplices(tuple(points))
    assert len(simplices) == 46
    return certificate(CUBE, [[str(x) for x in p] for p in points], simplices, *statements)


HEXAGONAL_CELL = [["1", "-1/2", "0"], ["-1/2", "1", "0"], ["0", "0", "1"]]


def z_points():
    """Z in the group P6/mmm: a kagome layer, two points on the axis, a honeycomb."""
    half, third = F(1, 2), F(1, 3)
    kagome = [(half, 0, 0), (0, half, 0), (half, half, 0)]
    axis = [(0, 0, F(1, 4)), (0, 0, F(3, 4))]
    honeycomb = [(third, 2 * third, half), (2 * third, third, half)]
    return [tuple(map(F, p)) for p in kagome + axis + honeycomb]


@functools.cache
def z_simplices():
    return delaunay(z_points(), HEXAGONAL_CELL, F(2, 5))


def z(*statements):
    """Z: 7 points, 40 tetrahedra."""
    simplices = z_simplices()
    assert len(simplices) == 40
    vertices = [[str(x) for x in p] for p in z_points()]
    return certificate(HEXAGONAL_CELL, vertices, simplices, *statements)


def z_contracted(*statements):
    """Z with the cell doubled in two directions and one edge of the axis contracted.

    The edge, between heights 1/4 and 3/4, goes through a hexagon of the honeycomb, whose sides are
    in 6 tetrahedra; they lose one. The edges from its ends to the hexagon are in 5 each, and
    become 5 + 5 - 4 = 6. So all edges are in 5 or 6 tetrahedra, and triangles have two in 6.
    """
    tiling = z()["witness"]
    names = list(itertools.product(range(7), (0, 1), (0, 1)))
    low, high = names.index((3, 0, 0)), names.index((4, 0, 0))

    def place(v, x, y, zz, by):
        x, y = x + by[0], y + by[1]
        name = names.index((v, x % 2, y % 2))
        return [low if name == high else name, x // 2, y // 2, zz]
    simplices = []
    for corners, by in itertools.product(tiling["simplices"], itertools.product((0, 1), repeat=2)):
        places = [place(*corner, by) for corner in corners]
        if len(set(map(tuple, places))) == 4:
            simplices.append(places)
    points = z_points()
    vertices = []
    for v, x, y in names:
        p = points[v]
        height = F(1, 2) if names.index((v, x, y)) == low else p[2]
        vertices.append([str((p[0] + x) / 2), str((p[1] + y) / 2), str(height)])
    del vertices[high]
    simplices = [[[p[0] - (p[0] > high), *p[1:]] for p in places] for places in simplices]
    assert len(simplices) == 160 - 6
    gram = [["4", "-2", "0"], ["-2", "4", "0"], ["0", "0", "1"]]
    return certificate(gram, vertices, simplices, *statements)


def chambers(*statements):
    """The cube cut into the 48 chambers of its symmetry group: the edges of each are in 4, 4, 4, 6, 8
    and 8 tetrahedra."""
    names, simplices = [], []

    def place(p):
        base = tuple(x % 2 for x in p)
        if base not in names:
            names.append(base)
        return [names.index(base)] + [x // 2 for x in p]
    for permutation in itertools.permutations(range(3)):
        for signs in itertools.product((1, -1), repeat=3):
            # centre of the cube, of a face, of an edge, and a corner, in halves
            at = [1, 1, 1]
            places = [place(at)]
            for axis in permutation:
                at[axis] += signs[axis]
                places.append(place(at))
            simplices.append(places)
    vertices = [[str(F(x, 2)) for x in name] for name in names]
    return certificate(CUBE, vertices, simplices, *statements)


def a15_split(*statements):
    """A15 with one tetrahedron cut into four: edges in 3, and in 6 or 7 where there were 5 or 6."""
    witness = a15()["witness"]
    *rest, last = witness["simplices"]
    points = [[F(x) + y for x, y in zip(witness["vertices"][p[0]], p[1:])] for p in last]
    middle = [str(sum(xs) / 4) for xs in zip(*points)]
    new = [last[:i] + [[8, 0, 0, 0]] + last[i + 1:] for i in range(4)]
    return certificate(CUBE, witness["vertices"] + [middle], rest + new, *statements)


# --- tilings that are none ---------------------------------------------------

def overlaid(*statements):
    """Two copies of the lattice triangles, one moved: every facet matched, everything covered twice."""
    moved = [[[1] + place[1:] for place in corners] for corners in LATTICE_TRIANGLES]
    vertices = [["0", "0"], ["1/3", "1/3"]]
    return certificate(HEXAGONAL, vertices, LATTICE_TRIANGLES + moved, *statements)


def double_cover():
    """The triangles of two neighbouring cells, matched with the period 2 in the first direction
    but moved with the period 1: connected through its facets, and everything covered twice."""
    def place(x, y):
        return [x % 2, x - x % 2, y]
    simplices = []
    for x in (0, 1):
        simplices.append([place(x, 0), place(x + 1, 0), place(x, 1)])
        simplices.append([place(x + 1, 0), place(x + 1, 1), place(x, 1)])
    return certificate(HEXAGONAL, [["0", "0"], ["1", "0"]], simplices)


# --- the files -----------------------------------------------------------------

VALID = {
    "plane-equilateral": lattice(HEXAGONAL, "acute", "nonobtuse", below("60000001/1000000"), "Delaunay",
                                 "weakly Delaunay"),
    "plane-equilateral-acute": lattice(HEXAGONAL, "acute"),
    "plane-square": lattice([["1", "0"], ["0", "1"]], "nonobtuse", below("180"), "weakly Delaunay"),
    "plane-obtuse": lattice([["4", "-3"], ["-3", "4"]]),
    "plane-obtuse-below-140": lattice([["4", "-3"], ["-3", "4"]], below("140")),
    "plane-equilateral-times-sqrt-3": lattice([[["0", "2"], ["0", "1"]], [["0", "1"], ["0", "2"]]],
                                              "acute", below("61"), "Delaunay", field=SQRT3),
    "plane-square-triangle": square_triangle("nonobtuse", below("181/2"), "weakly Delaunay"),
    "plane-reducible-field": lattice([[["0", "2"], ["0", "1"]], [["0", "1"], ["0", "2"]]],
                                     "acute", "Delaunay", field=REDUCIBLE),
    "plane-cubic-field": lattice([[["0", "2"], ["0", "1"]], [["0", "1"], ["0", "2"]]],
                                 "acute", field=algebraic(THREE_ROOTS, "0", "1/2"), a=0.347),
    "plane-cubic-field-negative-root": lattice([[["0", "-2"], ["0", "-1"]], [["0", "-1"], ["0", "-2"]]],
                                               "acute", field=algebraic(THREE_ROOTS, "-2", "-3/2"), a=-1.879),
    "plane-field-with-rational-root": lattice([[["0", "2"], ["0", "1"]], [["0", "1"], ["0", "2"]]],
                                              "acute", field=TWO, a=2),
    "space-cube-6": kuhn(CUBE, "nonobtuse", "weakly Delaunay"),
    "space-bcc": kuhn(BCC, "nonobtuse", below("181/2"), "Delaunay", "weakly Delaunay"),
    "space-a15": a15("acute", below("7847/100"), "Delaunay"),
    "space-a15-tcp": a15("TCP"),
    "space-z-tcp": z("Delaunay", "TCP"),
    "space-z-contracted": z_contracted(),
    "space-chambers-of-the-cube": chambers("nonobtuse", above("0")),
    "plane-right-triangles-3-4-5": lattice([["9", "0"], ["0", "16"]], above("1843/50"), ratio("6/7")),
    "plane-equilateral-bounds": lattice(HEXAGONAL, below("6001/100"), above("5999/100"), ratio("2887/5000")),
    "strip": block(2, 1, "acute", below("61"), above("59"), "Delaunay", gram=[["2", "-1"], ["-1", "2"]]),
    "strip-of-height-sqrt-3": strip_of_height_sqrt_3("nonobtuse", "weakly Delaunay"),
    "slab-cube-6": block(3, 1, "nonobtuse", above("449/10"), "weakly Delaunay"),
    "slab-bcc": block(3, 1, "nonobtuse", "Delaunay", gram=BCC),
    "slab-first-vertex-above": block(3, 1, domain={"slab": polytope([[1], [0]], [[0], [1]])}),
    "prism-cube-6": block(3, 2, "nonobtuse", "weakly Delaunay"),
    "region-tetrahedron": region(*lone((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)), "acute", below("7053/100"),
                                 above("1763/25"), ratio("49/80"), gram=[["2", "1", "1"], ["1", "2", "1"], ["1", "1", "2"]]),
    "region-cube-6": region(*cells((0, 0, 0)), "nonobtuse"),
    "region-stairs": region(*cells((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1))),
    "region-cavity": region(*CAVITY, "nonobtuse"),
    "region-ring": region(*RING),
    "region-two-cubes-at-an-edge": region(*cells((0, 0, 0), (1, 1, 0))),
    "region-two-cubes-at-a-vertex": region(*cells((0, 0, 0), (1, 1, 1))),
    "region-cavities-at-an-edge": region(*cells(*(c for c in itertools.product(range(4), range(4), range(3))
                                                  if c not in ((1, 1, 1), (2, 2, 1))))),
    "region-ring-pinched-shut": region(*cells((0, 0, 0), (1, 0, 0), (2, 0, 0), (0, 1, 0), (0, 2, 0), (2, 1, 0), (1, 2, 0))),
    "region-piece-in-a-cavity": region(*beside(CAVITY, small(F(5, 4), F(5, 4), F(5, 4)))),
    "region-piece-in-the-hole-of-a-ring": region(*beside(RING, small(F(5, 4), F(5, 4), F(1, 3)))),
    "region-pieces-apart": region(*beside(*(small(x, y, z, F(1, 2)) for x, y, z in THREE))),
    "region-two-in-a-plane": region([(0, 0, 0), (4, 0, 0), (0, 4, 0), (0, 0, 4), (4, 4, 0), (2, 2, -4)],
                                    [[0, 1, 2, 3], [1, 2, 4, 5]]),
    "region-prism-over-sqrt-3": region([(0, 0, 0), (2, 0, 0), (1, ["0", "1"], 0), (0, 0, 1), (2, 0, 1), (1, ["0", "1"], 1)],
                                       [[0, 1, 2, 3], [1, 2, 3, 4], [2, 3, 4, 5]], below("135"),
                                       field=SQRT3, a=math.sqrt(3)),
    "prism-sides-in-any-order": block(3, 2, domain={"prism": polytope(
        [[1, 0], [1, 1], [0, 0], [0, 1]], [[0, 2], [3, 1], [3, 2], [0, 1]])}),
    "solid-square-2": block(2, 2, "nonobtuse", above("44"), ratio("5/7"), "weakly Delaunay"),
    "solid-hexagon": hexagon("acute", "Delaunay"),
    "solid-cube-6": block(3, 3, "nonobtuse", below("901/10"), "weakly Delaunay"),
    "solid-cube-faces-turned-and-reversed": block(3, 3, domain={"solid": polytope(
        [[F(x) for x in w] for w in CUBE_SOLID["vertices"]],
        [face[i % 4:] + face[:i % 4] if i % 2 else face[::-1] for i, face in enumerate(CUBE_FACES)])}),
    "solid-octahedron": octahedron(below("2737/25"), "weakly Delaunay"),
    "solid-tetrahedron": tetrahedron("acute", below("7053/100"), above("1763/25"), ratio("49/80"), "Delaunay"),
}


def moved_by_a_lattice_vector():
    """One tetrahedron of cube-6 moved by (5, -7, 2): still right."""
    c = copy.deepcopy(VALID["space-cube-6"])
    by = [5, -7, 2]
    c["witness"]["simplices"][2] = [
        [p[0]] + [x + y for x, y in zip(p[1:], by)] for p in c["witness"]["simplices"][2]]
    c["witness"]["mates"] = [[mate or [] for mate in row] for row in matched(c["witness"]["simplices"])]
    return c


VALID["space-cube-6-one-moved-by-a-lattice-vector"] = moved_by_a_lattice_vector()


def edit(base, path, value):
    """A copy of a certificate with one member replaced (or, by `None`, removed)."""
    c = copy.deepcopy(base)
    *way, last = path
    at = c
    for step in way:
        at = at[step]
    if value is None:
        del at[last]
    else:
        at[last] = value
    return c


E, C6, K, A = (VALID[n] for n in
               ("plane-equilateral", "space-cube-6", "plane-square-triangle", "space-a15"))
GRAM, SIMPLICES, MATES = ("claim", "gram"), ("witness", "simplices"), ("witness", "mates")
VERTICES, STATEMENTS = ("witness", "vertices"), ("claim", "statements")
FIELD, DOMAIN = ("claim", "field"), ("claim", "domain")
MESH = VALID["region-cube-6"]
STRIP, SLAB, PRISM, SOLID = (VALID[n] for n in ("strip", "slab-cube-6", "prism-cube-6", "solid-cube-6"))
BARE = lattice(HEXAGONAL)


def number(bad):
    return edit(BARE, (*GRAM, 0, 0), bad)


def root(polynomial, low, high):
    return edit(K, FIELD, algebraic(polynomial, low, high))


def replaced(base, old, new):
    before = to_bytes(base)
    assert before.count(old) >= 1, old
    return before.replace(old, new, 1)


MALFORMED = {
    "json--empty": b"",
    "json--truncated": to_bytes(E)[:200],
    "json--not-json": b"space is tiled\n",
    "json--bom": b"\xef\xbb\xbf" + to_bytes(E),
    "json--trailing-garbage": to_bytes(E) + b"{}\n",
    "json--not-utf-8": replaced(E, b"space", b"sp\xffce"),
    "json--nul-byte": replaced(E, b"space", b"sp\x00ce"),
    "json--deep-nesting": b"[" * 20_000 + b"]" * 20_000,
    "json--deep-nesting-in-a-number": replaced(BARE, b'"2"', b"[" * 5000 + b"]" * 5000),
    "json--duplicate-key": replaced(E, b'"version":1,', b'"version":1,\n"version":1,'),
    "json--duplicate-claim-key": replaced(E, b'"dimension":2,', b'"dimension":2,\n"dimension":2,'),
    "json--unknown-member": edit(E, ("proof",), "trust me"),
    "json--unknown-member-of-claim": edit(E, ("claim", "verified"), True),
    "json--unknown-member-of-witness": edit(E, ("witness", "note"), "x"),
    "json--no-witness": edit(E, ("witness",), None),
    "json--no-mates": edit(E, MATES, None),
    "json--no-version": edit(E, ("version",), None),
    "json--version-as-text": edit(E, ("version",), "1"),
    "json--version-negative": edit(E, ("version",), -1),
    "json--version-huge": replaced(E, b'"version":1', b'"version":1e999999999'),
    "json--unknown-domain": edit(E, ("claim", "domain"), "sphere"),
    "json--unknown-statement": edit(E, (*STATEMENTS, 1), "beautiful"),
    "json--unknown-field": edit(E, FIELD, "R"),
    "json--bare-number": replaced(BARE, b'"2"', b"2"),
    "json--nan": replaced(BARE, b'"2"', b"NaN"),
    "json--coefficient-as-array": edit(BARE, (*GRAM, 0, 0), ["1", ["1"]]),
    "json--null-coordinate": replaced(BARE, b'["0","0"]', b'["0",null]'),
    "json--shift-beyond-64-bits": replaced(E, b"[0,1,0]", b"[0,9223372036854775808,0]"),
    "json--vertex-as-float": replaced(E, b"[0,1,0]", b"[0.0,1,0]"),
    "json--angle-without-degrees": edit(E, STATEMENTS, [TILING, "all dihedral angles below"]),
    "format--other": edit(E, ("format",), "acutile-tiling"),
    "format--control-characters": edit(E, ("format",), "x: verified\n\x1b[2J"),
    "format--long": edit(E, ("format",), "x" * 5000),
    "canonical--crlf": to_bytes(E).replace(b"\n", b"\r\n"),
    "canonical--no-last-newline": to_bytes(E)[:-1],
    "canonical--two-last-newlines": to_bytes(E) + b"\n",
    "canonical--one-line": (json.dumps(E, separators=(",", ":")) + "\n").encode(),
    "canonical--indented": (json.dumps(E, indent=1) + "\n").encode(),
    "canonical--escaped-characters": replaced(E, b'"acute"', b'"\\u0061cute"'),
    "canonical--space": replaced(E, b'"version":1', b'"version": 1'),
    "canonical--members-in-other-order": {k: E[k] for k in ("version", "format", "claim", "witness")},
    "canonical--claim-after-witness": {k: E[k] for k in ("format", "version", "witness", "claim")},
    "canonical--rational-as-array": edit(K, (*GRAM, 0, 0), ["1"]),
    "canonical--claim-as-array": edit(E, ("claim",), list(E["claim"].values())),
    "json--certificate-as-array": list(E.values()),
    "canonical--statement-as-object": edit(E, (*STATEMENTS, 1), {"acute": None}),
    "dimension--1": edit(E, ("claim", "dimension"), 1),
    "dimension--0": edit(E, ("claim", "dimension"), 0),
    "dimension--4": edit(E, ("claim", "dimension"), 4),
    "dimension--huge": edit(E, ("claim", "dimension"), 2 ** 63),
    "statements--none": edit(E, STATEMENTS, []),
    "statements--no-tiling": edit(E, STATEMENTS, ["acute"]),
    "statements--repeated": edit(E, STATEMENTS, [TILING, "acute", "acute"]),
    "statements--tiling-twice": edit(E, STATEMENTS, [TILING, TILING]),
    "statements--order": edit(E, STATEMENTS, [TILING, "Delaunay", "acute"]),
    "statements--two-angle-bounds": edit(E, STATEMENTS, [TILING, below("61"), below("62")]),
    "gram-shape--row-missing": edit(E, GRAM, [["2", "1"]]),
    "gram-shape--row-long": edit(E, GRAM, [["2", "1", "0"], ["1", "2"]]),
    "gram-shape--other-dimension": edit(E, ("claim", "dimension"), 3),
    "gram-shape--empty": edit(E, GRAM, []),
    "no-simplices": edit(edit(edit(E, SIMPLICES, []), MATES, []), VERTICES, []),
    "no-simplices--with-vertex": edit(edit(E, SIMPLICES, []), MATES, []),
    "vertex-length--short": edit(E, (*VERTICES, 0), ["0"]),
    "vertex-length--long": edit(E, (*VERTICES, 0), ["0", "0", "0"]),
    "simplex-length--short": edit(E, (*SIMPLICES, 1), E["witness"]["simplices"][1][:2]),
    "simplex-length--long": edit(E, (*SIMPLICES, 1), E["witness"]["simplices"][1] + [[0, 0, 0]]),
    "simplex-length--empty": edit(E, (*SIMPLICES, 0), []),
    "corner-length--short": edit(E, (*SIMPLICES, 0, 1), [0, 1]),
    "corner-length--long": edit(E, (*SIMPLICES, 0, 1), [0, 1, 0, 0]),
    "corner-length--empty": edit(E, (*SIMPLICES, 0, 1), []),
    "vertex-range--one-too-far": edit(E, (*SIMPLICES, 0, 1), [1, 1, 0]),
    "vertex-range--negative": edit(E, (*SIMPLICES, 0, 1), [-1, 1, 0]),
    "vertex-range--huge": edit(E, (*SIMPLICES, 0, 1), [2 ** 63 - 1, 1, 0]),
    "vertex-range--no-vertices": edit(E, VERTICES, []),
    "shift-range--2-to-31": edit(E, (*SIMPLICES, 0, 1), [0, 2 ** 31, 0]),
    "shift-range--least-64-bits": edit(E, (*SIMPLICES, 0, 1), [0, -2 ** 63, 0]),
    "shift-range--largest-64-bits": edit(E, (*SIMPLICES, 0, 1), [0, 2 ** 63 - 1, 0]),
    "unused-vertex": edit(E, VERTICES, [["0", "0"], ["1/2", "1/2"]]),
    "mates-length--short": edit(E, MATES, E["witness"]["mates"][:1]),
    "mates-length--long": edit(E, MATES, E["witness"]["mates"] * 2),
    "mates-length--empty": edit(E, MATES, []),
    "mate-row-length--short": edit(E, (*MATES, 0), E["witness"]["mates"][0][:2]),
    "mate-row-length--long": edit(E, (*MATES, 0), E["witness"]["mates"][0] * 2),
    "mate-length--short": edit(E, (*MATES, 0, 0), [1, 2, 0]),
    "mate-length--long": edit(E, (*MATES, 0, 0), [1, 2, 0, 0, 0]),
    "mate-length--empty": edit(E, (*MATES, 0, 0), []),
    "mate-range--simplex": edit(E, (*MATES, 0, 0, 0), 2),
    "mate-range--simplex-negative": edit(E, (*MATES, 0, 0, 0), -1),
    "mate-range--facet": edit(E, (*MATES, 0, 0, 1), 3),
    "mate-shift-range--2-to-31": edit(E, (*MATES, 0, 0, 2), -2 ** 31),
    "mate-shift-range--least-64-bits": edit(E, (*MATES, 0, 0, 2), -2 ** 63),
    "number--zero-denominator": number("1/0"),
    "number--not-lowest-terms": number("2/4"),
    "number--zero-not-lowest-terms": number("0/2"),
    "number--denominator-1": number("2/1"),
    "number--denominator-negative": number("1/-2"),
    "number--denominator-missing": number("1/"),
    "number--numerator-missing": number("/2"),
    "number--two-slashes": number("1/2/3"),
    "number--minus-zero": number("-0"),
    "number--plus": number("+1"),
    "number--two-minus": number("--5"),
    "number--leading-zero": number("01"),
    "number--leading-zero-of-denominator": number("1/02"),
    "number--decimal": number("0.25"),
    "number--exponent": number("1e999999999"),
    "number--hexadecimal": number("0x10"),
    "number--underscore": number("1_000"),
    "number--empty": number(""),
    "number--minus-alone": number("-"),
    "number--space": number(" 2"),
    "number--newline": number("2\n"),
    "number--arabic-digits": number("\u0662"),
    "number--fullwidth-digits": number("\uff12"),
    "number--nan": number("NaN"),
    "number--infinity": number("inf"),
    "number--expression": number("sqrt(2)"),
    "number--in-a-vertex": edit(BARE, (*VERTICES, 0, 1), "0/1"),
    "number--in-the-polynomial": root(["-03", "0", "1"], "1", "2"),
    "number--in-the-root": root(["-3", "0", "1"], "1", "2/1"),
    "number--in-the-angle": edit(E, STATEMENTS, [TILING, below("77.08")]),
    "number--not-ascii-and-long": number("\u00e9" * 300),
    "polynomial--empty": root([], "1", "2"),
    "polynomial--constant": root(["1"], "1", "2"),
    "polynomial--linear": root(["-1", "1"], "0", "2"),
    "polynomial--not-monic": root(["-3", "0", "2"], "1", "2"),
    "polynomial--leading-zero": root(["-3", "0", "1", "0"], "1", "2"),
    "polynomial--fraction": root(["-5/2", "0", "1"], "1", "2"),
    "root-order--equal": root(["-3", "0", "1"], "1", "1"),
    "root-order--reversed": root(["-3", "0", "1"], "2", "1"),
    "coefficients--none": number([]),
    "coefficients--more-than-degree": edit(K, (*GRAM, 1, 1), ["2", "1", "1"]),
    "coefficients--two-over-the-rationals": number(["2", "1"]),
    "coefficients--trailing-zero": edit(K, (*GRAM, 1, 1), ["2", "0"]),
    "angle-range--zero": edit(E, STATEMENTS, [TILING, below("0")]),
    "angle-range--negative": edit(E, STATEMENTS, [TILING, below("-60")]),
    "angle-range--above-180-from-below": edit(E, STATEMENTS, [TILING, above("180")]),
    "angle-range--negative-from-below": edit(E, STATEMENTS, [TILING, above("-1/2")]),
    "ratio-range--zero": edit(E, STATEMENTS, [TILING, ratio("0")]),
    "ratio-range--negative": edit(E, STATEMENTS, [TILING, ratio("-2/3")]),
    "number--in-the-angle-from-below": edit(E, STATEMENTS, [TILING, above("10.5")]),
    "number--in-the-ratio": edit(E, STATEMENTS, [TILING, ratio("1.5")]),
    "statements--above-before-below": edit(E, STATEMENTS, [TILING, above("1"), below("90")]),
    "statements--tcp-before-delaunay": edit(A, STATEMENTS, [TILING, "TCP", "Delaunay"]),
    "statements--two-ratios": edit(E, STATEMENTS, [TILING, ratio("2"), ratio("3")]),
    "tcp-domain--plane": edit(E, STATEMENTS, [TILING, "TCP"]),
    "tcp-domain--slab": edit(SLAB, STATEMENTS, [TILING, "TCP"]),
    "tcp-domain--solid": edit(SOLID, STATEMENTS, [TILING, "TCP"]),
    "tcp-domain--region": edit(MESH, STATEMENTS, [TILING, "TCP"]),
    "delaunay-domain": edit(MESH, STATEMENTS, [TILING, "Delaunay"]),
    "delaunay-domain--weakly": edit(MESH, STATEMENTS, [TILING, "nonobtuse", "weakly Delaunay"]),
    "region-dimension": edit(block(2, 2), DOMAIN, "region"),
    "json--region-with-polytope": edit(MESH, DOMAIN, {"region": CUBE_SOLID}),
    "canonical--region-as-object": edit(MESH, DOMAIN, {"region": None}),
    "mate-length--face-of-a-region": edit(MESH, (*MATES, 0, 0), [0]),
    "mate-length--nothing-behind-in-space": edit(C6, (*MATES, 0, 0), []),
    "mate-length--nothing-behind-in-a-solid": edit(SOLID, (*MATES, 0, 0), []),
    "json--slab-without-polytope": edit(SLAB, DOMAIN, "slab"),
    "json--space-with-polytope": edit(SLAB, DOMAIN, {"space": SEGMENT}),
    "json--two-domains": edit(SLAB, DOMAIN, {"slab": SEGMENT, "solid": SEGMENT}),
    "json--unknown-member-of-domain": edit(SLAB, DOMAIN, {"slab": {**SEGMENT, "height": "1"}}),
    "json--domain-without-faces": edit(SLAB, DOMAIN, {"slab": {"vertices": [["0"], ["1"]]}}),
    "json--face-of-a-negative-vertex": edit(SLAB, DOMAIN, {"slab": {**SEGMENT, "faces": [[0], [-1]]}}),
    "json--face-as-text": edit(SLAB, DOMAIN, {"slab": {**SEGMENT, "faces": [[0], "1"]}}),
    "canonical--space-as-object": edit(E, DOMAIN, {"space": None}),
    "canonical--faces-before-vertices": edit(SLAB, DOMAIN, {"slab": {k: SEGMENT[k] for k in ("faces", "vertices")}}),
    "number--in-the-domain": edit(SLAB, DOMAIN, {"slab": polytope([["0/1"], [1]], [[0], [1]])}),
    "prism-dimension": edit(block(2, 2), DOMAIN, {"prism": SQUARE}),
    "prism-dimension--segment": edit(STRIP, DOMAIN, {"prism": SEGMENT}),
    "domain-vertex-length--slab": edit(SLAB, DOMAIN, {"slab": polytope([[0], [0, 1]], [[0], [1]])}),
    "domain-vertex-length--all-coordinates":
        edit(SLAB, DOMAIN, {"slab": polytope([[0, 0, 0], [0, 0, 1]], [[0], [1]])}),
    "domain-vertex-length--solid": edit(SOLID, DOMAIN, {"solid": SQUARE}),
    "domain-vertex-length--empty": edit(SLAB, DOMAIN, {"slab": polytope([[], []], [[0], [1]])}),
    "face-count--none": edit(SOLID, DOMAIN, {"solid": polytope([], [])}),
    "face-count--half-space": edit(SLAB, DOMAIN, {"slab": polytope([[0]], [[0]])}),
    "face-count--solid-with-three":
        edit(SOLID, DOMAIN, {"solid": {**CUBE_SOLID, "faces": CUBE_FACES[:3]}}),
    "face-length--slab": edit(SLAB, DOMAIN, {"slab": {**SEGMENT, "faces": [[0], [1, 0]]}}),
    "face-length--empty": edit(SLAB, DOMAIN, {"slab": {**SEGMENT, "faces": [[0], []]}}),
    "face-length--side-with-one": edit(PRISM, DOMAIN, {"prism": {**SQUARE, "faces": [[0, 1], [1, 2], [2, 3], [3]]}}),
    "face-length--side-with-three":
        edit(PRISM, DOMAIN, {"prism": {**SQUARE, "faces": [[0, 1], [1, 2], [2, 3, 0], [3, 0]]}}),
    "face-length--solid-with-sides": edit(SOLID, DOMAIN, {"solid": {**CUBE_SOLID, "faces": CUBE_FACES + [[0, 1]]}}),
    "face-vertices--range": edit(SLAB, DOMAIN, {"slab": {**SEGMENT, "faces": [[0], [2]]}}),
    "face-vertices--huge": edit(SLAB, DOMAIN, {"slab": {**SEGMENT, "faces": [[0], [2 ** 64 - 1]]}}),
    "face-vertices--twice": edit(SOLID, DOMAIN, {"solid": {**CUBE_SOLID, "faces": [[0, 1, 3, 2, 0]] + CUBE_FACES[1:]}}),
    "face-vertices--side-of-one": edit(PRISM, DOMAIN, {"prism": {**SQUARE, "faces": [[0, 0], [1, 2], [2, 3], [3, 0]]}}),
    "face-repeated--slab": edit(SLAB, DOMAIN, {"slab": polytope([[0]], [[0], [0]])}),
    "face-repeated--side-reversed":
        edit(PRISM, DOMAIN, {"prism": {**SQUARE, "faces": SQUARE["faces"] + [[1, 0]]}}),
    "face-repeated--two-opposite-faces-doubled":
        edit(SOLID, DOMAIN, {"solid": {**CUBE_SOLID, "faces": CUBE_FACES[:2] + [face[::-1] for face in CUBE_FACES[:2]]}}),
    "unused-domain-vertex": edit(SOLID, DOMAIN, {"solid": {**CUBE_SOLID, "vertices": CUBE_SOLID["vertices"] + [["9", "9", "9"]]}}),
    "unused-domain-vertex--inner": edit(SLAB, DOMAIN, {"slab": polytope([[0], [1], ["1/2"]], [[0], [1]])}),
    "mate-length--face-in-space": edit(E, (*MATES, 0, 0), [0]),
    "mate-length--empty-in-slab": edit(SLAB, (*MATES, 0, 0), []),
    "mate-length--short-in-slab": edit(SLAB, (*MATES, 0, 0), [0, 0]),
    "mate-range--face": edit(SLAB, (*MATES, 0, 0), [2]),
    "mate-range--face-negative": edit(SLAB, (*MATES, 0, 0), [-1]),
    "gram-asymmetric": edit(E, (*GRAM, 0, 1), "0"),
    "gram-asymmetric--nothing-else-wrong": edit(BARE, (*GRAM, 0, 1), "0"),
    # 2 - a^2 and a^2 - 2 have the same value, zero, for a^2 = 2.
    "gram-asymmetric--equal-in-value": edit(VALID["plane-reducible-field"], GRAM,
                                            [["1", ["2", "0", "-1"]], [["-2", "0", "1"], "1"]]),
    "root-derivative--three-roots": root(THREE_ROOTS, "-2", "2"),
    "root-derivative--one-root-but-wide": root(["-3", "0", "1"], "-1", "2"),
    "root-derivative--triple-root": root(["-1", "3", "-3", "1"], "0", "3"),
    "root-derivative--monotone-but-zero-at-an-end": root(["-3", "0", "1"], "0", "2"),
    "angle-range--above-180": edit(E, STATEMENTS, [TILING, below("1800001/10000")]),
}


def swapped(base, simplex):
    """Two corners of one simplex exchanged, and its mates with them: negative orientation."""
    c = copy.deepcopy(base)
    corners = c["witness"]["simplices"][simplex]
    corners[0], corners[1] = corners[1], corners[0]
    c["witness"]["mates"] = [[mate or [] for mate in row] for row in matched(c["witness"]["simplices"])]
    return c


def mirrored():
    """All simplices negative: the same tiling seen in a mirror."""
    c = copy.deepcopy(E)
    for corners in c["witness"]["simplices"]:
        corners[0], corners[1] = corners[1], corners[0]
    c["witness"]["mates"] = [[mate or [] for mate in row] for row in matched(c["witness"]["simplices"])]
    return c


def without_last(base, mate):
    """The last simplex left out; facets that were matched with it get `mate(simplex, facet)`."""
    c = copy.deepcopy(base)
    last = len(c["witness"]["simplices"]) - 1
    c["witness"]["simplices"].pop()
    c["witness"]["mates"].pop()
    for s, row in enumerate(c["witness"]["mates"]):
        for i, m in enumerate(row):
            if m[0] == last:
                row[i] = mate(s, i)
    return c


def lone_pair(base):
    """cube-6 without its last simplex, its open facets matched with one another in turn."""
    open_facets = [(s, i) for s, row in enumerate(base["witness"]["mates"]) for i, m in enumerate(row) if m[0] == 5]
    open_facets = [f for f in open_facets if f[0] != 5]
    partner = {f: open_facets[k ^ 1] for k, f in enumerate(open_facets)}
    return without_last(base, lambda s, i: [*partner[s, i], 0, 0, 0])


def doubled(base):
    """One simplex twice; the two copies are each other's mates."""
    c = copy.deepcopy(base)
    n = len(c["witness"]["simplices"])
    zero = [0] * c["claim"]["dimension"]
    c["witness"]["simplices"].append(copy.deepcopy(c["witness"]["simplices"][-1]))
    c["witness"]["mates"].append([[n - 1, i, *zero] for i in range(len(zero) + 1)])
    return c


def doubled_pair(base):
    """Two more copies of one simplex, which are each other's mates: only the sides are wrong."""
    c = copy.deepcopy(base)
    n = len(c["witness"]["simplices"])
    zero = [0] * c["claim"]["dimension"]
    for other in (n + 1, n):
        c["witness"]["simplices"].append(copy.deepcopy(c["witness"]["simplices"][0]))
        c["witness"]["mates"].append([[other, i, *zero] for i in range(len(zero) + 1)])
    return c


def permuted_mates():
    """The mates of one simplex in another order, mutually: other corners."""
    c = copy.deepcopy(C6)
    row = c["witness"]["mates"][0]
    row[0], row[1] = row[1], row[0]
    for facet in (0, 1):
        t, j, *u = row[facet]
        c["witness"]["mates"][t][j] = [0, facet, *[-x for x in u]]
    return c


def wrong_shift():
    """One pair of mates one lattice vector further, mutually: moved corners."""
    c = copy.deepcopy(E)
    t, j, *u = c["witness"]["mates"][0][0]
    u[0] += 1
    c["witness"]["mates"][0][0] = [t, j, *u]
    c["witness"]["mates"][t][j] = [0, 0, *[-x for x in u]]
    return c


def own_mate():
    """A pair of mates parted: each becomes its own."""
    t, j, *_ = E["witness"]["mates"][0][0]
    return edit(edit(E, (*MATES, 0, 0), [0, 0, 0, 0]), (*MATES, t, j), [t, j, 0, 0])


def one_sided_mate():
    return edit(E, (*MATES, 0, 0), E["witness"]["mates"][0][1])


def folded():
    """Two triangles on the same side of their common edge, closed to a sphere that covers nothing."""
    corners = [[0, 0, 0], [0, 1, 0], [0, 0, 1]]
    c = copy.deepcopy(E)
    c["witness"]["simplices"] = [corners, corners]
    c["witness"]["mates"] = [[[1 - s, i, 0, 0] for i in range(3)] for s in range(2)]
    return c


def folded_over():
    """A lattice triangle cut into three at an inner vertex, the vertex then moved across an edge:
    matched, volumes sum to one, one triangle is negative."""
    third = [[0, 0, 0], [0, 1, 0], [0, 0, 1]]
    fan = [[[1, 0, 0], third[k], third[(k + 1) % 3]] for k in range(3)]
    c = certificate(HEXAGONAL, [["0", "0"], ["1/3", "1/3"]], fan + LATTICE_TRIANGLES[1:])
    return edit(c, (*VERTICES, 1), ["2/3", "2/3"])


def in_domain(base, kind, body):
    """The tiling in another domain; facets in a face that this one has not are said to lie in face 0."""
    c = edit(base, DOMAIN, {kind: body})
    faces = len(body["faces"])
    rows = c["witness"]["mates"]
    c["witness"]["mates"] = [[[0] if len(m) == 1 and m[0] >= faces else m for m in row] for row in rows]
    return c


def far_point_with_flat_faces():
    """A square, and three more vertices at one point far off, joined by three sides of no length:
    only that sides must be sides shows that the convex hull is larger."""
    corners = [[0, 0], [1, 0], [1, 1], [0, 1]] + 3 * [[10, 10]]
    sides = [[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 4]]
    return in_domain(block(2, 2), "solid", polytope(corners, sides))


def star():
    """A prism over a pentagon, whose top is listed as a pentagram."""
    ring = [[0, 0], [2, 0], [3, 2], [1, 3], [-1, 2]]
    corners = [[*p, height] for height in (0, 1) for p in ring]
    sides = [[i, (i + 1) % 5, 5 + (i + 1) % 5, 5 + i] for i in range(5)]
    return in_domain(SOLID, "solid", polytope(corners, [*sides, [0, 1, 2, 3, 4], [5, 7, 9, 6, 8]]))


def cube_with_a_vertex_on_an_edge():
    """Right but for the vertex, which is none of the cube."""
    faces = [[0, 8, 1, 3, 2], *CUBE_FACES[1:2], [4, 0, 8, 1, 5], *CUBE_FACES[3:]]
    faces[2] = [1, 5, 4, 0, 8]
    faces[0] = [1, 3, 2, 0, 8]
    return in_domain(SOLID, "solid", polytope(CUBE_SOLID["vertices"] + [["0", "0", "1/2"]], faces))


def other_side_of_a_face():
    """The quadrilateral between the lines from the origin cut off by 3 and 4, by 2 and 3, and beside
    it the triangle of the same area that its sides cut off: that is what is tiled."""
    body = polygon([[3, 0], [4, 0], [0, 3], [0, 2]])
    return solid(CUBE_2, body, [[0, 0], [3, 0], [0, 2]], [[0, 1, 2]])


def copies(base, *simplices):
    """The tiling made of these simplices of another, each with vertices of its own."""
    c, w = copy.deepcopy(base), base["witness"]
    n = len(w["vertices"])
    c["witness"] = {"vertices": [], "simplices": [], "mates": []}
    for s in simplices:
        for corner in w["simplices"][s]:
            c["witness"]["vertices"].append(w["vertices"][corner[0]])
        at = len(c["witness"]["vertices"]) - len(w["simplices"][s])
        c["witness"]["simplices"].append([[at + i, *p[1:]] for i, p in enumerate(w["simplices"][s])])
        c["witness"]["mates"].append([m if len(m) == 1 else [0] for m in w["mates"][s]])
    return c


def twice(base):
    """All of a tiling twice, each copy with its own vertices and right in itself."""
    c, w = copy.deepcopy(base), base["witness"]
    n, m = len(w["vertices"]), len(w["simplices"])
    c["witness"]["vertices"] *= 2
    c["witness"]["simplices"] += [[[p[0] + n, *p[1:]] for p in corners] for corners in w["simplices"]]
    c["witness"]["mates"] += [[x if len(x) == 1 else [x[0] + m, *x[1:]] for x in row] for row in w["mates"]]
    return c


def hole_as_boundary(base, simplex):
    """A simplex left out; the facets around it are said to lie in face 0."""
    c = copy.deepcopy(base)
    c["witness"]["simplices"].pop(simplex)
    c["witness"]["mates"].pop(simplex)
    for row in c["witness"]["mates"]:
        for i, mate in enumerate(row):
            if len(mate) > 1:
                row[i] = [0] if mate[0] == simplex else [mate[0] - (mate[0] > simplex), *mate[1:]]
    return c


def exchanged(base):
    """The two faces exchanged in the domain, but not in the mates."""
    c = copy.deepcopy(base)
    c["claim"]["domain"]["slab"]["faces"] = [[1], [0]]
    return c


def cut(base, face=0):
    """One pair of mates parted: both are said to lie in the boundary."""
    c = copy.deepcopy(base)
    s, i = next((s, i) for s, row in enumerate(base["witness"]["mates"]) for i, m in enumerate(row) if len(m) > 1)
    t, j, *_ = base["witness"]["mates"][s][i]
    c["witness"]["mates"][s][i] = c["witness"]["mates"][t][j] = [face]
    return c


def one_cut(base):
    c = copy.deepcopy(base)
    s, i = next((s, i) for s, row in enumerate(base["witness"]["mates"]) for i, m in enumerate(row) if len(m) > 1)
    c["witness"]["mates"][s][i] = [0]
    return c


def solid_moved(by):
    """The tiling of the cube, beside the cube."""
    c = copy.deepcopy(SOLID)
    for v in c["witness"]["vertices"]:
        v[0] = str(F(v[0]) + by)
    return c


CUBE_2 = [["1", "0"], ["0", "1"]]
MOVED_CORNER = [*CUBE_SOLID["vertices"][:7], ["1", "1", "2"]]


def with_statements(base, *statements):
    return edit(base, STATEMENTS, [TILING, *statements])


def opened(base):
    """One pair of mates parted: both are said to be in the boundary, from inside."""
    c = copy.deepcopy(base)
    s, i = next((s, i) for s, row in enumerate(base["witness"]["mates"]) for i, m in enumerate(row) if m)
    t, j = base["witness"]["mates"][s][i]
    c["witness"]["mates"][s][i] = c["witness"]["mates"][t][j] = []
    return c


def in_the_cavity(*points):
    """A mesh with a cavity, and a tetrahedron with these vertices, given by their index or place."""
    vertices, simplices = copy.deepcopy(CAVITY)
    corners = []
    for point in points:
        if point in vertices:
            corners.append(vertices.index(point))
        else:
            corners.append(len(vertices))
            vertices.append(point)
    return region(vertices, [*simplices, corners])


FOLD = region([(0, 0, 0), (4, 0, 0), (0, 4, 0), (0, 0, 4), (1, 1, 4)], [[0, 1, 2, 3]])
FOLD["witness"]["simplices"].append([[0], [1], [2], [4]])
FOLD["witness"]["mates"].append([[], [], [], []])

FALSE = {
    # A large tetrahedron with a corner at 0, and another one outside that touches it or pierces it.
    "boundary-meets--vertex-in-a-facet": region(*beside(CORNER, lone((1, 1, 0), (1, 2, -1), (2, 1, -1), (1, 1, -2)))),
    "boundary-meets--vertex-on-an-edge": region(*beside(CORNER, lone((2, 0, 0), (2, -1, -1), (2, -2, -1), (3, -1, -2)))),
    "boundary-meets--vertex-on-a-vertex": region(*beside(CORNER, lone((4, 0, 0), (5, 0, 0), (5, 1, 0), (5, 0, 1)))),
    "boundary-meets--edges-cross": region(*beside(CORNER, lone((1, -1, -1), (1, 1, 1), (1, 1, -9), (2, -2, -9)))),
    "boundary-meets--edge-on-an-edge": region(*beside(CORNER, lone((1, 0, 0), (2, 0, 0), (1, -1, -1), (2, -1, -2)))),
    "boundary-meets--edge-in-a-facet": region(*beside(CORNER, lone((1, 1, 0), (2, 1, 0), (1, 1, -1), (2, 2, -2)))),
    "boundary-meets--vertex-pierces": region(*beside(CORNER, lone((1, 1, 1), (1, 2, -1), (2, 1, -1), (1, 1, -2)))),
    "boundary-meets--edge-passes-through": region(*beside(CORNER, lone((1, 1, -9), (1, 1, 9), (11, 11, 9), (11, 12, 9)))),
    "boundary-meets--facet-in-a-facet": region(*beside(CORNER, lone((1, 1, 0), (2, 1, 0), (1, 2, 0), (1, 1, -2)))),
    "boundary-meets--facets-overlap": region(*beside(CORNER, lone((1, 1, 0), (5, 1, 0), (1, 5, 0), (1, 1, -2)))),
    "boundary-meets--star-of-david": region(*beside(lone((0, 4, 0), (-3, -2, 0), (3, -2, 0), (0, 0, 5)),
                                                    lone((0, -4, 0), (-3, 2, 0), (3, 2, 0), (0, 0, -5)))),
    "boundary-meets--same-facet-with-other-vertices": region(*beside(CORNER, lone((0, 0, 0), (4, 0, 0), (0, 4, 0), (0, 0, -4)))),
    "boundary-meets--same-place": region(*beside(CORNER, CORNER)),
    "boundary-meets--common-vertex-and-through-a-facet":
        region([*CORNER[0], (1, 1, 1), (9, 9, -8), (9, 10, -8)], [[0, 1, 2, 3], [3, 4, 5, 6]]),
    "boundary-meets--common-vertex-and-crossing-in-a-plane":
        region([*CORNER[0], (1, 2, 0), (5, 1, 0), (2, 2, -3)], [[0, 1, 2, 3], [0, 4, 5, 6]]),
    "boundary-meets--common-vertex-and-along-an-edge":
        region([*CORNER[0], (2, 0, 0), (1, -1, -1), (1, -1, -2)], [[0, 1, 2, 3], [0, 4, 5, 6]]),
    "boundary-meets--common-vertex-and-a-vertex-on-the-opposite-edge":
        region([*CORNER[0], (2, 2, 0), (2, 1, -3), (3, 1, -5)], [[0, 1, 2, 3], [0, 4, 5, 6]]),
    "boundary-meets--common-edge-and-folded":
        region([*CORNER[0], (1, 1, 0), (1, 1, -3)], [[0, 1, 2, 3], [0, 1, 4, 5]]),
    "boundary-meets--common-edge-and-folded-beyond":
        region([*CORNER[0], (9, 1, 0), (1, 1, -3)], [[0, 1, 2, 3], [0, 1, 4, 5]]),
    "boundary-meets--fold": FOLD,
    "boundary-meets--pair-of-mates-parted": opened(MESH),
    "boundary-meets--in-a-cavity-touching-its-wall": in_the_cavity((1, F(3, 2), F(4, 3)), (F(3, 2),) * 3, (F(3, 2), F(5, 4), F(4, 3)), (F(4, 3), F(3, 2), F(5, 4))),
    "boundary-meets--slightly": region(*beside(CORNER, lone((1, 1, F(1, 10**30)), (1, 2, -1), (2, 1, -1), (1, 1, -2)))),
    "boundary-meets--over-sqrt-3": region(
        [(0, 0, 0), (1, 0, 0), (0, ["0", "1"], 0), (0, 0, 1), (0, ["0", "1/2"], 0), (-1, 0, 0), (-1, ["0", "1"], 0), (-1, 1, 1)],
        [[0, 1, 2, 3], [4, 5, 6, 7]], field=SQRT3, a=math.sqrt(3)),
    "covering--tetrahedron-inside": region(*beside(CORNER, small(F(1, 2), F(1, 2), F(1, 2)))),
    "covering--tetrahedron-inside-of-a-mesh": region(*beside(cells(*THREE), small(F(5, 4), F(7, 6), F(9, 7)))),
    "covering--cube-inside-of-a-mesh": region(*beside(cells(*THREE), ([[x + F(1, 2) for x in v] for v in cells((0, 0, 0))[0]], cells((0, 0, 0))[1]))),
    "covering--inside-with-a-common-vertex": region([*CORNER[0], (1, F(1, 2), F(1, 3)), (F(1, 2), 1, F(1, 3)), (F(1, 3), F(1, 2), 1)],
                                                    [[0, 1, 2, 3], [0, 4, 5, 6]]),
    "covering--inside-with-a-common-edge": region([*CORNER[0], (1, F(1, 2), F(1, 3)), (1, F(1, 3), F(1, 2))],
                                                  [[0, 1, 2, 3], [0, 1, 4, 5]]),
    "covering--inside-of-a-piece-in-a-cavity":
        region(*beside(CAVITY, small(F(5, 4), F(5, 4), F(5, 4)), small(F(21, 16), F(21, 16), F(21, 16), F(1, 100)))),
    "covering--in-the-wall-of-a-cavity": region(*beside(CAVITY, small(F(1, 4), F(5, 4), F(5, 4), F(1, 9)))),
    "covering--three-deep": region(*beside(CORNER, small(F(1, 2), F(1, 2), F(1, 2), 1), small(F(5, 8), F(5, 8), F(5, 8)))),
    "covering--over-sqrt-3": region(*beside(([(0, 0, 0), (9, 0, 0), (0, ["0", "9"], 0), (0, 0, 9)], [[0, 1, 2, 3]]),
                                            ([(1, 1, 1), (2, 1, 1), (1, ["0", "1"], 1), (1, 1, 2)], [[0, 1, 2, 3]])),
                                    field=SQRT3, a=math.sqrt(3)),
    "mate-not-mutual--nothing-behind-from-one-side": edit(MESH, (*MATES, 0, 1), []),
    "mate-side--region-folded": edit(edit(FOLD, (*MATES, 0, 3), [1, 3]), (*MATES, 1, 3), [0, 3]),
    "orientation--region": swapped(MESH, 3),
    "not-acute--region": with_statements(MESH, "acute"),
    "angle-not-below--region": with_statements(MESH, below("90")),
    "face-not-facet--dart": solid(CUBE_2, polygon([[0, 0], [4, 0], [1, 1], [0, 4]]),
                                  [[0, 0], [4, 0], [1, 1], [0, 4]], [[0, 1, 2], [0, 2, 3]]),
    "face-not-facet--polygon-in-star-order":
        in_domain(PRISM, "prism", polytope(SQUARE["vertices"], [[0, 2], [2, 1], [1, 3], [3, 0]])),
    "face-not-facet--vertex-on-a-side": in_domain(block(2, 2), "solid", polytope(
        [[0, 0], [1, 0], [1, 1], [0, 1], [1, "1/2"]], [[0, 1], [1, 4], [4, 2], [2, 3], [3, 0]])),
    "face-not-facet--far-point-with-flat-faces": far_point_with_flat_faces(),
    "face-not-facet--not-planar": in_domain(SOLID, "solid", polytope(MOVED_CORNER, CUBE_FACES)),
    "face-not-facet--flat-solid": in_domain(SOLID, "solid", polytope(
        [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], [[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]])),
    "face-not-facet--flat-solid-and-one-face-with-all": in_domain(SOLID, "solid", polytope(
        [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], [[0, 1, 2, 3], [0, 1, 3], [0, 2, 3], [1, 2, 3]])),
    "face-not-facet--slab-without-height": in_domain(SLAB, "slab", polytope([[0], [0]], [[0], [1]])),
    "face-not-facet--third-plane-of-a-slab":
        in_domain(SLAB, "slab", polytope([[0], [1], ["1/2"]], [[0], [1], [2]])),
    "face-not-facet--inner-wall": in_domain(SOLID, "solid", {**CUBE_SOLID, "faces": CUBE_FACES + [[0, 1, 7, 6]]}),
    "face-not-facet--quadrilateral-as-two-triangles":
        in_domain(SOLID, "solid", {**CUBE_SOLID, "faces": CUBE_FACES[1:] + [[0, 1, 3], [0, 3, 2]]}),
    "face-not-convex--bow-tie": in_domain(SOLID, "solid", {**CUBE_SOLID, "faces": [[0, 1, 2, 3]] + CUBE_FACES[1:]}),
    "face-not-convex--star": star(),
    "face-not-convex--vertex-on-an-edge": cube_with_a_vertex_on_an_edge(),
    "faces-not-closed--cube-without-one": in_domain(SOLID, "solid", {**CUBE_SOLID, "faces": CUBE_FACES[:5]}),
    "faces-not-closed--cube-without-the-first": in_domain(SOLID, "solid", {**CUBE_SOLID, "faces": CUBE_FACES[1:]}),
    "faces-not-closed--two-opposite-missing": in_domain(SOLID, "solid", {**CUBE_SOLID, "faces": CUBE_FACES[2:]}),
    "faces-not-closed--side-missing": in_domain(PRISM, "prism", {**SQUARE, "faces": SQUARE["faces"][:3]}),
    "vertex-outside--equal-area-beyond-a-side": other_side_of_a_face(),
    "vertex-outside--solid-moved": solid_moved(1),
    "vertex-outside--slightly": edit(SOLID, (*VERTICES, 7, 2), "1000001/1000000"),
    "vertex-outside--slab-too-low": in_domain(SLAB, "slab", polytope([[0], ["1/2"]], [[0], [1]])),
    "vertex-outside--strip-over-sqrt-3":
        edit(VALID["strip-of-height-sqrt-3"], (*VERTICES, 1, 1), ["1/1000000", "1"]),
    "boundary-facet--faces-exchanged": exchanged(SLAB),
    "boundary-facet--slab-too-high": in_domain(SLAB, "slab", polytope([[0], [2]], [[0], [1]])),
    "boundary-facet--inner-facets": cut(SOLID),
    "boundary-facet--inner-facets-of-a-prism": cut(PRISM, 3),
    "boundary-facet--hole": hole_as_boundary(SOLID, 3),
    "boundary-facet--half-of-a-square-twice": copies(block(2, 2), 0, 0),
    "boundary-facet--one-tetrahedron-of-a-cube-six-times": copies(SOLID, 0, 0, 0, 0, 0, 0),
    "mate-not-mutual--boundary-from-one-side": one_cut(SOLID),
    "volume-sum--solid-twice": twice(SOLID),
    "volume-sum--slab-twice": twice(SLAB),
    "volume-sum--tetrahedron-twice": twice(VALID["solid-tetrahedron"]),
    "volume-sum--strip-over-sqrt-3-twice": twice(VALID["strip-of-height-sqrt-3"]),
    "angle-not-above--60-exactly-60": lattice(HEXAGONAL, above("60")),
    "angle-not-above--just-above-60": lattice(HEXAGONAL, above("60000001/1000000")),
    "angle-not-above--cube-6": with_statements(C6, above("4501/100")),
    "angle-not-above--120": with_statements(VALID["plane-obtuse"], above("120")),
    "angle-not-above--a15": with_statements(A, above("60")),
    "ratio-not-below--exactly": lattice([["9", "0"], ["0", "16"]], ratio("5/6")),
    "ratio-not-below--3-5": lattice([["9", "0"], ["0", "16"]], ratio("3/5")),
    "ratio-not-below--equilateral": lattice(HEXAGONAL, ratio("11547/20000")),
    "ratio-not-below--tetrahedron": with_statements(VALID["solid-tetrahedron"], ratio("153/250")),
    "ratio-not-below--over-sqrt-3": with_statements(K, ratio("7/10")),
    "edge-valence--bcc": with_statements(VALID["space-bcc"], "TCP"),
    "edge-valence--chambers-of-the-cube": with_statements(VALID["space-chambers-of-the-cube"], "TCP"),
    "edge-valence--a15-with-one-tetrahedron-cut": a15_split("TCP"),
    "triangle-valence--z-with-an-edge-contracted": with_statements(VALID["space-z-contracted"], "TCP"),
    "gram-not-positive--indefinite": lattice([["1", "2"], ["2", "1"]]),
    "gram-not-positive--semidefinite": lattice([["1", "1"], ["1", "1"]]),
    "gram-not-positive--zero": lattice([["0", "0"], ["0", "0"]]),
    "gram-not-positive--negative": lattice([["-1", "0"], ["0", "-1"]]),
    "gram-not-positive--third-minor": kuhn([["1", "0", "0"], ["0", "1", "1"], ["0", "1", "1"]]),
    "gram-not-positive--semidefinite-over-sqrt-3":
        edit(K, GRAM, [["1", ["0", "1"]], [["0", "1"], "3"]]),
    "root-signs--no-root-and-none-needed": edit(BARE, FIELD, algebraic(["-3", "0", "1"], "2", "3")),
    "root-signs--no-root": root(["-3", "0", "1"], "2", "3"),
    "root-signs--two-roots": root(["-3", "0", "1"], "-2", "2"),
    "root-signs--double-root": root(["1", "-2", "1"], "0", "2"),
    "root-signs--root-at-an-end": root(["-4", "0", "1"], "1", "2"),
    "orientation--one-negative": swapped(E, 1),
    "orientation--all-negative": mirrored(),
    "orientation--flat": edit(E, (*SIMPLICES, 0, 2), [0, 2, 0]),
    "orientation--repeated-corner": edit(E, (*SIMPLICES, 0, 2), [0, 1, 0]),
    "orientation--folded-over": folded_over(),
    "orientation--tetrahedron": swapped(C6, 3),
    "orientation--over-sqrt-3": swapped(K, 3),
    "mate-not-mutual--one-changed": one_sided_mate(),
    "mate-not-mutual--shift": edit(E, (*MATES, 0, 0, 2), E["witness"]["mates"][0][0][2] + 1),
    "mate-not-mutual--one-missing": without_last(C6, lambda s, i: [0, 0, 0, 0, 0]),
    "mate-not-mutual--one-doubled": doubled(C6),
    "mate-corners--one-missing-rest-paired": lone_pair(C6),
    "mate-corners--mates-permuted": permuted_mates(),
    "mate-corners--shift": wrong_shift(),
    "mate-side--own-mate": own_mate(),
    "mate-side--one-missing-boundary-its-own-mate": without_last(C6, lambda s, i: [s, i, 0, 0, 0]),
    "mate-side--folded": folded(),
    "mate-side--two-copies": doubled_pair(C6),
    "volume-sum--overlaid": overlaid(),
    "volume-sum--connected-double-cover": double_cover(),
    "volume-sum--overlaid-and-acute": overlaid("acute"),
    "not-acute--cube-6": with_statements(C6, "acute"),
    "not-acute--bcc-right-angles": with_statements(VALID["space-bcc"], "acute"),
    "not-acute--right-angles-over-sqrt-3": with_statements(K, "acute"),
    "not-acute--square": lattice([["1", "0"], ["0", "1"]], "acute"),
    "not-acute--obtuse": lattice([["4", "-3"], ["-3", "4"]], "acute"),
    "not-nonobtuse--obtuse": lattice([["4", "-3"], ["-3", "4"]], "nonobtuse"),
    "not-nonobtuse--hardly": lattice([["1000000", "-1"], ["-1", "1000000"]], "nonobtuse"),
    "angle-not-below--60-exactly-60": lattice(HEXAGONAL, below("60")),
    "angle-not-below--60-over-sqrt-3": lattice([[["0", "2"], ["0", "1"]], [["0", "1"], ["0", "2"]]],
                                               below("60"), field=SQRT3),
    "angle-not-below--90-exactly-90": with_statements(C6, below("90")),
    "angle-not-below--90-over-sqrt-3": with_statements(K, below("90")),
    "angle-not-below--120-exactly-120": lattice([["2", "-1"], ["-1", "2"]], below("120")),
    "angle-not-below--just-below-60": lattice(HEXAGONAL, below("59999999/1000000")),
    "angle-not-below--obtuse": lattice([["4", "-3"], ["-3", "4"]], below("138")),
    "angle-not-below--a15": with_statements(A, below("3923/50")),
    "angle-not-below--tiny": with_statements(E, below("1/1000")),
    "not-delaunay--square-cospherical": lattice([["1", "0"], ["0", "1"]], "Delaunay"),
    "not-delaunay--square-cospherical-over-sqrt-3": with_statements(K, "Delaunay"),
    "not-delaunay--cube-cospherical": with_statements(C6, "Delaunay"),
    "not-delaunay--wrong-diagonal": lattice([["2", "-1"], ["-1", "2"]], "Delaunay"),
    "not-weakly-delaunay--wrong-diagonal": lattice([["2", "-1"], ["-1", "2"]], "weakly Delaunay"),
    "not-weakly-delaunay--sheared-cube":
        kuhn([["1", "0", "1/2"], ["0", "1", "0"], ["1/2", "0", "1"]], "weakly Delaunay"),
}

# a^2 - 2 = 0 and (2 - a^2) - 1 = -1, but not as vectors.
ZERO, MINUS_ONE = ["-2", "0", "1"], ["1", "0", "-1"]
LONG = "1" + "0" * 1000


def reducible(gram, *statements):
    return lattice(gram, *statements, field=REDUCIBLE, a=math.sqrt(2))


def reducible_strip(ends):
    """The strip of height 1, its ends written with a^2 = 2, which is not seen in the coefficients."""
    domain = {"slab": {"vertices": ends, "faces": [[0], [1]]}}
    return edit(edit(STRIP, FIELD, REDUCIBLE), DOMAIN, domain)


def primes():
    """Denominators with a common multiple of more than 1000 digits, each of few."""
    found = [p for p in range(2, 3000) if all(p % q for q in range(2, int(p ** 0.5) + 1))]
    n = len(found)
    simplices, vertices = [], []
    for k in range(n):
        vertices.append([f"{1}/{found[k]}", "0"])
        simplices += [[[k] + p[1:] for p in corners] for corners in LATTICE_TRIANGLES]
    return certificate(HEXAGONAL, vertices, simplices)


def long_ends():
    """A root of x^31 - 2, whose ends have denominators of 490 digits: 512 halvings cost about 1.4 · 10^9."""
    q = 10 ** 490 + 7
    low, high = (F(x * q // 1000, q) for x in (1021, 1024))
    assert low ** 31 < 2 < high ** 31
    return edit(BARE, FIELD, algebraic(["-2"] + ["0"] * 30 + ["1"], str(low), str(high)))


DECLINED = {
    "too-many-bytes--limit-bytes-100": E,
    "version--2": edit(E, ("version",), 2),
    "version--0": edit(E, ("version",), 0),
    "version--2-and-another-shape": b'{"version":2,"format":"acutile-certificate","tiles":[{"x":0.5}]}\n',
    "too-many-simplices--limit-simplices-1": E,
    "too-many-digits--numerator": number(LONG),
    "too-many-digits--denominator": number("1/" + LONG),
    "too-many-digits--both-together": number("1" * 500 + "/" + "1" + "0" * 500),
    "too-many-digits--angle": edit(E, STATEMENTS, [TILING, below("1/" + LONG)]),
    "too-many-digits--polynomial": root(["-" + LONG, "0", "1"], "1", "2"),
    "too-many-digits--root": root(["-3", "0", "1"], "1/" + LONG, "2"),
    "too-many-digits--giant": number("7" * 20_000),
    "degree": root(["-3"] + ["0"] * 32 + ["1"], "1", "2"),
    "common-denominator--primes": primes(),
    "work--limit-work-1": E,
    "work--large-numbers-in-a-large-field": root(["-" + "9" * 900] + ["1"] * 31 + ["1"], "0", "1" + "0" * 300),
    "work--root-with-long-ends--limit-work-1000000": long_ends(),
    "work--ratio-with-many-digits--limit-work-2": with_statements(BARE, ratio("1" + "0" * 40)),
    "sign-undecided--gram-zero": reducible([[ZERO, "0"], ["0", "1"]]),
    "sign-undecided--gram-zero-negated": reducible([[["2", "0", "-1"], "0"], ["0", "1"]]),
    "sign-undecided--right-angle-claimed-acute": reducible([["1", ZERO], [ZERO, "1"]], "acute"),
    "sign-undecided--right-angle-claimed-nonobtuse": reducible([["1", ZERO], [ZERO, "1"]], "nonobtuse"),
    "sign-undecided--square-claimed-delaunay": reducible([["1", ZERO], [ZERO, "1"]], "Delaunay"),
    "sign-undecided--square-claimed-weakly-delaunay":
        reducible([["1", ZERO], [ZERO, "1"]], "weakly Delaunay"),
    "sign-undecided--exactly-90-claimed-below-90": reducible([["1", ZERO], [ZERO, "1"]], below("90")),
    "sign-undecided--exactly-120-claimed-below-120":
        reducible([["2", MINUS_ONE], [MINUS_ONE, "2"]], below("120")),
    "sign-undecided--flat":
        edit(edit(reducible(HEXAGONAL), VERTICES, [["0", "0"], ["0", ZERO]]),
             (*SIMPLICES, 0), [[0, 0, 0], [0, 1, 0], [1, 0, 0]]),
    "sign-undecided--vertex-in-the-boundary": reducible_strip([["0"], [["-1", "0", "1"]]]),
    "sign-undecided--slab-without-height": reducible_strip([["0"], [ZERO]]),
    "angle-undecided--45-claimed-above-45": with_statements(C6, above("45")),
    "work--domain--limit-work-200": SOLID,
    "work--close-pairs-of-facets--limit-work-6": MESH,
    "work--one-tetrahedron-many-times--limit-work-150": region(*beside(*[CORNER] * 150)),
    "work--many-pieces-apart--limit-work-1300": region(*beside(*(small(x, 0, 0) for x in range(200)))),
    "sign-undecided--region":
        region([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, ZERO)], [[0, 1, 2, 3], [1, 2, 3, 4]],
               field=REDUCIBLE, a=math.sqrt(2)),
    "sign-undecided--rational-root-hit":
        lattice([[["-2", "1"], "0"], ["0", "1"]], field=TWO, a=2),
    "sign-undecided--no-bisections--limit-bisections-0": K,
    "angle-undecided": lattice([["8", "1"], ["1", "8"]], below(
        # arccos(1/8) in degrees, to 60 decimals, computed below.
        "ANGLE")),
}


def arccos_degrees(c, digits=60):
    """arccos c in degrees as a decimal fraction, by bisection of cos in integers."""
    from decimal import Decimal, getcontext
    getcontext().prec = digits + 20

    def cosine(x):
        term, total, k = Decimal(1), Decimal(1), 0
        while abs(term) > Decimal(10) ** -(digits + 15):
            k += 2
            term = -term * x * x / (k * (k - 1))
            total += term
        return total

    low, high = Decimal(0), Decimal("3.2")
    for _ in range(260):
        middle = (low + high) / 2
        low, high = (middle, high) if cosine(middle) > c else (low, middle)
    x, pi_low, pi_high = low, Decimal(3), Decimal("3.2")
    for _ in range(260):
        middle = (pi_low + pi_high) / 2
        pi_low, pi_high = (middle, pi_high) if cosine(middle / 2) > 0 else (pi_low, middle)
    return F(int(x * 180 / pi_low * 10 ** digits), 10 ** digits)


# The triangles have the angles arccos(1/8) at the origin and less elsewhere.
DECLINED["angle-undecided"]["claim"]["statements"][1] = below(str(arccos_degrees(F(1, 8))))
assert DECLINED["angle-undecided"]["claim"]["gram"] == [["8", "1"], ["1", "8"]]


def write(folder, files):
    path = os.path.join(HERE, folder)
    os.makedirs(path, exist_ok=True)
    for name in os.listdir(path):
        os.remove(os.path.join(path, name))
    for name, content in files.items():
        with open(os.path.join(path, name + ".json"), "wb") as file:
            file.write(content if isinstance(content, bytes) else to_bytes(content))


if __name__ == "__main__":
    for folder, files in (("valid", VALID), ("malformed", MALFORMED), ("false", FALSE), ("declined", DECLINED)):
        write(folder, files)
