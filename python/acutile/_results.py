"""The results of the functions of the package."""

from __future__ import annotations

import html
from collections.abc import Iterator
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property
from typing import Any

import numpy as np

from ._native import Failed, Tiling

#: Members of a defect that hold the exact value which is wrong, the first that is there.
VALUES = ("determinant", "product", "square", "sum", "value", "minor")

#: VTK's number of a linear tetrahedron.
VTK_TETRA = 10


class Result:
    """The verdict on a tiling.

    Attributes
    ----------
    verdict : str
        ``"proved"``, ``"refuted"`` or ``"declined"``.
    is_confirmed : bool
        Whether the kernel confirmed a certificate; false for the prover's word alone.
    statements : list of str
        Statements that are proved, in words.
    certificate : bytes or None
        The certificate in CBOR.
    sha256 : str or None
        The certificate's digest.
    counts : dict of str to int
        Defects by kind, all of them.
    defects : Defects
        The defects that were kept, with exact values.
    notes : list of str
        Notes on changes to the input, and on parts that are left out.
    """

    def __init__(self, tiling: Tiling, answer: dict[str, Any], certificate: bytes | None):
        self._tiling = tiling
        self.verdict: str = answer["verdict"]
        self.is_confirmed: bool = answer.get("kernel", False)
        self.statements: list[str] = answer.get("statements", [])
        self.words: str = answer.get("words", answer.get("message", ""))
        self.certificate = certificate
        self.sha256: str | None = answer.get("sha256")
        self.counts: dict[str, int] = answer.get("counts", {})
        self.defects = Defects(answer.get("defects", []))
        self.notes: list[str] = answer["notes"]
        self.vertices: int = answer["vertices"]
        self.simplices: int = answer["simplices"]

    def __bool__(self) -> bool:
        """Whether the verdict is ``"proved"``."""
        return self.verdict == "proved"

    def __str__(self) -> str:
        if self.verdict == "proved":
            alone = "" if self.is_confirmed else " by the prover alone, no certificate"
            return f"proved{alone}: {self.words}"
        counts = ", ".join(f"{count} {kind}" for kind, count in self.counts.items())
        return f"{self.verdict}: {counts or self.words}"

    def __repr__(self) -> str:
        return f"<acutile.Result {self}>"

    def require_certificate(self) -> bytes:
        """The certificate; ``Failed`` where there is none."""
        if self.certificate is None:
            raise Failed(f"there is no certificate: {self}")
        return self.certificate

    def to_pyvista(self) -> Any:
        """The cells in space as an ``UnstructuredGrid``, in Cartesian coordinates.

        A bounded mesh keeps its coordinates, rounded to doubles. The first lattice vector of a
        periodic tiling lies on the x-axis, and the second one in the plane of x and y.
        The cell array ``defect`` has the kind of the first defect of each cell, or nothing, and
        ``defects`` the number of defects. Periodic tilings show one simplex for each orbit.
        """
        import pyvista

        if self._tiling.dimension != 3:
            raise Failed("a plane tiling has no tetrahedra to show")
        vertices, (corners, shifts) = self._tiling.vertices(), self._tiling.corners()
        points = vertices[corners] + shifts.reshape(*corners.shape, 3)
        places, inverse = np.unique(points.reshape(-1, 3), axis=0, return_inverse=True)
        places = places @ _basis(self._tiling.gram())
        grid = pyvista.UnstructuredGrid({VTK_TETRA: inverse.reshape(corners.shape)}, places)
        kinds, counts = self.defects.by_simplex(len(corners))
        grid.cell_data["defect"] = kinds
        grid.cell_data["defects"] = counts
        return grid

    def _repr_html_(self) -> str:
        lines = self.statements or [str(defect) for defect in self.defects[:5]]
        items = "".join(f"<li>{html.escape(line)}</li>" for line in lines)
        try:
            picture = self._tiling.picture("tiling") if self.simplices <= 200 else ""
        except Failed:
            picture = ""
        picture = picture[picture.find("<svg"):] if "<svg" in picture else ""
        return f"<div><b>{html.escape(self.verdict)}</b><ul>{items}</ul>{picture}</div>"


class Optimized(Result):
    """A tiling with better angles, proved.

    Attributes
    ----------
    is_better : bool
        Whether the proved value is better than that of the start.
    before, after : str
        The value of the goal, in degrees or as a ratio: a decimal, or ``"low to high"``.
    """

    def __init__(self, tiling: Tiling, answer: dict[str, Any], certificate: bytes | None):
        super().__init__(tiling, answer, certificate)
        self.is_better: bool = answer["is_better"]
        self.before: str = answer["before"]
        self.after: str = answer["after"]


@dataclass(frozen=True)
class Defect:
    """Something that is wrong.

    Attributes
    ----------
    kind : str
        The code, as the command line prints it.
    message : str
        The sentence of the command line.
    elements : tuple of int
        Indices of the cells, counted from 0.
    nodes : tuple of tuple of str
        The corners of each cell.
    value : Fraction or None
        The exact value that is wrong, where it is rational.
    data : dict
        All members, as ``acutile certify --json`` prints them.
    """

    kind: str
    message: str
    elements: tuple[int, ...]
    nodes: tuple[tuple[str, ...], ...]
    value: Fraction | None
    data: dict[str, Any] = field(repr=False)

    @property
    def approximate(self) -> float:
        """The value as a double, NaN where it is not rational or there is none."""
        return float("nan") if self.value is None else float(self.value)

    def __str__(self) -> str:
        return self.message


class Defects:
    """The defects of a result: a sequence, and :attr:`array` for numpy."""

    def __init__(self, data: list[dict[str, Any]]):
        self._list = [_defect(entry) for entry in data]

    def __len__(self) -> int:
        return len(self._list)

    def __getitem__(self, key: Any) -> Any:
        return self._list[key]

    def __iter__(self) -> Iterator[Defect]:
        return iter(self._list)

    def __repr__(self) -> str:
        return f"<acutile.Defects, {len(self)}>"

    @cached_property
    def array(self) -> np.ndarray:
        """A structured array with `kind`, `elements`, `nodes`, `value` (Fraction) and `approximate`.

        `approximate` is the value as a double, NaN where it is not rational or there is none.
        """
        kinds = [
            ("kind", "U32"),
            ("elements", object),
            ("nodes", object),
            ("value", object),
            ("approximate", float),
        ]
        rows = [
            (d.kind, d.elements, d.nodes, d.value, d.approximate) for d in self._list
        ]
        array = np.empty(len(rows), dtype=kinds)
        for index, row in enumerate(rows):
            array[index] = row
        return array

    def by_simplex(self, count: int) -> tuple[np.ndarray, np.ndarray]:
        """For each of `count` simplices the kind of its first defect, and how many it has."""
        kinds, counts = np.full(count, "", dtype="U32"), np.zeros(count, dtype=np.int64)
        for defect in self._list:
            for element in defect.elements:
                counts[element] += 1
                if not kinds[element]:
                    kinds[element] = defect.kind
        return kinds, counts


def _defect(data: dict[str, Any]) -> Defect:
    places = data.get("places", [])
    value = next((data[key] for key in VALUES if key in data), None)
    return Defect(
        kind=data["code"],
        message=data["message"],
        elements=tuple(place["simplex"] for place in places),
        nodes=tuple(tuple(place["corner_names"]) for place in places),
        value=_fraction(value),
        data=data,
    )


def _fraction(value: Any) -> Fraction | None:
    try:
        return None if value is None else Fraction(value)
    except ValueError:
        return None


def _basis(gram: np.ndarray) -> np.ndarray:
    """Basis vectors as rows: the identity as it is, else a lower triangle."""
    if np.array_equal(gram, np.eye(len(gram))):
        return gram
    try:
        return np.linalg.cholesky(gram)
    except np.linalg.LinAlgError:
        raise Failed("the Gram matrix is not positive definite: there is nothing to show") from None


@dataclass(frozen=True)
class Verified:
    """A certificate that the kernel confirmed."""

    verdict: str
    #: The claim in words.
    words: str
    #: The claim as a claim file.
    claim: str
    vertices: int
    simplices: int
    #: The digest of the certificate in CBOR.
    sha256: str


@dataclass(frozen=True)
class Quality:
    """Enclosures of dihedral angles in degrees, arrays of shape (m, D (D + 1) / 2).

    Column k belongs to the pair k of facets (0,1), (0,2), ..., (D-1,D); a facet has the number of
    the corner opposite to it. Angles of a flat simplex are NaN.
    """

    lower: np.ndarray
    upper: np.ndarray

    @property
    def largest(self) -> np.ndarray:
        """The upper end of the largest angle of each simplex, shape (m,)."""
        return self.upper.max(axis=1)

    @property
    def smallest(self) -> np.ndarray:
        """The lower end of the smallest angle of each simplex, shape (m,)."""
        return self.lower.min(axis=1)


@dataclass(frozen=True)
class Classification:
    """The combinatorial type of a tiling."""

    vertices: int
    simplices: int
    #: Congruence classes of simplices.
    shapes: int
    #: How many edges (vertices in the plane) have each valence.
    valences: dict[str, int]
    #: The digest of the certificate that proves the tiling.
    certificate: str
    #: How many vertices have each star, such as ``Z12``; in space only.
    vertex_types: dict[str, int] | None = None
    tcp: bool | None = None
    #: Names of the catalogue with the same combinatorial type; for tilings of space only.
    isomorphic_to: list[str] | None = None


class Triangulation:
    """A periodic Delaunay triangulation, which :func:`acutile.certify` takes as its input.

    Attributes
    ----------
    tiling : Tiling
        The exact triangulation.
    vertices : array of shape (n, D)
        Basis coordinates, rounded to doubles.
    corners : array of shape (m, D + 1)
        Vertices of each simplex.
    shifts : array of shape (m, D + 1, D)
        The lattice translation of each corner.
    """

    def __init__(self, tiling: Tiling):
        self.tiling = tiling
        self.vertices = tiling.vertices()
        self.corners, shifts = tiling.corners()
        self.shifts = shifts.reshape(*self.corners.shape, tiling.dimension)
