#!/usr/bin/env python3
"""Which of the 84 space fullerenes of GenIce are TCP, which are acute, and what acutile makes of them.

    genice-study.py [--acutile PROGRAM] [--only 33,38] [--seconds N] [-o STUDY.md]

The cages of Struct01 to Struct84 in the PyPI package genice2 (MIT; after Dutour Sikirić, Delgado-Friedrichs,
Deza 2010) are Frank-Kasper point sets. The program reads them from the installed package, which it installs with
pip where it is missing. Nothing of that package is copied here.

For each structure: the Delaunay triangulation of the cages as published, whether it is TCP, its largest
dihedral angle, and that after `acutile optimize`. Every angle is proved, and is an upper bound. A point set
whose decimals break a tie has no single triangulation, and is said so.
"""
import argparse
import importlib
import json
import pathlib
import subprocess
import sys
import tempfile
from fractions import Fraction

COUNT = 84
# Lengths are published as doubles; only these decimals are kept.
DECIMALS = 9


def lattices():
    """The package, installed if it is missing."""
    try:
        return importlib.import_module("genice2.lattices")
    except ImportError:
        subprocess.run([sys.executable, "-m", "pip", "install", "genice2"], check=True)
        importlib.invalidate_caches()
        return importlib.import_module("genice2.lattices")


def decimal(number):
    return Fraction(f"{float(number):.{DECIMALS}f}")


def point_set(name):
    """The cages of a structure as a point set file of acutile, with exact decimals."""
    lattice = importlib.import_module(f"genice2.lattices.{name}").Lattice()
    rows = [line.split() for line in lattice.cages.splitlines() if line.split()]
    cell = [[decimal(x) for x in row] for row in lattice.cell]
    gram = [[sum(a * b for a, b in zip(u, v)) for v in cell] for u in cell]
    text = lambda rows: [[str(x) for x in row] for row in rows]
    return {
        "format": "acutile-points",
        "version": 1,
        "dimension": 3,
        "name": name,
        "lattice": {"gram": text(gram)},
        "points": text([[Fraction(x) for x in row[1:4]] for row in rows]),
    }


def run(arguments, seconds):
    """The JSON object that acutile prints, or why there is none."""
    try:
        done = subprocess.run(arguments, capture_output=True, text=True, timeout=seconds)
    except subprocess.TimeoutExpired:
        return None, f"not finished in {seconds} s"
    lines = [line for line in done.stdout.splitlines() if line.startswith("{")]
    if not lines:
        return None, (done.stderr.strip().splitlines() or ["no answer"])[-1][:90]
    return json.loads(lines[0]), None


def largest(interval):
    """The upper end of `a to b`, or a single number."""
    return interval.split(" to ")[-1]


def study(name, options, folder):
    path = folder / f"{name}.json"
    points = point_set(name)
    path.write_text(json.dumps(points))
    count = len(points["points"])
    program = options.acutile
    classes, why = run([program, "classify", str(path), "--json"], options.seconds)
    if classes is None or "error" in classes:
        return [name, count, why or classes["error"][:90], "", "", ""]
    tcp = "yes" if classes.get("tcp") else "no"
    found, why = run([program, "optimize", str(path), "--json"], options.seconds)
    if found is None or "before" not in found:
        return [name, count, tcp, why or found["error"][:90], "", ""]
    is_acute = float(largest(found["before"])) < 90
    acute = "yes" if is_acute else "no"
    return [name, count, tcp, largest(found["before"]), acute, largest(found["after"])]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--acutile", default="acutile", help="the program")
    parser.add_argument("--only", default="", help="numbers of structures, like 33,38")
    parser.add_argument("--seconds", type=int, default=600, help="for each run of acutile")
    parser.add_argument("-o", "--output", help="write here and not to standard output")
    options = parser.parse_args()
    lattices()
    numbers = [int(n) for n in options.only.split(",") if n] or range(1, COUNT + 1)
    head = ["structure", "points", "TCP", "largest angle as published", "acute", "optimized"]
    lines = ["| " + " | ".join(head) + " |", "|---|--:|---|--:|---|--:|"]
    with tempfile.TemporaryDirectory() as folder:
        for number in numbers:
            row = study(f"Struct{number:02}", options, pathlib.Path(folder))
            lines.append("| " + " | ".join(map(str, row)) + " |")
            print(lines[-1], file=sys.stderr, flush=True)
    text = "\n".join(lines) + "\n"
    if options.output:
        pathlib.Path(options.output).write_text(text)
    else:
        print(text, end="")


if __name__ == "__main__":
    main()
