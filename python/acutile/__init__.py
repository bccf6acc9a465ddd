"""Proofs in exact arithmetic that meshes, tilings and crystal structures are valid and acute.

>>> import acutile
>>> result = acutile.certify("a15", require=["acute"])
>>> result.verdict
'proved'
>>> acutile.verify(result.certificate).simplices
46
"""

from __future__ import annotations

from ._commands import (
    certify,
    classify,
    delaunay,
    names,
    optimize,
    quality,
    report,
    table,
    verify,
)
from ._native import Failed, __version__
from ._results import Classification, Defects, Optimized, Quality, Result, Triangulation, Verified

__all__ = [
    "Classification",
    "Defects",
    "Failed",
    "Optimized",
    "Quality",
    "Result",
    "Triangulation",
    "Verified",
    "__version__",
    "certify",
    "classify",
    "delaunay",
    "names",
    "optimize",
    "quality",
    "report",
    "table",
    "verify",
]
