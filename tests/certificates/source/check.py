"""A slow checker of format 2: it answers with the code of the first refusal, or None.

It reads JSON, keeps everything in memory and decides by brute force. Its only limits are the degree 8 and 4096 bits. It shares the number
fields with the generator, and nothing with the program. `make.py --check` compares its answers with the names.
"""
import json
import math
import re
from fractions import Fraction as F

from .build import LARGEST, RATIO, RELATIONS, SMALLEST, TILING, edges, facets, from_first
from .encode import text
from .field import Field, Q, Undecided, determinant, figures, inner, products, signed, times
from .meet import covered, meet_wrongly

ORDER = [TILING, "acute", "nonobtuse", LARGEST, SMALLEST, RATIO, "Delaunay", "weakly Delaunay", "locally Delaunay",
         "locally weakly Delaunay", "TCP"]
DELAUNAY = {"Delaunay": 1, "weakly Delaunay": 0, "locally Delaunay": 1, "locally weakly Delaunay": 0}


class Refusal(Exception):
    pass


def ensure(condition, code):
    if not condition:
        raise Refusal(code)


def code_of(data):
    try:
        check(read(data))
    except Refusal as refusal:
        return str(refusal)
    except Undecided:
        return "sign-undecided"
    return None


# --- bytes and shape ---------------------------------------------------------------

def no_such(_):
    raise Refusal("json")


def decimal(literal):
    """A whole number in another notation; `text` does not write it so."""
    value = F(literal)
    ensure(value.denominator == 1, "json")
    return int(value)


def read(data):
    try:
        value = json.loads(data.decode("ascii"), parse_float=decimal, parse_constant=no_such,
                           object_pairs_hook=lambda pairs: dict(pairs))
    except (ValueError, RecursionError):
        raise Refusal("json") from None
    value = numbers(value)
    shape(value)
    ensure((text(value) + "\n").encode() == data, "canonical")
    return value


def numbers(value):
    """Integers that are written as texts become integers; `text` writes them as texts again."""
    if isinstance(value, str) and re.fullmatch("-?[1-9][0-9]*", value):
        ensure(len(value) < 1300 and abs(int(value)) < 2 ** 4096, "too-many-digits")
        return int(value)
    if isinstance(value, list):
        return [numbers(item) for item in value]
    if isinstance(value, dict):
        return {key: numbers(item) for key, item in value.items()}
    return value


def record(value, **members):
    ensure(isinstance(value, dict) and set(value) == set(members), "json")
    ensure(list(value) == list(members), "canonical")
    for key, check_member in members.items():
        check_member(value[key])


def array(item, length=None):
    def check_array(value):
        ensure(isinstance(value, list) and length in (None, len(value)), "json")
        for x in value:
            item(x)
    return check_array


def integer(value):
    ensure(type(value) is int, "json")


def a_text(value):
    ensure(isinstance(value, str) and re.fullmatch("[ -~]*", value), "json")


def shape(value):
    record(value, format=a_text, version=integer, kind=a_text, claim=lambda _: None, witness=lambda _: None)
    ensure(value["format"] == "acutile-certificate", "format")
    ensure(value["version"] == 2, "version")
    ensure(value["kind"] == "tiling", "kind")
    claim = value["claim"]
    ensure(isinstance(claim, dict) and "dimension" in claim and "field" in claim and "domain" in claim, "json")
    integer(claim["dimension"])
    d = claim["dimension"]
    ensure(d in (2, 3), "dimension")
    number = integer
    if claim["field"] != "Q":
        record(claim["field"], polynomial=array(integer),
               root=lambda root: record(root, low=integer, high=integer, denominator=integer))
        p = claim["field"]["polynomial"]
        ensure(len(p) >= 3 and p[-1] == 1, "polynomial")
        ensure(len(p) <= 9, "degree")
        number = array(integer, len(p) - 1)
    rank = domain_shape(claim["domain"], d, number)

    def gram(rows):
        array(array(number))(rows)
        ensure([len(row) for row in rows] == list(range(d, 0, -1)), "json")
    fraction = array(lambda x: None, 2)

    def bound_fraction(x):
        fraction(x)
        number(x[0])
        integer(x[1])

    def statement(s):
        if isinstance(s, list):
            ensure(s and isinstance(s[0], str), "json")
            ensure(s[0] in (LARGEST, SMALLEST, RATIO), "statements")
            ensure(len(s) == (3 if s[0] == RATIO else 4), "json")
            a_text(s[1])
            ensure(s[1] in RELATIONS, "statements")
            if s[0] != RATIO:
                integer(s[2])
            bound_fraction(s[-1])
        else:
            a_text(s)
            ensure(s in ORDER and s not in (LARGEST, SMALLEST, RATIO), "statements")
    record(claim, dimension=integer, field=lambda _: None, gram=gram, domain=lambda _: None, statements=array(statement))
    tcp = "TCP" in claim["statements"]

    def corner(c):
        if isinstance(c, list):
            array(integer, rank + 1)(c)
            ensure(any(c[1:]), "canonical")
        else:
            integer(c)

    def row(r):
        ensure(isinstance(r, list) and len(r) == d + 1 + tcp, "json")
        for c in r[:d + 1]:
            corner(c)
        if tcp:
            integer(r[-1])
    record(value["witness"], denominator=integer, vertices=array(array(number, d)), boundary=array(array(corner, d)),
           simplices=array(row))


def domain_shape(domain, d, number):
    if domain == "space":
        return d
    ensure(isinstance(domain, list) and len(domain) == 2, "json")
    kind, body = domain
    if kind == "region":
        integer(body)
        ensure(0 <= body <= d, "region-rank")
        return body
    ensure(kind in ("slab", "prism", "solid"), "json")
    k = {"slab": 1, "prism": 2, "solid": d}[kind]
    ensure(kind != "prism" or d == 3, "prism-dimension")
    record(body, denominator=integer, vertices=array(array(number, k)), faces=array(array(integer)))
    return d - k


# --- the claim ------------------------------------------------------------------------

def coefficients(x):
    return x if isinstance(x, list) else [x]


def lowest(denominator, numbers_):
    ensure(denominator > 0, "denominator")
    ensure(math.gcd(denominator, *(c for x in numbers_ for c in coefficients(x))) == 1, "canonical")


def field_of(claim):
    if claim["field"] == "Q":
        return Q
    p, root = claim["field"]["polynomial"], claim["field"]["root"]
    low, high, denominator = root.values()
    ensure(low < high and denominator > 0, "root-order")
    ensure(math.gcd(low, high, denominator) == 1, "canonical")
    field = Field(p, F(low, denominator), F(high, denominator))
    ensure(field.value(field.low) * field.value(field.high) < 0, "root-signs")
    least, greatest = field.range([k * c for k, c in enumerate(p)][1:], field.low, field.high)
    ensure(least > 0 or greatest < 0, "root-derivative")
    return field


class Claim:
    def __init__(self, claim):
        self.f = f = field_of(claim)
        self.d = d = claim["dimension"]
        rows = claim["gram"]
        ensure(math.gcd(*(c for row in rows for x in row for c in coefficients(x))) in (0, 1), "canonical")
        full = [[rows[min(i, j)][abs(i - j)] for j in range(d)] for i in range(d)]
        self.gram = [[f.element(x) for x in row] for row in full]
        for k in range(1, d + 1):
            ensure(f.sign(determinant(f, [row[:k] for row in self.gram[:k]])) > 0, "gram-not-positive")
        self.region = self.polytope = None
        self.rank = d
        if claim["domain"] != "space":
            kind, body = claim["domain"]
            if kind == "region":
                self.region, self.rank = body, body
            else:
                self.polytope = Polytope(f, body, kind)
                self.rank = d - self.polytope.k
        self.statements = claim["statements"]
        self.check_statements(claim["domain"])

    def check_statements(self, domain):
        places = [(ORDER.index(s), 0) if isinstance(s, str) else (ORDER.index(s[0]), RELATIONS.index(s[1]))
                  for s in self.statements]
        ensure(places and places[0] == (0, 0) and places == sorted(set(places)), "statements")
        for s in self.statements:
            if isinstance(s, str):
                space = domain == "space"
                good = {"TCP": self.d == 3 and space, "Delaunay": self.region is None, "weakly Delaunay": self.region is None,
                        "locally Delaunay": self.region is not None, "locally weakly Delaunay": self.region is not None}
                ensure(good.get(s, True), "statement-domain")
                continue
            numerator, denominator = s[-1]
            ensure(denominator > 0, "bound-range")
            ensure(math.gcd(denominator, *coefficients(numerator)) == 1, "canonical")
            value = times(self.f.element(numerator), F(1, denominator))
            sign = self.f.sign(value)
            if s[0] == RATIO:
                ensure(sign > 0, "bound-range")
            else:
                ensure(s[2] in (-1, 0, 1) and sign == abs(s[2]), "bound-range")
                ensure(self.f.sign(self.f.subtract(self.f.element(1), value)) >= 0, "bound-range")


class Polytope:
    def __init__(self, f, body, kind):
        self.f = f
        vertices, faces = body["vertices"], body["faces"]
        self.k = k = {"slab": 1, "prism": 2, "solid": None}[kind] or (len(vertices[0]) if vertices else 3)
        self.denominator, self.faces = body["denominator"], faces
        ensure(self.denominator > 0, "denominator")
        lowest(self.denominator, [x for v in vertices for x in v])
        ensure(len(faces) >= k + 1, "face-count")
        for face in faces:
            ensure(len(face) == k if k < 3 else len(face) >= 3, "face-length")
            ensure(all(0 <= w < len(vertices) for w in face) and len(set(face)) == len(face), "face-vertices")
        ensure(len(set(map(frozenset, faces))) == len(faces), "face-repeated")
        ensure({w for face in faces for w in face} == set(range(len(vertices))), "unused-domain-vertex")
        self.points = [[times(f.element(x), F(1, self.denominator)) for x in v] for v in vertices]
        self.inside = []
        for face in faces:
            signs = [f.sign(self.height(face, x)) for x in self.points]
            ensure(all(signs[w] == 0 for w in face), "face-not-facet")
            others = {s for w, s in enumerate(signs) if w not in face}
            ensure(others in ({1}, {-1}), "face-not-facet")
            self.inside.append(others.pop())
        if k == 3:
            for face in faces:
                self.check_convex(face)
        ridges = [frozenset(pair) for face in faces for pair in zip(face, face[1:] + face[:1])] if k == 3 else \
            [w for face in faces for w in face] if k == 2 else []
        ensure(all(ridges.count(ridge) == 2 for ridge in ridges), "faces-not-closed")

    def height(self, face, x):
        base, *rest = [self.points[w] for w in face[:self.k]]
        return determinant(self.f, [[self.f.subtract(a, b) for a, b in zip(y, base)] for y in [*rest, x]])

    def check_convex(self, face):
        """Seen from a vertex that is not in the face, each side has the rest of the face on one side."""
        apex = next(x for w, x in enumerate(self.points) if w not in face)
        signs = set()
        for i in range(len(face)):
            a, b = (self.points[face[(i + j) % len(face)]] for j in (0, 1))
            for w in face:
                if self.points[w] not in (a, b):
                    rows = [[self.f.subtract(p, q) for p, q in zip(y, apex)] for y in (a, b, self.points[w])]
                    signs.add(self.f.sign(determinant(self.f, rows)))
        ensure(signs in ({1}, {-1}), "face-not-convex")

    def volume(self):
        """k! times the volume: the pyramids over a fan of each face from the first vertex."""
        f, apex = self.f, self.points[0]
        total = f.element(0)
        for face, inside in zip(self.faces, self.inside):
            for i in range(1, max(2, len(face) - 1)):
                fan = [face[0], *face[i:i + self.k - 1]] if self.k > 1 else face
                total = f.add(total, times(self.height(fan, apex), inside) if self.k > 1 else
                              times(f.subtract(apex[0], self.points[face[0]][0]), inside))
        return total


# --- the witness -------------------------------------------------------------------------

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
    if local is not None:
        check_delaunay(claim, position, rows, listed)


def check_delaunay(claim, position, rows, listed):
    """The mate's opposite corner and the circumsphere, for each facet that two rows have."""
    f = claim.f
    strict = any(s in claim.statements for s in ("Delaunay", "locally Delaunay"))
    first = {}
    for row in rows:
        corners = sorted(row)
        for i, (name, _) in enumerate(facets(row)):
            others = corners[:i] + corners[i + 1:]
            opposite = (corners[i][0], *(s - t for s, t in zip(corners[i][1:], others[0][1:])))
            if name not in first:
                first[name] = (name, opposite)
                continue
            power = outside(f, claim.gram, position, [*name, first[name][1]], opposite)
            ensure(power >= 0, "not-delaunay" if strict else "not-weakly-delaunay")
            ensure(power > 0 or not strict, "not-delaunay")


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
