#!/usr/bin/env python3
"""The schemas of input files accept what the program writes and the documents show, and refuse what has another shape.

Usage: schemas.py ACUTILE. Needs the package jsonschema. Exits with 1 where a file is judged wrongly.
"""
import copy
import json
import re
import subprocess
import sys
from pathlib import Path

from jsonschema import Draft202012Validator

ROOT = Path(__file__).parents[1]
SCHEMAS = {
    "acutile-tiling": "tiling.schema.json",
    "acutile-points": "tiling.schema.json",
    "acutile-plane-tiling": "plane-tiling.schema.json",
}


def parsed(text):
    """JSON without comment lines."""
    return json.loads("\n".join(line for line in text.splitlines() if not line.lstrip().startswith("//")))


def documents(acutile):
    """Name and value of each input file that is shown or written."""
    for path in sorted((ROOT / "src/cli/examples").glob("*.json")):
        yield path.name, parsed(path.read_text())
    blocks = re.findall(r"```json\n(.*?)```", (ROOT / "docs/format.md").read_text(), re.DOTALL)
    for number, block in enumerate(blocks):
        if re.search(r'"format": "acutile-(tiling|points|plane-tiling)"', block):
            yield f"format.md, block {number}", parsed(block)
    for name in ("a15", "slab", "bcc", "cube-6", "two-corners"):
        text = subprocess.run([acutile, "export", name], check=True, capture_output=True, text=True).stdout
        yield f"export {name}", parsed(text)


def spoiled(value):
    """Each with one thing of another shape."""
    for member in ("format", "version"):
        yield {key: inner for key, inner in value.items() if key != member}
    yield {**value, "colour": "red"}
    yield {**value, "version": 2}
    for member in ("vertices", "points", "simplices"):
        if member in value:
            yield {**value, member: {}}
            yield {key: inner for key, inner in value.items() if key != member}
    if "dimension" in value:
        yield {**value, "dimension": 4}
        yield {**value, "domain": "slab"}
    if "simplices" in value:
        other = copy.deepcopy(value)
        other["simplices"][0][0] = -1
        yield other


def main():
    validators = {}
    for kind, name in SCHEMAS.items():
        schema = json.loads((ROOT / "docs" / name).read_bytes())
        Draft202012Validator.check_schema(schema)
        validators[kind] = Draft202012Validator(schema)
    accepted, refused, wrong = 0, 0, []
    for name, value in documents(sys.argv[1]):
        validator = validators[value["format"]]
        error = next(validator.iter_errors(value), None)
        accepted += 1
        if error:
            wrong.append(f"{name}: {error.message[:200]}")
        for other in spoiled(value):
            refused += 1
            if validator.is_valid(other):
                wrong.append(f"{name}: accepted, though spoiled: {json.dumps(other)[:200]}")
    print(f"schemas: {accepted} files accepted, {refused} refused, {len(wrong)} wrongly", *wrong, sep="\n")
    return 1 if wrong or accepted < 15 or refused < 80 else 0


if __name__ == "__main__":
    sys.exit(main())
