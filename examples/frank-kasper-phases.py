#!/usr/bin/env python3
"""The digests by which `acutile classify` names the P, M, R and T phases of Frank and Kasper.

    frank-kasper-phases.py [--acutile PROGRAM] [FILE...] > crates/paper/src/survey/phases.txt

For each crystal file, by default those of the four phases in examples/frank-kasper, it prints the name of the phase
and the digest of its minimal symbol. The name is the first letter of the file, in upper case, after `POSCAR_` if it
begins so. So the prototypes of github.com/AIIMProject/MLFeMoTCPs, from which P, M and R come, can be compared with
the files here:

    frank-kasper-phases.py MLFeMoTCPs/PrototypeStructures/POSCAR_[PMR]_proto.vasp

A file whose Delaunay triangulation is not TCP, or has other vertex types than the literature gives, stops the program.
"""
import argparse
import json
import pathlib
import subprocess
import sys

FOLDER = pathlib.Path(__file__).with_name("frank-kasper")

# Vertices of types Z12, Z14, Z15, Z16 in a primitive cell, after D. P. Shoemaker and C. B. Shoemaker,
# Acta Cryst. B 42 (1986) 3-11.
COUNTS = {"P": [24, 20, 8, 4], "M": [28, 8, 8, 8], "R": [27, 12, 6, 8], "T": [49, 6, 6, 20]}


def classified(program, path):
    done = subprocess.run([program, "classify", str(path), "--json"], capture_output=True, text=True)
    lines = [line for line in done.stdout.splitlines() if line.startswith("{")]
    if done.returncode != 0 or not lines:
        sys.exit(f"{path}: {done.stderr.strip() or 'no answer'}")
    return json.loads(lines[0])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--acutile", default="acutile")
    parser.add_argument("files", nargs="*", metavar="FILE", default=[FOLDER / f"{name.lower()}.cif" for name in COUNTS])
    options = parser.parse_args()
    for path in options.files:
        name = pathlib.Path(path).name.removeprefix("POSCAR_")[:1].upper()
        if name not in COUNTS:
            sys.exit(f"{path}: its name begins with none of {', '.join(COUNTS)}")
        answer = classified(options.acutile, path)
        if not answer.get("tcp"):
            sys.exit(f"{path}: not TCP")
        found = [answer["vertex_types"].get(f"Z{n}", 0) for n in (12, 14, 15, 16)]
        expected = COUNTS[name]
        cells = found[0] // expected[0]
        if found != [cells * n for n in expected]:
            sys.exit(f"{path}: found {found} of Z12, Z14, Z15, Z16, expected a multiple of {expected}")
        print(name, answer["symbol"])


main()
