"""Families whose numbers have a common factor that is zero or negative somewhere, and names that are easy to mistake."""
from fractions import Fraction as F

from .family import Family, closed, opened
from .polynomial import variables
from .tilings import SQRT3, SQUARE_GRAM, polygon
from .valid_families import KUHN, UNIT, X, X_, Y_, plane

HALF_OPEN = (("open", 0), ("closed", 1))
LAST_OPEN = (("closed", 0), ("open", [0, 1]))
NEGATIVE = closed(-2, -1)


def scaled_metric(factor, **parameters):
    """Equilateral triangles with the square 2 `factor` of a side."""
    return plane(parameters or {"t": closed(0, 1)}, [[factor * 2, factor], [factor, factor * 2]])


def scaled_space(factor, *ends):
    """The cubic lattice with the square `factor` of a side."""
    return Family({"t": ends}, [[factor if i == j else 0 for j in range(3)] for i in range(3)], [[0, 0, 0]], KUHN)


def scaled_triangle(across, up, *ends):
    """A triangle as a solid, of which the coordinates have factors."""
    corners = [[0, 0], [2 * across, 0], [across, 2 * up]]
    return Family({"t": ends}, SQUARE_GRAM, corners, [[[0], [1], [2]]], ("solid", *polygon(*corners)))


def up_to_root(name, *ends):
    """Rectangles whose sides have the squares 1 and 3 - x²: the last one is zero at √3."""
    x, = variables(1, SQRT3)
    return plane({name: ends}, [[1, 0], [0, x * x * -1 + 3]], field=SQRT3)


def generator_as_factor():
    """Triangles with the squared sides 1, 1 and 2 - √3 x. There is a right angle at x = 0."""
    x, = variables(1, SQRT3)
    half = x * [0, F(1, 2)]
    return plane({"x": closed(0, 1)}, [[1, half], [half, 1]], field=SQRT3)


FACTORS_VALID = {
    "family-plane-common-factor": scaled_metric(X, t=HALF_OPEN).certificate("acute", "Delaunay"),
    "family-plane-common-factor-of-two-parameters": scaled_metric(X_ + Y_, x=closed(0, 1), y=HALF_OPEN).certificate("acute", "Delaunay"),
    "family-plane-common-factor-with-a-double-zero": scaled_metric(X * X, t=opened(0, 1)).certificate("acute", "Delaunay"),
    # Turned by 180 degrees.
    "family-solid-with-two-negative-factors": scaled_triangle(X, X, *NEGATIVE).certificate("acute"),
    "family-plane-up-to-an-algebraic-zero": up_to_root("x", *LAST_OPEN).certificate("nonobtuse"),
    # Over Q there is no generator.
    "family-plane-parameter-named-a": plane({"a": HALF_OPEN}, [[1, 0], [0, X]]).certificate("nonobtuse"),
}

FACTORS_FALSE = {
    "gram-not-positive--family-common-factor-zero-at-the-end": scaled_metric(X).certificate("acute", at=[F(1, 2)]),
    "gram-not-positive--family-common-factor-zero-in-the-middle": scaled_metric((2 * X - 1) ** 2).certificate("acute", at=[F(0)]),
    "gram-not-positive--family-common-factor-zero-in-a-corner": scaled_metric(X_ + Y_, **UNIT).certificate("acute", at=[F(1), F(1)]),
    # The determinant is 3 t².
    "gram-not-positive--family-negative-common-factor": scaled_metric(X, t=NEGATIVE).certificate("acute"),
    "gram-not-positive--family-negative-leading-coefficient": scaled_metric(1 - X, t=closed(0, 2)).certificate("acute", at=[F(0)]),
    # The minors are t, t² and t³.
    "gram-not-positive--family-negative-common-factor-of-space": scaled_space(X, *NEGATIVE).certificate(),
    "gram-not-positive--family-zero-at-an-algebraic-end": up_to_root("x", *closed(0, [0, 1])).certificate("nonobtuse", at=[F(1, 4)]),
    "orientation--family-with-one-negative-factor": scaled_triangle(X, 1, *NEGATIVE).certificate(oriented=False),
    "not-acute--family-with-the-generator-as-a-factor": generator_as_factor().certificate("acute", at=[F(1, 2)]),
}

FACTORS_MALFORMED = {
    "parameter-name--that-of-the-generator": up_to_root("a", *LAST_OPEN).certificate("nonobtuse"),
}

FACTORS_DECLINED = {
    # It is zero at t = 1/3, where nothing tries.
    "sign-undecided--family-common-factor-zero-at-a-third": scaled_metric((3 * X - 1) ** 2).certificate("acute", at=[F(1, 2)]),
}
