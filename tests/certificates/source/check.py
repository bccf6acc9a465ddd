"""A slow checker of format 2: it answers with the code of the first refusal, or None.

It reads JSON, keeps everything in memory and decides by brute force. Its only limits are the degree 8 and 4096 bits.
It shares the number fields with the generator, and nothing with the program. `make.py --check` compares its answers
with the names.
"""
import math
from fractions import Fraction as F

from .build import CROSSED, LARGEST, RATIO, edges, facets, from_first
from .claim import Claim, lowest
from .field import Undecided, determinant, figures, inner, products, signed, times
from .meet import covered, meet_wrongly
from .shape import Refusal, ensure, read

DELAUNAY = {"Delaunay": 1, "weakly Delaunay": 0, "locally Delaunay": 1, "locally weakly Delaunay": 0}


def code_of(data):
    try:
        check(read(data))
    except Refusal as refusal:
        return str(refusal)
    except Undecided:
        return "sign-undecided"
    return None


def corners_of(raw, claim, vertices, sorted_row):
    corners = [tuple(c) if isinstance(c, list) else (c, *[0] * claim.rank) for c in raw]
    for c in corners:
        ensure(0 <= c[0] < len(vertices), "vertex-range")
        ensure(all(abs(s) < 2 ** 29 for s in c[1:]), "shift-range")
    ensure(not any(corners[0][1:]), "corner-order")
    *first, x, y = corners
    good = first == sorted(set(first)) and x != y and (not first or (first[-1] < x and first[-1] < y))
    ensure(good, "corner-order")
    return corners


def check(certificate):
    claim, witness = Claim(certificate["claim"]), certificate["witness"]
    f, d = claim.f, claim.d
    lowest(witness["denominator"], [x for v in witness["vertices"] for x in v])
    if claim.polytope:
        ensure(witness["denominator"] % claim.polytope.denominator == 0, "denominator-domain")
    vertices = [[times(f.element(x), F(1, witness["denominator"])) for x in v] for v in witness["vertices"]]
    on_face = []
    for v in vertices:
        on_face.append(set())
        if claim.polytope:
            p = claim.polytope
            for i, face in enumerate(p.faces):
                sign = f.sign(p.height(face, v[-p.k:])) * p.inside[i]
                ensure(sign >= 0, "vertex-outside")
                if sign == 0:
                    on_face[-1].add(i)

    def position(c):
        shift = [*c[1:], *[0] * (d - claim.rank)]
        return [f.add(x, f.element(s)) for x, s in zip(vertices[c[0]], shift)]
    ensure(bool(witness["boundary"]) == (claim.region is not None), "boundary-domain")
    ensure(witness["simplices"], "no-simplices")
    open_facets, listed = {}, {}
    boundary = []
    for raw in witness["boundary"]:
        corners = corners_of(raw, claim, vertices, False)
        name = tuple(from_first(sorted(corners)))
        ensure(name not in listed, "boundary-repeated")
        listed[name] = False
        open_facets[name] = (int(sorted(corners) == corners), None, None)
        boundary.append(corners)
    ensure(not meet_wrongly(f, boundary, position, claim.rank), "boundary-meets")
    rows = [corners_of(raw[:d + 1], claim, vertices, True) for raw in witness["simplices"]]
    hints = [raw[-1] for raw in witness["simplices"]] if "TCP" in claim.statements else None
    check_rows(claim, vertices, position, on_face, open_facets, listed, rows, hints)
    if claim.region is not None:
        ensure(not covered(f, boundary, rows, position, claim.rank), "covering")
    check_bounds(claim, position, rows)
    ensure(not open_facets or all(n in listed and not listed[n] for n in open_facets), "open-facet")
    ensure(all(listed.values()), "boundary-open")
    ensure({c[0] for row in rows for c in row} == set(range(len(vertices))), "unused-vertex")
    if claim.region is None:
        total = f.add(*(determinant(f, vectors(f, position, row)) for row in rows))
        k = claim.polytope.k if claim.polytope else 0
        expected = times(claim.polytope.volume(), math.factorial(d) // math.factorial(k)) if k else f.element(math.factorial(d))
        ensure(f.sign(f.subtract(total, expected)) == 0, "volume-sum")
    check_attained(claim, position, rows)
    if "not Delaunay" in claim.statements:
        ensure(any(power < 0 for power in powers(claim, position, rows)), "none-inside")


def vectors(f, position, row):
    base, *rest = map(position, row)
    return [[f.subtract(a, b) for a, b in zip(x, base)] for x in rest]


def check_rows(claim, vertices, position, on_face, open_facets, listed, rows, hints):
    f, d = claim.f, claim.d
    valences = {}
    for row in rows:
        for edge in edges(row) if hints else []:
            valences[edge] = valences.get(edge, 0) + 1
    local = max((DELAUNAY[s] for s in claim.statements if isinstance(s, str) and s in DELAUNAY), default=None)
    for index, row in enumerate(rows):
        if hints:
            ensure(0 <= hints[index] < 64, "sixes")
        corners = sorted(row)
        for i, (name, side) in enumerate(facets(row)):
            others = corners[:i] + corners[i + 1:]
            if set.intersection(*(on_face[c[0]] for c in others)):
                continue
            if name in open_facets:
                waiting, opposite, before = open_facets.pop(name)
                ensure(waiting != side, "facet-side")
                if name in listed:
                    listed[name] = True
            else:
                shift = others[0][1:]
                open_facets[name] = (side, (corners[i][0], *(s - t for s, t in zip(corners[i][1:], shift))), index)
        if hints:
            ensure(hints[index] in (0, 1, 2, 4, 8, 16, 32, 33, 18, 12), "triangle-valence")
            for p, edge in enumerate(edges(row)):
                ensure(valences[edge] == (6 if hints[index] >> p & 1 else 5), "edge-valence")
        ensure(f.sign(determinant(f, vectors(f, position, row))) > 0, "orientation")
        _, normals = products(f, claim.gram, vectors(f, position, row))
        signs = {-f.sign(normals[i][j]) for i in range(d + 1) for j in range(i)}
        ensure("acute" not in claim.statements or signs == {1}, "not-acute")
        ensure("nonobtuse" not in claim.statements or -1 not in signs, "not-nonobtuse")
    for s in claim.statements:
        if s[0] == CROSSED:
            check_plane(f, position, rows, s, claim.rank)
    if local is not None:
        check_delaunay(claim, position, rows)


def check_plane(f, position, rows, statement, rank):
    """No translate of the plane within a hundred steps has corners of a simplex on both sides."""
    _, normal, (p, q) = statement
    step = math.gcd(*normal[:rank])
    for row in rows:
        values = [f.add(*(times(x, n * q) for x, n in zip(position(c), normal))) for c in row]
        for k in range(-100, 101) if step else [0]:
            signs = {f.sign(f.subtract(x, f.element(p + q * step * k))) for x in values}
            ensure(not {-1, 1} <= signs, "plane-crossed")


def check_delaunay(claim, position, rows):
    strict = any(s in claim.statements for s in ("Delaunay", "locally Delaunay"))
    for power in powers(claim, position, rows):
        ensure(power >= 0, "not-delaunay" if strict else "not-weakly-delaunay")
        ensure(power > 0 or not strict, "not-delaunay")


def powers(claim, position, rows):
    """The mate's opposite corner and the circumsphere, for each facet that two rows have."""
    first = {}
    for row in rows:
        corners = sorted(row)
        for i, (name, _) in enumerate(facets(row)):
            others = corners[:i] + corners[i + 1:]
            opposite = (corners[i][0], *(s - t for s, t in zip(corners[i][1:], others[0][1:])))
            if name not in first:
                first[name] = (name, opposite)
                continue
            yield outside(claim.f, claim.gram, position, [*name, first[name][1]], opposite)


def outside(f, gram, position, simplex, x):
    """The sign of |x - c|^2 - R^2, by the lifted determinant."""
    base = position(simplex[0])
    rows = [[f.subtract(a, b) for a, b in zip(position(c), base)] for c in [*simplex[1:], x]]
    lifted = determinant(f, [[*row, inner(f, gram, row, row)] for row in rows])
    return f.sign(lifted) * f.sign(determinant(f, rows[:-1]))


def check_bounds(claim, position, rows):
    for s, value, bound in compared(claim, position, rows):
        sign = claim.f.sign(claim.f.subtract(value, bound)) * (1 if s[0] == RATIO else -1)
        allowed = {"less than": (-1,), "at most": (-1, 0), "maximum": (-1, 0), "more than": (1,), "at least": (0, 1),
                   "minimum": (0, 1)}[s[1]]
        ensure(sign in allowed, "ratio-bound" if s[0] == RATIO else "angle-bound")


def check_attained(claim, position, rows):
    missing = [s for s in claim.statements if not isinstance(s, str) and s[1] in ("maximum", "minimum")]
    for s, value, bound in compared(claim, position, rows):
        if s in missing and not any(claim.f.subtract(value, bound)):
            missing.remove(s)
    ensure(not missing, "not-attained")


def compared(claim, position, rows):
    """Each bound with each simplex: the values grow with the cosine or with the ratio."""
    f = claim.f
    bounds = [s for s in claim.statements if not isinstance(s, str)]
    seen = set()
    for row in rows if bounds else []:
        shape_of = vectors(f, position, row)
        if repr(shape_of) in seen:
            continue
        seen.add(repr(shape_of))
        large, little, quotient = figures(f, claim.gram, shape_of)
        for s in bounds:
            square = times(f.element(s[-1][0]), F(1, s[-1][1]))
            if s[0] == RATIO:
                yield s, quotient, square
            else:
                yield s, signed(f, large if s[0] == LARGEST else little), signed(f, (s[2], square))
