"""Ways to spoil a tiling or a certificate, each in one respect."""
import copy
from dataclasses import replace
from fractions import Fraction as F

from .build import Tiling, edit, largest, ratio, smallest
from .regions import CAVITY, region
from .tilings import CUBE_CORNERS, CUBE_FACES, HEXAGONAL, LATTICE_TRIANGLES, SQUARE_GRAM, block, lattice, polygon, solid

GRAM, FIELD, DOMAIN = ("claim", "gram"), ("claim", "field"), ("claim", "domain")
STATEMENTS = ("claim", "statements")
VERTICES, BOUNDARY, ROWS = ("witness", "vertices"), ("witness", "boundary"), ("witness", "simplices")


def in_domain(tiling, kind, vertices, faces):
    return replace(tiling, domain=(kind, vertices, faces))


def cube_with_faces(faces, corners=CUBE_CORNERS):
    return in_domain(block(3, 3), "solid", corners, faces).certificate()


def together(*tilings):
    """Several tilings with the same lattice in one, each with its own vertices."""
    vertices, simplices = [], []
    for tiling in tilings:
        simplices += [[[p[0] + len(vertices), *p[1:]] for p in places] for places in tiling.simplices]
        vertices = vertices + list(tiling.vertices)
    return replace(tilings[0], vertices=vertices, simplices=simplices)


def moved(tiling, by):
    """The same tiling in another place."""
    return replace(tiling, vertices=[[F(x) + b for x, b in zip(v, by)] for v in tiling.vertices])


def copies(tiling, *which):
    """The chosen simplices, each with vertices of its own."""
    return together(*(only(tiling, s) for s in which))


def only(tiling, s):
    """One simplex and its vertices."""
    places = tiling.simplices[s]
    used = [tiling.vertices[p[0]] for p in places]
    return replace(tiling, vertices=used, simplices=[[[i, *p[1:]] for i, p in enumerate(places)]])


def without(tiling, s):
    return replace(tiling, simplices=tiling.simplices[:s] + tiling.simplices[s + 1:])


def repeated(tiling, s, at):
    """One simplex listed once more, before the simplex `at`."""
    simplices = list(tiling.simplices)
    return replace(tiling, simplices=[*simplices[:at], simplices[s], *simplices[at:]])


def mirrored(tiling, *which):
    """Simplices as the mirror shows them: rows and sides are those of the other orientation."""
    simplices = [[*p[:-2], p[-1], p[-2]] if not which or s in which else p for s, p in enumerate(tiling.simplices)]
    return replace(tiling, simplices=simplices)


def with_vertex(tiling, v, *coordinates):
    """One vertex elsewhere, the names and sides as before."""
    return replace(tiling, vertices=[*tiling.vertices[:v], list(coordinates), *tiling.vertices[v + 1:]])


def fan():
    """The lattice triangles of the plane, the first cut into three at its centre, which is vertex 1."""
    third = [[0, 0, 0], [0, 1, 0], [0, 0, 1]]
    simplices = [[[1, 0, 0], third[k], third[(k + 1) % 3]] for k in range(3)] + LATTICE_TRIANGLES[1:]
    return Tiling(HEXAGONAL, [[0, 0], [F(1, 3), F(1, 3)]], simplices).turned()


def overlaid():
    """Two copies of the lattice triangles, one moved: every facet matched, everything covered twice."""
    return together(lattice(HEXAGONAL), moved(lattice(HEXAGONAL), [F(1, 3), F(1, 3)]))


def double_cover():
    """The triangles of two neighbouring cells, with names of the period 2 and shifts of the period 1:
    connected through its facets, and everything covered twice."""
    def place(x, y):
        return [x % 2, x - x % 2, y]
    simplices = []
    for x in (0, 1):
        simplices.append([place(x, 0), place(x + 1, 0), place(x, 1)])
        simplices.append([place(x + 1, 0), place(x + 1, 1), place(x, 1)])
    return Tiling(HEXAGONAL, [[0, 0], [1, 0]], simplices)


def far_point_with_flat_faces():
    """A square, and three more vertices at one point far off, joined by three sides of no length:
    only that sides must be sides shows that the convex hull is larger."""
    corners = [[0, 0], [1, 0], [1, 1], [0, 1]] + 3 * [[10, 10]]
    sides = [[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 4]]
    return in_domain(block(2, 2), "solid", corners, sides).certificate()


def star():
    """A prism over a pentagon, whose top is listed as a pentagram."""
    ring = [[0, 0], [2, 0], [3, 2], [1, 3], [-1, 2]]
    corners = [[*p, height] for height in (0, 1) for p in ring]
    sides = [[i, (i + 1) % 5, 5 + (i + 1) % 5, 5 + i] for i in range(5)]
    return cube_with_faces([*sides, [0, 1, 2, 3, 4], [5, 7, 9, 6, 8]], corners)


def cube_with_a_vertex_on_an_edge():
    """Right but for the vertex, which is none of the cube."""
    faces = [[1, 3, 2, 0, 8], CUBE_FACES[1], [1, 5, 4, 0, 8], *CUBE_FACES[3:]]
    return cube_with_faces(faces, [*CUBE_CORNERS, [0, 0, F(1, 2)]])


def other_side_of_a_face():
    """The quadrilateral between the lines from the origin cut off by 3 and 4, by 2 and 3, and beside
    it the triangle of the same area that its sides cut off: that is what is tiled."""
    body = polygon([3, 0], [4, 0], [0, 3], [0, 2])
    return solid(SQUARE_GRAM, body, [[0, 0], [3, 0], [0, 2]], [[0, 1, 2]]).certificate()


def in_the_cavity(*points):
    """A mesh with a cavity, and a tetrahedron with these vertices, given by their place."""
    vertices, simplices = copy.deepcopy(CAVITY)
    corners = []
    for point in points:
        if point not in vertices:
            vertices.append(point)
        corners.append(vertices.index(point))
    return region(vertices, [*simplices, corners])


def fold(apex):
    """Two tetrahedra on one side of their common facet."""
    return region([(0, 0, 0), (4, 0, 0), (0, 4, 0), (0, 0, 4), apex], [[0, 1, 2, 4], [0, 1, 2, 3]])


def edited(base, *changes):
    """A certificate with several items replaced: pairs of a path and a value."""
    for path, value in changes:
        base = edit(base, path, value)
    return base


# --- bounds -----------------------------------------------------------------------------

TINY = F(1, 10**30)
SIXTY, NINETY, HUNDRED_TWENTY = (1, F(1, 4)), (0, 0), (-1, F(1, 4))
JUST_BELOW_60, JUST_ABOVE_60 = (1, F(1, 4) + TINY), (1, F(1, 4) - TINY)


def dashed(text):
    return text.replace(" ", "-")


def wrong_bounds():
    """Each relation of each quantity, about equilateral triangles: 60 degrees and the squared ratio 1/3."""
    triangles = lattice(HEXAGONAL)
    below = {"less than": SIXTY, "at most": JUST_BELOW_60, "maximum": JUST_BELOW_60}
    above = {"more than": SIXTY, "at least": JUST_ABOVE_60, "minimum": JUST_ABOVE_60}
    for name, make in (("largest", largest), ("smallest", smallest)):
        for relation, bound in {**below, **above}.items():
            yield f"angle-bound--{name}-{dashed(relation)}", triangles.certificate(make(relation, *bound))
    third = F(1, 3)
    for relation, bound in {"less than": third, "at most": third - TINY, "maximum": third - TINY,
                            "more than": third, "at least": third + TINY, "minimum": third + TINY}.items():
        yield f"ratio-bound--{dashed(relation)}", triangles.certificate(ratio(relation, bound))
    for name, make in (("largest", largest), ("smallest", smallest)):
        yield f"not-attained--{name}-maximum", triangles.certificate(make("maximum", *JUST_ABOVE_60))
        yield f"not-attained--{name}-minimum", triangles.certificate(make("minimum", *JUST_BELOW_60))
    yield "not-attained--ratio-maximum", triangles.certificate(ratio("maximum", third + TINY))
    yield "not-attained--ratio-minimum", triangles.certificate(ratio("minimum", third - TINY))
