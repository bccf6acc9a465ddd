#!/usr/bin/env python3
"""Looks for a system of patches in the mixtures of Z and C15 over tilings with blank edges.

    blank-edges.py [--acutile PROGRAM]

`acutile certify z-c15:TILING` proves the structure over a tiling of the plane. Its certificate is read here, in exact
arithmetic over Q(sqrt 3). Each cell is assigned to the smallest set of tiles that it lies over: one tile, or two tiles
with a common side. Cells over one kind of place are compared after a motion and a shift in height, for all tilings.
A table shows each kind of place with the number of its cells, and whether these cells are a join: all of them have the
same two corners off the wall, one on each side. The last lines state which meetings of tiles a system of patches with
one tile for each colour needs, and which of them occur. The exit code is 1 if a place has cells of two patterns, or if
a cell lies over no two tiles with a common side.
"""
import argparse
import copy
import json
import pathlib
import subprocess
import sys
import tempfile
from collections import Counter, defaultdict
from dataclasses import dataclass
from fractions import Fraction as F
from itertools import combinations, combinations_with_replacement, permutations, product
from math import isqrt, lcm

# Rows of squares (s) and triangles (t), and tilings that are built in.
ROWS = ["tss", "tts", "ttss", "ttsts"]
BUILT_IN = ["3", "4", "33344", "32434"]
STEPS = [(a, b) for a in range(-4, 5) for b in range(-4, 5)]
SIDE_SQUARE = F(1369, 100)


@dataclass(frozen=True)
class Surd:
    """a + b sqrt 3."""
    a: F
    b: F = F(0)

    def __add__(self, other):
        return Surd(self.a + other.a, self.b + other.b)

    def __sub__(self, other):
        return Surd(self.a - other.a, self.b - other.b)

    def __mul__(self, other):
        return Surd(self.a * other.a + 3 * self.b * other.b, self.a * other.b + self.b * other.a)

    def __truediv__(self, other):
        norm = other.a ** 2 - 3 * other.b ** 2
        return self * Surd(other.a / norm, -other.b / norm)

    def sign(self):
        """That of the part with the larger square."""
        larger = self.b if 3 * self.b ** 2 > self.a ** 2 else self.a
        return (larger > 0) - (larger < 0)

    def floor(self):
        scale = lcm(self.a.denominator, self.b.denominator)
        b = int(self.b * scale)
        root = isqrt(3 * b * b) if b >= 0 else -isqrt(3 * b * b) - 1
        return (int(self.a * scale) + root) // scale


def surd(x):
    return Surd(*map(F, x)) if isinstance(x, list) else Surd(F(x))


def plus(p, q):
    return tuple(x + y for x, y in zip(p, q))


def minus(p, q):
    return tuple(x - y for x, y in zip(p, q))


def cross(p, q):
    return p[0] * q[1] - p[1] * q[0]


def shifted(place, shift):
    return plus(place, [Surd(F(s)) for s in shift])


def cell_of(place):
    return tuple(x.floor() for x in place)


def back(shift):
    return tuple(-s for s in shift)


class Tile:
    """
    Its corners, counterclockwise, begin with those of a blank side. The colour is the height of the middles of the other
    sides, in quarters of the period: 1 or 3.
    """

    def __init__(self, corners, heights):
        def middle(p, q):
            return tuple(x * Surd(F(1, 2)) for x in plus(p, q))
        sides = list(zip(corners, corners[1:] + corners[:1]))
        found = [heights(middle(*side)) for side in sides]
        first = found.index(None)
        self.corners = corners[first:] + corners[:first]
        self.heights = found[first:] + found[:first]
        self.middles = [middle(*side) for side in sides[first:] + sides[:first]]
        colours = set(found) - {None}
        if len(colours) != 1 or found.count(None) != len(corners) - 2:
            sys.exit("a tile has not the blank sides that it should have")
        self.colour = colours.pop()
        self.letter = "TS"[len(corners) - 3]

    def contains(self, place):
        ends = zip(self.corners, self.corners[1:] + self.corners[:1])
        return all(cross(minus(q, p), minus(place, p)).sign() >= 0 for p, q in ends)

    def moved(self, shift):
        tile = copy.copy(self)
        tile.corners = [shifted(p, shift) for p in self.corners]
        tile.middles = [shifted(p, shift) for p in self.middles]
        return tile

    def frames(self):
        """A place and two vectors. A square has two frames, since it may be turned by 180 degrees."""
        a, b, *_, last = self.corners
        yield (a, minus(b, a), minus(last, a))
        if self.letter == "S":
            c = self.corners[2]
            yield (c, minus(last, c), minus(b, c))

    def common(self, other):
        """The number of the side that the other tile has, too."""
        return next((i for i, middle in enumerate(self.middles) if middle in other.middles), None)

    def named_side(self, other):
        """Of the three sides of a triangle number 0 is blank; in a square two opposite sides look alike."""
        return self.letter + (str(self.common(other)) if self.letter == "T" else "")


class Structure:
    """The points of a certificate: a place in the plane, in lattice coordinates, and a height in quarters of the period."""

    def __init__(self, certificate):
        gram = [[surd(x) for x in row] for row in certificate["claim"]["gram"]]
        # The period in height is 4.
        unit = gram[2][0] / Surd(F(16))
        self.gram = [gram[0][0] / unit, gram[0][1] / unit, gram[1][0] / unit]
        witness = certificate["witness"]
        scale = Surd(F(witness["denominator"]))
        self.points = [tuple(surd(x) / scale for x in vertex) for vertex in witness["vertices"]]
        self.cells = [[self.corner(c) for c in row[:4]] for row in witness["simplices"]]
        self.heights = defaultdict(set)
        for place, height in (self.corner(v) for v in range(len(self.points))):
            self.heights[shifted(place, back(cell_of(place)))].add(height % 4)
        self.tiles = list(self.find_tiles())
        self.known = {place: list(self.tiles_over(place)) for place in self.heights}

    def corner(self, corner):
        vertex, *shift = corner if isinstance(corner, list) else [corner, 0, 0, 0]
        x, y, z = self.points[vertex]
        return (shifted((x, y), shift[:2]), int(4 * (z.a + shift[2])))

    def inner(self, p, q):
        a, b, c = self.gram
        return p[0] * q[0] * a + (p[0] * q[1] + p[1] * q[0]) * b + p[1] * q[1] * c

    def height(self, middle):
        """That of the only point over a place."""
        found = self.heights.get(shifted(middle, back(cell_of(middle))))
        return next(iter(found)) if found else None

    def find_tiles(self):
        """The triangles and squares of vertices of the plane tiling, up to the lattice. Two points are over such a vertex."""
        vertices = [place for place, found in self.heights.items() if len(found) == 2]
        known, twice_area, side = set(), Surd(F(0)), Surd(SIDE_SQUARE)
        for p in vertices:
            steps = [minus(shifted(q, step), p) for q in vertices for step in STEPS]
            steps = [v for v in steps if self.inner(v, v) == side]
            for u, v in permutations(steps, 2):
                inner = self.inner(u, v)
                corners = [p, plus(p, u), plus(plus(p, u), v), plus(p, v)]
                if inner + inner == side:
                    del corners[2]
                is_tile = cross(u, v).sign() > 0 and (len(corners) == 3 or inner.sign() == 0)
                if not is_tile or not all(shifted(c, back(cell_of(c))) in vertices for c in corners):
                    continue
                names = {frozenset(shifted(c, back(cell_of(base))) for c in corners) for base in corners}
                if not names & known:
                    known |= names
                    twice_area += cross(u, v) * Surd(F(len(corners) - 2))
                    yield Tile(corners, self.height)
        if twice_area != Surd(F(2)):
            sys.exit("the tiles do not cover the plane")

    def tiles_over(self, place):
        """The closed tiles that contain a place: an index and a shift."""
        for i, tile in enumerate(self.tiles):
            ranges = []
            for k in (0, 1):
                values = [minus(place, corner)[k].floor() for corner in tile.corners]
                ranges.append(range(min(values), max(values) + 2))
            yield from ((i, shift) for shift in product(*ranges) if tile.contains(shifted(place, back(shift))))

    def over(self, place):
        base = cell_of(place)
        return {(i, tuple(plus(shift, base))) for i, shift in self.known[shifted(place, back(base))]}

    def placed(self):
        """The cells over one tile, and those over two tiles with a common side, by tiles; and the number of all others."""
        found, others = defaultdict(list), 0
        for cell in self.cells:
            over = [self.over(place) for place, _ in cell]
            keys = [(tile,) for tile in set.intersection(*over)]
            keys = keys or [
                (one, other) for one, other in combinations(sorted(set.union(*over)), 2)
                if all(tiles & {one, other} for tiles in over) and self.tile(one).common(self.tile(other)) is not None]
            if len(keys) != 1:
                others += 1
                continue
            base = keys[0][0][1]
            key = tuple((i, minus(shift, base)) for i, shift in keys[0])
            found[key].append([(shifted(place, back(base)), height) for place, height in cell])
        return {tuple(map(self.tile, key)): cells for key, cells in found.items()}, others

    def tile(self, key):
        return self.tiles[key[0]].moved(key[1])


def in_frame(cells, frame, colour):
    """The cells as sets of points, up to periods in height. The colour 3 is seen half a period lower."""
    origin, u, v = frame
    area = cross(u, v)

    def seen(cell):
        places = [minus(place, origin) for place, _ in cell]
        points = [(cross(p, v) / area, cross(u, p) / area, height - colour) for p, (_, height) in zip(places, cell)]
        base = min(height for *_, height in points) // 4 * 4
        return frozenset((x, y, height - base) for x, y, height in points)
    return frozenset(map(seen, cells))


def is_join(cells, one, other):
    """All cells have the same two corners off the wall, one over either tile; the other two are in the wall."""
    ends = set()
    for cell in cells:
        off = [c for c in cell if not (one.contains(c[0]) and other.contains(c[0]))]
        if len(off) != 2 or one.contains(off[0][0]) == one.contains(off[1][0]):
            return False
        ends.add(frozenset((place, height - min(z for _, z in off)) for place, height in off))
    return len(ends) == 1


def shape(cells, one, other):
    """How many corners of each cell are over the first tile only, in the wall, and over the second tile only."""
    def split(cell):
        sides = [(one.contains(place), other.contains(place)) for place, _ in cell]
        counts = [sides.count(kind) for kind in [(True, False), (True, True), (False, True)]]
        return "-".join(map(str, counts))
    found = Counter(map(split, cells))
    return ", ".join(f"{count} of {split}" for split, count in sorted(found.items()))


def groups(meetings):
    """The sides that a system of patches must give one class: those that are linked by meetings."""
    found = []
    for meeting in meetings:
        linked = [group for group in found if group & set(meeting)]
        found = [group for group in found if group not in linked] + [set(meeting).union(*linked)]
    return sorted(map(sorted, found))


class Study:
    """All kinds of places, with their patterns, and the pairs of coloured tiles that meet."""

    def __init__(self):
        self.patterns, self.shapes, self.others = defaultdict(Counter), {}, 0
        self.meetings = {"blank": set(), "full": set()}

    def add(self, structure):
        found, others = structure.placed()
        self.others += others
        for tiles, cells in found.items():
            tiles = sorted(tiles, key=lambda tile: tile.letter, reverse=True)
            kind = "|".join(tile.letter for tile in tiles)
            orders = [tiles]
            if len(tiles) == 2:
                kind = "|".join(sorted((one.named_side(other) for one, other in permutations(tiles)), reverse=True))
                side = "blank" if tiles[0].heights[tiles[0].common(tiles[1])] is None else "full"
                self.meetings[side].add(tuple(sorted(tile.letter + " +-"[tile.colour // 2 + 1] for tile in tiles)))
                kind += f" {side}"
                self.shapes[kind] = ("a join" if is_join(cells, *tiles) else "no join", shape(cells, *tiles))
                orders += [tiles[::-1]] if tiles[0].letter == tiles[1].letter else []
            seen = [in_frame(cells, frame, order[0].colour) for order in orders for frame in order[0].frames()]
            self.patterns[kind][min(seen, key=hash)] += 1

    def print(self):
        """The tables; returns whether each kind of place has one pattern and all cells have a place."""
        head = "corners over the one tile - in the wall - over the other"
        print(f"{'place':<12}{'seen':>6}{'patterns':>10}{'cells':>7}  join?    {head}")
        for kind, patterns in sorted(self.patterns.items(), key=lambda item: (len(item[0]), item[0])):
            counts = ",".join(str(n) for n in sorted({len(pattern) for pattern in patterns}))
            join, corners = self.shapes.get(kind, ("", ""))
            print(f"{kind:<12}{sum(patterns.values()):>6}{len(patterns):>10}{counts:>7}  {join:<7}  {corners}".rstrip())
        print(f"cells over no tile and no two tiles with a common side: {self.others}")
        for side, meetings in self.meetings.items():
            for group in groups(meetings):
                needed = set(combinations_with_replacement(group, 2))
                print(f"{side} sides of {' '.join(group)} have one class")
                print(f"  meetings that occur: {', '.join(map('|'.join, sorted(needed & meetings)))}")
                print(f"  and never: {', '.join(map('|'.join, sorted(needed - meetings))) or 'none'}")
        return self.others == 0 and all(len(patterns) == 1 for patterns in self.patterns.values())


def rows_file(word):
    """The plane tiling of these rows."""
    vertices, at = [], [0, 0, 0, 0]
    for row in word:
        vertices.append(list(at))
        at[3 if row == "s" else 2] += 1
    return {"format": "acutile-plane-tiling", "version": 1, "name": f"rows {word}", "lattice": [[1, 0, 0, 0], at],
            "vertices": vertices}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--acutile", default="acutile", metavar="PROGRAM")
    program = str(pathlib.Path(parser.parse_args().acutile))
    study = Study()
    with tempfile.TemporaryDirectory() as folder:
        names = list(BUILT_IN)
        for word in ROWS:
            path = pathlib.Path(folder, f"{word}.json")
            path.write_text(json.dumps(rows_file(word)))
            names.append(str(path))
        for name in names:
            written = pathlib.Path(folder, "certificate.json")
            subprocess.run([program, "certify", f"z-c15:{name}", "-o", str(written)], check=True, stdout=subprocess.DEVNULL)
            study.add(Structure(json.loads(written.read_bytes())))
    sys.exit(0 if study.print() else 1)


if __name__ == "__main__":
    main()
