"""Conditions X and W of regions, decided by brute force over exact numbers."""
import itertools
import math

from .field import determinant


def floats(f, point):
    """Bounds are only for the search: each is widened by far more than its error."""
    low, high = (float(f.enclosure(2)[0]), float(f.enclosure(2)[1])) if f.degree > 1 else (0.0, 0.0)
    return [sum(float(c) * ((low + high) / 2) ** k for k, c in enumerate(x)) for x in point]


def box(f, points):
    columns = list(zip(*(floats(f, p) for p in points)))
    slack = 1e-6
    return [(min(c) - slack * (1 + abs(min(c))), max(c) + slack * (1 + abs(max(c)))) for c in columns]


def shifts(a, b, rank):
    """All lattice vectors that may move box b so that it meets box a."""
    ranges = [range(math.ceil(p[0] - q[1]), math.floor(p[1] - q[0]) + 1) for p, q in zip(a[:rank], b[:rank])]
    rest = all(p[0] <= q[1] and q[0] <= p[1] for p, q in zip(a[rank:], b[rank:]))
    return itertools.product(*ranges) if rest else []


def moved(corners, shift):
    return [(c[0], *(s + t for s, t in zip(c[1:], shift))) for c in corners]


def meet_wrongly(f, boundary, position, rank):
    """Whether two boundary facets, up to the lattice, meet beyond the hull of their common corners."""
    points = [[position(c) for c in facet] for facet in boundary]
    boxes = [box(f, p) for p in points]
    for i, facet in enumerate(boundary):
        for j in range(i + 1):
            for shift in shifts(boxes[i], boxes[j], rank):
                if i == j and not any(shift):
                    continue
                other = moved(boundary[j], shift)
                if pair_meets(f, facet, points[i], other, [position(c) for c in other]):
                    return True
    return False


def pair_meets(f, a, a_points, b, b_points):
    common = set(a) & set(b)
    if separated(f, a_points, b_points, [c in common for c in b]) or separated(f, b_points, a_points, [c in common for c in a]):
        return False
    return overlap(f, a_points, [c in common for c in a], b_points)


def separated(f, facet, points, common):
    """The corners that are not common lie strictly on one side of the facet's plane."""
    base, *rest = facet
    signs = set()
    for p, is_common in zip(points, common):
        if not is_common:
            signs.add(f.sign(determinant(f, [[f.subtract(x, y) for x, y in zip(q, base)] for q in [*rest, p]])))
    return signs in ({1}, {-1})


def overlap(f, a, a_common, b):
    """Whether a point of both hulls has a positive weight at a corner of a that is not common.

    The weights (l, m) with sum l = sum m = 1 and sum l a = sum m b are a polytope. Some vertex of it
    has such a weight if any point has, and a vertex has linearly independent columns.
    """
    one, zero, n = f.element(1), f.element(0), len(a)
    columns = [[one, zero, *p] for p in a] + [[zero, one, *(f.negative(x) for x in p)] for p in b]
    right = [one, one, *[zero] * len(a[0])]
    wrong = [i for i in range(n) if not a_common[i]]
    for size in range(2, len(right) + 1):
        for support in itertools.combinations(range(2 * n), size):
            if not any(i in support for i in wrong) or not any(i >= n for i in support):
                continue
            weights = solve(f, [columns[i] for i in support], right)
            if weights and all(f.sign(w) > 0 for w in weights):
                return True
    return False


def solve(f, columns, right):
    """The only solution, or None."""
    rows = [[c[i] for c in columns] + [right[i]] for i in range(len(right))]
    n = len(columns)
    for k in range(n):
        pivot = next((i for i in range(k, len(rows)) if any(rows[i][k])), None)
        if pivot is None:
            return None
        rows[k], rows[pivot] = rows[pivot], rows[k]
        inverse = f.inverse(rows[k][k])
        rows[k] = [f.multiply(x, inverse) for x in rows[k]]
        for i in range(len(rows)):
            if i != k and any(rows[i][k]):
                factor = rows[i][k]
                rows[i] = [f.subtract(x, f.multiply(factor, y)) for x, y in zip(rows[i], rows[k])]
    if any(any(row[n]) for row in rows[n:]):
        return None
    return [row[n] for row in rows[:n]]


def covered(f, boundary, rows, position, rank):
    """Whether a simplex lies directly outside some boundary facet, near its centroid.

    The point just outside is the centroid + e n + e^2 t + e^3 u for the outward normal n and the edges t, u of the
    facet and a small e. It is generic: a facet of a simplex may contain the centroid and the normal.
    """
    n = len(rows[0])
    simplices = [[position(c) for c in row] for row in rows]
    boxes = [box(f, s) for s in simplices]
    for facet in boundary:
        points = [position(c) for c in facet]
        share = f.inverse(f.element(len(points)))
        centre = [f.multiply(f.add(*xs), share) for xs in zip(*points)]
        directions = [normal(f, points), *([f.subtract(x, y) for x, y in zip(p, points[0])] for p in points[1:])]
        for simplex, its_box in zip(simplices, boxes):
            for shift in shifts(box(f, [centre]), its_box, rank):
                by = [f.element(s) for s in [*shift, *[0] * (len(centre) - rank)]]
                corners = [[f.add(x, s) for x, s in zip(p, by)] for p in simplex]
                if all(inner_side(f, corners, i, centre, directions) for i in range(n)):
                    return True
    return False


def normal(f, points):
    """A vector that points outwards, in basis coordinates: for D = 2 the inside is on the left."""
    base, *rest = points
    edges = [[f.subtract(x, y) for x, y in zip(p, base)] for p in rest]
    if len(base) == 2:
        return [edges[0][1], f.negative(edges[0][0])]
    a, b = edges
    return [f.subtract(f.multiply(a[i], b[j]), f.multiply(a[j], b[i])) for i, j in ((1, 2), (2, 0), (0, 1))]


def inner_side(f, corners, i, centre, directions):
    """Whether the i-th barycentric coordinate of the point just outside is positive; corners are positively oriented."""
    for step in [None, *directions]:
        point = centre if step is None else [f.add(x, y) for x, y in zip(centre, step)]
        base, *rest = [*corners[:i], point, *corners[i + 1:]]
        sign = f.sign(determinant(f, [[f.subtract(x, y) for x, y in zip(p, base)] for p in rest]))
        if sign:
            return sign > 0
    return False
