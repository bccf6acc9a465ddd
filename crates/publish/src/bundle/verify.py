#!/usr/bin/env python3
"""python3 verify.py FILE…: a third checker of acutile's certificates, in plain Python.

It reads a certificate and checks the hypotheses K, M, C, O, P1 to P3, I, F, B and V of docs/soundness.md,
which imply that the simplices tile the domain face to face, and every other statement of the claim.
Codes of refusals are those of docs/format.md. Numbers are integers, fractions, and integer polynomials
in a root that is enclosed by fractions; no floating-point number is used.

What it does not check: that the bytes are the canonical ones, the order of members and statements, that
fractions are in lowest terms, and limits of size. It declines certificates of the domain "region",
and those in CBOR, which `acutile convert F.cbor F.json` turns into JSON.

Python 3.8 or newer, its standard library alone. Exit code: 0 if every file is verified; else 1 if one is
rejected (something stated is false); else 2 if one is malformed or unreadable; else 3 (declined).
"""

import hashlib
import json
import re
import sys
from collections import Counter
from fractions import Fraction
from itertools import combinations
from math import factorial

BAD_KIND = {"declined": 3, "malformed": 2, "rejected": 1}


class Refusal(Exception):
    def __init__(self, kind, code, message):
        super().__init__(f"{kind} [{code}] {message}")
        self.exit_code = BAD_KIND[kind]


def require(condition, kind, code, message):
    if not condition:
        raise Refusal(kind, code, message)


def true(condition, code, message):
    require(condition, "rejected", code, message)


def formed(condition, code, message):
    require(condition, "malformed", code, message)


# Numbers: over Q integers after scaling; over Q(a) elements of Z[a].


class Field:
    """Q(a), for the one root a of a monic integer polynomial in an interval (hypothesis K)."""

    def __init__(self, polynomial, root):
        self.polynomial, (self.low, self.high) = polynomial, root
        self.degree = len(polynomial) - 1
        formed(self.degree >= 2 and polynomial[-1] == 1, "polynomial", "not monic of degree at least 2")
        formed(self.low < self.high, "root-order", "the root's interval does not rise")
        self.rises = self.value(self.high) > 0
        true(self.value(self.low) * self.value(self.high) < 0, "root-signs", "no opposite signs at the ends")
        low, high = Fraction(0), Fraction(0)
        for power in range(self.degree, 0, -1):
            ends = [x * y for x in (low, high) for y in (self.low, self.high)]
            low, high = (end(ends) + power * polynomial[power] for end in (min, max))
        formed(low > 0 or high < 0, "root-derivative", "the derivative's enclosure contains zero")
        self.found = []

    def value(self, x):
        total = Fraction(0)
        for coefficient in reversed(self.polynomial):
            total = total * x + coefficient
        return total

    def enclosures(self):
        """Finer and finer: for each power of a an interval of integers, over one denominator for all."""
        for level, halvings in enumerate((64, 64, 128, 256, 512, 1024)):
            if level == len(self.found):
                for _ in range(halvings):
                    self.halve()
                self.found.append(self.powers())
            yield self.found[level]

    def halve(self):
        middle = (self.low + self.high) / 2
        at_middle = self.value(middle) if self.rises else -self.value(middle)
        self.low, self.high = (self.low if at_middle > 0 else middle), (self.high if at_middle < 0 else middle)

    def powers(self):
        intervals = [(Fraction(1), Fraction(1))]
        for _ in range(self.degree - 1):
            ends = [x * y for x in intervals[-1] for y in (self.low, self.high)]
            intervals.append((min(ends), max(ends)))
        common = common_denominator(end for interval in intervals for end in interval)
        return [(int(x * common), int(y * common)) for x, y in intervals]


class Element:
    """c_0 + c_1 a + … with integers c_i."""

    def __init__(self, field, coefficients):
        self.field, self.coefficients = field, coefficients

    def lifted(self, other):
        if isinstance(other, Element):
            return other.coefficients
        return [other] + [0] * (self.field.degree - 1)

    def __add__(self, other):
        return Element(self.field, [x + y for x, y in zip(self.coefficients, self.lifted(other))])

    def __sub__(self, other):
        return Element(self.field, [x - y for x, y in zip(self.coefficients, self.lifted(other))])

    def __neg__(self):
        return Element(self.field, [-x for x in self.coefficients])

    def __mul__(self, other):
        if isinstance(other, int):
            return Element(self.field, [x * other for x in self.coefficients])
        n = self.field.degree
        product = [0] * (2 * n - 1)
        for i, x in enumerate(self.coefficients):
            for j, y in enumerate(other.coefficients):
                product[i + j] += x * y
        for top in range(2 * n - 2, n - 1, -1):
            for k in range(n):
                product[top - n + k] -= product[top] * self.field.polynomial[k]
        return Element(self.field, product[:n])

    __radd__ = __add__
    __rmul__ = __mul__

    def __rsub__(self, other):
        return -self + other


def sign(x):
    """-1, 0 or 1. Zero only where all coefficients are; otherwise an enclosure decides, or nothing does."""
    if isinstance(x, int):
        return (x > 0) - (x < 0)
    if not any(x.coefficients):
        return 0
    for powers in x.field.enclosures():
        low = sum(c * (lower if c > 0 else upper) for c, (lower, upper) in zip(x.coefficients, powers))
        high = sum(c * (upper if c > 0 else lower) for c, (lower, upper) in zip(x.coefficients, powers))
        if low > 0 or high < 0:
            return 1 if low > 0 else -1
    raise Refusal("declined", "sign-undecided", "a value is too near to zero")


def rational(text):
    is_rational = isinstance(text, str) and re.fullmatch(r"-?[0-9]+(/[1-9][0-9]*)?", text, re.ASCII)
    formed(is_rational, "number", f"{str(text)[:40]!r} is no rational")
    require(len(text) <= 4000, "declined", "too-many-digits", "more digits than Python reads")
    return Fraction(text)


def integer(text):
    value = rational(text)
    formed(value.denominator == 1, "number", f"{text} is no integer")
    return value.numerator


def common_denominator(fractions):
    product = 1
    for x in fractions:
        product *= (x * product).denominator
    return product


def coefficients(data, field):
    """A number as a list of fractions, one over Q."""
    degree = field.degree if field else 1
    rationals = [rational(x) for x in (data if isinstance(data, list) else [data])]
    formed(1 <= len(rationals) <= degree, "coefficients", "a number has too few or too many coefficients")
    return rationals + [Fraction(0)] * (degree - len(rationals))


def scaled(rows, scale, field):
    """Rows of lists of fractions, times an integer, as numbers to compute with."""
    def one(number):
        integers = [int(x * scale) for x in number]
        return Element(field, integers) if field else integers[0]
    return [[one(number) for number in row] for row in rows]


# Vectors and matrices.


def minus(x, y):
    return [a - b for a, b in zip(x, y)]


def dot(x, y):
    return sum((a * b for a, b in zip(x, y)), 0)


def det(rows):
    if not rows:
        return 1
    minors = ([row[:j] + row[j + 1:] for row in rows[1:]] for j in range(len(rows)))
    return sum((rows[0][j] * det(minor) * (-1) ** j for j, minor in enumerate(minors)), 0)


def cofactors(m):
    def minor(i, j):
        return [row[:j] + row[j + 1:] for k, row in enumerate(m) if k != i]
    return [[det(minor(i, j)) * (-1) ** (i + j) for j in range(len(m))] for i in range(len(m))]


def parity(items):
    """The sign of the permutation that sorts different items."""
    return (-1) ** sum(x > y for x, y in combinations(items, 2))


# The certificate.


def member(data, *names):
    formed(isinstance(data, dict) and set(data) == set(names), "json", f"expected the members {', '.join(names)}")
    return [data[name] for name in names]


def array(data, length=None, code="json"):
    formed(isinstance(data, list), "json", "expected an array")
    formed(length is None or len(data) == length, code, f"{len(data)} entries, expected {length}")
    return data


def naturals(data, end, code):
    formed(all(type(n) is int and 0 <= n < end for n in array(data)), code, f"{data} is out of range")
    return data


def integers(data, length, code):
    formed(all(type(n) is int for n in array(data, length, code)), "json", "expected integers")
    return data


class Certificate:
    """Reads a certificate; its numbers are scaled to be integral (hypotheses K and C)."""

    def __init__(self, data):
        formed(isinstance(data, dict) and data.get("format") == "acutile-certificate", "format", "no certificate")
        version = data.get("version")
        require(type(version) is int and version == 1, "declined", "version", "a version that is unknown here")
        _, _, claim, witness = member(data, "format", "version", "claim", "witness")
        self.dimension, field, gram, domain, self.statements = member(
            claim, "dimension", "field", "gram", "domain", "statements")
        vertices, simplices, self.mates = member(witness, "vertices", "simplices", "mates")
        formed(type(self.dimension) is int and self.dimension in (2, 3), "dimension", "expected 2 or 3")
        self.read_field(field)
        kinds = {"space": 0, "slab": 1, "prism": 2, "solid": self.dimension}
        require(domain != "region", "declined", "region", "regions are not checked here")
        self.domain, polytope = ("space", {"vertices": [], "faces": []}) if domain == "space" else self.only(domain)
        formed(self.domain in kinds, "json", "an unknown domain")
        formed(self.domain != "prism" or self.dimension == 3, "prism-dimension", "a prism in the plane")
        self.codimension = kinds[self.domain]
        self.rank = self.dimension - self.codimension
        self.read_numbers(gram, vertices, polytope)
        self.read_simplices(simplices)

    def only(self, data):
        formed(isinstance(data, dict) and len(data) == 1, "json", "expected one member")
        return next(iter(data.items()))

    def read_field(self, field):
        self.field = None
        if field != "Q":
            polynomial, root = member(member(field, "Q(a)")[0], "polynomial", "root")
            ends = [rational(x) for x in array(root, 2)]
            self.field = Field([integer(x) for x in array(polynomial)], ends)

    def read_numbers(self, gram, vertices, polytope):
        d = self.dimension
        corners, self.faces = member(polytope, "vertices", "faces")
        def table(rows, length, code):
            return [[coefficients(x, self.field) for x in array(row, length, code)] for row in array(rows)]
        texts, gram = gram, table(array(gram, d, "gram-shape"), d, "gram-shape")
        vertices = table(vertices, d, "vertex-length")
        corners = table(corners, self.codimension, "domain-vertex-length")
        formed(texts == [list(column) for column in zip(*texts)], "gram-asymmetric", "G is not symmetric")
        def denominator(rows):
            return common_denominator(x for row in rows for number in row for x in number)
        self.scale = denominator(vertices + corners)
        self.gram = scaled(gram, denominator(gram), self.field)
        self.vertices, self.polytope = (scaled(rows, self.scale, self.field) for rows in (vertices, corners))

    def read_simplices(self, simplices):
        d, count = self.dimension, len(self.vertices)
        formed(array(simplices), "no-simplices", "there is no simplex")
        for corner in (corner for row in simplices for corner in array(row, d + 1, "simplex-length")):
            naturals(integers(corner, 1 + self.rank, "corner-length")[:1], count, "vertex-range")
        self.simplices = [[tuple(corner) for corner in row] for row in simplices]
        used = {corner[0] for row in self.simplices for corner in row}
        formed(len(used) == count, "unused-vertex", "a vertex is no corner")
        array(self.mates, len(simplices), "mates-length")
        for mate in (mate for row in self.mates for mate in array(row, d + 1, "mate-row-length")):
            if self.codimension and len(array(mate)) == 1:
                naturals(mate, len(array(self.faces)), "mate-range")
            else:
                integers(mate, 2 + self.rank, "mate-length")
                naturals(mate[:1], len(simplices), "mate-range")
                naturals(mate[1:2], d + 1, "mate-range")

    def position(self, corner):
        """The coordinates of a corner, scaled."""
        shift = [s * self.scale for s in corner[1:]] + [0] * self.codimension
        return [x + s for x, s in zip(self.vertices[corner[0]], shift)]

    def product(self, x, y):
        return dot(x, [dot(row, y) for row in self.gram])

    def facet(self, simplex, i):
        return self.simplices[simplex][:i] + self.simplices[simplex][i + 1:]

    def height(self, face, point):
        """h_f of a point, given by its last k coordinates."""
        w = [self.polytope[n] for n in face]
        return det([minus(x, w[0]) for x in w[1:self.codimension]] + [minus(point, w[0])])


# The hypotheses.


def check_metric(c):
    for n in range(1, c.dimension + 1):
        true(sign(det([row[:n] for row in c.gram[:n]])) > 0, "gram-not-positive", f"leading minor {n}")


def check_polytope(c):
    """P1, P2, P3; returns the sign s_f of each face."""
    k, count = c.codimension, len(c.polytope)
    formed(len(array(c.faces)) > k, "face-count", "too few faces")
    for face in c.faces:
        formed(len(array(face)) == k or len(face) > k == 3, "face-length", f"{len(face)} vertices")
        formed(len(set(naturals(face, count, "face-vertices"))) == len(face), "face-vertices", "one is there twice")
    formed(len({frozenset(face) for face in c.faces}) == len(c.faces), "face-repeated", "a face is there twice")
    formed(len({n for face in c.faces for n in face}) == count, "unused-domain-vertex", "a vertex is in no face")
    signs = [face_sign(c, face) for face in c.faces]
    if k == 3:
        for face in c.faces:
            check_polygon(c, face)
    ridges = {
        1: lambda face: [()], 2: lambda face: face,
        3: lambda face: [frozenset(pair) for pair in zip(face, face[1:] + face[:1])],
    }[k]
    found = Counter(ridge for face in c.faces for ridge in ridges(face))
    true(set(found.values()) == {2}, "faces-not-closed", "a ridge is not in two faces")
    return signs


def face_sign(c, face):
    signs = [sign(c.height(face, w)) for w in c.polytope]
    others = {s for n, s in enumerate(signs) if n not in face}
    is_facet = all(signs[n] == 0 for n in face) and others in ({1}, {-1})
    true(is_facet, "face-not-facet", f"face {face}")
    return others.pop()


def check_polygon(c, face):
    outside = next(w for n, w in enumerate(c.polytope) if n not in face)
    turns = set()
    for p, q in zip(face, face[1:] + face[:1]):
        for t in set(face) - {p, q}:
            turns.add(sign(det([minus(x, c.polytope[p]) for x in (c.polytope[q], c.polytope[t], outside)])))
    true(turns in ({1}, {-1}), "face-not-convex", f"face {face}")


def check_inside(c, signs):
    for n, vertex in enumerate(c.vertices):
        for face, s in zip(c.faces, signs):
            is_inside = s * sign(c.height(face, vertex[c.rank:])) >= 0
            true(is_inside, "vertex-outside", f"vertex {n} is beyond face {face}")


def facets(c):
    return ((s, i, mate) for s, row in enumerate(c.mates) for i, mate in enumerate(row))


def check_mates(c):
    paired = [(s, i, *mate) for s, i, mate in facets(c) if len(mate) > 1]
    for s, i, t, j, *shift in paired:
        back = [s, i] + [-u for u in shift]
        true(c.mates[t][j] == back, "mate-not-mutual", f"facet {i} of simplex {s}")
    for s, i, t, j, *shift in paired:
        here, there = c.facet(s, i), [moved(corner, shift) for corner in c.facet(t, j)]
        true(sorted(here) == sorted(there), "mate-corners", f"facet {i} of simplex {s}")
        is_opposite = (-1) ** (i + j) * parity(here) * parity(there) == -1
        true(is_opposite, "mate-side", f"facet {i} of simplex {s}")
    for s, i, mate in facets(c):
        for corner in c.facet(s, i) if len(mate) == 1 else []:
            height = c.height(c.faces[mate[0]], c.position(corner)[c.rank:])
            true(sign(height) == 0, "boundary-facet", f"facet {i} of simplex {s}")


def moved(corner, shift):
    return (corner[0],) + tuple(x + u for x, u in zip(corner[1:], shift))


def check_volume(c, determinants):
    """The sum of the determinants is D! vol P, with Lemma 0's k! vol P."""
    k = c.codimension
    volume = 1
    for face in c.faces if k else []:
        volume = 0 if face is c.faces[0] else volume
        w = [minus(c.polytope[n], c.polytope[face[0]]) for n in face]
        apex = minus(c.polytope[0], c.polytope[face[0]])
        pieces = sum((det(w[i:i + k - 1] + [apex]) for i in range(1, len(face) - k + 2)), 0)
        volume = volume + pieces * sign(pieces)
    expected = volume * (factorial(c.dimension) // factorial(k) * c.scale ** c.rank)
    true(sign(sum(determinants, 0) - expected) == 0, "volume-sum", "the volumes do not sum to the domain's")


# The statements.


class Shape:
    """The Gram matrix of a simplex's edges from corner 0, its cofactors and determinant."""

    def __init__(self, c, corners):
        self.origin, *others = [c.position(corner) for corner in corners]
        self.edges = [minus(x, self.origin) for x in others]
        self.m = [[c.product(x, y) for y in self.edges] for x in self.edges]
        self.cofactors = cofactors(self.m)
        self.det = det(self.m)
        self.delta = [row[i] for i, row in enumerate(self.m)]

    def gradients(self):
        """det M times the inner products of the gradients g_0, …, g_D."""
        first = [-sum(column, 0) for column in zip(*self.cofactors)]
        return [[-sum(first, 0)] + first] + [[x] + row for x, row in zip(first, self.cofactors)]

    def squared_edges(self):
        between = [x + y - 2 * self.m[i][j] for (i, x), (j, y) in combinations(enumerate(self.delta), 2)]
        return self.delta + between

    def power(self, c, point):
        """det M times the power of a point in the circumsphere."""
        x = minus(point, self.origin)
        products = [c.product(edge, x) for edge in self.edges]
        return self.det * c.product(x, x) - dot(self.delta, [dot(row, products) for row in self.cofactors])


def compared_cosine(g, i, j, bound):
    """The sign of cos θ_ij - bound, for the angle between facets i and j; bound is a fraction."""
    cosine = -g[i][j]
    s, t = sign(cosine), sign(bound.numerator)
    if s != t or s == 0:
        return (s > t) - (s < t)
    squares = cosine * cosine * bound.denominator ** 2 - g[i][i] * g[j][j] * bound.numerator ** 2
    return s * sign(squares)


def cosine(degrees):
    """Fractions that enclose cos(degrees); equal where it is rational."""
    exact = {0: 1, 60: Fraction(1, 2), 90: 0, 120: Fraction(-1, 2), 180: -1}
    if degrees in exact:
        return Fraction(exact[degrees]), Fraction(exact[degrees])
    unit = 1 << 200
    # Machin: π = 16 arctan(1/5) - 4 arctan(1/239); each series alternates, and so its error is less than the next term.
    def arctan(n):
        return sum(Fraction((-1) ** k, (2 * k + 1) * n ** (2 * k + 1)) for k in range(60))
    pi = 16 * arctan(5) - 4 * arctan(239)
    x = Fraction(int(pi * degrees / 180 * unit), unit)
    # The tails are less than 20 / 5^121 < 2^-270 and x is rounded by 2^-200; the terms of the cosine alternate and
    # fall from x^2 / 2 on, for x^2 < 12, and the first one left out, x^120 / 120!, is less than 2^-400. |cos'| ≤ 1.
    value, term = Fraction(0), Fraction(1)
    for k in range(60):
        value += term
        term *= -x * x / ((2 * k + 1) * (2 * k + 2))
    return value - Fraction(1, 1 << 190), value + Fraction(1, 1 << 190)


def check_angles(shapes, degrees, side):
    """All angles less (side 1) or more (side -1) than so many degrees: the cosine is on the other side."""
    low, high = cosine(degrees)
    sure, wrong = (high, low) if side == 1 else (low, high)
    code = "angle-not-below" if side == 1 else "angle-not-above"
    undecided = []
    for s, g in enumerate(shape.gradients() for shape in shapes):
        for i, j in combinations(range(len(g)), 2):
            if side * compared_cosine(g, i, j, sure) > 0:
                continue
            true(side * compared_cosine(g, i, j, wrong) > 0, code, f"facets {i} and {j} of simplex {s}")
            undecided.append((s, i, j))
    require(not undecided, "declined", "angle-undecided", "an angle is too near to the bound")


def check_acute(shapes, least, code):
    for s, g in enumerate(shape.gradients() for shape in shapes):
        for i, j in combinations(range(len(g)), 2):
            true(-sign(g[i][j]) >= least, code, f"facets {i} and {j} of simplex {s}")


def check_ratio(shapes, q):
    for s, shape in enumerate(shapes):
        radius = dot(shape.delta, [dot(row, shape.delta) for row in shape.cofactors])
        for edge in shape.squared_edges():
            is_less = sign(shape.det * edge * (4 * q.numerator ** 2) - radius * q.denominator ** 2) > 0
            true(is_less, "ratio-not-below", f"simplex {s}")


def check_delaunay(c, shapes, least, code):
    for s, i, mate in facets(c):
        if len(mate) > 1:
            t, j, *shift = mate
            behind = c.position(moved(c.simplices[t][j], shift))
            true(sign(shapes[s].power(c, behind)) >= least, code, f"behind facet {i} of simplex {s}")


def check_tcp(c):
    formed(c.dimension == 3 and c.domain == "space", "tcp-domain", "TCP is stated of space alone")
    def edge(pair):
        (v, *s), (w, *t) = sorted(pair)
        return (v, w, *minus(t, s))
    valences = Counter(edge(pair) for row in c.simplices for pair in combinations(row, 2))
    true(set(valences.values()) <= {5, 6}, "edge-valence", "an edge is in fewer than 5 or more than 6")
    for triangle in (triangle for row in c.simplices for triangle in combinations(row, 3)):
        sixes = sum(valences[edge(pair)] == 6 for pair in combinations(triangle, 2))
        true(sixes < 2, "triangle-valence", "a triangle has two edges that are in 6")


def check_statement(c, shapes, statement):
    bounds = {"all dihedral angles below": (0, 180), "all dihedral angles above": (0, 180)}
    if statement == "acute":
        check_acute(shapes, 1, "not-acute")
    elif statement == "nonobtuse":
        check_acute(shapes, 0, "not-nonobtuse")
    elif statement == "Delaunay":
        check_delaunay(c, shapes, 1, "not-delaunay")
    elif statement == "weakly Delaunay":
        check_delaunay(c, shapes, 0, "not-weakly-delaunay")
    elif statement == "TCP":
        check_tcp(c)
    else:
        name, bound = c.only(statement)
        bound = rational(bound)
        if name in bounds:
            formed(0 <= bound <= 180, "angle-range", "expected 0 to 180 degrees")
            check_angles(shapes, bound, 1 if name.endswith("below") else -1)
        else:
            formed(name == "all radius-edge ratios below", "json", "an unknown statement")
            formed(bound > 0, "ratio-range", "expected a positive ratio")
            check_ratio(shapes, bound)


def check(data):
    """Refuses, or returns the certificate, which then proves what it claims."""
    c = Certificate(data)
    first, *others = array(c.statements) or [None]
    formed(first == "face-to-face tiling", "statements", "the tiling is not the first statement")
    check_metric(c)
    if c.codimension:
        check_inside(c, check_polytope(c))
    shapes = [Shape(c, row) for row in c.simplices]
    determinants = [det(shape.edges) for shape in shapes]
    for s, determinant in enumerate(determinants):
        true(sign(determinant) > 0, "orientation", f"simplex {s}")
    check_mates(c)
    check_volume(c, determinants)
    for statement in others:
        check_statement(c, shapes, statement)
    return c


def unrepeated(pairs):
    formed(len({name for name, _ in pairs}) == len(pairs), "json", "a member is there twice")
    return dict(pairs)


def check_encoding(content):
    """A certificate in CBOR is a map, and no text in UTF-8 begins as one."""
    message = "the certificate is in CBOR; `acutile convert F.cbor F.json` gives the JSON that this program reads"
    require(content[:1] < b"\xa0" or content[:1] > b"\xbf", "declined", "encoding", message)


def verdict(path):
    """A line about a file, and the exit code."""
    try:
        with open(path, "rb") as file:
            content = file.read()
        check_encoding(content)
        c = check(json.loads(content.decode("utf-8"), object_pairs_hook=unrepeated))
    except Refusal as refusal:
        return str(refusal), refusal.exit_code
    except OSError as error:
        return f"unreadable: {error.strerror}", 2
    except (ValueError, RecursionError) as error:
        return f"malformed [json] {type(error).__name__}", 2
    said = "; ".join(x if isinstance(x, str) else "{} {}".format(*c.only(x)) for x in c.statements)
    sizes = f"dimension {c.dimension}, domain {c.domain}, {len(c.vertices)} vertices, {len(c.simplices)} simplices"
    return f"verified: {said} ({sizes}, sha256 {hashlib.sha256(content).hexdigest()})", 0


def main(paths):
    if not paths or paths[0].startswith("-"):
        print(__doc__)
        return 0 if paths else 2
    worst = 0
    for path in paths:
        line, code = verdict(path)
        print(f"{path}: {line}", flush=True)
        worst = min(worst or code, code or worst)
    return worst


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
