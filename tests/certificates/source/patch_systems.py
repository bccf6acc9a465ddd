"""Systems of patches: small ones, and the one over squares and triangles, from a list of its tetrahedra."""
from fractions import Fraction as F
from itertools import permutations, product
from math import lcm

FIELD = {"polynomial": [-3, 0, 1], "root": {"low": 1, "high": 2, "denominator": 1}}


class Surd:
    """a + b √3."""

    def __init__(self, a, b=0):
        self.a, self.b = F(a), F(b)

    def __add__(self, other):
        return Surd(self.a + other.a, self.b + other.b)

    def __sub__(self, other):
        return Surd(self.a - other.a, self.b - other.b)

    def __mul__(self, other):
        return Surd(self.a * other.a + 3 * self.b * other.b, self.a * other.b + self.b * other.a)

    def is_positive(self):
        """Compares the squares of a and b √3 where their signs differ."""
        if self.a >= 0 and self.b >= 0:
            return (self.a, self.b) != (0, 0)
        if self.a <= 0 and self.b <= 0:
            return False
        return (self.a ** 2 > 3 * self.b ** 2) == (self.a > 0)


def surd(x):
    return x if isinstance(x, Surd) else Surd(x)


def determinant(rows):
    (a, b, c), (d, e, f), (g, h, i) = rows
    return a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)


class System:
    """Tiles, with vertices by name; corners are a name and a shift. Lattice coordinates come first."""

    def __init__(self, rank, gram, surds=False):
        self.rank, self.surds, self.tiles, self.patches = rank, surds, [], []
        self.gram = [[self.number(Surd(x)) for x in row] for row in gram]

    def number(self, x, denominator=1):
        a, b = x.a * denominator, x.b * denominator
        assert a.denominator == b.denominator == 1
        return [int(a), int(b)] if self.surds else int(a)

    def numbers(self, rows):
        rows = [list(map(surd, row)) for row in rows]
        denominator = lcm(*(c.denominator for row in rows for x in row for c in (x.a, x.b)))
        return denominator, [[self.number(x, denominator) for x in row] for row in rows]

    def add(self, corners, points, rows, pyramids, offsets=None, classes=None):
        names = list(points)
        place = [list(map(surd, points[name])) for name in names]

        def corner(key):
            return (names.index(key[0]), *key[1:])

        def written(key):
            return list(key) if any(key[1:]) else key[0]

        def moved(key, base):
            return (key[0], *(x - y for x, y in zip(key[1:], base[1:])))

        def is_positive(keys):
            at = [[x + Surd(s) for x, s in zip(place[v], [*shift, 0, 0])] for v, *shift in keys]
            return determinant([[x - y for x, y in zip(p, at[0])] for p in at[1:]]).is_positive()

        def row(keys):
            keys = sorted(map(corner, keys))
            keys = [moved(key, keys[0]) for key in keys]
            return list(map(written, keys if is_positive(keys) else [keys[0], keys[1], keys[3], keys[2]]))

        def pyramid(apex, polygon):
            apex, polygon = corner(apex), list(map(corner, polygon))
            if not is_positive([*polygon[:3], apex]):
                polygon = polygon[:1] + polygon[:0:-1]
            apex, *polygon = [written(moved(key, polygon[0])) for key in [apex, *polygon]]
            return [apex, polygon]

        denominator, vertices = self.numbers(points.values())
        offsets = offsets or [[0] * self.rank for _ in corners]
        offsets = [[self.number(Surd(x), denominator) for x in offset] for offset in offsets]
        self.patches.append({
            "denominator": denominator, "offsets": offsets, "vertices": vertices,
            "pyramids": [pyramid(*p) for p in pyramids], "simplices": [row(keys) for keys in rows]})
        denominator, vertices = self.numbers(corners)
        self.tiles.append({"denominator": denominator, "vertices": vertices, "classes": classes or [0] * len(corners)})
        return self

    def certificate(self, *statements):
        claim = {"field": FIELD if self.surds else "Q", "gram": self.gram, "rank": self.rank, "tiles": self.tiles,
                 "statements": ["face-to-face tiling", *statements]}
        return {"format": "acutile-certificate", "version": 2, "kind": "patches", "claim": claim,
                "witness": self.patches}


UNIT = [[1, 0, 0], [1, 0], [1]]
SQUARE = [(0, 0), (1, 0), (1, 1), (0, 1)]


def bcc(periods=1, offsets=None, classes=None, corners=SQUARE):
    """Cubes with their centres: pyramids over the sides, four tetrahedra around each vertical axis between centres."""
    points, rows, pyramids, count = {}, [], [], len(corners)
    for n in range(periods):
        for i, corner in enumerate(corners):
            points[f"V{i}{n}"] = (F(n, periods), *corner)
        points[f"C{n}"] = (F(2 * n + 1, 2 * periods), *(F(sum(column), count) for column in zip(*corners)))

    def at(name, n):
        return (f"{name}{n % periods}", n // periods)

    for n in range(periods):
        for i in range(count):
            j = (i + 1) % count
            rows.append([at("C", n), at("C", n + 1), at(f"V{i}", n + 1), at(f"V{j}", n + 1)])
            pyramids.append((at("C", n), [at(f"V{i}", n), at(f"V{j}", n), at(f"V{j}", n + 1), at(f"V{i}", n + 1)]))
    return System(1, [[periods ** 2, 0, 0], [1, 0], [1]]).add(corners, points, rows, pyramids, offsets, classes)


def cubes(order="C H F0 F1 F2 F3 V0 V1 V2 V3"):
    """Cubes in 24: the centre, the centre of a face, an edge of this face; with the vertices in an order."""
    points = {"C": (F(1, 2), F(1, 2), F(1, 2)), "H": (0, F(1, 2), F(1, 2))}
    for i, (x, y) in enumerate(SQUARE):
        p, q = SQUARE[(i + 1) % 4]
        points[f"V{i}"] = (0, x, y)
        points[f"F{i}"] = (F(1, 2), F(x + p, 2), F(y + q, 2))
    rows = []
    for i in range(4):
        j = (i + 1) % 4
        around = [(f"V{i}", 0), (f"V{j}", 0), (f"V{j}", 1), (f"V{i}", 1)]
        rows += [[("C", 0), (f"F{i}", 0), one, other] for one, other in zip(around, around[1:] + around[:1])]
        rows += [[("C", 0), ("H", h), (f"V{i}", h), (f"V{j}", h)] for h in (0, 1)]
    return System(1, UNIT).add(SQUARE, {name: points[name] for name in order.split()}, rows, [])


def kuhn_prism(classes=None):
    """The cube in six around a diagonal."""
    points = {f"V{i}": (0, *corner) for i, corner in enumerate(SQUARE)}
    rows = []
    for order in permutations(range(3)):
        at, row = [0, 0, 0], [("V0", 0)]
        for axis in order:
            at[axis] = 1
            row.append((f"V{SQUARE.index((at[1], at[2]))}", at[0]))
        rows.append(row)
    return System(1, UNIT).add(SQUARE, points, rows, [], None, classes)


def kuhn_slab(layers, are_pyramids):
    """Layers of cubes in six; the triangles in the two planes can be bases of pyramids."""
    points = {f"V{n}": (0, 0, n) for n in range(layers + 1)}
    rows, pyramids = [], []
    for n, order in product(range(layers), permutations(range(3))):
        at, row = [0, 0, n], [(f"V{n}", 0, 0)]
        for axis in order:
            at[axis] += 1
            row.append((f"V{at[2]}", at[0], at[1]))
        flat = [[key for key in row if key[0] == f"V{h}"] for h in (0, layers)]
        base = next((keys for keys in flat if len(keys) == 3), None)
        if base and are_pyramids:
            pyramids.append((next(key for key in row if key not in base), base))
        else:
            rows.append(row)
    return System(2, UNIT).add([(0,), (layers,)], points, rows, pyramids)


TRIANGLE_ROWS = """
C.1 E0.3 E1.3 E2.3; C.1 E0.3 E1.3 V1.2; C.1 E0.3 E2.3 V0.2; C.1 E1.3 E2.3 V2.2;
C.5 E0.3 E1.3 E2.3; C.5 E0.3 E1.3 V1.4; C.5 E0.3 E2.3 V0.4; C.5 E1.3 E2.3 V2.4;
E0.3 E1.3 V1.2 V1.4; E0.3 E2.3 V0.2 V0.4; E1.3 E2.3 V2.2 V2.4;
"""

SQUARE_ROWS = """
E0.3 S0.1 S1.3 S3.3; E0.3 S0.1 S1.3 V1.2; E0.3 S0.1 S3.3 V0.2; E0.3 S0.5 S1.3 S3.3;
E0.3 S0.5 S1.3 V1.4; E0.3 S0.5 S3.3 V0.4; E0.3 S1.3 V1.2 V1.4; E0.3 S3.3 V0.2 V0.4;
E1.1 S0.1 S1.3 S2.1; E1.1 S0.1 S1.3 V1.2; E1.1 S0.1 V1.0 V1.2; E1.1 S1.3 S2.1 V2.2;
E1.1 S2.1 V2.0 V2.2; E1.5 S0.5 S1.3 S2.5; E1.5 S0.5 S1.3 V1.4; E1.5 S1.3 S2.5 V2.4;
E2.3 S1.3 S2.1 S3.3; E2.3 S1.3 S2.1 V2.2; E2.3 S1.3 S2.5 S3.3; E2.3 S1.3 S2.5 V2.4;
E2.3 S1.3 V2.2 V2.4; E2.3 S2.1 S3.3 V3.2; E2.3 S2.5 S3.3 V3.4; E2.3 S3.3 V3.2 V3.4;
E3.1 S0.1 S2.1 S3.3; E3.1 S0.1 S3.3 V0.2; E3.1 S0.1 V0.0 V0.2; E3.1 S2.1 S3.3 V3.2;
E3.1 S2.1 V3.0 V3.2; E3.5 S0.5 S2.5 S3.3; E3.5 S0.5 S3.3 V0.4; E3.5 S2.5 S3.3 V3.4;
S0.1 S1.3 S2.1 S3.3; S0.5 S1.3 S2.5 S3.3;
"""


def rows_of(text):
    """C is the triangle's centre; V a corner, E the middle of a side, S one unit inside of it; then quarters of a period."""
    for row in text.split(";"):
        corners = [corner.split(".") for corner in row.split()]
        if corners:
            yield [(f"{name}.{int(h) % 4}", int(h) // 4) for name, h in corners]


def polygon(system, corners, inner, rows):
    """Side 1, period 1. All that belongs to a side of a square with an odd number is half a period higher."""
    count = len(corners)
    half, points, pyramids = Surd(F(1, 2)), {}, []
    lifts = [2 * (i % 2) if count == 4 else 0 for i in range(count)]

    def key(name, quarters):
        return (f"{name}.{quarters % 4}", quarters // 4)

    for i, lift in enumerate(lifts):
        j = (i + 1) % count
        for name, quarters, place in [
                (f"V{i}", 0, corners[i]), (f"V{i}", 2, corners[i]), (inner[i][0], 1 + lift, inner[i][1]),
                (f"E{i}", 3 + lift, [(x + y) * half for x, y in zip(corners[i], corners[j])])]:
            points[key(name, quarters)[0]] = (F(quarters % 4, 4), *place)
        hexagon = [(f"V{i}", 0), (f"V{i}", 2), (f"E{i}", 3), (f"V{j}", 2), (f"V{j}", 0), (f"E{i}", -1)]
        pyramids.append((key(inner[i][0], 1 + lift), [key(name, quarters + lift) for name, quarters in hexagon]))
    system.add(corners, points, rows_of(rows), pyramids, [[F(lift, 4)] for lift in lifts])


def square_triangle():
    zero, quarter, half, rest, one = (Surd(F(n, 4)) for n in range(5))
    triangle = [(zero, zero), (one, zero), (half, Surd(0, F(1, 2)))]
    square = [(zero, zero), (one, zero), (one, one), (zero, one)]
    system = System(1, UNIT, surds=True)
    polygon(system, triangle, [("C", (half, Surd(0, F(1, 6))))] * 3, TRIANGLE_ROWS)
    inner = [("S0", (half, quarter)), ("S1", (rest, half)), ("S2", (half, rest)), ("S3", (quarter, half))]
    polygon(system, square, inner, SQUARE_ROWS)
    return system


EXACT = ["largest dihedral angle", "maximum", 1, [[1, 0], 25]]
RIGHT = ["largest dihedral angle", "maximum", 0, [0, 1]]
ALL = square_triangle().certificate("acute", EXACT, "Delaunay", "TCP")
# Sommerville's tetrahedra: right angles, and bcc has one Delaunay triangulation.
BCC = bcc().certificate("nonobtuse", RIGHT, "Delaunay")

PATCHES_VALID = {
    "patches-square-triangle": ALL,
    "patches-bcc": BCC,
    "patches-bcc-of-two-periods": bcc(2, [[0], [F(1, 2)], [0], [F(1, 2)]]).certificate("nonobtuse", RIGHT, "Delaunay"),
    "patches-cubes": cubes().certificate("nonobtuse", RIGHT),
    # All corners of a cube lie on its sphere.
    "patches-kuhn-slab": kuhn_slab(1, False).certificate("nonobtuse", RIGHT, "weakly Delaunay"),
    # Each side can meet itself only.
    "patches-bcc-of-four-classes": bcc(1, None, [0, 1, 2, 3]).certificate("nonobtuse", RIGHT, "Delaunay"),
    "patches-kuhn-slab-of-two-layers": kuhn_slab(2, False).certificate(),
}


def edited(certificate, *changes):
    """A copy with values replaced by path; a function gets the old value."""
    def copy(value):
        if isinstance(value, dict):
            return {name: copy(item) for name, item in value.items()}
        return [copy(item) for item in value] if isinstance(value, list) else value

    certificate = copy(certificate)
    for path, value in changes:
        item = certificate
        for step in path[:-1]:
            item = item[step]
        item[path[-1]] = value(item[path[-1]]) if callable(value) else value
    return certificate


def claim(*path):
    return ("claim", *path)


def witness(*path):
    return ("witness", *path)


FAR = 400_000_000
PATCHES_MALFORMED = {
    "rank--patches-3": edited(BCC, (claim("rank"), 3)),
    "tile-count--patches-none": edited(BCC, (claim("tiles"), []), (("witness",), [])),
    "tile-count--patches-without-a-patch": edited(ALL, (("witness",), lambda patches: patches[:1])),
    "side-count--patches-two-corners": edited(
        BCC, (claim("tiles", 0, "vertices"), lambda v: v[:2]), (claim("tiles", 0, "classes"), [0, 0])),
    "side-count--patches-three-ends": edited(
        PATCHES_VALID["patches-kuhn-slab"], (claim("tiles", 0, "vertices"), [[0], [1], [2]]),
        (claim("tiles", 0, "classes"), [0, 0, 0])),
    "denominator--patches-tile": edited(BCC, (claim("tiles", 0, "denominator"), 0)),
    "pyramid--two-corners": edited(BCC, (witness(0, "pyramids", 0, 1), lambda polygon: polygon[:2])),
    "pyramid--patches-corner-twice": edited(BCC, (witness(0, "pyramids", 0, 1), lambda p: p[:2] + p[1:2] + p[2:])),
    "pyramid--patches-first-corner-moved": edited(BCC, (witness(0, "pyramids", 0, 1, 0), [0, 1])),
    "no-simplices--patches": edited(BCC, (witness(0, "simplices"), [])),
    "shift-range--patches-fan": edited(
        BCC, (witness(0, "pyramids", 0), [[4, FAR], [3, [1, -FAR], 2]])),
    "statement-domain--patches-bcc-locally": edited(BCC, (claim("statements", 3), "locally Delaunay")),
    "unused-vertex--patches": edited(BCC, (witness(0, "vertices"), lambda v: v + [[0, 1, 1]])),
}

KUHN_SLAB = PATCHES_VALID["patches-kuhn-slab"]
PATCHES_FALSE = {
    "gram-blocks--leaning-base": edited(BCC, (claim("gram"), [[3, 1, 0], [3, 0], [3]])),
    "gram-blocks--leaning-height": edited(KUHN_SLAB, (claim("gram"), [[3, 0, 0], [3, 1], [3]])),
    "gram-not-positive--patches-bcc": edited(BCC, (claim("gram", 0, 0), -1)),
    "tile-order--patches-clockwise": edited(cubes().certificate(), (claim("tiles", 0, "vertices"), lambda v: v[::-1])),
    "tile-order--upper-end-first": edited(
        KUHN_SLAB, (claim("tiles", 0, "vertices"), [[1], [0]])),
    "pyramid-side--apex-in-the-other-side": kuhn_slab(1, True).certificate(),
    # The walls of the square are half a period higher than they say.
    "wall-pattern--square-without-offsets": edited(ALL, (witness(1, "offsets"), [[[0, 0]]] * 4)),
    "wall-pattern--square-with-other-offsets": edited(
        ALL, (witness(1, "offsets", 0), [[6, 0]]), (witness(1, "offsets", 2), [[6, 0]])),
    # Each side has its own class, and the diagonal of a turned side is the other one.
    "wall-reversal--cube-in-six": kuhn_prism([0, 1, 2, 3]).certificate(),
    "wall-reversal--square-of-two-classes-is-no-excuse": kuhn_prism([0, 1, 0, 1]).certificate(),
    # The pattern has a half and a third of the period, so the walls agree; but around a vertex they do not close.
    "side-classes--half-a-period-at-one-side": bcc(2, [[0], [0], [0], [F(1, 2)]]).certificate(),
    "side-classes--third-of-a-period-at-one-side": bcc(3, [[0], [0], [0], [F(1, 3)]]).certificate(),
    # The axis meets the hypotenuse of the triangle, not its interior.
    "missing-join--axis-through-an-edge": kuhn_slab(2, True).certificate(),
    "not-attained--patches-bcc": edited(BCC, (claim("statements", 2), ["largest dihedral angle", "maximum", -1, [1, 4]])),
    "angle-bound--patches-squares-and-triangles": edited(ALL, (claim("statements", 2, 3), [[1, 0], 24])),
    "not-acute--patches-bcc": edited(BCC, (claim("statements", 1), "acute")),
    "not-delaunay--patches": edited(KUHN_SLAB, (claim("statements", 3), "Delaunay")),
    # The centre of a neighbouring face lies in the sphere.
    "not-weakly-delaunay--patches": cubes().certificate("weakly Delaunay"),
    "edge-valence--patches-axis": edited(BCC, (claim("statements"), ["face-to-face tiling", "TCP"])),
    "edge-valence--patches-inside": cubes().certificate("TCP"),
    "edge-valence--patches-vertical": cubes("V0 V1 V2 V3 C H F0 F1 F2 F3").certificate("TCP"),
    "open-facet--patches-tetrahedron-missing": edited(ALL, (witness(1, "simplices"), lambda rows: rows[1:])),
    "open-facet--patches-pyramid-missing-in-a-triangle": edited(ALL, (witness(0, "pyramids"), lambda pyramids: pyramids[1:])),
    "facet-side--patches-tetrahedron-twice": edited(ALL, (witness(1, "simplices"), lambda rows: rows[:1] + rows)),
}

PATCHES_DECLINED = {
    "corner-angle--sides-of-3-4-5": bcc(1, None, [0, 1, 2], [(0, 0), (3, 0), (0, 4)]).certificate(),
    "too-many-simplices--patches--limit-simplices-10": ALL,
}
