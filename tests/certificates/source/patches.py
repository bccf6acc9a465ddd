"""Systems of patches, by hand: cubes cut in six, and prisms and slabs with a vertex in the middle of each cell.

A cell of the second kind is a prism over a polygon, or a cube. Around the axis from its middle to that of the cell above it
(beside it, in a slab) are tetrahedra; the rest are pyramids over the walls, whose apex is the middle.
"""
from dataclasses import dataclass, field as member
from fractions import Fraction as F

from .build import corner, from_first, oriented_row
from .field import Q, common_denominator, determinant, times


@dataclass
class Patch:
    """A tile with its classes, and what is over it. Corners are (vertex, shift…); tetrahedra are oriented by the generator."""
    tile: list
    classes: list
    vertices: list
    tetrahedra: list
    pyramids: list = member(default_factory=list)
    offsets: list = None


def system(patches, gram, statements, rank, field=Q):
    """The certificate."""
    f = field
    members = [patch_member(p, rank, f) for p in patches]
    upper = [[f.element(x) for x in row[i:]] for i, row in enumerate(gram)]
    scale = common_denominator([x for row in upper for x in row])
    claim_field = "Q" if f.degree == 1 else {
        "polynomial": f.polynomial, "root": {"low": int(f.low), "high": int(f.high), "denominator": 1}}
    return {
        "format": "acutile-certificate", "version": 2, "kind": "patches",
        "claim": {"field": claim_field, "gram": [[f.integers(times(x, scale)) for x in row] for row in upper], "rank": rank,
                  "tiles": [tile_member(p, f) for p in patches],
                  "statements": ["face-to-face tiling", *(bound_member(s, f) for s in statements)]},
        "witness": members,
    }


def bound_member(statement, f):
    """A text, or a quantity with its relation, the sign of a cosine, and a square."""
    if isinstance(statement, str):
        return statement
    *head, square = statement
    return [*head, f.fraction(f.element(square))]


def integral(f, points, denominator):
    return [[f.integers(times(f.element(x), denominator)) for x in point] for point in points]


def tile_member(patch, f):
    denominator = common_denominator([f.element(x) for point in patch.tile for x in point])
    return {"denominator": denominator, "vertices": integral(f, patch.tile, denominator), "classes": patch.classes}


def patch_member(patch, rank, f):
    offsets = patch.offsets or [[0] * rank for _ in patch.classes]
    denominator = common_denominator([f.element(x) for point in patch.vertices + patch.tile + offsets for x in point])

    def position(c):
        shift = [*c[1:], *[0] * (3 - rank)]
        return [f.add(f.element(x), f.element(s)) for x, s in zip(patch.vertices[c[0]], shift)]

    def sign(corners):
        base, *rest = map(position, corners)
        return f.sign(determinant(f, [[f.subtract(a, b) for a, b in zip(x, base)] for x in rest]))

    def row(corners):
        return [corner(c) for c in oriented_row(corners if sign(corners) > 0 else [*corners[:-2], corners[-1], corners[-2]])]

    def pyramid(apex, polygon):
        """From the first corner, in the sense in which it sees the apex as positive."""
        first, *others = polygon
        polygon = polygon if sign([*polygon[:3], apex]) > 0 else [first, *reversed(others)]
        moved = from_first([*polygon, apex])
        return [corner(moved[-1]), [corner(c) for c in moved[:-1]]]
    return {
        "denominator": denominator, "offsets": integral(f, offsets, denominator), "vertices": integral(f, patch.vertices, denominator),
        "pyramids": [pyramid(*p) for p in patch.pyramids], "simplices": [row(t) for t in patch.tetrahedra],
    }


def with_middle(tile, middle, classes, heights=1, offsets=None):
    """
    The prism over a polygon: `heights` cells in a period, each with its middle at half its height. The wall of a side has one
    quadrilateral for each cell.
    """
    n = len(tile)
    vertices = [[F(k, heights), *p] for k in range(heights) for p in tile] + [[F(2 * k + 1, 2 * heights), *middle] for k in range(heights)]

    def at(k, i):
        return ((k % heights) * n + i % n, k // heights)

    def centre(k):
        return (heights * n + k % heights, k // heights)
    tetrahedra = [[centre(k - 1), centre(k), at(k, i), at(k, i + 1)] for k in range(heights) for i in range(n)]
    pyramids = [(centre(k), [at(k, i), at(k, i + 1), at(k + 1, i + 1), at(k + 1, i)]) for k in range(heights) for i in range(n)]
    return Patch(tile, classes, vertices, tetrahedra, pyramids, offsets)


def slab_with_middles(low, high, offsets=None, middle=(F(1, 2), F(1, 2))):
    """Cells over unit squares: axes between the middles of neighbours, pyramids over the upper and lower square."""
    vertices = [[0, 0, low], [0, 0, high], [*middle, F(low + high, 2)]]
    tetrahedra = []
    for x, y in ((1, 0), (0, 1)):
        # The common square of this cell and the one in this direction.
        ring = [(0, x, y), (1, x, y), (1, 1, 1), (0, 1, 1)]
        tetrahedra += [[(2, 0, 0), (2, x, y), ring[i], ring[(i + 1) % 4]] for i in range(4)]
    pyramids = [((2, 0, 0), [(v, 0, 0), (v, 1, 0), (v, 1, 1), (v, 0, 1)]) for v in (0, 1)]
    return Patch([[low], [high]], [0, 0], vertices, tetrahedra, pyramids, offsets)


def slab_of_cubes(low, high, kuhn, classes=(0, 0)):
    """Kuhn's tetrahedra; both walls have the same diagonals."""
    tetrahedra = [[(c[2], c[0], c[1]) for c in simplex] for simplex in kuhn]
    return Patch([[low], [high]], list(classes), [[0, 0, low], [0, 0, high]], tetrahedra)
