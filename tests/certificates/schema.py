#!/usr/bin/env python3
"""docs/certificate.schema.json accepts what has the shape, and refuses what has not, as far as a schema can tell.

Needs the package jsonschema. Prints how many files were accepted and refused; exits with 1 where one is judged wrongly.
"""
import json
import sys
from pathlib import Path

from jsonschema import Draft202012Validator

HERE = Path(__file__).parent
# What a schema over parsed JSON cannot express: bytes, arithmetic, and references from one member to another.
BEYOND_A_SCHEMA = (
    "boundary-repeated--", "shift-range--patches-fan", "tile-count--patches-without-a-patch", "bound-range--", "box-empty--", "box-exchanged--", "parameter-name--twice", "parameter-name--that-of-the-generator", "terms--", "tree--axis-of-no-parameter",
    "pyramid--apex-in-the-polygon", "tile-count--one-", "unused-parameter--", "canonical--", "corner-order--", "face-repeated--side-reversed",
    "face-repeated--two-opposite-faces-doubled", "face-vertices--range", "polynomial--leading-zero", "polynomial--minus-one",
    "polynomial--not-monic", "root-derivative--", "root-order--", "statements--bound-before-acute",
    "statements--local-before-global", "statements--not-delaunay-before-delaunay", "statements--order", "statements--plane-after-delaunay", "statements--planes-in-other-order",
    "json--plane-of-three-coordinates", "statement-domain--family-plane", "statement-domain--patches-plane", "statements--quantities-in-other-order",
    "statements--ratio-after-delaunay", "statements--relations-in-other-order", "statements--tcp-before-delaunay",
    "statements--two-of-one-relation", "unused-domain-vertex--", "unused-vertex--", "vertex-range--",
)
LEAST = {"accepted": 350, "refused": 150}


def values(folder):
    """The files that are JSON at all: name and value."""
    for path in sorted((HERE / folder).glob("*.json")):
        try:
            yield path.stem, json.loads(path.read_bytes().decode())
        except (ValueError, RecursionError):
            pass


def expectations():
    """Name, value, and whether the schema accepts it."""
    for folder in ("valid", "false"):
        yield from ((f"{folder}/{name}", value, True) for name, value in values(folder))
    for name, value in values("malformed"):
        if not name.startswith(BEYOND_A_SCHEMA):
            yield f"malformed/{name}", value, False
    for name, value in values("declined"):
        if name.startswith("version--"):
            yield f"declined/{name}", value, False


def main():
    schema = json.loads((HERE.parents[1] / "docs/certificate.schema.json").read_bytes())
    Draft202012Validator.check_schema(schema)
    validator = Draft202012Validator(schema)
    counts, wrong = {"accepted": 0, "refused": 0}, 0
    for name, value, expected in expectations():
        error = next(iter(validator.iter_errors(value)), None)
        counts["refused" if error else "accepted"] += 1
        if (error is None) != expected:
            wrong += 1
            print(f"{name}: {'accepted' if error is None else error.message[:200]}")
    print(f"schema: {counts['accepted']} files accepted, {counts['refused']} refused, {wrong} wrongly")
    sys.exit(1 if wrong or any(counts[key] < least for key, least in LEAST.items()) else 0)


if __name__ == "__main__":
    main()
