#!/usr/bin/env python3
"""What other mesh programs say about four faulty meshes, beside what acutile says.

    python3 -m venv env && env/bin/pip install meshio pyvista gmsh
    env/bin/python benches/peers/validity.py target/release/acutile DIRECTORY

writes the meshes into DIRECTORY, asks every program, and prints the answers as they come. The meshes are
a cube of 4 x 4 x 4 small cubes, each cut into six tetrahedra (384 in all), with one fault:

overlap    a 385th tetrahedron with vertices of its own lies inside of another one
flat       a 385th tetrahedron, apart from the others, is so flat that doubles compute the wrong sign of
           its volume
cavity     one tetrahedron inside is missing, which is legitimate for a mesh, and no fault: a control
periodic   opposite sides are declared periodic, and one vertex of one side is off by 1e-9
"""

import itertools
import random
import subprocess
import sys
from fractions import Fraction
from pathlib import Path

import gmsh
import meshio
import numpy
import pyvista

N = 4


def grid():
    """Vertices and positively oriented tetrahedra of the cube [0, N]^3, by Kuhn's subdivision."""
    index = {p: i for i, p in enumerate(itertools.product(range(N + 1), repeat=3))}
    tetrahedra = []
    for corner in itertools.product(range(N), repeat=3):
        for order in itertools.permutations(range(3)):
            path, point = [index[corner]], list(corner)
            for axis in order:
                point[axis] += 1
                path.append(index[tuple(point)])
            odd = sum(order[i] > order[j] for i in range(3) for j in range(i + 1, 3)) % 2
            if odd:
                path[2], path[3] = path[3], path[2]
            tetrahedra.append(path)
    return [[float(x) for x in p] for p in index], tetrahedra, index


def overlap():
    points, tetrahedra, _ = grid()
    inside = tetrahedra[200]
    # Not around its centroid: a program that compares centroids shall not find it by luck.
    middle = [sum(w * points[v][k] for v, w in zip(inside, (1, 2, 2, 3))) / 8 for k in range(3)]
    extra = [[(points[v][k] + 7 * middle[k]) / 8 for k in range(3)] for v in inside]
    tetrahedra.append(list(range(len(points), len(points) + 4)))
    return points + extra, tetrahedra


def flat():
    """A tetrahedron whose volume is negative, and positive as doubles compute it."""
    points, tetrahedra, _ = grid()
    base = len(points)
    # Outside of the cube, in a plane but for roundings, which make the volume as small as they are.
    chance = random.Random(1)
    corners = []
    while not corners or not (volume(corners) < 0 < rounded_volume(corners)):
        a, b, c = [[10 + chance.random() for _ in range(3)] for _ in range(3)]
        weights = [chance.random() for _ in range(3)]
        d = [sum(w * p[k] for w, p in zip(weights, (a, b, c))) / sum(weights) for k in range(3)]
        corners = [a, b, c, d]
    tetrahedra.append([base, base + 1, base + 2, base + 3])
    return points + corners, tetrahedra


def rounded_volume(corners):
    """As VTK computes it: the triple product of the edges from the first corner."""
    a, b, c, d = [numpy.array(p) for p in corners]
    return float(numpy.dot(b - a, numpy.cross(c - a, d - a))) / 6


def volume(corners):
    a, b, c, d = [[Fraction(x) for x in p] for p in corners]
    u, v, w = [[p[k] - a[k] for k in range(3)] for p in (b, c, d)]
    return (
        u[0] * (v[1] * w[2] - v[2] * w[1])
        - u[1] * (v[0] * w[2] - v[2] * w[0])
        + u[2] * (v[0] * w[1] - v[1] * w[0])
    ) / 6


def cavity():
    points, tetrahedra, _ = grid()
    # In the small cube (1, 1, 1), far from the boundary.
    del tetrahedra[6 * (N * N + N + 1)]
    return points, tetrahedra


def periodic():
    points, tetrahedra, index = grid()
    points[index[(0, 2, 2)]][1] += 1e-9
    return points, tetrahedra, index


def write_msh(path, points, tetrahedra, index=None):
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$Nodes", str(len(points))]
    lines += [f"{i + 1} {x!r} {y!r} {z!r}" for i, (x, y, z) in enumerate(points)]
    lines += ["$EndNodes", "$Elements", str(len(tetrahedra))]
    lines += [f"{i + 1} 4 2 1 1 " + " ".join(str(v + 1) for v in t) for i, t in enumerate(tetrahedra)]
    lines += ["$EndElements"]
    if index:
        lines += ["$Periodic", "3"]
        for axis in range(3):
            pairs = []
            for p, i in index.items():
                if p[axis] == N:
                    master = tuple(0 if k == axis else p[k] for k in range(3))
                    pairs.append((i + 1, index[master] + 1))
            affine = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]
            affine[4 * axis + 3] = N
            lines += [f"2 {2 * axis + 2} {2 * axis + 1}", "Affine " + " ".join(map(str, affine)), str(len(pairs))]
            lines += [f"{a} {b}" for a, b in pairs]
        lines += ["$EndPeriodic"]
    path.write_text("\n".join(lines) + "\n")


def ask_pyvista(path):
    mesh = pyvista.from_meshio(meshio.read(path))
    report = mesh.validate_mesh()
    quality = mesh.cell_quality(["volume", "scaled_jacobian"])
    volumes = quality["volume"]
    said = "valid" if report.is_valid else f"invalid: {', '.join(report.invalid_fields)}"
    return f"validate_mesh: {said}; least volume {volumes.min():.3g}"


def ask_gmsh(path):
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    try:
        gmsh.logger.start()
        gmsh.open(str(path))
        _, tags, _ = gmsh.model.mesh.getElements(3)
        volumes = gmsh.model.mesh.getElementQualities(tags[0], "volume")
        messages = [m for m in gmsh.logger.get() if m.startswith(("Warning", "Error"))]
        gmsh.logger.stop()
    finally:
        gmsh.finalize()
    check = subprocess.run(
        [sys.executable, "-c", f"import gmsh; gmsh.initialize(['gmsh', '-check', {str(path)!r}], run=True)"],
        capture_output=True,
        text=True,
    )
    lines = (check.stdout + check.stderr).splitlines()
    complaints = [l.strip() for l in lines if "Warning" in l or "Error" in l or "degenerate" in l]
    return f"opens; {messages or complaints or 'no warning, with -check as well'}; least volume {numpy.min(volumes):.3g}"


def ask_meshio(path):
    command = [str(Path(sys.executable).parent / "meshio"), "info", str(path)]
    done = subprocess.run(command, capture_output=True, text=True)
    lines = [l.strip() for l in (done.stdout + done.stderr).splitlines()]
    complaints = [l for l in lines if "Warning" in l or "inconsistent" in l.lower() or "Error" in l]
    return "; ".join(complaints) or "reads it, says nothing against it"


def ask_acutile(program, path, options):
    done = subprocess.run([program, "certify", *options, str(path)], capture_output=True, text=True)
    return f"exit code {done.returncode}: " + "\n    ".join((done.stdout + done.stderr).splitlines()[:8])


def main():
    program, directory = sys.argv[1], Path(sys.argv[2])
    directory.mkdir(exist_ok=True)
    for make in (overlap, flat, cavity, periodic):
        path = directory / f"{make.__name__}.msh"
        write_msh(path, *make())
        print(f"== {make.__name__}")
        print("  pyvista:", ask_pyvista(path))
        print("  gmsh:   ", ask_gmsh(path))
        print("  meshio: ", ask_meshio(path))
        print("  acutile:", ask_acutile(program, path, []))


if __name__ == "__main__":
    main()
