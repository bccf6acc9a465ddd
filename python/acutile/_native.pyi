"""Types of the compiled part."""

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray

__version__: str

class Failed(ValueError): ...

class Tiling:
    @staticmethod
    def of_mesh(
        points: NDArray[np.float64],
        cells: NDArray[np.uint32],
        lattice: str | None = None,
        tolerance: float | None = None,
    ) -> Tiling: ...
    @staticmethod
    def of_text(text: str, triangulate: bool = False) -> Tiling: ...
    @staticmethod
    def open(
        source: str,
        parameter: str | None = None,
        lattice: str | None = None,
        tolerance: float | None = None,
        triangulate: bool = False,
    ) -> Tiling: ...
    @property
    def dimension(self) -> int: ...
    @property
    def notes(self) -> list[str]: ...
    def vertices(self) -> NDArray[np.float64]: ...
    def gram(self) -> NDArray[np.float64]: ...
    def corners(self) -> tuple[NDArray[np.int64], NDArray[np.int64]]: ...
    def certify(
        self,
        require: Sequence[str],
        certificate: bool = True,
        max_defects: int = 10_000,
        progress: Callable[[str], object] | None = None,
    ) -> tuple[str, bytes | None]: ...
    def optimize(
        self,
        goal: str,
        symmetry: str,
        fixed_lattice: bool = False,
        fixed_boundary: bool = False,
        denominator: int | None = None,
        progress: Callable[[str], object] | None = None,
    ) -> tuple[Tiling, str, bytes]: ...
    def angles(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]: ...
    def classify(self) -> str: ...
    def picture(self, name: str) -> str: ...

def verify(certificate: bytes, claim: bytes | None = None) -> str: ...
def names() -> list[tuple[str, str]]: ...
def table_of(names: Sequence[str], format: str) -> str: ...
def report(certificates: Sequence[tuple[str, bytes]]) -> str: ...
