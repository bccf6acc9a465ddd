"""A certificate, and what follows from it by formulas of its own."""
import itertools, json, sys
from fractions import Fraction as F
from pathlib import Path

from exact import Field, Wrong

sys.path.append(str(Path(__file__).parents[1] / "certificates"))
from source.encode import to_cbor


def minor(m, i, j):
    return [[x for c, x in enumerate(row) if c != j] for r, row in enumerate(m) if r != i]


def determinant(m):
    if len(m) == 1:
        return m[0][0]
    return sum((((-1) ** j) * (m[0][j] * determinant(minor(m, 0, j))) for j in range(1, len(m))),
               m[0][0] * determinant(minor(m, 0, 0)))


def arrays(value):
    """Records as the arrays of their values, decimal strings as integers: the structure of CBOR."""
    if isinstance(value, dict):
        value = list(value.values())
    if isinstance(value, str) and value.lstrip("-").isdigit():
        return int(value)
    return [arrays(item) for item in value] if isinstance(value, list) else value


class Certificate:
    """The members of the JSON, with all corners as [vertex, shift…] and all numbers as elements of the field."""

    def __init__(self, path):
        data = json.loads(path.read_bytes())
        self.cbor = to_cbor(arrays(data))
        self.claim, self.witness = data["claim"], data["witness"]
        self.d = self.claim["dimension"]
        self.k = Field(self.claim["field"])
        upper = [[self.k.of(x) for x in row] for row in self.claim["gram"]]
        self.gram = [[upper[min(i, j)][abs(i - j)] for j in range(self.d)] for i in range(self.d)]
        self.vertices = self.points(self.witness)
        domain = self.claim["domain"]
        self.kind, self.polytope = (domain, None) if isinstance(domain, str) else domain
        self.rank = self.polytope if self.kind == "region" else {"space": self.d, "slab": self.d - 1, "prism": 1, "solid": 0}[self.kind]
        rows = [row[:self.d + 1] for row in self.witness["simplices"]]
        self.simplices = [[self.full(corner) for corner in row] for row in rows]
        self.mates = self.pairing()
        self.lengths = {}

    def points(self, record):
        denominator = F(1, int(record["denominator"]))
        return [[self.k.of(x) * denominator for x in vertex] for vertex in record["vertices"]]

    def full(self, corner):
        return corner if isinstance(corner, list) else [corner] + [0] * self.rank

    def pairing(self):
        """What is on the other side of each facet: [simplex, corner, shift…], or the face of the domain, [f]."""
        mates, found = [[None] * (self.d + 1) for _ in self.simplices], {}
        for s, corners in enumerate(self.simplices):
            for i in range(self.d + 1):
                facet = sorted(corners[:i] + corners[i + 1:])
                shift = facet[0][1:]
                name = tuple((c[0], *[a - b for a, b in zip(c[1:], shift)]) for c in facet)
                found.setdefault(name, []).append((s, i, shift))
        for name, places in found.items():
            if len(places) == 1:
                (s, i, _), = places
                mates[s][i] = [self.face(name)]
                continue
            (s, i, p), (t, j, q) = places
            mates[s][i] = [t, j] + [a - b for a, b in zip(p, q)]
            mates[t][j] = [s, i] + [b - a for a, b in zip(p, q)]
        return mates

    def face(self, corners):
        """Region: -1. Otherwise as follows."""
        return -1 if self.kind == "region" else self.face_of_polytope(corners)

    def face_of_polytope(self, corners):
        """The first face of the polytope in whose plane these corners are."""
        vertices, k = self.points(self.polytope), self.d - self.rank
        points = [self.position(list(corner))[self.rank:] for corner in corners]
        for f, face in enumerate(self.polytope["faces"]):
            first, *others = [vertices[w] for w in face[:k]]
            sides = [[b - a for a, b in zip(first, other)] for other in others]
            heights = [determinant(sides + [[b - a for a, b in zip(first, point)]]) for point in points]
            if all(height.sign() == 0 for height in heights):
                return f
        raise Wrong("a facet without a mate, and in no face")

    def position(self, place):
        shifts = place[1:] + [0] * (self.d - self.rank)
        return [x + s for x, s in zip(self.vertices[place[0]], shifts)]

    def square(self, x):
        return sum((x[i] * self.gram[i][j] * x[j] for i in range(self.d) for j in range(self.d)), self.k.of("0"))

    def edges(self, s):
        """Squared lengths by pairs, from coordinates."""
        if s not in self.lengths:
            points = [self.position(c) for c in self.simplices[s]]
            self.lengths[s] = {(i, j): self.square([b - a for a, b in zip(points[i], points[j])])
                               for i, j in itertools.combinations(range(self.d + 1), 2)}
        return self.lengths[s]

    def det(self, s):
        points = [self.position(c) for c in self.simplices[s]]
        return determinant([[b - a for a, b in zip(points[0], p)] for p in points[1:]])

    def form(self, s):
        """Equal exactly for congruent simplices; the set of all renumberings' edges."""
        edges = self.edges(s)
        key = lambda p: tuple(tuple(edges[min(p[i], p[j]), max(p[i], p[j])].c) for i, j in edges)
        return min(key(p) for p in itertools.permutations(range(self.d + 1)))

    def inner(self, s):
        """The inner products of the edges from corner 0, from coordinates."""
        points = [self.position(c) for c in self.simplices[s]]
        e = [[b - a for a, b in zip(points[0], p)] for p in points[1:]]
        r = range(self.d)
        return [[sum((x[i] * self.gram[i][j] * y[j] for i in r for j in r), self.k.of("0")) for y in e] for x in e]

    def normals(self, s):
        """<g_i, g_j> det M: cofactors, bordered."""
        m = self.inner(s)
        r = range(self.d)
        c = [[determinant(minor(m, i, j)) * (-1) ** (i + j) for j in r] for i in r]
        first = [-sum(row, self.k.of("0")) for row in c]
        return [[-sum(first, self.k.of("0"))] + first] + [[f] + row for f, row in zip(first, c)]

    def power(self, s, i):
        """|d - z|² - ρ² of the corner behind a facet, by the determinant of the lifted points."""
        t, j, *u = self.mates[s][i]
        place = self.simplices[t][j]
        behind = self.position([place[0]] + [a + b for a, b in zip(place[1:], u)])
        points = [self.position(c) for c in self.simplices[s]]
        origin = points[0]
        rows = []
        for p in points[1:] + [behind]:
            x = [b - a for a, b in zip(origin, p)]
            rows.append(x + [self.square(x)])
        # Expanding along the last row: |x|² det E - Σ …
        return determinant(rows) / determinant([row[:-1] for row in rows[:-1]])

    def colours(self):
        """The coarsest partition of the chambers that respects lengths and neighbours."""
        orders = list(itertools.permutations(range(self.d + 1)))
        index = {o: n for n, o in enumerate(orders)}
        m = len(orders)
        number = {}
        label, images = [], []
        for s, corners in enumerate(self.simplices):
            edges = self.edges(s)
            maps = []
            for i in range(self.d + 1):
                mate = self.mates[s][i]
                if len(mate) == 1:
                    maps.append(None)
                    continue
                t, j, *u = mate
                there = {(c[0], *[a + b for a, b in zip(c[1:], u)]): n for n, c in enumerate(self.simplices[t])}
                maps.append((t, [j if n == i else there[tuple(c)] for n, c in enumerate(corners)]))
            for o in orders:
                key = tuple(edges[min(o[i], o[j]), max(o[i], o[j])] for i, j in edges) + (maps[o[-1]] is None,)
                label.append(number.setdefault(key, len(number)))
                row = []
                for k in range(self.d):
                    swapped = list(o)
                    swapped[k], swapped[k + 1] = o[k + 1], o[k]
                    row.append(s * m + index[tuple(swapped)])
                glue = maps[o[-1]]
                row.append(s * m + index[o] if glue is None else glue[0] * m + index[tuple(glue[1][n] for n in o)])
                images.append(row)
        count = len(number)
        while True:
            number = {}
            label = [number.setdefault((c, *[label[x] for x in row]), len(number)) for c, row in zip(label, images)]
            if len(number) == count:
                return label, orders
            count = len(number)

    def orbits(self):
        """Sets of simplices and sets of vertices, and the number of symmetries up to the lattice."""
        label, orders = self.colours()
        m = len(orders)
        simplices, vertices = {}, {}
        for s, corners in enumerate(self.simplices):
            simplices.setdefault(min(label[s * m:(s + 1) * m]), set()).add(s)
        least = {}
        for n, colour in enumerate(label):
            v = self.simplices[n // m][orders[n % m][0]][0]
            least[v] = min(colour, least.get(v, colour))
        for v, colour in least.items():
            vertices.setdefault(colour, set()).add(v)
        return simplices.values(), vertices.values(), label.count(label[0])
