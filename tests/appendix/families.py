#!/usr/bin/env python3
"""Checks the appendices of families: polynomials, Bernstein coefficients, and members at points of the box.

    tests/appendix/families.py DIR

For each polynomial the printed coefficients b must be a positive multiple of those that interpolation gives, and
show the sign. At some points of the box the printed names and coordinates must be a tiling: positive determinants,
each facet twice, on different sides, and volumes that sum up to the same. Families over the rationals with one box.
"""
import itertools, re, sys
from collections import defaultdict
from fractions import Fraction as F
from pathlib import Path

from exact import Wrong, must
from formulas import corner, math, rows_of, source
from tiling import determinant


def polynomial(text, names):
    """A Python function of the parameters."""
    text = text.replace("\\,", "")
    for name in sorted(names, key=len, reverse=True):
        shown = name if len(name) == 1 else f"\\mathit{{{name}}}"
        text = text.replace(shown, f" v['{name}'] ")
    text = re.sub(r"\^\{(\d+)\}", r" **\1 ", text)
    text = re.sub(r"\\frac\{(-?\d+)\}\{(\d+)\}", r"(\1/\2)", text)
    text = re.sub(r"(?<![\w'\[*])(\d+)", r"F(\1)", text)
    text = re.sub(r"([)\]]|\*\*\d+)\s+(?=[v(F])", r"\1*", text.strip())
    text = re.sub(r"\)(?=F|v|\()", ")*", text)
    return lambda values: eval(text, {"F": F, "v": values})


class Family:
    def __init__(self, text):
        self.lines = text.split("\n")
        theorem = text[:text.index("\\end{acutiletheorem}")]
        box = theorem[theorem.index("Let ") + 4:theorem.index(". Let $b_1$")]
        self.box = {}
        for low, left, name, right, high in re.findall(r"\$([-\d/]+)(<|\\le )(?:\\mathit\{)?([a-z0-9_\\]+?)\}?(<|\\le )([-\d/]+)\$", box):
            self.box[name.replace("\\", "")] = (F(low), left == "<", F(high), right == "<")
        must(self.box, f"no box: {box}")
        self.names = list(self.box)
        self.rank = len(re.findall("b_", re.search(r"\\Lambda=(.*?)\$", theorem).group(1))) if "\\Lambda=" in theorem else 0
        self.vertices = [[polynomial(math(x), self.names) for x in row[1:]] for row in self.table("vertices")]
        self.d = len(self.vertices[0])
        self.tiles = [[tuple(corner(math(x), self.rank)) for x in row[1:]] for row in self.table("orbits")]

    def table(self, mark):
        start = next(n for n, line in enumerate(self.lines) if line.startswith(f"% acutile:table {mark} "))
        return rows_of(self.lines, start)

    def check_signs(self):
        count = 0
        for row in self.table("signs-of-polynomials"):
            text, strict = math(row[1]), row[1].rstrip("$").endswith(">0")
            p = polynomial(re.sub(r"(>0|\\ge0)$", "", text), self.names)
            boxes = row[3].split(";") if row[3] else []
            if len(boxes) != 1:
                continue
            found = [F(x) for x in re.findall(r"\$([-\d/]+)\$", row[3])]
            expected, degrees = self.bernstein(p, text)
            scale = next((a / b for a, b in zip(found, expected) if b), None)
            must(len(found) == len(expected) and scale and scale > 0, f"{text}: other coefficients")
            must(all(a == scale * b for a, b in zip(found, expected)), f"{text}: {found} is no multiple of {expected}")
            must(all(b >= 0 for b in found), f"{text}: a negative coefficient")
            if strict:
                self.check_faces(text, found, degrees)
            count += 1
        return count

    def bernstein(self, p, text):
        """By interpolation at k/n on each axis, one axis after the other."""
        degrees = []
        for name in self.names:
            shown = name if len(name) == 1 else f"\\mathit{{{name}}}"
            powers = [int(e or 1) for e in re.findall(re.escape(shown) + r"(?:\^\{(\d+)\})?", text)]
            degrees.append(max(powers, default=0))
        nodes = [[F(k, n) if n else F(0) for k in range(n + 1)] for n in degrees]
        values = {}
        for index in itertools.product(*(range(n + 1) for n in degrees)):
            at = {name: self.box[name][0] + (self.box[name][2] - self.box[name][0]) * nodes[k][i]
                  for k, (name, i) in enumerate(zip(self.names, index))}
            values[index] = F(p(at))
        for axis, n in enumerate(degrees):
            basis = [[u ** i * (1 - u) ** (n - i) for i in range(n + 1)] for u in nodes[axis]]
            for rest in itertools.product(*(range(m + 1) for k, m in enumerate(degrees) if k != axis)):
                keys = [rest[:axis] + (i,) + rest[axis:] for i in range(n + 1)]
                solved = solve(basis, [values[k] for k in keys])
                values.update(zip(keys, solved))
        return [values[i] for i in sorted(values)], degrees

    def check_faces(self, text, found, degrees):
        indices = sorted(itertools.product(*(range(n + 1) for n in degrees)))
        choices = []
        for name, n in zip(self.names, degrees):
            _, low_open, _, high_open = self.box[name]
            ends = ([] if low_open else [0]) + ([] if high_open else [n])
            choices.append(ends or [None])
        for choice in itertools.product(*choices):
            on = [b for i, b in zip(indices, found) if all(c is None or c == k for c, k in zip(choice, i))]
            must(any(b > 0 for b in on), f"{text}: zero on a face of the box")

    def check_member(self, share):
        at = {name: low + (high - low) * share for name, (low, _, high, _) in self.box.items()}
        points = [[F(p(at)) for p in vertex] for vertex in self.vertices]
        place = lambda c: [x + (c[1 + i] if i < self.rank else 0) for i, x in enumerate(points[c[0]])]
        facets, total = defaultdict(list), F(0)
        for t, corners in enumerate(self.tiles):
            at_corners = [place(c) for c in corners]
            det = determinant([[b - a for a, b in zip(at_corners[0], p)] for p in at_corners[1:]])
            must(det > 0, f"T{t}: the determinant is not positive at {at}")
            total += det
            for i in range(self.d + 1):
                facet = sorted(corners[:i] + corners[i + 1:])
                first = place(facet[0])
                rows = [[b - a for a, b in zip(first, place(c))] for c in facet[1:]] + [[b - a for a, b in zip(first, at_corners[i])]]
                shift = facet[0][1:]
                name = tuple((c[0], *[a - b for a, b in zip(c[1:], shift)]) for c in facet)
                facets[name].append(determinant(rows) > 0)
        must(all(sorted(sides) in ([False, True], [False], [True]) for sides in facets.values()), "a facet without one tile on each side")
        printed = sum(1 for row in self.table("pairing") if "partial" in row[2])
        must(sum(len(sides) == 1 for sides in facets.values()) == printed, "other facets in the boundary than printed")
        return total


def solve(matrix, right):
    rows = [list(row) + [x] for row, x in zip(matrix, right)]
    n = len(rows)
    for j in range(n):
        pivot = next(i for i in range(j, n) if rows[i][j])
        rows[j], rows[pivot] = rows[pivot], rows[j]
        rows[j] = [x / rows[j][j] for x in rows[j]]
        for i in range(n):
            if i != j and rows[i][j]:
                rows[i] = [x - rows[i][j] * y for x, y in zip(rows[i], rows[j])]
    return [row[n] for row in rows]


def main():
    wrong = families = signs = 0
    for path in sorted(Path(sys.argv[1]).glob("tiling-*.tex")):
        text = source(path)
        if "acutile:table signs-of-polynomials" not in text or "\\sqrt" in text[:text.index("% acutile:table pairing")]:
            continue
        try:
            family = Family(text)
            signs += family.check_signs()
            for share in (F(1, 3), F(1, 2), F(7, 9)):
                family.check_member(share)
            families += 1
        except Wrong as error:
            wrong += 1
            print(f"{path.name}: {error}")
    print(f"{families} families, {signs} signs by Bernstein coefficients; {wrong} wrong")
    sys.exit(1 if wrong or not signs else 0)


if __name__ == "__main__":
    main()
