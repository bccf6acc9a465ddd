"""Checks the claim of a certificate: field, Gram matrix, domain and statements."""
import math
from fractions import Fraction as F

from .build import CROSSED, RATIO, RELATIONS
from .field import Field, Q, determinant, times
from .shape import ORDER, ensure


def coefficients(x):
    return x if isinstance(x, list) else [x]


def lowest(denominator, numbers_):
    ensure(denominator > 0, "denominator")
    ensure(math.gcd(denominator, *(c for x in numbers_ for c in coefficients(x))) == 1, "canonical")


def field_of(claim):
    if claim["field"] == "Q":
        return Q
    p, root = claim["field"]["polynomial"], claim["field"]["root"]
    low, high, denominator = root.values()
    ensure(low < high and denominator > 0, "root-order")
    ensure(math.gcd(low, high, denominator) == 1, "canonical")
    field = Field(p, F(low, denominator), F(high, denominator))
    ensure(field.value(field.low) * field.value(field.high) < 0, "root-signs")
    least, greatest = field.range([k * c for k, c in enumerate(p)][1:], field.low, field.high)
    ensure(least > 0 or greatest < 0, "root-derivative")
    return field


class Claim:
    def __init__(self, claim):
        self.f = f = field_of(claim)
        self.d = d = claim["dimension"]
        rows = claim["gram"]
        ensure(math.gcd(*(c for row in rows for x in row for c in coefficients(x))) in (0, 1), "canonical")
        full = [[rows[min(i, j)][abs(i - j)] for j in range(d)] for i in range(d)]
        self.gram = [[f.element(x) for x in row] for row in full]
        for k in range(1, d + 1):
            ensure(f.sign(determinant(f, [row[:k] for row in self.gram[:k]])) > 0, "gram-not-positive")
        self.region = self.polytope = None
        self.rank = d
        if claim["domain"] != "space":
            kind, body = claim["domain"]
            if kind == "region":
                self.region, self.rank = body, body
            else:
                self.polytope = Polytope(f, body, kind)
                self.rank = d - self.polytope.k
        self.statements = claim["statements"]
        self.check_statements(claim["domain"])

    def check_statements(self, domain):
        places = [(ORDER.index(s), 0) if isinstance(s, str) else (ORDER.index(s[0]), *s[1], *s[2]) if s[0] == CROSSED
                  else (ORDER.index(s[0]), RELATIONS.index(s[1])) for s in self.statements]
        ensure(places and places[0] == (0, 0) and places == sorted(set(places)), "statements")
        for s in self.statements:
            if isinstance(s, str):
                space = domain == "space"
                good = {"TCP": self.d == 3 and space, "Delaunay": self.region is None, "weakly Delaunay": self.region is None,
                        "locally Delaunay": self.region is not None, "locally weakly Delaunay": self.region is not None}
                ensure(good.get(s, True), "statement-domain")
                continue
            if s[0] == CROSSED:
                ensure(math.gcd(*s[1]) == 1 and [c for c in s[1] if c][0] > 0 and math.gcd(*s[2]) == 1, "canonical")
                ensure(all(abs(c) < 1 << 29 for c in s[1]) and s[2][1] > 0, "bound-range")
                continue
            numerator, denominator = s[-1]
            ensure(denominator > 0, "bound-range")
            ensure(math.gcd(denominator, *coefficients(numerator)) == 1, "canonical")
            value = times(self.f.element(numerator), F(1, denominator))
            sign = self.f.sign(value)
            if s[0] == RATIO:
                ensure(sign > 0, "bound-range")
            else:
                ensure(s[2] in (-1, 0, 1) and sign == abs(s[2]), "bound-range")
                ensure(self.f.sign(self.f.subtract(self.f.element(1), value)) >= 0, "bound-range")


class Polytope:
    def __init__(self, f, body, kind):
        self.f = f
        vertices, faces = body["vertices"], body["faces"]
        self.k = k = {"slab": 1, "prism": 2, "solid": None}[kind] or (len(vertices[0]) if vertices else 3)
        self.denominator, self.faces = body["denominator"], faces
        ensure(self.denominator > 0, "denominator")
        lowest(self.denominator, [x for v in vertices for x in v])
        ensure(len(faces) >= k + 1, "face-count")
        for face in faces:
            ensure(len(face) == k if k < 3 else len(face) >= 3, "face-length")
            ensure(all(0 <= w < len(vertices) for w in face) and len(set(face)) == len(face), "face-vertices")
        ensure(len(set(map(frozenset, faces))) == len(faces), "face-repeated")
        ensure({w for face in faces for w in face} == set(range(len(vertices))), "unused-domain-vertex")
        self.points = [[times(f.element(x), F(1, self.denominator)) for x in v] for v in vertices]
        self.inside = []
        for face in faces:
            signs = [f.sign(self.height(face, x)) for x in self.points]
            ensure(all(signs[w] == 0 for w in face), "face-not-facet")
            others = {s for w, s in enumerate(signs) if w not in face}
            ensure(others in ({1}, {-1}), "face-not-facet")
            self.inside.append(others.pop())
        if k == 3:
            for face in faces:
                self.check_convex(face)
        ridges = [frozenset(pair) for face in faces for pair in zip(face, face[1:] + face[:1])] if k == 3 else \
            [w for face in faces for w in face] if k == 2 else []
        ensure(all(ridges.count(ridge) == 2 for ridge in ridges), "faces-not-closed")

    def height(self, face, x):
        base, *rest = [self.points[w] for w in face[:self.k]]
        return determinant(self.f, [[self.f.subtract(a, b) for a, b in zip(y, base)] for y in [*rest, x]])

    def check_convex(self, face):
        """Seen from a vertex that is not in the face, each side has the rest of the face on one side."""
        apex = next(x for w, x in enumerate(self.points) if w not in face)
        signs = set()
        for i in range(len(face)):
            a, b = (self.points[face[(i + j) % len(face)]] for j in (0, 1))
            for w in face:
                if self.points[w] not in (a, b):
                    rows = [[self.f.subtract(p, q) for p, q in zip(y, apex)] for y in (a, b, self.points[w])]
                    signs.add(self.f.sign(determinant(self.f, rows)))
        ensure(signs in ({1}, {-1}), "face-not-convex")

    def volume(self):
        """k! times the volume: the pyramids over a fan of each face from the first vertex."""
        f, apex = self.f, self.points[0]
        total = f.element(0)
        for face, inside in zip(self.faces, self.inside):
            for i in range(1, max(2, len(face) - 1)):
                fan = [face[0], *face[i:i + self.k - 1]] if self.k > 1 else face
                total = f.add(total, times(self.height(fan, apex), inside) if self.k > 1 else
                              times(f.subtract(apex[0], self.points[face[0]][0]), inside))
        return total
