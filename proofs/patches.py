#!/usr/bin/env python3
"""The patches of certificates/square-triangle-all.json for Coq: theories/SquareTriangle.v and the hints.

    patches.py            write both files
    patches.py --check    fail if they are not what would be written

Coq does not believe this program: the theorem is about the patches in SquareTriangle.v.
That these are the patches of the certificate is what --check says.
A point of the certificate is written in units of 1/24 of a side.
Tetrahedra are listed such that they are positive.
Each pyramid is moved by periods such that the heights of its polygon over the offset are the same in all walls.
Its polygon is listed such that the tetrahedra of its joins are positive.
"""
import json, pathlib, sys

UNIT = 24
here = pathlib.Path(__file__).resolve().parent
source = here.parent / "certificates/square-triangle-all.json"
ZERO = (0, 0)


# Numbers a + b sqrt 3 are pairs (a, b), spots are triples of numbers.
def plus(x, y): return (x[0] + y[0], x[1] + y[1])
def minus(x, y): return (x[0] - y[0], x[1] - y[1])
def times(x, y): return (x[0] * y[0] + 3 * x[1] * y[1], x[0] * y[1] + x[1] * y[0])
def multiple(n, x): return (n * x[0], n * x[1])


def positive(x):
    a, b = x
    return a >= 0 and b >= 0 and x != ZERO or a > 0 and 3 * b * b < a * a or b > 0 and a * a < 3 * b * b


def difference(x, y): return tuple(minus(a, b) for a, b in zip(x, y))
def lift(n, x): return (plus(x[0], (n, 0)), x[1], x[2])
def turn(x): return (x[0], minus((UNIT * UNIT, 0), x[1]), minus(ZERO, x[2]))


def orient(a, b, c, d):
    u, v, w = difference(b, a), difference(c, a), difference(d, a)
    minors = [minus(times(v[i], w[j]), times(v[j], w[i])) for i, j in ((1, 2), (0, 2), (0, 1))]
    return plus(minus(times(u[0], minors[0]), times(u[1], minors[1])), times(u[2], minors[2]))


def facet(t, i):
    a, b, c, d = t
    return [(b, d, c), (a, c, d), (a, d, b), (a, b, c)][i]


def are_opposite(f, g): return f in [(g[1], g[0], g[2]), (g[0], g[2], g[1]), (g[2], g[1], g[0])]


class Patch:
    """One tile with its patch, in units."""

    def __init__(self, tile, patch):
        of_tile, of_patch = UNIT // tile["denominator"], UNIT // patch["denominator"]
        assert UNIT % tile["denominator"] == UNIT % patch["denominator"] == 0
        vertices = [tuple(multiple(of_patch, x) for x in v) for v in patch["vertices"]]

        def spot(corner):
            if isinstance(corner, int):
                return vertices[corner]
            return lift(UNIT * corner[1], vertices[corner[0]])

        starts = zip(patch["offsets"], tile["vertices"])
        self.starts = [(multiple(of_patch, o[0]), *(multiple(of_tile, x) for x in v)) for o, v in starts]
        self.pieces = [tuple(map(spot, row)) for row in patch["simplices"]]
        self.pieces = [t if positive(orient(*t)) else (t[0], t[1], t[3], t[2]) for t in self.pieces]
        self.pyramids = [None] * len(self.starts)
        for apex, polygon in patch["pyramids"]:
            apex, polygon = spot(apex), [spot(x) for x in polygon]
            [side] = [s for s in range(len(self.starts)) if all(self.wall(s, x)[2] == ZERO for x in polygon)]
            assert self.pyramids[side] is None
            self.pyramids[side] = (apex, polygon)
        self.occupants = {("Facet", k, f): facet(t, f) for k, t in enumerate(self.pieces) for f in range(4)}

    def wall(self, s, x):
        """Wall coordinates, as in PatchChecker.v."""
        start, end = self.starts[s], self.starts[(s + 1) % len(self.starts)]
        u, b = difference(end, start), difference(x, start)
        along = plus(times(b[1], u[1]), times(b[2], u[2]))
        return (multiple(UNIT, b[0]), along, minus(times(u[1], b[2]), times(u[2], b[1])))

    def arrange(self, s, total):
        """Moves and turns the pyramid of a side; the heights of its polygon then have the sum `total`."""
        apex, polygon = self.pyramids[s]
        periods, rest = divmod(total - sum(self.wall(s, x)[0][0] for x in polygon), len(polygon) * UNIT * UNIT)
        assert rest == 0
        apex, polygon = lift(UNIT * periods, apex), [lift(UNIT * periods, x) for x in polygon]
        top = self.wall(s, apex)
        below = (top[0], top[1], minus(ZERO, top[2]))
        if not positive(orient(below, self.wall(s, polygon[0]), self.wall(s, polygon[1]), top)):
            polygon = polygon[:1] + polygon[:0:-1]
        self.pyramids[s] = (apex, polygon)
        for e, x in enumerate(polygon):
            self.occupants["Lateral", s, e] = (x, apex, polygon[(e + 1) % len(polygon)])

    def find_mates(self):
        self.owners, self.behind = [[] for _ in self.starts], {}
        for o, triangle in self.occupants.items():
            walls = [s for s in range(len(self.starts)) if all(self.wall(s, x)[2] == ZERO for x in triangle)]
            if walls:
                [s] = walls
                self.behind[o] = f"Wall {s} {len(self.owners[s])}"
                self.owners[s].append(o)
                continue
            [(mate, n)] = [(other, n) for other, there in self.occupants.items() for n in range(-3, 4)
                           if are_opposite(triangle, tuple(lift(n * UNIT, x) for x in there))]
            self.behind[o] = f"Inner ({name(mate)}) ({n})"


def name(occupant): return "%s %d %d" % occupant


def rim_mates(p, s, q, r):
    here, there = p.pyramids[s][1], q.pyramids[r][1]
    here, there = [p.wall(s, x) for x in here], [turn(q.wall(r, x)) for x in there]
    edges = [(there[(e + 1) % len(there)], x) for e, x in enumerate(there)]
    return [edges.index((x, here[(e + 1) % len(here)])) for e, x in enumerate(here)]


def wall_mates(p, s, q, r):
    mates = []
    for o in p.owners[s]:
        triangle = tuple(p.wall(s, x) for x in p.occupants[o])
        [mate] = [(w, n) for w, other in enumerate(q.owners[r]) for n in range(-3, 4)
                  if are_opposite(triangle, tuple(lift(n * UNIT * UNIT, turn(q.wall(r, x))) for x in q.occupants[other]))]
        mates.append("(%d%%nat, %d)" % mate)
    return mates


def spot(x): return "Spot " + " ".join("(%d,%d)" % c for c in x)
def listed(items, between="; "): return "[" + between.join(map(str, items)) + "]"


DATA = """(** * The patches over equilateral triangles and squares

    The data of the certificate square-triangle-all, in the words of PatchStatement.v and in units
    of 1/24 of a side.  patches.py writes this file; it contains no proof. *)
From Coq Require Import ZArith List.
From Acutile Require Import PatchStatement.
Import ListNotations.
Open Scope Z_scope.

{}

Definition square_triangle := [triangle_patch; square_patch].
"""
HINTS = """(** * Patches over triangles and squares: the mates of facets

    patches.py writes this file.  These are hints: PatchChecker.v does not believe them. *)
From Coq Require Import ZArith List.
From Acutile Require Import PatchStatement PatchChecker.
Import ListNotations.
Open Scope Z_scope.

{}
"""


def files():
    certificate = json.loads(source.read_text())
    patches = [Patch(t, w) for t, w in zip(certificate["claim"]["tiles"], certificate["witness"])]
    first = patches[0]
    total = sum(first.wall(0, x)[0][0] for x in first.pyramids[0][1])
    for p in patches:
        for s in range(len(p.starts)):
            p.arrange(s, total)
        p.find_mates()
    data = []
    for p, word in zip(patches, ["triangle_patch", "square_patch"]):
        edges = [f"Edge ({spot(start)}) ({spot(apex)})\n      {listed(map(spot, polygon), ';' + chr(10) + '       ')}"
                 for start, (apex, polygon) in zip(p.starts, p.pyramids)]
        pieces = ["(" + ", ".join(map(spot, t)) + ")" for t in p.pieces]
        data.append(f"Definition {word} := Patch\n  {listed(edges, ';' + chr(10) + '   ')}\n  {listed(pieces, ';' + chr(10) + '   ')}.")

    def nested(name, kind, of):
        rows = [listed([of(p, s) for s in range(len(p.starts))], ";\n    ") for p in patches]
        return f"Definition {name} : list (list ({kind})) :=\n  {listed(rows, ';' + chr(10) + '   ')}."

    def pairs(of): return lambda p, s: listed([listed([listed(of(p, s, q, r)) for r in range(len(q.starts))]) for q in patches])
    facets = [listed([listed([p.behind["Facet", k, f] for f in range(4)]) for k in range(len(p.pieces))], ";\n    ") for p in patches]
    hints = [
        f"Definition behind_facets : list (list (list entry)) :=\n  {listed(facets, ';' + chr(10) + '   ')}.",
        nested("behind_laterals", "list entry", lambda p, s: listed([p.behind["Lateral", s, e] for e in range(len(p.pyramids[s][1]))])),
        nested("wall_owners", "list occupant", lambda p, s: listed(map(name, p.owners[s]))),
        nested("rim_mates", "list (list (list nat))", pairs(rim_mates)).replace("].", "]%nat."),
        nested("wall_mates", "list (list (list (nat * Z)))", pairs(wall_mates)),
    ]
    return {"SquareTriangle.v": DATA.format("\n\n".join(data)), "SquareTriangleHints.v": HINTS.format("\n".join(hints))}


for file, text in files().items():
    path = here / "theories" / file
    if sys.argv[1:] != ["--check"]:
        path.write_text(text)
    elif path.read_text() != text:
        sys.exit(f"{file} is not what patches.py writes from {source.name}")
