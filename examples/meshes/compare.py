"""Compares a folder of mesh files with meshio: counts, volumes and extremes of every file.

    python3 -m venv venv && venv/bin/pip install meshio==5.3.5 lxml
    venv/bin/python examples/meshes/compare.py FOLDER [--acutile PATH]

For each file that both programs read, acutile converts the mesh to MSH 2.2, and meshio reads the original and the
converted file. The numbers of nodes in use, of tetrahedra and of triangles of a plane mesh, the sum of their signed volumes,
and the least and greatest coordinates have to agree. One line for each file that does not, and a summary. Exit code 1 if
a file differs.
"""

import argparse
import contextlib
import io
import pathlib
import subprocess
import sys
import tempfile
import warnings

import meshio
import numpy as np

warnings.simplefilter("ignore")
EXTENSIONS = {".msh", ".vtk", ".vtu", ".mesh", ".meshb", ".node", ".ele", ".inp", ".bdf", ".nas"}


def read(path):
    """The mesh of a file, without meshio's words about it."""
    if path.suffix == ".vtu" and path.read_bytes().count(b"<Piece") > 1:
        raise ValueError("meshio reads one piece of several")
    silent = io.StringIO()
    with contextlib.redirect_stdout(silent), contextlib.redirect_stderr(silent):
        return meshio.read(path)


def figures(mesh):
    """Counts, volume and extremes of the tetrahedra, or of the triangles where there are none."""
    cells = [c.data[:, :4] for c in mesh.cells if c.type in ("tetra", "tetra10")]
    if not cells:
        cells = [c.data[:, :3] for c in mesh.cells if c.type in ("triangle", "triangle6")]
    if not cells:
        return None
    cells = np.vstack(cells)
    points = np.asarray(mesh.points, dtype=float)
    if points.shape[1] == 2:
        points = np.column_stack([points, np.zeros(len(points))])
    used = points[np.unique(cells)]
    corner = points[cells]
    edges = corner[:, 1:] - corner[:, :1]
    if cells.shape[1] == 4:
        volume = np.linalg.det(edges).sum() / 6
    else:
        volume = np.cross(edges[:, 0], edges[:, 1])[:, 2].sum() / 2
    return len(cells), volume, used.min(axis=0), used.max(axis=0)


def differences(first, second):
    """What differs, in words."""
    found = []
    if first[0] != second[0]:
        found.append(f"cells: meshio {first[0]}, acutile {second[0]}")
        return found
    scale = np.prod(np.maximum(first[3] - first[2], 1e-300)) + abs(first[1])
    # TetGen's order of corners is not settled, so acutile may turn a whole mesh.
    if min(abs(first[1] - second[1]), abs(first[1] + second[1])) > 1e-9 * scale:
        found.append(f"volume: meshio {first[1]}, acutile {second[1]}")
    for name, a, b in [("least", first[2], second[2]), ("greatest", first[3], second[3])]:
        if not np.array_equal(a, b):
            found.append(f"{name} coordinates: meshio {a}, acutile {b}")
    return found


def compare(path, acutile, folder):
    """A word for the outcome, and what is to be said."""
    try:
        original = figures(read(path))
    except BaseException as error:  # meshio raises SystemExit, too.
        original = None
        reason = f"meshio: {type(error).__name__} {error}".splitlines()[0].strip()
    else:
        reason = "meshio finds no tetrahedra or triangles"
    target = folder / "converted.msh"
    target.unlink(missing_ok=True)
    command = [acutile, "convert", str(path), str(target), "--to", "msh2", "--bounded"]
    run = subprocess.run(command, capture_output=True, text=True, timeout=600, check=False)
    if run.returncode != 0:
        word = "neither" if original is None else "only meshio"
        return word, run.stderr.strip().splitlines()[-1:] or [f"exit code {run.returncode}"]
    if original is None:
        return "only acutile", [reason]
    found = differences(original, figures(read(target)))
    return ("differs", found) if found else ("equal", [])


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--acutile", default="acutile")
    arguments = parser.parse_args()
    files = sorted(p for p in arguments.folder.rglob("*") if p.suffix.lower() in EXTENSIONS)
    counts = {}
    with tempfile.TemporaryDirectory() as folder:
        for path in files:
            word, lines = compare(path, arguments.acutile, pathlib.Path(folder))
            counts[word] = counts.get(word, 0) + 1
            if word != "equal":
                print(f"{path}: {word}: {'; '.join(lines)}")
    print(", ".join(f"{count} {word}" for word, count in sorted(counts.items())) or "no mesh files")
    sys.exit(1 if "differs" in counts else 0)


if __name__ == "__main__":
    main()
