"""Families that are no certificates, or not in the canonical form."""
from fractions import Fraction as F

from .build import TILING, edit, uncrossed
from .encode import to_json
from .family import closed, halved
from .malformed import BARE, MESH
from .valid_families import UNIT, X, X_, XYZ, Y_, isosceles, plane, rows_over_sqrt_3, strip
from .wrong import BOUNDARY, DOMAIN, GRAM, VERTICES, edited

PARAMETERS, TREE = ("claim", "parameters"), ("witness", "tree")
ONE = isosceles().certificate("acute")
TWO = plane(UNIT, [[1 + X_, F(1, 2)], [F(1, 2), 1 + Y_]], halved(0, 1)).certificate("acute")
ROOT, STRIP = rows_over_sqrt_3().certificate(), strip(X, ("open", 0), ("closed", 5)).certificate()
ENTRY = (*GRAM, 1, 0)


def value(*terms, base=ONE):
    """The last entry of the Gram matrix has these terms."""
    return edit(base, ENTRY, [list(term) for term in terms])


def parameter(base=ONE, **members):
    return edited(base, *(((*PARAMETERS, 0, name), member) for name, member in members.items()))


def named(*names):
    return edited(TWO, *(((*PARAMETERS, k, "name"), name) for k, name in enumerate(names)))


def ends(low, high):
    return parameter(low=["closed", low], high=["closed", high])


def replaced(old, new, base=ONE):
    before = to_json(base)
    assert before.count(old) >= 1, old
    return before.replace(old, new, 1)


def without_a_member(certificate, path):
    return edit(certificate, path, None)


def tree(value, base=TWO):
    return edit(base, TREE, value)


def as_family(tiling):
    """A tiling that says that it is a family."""
    return edit(tiling, ("kind",), "family")


JSON = {
    "json--family-without-parameters": without_a_member(ONE, PARAMETERS),
    "json--family-without-tree": without_a_member(ONE, TREE),
    "json--family-with-numbers-of-a-tiling": as_family(BARE),
    "json--family-kind-tiling": edit(ONE, ("kind",), "tiling"),
    "json--family-parameters-an-object": edit(ONE, PARAMETERS, {"t": [0, 1]}),
    "json--family-parameter-an-array": edit(ONE, (*PARAMETERS, 0), ["t", ["closed", [0, 1]], ["closed", [1, 1]]]),
    "json--family-parameter-without-end": without_a_member(ONE, (*PARAMETERS, 0, "high")),
    "json--family-name-a-number": parameter(name=7),
    "json--family-name-an-array": parameter(name=["t"]),
    "json--family-end-a-fraction-alone": parameter(low=[0, 1]),
    "json--family-end-of-another-kind": parameter(low=["half-open", [0, 1]]),
    "json--family-end-kind-a-number": parameter(low=[1, [0, 1]]),
    "json--family-end-too-long": parameter(low=["closed", [0, 1], 1]),
    "json--family-end-an-integer": parameter(low=["closed", 0]),
    "json--family-end-a-fraction-of-three": parameter(low=["closed", [0, 1, 1]]),
    "json--family-end-of-another-field": parameter(low=["closed", [[0, 0], 1]]),
    "json--family-end-over-q-in-a-field": parameter(base=ROOT, low=["closed", [0, 1]]),
    "json--family-value-an-integer": edit(ONE, ENTRY, 2),
    "json--family-term-an-integer": edit(ONE, ENTRY, [2]),
    "json--family-term-without-exponent": value([2]),
    "json--family-term-with-two-exponents": value([2, 0, 0]),
    "json--family-term-empty": value([]),
    "json--family-exponent-a-text": value([2, "a"]),
    "json--family-exponents-in-an-array": value([2, [0]]),
    "json--family-coefficient-of-a-field": value([[2, 0], 0]),
    "json--family-coefficient-over-q-in-a-field": value([2, 0, 0], base=ROOT),
    "json--family-tree-an-integer": tree(0),
    "json--family-tree-of-one": tree([0]),
    "json--family-tree-of-two": tree([0, []]),
    "json--family-tree-of-four": tree([0, [], [], []]),
    "json--family-half-an-integer": tree([0, [], 1]),
    "json--family-axis-an-array": tree([[], [], []]),
    "json--family-tree-an-object": tree({"axis": 0, "low": [], "high": []}),
    "json--family-bound-with-terms": edit(isosceles().certificate(), ("claim", "statements"), [
        "face-to-face tiling", ["squared radius-edge ratio", "less than", [[[1, 0]], 1]]]),
    "json--family-gram-of-another-shape": edit(ONE, GRAM, [[[[2, 0]], [[1, 0]]], [[[1, 0]], [[2, 0]]]]),
}

CANONICAL = {
    "canonical--family-members-in-another-order": edit(ONE, ("claim",), {
        key: ONE["claim"][key] for key in ("dimension", "parameters", "field", "gram", "domain", "statements")}),
    "canonical--family-tree-before-boundary": edit(ONE, ("witness",), {
        key: ONE["witness"][key] for key in ("denominator", "vertices", "tree", "boundary", "simplices")}),
    "canonical--family-ends-exchanged-in-the-text": edit(ONE, (*PARAMETERS, 0), {
        key: ONE["claim"]["parameters"][0][key] for key in ("name", "high", "low")}),
    "canonical--family-parameters-on-one-line": replaced(b'[\n{"name"', b'[{"name"'),
    "canonical--family-space-in-a-term": replaced(b"[[2,0],[1,1]]", b"[[2,0], [1,1]]"),
    "canonical--family-exponent-with-a-point": replaced(b"[[2,0],[1,1]]", b"[[2,0],[1,1.0]]"),
    "canonical--family-exponent-a-text": replaced(b"[[2,0],[1,1]]", b'[[2,0],[1,"1"]]'),
    "canonical--family-end-not-in-lowest-terms": ends([0, 1], [2, 2]),
    "canonical--family-end-zero-over-two": ends([0, 2], [1, 1]),
    "canonical--family-end-in-a-field-not-in-lowest-terms": parameter(base=ROOT, low=["closed", [[-6, 4], 4]]),
    "canonical--family-gram-with-a-common-divisor": edit(ONE, GRAM, [[[[4, 0]], [[2, 0]]], [[[4, 0], [2, 1]]]]),
    "canonical--family-vertices-with-a-common-divisor": edited(STRIP, (("witness", "denominator"), 2), ((*VERTICES, 1, 1), [[2, 1]])),
    "canonical--family-domain-with-a-common-divisor": edited(
        STRIP, ((*DOMAIN, 1, "denominator"), 3), ((*DOMAIN, 1, "vertices"), [[[]], [[[3, 1]]]])),
}

PARTS = {
    "parameters--none": edit(plane({"t": closed(0, 1)}, [[2, 1], [1, 2 + X]]).certificate(), PARAMETERS, []),
    "parameters--65": edit(ONE, PARAMETERS, [{"name": f"t{k}", "low": ["closed", [0, 1]], "high": ["closed", [1, 1]]} for k in range(65)]),
    "parameter-name--empty": parameter(name=""),
    "parameter-name--capital": parameter(name="T"),
    "parameter-name--digit-first": parameter(name="2t"),
    "parameter-name--underscore-first": parameter(name="_t"),
    "parameter-name--hyphen": parameter(name="a-b"),
    "parameter-name--space": parameter(name="a b"),
    "parameter-name--of-17": parameter(name="a" * 17),
    "parameter-name--twice": named("x", "x"),
    "box-exchanged--integers": ends([1, 1], [0, 1]),
    "box-exchanged--by-little": ends([1, 3], [33333, 100000]),
    "box-exchanged--in-a-field": parameter(base=ROOT, low=["closed", [[2, -1], 1]], high=["closed", [[-3, 2], 2]]),
    "box-exchanged--open": parameter(low=["open", [1, 1]], high=["open", [0, 1]]),
    "box-empty--closed": ends([1, 3], [1, 3]),
    "box-empty--open": parameter(low=["open", [0, 1]], high=["open", [0, 1]]),
    "box-empty--in-a-field": parameter(base=ROOT, high=["closed", [[-3, 2], 2]]),
    "denominator--family-end-zero": ends([0, 1], [1, 0]),
    "denominator--family-end-negative": ends([0, 1], [-1, -1]),
    "unused-parameter--first": edit(TWO, GRAM, [[[[2, 0, 0]], [[1, 0, 0]]], [[[2, 0, 0], [2, 0, 1]]]]),
    "unused-parameter--only-one": value([2, 0]),
    "statement-domain--family-plane": edit(ONE, ("claim", "statements"), [TILING, uncrossed((1, 0), 0)]),
    "exponent--16": value([2, 0], [1, 16]),
    "exponent--beyond-64-bits": value([2, 0], [1, 2 ** 64]),
    "exponent--negative": value([1, -1], [2, 0]),
    "exponent--in-a-vertex": edit(STRIP, (*VERTICES, 1, 1), [[1, 16]]),
    "exponent--in-the-domain": edit(STRIP, (*DOMAIN, 1, "vertices", 1, 0), [[1, 16]]),
    "terms--descending": value([1, 1], [2, 0]),
    "terms--of-two-parameters-in-another-order": value([1, 1, 0], [1, 0, 1], base=TWO),
    "terms--one-twice": value([2, 0], [1, 1], [1, 1]),
    "terms--zero-coefficient": value([2, 0], [1, 1], [0, 2]),
    "terms--zero-written": edit(ONE, (*VERTICES, 0, 0), [[0, 0]]),
    "terms--zero-coefficient-of-a-field": edit(ROOT, (*VERTICES, 0, 0), [[[0, 0], 0, 0]]),
    "tree--axis-of-no-parameter": tree([2, [], []]),
    "tree--axis-negative": tree([-1, [], []]),
    "tree--axis-of-no-parameter-in-a-leaf": tree([0, [1, [], [7, [], []]], []]),
    "tree--axis-beyond-64-bits": tree([2 ** 64, [], []]),
    "family-domain--region": edit(ONE, DOMAIN, ["region", 2]),
    "family-domain--region-with-boundary": edited(ONE, (DOMAIN, ["region", 0]), (BOUNDARY, MESH.certificate()["witness"]["boundary"])),
    "boundary-domain--family": edit(ONE, BOUNDARY, [[0, [0, 1, 0]]]),
    "denominator--family-witness-zero": edit(ONE, ("witness", "denominator"), 0),
    "no-simplices--family": edit(ONE, ("witness", "simplices"), []),
}

# Three parameters, of which the second is in a term with the exponent zero only.
PARTS["unused-parameter--exponent-zero"] = edit(
    plane({name: closed(0, 1) for name in "abc"}, [[1 + XYZ[0], XYZ[1] / 2], [XYZ[1] / 2, 1 + XYZ[2]]]).certificate(),
    (*GRAM, 0, 1), [[1, 0, 0, 0]])

MALFORMED_FAMILIES = {**JSON, **CANONICAL, **PARTS}
