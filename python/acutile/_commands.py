"""The functions of the package."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Iterable
from typing import Any

from . import _inputs, _native
from ._native import Failed
from ._results import (
    Classification,
    Optimized,
    Quality,
    Result,
    Triangulation,
    Verified,
)

Progress = Callable[[str], object] | Any


def _callback(progress: Progress | None) -> Callable[[str], object] | None:
    """A function for the steps: a bar of tqdm counts and shows them."""
    if not (hasattr(progress, "set_description_str") and hasattr(progress, "update")):
        return progress

    def step(text: str) -> None:
        progress.set_description_str(text, refresh=False)
        progress.update()

    return step


def certify(
    source: Any,
    cells: Any = None,
    *,
    lattice: Any = None,
    domain: Any = None,
    require: Iterable[str] = (),
    certificate: bool = True,
    max_defects: int = 10_000,
    progress: Progress | None = None,
    **options: Any,
) -> Result:
    """Proves that something is a face-to-face tiling, with the required statements.

    Parameters
    ----------
    source
        Points of shape (n, D) with D = 2 or 3, if `cells` are given: float64 (taken exactly),
        integers, Fractions, or strings such as ``"sqrt(5)/2"``. Otherwise a name of the catalogue,
        a file name, a meshio ``Mesh``, a pyvista ``UnstructuredGrid``, an ASE ``Atoms`` or a
        pymatgen ``Structure``; of the last two the Delaunay triangulation is certified.
    cells
        Indices of points, counted from 0, of shape (m, D + 1).
    lattice
        Lattice vectors as rows, in the unit of the points. Nodes that differ by a lattice vector
        are one vertex. Without it the mesh is bounded.
    domain
        The domain of a tiling file, such as ``{"solid": {"vertices": …}}``. Without it a bounded
        mesh is the region that it covers.
    require
        Statements that must hold, such as ``"acute"``, ``"dihedral<80"``, ``"delaunay"``: a list,
        or a text with commas.
    certificate
        Whether to write a certificate and let the kernel check it. Without it the prover alone
        decides, which is faster.
    max_defects
        How many defects of each kind are returned. All are counted.
    progress
        A function that is called with the name of each step, or a bar of tqdm, which shows it.
    **options
        ``parameter`` for a construction of the catalogue, ``tolerance`` to merge near nodes,
        ``triangulate`` to cut Delaunay cells with cospherical vertices.

    Returns
    -------
    Result
        With the verdict ``"proved"``, ``"refuted"`` or ``"declined"``.

    Raises
    ------
    Failed
        The input cannot be read. The message is that of the command line.
    KeyboardInterrupt
        After Ctrl-C, at once. The interrupted proof ends in the background.

    Examples
    --------
    >>> import acutile
    >>> corner = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
    >>> acutile.certify(corner, [[0, 1, 2, 3]]).verdict
    'proved'
    >>> acutile.certify(corner, [[0, 1, 2, 3]], require=["acute"]).counts
    {'right-angle': 3}
    """
    if isinstance(require, str):
        require = require.split(",")
    if lattice is not None:
        options["lattice"] = lattice
    if domain is not None:
        options["domain"] = domain
    tiling = _inputs.tiling(source, cells, **options)
    answer, cbor = tiling.certify(list(require), certificate, max_defects, _callback(progress))
    return Result(tiling, json.loads(answer), cbor)


def optimize(
    source: Any,
    cells: Any = None,
    *,
    goal: str = "max-dihedral",
    symmetry: str = "full",
    fixed_lattice: bool = False,
    fixed_boundary: bool = False,
    denominator: int | None = None,
    progress: Progress | None = None,
    **options: Any,
) -> Optimized:
    """Moves the vertices of a tiling, and its lattice, for better angles, and proves the result.

    Parameters
    ----------
    source, cells, **options
        As for :func:`certify`, in space.
    goal
        ``"max-dihedral"``, ``"min-dihedral"``, ``"radius-edge"`` or ``"acute"``.
    symmetry
        The symmetry that stays: ``"full"``, ``"rotations"`` or ``"none"``.
    fixed_lattice, fixed_boundary
        Whether these stay; without it boundary vertices move in the planes of the boundary.
    denominator
        Moved coordinates become multiples of 1 over this.
    progress
        A function that is called with the current value as a text, or a bar of tqdm.

    Returns
    -------
    Optimized
        The best tiling found, with its certificate; ``is_better`` compares it with the start.

    Raises
    ------
    Failed
        The input cannot be read, is not a valid tiling, or is a tiling of the plane.

    Examples
    --------
    >>> import acutile
    >>> acutile.optimize("c14").is_better
    True
    """
    tiling = _inputs.tiling(source, cells, **options)
    best, answer, cbor = tiling.optimize(
        goal, symmetry, fixed_lattice, fixed_boundary, denominator, _callback(progress)
    )
    return Optimized(best, json.loads(answer), cbor)


def verify(
    certificate: bytes | str | os.PathLike | Result, claim: str | None = None
) -> Verified:
    """Checks a certificate with the kernel, from its bytes alone.

    Parameters
    ----------
    certificate
        The bytes in CBOR or canonical JSON, a file name, or a result of :func:`certify`.
    claim
        The text of a claim file. The certificate must prove exactly this claim.

    Returns
    -------
    Verified
        The claim, its words, the counts and the SHA-256 of the certificate.

    Raises
    ------
    Failed
        The certificate is rejected, malformed, declined, or proves another claim. The message has
        the code, the place and the exact value. A place in JSON is a line and a column.
    OSError
        The file cannot be read.
    """
    if isinstance(certificate, Result):
        certificate = certificate.require_certificate()
    if not isinstance(certificate, (bytes, bytearray)):
        with open(certificate, "rb") as file:
            certificate = file.read()
    expected = None if claim is None else claim.encode()
    return Verified(**json.loads(_native.verify(bytes(certificate), expected)))


def delaunay(points: Any, lattice: Any, *, triangulate: bool = False) -> Triangulation:
    """The periodic Delaunay triangulation of points, decided exactly.

    Parameters
    ----------
    points
        Cartesian coordinates of shape (n, D), numbers as for :func:`certify`.
    lattice
        D lattice vectors as rows.
    triangulate
        Cut cells with cospherical vertices, the same way in every translate. Without it such a
        set raises ``Failed``.

    Returns
    -------
    Triangulation
        Vertices of shape (n, D) in basis coordinates, corners of shape (m, D + 1) and lattice
        translations of shape (m, D + 1, D). :func:`certify` proves it.

    Raises
    ------
    Failed
        Two points coincide, the lattice vectors are dependent, or a limit is exceeded.
    """
    return Triangulation(
        _inputs.of_points(points, lattice=lattice, triangulate=triangulate)
    )


def quality(source: Any, cells: Any = None, **options: Any) -> Quality:
    """Dihedral angles of all simplices, in degrees, as enclosures.

    The input is that of :func:`certify`. It need not be a valid tiling.

    Returns
    -------
    Quality
        Two float64 arrays ``lower`` and ``upper`` of shape (m, 6), in the plane (m, 3). Each exact
        angle lies between its two ends. Angles of a flat simplex are NaN.

    Raises
    ------
    Failed
        The input cannot be read.
    """
    tiling = _inputs.tiling(source, cells, **options)
    return Quality(*tiling.angles())


def classify(source: Any, cells: Any = None, **options: Any) -> Classification:
    """The combinatorial type of a tiling. The input is that of :func:`certify`.

    Returns
    -------
    Classification
        Counts of classes, valences and vertex types, TCP, and isomorphic constructions.

    Raises
    ------
    Failed
        The input cannot be read, or the tiling is not proved.
    """
    tiling = _inputs.tiling(source, cells, **options)
    return Classification(**json.loads(tiling.classify()))


def table(names: str | Iterable[str], *, format: str = "text") -> str:
    """The columns of the paper's Table 1 for constructions of the catalogue.

    `format` is ``text``, ``markdown``, ``latex``, ``csv`` or ``json``. Angles are in degrees. An
    unknown name raises ``Failed``.
    """
    return _native.table_of([names] if isinstance(names, str) else list(names), format)


def report(*results: Result, names: Iterable[str] | None = None) -> str:
    """A page in HTML about proved results, as a text.

    It loads nothing from elsewhere, and verifies the certificates in the browser. `names` has a
    title for each result. A result without a certificate raises ``Failed``.
    """
    for result in results:
        if not isinstance(result, Result):
            found = type(result).__name__
            raise Failed(f"found {found}, expected results of certify, such as certify('a15')")
    labels = list(names) if names is not None else [f"result {k}" for k in range(len(results))]
    if len(labels) != len(results):
        raise ValueError(f"found {len(labels)} names for {len(results)} results")
    return _native.report(
        [(label, result.require_certificate()) for label, result in zip(labels, results)]
    )


def names() -> dict[str, str]:
    """The constructions of the catalogue, with their descriptions."""
    return dict(_native.names())
