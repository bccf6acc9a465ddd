#!/usr/bin/env python3
"""Writes the certificates of this folder: `python3 make.py`, needs Python 3 alone.

A second implementation, which shares nothing with the program: it writes the
canonical bytes from docs/format.md, matches facets by sorting them modulo the
lattice, and finds Delaunay tetrahedra by trying all quadruples of near points,
in exact fractions. README.md says what each file is for.
"""
import copy
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
        return [approximate(x, a) + s for x, s in zip(vertices[place[0]], place[1:])]
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


def certificate(gram, vertices, simplices, *statements, field="Q", a=0.0):
    simplices = oriented(vertices, simplices, a)
    mates = matched(simplices)
    assert all(mate for row in mates for mate in row), "not every facet has one mate"
    return {
        "format": "acutile-certificate", "version": 1,
        "claim": {"dimension": len(gram), "field": field, "gram": gram, "domain": "space",
                  "statements": [TILING, *statements]},
        "witness": {"vertices": vertices, "simplices": simplices, "mates": mates},
    }


def below(degrees):
    return {"all dihedral angles below": degrees}


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


def delaunay(points):
    """The Delaunay tetrahedra of points modulo Z^3 with the unit metric, each orbit once."""
    cells = list(itertools.product((-1, 0, 1), repeat=3))
    cloud = [(v, c, [x + s for x, s in zip(p, c)]) for v, p in enumerate(points) for c in cells]
    found = {}
    for v, p in enumerate(points):
        near = [(w, c, [x - y for x, y in zip(q, p)]) for w, c, q in cloud]
        near = [n for n in near if 0 < sum(x * x for x in n[2]) <= F(2, 5)]
        for triple in itertools.combinations(near, 3):
            edges = [n[2] for n in triple]
            volume = determinant(edges)
            if volume == 0:
                continue
            squares = [sum(x * x for x in e) for e in edges]
            centre = []
            for k in range(3):
                centre.append(determinant([e[:k] + [r] + e[k + 1:] for e, r in zip(edges, squares)])
                              / (2 * volume))
            radius = sum(x * x for x in centre)
            powers = [sum((x - y - z) ** 2 for x, y, z in zip(q, p, centre)) - radius
                      for _, _, q in cloud]
            if min(powers) < 0:
                continue
            assert powers.count(0) == 4, "cospherical points"
            corners = [[v, 0, 0, 0]] + [[w, *c] for w, c, _ in triple]
            form, _ = normal_form(corners)
            found[form] = [list(place) for place in form]
    return [found[form] for form in sorted(found)]


def a15(*statements):
    """A15: (0,0,0), (1/2,1/2,1/2) and the six of 6c; 46 tetrahedra."""
    points = [(F(0),) * 3, (F(1, 2),) * 3]
    for axis in range(3):
        for quarter in (1, 3):
            point = [F(0)] * 3
            point[axis], point[(axis + 2) % 3] = F(quarter, 4), F(1, 2)
            points.append(tuple(point))
    simplices = delaunay(points)
    assert len(simplices) == 46
    return certificate(CUBE, [[str(x) for x in p] for p in points], simplices, *statements)


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
}


def moved_by_a_lattice_vector():
    """One tetrahedron of cube-6 moved by (5, -7, 2): still right."""
    c = copy.deepcopy(VALID["space-cube-6"])
    by = [5, -7, 2]
    c["witness"]["simplices"][2] = [
        [p[0]] + [x + y for x, y in zip(p[1:], by)] for p in c["witness"]["simplices"][2]]
    c["witness"]["mates"] = matched(c["witness"]["simplices"])
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
FIELD = ("claim", "field")
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
    "angle-range--above-180": edit(E, STATEMENTS, [TILING, below("1800001/10000")]),
}


def swapped(base, simplex):
    """Two corners of one simplex exchanged, and its mates with them: negative orientation."""
    c = copy.deepcopy(base)
    corners = c["witness"]["simplices"][simplex]
    corners[0], corners[1] = corners[1], corners[0]
    c["witness"]["mates"] = matched(c["witness"]["simplices"])
    return c


def mirrored():
    """All simplices negative: the same tiling seen in a mirror."""
    c = copy.deepcopy(E)
    for corners in c["witness"]["simplices"]:
        corners[0], corners[1] = corners[1], corners[0]
    c["witness"]["mates"] = matched(c["witness"]["simplices"])
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


def with_statements(base, *statements):
    return edit(base, STATEMENTS, [TILING, *statements])


FALSE = {
    "gram-asymmetric": edit(E, (*GRAM, 0, 1), "0"),
    "gram-asymmetric--nothing-else-wrong": edit(BARE, (*GRAM, 0, 1), "0"),
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
    "root-derivative--three-roots": root(THREE_ROOTS, "-2", "2"),
    "root-derivative--one-root-but-wide": root(["-3", "0", "1"], "-1", "2"),
    "root-derivative--triple-root": root(["-1", "3", "-3", "1"], "0", "3"),
    "root-derivative--monotone-but-zero-at-an-end": root(["-3", "0", "1"], "0", "2"),
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


def primes():
    """Denominators with a common multiple of more than 1000 digits, each of few."""
    found = [p for p in range(2, 3000) if all(p % q for q in range(2, int(p ** 0.5) + 1))]
    n = len(found)
    simplices, vertices = [], []
    for k in range(n):
        vertices.append([f"{1}/{found[k]}", "0"])
        simplices += [[[k] + p[1:] for p in corners] for corners in LATTICE_TRIANGLES]
    return certificate(HEXAGONAL, vertices, simplices)


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
