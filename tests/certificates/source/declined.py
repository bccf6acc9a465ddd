"""Certificates that are declined: by a limit, or because a sign is not decided."""
from dataclasses import replace
from fractions import Fraction as F

from .build import Tiling, edit, largest, ratio, smallest
from .false_regions import MESH, VOID
from .malformed import BARE, DENOMINATOR, E, bound, entry, field
from .field import Q
from .regions import cells, periodic, region
from .tilings import HEXAGONAL, REDUCIBLE, SQUARE_GRAM, TWO, lattice, strip_of_height
from .wrong import GRAM, VERTICES, edited, fan, with_vertex

# Over (x^2 - 2)(x^2 - 3) with the root sqrt 2: a^2 - 2 is zero, a^2 - 1 is 1, but not as coefficients. At the other
# root, sqrt 3, no factor of a value below is zero; so no multiple of it has zero coefficients alone.
ZERO, ZERO_NEGATED, PLUS_ONE = [-2, 0, 1], [2, 0, -1], [-1, 0, 1]
TWICE_ZERO, ONE_AND_ZERO, MINUS_ONE_AND_ZERO = [-4, 0, 2], [-3, 0, 2], [3, 0, -2]
LONG = 10 ** 2000
OTHER = {"tiles": [{"x": [1, 2]}]}


def reducible(gram):
    return lattice(gram, REDUCIBLE)


RIGHT = reducible([[1, TWICE_ZERO], [TWICE_ZERO, 1]])
OBLIQUE = reducible([[2, MINUS_ONE_AND_ZERO], [MINUS_ONE_AND_ZERO, 2]])
EQUILATERAL = reducible([[2, ONE_AND_ZERO], [ONE_AND_ZERO, 2]])


def reducible_solid(corners, faces):
    """The unit square cut in two; its corners as vertices of the domain may be written otherwise."""
    triangles = [[[0], [1], [2]], [[0], [2], [3]]]
    return Tiling(SQUARE_GRAM, [[0, 0], [1, 0], [1, 1], [0, 1]], triangles, ("solid", corners, faces), REDUCIBLE).certificate()


def version(n):
    return edit(E, ("version",), n)


def flat():
    """A lattice triangle cut into three at a vertex of its side, which is a^2 - 2 beside it."""
    return with_vertex(replace(fan(), field=REDUCIBLE), 1, F(1, 2), [F(1, 2) - 2, 0, 1])


def apart(gap):
    """Two triangles of a region whose edges are parallel with this gap."""
    return region([(0, 0), (1, 0), (0, 1), (0, gap), (1, gap), (0, -1)], [[0, 1, 2], [3, 5, 4]], field=REDUCIBLE)


DECLINED = {
    "too-many-bytes--limit-bytes-100": E,
    "too-many-simplices--limit-simplices-1": E,
    "version--0": version(0),
    "version--1": version(1),
    "version--3": version(3),
    "version--negative": version(-2),
    "version--large": version(2 ** 32 + 2),
    "version--3-and-another-shape": edited(version(3), (("claim",), OTHER), (("witness",), [])),
    "kind--families": edit(E, ("kind",), "families"),
    "kind--empty": edit(E, ("kind",), ""),
    "kind--mosaic-and-another-shape": edited(E, (("kind",), "mosaic"), (("claim",), OTHER), (("witness",), [])),
    "degree--9": field([-3, *[0] * 8, 1], 1, 2),
    "degree--32": field([-3, *[0] * 31, 1], 1, 2),
    "degree--limit-degree-2": field([-3, 0, 0, 1], 1, 2),
    "too-many-digits--coordinate": edited(BARE, (VERTICES, [[LONG, 0]])),
    "too-many-digits--coordinate-negative": edited(BARE, (VERTICES, [[0, -LONG]])),
    "too-many-digits--gram": edit(BARE, (*GRAM, 0, 0), LONG),
    "too-many-digits--denominator": edited(BARE, (DENOMINATOR, LONG), (VERTICES, [[1, 0]])),
    "too-many-digits--denominator-of-the-domain":
        replace(strip_of_height(F(1, LONG), Q), domain=("slab", [[0], [F(1, LONG)]], [[0], [1]])).certificate(),
    "too-many-digits--bound": bound("largest dihedral angle", "less than", 1, [1, LONG]),
    "too-many-digits--polynomial": field([-LONG, 0, 1], 1, 10 ** 1001),
    "too-many-digits--root": field([-3, 0, 1], 1, LONG),
    "too-many-digits--giant": entry(b'"7' + b"0" * 20_000 + b'"'),
    "too-many-digits--limit-bits-100": edit(BARE, GRAM, [[2 ** 101, 1], [2 ** 101]]),
    "work--limit-work-1": MESH.certificate(),
    "work--periodic--limit-work-1": periodic((2, 2, 2), *VOID).certificate(),
    "sign-undecided--gram-zero": reducible([[ZERO, 0], [0, 1]]).certificate(),
    "sign-undecided--gram-zero-negated": reducible([[ZERO_NEGATED, 0], [0, 1]]).certificate(),
    "sign-undecided--right-angle-claimed-acute": RIGHT.certificate("acute"),
    "sign-undecided--right-angle-claimed-nonobtuse": RIGHT.certificate("nonobtuse"),
    "sign-undecided--square-claimed-delaunay": RIGHT.certificate("Delaunay"),
    "sign-undecided--square-claimed-weakly-delaunay": RIGHT.certificate("weakly Delaunay"),
    "sign-undecided--exactly-90-claimed-below-90": RIGHT.certificate(largest("less than", 0, 0)),
    "sign-undecided--exactly-90-claimed-as-maximum": RIGHT.certificate(largest("maximum", 0, 0)),
    "sign-undecided--exactly-120-claimed-below-120": OBLIQUE.certificate(largest("less than", -1, F(1, 4))),
    "sign-undecided--exactly-60-claimed-at-most-60": EQUILATERAL.certificate(largest("at most", 1, F(1, 4))),
    "sign-undecided--exactly-60-claimed-as-minimum": EQUILATERAL.certificate(smallest("minimum", 1, F(1, 4))),
    # The same number, 1/3, written with other coefficients than the squared ratio has.
    "sign-undecided--ratio-of-other-coefficients":
        reducible(HEXAGONAL).certificate(ratio("maximum", [F(-1, 3), 0, F(1, 3)])),
    "sign-undecided--bound-zero": reducible(HEXAGONAL).certificate(ratio("more than", ZERO)),
    "sign-undecided--bound-one": reducible(HEXAGONAL).certificate(largest("less than", -1, PLUS_ONE)),
    "sign-undecided--flat": flat().certificate(),
    "sign-undecided--slab-without-height":
        replace(strip_of_height(1, REDUCIBLE), domain=("slab", [[0], [ZERO]], [[0], [1]])).certificate(),
    "sign-undecided--vertex-in-the-boundary":
        replace(strip_of_height(1, REDUCIBLE), domain=("slab", [[0], [PLUS_ONE]], [[0], [1]])).certificate(),
    "sign-undecided--solid-with-a-vertex-on-a-side": reducible_solid(
        [[0, 0], [1, 0], [1, 1], [0, 1], [PLUS_ONE, F(1, 2)]], [[0, 1], [1, 4], [4, 2], [2, 3], [3, 0]]),
    "sign-undecided--locally-delaunay":
        region(*cells((0, 0)), gram=[[1, TWICE_ZERO], [TWICE_ZERO, 1]], field=REDUCIBLE).certificate("locally Delaunay"),
    "sign-undecided--gap-between-two-boundary-facets": apart(ZERO).certificate(),
    "sign-undecided--rational-root-hit": lattice([[[-2, 1], 0], [0, 1]], TWO).certificate(),
}
