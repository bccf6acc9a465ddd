"""python3 tests/bundle/certificates.py ACUTILE_VERIFY [MUTATIONS [all]]: tests of verifiers/python/verify.py.

Functions against hand calculations; signs on boxes (signs.py); the certificates of tests/certificates, whose names state the code; and
acutile-verify on certificates in CBOR that are changed at random. With `all` also certificates/.
"""

import copy
import importlib.util
import random
import re
import subprocess
import sys
import tempfile
from itertools import product
from pathlib import Path

ROOT = Path(__file__).parents[2]
sys.dont_write_bytecode = True
spec = importlib.util.spec_from_file_location("verify", ROOT / "verifiers/python/verify.py")
verify = importlib.util.module_from_spec(spec)
spec.loader.exec_module(verify)

sys.path.insert(0, str(Path(__file__).parent))
from signs import check_signs_on_boxes  # noqa: E402

# It has no other limits than those of its docstring.
WITHOUT_LIMIT = {"too-many-bytes", "too-many-simplices", "work"}
EXIT_CODES = {"verified": 0, "rejected": 1, "malformed": 2, "declined": 3}
WORDS = {"verified": "accepted", "rejected": "refused", "malformed": "refused", "declined": "declined"}


def answer(line):
    """Verdict, code and digest of a line that a verifier prints about a file."""
    found = re.search(r": (verified|rejected|malformed|declined)(?: \[([a-z-]+)\])?", line)
    assert found, line
    digest = re.search("sha256 ([0-9a-f]{64})", line)
    return found[1], found[2], digest and digest[1]


def said(path):
    """Verdict and code; nothing but these ever leaves verify.py."""
    line, code = verify.verdict(path)
    verdict, reason, _ = answer(f": {line}")
    assert code == EXIT_CODES[verdict], path
    return verdict, reason


def files(folder, ending="json"):
    found = sorted((ROOT / folder).glob(f"*.{ending}"))
    assert found, folder
    return found


# Hand calculations.


def check_integers():
    """RFC 8949, appendix A."""
    examples = {0: "00", 23: "17", 24: "1818", 255: "18ff", 1000: "1903e8", 1000000: "1a000f4240", -1: "20", -1000: "3903e7",
                2 ** 64 - 1: "1bffffffffffffffff", 2 ** 64: "c249010000000000000000", -2 ** 64: "3bffffffffffffffff",
                -2 ** 64 - 1: "c349010000000000000000"}
    for value, expected in examples.items():
        assert verify.cbor(value).hex() == expected, value
        assert verify.read_cbor(bytes.fromhex(expected)) == value, value
    assert verify.cbor([1, [2, 3], "IETF"]).hex() == "830182020364" + b"IETF".hex()
    for wrong, code in {"1817": "canonical", "190018": "canonical", "c2480100000000000000": "canonical", "c24100": "canonical",
                        "c249000100000000000000": "canonical", "9f01ff": "cbor", "f6": "cbor", "f90000": "cbor", "a0": "cbor",
                        "0000": "cbor", "8201": "cbor", "41ff": "cbor", "c48201": "cbor", "63e282ac": "cbor", "1c": "cbor"}.items():
        try:
            verify.read_cbor(bytes.fromhex(wrong))
        except verify.Refusal as refusal:
            assert (refusal.kind, refusal.code) == ("malformed", code), wrong
        else:
            raise AssertionError(wrong)


def check_signs():
    """Convergents of √2 lie on alternate sides: 3/2, 7/5, 577/408, 1393/985."""
    record = verify.Record([[-2, 0, 1], verify.Record([1, 2, 1])])
    field = verify.Field(verify.Record([verify.Record(record[0]), record[1]]))
    for p, q, expected in [(0, 0, 0), (3, -2, 1), (7, -5, -1), (577, -408, 1), (1393, -985, -1), (-1, 0, -1), (0, 1, 1)]:
        assert verify.sign(verify.Element(field, [p, q])) == expected, (p, q)
    square = verify.Element(field, [1, 3]) * verify.Element(field, [-2, 1])
    assert square.coefficients == [4, -5]  # (1 + 3√2)(-2 + √2) = 4 - 5√2


class Space:
    """Corners are points, without a lattice."""

    def position(self, corner):
        return list(corner)

    @staticmethod
    def product(x, y):
        return verify.dot(x, y)


def check_meeting():
    """Hulls of corners, by inspection."""
    a, b, c = (0, 0, 0), (4, 0, 0), (0, 4, 0)
    cases = [
        ([a, b, c], [(1, 1, -1), (1, 1, 1), (1, 2, 1)], False),  # an edge through the inside
        ([a, b, c], [(1, 1, 1), (2, 1, 1), (1, 2, 2)], True),    # above
        ([a, b, c], [(1, 1, 0), (9, 9, 0), (9, 9, 1)], False),   # a corner in the inside
        ([a, b, c], [(2, 2, 0), (9, 9, 0), (9, 9, 1)], False),   # a corner on an edge
        ([a, b, c], [(3, 3, 0), (9, 9, 0), (9, 9, 1)], True),    # beyond the edge, in the plane
        ([a, b, c], [a, b, (0, -1, 0)], True),                   # two common corners, other sides
        ([a, b, c], [a, b, (1, 1, 0)], False),                   # folded
        ([a, b, c], [a, b, (1, 1, 1)], True),
        ([a, b, c], [a, (-1, 0, 0), (0, -1, 0)], True),          # one common corner
        ([a, b, c], [a, (1, 1, 0), (0, 0, 1)], False),
        ([a, b, c], [a, (1, 1, 1), (1, 1, -1)], False),
        ([a, b], [(1, 0, 0), (1, 1, 0)], False),                 # segments
        ([a, b], [(5, 0, 0), (9, 0, 0)], True),
        ([a, b], [a, (1, 0, 0)], False),
        ([a, b], [a, (-1, 0, 0)], True),
    ]
    for f, g, expected in cases:
        for one, other in product((f, f[::-1]), (g, g[::-1])):
            assert verify.meet_in_shared(Space(), one, other) == expected, (one, other)
            assert verify.meet_in_shared(Space(), other, one) == expected, (other, one)


def compared(quantity):
    """-1, 0 or 1: whether a quantity is less than its bound, equal or more."""
    less, more = (getattr(quantity, way)(verify.positive_in) for way in ("less", "more"))
    if not less and not more:
        assert quantity.less(verify.nonnegative_in) and quantity.more(verify.nonnegative_in)
    return bool(more) - bool(less)


def ratio(shape, bound):
    """R² over the square of the shortest edge, beside a bound."""
    return max(compared(verify.Ratio(shape, edge, bound)) for edge in shape.squared_edges())


def check_shapes():
    """The corner of a cube and the regular tetrahedron with edges √2."""
    corner = verify.Shape(Space(), [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)])
    # Its circumsphere has the centre (1/2, 1/2, 1/2) and R² = 3/4; det M = 1.
    assert [corner.power(Space(), list(w)) for w in [(1, 1, 1), (2, 0, 0), (0, 0, 0), (1, 0, -1)]] == [0, 2, 0, 2]
    assert ratio(corner, (3, 4)) == 0 and ratio(corner, (2, 3)) == 1
    regular = verify.Shape(Space(), [(0, 0, 0), (1, 1, 0), (1, 0, 1), (0, 1, 1)])
    assert ratio(regular, (3, 8)) == 0 and ratio(regular, (1, 2)) == -1
    g = regular.gradients()
    # Every dihedral angle is arccos 1/3.
    angles = {(1, (1, 9)): 0, (1, (1, 10)): -1, (1, (1, 8)): 1, (0, (0, 1)): -1, (-1, (1, 9)): -1}
    for (side, bound), expected in angles.items():
        assert {compared(verify.Angle(g, i, j, side, bound)) for i, j in [(0, 1), (2, 3), (1, 3)]} == {expected}, (side, bound)


def check_names():
    assert verify.shown("a/b.json") == "a/b.json"
    assert verify.shown("a\nb: verified: ") == '"a\\nb: verified: "'


# Certificates.


def check_known():
    for folder, verdict in {"valid": "verified", "false": "rejected", "malformed": "malformed", "declined": "declined"}.items():
        for path in files(f"tests/certificates/{folder}"):
            code = path.stem.split("--")[0] if verdict != "verified" else None
            is_other = code in WITHOUT_LIMIT or re.search("--(limit|max)-", path.stem)
            assert is_other or said(path) == (verdict, code), (path, said(path))
            check_encodings(path)
    for path in files("tests/certificates/cbor", "cbor"):
        code = path.stem.split("--")[0]
        # Where the first byte is not that of an array in CBOR, the file is read as JSON.
        found = said(path)[1]
        assert found == (None if code == "valid" else code) or (found, code) == ("json", "cbor"), (path, found)


def check_encodings(path):
    """CBOR gives the values of the JSON, and the verifier sees nothing else. So it gives the same answer in both encodings."""
    try:
        tree = verify.read_json(path.read_bytes())
    except verify.Refusal:
        return
    assert verify.read_cbor(verify.cbor(tree)) == values(tree), path


def values(tree):
    """A tree with the list of its values in place of each object."""
    return [values(item) for item in (tree.values() if isinstance(tree, dict) else tree)] if isinstance(tree, (list, dict)) else tree


def places(data, at=()):
    """Every place of a tree."""
    yield at
    for n, value in enumerate(data if isinstance(data, list) else []):
        yield from places(value, at + (n,))


def changed(data, chance):
    data = copy.deepcopy(data)
    at = chance.choice([place for place in places(data) if place])
    parent = data
    for key in at[:-1]:
        parent = parent[key]
    old = parent[at[-1]]
    odd = [-1, 10 ** 30, -2 ** 64, 2 ** 64, 2 ** 63, 24, "x", "Delaunay", "space", [], [[]], ["region", 3], [1, 1], 2 ** 5000]
    if type(old) is int and chance.random() < 0.8:
        parent[at[-1]] = old + chance.choice([-2, -1, 1, 2])
    elif chance.random() < 0.5:
        other = chance.randrange(len(parent))
        parent[at[-1]], parent[other] = parent[other], parent[at[-1]]
    elif chance.random() < 0.3:
        parent.insert(at[-1], copy.deepcopy(old))
    elif chance.random() < 0.3:
        del parent[at[-1]]
    else:
        parent[at[-1]] = chance.choice(odd)
    return data


def mutated(content, chance):
    """Another certificate in CBOR, or other bytes."""
    if chance.random() < 0.8:
        return verify.cbor(changed(verify.read_cbor(content), chance))
    content = bytearray(content)
    at = chance.randrange(len(content))
    choice = chance.randrange(4)
    if choice == 0:
        content[at] ^= 1 << chance.randrange(8)
    elif choice == 1:
        del content[at]
    elif choice == 2:
        content.insert(at, chance.choice([0, 0x18, 0x80, 0x9f, 0xc2, 0xf6, 0xff]))
    else:
        del content[at:]
    return bytes(content)


def check_mutations(program, count, seed):
    chance = random.Random(seed)
    originals = [verify.cbor(verify.read_json(path.read_bytes())) for path in files("tests/certificates/valid") if path.stat().st_size < 4000]
    tally = {}
    with tempfile.TemporaryDirectory() as folder:
        paths = [Path(folder) / f"{n}.cbor" for n in range(count)]
        for path in paths:
            path.write_bytes(mutated(chance.choice(originals), chance))
        lines = subprocess.run([program, *paths], capture_output=True, text=True).stdout.splitlines()
        assert len(lines) == count, lines[:3]
        for path, line in zip(paths, lines):
            there, code, digest = answer(line)
            here = answer(f": {verify.verdict(path)[0]}")
            tally[there, here[0]] = tally.get((there, here[0]), 0) + 1
            words = {WORDS[there], WORDS[here[0]]}
            assert len(words) == 1 or "declined" in words, (line, here, path.read_bytes())
            assert words != {"accepted"} or digest == here[2], (line, here)
    assert tally.get(("rejected", "rejected"), 0) > count // 10, tally
    print(f"{count} mutations, (acutile-verify, verify.py): {tally}")


def main(program, count="400", *rest):
    for check in (check_integers, check_signs, check_meeting, check_shapes, check_names, check_known):
        check()
    check_signs_on_boxes(verify, 150)
    check_mutations(program, int(count), 1)
    for path in files("certificates") if "all" in rest else []:
        assert said(path) == ("verified", None), path
        check_encodings(path)
    print("verify.py agrees")


if __name__ == "__main__":
    main(*sys.argv[1:])
