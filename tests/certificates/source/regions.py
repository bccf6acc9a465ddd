"""Regions: meshes of any rank, whose boundary facets are those that one simplex has alone."""
import itertools
from fractions import Fraction as F

from .build import Tiling
from .field import Q
from .tilings import CUBE, SQUARE_GRAM, kuhn_simplices


def region(vertices, simplices, gram=None, field=Q):
    """A mesh without a lattice. Simplices are lists of vertices."""
    gram = gram or (CUBE if len(vertices[0]) == 3 else SQUARE_GRAM)
    return Tiling(gram, vertices, [[[v] for v in corners] for corners in simplices], ("region", 0), field).turned()


def cells(*corners):
    """Unit cubes at these corners, each cut into Kuhn's simplices: vertices and simplices."""
    index, simplices = {}, []
    for corner in corners:
        for simplex in kuhn_simplices(len(corner)):
            points = [tuple(x + y for x, y in zip(corner, c)) for c in simplex]
            simplices.append([index.setdefault(point, len(index)) for point in points])
    return list(index), simplices


def periodic(period, *corners, extra=()):
    """Unit cubes at these corners, periodic in the first directions with these periods.

    `extra` holds simplices as lists of points, whose vertices are their own or those of the cubes.
    """
    rank = len(period)
    names, simplices = {}, []

    def place(point):
        shift = [int(x // p) for x, p in zip(point, period)]
        base = tuple(x - s * p for x, s, p in zip(point, shift, period)) + tuple(point[rank:])
        return [names.setdefault(base, len(names)), *shift]
    for corner in corners:
        for simplex in kuhn_simplices(len(corner)):
            simplices.append([place([x + y for x, y in zip(corner, c)]) for c in simplex])
    simplices += [[place(point) for point in points] for points in extra]
    lengths = [*period, *[1] * (len(corners[0]) - rank)]
    gram = [[p * p * int(i == j) for j in range(len(lengths))] for i, p in enumerate(lengths)]
    vertices = [[F(x) / p for x, p in zip(point, lengths)] for point in names]
    return Tiling(gram, vertices, simplices, ("region", rank)).turned()


def shaken(mesh):
    """The vertices inside of three cubes in each direction, each moved by less than 1/16 to coordinates of 53 bits."""
    def moved(x, seed):
        return x + F(pow(2654435761 * (seed + 1), 3, 2**49), 2**53)
    vertices, simplices = mesh
    inside = [all(0 < x < 3 for x in point) for point in vertices]
    return [tuple(moved(x, 3 * k + axis) for axis, x in enumerate(point)) if inside[k] else point
            for k, point in enumerate(vertices)], simplices


def beside(*meshes):
    """Several meshes in one, none of whose vertices are shared."""
    vertices, simplices = [], []
    for points, tetrahedra in meshes:
        simplices += [[v + len(vertices) for v in corners] for corners in tetrahedra]
        vertices += points
    return vertices, simplices


def lone(*points):
    """One simplex."""
    return list(points), [list(range(len(points)))]


def small(x, y, z, size=F(1, 4)):
    """A small tetrahedron with its right-angled corner here."""
    return lone((x, y, z), (x + size, y, z), (x, y + size, z), (x, y, z + size))


THREE = list(itertools.product(range(3), repeat=3))
CAVITY = cells(*(c for c in THREE if c != (1, 1, 1)))
RING = cells(*((x, y, 0) for x, y, z in THREE if z == 0 and (x, y) != (1, 1)))
CORNER = lone((0, 0, 0), (4, 0, 0), (0, 4, 0), (0, 0, 4))
NINE = list(itertools.product(range(3), repeat=2))
