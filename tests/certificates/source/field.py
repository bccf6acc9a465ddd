"""Exact numbers: the rationals, and Q(a) for a real root a of an integer polynomial.

An element is a tuple of fractions, the coefficients of 1, a, a^2, and so on. Equality is equality
of coefficients. The polynomial may be reducible; then `sign` and `inverse` may fail.
"""
import math
from fractions import Fraction as F
from functools import cache, reduce


class Undecided(Exception):
    """No enclosure of the root shows the sign, or a divisor of zero has no inverse."""


class Field:
    def __init__(self, polynomial=None, low=0, high=0):
        self.polynomial = polynomial
        self.degree = len(polynomial) - 1 if polynomial else 1
        self.low, self.high = F(low), F(high)

    def element(self, x):
        if isinstance(x, tuple):
            return x
        coefficients = [F(c) for c in (x if isinstance(x, list) else [x])]
        return tuple(coefficients + [F(0)] * (self.degree - len(coefficients)))

    def add(self, *terms):
        return tuple(map(sum, zip(*terms)))

    def negative(self, x):
        return tuple(-c for c in x)

    def subtract(self, x, y):
        return tuple(a - b for a, b in zip(x, y))

    def multiply(self, x, y):
        product = [F(0)] * (2 * self.degree - 1)
        for i, a in enumerate(x):
            for j, b in enumerate(y):
                product[i + j] += a * b
        for k in range(2 * self.degree - 2, self.degree - 1, -1):
            for j in range(self.degree):
                product[k - self.degree + j] -= product[k] * self.polynomial[j]
        return tuple(product[:self.degree])

    def product(self, *factors):
        return reduce(self.multiply, factors)

    def inverse(self, x):
        """Solves x y = 1 by elimination in the basis of the powers of a."""
        n = self.degree
        powers = [tuple(F(int(i == k)) for i in range(n)) for k in range(n)]
        columns = [self.multiply(x, power) for power in powers]
        rows = [[column[i] for column in columns] + [powers[0][i]] for i in range(n)]
        for k in range(n):
            pivot = next((i for i in range(k, n) if rows[i][k]), None)
            if pivot is None:
                raise Undecided
            rows[k], rows[pivot] = rows[pivot], rows[k]
            rows[k] = [c / rows[k][k] for c in rows[k]]
            for i in range(n):
                if i != k:
                    rows[i] = [c - rows[i][k] * d for c, d in zip(rows[i], rows[k])]
        return tuple(row[n] for row in rows)

    def value(self, t):
        return reduce(lambda total, c: total * t + c, reversed(self.polynomial), F(0))

    @cache
    def enclosure(self, k):
        """The root's interval, halved 32 k times."""
        if k == 0:
            return self.low, self.high
        low, high = self.enclosure(k - 1)
        rising = self.value(self.high) > 0
        for _ in range(32):
            middle = (low + high) / 2
            if (self.value(middle) > 0) == rising:
                high = middle
            else:
                low = middle
        return low, high

    def sign(self, x):
        if not any(x):
            return 0
        if not any(x[1:]):
            return 1 if x[0] > 0 else -1
        for k in range(40):
            least, greatest = self.range(x, *self.enclosure(k))
            if least > 0:
                return 1
            if greatest < 0:
                return -1
        raise Undecided

    @staticmethod
    def range(coefficients, low, high):
        """Horner's rule in interval arithmetic."""
        least = greatest = F(0)
        for c in reversed(coefficients):
            ends = [least * low, least * high, greatest * low, greatest * high]
            least, greatest = min(ends) + c, max(ends) + c
        return least, greatest

    def less(self, x, y):
        return self.sign(self.subtract(x, y)) < 0

    def integers(self, x):
        """The form in a certificate of an element with integral coefficients."""
        assert all(c.denominator == 1 for c in x)
        return int(x[0]) if self.degree == 1 else [int(c) for c in x]

    def fraction(self, x):
        """A numerator over the least positive integer."""
        denominator = common_denominator([x])
        return [self.integers(times(x, denominator)), denominator]


Q = Field()


def times(x, factor):
    return tuple(c * factor for c in x)


def common_denominator(elements):
    return math.lcm(*(c.denominator for x in elements for c in x))


def content(elements):
    return math.gcd(*(int(c) for x in elements for c in x))


def minor(matrix, i, j):
    return [row[:j] + row[j + 1:] for k, row in enumerate(matrix) if k != i]


def determinant(field, matrix):
    if len(matrix) == 1:
        return matrix[0][0]
    terms = []
    for j, entry in enumerate(matrix[0]):
        term = field.multiply(entry, determinant(field, minor(matrix, 0, j)))
        terms.append(field.negative(term) if j % 2 else term)
    return field.add(*terms)


def adjugate(field, matrix):
    """The transposed cofactors of a symmetric matrix are its cofactors."""
    n = len(matrix)
    cofactors = [[determinant(field, minor(matrix, i, j)) for j in range(n)] for i in range(n)]
    return [[field.negative(c) if (i + j) % 2 else c for j, c in enumerate(row)] for i, row in enumerate(cofactors)]


def inner(field, gram, x, y):
    return field.add(*(field.product(x[i], gram[i][j], y[j]) for i in range(len(x)) for j in range(len(y))))


def products(field, gram, edges):
    """The inner products of the edges, and those of the facets' inward normals, up to a positive factor."""
    m = [[inner(field, gram, x, y) for y in edges] for x in edges]
    c = adjugate(field, m)
    first = [field.negative(field.add(*column)) for column in zip(*c)]
    corner = field.negative(field.add(*first))
    normals = [[corner, *first]] + [[first[i], *row] for i, row in enumerate(c)]
    return m, normals


def signed(field, cosine):
    """A number that grows with the cosine, given by its sign and square."""
    sign, square = cosine
    return square if sign > 0 else field.negative(square)


def figures(field, gram, edges):
    """The cosines of the largest and the smallest dihedral angle (sign, square), and R^2 / l^2."""
    m, normals = products(field, gram, edges)
    d = len(edges)
    cosines = []
    for i in range(d + 1):
        for j in range(i):
            g = field.negative(normals[i][j])
            square = field.multiply(g, g)
            square = field.multiply(square, field.inverse(field.multiply(normals[i][i], normals[j][j])))
            cosines.append((field.sign(g), square))
    largest = smallest = cosines[0]
    for cosine in cosines[1:]:
        if field.less(signed(field, cosine), signed(field, largest)):
            largest = cosine
        if field.less(signed(field, smallest), signed(field, cosine)):
            smallest = cosine
    return largest, smallest, squared_ratio(field, m)


def squared_ratio(field, m):
    """R^2 = s C s / 4 det M for the squared lengths s from a corner; l^2 is the least squared length."""
    d, c = len(m), adjugate(field, m)
    s = [m[i][i] for i in range(d)]
    radius = field.add(*(field.product(s[i], c[i][j], s[j]) for i in range(d) for j in range(d)))
    lengths = s + [field.add(s[i], s[j], times(m[i][j], -2)) for i in range(d) for j in range(i)]
    shortest = lengths[0]
    for length in lengths[1:]:
        shortest = length if field.less(length, shortest) else shortest
    return field.multiply(radius, field.inverse(times(field.multiply(determinant(field, m), shortest), 4)))
