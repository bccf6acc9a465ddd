#!/usr/bin/env python3
"""The schemas of input files and of answers accept what the program writes and the documents show, and refuse what
has another shape.

Usage: schemas.py ACUTILE. Needs the package jsonschema. Exits with 1 where a file is judged wrongly.
"""
import copy
import json
import re
import subprocess
import sys
import tempfile
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


VALID = "tests/certificates/valid"
MESHES = "tests/meshes/cases"

# Arguments with the exit code. Each is run with --json; OUT is a new folder for each.
RUNS = [
    ("list", 0),
    ("show a15", 0),
    ("show square-triangle-all", 0),
    ("show OUT/box.json", 0),
    ("show equilateral", 0),
    ("new slab -o OUT/slab.json", 0),
    ("new cif", 0),
    ("certify bcc cube-6 no-such-name --require acute", 1),
    ("certify a15 -o OUT/a15.cbor --report OUT/a15.html", 0),
    ("certify a15 -o -", 0),
    ("certify a15 --no-certificate", 0),
    ("certify OUT/box.json", 0),
    (f"certify {MESHES}/two_pieces.msh {MESHES}/folded.msh --defects OUT/defects.vtu", 1),
    (f"certify {MESHES}/curved10.vtu {MESHES}/cube.mesh --fills {MESHES}/cube.stl", None),
    (f"certify {MESHES}/interface_duplicated_nodes.msh --allow-contact", None),
    ("certify --require blunt a15", 2),
    ("certify a15 -o OUT/a15.pdf", 2),
    (f"verify {VALID}/space-bcc.json tests/certificates/false/not-acute--cube-6.json", 1),
    ("verify tests/certificates/declined/version--3.json README.md no-such-file", 2),
    ("delaunay tests/cif/bcc.cif --special -o OUT/bcc.json", 0),
    ("delaunay tests/cif/bcc.cif --special", 0),
    ("export a15 --supercell 2,1,1 -o OUT/a15.json", 0),
    (f"export --coq {VALID}/space-bcc.json", 0),
    ("convert a15 OUT/a15.vtu --round", 0),
    (f"convert {MESHES}/cube.mesh OUT/cube.node", 0),
    (f"convert {VALID}/space-bcc.json OUT/bcc.cbor", 0),
    ("table bcc equilateral square-triangle-all no-such-name", 2),
    ("paper", 0),
    ("lower-bound", 0),
    ("optimize c14 --steps 3", 0),
    ("optimize c15 --symmetry none --prove-local", 0),
    ("optimize cube-6 --symmetry list", 0),
    ("optimize square", 2),
    ("records", 0),
    ("search slab --tries 8 -o OUT/best.cbor", None),
    ("search balls --size 1 --steps 1 --seconds 20", None),
    ("quality a15", 0),
    ("quality equilateral", 0),
    (f"quality {MESHES}/folded.msh --below 30", 0),
    ("quality a15 -o OUT/q.json", 0),
    ("gallery -o README.md", 2),
    ("report a15 cube-6 -o OUT/page.html", 0),
    (f"report {MESHES}/folded.msh tests/certificates/false/not-acute--cube-6.json -o OUT/page.html", 1),
    ("draw slab --figure steps", 0),
    ("draw a15 --standalone", 2),
    ("classify z", 0),
    ("classify equilateral", 0),
    ("classify tests/cif/diamond.cif --special", 0),
    (f"classify {MESHES}/soup.msh", 1),
    ("appendix a15 cube-6 -o OUT/appendix", 0),
    ("bundle a15 --no-pdf -o OUT/a15.zip", 0),
    ("bundle no-such-name -o OUT/a15.zip", 2),
    ("cite a15 -o OUT/a15.bib", 0),
    ("completions bash", 0),
    ("man OUT", 0),
    ("frobnicate", 2),
]

BOX = """{"format": "acutile-tiling", "version": 1, "dimension": 2, "parameters": {"t": ["1/3", "1/2"]},
"lattice": {"gram": [[1, "t"], ["t", 1]]}, "vertices": [[0, 0]], "simplices": [[0, [0, 1, 0], [0, 0, 1]],
[[0, 1, 1], [0, 0, 1], [0, 1, 0]]]}"""


def answers(acutile, run, expected):
    """The answers of a run: the lines of standard output, or of standard error if that has the document, and of
    files that begin as an answer does."""
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "box.json").write_text(BOX)
        arguments = run.replace("OUT", folder).split()
        done = subprocess.run([acutile, *arguments, "--json"], cwd=ROOT, capture_output=True, text=True)
        lines = done.stdout.splitlines() + done.stderr.splitlines()
        for path in Path(folder).glob("q.json"):
            lines += path.read_text().splitlines()
    found = [json.loads(line) for line in lines if line.startswith("{") and '"acutile-answer"' in line]
    if expected is not None and done.returncode != expected:
        raise SystemExit(f"{run}: exit code {done.returncode}, expected {expected}: {done.stderr[-500:]}")
    failed = done.returncode in (2, 3) and "search" not in run
    if not found or failed != any("error" in answer for answer in found) and done.returncode != 1:
        raise SystemExit(f"{run}: {len(found)} answers, exit code {done.returncode}: {done.stdout[:300]}{done.stderr[:300]}")
    return found


def spoiled_answers(answer):
    """Each with one thing of another shape."""
    for member in ("format", "version", "command", "input", "verdict", "certificate", "notes"):
        yield {key: inner for key, inner in answer.items() if key != member}
    yield {**answer, "colour": "red"}
    yield {**answer, "version": 2}
    yield {**answer, "verdict": "perhaps"}
    yield {**answer, "notes": "none"}
    yield {**answer, "certificate": "a15.json"}


def check_answers(acutile):
    """The number of answers that the schema accepts, of changed ones that it refuses, and what is judged wrongly."""
    schema = json.loads((ROOT / "docs/answer.schema.json").read_bytes())
    Draft202012Validator.check_schema(schema)
    validator = Draft202012Validator(schema)
    accepted, refused, wrong, commands = 0, 0, [], set()
    for run, expected in RUNS:
        for answer in answers(acutile, run, expected):
            commands.add(answer["command"])
            accepted += 1
            error = next(validator.iter_errors(answer), None)
            if error:
                wrong.append(f"{run}: {'/'.join(map(str, error.path))}: {error.message[:300]}")
            for other in spoiled_answers(answer):
                refused += 1
                if validator.is_valid(other):
                    wrong.append(f"{run}: accepted, though spoiled: {json.dumps(other)[:200]}")
    missing = set(schema["properties"]["command"]["enum"]) - commands
    wrong += [f"no run of {command}" for command in sorted(missing)]
    print(f"answers: {accepted} accepted, {refused} refused, {len(wrong)} wrongly", *wrong, sep="\n")
    return bool(wrong)


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
    is_wrong = check_answers(sys.argv[1])
    return 1 if is_wrong or wrong or accepted < 15 or refused < 80 else 0


if __name__ == "__main__":
    sys.exit(main())
