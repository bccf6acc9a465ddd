#!/usr/bin/env python3
"""Checks a tiling with pencil-and-paper rules from the printed text alone.

    tests/appendix/referee.py DIR NAME...     NAME: what is in DIR/tiling-NAME.tex

Reads the basis, the vertices, the isometries, the representatives and the facets from the TeX source; it opens no
certificate. It checks every hypothesis (M), (S), (O), (F), (B), (V) as printed, with each value and each reason for
a sign. Then it forgets the representatives: it makes all tiles, and checks that each of their facets has exactly one
other tile, on its other side, and that the volumes sum up. Python's standard library only.
"""
import re, sys
from collections import Counter, defaultdict
from fractions import Fraction as F
from pathlib import Path

from exact import Field, Wrong, must
from formulas import corner, math, number, rows_of, shift, source
from reasons import check_justified
from tiling import determinant


def field_of(text):
    """The field that the theorem names."""
    match = re.search(r"All numbers lie in \$\\mathbb\{Q\}\(\\sqrt\{(\d+)\}\)\$", text)
    if match:
        d = int(match.group(1))
        low = next(i for i in range(d + 1) if (i + 1) ** 2 > d)
        return Field({"polynomial": [-d, 0, 1], "root": {"low": low, "high": low + 1, "denominator": 1}})
    match = re.search(r"where \$\\alpha\$ is the root of \$(.*?)\$ between \$(.*?)\$ and \$(.*?)\$", text)
    if not match:
        return Field("Q")
    low, high = F(match.group(2)), F(match.group(3))
    denominator = low.denominator * high.denominator
    ends = {"low": low * denominator, "high": high * denominator, "denominator": denominator}
    return Field({"polynomial": coefficients(match.group(1)), "root": ends})


def coefficients(text):
    """x^{3}-3x+1 as [1, -3, 0, 1]."""
    found = {}
    for sign, size, x, power in re.findall(r"([+-]?)(\d*)(x?)(?:\^\{(\d+)\})?", text):
        if size or x:
            found[int(power or 1) if x else 0] = int(sign + (size or "1"))
    return [found.get(k, 0) for k in range(max(found) + 1)]


def key(x):
    return tuple(x.c)


def terms(text):
    """The terms of a sum with their signs: those outside of all parentheses, which may be nested."""
    found, depth = [["+", ""]], 0
    for letter in text.strip():
        depth += (letter in "({") - (letter in ")}")
        if depth == 0 and letter in "+-":
            found.append([letter, ""])
        else:
            found[-1][1] += letter
    must(depth == 0, f"parentheses that do not match: {text}")
    found = found if found[0][1] else found[1:]
    must(found and all(term for _, term in found), f"no sum: {text}")
    return found


class Printed:
    """The data of a section, as numbers."""

    def __init__(self, text):
        self.text, self.lines = text, text.split("\n")
        self.k = field_of(text)
        self.zero, self.one = self.k.of("0"), self.k.of("1")
        self.gram = self.matrix(self.line_after("gram"))
        self.d = len(self.gram)
        lattice = re.search(r"Let \$\\Lambda=(.*?)\$", text)
        self.rank = len(re.findall("b_", lattice.group(1))) if lattice else 0
        self.vertices = self.read_vertices()
        self.maps, self.products, self.images = self.read_group()
        self.tiles, self.dets, self.counts, self.order, self.classes = self.read_tiles()
        self.faces = self.read_faces()

    def line_after(self, mark):
        return self.lines[next(n for n, line in enumerate(self.lines) if line.startswith(f"% acutile:{mark}")) + 1]

    def table(self, mark):
        start = next((n for n, line in enumerate(self.lines) if line.startswith(f"% acutile:table {mark} ")), None)
        return [] if start is None else rows_of(self.lines, start)

    def matrix(self, text):
        inner = re.search(r"\\begin\{pmatrix\}(.*?)\\end\{pmatrix\}", text).group(1)
        return [[number(self.k, x) for x in row.split("&")] for row in inner.split("\\\\")]

    def read_vertices(self):
        rows = self.table("vertices")
        must([int(row[0]) for row in rows] == list(range(len(rows))), "the vertices are not numbered in order")
        self.origins = [row[-1] for row in rows]
        return [[number(self.k, math(x)) for x in row[1:1 + self.d]] for row in rows]

    def triplet(self, text):
        """(-x_1+1/2, x_2, x_3) as a matrix and a vector."""
        lines = text.strip()[1:-1].split(",\\,")
        must(len(lines) == self.d, f"no isometry: {text}")
        matrix, start = [], []
        for line in lines:
            row = [self.zero] * (self.d + 1)
            for sign, term in terms(line):
                factor, variable = re.fullmatch(r"(.*?)(?:x_(\d))?", term).groups()
                value = number(self.k, factor) if factor else self.one
                place = int(variable) - 1 if variable else self.d
                row[place] = row[place] - value if sign == "-" else row[place] + value
            matrix.append(row[:self.d])
            start.append(row[self.d])
        return matrix, start

    def read_group(self):
        rows = self.table("group")
        if not rows:
            return [([[self.one if i == j else self.zero for j in range(self.d)] for i in range(self.d)], [self.zero] * self.d)], {}, None
        head = next(line for line in self.lines if line.startswith("& image"))
        generators = [int(g) for g in re.findall(r"\\gamma_\{(\d+)\}\\cdot", head)]
        must([row[0] for row in rows] == [f"$\\gamma_{{{m}}}$" for m in range(len(rows))], "the isometries are not numbered in order")
        maps = [self.triplet(math(row[1].replace('$ $', '\\,'))) for row in rows]
        for m, (_, start) in enumerate(maps):
            must(all(floor(x) == 0 for x in start[:self.rank]), f"isometry {m} has a translation outside of the cell")
        products = {g: [int(row[2 + n]) for row in rows] for n, g in enumerate(generators)}
        images = [[int(x) for x in row[-1].split()] for row in rows] if "$P$" in head else None
        theorem = self.text[:self.text.index("\\end{acutiletheorem}")]
        named = re.findall(r"\$\\gamma_\{(\d+)\}=(\(.*?\))\$", theorem)
        must([int(g) for g, _ in named] == generators, "the theorem has other generators")
        for g, text in named:
            must(self.triplet(text) == maps[int(g)], f"the theorem has another generator {g}")
        return maps, products, images

    def read_tiles(self):
        tiles, dets, counts, order, classes = {}, {}, {}, [], {}
        for row in self.table("orbits"):
            name = int(re.fullmatch(r"\$T_\{(\d+)\}\$", row[1]).group(1))
            tiles[name] = [corner(math(x), self.rank) for x in row[2:3 + self.d]]
            dets[name] = math(row[3 + self.d])
            counts[name] = (int(row[4 + self.d]), int(row[5 + self.d])) if len(row) > 5 + self.d else (1, 1)
            classes[name] = int(row[0])
            order.append(name)
        return tiles, dets, counts, order, classes

    def read_faces(self):
        """Each face of the domain by the points of its corners, in the last coordinates."""
        match = re.search(r"lies in face \$f\$ of the boundary \((.*?)\)\. ?\n", self.text)
        if not match:
            return []
        faces = []
        for face in match.group(1).split("; "):
            height = re.search(r"\$x_\d=(.*?)\$", face)
            points = [(int(n), [number(self.k, x) for x in p.split(",\\,")]) for n, p in re.findall(r"\$p_\{(\d+)\}=\((.*?)\)\$", face)]
            faces.append([(len(faces), [number(self.k, height.group(1))])] if height else points)
        return faces

    def point(self, c):
        return [x + (c[1 + i] if i < self.rank else 0) for i, x in enumerate(self.vertices[c[0]])]

    def apply(self, m, point):
        matrix, start = self.maps[m]
        return [sum((a * x for a, x in zip(row, point)), t) for row, t in zip(matrix, start)]

    def named(self, point):
        """The corner at a point."""
        if not hasattr(self, "places"):
            self.places = {}
            for v, p in enumerate(self.vertices):
                reduced, cell = self.reduced(p)
                must(reduced not in self.places, f"vertices {self.places.get(reduced)} and {v} are one point")
                self.places[reduced] = (v, cell)
        reduced, cell = self.reduced(point)
        must(reduced in self.places, "a point that is no vertex")
        v, own = self.places[reduced]
        return [v] + [a - b for a, b in zip(cell, own)]

    def reduced(self, point):
        cell = [floor(x) for x in point[:self.rank]]
        return tuple(key(x - (cell[i] if i < self.rank else 0)) for i, x in enumerate(point)), cell

    def det(self, points):
        return determinant([[b - a for a, b in zip(points[0], p)] for p in points[1:]])

    def dot(self, x, y):
        return sum((self.gram[i][j] * x[i] * y[j] for i in range(self.d) for j in range(self.d)), self.zero)


def floor(x):
    """The floor of a number, by its sign after subtraction."""
    low, high = -1, 1
    while (x - low).sign() < 0:
        low *= 2
    while (x - high).sign() >= 0:
        high *= 2
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (middle, high) if (x - middle).sign() >= 0 else (low, middle)
    return low


def sorted_ends(values):
    """The least and the greatest."""
    values = list(values)
    low = high = values[0]
    for x in values[1:]:
        low, high = (x if (x - low).sign() < 0 else low), (x if (x - high).sign() > 0 else high)
    return low, high


def same_matrix(a, b):
    return all(x == y for row, other in zip(a, b) for x, y in zip(row, other))


class Referee:
    def __init__(self, text):
        self.p = Printed(text)
        self.moved = {}

    def run(self):
        p = self.p
        for k in range(1, p.d + 1):
            must(determinant([row[:k] for row in p.gram[:k]]).sign() > 0, "(M): a minor is not positive")
        self.symmetry()
        self.determinants()
        self.facets()
        self.boundary()
        self.whole()
        self.powers()
        self.shapes()
        if "the region that is their union" in p.text:
            self.region()
        return f"{len(p.vertices)} vertices, {len(p.maps)} isometries, {len(p.tiles)} representatives, {len(self.all)} tiles"

    def symmetry(self):
        """(S): isometries, the lattice, products, stabilisers, the domain."""
        p = self.p
        for g in p.products:
            matrix, _ = p.maps[g]
            columns = [[matrix[i][j] for i in range(p.d)] for j in range(p.d)]
            must(same_matrix([[p.dot(x, y) for y in columns] for x in columns], p.gram), f"γ{g} is no isometry")
            for j in range(p.rank):
                must(all(len(x.c) == 1 and x.c[0].denominator == 1 and (i < p.rank or x.c[0] == 0) for i, x in enumerate(columns[j])),
                     f"γ{g} does not keep the lattice")
        reached, fresh = {0}, [0]
        while fresh:
            m = fresh.pop()
            for g, products in p.products.items():
                n = products[m]
                a, b = p.maps[g], p.maps[m]
                linear = [[sum((a[0][i][k] * b[0][k][j] for k in range(p.d)), p.zero) for j in range(p.d)] for i in range(p.d)]
                must(same_matrix(linear, p.maps[n][0]), f"γ{g} γ{m} is not γ{n}")
                self.lattice_vector([x - y for x, y in zip(p.apply(g, b[1]), p.maps[n][1])], f"γ{g} γ{m} and γ{n}")
                if n not in reached:
                    reached.add(n)
                    fresh.append(n)
        must(reached == set(range(len(p.maps))), "not all isometries are products of the generators")
        keys = {(tuple(key(x) for row in m for x in row), p.reduced(t)[0]) for m, t in p.maps}
        must(len(keys) == len(p.maps), "two isometries agree up to the lattice")
        stated = {}
        if "% acutile:stabilisers" in p.text:
            for tile, numbers in re.findall(r"\$T_\{(\d+)\}\$: (.*?)(?:;|\.$)", p.line_after("stabilisers")):
                stated[int(tile)] = [int(x) for x in re.findall(r"\d+", numbers)]
        for tile, corners in p.tiles.items():
            own = self.name([tuple(c) for c in corners])
            fixing = stated.get(tile, [0])
            for m in fixing:
                must(self.name(self.image(m, tile)) == own, f"γ{m} does not fix T{tile}")
            if len(p.maps) > 1:
                must(p.counts[tile][0] == len(fixing), f"T{tile}: the number s")
                must(p.counts[tile][0] * p.counts[tile][1] == len(p.maps), f"T{tile}: the number of images")

    def lattice_vector(self, vector, what):
        p = self.p
        must(all(len(x.c) == 1 and x.c[0].denominator == 1 and (i < p.rank or x.c[0] == 0) for i, x in enumerate(vector)),
             f"{what} differ by no lattice vector")

    def image(self, m, tile, by=None):
        p = self.p
        corners = [self.corner_image(m, tuple(c)) for c in p.tiles[tile]]
        return [(c[0], *[a + b for a, b in zip(c[1:], by or [0] * p.rank)]) for c in corners]

    def corner_image(self, m, c):
        """Neighbours share corners, so each image is found once."""
        if (m, c) not in self.moved:
            self.moved[m, c] = tuple(self.p.named(self.p.apply(m, self.p.point(c))))
        return self.moved[m, c]

    def name(self, corners):
        ordered = sorted(corners)
        first = ordered[0][1:]
        return tuple((c[0], *[a - b for a, b in zip(c[1:], first)]) for c in ordered)

    def determinants(self):
        """(O), and that every vertex occurs."""
        p = self.p
        for tile, corners in p.tiles.items():
            det = p.det([p.point(c) for c in corners])
            check_justified(p.k, p.dets[tile], det, f"T{tile}, determinant")
            must(det.sign() > 0, f"T{tile}: the determinant is not positive")
        for v, origin in enumerate(p.origins):
            m, c, tile = re.fullmatch(r"(?:\$\\gamma_\{(\d+)\}\$, )?\$c_(\d)\$ of \$T_\{(\d+)\}\$", origin).groups()
            must(self.image(int(m or 0), int(tile))[int(c)][0] == v, f"vertex {v}: {origin}")

    def facets(self):
        """(F): the other tile has the facet and d, and d is on the other side."""
        p, rows = self.p, self.p.table("pairing")
        self.apex, expected = {}, [(tile, i) for tile in p.order for i in range(p.d + 1)]
        must(len(rows) == len(expected), "not every facet has a row")
        for row, (tile, i) in zip(rows, expected):
            what = f"T{tile}, facet {i}"
            must(row[0] == f"$T_{{{tile}}}$" and int(row[1]) == i, f"{what}: another row")
            corners = [tuple(c) for c in p.tiles[tile]]
            facet = corners[:i] + corners[i + 1:]
            text = math(row[2])
            if text.startswith("\\partial"):
                self.in_face(facet, text, what)
                continue
            d = tuple(corner(text, p.rank))
            m, other, by = re.fullmatch(r"(?:\\gamma_\{(\d+)\})?T_\{(\d+)\}(?:\^\{(.*)\})?", math(row[3])).groups()
            found = self.image(int(m or 0), int(other), shift(by, p.rank))
            must(sorted(found) == sorted(facet + [d]), f"{what}: the other tile has other corners")
            must(found[int(row[4])] == d, f"{what}: d is another corner of it")
            det = p.det([p.point(c) for c in corners[:i] + [d] + corners[i + 1:]])
            check_justified(p.k, math(row[5]), det, f"{what}, determinant")
            must(det.sign() < 0, f"{what}: d is not on the other side")
            self.apex[tile, i] = (d, int(other), int(row[4]))

    def plane(self, f, point):
        """Zero in the plane of face f, and its sign at a point of the domain's inside is that at the other corners."""
        face, k = self.p.faces[f], len(self.p.faces[f][0][1])
        rest = point[self.p.d - k:]
        if k == 1:
            return rest[0] - face[0][1][0]
        origin = face[0][1]
        rows = [[b - a for a, b in zip(origin, q)] for _, q in face[1:k]] + [[b - a for a, b in zip(origin, rest)]]
        return determinant(rows)

    def in_face(self, facet, text, what):
        if text == "\\partial":
            must("the region that is their union" in self.p.text, f"{what}: a facet without a face")
            return
        f = int(re.fullmatch(r"\\partial_\{(\d+)\}", text).group(1))
        must(all(self.plane(f, self.p.point(c)).sign() == 0 for c in facet), f"{what}: not in face {f}")

    def boundary(self):
        """(B): all vertices on the inner side of each face; the values are as printed; the isometries keep P."""
        p = self.p
        if not p.faces:
            return
        corners = {n: q for face in p.faces for n, q in face}
        k = len(p.faces[0][0][1])
        pad = [p.zero] * (p.d - k)
        printed = p.line_after("boundary").rstrip(".").split("; ")
        for f in range(len(p.faces)):
            values = [self.plane(f, p.point([v] + [0] * p.rank)) for v in range(len(p.vertices))]
            inside = next(s for s in (self.plane(f, pad + q).sign() for q in corners.values()) if s)
            values = [x * inside for x in values]
            must(all(x.sign() >= 0 for x in values), f"(B): a vertex beyond face {f}")
            counts, found = Counter(map(key, values)), []
            by_key = {key(x): x for x in values}
            for text, times in re.findall(r"\$((?:[^$])*)\$(?: \(\$(\d+)\$ times\))?", printed[f].split(": ", 1)[1]):
                found.append((text, int(times or 1)))
            must(sum(n for _, n in found) == len(values), f"face {f}: not all vertices are counted")
            for text, n in found:
                if text.startswith("\\in"):
                    continue
                value = number(p.k, text.split("\\quad")[0])
                must(counts.get(key(value)) == n, f"face {f}: {text} occurs {counts.get(key(value))} times, not {n}")
                check_justified(p.k, text, by_key[key(value)], f"face {f}")
        if p.images:
            for m, places in enumerate(p.images):
                for n, q in corners.items():
                    must([key(x) for x in p.apply(m, pad + q)[p.d - k:]] == [key(x) for x in corners[places[n]]], f"γ{m} moves the corner {n} elsewhere")
                for x in range(p.d - k):
                    must(all(p.maps[m][0][r][x].sign() == 0 for r in range(p.d - k, p.d)), f"γ{m} mixes the coordinates")

    def domain_volume(self):
        """D! times the volume that the tiles have to fill."""
        p, factorial = self.p, 2 if self.p.d == 2 else 6
        if not p.faces:
            return p.one * factorial
        k = len(p.faces[0][0][1])
        if k == 1:
            height = p.faces[1][0][1][0] - p.faces[0][0][1][0]
            return (height if height.sign() > 0 else -height) * factorial
        apex, total = p.faces[0][0][1], p.zero
        for face in p.faces:
            points = [q for _, q in face]
            for a, b in ([(0, 1)] if k == 2 else [(i, i + 1) for i in range(1, len(points) - 1)]):
                chosen = [points[a], points[b]] if k == 2 else [points[0], points[a], points[b]]
                cone = determinant([[y - x for x, y in zip(apex, q)] for q in chosen])
                total = total + (cone if cone.sign() > 0 else -cone)
        return total * F(factorial, 2 if k == 2 else 6)

    def whole(self):
        """All tiles: their number, their volume (V), and one other tile at each facet, on the other side."""
        p = self.p
        self.all = {}
        for tile in p.tiles:
            images = {self.name(self.image(m, tile)) for m in range(len(p.maps))}
            must(len(images) == p.counts[tile][1], f"T{tile} has {len(images)} images, not {p.counts[tile][1]}")
            for image in images:
                must(image not in self.all, f"T{tile} and T{self.all.get(image)} have an image in common")
                self.all[image] = tile
        stated = re.search(r"There are \$(\d+)\$ t", p.text)
        must(not stated or int(stated.group(1)) == len(self.all), "the theorem's number of tiles")
        total, facets = p.zero, defaultdict(list)
        for corners in self.all:
            points = [p.point(c) for c in corners]
            det = p.det(points)
            total = total + (det if det.sign() > 0 else -det)
            for i in range(p.d + 1):
                facet = corners[:i] + corners[i + 1:]
                first = facet[0][1:]
                plane = [[b - a for a, b in zip(p.point(facet[0]), p.point(c))] for c in facet[1:]]
                side = determinant(plane + [[b - a for a, b in zip(p.point(facet[0]), points[i])]]).sign()
                facets[tuple((c[0], *[a - b for a, b in zip(c[1:], first)]) for c in facet)].append(side)
        free = [facet for facet, sides in facets.items() if len(sides) == 1]
        must(all(sorted(sides) == [-1, 1] for sides in facets.values() if len(sides) != 1), "a facet without one tile on each side")
        if "the region that is their union" in p.text:
            return
        for facet in free:
            must(any(all(self.plane(f, p.point(c)).sign() == 0 for c in facet) for f in range(len(p.faces))), f"an open facet: {facet}")
        expected = self.domain_volume()
        must(total == expected, f"(V): the volumes sum up to {total.c}, not {expected.c}")
        start = next(n for n, line in enumerate(self.p.lines) if line.startswith("% acutile:volume"))
        text, n = "", start + 1
        while p.lines[n].startswith("\\[ "):
            end = next(k for k in range(n, len(p.lines)) if p.lines[k].startswith("\\end{aligned}"))
            text += " ".join(p.lines[n + 1:end]) + " "
            n = end + 1
        text = text.replace("\\\\", " ").replace("&", " ").replace("\\quad{}", " ")
        left, right = text.rstrip(" ,").split("=")
        must(number(p.k, right) == expected, "(V): another sum is printed")
        if "\\sum" in left:
            return
        terms = [term.split("\\cdot", 1) for term in re.split(r"(?:^|\+)\s*(?=\d+\\cdot)", left.strip())[1:]]
        expected = Counter()
        for tile in p.order:
            expected[key(p.det([p.point(c) for c in p.tiles[tile]]))] += p.counts[tile][1]
        must({key(number(p.k, factor)): int(count) for count, factor in terms} == expected and len(terms) == len(expected),
             "(V): the terms are others than in the table")

    def region(self):
        """The list of boundary facets, (X) for all pairs by ranges or by the printed function, and (W)."""
        p, facets, classes = self.p, [], []
        for n, row in enumerate(p.table("boundary-facets")):
            must(row[0] == f"$f_{{{n}}}$", "the boundary facets are not numbered in order")
            tile, i = int(re.search(r"\d+", row[1]).group(0)), int(row[2])
            corners = [tuple(corner(math(x), p.rank)) for x in row[3:3 + p.d]]
            must(corners == [tuple(c) for k, c in enumerate(p.tiles[tile]) if k != i] and (tile, i) not in self.apex, f"f{n} is no boundary facet")
            facets.append((tile, i, corners))
            classes.append(int(re.search(r"\d+", row[3 + p.d]).group(0)))
        must(facets and len({(t, i) for t, i, _ in facets}) == len(p.tiles) * (p.d + 1) - len(self.apex), "boundary facets are missing")
        ridges = defaultdict(list)
        for n, (_, _, corners) in enumerate(facets):
            for left in range(p.d):
                ridges[self.name(corners[:left] + corners[left + 1:])].append(n)
        joined = list(range(len(facets)))
        for pair in (pair for pair in ridges.values() if len(pair) == 2):
            low, high = sorted(joined[n] for n in pair)
            joined = [low if x == high else x for x in joined]
        must(joined == classes, "the classes of boundary facets")
        self.check_pairs(facets)
        self.check_outside(facets, sorted(set(classes)))

    def near(self, first, second):
        """The lattice vectors that move the second points so that the ranges of all coordinates meet."""
        p, found = self.p, [[]]
        for k in range(p.d):
            a, b = sorted_ends(x[k] for x in first), sorted_ends(x[k] for x in second)
            low, high = a[0] - b[1], a[1] - b[0]
            if k < p.rank:
                found = [f + [s] for f in found for s in range(-floor(-low), floor(high) + 1)]
            elif low.sign() > 0 or high.sign() < 0:
                return []
        return found

    def check_pairs(self, facets):
        p, printed = self.p, {}
        if "are too many or too far apart to be printed" in p.text:
            return
        for row in p.table("pairs"):
            i = int(re.search(r"\d+", row[0]).group(0))
            j, by = re.fullmatch(r"\$f_\{(\d+)\}(?:\^\{(.*)\})?\$", row[1]).groups()
            w = [number(p.k, x) for x in math(row[2])[1:-1].split(",\\,")]
            printed[i, int(j), tuple(shift(by, p.rank))] = (w, number(p.k, math(row[3])))
        moved = lambda c, by: (c[0], *[a + b for a, b in zip(c[1:], by)])
        for i, (_, _, first) in enumerate(facets):
            for j in range(i, len(facets)):
                second = facets[j][2]
                for by in self.near([p.point(c) for c in first], [p.point(c) for c in second]):
                    if i == j and (not any(by) or next(x for x in by if x) < 0):
                        continue
                    must((i, j, tuple(by)) in printed, f"(X): f{i} and f{j} moved by {by} are not in the table")
                    w, c = printed[i, j, tuple(by)]
                    value = lambda x: sum((a * b for a, b in zip(w, p.point(x))), p.zero) - c
                    must(all(value(x).sign() <= 0 for x in first), f"(X): f{i} and f{j}: w > c on the first")
                    for x in (moved(x, by) for x in second):
                        must(value(x).sign() == (0 if x in first else 1), f"(X): f{i} and f{j}: w on the second")

    def check_outside(self, facets, bases):
        p, rows = self.p, {}
        if "Vertices are too far apart for the tiles" in p.text:
            return
        for row in p.table("outside"):
            base = int(re.search(r"\d+", row[0]).group(0))
            tile, by = re.fullmatch(r"\$T_\{(\d+)\}(?:\^\{(.*)\})?\$", row[1]).groups()
            rows[base, int(tile), tuple(shift(by, p.rank))] = (int(row[2]), math(row[3]))
        for base in bases:
            own, _, corners = facets[base]
            points = [p.point(c) for c in corners]
            centre = [sum((q[k] for q in points), p.zero) / p.d for k in range(p.d)]
            stated = re.search(rf"\$m=\(([^$]*)\)\$ of \$f_\{{{base}\}}\$", p.text).group(1)
            must([number(p.k, x) for x in stated.split(",\\,")] == centre, f"(W): the centre of f{base}")
            for tile in p.order:
                tile_points = [p.point(c) for c in p.tiles[tile]]
                for by in self.near([centre], tile_points):
                    if tile == own and not any(by):
                        continue
                    must((base, tile, tuple(by)) in rows, f"(W): T{tile} moved by {by} is not in the table for f{base}")
                    k, text = rows[base, tile, tuple(by)]
                    m = [x - (by[n] if n < p.rank else 0) for n, x in enumerate(centre)]
                    beta = p.det(tile_points[:k] + [m] + tile_points[k + 1:]) / p.det(tile_points)
                    check_justified(p.k, text, beta, f"(W): f{base} and T{tile}")
                    must(beta.sign() < 0, f"(W): T{tile} may contain the centre of f{base}")

    def powers(self):
        """Delaunay: the power of d by the circumcentre, for every facet or the other side of it."""
        p, rows, seen = self.p, self.p.table("delaunay"), set()
        if not rows:
            must("no vertex of the tiling but" not in p.text or not self.apex, "no table of powers")
            return
        for row in rows:
            tile, i = int(re.fullmatch(r"\$T_\{(\d+)\}\$", row[0]).group(1)), int(row[1])
            d = self.apex[tile, i][0]
            must(tuple(corner(math(row[2]), p.rank)) == d, f"T{tile}, facet {i}: another d")
            power = self.power([p.point(c) for c in p.tiles[tile]], p.point(d))
            check_justified(p.k, math(row[3]), power, f"T{tile}, facet {i}, power")
            must(power.sign() > (-1 if "is nonnegative" in p.text else 0), f"T{tile}, facet {i}: not Delaunay")
            seen.add((tile, i))
        open_facets = {facet for facet, (_, other, j) in self.apex.items() if facet not in seen and (other, j) not in seen}
        must(not open_facets, f"facets without a power: {open_facets}")

    def power(self, corners, point):
        """|x-z|² - r² with the centre z = c0 + y, 2 <e_i, y> = |e_i|², solved by Cramer's rule."""
        p = self.p
        edges = [[b - a for a, b in zip(corners[0], c)] for c in corners[1:]]
        matrix = [[sum((p.gram[i][j] * e[i] for i in range(p.d)), p.zero) for j in range(p.d)] for e in edges]
        right = [p.dot(e, e) / 2 for e in edges]
        base = determinant(matrix)
        y = [determinant([[right[r] if c == n else x for c, x in enumerate(row)] for r, row in enumerate(matrix)]) / base for n in range(p.d)]
        self.centre = y
        away = [b - a - c for a, b, c in zip(corners[0], point, y)]
        return p.dot(away, away) - p.dot(y, y)

    def shapes(self):
        """Each class: the squared edges of its first tile, the squared circumradius and its quotient."""
        p = self.p
        starts = [n for n, line in enumerate(p.lines) if line.startswith("% acutile:edges")]
        must(len(starts) == max(p.classes.values()) + 1, "not every class has its edges")
        for n in starts:
            kind, tile = re.search(r"Class (\d+)\.\}.*the first is \$T_\{(\d+)\}\$", p.lines[n - 1]).groups()
            must(p.classes[int(tile)] == int(kind), f"T{tile} is in another class")
            points = [p.point(c) for c in p.tiles[int(tile)]]
            edge = lambda i, j: [b - a for a, b in zip(points[i], points[j])]
            lengths = {(i, j): p.dot(edge(i, j), edge(i, j)) for i in range(p.d + 1) for j in range(i + 1, p.d + 1)}
            found = re.findall(r"l_\{(\d)(\d)\}=([^$]*)\$", p.lines[n + 1])
            must(len(found) == len(lengths), f"class {kind}: the number of edges")
            for i, j, text in found:
                must(number(p.k, text) == lengths[int(i), int(j)], f"class {kind}: l_{i}{j}")
            least, square, ratio = re.search(r"\$l=(.*?)\$.*\$R\^2=(.*?)\$, and \$R\^2/l=(.*?)\$", p.lines[n + 2]).groups()
            least = number(p.k, least)
            must(all((x - least).sign() >= 0 for x in lengths.values()) and least in lengths.values(), f"class {kind}: the shortest edge")
            self.power(points, points[0])
            radius = p.dot(self.centre, self.centre)
            must(number(p.k, square) == radius and number(p.k, ratio) == radius / least, f"class {kind}: the circumradius")


def main():
    directory, wrong = Path(sys.argv[1]), 0
    for name in sys.argv[2:]:
        try:
            print(f"{name}: {Referee(source(directory / f'tiling-{name}.tex')).run()}")
        except Wrong as error:
            wrong += 1
            print(f"{name}: {error}")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
