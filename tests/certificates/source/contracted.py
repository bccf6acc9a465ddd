"""Systems of patches over large tiles of Z, in which one edge of a vertical line is contracted.

A tile consists of equilateral triangles with the pieces of `patch_systems`; their joins inside of it are cells. The tetrahedra
around the edge of a vertical line between the heights 0 and 2 go, and its ends become one vertex at height 1. The centres of
the six triangles around the line form the hexagon around this edge. The sides of the hexagon were in 6 tetrahedra and lose
one. The edges from the two ends to its corners were in 5 each, and become 5 + 5 - 4 = 6. So all edges are in 5 or 6, and
the triangles from the new vertex to the sides of the hexagon have two edges in 6. Apart from `TCP` every claim is true.
"""
from fractions import Fraction as F

from .patch_systems import TRIANGLE_ROWS, UNIT, Surd, System, rows_of

# The vertices and triangles of the lattice are in coordinates along two sides of a triangle.
HEXAGON = [(1, 0), (0, 1), (-1, 1), (-1, 0), (0, -1), (1, -1)]
AROUND = [[(0, 0), HEXAGON[i], HEXAGON[(i + 1) % 6]] for i in range(6)]
LARGE = [(0, 0), (2, 0), (0, 2)]
FOUR = [[(0, 0), (1, 0), (0, 1)], [(1, 0), (2, 0), (1, 1)], [(0, 1), (1, 1), (0, 2)], [(1, 0), (1, 1), (0, 1)]]


def place(points):
    """The middle of some points of the lattice, in the plane."""
    a, b = (F(sum(column), len(points)) for column in zip(*points))
    return [Surd(a + b / 2), Surd(0, b / 2)]


def contracted(corners, triangles, lines):
    """A tile, its triangles, and the vertical lines with a contracted edge. All sides have one class, period and side are 1."""
    points, rows, hexagons = {}, [], {}

    def vertex(kind, where, quarters):
        where = sorted(where)
        if kind == "V" and where[0] in lines:
            # The heights 0 and 2 become 1: quarters of a period.
            quarters -= quarters % 4 - 1
        name = f"{kind}.{quarters % 4} {where}"
        points[name] = (F(quarters % 4, 4), *place(where))
        return (name, quarters // 4)

    for triangle in triangles:
        names = {"C": ("C", triangle)}
        for i in range(3):
            side = [triangle[i], triangle[(i + 1) % 3]]
            names[f"V{i}"], names[f"E{i}"] = ("V", side[:1]), ("E", side)
            (a, b), middle = [("V", [end]) for end in sorted(side)], ("E", side)
            around = [(a, 0), (a, 2), (middle, 3), (b, 2), (b, 0), (middle, -1)]
            polygon = list(dict.fromkeys(vertex(*name, quarters) for name, quarters in around))
            hexagons.setdefault(tuple(sorted(side)), (polygon, []))[1].append(vertex("C", triangle, 1))
        for row in rows_of(TRIANGLE_ROWS):
            where = [(name.split("."), shift) for name, shift in row]
            rows.append([vertex(*names[name], int(quarters) + 4 * shift) for (name, quarters), shift in where])
    pyramids = []
    for polygon, centres in hexagons.values():
        if len(centres) == 1:
            pyramids.append((*centres, polygon))
        else:
            rows += [[*ends, *centres] for ends in zip(polygon, polygon[1:] + polygon[:1])]
    rows = [row for row in rows if len(set(row)) == 4]
    return System(1, UNIT, surds=True).add([place([corner]) for corner in corners], points, rows, pyramids)


# The line stands inside of the tile, or over each of its corners: then the hexagon has a side in each of six joins.
INSIDE = contracted(HEXAGON, AROUND, [(0, 0)])
AT_CORNERS = contracted(LARGE, FOUR, LARGE)

CONTRACTED_VALID = {
    "patches-hexagons-with-a-contracted-edge": INSIDE.certificate(),
    "patches-triangles-with-edges-contracted-at-corners": AT_CORNERS.certificate(),
    # The same tiles without a contracted edge: larger tiles for Z.
    "patches-hexagons-of-z": contracted(HEXAGON, AROUND, []).certificate("acute", "Delaunay", "TCP"),
    "patches-triangles-of-z": contracted(LARGE, FOUR, []).certificate("acute", "Delaunay", "TCP"),
}

CONTRACTED_FALSE = {
    "triangle-valence--patches-in-a-tile": INSIDE.certificate("TCP"),
    "triangle-valence--patches-in-a-join": AT_CORNERS.certificate("TCP"),
}
