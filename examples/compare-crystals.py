#!/usr/bin/env python3
"""Compares what acutile reads of crystal files with gemmi (CIF) and pymatgen (other formats).

    compare-crystals.py FOLDER [--acutile PROGRAM] [--jobs N] [-- OPTIONS OF acutile]

Each file of the folder, at any depth, is read by `acutile classify --json --special` and by the other
program. The number of atoms, the volume of the cell and the shortest distance must agree. A table of
all files that differ or are refused is printed, and counts at the end. The exit code is 1 if a file
that both programs read differs.

gemmi knows nothing of special positions but a distance: images of one element nearer than 0.003 Å are
one atom there. Needs `pip install gemmi`, and pymatgen for POSCAR, extended XYZ and JSON.
"""
import argparse
import concurrent.futures
import json
import pathlib
import re
import subprocess
import sys

# In ångströms.
SAME_ATOM = 0.003
SAME_LENGTH = 3e-4
# acutile takes lengths that agree within their digits as one length.
SAME_VOLUME = 1e-4
SUFFIXES = {".cif", ".mcif", ".vasp", ".poscar", ".xyz", ".extxyz", ".json"}


def of_gemmi(path):
    import gemmi

    structure = gemmi.read_small_structure(str(path))
    if not structure.sites:
        raise ValueError("no sites")
    group = structure.spacegroup
    operations = structure.symops or (group.operations() if group else ["x,y,z"])
    operations = [gemmi.Op(o) if isinstance(o, str) else o for o in operations]
    # The cell of the structure would count images under its space group as one place.
    cell = gemmi.UnitCell(*structure.cell.parameters)
    elements = {}
    for site in structure.sites:
        own = elements.setdefault(site.element.name, [])
        for operation in operations:
            image = operation.apply_to_xyz(site.fract.tolist())
            place = gemmi.Fractional(*image).wrap_to_unit()
            near = (cell.find_nearest_image(cell.orthogonalize(place), cell.orthogonalize(other)).dist()
                    for other in own)
            if all(distance > SAME_ATOM for distance in near):
                own.append(place)
    atoms = [atom for own in elements.values() for atom in own]
    return len(atoms), cell.volume, shortest(cell, atoms)


def shortest(cell, atoms):
    """The shortest distance, each atom's own translates included."""
    import itertools

    import gemmi

    best = float("inf")
    steps = list(itertools.product((-1, 0, 1), repeat=3))
    for i, first in enumerate(atoms):
        for second in atoms[i:]:
            for step in steps:
                if second is first and step <= (0, 0, 0):
                    continue
                difference = [b - a + s for a, b, s in zip(first.tolist(), second.tolist(), step)]
                best = min(best, cell.orthogonalize(gemmi.Fractional(*difference)).length())
    return best


def of_pymatgen(path):
    from pymatgen.core import Lattice, Structure

    if path.suffix in (".xyz", ".extxyz"):
        lines = path.read_text().splitlines()
        numbers = [float(x) for x in re.search(r'Lattice="([^"]*)"', lines[1]).group(1).split()]
        count = int(lines[0])
        rows = [line.split() for line in lines[2:2 + count]]
        structure = Structure(
            Lattice([numbers[0:3], numbers[3:6], numbers[6:9]]),
            [row[0] for row in rows],
            [[float(x) for x in row[1:4]] for row in rows],
            coords_are_cartesian=True,
        )
    elif path.suffix == ".json":
        structure = Structure.from_dict(json.loads(path.read_text()))
    else:
        from pymatgen.io.vasp import Poscar

        structure = Poscar.from_str(path.read_text()).structure
    distances = structure.distance_matrix
    own = min(sum(x * x for x in structure.lattice.get_cartesian_coords(step)) ** 0.5
              for step in [(1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 0), (1, 0, 1), (0, 1, 1), (1, -1, 0), (1, 0, -1), (0, 1, -1)])
    pairs = [distances[i][j] for i in range(len(structure)) for j in range(i)]
    return len(structure), structure.volume, min(pairs + [own])


def of_acutile(program, path, options):
    command = [program, "classify", "--json", "--special", *options, str(path)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=600)
    report = json.loads(done.stdout)
    if done.returncode != 0:
        raise ValueError(f"exit code {done.returncode}: {report['error'].splitlines()[0]}")
    lengths = [re.search(r"the shortest distance is ([0-9.]+)", note) for note in report["notes"]]
    length = next((float(match.group(1)) for match in lengths if match), None)
    return report["points"], report["volume"], length


def compare(program, path, options):
    results = []
    readers = [lambda: of_acutile(program, path, options),
               lambda: (of_gemmi if path.suffix in (".cif", ".mcif") else of_pymatgen)(path)]
    for reader in readers:
        try:
            results.append(reader())
        except Exception as error:  # The other programs raise many kinds.
            results.append(f"{type(error).__name__}: {error}".splitlines()[0])
    own, other = results
    if isinstance(own, str) or isinstance(other, str):
        both = isinstance(own, str) and isinstance(other, str)
        kind = "both refuse" if both else "acutile refuses" if isinstance(own, str) else "only acutile reads"
        return path, kind, f"{own} | {other}"
    is_same = own[0] == other[0] and abs(own[1] / other[1] - 1) < SAME_VOLUME
    if own[2] is not None:
        is_same = is_same and abs(own[2] - other[2]) < SAME_LENGTH
    return path, "same" if is_same else "different", f"{own} | {other}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--acutile", default="acutile")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("options", nargs="*", help="options of acutile classify, after --")
    arguments = parser.parse_args()
    is_crystal = lambda path: path.suffix.lower() in SUFFIXES or re.search("POSCAR|CONTCAR", path.name)
    paths = sorted(path for path in arguments.folder.rglob("*") if path.is_file() and is_crystal(path))
    counts = {}
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        work = lambda path: compare(arguments.acutile, path, arguments.options)
        for path, kind, words in pool.map(work, paths):
            counts[kind] = counts.get(kind, 0) + 1
            if kind != "same":
                print(f"{kind}: {path}: {words}")
    print(", ".join(f"{kind}: {count}" for kind, count in sorted(counts.items())) or "no crystal files")
    return 1 if counts.get("different") else 0


if __name__ == "__main__":
    sys.exit(main())
