"""Certificates of false claims, and witnesses that do not prove their claims."""
from dataclasses import replace
from fractions import Fraction as F

from .build import Tiling, edges, edit, exchange_last, largest, ratio, smallest, uncrossed
from .false_regions import MESH, REGIONS, VOID
from .regions import CORNER, beside, cells, lone, periodic, region, small
from .tilings import (BCC, CUBE, CUBE_CORNERS, CUBE_FACES, HEXAGONAL, ROOT, SQRT3, SQUARE, SQUARE_GRAM, a15, a15_split, block,
                      chambers, kuhn, lattice, polygon, root_power, solid, square_triangle, strip_of_height, tetrahedron, times_root,
                      moved_to_53_bits, z_contracted)
from .wrong import (FIELD, GRAM, HUNDRED_TWENTY, NINETY, ROWS, SIXTY, TINY, copies, cube_with_a_vertex_on_an_edge, cube_with_faces,
                    double_cover, fan, far_point_with_flat_faces, fold, in_domain, mirrored, moved, other_side_of_a_face, overlaid,
                    repeated, star, together, with_vertex, without, wrong_bounds)

E, C6, K, A = lattice(HEXAGONAL), kuhn(CUBE), square_triangle(), a15()
SQUARES, OBTUSE, RIGHT_3_4_5 = lattice(SQUARE_GRAM), lattice([[4, -3], [-3, 4]]), lattice([[9, 0], [0, 16]])
LONG_DIAGONAL = lattice([[2, -1], [-1, 2]])
STRIP, SLAB, PRISM, SOLID = block(2, 1), block(3, 1), block(3, 2), block(3, 3)
PLANE_MESH, ROD, PERFORATED = region(*cells((0, 0), (1, 0))), periodic((1,), (0, 0)), periodic((2, 2, 2), *VOID)


# --- pairing ----------------------------------------------------------------------------

def boundary_without(tiling, *which):
    return tiling.certificate(boundary=[facet for i, facet in enumerate(tiling.boundary()) if i not in which])


def boundary_reversed(tiling, i):
    facets = tiling.boundary()
    return tiling.certificate(boundary=[*facets[:i], exchange_last(facets[i]), *facets[i + 1:]])


def boundary_with(tiling, *facet):
    return tiling.certificate(boundary=[*tiling.boundary(), list(facet)])


def vertex_with_two_names():
    """The second triangle has a vertex of its own at the place of the origin."""
    return replace(E, vertices=[[0, 0], [0, 0]], simplices=[E.simplices[0], [[0, 0, 0], [0, 1, -1], [1, 1, 0]]]).certificate()


def void_not_listed():
    """A cell with a void and a small tetrahedron in it: only the tetrahedron's facets are listed."""
    tiling = periodic((2, 2, 2), *VOID, extra=[small(F(5, 4), F(5, 4), F(5, 4))[0]])
    first = len(PERFORATED.vertices)
    return tiling.certificate(boundary=[facet for facet in tiling.boundary() if facet[0][0] >= first])


APART = region(*beside(CORNER, lone((9, 0, 0), (10, 0, 0), (9, 1, 0), (9, 0, 1))))
APART_IN_THE_PLANE = region(*beside(lone((0, 0), (4, 0), (0, 4)), lone((6, 0), (7, 0), (6, 1))))
TRIANGLES_IN_A_ROW = Tiling(SQUARE_GRAM, [[0, 0], [F(1, 2), 1]], [[[0, 0], [0, 1], [1, 0]]], ("region", 1))

PAIRING = {
    "facet-side--row-twice": repeated(C6, 0, 1).certificate(),
    "facet-side--folded": replace(E, simplices=[E.simplices[0]] * 2).certificate(),
    "facet-side--one-row-in-the-mirror": mirrored(E, 1).certificate(),
    "facet-side--tetrahedron-in-the-mirror": mirrored(C6, 5).certificate(),
    "facet-side--over-sqrt-3": mirrored(K, 3).certificate(),
    "facet-side--region-folded": fold((1, 1, 1)).certificate(),
    "facet-side--region-in-the-mirror": mirrored(MESH, 5).certificate(boundary=MESH.boundary()),
    "facet-side--boundary-facet-reversed": boundary_reversed(MESH, 4),
    "facet-side--boundary-facet-reversed-in-the-plane": boundary_reversed(PLANE_MESH, 3),
    "facet-side--boundary-facet-reversed-of-rank-1": boundary_reversed(ROD, 1),
    "facet-side--boundary-facet-reversed-of-rank-3": boundary_reversed(PERFORATED, 7),
    "open-facet--row-missing": without(C6, 5).certificate(),
    "open-facet--first-row-missing": without(A, 0).certificate(),
    "open-facet--row-once-more-at-the-end": repeated(C6, 0, 6).certificate(),
    "open-facet--one-triangle": without(E, 1).certificate(),
    # Row 1 was [0,[0,1,-1],[0,1,0]]; the new triangle is positive, too.
    "open-facet--shift": edit(E.certificate(), (*ROWS, 1, 2), [0, 2, 0]),
    "open-facet--vertex-with-two-names": vertex_with_two_names(),
    "open-facet--hole-in-a-solid": without(SOLID, 3).certificate(),
    "open-facet--hole-in-a-prism": without(PRISM, 1).certificate(),
    "open-facet--slab-too-high": in_domain(SLAB, "slab", [[0], [2]], [[0], [1]]).certificate(),
    "open-facet--half-of-a-square-twice": copies(block(2, 2), 0, 0).certificate(),
    "open-facet--one-tetrahedron-of-a-cube-six-times": copies(SOLID, *[0] * 6).certificate(),
    # The edge from (0, 0) to (1, 1) has its ends in two sides, but in no common one.
    "open-facet--half-of-a-square": without(block(2, 2), 1).certificate(),
    "open-facet--boundary-facet-missing": boundary_without(MESH, 5),
    "open-facet--boundary-facet-missing-in-the-plane": boundary_without(PLANE_MESH, 2),
    "open-facet--boundary-facet-missing-of-rank-1": boundary_without(ROD, 0),
    "open-facet--boundary-facet-missing-of-rank-2": boundary_without(periodic((1, 1), (0, 0, 0)), 0),
    "open-facet--boundary-facet-missing-of-rank-3": boundary_without(PERFORATED, 11),
    "open-facet--all-but-one-missing": boundary_without(MESH, *range(1, 12)),
    "open-facet--void-not-listed": void_not_listed(),
    "boundary-open--between-two-pieces": boundary_with(APART, (1,), (2,), (4,)),
    "boundary-open--between-two-pieces-reversed": boundary_with(APART, (1,), (4,), (2,)),
    "boundary-open--between-two-pieces-in-the-plane": boundary_with(APART_IN_THE_PLANE, (1,), (3,)),
    "boundary-open--between-translates": boundary_with(TRIANGLES_IN_A_ROW, (1, 0), (1, 1)),
}

# --- orientation and volume -----------------------------------------------------------------

GEOMETRY = {
    "orientation--all-negative": mirrored(E).certificate(),
    "orientation--all-negative-tetrahedra": mirrored(C6).certificate(),
    "orientation--all-negative-over-sqrt-3": mirrored(K).certificate(),
    "orientation--all-negative-solid": mirrored(SOLID).certificate(),
    "orientation--region-all-negative": mirrored(MESH).certificate(),
    "orientation--plane-region-all-negative": mirrored(PLANE_MESH).certificate(),
    # The inner vertex of a fan moved into its side: one triangle is flat; and beyond: one is negative.
    "orientation--flat": with_vertex(fan(), 1, F(1, 2), F(1, 2)).certificate(),
    "orientation--folded-over": with_vertex(fan(), 1, F(2, 3), F(2, 3)).certificate(),
    "orientation--hardly-negative": with_vertex(fan(), 1, F(1, 2) + TINY, F(1, 2)).certificate(),
    "volume-sum--overlaid": overlaid().certificate(),
    "volume-sum--overlaid-and-acute": overlaid().certificate("acute"),
    "volume-sum--connected-double-cover": double_cover().certificate(),
    "volume-sum--solid-twice": together(SOLID, SOLID).certificate(),
    "volume-sum--slab-twice": together(SLAB, SLAB).certificate(),
    "volume-sum--prism-twice": together(PRISM, PRISM).certificate(),
    "volume-sum--tetrahedron-twice": together(tetrahedron(), tetrahedron()).certificate(),
    "volume-sum--strip-over-sqrt-3-twice":
        together(strip_of_height(ROOT, SQRT3), strip_of_height(ROOT, SQRT3)).certificate(),
    "volume-sum--a15-twice": together(A, A).certificate("acute"),
    "volume-sum--coordinates-of-53-bits-twice": together(moved_to_53_bits(A), moved_to_53_bits(A)).certificate("acute"),
}

# --- statements -------------------------------------------------------------------------------

TIMES_SQRT_3 = times_root(SQRT3)
DEGREE_8 = lattice([[1, 0], [0, ROOT]], root_power(8))

BOUNDS = {
    **dict(wrong_bounds()),
    "angle-bound--60-over-sqrt-3": TIMES_SQRT_3.certificate(largest("less than", *SIXTY)),
    "angle-bound--90-exactly-90": C6.certificate(largest("less than", *NINETY)),
    "angle-bound--90-over-sqrt-3": K.certificate(largest("less than", *NINETY)),
    "angle-bound--120-exactly-120": LONG_DIAGONAL.certificate(largest("less than", *HUNDRED_TWENTY)),
    # The cosine -3/4: 135 degrees are less, 142.2 more, and so are the angles with the same squares and the other sign.
    "angle-bound--obtuse-at-most-135": OBTUSE.certificate(largest("at most", -1, F(1, 2))),
    "angle-bound--obtuse-at-most-90": OBTUSE.certificate(largest("at most", *NINETY)),
    "angle-bound--obtuse-at-most-41": OBTUSE.certificate(largest("at most", 1, F(9, 16))),
    "angle-bound--obtuse-at-least-142": OBTUSE.certificate(largest("at least", -1, F(5, 8))),
    "angle-bound--obtuse-at-least-180": OBTUSE.certificate(largest("at least", -1, 1)),
    "angle-bound--obtuse-at-most-0": OBTUSE.certificate(largest("at most", 1, 1)),
    "angle-bound--smallest-at-least-120": OBTUSE.certificate(smallest("at least", *HUNDRED_TWENTY)),
    "angle-bound--smallest-is-not-the-largest": C6.certificate(smallest("at least", *SIXTY)),
    "angle-bound--largest-is-not-the-smallest": C6.certificate(largest("at most", *SIXTY)),
    # arccos(1/5) is 78.46304096718...; the bound's cosine is larger by 10^-30.
    "angle-bound--a15": A.certificate(largest("at most", 1, (F(1, 5) + TINY) ** 2)),
    "angle-bound--a15-not-less-than-itself": A.certificate(largest("less than", 1, F(1, 25))),
    "angle-bound--a15-smallest": A.certificate(smallest("more than", 1, F(9, 25))),
    "angle-bound--only-the-last-triangle":
        replace(K, simplices=K.simplices[2:] + K.simplices[:2]).certificate(largest("less than", *NINETY)),
    "angle-bound--region": MESH.certificate(largest("less than", *NINETY)),
    "angle-bound--region-of-rank-3": PERFORATED.certificate(smallest("more than", 1, F(1, 2))),
    "angle-bound--bound-in-the-field": K.certificate(smallest("at least", 1, [F(1, 2), F(-1, 4)])),
    "angle-bound--second-bound-of-three":
        E.certificate(largest("less than", *NINETY), largest("at least", *NINETY), smallest("maximum", *SIXTY)),
    "angle-bound--degree-8": DEGREE_8.certificate(smallest("at least", 1, F(478, 1000))),
    "ratio-bound--3-4-5-exactly": RIGHT_3_4_5.certificate(ratio("less than", F(25, 36))),
    "ratio-bound--3-4-5": RIGHT_3_4_5.certificate(ratio("at most", F(9, 25))),
    "ratio-bound--not-squared": RIGHT_3_4_5.certificate(ratio("at least", F(5, 6))),
    "ratio-bound--tetrahedron": tetrahedron().certificate(ratio("less than", F(3, 8))),
    "ratio-bound--over-sqrt-3": K.certificate(ratio("less than", F(1, 2))),
    "ratio-bound--region": MESH.certificate(ratio("at least", F(3, 4) + TINY)),
    # R^2 / l^2 is (1 + a) / 4 for a = 2^(1/8) = 1.0905...
    "ratio-bound--degree-8": DEGREE_8.certificate(ratio("at most", F(5226, 10000))),
    # Kuhn's tetrahedra have angles of 60 degrees, but neither the largest nor the smallest.
    "not-attained--by-an-angle-between-as-largest": C6.certificate(largest("minimum", *SIXTY)),
    "not-attained--by-an-angle-between-as-smallest": C6.certificate(smallest("maximum", *SIXTY)),
    "not-attained--same-square-of-the-other-sign": E.certificate(largest("maximum", *HUNDRED_TWENTY)),
    "not-attained--maximum-of-the-smallest-by-the-largest": K.certificate(smallest("maximum", *NINETY)),
    "not-attained--one-of-several":
        K.certificate(largest("maximum", *NINETY), largest("minimum", 1, F(1, 2)), smallest("minimum", 1, F(1, 2))),
    "not-attained--over-sqrt-3": TIMES_SQRT_3.certificate(largest("maximum", 1, [F(1, 2), F(-1, 4)])),
    "not-attained--region": MESH.certificate(ratio("maximum", 1)),
    "not-attained--degree-8": DEGREE_8.certificate(ratio("maximum", F(5227, 10000))),
}


def sheared(tiling):
    """The third direction inclined: Kuhn's tetrahedra of this parallelepiped are not Delaunay."""
    scale = [row[i] for i, row in enumerate(tiling.gram)]
    gram = [[F(g) for g in row] for row in tiling.gram]
    gram[0][2] = gram[2][0] = F(scale[0], 2)
    return replace(tiling, gram=gram)


DEGREE_5 = lattice([[1, 0], [0, ROOT]], root_power(5))

STATEMENTS = {
    "not-acute--cube-6": C6.certificate("acute"),
    "not-acute--bcc-right-angles": kuhn(BCC).certificate("acute"),
    "not-acute--right-angles-over-sqrt-3": K.certificate("acute"),
    "not-acute--right-angles-of-degree-5": DEGREE_5.certificate("acute"),
    "not-acute--square": SQUARES.certificate("acute"),
    "not-acute--obtuse": OBTUSE.certificate("acute"),
    "not-acute--region": MESH.certificate("acute"),
    "not-acute--plane-region": PLANE_MESH.certificate("acute"),
    "not-acute--only-the-last-triangle": replace(K, simplices=K.simplices[2:] + K.simplices[:2]).certificate("acute"),
    "not-nonobtuse--obtuse": OBTUSE.certificate("nonobtuse"),
    "not-nonobtuse--hardly": lattice([[1000000, -1], [-1, 1000000]]).certificate("nonobtuse"),
    "not-nonobtuse--hardly-beyond-64-bits": lattice([[10**40, -1], [-1, 10**40]]).certificate("nonobtuse"),
    "not-nonobtuse--sheared-region": sheared(MESH).certificate("nonobtuse"),
    "not-delaunay--square-cospherical": SQUARES.certificate("Delaunay"),
    "not-delaunay--square-cospherical-over-sqrt-3": K.certificate("Delaunay"),
    "not-delaunay--cube-cospherical": C6.certificate("Delaunay"),
    "not-delaunay--slab-cospherical": SLAB.certificate("Delaunay"),
    "not-delaunay--wrong-diagonal": LONG_DIAGONAL.certificate("Delaunay"),
    "not-delaunay--locally-cospherical": MESH.certificate("locally Delaunay"),
    "not-delaunay--locally-cospherical-in-the-plane": PLANE_MESH.certificate("locally Delaunay"),
    "not-delaunay--locally-cospherical-of-rank-1": ROD.certificate("locally Delaunay"),
    "not-delaunay--locally-cospherical-of-rank-3": PERFORATED.certificate("locally Delaunay"),
    "none-inside--square-cospherical": SQUARES.certificate("not Delaunay"),
    "none-inside--cube-cospherical": C6.certificate("not Delaunay"),
    "none-inside--one-simplex-over-sqrt-3": K.certificate("not Delaunay"),
    "none-inside--region": MESH.certificate("not Delaunay"),
    "none-inside--with-weakly": C6.certificate("weakly Delaunay", "not Delaunay"),
    "not-weakly-delaunay--with-not": LONG_DIAGONAL.certificate("weakly Delaunay", "not Delaunay"),
    "not-weakly-delaunay--wrong-diagonal": LONG_DIAGONAL.certificate("weakly Delaunay"),
    "not-weakly-delaunay--sheared-cube": sheared(C6).certificate("weakly Delaunay"),
    "not-weakly-delaunay--locally-wrong-diagonal":
        region(*cells((0, 0)), gram=HEXAGONAL).certificate("locally weakly Delaunay"),
    "not-weakly-delaunay--locally-sheared-cube": sheared(MESH).certificate("locally weakly Delaunay"),
    "not-weakly-delaunay--locally-sheared-of-rank-3": sheared(PERFORATED).certificate("locally weakly Delaunay"),
}

# --- planes -----------------------------------------------------------------------------------

PLANES = {
    "plane-crossed--half-way": E.certificate(uncrossed((1, 0), 1, 2)),
    "plane-crossed--far-translate": E.certificate(uncrossed((1, 0), 41, 2)),
    "plane-crossed--other-diagonal": E.certificate(uncrossed((1, -1), 0), uncrossed((1, 0), 0)),
    "plane-crossed--cube": C6.certificate(uncrossed((1, 1, 0), 0)),
    "plane-crossed--over-sqrt-3": K.certificate(uncrossed((2, 1), 1, 3)),
    "plane-crossed--slab-across": SLAB.certificate(uncrossed((0, 0, 1), 1, 3)),
    "plane-crossed--solid": SOLID.certificate(uncrossed((1, 1, -1), 0)),
    "plane-crossed--region": MESH.certificate(uncrossed((1, 1, 0), 1, 2)),
}

# --- TCP ---------------------------------------------------------------------------------------

A_TCP = A.certificate("TCP")
HINTS = [row[-1] for row in A_TCP["witness"]["simplices"]]


def with_hint(row, hint):
    return edit(A_TCP, (*ROWS, row, 4), hint)


def first_with(*hints, odd=None):
    return next(i for i, row in enumerate(A.rows()) if HINTS[i] in hints and odd in (None, row != sorted(row)))


# The opposite edge of edge p is 5 - p.
SINGLE = first_with(1, 2, 4, 8, 16, 32)
SIDEWAYS = first_with(2, 4, 8, 16, odd=True)

TCP = {
    "edge-valence--hint-missing": with_hint(SINGLE, 0),
    "edge-valence--hint-of-an-edge-in-5": with_hint(first_with(0), 4),
    "edge-valence--hint-of-the-opposite-edge": with_hint(SINGLE, 32 // HINTS[SINGLE]),
    "edge-valence--hint-with-the-opposite-edge": with_hint(SINGLE, HINTS[SINGLE] + 32 // HINTS[SINGLE]),
    "edge-valence--hint-of-the-corners-as-listed": with_hint(SIDEWAYS, {2: 4, 4: 2, 8: 16, 16: 8}[HINTS[SIDEWAYS]]),
    "edge-valence--no-hints": A.certificate("TCP", sixes=lambda valence: False),
    "edge-valence--no-hints-in-bcc": kuhn(BCC).certificate("TCP", sixes=lambda valence: False),
    "edge-valence--no-hints-in-the-cube": C6.certificate("TCP", sixes=lambda valence: False),
    "edge-valence--no-hints-in-chambers": chambers().certificate("TCP", sixes=lambda valence: False),
    "triangle-valence--z-with-an-edge-contracted": z_contracted().certificate("TCP"),
    "triangle-valence--hint-of-two-edges-at-a-corner": with_hint(0, 3),
    "triangle-valence--hint-of-all-edges": with_hint(0, 63),
    "triangle-valence--all-hints": A.certificate("TCP", sixes=lambda valence: True),
}


def split_with_old_hints():
    """The hints of A15; the last tetrahedron, cut into four, has its old ones, and none at its centre."""
    split = a15_split()
    certificate = split.certificate("TCP", sixes=lambda valence: False)
    old = {edge: bit for row, hint in zip(A.rows(), HINTS) for bit, edge in
           ((hint >> p & 1, edge) for p, edge in enumerate(edges(row)))}
    for row, listed_row in zip(split.rows(), certificate["witness"]["simplices"]):
        listed_row[-1] = sum(old.get(edge, 0) << p for p, edge in enumerate(edges(row)))
    return certificate


TCP["edge-valence--a15-with-one-tetrahedron-cut"] = split_with_old_hints()

# --- claims -----------------------------------------------------------------------------------

MOVED_CORNER = [*CUBE_CORNERS[:7], [1, 1, 2]]
FLAT_SOLID = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
DART = [[0, 0], [4, 0], [1, 1], [0, 4]]


def root(polynomial, low, high, denominator=1):
    return edit(K.certificate(
        ), FIELD, {"polynomial": polynomial, "root": {"low": low, "high": high, "denominator": denominator}})


def square(corners, faces):
    return in_domain(block(2, 2), "solid", corners, faces).certificate()


def slab(corners, faces):
    return in_domain(SLAB, "slab", corners, faces).certificate()


CLAIMS = {
    "face-not-facet--dart": solid(SQUARE_GRAM, polygon(*DART), DART, [[0, 1, 2], [0, 2, 3]]).certificate(),
    "face-not-facet--polygon-in-star-order":
        in_domain(PRISM, "prism", SQUARE[0], [[0, 2], [2, 1], [1, 3], [3, 0]]).certificate(),
    "face-not-facet--vertex-on-a-side": square(
        [[0, 0], [1, 0], [1, 1], [0, 1], [1, F(1, 2)]], [[0, 1], [1, 4], [4, 2], [2, 3], [3, 0]]),
    "face-not-facet--far-point-with-flat-faces": far_point_with_flat_faces(),
    "face-not-facet--not-planar": cube_with_faces(CUBE_FACES, MOVED_CORNER),
    "face-not-facet--flat-solid": cube_with_faces([[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]], FLAT_SOLID),
    "face-not-facet--flat-solid-and-one-face-with-all":
        cube_with_faces([[0, 1, 2, 3], [0, 1, 3], [0, 2, 3], [1, 2, 3]], FLAT_SOLID),
    "face-not-facet--slab-without-height": slab([[0], [0]], [[0], [1]]),
    "face-not-facet--third-plane-of-a-slab": slab([[0], [1], [F(1, 2)]], [[0], [1], [2]]),
    "face-not-facet--inner-face": cube_with_faces([*CUBE_FACES, [0, 1, 7, 6]]),
    "face-not-facet--quadrilateral-as-two-triangles": cube_with_faces([*CUBE_FACES[1:], [0, 1, 3], [0, 3, 2]]),
    "face-not-convex--bow-tie": cube_with_faces([[0, 1, 2, 3], *CUBE_FACES[1:]]),
    "face-not-convex--star": star(),
    "face-not-convex--vertex-on-an-edge": cube_with_a_vertex_on_an_edge(),
    "faces-not-closed--cube-without-one": cube_with_faces(CUBE_FACES[:5]),
    "faces-not-closed--cube-without-the-first": cube_with_faces(CUBE_FACES[1:]),
    "faces-not-closed--two-opposite-missing": cube_with_faces(CUBE_FACES[2:]),
    "faces-not-closed--side-missing": in_domain(PRISM, "prism", SQUARE[0], SQUARE[1][:3]).certificate(),
    "denominator-domain--slab-of-height-3-2": slab([[0], [F(3, 2)]], [[0], [1]]),
    "denominator-domain--square-with-a-corner-moved": square([[0, 0], [1, 0], [1, 1], [0, F(4, 3)]], SQUARE[1]),
    "denominator-domain--multiple-the-other-way":
        in_domain(moved(SLAB, [F(1, 2), 0, 0]), "slab", [[0], [F(5, 4)]], [[0], [1]]).certificate(),
    "vertex-outside--equal-area-beyond-a-side": other_side_of_a_face(),
    "vertex-outside--solid-moved": moved(SOLID, [1, 0, 0]).certificate(),
    "vertex-outside--slightly": with_vertex(SOLID, 7, 1, 1, 1 + F(1, 10**6)).certificate(),
    "vertex-outside--slab-too-low": with_vertex(SLAB, 1, 0, 0, 2).certificate(),
    "vertex-outside--prism-moved": moved(PRISM, [0, 0, -1]).certificate(),
    "vertex-outside--strip-over-sqrt-3": with_vertex(strip_of_height(ROOT, SQRT3), 1, 0, [F(1, 10**6), 1]).certificate(),
    "gram-not-positive--indefinite": lattice([[1, 2], [2, 1]]).certificate(),
    "gram-not-positive--semidefinite": lattice([[1, 1], [1, 1]]).certificate(),
    "gram-not-positive--first-entry-zero": lattice([[0, 1], [1, 1]]).certificate(),
    "gram-not-positive--negative": lattice([[-1, 0], [0, -1]]).certificate(),
    "gram-not-positive--third-minor": kuhn([[1, 0, 0], [0, 1, 1], [0, 1, 1]]).certificate(),
    "gram-not-positive--semidefinite-over-sqrt-3": edit(K.certificate(), GRAM, [[[1, 0], [0, 1]], [[3, 0]]]),
    "gram-not-positive--region": edit(MESH.certificate(), GRAM, [[1, 1, 0], [1, 0], [1]]),
    "root-signs--no-root-and-none-needed": 
        edit(replace(E, field=SQRT3).certificate(), (*FIELD, "root"), {"low": 2, "high": 3, "denominator": 1}),
    "root-signs--no-root": root([-3, 0, 1], 2, 3),
    "root-signs--two-roots": root([-3, 0, 1], -2, 2),
    "root-signs--double-root": root([1, -2, 1], 0, 2),
    "root-signs--root-at-an-end": root([-4, 0, 1], 1, 2),
}

FALSE = {**REGIONS, **PAIRING, **GEOMETRY, **BOUNDS, **STATEMENTS, **PLANES, **TCP, **CLAIMS}
