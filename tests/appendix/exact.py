"""Exact numbers: Q(a), signs by halving the root's interval, cosines by Taylor's series."""
import functools, itertools
from fractions import Fraction as F


class Wrong(Exception):
    pass


def must(condition, what):
    if not condition:
        raise Wrong(what)


class Field:
    """Q(a): lists of coefficients of 1, a, a², …"""

    def __init__(self, data):
        self.q = data == "Q"
        self.p = [F(0), F(1)] if self.q else [F(int(c)) for c in data["polynomial"]]
        self.n = len(self.p) - 1
        self.root = (F(0), F(0)) if self.q else tuple(
            F(int(data["root"][end]), int(data["root"]["denominator"])) for end in ("low", "high"))
        self.radicand, self.radical, self.rational = None, None, None
        if self.n == 2:
            c, b, _ = self.p
            square, d = 1, int(b * b - 4 * c)
            for k in range(2, 1000):
                while d % (k * k) == 0:
                    square, d = square * k, d // (k * k)
            if d == 1:  # a reducible polynomial: the root is rational
                roots = [(-b + s * square) / 2 for s in (1, -1)]
                self.rational = next(r for r in roots if self.root[0] < r < self.root[1])
                self.p, self.n = [-self.rational, F(1)], 1
                return
            # √d = ± (2a + b)/square
            radical = El(self, [b / square, F(2) / square])
            self.radicand, self.radical = d, radical if radical.sign() > 0 else -radical

    def at(self, c, x):
        value = F(0)
        for k in reversed(c):
            value = value * x + k
        return value

    def halve(self):
        lo, hi = self.root
        mid = (lo + hi) / 2
        if (self.at(self.p, lo) > 0) == (self.at(self.p, mid) > 0):
            self.root = (mid, hi)
        else:
            self.root = (lo, mid)

    def of(self, x):
        """A number of a certificate, or a decimal."""
        if isinstance(x, list):
            if self.rational is not None:
                return El(self, [sum(int(c) * self.rational ** i for i, c in enumerate(x))])
            return El(self, [F(int(c)) for c in x])
        return El(self, [F(x)])


class El:
    def __init__(self, k, c):
        self.k = k
        c = list(c)
        while len(c) > k.n:
            top = c.pop()
            for i in range(k.n):
                c[len(c) - k.n + i] -= top * k.p[i]
        while len(c) > 1 and c[-1] == 0:
            c.pop()
        self.c = c or [F(0)]

    @classmethod
    def rational(cls, k, x):
        """The same without the work of __init__, for most numbers are rational."""
        number = cls.__new__(cls)
        number.k, number.c = k, [x]
        return number

    def lift(self, other):
        return other if isinstance(other, El) else El(self.k, [F(other)])

    def __add__(self, o):
        o = self.lift(o)
        if len(self.c) == len(o.c) == 1:
            return El.rational(self.k, self.c[0] + o.c[0])
        return El(self.k, [a + b for a, b in itertools.zip_longest(self.c, o.c, fillvalue=F(0))])

    def __neg__(self):
        return El(self.k, [-a for a in self.c])

    def __sub__(self, o):
        return self + -self.lift(o)

    def __mul__(self, o):
        o = self.lift(o)
        if len(self.c) == len(o.c) == 1:
            return El.rational(self.k, self.c[0] * o.c[0])
        c = [F(0)] * (len(self.c) + len(o.c) - 1)
        for i, a in enumerate(self.c):
            for j, b in enumerate(o.c):
                c[i + j] += a * b
        return El(self.k, c)

    __radd__, __rmul__ = __add__, __mul__

    def __rsub__(self, o):
        return self.lift(o) - self

    def inverse(self):
        """Solves x y = 1 for the coefficients of y."""
        if len(self.c) == 1:
            must(self.c[0] != 0, "division by zero")
            return El.rational(self.k, 1 / self.c[0])
        n = self.k.n
        rows = [[F(0)] * (n + 1) for _ in range(n)]
        for j in range(n):
            column = (self * El(self.k, [F(0)] * j + [F(1)])).c
            for i, value in enumerate(column):
                rows[i][j] = value
        rows[0][n] = F(1)
        for j in range(n):
            pivot = next((i for i in range(j, n) if rows[i][j] != 0), None)
            must(pivot is not None, "division by zero")
            rows[j], rows[pivot] = rows[pivot], rows[j]
            rows[j] = [x / rows[j][j] for x in rows[j]]
            for i in range(n):
                if i != j:
                    rows[i] = [x - rows[i][j] * y for x, y in zip(rows[i], rows[j])]
        return El(self.k, [row[n] for row in rows])

    def __truediv__(self, o):
        return self * self.lift(o).inverse()

    def __eq__(self, o):
        return self.c == self.lift(o).c

    def __hash__(self):
        return hash(tuple(self.c))

    def bounds(self):
        """An enclosure from that of the root, by Horner's rule with intervals."""
        lo = hi = F(0)
        a, b = self.k.root
        for c in reversed(self.c):
            ends = [lo * a, lo * b, hi * a, hi * b]
            lo, hi = min(ends) + c, max(ends) + c
        return lo, hi

    def sign(self):
        if len(self.c) == 1:
            return (self.c[0] > 0) - (self.c[0] < 0)
        for _ in range(2000):
            lo, hi = self.bounds()
            if lo > 0 or hi < 0:
                return 1 if lo > 0 else -1
            self.k.halve()
        raise Wrong("a sign that is not decided")


def sign_of_difference(signed_square, x):
    """The sign of c - x, where c has this sign and square."""
    s = signed_square.sign()
    t = (x > 0) - (x < 0)
    if s != t:
        return 1 if s > t else -1
    return s * (signed_square * s - x * x).sign()


@functools.cache
def cosine(degrees):
    """Rational bounds of cos, by Taylor's series; pi from Machin's formula."""
    def atan(n):
        total, k = F(0), 0
        while F(1, (2 * k + 1) * n ** (2 * k + 1)) > F(1, 10 ** 40):
            total += F((-1) ** k, (2 * k + 1) * n ** (2 * k + 1))
            k += 1
        return total
    global PI
    if PI is None:
        PI = 16 * atan(5) - 4 * atan(239)
        PI = F(round(PI * 10 ** 36), 10 ** 36)
    x = degrees * PI / 180
    x = F(round(x * 10 ** 34), 10 ** 34)
    term, total, k = F(1), F(0), 0
    while abs(term) > F(1, 10 ** 32) or k < 10:
        total += term
        k += 1
        term = -term * x * x / ((2 * k - 1) * (2 * k))
        term = F(round(term * 10 ** 40), 10 ** 40)
    return total - F(1, 10 ** 28), total + F(1, 10 ** 28)


PI = None


# The ends of an enclosure of width 1e-9, rounded outward to six decimals, are no farther away.
SLACK = F(1002, 10 ** 9)


def check_cosine_interval(square, low, high, what):
    must(sign_of_difference(square, low) >= 0 >= sign_of_difference(square, high),
         f"{what}: the cosine is not in [{float(low)}, {float(high)}]")
    if low < high:
        must(sign_of_difference(square, low + SLACK) <= 0 <= sign_of_difference(square, high - SLACK),
             f"{what}: the cosine is far from an end of [{float(low)}, {float(high)}]")


def check_degrees(square, low, high, what):
    """The cosine falls: cos(low) >= c >= cos(high)."""
    if low == high:  # said to be exact: then it is in a much smaller interval, too
        low, high = low - F(1, 10 ** 20), high + F(1, 10 ** 20)
    else:
        must(sign_of_difference(square, cosine(low + SLACK)[0]) >= 0 >= sign_of_difference(square, cosine(high - SLACK)[1]),
             f"{what}: the angle is far from an end of [{float(low)}, {float(high)}]")
    must(sign_of_difference(square, cosine(low)[1]) <= 0 <= sign_of_difference(square, cosine(high)[0]),
         f"{what}: the angle is not in [{float(low)}, {float(high)}]")


def largest(xs):
    best = xs[0]
    for x in xs[1:]:
        if (x - best).sign() > 0:
            best = x
    return best


def smallest(xs):
    return -largest([-x for x in xs])
