"""Reads JSON strictly: the shape of the grammar and the canonical form."""
import json
import re
from fractions import Fraction as F

from .build import CROSSED, LARGEST, RATIO, RELATIONS, SMALLEST, TILING
from .encode import text

ORDER = [TILING, "acute", "nonobtuse", LARGEST, SMALLEST, RATIO, CROSSED, "Delaunay", "weakly Delaunay", "locally Delaunay",
         "locally weakly Delaunay", "not Delaunay", "TCP"]


class Refusal(Exception):
    pass


def ensure(condition, code):
    if not condition:
        raise Refusal(code)


def no_such(_):
    raise Refusal("json")


def decimal(literal):
    """A whole number in another notation; `text` does not write it so."""
    value = F(literal)
    ensure(value.denominator == 1, "json")
    return int(value)


def read(data, kind="tiling", check_shape=None):
    try:
        value = json.loads(data.decode("ascii"), parse_float=decimal, parse_constant=no_such,
                           object_pairs_hook=lambda pairs: dict(pairs))
    except (ValueError, RecursionError):
        raise Refusal("json") from None
    value = numbers(value)
    record(value, format=a_text, version=integer, kind=a_text, claim=lambda _: None, witness=lambda _: None)
    ensure(value["format"] == "acutile-certificate", "format")
    ensure(value["version"] == 2, "version")
    ensure(value["kind"] == kind, "kind")
    (check_shape or shape)(value)
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
            if s[0] == CROSSED:
                array(lambda _: None, 3)(s)
                array(integer, claim["dimension"])(s[1])
                array(integer, 2)(s[2])
                return
            ensure(s[0] in (LARGEST, SMALLEST, RATIO), "statements")
            ensure(len(s) == (3 if s[0] == RATIO else 4), "json")
            a_text(s[1])
            ensure(s[1] in RELATIONS, "statements")
            if s[0] != RATIO:
                integer(s[2])
            bound_fraction(s[-1])
        else:
            a_text(s)
            ensure(s in ORDER and s not in (LARGEST, SMALLEST, RATIO, CROSSED), "statements")
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


def numbers_of(field):
    """The check of a number of this field."""
    return integer if field.degree == 1 else array(integer, field.degree)


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
