"""Families about which nothing is decided: the tree is too coarse, or a limit is exceeded."""
from fractions import Fraction as F

from .build import edit, largest
from .declined import RIGHT
from .family import closed, halved, of_tiling, opened
from .malformed_families import TREE
from .polynomial import variables
from .valid_families import HILL, SIDE, UNIT, X, X_, Y_, isosceles, path, plane, strip, with_cosine

THIRD = (3 * X - 1) ** 2
ONE = isosceles().certificate("acute")
LONG = 10 ** 2000
MANY = variables(12)


def product_of(factors):
    result = 1
    for x in factors:
        result = result * (x + 1)
    return result


def leaves(n):
    """A tree with n leaves, as even as possible."""
    return [] if n == 1 else [0, leaves(n // 2), leaves(n - n // 2)]


# The Bernstein coefficients of SIDE on [0, 1] are 13/50, -6/25, 13/50; on [0, 1/2] they are not negative.
TRUE = {
    "sign-undecided--family-needs-a-tree": with_cosine(SIDE).certificate("acute"),
    "sign-undecided--family-needs-a-tree-for-nonobtuse": with_cosine(SIDE).certificate("nonobtuse"),
    "sign-undecided--family-halved-along-one-axis-only": with_cosine(HILL, halved(0, 0), **UNIT).certificate("acute"),
    "sign-undecided--family-one-leaf-too-coarse": with_cosine(HILL, [0, [1, [], []], []], **UNIT).certificate("acute"),
    "sign-undecided--family-gram": plane({"x": closed(0, 1)}, [[SIDE, 0], [0, 1]]).certificate(),
    "sign-undecided--family-delaunay": with_cosine(SIDE).certificate("Delaunay"),
    "sign-undecided--family-weakly-delaunay": with_cosine(SIDE).certificate("weakly Delaunay"),
    "sign-undecided--family-not-delaunay": with_cosine(-SIDE).certificate("not Delaunay"),
    "sign-undecided--family-domain": strip((X - F(1, 2)) ** 2 + F(1, 100), *closed(0, 1)).certificate(),
    "sign-undecided--family-bound": with_cosine(SIDE).certificate(largest("less than", 0, 0)),
    # Up to x = 1/2 the angle with the cosine x is at least 60 degrees, then another one.
    "sign-undecided--family-neither-angle-everywhere": with_cosine(X, x=opened(-1, 1)).certificate(largest("at least", 1, F(1, 4))),
    "sign-undecided--family-neither-angle-in-a-leaf": with_cosine(X, halved(0), x=opened(-1, 1)).certificate(largest("at least", 1, F(1, 4))),
}

# A right angle, or more, where nothing tries: at x = 1/3, or near to it, or near to an open end.
FALSE_BUT_DECLINED = {
    "sign-undecided--family-zero-at-a-third": with_cosine(THIRD / 8).certificate("acute"),
    "sign-undecided--family-zero-at-a-third-of-a-leaf": with_cosine(THIRD / 8, halved(0, 0, 0)).certificate("acute"),
    "sign-undecided--family-negative-near-a-third": with_cosine(THIRD / 8 - F(1, 1000), halved(0)).certificate("nonobtuse"),
    "sign-undecided--family-gram-zero-at-a-third": plane({"x": closed(0, 1)}, [[THIRD, 0], [0, 1]]).certificate(),
    "sign-undecided--family-negative-near-an-open-end": with_cosine(X - F(1, 8), x=opened(0, F(1, 2))).certificate("acute"),
    "sign-undecided--family-zero-on-a-line": with_cosine((X_ - Y_ - F(1, 3)) ** 2 / 4, halved(0, 1), **UNIT).certificate("acute"),
    "sign-undecided--family-attained-in-the-middle-only": plane({"t": opened(0, 1)}, [[2, 1], [1, 2 + (2 * X - 1) ** 2]]).certificate(
        largest("minimum", 1, F(1, 4))),
    "sign-undecided--family-of-a-right-angle-over-a-reducible-field": of_tiling(RIGHT).certificate("acute"),
}

DECLINED_FAMILIES = {
    **TRUE, **FALSE_BUT_DECLINED,
    "tree-size--4097-leaves": edit(ONE, TREE, leaves(4097)),
    "tree-size--path-of-65": edit(ONE, TREE, path(65)),
    "version--3-of-a-family": edit(ONE, ("version",), 3),
    "too-many-digits--family-end": edit(ONE, ("claim", "parameters", 0, "high"), ["closed", [LONG, 1]]),
    "too-many-digits--family-coefficient": edit(ONE, ("claim", "gram", 0, 0), [[LONG, 0]]),
    "degree--family": edit(ONE, ("claim", "field"), {
        "polynomial": [-3, *[0] * 8, 1], "root": {"low": 1, "high": 2, "denominator": 1}}),
    # The area is a product with 2^12 coefficients.
    "too-many-simplices--family--limit-simplices-1": ONE,
    "work--family-of-12-parameters--limit-work-1000": plane(
        {f"x{k}": closed(0, 1) for k in range(12)}, [[product_of(MANY[:6]), 0], [0, product_of(MANY[6:])]]).certificate(),
}
