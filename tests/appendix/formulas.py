"""Reading what the appendix typesets: numbers, corners, facets, tables."""
import re
from fractions import Fraction as F

from exact import El, Wrong, must


class Root:
    """c √e for elements c and e >= 0 of the field; e = 1 where there is no root."""

    def __init__(self, c, e):
        self.c, self.e = c, e

    def pure(self):
        must(self.e == 1, "a root in a place for numbers of the field")
        return self.c

    def signed_square(self):
        square = self.c * self.c * self.e
        return square if self.c.sign() >= 0 else -square


TOKEN = re.compile(r"\s*(\\[a-zA-Z]+|\d+\.\d+|\d+|[-+/(){}^_=<>,\[\]]|\\,)")


class Reader:
    """A formula: + - / juxtaposition, \\frac, \\sqrt, \\alpha, \\acutiledecimal, N_{ij}."""

    def __init__(self, field, text, names=None):
        self.k, self.names = field, names or {}
        text = text.replace("\\,", " ").replace("\\allowbreak", " ").replace("\\cdot", " ")
        self.tokens, place = [], 0
        while place < len(text.rstrip()):
            match = TOKEN.match(text, place)
            must(match, f"cannot be read: {text[place:place + 40]!r}")
            self.tokens.append(match.group(1))
            place = match.end()
        self.at = 0

    def peek(self):
        return self.tokens[self.at] if self.at < len(self.tokens) else None

    def take(self, expected=None):
        token = self.peek()
        must(token is not None and expected in (None, token), f"found {token}, expected {expected}")
        self.at += 1
        return token

    def end(self):
        must(self.peek() is None, f"more than a number: {self.tokens}")

    def sum(self):
        negative = self.peek() == "-" and self.take()
        value = self.quotient()
        if negative:
            value = Root(-value.c, value.e)
        while self.peek() in ("+", "-"):
            sign = self.take()
            term = self.quotient()
            must(term.e == value.e, "a sum of different roots")
            value = Root(value.c + term.c if sign == "+" else value.c - term.c, value.e)
        return value

    def quotient(self):
        value = self.product()
        while self.peek() == "/":
            self.take()
            by = self.factor()
            value = Root(value.c / (by.c * by.e), value.e * by.e if by.e != value.e else self.k.of("1"))
        return value

    def product(self):
        value = self.factor()
        while self.peek() is not None and (self.peek()[0] == "\\" or self.peek() in ("(", "N") or self.peek()[0].isdigit()):
            other = self.factor()
            must(value.e == 1 or other.e == 1, "a product of roots")
            value = Root(value.c * other.c, other.e if value.e == 1 else value.e)
        return value

    def group(self, opening="{", closing="}"):
        self.take(opening)
        value = self.sum()
        self.take(closing)
        return value

    def power(self, value):
        """The value, or its root where 1/2 is the exponent."""
        if self.peek() != "^":
            return value
        self.take()
        must(self.group().pure() == F(1, 2), "another exponent than 1/2")
        must(value.pure().sign() >= 0, "the root of a negative number")
        return Root(self.k.of("1"), value.pure())

    def factor(self):
        token = self.take()
        one = self.k.of("1")
        if token[0].isdigit():
            return Root(self.k.of(token), one)
        if token == "(":
            self.at -= 1
            return self.power(self.group("(", ")"))
        if token == "\\frac":
            over, under = self.group(), self.group()
            return Root(over.c / under.pure(), over.e)
        if token == "\\acutiledecimal":
            return self.group()
        if token == "\\alpha":
            power = 1
            if self.peek() == "^":
                self.take()
                power = int(self.group().pure().c[0])
            return Root(El(self.k, [F(0)] * power + [F(1)]), one)
        if token == "\\sqrt":
            inside = self.group().pure()
            if self.k.radicand is not None and inside == self.k.radicand:
                return Root(self.k.radical, one)
            must(inside.sign() >= 0, "the root of a negative number")
            return Root(one, inside)
        raise Wrong(f"found {token}")


def source(path):
    """The text of a file without the places where a line may break in a number."""
    return path.read_text().replace("\\acutilebreak ", "").replace("/\\allowbreak ", "/")


def number(field, text):
    reader = Reader(field, text)
    value = reader.sum()
    reader.end()
    return value.pure()


def math(cell):
    match = re.fullmatch(r"\s*\$(.*)\$\s*", cell)
    must(match, f"no formula: {cell!r}")
    return match.group(1)


def corner(text, rank):
    """`5^{1\\bar10}` as [5, 1, -1, 0]."""
    match = re.fullmatch(r"(\d+)(?:\^\{(.*)\})?", text)
    must(match, f"no corner: {text!r}")
    return [int(match.group(1))] + shift(match.group(2), rank)


def shift(text, rank):
    if text is None:
        return [0] * rank
    if text.startswith("("):
        found = [int(x) for x in text[1:-1].split(",")]
    else:
        found = [int(x.replace("\\bar", "-")) for x in re.findall(r"\\bar\d|\d", text)]
    must(len(found) == rank, f"a shift of another rank: {text}")
    return found


def mate(text, rank):
    if text == "\\partial":
        return [-1]
    match = re.fullmatch(r"\\partial_\{(\d+)\}", text)
    if match:
        return [int(match.group(1))]
    match = re.fullmatch(r"(\d+)_\{(\d+)\}(?:\^\{(.*)\})?", text)
    must(match, f"no facet: {text!r}")
    return [int(match.group(1)), int(match.group(2))] + shift(match.group(3), rank)


def rows_of(lines, start):
    """The cells of the table whose environment begins after line `start`."""
    begin = start
    while lines[begin] not in ("\\endlastfoot", "\\midrule") or (
            lines[begin] == "\\midrule" and "longtable" in lines[start + 1]):
        begin += 1
    rows = []
    for line in lines[begin + 1:]:
        if line.startswith(("\\end{", "\\bottomrule")):
            return rows
        rows.append([cell.strip() for cell in re.sub(r"\s*\\\\\*?$", "", line).split("&")])
    raise Wrong("a table without an end")


def interval(field, text):
    inner = text.strip()
    if inner.startswith("["):
        low, high = inner[1:-1].split(",", 1)
        return number(field, low).c[0], number(field, high.replace("\\allowbreak", "").replace("\\,", "", 1)).c[0]
    value = number(field, inner).c[0]
    return value, value
