"""Families of which something is false: in an end, at a point inside, or everywhere."""
from fractions import Fraction as F

from .build import edit, largest, ratio, smallest
from .family import Family, closed, halved, of_tiling, opened
from .polynomial import variables
from .regions import cells
from .tilings import BCC, SQRT3, SQUARE_GRAM, a15, block, kuhn, lattice, polygon, square_triangle, strip_of_height, tetrahedron
from .valid_families import (UNIT, X, XY, X_, Y_, acute_triangles, corner_moved, cut_square, goldberg, isosceles, plane, selling,
                             stretched, strip, tetrahedron_moved, with_cosine)
from .wrong import (NINETY, SIXTY, TINY, cube_with_faces, double_cover, far_point_with_flat_faces, fan, mirrored, other_side_of_a_face,
                    overlaid, repeated, star, together, with_vertex, without)

HALF = F(1, 2)
HALF_OPEN = (("open", 0), ("closed", 1))
LOW_OPEN = (("closed", 0), ("open", 1))


def metric(entry, tree=(), **parameters):
    """Rectangles with this square of a side."""
    return plane(parameters or {"x": closed(0, 1)}, [[entry, 0], [0, 1]], tree).certificate()


METRIC = {
    "gram-not-positive--family-zero-at-the-low-end": metric(X),
    "gram-not-positive--family-zero-at-the-high-end": metric(1 - X),
    "gram-not-positive--family-zero-in-the-middle": metric((X - HALF) ** 2),
    "gram-not-positive--family-zero-in-the-middle-of-a-leaf": metric((4 * X - 1) ** 2, halved(0)),
    "gram-not-positive--family-zero-where-leaves-meet": metric((2 * X - 1) ** 2, halved(0), x=opened(0, 1)),
    "gram-not-positive--family-zero-in-one-corner": metric(X_ + Y_, **UNIT),
    "gram-not-positive--family-zero-on-a-side": metric(X_ * Y_, x=closed(0, 1), y=HALF_OPEN),
    "gram-not-positive--family-zero-in-the-other-corner": metric(2 - X_ - Y_, x=HALF_OPEN, y=HALF_OPEN),
    "gram-not-positive--family-negative-inside": metric((X - F(1, 4)) * (X - F(3, 4)) * 16),
    "gram-not-positive--family-hardly-negative": metric(X - TINY, x=closed(0, 1)),
    "gram-not-positive--family-determinant": with_cosine(X).certificate(),
    "gram-not-positive--family-determinant-at-minus-one": with_cosine(X, x=closed(-1, HALF)).certificate(),
    "gram-not-positive--family-over-sqrt-3": plane(
        {"x": closed(0, [0, 1])}, [[variables(1, SQRT3)[0] * -1 + [0, 1], 0], [0, 1]], field=SQRT3).certificate(at=[F(1, 4)]),
}

ORIENTED = {
    "orientation--family-flat-at-the-closed-end": cut_square((X, HALF), x=closed(0, HALF)).certificate(),
    "orientation--family-flat-in-a-corner-of-the-box": cut_square((X_, Y_), x=closed(0, HALF), y=closed(HALF, F(3, 4))).certificate(),
    "orientation--family-flat-in-the-middle": cut_square(((2 * X - 1) ** 2, HALF), halved(0), x=closed(F(1, 4), F(3, 4))).certificate(
        at=[F(0)]),
    "vertex-outside--family-beyond-the-low-end": cut_square((X, HALF), x=opened(-1, HALF)).certificate(at=[F(3, 4)]),
    "vertex-outside--family-beyond-in-the-middle": cut_square((HALF, (2 * X - 1) ** 2 - F(1, 100)), x=closed(F(1, 8), F(7, 8))).certificate(
        at=[F(0)]),
    "orientation--family-always-negative": of_tiling(mirrored(lattice([[2, 1], [1, 2]]))).certificate(oriented=False),
    "volume-sum--family-overlaid": of_tiling(overlaid()).certificate("acute"),
    "volume-sum--family-double-cover": of_tiling(double_cover(), halved(0)).certificate(),
    "volume-sum--family-solid-twice": of_tiling(together(block(3, 3), block(3, 3))).certificate(),
    "volume-sum--family-strip-over-sqrt-3-twice":
        of_tiling(together(strip_of_height([0, 1], SQRT3), strip_of_height([0, 1], SQRT3))).certificate(),
    "volume-sum--family-a15-twice": of_tiling(together(a15(), a15())).certificate(),
    "open-facet--family-tetrahedron-missing": of_tiling(without(kuhn(BCC), 5)).certificate(),
    "facet-side--family-row-twice": of_tiling(repeated(kuhn(BCC), 0, 1)).certificate(),
    # The vertex is in the strip's side at h = 1 only.
    "open-facet--family-in-the-boundary-at-the-end-only": Family(
        {"h": closed(HALF, 1)}, SQUARE_GRAM, [[0, 0], [0, X]], strip(X, *closed(HALF, 1)).simplices,
        ("slab", [[0], [1]], [[0], [1]])).certificate(),
}


def quadrilateral(*ends, tree=()):
    """A solid with the corner (x, x); its two triangles have the diagonal to it."""
    corners = [[0, 0], [1, 0], [X, X], [0, 1]]
    return Family({"x": ends}, SQUARE_GRAM, corners, [[[0], [1], [2]], [[0], [2], [3]]], ("solid", *polygon(*corners)), tree=tree)


DOMAINS = {
    "face-not-facet--family-strip-without-height-at-the-end": strip(X, *closed(0, 1)).certificate(),
    "face-not-facet--family-strip-without-height-in-the-middle": strip((X - 1) ** 2, *closed(0, 2)).certificate(at=[F(0)]),
    "face-not-facet--family-straight-corner-at-the-end": quadrilateral(*closed(HALF, 1)).certificate(at=[F(1)]),
    "face-not-facet--family-dent": quadrilateral(*closed(F(1, 4), 1)).certificate(at=[F(1)]),
    "face-not-facet--family-flat-tetrahedron": Family(
        {"x": closed(0, 1)}, [[1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, X]], [[[0], [1], [2], [3]]],
        ("solid", [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, X]], tetrahedron().domain[2])).certificate(),
}

STATEMENTS = {
    "not-acute--family-right-at-the-low-end": with_cosine(X, x=closed(0, HALF)).certificate("acute"),
    "not-acute--family-right-at-the-high-end": with_cosine(HALF - X, x=closed(0, HALF)).certificate("acute"),
    "not-acute--family-right-in-the-middle": with_cosine((X - F(1, 3)) ** 2, x=closed(0, F(2, 3))).certificate("acute"),
    "not-acute--family-right-everywhere": plane({"x": closed(1, 2)}, [[X, 0], [0, 1]]).certificate("acute"),
    "not-acute--family-right-on-a-closed-side": plane(
        {"x": LOW_OPEN, "y": closed(F(1, 4), F(3, 4))}, [[Y_, X_ * Y_], [X_ * Y_, 1 - Y_ + X_ * Y_]]).certificate("acute"),
    "not-acute--family-right-in-a-corner": with_cosine((X_ + Y_) / 4, **UNIT).certificate("acute"),
    "not-acute--family-obtuse-in-a-leaf": with_cosine(X - F(1, 8), halved(0, 0), x=closed(0, HALF)).certificate("acute"),
    "not-acute--family-goldberg": goldberg().certificate("acute"),
    "not-acute--family-tetrahedra-right-everywhere": of_tiling(kuhn(BCC)).certificate("acute"),
    "not-acute--family-triangle-at-the-end": corner_moved(*LOW_OPEN).certificate("acute"),
    "not-acute--family-over-sqrt-3": of_tiling(square_triangle()).certificate("acute"),
    "not-nonobtuse--family-goldberg-beyond": goldberg(("open", 0), ("closed", F(1001, 1000))).certificate("nonobtuse"),
    "not-nonobtuse--family-goldberg-beyond-an-open-end": goldberg(*opened(0, 3)).certificate("nonobtuse"),
    "not-nonobtuse--family-hardly": with_cosine(X - TINY, x=closed(0, HALF)).certificate("nonobtuse"),
    "not-nonobtuse--family-below-zero-in-the-middle": with_cosine((X - HALF) ** 2 - TINY).certificate("nonobtuse"),
    "not-delaunay--family-selling-closed": selling("closed").certificate("Delaunay"),
    "not-delaunay--family-right-in-the-middle": with_cosine((X - HALF) ** 2).certificate("Delaunay"),
    "none-inside--family-right-at-the-end": with_cosine(X, x=closed(-HALF, 0)).certificate("not Delaunay"),
    "none-inside--family-acute-at-the-end": with_cosine(X, halved(0), x=closed(-HALF, F(1, 4))).certificate("not Delaunay"),
    "none-inside--family-acute": with_cosine(X, x=closed(F(1, 4), HALF)).certificate("not Delaunay"),
    "none-inside--family-right-in-the-middle": with_cosine(-(X - HALF) ** 2).certificate("not Delaunay"),
    "not-weakly-delaunay--family-obtuse-at-the-end": with_cosine(X - F(1, 4), x=closed(0, HALF)).certificate(
        "weakly Delaunay"),
    "not-weakly-delaunay--family-obtuse-at-the-low-end": plane({"x": closed(0, HALF)}, [[1, X - F(1, 3)], [X - F(1, 3), 2]]).certificate("weakly Delaunay"),
}


def relation_name(name, relation):
    return f"{name}-{relation.replace(' ', '-')}"


def wrong_bounds():
    """Each relation of each quantity, of isosceles triangles (see there): in an end, or by little in an end."""
    sixth, quarter = F(1, 6), F(1, 4)
    # Values at t = 0 and at t = 1; the squared cosine falls where the angle grows.
    cases = {
        "largest": (largest, "angle-bound", (1, quarter), (1, sixth), -1),
        "smallest": (smallest, "angle-bound", (1, F(4, 9)), (1, quarter), -1),
        "ratio": (ratio, "ratio-bound", (F(1, 3),), (F(9, 20),), 1),
    }
    for name, (make, code, least, greatest, way) in cases.items():
        below = (*greatest[:-1], greatest[-1] - way * TINY)
        above = (*least[:-1], least[-1] + way * TINY)
        for relation, bound in (("less than", greatest), ("at most", below), ("more than", least), ("at least", above)):
            yield f"{code}--family-{relation_name(name, relation)}", isosceles().certificate(make(relation, *bound))
        for relation, bound in (("maximum", greatest), ("minimum", least)):
            yield f"not-attained--family-{relation_name(name, relation)}-in-an-end-only", isosceles().certificate(make(relation, *bound))
            out = (*bound[:-1], bound[-1] + (way if relation == "maximum" else -way) * TINY)
            yield f"not-attained--family-{relation_name(name, relation)}-never", isosceles().certificate(make(relation, *out))


BOUNDS = {
    **dict(wrong_bounds()),
    # The largest angle is 60 degrees at t = 1/2, more before and after it.
    "not-attained--family-in-the-middle-only": plane({"t": closed(0, 1)}, [[2, 1], [1, 2 + (2 * X - 1) ** 2]], halved(0)).certificate(
        largest("minimum", *SIXTY)),
    "angle-bound--family-sign-of-the-cosine-changes": with_cosine(X, x=closed(-HALF, HALF)).certificate(largest("at most", *NINETY)),
    "angle-bound--family-obtuse-to-the-end": with_cosine(X, x=closed(-HALF, 0)).certificate(largest("less than", -1, F(1, 4))),
    "angle-bound--family-at-least-obtuse": with_cosine(X, x=closed(-HALF, 0)).certificate(largest("more than", *NINETY)),
    "angle-bound--family-a15": stretched(a15(), F(99, 100), F(101, 100)).certificate(largest("at most", 1, F(1, 25))),
    "edge-valence--family-a15": edit(
        stretched(a15(), F(99, 100), F(101, 100)).certificate("TCP"), ("witness", "simplices", 0, 4), 0),
    "triangle-valence--family-a15": edit(
        stretched(a15(), F(99, 100), F(101, 100)).certificate("TCP"), ("witness", "simplices", 0, 4), 3),
}

FALSE_FAMILIES = {**METRIC, **ORIENTED, **DOMAINS, **STATEMENTS, **BOUNDS}
