"""Certificates of format 2 from vertices and oriented simplices."""
import copy
import itertools
from dataclasses import dataclass, replace
from fractions import Fraction as F

from .field import Q, Field, common_denominator, content, determinant, figures, signed, times

TILING = "face-to-face tiling"
LARGEST, SMALLEST, RATIO = "largest dihedral angle", "smallest dihedral angle", "squared radius-edge ratio"
CROSSED = "uncrossed plane"
RELATIONS = ["less than", "at most", "maximum", "more than", "at least", "minimum"]


@dataclass
class Bound:
    """A bound; without a value, "maximum" and "minimum" mean the exact value that is computed."""
    quantity: str
    relation: str
    sign: int = None
    square: object = None


def largest(relation, sign=None, square=0):
    return Bound(LARGEST, relation, sign, square)


def smallest(relation, sign=None, square=0):
    return Bound(SMALLEST, relation, sign, square)


def ratio(relation, square=None):
    return Bound(RATIO, relation, None if square is None else 1, square)


ALL_FIGURES = [make(relation) for make in (largest, smallest, ratio) for relation in ("maximum", "minimum")]


# --- names -------------------------------------------------------------------

def inversions(order):
    return sum(order[i] > order[j] for i in range(len(order)) for j in range(i + 1, len(order)))


def from_first(corners):
    """The corners as tuples (vertex, shift), moved so that the first has the shift zero."""
    shift = corners[0][1:]
    return [(c[0], *(s - t for s, t in zip(c[1:], shift))) for c in corners]


def exchange_last(corners):
    return from_first([*corners[:-2], corners[-1], corners[-2]])


def oriented_row(corners):
    """Sorted corners of a simplex that is oriented positively as given; then the last two may change places."""
    order = sorted(range(len(corners)), key=lambda i: tuple(corners[i]))
    row = from_first([tuple(corners[i]) for i in order])
    return exchange_last(row) if inversions(order) % 2 else row


def facets(row):
    """Name and side of each facet of a row."""
    corners = sorted(row)
    odd = corners != list(row)
    return [(tuple(from_first(corners[:i] + corners[i + 1:])), (odd + i) % 2) for i in range(len(corners))]


def edges(row):
    return [tuple(from_first(list(pair))) for pair in itertools.combinations(sorted(row), 2)]


def listed(name, side):
    """A boundary facet as it is listed: its corner outside of it, if the simplex is on this side."""
    return exchange_last(list(name)) if side else list(name)


def corner(c):
    """A vertex alone, or with the shift that moves it."""
    return list(c) if any(c[1:]) else c[0]


# --- tilings -------------------------------------------------------------------

@dataclass(frozen=True)
class Tiling:
    gram: list
    vertices: list
    simplices: list
    domain: object = "space"
    field: Field = Q

    @property
    def dimension(self):
        return len(self.gram)

    @property
    def rank(self):
        if self.domain == "space":
            return self.dimension
        if self.domain[0] == "region":
            return self.domain[1]
        return self.dimension - len(self.domain[1][0])

    def position(self, place):
        f = self.field
        shift = [*place[1:], *[0] * (self.dimension - len(place) + 1)]
        return [f.add(f.element(x), f.element(s)) for x, s in zip(self.vertices[place[0]], shift)]

    def edge_vectors(self, places):
        base, *rest = map(self.position, places)
        return [[self.field.subtract(a, b) for a, b in zip(x, base)] for x in rest]

    def turned(self):
        """The last two corners exchanged where the determinant is negative."""
        simplices = []
        for places in self.simplices:
            sign = self.field.sign(determinant(self.field, self.edge_vectors(places)))
            assert sign != 0, "flat"
            simplices.append(places if sign > 0 else exchange_last([tuple(p) for p in places]))
        return replace(self, simplices=simplices)

    def rows(self):
        return [oriented_row(places) for places in self.simplices]

    def boundary(self):
        """The facets that one simplex has alone."""
        sides = {}
        for row in self.rows():
            for name, side in facets(row):
                sides.setdefault(name, []).append(side)
        return [listed(name, found[0]) for name, found in sides.items() if len(found) == 1]

    def certificate(self, *statements, boundary=None, sixes=None):
        """`sixes` maps the valence of an edge to whether its bit is set."""
        rows = [[corner(c) for c in row] for row in self.rows()]
        if "TCP" in statements:
            rows = [[*row, hint] for row, hint in zip(rows, self.hints(sixes or (lambda valence: valence == 6)))]
        if boundary is None:
            boundary = self.boundary() if self.domain[0] == "region" else []
        denominator, vertices = integral(self.field, self.vertices)
        return {
            "format": "acutile-certificate", "version": 2, "kind": "tiling",
            "claim": {"dimension": self.dimension, "field": self.field_member(), "gram": self.gram_member(),
                      "domain": self.domain_member(), "statements": [TILING, *self.statements(statements)]},
            "witness": {"denominator": denominator, "vertices": vertices,
                        "boundary": [[corner(c) for c in facet] for facet in boundary], "simplices": rows},
        }

    def hints(self, rule):
        valence = {}
        for row in self.rows():
            for edge in edges(row):
                valence[edge] = valence.get(edge, 0) + 1
        return [sum(rule(valence[edge]) << p for p, edge in enumerate(edges(row))) for row in self.rows()]

    def field_member(self):
        f = self.field
        if f.degree == 1:
            return "Q"
        d = common_denominator([(f.low, f.high)])
        return {"polynomial": f.polynomial,
                "root": {"low": int(f.low * d), "high": int(f.high * d), "denominator": d}}

    def gram_member(self):
        """The upper triangle, integral and primitive."""
        gram = [[self.field.element(x) for x in row[i:]] for i, row in enumerate(self.gram)]
        entries = [x for row in gram for x in row]
        scale = common_denominator(entries)
        factor = F(scale, content(times(x, scale) for x in entries) or 1)
        return [[self.field.integers(times(x, factor)) for x in row] for row in gram]

    def domain_member(self):
        if self.domain == "space":
            return "space"
        if self.domain[0] == "region":
            return list(self.domain)
        kind, vertices, faces = self.domain
        denominator, vertices = integral(self.field, vertices)
        return [kind, {"denominator": denominator, "vertices": vertices, "faces": copy.deepcopy(faces)}]

    def statements(self, statements):
        for s in statements:
            if not isinstance(s, Bound):
                yield s
                continue
            sign, square = self.figure(s) if s.sign is None else (s.sign, self.field.element(s.square))
            yield [s.quantity, s.relation, *([] if s.quantity == RATIO else [sign]), self.field.fraction(square)]

    def figure(self, bound):
        """The exact greatest or least value over the simplices. The greatest angle has the least cosine."""
        f, gram = self.field, [[self.field.element(x) for x in row] for row in self.gram]
        found = {}
        for places in self.simplices:
            vectors = self.edge_vectors(places)
            if repr(vectors) not in found:
                found[repr(vectors)] = figures(f, gram, vectors)
        values = [dict(zip((LARGEST, SMALLEST, RATIO), (a, b, (1, r))))[bound.quantity] for a, b, r in found.values()]
        least = (bound.relation == "minimum") == (bound.quantity == RATIO)
        best = values[0]
        for value in values[1:]:
            x, y = signed(f, value), signed(f, best)
            if f.less(x, y) if least else f.less(y, x):
                best = value
        return best


def integral(field, points):
    """Points as integers over their least common denominator."""
    points = [[field.element(x) for x in point] for point in points]
    denominator = common_denominator([x for point in points for x in point])
    return denominator, [[field.integers(times(x, denominator)) for x in point] for point in points]


def edit(base, path, value):
    """A copy of a certificate with one item replaced (or, by `None`, removed)."""
    certificate = copy.deepcopy(base)
    *way, last = path
    at = certificate
    for step in way:
        at = at[step]
    if value is None:
        del at[last]
    else:
        at[last] = value
    return certificate


def uncrossed(normal, p, q=1):
    """No simplex crosses normal · x = p/q or a translate of it."""
    return [CROSSED, list(normal), [p, q]]
