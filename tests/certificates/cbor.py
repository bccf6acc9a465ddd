#!/usr/bin/env python3
"""Encodes certificates, and writes the files of the folder `cbor`; needs Python 3 alone.

usage: cbor.py                  writes the folder, from the folder `valid`
       cbor.py F.json F.cbor    encodes one certificate

The encoder, source/encode.py, shares no code with the program. `valid--NAME.cbor` is the certificate
NAME; any other name begins with the code of its refusal.
"""
import copy
import json
import os
import sys

from source.encode import Raw, to_cbor

HERE = os.path.dirname(os.path.abspath(__file__))
VALID = ["plane-equilateral-acute", "plane-cubic-field", "plane-square-triangle", "plane-every-relation", "space-a15-tcp", "slab-bcc",
         "prism-cube-6", "solid-octahedron", "region-cavity", "region-rank-3-void", "region-integers-at-limits",
         "region-integers-at-limits-below", "plane-field-of-degree-8", "family-plane-acute-triangles", "family-plane-rows-over-sqrt-3",
         "family-plane-lopsided-tree", "patches-prisms-of-bcc-with-offsets", "patches-slabs-of-two-heights"]


def arrays(value):
    """Objects as the arrays of their values: the structure of CBOR."""
    if isinstance(value, dict):
        value = list(value.values())
    return [arrays(item) for item in value] if isinstance(value, list) else value


def valid(name):
    with open(os.path.join(HERE, "valid", name + ".json")) as file:
        return arrays(json.load(file))


GOOD, BIG, REGION = valid("plane-equilateral-acute"), valid("region-integers-at-limits"), valid("region-cube-6")
A_FIELD, SLAB = valid("plane-cubic-field"), valid("slab-bcc")
BYTES = to_cbor(GOOD)
FORMAT, VERSION, KIND, CLAIM, WITNESS = range(5)
DIMENSION, FIELD, GRAM, DOMAIN, STATEMENTS = ((CLAIM, i) for i in range(5))
DENOMINATOR, VERTICES, BOUNDARY, ROWS = ((WITNESS, i) for i in range(4))
HUGE = b"\x7f" + b"\xff" * 7


def put(value, *path, base=GOOD):
    """The certificate with one item replaced; `path` is a path, with more indices behind it."""
    outer = [*(path[0] if isinstance(path[0], tuple) else path[:1]), *path[1:]]
    certificate = copy.deepcopy(base)
    at = certificate
    for index in outer[:-1]:
        at = at[index]
    at[outer[-1]] = value
    return to_cbor(certificate)


def item(path, base=GOOD):
    for index in path:
        base = base[index]
    return to_cbor(base)


def raw(data, *path, base=GOOD):
    return put(Raw(data), *path, base=base)


def without(index, outer=()):
    certificate = copy.deepcopy(GOOD)
    at = certificate
    for i in outer:
        at = at[i]
    del at[index]
    return to_cbor(certificate)


def with_more(value, *outer):
    certificate = copy.deepcopy(GOOD)
    at = certificate
    for i in outer:
        at = at[i]
    at.append(value)
    return to_cbor(certificate)


CANONICAL = {
    "version-in-two-bytes": raw(b"\x18\x02", VERSION),
    "version-in-three-bytes": raw(b"\x19\x00\x02", VERSION),
    "version-in-nine-bytes": raw(b"\x1b" + b"\0" * 7 + b"\x02", VERSION),
    "shift-in-two-bytes": raw(b"\x38\x00", ROWS, 1, 1, 2),
    "vertex-index-in-five-bytes": raw(b"\x1a\0\0\0\0", ROWS, 0, 0),
    "length-of-text-in-two-bytes": raw(b"\x78\x05space", DOMAIN),
    "length-of-array-in-two-bytes": raw(b"\x98\x02" + item(ROWS)[1:], ROWS),
    "length-of-row-in-two-bytes": raw(b"\x98\x03" + item((*ROWS, 1))[1:], ROWS, 1),
    "length-of-certificate-in-two-bytes": b"\x98\x05" + BYTES[1:],
    "coordinate-of-32-bits-in-nine-bytes": raw(b"\x1b\0\0\0\0\xff\xff\xff\xff", VERTICES, 0, 0),
    "shift-zero-in-an-array": put([0, 0, 0], ROWS, 0, 0),
    "gram-not-primitive": put([[4, 2], [4]], GRAM),
    "denominator-not-least": put(2, DENOMINATOR),
    # Big integers: tag 2 or 3 and at least nine bytes, the first one not zero.
    "big-integer-for-zero": raw(b"\xc2\x40", VERTICES, 0, 0),
    "big-integer-of-one-byte": raw(b"\xc2\x41\x01", VERTICES, 0, 0),
    "big-integer-of-eight-bytes": raw(b"\xc2\x48" + b"\xff" * 8, VERTICES, 0, 0),
    "big-integer-of-eight-bytes-negative": raw(b"\xc3\x48" + b"\xff" * 8, VERTICES, 0, 0),
    "big-integer-with-a-leading-zero": raw(b"\xc2\x49\0" + b"\xff" * 8, VERTICES, 0, 0),
    "big-integer-with-a-leading-zero-of-eleven-bytes": raw(b"\xc2\x4b\0" + b"\xff" * 10, VERTICES, 0, 0),
    "big-integer-with-a-leading-zero-negative": raw(b"\xc3\x4a\0" + b"\xff" * 9, VERTICES, 0, 0),
    "big-integer-whose-length-is-in-two-bytes": raw(b"\xc2\x58\x09\x01" + b"\0" * 8, VERTICES, 0, 0),
    "shift-is-a-short-big-integer": raw(b"\xc2\x41\x01", ROWS, 0, 1, 1),
}

NOT_CBOR = {
    "empty": b"",
    "tagged": b"\xd9\xd9\xf7" + BYTES,
    "in-an-array": to_cbor([GOOD]),
    "empty-array": b"\x80",
    "a-map": b"\xa5" + b"".join(to_cbor(key) + to_cbor(value) for key, value in
                                zip(("format", "version", "kind", "claim", "witness"), GOOD)),
    "byte-after-the-end": BYTES + b"\x00",
    "twice": BYTES + BYTES,
    "line-feed-after-the-end": BYTES + b"\n",
    "last-byte-missing": BYTES[:-1],
    "half": BYTES[:len(BYTES) // 2],
    "first-byte-alone": BYTES[:1],
    "indefinite-certificate": b"\x9f" + BYTES[1:] + b"\xff",
    "indefinite-rows": raw(b"\x9f" + item(ROWS)[1:] + b"\xff", ROWS),
    "indefinite-row": raw(b"\x9f" + item((*ROWS, 1))[1:] + b"\xff", ROWS, 1),
    "indefinite-text": raw(b"\x7f\x65space\xff", DOMAIN),
    "indefinite-integer": raw(b"\x1f", VERTICES, 0, 0),
    "break": raw(b"\xff", VERTICES, 0, 0),
    "one-row-more-announced": raw(b"\x83" + item(ROWS)[1:], ROWS),
    "one-row-less-announced": raw(b"\x81" + item(ROWS)[1:], ROWS),
    "claim-missing": without(CLAIM),
    "kind-missing": without(KIND),
    "witness-missing": without(WITNESS),
    "gram-missing": without(2, (CLAIM,)),
    "boundary-missing": without(2, (WITNESS,)),
    "item-after-the-witness": with_more(0),
    "item-in-the-claim": with_more("no", CLAIM),
    "item-in-the-witness": with_more([], WITNESS),
    "format-is-an-integer": put(1, FORMAT),
    "version-is-a-text": put("two", VERSION),
    "version-is-a-float": raw(b"\xf9\x40\x00", VERSION),
    "kind-is-an-array": put(["tiling"], KIND),
    "witness-is-a-text": put("witness", WITNESS),
    "claim-is-a-text": put("claim", CLAIM),
    "dimension-is-a-text": put("two", DIMENSION),
    "field-is-another-text": put("R", FIELD),
    "field-without-root": put([[-3, 0, 1]], FIELD),
    "root-of-two-integers": put([0, 1], (*FIELD, 1), base=A_FIELD),
    "domain-is-another-text": put("sphere", DOMAIN),
    "domain-is-an-integer": put(0, DOMAIN),
    "slab-without-polytope": put(["slab"], DOMAIN, base=SLAB),
    "region-of-a-text": put(["region", "three"], DOMAIN, base=REGION),
    "rows-are-a-map": raw(b"\xa0", ROWS),
    "row-is-an-integer": put(0, ROWS, 1),
    "row-without-a-corner": put([0, [0, 0, 1]], ROWS, 0),
    "row-with-a-corner-more": put([0, [0, 0, 1], [0, 1, 0], [0, 1, 1]], ROWS, 0),
    "corner-is-a-text": put("origin", ROWS, 0, 0),
    "corner-is-null": raw(b"\xf6", ROWS, 0, 0),
    "corner-with-a-shift-too-long": put([0, 0, 1, 0], ROWS, 0, 1),
    "shift-is-a-text": put("one", ROWS, 0, 1, 2),
    "shift-is-a-float": raw(b"\xf9\x00\x00", ROWS, 0, 1, 2),
    "coordinate-is-an-array": put([0], VERTICES, 0, 0),
    "coordinate-is-bytes": raw(b"\x410", VERTICES, 0, 0),
    "coordinate-is-a-float-of-64-bits": raw(b"\xfb" + b"\0" * 8, VERTICES, 0, 0),
    "coordinate-of-a-field-is-an-integer": put(0, VERTICES, 0, 0, base=A_FIELD),
    "coefficient-missing": put([2, 0], GRAM, 0, 0, base=A_FIELD),
    "digits-as-a-text": raw(b"\x6218", VERTICES, 0, 0),
    "text-is-not-utf-8": raw(b"\x61\xff", DOMAIN),
    "text-beyond-ascii": raw(b"\x66spac\xc3\xa9", DOMAIN),
    "text-with-a-line-feed": raw(b"\x66space\n", DOMAIN),
    "simple-value": raw(b"\xf5", DOMAIN),
    "reserved-head": raw(b"\x1c", DIMENSION),
    "big-integer-with-another-tag": raw(b"\xc4\x49\x01" + b"\0" * 8, VERTICES, 0, 0),
    "big-integer-of-a-text": raw(b"\xc2\x69" + b"1" * 9, VERTICES, 0, 0),
    "big-integer-of-an-integer": raw(b"\xc2\x01", VERTICES, 0, 0),
    "big-integer-of-indefinite-length": raw(b"\xc2\x5f\x49\x01" + b"\0" * 8 + b"\xff", VERTICES, 0, 0),
    "big-integer-cut": put(2 ** 64, WITNESS)[:-4],
    "tag-alone": raw(b"\xc2", WITNESS),
    "huge-text": raw(b"\x7b" + HUGE, DOMAIN),
    "many-rows-announced": raw(b"\x9a\x08\0\0\0", ROWS),
    "huge-row": raw(b"\x9b" + HUGE, ROWS, 0),
    "huge-corner": raw(b"\x9b" + HUGE, ROWS, 0, 1),
    "huge-boundary": raw(b"\x9b" + HUGE, BOUNDARY, base=REGION),
    "huge-gram": raw(b"\x9b" + HUGE, GRAM),
    "huge-certificate": b"\x9b" + HUGE + BYTES[1:],
    "huge-map": b"\xbb" + HUGE + BYTES[1:],
    "deep-domain": raw(b"\x81" * 20 + b"\x00", DOMAIN),
    "very-deep-domain": raw(b"\x81" * 200000 + b"\x00", DOMAIN),
    "very-deep-coordinate": raw(b"\x81" * 200000 + b"\x00", VERTICES, 0, 0),
}

# CBOR of a certificate, and something is wrong with it: as in JSON.
OTHERS = {
    "format--other": put("another", FORMAT),
    "version--1": put(1, VERSION),
    "version--3": put(3, VERSION),
    "version--negative": put(-2, VERSION),
    "version--3-and-another-shape": to_cbor([*GOOD[:1], 3, "tiling", ["cells"], [1]]),
    "kind--mosaic": put("mosaic", KIND),
    "vertex-range--beyond": put(1, ROWS, 0, 0),
    "vertex-range--least-integer": put(-2 ** 63, ROWS, 0, 0),
    "vertex-range--of-65-bits-negative": put(-2 ** 64, ROWS, 0, 0),
    "vertex-range--big-integer": put(2 ** 64, ROWS, 0, 0),
    "shift-range--2-to-29": put(2 ** 29, ROWS, 0, 1, 1),
    "shift-range--2-to-31": put(2 ** 31, ROWS, 0, 1, 1),
    "shift-range--2-to-63": put(2 ** 63, ROWS, 0, 1, 1),
    "shift-range--big-integer": put(2 ** 64, ROWS, 0, 1, 1),
    "corner-order--second-corner-too-small": put([0, -1, 0], ROWS, 0, 1),
    "no-simplices--none": put([], ROWS),
    "polynomial--empty": put([], (*FIELD, 0), base=A_FIELD),
    "boundary-domain--of-the-plane": put([[0, [0, 1, 0]]], BOUNDARY),
    "too-many-digits--of-600-bytes": put(2 ** 4799, VERTICES, 0, 0),
}

FILES = {**{f"valid--{name}": to_cbor(valid(name)) for name in VALID},
         **{f"canonical--{name}": data for name, data in CANONICAL.items()},
         **{f"cbor--{name}": data for name, data in NOT_CBOR.items()}, **OTHERS}


def write_folder():
    folder = os.path.join(HERE, "cbor")
    os.makedirs(folder, exist_ok=True)
    for name in os.listdir(folder):
        os.remove(os.path.join(folder, name))
    for name, content in FILES.items():
        with open(os.path.join(folder, name + ".cbor"), "wb") as file:
            file.write(content)


def encode_file(source, target):
    with open(source) as file:
        data = to_cbor(json.load(file))
    with open(target, "wb") as file:
        file.write(data)


if __name__ == "__main__":
    if len(sys.argv) == 3:
        encode_file(*sys.argv[1:])
    else:
        write_folder()
