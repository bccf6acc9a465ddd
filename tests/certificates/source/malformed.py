"""Files that are no certificates, or not in the canonical form."""
import json
from fractions import Fraction as F

from .build import TILING, edit, exchange_last, largest, uncrossed
from .encode import to_json
from .false_regions import MESH, VOID
from .regions import cells, periodic, region
from .tilings import CUBE, CUBE_CORNERS, CUBE_FACES, HEXAGONAL, SQUARE, a15, block, kuhn, lattice, square_triangle
from .wrong import BOUNDARY, DOMAIN, FIELD, GRAM, ROWS, STATEMENTS, VERTICES, edited, moved

E = lattice(HEXAGONAL).certificate("acute", "nonobtuse", "Delaunay")
BARE = lattice(HEXAGONAL).certificate()
BOUND = lattice(HEXAGONAL).certificate(largest("maximum", 1, F(1, 4)))
C6, K, A_TCP = kuhn(CUBE).certificate(), square_triangle().certificate(), a15().certificate("TCP")
STRIP, SLAB, PRISM, SOLID = (block(*dk).certificate() for dk in ((2, 1), (3, 1), (3, 2), (3, 3)))
REGION, ROD = MESH.certificate(), periodic((1,), (0, 0))
PLANE_REGION = region(*cells((0, 0), (1, 0)))
PERFORATED = periodic((2, 2, 2), *VOID)
DENOMINATOR = ("witness", "denominator")
BODY = (*DOMAIN, 1)


def replaced(base, old, new):
    before = to_json(base)
    assert before.count(old) >= 1, old
    return before.replace(old, new, 1)


def entry(raw):
    """The first entry of the Gram matrix is these bytes."""
    return replaced(BARE, b"[2,1]", b"[" + raw + b",1]")


def statements(*items):
    return edit(E, STATEMENTS, list(items))


def bound(*items):
    return edit(BOUND, (*STATEMENTS, 1), list(items))


def padded(base, n):
    """A certificate over Q as one over a field of degree n, without the field."""
    def number(x):
        return [x, *[0] * (n - 1)][:max(n, 0)]
    gram = [[number(x) for x in row] for row in base["claim"]["gram"]]
    vertices = [[number(x) for x in v] for v in base["witness"]["vertices"]]
    return edited(base, (GRAM, gram), (VERTICES, vertices))


def field(polynomial, low, high, denominator=1, n=None):
    root = {"low": low, "high": high, "denominator": denominator}
    return edit(padded(BARE, len(polynomial) - 1 if n is None else n), FIELD, {"polynomial": polynomial, "root": root})


def domain(base, **members):
    """Some members of the polytope replaced."""
    return edited(base, *(((*BODY, key), value) for key, value in members.items()))


def with_corner(base, row, i, corner):
    return edit(base, (*ROWS, row, i), corner)


def listed(tiling, *facets):
    """A region with these boundary facets after its own."""
    certificate = tiling.certificate()
    return edit(certificate, BOUNDARY, certificate["witness"]["boundary"] + list(facets))


def reversed_facet(tiling, i):
    return [list(c) if any(c[1:]) else c[0] for c in exchange_last(tiling.boundary()[i])]


# --- JSON --------------------------------------------------------------------------------

JSON = {
    "json--empty": b"",
    "json--truncated": to_json(E)[:200],
    "json--not-json": b"space is tiled\n",
    "json--bom": b"\xef\xbb\xbf" + to_json(E),
    "json--trailing-garbage": to_json(E) + b"{}\n",
    "json--not-utf-8": replaced(E, b"space", b"sp\xffce"),
    "json--nul-byte": replaced(E, b"space", b"sp\x00ce"),
    "json--text-beyond-ascii": replaced(E, b"acute", "acut\u00e9".encode()),
    "json--deep-nesting": b"[" * 20_000 + b"]" * 20_000,
    "json--deep-nesting-in-a-number": entry(b"[" * 5000 + b"]" * 5000),
    "json--unknown-member": edit(E, ("proof",), "trust me"),
    "json--unknown-member-of-claim": edit(E, ("claim", "verified"), 1),
    "json--unknown-member-of-witness": edit(E, ("witness", "note"), "x"),
    "json--unknown-member-of-domain": domain(SLAB, height=1),
    "json--unknown-member-of-field": edit(K, (*FIELD, "name"), "a"),
    "json--unknown-member-of-root": edit(K, (*FIELD, "root", "digits"), 3),
    "json--no-witness": edit(E, ("witness",), None),
    "json--no-kind": edit(E, ("kind",), None),
    "json--no-version": edit(E, ("version",), None),
    "json--no-boundary": edit(E, BOUNDARY, None),
    "json--no-denominator": edit(E, DENOMINATOR, None),
    "json--no-faces": domain(SLAB, faces=None),
    "json--no-root": edit(K, (*FIELD, "root"), None),
    "json--certificate-as-array": list(E.values()),
    "json--claim-as-array": edit(E, ("claim",), list(E["claim"].values())),
    "json--witness-as-array": edit(E, ("witness",), list(E["witness"].values())),
    "json--version-is-true": replaced(E, b'"version":2', b'"version":true'),
    "json--version-one-half": replaced(E, b'"version":2', b'"version":0.5'),
    "json--kind-is-null": replaced(E, b'"tiling"', b"null"),
    "json--format-is-a-number": edit(E, ("format",), 2),
    "json--dimension-as-word": edit(E, ("claim", "dimension"), "two"),
    "json--unknown-domain": edit(E, DOMAIN, "sphere"),
    "json--unknown-domain-with-polytope": edit(SLAB, (*DOMAIN, 0), "ball"),
    "json--unknown-field": edit(E, FIELD, "R"),
    "json--space-in-an-array": edit(E, DOMAIN, ["space"]),
    "json--slab-without-polytope": edit(SLAB, DOMAIN, "slab"),
    "json--slab-with-two-polytopes": edit(SLAB, DOMAIN, SLAB["claim"]["domain"] + [SLAB["claim"]["domain"][1]]),
    "json--space-with-polytope": edit(SLAB, (*DOMAIN, 0), "space"),
    "json--region-with-polytope": edit(SLAB, (*DOMAIN, 0), "region"),
    "json--region-without-rank": edit(REGION, DOMAIN, "region"),
    "json--domain-as-object": edit(SLAB, DOMAIN, {"slab": SLAB["claim"]["domain"][1]}),
    "json--face-as-number": edit(SLAB, (*BODY, "faces", 1), 1),
    "json--face-of-words": edit(SLAB, (*BODY, "faces", 1), ["top"]),
    "json--domain-vertex-long": edit(SLAB, (*BODY, "vertices", 1), [1, 0]),
    "json--domain-vertex-with-all-coordinates": domain(SLAB, vertices=[[0, 0, 0], [0, 0, 1]]),
    "json--domain-vertex-of-a-polygon": domain(SOLID, vertices=SQUARE[0]),
    "json--domain-vertex-empty": domain(SLAB, vertices=[[], []]),
    "json--gram-row-missing": edit(E, GRAM, [[2, 1]]),
    "json--gram-row-long": edit(E, GRAM, [[2, 1, 0], [2]]),
    "json--gram-full": edit(E, GRAM, HEXAGONAL),
    "json--gram-of-other-dimension": edit(E, ("claim", "dimension"), 3),
    "json--gram-empty": edit(E, GRAM, []),
    "json--statement-is-a-number": statements(TILING, 90),
    "json--bound-without-fraction": bound("largest dihedral angle", "maximum", 1),
    "json--bound-without-sign": bound("largest dihedral angle", "maximum", [1, 4]),
    "json--bound-with-sign-of-a-ratio": bound("squared radius-edge ratio", "maximum", 1, [1, 3]),
    "json--bound-with-a-number-for-a-fraction": bound("largest dihedral angle", "maximum", 0, 0),
    "json--bound-with-one-number": bound("largest dihedral angle", "maximum", 1, [1]),
    "json--bound-with-three-numbers": bound("largest dihedral angle", "maximum", 1, [1, 4, 1]),
    "json--bound-with-a-field-number": bound("largest dihedral angle", "maximum", 1, [[1], 4]),
    "json--bound-with-a-relation-of-numbers": bound("largest dihedral angle", 90, 1, [1, 4]),
    "json--vertex-short": edit(E, (*VERTICES, 0), [0]),
    "json--vertex-long": edit(E, (*VERTICES, 0), [0, 0, 0]),
    "json--coordinate-is-null": replaced(BARE, b"[0,0]", b"[0,null]"),
    "json--row-short": edit(E, (*ROWS, 1), E["witness"]["simplices"][1][:2]),
    "json--row-long": edit(E, (*ROWS, 1), [*E["witness"]["simplices"][1], [0, 2, 0]]),
    "json--row-with-a-hint": edit(C6, (*ROWS, 1), [*C6["witness"]["simplices"][1], 0]),
    "json--row-without-a-hint": edit(A_TCP, (*ROWS, 1), A_TCP["witness"]["simplices"][1][:4]),
    "json--row-empty": edit(E, (*ROWS, 0), []),
    "json--corner-short": with_corner(E, 0, 1, [0, 1]),
    "json--corner-long": with_corner(E, 0, 1, [0, 1, 0, 0]),
    "json--corner-empty": with_corner(E, 0, 1, []),
    "json--corner-is-a-word": with_corner(E, 0, 0, "origin"),
    "json--corner-with-a-shift-in-a-region": with_corner(REGION, 0, 1, [1, 1]),
    "json--corner-of-rank-3-in-a-slab": with_corner(SLAB, 0, 1, [0, 1, 0, 0]),
    "json--shift-is-a-fraction": replaced(E, b"[0,1,0]", b"[0,0.5,0]"),
    "json--facet-short": edit(REGION, (*BOUNDARY, 0), REGION["witness"]["boundary"][0][:2]),
    "json--facet-long": edit(REGION, (*BOUNDARY, 0), [0, 1, 2, 3]),
    "json--facet-long-in-the-plane": edit(PLANE_REGION.certificate(), (*BOUNDARY, 0), [0, 1, 2]),
    "json--field-number-over-q": edit(BARE, (*GRAM, 0, 0), [2]),
    "json--integer-over-a-field": edit(K, (*GRAM, 1, 0), 2),
    "json--one-coefficient": edit(K, (*GRAM, 1, 0), [2]),
    "json--three-coefficients": edit(K, (*GRAM, 1, 0), [2, 1, 0]),
    "json--coefficient-in-an-array": edit(K, (*GRAM, 1, 0), [2, [1]]),
    "json--number-empty": entry(b'""'),
    "json--number-fraction": entry(b'"2/1"'),
    "json--number-plus": entry(b'"+2"'),
    "json--number-minus-alone": entry(b'"-"'),
    "json--number-two-minus": entry(b'"--2"'),
    "json--number-leading-zero": entry(b'"02"'),
    "json--number-bare-leading-zero": entry(b"02"),
    "json--number-zero-as-text": entry(b'"0"'),
    "json--number-minus-zero-as-text": entry(b'"-0"'),
    "json--number-long-with-leading-zero": entry(b'"09007199254740993"'),
    "json--number-hexadecimal": entry(b'"0x2"'),
    "json--number-underscore": entry(b'"9_007_199_254_740_993"'),
    "json--number-exponent-as-text": entry(b'"2e0"'),
    "json--number-space": entry(b'" 9007199254740993"'),
    "json--number-line-feed": entry(b'"9007199254740993\\n"'),
    "json--number-arabic-digits": entry('"\u0662"'.encode()),
    "json--number-nan": entry(b"NaN"),
    "json--number-infinity": entry(b'"inf"'),
    "json--number-expression": entry(b'"sqrt(4)"'),
}

# --- canonical form ----------------------------------------------------------------------------

CANONICAL = {
    "canonical--crlf": to_json(E).replace(b"\n", b"\r\n"),
    "canonical--no-last-line-feed": to_json(E)[:-1],
    "canonical--two-last-line-feeds": to_json(E) + b"\n",
    "canonical--one-line": (json.dumps(E, separators=(",", ":")) + "\n").encode(),
    "canonical--indented": (json.dumps(E, indent=1) + "\n").encode(),
    "canonical--empty-array-on-two-lines": replaced(E, b'"boundary":[]', b'"boundary":[\n]'),
    "canonical--escaped-characters": replaced(E, b'"acute"', b'"\\u0061cute"'),
    "canonical--space": replaced(E, b'"version":2', b'"version": 2'),
    "canonical--duplicate-key": replaced(E, b'"version":2,', b'"version":2,\n"version":2,'),
    "canonical--duplicate-claim-key": replaced(E, b'"dimension":2,', b'"dimension":2,\n"dimension":2,'),
    "canonical--members-in-other-order": {k: E[k] for k in ("version", "format", "kind", "claim", "witness")},
    "canonical--claim-after-witness": {k: E[k] for k in ("format", "version", "kind", "witness", "claim")},
    "canonical--faces-before-vertices":
        edit(SLAB, BODY, {k: SLAB["claim"]["domain"][1][k] for k in ("denominator", "faces", "vertices")}),
    "canonical--high-before-low": edit(K, (*FIELD, "root"), {"high": 2, "low": 1, "denominator": 1}),
    "canonical--small-number-as-text": entry(b'"2"'),
    "canonical--small-number-of-53-bits-as-text": entry(b'"9007199254740991"'),
    "canonical--large-number-bare": entry(b"9007199254740992"),
    "canonical--large-negative-number-bare": replaced(BARE, b"[0,0]", b"[-9007199254740992,0]"),
    "canonical--number-with-point": entry(b"2.0"),
    "canonical--minus-zero": replaced(BARE, b"[0,0]", b"[-0,0]"),
    "canonical--shift-zero": with_corner(E, 0, 0, [0, 0, 0]),
    "canonical--shift-zero-of-another-vertex": with_corner(A_TCP, 20, 1, [2, 0, 0, 0]),
    "canonical--shift-zero-in-a-facet": edit(ROD.certificate(), (*BOUNDARY, 0, 0), [0, 0]),
    "canonical--corner-in-an-array-without-lattice": with_corner(REGION, 0, 0, [0]),
    "canonical--gram-not-primitive": edit(E, GRAM, [[4, 2], [4]]),
    "canonical--gram-not-primitive-over-a-field":
        edit(K, GRAM, [[[2 * c for c in x] for x in row] for row in K["claim"]["gram"]]),
    "canonical--denominator-not-least": edit(BARE, DENOMINATOR, 2),
    "canonical--denominator-not-least-of-a15": edited(a15().certificate(), (DENOMINATOR, 12), (
        VERTICES, [[3 * x for x in v] for v in a15().certificate()["witness"]["vertices"]])),
    "canonical--denominator-of-the-domain-not-least":
        domain(moved(block(3, 1), [F(1, 2), 0, 0]).certificate(), denominator=2, vertices=[[0], [2]]),
    "canonical--root-not-in-lowest-terms": edit(K, (*FIELD, "root"), {"low": 2, "high": 4, "denominator": 2}),
    "canonical--bound-not-in-lowest-terms": bound("largest dihedral angle", "maximum", 1, [2, 8]),
    "canonical--bound-zero-not-in-lowest-terms": bound("largest dihedral angle", "at most", 0, [0, 2]),
    "canonical--ratio-not-in-lowest-terms": bound("squared radius-edge ratio", "at most", [2, 4]),
    "canonical--bound-over-a-field-not-in-lowest-terms":
        edit(K, STATEMENTS, [TILING, ["largest dihedral angle", "less than", -1, [[2, 0], 8]]]),
}

# --- claims --------------------------------------------------------------------------------------

THREE_ROOTS = [1, -3, 0, 1]
ANGLE, OTHER_ANGLE, RATIO_OF = "largest dihedral angle", "smallest dihedral angle", "squared radius-edge ratio"
AT_MOST_90 = [ANGLE, "at most", 0, [0, 1]]

CLAIMS = {
    "format--other": edit(E, ("format",), "acutile-tiling"),
    "format--long": edit(E, ("format",), "acutile-certificate" * 3),
    "format--empty": edit(E, ("format",), ""),
    "dimension--1": edit(E, ("claim", "dimension"), 1),
    "dimension--0": edit(E, ("claim", "dimension"), 0),
    "dimension--4": edit(E, ("claim", "dimension"), 4),
    "dimension--negative": edit(E, ("claim", "dimension"), -2),
    "dimension--huge": edit(E, ("claim", "dimension"), 2 ** 63),
    "dimension--2-to-64-and-2": edit(E, ("claim", "dimension"), 2 ** 64 + 2),
    "polynomial--empty": field([], 1, 2),
    "polynomial--constant": field([1], 1, 2),
    "polynomial--linear": field([-1, 1], 0, 2),
    "polynomial--not-monic": field([-3, 0, 2], 1, 2),
    "polynomial--minus-one": field([3, 0, -1], 1, 2),
    "polynomial--leading-zero": field([-3, 0, 1, 0], 1, 2),
    "root-order--equal": field([-3, 0, 1], 1, 1),
    "root-order--reversed": field([-3, 0, 1], 2, 1),
    "root-order--denominator-zero": field([-3, 0, 1], 1, 2, 0),
    "root-order--denominator-negative": field([-3, 0, 1], -2, -1, -1),
    "root-derivative--three-roots": field(THREE_ROOTS, -2, 2),
    "root-derivative--one-root-but-wide": field([-3, 0, 1], -1, 2),
    "root-derivative--triple-root": field([-1, 3, -3, 1], 0, 3),
    "root-derivative--monotone-but-zero-at-an-end": field([-3, 0, 1], 0, 2),
    "prism-dimension--square": edit(block(2, 2).certificate(), (*DOMAIN, 0), "prism"),
    "region-rank--negative": edit(REGION, (*DOMAIN, 1), -1),
    "region-rank--3-in-the-plane": edit(PLANE_REGION.certificate(), (*DOMAIN, 1), 3),
    "region-rank--4-in-space": edit(REGION, (*DOMAIN, 1), 4),
    "region-rank--huge": edit(REGION, (*DOMAIN, 1), 2 ** 70),
    "denominator--zero": edit(BARE, DENOMINATOR, 0),
    "denominator--negative": edit(BARE, DENOMINATOR, -1),
    "denominator--of-the-domain-zero": domain(SLAB, denominator=0),
    "denominator--of-the-domain-negative": domain(SLAB, denominator=-1),
    "face-count--none": domain(SOLID, vertices=[], faces=[]),
    "face-count--half-space": domain(SLAB, vertices=[[0]], faces=[[0]]),
    "face-count--solid-with-three": domain(SOLID, faces=CUBE_FACES[:3]),
    "face-count--square-with-two": domain(PRISM, faces=SQUARE[1][:2]),
    "face-length--slab": domain(SLAB, faces=[[0], [1, 0]]),
    "face-length--empty": domain(SLAB, faces=[[0], []]),
    "face-length--side-with-one": domain(PRISM, faces=[[0, 1], [1, 2], [2, 3], [3]]),
    "face-length--side-with-three": domain(PRISM, faces=[[0, 1], [1, 2], [2, 3, 0], [3, 0]]),
    "face-length--solid-with-sides": domain(SOLID, faces=[*CUBE_FACES, [0, 1]]),
    "face-vertices--range": domain(SLAB, faces=[[0], [2]]),
    "face-vertices--negative": domain(SLAB, faces=[[0], [-1]]),
    "face-vertices--huge": domain(SLAB, faces=[[0], [2 ** 64 - 1]]),
    "face-vertices--twice": domain(SOLID, faces=[[0, 1, 3, 2, 0], *CUBE_FACES[1:]]),
    "face-vertices--side-of-one": domain(PRISM, faces=[[0, 0], [1, 2], [2, 3], [3, 0]]),
    "face-repeated--slab": domain(SLAB, vertices=[[0]], faces=[[0], [0]]),
    "face-repeated--side-reversed": domain(PRISM, faces=[*SQUARE[1], [1, 0]]),
    "face-repeated--two-opposite-faces-doubled": domain(SOLID, faces=CUBE_FACES[:2] + [face[::-1] for face in CUBE_FACES[:2]]),
    "unused-domain-vertex--far": domain(SOLID, vertices=[*CUBE_CORNERS, [9, 9, 9]]),
    "unused-domain-vertex--inner": domain(SLAB, vertices=[[0], [1], [0]]),
    "statements--none": statements(),
    "statements--no-tiling": statements("acute"),
    "statements--tiling-second": statements("acute", TILING),
    "statements--repeated": statements(TILING, "acute", "acute"),
    "statements--tiling-twice": statements(TILING, TILING),
    "statements--order": statements(TILING, "Delaunay", "acute"),
    "statements--unknown": statements(TILING, "beautiful"),
    "statements--of-format-1": bound("all dihedral angles below", "at most", 0, [0, 1]),
    "statements--unknown-relation": bound(ANGLE, "below", 1, [1, 4]),
    "statements--bound-as-text": statements(TILING, ANGLE),
    "statements--text-as-bound": statements(TILING, ["acute", "at most", 0, [0, 1]]),
    "statements--two-of-one-relation": statements(TILING, AT_MOST_90, [ANGLE, "at most", -1, [1, 4]]),
    "statements--bound-twice": statements(TILING, AT_MOST_90, AT_MOST_90),
    "statements--relations-in-other-order": statements(TILING, [ANGLE, "maximum", 1, [1, 4]], AT_MOST_90),
    "statements--quantities-in-other-order": statements(TILING, [OTHER_ANGLE, "at most", 0, [0, 1]], AT_MOST_90),
    "statements--bound-before-acute": statements(TILING, AT_MOST_90, "acute"),
    "statements--ratio-after-delaunay": statements(TILING, "Delaunay", [RATIO_OF, "at most", [1, 1]]),
    "statements--tcp-before-delaunay": edit(A_TCP, STATEMENTS, [TILING, "TCP", "Delaunay"]),
    "statements--not-delaunay-before-delaunay": edit(REGION, STATEMENTS, [TILING, "not Delaunay", "locally Delaunay"]),
    "statements--local-before-global": edit(REGION, STATEMENTS, [TILING, "locally weakly Delaunay", "locally Delaunay"]),
    "bound-range--sign-2": bound(ANGLE, "at most", 2, [1, 4]),
    "bound-range--sign-minus-2": bound(ANGLE, "at most", -2, [1, 4]),
    "bound-range--sign-0-of-a-square": bound(ANGLE, "at most", 0, [1, 4]),
    "bound-range--sign-1-of-zero": bound(ANGLE, "at most", 1, [0, 1]),
    "bound-range--sign-minus-1-of-zero": bound(ANGLE, "at most", -1, [0, 1]),
    "bound-range--square-above-1": bound(ANGLE, "less than", -1, [5, 4]),
    "bound-range--square-negative": bound(ANGLE, "less than", -1, [-1, 4]),
    "bound-range--denominator-zero": bound(ANGLE, "at most", 1, [1, 0]),
    "bound-range--denominator-negative": bound(ANGLE, "at most", 1, [-1, -4]),
    "bound-range--of-the-smallest-angle": bound(OTHER_ANGLE, "more than", 1, [4, 3]),
    "bound-range--ratio-zero": bound(RATIO_OF, "at most", [0, 1]),
    "bound-range--ratio-negative": bound(RATIO_OF, "more than", [-1, 3]),
    "bound-range--ratio-with-denominator-negative": bound(RATIO_OF, "at most", [-1, -3]),
    "statements--plane-as-text": statements(TILING, "uncrossed plane"),
    "statements--plane-twice": statements(TILING, uncrossed((1, 0), 0), uncrossed((1, 0), 0)),
    "statements--planes-in-other-order": statements(TILING, uncrossed((1, 0), 0), uncrossed((0, 1), 0)),
    "statements--plane-after-delaunay": statements(TILING, "Delaunay", uncrossed((1, 0), 0)),
    "bound-range--plane-denominator-zero": statements(TILING, uncrossed((1, 0), 1, 0)),
    "bound-range--plane-denominator-negative": statements(TILING, uncrossed((1, 0), -1, -2)),
    "bound-range--plane-entry-of-30-bits": statements(TILING, uncrossed((1, 2 ** 29), 0)),
    "canonical--plane-without-normal": statements(TILING, uncrossed((0, 0), 0)),
    "canonical--plane-with-divisor": statements(TILING, uncrossed((2, 2), 1)),
    "canonical--plane-negated": statements(TILING, uncrossed((0, -1), 0)),
    "canonical--plane-offset": statements(TILING, uncrossed((1, 0), 2, 2)),
    "json--plane-with-a-fourth-part": statements(TILING, [*uncrossed((1, 0), 0), 0]),
    "json--plane-of-three-coordinates": statements(TILING, uncrossed((1, 0, 0), 0)),
    # The square (1 + sqrt 3) / 2 is 1.36; (1 - sqrt 3) / 2 is negative.
    "bound-range--above-1-over-sqrt-3": edit(K, STATEMENTS, [TILING, [ANGLE, "less than", -1, [[1, 1], 2]]]),
    "bound-range--negative-over-sqrt-3": edit(K, STATEMENTS, [TILING, [ANGLE, "less than", -1, [[1, -1], 2]]]),
    "bound-range--ratio-negative-over-sqrt-3": edit(K, STATEMENTS, [TILING, [RATIO_OF, "more than", [[1, -1], 2]]]),
    "statement-domain--tcp-in-the-plane": edited(BARE, (STATEMENTS, [TILING, "TCP"]), *(
        ((*ROWS, i), [*row, 0]) for i, row in enumerate(BARE["witness"]["simplices"]))),
    "statement-domain--tcp-in-a-slab": block(3, 1).certificate("TCP"),
    "statement-domain--tcp-in-a-solid": block(3, 3).certificate("TCP"),
    "statement-domain--tcp-in-a-region": MESH.certificate("TCP"),
    "statement-domain--tcp-in-a-region-of-rank-3": PERFORATED.certificate("TCP"),
    "statement-domain--delaunay-in-a-region": MESH.certificate("Delaunay"),
    "statement-domain--weakly-delaunay-in-a-region": MESH.certificate("nonobtuse", "weakly Delaunay"),
    "statement-domain--delaunay-in-a-region-of-rank-3": PERFORATED.certificate("weakly Delaunay"),
    "statement-domain--locally-delaunay-in-space": lattice(HEXAGONAL).certificate("locally Delaunay"),
    "statement-domain--locally-weakly-delaunay-in-a-slab": block(3, 1).certificate("locally weakly Delaunay"),
}

# --- witnesses -------------------------------------------------------------------------------------

WITNESSES = {
    "boundary-domain--facet-in-the-plane": edit(E, BOUNDARY, [[0, [0, 1, 0]]]),
    "boundary-domain--facet-in-a-slab": edit(SLAB, BOUNDARY, [[0, [0, 0, 1], [0, 1, 1]]]),
    "boundary-domain--facet-in-a-solid": edit(SOLID, BOUNDARY, [[0, 1, 3]]),
    "boundary-domain--none-in-a-region": edit(REGION, BOUNDARY, []),
    "boundary-domain--none-in-a-region-of-rank-2": edit(PERFORATED.certificate(), BOUNDARY, []),
    "boundary-domain--whole-plane-as-a-region": edit(BARE, DOMAIN, ["region", 2]),
    "no-simplices--none": edited(BARE, (ROWS, []), (VERTICES, [])),
    "no-simplices--with-vertex": edit(BARE, ROWS, []),
    "no-simplices--solid": edit(SOLID, ROWS, []),
    "vertex-range--one-too-far": with_corner(E, 0, 1, [1, 1, 0]),
    "vertex-range--negative": with_corner(E, 0, 1, [-1, 1, 0]),
    "vertex-range--2-to-32": with_corner(E, 0, 1, [2 ** 32, 1, 0]),
    "vertex-range--beyond-64-bits": with_corner(E, 0, 1, [2 ** 64, 1, 0]),
    "vertex-range--first-corner": with_corner(E, 0, 0, -1),
    "vertex-range--no-vertices": edit(BARE, VERTICES, []),
    "vertex-range--in-a-facet": edit(REGION, (*BOUNDARY, 0, 2), 8),
    "vertex-range--in-the-first-corner-of-a-facet": edit(REGION, (*BOUNDARY, 3, 0), -1),
    "shift-range--2-to-29": with_corner(E, 0, 1, [0, 2 ** 29, 0]),
    "shift-range--minus-2-to-29": with_corner(E, 0, 2, [0, 1, -2 ** 29]),
    "shift-range--2-to-32": with_corner(E, 0, 1, [0, 2 ** 32 + 1, 0]),
    "shift-range--beyond-64-bits": with_corner(E, 0, 1, [0, 2 ** 64 + 1, 0]),
    "shift-range--in-a-facet": edit(ROD.certificate(), (*BOUNDARY, 0, 1), [0, 2 ** 29]),
    "corner-order--not-sorted": with_corner(E, 0, 1, [0, -1, 0]),
    "corner-order--corner-twice": with_corner(E, 0, 2, E["witness"]["simplices"][0][1]),
    "corner-order--first-corner-twice": with_corner(E, 0, 1, 0),
    "corner-order--first-corner-shifted": edit(E, (*ROWS, 0), [[0, 1, 0], [0, 2, 0], [0, 1, 1]]),
    "corner-order--last-corner-too-small": with_corner(E, 0, 2, [0, 0, -1]),
    "corner-order--second-and-third-exchanged":
        edit(C6, (*ROWS, 0), [C6["witness"]["simplices"][0][i] for i in (0, 2, 1, 3)]),
    "corner-order--second-after-fourth":
        edit(C6, (*ROWS, 0), [C6["witness"]["simplices"][0][i] for i in (0, 3, 2, 1)]),
    "corner-order--last-two-equal": with_corner(C6, 0, 3, C6["witness"]["simplices"][0][2]),
    "corner-order--second-and-fourth-equal": with_corner(C6, 0, 3, C6["witness"]["simplices"][0][1]),
    "corner-order--last-row": edit(REGION, (*ROWS, 5), [REGION["witness"]["simplices"][5][i] for i in (1, 0, 2, 3)]),
    "corner-order--facet-not-sorted": edit(REGION, (*BOUNDARY, 2), [REGION["witness"]["boundary"][2][i] for i in (1, 2, 0)]),
    "corner-order--facet-last-corner-too-small": edit(REGION, (*BOUNDARY, 2), [1, 2, 0]),
    "corner-order--facet-last-two-equal": edit(REGION, (*BOUNDARY, 2, 2), REGION["witness"]["boundary"][2][1]),
    "corner-order--facet-first-corner-twice": edit(REGION, (*BOUNDARY, 2, 1), REGION["witness"]["boundary"][2][0]),
    "corner-order--facet-of-one-corner-in-the-plane":
        edit(PLANE_REGION.certificate(), (*BOUNDARY, 2, 1), PLANE_REGION.certificate()["witness"]["boundary"][2][0]),
    "corner-order--facet-first-corner-shifted": edit(ROD.certificate(), (*BOUNDARY, 0), [[0, 1], [0, 2]]),
    "sixes--64": edit(A_TCP, (*ROWS, 0, 4), 64),
    "sixes--negative": edit(A_TCP, (*ROWS, 0, 4), -1),
    "sixes--beyond-64-bits": edit(A_TCP, (*ROWS, 0, 4), 2 ** 64),
    "boundary-repeated--twice": listed(MESH, MESH.certificate()["witness"]["boundary"][3]),
    "boundary-repeated--reversed": listed(MESH, reversed_facet(MESH, 3)),
    "boundary-repeated--reversed-in-the-plane": listed(PLANE_REGION, reversed_facet(PLANE_REGION, 0)),
    "boundary-repeated--reversed-of-rank-1": listed(ROD, reversed_facet(ROD, 0)),
    "boundary-repeated--twice-of-rank-3": listed(PERFORATED, PERFORATED.certificate()["witness"]["boundary"][0]),
    "unused-vertex--plane": edited(BARE, (VERTICES, [[0, 0], [1, 1]]), (DENOMINATOR, 2)),
    "unused-vertex--a15": edit(A_TCP, VERTICES, [*A_TCP["witness"]["vertices"], [1, 1, 1]]),
    "unused-vertex--region": edit(REGION, VERTICES, [*REGION["witness"]["vertices"], [5, 5, 5]]),
    "unused-vertex--at-a-used-place": edit(REGION, VERTICES, [*REGION["witness"]["vertices"], [0, 0, 0]]),
}

MALFORMED = {**JSON, **CANONICAL, **CLAIMS, **WITNESSES}
