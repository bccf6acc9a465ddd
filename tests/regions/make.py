#!/usr/bin/env python3
"""Meshes that TetGen and Gmsh make, through acutile: `python3 tests/regions/make.py DIRECTORY`.

Needs `tetgen` and `gmsh` (Debian packages of these names) and a release build. Writes each mesh as a
tiling file with the domain `region`, every double as the fraction that it is; then demands that acutile proves
it, that acutile-verify verifies the certificate, and that the numbers of points, tetrahedra and
boundary triangles are those that the mesh generator itself tells. Then it
plants defects and demands that they are found. With a second argument, a number of tetrahedra, the meshes are
about that large; 100 000 otherwise. The files of this folder were made with 300, and nothing else was changed in them.
"""
import itertools
import json
import math
import os
import random
import subprocess
import sys
import time
from fractions import Fraction

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PROGRAMS = os.path.join(ROOT, "target", "release")


def run(*command, **options):
    return subprocess.run(command, capture_output=True, text=True, **options)


# --- meshes: points, tetrahedra, and the number of boundary triangles as the tool counts it ---

def gmsh(directory, name, geometry, size):
    """Meshes a geometry in Gmsh's language; reads MSH 2.2."""
    geo, msh = (os.path.join(directory, name + end) for end in (".geo", ".msh"))
    with open(geo, "w") as file:
        file.write('SetFactory("OpenCASCADE");\n' + geometry + f"\nMesh.MeshSizeMax = {size};\nMesh.MeshSizeMin = {size};\n")
    answer = run("gmsh", "-3", geo, "-format", "msh22", "-o", msh)
    assert answer.returncode == 0, answer.stdout + answer.stderr
    points, tetrahedra, triangles = {}, [], 0
    with open(msh) as file:
        lines = iter(file.read().split("\n"))
    for line in lines:
        if line == "$Nodes":
            for row in itertools.islice(lines, int(next(lines))):
                number, *place = row.split()
                points[int(number)] = [float(x) for x in place]
        if line == "$Elements":
            for row in itertools.islice(lines, int(next(lines))):
                _, kind, tags, *rest = map(int, row.split())
                triangles += kind == 2
                if kind == 4:
                    tetrahedra.append(rest[tags:])
    return points, tetrahedra, triangles


def tetgen(directory, name, points, facets, holes, volume):
    """Meshes the inside of some triangles; reads .node, .ele and .face."""
    poly = os.path.join(directory, name + ".poly")
    with open(poly, "w") as file:
        print(len(points), 3, 0, 0, file=file)
        for k, place in enumerate(points):
            print(k, *map(repr, place), file=file)
        print(len(facets), 0, file=file)
        for facet in facets:
            print(1, file=file)
            print(len(facet), *facet, file=file)
        print(len(holes), file=file)
        for k, place in enumerate(holes):
            print(k, *place, file=file)
        print(0, file=file)
    answer = run("tetgen", f"-pq1.4a{volume:.12f}", poly)
    assert answer.returncode == 0, answer.stdout + answer.stderr

    def rows(end):
        with open(os.path.join(directory, f"{name}.1.{end}")) as file:
            count, *_ = map(int, file.readline().split())
            return [file.readline().split() for _ in range(count)]
    places = {int(row[0]): [float(x) for x in row[1:4]] for row in rows("node")}
    return places, [[int(v) for v in row[1:5]] for row in rows("ele")], len(rows("face"))


# --- shapes -------------------------------------------------------------------

def icosphere(depth):
    """A geodesic sphere of radius one, and its triangles."""
    g = (1 + math.sqrt(5)) / 2
    corners = [p for a in (-1, 1) for b in (-g, g) for p in ((0, a, b), (a, b, 0), (b, 0, a))]
    triangles = [t for t in itertools.combinations(range(12), 3)
                 if all(math.dist(corners[i], corners[j]) < 2.1 for i, j in itertools.combinations(t, 2))]
    for _ in range(depth):
        middle = {}

        def between(i, j):
            key = (min(i, j), max(i, j))
            if key not in middle:
                middle[key] = len(corners)
                corners.append(tuple((x + y) / 2 for x, y in zip(corners[i], corners[j])))
            return middle[key]
        finer = []
        for a, b, c in triangles:
            d, e, f = between(a, b), between(b, c), between(c, a)
            finer += [(a, d, f), (b, e, d), (c, f, e), (d, e, f)]
        triangles = finer
    return [tuple(x / math.hypot(*p) for x in p) for p in corners], triangles


def box(low, high, first=0):
    corners = list(itertools.product(*zip(low, high)))
    sides = [[0, 1, 3, 2], [4, 5, 7, 6], [0, 1, 5, 4], [2, 3, 7, 6], [0, 2, 6, 4], [1, 3, 7, 5]]
    return corners, [[v + first for v in side] for side in sides]


def meshes(directory, tetrahedra):
    """Each generator's answer, about so many tetrahedra of the volume h³ / 8 (Gmsh), or asked for by volume."""
    size = lambda volume: (4 * volume / tetrahedra) ** (1 / 3)
    yield "gmsh-sphere", gmsh(directory, "gmsh-sphere", "Sphere(1) = {0, 0, 0, 1};", size(4.19))
    yield "gmsh-torus", gmsh(directory, "gmsh-torus", "Torus(1) = {0, 0, 0, 1, 0.4};", size(3.16))
    yield "gmsh-box-with-a-cavity", gmsh(directory, "gmsh-box-with-a-cavity", """Box(1) = {0, 0, 0, 2, 1, 1};
Sphere(2) = {0.6, 0.5, 0.5, 0.3};
BooleanDifference(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };""", size(1.89))
    sphere = icosphere(max(2, round(math.log(tetrahedra / 100, 4) * 0.9)))
    yield "tetgen-sphere", tetgen(directory, "tetgen-sphere", *sphere, [], 2.4 * 4.19 / tetrahedra)
    outer, inner = box((0, 0, 0), (2, 1, 1)), box((0.3, 0.25, 0.25), (0.9, 0.7, 0.75), 8)
    yield "tetgen-box-with-a-cavity", tetgen(directory, "tetgen-box-with-a-cavity", outer[0] + inner[0], outer[1] + inner[1],
                                             [(0.5, 0.5, 0.5)], 1.8 * 1.865 / tetrahedra)


# --- acutile ----------------------------------------------------------------------

def write(directory, name, points, tetrahedra, description=""):
    """A tiling file; points that no tetrahedron has are left out."""
    used = sorted({v for corners in tetrahedra for v in corners})
    index = {v: k for k, v in enumerate(used)}
    path = os.path.join(directory, name + ".json")
    with open(path, "w") as file:
        json.dump({"format": "acutile-tiling", "version": 1, "description": description, "dimension": 3,
                   "domain": "region", "vertices": [[str(Fraction(x)) for x in points[v]] for v in used],
                   "simplices": [[index[v] for v in corners] for corners in tetrahedra]}, file, separators=(",", ":"))
    return path, len(used)


def timed(*command):
    """The answer of a program, its seconds, and the MiB that it took at most."""
    start = time.monotonic()
    script = "import resource, subprocess, sys\np = subprocess.run(sys.argv[1:])\n" \
             "print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss // 1024, file=sys.stderr)\nsys.exit(p.returncode)"
    answer = run(sys.executable, "-c", script, *command)
    memory = answer.stderr.strip().split("\n")[-1]
    return answer, f"{time.monotonic() - start:.1f} s, {memory} MiB"


def check(directory, name, points, tetrahedra, triangles):
    told = f"{len(points)} points, {len(tetrahedra)} tetrahedra, {triangles} boundary triangles"
    path, vertices = write(directory, name, points, tetrahedra, f"{name}: {told}")
    certificate = os.path.join(directory, name + ".certificate.json")
    answer, prover = timed(os.path.join(PROGRAMS, "acutile"), "certify", "--reorient", path, "-o", certificate)
    assert answer.returncode == 0 and ": proved: " in answer.stdout, answer.stdout[:3000] + answer.stderr[-3000:]
    answer, kernel = timed(os.path.join(PROGRAMS, "acutile-verify"), "--limit-bytes", str(1 << 30), certificate)
    assert answer.returncode == 0 and ": verified: " in answer.stdout, answer.stdout[:3000]
    for count in (f"{len(tetrahedra)} tetrahedra", f"boundary by {triangles} triangles", f"({vertices} vertices"):
        assert count in answer.stdout, (count, answer.stdout)
    print(f"{name}: {vertices} vertices, {len(tetrahedra)} tetrahedra, {triangles} boundary triangles; "
          f"proved in {prover}, verified in {kernel}", flush=True)


def refute(directory, name, points, tetrahedra, code):
    path, _ = write(directory, name, points, tetrahedra)
    answer, cost = timed(os.path.join(PROGRAMS, "acutile"), "certify", "--reorient", path)
    head = answer.stdout.split("\n")[0]
    assert answer.returncode == 1 and code in head, answer.stdout[:3000] + answer.stderr[-3000:]
    print(f"{os.path.basename(path)}: {head.split(': ', 1)[1]}; in {cost}", flush=True)


def plant(directory, name, points, tetrahedra):
    """The mesh and a small tetrahedron inside of one of its own; two copies of it, a little apart; and a hole
    whose walls are not glued."""
    generator, last = random.Random(1), max(points)
    corners = [points[v] for v in generator.choice(tetrahedra)]
    centre = [sum(x) / 4 for x in zip(*corners)]
    inner = {last + 1 + k: [c + (x - c) / 4 for x, c in zip(corner, centre)] for k, corner in enumerate(corners)}
    refute(directory, name + "-inside", points | inner, tetrahedra + [list(inner)], "covered-twice")
    moved = {v + last + 1: [x + 0.01 for x in place] for v, place in points.items()}
    refute(directory, name + "-twice", points | moved, tetrahedra + [[v + last + 1 for v in t] for t in tetrahedra],
           "boundary-meets")
    half = {v for v, place in points.items() if place[0] > 0.5}
    split = {v + last + 1: points[v] for v in half}
    parted = [[v + last + 1 if v in half else v for v in t] if all(v in half for v in t) else t for t in tetrahedra]
    refute(directory, name + "-not-glued", points | split, parted, "coincident-vertices")


def main():
    directory = sys.argv[1]
    os.makedirs(directory, exist_ok=True)
    for name, (points, tetrahedra, triangles) in meshes(directory, int(sys.argv[2]) if len(sys.argv) > 2 else 100_000):
        check(directory, name, points, tetrahedra, triangles)
        plant(directory, name, points, tetrahedra)


if __name__ == "__main__":
    main()
