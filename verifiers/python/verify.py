#!/usr/bin/env python3
"""python3 verify.py FILE…: a checker of acutile's certificates of format 2, in plain Python.

It reads a certificate, in CBOR or JSON, and checks the hypotheses of docs/soundness.md, which imply that the
simplices tile the domain face to face, and every other statement of the claim. Codes of refusals are those of
docs/format.md. Numbers are integers, and integer polynomials in a root that is enclosed by fractions; no
floating-point number is used. The digest that it prints is that of the certificate's CBOR.

A family is a tiling whose numbers are polynomials in parameters. There each condition is proved in every leaf of a
tree of boxes, from the signs of Bernstein coefficients.
A certificate of the kind patches is about all tilings that its patches build (docs/format.md).

Every domain is checked, regions too: there it compares all pairs of boundary facets, and every boundary facet
with every simplex. So a region with many boundary facets takes long.

It leaves out limits on bytes, simplices and time. An integer has at most 4096 bits, a field degree 8, a simplex of
a region reaches over less than 1000 cells, and a polynomial has at most a million Bernstein coefficients.

Python 3.8 or newer, its standard library alone. Exit code: 0 if every file is verified; else 1 if one is
rejected (something stated is false); else 2 if one is malformed or unreadable; else 3 (declined).
"""

import hashlib
import json
import re
import sys
from collections import Counter
from fractions import Fraction
from functools import reduce
from itertools import combinations, islice, product
from math import ceil, comb, factorial, floor, gcd, prod

EXIT_CODES = {"declined": 3, "malformed": 2, "rejected": 1}
BITS, DEGREE, FAR, TRANSLATES, DEPTH, TURN = 4096, 8, 2 ** 29, 1000, 80, 60
PARAMETERS, EXPONENT, LEAVES, HALVINGS, COEFFICIENTS, POINTS = 64, 15, 4096, 64, 10 ** 6, 1000


class Refusal(Exception):
    """`points` are those of a family's box that may refute a condition, which is not proved."""

    def __init__(self, kind, code, message, points=None):
        super().__init__(message)
        self.kind, self.code, self.points = kind, code, points


def require(condition, kind, code, message):
    if not condition:
        raise Refusal(kind, code, message)


def true(condition, code, message):
    require(condition, "rejected", code, message)


def formed(condition, code, message):
    require(condition, "malformed", code, message)


# The two encodings. Both give a tree of integers, texts and arrays. An object of JSON is a dictionary; in CBOR it is an array.


class Record(list):
    """An array of CBOR, which may stand for an object. No array of JSON does."""


def read_cbor(content):
    """The items of RFC 8949 that a certificate has. Only the deterministic encoding is accepted."""
    at = 0

    def take(count):
        nonlocal at
        formed(at + count <= len(content), "cbor", "the bytes end inside of an item")
        at += count
        return content[at - count:at]

    def head():
        first = take(1)[0]
        major, short = first >> 5, first & 31
        formed(major < 7 and short < 28, "cbor", "a float, a simple value, or an indefinite or reserved length")
        if short < 24:
            return major, short
        argument = int.from_bytes(take(1 << (short - 24)), "big")
        formed(argument >= (24 if short == 24 else 1 << (4 << (short - 24))), "canonical", "a head is too long")
        return major, argument

    def item(depth):
        formed(depth < DEPTH, "cbor", "arrays are nested too deeply")
        major, argument = head()
        if major < 2:
            return argument if major == 0 else -1 - argument
        if major == 3:
            text = take(argument)
            formed(all(32 <= byte < 127 for byte in text), "cbor", "a text is not printable ASCII")
            return text.decode("ascii")
        if major == 4:
            return Record(item(depth + 1) for _ in range(argument))
        formed(major == 6 and argument in (2, 3), "cbor", f"an item of the major type {major}")
        kind, length = head()
        formed(kind == 2, "cbor", "a big integer without a byte string")
        size = take(length)
        formed(length > 8 and size[0] > 0, "canonical", "a big integer could be shorter")
        size = int.from_bytes(size, "big")
        return size if argument == 2 else -1 - size

    tree = item(0)
    formed(at == len(content), "cbor", "a byte follows the certificate")
    return tree


def cbor(tree):
    """The deterministic encoding, in which an object is the list of its values."""
    def head(major, argument):
        if argument < 24:
            return bytes([32 * major + argument])
        order = next(k for k in range(4) if argument < 1 << (8 << k))
        return bytes([32 * major + 24 + order]) + argument.to_bytes(1 << order, "big")

    if isinstance(tree, int):
        size = tree if tree >= 0 else -1 - tree
        if size < 1 << 64:
            return head(0 if tree >= 0 else 1, size)
        digits = size.to_bytes((size.bit_length() + 7) // 8, "big")
        return (b"\xc2" if tree >= 0 else b"\xc3") + head(2, len(digits)) + digits
    if isinstance(tree, str):
        return head(3, len(tree)) + tree.encode("ascii")
    items = list(tree.values()) if isinstance(tree, dict) else tree
    return head(4, len(items)) + b"".join(map(cbor, items))


def read_json(content):
    """The tree of a JSON file: its canonical text is printed again and compared."""
    def unrepeated(pairs):
        formed(len({name for name, _ in pairs}) == len(pairs), "canonical", "a member is there twice")
        return dict(pairs)

    def odd(text):
        is_whole = re.fullmatch(r"-?[0-9]+(\.0+)?(e[+]?[0-9]+)?", text, re.ASCII | re.IGNORECASE)
        raise Refusal("malformed", "canonical" if is_whole else "json", f"{text[:20]} is not written as an integer")

    try:
        text = content.decode("utf-8")
        tree = json.loads(text, object_pairs_hook=unrepeated, parse_int=whole, parse_float=odd, parse_constant=odd)
    except (ValueError, RecursionError) as error:
        raise Refusal("malformed", "json", type(error).__name__) from error
    check_header(tree)
    formed("".join(printed(tree, 0)) + "\n" == text, "canonical", "not in canonical form")
    return integral(tree)


def check_header(tree):
    """Another version may have another shape."""
    formed(isinstance(tree, dict) and isinstance(tree.get("format"), str), "json", "no format")
    formed(tree["format"] == "acutile-certificate", "format", "no certificate")
    version = integral(tree.get("version"))
    formed(is_integer(version), "json", "no version")
    require(version == 2, "declined", "version", "a version that is unknown here")


def printed(tree, depth):
    """The one JSON text of a tree, in pieces."""
    if isinstance(tree, str):
        formed(re.fullmatch("[ -~]*", tree), "json", "a text is not printable ASCII")
        yield json.dumps(tree)
    elif is_integer(tree):
        formed(abs(tree) < 2 ** 53, "canonical", "an integer of more than 53 bits is written as a number")
        yield str(tree)
    else:
        formed(isinstance(tree, (list, dict)) and depth < DEPTH, "json", "a value that the grammar has not")
        line = "\n" if depth < 3 and tree else ""
        opening, closing = "[]" if isinstance(tree, list) else "{}"
        yield opening
        for n, item in enumerate(tree):
            yield ("," if n else "") + line
            if isinstance(tree, dict):
                yield from printed(item, depth)
                yield ":"
                item = tree[item]
            yield from printed(item, depth + 1)
        yield line + closing


def integral(tree):
    """The tree with integers for texts of decimal digits."""
    if isinstance(tree, list):
        return [integral(item) for item in tree]
    if isinstance(tree, dict):
        return {name: integral(item) for name, item in tree.items()}
    if isinstance(tree, str) and re.fullmatch("-?[1-9][0-9]*", tree, re.ASCII):
        formed(abs(whole(tree)) >= 2 ** 53, "canonical", "a small integer is written as a text")
        return whole(tree)
    return tree


def whole(text):
    """The integer; one that is beyond the limit, too, where the text is so long that the integer is."""
    return int(text) if len(text) < 1300 else 1 << (BITS + 1)


# The items of the grammar.


def is_integer(value):
    return type(value) is int


def record(data, *names):
    """The values of an object with these members; in CBOR it is an array of as many."""
    if isinstance(data, dict):
        formed(set(data) == set(names), "json", f"expected the members {', '.join(names)}")
        formed(list(data) == list(names), "canonical", "the members are in another order")
        return list(data.values())
    formed(isinstance(data, Record) and len(data) == len(names), "json", f"expected the members {', '.join(names)}")
    return data


def array(data, length=None):
    formed(isinstance(data, list) and length in (None, len(data)), "json", f"expected an array of {length or 'items'}")
    return data


def integer(data):
    formed(is_integer(data), "json", "expected an integer")
    require(abs(data).bit_length() <= BITS, "declined", "too-many-digits", f"more than {BITS} bits")
    return data


def integers(data, length=None):
    return [integer(x) for x in array(data, length)]


def positive(data, code="denominator"):
    formed(integer(data) > 0, code, f"the denominator {data} is not positive")
    return data


def check_primitive(values):
    formed(gcd_of(values) == 1, "canonical", "all integers have a common divisor")


def gcd_of(values):
    common = 0
    for value in values:
        common = gcd(common, value)
    return common


# Numbers: over Q integers; over Q(a) elements of Z[a].


class Field:
    """Q(a), for the one root a of a monic integer polynomial in an interval (hypothesis K)."""

    def __init__(self, data):
        polynomial, root = record(data, "polynomial", "root")
        self.degree = len(array(polynomial)) - 1
        formed(self.degree >= 2, "polynomial", "the degree is less than two")
        require(self.degree <= DEGREE, "declined", "degree", f"a field of degree {self.degree}")
        self.polynomial = integers(polynomial)
        formed(self.polynomial[-1] == 1, "polynomial", "not monic")
        low, high, denominator = map(integer, record(root, "low", "high", "denominator"))
        formed(low < high and denominator > 0, "root-order", "the root's interval does not rise")
        check_primitive([low, high, denominator])
        self.low, self.high = Fraction(low, denominator), Fraction(high, denominator)
        self.rises = self.value(self.high) > 0
        true(self.value(self.low) * self.value(self.high) < 0, "root-signs", "no opposite signs at the ends")
        low, high = Fraction(0), Fraction(0)
        for power in range(self.degree, 0, -1):
            ends = [x * y for x in (low, high) for y in (self.low, self.high)]
            low, high = (end(ends) + power * self.polynomial[power] for end in (min, max))
        formed(low > 0 or high < 0, "root-derivative", "the derivative's enclosure contains zero")
        self.found = []

    def value(self, x):
        total = Fraction(0)
        for coefficient in reversed(self.polynomial):
            total = total * x + coefficient
        return total

    def enclosures(self):
        """Finer and finer: for each power of a an interval of integers, over one denominator for all."""
        for level, halvings in enumerate((64, 64, 128, 256, 512, 1024)):
            if level == len(self.found):
                for _ in range(halvings):
                    self.halve()
                self.found.append(self.powers())
            yield self.found[level]

    def halve(self):
        middle = (self.low + self.high) / 2
        at_middle = self.value(middle) if self.rises else -self.value(middle)
        self.low, self.high = (self.low if at_middle > 0 else middle), (self.high if at_middle < 0 else middle)

    def powers(self):
        intervals = [(Fraction(1), Fraction(1))]
        for _ in range(self.degree - 1):
            ends = [x * y for x in intervals[-1] for y in (self.low, self.high)]
            intervals.append((min(ends), max(ends)))
        common = 1
        for end in (end for interval in intervals for end in interval):
            common *= (end * common).denominator
        return common, [(int(x * common), int(y * common)) for x, y in intervals]


class Element:
    """c_0 + c_1 a + … with integers c_i."""

    def __init__(self, field, coefficients):
        self.field, self.coefficients = field, coefficients

    def lifted(self, other):
        if isinstance(other, Element):
            return other.coefficients
        return [other] + [0] * (self.field.degree - 1)

    def __add__(self, other):
        return Element(self.field, [x + y for x, y in zip(self.coefficients, self.lifted(other))])

    def __sub__(self, other):
        return Element(self.field, [x - y for x, y in zip(self.coefficients, self.lifted(other))])

    def __neg__(self):
        return Element(self.field, [-x for x in self.coefficients])

    def __mul__(self, other):
        if isinstance(other, int):
            return Element(self.field, [x * other for x in self.coefficients])
        if isinstance(other, Polynomial):
            return other * self
        n = self.field.degree
        result = [0] * (2 * n - 1)
        for i, x in enumerate(self.coefficients):
            for j, y in enumerate(other.coefficients):
                result[i + j] += x * y
        for top in range(2 * n - 2, n - 1, -1):
            for k in range(n):
                result[top - n + k] -= result[top] * self.field.polynomial[k]
        return Element(self.field, result[:n])

    __radd__ = __add__
    __rmul__ = __mul__

    def __rsub__(self, other):
        return -self + other

    def between(self, enclosure):
        """Integers over a common denominator: the value is from the first to the second."""
        common, powers = enclosure
        low = sum(c * (lower if c > 0 else upper) for c, (lower, upper) in zip(self.coefficients, powers))
        high = sum(c * (upper if c > 0 else lower) for c, (lower, upper) in zip(self.coefficients, powers))
        return low, high, common


def sign(x):
    """-1, 0 or 1. Zero only where all coefficients are; otherwise an enclosure decides, or nothing does."""
    if isinstance(x, int):
        return (x > 0) - (x < 0)
    if not any(x.coefficients):
        return 0
    for enclosure in x.field.enclosures():
        low, high, _ = x.between(enclosure)
        if low > 0 or high < 0:
            return 1 if low > 0 else -1
    raise Refusal("declined", "sign-undecided", "a value is too near to zero")


def bounds(x, scale):
    """Fractions below and above x / scale."""
    if isinstance(x, int):
        return Fraction(x, scale), Fraction(x, scale)
    low, high, common = x.between(next(x.field.enclosures()))
    return Fraction(low, common * scale), Fraction(high, common * scale)


# Families: a value is a polynomial in parameters, which range over a box. A condition is proved where the signs of
# Bernstein coefficients show it. A set of leaves is an integer, by its bits; a tiling is one leaf with plain numbers.


class Polynomial:
    """Coefficients, none of them zero, by exponents."""

    def __init__(self, box, terms):
        self.box, self.terms = box, {powers: c for powers, c in terms.items() if not has_zeros(c)}

    def lifted(self, other):
        return other.terms if isinstance(other, Polynomial) else {(0,) * len(self.box.sides): other}

    def __add__(self, other):
        terms = dict(self.terms)
        for powers, c in self.lifted(other).items():
            terms[powers] = terms.get(powers, 0) + c
        return Polynomial(self.box, terms)

    def __mul__(self, other):
        terms = {}
        for (p, c), (q, d) in product(self.terms.items(), self.lifted(other).items()):
            powers = tuple(map(int.__add__, p, q))
            terms[powers] = terms.get(powers, 0) + c * d
        return Polynomial(self.box, terms)

    def __neg__(self):
        return self * -1

    def __sub__(self, other):
        return self + other * -1

    def __rsub__(self, other):
        return -self + other

    __radd__ = __add__
    __rmul__ = __mul__


def has_zeros(number):
    return not any(number.coefficients if isinstance(number, Element) else [number])


class Bernstein:
    """The tensor of Bernstein coefficients, times a positive number, on a box; flat, the last axis varies fastest."""

    def __init__(self, shape, entries):
        self.shape, self.entries = shape, entries

    @classmethod
    def of(cls, polynomial):
        sides = polynomial.box.sides
        shape = [1 + max((powers[k] for powers in polynomial.terms), default=0) for k in range(len(sides))]
        require(prod(shape) <= COEFFICIENTS, "declined", "work", "a polynomial has too many Bernstein coefficients")
        entries = [polynomial.terms.get(powers, 0) for powers in product(*map(range, shape))]
        table = cls(shape, entries)
        for k, side in enumerate(sides):
            table = table.changed(k, lambda line, side=side: bernstein(side.substituted(line)))
        return table

    def changed(self, axis, change):
        step, size = prod(self.shape[axis + 1:]), self.shape[axis]
        entries = list(self.entries)
        for start in range(len(entries)):
            if start // step % size == 0:
                line = slice(start, start + step * size, step)
                entries[line] = change(entries[line])
        return Bernstein(self.shape, entries)

    def halves(self, axis):
        """Those of both halves of the box."""
        if self.shape[axis] == 1:
            return self, self
        return [self.changed(axis, lambda line, half=half: de_casteljau(line)[half]) for half in (0, 1)]

    def is_positive(self, closed):
        """
        All are at least zero; and on every face of the box that its closed ends leave, some is positive. `closed` says
        of each axis which of its two ends belong to the box. No smaller face is in the box, so each point of the box
        is inside of a face with a positive coefficient, or of one that contains such a face.
        """
        signs = [sign(x) for x in self.entries]
        faces = [[range(n)] if n == 1 or not any(ends) else [[k] for k, end in zip((0, n - 1), ends) if end]
                 for n, ends in zip(self.shape, closed)]
        steps = [prod(self.shape[k + 1:]) for k in range(len(self.shape))]
        return min(signs) >= 0 and all(any(signs[dot(at, steps)] for at in product(*face)) for face in product(*faces))

    def is_nonnegative(self, closed):
        return all(sign(x) >= 0 for x in self.entries)


def bernstein(line):
    """From the coefficients of 1, t, …, t^n to those of the Bernstein basis on [0, 1], times n!."""
    n = len(line) - 1
    return [sum((line[i] * (comb(k, i) * factorial(i) * factorial(n - i)) for i in range(k + 1)), 0) for k in range(n + 1)]


def de_casteljau(line):
    """Both halves, times 2^n."""
    left, right, n = [], [], len(line) - 1
    for k in range(n + 1):
        left.append(line[0] * 2 ** (n - k))
        right.insert(0, line[-1] * 2 ** (n - k))
        line = [x + y for x, y in zip(line, line[1:])]
    return left, right


class Interval:
    """An interval of a parameter from low / scale to (low + width) / scale, and which of its ends belong to it."""

    def __init__(self, low, width, scale, closed):
        self.low, self.width, self.scale, self.closed = low, width, scale, closed

    def __str__(self):
        low, high = (shown_number(end, self.scale) for end in (self.low, self.low + self.width))
        return f"{'(['[self.closed[0]]}{low}, {high}{')]'[self.closed[1]]}"

    def halves(self):
        low, width, scale = self.low * 2, self.width, self.scale * 2
        return Interval(low, width, scale, (self.closed[0], True)), Interval(low + width, width, scale, (True, self.closed[1]))

    def points(self):
        """The closed ends, or the middle where there is none."""
        ends = [self.low, self.low + self.width]
        found = [Interval(end, 0, self.scale, (True, True)) for end, is_closed in zip(ends, self.closed) if is_closed]
        return found or [self.middle()]

    def middle(self):
        return Interval(self.low * 2 + self.width, 0, self.scale * 2, (True, True))

    def substituted(self, line):
        """For the coefficients of x^0, …, x^n those of t^0, …, t^n for x = (low + width t) / scale, times scale^n."""
        result, power = [], 1
        for c in reversed(line):
            result = [x * self.low + y * self.width for x, y in zip(result + [0], [0] + result)] if result else [0]
            result[0] = result[0] + c * power
            power *= self.scale
        return result


class Box:
    """The parameters' intervals, with a tree of halvings; or, for a test, one point of it."""

    def __init__(self, names, sides, tree):
        self.names, self.sides, self.tree = names, sides, tree
        self.all = (1 << len(list(self.leaves()))) - 1
        self.used = set()

    def leaves(self):
        """The sides of every leaf."""
        open_nodes = [(self.tree, self.sides)]
        while open_nodes:
            node, sides = open_nodes.pop()
            if not node:
                yield sides
                continue
            _, axis, *halves = node
            for half, side in reversed(list(zip(halves, sides[axis].halves()))):
                open_nodes.append((half, [*sides[:axis], side, *sides[axis + 1:]]))

    def where(self, polynomial, test):
        """The leaves in which a test of the Bernstein coefficients is passed."""
        found, count = 0, 0
        open_nodes = [(self.tree, Bernstein.of(polynomial), [side.closed for side in self.sides])]
        while open_nodes:
            node, table, closed = open_nodes.pop()
            if not node:
                found |= test(table, closed) << count
                count += 1
                continue
            signs = {sign(x) for x in table.entries}
            if signs == {1} or 1 not in signs:  # The halves have means of these, so they have the same sign, or are zero as all.
                is_passed = test(table, [(True, True)] * len(closed))
                found |= ((1 << leaves_of(node)) - 1) * is_passed << count
                count += leaves_of(node)
                continue
            _, axis, *halves = node
            ends = (closed[axis][0], True), (True, closed[axis][1])
            for half, part, end in reversed(list(zip(halves, table.halves(axis), ends))):
                open_nodes.append((half, part, [*closed[:axis], end, *closed[axis + 1:]]))
        return found

    def points(self, leaves):
        """Points of some leaves: the middle, and the corners of the box where they belong to it."""
        for n, sides in enumerate(self.leaves()):
            if leaves >> n & 1:
                yield Box(self.names, [side.middle() for side in sides], [])
                yield from (Box(self.names, list(corner), []) for corner in product(*(side.points() for side in sides)))

    def __str__(self):
        return ", ".join(f"{name} = {shown_number(side.low, side.scale)}" for name, side in zip(self.names, self.sides))

    def in_words(self):
        return ", ".join(f"{name} in {side}" for name, side in zip(self.names, self.sides))


def positive_in(x):
    """The leaves in which a value is shown to be positive."""
    return x.box.where(x, Bernstein.is_positive) if isinstance(x, Polynomial) else int(sign(x) > 0)


def nonnegative_in(x):
    return x.box.where(x, Bernstein.is_nonnegative) if isinstance(x, Polynomial) else int(sign(x) >= 0)


def zero_in(x):
    return nonnegative_in(x) & nonnegative_in(-x)


# Vectors and matrices.


def minus(x, y):
    return [a - b for a, b in zip(x, y)]


def dot(x, y):
    return sum((a * b for a, b in zip(x, y)), 0)


def det(rows):
    if not rows:
        return 1
    # Most of the time of a verification would be here without these two.
    if len(rows) == 2:
        (a, b), (c, d) = rows
        return a * d - b * c
    if len(rows) == 3:
        (a, b, c), (d, e, f), (g, h, i) = rows
        return a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)
    minors = ([row[:j] + row[j + 1:] for row in rows[1:]] for j in range(len(rows)))
    return sum((rows[0][j] * det(minor) * (-1) ** j for j, minor in enumerate(minors)), 0)


def cofactors(m):
    def minor(i, j):
        return [row[:j] + row[j + 1:] for k, row in enumerate(m) if k != i]
    return [[det(minor(i, j)) * (-1) ** (i + j) for j in range(len(m))] for i in range(len(m))]


def parity(items):
    """The sign of the permutation that sorts different items."""
    return (-1) ** sum(x > y for x, y in combinations(items, 2))


# The claim.

PLAIN = ["face-to-face tiling", "acute", "nonobtuse"]
BOUNDS = ["largest dihedral angle", "smallest dihedral angle", "squared radius-edge ratio"]
PLANE = "uncrossed plane"
NOT_DELAUNAY = "not Delaunay"
LATER = ["Delaunay", "weakly Delaunay", "locally Delaunay", "locally weakly Delaunay", NOT_DELAUNAY, "TCP"]
STATEMENTS = PLAIN + BOUNDS + [PLANE] + LATER
RELATIONS = ["less than", "at most", "maximum", "more than", "at least", "minimum"]
DELAUNAY = {"Delaunay": (positive_in, "not-delaunay"), "locally Delaunay": (positive_in, "not-delaunay"),
            "weakly Delaunay": (nonnegative_in, "not-weakly-delaunay"),
            "locally weakly Delaunay": (nonnegative_in, "not-weakly-delaunay")}


class Certificate:
    """
    The claim, with the checks that need nothing else; then the witness. Of a family either in all leaves of its tree, or
    in one point of its box.
    """

    def __init__(self, data, point=None):
        _, _, kind, claim, witness = record(data, "format", "version", "kind", "claim", "witness")
        formed(isinstance(kind, str), "json", "no kind")
        require(kind in ("tiling", "family"), "declined", "kind", "a kind that is unknown here")
        is_family = kind == "family"
        self.dimension, field, *parameters, gram, domain, statements = record(
            claim, "dimension", "field", *["parameters"] * is_family, "gram", "domain", "statements")
        denominator, vertices, boundary, *tree, simplices = record(
            witness, "denominator", "vertices", "boundary", *["tree"] * is_family, "simplices")
        formed(integer(self.dimension) in (2, 3), "dimension", "expected 2 or 3")
        self.field = None if field == "Q" else Field(field)
        self.box = self.read_box(*parameters, *tree) if is_family else None
        self.box = point or self.box
        self.read_gram(gram)
        self.read_domain(domain)
        self.read_statements(statements)
        self.read_witness(denominator, vertices, boundary, simplices)

    # Parameters.

    def read_box(self, parameters, tree):
        formed(0 < len(array(parameters)) <= PARAMETERS, "parameters", "none, or too many")
        names, sides = zip(*map(self.read_parameter, parameters))
        formed(len(set(names)) == len(names), "parameter-name", "two parameters have one name")
        formed("a" not in names or not self.field, "parameter-name", "a parameter is named a, like the root of the field")
        return Box(names, list(sides), self.read_tree(tree, len(names)))

    def read_parameter(self, data):
        name, *ends = record(data, "name", "low", "high")
        formed(isinstance(name, str), "json", "a name is no text")
        formed(re.fullmatch("[a-z][a-z0-9_]{0,15}", name, re.ASCII), "parameter-name", "a name is not like a_1")
        (is_low_closed, low, p), (is_high_closed, high, q) = map(self.read_end, ends)
        width = high * p - low * q
        formed(sign(width) != 0, "box-empty", f"the ends of {name} are equal")
        formed(sign(width) > 0, "box-exchanged", f"the low end of {name} is above the high end")
        return name, Interval(low * q, width, p * q, (is_low_closed, is_high_closed))

    def read_end(self, data):
        kind, fraction = array(data, 2)
        formed(kind in ("closed", "open"), "json", "an end is neither closed nor open")
        p, q = array(fraction, 2)
        p, q = self.number(p), positive(q)
        check_primitive([q, *coefficients([[p]])])
        return kind == "closed", p, q

    def read_tree(self, data, count):
        """Every node gets the number of its leaves."""
        def node(item, depth):
            if not array(item):
                return []
            require(depth < HALVINGS, "declined", "tree-size", f"more than {HALVINGS} halvings")
            axis, *halves = array(item, 3)
            formed(0 <= integer(axis) < count, "tree", "an axis is no parameter")
            halves = [node(half, depth + 1) for half in halves]
            return [sum(map(leaves_of, halves)), axis, *halves]
        root = node(data, 0)
        require(leaves_of(root) <= LEAVES, "declined", "tree-size", f"more than {LEAVES} leaves")
        return root

    def number(self, data):
        if self.field is None:
            return integer(data)
        return Element(self.field, integers(data, self.field.degree))

    def value(self, data):
        """A number; in a family a polynomial."""
        if self.box is None:
            return self.number(data)
        count, terms = len(self.box.sides), {}
        for term in array(data):
            c, *powers = array(term, 1 + count)
            powers = tuple(integers(powers))
            formed(all(0 <= e <= EXPONENT for e in powers), "exponent", "a polynomial of too high degree")
            self.box.used.update(k for k, e in enumerate(powers) if e)
            terms[powers] = self.number(c)
            formed(not has_zeros(terms[powers]), "terms", "a coefficient is zero")
        formed(list(terms) == sorted(terms) and len(terms) == len(data), "terms", "not in order")
        return Polynomial(self.box, terms)

    def values(self, data, length):
        return [self.value(x) for x in array(data, length)]

    def proved(self, leaves, code, message):
        """Refuses what is not proved in every leaf."""
        if not self.is_proved(leaves):
            raise Refusal("rejected", code, message, self.box and self.box.points(self.box.all & ~leaves))

    @property
    def all_leaves(self):
        return self.box.all if self.box else 1

    def is_proved(self, leaves):
        return leaves == self.all_leaves

    def sizes(self):
        return f"dimension {self.dimension}, domain {self.domain}, {len(self.vertices)} vertices, {len(self.simplices)} simplices"

    def read_gram(self, data):
        """The matrix by its upper triangle; positive definite (hypothesis M)."""
        d = self.dimension
        upper = [self.values(row, d - i) for i, row in enumerate(array(data, d))]
        check_primitive(coefficients(upper))
        self.gram = [[upper[min(i, j)][abs(i - j)] for j in range(d)] for i in range(d)]
        for n in range(1, d + 1):
            minor = det([row[:n] for row in self.gram[:n]])
            self.proved(positive_in(minor), "gram-not-positive", f"leading minor {n}")

    def read_domain(self, data):
        d = self.dimension
        self.domain, self.rank, self.polytope, self.faces = "space", d, [], []
        if data == "space":
            return
        self.domain, value = array(data, 2)
        formed(self.domain != "region" or not self.box, "family-domain", "a family of regions")
        if self.domain == "region":
            self.rank = integer(value)
            formed(0 <= self.rank <= d, "region-rank", f"the rank {self.rank}")
            return
        formed(self.domain in ("slab", "prism", "solid"), "json", "an unknown domain")
        formed(self.domain != "prism" or d == 3, "prism-dimension", "a prism in the plane")
        self.rank = d - {"slab": 1, "prism": 2, "solid": d}[self.domain]
        denominator, vertices, faces = record(value, "denominator", "vertices", "faces")
        self.polytope_scale = positive(denominator)
        self.polytope = [self.values(row, self.codimension) for row in array(vertices)]
        check_primitive([self.polytope_scale, *coefficients(self.polytope)])
        self.faces = [integers(face) for face in array(faces)]
        self.sides = check_polytope(self)

    @property
    def codimension(self):
        return self.dimension - self.rank

    def read_statements(self, data):
        self.statements = [self.read_statement(x) for x in array(data)]
        order = [(STATEMENTS.index(name), RELATIONS.index(relation) if relation else 0, *(value if name == PLANE else ()))
                 for name, relation, _, value in self.statements]
        is_ordered = order == sorted(set(order)) and order[:1] == [(0, 0)]
        formed(is_ordered, "statements", "not in order, or the tiling is not the first")
        names = {name for name, _, _, _ in self.statements}
        wrong = {"Delaunay", "weakly Delaunay"} if self.domain == "region" else {name for name in LATER if "locally" in name}
        if self.domain != "space" or self.dimension != 3:
            wrong.add("TCP")
        if self.is_not_single:
            wrong.add(PLANE)
        if self.is_of_patches:
            wrong.add(NOT_DELAUNAY)
        formed(not names & wrong, "statement-domain", "a statement is not for this domain")

    is_of_patches = False

    @property
    def is_not_single(self):
        """Planes are stated of single tilings, not of families and systems of patches."""
        return self.box is not None

    def read_plane(self, data):
        """[normal, [offset, denominator]]: no simplex crosses normal · x = offset / denominator or a translate of it."""
        _, normal, value = array(data, 3)
        normal, (p, q) = tuple(integers(normal, self.dimension)), integers(value, 2)
        check_primitive(normal)
        formed(next((c for c in normal if c), 0) > 0, "canonical", "the first entry of a normal is negative")
        formed(all(abs(c) < 2 ** 29 for c in normal) and q > 0, "bound-range", "a plane")
        check_primitive([p, q])
        return PLANE, None, None, (normal, p, q)

    def read_statement(self, data):
        """Name, relation, sign and fraction; the last three are None for statements that are texts."""
        if isinstance(data, str):
            formed(data in PLAIN + LATER, "statements", f"the unknown statement {data[:40]!r}")
            return data, None, None, None
        name = (array(data) or [None])[0]
        if name == PLANE:
            return self.read_plane(data)
        formed(name in BOUNDS, "statements", "an unknown statement")
        _, relation, *rest = array(data, 3 if name == BOUNDS[2] else 4)
        formed(isinstance(relation, str), "json", "a relation is no text")
        formed(relation in RELATIONS, "statements", "an unknown relation")
        side = integer(rest[0]) if name != BOUNDS[2] else 1
        p, q = array(rest[-1], 2)
        p, q = self.number(p), positive(q, "bound-range")
        check_primitive([q, *coefficients([[p]])])
        is_bound = side in (-1, 0, 1) and sign(p) == abs(side) and (name == BOUNDS[2] or sign(p - q) <= 0)
        formed(is_bound, "bound-range", f"a bound of {name}")
        return name, relation, side, (p, q)

    # The witness.

    def read_witness(self, denominator, vertices, boundary, simplices):
        d = self.dimension
        self.scale = positive(denominator)
        if self.polytope:
            true(self.scale % self.polytope_scale == 0, "denominator-domain", "the polytope's does not divide it")
            factor = self.scale // self.polytope_scale
            self.polytope = [[x * factor for x in vertex] for vertex in self.polytope]
        self.vertices = [self.values(row, d) for row in array(vertices)]
        check_primitive([self.scale, *coefficients(self.vertices)])
        formed(not self.box or len(self.box.used) == len(self.box.sides), "unused-parameter", "a parameter does not occur")
        self.on_faces = [check_inside(self, v) for v in range(len(self.vertices))]
        formed(bool(array(boundary)) == (self.domain == "region"), "boundary-domain", "of a region, and of no other domain")
        self.boundary = [self.read_facet(facet) for facet in array(boundary)]
        names = {facet_name(facet)[0] for facet in self.boundary}
        formed(len(names) == len(self.boundary), "boundary-repeated", "a boundary facet is listed twice")
        formed(array(simplices), "no-simplices", "there is no simplex")
        has_sixes = self.claims("TCP")
        rows = [array(row, d + 1 + has_sixes) for row in array(simplices)]
        self.sixes = [integer(row[-1]) if has_sixes else 0 for row in rows]
        self.simplices = [self.read_row(row[:d + 1]) for row in rows]
        formed(all(0 <= n < 64 for n in self.sixes), "sixes", "not from 0 to 63")

    def claims(self, statement):
        return any(name == statement for name, _, _, _ in self.statements)

    def corner(self, data):
        v, *shift = integers(data, 1 + self.rank) if isinstance(data, list) else [integer(data)]
        formed(0 <= v < len(self.vertices), "vertex-range", f"vertex {v}")
        formed(all(abs(s) < FAR for s in shift), "shift-range", f"the shift {shift}")
        formed(any(shift) or not isinstance(data, list), "canonical", "a shift of zero is written")
        return (v, *(shift or [0] * self.rank))

    def read_facet(self, data):
        corners = [self.corner(x) for x in array(data, self.dimension)]
        least, *_ = sorted(corners)
        is_ordered = not any(corners[0][1:]) and len(set(corners)) == len(corners)
        is_ordered = is_ordered and (self.dimension == 2 or corners[0] == least)
        formed(is_ordered, "corner-order", f"boundary facet {data}")
        return corners

    def read_row(self, data):
        """Sorted corners, but the last two stand in the order of a positive determinant."""
        corners = [self.corner(x) for x in data]
        is_ordered = not any(corners[0][1:]) and len(set(corners)) == len(corners)
        is_ordered = is_ordered and corners[:-2] == sorted(corners)[:-2]
        formed(is_ordered, "corner-order", f"simplex {data}")
        return corners

    def position(self, corner):
        """The coordinates of a corner, scaled."""
        shift = [s * self.scale for s in corner[1:]] + [0] * self.codimension
        return [x + s for x, s in zip(self.vertices[corner[0]], shift)]

    def product(self, x, y):
        return dot(x, [dot(row, y) for row in self.gram])

    def height(self, face, point):
        """h_f of a point, given by its last k coordinates."""
        w = [self.polytope[n] for n in face]
        return det([minus(x, w[0]) for x in w[1:self.codimension]] + [minus(point, w[0])])


def leaves_of(node):
    return node[0] if node else 1


def coefficients(rows):
    """All integers in rows of values."""
    numbers = (c for row in rows for x in row for c in (x.terms.values() if isinstance(x, Polynomial) else [x]))
    return (c for x in numbers for c in (x.coefficients if isinstance(x, Element) else [x]))


def moved(corner, shift, factor=1):
    return (corner[0],) + tuple(x + factor * u for x, u in zip(corner[1:], shift))


def facet_name(corners):
    """The same for translates, in any order; and the shift of the first corner."""
    first, *_ = ordered = sorted(corners)
    return tuple(moved(corner, first[1:], -1) for corner in ordered), first[1:]


# Domains with a polytope: hypotheses P1, P2, P3, I.


def check_polytope(c):
    """Returns the sign s_f of each face."""
    k, count = c.codimension, len(c.polytope)
    formed(len(c.faces) > k, "face-count", "too few faces")
    for face in c.faces:
        formed(len(face) == k or len(face) > k == 3, "face-length", f"{len(face)} vertices")
    for face in c.faces:
        is_face = all(0 <= n < count for n in face) and len(set(face)) == len(face)
        formed(is_face, "face-vertices", f"face {face}")
    formed(len({frozenset(face) for face in c.faces}) == len(c.faces), "face-repeated", "a face is there twice")
    formed(len({n for face in c.faces for n in face}) == count, "unused-domain-vertex", "a vertex is in no face")
    signs = [face_sign(c, face) for face in c.faces]
    if k == 3:
        for face in c.faces:
            check_polygon(c, face)
    ridges = {
        1: lambda face: [()], 2: lambda face: face,
        3: lambda face: [frozenset(pair) for pair in zip(face, face[1:] + face[:1])],
    }[k]
    found = Counter(ridge for face in c.faces for ridge in ridges(face))
    true(set(found.values()) == {2}, "faces-not-closed", "a ridge is not in two faces")
    return signs


def face_sign(c, face):
    """It is the same in all leaves: h_f is continuous, and not zero at the other vertices."""
    heights = [c.height(face, w) for w in c.polytope]
    for n in face:
        c.proved(zero_in(heights[n]), "face-not-facet", f"face {face}")
    others = [heights[n] for n in range(len(heights)) if n not in face]
    true(others, "face-not-facet", f"face {face} has all vertices")
    return common_sign(c, others, "face-not-facet", f"face {face}")


def common_sign(c, values, code, message):
    """The one strict sign of all these."""
    side = 1 if c.is_proved(positive_in(values[0])) else -1
    for x in values:
        c.proved(positive_in(x * side), code, message)
    return side


def check_polygon(c, face):
    outside = next(w for n, w in enumerate(c.polytope) if n not in face)
    turns = [det([minus(x, c.polytope[p]) for x in (c.polytope[q], c.polytope[t], outside)])
             for p, q in zip(face, face[1:] + face[:1]) for t in face if t not in (p, q)]
    common_sign(c, turns, "face-not-convex", f"face {face}")


def check_inside(c, v):
    """The faces that have a vertex of the tiling, everywhere; it is on the inner side of the others, or in their plane."""
    heights = [c.height(face, c.vertices[v][c.rank:]) * s for face, s in zip(c.faces, c.sides)] if c.faces else []
    for h in heights:
        c.proved(nonnegative_in(h), "vertex-outside", f"vertex {v}")
    return {f for f, h in enumerate(heights) if c.is_proved(zero_in(h))}


# The tiling: hypotheses O, F, B, V and, of regions, X and W.


def check_orientation(c, determinants):
    for s, determinant in enumerate(determinants):
        c.proved(positive_in(determinant), "orientation", f"simplex {s}")


class Facet:
    """A facet of a simplex: its side, what is opposite to it, and by what it is moved from the facet of its name."""

    def __init__(self, row, s, apex):
        corners = [corner for corner in row if corner != apex]
        self.simplex, self.apex, self.corners = s, apex, corners
        self.name, self.base = facet_name(corners)
        self.side = (-1) ** row.index(apex) * parity(corners)


def matched(c):
    """
    Pairs of a facet and its mate. Facets of one name are paired in the order of the rows; in a region the first one
    closes a listed facet of its name. What is in a face of the polytope has no mate.
    """
    listed = {facet_name(facet)[0]: parity(facet) for facet in c.boundary}
    groups = {}
    for s, row in enumerate(c.simplices):
        for apex in sorted(row):
            facet = Facet(row, s, apex)
            if not set.intersection(*(c.on_faces[corner[0]] for corner in facet.corners)):
                groups.setdefault(facet.name, []).append(facet)
    mates = []
    for key, group in groups.items():
        if key in listed:
            true(group.pop(0).side == listed[key], "facet-side", "a boundary facet turns its outer side to its simplex")
        for one, other in zip(group[::2], group[1::2]):
            true(one.side != other.side, "facet-side", f"simplices {one.simplex} and {other.simplex}")
            mates.append((one, other))
    return mates, groups, listed


def check_end(c, groups, listed, determinants):
    for group in groups.values():
        true(len(group) % 2 == 0, "open-facet", f"a facet of simplex {group[-1].simplex} has no mate" if group else "")
    true(set(listed) <= set(groups), "boundary-open", "a boundary facet is a facet of no simplex")
    used = {corner[0] for row in c.simplices for corner in row}
    formed(len(used) == len(c.vertices), "unused-vertex", "a vertex is no corner")
    if c.domain != "region":
        check_volume(c, determinants)


def check_volume(c, determinants):
    """The sum of the determinants is D! vol P, with Lemma 0's k! vol P."""
    k = c.codimension
    volume = 0 if k else 1
    for face, side in zip(c.faces, c.sides if c.faces else []):
        w = [minus(c.polytope[n], c.polytope[face[0]]) for n in face]
        apex = minus(c.polytope[0], c.polytope[face[0]])
        pieces = sum((det(w[i:i + k - 1] + [apex]) for i in range(1, len(face) - k + 2)), 0)
        volume = volume + pieces * side
    expected = volume * (factorial(c.dimension) // factorial(k) * c.scale ** c.rank)
    c.proved(zero_in(sum(determinants, 0) - expected), "volume-sum", "the volumes do not sum to the domain's")


def check_apart(c):
    """X: any two boundary facets, also translates, meet in the hull of their common corners."""
    boxes = [box(c, facet) for facet in c.boundary]
    for f, g in product(range(len(boxes)), repeat=2):
        if f > g:
            continue
        for shift in shifts(c, boxes[f], boxes[g]):
            if f < g or shift > (0,) * c.rank:
                there = [moved(corner, shift) for corner in c.boundary[g]]
                true(meet_in_shared(c, c.boundary[f], there), "boundary-meets", f"boundary facets {f} and {g}, moved by {shift}")


def box(c, corners):
    """For each coordinate fractions below and above those of the corners."""
    points = [[bounds(x, c.scale) for x in c.position(corner)] for corner in corners]
    return [(min(low for low, _ in column), max(high for _, high in column)) for column in zip(*points)]


def shifts(c, one, other):
    """All lattice vectors that could move the second box to one that meets the first."""
    ranges = []
    for k, ((low, high), (least, most)) in enumerate(zip(one, other)):
        if k < c.rank:
            first, last = ceil(low - most), floor(high - least)
            require(last - first < TRANSLATES, "declined", "work", "a simplex extends over too many cells")
            ranges.append(range(first, last + 1))
        elif low > most or high < least:
            return []
    return product(*ranges)


def meet_in_shared(c, f, g):
    """
    Two hulls of corners meet in that of the common ones exactly if some affine function is zero at these, positive at
    the others of the first, negative at the others of the second.
    """
    shared = [corner for corner in f if corner in g]
    rows = [[1] + c.position(corner) for corner in f if corner not in shared]
    rows += [[-x for x in [1] + c.position(corner)] for corner in g if corner not in shared]
    return is_feasible(rows, [[1] + c.position(corner) for corner in shared])


def is_feasible(positive_rows, zero_rows):
    """Whether some w has row · w > 0 for all rows of the first list and = 0 for the second (Fourier and Motzkin)."""
    if not positive_rows:
        return True
    if not positive_rows[0]:
        return False
    pivot = next((row for row in zero_rows if sign(row[0]) != 0), None)
    if pivot is not None:
        others = [row for row in zero_rows if row is not pivot]
        return is_feasible([eliminated(row, pivot) for row in positive_rows], [eliminated(row, pivot) for row in others])
    signs = [sign(row[0]) for row in positive_rows]
    kept = [row[1:] for row, s in zip(positive_rows, signs) if s == 0]
    up, down = ([row for row, s in zip(positive_rows, signs) if s == side] for side in (1, -1))
    if not up or not down:
        return is_feasible(kept, [row[1:] for row in zero_rows])
    kept += [[x * -q[0] + y * p[0] for x, y in zip(p[1:], q[1:])] for p in up for q in down]
    return is_feasible(kept, [row[1:] for row in zero_rows])


def eliminated(row, pivot):
    """A positive multiple of the row, plus a multiple of the pivot, without its first entry, which is zero."""
    s = sign(pivot[0])
    return [x * (pivot[0] * s) - y * (row[0] * s) for x, y in zip(row[1:], pivot[1:])]


def check_covering(c):
    """
    W: no tile has the point x = m + ε o + ε² e_1 + ε³ e_2 + … for small ε > 0, where m is the centroid of a boundary
    facet and o is a vector to the outside. x is in no plane of a facet, and directly outside.
    """
    d = c.dimension
    boxes = [box(c, row) for row in c.simplices]
    for facet in c.boundary:
        points = [c.position(corner) for corner in facet]
        centre = [sum(column, 0) for column in zip(*points)]
        outward = outward_normal([minus(x, points[0]) for x in points[1:]])
        middle = [tuple(end / d for end in bounds(x, c.scale)) for x in centre]
        for s, row in enumerate(c.simplices):
            for shift in shifts(c, middle, boxes[s]):
                tile = [c.position(moved(corner, shift)) for corner in row]
                is_covered = all(first_sign(values) > 0 for values in coordinates(tile, centre, outward))
                true(not is_covered, "covering", f"simplex {s}, moved by {shift}, is outside of boundary facet {facet}")


def outward_normal(rows):
    """In coordinates: det(outward, rows…) > 0."""
    minors = [[row[:j] + row[j + 1:] for row in rows] for j in range(len(rows) + 1)]
    return [det(minor) * (-1) ** j for j, minor in enumerate(minors)]


def coordinates(tile, centre, outward):
    """For each corner the positive multiple of its barycentric coordinate at x, by powers of ε."""
    d = len(outward)
    unit = [[int(i == j) for j in range(d)] for i in range(d)]
    for i in range(d + 1):
        def value(point, weight):
            """The determinant of the homogeneous coordinates, where the point replaces corner i."""
            return det([[1] + x if j != i else [weight] + point for j, x in enumerate(tile)])
        yield [value(centre, d), value(outward, 0)] + [value(e, 0) for e in unit]


def first_sign(values):
    return next((s for s in map(sign, values) if s), 0)


# The statements.


class Shape:
    """The Gram matrix of a simplex's edges from corner 0, its cofactors and determinant."""

    def __init__(self, c, corners):
        self.origin, *others = [c.position(corner) for corner in corners]
        self.edges = [minus(x, self.origin) for x in others]
        self.m = [[c.product(x, y) for y in self.edges] for x in self.edges]
        self.cofactors = cofactors(self.m)
        self.det = det(self.m)
        self.delta = [row[i] for i, row in enumerate(self.m)]

    def gradients(self):
        """det M times the inner products of the gradients g_0, …, g_D."""
        first = [-sum(column, 0) for column in zip(*self.cofactors)]
        return [[-sum(first, 0)] + first] + [[x] + row for x, row in zip(first, self.cofactors)]

    def squared_edges(self):
        between = [x + y - 2 * self.m[i][j] for (i, x), (j, y) in combinations(enumerate(self.delta), 2)]
        return self.delta + between

    def power(self, c, point):
        """The power of a point in the circumsphere, times det(edges): |x|² less the affine function that agrees with it at the corners."""
        x = minus(point, self.origin)
        return det([edge + [square] for edge, square in zip([*self.edges, x], [*self.delta, c.product(x, x)])])


class Angle:
    """The angle of facets i and j beside that with the cosine side · √(p/q): the leaves in which it is less or more."""

    def __init__(self, g, i, j, side, bound):
        p, q = bound
        self.cosine, self.side = -g[i][j], side
        self.excess = self.cosine * self.cosine * q - g[i][i] * g[j][j] * p  # cos² less p/q, times a positive number

    def less(self, positive_in):
        """Less; or at most, by the other function. The cosine is larger, its sign or else its square shows it."""
        if self.side == 0:
            return positive_in(self.cosine)
        if self.side > 0:
            return nonnegative_in(self.cosine) & positive_in(self.excess)
        return nonnegative_in(self.cosine) | positive_in(-self.excess)

    def more(self, positive_in):
        if self.side == 0:
            return positive_in(-self.cosine)
        if self.side < 0:
            return nonnegative_in(-self.cosine) & positive_in(self.excess)
        return nonnegative_in(-self.cosine) | positive_in(-self.excess)


class Ratio:
    """R² / l² for one edge beside the bound p/q; 4 det M R² = δ · C δ. The shortest edge has the largest ratio."""

    def __init__(self, shape, edge, bound):
        p, q = bound
        radius = dot(shape.delta, [dot(row, shape.delta) for row in shape.cofactors])
        self.excess = radius * q - shape.det * edge * p * 4

    def less(self, positive_in):
        return positive_in(-self.excess)

    def more(self, positive_in):
        return positive_in(self.excess)


def check_bound(c, shapes, statement):
    """Returns the leaves in which a bound is attained, all of them for one that need not be."""
    name, relation, side, bound = statement
    code = "ratio-bound" if name == BOUNDS[2] else "angle-bound"
    test = positive_in if relation in ("less than", "more than") else nonnegative_in
    is_upper = relation in RELATIONS[:3]
    attained = 0 if relation in ("maximum", "minimum") else c.all_leaves
    for s, shape in enumerate(shapes):
        if name == BOUNDS[2]:
            quantities = [Ratio(shape, edge, bound) for edge in shape.squared_edges()]
        else:
            g = shape.gradients()
            quantities = [Angle(g, i, j, side, bound) for i, j in combinations(range(len(g)), 2)]
        # The largest one is less if all are, and more if one is.
        less, more = [(some, every), (every, some)][name != BOUNDS[1]]
        found = less(x.less(test) for x in quantities) if is_upper else more(x.more(test) for x in quantities)
        c.proved(found, code, f"simplex {s}: {name}")
        if not c.is_proved(attained):
            attained |= less(x.less(test) for x in quantities) & more(x.more(test) for x in quantities)
    return attained


def every(sets):
    return reduce(int.__and__, sets)


def some(sets):
    return reduce(int.__or__, sets)


def check_acute(c, shapes, test, code):
    for s, g in enumerate(shape.gradients() for shape in shapes):
        for i, j in combinations(range(len(g)), 2):
            c.proved(test(-g[i][j]), code, f"facets {i} and {j} of simplex {s}")


def check_delaunay(c, shapes, mates, test, code):
    for one, other, power in powers(c, shapes, mates):
        c.proved(test(power), code, f"simplices {one.simplex} and {other.simplex}")


def powers(c, shapes, mates):
    """For each facet with a mate the power of the mate's corner."""
    for one, other in mates:
        beyond = moved(moved(other.apex, other.base, -1), one.base)
        yield one, other, shapes[one.simplex].power(c, c.position(beyond))


def inside(c, shapes, mates):
    """The leaves in which one corner is inside of a circumsphere in all points."""
    return reduce(int.__or__, (positive_in(-power) for _, _, power in powers(c, shapes, mates)), 0)


def check_plane(c, normal, p, q):
    """In units of the step between translates by the lattice, the corners of a simplex are between successive integers."""
    step = gcd(*normal[:c.rank])

    def height(corner):
        return sum((x * n for x, n in zip(c.position(corner), normal)), 0) * q - p * c.scale

    for s, row in enumerate(c.simplices):
        heights = [height(corner) for corner in row]
        if step:
            unit = q * c.scale * step
            floors = [floor_of(x, unit) for x in heights]
            ceilings = [k + (sign(x - k * unit) != 0) for x, k in zip(heights, floors)]
            is_crossed = max(ceilings) - min(floors) > 1
        else:
            is_crossed = {-1, 1} <= {sign(x) for x in heights}
        true(not is_crossed, "plane-crossed", f"simplex {s} crosses a translate of the plane {normal} = {p}/{q}")


def floor_of(x, unit):
    """The largest integer k for which k unit is at most x."""
    low, high = -1, 1
    while sign(x - low * unit) < 0:
        low *= 2
    while sign(x - high * unit) >= 0:
        high *= 2
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (low, middle) if sign(x - middle * unit) < 0 else (middle, high)
    return low


def check_tcp(c):
    edges = [[facet_name(pair)[0] for pair in combinations(sorted(row), 2)] for row in c.simplices]
    valences = Counter(edge for row in edges for edge in row)
    for s, (row, sixes) in enumerate(zip(c.simplices, c.sixes)):
        six = [pair for p, pair in enumerate(combinations(range(4), 2)) if sixes >> p & 1]
        is_allowed = len(six) < 2 or (len(six) == 2 and not set(six[0]) & set(six[1]))
        true(is_allowed, "triangle-valence", f"simplex {s}")
        stated = [6 if pair in six else 5 for pair in combinations(range(4), 2)]
        true(stated == [valences[edge] for edge in edges[s]], "edge-valence", f"simplex {s}")


def check_tiling(data):
    """Also a family: a condition that is not proved in some leaves is refuted if it is false in one of some points."""
    try:
        return check_places(data)
    except Refusal as refusal:
        if not refusal.points:
            raise
        found = refusal
    others = [Refusal("declined", "sign-undecided", f"not decided in all leaves: {found.code}, {found}")]
    for point in islice(found.points, POINTS):
        try:
            check_places(data, point)
        except Refusal as refusal:
            there = Refusal(refusal.kind, refusal.code, f"for {point}: {refusal}")
            if refusal.code == found.code:
                raise there from found
            others.append(there)
    raise others[-1]


def check_places(data, point=None):
    """In all leaves, or in one point."""
    c = Certificate(data, point)
    if c.domain == "region":
        check_apart(c)
    mates, groups, listed = matched(c)
    shapes = [Shape(c, row) for row in c.simplices]
    determinants = [det(shape.edges) for shape in shapes]
    check_orientation(c, determinants)
    if c.domain == "region":
        check_covering(c)
    attained = []
    for statement in c.statements:
        name = statement[0]
        if name == "acute":
            check_acute(c, shapes, positive_in, "not-acute")
        elif name == "nonobtuse":
            check_acute(c, shapes, nonnegative_in, "not-nonobtuse")
        elif name in BOUNDS:
            attained.append(check_bound(c, shapes, statement))
        elif name == PLANE:
            check_plane(c, *statement[-1])
        elif name in DELAUNAY:
            check_delaunay(c, shapes, mates, *DELAUNAY[name])
        elif name == NOT_DELAUNAY:
            found = inside(c, shapes, mates)
    check_end(c, groups, listed, determinants)
    if c.claims("TCP"):
        check_tcp(c)
    for leaves in attained:
        c.proved(leaves, "not-attained", "no simplex attains a bound")
    if c.claims(NOT_DELAUNAY):
        c.proved(found, "none-inside", "no vertex is found inside of a circumsphere")
    return c


# Systems of patches.


class System(Certificate):
    """A certificate of the kind patches. What is a corner elsewhere is here a point of a tile, times unit."""

    is_not_single = is_of_patches = True

    def __init__(self, data):
        _, _, _, claim, witness = record(data, "format", "version", "kind", "claim", "witness")
        field, gram, self.rank, tiles, statements = record(claim, "field", "gram", "rank", "tiles", "statements")
        formed(integer(self.rank) in (1, 2), "rank", f"the rank {self.rank}")
        self.dimension, self.domain, self.box = 3, "space", None
        self.field = None if field == "Q" else Field(field)
        self.read_gram(gram)
        mixed = [self.gram[i][j] for i in range(self.rank) for j in range(self.rank, 3)]
        true(all(sign(x) == 0 for x in mixed), "gram-blocks", "the base is not orthogonal to the lattice")
        formed(array(tiles), "tile-count", "there is no tile")
        self.read_statements(statements)
        formed(len(array(witness)) == len(tiles), "tile-count", "expected a patch for each tile")
        self.patches = [Patch(self, (field, gram), tile, patch) for tile, patch in zip(tiles, witness)]
        self.scale = 1
        for patch in self.patches:
            self.scale *= patch.scale // gcd(self.scale, patch.scale)
        self.sides = [Side(self, patch, number) for patch in self.patches for number in range(len(patch.classes))]
        self.unit = 1
        self.walls = {}
        for side in self.sides:
            if side.label not in self.walls:
                self.walls[side.label] = side
                self.unit = self.unit * side.square
        for side in self.sides:
            side.check_wall(self.walls[side.label])

    def sizes(self):
        return f"{len(self.patches)} patches, {sum(len(patch.rows) for patch in self.patches)} simplices"

    def position(self, point):
        return point

    def point(self, patch, corner):
        """In the coordinates of the tile, times unit."""
        factor = self.unit * (self.scale // patch.scale)
        return [x * factor for x in patch.part.position(corner)]

    def meetings(self):
        """The pairs of sides that can meet, in both orders."""
        for left, right in product(self.sides, repeat=2):
            if left.label == right.label and (self.rank == 1 or left.number != right.number):
                yield left, right

    def others(self, wall):
        """unit, divided by the square of this side's length."""
        result = 1
        for other in self.walls.values():
            result = result if other is wall else result * other.square
        return result


class Patch:
    """A tile and its piece. With the fans of the pyramids it is a prism or a slab, which is checked here."""

    def __init__(self, system, metric, tile, data):
        denominator, vertices, classes = record(tile, "denominator", "vertices", "classes")
        self.rank, count = system.rank, len(array(vertices))
        self.classes = integers(classes, count)
        formed(count > 2 if self.rank == 1 else count == 2, "side-count", f"{count} vertices")
        faces = [[s, (s + 1) % count] if self.rank == 1 else [s] for s in range(count)]
        domain = ["prism" if self.rank == 1 else "slab", dict(denominator=denominator, vertices=vertices, faces=faces)]
        denominator, offsets, vertices, pyramids, simplices = record(
            data, "denominator", "offsets", "vertices", "pyramids", "simplices")
        formed(array(simplices), "no-simplices", "there is no simplex")
        pyramids = [self.read_pyramid(pyramid) for pyramid in array(pyramids)]
        fans = [fan for apex, polygon in pyramids for fan in fans_of(apex, polygon)]
        claim = dict(dimension=3, field=metric[0], gram=metric[1], domain=domain, statements=["face-to-face tiling"])
        witness = dict(denominator=denominator, vertices=vertices, boundary=[], simplices=simplices + fans)
        self.part = check_tiling(dict(format="", version=2, kind="tiling", claim=claim, witness=witness))
        self.scale, self.corners = self.part.scale, self.part.polytope
        self.offsets = [self.part.values(offset, self.rank) for offset in array(offsets, count)]
        self.rows = self.part.simplices[:len(simplices)]
        self.pyramids = [(apex, polygon, self.side_of(apex, polygon)) for apex, polygon in pyramids]
        first, second, third = (self.corners * 2)[:3]
        turn = det([minus(second, first), minus(third, first)]) if self.rank == 1 else second[0] - first[0]
        true(sign(turn) > 0, "tile-order", "the vertices are not counterclockwise, or not in increasing order")

    def read_pyramid(self, data):
        apex, polygon = array(data, 2)
        apex, *polygon = [self.read_corner(corner) for corner in [apex, *array(polygon)]]
        is_polygon = len(polygon) > 2 and len(set(polygon)) == len(polygon) and not any(polygon[0][1:])
        formed(is_polygon and apex not in polygon, "pyramid", "no polygon that begins with the shift zero, and an apex")
        return apex, polygon

    def read_corner(self, data):
        v, *shift = integers(data, 1 + self.rank) if isinstance(data, list) else [integer(data)]
        formed(any(shift) or not isinstance(data, list), "canonical", "a shift of zero is written")
        return (v, *(shift or [0] * self.rank))

    def side_of(self, apex, polygon):
        sides = self.faces(*polygon)
        true(not self.faces(apex) and len(sides) == 1, "pyramid-side", "an apex is in a side, or a polygon is in none")
        return sides.pop()

    def faces(self, *corners):
        """The sides that contain all these corners."""
        return set.intersection(*(self.part.on_faces[corner[0]] for corner in corners))


def fans_of(apex, polygon):
    """The rows of the tetrahedra from the first corner of the polygon, positive in this order."""
    for corners in ([polygon[0], one, other, apex] for one, other in zip(polygon[1:], polygon[2:])):
        a, b, c, d = facet_name(corners)[0]
        ordered = [a, b, c, d] if parity(corners) > 0 else [a, b, d, c]
        yield [list(corner) if any(corner[1:]) else corner[0] for corner in ordered]


class Side:
    """A side of a tile. Its wall coordinates are those of the lattice, and X along the side and Y inwards, or a height."""

    def __init__(self, system, patch, number):
        self.system, self.patch, self.number, self.label = system, patch, number, patch.classes[number]
        self.factor = system.scale // patch.scale
        self.offset = [x * self.factor for x in patch.offsets[number]]
        self.start, self.square = [x * self.factor for x in patch.corners[number]], 1
        if patch.rank == 1:
            end = [x * self.factor for x in patch.corners[(number + 1) % len(patch.corners)]]
            self.along = minus(end, self.start)
            first, second = [dot(row[1:], self.along) for row in system.gram[1:]]
            self.across = [-second, first]
            self.square = dot(self.along, [first, second])

    def coordinates(self, corner, is_turned):
        r, point = self.patch.rank, [x * self.factor for x in self.patch.part.position(corner)]
        base = minus(point[r:], self.start)
        if r == 1:
            base = [det([base, self.across]), det([self.along, base])]
            base = [self.square - base[0], -base[1]] if is_turned else base
        return minus(point[:r], self.offset) + base

    def check_wall(self, wall):
        """The pattern is that of the class, as seen from the left and from the right."""
        r = self.patch.rank
        self.left_corners = self.right_corners = self.wall_corners(wall, False)
        self.left = self.right = self.pattern(self.left_corners)
        pattern = self.left if self is wall else wall.left
        is_same = set(self.left) == set(pattern) and is_equal(self.square, wall.square)
        true(is_same, "wall-pattern", f"side {self.number} does not look like the first one of class {self.label}")
        if r == 1:
            self.right_corners = self.wall_corners(wall, True)
            self.right = self.pattern(self.right_corners)
            true(set(self.right) == set(pattern), "wall-reversal", f"side {self.number} looks different from its other end")

    def wall_corners(self, wall, is_turned):
        """For each vertex in this side the corner of the wall that is there."""
        zero = [0] * self.patch.rank
        return {v: wall.corner_at(self.coordinates((v, *zero), is_turned))
                for v, faces in enumerate(self.patch.part.on_faces) if self.number in faces}

    def roles(self):
        """Whether this side can be the left or the right one where two meet, and its corners then."""
        if self.patch.rank == 1:
            return [(True, self.left_corners), (False, self.right_corners)]
        return [(self.number == 1, self.left_corners)]

    def pattern(self, corners):
        """The polygons in the side, by the names that they have in the wall of the class."""
        polygons = [Polygon(corners, polygon, apex, n) for n, (apex, polygon, s) in enumerate(self.patch.pyramids) if s == self.number]
        for row in self.patch.rows:
            for apex in row:
                facet = [corner for corner in row if corner != apex]
                if self.number in self.patch.faces(*facet):
                    polygons.append(Polygon(corners, facet, apex, None))
        return {polygon.name: polygon for polygon in polygons}

    def corner_at(self, coordinates):
        """The corner of this side with these coordinates; none has the number -1."""
        r = self.patch.rank
        for v, faces in enumerate(self.patch.part.on_faces):
            if self.number in faces:
                difference = minus(coordinates, self.coordinates((v, *[0] * r), False))
                shift = [whole_quotient(x, self.system.scale) for x in difference[:r]]
                if None not in shift and all(is_equal(x, 0) for x in difference[r:-1]):
                    return (v, *shift)
        return (-1, *[0] * r)

    def point(self, corner):
        return self.system.point(self.patch, corner)

    def point_of(self, right, corner, shift):
        """The point of a corner of a tile that meets this one here, moved by a lattice vector."""
        r, unit = self.patch.rank, self.system.unit
        there = right.coordinates(corner, True)
        lattice = [(x + y + z * self.system.scale) * unit for x, y, z in zip(there, self.offset, shift)]
        if r == 2:
            return lattice + [there[2] + self.start[0]]
        factor = self.system.others(self.system.walls[self.label])
        moves = [x * there[1] + y * there[2] for x, y in zip(self.along, self.across)]
        return lattice + [x * unit + y * factor for x, y in zip(self.start, moves)]


class Polygon:
    """A polygon in a side, and the apex over it: of a pyramid, or of a tetrahedron over a triangle."""

    def __init__(self, seen, corners, apex, pyramid):
        self.corners, self.apex, self.pyramid = corners, apex, pyramid
        there = [moved(seen[corner[0]], corner[1:]) for corner in corners]
        self.base = min(there)[1:]
        self.there = [moved(corner, self.base, -1) for corner in there]
        self.name = (frozenset(frozenset(edge) for edge in cycle(self.there)), pyramid is not None)


def cycle(items):
    return list(zip(items, items[1:] + items[:1]))


def is_equal(x, y):
    return not any(coefficients([[x - y]]))


def whole_quotient(x, scale):
    """x / scale where this is an integer."""
    first, *others = x.coefficients if isinstance(x, Element) else [x]
    return None if any(others) or first % scale else first // scale


def check_corners(s):
    """The angles of the tiles are parts of a turn, and the offsets follow them. Returns for each tile its angles, and the whole."""
    turns = [[angle(s, patch, i) for i in range(len(patch.corners))] for patch in s.patches]
    whole = 1
    for _, count in sum(turns, []):
        whole = whole * count // gcd(whole, count)
    require(whole <= TURN, "declined", "corner-angle", f"angles are parts of more than {TURN}")
    parts = [[a * (whole // count) for a, count in row] for row in turns]
    steps = []
    for patch, row in zip(s.patches, parts):
        for i, a in enumerate(row):
            step = whole_quotient((patch.offsets[i - 1][0] - patch.offsets[i][0]) * whole, patch.scale)
            true(step is not None, "side-classes", f"at corner {i} the offsets differ by no part of {whole}")
            steps.append((step, a))
    is_consistent = any(all((step - a * n) % whole == 0 for step, a in steps) for n in range(whole))
    true(is_consistent, "side-classes", "around a vertex of the tiles the offsets do not close")
    return parts, whole


def angle(s, patch, i):
    """The angle at corner i as a part of a turn: a numerator and the least denominator."""
    corner, one, other = (patch.corners[j % len(patch.corners)] for j in (i, i + 1, i - 1))
    g = [row[1:] for row in s.gram[1:]]
    u, v = minus(one, corner), minus(other, corner)
    x = (dot(u, [dot(row, v) for row in g]), det([u, v]))
    power, turns = x, 0
    for n in range(1, TURN + 1):
        if sign(power[1]) == 0 and sign(power[0]) > 0:
            return turns, n
        following = (power[0] * x[0] - det(g) * power[1] * x[1], power[0] * x[1] + power[1] * x[0])
        turns += sign(power[1]) < 0 <= sign(following[1])
        power = following
    raise Refusal("declined", "corner-angle", f"corner {i} has no angle that is a part of at most {TURN} of a turn")


class Join:
    """Two pyramids over one polygon, and the tetrahedra around the axis between their apexes."""

    def __init__(self, s, left, right, one, other):
        self.one, self.other = one, other
        self.beyond = left.point_of(right, other.apex, minus(one.base, other.base))
        self.polygon, self.apex = [left.point(corner) for corner in one.corners], left.point(one.apex)
        self.shapes = [Shape(s, [self.beyond, x, y, self.apex]) for x, y in cycle(self.polygon)]
        for shape in self.shapes:
            true(sign(det(shape.edges)) > 0, "missing-join", "the axis between two apexes does not cross their polygon")


def inner_pairs(s, patch, joins):
    """The facets inside of a tile that are in no fan: their corners, and what can be opposite to them on each side."""
    groups = {}
    for row in patch.rows:
        for apex in row:
            facet = [corner for corner in row if corner != apex]
            if not patch.faces(*facet):
                add_points(s, groups, facet, [s.point(patch, apex)])
    for n, (apex, polygon, _) in enumerate(patch.pyramids):
        beyond = distinct(join.beyond for left, _, join in joins if left.patch is patch and join.one.pyramid == n)
        for one, other in cycle(polygon):
            add_points(s, groups, [one, other, apex], beyond)
    for name, (points, others) in groups.items():
        yield [s.point(patch, corner) for corner in name], points, others


def add_points(s, groups, facet, points):
    """Adds the points on one side of a facet, seen from its first corner."""
    name, base = facet_name(facet)
    moves = [x * s.scale for x in base] + [0] * (3 - s.rank)
    groups.setdefault(name, []).append([[x - s.unit * y for x, y in zip(point, moves)] for point in points])


def distinct(points):
    found = {tuple(coefficients([point])): point for point in points}
    return list(found.values())


def axial_pairs(join):
    """The facets with the axis of a join."""
    for before, corner, after in zip(join.polygon[-1:] + join.polygon, join.polygon, join.polygon[1:] + join.polygon):
        yield [corner, join.apex, join.beyond], [before], [after]


def check_local(s, pairs, test, code):
    for facet, points, others in pairs:
        for shape in (Shape(s, [point, *facet]) for point in points):
            side = sign(det(shape.edges))
            for other in others:
                s.proved(test(shape.power(s, other) * side), code, "two cells with a common facet")


def check_valences(s, parts, whole, joins):
    """TCP. Edges inside of tiles, in walls and over the vertices of tiles have 5 or 6 cells, and no triangle has two sixes."""
    for valence in (len(polygon) for patch in s.patches for _, polygon, _ in patch.pyramids):
        true(valence in (5, 6), "edge-valence", f"the axis of a join has the valence {valence}")
    counts = {patch: Counts(patch) for patch in s.patches}
    walls = {}
    for side in s.sides:
        for edge in counts[side.patch].edges_in(side.number):
            for is_left, seen in side.roles():
                walls.setdefault((side.label, wall_edge(seen, edge)), (set(), set()))[is_left].add(counts[side.patch].rows[edge])
    six = {}
    for patch in s.patches:
        c = counts[patch]
        for edge in c.edges:
            faces = patch.faces(*edge)
            if not faces:
                found = {c.rows[edge] + c.lateral[edge]}
            elif len(faces) == 1:
                side = next(x for x in s.sides if x.patch is patch and x.number in faces)
                left, right = walls[side.label, wall_edge(side.roles()[0][1], edge)]
                found = {x + y + c.flat[edge] for x in left for y in right}
            else:
                vertex = next(i for i in faces if (i - 1) % len(patch.corners) in faces)
                is_share = (2 * c.rows[edge] + c.flat[edge]) * whole == 12 * parts[s.patches.index(patch)][vertex]
                true(is_share, "edge-valence", "the cells at an edge over a vertex of a tile are not its share of six")
                found = {6}
            true(found <= {5, 6}, "edge-valence", f"an edge can have the valence {max(found - {5, 6}, default=0)}")
            six[patch, edge] = 6 in found
    for patch in s.patches:
        triangles = [triangle for row in patch.rows for triangle in combinations(row, 3)]
        triangles += [(apex, *edge) for apex, polygon, _ in patch.pyramids for edge in cycle(polygon)]
        for triangle in triangles:
            found = sum(six[patch, edge_name(edge)] for edge in combinations(triangle, 2))
            true(found < 2, "triangle-valence", "a triangle can have two edges of valence 6")
    for left, right, join in joins:
        valence = len(join.polygon)
        mine, theirs = ({there: six[side.patch, edge_name((polygon.apex, corner))] for there, corner in zip(polygon.there, polygon.corners)}
                        for side, polygon in ((left, join.one), (right, join.other)))
        is_allowed = all(mine[corner] + theirs[corner] + (valence == 6) < 2 for corner in mine)
        true(is_allowed, "triangle-valence", "a triangle at an axis can have two edges of valence 6")


def edge_name(edge):
    return facet_name(edge)[0]


def wall_edge(seen, edge):
    return edge_name([moved(seen[corner[0]], corner[1:]) for corner in edge])


class Counts:
    """For each edge of a piece and its pyramids: its rows, the cells of joins inside, and the polygons with it in sides."""

    def __init__(self, patch):
        self.patch = patch
        self.rows = Counter(edge_name(edge) for row in patch.rows for edge in combinations(row, 2))
        self.lateral, self.flat = Counter(), Counter()
        for apex, polygon, _ in patch.pyramids:
            self.flat.update(edge_name(edge) for edge in cycle(polygon))
            self.lateral.update(edge_name((apex, corner)) for corner in polygon * 2)
        self.edges = {*self.rows, *self.lateral, *self.flat}

    def edges_in(self, side):
        return [edge for edge in self.edges if self.patch.faces(*edge) == {side}]


def check_patches(data):
    """Refuses, or returns the system, which then proves what it claims."""
    s = System(data)
    corners = check_corners(s) if s.rank == 1 else ([], 1)
    joins, pairs = [], []
    for left, right in s.meetings():
        for name, one in left.left.items():
            other = right.right[name]
            if one.pyramid is not None:
                joins.append((left, right, Join(s, left, right, one, other)))
            else:
                beyond = left.point_of(right, other.apex, minus(one.base, other.base))
                pairs.append(([left.point(corner) for corner in one.corners], [left.point(one.apex)], [beyond]))
    pieces = [[Shape(s, [s.point(patch, corner) for corner in row]) for row in patch.rows] for patch in s.patches]
    shapes = [shape for _, _, join in joins for shape in join.shapes]
    attained = s.all_leaves
    for statement in s.statements:
        name = statement[0]
        if name in ("acute", "nonobtuse"):
            for cells in [*pieces, shapes]:
                check_acute(s, cells, positive_in if name == "acute" else nonnegative_in, f"not-{name}")
        elif name in BOUNDS:
            check_bound(s, shapes, statement)
            attained &= some(check_bound(s, piece, statement) for piece in pieces)
        elif name in DELAUNAY:
            inner = [pair for patch in s.patches for pair in inner_pairs(s, patch, joins)]
            axial = [pair for _, _, join in joins for pair in axial_pairs(join)]
            check_local(s, inner + axial + pairs, *DELAUNAY[name])
    if s.claims("TCP"):
        check_valences(s, *corners, joins)
    s.proved(attained, "not-attained", "the cells of no tile attain a bound")
    return s


def check(data):
    """Refuses, or returns what then proves what it claims."""
    kind = data["kind"] if isinstance(data, dict) and "kind" in data else data[2] if isinstance(data, Record) else None
    return check_patches(data) if kind == "patches" else check_tiling(data)


# Files.


def shown_number(p, q):
    return f"{p.coefficients}/{q}" if isinstance(p, Element) else str(Fraction(p, q))


def is_cbor(content):
    """An array of CBOR begins with a byte from 0x80 to 0x9f, and no text in UTF-8 does."""
    return b"\x80" <= content[:1] < b"\xa0"


def tree_of(content):
    if not is_cbor(content):
        return read_json(content)
    tree = read_cbor(content)
    formed(isinstance(tree, list) and len(tree) == 5, "json", "not an array of five")
    check_header(dict(zip(("format", "version"), tree)))
    return tree


def verdict(path):
    """A line about a file, and the exit code."""
    try:
        with open(path, "rb") as file:
            content = file.read()
        tree = tree_of(content)
        c = check(tree)
    except Refusal as refusal:
        code = "cbor" if refusal.code == "json" and is_cbor(content) else refusal.code
        return f"{refusal.kind} [{code}] {refusal}", EXIT_CODES[refusal.kind]
    except OSError as error:
        return f"unreadable: {error.strerror}", 2
    said = "; ".join(in_words(statement) for statement in c.statements) + (f"; for {c.box.in_words()}" if c.box else "")
    return f"verified: {said} ({c.sizes()}, sha256 {hashlib.sha256(cbor(tree)).hexdigest()})", 0


def in_words(statement):
    name, relation, side, bound = statement
    if bound is None:
        return name
    if name == PLANE:
        normal, p, q = bound
        return f"no simplex crosses {normal} · x = {shown_number(p, q)} or a translate of it by the lattice"
    number = shown_number(*bound)
    return f"{name} {relation} " + (number if name == BOUNDS[2] else f"arccos({side} √({number}))")


def shown(path):
    """A name of ordinary characters itself, any other as a JSON string: no name forges a line."""
    return path if re.fullmatch("[A-Za-z0-9._/+=@%~-]+", path) else json.dumps(path)


def main(paths):
    if not paths or paths[0].startswith("-"):
        print(__doc__)
        return 0 if paths and paths[0] in ("-h", "--help") else 2
    worst = 0
    for path in paths:
        line, code = verdict(path)
        print(f"{shown(path)}: {line}", flush=True)
        worst = min(worst or code, code or worst)
    return worst


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
