"""Times of `acutile.certify` for meshes of about 1,000,000 tetrahedra in arrays of numpy.

`python python/benches/million.py [ROUNDS]` prints the least times of each mesh, in Markdown: elapsed
seconds, seconds of all processors, and their quotient by those that numpy takes for the determinants
of all tetrahedra. Other programs on the machine change the quotient least.
The meshes are a grid of cubes with six tetrahedra each, the same with moved inner nodes (coordinates
of 53 bits), and the A15 tiling repeated in three directions, with a boundary and periodic.
"""

from __future__ import annotations

import itertools
import sys
import time
from collections.abc import Callable, Iterator
from functools import partial

import numpy as np

import acutile

SIDE = 56
A15_CELLS = 28


def grid(n: int) -> tuple[np.ndarray, np.ndarray]:
    """A cube of n x n x n unit cubes, each cut into six tetrahedra around a diagonal."""
    points = np.stack(np.meshgrid(*[np.arange(n + 1.0)] * 3, indexing="ij"), -1).reshape(-1, 3)
    i, j, k = np.meshgrid(*[np.arange(n)] * 3, indexing="ij")
    first = ((i * (n + 1) + j) * (n + 1) + k).reshape(-1, 1)
    steps = np.array([(n + 1) ** 2, n + 1, 1])
    paths = [np.cumsum([0, *steps[list(order)]]) for order in itertools.permutations(range(3))]
    return points, oriented(points, np.stack([first + path for path in paths], 1).reshape(-1, 4))


def oriented(points: np.ndarray, cells: np.ndarray) -> np.ndarray:
    """The cells, with two corners exchanged where the determinant is negative."""
    corners = points[cells]
    negative = np.linalg.det(corners[:, 1:] - corners[:, :1]) < 0
    cells[negative] = cells[negative][:, [0, 1, 3, 2]]
    return cells


def moved(points: np.ndarray) -> np.ndarray:
    """The nodes inside of a grid, each at a random place near its own."""
    inside = ((points > 0) & (points < points.max())).all(axis=1)
    offsets = np.random.default_rng(1).uniform(-0.05, 0.05, points.shape)
    return points + inside[:, None] * offsets


def a15(n: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """n x n x n cells of A15, whose coordinates are multiples of 1/4, and three lattice vectors."""
    cell = acutile.delaunay(A15 / 4, lattice=np.eye(3))
    places = np.rint(4 * (cell.vertices[cell.corners] + cell.shifts)).astype(int)
    offsets = 4 * np.stack(np.meshgrid(*[np.arange(n)] * 3, indexing="ij"), -1).reshape(-1, 1, 1, 3)
    places = (places + offsets).reshape(-1, 3)
    nodes, cells = np.unique(places, axis=0, return_inverse=True)
    return nodes / 4.0, cells.reshape(-1, 4), n * np.eye(3)


A15 = np.array(
    [[0, 0, 0], [2, 2, 2], [1, 0, 2], [3, 0, 2], [2, 1, 0], [2, 3, 0], [0, 2, 1], [0, 2, 3]]
)


def meshes() -> Iterator[tuple[str, np.ndarray, np.ndarray, dict]]:
    points, cells = grid(SIDE)
    yield "grid", points, cells, {}
    yield "grid, inner nodes moved", moved(points), cells, {}
    points, cells, lattice = a15(A15_CELLS)
    yield "A15, bounded", points, cells, {"require": ["acute"]}
    yield "A15, periodic", points, cells, {"require": ["acute"], "lattice": lattice}


def times(task: Callable[[], object]) -> tuple[float, float]:
    """Elapsed seconds, and seconds of all processors."""
    start, used = time.perf_counter(), time.process_time()
    task()
    return time.perf_counter() - start, time.process_time() - used


def proved(points: np.ndarray, cells: np.ndarray, **options) -> None:
    result = acutile.certify(points, cells, **options)
    if not result:
        raise SystemExit(f"expected a proof, found {result}")


def determinants(points: np.ndarray, cells: np.ndarray) -> np.ndarray:
    corners = points[cells]
    return np.linalg.det(corners[:, 1:] - corners[:, :1])


def least(rounds: int, task: Callable[[], object]) -> tuple[float, float]:
    elapsed, used = zip(*(times(task) for _ in range(rounds)))
    return min(elapsed), min(used)


def main() -> None:
    rounds = int(sys.argv[1]) if len(sys.argv) > 1 else 3
    print("| mesh | tetrahedra | certificate | elapsed | processors | x determinants of numpy |")
    print("|---|--:|---|--:|--:|--:|")
    for name, points, cells, options in meshes():
        _, unit = least(rounds, lambda: determinants(points, cells))
        for certificate, words in (False, "no"), (True, "yes"):
            task = partial(proved, points, cells, certificate=certificate, **options)
            elapsed, used = least(rounds, task)
            figures = f"{elapsed:.2f} s | {used:.2f} s | {used / unit:.1f}"
            print(f"| {name} | {len(cells):,} | {words} | {figures} |", flush=True)


if __name__ == "__main__":
    main()
