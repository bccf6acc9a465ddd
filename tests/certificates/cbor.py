#!/usr/bin/env python3
"""Writes the files of the folder `cbor`; needs Python 3 alone and shares no code with the program.

An encoder of RFC 8949, section 4.2.1, in twenty lines, applied to certificates of the folder `valid`,
and what must be refused, bytes by hand. `valid--NAME.cbor` is the certificate NAME; any other name
begins with the code of its refusal.
"""
import json, os

HERE = os.path.dirname(os.path.abspath(__file__))


def head(major, n):
    for info, size in ((24, 1), (25, 2), (26, 4), (27, 8)):
        if n < 24:
            return bytes([major << 5 | n])
        if n < 256 ** size:
            return bytes([major << 5 | info]) + n.to_bytes(size, "big")
    raise OverflowError


class Raw(bytes):
    """An item that is encoded already."""


class Members(list):
    """A map as pairs, in this order."""


def encode(x):
    if isinstance(x, Raw):
        return bytes(x)
    if isinstance(x, Members):
        return head(5, len(x)) + b"".join(encode(k) + encode(v) for k, v in x)
    if isinstance(x, dict):
        return encode(Members(sorted(x.items(), key=lambda member: encode(member[0]))))
    if isinstance(x, list):
        return head(4, len(x)) + b"".join(map(encode, x))
    if isinstance(x, str):
        return head(3, len(x.encode())) + x.encode()
    return head(0, x) if x >= 0 else head(1, -1 - x)


def valid(name):
    with open(os.path.join(HERE, "valid", name + ".json")) as file:
        return json.load(file)


VALID = ["plane-equilateral-acute", "plane-cubic-field", "plane-square-triangle", "space-a15-tcp", "slab-bcc", "prism-cube-6",
         "solid-octahedron", "region-cavity"]


def changed(change, name="plane-equilateral-acute"):
    certificate = valid(name)
    change(certificate)
    return encode(certificate)


def put(value, *path):
    """The certificate with one item replaced."""
    def change(certificate):
        *outer, last = path
        for key in outer:
            certificate = certificate[key]
        certificate[last] = value
    return changed(change)


def ordered(certificate, *keys):
    return Members((key, certificate[key]) for key in keys)


GOOD = valid("plane-equilateral-acute")
BYTES = encode(GOOD)
CLAIM, WITNESS = GOOD["claim"], GOOD["witness"]
DEEP = Raw(b"\x81" * 20 + b"\x00")
VERY_DEEP = Raw(b"\x81" * 200000 + b"\x00")

FILES = {f"valid--{name}": encode(valid(name)) for name in VALID} | {
    # Another encoding of the same data.
    "canonical--version-in-two-bytes": put(Raw(b"\x18\x01"), "version"),
    "canonical--version-in-three-bytes": put(Raw(b"\x19\x00\x01"), "version"),
    "canonical--version-in-nine-bytes": put(Raw(b"\x1b" + b"\0" * 7 + b"\x01"), "version"),
    "canonical--shift-in-two-bytes": put(Raw(b"\x38\x00"), "witness", "mates", 0, 1, 2),
    "canonical--vertex-index-in-five-bytes": put(Raw(b"\x1a\0\0\0\0"), "witness", "simplices", 0, 0, 0),
    "canonical--length-of-text-in-two-bytes": put(Raw(b"\x78\x05" + b"space"), "claim", "domain"),
    "canonical--length-of-array-in-two-bytes": put(Raw(b"\x98\x02" + encode(WITNESS["mates"])[1:]), "witness", "mates"),
    "canonical--length-of-map-in-two-bytes": b"\xb8\x04" + BYTES[1:],
    "canonical--indefinite-map": b"\xbf" + BYTES[1:] + b"\xff",
    "canonical--indefinite-array": put(Raw(b"\x9f" + encode(WITNESS["simplices"])[1:] + b"\xff"), "witness", "simplices"),
    "canonical--indefinite-row": put(Raw(b"\x9f" + encode(WITNESS["simplices"][1])[1:] + b"\xff"), "witness", "simplices", 1),
    "canonical--indefinite-text": put(Raw(b"\x7f\x65space\xff"), "claim", "domain"),
    "canonical--members-as-in-json": encode(ordered(GOOD, "format", "version", "claim", "witness")),
    "canonical--version-behind-witness": encode(ordered(GOOD, "claim", "format", "witness", "version")),
    "canonical--witness-as-in-json": put(ordered(WITNESS, "vertices", "simplices", "mates"), "witness"),
    "canonical--claim-as-in-json": put(ordered(CLAIM, "dimension", "field", "gram", "domain", "statements"), "claim"),
    "canonical--coefficient-in-an-array": put(["0"], "witness", "vertices", 0, 0),
    "canonical--entry-of-gram-in-an-array": put(["2"], "claim", "gram", 0, 0),
    # Not CBOR of a certificate.
    "json--empty": b"",
    "json--tagged": b"\xd9\xd9\xf7" + BYTES,
    "json--array": encode([GOOD]),
    "cbor--empty-map": b"\xa0",
    "cbor--byte-behind": BYTES + b"\x00",
    "cbor--twice": BYTES + BYTES,
    "cbor--line-feed-behind": BYTES + b"\n",
    "cbor--last-byte-missing": BYTES[:-1],
    "cbor--one-row-more-announced": put(Raw(b"\x83" + encode(WITNESS["simplices"])[1:]), "witness", "simplices"),
    "cbor--one-row-less-announced": put(Raw(b"\x81" + encode(WITNESS["simplices"])[1:]), "witness", "simplices"),
    "cbor--key-twice": b"\xa5" + BYTES[1:BYTES.index(b"\x66format")] + 2 * (encode("format") + encode(GOOD["format"])) +
                       BYTES[BYTES.index(b"\x67version"):],
    "cbor--key-of-witness-twice": put(Members([("mates", WITNESS["mates"])] + list(ordered(WITNESS, "mates", "vertices", "simplices"))), "witness"),
    "cbor--key-of-claim-twice": put(Members([("gram", CLAIM["gram"])] + list(ordered(CLAIM, "gram", "field", "domain", "dimension", "statements"))), "claim"),
    "cbor--key-is-an-integer": encode(Members([(1, 2)] + list(ordered(GOOD, "claim", "format", "version", "witness")))),
    "cbor--member-unknown": changed(lambda c: c.update(comment="no")),
    "cbor--member-of-claim-unknown": changed(lambda c: c["claim"].update(name="no")),
    "cbor--member-of-witness-unknown": changed(lambda c: c["witness"].update(name="no")),
    "cbor--claim-missing": changed(lambda c: c.pop("claim")),
    "cbor--witness-missing": changed(lambda c: c.pop("witness")),
    "cbor--format-missing": changed(lambda c: c.pop("format")),
    "cbor--version-missing": changed(lambda c: c.pop("version")),
    "cbor--mates-missing": changed(lambda c: c["witness"].pop("mates")),
    "cbor--gram-missing": changed(lambda c: c["claim"].pop("gram")),
    "cbor--format-is-an-integer": put(1, "format"),
    "cbor--version-is-a-text": put("1", "version"),
    "cbor--version-negative": put(-1, "version"),
    "cbor--version-is-a-float": put(Raw(b"\xf9\x3c\x00"), "version"),
    "cbor--witness-is-an-array": put([[], [], []], "witness"),
    "cbor--claim-is-a-text": put("claim", "claim"),
    "cbor--dimension-is-a-text": put("2", "claim", "dimension"),
    "cbor--dimension-negative": put(-2, "claim", "dimension"),
    "cbor--table-is-a-map": put({}, "witness", "mates"),
    "cbor--row-is-an-integer": put(0, "witness", "mates", 1),
    "cbor--mate-is-an-integer": put(0, "witness", "mates", 1, 2),
    "cbor--shift-is-a-text": put("0", "witness", "mates", 1, 2, 3),
    "cbor--shift-is-a-float": put(Raw(b"\xf9\x00\x00"), "witness", "mates", 1, 2, 3),
    "cbor--shift-is-a-big-number": put(Raw(b"\xc2\x49\x01" + b"\0" * 8), "witness", "mates", 1, 2, 3),
    "cbor--shift-of-65-bits": put(Raw(b"\x1b\x80" + b"\0" * 7), "witness", "mates", 1, 2, 3),
    "cbor--shift-of-65-bits-negative": put(Raw(b"\x3b\xff" + b"\xff" * 7), "witness", "mates", 1, 2, 3),
    "cbor--corner-is-null": put(Raw(b"\xf6"), "witness", "simplices", 0, 0),
    "cbor--coordinate-is-an-integer": put(0, "witness", "vertices", 0, 0),
    "cbor--coordinate-is-bytes": put(Raw(b"\x410"), "witness", "vertices", 0, 0),
    "cbor--coefficient-is-an-array": put([["0"], "1"], "witness", "vertices", 0, 0),
    "cbor--text-is-not-utf-8": put(Raw(b"\x61\xff"), "witness", "vertices", 0, 0),
    "cbor--text-is-a-surrogate": put(Raw(b"\x63\xed\xa0\x80"), "witness", "vertices", 0, 0),
    "cbor--simple-value": put(Raw(b"\xf5"), "claim", "domain"),
    "cbor--reserved-head": put(Raw(b"\x1c"), "claim", "dimension"),
    "cbor--huge-text": put(Raw(b"\x7b\x7f" + b"\xff" * 7), "claim", "domain"),
    "cbor--huge-coordinate": put(Raw(b"\x7b\xff" + b"\xff" * 7), "witness", "vertices", 0, 0),
    "cbor--huge-array": put(Raw(b"\x9b\xff" + b"\xff" * 7), "witness", "simplices"),
    "cbor--huge-row": put(Raw(b"\x9b\xff" + b"\xff" * 7), "witness", "simplices", 0),
    "cbor--huge-mate": put(Raw(b"\x9b\xff" + b"\xff" * 7), "witness", "mates", 0, 0),
    "cbor--huge-map": b"\xbb" + b"\xff" * 8 + BYTES[1:],
    "cbor--huge-gram": put(Raw(b"\x9b\xff" + b"\xff" * 7), "claim", "gram"),
    "cbor--deep-claim": put(DEEP, "claim", "domain"),
    "cbor--very-deep-claim": put(VERY_DEEP, "claim", "domain"),
    "cbor--very-deep-in-another-version": changed(lambda c: c.update(version=2, witness=VERY_DEEP)),
    "cbor--cut-in-another-version": put(2, "version")[:-1],
    "format--other": put("another", "format"),
    "version--2": changed(lambda c: c.update(version=2, witness={"cells": [], "and": 1})),
    # CBOR of a certificate, and something is wrong with it: as in JSON.
    "vertex-range--beyond": put(1, "witness", "simplices", 0, 0, 0),
    "vertex-range--least-integer": put(-2 ** 63, "witness", "simplices", 0, 0, 0),
    "shift-range--2-to-31": put(2 ** 31, "witness", "simplices", 0, 0, 1),
    "mate-shift-range--minus-2-to-31": put(-2 ** 31, "witness", "mates", 0, 0, 2),
    "mate-range--one-beyond": put(2, "witness", "mates", 0, 0, 0),
    "mates-length--one-less": changed(lambda c: c["witness"]["mates"].pop()),
    "simplex-length--none": put([], "witness", "simplices", 0),
    "no-simplices--none": changed(lambda c: c["witness"].update(simplices=[], mates=[])),
    "coefficients--none": put([], "witness", "vertices", 0, 0),
    # Facets that the front must not confuse.
    "mate-not-mutual--closed-twice": put([0, 0, 0, 0], "witness", "mates", 1, 2),
    "mate-not-mutual--opened-and-never-closed": put([1, 1, 1, 0], "witness", "mates", 0, 0),
    "mate-not-mutual--two-for-one": put([1, 1, 0, 0], "witness", "mates", 0, 1),
    "mate-not-mutual--of-itself-moved": put([0, 0, 1, 0], "witness", "mates", 0, 0),
    "mate-not-mutual--back-to-a-facet-that-went-elsewhere": put([0, 1, 0, 0], "witness", "mates", 1, 0),
    "mate-not-mutual--of-itself": put([0, 0, 0, 0], "witness", "mates", 0, 0),
    "mate-side--both-of-themselves": changed(lambda c: (c["witness"]["mates"][0].__setitem__(0, [0, 0, 0, 0]),
                                                        c["witness"]["mates"][1].__setitem__(1, [1, 1, 0, 0]))),
}


if __name__ == "__main__":
    folder = os.path.join(HERE, "cbor")
    os.makedirs(folder, exist_ok=True)
    for name in os.listdir(folder):
        os.remove(os.path.join(folder, name))
    for name, content in FILES.items():
        with open(os.path.join(folder, name + ".cbor"), "wb") as file:
            file.write(content)
