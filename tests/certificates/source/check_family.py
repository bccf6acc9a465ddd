"""A slow checker of families: it evaluates them in many points of the box, and checks each of these tilings.

It says what is false in some of these points. It proves nothing about the others.
"""
import math
import re
from fractions import Fraction as F

from .check import check
from .claim import field_of
from .family import samples
from .field import Undecided, common_denominator, content, times
from .shape import Refusal, a_text, array, domain_shape, ensure, integer, numbers_of, read, record
from .shape import shape as tiling_shape


def codes_of(data):
    """The codes of the refusals in all points; None for a point where everything is true."""
    try:
        family = read(data, "family", shape)
        points = list(samples(family["claim"]["parameters"], field_of(family["claim"])))
        tiling_shape(tiling_at(family, points[0]))
        return {code_at(family, point) for point in points}
    except Refusal as refusal:
        return {str(refusal)}
    except Undecided:
        return {"sign-undecided"}


def code_at(family, point):
    try:
        check(tiling_at(family, point))
    except Refusal as refusal:
        return str(refusal)
    except Undecided:
        return "sign-undecided"
    return None


def tiling_at(family, point):
    """The certificate of the tiling with these parameters, its numbers integral and primitive."""
    claim, witness = family["claim"], family["witness"]
    f = field_of(claim)
    gram, _ = primitive(f, evaluated(f, claim["gram"], point), 0)
    domain = claim["domain"]
    if domain != "space":
        vertices, denominator = primitive(f, evaluated(f, domain[1]["vertices"], point), domain[1]["denominator"])
        domain = [domain[0], {**domain[1], "denominator": denominator, "vertices": vertices}]
    vertices, denominator = primitive(f, evaluated(f, witness["vertices"], point), witness["denominator"])
    return {
        **family, "kind": "tiling",
        "claim": {"dimension": claim["dimension"], "field": claim["field"], "gram": gram, "domain": domain, "statements": claim["statements"]},
        "witness": {"denominator": denominator, "vertices": vertices, "boundary": [], "simplices": witness["simplices"]},
    }


def evaluated(f, rows, point):
    return [[value_at(f, value, point) for value in row] for row in rows]


def value_at(f, value, point):
    total = f.element(0)
    for c, *exponents in value:
        powers = [x for x, e in zip(point, exponents) for _ in range(e)]
        total = f.add(total, f.product(f.element(c), *powers))
    return total


def primitive(f, rows, denominator):
    """The rows times a positive number; so is the denominator."""
    entries = [x for row in rows for x in row] + [f.element(denominator)]
    scale = common_denominator(entries)
    factor = F(scale, content(times(x, scale) for x in entries) or 1)
    return [[f.integers(times(x, factor)) for x in row] for row in rows], int(denominator * factor)


# --- the grammar ------------------------------------------------------------------


def shape(family):
    """What the grammar and the canonical form demand beyond that of a tiling."""
    claim, witness = family["claim"], family["witness"]
    record(claim, dimension=integer, field=lambda _: None, parameters=array(lambda _: None), gram=lambda _: None,
           domain=lambda _: None, statements=lambda _: None)
    record(witness, denominator=integer, vertices=lambda _: None, boundary=array(lambda _: None), tree=lambda _: None,
           simplices=array(lambda _: None))
    d, parameters = claim["dimension"], claim["parameters"]
    ensure(d in (2, 3), "dimension")
    ensure(claim["field"] == "Q" or len(claim["field"]["polynomial"]) <= 9, "degree")
    f = field_of(claim)
    number = numbers_of(f)
    ensure(0 < len(parameters) <= 64, "parameters")
    for parameter in parameters:
        check_parameter(parameter, f, number)
    ensure(len({p["name"] for p in parameters}) == len(parameters), "parameter-name")
    ensure(check_tree(witness["tree"], len(parameters), 0) <= 4096, "tree-size")
    used = set()
    value = array(lambda term: check_term(term, len(parameters), number, used))

    def values(x):
        value(x)
        ensure([term[1:] for term in x] == sorted({tuple(term[1:]): term[1:] for term in x}.values()), "terms")
    array(array(values))(claim["gram"])
    ensure([len(row) for row in claim["gram"]] == list(range(d, 0, -1)), "json")
    primitive_values([], claim["gram"])
    ensure(not (isinstance(claim["domain"], list) and claim["domain"][:1] == ["region"]), "family-domain")
    rank = domain_shape(claim["domain"], d, values)
    if rank < d:
        body = claim["domain"][1]
        ensure(body["denominator"] > 0, "denominator")
        primitive_values([body["denominator"]], body["vertices"])
    ensure(not witness["boundary"], "boundary-domain")
    array(array(values, d))(witness["vertices"])
    ensure(witness["denominator"] > 0, "denominator")
    primitive_values([witness["denominator"]], witness["vertices"])
    ensure(len(used) == len(parameters), "unused-parameter")


def check_parameter(parameter, f, number):
    ends = []

    def end(x):
        ensure(isinstance(x, list) and len(x) == 2 and x[0] in ("closed", "open"), "json")
        fraction = x[1]
        ensure(isinstance(fraction, list) and len(fraction) == 2, "json")
        number(fraction[0])
        integer(fraction[1])
        ensure(fraction[1] > 0, "denominator")
        ensure(math.gcd(fraction[1], *coefficients(fraction[0])) == 1, "canonical")
        ends.append(times(f.element(fraction[0]), F(1, fraction[1])))
    record(parameter, name=a_text, low=end, high=end)
    ensure(re.fullmatch("[a-z][a-z0-9_]*", parameter["name"]) and len(parameter["name"]) <= 16, "parameter-name")
    width = f.sign(f.subtract(ends[1], ends[0]))
    ensure(width >= 0, "box-exchanged")
    ensure(width > 0, "box-empty")


def check_tree(tree, count, depth):
    """The number of leaves."""
    ensure(isinstance(tree, list) and len(tree) in (0, 3), "json")
    if not tree:
        return 1
    integer(tree[0])
    ensure(0 <= tree[0] < count, "tree")
    ensure(depth < 64, "tree-size")
    return sum(check_tree(half, count, depth + 1) for half in tree[1:])


def check_term(term, count, number, used):
    ensure(isinstance(term, list) and len(term) == 1 + count, "json")
    c, *exponents = term
    number(c)
    for k, e in enumerate(exponents):
        integer(e)
        ensure(0 <= e <= 15, "exponent")
        used |= {k} if e else set()
    ensure(any(coefficients(c)), "terms")


def coefficients(x):
    return x if isinstance(x, list) else [x]


def primitive_values(integers, rows):
    ensure(math.gcd(*integers, *(c for row in rows for value in row for term in value for c in coefficients(term[0]))) == 1, "canonical")
