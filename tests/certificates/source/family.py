"""Certificates of families: tilings whose numbers are polynomials in parameters over a box.

The rows are those of the tiling at one point of the box, and the numbers are written as polynomials.
"""
import copy
import itertools
from dataclasses import dataclass
from fractions import Fraction as F

from .build import Tiling
from .field import Q, Field, times
from .polynomial import Polynomial, integral_values


def closed(low, high):
    return ("closed", low), ("closed", high)


def opened(low, high):
    return ("open", low), ("open", high)


def halved(*axes):
    """The tree that halves every leaf along the first axis, then along the second, and so on."""
    if not axes:
        return []
    return [axes[0], halved(*axes[1:]), halved(*axes[1:])]


@dataclass(frozen=True)
class Family:
    parameters: dict
    gram: list
    vertices: list
    simplices: list
    domain: object = "space"
    field: Field = Q
    tree: object = ()

    def value(self, x):
        if isinstance(x, Polynomial):
            return x
        count = len(self.parameters)
        return Polynomial(self.field, count, {(0,) * count: self.field.element(x)})

    def values(self, rows):
        return [[self.value(x) for x in row] for row in rows]

    def ends(self):
        """Both ends of each parameter in the field."""
        return [tuple(self.field.element(end) for _, end in ends) for ends in self.parameters.values()]

    def between(self, *fractions):
        """The point of the box at these fractions of its sides."""
        return [self.field.add(times(low, 1 - t), times(high, t)) for (low, high), t in zip(self.ends(), fractions)]

    def at(self, point):
        """The tiling with these values of the parameters."""
        def numbers(rows):
            return [[value.at(point) for value in row] for row in self.values(rows)]
        domain = self.domain
        if domain != "space":
            domain = (domain[0], numbers(domain[1]), domain[2])
        return Tiling(numbers(self.gram), numbers(self.vertices), self.simplices, domain, self.field)

    def certificate(self, *statements, at=None, oriented=True):
        """Exact bounds without a value, and the orientation of the rows, are those of the tiling in one point."""
        point = self.between(*(at or [F(1, 2)] * len(self.parameters)))
        tiling = self.at(point)
        single = (tiling.turned() if oriented else tiling).certificate(*statements)
        claim, witness = single["claim"], single["witness"]
        denominator, vertices = self.points(self.vertices)
        return {
            **single, "kind": "family",
            "claim": {"dimension": claim["dimension"], "field": claim["field"], "parameters": self.parameters_member(),
                      "gram": self.gram_member(), "domain": self.domain_member(), "statements": claim["statements"]},
            "witness": {"denominator": denominator, "vertices": vertices, "boundary": [], "tree": list(self.tree),
                        "simplices": witness["simplices"]},
        }

    def parameters_member(self):
        def end(kind, x):
            return [kind, self.field.fraction(self.field.element(x))]
        return [{"name": name, "low": end(*low), "high": end(*high)} for name, (low, high) in self.parameters.items()]

    def gram_member(self):
        """The upper triangle, integral and primitive."""
        rows = self.values([row[i:] for i, row in enumerate(self.gram)])
        denominator, divisor = integral_values(x for row in rows for x in row)
        return [[x.terms_member(F(denominator, divisor or 1)) for x in row] for row in rows]

    def points(self, points):
        """Points as integral values over their least common denominator."""
        points = self.values(points)
        denominator, _ = integral_values([x for point in points for x in point])
        return denominator, [[x.terms_member(denominator) for x in point] for point in points]

    def domain_member(self):
        if self.domain == "space":
            return "space"
        kind, vertices, faces = self.domain
        denominator, vertices = self.points(vertices)
        return [kind, {"denominator": denominator, "vertices": vertices, "faces": copy.deepcopy(faces)}]


def of_tiling(tiling, tree=()):
    """A tiling for every t from 0 to 1, its Gram matrix times 1 + t: all angles are the same."""
    one_more = Polynomial(tiling.field, 1, {(0,): tiling.field.element(1), (1,): tiling.field.element(1)})
    gram = [[one_more * tiling.field.element(x) for x in row] for row in tiling.gram]
    return Family({"t": closed(0, 1)}, gram, tiling.vertices, tiling.simplices, tiling.domain, tiling.field, tree)


FRACTIONS = {
    1: [F(k, 16) for k in range(17)] + [F(1, 3), F(2, 3), F(1, 5), F(1, 7), F(1, 1000), F(999, 1000)],
    2: [F(0), F(1, 1000), F(1, 4), F(1, 3), F(1, 2), F(3, 4), F(999, 1000), F(1)],
    3: [F(0), F(1, 9), F(1, 2), F(3, 4), F(1)],
}


def samples(parameters, field):
    """Points of the box, which a certificate describes: with its closed ends, and near the open ones."""
    fractions = FRACTIONS.get(len(parameters), [F(1, 2)])
    sides = []
    for parameter in parameters:
        (low_kind, (low, p)), (high_kind, (high, q)) = parameter["low"], parameter["high"]
        low, high = times(field.element(low), F(1, p)), times(field.element(high), F(1, q))
        inside = [t for t in fractions if (t > 0 or low_kind == "closed") and (t < 1 or high_kind == "closed")]
        sides.append([field.add(times(low, 1 - t), times(high, t)) for t in inside])
    return itertools.product(*sides)
