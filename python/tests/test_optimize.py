"""Better angles, proved."""

import numpy as np
import pytest

import acutile


def test_an_inner_vertex_goes_to_the_centre():
    """Three angles at each inner edge add up to 360 degrees; at the centre all are 120."""
    points = np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1], [0.25, 0.125, 0]], dtype=float)
    cells = [[0, 1, 2, 4], [0, 3, 1, 4], [0, 2, 3, 4], [1, 3, 2, 4]]
    if not acutile.certify(points, cells):
        cells = [[b, a, c, d] for a, b, c, d in cells]
    best = acutile.optimize(points, cells, symmetry="none")
    assert best.is_better and best.is_confirmed
    assert 120 <= float(best.after.split(" to ")[-1]) < 120.001
    assert acutile.verify(best.certificate).sha256 == best.sha256


def test_wrong_words_are_named():
    with pytest.raises(acutile.Failed, match="expected max-dihedral"):
        acutile.optimize("a15", goal="best")
    with pytest.raises(acutile.Failed, match="expected full"):
        acutile.optimize("a15", symmetry="some")
