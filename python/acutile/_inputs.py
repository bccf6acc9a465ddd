"""Whatever a user has, turned into a tiling of the compiled part.

Floating-point numbers are taken exactly: 0.1 is the dyadic rational that the double is.
"""

from __future__ import annotations

import json
import os
from fractions import Fraction
from typing import Any

import numpy as np

from ._native import Failed, Tiling
from ._results import VTK_TETRA, Triangulation


def tiling(source: Any, cells: Any = None, **options: Any) -> Tiling:
    """The tiling of any input that :func:`acutile.certify` documents."""
    if isinstance(source, Triangulation):
        return source.tiling
    if cells is not None:
        return of_arrays(source, cells, **options)
    if isinstance(source, (str, os.PathLike)):
        return of_name(os.fspath(source), **options)
    if hasattr(source, "cells_dict") and hasattr(source, "points"):
        return of_mesh_object(source, **options)
    if hasattr(source, "get_scaled_positions"):
        return of_points(
            source.get_positions(), lattice=np.asarray(source.get_cell()), **options
        )
    if hasattr(source, "frac_coords") and hasattr(source, "lattice"):
        return of_points(
            source.frac_coords,
            lattice=source.lattice.matrix,
            coordinates="fractional",
            **options,
        )
    raise Failed(
        f"found {type(source).__name__}, expected points and cells, a name of the catalogue, a file name, "
        "a meshio Mesh, a pyvista UnstructuredGrid, an ASE Atoms or a pymatgen Structure"
    )


def of_name(
    source: str,
    *,
    parameter: Any = None,
    lattice: Any = None,
    tolerance: float | None = None,
    triangulate: bool = False,
) -> Tiling:
    return Tiling.open(
        source,
        None if parameter is None else exact(parameter),
        lattice_text(lattice),
        tolerance,
        triangulate,
    )


def of_mesh_object(
    mesh: Any, *, lattice: Any = None, tolerance: float | None = None
) -> Tiling:
    """A meshio Mesh (cells by name) or a pyvista UnstructuredGrid (cells by VTK's number)."""
    cells = mesh.cells_dict
    tetrahedra = cells.get("tetra", cells.get(VTK_TETRA))
    if tetrahedra is None:
        raise Failed(
            f"the mesh has no tetrahedra, but cells of the kinds {sorted(map(str, cells))}"
        )
    return of_arrays(mesh.points, tetrahedra, lattice=lattice, tolerance=tolerance)


def of_arrays(
    points: Any,
    cells: Any,
    *,
    lattice: Any = None,
    domain: Any = None,
    tolerance: float | None = None,
) -> Tiling:
    """Points and cells. Doubles in space are a mesh; all other numbers make a tiling file."""
    array = np.asarray(points)
    cells = np.asarray(cells)
    if cells.ndim != 2 or cells.shape[1] not in (3, 4):
        raise Failed(f"found cells of the shape {cells.shape}, expected (m, 3) or (m, 4)")
    if not np.issubdtype(cells.dtype, np.integer):
        raise Failed(f"found cells of the type {cells.dtype}, expected integers")
    is_mesh = (
        array.ndim == 2
        and array.shape[1] == 3
        and array.dtype.kind in "fi"
        and array.dtype.itemsize <= 8
        and domain is None
    )
    if is_mesh and (array.dtype.kind == "f" or np.abs(array).max(initial=0) < 2**53):
        return Tiling.of_mesh(
            np.ascontiguousarray(array, dtype=np.float64),
            indices(cells, len(array)),
            lattice_text(lattice),
            tolerance,
        )
    if tolerance is not None:
        raise Failed("a tolerance is for points that are doubles")
    return of_text(points, cells, lattice, domain)


def indices(cells: np.ndarray, count: int) -> np.ndarray:
    """Cells as the compiled part takes them; a wrong index is named with its place."""
    outside = np.argwhere((cells < 0) | (cells >= count))
    if len(outside):
        i, j = outside[0]
        raise Failed(
            f"cells[{i}, {j}] is {cells[i, j]}, expected an index from 0 to {count - 1}"
        )
    return np.ascontiguousarray(cells, dtype=np.uint32)


def of_text(points: Any, cells: np.ndarray, lattice: Any, domain: Any) -> Tiling:
    document = {
        "format": "acutile-tiling",
        "version": 1,
        "dimension": cells.shape[1] - 1,
        "domain": exact_all(domain) if domain is not None else "region",
        "vertices": exact_rows(points),
        "simplices": cells.tolist(),
    }
    if domain is None and lattice is not None:
        document["domain"] = "space"
    if lattice is not None:
        document["lattice"] = {"vectors": exact_rows(lattice)}
        document["coordinates"] = "cartesian"
    return Tiling.of_text(json.dumps(document))


def of_points(
    points: Any,
    *,
    lattice: Any,
    coordinates: str = "cartesian",
    triangulate: bool = False,
) -> Tiling:
    """The periodic Delaunay triangulation of points."""
    rows = exact_rows(points)
    document = {
        "format": "acutile-points",
        "version": 1,
        "dimension": len(rows[0]) if rows else 3,
        "lattice": {"vectors": exact_rows(lattice)},
        "coordinates": coordinates,
        "points": rows,
    }
    return Tiling.of_text(json.dumps(document), triangulate)


def lattice_text(lattice: Any) -> str | None:
    """Lattice vectors as rows, in the form of the option ``--lattice``."""
    if lattice is None or isinstance(lattice, str):
        return lattice
    return ";".join(",".join(row) for row in exact_rows(lattice))


def exact_rows(rows: Any) -> list[list[str]]:
    return [[exact(x) for x in row] for row in rows]


def exact_all(value: Any) -> Any:
    """Numbers anywhere in lists and dictionaries as exact texts; names and indices stay."""
    if isinstance(value, dict):
        return {
            key: inner if key == "faces" else exact_all(inner)
            for key, inner in value.items()
        }
    if isinstance(value, (list, tuple, np.ndarray)):
        return [exact_all(inner) for inner in value]
    return exact(value)


def exact(value: Any) -> str:
    """A number as an exact text: ``"3/7"``, ``"sqrt(5)/2"``."""
    if isinstance(value, str):
        return value
    if isinstance(value, (bool, np.bool_)):
        raise Failed(f"found {value}, expected a number")
    if isinstance(value, (int, np.integer, Fraction)):
        return str(value)
    try:
        return str(Fraction(float(value)))
    except (TypeError, ValueError, OverflowError):
        raise Failed(f"found {value!r}, expected a finite number") from None
