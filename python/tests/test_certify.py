"""Verdicts on arrays, objects of other packages, files and names."""

from fractions import Fraction

import numpy as np
import pytest

import acutile

CORNER = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], dtype=float)
ONE = np.array([[0, 1, 2, 3]])


def cube_in_six():
    """The unit cube in Kuhn's six tetrahedra along the diagonal from node 0 to node 7."""
    points = np.array([[i >> 2 & 1, i >> 1 & 1, i & 1] for i in range(8)], dtype=float)
    cells = [[0, 4, 6, 7], [0, 6, 2, 7], [0, 2, 3, 7], [0, 3, 1, 7], [0, 1, 5, 7], [0, 5, 4, 7]]
    return points, np.array(cells)


def test_a_corner_of_a_cube_is_proved_with_a_certificate():
    result = acutile.certify(CORNER, ONE)
    assert result.verdict == "proved" and bool(result) and result.is_confirmed
    verified = acutile.verify(result.certificate)
    assert (verified.vertices, verified.simplices) == (4, 1)
    assert verified.sha256 == result.sha256


def test_its_three_right_angles_are_defects_with_exact_values():
    result = acutile.certify(CORNER, ONE, require=["acute"])
    assert result.verdict == "refuted" and not result
    assert result.counts == {"right-angle": 3}
    array = result.defects.array
    assert list(array["kind"]) == ["right-angle"] * 3
    assert list(array["elements"]) == [(0,)] * 3
    assert list(array["value"]) == [Fraction(0)] * 3
    assert list(array["approximate"]) == [0.0] * 3
    assert array["nodes"][0] == (("0", "1", "2", "3"),)


def test_a_requirement_is_a_text_or_a_list():
    assert acutile.certify(CORNER, ONE, require="nonobtuse").verdict == "proved"


def test_the_prover_alone_makes_no_certificate():
    result = acutile.certify(CORNER, ONE, certificate=False)
    assert result.verdict == "proved" and not result.is_confirmed
    assert result.certificate is None
    with pytest.raises(acutile.Failed, match="there is no certificate"):
        result.require_certificate()


def test_a_negative_tetrahedron_has_its_determinant():
    result = acutile.certify(2 * CORNER, [[0, 1, 3, 2]])
    assert result.counts["negative-orientation"] == 1
    defect = next(d for d in result.defects if d.kind == "negative-orientation")
    assert defect.value == -8


def test_a_cube_repeated_in_three_directions_tiles_space():
    points, cells = cube_in_six()
    result = acutile.certify(points, cells, lattice=np.eye(3), require=["nonobtuse"])
    assert result.verdict == "proved"
    assert acutile.verify(result.certificate).vertices == 1


def test_exact_numbers_and_texts():
    half = Fraction(1, 2)
    triangle = [[0, 0], [1, 0], [half, "sqrt(3)/2"]]
    result = acutile.certify(
        triangle, [[0, 1, 2]], domain={"solid": {"vertices": triangle}}, require=["acute"]
    )
    assert result.verdict == "proved"
    assert any("60" in statement for statement in result.statements)


@pytest.mark.parametrize(
    "points, cells, message",
    [
        (CORNER, [[0, 1, 2, 4]], r"cells\[0, 3\] is 4, expected an index from 0 to 3"),
        (CORNER, [[0, 1, 2, -1]], r"cells\[0, 3\] is -1"),
        (CORNER, [[0.5, 1, 2, 3]], "expected integers"),
        (CORNER, [0, 1, 2, 3], r"found cells of the shape \(4,\)"),
        (np.full((4, 3), np.nan), ONE, r"points\[0, 0\] is NaN, expected a finite number"),
        (object(), None, "found object, expected points and cells"),
        ("no-such-name", None, "neither a name of the catalogue"),
    ],
)
def test_wrong_input_is_named(points, cells, message):
    with pytest.raises(acutile.Failed, match=message):
        acutile.certify(points, cells)


def test_an_unknown_statement_is_named():
    with pytest.raises(acutile.Failed, match="blunt"):
        acutile.certify("a15", require=["blunt"])


def test_the_steps_are_reported():
    steps = []
    acutile.certify("a15", progress=steps.append)
    assert "verification" in steps


def test_the_steps_are_shown_by_tqdm():
    import io

    import tqdm

    with tqdm.tqdm(file=io.StringIO()) as bar:
        acutile.certify("a15", progress=bar)
        assert bar.n >= 2 and bar.desc == "verification"


def test_a_periodic_grid_is_cartesian():
    # A body-centred cubic cell of side 2, by a basis that is not orthogonal.
    lattice = [[1, 1, 1], [1, -1, -1], [-1, 1, -1]]
    grid = acutile.certify(acutile.delaunay([[0, 0, 0]], lattice)).to_pyvista()
    assert abs(grid.volume - 4) < 1e-12
    lengths = np.linalg.norm(grid.points[:, None] - grid.points[None], axis=2)
    assert abs(lengths[lengths > 0.1].min() - np.sqrt(3)) < 1e-12


def test_the_value_of_a_defect_is_exact():
    corner = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, -0.5]]
    defect = acutile.certify(np.array(corner), [[0, 1, 2, 3]]).defects[0]
    assert defect.value == Fraction(-1, 2) and defect.approximate == -0.5


def test_a_meshio_mesh(tmp_path):
    import meshio
    points, cells = cube_in_six()
    mesh = meshio.Mesh(points, [("tetra", cells)])
    result = acutile.certify(mesh)
    assert result.verdict == "proved" and result.simplices == 6
    path = tmp_path / "cube.vtu"
    mesh.write(path)
    assert acutile.certify(path).sha256 == result.sha256


def test_a_pyvista_grid_there_and_back():
    import pyvista
    points, cells = cube_in_six()
    grid = pyvista.UnstructuredGrid({10: cells}, points)
    result = acutile.certify(grid, require=["acute"])
    assert result.verdict == "refuted"
    back = result.to_pyvista()
    assert back.n_cells == 6 and back.n_points == 8
    assert abs(back.volume - 1) < 1e-12
    assert back.cell_data["defects"].sum() == sum(result.counts.values())
    assert set(back.cell_data["defect"]) == {"right-angle"}


def test_a_crystal_of_ase_and_of_pymatgen():
    import ase
    from pymatgen import core
    # Body-centred cubic: each atom has 14 Voronoi neighbours, and the cell 12 tetrahedra.
    cell, places = 2 * np.eye(3), [[0, 0, 0], [1, 1, 1]]
    atoms = ase.Atoms("W2", positions=places, cell=cell, pbc=True)
    structure = core.Structure(cell, ["W", "W"], np.array(places) / 2)
    for crystal in (atoms, structure):
        result = acutile.certify(crystal, require=["delaunay", "nonobtuse"])
        assert result.verdict == "proved" and result.simplices == 12


def test_a_picture_for_notebooks():
    markup = acutile.certify("a15")._repr_html_()
    assert "<svg" in markup and "acute" in markup
