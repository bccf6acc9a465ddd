"""Polynomials in parameters: coefficients, elements of a field, by exponents."""
from fractions import Fraction as F

from .field import Q, common_denominator, content, times


class Polynomial:
    def __init__(self, field, count, terms):
        self.field, self.count = field, count
        self.terms = {e: c for e, c in terms.items() if any(c)}

    def lifted(self, other):
        if isinstance(other, Polynomial):
            return other
        return Polynomial(self.field, self.count, {(0,) * self.count: self.field.element(other)})

    def __add__(self, other):
        terms = dict(self.terms)
        for e, c in self.lifted(other).terms.items():
            terms[e] = self.field.add(terms.get(e, self.field.element(0)), c)
        return Polynomial(self.field, self.count, terms)

    def __mul__(self, other):
        terms = {}
        for p, c in self.terms.items():
            for q, d in self.lifted(other).terms.items():
                e = tuple(map(sum, zip(p, q)))
                terms[e] = self.field.add(terms.get(e, self.field.element(0)), self.field.multiply(c, d))
        return Polynomial(self.field, self.count, terms)

    __radd__, __rmul__ = __add__, __mul__

    def __neg__(self):
        return self * -1

    def __sub__(self, other):
        return self + self.lifted(other) * -1

    def __rsub__(self, other):
        return -self + other

    def __truediv__(self, number):
        return self * F(1, number)

    def __pow__(self, n):
        return self.lifted(1) if n == 0 else self * self ** (n - 1)

    def at(self, point):
        """The value, for elements of the field as parameters."""
        total = self.field.element(0)
        for exponents, c in self.terms.items():
            for x, e in zip(point, exponents):
                for _ in range(e):
                    c = self.field.multiply(c, x)
            total = self.field.add(total, c)
        return total

    def terms_member(self, factor):
        """As in a certificate, times a factor that makes all coefficients integral."""
        return [[self.field.integers(times(c, factor)), *e] for e, c in sorted(self.terms.items())]


def variables(count, field=Q):
    units = [tuple(int(i == k) for i in range(count)) for k in range(count)]
    return [Polynomial(field, count, {e: field.element(1)}) for e in units]


def coefficients(values):
    return [c for value in values for c in value.terms.values()]


def integral_values(values):
    """The least positive integer that makes them all integral, and their common divisor then."""
    found = coefficients(values)
    denominator = common_denominator(found)
    return denominator, content(times(c, denominator) for c in found)
