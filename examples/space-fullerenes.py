#!/usr/bin/env python3
"""The digests by which `acutile classify` names space fullerenes.

    space-fullerenes.py [--acutile PROGRAM] > crates/paper/src/survey/fullerenes.txt

Reads the cages of Struct01 to Struct84 from the PyPI package genice2 (MIT; after Dutour Sikirić, Delgado-Friedrichs,
Deza 2010), and prints for each that is TCP as published its number, its name (`-` if it has none of its own) and the
digest of its minimal symbol. The names are those of the package's other files for the same structure.
"""
import argparse
import importlib.util
import json
import pathlib
import re
import sys
import tempfile

spec = importlib.util.spec_from_file_location("study", pathlib.Path(__file__).with_name("genice-study.py"))
study = importlib.util.module_from_spec(spec)
spec.loader.exec_module(study)

# The names of crystal structures that differ in spelling from those of the literature.
SPELLING = {"Hcomp": "H", "psigma": "p-sigma", "FK6layers": "6-layer-Laves", "FK9layers": "9-layer-Laves"}


def names(folder):
    """The names of files that only repeat a structure, by its number."""
    found = {}
    for path in folder.glob("*.py"):
        match = re.match(r"from \.Struct(\d\d) import \*", path.read_text())
        if match:
            found[int(match[1])] = SPELLING.get(path.stem, path.stem)
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--acutile", default="acutile")
    program = parser.parse_args().acutile
    named = names(pathlib.Path(study.lattices().__path__[0]))
    with tempfile.TemporaryDirectory() as folder:
        for number in range(1, study.COUNT + 1):
            path = pathlib.Path(folder) / "points.json"
            path.write_text(json.dumps(study.point_set(f"Struct{number:02}")))
            answer, why = study.run([program, "classify", str(path), "--json"], 600)
            if answer and answer.get("tcp"):
                print(number, named.get(number, "-"), answer["symbol"], flush=True)
            else:
                print(f"structure {number} is left out: {why or answer.get('error') or 'not TCP as published'}", file=sys.stderr)


main()
