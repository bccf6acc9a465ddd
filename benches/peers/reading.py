"""meshio: text mesh files read.   reading.py DIRECTORY"""

import sys
import time
from pathlib import Path

import meshio

for name in ("a15.msh", "a15.vtk", "a15.vtu", "a15.mesh", "a15.ele"):
    best, count, points = 1e300, 0, 0
    path = Path(sys.argv[1]) / name
    for _ in range(2):
        start = time.process_time()
        try:
            mesh = meshio.read(path)
        except BaseException as problem:  # meshio ends the program where it cannot read
            print(f"meshio {meshio.__version__} does not read {name}: {problem!r}", file=sys.stderr)
            break
        best = min(best, time.process_time() - start)
        count = sum(len(block.data) for block in mesh.cells if block.type == "tetra")
    if count:
        print(f"@peer\tmeshio\t{name}\t{count}\t{count}\t{count / best:.6g}\ttetrahedra/s", flush=True)
